"""What the module makes of values of all kinds: numbers that are no doubles, masks, names of files that are no text,
and what goes wrong while numpy looks at them."""
import fractions
import os
import pathlib
import pickle
import tempfile
import unittest

import numpy as np

import cover

SQUARE = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], dtype=float)
RING = np.array([[0, 1], [1, 2], [2, 3], [3, 0]])
LARGE = 2**53
WIDE = [(0, 0), (LARGE + 1, 0), (0, LARGE)]


class Whole(unittest.TestCase):
    """Whole numbers that no double is."""

    def refused(self, call, *words):
        with self.assertRaisesRegex(ValueError, '.*'.join((*words, 'above 2\\^53 are rounded'))):
            call()

    def test_points(self):
        ring = RING[:3] % 3
        for points in (np.array(WIDE), np.array(WIDE, dtype=np.uint64), np.array(WIDE, dtype=object), WIDE,
                       [(0, 0.5), *WIDE[1:]], [(0, 0), (10**400, 0), (0, 1)], [(0, 0), (2**64 + 1, 0), (0, 1)],
                       np.array(WIDE, dtype=np.int64) * 8 + 1):
            with self.subTest(repr(points)):
                self.refused(lambda points=points: cover.mesh(points, ring), 'points: no double is ')

    def test_those_that_are_doubles_are_taken(self):
        ring = RING[:3] % 3
        for points in (np.array(WIDE, dtype=np.int64) // 2 * 2, [(0, 0), (2**70, 0), (0, 2**70)], np.array(WIDE, float),
                       [(0, 0), (1e20, 0), (0, 1e20)], [(0, 0), (fractions.Fraction(1, 2), 0), (0, 1)]):
            with self.subTest(repr(points)):
                mesh = cover.mesh(points, ring)
                self.assertEqual({tuple(p) for p in mesh.points.tolist()}, {tuple(map(float, p)) for p in points})

    def test_seeds_and_holes(self):
        self.refused(lambda: cover.mesh(SQUARE, RING, [(LARGE + 1, 0.5, 'Si')]), 'a region: no double is 9007199254740993')
        self.refused(lambda: cover.mesh(SQUARE, RING, holes=[(LARGE + 1, 0)]), 'holes: no double is ')

    def test_polygons(self):
        self.refused(lambda: cover.mesh_polygons([('Si', [WIDE])]), 'polygon 0: ring 0: no double is ')
        self.refused(lambda: cover.mesh_polygons([('Si', [WIDE])], unit='um'), 'polygon 0: no double is ')
        self.refused(lambda: cover.mesh_polygons([('Si', [[(0, 0), (1, 0), (0, 1)]])], lines={'a': [(0, 0), (10**400, 0)]}),
                     "the line 'a': no double is ")


class Masked(unittest.TestCase):
    """Behind a mask stands a number that is not meant."""
    POINTS = np.ma.masked_array(SQUARE, mask=[[0, 0], [0, 0], [1, 0], [0, 0]])
    INDICES = np.ma.masked_array(RING, mask=[[0, 0], [0, 0], [0, 1], [0, 0]])

    def refused(self, call, what):
        with self.assertRaisesRegex(ValueError, f'{what}: a value is masked'):
            call()

    def test_is_refused(self):
        rows = [np.ma.masked_array(p, mask=m) for p, m in zip(SQUARE, self.POINTS.mask, strict=True)]
        for points in self.POINTS, rows, tuple(rows), [(0, 0), (1, np.ma.masked), (0, 1)]:
            self.refused(lambda points=points: cover.mesh(points, RING), 'points')
        self.refused(lambda: cover.mesh(SQUARE, self.INDICES), 'segments')
        self.refused(lambda: cover.mesh(SQUARE, RING, holes=self.POINTS[2:]), 'holes')
        self.refused(lambda: cover.mesh(SQUARE, RING, [(np.ma.masked, 0.5, 'Si')]), 'a region')
        self.refused(lambda: cover.mesh(SQUARE, RING, lines={'a': np.ma.masked_array([1, 2], mask=[1, 0])}), 'lines')
        self.refused(lambda: cover.mesh_polygons([('Si', [self.POINTS])]), 'polygon 0: ring 0')
        self.refused(lambda: cover.mesh_polygons([('Si', [self.POINTS])], unit='um'), 'polygon 0')
        self.refused(lambda: cover.mesh(SQUARE, RING, size=np.ma.masked), 'an option')

    def test_without_a_masked_value_it_is_an_array(self):
        points, indices = np.ma.masked_array(SQUARE), np.ma.masked_array(RING, mask=np.zeros((4, 2), bool))
        self.assertEqual(len(cover.mesh(points, indices).triangles), 2)
        self.assertEqual(len(cover.mesh_polygons([('Si', [points])], unit='um').triangles), 2)


