"""Readers of our own for the text formats, each as short as the format allows; nothing of them is shared with cover.

Each takes a path and returns a Mesh. Numbers of nodes count from 0; of second-order cells the corners are taken.
"""
import dataclasses
import pathlib
import xml.etree.ElementTree

import numpy as np


@dataclasses.dataclass
class Mesh:
    points: np.ndarray  # (n, 2)
    triangles: np.ndarray  # (m, 3)
    tags: list = None  # of triangles; by the format, a material or a group
    regions: list = None  # of triangles
    lines: list = ()  # pairs
    line_tags: list = ()
    names: dict = None  # (dimension, name) -> tag


def words(path):
    return iter(pathlib.Path(path).read_text().split())


def take(stream, n, kind=int):
    return [kind(next(stream)) for _ in range(n)]


def xdmf(path):
    def numbers(parent, kind):
        return np.array(parent.find('DataItem').text.split(), dtype=kind)

    def arrays(grid):
        kind = {'Int': np.int64, 'Float': float}
        return {a.get('Name'): list(numbers(a, kind[a.find('DataItem').get('NumberType')])) for a in grid.iter('Attribute')}

    def cells(grid, corners):
        topology = grid.find('Topology')
        return numbers(topology, np.int64).reshape(int(topology.get('NumberOfElements')), -1)[:, :corners]

    root = xml.etree.ElementTree.parse(path).getroot()
    grids = {grid.get('Name'): grid for grid in root.iter('Grid')}
    faces = arrays(grids['mesh'])
    names = {(dimension, item.get('Name')): int(item.get('Value'))
             for dimension, grid in ((2, grids['mesh']), (1, grids['lines'])) for item in grid.iter('Information')}
    return Mesh(numbers(grids['mesh'].find('Geometry'), float).reshape(-1, 2), cells(grids['mesh'], 3),
                faces['MaterialID'], faces['RegionId'], cells(grids['lines'], 2).tolist(),
                arrays(grids['lines'])['LineID'], names)


def msh(path):
    lines = pathlib.Path(path).read_text().splitlines()
    section = {}
    for k, line in enumerate(lines):
        if line.startswith('$') and not line.startswith('$End'):
            section[line[1:]] = lines[k + 1:lines.index('$End' + line[1:], k)]
    names = {}
    for line in section['PhysicalNames'][1:]:
        dimension, tag, name = line.split(maxsplit=2)
        names[int(dimension), name.strip('"')] = int(tag)
    corners = {1: 2, 8: 2, 2: 3, 9: 3}
    mesh = Mesh(None, [], [], lines=[], line_tags=[], names=names)

    def add(kind, tag, nodes):
        (mesh.lines if corners[kind] == 2 else mesh.triangles).append([n - 1 for n in nodes[:corners[kind]]])
        (mesh.line_tags if corners[kind] == 2 else mesh.tags).append(tag)

    if section['MeshFormat'][0].startswith('2.2'):
        mesh.points = np.array([[float(x) for x in line.split()[1:3]] for line in section['Nodes'][1:]])
        for line in section['Elements'][1:]:
            number, kind, tags, physical, entity, *nodes = map(int, line.split())
            add(kind, physical, nodes)
        return mesh
    curves = int(section['Entities'][0].split()[1])
    physical = {}
    for k, line in enumerate(section['Entities'][1:]):
        row = line.split()
        physical[1 if k < curves else 2, int(row[0])] = int(row[8])
    blocks, points, _, _ = map(int, section['Nodes'][0].split())
    assert blocks == 1
    mesh.points = np.array([[float(x) for x in line.split()[:2]] for line in section['Nodes'][2 + points:]])
    rest = iter(section['Elements'][1:])
    for line in rest:
        dimension, entity, kind, count = map(int, line.split())
        for _ in range(count):
            add(kind, physical[dimension, entity], [int(n) for n in next(rest).split()[1:]])
    return mesh


