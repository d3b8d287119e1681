#!/usr/bin/env python3
"""mpi_test.py COVER COVER_MPI MPIRUN DATA: the files of cover-mpi are those of cover, byte for byte, for any number of
ranks; what goes wrong ends the run, and leaves nothing under the final name."""
import itertools
import json
import os
import pathlib
import random
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

COVER, COVER_MPI, MPIRUN, DATA = [pathlib.Path(a) for a in sys.argv[1:5]]
HERE = pathlib.Path(__file__).resolve().parent
# A test may run as root, on a machine with fewer cores than ranks.
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT='1', OMPI_ALLOW_RUN_AS_ROOT_CONFIRM='1',
                   OMPI_MCA_rmaps_base_oversubscribe='1')


KILLS = int(os.environ.get('COVER_KILLS', 4))  # for each format


def on_ranks(ranks, *arguments):
    return [str(a) for a in (MPIRUN, '-n', ranks, COVER_MPI, *arguments)]


def end_of(process, seconds=60):
    """What a run has printed, and whether it ended by itself. Now and then Open MPI's mpiexec waits for a lock of its own
    after its ranks are gone (PMIx_server_finalize): it is killed then. A rank that is still there hangs, which is ours."""
    try:
        return *process.communicate(timeout=seconds), True
    except subprocess.TimeoutExpired:
        ranks = processes_with([str(COVER_MPI)])
        process.kill()
        if ranks:
            for rank in ranks:
                os.kill(rank, signal.SIGKILL)
            raise
        print('mpiexec waits for itself, without ranks:', shlex.join(process.args), file=sys.stderr)
        return *process.communicate(), False


