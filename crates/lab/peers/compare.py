"""Time against error of the same landings by other people's integrators and by ours.

Forty level landings of Table 4-1's vehicle around its toppling boundary, each run to its outcome on one
core; errors a second after first contact, against ours at a tolerance of 1e-11. The peers are plain
adaptive methods: every evaluation of the same compiled right-hand side chooses the active piece of each
law, and what the crushable elements keep changes after accepted steps.
"""

import argparse
import os
import sys
import time
import tomllib
from pathlib import Path

import numpy
import scipy
from scipy.integrate import DOP853, LSODA, RK45

import touchdown_peers
from table import Row, write

HERE = Path(__file__).parent
ROOT = HERE.parents[2]
VEHICLE = ROOT / "sweeps/vehicles/surveyor-table-4-1.toml"
CONVERGED = ("touchdown", 1e-11)
COMPARED_AT = 1.0  # s

SCIPY = {"SciPy RK45": RK45, "SciPy DOP853": DOP853, "SciPy LSODA": LSODA}
# Of the compiled ones the least of so many times is taken: a landing takes a few milliseconds.
REPEATS = 5
MEASURED = [
    ("SciPy RK45", [1e-4, 1e-6]),
    ("SciPy DOP853", [1e-4, 1e-6]),
    ("SciPy LSODA", [1e-4, 1e-6]),
    ("ode_solvers Dopri5", [1e-3, 1e-4, 1e-5, 1e-6]),
    ("diffsol TSIT45", [1e-3, 1e-4, 1e-5, 1e-6]),
    ("touchdown --method report", [None]),
    ("touchdown", [1e-3, 1e-4, 3e-5, 1e-6, 1e-8]),
]


def integrate(landing, method, tolerance):
    """Takes a plain landing through SciPy's method; the variables at its end."""
    with numpy.errstate(all="ignore"):  # a trial step may go too far; it is then rejected
        solver = method(
            landing.derivative, 0.0, landing.start(), landing.last(), rtol=tolerance, atol=tolerance
        )
        while solver.status == "running":
            complaint = solver.step()
            if solver.status == "failed":
                raise RuntimeError(complaint)
            if landing.accept(solver.y):
                break
    return solver.y


def land(case, integrator, tolerance):
    """Time (µs), evaluations and outcome of a landing."""
    if integrator not in SCIPY:
        runs = [case.land(integrator, tolerance) for _ in range(REPEATS)]
        return min(runs)
    start = time.perf_counter()
    landing = case.plain_landing()
    integrate(landing, SCIPY[integrator], tolerance)
    return 1e6 * (time.perf_counter() - start), landing.evaluations(), landing.outcome()


def seen(case, integrator, tolerance):
    """Position (ft) and pitch (deg) a second after first contact, if the landing lasts so long."""
    if integrator not in SCIPY:
        return case.seen_at(integrator, tolerance, COMPARED_AT)
    landing = case.plain_landing(COMPARED_AT)
    return landing.seen(integrate(landing, SCIPY[integrator], tolerance))


def measure(cases, integrator, tolerance, converged):
    """A row of the table."""
    number = tolerance or CONVERGED[1]  # the report's method has error limits of its own
    landings = [land(case, integrator, number) for case in cases]
    positions, pitches = [], []
    for case, (_, exact) in zip(cases, converged):
        found = seen(case, integrator, number)
        if found and exact:
            positions.append(numpy.linalg.norm(numpy.subtract(found[0], exact[0])))
            pitches.append(abs(found[1] - exact[1]))
    times, evaluations, outcomes = zip(*landings)
    return Row(
        integrator=integrator,
        tolerance=tolerance,
        median_us_per_landing=numpy.median(times),
        mean_us_per_landing=numpy.mean(times),
        mean_evaluations=numpy.mean(evaluations),
        median_position_error_at_1s_ft=numpy.median(positions),
        p90_position_error_at_1s_ft=numpy.quantile(positions, 0.9),
        median_pitch_error_at_1s_deg=numpy.median(pitches),
        p90_pitch_error_at_1s_deg=numpy.quantile(pitches, 0.9),
        other_outcomes=sum(a != b for a, (b, _) in zip(outcomes, converged)),
        landings=len(cases),
    )


def versions():
    """Versions of the peers."""
    lock = tomllib.loads((HERE / "Cargo.lock").read_text())
    crates = {package["name"]: package["version"] for package in lock["package"]}
    return (
        f"SciPy {scipy.__version__}, ode_solvers {crates['ode_solvers']}, "
        f"diffsol {crates['diffsol']}, touchdown {crates['touchdown-dynamics']}"
    )


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    options.add_argument("--quick", action="store_true", help="ten landings, to target/quick")
    quick = options.parse_args().quick
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})

    cases = touchdown_peers.cases(VEHICLE, quick)
    converged = [
        (case.land(*CONVERGED)[2], case.seen_at(*CONVERGED, COMPARED_AT)) for case in cases
    ]
    rows = []
    for integrator, tolerances in MEASURED:
        for tolerance in tolerances:
            print(f"{integrator} {tolerance or ''}", file=sys.stderr)
            rows.append(measure(cases, integrator, tolerance, converged))
    folder = HERE / "target/quick" if quick else HERE.parent / "results"
    print(write(rows, versions(), folder))


if __name__ == "__main__":
    main()
