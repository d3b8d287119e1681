"""What tests of the program have in common: it, a folder for each of them, and a square."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SAMPLES = sys.argv[1], pathlib.Path(sys.argv[2])
APP = SAMPLES.parent.parent / 'apps/cover'

SQUARE = '4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n'


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.dir = pathlib.Path(folder.name)

    def run_cover(self, *words, code=0, stdin=None):
        """Runs the program in the folder of this test; returns stdout and stderr."""
        done = subprocess.run([PROGRAM, *map(str, words)], cwd=self.dir, input=stdin, text=True, timeout=60,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, code, f'{words}\n{done.stdout}\n{done.stderr}')
        return done.stdout, done.stderr

    def write(self, name, text):
        (self.dir / name).write_text(text)
        return name

    def files(self):
        return sorted(p.name for p in self.dir.iterdir())


def main():
    """Runs the classes of the file that is run, or those named on the command line."""
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=1)
