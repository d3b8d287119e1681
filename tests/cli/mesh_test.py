#!/usr/bin/env python3
"""mesh_test.py PROGRAM SAMPLES [TEST...]: cover mesh: what it makes, tells and writes."""
import json
import math
import os
import pty
import re
import shutil
import subprocess

from cover_case import Case, PROGRAM, SAMPLES, SQUARE, main


class Mesh(Case):
    def test_couplings_inside_are_mended_with_box_method_too(self):
        rings = [[[35, 57], [35, 29], [3, 13], [41, 56], [9, 5]]], [[[80, 30], [78, 48], [31, 46]]], [[[47, 53], [38, 92], [-5, 35]]]
        self.write('b.json', json.dumps({'polygons': [{'material': 'a', 'rings': r} for r in rings]}))
        out, err = self.run_cover('mesh', 'b.json', '--box-method', '-o', 'b.vtu')
        self.assertNotIn('cuts these sides', out)
        self.assertNotIn('negative coupling left', err)
        self.run_cover('check', 'b.json', 'b.vtu', '--box-method')

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

    def test_markers_of_points_in_a_node_file(self):
        marked = SQUARE.replace('4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n', '4 2 0 1\n1 0 0 5\n2 1 0 0\n3 1 1 -7\n4 0 1 9\n')
        self.run_cover('mesh', self.write('s.poly', marked), '-o', 's2.ele', '--size', '0.3', '--split-interfaces', '-q')
        head, *rows = (self.dir / 's2.node').read_text().splitlines()
        self.assertEqual(head.split()[1:], ['2', '0', '1'])
        found = {tuple(map(float, row.split()[1:3])): int(row.split()[3]) for row in rows}
        self.assertEqual({at: marker for at, marker in found.items() if marker}, {(0, 0): 5, (1, 1): -7, (0, 1): 9})
        self.assertGreater(len(found), 4)
        self.run_cover('check', 's.poly', 's2.ele', '--allow-split')
        self.run_cover('mesh', self.write('s.poly', SQUARE), '-o', 's2.ele', '-q')
        self.assertEqual((self.dir / 's2.node').read_text().split()[1:4], ['2', '0', '0'])

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

    def test_names_of_contacts_stay_where_cover_would_call_a_line_so(self):
        self.write('x.json', json.dumps({
            'polygons': [{'material': 'a', 'rings': [[[0, 0], [1, 0], [1, 1], [0, 1]]]},
                         {'material': 'b "q"', 'region': 'b', 'rings': [[[1, 0], [2, 0], [2, 1], [1, 1]]]},
                         {'material': 'c', 'region': 'c "q" ä', 'rings': [[[2, 0], [3, 0], [3, 1], [2, 1]]]}],
            'lines': [{'name': 'a_b', 'points': [[0, 0], [0, 1]]}]}))
        out, _ = self.run_cover('mesh', 'x.json', '-o', 'x.msh', '-o', 'x.inp', '-o', 'x.vtm')
        names = dict(re.findall(r'(?m)^1 (\d+) "(.*)"$', (self.dir / 'x.msh').read_text()))
        of = {name: tag for tag, name in names.items()}
        self.assertIn('a_b', of)
        self.assertIn('a_b_2', of)
        # The contact is on the left, the line between regions is not.
        nodes = {line.split()[0]: line.split()[1:3] for line in
                 (self.dir / 'x.msh').read_text().partition('$Nodes\n')[2].partition('$EndNodes')[0].splitlines()[1:]}
        for name, x in (('a_b', 0), ('a_b_2', 1)):
            ends = re.findall(rf'(?m)^\d+ 1 2 {of[name]} \d+ (\d+) (\d+)$', (self.dir / 'x.msh').read_text())
            self.assertTrue(ends)
            self.assertEqual({float(nodes[n][0]) for pair in ends for n in pair}, {x})
            # What is told is what the file has.
            self.assertRegex(out, rf'(?m)^ +{of[name]}  {name}$')
        self.assertRegex(out, r'(?m)^ +in \.msh +stands for *\n +c _q_ ä +c "q" ä$')
        self.assertIn('name="a_b_2"', (self.dir / 'x.vtm').read_text())
        self.assertIn('*NSET, NSET=A_B_2\n', (self.dir / 'x.inp').read_text())

    def test_quiet_says_nothing(self):
        self.assertEqual(self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '-q'), ('', ''))

    def test_options_that_do_nothing(self):
        def warnings(*words):
            return self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', *words)[1]
        self.assertIn('--max-angle does nothing', warnings('--method', 'almond', '--max-angle', 110))
        self.assertIn('--min-angle does nothing', warnings('--method', 'nonobtuse', '--min-angle', 10))
        self.assertIn('--fill does nothing', warnings('--method', 'quality', '--fill', 'disks'))
        self.assertIn("--format does nothing: it counts with '-o -' only", warnings('--format', 'msh'))
        for words in (['--fill', 'disks'], ['--max-angle', 110, '--min-angle', 10], ['--method', 'almond'],
                      ['--method', 'almond', '--max-angle', 170, '--require', 'max-angle']):
            self.assertEqual(warnings(*words), '', words)
        for option, value, extension in (('--inp-element', 'CPS', '.inp'), ('--msh', '4.1', '.msh'), ('--xdmf', 'hdf5', '.xdmf'),
                                         ('--lines', 'true', '.vtk')):
            words = [f'{option}={value}']
            told = f'{option} does nothing: it counts with {extension} only'
            self.assertIn(told, warnings(*words))
            self.assertIn(told, self.run_cover('convert', 'd.vtu', *words, '-o', 'e.mesh')[1])
            self.assertEqual(warnings(*words, '-o', 'd' + extension), '', words)
        for words in (['--ids', 'region'], ['--no-inner-lines']):
            self.assertIn(f'{words[0]} does nothing: it counts with .', warnings(*words))
            self.assertEqual(warnings(*words, '-o', 'd.msh'), '', words)
        order = [SAMPLES / 'diode.poly', '--order', 2, '-o', 'd.poly']
        self.assertIn('--order does nothing: it counts with .vtu, .vtm,', self.run_cover('mesh', *order)[1])
        for words in ('-o', 'd.vtu'), ('-o', 'd.svg'), ('--report', 'd.html'):
            self.assertEqual(self.run_cover('mesh', *order, *words)[1], '', words)
        self.assertIn('--order does nothing', self.run_cover('mesh', *order, '--report', 'd.json')[1])

    def test_missed_targets_are_told_with_v(self):
        flat = self.write('flat.poly', SQUARE.replace('2 1 0', '2 2 0').replace('3 1 1', '3 2 2').replace('4 0 1', '4 1 0.1'))
        for words, told in (((), False), (('-v',), True)):
            _, err = self.run_cover('mesh', flat, '-o', 'd.vtu', *words)
            self.assertEqual('above 100 degrees' in err, told, err)

    def test_verbose_and_log(self):
        _, err = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '-v', '--log', 'log')
        self.assertIn('cover: info: wrote d.vtu', err)
        self.assertIn('wrote d.vtu', (self.dir / 'log').read_text())

    def test_log_is_of_one_run(self):
        for name in 'd.vtu', 'e.vtu':
            self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', name, '--log', 'log')
        log = (self.dir / 'log').read_text()
        self.assertEqual(('wrote d.vtu' in log, 'wrote e.vtu' in log), (False, True))
        self.assertIn('to FILE, which is replaced', ' '.join(self.run_cover('mesh', '--help')[0].split()))

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

    def test_extensions_in_upper_case(self):
        names = ('d.vtu', 'd.ele', 'd.vtm', 'd.svg', 'd.vtkhdf')
        self.run_cover('mesh', SAMPLES / 'diode.poly', *[word for name in names for word in ('-o', name)], '-q')
        (self.dir / 'up').mkdir()
        upper = ['up/' + name.replace(name.split('.')[1], name.split('.')[1].upper()) for name in names]
        self.run_cover('mesh', SAMPLES / 'diode.poly', *[word for name in upper for word in ('-o', name)], '--report', 'up/r.JSON', '-q')
        for name, other in zip(names, upper):
            if name != 'd.vtm':
                self.assertEqual((self.dir / name).read_bytes(), (self.dir / other).read_bytes(), other)
            if name != 'd.svg':
                self.assertIn('Every promise holds', self.run_cover('check', SAMPLES / 'diode.poly', other)[0])
        _, err = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'x.ELE', '-o', 'x.node', code=2)
        self.assertIn("unknown format '.node'", err)
        _, err = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'x.ELE', '--log', 'x.node', code=2)
        self.assertIn('would replace each other', err)

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
        self.assertRegex(err, "no interface, contact, point or boundary marker of that name; there are '.*', '")
        _, err = self.run_cover('mesh', diode, '--dry-run', '--size', 'gold=1', code=2)
        self.assertRegex(err, "size for 'gold': there is no region or material of that name; there are '.*', '")
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
        self.assertRegex(out, r'0 on sides that the input encroaches, 1 that the bound forces, 0 given up for angles; '
                              r'--box-method cuts these sides\n +forced: from \(-1, 0\) to \(1, 0\), region 1\n')
        out, _ = self.run_cover('check', 'half.poly', 'd.vtm', '--box-method', code=6)
        self.assertIn('encroaches, 1 that the bound on angles forces, 0 on other sides', out)
        # Methods that the box method does not go with are not told to take it.
        out, _ = self.run_cover('mesh', 'half.poly', '-o', 'd.vtm', '--method', 'almond')
        self.assertRegex(out, 'Box method +[1-9]')
        self.assertNotIn('cuts these sides', out)
        # Grains: in ten regions a vertex has room only in cusps between two discs; in one of them there is none.
        self.run_cover('mesh', SAMPLES / 'grains.png', '-o', 'd.obj', '--report', 'r.json')
        box = json.loads((self.dir / 'r.json').read_text())['overall']['box']
        self.assertEqual([box['negative_inside'], box['negative_forced'], box['negative_given_up']], [0, 1, 0])
        # With --split-interfaces targets come first, unless couplings are asked for.
        for words, some in ((), True), (('--couplings', 'auto'), True), (('--couplings', 'first'), False):
            self.run_cover('mesh', SAMPLES / 'tft.json', '--split-interfaces', *words, '-o', 'd.obj', '--report', 'r.json')
            box = json.loads((self.dir / 'r.json').read_text())['overall']['box']
            self.assertEqual(box['negative_couplings'] > 0, some, words)
        # Beside layers nothing is cut for angles, and where targets are met all the same no coupling is negative.
        self.run_cover('mesh', SAMPLES / 'mosfet_layers.json', '--split-interfaces', '--size-at', 'channel_oxide=20',
                       '--size-at', 'oxide_gate=20', '-o', 'd.obj', '--report', 'r.json')
        self.assertEqual(json.loads((self.dir / 'r.json').read_text())['overall']['box']['negative_couplings'], 0)

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
        self.assertIn('the box method', err)

    def test_box_method_with_other_options(self):
        box = self.write('box.poly', '6 2 0 0\n1 0 0\n2 10 0\n3 10 6\n4 0 6\n5 4 1\n6 6 1\n'
                         '4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n')
        # What cuts segments by itself, or may cut none, is refused by name.
        for options, name in ((['--hull'], 'hull'), (['--method', 'nonobtuse'], 'nonobtuse'), (['--method', 'almond'], 'almond')):
            err = self.run_cover('mesh', box, '-o', 'd.vtu', '--box-method', *options, code=2)[1]
            self.assertIn('the box method', err)
            self.assertIn(name, err)
        self.run_cover('mesh', box, '-o', 'd.vtu')
        err = self.run_cover('mesh', box, '--box-method', '--only', 'unnamed', '--onto', 'd.vtu', '-o', 'e.vtu', code=2)[1]
        self.assertIn('the box method', err)
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

    def test_couplings_stay_where_segments_are_cut_for_sizes(self):
        for name, size in (('mosfet.poly', '20'), ('coax_arcs.json', '0.3'), ('motor_pole.json', '1'), ('tft.json', '50')):
            overall = self.require(SAMPLES / name, 'box-method', 0, '--split-interfaces', '--size', size)
            self.assertEqual(overall['box']['negative_couplings'], 0, name)
            self.assertLessEqual(overall['largest_angle'], 100, name)
        # One region fine and all others coarse: what is beside the fine one is graded from there.
        for name, coarse, fine in (('mosfet.poly', '50', 'material_3=5'), ('motor_pole.json', '4', 'magnet=0.5'),
                                   ('tft.json', '100', 'insulator=20')):
            overall = self.require(SAMPLES / name, 'box-method', 0, '--split-interfaces', '--size', coarse, '--size', fine)
            self.assertEqual(overall['box']['negative_couplings'], 0, name)
            self.assertLessEqual(overall['largest_angle'], 100, name)
            self.assertGreaterEqual(overall['smallest_angle'], 20, name)

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
            self.assertEqual(report['input']['points'], 8)
            self.assertEqual(report['mesh']['vertices'] - report['mesh']['cut_vertices'] - report['mesh']['steiner_vertices'], 8)
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

    def test_progress_tells_of_writing(self):
        told = self.run_cover('mesh', SAMPLES / 'coax.poly', '-o', 'd.vtu', '--progress', 'on')[1]
        self.assertIn('write', told.split('mesh')[-1])

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

    def test_pieces_need_a_folder(self):
        self.refuse("the pieces of -o 'd.poly.vtm' go into a folder 'd.poly', and the input is a file of that name",
                    'mesh', 'd.poly', '-o', 'd.poly.vtm')

    def test_a_conversion_does_not_replace_its_mesh(self):
        # It may lose what the mesh has, as nodes of second order.
        os.symlink('d.vtu', self.dir / 'link.vtu')
        for name in ('d.vtu', './d.vtu', 'link.vtu'):
            self.refuse(f"writing -o '{name}' would replace the input", 'convert', 'd.vtu', '-o', 'e.msh', '-o', name)
        self.refuse("would replace the input 'link.vtu'", 'convert', 'link.vtu', '-o', 'd.vtu')
        self.refuse('would replace the input\n', 'convert', 'd.vtm', '-o', 'd.vtm')
        # Meshing again does: all else stays as it is.
        self.run_cover('mesh', 'd.poly', '--only', '2', '--onto', 'd.vtu', '-o', 'd.vtu', '-q')

    def test_nothing_is_written_twice(self):
        mesh = ('mesh', 'd.poly')
        self.refuse("-o 'x.json' and --report './x.json' would replace each other", *mesh, '-o', 'x.json', '--report',
                    './x.json')
        self.refuse('would replace each other', *mesh, '-o', 'x.vtu', '-o', 'x.vtu')
        self.refuse('would replace each other', *mesh, '-o', 'x.ele', '--log', 'x.node')
        self.refuse('two files cannot be written to standard output', *mesh, '-o', '-', '-o', '-')
        self.refuse("standard input can be read once, so '-' names one file", 'mesh', '-', '-', '-o', 'twice.vtu')
        self.refuse('two files cannot be written to standard output', 'render', 'd.vtu', '-o', '-', '-o', '-')
        self.run_cover(*mesh, '-o', 'x.vtu', '--log', '/dev/null', '-q')

    def test_folders_are_there(self):
        for words in (('-o', 'none/x.vtu'), ('-o', 'x.vtu', '--report', 'none/r.html'),
                      ('-o', 'x.vtu', '--log', 'none/l')):
            self.refuse(f'cannot write {words[-1]}: No such file or directory', 'mesh', 'd.poly', *words, code=5)
            self.refuse('No such file or directory', 'mesh', 'd.poly', *words, '--dry-run', code=5)
        self.refuse('Is a directory', 'mesh', 'd.poly', '-o', 'x.vtu', '--log', 'd', code=5)
        self.refuse('Not a directory', 'mesh', 'd.poly', '-o', 'd.poly/x.vtu', code=5)
        self.refuse('Not a directory', 'mesh', 'd.poly', '-o', 'x.vtu', '--report', 'd.poly/r.json', code=5)
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


if __name__ == '__main__':
    main()
