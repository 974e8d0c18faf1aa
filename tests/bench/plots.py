#!/usr/bin/python3
#  SPDX-License-Identifier: GPL-3.0-or-later
"""usage: tests/bench/plots.py RESULTS PICTURE
Draws the measurements of a soak test (script/soak --csv RESULTS) as PNG or SVG, by
PICTURE's name. Needs Debian's python3-matplotlib."""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

WINDOW = 30  # seconds of a soak test that make a point of its curves
MOST_STOLEN = 1.0  # percent: soak.py judges no seconds with more


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


if len(sys.argv) != 3:
    sys.exit(__doc__)
draw_soak(sys.argv[1])
plt.tight_layout()
plt.savefig(sys.argv[2])
