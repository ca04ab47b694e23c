#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_rgbd_planes authors
"""Renews the tables of benchmarks.md, each between a comment that names it and "<!-- end -->",
and the plots, from the results of scripts/benchmark.sh."""
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

RESOLUTIONS = ("vga", "qvga", "qqvga")
PIXELS = {"vga": "640 x 480", "qvga": "320 x 240", "qqvga": "160 x 120"}
# Holz et al. (2011), figure 6(c)
PAPER_HZ = {"vga": "7", "qvga": "27", "qqvga": "30"}


def read(folder, name, key):
    with open(folder / name, encoding="utf-8") as file:
        try:
            return json.load(file)[key]
        except (ValueError, KeyError):
            sys.exit(f"{folder / name}: damaged; run scripts/benchmark.sh anew")


class Speed:
    """Medians of the benchmarks."""

    def __init__(self, rows):
        rows = sorted(rows, key=lambda row: row["family_index"])
        self.rows = {row["run_name"]: row for row in rows
                     if row.get("aggregate_name") == "median"}
        if not self.rows:
            sys.exit("no medians: run the benchmarks with --benchmark_repetitions")

    def instructions(self):
        """Sets of instructions, the widest first."""
        return [name.split("/")[-1] for name in self.rows if "/all_instructions/" in name]

    def ms(self, name):
        return self.rows[name]["real_time"]

    def nanoseconds_per_point(self, name):
        return self.ms(name) * 1e6 / self.rows[name]["points"]

    def ratio(self, name, other):
        """How many times as long a point takes as with the method other, at the same
        resolution, or at vga for benchmarks that name none; NaN where it was not run."""
        resolution = name.split("/")[-1]
        peer = f"{other}/{resolution if resolution in RESOLUTIONS else 'vga'}"
        if peer not in self.rows:
            return math.nan
        return self.nanoseconds_per_point(name) / self.nanoseconds_per_point(peer)

    def stages(self, resolution):
        """Time of each stage of the pipeline, in ms."""
        normals = self.ms(f"normals/tangent/{resolution}")
        planes = self.rows[f"planes/normal_space/{resolution}"]
        clusters = planes["normal_space_ms"], planes["distance_space_ms"]
        objects = self.ms(f"objects/supported_split/{resolution}")
        return {"normals": normals, "normal space": clusters[0], "distance space": clusters[1],
                "refinement": planes["real_time"] - normals - sum(clusters),
                "objects": objects - planes["real_time"],
                "obstacles": self.ms(f"obstacles/detection/{resolution}")}


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def speed_table(speed):
    rows = []
    for name in speed.rows:
        if "_instructions/" in name:
            continue
        cells = (speed.ms(name), speed.nanoseconds_per_point(name),
                 speed.ratio(name, "normals/copy_floor"),
                 1 / speed.ratio(name, "normals/pcl_average_3d_gradient"))
        rows.append([f"`{name}`", *(f"{cell:.3g}" for cell in cells)])
    return table(["benchmark", "ms", "ns per point", "times `copy_floor`",
                  "times as fast as `pcl_average_3d_gradient`"], rows)


def stage_table(speed):
    rows = []
    for resolution in RESOLUTIONS:
        stages = speed.stages(resolution)
        all_ms = speed.ms(f"pipeline/all/{resolution}")
        omps = speed.ms(f"planes/pcl_omps/{resolution}")
        rows.append([PIXELS[resolution], *(f"{ms:.2f}" for ms in stages.values()),
                     f"{all_ms:.2f}", f"{1000 / all_ms:.0f}", PAPER_HZ[resolution],
                     f"{omps / speed.ms(f'planes/normal_space/{resolution}'):.1f}"])
    names = [f"{name} ms" for name in speed.stages("vga")]
    return table(["size", *names, "all ms", "Hz", "Hz of the paper",
                  "normals and planes: times as fast as PCL's"], rows)


def instruction_table(speed):
    rows = []
    for instructions in speed.instructions():
        times = [speed.ms(f"{name}_instructions/{instructions}")
                 for name in ("normals/tangent", "planes/normal_space", "pipeline/all")]
        rows.append([f"`{instructions}`", *(f"{ms:.2f}" for ms in times),
                     f"{1000 / times[-1]:.0f}"])
    return table(["instructions", "normals ms", "normals and planes ms", "everything ms", "Hz"],
                 rows)


def accuracy_table(normals):
    methods = list(dict.fromkeys(row["method"] for row in normals))
    cells = {(row["method"], row["resolution"]): row for row in normals}
    rows = []
    for method in methods:
        row = [f"`{method}`"]
        for resolution in RESOLUTIONS:
            cell = cells[method, resolution]
            row.append(f"{cell['ms_median']:.2f} / {cell['mean_deg']:.2f} / "
                       f"{cell['over_25_percent']:.2f} / {cell['coverage_percent']:.1f}")
        rows.append(row)
    return table(["method", *(resolution.upper() for resolution in RESOLUTIONS)], rows)


def plane_table(planes):
    rows = []
    for row in planes:
        rows.append([f"`{row['method']}`", row["resolution"].upper(), f"{row['ms_median']:.2f}",
                     f"{row['ms_worst'] / row['ms_median']:.2f}",
                     f"{100 * row['correct_80'] / row['planes_truth']:.1f}",
                     f"{row['f1_50']:.3f}",
                     f"{100 * row['noise'] / max(row['planes_found'], 1):.1f}",
                     f"{row['median_angle_error_deg']:.2f}",
                     f"{row['median_distance_error_mm']:.1f}"])
    return table(["method", "size", "ms", "worst over median", "correct %", "F1", "noise %",
                  "angle deg", "distance mm"], rows)


