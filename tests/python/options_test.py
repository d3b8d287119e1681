#!/usr/bin/env python3
"""options_test.py PROGRAM ROOT: every option of the table is an option of the program, a key of job files, a keyword of
Python, a line of provenance, help, manual and completion, everywhere with the same name, values and range."""
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import cover

PROGRAM, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
# Two materials, one above the other, and a contact.
GEOMETRY = {'polygons': [{'material': 'Si', 'rings': [[[0, 0], [4, 0], [4, 2], [0, 2]]]},
                         {'material': 'SiO2', 'rings': [[[0, 2], [4, 2], [4, 3], [0, 3]]]}],
            'lines': [{'name': 'anode', 'points': [[0, 0], [4, 0]]}, {'name': 'left', 'points': [[0, 0], [0, 2], [0, 3]]},
                      {'name': 'right', 'points': [[4, 0], [4, 2], [4, 3]]}]}
TABLE = cover.options()
READ_TABLE = cover.read_options()
WRITE_TABLE = cover.write_options()
# Background sizes of 1 everywhere.
FIELD = '''# vtk DataFile Version 3.0
sizes
ASCII
DATASET POLYDATA
POINTS 3 double
-100 -100 0 100 -100 0 0 100 0
POLYGONS 1 4
3 0 1 2
POINT_DATA 3
SCALARS size double 1
LOOKUP_TABLE default
1 1 1
'''
# What else must be given.
NEEDS = {'pieces': {'paper': True}, 'size-of': {'size_field': 'field.vtk'},
         'size-step': {'size_of': 'asinh', 'size_field': 'field.vtk'}}
TEXTS = {'size': ['SiO2=0.5', '1'], 'size-at': ['anode=0.25'], 'layers': ['anode=0.25,1.5,2'], 'size-field': ['field.vtk'], 'size-of': ['asinh', '2*size+x'], 'weld': ['off', 'auto', '1e-06'],
         'periodic': ['left=right', 'left=right@mirror']}


def values(row):
    """Legal values, as texts."""
    if row['kind'] == 'flag':
        return ['true']
    if row['words']:
        return row['words']
    if row['kind'] in ('whole', 'number', 'angle'):
        high = row['high'] if math.isfinite(row['high']) else row['low'] + 5
        return [f'{(row["low"] + high) / 2:.0f}', f'{row["low"] + 1 if row["kind"] == "whole" else row["low"] + 0.5:g}']
    return TEXTS[row['name']]


def beyond(row):
    """Numbers that the option must not take."""
    if row['kind'] not in ('whole', 'number', 'angle'):
        return []
    limits = [(row['low'], row['has_low'], -1), (row['high'], row['has_high'], 1)]
    return [limit + (step if legal else 0) for limit, legal, step in limits if math.isfinite(limit)]


def as_flags(needed):
    """The options that another one needs, as words and as lines of a job file."""
    names = {key.replace('_', '-'): value for key, value in needed.items()}
    return ([f'--{name}' if value is True else f'--{name}={value}' for name, value in names.items()],
            ''.join(f'{name}=true\n' if value is True else f'{name}="{value}"\n' for name, value in names.items()))


def python_value(row, text):
    if row['kind'] == 'flag':
        return text == 'true'
    if row['kind'] == 'whole':
        return int(text)
    try:
        return float(text)
    except ValueError:
        return text


