#!/usr/bin/env python3
"""clang-tidy over the sources that the last change touched; check_tidy.py ROOT BUILD.

COVER_TIDY_SINCE names the commit to compare with instead of the one before (all sources: the empty tree,
4b825dc642cb6eb9a060e54bf8d69288fbee4904). Of many files, as after a merge, every so manieth is taken, unless
COVER_TIDY_SINCE is set. Exit code 77 where there is no clang-tidy or no git."""
import os
import pathlib
import shutil
import subprocess
import sys

MOST = 24  # files; a file takes some 4 s


def changed(root, since):
    """Sources that differ from `since`, committed or not."""
    listed = subprocess.run(['git', '-C', str(root), 'diff', '--name-only', '--diff-filter=d', since, '--', 'libcover/src', 'apps'],
                            capture_output=True, text=True, check=True).stdout.split()
    return sorted(path for path in listed if path.endswith('.cpp'))


def main(root, build):
    tidy = shutil.which('clang-tidy-14') or shutil.which('clang-tidy')
    since = os.environ.get('COVER_TIDY_SINCE')
    try:
        files = changed(root, since or 'HEAD~1')
    except (OSError, subprocess.CalledProcessError):
        tidy = None
    if not tidy:
        print('there is no clang-tidy, or no git history')
        return 77
    if not since and len(files) > MOST:
        files = files[::-(-len(files) // MOST)]
    # A build that compiles whole folders at once does not know how a file is compiled.
    subprocess.run(['cmake', '-S', root, '-B', build, '-DCMAKE_BUILD_TYPE=Release', '-DCMAKE_EXPORT_COMPILE_COMMANDS=ON'],
                   stdout=subprocess.DEVNULL, check=True)
    faulty = []
    for path in files:
        run = subprocess.run([tidy, '-p', build, '--quiet', path], cwd=root, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        if run.returncode != 0:
            faulty.append(path)
            print(run.stdout)
    print(f'{len(files)} files, {len(faulty)} with faults')
    return 1 if faulty else 0


if __name__ == '__main__':
    sys.exit(main(pathlib.Path(sys.argv[1]), sys.argv[2]))
