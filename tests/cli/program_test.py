#!/usr/bin/env python3
"""program_test.py PROGRAM SAMPLES [TEST...]: the program as such: help, messages, exit codes, job files, memory, interrupts."""
import json
import math
import os
import re
import resource
import shutil
import signal
import subprocess
import time
import unittest
from xml.etree import ElementTree

from cover_case import APP, Case, PROGRAM, SAMPLES, SQUARE, main


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

    def test_starts_without_the_libraries_that_few_runs_need(self):
        # Four in five milliseconds of a start went to them. A sanitizer's own library may not be traced.
        listed = subprocess.run([PROGRAM], env={**os.environ, 'LD_TRACE_LOADED_OBJECTS': '1'}, stdout=subprocess.PIPE,
                                text=True).stdout
        self.assertIn('libstdc++', listed)
        self.assertNotRegex(listed, 'libvtk|libhdf5|libgdal')

    def test_misspelt_command(self):
        self.assertEqual(self.run_cover('msh', code=2)[1].splitlines()[0],
                         "cover: error: unknown command 'msh'; did you mean 'mesh'?")

    def test_misspelt_option(self):
        error = self.run_cover('mesh', 'a.poly', '-o', 'a.vtu', '--fil=disks', code=2)[1]
        self.assertIn("unknown option '--fil=disks'; did you mean '--fill'?", error)

    def test_short_option_with_equals(self):
        # A file '=a.vtu' would be written.
        error = self.run_cover('mesh', 'a.poly', '-o=a.vtu', code=2)[1]
        self.assertIn("'-o=a.vtu': the value of -o stands behind it without '='", error)

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

    def test_wrong_numbers_of_values(self):
        for words, message in ((['mesh', 'a.poly', '-o'], '--output needs FILE behind it'),
                               (['mesh', 'a.poly', '-o', 'a.vtu', '-j', '1', '-j', '2'], '--threads is given 2 times, once is the most'),
                               (['render', 'a.vtu', '-o', 'a.svg', '--range', '1'], '--range takes 2 values, not 1'),
                               (['render', 'a.vtu', '-o', 'a.svg', '--range', '1,2,3'], '--range takes 2 values, not 3')):
            self.assertTrue(self.run_cover(*words, code=2)[1].startswith(f'cover: error: {message}\n'), words)

    def test_nothing_to_do(self):
        self.assertIn('no input file', self.run_cover('mesh', '-o', 'a.vtu', code=2)[1])
        self.assertIn('nothing to write', self.run_cover('mesh', 'a.poly', code=2)[1])

    def test_unknown_output_format(self):
        error = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'a.xyz', code=2)[1]
        self.assertIn("unknown format '.xyz'; possible are .vtu", error)
        self.assertEqual(self.files(), [])


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

    def test_values_with_quotes_can_be_read_back(self):
        shutil.copy(SAMPLES / 'diode.poly', self.dir / 'di"o\'de.poly')
        for output in ('it\'s "z".vtu', '"x".vtu', "'x'.vtu", '\'\'\'"""\\"".vtu', 'a, b].vtu', '"a", "b".vtu', '#x`.vtu', 'a\nb\\n.vtu',
                       'a\\u00e9\x01.vtu', '1e3', '007'):
            command = ['mesh', 'di"o\'de.poly', '-o', output, '-o', 'it\'s "2".msh', '--size', '"1"=0.5', '--periodic', '"x=y"="r@1,2"']
            printed = self.run_cover(*command, '--print-config')[0]
            self.write('job.toml', printed)
            self.assertEqual(self.run_cover('mesh', '--config', 'job.toml', '--print-config')[0], printed, output)
        self.write('job.toml', self.run_cover('mesh', 'di"o\'de.poly', '-o', 'it\'s "z".vtu', '-o', 'it\'s "2".msh', '--print-config')[0])
        self.run_cover('mesh', '--config', 'job.toml', '-q')
        self.assertIn('it\'s "z".vtu', self.files())
        self.assertIn('it\'s "2".msh', self.files())

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

    def test_types_and_keys_that_do_not_fit(self):
        for text, said in (('hull = 7', "--hull: '7' is not true or false"),
                           ('hull = "maybe"', "--hull: 'maybe' is not true or false"),
                           ('threads = 1.5', "--threads: 1.5 is not a whole number"),
                           ('config = "job.toml"', "'config' does not stand in a --config file"),
                           ('dry-run = true', "'dry-run' does not stand in a --config file")):
            self.write('job.toml', text + '\n')
            _, err = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '--config', 'job.toml', code=2)
            self.assertIn(said, err)
        for text in 'hull = true', 'hull = "off"', 'hull = 1':
            self.write('job.toml', text + '\n')
            self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '--config', 'job.toml')

    def test_what_is_no_toml(self):
        for text, said in (('output = ["x.vtu"\nsize = 4\n', "job.toml:2: array: expected comma or closing ']'"),
                           ('# job\ninput = "gap.json\n', 'job.toml:2: string: '),
                           ("output = ['x.vtu', 'x.msh]\n", 'job.toml:1: literal string: '),
                           ("output = ['x.vtu', 'x.msh]\n", '; a string ends on its line\n'),
                           ('size = 1\nstrict = yes\n', 'job.toml:2: value: could not determine value type; text stands in quotes\n'),
                           ('output = "a\\b\\q.vtu"\n', "job.toml:1: string: unknown escape sequence '\\q'"),
                           ('size = 1\nsize = 2\n', "job.toml:2: key-value pair: cannot redefine existing integer 'size'; several values"),
                           ('size = 1\n' + 'a.' * 100000 + 'b = 1\n', 'job.toml:2: a key has more than 16 parts\n'),
                           ('size = ' + '[' * 100000, 'job.toml:1: value: exceeded maximum nested value depth'),
                           ('layer = 68/20\n', '; text stands in quotes\n'),
                           ('# ' + '.' * 300 + '\nsize = yes\n', 'job.toml:2: value: could not determine'),
                           ('size = [[1], 2]\n', 'job.toml:1: the value of size is no text, number, true, false or list of these\n')):
            self.write('job.toml', text)
            _, err = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.vtu', '--config', 'job.toml', code=2)
            self.assertIn(said, err)

    def test_strings_of_every_kind(self):
        for text, name in ((r'"q\u00e9 \\ \"2\".vtu"', 'q\u00e9 \\ "2".vtu'), ("\'\'\'q.vtu\'\'\'", 'q.vtu'), (r"'a\u00e9.vtu'", r'a\u00e9.vtu'),
                           ('"""\nq.vtu"""', 'q.vtu')):
            self.write('job.toml', f'output = {text}\n')
            self.run_cover('mesh', SAMPLES / 'diode.poly', '--config', 'job.toml', '-q')
            self.assertEqual(self.files(), sorted(['job.toml', name]))
            (self.dir / name).unlink()

    def test_lists_and_comments(self):
        (self.dir / 'd#1.poly').write_bytes((SAMPLES / 'diode.poly').read_bytes())
        self.write('job.toml', '\ufeffinput = "d#1.poly"  # the diode\noutput = [  # two\n  "x.vtu",  # one\n  \'x.msh\'\n] # done\n'
                               'method = "almond" # that\'s all\n')
        self.run_cover('mesh', '--config', 'job.toml', '-q')
        self.assertEqual(self.files(), ['d#1.poly', 'job.toml', 'x.msh', 'x.vtu'])

    def test_an_option_that_stands_alone(self):
        for text, option in (('true', '90'), ('100', '100'), ('false', None)):
            self.write('job.toml', f'split-interfaces = {text}\n')
            self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.json', '--config', 'job.toml', '-q')
            self.assertEqual(json.loads((self.dir / 'd.json').read_text())['options'].get('split-interfaces'), option)
        self.write('job.toml', 'split-interfaces = "much"\n')
        _, err = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'd.json', '--config', 'job.toml', code=2)
        self.assertIn("--split-interfaces: 'much' is not a number\n", err)

    def test_missing_file(self):
        _, err = self.run_cover('mesh', 'a.poly', '-o', 'd.vtu', '--config', 'none.toml', code=2)
        self.assertIn('none.toml', err)


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
        about, text = report['estimate'], self.run_cover('mesh', SAMPLES / 'diode.poly', '--dry-run')[0]
        told = re.search(r'A mesh takes about ([0-9,]+) triangles and ([0-9,]+) MB of memory, of ([0-9,]+) MB\n', text)
        told = [float(number.replace(',', '')) for number in told.groups()]
        self.assertAlmostEqual(told[0] / about['triangles'], 1, delta=0.05)
        self.assertEqual(told[1], about['bytes'] // 1e6)
        self.assertAlmostEqual(told[2] / about['available_bytes'] * 1e6, 1, delta=0.5)
        self.assertFalse(about['by_disks'])

    def test_json_tells_how_files_are_read(self):
        self.write('m.geojson', json.dumps({'type': 'Feature', 'properties': {'use': 'wood'}, 'geometry': {
            'type': 'Polygon', 'coordinates': [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]]}}))
        options = json.loads(self.run_cover('mesh', 'm.geojson', '--material-field', 'use', '--size', '1', '--dry-run', '--stats', 'json')[0])
        self.assertEqual((options['options']['material-field'], options['options']['size']), ('use', '1'))

    def test_report_is_not_written(self):
        for words in ((), ('--stats', 'json')):
            _, err = self.run_cover('mesh', SAMPLES / 'diode.poly', '--report', 'r.json', '--dry-run', *words)
            self.assertIn('--report writes nothing in a dry run', err)
            self.assertEqual(self.files(), [])

    def test_estimate_with_layers_of_the_input(self):
        words = (SAMPLES / 'mosfet_layers.json', '--split-interfaces', '--box-method', '--size-at', 'channel_oxide=20', '--size-at', 'oxide_gate=20')
        report = json.loads(self.run_cover('mesh', *words, '-o', 's.vtu', '--dry-run', '--stats', 'json')[0])
        made, _ = self.run_cover('mesh', *words, '-o', 's.vtu')
        made = float(re.match(r'([0-9,]+) triangles', made)[1].replace(',', ''))
        self.assertLess(abs(report['estimate']['triangles'] - made), 0.3 * made)

    def test_estimate(self):
        self.write('s.poly', SQUARE)
        fine = ('--split-interfaces', '--size', '0.02')
        out, _ = self.run_cover('mesh', 's.poly', '-o', 's.vtu', '--dry-run', *fine)
        about = float(re.search(r'A mesh takes about ([0-9,]+) triangles and \d+ MB of memory, of [\d,]+ MB\b', out)[1].replace(',', ''))
        made, _ = self.run_cover('mesh', 's.poly', '-o', 's.vtu', *fine)
        made = float(re.match(r'([0-9,]+) triangles', made)[1].replace(',', ''))
        self.assertLess(abs(about - made), 0.3 * made)
        self.assertNotIn('disk', out)
        # What the run keeps on the disk may take less.
        self.write_fine_squares(1, 1500)
        held = ' MB\nwhere it is held; this one stays on the disk, region by region, and may take less\n'
        for words, is_told in ((('--size', '0.01'), False), (('--size', '0.01', '--stream', 'on'), True), (('--size', '7e-4'), True),
                               (('--size', '7e-4', '--stream', 'off'), False), (('--size', '7e-4', '-o', 's.svg'), False)):
            out, _ = self.run_cover('mesh', 's.json', '-o', 's.vtu', '--dry-run', *words)
            self.assertEqual(held in out, is_told, (words, out))
        out, _ = self.run_cover('mesh', SAMPLES / 'plate.poly', '-o', 's.vtu', '--dry-run', '--method', 'nonobtuse')
        self.assertRegex(out, r'There is no estimate where disks are packed, .*\n.* some 1,[0-9]00 triangles and ')
        self.assertNotIn('A mesh takes about', out)
        out, _ = self.run_cover('mesh', SAMPLES / 'plate.poly', '--dry-run', '--method', 'nonobtuse', '--stats', 'json')
        self.assertTrue(json.loads(out)['estimate']['by_disks'])

    def write_fine_squares(self, count, n):
        """With sides of n segments each, so that triangles inside may be as fine without cuts."""
        points, segments = [], []
        for x in range(0, 2 * count, 2):
            first = len(points)
            points += [(x + p, q) for k in range(n) for p, q in ((k / n, 0), (1, k / n), (1 - k / n, 1), (0, 1 - k / n))]
            segments += [(first + 4 * k + side, first + (4 * (k + 1) + side if k + 1 < n else (side + 1) % 4))
                         for k in range(n) for side in range(4)]
        self.write('s.json', json.dumps({'points': points, 'segments': segments}))

    def test_what_does_not_fit(self):
        self.write('s.poly', SQUARE)
        if os.sysconf('SC_PHYS_PAGES') * os.sysconf('SC_PAGE_SIZE') > 6e10:
            self.skipTest('it might fit')
        begin = time.monotonic()
        _, err = self.run_cover('mesh', 's.poly', '-o', 's.vtu', '--split-interfaces', '--size', '6e-5', code=7)
        self.assertLess(time.monotonic() - begin, 10)
        self.assertRegex(err, r'the sizes asked for take about 6.4e\+08 triangles and 108 GB of memory, and there are ')
        # A dry run asks for the memory that the run would need: of one region, where the mesh stays on the disk.
        self.write_fine_squares(16, 500)
        for words in ['-o', 's.vtu', '--stream', 'off'], ['-o', 's.vtm'], []:
            _, err = self.run_cover('mesh', 's.json', '--size', '2.6e-4', *words, '--dry-run', code=7)
            self.assertRegex(err, r'take about 5.5e\+08 triangles and 91\.8 GB of memory, and there are ')
        out, _ = self.run_cover('mesh', 's.json', '--size', '2.6e-4', '-o', 's.vtu', '--dry-run')
        self.assertIn('where it is held; this one stays on the disk', out)
        self.assertEqual(self.files(), ['s.json', 's.poly'])


