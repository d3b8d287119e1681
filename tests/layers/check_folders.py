#!/usr/bin/env python3
"""check_folders.py ROOT: folders are small enough to be read at a glance, and tests stand where their sources do.

No folder of sources holds more than FILES of them without subfolders that say what they hold; not so what is one
list by its nature: the public headers, and the samples. A folder of tests/unit is one of libcover/src, or APP. What is
checked in at the top level is what TOP names, and dotfiles.
"""
import pathlib
import subprocess
import sys

FILES = 16
SUFFIXES = ('.cpp', '.hpp', '.py')
APP = 'app'  # what the program decides by itself
TOP = {'libcover', 'apps', 'tests', 'samples', 'cmake', 'CMakeLists.txt', 'CMakePresets.json', 'README.md',
       'CHANGELOG.md', 'LICENSE'}


def at_the_top(root):
    """The names that are checked in at the top level; those of TOP where there is no repository."""
    listed = subprocess.run(['git', '-C', root, 'ls-files', '-z'], capture_output=True, text=True)
    return {name.split('/')[0] for name in listed.stdout.split('\0') if name} if listed.returncode == 0 else TOP


def main(root):
    folders = [top for name in ('libcover/src', 'apps', 'tests') for top in [root / name, *(root / name).rglob('*')]
               if top.is_dir()]
    found = []
    for folder in sorted(folders):
        count = sum(path.suffix in SUFFIXES for path in folder.iterdir())
        if count > FILES:
            found.append(f'{folder.relative_to(root)}: {count} files, and {FILES} at the most')
    found += [f'{name}: does not belong to the top level'
              for name in sorted(at_the_top(root) - TOP) if not name.startswith('.')]
    unit = root / 'tests/unit'
    for folder in sorted({path.parent.relative_to(unit) for path in unit.rglob('*_test.cpp')}):
        if folder.parts[0] != APP and not (root / 'libcover/src' / folder).is_dir():
            found.append(f'tests/unit/{folder}: there is no libcover/src/{folder}')
    print('\n'.join(found) or f'{len(folders)} folders of {FILES} files at the most')
    return 1 if found or not folders else 0


if __name__ == '__main__':
    sys.exit(main(pathlib.Path(sys.argv[1])))
