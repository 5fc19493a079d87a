"""The transition velocity at one touchdown."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import pandas as pd

from touchdown import _engine
from touchdown._arguments import settings, thread_count
from touchdown._documents import Document, merged, same_quantity
from touchdown._html import bands_picture
from touchdown._units import US, InBothUnits, Units, checked, in_units, told, unit_in, value_in
from touchdown._warnings import warn_of_landings
from touchdown.progress import Watch, watching
from touchdown.errors import InputError
from touchdown.scene import Scene
from touchdown.scene import checked as checked_scene
from touchdown.vehicle import Vehicle, engine_of

# As the sweeps of the figures of 1966, but to the next band and beyond.
SEARCH: Document = {"from_fps": 0, "to_fps": 25, "scan_step_fps": 0.25, "tolerance_fps": 0.001}
HORIZONTAL = "horizontal_velocity_fps"
# A sweep has an axis.
_AXIS = "cross_slope_deg"


@dataclass(frozen=True, repr=False)
class Band(InBothUnits, tables=("band",)):
    """A range of horizontal velocities whose landings end alike.

    None stands for what is empty in tables. Velocities are attributes in SI too, such as `to_mps`.

    Attributes
    ----------
    units : {"US", "SI"}
        Units that it is told in.
    """

    from_fps: float
    to_fps: float
    outcome: str
    kind: str
    bracket_width_fps: float | None
    certainty: str | None
    disputed_from_fps: float | None
    disputed_to_fps: float | None
    solver_tolerance: float | None
    units: Units = field(default=US, compare=False)

    def __repr__(self) -> str:
        start, end = (told(name, speed, self.units) for name, speed in [("from_fps", self.from_fps), ("to_fps", self.to_fps)])
        return f"<Band from {start} to {end}: {self.kind}>"


@dataclass(frozen=True, repr=False)
class Boundary(InBothUnits, tables=("boundary",)):
    """Where landings cease to be stable as the horizontal velocity grows.

    None stands for what is empty in tables. Velocities are attributes in SI too, such as `first_transition_mps`.

    Attributes
    ----------
    bands : tuple of Band
        All bands of the range, from below; empty with ``bands = "first"``.
    vehicle : Vehicle
        What lands.
    scene : Scene
        How it touches down.
    units : {"US", "SI"}
        Units that it is told in, and that its tables have unless asked for others.
    """

    first_transition_fps: float | None
    first_transition_to: str
    bracket_low_fps: float | None
    bracket_high_fps: float | None
    certainty: str | None
    disputed_from_fps: float | None
    disputed_to_fps: float | None
    solver_tolerance: float | None
    stable_landings_below: int
    patchy_to_fps: float | None
    patchy_landings: int
    patchy_not_stable: int
    bands: tuple[Band, ...]
    landings: int
    derivative_evaluations: int
    vehicle: Vehicle
    scene: Scene
    units: Units = field(default=US, compare=False)

    def to_series(self, units: Units | None = None) -> pd.Series[Any]:
        """What is found, without the bands, by name.

        Parameters
        ----------
        units : {"US", "SI"}, optional
            Units of the values, which are part of their names; without, `units` of the boundary.
        """
        left_out = {"bands", "vehicle", "scene", "units"}
        found = {name: getattr(self, name) for name in type(self).__dataclass_fields__ if name not in left_out}
        return pd.Series(in_units(found, self._units_or_own(units)), dtype=object)

    def to_frame(self, units: Units | None = None) -> pd.DataFrame:
        """The bands as a table, indexed by their numbers from 1.

        Parameters
        ----------
        units : {"US", "SI"}, optional
            Units of the columns, which are part of their names; without, `units` of the boundary.
        """
        told_in = self._units_or_own(units)
        names = dict.fromkeys(name for name in Band.__dataclass_fields__ if name != "units")
        rows = [in_units({name: getattr(band, name) for name in names}, told_in) for band in self.bands]
        frame = pd.DataFrame(rows, columns=list(in_units(names, told_in)))
        frame.index = pd.RangeIndex(1, len(frame) + 1, name="band")
        return frame

    def __repr__(self) -> str:
        if self.first_transition_fps is None:
            found = "no transition"
        else:
            speed = told("first_transition_fps", self.first_transition_fps, self.units)
            found = f"V_H {speed} to {self.first_transition_to}, {self.certainty or 'untested'}"
            if self.certainty == "at-or-below":
                found = f"V_H at or below {speed}, already {self.first_transition_to}"
            if self.patchy_to_fps is not None:
                found += f", patchy up to {told('patchy_to_fps', self.patchy_to_fps, self.units)}"
        bands = {0: "", 1: ", 1 band"}.get(len(self.bands), f", {len(self.bands)} bands")
        return f"<Boundary of {self.vehicle.name}: {found}{bands}>"

    def _repr_html_(self) -> str:
        ends = [value_in(self.units, HORIZONTAL, (band.from_fps, band.to_fps)) for band in self.bands]
        bands = [(*end, band.outcome, band.kind) for end, band in zip(ends, self.bands, strict=True)]
        return bands_picture(bands, unit_in(self.units, HORIZONTAL))


def boundary(
    vehicle: Vehicle,
    scene: Scene,
    *,
    search: Document | None = None,
    solver: Document | None = None,
    units: Units | None = None,
    threads: int | None = None,
    progress: bool | Watch | None = None,
) -> Boundary:
    """Find the horizontal velocities at which landings cease, and begin again, to be stable.

    Parameters
    ----------
    vehicle : Vehicle
        What lands.
    scene : Scene
        How it touches down; its horizontal velocity does not matter.
    search : mapping, optional
        Where to search, with the keys of a table ``[search]``. Without, all bands from 0 to 25 ft/s, in steps of 0.25 ft/s narrowed down
        to 0.001 ft/s.
    solver : mapping, optional
        How landings are computed, with the keys of a table ``[solver]``; the tolerance is that of sweeps, 3e-5, unless given.
    units : {"US", "SI"}, optional
        Units in which the boundary and its bands are told and come as tables; without, those of `use_units`.
        They compute and compare alike, and both have the
        names of either as attributes.
    threads : int, optional
        Threads; all cores without. Results do not depend on it.
    progress : bool or callable, optional
        As in `land_many`.

    Returns
    -------
    Boundary

    Warns
    -----
    LandingWarning
        Of landings that are less than they seem.

    Examples
    --------
    >>> import touchdown as td
    >>> scene = td.Scene(vertical_velocity_fps=14, cross_slope_deg=180, slope_deg=15, friction=1.0)
    >>> found = td.boundary(td.vehicles.surveyor(), scene, search={"from_fps": 8, "to_fps": 16})
    >>> print(f"{found.first_transition_fps:.3f} ft/s, {found.certainty}")
    11.400 ft/s, certain
    """
    units = checked(units)
    engine = _engine.Sweep("boundary", _engine.toml(_point(scene, search, solver) | {"units": units}), engine_of(vehicle), {})
    with watching(progress, "points") as watch:
        found, warnings = _engine.boundary(engine, thread_count(threads), watch)
    warn_of_landings(warnings)
    bands = tuple(Band(**band, units=units) for band in found.pop("bands"))
    return Boundary(**found, bands=bands, vehicle=vehicle, scene=scene, units=units)


def _point(scene: Scene, search: Document | None, solver: Document | None) -> dict[str, Any]:
    """A sweep over a single point."""
    conditions = checked_scene(scene).without({HORIZONTAL})
    axes = axis_of_one_point(scene)
    for name in axes:
        del conditions[name]
    return {
        "title": "boundary",
        "vehicle": "vehicle.toml",
        "scene": conditions,
        "axes": axes,
        "search": merged({**SEARCH, "bands": "all"}, settings("search", search), "search."),
        "solver": settings("solver", solver),
    }


def axis_of_one_point(scene: Scene) -> dict[str, Any]:
    """The axis of a sweep over this touchdown alone."""
    axis = {name: [value] for name, value in checked_scene(scene).to_dict().items() if same_quantity(name) == _AXIS}
    if not axis:
        allowed = "the direction of travel, in the scene"
        raise InputError(f"{_AXIS} is missing: expected {allowed}", _AXIS, None, allowed)
    return axis
