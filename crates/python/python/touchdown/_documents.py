"""Vehicles, touchdowns and settings that are dictionaries become documents of the engine."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

from touchdown import _engine
from touchdown._arguments import an_instance

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


def put(table: dict[str, Any], name: str, value: Any) -> None:
    """Write a value under a dotted name, such as ``legs[2].strut.kind``, in place of what is there in any unit."""
    step, _, rest = name.partition(".")
    key, _, number = step.partition("[")
    if not rest:
        bare = _engine.bare_name_and_unit(key)[0]
        for other in [other for other in table if _engine.bare_name_and_unit(other)[0] == bare]:
            del table[other]
        table[key] = value
        return
    below = table.setdefault(key, [] if number else {})
    if number and isinstance(below, list) and (entry := number.removesuffix("]")).isdecimal():
        below.extend({} for _ in range(len(below), int(entry)))
        below = below[int(entry) - 1]
    an_instance(step, below, dict, "a table")
    put(below, rest, value)
