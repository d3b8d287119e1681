#!/usr/bin/env python3
"""pages_test.py PROGRAM SAMPLES PAGE [MODULE]: runs the commands of a page in samples/, as they stand there, and looks at what
they made. Commands of programs that are not installed are left out."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PROGRAM, SAMPLES, PAGE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3]
MODULE = sys.argv[4] if len(sys.argv) > 4 else ''


def run_page(folder):
    """The output of all commands."""
    (folder / 'bin').mkdir()
    (folder / 'bin/cover').symlink_to(PROGRAM)
    (folder / 'bin/python3').write_text(f'#!/bin/sh\nexec {sys.executable} "$@"\n')  # the one that the module is for
    (folder / 'bin/python3').chmod(0o755)
    environment = {**os.environ, 'PATH': f'{folder / "bin"}:{os.environ["PATH"]}', 'PYTHONPATH': MODULE}
    blocks = re.findall(r'^```sh\n(.*?)^```', (SAMPLES / f'{PAGE}.md').read_text(), re.M | re.S)
    assert blocks, f'no commands in {PAGE}.md'
    text = ''
    for command in '\n'.join(blocks).replace('\\\n', ' ').splitlines():
        if not command:
            continue
        name = command.split()[0]
        if not shutil.which(name, path=environment['PATH']) or (name == 'python3' and 'values' in command and not MODULE):
            print(f'left out: {command}')
            continue
        done = subprocess.run(['bash', '-c', command], cwd=folder / 'samples', env=environment, text=True, timeout=100,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        print(f'$ {command}\n{done.stdout}')
        assert done.returncode == 0, f'exit code {done.returncode}'
        text += done.stdout
    return text



def contacts(program, path):
    """Names of regions and lines of a mesh that has them, by its conversion to a manifest."""
    subprocess.run([program, 'convert', path, '-o', path.with_suffix('.json'), '-q'], check=True, timeout=100)
    told = json.loads(path.with_suffix('.json').read_text())
    return [region['name'] for region in told['regions']], {line['name'] for line in told['lines']}


def check_finfet(folder, text):
    regions, lines = contacts(PROGRAM, folder / 'finfet.vtm')
    assert sorted(regions) == ['HfO2', 'STI', 'STI', 'STI', 'Si', 'SiO2', 'SiO2', 'TiN'], regions
    assert {'gate', 'bulk'} <= lines, lines
    assert '"gate"' in (folder / 'finfet.msh').read_text()
    regions, _ = contacts(PROGRAM, folder / 'one_fin.vtm')
    assert sorted(regions) == ['HfO2', 'STI', 'STI', 'Si', 'SiO2', 'TiN'], regions
    assert (folder / 'finfet.png').stat().st_size > 10000
    assert text.count('Box method: no negative coupling') == 2, text
    regions, lines = contacts(PROGRAM, folder / 'finfet_layers.vtm')
    assert sorted(regions) == ['fin', 'gate', 'oxide', 'trench', 'trench'], regions
    assert '"fin_oxide"' in (folder / 'finfet_layers.msh').read_text()


def check_motor(folder, text):
    regions, lines = contacts(PROGRAM, folder / 'motor.vtm')
    assert sorted(regions) == sorted(['A+', 'A-', 'B+', 'B-', 'C+', 'C-', 'gap', 'rotor', 'stator']), regions
    assert 'frame' in lines, lines
    labels = {line.split()[3] for line in triangles_of(folder / 'motor.mesh')}
    assert len(labels) == 9, labels
    if shutil.which('FreeFem++-nw'):
        found = re.search(r'flux of A: (\S+), of B: (\S+), of C: (\S+)', text)
        flux = [float(x) for x in found.groups()]
        # Three phases with currents 1, -1/2, -1/2: so are their fluxes, by symmetry.
        assert flux[0] > 0 and abs(flux[1] / flux[0] + 0.5) < 0.01 and abs(flux[2] / flux[0] + 0.5) < 0.01, flux


def triangles_of(path):
    lines = path.read_text().splitlines()
    start = lines.index('Triangles')
    return lines[start + 2:start + 2 + int(lines[start + 1])]


def check_parcels(folder, text):
    told = json.loads((folder / 'parcels.json').read_text())
    assert len(told['regions']) == 5000
    assert {region['material_name'] for region in told['regions']} == {'house', 'garden', 'field', 'forest', 'road'}
    assert told['unit'] == 'm', told['unit']
    if MODULE:
        parcels, hectares, value = re.search(r'(\d+) parcels, ([\d.]+) ha, ([\d.]+) per square metre', text).groups()
        # 0.04 degrees of longitude at 49.5 degrees are 2.9 km, 0.015 of latitude 1.67 km.
        assert parcels == '5000' and 470 < float(hectares) < 500 and 450 < float(value) < 550, text


def check_grains(folder, text):
    told = json.loads((folder / 'grains.json').read_text())
    # At sharp corners of 20 grains a pixel stands alone.
    assert len(told['regions']) == 1020 and len({region['material'] for region in told['regions']}) == 1000
    assert told['unit'] == 'um'
    assert abs(sum(region['area'] for region in told['regions']) - 256**2) < 1e-6 * 256**2
    areas = sorted(region['area'] for region in told['regions'])
    assert areas[0] > 0.1 and 40 < areas[510] < 70 and areas[-1] < 400, areas
    assert (folder / 'grains.png').stat().st_size > 10000
    regions = [region['name'] for region in json.loads((folder / 'phases.json').read_text())['regions']]
    assert len(regions) == 1018 and regions.count('ferrite') == 2, len(regions)


def check_tcad(folder, text):
    for name, materials in ('nmos', ['Oxide', 'Poly', 'Si']), ('str', ['Poly', 'Si', 'SiO2']):
        regions, lines = contacts(PROGRAM, folder / f'{name}.vtm')
        assert sorted(regions) == materials, regions
        if name == 'nmos':
            assert {'source', 'drain', 'gate', 'bulk'} <= lines, lines
    regions, lines = contacts(PROGRAM, folder / 'deck.vtm')
    assert sorted(regions) == ['R.Bulk', 'R.Gate', 'R.GateOx', 'R.Spacer', 'R.Spacer'], regions
    assert {'source', 'drain', 'gate', 'bulk'} <= lines, lines
    for words in 'not understood and left out: sdegeo:fillet-2d (line 37)', 'commands of doping and meshing are left out':
        assert words in text, words


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shutil.copytree(SAMPLES, folder / 'samples')
        text = run_page(folder)
        globals()[f'check_{PAGE}'](folder / 'samples', text)


if __name__ == '__main__':
    main()
