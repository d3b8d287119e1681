#!/usr/bin/env python3
"""cli_test.py PROGRAM SAMPLES [TEST...]: the program as a user meets it: exit codes, messages, files."""
import json
import math
import os
import pathlib
import pty
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from xml.etree import ElementTree

PROGRAM, SAMPLES = sys.argv[1], pathlib.Path(sys.argv[2])
APP = SAMPLES.parent.parent / 'apps/cover'

SQUARE = '4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n'


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.dir = pathlib.Path(folder.name)

    def run_cover(self, *words, code=0, stdin=None):
        """Runs the program in the folder of this test; returns stdout and stderr."""
        done = subprocess.run([PROGRAM, *map(str, words)], cwd=self.dir, input=stdin, text=True, timeout=60,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, code, f'{words}\n{done.stdout}\n{done.stderr}')
        return done.stdout, done.stderr

    def write(self, name, text):
        (self.dir / name).write_text(text)
        return name

    def files(self):
        return sorted(p.name for p in self.dir.iterdir())


class Usage(Case):
    def test_no_command(self):
        self.assertIn('Usage: cover', self.run_cover(code=2)[1])

    def test_help_of_every_command(self):
        self.assertIn('Commands:', self.run_cover('--help')[0])
        for command in ('mesh', 'info', 'check', 'render', 'convert'):
            text = self.run_cover(command, '--help')[0]
            self.assertIn('Example', text)
            self.assertLess(max(map(len, text.splitlines())), 121, command)
            self.assertEqual(self.run_cover('help', command)[0], text)

    def test_version(self):
        self.assertRegex(self.run_cover('--version')[0], r'^cover \d+\.\d+\.\d+\n.*GPL')

    def test_misspelt_command(self):
        self.assertEqual(self.run_cover('msh', code=2)[1].splitlines()[0],
                         "cover: error: unknown command 'msh'; did you mean 'mesh'?")

    def test_misspelt_option(self):
        error = self.run_cover('mesh', 'a.poly', '-o', 'a.vtu', '--fil=disks', code=2)[1]
        self.assertIn("unknown option '--fil=disks'; did you mean '--fill'?", error)

    def test_misspelt_word(self):
        error = self.run_cover('mesh', 'a.poly', '-o', 'a.vtu', '--fill', 'disk', code=2)[1]
        self.assertIn("'disk' is not one of refine, disks; did you mean 'disks'?", error)

    def test_number_out_of_range(self):
        for option, bad, message in (('max-angle', (20, 60, 180, 'nan'), 'above 60 and below 180'),
                                     ('min-angle', (-1, 60), 'at least 0 and below 60'),
                                     ('split-interfaces', (59, 180), 'at least 60 and below 180'),
                                     ('growth', (1, 'inf'), 'above 1')):
            for value in bad:
                err = self.run_cover('mesh', 'a.poly', '-o', 'a.vtu', f'--{option}={value}', code=2)[1]
                self.assertIn(f'--{option}: {value} is not {message}\n', err)
        self.assertIn('none.poly', self.run_cover('mesh', 'none.poly', '-o', 'a.vtu', '--split-interfaces=60', '--min-angle=0',
                                                  '--growth=200', '--max-angle=60.01', code=5)[1])

    def test_an_option_that_takes_the_input_for_its_number(self):
        err = self.run_cover('mesh', '--split-interfaces', 'a.poly', '-o', 'a.vtu', code=2)[1]
        self.assertIn("--split-interfaces: 'a.poly' is not a number; before a file, write it with '='", err)

    def test_nothing_to_do(self):
        self.assertIn('no input file', self.run_cover('mesh', '-o', 'a.vtu', code=2)[1])
        self.assertIn('nothing to write', self.run_cover('mesh', 'a.poly', code=2)[1])

    def test_unknown_output_format(self):
        error = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'a.xyz', code=2)[1]
        self.assertIn("unknown format '.xyz'; possible are .vtu", error)
        self.assertEqual(self.files(), [])


class Periodic(Case):
    CELL = {'points': [[0, 0], [2, 0], [2, 1], [0, 1]],
            'segments': [[0, 1], {'points': [1, 2], 'name': 'right'}, [2, 3], {'points': [3, 0], 'name': 'left=1'}]}

    def setUp(self):
        super().setUp()
        self.write('cell.json', json.dumps(self.CELL))

    def test_what_cuts_one_side_cuts_the_other(self):
        out, _ = self.run_cover('mesh', 'cell.json', '--periodic', '"left=1"=right', '--split-interfaces', '--size', '0.3',
                                '--size-at', 'right=0.1', '-o', 'a.msh', '-o', 'a.json', '-o', 'a.vtk')
        self.assertRegex(out, r"Periodic +\d+  pairs of vertices on 'left=1' and 'right'")
        rule, = json.loads((self.dir / 'a.json').read_text())['periodic']
        self.assertGreater(len(rule['vertices']), 8)
        self.assertEqual(len(rule['edges']), len(rule['vertices']) - 1)
        self.assertIn('$Periodic', (self.dir / 'a.msh').read_text())
        self.assertIn('SCALARS PeriodicNode', (self.dir / 'a.vtk').read_text())
        self.assertIn('none without a partner', self.run_cover('check', 'cell.json', 'a.vtk', '--periodic', '"left=1"=right')[0])
        self.run_cover('convert', 'a.vtk', '-o', 'b.msh')
        self.assertIn('$Periodic', (self.dir / 'b.msh').read_text())

    def test_check_finds_vertices_without_a_partner(self):
        self.run_cover('mesh', 'cell.json', '--split-interfaces', '--size-at', 'right=0.1', '-o', 'a.vtu')
        out, _ = self.run_cover('check', 'cell.json', 'a.vtu', '--allow-split', '--periodic', '"left=1"=right', code=6)
        self.assertRegex(out, r"FAILED periodic 'left=1' and 'right': \d+ points without a partner, the first at \(2, ")

    def test_in_the_input(self):
        self.write('cell.json', json.dumps({**self.CELL, 'periodic': [['left=1', 'right']]}))
        self.run_cover('mesh', 'cell.json', '-o', 'a.vtu', '--box-method')
        self.assertIn('Periodic: 2 pairs', self.run_cover('check', 'cell.json', 'a.vtu')[0])

    def test_what_cannot_be_is_refused_and_nothing_is_written(self):
        for rule, what in (('"left=1"=rihgt', "did you mean 'right'?"),
                           ('right=right', 'a line cannot be taken to itself'),
                           ('"left=1"=right@0,0:360', 'takes every line to itself'),
                           ('"left=1"=right@0,0:20', 'the lines do not match: (0, 1) of'),
                           ('left', "'left' is not A=B, A=B@x,y:degrees or A=B@mirror")):
            self.assertIn(what, self.run_cover('mesh', 'cell.json', '--periodic', rule, '-o', 'a.vtu', code=2)[1])
        self.assertIn('periodic needs another method', self.run_cover(
            'mesh', 'cell.json', '--periodic', '"left=1"=right', '--method', 'nonobtuse', '-o', 'a.vtu', code=2)[1])
        self.assertEqual(self.files(), ['cell.json'])


class Arcs(Case):
    CUT = ['--split-interfaces=150', '--size', '0.3']

    def test_cuts_and_middle_nodes_lie_on_arcs(self):
        coax = SAMPLES / 'coax_arcs.json'
        out, _ = self.run_cover('mesh', coax, *self.CUT, '--order', '2', '-o', 'a.msh', '-o', 'a.json', '--report', 'r.json')
        self.assertRegex(out, r'On arcs +\d+  edges; with --order 2 the area is 9\.42')
        area, = (a['area'] for a in json.loads((self.dir / 'r.json').read_text())['arcs']['areas'])
        self.assertLess(abs(area / (3 * math.pi) - 1), 1e-4)
        arcs = json.loads((self.dir / 'a.json').read_text())['arcs']
        self.assertEqual([a['radius'] for a in arcs], [1, 2])
        out, _ = self.run_cover('check', coax, 'a.msh')
        self.assertRegex(out, r'Segments are cut at \d+ points, those of arcs on their circles: --split-interfaces 150')
        self.assertRegex(out, r'every Jacobian is positive everywhere; \d+ edges lie on arcs\n')
        # Kept by files: converted, the arcs are there again.
        self.run_cover('mesh', coax, *self.CUT, '-o', 'b.vtk', '-o', 'b.json', '-q')
        self.run_cover('convert', 'b.vtk', '-o', 'c.msh', '--order', '2')
        self.assertIn('edges lie on arcs', self.run_cover('check', coax, 'c.msh', '--allow-split')[0])

    def test_check_refuses_what_is_off_its_arc(self):
        coax = SAMPLES / 'coax_arcs.json'
        self.run_cover('mesh', coax, *self.CUT, '--order', '2', '-o', 'a.vtk', '-o', 'a.json', '-q')
        lines = (self.dir / 'a.vtk').read_text().splitlines()
        corners = json.loads((self.dir / 'a.json').read_text())['counts']['vertices']
        first = next(k for k, line in enumerate(lines) if line.startswith('POINTS')) + 1
        moved = next(k for k in range(first + corners, len(lines))
                     if abs(math.hypot(*map(float, lines[k].split()[:2])) - 2) < 1e-12)
        x, y = map(float, lines[moved].split()[:2])
        lines[moved] = f'{x * 0.9999!r} {y * 0.9999!r} 0'
        self.write('a.vtk', '\n'.join(lines) + '\n')
        self.assertIn('FAILED second order: the middle node', self.run_cover('check', coax, 'a.vtk', code=6)[0])

    def test_ends_off_the_circle_are_refused(self):
        self.write('a.json', json.dumps({'points': [[1, 0], [0, 1.1]], 'segments': [
            {'points': [0, 1], 'arc': {'centre': [0, 0], 'chords': 4}}, [0, 1]]}))
        self.assertIn('are not equally far from the centre: 1 and 1.1', self.run_cover('mesh', 'a.json', '-o', 'a.vtu', code=5)[1])
        self.assertEqual(self.files(), ['a.json'])


