#!/usr/bin/env python3
"""Writes samples/data/nmos.tif and nmos.str: a coarse process mesh of one transistor with its doping, as TSUPREM-4 and
SUPREM-IV would store it (own data). Lengths in um; y points downwards."""
import math
import os
import sys

X = [-0.5, -0.4, -0.3, -0.25, -0.2, -0.15, -0.1, 0, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5]
Y = [-0.12, -0.07, -0.01, 0, 0.01, 0.03, 0.06, 0.1, 0.2, 0.4, 0.6]
GATE = 0.2


def region_of(x, y):
    """1 oxide, 2 gate, 3 substrate, 0 nothing; x, y inside a cell."""
    if y > 0:
        return 3
    if abs(x) > GATE:
        return 0
    return 1 if y > -0.01 else 2


def donors(x, y):
    reach = max(0.0, 0.22 - abs(x))
    return 1e20 * math.exp(-(y / 0.05)**2 - (reach / 0.025)**2)


def acceptors(x, y):
    return 1e17 + 4e17 * math.exp(-((y - 0.1) / 0.08)**2)


def mesh():
    nodes, triangles = {}, []

    def node(i, j):
        return nodes.setdefault((i, j), len(nodes) + 1)
    for i in range(len(X) - 1):
        for j in range(len(Y) - 1):
            region = region_of((X[i] + X[i + 1]) / 2, (Y[j] + Y[j + 1]) / 2)
            if region:
                a, b, c, d = node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)
                triangles += [(region, a, b, c), (region, a, c, d)]
    return [(n, X[i], Y[j]) for (i, j), n in nodes.items()], triangles


def values(nodes, triangles):
    """(node, region) of all corners, in order."""
    place = {n: (x, y) for n, x, y in nodes}
    for n, region in sorted({(n, t[0]) for t in triangles for n in t[1:]}):
        x, y = place[n]
        yield n, region, *((donors(x, y), acceptors(x, y)) if region == 3 else (0.0, 0.0))


def write_tif(path):
    nodes, triangles = mesh()
    materials = {1: 'Oxide', 2: 'Poly', 3: 'Si'}
    electrodes = {'source': lambda x, y: y == 0 and x <= -0.3, 'drain': lambda x, y: y == 0 and x >= 0.3,
                  'gate': lambda x, y: y == Y[0], 'bulk': lambda x, y: y == Y[-1]}
    place = {n: (x, y) for n, x, y in nodes}
    edges = sorted({tuple(sorted((t[1 + k], t[1 + (k + 1) % 3]))) for t in triangles for k in range(3)})
    with open(path, 'w') as f:
        f.write('h TIF V1.2.1 own sample\ncd GEN blnk blnk blnk cart2D 1.0 0.0\ncg 3.0E+02\n')
        for n, x, y in nodes:
            f.write(f'c {n} {x} {y} 0.\n')
        used = {name: [k + 1 for k, e in enumerate(edges) if all(holds(*place[n]) for n in e)]
                for name, holds in electrodes.items()}
        for k, (a, b) in enumerate(edges):
            f.write(f'e {k + 1} {a} {b} 0\n')
        for region, material in materials.items():
            f.write(f'r {region} {material} {region}\n')
        for k, (name, own) in enumerate(used.items()):
            f.write(f'i {k + 1} Elec {name} 0\n' + ''.join(f' j {e}\n' for e in own))
        for k, (region, a, b, c) in enumerate(triangles):
            f.write(f't {k + 1} {region} {a} {b} {c} -1024 -1024 -1024\n')
        f.write('s 2 Net Total\n')
        for n, region, plus, minus in values(nodes, triangles):
            f.write(f'n {n} {materials[region]} {plus - minus:.6e} {plus + minus:.6e}\n')


def write_str(path):
    nodes, triangles = mesh()
    materials = {1: 1, 2: 4, 3: 3}
    with open(path, 'w') as f:
        f.write('v SUPREM-IV.GS own sample\nD 2 3 3\n')
        for n, x, y in nodes:
            f.write(f'c {n} {x} {y} 0\n')
        for region, material in materials.items():
            f.write(f'r {region} {material}\n')
        for k, (region, a, b, c) in enumerate(triangles):
            f.write(f't {k + 1} {region} {a} {b} {c} -1024 -1024 -1024\n')
        f.write('s 2 3 5\n')
        for n, region, plus, minus in values(nodes, triangles):
            f.write(f'n {n} {materials[region]} {plus:.6e} {minus:.6e}\n')


if __name__ == '__main__':
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), 'data')
    write_tif(os.path.join(folder, 'nmos.tif'))
    write_str(os.path.join(folder, 'nmos.str'))
