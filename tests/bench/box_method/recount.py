#!/usr/bin/env python3
"""Counts negative couplings of cover's meshes by a program that shares nothing with it.

    recount.py COVER RECOUNT FILE... [-- OPTION...]

RECOUNT is bench_recount (recount_couplings.cpp). Meshes every FILE with OPTIONs and prints those that have a negative coupling on an
inner edge, then the sums: files meshed and refused, negative couplings on inner edges, sides, negative ones on sides that a vertex of
the input encroaches, and on others (with --box-method or --split-interfaces these two are to be added: pieces are no segments).
"""
import os
import subprocess
import sys
import tempfile


def main():
    program, recount, *files = sys.argv[1:]
    options = []
    if "--" in files:
        at = files.index("--")
        files, options = files[:at], files[at + 1:]
    meshed = refused = 0
    sums = [0] * 4
    with tempfile.TemporaryDirectory() as folder:
        node, ele, clean = (os.path.join(folder, name) for name in ("m.node", "m.ele", "clean.poly"))
        for path in files:
            run = subprocess.run([program, "mesh", path, "-q", "-o", ele, "-o", clean, "--ids", "region", *options],
                                 stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
            if run.returncode != 0:
                refused += 1
                if run.returncode not in (2, 3, 5):
                    print("exit", run.returncode, path, run.stderr[:200], flush=True)
                continue
            said = subprocess.run([recount, clean, node, ele], capture_output=True, text=True, check=True).stdout
            counts = [int(word) for word in said.split()]
            meshed += 1
            sums = [a + b for a, b in zip(sums, counts)]
            if counts[0]:
                print("inside", counts, path, flush=True)
    print(f"{meshed} meshed, {refused} refused: {sums[0]} negative inside; of {sums[1]} sides {sums[2]} negative and encroached, "
          f"{sums[3]} negative and not")


if __name__ == "__main__":
    main()
