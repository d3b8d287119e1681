"""Triangle meshes over many materials with a proven bound on the largest angle.

    import cover
    mesh = cover.mesh(points, segments, regions=[(0.5, 0.5, "Si")])
    mesh.points, mesh.triangles, mesh.region, mesh.report["overall"]["largest_angle"]

Every segment becomes one edge of the mesh. Options are those of `cover mesh` by the same names, as
keywords with '_' for '-': max_angle=110, no_input_sizes=True. options() lists them. Sizes may be a
length or lengths by name: size={"": 1, "gate": 0.1}; size_field may be a function of x and y. Ctrl-C stops a run.
What `cover mesh` would warn of is in mesh.notes. read() takes a mesh from a file.
"""

import json as _json
import math as _math
import os as _os
from collections.abc import Mapping as _Mapping


class Error(Exception):
    """What is wrong with the input or the options.

    code: the number of the error, the same for good; where: coordinates it is about; inputs: elements of the input
    it is about, each by its kind ("point", "segment", "polygon", "hole", "region", "line") and its index or number.
    """

    code = 0
    where = ()
    inputs = ()


class OptionError(Error, ValueError, TypeError):
    """A value that an option does not take, or an option that there is not."""


class OutOfMemory(Error, MemoryError):
    """Less memory than the run needs."""


class Cancelled(Error):
    """The progress callback returned False."""


class RequirementNotMet(Error):
    """What the option `require` asks for is not met.

    mesh: the mesh that was made.
    """

    mesh: "Mesh"


from ._cover import Mesh, __version__, options as _options, read_options as _read_options, write_options as _write_options  # noqa: E402
from ._cover import mesh_files as _mesh_files, mesh_polygons as _mesh_polygons, mesh_pslg as _mesh_pslg, mesh_text as _mesh_text  # noqa: E402
from ._cover import mesh_of_state as _made_of_state, read as _read  # noqa: E402

__all__ = ["Cancelled", "Error", "Mesh", "OptionError", "OutOfMemory", "RequirementNotMet", "mesh", "mesh_file",
           "mesh_polygons", "options", "read", "read_options", "write_options"]


def options():
    """The table of options: name, kind, unit, range, words, default and help of each."""
    return _options()


def read_options():
    """The table of what mesh_file() takes beside options(): how a file is to be read."""
    return _read_options()


def write_options():
    """The table of what Mesh.save() takes: what a file holds where its format leaves a choice."""
    return _write_options()


def mesh(points, segments, regions=(), holes=(), *, lines=None, progress=None, only=None, onto=None, **options):
    """Meshes a planar straight-line graph.

    points: (n, 2) floats; segments: (m, 2) indices into points; regions: (x, y, material) or
    (x, y, material, name), a point in each region; holes: (k, 2) floats. Where there are regions,
    a face without one is void, of which a note tells unless a hole is in it; without any, every
    enclosed face is meshed. lines: of contacts and named interfaces, the indices of their segments
    by name.
    progress(stage, done, total) is called now and then; returning False raises Cancelled.
    only: names of regions or materials, one or several, that alone are meshed, inside onto, a Mesh of this geometry or
    the path of one: all else of it stays, bit for bit.
    """
    return _mesh_pslg(points, segments, list(_or_none(regions)), _or_none(holes), dict(_by_name(lines, "segments")),
                      _again(options, only, onto), progress)


def _again(options, only, onto):
    """Options with those of meshing again."""
    return options if only is None and onto is None else {**options, "only": only, "onto": onto}


def _or_none(places):
    """Those that are given; None as none."""
    return () if places is None else places


def _by_name(lines, what):
    """The dictionary of lines, which may be none."""
    if lines is not None and not hasattr(lines, "items"):
        raise TypeError(f"lines must be a dictionary: {what} by the name of the line")
    if lines and "" in lines:
        raise ValueError("lines: the name of a line is empty")
    return lines or {}


def _coordinate(x, what):
    """The double that x is."""
    if bool(getattr(x, "mask", False)):
        raise ValueError(f"{what}: a value is masked, so there is no number to take")
    if hasattr(x, "__index__") and not _is_double(int(x)):
        raise ValueError(f"{what}: no double is {x}; numbers above 2^53 are rounded, give a float if that is meant")
    try:
        return float(x)
    except (TypeError, ValueError) as error:
        kind = TypeError if isinstance(error, TypeError) else ValueError
        raise kind(f"{what}: {x!r} is no coordinate") from error


def _point(item, what):
    """A point as a pair."""
    if not hasattr(item, "__iter__"):
        raise TypeError(f"{what}: {item!r} is no point (x, y)")
    return [_coordinate(x, what) for x in item]


def _is_double(whole):
    try:
        return float(whole) == whole
    except OverflowError:
        return False


def _plain(path, what):
    """A path as JSON has it: points as pairs, curves as dictionaries."""
    plain = [item if isinstance(item, _Mapping) else _point(item, what) for item in path]
    for point in plain:
        if not isinstance(point, _Mapping) and not all(map(_math.isfinite, point)):
            error = Error(f"the point ({', '.join(f'{x:g}' for x in point)}) of {what} is not finite")
            error.code, error.where = 100, [tuple(point)]
            raise error
    return plain


