"""Sweeps, maps, samples and sensitivities."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Literal, NamedTuple

import pandas as pd
import xarray as xr

from touchdown import _engine
from touchdown._arguments import a_dictionary, a_flag, a_path, an_instance, names, settings, text_of, thread_count
from touchdown._documents import Document, merged
from touchdown._units import Units, checked
from touchdown._warnings import warn_of_journal, warn_of_landings
from touchdown.boundaries import HORIZONTAL, SEARCH, axis_of_one_point
from touchdown.errors import InputError
from touchdown.progress import Watch, watching
from touchdown.reading import read
from touchdown.scene import Scene
from touchdown.scene import checked as checked_scene
from touchdown.vehicle import Vehicle, engine_of, written

Axes = Mapping[str, Any]
Job = Literal["boundary", "outcome"]
Design = Literal["monte-carlo", "latin-hypercube", "sobol"]


def sweep(
    vehicle: Vehicle,
    scene: Scene,
    axes: Axes,
    *,
    search: Document | None = None,
    solver: Document | None = None,
    sensitivity: Sequence[str] = (),
    job: Job = "boundary",
    out: str | os.PathLike[str] | None = None,
    name: str = "sweep",
    title: str | None = None,
    units: Units | None = None,
    parquet: bool = False,
    overwrite: bool = False,
    threads: int | None = None,
    progress: bool | Watch | None = None,
) -> xr.Dataset:
    """Search the transition velocity, or compute one landing, at every point of a grid.

    Parameters
    ----------
    vehicle : Vehicle
        What lands.
    scene : Scene
        Conditions that stay the same; those that are axes do not matter.
    axes : mapping
        What varies, the first slowest: values by the name of a parameter, in any of its units (``roll_deg``, ``vehicle.strut.preload_lb``,
        ``"vehicle.legs[2].strut.preload_n"``, ``solver.crush_rule``). Values are a list or array, or a dictionary such as
        ``{"from": -20, "to": 20, "step": 10}``; axes with the same ``zip`` move together.
    search : mapping, optional
        Where to search, with the keys of a table ``[search]``. Without, up to the first transition from 0 to 25 ft/s, in steps of
        0.25 ft/s narrowed down to 0.001 ft/s; ``{"bands": "all"}``
        searches the whole range for bands.
    solver : mapping, optional
        How landings are computed, with the keys of a table ``[solver]``.
    sensitivity : sequence of str
        Parameters whose effect on the transition velocity is computed at every point.
    job : {"boundary", "outcome"}
        Whether to search, or to compute a landing at every point.
    out : path, optional
        Folder for the files of the results, and for a journal while they are computed: after an interruption the same call goes on.
        Without, nothing is kept.
    name : str
        What files are named after.
    title : str, optional
        Title of the record; without, `name`.
    units : {"US", "SI"}, optional
        Units of the results; without, those of `use_units`.
    parquet : bool
        Whether to write tables as Parquet too.
    overwrite : bool
        Whether to replace results of other input, and files that are no results. Results of the same input are given back.
    threads : int, optional
        Threads; all cores without. Results do not depend on it.
    progress : bool or callable, optional
        Whether to show a bar; a callable is told the points done, the points wanted, and the landings so far.

    Returns
    -------
    Dataset
        Dimensions are the axes; variables are the columns of the results without their units, which are attributes. With
        ``bands = "all"`` there are variables ``band_…`` with the dimension ``band``, with sensitivities ``sensitivity_…`` with the
        dimension ``parameter``, of single landings some with the dimension ``leg``. The attribute ``input`` is the whole input with
        defaults filled in, as JSON.

    Examples
    --------
    >>> import touchdown as td
    >>> scene = td.Scene(vertical_velocity_fps=14, cross_slope_deg=180, slope_deg=15, friction=1.0)
    >>> ds = td.sweep(td.vehicles.surveyor(), scene, axes={"roll_deg": [0, 10]}, search={"from_fps": 8, "to_fps": 16})
    >>> ds.first_transition.round(3).values.tolist(), ds.first_transition.units
    ([11.4, 11.274], 'ft/s')
    """
    asked: dict[str, Any] = {"job": job, "solver": solver, "search": _search(search, job)}
    if parameters := names("sensitivity", sensitivity):
        asked["sensitivity"] = {"parameters": parameters}
    options = _Options(out, name, title, units, parquet, overwrite, threads, progress)
    return _computed(vehicle, scene, axes, asked, options)


def map(  # noqa: A001
    vehicle: Vehicle,
    scene: Scene,
    axes: Axes,
    edge_width: Mapping[str, float],
    *,
    error_fps: float | None = None,
    error_mps: float | None = None,
    budget_landings: int | None = None,
    jump_fps: float | None = None,
    jump_mps: float | None = None,
    grid_steps: int | None = None,
    search: Document | None = None,
    solver: Document | None = None,
    out: str | os.PathLike[str] | None = None,
    name: str = "sweep",
    title: str | None = None,
    units: Units | None = None,
    parquet: bool = False,
    overwrite: bool = False,
    threads: int | None = None,
    progress: bool | Watch | None = None,
) -> xr.Dataset:
    """Map the transition velocity over one axis or two; the program refines where it curves, jumps or ends.

    Parameters
    ----------
    vehicle : Vehicle
        What lands.
    scene : Scene
        Conditions that stay the same.
    axes : mapping
        The first level of the map, as in `sweep`.
    edge_width : mapping of str to float
        The one or two axes that are refined: edges are located between points no farther apart, in the unit of the axis.
    error_fps, error_mps : float, optional
        Cells are refined while the error of interpolation at their centres is greater, ft/s or m/s.
    budget_landings : int, optional
        The refinement ends when about so many landings are spent. Give this, an error or both.
    jump_fps, jump_mps : float, optional
        Least difference over `edge_width` that counts as an edge, ft/s or m/s.
    grid_steps : int, optional
        Steps of the regular grid along each side of a first-level cell; default 8. Not over one axis.
    search, solver : mapping, optional
        As in `sweep`.
    out, name, title, units, parquet, overwrite, threads, progress
        As in `sweep`.

    Returns
    -------
    Dataset
        ``first_transition`` and ``estimated_error`` over the axes, on a regular grid; the points themselves as ``point_…``, edges as lines
        ``edge_…``, and triangles ``corner_…``. Over one axis: what `sweep` returns, at the points themselves, and the edges.
    """
    rules = {
        "edge_width": a_dictionary("edge_width", edge_width),
        "error_fps": error_fps,
        "error_mps": error_mps,
        "budget_landings": budget_landings,
        "jump_fps": jump_fps,
        "jump_mps": jump_mps,
        "grid_steps": grid_steps,
    }
    given = {name: value for name, value in rules.items() if value is not None}
    asked = {"map": given, "solver": solver, "search": _search(search, "boundary")}
    options = _Options(out, name, title, units, parquet, overwrite, threads, progress)
    return _computed(vehicle, scene, axes, asked, options)


def sample(
    vehicle: Vehicle,
    scene: Scene,
    axes: Axes,
    count: int,
    seed: int,
    *,
    design: Design = "monte-carlo",
    job: Job = "outcome",
    covariance: Sequence[Document] = (),
    stop_at_interval_width: float | None = None,
    search: Document | None = None,
    solver: Document | None = None,
    out: str | os.PathLike[str] | None = None,
    name: str = "sweep",
    title: str | None = None,
    units: Units | None = None,
    parquet: bool = False,
    overwrite: bool = False,
    threads: int | None = None,
    progress: bool | Watch | None = None,
) -> xr.Dataset:
    """Draw touchdowns at random: probabilities of single landings, or the distribution of the transition velocity.

    Parameters
    ----------
    vehicle : Vehicle
        What lands.
    scene : Scene
        Conditions that stay the same.
    axes : mapping
        A distribution for each parameter, such as ``{"mean": 14, "sd": 0.5}``, ``{"from": 0, "to": 20}``, or ``{"file": "measured.csv",
        "column": "friction"}``.
    count : int
        Number of points. A finished sample in `out` with fewer of them, and otherwise the same, is taken over, but for Latin hypercubes.
    seed : int
        The same seed gives the same points on every machine.
    design : {"monte-carlo", "latin-hypercube", "sobol"}
        How points are spread.
    job : {"outcome", "boundary"}
        Whether to compute a landing or search the transition velocity at every point.
    covariance : sequence of mappings
        Axes that are jointly normal: ``{"axes": [...], "matrix": [[...], ...]}``.
    stop_at_interval_width : float, optional
        Of landings: stop when the 95 % intervals of the probabilities are no wider.
    search, solver : mapping, optional
        As in `sweep`.
    out, name, title, units, parquet, overwrite, threads, progress
        As in `sweep`.

    Returns
    -------
    Dataset
        With the dimension ``point``. Of landings also probabilities, all and in bins of every axis, as ``bin_…``; of transitions
        quantiles ``quantile_…`` and the distribution ``interval_…``.
    """
    rules: dict[str, Any] = {"design": design, "count": count, "seed": seed}
    if stop_at_interval_width is not None:
        rules["stop_at_interval_width"] = stop_at_interval_width
    allowed = "a list of dictionaries"
    if blocks := list(an_instance("covariance", covariance, Sequence, allowed)):
        rules["covariance"] = [an_instance("covariance", block, Mapping, allowed) for block in blocks]
    asked = {"job": job, "sample": rules, "solver": solver, "search": _search(search, job)}
    options = _Options(out, name, title, units, parquet, overwrite, threads, progress)
    return _computed(vehicle, scene, axes, asked, options)


def sensitivity(
    vehicle: Vehicle,
    scene: Scene,
    parameters: Sequence[str],
    *,
    search: Document | None = None,
    solver: Document | None = None,
    out: str | os.PathLike[str] | None = None,
    name: str = "sweep",
    title: str | None = None,
    units: Units | None = None,
    parquet: bool = False,
    overwrite: bool = False,
    threads: int | None = None,
    progress: bool | Watch | None = None,
) -> pd.DataFrame:
    """How the transition velocity at one touchdown changes with parameters of scene and vehicle.

    Parameters
    ----------
    vehicle : Vehicle
        What lands.
    scene : Scene
        How it touches down.
    parameters : sequence of str
        Dotted names, as those of axes.
    search, solver : mapping, optional
        As in `sweep`.
    out, name, title, units, parquet, overwrite, threads, progress
        As in `sweep`.

    Returns
    -------
    DataFrame
        Indexed by the parameters; columns as those of a table of sensitivities: the derivative ``dvh_dp_fps_per_unit`` with its error,
        and ``vh_change_fps``, the change for 10 % of the parameter, or 1 deg of an angle. Where V_H jumps,
        ``vh_at_minus_span_fps`` and ``vh_at_plus_span_fps`` tell it at both ends of that change.
    """
    axes = axis_of_one_point(scene)
    known = names("parameters", parameters)
    if not known:
        raise InputError.of_value("parameters", parameters, "at least one name of a parameter")
    asked = {"job": "boundary", "solver": solver, "search": _search(search, "boundary"), "sensitivity": {"parameters": known}}
    options = _Options(out, name, title, units, parquet, overwrite, threads, progress)
    found = _computed(vehicle, scene, axes, asked, options)
    of_parameters = [name for name in found.data_vars if str(name).startswith("sensitivity_")]
    table = found[of_parameters].squeeze(list(axes), drop=True).to_dataframe()
    return table.rename(columns={name: found[name].attrs["column"] for name in of_parameters})


def run(
    path: str | os.PathLike[str],
    out: str | os.PathLike[str] = "results",
    *,
    vehicle: Vehicle | None = None,
    set: Mapping[str, float | str] | None = None,  # noqa: A002
    units: Units | None = None,
    parquet: bool = False,
    overwrite: bool = False,
    threads: int | None = None,
    progress: bool | Watch | None = None,
) -> xr.Dataset:
    """Run a sweep file into a folder, as ``touchdown sweep`` does but for pictures: `touchdown.plot` draws them.

    What is finished is in a journal in the folder at once. After an interruption the same call goes on, and so does the command line.

    Parameters
    ----------
    path : path
        The sweep file.
    out : path
        Folder for the results.
    vehicle : Vehicle, optional
        In place of the one that the file names.
    set : mapping, optional
        Values by dotted names in place of those of the files.
    units : {"US", "SI"}, optional
        Units of the results; without, those of the file.
    parquet : bool
        Whether to write tables as Parquet too.
    overwrite : bool
        Whether to replace results of other input, and files that are no results. Results of the same input are given back.
    threads, progress
        As in `land_many`.

    Returns
    -------
    Dataset
        As `sweep`.
    """
    given = written(settings("set", set).items())
    other = None if vehicle is None else engine_of(vehicle)
    engine = _engine.Sweep.from_file(a_path("path", path), other, given, None if units is None else checked(units))
    folder = Path(a_path("out", out))
    _run(engine, folder, parquet, overwrite, threads, progress)
    return _results(folder, engine)


class _Options(NamedTuple):
    """Options of calls that compute many points, as `sweep` describes them."""

    out: str | os.PathLike[str] | None
    name: str
    title: str | None
    units: Units | None
    parquet: bool
    overwrite: bool
    threads: int | None
    progress: bool | Watch | None


def _computed(vehicle: Vehicle, scene: Scene, axes: Axes, asked: Mapping[str, Any], options: _Options) -> xr.Dataset:
    """The results of a sweep that asks for these tables."""
    name, allowed = options.name, "a name without a folder"
    if not an_instance("name", name, str, allowed) or Path(name).name != name:
        raise InputError.of_value("name", name, allowed)
    allowed = "a dictionary with the values of at least one parameter"
    if not (axes := a_dictionary("axes", axes, allowed)):
        raise InputError.of_value("axes", axes, allowed)
    searched = {HORIZONTAL} if asked.get("job", "boundary") == "boundary" else set()
    document = {
        "title": options.title or name,
        "vehicle": "vehicle.toml",
        "units": checked(options.units),
        "scene": checked_scene(scene).without({*axes, *searched}),
        "axes": axes,
    }
    document |= {key: value for key, value in asked.items() if value is not None}
    engine = _engine.Sweep(name, _engine.toml(document), engine_of(vehicle), _files(axes))
    with _folder(options.out) as folder:
        _run(engine, folder, options.parquet, options.overwrite, options.threads, options.progress)
        return _results(folder, engine)


def _run(
    engine: _engine.Sweep,
    folder: Path,
    parquet: bool,
    overwrite: bool,
    threads: int | None,
    progress: bool | Watch | None,
) -> None:
    with watching(progress, "points") as watch:
        flags = a_flag("parquet", parquet), a_flag("overwrite", overwrite)
        of_journal, of_landings = engine.run(folder, *flags, thread_count(threads), watch)
    warn_of_journal(of_journal)
    warn_of_landings(of_landings)


def _results(folder: Path, engine: _engine.Sweep) -> xr.Dataset:
    found = read(folder / f"{engine.name}.csv")
    assert isinstance(found, xr.Dataset)
    return found


def _search(search: Document | None, job: str) -> dict[str, Any] | None:
    if job == "boundary":
        return merged(SEARCH, settings("search", search), "search.")
    return None if search is None else a_dictionary("search", search)


def _files(axes: Axes) -> dict[str, str]:
    """The texts of tables from which axes take their values."""
    tables = {name: axis for name, axis in axes.items() if isinstance(axis, Mapping) and "file" in axis}
    files = {a_path(f"axes.{name}.file", axis["file"]) for name, axis in tables.items()}
    return {file: text_of(file) for file in files}


@contextmanager
def _folder(out: str | os.PathLike[str] | None) -> Iterator[Path]:
    if out is not None:
        yield Path(a_path("out", out))
        return
    with TemporaryDirectory(prefix="touchdown-") as folder:
        yield Path(folder)
