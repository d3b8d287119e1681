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


class Cancelled(Error):
    """The progress callback returned False."""


from ._cover import Mesh, options as _options  # noqa: E402
from ._cover import mesh_file as _mesh_file, mesh_polygons as _mesh_polygons, mesh_pslg as _mesh_pslg  # noqa: E402

__all__ = ["Cancelled", "Error", "Mesh", "OptionError", "mesh", "mesh_file", "mesh_polygons", "options"]


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
