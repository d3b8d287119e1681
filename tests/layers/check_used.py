#!/usr/bin/env python3
"""check_used.py ROOT: a file includes, by whatever way, what declares the names that it uses.

A unity build compiles many files as one, so that each lives on what those before it included; the next who builds file
by file finds out. Looked at are types, constants and functions at namespace scope of the library's and the programs'
headers, of a name that no other header gives to anything else. This needs no compiler, and takes a second or two.
"""
import functools
import pathlib
import re
import sys

TYPE = re.compile(r'^(?:template <[^>]*> )?(?:struct|class|enum class|enum) (?:\[\[\w+\]\] )?(\w+)(?!\w|::)')
ALIAS = re.compile(r'^using (\w+) =')
CONSTANT = re.compile(r'^(?:inline )?constexpr [\w:<>, ]+ (k[A-Z]\w*)\b')
FUNCTION = re.compile(r'^(?:\[\[nodiscard\]\] )?(?:inline |constexpr |static )*[A-Za-z][\w:<>,&* ]* &?\*?(\w+_\w+)\(')
# Of a class the members are its own; a namespace, in small letters, is not.
USE = r'(?:(?<![.>:\w])|\b[a-z_]+::)([A-Z]\w*|k[A-Z]\w*|\w+_\w+(?=\())'
FOREIGN = r'\b(?:std|fmt|CGAL|nlohmann|py|fs|testing|chrono|ios|filesystem|numbers|this_thread)::\w+'
# What a name's own declaration may look like: a type, a member, a parameter, a local variable, a function, a value of
# an enumeration.
OWN = (r'(?:struct|class|enum class|using|typename|namespace) {name}\b|[\w>*&] [&*]*{name}(?:[;,={{)\[(]| =| :)'
       r'|^ +{name}(?:,| =)| {name}>|[{{,] {name}[,}} ]')


def code_of(path):
    """The file without comments and without what stands between quotes, but for includes."""
    text = re.sub(r'/\*.*?\*/', '', path.read_text(), flags=re.S)
    text = re.sub(r'R"(\w*)\(.*?\)\1"', '""', text, flags=re.S)
    text = re.sub(r'^(?:TYPED_)?(?:TEST|INSTANTIATE)\w*\([^)]*\)', '', text, flags=re.M)
    lines = [line if '#include' in line else re.sub(r'"(?:\\.|[^"\\])*"', '""', line) for line in text.splitlines()]
    return re.sub(FOREIGN, 'foreign', '\n'.join(re.sub(r'//.*', '', line) for line in lines))


def declared(code):
    """Names that a header declares at namespace scope, which clang-format leaves unindented."""
    for line in code.splitlines():
        for form in (TYPE, ALIAS, CONSTANT, FUNCTION):
            if found := form.match(line):
                yield found[1]


def main(root):
    tops = ['libcover/src', 'libcover/include', 'apps', 'samples', 'tests']
    codes = {path: code_of(path) for top in tops for path in (root / top).rglob('*.[hc]pp')
             if not {'solvers', 'package'} & set(path.parts)}  # programs of others
    roots = [root / 'libcover/src', root / 'libcover/include', root / 'apps/cover', root / 'apps/cover_mpi',
             root / 'apps/python', root / 'apps/reading', root / 'apps', root / 'tests']

    @functools.cache
    def included(path):
        names = re.findall(r'#\s*include\s*["<]([^">]+)', codes[path])
        places = [place / name for name in names for place in [path.parent, *roots]]
        return frozenset(place.resolve() for place in places if place.resolve() in codes)

    def reach(path):
        seen, open_ones = {path}, [path]
        while open_ones:
            for other in included(open_ones.pop()) - seen:
                seen.add(other)
                open_ones.append(other)
        return seen

    homes = {}
    for path, code in codes.items():
        if path.suffix == '.hpp':
            for name in declared(code):
                homes.setdefault(name, set()).add(path)
    found, uses = [], 0
    for path, code in sorted(codes.items()):
        seen = reach(path)
        words = set(re.findall(USE, code))
        for name in sorted(words & homes.keys()):
            if homes[name] & seen:
                uses += 1
            elif not any(re.search(OWN.format(name=name), codes[other], re.M) for other in seen):
                line = code[:re.search(rf'\b{name}\b', code).start()].count('\n') + 1
                home = min(homes[name]).relative_to(root)
                found.append(f'{path.relative_to(root)}:{line}: uses {name} without including {home}')
    print('\n'.join(found) or f'{len(codes)} files include what declares the {uses} names that they use')
    return 1 if found or not uses else 0


if __name__ == '__main__':
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
