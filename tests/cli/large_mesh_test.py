#!/usr/bin/env python3
"""large_mesh_test.py PROGRAM SAMPLES [TEST...]: cover mesh: regions to the disk, tiles, meshes in parts."""
import json
import math
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import time

from cover_case import Case, PROGRAM, SAMPLES, SQUARE, main


def is_temporary(name):
    return re.search(r'(^|/)\.[^/]*\.tmp$', name) is not None


def wavy_cells(n, k):
    """n x n cells with wavy sides of k segments; no arcs, no periodic sides."""
    points, index, segments = [], {}, []

    def point(x, y):
        key = (round(x, 9), round(y, 9))
        if key not in index:
            index[key] = len(points)
            points.append(key)
        return index[key]
    for i in range(n + 1):
        for j in range(n):
            wave = [0.06 * math.sin(2 * math.pi * t / k) * (0 < i < n) for t in range(k + 1)]
            for t in range(k):
                segments.append((point(i + wave[t], j + t / k), point(i + wave[t + 1], j + (t + 1) / k)))
                segments.append((point(j + t / k, i + wave[t]), point(j + (t + 1) / k, i + wave[t + 1])))
    text = f'{len(points)} 2 0 0\n' + ''.join(f'{p} {x!r} {y!r}\n' for p, (x, y) in enumerate(points))
    text += f'{len(segments)} 1\n' + ''.join(f'{s} {a} {b} {s % 3}\n' for s, (a, b) in enumerate(segments))
    return text + '0\n'


