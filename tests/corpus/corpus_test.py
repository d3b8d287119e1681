#!/usr/bin/env python3
"""corpus_test.py PROGRAM FILE [--may-refuse]: meshes the file in every way and checks every promise on what was
written. With --may-refuse, input that is no usable geometry or not read (exit codes 3, 5) ends the test as skipped."""
import pathlib
import subprocess
import sys
import tempfile

WAYS = {'almond': ['--method', 'almond'], 'quality': ['--method', 'quality'], 'paper': ['--paper'],
        'disks': ['--fill', 'disks']}


SKIPPED = 77  # as SKIP_RETURN_CODE in CMakeLists.txt


def run(*words):
    done = subprocess.run([*map(str, words)], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120)
    if done.returncode in (3, 5) and '--may-refuse' in sys.argv:
        print(done.stdout)
        sys.exit(SKIPPED)
    if done.returncode != 0:
        sys.exit(f'exit {done.returncode}: {" ".join(map(str, words))}\n{done.stdout}')
    return done.stdout


def main(program, path):
    with tempfile.TemporaryDirectory() as folder:
        clean = pathlib.Path(folder, 'clean.poly')
        for name, options in WAYS.items():
            mesh = pathlib.Path(folder, name + '.vtu')
            run(program, 'mesh', path, '-o', mesh, '-o', clean, '-q', *options)
            print(name, run(program, 'check', clean, mesh), end='')


if __name__ == '__main__':
    main(*sys.argv[1:3])
