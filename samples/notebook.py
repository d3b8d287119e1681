# %% [markdown]
# A transistor from Python: polygons with contacts and a round corner, meshed into numpy arrays.
# Each `# %%` begins a cell, for editors that run them one by one; `python3 notebook.py` runs all.

# %%
import pickle

import numpy as np

import cover

print('cover', cover.__version__)

# %% Geometry in nm: later polygons lie on top; a contact is a line with a name.
gate_corner = {'arc': {'centre': (40, 22), 'radius': 10, 'from': 0, 'to': 90, 'chord_error': 0.05}}
device = [
    ('Si', [[(-100, -80), (100, -80), (100, 0), (-100, 0)]], 'substrate'),
    ('SiO2', [[(-50, 0), (50, 0), (50, 2), (-50, 2)]], 'oxide'),
    {'material': 'poly', 'region': 'gate', 'size': 6,
     'rings': [[(-50, 2), (50, 2), gate_corner, (-50, 32)]]},
]
contacts = {'source': [(-100, 0), (-60, 0)], 'drain': [(60, 0), (100, 0)],
            'body': [(-100, -80), (100, -80)], 'gate': [(-50, 32), (40, 32)]}

# %% Sizes by place; options are those of the program, with '_' for '-'.
mesh = cover.mesh_polygons(device, lines=contacts, unit='nm', size={'Si': '2 + 0.2*abs(y)', 'SiO2': 1.5},
                           split_interfaces=120, max_angle=110)
print(mesh)

# %% Arrays: coordinates, triangles, the region and material of each.
corners = mesh.points[mesh.triangles]
u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
areas = (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2
for region in mesh.report['regions']:
    mine = mesh.region == region['id']
    print(f'{region["name"]:10} {mine.sum():5} triangles, area {areas[mine].sum():8.1f} nm^2')

# %% Angles.
lengths = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2)
a, b, c = lengths.T
largest = np.degrees(np.arccos(np.clip((a * a + b * b - c * c) / (2 * a * b), -1, 1)))
print('angles at one corner:', np.round(np.percentile(largest, [0, 50, 100]), 1), 'degrees')
print('largest of all:', round(mesh.report['overall']['largest_angle'], 2), 'degrees')

# %% Contacts: edges by name.
for name in contacts:
    edges = np.concatenate([piece['edges'] for piece in mesh.lines[name]])
    print(f'{name:7} {len(edges):3} edges')

# %% Files and pictures; a mesh is checked against its input, and can be pickled and sent to another process.
mesh.save('transistor.vtu')
mesh.save('transistor.png')
again = pickle.loads(pickle.dumps(mesh))
assert np.array_equal(again.points, mesh.points) and mesh.violations() == []

# %% Errors in words.
try:
    cover.mesh_polygons(device, max_angel=100)
except TypeError as error:
    print(error)
try:
    cover.mesh_polygons(device, size='2 +* y')
except cover.OptionError as error:
    print(error)
