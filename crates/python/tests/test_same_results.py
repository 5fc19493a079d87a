"""The numbers of the command line, bit for bit."""

from __future__ import annotations

import json

import numpy as np
import pandas as pd
import pytest

import touchdown as td

from conftest import SHORT

SURVEYOR = "sweeps/vehicles/surveyor-table-4-1.toml"
TOUCHDOWN = ["--vertical-velocity", 14, "--horizontal-velocity", 11.25, "--cross-slope", 180, "--slope", 15, "--friction", 1]


def test_figure_4_9_has_the_bytes_that_are_committed(root, tmp_path):
    found = td.run(root / "sweeps/figure-4-09.toml", tmp_path)
    for file in ["figure-4-09.csv", "figure-4-09-bands.csv"]:
        assert (tmp_path / file).read_bytes() == (root / "results" / file).read_bytes()
    committed = td.read(root / "results/figure-4-09.csv")
    assert found.drop_attrs(deep=False).identical(committed.drop_attrs(deep=False))
    # The record names the file as it was given.
    input_of = lambda ds: {k: v for k, v in json.loads(ds.input).items() if not k.endswith("_file")}  # noqa: E731
    assert input_of(found) == input_of(committed)


def test_reference_landings_are_those_of_the_command_line(root, tmp_path, program, lander):
    table = pd.read_csv(root / "crates/dynamics/tests/reference/landings.csv")
    cases = table.loc[:, "vertical_velocity_fps":"friction"].astype(float)
    files = {"table-4-1": SURVEYOR, "sample-deck": "sweeps/vehicles/surveyor-sample-deck.toml"}
    cases.insert(0, "vehicle", [str(root / files[name]) for name in table.vehicle])
    cases.to_csv(tmp_path / "cases.csv", index=False)
    program("land", "--vehicle", SURVEYOR, "--cases", tmp_path / "cases.csv", "--out", tmp_path / "out.csv", "--quiet")
    expected = td.read(tmp_path / "out.csv").reset_index(drop=True)

    landed = td.land_many(lander, cases, progress=False)
    classes = landed.outcome_class.astype(str)
    words = {"stable": "stable", "unstable": "unstable", "bottomed": "bottomed", "failure": "failure"}
    assert (classes == expected.outcome.str.split("-").str[0].map(words).fillna("undecided")).all()
    assert list(landed.columns.drop("outcome_class")) == list(expected.columns)
    for column in expected:
        told, known = landed[column], expected[column]
        same = told.to_numpy(dtype=object) == known.to_numpy(dtype=object)
        assert (same | (told.isna() & known.isna())).all(), column

    own = table.vehicle.eq("table-4-1") & (table.index < 80)
    for row, conditions in cases[own].drop(columns="vehicle").iterrows():
        alone = td.land(lander, td.Scene(**conditions)).to_series()
        pd.testing.assert_series_equal(alone, landed.loc[row].astype(object), check_names=False, check_exact=True)


@pytest.mark.parametrize("units", ["US", "SI"])
def test_a_landing_and_its_history_are_those_of_the_command_line(units, root, tmp_path, program, lander, scene):
    history = tmp_path / "history.csv"
    told = json.loads(
        program("land", "--vehicle", SURVEYOR, *TOUCHDOWN, "--json", "--history", history, "--interval", 0.05, "--units", units)
    )
    landing = td.land(lander, scene)
    pd.testing.assert_frame_equal(landing.history(0.05, units=units), td.read(history), check_exact=True)
    known = pd.Series(told["result"] | {"failure": np.nan}, dtype=object).fillna(np.nan)
    pd.testing.assert_series_equal(landing.to_series(units).drop("outcome_class"), known, check_exact=True)
    if units == "US":
        assert landing.why == told["why"]
        assert landing.strut_work_ftlb == tuple(told[f"strut_work_{leg}_ftlb"] for leg in (1, 2, 3))
        assert landing.final_kinetic_energy_ftlb == told["final_kinetic_energy_ftlb"]


def test_a_boundary_has_the_bands_of_a_sweep(lander, scene):
    search = SHORT | {"bands": "all", "to_fps": 24}
    found = td.boundary(lander, scene, search=search, progress=False)
    swept = td.sweep(lander, scene, {"roll_deg": [0]}, search=search, progress=False).squeeze()
    assert found.first_transition_fps == swept.first_transition.item()
    assert found.landings == swept.landings.item()
    assert [band.to_fps for band in found.bands] == swept.band_to.values.tolist()
    assert [band.kind for band in found.bands] == swept.band_kind.values.tolist()


def test_results_do_not_depend_on_threads(lander, scene):
    search = SHORT | {"bands": "all"}
    one, two = (td.sweep(lander, scene, {"roll_deg": [0, 20]}, search=search, threads=n, progress=False) for n in (1, 2))
    assert one.identical(two)
