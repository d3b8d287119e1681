#!/usr/bin/env python3
"""rectangles.py N [substrate] > layout.gds: N rectangles of three layers, no two of which touch, as a flat layout in GDSII.

Each has a cell of 1 by 1 um of its own and sides of 0.2 to 0.8 um by chance, on a grid of 1 nm. With `substrate` a fourth layer
lies under all of them: one region with N holes. Same numbers, same bytes.
"""
import math
import random
import struct
import sys

STRING, INT2, INT4 = 0x06, 0x02, 0x03


def record(kind, of=0, payload=b""):
    return struct.pack(">HBB", 4 + len(payload), kind, of) + payload


def real8(value):
    """GDSII's floating point number: excess 64, base 16."""
    exponent = 0
    while value >= 1:
        value, exponent = value / 16, exponent + 1
    while value < 1 / 16:
        value, exponent = value * 16, exponent - 1
    return struct.pack(">Q", (64 + exponent) << 56 | round(value * 2**56))


def name(text):
    return text.encode() + b"\0" * (len(text) % 2)


def box(layer, x0, y0, x1, y1):
    return (record(0x08) + record(0x0D, INT2, struct.pack(">h", layer)) + record(0x0E, INT2, struct.pack(">h", 0)) +
            record(0x10, INT4, struct.pack(">10i", x0, y0, x1, y0, x1, y1, x0, y1, x0, y0)) + record(0x11))


def main():
    count = int(sys.argv[1])
    side = math.ceil(math.sqrt(count))
    chance = random.Random(count)
    out = sys.stdout.buffer
    date = struct.pack(">12h", *(2026, 1, 1, 0, 0, 0) * 2)
    out.write(record(0x00, INT2, struct.pack(">h", 600)) + record(0x01, INT2, date) + record(0x02, STRING, name("CHIP")) +
              record(0x03, 0x05, real8(1e-3) + real8(1e-9)) + record(0x05, INT2, date) + record(0x06, STRING, name("TOP")))
    if sys.argv[2:] == ["substrate"]:
        out.write(box(0, 0, 0, 1000 * side, 1000 * side))
    for k in range(count):
        x, y = 1000 * (k % side), 1000 * (k // side)
        w, h = chance.randint(200, 800), chance.randint(200, 800)
        left, low = x + chance.randint(50, 950 - w), y + chance.randint(50, 950 - h)
        out.write(box(1 + k % 3, left, low, left + w, low + h))
    out.write(record(0x07) + record(0x04))


if __name__ == "__main__":
    main()
