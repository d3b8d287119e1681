#!/usr/bin/env python3
"""layers.py COVER FOLDER MOSFET: what layers are worth to a solver, in numpy and scipy.

Poisson's equation with Boltzmann's electrons and holes in a MOSFET from below its threshold to far above, on a mesh with layers of
0.2 nm below the oxide and on one that is finer by 4 in both directions: the charge of the inversion layer agrees within 1 %, with a
fifth of the nodes. Edges along the gate are 10 nm long: with 20 nm, it is the gate's ends that make a difference of 2 % below the
threshold, where charges are exponentials of the potential, and no layers across the gate change that.
The layers' first row is right to 1e-9, and isotropic triangles of its thickness would be five times as many."""
import json
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

from box_method import boxes, form_factors, mesh

DOPING, INTRINSIC = 1e-3, 1.5e-11  # per cubic nm: 1e18 and 1.5e10 per cubic cm
CHARGE = 59.5                      # q / (permittivity of silicon * kT / q), in nm
THERMAL = 0.02585                  # kT / q, in V
GATES = (0.8, 1.0, 1.5, 2.0)       # in V
ALONG = 10                         # nm
PERMITTIVITY = {'channel': 1.0, 'oxide': 3.9 / 11.7, 'gate': 1.0}


def device(given, folder, fine):
    """The sample with layers that are finer by `fine`, and its file."""
    drawing = json.loads(pathlib.Path(given).read_text())
    drawing['layers'] = [
        {'line': 'channel_oxide', 'region': 'channel', 'first': 0.2 / fine, 'growth': 1.3 ** (1 / fine)},
        {'line': 'channel_oxide', 'region': 'oxide', 'first': 0.3 / fine, 'growth': 1, 'count': 3 * fine}]
    path = folder / f'mosfet{fine}.json'
    path.write_text(json.dumps(drawing))
    return path


def inversion_charge(points, triangles, regions, names, volts):
    """Electrons per nm of depth in the channel."""
    factors = form_factors(points, triangles, regions)
    n = len(points)
    edges = np.array([key[:2] for key in factors])
    weight = np.array([PERMITTIVITY[names[key[2]]] * factor for key, factor in factors.items()])
    a, b = edges.T
    rows, columns = np.concatenate([a, a, b, b]), np.concatenate([a, b, b, a])
    laplace = sparse.csr_matrix((np.concatenate([weight, -weight, weight, -weight]), (rows, columns)), (n, n))
    channel = np.array([names[r] == 'channel' for r in regions])
    box = boxes(points, triangles[channel], False)
    gate = np.zeros(n, bool)
    gate[triangles[[names[r] == 'gate' for r in regions]].ravel()] = True
    bottom = points[:, 1] == points[:, 1].min()
    bulk = -np.arcsinh(DOPING / 2 / INTRINSIC)
    psi = np.where(box > 0, bulk, 0.0)
    psi[gate], psi[bottom] = volts / THERMAL + bulk, bulk
    free = np.flatnonzero(~gate & ~bottom)
    for _ in range(500):
        electrons, holes = INTRINSIC * np.exp(psi), INTRINSIC * np.exp(-psi)
        residual = laplace @ psi - CHARGE * box * (holes - electrons - DOPING)
        matrix = laplace + sparse.diags(CHARGE * box * (holes + electrons))
        step = spsolve(matrix[free][:, free].tocsc(), -residual[free])
        psi[free] += np.clip(step, -2, 2)
        if np.abs(step).max() < 1e-9:
            return (box * INTRINSIC * np.exp(psi)).sum()
    raise AssertionError('Newton does not converge')


def main():
    cover, folder, given = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
    folder.mkdir(parents=True, exist_ok=True)
    charges, nodes = [], []
    for fine in (1, 4):
        report = folder / f'report{fine}.json'
        points, triangles, regions = mesh(cover, device(given, folder, fine), folder, f'mosfet{fine}', '--split-interfaces',
                                          '--size-at', f'channel_oxide={ALONG / fine}', '--size-at', f'oxide_gate={ALONG / fine}',
                                          '--report', report)
        told = json.loads(report.read_text())
        # Materials are numbered in the order of the polygons.
        names = dict(zip(sorted(set(regions.tolist())), ('channel', 'oxide', 'gate')))
        charges.append(np.array([inversion_charge(points, triangles, regions, names, volts) for volts in GATES]))
        nodes.append(len(points))
        layers = next(r['layers'][0] for r in told['regions'] if r['name'] == 'channel')
        depths = np.sort(-points[points[:, 1] < 0, 1])
        assert abs(depths[0] / (0.2 / fine) - 1) <= 1e-9, depths[:3]
        print(f'finer by {fine}: {len(points)} nodes, {len(triangles)} triangles, {layers["fewest"]} to {layers["most"]} layers, '
              f'{charges[-1]} electrons per nm at {GATES} V')
    assert (abs(charges[0] / charges[1] - 1) <= 0.01).all(), charges
    assert nodes[0] * 5 <= nodes[1], nodes
    drawing = json.loads(pathlib.Path(given).read_text())
    del drawing['layers']
    isotropic = folder / 'isotropic.json'
    isotropic.write_text(json.dumps(drawing))
    points, triangles, _ = mesh(cover, isotropic, folder, 'isotropic', '--split-interfaces', '--size-at', 'channel_oxide=0.2')
    print(f'isotropic: {len(points)} nodes, {len(triangles)} triangles')
    assert nodes[0] * 5 <= len(points)


if __name__ == '__main__':
    main()
