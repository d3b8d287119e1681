#!/usr/bin/env python3
"""make_parcels.py FILE: writes a GeoPackage of 5,000 parcels with attributes, in longitudes and latitudes."""
import pathlib
import random
import sqlite3
import struct
import sys

ROWS, COLUMNS = 50, 100
LANDUSE = ('house', 'garden', 'field', 'forest', 'road')
SCHEMA = '''
PRAGMA application_id = 0x47504B47;
PRAGMA user_version = 10300;
CREATE TABLE gpkg_spatial_ref_sys (srs_name TEXT NOT NULL, srs_id INTEGER PRIMARY KEY, organization TEXT NOT NULL,
  organization_coordsys_id INTEGER NOT NULL, definition TEXT NOT NULL, description TEXT);
CREATE TABLE gpkg_contents (table_name TEXT PRIMARY KEY, data_type TEXT NOT NULL, identifier TEXT UNIQUE, description TEXT DEFAULT '',
  last_change DATETIME NOT NULL DEFAULT '2020-01-01T00:00:00.000Z', min_x DOUBLE, min_y DOUBLE, max_x DOUBLE, max_y DOUBLE,
  srs_id INTEGER);
CREATE TABLE gpkg_geometry_columns (table_name TEXT PRIMARY KEY, column_name TEXT NOT NULL, geometry_type_name TEXT NOT NULL,
  srs_id INTEGER NOT NULL, z TINYINT NOT NULL, m TINYINT NOT NULL);
CREATE TABLE parcels (fid INTEGER PRIMARY KEY AUTOINCREMENT, geom BLOB, number TEXT, landuse TEXT, value REAL);
INSERT INTO gpkg_contents (table_name, data_type, identifier, srs_id) VALUES ('parcels', 'features', 'parcels', 4326);
INSERT INTO gpkg_geometry_columns VALUES ('parcels', 'geom', 'POLYGON', 4326, 0, 0);
'''
WGS84 = ('GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],'
         'UNIT["degree",0.0174532925199433],AUTHORITY["EPSG","4326"]]')


def polygon(corners):
    """As a GeoPackage stores it: a head, and well-known binary."""
    ring = [*corners, corners[0]]
    return (b'GP\0\1' + struct.pack('<i', 4326) + struct.pack('<BIII', 1, 3, 1, len(ring)) +
            b''.join(struct.pack('<2d', *p) for p in ring))


def main(path):
    pathlib.Path(path).unlink(missing_ok=True)
    chance = random.Random(17)
    corners = [[(8.5 + (c + 0.3 * chance.random()) * 4e-4, 49.5 + (r + 0.3 * chance.random()) * 3e-4) for c in range(COLUMNS + 1)]
               for r in range(ROWS + 1)]
    with sqlite3.connect(path) as base:
        base.executescript(SCHEMA)
        base.execute('INSERT INTO gpkg_spatial_ref_sys VALUES (?, ?, ?, ?, ?, ?)', ('WGS 84', 4326, 'EPSG', 4326, WGS84, ''))
        for r in range(ROWS):
            for c in range(COLUMNS):
                shape = polygon([corners[r][c], corners[r][c + 1], corners[r + 1][c + 1], corners[r + 1][c]])
                base.execute('INSERT INTO parcels (geom, number, landuse, value) VALUES (?, ?, ?, ?)',
                             (shape, f'{r + 1}/{c + 1}', chance.choice(LANDUSE), round(1000 * chance.random(), 2)))
    base.close()


if __name__ == '__main__':
    main(sys.argv[1])
