"""The module from outside; run by ctest with the built package in PYTHONPATH."""
import copy
import importlib.util
import json
import math
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import textwrap
import threading
import time
import types
import unittest
import unittest.mock

import numpy as np

import cover

SQUARE = np.array([[0, 0], [1, 0], [2, 0], [2, 1], [1, 1], [0, 1]], dtype=float)
SEGMENTS = np.array([[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0], [1, 4]])
REGIONS = [(0.5, 0.5, 'Si', 'bulk'), (1.5, 0.5, 'SiO2')]


def polygon(n, radius=1.0):
    angles = 2 * math.pi * np.arange(n) / n
    points = radius * np.column_stack([np.cos(angles), np.sin(angles)])
    return points, np.column_stack([np.arange(n), (np.arange(n) + 1) % n])


class WithoutNumpy(unittest.TestCase):
    def test_that_it_is_missing_is_told(self):
        program = """
            import sys
            sys.modules['numpy'] = None
            import cover
            cover.mesh([[0, 0], [1, 0], [0, 1]], [[0, 1], [1, 2], [2, 0]])"""
        done = subprocess.run([sys.executable, '-c', textwrap.dedent(program)], text=True, timeout=100, stderr=subprocess.PIPE)
        self.assertRegex(done.stderr.splitlines()[-1], '^ModuleNotFoundError: .*numpy')


class BoxMethod(unittest.TestCase):
    def setUp(self):
        corners, sides = polygon(7)
        inner, ring = polygon(5, 0.4)
        self.mesh = cover.mesh(np.vstack([corners, inner]), np.vstack([sides, ring + 7]), [(0.9, 0, 'a'), (0, 0, 'b')], size=0.1)
        self.boxes = self.mesh.box_method()

    def test_boxes_fill_their_regions(self):
        areas = {region: 0.0 for region in (1, 2)}
        for region, area in zip(self.boxes['box_regions'], self.boxes['box_areas']):
            areas[region] += area
        for region in self.mesh.report['regions']:
            self.assertAlmostEqual(areas[region['id']], region['area'], places=12)
        places = list(zip(self.boxes['box_regions'], self.boxes['box_points']))
        self.assertEqual(places, sorted(set(places)))

    def test_an_edge_between_regions_couples_in_both(self):
        found = set(zip(self.boxes['edge_regions'], map(tuple, self.boxes['edges'])))
        self.assertEqual(len(found), len(self.boxes['couplings']))
        for k in range(5):
            ends = (7 + k, 7 + (k + 1) % 5)
            self.assertTrue({(1, tuple(sorted(ends))), (2, tuple(sorted(ends)))} <= found)

    def test_what_is_linear_has_no_residue_inside(self):
        edges, couplings = self.boxes['edges'], self.boxes['couplings']
        potential = self.mesh.points @ [2, -3]
        residue = np.zeros(len(potential))
        flux = couplings * (potential[edges[:, 1]] - potential[edges[:, 0]])
        np.add.at(residue, edges[:, 0], flux)
        np.add.at(residue, edges[:, 1], -flux)
        np.testing.assert_allclose(residue[12:], 0, atol=1e-12)
        self.assertGreater(abs(residue[:7]).max(), 1)

    def test_negative_couplings_are_those_of_the_report(self):
        sliver = cover.mesh([[0, 0], [9, 0], [9, 1], [4, 0.2], [0, 1]], [[0, 1], [1, 2], [2, 3], [3, 4], [4, 0]])
        negative = sliver.box_method()['couplings'] < 0
        self.assertEqual(negative.sum(), sliver.report['overall']['box']['negative_couplings'])
        self.assertGreater(negative.sum(), 0)


