#!/usr/bin/python3
"""Periodic sides in solvers: the field of one cell is that of the whole, at every node.

usage: periodic.py COVER SAMPLES SOLVER [FOLDER]
SOLVER is own (numpy, here), getdp (an anti-periodic motor pole, `Link` with factor -1) or freefem (a doubly periodic
cell, `periodic=`). The whole is made by repeating the mesh of the cell, joined by the pairs of the manifest and not by
coordinates, and solved in numpy. Exit code 77: the program is not installed.
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

LARGEST_ERROR = 1e-9


class Cell:
    """A mesh of a sample with its manifest."""

    def __init__(self, cover, geometry, folder, *options):
        for name in ('a.ele', 'a.msh', 'a.mesh', 'a.json'):
            subprocess.run([cover, 'mesh', geometry, '-q', '-o', folder / name, *options], check=True)
        self.manifest = json.loads((folder / 'a.json').read_text())
        rows = lambda name: [line.split() for line in (folder / name).read_text().splitlines()[1:]
                             if not line.startswith('#')]
        count = self.manifest['counts']
        self.points = np.array([[float(x) for x in row[1:3]] for row in rows('a.node')[:count['vertices']]])
        first = int(rows('a.node')[0][0])
        table = np.array([[int(float(x)) for x in row] for row in rows('a.ele')[:count['triangles']]])
        self.triangles = table[:, 1:4] - first
        self.region = table[:, 5]
        self.regions = {r['id']: r for r in self.manifest['regions']}
        self.pairs = self.manifest['periodic']

    def tag(self, line):
        return next(g['tag'] for g in self.manifest['line_groups'] if g['original'] == line)

    def nodes_of(self, *lines):
        return sorted({v for line in self.manifest['lines'] if line['name'] in lines for e in line['edges'] for v in e})


def matrices(points, triangles, k, mass):
    """Stiffness with coefficient k by triangle, plus mass * the mass matrix; and the integrals of the shape functions."""
    n = len(points)
    matrix, weight = np.zeros((n, n)), np.zeros((len(triangles), 3))
    local_mass = (np.ones((3, 3)) + np.eye(3)) / 12
    for t, nodes in enumerate(triangles):
        p = points[nodes]
        e = np.array([p[2] - p[1], p[0] - p[2], p[1] - p[0]])
        area = (e[0][0] * e[1][1] - e[0][1] * e[1][0]) / 2
        assert area > 0
        matrix[np.ix_(nodes, nodes)] += k[t] * (e @ e.T) / (4 * area) + mass * area * local_mass
        weight[t] = area / 3
    return matrix, weight


def solve(points, triangles, k, source, mass, fixed, links):
    """links: (vertex, vertex, factor): the second value is factor times the first one."""
    n = len(points)
    matrix, weight = matrices(points, triangles, k, mass)
    load = np.zeros(n)
    np.add.at(load, triangles, weight * np.asarray(source)[:, None])
    master, factor = np.arange(n), np.ones(n)
    for a, b, f in links:
        while master[a] != a:
            f, a = f * factor[a], master[a]
        while master[b] != b:
            f, b = f / factor[b], master[b]
        if a != b:
            master[b], factor[b] = a, f
    for v in range(n):  # straight to the root
        u, f = v, 1.0
        while master[u] != u:
            f, u = f * factor[u], master[u]
        master[v], factor[v] = u, f
    free = sorted(set(master.tolist()) - {int(master[v]) for v in fixed})
    column = {v: i for i, v in enumerate(free)}
    spread = np.zeros((n, len(free)))
    for v in range(n):
        if int(master[v]) in column:
            spread[v, column[int(master[v])]] = factor[v]
    return spread @ np.linalg.solve(spread.T @ matrix @ spread, spread.T @ load)


class Pole:
    """The motor pole: alone with factor -1, and four of them."""

    def __init__(self, cell):
        self.cell = cell
        nu = {'shaft': 1e-3, 'iron': 1e-3, 'magnet': 0.9, 'air': 1, 'coil': 1}
        current = {'coil_right': 1.0, 'coil_left': 2.0, 'magnet': 0.1}
        self.nu = {i: nu[r['material_name']] for i, r in cell.regions.items()}
        self.current = {i: current.get(r['name'], 0.0) for i, r in cell.regions.items()}
        self.fixed = cell.nodes_of('inside', 'outside')
        self.rule = cell.pairs[0]

    def alone(self):
        c = self.cell
        return solve(c.points, c.triangles, [self.nu[r] for r in c.region], [self.current[r] for r in c.region], 0,
                     self.fixed, [(a, b, -1.0) for a, b in self.rule['vertices']])

    def whole(self):
        c, n = self.cell, len(self.cell.points)
        image = dict(self.rule['vertices'])
        images = {b: a for a, b in image.items()}
        number = np.full((4, n), -1)
        points = []
        for pole in range(4):
            turn = [[[1, 0], [0, 1]], [[0, -1], [1, 0]], [[-1, 0], [0, -1]], [[0, 1], [-1, 0]]][pole]
            for v in range(n):
                if pole > 0 and v in image:  # on 'start': that is the 'end' of the pole before
                    number[pole, v] = number[pole - 1, image[v]]
                elif pole == 3 and v in images:
                    number[pole, v] = number[0, images[v]]
                else:
                    number[pole, v] = len(points)
                    points.append(np.array(turn) @ c.points[v])
        triangles = np.concatenate([number[pole][c.triangles] for pole in range(4)])
        k = [self.nu[r] for r in c.region] * 4
        source = [self.current[r] * (-1) ** pole for pole in range(4) for r in c.region]
        fixed = {int(number[pole, v]) for pole in range(4) for v in self.fixed}
        u = solve(np.array(points), triangles, k, source, 0, fixed, [])
        return np.array([u[number[pole]] * (-1) ** pole for pole in range(4)])


class Weave:
    """The fibre cell: alone, and three by two of them with periodic outer sides."""

    def __init__(self, cell):
        self.cell = cell
        self.k = {i: 10.0 if r['name'] == 'fibre' else 1.0 for i, r in cell.regions.items()}
        self.source = {i: float(i) for i in cell.regions}

    def alone(self):
        c = self.cell
        links = [(a, b, 1.0) for rule in c.pairs for a, b in rule['vertices']]
        return solve(c.points, c.triangles, [self.k[r] for r in c.region], [self.source[r] for r in c.region], 0.1, [], links)

    def whole(self, columns=3, rows=2):
        c, n = self.cell, len(self.cell.points)
        across, up = ({a: b for a, b in rule['vertices']} for rule in c.pairs)
        shift = [np.array([row[2] for row in rule['matrix']]) for rule in c.pairs]
        points = np.concatenate([c.points + i * shift[0] + j * shift[1] for j in range(rows) for i in range(columns)])
        at = lambda i, j: n * (i % columns + columns * (j % rows))
        links = []
        for j in range(rows):
            for i in range(columns):
                links += [(at(i + 1, j) + a, at(i, j) + b, 1.0) for a, b in across.items()]
                links += [(at(i, j + 1) + a, at(i, j) + b, 1.0) for a, b in up.items()]
        triangles = np.concatenate([c.triangles + n * k for k in range(columns * rows)])
        times = columns * rows
        u = solve(points, triangles, [self.k[r] for r in c.region] * times, [self.source[r] for r in c.region] * times, 0.1,
                  [], links)
        return u.reshape(times, n)


def getdp_pole(pole, folder):
    c = pole.cell
    tags = {i: r['group'] for i, r in c.regions.items()}
    regions = ', '.join(map(str, sorted(set(tags.values()))))
    lines = {name: c.tag(name) for name in ('start', 'end', 'inside', 'outside')}
    rows = [f'Group {{ Solid = Region[{{{regions}}}]; Fixed = Region[{{{lines["inside"]}, {lines["outside"]}}}];',
            f'  Start = Region[{lines["start"]}]; End = Region[{lines["end"]}];',
            '  Everything = Region[{Solid, Fixed, Start, End}]; }', 'Function {']
    for i, tag in tags.items():
        rows.append(f'  nu[Region[{tag}]] = {pole.nu[i]!r}; j[Region[{tag}]] = {pole.current[i]!r};')
    rows.append('''}
Constraint { { Name A; Type Assign; Case {
  { Region Fixed; Value 0; }
  { Region End; Type Link; RegionRef Start; Coefficient -1; Function Rotate[XYZ[], 0, 0, -Pi/2]; } } } }
FunctionSpace { { Name H; Type Form0;
  BasisFunction { { Name s; NameOfCoef c; Function BF_Node; Support Everything; Entity NodesOf[Everything]; } }
  Constraint { { NameOfCoef c; EntityType NodesOf; NameOfConstraint A; } } } }
Jacobian { { Name V; Case { { Region Region[{Fixed, Start, End}]; Jacobian Sur; } { Region Solid; Jacobian Vol; } } } }
Integration { { Name G; Case { { Type Gauss; Case { { GeoElement Triangle; NumberOfPoints 6; }
  { GeoElement Line; NumberOfPoints 3; } } } } } }
Formulation { { Name F; Type FemEquation; Quantity { { Name u; Type Local; NameOfSpace H; } } Equation {
  Galerkin { [nu[] * Dof{d u}, {d u}]; In Solid; Jacobian V; Integration G; }
  Galerkin { [-j[], {u}]; In Solid; Jacobian V; Integration G; } } } }
Resolution { { Name Solve; System { { Name S; NameOfFormulation F; } }
  Operation { Generate[S]; Solve[S]; SaveSolution[S]; } } }
PostProcessing { { Name P; NameOfFormulation F; Quantity { { Name u; Value { Local { [{u}]; In Solid; Jacobian V; } } } } } }
PostOperation { { Name Table; NameOfPostProcessing P; Operation {
  Print[u, OnElementsOf Solid, Format NodeTable, File "u.txt"]; } } }''')
    (folder / 'pole.pro').write_text('\n'.join(rows) + '\n')
    done = subprocess.run(['getdp', 'pole.pro', '-msh', 'a.msh', '-solve', 'Solve', '-pos', 'Table'], cwd=folder, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300)
    table = folder / 'u.txt'
    if not table.exists():
        print(done.stdout[-3000:])
        return None
    u = np.full(len(c.points), np.nan)
    for line in table.read_text().splitlines():
        words = line.split()
        if len(words) == 2:
            u[int(words[0]) - 1] = float(words[1])
    return u


def freefem_cell(weave, folder):
    c = weave.cell
    number = {i: r['material'] for i, r in c.regions.items()}
    by_region = lambda values: ' + '.join(f'{values[i]!r} * (region == {n})' for i, n in number.items())
    # All regions of one material need one source here.
    weave.source = {i: float(n) for i, n in number.items()}
    tag = {name: c.tag(name) for name in ('left', 'right', 'bottom', 'top')}
    one_of_each = {n: i for i, n in number.items()}
    number = {i: n for n, i in one_of_each.items()}
    (folder / 'cell.edp').write_text(f'''
mesh Th = readmesh("a.mesh");
fespace Constants(Th, P0);
fespace Space(Th, P1, periodic = [[{tag['left']}, y], [{tag['right']}, y], [{tag['bottom']}, x], [{tag['top']}, x]]);
Constants k = {by_region(weave.k)}, f = {by_region(weave.source)};
Space u, v;
solve Cell(u, v, solver = UMFPACK) = int2d(Th)(k * (dx(u) * dx(v) + dy(u) * dy(v)) + 0.1 * u * v) - int2d(Th)(f * v);
ofstream out("u.txt");
out.precision(17);
for (int t = 0; t < Th.nt; t++) for (int i = 0; i < 3; i++) out << int(Th[t][i]) << " " << u[][Space(t, i)] << endl;
''')
    done = subprocess.run(['FreeFem++-nw', '-v', '0', 'cell.edp'], cwd=folder, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=300)
    table = folder / 'u.txt'
    if done.returncode != 0 or not table.exists():
        print(done.stdout[-3000:])
        return None
    u = np.full(len(c.points), np.nan)
    for line in table.read_text().splitlines():
        vertex, value = line.split()
        u[int(vertex)] = float(value)
    return u


def error(found, whole):
    return math.inf if found is None or np.isnan(found).any() else np.abs(whole - found).max() / np.abs(whole).max()


def main():
    cover, samples, solver = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]), sys.argv[3]
    program = {'own': None, 'getdp': 'getdp', 'freefem': 'FreeFem++-nw'}[solver]
    if program and shutil.which(program) is None:
        print('not installed:', program)
        sys.exit(77)
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(sys.argv[4] if len(sys.argv) > 4 else scratch).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        errors = {}
        cut = ['--split-interfaces', '--size', '4']
        if solver != 'freefem':
            pole = Pole(Cell(cover, samples / 'motor_pole.json', folder, *cut))
            whole = pole.whole()
            errors['four poles'] = error(pole.alone(), whole)
            if solver == 'getdp':
                errors['GetDP, anti-periodic'] = error(getdp_pole(pole, folder), whole)
        if solver != 'getdp':
            weave = Weave(Cell(cover, samples / 'fibre_cell.json', folder, '--split-interfaces', '--size', '1.5'))
            if solver == 'freefem':
                found = freefem_cell(weave, folder)
                errors['FreeFem++, periodic'] = error(found, weave.whole())
            errors['six cells'] = error(weave.alone(), weave.whole())
    for what, e in errors.items():
        print(f'{what:24} {e:.3g}')
    sys.exit(0 if all(e <= LARGEST_ERROR for e in errors.values()) else 1)


if __name__ == '__main__':
    main()
