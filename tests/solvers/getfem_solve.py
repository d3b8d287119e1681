"""getfem: mesh.msh, then the numbers of Si, SiO2, left, right, interface."""
import sys

import getfem
import numpy as np

si, sio2, left, right, between = map(int, sys.argv[2:7])
mesh = getfem.Mesh('import', 'gmsh', sys.argv[1])
field = getfem.MeshFem(mesh, 1)
field.set_fem(getfem.Fem('FEM_PK(2,1)'))
integration = getfem.MeshIm(mesh, getfem.Integ('IM_TRIANGLE(4)'))
model = getfem.Model('real')
model.add_fem_variable('u', field)
model.add_linear_term(integration, 'Grad_u.Grad_Test_u', si)
model.add_linear_term(integration, '4*Grad_u.Grad_Test_u', sio2)
model.add_source_term(integration, '0.25*Test_u', between)  # once from either side
for number, name, value in ((left, 'zero', 0.0), (right, 'one', 1.0)):
    model.add_initialized_data(name, value)
    model.add_Dirichlet_condition_with_simplification('u', number, name)
model.solve()
x = field.basic_dof_nodes()[0]
exact = np.where(x < 1, 0.9 * x, 0.9 + 0.1 * (x - 1))
print('largest error', abs(model.variable('u') - exact).max())