class Meshing(unittest.TestCase):
    def test_arrays(self):
        mesh = cover.mesh(SQUARE, SEGMENTS, REGIONS)
        self.assertEqual(mesh.points.shape[1], 2)
        self.assertEqual(mesh.triangles.shape, (len(mesh.region), 3))
        np.testing.assert_array_equal(mesh.points[:6], SQUARE)
        np.testing.assert_array_equal(mesh.input_id[:6], np.arange(6))
        self.assertTrue((mesh.input_id[6:] == -1).all())
        corners = mesh.points[mesh.triangles]
        u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        areas = (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2
        self.assertTrue((areas > 0).all())
        for region in (1, 2):
            self.assertAlmostEqual(areas[mesh.region == region].sum(), 1, places=12)
        self.assertEqual(mesh.violations(), [])
        self.assertIn('2 regions', repr(mesh))

    def test_periodic_sides(self):
        lines = {'left': [5], 'right': [2]}
        mesh = cover.mesh(SQUARE, SEGMENTS, REGIONS, lines=lines, periodic='left=right', split_interfaces=90, size=0.2)
        rule, = mesh.periodic
        self.assertEqual((rule['from'], rule['to']), ('left', 'right'))
        again = cover.mesh(SQUARE, SEGMENTS, REGIONS, lines=lines, periodic=[('left', 'right')], split_interfaces=90, size=0.2)
        self.assertEqual(again.report['options']['periodic'], 'left=right')
        pairs = rule['vertices']
        self.assertGreater(len(pairs), 4)
        self.assertEqual(rule['edges'].shape, (len(pairs) - 1, 4))
        np.testing.assert_array_equal(mesh.points[pairs[:, 0]] + [2, 0], mesh.points[pairs[:, 1]])
        with self.assertRaisesRegex(cover.OptionError, "did you mean 'right'"):
            cover.mesh(SQUARE, SEGMENTS, REGIONS, lines=lines, periodic=['left=rigth'])

    def test_a_size_field_beside_the_drawing_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            for shift, told in ((0, 0), (1000, 1)):
                path = pathlib.Path(folder) / f'{shift}.csv'
                path.write_text(''.join(f'{x + shift},{y},0.2\n' for x, y in SQUARE))
                mesh = cover.mesh(SQUARE, SEGMENTS, REGIONS, size_field=path)
                beside = [n for n in mesh.report['notes'] if 'the drawing' in n['message']]
                self.assertEqual(len(beside), told, mesh.report['notes'])

    def test_arcs(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / 'disc.json'
            path.write_text('{"segments": [{"circle": {"centre": [1, 2], "radius": 3, "chords": 6}}]}')
            mesh = cover.mesh_file(path, split_interfaces=120, size=0.5)
        arcs = mesh.arcs
        self.assertGreater(len(arcs['edges']), 20)
        for points in (mesh.points[arcs['edges'].ravel()], arcs['middles']):
            np.testing.assert_allclose(np.hypot(*(points - [1, 2]).T), 3, rtol=1e-14)
        self.assertFalse(any(arcs['straight']))
        # Parabolas through the middles of 36 arcs or so are off by some 2e-6 of the disc; chords by 5e-3.
        self.assertLess(abs(arcs['areas'][0] / (9 * math.pi) - 1), 1e-5)

    def test_promises_are_those_of_the_run(self):
        corners, inner = [(0, 0), (4, 0), (4, 3), (0, 3)], [(1, 1), (2, 1), (2, 2)]
        for options in ({}, {'hull': True}, {'split_interfaces': True}, {'method': 'nonobtuse'}, {'method': 'almond'}, {'box_method': True},
                        {'method': 'almond', 'paper': True}):
            mesh = cover.mesh(corners, [(0, 1), (1, 2), (2, 3), (3, 0), (0, 2)], **options)
            self.assertEqual(mesh.violations(), [], options)
        mesh = cover.mesh(corners + inner, [(4, 5), (5, 6)], hull=True)
        self.assertEqual(mesh.violations(), [])

    def test_lists_will_do(self):
        mesh = cover.mesh([(0, 0), (1, 0), (0, 1)], [(0, 1), (1, 2), (2, 0)])
        self.assertEqual(len(mesh.triangles), 1)

    def test_empty_lists_are_no_segments(self):
        corners = [(0, 0), (1, 0), (0, 1)]
        for none in ([], np.array([]), np.zeros((0, 2), int)):
            self.assertEqual(len(cover.mesh(corners, none, hull=True).triangles), 1)
            with self.assertRaisesRegex(cover.Error, 'no segments'):
                cover.mesh(corners, none)
        ring = np.array([(0, 1), (1, 2), (2, 0)], dtype=np.uint64)
        self.assertEqual(len(cover.mesh(corners, ring, lines={'a': []}).triangles), 1)

    def test_report_and_lines(self):
        mesh = cover.mesh(SQUARE, SEGMENTS, REGIONS, threads=1)
        self.assertEqual([r['name'] for r in mesh.report['regions']], ['bulk', 'SiO2'])
        self.assertEqual(mesh.report['threads'], 1)
        between = [p for pieces in mesh.lines.values() for p in pieces if (p['left'], p['right']) == (1, 2)]
        self.assertEqual(len(between), 1)
        self.assertEqual({frozenset(e) for e in between[0]['edges'].tolist()}, {frozenset((1, 4))})

    def test_named_lines(self):
        mesh = cover.mesh(SQUARE, SEGMENTS, REGIONS, lines={'drain': [5], 'source': np.array([2])})
        for name, ends in ('drain', {5, 0}), ('source', {2, 3}):
            (piece,) = mesh.lines[name]
            self.assertEqual(set(piece['edges'].ravel().tolist()), ends)
        with self.assertRaises(IndexError):
            cover.mesh(SQUARE, SEGMENTS, REGIONS, lines={'drain': [7]})
        with self.assertRaises(ValueError):
            cover.mesh(SQUARE, SEGMENTS, REGIONS, lines={'drain': [[5]]})
        with self.assertRaisesRegex(ValueError, 'the name of a line is empty'):
            cover.mesh(SQUARE, SEGMENTS, REGIONS, lines={'': [2]})

    def test_sizes_and_split_interfaces(self):
        coarse = cover.mesh(SQUARE, SEGMENTS, REGIONS)
        fine = cover.mesh(SQUARE, SEGMENTS, REGIONS, lines={'drain': [5]}, sizes={'bulk': 0.2},
                          sizes_at={'drain': 0.05}, split_interfaces=90)
        self.assertGreater(len(fine.triangles), len(coarse.triangles))
        self.assertGreaterEqual(len(fine.lines['drain'][0]['edges']), 10)

    def test_holes(self):
        outer, ring = polygon(12)
        inner, _ = polygon(12, 0.4)
        mesh = cover.mesh(np.vstack([outer, inner]), np.vstack([ring, ring + 12]), holes=[(0, 0)])
        self.assertEqual(len(mesh.report['regions']), 1)

    def test_threads_do_not_matter(self):
        outer, ring = polygon(300)
        one = cover.mesh(outer, ring, threads=1)
        many = cover.mesh(outer, ring, threads=4)
        np.testing.assert_array_equal(one.points, many.points)
        np.testing.assert_array_equal(one.triangles, many.triangles)

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'a.vtu')
            cover.mesh(SQUARE, SEGMENTS, REGIONS).save(path)
            again = cover.mesh_file(path)
            self.assertEqual(len(again.report['regions']), 2)
            with self.assertRaises(cover.Error):
                again.save(os.path.join(folder, 'a.unknown'))
            again.save(pathlib.Path(folder, 'a.msh'), order=2, msh='4.1')
            self.assertIn('4.1 0 8', pathlib.Path(folder, 'a.msh').read_text())
            for name, start in ('a.png', b'\x89PNG'), ('a.svg', b'<svg '):
                again.save(os.path.join(folder, name))
                self.assertEqual(pathlib.Path(folder, name).read_bytes()[:len(start)], start)

    def test_polygons(self):
        mesh = cover.mesh_polygons([('Si', [[(0, 0), (4, 0), (4, 4), (0, 4)]]),
                                    ('SiO2', [[(1, 1), (2, 1), (2, 2), (1, 2)]], 'gate')])
        self.assertEqual({r['name'] for r in mesh.report['regions']}, {'Si', 'gate'})


class Values(unittest.TestCase):
    """What maps and simulators have beside shapes."""
    DATA = pathlib.Path(__file__).resolve().parents[2] / 'samples/data'
    MAP = """{"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"use": "wood", "height": 2.5}, "geometry":
            {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]}},
        {"type": "Feature", "properties": {"use": null}, "geometry":
            {"type": "Polygon", "coordinates": [[[1, 0], [2, 0], [2, 1], [1, 1], [1, 0]]]}}]}"""

    def mapped(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, 'm.geojson')
            path.write_text(self.MAP)
            with self.assertRaises(cover.OptionError):
                cover.mesh_file(path, keep_field='usage')
            self.assertEqual(cover.mesh_file(path).attributes, {})
            return cover.mesh_file(path, keep_field=['use', 'height', 'fid'])

    def test_several_files_are_one_geometry(self):
        with tempfile.TemporaryDirectory() as folder:
            a, b = pathlib.Path(folder, 'a.geojson'), pathlib.Path(folder, 'b.json')
            a.write_text(self.MAP)
            b.write_text('{"polygons": [{"material": "lake", "rings": [[[0.25, 0.25], [0.75, 0.25], [0.5, 0.5]]]}]}')
            both = cover.mesh_file([a, str(b)], keep_field='use')
            self.assertEqual(len(both.regions), 3)
            self.assertIn('lake', both.materials.values())
            self.assertEqual(len(cover.mesh_file((a,)).regions), 2)
            # Fields need be in one of them only.
            bare = pathlib.Path(folder, 'c.geojson')
            bare.write_text(self.MAP.replace('"use": "wood", "height": 2.5', '').replace('"use": null', ''))
            for files in (a, bare), (bare, a):
                mesh = cover.mesh_file(files, keep_field='height', material_field='use')
                self.assertEqual('wood' in mesh.materials.values(), files[1] == a, 'the later file is painted over the other')
            with self.assertRaisesRegex(cover.OptionError, 'nowhere'):
                cover.mesh_file([a, bare], keep_field='nowhere')
            with self.assertRaisesRegex(TypeError, 'no file'):
                cover.mesh_file([])

    def test_attributes_by_region(self):
        mesh = self.mapped()
        for m in mesh, pickle.loads(pickle.dumps(mesh)):
            self.assertEqual(list(m.attributes), ['use', 'height', 'fid'])
            self.assertEqual(m.attributes['use'], ['wood', None])
            np.testing.assert_array_equal(m.attributes['height'], [2.5, math.nan])
            np.testing.assert_array_equal(m.attributes['fid'], [0, 1])

    def test_fields_by_point(self):
        mesh = cover.mesh_file(self.DATA / 'nmos.tif')
        for m in mesh, pickle.loads(pickle.dumps(mesh)):
            doping = m.fields['Net']
            self.assertEqual(doping.shape, (len(m.points),))
            self.assertGreater(np.nanmax(np.abs(doping)), 1e15)
            np.testing.assert_array_equal(doping, mesh.fields['Net'])
        self.assertEqual(cover.mesh(SQUARE, SEGMENTS, REGIONS).fields, {})

    def test_no_vtk_without_pictures(self):
        # In a process of its own; a program may have another VTK.
        code = """if True:
            import cover
            mesh = cover.mesh([(0, 0), (1, 0), (0, 1)], [(0, 1), (1, 2), (2, 0)])
            assert 'libvtk' not in open('/proc/self/maps').read()
            mesh.save('a.png')
            assert 'libvtk' in open('/proc/self/maps').read()
        """
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, '-c', code], cwd=folder, check=True, timeout=60)


