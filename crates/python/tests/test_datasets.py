"""Sweeps, maps and samples as datasets."""

from __future__ import annotations

import json

import numpy as np
import pandas as pd
import polars
import pytest
import xarray as xr

import touchdown as td

from conftest import SHORT


def test_a_grid_has_its_axes_as_coordinates(lander, scene):
    axes = {"cross_slope_deg": np.array([150, 180]), "vehicle.strut.preload_lb": [180, 200]}
    found = td.sweep(lander, scene, axes, search=SHORT, progress=False)
    assert found.first_transition.dims == ("cross_slope_deg", "vehicle.strut.preload_lb")
    assert found.cross_slope_deg.values.tolist() == [150, 180]
    assert found.cross_slope_deg.units == "deg" and found.first_transition.units == "ft/s"
    stiff = lander.replace({"strut.preload_lb": 200})
    alone = td.boundary(stiff, scene.replace(cross_slope_deg=150), search=SHORT, progress=False)
    assert found.first_transition.sel({"cross_slope_deg": 150, "vehicle.strut.preload_lb": 200}) == alone.first_transition_fps
    given = json.loads(found.input)
    assert given["vehicle"]["mass_slug"] == lander.to_dict()["mass_slug"]
    assert given["scene"]["friction"] == 1 and "horizontal_velocity_fps" not in given["scene"]


def test_results_in_si_say_so(lander, scene):
    found = td.sweep(lander, scene, {"roll_deg": [0]}, search=SHORT, units="SI", progress=False)
    feet = td.sweep(lander, scene, {"roll_deg": [0]}, search=SHORT, progress=False)
    assert found.first_transition.units == "m/s"
    assert found.first_transition.item() == pytest.approx(0.3048 * feet.first_transition.item(), rel=1e-14)


def test_bands_and_sensitivities_have_dimensions_of_their_own(lander, scene):
    search = SHORT | {"bands": "all"}
    found = td.sweep(lander, scene, {"roll_deg": [0, 30]}, search=search, sensitivity=["friction"], progress=False)
    assert found.band_outcome.dims == ("roll_deg", "band")
    assert found.band_outcome.sel(roll_deg=0, band=1) == "stable"
    assert found.sensitivity_dvh_dp_fps_per_unit.dims == ("roll_deg", "parameter")
    alone = td.sensitivity(lander, scene, ["friction"], search=SHORT, progress=False)
    assert alone.dvh_dp_fps_per_unit["friction"] == found.sensitivity_dvh_dp_fps_per_unit.sel(roll_deg=0).item()


def test_axes_that_move_together_share_a_dimension(lander, scene):
    together = {
        "pitch_deg": {"values": [0, 1, 2], "zip": "a"},
        "friction": {"values": [1.0, 0.9, 0.8], "zip": "a"},
    }
    found = td.sweep(lander, scene, together, job="outcome", progress=False)
    assert found.outcome.dims == ("pitch_deg",)
    assert found.friction.dims == ("pitch_deg",) and found.friction.values.tolist() == [1.0, 0.9, 0.8]
    assert found.max_strut_force.dims == ("pitch_deg", "leg")


def test_words_are_axes_too(lander, scene):
    found = td.sweep(lander, scene, {"solver.crush_rule": ["pivot-rate", "section"]}, job="outcome", progress=False)
    rules = found.end_time.sel({"solver.crush_rule": "section"})
    assert rules == td.land(lander, scene, {"crush_rule": "section", "tolerance": 3e-5}).end_time_s


def test_samples_have_points_and_probabilities(lander, scene, tmp_path):
    (tmp_path / "measured.csv").write_text("friction\n0.9\n1.0\n1.1\n")
    axes = {
        "horizontal_velocity_fps": {"mean": 11, "sd": 1},
        "friction": {"file": str(tmp_path / "measured.csv"), "column": "friction"},
    }
    found = td.sample(lander, scene, axes, 40, 1966, progress=False)
    assert found.sizes["point"] == 40 and set(found.friction.values) <= {0.9, 1.0, 1.1}
    everything = found.isel(bin=0)
    toppled = found.outcome.str.startswith("unstable").sum()
    assert everything.bin_axis == "all" and everything.bin_toppled == toppled
    searched = td.sample(lander, scene, {"friction": {"from": 0.8, "to": 1}}, 10, 1, job="boundary", search=SHORT, progress=False)
    assert searched.first_transition.dims == ("point",) and searched.friction.dims == ("point",)
    single = td.sample(lander, scene, axes, 1, 1966, progress=False)
    assert single.outcome.dims == ("point",)
    assert {"quantile_share", "interval_share"} <= set(searched.data_vars)


