#!/usr/bin/python3
#  SPDX-License-Identifier: GPL-3.0-or-later
"""usage: tests/bench/plots.py RESULTS PICTURE
Draws the measurements of a soak test (script/soak --csv RESULTS), or of a
benchmark (RESULTS is its bench.json), as PNG or SVG by PICTURE's name. Needs Debian's
python3-matplotlib."""

import csv
import json
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

SHARES = ("median", "p99", "p999", "max")
WINDOW = 30  # seconds of a soak test that make a point of its curves
MOST_STOLEN = 1.0  # percent: Soak_Records judges no seconds with more


def draw_soak(path: str) -> None:
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))

    def column(name: str, of: list[dict[str, str]] = rows) -> list[float]:
        return [float(row[name]) for row in of if row[name]]

    minutes = [second / 60 for second in column("second")]
    _, panels = plt.subplots(5, sharex=True, figsize=(9, 12))
    for panel, title in zip(
        panels,
        (
            "resident memory, MB (strokes: faults)",
            "descriptors and threads",
            "answer to a command, ms, per half minute",
            "images a second, per half minute",
            "taken by the host, % (seconds with more than 1 are not judged)",
        ),
        strict=True,
    ):
        panel.set_title(title, loc="left", fontsize="medium")
    panels[0].plot(minutes, [kb / 1024 for kb in column("memory_kb")])
    for row in rows:
        if row["fault_begun"]:
            panels[0].axvline(float(row["second"]) / 60, ymin=0.95)
    for name in "threads", "descriptors":
        panels[1].step(minutes, column(name), label=name)
    windows = [
        [
            row
            for row in rows[first : first + WINDOW]
            if row["calm"] == "1" and float(row["stolen_percent"]) <= MOST_STOLEN
        ]
        for first in range(0, len(rows), WINDOW)
    ]
    windows = [window for window in windows if column("median_ms", window)]
    middles = [column("second", window)[0] / 60 for window in windows]
    for name in "maximum", "p99", "median":
        values = [sorted(column(f"{name}_ms", window)) for window in windows]
        panels[2].semilogy(
            middles,
            [some[-1 if name != "median" else len(some) // 2] for some in values],
            label=name,
        )
    panels[3].plot(
        middles, [sum(column("images", window)) / len(window) for window in windows]
    )
    panels[4].plot(minutes, column("stolen_percent"))
    panels[4].set_xlabel("minutes")
    for panel in panels[1:3]:
        panel.legend()
    for panel in panels[0], panels[1], panels[3]:
        panel.set_ylim(bottom=0)


def draw_bench(path: str) -> None:
    with open(path, encoding="utf-8") as file:
        sections = json.load(file)["sections"]
    for section in sections:
        section["rows"] = [row for row in section["rows"] if "median" in row]
    sections = [section for section in sections if section["rows"]]
    sizes = [len(section["rows"]) + 2 for section in sections]
    _, panels = plt.subplots(
        len(sections),
        squeeze=False,
        figsize=(11, sum(sizes) / 4),
        gridspec_kw={"height_ratios": sizes},
    )
    for (panel,), section in zip(panels, sections, strict=True):
        panel.set_title(section["title"] + ", us: ours (o), floor (x)")
        panel.set_xscale("log")
        names = [row["name"] for row in section["rows"]]
        for share in SHARES:
            for key, marker in (share, "o"), (f"floor_{share}", "x"):
                points = [
                    (row[key], row["name"]) for row in section["rows"] if row.get(key)
                ]
                panel.scatter(
                    *zip(*points, strict=True) if points else ((), ()),
                    marker=marker,
                    color=f"C{SHARES.index(share)}",
                    label=share if marker == "o" else None,
                )
        panel.set_yticks(range(len(names)), names)
        panel.invert_yaxis()
    panels[0][0].legend()


if len(sys.argv) != 3:
    sys.exit(__doc__)
(draw_bench if sys.argv[1].endswith(".json") else draw_soak)(sys.argv[1])
plt.tight_layout()
plt.savefig(sys.argv[2])
