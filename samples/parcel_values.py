#!/usr/bin/env python3
"""parcel_values.py FILE: meshes a GeoPackage of parcels; every triangle gets an attribute of its parcel."""
import sys

import cover

mesh = cover.mesh_file(sys.argv[1], crs='EPSG:25832', material_field='landuse', name_field='number', keep_field='value',
                       method='almond')
by_region = mesh.attributes['value']
value = by_region[mesh.region - 1]  # of each triangle

corners = mesh.points[mesh.triangles]
u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
areas = (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2
print(f'{len(by_region)} parcels, {areas.sum() / 1e4:.1f} ha, {(value * areas).sum() / areas.sum():.2f} per square metre')
