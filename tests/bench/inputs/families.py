#!/usr/bin/env python3
"""families.py FAMILY SIZE: an input of about SIZE points as .json on stdout.

Families that invite work of the square of the size: many points on a line, many segments at a point, many
holes, contacts or names. `time_per_point.py` measures all of them. Same family and size, same bytes.
"""
import json
import math
import random
import sys

SQUARE = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]


def ring(n, first=0):
    return [[first + i, first + (i + 1) % n] for i in range(n)]


def polygon(points):
    return {"points": points, "segments": ring(len(points))}


def side(n):
    """All points on one side of a square."""
    return polygon([[i / n, 0.0] for i in range(n)] + SQUARE[1:])


def slanted_side(n):
    """The same, turned: coordinates are rounded, so that no three points need be on one line."""
    return polygon([[0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y] for x, y in side(n)["points"]])


def rough_side(n):
    """A side of a square that is straight but for a thousandth of the distance of its points."""
    rng = random.Random(n)
    return polygon([[i / n, rng.uniform(-1, 1) * 1e-3 / n if i else 0.0] for i in range(n)] + SQUARE[1:])


def two_sides(n):
    """A layer between two straight rows of points."""
    half = n // 2
    return polygon([[i / half, 0.0] for i in range(half + 1)] + [[1 - i / half, 0.01] for i in range(half + 1)])


def circle(n):
    return polygon([[math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n)] for i in range(n)])


def parabola(n):
    """A long arc and its chord: all points of the arc see those beside them only."""
    return polygon([[x, x * x] for x in (2 * i / n - 1 for i in range(n + 1))])


def star(n):
    rng = random.Random(n)
    turn = [2 * math.pi * i / n for i in range(n)]
    radius = [1 + 0.3 * math.sin(5 * t) + 0.5 / n * rng.uniform(-1, 1) for t in turn]
    return polygon([[r * math.cos(t), r * math.sin(t)] for r, t in zip(radius, turn)])


def comb(n):
    """Teeth of a height of 1."""
    teeth = n // 4
    points = [[0.0, -1.0]]
    for i in range(teeth):
        points += [[(4 * i + k) / teeth, float(k in (1, 2))] for k in range(4)]
    return polygon([[4.0, -1.0]] + points[::-1])


