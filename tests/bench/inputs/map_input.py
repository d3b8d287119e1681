#!/usr/bin/env python3
"""Writes map-like inputs as .json on stdout: what real maps are like, from a seed.

    map_input.py counties [COUNT] [SEED]   cells with shared rough borders (python3-scipy)
    map_input.py parcels  [COUNT] [SEED]   blocks of lots between streets, which are void
"""
import json
import math
import random
import sys


class Points:
    """Points by coordinates, each once."""

    def __init__(self):
        self.all, self.number = [], {}

    def add(self, x, y):
        key = (round(x, 6), round(y, 6))
        if key not in self.number:
            self.number[key] = len(self.all)
            self.all.append(list(key))
        return self.number[key]


def rough_line(a, b, apexes, levels, rng):
    """Points from a to b, displaced inside the triangles from ab to both apexes: borders that stay in
    triangles of their own do not meet."""
    offsets = {0.0: 0.0, 1.0: 0.0}

    def halve(low, high, level, size):
        if level == 0:
            return
        middle = (low + high) / 2
        value = (offsets[low] + offsets[high]) / 2 + rng.gauss(0, size)
        offsets[middle] = max(-0.9, min(0.9, value))
        halve(low, middle, level - 1, size * 0.6)
        halve(middle, high, level - 1, size * 0.6)

    halve(0.0, 1.0, levels, 0.35)
    line = []
    for t in sorted(offsets):
        s, w = offsets[t], 2 * min(t, 1 - t)
        m = apexes[0] if s > 0 else apexes[1]
        line.append(tuple(a[i] + t * (b[i] - a[i]) + abs(s) * w * (m[i] - (a[i] + b[i]) / 2) for i in (0, 1)))
    return line


def counties(count, seed):
    from scipy.spatial import Voronoi

    rng = random.Random(seed)
    # Dense in places, as people live: half of the seeds stand around some towns.
    towns = [(rng.uniform(0, 100), rng.uniform(0, 60)) for _ in range(25)]
    seeds = []
    while len(seeds) < count:
        if rng.random() < 0.5:
            x, y = rng.uniform(0, 100), rng.uniform(0, 60)
        else:
            cx, cy = rng.choice(towns)
            x, y = rng.gauss(cx, 6), rng.gauss(cy, 6)
        if 0 < x < 100 and 0 < y < 60:
            seeds.append((x, y))
    # Mirrored at the frame, so that its sides are edges of the diagram.
    mirrored = [(-x, y) for x, y in seeds] + [(200 - x, y) for x, y in seeds]
    mirrored += [(x, -y) for x, y in seeds] + [(x, 120 - y) for x, y in seeds]
    diagram = Voronoi(seeds + mirrored)
    points, segments = Points(), []
    for (p, q), (u, v) in zip(diagram.ridge_points, diagram.ridge_vertices):
        if min(p, q) >= count or u < 0 or v < 0:
            continue
        a, b = diagram.vertices[u], diagram.vertices[v]
        length = math.dist(a, b)
        centre = [tuple((a[i] + b[i] + diagram.points[s][i]) / 3 for i in (0, 1)) for s in (p, q)]
        levels = 0 if max(p, q) >= count or length < 0.05 else 1 if length < 0.4 else 2 if length < 1.2 else 3
        line = rough_line(a, b, centre, levels, rng)
        for start, end in zip(line, line[1:]):
            i, j = points.add(*start), points.add(*end)
            if i != j:
                segments.append([i, j])
    return points.all, segments, []


def parcels(count, seed):
    rng = random.Random(seed)
    points, segments, regions = Points(), set(), []

    def side(i, j):
        if i != j:
            segments.add((min(i, j), max(i, j)))

    def block(x, y, width, height, turn):
        """Two rows of lots of width 12 to 30, back to back."""
        nonlocal count
        co, si = math.cos(turn), math.sin(turn)
        at = lambda u, v: points.add(x + co * u - si * v, y + si * u + co * v)

        def cuts():
            u, out = 0.0, [0.0]
            while width - u > 36:
                u += rng.uniform(12, 30)
                out.append(u)
            return out + [width]

        back = height * rng.uniform(0.42, 0.58)
        rows = [(0.0, back, cuts()), (back, height, cuts())]
        line = sorted({u for row in rows for u in row[2]})
        for a, b in zip(line, line[1:]):
            side(at(a, back), at(b, back))
        for low, high, row in rows:
            front = low if low == 0 else high
            for a, b in zip(row, row[1:]):
                side(at(a, front), at(b, front))
                regions.append({"x": x + co * (a + b) / 2 - si * (low + high) / 2,
                                "y": y + si * (a + b) / 2 + co * (low + high) / 2, "material": 1})
                count -= 1
            for u in row:
                side(at(u, low), at(u, high))

    y = 0.0
    while count > 0:
        x, height = 0.0, rng.uniform(50, 80)
        while count > 0 and x < 3000:
            width = rng.uniform(80, 260)
            block(x, y, width, height, rng.uniform(-0.02, 0.02))
            x += width + rng.uniform(14, 22)
        y += height + 30
    return points.all, [list(s) for s in sorted(segments)], regions


def main():
    kind = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else {"counties": 3500, "parcels": 5000}[kind]
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 0
    points, segments, regions = {"counties": counties, "parcels": parcels}[kind](count, seed)
    name = f"{kind} {count} seed {seed}"
    json.dump({"name": name, "points": points, "segments": segments, "holes": [], "regions": regions}, sys.stdout)
    print(f"{name}: {len(points)} points, {len(segments)} segments", file=sys.stderr)


if __name__ == "__main__":
    main()
