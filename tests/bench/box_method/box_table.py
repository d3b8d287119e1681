#!/usr/bin/env python3
"""What the two grades of the box method take, input by input, as rows of a table.

    box_table.py COVER BENCH_GABRIEL INPUT...

A row each: sides that a vertex encroaches; cuts that are proven to be needed; vertices of the default mesh; cuts and vertices of
--box-method, and negative couplings left; cuts and vertices of --split-interfaces --max-angle 90, and obtuse triangles left (those
above by no more than rounding in brackets); points that CGAL's Gabriel conformer adds, at most 200,000. A line of sums.
"""
import json
import os
import re
import subprocess
import sys
import tempfile


def mesh(program, path, options):
    with tempfile.TemporaryDirectory() as folder:
        report = os.path.join(folder, "r.json")
        subprocess.run([program, "mesh", path, "-q", "--keep-partial", "--report", report, "-o", os.path.join(folder, "m.obj")]
                       + options, check=False, stderr=subprocess.DEVNULL)
        with open(report, encoding="utf-8") as file:
            report = json.load(file)
        return report["mesh"]["cut_vertices"], report["mesh"]["vertices"], report["overall"]


def number(pattern, text):
    found = re.search(pattern, text)
    return int(found.group(1).replace(",", "")) if found else 0


def main():
    program, gabriel, *inputs = sys.argv[1:]
    sums = [0] * 9
    print("| input | encroached | bound | default: vertices | grade 1: cuts | vertices | negative | grade 2: cuts | vertices | obtuse | "
          "Gabriel adds |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    for path in inputs:
        info = subprocess.run([program, "info", path], capture_output=True, text=True, check=True).stdout
        encroached = number(r"Box method: ([\d,]+) of", info)
        bound = number(r"proven to be needed: ([\d,]+)", info)
        _, plain, _ = mesh(program, path, [])
        cuts, vertices, overall = mesh(program, path, ["--box-method"])
        cuts2, vertices2, overall2 = mesh(program, path, ["--split-interfaces", "--max-angle", "90"])
        added = subprocess.run([gabriel, path], capture_output=True, text=True, check=True).stdout.strip()
        negative = overall["box"]["negative_couplings"]
        rounded = overall2.get("obtuse_by_rounding", 0)
        row = [encroached, bound, plain, cuts, vertices, negative, cuts2, vertices2, overall2["obtuse"]]
        sums = [a + b for a, b in zip(sums, row)]
        name = os.path.splitext(os.path.basename(path))[0]
        cells = [f"{x:,}" for x in row[:8]] + [f"{row[8]:,}" + (f" ({rounded:,})" if rounded else "")]
        words = added.split()
        cells.append(" ".join(f"{int(w):,}" if w.isdigit() else w for w in words))
        print("| " + " | ".join([name] + cells) + " |", flush=True)
    print("| all | " + " | ".join(f"{x:,}" for x in sums) + " | |")


if __name__ == "__main__":
    main()
