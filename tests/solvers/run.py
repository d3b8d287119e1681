#!/usr/bin/python3
"""Solves the problem of README.md in one program on meshes that cover made.

usage: run.py COVER SOLVER [FOLDER [GEOMETRY]]
SOLVER is a function solve_* below; `readers` solve nothing, they compare all that arrives with the
manifest. FOLDER keeps the files. GEOMETRY is two_materials.json unless given.
Exit code 77: the program is not installed.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from problem import Data, Problem, freefem, getdp

HERE = pathlib.Path(__file__).resolve().parent
PYTHON = '/usr/bin/python3'  # the packages of the system, whatever else is first in the path
LARGEST_ERROR = 1e-12
SKIPPED = 77


class Job:
    """A folder with meshes, and the numbers behind their names."""

    def __init__(self, cover, folder, geometry):
        self.cover, self.folder, self.geometry = cover, folder, geometry
        self.failures = 0

    def mesh(self, name, *options):
        """Writes `name` with the options of `cover mesh`; returns its path."""
        path = self.folder / name
        subprocess.run([self.cover, 'mesh', self.geometry, '-q', '--method', 'quality',
                        '-o', path, '-o', self.folder / 'manifest.json', *options], check=True)
        return path

    def problem(self, key):
        """Writes the problem for files that number regions by `key`, group or material; returns its path."""
        self.mesh('points.ele')
        path = self.folder / f'problem_{key}.txt'
        path.write_text(Problem(self.folder / 'manifest.json', self.folder / 'points.node').text(key))
        return path

    def run(self, *command, env=None):
        done = subprocess.run(list(map(str, command)), cwd=self.folder, text=True, timeout=600, env=env,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            print(done.stdout[-3000:])
        return done.stdout

    def judge(self, what, error):
        good = error is not None and error <= LARGEST_ERROR
        print(f'{what:40} {"failed" if error is None else error}')
        self.failures += not good

    def judge_output(self, what, output):
        found = re.findall(r'largest error (\S+)', output)
        if not found:
            print(output[-3000:])
        self.judge(what, float(found[-1]) if found else None)


def need(*programs, module=None):
    """Ends the test as skipped unless all this is installed."""
    missing = [p for p in programs if shutil.which(p) is None]
    if module and subprocess.run([PYTHON, '-c', f'import {module}'], stderr=subprocess.DEVNULL).returncode:
        missing.append(module)
    if missing:
        print('not installed:', *missing)
        sys.exit(SKIPPED)


def solve_freefem(job):
    need('FreeFem++-nw')
    for name, reader, key in (('a.msh', 'gmsh', 'group'), ('a.mesh', 'medit', 'material')):
        (job.folder / 'problem.idp').write_text(freefem(Data(job.problem(key))))
        mesh = job.mesh(name)
        shutil.copy(HERE / 'freefem.edp', job.folder)  # so that it finds its include file
        out = job.run('FreeFem++-nw', '-v', '0', 'freefem.edp', mesh, reader,
                      env={'FF_LOADPATH': '/usr/lib/freefem++', 'PATH': '/usr/bin:/bin'})
        if 'mes < 1e-8' in out:
            print('gmshload refuses triangles with an area below 1e-8: --scale, or Medit')
            continue
        job.judge_output(f'FreeFem++ {reader}', out)


def solve_dolfinx(job):
    need(module='dolfinx')
    for name, key, options in (('a.xdmf', 'material', []), ('a.msh', 'group', []),
                               ('b.msh', 'group', ['--msh', '4.1'])):
        problem, mesh = job.problem(key), job.mesh(name, *options)
        job.judge_output(f'dolfinx {name} {" ".join(options)}',
                         job.run(PYTHON, HERE / 'dolfinx_solve.py', mesh, problem))


def solve_sfepy(job):
    need(module='sfepy')
    problem, mesh = job.problem('material'), job.mesh('a.vtk')
    job.judge_output('sfepy legacy .vtk', job.run(PYTHON, HERE / 'sfepy_solve.py', mesh, problem))


def solve_getfem(job):
    need(module='getfem')
    for name, options in (('a.msh', []), ('b.msh', ['--msh', '4.1']), ('c.msh', ['--order', '2'])):
        problem, mesh = job.problem('group'), job.mesh(name, *options)
        job.judge_output(f'getfem {name} {" ".join(options)}',
                         job.run(PYTHON, HERE / 'getfem_solve.py', mesh, problem))


def solve_getdp(job):
    need('getdp')
    for name, options in (('a.msh', []), ('b.msh', ['--order', '2'])):
        (job.folder / 'problem.pro').write_text(getdp(Data(job.problem('group'))))
        mesh = job.mesh(name, *options)
        shutil.copy(HERE / 'getdp.pro', job.folder)  # so that it finds its include file
        out = job.run('getdp', 'getdp.pro', '-msh', mesh, '-solve', 'Solve', '-pos', 'Deviation',
                      '-name', job.folder / 'getdp')
        table = job.folder / 'error.txt'
        if not table.exists():
            print(out[-3000:])
            job.judge(f'getdp {name}', None)
            continue
        # Each line: type, element, coordinates ..., then the value at every node.
        values = [float(line.split()[-1]) for line in table.read_text().splitlines()]
        job.judge(f'getdp {name} {" ".join(options)}', max(values))
        table.unlink()


def solve_dealii(job):
    need('cmake')
    build = job.folder.parent / 'dealii.build'  # for all geometries: it takes a minute
    out = job.run('cmake', '-S', HERE / 'dealii', '-B', build, '-DCMAKE_BUILD_TYPE=Release')
    if 'Could not find a package configuration file provided by "deal.II"' in out:
        need('deal.II')
    print(job.run('cmake', '--build', build)[-200:])
    for name, key, options in (('a.vtk', 'material', ['--lines']), ('a.msh', 'group', ['--no-inner-lines']),
                               ('b.msh', 'group', ['--msh', '4.1', '--no-inner-lines'])):
        problem, mesh = job.problem(key), job.mesh(name, *options)
        job.judge_output(f'deal.II {name} {" ".join(options)}', job.run(build / 'dealii_solve', mesh, problem))


def solve_calculix(job):
    need('ccx')
    deck = (HERE / 'calculix.inp').read_text()
    for order, element in ((1, 'S'), (2, 'S'), (1, 'CPE'), (2, 'CPS')):
        sets = job.mesh('mesh.inp', '--order', str(order), '--inp-element', element).read_text()
        # Plane elements lose heat through their edges on the right to what is 1.5 warm: as much as heats that to 1.25.
        edges = [k for k in '123' if f'*ELSET, ELSET=RIGHT_S{k}\n' in sets]
        film = '*FILM\n' + ''.join(f'RIGHT_S{k}, F{k}, 1.5, 4.\n' for k in edges)
        warmest = 1.25 if edges else 1
        plane = deck.replace('*SHELL', '*SOLID').replace('RIGHT, 11, 11, 1.\n', film).replace('\n0.1\n', '\n1.\n')
        (job.folder / 'job.inp').write_text(plane if edges else deck)
        job.failures += bool(edges) != (element != 'S')
        job.run('ccx', 'job')
        nodes, error = {}, None
        for line in (job.folder / 'mesh.inp').read_text().splitlines()[1:]:
            if line.startswith('*'):
                break
            number, x = line.split(',')[:2]
            nodes[int(number)] = float(x)
        table = job.folder / 'job.dat'
        for line in table.read_text().splitlines() if table.exists() else []:
            words = line.split()
            if len(words) == 2 and words[0].isdigit() and int(words[0]) in nodes:
                x = nodes[int(words[0])]
                # Without a source: 4 / 5 of the step lies in Si.
                exact = warmest * (0.8 * x if x < 1 else 0.8 + 0.2 * (x - 1))
                error = max(error or 0, abs(float(words[1]) - exact))
        # ccx prints seven digits.
        print(f'CalculiX {element}{3 * order}: {error}')
        job.failures += error is None or error > 1e-6


def solve_samples(job):
    """The programs in samples/solvers, as their first lines say, on the mesh of the samples and on a finer one. All find
    the same conductance; by Dirichlet's principle it is too large, on the coarser mesh by some percent."""
    folder = HERE.parents[1] / 'samples'
    found = {}
    for mesh, options in (('coarse', []), ('fine', ['--split-interfaces', '--size', '0.4'])):
        here = job.folder / mesh
        here.mkdir(exist_ok=True)
        subprocess.run([job.cover, 'mesh', folder / 'data/diode.poly', '-o', here / 'diode.mesh', '-o', here / 'diode.xdmf',
                        '-q', *options], check=True)
        for name, command in (('diode.edp', ['FreeFem++-nw', '-v', '0']), ('diode.py', [PYTHON])):
            if shutil.which(command[0]) is None or (name.endswith('.py') and subprocess.run(
                    [PYTHON, '-c', 'import dolfinx'], stderr=subprocess.DEVNULL).returncode):
                print(f'{name}: not installed')
                continue
            said = subprocess.run([*command, folder / 'solvers' / name], cwd=here, text=True, stdout=subprocess.PIPE).stdout
            numbers = re.findall(r'conductance (\S+)', said)
            found.setdefault(mesh, []).append(float(numbers[0]) if numbers else float('nan'))
            print(name, mesh, found[mesh][-1])
    if not found:
        sys.exit(SKIPPED)
    for values in found.values():
        job.failures += not max(values) / min(values) - 1 < 1e-5
    job.failures += not 0 < found['coarse'][0] / found['fine'][0] - 1 < 0.03


