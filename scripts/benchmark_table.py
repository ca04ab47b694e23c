#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_rgbd_planes authors
"""Prints the medians in a file of pcl_rgbd_planes_benchmark --benchmark_out as the table of
doc/benchmarks.md. Ratios are of times per point, at the same resolution, or at vga for benchmarks
that name none."""
import json
import math
import sys

if len(sys.argv) != 2:
    sys.exit("usage: benchmark_table.py FILE, written by --benchmark_out with --benchmark_repetitions")
with open(sys.argv[1], encoding="utf-8") as file:
    rows = json.load(file)["benchmarks"]
rows.sort(key=lambda row: row["family_index"])
medians = {row["run_name"]: row for row in rows if row.get("aggregate_name") == "median"}
if not medians:
    sys.exit(f"{sys.argv[1]}: no medians; run with --benchmark_repetitions")


def nanoseconds_per_point(row):
    return row["real_time"] * 1e6 / row["points"]


def ratio(name, other):
    """How many times as long a point takes as with the method other; NaN where it was not run."""
    resolution = name.split("/")[-1]
    peer = medians.get(f"{other}/{resolution if 'vga' in resolution else 'vga'}")
    return nanoseconds_per_point(medians[name]) / nanoseconds_per_point(peer) if peer else math.nan


print("| benchmark | ms | ns per point | times `copy_floor` | times as fast as `pcl_average_3d_gradient` |")
print("|---|---|---|---|---|")
for name, row in medians.items():
    cells = (row["real_time"], nanoseconds_per_point(row), ratio(name, "normals/copy_floor"),
             1 / ratio(name, "normals/pcl_average_3d_gradient"))
    print(f"| `{name}` |", " | ".join(f"{cell:.3g}" for cell in cells), "|")
