#!/usr/bin/env python3
"""check_format.py ROOT: every source of ours is as clang-format 14 writes it with the checked-in configuration."""
import pathlib
import shutil
import subprocess
import sys

SKIPPED = 77


def main(root):
    program = shutil.which('clang-format')
    if program is None or ' 14.' not in subprocess.run([program, '--version'], capture_output=True, text=True).stdout:
        print('clang-format 14 is not installed: the format of sources is NOT checked')
        return SKIPPED
    files = sorted(str(path) for top in ('libcover', 'apps', 'tests', 'samples') for path in (root / top).rglob('*.[hc]pp'))
    done = subprocess.run([program, '--dry-run', '-Werror', *files], capture_output=True, text=True)
    places = [line for line in done.stderr.splitlines() if 'error:' in line]
    print('\n'.join(places) or f'{len(files)} files are formatted')
    return done.returncode


if __name__ == '__main__':
    sys.exit(main(pathlib.Path(sys.argv[1])))
