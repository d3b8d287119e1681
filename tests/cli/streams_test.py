#!/usr/bin/env python3
"""streams_test.py PROGRAM SAMPLES [TEST...]: meshes from standard input and from pipes."""
import subprocess

from cover_case import Case, PROGRAM, SAMPLES, main

ONE_FILE = ('vtu', 'vtk', 'vtkhdf', 'msh', 'xdmf', 'mesh', 'inp')


class MeshStreams(Case):
    DEVICE = SAMPLES / 'mosfet.poly'

    def setUp(self):
        super().setUp()
        outputs = [word for extension in ONE_FILE for word in ('-o', 'd.' + extension)]
        self.run_cover('mesh', self.DEVICE, *outputs, '-q')

    def run_on(self, mesh, *words, code=0):
        """As run_cover(), with these bytes on standard input."""
        done = subprocess.run([PROGRAM, *map(str, words)], cwd=self.dir, input=mesh, timeout=60,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, code, (words, done.stdout, done.stderr))
        return done.stdout.decode(), done.stderr.decode()

    def test_every_format_of_one_file_is_known_by_how_it_begins(self):
        for extension in ONE_FILE:
            mesh = (self.dir / f'd.{extension}').read_bytes()
            told, _ = self.run_on(mesh, 'check', self.DEVICE, '-')
            self.assertIn('345 segments whole', told, extension)
            self.run_on(mesh, 'render', '-', '-o', 'x.svg')
            self.run_on(mesh, 'convert', '-', '-o', 'x.vtu', '-q')
            self.run_cover('convert', 'd.' + extension, '-o', 'y.vtu', '-q')
            self.assertEqual((self.dir / 'x.vtu').read_bytes(), (self.dir / 'y.vtu').read_bytes(), extension)
        self.assertIn('standard input: 1,046 triangles', (self.dir / 'x.svg').read_text())

    def test_a_broken_mesh_is_told_by_its_name(self):
        mesh = (self.dir / 'd.vtu').read_bytes()
        for words in (['check', self.DEVICE, '-'], ['render', '-', '-o', 'x.svg'], ['convert', '-', '-o', 'x.vtu']):
            _, told = self.run_on(mesh[:5000], *words, code=5)
            self.assertIn('standard input: ', told)
            self.assertIn('the file was cut off', told)
            for nothing in (b'', b'  \n', b'{"points": []}', b'<html>'):
                _, told = self.run_on(nothing, *words, code=5)
                self.assertIn('standard input begins as no mesh that is one file', told)
        self.assertEqual(self.files(), sorted('d.' + extension for extension in ONE_FILE))

    def test_what_is_missing_is_told_by_its_name(self):
        _, told = self.run_on((self.dir / 'd.vtu').read_bytes(), 'convert', '-', '-o', 'x.msh')
        self.assertIn('standard input holds no names of regions', told)
        self.assertIn('and neither stdin.json nor stdin.vtm is there', told)
        self.assertNotIn('/', told)

    def test_pipes_of_a_shell(self):
        subprocess.run(['bash', '-c', '"$0" check "$1" <(cat d.msh) && "$0" render <(cat d.vtu) -o x.svg',
                        PROGRAM, self.DEVICE], cwd=self.dir, check=True, timeout=60, stdout=subprocess.PIPE)
        self.assertIn('1,046 triangles', (self.dir / 'x.svg').read_text())

    def test_what_is_no_drawing_is_named(self):
        # In builds without GDAL, and with it.
        map_of = r'maps other than GeoJSON are read by GDAL, from files|{} is read from a file and not from a pipe; read from pipes are .*\.geojson'
        for begin, told in ((b'<?xml version="1.0"?>\n<kml xmlns="http://www.opengis.net/kml/2.2">', map_of.format('.kml')),
                            (b'<?xml version="1.0"?>\n<ogr:FeatureCollection>', map_of.format('.gml')),
                            (b'SQLite format 3\0', map_of.format('.gpkg')),
                            (b'fgb\x03fgb\0', map_of.format('.fgb')),
                            (b'\0\0\x27\x0a\0\0\0\0', map_of.format('.shp')),
                            (b'%SEMI-OASIS\r\n', 'OASIS is read from files, by programs that call KLayout for it'),
                            (b'<?xml version="1.0"?>\n<html></html>', 'VTK')):
            self.assertRegex(self.run_on(begin, 'info', '-', code=5)[1], told)
        self.assertIn("a .vtkhdf are drawn, checked and converted, but not meshed again; 'cover convert FILE -o FILE.msh' makes",
                      self.run_on((self.dir / 'd.vtkhdf').read_bytes(), 'info', '-', code=5)[1])

    def test_standard_input_is_read_once(self):
        _, told = self.run_cover('check', '-', '-', code=2)
        self.assertIn("standard input can be read once, so '-' names one file", told)

    def test_mesh_again_onto_a_stream(self):
        told, _ = self.run_on((self.dir / 'd.vtu').read_bytes(), 'mesh', self.DEVICE, '--onto', '-', '--only', 'material_3',
                              '-o', 'x.vtu')
        self.assertIn('Meshed again, the other 6 regions kept', told)
        self.run_cover('check', self.DEVICE, 'x.vtu')


if __name__ == '__main__':
    main()
