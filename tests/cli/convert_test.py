#!/usr/bin/env python3
"""convert_test.py PROGRAM SAMPLES [TEST...]: cover convert; names, numbers and values on their way out."""
import json
import math
import re
import subprocess
from xml.etree import ElementTree

from cover_case import Case, PROGRAM, SAMPLES, SQUARE, main


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

    def test_standard_output_has_the_names_that_a_file_has(self):
        self.write('n.json', json.dumps({'polygons': [{'material': 'a b', 'rings': [[[0, 0], [1, 0], [1, 1], [0, 1]]]}]}))
        self.run_cover('mesh', 'n.json', '-o', 'n.vtm', '-q')
        for extension in 'inp', 'obj':
            told, _ = self.run_cover('convert', 'n.vtm', '-o', 'n.' + extension)
            self.assertRegex(told, r'(?m)^ +in \.' + extension + r' +stands for\n +[Aa]_[Bb] +a b$')
            out, err = self.run_cover('convert', 'n.vtm', '-o', '-', '--format', extension)
            self.assertEqual(out, (self.dir / f'n.{extension}').read_text())
            self.assertEqual(err, told)
        out, err = self.run_cover('mesh', 'n.json', '-o', '-', '--format', 'inp')
        self.assertIn(self.run_cover('convert', 'n.vtm', '-o', 'n.inp')[0], err)
        self.assertEqual(self.run_cover('convert', 'n.vtm', '-o', '-', '--format', 'inp', '-q')[1], '')

    def test_voids_stay_void(self):
        def holes(name):
            lines = (self.dir / name).read_text().split('# holes')[1].split('\n')[1:]
            return [[float(x) for x in line.split()[1:3]] for line in lines[1:1 + int(lines[0])]]
        rings = [[[0, 0], [9, 0], [9, 9], [0, 9]], [[1, 1], [4, 1], [4, 4], [1, 4]], [[4, 4], [8, 4], [8, 8], [4, 8]]]
        island = [[[5, 5], [7, 5], [7, 7], [5, 7]]]
        self.write('v.json', json.dumps({'polygons': [{'material': 'Si', 'rings': rings}, {'material': 'Au', 'rings': island}]}))
        for mesh in 'm.vtm', 'm.vtu', 'm.msh', 'm.vtkhdf', 'm.inp':
            self.run_cover('mesh', 'v.json', '-o', mesh, '-o', 'm.poly', '-q')
            self.run_cover('convert', mesh, '-o', 'c.poly', '-q')
            self.assertEqual(len(holes('m.poly')), 2)
            self.assertEqual([x < 4 for x, _ in sorted(holes('c.poly'))], [True, False], mesh)
            self.run_cover('mesh', 'c.poly', '-o', 'again.vtu', '-q')
            self.run_cover('check', 'v.json', 'again.vtu', '-q')

    def test_regions_of_one_name_are_one_set(self):
        rings = [[[x, 0], [x + 1, 0], [x + 1, 1], [x, 1]] for x in (0, 2)]
        self.write('c.json', json.dumps({'polygons': [{'material': 'cu', 'region': 'coil', 'rings': [ring]} for ring in rings]}))
        self.run_cover('mesh', 'c.json', '-o', 'c.vtm', '-q')
        told = '2 regions with names are 1 element set in a.inp, one for each name and material: --ids region keeps them apart'
        self.assertIn(told, self.run_cover('convert', 'c.vtm', '-o', 'a.inp')[1])
        self.assertEqual((self.dir / 'a.inp').read_text().count('ELSET'), 1)
        self.assertEqual(self.run_cover('convert', 'c.vtm', '-o', 'a.inp', '--ids', 'region')[1], '')
        self.assertEqual((self.dir / 'a.inp').read_text().count('ELSET'), 2)
        for names in (('a.inp', 'a.json'), ('a.msh',)):
            words = [word for name in names for word in ('-o', name)]
            self.assertNotIn('element set', self.run_cover('convert', 'c.vtm', *words)[1])

    def test_a_mesh_in_parts_comes_back(self):
        plate = SAMPLES / 'plate.poly'
        for order in '1', '2':
            self.run_cover('mesh', plate, '--order', order, '--parts', '3', '-o', 'p.pvtu', '-q')
            self.run_cover('mesh', plate, '--order', order, '-o', 'w.vtu', '-q')
            self.run_cover('check', plate, 'p.pvtu')
            for name in 'p.pvtu', 'w.vtu':
                self.run_cover('convert', name, '--order', '1', '-o', name + '.vtu', '-q')
            self.assertEqual((self.dir / 'p.pvtu.vtu').read_bytes(), (self.dir / 'w.vtu.vtu').read_bytes())
        # More parts than triangles: some are empty.
        self.write('s.poly', SQUARE)
        self.run_cover('mesh', 's.poly', '--parts', '5', '-o', 'e.pvtu', '-q')
        self.run_cover('check', 's.poly', 'e.pvtu')
        self.assertEqual(self.run_cover('convert', 'e.pvtu', '-o', 'e.vtk', '-q')[1], '')
        self.assertIn('RegionId', (self.dir / 'e.vtk').read_text())
        pieces = sorted((self.dir / 'p.parts').iterdir())
        kept = pieces[1].read_bytes()
        for array, what in ('GlobalNodeId', 'the numbers that vertices have'), ('GlobalCellId', 'the numbers that triangles'):
            pieces[1].write_bytes(kept.replace(array.encode(), b'X' * len(array)))
            self.assertIn(f'its pieces do not tell {what}', self.run_cover('check', plate, 'p.pvtu', code=5)[1])
        pieces[1].write_bytes(kept)
        text = (self.dir / 'p.pvtu').read_text()
        self.write('p.pvtu', text.replace(pieces[1].name, pieces[0].name))
        self.assertIn('two pieces are the file', self.run_cover('check', plate, 'p.pvtu', code=5)[1])
        self.write('p.pvtu', re.sub('<Piece [^\n]*' + pieces[1].name + '"/>', '', text))
        self.assertRegex(self.run_cover('check', plate, 'p.pvtu', code=5)[1], 'its pieces do not tell all (vertices|triangles)')
        self.write('p.pvtu', text)
        self.write('p.pvtu', text.replace('p.parts/' + pieces[1].name, 'x' * 300))
        self.assertIn('is not there', self.run_cover('check', plate, 'p.pvtu', code=5)[1])
        self.write('p.pvtu', text.replace('p.parts/' + pieces[1].name, '/proc/self/root' + str(pieces[0].resolve())))
        self.assertIn('two pieces are the file', self.run_cover('check', plate, 'p.pvtu', code=5)[1])
        self.write('p.pvtu', text)
        pieces[1].unlink()
        self.assertIn(f"its piece 'p.parts/{pieces[1].name}' is not there", self.run_cover('check', plate, 'p.pvtu', code=5)[1])

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
            told = [line for line in done.stderr.splitlines() if not re.search('points? in d.inp (is|are) rounded', line)]
            self.assertEqual((done.returncode, told), (0, []), source)
            for name in direct:
                self.assertEqual((folder / name).read_bytes(), (self.dir / name).read_bytes(), f'{source} into {name}')

    def test_every_format_into_every_other(self):
        self.compare_ways(('d.vtu', 'd.vtm', 'd.vtkhdf', 'd.vtk', 'd.msh', 'd.xdmf', 'd.mesh', 'd.ele'))

    def test_abaqus_into_every_other(self):
        # An .inp has 20 characters for each coordinate: those of the device fit, not of every new vertex.
        self.compare_ways(('d.inp',), '--max-angle', '178', '--min-angle', '0')

    def test_rounding_for_abaqus_is_told(self):
        told = r'(\d+) points? in r.inp (is|are) rounded: readers of .inp take 20 characters of a coordinate'
        square = self.write('r.poly', SQUARE)
        self.assertNotIn('rounded', self.run_cover('mesh', square, '-o', 'r.inp')[1])
        tiny = self.write('t.poly', SQUARE.replace('1 0 0', '1 1.2345678901234567e-7 0', 1))
        self.assertRegex(self.run_cover('mesh', tiny, '-o', 'r.inp', '-o', 'r.msh')[1], told)
        self.assertRegex(self.run_cover('convert', 'r.msh', '-o', 'r.inp')[1], told)
        self.assertNotIn('rounded', self.run_cover('convert', 'r.msh', '-o', 'r.vtu')[1])

    def test_points_in_no_triangle_are_told(self):
        self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'w.inp', '-q')
        whole = (self.dir / 'w.inp').read_text()
        self.assertNotIn('cut short', self.run_cover('convert', 'w.inp', '-o', 'n.vtu')[1])
        triangles = whole.index('*ELEMENT')
        self.write('c.inp', whole[:whole.index('\n', triangles + 60) + 1])
        self.assertRegex(self.run_cover('convert', 'c.inp', '-o', 'n.vtu')[1],
                         r'c.inp: \d+ points are in no triangle: the file may have been cut short')

    def test_says_what_is_missing(self):
        (self.dir / 'd.vtm').unlink()
        _, err = self.run_cover('convert', 'd.vtu', '-o', 'e.vtm')
        self.assertIn('neither d.json nor d.vtm is there', err)
        self.assertIn('e.vtm', self.files())

    def test_a_curve_of_a_msh_is_the_image_of_one_other(self):
        # The materials meet the periodic sides at different heights.
        ring = [[[0, 0], [4, 0], [4, 1.25], [0, 1]], [[0, 1], [4, 1.25], [4, 2], [0, 2]]]
        self.write('x.json', json.dumps({
            'polygons': [{'material': m, 'rings': [r]} for m, r in zip('ab', ring)], 'periodic': [['left', 'right']],
            'lines': [{'name': name, 'points': [[x, 0], [x, 2]]} for name, x in (('left', 0), ('right', 4))]}))
        for version in ('2.2', '4.1'):
            self.run_cover('mesh', 'x.json', '--split-interfaces', '--size', '0.25', '--msh', version, '-o', 'x.msh', '-q')
            lines = (self.dir / 'x.msh').read_text().partition('$Periodic')[2].splitlines()
            links = [line.split()[1:] for line in lines if line.startswith('1 ') and len(line.split()) == 3]
            self.assertEqual(len({image for image, _ in links}), len(links))
            self.assertNotIn('periodic', self.run_cover('convert', 'x.msh', '-o', 'y.msh', '-o', 'y.json')[1])
            rule, = json.loads((self.dir / 'y.json').read_text())['periodic']
            self.assertGreaterEqual(len(rule['edges']), 8)

    def test_periodic_pairs_need_the_manifest_or_a_msh(self):
        def section(name):
            return (self.dir / name).read_text().partition('$Periodic')[2].partition('$EndPeriodic')[0]

        def pairs(name):
            return [{key: sorted(rule[key]) for key in ('vertices', 'edges')} for rule in json.loads((self.dir / name).read_text())['periodic']]
        self.run_cover('mesh', SAMPLES / 'motor_pole.json', '-o', 'p.msh', '-o', 'p.vtu', '-o', 'p.vtm', '-o', 'p.json', '-q')
        known, given = section('p.msh'), pairs('p.json')
        for mesh in ('p.msh', 'p.vtu', 'p.vtm'):
            self.assertEqual(self.run_cover('convert', mesh, '-o', 'q.msh')[1], '')
            self.assertEqual(section('q.msh'), known)
        (self.dir / 'p.json').unlink()
        for mesh in ('p.vtu', 'p.vtm'):
            _, err = self.run_cover('convert', mesh, '-o', 'q.msh')
            self.assertIn(f'{mesh}: pairs of points on periodic sides are left out: only the manifest, p.json, or a .msh names', err)
            self.assertEqual(section('q.msh'), '')
        self.assertEqual(self.run_cover('convert', 'p.msh', '-o', 'q.msh', '-o', 'q.vtu', '-o', 'q.json')[1], '')
        self.assertEqual(section('q.msh'), known)
        self.assertEqual(pairs('q.json'), given)
        self.assertIn('PeriodicNode', (self.dir / 'q.vtu').read_text(errors='replace'))
        # Translations, both versions and second order, alone.
        cell = SAMPLES / 'fibre_cell.json'
        for number, words in enumerate((('--msh', '2.2'), ('--msh', '4.1'), ('--order', '2'), ('--order', '2', '--msh', '4.1'))):
            source, target = f'm{number}.msh', f'n{number}.msh'
            self.run_cover('mesh', cell, '--split-interfaces', '--size', '2', *words, '-o', source, '-q')
            self.assertNotIn('periodic', self.run_cover('convert', source, *words, '-o', target, '-o', f'n{number}.json')[1])
            told = json.loads((self.dir / f'n{number}.json').read_text())['periodic']
            self.assertEqual({(rule['from'], rule['to'], rule['map']) for rule in told},
                             {('left', 'right', 'translation'), ('bottom', 'top', 'translation')})
            self.assertEqual(section(target).split('\n')[1], section(source).split('\n')[1])

    def test_the_manual_counts_the_pairs_of_its_machine(self):
        manual = (SAMPLES.parents[1] / 'libcover/docs/manual.md').read_text()
        told = re.search(r'with (\d+) pairs of vertices.*?`cover mesh samples/data/(motor_pole.json) (.*?) -o', manual, re.DOTALL)
        self.run_cover('mesh', SAMPLES / told[2], *told[3].split(), '-o', 'pole.json', '-q')
        pairs = json.loads((self.dir / 'pole.json').read_text())['periodic'][0]['vertices']
        self.assertEqual(len(pairs), int(told[1]))

    def test_not_ours(self):
        self.write('x.vtu', 'rubbish')
        _, err = self.run_cover('convert', 'x.vtu', '-o', 'e.vtm', code=5)
        self.assertIn('x.vtu:1: no valid XML', err)
        self.assertNotIn('ERR', err)


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

    def test_names_of_materials_that_a_lone_xdmf_lacks_are_told(self):
        for form in 'text', 'hdf5':
            self.run_cover('mesh', 'd.json', '-o', 'm.xdmf', '--xdmf', form, '-q')
            self.assertIn('m.xdmf holds no names of materials, and neither m.json nor m.vtm is there: they are made up',
                          self.run_cover('convert', 'm.xdmf', '-o', 'n.vtu')[1])
        self.run_cover('mesh', 'd.json', '-o', 'm.json', '-q')
        self.assertNotIn('made up', self.run_cover('convert', 'm.xdmf', '-o', 'n.vtu')[1])

    def test_materials_that_a_lone_msh_lacks_are_told(self):
        self.run_cover('mesh', 'd.json', '-o', 'm.msh', '-q')
        self.assertIn('m.msh holds no numbers and names of materials, and neither m.json nor m.vtm is there: they are made up',
                      self.run_cover('convert', 'm.msh', '-o', 'n.vtu')[1])

    def test_where_they_cannot_it_is_told(self):
        out, _ = self.run_cover('mesh', 'd.json', '-o', 'm.inp', '-o', 'm.json')
        sets = re.findall(r'ELSET=(\S+)', (self.dir / 'm.inp').read_text())
        self.assertEqual(len(set(sets)), 4)  # Si and si are two
        groups = json.loads((self.dir / 'm.json').read_text())['region_groups']
        self.assertEqual([g.get('set', g['name']) for g in groups], sets)
        self.assertEqual([g['original'] for g in groups], list(self.NAMES))
        for name, made in zip(self.NAMES, sets):
            if made != name.upper():
                self.assertRegex(out, re.escape(made) + r' +' + re.escape(name))
        self.assertRegex(out, r'KONTAKT___ +Kontakt Ä')
        self.assertNotIn('in .inp', self.run_cover('mesh', self.write('s.poly', SQUARE), '-o', 's.inp')[0])
        # What is converted is told alike.
        table = out[out.index('  in .inp'):]
        self.assertEqual(self.run_cover('convert', 'm.inp', '-o', 'c.inp')[0], table)
        self.assertEqual(self.run_cover('convert', 'm.inp', '-o', 'c.vtu')[0], '')
        self.assertEqual(self.run_cover('convert', 'm.inp', '-o', 'c.inp', '-q')[0], '')
        self.assertIn('in .msh', self.run_cover('convert', 'm.inp', '-o', 'c.msh')[0])
        # All nodes are a set of the writer's own, and names have 80 characters.
        square = {'polygons': [{'material': 'Si', 'region': 'r' * 81, 'rings': [[[0, 0], [1, 0], [1, 1], [0, 1]]]}],
                  'lines': [{'name': 'Nall', 'points': [[0, 0], [1, 0]]}]}
        out, _ = self.run_cover('mesh', self.write('s.json', json.dumps(square)), '-o', 'n.inp')
        self.assertRegex(out, r'\n *NALL_2 +Nall\n')
        self.assertRegex(out, r'\n *R{80} +r{81}\n')
        text = (self.dir / 'n.inp').read_text()
        self.assertEqual(re.findall(r'NSET=(\w+)', text).count('NALL'), 1)
        self.assertIn('NSET=NALL_2\n', text)

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
            told = self.run_cover('check', 'coils.json', 'm.mesh')[0]
            self.assertEqual('which material has which number' in told, ids != 'material', told)
        self.assertEqual(labels, {'region': 6, 'material': 1, 'name': 6})
        # A triangle in the group of another coil whose material is another one.
        squares[5]['material'] = 'Al'
        self.write('coils.json', json.dumps({'polygons': squares}))
        self.run_cover('mesh', 'coils.json', '-o', 'm.mesh', '--ids', 'region', '-q')
        self.run_cover('check', 'coils.json', 'm.mesh')
        text = (self.dir / 'm.mesh').read_text()
        self.write('m.mesh', re.sub(r'( )6\n', r'\g<1>5\n', text, count=1))
        self.run_cover('check', 'coils.json', 'm.mesh', code=6)
        _, err = self.run_cover('mesh', 'coils.json', '-o', 'm.mesh', '--ids', 'colour', code=2)
        self.assertIn("--ids: 'colour' is not one of region, material, name", err)


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
        files = [word for f in ('m.vtu', 'm.vtm', 'm.vtkhdf', 'm.msh', 'm.xdmf', 'm.json') for word in ('-o', f)]
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
        xdmf = ElementTree.parse(self.dir / 'm.xdmf').find(".//Grid[@Name='mesh']")
        self.assertEqual([(a.get('Name'), a.get('Center'), a[0].get('NumberType')) for a in xdmf.iter('Attribute')][3:],
                         [('use', 'Cell', 'Int'), ('height', 'Cell', 'Float'), ('fid', 'Cell', 'Float')])
        numbers = xdmf.find("Attribute[@Name='height']/DataItem").text.split()
        self.assertEqual(str([float(n) for n in numbers]), str([float(heights[r - 1]) for r in region]))
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
        for name in ('m.vtu', 'm.vtm', 'm.vtkhdf', 'm.msh', 'n.msh', 'm.xdmf'):
            self.assertNotIn('Not checked: attributes', self.run_cover('check', 'm.geojson', name)[0])
        for stream in 'on', 'off':
            told = self.run_cover('check', 'm.geojson', *self.KEEP, 'm.vtu', '--stream', stream)[0]
            self.assertIn('\nNot checked: attributes (use, height, fid)\n', told)

    def test_values_of_merged_polygons_are_told(self):
        text = (self.dir / 'm.geojson').read_text()
        self.write('m.geojson', text.replace('"material": "b"', '"material": "a"'))
        lost = 'the names or attributes of 1 polygon are left out'
        for option in ('--keep-field', 'height'), ('--name-field', 'use'):
            told = self.run_cover('mesh', 'm.geojson', '--merge-materials', *option, '-o', 'm.vtu')[1]
            self.assertIn(lost, told)
        # Nothing is lost of equal values, and without merging.
        self.assertNotIn('left out', self.run_cover('mesh', 'm.geojson', '--merge-materials', '-o', 'm.vtu')[1])
        self.assertNotIn('left out', self.run_cover('mesh', 'm.geojson', '--keep-field', 'height', '-o', 'm.vtu')[1])
        self.write('m.geojson', text.replace('"material": "c"', '"material": "a"'))
        self.assertNotIn('left out', self.run_cover('mesh', 'm.geojson', '--merge-materials', '--keep-field', 'use', '-o', 'm.vtu')[1])

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
        # HDF5 sorts the arrays of a group by name, and meshio reads those of a .vtu in few orders: the input's is listed.
        self.run_cover('mesh', 'm.geojson', *self.KEEP, '-o', 'h.vtkhdf')
        for mesh in 'm.vtm', 'h.vtkhdf', 'a.vtkhdf':
            self.run_cover('convert', mesh, '-o', 'order.json')
            self.assertEqual([a['name'] for a in json.loads((self.dir / 'order.json').read_text())['attributes']],
                             ['use', 'height', 'fid'], mesh)
        kept = {a['name']: a for a in json.loads((self.dir / 'b.json').read_text())['attributes']}
        self.assertEqual(kept['use'], {'name': 'use', 'words': ['Wald', 'Äcker & "Wiese"'], 'values': ['Wald', 'Äcker & "Wiese"', 'Wald']})
        self.assertEqual(kept['fid']['values'], [40, 41, 42])
        self.run_cover('mesh', SAMPLES / 'nmos.tif', '-o', 'd.vtkhdf', '-o', 'e.vtu')
        self.run_cover('convert', 'd.vtkhdf', '-o', 'f.vtu')
        for form in 'text', 'hdf5':
            self.run_cover('convert', 'd.vtkhdf', '--xdmf', form, '-o', 'g.xdmf')
            self.run_cover('convert', 'g.xdmf', '-o', 'g.vtu')
            self.assertEqual(str(self.arrays('g.vtu', 'PointData', 'Net')), str(self.arrays('e.vtu', 'PointData', 'Net')))
        self.assertEqual(str(self.arrays('f.vtu', 'PointData', 'Net')), str(self.arrays('e.vtu', 'PointData', 'Net')))

    def test_what_is_lost_where_a_mesh_is_meshed_again_is_told(self):
        self.run_cover('mesh', SAMPLES / 'nmos.tif', '-o', 'n.vtu', '-o', 'n.msh', '-o', 'n.vtm', '-q')
        told = self.run_cover('mesh', 'n.vtu', '-o', 'a.vtu')[1]
        self.assertEqual((told.count('contacts are missing'), told.count("values at points are not taken over: 'Net'")), (1, 1), told)
        told = self.run_cover('mesh', 'n.msh', '-o', 'a.vtu')[1]
        self.assertEqual((told.count('contacts are missing'), told.count("values at points are not taken over: 'Net'")), (0, 1), told)
        self.assertNotIn('taken over', self.run_cover('mesh', SAMPLES / 'nmos.tif', '-o', 'a.vtu')[1])
        told = self.run_cover('mesh', 'n.vtm', '-o', 'a.vtu', code=5)[1]
        self.assertIn("'cover convert FILE -o FILE.msh' makes a file that can be read, with names and contacts", told)
        told = self.run_cover('mesh', SAMPLES / 'nmos.tif', '--size-field', 'n.vtm', '--size-of', 'Net', '--size-step', 1, '-o', 'a.vtu', code=5)[1]
        self.assertIn("n.vtm: blocks are not read; 'cover convert FILE.vtm -o FILE.vtu' makes one file of them", told)

    def test_formats_without_attributes_are_told(self):
        told = self.run_cover('mesh', 'm.geojson', *self.KEEP, '-o', 'm.vtk', '-o', 'm.inp', '-o', 'm.vtu', '-o', 'm.svg')[1]
        self.assertIn('attributes (use, height, fid) are not in m.vtk, m.inp: formats that hold them are .vtu, ', told)
        for files in ('-o', 'm.vtu'), ('-o', 'm.inp', '-o', 'm.json'), ('-o', 'm.poly', '-o', 'm.svg', '-o', 'm.vtkhdf'):
            self.assertNotIn('attributes', self.run_cover('mesh', 'm.geojson', *self.KEEP, *files)[1])
        self.assertNotIn('attributes', self.run_cover('mesh', 'm.geojson', '-o', 'm.vtk')[1])
        self.assertIn('attributes (', self.run_cover('convert', 'm.vtkhdf', '-o', 'n.mesh')[1])

    def test_texts_that_no_file_holds_are_told(self):
        table = 'texts (use: 1 = Wald, 2 = Äcker & "Wiese") are not in {}: formats that hold them are .vtm, .vtkhdf, .json'
        for name in 'a.vtu', 'a.msh', 'a.pvtu', 'a.xdmf':
            self.assertIn(table.format(name), self.run_cover('mesh', 'm.geojson', *self.KEEP, '-o', name)[1])
        told = self.run_cover('convert', 'a.vtu', '-o', 'b.msh')[1]
        self.assertIn("numbers of 'use' may stand for texts", told)
        self.run_cover('mesh', 'm.geojson', *self.KEEP, '-o', 'c.vtu', '-o', 'c.json')
        self.assertIn(table.format('d.vtu'), self.run_cover('convert', 'c.vtu', '-o', 'd.vtu')[1])
        self.assertNotIn('texts', self.run_cover('convert', 'c.vtu', '-o', 'e.vtm')[1])

    def test_what_an_earlier_run_left_beside_a_mesh(self):
        self.run_cover('mesh', 'm.geojson', *self.KEEP, '-o', 'a.vtu', '-o', 'a.json')
        before = self.arrays('a.vtu', 'CellData', 'fid')
        self.write('n.geojson', (self.dir / 'm.geojson').read_text().replace('40', '77'))
        told = self.run_cover('mesh', 'n.geojson', *self.KEEP, '-o', 'a.vtu')[1]
        self.assertIn('a.json stays beside a.vtu as an earlier run left it', told)
        now = self.arrays('a.vtu', 'CellData', 'fid')
        self.assertNotEqual(now, before)
        told = self.run_cover('convert', 'a.vtu', '-o', 'b.vtu')[1]
        self.assertIn("a.vtu: a.json contradicts it, and the mesh's own file counts: 'fid' of region 1 is 77, not 40", told)
        self.assertEqual(self.arrays('b.vtu', 'CellData', 'fid'), now)

    def test_a_map_may_be_named_json(self):
        self.write('n.json', (self.dir / 'm.geojson').read_text())
        chosen = ('--material-field', 'use', '--name-field', 'fid', '--keep-field', 'height')
        told = self.run_cover('mesh', 'n.json', '--material-field', 'use', '--keep-field', 'height', '-o', 'o.vtu', '-o', 'o.json')[1]
        self.assertNotIn('does nothing', told)
        manifest = json.loads((self.dir / 'o.json').read_text())
        self.assertIn('Wald', [r['material_name'] for r in manifest['regions']])
        self.assertEqual(manifest['attributes'][0]['values'], [2.5, None, -1])
        self.assertIn("--name-field: no feature has the property 'fid'", self.run_cover('mesh', 'n.json', *chosen, '-o', 'p.vtu', code=2)[1])
        self.write('own.json', '{"polygons": [{"material": "Si", "rings": [[[0, 0], [1, 0], [0, 1]]]}]}')
        self.assertIn('--keep-field does nothing: it counts with maps only', self.run_cover('info', 'own.json', '--keep-field', 'x')[1])

    def test_holes_outside_of_their_polygon_are_told(self):
        outer = [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]
        ring = lambda x, y: [[x, y], [x, y + 1], [x + 1, y + 1], [x + 1, y], [x, y]]
        for rings, told in (([outer, ring(6, 1), ring(1, 1)], '1 inner ring lies outside of the outer ring of its polygon, the first at (6, 1)'),
                            ([outer, ring(5, 1), ring(1, 8)], '2 inner rings lie outside of the outer ring of their polygons, the first at (5, 1)'),
                            ([outer, ring(1, 1), ring(3, 2)], None)):
            self.write('h.geojson', json.dumps({'type': 'Polygon', 'coordinates': rings}))
            err = self.run_cover('info', 'h.geojson')[1]
            if told:
                self.assertIn(told, err)
            else:
                self.assertNotIn('inner ring', err)

    def test_unknown_attribute(self):
        self.assertIn("--name-field: no feature has the property 'USE'; did you mean 'use'?",
                      self.run_cover('mesh', 'm.geojson', '--name-field', 'USE', '-o', 'm.vtu', code=2)[1])
        self.assertIn("--keep-field: no feature has the property 'usage'",
                      self.run_cover('mesh', 'm.geojson', '--keep-field', 'usage', '-o', 'm.vtu', code=2)[1])
        self.assertIn('it counts with maps only', self.run_cover('info', SAMPLES / 'diode.poly', '--keep-field', 'x')[1])

    def test_doping_comes_back_at_the_points(self):
        for name, array in ('nmos.tif', 'Net'), ('nmos.str', None):
            self.run_cover('mesh', SAMPLES / name, '--order', '2', '-o', 'd.vtu', '-o', 'd.msh', '-o', 'd.vtm', '-o', 'd.vtkhdf', '-o', 'd.json')
            manifest = json.loads((self.dir / 'd.json').read_text())
            fields = [f['name'] for f in manifest['fields']]
            self.assertTrue(fields)
            array = array or fields[0]
            values = self.arrays('d.vtu', 'PointData', array)
            self.assertEqual(len(values) * 3, len(self.arrays('d.vtu', 'Points', 'Points')))
            known = [v for v in values if not math.isnan(v)]
            self.assertGreater(max(map(abs, known)), 1e15)
            self.assertEqual(str(list(self.msh_data('d.msh', 'Node')[array].values())), str(values))
            # Each block has what its region has; where regions meet, the largest is that of the whole mesh.
            seen = {}
            for file in self.dir.glob('d/*.vtu'):
                if b'Name="RegionId"' in file.read_bytes():
                    piece = file.relative_to(self.dir)
                    for n, value in zip(self.arrays(piece, 'PointData', 'GlobalNodeId'), self.arrays(piece, 'PointData', array)):
                        seen.setdefault(n, []).append(value)
            for n, value in enumerate(values[:manifest['counts']['vertices']]):
                self.assertEqual(str(max(seen[n], key=lambda v: -1 if math.isnan(v) else abs(v))), str(value))
            self.assertTrue(any(len(set(map(str, several))) > 1 for several in seen.values()))
            self.run_cover('convert', 'd.vtm', '-o', 'e.vtm', '--order', '2')
            before, after = ({file.name[1:]: file.read_bytes() for file in self.dir.glob(f'{name}/*.vtu')} for name in 'de')
            self.assertTrue(before == after)


