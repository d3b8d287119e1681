"""Reads all files of a folder with VTK, meshio and gmsh and compares them with the manifest.

usage: readers.py FOLDER
"""
import collections
import json
import pathlib
import sys

import meshio
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

folder = pathlib.Path(sys.argv[1])
manifest = json.loads((folder / 'manifest.json').read_text())
failures = []


def count(numbers):
    return dict(collections.Counter(int(n) for n in np.ravel(numbers)))


def expected(items, key, size):
    counts = collections.Counter()
    for item in items:
        counts[item[key]] += size(item)
    return dict(counts)


TRIANGLES_OF_GROUP = expected(manifest['regions'], 'group', lambda r: r['triangles'])
TRIANGLES_OF_MATERIAL = expected(manifest['regions'], 'material', lambda r: r['triangles'])
TRIANGLES_OF_REGION = expected(manifest['regions'], 'id', lambda r: r['triangles'])
EDGES_OF_GROUP = count([tag for line in manifest['lines']
                        for tag in line.get('groups', [line.get('group')] * len(line['edges']))])
NAMES = {g['name']: g['tag'] for g in manifest['region_groups'] + manifest['line_groups']}


def check(what, found, wanted):
    if found != wanted:
        failures.append(what)
        print(f'{what}: {found} instead of {wanted}')


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


# The default file gives the coordinates that all others are compared with, bit for bit.
grid = read_vtk(vtk.vtkXMLUnstructuredGridReader(), folder / 'a.vtu')
POINTS = vtk_points(grid)


def check_points(what, points):
    found = np.asarray(points)[:len(POINTS), :2]
    # .inp holds 20 characters per number, which is too few for some.
    same = np.allclose(found, POINTS, rtol=1e-12, atol=0) if what.endswith('.inp') else np.array_equal(found, POINTS)
    check(f'{what} coordinates', bool(same), True)


check('a.vtu material', count(vtk_array(grid, 'material')), TRIANGLES_OF_MATERIAL)
check('a.vtu RegionId', count(vtk_array(grid, 'RegionId')), TRIANGLES_OF_REGION)
grid = read_vtk(vtk.vtkXMLUnstructuredGridReader(), folder / 'order2.vtu')
check_points('VTK order2.vtu', vtk_points(grid))
check('order2.vtu RegionId', count(vtk_array(grid, 'RegionId')), TRIANGLES_OF_REGION)

for name in ('a.vtk', 'lines.vtk', 'order2.vtk'):
    grid = read_vtk(vtk.vtkUnstructuredGridReader(), folder / name)
    is_triangle = np.array([grid.GetCell(k).GetCellDimension() == 2 for k in range(grid.GetNumberOfCells())])
    check_points(f'VTK {name}', vtk_points(grid))
    check(f'VTK {name} material', count(vtk_array(grid, 'MaterialID')[is_triangle]), TRIANGLES_OF_MATERIAL)
    check(f'VTK {name} RegionId', count(vtk_array(grid, 'RegionId')[is_triangle]), TRIANGLES_OF_REGION)
    if name == 'lines.vtk':
        check(f'VTK {name} lines', count(vtk_array(grid, 'LineID')[~is_triangle]), EDGES_OF_GROUP)

for name in ('a.vtm', 'order2.vtm'):
    blocks = read_vtk(vtk.vtkXMLMultiBlockDataReader(), folder / name)
    for k, (key, groups, sizes) in enumerate((('regions', 'region_groups', TRIANGLES_OF_GROUP),
                                              ('interfaces', 'line_groups', EDGES_OF_GROUP))):
        check(f'{name} {key}', blocks.GetMetaData(k).Get(vtk.vtkCompositeDataSet.NAME()), key)
        part = blocks.GetBlock(k)
        found = {part.GetMetaData(b).Get(vtk.vtkCompositeDataSet.NAME()): part.GetBlock(b).GetNumberOfCells()
                 for b in range(part.GetNumberOfBlocks())}
        check(f'{name} {key} sizes', found, {g['name']: sizes[g['tag']] for g in manifest[groups]})

