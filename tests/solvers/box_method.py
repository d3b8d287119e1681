#!/usr/bin/env python3
"""box_method.py COVER FOLDER INPUT...: what a finite volume solver does with our meshes, in numpy and scipy.

For every input and grade: box areas add up to the triangles' areas, with signed lengths where no coupling is negative (--box-method, and the
default where nothing encroaches a side) and
with unsigned ones, as devsim takes them, where no angle is obtuse (--split-interfaces --max-angle 90). Form factors are per region, as in
VoronoiFVM and WIAS' pdelib. Then a diode with Scharfetter-Gummel fluxes on a --box-method mesh: Gummel's iteration converges, densities stay positive
(its matrices are M-matrices), and the current agrees with that on a mesh 16 times as fine within 1 %."""
import pathlib
import subprocess
import sys

try:
    import numpy as np
    import scipy.sparse as sparse
    from scipy.sparse.linalg import spsolve
except ImportError as error:
    print('skipped:', error)
    sys.exit(77)


def mesh(cover, given, folder, name, *options):
    """Points, triangles and regions of `given`, meshed with `options`."""
    stem = folder / name
    subprocess.run([cover, 'mesh', given, '-q', '-o', f'{stem}.ele', *options], check=True)
    def table(suffix):
        lines = [line.split('#')[0].split() for line in open(f'{stem}{suffix}')]
        return [line for line in lines if line][1:]
    nodes, elements = table('.node'), table('.ele')
    first = int(nodes[0][0])
    points = np.array([[float(x) for x in line[1:3]] for line in nodes])
    triangles = np.array([[int(v) - first for v in line[1:4]] for line in elements])
    return points, triangles, np.array([float(line[4]) for line in elements])


