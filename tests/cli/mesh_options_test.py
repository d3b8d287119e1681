#!/usr/bin/env python3
"""mesh_options_test.py PROGRAM SAMPLES [TEST...]: cover mesh: periodic cells, arcs, layers, sizes, parts of a mesh again."""
import json
import math
import re
import shutil

from cover_case import Case, SAMPLES, SQUARE, main


class Periodic(Case):
    CELL = {'points': [[0, 0], [2, 0], [2, 1], [0, 1]],
            'segments': [[0, 1], {'points': [1, 2], 'name': 'right'}, [2, 3], {'points': [3, 0], 'name': 'left=1'}]}

    def setUp(self):
        super().setUp()
        self.write('cell.json', json.dumps(self.CELL))

    def test_says_which_files_do_not_hold_pairs(self):
        told = "pairs on periodic sides ('left=1' and 'right') are not in a.xdmf, a.inp, a.mesh: formats that hold them are "
        rule = ('--periodic', '"left=1"=right')
        _, err = self.run_cover('mesh', 'cell.json', *rule, *(w for e in ('xdmf', 'vtu', 'inp', 'mesh') for w in ('-o', 'a.' + e)))
        self.assertIn(told, err)
        self.assertEqual(err.count('periodic'), 1)
        for names in (('a.vtu', 'a.msh'), ('a.inp', 'a.json')):
            _, err = self.run_cover('mesh', 'cell.json', *rule, *(w for name in names for w in ('-o', name)))
            self.assertNotIn('periodic', err)
        _, err = self.run_cover('convert', 'a.vtu', '-o', 'b.msh', '-o', 'b.inp')
        self.assertIn("pairs on periodic sides ('left=1' and 'right') are not in b.inp: ", err)
        for words in ('mesh', 'cell.json', *rule), ('convert', 'a.vtu'):
            self.assertIn("pairs on periodic sides ('left=1' and 'right') are not in b.poly: ",
                          self.run_cover(*words, '-o', 'b.poly')[1])

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
        self.assertRegex(out, r"^FAILED periodic 'left=1' and 'right': \d+ points without a partner, the first at \(2, "
                              r'[^F]+\nAll else that was checked holds: .*\n(Not checked: .*\n)+$')

    def test_in_the_input(self):
        self.write('cell.json', json.dumps({**self.CELL, 'periodic': [['left=1', 'right']]}))
        self.run_cover('mesh', 'cell.json', '-o', 'a.vtu', '--box-method')
        self.assertRegex(self.run_cover('check', 'cell.json', 'a.vtu')[0], r'Periodic: 2 pairs.*\nEvery promise holds')

    def test_what_meets_the_arc_of_one_side_cuts_the_arc_of_the_other(self):
        """A line that ends on the left arc, and a circle beside the right one for which its chord is halved."""
        on_arc = [0.40714838515390483, 1.1411857717999883]
        for more in {'points': [4, 5]}, {'circle': {'centre': [3.1122135623730953, 1], 'radius': 0.3, 'chords': 12}}:
            points = [[0, 0], [0, 2], [3, 0], [3, 2]] + ([[1.5, 1], on_arc] if 'points' in more else [])
            self.write('bent.json', json.dumps({'points': points, 'periodic': [['left', 'right']], 'segments': [
                {'points': [0, 1], 'arc': {'centre': [-1, 1], 'chords': 3}, 'name': 'left'},
                {'points': [2, 3], 'arc': {'centre': [2, 1], 'chords': 3}, 'name': 'right'}, [0, 2], [1, 3], more]}))
            self.run_cover('mesh', 'bent.json', '--order', '2', '-o', 'a.msh')
            out = self.run_cover('check', 'bent.json', 'a.msh')[0]
            self.assertRegex(out, r'^Periodic: \d+ pairs .*, none without a partner\nSecond order: .* lie on arcs\nEvery promise')

    def test_what_cannot_be_is_refused_and_nothing_is_written(self):
        for rule, what in (('"left=1"=rihgt', "did you mean 'right'?"),
                           ('right=right', 'a line cannot be taken to itself'),
                           ('"left=1"=right@0,0:360', 'takes every line to itself'),
                           ('"left=1"=right@0,0:20', 'the lines do not match: (0, 1) of'),
                           ('left', "'left' is not A=B, A=B@x,y:degrees or A=B@mirror")):
            self.assertIn(what, self.run_cover('mesh', 'cell.json', '--periodic', rule, '-o', 'a.vtu', code=2)[1])
        self.assertIn('periodic sides need another method', self.run_cover(
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

    def test_circles_that_touch_are_joined(self):
        """Three rods in a row round a pocket, a tube with a wire inside that touches it, and a pipe on a floor."""
        def circle(x, y, radius):
            return {'circle': {'centre': [x, y], 'radius': radius, 'chord_error': 0.01}}

        def disc(material, x, y, radius):
            return {'material': material, 'rings': [[circle(x, y, radius)]]}

        air = {'material': 'air', 'rings': [[[-6, -6], [6, -6], [6, 6], [-6, 6]]]}
        turns = [0.3 + 2 * math.pi * k / 3 for k in range(3)]
        rods = [disc('rod', 4 / 3**0.5 * math.cos(t), 4 / 3**0.5 * math.sin(t), 2) for t in turns]
        tube = [disc('tube', 0, 0, 4), disc('wire', 2.5 * math.cos(0.9), 2.5 * math.sin(0.9), 1.5)]
        floor = {'material': 'floor', 'rings': [[[-6, -6], [6, -6], [6, 0], [-6, 0]]]}
        for name, parts, regions, places in (('rods', rods, 5, 3), ('tube', tube, 3, 1),
                                             ('pipe', [floor, disc('pipe', 0.3, 0.7, 0.7)], 3, 1)):
            self.write(f'{name}.json', json.dumps({'polygons': [air, *parts]}))
            for options in [], ['--split-interfaces', '--box-method', '--order', '2']:
                out, err = self.run_cover('mesh', f'{name}.json', *options, '-o', 'a.msh', '-o', 'a.json')
                self.assertIn(f'{places} split: ', err)
                self.assertIn(f' {regions} regions', out)
                self.assertNotIn('stay straight', err)
                self.assertIn('Every promise holds', self.run_cover('check', f'{name}.json', 'a.msh')[0])
            self.assertIn('touches an arc of polygon', self.run_cover('mesh', f'{name}.json', '--strict', '-o', 'b.msh', code=3)[1])

    def test_check_looks_at_second_order_in_every_format(self):
        coax = SAMPLES / 'coax_arcs.json'
        names = ['a.msh', 'a.vtu', 'a.vtm', 'a.vtkhdf', 'a.xdmf', 'a.ele', 'a.inp', 'a.mesh']
        self.run_cover('mesh', coax, '--order', '2', *[word for name in names for word in ('-o', name)], '-q')
        told = {re.search('Second order: .*', self.run_cover('check', coax, name)[0]).group() for name in names}
        self.assertEqual(len(told), 1)
        self.assertRegex(told.pop(), r'^Second order: every Jacobian is positive everywhere; \d+ edges lie on arcs$')

    def test_convert_keeps_the_nodes_of_curved_edges(self):
        """Also of those that give way to arcs, and where no manifest tells the arcs."""
        coax = SAMPLES / 'coax_arcs.json'
        for name in 'a.msh', 'a.vtu', 'a.vtm', 'a.vtkhdf', 'a.xdmf', 'a.ele', 'a.inp', 'a.mesh':
            self.run_cover('mesh', coax, '--order', '2', '-o', name, '-o', 'direct.vtk', '-q')
            told = self.run_cover('convert', name, '--order', '2', '-o', 'b.vtk')[1]
            self.assertNotIn('nodes', told, name)
            places = [text.partition('POINTS')[2].partition('CELLS')[0] for text in
                      ((self.dir / other).read_text() for other in ('direct.vtk', 'b.vtk'))]
            self.assertEqual(places[0], places[1], name)
            self.assertRegex(self.run_cover('check', coax, 'b.vtk')[0], r'\d+ edges lie on arcs')
            told = self.run_cover('convert', name, '-o', 'c.vtu')[1]
            self.assertIn(f'{name}: triangles have six nodes, of which the corners are written: --order 2 keeps all', told)
        # Straight ones, too, and those of arcs that a manifest tells.
        self.run_cover('mesh', SAMPLES / 'diode.poly', '--order', '2', '-o', 'd.msh', '-q')
        self.assertNotIn('nodes', self.run_cover('convert', 'd.msh', '--order', '2', '-o', 'b.inp')[1])
        self.run_cover('mesh', coax, '--order', '2', '-o', 'a.msh', '-o', 'a.json', '-q')
        self.assertNotIn('nodes', self.run_cover('convert', 'a.msh', '--order', '2', '-o', 'b.vtk')[1])
        self.assertEqual((self.dir / 'b.vtk').read_text().partition('POINTS')[2].partition('CELLS')[0], places[0])

    def test_convert_refuses_nodes_that_fold_triangles_over(self):
        coax = SAMPLES / 'coax_arcs.json'
        self.run_cover('mesh', coax, '--order', '2', '-o', 'a.msh', '-q')
        lines = (self.dir / 'a.msh').read_text().splitlines()
        middles = {node for line in lines if line.split()[1:2] == ['9'] for node in line.split()[8:]}
        moved = next(k for k, line in enumerate(lines) if line.split()[0] in middles and len(line.split()) == 4
                     and abs(math.hypot(*map(float, line.split()[1:3])) - 2) < 1e-12)
        lines[moved] = lines[moved].split()[0] + ' 0.1 0.1 0'
        self.write('a.msh', '\n'.join(lines) + '\n')
        _, err = self.run_cover('convert', 'a.msh', '--order', '2', '-o', 'b.vtk', code=5)
        self.assertRegex(err, r"cannot write 'b\.vtk' of second order: with the nodes that were read, .* folded over")
        self.assertNotIn('b.vtk', self.files())

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

    def test_layers_that_want_shorter_edges_across_the_region(self):
        self.write('cap.json', json.dumps({
            'polygons': [{'material': 'Si', 'region': 'sub', 'rings': [[[0, -1], [0.2, -1], [0.2, 0], [0, 0]]]},
                         {'material': 'SiO2', 'region': 'ox', 'rings': [[[0, 0], [0.2, 0], [0.2, 0.002], [0, 0.002]]]}],
            'lines': [{'name': 'gate', 'points': [[0, 0.002], [0.2, 0.002]]}],
            'layers': [{'line': 'sub_ox', 'region': 'sub', 'first': 0.0002, 'growth': 1.2},
                       {'line': 'sub_ox', 'region': 'ox', 'first': 0.0005, 'growth': 1, 'count': 4}]}))
        words = ('mesh', 'cap.json', '--split-interfaces', '--box-method', '-o', 'cap.vtu', '--size-at', 'sub_ox=0.01')
        told = self.run_cover(*words)[1]
        self.assertRegex(told, r'be negative \(the region is thin there: --size-at LINE=0\.01 for the line across it as well, '
                               r'as at \(0\.\d+, 0\.002\), makes points of both alike\)')
        self.assertNotIn('--couplings last', told)
        self.assertNotIn('would be negative', self.run_cover(*words, '--size-at', 'gate=0.01')[1])

    def test_layers_that_give_way_to_couplings(self):
        """Walls with other numbers of points: the default, angles alone, and what the report says of both."""
        def ring(radius, chords):
            return [[{'circle': {'centre': [0, 0], 'radius': radius, 'chords': chords}}]]
        self.write('gap.json', json.dumps({'polygons': [
            {'material': 'air', 'region': 'gap', 'rings': ring(10, 36)},
            {'material': 'steel', 'region': 'rotor', 'rings': ring(9.13, 34)}]}))
        words = ['--layers', 'gap_rotor@gap=0.43,1,1']
        for method in 'quality', 'almond':
            report, out, err = self.report('gap.json', *words, '--method', method)
            [gap] = [line for region in report['regions'] for line in region.get('layers', [])]
            self.assertEqual([part['why'] for part in gap['cut_short']], ['couplings'])
            told = 'couplings inside would be negative'
            self.assertIn(told + ' (--couplings last keeps all that the bound allows)', err)
            self.assertIn(told + ', the first at', out)
            report, _, err = self.report('gap.json', *words, '--method', method, '--couplings', 'last')
            [gap] = [line for region in report['regions'] for line in region.get('layers', [])]
            self.assertEqual((gap['complete'], gap['cut_short']), (34, []))
            self.assertNotIn('does nothing', err)

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

    def test_a_field_beside_the_drawing_is_told(self):
        fine = self.fine_square()
        self.write('beside.csv', 'x,y,h\n5,5,0.1\n6,5,0.1\n6,6,0.1\n')
        _, err = self.run_cover('mesh', fine, '-o', 'd.vtu', '--size-field', 'beside.csv')
        self.assertIn('warning: the size field beside.csv lies from (5, 5) to (6, 6), and the drawing from (0, 0) to (1, 1): '
                      'the whole drawing is outside of it, where', err)
        self.assertEqual(err.count('beside.csv'), 1)
        self.write('corner.csv', 'x,y,h\n0.999,0.999,0.1\n6,0.999,0.1\n6,6,0.1\n')
        _, err = self.run_cover('mesh', fine, '-o', 'd.vtu', '--size-field', 'corner.csv')
        self.assertIn('few of its sizes count, outside of it those of the nearest place', err)
        self.write('one.csv', '0.5,0.5,0.1\n')
        self.assertNotIn('the size field', self.run_cover('mesh', fine, '-o', 'd.vtu', '--size-field', 'one.csv')[1])
        # Before what may take long, and where that fails, too.
        self.write('tiny.csv', 'x,y,h\n5,5,1e-9\n6,5,1e-9\n6,6,1e-9\n')
        _, err = self.run_cover('mesh', fine, '-o', 'd.vtm', '--split-interfaces', '--size-field', 'tiny.csv', code=2)
        self.assertRegex(err, 'the whole drawing is outside of it[^E]*error: the sizes asked for take more triangles')
        nmos = SAMPLES / 'nmos.tif'
        command = ('mesh', nmos, '--size-field', nmos, '--size-of', 'asinh(Net/1e17)', '-o', 'd.vtu')
        self.assertNotIn('the size field', self.run_cover(*command)[1])

    def test_sizes_hold_beside_a_thin_layer(self):
        """Cuts of its walls face each other, beside those for the size: short pieces beside long ones."""
        upper, lower = [[0, 20.2], [25, 18.2], [60, 10.2]], [[0, 20], [25, 18], [60, 10]]
        rings = {'rock': [[0, 0], [60, 0], *lower[::-1]], 'weak': [*lower, *upper[::-1]], 'clay': [*upper, [60, 35], [0, 40]]}
        self.write('s.json', json.dumps({'polygons': [{'material': name, 'rings': [ring]} for name, ring in rings.items()]}))
        for size in (5, 4):
            _, err = self.run_cover('mesh', 's.json', '-o', 'd.vtu', '--report', 'd.json', '--split-interfaces', '--size', size)
            self.assertNotIn('do not count', err)
            report = json.loads((self.dir / 'd.json').read_text())
            self.assertLess(max(region['largest_angle'] for region in report['regions']), 100)
            self.assertTrue(all(region['bound_held'] for region in report['regions']))

    def test_sizes_of_the_same_file_are_scaled_with_it(self):
        self.write('nmos.tif', (SAMPLES / 'nmos.tif').read_text())
        command = ('mesh', SAMPLES / 'nmos.tif', '--size-of', 'asinh(Net/1e17)', '-o', 'd.vtu')
        plain, _ = self.run_cover(*command, '--size-field', SAMPLES / 'nmos.tif')
        scaled, err = self.run_cover(*command, '--size-field', SAMPLES / 'nmos.tif', '--scale', 4, '--unit', 'um')
        self.assertNotIn('size field', err)
        self.assertEqual(plain.splitlines()[0], scaled.splitlines()[0])
        self.assertIn('; lengths in um', plain.splitlines()[0])
        # A copy is a file of its own, whose lengths are what they are.
        _, err = self.run_cover(*command, '--size-field', 'nmos.tif', '--scale', 4, '--unit', 'um')
        self.assertIn('the drawing alone was multiplied by 4, not places and lengths of the size field nmos.tif', err)
        _, err = self.run_cover(*command, '--size-field', 'nmos.tif', '--scale', '1e-6')
        self.assertRegex(err, 'the size field nmos.tif lies .*; the drawing alone was multiplied by 1e-06')

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
        # A fine spot between all vertices of the input is found.
        self.assertGreater(self.triangles(fine, '--size', '0.01 + 20*((x-0.3)^2 + (y-0.7)^2)'), 300)
        error = self.run_cover('mesh', fine, '-o', 'd.vtu', '--size', 'x - 0.3', code=2)[1]
        self.assertIn("the size 'x - 0.3' falls to zero near (0.3", error)
        # Where an expression asks for less than the shortest length, for that.
        for zero in ('abs(y)', 'max(abs(y), 0.01)'):  # so does zero itself
            self.run_cover('mesh', fine, '-o', 'z.obj', '--size', zero, '--min-size', '0.01', '--split-interfaces')
            corners = [line.split() for line in (self.dir / 'z.obj').read_text().splitlines() if line.startswith('v ')]
            self.assertGreaterEqual(sum(float(corner[2]) == 0 for corner in corners), 100)
        error = self.run_cover('mesh', fine, '-o', 'd.vtu', '--size', 'abs(y)', '--min-size', '1e-9', code=2)[1]
        self.assertIn('--min-size 1e-09 is too short', error)
        error = self.run_cover('mesh', fine, '-o', 'd.vtu', '--size', '0.001 + 100*abs(x - 0.51)')[1]
        self.assertIn('warning: the sizes asked for by expressions change too fast', error)
        floor = self.triangles(fine, '--size', '1e-9 + 0*x', '--min-size', '0.06')
        self.assertEqual(floor, self.triangles(fine, '--size', '0.06 + 0*x'))
        self.assertEqual(self.triangles(fine, '--size', '0.05 + 0.5*x', '--min-size', '0.05'), graded)
        self.assertIn('it counts with --size-field or an expression', self.run_cover('mesh', fine, '-o', 'd.vtu', '--size', '0.1', '--min-size', '0.2')[1])
        error = self.run_cover('mesh', fine, '-o', 'd.vtu', '--size', '0.1 + y)', code=2)[1]
        self.assertIn("--size: '0.1 + y)', column 8: ')' does not belong here", error)

    def test_tables_of_points(self):
        fine = self.fine_square()
        expected = self.triangles(fine, '--size-field', self.field('h.vtk', '0.05 0.05 0.3 0.3'))
        table = self.write('h.csv', 'x,y,h\n0,0,0.05\n1,0,0.05\n0,1,0.3\n1,1,0.3\n')
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

    def test_at_a_point_of_a_map_by_its_name(self):
        def feature(kind, coordinates, **properties):
            return {'type': 'Feature', 'properties': properties, 'geometry': {'type': kind, 'coordinates': coordinates}}
        self.write('m.geojson', json.dumps({'type': 'FeatureCollection', 'features': [
            feature('Polygon', [[[0, 0], [900, 0], [900, 900], [0, 900], [0, 0]]], name='field'),
            feature('Point', [400, 300], name='well1')]}))
        plain = self.triangles('m.geojson')
        self.assertGreater(self.triangles('m.geojson', '--split-interfaces', '--size-at', 'well1=5'), 4 * plain)
        _, err = self.run_cover('mesh', 'm.geojson', '-o', 'd.vtu', '--size-at', 'well=5', code=2)
        self.assertIn("did you mean 'well1'?", err)

    def test_at_interfaces_in_either_order(self):
        squares = [(0, 'a'), (1, 'b'), (5, 'b'), (6, 'a')]
        self.write('p.json', json.dumps({'polygons': [
            {'material': name, 'rings': [[[x, 0], [x + 1, 0], [x + 1, 1], [x, 1]]]} for x, name in squares]}))
        counts = [self.triangles('p.json', '--split-interfaces', '--size-at', f'{name}=0.1') for name in ('a_b', 'b_a')]
        self.assertEqual(counts[0], counts[1])
        regions = json.loads((self.dir / 'd.json').read_text())['regions']
        self.assertGreater(min(region['triangles'] for region in regions), 20)
        self.run_cover('mesh', 'p.json', '-q', '-o', 'd.msh')
        groups = re.findall(r'^1 \d+ "(.*)"$', (self.dir / 'd.msh').read_text(), re.MULTILINE)
        self.assertEqual([name for name in groups if 'outline' not in name], ['a_b'])

    def test_a_line_in_the_void_is_no_unknown_name(self):
        corners = [[0, 0], [1, 0], [1, 1], [0, 1], [3, 0], [3, 1]]
        self.write('v.json', json.dumps({'points': corners, 'segments': [[0, 1], [2, 3], {'points': [3, 0], 'name': 'left'}, [1, 2],
                                         {'points': [4, 5], 'name': 'probe'}]}))
        for words in (['--size-at', 'probe=0.1'], ['--layers', 'probe=0.01,1.2,3'], ['--periodic', 'left=probe']):
            _, err = self.run_cover('mesh', 'v.json', '-o', 'd.vtu', *words, code=2)
            self.assertIn("the line 'probe' touches no region that is meshed: it lies in the void, first from (3, 0) to (3, 1)", err)

    def pieces_of(self, line, *words):
        """The lengths of a line's edges."""
        self.run_cover('mesh', *words, '-o', 'p.mesh', '-o', 'p.json', '-q')
        lines = (self.dir / 'p.mesh').read_text().split('\n')
        first = lines.index('Vertices') + 2
        at = [[float(x) for x in row.split()[:2]] for row in lines[first:first + int(lines[first - 1])]]
        edges = [edge for known in json.loads((self.dir / 'p.json').read_text())['lines']
                 if known['name'] == line for edge in known['edges']]
        return [math.dist(at[a], at[b]) for a, b in edges]

    def test_a_line_in_equal_pieces(self):
        """As the manual says of sliding bands."""
        corners = [[0, 0], [10, 0], [10, 3], [0, 3], [0, 1], [10, 1], [4, 3]]
        self.write('strip.json', json.dumps({'points': corners, 'segments': [
            [0, 1], [1, 5], [5, 2], [2, 6], [6, 3], [3, 4], [4, 0], {'points': [4, 5], 'name': 'band'}]}))
        for count in 3, 7, 33:
            lengths = self.pieces_of('band', 'strip.json', '--split-interfaces', '--size-at', f'band={10 / count:.6g}')
            self.assertEqual(len(lengths), count)
            self.assertLess(max(lengths) - min(lengths), 1e-12)
        self.write('half.json', json.dumps({'points': [[1, 0], [-1, 0]], 'segments': [
            [1, 0], {'points': [0, 1], 'arc': {'centre': [0, 0], 'chords': 9}, 'name': 'band'}]}))
        lengths = self.pieces_of('band', 'half.json')
        self.assertEqual(len(lengths), 9)
        self.assertLess(max(lengths) - min(lengths), 1e-12)

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

    def test_values_of_the_whole_mesh(self):
        square = [[0, 0], [2, 0], [2, 2], [0, 2], [0, 0]]
        parts = [('wood', [[x / 2 for x in p] for p in square], 7), ('lake', [[2 + p[0], p[1]] for p in square], 9)]
        self.write('map.geojson', json.dumps({'type': 'FeatureCollection', 'features': [
            {'type': 'Feature', 'properties': {'material': name, 'pop': pop},
             'geometry': {'type': 'Polygon', 'coordinates': [ring]}} for name, ring, pop in parts]}))
        self.run_cover('mesh', 'map.geojson', '--keep-field', 'pop', '-o', 'k.vtm', '-q')
        self.run_cover('mesh', 'map.geojson', '--only', 'wood', '--onto', 'k.vtm', '--method', 'almond', '-o', 'l.vtm', '-q')
        for name in 'k', 'l':
            for file in sorted((self.dir / name).rglob('*.vtu')):
                if b'RegionId' in file.read_bytes() and b'pop' not in file.read_bytes():
                    self.assertIn('line', file.name)
        self.run_cover('convert', 'l.vtm', '-o', 'l.json')
        kept, = json.loads(self.bytes_of('l.json'))['attributes']
        self.assertEqual((kept['name'], kept['values']), ('pop', [7, 9]))
        shutil.copy(SAMPLES / 'nmos.tif', self.dir / 'd.tif')
        self.run_cover('mesh', 'd.tif', '-o', 'd.vtu', '-q')
        self.run_cover('mesh', 'd.tif', '-o', 'd.poly', '-q')
        _, err = self.run_cover('mesh', 'd.poly', '--only', 'region:1', '--onto', 'd.vtu', '-o', 'e.vtu')
        self.assertIn("the values 'Net' of d.vtu are left out: this input has none", err)

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
        self.assertIn('since it was made, sizes, angles, methods, names and materials may have changed, but no point', err)
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


if __name__ == '__main__':
    main()
