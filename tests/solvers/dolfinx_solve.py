"""dolfinx 0.5: mesh.xdmf or mesh.msh, then the numbers of Si, SiO2, left, right, interface."""
import sys

import numpy as np
import ufl
from dolfinx import fem, io
from dolfinx.fem.petsc import LinearProblem
from mpi4py import MPI
from petsc4py.PETSc import ScalarType

path = sys.argv[1]
si, sio2, left, right, between = map(int, sys.argv[2:7])


def read_xdmf():
    with io.XDMFFile(MPI.COMM_WORLD, path, 'r', encoding=io.XDMFFile.Encoding.ASCII) as file:
        mesh = file.read_mesh(name='mesh')
        cells = file.read_meshtags(mesh, name='mesh')
        mesh.topology.create_entities(1)
        mesh.topology.create_connectivity(1, 2)
        return mesh, cells, file.read_meshtags(mesh, name='lines')


def read_msh():
    import gmsh
    from dolfinx.io import gmshio
    gmsh.initialize()
    gmsh.option.setNumber('General.Terminal', 0)
    gmsh.open(path)
    # Not gmshio.read_from_msh(): in 0.5.2 it ends in a NameError.
    return gmshio.model_to_mesh(gmsh.model, MPI.COMM_WORLD, 0, gdim=2)


mesh, cells, facets = read_xdmf() if path.endswith('.xdmf') else read_msh()

k = fem.Function(fem.FunctionSpace(mesh, ('DG', 0)))
for number, value in ((si, 1.0), (sio2, 4.0)):
    k.x.array[cells.indices[cells.values == number]] = value
space = fem.FunctionSpace(mesh, ('CG', 1))
u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
fixed = [fem.dirichletbc(ScalarType(value),
                         fem.locate_dofs_topological(space, 1, facets.indices[facets.values == number]), space)
         for number, value in ((left, 0.0), (right, 1.0))]
interface = ufl.Measure('dS', domain=mesh, subdomain_data=facets)(between)
problem = LinearProblem(k * ufl.inner(ufl.grad(u), ufl.grad(v)) * ufl.dx,
                        fem.Constant(mesh, ScalarType(0.5)) * ufl.avg(v) * interface, bcs=fixed,
                        petsc_options={'ksp_type': 'preonly', 'pc_type': 'lu'})
solution = problem.solve().x.array
x = space.tabulate_dof_coordinates()[:, 0]
print('largest error', abs(solution - np.where(x < 1, 0.9 * x, 0.9 + 0.1 * (x - 1))).max())