class Polygons(unittest.TestCase):
    """mesh_polygons() with curves, contacts and voids."""

    def test_curves_and_contacts(self):
        wire = {'circle': {'centre': (2, 1), 'radius': 0.5}}
        quarter = [{'arc': {'centre': (0, 0), 'radius': 1.0, 'from': 0, 'to': 90}}, (0, 0)]
        mesh = cover.mesh_polygons(
            [('Si', [np.array([[0, 0], [4, 0], [4, 2], [0, 2]])]), ('Cu', [[wire]], 'wire'),
             {'material': 'Ox', 'rings': [quarter], 'size': 0.1, 'priority': np.int64(1)}],
            lines={'top': [(0, 2), (4, 2)], 'ends': [np.array([[0, 1], [0, 2.0]]), [(4, 0), (4, 2)]], 'rim': [wire]},
            chord_error=0.01, unit='um')
        self.assertEqual({name: len(pieces) > 0 for name, pieces in mesh.lines.items() if name in ('top', 'ends', 'rim')},
                         {'top': True, 'ends': True, 'rim': True})
        regions = {r['name']: r for r in mesh.report['regions']}
        self.assertEqual(set(regions), {'Si', 'wire', 'Ox'})
        self.assertAlmostEqual(regions['wire']['area'], math.pi / 4, delta=0.03)
        self.assertAlmostEqual(regions['Ox']['area'], math.pi / 4, delta=0.03)
        self.assertEqual(mesh.report['input']['unit'], 'um')
        self.assertEqual(mesh.violations(), [])

    def test_voids(self):
        square = np.array([[0, 0], [4, 0], [4, 4], [0, 4]])
        mesh = cover.mesh_polygons([('a', [square]), ('b', [square / 4 + 1])], holes=np.array([[1.5, 1.5]]))
        self.assertEqual([r['material_name'] if 'material_name' in r else r['name'] for r in mesh.report['regions']], ['a'])

    def test_points(self):
        square = [(0, 0), (4, 0), (4, 4), (0, 4)]
        wells = np.array([[1.25, 1.5], [3, 2]])
        for points in wells, wells.tolist():
            mesh = cover.mesh_polygons([('a', [square])], points=points)
            places = {tuple(p) for p in mesh.points.tolist()}
            self.assertLessEqual({(1.25, 1.5), (3.0, 2.0)}, places)
            self.assertEqual(mesh.violations(), [])
        for none in None, (), np.zeros((0, 2)):
            self.assertEqual(len(cover.mesh_polygons([('a', [square])], points=none).points), 4)
        with self.assertRaisesRegex(cover.Error, 'expected a point'):
            cover.mesh_polygons([('a', [square])], points=[(1, 2, 3)])
        with self.assertRaisesRegex(TypeError, 'points: 1 is no point'):
            cover.mesh_polygons([('a', [square])], points=[1, 2])

    def test_mistakes(self):
        with self.assertRaises(cover.Error) as caught:
            cover.mesh_polygons([('a', [[{'circle': {'centre': (0, 0), 'radius': -1, 'chords': 8}}]])])
        self.assertIn('polygons[0].rings[0][0].circle.radius', str(caught.exception))
        with self.assertRaises(TypeError):
            cover.mesh_polygons([('a', [[{'circle': object()}]])])

    def test_mistakes_in_their_shape_are_told_in_words(self):
        square = [(0, 0), (4, 0), (4, 4), (0, 4)]
        with self.assertRaisesRegex(TypeError, 'lines must be a dictionary: paths by'):
            cover.mesh_polygons([('a', [square])], lines=[square[:2]])
        for polygons, said in (({'a': 3}, 'polygons must be a list'), (None, 'polygons must be a list'), ([square], 'polygon 0 is no'),
                               ([('a', [square]), 'b'], 'polygon 1 is no'), ([([square], 'a')], 'polygon 0: its material'),
                               ([('a', 3)], 'polygon 0: its rings'), ([('a', [3, 4])], 'polygon 0: a ring'),
                               ([([(0, 0), (1, 0)], [square])], 'polygon 0: its material')):
            with self.assertRaisesRegex(TypeError, said):
                cover.mesh_polygons(polygons)
        with self.assertRaises((TypeError, ValueError)) as raised:
            cover.mesh_polygons([('a', square)])  # a ring too little of brackets
        self.assertNotIn('not iterable', str(raised.exception))


