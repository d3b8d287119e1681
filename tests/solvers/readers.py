"""Reads all files of a folder, with readers of our own, VTK, and meshio and gmsh where they are installed, and
compares everything with the manifest: coordinates bit for bit, the number of every triangle and line, names.

usage: readers.py FOLDER
"""
import collections
import json
import pathlib
import sys
import xml.etree.ElementTree

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

import own_readers

folder = pathlib.Path(sys.argv[1])
manifest = json.loads((folder / 'manifest.json').read_text())
failures = []
read = collections.Counter()


def check(what, found, wanted):
    if found != wanted:
        failures.append(what)
        print(f'{what}: {str(found)[:500]} instead of {str(wanted)[:500]}')


def read_vtk(reader, path):
    reader.SetFileName(str(path))
    if isinstance(reader, vtk.vtkUnstructuredGridReader):
        reader.ReadAllScalarsOn()
    reader.Update()
    return reader.GetOutput()


def vtk_points(grid):
    return vtk_to_numpy(grid.GetPoints().GetData())[:, :2]


def vtk_array(grid, name):
    return vtk_to_numpy(grid.GetCellData().GetArray(name))


def vtk_cells(grid, dimension):
    """Numbers of the cells, and their corners."""
    numbers = [k for k in range(grid.GetNumberOfCells()) if grid.GetCell(k).GetCellDimension() == dimension]
    return numbers, [[grid.GetCell(k).GetPointId(i) for i in range(dimension + 1)] for k in numbers]


# The default file gives the coordinates and triangles that all others are compared with.
GRID = read_vtk(vtk.vtkXMLUnstructuredGridReader(), folder / 'a.vtu')
POINTS = vtk_points(GRID)
REGION = {r['id']: r for r in manifest['regions']}
GROUP = {g['tag']: g['name'] for g in manifest['region_groups'] + manifest['line_groups']}
NAMES = {(2, g.get('label', g['name'])): g['tag'] for g in manifest['region_groups']}
NAMES.update({(1, g.get('label', g['name'])): g['tag'] for g in manifest['line_groups']})


def turned(triangle):
    k = int(np.argmin(triangle))
    return tuple(int(n) for n in (*triangle[k:], *triangle[:k]))


REGION_OF = {turned(t): int(r) for t, r in zip(vtk_cells(GRID, 2)[1], vtk_array(GRID, 'RegionId'))}
LINE_GROUP, SLITS = {}, set()
for line in manifest['lines']:
    groups = line.get('groups', [line.get('group')] * len(line['edges']))
    LINE_GROUP.update({tuple(edge): group for edge, group in zip(line['edges'], groups)})
    if line['kind'] == 'slit':
        SLITS.update(tuple(edge) for edge in line['edges'])


def marker(group):
    """Groups of boundary markers are named by the number."""
    return int(GROUP[group]) if GROUP[group].isdigit() else 0


HAS_MARKERS = any(marker(group) for group in LINE_GROUP.values())
OF_TRIANGLE = {'region': lambda r: r, 'material': lambda r: REGION[r]['material'], 'group': lambda r: REGION[r]['group'],
               'name': lambda r: GROUP[REGION[r]['group']], 'NAME': lambda r: GROUP[REGION[r]['group']].upper()}
OF_LINE = {'group': lambda g: g, 'marker': marker if HAS_MARKERS else lambda g: g}


def check_points(what, points):
    points = np.asarray(points)[:, :2]
    corners, middles = points[:len(POINTS)], points[len(POINTS):]
    if what.endswith('.inp'):  # which holds 20 characters per number, too few for some
        check(f'{what} coordinates', bool(np.allclose(corners, POINTS, rtol=1e-12, atol=0)), True)
    else:
        check(f'{what} coordinates', bool(np.array_equal(corners, POINTS)), True)
    edges = {frozenset(e) for t in REGION_OF for e in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))}
    if 'order2' not in what:
        check(f'{what} further points', len(middles), 0)
        return
    check(f'{what} midpoints', len(middles), len(edges))
    wanted = np.array([(POINTS[a] + POINTS[b]) / 2 for a, b in map(tuple, edges)])
    far = max(np.abs(wanted - middle).max(axis=1).min() for middle in middles)
    check(f'{what} midpoints in the middle', bool(far <= 1e-15 * np.abs(POINTS).max()), True)


def compare(what, points, triangles, tags=None, kind='material', lines=None, line_tags=None, line_kind='group', names=None):
    """`kind` and `line_kind` say what the tags are."""
    read[what.split()[0]] += 1
    check_points(what, points)
    found = {turned(t): tag for t, tag in zip(triangles, tags if tags is not None else [None] * len(triangles))}
    wanted = {t: OF_TRIANGLE[kind](r) if tags is not None else None for t, r in REGION_OF.items()}
    check(f'{what} triangles', found, wanted)
    if lines is not None and len(lines):
        found = {}
        for (a, b), tag in zip(lines, line_tags):
            found[(b, a) if (b, a) in SLITS else (int(a), int(b))] = int(tag)
        check(f'{what} lines', found, {edge: OF_LINE[line_kind](group) for edge, group in LINE_GROUP.items()})
    if names is not None:
        check(f'{what} names', names, NAMES)