class Mesh(Case):
    def test_mesh_report_and_picture(self):
        out, _ = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '-o', 'd.svg', '--report', 'd.json')
        self.assertEqual(self.files(), ['d.json', 'd.svg', 'd.vtu'])
        self.assertIn('Proven bound    held in every region', out)
        self.assertRegex(out, r'lowest  proven  reached  smallest ')
        self.assertIn('170-180', out)
        for name in self.files():
            self.assertIn('Wrote ' + name, out)
        report = json.loads((self.dir / 'd.json').read_text())
        self.assertEqual(len(report['regions']), 4)
        self.assertEqual(sum(r['triangles'] for r in report['regions']), report['mesh']['triangles'])
        self.assertTrue(all(r['bound_held'] for r in report['regions']))
        self.run_cover('check', SAMPLES / 'diode.poly', 'd.vtu')

    def test_same_bytes_for_any_number_of_threads(self):
        for threads in (1, 2, 8):
            self.run_cover('mesh', SAMPLES / 'coax.poly', '-o', f'{threads}.vtu', '-j', threads, '-q')
        one = (self.dir / '1.vtu').read_bytes()
        self.assertEqual(one, (self.dir / '2.vtu').read_bytes())
        self.assertEqual(one, (self.dir / '8.vtu').read_bytes())

    def test_nonobtuse_says_how_many_are_above_90(self):
        out, _ = self.run_cover('mesh', SAMPLES / 'coax.poly', '-o', 'd.vtu', '--report', 'd.json', '--method', 'nonobtuse')
        overall = json.loads((self.dir / 'd.json').read_text())['overall']
        self.assertGreater(overall['obtuse'], 0)
        self.assertLess(overall['largest_angle'], 90.1)
        rounded = f"{overall['obtuse_by_rounding']:,}"
        self.assertRegex(out, rf"\nAbove 90 +{overall['obtuse']}  obtuse triangles; {rounded} more by no more than rounding of coordinates\n")

    def test_several_formats(self):
        self.run_cover('mesh', SAMPLES / 'diode.poly', '-q', '--order', 2, '--msh', '4.1', '--no-inner-lines',
                       *(word for e in ('msh', 'xdmf', 'mesh', 'inp', 'ele', 'vtk') for word in ('-o', f'd.{e}')))
        self.assertEqual(self.files(), ['d.edge', 'd.ele', 'd.inp', 'd.mesh', 'd.msh', 'd.node', 'd.vtk', 'd.xdmf'])
        self.assertIn('4.1 0 8', (self.dir / 'd.msh').read_text())

    def test_options_before_the_input(self):
        self.run_cover('mesh', '--size', 1, '--size', '2=0.5', '--require', 'bound', SAMPLES / 'diode.poly', '-o', 'd.vtu', '-q')
        text, _ = self.run_cover('mesh', '--size', 1, '--size', '2=0.5', SAMPLES / 'diode.poly', '-o', 'e.vtu', '--print-config')
        self.write('job.toml', text)
        self.run_cover('mesh', '--config', 'job.toml', '-q')
        self.assertEqual((self.dir / 'd.vtu').read_bytes(), (self.dir / 'e.vtu').read_bytes())

    def test_never_overwrites_its_input(self):
        poly = (SAMPLES / 'diode.poly').read_bytes()
        (self.dir / 'd.poly').write_bytes(poly)
        (self.dir / 'd.node').write_text('points')
        for out in ('d.poly', './d.poly', 'd.ele'):
            err = self.run_cover('mesh', 'd.poly', '-o', out, code=2)[1]
            self.assertIn('would replace the input', err)
        self.assertEqual((self.dir / 'd.poly').read_bytes(), poly)
        self.assertEqual((self.dir / 'd.node').read_text(), 'points')

    def test_tells_the_numbers_in_the_files(self):
        out, _ = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.msh', '-o', 'd.json')
        numbers = dict(re.findall(r'^ +(\d+)  (marker \d+|\S+_\S+)$', out.partition('Numbers in the files')[2], re.M))
        manifest = json.loads((self.dir / 'd.json').read_text())
        self.assertEqual({int(n): name.replace('marker ', '') for n, name in numbers.items()},
                         {g['tag']: g['original'] for g in manifest['line_groups']})
        self.assertRegex(out, r'\n +2 +1  material_1\n')
        self.assertNotIn('Numbers', self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu')[0])

    def test_quiet_says_nothing(self):
        self.assertEqual(self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '-q'), ('', ''))

    def test_options_that_do_nothing(self):
        def warnings(*words):
            return self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', *words)[1]
        self.assertIn('--max-angle does nothing', warnings('--method', 'almond', '--max-angle', 110))
        self.assertIn('--min-angle does nothing', warnings('--method', 'nonobtuse', '--min-angle', 10))
        self.assertIn('--fill does nothing', warnings('--method', 'quality', '--fill', 'disks'))
        for words in (['--fill', 'disks'], ['--max-angle', 110, '--min-angle', 10], ['--method', 'almond'],
                      ['--method', 'almond', '--max-angle', 170, '--require', 'max-angle']):
            self.assertEqual(warnings(*words), '', words)

    def test_missed_targets_are_told_with_v(self):
        flat = self.write('flat.poly', SQUARE.replace('2 1 0', '2 2 0').replace('3 1 1', '3 2 2').replace('4 0 1', '4 1 0.1'))
        for words, told in (((), False), (('-v',), True)):
            _, err = self.run_cover('mesh', flat, '-o', 'd.vtu', *words)
            self.assertEqual('above 100 degrees' in err, told, err)

    def test_verbose_and_log(self):
        _, err = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '-v', '--log', 'log')
        self.assertIn('cover: info: wrote d.vtu', err)
        self.assertIn('wrote d.vtu', (self.dir / 'log').read_text())

    def test_log_that_cannot_be_written(self):
        _, err = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '--log', SAMPLES / 'diode.poly/log', code=5)
        self.assertIn('diode.poly/log', err)

    def test_statistics_as_json(self):
        out, _ = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '--stats', 'json')
        self.assertEqual(json.loads(out)['format'], 'cover report')

    def test_meshes_of_vtk_come_through_pipes_and_in_capitals(self):
        self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '-o', 'd.vtk', '-q')
        mesh = (self.dir / 'd.vtu').read_bytes()
        (self.dir / 'D.VTU').write_bytes(mesh)
        self.run_cover('mesh', 'D.VTU', '-o', 'file.vtu', '-q')
        expected = (self.dir / 'file.vtu').read_bytes()
        for name in ('d.vtu', 'd.vtk'):
            done = subprocess.run([PROGRAM, 'mesh', '-', '-o', 'x.vtu', '-q'], cwd=self.dir, timeout=60,
                                  input=(self.dir / name).read_bytes(), stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.assertEqual((done.returncode, done.stderr), (0, b''))
            self.assertEqual((self.dir / 'x.vtu').read_bytes(), expected)
        os.mkfifo(self.dir / 'pipe')
        with subprocess.Popen([PROGRAM, 'mesh', 'pipe', '-o', 'y.vtu', '-q'], cwd=self.dir) as run:
            (self.dir / 'pipe').write_bytes(mesh)
            self.assertEqual(run.wait(60), 0)
        self.assertEqual((self.dir / 'y.vtu').read_bytes(), expected)

    def test_files_of_vtk_that_are_cut_off_say_so(self):
        self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '-q')
        mesh = (self.dir / 'd.vtu').read_bytes()
        for size in (0, 100, len(mesh) // 2, len(mesh) - 2000):
            (self.dir / 'cut.vtu').write_bytes(mesh[:size])
            for words in (('mesh', 'cut.vtu', '-o', 'x.vtu'), ('render', 'cut.vtu', '-o', 'x.svg')):
                _, err = self.run_cover(*words, code=5)
                self.assertIn('cut off', err)

    def test_stdin_to_stdout(self):
        done = subprocess.run([PROGRAM, 'mesh', '-', '-o', '-'], input=SQUARE.encode(), timeout=60,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout.startswith(b'<?xml') or done.stdout.startswith(b'<VTKFile'), done.stdout[:60])
        self.assertIn(b'largest angle', done.stderr.lower())

    def test_several_files_do_not_fit_into_stdout(self):
        for words in (['mesh', SAMPLES / 'diode.poly'], ['convert', 'd.vtu']):
            for name in ('vtm', 'ele'):
                _, err = self.run_cover(*words, '-o', '-', '--format', name, code=2)
                self.assertIn(f'.{name} is more than one file', err)
        for format, more, what in (('xdmf', ['--xdmf', 'hdf5'], 'with HDF5'), ('msh', ['--msh', '4.1', '--parts', '2'], 'in parts')):
            _, err = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', '-', '--format', format, *more, code=2)
            self.assertIn(f'.{format} {what} is more than one file', err)

    def test_clean_poly_meshes_the_same(self):
        self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'a.vtu', '-o', 'clean.poly', '-q')
        self.run_cover('mesh', 'clean.poly', '-o', 'b.vtu', '-q')
        self.assertEqual((self.dir / 'a.vtu').read_bytes(), (self.dir / 'b.vtu').read_bytes())

    def test_dry_run_writes_nothing(self):
        out, _ = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '--report', 'd.html', '--dry-run')
        self.assertIn('4 regions', out)
        self.assertIn('Would write d.vtu', out)
        self.assertIn('Would write d.html', out)
        self.assertEqual(self.files(), [])

    def test_dry_run_finds_wrong_names(self):
        diode = SAMPLES / 'diode.poly'
        _, err = self.run_cover('mesh', diode, '--dry-run', '--size-at', 'gold=1', code=2)
        self.assertIn("no interface, contact or point of that name", err)
        _, err = self.run_cover('mesh', diode, '--dry-run', '--size', 'gold=1', code=2)
        self.assertIn("size for 'gold'", err)
        _, err = self.run_cover('mesh', diode, '--dry-run', '--only', '2', '--onto', 'none.vtu', code=5)
        self.assertIn('none.vtu', err)

    def test_paper(self):
        self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '--paper', '--pieces', '3', '-q')
        self.run_cover('check', SAMPLES / 'diode.poly', 'd.vtu')

    def test_paper_and_fill_imply_the_almond_method(self):
        for implying in ['--paper'], ['--fill', 'refine'], ['--fill', 'disks']:
            for method in [], ['--method', 'almond']:
                self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', f'd{len(method)}.vtu', '-q', *implying, *method)
            self.assertEqual((self.dir / 'd0.vtu').read_bytes(), (self.dir / 'd2.vtu').read_bytes())
        _, err = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '--paper', '--method', 'quality', code=2)
        self.assertIn('paper needs method almond', err)

    def require(self, poly, what, code, *words):
        """Runs with --require; the mesh is written in any case. What the report says overall."""
        (self.dir / 'd.vtu').unlink(missing_ok=True)
        _, err = self.run_cover('mesh', poly, '-o', 'd.vtu', '--require', what, '--report', 'd.json', *words, code=code)
        self.assertIn('d.vtu', self.files())
        if code == 6:
            self.assertRegex(err, f'required, but not met: {what} .*, in regions? ')
        return json.loads((self.dir / 'd.json').read_text())['overall']

    def test_require(self):
        square = self.write('square.poly', SQUARE)
        for what in ('bound', 'max-angle', 'delaunay', 'non-obtuse', 'bound,max-angle,delaunay,non-obtuse'):
            self.require(square, what, 0)
        # The last point lies so near the first segment that an angle of 168.6 degrees is forced.
        flat = self.write('flat.poly', SQUARE.replace('2 1 0', '2 2 0').replace('3 1 1', '3 2 2').replace('4 0 1', '4 1 0.1'))
        self.assertGreater(self.require(flat, 'non-obtuse', 6)['obtuse'], 0)
        self.assertGreater(self.require(flat, 'max-angle', 6)['largest_angle'], 168)
        self.require(flat, 'max-angle', 0, '--max-angle', 170)
        self.require(flat, 'bound', 0)
        _, err = self.run_cover('mesh', flat, '-o', 'd.vtu', '--require', 'max-angle,non-obtuse', code=6)
        self.assertEqual(err.count('required, but not met'), 2)
        diode = SAMPLES / 'diode.poly'
        self.assertGreater(self.require(diode, 'delaunay', 6, '--couplings', 'last')['box']['non_delaunay_edges'], 0)
        self.assertEqual(self.require(diode, 'delaunay', 0, '--method', 'almond')['box']['non_delaunay_edges'], 0)
        self.assertEqual(self.require(diode, 'delaunay,box-method', 0)['box']['negative_couplings'], 0)

    def test_couplings(self):
        # A picture has short sides between its grains, beside which only the almond method holds the bound.
        for sample in sorted([*SAMPLES.glob('*.poly'), *SAMPLES.glob('*.*json')]):
            with self.subTest(sample.name):
                out, _ = self.run_cover('mesh', sample, '-o', 'd.vtm', '--report', 'r.json')
                box = json.loads((self.dir / 'r.json').read_text())['overall']['box']
                layered = '"layers"' in sample.read_text()
                self.assertEqual(box['negative_inside'], 0)
                self.assertEqual(box['negative_given_up'], 0)
                self.assertRegex(out, f'Box method +{box["negative_couplings"]} +negative coupling')
                encroached = int(re.search(r'Box method: (\d+) of', self.run_cover('info', sample)[0])[1])
                if layered:  # their vertices are as given as those of the input
                    self.assertGreaterEqual(box['negative_encroached'], encroached)
                    continue
                self.assertEqual(box['negative_encroached'], encroached)
                if encroached:
                    self.assertIn(f'0 inside, {encroached} on sides that the input encroaches, 0 given up', out)
        self.assertGreater(self.require(SAMPLES / 'motor_slot.poly', 'bound', 0, '--couplings', 'last')['box']['negative_inside'], 9)
        # A half disc of many chords: every point inside lies in the disk of its diameter, and without one an ear is flat.
        points = [(1.001 * math.cos(math.pi * k / 24), 1.001 * math.sin(math.pi * k / 24)) for k in range(1, 24)]
        points = [(1, 0), *points, (-1, 0)]
        self.write('half.poly', f'{len(points)} 2 0 0\n' + ''.join(f'{k} {x} {y}\n' for k, (x, y) in enumerate(points))
                   + f'{len(points)} 0\n' + ''.join(f'{k} {k} {(k + 1) % len(points)}\n' for k in range(len(points))) + '0\n')
        out, _ = self.run_cover('mesh', 'half.poly', '-o', 'd.vtm')
        self.assertRegex(out, r'0 on sides that the input encroaches, 1 given up for angles; --box-method cuts these sides\n'
                              r' +given up: from \(-1, 0\) to \(1, 0\), region 1\n')

    def test_box_method(self):
        # A point over the lid of a box, and two beside each other in it.
        box = self.write('box.poly', '6 2 0 0\n1 0 0\n2 10 0\n3 10 6\n4 0 6\n5 4 1\n6 6 1\n'
                         '4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n')
        out, _ = self.run_cover('info', box)
        self.assertRegex(out, 'Box method: 1 of 4 sides has a vertex in the open diametral disk')
        self.assertRegex(out, r'none negative \(--box-method\) +2 cuts before meshing; proven to be needed: 2')
        self.assertEqual(self.require(box, 'box-method', 6)['box']['negative_encroached'], 1)
        out, _ = self.run_cover('check', box, 'd.vtu', '--box-method', code=6)
        self.assertRegex(out, r'FAILED box method: \d negative couplings: 0 on inner edges, 1 on sides that a vertex')
        self.assertIn('side from (0, 0) to (10, 0), encroached by (', out)
        overall = self.require(box, 'box-method', 0, '--box-method')
        self.assertEqual(overall['box']['negative_couplings'], 0)
        report = json.loads((self.dir / 'd.json').read_text())
        # Those that are encroached first; the others are of sides that the mesh gave up for its angles.
        reasons = [cut['reason'] for cut in report['box_cuts']]
        self.assertEqual(reasons, ['encroached'] * 2 + ['given_up'] * (len(reasons) - 2))
        out, _ = self.run_cover('check', box, 'd.vtu', '--box-method', '--allow-split')
        self.assertIn('Box method: no negative coupling', out)
        err = self.run_cover('mesh', box, '-o', 'd.vtu', '--box-method', '--hull', code=2)[1]
        self.assertIn('box_method', err)

    def test_box_method_with_other_options(self):
        box = self.write('box.poly', '6 2 0 0\n1 0 0\n2 10 0\n3 10 6\n4 0 6\n5 4 1\n6 6 1\n'
                         '4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n')
        # What cuts segments by itself, or may cut none, is refused by name.
        for options, name in ((['--hull'], 'hull'), (['--method', 'nonobtuse'], 'nonobtuse'), (['--method', 'almond'], 'almond')):
            err = self.run_cover('mesh', box, '-o', 'd.vtu', '--box-method', *options, code=2)[1]
            self.assertIn('box_method', err)
            self.assertIn(name, err)
        self.run_cover('mesh', box, '-o', 'd.vtu')
        err = self.run_cover('mesh', box, '--box-method', '--only', 'unnamed', '--onto', 'd.vtu', '-o', 'e.vtu', code=2)[1]
        self.assertIn('box_method', err)
        self.assertIn('only', err)
        # Everything else works: no coupling is negative, by exact signs.
        for options in (['--split-interfaces'], ['--split-interfaces', '--max-angle', '90'], ['--size', '0.7'],
                        ['--size', '0.7', '--split-interfaces'], ['--split-interfaces', '--max-angle', '90', '--effort', 'fast']):
            overall = self.require(box, 'box-method', 0, '--box-method', *options)
            self.assertEqual(overall['box']['negative_couplings'], 0, options)
            out, _ = self.run_cover('check', box, 'd.vtu', '--box-method', '--allow-split')
            self.assertIn('Box method: no negative coupling', out)
            if '--max-angle' in options:
                self.assertEqual(overall['obtuse'], 0, options)

    def test_right_angles_are_thinned_out(self):
        # A kite between two rectangles: many vertices become a few.
        self.write('kite.json', json.dumps({
            'points': [[0, 0], [10, 0], [10, 4], [0, 4], [3, 2], [5, 1.2], [8, 2], [5, 2.9]],
            'segments': [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]]}))
        counts = {}
        for effort in ('fast', 'normal'):
            overall = self.require('kite.json', 'non-obtuse', 0, '--split-interfaces', '--max-angle', '90', '--min-angle', '0',
                                   '--effort', effort)
            self.assertEqual(overall['obtuse'], 0)
            report = json.loads((self.dir / 'd.json').read_text())
            counts[effort] = report['mesh']['vertices']
            self.assertTrue(any('that no right angle needs' in note['message'] for note in report['notes']))
            self.assertEqual(report['mesh']['cut_vertices'], report['input']['points'] - 8)
            self.run_cover('check', 'kite.json', 'd.vtu', '--allow-split')
        self.assertLessEqual(counts['normal'], counts['fast'])
        self.assertLessEqual(counts['normal'], 12)

    def test_require_bound_of_what_is_kept(self):
        # Two squares; the left one was meshed by hand, with an angle of 179.8 degrees.
        self.write('two.poly', '6 2 0 0\n1 0 0\n2 1 0\n3 2 0\n4 2 1\n5 1 1\n6 0 1\n'
                   '7 0\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n5 5 6\n6 6 1\n7 2 5\n0\n2\n1 0.5 0.5 1 -1\n2 1.5 0.5 2 -1\n')
        self.write('hand.node', '7 2 0 0\n1 0 0\n2 1 0\n3 2 0\n4 2 1\n5 1 1\n6 0 1\n7 0.5 0.001\n')
        self.write('hand.ele', '6 3 1\n1 1 2 7 1\n2 2 5 7 1\n3 5 6 7 1\n4 6 1 7 1\n5 2 3 4 2\n6 2 4 5 2\n')
        onto = ('--only', '2', '--onto', 'hand.ele', '--size', '0.2')
        self.assertEqual(self.require('two.poly', 'max-angle', 0, *onto, '--max-angle', 179.9)['bound_missed'], [1])
        self.require('two.poly', 'bound', 6, *onto)
        out, err = self.run_cover('mesh', 'two.poly', '-o', 'd.vtu', *onto)
        self.assertIn('Proven bound    MISSED in 1 of 2 regions', out)
        self.assertRegex(err, r'region 1: the triangle .* has an angle of 179\.\d+ degrees')
        self.run_cover('check', 'two.poly', 'd.vtu', '--no-bound')

    def test_no_progress_without_a_terminal(self):
        self.assertNotIn('%', self.run_cover('mesh', SAMPLES / 'coax.poly', '-o', 'd.vtu')[1])

    def test_progress_on_a_terminal(self):
        try:
            master, slave = pty.openpty()
        except OSError as error:  # a container without terminals
            self.skipTest(str(error))
        done = subprocess.run([PROGRAM, 'mesh', SAMPLES / 'coax.poly', '-o', 'd.vtu'], cwd=self.dir, timeout=60,
                              stdout=subprocess.DEVNULL, stderr=slave)
        os.close(slave)
        self.assertEqual(done.returncode, 0)
        self.assertIn(b'%', os.read(master, 65536))
        os.close(master)


