"""What is solved: see README.md. A problem is written as lines of words that every program can read:

    region NUMBER K GX GY         K, and the gradient of the solution, in a region
    affine A GX GY                the solution is the smallest of these A + GX x + GY y
    fixed NUMBER                  a line on which the solution is given
    line NUMBER LEFT SX SY OUTER  any other: the source is (SX, SY) times the normal that points out
                                  of region LEFT; OUTER is 1 on the outer boundary
"""
import collections
import json


def affine_of(node_file):
    """An affine function of size 1 over the points of Triangle's .node."""
    rows = [line.split() for line in node_file.read_text().splitlines()[1:]]
    xs, ys = [float(row[1]) for row in rows], [float(row[2]) for row in rows]
    gx, gy = 2 / (max(xs) - min(xs)), 3 / (max(ys) - min(ys))
    return [1 - gx * min(xs) - gy * min(ys), gx, gy]


class Problem:
    def __init__(self, manifest_file, node_file):
        self.manifest = json.loads(manifest_file.read_text())
        names = {region['name'] for region in self.manifest['regions']}
        if names == {'Si', 'SiO2'}:
            self.affine = [[0, 0.9, 0], [0.8, 0.1, 0]]
            self.k = {r['id']: 1 if r['name'] == 'Si' else 4 for r in self.manifest['regions']}
            self.gradient = {r['id']: (0.9, 0) if r['name'] == 'Si' else (0.1, 0) for r in self.manifest['regions']}
        else:
            self.affine = [affine_of(node_file)]
            self.k = {r['id']: 1 + r['material'] for r in self.manifest['regions']}
            self.gradient = {r['id']: self.affine[0][1:] for r in self.manifest['regions']}

    def flux(self, region):
        return [self.k[region] * g for g in self.gradient[region]] if region else [0, 0]

    def text(self, key):
        """`key`: what numbers regions in the file, 'group' or 'material'."""
        number = {region['id']: region[key] for region in self.manifest['regions']}
        lines = sorted({f'region {number[r]} {self.k[r]} {self.gradient[r][0]!r} {self.gradient[r][1]!r}' for r in number})
        lines += [f'affine {a!r} {gx!r} {gy!r}' for a, gx, gy in self.affine]
        return '\n'.join(lines + [*self.boundary(number)]) + '\n'

    def boundary(self, number):
        """Contacts are fixed, and what has no one pair of sides; on all other lines there is a source."""
        pairs = collections.defaultdict(set)
        for line in self.manifest['lines']:
            for group in line.get('groups', [line.get('group')]):
                sides = (number[line['left']], number.get(line['right'], 0))
                source = [l - r for l, r in zip(self.flux(line['left']), self.flux(line['right']))]
                pairs[group].add((line['kind'] == 'contact', sides, *source))
        fixed = {group for group, sides in pairs.items() if len(sides) > 1 or next(iter(sides))[0]}
        if not fixed:
            fixed = {next(g for g, sides in sorted(pairs.items()) if next(iter(sides))[1][1] == 0)}
        for group, sides in sorted(pairs.items()):
            if group in fixed:
                yield f'fixed {group}'
                continue
            (_, (left, right), sx, sy), = sides
            if left != right:
                yield f'line {group} {left} {sx!r} {sy!r} {int(right == 0)}'


def smallest(terms, function):
    """min(a, min(b, c)), for languages whose minimum takes two."""
    return terms[0] if len(terms) == 1 else f'{function}{terms[0]}, {smallest(terms[1:], function)}{")" if function[-1] == "(" else "]"}'


def freefem(data):
    """The include file of freefem.edp."""
    k = ' + '.join(f'{k!r} * (region == {n})' for n, (k, _, _) in data.regions.items())
    exact = smallest([f'({a!r} + ({gx!r}) * x + ({gy!r}) * y)' for a, gx, gy in data.affine], 'min(')
    sources = ' '.join(f'- int1d(Th, {n})((2. * (region == {left}) - 1.) * (({sx!r}) * N.x + ({sy!r}) * N.y) * v)'
                       for n, left, sx, sy in data.lines)
    return (f'Constants k = {k};\nfunc exact = {exact};\n'
            f'int[int] fixed = [{", ".join(map(str, data.fixed))}];\nmacro sources() {sources} //\n')


def getdp(data):
    """The include file of getdp.pro. Normals of lines point to the right, where their right region is."""
    group = lambda numbers: f'Region[{{{", ".join(map(str, numbers))}}}]'
    rows = ['Group {', f'  Solid = {group(data.regions)}; Fixed = {group(data.fixed)};',
            f'  Lines = {group(line[0] for line in data.lines)};', '}', 'Function {']
    rows += [f'  k[Region[{n}]] = {k!r};' for n, (k, _, _) in data.regions.items()]
    rows += [f'  flux[Region[{n}]] = Vector[{sx!r}, {sy!r}, 0];' for n, _, sx, sy in data.lines]
    exact = smallest([f'({a!r} + ({gx!r}) * X[] + ({gy!r}) * Y[])' for a, gx, gy in data.affine], 'Min[')
    return '\n'.join([*rows, f'  exact[] = {exact};', '}']) + '\n'


class Data:
    """A problem as a program in Python reads it."""

    def __init__(self, path):
        rows = [line.split() for line in open(path)]
        pick = lambda word: [row[1:] for row in rows if row[0] == word]
        self.regions = {int(n): (float(k), float(gx), float(gy)) for n, k, gx, gy in pick('region')}
        self.affine = [tuple(map(float, row)) for row in pick('affine')]
        self.fixed = [int(row[0]) for row in pick('fixed')]
        self.lines = [(int(row[0]), int(row[1]), float(row[2]), float(row[3])) for row in pick('line')]
        self.inner = [int(row[0]) for row in pick('line') if row[4] == '0']
        self.outer = [int(row[0]) for row in pick('line') if row[4] == '1']

    def exact(self, x, y):
        import numpy as np
        return np.min([a + gx * x + gy * y for a, gx, gy in self.affine], axis=0)
