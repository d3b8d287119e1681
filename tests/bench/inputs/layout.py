#!/usr/bin/env python3
"""layout.py N [SEGMENTS] > layout.poly: N x N cells with wavy sides of SEGMENTS (8) segments each, as .poly.

A generated layout for weak scaling: one cell, repeated, with waves that differ from cell to cell so that no two regions
are meshed alike. About 50 triangles to a region. It is written row by row, so that 1000 x 1000 take no memory.
Same numbers, same bytes.
"""
import math
import sys


def wave(i, j, turned):
    """Height of the wave on a side: at most 0.12 of a cell, so that neighbouring sides never meet."""
    return 0.06 * (math.sin(12.9898 * i + 78.233 * j + turned) + math.sin(0.37 * i + 0.91 * j + 2 * turned))


def main():
    n = int(sys.argv[1])
    k = int(sys.argv[2]) if len(sys.argv) > 2 else 8
    out = sys.stdout
    inner = k - 1
    corners = (n + 1) * (n + 1)
    sides = n * (n + 1)
    shape = [math.sin(2 * math.pi * s / k) for s in range(1, k)]
    out.write(f"{corners + 2 * sides * inner} 2 0 0\n")
    for j in range(n + 1):
        out.write("".join(f"{j * (n + 1) + i} {i} {j}\n" for i in range(n + 1)))
    number = corners
    for j in range(n + 1):  # sides from left to right
        lines = []
        for i in range(n):
            height = wave(i, j, 0.0) if 0 < j < n else 0.0
            for s in range(1, k):
                lines.append(f"{number} {i + s / k} {j + height * shape[s - 1]:.9g}\n")
                number += 1
        out.write("".join(lines))
    for j in range(n):  # and upwards
        lines = []
        for i in range(n + 1):
            height = wave(i, j, 1.7) if 0 < i < n else 0.0
            for s in range(1, k):
                lines.append(f"{number} {i + height * shape[s - 1]:.9g} {j + s / k}\n")
                number += 1
        out.write("".join(lines))
    out.write(f"{2 * sides * k} 0\n")
    segment = 0
    first = corners
    for j in range(n + 1):
        lines = []
        for i in range(n):
            at = [j * (n + 1) + i, *range(first, first + inner), j * (n + 1) + i + 1]
            first += inner
            for a, b in zip(at, at[1:]):
                lines.append(f"{segment} {a} {b}\n")
                segment += 1
        out.write("".join(lines))
    for j in range(n):
        lines = []
        for i in range(n + 1):
            at = [j * (n + 1) + i, *range(first, first + inner), (j + 1) * (n + 1) + i]
            first += inner
            for a, b in zip(at, at[1:]):
                lines.append(f"{segment} {a} {b}\n")
                segment += 1
        out.write("".join(lines))
    out.write("0\n")


if __name__ == "__main__":
    main()
