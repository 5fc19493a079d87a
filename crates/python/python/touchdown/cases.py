"""Many landings."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

import pandas as pd

from touchdown import _engine
from touchdown._arguments import a_dictionary, a_flag, a_path, settings, thread_count
from touchdown._columns import OF_WORDS, columns_of, index_of, series
from touchdown._documents import Document, merged, solver_of
from touchdown._units import Units, checked
from touchdown._warnings import warn_of_journal, warn_of_landings
from touchdown.errors import InputError
from touchdown.landing import Landing, land
from touchdown.progress import Watch, watching
from touchdown.scene import Scene
from touchdown.scene import checked as checked_scene
from touchdown.vehicle import Vehicle, engine_of


def land_many(
    vehicle: Vehicle,
    table: Any,
    *,
    scene: Scene | None = None,
    solver: Document | None = None,
    units: Units | None = None,
    out: str | os.PathLike[str] | None = None,
    overwrite: bool = False,
    threads: int | None = None,
    progress: bool | Watch | None = None,
) -> pd.DataFrame:
    """Compute one landing for each row of a table, in all lanes of all cores.

    Parameters
    ----------
    vehicle : Vehicle
        What lands; columns such as ``vehicle.strut.preload_lb`` replace its numbers.
    table : DataFrame or mapping of arrays, lists, Series or single values
        Columns as those of a table of cases (``touchdown land --cases``): keys of the scene, ``vehicle.…`` and ``solver.…``; a single
        value is that of all rows. A gap (None, ``pandas.NA``, a masked element, a null of polars) leaves a number to `scene`, the
        vehicle, `solver` or the default. NaN among numbers is refused. Tables of polars are taken as well.
    scene : Scene, optional
        Conditions of all rows that the table does not give.
    solver : mapping, optional
        How landings are computed, as in `land`, with the same tolerance, 1e-6, unless given.
    units : {"US", "SI"}, optional
        Units of the results, which are part of the names of the columns; without, those of `use_units`.
    out : path, optional
        CSV or Parquet file for the results too. What is finished is in a journal beside it at once: after an interruption the same call goes on.
    overwrite : bool
        Whether to replace a file with other results. Without, it is refused when all rows are landed and differ from it.
    threads : int, optional
        Threads; all cores without. Results do not depend on it.
    progress : bool or callable, optional
        Whether to show a bar; a callable is told the landings done, the landings wanted, and the landings so far.

    Returns
    -------
    DataFrame
        A row for each row of the table, with its index, or that of all Series in it; columns as those of ``touchdown land --cases``, and after `outcome` its class,
        `outcome_class`: ``"stable"``, ``"unstable"``, ``"bottomed"``, ``"undecided"`` or ``"failure"``. `outcome`, `outcome_class` and
        `failure` are categorical; the first two have all outcomes of up to eight legs as categories, whichever occur. A table without
        rows has a result without rows.

    Raises
    ------
    InputError
        Names row (counted from 0), column and value of the first thing wrong, before anything is landed.

    Warns
    -----
    LandingWarning
        When footpads or blocks gave energy to the motion, or footpads were crushed beyond their hinges.

    Examples
    --------
    >>> import touchdown as td
    >>> scene = td.Scene(vertical_velocity_fps=14, cross_slope_deg=180, slope_deg=15, friction=1.0)
    >>> landed = td.land_many(td.vehicles.surveyor(), {"horizontal_velocity_fps": [11, 12]}, scene=scene)
    >>> list(landed.outcome)
    ['stable-rockback', 'unstable-pitch']
    """
    columns, index = list(columns_of(table).items()), index_of(table)
    conditions = None if scene is None else checked_scene(scene)._engine
    file = None if out is None else a_path("out", out)
    if file is not None and not file.endswith((".csv", ".parquet")):
        raise InputError.of_value("out", out, "a name that ends in .csv or .parquet")
    options = (checked(units), file, a_flag("overwrite", overwrite), thread_count(threads))
    with watching(progress, "landings") as watch:
        found, (of_journal, of_landings) = _engine.land_many(
            engine_of(vehicle), columns, conditions, solver_of(solver), *options, watch
        )
    warn_of_journal(of_journal)
    warn_of_landings(of_landings)
    results = {name: series(*column) for name, column in found}
    return pd.DataFrame(results, index=index, copy=False)


def land_row(
    vehicle: Vehicle,
    row: Mapping[str, Any] | pd.Series[Any],
    *,
    scene: Scene | None = None,
    solver: Document | None = None,
    units: Units | None = None,
) -> Landing:
    """Compute the landing of one row of a table that `land_many` takes: all its results and its history.

    Parameters
    ----------
    vehicle : Vehicle
        As in `land_many`.
    row : Series or mapping
        The row, such as ``table.iloc[3]``; of polars ``table.row(3, named=True)``.
    scene, solver
        As in `land_many`.
    units : {"US", "SI"}, optional
        As in `land`.

    Returns
    -------
    Landing
        The same numbers, bit for bit, as the row of `land_many`; `vehicle`, `scene` and `solver` are those of the row.

    Examples
    --------
    >>> import pandas as pd
    >>> import touchdown as td
    >>> scene = td.Scene(vertical_velocity_fps=14, cross_slope_deg=180, slope_deg=15, friction=1.0)
    >>> table = pd.DataFrame({"horizontal_velocity_fps": [11, 12], "vehicle.strut.preload_lb": 190})
    >>> landing = td.land_row(td.vehicles.surveyor(), table.iloc[1], scene=scene)
    >>> landing.outcome, landing.vehicle.to_dict()["strut"]["preload_lb"]
    ('unstable-pitch', 190)
    """
    said = a_dictionary("row", row)
    # In a row of pandas a gap among words is NaN.
    columns = columns_of({name: None if name.startswith("solver.") and pd.isna(value) else value for name, value in said.items()})
    cells = {name: column[0] for name, column in columns.items()}
    given = {name: _value(name, cell) for name, cell in cells.items() if cell not in (None, "")}
    words = {name: given.pop(name) for name in OF_WORDS if name in given}

    def taken(prefix: str) -> dict[str, float | str]:
        return {name.removeprefix(prefix): given.pop(name) for name in list(given) if name.startswith(prefix)}

    if "vehicle" in words:
        vehicle = Vehicle.from_toml(str(words["vehicle"]))
    if numbers := taken("vehicle."):
        vehicle = vehicle.replace(numbers)
    settled = merged(settings("solver", solver), taken("solver."), "solver.")
    touchdown = Scene() if scene is None else checked_scene(scene)
    return land(vehicle, touchdown.replace(given), settled or None, units=units)


def _value(name: str, cell: Any) -> float | str:
    """What a cell says: a number, or a word such as ``"1966"`` of ``solver.rules``."""
    if isinstance(cell, str) and name.startswith("solver."):
        return cell
    try:
        return float(cell)
    except ValueError:
        return str(cell)