class Options(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.dir = pathlib.Path(folder.name)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.dir)
        (self.dir / 'field.vtk').write_text(FIELD)
        self.device = self.dir / 'device.json'
        self.device.write_text(json.dumps(GEOMETRY))

    def run_cover(self, *words, code=0):
        done = subprocess.run([PROGRAM, *map(str, words)], cwd=self.dir, text=True, timeout=100, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, code, f'{words}\n{done.stdout}\n{done.stderr}')
        return done.stdout, done.stderr

    def test_documents(self):
        command, manual = self.run_cover('mesh', '--help')[0], (ROOT / 'apps/cover/cover.1').read_text()
        printed = self.run_cover('mesh', '--print-config')[0]
        completion = (ROOT / 'apps/cover/completion.bash').read_text()
        for row in TABLE:
            with self.subTest(row['name']):
                self.assertRegex(command, rf'(?m)^  (-\w,)?--{row["name"]} ')
                self.assertRegex(printed, rf'(?m)^# {row["name"]}=')
                self.assertIn(f'\\-\\-{row["name"]}'.replace('-', '\\-').replace('\\\\', '\\'), manual)
                if row['words']:
                    self.assertIn(f'--{row["name"]}) words="{" ".join(row["words"])}"', completion)

    def test_default(self):
        printed = self.run_cover('mesh', '--print-config')[0]
        for row in TABLE:
            with self.subTest(row['name']):
                if row['default'] and row['kind'] != 'flag':
                    self.assertRegex(printed, rf'(?m)^# {row["name"]}="?{row["default"]}"?$')
                    keywords = {row['name'].replace('-', '_'): python_value(row, row['default'])}
                    made = cover.mesh_file(self.device, **keywords, **NEEDS.get(row['name'], {}))
                    needed = NEEDS.get(row['name'], {})
                    implied = 'implies --method almond' in row['help'] or 'paper' in needed
                    self.assertEqual({k: v for k, v in made.report['options'].items() if k.replace('-', '_') not in needed},
                                     {'method': 'almond' if implied else 'quality'})

    def test_the_same_everywhere(self):
        for row in TABLE:
            with self.subTest(row['name']):
                name, key = row['name'], row['name'].replace('-', '_')
                more = NEEDS.get(name, {})
                for text in values(row):
                    keywords = {key: python_value(row, text)} | more
                    made = cover.mesh_file(self.device, **keywords) if name != 'size-field' else \
                        cover.mesh_file(self.device, size_field=self.dir / 'field.vtk')
                    flag = [f'--{name}'] if row['kind'] == 'flag' else [f'--{name}', text]
                    told = []
                    words_of_more, lines_of_more = as_flags(more)
                    (self.dir / 'job.toml').write_text(lines_of_more + (
                        f'{name}={text}\n' if row['kind'] == 'flag' else f'{name}="{text}"\n'))
                    for words in ([*flag, *words_of_more], ['--config', 'job.toml']):
                        # A requirement may be missed.
                        done = subprocess.run([PROGRAM, 'mesh', 'device.json', '-q', '--report', 'r.json', *words], cwd=self.dir,
                                              timeout=100, text=True, stderr=subprocess.PIPE)
                        self.assertIn(done.returncode, (0, 6) if name == 'require' else (0,), f'{words} {done.stderr}')
                        told.append(json.loads((self.dir / 'r.json').read_text()))
                    self.assertEqual(told[0]['options'], told[1]['options'], text)
                    self.assertEqual(told[0]['overall'], told[1]['overall'], text)
                    mine = made.report
                    if name == 'size-field':
                        self.assertEqual(pathlib.Path(mine['options'].pop(name)).name, told[0]['options'].pop(name))
                    self.assertEqual(mine['options'], told[0]['options'], text)
                    self.assertEqual(mine['overall'], told[0]['overall'], text)
                    is_default = text in row['default'].split(',')
                    shown = name in mine['options'] or name == 'size-field'
                    self.assertEqual(shown, name == 'method' or (row['shapes_mesh'] and not is_default), text)

    def test_ranges(self):
        for row in TABLE:
            with self.subTest(row['name']):
                name = row['name']
                more = NEEDS.get(name, {})
                for number in beyond(row):
                    text = f'{number:g}'
                    (self.dir / 'job.toml').write_text(f'{name}={text}\n')
                    flags = as_flags(more)[0]
                    errors = [self.run_cover('mesh', 'device.json', '-o', 'd.vtu', *words, *flags, code=2)[1].split('\n')[0]
                              for words in ([f'--{name}={text}'], ['--config', 'job.toml'])]
                    self.assertEqual(errors[0], errors[1])
                    with self.assertRaises(cover.OptionError) as caught:
                        cover.mesh_file(self.device, **{name.replace('-', '_'): number}, **more)
                    reason = errors[0].split(f'--{name}: ')[1].split(';')[0]
                    self.assertIn(reason.split(' is not ')[1], str(caught.exception))

    def test_words(self):
        for row in TABLE:
            with self.subTest(row['name']):
                if not row['words']:
                    continue
                error = self.run_cover('mesh', 'device.json', '-o', 'd.vtu', f'--{row["name"]}', 'x', code=2)[1]
                reason = f"'x' is not one of {', '.join(row['words'])}"
                self.assertIn(f'--{row["name"]}: {reason}', error)
                with self.assertRaises(cover.OptionError) as caught:
                    cover.mesh_file(self.device, **{row['name'].replace('-', '_'): 'x'})
                self.assertEqual(str(caught.exception), f"{row['name'].replace('-', '_')}: {reason}")