class Files(Case):
    """No file that is read is written over, no file is written twice; found out before any work."""

    def setUp(self):
        super().setUp()
        (self.dir / 'd.poly').write_bytes((SAMPLES / 'diode.poly').read_bytes())
        self.run_cover('mesh', 'd.poly', '-o', 'd.vtu', '-o', 'd.vtm', '-q')
        self.write('h.vtk', '# vtk DataFile Version 3.0')
        self.write('job.toml', 'max-angle = 110\n')

    def refuse(self, part, *words, code=2):
        before = {p: p.read_bytes() for p in self.dir.rglob('*.*') if p.is_file()}
        _, err = self.run_cover(*words, code=code)
        self.assertIn(part, err)
        self.assertEqual({p: p.read_bytes() for p in self.dir.rglob('*.*') if p.is_file()}, before, words)

    def test_what_is_read_stays(self):
        mesh = ('mesh', 'd.poly', '-o', 'e.vtu')
        self.refuse("writing --log 'd.poly' would replace the input\n", *mesh, '--log', 'd.poly')
        self.refuse("would replace the input 'd.poly'", *mesh, '--log', './d.poly')
        self.refuse('the file of --size-field', *mesh, '--size-field', 'h.vtk', '-o', 'h.vtk')
        self.refuse('the file of --config', *mesh, '--config', 'job.toml', '--log', 'job.toml')
        self.refuse('the file of --onto', *mesh, '--only', '2', '--onto', 'd.vtu', '--log', 'd.vtu')
        self.refuse('would replace', 'mesh', next((self.dir / 'd').glob('d_0_*.vtu')).relative_to(self.dir), '-o', 'd.vtm')
        os.symlink('d.poly', self.dir / 'link.json')
        self.refuse('would replace the input', *mesh, '--report', 'link.json')
        for words in (('info', 'd.poly'), ('check', 'd.poly', 'd.vtu'), ('render', 'd.vtu', '-o', 'e.svg'),
                      ('convert', 'd.vtu', '-o', 'e.vtu')):
            self.refuse('would replace the input', *words, '--log', words[1])
        self.refuse('would replace the input', 'check', 'd.poly', 'd.vtu', '--log', 'd.vtu')

    def test_a_manifest_needs_a_name_of_its_own(self):
        shutil.copy(SAMPLES / 'tft.json', self.dir)
        self.refuse('give both another one, or write a .vtm', 'mesh', 'tft.json', '-o', 'tft.vtu', '-o', 'tft.json')
        self.run_cover('mesh', 'tft.json', '-o', 'tft.vtm', '-q')
        self.run_cover('convert', 'tft.vtm', '-o', 'other.msh', '-q')
        self.assertIn('"gate_contact"', (self.dir / 'other.msh').read_text())

    def test_a_mesh_may_be_replaced_by_its_conversion(self):
        self.run_cover('convert', 'd.vtu', '-o', 'd.vtu', '--order', 2)

    def test_nothing_is_written_twice(self):
        mesh = ('mesh', 'd.poly')
        self.refuse("-o 'x.json' and --report './x.json' would replace each other", *mesh, '-o', 'x.json', '--report',
                    './x.json')
        self.refuse('would replace each other', *mesh, '-o', 'x.vtu', '-o', 'x.vtu')
        self.refuse('would replace each other', *mesh, '-o', 'x.ele', '--log', 'x.node')
        self.refuse('two files cannot be written to standard output', *mesh, '-o', '-', '-o', '-')
        self.refuse('two files cannot be written to standard output', 'render', 'd.vtu', '-o', '-', '-o', '-')
        self.run_cover(*mesh, '-o', 'x.vtu', '--log', '/dev/null', '-q')

    def test_folders_are_there(self):
        for words in (('-o', 'none/x.vtu'), ('-o', 'x.vtu', '--report', 'none/r.html'),
                      ('-o', 'x.vtu', '--log', 'none/l')):
            self.refuse(f'cannot write {words[-1]}: No such file or directory', 'mesh', 'd.poly', *words, code=5)
            self.refuse('No such file or directory', 'mesh', 'd.poly', *words, '--dry-run', code=5)
        self.refuse('Is a directory', 'mesh', 'd.poly', '-o', 'x.vtu', '--log', 'd', code=5)
        self.refuse('cannot write d.poly/x.vtu', 'mesh', 'd.poly', '-o', 'd.poly/x.vtu', code=5)


class CloseUps(Case):
    """Pictures of layers, arcs and periodic sides."""

    def test_curved_edges(self):
        coax = SAMPLES / 'coax_arcs.json'
        self.run_cover('mesh', coax, '--order', '2', '-o', 'c.svg', '-o', 'c.msh', '-o', 'c.png', '--report', 'c.html', '-q')
        self.run_cover('mesh', coax, '-o', 's.svg', '--report', 's.html', '-q')
        curved, straight = ((self.dir / name).read_text() for name in ('c.svg', 's.svg'))
        self.assertGreater(curved.count('M'), straight.count('M') + 7 * 16)  # eight pieces for each of the arcs' edges
        # Drawn from a file of second order, it is the same picture but for names that only the run knows.
        self.run_cover('render', 'c.msh', '-o', 'r.svg')
        self.assertEqual((self.dir / 'r.svg').read_text().count('M'), curved.count('M'))
        self.assertIn('Edges on an arc', (self.dir / 'c.html').read_text())
        self.assertNotIn('Close-ups', (self.dir / 's.html').read_text())

    def test_layers_and_partners(self):
        self.run_cover('mesh', SAMPLES / 'waveguide_layers.json', '-o', 'w.vtu', '--report', 'w.html', '-q')
        self.assertIn('>Layers along wall_guide<', (self.dir / 'w.html').read_text())
        self.run_cover('mesh', SAMPLES / 'fibre_cell.json', '-o', 'p.vtu', '--report', 'p.html', '-q')
        page = (self.dir / 'p.html').read_text()
        self.assertIn('>Vertices with partners on periodic sides<', page)
        self.assertIn('id="close-up-0"', page)


class Layers(Case):
    """--layers, and "layers" in JSON."""

    def report(self, *words):
        out, err = self.run_cover('mesh', *words, '-o', 'd.vtu', '-o', 'd.json', '--report', 'r.json')
        self.run_cover('check', words[0], 'd.vtu', *(['--allow-split'] if '--split-interfaces' in words else []))
        return json.loads((self.dir / 'r.json').read_text()), out, err

    def test_on_a_mosfet(self):
        given = SAMPLES / 'mosfet_layers.json'
        fine = ['--split-interfaces', '--size-at', 'channel_oxide=20', '--size-at', 'oxide_gate=20']
        report, out, _ = self.report(given, *fine)
        regions = {region['name']: region for region in report['regions']}
        [channel], [oxide] = regions['channel']['layers'], regions['oxide']['layers']
        self.assertEqual((channel['line'], channel['first'], channel['growth'], channel['count']), ('channel_oxide', 0.2, 1.3, 0))
        self.assertGreater(channel['most'], 12)
        self.assertEqual((oxide['fewest'], oxide['most'], oxide['complete']), (3, 3, oxide['segments']))
        self.assertAlmostEqual(oxide['thickness'], 0.9, delta=1e-12)
        self.assertAlmostEqual(regions['oxide']['largest_angle'], 90, delta=1e-6)
        self.assertTrue(all(region['bound_held'] for region in report['regions']))
        self.assertIn('channel_oxide in oxide: 3 of 3 layers, 0.9 thick', out)
        self.assertEqual(report['options']['layers'], ['channel_oxide@channel=0.2,1.3,0', 'channel_oxide@oxide=0.3,1,3'])
        # The command line wins.
        report = self.report(given, *fine, '--layers', 'channel_oxide@oxide=0.4,1,2')[0]
        regions = {region['name']: region for region in report['regions']}
        self.assertEqual(regions['oxide']['layers'][0]['most'], 2)

    def judged(self, sample, line, region, first, *words, steepest=90):
        """A sample with layers against isotropic triangles as thin as the first layer."""
        given = SAMPLES / f'{sample}_layers.json'
        report, _, _ = self.report(given, *words, '--box-method')
        self.assertTrue(all(r['bound_held'] for r in report['regions']))
        self.assertEqual(report['overall']['box']['negative_couplings'], 0)
        check = ['check', given, 'd.vtu', '--allow-split', '--layers']
        out = self.run_cover(*check, f'{line}@{region}')[0]
        found = re.search(r"Layers along '.*: (\d+) to (\d+) over ([\d,]+) of ([\d,]+) edges; the first (\S+) to (\S+) thick, "
                          r'all \S+; [\d,]+ triangles, largest angle (\S+), [\d,]+ above 90 degrees; 0 negative couplings\n', out)
        self.assertIsNotNone(found, out)
        for thickness in found[5], found[6]:
            self.assertAlmostEqual(float(thickness) / first, 1, delta=1e-9)
        self.assertLessEqual(float(found[7]), steepest + 1e-6)
        drawing = json.loads(given.read_text())
        del drawing['layers']
        self.write('isotropic.json', json.dumps(drawing))
        self.run_cover('mesh', 'isotropic.json', '-o', 'i.vtu', '--report', 'i.json', '-q', '--effort', 'fast', *words,
                       '--size-at', f'{line}={first}')
        isotropic = json.loads((self.dir / 'i.json').read_text())['mesh']['triangles']
        self.assertLessEqual(5 * report['mesh']['triangles'], isotropic)
        return report

    def test_on_a_fin(self):
        # Right corners: layers of both sides meet in the middle.
        report = self.judged('finfet', 'fin_oxide', 'fin', 0.05, '--split-interfaces', '--size-at', 'fin_oxide=1', '--size-at', 'gate_oxide=1')
        fin = next(r for r in report['regions'] if r['name'] == 'fin')
        self.assertEqual([part['why'] for part in fin['layers'][0]['cut_short']], ['end', 'room'])

    def test_on_a_birds_beak(self):
        report = self.judged('locos', 'silicon_oxide', 'silicon', 0.5, '--split-interfaces', '--size-at', 'silicon_oxide=25', steepest=100)
        oxide = next(r for r in report['regions'] if r['name'] == 'oxide')
        self.assertGreater(oxide['layers'][0]['fewest'], 0)

    def test_check_of_layers(self):
        given = SAMPLES / 'mosfet_layers.json'
        self.report(given, '--split-interfaces', '--size-at', 'channel_oxide=20', '--size-at', 'oxide_gate=20')
        check = ['check', given, 'd.vtu', '--allow-split', '--layers']
        out = self.run_cover(*check, 'channel_oxide')[0]
        self.assertRegex(out, r"Layers along 'channel_oxide' in 'channel': \d to \d+ over .* edges; the first 0.2 to 0.2 thick")
        self.assertRegex(out, r"Layers along 'channel_oxide' in 'oxide': 3 to 3 over .* largest angle 90\.000000, 0 above 90 degrees; 0 neg")
        self.assertRegex(out, r'largest angle [\d.]+, \d+ above 90 degrees; 0 negative couplings')
        self.run_cover(*check, 'channel_oxide@oxide=0.3,1,3', '-q')
        out = self.run_cover(*check, 'channel_oxide@oxide=0.31,1,3', code=6)[0]
        self.assertIn("FAILED Layers along 'channel_oxide' in 'oxide'", out)
        self.run_cover(*check, 'channel_oxide@oxide=0.3,1,9', code=6)
        self.assertIn("did you mean 'channel_oxide'", self.run_cover(*check, 'channel_oxid', code=2)[1])
        self.assertIn("no region 'gate' is beside the line", self.run_cover(*check, 'channel_oxide@gate', code=2)[1])
        self.assertIn('is not LINE[@REGION]=first', self.run_cover(*check, 'channel_oxide=x,2', code=2)[1])

    def test_that_cannot_be(self):
        given = SAMPLES / 'mosfet_layers.json'
        for layers, part in (('channel_oxid=1,2', "did you mean 'channel_oxide'?"),
                             ('channel_oxide@gate=1,2', "region 'gate' is not beside that line, but 'channel' and 'oxide'"),
                             ('channel_oxide@oxide=1.3,1,1', "no thinner than region 2 'oxide', which is 1.2"),
                             ('channel_oxide=-1,2', 'the first layer is -1, but must be above 0'),
                             ('channel_oxide=nan,2', 'the first layer is nan'),
                             ('channel_oxide=1,0.5', 'the growth is 0.5, but must be at least 1')):
            _, err = self.run_cover('mesh', given, '-o', 'd.vtu', '--layers', layers, code=2)
            self.assertIn(part, err)
            self.assertFalse((self.dir / 'd.vtu').exists())
        self.assertIn('layers need method quality or almond', self.run_cover('mesh', given, '-o', 'd.vtu', '--method', 'nonobtuse', code=2)[1])
        self.assertIn('sides of a hull are none: not with hull', self.run_cover('mesh', given, '-o', 'd.vtu', '--hull', code=2)[1])