def compare_own(name, reader, kind='material', **more):
    mesh = reader(folder / name)
    compare(f'own {name}', mesh.points, mesh.triangles, mesh.tags, kind, mesh.lines if len(mesh.line_tags) else None,
            mesh.line_tags, names=mesh.names if kind != 'NAME' else None, **more)
    if mesh.regions is not None:
        compare(f'own {name}', mesh.points, mesh.triangles, mesh.regions, 'region')
    return mesh


def with_own_readers():
    for name in ('a.xdmf', 'order2.xdmf'):
        compare_own(name, own_readers.xdmf)
    for name in ('a.msh', 'v4.msh', 'order2.msh', 'v4order2.msh'):
        compare_own(name, own_readers.msh, 'group')
    for name in ('a.mesh', 'order2.mesh'):
        compare_own(name, own_readers.medit)
    for name in ('a.ele', 'order2.ele'):
        compare_own(name, own_readers.triangle, line_kind='marker')
    compare_own('a.off', own_readers.off)
    compare_own('a.ply', own_readers.ply)
    mesh = compare_own('a.obj', own_readers.obj, 'name')
    check('own a.obj lines', {frozenset(line) for line in mesh.lines}, {frozenset(edge) for edge in LINE_GROUP})
    mesh = own_readers.inp(folder / 'a.inp')
    compare('own a.inp', mesh.points, mesh.triangles, [OF_INP.get(tag, tag) for tag in mesh.tags], 'NAME')
    nodes = collections.defaultdict(set)
    for edge, group in LINE_GROUP.items():
        nodes[GROUP[group]].update(edge)
    sizes = collections.Counter(len(n) for n in nodes.values())
    found = collections.Counter(len(n) for name, n in mesh.names.items() if any(n == wanted for wanted in nodes.values()))
    check('own a.inp node sets', found, sizes)
    svg = xml.etree.ElementTree.parse(folder / 'a.svg').getroot()
    check('own a.svg', svg.tag, '{http://www.w3.org/2000/svg}svg')
    read['own'] += 1


# Abaqus' names are upper case, without dots.
OF_INP = {g['name'].upper().replace('.', '_'): g['name'].upper() for g in manifest['region_groups']}


def with_vtk():
    for name in ('a.vtu', 'order2.vtu', 'a.vtk', 'lines.vtk', 'order2.vtk'):
        xml_file = name.endswith('.vtu')
        grid = read_vtk(vtk.vtkXMLUnstructuredGridReader() if xml_file else vtk.vtkUnstructuredGridReader(), folder / name)
        faces, triangles = vtk_cells(grid, 2)
        edges, lines = vtk_cells(grid, 1)
        check(f'VTK {name} has lines', bool(edges), name == 'lines.vtk')
        line_tags = vtk_array(grid, 'LineID')[edges] if edges else None
        keys = ('MaterialID',) if name == 'lines.vtk' else ('MaterialID', 'material', 'mat_id')
        for key in keys:
            compare(f'VTK {name}', vtk_points(grid), triangles, vtk_array(grid, key)[faces], 'material', lines, line_tags)
        compare(f'VTK {name}', vtk_points(grid), triangles, vtk_array(grid, 'RegionId')[faces], 'region')
    for name in ('a.vtm', 'order2.vtm'):
        check_blocks(name, read_vtk(vtk.vtkXMLMultiBlockDataReader(), folder / name))
    for name in ('a.ply', 'a.obj'):
        surface = read_vtk(vtk.vtkPLYReader() if name == 'a.ply' else vtk.vtkOBJReader(), folder / name)
        check(f'VTK {name} triangles', surface.GetNumberOfPolys(), len(REGION_OF))
    picture = read_vtk(vtk.vtkPNGReader(), folder / 'a.png')
    check('VTK a.png', picture.GetDimensions()[0], 1200)


