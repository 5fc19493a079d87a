"""Results in the units of the program and in SI; the engine knows the units of a name, here is no table of them."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Mapping
from dataclasses import Field
from functools import cache
from inspect import cleandoc
from typing import Any, ClassVar, Literal

from touchdown import _engine
from touchdown._arguments import an_instance

Units = Literal["US", "SI"]
#: Feet, pounds and seconds.
US: Units = "US"
_chosen: Units = US


def name_in(units: str, name: str) -> str:
    """The name that a result has in these units."""
    return _engine.in_units(name, 0.0, units)[0]


def value_in(units: str, name: str, value: Any) -> Any:
    """A result, or those of all legs, in these units; what is no number of its own stays as it is."""
    match value:
        case float():
            return _engine.in_units(name, value, units)[1]
        case tuple():
            return tuple(value_in(units, name, one) for one in value)
        case _:
            return value


def in_units(values: Mapping[str, Any], units: str) -> dict[str, Any]:
    """Results by name, in these units."""
    return {name_in(units, name): value_in(units, name, value) for name, value in values.items()}


def unit_in(units: str, name: str) -> str:
    """The unit that a result has there, in words."""
    return _engine.bare_name_and_unit(name_in(units, name))[1]


def use_units(units: Units) -> None:
    """Choose the units of results of all calls that name none.

    Parameters
    ----------
    units : {"US", "SI"}
        Feet and pounds, as without a choice, or SI. Results of sweep files keep the units of the file.

    Examples
    --------
    >>> import touchdown as td
    >>> td.use_units("SI")
    >>> scene = td.Scene(vertical_velocity_fps=14, horizontal_velocity_fps=11, cross_slope_deg=180, slope_deg=15, friction=1.0)
    >>> td.land(td.vehicles.surveyor(), scene).units
    'SI'
    >>> td.use_units("US")
    """
    global _chosen
    _chosen = _known(units)


def checked(units: Units | None) -> Units:
    """These units, if there are such; without, those of `use_units`."""
    return _chosen if units is None else _known(units)


def _known(units: Units) -> Units:
    an_instance("units", units, str, '"US" or "SI"')
    name_in(units, "")
    return units


def told(name: str, value: float, units: str) -> str:
    """A result with its unit, in these units."""
    return f"{value_in(units, name, value):.3f} {unit_in(units, name)}"


@cache
def _names_by_si(names: tuple[str, ...]) -> dict[str, str]:
    """Those of these names that are others in SI, by how they are called there."""
    in_si = {name_in("SI", name): name for name in names}
    return {si: name for si, name in in_si.items() if si != name}


def _sentence(about: str) -> str:
    """What the catalogue says of a column, without links of documents."""
    text = re.sub(r"\[([^]]+)\]\(#[^)]*\)", r"\1", about)
    text = re.sub(r"\[([^]]+)\]\(([^)]+)\)", r"\1 (docs/\2)", text)
    indent = " " * 4
    return textwrap.fill(f"{text[0].upper()}{text[1:]}.", 120, initial_indent=indent, subsequent_indent=indent, break_on_hyphens=False)


class InBothUnits:
    """What makes the fields of a dataclass attributes in SI too, under the names that results have there.

    Those that are columns of `tables` end the list of attributes in its docstring, in the words of the catalogue.
    """

    __slots__ = ()
    __dataclass_fields__: ClassVar[dict[str, Field[Any]]]

    units: Units

    def __init_subclass__(cls, tables: tuple[str, ...]) -> None:
        columns = _engine.columns()
        about = {name: said for table in tables for name, _, said in columns[table]}
        told = [f"{name} : {kind}\n{_sentence(about[name])}" for name, kind in cls.__annotations__.items() if name in about]
        cls.__doc__ = "\n".join([cleandoc(cls.__doc__ or ""), *told])

    def _units_or_own(self, units: Units | None) -> Units:
        return self.units if units is None else checked(units)

    def __getattr__(self, name: str) -> Any:
        known = _names_by_si(tuple(self.__dataclass_fields__)).get(name)
        if known is None:
            raise AttributeError(f"the {type(self).__name__.lower()} has no {name}")
        return value_in("SI", known, getattr(self, known))

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *_names_by_si(tuple(self.__dataclass_fields__))]
