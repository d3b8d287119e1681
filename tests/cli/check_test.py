#!/usr/bin/env python3
"""check_test.py PROGRAM SAMPLES [TEST...]: cover check and cover info."""
import json
import re

from cover_case import Case, SAMPLES, SQUARE, main


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
        # Groups have the names of materials.
        for name in ('m.msh', 'm.inp'):
            out, _ = self.run_cover('check', mosfet, name)
            self.assertIn('Every promise holds', out)
            self.assertNotIn('Not checked', out)
        text = (self.dir / 'm.msh').read_text()
        self.write('s.msh', text.replace('"material_3"', '"x"').replace('"material_2"', '"material_3"').replace('"x"', '"material_2"'))
        out, _ = self.run_cover('check', mosfet, 's.msh', code=6)
        self.assertRegex(out, r'FAILED promise 4 \(materials\): .* has material 2 instead of 3')
        self.write('u.msh', text.replace('"material_3"', '"x"'))
        out, _ = self.run_cover('check', mosfet, 'u.msh')
        self.assertIn('All that was checked holds: ', out)
        self.assertIn('Not checked: which material has which number', out)
        # A triangle in the group of another region.
        wrong, count = re.subn(r'(?m)^(\d+ 2 2) 1 ', r'\1 2 ', text, count=1)
        self.assertEqual(count, 1)
        self.write('w.msh', wrong)
        self.assertIn('FAILED promise 4 (materials)', self.run_cover('check', mosfet, 'w.msh', code=6)[0])
        self.run_cover('mesh', mosfet, '-o', 'm.json', '-q')
        manifest = json.loads((self.dir / 'm.json').read_text())
        manifest['regions'][0]['material'] = 9
        self.write('m.json', json.dumps(manifest))
        self.assertIn('FAILED promise 4 (materials)', self.run_cover('check', mosfet, 'm.msh', code=6)[0])

    def test_named_lines(self):
        tft = SAMPLES / 'tft.json'
        for name in ('t.msh', 't.xdmf', 't.vtkhdf'):
            self.run_cover('mesh', tft, '-o', name, '-q')
            self.assertNotIn('Not checked', self.run_cover('check', tft, name)[0])
        self.run_cover('mesh', tft, '-o', 't.vtm', '-q')
        self.assertNotIn('Not checked', self.run_cover('check', tft, 't.vtm')[0])
        for name in ('t.vtu', 't.inp', 't.mesh'):
            self.run_cover('mesh', tft, '-o', name, '-q')
            self.assertIn('\nNot checked: named lines (contacts)\n', self.run_cover('check', tft, name)[0])
        for stream in ('on', 'off'):
            self.assertIn('\nNot checked: named lines (contacts)\n', self.run_cover('check', tft, 't.vtu', '--stream', stream)[0])
        text = (self.dir / 't.msh').read_text()
        self.write('s.msh', text.replace('"gate_contact"', '"x"').replace('"drain_contact"', '"gate_contact"').replace('"x"', '"drain_contact"'))
        out, _ = self.run_cover('check', tft, 's.msh', code=6)
        for name in ('gate_contact', 'drain_contact'):
            self.assertRegex(out, rf"FAILED named lines: (\d+) of the \1 edges? of '{name}' (is|are) not there under that name\n    at \(")
            self.assertRegex(out, rf"FAILED named lines: \d+ edges? named '{name}' (is|are) not of that line\n    at \(")
        self.assertNotIn("'source_contact'", out)
        # No element of a contact.
        tag = re.search(r'1 (\d+) "source_contact"', text)[1]
        head, elements = text.split('$Elements\n')
        gone, count = re.subn(rf'(?m)^\d+ 1 2 {tag} .*\n', '', elements)
        self.assertGreater(count, 0)
        total, rest = gone.split('\n', 1)
        self.write('g.msh', f'{head}$Elements\n{int(total) - count}\n{rest}')
        out, _ = self.run_cover('check', tft, 'g.msh', code=6)
        self.assertRegex(out, rf"FAILED named lines: {count} of the {count} edges? of 'source_contact'")
        self.assertEqual(out.count('FAILED'), 1)
        # The pieces of a line together are it, whether cuts are allowed or meant.
        self.run_cover('mesh', tft, '-o', 'p.msh', '--method', 'nonobtuse', '-q')
        out, _ = self.run_cover('check', tft, 'p.msh', '--allow-split')
        self.assertNotIn('named lines', out)
        self.run_cover('mesh', tft, '-o', 'q.msh', '-o', 'q.json', '--method', 'nonobtuse', '-q')
        self.assertNotIn('named lines', self.run_cover('check', tft, 'q.msh')[0])
        # With lines of the outside alone those inside cannot be told.
        self.run_cover('mesh', tft, '-o', 'o.msh', '--no-inner-lines', '-q')
        self.assertIn('Not checked: named lines (contacts) inside the mesh', self.run_cover('check', tft, 'o.msh')[0])

    def test_digits_that_inp_leaves_out(self):
        # 7.559548074848963e-17 has 21 characters, of which readers of .inp take 20.
        points = [(1.5, 0), (7.559548074848963e-17, 1.0987654321), (-1.5, 1.3455995694350233e-16), (0, -1)]
        for name, at in (('r.poly', points), ('moved.poly', [(1.5, 1e-3), *points[1:]])):
            self.write(name, '4 2 0 0\n' + ''.join(f'{k} {x!r} {y!r}\n' for k, (x, y) in enumerate(at, 1))
                       + '4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n')
        self.run_cover('mesh', 'r.poly', '-o', 'r.inp', '-o', 'r.vtu', '-q')
        out, _ = self.run_cover('check', 'r.poly', 'r.inp', code=6)
        lines = out.splitlines()
        self.assertRegex(lines[0], '^FAILED promise 1: 2 points of the input are rounded in the mesh, by its format and not by '
                                   'the mesher: readers of .inp take 20 characters')
        self.assertEqual(lines[1], '    at (7.5595480748489628e-17, 1.0987654321), there (7.5595480748489603e-17, 1.0987654321)')
        self.assertIn('\nAll else that was checked holds: 2 triangles', out)
        self.assertEqual(out.count('FAILED'), 1)
        self.assertIn('Every promise holds', self.run_cover('check', 'r.poly', 'r.vtu')[0])
        # What is wrong beside that is told as ever.
        out, _ = self.run_cover('check', 'moved.poly', 'r.inp', code=6)
        self.assertIn('FAILED promise 1: point 1 at (1.5, 0.001) is no vertex of the mesh', out)

    def test_says_what_was_not_checked(self):
        diode = SAMPLES / 'diode.poly'
        out, _ = self.run_cover('check', diode, 'd.vtu')
        self.assertRegex(out, r'^Every promise holds: [\d,]+ triangles, 4 regions, \d+ segments whole\n'
                              r'Regions beside targets of 100 and 20 degrees, and beside proven limits: [^\n]*\n$')
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
        # Without numbers of regions too, what made it stands in the .vtm beside it.
        self.run_cover('mesh', diode, '-o', 's.mesh', '--method', 'nonobtuse', '-q')
        out, _ = self.run_cover('check', diode, 's.mesh')
        self.assertRegex(out, r'^Segments are cut at \d+ points by the run itself: --method nonobtuse\nEvery promise holds')
        out, _ = self.run_cover('check', diode, 's.vtu', '--allow-split')
        self.assertIn('Not checked: that segments are one edge each (promise 1)\n', out)
        self.assertIn('Not checked: the bound', out)
        out, _ = self.run_cover('check', SAMPLES / 'coax.poly', 's.vtu', code=6)
        self.assertNotIn('--allow-split', out)

    def test_targets_of_the_run(self):
        plate = SAMPLES / 'plate.poly'
        own = 'Regions beside targets of 95 and 15 degrees, those of the run that made it, and beside proven limits: '
        usual = 'Regions beside targets of 100 and 20 degrees, and beside proven limits: '
        angles = ('--max-angle', '95', '--min-angle', '15')
        self.run_cover('mesh', plate, *angles, '-o', 'm.vtm', '-o', 'm.vtkhdf', '-o', 'm.msh', '-o', 'm.vtu', '-q')
        for name in ('m.vtm', 'm.vtkhdf'):
            self.assertIn(own, self.run_cover('check', plate, name)[0])
        for name in ('m.msh', 'm.vtu'):
            self.assertIn(usual, self.run_cover('check', plate, name)[0])
        self.run_cover('mesh', plate, *angles, '-o', 'm.json', '-q')
        for name in ('m.msh', 'm.vtu'):
            self.assertIn(own, self.run_cover('check', plate, name)[0])
        self.assertIn(own, self.run_cover('check', plate, 'm.vtu', '--stream', 'on')[0])
        # Each of the command line counts before its own, and those of another mesh do not.
        for given, whose in ((('--max-angle', '120'), '120 and 15 degrees, the second that of the run that made it'),
                            (('--min-angle', '25'), '95 and 25 degrees, the first that of the run that made it'),
                            (('--max-angle', '120', '--min-angle', '25'), '120 and 25 degrees')):
            out, _ = self.run_cover('check', plate, 'm.msh', *given)
            self.assertIn(f'Regions beside targets of {whose}, and beside', out)
        self.run_cover('mesh', plate, '--method', 'almond', '-o', 'm.vtu', '-q')
        for stream in ('off', 'on'):
            self.assertIn(usual, self.run_cover('check', plate, 'm.vtu', '--stream', stream)[0])
        # What a file says itself counts before the manifest of another mesh beside it.
        self.run_cover('mesh', plate, '--max-angle', '105', '-o', 'm.vtkhdf', '-o', 'm.vtm', '-q')
        for name in ('m.vtkhdf', 'm.vtm'):
            self.assertIn('targets of 105 and 20 degrees, those of the run', self.run_cover('check', plate, name)[0])
        # Settings that cannot be understood are taken neither as targets nor as words.
        manifest = json.loads((self.dir / 'm.json').read_text())
        manifest['counts']['triangles'] = 0
        manifest['options'] = {'max-angle': '95', 'min-angle': '1000'}
        self.write('m.json', json.dumps(manifest))
        self.assertIn(usual, self.run_cover('check', plate, 'm.msh')[0])
        self.run_cover('mesh', plate, '--method', 'almond', '-o', 'a.vtm', '-q')
        self.assertIn(usual, self.run_cover('check', plate, 'a.vtm')[0])

    def test_names_of_regions(self):
        """Two regions of one material that change names would be n for p."""
        ring = [[[x, 0], [x + 1, 0], [x + 1, 1], [x, 1]] for x in (0, 1)]
        self.write('d.json', json.dumps({'polygons': [{'material': 'si', 'region': name, 'rings': [r]} for name, r in zip(('p', 'n'), ring)]}))
        self.run_cover('mesh', 'd.json', '-o', 'd.msh', '-o', 'd.inp', '-q')
        for name in ('d.msh', 'd.inp'):
            self.run_cover('check', 'd.json', name)
        text = (self.dir / 'd.msh').read_text()
        self.write('e.msh', text.replace('"p"', '"x"').replace('"n"', '"p"').replace('"x"', '"n"'))
        out, _ = self.run_cover('check', 'd.json', 'e.msh', code=6)
        self.assertRegex(out, r"FAILED named regions: \d+ triangles of 'p' are named 'n'")
        self.assertNotIn('Every promise', out)

    def test_cuts_of_split_interfaces(self):
        plate = SAMPLES / 'plate.poly'
        out, _ = self.run_cover('mesh', plate, '-o', 's.msh', '-o', 's.json', '--report', 's.html', '--split-interfaces')
        self.assertRegex(out, r'\(\d+ new, 7 of them on segments\)')
        self.assertIn('The 27 segments are cut into 34, as was asked for; each piece is one edge',
                      (self.dir / 's.html').read_text())
        out, _ = self.run_cover('check', plate, 's.msh')
        self.assertRegex(out, r'^Segments are cut at 7 points by the run itself: --split-interfaces 90\nEvery promise holds')
        self.run_cover('mesh', plate, '-o', 's.msh', '-o', 's.json', '--split-interfaces', '--box-method', '-q')
        self.assertRegex(self.run_cover('check', plate, 's.msh')[0],
                         r'^Segments are cut at \d+ points by the run itself: (?=.*--split-interfaces 90\b)(?=.*--box-method(?! true))')
        (self.dir / 's.json').unlink()
        self.run_cover('mesh', SAMPLES / 'mosfet.poly', '-o', 'one.vtu', '--split-interfaces', '--max-angle', '85', '-q')
        out, _ = self.run_cover('check', SAMPLES / 'mosfet.poly', 'one.vtu')
        self.assertRegex(out, r'^Segments are cut at 1 point by the run itself')
        out, _ = self.run_cover('check', plate, 's.msh', code=6)
        self.assertIn('--split-interfaces, --box-method or --method nonobtuse, add --allow-split', out.splitlines()[0])

    def test_cuts_of_a_run_on_another_input(self):
        """They hide nothing of what is different: one well was moved."""
        def island(well):
            square = {'type': 'Polygon', 'coordinates': [[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]]}
            return json.dumps({'type': 'FeatureCollection', 'features': [
                {'type': 'Feature', 'properties': {'name': 'island', 'soil': 'sand'}, 'geometry': square},
                {'type': 'Feature', 'properties': {'name': 'well'}, 'geometry': {'type': 'Point', 'coordinates': well}}]})

        self.write('island.geojson', island([4, 5]))
        self.write('moved.geojson', island([4, 4]))
        self.run_cover('mesh', 'island.geojson', '--split-interfaces', '--size', 1, '-o', 'w.vtm', '-q')
        out, _ = self.run_cover('check', 'moved.geojson', 'w.vtm', code=6)
        self.assertRegex(out, r'^Segments are cut at \d+ points by the run itself: --split-interfaces 90\n'
                              r'1 point of the input missing in the mesh\. .*\n'
                              r'FAILED promise 1: point 0 at \(4, 4\) is no vertex of the mesh\n +at \(4, 4\)\n$')

    def test_names_of_regions_and_points(self):
        """Materials and places are as they were; names are exchanged."""
        def island(north, south, first, second):
            def feature(kind, coordinates, **properties):
                return {'type': 'Feature', 'properties': properties, 'geometry': {'type': kind, 'coordinates': coordinates}}
            return json.dumps({'type': 'FeatureCollection', 'features': [
                feature('Polygon', [[[0, 9], [9, 9], [9, 18], [0, 18], [0, 9]]], name=north, material='sand'),
                feature('Polygon', [[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]], name=south, material='sand'),
                feature('Point', [4, 3], name=first), feature('Point', [4, 12], name=second)]})

        self.write('a.geojson', island('north', 'south', 'well', 'probe'))
        self.write('b.geojson', island('south', 'north', 'probe', 'well'))
        self.write('c.geojson', island('north', 'lake', 'well', 'spring'))
        wrong = (r"FAILED named points: 'probe' is named 'well'\n +at \(4, 3\)\n"
                 r"FAILED named points: 'well' is named 'probe'\n +at \(4, 12\)\n"
                 r"FAILED named regions: \d+ triangles of 'south' of 'sand' are named 'north' of 'sand'\n.*\n"
                 r"FAILED named regions: \d+ triangles of 'north' of 'sand' are named 'south' of 'sand'\n")
        for outputs in ('m.vtm',), ('m.vtkhdf',), ('n.msh', 'n.json'):
            self.run_cover('mesh', 'a.geojson', *(word for name in outputs for word in ('-o', name)), '-q')
            out, _ = self.run_cover('check', 'a.geojson', outputs[0])
            self.assertTrue(out.startswith('Every promise holds') and 'Not checked' not in out, out)
            self.assertRegex(self.run_cover('check', 'b.geojson', outputs[0], code=6)[0], '^' + wrong)
            # What the input calls otherwise may be what a format or a tool made of it.
            out, _ = self.run_cover('check', 'c.geojson', outputs[0])
            self.assertIn("Not checked: names of regions: 'south' of 'sand' is none of the input's\n", out)
            self.assertIn("Not checked: names of points: 'probe' is none of the input's\n", out)

    def test_tells_what_names_materials(self):
        """Points of the void do not count as missing, and nothing else is told of them."""
        square = {'type': 'Polygon', 'coordinates': [[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]]}
        self.write('soil.geojson', json.dumps({'type': 'FeatureCollection', 'features': [
            {'type': 'Feature', 'properties': {'soil': 'sand'}, 'geometry': square},
            {'type': 'Feature', 'properties': {'soil': 'clay'}, 'geometry': {
                'type': 'Polygon', 'coordinates': [[[9, 0], [18, 0], [18, 9], [9, 9], [9, 0]]]}},
            {'type': 'Feature', 'properties': {'soil': 'sand'}, 'geometry': {
                'type': 'Polygon', 'coordinates': [[[18, 0], [27, 0], [27, 9], [18, 9], [18, 0]]]}},
            {'type': 'Feature', 'properties': {'soil': 'x'}, 'geometry': {'type': 'Point', 'coordinates': [40, 5]}}]}))
        self.run_cover('mesh', 'soil.geojson', '--material-field', 'soil', '-o', 'soil.vtu', '-q')
        out, _ = self.run_cover('check', 'soil.geojson', 'soil.vtu', code=6)
        self.assertNotIn('missing', out)
        self.assertIn('took materials from elsewhere, repeat its --material-field or --name-field here\n', out)
        self.run_cover('check', 'soil.geojson', 'soil.vtu', '--material-field', 'soil')

    def test_cuts_go_through_conversions_and_again(self):
        plate = SAMPLES / 'plate.poly'
        again = ('--only', 'region:1', '--onto')
        for names in (('a.vtkhdf', 'b.vtu', 'c.vtkhdf'), ('a.vtu', 'b.vtkhdf', 'c.vtu'), ('a.vtkhdf', 'b.vtkhdf', 'c.vtkhdf')):
            self.run_cover('mesh', plate, '-o', names[0], '--split-interfaces', '-q')
            self.run_cover('convert', names[0], '-o', names[1], '-q')
            self.run_cover('mesh', plate, *again, names[1], '-o', names[2], '-q')
            for name in names:
                for file in self.dir.iterdir():
                    if file.name != name:
                        file.rename(self.dir / ('hidden_' + file.name.replace('.', '_')))
                self.assertRegex(self.run_cover('check', plate, name)[0], r'^Segments are cut at 7 points by the run itself', name)
                for file in self.dir.glob('hidden_*'):
                    stem, _, extension = file.name.removeprefix('hidden_').rpartition('_')
                    file.rename(self.dir / f'{stem}.{extension}')

    def test_cut_points_are_no_points_of_the_input(self):
        plate = SAMPLES / 'plate.poly'
        known = json.loads(self.run_cover('mesh', plate, '--dry-run', '--stats', 'json')[0])['input']
        out, _ = self.run_cover('mesh', plate, '-o', 's.json', '--report', 'r.json', '--split-interfaces', '--stats', 'json', '-q')
        report = json.loads((self.dir / 'r.json').read_text())
        self.assertEqual(report['mesh']['cut_vertices'], 7)
        for found in report, json.loads(out):
            self.assertEqual((found['input']['points'], found['input']['segments']), (known['points'], known['segments']))
        counts = json.loads((self.dir / 's.json').read_text())['counts']
        self.assertEqual(counts['cut_vertices'], 7)
        self.assertEqual(counts['input_vertices'] + counts['steiner_vertices'], counts['vertices'])

    def test_cuts_that_nothing_tells_of(self):
        # A cut segment is one line, not one for each side, and nothing that follows from it is listed.
        coax = SAMPLES / 'coax_arcs.json'
        self.run_cover('mesh', coax, '-o', 's.msh', '--split-interfaces', '--size', '1', '-q')
        out, _ = self.run_cover('check', coax, 's.msh', code=6)
        first, *rest = out.splitlines()
        self.assertRegex(first, r'^Segments are cut at \d+ points, those of arcs on their circles; all else is sound\..* add --allow-split$')
        failed = [line for line in rest if line.startswith('FAILED')]
        self.assertTrue(failed)
        for line in failed:
            self.assertRegex(line, r'^FAILED promise 1: the segment .* is no edge of the mesh')
        places = [' '.join(sorted(re.findall(r'\([^)]*\)', line)[:2])) for line in failed]
        self.assertEqual(len(places), len(set(places)))

    def test_cuts_that_nothing_tells_of_say_nothing_of_region_ids(self):
        # Regions run together over segments that are no edges: nothing is known of RegionIds then.
        self.write('stack.json', json.dumps({
            'points': [[x, y] for y in (0, 1, 2, 7) for x in (0, 10)],
            'segments': [[k, k + 1] for k in (0, 2, 4, 6)] + [[k, k + 2] for k in range(6)]}))
        self.run_cover('mesh', 'stack.json', '-o', 's.vtk', '--split-interfaces', '--size', '2', '-q')
        out = self.run_cover('check', 'stack.json', 's.vtk', code=6)[0]
        self.assertIn('all else is sound', out)
        self.assertNotIn('RegionId', out)

    def test_other_numbers_of_materials_on_cut_arcs(self):
        def ring(iron, air):
            return json.dumps({'polygons': [
                {'material': iron, 'region': 'a', 'rings': [[[0, 0], [4, 0], [4, 4], [0, 4]]]},
                {'material': air, 'region': 'b', 'rings': [[{'circle': {'centre': [2, 2], 'radius': 1, 'chords': 8}}]]}]})
        self.write('ring.json', ring('iron', 'air'))
        self.write('other.json', ring(7, 9))
        square = {'points': [[0, 0], [4, 0], [4, 4], [0, 4]], 'segments': [[0, 1], [1, 2], [2, 3], [3, 0]]}
        for name, material in (('square.json', 1), ('numbered.json', 7)):
            self.write(name, json.dumps({**square, 'regions': [{'x': 1, 'y': 1, 'material': material}]}))
        for one, other in (('ring.json', 'other.json'), ('square.json', 'numbered.json')):
            self.run_cover('mesh', one, '--split-interfaces', '--size', '0.5', '-o', 'r.vtk', '-q')
            out, _ = self.run_cover('check', other, 'r.vtk', '--allow-split', '--no-bound', code=6)
            failed = [line for line in out.splitlines() if line.startswith('FAILED')]
            self.assertTrue(failed)
            for line in failed:
                self.assertTrue(line.startswith('FAILED promise 4 (materials): '), line)
            # Where cuts are not allowed, they are told beside the materials.
            out, _ = self.run_cover('check', other, 'r.vtk', code=6)
            self.assertRegex(out, r'^Segments [^\n]*; all else but materials is sound[^\n]* add --allow-split\n')
            self.assertRegex(out, r'\nFAILED promise 1: ')
            self.assertRegex(out, r'\nFAILED promise 4 \(materials\): ')
            self.assertNotIn('FAILED promise 2', out)
            self.assertNotIn('all else but', self.run_cover('check', one, 'r.vtk', code=6)[0])

    def test_a_mesh_of_the_hull(self):
        self.run_cover('mesh', SAMPLES / 'mosfet.poly', '-o', 'h.vtu', '--hull', '-q')
        out, _ = self.run_cover('check', SAMPLES / 'mosfet.poly', 'h.vtu', code=6)
        self.assertRegex(out.splitlines()[0], r'^\d+ triangles lie along segments in the void\. If .* convex hull, add --hull$')
        self.run_cover('check', SAMPLES / 'mosfet.poly', 'h.vtu', '--hull')
        self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '-q')
        self.assertNotIn('--hull', self.run_cover('check', SAMPLES / 'mosfet.poly', 'd.vtu', code=6)[0])

    def test_regions_that_were_joined_or_not(self):
        squares = [{'rings': [[[x, 0], [x + 1, 0], [x + 1, 1], [x, 1]]], 'material': 'a'} for x in (0, 1)]
        self.write('s.json', json.dumps({'polygons': squares}))
        self.run_cover('mesh', 's.json', '--merge-materials', '-o', 'joined.vtu', '-q')
        self.run_cover('mesh', 's.json', '-o', 'two.vtu', '-q')
        hint = r'\n\d+ triangles have another RegionId than [^.]*\. .* --merge-materials here\n'
        self.assertRegex('\n' + self.run_cover('check', 's.json', 'joined.vtu', code=6)[0], hint)
        self.assertRegex('\n' + self.run_cover('check', 's.json', 'two.vtu', '--merge-materials', code=6)[0], hint)
        self.run_cover('check', 's.json', 'joined.vtu', '--merge-materials')
        self.assertNotIn('--merge', self.run_cover('check', 's.json', 'two.vtu')[0])

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

    def test_cuts_that_cascade_are_not_counted(self):
        """Thin layers around each other: cuts of one make the next one need cuts, a thousand times."""
        circles = [{'circle': {'centre': [0, 0], 'radius': 1 + k / 100, 'chords': 16}} for k in range(1000)]
        self.write('n.json', json.dumps({'segments': circles}))
        out, _ = self.run_cover('info', 'n.json')
        self.assertRegex(out, r'\n  no obtuse angle \(--split-interfaces\) +many cuts before meshing\n')
        self.assertIn('\n  many: not counted, as cuts of one segment make the next ones need cuts, and so on\n', out)
        self.assertNotIn('many', self.run_cover('info', SAMPLES / 'mosfet.poly')[0])

    def test_several_inputs(self):
        for name, x in (('a.json', 0), ('b.json', 1)):
            self.write(name, json.dumps({'polygons': [{'material': name[0], 'rings': [[[x, 0], [x + 1, 0], [x + 1, 1], [x, 1]]]}]}))
        self.run_cover('mesh', 'a.json', 'b.json', '-o', 'm.vtm', '-q')
        for words in (('a.json', 'b.json', 'm.vtm'), ('a.json', '--allow-split', 'b.json', '-j', '1', 'm.vtm')):
            self.assertIn('2 regions', self.run_cover('check', *words)[0])
        self.run_cover('check', 'a.json', 'm.vtm', code=6)
        for words in (('a.json',), ()):
            self.assertRegex(self.run_cover('check', *words, code=2)[1], '(mesh|input) is required')
        usage = self.run_cover('check', '--help')[0]
        self.assertIn('Usage: cover check [OPTIONS] input... mesh\n', usage)
        # Its targets are those of the run, no defaults.
        self.assertRegex(usage, r'--max-angle DEG +Largest angle beside which regions are put')
        self.assertRegex(usage, r'--min-angle DEG +Smallest angle beside which regions are put')

    def test_what_the_run_had_welded(self):
        (self.dir / 'a.poly').write_text('8 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 1.0004 0\n6 2 0\n7 2 1\n8 1.0004 1\n'
                                         '8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n0\n')
        self.run_cover('mesh', 'a.poly', '-o', 'a.vtu', '--weld', '1e-3', '-q')
        out, _ = self.run_cover('check', 'a.poly', 'a.vtu', code=6)
        self.assertTrue(out.startswith('2 points of the input missing in the mesh.'), out)
        self.assertIn('--weld', out.splitlines()[0])
        out, _ = self.run_cover('check', 'a.poly', 'a.vtu', '--weld', '1e-3')
        self.assertTrue(out.startswith('Every promise holds'), out)

    def test_options_that_read_another_geometry(self):
        grains = SAMPLES / 'grains.png'
        words = ('--speckle', '5', '--no-smooth', '--method', 'almond')
        self.run_cover('mesh', grains, *words, '-o', 'g.vtu', '-q')
        first = self.run_cover('check', grains, 'g.vtu', code=6)[0].splitlines()[0]
        self.assertTrue(first.endswith('repeat its --weld, --overlap, --scale, --speckle, --no-smooth or --legend here'), first)
        # A run that tells how it read is quoted, without what was given again.
        self.run_cover('mesh', grains, *words, '-o', 'g.json', '-q')
        first = self.run_cover('check', grains, 'g.vtu', code=6)[0].splitlines()[0]
        self.assertTrue(first.endswith(' The run that made it had other options: repeat --speckle 5 --no-smooth here'), first)
        first = self.run_cover('check', grains, 'g.vtu', '--speckle', '5', code=6)[0].splitlines()[0]
        self.assertTrue(first.endswith(': repeat --no-smooth here'), first)
        self.assertIn('Every promise holds', self.run_cover('check', grains, 'g.vtu', '--speckle', '5', '--no-smooth')[0])
        # A manifest may hold anything, which neither a terminal nor a shell is to take for more.
        manifest = json.loads((self.dir / 'g.json').read_text())
        manifest['options'] = {'legend': "it's; rm\x1b[2J", 'speckle': '', 'no-smooth': 'true'}
        self.write('g.json', json.dumps(manifest))
        first = self.run_cover('check', grains, 'g.vtu', code=6)[0].splitlines()[0]
        self.assertTrue(first.endswith(r""": repeat --legend 'it'\''s; rm\x1b[2J' --speckle '' --no-smooth here"""), first)


if __name__ == '__main__':
    main()
