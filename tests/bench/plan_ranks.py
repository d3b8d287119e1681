#!/usr/bin/env python3
"""plan_ranks.py REPORT...: what more ranks would bring, from the times that a run reports.

REPORT is what `cover mesh ... -j 1 --report REPORT.json` wrote. The run is played again: reading,
cleaning, regions and splitting on one core of rank 0, as they were measured; the regions handed out
as cover-mpi does, the largest first, each request a quarter of the asker's part of what is left,
with every message through rank 0; then the file, joined by rank 0 at the bandwidth of a disk. No
rank is faster or slower than the machine of the report.
"""
import argparse
import heapq
import json

LATENCY = 20e-6    # seconds for a message
NETWORK = 1e9      # bytes per second
DISK = 1e9         # bytes per second of the file system
BOUNDARY = 60      # bytes of a region's boundary for each of its vertices, as cover-mpi sends it
REGION = 700       # bytes of a region's report
TRIANGLE = 16      # bytes of a triangle and its part of Steiner vertices on the way back
FILE = 85          # bytes of a triangle in a .vtkhdf


def play(report, ranks, threads, read):
    """Seconds of a run: (serial, meshing, writing, messages at rank 0)."""
    times = {t['stage']: t['seconds'] for t in report['times']}
    serial = read + sum(times.get(stage, 0) for stage in ('clean', 'regions', 'split'))
    regions = sorted(report['regions'], key=lambda r: -r['input_vertices'])
    costs = [2 * r['input_vertices'] + 1 for r in regions]
    left, at, busy, sending = sum(costs), 0, 0.0, 0.0
    takers = ranks * threads
    # Who is free first asks first; rank 0 answers one at a time.
    free = [(0.0, k) for k in range(takers)]
    heapq.heapify(free)
    end = 0.0
    while at < len(regions):
        now, who = heapq.heappop(free)
        part, taken, seconds, sent = max(1000, left / (4 * takers)), 0, 0.0, 0
        while at < len(regions) and taken < part:
            region = regions[at]
            taken += costs[at]
            left -= costs[at]
            seconds += region['seconds']
            sent += BOUNDARY * region['input_vertices'] + REGION + TRIANGLE * region['triangles']
            at += 1
        if who >= threads:  # not on rank 0
            start = max(now, busy)
            sending += 2 * LATENCY + sent / NETWORK
            now = busy = start + 2 * LATENCY + sent / NETWORK
        heapq.heappush(free, (now + seconds, who))
        end = max(end, now + seconds)
    triangles = sum(r['triangles'] for r in regions)
    return serial, end, FILE * triangles / DISK, sending


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('reports', nargs='+')
    parser.add_argument('--ranks', type=int, nargs='+', default=[1, 2, 8, 64, 512])
    parser.add_argument('--threads', type=int, default=1, help='of a rank')
    parser.add_argument('--read', type=float, default=0, help='seconds that reading the input takes')
    asked = parser.parse_args()
    for path in asked.reports:
        with open(path, encoding='utf-8') as file:
            report = json.load(file)
        triangles = sum(r['triangles'] for r in report['regions'])
        meshing = sum(r['seconds'] for r in report['regions'])
        serial, _, writing, _ = play(report, 1, 1, asked.read)
        largest = max(r['seconds'] for r in report['regions'])
        print(f'{path}: {len(report["regions"]):,} regions, {triangles:,} triangles; serial {serial:.2f} s, meshing '
              f'{meshing:.2f} s, largest region {largest:.3f} s, writing {writing:.2f} s')
        print(f'  Amdahl: at most {(serial + meshing + writing) / (serial + writing):.1f} with writing, '
              f'{(serial + meshing) / serial:.1f} without')
        one = None
        for ranks in asked.ranks:
            serial, mesh, writing, messages = play(report, ranks, asked.threads, asked.read)
            total = serial + mesh + writing
            one = one or total
            print(f'  {ranks:4} ranks: {total:8.2f} s = {serial:.2f} + {mesh:.2f} + {writing:.2f}; speed-up '
                  f'{one / total:5.1f}; messages {messages:.2f} s')


if __name__ == '__main__':
    main()