def renew(text, name, content):
    pattern = re.compile(rf"(<!-- table: {name} -->\n).*?(<!-- end -->)", re.DOTALL)
    text, count = pattern.subn(lambda match: f"{match[1]}{content}\n{match[2]}", text)
    if count != 1:
        sys.exit(f"benchmarks.md: needs one '<!-- table: {name} -->' with its '<!-- end -->'")
    return text


def plot(file, commands, rows):
    """Runs gnuplot on rows of data, which the commands call $data."""
    data = "$data << EOD\n" + "\n".join(rows) + "\nEOD\n"
    script = (f"set terminal pngcairo noenhanced size 760,420 font 'sans,10'\n"
              f"set output '{file}'\nset grid\n{data}{commands}\n")
    messages = subprocess.run(["gnuplot", "-"], input=script, text=True, check=False,
                              stderr=subprocess.PIPE).stderr
    if not file.exists() or b"IEND" not in file.read_bytes()[-12:]:
        sys.exit(f"{file.name}: gnuplot cannot write it (is the disk full?) "
                 f"{' '.join(messages.split())}".rstrip())


def plot_stages(speed, file):
    names = list(speed.stages("vga"))
    rows = [" ".join([f'"{PIXELS[resolution]}"',
                      *(str(ms) for ms in speed.stages(resolution).values())])
            for resolution in RESOLUTIONS]
    bars = ", ".join(f"$data using {k + 2}:xtic(1) title '{name}'"
                     for k, name in enumerate(names))
    plot(file, "set style data histograms\nset style histogram rowstacked\n"
               "set style fill solid border -1\nset boxwidth 0.6\nset ylabel 'ms on one core'\n"
               f"set yrange [0:*]\nplot {bars}", rows)


def plot_points(speed, file):
    names = [name for name in speed.rows if "/tangent_points/" in name]
    rows = [f"{speed.rows[name]['points'] / 1e6} {speed.ms(name)}" for name in names]
    slope = speed.nanoseconds_per_point(names[0])
    plot(file, "set xlabel 'megapixels'\nset ylabel 'ms'\nset key left\nset xrange [0:*]\n"
               "set yrange [0:*]\nplot $data with points pointtype 7 title 'normals', "
               f"{slope} * x title 'as the smallest, point by point'", rows)


def plot_scatter(rows, name, value, label, file):
    """Time, on a logarithmic axis, against a figure; ours are filled circles."""
    points = [f"{row['ms_median']} {row[value]}" for row in rows]
    marks = iter(range(1, 100))
    curves = []
    for k, row in enumerate(rows):
        ours = row["method"].startswith(("tangent", "normal_space"))
        style = "pointtype 7 pointsize 1.5" if ours else f"pointtype {next(marks) % 6 + 1}"
        curves.append(f"$data every ::{k}::{k} with points {style} title '{name(row)}'")
    plot(file, "set logscale x\nset xlabel 'ms per frame'\nset key outside right top\n"
               f"set ylabel '{label}'\nset yrange [0:*]\nplot {', '.join(curves)}", points)


def plot_accuracy(normals, file):
    rows = [f"\"{row['method']}\" {row['mean_deg']} {row['over_25_percent']}"
            for row in sorted(normals, key=lambda row: row["mean_deg"])]
    plot(file, "set style data histograms\nset style fill solid\nset bmargin 10\nset rmargin 8\nset key left\n"
               "set xtics rotate by -40 font ',9'\nset yrange [0:*]\n"
               "plot $data using 2:xtic(1) title 'mean deviation, degrees', "
               "$data using 3 title 'above 25 degrees, percent'", rows)


def draw(speed, normals, planes, images):
    at_vga = [row for row in normals if row["resolution"] == "vga"]
    plot_stages(speed, images / "benchmark_stages.png")
    plot_points(speed, images / "benchmark_points.png")
    plot_accuracy(at_vga, images / "benchmark_normals.png")
    plot_scatter(at_vga, lambda row: row["method"], "mean_deg", "mean deviation, degrees",
                 images / "benchmark_normals_speed.png")
    plot_scatter(planes, lambda row: f"{row['method']} {row['resolution']}", "f1_50",
                 "F1 at IoU 0.5", images / "benchmark_planes_speed.png")


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: benchmark_report.py RESULTS DOC")
    results, doc = map(pathlib.Path, sys.argv[1:])
    speed = Speed(read(results, "speed.json", "benchmarks"))
    normals = read(results, "normals.json", "results")
    planes = read(results, "planes.json", "results")
    page = doc / "benchmarks.md"
    text = page.read_text(encoding="utf-8")
    for name, content in (("stages", stage_table(speed)), ("speed", speed_table(speed)),
                          ("instructions", instruction_table(speed)),
                          ("normals", accuracy_table(normals)), ("planes", plane_table(planes))):
        text = renew(text, name, content)
    with tempfile.TemporaryDirectory(prefix=".benchmarks_", dir=doc) as folder:
        new = pathlib.Path(folder)
        draw(speed, normals, planes, new)
        (new / page.name).write_text(text, encoding="utf-8")
        for image in new.glob("*.png"):
            image.replace(doc / "images" / image.name)
        (new / page.name).replace(page)


try:
    main()
except OSError as error:
    sys.exit(f"{error.filename}: {error.strerror}")
except KeyboardInterrupt:
    sys.exit("interrupted; nothing was written")