class BadInput(Case):
    """Each fault of the geometry ends with its exit code and a message that names file, ids and place."""

    def refuse(self, text, code, *parts):
        self.write('bad.poly', text)
        _, err = self.run_cover('mesh', 'bad.poly', '-o', 'bad.vtu', '--strict', code=code)
        self.assertTrue(err.startswith('cover: error: '), err)
        for part in parts:
            self.assertIn(part, err)
        self.assertNotIn('bad.vtu', self.files())
        return err

    def test_missing_file(self):
        _, err = self.run_cover('mesh', 'none.poly', '-o', 'a.vtu', code=5)
        self.assertIn('none.poly', err)

    def test_many_warnings_of_one_sort_hide_no_other(self):
        ring = [[0, 0], [8, 0], [8, 8], [0, 8]]
        hidden = [{'material': f'm {k}', 'rings': [[[1 + k / 4, 1], [1.125 + k / 4, 1], [1 + k / 4, 2]]]} for k in range(15)]
        seam = [{'material': 'near', 'rings': [[[8, 0], [9, 0], [9, 8], [8, 8], [8.001, 4]]]}]
        self.write('d.json', json.dumps({'polygons': hidden + [{'material': 'top', 'rings': [ring]}] + seam}))
        _, err = self.run_cover('info', 'd.json')
        self.assertEqual(err.count('is wholly covered by others'), 9)
        self.assertIn('thin void', err)
        self.assertIn('6 further warnings are in the report', err)
        _, err = self.run_cover('info', 'd.json', '-vv')
        self.assertEqual(err.count('is wholly covered by others'), 15)

    def test_strict_says_its_name(self):
        # Two polygons that cross: both their edges are split.
        self.write('d.json', json.dumps({'polygons': [
            {'material': 'a', 'rings': [[[0, 0], [2, 0], [2, 2], [0, 2]]]},
            {'material': 'b', 'rings': [[[1, 0], [3, 0], [3, 1], [1, 1]]]}]}))
        _, err = self.run_cover('mesh', 'd.json', '-o', 'd.vtu', '--strict', code=3)
        self.assertIn('--strict refuses every change', err)
        # Corners on sides are what painting is for.
        self.run_cover('mesh', SAMPLES / 'tft.json', '-o', 'd.vtu', '--strict')

    def test_strict_refuses_commands_that_are_not_understood(self):
        body = '(sdegeo:create-rectangle (position 0 0 0) (position 2 1 0) "Si" "R")\n'
        self.write('d.cmd', body + '(sdedr:define-constant-profile "p" "Boron" 1e17)\n')
        self.run_cover('mesh', 'd.cmd', '-o', 'd.vtu', '--strict', '-q')
        for command in ('(do ((i 0 (+ i 1))) ((= i 3)) (gate i))', '#include "gates.cmd"',
                        '(sdegeo:mirror-selected (get-body-list) (transform) #t)'):
            self.write('d.cmd', body + command + '\n')
            _, err = self.run_cover('mesh', 'd.cmd', '-o', 'd.vtu', '--strict', '-q', code=3)
            self.assertIn('not understood and left out: ', err)
            _, err = self.run_cover('mesh', 'd.cmd', '-o', 'd.vtu')
            self.assertIn('input changed: 1 dropped: not understood and left out: ', err)

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
        self.assertNotIn('--weld', self.refuse(text, 3, '--hull meshes the convex hull'))
        self.run_cover('mesh', 'bad.poly', '-o', 'hull.vtu', '--hull', '-q')
        gap = SQUARE.replace('4 2 0 0', '5 2 0 0').replace('4 0\n1 1 2', '5 0 0.0001\n4 0\n1 1 2').replace('4 4 1', '4 4 5')
        self.refuse(gap, 3, '2 ends of lines nearly meet another, the first at (0, 0), 0.0001 away: --weld 2e-04 closes such gaps')
        self.run_cover('mesh', 'bad.poly', '-o', 'closed.vtu', '--weld', '2e-4', '-q')

    def test_nothing_enclosed(self):
        self.refuse('2 2 0 0\n1 0 0\n2 1 0\n1 0\n1 1 2\n0\n', 3)

    def test_no_segments(self):
        self.refuse('2 2 0 0\n1 0 0\n2 1 0\n0 0\n0\n', 3)

    def test_seed_in_the_void(self):
        self.refuse(SQUARE + '1\n1 5 5 1 -1\n', 3, '(5, 5)')

    def test_wrong_names_come_before_what_is_wrong_with_seeds(self):
        square = {'points': [[0, 0], [1, 0], [1, 1], [0, 1]], 'segments': [[0, 1], [1, 2], [2, 3], [3, 0]],
                  'regions': [{'x': 0.5, 'y': y, 'material': name} for y, name in ((0.4, 'iron'), (0.6, 'air'))]}
        self.write('d.json', json.dumps(square))
        words = ('mesh', 'd.json', '-o', 'd.vtu', '--size', 'iorn=1', '--size', 'air=1', '--layers', 'rim@quartz=0.1,1,1')
        _, err = self.run_cover(*words, code=3)
        self.assertRegex(err, "error: there is no region or material 'quartz'; there is no region or material 'iorn'; "
                              r"did you mean 'iron'\? d.json: region seed .* disagree on its material")
        self.assertNotIn("'air'; ", err)

    def test_folder_that_is_not_there(self):
        _, err = self.run_cover('mesh', SAMPLES / 'diode.poly', '-o', 'no/such/d.vtu', code=5)
        self.assertIn('no/such/d.vtu', err)


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

    def test_words_of_the_command_line(self):
        for words in (['me\x1bsh'], ['mesh', '--si\x1bze'], ['mesh', 'a.poly', '-o', 'a.vtu', '--fill', 'a\x1b'],
                      ['mesh', 'a.poly', '-o', 'a.\x1b']):
            self.assertIn('\\x1b', self.run_cover(*words, code=2)[1])
        self.write('s.poly', SQUARE)
        for name in 'a\x1b.vtm', 'a\n.pvtu', 'a\udcff.vtm':
            self.assertIn('cannot name files beside it', self.run_cover('mesh', 's.poly', '-o', name, code=2)[1])
        self.assertEqual(self.files(), ['s.poly'])

    def test_names_that_mean_something_in_xml(self):
        self.write('s.poly', SQUARE)
        for stem in 'a&b', 'a"b', '<b>':
            for word in f'{stem}.vtm', f'{stem}.xdmf':
                self.run_cover('mesh', 's.poly', '-o', word, '--xdmf', 'hdf5')
                self.assertIn('Every promise holds', self.run_cover('check', 's.poly', word)[0])


