"""What a mesh keeps: its arrays, its notes on options without effect, all figures when it is pickled; and what happens
around files that wait and an interpreter that ends."""
import copy
import json
import os
import pathlib
import pickle
import re
import signal
import subprocess
import sys
import tempfile
import textwrap
import threading
import time
import unittest

import numpy as np

import cover

DATA = pathlib.Path(__file__).parents[2] / 'samples/data'
SQUARE = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], dtype=float)
RING = np.array([[0, 1], [1, 2], [2, 3], [3, 0]])


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.dir = pathlib.Path(folder.name)


class Arrays(Case):
    def test_are_read_only(self):
        mesh = cover.mesh_file(DATA / 'coax_arcs.json')
        arrays = [getattr(mesh, name) for name in ('points', 'triangles', 'region', 'material', 'input_id')]
        arrays += [piece['edges'] for pieces in mesh.lines.values() for piece in pieces]
        arrays += [mesh.arcs['edges'], mesh.arcs['middles']]
        for array in arrays:
            self.assertFalse(array.flags.writeable)
            with self.assertRaisesRegex(ValueError, 'read-only'):
                array[0] = 0
        points = mesh.points.copy()
        points[0] = 7
        self.assertNotEqual(points[0].tolist(), mesh.points[0].tolist())
        self.assertEqual(len(cover.mesh(mesh.points[:3], [(0, 1), (1, 2), (2, 0)]).points), 3)


class Voids(Case):
    def test_stay_when_a_mesh_is_read_or_pickled(self):
        points = np.concatenate([SQUARE * 4, SQUARE * 2 + 1])
        mesh = cover.mesh(points, np.concatenate([RING, RING + 4]), holes=[(2, 2)])
        mesh.save(self.dir / 'a.vtm')
        for name, other in ('read', cover.read(self.dir / 'a.vtm')), ('pickled', pickle.loads(pickle.dumps(mesh))):
            other.save(self.dir / 'clean.poly')
            with self.subTest(name):
                self.assertEqual(len(cover.mesh_file(self.dir / 'clean.poly').regions), 1)


class NamedPoints(Case):
    def test_survive_files_and_pickling(self):
        corners = [[0, 0], [9, 0], [9, 9], [0, 9]]
        def feature(kind, coordinates, name):
            return {'type': 'Feature', 'properties': {'name': name}, 'geometry': {'type': kind, 'coordinates': coordinates}}
        wells = [('probe ö', [4, 3]), ('well', [2, 2]), ('well', [6, 5])]
        (self.dir / 'map.geojson').write_text(json.dumps({'type': 'FeatureCollection', 'features': [
            feature('Polygon', [[*corners, corners[0]]], 'field'), *(feature('Point', at, name) for name, at in wells)]}))
        mesh = cover.mesh_file(self.dir / 'map.geojson')
        mesh.save(self.dir / 'a.vtm')
        for other in mesh, cover.read(self.dir / 'a.vtm'), pickle.loads(pickle.dumps(mesh)):
            self.assertEqual([(name, other.points[k].tolist()) for name, points in other.named_points.items() for k in points], wells)
            self.assertEqual(other.named_points['well'].dtype, np.int64)
            self.assertFalse(other.named_points['well'].flags.writeable)
        self.assertEqual(cover.mesh(SQUARE, RING).named_points, {})


