#!/usr/bin/env python3
"""options_sweep.py PROGRAM FILE... [--seconds S] [--ways NAME,...]: meshes every file in every way below and has
`cover check` judge what was written, against the drawing as it was cleaned and cut and against the file. Prints a
line for every refusal, for all to be read, and one for every fault: a crash, a mesh that is refused, a run of more than
S seconds (20) of the processor. Exit 1 if there is a fault. On request: an hour for some hundred files.

  tests/corpus/options_sweep.py build/release/apps/cover/cover samples/data/*.poly"""
import argparse
import collections
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
from timed_run import run  # noqa: E402  (after the path)

WAYS = {'default': [], 'hull': ['--hull'], 'split': ['--split-interfaces'],
        'split90': ['--split-interfaces', '--max-angle', '90'], 'nonobtuse': ['--method', 'nonobtuse'],
        'weld': ['--weld', 'auto'], 'box': ['--box-method'], 'almond': ['--method', 'almond']}
REFUSALS = (2, 3, 4, 5, 7)


def checks(program, path, folder, way, said, limit):
    """What `cover check` says against the mesh, of whose run was `said`; empty if nothing."""
    options = WAYS[way]
    hull = ['--hull'] if '--hull' in options else []
    cleaning = ['--weld', 'auto'] if '--weld' in options else []
    # A clean drawing is not welded again; and it may say that it cannot name a region.
    clean = [] if 'a seed in a .poly cannot name it' in said else [[folder / 'clean.poly', '--weld', '0']]
    for words in [*clean, [path, *cleaning]]:
        code, text, _ = run([program, 'check', words[0], folder / 'm.vtu', *words[1:], *hull], limit)
        if code != 0:
            return f'check of {words[0].name} exits with {code}: {text[:800]}'
    return ''


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('program')
    parser.add_argument('files', nargs='+', type=pathlib.Path)
    parser.add_argument('--seconds', type=float, default=20)
    parser.add_argument('--limit', type=float, default=600, help='seconds of the clock, then a run is killed')
    parser.add_argument('--ways', default=','.join(WAYS))
    asked = parser.parse_args()
    outcomes, faults = collections.Counter(), 0
    for path in asked.files:
        for way in asked.ways.split(','):
            with tempfile.TemporaryDirectory() as name:
                folder = pathlib.Path(name)
                code, text, seconds = run([asked.program, 'mesh', path, '-vv', '-o', folder / 'm.vtu', '-o',
                                           folder / 'clean.poly', *WAYS[way]], asked.limit)
                wrong = checks(asked.program, path, folder, way, text, asked.limit) if code == 0 else ''
            if code not in (0, *REFUSALS) or len(text.strip()) < 10 and code != 0:
                wrong = f'exit {code}: {text[-800:]}'
            elif seconds > asked.seconds:
                wrong = wrong or f'{seconds:.1f} s'
            outcomes['fault' if wrong else f'exit {code}'] += 1
            faults += bool(wrong)
            if wrong or code != 0:
                told = wrong or text.strip()[-300:]
                print(f'{"FAULT" if wrong else "refused"} {path.name} {way} {seconds:.1f} s: {told}', flush=True)
    print(dict(outcomes))
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main())
