#!/usr/bin/env python3
"""parcel_values.py FILE: meshes a GeoPackage of parcels; every triangle gets an attribute of its parcel."""
import sqlite3
import sys

import numpy as np

import cover

mesh = cover.mesh_file(sys.argv[1], crs='EPSG:25832', material_field='landuse', name_field='number', method='almond')
values = dict(sqlite3.connect(sys.argv[1]).execute('SELECT number, value FROM parcels'))
by_region = np.array([values[region['name']] for region in mesh.report['regions']])
value = by_region[mesh.region - 1]  # of each triangle

corners = mesh.points[mesh.triangles]
u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
areas = (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2
print(f'{len(by_region)} parcels, {areas.sum() / 1e4:.1f} ha, {(value * areas).sum() / areas.sum():.2f} per square metre')
