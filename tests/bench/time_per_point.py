#!/usr/bin/env python3
"""time_per_point.py PROGRAM [-f FAMILY...] [-m METHOD...] [-n SIZE...]: is the time per point flat?

Meshes the inputs of inputs/families.py at growing sizes, one thread, and prints microseconds of user time per
input point for the whole run and for each stage that takes longer than a twentieth of it. The last column is
the time per point over the least of the smaller sizes. Exits with 1 where that is above 2.
"""
import argparse
import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / 'inputs'))
from families import FAMILIES  # noqa: E402  (after the path)

LIMIT = 2.0
SECONDS = 100  # for one run


def run(program, source, target, options):
    """User seconds, and seconds by stage; None where the run failed or took too long."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    command = [program, 'mesh', str(source), '-o', str(target), '-j', '1', '--stats', 'json', *options]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return None, f'more than {SECONDS} s'
    user = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    if done.returncode not in (0, 6):
        return None, f'exit status {done.returncode}: {done.stderr.strip().splitlines()[-1:]}'
    report = json.loads(done.stdout)
    return user, {entry['stage']: entry['seconds'] for entry in report['times']}


def start_seconds(program, folder):
    """User seconds of a run that has nothing to do."""
    source = folder / 'square.json'
    source.write_text(json.dumps(FAMILIES['circle'](4)))
    return min(run(program, source, folder / 'square.vtu', [])[0] for _ in range(5))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('program')
    parser.add_argument('-f', '--family', nargs='+', default=list(FAMILIES), choices=list(FAMILIES))
    parser.add_argument('-m', '--method', nargs='+', default=['quality', 'almond'])
    parser.add_argument('-n', '--size', nargs='+', type=int, default=[1000, 10000, 100000])
    parser.add_argument('-o', '--options', default='', help='more options of cover mesh')
    parser.add_argument('--format', default='vtu', help='extension of what is written (vtu)')
    parser.add_argument('--keep', help='a folder in which inputs are kept')
    arguments = parser.parse_args()
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        inputs = pathlib.Path(arguments.keep or folder)
        inputs.mkdir(exist_ok=True)
        start = start_seconds(arguments.program, inputs)
        for family in arguments.family:
            for method in arguments.method:
                least = None
                for size in arguments.size:
                    source = inputs / f'{family}_{size}.json'
                    if not source.exists():
                        source.write_text(json.dumps(FAMILIES[family](size)))
                    target = os.path.join(folder, f'out.{arguments.format}')
                    user, stages = run(arguments.program, source, target,
                                       ['--method', method, *arguments.options.split()])
                    if user is None:
                        print(f'{family:18} {method:8} {size:7}  {stages}', flush=True)
                        failed = True
                        continue
                    per_point = 1e6 * (user - start) / size
                    growth = per_point / least if least else 1.0
                    failed |= growth > LIMIT
                    slow = ', '.join(f'{stage} {1e6 * seconds / size:.1f}' for stage, seconds in stages.items()
                                     if seconds > 0.05 * user)
                    print(f'{family:18} {method:8} {size:7} {per_point:9.1f} us  x{growth:.2f}'
                          f'{" <--" if growth > LIMIT else "    "} {slow}', flush=True)
                    least = min(per_point, least or per_point)
    sys.exit(failed)


if __name__ == '__main__':
    main()
