#!/usr/bin/env python3
"""Random devices with layers along random lines, each mesh judged by an outside program.

    layered_devices.py COVER VERIFY FIRST COUNT

VERIFY is a Python file with verify(poly, vtu, bound, allow_split), which returns a list of faults and a dictionary of figures, as
`check/verify.py` beside the repository. Devices FIRST to FIRST + COUNT - 1 are made by chance from their number: rings, tensor grids,
trenches, fins, diodes with a bent junction, bird's beaks, each turned and scaled. Prints one line for each fault, then the sums;
exits with 1 if there was one. Not a test by itself: ten thousand take an hour.
"""
import importlib.util
import json
import math
import os
import random
import subprocess
import sys
import tempfile


class Device:
    """Points and segments that meet only at points; open chains of `lines` are named contacts."""

    def __init__(self):
        self.points, self.index, self.segments = [], {}, {}

    def at(self, p):
        if p not in self.index:
            self.index[p] = len(self.points)
            self.points.append(p)
        return self.index[p]

    def chain(self, corners, pieces=1, marker=1, closed=False):
        corners = list(corners)
        if closed:
            corners.append(corners[0])
        for p, q in zip(corners, corners[1:]):
            before = self.at(p)
            for k in range(1, pieces + 1):
                t = k / pieces
                after = self.at(q if k == pieces else (p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t))
                if (after, before) not in self.segments:
                    self.segments[before, after] = marker
                before = after


def rings(r):
    device, count, n = Device(), r.randint(2, 4), r.randint(8, 40)
    for k, radius in enumerate(sorted((r.uniform(0.2, 1) for _ in range(count)), reverse=True)):
        phase, wave, waves = r.uniform(0, 6), r.uniform(0, 0.12), r.randint(2, 5)
        place = []
        for i in range(n):
            t = 2 * math.pi * i / n
            here = radius * 0.8 ** k * (1 + wave * math.sin(waves * t + phase))
            place.append((here * math.cos(t), here * math.sin(t)))
        device.chain(place, closed=True)
    return device


def grid(r):
    device = Device()
    xs, ys = [0.0], [0.0]
    for line in (xs, ys):
        for _ in range(r.randint(1, 4)):
            line.append(line[-1] + 10 ** r.uniform(-1.5, 0.5))
    pieces = r.choice([1, 3, 8, 20])
    cells = {(i, j) for i in range(len(xs) - 1) for j in range(len(ys) - 1) if r.random() < 0.9 or i == j == 0}
    for i, x in enumerate(xs):
        for j, y in enumerate(ys):
            if i + 1 < len(xs) and {(i, j), (i, j - 1)} & cells:
                device.chain([(x, y), (xs[i + 1], y)], pieces)
            if j + 1 < len(ys) and {(i, j), (i - 1, j)} & cells:
                device.chain([(x, y), (x, ys[j + 1])], pieces)
    return device


def trench(r):
    device, n = Device(), r.randint(3, 12)
    w, h = r.uniform(0.3, 1), r.uniform(0.5, 2)
    radius = r.uniform(0.05, 0.9) * min(w, h) / 2

    def outline(d):
        out = [(-w / 2 - d, 0.0)]
        for x, turn in ((-w / 2 + radius, math.pi), (w / 2 - radius, 1.5 * math.pi)):
            for k in range(n + 1):
                a = turn + math.pi / 2 * k / n
                out.append((x + (radius + d) * math.cos(a), -h + radius + (radius + d) * math.sin(a)))
        return out + [(w / 2 + d, 0.0)]

    inner, outer = outline(0), outline(10 ** r.uniform(-3, -0.7))
    device.chain(inner)
    device.chain(outer)
    device.chain([inner[0], outer[0], (-2.0, 0.0), (-2.0, -4.0), (2.0, -4.0), (2.0, 0.0), outer[-1], inner[-1]],
                 r.choice([1, 4]))
    if r.random() < 0.9:
        device.chain([inner[0], inner[-1]], r.choice([1, 5, 30]), 2)
    return device


