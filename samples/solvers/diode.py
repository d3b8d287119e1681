"""dolfinx: a current through the diode of the samples.

    cover mesh samples/data/diode.poly -o diode.xdmf
    python3 samples/solvers/diode.py

cover prints which number stands for what: here line 8 is the cathode, 10 the anode.
"""
import ufl
from dolfinx import fem, io
from dolfinx.fem.petsc import LinearProblem
from mpi4py import MPI

with io.XDMFFile(MPI.COMM_WORLD, 'diode.xdmf', 'r', encoding=io.XDMFFile.Encoding.ASCII) as file:
    mesh = file.read_mesh(name='mesh')
    materials = file.read_meshtags(mesh, name='mesh')
    mesh.topology.create_entities(1)
    mesh.topology.create_connectivity(1, 2)
    lines = file.read_meshtags(mesh, name='lines')

conductivity = fem.Function(fem.FunctionSpace(mesh, ('DG', 0)))
conductivity.x.array[:] = 1
conductivity.x.array[materials.find(3)] = 1e-6  # material 3 is the oxide
space = fem.FunctionSpace(mesh, ('CG', 1))
u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
contacts = [fem.dirichletbc(value, fem.locate_dofs_topological(space, 1, lines.find(number)), space)
            for number, value in ((8, 0.0), (10, 1.0))]
problem = LinearProblem(conductivity * ufl.inner(ufl.grad(u), ufl.grad(v)) * ufl.dx,
                        fem.Constant(mesh, 0.0) * v * ufl.dx, bcs=contacts,
                        petsc_options={'ksp_type': 'preonly', 'pc_type': 'lu'})
u = problem.solve()
print('potential from', u.x.array.min(), 'to', u.x.array.max())
print('conductance', fem.assemble_scalar(fem.form(conductivity * ufl.inner(ufl.grad(u), ufl.grad(u)) * ufl.dx)))
