"""Results of the command line, read back."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import pandas as pd
import xarray as xr

from touchdown._arguments import a_path, text_of
from touchdown.datasets import BESIDE, dataset, is_of_points
from touchdown.errors import InputError

# Every digit counts; from version 3 on pandas reads all of them anyway.
_EXACT: Any = {} if int(pd.__version__.split(".")[0]) >= 3 else {"float_precision": "round_trip"}
_COUNTS = {
    *("landings", "derivative_evaluations", "steps", "points", "level", "band", "edge", "triangle"),
    *("toppled", "bottomed", "undecided", "failed", "not_stable"),
    *("stable_landings_below", "patchy_landings", "patchy_not_stable"),
}
_KINDS = "a table or record that touchdown has written (.csv, .parquet, .json)"


def read(path: str | os.PathLike[str]) -> xr.Dataset | pd.DataFrame:
    """Read what the command line, or this package, has written.

    Parameters
    ----------
    path : path
        A table of a sweep (CSV or Parquet) or its record (JSON); a history; a table of landings.

    Returns
    -------
    Dataset
        Of the table or record of a sweep, with all tables beside it: the same as `touchdown.sweep` returns.
    DataFrame
        Of a history, indexed by ``t_s``; of landings, indexed by ``case``; of another table of a sweep, as it is.

    Raises
    ------
    InputError
        When it is something else.
    """
    path = Path(a_path("path", path))
    if path.suffix == ".json":
        path = _table_of(path)
    table = _table(path)
    columns = table.columns
    if columns[0] == "t_s":
        return table.set_index("t_s")
    if columns[0] == "case" and "outcome" in columns:
        return table.set_index("case")
    if not is_of_points(table):
        if any(path.stem.endswith(f"-{end}") for end in BESIDE):
            return table
        raise InputError(f"{path}: expected {_KINDS}", allowed=_KINDS)
    beside = {end: path.with_name(f"{path.stem}-{end}{path.suffix}") for end in BESIDE}
    record = path.with_suffix(".json")
    return dataset(
        table,
        {end: _table(file) for end, file in beside.items() if file.is_file()},
        json.loads(text_of(str(record))) if record.is_file() else None,
    )


def _table_of(record: Path) -> Path:
    """The table of the points of a record."""
    for ending in (".csv", ".parquet"):
        if (table := record.with_suffix(ending)).is_file():
            return table
    raise InputError(f"{record}: there is no table beside it: expected {record.stem}.csv", allowed=f"{record.stem}.csv")


def _table(path: Path) -> pd.DataFrame:
    match path.suffix:
        case ".csv":
            try:
                # Names of cases are words, whatever they look like.
                table: pd.DataFrame = pd.read_csv(path, keep_default_na=False, na_values=[""], dtype={"case": str}, **_EXACT)
            except (pd.errors.EmptyDataError, pd.errors.ParserError, UnicodeDecodeError):
                raise InputError(f"{path}: expected {_KINDS}", allowed=_KINDS) from None
            # Numbers are numbers, whether or not they happen to be whole.
            whole = table.select_dtypes("integer").columns.difference(list(_COUNTS))
            return table.astype(dict.fromkeys(whole, float))
        case ".parquet":
            return pd.read_parquet(path)
        case _:
            raise InputError(f"{path}: expected {_KINDS}", allowed=_KINDS)
