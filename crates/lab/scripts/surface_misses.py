#!/usr/bin/env python3
"""First transitions of the surface of Figure 4-20 that are too high, for docs/notes/skips.md.

    crates/lab/scripts/surface_misses.py write DIR       # DIR/truth.toml, DIR/parts-1.toml, DIR/parts-8.toml ...
    touchdown sweep DIR/*.toml --out DIR                 # half an hour on two cores
    crates/lab/scripts/surface_misses.py table DIR

The truth lands at every 0.025 ft/s from 10.5 to 20 ft/s, and counts up to 20 ft/s.
"""

import csv
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
PARTS = (1, 4, 8)
HIGHEST = 20.0


def write(folder):
    text = (ROOT / "sweeps/surface-4-20.toml").read_text()
    text = text.replace('"vehicles/', f'"{ROOT}/sweeps/vehicles/')

    def put(name, **values):
        changed = text
        for key, value in values.items():
            line = f"{key} = {value}"
            changed, found = re.subn(rf"(?m)^{key} = .*$", line, changed)
            if not found:
                changed = changed.replace("[search]", f"[search]\n{line}")
        (folder / f"{name}.toml").write_text(changed)

    put("truth", from_fps=10.5, to_fps=HIGHEST, scan_step_fps=0.025, scan='"full"', scan_looseness=1, parts_below=1)
    for parts in PARTS:
        put(f"parts-{parts}", parts_below=parts)


def transitions(file):
    with open(file) as table:
        rows = list(csv.DictReader(table))
    place = lambda row: (row["cross_slope_deg"], row["roll_deg"])
    speed = lambda row: float(row["first_transition_fps"] or "inf")
    work = [sum(int(row[column]) for row in rows) / len(rows) for column in ("landings", "derivative_evaluations")]
    return {place(row): speed(row) for row in rows}, work


def table(folder):
    truth, _ = transitions(folder / "truth.csv")
    truth = {place: speed for place, speed in truth.items() if speed < HIGHEST}
    print(f"{len(truth)} transitions")
    for parts in PARTS:
        found, (landings, evaluations) = transitions(folder / f"parts-{parts}.csv")
        above = [found[place] - speed for place, speed in truth.items()]
        counts = [sum(excess > limit for excess in above) for limit in (0.01, 0.05, 0.1, 0.3)]
        missed = sum(excess == float("inf") for excess in above)
        print(f"{parts}: {landings:.1f} landings, {evaluations:.0f} evaluations; too high {counts}, missed {missed}")


if __name__ == "__main__":
    {"write": write, "table": table}[sys.argv[1]](Path(sys.argv[2]))