class Notes(Case):
    def test_options_of_reading_without_effect(self):
        mesh = cover.mesh_file(DATA / 'mosfet.poly', layer='metal', speckle=4, scale=2, crs=None, no_smooth=False)
        for words in ('layer does nothing: it counts with drawings, layouts and maps only',
                      'speckle does nothing: it counts with pictures only'):
            self.assertIn(f'the option {words}', mesh.notes)
        self.assertEqual(sum('does nothing' in note for note in mesh.notes), 2)
        layout = cover.mesh_file(DATA / 'finfet.gds', layer_map=DATA / 'finfet.map', speckle=4)
        self.assertEqual([note for note in layout.notes if 'does nothing' in note],
                         ['the option speckle does nothing: it counts with pictures only'])

    def test_options_of_writing_without_effect(self):
        mesh = cover.mesh(SQUARE, RING)
        before = mesh.notes
        mesh.save(self.dir / 'x.msh', msh='4.1', ids='region')
        mesh.save(self.dir / 'x.svg', order=2)
        self.assertEqual(mesh.notes, before)
        for _ in range(2):
            mesh.save(self.dir / 'x.vtu', msh='4.1', lines=True, no_inner_lines=False)
        added = ['the option msh does nothing: it counts with .msh only', 'the option lines does nothing: it counts with .vtk only']
        self.assertEqual(mesh.notes, before + added)
        self.assertEqual(pickle.loads(pickle.dumps(mesh)).notes, before + added)


    def test_what_files_lack(self):
        corners = [[0, 0], [9, 0], [9, 9], [0, 9]]
        features = [({'kind': 'wood'}, 'Polygon', [[*corners, corners[0]]]), ({'name': 'well'}, 'Point', [4, 3])]
        (self.dir / 'map.geojson').write_text(json.dumps({'type': 'FeatureCollection', 'features': [
            {'type': 'Feature', 'properties': of, 'geometry': {'type': kind, 'coordinates': at}} for of, kind, at in features]}))
        mesh = cover.mesh_file(self.dir / 'map.geojson', keep_field='kind', name_field='name')
        before = mesh.notes
        for name in 'x.vtm', 'x.vtkhdf', 'x.svg', 'x.poly', 'x.json':
            mesh.save(self.dir / name)
        self.assertEqual(mesh.notes, before)
        for _ in range(2):
            mesh.save(self.dir / 'x.obj')
        added = mesh.notes[len(before):]
        self.assertEqual(len(added), 2)
        self.assertRegex(added[0], r'^attributes \(kind\) are not in x\.obj: formats that hold them are .*\.vtm')
        self.assertRegex(added[1], r'^names of points \(well\) are not in x\.obj: formats that hold them are .*\.msh')
        square = cover.mesh(np.array([[0, 0], [1 + 2**-52, 0], [1, 1.2345678901234567e-7]]), [[0, 1], [1, 2], [2, 0]])
        square.save(self.dir / 'x.inp')
        self.assertTrue(any('in x.inp' in note and 'rounded' in note for note in square.notes), square.notes)
        doped = cover.mesh_file(DATA / 'nmos.tif')
        doped.save(self.dir / 'x.mesh')
        self.assertTrue(any(note.startswith('values at points (') for note in doped.notes))
        for element, at in ('CAX', -1), ('CAX', 0), ('CPS', -1):
            square = cover.mesh(np.array([[at, 0], [1, 0], [1, 1]]), [[0, 1], [1, 2], [2, 0]])
            square.save(self.dir / 'x.inp', inp_element=element)
            self.assertEqual('1 point in x.inp has x < 0' in str(square.notes), (element, at) == ('CAX', -1))
        cell = cover.mesh_file(DATA / 'motor_pole.json')
        cell.save(self.dir / 'c.poly')
        self.assertTrue(any(re.match('pairs on periodic sides .* not in c.poly', note) for note in cell.notes), cell.notes)


class Pictures(Case):
    def test_title_width_and_colour(self):
        mesh = cover.mesh(SQUARE, RING)
        mesh.save(self.dir / 'a.svg')
        mesh.save(self.dir / 'b.svg', title='Two <triangles> ö', width=640, color='max_angle')
        plain, text = ((self.dir / name).read_text(encoding='utf8') for name in ('a.svg', 'b.svg'))
        self.assertIn('Two &lt;triangles&gt; ö', text)
        self.assertRegex(text, r'<svg [^>]*width="640')
        self.assertIn('max_angle', text)
        self.assertNotIn('max_angle', plain)
        mesh.save(self.dir / 'b.png', title='x', width=np.int64(500), color=None)
        self.assertEqual(int.from_bytes((self.dir / 'b.png').read_bytes()[16:20], 'big'), 500)

    def test_mistakes(self):
        mesh = cover.mesh(SQUARE, RING)
        for said, options in (('width: 10 is not in 200..20000', {'width': 10}), ('width: 640.5 is not a whole number', {'width': 640.5}),
                              ('width: True is not a whole number', {'width': True}), ('title: 7 is not text', {'title': 7}),
                              ("unexpected option 'colour'; did you mean 'color'", {'colour': 'x'})):
            with self.assertRaisesRegex(cover.OptionError, said):
                mesh.save(self.dir / 'a.svg', **options)
        with self.assertRaisesRegex(cover.Error, "the mesh has no array 'depth'"):
            mesh.save(self.dir / 'a.svg', color='depth')
        self.assertEqual(list(self.dir.iterdir()), [])
        mesh.save(self.dir / 'a.vtu', title='x', width=None)
        self.assertEqual(mesh.notes[-1], 'the option title does nothing: it counts with pictures only')


