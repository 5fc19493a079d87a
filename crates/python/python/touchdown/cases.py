"""Many landings."""

from __future__ import annotations

import os
from typing import Any

import pandas as pd

from touchdown import _engine
from touchdown._arguments import a_flag, a_path, thread_count
from touchdown._columns import columns_of, index_of, series
from touchdown._documents import Document, solver_of
from touchdown._units import checked
from touchdown._warnings import warn_of_journal, warn_of_landings
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
    table : DataFrame or mapping of arrays, lists or Series
        Columns as those of a table of cases (``touchdown land --cases``): keys of the scene, ``vehicle.…`` and ``solver.…``. A gap
        (None, ``pandas.NA``, a masked element, a null of polars) leaves a number to `scene`, the vehicle, `solver` or the default.
        NaN among numbers is refused. Tables of polars are taken as well.
    scene : Scene, optional
        Conditions of all rows that the table does not give.
    solver : mapping, optional
        How landings are computed, as in `land`, with the same tolerance, 1e-6, unless given.
    units : {"US", "SI"}, optional
        Units of the results, which are part of the names of the columns; without, those of `use_units`.
    out : path, optional
        CSV file for the results too. What is finished is in a journal beside it at once: after an interruption the same call goes on.
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
        `failure` are categorical.

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
    options = (checked(units), file, a_flag("overwrite", overwrite), thread_count(threads))
    with watching(progress, "landings") as watch:
        found, (of_journal, of_landings) = _engine.land_many(
            engine_of(vehicle), columns, conditions, solver_of(solver), *options, watch
        )
    warn_of_journal(of_journal)
    warn_of_landings(of_landings)
    results = {name: series(*column) for name, column in found}
    return pd.DataFrame(results, index=index, copy=False)