def spiral(n):
    """A corridor wound up, with equal steps."""
    inner, outer, turns = [], [], max(2, int(math.sqrt(n) / 6))
    for i in range(n // 2):
        t = math.sqrt(0.002 + i / (n // 2)) * turns * 2 * math.pi
        inner.append([t * math.cos(t), t * math.sin(t)])
        outer.append([(t + 2) * math.cos(t), (t + 2) * math.sin(t)])
    return polygon(inner[::-1] + outer)


def wheel(n):
    """A region per spoke."""
    rim = circle(n)["points"]
    return {"points": rim + [[0.0, 0.0]], "segments": ring(n) + [[i, n] for i in range(n)]}


def fan(n):
    """Spokes that end inside of one region."""
    spokes = [[0.3 * x, 0.3 * y] for x, y in circle(n)["points"]]
    return {"points": [[x - 0.5, y - 0.5] for x, y in SQUARE] + [[0.0, 0.0]] + spokes,
            "segments": ring(4) + [[4, 5 + i] for i in range(n)]}


def holes(n):
    """Square holes in one region."""
    rng = random.Random(n)
    across = max(1, round(math.sqrt(n / 4)))
    points, segments, seeds = [[across * x, across * y] for x, y in SQUARE], ring(4), []
    for i in range(across):
        for j in range(across):
            x, y, t = i + rng.uniform(0.4, 0.6), j + rng.uniform(0.4, 0.6), rng.uniform(0, math.pi)
            segments += ring(4, len(points))
            points += [[x + 0.2 * math.cos(t + k * math.pi / 2), y + 0.2 * math.sin(t + k * math.pi / 2)] for k in range(4)]
            seeds.append([x, y])
    return {"points": points, "segments": segments, "holes": seeds}


def cells(n):
    """A board of regions with seeds."""
    across = max(1, round(math.sqrt(n)))
    points = [[i + 0.2 * math.sin(3 * i + 5 * j), j + 0.2 * math.sin(2 * i + 7 * j)]
              for j in range(across + 1) for i in range(across + 1)]
    at = lambda i, j: j * (across + 1) + i
    segments = [[at(i, j), at(i + 1, j)] for j in range(across + 1) for i in range(across)]
    segments += [[at(i, j), at(i, j + 1)] for j in range(across) for i in range(across + 1)]
    seeds = [{"x": i + 0.5, "y": j + 0.5, "material": f"m{(i + j) % 3}", "region": f"r{i}_{j}"}
             for i in range(across) for j in range(across)]
    return {"points": points, "segments": segments, "regions": seeds}


def strips(n):
    """Layers of the whole width."""
    half = n // 2
    points = [[x, i / half * 4] for i in range(half) for x in (0.0, 1.0)]
    segments = [[2 * i, 2 * i + 1] for i in range(half)]
    segments += [[2 * i + k, 2 * i + 2 + k] for i in range(half - 1) for k in (0, 1)]
    return {"points": points, "segments": segments}


def slits(n):
    """Long parallel segments inside of one region."""
    half = n // 2
    points = [list(p) for p in SQUARE] + [[x, (i + 0.5) / half] for i in range(half) for x in (0.1, 0.9)]
    return {"points": points, "segments": ring(4) + [[4 + 2 * i, 5 + 2 * i] for i in range(half)]}


def crossings(n):
    """Lines that have to be cut: n crossings."""
    lines = max(1, round(math.sqrt(n)))
    points, segments = [], []
    for i in range(lines):
        t = (i + 0.5) / lines
        for a, b in (([t, 0.0], [t + 0.01, 1.0]), ([0.0, t], [1.0, t + 0.01])):
            segments.append([len(points), len(points) + 1])
            points += [a, b]
    return {"points": points, "segments": segments}


def contacts(n):
    """A contact of its own on every segment of a circle."""
    points = circle(n)["points"]
    return {"polygons": [{"material": "a", "rings": [points]}],
            "lines": [{"name": f"c{i}", "points": [points[i], points[(i + 1) % n]]} for i in range(n)]}


def overlapping_names(n):
    """Contacts along a circle, each on eight segments, so that each segment has eight names."""
    points = circle(n)["points"]
    return {"polygons": [{"material": "a", "rings": [points]}],
            "lines": [{"name": f"c{i}", "points": [points[(i + k) % n] for k in range(9)]} for i in range(n)]}


def names_on_one(n):
    """Contacts that all lie on one segment."""
    points = circle(n)["points"]
    return {"polygons": [{"material": "a", "rings": [points]}],
            "lines": [{"name": f"c{i}", "points": points[:2]} for i in range(n)]}


def painted(n):
    """Polygons that overlap their neighbours."""
    return {"polygons": [{"material": f"m{i % 5}", "region": f"r{i}",
                          "rings": [[[x + i, y + i] for x, y in ((0, 0), (1.5, 0), (1.5, 1.4), (0, 1.4))]]}
                         for i in range(n // 4)]}


def nested(n):
    """Polygons inside one another."""
    count = n // 4
    return {"polygons": [{"material": f"m{i % 5}", "rings": [[[-r, -r], [r, -r], [r, r], [-r, r]]]}
                         for i in range(count) for r in [float(count - i)]]}


FAMILIES = {f.__name__: f for f in (
    side, slanted_side, rough_side, two_sides, circle, parabola, star, comb, spiral, wheel, fan, holes, cells, strips,
    slits, crossings, contacts, overlapping_names, names_on_one, painted, nested)}


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in FAMILIES:
        sys.exit(f"{__doc__}\nfamilies: {' '.join(FAMILIES)}")
    json.dump(FAMILIES[sys.argv[1]](int(sys.argv[2])), sys.stdout)


if __name__ == "__main__":
    main()