class Pickling(unittest.TestCase):
    def test_everything_survives(self):
        mesh = cover.mesh(SQUARE, SEGMENTS, REGIONS, lines={'anode': [5]}, size=0.2)
        again = pickle.loads(pickle.dumps(mesh))
        for name in ('points', 'triangles', 'region', 'material', 'input_id'):
            np.testing.assert_array_equal(getattr(mesh, name), getattr(again, name), name)
        self.assertEqual(mesh.report, again.report)
        self.assertEqual(list(mesh.lines), list(again.lines))
        for name, pieces in mesh.lines.items():
            for one, other in zip(pieces, again.lines[name], strict=True):
                self.assertEqual((one['left'], one['right']), (other['left'], other['right']))
                self.assertEqual({frozenset(e) for e in one['edges'].tolist()}, {frozenset(e) for e in other['edges'].tolist()})
        with self.assertRaisesRegex(ValueError, 'read, copied or pickled'):
            again.violations()
        with tempfile.TemporaryDirectory() as folder:
            for k, m in enumerate((mesh, again)):
                m.save(f'{folder}/{k}.msh')
            self.assertEqual(*(pathlib.Path(f'{folder}/{k}.msh').read_bytes() for k in range(2)))

    def test_wrong_states(self):
        mesh = cover.mesh(SQUARE, SEGMENTS, REGIONS)
        function, (state,) = mesh.__reduce__()
        for k, value in ((0, 99), (1, np.zeros(3)), (2, np.full((4, 3), 999, np.uint32)), (8, np.zeros((2, 3), int))):
            wrong = list(state)
            wrong[k] = value
            with self.assertRaises((ValueError, cover.Error)):
                function(tuple(wrong))
        with self.assertRaisesRegex(TypeError, 'made by mesh'):
            cover.Mesh.__new__(cover.Mesh)

    def test_every_protocol_and_copy(self):
        mesh = cover.mesh(SQUARE, SEGMENTS, REGIONS)
        for again in [copy.copy(mesh), copy.deepcopy(mesh),
                      *(pickle.loads(pickle.dumps(mesh, k)) for k in range(pickle.HIGHEST_PROTOCOL + 1))]:
            np.testing.assert_array_equal(again.triangles, mesh.triangles)

    def test_nodes_of_second_order_stay(self):
        with tempfile.TemporaryDirectory() as folder:
            mesh = cover.mesh_file(Values.DATA / 'coax_arcs.json')
            for extension in 'msh', 'vtk':
                mesh.save(f'{folder}/direct.{extension}', order=2)
            read = cover.read(f'{folder}/direct.msh')
            for k, m in enumerate((read, pickle.loads(pickle.dumps(read)))):
                m.save(f'{folder}/{k}.vtk', order=2)
            places = [pathlib.Path(f'{folder}/{name}.vtk').read_text().partition('POINTS')[2].partition('CELLS')[0]
                      for name in ('direct', 0, 1)]
            self.assertEqual(places, places[:1] * 3)

    def test_arcs_and_pairs_of_sides_stay(self):
        for name, options in ('motor_pole.json', {'split_interfaces': True, 'size': 2}), ('coax_arcs.json', {}):
            mesh = cover.mesh_file(Values.DATA / name, **options)
            again = pickle.loads(pickle.dumps(mesh))
            self.assertEqual(*({frozenset(edge) for edge in m.arcs['edges'].tolist()} for m in (mesh, again)))
            self.assertEqual([(rule['from'], rule['to']) for rule in again.periodic],
                             [(rule['from'], rule['to']) for rule in mesh.periodic])
            for one, other in zip(mesh.periodic, again.periodic, strict=True):
                np.testing.assert_array_equal(one['edges'], other['edges'])
            with tempfile.TemporaryDirectory() as folder:
                for k, m in enumerate((mesh, again)):
                    for extension in ('msh', 'vtu', 'json'):
                        m.save(f'{folder}/{k}.{extension}', order=2)
                for extension in ('msh', 'vtu'):
                    one, other = (pathlib.Path(f'{folder}/{k}.{extension}').read_bytes() for k in range(2))
                    self.assertEqual(one, other)
                manifests = [json.loads(pathlib.Path(f'{folder}/{k}.json').read_text()) for k in range(2)]
                for key in ('cover', 'source', 'options', 'counts', 'periodic'):
                    self.assertEqual(manifests[0].get(key), manifests[1].get(key), key)
                self.assertEqual(*([(arc['radius'], len(arc['edges'])) for arc in m['arcs']] for m in manifests))


