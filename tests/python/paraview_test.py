"""The plugin of ParaView without ParaView: what it reads, with stand-ins for ParaView's decorators."""
import importlib.util
import pathlib
import sys
import tempfile
import types
import unittest

PLUGIN = pathlib.Path(__file__).resolve().parents[2] / 'apps/paraview/cover_reader.py'
SQUARE = '4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n'


class Grid:
    """Stands for vtkUnstructuredGrid where VTK is not there."""
    def ShallowCopy(self, other):
        self.copied = other

    @staticmethod
    def GetData(outputs, port):
        return outputs[port]


class Algorithm:
    def __init__(self, **ports):
        self.ports, self.modified = ports, 0

    def Modified(self):
        self.modified += 1


def stand_in(*args, **kwargs):
    return lambda thing: thing


def plugin():
    decorators = types.SimpleNamespace(reader=stand_in, stringvector=stand_in, filelist=stand_in, filechooser=stand_in)
    modules = {'paraview': {}, 'paraview.util': {}, 'vtkmodules': {}, 'vtkmodules.vtkCommonDataModel': {'vtkUnstructuredGrid': Grid},
               'paraview.util.vtkAlgorithm': {'VTKPythonAlgorithmBase': Algorithm, 'smproxy': decorators, 'smproperty': decorators,
                                              'smdomain': decorators, 'smhint': decorators}}
    for name, members in modules.items():
        sys.modules[name] = types.ModuleType(name)
        vars(sys.modules[name]).update(members)
    spec = importlib.util.spec_from_file_location('cover_reader', PLUGIN)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Reader(unittest.TestCase):
    def test_options(self):
        keywords = plugin().keywords
        self.assertEqual(keywords(''), {})
        self.assertEqual(keywords('--size 0.1 --max-angle=95 --strict'), {'size': '0.1', 'max_angle': '95', 'strict': True})
        self.assertEqual(keywords("--keep-field 'land use' --keep-field fid"), {'keep_field': ['land use', 'fid']})
        with self.assertRaises(ValueError):
            keywords('0.1')

    def test_reads_and_reads_again(self):
        import cover
        reader = plugin().CoverReader()
        self.assertEqual(reader.ports, {'nInputPorts': 0, 'nOutputPorts': 1, 'outputType': 'vtkUnstructuredGrid'})
        cover.Mesh.to_vtk, kept = (lambda mesh: mesh), cover.Mesh.to_vtk
        self.addCleanup(lambda: setattr(cover.Mesh, 'to_vtk', kept))
        grid = Grid()
        self.assertEqual(reader.RequestData(None, None, [grid]), 1)
        self.assertFalse(hasattr(grid, 'copied'))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, 'a.poly')
            path.write_text(SQUARE)
            reader.SetFileName(str(path))
            reader.RequestData(None, None, [grid])
            coarse = grid.copied
            reader.RequestData(None, None, [grid])
            self.assertIs(grid.copied, coarse)
            reader.SetOptions('--split-interfaces --size 0.1')
            reader.RequestData(None, None, [grid])
            self.assertGreater(len(grid.copied.triangles), len(coarse.triangles))
            self.assertEqual(reader.modified, 2)
            reader.SetOptions('--size -1')
            with self.assertRaises(cover.OptionError):
                reader.RequestData(None, None, [grid])


if __name__ == '__main__':
    unittest.main()