def run(command):
    command = [str(c) for c in command]
    for _ in range(2):
        with subprocess.Popen(command, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
            out, err, has_ended = end_of(process, 100)
        if has_ended:
            break
    return subprocess.CompletedProcess(command, process.returncode, out, err)


def grid_poly(cells):
    """A drawing of cells x cells squares whose corners are moved a little."""
    n = cells + 1
    points = [(x + 0.2 * ((x * 7 + y * 3) % 5) / 5, y + 0.2 * ((x * 5 + y * 11) % 7) / 7) for y in range(n) for x in range(n)]
    segments = [(y * n + x, y * n + x + 1) for y in range(n) for x in range(cells)]
    segments += [(y * n + x, (y + 1) * n + x) for y in range(cells) for x in range(n)]
    lines = [f'{len(points)} 2 0 0', *(f'{i} {x} {y}' for i, (x, y) in enumerate(points)), f'{len(segments)} 0',
             *(f'{i} {a} {b}' for i, (a, b) in enumerate(segments)), '0']
    return '\n'.join(lines) + '\n'


def layout_poly(cells):
    """A drawing of cells x cells regions of some 50 triangles each."""
    made = subprocess.run([sys.executable, HERE.parent / 'bench/inputs/layout.py', str(cells)], capture_output=True, text=True, check=True)
    return made.stdout


def processes_with(words):
    """Ids of the processes whose command begins with these words."""
    found = []
    for line in pathlib.Path('/proc').glob('[0-9]*/cmdline'):
        try:
            if line.read_text().split('\0')[:len(words)] == words:
                found.append(int(line.parent.name))
        except OSError:  # it has ended meanwhile
            pass
    return found


class CoverMpi(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def same(self, geometry, *options, ranks=(1, 2, 3, 7), form='vtu'):
        alone = self.folder / f'alone.{form}'
        done = run([COVER, 'mesh', geometry, '-o', alone, '-q', *options])
        self.assertEqual(done.returncode, 0, done.stderr)
        for n in ranks:
            together = self.folder / f'ranks_{n}.{form}'
            done = run(on_ranks(n, 'mesh', geometry, '-o', together, '-q', *options))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(together.read_bytes(), alone.read_bytes(), f'{n} ranks, {options}')

    def test_same_bytes(self):
        self.same(DATA / 'mosfet.poly')
        drawing = self.folder / 'grid.poly'
        drawing.write_text(grid_poly(12))
        self.same(drawing, '--size', '0.2')

    def test_same_bytes_where_meshes_stay_with_their_ranks(self):
        """All ranks write the file; options that need whole meshes or one writer have their way."""
        drawing = self.folder / 'layout.poly'
        drawing.write_text(layout_poly(12))
        self.same(drawing, '--stream', 'on', form='vtkhdf')
        self.same(DATA / 'mosfet.poly', '--stream', 'on', '-j', '2', form='vtkhdf')
        self.same(drawing, '--stream', 'on', '-o', self.folder / 'beside.msh', ranks=(3,), form='vtkhdf')
        self.same(drawing, '--stream', 'on', '-o', self.folder / 'second.vtkhdf', ranks=(3,), form='vtkhdf')
        self.assertEqual((self.folder / 'second.vtkhdf').read_bytes(), (self.folder / 'alone.vtkhdf').read_bytes())
        report = self.folder / 'report.json'
        self.same(drawing, '--stream', 'on', '--report', report, ranks=(2,), form='vtkhdf')
        self.assertEqual(len(json.loads(report.read_text())['regions']), 144)
        self.assertEqual([p.name for p in self.folder.iterdir() if p.name.startswith('.')], [])

    def test_several_inputs(self):
        tiles = []
        for k in range(3):
            square = [[k, 0], [k + 1, 0], [k + 1, 1], [k, 1], [k, 0]]
            tiles.append(self.folder / f'tile_{k}.geojson')
            tiles[k].write_text(json.dumps({'type': 'FeatureCollection', 'features': [
                {'type': 'Feature', 'properties': {'name': f'tile {k}'}, 'geometry': {'type': 'Polygon', 'coordinates': [square]}}]}))
        alone, together = self.folder / 'alone.vtkhdf', self.folder / 'together.vtkhdf'
        mesh = ('mesh', *tiles, '--stream', 'on')
        done = run([COVER, *mesh, '-o', alone])
        self.assertIn('3 regions', done.stdout)
        for ranks in (1, 2, 3, 7):
            done = run(on_ranks(ranks, *mesh, '-o', together))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(together.read_bytes(), alone.read_bytes(), ranks)
        if shutil.which('strace'):
            self.assertEqual(self.readers(2, *mesh, '-o', together), 2)
        done = run(on_ranks(2, 'mesh', tiles[0], self.folder / 'none.geojson', '-o', self.folder / 'x.vtkhdf'))
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertIn('none.geojson', done.stderr)
        # The other rank sees none of them; rank 0 does.
        elsewhere = [MPIRUN, '-n', '1', '-wdir', self.folder, COVER_MPI, 'mesh', *(t.name for t in tiles), '-o', 'here.vtkhdf',
                     ':', '-n', '1', '-wdir', '/', COVER_MPI, 'mesh', 'x']
        done = run(elsewhere)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn('3 regions', done.stdout)

    def readers(self, ranks, *arguments):
        """How many processes open tiles, as strace sees it."""
        trace = self.folder / 'trace'
        watched = ['strace', '-f', '-qq', '-e', 'trace=openat', '-o', trace, *on_ranks(ranks, *arguments)]
        self.assertEqual(run(watched).returncode, 0)
        return len({line.split()[0] for line in trace.read_text().splitlines() if 'tile_' in line and 'O_RDONLY' in line})

    def test_tells_of_cores_that_are_not_used(self):
        if len(os.sched_getaffinity(0)) < 2:
            self.skipTest('there is one core')
        mesh = ('mesh', DATA / 'diode.poly', '-o', self.folder / 'x.vtu')
        for bind, told in (('core', True), ('none', False)):
            done = run([MPIRUN, '-n', 1, '--bind-to', bind, COVER_MPI, *mesh])
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual('--bind-to none' in done.stderr, told, done.stderr)

    def on_two(self, second, *arguments):
        """Rank 0 as it is; rank 1 in a shell, after the commands `second`."""
        words = [str(a) for a in (COVER_MPI, *arguments)]
        script = f'{second}; exec {shlex.join(words)}'
        return [str(MPIRUN), '-n', '1', *words, ':', '-n', '1', 'sh', '-c', script]

    def test_a_rank_that_cannot_write(self):
        drawing, target = self.folder / 'layout.poly', self.folder / 'x.vtkhdf'
        drawing.write_text(layout_poly(60))
        target.write_text('old')
        done = run(self.on_two('trap "" XFSZ; ulimit -f 10000', 'mesh', drawing, '-o', target, '--stream', 'on'))
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertRegex(done.stderr, r'rank 1: cannot write .*x\.vtkhdf: File too large')
        self.assertEqual(target.read_text(), 'old')
        self.assertEqual([p.name for p in self.folder.iterdir() if p.name.startswith('.')], [])

    def test_ranks_that_do_not_share_the_folder(self):
        """Meshes travel then."""
        drawing, target, alone = (self.folder / name for name in ('layout.poly', 'x.vtkhdf', 'alone.vtkhdf'))
        drawing.write_text(layout_poly(10))
        hide = f'mount -t tmpfs none {shlex.quote(str(self.folder))}'
        if subprocess.run(['unshare', '-m', 'sh', '-c', hide], capture_output=True, check=False).returncode != 0:
            self.skipTest('nothing can be mounted here')
        mesh = ('mesh', drawing, '-q', '--stream', 'on')
        self.assertEqual(run([COVER, *mesh, '-o', alone]).returncode, 0)
        words = shlex.join([str(a) for a in (COVER_MPI, *mesh, '-o', target)])
        second = f'exec unshare -m sh -c {shlex.quote(f"{hide} && exec {words}")}'
        done = run(self.on_two(second, *mesh, '-o', target))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(target.read_bytes(), alone.read_bytes())

    def test_same_bytes_with_options(self):
        self.same(DATA / 'diode.poly', '--method', 'almond', ranks=(2,), form='msh')
        self.same(DATA / 'mosfet.poly', '--split-interfaces', '--max-angle', '90', ranks=(3,))
        field = self.folder / 'field.vtk'
        field.write_text('# vtk DataFile Version 3.0\nfield\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 1\n'
                         'ORIGIN 0 0 0\nSPACING 13 13 1\nPOINT_DATA 4\nSCALARS size double 1\nLOOKUP_TABLE default\n'
                         '0.3 0.4 0.5 0.6\n')
        drawing = self.folder / 'grid.poly'
        drawing.write_text(grid_poly(4))
        self.same(drawing, '--size-field', field, ranks=(2, 3))

    def test_errors_of_geometry_and_of_use(self):
        bad = self.folder / 'bad.poly'
        bad.write_text('3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n1 0\n0 0 1\n0\n')
        done = run(on_ranks(2, 'mesh', bad, '-o', self.folder / 'x.vtu'))
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn('enclose nothing', done.stderr)
        done = run(on_ranks(2, 'mesh', bad, '-o', self.folder / 'x.vtu', '--max-angle', '20'))
        self.assertEqual(done.returncode, 2, done.stderr)
        done = run(on_ranks(2, 'check', bad))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("'check' is no command of cover-mpi", done.stderr)
        self.assertEqual([p.name for p in self.folder.iterdir()], ['bad.poly'])

    def test_help(self):
        done = run(on_ranks(2, '--help'))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn('mpirun -n 4 cover-mpi mesh', done.stdout)

    def test_a_rank_that_is_killed_ends_the_run(self):
        drawing = self.folder / 'grid.poly'
        drawing.write_text(grid_poly(30))
        target = self.folder / 'x.vtu'
        target.write_text('old')
        with subprocess.Popen(on_ranks(2, 'mesh', drawing, '-o', target, '-q', '--split-interfaces', '--size', '0.02'), env=ENVIRONMENT,
                              stderr=subprocess.PIPE, text=True) as process:
            ranks = []
            while len(ranks) < 2 and process.poll() is None:
                ranks = processes_with([str(COVER_MPI), 'mesh', str(drawing)])
                time.sleep(0.05)
            time.sleep(0.5)
            os.kill(max(ranks), signal.SIGKILL)
            _, told, _ = end_of(process)
        self.assertNotEqual(process.returncode, 0)
        self.assertRegex(told, r'rank \d')
        self.assertEqual(target.read_text(), 'old')

    def test_an_interrupt_while_klayout_reads_leaves_nothing(self):
        """Of one file, which rank 0 reads, and of two, which two ranks read. A script stands for KLayout. mpirun kills its
        ranks, so it may end before the folders are gone."""
        tools, temporary = self.folder / 'bin', self.folder / 'tmp'
        tools.mkdir()
        temporary.mkdir()
        (tools / 'strm2gds').write_text('#!/bin/sh\n: >"$2"\nexec /bin/sleep 50\n')
        (tools / 'strm2gds').chmod(0o755)
        layouts = [self.folder / name for name in ('a.oas', 'b.oas')]
        for layout in layouts:
            layout.write_text('%SEMI-OASIS')
        there = dict(ENVIRONMENT, PATH=f'{tools}:{ENVIRONMENT["PATH"]}', TMPDIR=str(temporary))
        for files, one in itertools.product((layouts[:1], layouts), (signal.SIGINT, signal.SIGTERM)):
            mesh = ('mesh', *files, '-o', self.folder / 'x.vtu')
            with subprocess.Popen(on_ranks(3, *mesh), env=there, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
                while len(list(temporary.glob('.cover-oasis.*/layout.gds'))) < len(files):
                    self.assertIsNone(process.poll(), 'it ended before KLayout began')
                    time.sleep(0.01)
                process.send_signal(one)
                end_of(process)
            self.assertNotEqual(process.returncode, 0)
            for _ in range(200):
                if not list(temporary.glob('.cover-*')):
                    break
                time.sleep(0.1)
            self.assertEqual(list(temporary.glob('.cover-*')), [], one)
            self.assertFalse((self.folder / 'x.vtu').exists())

    def test_ranks_killed_at_any_moment(self):
        """An error, no hang, and the old file or the new one; the next run leaves nothing else."""
        drawing = self.folder / 'layout.poly'
        drawing.write_text(layout_poly(40))
        for form, stream in (('vtu', 'off'), ('vtkhdf', 'off'), ('vtkhdf', 'on')):
            target = self.folder / f'x.{form}'
            mesh = ('mesh', drawing, '-o', target, '-q', '--stream', stream)
            start = time.monotonic()
            self.assertEqual(run(on_ranks(3, *mesh)).returncode, 0)
            took = time.monotonic() - start
            new, dice, killed = target.read_bytes(), random.Random(form + stream), 0
            for k in range(KILLS):
                target.write_text('old')
                killed += self.kill_one(on_ranks(3, *mesh), drawing, k % 3, dice.uniform(0, took))
                self.assertTrue(target.read_bytes() in (b'old', new), form)
            self.assertGreater(killed, 0)
            self.assertEqual(run(on_ranks(3, *mesh)).returncode, 0)
            self.assertTrue(target.read_bytes() == new, form)
            self.assertEqual([p.name for p in self.folder.iterdir() if p.name.startswith('.')], [])

    def kill_one(self, command, drawing, which, moment):
        """Kills one of the ranks, in the order of their ids; whether that was in time."""
        with subprocess.Popen(command, env=ENVIRONMENT, stderr=subprocess.PIPE, text=True) as process:
            ranks = []
            while len(ranks) < 3 and process.poll() is None:
                ranks = processes_with([str(COVER_MPI), 'mesh', str(drawing)])
                time.sleep(0.01)
            time.sleep(moment)
            try:
                os.kill(sorted(ranks)[which], signal.SIGKILL)
            except (IndexError, ProcessLookupError):  # it has ended
                pass
            _, told, _ = end_of(process)
        if process.returncode == 0:
            return 0
        self.assertRegex(told, r'rank \d')
        return 1


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