class Reading(unittest.TestCase):
    def test_arcs_and_pairs_of_sides_from_the_manifest(self):
        mesh = cover.mesh_file(Values.DATA / 'fibre_cell.json')
        with tempfile.TemporaryDirectory() as folder:
            for order in 1, 2:
                mesh.save(f'{folder}/m.vtkhdf', order=order)
                mesh.save(f'{folder}/m.json', order=order)
                again = cover.read(f'{folder}/m.vtkhdf')
                self.assertEqual(*({frozenset(edge) for edge in m.arcs['edges'].tolist()} for m in (mesh, again)))
                self.assertGreater(len(again.arcs['edges']), 0)
                self.assertEqual([rule['vertices'].tolist() for rule in again.periodic],
                                 [rule['vertices'].tolist() for rule in mesh.periodic])
                self.assertEqual(again.regions, mesh.regions)
            # The file does not need a manifest, so that of another mesh does no harm.
            cover.mesh(SQUARE, SEGMENTS, REGIONS).save(f'{folder}/m.json')
            again = cover.read(f'{folder}/m.vtkhdf')
            self.assertEqual((again.regions, again.periodic), (mesh.regions, []))
            self.assertRegex('; '.join(again.notes), 'arcs and periodic sides are left out: .*m.json: it is of another mesh')

    def test_vertices_of_the_input(self):
        mesh = cover.mesh(SQUARE, SEGMENTS, REGIONS, split_interfaces=True, size=.3)
        self.assertGreater(mesh.report['mesh']['cut_vertices'], 0)
        with tempfile.TemporaryDirectory() as folder:
            for extension in 'vtm', 'vtkhdf', 'vtu', 'msh', 'ele':
                (pathlib.Path(folder) / 'm.json').unlink(missing_ok=True)
                mesh.save(f'{folder}/m.{extension}')
                if extension not in ('vtm', 'vtkhdf'):
                    mesh.save(f'{folder}/m.json')
                again = cover.read(f'{folder}/m.{extension}')
                self.assertEqual(again.input_id.tolist(), mesh.input_id.tolist(), extension)
                self.assertEqual(pickle.loads(pickle.dumps(again)).input_id.tolist(), mesh.input_id.tolist())

    def test_what_was_written(self):
        mesh = cover.mesh(SQUARE, SEGMENTS, REGIONS, lines={'drain': [5]})
        with tempfile.TemporaryDirectory() as folder:
            for extension in 'vtm', 'vtkhdf', 'msh':
                mesh.save(f'{folder}/m.{extension}')
                again = cover.read(pathlib.Path(f'{folder}/m.{extension}'))
                np.testing.assert_array_equal(again.points, mesh.points)
                with self.assertRaisesRegex(ValueError, 'read, copied or pickled'):
                    again.violations()
                self.assertEqual(again.regions, mesh.regions)
                self.assertEqual(again.materials, mesh.materials)
                self.assertEqual(again.report['overall']['largest_angle'], mesh.report['overall']['largest_angle'])
                self.assertIn('drain', again.lines)
                again.save(f'{folder}/again.vtu')
            with self.assertRaisesRegex(cover.Error, 'cannot open'):
                cover.read(f'{folder}/none.vtu')


class Conversions(unittest.TestCase):
    def setUp(self):
        self.mesh = cover.mesh(SQUARE, SEGMENTS, REGIONS, lines={'drain': [5]})

    def test_version(self):
        self.assertEqual(cover.__version__, self.mesh.report['cover'])

    @unittest.skipUnless(importlib.util.find_spec('vtkmodules'), "VTK's Python modules are not installed")
    def test_vtk(self):
        from vtkmodules.util.numpy_support import vtk_to_numpy
        grid = self.mesh.to_vtk()
        self.assertEqual(grid.GetNumberOfCells(), len(self.mesh.triangles))
        np.testing.assert_array_equal(vtk_to_numpy(grid.GetPoints().GetData())[:, :2], self.mesh.points)
        for t, corners in enumerate(self.mesh.triangles):
            ids = grid.GetCell(t).GetPointIds()
            self.assertEqual([ids.GetId(k) for k in range(3)], corners.tolist())
        for name, values in ('RegionId', self.mesh.region), ('material', self.mesh.material):
            np.testing.assert_array_equal(vtk_to_numpy(grid.GetCellData().GetArray(name)), values)

    def test_meshio(self):
        # A stand-in where meshio is not installed: what it would be given.
        given = {}
        module = types.ModuleType('meshio')
        module.Mesh = lambda points, cells, **data: given.update(points=points, cells=cells, **data)
        with unittest.mock.patch.dict(sys.modules, meshio=module):
            self.mesh.to_meshio()
        self.assertEqual([kind for kind, _ in given['cells']], ['triangle', 'line'])
        for values in given['cell_data'].values():
            self.assertEqual([len(v) for v in values], [len(cells) for _, cells in given['cells']])
        drain = given['field_data']['drain'][0]
        edges = given['cells'][1][1][given['cell_data']['LineId'][1] == drain]
        self.assertEqual(set(edges.ravel().tolist()), {5, 0})


