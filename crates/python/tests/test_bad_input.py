"""Bad input over every argument: an InputError in the words of the command line, and nothing else."""

from __future__ import annotations

import numpy as np
import pandas as pd
import polars
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
        ({"slope_deg": set(range(50))}, "slope_deg = a set: expected a number"),
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


def test_dictionaries_within_themselves_and_lists_within_lists():
    thrust: dict[str, object] = {}
    thrust["curve"] = [thrust]
    lists: list[object] = []
    for _ in range(40):
        lists = [lists]
    for deep in (thrust, lists):
        error = complaint(lambda deep=deep: td.Scene(thrust=deep))
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
        ({}, "the table has no columns: expected a DataFrame"),
        (pd.DataFrame(index=[1, 2]), "the table has no columns: expected a DataFrame"),
        (FAST | {"roll_deg": [1, 2, 3]}, "column roll_deg has 3 rows: expected as many as in horizontal_velocity_fps, 2"),
        ({"horizontal_velocity_fps": np.ones((2, 2))}, "column horizontal_velocity_fps has 2 dimensions: expected one"),
        ({"horizontal_velocity_fps": [True]}, "column horizontal_velocity_fps is of type bool: expected numbers"),
        ({"horizontal_velocity_fps": [1 + 2j]}, "column horizontal_velocity_fps is of type complex128: expected numbers"),
        ({"horizontal_velocity_fps": ["fast"]}, "row 0: horizontal_velocity_fps = fast: expected a finite number"),
        ({"horizontal_velocity_fps": [[1], 2]}, "row 0: horizontal_velocity_fps = [1]: expected a number or a word"),
        (FAST | {"solver.crush_rule": ["section", "soft"]}, "row 1: solver.crush_rule = soft: expected one of"),
        (FAST | {"vehicle.strut.preload_lb": [180, -1]}, "row 1: at vehicle.strut.preload_lb = -1: strut.preload_lb = -1: expected"),
        (FAST | {3: [1, 2]}, "column 3: expected a text as name"),
        (pd.DataFrame([[1.0, 2.0]], columns=["roll_deg", "roll_deg"]), "column roll_deg is there twice: expected once"),
        (FAST | {"roll_deg": {1: 2}}, "row 0: roll_deg = {1: 2}: expected a number or a word"),
        (7, "the table is a int: expected a DataFrame"),
        ([1, 2], "the table is a list: expected a DataFrame"),
    ],
)
def test_tables(table, said, lander, scene):
    assert said in str(complaint(lambda: td.land_many(lander, table, scene=scene, progress=False)))


def test_columns_that_are_missing(lander):
    error = complaint(lambda: td.land_many(lander, {"roll_deg": [0]}, progress=False))
    assert str(error).startswith("column vertical_velocity_fps is missing")


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
        assert str(error).startswith("row 1: horizontal_velocity_fps is missing: expected 0 ≤ value ≤ 10000 ft/s, horizontal velocity V_H")


def test_nan_among_numbers_is_no_gap(lander, scene):
    nan = float("nan")
    for numbers in ([20, nan], np.array([20, nan]), pd.Series([20, None]), [20, nan, None], np.array([20, nan], dtype=object)):
        error = complaint(lambda numbers=numbers: td.land_many(lander, {"roll_deg": numbers}, scene=scene, progress=False))
        assert str(error).startswith("row 1: roll_deg = NaN: expected a finite number; a gap is None or pandas.NA")
    # Among words it is.
    rules = {"solver.crush_rule": ["section", nan], "note": [nan, nan], "case": ["a", nan], "vehicle": pd.Series([nan, nan])}
    landed = td.land_many(lander, rules, scene=scene, progress=False)
    assert landed.end_time_s[1] == td.land(lander, scene).end_time_s


