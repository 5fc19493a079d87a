"""Vehicles, touchdowns and settings that are dictionaries become documents of the engine."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

from touchdown import _engine

Document = Mapping[str, Any]


class NeverChanges:
    """What has a method `replace` and no attributes that can be set."""

    def __setattr__(self, name: str, value: object) -> None:
        if not name.startswith("_"):
            kind = type(self).__name__.lower()
            raise AttributeError(f"{name} cannot be set: a {kind} never changes; {kind}.replace(...) makes another one")
        super().__setattr__(name, value)


@cache
def _default_solver() -> _engine.Solver:
    return _engine.Solver("")


def solver_of(solver: Document | None) -> _engine.Solver:
    """The settings of a landing: those given, or the defaults."""
    if solver is None:
        return _default_solver()
    return _engine.Solver(_engine.toml({"solver": solver}))


def same_quantity(name: str) -> str:
    """A name that all spellings of a quantity have in common."""
    return _engine.program_name(name) or name


def merged(defaults: Document, given: Mapping[str, Any], prefix: str = "") -> dict[str, Any]:
    """Values given, and the defaults of quantities that are not."""
    said = {same_quantity(prefix + name) for name in given}
    kept = {name: value for name, value in defaults.items() if same_quantity(prefix + name) not in said}
    return kept | dict(given)