def _is_curved(path):
    return any(isinstance(item, _Mapping) for item in path) if not hasattr(path, "dtype") else False


def _document(k, polygon):
    """A polygon as JSON has it; the names and numbers of a tuple are those of mesh_polygons()."""
    if not isinstance(polygon, _Mapping):
        polygon = dict(zip(("material", "rings", "region"), polygon))
    return {**polygon, "rings": [_plain(ring, f"polygon {k}") for ring in polygon.get("rings", ())]}


def _check_polygon(k, polygon):
    """A mistake in the shape of a polygon, by its number."""
    if isinstance(polygon, _Mapping):
        return
    if isinstance(polygon, str) or not hasattr(polygon, "__len__") or len(polygon) not in (2, 3):
        raise TypeError(f"polygon {k} is no (material, rings), (material, rings, name) or dictionary")
    material, rings = polygon[:2]
    if hasattr(material, "__len__") and not isinstance(material, str):
        raise TypeError(f"polygon {k}: its material, the first of the tuple, must be a name or a number")
    if isinstance(rings, (str, _Mapping)) or not hasattr(rings, "__len__"):
        raise TypeError(f"polygon {k}: its rings must be a list of rings, each a list of points")
    for ring in rings:
        if isinstance(ring, (str, _Mapping)) or not hasattr(ring, "__len__"):
            raise TypeError(f"polygon {k}: a ring must be a list of points; rings are a list of such lists")


def mesh_polygons(polygons, *, lines=None, holes=(), points=(), chord_error=None, unit=None, progress=None, only=None,
                  onto=None, **options):
    """Meshes painted polygons, each (material, rings), (material, rings, name), or a dictionary with the keys
    material, rings, region, priority, size, as in JSON.

    A ring is (n, 2) floats, closed implicitly; inside is even-odd. Among its points may stand curves, as
    {"circle": {"centre": (0, 0), "radius": 1}} or {"arc": {"centre": (0, 0), "radius": 1, "from": 0, "to": 90}},
    each with "chords" or "chord_error", unless chord_error says it for all. Where polygons overlap the higher
    priority wins, then the later one, or as the option overlap says.
    lines: contacts, paths by name; a name may have a list of paths. holes: (k, 2) floats, a point in each void.
    points: (k, 2) floats, places beside all polygons' corners where the mesh has a vertex, as wells.
    only, onto: as mesh() has them.
    """
    options = _again(options, only, onto)
    if isinstance(polygons, (str, _Mapping)) or not hasattr(polygons, "__iter__"):
        raise TypeError("polygons must be a list of (material, rings), (material, rings, name) or dictionaries")
    polygons, holes, points = list(polygons), _or_none(holes), _or_none(points)
    for k, polygon in enumerate(polygons):
        _check_polygon(k, polygon)
    simple = not lines and not len(holes) and not len(points) and unit is None and all(
        not isinstance(p, _Mapping) and not any(_is_curved(ring) for ring in p[1]) for p in polygons)
    if simple:
        return _mesh_polygons(polygons, options, progress)
    document = {"polygons": [_document(k, p) for k, p in enumerate(polygons)], "lines": [], "holes": _plain(holes, "holes")}
    for name, paths in _by_name(lines, "paths").items():
        # One path begins with a point or a curve, a list of them with a path.
        if not hasattr(paths, "__len__"):
            raise TypeError(f"lines: '{name}' must be a list of points, or of such lists")
        if not len(paths):
            raise ValueError(f"lines: '{name}' has no points")
        first = paths[0]
        if not hasattr(first, "__len__"):
            raise TypeError(f"lines: '{name}' must be a list of points, or of such lists, and begins with {first!r}")
        one = isinstance(first, _Mapping) or (len(first) == 2 and not any(isinstance(x, dict) or hasattr(x, "__len__") for x in first))
        for path in [paths] if one else paths:
            document["lines"].append({"name": str(name), "points": _plain(path, f"the line '{name}'")})
    if len(points):
        document["points"] = _plain(points, "points")
    if chord_error is not None:
        document["chord_error"] = float(chord_error)
    if unit is not None:
        document["unit"] = unit
    try:
        text = _json.dumps(document, default=_number, allow_nan=False)
    except ValueError as error:
        wrong = [f"polygon {k}" for k, p in enumerate(document["polygons"]) if not _is_finite(p)]
        wrong += [f"the line '{line['name']}'" for line in document["lines"] if not _is_finite(line)]
        what = f"{wrong[0]}: a curve, a size or a priority" if wrong else "chord_error"
        raise ValueError(f"{what} is not a finite number") from error
    return _mesh_text(text, ".json", "polygons", options, progress)


def _is_finite(part):
    try:
        return bool(_json.dumps(part, default=_number, allow_nan=False))
    except ValueError:
        return False


