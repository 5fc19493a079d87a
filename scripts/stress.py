#!/usr/bin/env python3
"""Put sweeps under stress and say in numbers how they take it.

    scripts/stress.py                               # all of it: 200 kills, 1,000,000 wild landings
    scripts/stress.py --kills 10 --landings 2000    # a taste

Kills: a sweep of all bands is killed (SIGKILL) at random times, from the first write to the last
rename, and started again with another number of threads, until it was killed so often; whenever it
gets to its end its results are compared with those of a run in peace, and it begins anew.

Wild landings: sweeps/stress/wild.toml, or its first so many points. Fails if a landing gives a number
that is none; tells outcomes, failures with their inputs, worst energy account, largest step count.
"""

import argparse
import csv
import random
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def options():
    """What the command line asks for."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--landings", type=int, default=1_000_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--touchdown", default=str(ROOT / "target/release/touchdown"))
    return parser.parse_args()


def sweep(touchdown, file, out, *more):
    """The command of a sweep."""
    return [touchdown, "sweep", str(file), "--out", str(out), "--quiet", *more]


def kills(arguments, folder):
    """Kills a sweep again and again; number of runs that ended and were compared."""
    file = folder / "killed.toml"
    text = (ROOT / "sweeps/figure-4-09.toml").read_text()
    vehicles = ROOT / "sweeps/vehicles"
    text = text.replace('"vehicles/', f'"{vehicles}/').replace("step = 5", "step = 10")
    file.write_text(text.replace("tolerance = 1e-6", "tolerance = 1e-4"))
    started = time.monotonic()
    subprocess.run(sweep(arguments.touchdown, file, folder / "peace"), check=True)
    whole = time.monotonic() - started
    names = [path.name for path in (folder / "peace").iterdir() if path.suffix != ".json"]
    expected = {name: (folder / "peace" / name).read_bytes() for name in names}

    chance = random.Random(arguments.seed)
    out = folder / "killed"
    journal = out / "killed.journal"
    killed = compared = resumed = 0
    while killed < arguments.kills:
        before = journal.stat().st_size if journal.exists() else 0
        resumed += before > 0
        threads = str(chance.choice([1, 2, 3]))
        run = subprocess.Popen(sweep(arguments.touchdown, file, out, "--threads", threads),
                               stderr=subprocess.PIPE)
        try:
            run.wait(chance.uniform(0.0, 0.6 * whole))
        except subprocess.TimeoutExpired:
            run.kill()
            run.wait()
            killed += 1
            after = journal.stat().st_size if journal.exists() else None
            # A journal only disappears when the results stand, and never shrinks but by a torn end.
            if after is None and before > 0 and not (out / "killed.csv").exists():
                sys.exit("a journal was lost")
            continue
        if run.returncode != 0:
            sys.exit(f"a resumed run failed: {run.stderr.read().decode()}")
        for name, content in expected.items():
            if (out / name).read_bytes() != content:
                sys.exit(f"{name} differs after kills")
            (out / name).unlink()
        compared += 1
    print(f"{killed} kills, {resumed} times resumed from a journal, "
          f"{compared} times finished and compared: no difference")


def wild(arguments, folder):
    """Lands wildly and tells how it went."""
    text = (ROOT / "sweeps/stress/wild.toml").read_text()
    vehicles = ROOT / "sweeps/vehicles"
    text = text.replace('"../vehicles/', f'"{vehicles}/')
    file = folder / "wild.toml"
    file.write_text(text.replace("count = 1000000", f"count = {arguments.landings}"))
    started = time.monotonic()
    subprocess.run(sweep(arguments.touchdown, file, folder / "wild"), check=True)
    seconds = time.monotonic() - started
    outcomes, failures = Counter(), Counter()
    examples = {}
    worst, steps = (-1.0, None), (-1, None)
    with open(folder / "wild/wild.csv", newline="", encoding="utf-8") as table:
        for number, row in enumerate(csv.DictReader(table)):
            outcomes[row["outcome"]] += 1
            if row["failure"]:
                failures[row["failure"]] += 1
                examples.setdefault(row["failure"], number)
            for name, cell in row.items():
                if cell.lower() in ("nan", "inf", "-inf"):
                    sys.exit(f"point {number}: {name} is {cell}")
            energy = float(row["initial_kinetic_energy_ftlb"])
            energy += abs(float(row["potential_energy_change_ftlb"])) + 1.0
            closure = abs(float(row["energy_closure_ftlb"])) / energy
            if row["outcome"] != "failure":
                worst = max(worst, (closure, number))
            steps = max(steps, (int(row["steps"]), number))
    total = outcomes.total()
    print(f"{total} wild landings in {seconds:.0f} s, every number finite")
    for outcome, count in outcomes.most_common():
        print(f"  {outcome}: {100 * count / total:.3f} %")
    for failure, count in failures.most_common():
        print(f"  {count} failures: {failure} (first: point {examples[failure]})")
    print(f"  worst energy closure {worst[0]:.2e} of the energy (point {worst[1]})")
    print(f"  most steps {steps[0]} (point {steps[1]})")


def main():
    """Runs what was asked for."""
    arguments = options()
    with tempfile.TemporaryDirectory() as name:
        if arguments.kills:
            kills(arguments, Path(name))
        if arguments.landings:
            wild(arguments, Path(name))


if __name__ == "__main__":
    main()