class MeshingAgain(Case):
    SIDE = np.concatenate([SQUARE[k] * 4 + (SQUARE[(k + 1) % 4] - SQUARE[k]) * np.arange(0, 4, 0.5)[:, None] for k in range(4)])
    POLYGONS = [('Si', [SIDE], 'left'), ('Cu', [SIDE + (4, 0)], 'right')]

    def test_others_stay_bit_for_bit(self):
        mesh = cover.mesh_polygons(self.POLYGONS)
        mesh.save(self.dir / 'a.vtm')
        mesh.save(self.dir / 'lone.msh')
        for onto in mesh, self.dir / 'a.vtm', str(self.dir / 'lone.msh'):
            for only in 'left', ['left'], 'Si', ('region:1',), 1:
                again = cover.mesh_polygons(self.POLYGONS, only=only, onto=onto, size=0.2)
                self.assertGreater(np.sum(again.region == 1), np.sum(mesh.region == 1))
                self.assertEqual(again.points[again.triangles[again.region == 2]].tolist(),
                                 mesh.points[mesh.triangles[mesh.region == 2]].tolist())
                self.assertEqual(again.violations(), [])
                self.assertEqual(again.report['regions'][1]['method'], 'kept')
        same = cover.mesh_polygons(self.POLYGONS, only=['left', 'right'], onto=mesh)
        self.assertEqual(same.points.tolist(), mesh.points.tolist())

    def test_of_arrays_and_files(self):
        graph = (self.SIDE, [(k, (k + 1) % 32) for k in range(32)], [(1, 1, 'Si')])
        mesh = cover.mesh(*graph)
        self.assertGreater(len(cover.mesh(*graph, only='Si', onto=mesh, size=0.2).triangles), len(mesh.triangles))
        doped = cover.mesh_file(DATA / 'nmos.tif')
        again = cover.mesh_file(DATA / 'nmos.tif', only=doped.regions[0]['name'], onto=doped, max_angle=110)
        self.assertEqual(set(again.fields), set(doped.fields))

    def test_mistakes(self):
        mesh = cover.mesh_polygons(self.POLYGONS)
        for more in {'only': 'left'}, {'onto': mesh}:
            with self.assertRaisesRegex(cover.OptionError, 'both are needed'):
                cover.mesh_polygons(self.POLYGONS, **more)
        with self.assertRaisesRegex(cover.OptionError, 'only: 0.5 is no name'):
            cover.mesh_polygons(self.POLYGONS, only=[0.5], onto=mesh)
        with self.assertRaisesRegex(cover.OptionError, 'middle'):
            cover.mesh_polygons(self.POLYGONS, only='middle', onto=mesh)
        with self.assertRaisesRegex(cover.Error, '^the mesh: '):
            cover.mesh(SQUARE * 3, RING, [(1, 1, 'Si')], only='Si', onto=mesh)
        with self.assertRaises(cover.Error):
            cover.mesh_polygons(self.POLYGONS, only='left', onto=self.dir / 'none.vtu')


class ValuesOfRegions(Case):
    def test_survive_files_and_pickling(self):
        mesh = cover.mesh_file(DATA / 'nmos.tif')
        def blocks(of, name):
            of.save(self.dir / f'{name}.vtm')
            return {file.name[1:]: file.read_bytes() for file in (self.dir / name).iterdir()}
        before = blocks(mesh, 'a')
        self.assertTrue(before == blocks(pickle.loads(pickle.dumps(mesh)), 'b'))
        self.assertTrue(before == blocks(cover.read(self.dir / 'a.vtm'), 'c'))
        mesh.save(self.dir / 'd.vtu')  # which has one value for all regions
        self.assertFalse(before == blocks(cover.read(self.dir / 'd.vtu'), 'e'))


