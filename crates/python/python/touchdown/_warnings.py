"""Warnings, on behalf of whoever called the package."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterable

from touchdown.errors import LandingWarning


def warn_of_journal(told: Iterable[str]) -> None:
    """Warn of each fault of a journal."""
    for warning in told:
        warnings.warn(warning, RuntimeWarning, stacklevel=_level_of_caller())


def warn_of_landings(told: Iterable[str]) -> None:
    """Warn once of all landings of a call."""
    if said := "; ".join(told):
        warnings.warn(said, LandingWarning, stacklevel=_level_of_caller())


def _level_of_caller() -> int:
    """How far above the function that asks the first one outside the package stands."""
    frame, level = sys._getframe(1), 1
    while frame.f_back is not None and frame.f_globals["__name__"].startswith("touchdown."):
        frame, level = frame.f_back, level + 1
    return level