@pytest.mark.parametrize(
    ("axes", "options", "said"),
    [
        ({}, {}, "axes = {}: expected a dictionary with the values of at least one parameter"),
        (None, {}, "axes = None: expected a dictionary with"),
        (["roll_deg"], {}, "axes = ['roll_deg']: expected a dictionary with"),
        (pd.DataFrame({"roll_deg": [0, 1]}), {}, "axes = a DataFrame: expected a dictionary with"),
        ({3: [1]}, {}, "key of axes = 3: expected a text"),
        ({"roll_deg": pd.DataFrame({"a": [0, 1]})}, {}, "axes.roll_deg = a DataFrame: expected a number, a text, a list"),
        ({"roll_deg": {"file": 3, "column": "a"}}, {}, "axes.roll_deg.file = 3: expected a path"),
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
        ({"roll_deg": [0]}, {"threads": 0}, "threads = 0: expected a whole number from 1 on, or None for all cores"),
        ({"roll_deg": [0]}, {"threads": "two"}, "threads = 'two': expected a whole number"),
        ({"roll_deg": [0]}, {"search": "all"}, "search = 'all': expected a dictionary"),
        ({"roll_deg": [0]}, {"solver": 3}, "solver = 3: expected a table"),
        ({"roll_deg": [0]}, {"sensitivity": "friction"}, "sensitivity = 'friction': expected a list of names"),
        ({"roll_deg": polars.Series([0.0, None])}, {}, "axes.roll_deg[2] = nan: expected a finite number"),
        ({"roll_deg": [0]}, {"units": 3}, "units = 3: expected \"US\" or \"SI\""),
        ({"roll_deg": [0]}, {"name": "a/b"}, "name = 'a/b': expected a name without a folder"),
        ({"roll_deg": [0]}, {"out": 3}, "out = 3: expected a path"),
        ({"roll_deg": [0]}, {"parquet": "yes"}, "parquet = 'yes': expected True or False"),
        ({"roll_deg": [0]}, {"progress": "yes"}, "progress = 'yes': expected True, False, None or a callable"),
    ],
)
def test_sweeps(axes, options, said, lander, scene):
    options = {"search": SHORT, "progress": False} | options
    assert said in str(complaint(lambda: td.sweep(lander, scene, axes, **options)))


TEXT = "expected the text of a vehicle file; Vehicle.from_toml(path) reads the file itself"
VEHICLE = "vehicle = 'surveyor.toml': expected a Vehicle; Vehicle.from_toml(path) reads one"
MAPPED = {"roll_deg": [0, 20]}


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda lander, scene: td.land("surveyor.toml", scene), VEHICLE),
        (lambda lander, scene: td.boundary("surveyor.toml", scene), VEHICLE),
        (lambda lander, scene: td.land_many("surveyor.toml", FAST, scene=scene, progress=False), VEHICLE),
        (lambda lander, scene: td.sweep("surveyor.toml", scene, MAPPED, progress=False), VEHICLE),
        (lambda lander, scene: td.run("sweep.toml", vehicle="surveyor.toml"), VEHICLE),
        (lambda lander, scene: td.land(scene, lander), "vehicle = a Scene: expected a Vehicle"),
        (lambda lander, scene: td.land(lander, {"slope_deg": 3}), "scene = {'slope_deg': 3}: expected a Scene"),
        (lambda lander, scene: td.boundary(lander, None), "scene = None: expected a Scene"),
        (lambda lander, scene: td.sweep(lander, {}, MAPPED), "scene = {}: expected a Scene"),
        (lambda lander, scene: td.land_many(lander, FAST, scene={}), "scene = {}: expected a Scene"),
        (lambda lander, scene: td.land(lander, scene, units=3), 'units = 3: expected "US" or "SI"'),
        (lambda lander, scene: td.land(lander, scene).to_series(3), 'units = 3: expected "US" or "SI"'),
        (lambda lander, scene: td.land(lander, scene).history(float("inf")), "dt = inf: expected a finite number of at least"),
        (lambda lander, scene: td.land(lander, scene).history("fine"), "dt = 'fine': expected a number of seconds"),
        (lambda lander, scene: td.boundary(lander, scene, threads=0), "threads = 0: expected a whole number from 1 on"),
        (lambda lander, scene: td.boundary(lander, scene, search=[1]), "search = [1]: expected a dictionary"),
        (lambda lander, scene: td.boundary(lander, td.Scene(slope_deg=1)), "cross_slope_deg is missing: expected the direction of"),
        (lambda lander, scene: td.sensitivity(lander, td.Scene(slope_deg=1), ["friction"]), "cross_slope_deg is missing"),
        (lambda lander, scene: td.sensitivity(lander, scene, []), "parameters = []: expected at least one name"),
        (lambda lander, scene: td.sensitivity(lander, scene, "friction"), "parameters = 'friction': expected a list of names"),
        (lambda lander, scene: td.map(lander, scene, MAPPED, [5], error_fps=1), "edge_width = [5]: expected a dictionary"),
        (lambda lander, scene: td.sample(lander, scene, MAPPED, 5, 1, covariance=3), "covariance = 3: expected a list of dictionaries"),
        (lambda lander, scene: td.sample(lander, scene, MAPPED, 5, 1, covariance=np.eye(2)), "covariance = a ndarray: expected a list"),
        (lambda lander, scene: td.sweep(lander, scene, MAPPED, sensitivity=np.array(["fiction", "roll_deg"])), "sensitivity.parameters"),
        (lambda lander, scene: td.land_many(lander, FAST, scene=scene, threads=0), "threads = 0: expected a whole number from 1 on"),
        (lambda lander, scene: td.land_many(lander, FAST, scene=scene, out=3), "out = 3: expected a path"),
        (lambda lander, scene: td.land_many(lander, FAST, scene=scene, out="z.json"), "out = 'z.json': expected a name that ends in .csv or .parquet"),
        (lambda lander, scene: td.land_many(lander, {"roll_deg": []}, scene=scene, out="z.csv"), "the table of cases: has no rows"),
        (lambda lander, scene: scene.replace({3: 4}), "key of conditions = 3: expected a text"),
        (lambda lander, scene: scene.replace("steep"), "conditions = 'steep': expected a dictionary"),
        (lambda lander, scene: lander.replace(None), "numbers = None: expected a dictionary"),
        (lambda lander, scene: lander.replace({3: 4}), "key of numbers = 3: expected a text"),
        (lambda lander, scene: lander.replace({"mass_slug": None}), "vehicle.mass_slug = None: expected a number or a word"),
        (lambda lander, scene: lander.replace({"mass_slug": True}), "vehicle.mass_slug = True: expected a number or a word"),
        (lambda lander, scene: lander.replace({"mass_slug": 1, "mass_kg": 2}), "vehicle.mass_slug and vehicle.mass_kg: expected one"),
        (lambda lander, scene: td.Vehicle("surveyor.toml"), f"text = 'surveyor.toml': {TEXT}"),
        (lambda lander, scene: td.Vehicle(3), f"text = 3: {TEXT}"),
        (lambda lander, scene: td.Vehicle.from_toml(3), "path = 3: expected a path"),
        (lambda lander, scene: td.Vehicle.from_dict("surveyor.toml"), "numbers = 'surveyor.toml': expected a dictionary with the keys"),
        (lambda lander, scene: td.run(3), "path = 3: expected a path"),
        (lambda lander, scene: td.run("sweep.toml", set="friction"), "set = 'friction': expected a dictionary"),
        (lambda lander, scene: td.run("sweep.toml", set={"friction": None}), "friction = None: expected a number or a word"),
        (lambda lander, scene: td.read(3), "path = 3: expected a path"),
        (lambda lander, scene: td.plot.profile(3), "ds = 3: expected a dataset"),
        (lambda lander, scene: td.plot.history(td.land(lander, scene)), "table = a Landing: expected a history"),
        (lambda lander, scene: td.plot.history(pd.DataFrame(), columns=[]), "columns = []: expected at least one name"),
        (lambda lander, scene: td.plot.tornado(pd.DataFrame({"a": [1]})), "table = a DataFrame: expected a table of sensitivities"),
    ],
)
def test_arguments_of_other_types(call, said, lander, scene):
    assert str(complaint(lambda: call(lander, scene))).startswith(said)