class Mistakes(unittest.TestCase):
    def test_geometry(self):
        with self.assertRaises(cover.Error) as caught:
            cover.mesh([(0, 0), (1, 0), (0, 1)], [(0, 1), (1, 2)])
        self.assertEqual(caught.exception.code, 109)
        self.assertIn('enclose', str(caught.exception))

    def test_arguments(self):
        with self.assertRaises(ValueError):
            cover.mesh([(0, 0, 0)], [(0, 1)])
        with self.assertRaises(IndexError):
            cover.mesh([(0, 0), (1, 0)], [(0, 2)])
        np.testing.assert_array_equal(cover.mesh(SQUARE, np.array(SEGMENTS, float), REGIONS).triangles,
                                      cover.mesh(SQUARE, SEGMENTS, REGIONS).triangles)
        for segments, kind in (([(0, 1.5)], ValueError), ([(0, math.nan)], ValueError), ([('a', 'b')], TypeError)):
            with self.assertRaises(kind) as caught:
                cover.mesh([(0, 0), (1, 0)], segments)
            self.assertIn('segments must be indices: whole numbers', str(caught.exception))
        with self.assertRaises(TypeError) as caught:
            cover.mesh([('a', 'b')], [(0, 0)])
        self.assertIn('points must be numbers', str(caught.exception))
        for said, arguments, options in (('points must be numbers', (np.array(SQUARE) * 1j, SEGMENTS), {}),
                                         ('a region is', (SQUARE, SEGMENTS, [1, 2]), {}),
                                         ('lines must be a dictionary: segments by', (SQUARE, SEGMENTS), dict(lines=[0, 1])),
                                         ('size: .* is not text or a number: Edge length', (SQUARE, SEGMENTS),
                                          dict(size=1j))):
            with self.assertRaisesRegex(TypeError, said):
                cover.mesh(*arguments, **options)
        with self.assertRaises(ValueError):
            cover.mesh(SQUARE, SEGMENTS, [(0.5, 0.5)])
        with self.assertRaises(TypeError):
            cover.mesh(SQUARE, SEGMENTS, REGIONS, colour='red')
        with self.assertRaises(ValueError):
            cover.mesh(SQUARE, SEGMENTS, REGIONS, method='best')
        with self.assertRaises(cover.Error):
            cover.mesh(SQUARE, SEGMENTS, REGIONS, max_angle=20)
        with self.assertRaises(cover.Error):
            cover.mesh_file('nowhere.poly')


    def test_bytes_are_no_sizes(self):
        for value in b'5', bytearray(b'5'), memoryview(b'5'), [b'5'], {'': b'5'}:
            for name in 'size', 'size_at', 'layers':
                with self.assertRaisesRegex(TypeError, f'{name}: '):
                    cover.mesh(SQUARE, SEGMENTS, REGIONS, **{name: value})

    def test_what_is_none(self):
        mesh = cover.mesh(SQUARE, SEGMENTS, None, None, lines=None)
        self.assertEqual(len(mesh.triangles), len(cover.mesh(SQUARE, SEGMENTS).triangles))
        self.assertTrue(len(cover.mesh_polygons([('a', [SQUARE])], holes=None).triangles))

    def test_coordinates_and_indices_of_wrong_types(self):
        with self.assertRaisesRegex(TypeError, "'left' is no coordinate"):
            cover.mesh(SQUARE, SEGMENTS, [('left', 0.5, 'Si')])
        with self.assertRaisesRegex(IndexError, 'no index 18446744073709551615'):
            cover.mesh(SQUARE, np.array([(0, 2**64 - 1)], np.uint64))

    def test_functions_have_no_values_of_a_file(self):
        with self.assertRaisesRegex(TypeError, 'size_of is of the values of a file'):
            cover.mesh(SQUARE, SEGMENTS, REGIONS, size_field=lambda x, y: 1, size_of='asinh')

    def test_mappings_that_are_no_dictionaries(self):
        view = types.MappingProxyType
        for polygon in {'material': 'a', 'rings': [SQUARE]}, {'material': 'a', 'rings': [[view({'circle': view({'centre': (0, 0), 'radius': 1, 'chords': 8})})]]}:
            np.testing.assert_array_equal(cover.mesh_polygons([view(polygon)]).points, cover.mesh_polygons([{**polygon}]).points)
        cover.mesh(SQUARE, SEGMENTS, REGIONS, lines=view({'anode': [5]}), size=view({'': 0.5}))

    def test_unknown_extensions(self):
        with self.assertRaisesRegex(cover.Error, r'\.svg.*\.png'):
            cover.mesh(SQUARE, SEGMENTS, REGIONS).save('mesh.gif')

    def test_members_are_explained(self):
        for name, member in vars(cover.Mesh).items():
            if not name.startswith('_'):
                self.assertTrue(member.__doc__, name)

    def test_numbers_of_numpy(self):
        for value in 0.4, np.float64(0.4), np.array(0.4), np.array([0.4]):
            mesh = cover.mesh(SQUARE, SEGMENTS, REGIONS, size=value)
            self.assertEqual(mesh.report['options'], {'method': 'quality', 'size': '0.4'})
        layers = cover.mesh(SQUARE, SEGMENTS, REGIONS, lines={'drain': [5]}, layers={'drain': np.array([0.05, 1.2, 2])})
        self.assertEqual(layers.report['options']['layers'], 'drain=0.05,1.2,2')
        self.assertEqual(cover.mesh(SQUARE, SEGMENTS, REGIONS, max_angle=np.array(95.5)).report['options']['max-angle'], '95.5')

    def test_lines(self):
        with self.assertRaisesRegex(ValueError, "segment 1 is in 'anode' and in 'cathode'"):
            cover.mesh(SQUARE, SEGMENTS, REGIONS, lines={'anode': [0, 1], 'cathode': [1]})
        self.assertIn("the line 'a' has no segments: it is left out", cover.mesh(SQUARE, SEGMENTS, REGIONS, lines={'a': []}).notes)
        with self.assertRaisesRegex(ValueError, "'a' has no points"):
            cover.mesh_polygons([('Si', [SQUARE])], lines={'a': []})

    def test_not_finite(self):
        bad = [(0, 0), (1, math.nan), (0, 1)]
        for options in {}, {'unit': 'nm'}:
            with self.assertRaisesRegex(cover.Error, r'\(1, nan\) of polygon 0 is not finite') as caught:
                cover.mesh_polygons([('Si', [bad])], **options)
            self.assertEqual(caught.exception.code, 100)
        with self.assertRaisesRegex(cover.Error, "of the line 'c' is not finite"):
            cover.mesh_polygons([('Si', [SQUARE])], lines={'c': bad})

    def test_materials(self):
        for value in None, True, 5.5, b'Si', ['a']:
            with self.assertRaisesRegex(TypeError, 'a name or a (whole )?number'):
                cover.mesh_polygons([(value, [SQUARE])])
            with self.assertRaisesRegex(TypeError, 'a name or a whole number'):
                cover.mesh(SQUARE, SEGMENTS, [(0.5, 0.5, value)])
        self.assertEqual(cover.mesh(SQUARE, SEGMENTS, [(0.5, 0.5, np.int64(7))]).material[0], 7)

    def test_requirements(self):
        thin = [(0, 0), (9, 0), (9, 1), (4.5, 0.4), (0, 1)]
        ring = [(k, (k + 1) % 5) for k in range(5)]
        with self.assertRaisesRegex(cover.RequirementNotMet, 'non-obtuse .*region 1') as caught:
            cover.mesh(thin, ring, require='non-obtuse')
        self.assertEqual(caught.exception.code, 302)
        self.assertGreater(caught.exception.mesh.report['overall']['obtuse'], 0)
        self.assertEqual(cover.mesh(thin, ring, require=['bound']).violations(), [])

    def test_options_without_effect(self):
        self.assertIn('the option max-angle does nothing: it counts with --method quality and --require max-angle only',
                      cover.mesh(SQUARE, SEGMENTS, REGIONS, method='almond', max_angle=95).notes)

    def test_paths(self):
        mesh = cover.mesh(SQUARE, SEGMENTS, REGIONS)
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(ValueError, 'zero byte'):
                mesh.save(f'{folder}/a.vtu\0.msh')
            odd = os.fsencode(folder) + b'/\xfe.poly'
            mesh.save(odd)
            for path in odd, *pathlib.Path(folder).iterdir():
                self.assertEqual(len(cover.mesh_file(path).triangles), len(mesh.triangles))

    def test_pictures_of_second_order(self):
        mesh = cover.mesh_file(Values.DATA / 'coax_arcs.json')
        with tempfile.TemporaryDirectory() as folder:
            for extension in 'svg', 'png':
                files = [pathlib.Path(f'{folder}/{order}.{extension}') for order in (1, 2)]
                for order, file in enumerate(files, 1):
                    mesh.save(file, order=order)
                self.assertNotEqual(*(file.read_bytes() for file in files))