class Sizes(Case):
    """--size, --size-at, --size-field, sizes in the input."""

    def triangles(self, name, *words, code=0):
        self.run_cover('mesh', name, '-o', 'd.vtu', '--report', 'd.json', '-q', *words, code=code)
        return json.loads((self.dir / 'd.json').read_text())['mesh']['triangles']

    def fine_square(self, seed=''):
        """The unit square, its sides cut into 20."""
        at = [(k / 20, 0) for k in range(20)] + [(1, k / 20) for k in range(20)]
        at += [(1 - x, 1 - y) for x, y in at]
        points = ''.join(f'{k + 1} {x} {y}\n' for k, (x, y) in enumerate(at))
        segments = ''.join(f'{k + 1} {k + 1} {(k + 1) % 80 + 1}\n' for k in range(80))
        return self.write('fine.poly', f'80 2 0 0\n{points}80 0\n{segments}0\n{seed}')

    def field(self, name, values='0.05 0.05 0.05 0.05', array='h'):
        return self.write(name, '# vtk DataFile Version 3.0\nh\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 1\n'
                          f'ORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 4\nSCALARS {array} double 1\nLOOKUP_TABLE default\n{values}\n')

    def test_field(self):
        fine = self.fine_square()
        plain, expected = self.triangles(fine), 4 / 3**0.5 / 0.05**2
        self.field('h.vtk')
        self.assertAlmostEqual(self.triangles(fine, '--size-field', 'h.vtk'), expected, delta=0.15 * expected)
        self.assertLess(plain, expected / 2)
        settings = json.loads((self.dir / 'd.json').read_text())['options']
        self.assertEqual(settings['size-field'], 'h.vtk')
        self.assertEqual(self.triangles(fine, '--size-field', 'h.vtk'), self.triangles(fine, '--size', 0.05))

    def test_what_is_no_field(self):
        fine = self.fine_square()
        for values, part in (('1 1 0 1', 'the size at point 2, (0, 1), is 0'), ('1 1 1', 'bad.vtk')):
            _, err = self.run_cover('mesh', fine, '-o', 'd.vtu', '--size-field', self.field('bad.vtk', values), code=5)
            self.assertIn('bad.vtk', err)
            self.assertIn(part, err)
        _, err = self.run_cover('mesh', fine, '-o', 'd.vtu', '--size-field', 'none.vtu', code=5)
        self.assertIn('none.vtu', err)

    def test_expressions(self):
        fine = self.fine_square()
        expected = self.triangles(fine, '--size', 0.05)
        self.assertEqual(self.triangles(fine, '--size', '0.1/2 + 0*x'), expected)
        settings = json.loads((self.dir / 'd.json').read_text())['options']
        self.assertEqual(settings['size'], '0.1/2 + 0*x')
        graded = self.triangles(fine, '--size', '0.05 + 0.5*x')
        self.assertLess(graded, expected / 2)
        self.assertEqual(self.triangles(fine, '--size', '1=0.05 + 0.5*x'), graded)  # the material 1
        self.assertLess(self.triangles(fine, '--size', 'sqrt(-1 - x)'), expected / 2)  # nothing is asked
        error = self.run_cover('mesh', fine, '-o', 'd.vtu', '--size', '0.1 + y)', code=2)[1]
        self.assertIn("--size: '0.1 + y)', column 8: ')' does not belong here", error)

    def test_tables_of_points(self):
        fine = self.fine_square()
        expected = self.triangles(fine, '--size-field', self.field('h.vtk', '0.05 0.05 0.3 0.3'))
        table = self.write('h.csv', 'x,y,h\n0,0,0.05\n0,1,0.05\n1,0,0.3\n1,1,0.3\n')
        self.assertAlmostEqual(self.triangles(fine, '--size-field', table), expected, delta=0.02 * expected)
        error = self.run_cover('mesh', fine, '-o', 'd.vtu', '--size-field', self.write('h.csv', '0,0,1\n1,0\n'), code=5)[1]
        self.assertIn('h.csv:2: expected 3 numbers, found 2', error)

    def test_values_are_resolved(self):
        """asinh of a doping that falls over 20 decades: it changes by at most the step on nearly every inner edge."""
        n = 60
        def doping(x):
            return 1e20 * math.exp(-60 * x * x) - 1e15
        values = '\n'.join(repr(doping(i / n)) for _ in range(n + 1) for i in range(n + 1))
        self.write('doping.vtk', f'''# vtk DataFile Version 3.0
doping
ASCII
DATASET STRUCTURED_POINTS
DIMENSIONS {n + 1} {n + 1} 1
ORIGIN 0 0 0
SPACING {1 / n} {1 / n} 1
POINT_DATA {(n + 1)**2}
SCALARS doping double 1
LOOKUP_TABLE default
{values}
''')
        square = self.write('square.poly', SQUARE)
        step = 2
        self.run_cover('mesh', square, '-o', 'd.json', '-o', 'd.obj', '--split-interfaces', 150, '--size-field', 'doping.vtk',
                       '--size-of', 'asinh(doping/1e15)', '--size-step', step)
        points, edges = [], set()
        for line in (self.dir / 'd.obj').read_text().splitlines():
            words = line.split()
            if line.startswith('v '):
                points.append((float(words[1]), float(words[2])))
            if line.startswith('f '):
                t = [int(word.split('/')[0]) - 1 for word in words[1:]]
                edges |= {tuple(sorted((t[k], t[k - 1]))) for k in range(3)}

        def value(x):  # linear between the samples, as sizes are made
            cell = min(int(x * n), n - 1)
            a, b = (math.asinh(doping(i / n) / 1e15) for i in (cell, cell + 1))
            return a + (x * n - cell) * (b - a)
        changes = sorted(abs(value(points[a][0]) - value(points[b][0])) for a, b in edges)
        self.assertGreater(len(changes), 500)
        self.assertLess(len(changes), 20000)
        too_large = sum(change > step for change in changes)
        self.assertLess(too_large, 0.01 * len(changes), changes[-20:])
        self.assertLess(changes[-1], 1.5 * step)
        error = self.run_cover('mesh', square, '-o', 'd.vtu', '--size-of', 'asinh', code=2)[1]
        self.assertIn('size-field', error)

    def test_sizes_in_the_input(self):
        area = 3**0.5 / 4 * 0.05**2  # of an equilateral triangle with sides of 0.05
        plain = self.triangles(self.fine_square())
        for none in (-1, 0):
            self.assertEqual(self.triangles(self.fine_square(f'1\n1 0.5 0.5 1 {none}\n')), plain)
        fine = self.fine_square(f'1\n1 0.5 0.5 1 {area}\n')
        self.assertAlmostEqual(self.triangles(fine), 1 / area, delta=0.15 / area)
        self.assertEqual(self.triangles(fine, '--no-input-sizes'), plain)
        self.assertRegex(self.run_cover('info', fine)[0], r'proven +size\n.* 0\.05\n')
        corners = [[0, 0], [1, 0], [1, 1], [0, 1]]
        self.write('j.json', json.dumps({'points': corners, 'segments': [[0, 1], [1, 2], [2, 3], [3, 0]],
                                         'regions': [{'x': 0.5, 'y': 0.5, 'size': 0.1}]}))
        self.assertGreater(self.triangles('j.json', '--split-interfaces'), 150)

    def test_at_an_interface_a_contact_and_a_point(self):
        poly = SAMPLES / 'mosfet.poly'
        plain = self.triangles(poly)
        for name in ('material_2_outline', 'material_4_outline', '1'):
            self.assertGreater(self.triangles(poly, '--size-at', f'{name}=0.5'), plain, name)
        corners = [[0, 0], [1, 0], [1, 1], [0, 1]]
        self.write('c.json', json.dumps({'points': corners, 'segments': [[0, 1], [1, 2], [2, 3],
                                         {'points': [3, 0], 'name': 'anode'}]}))
        out, err = self.run_cover('mesh', 'c.json', '-o', 'd.vtu', '--size-at', 'anode=0.1', '--split-interfaces')
        self.assertRegex(out, 'points added on segments for --split-interfaces 90, the first at')
        self.assertNotIn('changed', err)
        _, err = self.run_cover('mesh', 'c.json', '-o', 'd.vtu', '--size-at', 'anod=0.1', code=2)
        self.assertIn("did you mean 'anode'?", err)

    def test_a_contact_is_no_region(self):
        _, err = self.run_cover('mesh', SAMPLES / 'tft.json', '-o', 'd.vtu', '--size', 'gate_contact=2', code=2)
        self.assertIn('an interface or contact has it: ask for a size at that (--size-at)', err)

    def test_says_what_stays_larger(self):
        self.write('s.poly', SQUARE)
        _, err = self.run_cover('mesh', 's.poly', '-o', 'd.vtu', '--size', 0.1)
        self.assertIn('4 segments are longer than the sizes asked for there, up to 1 from', err)
        _, err = self.run_cover('mesh', 's.poly', '-o', 'd.vtu', '--size', 0.1, '--split-interfaces')
        self.assertNotIn('longer', err)
        _, err = self.run_cover('mesh', 's.poly', '-o', 'd.vtu', '--size', 0.1, '--method', 'almond')
        self.assertIn('sizes count with method quality only', err)


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
        self.assertIn('text or hdf5', self.run_cover('mesh', 'plain.poly', '-o', 'b.xdmf', '--xdmf', 'x', code=2)[1])

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
        """Cells with wavy sides; no arcs, no periodic sides."""
        n, k = 6, 5
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
        return self.write('plain.poly', text + '0\n')

    def test_what_needs_the_whole_mesh_is_told(self):
        device = self.plain()
        for words, what in ((('-o', 'a.svg'), 'a file in .svg'), (('-o', 'a.vtm'), 'a file in .vtm'),
                            (('-o', 'a.vtu', '--report', 'r.html'), 'a report that shows the mesh'),
                            (('-o', 'a.vtu', '--order', 2), 'triangles of second order'),
                            (('-o', 'a.vtu', '--split-interfaces', 95), 'cutting segments after meshing'),
                            (('-o', 'a.vtu', '--method', 'nonobtuse'), 'method nonobtuse'),
                            (('-o', '-'), 'writing to standard output')):
            _, err = self.run_cover('mesh', device, *words, '--stream', 'on', code=2)
            self.assertIn(f'--stream on: {what} needs the whole mesh in memory', err)
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

    def test_killed_at_any_moment(self):
        """No half file under the name, and the next run leaves nothing else."""
        device = self.plain()
        self.run_cover('mesh', device, '-o', 'a.vtkhdf', '-q', '--stream', 'on')
        whole = (self.dir / 'a.vtkhdf').read_bytes()
        for k in range(25):
            (self.dir / 'a.vtkhdf').unlink(missing_ok=True)
            run = subprocess.Popen([PROGRAM, 'mesh', device, '-o', 'a.vtkhdf', '-q', '--stream', 'on'], cwd=self.dir)
            time.sleep(0.008 * k)
            run.kill()
            run.wait()
            if (self.dir / 'a.vtkhdf').exists():
                self.assertTrue((self.dir / 'a.vtkhdf').read_bytes() == whole)
        self.run_cover('mesh', device, '-o', 'a.vtkhdf', '-q', '--stream', 'on')
        self.assertEqual(self.files(), ['a.vtkhdf', 'plain.poly'])
        self.assertTrue((self.dir / 'a.vtkhdf').read_bytes() == whole)

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

    def test_only_where_the_format_has_parts(self):
        self.assertIn('version 4.1', self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.msh', '--parts', 2, code=2)[1])
        self.assertIn('in parts', self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '--parts', 2, code=2)[1])
        self.assertIn('parts are 1 to', self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.pvtu', '--parts', 0, code=2)[1])
        self.assertEqual(self.files(), [])


class Memory(Case):
    @staticmethod
    def peak(*words):
        """Kilobytes at the most, of a run of the program."""
        run = subprocess.Popen([PROGRAM, *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        _, status, usage = os.wait4(run.pid, 0)
        run.returncode = os.waitstatus_to_exitcode(status)
        return usage.ru_maxrss if run.returncode == 0 else None

    def star(self, n):
        """Written line by line: the interpreter's own peak, which a child inherits, is to stay below the program's."""
        path = self.dir / f'{n}.poly'
        with open(path, 'w') as out:
            out.write(f'{n} 2 0 0\n')
            for i in range(n):
                t = 2 * math.pi * i / n
                r = 1 + sum(0.25 / k * math.cos(k * t + k) for k in (2, 5, 17, 64, 301))
                out.write(f'{i} {r * math.cos(t)!r} {r * math.sin(t)!r}\n')
            out.write(f'{n} 0\n')
            out.writelines(f'{i} {i} {(i + 1) % n}\n' for i in range(n))
            out.write('0\n')
        return path

    def bytes_per_triangle(self, method, stars):
        """What the program needs for any mesh cancels out."""
        peaks, triangles = [], []
        for star in stars:
            mesh, report = self.dir / 'star.vtu', self.dir / 'star.json'
            peaks.append(self.peak('mesh', star, '--method', method, '-j', 1, '-o', mesh, '--report', report))
            triangles.append(json.loads(report.read_text())['overall']['triangles'])
        return 1024 * (peaks[1] - peaks[0]) / (triangles[1] - triangles[0])

    def least_bytes_per_triangle(self, method, stars):
        """Beside other work the system takes pages of files away from whom it likes, from the smaller run too."""
        return min(self.bytes_per_triangle(method, stars) for _ in range(2))

    def test_bytes_per_triangle(self):
        square = self.dir / self.write('square.poly', SQUARE)
        if self.peak('mesh', square, '-o', self.dir / 'square.vtu') > 40000:
            self.skipTest('a sanitizer takes memory of its own')
        # What is resident varies by two megabytes, and the smaller star has to take more than this interpreter. The
        # almond method makes hardly more triangles than there are points, which take memory, too: 451 were measured.
        small, middle, large = [self.star(n) for n in (60000, 120000, 300000)]
        self.assertLess(self.least_bytes_per_triangle('almond', [middle, large]), 460)
        # Regions of more than 100,000 triangles are worked on in parts, which are copies: 373 were measured.
        self.assertLess(self.least_bytes_per_triangle('quality', [small, middle]), 400)

    def test_out_of_memory(self):
        """An error of its own, whenever memory ends, and files as they were."""
        square = self.dir / self.write('square.poly', SQUARE)
        mesh, star = self.dir / 'm.vtu', self.star(20000)

        def run_within(megabytes, source):
            limit = megabytes << 20
            return subprocess.run([PROGRAM, 'mesh', source, '-o', mesh, '-q'], timeout=60, capture_output=True, text=True,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))

        if run_within(150, square).returncode != 0:
            self.skipTest('a sanitizer takes memory of its own')
        before, ends = mesh.read_bytes(), []
        for megabytes in range(70, 200, 6):
            run = run_within(megabytes, star)
            ends.append(run.returncode)
            if run.returncode == 0:
                break
            if run.returncode == 127:  # the system's own: libraries do not fit
                continue
            self.assertEqual(run.returncode, 7, run.stderr)
            self.assertRegex(run.stderr, r'^cover: error: .*memory')
            self.assertEqual(mesh.read_bytes(), before)
            self.assertEqual(self.files(), ['20000.poly', 'm.vtu', 'square.poly'])
        self.assertEqual(ends[-1], 0)
        self.assertIn(7, ends)


class Remesh(Case):
    """--only and --onto: some regions again inside a mesh."""

    def setUp(self):
        super().setUp()
        self.poly = SAMPLES / 'mosfet.poly'
        self.run_cover('mesh', self.poly, '-o', 'm.vtu', '-o', 'm.vtm', '-q')

    def again(self, *words, code=0):
        return self.run_cover('mesh', self.poly, *words, code=code)

    def bytes_of(self, name):
        return (self.dir / name).read_bytes()

    def test_same_options_give_the_same_bytes(self):
        for mesh in ('m.vtu', 'm.vtm'):
            self.again('--only', '2', 'region:9', '--onto', mesh, '-o', 'n.vtu', '-q')
            self.assertEqual(self.bytes_of('n.vtu'), self.bytes_of('m.vtu'))

    def test_every_format_that_is_read(self):
        for name in ('m.msh', 'm.vtk', 'm.mesh', 'm.ele', 'm.xdmf'):
            self.run_cover('convert', 'm.vtu', '-o', name)
            self.again('--only', 'material_4', '--onto', name, '-o', 'n.vtu', '-q')
            self.assertEqual(self.bytes_of('n.vtu'), self.bytes_of('m.vtu'), name)

    def test_finer_and_back(self):
        out, _ = self.again('--only', '2', '--onto', 'm.vtu', '--size', '10', '-o', 'n.vtu', '--report', 'n.json')
        self.assertIn('Meshed again, the other 7 regions kept:', out)
        self.assertRegex(out, r"region 2 'material_2': \d+ triangles, \d+ new; before: \d+ triangles")
        report = json.loads(self.bytes_of('n.json'))
        self.assertEqual([r['region'] for r in report['replaced']], [2, 5])
        self.assertEqual(report['overall']['methods']['kept'], 7)
        self.assertEqual(report['options']['only'], '2')
        self.assertEqual(report['options']['onto'], 'm.vtu')
        for before in report['replaced']:
            self.assertGreater(report['regions'][before['region'] - 1]['triangles'], 2 * before['triangles'])
        self.run_cover('check', self.poly, 'n.vtu')
        self.again('--only', '2', '--onto', 'n.vtu', '-o', 'n.vtu', '-q')  # in place
        self.assertEqual(self.bytes_of('n.vtu'), self.bytes_of('m.vtu'))

    def test_cut_segments_stay_cut(self):
        self.again('-o', 'c.vtu', '--split-interfaces', '--size-at', 'material_2_outline=2', '-q')
        _, err = self.again('--only', '4', '--onto', 'c.vtu', '-o', 'n.vtu', '-o', 'n.poly')
        self.assertIn('segments are cut as in the mesh', err)
        self.run_cover('check', 'n.poly', 'n.vtu')

    def test_second_order(self):
        self.again('-o', 's.vtu', '--order', '2', '-q')
        _, err = self.again('--only', '4', '--onto', 's.vtu', '--order', '2', '-o', 'n.vtu')
        self.assertIn('six nodes, of which the corners are taken', err)
        self.assertEqual(self.bytes_of('n.vtu'), self.bytes_of('s.vtu'))

    def test_what_does_not_fit(self):
        _, err = self.run_cover('mesh', SAMPLES / 'diode.poly', '--only', '2', '--onto', 'm.vtu', '-o', 'n.vtu', code=3)
        self.assertIn('m.vtu: the mesh is not one of', err)
        self.assertRegex(err, r'point 1 at \(.*\) is no vertex of the mesh')
        _, err = self.again('--only', 'gate', '--onto', 'm.vtu', '-o', 'n.vtu', code=2)
        self.assertIn("only 'gate': there is no region or material of that name", err)
        _, err = self.again('--only', '2', '--onto', 'none.vtu', '-o', 'n.vtu', code=5)
        self.assertIn('none.vtu', err)
        _, err = self.again('--only', '2', '--onto', 'm.vtu', '--method', 'nonobtuse', '-o', 'n.vtu', code=2)
        self.assertIn('cuts segments', err)
        self.assertNotIn('n.vtu', self.files())

    def test_names_stand_apart(self):
        _, err = self.again('--only', '2,4', '--onto', 'm.vtu', '-o', 'n.vtu', code=2)
        self.assertIn('; blanks separate the names of --only', err)

    def test_both_or_none(self):
        self.assertIn('--onto', self.again('--only', '2', '-o', 'n.vtu', code=2)[1])
        self.assertIn('--only', self.again('--onto', 'm.vtu', '-o', 'n.vtu', code=2)[1])

    def test_job_file_and_dry_run(self):
        text, _ = self.again('--only', '2', 'region:9', '--onto', 'm.vtu', '-o', 'n.vtu', '--print-config')
        self.write('job.toml', text)
        self.run_cover('mesh', '--config', 'job.toml', '-q')
        self.assertEqual(self.bytes_of('n.vtu'), self.bytes_of('m.vtu'))
        out, _ = self.run_cover('mesh', '--config', 'job.toml', '--dry-run')
        for region in (2, 5, 9):
            self.assertIn(f'Would mesh region {region} ', out)


class DryRun(Case):
    def test_json(self):
        out, _ = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '--dry-run', '--stats', 'json')
        report = json.loads(out)
        self.assertEqual(report['format'], 'cover input report')
        self.assertEqual([report['input'][k] for k in ('points', 'segments')], [150, 153])
        self.assertEqual(len(report['regions']), 4)
        self.assertAlmostEqual(report['regions'][0]['gamma_opt'], 62.14824277768956)
        self.assertEqual(len(report['interfaces']), 9)
        self.assertEqual(self.files(), [])


    def test_estimate(self):
        self.write('s.poly', SQUARE)
        fine = ('--split-interfaces', '--size', '0.02')
        out, _ = self.run_cover('mesh', 's.poly', '-o', 's.vtu', '--dry-run', *fine)
        about = float(re.search(r'A mesh takes about ([0-9.e+]+) triangles and \d+ MB of memory', out)[1])
        made, _ = self.run_cover('mesh', 's.poly', '-o', 's.vtu', *fine)
        made = float(re.match(r'([0-9,]+) triangles', made)[1].replace(',', ''))
        self.assertLess(abs(about - made), 0.3 * made)

    def test_what_does_not_fit(self):
        self.write('s.poly', SQUARE)
        if os.sysconf('SC_PHYS_PAGES') * os.sysconf('SC_PAGE_SIZE') > 6e10:
            self.skipTest('it might fit')
        begin = time.monotonic()
        _, err = self.run_cover('mesh', 's.poly', '-o', 's.vtu', '--split-interfaces', '--size', '6e-5', code=7)
        self.assertLess(time.monotonic() - begin, 10)
        self.assertRegex(err, r'the sizes asked for take about 6.4e\+08 triangles and 108 GB of memory, and there are ')
        self.assertEqual(self.files(), ['s.poly'])


class StrangeNames(Case):
    """Names that would steer a terminal or break a file."""

    def test_control_characters(self):
        name = 'a\x1b[31m\nb\u202e<'
        self.write('d.json', json.dumps({'points': [[0, 0], [1, 0], [1, 1], [0, 1]],
                                         'segments': [[0, 1], [1, 2], [2, 3], [3, 0]],
                                         'regions': [{'x': 0.5, 'y': 0.5, 'material': name, 'region': name + '2'}]}))
        outputs = ['m.vtu', 'm.vtm', 'm.svg', 'm.json']
        texts = [*self.run_cover('mesh', 'd.json', *(f'-o{o}' for o in outputs), '--report', 'r.html', '-v'),
                 *self.run_cover('info', 'd.json', '-v'),
                 *self.run_cover('mesh', 'd.json', '-o', 'n.vtu', '--size', 'x=1', code=2),
                 *self.run_cover('check', 'd.json', 'm.vtm')]
        texts += [(self.dir / f).read_text() for f in ('m.svg', 'm.vtm', 'r.html')]
        for text in texts:
            self.assertNotIn('\x1b', text)
            self.assertNotIn('\u202e', text)
            self.assertNotRegex(text, 'a.{0,9}\n *b.{0,9}<')
        self.assertIn(r'a\x1b[31m\nb\u202e<', texts[0])
        self.assertIn(r'a\x1b[31m\nb\u202e<', ''.join(ElementTree.parse(self.dir / 'm.svg').getroot().itertext()))
        ElementTree.parse(self.dir / 'm.vtm')
        self.assertEqual(json.loads((self.dir / 'm.json').read_text())['regions'][0]['name'], name + '2')


class Configuration(Case):
    def test_printed_configuration_can_be_read(self):
        text, _ = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '--fill', 'refine', '--print-config')
        self.write('job.toml', text)
        self.run_cover('mesh', '--config', 'job.toml', '-q')
        self.assertIn('d.vtu', self.files())

    def test_a_printed_configuration_does_the_same(self):
        shutil.copy(SAMPLES / 'diode.poly', self.dir)
        for words in ([], ['-v'], ['-vv'], ['--split-interfaces'], ['--split-interfaces', '100'], ['--paper', '--pieces', '3'],
                      ['--size', '1', '--size', '2=0.5', '--growth', '1.5'], ['--method', 'nonobtuse', '--no-inner-lines'],
                      ['--fill', 'disks'], ['--max-angle', '110', '--min-angle', '0', '--require', 'bound,max-angle'],
                      ['--merge-materials', '--unit', 'nm', '--scale', '1e-9', '--order', '2', '-q', '-j', '1']):
            command = ['mesh', 'diode.poly', '-o', 'd.vtu', '-o', 'd.msh', '--report', 'd.json', *words]
            runs = []
            self.write('job.toml', self.run_cover(*command, '--print-config')[0])
            for run in (command, ['mesh', '--config', 'job.toml']):
                for file in self.dir.glob('d.*'):
                    file.unlink()
                said = [re.sub(r'[\d.]+ s\b', '', text) for text in self.run_cover(*run)]  # times
                files = {file.name: file.read_bytes() for file in self.dir.glob('d.*')}
                report = re.sub(rb'"seconds": [\d.e-]+', b'', files.pop('d.json'))
                runs.append((said, files, report))
            self.assertTrue(runs[0] == runs[1], words)  # too long to be shown

    def test_verbose_false(self):
        self.write('job.toml', 'verbose=false\n')
        self.assertEqual(self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '--config', 'job.toml')[1], '')

    def test_unknown_key(self):
        self.write('job.toml', 'fil = "refine"\n')
        _, err = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '--config', 'job.toml', code=2)
        self.assertIn("unknown key 'fil' in the --config file; did you mean '--fill'?", err)

    def test_section(self):
        self.write('job.toml', '[mesh]\nfill = "refine"\n')
        _, err = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '--config', 'job.toml', code=2)
        self.assertIn('has a section [mesh]; its keys stand without sections', err)

    def test_wrong_value(self):
        self.write('job.toml', 'max-angle = "large"\n')
        _, err = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '--config', 'job.toml', code=2)
        self.assertIn("--max-angle: 'large' is not a number", err)

    def test_missing_file(self):
        _, err = self.run_cover('mesh', 'a.poly', '-o', 'd.vtu', '--config', 'none.toml', code=2)
        self.assertIn('none.toml', err)