class Reading(Options):
    """The options of reading: the same in the program, in job files and in Python."""
    VALUES = {'unit': ['mm'], 'scale': ['25.4'], 'input-format': ['gds'], 'layer': ['1', 'L2D0'], 'layer-map': ['1/0=fin', 'a.map'],
              'label-layer': ['1'], 'cell': ['TT'], 'window': ['-0.5,-0.25,0.75,1'], 'chord-error': ['0.001'], 'chord-angle': ['30'], 'material-field': ['landuse'], 'name-field': ['nr'],
              'priority-field': ['rank'], 'keep-field': ['landuse', 'fid'], 'crs': ['EPSG:25832'], 'speckle': ['4'],
              'no-smooth': ['true'], 'legend': ['legend.csv']}
    # A layout that is cut to what the options leave of it.
    LAYOUT = ROOT / 'tests/fuzz/seeds/gds/all.gds'

    def setUp(self):
        super().setUp()
        (self.dir / 'a.map').write_text('2=oxide\n3/1=metal # a path\n')
        self.device = self.dir / 'device.gds'
        self.device.write_bytes(self.LAYOUT.read_bytes())

    def test_documents(self):
        manual = (ROOT / 'apps/cover/cover.1').read_text().replace('\\-', '-')
        for command in 'mesh', 'info', 'check':
            told = self.run_cover(command, '--help')[0]
            for row in READ_TABLE:
                self.assertIn(f'--{row["name"]} ', told)
                self.assertIn(f'--{row["name"]}', manual)

    def test_default(self):
        printed = self.run_cover('mesh', '--print-config')[0]
        for row in READ_TABLE:
            self.assertRegex(printed, rf'(?m)^# {row["name"]}=.*{row["default"]}')

    def test_the_same_everywhere(self):
        self.assertEqual(set(self.VALUES), {row['name'] for row in READ_TABLE})
        for row in READ_TABLE:
            name, texts = row['name'], self.VALUES[row['name']]
            with self.subTest(name):
                value = [{'number': float, 'flag': lambda text: text == 'true'}.get(row['kind'], str)(text) for text in texts]
                paths = [self.dir / v if v == 'a.map' else v for v in value] if row['repeats'] else value[0]
                made = cover.mesh_file(self.device, **{name.replace('-', '_'): paths}).report
                quoted = ', '.join(f'"{text}"' for text in texts)
                if row['kind'] == 'flag':
                    quoted = texts[0]
                (self.dir / 'job.toml').write_text(f'{name}=[{quoted}]\n' if row['repeats'] else f'{name}={quoted}\n')
                flags = [f'--{name}'] if row['kind'] == 'flag' else [word for text in texts for word in (f'--{name}', text)]
                for words in (flags, ['--config', 'job.toml']):
                    self.run_cover('mesh', 'device.gds', '-q', '--report', 'r.json', *words)
                    told = json.loads((self.dir / 'r.json').read_text())
                    for key in 'overall', 'unit', 'scale':
                        self.assertEqual(told.get(key), made.get(key), key)
                    self.assertEqual(str(told['options'].get(name)).replace('a.map', ''),
                                     str(made['options'].get(name)).replace(str(self.dir / 'a.map'), ''))
                    self.assertEqual(name in told['options'], name not in ('unit', 'scale'))

    def test_ranges(self):
        for row in READ_TABLE:
            for number in beyond(row):
                error = self.run_cover('mesh', 'device.gds', '-o', 'd.vtu', f'--{row["name"]}={number:g}', code=2)[1]
                with self.assertRaises(cover.OptionError) as caught:
                    cover.mesh_file(self.device, **{row['name'].replace('-', '_'): number})
                self.assertIn(str(caught.exception).split(' is not ')[1], error)

    def test_words(self):
        with self.assertRaises(cover.OptionError):
            cover.mesh_file(self.device, unit='km')
        with self.assertRaisesRegex(cover.OptionError, "did you mean 'layers'"):
            cover.mesh_file(self.device, layerz='1')
        with self.assertRaisesRegex(cover.OptionError, 'it counts where files are read'):
            cover.mesh([(0, 0), (1, 0), (0, 1)], [(0, 1), (1, 2), (2, 0)], layer='1')
        self.assertIn('no.map', self.run_cover('mesh', 'device.gds', '-o', 'd.vtu', '--layer-map', 'no.map', code=5)[1])

    def test_windows_in_every_form(self):
        made = [cover.mesh_file(self.device, window=form).report['options']['window']
                for form in ('0,0,0.5,0.5', (0, 0, 0.5, 0.5), [0, 0, '0.5', 0.5])]
        self.assertEqual(made, ['0,0,0.5,0.5'] * 3)


