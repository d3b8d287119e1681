#!/usr/bin/env python3
"""check_names.py ROOT: a test is found by its name, and nothing that comments and documents name is missing.

Every source file of the library has a test of its own name (tests/unit/ROOM/FILE_test.cpp) or says in its first
comment which one tests it: "Tested by tests/...". Files and folders that comments and documents name exist.
"""
import pathlib
import re
import sys

# Words that once were documents; nobody can look them up.
GONE = ['DESIGN', 'HOUSE', 'STYLE', 'PEERS', 'ECOSYSTEM']
FILE = r'[\w./-]*\w\.(?:cpp|hpp|py|md|sh|bib|cmake)\b'


def first_comment(text):
    """The lines of comment at the head of a file, as one string."""
    lines = []
    for line in text.splitlines():
        if not line.startswith('//'):
            break
        lines.append(line.lstrip('/ '))
    return ' '.join(lines)


def untested(root):
    source, unit = root / 'libcover/src', root / 'tests/unit'
    for path in sorted(source.rglob('*.cpp')):
        inside = path.relative_to(source)
        if (unit / inside.parent / f'{inside.stem}_test.cpp').exists():
            continue
        named = re.findall(r'Tested by ((?:tests/[\w/.]+\w(?:, | and )?)+)', first_comment(path.read_text()))
        tests = [t for group in named for t in re.findall(r'tests/[\w/.]+\w', group)]
        if not tests:
            yield f'libcover/src/{inside}: there is no tests/unit/{inside.with_suffix("")}_test.cpp, and no "Tested by"'
        for test in tests:
            if not (root / test).exists():
                yield f'libcover/src/{inside}: there is no {test}'


def comments(path):
    """Number and text of the lines that are comments; of documents all lines."""
    mark = {'.py': '#', '.sh': '#', '.cmake': '#', '.txt': '#'}.get(path.suffix, '//')
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if path.suffix == '.md':
            yield number, line
        elif mark in line:
            yield number, line[line.index(mark):]


def dangling(root, paths):
    known = {p.name for p in root.rglob('*') if 'build' not in p.relative_to(root).parts}
    folders = [root, root / 'libcover', root / 'libcover/src', root / 'libcover/include', root / 'tests', root / 'tests/unit',
               root / 'apps', root / 'libcover/docs']
    for path in paths:
        for number, line in comments(path):
            where = f'{path.relative_to(root)}:{number}'
            for word in GONE:
                if re.search(rf'\b{word}\b', line):
                    yield f'{where}: there is no {word}'
            line = re.sub(r'https?://\S+|<[\w/]+\.h(?:pp|h)?>', '', line)
            for name in re.findall(FILE, line):
                places = [path.parent, *folders]
                if '/' in name and not any((place / name).exists() for place in places) or \
                        '/' not in name and name not in known:
                    yield f'{where}: there is no {name}'


def main(root):
    sources = [p for top in ('libcover/src', 'libcover/include', 'apps', 'samples', 'tests', 'cmake')
               for p in sorted((root / top).rglob('*')) if p.suffix in ('.cpp', '.hpp', '.py', '.sh', '.cmake')]
    documents = [root / 'README.md', *sorted((root / 'libcover').rglob('*.md')), *sorted((root / 'tests').rglob('*.md'))]
    found = [*untested(root), *dangling(root, sources + documents)]
    print('\n'.join(found) or f'{len(sources)} sources and {len(documents)} documents name what is there')
    return 1 if found or not sources else 0


if __name__ == '__main__':
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