class BadInput(Case):
    """Each fault of the geometry ends with its exit code and a message that names file, ids and place."""

    def refuse(self, text, code, *parts):
        self.write('bad.poly', text)
        _, err = self.run_cover('mesh', 'bad.poly', '-o', 'bad.vtu', '--strict', code=code)
        self.assertTrue(err.startswith('cover: error: '), err)
        for part in parts:
            self.assertIn(part, err)
        self.assertNotIn('bad.vtu', self.files())

    def test_missing_file(self):
        _, err = self.run_cover('mesh', 'none.poly', '-o', 'a.vtu', code=5)
        self.assertIn('none.poly', err)

    def test_strict_says_its_name(self):
        # Two polygons that cross: both their edges are split.
        self.write('d.json', json.dumps({'polygons': [
            {'material': 'a', 'rings': [[[0, 0], [2, 0], [2, 2], [0, 2]]]},
            {'material': 'b', 'rings': [[[1, 0], [3, 0], [3, 1], [1, 1]]]}]}))
        _, err = self.run_cover('mesh', 'd.json', '-o', 'd.vtu', '--strict', code=3)
        self.assertIn('--strict refuses every change', err)
        # Corners on sides are what painting is for.
        self.run_cover('mesh', SAMPLES / 'tft.json', '-o', 'd.vtu', '--strict')

    def test_truncated(self):
        self.refuse(SQUARE[:30], 5, 'bad.poly')

    def test_not_a_number(self):
        self.refuse(SQUARE.replace('3 1 1', '3 one 1'), 5, 'bad.poly:4')

    def test_not_finite(self):
        self.refuse(SQUARE.replace('3 1 1', '3 nan 1'), 3, 'bad.poly:4')

    def test_unknown_point(self):
        self.refuse(SQUARE.replace('4 4 1\n0', '4 4 9\n0'), 3, 'bad.poly', '9')

    def test_crossing(self):
        self.refuse(SQUARE.replace('4 0\n1 1 2', '5 0\n5 2 4\n1 1 3'), 3, '(0.5, 0.5)')

    def test_what_would_mesh_it_is_said(self):
        text = SQUARE.replace('4 0\n1 1 2', '3 0\n1 1 2').replace('4 4 1\n', '')
        self.refuse(text, 3, '--weld auto', '--hull meshes the convex hull')
        self.run_cover('mesh', 'bad.poly', '-o', 'hull.vtu', '--hull', '-q')

    def test_nothing_enclosed(self):
        self.refuse('2 2 0 0\n1 0 0\n2 1 0\n1 0\n1 1 2\n0\n', 3)

    def test_no_segments(self):
        self.refuse('2 2 0 0\n1 0 0\n2 1 0\n0 0\n0\n', 3)

    def test_seed_in_the_void(self):
        self.refuse(SQUARE + '1\n1 5 5 1 -1\n', 3, '(5, 5)')

    def test_folder_that_is_not_there(self):
        _, err = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'no/such/d.vtu', code=5)
        self.assertIn('no/such/d.vtu', err)