class Writing(Options):
    """Options that say what a file holds: of the program's commands that write meshes, and of Mesh.save()."""

    # A format in which each counts, and a value.
    VALUES = {'order': ('.msh', '2'), 'msh': ('.msh', '4.1'), 'xdmf': ('.xdmf', 'hdf5'), 'parts': ('.pvtu', '2'),
              'no-inner-lines': ('.msh', 'true'), 'lines': ('.vtk', 'true'), 'ids': ('.ele', 'region'),
              'inp-element': ('.inp', 'CAX')}

    def setUp(self):
        super().setUp()
        (self.dir / 'd.json').write_text(json.dumps(GEOMETRY))

    def files(self, name):
        """What a run has written as NAME, by the names of files without NAME; NAME is gone afterwards."""
        found = {}
        for path in sorted(p for p in self.dir.rglob('*') if p.is_file() and p.relative_to(self.dir).parts[0].startswith(f'{name}.')):
            found[str(path.relative_to(self.dir)).replace(name, '')] = path.read_bytes().replace(name.encode(), b'')
            path.unlink()
        return found

    def test_documents(self):
        manual = (ROOT / 'apps/cover/cover.1').read_text().replace('\\-', '-')
        for command in 'mesh', 'convert':
            told = self.run_cover(command, '--help')[0]
            for row in WRITE_TABLE:
                self.assertRegex(told, rf'--{row["name"]}\b')
                self.assertIn(f'--{row["name"]}', manual)

    def test_default(self):
        printed = self.run_cover('mesh', '--print-config')[0]
        for row in WRITE_TABLE:
            self.assertRegex(printed, rf'(?m)^# {row["name"]}=.*{row["default"]}')

    def test_the_same_everywhere(self):
        self.assertEqual(set(self.VALUES), {row['name'] for row in WRITE_TABLE})
        mesh = cover.mesh_file(self.dir / 'd.json')
        for row in WRITE_TABLE:
            name, (extension, text) = row['name'], self.VALUES[row['name']]
            with self.subTest(name):
                self.run_cover('mesh', 'd.json', '-q', '-o', f'plain{extension}')
                plain = self.files('plain')
                flag = row['kind'] == 'flag'
                self.run_cover('mesh', 'd.json', '-q', '-o', f'flags{extension}', f'--{name}' if flag else f'--{name}={text}')
                flags = self.files('flags')
                self.assertNotEqual(plain, flags)
                (self.dir / 'settings.toml').write_text(f'{name}={text}\n' if flag else f'{name}="{text}"\n')
                self.run_cover('mesh', 'd.json', '-q', '-o', f'job{extension}', '--config', 'settings.toml')
                self.assertEqual(flags, self.files('job'))
                mesh.save(self.dir / f'python{extension}', **{name.replace('-', '_'): python_value(row, text)})
                self.assertEqual(sorted(flags), sorted(self.files('python')))

    def test_ranges(self):
        mesh = cover.mesh_file(self.dir / 'd.json')
        for row in WRITE_TABLE:
            for value in beyond(row) + ([] if not row['words'] else ['nothing']):
                error = self.run_cover('mesh', 'd.json', '-o', 'd.msh', f'--{row["name"]}={value}', code=2)[1]
                with self.assertRaises(cover.OptionError) as caught:
                    mesh.save(self.dir / 'd.msh', **{row['name'].replace('-', '_'): value})
                self.assertIn(str(caught.exception).split(': ')[1], error)

    def test_words(self):
        mesh = cover.mesh_file(self.dir / 'd.json')
        for keywords in dict(order='two'), dict(lines=3):
            with self.assertRaises((cover.OptionError, TypeError)):
                mesh.save(self.dir / 'd.msh', **keywords)
        with self.assertRaises(cover.OptionError):
            mesh.save(self.dir / 'd.msh', method='almond')


