"""sfepy: mesh.vtk. Regions are groups by mat_id; the format has no lines, so the interface is what
both regions share and the contacts are found by their coordinates."""
import sys

import numpy as np
from sfepy.base.base import output
from sfepy.discrete import Equation, Equations, FieldVariable, Integral, Material, Problem
from sfepy.discrete.conditions import Conditions, EssentialBC
from sfepy.discrete.fem import FEDomain, Field, Mesh
from sfepy.solvers.ls import ScipyDirect
from sfepy.solvers.nls import Newton
from sfepy.terms import Term

output.set_output(quiet=True)
mesh = Mesh.from_file(sys.argv[1])
domain = FEDomain('domain', mesh)
whole = domain.create_region('Whole', 'all')
domain.create_region('Si', 'cells of group 1')
domain.create_region('SiO2', 'cells of group 2')
interface = domain.create_region('Interface', 'r.Si *v r.SiO2', 'facet')
left = domain.create_region('Left', 'vertices in x < 1e-9', 'facet')
right = domain.create_region('Right', 'vertices in x > 1.999999999', 'facet')

field = Field.from_args('field', np.float64, 'scalar', whole, approx_order=1)
u = FieldVariable('u', 'unknown', field)
v = FieldVariable('v', 'test', field, primary_var_name='u')
k = Material('k', values={'value': {'Si': 1.0, 'SiO2': 4.0}})
source = Material('source', value=0.25)  # integrated from both sides of an inner facet
integral = Integral('integral', order=2)
problem = Problem('problem', equations=Equations([Equation(
    'balance', Term.new('dw_laplace(k.value, v, u)', integral, whole, k=k, v=v, u=u)
    - Term.new('dw_integrate(source.value, v)', integral, interface, source=source, v=v))]))
problem.set_bcs(ebcs=Conditions([EssentialBC('left', left, {'u.0': 0.0}),
                                 EssentialBC('right', right, {'u.0': 1.0})]))
problem.set_solver(Newton({}, lin_solver=ScipyDirect({})))
solution = problem.solve(save_results=False).get_parts()['u'].ravel()
x = mesh.coors[:, 0]
print('largest error', abs(solution - np.where(x < 1, 0.9 * x, 0.9 + 0.1 * (x - 1))).max())