class NamedPoints(Case):
    """Wells and probes: two of one name, one of another, which is a contact's, too."""

    def setUp(self):
        super().setUp()
        corners = [[0, 0], [9, 0], [9, 9], [0, 9]]
        def feature(kind, coordinates, **properties):
            return {'type': 'Feature', 'properties': properties, 'geometry': {'type': kind, 'coordinates': coordinates}}
        self.write('map.geojson', json.dumps({'type': 'FeatureCollection', 'features': [
            feature('Polygon', [[*corners, corners[0]]], name='field'), feature('LineString', corners[:2], name='well "1"'),
            *(feature('Point', place, name=name) for place, name in (([4, 3], 'Sonde ö'), ([2, 2], 'well "1"'), ([6, 5], 'well "1"')))]}))

    def groups_of_msh(self, name):
        """Places of the points of each physical point."""
        lines = (self.dir / name).read_text().split('\n')
        def section(of):
            return lines[lines.index('$' + of) + 1:lines.index('$End' + of)]
        names = dict(re.match(r'0 (\d+) "(.*)"', line).groups() for line in section('PhysicalNames') if line.startswith('0 '))
        found = {name: [] for name in names.values()}
        if lines[1].startswith('2'):
            places = {words[0]: words[1:3] for words in map(str.split, section('Nodes')[1:])}
            for words in map(str.split, section('Elements')[1:]):
                if words[1] == '15':
                    found[names[words[3]]].append([float(x) for x in places[words[5]]])
            return found
        nodes = section('Nodes')
        count = int(nodes[0].split()[1])
        blocks = section('Elements')
        at = 1
        while at < len(blocks):
            dimension, tag, kind, size = blocks[at].split()
            for line in blocks[at + 1:at + 1 + int(size)] if kind == '15' else []:
                self.assertEqual(dimension, '0')
                found[names[tag]].append([float(x) for x in nodes[1 + count + int(line.split()[1])].split()[:2]])
            at += 1 + int(size)
        return found

    EXPECTED = {'Sonde ö': [[4, 3]], 'well _1_': [[2, 2], [6, 5]]}

    def test_points_are_groups_of_every_format_that_has_such(self):
        for version in '2.2', '4.1':
            for more in [], ['--order', '2'], ['--keep-field', 'name']:
                out, _ = self.run_cover('mesh', 'map.geojson', '-o', 'a.msh', '--msh', version, *more)
                self.assertEqual(self.groups_of_msh('a.msh'), self.EXPECTED, (version, more))
                self.assertRegex(out, r'group +point *\n +\d+ +Sonde ö *\n +\d+ +well "1"')
        self.run_cover('mesh', 'map.geojson', '-o', 'a.inp', '-o', 'a.mesh', '-o', 'a.json', '-q')
        manifest = json.loads((self.dir / 'a.json').read_text())
        points = {group['original']: group for group in manifest['points']}
        self.assertEqual({name: len(group['vertices']) for name, group in points.items()}, {'Sonde ö': 1, 'well "1"': 2})
        deck = (self.dir / 'a.inp').read_text()
        places = {line.split(',')[0]: line for line in deck.split('*ELEMENT')[0].splitlines()}
        for group in points.values():
            nodes = [str(vertex + 1) for vertex in group['vertices']]
            self.assertIn(f'*NSET, NSET={group["set"]}\n' + ''.join(node + ',\n' for node in nodes), deck)
            self.assertEqual(deck.count(f'NSET={group["set"]}\n'), 1)
        self.assertEqual(places[str(points['Sonde ö']['vertices'][0] + 1)].split(', ')[1:3], ['4', '3'])
        tags = [int(line.split()[2]) for line in (self.dir / 'a.mesh').read_text().split('\n') if line.startswith(('4 3 ', '2 2 ', '6 5 '))]
        self.assertEqual(sorted(tags), sorted([points['Sonde ö']['tag']] + 2 * [points['well "1"']['tag']]))

    def test_names_of_points_as_they_are(self):
        def names(mesh):
            self.run_cover('convert', mesh, '-o', 'out.json', '-q')
            return {group['original']: group['vertices'] for group in json.loads((self.dir / 'out.json').read_text())['points']}
        self.run_cover('mesh', 'map.geojson', '-o', 'a.json', '-q')
        expected = {group['original']: group['vertices'] for group in json.loads((self.dir / 'a.json').read_text())['points']}
        for order in '1', '2':
            self.run_cover('mesh', 'map.geojson', '-o', 'm.vtm', '-o', 'm.vtu', '-o', 'm.inp', '-o', 'm.msh', '--order', order, '-q')
            for extension in 'vtm', 'vtu', 'inp', 'msh':
                self.assertEqual(names(f'm.{extension}'), expected, (extension, order))

    def test_points_beyond_the_axis_of_a_deck_are_told(self):
        self.write('s.json', json.dumps({'polygons': [{'material': 'Si', 'rings': [[[-1, 0], [1, 0], [1, 1], [-1, 1]]]}]}))
        told = ' in s.inp have x < 0: solvers refuse axisymmetric elements (--inp-element CAX) there, the axis is x = 0'
        for words in ('mesh', 's.json'), ('convert', 'mesh.vtm'):
            self.assertIn('2 points' + told, self.run_cover(*words, '--inp-element', 'CAX', '-o', 's.inp', '-o', f'{words[0]}.vtm')[1])
            self.assertNotIn('x < 0', self.run_cover(*words, '--inp-element', 'CPS', '-o', 's.inp')[1])
        self.write('r.json', json.dumps({'polygons': [{'material': 'Si', 'rings': [[[-0.0, 0], [1, 0], [1, 1], [0, 1]]]}]}))
        self.assertNotIn('x < 0', self.run_cover('mesh', 'r.json', '--inp-element', 'CAX', '-o', 'r.inp')[1])

    def test_formats_without_names_of_points_are_told(self):
        told = 'names of points (Sonde ö, well "1") are not in {}: formats that hold them are .vtm, .vtkhdf, .msh, .mesh, .inp, .json'
        self.run_cover('mesh', 'map.geojson', '-o', 'm.vtm', '-q')
        for words in ('mesh', 'map.geojson'), ('convert', 'm.vtm'):
            for extension in 'vtu', 'vtk', 'xdmf', 'ele', 'ply':
                self.assertIn(told.format('a.' + extension), self.run_cover(*words, '-o', 'a.' + extension)[1])
            self.assertIn('names of points', self.run_cover(*words, '-o', 'p.msh', '--msh', '4.1', '--parts', '2')[1])
            for files in ('-o', 'b.vtu', '-o', 'b.json'), ('-o', 'c.vtu', '-o', 'c.vtm'), ('-o', 'd.msh'), ('-o', 'd.vtkhdf'), ('-o', 'd.poly'):
                self.assertNotIn('names of points', self.run_cover(*words, *files)[1])

    def test_numbers_of_points_are_those_of_a_file(self):
        for name, has_some in ('a.msh', True), ('a.mesh', True), ('a.xdmf', False), ('a.vtk', False), ('a.ele', False):
            out, _ = self.run_cover('mesh', 'map.geojson', '-o', name)
            (self.assertRegex if has_some else self.assertNotRegex)(out, r'group +point *\n')
        self.assertNotIn('Sonde', self.run_cover('mesh', 'map.geojson', '-o', 'a.obj')[0])

    def test_info_and_reports_list_them(self):
        out, _ = self.run_cover('info', 'map.geojson', '-v')
        self.assertRegex(out, r'Named points\n +point +name +at\n +\d+ +Sonde ö +\(4, 3\)\n +\d+ +well "1" +\(2, 2\)\n')
        self.assertNotIn('Named points', self.run_cover('info', 'map.geojson')[0])
        self.run_cover('mesh', 'map.geojson', '-o', 'a.vtm', '--report', 'r.json', '-q')
        points = json.loads((self.dir / 'r.json').read_text())['input']['named_points']
        self.assertEqual([(point['name'], point['at']) for point in points], [('Sonde ö', [4, 3]), ('well "1"', [2, 2]), ('well "1"', [6, 5])])

    def test_points_keep_their_names_through_files(self):
        self.run_cover('mesh', 'map.geojson', '-o', 'a.msh', '-q')
        for name in 'a.msh', 'b.vtkhdf', 'd.vtm', 'c.vtu':
            with_names = ['-o', 'c.json'] if name == 'c.vtu' else []
            for order in '1', '2':
                self.run_cover('mesh', 'map.geojson', '-o', name, *with_names, '--order', order, '-q')
                self.run_cover('convert', name, '-o', 'again.msh')
                self.assertEqual(self.groups_of_msh('again.msh'), self.EXPECTED, name)
        # Without a manifest, which would tell how they are spelled. Nodes of lines are no points.
        for element in 'CPS', 'S':
            for order in '1', '2':
                self.run_cover('mesh', 'map.geojson', '-o', 'e.inp', '-o', 'e.mesh', '--inp-element', element, '--order', order, '-q')
                self.run_cover('convert', 'e.inp', '-o', 'again.msh')
                self.assertEqual(self.groups_of_msh('again.msh'), {'SONDE___': [[4, 3]], 'WELL__1__2': [[2, 2], [6, 5]]})
                self.run_cover('convert', 'e.mesh', '-o', 'again.msh')
                self.assertEqual(sorted(self.groups_of_msh('again.msh').values()), sorted(self.EXPECTED.values()))
        self.run_cover('mesh', 'map.geojson', '-o', 'a.msh', '-o', 'a.vtkhdf', '-q')
        self.run_cover('mesh', 'map.geojson', '-o', 's.msh', '-o', 's.vtkhdf', '--stream', 'on', '-q')
        self.assertEqual(*(self.groups_of_msh(name) for name in ('a.msh', 's.msh')))
        for extension in 'msh', 'vtkhdf':
            self.assertEqual(*((self.dir / f'{name}.{extension}').read_bytes() for name in 'as'))


if __name__ == '__main__':
    main()
