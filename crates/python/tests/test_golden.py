"""The corpus of the command line, landed and swept by the package."""

from __future__ import annotations

import pandas as pd
import pytest

import touchdown as td


@pytest.fixture
def golden(root):
    """Its folder."""
    return root / "crates/touchdown/tests/golden"


def same(told: pd.Series, known: pd.Series) -> bool:
    """Whether two columns have the same bits and gaps."""
    equal = told.to_numpy(dtype=object) == known.to_numpy(dtype=object)
    return bool((equal | (told.isna() & known.isna()).to_numpy()).all())


@pytest.mark.parametrize(("units", "table"), [("US", "landings"), ("SI", "methods")])
def test_land_many_gives_every_number_of_the_corpus(units, table, golden):
    cases = pd.read_csv(golden / f"input/{table}.csv", dtype={"case": str, "solver.rules": str})
    cases = cases.drop(columns="case")
    if "vehicle" in cases:
        cases["vehicle"] = [str(golden / "input" / name) for name in cases.vehicle]
    expected = td.read(golden / f"expected/{table}/{table}.csv").reset_index(drop=True)
    lander = td.Vehicle.from_toml(golden / "input/three.toml")
    # Rows that fill the same columns: a table of the package has no gaps in the numbers of vehicles and solvers.
    for _, rows in cases.groupby(cases.notna().apply(tuple, axis=1)):
        landed = td.land_many(lander, rows.dropna(axis=1), units=units, progress=False)
        known = expected.loc[rows.index]
        for column in landed.columns.drop("outcome_class"):
            assert same(landed[column], known[column]), (column, rows.index)


@pytest.mark.parametrize("name", ["first-si", "map-two", "sensitivity", "latin-hypercube", "sobol"])
def test_sweeps_of_the_package_write_the_corpus(name, golden, tmp_path):
    td.run(golden / f"input/{name}.toml", tmp_path)
    for file in (golden / "expected" / name).glob("*.csv"):
        assert (tmp_path / file.name).read_bytes() == file.read_bytes(), file.name
