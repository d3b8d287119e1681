#!/usr/bin/env python3
"""stacks.py FIRST COUNT FOLDER: random stacks of layers as devices have them, FOLDER/stack_SEED.json.

Two to four layers of 5 nm to 3 um, up to a thousand times as wide as thick; in them, up to three trapezoids and discs of
few chords, which are painted over what is below.
"""
import json
import pathlib
import random
import sys


def ring(*corners):
    return [list(map(list, corners))]


def layers(rng, width):
    """The layers from below, and the height of all of them."""
    found, y = [], 0.0
    for k in range(rng.randint(2, 4)):
        top = round(y + rng.choice([0.005, 0.02, 0.1, 1, 3]), 6)
        found.append({'material': f'layer_{k % 3}', 'region': f'layer_{k}',
                      'rings': ring((0, y), (width, y), (width, top), (0, top))})
        y = top
    return found, y


def inclusion(rng, k, width, height):
    digits = rng.choice([2, 3, 4])
    x, w = round(rng.uniform(0, 0.7 * width), digits), round(rng.uniform(0.05, 0.3) * width, digits)
    y = round(rng.uniform(0, 0.8 * height), digits)
    h = round(rng.uniform(0.1, 0.5) * height, digits) + 0.001
    if k % 2 == 0:
        inset = round(rng.uniform(0, 0.3) * w, digits)
        shape = ring((x, y), (x + w, y), (x + w - inset, y + h), (x + inset, y + h))
    else:
        shape = [[{'circle': {'centre': [x + w / 2, y + h / 2], 'radius': min(w, h) / 2.2,
                              'chords': rng.choice([8, 16, 24])}}]]
    return {'material': 'inclusion', 'region': f'inclusion_{k}', 'rings': shape}


def stack(seed):
    rng = random.Random(seed)
    width = rng.choice([1, 2, 10, 40])
    polygons, height = layers(rng, width)
    polygons += [inclusion(rng, k, width, height) for k in range(rng.randint(1, 3))]
    return {'unit': 'um', 'polygons': polygons, 'lines': [{'name': 'bottom', 'points': [[0, 0], [width, 0]]}]}


def main(first, count, folder):
    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    for seed in range(int(first), int(first) + int(count)):
        pathlib.Path(folder, f'stack_{seed}.json').write_text(json.dumps(stack(seed)))


if __name__ == '__main__':
    main(*sys.argv[1:])