class Stream(Case):
    """A mesh that is never held: the same files, the same verdict."""
    def both(self, *words):
        """Files and what is said, in memory and from the disk."""
        found = []
        for when in ('off', 'on'):
            out, _ = self.run_cover(*words, '--stream', when)
            written = {name: (self.dir / name).read_bytes() for name in self.files()}
            found.append((re.sub(r'(?m)^Time .*', '', out), written))
        return found

    def test_the_same_bytes(self):
        device = self.plain()
        for more in ((), ('--method', 'almond', '-j', 3), ('--ids', 'region', '--no-inner-lines', '--size', 0.3)):
            for msh in ('2.2', '4.1'):
                held, streamed = self.both('mesh', device, '-o', 'a.vtu', '-o', 'a.vtkhdf', '-o', 'a.msh', '--msh', msh, *more)
                self.assertEqual(held[0], streamed[0])
                self.assertEqual(set(held[1]), {'a.vtu', 'a.vtkhdf', 'a.msh', 'plain.poly'})
                for name in held[1]:
                    self.assertTrue(held[1][name] == streamed[1][name], (name, more))

    def test_the_same_bytes_in_hdf5(self):
        held, streamed = self.both('mesh', self.plain(), '-o', 'a.xdmf', '--xdmf', 'hdf5', '--ids', 'region')
        self.assertEqual(set(held[1]), {'a.xdmf', 'a.h5', 'plain.poly'})
        self.assertEqual(held, streamed)
        self.assertIn(b'Format="HDF">a.h5:/mesh/topology<', held[1]['a.xdmf'])
        self.run_cover('check', 'plain.poly', 'a.xdmf')
        # Text has to be held, and says the same.
        self.run_cover('mesh', 'plain.poly', '-o', 't.xdmf', '--ids', 'region', '-q')
        for name in ('a', 't'):
            self.run_cover('convert', f'{name}.xdmf', '-o', f'{name}.vtu')
        self.assertEqual((self.dir / 'a.vtu').read_bytes(), (self.dir / 't.vtu').read_bytes())
        self.assertIn("'x' is not one of text, hdf5", self.run_cover('mesh', 'plain.poly', '-o', 'b.xdmf', '--xdmf', 'x', code=2)[1])

    def test_xdmf_without_its_numbers(self):
        self.run_cover('mesh', self.plain(), '-o', 'a.xdmf', '--xdmf', 'hdf5', '-q')
        whole = (self.dir / 'a.h5').read_bytes()
        text = (self.dir / 'a.xdmf').read_text()
        (self.dir / 'a.h5').write_bytes(whole[:len(whole) // 2])
        self.assertIn('a.h5', self.run_cover('check', 'plain.poly', 'a.xdmf', code=5)[1])
        (self.dir / 'a.h5').unlink()
        self.assertIn('a.h5', self.run_cover('check', 'plain.poly', 'a.xdmf', code=5)[1])
        self.write('a.xdmf', text.replace('a.h5:', '../a.h5:'))
        self.assertIn('beside the XML', self.run_cover('check', 'plain.poly', 'a.xdmf', code=5)[1])

    def test_the_same_report(self):
        def figures():
            report = json.loads((self.dir / 'r.json').read_text())
            report.pop('times', None)
            for region in report['regions']:
                region.pop('seconds', None)
            return report
        device = self.plain()
        self.run_cover('mesh', device, '-o', 'a.vtu', '--report', 'r.json', '--stream', 'off')
        held = figures()
        self.run_cover('mesh', device, '-o', 'a.vtu', '--report', 'r.json', '--stream', 'on')
        self.assertEqual(held, figures())

    def plain(self):
        return self.write('plain.poly', wavy_cells(6, 5))

    def test_what_needs_the_whole_mesh_is_told(self):
        device = self.plain()
        for words, what in ((('-o', 'a.svg'), 'a file in .svg'), (('-o', 'a.vtm'), 'a file in .vtm'),
                            (('-o', 'a.vtu', '--report', 'r.html'), 'a report that shows the mesh'),
                            (('-o', 'a.vtu', '--order', 2), 'triangles of second order'),
                            (('-o', 'a.vtu', '--split-interfaces', 95), 'cutting segments after meshing'),
                            (('-o', 'a.vtu', '--method', 'nonobtuse'), 'method nonobtuse'),
                            (('-o', '-'), 'writing to standard output')):
            _, err = self.run_cover('mesh', device, *words, '--stream', 'on', code=2)
            self.assertIn(f'--stream on: the whole mesh is needed in memory for {what}', err)
        self.assertEqual(self.files(), ['plain.poly'])

    def test_check_says_the_same(self):
        device = self.plain()
        for mesh in ('a.vtu', 'a.vtkhdf'):
            self.run_cover('mesh', device, '-o', mesh, '-q')
            held, streamed = (self.run_cover('check', device, mesh, '--stream', when)[0] for when in ('off', 'on'))
            self.assertIn('Every promise holds', held)
            self.assertEqual(held, streamed)
        self.write('other.poly', SQUARE)
        held, streamed = (self.run_cover('check', 'other.poly', 'a.vtu', '--stream', when, code=6)[0] for when in ('off', 'on'))
        self.assertIn('FAILED', held)
        self.assertEqual(held, streamed)

    def test_a_full_disk(self):
        """An error, and the old file stays."""
        device = self.plain()
        self.write('a.vtu', 'old')
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))
        done = subprocess.run([PROGRAM, 'mesh', device, '-o', 'a.vtu', '--stream', 'on'], cwd=self.dir, text=True,
                              preexec_fn=limit, capture_output=True, timeout=60)
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertIn('cannot write a.vtu', done.stderr)
        self.assertEqual((self.dir / 'a.vtu').read_text(), 'old')
        self.assertEqual(self.files(), ['a.vtu', 'plain.poly'])


