"""Triangle meshes over many materials with a proven bound on the largest angle.

    import cover
    mesh = cover.mesh(points, segments, regions=[(0.5, 0.5, "Si")])
    mesh.points, mesh.triangles, mesh.region, mesh.report["overall"]["largest_angle"]

Every segment becomes one edge of the mesh. Options are those of `cover mesh` by the same names, as
keywords with '_' for '-': max_angle=110, no_input_sizes=True. options() lists them. Sizes may be a
length or lengths by name: size={"": 1, "gate": 0.1}. Ctrl-C stops a run.
"""

import os as _os


class Error(Exception):
    """What is wrong with the input or the options.

    code: the number of the error, the same for good; where: coordinates it is about.
    """

    code = 0
    where = ()


class OptionError(Error, ValueError):
    """A value that an option does not take."""


class OutOfMemory(Error, MemoryError):
    """Less memory than the run needs."""


class Cancelled(Error):
    """The progress callback returned False."""


from ._cover import Mesh, __version__, options as _options  # noqa: E402
from ._cover import mesh_file as _mesh_file, mesh_polygons as _mesh_polygons, mesh_pslg as _mesh_pslg  # noqa: E402

__all__ = ["Cancelled", "Error", "Mesh", "OptionError", "OutOfMemory", "mesh", "mesh_file", "mesh_polygons", "options"]


def options():
    """The table of options: name, kind, unit, range, words, default and help of each."""
    return _options()


def mesh(points, segments, regions=(), holes=(), *, lines=None, progress=None, **options):
    """Meshes a planar straight-line graph.

    points: (n, 2) floats; segments: (m, 2) indices into points; regions: (x, y, material) or
    (x, y, material, name), a point in each region; holes: (k, 2) floats. Where there are regions,
    a face without one is void; without any, every enclosed face is meshed. lines: of contacts and
    named interfaces, the indices of their segments by name.
    progress(stage, done, total) is called now and then; returning False raises Cancelled.
    """
    return _mesh_pslg(points, segments, list(regions), holes, dict(lines or {}), options, progress)


def mesh_polygons(polygons, *, progress=None, **options):
    """Meshes painted polygons, each (material, rings) or (material, rings, name).

    A ring is (n, 2) floats, closed implicitly; inside is even-odd. Where polygons overlap the later
    one wins, or as the option overlap says.
    """
    return _mesh_polygons(list(polygons), options, progress)


def mesh_file(path, *, progress=None, **options):
    """Meshes a geometry file: .poly, .json, .geojson, .msh, .vtu, .vtp or .vtk."""
    return _mesh_file(_os.fspath(path), options, progress)


def _to_vtk(self):
    """The triangles as a vtkUnstructuredGrid with the cell arrays RegionId and material; needs VTK's own modules."""
    import numpy as np
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import VTK_TRIANGLE, vtkCellArray, vtkUnstructuredGrid

    points = vtkPoints()
    places = self.points
    points.SetData(numpy_to_vtk(np.column_stack([places, np.zeros(len(places))]), deep=True))
    cells = vtkCellArray()
    triangles = self.triangles
    cells.SetData(3, numpy_to_vtkIdTypeArray(triangles.ravel().astype(np.int64), deep=True))
    grid = vtkUnstructuredGrid()
    grid.SetPoints(points)
    grid.SetCells(VTK_TRIANGLE, cells)
    for name, values in ("RegionId", self.region), ("material", self.material):
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        grid.GetCellData().AddArray(array)
    return grid


def _to_meshio(self):
    """A meshio.Mesh: triangles with RegionId and material, lines with their number in LineId, of which
    field_data has the names; needs meshio."""
    import meshio
    import numpy as np

    lines = [(name, piece["edges"]) for name, pieces in self.lines.items() for piece in pieces]
    edges = [edges for _, edges in lines if len(edges)]
    names = {name: k + 1 for k, name in enumerate(self.lines)}
    numbers = [np.full(len(edges), names[name]) for name, edges in lines if len(edges)]
    cells = [("triangle", self.triangles)]
    data = {"RegionId": [self.region], "material": [self.material], "LineId": [np.zeros(len(self.triangles), int)]}
    if edges:
        cells.append(("line", np.concatenate(edges)))
        none = np.zeros(sum(map(len, edges)), int)
        for name, values in ("RegionId", none), ("material", none), ("LineId", np.concatenate(numbers)):
            data[name].append(values)
    field_data = {name: np.array([number, 1]) for name, number in names.items()}
    return meshio.Mesh(self.points, cells, cell_data=data, field_data=field_data)


Mesh.to_vtk, Mesh.to_meshio = _to_vtk, _to_meshio