class Raising:
    """Something whose conversion raises."""

    def __init__(self, error):
        self.error = error

    def raise_it(self, *_, **__):
        raise self.error

    __array__ = __float__ = raise_it


class Conversions(unittest.TestCase):
    def test_what_is_no_fault_of_the_value_comes_out(self):
        for error in MemoryError('mine'), KeyboardInterrupt('mine'), SystemExit(3):
            for call in (lambda value: cover.mesh(value, RING), lambda value: cover.mesh(SQUARE, value),
                         lambda value: cover.mesh(SQUARE, RING, [(value, 0.5, 'Si')]),
                         lambda value: cover.mesh(SQUARE, RING, lines={'a': value})):
                with self.assertRaises(type(error)) as caught:
                    call(Raising(error))
                self.assertIs(caught.exception, error)

    def test_the_rest_is_the_cause(self):
        error = RuntimeError('no array today')
        for call in (lambda: cover.mesh(Raising(error), RING), lambda: cover.mesh(SQUARE, Raising(error)),
                     lambda: cover.mesh(SQUARE, RING, [(Raising(error), 0.5, 'Si')])):
            with self.assertRaisesRegex(TypeError, 'must be|no coordinate') as caught:
                call()
            self.assertIs(caught.exception.__cause__, error)
        with self.assertRaisesRegex(TypeError, 'points must be numbers of the shape') as caught:
            cover.mesh([(0, 0), (1, 'x'), (0, 1)], RING)
        self.assertIsInstance(caught.exception.__cause__, ValueError)

    def test_an_answer_that_is_neither_true_nor_false(self):
        with self.assertRaisesRegex(ValueError, 'truth value'):
            cover.mesh(SQUARE, RING, size=0.1, progress=lambda *_: np.array([1, 2]))


class Mistakes(unittest.TestCase):
    """Errors name the element that they are about."""

    def refused(self, kind, words, *polygons, **more):
        with self.assertRaisesRegex(kind, words) as caught:
            cover.mesh_polygons(list(polygons), **more)
        return caught.exception

    def test_elements_of_polygons(self):
        good, top = ('Si', [SQUARE]), {'top': SQUARE[:2]}
        self.refused(ValueError, r'^polygon 1: ring 0 must have the shape', good, ('Cu', SQUARE))
        self.refused(TypeError, r'^polygon 1: 0 is no point', good, ('Cu', [(0, 0), (1, 0)]), lines=top)
        self.refused(ValueError, r"^polygon 1: 'x' is no coordinate", good, ('Cu', [[(0, 'x'), (1, 0)]]), lines=top)
        self.refused(TypeError, r'^holes: 1 is no point', good, holes=(1, .5))
        self.refused(ValueError, r'^polygon 1: a curve, a size or a priority is not', good,
                     {'material': 'Cu', 'rings': [SQUARE], 'size': float('nan')})
        self.refused(cover.Error, 'null says nothing here: give a value, or', {'material': None, 'rings': [SQUARE]})
        self.refused(ValueError, r'^chord_error is not', good, lines=top, chord_error=float('inf'))
        for paths in None, (point for point in SQUARE), 5:
            self.refused(TypeError, r"^lines: 'top' must be a list of points", good, lines={'top': paths})
        self.refused(TypeError, r"^lines: 'top' must be .*, and begins with 0$", good, lines={'top': [0, 0, 1, 0]})

    def test_inputs_of_an_error(self):
        self.assertEqual(cover.Error.inputs, ())
        error = self.refused(cover.Error, 'overlap', ('Si', [SQUARE]), ('Cu', [SQUARE]), overlap='error')
        self.assertEqual(error.inputs, [('polygon', 0), ('polygon', 1)])

    def test_size_fields_that_are_none(self):
        for field in np.ones((2, 3)), .1, ['a.csv'], b'a.csv':
            with self.assertRaisesRegex(cover.OptionError, r'^size_field: [^:]* is neither a function of x and y nor the path'):
                cover.mesh(SQUARE, RING, size_field=field)
        with self.assertRaisesRegex(cover.OptionError, 'size_of is of the values of a file'):
            cover.mesh(SQUARE, RING, size_field=lambda x, y: .1, size_of='z')

    def test_options_that_count_with_a_size_function(self):
        mesh = cover.mesh(SQUARE, RING, size_field=lambda x, y: .01, min_size=.3)
        self.assertFalse([note for note in mesh.notes if 'does nothing' in note])
        self.assertTrue([note for note in cover.mesh(SQUARE, RING, min_size=.3).notes if 'does nothing' in note])

    def test_kinds_of_numbers(self):
        ring = np.array(RING).astype(object)
        self.assertEqual(len(cover.mesh(SQUARE, ring, lines={'a': np.array([0], object)}).lines['a']), 1)
        for wrong in 1.5, None, 'x':
            ring[0, 1] = wrong
            with self.assertRaises((TypeError, ValueError)):
                cover.mesh(SQUARE, ring)
        for kind in 'M8[s]', 'm8[s]':
            with self.assertRaisesRegex(TypeError, 'points must be numbers'):
                cover.mesh(np.array(SQUARE).astype(int).astype(kind), RING)

    def test_layers_of_lines_with_signs_in_their_names(self):
        for name, key in ('a=b', 'a=b'), ('a@b', '"a@b"'), ('a=b', '"a=b"'), ('a=b', 'a=b@Si'):
            mesh = cover.mesh(SQUARE, RING, [(.5, .4, 'Si')], lines={name: [0]}, layers={key: (.01, 1.5, 3)},
                              split_interfaces=90)
            self.assertGreater(len(mesh.triangles), 4)


