#!/usr/bin/env python3
"""make_layouts.py [FOLDER]: writes the layout and the drawing of samples/data, finfet.gds and motor.dxf."""
import math
import pathlib
import struct
import sys


class Layout:
    """A GDSII file, record by record; lengths in units of the database, of which there are 10,000 in a micrometre."""

    def __init__(self):
        self.bytes = b''
        self.shorts(0x00, 600).shorts(0x01, *[0] * 12).text(0x02, 'SAMPLES').record(0x03, 5, self.real(1e-4) + self.real(1e-10))

    def record(self, kind, form, data=b''):
        self.bytes += struct.pack('>HBB', len(data) + 4, kind, form) + data
        return self

    def shorts(self, kind, *values):
        return self.record(kind, 2, struct.pack(f'>{len(values)}h', *values))

    def text(self, kind, words):
        return self.record(kind, 6, words.encode() + b'\0' * (len(words) % 2))

    def points(self, points):
        return self.record(0x10, 3, b''.join(struct.pack('>2i', *p) for p in points))

    @staticmethod
    def real(value):
        exponent = 64
        while value < 1 / 16:
            value, exponent = value * 16, exponent - 1
        return struct.pack('>Q', exponent << 56 | int(value * (1 << 56)))

    def begin(self, cell):
        return self.shorts(0x05, *[0] * 12).text(0x06, cell)

    def end(self):
        return self.record(0x07, 0)

    def polygon(self, layer, *points):
        return self.record(0x08, 0).shorts(0x0d, layer).shorts(0x0e, 0).points([*points, points[0]]).record(0x11, 0)

    def box(self, layer, x0, y0, x1, y1):
        return self.polygon(layer, (x0, y0), (x1, y0), (x1, y1), (x0, y1))

    def line(self, layer, *points):
        return self.record(0x09, 0).shorts(0x0d, layer).shorts(0x0e, 0).points(points).record(0x11, 0)

    def array(self, cell, columns, step):
        self.record(0x0b, 0).text(0x12, cell).shorts(0x13, columns, 1)
        return self.points([(0, 0), (columns * step, 0), (0, 1)]).record(0x11, 0)


def finfet():
    """Two fins side by side, cut across: lengths in tenths of a nanometre."""
    layout = Layout()
    layout.begin('FIN').polygon(3, (-60, 0), (60, 0), (40, 620), (-40, 620))
    for layer, thick in (4, 8), (5, 28):  # oxide, and hafnium oxide around it
        layout.polygon(layer, (-54 - thick, 200), (54 + thick, 200), (40 + thick, 620 + thick), (-40 - thick, 620 + thick))
    layout.end().begin('DEVICE')
    layout.box(1, -300, -600, 600, 0).box(2, -300, 0, 600, 200).box(5, -300, 200, 600, 228).box(6, -300, 200, 600, 900)
    layout.line(10, (-300, 900), (600, 900)).line(11, (-300, -600), (600, -600))
    layout.array('FIN', 2, 300).end()
    return layout.record(0x04, 0).bytes


def motor():
    """A motor of six slots: the slot is a block, inserted six times."""
    out = []

    def put(*groups):
        out.extend(f'{code}\n{value}' for code, value in groups)

    def entity(kind, layer, **numbers):
        put((0, kind), (8, layer), *((int(code[1:]), value) for code, value in numbers.items()))

    put((0, 'SECTION'), (2, 'HEADER'), (9, '$INSUNITS'), (70, 4), (0, 'ENDSEC'))
    put((0, 'SECTION'), (2, 'BLOCKS'), (0, 'BLOCK'), (8, '0'), (2, 'slot'), (70, 0), (10, 0), (20, 0))
    # Around the x axis, from the bore outwards; its bottom is round.
    put((0, 'LWPOLYLINE'), (8, '0'), (90, 4), (70, 1))
    for radius, angle in (28, -7), (40, -12), (40, 12), (28, 7):
        put((10, radius * math.cos(math.radians(angle))), (20, radius * math.sin(math.radians(angle))))
        if angle == -12:
            put((42, math.tan(math.radians(24) / 4)))
    put((0, 'ENDBLK'), (8, '0'), (0, 'ENDSEC'))
    put((0, 'SECTION'), (2, 'ENTITIES'))
    entity('CIRCLE', 'frame', _10=0, _20=0, _40=50)
    for radius in (26, 25, 8):  # bore, rotor, shaft
        entity('CIRCLE', '0', _10=0, _20=0, _40=radius)
    for k, coil in enumerate(('A+', 'C-', 'B+', 'A-', 'C+', 'B-')):
        put((0, 'INSERT'), (8, '0'), (2, 'slot'), (10, 0), (20, 0), (50, 60 * k))
        put((0, 'TEXT'), (8, 'labels'), (10, 34 * math.cos(math.pi / 3 * k)), (20, 34 * math.sin(math.pi / 3 * k)), (40, 2),
            (1, f'copper/{coil}'))
    for words, x in ('steel/stator', 46), ('air/gap', 25.5), ('steel/rotor', 16), ('void', 0):
        put((0, 'TEXT'), (8, 'labels'), (10, 0), (20, x), (40, 2), (1, words))
    put((0, 'ENDSEC'), (0, 'EOF'))
    return '\n'.join(out) + '\n'


if __name__ == '__main__':
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent / 'data')
    (folder / 'finfet.gds').write_bytes(finfet())
    (folder / 'motor.dxf').write_text(motor())