class Streams(Case):
    """What is printed is written too, or said not to be."""

    def with_stdout(self, stdout, *words, **more):
        return subprocess.run([PROGRAM, *map(str, words)], cwd=self.dir, stdout=stdout, stderr=subprocess.PIPE, text=True,
                              timeout=60, **more)

    def test_a_full_disk_behind_standard_output(self):
        self.write('s.poly', SQUARE)
        self.run_cover('mesh', 's.poly', '-o', 's.vtu')
        with open('/dev/full', 'w') as full:
            for words in (['--help'], ['--version'], ['mesh', '--help'], ['info', 's.poly'], ['check', 's.poly', 's.vtu'],
                          ['mesh', 's.poly', '-o', 's.vtu'], ['mesh', 's.poly', '--dry-run'],
                          ['mesh', 's.poly', '-o', 's.vtu', '--print-config'], ['convert', 's.vtu', '-o', '-']):
                run = self.with_stdout(full, *words)
                self.assertEqual((run.returncode, run.stderr.count('cannot write to standard output')), (5, 1), words)
            self.assertIn('cannot write to standard output: No space left on device\n', run.stderr)
            self.assertEqual(self.with_stdout(full, 'mesh', 's.poly', '-o', 's.vtu', '-q').returncode, 0)

    def test_nobody_reads_errors(self):
        self.write('s.poly', SQUARE)
        with open('/dev/full', 'w') as full:
            for words, code in ((['mesh', 's.poly', '-o', 's.vtu'], 5), (['info', 's.poly'], 5), (['--version'], 5), (['-x'], 2),
                                (['mesh', '--nonsense'], 2), (['info', 'none.poly'], 5), (['mesh', 's.poly', '-o', 's.vtu', '-q'], 0)):
                run = subprocess.run([PROGRAM, *words], cwd=self.dir, stdout=full, stderr=full, timeout=60)
                self.assertEqual(run.returncode, code, words)
            run = subprocess.run([PROGRAM, 'mesh', 's.poly', '-o', '-'], cwd=self.dir, stdout=subprocess.PIPE, stderr=full, timeout=60)
        self.assertEqual((run.returncode, run.stdout), (0, (self.dir / 's.vtu').read_bytes()))

    def test_a_full_disk_behind_the_log(self):
        self.write('s.poly', SQUARE)
        _, err = self.run_cover('mesh', 's.poly', '-o', 's.vtu', '--log', '/dev/full')
        self.assertRegex(err, r'^cover: warning: messages are missing in the log: .*No space left on device\n$')

    def test_files_longer_than_the_limit(self):
        self.write('s.poly', SQUARE)
        for kind in 'vtu', 'vtm', 'vtkhdf', 'msh', 'svg', 'png':
            run = self.with_stdout(subprocess.DEVNULL, 'mesh', SAMPLES / 'diode.poly', '-o', f'd.{kind}', '-q',
                                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1024, 1024)))
            self.assertEqual((run.returncode, run.stderr), (5, f'cover: error: cannot write d.{kind}: File too large\n'))
        self.assertEqual(self.files(), ['s.poly'])

    def test_no_place_for_what_passes_through(self):
        self.write('s.poly', SQUARE)
        run = self.with_stdout(subprocess.DEVNULL, 'mesh', 's.poly', '-o', '-', '-q', env={**os.environ, 'TMPDIR': '/none'})
        self.assertEqual(run.returncode, 5)
        self.assertIn('$TMPDIR is no folder', run.stderr)

    @unittest.skipUnless(os.access('/dev/full', os.W_OK), 'needs a full disk')
    def test_a_file_that_may_not_be_written(self):
        self.write('s.poly', SQUARE)
        self.run_cover('mesh', 's.poly', '-o', 's.vtu', '-o', 's.vtm', '-q')
        before = {name: (self.dir / name).read_bytes() for name in ('s.vtu', 's.vtm')}
        self.dir.chmod(0o777)
        other = {'user': 65534, 'group': 65534} if os.geteuid() == 0 else {}
        for name in before:
            (self.dir / name).chmod(0o444)
            run = self.with_stdout(subprocess.DEVNULL, 'mesh', 's.poly', '-o', name, '--max-angle', '90', **other)
            if run.returncode in (126, 127):
                self.skipTest('nobody may not run the program')
            self.assertEqual((run.returncode, name in run.stderr), (5, True), run.stderr)
            self.assertEqual((self.dir / name).read_bytes(), before[name])


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

    def test_help_says_what_standard_input_and_output_take(self):
        told = {command: ' '.join(self.run_cover(command, '--help')[0].split()) for command in ('mesh', 'convert', 'check', 'render')}
        self.assertIn("'-' is standard input, known by how it begins: any of these but .geo, .oas, .shp, .gpkg, .fgb, .gml and .kml;", told['mesh'])
        self.assertIn("'-' is stdout, in the format of --format, by way of $TMPDIR, for all but .vtm, .pvtu, .ele ", told['mesh'])
        self.assertIn("'-' is stdout, in the format of --format, for all but .vtm, .pvtu, .ele ", told['convert'])
        read = re.search(r"standard input, known by how it begins: (\.vtu.*?) or (\.inp)", told['convert'])
        self.write('square.poly', SQUARE)
        for extension in [*read[1].split(', '), read[2]]:
            self.run_cover('mesh', 'square.poly', '-o', 'm' + extension, '-q')
            with open(self.dir / ('m' + extension), 'rb') as mesh:
                subprocess.run([PROGRAM, 'convert', '-', '-o', 'out.vtu', '-q'], cwd=self.dir, stdin=mesh, check=True, timeout=60)
        for command in 'check', 'render':
            self.assertIn(read[0], told[command])

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