class Killed(Case):
    """kill -9 at any moment: names stand for whole files, old or new ones, and the next run leaves nothing else.
    COVER_KILLS in the environment: how many times for each format; COVER_KILL_CELLS: of a side of the drawing."""
    KILLS, CELLS = (int(os.environ.get(name, usual)) for name, usual in (('COVER_KILLS', 6), ('COVER_KILL_CELLS', 12)))

    def state(self):
        """By name, folders and all; but for what has a temporary name, and the drawing."""
        found = {p.relative_to(self.dir).as_posix(): p.read_bytes() for p in self.dir.rglob('*') if p.is_file()}
        return {name: found[name] for name in found if not is_temporary(name) and name != 'plain.poly'}

    def temporary(self):
        return [p for p in self.dir.rglob('*') if is_temporary(p.relative_to(self.dir).as_posix())]

    def kill_once(self, mesh, moment, at_writing):
        with subprocess.Popen([PROGRAM, *mesh], cwd=self.dir) as run:
            if at_writing:
                while not self.temporary() and run.poll() is None:
                    time.sleep(0.001)
                moment *= 0.1
            time.sleep(moment)
            run.kill()
        return run.returncode != 0

    def each_kill(self, seed, *words):
        mesh = ['mesh', self.write('plain.poly', wavy_cells(self.CELLS, 5)), '-q', *map(str, words)]
        self.run_cover(*mesh, '--size', 0.15)
        old = self.state()
        start = time.monotonic()
        self.run_cover(*mesh)
        took = time.monotonic() - start
        new = self.state()
        main = words[1] if words[1] in new else min(new)  # the file that names others, if one does
        self.assertTrue(old[main] != new[main], main)
        dice, killed = random.Random(repr(seed)), 0
        for k in range(self.KILLS):
            for name in self.state().keys() - old.keys():
                (self.dir / name).unlink()
            for name, content in old.items():
                (self.dir / name).write_bytes(content)
            killed += self.kill_once(mesh, dice.uniform(0, took), k % 2 == 1)
            now = self.state()
            for name, content in now.items():
                self.assertTrue(content in (old.get(name), new.get(name)), (name, words))
            self.assertIn(main, now)
            if main.endswith(('.vtm', '.pvtu')):  # pieces have names of their own
                whole = old if now[main] == old[main] else new
                self.assertLessEqual(whole.keys(), now.keys(), words)
        self.assertGreater(killed, 0)
        self.run_cover(*mesh)
        self.assertEqual(sorted(self.state()), sorted(new))
        self.assertTrue(self.state() == new, words)
        self.assertEqual(self.temporary(), [])

    def test_streams(self):
        for words in (('a.vtu',), ('a.vtkhdf',), ('a.msh', '--msh', '2.2'), ('a.msh', '--msh', '4.1'),
                      ('a.xdmf', '--xdmf', 'hdf5'), ('a.vtu', '-o', 'a.vtkhdf', '-o', 'a.msh')):
            with self.subTest(words):
                self.each_kill(words, '-o', *words, '--stream', 'on')
                self.clear()

    def test_meshes_in_memory(self):
        for words in (('a.vtu',), ('a.vtkhdf',), ('a.msh',), ('a.xdmf', '--xdmf', 'hdf5'), ('a.vtm',), ('a.svg',),
                      ('a.pvtu', '--parts', 2), ('a.msh', '--msh', '4.1', '--parts', 2)):
            with self.subTest(words):
                self.each_kill(words, '-o', *words, '--stream', 'off')
                self.clear()

    def clear(self):
        for path in self.dir.iterdir():
            shutil.rmtree(path) if path.is_dir() else path.unlink()


