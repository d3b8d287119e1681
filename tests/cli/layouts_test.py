#!/usr/bin/env python3
"""layouts_test.py PROGRAM SAMPLES [TEST...]: layouts: GDS and OASIS, layer maps, windows."""
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import time
import unittest

from cover_case import Case, PROGRAM, SAMPLES, SQUARE, main

KLAYOUT = pathlib.Path('/usr/lib/klayout')  # where Debian's package has its tools


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

    def test_check_names_the_layer_map_of_the_run(self):
        self.run_cover('mesh', SAMPLES / 'finfet.gds', *self.MAP, '-o', 'm.vtm', '-q')
        out = self.run_cover('check', SAMPLES / 'finfet.gds', 'm.vtm', code=6)[0]
        self.assertIn(f'The run that made it had other options: repeat --layer-map {self.MAP[1]} here\n', out)
        self.assertNotIn('repeat', self.run_cover('check', SAMPLES / 'finfet.gds', 'm.vtm', *self.MAP)[0])

    def test_says_why_nothing_is_left(self):
        for words, why in ((['--layer', '99'], 'nothing is on the layers chosen; other layers are 1/0'),
                           (['--window', '10,10,11,11'], 'nothing is in the window; the layout is from (-')):
            self.assertIn(why, self.run_cover('info', SAMPLES / 'finfet.gds', *words, code=2)[1])

    def test_a_wrong_layer_comes_before_the_labels_that_miss_theirs(self):
        words = ['info', SAMPLES / 'motor.dxf', '--layer', 'frame', '--layer', 'rotro', '--label-layer', 'labels']
        done = subprocess.run([PROGRAM, *words], cwd=self.dir, timeout=60, stderr=subprocess.PIPE, text=True)
        if 'in builds that have it' in done.stderr:
            return
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertRegex(done.stderr, r"^cover: warning: no line or curve is on the layer 'rotro'.*\ncover: error: .* the text '")

    def test_drawings_and_decks_from_a_pipe(self):
        for name in ('nmos.cmd', 'nmos.str', 'motor.dxf'):
            done = subprocess.run([PROGRAM, 'info', '-'], input=(SAMPLES / name).read_bytes(), cwd=self.dir, timeout=60,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            if name == 'motor.dxf' and b'in builds that have it' in done.stderr:
                continue
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(b'regions', done.stdout)

    def test_options_that_do_nothing_are_told(self):
        self.write('a.poly', SQUARE)
        for command in ('info', 'a.poly'), ('mesh', 'a.poly', '-o', 'a.vtu'):
            error = self.run_cover(*command, '--cell', 'TOP', '--unit', 'nm')[1]
            self.assertIn('--cell does nothing: it counts with layouts only', error)
            self.assertNotIn('--unit', error)
        self.write('a.geojson', '{"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1], [0, 0]]]}')
        error = self.run_cover('info', 'a.geojson', '--chord-angle', '10')[1]
        self.assertIn('--chord-angle does nothing: it counts with drawings, layouts and maps with curves only', error)

    def test_maps_in_geojson_have_the_unit_of_their_system(self):
        if '.gpkg' not in self.run_cover('info', '--help')[0]:
            self.skipTest('without GDAL, which knows systems')

        def drawn(name, system, x):
            self.write(name, '{"type": "Feature", "properties": {"name": "a"}, "crs": {"type": "name", "properties": {"name": "%s"}}, '
                       '"geometry": {"type": "Polygon", "coordinates": [[[%d, 0], [%d, 0], [%d, 1000]]]}}' % (system, x, x + 1000, x))
            return self.run_cover('info', name)
        self.assertIn('lengths in m\n', drawn('a.geojson', 'urn:ogc:def:crs:EPSG::25832', 1000)[0])
        self.assertNotIn('lengths in', drawn('f.geojson', 'EPSG:2263', 1000)[0])  # feet
        out, told = self.run_cover('info', 'a.geojson', '--unit', 'mm')
        self.assertIn('lengths in mm\n', out)
        self.assertIn('the option unit says mm, and the input m: mm is taken', told)
        told = self.run_cover('info', 'a.geojson', '--unit', 'm', '--scale', '0.001')[1]
        self.assertIn('the option unit says m, and lengths in m times 0.001 are not in it: m is taken', told)
        self.assertNotIn('option unit', self.run_cover('info', 'a.geojson', '--unit', 'mm', '--scale', '1000')[1])
        out, told = drawn('b.geojson', 'EPSG:999999', 3000)
        self.assertNotIn('lengths in', out)
        self.assertIn('PROJ does not know the system of its coordinates, EPSG:999999', told)
        told = self.run_cover('info', 'a.geojson', 'b.geojson', code=2)[1]
        self.assertNotIn('EPSG:999999', told.partition('ogr2ogr')[2])

    def test_attributes_of_maps_are_listed(self):
        for name, key, x in ('a', 'USE', 0), ('b', 'SOIL', 2):
            self.write(name + '.geojson', '{"type": "Feature", "crs": null, "properties": {"%s": 1, "nr": 2}, "geometry": '
                       '{"type": "Polygon", "coordinates": [[[%d, 0], [%d, 0], [%d, 1]]]}}' % (key, x, x + 1, x))
        listed = 'Attributes of the map, for --name-field, --material-field and their like: '
        self.assertIn(listed + 'USE, nr\n', self.run_cover('info', 'a.geojson')[0])
        self.assertIn(listed + 'USE, nr, SOIL\n', self.run_cover('info', 'a.geojson', 'b.geojson')[0])
        self.assertNotIn('Attributes', self.run_cover('info', self.write('a.poly', SQUARE))[0])

    def test_maps_of_other_formats_are_told_of_ogr2ogr(self):
        for name in 'a.tab', 'a.gpx', 'a.mif', 'a.geojsonl', 'a.csv', 'a.wkt':
            told = self.run_cover('info', self.write(name, 'x'), code=5)[1]
            self.assertIn("'ogr2ogr -f GeoJSON ", told)
            self.assertIn(' can be read', told)
        self.assertIn('--size-field', self.run_cover('info', 'a.csv', code=5)[1])

    def test_options_that_count_for_one_of_several_files_do_something(self):
        self.write('a.geojson', '{"type": "Feature", "crs": null, "properties": {}, "geometry": {"type": "Polygon", "coordinates": '
                                '[[[0, 0], [1, 0], [0, 1], [0, 0]]]}}')
        self.write('b.json', '{"polygons": [{"material": "Si", "rings": [[[0, 0], [-1, 0], [0, -1]]]}]}')
        self.write('c.poly', SQUARE)
        for files in ('a.geojson', 'b.json'), ('a.geojson', 'c.poly'), ('c.poly', 'a.geojson'):
            told = self.run_cover('info', *files, '--keep-field', 'fid', '--name-field', 'x', code=2)[1]
            self.assertIn("--name-field: a.geojson: no feature has the property 'x'", told)
            self.assertNotIn('does nothing', self.run_cover('info', *files, '--keep-field', 'fid')[1])
        told = self.run_cover('info', 'a.geojson', 'c.poly', '--keep-field', 'fid', '--cell', 'TOP')[1]
        self.assertNotIn('--keep-field', told)
        self.assertIn('--cell does nothing: it counts with layouts only', told)
        self.assertIn('--keep-field: b.json: it is no map', self.run_cover('info', 'b.json', 'c.poly', '--keep-field', 'x', code=2)[1])

    def test_formats_of_an_unknown_file_are_all_told(self):
        error = self.run_cover('info', self.write('a.xyz', 'x'), code=5)[1]
        known = error.partition('known: ')[2]
        self.assertIn('.poly, .msh, ', known)
        help_text = ' '.join(self.run_cover('info', '--help')[0].split())
        for extension in '.oas', '.dxf', '.shp', '.gpkg', '.fgb', '.gml', '.kml':
            if extension == '.oas' or extension in help_text:
                self.assertIn(extension, known)
        self.assertIn('possible are .vtu, .vtm, ', self.run_cover('convert', 'a.xyz', '-o', 'a.vtu', code=5)[1])

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
        self.assertEqual(list(self.dir.glob('.cover-oasis*')), [], 'a folder was left')
        return done.stdout + done.stderr

    @unittest.skipUnless((KLAYOUT / 'strm2oas').exists(), 'KLayout is not there')
    def test_oasis_that_klayout_made(self):
        """Polygons may begin at other corners and come in another order; the drawing is the same."""
        made = subprocess.run([KLAYOUT / 'strm2oas', SAMPLES / 'finfet.gds', 'finfet.oas'], cwd=self.dir, timeout=60,
                              env={'LD_LIBRARY_PATH': str(KLAYOUT)}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.assertEqual(made.returncode, 0, made.stdout)
        drawn = sorted(self.materials(SAMPLES / 'finfet.gds', *self.MAP))
        self.assertEqual(sorted(self.materials('finfet.oas', *self.MAP)), drawn)
        self.assertIn('HfO2', drawn)
        (self.dir / 'cut.oas').write_bytes((self.dir / 'finfet.oas').read_bytes()[:300])
        error = self.run_cover('info', 'cut.oas', code=5)[1]
        self.assertIn('cut.oas: KLayout makes no GDSII of it', error)

    def test_an_interrupt_while_klayout_reads_leaves_nothing(self):
        """Ctrl-C in a terminal goes to all programs that run there, `kill` to this one alone."""
        self.write('a.OAS', '%SEMI-OASIS')
        tools = self.dir / 'bin'
        tools.mkdir()
        (tools / 'strm2gds').write_text('#!/bin/sh\necho $$ >begun\nexec /bin/sleep 50\n')
        (tools / 'strm2gds').chmod(0o755)
        for send in os.kill, os.killpg:
            for one in signal.SIGINT, signal.SIGTERM, signal.SIGHUP:
                if signal.getsignal(one) == signal.SIG_IGN:
                    continue  # as by nohup, and what it starts ignores it, too
                run = subprocess.Popen([PROGRAM, 'info', 'a.OAS'], cwd=self.dir, env={'PATH': str(tools), 'TMPDIR': str(self.dir)},
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True)
                self.addCleanup(run.kill)
                begun = self.dir / 'begun'
                while not begun.exists() or not begun.read_text().endswith('\n'):
                    self.assertIsNone(run.poll())
                send(run.pid, one)
                out, err = run.communicate(timeout=20)
                self.assertEqual((run.returncode, out), (130, ''), (send, one, err))
                # A second after the signal the program ends in any case.
                self.assertEqual(err, 'cover: error: interrupted\n')
                self.assert_ends(int(begun.read_text()))
                begun.unlink()
                self.assertEqual(self.files(), ['a.OAS', 'bin'])

    def test_a_kill_while_klayout_reads_leaves_nothing(self):
        """Nobody can wait for that: a process of its own removes the folder."""
        self.write('a.OAS', '%SEMI-OASIS')
        tools = self.dir / 'bin'
        tools.mkdir()
        (tools / 'strm2gds').write_text('#!/bin/sh\necho $$ >begun\n: >"$2"\nexec /bin/sleep 50\n')
        (tools / 'strm2gds').chmod(0o755)
        for send in os.kill, os.killpg:
            run = subprocess.Popen([PROGRAM, 'info', 'a.OAS'], cwd=self.dir, env={'PATH': str(tools), 'TMPDIR': str(self.dir)},
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
            self.addCleanup(run.kill)
            while not list(self.dir.glob('.cover-oasis.*/layout.gds')):
                self.assertIsNone(run.poll())
            send(run.pid, signal.SIGKILL)
            run.wait(20)
            reader = int((self.dir / 'begun').read_text())
            if send == os.kill:
                os.kill(reader, signal.SIGKILL)
            self.assert_ends(reader)
            (self.dir / 'begun').unlink()
            for _ in range(200):
                if self.files() == ['a.OAS', 'bin']:
                    break
                time.sleep(0.1)
            self.assertEqual(self.files(), ['a.OAS', 'bin'])

    def assert_ends(self, process):
        """Within some seconds; where nothing takes its exit code, only that is left."""
        status = pathlib.Path(f'/proc/{process}/stat')
        for _ in range(100):
            try:
                if status.read_text().rpartition(')')[2].split()[0] == 'Z':
                    return
            except OSError:
                return
            time.sleep(0.1)
        self.fail('KLayout still runs')

    @unittest.skipIf((KLAYOUT / 'strm2gds').exists(), 'KLayout itself is there')
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


if __name__ == '__main__':
    main()