def cotangents(points, triangles):
    """By triangle and corner."""
    out = np.empty(triangles.shape)
    for i in range(3):
        p, q, r = (points[triangles[:, (i + k) % 3]] for k in range(3))
        u, v = q - p, r - p
        out[:, i] = (u * v).sum(1) / (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
    return out


def areas(points, triangles):
    u, v = (points[triangles[:, k]] - points[triangles[:, 0]] for k in (1, 2))
    return (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2


def boxes(points, triangles, unsigned):
    """The area of every vertex' box, assembled edge by edge: each end of an edge of length e gets e d / 4 from a triangle with
    the circumcentre at distance d = e cot / 2."""
    box = np.zeros(len(points))
    cot = cotangents(points, triangles)
    cot = np.abs(cot) if unsigned else cot
    for i in range(3):
        a, b = triangles[:, (i + 1) % 3], triangles[:, (i + 2) % 3]
        e = ((points[b] - points[a]) ** 2).sum(1)
        np.add.at(box, a, e * cot[:, i] / 8)
        np.add.at(box, b, e * cot[:, i] / 8)
    return box


def form_factors(points, triangles, regions):
    """Edges (a < b) and their factor (cot + cot) / 2, per region; the least of all is returned with them."""
    cot = cotangents(points, triangles)
    sums = {}
    for t, (corners, region) in enumerate(zip(triangles.tolist(), regions.tolist())):
        for i in range(3):
            a, b = corners[(i + 1) % 3], corners[(i + 2) % 3]
            key = (min(a, b), max(a, b), region)
            sums[key] = sums.get(key, 0.0) + cot[t, i] / 2
    return sums


def check_boxes(cover, given, folder, name):
    grades = [(1, ['--box-method']), (2, ['--split-interfaces', '--max-angle', '90'])]
    costs = subprocess.run([cover, 'info', given], check=True, capture_output=True, text=True).stdout
    if 'Box method: 0 of' in costs:
        grades.insert(0, (0, []))  # the default keeps segments whole and has no negative coupling either
    for grade, options in grades:
        points, triangles, regions = mesh(cover, given, folder, f'{name}{grade}', *options)
        area = areas(points, triangles).sum()
        for unsigned in ([False, True] if grade == 2 else [False]):
            box = boxes(points, triangles, unsigned)
            assert abs(box.sum() - area) <= 1e-12 * area, (name, grade, unsigned, box.sum() - area)
        least = min(form_factors(points, triangles, regions).values())
        assert least >= -1e-12, (name, grade, least)
        print(f'{name}: grade {grade}: {len(points)} vertices, boxes add up, least form factor {least:.3g}')


def bernoulli(x):
    small = np.abs(x) < 1e-4
    return np.where(small, 1 - x / 2 + x * x / 12, x / np.expm1(np.where(small, 1, x)))


def diode(points, triangles, regions, width, doping, bias):
    """The current through a diode, anode at x = 0, cathode at x = width; lengths in intrinsic Debye lengths times 1e-4 or so: potentials in
    kT/q, densities in units of the intrinsic one, mobilities 1, permittivity 1."""
    sums = {}
    for (a, b, _), factor in form_factors(points, triangles, regions).items():
        sums[a, b] = sums.get((a, b), 0.0) + factor
    edges, factor = np.array(list(sums)), np.array(list(sums.values()))
    a, b = edges.T
    box = boxes(points, triangles, False)
    n = len(points)
    fixed = np.isclose(points[:, 0], 0) | np.isclose(points[:, 0], width)
    free = np.flatnonzero(~fixed)
    built_in = np.arcsinh(doping / 2)
    applied = np.where(np.isclose(points[:, 0], 0), bias, 0.0)
    psi = built_in.copy()
    psi[fixed] += applied[fixed]
    phi_n = phi_p = np.where(points[:, 0] < width / 2, bias, 0.0)  # quasi-Fermi potentials to start with

    def assemble(weight_ab, weight_ba):
        """Rows: sum over edges of factor (weight_ab u_a - weight_ba u_b), and the reverse."""
        rows, columns = np.concatenate([a, a, b, b]), np.concatenate([a, b, b, a])
        values = np.concatenate([weight_ab, -weight_ba, weight_ba, -weight_ab]) * np.tile(factor, 4)
        return sparse.csr_matrix((values, (rows, columns)), (n, n))

    def solve(matrix, right, boundary):
        u = np.where(fixed, boundary, 0.0)
        right = (right - matrix @ u)[free]
        u[free] = spsolve(matrix[free][:, free].tocsc(), right)
        return u

    laplace = assemble(np.ones(len(a)), np.ones(len(a)))
    edge_density = built_in + applied
    for iteration in range(200):
        before = psi.copy()
        for _ in range(50):  # Newton's method for Poisson's equation with quasi-Fermi potentials held
            electrons, holes = np.exp(psi - phi_n), np.exp(phi_p - psi)
            residual = laplace @ psi - box * (holes - electrons + doping)
            matrix = laplace + sparse.diags(box * (holes + electrons))
            step = np.zeros(n)
            step[free] = spsolve(matrix[free][:, free].tocsc(), -residual[free])
            psi += np.clip(step, -2, 2)
            if np.abs(step).max() < 1e-10:
                break
        else:
            raise AssertionError('Newton does not converge')
        d = psi[b] - psi[a]
        electrons = solve(assemble(bernoulli(-d), bernoulli(d)), np.zeros(n), np.exp(edge_density - applied))
        holes = solve(assemble(bernoulli(d), bernoulli(-d)), np.zeros(n), np.exp(applied - edge_density))
        assert electrons.min() > 0 and holes.min() > 0, 'a density is not positive'
        phi_n, phi_p = psi - np.log(electrons), psi + np.log(holes)
        if np.abs(psi - before).max() < 1e-8:
            break
    else:
        raise AssertionError("Gummel's iteration does not converge")
    flux = factor * (bernoulli(d) * electrons[b] - bernoulli(-d) * electrons[a]
                     - bernoulli(-d) * holes[b] + bernoulli(d) * holes[a])
    at_anode = np.isclose(points[:, 0], 0)
    current = flux[at_anode[a] & ~at_anode[b]].sum() - flux[at_anode[b] & ~at_anode[a]].sum()
    return current, iteration + 1


def check_diode(cover, folder):
    # Two regions with a slanted interface beside the junction, and a dimple that encroaches the lower side.
    given = folder / 'diode_two.poly'
    given.write_text('8 2 0 0\n1 0 0\n2 5 0\n3 9 0\n4 9 4\n5 4 4\n6 0 4\n7 4.6 1.2\n8 7 0.4\n'
                     '8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n5 5 6\n6 6 1\n7 2 7\n8 7 5\n0\n2\n1 1 1 1 -1\n2 8 1 2 -1\n')
    currents = []
    for name, size in (('coarse', 0.4), ('fine', 0.1)):
        points, triangles, regions = mesh(cover, given, folder, name, '--box-method', '--size', str(size), '--split-interfaces=179')
        least = min(form_factors(points, triangles, regions).values())
        assert least >= -1e-12, least
        doping = 50 * np.tanh((points[:, 0] - 4.5) / 0.8)
        current, rounds = diode(points, triangles, regions, 9.0, doping, 4.0)
        print(f'diode: {len(points)} vertices, {rounds} rounds, current {current:.8g}')
        currents.append(current)
    assert currents[1] != 0 and abs(currents[0] / currents[1] - 1) < 0.01, currents


def main(cover, folder, *inputs):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for given in inputs:
        if pathlib.Path(given).exists():
            check_boxes(cover, given, folder, pathlib.Path(given).stem)
    check_diode(cover, folder)


if __name__ == '__main__':
    main(*sys.argv[1:])