class Tiles(Case):
    """Several input files are one geometry."""
    def square(self, x, material):
        ring = [[x, 0], [x + 1, 0], [x + 1, 1], [x, 1], [x, 0]]
        return {'type': 'Feature', 'properties': {'material': material},
                'geometry': {'type': 'Polygon', 'coordinates': [ring]}}

    def collect(self, name, *features):
        return self.write(name, json.dumps({'type': 'FeatureCollection', 'features': features}))

    def test_as_one_file_with_all_of_it(self):
        squares = [self.square(0, 'a'), self.square(0.5, 'b'), self.square(1.5, 'c')]
        tiles = [self.collect(f'tile_{k}.geojson', square) for k, square in enumerate(squares)]
        self.collect('all.geojson', *squares)
        out, _ = self.run_cover('mesh', *tiles, '-o', 'tiles.vtu')
        self.assertIn('3 regions', out)
        self.run_cover('mesh', 'all.geojson', '-o', 'all.vtu')
        self.assertEqual((self.dir / 'tiles.vtu').read_bytes(), (self.dir / 'all.vtu').read_bytes())
        self.run_cover('mesh', *reversed(tiles), '-o', 'reversed.vtu')
        self.assertNotEqual((self.dir / 'tiles.vtu').read_bytes(), (self.dir / 'reversed.vtu').read_bytes())
        self.assertIn('3 regions', self.run_cover('info', *tiles)[0])

    def test_of_several_kinds(self):
        self.collect('a.geojson', self.square(0, 'a'))
        self.write('b.json', json.dumps({'polygons': [{'material': 'b', 'rings': [[[1, 0], [2, 0], [2, 1], [1, 1]]]}]}))
        self.assertIn('2 regions', self.run_cover('mesh', 'a.geojson', 'b.json', '-o', 'm.vtu')[0])

    def test_maps_of_two_systems_are_refused(self):
        def system(name):
            return {'crs': {'type': 'name', 'properties': {'name': name}}}
        self.write('a.geojson', json.dumps({**self.square(0, 'a'), **system('urn:ogc:def:crs:OGC:1.3:CRS84')}))
        self.write('b.geojson', json.dumps({**self.square(500000, 'b'), **system('urn:ogc:def:crs:EPSG::25832')}))
        err = self.run_cover('mesh', 'a.geojson', 'b.geojson', '-o', 'm.vtu', code=2)[1]
        self.assertIn('a.geojson and b.geojson cannot be taken together: their coordinates are in different systems, '
                      'EPSG:4326 and EPSG:25832', err)
        self.assertIn("'ogr2ogr -t_srs EPSG:25832 OUT.geojson a.geojson'", err)

    def test_fields_are_asked_of_all_files_together(self):
        self.write('parcels.geojson', json.dumps({'type': 'Feature', 'properties': {'use': 'field', 'nr': 7},
                                                  'geometry': self.square(0, '')['geometry']}))
        self.write('river.geojson', json.dumps({'type': 'Feature', 'properties': {'name': 'Rhine'},
                                                'geometry': {'type': 'LineString', 'coordinates': [[0, 0.5], [1, 0.5]]}}))
        self.write('wells.geojson', json.dumps({'type': 'MultiPoint', 'coordinates': [[0.25, 0.25], [0.75, 0.6875]]}))
        files = ['river.geojson', 'wells.geojson', 'parcels.geojson']
        self.run_cover('mesh', *files, '--material-field', 'use', '--keep-field', 'nr', '-o', 'm.vtm', '-o', 'm.json', '-o', 'm.poly')
        text = (self.dir / 'm.json').read_text()
        self.assertIn('"field"', text)
        self.assertIn('"Rhine"', text)
        self.write('far.geojson', json.dumps({'type': 'Point', 'coordinates': [3, 3]}))
        self.assertIn('1 point lies in the void and is left out, the first at (3, 3)',
                      self.run_cover('mesh', 'parcels.geojson', 'far.geojson', '-o', 'f.vtu')[1])
        self.assertRegex((self.dir / 'm.poly').read_text(), r'(?s)0\.25 0\.25\b.*0\.75 0\.6875\b')
        err = self.run_cover('mesh', *files, '--material-field', 'usage', '-o', 'm.vtu', code=2)[1]
        self.assertRegex(err, "--material-field: river.geojson: no feature has the property 'usage'.*; parcels.geojson: "
                              "no feature has the property 'usage'")
        self.run_cover('mesh', 'river.geojson', '--material-field', 'use', '-o', 'm.vtu', code=2)

    def test_faults_name_the_file(self):
        self.collect('a.geojson', self.square(0, 'a'))
        self.assertIn('none.geojson', self.run_cover('mesh', 'a.geojson', 'none.geojson', '-o', 'm.vtu', code=5)[1])
        self.write('b.json', json.dumps({'unit': 'nm', 'polygons': [{'material': 'b', 'rings': [[[1, 0], [2, 0], [2, 1]]]}]}))
        self.assertIn('units', self.run_cover('mesh', 'a.geojson', 'b.json', '-o', 'm.vtu', code=2)[1])
        self.assertIn('would replace the input',
                      self.run_cover('mesh', 'a.geojson', 'b.json', '-o', 'b.json', code=2)[1])


