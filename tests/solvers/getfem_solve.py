"""getfem: mesh.msh, then the problem."""
import sys

import getfem
import numpy as np

from problem import Data

data = Data(sys.argv[2])
mesh = getfem.Mesh('import', 'gmsh', sys.argv[1])
field, constants = getfem.MeshFem(mesh, 1), getfem.MeshFem(mesh, 1)
field.set_fem(getfem.Fem('FEM_PK(2,1)'))
constants.set_fem(getfem.Fem('FEM_PK(2,0)'))
integration = getfem.MeshIm(mesh, getfem.Integ('IM_TRIANGLE(4)'))
k, fx, fy = np.zeros((3, constants.nbdof()))
for number, (value, gx, gy) in data.regions.items():
    dofs = constants.basic_dof_from_cvid(mesh.region(number)[0])[0]
    k[dofs], fx[dofs], fy[dofs] = value, value * gx, value * gy
model = getfem.Model('real')
model.add_fem_variable('u', field)
for name, values in (('k', k), ('fx', fx), ('fy', fy)):
    model.add_initialized_fem_data(name, constants, values)
model.add_linear_term(integration, 'k*Grad_u.Grad_Test_u')
for number in data.inner + data.outer:  # inner lines from either side
    model.add_source_term(integration, '([fx;fy].Normal)*Test_u', number)
exact = data.exact(*field.basic_dof_nodes())
model.add_initialized_fem_data('exact', field, exact)
for number in data.fixed:
    model.add_Dirichlet_condition_with_simplification('u', number, 'exact')
model.solve()
print('largest error', abs(model.variable('u') - exact).max())