class Check(Case):
    def setUp(self):
        super().setUp()
        self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '-q')

    def test_other_input(self):
        out, _ = self.run_cover('check', SAMPLES / 'waveguide.poly', 'd.vtu', code=6)
        self.assertIn('FAILED promise 1', out)

    def test_groups_instead_of_materials(self):
        mosfet = SAMPLES / 'mosfet.poly'
        self.run_cover('mesh', mosfet, '-o', 'm.msh', '-o', 'm.inp', '-q')
        for name in ('m.msh', 'm.inp'):
            out, _ = self.run_cover('check', mosfet, name)
            self.assertIn('All that was checked holds: ', out)
            self.assertIn('Not checked: which material has which number', out)
        # A triangle in the group of another region.
        text = (self.dir / 'm.msh').read_text()
        wrong, count = re.subn(r'(?m)^(\d+ 2 2) 1 ', r'\1 2 ', text, count=1)
        self.assertEqual(count, 1)
        self.write('w.msh', wrong)
        self.assertIn('FAILED materials', self.run_cover('check', mosfet, 'w.msh', code=6)[0])
        self.run_cover('mesh', mosfet, '-o', 'm.json', '-q')
        out, _ = self.run_cover('check', mosfet, 'm.msh')
        self.assertIn('Every promise holds', out)
        self.assertNotIn('Not checked', out)
        manifest = json.loads((self.dir / 'm.json').read_text())
        manifest['regions'][0]['material'] = 9
        self.write('m.json', json.dumps(manifest))
        self.assertIn('FAILED materials', self.run_cover('check', mosfet, 'm.msh', code=6)[0])

    def test_says_what_was_not_checked(self):
        diode = SAMPLES / 'diode.poly'
        out, _ = self.run_cover('check', diode, 'd.vtu')
        self.assertRegex(out, r'^Every promise holds: [\d,]+ triangles, 4 regions, \d+ segments whole\n'
                              r'Regions beside their targets and proven limits: [^\n]*\n$')
        out, _ = self.run_cover('check', diode, 'd.vtu', '--no-bound')
        self.assertRegex(out, r'^All that was checked holds.*\nRegions beside .*\nNot checked: the bound on the largest angle \(promise 3\)\n$')
        self.run_cover('mesh', diode, '-o', 's.vtu', '--method', 'nonobtuse', '-q')
        out, _ = self.run_cover('check', diode, 's.vtu')
        self.assertRegex(out, r'^Segments are cut at \d+ points by the run itself: its field data say so\nEvery promise holds')
        self.run_cover('mesh', diode, '-o', 'alone.msh', '--method', 'nonobtuse', '-q')
        out, _ = self.run_cover('check', diode, 'alone.msh', code=6)
        self.assertIn('add --allow-split', out.splitlines()[0])
        # A run that tells of its cuts is taken at its word, and its promises are checked on the pieces.
        self.run_cover('mesh', diode, '-o', 's.vtm', '-o', 's.json', '--method', 'nonobtuse', '-q')
        for mesh in ('s.vtm', 's.vtu'):
            out, _ = self.run_cover('check', diode, mesh)
            self.assertRegex(out, r'^Segments are cut at \d+ points by the run itself: --method nonobtuse\nEvery promise holds')
        (self.dir / 's.json').unlink()
        out, _ = self.run_cover('check', diode, 's.vtu', '--allow-split')
        self.assertIn('Not checked: that segments are one edge each (promise 1)\n', out)
        self.assertIn('Not checked: the bound', out)
        out, _ = self.run_cover('check', SAMPLES / 'coax.poly', 's.vtu', code=6)
        self.assertNotIn('--allow-split', out)

    def test_cuts_of_split_interfaces(self):
        plate = SAMPLES / 'plate.poly'
        out, _ = self.run_cover('mesh', plate, '-o', 's.msh', '-o', 's.json', '--report', 's.html', '--split-interfaces')
        self.assertRegex(out, r'\(\d+ new, 7 of them on segments\)')
        self.assertIn('The 27 segments are cut into 34, as was asked for; each piece is one edge',
                      (self.dir / 's.html').read_text())
        out, _ = self.run_cover('check', plate, 's.msh')
        self.assertRegex(out, r'^Segments are cut at 7 points by the run itself: --split-interfaces 90\nEvery promise holds')
        (self.dir / 's.json').unlink()
        out, _ = self.run_cover('check', plate, 's.msh', code=6)
        self.assertIn('--split-interfaces, --box-method or --method nonobtuse, add --allow-split', out.splitlines()[0])

    def test_one_region(self):
        self.write('s.poly', SQUARE)
        self.run_cover('mesh', 's.poly', '-o', 's.vtu', '-q')
        self.assertIn(' 1 region, ', self.run_cover('check', 's.poly', 's.vtu')[0])

    def test_not_a_mesh(self):
        self.write('x.vtu', 'nothing')
        self.assertIn('x.vtu', self.run_cover('check', SAMPLES / 'diode.poly', 'x.vtu', code=5)[1])

    def test_missing_mesh(self):
        self.assertIn('none.vtu', self.run_cover('check', SAMPLES / 'diode.poly', 'none.vtu', code=5)[1])


class Info(Case):
    def test_regions_and_lines(self):
        out, _ = self.run_cover('info', SAMPLES / 'mosfet.poly')
        self.assertIn('9 regions', out)
        self.assertRegex(out, r'material_4_outline .* 13\n')
        self.assertRegex(out, r'\d+ +material_\w+ +interface +material_\w+ +material_\w+ +\d+ +[\d.]+')

    def test_unknown_format(self):
        self.write('foo.dat', '')
        _, err = self.run_cover('info', 'foo.dat', code=5)
        for extension in ('.poly', '.json', '.geojson', '.msh', '.vtu', '.vtp', '.vtk'):
            self.assertIn(extension, err)

    def test_areas_add_up(self):
        out, _ = self.run_cover('info', SAMPLES / 'waveguide.poly')
        areas = [float(line.split()[4]) for line in out.splitlines() if line.strip()[:1].isdigit() and ' material_' in line
                 and line.split()[3].isdigit()]
        self.assertEqual(len(areas), 5)
        self.assertAlmostEqual(sum(areas), 6 * 5, places=3)


class Render(Case):
    def setUp(self):
        super().setUp()
        self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '-q')

    def test_both_formats(self):
        self.run_cover('render', 'd.vtu', '-o', 'd.png', '-o', 'd.svg', '--color', 'max_angle', '--window=-1,-1,1,1')
        self.assertEqual((self.dir / 'd.png').read_bytes()[1:4], b'PNG')
        self.assertIn('max_angle', (self.dir / 'd.svg').read_text())

    def test_to_stdout(self):
        out, err = self.run_cover('render', 'd.vtu', '-o', '-')
        self.assertIn('</svg>', out)
        self.assertEqual(err, '')
        done = subprocess.run([PROGRAM, 'render', 'd.vtu', '-o', '-', '--format', 'png'], cwd=self.dir, timeout=60,
                              stdout=subprocess.PIPE)
        self.assertEqual((done.returncode, done.stdout[1:4]), (0, b'PNG'))

    def test_empty_window(self):
        _, err = self.run_cover('render', 'd.vtu', '-o', 'd.svg', '--window=1000,1000,1001,1001')
        self.assertIn('the window shows nothing: the mesh lies between (', err)
        self.assertEqual(self.run_cover('render', 'd.vtu', '-o', 'd.svg', '--window=-1,-1,1,1')[1], '')

    def test_unknown_array(self):
        _, err = self.run_cover('render', 'd.vtu', '-o', 'd.png', '--color', 'stress', code=2)
        self.assertIn("no cell array 'stress'; it has", err)

    def test_unknown_format(self):
        self.assertIn('.svg, .png', self.run_cover('render', 'd.vtu', '-o', 'd.gif', code=2)[1])


