"""The transition velocity for Dakota: ``python dakota_driver.py PARAMETERS RESULTS``.

Dakota calls it once for each point. Variables are parameters of vehicle or scene under their dotted names, such as
``vehicle.strut.preload_lb`` or ``slope_deg``; the response is V_H of first transition in ft/s.
"""

from __future__ import annotations

import sys
from pathlib import Path

import touchdown as td

LANDER = td.vehicles.surveyor()
SCENE = td.Scene(vertical_velocity_fps=14, cross_slope_deg=180, slope_deg=15, friction=1.0)
SEARCH = {"bands": "first", "from_fps": 6, "to_fps": 16, "scan_step_fps": 1, "tolerance_fps": 0.01}
RESPONSE = "first_transition_fps"


def read_parameters(text: str) -> tuple[dict[str, float], list[str]]:
    """Variables and labels of the responses wanted, from a parameters file in Dakota's standard format."""
    lines = iter(text.splitlines())

    def section() -> list[list[str]]:
        count = int(next(lines).split()[0])
        return [next(lines).split(maxsplit=1) for _ in range(count)]

    variables = {label: float(value) for value, label in section()}
    # The active set is 1 for a value; this driver has no gradients (2) and no Hessians (4).
    active = {label.partition(":")[2]: int(code) for code, label in section()}
    if set(active.values()) != {1}:
        raise ValueError(f"active set {active}: expected values only (no_gradients, no_hessians)")
    return variables, list(active)


def first_transition(variables: dict[str, float]) -> float:
    """V_H of first transition, ft/s."""
    of_vehicle = {name: value for name, value in variables.items() if name.startswith("vehicle.")}
    of_scene = {name: value for name, value in variables.items() if name not in of_vehicle}
    found = td.boundary(LANDER.replace(of_vehicle), SCENE.replace(of_scene), search=SEARCH, threads=1, progress=False)
    if found.first_transition_fps is None:
        raise ValueError(f"all landings up to {SEARCH['to_fps']} ft/s are stable: there is no transition")
    return found.first_transition_fps


def main(parameters: Path, results: Path) -> None:
    """Answer one parameters file. Any error leaves the line by which Dakota knows of a failure."""
    try:
        variables, wanted = read_parameters(parameters.read_text(encoding="utf-8"))
        if wanted != [RESPONSE]:
            raise ValueError(f"responses {wanted}: expected {RESPONSE}")
        answer = f"{first_transition(variables):.17g} {RESPONSE}\n"
    except ValueError as error:
        print(error, file=sys.stderr)
        answer = "FAIL\n"
    results.write_text(answer, encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
