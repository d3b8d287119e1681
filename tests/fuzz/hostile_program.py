#!/usr/bin/env python3
"""hostile_program.py HOSTILE_RUNS COVER FIRST COUNT [--witness VERIFY.py] [--every N] [--seconds S]

The seeds of hostile_runs through the program: each input is written as JSON and meshed with its options, `cover check`
judges what was written, against the drawing as it was cleaned and cut and against the input, and every N-th mesh (10)
is judged by VERIFY.py INPUT.poly MESH.vtu too (by the same Python), a checker that shares nothing with cover. Names
the seeds that crash, whose mesh is refused, or that take longer than S seconds (20) of the processor; exit 1 if there
is one."""
import argparse
import collections
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
from timed_run import run  # noqa: E402  (after the path)

REFUSED = {2: 'cannot be done by the method', 3: 'geometry', 4: 'bound missed', 7: 'memory'}


class Runs:
    def __init__(self, arguments):
        self.asked = arguments
        self.outcomes = collections.Counter()
        self.faults = 0
        self.slowest = (0, None)

    def fault(self, seed, what, text=''):
        self.faults += 1
        print(f'seed {seed}: {what}\n{text[:600]}', flush=True)

    def judge(self, seed, folder, options, said):
        """Every check on the mesh in `folder`, of whose run was `said`."""
        mesh, clean, source = folder / 'm.vtu', folder / 'clean.poly', folder / 'in.json'
        bound = ['--no-bound'] if '--paper' in options else []
        hull = ['--hull'] if '--hull' in options else []
        cleaning = []
        for name in ('--weld', '--overlap'):
            if name in options:
                cleaning += [name, options[options.index(name) + 1]]
        cleaning += [name for name in ('--merge-materials', '--strict') if name in options]
        drawings = [[source, mesh, *cleaning]]
        # Cuts on the outline, rounded, make another hull of the cleaned drawing.
        has_other_hull = hull and '--split-interfaces' in options
        says_all = not has_other_hull and 'a seed in a .poly cannot name it' not in said
        if says_all:
            drawings.append([clean, mesh, '--weld', '0'])
        for words in drawings:
            code, text, _ = run([self.asked.cover, 'check', *words, *bound, *hull], self.asked.limit)
            if code != 0:
                self.fault(seed, f'check exits with {code}: {" ".join(map(str, words))} of {" ".join(options)}', text)
        if self.asked.witness and seed % self.asked.every == 0 and says_all and not hull:
            code, text, _ = run([sys.executable, self.asked.witness, clean, mesh, *bound], 10 * self.asked.limit)
            self.outcomes['by the witness'] += 1
            if code != 0:
                self.fault(seed, f'the witness exits with {code}, options {" ".join(options)}', text)

    def one(self, seed):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            made = subprocess.run([self.asked.hostile_runs, '--write', str(seed), str(folder / 'in.json')], check=True,
                                  text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
            options = made.stdout.split()
            code, text, seconds = run([self.asked.cover, 'mesh', '-vv', folder / 'in.json', '-o', folder / 'm.vtu', '-o',
                                       folder / 'clean.poly', *options], self.asked.limit)
            self.slowest = max(self.slowest, (seconds, seed))
            if code is None or seconds > self.asked.seconds:
                self.fault(seed, f'{seconds:.1f} s, options {" ".join(options)}', text)
            if code == 0:
                self.outcomes['meshed'] += 1
                self.judge(seed, folder, options, text)
            elif code in REFUSED:
                self.outcomes[REFUSED[code]] += 1
                if len(text.strip()) < 10 or code == 4 and self.asked.missed:
                    self.fault(seed, f'exit {code}, options {" ".join(options)}', text)
            elif code is not None:
                self.fault(seed, f'exit {code}, options {" ".join(options)}', text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('hostile_runs')
    parser.add_argument('cover')
    parser.add_argument('first', type=int)
    parser.add_argument('count', type=int)
    parser.add_argument('--witness')
    parser.add_argument('--every', type=int, default=10)
    parser.add_argument('--seconds', type=float, default=20)
    parser.add_argument('--limit', type=float, default=300, help='seconds of the clock, then a run is killed')
    parser.add_argument('--missed', action='store_true', help='a missed bound counts as a fault')
    runs = Runs(parser.parse_args())
    done = 0
    try:
        for seed in range(runs.asked.first, runs.asked.first + runs.asked.count):
            runs.one(seed)
            done += 1
    except KeyboardInterrupt:
        pass
    print(json.dumps({'runs': done, **runs.outcomes, 'faults': runs.faults,
                      'slowest': [round(runs.slowest[0], 1), runs.slowest[1]]}))
    return 1 if runs.faults else 0


if __name__ == '__main__':
    sys.exit(main())
