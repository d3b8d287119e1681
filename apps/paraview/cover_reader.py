"""ParaView reads cover's inputs and shows them meshed: Tools > Manage Plugins > Load New, then open a .poly or .json
(or any other format that cover reads). Needs the Python module `cover` where ParaView's Python finds it; it loads no VTK
of its own."""
import os
import shlex

from paraview.util.vtkAlgorithm import VTKPythonAlgorithmBase, smdomain, smhint, smproperty, smproxy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid


@smproxy.reader(name='CoverReader', label='Cover Reader', file_description='Geometry, meshed by cover',
                extensions='poly json geojson gds dxf gpkg shp fgb tif str cmd')
class CoverReader(VTKPythonAlgorithmBase):
    """The triangles of a geometry file, with regions, materials and what the file has beside them as arrays; names of
    regions and materials are field data."""

    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType='vtkUnstructuredGrid')
        self._path = None
        self._options = ''
        self._mesh = None

    @smproperty.stringvector(name='FileName')
    @smdomain.filelist()
    @smhint.filechooser(extensions='poly json geojson gds dxf gpkg shp fgb tif str cmd',
                        file_description='Geometry, meshed by cover')
    def SetFileName(self, path):
        if path != self._path:
            self._path, self._mesh = path, None
            self.Modified()

    @smproperty.stringvector(name='Options', default_values='')
    def SetOptions(self, text):
        """Options as on the command line of `cover mesh`: --size 0.1 --max-angle 95."""
        if text != self._options:
            self._options, self._mesh = text, None
            self.Modified()

    def RequestData(self, request, inputs, outputs):
        import cover

        if not self._path or self._path == 'None':
            return 1
        if self._mesh is None:
            self._mesh = cover.mesh_file(os.fspath(self._path), **keywords(self._options))
        vtkUnstructuredGrid.GetData(outputs, 0).ShallowCopy(self._mesh.to_vtk())
        return 1


def keywords(text):
    """What Python calls the options of a command line."""
    options = {}
    words = shlex.split(text or '')
    while words:
        word = words.pop(0)
        if not word.startswith('--'):
            raise ValueError(f"'{word}' is no option; options begin with --")
        name, _, value = word[2:].partition('=')
        if not value:
            value = words.pop(0) if words and not words[0].startswith('--') else True
        name = name.replace('-', '_')
        if name in options:
            before = options[name]
            value = [*(before if isinstance(before, list) else [before]), value]
        options[name] = value
    return options
