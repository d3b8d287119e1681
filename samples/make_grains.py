#!/usr/bin/env python3
"""make_grains.py FILE [SIZE] [GRAINS]: a picture of a polycrystal: Voronoi cells, each of a colour of its own, as a PNG
(own data, without any library). samples/data/grains.png is make_grains.py grains.png 512 1000."""
import random
import struct
import sys
import zlib


def colour(grain):
    """Of up to 1,728 grains each has its own."""
    return bytes(35 + 20 * (grain // 12**k % 12) for k in range(3))


def grains(size, count, seed=1):
    """The colours of the pixels, by row."""
    rand = random.Random(seed)
    cell = size / max(1, int(count**0.5))
    n = int(size / cell) + 1
    boxes = {}
    for k in range(count):
        x, y = rand.uniform(0, size), rand.uniform(0, size)
        boxes.setdefault((int(x / cell), int(y / cell)), []).append((x, y, k))
    rows = []
    for j in range(size):
        row = bytearray()
        near = None
        for i in range(size):
            box = (int(i / cell), int(j / cell))
            if near is None or box != near[0]:
                reach = 2
                near = (box, [p for u in range(-reach, reach + 1) for v in range(-reach, reach + 1)
                              for p in boxes.get((box[0] + u, box[1] + v), ())] or
                        [p for b in boxes.values() for p in b])
            x, y = i + 0.5, j + 0.5
            row += colour(min(near[1], key=lambda p: (p[0] - x)**2 + (p[1] - y)**2)[2])
        rows.append(bytes(row))
    return rows


def write_png(path, rows):
    def chunk(kind, content):
        return struct.pack('>I', len(content)) + kind + content + struct.pack('>I', zlib.crc32(kind + content))
    header = struct.pack('>IIBBBBB', len(rows[0]) // 3, len(rows), 8, 2, 0, 0, 0)
    with open(path, 'wb') as f:
        f.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', header) + chunk(b'IDAT', zlib.compress(b''.join(b'\0' + row for row in rows), 9)) + chunk(b'IEND', b''))


if __name__ == '__main__':
    size, count = (int(w) for w in (sys.argv[2:] + ['512', '1000'][len(sys.argv) - 2:])[:2])
    write_png(sys.argv[1], grains(size, count))
