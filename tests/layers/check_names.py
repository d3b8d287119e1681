#!/usr/bin/env python3
"""check_names.py ROOT: a test is found by its name, and nothing that comments and documents name is missing.

Every source file of the library has a test of its own name (tests/unit/ROOM/FILE_test.cpp) or says in its first
comment which one tests it: "Tested by tests/...". Files and folders that comments and documents name exist, with an
extension or without one, as `quality/moves/flip`; so do tests that documents choose by `--gtest_filter` or `-R`.
Every public header has its line in libcover/docs/headers.md.
"""
import fnmatch
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
        own = unit / inside.parent / f'{inside.stem}_test.cpp'
        named = re.findall(r'Tested by ((?:tests/[\w/.]+\w(?:, | and )?)+)', first_comment(path.read_text()))
        tests = [t for group in named for t in re.findall(r'tests/[\w/.]+\w', group)]
        if own.exists():
            if tests and own.relative_to(root).as_posix() not in tests:
                yield f'libcover/src/{inside}: its test is {own.relative_to(root)}, not {tests[0]}'
            continue
        if not tests:
            yield f'libcover/src/{inside}: there is no tests/unit/{inside.with_suffix("")}_test.cpp, and no "Tested by"'
        for test in tests:
            if not (root / test).exists():
                yield f'libcover/src/{inside}: there is no {test}'


def defined_twice(root):
    """Types of one name at namespace scope in two headers: two definitions of one entity."""
    places = {}
    for path in sorted([*(root / 'libcover').rglob('*.hpp'), *(root / 'apps').rglob('*.hpp')]):
        space = ''
        for line in path.read_text().splitlines():
            if found := re.match(r'namespace ([\w:]+) \{', line):
                space = found[1]
            elif found := re.match(r'(?:struct|class|enum class) (\w+)(?: final)?(?: : .*)? \{', line):
                places.setdefault((space, found[1]), []).append(path.relative_to(root))
    for (space, name), paths in places.items():
        if len(paths) > 1:
            yield f'{paths[1]}: {space}::{name} is another one in {paths[0]}'


def unlisted(root):
    """Public headers without a line in the document that lists them, and lines of headers that are not there."""
    there = {path.name.split('.')[0] for path in (root / 'libcover/include/cover').iterdir()}
    listed = re.findall(r'^\| `(\w+)` \|', (root / 'libcover/docs/headers.md').read_text(), re.MULTILINE)
    yield from (f'libcover/docs/headers.md: <cover/{name}.hpp> has no line' for name in sorted(there - set(listed)))
    yield from (f'libcover/docs/headers.md: there is no <cover/{name}.hpp>' for name in sorted(set(listed) - there))


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


def tracked(root):
    """Files and folders below `root`, but for what is built."""
    return [p.relative_to(root) for p in root.rglob('*') if not {'build', '.git'} & set(p.relative_to(root).parts)]


def without_extension(root, paths):
    """Paths such as geom/predicates whose first part is a room or a folder in one, and that lead nowhere."""
    there = tracked(root)
    ends = set()
    for path in there:
        parts = path.with_suffix('').parts
        ends |= {'/'.join(parts[k:]) for k in range(len(parts))}
    rooms = {p.name for p in there if (root / p).is_dir() and p.parts[:2] == ('libcover', 'src')}
    for path in paths:
        for number, line in comments(path):
            line = re.sub(r'https?://\S+|<[^>]*>|\{[^}]*\}', '', line)
            for name in re.findall(r'(?<![\w./*-])[a-z_]\w*(?:/[a-z_]\w*)+/?(?![\w/.*-])', line):
                if name.split('/')[0] in rooms and name.rstrip('/') not in ends:
                    yield f'{path.relative_to(root)}:{number}: there is no {name}'


def chosen_tests(root, documents):
    """Tests that a document tells its reader to run."""
    tests = {f'{suite}.{name}' for path in (root / 'tests').rglob('*.cpp')
             for suite, name in re.findall(r'^TEST(?:_[FP])?\((\w+), *(\w+)\)', path.read_text(), re.MULTILINE)}
    for path in documents:
        for number, line in enumerate(path.read_text().splitlines(), 1):
            where = f'{path.relative_to(root)}:{number}'
            for chosen in re.findall(r"--gtest_filter='?([\w.*?]+)", line):
                if not any(fnmatch.fnmatchcase(test, chosen) for test in tests):
                    yield f'{where}: no test is called {chosen}'
            for chosen in re.findall(r'ctest [^`]*-R "?([A-Z]\w+)', line):
                if not any(chosen in test for test in tests):
                    yield f'{where}: no test is called {chosen}'


def main(root):
    sources = [p for top in ('libcover/src', 'libcover/include', 'apps', 'samples', 'tests', 'cmake')
               for p in sorted((root / top).rglob('*')) if p.suffix in ('.cpp', '.hpp', '.py', '.sh', '.cmake')]
    documents = [root / 'README.md', *sorted((root / 'libcover').rglob('*.md')), *sorted((root / 'tests').rglob('*.md'))]
    found = [*untested(root), *defined_twice(root), *unlisted(root), *dangling(root, sources + documents),
             *without_extension(root, sources + documents),
             *chosen_tests(root, documents)]
    print('\n'.join(found) or f'{len(sources)} sources and {len(documents)} documents name what is there')
    return 1 if found or not sources else 0


if __name__ == '__main__':
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
