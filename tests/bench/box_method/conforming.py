#!/usr/bin/env python3
"""conforming.py list | KIND SIZE [SEED]: inputs for conforming triangulations without obtuse angles, as .json on stdout.

Small planar straight-line graphs of the kinds that the CG:SHOP challenge of 2025 had, made at random from a seed: simple
polygons, the same within their convex hull, with and without points between, orthogonal polygons with
diagonals, and sets of points within their convex hull. Coordinates are integers. `list` names the 30 of
conforming_points.py. Same kind, size and seed, same bytes.
"""
import json
import random
import sys

WIDTH = 10_000
KINDS = ("simple", "exterior", "exterior_points", "orthogonal", "points")
SIZES = (10, 20, 40, 80, 150, 250)


def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def lies_between(a, b, p):
    return min(a[0], b[0]) <= p[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= p[1] <= max(a[1], b[1])


def meet(a, b, c, d):
    """Whether the closed segments ab and cd have a point in common."""
    t = [turn(c, d, a), turn(c, d, b), turn(a, b, c), turn(a, b, d)]
    if t[0] * t[1] < 0 and t[2] * t[3] < 0:
        return True
    return (t[0] == 0 and lies_between(c, d, a)) or (t[1] == 0 and lies_between(c, d, b)) or \
        (t[2] == 0 and lies_between(a, b, c)) or (t[3] == 0 and lies_between(a, b, d))


def hull_of(points):
    """Indices, counter-clockwise, with the points on its edges."""
    order = sorted(range(len(points)), key=lambda i: points[i])

    def chain(indices):
        out = []
        for i in indices:
            while len(out) > 1 and turn(points[out[-2]], points[out[-1]], points[i]) < 0:
                out.pop()
            out.append(i)
        return out[:-1]

    return chain(order) + chain(order[::-1])


def random_points(n, rng):
    chosen = set()
    while len(chosen) < n:
        chosen.add((rng.randrange(WIDTH), rng.randrange(WIDTH)))
    return sorted(chosen, key=lambda p: rng.random())


def ring(loop):
    return [[loop[i], loop[(i + 1) % len(loop)]] for i in range(len(loop))]


def simple_loop(points, rng):
    """A simple polygon through all points: crossings of a random tour are undone, which makes it shorter each time."""
    tour = list(range(len(points)))
    rng.shuffle(tour)
    n = len(tour)
    changed = True
    while changed:
        changed = False
        for i in range(n - 1):
            for j in range(i + 2, n):
                if i == 0 and j == n - 1:
                    continue
                a, b, c, d = (points[tour[k % n]] for k in (i, i + 1, j, j + 1))
                if meet(a, b, c, d):
                    tour[i + 1:j + 1] = tour[i + 1:j + 1][::-1]
                    changed = True
    return tour


def simple(n, rng):
    points = random_points(n, rng)
    return points, ring(simple_loop(points, rng))


def within_hull(points, loop):
    edges = {tuple(sorted(e)) for e in ring(loop)} | {tuple(sorted(e)) for e in ring(hull_of(points))}
    return points, [list(e) for e in sorted(edges)]


def exterior(n, rng):
    points = random_points(n, rng)
    return within_hull(points, simple_loop(points, rng))


def exterior_points(n, rng):
    """One point in five is on no segment of the polygon."""
    points = random_points(n, rng)
    m = max(4, n * 4 // 5)
    return within_hull(points, simple_loop(points[:m], rng))


def corners_of(cells):
    """The loop around a set of cells without holes and without two that touch at a corner only."""
    after = {}
    for x, y in cells:
        for a, b, beyond in (((x, y), (x + 1, y), (x, y - 1)), ((x + 1, y), (x + 1, y + 1), (x + 1, y)),
                             ((x + 1, y + 1), (x, y + 1), (x, y + 1)), ((x, y + 1), (x, y), (x - 1, y))):
            if beyond not in cells:
                if a in after:
                    return None
                after[a] = b
    start = min(after)
    loop, at = [start], after[start]
    while at != start:
        loop.append(at)
        at = after[at]
    if len(loop) != len(after):
        return None
    return [p for i, p in enumerate(loop) if turn(loop[i - 1], p, loop[(i + 1) % len(loop)]) != 0]


def orthogonal(n, rng):
    """Cells are added at random until the loop has enough corners; rows and columns get random widths. Some diagonals
    are constraints."""
    cells, loop = {(0, 0)}, []
    while len(loop) < n:
        x, y = rng.choice(sorted(cells))
        new = (x + rng.choice((-1, 0, 1)), y) if rng.random() < 0.5 else (x, y + rng.choice((-1, 1)))
        grown = corners_of(cells | {new})
        if grown is not None and len(grown) <= n:
            cells, loop = cells | {new}, grown
    xs, ys = sorted({p[0] for p in loop}), sorted({p[1] for p in loop})
    place_x = dict(zip(xs, sorted(rng.sample(range(WIDTH), len(xs)))))
    place_y = dict(zip(ys, sorted(rng.sample(range(WIDTH), len(ys)))))
    points = [(place_x[x], place_y[y]) for x, y in loop]
    segments = ring(list(range(len(points))))
    for _ in range(20 * n):
        if len(segments) >= n + n // 10:
            break
        i, j = sorted(rng.sample(range(n), 2))
        a, b = points[i], points[j]
        apart = [s for s in segments if i not in s and j not in s]
        beside = [p for s in segments for p in (points[s[0]], points[s[1]]) if p not in (a, b)]
        if [i, j] in segments or [j, i] in segments or any(meet(a, b, points[s[0]], points[s[1]]) for s in apart):
            continue
        if any(turn(a, b, p) == 0 and lies_between(a, b, p) for p in beside) or not inside(points, a, b):
            continue
        segments.append([i, j])
    return points, segments


def inside(loop, a, b):
    """Whether the middle of ab lies inside of the loop."""
    x, y = (a[0] + b[0]) / 2, (a[1] + b[1]) / 2
    odd = False
    for i, p in enumerate(loop):
        q = loop[i - 1]
        if (p[1] > y) != (q[1] > y) and x < p[0] + (q[0] - p[0]) * (y - p[1]) / (q[1] - p[1]):
            odd = not odd
    return odd


def points(n, rng):
    chosen = random_points(n, rng)
    return chosen, ring(hull_of(chosen))


def make(kind, size, seed):
    found, segments = globals()[kind](size, random.Random(f"{kind} {size} {seed}"))
    return {"points": [[float(x), float(y)] for x, y in found], "segments": segments}


def main():
    if sys.argv[1] == "list":
        for kind in KINDS:
            for size in SIZES:
                print(kind, size)
        return
    seed = sys.argv[3] if len(sys.argv) > 3 else 0
    json.dump(make(sys.argv[1], int(sys.argv[2]), int(seed)), sys.stdout)


if __name__ == "__main__":
    main()
