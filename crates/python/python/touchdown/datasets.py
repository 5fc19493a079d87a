"""Tables of sweeps as datasets of xarray."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr

from touchdown import _engine

# The first column of results of a point.
_FIRST_RESULT = ("first_transition_to", "outcome")
_OF_LEG = re.compile(r"(max_strut_force|pad_contact|block_contact)_(\d+)")
# Tables beside that of the points: what their variables begin with, and the dimension of their rows at each point.
_AT_EACH_POINT = {"bands": ("band", "band"), "sensitivity": ("sensitivity", "parameter")}
# The same of those that are about all points together.
_OF_ALL_POINTS = {
    "probabilities": ("bin", "bin"),
    "quantiles": ("quantile", "quantile"),
    "distribution": ("interval", "interval"),
    "edges": ("edge", "edge_point"),
    "surface": ("corner", "corner"),
}
#: What follows the name of a sweep in the names of its tables.
BESIDE = [*_AT_EACH_POINT, *_OF_ALL_POINTS, "grid"]


def is_of_points(table: pd.DataFrame) -> bool:
    """Whether a table has a row for each point of a sweep."""
    return any(name in table.columns for name in _FIRST_RESULT) and not {"band", "parameter", "case"} & set(table.columns)


def dataset(points: pd.DataFrame, beside: Mapping[str, pd.DataFrame], record: Mapping[str, Any] | None) -> xr.Dataset:
    """A dataset of the tables of a sweep.

    Parameters
    ----------
    points : DataFrame
        The table of the points.
    beside : mapping of str to DataFrame
        The others, by what follows the name of the sweep in theirs.
    record : mapping, optional
        The record of the sweep.
    """
    axes = _axes(points)
    if "grid" in beside:
        made = _Grid(beside["grid"], axes, []).dataset(beside["grid"].columns[len(axes) :])
        made = made.merge(_rows("point", "point", points))
    else:
        given = (record or {}).get("input", {})
        grid = _Grid(points, axes, given.get("axes_that_move_together", []), "sample" in given)
        made = grid.dataset(points.columns[len(axes) :])
        for end, (prefix, dimension) in _AT_EACH_POINT.items():
            if end in beside:
                made = made.merge(grid.beside(beside[end], prefix, dimension))
    for end, (prefix, dimension) in _OF_ALL_POINTS.items():
        if end in beside:
            made = made.merge(_rows(prefix, dimension, beside[end]))
    return made.assign_attrs(_attributes(record))


def _axes(points: pd.DataFrame) -> list[str]:
    columns = list(points.columns)
    return columns[: min(columns.index(name) for name in _FIRST_RESULT if name in columns)]


class _Grid:
    """Where each row of a table stands in a grid; of a sample there is one dimension, the points."""

    def __init__(self, points: pd.DataFrame, axes: list[str], together: Iterable[list[str]], is_sample: bool = False) -> None:
        self.points = points
        self.axes = axes
        groups = [group for group in together if set(group) <= set(axes)]
        zipped = {name for group in groups for name in group}
        groups = sorted([*groups, *([name] for name in axes if name not in zipped)], key=lambda group: axes.index(group[0]))
        places = [points.groupby(group, sort=False, dropna=False).ngroup().to_numpy() for group in groups]
        shape = tuple(int(place.max(initial=-1)) + 1 for place in places)
        if axes and not is_sample and np.prod(shape) == len(points):
            self.groups, self.dimensions, self.shape = groups, [group[0] for group in groups], shape
            self.flat = np.ravel_multi_index(places, shape)
        else:
            self.groups, self.dimensions, self.shape = [], ["point"], (len(points),)
            self.flat = np.arange(len(points))

    def dataset(self, columns: Iterable[str]) -> xr.Dataset:
        made = xr.Dataset(coords=self._coordinates())
        if not self.groups:
            made = made.merge({name: _variable(["point"], self.points[name], name)[1] for name in self.axes})
        legs: dict[str, list[str]] = {}
        for column in columns:
            bare, _ = _engine.bare_name_and_unit(column)
            if of_leg := _OF_LEG.fullmatch(bare):
                legs.setdefault(of_leg[1], []).append(column)
            else:
                name, variable = _variable(self.dimensions, self._in_place(self.points[column]), column)
                made[name] = variable
        for name, of_legs in legs.items():
            values = np.stack([self._in_place(self.points[column]) for column in of_legs], axis=-1)
            _, made[name] = _variable([*self.dimensions, "leg"], values, of_legs[0], name)
        if legs:
            made = made.assign_coords(leg=np.arange(1, max(map(len, legs.values())) + 1))
        return made

    def beside(self, table: pd.DataFrame, prefix: str, dimension: str) -> xr.Dataset:
        """A table with several rows for a point."""
        keys = pd.MultiIndex.from_frame(self.points[self.axes])
        point = self.flat[keys.get_indexer(pd.MultiIndex.from_frame(table[self.axes]))]
        labels, names = pd.factorize(table[dimension], sort=dimension == "band")
        labelled = np.asarray(names, dtype=str if dimension == "parameter" else int)
        made = xr.Dataset(coords={dimension: labelled})
        shape = (int(np.prod(self.shape)), len(names))
        for column in table.columns.drop([*self.axes, dimension]):
            values = _column(table[column])
            whole = np.full(shape, _nothing(values), dtype=values.dtype)
            whole[point, labels] = values
            name, variable = _variable([*self.dimensions, dimension], whole.reshape(*self.shape, -1), column)
            made[f"{prefix}_{name}"] = variable
        return made

    def _coordinates(self) -> dict[str, xr.Variable]:
        coordinates = {}
        for axis, group in enumerate(self.groups):
            place = np.unravel_index(self.flat, self.shape)[axis]
            for name in group:
                values = _column(self.points[name])
                along = np.empty(self.shape[axis], dtype=values.dtype)
                along[place] = values
                coordinates[name] = xr.Variable(group[0], along, _units(name))
        return coordinates

    def _in_place(self, column: pd.Series[Any]) -> Any:
        values = _column(column)
        whole = np.empty_like(values)
        whole[self.flat] = values
        return whole.reshape(self.shape)


def _rows(prefix: str, dimension: str, table: pd.DataFrame) -> xr.Dataset:
    """A table whose rows are a dimension of their own."""
    variables = {}
    for column in table.columns:
        name, variable = _variable([dimension], table[column], column)
        variables[name if name.startswith(prefix) else f"{prefix}_{name}"] = variable
    return xr.Dataset(variables)


def _variable(dimensions: list[str], values: Any, column: str, bare: str | None = None) -> tuple[str, xr.Variable]:
    """The name of a column without its unit, and its values with it."""
    values = _column(values) if isinstance(values, pd.Series) else values
    name = bare or _engine.bare_name_and_unit(column)[0]
    return name, xr.Variable(dimensions, values, _units(column))


def _units(column: str) -> dict[str, str]:
    return {"units": _engine.bare_name_and_unit(column)[1], "column": column}


def _column(column: pd.Series[Any]) -> Any:
    """Numbers as they are, words as words, of which an empty one stands for none."""
    if column.dtype.kind in "iuf":
        return column.to_numpy()
    if column.isna().all():
        return column.to_numpy(dtype=float)
    return column.fillna("").astype(str).to_numpy(dtype=str)


def _nothing(values: Any) -> Any:
    return "" if values.dtype.kind == "U" else np.nan


def _attributes(record: Mapping[str, Any] | None) -> dict[str, str]:
    if record is None:
        return {}
    program = record["program"]
    return {
        "title": record["title"],
        "program": f"{program['name']} {program['version']}, model {program['model']}",
        "input_fingerprint": record["input_fingerprint"],
        "input": json.dumps(record["input"], ensure_ascii=False),
        "counts": json.dumps(record["counts"], ensure_ascii=False),
    }
