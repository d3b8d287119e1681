#!/usr/bin/env python3
"""Writes the sample devices of samples/data as Triangle's .poly.

A device is a set of lines (straight or round), a size field that says how long segments are wished to be
at a place, region seeds with materials, and boundary markers for contacts. Every line is cut once,
however many regions it bounds, so that the pieces fit together point by point.
"""
import math
import os
import sys


class Device:
    def __init__(self, name, about, size):
        self.name, self.about, self.size = name, about, size
        self.points, self.index, self.segments = [], {}, {}
        self.holes, self.seeds = [], []

    def point(self, p):
        if p not in self.index:
            self.index[p] = len(self.points)
            self.points.append(p)
        return self.index[p]

    def curve(self, at, length, start, end, marker=0):
        """Cuts the curve at(0..1) so that each piece has the same share of the integral of ds / size."""
        steps = 2000
        total, shares = 0.0, [0.0]
        for i in range(steps):
            total += length / steps / self.size(*at((i + 0.5) / steps))
            shares.append(total)
        pieces = max(1, round(total))
        chain, i = [start], 0
        for k in range(1, pieces):
            while shares[i + 1] < total * k / pieces:
                i += 1
            t = (i + (total * k / pieces - shares[i]) / (shares[i + 1] - shares[i])) / steps
            chain.append(tuple(float('%.12g' % c) for c in at(t)))
        chain.append(end)
        for p, q in zip(chain, chain[1:]):
            self.segments[(self.point(p), self.point(q))] = marker

    def line(self, a, b, marker=0):
        self.curve(lambda t: (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])), math.dist(a, b), a, b, marker)

    def path(self, *corners, marker=0):
        for a, b in zip(corners, corners[1:]):
            self.line(a, b, marker)

    def arc(self, centre, radius, degrees_a, degrees_b, start, end, marker=0):
        """A round line between given end points, so that it meets its neighbours bit for bit."""
        a, b = math.radians(degrees_a), math.radians(degrees_b)

        def at(t):
            w = a + t * (b - a)
            return (centre[0] + radius * math.cos(w), centre[1] + radius * math.sin(w))
        self.curve(at, radius * abs(b - a), start, end, marker)

    def circle(self, centre, radius):
        east, west = (centre[0] + radius, centre[1]), (centre[0] - radius, centre[1])
        self.arc(centre, radius, 0, 180, east, west)
        self.arc(centre, radius, 180, 360, west, east)

    def region(self, x, y, material):
        self.seeds.append((x, y, material))

    def write(self, folder):
        with open(os.path.join(folder, self.name + '.poly'), 'w') as f:
            for line in self.about.strip().splitlines():
                f.write('# ' + line.strip() + '\n')
            f.write('%d 2 0 0\n' % len(self.points))
            for i, (x, y) in enumerate(self.points, 1):
                f.write('%d %r %r\n' % (i, float(x), float(y)))
            f.write('%d 1\n' % len(self.segments))
            for i, ((a, b), marker) in enumerate(self.segments.items(), 1):
                f.write('%d %d %d %d\n' % (i, a + 1, b + 1, marker))
            f.write('%d\n' % len(self.holes))
            for i, (x, y) in enumerate(self.holes, 1):
                f.write('%d %r %r\n' % (i, float(x), float(y)))
            f.write('%d\n' % len(self.seeds))
            for i, (x, y, material) in enumerate(self.seeds, 1):
                f.write('%d %r %r %d -1\n' % (i, float(x), float(y), material))


def distance_to_box(x, y, x0, x1, y0, y1):
    return math.hypot(max(x0 - x, x - x1, 0), max(y0 - y, y - y1, 0))


def mosfet():
    """Cross-section with a gate oxide of 1.2 nm on a substrate of 1 um."""
    gate, spacer, tox, top = 40, 70, 1.2, 90
    d = Device('mosfet', """MOSFET cross-section, lengths in nm: gate oxide of 1.2 nm on a substrate 1 um wide.
        materials: 1 p-silicon, 2 n+ silicon, 3 oxide, 4 polysilicon, 5 nitride
        markers:   11 source, 12 drain, 13 gate, 14 body""",
        lambda x, y: min(40, 1.4 + 0.16 * distance_to_box(x, y, -gate, gate, 0, tox)))
    left, right, bottom, trench = -500, 500, -420, -380
    junction, reach, bend = -60, 28, 22  # depth, inner end, and corner radius of the wells
    d.path((left, -150), (left, bottom), (right, bottom), (right, -150), marker=0)
    for (a, b) in [k for k in d.segments if d.points[k[0]][1] == bottom == d.points[k[1]][1]]:
        d.segments[(a, b)] = 14
    for s in (-1, 1):
        contact = 11 if s < 0 else 12
        # field oxide
        d.path((s * 500, -150), (s * 500, 0), (s * -trench, 0))
        d.path((s * -trench, 0), (s * -trench, junction), (s * -trench, -150), (s * 500, -150))
        # surface from the trench to the middle
        d.path((s * -trench, 0), (s * 300, 0))
        d.path((s * 300, 0), (s * 150, 0), marker=contact)
        d.path((s * 150, 0), (s * spacer, 0), (s * gate, 0), (s * reach, 0))
        # the well
        d.path((s * -trench, junction), (s * (reach + bend), junction))
        d.arc((s * (reach + bend), junction + bend), bend, 270, 270 - s * 90,
              (s * (reach + bend), junction), (s * reach, junction + bend))
        d.path((s * reach, junction + bend), (s * reach, 0))
        # spacer, oxide and gate sides
        d.path((s * gate, 0), (s * gate, tox), (s * gate, top))
        d.path((s * spacer, 0), (s * spacer, top - 25))
        d.arc((s * (spacer - 25), top - 25), 25, 0 if s > 0 else 180, 90,
              (s * spacer, top - 25), (s * (spacer - 25), top))
        d.path((s * (spacer - 25), top), (s * gate, top))
        d.region(s * 440, -75, 3)
        d.region(s * 200, -30, 2)
        d.region(s * 55, 40, 5)
    d.path((-reach, 0), (reach, 0))
    d.path((-gate, tox), (gate, tox))
    d.path((-gate, top), (gate, top), marker=13)
    d.region(0, -200, 1)
    d.region(0, tox / 2, 3)
    d.region(0, 50, 4)
    return d


