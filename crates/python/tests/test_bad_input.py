"""Bad input over every argument: an InputError in the words of the command line, and nothing else."""

from __future__ import annotations

import numpy as np
import pandas as pd
import pytest

import touchdown as td

from conftest import SHORT

FAST = {"horizontal_velocity_fps": [1.0, 2.0]}


def complaint(call) -> td.InputError:
    with pytest.raises(td.InputError) as caught:
        call()
    return caught.value


@pytest.mark.parametrize(
    ("conditions", "said"),
    [
        ({"slope_deg": float("nan")}, "slope_deg = nan: expected a finite number"),
        ({"slope_deg": float("inf")}, "slope_deg = inf: expected a finite number"),
        ({"slope_deg": 95}, "slope_deg = 95: expected"),
        ({"friction": -1}, "friction = -1: expected 0 ≤ value ≤ 1000"),
        ({"slop_deg": 15}, "slop_deg = 15: unknown key; did you mean slope_deg?"),
        ({"slope_deg": "steep"}, 'slope_deg = "steep": expected a number'),
        ({"slope_deg": None}, "slope_deg = None: expected a number, a text, a list or a dictionary"),
        ({"slope_deg": True}, "slope_deg = True: expected a number"),
        ({"slope_deg": [15]}, "slope_deg = [15]: expected a number"),
        ({"slope_deg": object}, "slope_deg = <class 'object'>: expected a number"),
        ({"slope_deg": 15, "slope_rad": 0.1}, "slope_rad = 0.1: expected one spelling of a quantity"),
        ({"gravity": "sun"}, 'gravity = "sun": expected "moon", "mars", "earth" or "ceres"'),
        ({"roll_deg": 1, "tip_deg": 1, "tip_azimuth_deg": 0}, "roll_deg = 1: expected either"),
        ({"thrust": {"time_s": [0, 1], "force_lb": [1]}}, "thrust.force_lb = [1]: 1 numbers: expected as many as in time_s"),
        ({"footing": [{"height_ft": 1e6}]}, "footing[1].height_ft = 1000000: expected"),
    ],
)
def test_scenes(conditions, said):
    error = complaint(lambda: td.Scene(**conditions))
    assert str(error).startswith(said)


def test_complaints_name_key_value_and_what_is_allowed():
    error = complaint(lambda: td.Scene(friction=-1))
    assert (error.key, error.value, error.allowed) == ("friction", "-1", "0 ≤ value ≤ 1000")
    error = complaint(lambda: td.Scene(slop_deg=1))
    assert error.key == "slop_deg" and "slope_deg" in error.allowed


def test_dictionaries_within_themselves():
    thrust: dict[str, object] = {}
    thrust["curve"] = [thrust]
    error = complaint(lambda: td.Scene(thrust=thrust))
    assert "expected at most 32 lists and dictionaries within each other" in str(error)


def test_what_a_landing_needs(lander, scene):
    incomplete = td.Scene(vertical_velocity_fps=14, slope_deg=15, friction=1)
    error = complaint(lambda: td.land(lander, incomplete))
    assert str(error).startswith("horizontal_velocity_fps is missing") and error.value is None
    for solver, said in [
        ({"tolerance": 0}, "solver.tolerance = 0: expected"),
        ({"tolerence": 1e-6}, "solver.tolerence = 0.000001: unknown key; did you mean tolerance?"),
        ({"crush_rule": "soft"}, 'solver.crush_rule = "soft": expected "pivot-rate" or "section"'),
    ]:
        assert str(complaint(lambda solver=solver: td.land(lander, scene, solver))).startswith(said)
    for dt in (0, -1, float("nan")):
        assert complaint(lambda dt=dt: td.land(lander, scene).history(dt)).key == "dt"
    assert complaint(lambda: td.land(lander, scene).history(units="cgs")).key == "units"


