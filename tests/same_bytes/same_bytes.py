#!/usr/bin/env python3
"""same_bytes.py OLD NEW [-k WORD]: do two builds of the program make the same meshes, byte for byte?

Meshes the samples, the cases of others (../shared/cases, where they are) and generated inputs in every
way with both programs, and compares exit codes and Triangle's .node, .ele and .edge: coordinates,
triangles, regions, materials and markers in their order. With --reports the JSON reports too, apart
from times and provenance. On request, not a test: for steps that only move, rename or unite.

Exits with 1 where anything differs, and names it. A full run takes some minutes on two cores.
"""
import argparse
import concurrent.futures
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASES = ROOT.parent / 'shared/cases'
SECONDS = 60  # for one run; a run that takes longer in both programs says nothing

WAYS = {
    'quality': [],
    'strict_angles': ['--max-angle', '90', '--min-angle', '30'],
    'almond': ['--method', 'almond'],
    'disks': ['--fill', 'disks'],
    'paper': ['--paper', '--pieces', '8'],
    'nonobtuse': ['--method', 'nonobtuse'],
    'hull': ['--hull'],
    'hull_almond': ['--hull', '--method', 'almond'],
    'cut': ['--split-interfaces', '--max-angle', '90'],
    'growth': ['--growth', '1.5'],
    'fast': ['--effort', 'fast'],
    'thorough': ['--effort', 'thorough'],
    'largest': ['--prefer', 'largest'],
    'couplings_last': ['--couplings', 'last'],
    'boxes': ['--box-method'],
    # Generated inputs only, whose extents are known.
    'sized': ['--size', '0.2'],
    'sized_cut': ['--size', '0.2', '--split-interfaces'],
    'sized_fast': ['--size', '0.2', '--effort', 'fast'],
    'sized_largest': ['--size', '0.2', '--prefer', 'largest'],
    'merged': ['--merge-materials', '--weld', 'auto', '--overlap', 'first'],
}


def poly(points, segments, holes=(), seeds=()):
    """The text of a .poly; seeds are (x, y, material, area)."""
    lines = [f'{len(points)} 2 0 0'] + [f'{i} {x!r} {y!r}' for i, (x, y) in enumerate(points)]
    lines += [f'{len(segments)} 0'] + [f'{i} {a} {b}' for i, (a, b) in enumerate(segments)]
    lines += [str(len(holes))] + [f'{i} {x!r} {y!r}' for i, (x, y) in enumerate(holes)]
    lines += [str(len(seeds))] + [f'{i} {x!r} {y!r} {m} {a}' for i, (x, y, m, a) in enumerate(seeds)]
    return '\n'.join(lines) + '\n'


def ring(points, start=0):
    n = len(points)
    return [(start + i, start + (i + 1) % n) for i in range(n)]


def star(rng, n, smallest):
    """A star-shaped polygon with radii from `smallest` to 1."""
    angles = sorted(rng.uniform(0, 2 * math.pi) for _ in range(n))
    return [(r * math.cos(a), r * math.sin(a)) for a in angles for r in [rng.uniform(smallest, 1)]]