class Names(unittest.TestCase):
    """Names of files are bytes, and need not be text."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        cover.mesh(SQUARE, RING).save(b'\xfc.poly')

    def test_in_and_out(self):
        for name in b'\xfc.poly', '\udcfc.poly', pathlib.Path('\udcfc.poly'):
            mesh = cover.mesh_file(name)
            for again in mesh, pickle.loads(pickle.dumps(mesh)):
                again.save(b'\xfd.vtu')
                again.save('\udcfe.vtkhdf')
                again.save(pathlib.Path('\udcff.json'))
        for name in '\udcfd.vtu', b'\xfe.vtkhdf':
            self.assertEqual(len(cover.read(name).triangles), 2)
            pickle.loads(pickle.dumps(cover.read(name)))
        self.assertEqual(sorted(os.listdir(b'.')), [b'\xfc.poly', b'\xfd.vtu', b'\xfe.vtkhdf', b'\xff.json'])

    def test_options_that_are_files(self):
        pathlib.Path('\udcfa.csv').write_text('x,y,size\n0,0,0.1\n1,0,0.1\n0,1,0.1\n1,1,0.1\n')
        for name in '\udcfa.csv', pathlib.Path('\udcfa.csv'):
            mesh = cover.mesh(SQUARE, RING, size_field=name, split_interfaces=True)
            self.assertGreater(len(mesh.triangles), 50)
            self.assertEqual(pickle.loads(pickle.dumps(mesh)).report, mesh.report)

    def test_words_of_errors(self):
        mesh = cover.mesh(SQUARE, RING)
        for call in (lambda: cover.mesh_file('a\udcfc.poly'), lambda: cover.mesh_file(b'a\xfc.poly'), lambda: cover.read(b'a\xfc.vtu'),
                     lambda: mesh.save(b'a\xfc/x.vtu'), lambda: mesh.save(b'a\xfc/x.svg'), lambda: mesh.save(b'a\xfc/x.png'),
                     lambda: mesh.save(b'a\xfc'), lambda: mesh.save(b'x.a\xfc'),
                     lambda: cover.mesh(SQUARE, RING, size_field='a\udcfc.csv')):
            with self.assertRaisesRegex(cover.Error, r'a\\xfc') as caught:
                call()
            str(caught.exception).encode()  # so that it can be printed
        with self.assertRaisesRegex(TypeError, 'max_angle: .*ä\\.\\.\\. is not'):
            cover.mesh(SQUARE, RING, max_angle=['ä' * 40, 'x' * 40])


if __name__ == '__main__':
    unittest.main()