def test_vehicles(lander, tmp_path):
    numbers = lander.to_dict()
    for change, said in [
        ({"mass_slug": -1}, "mass_slug = -1: expected"),
        ({"mass_slugs": 1}, "mass_slugs = 1: unknown key"),
        ({"legs": []}, "legs = []: 0 legs: expected three to eight"),
        ({"strut": 3}, "strut = 3: expected a table"),
    ]:
        error = complaint(lambda change=change: td.Vehicle.from_dict(numbers | change))
        assert str(error).startswith(said), error
    assert str(complaint(lambda: td.Vehicle.from_dict({3: 4}))).startswith("[3]: expected a text as key")
    error = complaint(lambda: lander.replace({"strut.preload": 1}))
    assert "did you mean" in str(error)
    assert "expected 0 < value" in str(complaint(lambda: lander.replace({"strut.preload_lb": -1})))
    file = tmp_path / "bad.toml"
    file.write_text(lander.to_toml().replace("mass_slug", "mass_slag"))
    assert f"{file}:" in str(complaint(lambda: td.Vehicle.from_toml(file)))
    with pytest.raises(FileNotFoundError):
        td.Vehicle.from_toml(tmp_path / "none.toml")


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ({"horizontal_velocity_fps": [1.0, float("nan")]}, "row 1: horizontal_velocity_fps = NaN: expected a finite number"),
        ({"horizontal_velocity_fps": [1.0, -2.0]}, "row 1: horizontal_velocity_fps = -2: expected"),
        (FAST | {"rol_deg": [1, 2]}, "column rol_deg: no such column; did you mean roll_deg?"),
        ({"horizontal_velocity_fps": []}, "the table of cases: has no rows"),
        ({}, "column vertical_velocity_fps is missing"),
        (FAST | {"roll_deg": [1, 2, 3]}, "column roll_deg has 3 rows: expected as many as in horizontal_velocity_fps, 2"),
        ({"horizontal_velocity_fps": np.ones((2, 2))}, "column horizontal_velocity_fps has 2 dimensions: expected one"),
        ({"horizontal_velocity_fps": [True]}, "column horizontal_velocity_fps is of type bool: expected numbers"),
        ({"horizontal_velocity_fps": [1 + 2j]}, "column horizontal_velocity_fps is of type complex128: expected numbers"),
        ({"horizontal_velocity_fps": ["fast"]}, "row 0: horizontal_velocity_fps = fast: expected a finite number"),
        ({"horizontal_velocity_fps": [[1], 2]}, "row 0: horizontal_velocity_fps = [1]: expected a number or a word"),
        (FAST | {"solver.crush_rule": ["section", "soft"]}, "row 1: solver.crush_rule = soft: expected one of"),
        (FAST | {"vehicle.strut.preload_lb": [180, -1]}, "row 1: at vehicle.strut.preload_lb = -1: strut.preload_lb = -1: expected"),
        (FAST | {"vehicle": ["", "none.toml"]}, "none.toml: row 1: cannot be read"),
        (FAST | {3: [1, 2]}, "column 3: expected a text as name"),
        (7, "the table is a int: expected a DataFrame"),
        ([1, 2], "the table is a list: expected a DataFrame"),
    ],
)
def test_tables(table, said, lander, scene):
    if isinstance(table, dict) and not table:
        error = complaint(lambda: td.land_many(lander, table, progress=False))
    else:
        error = complaint(lambda: td.land_many(lander, table, scene=scene, progress=False))
    assert said in str(error)


def test_gaps_leave_numbers_to_defaults(lander, scene):
    table = {"roll_deg": [None, 0, 5], "vehicle.strut.preload_lb": pd.array([pd.NA, 200, pd.NA], dtype="Float64")}
    landed = td.land_many(lander, table, scene=scene, progress=False)
    expected = td.land(lander, scene)
    assert landed.end_time_s[0] == expected.end_time_s
    assert landed.end_time_s.nunique() == 3


MASKED = np.ma.array([20.0, 5.0], mask=[False, True])


@pytest.mark.parametrize(
    "gaps",
    [[20, None], [20, pd.NA], pd.array([20, pd.NA], dtype="Float64"), MASKED, list(MASKED), np.array([20, None]), pd.Series(["20", None])],
    ids=lambda gaps: type(gaps).__name__,
)
def test_gaps_leave_numbers_to_the_scene(gaps, lander, scene):
    rolled = scene.replace(roll_deg=10)
    landed = td.land_many(lander, {"roll_deg": gaps}, scene=rolled, progress=False)
    assert landed.end_time_s[0] == td.land(lander, scene.replace(roll_deg=20)).end_time_s
    assert landed.end_time_s[1] == td.land(lander, rolled).end_time_s


