"""Vehicles to start from."""

from __future__ import annotations

from functools import cache

from touchdown import _engine
from touchdown.vehicle import Vehicle

__all__ = ["apollo_like", "four_legs", "six_legs", "surveyor", "surveyor_si"]


@cache
def _own(name: str) -> Vehicle:
    return Vehicle(_engine.own_vehicle(name))


def surveyor() -> Vehicle:
    """The Surveyor of Table 4-1 of the report of 1966, in feet and pounds."""
    return _own("surveyor-table-4-1")


def surveyor_si() -> Vehicle:
    """The Surveyor in SI units."""
    return _own("surveyor-si")


def four_legs() -> Vehicle:
    """A lander with four legs on honeycomb struts, in SI units."""
    return _own("four-legs")


def six_legs() -> Vehicle:
    """A lander with six legs on honeycomb struts, in SI units."""
    return _own("six-legs")


def apollo_like() -> Vehicle:
    """A lander of the size of the Apollo lunar module, on four cantilever legs of three struts. Many of its numbers are assumed."""
    return _own("apollo-like")
