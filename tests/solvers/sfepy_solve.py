"""sfepy: mesh.vtk, then the problem with materials as regions. The format has no lines, so the
solution is given on the whole outline, and interfaces are what two materials share."""
import itertools
import sys

import numpy as np
from sfepy.base.base import output
from sfepy.discrete import Equation, Equations, FieldVariable, Integral, Material, Problem
from sfepy.discrete.conditions import Conditions, EssentialBC
from sfepy.discrete.functions import Function
from sfepy.discrete.fem import FEDomain, Field, Mesh
from sfepy.solvers.ls import ScipyDirect
from sfepy.solvers.nls import Newton
from sfepy.terms import Term

from problem import Data

output.set_output(quiet=True)
data = Data(sys.argv[2])
mesh = Mesh.from_file(sys.argv[1])
domain = FEDomain('domain', mesh)
whole = domain.create_region('Whole', 'all')
outline = domain.create_region('Outline', 'vertices of surface', 'facet')
for number in data.regions:
    domain.create_region(f'M{number}', f'cells of group {number}')

field = Field.from_args('field', np.float64, 'scalar', whole, approx_order=1)
u = FieldVariable('u', 'unknown', field)
v = FieldVariable('v', 'test', field, primary_var_name='u')
k = Material('k', values={'value': {f'M{number}': values[0] for number, values in data.regions.items()}})
integral = Integral('integral', order=2)
terms = Term.new('dw_laplace(k.value, v, u)', integral, whole, k=k, v=v, u=u)
for one, other in itertools.permutations(data.regions, 2):
    try:
        shared = domain.create_region(f'I{one}_{other}', f'r.M{one} *e r.M{other}', 'facet', f'M{one}')
    except ValueError:  # they do not touch
        continue
    value, gx, gy = data.regions[one]
    flux = Material(f'flux{one}_{other}', flux=[[value * gx], [value * gy]])
    terms = terms - Term.new(f'dw_surface_ndot({flux.name}.flux, v)', integral, shared, v=v, **{flux.name: flux})
problem = Problem('problem', equations=Equations([Equation('balance', terms)]))


def boundary(ts, coors, **kwargs):
    return data.exact(coors[:, 0], coors[:, 1])


problem.set_bcs(ebcs=Conditions([EssentialBC('outline', outline, {'u.0': Function('boundary', boundary)})]))
problem.set_solver(Newton({}, lin_solver=ScipyDirect({})))
solution = problem.solve(save_results=False).get_parts()['u'].ravel()
print('largest error', abs(solution - data.exact(*mesh.coors.T[:2])).max())