def test_maps_have_a_regular_grid_points_and_edges(lander, scene):
    found = td.map(
        lander, scene, {"cross_slope_deg": [160, 180], "roll_deg": [0, 20, 40]}, {"cross_slope_deg": 10, "roll_deg": 10},
        error_fps=1, grid_steps=2, search=SHORT, progress=False,
    )  # fmt: skip
    assert found.first_transition.dims == ("cross_slope_deg", "roll_deg")
    assert found.sizes["cross_slope_deg"] == 3 and found.sizes["roll_deg"] == 5
    assert found.point_first_transition.sizes["point"] >= 6
    assert {"edge_kind", "corner_triangle"} <= set(found.data_vars)


def test_a_map_over_one_axis_has_its_points_bands_and_edges(lander, scene):
    found = td.map(
        lander, scene, {"roll_deg": [0, 20, 40]}, {"roll_deg": 5}, error_fps=0.5, search={**SHORT, "bands": "all"}, progress=False
    )
    rolls = found.roll_deg.values
    assert found.first_transition.dims == ("roll_deg",) and len(rolls) > 3 and (np.diff(rolls) > 0).all()
    assert found.band_to.dims == ("roll_deg", "band")
    assert {"edge_roll", "edge_kind"} <= set(found.variables)
    assert td.plot.profile(found).lines


def test_errors_of_a_map_in_si(lander, scene):
    def mapped(**errors):
        axes = {"cross_slope_deg": [160, 180], "roll_deg": [0, 20]}
        width = {"cross_slope_deg": 10, "roll_deg": 10}
        return td.map(lander, scene, axes, width, search=SHORT, progress=False, **errors)

    feet, metres = mapped(error_fps=1, jump_fps=0.5), mapped(error_mps=0.3048, jump_mps=0.1524)
    assert metres.drop_attrs().equals(feet.drop_attrs())
    with pytest.raises(td.InputError, match="one spelling of a quantity"):
        mapped(error_fps=1, error_mps=0.3)


def test_results_of_the_command_line_read_as_the_same_dataset(root):
    surface = td.read(root / "results/surface-4-20.json")
    assert surface.first_transition.shape == (81, 49)
    table = pd.read_csv(root / "results/surface-4-20.csv")
    row = table[(table.cross_slope_deg == 180) & (table.roll_deg == 10)].first_transition_fps.item()
    assert surface.first_transition.sel(cross_slope_deg=180, roll_deg=10) == row
    trade = td.read(root / "results/trade/trade-damping-friction.csv")
    assert len(trade.first_transition.dims) == 6
    assert td.read(root / "results/figure-4-09-bands.csv").columns[0] == "roll_deg"


def test_tables_come_as_numpy_pandas_or_polars_make_them(lander, scene):
    numbers = np.array([10, 11, 12], dtype=np.float32)
    frame = pd.DataFrame({"horizontal_velocity_fps": numbers}, index=pd.Index(["a", "b", "c"], name="run"))
    expected = td.land_many(lander, frame, scene=scene, progress=False)
    assert expected.index.equals(frame.index)
    for table in [{"horizontal_velocity_fps": numbers}, {"horizontal_velocity_fps": [10, 11, 12]}]:
        pd.testing.assert_frame_equal(td.land_many(lander, table, scene=scene, progress=False), expected.reset_index(drop=True))
    strided = {"horizontal_velocity_fps": np.repeat(numbers, 2)[::2]}
    pd.testing.assert_frame_equal(td.land_many(lander, strided, scene=scene, progress=False), expected.reset_index(drop=True))


def test_outcomes_have_the_same_categories_in_every_call(lander, scene):
    first = td.land_many(lander, {"roll_deg": [0]}, scene=scene, progress=False)
    second = td.land_many(td.vehicles.six_legs(), {"roll_deg": [5]}, scene=scene.replace(horizontal_velocity_fps=3), progress=False)
    assert set(first.outcome_class.cat.categories) == {"stable", "unstable", "bottomed", "undecided", "failure"}
    assert {"stable-rockback", "unstable-toppled", "time-expired", "bottomed-block-8"} <= set(first.outcome.cat.categories)
    for name in ("outcome", "outcome_class"):
        assert first[name].dtype == second[name].dtype == pd.concat([first, second])[name].dtype


def test_single_values_are_those_of_all_rows(lander, scene):
    table = {"friction": 0.9, "roll_deg": [0, 5], "pitch_deg": np.float64(1), "solver.crush_rule": "section", "note": None}
    full = {"friction": [0.9, 0.9], "roll_deg": [0, 5], "pitch_deg": [1, 1], "solver.crush_rule": ["section"] * 2}
    landed = td.land_many(lander, table, scene=scene, progress=False)
    pd.testing.assert_frame_equal(landed, td.land_many(lander, full, scene=scene, progress=False))
    assert len(td.land_many(lander, {"roll_deg": 5}, scene=scene, progress=False)) == 1