class SizesByFunction(unittest.TestCase):
    RING = [(0, 1), (1, 2), (2, 3), (3, 0)]
    CORNERS = [(0, 0), (1, 0), (1, 1), (0, 1)]

    def mesh(self, function, **options):
        return cover.mesh(self.CORNERS, self.RING, size_field=function, split_interfaces=True, **options)

    def test_the_same_for_any_number_of_threads(self):
        meshes = [self.mesh(lambda x, y: 0.02 + 0.2 * abs(x - 0.5), threads=n) for n in (1, 2)]
        np.testing.assert_array_equal(*(m.points for m in meshes))
        points, triangles = meshes[0].points, meshes[0].triangles
        sides = np.linalg.norm(points[triangles] - points[np.roll(triangles, 1, axis=1)], axis=2).max(axis=1)
        middle = np.abs(points[triangles].mean(axis=1)[:, 0] - 0.5) < 0.05
        self.assertLess(sides[middle].max(), 0.06)
        self.assertGreater(sides.max(), 0.1)

    def test_what_it_raises_comes_out(self):
        def raises(x, y):
            raise KeyError('mine')
        with self.assertRaises(KeyError):
            self.mesh(raises)
        with self.assertRaises(TypeError):
            self.mesh(lambda x, y: None)
        with self.assertRaisesRegex(TypeError, 'given as size_field'):
            cover.mesh(self.CORNERS, self.RING, size=lambda x, y: 1)
        # No size there: nothing is asked.
        for function in (lambda x, y: math.nan), (lambda x, y: -.1):
            mesh = self.mesh(function)
            self.assertEqual(len(mesh.points), 4)
            self.assertRegex('; '.join(mesh.notes), "^the size field 'a function' asks for nothing: ")
        self.assertNotIn('asks for nothing', '; '.join(self.mesh(lambda x, y: .3 if x < .5 else math.nan).notes))


