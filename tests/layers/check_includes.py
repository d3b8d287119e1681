#!/usr/bin/env python3
"""check_includes.py ROOT: a file includes only its own layer or lower ones; CGAL and VTK stay where they belong; the
tests that comments and ARCHITECTURE.md name are there."""
import pathlib
import re
import sys

GROUND = ['base', 'geom', 'cdt']
ORDER = GROUND + ['limits', 'options', 'faces', 'clean', 'region', 'box', 'target', 'sizes', 'mend', 'layers', 'disks',
                  'almond', 'quality', 'method', 'tasks', 'cuts', 'nonobtuse']
SEES = {layer: set(ORDER[:i + 1]) for i, layer in enumerate(ORDER)}
# Of folders within a layer, those that have an order: each sees itself and those before it.
FOLDERS = {'quality': ['effort', 'mutable', 'fault', 'optimum', 'moves', 'parts', 'starts', 'repair', 'plan']}
# What judges meshes shares no code that makes or changes triangles with what makes them.
SEES['verify'] = {'verify', 'limits', *GROUND}
SEES['mesh'] = SEES['target'] | {'mesh'}
SEES['pipeline'] = {*ORDER, 'verify', 'mesh', 'pipeline'}
SEES['io'] = {'io', *GROUND}
SEES['stream'] = SEES['pipeline'] | {'io', 'stream'}
SEES['picture'] = SEES['io'] | {'picture'}
SEES['vtk'] = SEES['picture'] | {'vtk'}
SEES['dxf'] = SEES['io'] | {'dxf'}
SEES['gdal'] = SEES['io'] | {'gdal'}
SEES['gmsh'] = SEES['io'] | {'gmsh'}
CGAL = {'geom', 'cdt'}  # and there in .cpp files only


def is_crossed(including, included):
    """Whether one folder of a layer includes one that comes later; files beside the folders see all."""
    order = FOLDERS[including[0]]
    if included[0] != including[0] or len(including) < 3:
        return False
    return len(included) < 3 or order.index(included[1]) > order.index(including[1])


def faults(root, path, layer):
    """What `path` includes or names and must not; layer None is the public interface or a program on top of it."""
    for number, line in enumerate(path.read_text().splitlines(), 1):
        for test in re.findall(r'tests/[\w/.]+\.(?:cpp|py)', line):
            if not (root / test).exists():
                yield number, f'there is no {test}'
        if 'fmt::format_to' in line:
            yield number, 'fmt::format_to: what clang calls for it, a libfmt built by g++ does not have; fmt::format'
        match = re.match(r'\s*#\s*include\s*(["<])([^">]+)', line)
        if not match:
            continue
        kind, name = match.groups()
        if kind == '"' and layer and name.split('/')[0] not in SEES[layer]:
            yield number, f"layer '{layer}' may not include \"{name}\""
        if kind == '"' and layer in FOLDERS and is_crossed(path.relative_to(root / 'libcover/src').parts, name.split('/')):
            yield number, f"{path.parent.name} may not include \"{name}\""
        if kind == '"' and not layer and '/' in name and not (root / 'apps/cover' / name).exists():
            yield number, f'"{name}" is private to the library'
        if name.startswith('CGAL/') and (layer not in CGAL or path.suffix != '.cpp'):
            yield number, f'<{name}>: CGAL belongs in .cpp files of {", ".join(sorted(CGAL))}'
        if re.match(r'(hdf5|H5\w+)\.h$', name) and '/io/hdf5/' not in path.as_posix():
            yield number, f'<{name}>: HDF5 belongs in io/hdf5'
        if name == 'gmsh.h' and layer != 'gmsh':
            yield number, f'<{name}>: gmsh belongs in gmsh'
        if name.startswith('dxflib/') and layer != 'dxf':
            yield number, f'<{name}>: dxflib belongs in dxf'
        if re.match(r'(ogr|cpl_|gdal)\w*\.h$', name) and layer != 'gdal':
            yield number, f'<{name}>: GDAL belongs in gdal'
        if name in ('fmt/format.h', 'fmt/ranges.h'):
            yield number, f'<{name}>: each unit would compile all of fmt again, for 4 s; <fmt/core.h> calls its library'
        if re.match(r'vtk\w+\.h', name) and layer != 'vtk' and path.name != 'vtk_cover_mesh.hpp':
            yield number, f'<{name}>: VTK belongs in vtk'


def main(root):
    files = [(p, p.relative_to(root / 'libcover/src').parts[0]) for p in (root / 'libcover/src').rglob('*.[hc]pp')]
    files += [(p, None) for top in ('libcover/include', 'apps', 'samples') for p in (root / top).rglob('*.[hc]pp')]
    found = [f'{path.relative_to(root)}:{number}: {what}'
             for path, layer in sorted(files, key=lambda f: f[0]) for number, what in faults(root, path, layer)]
    architecture = (root / 'libcover/ARCHITECTURE.md').read_text()
    found += [f'libcover/ARCHITECTURE.md: there is no tests/unit/{test}.cpp'
              for test in re.findall(r'`((?:\w+/)+\w+_test)`', architecture) if not (root / f'tests/unit/{test}.cpp').exists()]
    print('\n'.join(found) or f'{len(files)} files include only their own layer or lower ones')
    return 1 if found or not files else 0


if __name__ == '__main__':
    sys.exit(main(pathlib.Path(sys.argv[1])))
