#!/usr/bin/env python3
"""What a conforming triangulation without obtuse angles adds to the inputs of conforming.py.

    conforming_points.py COVER [OPTION...]

Runs `COVER mesh INPUT --split-interfaces --max-angle 90 OPTION...` with one thread on each of the 30 and tells, by kind
and in total: points added, how many of them on segments, obtuse triangles left, those that are obtuse exactly and no more than rounding makes them (where the
program tells), the median of the smallest angles in degrees, and user seconds, with those of the slowest input.
"""
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile

import conforming


def run(program, options, kind, size):
    with tempfile.TemporaryDirectory() as folder:
        path, report = os.path.join(folder, "in.json"), os.path.join(folder, "r.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(conforming.make(kind, size, 0), file)
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        subprocess.run([program, "mesh", path, "--split-interfaces", "--max-angle", "90", "-j", "1", "-q",
                        "--keep-partial", "--report", report, "-o", os.path.join(folder, "m.obj")] + options, check=False)
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        with open(report, encoding="utf-8") as file:
            return json.load(file), seconds


def main():
    program, options = sys.argv[1], sys.argv[2:]
    total = [0, 0, 0, 0, 0.0]
    angles, slowest = [], 0
    print("kind             added  on segments  obtuse  by rounding  smallest  seconds  slowest")
    for kind in conforming.KINDS:
        sums, its_angles, its_slowest = [0, 0, 0, 0, 0.0], [], 0
        for size in conforming.SIZES:
            report, seconds = run(program, options, kind, size)
            cuts, angles_of = report["mesh"]["cut_vertices"], report["overall"]
            new = [cuts + report["mesh"]["steiner_vertices"], cuts, angles_of["obtuse"],
                   angles_of.get("obtuse_by_rounding", 0), seconds]
            sums = [a + b for a, b in zip(sums, new)]
            its_angles.append(angles_of["smallest_angle"])
            its_slowest = max(its_slowest, seconds)
        print_row(kind, sums, its_angles, its_slowest)
        total = [a + b for a, b in zip(total, sums)]
        angles += its_angles
        slowest = max(slowest, its_slowest)
    print_row("all", total, angles, slowest)


def print_row(name, sums, angles, slowest):
    print(f"{name:16}{sums[0]:6d}{sums[1]:13d}{sums[2]:8d}{sums[3]:13d}{statistics.median(angles):10.2f}{sums[4]:9.2f}"
          f"{slowest:9.2f}")


if __name__ == "__main__":
    main()