def fin(r):
    """A fin with slanted sides and an oxide of even thickness on it, both in a gate."""
    device, pieces = Device(), r.choice([1, 2, 6, 15])
    w, h, slant, oxide = r.uniform(5, 15), r.uniform(20, 60), r.choice([0, r.uniform(0, 3)]), 10 ** r.uniform(-0.5, 0.5)
    device.chain([(-w / 2 - slant, 0.0), (-w / 2, h), (w / 2, h), (w / 2 + slant, 0.0)], pieces)
    device.chain([(-w / 2 - slant - oxide, 0.0), (-w / 2 - oxide, h + oxide), (w / 2 + oxide, h + oxide),
                  (w / 2 + slant + oxide, 0.0)], pieces)
    device.chain([(-40.0, 0.0), (-w / 2 - slant - oxide, 0.0), (-w / 2 - slant, 0.0)], pieces)
    device.chain([(w / 2 + slant, 0.0), (w / 2 + slant + oxide, 0.0), (40.0, 0.0)], pieces)
    if r.random() < 0.5:
        device.chain([(-w / 2 - slant, 0.0), (w / 2 + slant, 0.0)], pieces, 3)
    device.chain([(-40.0, 0.0), (-40.0, h + 20), (40.0, h + 20), (40.0, 0.0)], r.choice([1, 5]))
    device.chain([(-40.0, 0.0), (-40.0, -30.0), (40.0, -30.0), (40.0, 0.0)], r.choice([1, 5]), 4)
    return device


def diode(r):
    """A junction inside a region: a chain that ends inside, on the boundary, or is closed."""
    device, n = Device(), r.randint(2, 30)
    bend, kind = r.uniform(-0.3, 0.3), r.randint(0, 2)
    if kind == 2:
        x, y, a, b = 1.0, 0.5, r.uniform(0.1, 0.8), r.uniform(0.05, 0.4)
        device.chain([(x + a * math.cos(2 * math.pi * k / n), y + b * math.sin(2 * math.pi * k / n)) for k in range(max(n, 3))]
                     if n >= 3 else [(x - a, y), (x, y + b), (x + a, y)], marker=7, closed=True)
        device.chain([(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)], r.choice([1, 10]), 1, True)
        return device
    left, right = (0.0, 2.0) if kind == 0 else (r.uniform(0.1, 0.8), r.uniform(1.1, 1.9))
    line = [(left + (right - left) * k / n, 0.5 + bend * math.sin(math.pi * k / n) ** 2) for k in range(n + 1)]
    line[0], line[-1] = (left, 0.5), (right, 0.5)
    device.chain(line, marker=7)
    if kind == 0:
        device.chain([(0.0, 0.5), (0.0, 0.0), (2.0, 0.0), (2.0, 0.5)], r.choice([1, 10]))
        device.chain([(0.0, 0.5), (0.0, 1.0), (2.0, 1.0), (2.0, 0.5)], r.choice([1, 10]))
    else:
        device.chain([(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)], r.choice([1, 10]), 1, True)
    return device


def beak(r):
    """An oxide that thins out to a point or to a thin layer."""
    device, n, thin = Device(), r.randint(4, 40), r.choice([0.0, 10 ** r.uniform(-3, -1)])
    thick, sharp = r.uniform(0.2, 1), r.uniform(1, 3)

    def height(k):
        return thin + (thick - thin) * (1 - k / n) ** sharp

    top = [(4.0 * k / n, height(k) * 0.55) for k in range(n + 1)]
    bottom = [(4.0 * k / n, -height(k) * 0.45) for k in range(n + 1)]
    if thin == 0:
        top[-1] = bottom[-1] = (4.0, 0.0)
    device.chain(top)
    device.chain(bottom)
    device.chain([bottom[0], top[0]])
    device.chain([top[0], (0.0, 3.0), (6.0, 3.0), (6.0, 0.0)], r.choice([1, 6]))
    device.chain([bottom[0], (0.0, -3.0), (6.0, -3.0), (6.0, 0.0)], r.choice([1, 6]))
    if thin == 0:
        device.chain([top[-1], (6.0, 0.0)], r.choice([1, 8]))
    else:
        device.chain([top[-1], bottom[-1]])
    return device


KINDS = (rings, grid, trench, fin, diode, beak)


