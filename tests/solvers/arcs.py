#!/usr/bin/python3
"""True arcs in a solver: the capacitance of a coaxial line, given with 8 chords to a circle.

usage: arcs.py COVER SAMPLES SOLVER [FOLDER]
SOLVER is own (finite elements of second order in numpy, here) or getdp. Cut along the arcs and with --order 2 it must
come to 2 pi / ln 2 as fast as structured meshes do; with straight edges it does not. Exit code 77: not installed.
"""
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

try:
    import numpy as np
except ImportError:
    print('not installed: numpy')
    sys.exit(77)

EXACT = 2 * math.pi / math.log(2)
LARGEST_ERROR = 1e-4  # with 32 pieces


def mesh(cover, samples, folder, pieces, order):
    """The nodes, triangles (three or six nodes) and fixed nodes of the line cut into so many pieces."""
    size = lambda radius: repr(2 * math.pi * radius / pieces)
    cuts = [] if pieces <= 8 else ['--split-interfaces=150', '--size-at', f'inner={size(1)}', '--size-at', f'outer={size(2)}',
                                   '--growth', '1.005']
    subprocess.run([cover, 'mesh', samples / 'coax_arcs.json', '-q', '-o', folder / 'a.msh', '-o', folder / 'a.json', '--order',
                    str(order), *cuts], check=True)
    manifest = json.loads((folder / 'a.json').read_text())
    lines = (folder / 'a.msh').read_text().splitlines()
    start = lines.index('$Nodes')
    count = int(lines[start + 1])
    points = np.array([[float(x) for x in line.split()[1:3]] for line in lines[start + 2:start + 2 + count]])
    start = lines.index('$Elements')
    rows = [[int(x) for x in line.split()] for line in lines[start + 2:start + 2 + int(lines[start + 1])]]
    triangles = np.array([row[5:] for row in rows if row[1] in (2, 9)]) - 1
    tags = {g['original']: g['tag'] for g in manifest['line_groups']}
    nodes = {name: sorted({n - 1 for row in rows if row[1] in (1, 8) and row[3] == tags[name] for n in row[5:]})
             for name in ('inner', 'outer')}
    edges = sum(len(line['edges']) for line in manifest['lines'] if line['name'] == 'inner')
    assert edges == pieces, (edges, pieces)
    return points, triangles, nodes, tags, manifest


def shapes(each, r, s):
    """The derivatives of the shape functions by r and s."""
    q = 1 - r - s
    if each == 3:
        return np.array([[-1, 1, 0], [-1, 0, 1]], float)
    return np.array([[1 - 4 * q, 4 * r - 1, 0, 4 * (q - r), 4 * s, -4 * s],
                     [1 - 4 * q, 0, 4 * s - 1, -4 * r, 4 * r, 4 * (q - s)]])


# Seven points, exact for degree 5.
A, B = (6 - math.sqrt(15)) / 21, (6 + math.sqrt(15)) / 21
POINTS = [(1 / 3, 1 / 3, 9 / 80)] + [(r, s, w) for t, w in ((A, (155 - math.sqrt(15)) / 2400), (B, (155 + math.sqrt(15)) / 2400))
                                     for r, s in ((t, t), (1 - 2 * t, t), (t, 1 - 2 * t))]


def capacitance(points, triangles, nodes):
    n, each = len(points), triangles.shape[1]
    matrix = np.zeros((n, n))
    for t in triangles:
        for r, s, weight in POINTS:
            d = shapes(each, r, s)
            jacobian = d @ points[t]
            determinant = np.linalg.det(jacobian)
            assert determinant > 0
            gradient = np.linalg.solve(jacobian, d)
            matrix[np.ix_(t, t)] += weight * determinant * gradient.T @ gradient
    u = np.zeros(n)
    u[nodes['inner']] = 1
    fixed = np.zeros(n, bool)
    fixed[nodes['inner'] + nodes['outer']] = True
    free = ~fixed
    u[free] = np.linalg.solve(matrix[np.ix_(free, free)], -matrix[np.ix_(free, fixed)] @ u[fixed])
    return u @ matrix @ u


def getdp_capacitance(folder, tags, manifest):
    solid = manifest['regions'][0]['group']
    (folder / 'coax.pro').write_text(f'''
Group {{ Solid = Region[{solid}]; Inner = Region[{tags['inner']}]; Outer = Region[{tags['outer']}];
  Everything = Region[{{Solid, Inner, Outer}}]; }}
Constraint {{ {{ Name V; Type Assign; Case {{ {{ Region Inner; Value 1; }} {{ Region Outer; Value 0; }} }} }} }}
FunctionSpace {{ {{ Name H; Type Form0;
  BasisFunction {{ {{ Name s; NameOfCoef c; Function BF_Node; Support Everything; Entity NodesOf[All]; }} }}
  Constraint {{ {{ NameOfCoef c; EntityType NodesOf; NameOfConstraint V; }} }} }} }}
Jacobian {{ {{ Name J; Case {{ {{ Region Solid; Jacobian Vol; }} }} }} }}
Integration {{ {{ Name G; Case {{ {{ Type Gauss; Case {{ {{ GeoElement Triangle2; NumberOfPoints 12; }} }} }} }} }} }}
Formulation {{ {{ Name F; Type FemEquation; Quantity {{ {{ Name u; Type Local; NameOfSpace H; }} }} Equation {{
  Galerkin {{ [Dof{{d u}}, {{d u}}]; In Solid; Jacobian J; Integration G; }} }} }} }}
Resolution {{ {{ Name Solve; System {{ {{ Name S; NameOfFormulation F; }} }}
  Operation {{ Generate[S]; Solve[S]; SaveSolution[S]; }} }} }}
PostProcessing {{ {{ Name P; NameOfFormulation F; Quantity {{ {{ Name c; Value {{
  Integral {{ [{{d u}} * {{d u}}]; In Solid; Jacobian J; Integration G; }} }} }} }} }} }}
PostOperation {{ {{ Name Total; NameOfPostProcessing P; Operation {{
  Print[c[Solid], OnGlobal, Format Table, File "c.txt"]; }} }} }}
''')
    done = subprocess.run(['getdp', 'coax.pro', '-msh', 'a.msh', '-solve', 'Solve', '-pos', 'Total'], cwd=folder, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300)
    table = folder / 'c.txt'
    if not table.exists():
        print(done.stdout[-3000:])
        return math.inf
    return float(table.read_text().split()[-1])


def main():
    cover, samples, solver = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]), sys.argv[3]
    if solver == 'getdp' and shutil.which('getdp') is None:
        print('not installed: getdp')
        sys.exit(77)
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(sys.argv[4] if len(sys.argv) > 4 else scratch).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        good, errors = True, {}
        for order in (1, 2):
            for pieces in (8, 16, 32, 64) if solver == 'own' else (32, 64) if order == 2 else ():
                points, triangles, nodes, tags, manifest = mesh(cover, samples, folder, pieces, order)
                found = capacitance(points, triangles, nodes) if solver == 'own' else getdp_capacitance(folder, tags, manifest)
                errors[order, pieces] = abs(found / EXACT - 1)
                print(f'order {order}, {pieces:2} pieces, {len(points):5} nodes: {found:.9f}, off by {errors[order, pieces]:.2e}')
        good &= errors[2, 32] <= LARGEST_ERROR
        if solver == 'own':
            good &= errors[2, 32] < errors[2, 16] / 5  # chords are of second order at best
            good &= errors[1, 32] > 100 * errors[2, 32]
    sys.exit(0 if good else 1)


if __name__ == '__main__':
    main()