def test_gaps_leave_numbers_to_the_scene_in_any_unit(lander, scene):
    on_mars = scene.replace(gravity="mars")
    table = {"gravity_mps2": [None, 1.62], "horizontal_velocity_mps": [3.0, None], "vertical_velocity_fps": [None, 14.5]}
    landed = td.land_many(lander, table, scene=on_mars, progress=False)
    first, second = on_mars.replace(horizontal_velocity_mps=3.0), scene.replace(gravity_mps2=1.62, vertical_velocity_fps=14.5)
    assert landed.end_time_s.tolist() == [td.land(lander, first).end_time_s, td.land(lander, second).end_time_s]
    by_solver = td.land_many(lander, {"solver.tolerance": [1e-8, None]}, scene=scene, solver={"tolerance": 1e-7}, progress=False)
    expected = [td.land(lander, scene, {"tolerance": tolerance}).end_time_s for tolerance in (1e-8, 1e-7)]
    assert by_solver.end_time_s.tolist() == expected


def test_gaps_of_what_nothing_gives_are_refused_with_their_rows(lander, scene):
    slow = {name: value for name, value in scene.to_dict().items() if name != "horizontal_velocity_fps"}
    for gaps in ([11, None], np.ma.array([11, 12], mask=[False, True])):
        error = complaint(lambda gaps=gaps: td.land_many(lander, {"horizontal_velocity_fps": gaps}, scene=td.Scene(**slow), progress=False))
        assert str(error).startswith("row 1: horizontal_velocity_fps is missing: expected the horizontal velocity")


def test_nan_among_numbers_is_no_gap(lander, scene):
    nan = float("nan")
    for numbers in ([20, nan], np.array([20, nan]), pd.Series([20, None]), [20, nan, None], np.array([20, nan], dtype=object)):
        error = complaint(lambda numbers=numbers: td.land_many(lander, {"roll_deg": numbers}, scene=scene, progress=False))
        assert str(error).startswith("row 1: roll_deg = NaN: expected a finite number; a gap is None or pandas.NA")
    rules = {"solver.crush_rule": ["section", nan]}
    landed = td.land_many(lander, rules, scene=scene, progress=False)
    assert landed.end_time_s[1] == td.land(lander, scene).end_time_s


@pytest.mark.parametrize(
    ("axes", "options", "said"),
    [
        ({}, {}, "axes"),
        ({"rol_deg": [1]}, {}, "did you mean roll_deg?"),
        ({"roll_deg": []}, {}, "axes.roll_deg = []"),
        ({"roll_deg": [0, float("nan")]}, {}, "axes.roll_deg[2] = nan: expected a finite number"),
        ({"roll_deg": 5}, {}, "axes.roll_deg = 5"),
        ({"roll_deg": np.ones((2, 2))}, {}, "axes.roll_deg"),
        ({"roll_deg": {"from": 0, "to": 1}}, {}, "axes.roll_deg"),
        ({"slope_deg": [10, 95]}, {}, "axes.slope_deg"),
        ({"roll_deg": [0]}, {"search": {"from_fps": -1}}, "search.from_fps = -1"),
        ({"roll_deg": [0]}, {"search": {"step": 1}}, "search.step = 1: unknown key"),
        ({"roll_deg": [0]}, {"solver": {"stop": "time"}}, "solver.stop"),
        ({"roll_deg": [0]}, {"sensitivity": ["fiction"]}, "friction"),
        ({"roll_deg": [0]}, {"job": "both"}, 'job = "both"'),
        ({"roll_deg": [0]}, {"units": "cgs"}, 'units = "cgs"'),
        ({"roll_deg": [0]}, {"threads": 10_000}, "threads = 10000: expected 1 to"),
    ],
)
def test_sweeps(axes, options, said, lander, scene):
    options = {"search": SHORT, "progress": False} | options
    assert said in str(complaint(lambda: td.sweep(lander, scene, axes, **options)))


def test_types_that_are_none_of_ours_are_type_errors(lander, scene):
    for call in [
        lambda: td.land("surveyor", scene),
        lambda: td.land(lander, {"slope_deg": 3}),
        lambda: td.sweep(lander, scene, {"roll_deg": [0]}, thread=2),
        lambda: td.boundary(lander, scene, threads="two"),
        lambda: td.boundary(lander, scene, threads=-1),
    ]:
        with pytest.raises((TypeError, ValueError, OverflowError, AttributeError)):
            call()


def test_files_that_are_no_results(tmp_path):
    for name, text in [("a.csv", "x,y\n1,2\n"), ("a.txt", ""), ("a.json", "{}")]:
        (tmp_path / name).write_text(text)
        if name == "a.json":
            (tmp_path / "a.csv").unlink()
        assert "expected" in str(complaint(lambda name=name: td.read(tmp_path / name)))