def test_rows_of_a_table_replace_numbers(lander, scene):
    row = pd.DataFrame({"slope_deg": [5, 10], "friction": [0.9, 0.8]}).iloc[1]
    assert scene.replace(row) == scene.replace(slope_deg=10, friction=0.8)
    assert lander.replace(pd.Series({"mass_slug": 21})) == lander.replace({"mass_slug": 21})


def test_files_that_are_no_results(tmp_path):
    files = [("a.csv", b"x,y\n1,2\n"), ("b.csv", b""), ("c.csv", b"\xff\xfe"), ("d.csv", b"x\n1,2\n1,2,3\n"), ("a.txt", b""), ("a.json", b"{}")]
    for name, content in files:
        (tmp_path / name).write_bytes(content)
        if name == "a.json":
            (tmp_path / "a.csv").unlink()
        assert "expected" in str(complaint(lambda name=name: td.read(tmp_path / name)))


def test_files_that_cannot_be_read_or_written(lander, scene, tmp_path):
    (tmp_path / "file").write_text("")
    measured = {"roll_deg": {"file": str(tmp_path / "none.csv"), "column": "roll_deg"}}
    for call in [
        lambda: td.Vehicle.from_toml(tmp_path),
        lambda: td.run(tmp_path / "none.toml"),
        lambda: td.read(tmp_path / "none.csv"),
        lambda: td.land_many(lander, FAST | {"vehicle": ["", "none.toml"]}, scene=scene, progress=False),
        lambda: td.land_many(lander, FAST, scene=scene, out=tmp_path / "file/landed.csv", progress=False),
        lambda: td.sweep(lander, scene, MAPPED, search=SHORT, out=tmp_path / "file", progress=False),
        lambda: td.sample(lander, scene, measured, 5, 1, progress=False),
    ]:
        with pytest.raises(OSError):
            call()
    (tmp_path / "words.toml").write_bytes(b"name = '\xff'")
    error = complaint(lambda: td.Vehicle.from_toml(tmp_path / "words.toml"))
    assert str(error) == f"{tmp_path / 'words.toml'}: expected text in UTF-8"