for name in ('a.ply', 'a.obj'):
    reader = vtk.vtkPLYReader() if name == 'a.ply' else vtk.vtkOBJReader()
    surface = read_vtk(reader, folder / name)
    check(f'VTK {name} triangles', surface.GetNumberOfPolys(), manifest['counts']['triangles'])


def meshio_counts(mesh, kinds, key):
    return count(np.concatenate([mesh.cell_data[key][k] for k, c in enumerate(mesh.cells) if c.type in kinds]))


TRIANGLE, LINE = ('triangle', 'triangle6'), ('line', 'line3')
for name, key, triangles, lines in (
        ('a.vtu', 'material', TRIANGLES_OF_MATERIAL, None), ('a.vtk', 'mat_id', TRIANGLES_OF_MATERIAL, None),
        ('lines.vtk', 'LineID', None, EDGES_OF_GROUP), ('a.mesh', 'medit:ref', TRIANGLES_OF_MATERIAL, EDGES_OF_GROUP),
        ('a.msh', 'gmsh:physical', TRIANGLES_OF_GROUP, EDGES_OF_GROUP),
        ('v4.msh', 'gmsh:physical', TRIANGLES_OF_GROUP, EDGES_OF_GROUP),
        ('order2.msh', 'gmsh:physical', TRIANGLES_OF_GROUP, EDGES_OF_GROUP),
        ('v4order2.msh', 'gmsh:physical', TRIANGLES_OF_GROUP, EDGES_OF_GROUP)):
    mesh = meshio.read(folder / name)
    check_points(f'meshio {name}', mesh.points)
    if triangles:
        check(f'meshio {name} triangles', meshio_counts(mesh, TRIANGLE, key), triangles)
    if lines:
        check(f'meshio {name} lines', meshio_counts(mesh, LINE, key), lines)
    if name.endswith('.msh'):
        check(f'meshio {name} names', {n: int(v[0]) for n, v in mesh.field_data.items()}, NAMES)
        check(f'meshio {name} dimensions', sorted(int(v[1]) for v in mesh.field_data.values()),
              [1] * len(manifest['line_groups']) + [2] * len(manifest['region_groups']))

for name in ('a.off', 'a.obj', 'a.ply', 'a.inp'):
    mesh = meshio.read(folder / name)
    check_points(f'meshio {name}', mesh.points)
    check(f'meshio {name} triangles', sum(len(c.data) for c in mesh.cells if c.type in TRIANGLE),
          manifest['counts']['triangles'])
    if name == 'a.inp':
        sets = {k: sum(len(part) for part in v) for k, v in mesh.cell_sets.items()}
        wanted = {g['name'].upper().replace('.', '_'): TRIANGLES_OF_GROUP[g['tag']] for g in manifest['region_groups']}
        check(f'meshio {name} element sets', sets, wanted)

try:
    import gmsh
except ImportError:
    print('gmsh is not installed')
else:
    gmsh.initialize()
    gmsh.option.setNumber('General.Terminal', 0)
    for name in ('a.msh', 'v4.msh', 'order2.msh', 'v4order2.msh', 'order2.mesh'):
        gmsh.open(str(folder / name))
        tags, points, _ = gmsh.model.mesh.getNodes()
        order = np.argsort(tags)
        check_points(f'gmsh {name}', points.reshape(-1, 3)[order])
        if name.endswith('.mesh'):
            check('gmsh order2.mesh triangles', len(gmsh.model.mesh.getElementsByType(9)[0]),
                  manifest['counts']['triangles'])
            continue
        groups = gmsh.model.getPhysicalGroups()
        names = {gmsh.model.getPhysicalName(*g): g[1] for g in groups}
        check(f'gmsh {name} names', names, NAMES)
        sizes = {}
        for dimension, tag in groups:
            sizes[tag] = sum(len(gmsh.model.mesh.getElements(dimension, e)[1][0])
                             for e in gmsh.model.getEntitiesForPhysicalGroup(dimension, tag))
        check(f'gmsh {name} sizes', sizes, {**TRIANGLES_OF_GROUP, **EDGES_OF_GROUP})
    gmsh.finalize()

print(f'{len(POINTS)} points, {len(manifest["regions"])} regions, {len(manifest["lines"])} lines:',
      f'{len(failures)} differences' if failures else 'everything arrived')
