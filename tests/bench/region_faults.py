#!/usr/bin/env python3
"""What the quality method reaches on inputs, region by region, and what it takes (python3-numpy).

    region_faults.py COVER[:OPTION]... -- INPUT...

Runs every program on every input with one thread. A line each: user time of the run, microseconds of
it per triangle in the meshing stage, triangles; mean, 90th percentile and worst of the balanced fault
of regions; the largest angle, triangles above 120 degrees, the smallest angle; regions with an angle
below 1 degree; regions whose smallest angle is below a third of the almond method's though their
largest one is not smaller by 10 degrees; regions with two vertices nearer than a thousandth of their
shortest side; per cent of the regions whose largest angle meets its target or is proven to be within
a degree of the best, per cent whose smallest one is, and per cent of those of which that is proven
among the meshes alone that have no other negative couplings, by the largest and the smallest angle
(libcover/docs/limits.md). The almond method is that of the first program.

The fault of a region is the larger of (largest - target) / (180 - target), where target is 100
degrees or gamma_opt if that is more, and (20 - smallest) / 20; 0 at least. Angles between two sides
are the input's and count in no smallest angle. What the input forces otherwise is not known here: it
is the same for all programs.
"""
import json
import os
import resource
import subprocess
import sys
import tempfile

import numpy as np


def table(path):
    with open(path, encoding="utf-8") as file:
        next(file)
        return np.array([line.split() for line in file if line[0] != "#"], dtype=float)


def run(program, options, path):
    with tempfile.TemporaryDirectory() as folder:
        report, mesh = os.path.join(folder, "r.json"), os.path.join(folder, "m")
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        subprocess.run([program, "mesh", path, "-j", "1", "-q", "--keep-partial", "--report", report,
                        "-o", mesh + ".ele"] + options, check=True)
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        with open(report, encoding="utf-8") as file:
            report = json.load(file)
        return report, seconds, shape(table(mesh + ".node"), table(mesh + ".ele"), table(mesh + ".edge"))


def shape(nodes, triangles, segments):
    """By region: the smallest angle that is not between two sides, and the shortest edge in shortest
    sides."""
    points = nodes[:, 1:3]
    v = triangles[:, 1:4].astype(int) - 1
    region = triangles[:, -1].astype(int)
    ends = np.sort(segments[:, 1:3].astype(int) - 1, axis=1)
    key = lambda e: e[:, 0].astype(np.int64) * len(points) + e[:, 1]
    sides = np.unique(key(ends))
    p = [points[v[:, i]] for i in range(3)]
    edge = [np.sort(np.stack([v[:, (i + 1) % 3], v[:, (i + 2) % 3]], axis=1), axis=1) for i in range(3)]
    is_side = [np.isin(key(e), sides) for e in edge]
    length = [np.linalg.norm(p[(i + 1) % 3] - p[(i + 2) % 3], axis=1) for i in range(3)]
    count = region.max() + 1
    smallest, shortest, side = (np.full(count, np.inf) for _ in range(3))
    for i in range(3):
        a, b = p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]
        angle = np.degrees(np.arctan2(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0], (a * b).sum(axis=1)))
        own = ~(is_side[(i + 1) % 3] & is_side[(i + 2) % 3])
        np.minimum.at(smallest, region[own], angle[own])
        np.minimum.at(shortest, region, length[i])
        np.minimum.at(side, region[is_side[i]], length[i][is_side[i]])
    with np.errstate(invalid="ignore"):  # numbers that no region has
        return smallest, shortest / side


def fault(region, smallest):
    target = max(100.0, region["gamma_opt"])
    wide = (region["largest_angle"] - target) / (180 - target) if target < 179.999 else 0.0
    return max(0.0, wide, (20 - smallest) / 20)


def share(regions, of, *answers):
    """Per cent of the regions where what is known of the best angle `of` is one of `answers`."""
    return 100 * sum(1 for r in regions if r.get("limits", {}).get(of) in answers) / len(regions)


def print_row(path, program, result, almond):
    report, seconds, (smallest, edges) = result
    regions = [r for r in report["regions"] if r["triangles"] > 0]
    of_almond = {r["id"]: r["largest_angle"] for r in almond[0]["regions"]}
    faults = sorted(fault(r, smallest[r["id"]]) for r in regions)
    # Stages are timed by the clock on the wall: on a busy machine only their shares count.
    times = {t["stage"]: t["seconds"] for t in report["times"]}
    mesh = seconds * times["mesh"] / sum(times.values())
    lopsided = sum(1 for r in regions if smallest[r["id"]] < almond[2][0][r["id"]] / 3
                   and r["largest_angle"] > of_almond[r["id"]] - 10)
    overall = report["overall"]
    print("%-24s %-24s %7.2f %7.1f %7d %7.4f %7.4f %7.4f %8.3f %6d %8.4f %5d %5d %5d %6.1f %6.1f %6.1f %6.1f" % (
        os.path.basename(path)[:24], program[:24], seconds, 1e6 * mesh / overall["triangles"],
        overall["triangles"], sum(faults) / len(faults), faults[min(len(faults) - 1, int(0.9 * len(faults)))],
        faults[-1], overall["largest_angle"], overall["above_120"], min(smallest),
        sum(1 for r in regions if smallest[r["id"]] < 1), lopsided,
        sum(1 for r in regions if edges[r["id"]] < 1e-3),
        share(regions, "largest", "met", "optimal", "near"), share(regions, "smallest", "met", "optimal", "near"),
        share(regions, "largest", "coupled"), share(regions, "smallest", "coupled")), flush=True)


def main():
    split = sys.argv.index("--")
    programs, inputs = sys.argv[1:split], sys.argv[split + 1:]
    print("%-24s %-24s %7s %7s %7s %7s %7s %7s %8s %6s %8s %5s %5s %5s %6s %6s %6s %6s" % (
        "input", "program", "user s", "us/tri", "tri", "mean", "90 %", "worst", "largest", ">120", "smallest",
        "<1", "third", "near", "large%", "small%", "coupl%", "c.sm.%"))
    for path in inputs:
        almond = run(programs[0].split(":")[0], ["--method", "almond"], path)
        print_row(path, "almond", almond, almond)
        for program in programs:
            name, *options = program.split(":")
            print_row(path, " ".join([os.path.basename(name)] + options), run(name, options, path), almond)


if __name__ == "__main__":
    main()