def solve_readers(job):
    """Readers of our own, VTK, meshio and gmsh."""
    need(module='vtk')
    for name, options in (('a.vtu', []), ('a.vtm', []), ('a.vtk', []), ('lines.vtk', ['--lines']), ('a.msh', []),
                          ('v4.msh', ['--msh', '4.1']), ('a.xdmf', []), ('a.mesh', []), ('a.inp', []),
                          ('a.obj', []), ('a.off', []), ('a.ply', []), ('a.ele', []), ('a.svg', []), ('a.png', [])):
        job.mesh(name, *options)
    for name in ('order2.vtu', 'order2.vtm', 'order2.vtk', 'order2.msh', 'order2.xdmf', 'order2.mesh', 'order2.ele'):
        job.mesh(name, '--order', '2')
    job.mesh('v4order2.msh', '--order', '2', '--msh', '4.1')
    job.mesh('a.vtu')  # the manifest of first order
    out = job.run(PYTHON, HERE / 'readers.py', job.folder)
    print(out, end='')
    job.failures += 'everything arrived' not in out


SOLVERS = {name[len('solve_'):]: f for name, f in list(globals().items()) if name.startswith('solve_')}


def main():
    cover, solver = sys.argv[1:3]
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(sys.argv[3] if len(sys.argv) > 3 else scratch).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        geometry = pathlib.Path(sys.argv[4] if len(sys.argv) > 4 else HERE / 'two_materials.json')
        job = Job(pathlib.Path(cover).resolve(), folder, geometry.resolve())
        SOLVERS[solver](job)
    sys.exit(1 if job.failures else 0)


if __name__ == '__main__':
    main()
