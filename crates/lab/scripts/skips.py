#!/usr/bin/env python3
"""What each skip of a search spares, and that it changes nothing: the level-vehicle grid searched
without skips, with each alone, and as the sweeps of Phase II are (five minutes on one core). Prints
the table and the points of docs/notes/skips.md.

    crates/lab/scripts/skips.py [OPTIONS OF touchdown sweep ...]

Bands are alike when outcomes, ends and brackets are the same to the last digit.
"""

import csv
import json
import re
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
GRID = ROOT / "crates/lab/sweeps/level-grid.toml"
NONE = {"scan": "full", "scan_looseness": 1, "refinement": "bisection", "certainty": "all"}
SKIPS = {
    "scan": {"scan": "skipping"},
    "scan_looseness": {"scan_looseness": 10},
    "refinement": {"refinement": "margin"},
    "certainty": {"certainty": "doubtful"},
}
USUAL = SKIPS["scan"] | SKIPS["scan_looseness"] | SKIPS["certainty"]
ALL = USUAL | SKIPS["refinement"]
SEARCHES = {"none": {}, **SKIPS, "all but refinement": USUAL, "all": ALL}
OUTLINE = ["from_fps", "to_fps", "outcome", "bracket_width_fps"]


def search(name, folder, options):
    """Searches the grid with some skips: the bands of every point, counts, and the CPU time in s."""
    text = GRID.read_text().replace('"../../../sweeps/', f'"{ROOT}/sweeps/')
    for key, word in {**NONE, **SEARCHES[name]}.items():
        text, found = re.subn(rf"^{key} = .*$", f"{key} = {json.dumps(word)}", text, flags=re.M)
        if found != 1:
            raise SystemExit(f"{GRID}: {key} stands there {found} times, not once")
    file = folder / f"{name.replace(' ', '-')}.toml"
    file.write_text(text)
    command = [ROOT / "target/release/touchdown", "sweep", file, "--out", folder, "--quiet"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([*command, *options], check=True)
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    bands = {}
    with open(folder / f"{file.stem}-bands.csv", newline="") as table:
        for band in csv.DictReader(table):
            point = f"cross-slope {band['cross_slope_deg']}, roll {band['roll_deg']}"
            bands.setdefault(point, []).append(band)
    return bands, json.loads(file.with_suffix(".json").read_text())["counts"], seconds


def outline(bands):
    """What two searches have to agree in."""
    return [[band[column] for column in OUTLINE] for band in bands]


def main():
    """Runs all searches and prints what they came to."""
    subprocess.run(["cargo", "build", "--release", "--quiet"], cwd=ROOT, check=True)
    print("| skips | landings | evaluations | CPU s | bands | points with other bands | other certainty |")
    print("|---|---:|---:|---:|---:|---:|---:|")
    notes = []
    plain = None
    with tempfile.TemporaryDirectory() as folder:
        for name in SEARCHES:
            bands, counts, seconds = search(name, Path(folder), sys.argv[1:])
            plain = plain or bands
            other = [point for point in plain if outline(plain[point]) != outline(bands[point])]
            pairs = [
                pair
                for point in plain
                if point not in other
                for pair in zip(plain[point], bands[point])
            ]
            unlike = sum(a["certainty"] != b["certainty"] for a, b in pairs)
            evaluations = counts["derivative_evaluations"]
            print(
                f"| {name} | {counts['landings']} | {evaluations / 1e6:.1f}·10⁶ "
                f"| {seconds:.1f} | {counts['bands']} | {len(other)} | {unlike} |",
                flush=True,
            )
            for point in other:
                for band in bands[point]:
                    if band not in plain[point]:
                        words = ", ".join(f"{column} {band[column]}" for column in OUTLINE)
                        notes.append(f"{name}: {point}: {words}")
    print("\n".join(notes))


if __name__ == "__main__":
    main()