class Memory(Case):
    @staticmethod
    def peak(*words):
        """Bytes of memory at the most, of a run of the program, as the system counts them."""
        with subprocess.Popen([PROGRAM, *map(str, words)], stdout=subprocess.DEVNULL) as run:
            _, status, usage = os.wait4(run.pid, 0)
            run.returncode = os.waitstatus_to_exitcode(status)
        return 1024 * usage.ru_maxrss if run.returncode == 0 else None

    def star(self, n):
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
        return (peaks[1] - peaks[0]) / (triangles[1] - triangles[0])

    def test_bytes_per_triangle(self):
        square = self.dir / self.write('square.poly', SQUARE)
        if self.peak('mesh', square, '-j', 1, '-o', self.dir / 'square.vtu') > 100 << 20:
            self.skipTest('a sanitizer takes memory of its own')
        small, large = [self.star(n) for n in (120000, 300000)]
        # The almond method makes hardly more triangles than there are points, which take memory, too: 448 were counted.
        self.assertLess(self.bytes_per_triangle('almond', [small, large]), 470)
        # Regions of more than 100,000 triangles are worked on in parts, which are copies: 234 were counted.
        self.assertLess(self.bytes_per_triangle('quality', [small, large]), 240)

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
        for megabytes in range(24, 200, 4):
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

    def test_hangup(self):
        """The terminal is gone: as Ctrl-C, but under nohup. So for SIGINT and jobs in the background of a script."""
        big = self.slits(300)
        for sent, ignored in (signal.SIGHUP, False), (signal.SIGHUP, True), (signal.SIGINT, True):
            before = signal.getsignal(sent)
            if ignored:
                signal.signal(sent, signal.SIG_IGN)
            try:
                run = self.start(big, '-o', 'big.vtu', '--progress', 'on')
            finally:
                signal.signal(sent, before)
            seen = b''
            while b'mesh' not in seen:
                more = os.read(run.stderr.fileno(), 4096)
                self.assertTrue(more, seen)
                seen += more
            run.send_signal(sent)
            if ignored:
                time.sleep(1.5)  # longer than an interrupt takes
                self.assertIsNone(run.poll())
                run.send_signal(signal.SIGTERM)
            run.communicate(timeout=60)
            self.assertEqual(run.returncode, 130)
            self.assertEqual(self.files(), ['big.poly'])

    def test_while_reading(self):
        folder = self.dir / 'tmp'
        folder.mkdir()
        self.write('s.poly', SQUARE)
        os.mkfifo(self.dir / 'pipe')
        before = self.files()
        for sent, *words in ((signal.SIGTERM, 'mesh', 'pipe', '-o', 'a.vtu'), (signal.SIGINT, 'info', 'pipe'),
                             (signal.SIGINT, 'mesh', 'pipe', '-o', 'a.vtu', '--dry-run'),
                             (signal.SIGTERM, 'check', 'pipe', 'a.vtu'), (signal.SIGTERM, 'check', 's.poly', 'pipe'),
                             (signal.SIGTERM, 'convert', 'pipe', '-o', 'a.vtm'), (signal.SIGTERM, 'render', 'pipe', '-o', 'a.svg')):
            with self.subTest(words=words):
                run = subprocess.Popen([PROGRAM, *words], cwd=self.dir, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                       text=True, env={**os.environ, 'TMPDIR': str(folder)})
                with open(self.dir / 'pipe', 'wb', buffering=0) as pipe:  # waits until the program reads
                    # Of a mesh more than what tells its format, so that a temporary file has it.
                    pipe.write(b'$MeshFormat\n2.2 0 8\n$EndMeshFormat\n' + b' ' * 8192)
                    run.send_signal(sent)
                    out, err = run.communicate(timeout=60)
                self.assertEqual((run.returncode, out, err), (130, '', 'cover: error: interrupted\n'))
                self.assertEqual(list(folder.iterdir()), [])
        self.assertEqual(self.files(), before)

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

    def test_while_a_page_is_drawn(self):
        folder = self.dir / 'tmp'
        folder.mkdir()
        run = self.start(self.slits(200), '--method', 'almond', '--report', 'r.html', env={**os.environ, 'TMPDIR': str(folder)})
        while not any(folder.iterdir()):
            self.assertIsNone(run.poll(), run.stderr)
        run.send_signal(signal.SIGINT)
        run.communicate(timeout=60)
        self.assertIn(run.returncode, (0, 130))
        self.assertEqual(list(folder.iterdir()), [])

    def test_when_nobody_reads(self):
        folder = self.dir / 'tmp'
        folder.mkdir()
        run = self.start(self.slits(60), '--method', 'almond', '-o', '-', env={**os.environ, 'TMPDIR': str(folder)})
        run.stdout.close()
        run.stderr.read()
        self.assertNotEqual(run.wait(timeout=60), 0)
        self.assertEqual(list(folder.iterdir()), [])


if __name__ == '__main__':
    main()
