"""What the terminal warns of is a warning of the package, once for each call."""

from __future__ import annotations

import warnings

import pytest

import touchdown as td

from conftest import SHORT

CRUSHED = "crushed beyond their hinges: the contact rule"
ADDED = "crushing footpads or blocks added "


def told(call) -> str:
    """The single warning of a call, which points at this file."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        call()
    assert [(one.category, one.filename) for one in caught] == [(td.LandingWarning, __file__)]
    return str(caught[0].message)


@pytest.fixture
def stiff(lander) -> td.Vehicle:
    """Pads so stiff that they give energy to the motion."""
    return lander.replace({"footpad.crush_pressure_psf": 1e5})


@pytest.fixture
def slow(scene) -> td.Scene:
    return scene.replace(horizontal_velocity_fps=5)


def test_landings_of_the_baseline_are_silent(lander, scene, recwarn):
    td.land(lander, scene)
    td.land_many(lander, {"roll_deg": [0, 5]}, scene=scene, progress=False)
    td.boundary(lander, scene, search=SHORT, progress=False)
    assert not recwarn.list


def test_energy_given_by_contact(stiff, slow, tmp_path):
    assert told(lambda: td.land(stiff, slow)).startswith(ADDED)
    assert " J to the motion" in told(lambda: td.land(stiff, slow, units="SI"))
    soft = {"vehicle.footpad.crush_pressure_psf": [1578.8, None, 5e4]}
    for out in (None, tmp_path / "landed.csv"):
        said = told(lambda out=out: td.land_many(stiff, soft, scene=slow, out=out, progress=False))
        assert said.startswith(f"in 2 cases, most in row 1: {ADDED}")
    axes = {"vehicle.footpad.crush_pressure_psf": [1578.8, 1e5]}
    said = told(lambda: td.sweep(stiff, slow, axes, job="outcome", progress=False))
    assert said.startswith(f"at 1 point, most at vehicle.footpad.crush_pressure_psf = 100000: {ADDED}")
    search = {"from_fps": 5, "to_fps": 6, "scan_step_fps": 1, "tolerance_fps": 0.1}
    assert ADDED in told(lambda: td.boundary(stiff, slow, search=search, progress=False))
    assert " J to the motion" in told(lambda: td.boundary(stiff, slow, search=search, units="SI", progress=False))


def test_footpads_crushed_through():
    numbers = td.vehicles.four_legs().to_dict()
    profile = {"interference_mm": [0, 5, 60], "relative_pressure": [0, 1, 1]}
    soft = td.Vehicle.from_dict(numbers | {"footpad": numbers["footpad"] | {"crush_pressure_kpa": 3, "profile": profile}})
    scene = td.Scene(vertical_velocity_mps=2, horizontal_velocity_fps=0, cross_slope_deg=0, slope_deg=0, friction=1)
    solver = {"rules": "1966"}
    assert "up to its hinge" in told(lambda: td.land(soft, scene, solver))
    said = told(lambda: td.land_many(soft, {"roll_deg": [0, 45]}, scene=scene, solver=solver, progress=False))
    assert f"in 2 cases, first in row 0: footpads were {CRUSHED}" in said
    options = {"search": {"from_mps": 0, "to_mps": 2, "scan_step_mps": 1, "tolerance_mps": 0.01}, "solver": solver, "progress": False}
    axes = {"roll_deg": [0, 20]}
    for call in [
        lambda: td.sweep(soft, scene, axes, **options),
        lambda: td.map(soft, scene, axes, {"roll_deg": 20}, error_fps=5, **options),
        lambda: td.sensitivity(soft, scene, ["friction"], **options),
    ]:
        assert CRUSHED in told(call)


def test_struts_beyond_their_crush_tables():
    lander = td.vehicles.four_legs()
    # Millimetres where metres were meant: the table ends at a tenth of the stroke.
    short = lander.replace({"strut.crush_load.stroke_mm": [0, 12, 12, 30]})
    scene = td.Scene(vertical_velocity_mps=4, horizontal_velocity_fps=0, cross_slope_deg=0, slope_deg=0, friction=1)
    assert "beyond the 0.0300 m at which its crush_load ends" in told(lambda: td.land(short, scene, units="SI"))
    said = told(lambda: td.land_many(short, {"roll_deg": [0, 5]}, scene=scene, progress=False))
    assert said.startswith("in 2 cases, first in row 0: struts stroked beyond the end of their crush_load")
    search = {"from_mps": 0, "to_mps": 2, "scan_step_mps": 1, "tolerance_mps": 0.5}
    said = told(lambda: td.sweep(short, scene, {"roll_deg": [0, 5]}, search=search, progress=False))
    assert said.startswith("at 2 points: struts stroked beyond the end of their crush_load")


def test_undecided_landings(lander, scene):
    solver = {"time_limit_s": 0.1}
    axes = {"horizontal_velocity_fps": {"from": 0, "to": 2}}
    said = told(lambda: td.sample(lander, scene, axes, 20, 1, solver=solver, progress=False))
    assert said == "20 landings undecided: sliding, or still moving at time_limit_s = 0.1, counted as not stable"
    said = told(lambda: td.boundary(lander, scene, search=SHORT, solver=solver, progress=False))
    assert "at 1 point some landings are undecided" in said
