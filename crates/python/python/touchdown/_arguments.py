"""Arguments that are looked at before they go to the engine."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from touchdown.errors import InputError


def an_instance(name: str, value: Any, kinds: type | tuple[type, ...], allowed: str) -> Any:
    """This value if it is one of these kinds."""
    if not isinstance(value, kinds):
        raise InputError.of_value(name, value, allowed)
    return value


def a_dictionary(name: str, value: Any, allowed: str = "a dictionary") -> dict[str, Any]:
    """A copy of a mapping with texts as keys, or of such a Series."""
    given = dict(an_instance(name, value, (Mapping, pd.Series), allowed))
    for key in given:
        an_instance(f"key of {name}", key, str, "a text")
    return given


def settings(name: str, value: Any) -> dict[str, Any]:
    """A copy of a dictionary of settings, empty where there is none."""
    return {} if value is None else a_dictionary(name, value)


def a_path(name: str, value: Any) -> str:
    """The path of a file or a folder."""
    path: str = os.fspath(an_instance(name, value, (str, os.PathLike), "a path"))
    return path


def text_of(path: str) -> str:
    """The text of a file."""
    try:
        return Path(path).read_text(encoding="utf-8")
    except UnicodeDecodeError:
        allowed = "text in UTF-8"
        raise InputError(f"{path}: expected {allowed}", allowed=allowed) from None


def a_flag(name: str, value: Any) -> bool:
    """True or False."""
    return bool(an_instance(name, value, (bool, np.bool_), "True or False"))


def names(name: str, value: Any) -> list[Any]:
    """Names, in a list or the like."""
    allowed = "a list of names"
    if isinstance(value, (str, Mapping)):
        raise InputError.of_value(name, value, allowed)
    return list(an_instance(name, value, Iterable, allowed))


def thread_count(value: Any) -> int | None:
    """A number of threads; None stands for all cores."""
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or value < 1:
        raise InputError.of_value("threads", value, "a whole number from 1 on, or None for all cores")
    return int(value)


def number(name: str, value: Any, allowed: str) -> float:
    """A number."""
    if isinstance(value, bool):
        raise InputError.of_value(name, value, allowed)
    return float(an_instance(name, value, (int, float, np.number), allowed))