def generated(seed):
    """Inputs by name: text and extension."""
    rng = random.Random(seed)
    for n, smallest in [(12, .5), (60, .1), (200, .3), (400, .8)]:
        points = star(rng, n, smallest)
        yield f'star_{n}', poly(points, ring(points)), 'poly'
    smooth = [(r * math.cos(a), r * math.sin(a)) for i in range(800)
              for a in [2 * math.pi * i / 800] for r in [1 + .2 * math.sin(5 * a) + .05 * math.cos(17 * a)]]
    yield 'smooth_star', poly(smooth, ring(smooth)), 'poly'
    comb = [(0.0, 0.0), (10.0, 0.0)]
    for i in range(10, 0, -1):
        comb += [(i - .1, 1 + rng.random()), (i - .5, .1 + .05 * rng.random())]
    yield 'comb', poly(comb, ring(comb)), 'poly'
    # Stacked layers, the thinnest a ten-thousandth of the width.
    heights, layers, segments, seeds = [0, 1e-4, 2e-3, .05, .3], [], [], []
    for i, h in enumerate(heights):
        layers += [(0.0, float(h)), (1.0, float(h))]
        segments.append((2 * i, 2 * i + 1))
        if i:
            segments += [(2 * i - 2, 2 * i), (2 * i - 1, 2 * i + 1)]
            seeds.append((.5, (h + heights[i - 1]) / 2, i, 0))
    yield 'layers', poly(layers, segments, seeds=seeds), 'poly'
    outer, inner = star(rng, 40, .7), [(.2 * x, .2 * y) for x, y in star(rng, 9, .5)]
    slit = [(.3, .3), (.42, .31)]
    yield 'hole_slit_point', poly(outer + inner + slit + [(-.4, .25)],
                                  ring(outer) + ring(inner, 40) + [(49, 50)], holes=[(0.0, 0.0)]), 'poly'
    sized = [(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (0.0, 1.0), (2.0, 0.0), (2.0, 1.0)]
    yield 'sized', poly(sized, [(0, 4), (4, 1), (1, 2), (2, 5), (5, 3), (3, 0), (4, 5)],
                        seeds=[(1.0, .5, 1, .01), (3.0, .5, 2, 0)]), 'poly'
    scattered = [(rng.random(), rng.random()) for _ in range(30)]
    yield 'crossing_segments', poly(scattered, [(2 * i, 2 * i + 1) for i in range(15)] +
                                    [(28, 3), (0, 29)]), 'poly'
    # A checkerboard with bent sides.
    cells, place, ends, seeds = 5, {}, set(), []

    def at(i, j):
        return place.setdefault((i, j), len(place))

    for i in range(cells * 4 + 1):
        for j in range(cells * 4 + 1):
            if i % 4 == 0 and j < cells * 4:
                ends.add((at(i, j), at(i, j + 1)))
            if j % 4 == 0 and i < cells * 4:
                ends.add((at(i, j), at(i + 1, j)))
    points = [(i + (rng.uniform(-.3, .3) if i % 4 or j % 4 else 0), j + (rng.uniform(-.3, .3) if i % 4 or j % 4 else 0))
              for i, j in place]
    for i in range(cells):
        for j in range(cells):
            seeds.append((4.0 * i + 2, 4.0 * j + 2, 1 + (i + j) % 2, 0))
    yield 'checker', poly(points, sorted(ends), seeds=seeds), 'poly'
    # Painted polygons: overlaps, T-junctions, near misses, a circle.
    shapes = [{'material': f'm{k % 3}', 'region': f'r{k}', 'rings': [[[x, y], [x + w, y], [x + w, y + h], [x, y + h]]]}
              for k in range(12) for x, y, w, h in
              [(rng.randint(0, 8), rng.randint(0, 8), rng.randint(1, 4), rng.randint(1, 4) + rng.choice([0, 1e-9]))]]
    yield 'painted', json.dumps({'polygons': shapes}), 'json'


def inputs(folder, seed):
    for kind, files in [('sample', sorted((ROOT / 'samples/data').glob('*.*'))), ('case', sorted(CASES.glob('*.json'))),
                        ('crash', sorted((CASES / 'crashes').glob('*.json')))]:
        for path in files:
            if path.suffix in ('.poly', '.json'):
                yield f'{kind}/{path.stem}', path
    for name, text, extension in generated(seed):
        path = folder / f'{name}.{extension}'
        path.write_text(text)
        yield f'generated/{name}', path


def without(value, names):
    """A JSON value without what changes from run to run."""
    if isinstance(value, dict):
        return {k: without(v, names) for k, v in value.items() if k not in names}
    return [without(v, names) for v in value] if isinstance(value, list) else value


def result(program, path, options, folder, reports):
    """What a run gave: exit code and the bytes of its files; None if it took too long."""
    folder.mkdir(parents=True)
    words = [program, 'mesh', path, '-o', folder / 'm.ele', '--report', folder / 'r.json', '-q', '-j', '1', *options]
    try:
        done = subprocess.run([*map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return None
    files = {'exit code': done.returncode}
    for extension in ('node', 'ele', 'edge'):
        file = folder / f'm.{extension}'
        files['.' + extension] = file.read_bytes() if file.exists() else None
    if reports:
        report = folder / 'r.json'
        volatile = ('provenance', 'seconds', 'times', 'version', 'threads')
        files['report'] = without(json.loads(report.read_bytes()), volatile) if report.exists() else None
        files['words'] = done.stderr
    return files


def compare(old, new, name, way, path, folder, reports):
    place = folder / name / way
    before = result(old, path, WAYS[way], place / 'old', reports)
    after = result(new, path, WAYS[way], place / 'new', reports)
    if before is None or after is None:
        return name, way, None if before is after else ['time'], None
    return name, way, [what for what in before if before[what] != after[what]], before['exit code']


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('old', type=pathlib.Path)
    parser.add_argument('new', type=pathlib.Path)
    parser.add_argument('-k', metavar='WORD', default='', help='only where WORD is in INPUT:WAY, say mosfet or :hull')
    parser.add_argument('-j', type=int, default=1, help='comparisons at the same time')
    parser.add_argument('--seed', type=int, default=0, help='of the generated inputs')
    parser.add_argument('--reports', action='store_true', help='compare reports and messages too')
    parser.add_argument('--keep', type=pathlib.Path, help='leave all files in this new folder')
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.keep or pathlib.Path(temporary)
        (folder / 'inputs').mkdir(parents=True)
        runs = [(name, way, path) for name, path in inputs(folder / 'inputs', arguments.seed) for way in WAYS
                if arguments.k in f'{name}:{way}' and ('sized' not in way or name.startswith('generated'))]
        differ, slow, codes = 0, 0, {}
        with concurrent.futures.ThreadPoolExecutor(arguments.j) as pool:
            for name, way, what, code in pool.map(
                    lambda r: compare(arguments.old.resolve(), arguments.new.resolve(), r[0], r[1], r[2],
                                      folder / 'runs', arguments.reports), runs):
                codes[code] = codes.get(code, 0) + 1
                slow += what is None
                if what:
                    differ += 1
                    print(f'{name}:{way}: {", ".join(what)}', flush=True)
        ends = ', '.join(f'{n} with {c}' for c, n in sorted(codes.items(), key=str) if c is not None)
        print(f'{len(runs)} runs, {differ} differ, {slow} take longer than {SECONDS} s (exit codes: {ends})')
    return 1 if differ or not runs else 0


if __name__ == '__main__':
    sys.exit(main())