def _number(value):
    """numpy's numbers and arrays, and mappings that are no dictionaries, for JSON."""
    if isinstance(value, _Mapping):
        return dict(value)
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"{value!r} is no number, text, list or dictionary")


def mesh_file(path, *, progress=None, only=None, onto=None, **options):
    """Meshes a geometry file of any format that `cover mesh` reads, or several of them, a list, as one geometry: later
    polygons are painted over earlier ones.

    Options are those of meshing and those of reading, which read_options() lists: layer_map="layers.map",
    window=(0, 0, 2, 1), scale=1e-3. only, onto: as mesh() has them.
    """
    paths = path if isinstance(path, (list, tuple)) else [path]
    if not paths:
        raise TypeError("mesh_file: no file")
    return _mesh_files([_os.fsencode(p) for p in paths], _again(options, only, onto), progress)


def read(path):
    """A mesh that cover wrote, as far as the file and the manifest (.json) beside it tell: .vtu, .pvtu, .vtm, .vtkhdf,
    .vtk, .msh, .xdmf, .mesh, .inp, .ele.

    What they do not tell is said in its notes. Its report has no regions; names and materials are in Mesh.regions
    and Mesh.materials. It has no input, so violations() has nothing to compare it with.
    """
    return _read(_os.fsencode(path))


def _mesh_of_state(state):
    """For pickle, which finds functions by their names in a module of Python alone."""
    return _made_of_state(state)


def _no_constructor(cls, *_, **__):
    raise TypeError("a Mesh is made by mesh(), mesh_polygons() or mesh_file()")


def _notes(self):
    """What `cover mesh` would warn of, of the whole and of its regions: sentences with coordinates and ids."""
    report = self.report
    of_run = [note["message"] for of in [report, *report.get("regions", ())] for note in of.get("notes", ())]
    return of_run + self._remarks


def _to_vtk(self):
    """The triangles as a vtkUnstructuredGrid with the cell arrays RegionId and material, attributes (of texts their
    numbers, from 1 on), fields at the points, and the names of regions and materials as field data; needs VTK's own
    modules, of whichever VTK is loaded."""
    import numpy as np
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
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

    def add(data, name, values):
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        data.AddArray(array)

    def add_texts(name, texts):
        array = vtkStringArray()
        array.SetName(name)
        for text in texts:
            array.InsertNextValue(text)
        grid.GetFieldData().AddArray(array)

    add(grid.GetCellData(), "RegionId", self.region)
    add(grid.GetCellData(), "material", self.material)
    for name, values in self.attributes.items():
        if isinstance(values, list):
            words = list(dict.fromkeys(value for value in values if value is not None))
            values = np.array([0 if value is None else 1 + words.index(value) for value in values], np.int32)
            add_texts(name + "_names", words)
        add(grid.GetCellData(), name, values[self.region - 1])
    for name, values in self.fields.items():
        add(grid.GetPointData(), name, values)
    regions = self.regions
    add_texts("RegionName", [region["name"] for region in regions])
    add_texts("MaterialName", [region["material_name"] for region in regions])
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


def _box_method(self):
    """What a solver by the box method (finite volumes on Voronoi boxes) needs, as arrays in a dict.

    "edges" (two indices of points each, the smaller first), "edge_regions" and "couplings": the length of the box's
    side over that of the edge, (cot + cot) / 2 of the angles opposite to it in that region, without a unit; an edge
    between two regions has a row for each. "box_points", "box_regions" and "box_areas": of the part of each point's
    box in each region, in the square of the mesh's unit. Both are signed: the areas of a region's boxes add up to its
    area, whatever angles there are. Sorted by region, then by point. Cost: O(n log n) for n triangles."""
    import numpy as np

    points, triangles = self.points, self.triangles.astype(np.int64)
    ends, halves, parts = [], [], []
    for k in range(3):
        apex, a, b = (triangles[:, (k + i) % 3] for i in range(3))
        u, v = points[a] - points[apex], points[b] - points[apex]
        half = (u * v).sum(1) / (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2
        ends.append(np.sort(np.column_stack([a, b]), axis=1))
        halves.append(half)
        parts.append(((points[b] - points[a]) ** 2).sum(1) * half / 4)
    ends, halves, parts = np.concatenate(ends), np.concatenate(halves), np.concatenate(parts)
    region = np.tile(self.region, 3)

    def added(rows, values):
        rows, which = np.unique(rows, axis=0, return_inverse=True)
        return rows, np.bincount(which.ravel(), values, len(rows))

    edges, couplings = added(np.column_stack([region, ends]), halves)
    boxes, areas = added(np.column_stack([np.tile(region, 2), ends.T.ravel()]), np.tile(parts, 2))
    return {"edges": edges[:, 1:], "edge_regions": edges[:, 0], "couplings": couplings,
            "box_points": boxes[:, 1], "box_regions": boxes[:, 0], "box_areas": areas}


Mesh.to_vtk, Mesh.to_meshio, Mesh.box_method, Mesh.notes = _to_vtk, _to_meshio, _box_method, property(_notes)
# Else there were meshes without anything in them.
Mesh.__new__ = staticmethod(_no_constructor)