class Convert(Case):
    def setUp(self):
        super().setUp()
        self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '-o', 'd.vtm', '-o', 'd.poly', '-q')

    def test_names_from_the_vtm(self):
        _, err = self.run_cover('convert', 'd.vtu', '-o', 'e.vtu', '-o', 'e.vtm')
        self.assertEqual(err, '')
        self.assertEqual((self.dir / 'e.vtu').read_bytes(), (self.dir / 'd.vtu').read_bytes())
        self.assertEqual((self.dir / 'e.vtm').read_text().replace('"e/e_', '"d/d_'), (self.dir / 'd.vtm').read_text())

    def test_from_a_vtm(self):
        self.run_cover('convert', 'd.vtm', '-o', 'e.vtu')
        self.assertEqual((self.dir / 'e.vtu').read_bytes(), (self.dir / 'd.vtu').read_bytes())
        self.run_cover('check', SAMPLES / 'diode.poly', 'e.vtu')

    def compare_ways(self, sources, *options):
        """A mesh written in every format, and in every format again from what each source holds."""
        written = [f'd.{e}' for e in ('vtu', 'vtm', 'vtkhdf', 'vtk', 'msh', 'xdmf', 'mesh', 'inp', 'ele', 'obj', 'off',
                                      'ply', 'svg', 'png')]
        words = [word for name in written for word in ('-o', name)]
        self.run_cover('mesh', SAMPLES / 'mosfet.poly', *words, '-o', 'd.json', '-q', *options)
        direct = {p.relative_to(self.dir) for p in self.dir.rglob('*.*') if p.suffix not in ('.json', '.poly')}
        self.assertGreater(len(direct), len(written))  # .node, .edge, the blocks of the .vtm
        for source in sources:
            folder = self.dir / ('from_' + source)
            folder.mkdir()
            done = subprocess.run([PROGRAM, 'convert', '../' + source, *words], cwd=folder, timeout=60, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.assertEqual((done.returncode, done.stderr), (0, ''), source)
            for name in direct:
                self.assertEqual((folder / name).read_bytes(), (self.dir / name).read_bytes(), f'{source} into {name}')

    def test_every_format_into_every_other(self):
        self.compare_ways(('d.vtu', 'd.vtm', 'd.vtkhdf', 'd.vtk', 'd.msh', 'd.xdmf', 'd.mesh', 'd.ele'))

    def test_abaqus_into_every_other(self):
        # An .inp has 20 characters for each coordinate: those of the device fit, not of every new vertex.
        self.compare_ways(('d.inp',), '--max-angle', '178', '--min-angle', '0')

    def test_says_what_is_missing(self):
        (self.dir / 'd.vtm').unlink()
        _, err = self.run_cover('convert', 'd.vtu', '-o', 'e.vtm')
        self.assertIn('neither d.json nor d.vtm is there', err)
        self.assertIn('e.vtm', self.files())

    def test_not_ours(self):
        self.write('x.vtu', 'rubbish')
        _, err = self.run_cover('convert', 'x.vtu', '-o', 'e.vtm', code=5)
        self.assertIn('x.vtu:1: no valid XML', err)
        self.assertNotIn('ERR', err)


class Page(Case):
    """The HTML report: whole, self-contained, and without an error in a browser."""

    def page(self, sample):
        self.run_cover('mesh', SAMPLES / sample, '-o', 'd.vtu', '--report', 'd.html', '-q')
        return (self.dir / 'd.html').read_text()

    def test_says_what_matters(self):
        text = self.page('diode.poly')
        for part in ('targets reached', 'Valid: no gap', 'holds in all 4 regions', 'Meshed as it is', 'lowest rho',
                     'marker 1', 'box method', 'Time, on', '<svg ', 'id="mesh-view"', 'diode.poly; method quality, cover 0.'):
            self.assertIn(part, text)
        # Findings, two rows of heads and four regions, the box method, times.
        self.assertEqual(text.count('<tr>') + text.count('<tr class') + text.count('<tr data'), 6 + 2 + 4 + 9 + text.count(' s</td></tr>'))
        self.assertNotIn('class="bad"', text)

    def test_tells_what_to_distrust(self):
        # A segment that is seen at 179 degrees, and one that a polygon's corner cuts.
        self.write('d.json', json.dumps({'polygons': [
            {'material': 'Air', 'rings': [[[0, 0], [100, 0], [100, 0.5], [0, 0.5]]]},
            {'material': 'Si', 'rings': [[[0, 0.5], [50, 0.5], [50, 20], [0, 20]]]}]}))
        self.run_cover('mesh', 'd.json', '-o', 'd.vtu', '--report', 'd.html', '-q')
        text = (self.dir / 'd.html').read_text()
        for part in ('Promises kept; look at what is marked', 'no mesh with whole segments has less',
                     'The target of 100° is missed in 1 of 2 regions, where no mesh is better'):
            self.assertIn(part, text)
        self.assertNotIn('Changed in', text)  # corners on sides are what painting is for
        self.assertRegex(text, r'<li>region 1: the input forces an angle above 100 degrees.*; near \(')

    def test_loads_nothing(self):
        text = self.page('diode.poly').replace('http://www.w3.org/2000/svg', '')
        for word in ('http:', 'https:', ' src="http', 'import(', 'fetch(', 'XMLHttpRequest', 'WebSocket', '@import', 'url(http'):
            self.assertNotIn(word, text)
        for tag in re.findall(r'<(?:script|link|img|iframe)[^>]*>', text):
            self.assertFalse(re.search(r'(?:src|href)="(?!data:)', tag), tag)

    def test_names_cannot_leave_their_place(self):
        name = '</script><script>alert(1)</script><!--'
        self.write('d.json', json.dumps({'polygons': [
            {'material': name, 'region': name, 'rings': [[[0, 0], [1, 0], [1, 1], [0, 1]]]}]}))
        self.run_cover('mesh', 'd.json', '-o', 'd.vtu', '--report', 'd.html', '-q')
        text = (self.dir / 'd.html').read_text()
        self.assertEqual(text.count('<script'), 2)
        self.assertNotIn('<!--', text)
        data = json.loads(text.split('id="mesh-data">')[1].split('</script>')[0])
        self.assertEqual(data['regions'][0][0], name)

    def browse(self, script, *flags):
        """The page with a script behind its own: what that writes into the body's `data-said`."""
        page = self.dir / 'd.html'
        page.write_text(page.read_text().replace('</body>', f'<script>{script}</script></body>'))
        done = subprocess.run(['chromium', '--headless', '--no-sandbox', '--enable-logging=stderr', '--use-gl=angle',
                               '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--virtual-time-budget=4000', '--force-prefers-reduced-motion',
                               f'--user-data-dir={self.dir / "profile"}', *flags, '--dump-dom', f'file://{page}'],
                              text=True, timeout=100, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([line for line in done.stderr.splitlines() if 'CONSOLE' in line], [])
        return done.stdout

    @unittest.skipUnless(shutil.which('chromium'), 'chromium is not installed: the page is not tried in a browser')
    def test_in_a_browser(self):
        self.page('mosfet.poly')
        # A click on the first row, and on to every colour; then a look at the middle.
        script = """
          const root = document.getElementById('mesh-view'), said = {};
          said.ready = root.dataset.ready;
          document.querySelector('tr[data-region]').click();
          const choose = document.getElementById('mesh-mode');
          for (const option of choose.options) { choose.value = option.value; choose.onchange(); }
          said.modes = [...choose.options].map(o => o.value);
          setTimeout(() => {
            const box = root.querySelector('canvas.over').getBoundingClientRect();
            root.querySelector('canvas.over').dispatchEvent(new PointerEvent('pointermove',
              { clientX: box.left + box.width / 2, clientY: box.top + box.height / 2, pointerType: 'mouse' }));
            const m = root.meshView;
            said.tip = root.querySelector('.tip').textContent;
            said.marked = m.marked; said.hovered = m.hovered; said.largest = m.largest(m.marked); said.count = m.count;
            said.scroll = document.documentElement.scrollWidth <= innerWidth;
            document.body.dataset.said = JSON.stringify(said);
          }, 2000);"""
        dom = self.browse(script)
        for part in ('holds in all 9 regions', '</footer>'):
            self.assertIn(part, dom)
        said = json.loads(re.search(r'data-said="([^"]*)"', dom).group(1).replace('&quot;', '"'))
        self.assertIn(said['ready'], ('webgl', 'canvas'))
        self.assertEqual(said['modes'], ['regions', 'largest', 'smallest', 'coupling', 'gap'])
        self.assertEqual(said['marked'], said['hovered'], said)
        self.assertTrue(said['scroll'], 'wider than the window')
        first = re.search(r'<tr[^>]* data-region="\d+"[^>]*>(.*?)</tr>', dom).group(1)
        self.assertIn(f'>{said["largest"]:.2f}<', first)
        self.assertIn('couplings', said['tip'])

    def test_bytes_per_triangle(self):
        self.page('motor_slot.poly')
        text = (self.dir / 'd.html').read_text()
        data = json.loads(text.split('id="mesh-data">')[1].split('</script>')[0])
        arrays = sum(len(data[k]) for k in ('points', 'corners', 'lines', 'angles'))
        self.assertLess(arrays / data['all'], 40)


class Names(Case):
    """Names and numbers on their way out: as they are, or told what they became."""
    NAMES = ('Größe µm 日本', 'a/b "c" <d>&', 'Si', 'si')

    def setUp(self):
        super().setUp()
        squares = [{'material': 'Stoff ' + name, 'region': name,
                    'rings': [[[k, 0], [k + 1, 0], [k + 1, 1], [k, 1]]]} for k, name in enumerate(self.NAMES)]
        self.write('d.json', json.dumps({'polygons': squares, 'lines': [{'name': 'Kontakt Ä', 'points': [[0, 0], [1, 0]]}]}))

    def regions_of(self, mesh):
        self.run_cover('convert', mesh, '-o', 'out.json', '-q')
        return [(r['name'], r['material_name']) for r in json.loads((self.dir / 'out.json').read_text())['regions']]

    def test_survive_alone_in_files_that_bear_them(self):
        for mesh in ('m.vtm', 'm.vtkhdf'):
            self.run_cover('mesh', 'd.json', '-o', mesh, '-q')
            self.assertEqual(self.regions_of(mesh), [(n, 'Stoff ' + n) for n in self.NAMES], mesh)

    def test_in_msh_and_xdmf(self):
        self.run_cover('mesh', 'd.json', '-o', 'm.msh', '-o', 'm.xdmf', '-q')
        text = (self.dir / 'm.msh').read_text()
        for name in ('Größe µm 日本', 'a/b _c_ <d>&', 'Kontakt Ä'):
            self.assertIn(f'"{name}"', text)
        self.assertIn('Name="a/b _c_ &lt;d&gt;&amp;"', (self.dir / 'm.xdmf').read_text())

    def test_where_they_cannot_it_is_told(self):
        out, _ = self.run_cover('mesh', 'd.json', '-o', 'm.inp', '-o', 'm.json')
        sets = re.findall(r'ELSET=(\S+)', (self.dir / 'm.inp').read_text())
        self.assertEqual(len(set(sets)), 4)  # Si and si are two
        groups = json.loads((self.dir / 'm.json').read_text())['region_groups']
        self.assertEqual([g.get('set', g['name']) for g in groups], sets)
        self.assertEqual([g['original'] for g in groups], list(self.NAMES))
        for name, made in zip(self.NAMES, sets):
            if made != name.upper():
                self.assertRegex(out, re.escape(made) + r' +' + re.escape(name.replace('"', '_')))
        self.assertRegex(out, r'KONTAKT___ +Kontakt Ä')
        self.assertNotIn('in .inp', self.run_cover('mesh', self.write('s.poly', SQUARE), '-o', 's.inp')[0])

    def test_ids(self):
        squares = [{'material': 'Cu', 'region': f'coil {k}', 'rings': [[[2 * k, 0], [2 * k + 1, 0], [2 * k + 1, 1], [2 * k, 1]]]}
                   for k in range(6)]
        self.write('coils.json', json.dumps({'polygons': squares}))
        labels = {}
        for ids in ('region', 'material', 'name'):
            out, _ = self.run_cover('mesh', 'coils.json', '-o', 'm.mesh', '--ids', ids)
            self.assertIn(f'Numbers in the files, by {ids}:', out)
            rows = (self.dir / 'm.mesh').read_text().split('Triangles')[1].splitlines()[2:]
            labels[ids] = len({row.split()[3] for row in rows if len(row.split()) == 4})
        self.assertEqual(labels, {'region': 6, 'material': 1, 'name': 6})
        _, err = self.run_cover('mesh', 'coils.json', '-o', 'm.mesh', '--ids', 'colour', code=2)
        self.assertIn('ids are region, material or name, not colour', err)


class Values(Case):
    """Attributes of maps and values at nodes, from the input to the files."""

    def setUp(self):
        super().setUp()
        square = lambda k: [[[k, 0], [k + 1, 0], [k + 1, 1], [k, 1], [k, 0]]]
        self.properties = [{'use': 'Wald', 'height': 2.5, 'material': 'a'}, {'use': 'Äcker & "Wiese"', 'material': 'b'},
                           {'use': 'Wald', 'height': -1, 'material': 'c'}]
        self.write('m.geojson', json.dumps({'type': 'FeatureCollection', 'features': [
            {'type': 'Feature', 'id': 40 + k, 'properties': p, 'geometry': {'type': 'Polygon', 'coordinates': square(k)}}
            for k, p in enumerate(self.properties)]}))

    def arrays(self, name, section, part):
        """Of a .vtu: by name the numbers of an array."""
        data = (self.dir / name).read_bytes()
        head, tail = data.split(b'<AppendedData encoding="raw">\n   _', 1)
        root = ElementTree.fromstring(head + b'</VTKFile>')
        found = {}
        for array in root.find(f'.//{section}').iter('DataArray'):
            at = int(array.get('offset'))
            size = int.from_bytes(tail[at:at + 8], 'little')
            kind = {'Int32': 'i', 'Float64': 'd', 'Int64': 'q', 'UInt8': 'B'}[array.get('type')]
            found[array.get('Name')] = memoryview(tail[at + 8:at + 8 + size]).cast(kind).tolist()
        return found[part]

    def msh_data(self, name, kind):
        """By name, the values of $ElementData or $NodeData by number."""
        found = {}
        for block in re.findall(rf'\${kind}Data\n(.*?)\$End{kind}Data', (self.dir / name).read_text(), re.S):
            lines = block.splitlines()
            self.assertEqual(lines[:1] + lines[2:7], ['1', '1', '0', '3', '0', '1'])
            self.assertEqual(int(lines[7]), len(lines) - 8)
            found[lines[1].strip('"')] = {int(n): float(v) for n, v in (line.split() for line in lines[8:])}
        return found

    KEEP = ('--keep-field', 'use', '--keep-field', 'height', '--keep-field', 'fid')

    def test_attributes_become_arrays_of_triangles(self):
        files = [word for f in ('m.vtu', 'm.vtm', 'm.vtkhdf', 'm.msh', 'm.json') for word in ('-o', f)]
        self.run_cover('mesh', 'm.geojson', *self.KEEP, *files)
        region = self.arrays('m.vtu', 'CellData', 'RegionId')
        heights = [2.5, math.nan, -1]
        for name, values in ('use', [1, 2, 1]), ('height', heights), ('fid', [40, 41, 42]):
            self.assertEqual(str(self.arrays('m.vtu', 'CellData', name)), str([type(values[0])(values[r - 1]) for r in region]).replace('41.0', '41') if name == 'use'
                             else str([float(values[r - 1]) for r in region]))
        manifest = json.loads((self.dir / 'm.json').read_text())
        words = ['Wald', 'Äcker & "Wiese"']
        self.assertEqual(manifest['attributes'], [
            {'name': 'use', 'words': words, 'values': ['Wald', words[1], 'Wald']},
            {'name': 'height', 'values': [2.5, None, -1]}, {'name': 'fid', 'values': [40, 41, 42]}])
        names = ElementTree.parse(self.dir / 'm.vtm').getroot().find("CoverNames/Attribute[@Name='use']")
        self.assertEqual([(w.get('Id'), w.get('Name')) for w in names], [('1', words[0]), ('2', words[1])])
        self.assertIn(words[1].encode(), (self.dir / 'm.vtkhdf').read_bytes())
        for version in '2.2', '4.1':
            self.run_cover('mesh', 'm.geojson', *self.KEEP, '--msh', version, '-o', 'n.msh')
            data = self.msh_data('n.msh', 'Element')
            self.assertEqual(set(data), {'use', 'height', 'fid'})
            text = (self.dir / 'n.msh').read_text().split('$Elements\n')[1].split('$End')[0]
            elements = len(data['fid'])
            self.assertEqual(int(text.split()[0 if version == '2.2' else 1]), elements)
            if version == '2.2':
                for line in text.splitlines()[1:]:
                    number, kind, _, group = map(int, line.split()[:4])
                    if kind == 2:
                        self.assertEqual(data['fid'][number], 39 + group)
        # The mesh itself is the same, and is read back with the arrays in it.
        self.run_cover('mesh', 'm.geojson', '-o', 'plain.vtu')
        self.assertEqual(self.arrays('plain.vtu', 'Points', 'Points'), self.arrays('m.vtu', 'Points', 'Points'))
        for name in ('m.vtu', 'm.vtm', 'm.vtkhdf', 'm.msh', 'n.msh'):
            self.run_cover('check', 'm.geojson', name)

    def test_names_that_are_taken(self):
        text = (self.dir / 'm.geojson').read_text().replace('"use"', '"RegionId"').replace('"height"', '"a/b"')
        self.write('m.geojson', text)
        self.run_cover('mesh', 'm.geojson', '--keep-field', 'RegionId', '--keep-field', 'a/b', '-o', 'm.vtu', '-o', 'm.vtkhdf', '-o', 'm.json')
        self.assertEqual(set(self.arrays('m.vtu', 'CellData', 'RegionId')), {1, 2, 3})
        self.assertEqual(set(self.arrays('m.vtu', 'CellData', 'RegionId_2')), {1, 2})
        self.assertEqual([(a['name'], a['original']) for a in json.loads((self.dir / 'm.json').read_text())['attributes']],
                         [('RegionId_2', 'RegionId'), ('a_b', 'a/b')])
        self.run_cover('check', 'm.geojson', 'm.vtkhdf')

    def test_convert_keeps_them(self):
        self.run_cover('mesh', 'm.geojson', *self.KEEP, '-o', 'm.vtm')
        for source, target in ('m.vtm', 'a.vtkhdf'), ('a.vtkhdf', 'b.msh'), ('a.vtkhdf', 'b.json'), ('b.msh', 'c.vtu'), ('m.vtm', 'd.vtu'):
            self.run_cover('convert', source, '-o', target)
        self.assertEqual(self.arrays('c.vtu', 'CellData', 'use'), self.arrays('d.vtu', 'CellData', 'use'))
        self.assertEqual(sorted(map(str, self.arrays('c.vtu', 'CellData', 'height'))), sorted(map(str, self.arrays('d.vtu', 'CellData', 'height'))))
        kept = {a['name']: a for a in json.loads((self.dir / 'b.json').read_text())['attributes']}
        self.assertEqual(kept['use'], {'name': 'use', 'words': ['Wald', 'Äcker & "Wiese"'], 'values': ['Wald', 'Äcker & "Wiese"', 'Wald']})
        self.assertEqual(kept['fid']['values'], [40, 41, 42])
        self.run_cover('mesh', SAMPLES / 'nmos.tif', '-o', 'd.vtkhdf', '-o', 'e.vtu')
        self.run_cover('convert', 'd.vtkhdf', '-o', 'f.vtu')
        self.assertEqual(str(self.arrays('f.vtu', 'PointData', 'Net')), str(self.arrays('e.vtu', 'PointData', 'Net')))

    def test_a_map_may_be_named_json(self):
        self.write('n.json', (self.dir / 'm.geojson').read_text())
        chosen = ('--material-field', 'use', '--name-field', 'fid', '--keep-field', 'height')
        told = self.run_cover('mesh', 'n.json', '--material-field', 'use', '--keep-field', 'height', '-o', 'o.vtu', '-o', 'o.json')[1]
        self.assertNotIn('does nothing', told)
        manifest = json.loads((self.dir / 'o.json').read_text())
        self.assertIn('Wald', [r['material_name'] for r in manifest['regions']])
        self.assertEqual(manifest['attributes'][0]['values'], [2.5, None, -1])
        self.assertIn("name_field: no feature has the property 'fid'", self.run_cover('mesh', 'n.json', *chosen, '-o', 'p.vtu', code=2)[1])
        self.write('own.json', '{"polygons": [{"material": "Si", "rings": [[[0, 0], [1, 0], [0, 1]]]}]}')
        self.assertIn('--keep-field does nothing: it counts with maps only', self.run_cover('info', 'own.json', '--keep-field', 'x')[1])

    def test_unknown_attribute(self):
        self.assertIn("keep_field: no feature has the property 'usage'",
                      self.run_cover('mesh', 'm.geojson', '--keep-field', 'usage', '-o', 'm.vtu', code=2)[1])
        self.assertIn('it counts with maps only', self.run_cover('info', SAMPLES / 'diode.poly', '--keep-field', 'x')[1])

    def test_doping_comes_back_at_the_points(self):
        for name, array in ('nmos.tif', 'Net'), ('nmos.str', None):
            self.run_cover('mesh', SAMPLES / name, '--order', '2', '-o', 'd.vtu', '-o', 'd.msh', '-o', 'd.vtm', '-o', 'd.vtkhdf', '-o', 'd.json')
            fields = [f['name'] for f in json.loads((self.dir / 'd.json').read_text())['fields']]
            self.assertTrue(fields)
            array = array or fields[0]
            values = self.arrays('d.vtu', 'PointData', array)
            self.assertEqual(len(values) * 3, len(self.arrays('d.vtu', 'Points', 'Points')))
            known = [v for v in values if not math.isnan(v)]
            self.assertGreater(max(map(abs, known)), 1e15)
            self.assertEqual(str(list(self.msh_data('d.msh', 'Node')[array].values())), str(values))
            piece = next(self.dir.glob('d/*.vtu')).relative_to(self.dir)
            numbers = self.arrays(piece, 'PointData', 'GlobalNodeId')
            self.assertEqual(str(self.arrays(piece, 'PointData', array)), str([values[n] for n in numbers]))


class Layouts(Case):
    """What is said of reading beside the file; options_test.py tests the options themselves."""
    MAP = ('--layer-map', SAMPLES / 'finfet.map')

    def materials(self, *words):
        self.run_cover('mesh', *words, '--method', 'almond', '-o', 'm.json', '-q')
        return [r['material_name'] for r in json.loads((self.dir / 'm.json').read_text())['regions']]

    def test_a_layout_from_a_pipe(self):
        data = (SAMPLES / 'finfet.gds').read_bytes()
        for words in ('-',), ('-', '--input-format', 'GDS'), ('-', '--input-format', '.gds'):
            done = subprocess.run([PROGRAM, 'info', *words, *map(str, self.MAP)], input=data, cwd=self.dir, timeout=60,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(b'HfO2', done.stdout)

    def test_the_format_counts_and_not_the_name(self):
        (self.dir / 'layout.poly').write_bytes((SAMPLES / 'finfet.gds').read_bytes())
        self.run_cover('info', 'layout.poly', code=5)
        self.assertIn('L6D0', self.run_cover('info', 'layout.poly', '--input-format', 'gds')[0])
        self.write('square.GDS', SQUARE)
        self.run_cover('info', 'square.GDS', code=5)
        self.run_cover('info', 'square.GDS', '--input-format', 'poly')

    def test_layers_and_windows(self):
        fins = self.materials(SAMPLES / 'finfet.gds', *self.MAP)
        self.assertEqual(fins.count('SiO2'), 2)
        one = self.materials(SAMPLES / 'finfet.gds', *self.MAP, '--window=-0.015,0.01,0.015,0.08')
        self.assertEqual(one.count('SiO2'), 1)
        self.assertEqual(set(self.materials(SAMPLES / 'finfet.gds', '--layer', '1', '--layer', '2/0')), {'L1D0', 'L2D0'})
        self.assertEqual(set(self.materials(SAMPLES / 'finfet.gds', *self.MAP, '--layer', 'TiN')), {'TiN'})

    def test_options_that_do_nothing_are_told(self):
        self.write('a.poly', SQUARE)
        for command in ('info', 'a.poly'), ('mesh', 'a.poly', '-o', 'a.vtu'):
            error = self.run_cover(*command, '--cell', 'TOP', '--unit', 'nm')[1]
            self.assertIn('--cell does nothing: it counts with layouts only', error)
            self.assertNotIn('--unit', error)

    def test_scales_that_round_are_told(self):
        self.write('a.poly', SQUARE.replace('3 1 1', '3 1.1 1.3'))
        error = self.run_cover('mesh', 'a.poly', '--scale', '25.4', '--unit', 'mm', '-o', 'a.json')[1]
        self.assertIn('2 of 8 coordinates times 25.4 are rounded', error)
        told = json.loads((self.dir / 'a.json').read_text())
        self.assertEqual((told['unit'], told['scale']), ('mm', 25.4))
        self.assertNotIn('rounded', self.run_cover('mesh', 'a.poly', '--scale', '1e-9', '-o', 'a.json')[1])

    def oasis(self, tools, *words, code=0):
        """cover's answer where the PATH has these programs only: shell scripts by name."""
        folder = self.dir / 'bin'
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        for name, script in tools.items():
            (folder / name).write_text('#!/bin/sh\n' + script)
            (folder / name).chmod(0o755)
        done = subprocess.run([PROGRAM, 'info', *map(str, words)], cwd=self.dir, timeout=60, env={'PATH': str(folder), 'TMPDIR': str(self.dir)},
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertEqual(list(self.dir.glob('cover-oasis-*')), [], 'a folder was left')
        return done.stdout + done.stderr

    @unittest.skipIf(pathlib.Path('/usr/lib/klayout/strm2gds').exists(), 'KLayout itself is there')
    def test_oasis_is_read_by_klayout(self):
        self.write('a.OAS', '%SEMI-OASIS')
        copy = f'/bin/cp "{SAMPLES / "finfet.gds"}" '
        # strm2gds, and klayout only where that is not there.
        told = self.oasis({'strm2gds': copy + '"$2"', 'klayout': 'exit 1'}, 'a.OAS', *self.MAP)
        self.assertIn('HfO2', told)
        self.assertNotIn('does nothing', told)
        told = self.oasis({'klayout': '[ "$1" = -b ] && [ -s "$3" ] || exit 3\n[ "${5%%=*}" = from ] || exit 4\n' + copy + '"${7#to=}"'}, 'a.OAS', *self.MAP)
        self.assertIn('HfO2', told)
        told = self.oasis({'strm2gds': 'echo "no magic bytes in it" >&2; exit 1'}, 'a.OAS', code=5)
        self.assertIn('a.OAS: KLayout makes no GDSII of it: no magic bytes in it', told)
        self.assertIn('KLayout makes no GDSII of it', self.oasis({'strm2gds': 'exit 0'}, 'a.OAS', code=5))
        told = self.oasis({}, 'a.OAS', code=5)
        self.assertIn("not installed (Debian's package klayout)", told)
        self.assertIn('b.oas', self.oasis({'strm2gds': copy + '"$2"'}, 'b.oas', code=5))
        done = subprocess.run([PROGRAM, 'info', '-', '--input-format', 'oas'], input=b'%SEMI-OASIS', stderr=subprocess.PIPE, timeout=60)
        self.assertIn(b"'strm2gds FILE.oas FILE.gds'", done.stderr)

    def test_what_cannot_be_read_is_told_how_to_convert(self):
        formats = ' '.join(self.run_cover('info', '--help')[0].split())
        for extension, words in (('.dxf', 'ogr2ogr -f GeoJSON'), ('.gpkg', 'ogr2ogr -f GeoJSON')):
            if extension not in formats:
                self.write('a' + extension, '')
                self.assertIn(words, self.run_cover('info', 'a' + extension, code=5)[1])

    def test_gdal_is_opened_for_maps_only(self):
        if '.gpkg' not in self.run_cover('info', '--help')[0] or not shutil.which('ldd'):
            self.skipTest('built without GDAL')
        linked = subprocess.run(['ldd', PROGRAM], text=True, stdout=subprocess.PIPE, check=True).stdout
        self.assertNotIn('libgdal', linked)
        name = re.search(rb'libgdal\.so\.\d+', pathlib.Path(PROGRAM).read_bytes()).group().decode()
        # A library that is not GDAL in its place: maps are refused, all else goes on.
        other = re.search(r'=> (\S*/libz\.so\S*)', linked).group(1)
        (self.dir / name).symlink_to(other)
        self.write('a.gpkg', '')
        self.write('a.poly', SQUARE)
        before = os.environ.get('LD_LIBRARY_PATH')
        os.environ['LD_LIBRARY_PATH'] = str(self.dir)
        self.addCleanup(lambda: os.environ.pop('LD_LIBRARY_PATH') if before is None
                        else os.environ.update(LD_LIBRARY_PATH=before))
        self.assertRegex(self.run_cover('info', 'a.gpkg', code=5)[1],
                         r'a\.gpkg: .*GDAL, which cannot be opened .*ogr2ogr -f GeoJSON')
        self.run_cover('info', 'a.poly')

    def test_bad_layouts(self):
        data = (SAMPLES / 'finfet.gds').read_bytes()
        (self.dir / 'cut.gds').write_bytes(data[:-20])
        self.assertRegex(self.run_cover('info', 'cut.gds', code=5)[1], r'cut\.gds: byte \d+: ')
        (self.dir / 'a.gds').write_bytes(data)
        self.assertIn("there is no cell 'X'", self.run_cover('info', 'a.gds', '--cell', 'X', code=2)[1])
        self.assertIn('no.map', self.run_cover('info', 'a.gds', '--layer-map', 'no.map', code=5)[1])
        self.assertIn("'1=' is not LAYER/DATATYPE=NAME", self.run_cover('info', 'a.gds', '--layer-map', '1=', code=2)[1])
        self.run_cover('mesh', 'a.gds', '--layer-map', 'a.vtu', '-o', 'a.vtu', code=2)


class Documents(Case):
    """Man page and completion know what the program knows."""

    def test_man_page_has_every_option(self):
        page = (APP / 'cover.1').read_text().replace('\\-', '-')
        for command in ('mesh', 'info', 'check', 'render', 'convert'):
            self.assertIn('.B ' + command, page)
            for option in re.findall(r'^ +(?:-\w,)?(--[a-z-]+)', self.run_cover(command, '--help')[0], re.M):
                if option != '--help':
                    self.assertTrue(option in page, f'{option} of {command} is missing in apps/cover/cover.1')

    @unittest.skipUnless(shutil.which('man'), 'man is not installed')
    def test_man_page_is_well_formed(self):
        done = subprocess.run(['man', '--warnings=w', '-l', APP / 'cover.1'], text=True, timeout=60,
                              env={**os.environ, 'LC_ALL': 'C.UTF-8', 'MANWIDTH': '100', 'MANPAGER': 'cat'},
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual((done.returncode, done.stderr), (0, ''))
        self.assertIn('(.vtu, .vtp, .vti, .vtk), of which', ' '.join(done.stdout.split()))

    def test_formats_are_completed(self):
        formats = re.search(r'File to write, several if repeated: (.*?);', ' '.join(self.run_cover('mesh', '--help')[0].split()))
        of_one_file = set(formats[1].split(', ')) - {'.vtm', '.pvtu', '.ele'}
        self.assertEqual({'.' + word for word in self.complete('mesh', '--format', "''")}, of_one_file)

    def test_man_page_has_the_options_of_check(self):
        page = (APP / 'cover.1').read_text()
        check = page[page.index('.SH OPTIONS OF CHECK'):page.index('.SH OPTIONS OF RENDER')].replace('\\-', '-')
        for option in ('--allow-split', '--no-bound', '--hull'):
            self.assertIn(option, check)

    def complete(self, *words):
        script = (f'source {APP / "completion.bash"}; COMP_WORDS=({PROGRAM} {" ".join(words)}); '
                  f'COMP_CWORD={len(words)}; _cover; echo "${{COMPREPLY[*]}}"')
        return subprocess.run(['bash', '-c', script], text=True, timeout=20, stdout=subprocess.PIPE).stdout.split()

    def test_completion(self):
        self.assertEqual(self.complete('me'), ['mesh'])
        self.assertEqual(self.complete('mesh', '--fi'), ['--fill'])
        self.assertEqual(self.complete('mesh', '--fill', 'd'), ['disks'])
        self.assertIn('--window', self.complete('render', '--'))
        self.assertEqual(self.complete('mesh', '--method', '=', 'qu'), ['quality'])
        self.assertEqual(self.complete('mesh', '--msh', '='), ['2.2', '4.1'])
        self.assertEqual(self.complete('render', '--format', 'p'), ['png'])
        self.assertIn('mat_id', self.complete('render', '--color', ''))
        options = self.complete('mesh', '--')
        self.assertEqual(len(options), len(set(options)))


class Interrupt(Case):
    """No half file is left, whenever the program is stopped."""

    def slits(self, n):
        """Some n * n / 2 slits in one region."""
        points, segments = ['1 0 0', '2 1 0', '3 1 1', '4 0 1'], ['1 1 2', '2 2 3', '3 3 4', '4 4 1']
        for i in range(n * n // 2):
            x, y = (i % n + 1) / (n + 1), (i // n + 1) / (n + 1) * 2
            points += [f'{2 * i + 5} {x} {y / 1.1}', f'{2 * i + 6} {x + 0.001} {y / 1.1 + 0.0005}']
            segments.append(f'{i + 5} {2 * i + 5} {2 * i + 6}')
        return self.write('big.poly', f'{len(points)} 2 0 0\n' + '\n'.join(points) + f'\n{len(segments)} 0\n' +
                          '\n'.join(segments) + '\n0\n')

    def start(self, *words, **more):
        run = subprocess.Popen([PROGRAM, 'mesh', *words], cwd=self.dir, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, **more)
        self.addCleanup(run.wait)
        self.addCleanup(run.kill)
        self.addCleanup(run.stderr.close)
        return run

    def test_while_meshing(self):
        # Long enough to be caught at work on any machine, and to have nothing to tell for seconds.
        run = self.start(self.slits(300), '-o', 'big.vtu', '--progress', 'on')
        seen = b''
        while not re.search(rb'mesh .* 0 % +\d+ s', seen):
            more = os.read(run.stderr.fileno(), 4096)
            self.assertTrue(more, seen)
            seen += more
        run.send_signal(signal.SIGINT)
        sent = time.monotonic()
        out, err = run.communicate(timeout=60)
        self.assertLess(time.monotonic() - sent, 20)
        self.assertEqual(run.returncode, 130, (seen + err)[-300:])
        self.assertEqual(self.files(), ['big.poly'])

    def test_while_writing(self):
        names = [f'{k}.{e}' for k in range(4) for e in ('msh', 'vtk', 'mesh', 'vtm')]
        run = self.start(self.slits(120), '--method', 'almond', *(w for n in names for w in ('-o', n)))
        while not any(name.startswith('.') for name in self.files()):
            self.assertIsNone(run.poll(), run.stderr)
        run.send_signal(signal.SIGINT)
        time.sleep(0.01)
        run.send_signal(signal.SIGINT)
        run.communicate(timeout=60)
        self.assertIn(run.returncode, (0, 130))
        files = [name for name in self.files() if name != 'big.poly']
        self.assertEqual([name for name in files if name.startswith('.')], [])
        for kind in 'msh', 'vtk', 'mesh':
            whole = {(self.dir / name).read_bytes() for name in files if name.endswith('.' + kind)}
            self.assertLessEqual(len(whole), 1, kind)

    def test_when_nobody_reads(self):
        folder = self.dir / 'tmp'
        folder.mkdir()
        run = self.start(self.slits(60), '--method', 'almond', '-o', '-', env={**os.environ, 'TMPDIR': str(folder)})
        run.stdout.close()
        run.stderr.read()
        self.assertNotEqual(run.wait(timeout=60), 0)
        self.assertEqual(list(folder.iterdir()), [])


if __name__ == '__main__':
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=1)
