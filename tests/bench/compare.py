#!/usr/bin/env python3
"""compare.py OLD.json NEW.json: ratios of two google-benchmark results (new / old)."""
import json
import sys


def load(path):
    with open(path) as f:
        return {b["name"]: b for b in json.load(f)["benchmarks"] if b.get("run_type") != "aggregate"}


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    old, new = load(sys.argv[1]), load(sys.argv[2])
    for name in old:
        if name not in new:
            print(f"{name}: gone")
            continue
        ratios = [f"time {new[name]['real_time'] / old[name]['real_time']:.2f}"]
        for key in ("us_per_triangle", "ratio", "steiner", "bytes", "triangles"):
            if old[name].get(key) and key in new[name]:
                ratios.append(f"{key} {new[name][key] / old[name][key]:.2f}")
        print(f"{name}: " + ", ".join(ratios))
    for name in new.keys() - old.keys():
        print(f"{name}: new")


if __name__ == "__main__":
    main()
