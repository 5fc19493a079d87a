"""Vehicles."""

from __future__ import annotations

import json
import os
import tomllib
from collections.abc import Iterable, Mapping
from functools import cached_property
from typing import Any

from touchdown import _engine
from touchdown._arguments import a_dictionary, a_path, an_instance, number, text_of
from touchdown._documents import NeverChanges, put, same_quantity
from touchdown._html import table
from touchdown.errors import InputError


class Vehicle(NeverChanges):
    """A lander: mass properties and three to eight legs.

    A vehicle never changes; `replace` makes another one. Two vehicles are equal when all their numbers are, in whatever units
    they were given.

    Parameters
    ----------
    text : str
        The text of a vehicle file.

    See Also
    --------
    Vehicle.from_toml, Vehicle.from_dict, touchdown.vehicles
    """

    def __init__(self, text: str) -> None:
        allowed = "the text of a vehicle file; Vehicle.from_toml(path) reads the file itself"
        if an_instance("text", text, str, allowed) and "=" not in text:
            raise InputError.of_value("text", text, allowed)
        self._set(text, "")

    def _set(self, text: str, path: str) -> None:
        self._engine = _engine.Vehicle(text, path)
        self._text = text
        self._path = path

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Vehicle:
        """Read a vehicle file.

        Parameters
        ----------
        path : path
            The file. Complaints name it, with the line.

        Raises
        ------
        InputError
            Names file, line, key and value of the first thing wrong, and what is allowed.
        OSError
            When the file cannot be read.
        """
        vehicle = cls.__new__(cls)
        name = a_path("path", path)
        vehicle._set(text_of(name), name)
        return vehicle

    @classmethod
    def from_dict(cls, numbers: Mapping[str, Any]) -> Vehicle:
        """Make a vehicle of a dictionary with the keys of a vehicle file.

        Parameters
        ----------
        numbers : mapping
            Tables are dictionaries, `legs` is a list of them. Every number may be in SI under its other name, such as
            ``mass_kg``.
        """
        return cls(_engine.toml(an_instance("numbers", numbers, Mapping, "a dictionary with the keys of a vehicle file")))

    def to_dict(self) -> dict[str, Any]:
        """The vehicle as a dictionary, under the keys and in the units that it was given in."""
        return tomllib.loads(self._text)

    def to_toml(self) -> str:
        """The text of a vehicle file, comments included where there were any."""
        return self._text

    def replace(self, numbers: Mapping[str, Any]) -> Vehicle:
        """The same vehicle with other numbers, lists and words.

        Parameters
        ----------
        numbers : mapping
            Values by dotted names, as axes of sweeps have them, with or without ``vehicle.`` before them: ``strut.preload_lb`` of all
            legs, ``legs[2].strut.preload_n`` of one, ``footpad.profile.scale`` of a whole table. Or any other key of a vehicle file:
            ``name``, ``rules``, ``footpad.profile.relative_pressure``, a whole ``block``.

        Examples
        --------
        >>> import touchdown as td
        >>> softer = td.vehicles.surveyor().replace({"strut.preload_lb": 150})
        >>> softer.to_dict()["strut"]["preload_lb"]
        150
        """
        given = a_dictionary("numbers", numbers)
        parameters, document = [], self.to_dict()
        for key, value in given.items():
            name = key.removeprefix("vehicle.")
            if _engine.program_name(f"vehicle.{name}"):
                parameters.append((f"vehicle.{name}", value))
            else:
                put(document, name, value)
        text = self._text if len(parameters) == len(given) else _engine.toml(document)
        return type(self)(_engine.replaced(text, written(parameters)))

    @property
    def name(self) -> str:
        """Its name in reports."""
        return self._engine.name

    @property
    def legs(self) -> int:
        """Number of its legs."""
        return self._engine.legs

    @cached_property
    def _numbers(self) -> dict[str, Any]:
        numbers: dict[str, Any] = json.loads(self._engine.resolved())
        return numbers

    def __eq__(self, other: object) -> bool:
        return self._numbers == other._numbers if isinstance(other, Vehicle) else NotImplemented

    def __hash__(self) -> int:
        return hash(json.dumps(self._numbers, sort_keys=True))

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self._text, self._path)

    def __repr__(self) -> str:
        return f"<Vehicle {self.name!r}: {self.legs} legs, {self._numbers['mass_slug']:g} slug>"

    def _repr_html_(self) -> str:
        numbers = self._numbers
        rows = ((key, value) for key, value in numbers.items() if isinstance(value, float))
        return table(self.name, [("legs", self.legs), *rows])


def _restored(text: str, path: str) -> Vehicle:
    vehicle = Vehicle.__new__(Vehicle)
    vehicle._set(text, path)
    return vehicle


def written(values: Iterable[tuple[str, Any]]) -> list[tuple[str, str]]:
    """Numbers and words by name, as the engine reads them."""
    told: dict[str, tuple[str, str]] = {}
    for name, value in values:
        known, _ = told.get(same_quantity(name), (None, None))
        if known is not None:
            raise InputError(f"{known} and {name}: expected one of them", name)
        text = value if isinstance(value, str) else repr(number(name, value, "a number or a word"))
        told[same_quantity(name)] = (name, text)
    return list(told.values())


def engine_of(vehicle: Vehicle) -> _engine.Vehicle:
    """What the engine lands."""
    engine: _engine.Vehicle = an_instance("vehicle", vehicle, Vehicle, "a Vehicle; Vehicle.from_toml(path) reads one")._engine
    return engine