class Running(unittest.TestCase):
    POINTS, RING = polygon(4000)

    def test_progress(self):
        calls = []
        cover.mesh(self.POINTS, self.RING, progress=lambda *call: calls.append(call))
        self.assertTrue(calls)
        for stage, done, total in calls:
            self.assertIsInstance(stage, str)
            self.assertLessEqual(done, total)
        with self.assertRaisesRegex(TypeError, '^progress: 3 is no function'):
            cover.mesh(self.POINTS, self.RING, progress=3)

    def test_cancel(self):
        with self.assertRaises(cover.Cancelled) as caught:
            cover.mesh(self.POINTS, self.RING, progress=lambda *_: False)
        self.assertEqual(caught.exception.code, 300)

    def test_cancel_within_a_region(self):
        calls = []

        def progress(stage, done, total):
            calls.append((stage, done, total))
            return calls.count(('mesh', 0, total)) < 2 or not total
        with self.assertRaises(cover.Cancelled):
            cover.mesh(SQUARE, SEGMENTS[:6], split_interfaces=True, size=.002, progress=progress)
        self.assertEqual(calls[-1], calls[-2])

    def test_cancel_by_numpy(self):
        with self.assertRaises(cover.Cancelled):
            cover.mesh(self.POINTS, self.RING, progress=lambda *_: np.float64(1) < 0.5)

    def test_exception_in_callback(self):
        def progress(*_):
            raise KeyError('mine')
        with self.assertRaises(KeyError):
            cover.mesh(self.POINTS, self.RING, progress=progress)

    def test_ctrl_c(self):
        # A run of many seconds in a process of its own; what it prints is time of the processor.
        program = textwrap.dedent('''
            import os, signal, threading, time
            import cover
            import numpy as np
            n = 300
            x, y = np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, n))
            a = np.column_stack([x.ravel(), y.ravel()])
            points = np.vstack([a, a + (4e-4, 9e-4), [(-1, -1), (2, -1), (2, 2), (-1, 2)]])
            k, m = np.arange(n * n), 2 * n * n
            segments = np.vstack([np.column_stack([k, k + n * n]), [(m, m + 1), (m + 1, m + 2), (m + 2, m + 3), (m + 3, m)]])
            sent = []
            def progress(stage, done, total):
                if stage == 'mesh' and not sent:
                    sent.append(time.process_time())
                    os.kill(os.getpid(), signal.SIGINT)
            try:
                cover.mesh(points, segments, progress=progress)
            except KeyboardInterrupt:
                print('interrupted after', time.process_time() - sent[0])
            cover.mesh([(0, 0), (1, 0), (0, 1)], [(0, 1), (1, 2), (2, 0)])
            print('and on')
            ''')
        done = subprocess.run([sys.executable, '-c', program], text=True, timeout=100,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r'^interrupted after \S+\nand on\n$')
        self.assertLess(float(done.stdout.split()[2]), 5)

    def test_ctrl_c_while_klayout_reads(self):
        """KLayout's converter is ended with what waits for it."""
        with tempfile.TemporaryDirectory() as folder:
            tools = pathlib.Path(folder)
            (tools / 'a.oas').write_text('%SEMI-OASIS')
            (tools / 'strm2gds').write_text('#!/bin/sh\necho $$ >begun.tmp\n/bin/mv begun.tmp begun\nexec /bin/sleep 50\n')
            (tools / 'strm2gds').chmod(0o755)
            program = textwrap.dedent('''
                import os, pathlib, signal, threading, time
                import cover
                def interrupt():
                    while not pathlib.Path('begun').exists():
                        time.sleep(0.01)
                    sent.append(time.monotonic())
                    os.kill(os.getpid(), signal.SIGINT)
                sent = []
                threading.Thread(target=interrupt).start()
                try:
                    cover.mesh_file('a.oas')
                except KeyboardInterrupt:
                    print(time.monotonic() - sent[0])
                try:
                    os.kill(int(pathlib.Path('begun').read_text()), 0)
                except ProcessLookupError:
                    print('gone')
                ''')
            done = subprocess.run([sys.executable, '-c', program], cwd=folder, text=True, timeout=100,
                                  env={**os.environ, 'PATH': folder, 'TMPDIR': folder},
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stdout, r'^\S+\ngone\n$')
            self.assertLess(float(done.stdout.split()[0]), 1)
            self.assertEqual(list(tools.glob('.cover-oasis*')), [])

    def test_other_threads_go_on(self):
        ticks, done = [], threading.Event()

        def tick():
            while not done.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.001)
        ticker = threading.Thread(target=tick)
        ticker.start()
        start = time.monotonic()
        cover.mesh(self.POINTS, self.RING)
        end = time.monotonic()
        done.set()
        ticker.join()
        self.assertTrue([t for t in ticks if start < t < end])

    def test_other_threads_go_on_while_sizes_are_read(self):
        random = np.random.default_rng(1)
        rows = np.column_stack([random.random((100000, 2)), np.ones(100000)])
        ticks, done = [], threading.Event()

        def tick():
            while not done.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.001)
        with tempfile.TemporaryDirectory() as folder:
            np.savetxt(f'{folder}/sizes.csv', rows, delimiter=',')
            ticker = threading.Thread(target=tick)
            ticker.start()
            try:
                start = time.monotonic()
                cover.mesh([(0, 0), (1, 0), (0, 1)], [(0, 1), (1, 2), (2, 0)], size_field=f'{folder}/sizes.csv')
                end = time.monotonic()
            finally:
                done.set()
                ticker.join()
        # The mesh is a triangle or two: nearly all the time goes into the file.
        self.assertTrue([t for t in ticks if 0.1 < (t - start) / (end - start) < 0.6])

    def test_signals_are_seen_while_files_are_read(self):
        seen = []
        before = signal.signal(signal.SIGALRM, lambda *_: seen.append(time.monotonic()))
        random = np.random.default_rng(1)
        try:
            with tempfile.TemporaryDirectory() as folder:
                np.savetxt(f'{folder}/sizes.csv', np.column_stack([random.random((100000, 2)), np.ones(100000)]), delimiter=',')
                points = '\n'.join(f'{k} {x} {y}' for k, (x, y) in enumerate(random.random((1000000, 2)).tolist()))
                pathlib.Path(f'{folder}/broken.poly').write_text(f'1000000 2 0 0\n{points}\nnothing\n')

                def broken():
                    with self.assertRaisesRegex(cover.Error, 'nothing'):
                        cover.mesh_file(f'{folder}/broken.poly', threads=1)
                for read in broken, lambda: cover.mesh(self.POINTS, self.RING, size_field=f'{folder}/sizes.csv'):
                    seen.clear()
                    start = time.monotonic()
                    signal.setitimer(signal.ITIMER_REAL, 0.01)
                    read()
                    end = time.monotonic()
                    self.assertEqual(len(seen), 1)
                    self.assertLess((seen[0] - start) / (end - start), 0.9, end - start)
        finally:
            signal.signal(signal.SIGALRM, before)


if __name__ == '__main__':
    unittest.main()