def test_tables_without_rows_have_results_without_rows(lander, scene):
    table = pd.DataFrame({"roll_deg": [0.0], "note": ["a"]}, index=pd.Index(["b"], name="run"))
    full = td.land_many(lander, table, scene=scene, progress=False)
    for none in (table.iloc[:0], {"roll_deg": [], "friction": 0.9}):
        landed = td.land_many(lander, none, scene=scene, progress=False)
        assert len(landed) == 0 and landed.dtypes.drop("failure").equals(full.dtypes.drop("failure"))
    assert td.land_many(lander, table.iloc[:0], scene=scene, progress=False).index.name == "run"
    with pytest.raises(td.InputError, match="column rol_deg: no such column; did you mean roll_deg"):
        td.land_many(lander, {"rol_deg": []}, scene=scene, progress=False)


@pytest.mark.parametrize("values", [xr.DataArray([0.0, 10.0]), polars.Series([0.0, 10.0]), pd.Series([0, 10]), range(0, 11, 10)])
def test_axes_come_as_arrays_of_any_kind(values, lander, scene):
    found = td.sweep(lander, scene, {"roll_deg": values}, search=SHORT, progress=False)
    assert found.equals(td.sweep(lander, scene, {"roll_deg": [0, 10]}, search=SHORT, progress=False))


def test_a_row_becomes_a_landing(lander, scene, root, tmp_path):
    scene = scene.replace(gravity="mars", thrust={"time_s": [0, 1], "force_lb": [100, 0]}, footing=[{}, {"height_m": 0.1}])
    table = pd.DataFrame({
        "case": ["a", "b", "c"],
        "roll_deg": pd.array([5, None, 10], dtype="Float64"),
        "gravity_mps2": [3.7, 1.62, 9.8],
        "vehicle": [None, str(root / "sweeps/vehicles/surveyor-si.toml"), None],
        "vehicle.strut.preload_n": [800, 810, 820],
        "vehicle.legs[2].strut.preload_lb": [200, 190, 180],
        "thrust.scale": [0, 1, 2],
        "footing[1].height_m": [0, 0.05, 0.1],
        "solver.crush_rule": ["section", "pivot-rate", "section"],
        "solver.tolerance": [1e-6, 1e-7, 1e-6],
        "solver.rules": [None, "1966", "physical"],
        "note": "none",
    })
    solver = {"tolerance": 1e-5, "time_limit_s": 20}
    landed = td.land_many(lander, table, scene=scene, solver=solver, progress=False)
    for number in range(3):
        landing = td.land_row(lander, table.iloc[number], scene=scene, solver=solver)
        pd.testing.assert_series_equal(landing.to_series(), landed.iloc[number], check_names=False, check_dtype=False)
    assert landing.history(0.1).index[-1] == pytest.approx(landing.end_time_s, abs=0.1)
    assert landing.scene.thrust["scale"] == 2 and landing.solver["crush_rule"] == "section"
    assert td.land_row(lander, {"roll_deg": 5}, scene=scene, units="SI").units == "SI"
    with pytest.raises(td.InputError, match="did you mean roll_deg"):
        td.land_row(lander, {"rol_deg": 5}, scene=scene)


def test_a_point_of_a_sample_becomes_a_landing(lander, scene):
    axes = {"horizontal_velocity_fps": {"mean": 11, "sd": 1}, "friction": {"from": 0.9, "to": 1}}
    drawn = td.sample(lander, scene, axes, 5, 1, progress=False)
    point = drawn.isel(point=3)
    landing = td.land_row(lander, point[list(axes)], scene=scene, solver={"tolerance": 3e-5})
    assert landing.end_time_s == point.end_time.item()


def test_cases_keep_their_names(lander, scene, tmp_path):
    td.land_many(lander, {"case": ["01", "2"], "roll_deg": [0, 5]}, scene=scene, out=tmp_path / "landed.csv", progress=False)
    assert td.read(tmp_path / "landed.csv").index.tolist() == ["01", "2"]


@pytest.mark.parametrize("units", ["US", "SI"])
def test_parquet_has_the_table_of_csv(units, lander, scene, tmp_path):
    def landed(name, rolls=(0, 5), **options):
        table = {"case": ["01", "2"], "roll_deg": rolls, "vehicle.strut.preload_lb": [185.0, 150.0]}
        return td.land_many(lander, table, scene=scene, units=units, out=tmp_path / name, progress=False, **options)

    found = landed("landed.parquet")
    pd.testing.assert_frame_equal(found, landed("landed.csv"))
    assert not list(tmp_path.glob("*.journal"))
    parquet = polars.read_parquet(tmp_path / "landed.parquet")
    csv = polars.read_csv(tmp_path / "landed.csv", schema_overrides=parquet.schema)
    assert parquet.equals(csv)
    assert parquet["case"].to_list() == ["01", "2"]
    # What is there already comes out the same, or stays.
    pd.testing.assert_frame_equal(found, landed("landed.parquet"))
    with pytest.raises(td.InputError, match="holds other results"):
        landed("landed.parquet", (0, 6))
    assert landed("landed.parquet", (0, 6), overwrite=True).end_time_s.iloc[1] != found.end_time_s.iloc[1]
    (tmp_path / "mine.parquet").write_text("mine")
    with pytest.raises(td.InputError, match="exists and is no earlier result"):
        landed("mine.parquet")


