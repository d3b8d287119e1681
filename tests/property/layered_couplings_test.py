#!/usr/bin/env python3
"""layered_couplings_test.py PROGRAM: devices of layered_devices.py whose finer rest kept inner negative couplings."""
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

import layered_devices

PROGRAM = sys.argv[1]


class LayeredCouplings(unittest.TestCase):
    def test_a_coarser_rest_is_taken(self):
        seed, words = 60003823, ['--layers', 'unnamed_outline=6.28547e-05,1,6', '--box-method']
        r = random.Random(seed)
        kind = r.choice(layered_devices.KINDS)
        device = kind(r)
        with tempfile.TemporaryDirectory() as folder:
            poly, report = pathlib.Path(folder, 'd.poly'), pathlib.Path(folder, 'r.json')
            layered_devices.write_poly(poly, layered_devices.placed(device, r), device.segments)
            subprocess.run([PROGRAM, 'mesh', poly, '-o', pathlib.Path(folder, 'd.vtu'), '-q', '--report', report, *words],
                           check=True, timeout=100)
            said = json.loads(report.read_text())
        self.assertEqual(said['overall']['box']['negative_inside'], 0)
        lines = [line for part in said['regions'] for line in part['layers']]
        self.assertEqual([line['most'] for line in lines], [6] * len(lines))
        self.assertGreater(len(lines), 0)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1])