def medit(path):
    stream = words(path)
    mesh = Mesh(None, [], [], lines=[], line_tags=[])
    nodes_of = {'Triangles': (3, 3), 'TrianglesP2': (3, 6), 'Edges': (2, 2), 'EdgesP2': (2, 3)}
    for word in stream:
        if word == 'Vertices':
            mesh.points = np.array([take(stream, 3, float)[:2] for _ in range(int(next(stream)))])
        elif word in nodes_of:
            corners, nodes = nodes_of[word]
            elements, tags = ((mesh.triangles, mesh.tags) if corners == 3 else
                              (mesh.lines, mesh.line_tags))
            for _ in range(int(next(stream))):
                row = take(stream, nodes + 1)
                elements.append([n - 1 for n in row[:corners]])
                tags.append(row[-1])
    return mesh


def inp(path):
    """Tags are names of element sets; names has the nodes of each node set."""
    mesh, points, group, kind = Mesh(None, [], [], names={}), [], None, None
    elements = []
    for line in pathlib.Path(path).read_text().splitlines():
        if line.startswith('**'):
            continue
        if line.startswith('*'):
            kind, *options = [part.strip() for part in line[1:].split(',')]
            options = dict(option.split('=') for option in options if '=' in option)
            group = options.get('ELSET' if kind == 'ELEMENT' else 'NSET')
            continue
        row = [part.strip() for part in line.split(',') if part.strip()]
        if kind == 'NODE':
            points.append([float(x) for x in row[1:3]])
        elif kind == 'ELEMENT':
            elements.append((int(row[0]), [int(n) - 1 for n in row[1:4]], group))
        elif kind == 'NSET':
            mesh.names.setdefault(group, set()).update(int(n) - 1 for n in row)
    elements.sort()
    mesh.triangles, mesh.tags = [e[1] for e in elements], [e[2] for e in elements]
    mesh.points = np.array(points)
    return mesh


def triangle(path):
    path = pathlib.Path(path)

    def table(extension):
        rows = [line.split() for line in path.with_suffix(extension).read_text().splitlines()]
        return [row for row in rows if row and not row[0].startswith('#')]

    elements, edges = table('.ele'), table('.edge')
    each = int(elements[0][1])
    return Mesh(np.array([[float(x) for x in row[1:3]] for row in table('.node')[1:]]),
                [[int(n) - 1 for n in row[1:4]] for row in elements[1:]],
                [int(row[1 + each]) for row in elements[1:]], [int(row[2 + each]) for row in elements[1:]],
                [[int(n) - 1 for n in row[1:3]] for row in edges[1:]], [int(row[3]) for row in edges[1:]])


def off(path):
    stream = words(path)
    assert next(stream) == 'OFF'
    points, faces, _ = take(stream, 3)
    return Mesh(np.array([take(stream, 3, float)[:2] for _ in range(points)]),
                [take(stream, 4)[1:] for _ in range(faces)])


def obj(path):
    """Tags are names of groups."""
    mesh, points, group = Mesh(None, [], [], lines=[]), [], None
    for row in (line.split() for line in pathlib.Path(path).read_text().splitlines()):
        if row[:1] == ['v']:
            points.append([float(x) for x in row[1:3]])
        elif row[:1] == ['g']:
            group = row[1]
        elif row[:1] == ['f']:
            mesh.triangles.append([int(n) - 1 for n in row[1:]])
            mesh.tags.append(group)
        elif row[:1] == ['l']:
            mesh.lines.append([int(n) - 1 for n in row[1:]])
    mesh.points = np.array(points)
    return mesh


def ply(path):
    text = pathlib.Path(path).read_text()
    head, body = text.split('end_header\n')
    counts = {row.split()[1]: int(row.split()[2]) for row in head.splitlines() if row.startswith('element')}
    properties = [row.split()[-1] for row in head.splitlines() if row.startswith('property')]
    assert properties == ['x', 'y', 'z', 'vertex_indices', 'material', 'region'], properties
    stream = iter(body.split())
    points = np.array([take(stream, 3, float)[:2] for _ in range(counts['vertex'])])
    faces = [take(stream, 6) for _ in range(counts['face'])]
    return Mesh(points, [f[1:4] for f in faces], [f[4] for f in faces], [f[5] for f in faces])