def test_series_keep_their_index(lander, scene):
    speeds = pd.Series([10.0, 11.0], index=pd.Index(["a", "b"], name="run"))
    landed = td.land_many(lander, {"roll_deg": [0, 5], "horizontal_velocity_fps": speeds, "pitch_deg": 0 * speeds}, scene=scene, progress=False)
    assert landed.index.equals(speeds.index) and landed.index.name == "run"
    others = {"horizontal_velocity_fps": speeds, "roll_deg": pd.Series([0.0, 5.0], index=["b", "a"])}
    with pytest.raises(td.InputError, match="column roll_deg has another index: expected that of column horizontal_velocity_fps"):
        td.land_many(lander, others, scene=scene, progress=False)


def test_axes_win_over_thrust_and_footing_of_the_scene(lander, scene):
    def swept(given: td.Scene, name: str) -> list[float]:
        return td.sweep(lander, given, {name: [0.1, 0.2]}, job="outcome", progress=False).end_time.values.tolist()

    thrust = {"time_s": [0, 1], "force_lb": [100, 0], "offset_x_ft": 0.5}
    pushed = scene.replace(thrust=thrust | {"scale": 2})
    assert swept(pushed, "thrust.scale") == swept(scene.replace(thrust=thrust), "thrust.scale")
    rough = scene.replace(footing=[{"height_ft": 0.5}, {"height_m": 0.1}])
    assert swept(rough, "footing[1].height_m") == swept(scene.replace(footing=[{}, {"height_m": 0.1}]), "footing[1].height_m")
    assert swept(rough, "footing[2].height_ft") == swept(scene.replace(footing=[{"height_ft": 0.5}]), "footing[2].height_ft")


def test_soil_by_name_and_by_numbers(lander, scene):
    named = scene.replace(soil="surveyor-7")
    numbers = {"bearing_strength_kpa": 21, "bearing_depth_cm": 5, "rebound": 0.004}
    told = scene.replace(soil=numbers)
    sunk = td.land(lander, named)
    assert sunk.max_sinkage_m == pytest.approx(td.land(lander, told).max_sinkage_m, abs=1e-9)
    assert min(sunk.max_sinkage_m) > 0.02 and td.land(lander, scene).max_sinkage_m == (0, 0, 0)
    for soil in (named, told):
        landed = td.land_many(lander, {"soil.bearing_strength_kpa": [21.0, 55.0]}, scene=soil, progress=False)
        assert landed.max_sinkage_1_ft[0] == pytest.approx(sunk.max_sinkage_ft[0], abs=1e-9)
        assert landed.max_sinkage_1_ft[1] < landed.max_sinkage_1_ft[0]
    swept = td.sweep(lander, told, {"soil.bearing_strength_kpa": [55.0]}, job="outcome", progress=False)
    assert swept.max_sinkage_1.values[0] == pytest.approx(landed.max_sinkage_1_ft[1], rel=1e-2)


def test_a_scene_gives_what_the_table_does_not(lander, scene):
    rough = scene.replace(gravity="mars", footing=[{"height_ft": 0.2}, {"height_m": 0.1}])
    landed = td.land_many(lander, {"footing[1].height_m": [0.0, 0.05], "roll_deg": [0, 10]}, scene=rough, progress=False)
    for row, height in enumerate([0.0, 0.05]):
        alone = td.land(lander, rough.replace(footing=[{"height_m": height}, {"height_m": 0.1}], roll_deg=10 * row))
        assert landed.end_time_s[row] == alone.end_time_s
    thrust = scene.replace(thrust={"time_s": [0, 1], "force_lb": [100, 0]})
    landed = td.land_many(lander, {"thrust.scale": [None, 2.0]}, scene=thrust, progress=False)
    for row, scale in enumerate([1.0, 2.0]):
        assert landed.end_time_s[row] == td.land(lander, thrust.replace(thrust=thrust.thrust | {"scale": scale})).end_time_s


def test_polars_tables(lander, scene):
    table = polars.DataFrame({"horizontal_velocity_fps": [10.0, 11.0], "roll_deg": [0.0, None]})
    landed = td.land_many(lander, table, scene=scene, progress=False)
    assert landed.end_time_s[1] == td.land(lander, scene.replace(horizontal_velocity_fps=11)).end_time_s