def diode():
    """A planar p-n diode with contacts."""
    d = Device('diode', """Planar p-n diode, lengths in um.
        materials: 1 n-silicon, 2 p+ silicon, 3 oxide
        markers:   1 anode, 2 cathode""",
        lambda x, y: min(0.8, 0.12 + 0.25 * abs(math.hypot(max(abs(x) - 2, 0), y) - 1)))
    d.line((-6, -5), (6, -5), marker=2)
    for s in (-1, 1):
        d.path((s * 6, -5), (s * 6, 0), (s * 6, 0.4), (s * 2, 0.4), (s * 2, 0))
        d.path((s * 6, 0), (s * 3, 0), (s * 2, 0))
        d.arc((s * 2, 0), 1, 0 if s > 0 else 180, 270 if s < 0 else -90, (s * 3, 0), (s * 2, -1))
        d.region(s * 4, 0.2, 3)
    d.line((-2, -1), (2, -1))
    d.line((-2, 0), (2, 0), marker=1)
    d.region(0, -3, 1)
    d.region(0, -0.5, 2)
    return d


def coax():
    """A coaxial cable with gas bubbles in the dielectric."""
    d = Device('coax', """Coaxial cable with bubbles in the dielectric, lengths in mm.
        materials: 1 copper, 2 foam, 3 gas, 4 jacket""",
        lambda x, y: min(0.1, 0.04 + 0.04 * abs(math.hypot(x, y) - 1.15)))
    for radius in (0.5, 1.75, 1.95, 2.6):
        d.circle((0.0, 0.0), radius)
    d.region(0, 0, 1)
    d.region(0, 0.6, 2)
    d.region(0, 1.85, 1)
    d.region(0, 2.3, 4)
    for k in range(9):
        ring, turn = (0.95, 0.2) if k % 2 else (1.35, 0)
        angle = 2 * math.pi * k / 9 + turn
        centre = (float('%.6g' % (ring * math.cos(angle))), float('%.6g' % (ring * math.sin(angle))))
        d.circle(centre, 0.1 + 0.02 * (k % 4))
        d.region(*centre, 3)
    return d


def waveguide():
    """A silicon rib waveguide."""
    d = Device('waveguide', """Silicon rib waveguide on oxide, lengths in um.
        materials: 1 silicon substrate, 2 buried oxide, 3 silicon core, 4 oxide cladding, 5 air""",
        lambda x, y: min(0.4, 0.02 + 0.2 * distance_to_box(x, y, -0.25, 0.25, 0, 0.22)))
    levels = (-3, -2, 0, 0.07, 1.2, 2)
    for s in (-1, 1):
        d.path(*[(s * 3, y) for y in levels])
        d.path((s * 3, 0.07), (s * 0.25, 0.07), (s * 0.24, 0.22))
    for y in (-3, -2, 0, 1.2, 2):
        d.line((-3, y), (3, y))
    d.line((-0.24, 0.22), (0.24, 0.22))
    for y, material in ((-2.5, 1), (-1, 2), (0.1, 3), (0.7, 4), (1.6, 5)):
        d.region(0, y, material)
    return d


def motor_slot():
    """A stator slot with round wires and a cooling duct."""
    d = Device('motor_slot', """Stator slot with round wires; the cooling duct is a hole; lengths in mm.
        materials: 1 iron, 2 liner, 3 resin, 4 copper, 5 air gap
        markers:   1 air gap, 2 outside""",
        lambda x, y: min(0.9, 0.2 + 0.12 * distance_to_box(x, y, -3, 3, 2, 14)))
    mouth, low, high = 1.0, 3.2, 4.2
    d.path((-8, 0), (-8, 22), (8, 22), (8, 0), marker=2)
    d.path((-8, 0), (-8, -0.8))
    d.path((-8, -0.8), (8, -0.8), marker=1)
    d.path((8, -0.8), (8, 0), (mouth, 0), (mouth, 1.2), (low, 2.4), (high, 15), (-high, 15), (-low, 2.4),
           (-mouth, 1.2), (-mouth, 0), (-8, 0))
    d.line((-mouth, 1.2), (mouth, 1.2))
    d.line((-mouth, 0), (mouth, 0))
    d.path((-2.8, 2.75), (2.8, 2.75), (3.8, 14.6), (-3.8, 14.6), (-2.8, 2.75))
    d.circle((0, 18.5), 1.4)
    d.holes.append((0, 18.5))
    for row in range(7):
        for column in range(4):
            x, y = (column - 1.5) * 1.4, 3.8 + 1.55 * row
            centre = (float('%.6g' % x), float('%.6g' % y))
            d.circle(centre, 0.6)
            d.region(*centre, 4)
    d.region(-7, 10, 1)
    d.region(0, 2.0, 2)
    d.region(0, 3.0, 3)
    d.region(0, 0.6, 5)
    d.region(0, -0.4, 5)
    return d


if __name__ == '__main__':
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), 'data')
    for make in (mosfet, diode, coax, waveguide, motor_slot):
        make().write(folder)
