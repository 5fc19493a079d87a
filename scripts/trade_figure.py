#!/usr/bin/env python3
"""Draw the example trade: the worst touchdown of every design (needs matplotlib).

    scripts/trade_figure.py results/trade/trade-damping-friction.csv results/trade/worst-of-designs.png
"""

import csv
import sys

import matplotlib

matplotlib.use("agg")
from matplotlib import pyplot  # noqa: E402

COMPRESSION = "vehicle.strut.compression_damping"
REBOUND = "vehicle.strut.rebound_damping"
HEIGHT = "vehicle.center_of_gravity_height_ft"
FRICTION = "friction"
DESIGN = (COMPRESSION, REBOUND, HEIGHT, FRICTION)
# Where no landing up to the highest speed searched, 20 ft/s, fails.
BEYOND = 20.0
COLORS = ["#1b9e77", "#7570b3", "#d95f02"]


def worst(path):
    """Lowest first transition of each design over cross-slope and roll, ft/s, and its kind."""
    found = {}
    with open(path, newline="", encoding="utf-8") as table:
        for row in csv.DictReader(table):
            design = tuple(float(row[name]) for name in DESIGN)
            speed = float(row["first_transition_fps"] or BEYOND)
            found[design] = min(found.get(design, (BEYOND, "none")),
                                (speed, row["first_transition_to"]))
    return found


def main():
    """Nine panels: center of gravity height down, friction across."""
    found = worst(sys.argv[1])
    values = [sorted({design[axis] for design in found}) for axis in range(4)]
    compressions, rebounds, heights, frictions = values
    figure, panels = pyplot.subplots(len(heights), len(frictions), figsize=(10, 9),
                                     sharex=True, sharey=True, layout="constrained")
    for row, height in zip(panels, reversed(heights)):
        for panel, friction in zip(row, frictions):
            for rebound, color in zip(rebounds, COLORS):
                line = [found[c, rebound, height, friction] for c in compressions]
                panel.plot(compressions, [speed for speed, _ in line], color=color,
                           label=f"rebound {rebound:g}")
                for compression, (speed, kind) in zip(compressions, line):
                    marker = {"unstable": "o", "bottomed": "s", "none": "^"}[kind]
                    panel.plot(compression, speed, marker, color=color,
                               fillstyle="none" if kind == "none" else "full")
            panel.set_title(f"CG {height:g} ft, friction {friction:g}", fontsize=10)
            panel.set_xscale("log")
            panel.set_xticks(compressions, [f"{c:g}" for c in compressions], minor=False)
            panel.minorticks_off()
            panel.grid(alpha=0.3)
    panels[0][0].legend(title="damping, lb s²/ft²", fontsize=8, title_fontsize=8)
    figure.supxlabel("compression damping, lb s²/ft²")
    figure.supylabel("lowest first transition over cross-slope and roll, ft/s")
    figure.suptitle("What a design can bear at worst\n"
                    "● topples   ■ bottoms a strut   △ neither up to 20 ft/s")
    figure.savefig(sys.argv[2], dpi=110)


if __name__ == "__main__":
    main()
