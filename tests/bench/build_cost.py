#!/usr/bin/env python3
"""build_cost.py BUILD [TARGET...]: what compiling costs: user seconds of every unit, the costliest first.

BUILD is a build folder configured with -DCMAKE_EXPORT_COMPILE_COMMANDS=ON. A target is the name of one
of its CMake targets, say cover_cli; without any, all units are compiled, one at a time and past
ccache. User time hardly depends on what else the machine does.

  --lines   preprocesses only, and counts lines: quick, and the same on every machine
  --headers which headers all units read, by the lines that they bring with them
"""
import argparse
import collections
import json
import os
import pathlib
import re
import resource
import shlex
import subprocess
import sys
import tempfile

HEAVY = ['CGAL/', 'boost/asio', 'boost/', 'nlohmann/', 'fmt/', 'spdlog/', 'CLI/', 'gtest/', 'vtk', 'OpenMesh/', 'pybind11/',
         'benchmark/', 'Eigen/', 'c++/12/']


def units(build, targets):
    for unit in json.loads((build / 'compile_commands.json').read_text()):
        words = shlex.split(unit['command'])
        output = words[words.index('-o') + 1]
        target = re.search(r'CMakeFiles/([^/]+)\.dir', output).group(1)
        if not targets or target in targets:
            yield target, pathlib.Path(unit['file']), unit['directory'], words, output


def compiled(words, directory, output):
    words = [w if w != output else '/dev/null' for w in words if 'ccache' not in w]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run(words, cwd=directory, check=True, env={**os.environ, 'CCACHE_DISABLE': '1'})
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def preprocessed(words, directory, output):
    """Lines of the unit, and by library."""
    words = [w for w in words if 'ccache' not in w]
    words[words.index('-c')] = '-E'
    at = words.index('-o')
    text = subprocess.run(words[:at] + words[at + 2:], cwd=directory, check=True, capture_output=True, text=True).stdout
    library, lines = 'own', collections.Counter()
    for line in text.splitlines():
        if line.startswith('# '):
            file = line.split('"')[1]
            library = next((h for h in HEAVY if h in file), 'system' if '/usr/' in file else 'own')
        elif line.strip():
            lines[library] += 1
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('build', type=pathlib.Path)
    parser.add_argument('target', nargs='*')
    parser.add_argument('--lines', action='store_true')
    parser.add_argument('--top', type=int, default=20)
    parser.add_argument('--match', default='', help='only files whose path matches')
    arguments = parser.parse_args()
    found, by_target, libraries = [], collections.Counter(), collections.Counter()
    for target, file, directory, words, output in units(arguments.build, arguments.target):
        if not re.search(arguments.match, str(file)):
            continue
        if arguments.lines:
            lines = preprocessed(words, directory, output)
            cost, note = sum(lines.values()) / 1000, ' '.join(f'{k} {v // 1000}' for k, v in lines.most_common(6))
            libraries.update(lines)
        else:
            cost, note = compiled(words, directory, output), ''
        found.append((cost, target, file, note))
        by_target[target] += cost
    unit = 'thousand lines' if arguments.lines else 's'
    for cost, target, file, note in sorted(found, reverse=True, key=lambda f: f[0])[:arguments.top]:
        print(f'{cost:8.1f}  {target}: {os.path.relpath(file)}  {note}')
    print(f'\n{sum(by_target.values()):8.1f} {unit} in {len(found)} units')
    for target, cost in by_target.most_common():
        print(f'{cost:8.1f}  {target}')
    for library, lines in libraries.most_common():
        print(f'{lines / 1000:8.1f}  {library}')
    return 0


if __name__ == '__main__':
    sys.exit(main())
