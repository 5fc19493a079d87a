"""One landing."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any

import numpy as np
import pandas as pd

from touchdown import _engine
from touchdown._arguments import number, settings
from touchdown._documents import Document, solver_of
from touchdown._html import table
from touchdown._units import US, InBothUnits, Units, checked, in_units, told, unit_in, value_in
from touchdown._warnings import warn_of_landings
from touchdown.scene import Scene
from touchdown.scene import checked as checked_scene
from touchdown.vehicle import Vehicle, engine_of

#: What a notebook shows.
_SHOWN = [
    ("least stability angle", "min_stability_angle_deg"),
    ("least ground clearance", "min_clearance_ft"),
    ("tilt at the end", "tilt_deg"),
    ("footpad contact", "pad_contact_s"),
    ("block contact", "block_contact_s"),
    ("largest strut force", "max_strut_force_lb"),
    ("energy closure", "energy_closure_ftlb"),
]


@dataclass(frozen=True, repr=False)
class Landing(InBothUnits, tables=("landing", "report")):
    """How one landing went.

    Results of each leg are tuples, leg 1 first; None stands for what is empty in tables. Units are part of the names. Results
    are attributes in SI too, such as `min_clearance_m`, `max_strut_force_n` and `strut_work_j`.

    Attributes
    ----------
    outcome_class : str
        ``"stable"``, ``"unstable"``, ``"bottomed"``, ``"undecided"`` or ``"failure"``.
    why : str
        The outcome in words.
    verdict_time_s : float or None
        With ``stop = "time"``: when the outcome was decided, s.
    went_on_to : str or None
        With ``stop = "time"``: what ended the landing.
    vehicle : Vehicle
        What landed.
    scene : Scene
        How it touched down.
    solver : mapping
        Settings that were given, read only.
    units : {"US", "SI"}
        Units that it is told in, and that its tables have unless asked for others.
    """

    outcome: str
    outcome_class: str
    why: str
    end_time_s: float
    min_stability_angle_deg: float
    min_stability_time_s: float
    min_clearance_ft: float
    tilt_deg: float
    initial_kinetic_energy_ftlb: float
    potential_energy_change_ftlb: float
    thrust_work_ftlb: float
    final_kinetic_energy_ftlb: float
    energy_closure_ftlb: float
    given_by_contact_ftlb: float
    max_strut_force_lb: tuple[float, ...]
    max_stroke_ft: tuple[float, ...]
    max_stroke_share: tuple[float, ...]
    max_sinkage_ft: tuple[float, ...]
    pad_contact_s: tuple[float | None, ...]
    block_contact_s: tuple[float | None, ...]
    strut_work_ftlb: tuple[float, ...]
    pad_crush_work_ftlb: tuple[float, ...]
    pad_friction_work_ftlb: tuple[float, ...]
    block_crush_work_ftlb: tuple[float, ...]
    block_friction_work_ftlb: tuple[float, ...]
    stop_work_ftlb: tuple[float, ...]
    steps: int
    derivative_evaluations: int
    events: int
    failure: str | None
    verdict_time_s: float | None
    went_on_to: str | None
    vehicle: Vehicle
    scene: Scene
    _solver: Mapping[str, Any] = field(hash=False)
    units: Units = field(default=US, compare=False)

    @property
    def solver(self) -> Mapping[str, Any]:
        """Settings that were given, read only."""
        return MappingProxyType(self._solver)

    @property
    def is_stable(self) -> bool:
        """Whether the vehicle neither toppled nor bottomed, but came to rest."""
        return self.outcome_class == "stable"

    def history(self, dt: float = 0.01, units: Units | None = None) -> pd.DataFrame:
        """Motion, loads, deformations and energies over time, computed anew.

        Parameters
        ----------
        dt : float
            Time between rows, s.
        units : {"US", "SI"}, optional
            Units of the columns, which are part of their names; without, `units` of the landing.

        Returns
        -------
        DataFrame
            Indexed by ``t_s``, the time after first contact; columns as those of ``touchdown land --history``.
        """
        engine = solver_of(self._solver or None)
        seconds = number("dt", dt, "a number of seconds")
        columns = _engine.history(self.vehicle._engine, self.scene._engine, engine, seconds, self._units_or_own(units))
        arrays = {name: np.frombuffer(values) for name, values in columns}
        return pd.DataFrame(arrays, copy=False).set_index("t_s")

    def to_series(self, units: Units | None = None) -> pd.Series[Any]:
        """The results as a row of `land_many`, whose columns are those of ``touchdown land --cases`` and `outcome_class`.

        Parameters
        ----------
        units : {"US", "SI"}, optional
            Units of the values, which are part of their names; without, `units` of the landing.
        """
        row: dict[str, Any] = {}
        for name, column, _ in _engine.columns()["landing"]:
            value = getattr(self, name)
            if "#" in column:
                legs = {column.replace("#", str(leg)): of_leg for leg, of_leg in enumerate(value, 1)}
                row |= {name: np.nan if of_leg is None else of_leg for name, of_leg in legs.items()}
            else:
                row[name] = np.nan if value is None else value
            if name == "outcome":
                row["outcome_class"] = self.outcome_class
        return pd.Series(in_units(row, self._units_or_own(units)), dtype=object)

    def __repr__(self) -> str:
        numbers = [
            f"least stability angle {self.min_stability_angle_deg:.3f} deg at {self.min_stability_time_s:.3f} s",
            f"least clearance {told('min_clearance_ft', self.min_clearance_ft, self.units)}",
            f"largest strut force {told('max_strut_force_lb', max(self.max_strut_force_lb), self.units)}",
        ]
        return f"<Landing of {self.vehicle.name}: {self.outcome} at {self.end_time_s:.3f} s, {', '.join(numbers)}>"

    def _repr_html_(self) -> str:
        shown = [(f"{words}, {unit_in(self.units, name)}", value_in(self.units, name, getattr(self, name))) for words, name in _SHOWN]
        return table(self.vehicle.name, [("outcome", f"{self.outcome} at {self.end_time_s:.6f} s"), ("why", self.why), *shown])


def land(vehicle: Vehicle, scene: Scene, solver: Document | None = None, *, units: Units | None = None) -> Landing:
    """Compute one landing.

    Parameters
    ----------
    vehicle : Vehicle
        What lands.
    scene : Scene
        How it touches down.
    solver : mapping, optional
        How it is computed, with the keys of a table ``[solver]``, such as ``{"tolerance": 1e-8, "crush_rule": "section"}``.
        The tolerance is 1e-6 unless given.
    units : {"US", "SI"}, optional
        Units in which the landing is told and comes as a table; without, those of `use_units`.
        Landings compute and compare alike, and have the names of either as
        attributes.

    Returns
    -------
    Landing
        The same numbers, bit for bit, as ``touchdown land``.

    Raises
    ------
    InputError
        When a condition is missing, or not allowed for the vehicle or the method.

    Warns
    -----
    LandingWarning
        When footpads or blocks gave energy to the motion, or footpads were crushed beyond their hinges.

    Examples
    --------
    >>> import touchdown as td
    >>> scene = td.Scene(vertical_velocity_fps=14, horizontal_velocity_fps=11.25,
    ...                  cross_slope_deg=180, slope_deg=15, friction=1.0)
    >>> td.land(td.vehicles.surveyor(), scene).outcome
    'stable-rockback'
    """
    units = checked(units)
    results, warning = _engine.land(engine_of(vehicle), checked_scene(scene)._engine, solver_of(solver), units)
    warn_of_landings([warning] if warning else [])
    return Landing(**results, vehicle=vehicle, scene=scene, _solver=settings("solver", solver), units=units)
