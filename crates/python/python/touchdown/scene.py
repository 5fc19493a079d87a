"""Touchdowns."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping
from copy import deepcopy
from functools import cached_property
from typing import Any

from touchdown import _engine
from touchdown._arguments import an_instance, settings
from touchdown._documents import NeverChanges, merged, put, same_quantity
from touchdown._html import table

# Giving one form of the attitude replaces the other.
_EULER = {"pitch_deg", "yaw_deg", "roll_deg"}
_TIP = {"tip_deg", "tip_azimuth_deg", "nominal_roll_deg"}


class Scene(NeverChanges):
    """Conditions of a touchdown at first contact.

    A scene never changes; `replace` makes another one. Conditions may be left out as long as nothing needs them: a boundary needs no
    horizontal velocity, a sweep none of the conditions that are its axes. Two scenes are equal when all their numbers are, in
    whatever units they were given.

    Parameters
    ----------
    **conditions
        The keys of a table ``[scene]``; the attitude in one of its two forms:

        {conditions}
        - ``gravity``: "moon", "mars", "earth" or "ceres" in place of ``gravity_fps2``
        - ``thrust``: dictionary with ``time_s`` and ``force_lb``, and optional ``scale``, ``offset_x_ft``, ``offset_y_ft``
        - ``footing``: a dictionary for each leg, with ``height_ft``, ``tilt_along_deg``, ``tilt_across_deg``, ``block_…``,
          ``bearing_factor``

        Each may be in SI under its other name, such as ``vertical_velocity_mps``.

    Raises
    ------
    InputError
        Names the first condition that is unknown or not allowed.

    Examples
    --------
    >>> import touchdown as td
    >>> scene = td.Scene(vertical_velocity_fps=14, cross_slope_deg=180, slope_deg=15, friction=1.0)
    >>> scene.slope_deg
    15
    >>> scene.replace(slope_deg=10).slope_deg
    10
    """

    def __init__(self, **conditions: Any) -> None:
        self._set(_engine.toml(conditions))

    def _set(self, text: str) -> None:
        self._engine = _engine.Scene(text)
        self._text = text

    @cached_property
    def _given(self) -> dict[str, Any]:
        return tomllib.loads(self._text)

    def to_dict(self) -> dict[str, Any]:
        """The conditions as a dictionary, under the keys and in the units that they were given in."""
        return deepcopy(self._given)

    def replace(self, conditions: Mapping[str, Any] | None = None, /, **named: Any) -> Scene:
        """The same scene with other conditions.

        Parameters
        ----------
        conditions : mapping, optional
            Values by their keys, in any of their units, also dotted: ``thrust.scale``, ``footing[1].height_m``. One key of the other
            form of the attitude replaces the whole attitude.
        **named
            The same as keywords.
        """
        new = settings("conditions", conditions) | named
        names = {same_quantity(name) for name in new}
        replaced = (_TIP if names & _EULER else set()) | (_EULER if names & _TIP else set())
        if "gravity" in new or "gravity_fps2" in names:
            replaced |= {"gravity", "gravity_fps2"}
        kept = {name: value for name, value in self.to_dict().items() if same_quantity(name) not in replaced}
        changed = merged(kept, {name: value for name, value in new.items() if "." not in name})
        for name, value in new.items():
            if "." in name:
                put(changed, name, value)
        return Scene(**changed)

    def without(self, names: set[str]) -> dict[str, Any]:
        """The conditions without some, those of thrust, soil and footing included, whatever units either are in."""
        left_out = {same_quantity(name) for name in names}

        def kept(values: Mapping[str, Any], prefix: str = "") -> dict[str, Any]:
            return {name: value for name, value in values.items() if same_quantity(prefix + name) not in left_out}

        conditions = kept(self._given)
        for name in ("thrust", "soil"):
            if isinstance(conditions.get(name), Mapping):
                conditions[name] = kept(conditions[name], f"{name}.")
        if "footing" in conditions:
            conditions["footing"] = [kept(one, f"footing[{leg}].") for leg, one in enumerate(conditions["footing"], 1)]
        return conditions

    def __getattr__(self, name: str) -> Any:
        if not name.startswith("_") and name in self._given:
            return deepcopy(self._given[name])
        raise AttributeError(f"the scene has no {name}: it has {', '.join(self._given)}" if not name.startswith("_") else name)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._given]

    @cached_property
    def _numbers(self) -> str:
        return json.dumps(self._engine.resolved())

    def __eq__(self, other: object) -> bool:
        return self._numbers == other._numbers if isinstance(other, Scene) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._numbers)

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self._text,)

    def __repr__(self) -> str:
        return f"Scene({', '.join(f'{name}={value!r}' for name, value in self._given.items())})"

    def _repr_html_(self) -> str:
        return table("Scene", self._given.items())


Scene.__doc__ = (Scene.__doc__ or "").replace(
    "{conditions}", "\n        ".join(f"- ``{key}``: {about}" for key, about in _engine.conditions())
)


def checked(scene: Any) -> Scene:
    """This scene, if it is one."""
    known: Scene = an_instance("scene", scene, Scene, "a Scene")
    return known


def _restored(text: str) -> Scene:
    scene = Scene.__new__(Scene)
    scene._set(text)
    return scene
