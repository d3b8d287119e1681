#!/usr/bin/env python3
"""render_test.py PROGRAM SAMPLES [TEST...]: cover render, and pages to look at a mesh in."""
import json
import re
import shutil
import subprocess
import unittest

from cover_case import Case, PROGRAM, SAMPLES, main


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

    def test_values_at_points(self):
        self.run_cover('mesh', SAMPLES / 'nmos.tif', '-o', 'n.vtu', '-o', 'n.vtm', '-o', 'n.vtk', '-q')
        for name in ('n.vtu', 'n.vtm', 'n.vtk'):
            self.run_cover('render', name, '-o', name + '.svg', '--color', 'Net', '--title', 't')
        pictures = [(self.dir / f'n.{e}.svg').read_text() for e in ('vtu', 'vtm', 'vtk')]
        self.assertGreater(len(set(re.findall('fill="(#[0-9a-f]{6})"', pictures[0]))), 10)
        self.assertEqual(*(re.findall('<path fill=[^/]*/>', pictures[k]) for k in (0, 2)))

    def test_values_at_points_are_those_of_the_region(self):
        # Doping is above zero in silicon, also at its border, and zero in all else.
        self.run_cover('mesh', SAMPLES / 'nmos.tif', '-o', 'n.vtm', '-o', 'n.vtu', '--report', 'r.json', '-q')
        regions = json.loads((self.dir / 'r.json').read_text())['regions']
        undoped = sum(region['triangles'] for region in regions if region['material_name'] != 'Si')
        for mesh in 'n.vtm', 'n.vtu':
            self.run_cover('render', mesh, '-o', 'n.svg', '--color', 'Total', '--range', '0,1', '--no-edges', '--worst', 0)
            lowest = re.search('<path clip-path[^>]* fill="#440154"[^>]* d="([^"]*)"', (self.dir / 'n.svg').read_text())
            self.assertEqual(lowest[1].count('M'), undoped, mesh)

    def test_expressions_of_arrays(self):
        self.run_cover('mesh', SAMPLES / 'nmos.tif', '-o', 'n.vtm', '-q')
        self.run_cover('render', 'n.vtm', '-o', 'n.svg', '--color', 'asinh(Net/1e10)', '--title', 't')
        ends = [float(text) for text in re.findall(r'>(-?[0-9.]+)</text>', (self.dir / 'n.svg').read_text())]
        self.assertTrue(20 < max(ends) < 30, ends)
        self.assertIn('as an expression: ', self.run_cover('render', 'n.vtm', '-o', 'n.svg', '--color', 'asinh(Nit)', code=2)[1])

    def test_arrays_of_our_own(self):
        self.run_cover('mesh', SAMPLES / 'fibre_cell.json', '-o', 'p.vtu', '-q')
        self.run_cover('mesh', SAMPLES / 'fibre_cell.json', '-o', 'p.pvtu', '--parts', '3', '-q')
        for mesh, names in (('p.vtu', ('PeriodicNode',)), ('p.pvtu', ('Owner', 'GlobalCellId', 'GlobalNodeId', 'PeriodicNode'))):
            for name in names:
                self.run_cover('render', mesh, '-o', 'p.svg', '--color', name, '--title', 't')
                ends = [float(text) for text in re.findall(r'>([0-9.]+)</text>', (self.dir / 'p.svg').read_text())]
                self.assertGreaterEqual(min(ends), 0)
                self.assertTrue(1.3 < max(ends) <= 2 if name == 'Owner' else max(ends) > 60, (name, ends))
        _, err = self.run_cover('render', 'p.vtu', '-o', 'p.svg', '--color', 'Owner', code=2)
        self.assertIn("has no array 'Owner'; it has ", err)

    def test_angles_where_the_file_has_none(self):
        self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.msh', '-o', 'd.inp', '-o', 'd.mesh', '-o', 'd.vtm', '-q')
        for name in ('max_angle', 'min_angle'):
            pictures = []
            for mesh in ('d.vtu', 'd.msh', 'd.inp', 'd.mesh', 'd.vtm'):
                self.run_cover('render', mesh, '-o', 'p.svg', '--color', name, '--title', 't')
                pictures.append((self.dir / 'p.svg').read_text())
            # Of 64 colours those that are seen, and the ends of the bar.
            seen = [(re.findall('<path fill="(#[0-9a-f]{6})"', text), re.findall(r'>([0-9.]+)</text>', text)) for text in pictures]
            self.assertGreater(len(set(seen[0][0])), 10)
            self.assertEqual(seen, seen[:1] * len(seen))

    def test_materials_where_the_file_has_groups_alone(self):
        # The third region lies between the others: materials are not in the order of the regions.
        square = [[0, 0], [1, 0], [1, 1], [0, 1]]
        self.write('d.json', json.dumps({'polygons': [
            {'material': material, 'region': region, 'rings': [[[x + dx, y] for x, y in square]]}
            for material, region, dx in (('Si', 'body', 0), ('oxide', 'ox', 2), ('Si', 'well', 1))]}))
        for name, *options in (('d.inp',), ('d.mesh',), ('d.msh',), ('e.msh', '--msh', '4.1')):
            folder = self.dir / name.replace('.', '_')
            folder.mkdir()
            self.run_cover('mesh', 'd.json', '-o', folder / name, *options, '-q')
            for other in folder.glob('*.json'):
                other.unlink()
            self.run_cover('convert', folder / name, '-o', folder / 'n.json', '-q')
            self.run_cover('render', folder / name, '-o', folder / 'p.svg', '--title', 't')
            regions = json.loads((folder / 'n.json').read_text())['regions']
            self.assertEqual(len(regions), 3)
            said = {region['name'] if region['name'] == region['material_name'] else
                    f"{region['name']} ({region['material_name']})" for region in regions}
            picture = (folder / 'p.svg').read_text()
            texts = {re.sub(', 2 regions$', '', text) for text in re.findall('>([^<]*)</text>', picture)}
            legend = texts & {*said, 'body', 'ox', 'well'}
            self.assertEqual(legend, said, name)
            self.assertEqual(len(set(re.findall('<path fill="(#[0-9a-f]{6})"', picture))), len(said), name)

    def test_the_surface_of_a_device_on_top(self):
        # In TCAD's files y grows into the substrate.
        self.run_cover('mesh', SAMPLES / 'nmos.tif', '-o', 'n.vtm', '-q')

        def heights(*options):
            self.run_cover('render', 'n.vtm', '-o', 'n.svg', *options)
            texts = re.findall(r'<text[^>]* y="([\d.]+)"[^>]*>(gate|bulk)<', (self.dir / 'n.svg').read_text())
            return {name: float(y) for y, name in texts}
        up, down = heights(), heights('--y-down')
        self.assertEqual(set(up), {'gate', 'bulk'})
        self.assertGreater(up['gate'], up['bulk'])
        self.assertLess(down['gate'], down['bulk'])

    def test_unknown_array(self):
        _, err = self.run_cover('render', 'd.vtu', '-o', 'd.png', '--color', 'stress', code=2)
        self.assertIn("the mesh has no array 'stress'; it has", err)

    def test_regions_and_materials_as_values(self):
        # A .vtm has a block for each region, and no array of them; the colours are those of the other formats.
        self.run_cover('mesh', SAMPLES / 'mosfet.poly', '-o', 'm.vtm', '-o', 'm.vtu', '-q')
        for name in ('RegionId', 'material'):
            for mesh in ('m.vtm', 'm.vtu'):
                self.run_cover('render', mesh, '-o', mesh + '.svg', '--color', name)
            self.assertEqual((self.dir / 'm.vtm.svg').read_text().count('<path'),
                             (self.dir / 'm.vtu.svg').read_text().count('<path'))

    def test_unknown_format(self):
        self.assertIn('.svg, .png', self.run_cover('render', 'd.vtu', '-o', 'd.gif', code=2)[1])


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
        self.assertEqual(text.count('<tr>') + text.count('<tr class') + text.count('<tr data'), 6 + 2 + 4 + 10 + text.count(' s</td></tr>'))
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


if __name__ == '__main__':
    main()