class Parts(Case):
    """A mesh divided for processes."""
    READ = """
import sys
from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader
reader = vtkXMLPUnstructuredGridReader()
reader.SetFileName(sys.argv[1])
reader.UpdateInformation()
seen = []
for part in range(3):
    reader.UpdatePiece(part, 3, 0)
    grid = reader.GetOutput()
    cells = grid.GetCellData()
    ghost, ids, owner = (cells.GetArray(name) for name in ('vtkGhostType', 'GlobalCellId', 'Owner'))
    for k in range(grid.GetNumberOfCells()):
        assert (ghost.GetValue(k) == 0) == (owner.GetValue(k) == part)
        if ghost.GetValue(k) == 0:
            seen.append(ids.GetValue(k))
assert sorted(seen) == list(range(len(seen)))
print(len(seen))
"""

    def test_vtk_reads_every_triangle_once(self):
        report = ('--report', 'r.json', '-q')
        self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.pvtu', '--parts', 3, '-j', 1, *report)
        pieces = {p.name: p.read_bytes() for p in (self.dir / 'd.parts').iterdir()}
        self.assertEqual(len(pieces), 3)
        self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.pvtu', '--parts', 3, '-j', 3, *report)
        self.assertEqual(pieces, {p.name: p.read_bytes() for p in (self.dir / 'd.parts').iterdir()})
        triangles = json.loads((self.dir / 'r.json').read_text())['overall']['triangles']
        for python in (sys.executable, '/usr/bin/python3'):
            if subprocess.run([python, '-c', 'import vtkmodules'], capture_output=True).returncode == 0:
                break
        else:
            self.skipTest('no Python with VTK')
        done = subprocess.run([python, '-c', self.READ, 'd.pvtu'], cwd=self.dir, capture_output=True, text=True)
        self.assertEqual(done.stdout.strip(), str(triangles), done.stderr)

    @staticmethod
    def sections(text):
        """The words of each section of a .msh."""
        return {name: body.split() for name, body in re.findall(r'(?s)\$(\w+)\n(.*?)\$End\1\n', text)}

    @staticmethod
    def elements(words):
        """By element: its entity and its nodes."""
        words = list(map(int, words))
        blocks, count, at, found = words[0], words[1], 4, {}
        for _ in range(blocks):
            dimension, tag, kind, number = words[at:at + 4]
            at += 4
            size = {1: 2, 2: 3}[kind]
            for _ in range(number):
                assert words[at] not in found
                found[words[at]] = ((dimension, tag), tuple(words[at + 1:at + 1 + size]))
                at += 1 + size
        assert len(found) == count and at == len(words)
        return found

    def test_gmsh_gets_every_element(self):
        mesh = ('mesh', SAMPLES / 'diode.poly', '-q', '--msh', '4.1')
        self.run_cover(*mesh, '-o', 'whole.msh')
        whole = self.elements(self.sections((self.dir / 'whole.msh').read_text())['Elements'])
        self.run_cover(*mesh, '-o', 'd.msh', '--parts', 3, '-j', 1)
        names = ['d_1.msh', 'd_2.msh', 'd_3.msh']
        self.assertEqual([name for name in self.files() if name.startswith('d')], names)
        once = [(self.dir / name).read_bytes() for name in names]
        self.run_cover(*mesh, '-o', 'd.msh', '--parts', 3, '-j', 3)
        self.assertEqual(once, [(self.dir / name).read_bytes() for name in names])
        owned, lines, tags = {}, set(), set()
        for part, name in enumerate(names, 1):
            found = self.sections((self.dir / name).read_text())
            words = found['PartitionedEntities']
            self.assertEqual((words[0], words[1], words[3]), ('3', '1', str(part)))
            ghost_entity = (2, int(words[2]))
            numbers = list(map(int, found['GhostElements']))
            ghosts = {e: owner for e, owner, count, to in zip(*[iter(numbers[1:])] * 4) if (count, to) == (1, part)}
            self.assertEqual(len(ghosts), numbers[0])
            nodes = set(map(int, found['Nodes'][8:8 + int(found['Nodes'][1])]))
            for number, (entity, corners) in self.elements(found['Elements']).items():
                self.assertEqual(corners, whole[number][1])
                self.assertLessEqual(set(corners), nodes)
                self.assertEqual(entity == ghost_entity, number in ghosts)
                if len(corners) == 2:
                    lines.add(number)
                elif number not in ghosts:
                    self.assertNotIn(number, owned)
                    owned[number] = part
            tags_here = {entity for entity, _ in self.elements(found['Elements']).values()}
            self.assertFalse(tags & tags_here)
            tags |= tags_here
        for name in names:
            numbers = list(map(int, self.sections((self.dir / name).read_text())['GhostElements']))
            for element, owner in zip(numbers[1::4], numbers[2::4]):
                self.assertEqual(owned[element], owner)
        self.assertEqual(set(owned) | lines, set(whole))
        for words in (('check', SAMPLES / 'diode.poly', 'd_2.msh'), ('convert', 'd_2.msh', '-o', 'part.vtu')):
            _, err = self.run_cover(*words, code=5 if words[0] == 'check' else 0)
            self.assertIn('is one of 3 files of a mesh', err)

    def test_parts_of_a_mesh_in_more_parts_go(self):
        mesh = ('mesh', SAMPLES / 'diode.poly', '-o', 'd.msh', '--msh', '4.1', '-q', '--parts')
        self.run_cover(*mesh, 5)
        self.write('d_7.msh', '$MeshFormat\n')  # no part of it
        self.run_cover(*mesh, 2)
        self.assertEqual(self.files(), ['d_1.msh', 'd_2.msh', 'd_7.msh'])
        self.write('d_3.msh', 'somebody else\'s')
        self.run_cover(*mesh, 2)
        self.assertEqual(self.files(), ['d_1.msh', 'd_2.msh', 'd_3.msh', 'd_7.msh'])

    def test_other_formats_beside_parts_are_whole(self):
        self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '-o', 'd.pvtu', '-o', 'd.msh', '--msh', '4.1', '--parts', 2)
        self.assertEqual(self.files(), ['d.parts', 'd.pvtu', 'd.vtu', 'd_1.msh', 'd_2.msh'])
        self.assertIn('Every promise holds', self.run_cover('check', SAMPLES / 'diode.poly', 'd.vtu')[0])
        self.assertIn('version 4.1', self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'e.pvtu', '-o', 'e.msh', '--parts', 2, code=2)[1])

    def test_only_where_the_format_has_parts(self):
        self.assertIn('version 4.1', self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.msh', '--parts', 2, code=2)[1])
        self.assertIn('in parts', self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '--parts', 2, code=2)[1])
        files = self.files()
        self.assertIn('in parts: periodic sides', self.run_cover('mesh', SAMPLES / 'motor_pole.json', '-o', 'p.pvtu', '-o', 'p.msh',
                                                                 '--msh', '4.1', '--parts', 2, code=2)[1])
        self.assertEqual(self.files(), files)  # nothing is written before that is told
        self.assertIn('--parts: 0 is not at least 1', self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.pvtu', '--parts', 0, code=2)[1])
        self.assertEqual(self.files(), [])


if __name__ == '__main__':
    main()
