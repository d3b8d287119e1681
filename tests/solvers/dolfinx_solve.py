"""dolfinx 0.5: mesh.xdmf or mesh.msh, then the problem."""
import sys

import ufl
from dolfinx import fem, io
from dolfinx.fem.petsc import LinearProblem
from mpi4py import MPI

from problem import Data

path, data = sys.argv[1], Data(sys.argv[2])


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

constants = fem.FunctionSpace(mesh, ('DG', 0))
k, gx, gy = (fem.Function(constants) for _ in range(3))
for number, values in data.regions.items():
    for function, value in zip((k, gx, gy), values):
        function.x.array[cells.indices[cells.values == number]] = value
space = fem.FunctionSpace(mesh, ('CG', 1))
u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
exact = fem.Function(space)
exact.interpolate(lambda x: data.exact(x[0], x[1]))
fixed = [fem.dirichletbc(exact, fem.locate_dofs_topological(space, 1, facets.indices[facets.values == number]))
         for number in data.fixed]
flux = k * ufl.dot(ufl.as_vector((gx, gy)), ufl.FacetNormal(mesh)) * v
dS = ufl.Measure('dS', domain=mesh, subdomain_data=facets)
ds = ufl.Measure('ds', domain=mesh, subdomain_data=facets)
nothing = fem.Constant(mesh, 0.0) * v * ufl.dx
sources = sum(((flux('+') + flux('-')) * dS(number) for number in data.inner), nothing)
sources = sum((flux * ds(number) for number in data.outer), sources)
problem = LinearProblem(k * ufl.inner(ufl.grad(u), ufl.grad(v)) * ufl.dx, sources, bcs=fixed,
                        petsc_options={'ksp_type': 'preonly', 'pc_type': 'lu'})
print('largest error', abs(problem.solve().x.array - exact.x.array).max())
