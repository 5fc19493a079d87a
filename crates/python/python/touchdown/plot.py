"""Pictures with matplotlib; each takes axes and returns them.

Needs matplotlib (``pip install touchdown[plot]``).
"""

from __future__ import annotations

from collections.abc import Sequence

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.patches import Patch

from touchdown import _engine
from touchdown._arguments import an_instance, names
from touchdown._html import OUTCOME_COLOURS
from touchdown.errors import InputError

_STABILITY = ["sigma_deg"]
# Steps of an axis that are so many times the least one are gaps.
_WIDE_STEP = 8


def profile(ds: xr.Dataset, ax: Axes | None = None) -> Axes:
    """The transition velocity over one axis, with the bands of landings that end alike.

    Parameters
    ----------
    ds : Dataset
        A sweep over one axis; bands are shown where it has them.
    ax : Axes, optional
        Where to draw; new axes without.
    """
    [axis] = _axes(ds, 1)
    ax = ax or plt.figure().add_subplot()
    along = ds[axis].values
    if "band_outcome" in ds:
        borders = _borders(along)
        kinds = set()
        for index in range(len(along)):
            here = ds.isel({axis: index})
            for band in here.band.values:
                one = here.sel(band=band)
                if outcome := str(one.band_outcome.item()):
                    kinds.add(outcome)
                    ends = [one.band_from.item()] * 2, [one.band_to.item()] * 2
                    colour = OUTCOME_COLOURS[outcome]
                    ax.fill_between(borders[index : index + 2], *ends, color=colour, alpha=0.35, lw=0)
        ax.legend(handles=[Patch(color=OUTCOME_COLOURS[kind], alpha=0.35, label=kind) for kind in sorted(kinds)])
    ax.plot(along, ds.first_transition.values, "k.-", label="first transition")
    ax.set_xlabel(_title(axis))
    ax.set_ylabel(f"V_H, {ds.first_transition.units}")
    ax.set_title(ds.attrs.get("title", ""))
    return ax


def contours(ds: xr.Dataset, ax: Axes | None = None, levels: int | Sequence[float] = 12) -> Axes:
    """The transition velocity over two axes as a contour map, with the edges of a map.

    Parameters
    ----------
    ds : Dataset
        A sweep or a map over two axes.
    ax : Axes, optional
        Where to draw; new axes without.
    levels : int or sequence of float
        Levels, or about how many.
    """
    slow, fast = _axes(ds, 2)
    ax = ax or plt.figure().add_subplot()
    height = _with_gaps(ds.first_transition.transpose(slow, fast))
    filled = ax.contourf(height[fast], height[slow], height, levels=levels, cmap="viridis")
    ax.contour(filled, colors="k", linewidths=0.5)
    ax.figure.colorbar(filled, ax=ax, label=f"V_H, {height.units}")
    if "edge_kind" in ds:
        columns = {ds[name].attrs["column"]: ds[name] for name in ds.data_vars if str(name).startswith("edge")}
        for number in np.unique(ds.edge):
            line = (ds.edge == number).values
            ax.plot(columns[fast].values[line], columns[slow].values[line], "r-", lw=1.5)
    ax.set_xlabel(_title(fast))
    ax.set_ylabel(_title(slow))
    ax.set_title(ds.attrs.get("title", ""))
    return ax


def history(table: pd.DataFrame, ax: Axes | None = None, columns: Sequence[str] = _STABILITY) -> Axes:
    """Columns of a history over time; a panel for columns of one unit.

    Parameters
    ----------
    table : DataFrame
        As `touchdown.Landing.history` gives it.
    ax : Axes, optional
        Where to draw; new axes without.
    columns : sequence of str
        Names of columns; ``#`` stands for every leg.
    """
    an_instance("table", table, pd.DataFrame, "a history, as Landing.history gives it")
    patterns = names("columns", columns)
    if not patterns:
        raise InputError.of_value("columns", columns, "at least one name of a column")
    ax = ax or plt.figure().add_subplot()
    shown = [name for pattern in patterns for name in _matching(table, pattern)]
    units = {_engine.bare_name_and_unit(name)[1] for name in shown}
    if len(units) > 1:
        allowed = "columns of one unit"
        raise InputError(f"columns in {', '.join(sorted(units))}: expected {allowed}", "columns", str(columns), allowed)
    for name in shown:
        ax.plot(table.index, table[name], label=_engine.bare_name_and_unit(name)[0].replace("_", " "))
    ax.set_xlabel("time after first contact, s")
    ax.set_ylabel(", ".join(units))
    ax.legend()
    return ax