def check_blocks(name, blocks):
    """Named blocks of the triangles and lines of each group, with the numbers of vertices in the whole mesh."""
    wanted = {('regions', GROUP[REGION[r]['group']], t): r for t, r in REGION_OF.items()}
    wanted.update({('interfaces', GROUP[group], edge): None for edge, group in LINE_GROUP.items()})
    found = {}
    for k, (kind, dimension) in enumerate((('regions', 2), ('interfaces', 1))):
        check(f'{name} {kind}', blocks.GetMetaData(k).Get(vtk.vtkCompositeDataSet.NAME()), kind)
        part = blocks.GetBlock(k)
        for b in range(part.GetNumberOfBlocks()):
            block = part.GetMetaData(b).Get(vtk.vtkCompositeDataSet.NAME())
            grid = part.GetBlock(b)
            node = vtk_to_numpy(grid.GetPointData().GetArray('GlobalNodeId'))
            inside = node < len(POINTS)
            check(f'{name} {block} coordinates', bool(np.array_equal(vtk_points(grid)[inside], POINTS[node[inside]])), True)
            for c, corners in zip(*vtk_cells(grid, dimension)):
                ids = [int(node[n]) for n in corners]
                key = turned(ids) if dimension == 2 else (ids[1], ids[0]) if (ids[1], ids[0]) in SLITS else tuple(ids)
                found[kind, block, key] = int(vtk_array(grid, 'RegionId')[c]) if dimension == 2 else None
    check(f'{name} blocks', found, wanted)
    read['VTK'] += 1


def with_meshio(meshio):
    def cells(mesh, kind, key):
        at = [k for k, c in enumerate(mesh.cells) if c.type in kind]
        corners = 3 if 'triangle' in kind else 2
        return (np.concatenate([mesh.cells[k].data[:, :corners] for k in at]) if at else [],
                np.concatenate([mesh.cell_data[key][k] for k in at]) if key and at else None)

    triangle, line = ('triangle', 'triangle6'), ('line', 'line3')
    for name, key, kind in (
            ('a.vtu', 'material', 'material'), ('a.vtu', 'RegionId', 'region'), ('a.vtk', 'mat_id', 'material'),
            ('lines.vtk', 'LineID', None), ('a.mesh', 'medit:ref', 'material'), ('a.msh', 'gmsh:physical', 'group'),
            ('v4.msh', 'gmsh:physical', 'group'), ('order2.msh', 'gmsh:physical', 'group'),
            ('v4order2.msh', 'gmsh:physical', 'group'), ('a.off', None, None), ('a.obj', None, None),
            ('a.ply', None, None), ('a.inp', None, None)):
        mesh = meshio.read(folder / name)
        triangles, tags = cells(mesh, triangle, key)
        lines, line_tags = cells(mesh, line, key)
        names = {(int(v[1]), n): int(v[0]) for n, v in mesh.field_data.items()} if name.endswith('.msh') else None
        compare(f'meshio {name}', mesh.points, triangles, tags if kind else None, kind, lines if key else None, line_tags,
                names=names)
        if name == 'a.inp':
            sets = {OF_INP[k]: sum(len(part) for part in v) for k, v in mesh.cell_sets.items()}
            check('meshio a.inp element sets', sets,
                  dict(collections.Counter(OF_TRIANGLE['NAME'](r) for r in REGION_OF.values())))


def with_gmsh(gmsh):
    gmsh.initialize()
    gmsh.option.setNumber('General.Terminal', 0)
    for name in ('a.msh', 'v4.msh', 'order2.msh', 'v4order2.msh', 'a.mesh', 'order2.mesh'):
        gmsh.open(str(folder / name))
        tags, points, _ = gmsh.model.mesh.getNodes()
        index = np.empty(int(max(tags)) + 1, dtype=int)
        index[np.sort(tags)] = np.arange(len(tags))
        points = points.reshape(-1, 3)[np.argsort(tags)]

        def elements(dimension, entity=-1):
            for kind, _, nodes in zip(*gmsh.model.mesh.getElements(dimension, entity)):
                each = gmsh.model.mesh.getElementProperties(kind)[3]
                yield from index[nodes.reshape(-1, each)[:, :dimension + 1]].tolist()

        if name.endswith('.mesh'):  # of which gmsh does not keep references as groups
            compare(f'gmsh {name}', points, list(elements(2)))
            continue
        found, names = {1: ([], []), 2: ([], [])}, {}
        for dimension, group in gmsh.model.getPhysicalGroups():
            names[dimension, gmsh.model.getPhysicalName(dimension, group)] = group
            for entity in gmsh.model.getEntitiesForPhysicalGroup(dimension, group):
                cells = list(elements(dimension, entity))
                found[dimension][0].extend(cells)
                found[dimension][1].extend([group] * len(cells))
        compare(f'gmsh {name}', points, *found[2], 'group', *found[1], names=names)
    gmsh.finalize()


check('manifest triangles', dict(collections.Counter(REGION_OF.values())), {r: REGION[r]['triangles'] for r in REGION})
with_own_readers()
with_vtk()
for module, test in (('meshio', with_meshio), ('gmsh', with_gmsh)):
    try:
        imported = __import__(module)
    except ImportError:
        print(module, 'is not installed')
    else:
        test(imported)
print(f'{len(POINTS)} points, {len(manifest["regions"])} regions, {len(manifest["lines"])} lines; comparisons:', dict(read))
print(f'{len(failures)} differences' if failures else 'everything arrived')