class Keywords(unittest.TestCase):
    RING = [(0, 1), (1, 2), (2, 3), (3, 0)]

    def settings(self, **options):
        return cover.mesh([(0, 0), (1, 0), (1, 1), (0, 1)], self.RING, **options).report['options']

    def test_none_leaves_an_option_out(self):
        for row in TABLE:
            self.assertEqual(self.settings(**{row['name'].replace('-', '_'): None}), {'method': 'quality'})

    def test_sizes_in_every_form(self):
        for form in (0.5, '0.5', ['0.5'], [0.5], {'': 0.5}, {'': '0.5'}):
            for key in ('size', 'sizes'):
                self.assertEqual(self.settings(**{key: form})['size'], '0.5')

    def test_opposites(self):
        self.assertEqual(self.settings(input_sizes=False), {'method': 'quality', 'no-input-sizes': 'true'})
        self.assertEqual(self.settings(input_sizes=True), {'method': 'quality'})
        self.assertEqual(self.settings(split_interfaces=True)['split-interfaces'], '90')
        self.assertEqual(self.settings(split_interfaces=False), {'method': 'quality'})

    def test_numbers_of_numpy(self):
        import numpy as np
        self.assertEqual(self.settings(max_angle=np.float64(110.5), threads=np.int64(1))['max-angle'], '110.5')
        self.assertEqual(self.settings(max_angle=np.float32(110.5))['max-angle'], '110.5')

    def test_errors_in_words(self):
        for options, kind, message in (
                (dict(threads=-1), cover.OptionError, 'threads: -1 is not at least 0 and at most 4096'),
                (dict(threads=1.5), cover.OptionError, 'threads: 1.5 is not a whole number'),
                (dict(strict='yes'), cover.OptionError, "strict: 'yes' is not True or False"),
                (dict(max_angle=True), cover.OptionError, 'max_angle: True is not a number of degrees'),
                (dict(max_angle=[1]), TypeError, 'max_angle: [1] is not a number of degrees'),
                (dict(max_angle={'a': 1}), TypeError, "max_angle: {'a': 1} is not a number of degrees"),
                (dict(max_angle=1j), TypeError, 'max_angle: 1j is not a number of degrees'),
                (dict(growth=math.nan), cover.OptionError, 'growth: nan is not above 1'),
                (dict(require=['bound', 'bond']), cover.OptionError,
                 "require: 'bond' is not one of bound, max-angle, delaunay, non-obtuse, box-method; did you mean 'bound'?"),
                (dict(sizes={'a': 0}), cover.OptionError, "sizes: 'a=0' is not h or NAME=h with a length h above 0"),
                (dict(size_at=0.1), cover.OptionError, "size_at: '0.1' is not NAME=h with a length h above 0"),
                (dict(pieces=3), cover.OptionError, 'pieces needs paper'),
                (dict(order=2), cover.OptionError, "unexpected option 'order': it is an option of save()"),
                ({'max-angle': 120}, cover.OptionError, "unexpected option 'max-angle'; did you mean 'max_angle'?"),
                (dict(max_angel=120), cover.OptionError, "unexpected option 'max_angel'; did you mean 'max_angle'?")):
            with self.assertRaises(kind) as caught:
                self.settings(**options)
            self.assertIn(message, str(caught.exception), options)
        self.assertEqual(cover.OptionError.__mro__[1:4], (cover.Error, ValueError, TypeError))


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