def tornado(table: pd.DataFrame, ax: Axes | None = None) -> Axes:
    """What the transition velocity depends on, the strongest on top.

    Parameters
    ----------
    table : DataFrame
        As `touchdown.sensitivity` gives it.
    ax : Axes, optional
        Where to draw; new axes without.
    """
    allowed = "a table of sensitivities, as sensitivity gives it"
    changes = [name for name in an_instance("table", table, pd.DataFrame, allowed) if str(name).startswith("vh_change_")]
    if not changes:
        raise InputError.of_value("table", table, allowed)
    ax = ax or plt.figure().add_subplot()
    column = next(name for name in changes if "error" not in str(name))
    error = str(column).replace("vh_change_", "vh_change_error_")
    unit = str(column).removeprefix("vh_change_")
    searched = table[f"vh_at_plus_span_{unit}"] - table[f"first_transition_{unit}"]
    change = table[column].fillna(searched).dropna()
    change = change.loc[change.abs().sort_values().index]
    labels = [str(name).removeprefix("vehicle.") for name in change.index]
    colours = ["#d1495b" if one < 0 else "#4c9f70" for one in change]
    ax.barh(labels, change, xerr=table[error].loc[change.index], color=colours)
    ax.axvline(0, color="k", lw=0.8)
    ax.set_xlabel(f"change of V_H for 10 % more, or 1 deg of an angle, {_engine.bare_name_and_unit(str(column))[1]}")
    return ax


def _axes(ds: xr.Dataset, count: int) -> list[str]:
    an_instance("ds", ds, xr.Dataset, "a dataset, as a sweep gives it")
    axes = [str(name) for name in ds.first_transition.dims] if "first_transition" in ds else []
    if len(axes) != count or "point" in axes:
        allowed = f"a sweep of transition velocities over {count} {'axis' if count == 1 else 'axes'}"
        raise InputError(f"the dataset is over {', '.join(axes) or 'none'}: expected {allowed}", allowed=allowed)
    return axes


def _matching(table: pd.DataFrame, pattern: str) -> list[str]:
    if "#" in pattern:
        before, after = pattern.split("#", 1)
        found = [str(name) for name in table if str(name) in {f"{before}{leg}{after}" for leg in range(1, 9)}]
    else:
        found = [pattern] if pattern in table else []
    if not found:
        raise InputError.of_value("columns", pattern, f"columns of the history: {', '.join(map(str, table))}")
    return found


def _with_gaps(height: xr.DataArray) -> xr.DataArray:
    """Values along rising axes, with nothing between those that are far apart, such as slopes of −80 and 80 deg."""
    for axis in map(str, height.dims):
        height = height.sortby(axis)
        along = height[axis].values
        steps = np.diff(along)
        wide = steps > _WIDE_STEP * steps.min(initial=np.inf)
        amid = ((along[1:] + along[:-1]) / 2)[wide]
        height = height.reindex({axis: np.sort(np.concatenate([along, amid]))})
    return height


def _borders(along: np.ndarray[tuple[int], np.dtype[np.float64]]) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Half way between values, and as far beyond the first and the last."""
    if len(along) == 1:
        return np.array([along[0] - 0.5, along[0] + 0.5])
    middle = (along[1:] + along[:-1]) / 2
    return np.concatenate([[2 * along[0] - middle[0]], middle, [2 * along[-1] - middle[-1]]])


def _title(name: str) -> str:
    bare, unit = _engine.bare_name_and_unit(name)
    words = bare.removeprefix("vehicle.").replace("_", " ")
    return words if unit == "1" else f"{words}, {unit}"