def placed(device, r):
    """Turned, moved and scaled, or left alone."""
    if r.random() < 0.5:
        return device.points
    a, scale = r.uniform(0, 2 * math.pi), 10 ** r.uniform(-7, 4)
    x, y = (r.uniform(-9, 9) * scale for _ in range(2))
    return [(scale * (math.cos(a) * p[0] - math.sin(a) * p[1]) + x, scale * (math.sin(a) * p[0] + math.cos(a) * p[1]) + y)
            for p in device.points]


def write_poly(path, points, segments):
    with open(path, 'w', encoding='ascii') as file:
        print(len(points), 2, 0, 0, file=file)
        for k, (x, y) in enumerate(points):
            print(k + 1, repr(x), repr(y), file=file)
        print(len(segments), 1, file=file)
        for k, ((a, b), marker) in enumerate(segments.items()):
            print(k + 1, a + 1, b + 1, marker, file=file)
        print(0, file=file)


def lines_of(cover, poly):
    """Names of lines, from what `cover info` says."""
    said = subprocess.run([cover, 'info', poly], capture_output=True, text=True, check=False).stdout
    table = said.split('Interfaces, outlines and contacts')[-1].split('\n\n')[0].splitlines()
    rows = [line.split() for line in table]
    return sorted({row[1] for row in rows if len(row) > 4 and row[0].isdigit()})


def random_layers(r, names, extent):
    words = []
    for name in r.sample(names, min(len(names), r.randint(1, 3))):  # a line has layers once
        growth = r.choice([1, r.uniform(1.05, 2)])
        count = r.randint(1, 12) if growth == 1 else r.choice([0, r.randint(1, 12)])
        words += ['--layers', f'{name}={extent * 10 ** r.uniform(-5, -1):.6g},{growth:.6g},{count}']
    return words


def main(cover, verify_file, first, count):
    spec = importlib.util.spec_from_file_location('verify', verify_file)
    judge = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(judge)
    sums = {'meshed': 0, 'with layers': 0, 'refused': 0, 'faults': 0, 'negative inside': 0, 'triangles': 0}
    sums.update((kind.__name__, 0) for kind in KINDS)
    with tempfile.TemporaryDirectory() as folder:
        poly, vtu, report = (os.path.join(folder, name) for name in ('d.poly', 'd.vtu', 'r.json'))
        for seed in range(first, first + count):
            r = random.Random(seed)
            kind = r.choice(KINDS)
            device = kind(r)
            points = placed(device, r)
            write_poly(poly, points, device.segments)
            names = lines_of(cover, poly)
            extent = max(max(p[k] for p in points) - min(p[k] for p in points) for k in range(2))
            words = random_layers(r, names, extent) if names else []
            if r.random() < 0.2:
                words += ['--method', 'almond']
            split = r.random() < 0.15
            if split:
                words += r.choice([['--split-interfaces'], ['--box-method'], ['--split-interfaces', '--box-method']]) \
                    if '--method' not in words else ['--split-interfaces']
            if r.random() < 0.9:
                words += ['--effort', 'fast']
            run = subprocess.run([cover, 'mesh', poly, '-o', vtu, '-q', '--report', report, *words], capture_output=True,
                                 text=True, check=False)
            if run.returncode == 2 and 'layers for' in run.stderr:  # thicker than a region
                sums['refused'] += 1
                continue
            if run.returncode != 0:
                faults = [f'exit {run.returncode}: {run.stderr[:300]}']
            else:
                faults, _ = judge.verify(poly, vtu, 'paper', split)
                with open(report, encoding='utf-8') as file:
                    said = json.load(file)
                sums['meshed'] += 1
                sums[kind.__name__] += 1
                sums['with layers'] += any(line['most'] > 0 for part in said['regions'] for line in part.get('layers', []))
                inside = said['overall']['box']['negative_inside']
                sums['negative inside'] += inside
                sums['triangles'] += said['mesh']['triangles']
                if inside:
                    print('coupling', seed, kind.__name__, inside, *words, flush=True)
            if faults:
                sums['faults'] += 1
                print('FAULT', seed, kind.__name__, *words, *faults, flush=True)
    print(json.dumps(sums))
    return 1 if sums['faults'] else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])))
