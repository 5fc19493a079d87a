#!/usr/bin/env python3
"""Errors of a map over one axis and of uniform grids over roll in Figure 4-9, for docs/notes/maps.md.

    crates/lab/scripts/profile_errors.py write DIR        # DIR/truth.toml, DIR/grid-STEP.toml, DIR/map-BUDGET.toml
    touchdown sweep DIR/*.toml --out DIR
    crates/lab/scripts/profile_errors.py table DIR

The truth is every tenth of a degree, a minute of two cores. Between neighbours whose landings end alike from band to band, transitions
are interpolated linearly; elsewhere the nearer neighbour counts.
"""

import bisect
import csv
import re
import statistics
import sys
from itertools import groupby
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
GRIDS = ("5", "2.5", "1.25", "0.625")
BUDGETS = (2000, 4000, 8000, 16000)
HIGHEST = 25


def write(folder):
    folder.mkdir(parents=True, exist_ok=True)
    text = (ROOT / "sweeps/profile-4-09.toml").read_text()
    text = text.replace('"vehicles/', f'"{ROOT}/sweeps/vehicles/')
    uniform = re.sub(r"\[map\].*?\n\n", "", text, flags=re.DOTALL)
    for name, step in [("truth", "0.1"), *((f"grid-{step}", step) for step in GRIDS)]:
        (folder / f"{name}.toml").write_text(uniform.replace("step = 5", f"step = {step}"))
    for budget in BUDGETS:
        made = re.sub(r"budget_landings = \d+", f"budget_landings = {budget}", text)
        (folder / f"map-{budget}.toml").write_text(made)


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def profile(folder, name):
    """Bands (from, to, outcome) at each roll angle."""
    of = groupby(rows(folder / f"{name}-bands.csv"), key=lambda row: float(row["roll_deg"]))
    return {roll: [(float(row["from_fps"]), float(row["to_fps"]), row["outcome"]) for row in bands] for roll, bands in of}


def between(known, rolls, roll):
    after = bisect.bisect_left(rolls, roll)
    if rolls[after] == roll:
        return known[roll]
    low, high = rolls[after - 1], rolls[after]
    a, b, part = known[low], known[high], (roll - low) / (high - low)
    if [band[2] for band in a] != [band[2] for band in b]:
        return a if part < 0.5 else b
    return [(p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1]), p[2]) for p, q in zip(a, b)]


def first(bands):
    return bands[0][1] if len(bands) > 1 else None


def wrong(one, other):
    """Width of the speeds at which two say otherwise, ft/s."""
    ends = sorted({end for band in one + other for end in band[:2]})
    at = lambda bands, speed: next(band[2] for band in bands if band[0] <= speed <= band[1])  # noqa: E731
    return sum(b - a for a, b in zip(ends, ends[1:]) if at(one, 0.5 * (a + b)) != at(other, 0.5 * (a + b)))


def table(folder):
    truth = profile(folder, "truth")
    print("| | points | landings | median error of V_H, ft/s | 90 % | V_H missing or extra | wrong outcome |")
    print("|---|---|---|---|---|---|---|")
    for name in [*(f"grid-{step}" for step in GRIDS), *(f"map-{budget}" for budget in BUDGETS)]:
        known = profile(folder, name)
        rolls = sorted(known)
        landings = sum(int(row["landings"]) for row in rows(folder / f"{name}.csv"))
        found = [(between(known, rolls, roll), bands) for roll, bands in truth.items()]
        firsts = [(first(a), first(b)) for a, b in found]
        errors = sorted(abs(a - b) for a, b in firsts if a is not None and b is not None)
        unlike = sum((a is None) != (b is None) for a, b in firsts)
        area = statistics.mean(wrong(a, b) for a, b in found) / HIGHEST
        median, most = errors[len(errors) // 2], errors[int(0.9 * len(errors))]
        print(f"| {name} | {len(rolls)} | {landings} | {median:.4f} | {most:.3f} | {unlike} of {len(firsts)} | {100 * area:.2f} % |")


if __name__ == "__main__":
    match sys.argv[1:]:
        case ["write", folder]:
            write(Path(folder))
        case ["table", folder]:
            table(Path(folder))
        case _:
            sys.exit(__doc__)