class Pickling(Case):
    def manifest(self, mesh):
        mesh.save(self.dir / 'x.json')
        whole = json.loads((self.dir / 'x.json').read_text())
        for line in whole['lines']:
            line['edges'] = sorted(sorted(edge) for edge in line['edges'])
        for arc in whole.get('arcs', ()):
            arc['edges'] = sorted(sorted(edge) for edge in arc['edges'])
        return whole

    def test_figures_of_report_and_manifest(self):
        for name, options in (('mosfet.poly', {'size': 20}), ('tft.json', {}), ('diode_layers.json', {}),
                              ('motor_pole.json', {'split_interfaces': True, 'size': 2})):
            mesh = cover.mesh_file(DATA / name, **options)
            again = pickle.loads(pickle.dumps(mesh))
            for other in again, copy.deepcopy(again):
                self.assertEqual(other.report, mesh.report, name)
                self.assertEqual(other.notes, mesh.notes, name)
                self.assertEqual(self.manifest(other), self.manifest(mesh), name)

    def test_points_in_the_void(self):
        for options in {}, {'split_interfaces': True, 'size': .5}:
            mesh = cover.mesh([*SQUARE, [50, 50], [60, 50]], RING, **options)
            for other in pickle.loads(pickle.dumps(mesh)), copy.copy(mesh), copy.deepcopy(copy.deepcopy(mesh)):
                self.assertEqual(other.input_id.tolist(), mesh.input_id.tolist())
                self.assertEqual(other.points.tolist(), mesh.points.tolist())
                self.assertEqual(other.notes, mesh.notes)
                self.assertEqual(self.manifest(other), self.manifest(mesh))

    def test_what_was_read_has_no_figures_of_regions(self):
        cover.mesh(SQUARE, RING).save(self.dir / 'x.vtkhdf')
        mesh = cover.read(self.dir / 'x.vtkhdf')
        self.assertEqual(self.manifest(pickle.loads(pickle.dumps(mesh))), self.manifest(mesh))

    def test_broken_figures(self):
        function, (state,) = cover.mesh(SQUARE, RING).__reduce__()
        for k, value in (0, np.zeros(7)), (1, np.zeros(0)), (3, [(99, 0, 'x', np.zeros((0, 2)))]), (4, [()]):
            figures = list(state[19])
            figures[k] = value
            with self.assertRaises((ValueError, TypeError, RuntimeError, IndexError)):
                function((*state[:19], tuple(figures), state[20]))


class Pipes(Case):
    def setUp(self):
        super().setUp()
        self.pipe = self.dir / 'pipe.vtu'
        os.mkfifo(self.pipe)
        self.mesh = cover.mesh(SQUARE, RING, size=0.01, split_interfaces=True)
        self.mesh.save(self.dir / 'file.vtu')
        self.whole = (self.dir / 'file.vtu').read_bytes()
        self.assertGreater(len(self.whole), 1 << 17)  # more than a pipe holds

    def test_signals_while_it_waits(self):
        seen, got = [], []
        before = signal.signal(signal.SIGALRM, lambda *_: seen.append(1))

        def read():
            time.sleep(0.3)
            with open(self.pipe, 'rb') as pipe:
                time.sleep(0.3)
                got.append(pipe.read())
        reader = threading.Thread(target=read)
        reader.start()
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.05, 0.05)
            self.mesh.save(self.pipe)
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)
        reader.join()
        self.assertGreater(len(seen), 3)
        self.assertEqual(got, [self.whole])

    def test_ctrl_c_without_a_reader(self):
        self.pipe.rename(self.dir / 'pipe')
        for extension in 'vtu', 'msh', 'svg', 'png':
            with self.subTest(extension):
                pipe = (self.dir / 'pipe').rename(self.dir / f'pipe.{extension}')
                threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
                start = time.monotonic()
                with self.assertRaises(KeyboardInterrupt):
                    self.mesh.save(pipe)
                self.assertLess(time.monotonic() - start, 5)
                pipe.rename(self.dir / 'pipe')


class Ends(Case):
    """Of an interpreter while a thread that nobody waits for is at work."""

    def leave(self, work):
        program = textwrap.dedent('''
            import sys, threading, time
            import cover
            import numpy as np
            n = 2000
            angles = 2 * np.pi * np.arange(n) / n
            ring = np.column_stack([np.arange(n), (np.arange(n) + 1) % n])
            points = np.column_stack([np.cos(angles), np.sin(angles)])
            square = cover.mesh([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1), (1, 2), (2, 3), (3, 0)], size=0.01, split_interfaces=True)
            folder, began = sys.argv[1], threading.Event()
            def told(*_):
                began.set()
            def size(x, y):
                began.set()
                return 0.01
            def forever(f):
                while True:
                    f()
            ''') + f'threading.Thread(target=lambda: forever(lambda: {work}), daemon=True).start()\n' + textwrap.dedent('''
            began.wait()
            time.sleep(0.1)
            print('leaving')
            ''')
        for _ in range(4):
            done = subprocess.run([sys.executable, '-c', program, self.dir], text=True, timeout=60,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, 'leaving\n', ''))

    def test_sizes_by_function(self):
        self.leave('cover.mesh(points, ring, size_field=size)')

    def test_progress(self):
        self.leave('cover.mesh(points, ring, size=0.01, progress=told)')

    def test_without_callables(self):
        self.leave('[began.set(), cover.mesh(points, ring, size=0.01)]')

    def test_files_and_checks(self):
        self.leave('[began.set(), square.save(f"{folder}/x.vtu"), cover.read(f"{folder}/x.vtu"), square.violations()]')


if __name__ == '__main__':
    unittest.main()
