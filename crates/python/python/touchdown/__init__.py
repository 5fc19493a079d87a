"""How fast sideways may a legged lander touch down before it topples?

The engine of the command line ``touchdown`` with the shapes of Python: vehicles and scenes that never change, landings with attributes,
tables of pandas, sweeps and maps of xarray.

>>> import touchdown as td
>>> lander = td.vehicles.surveyor()
>>> scene = td.Scene(vertical_velocity_fps=14, horizontal_velocity_fps=11.25,
...                  cross_slope_deg=180, slope_deg=15, friction=1.0)
>>> td.land(lander, scene).outcome
'stable-rockback'
"""

from importlib import import_module
from typing import Any

from touchdown import _engine, vehicles
from touchdown._units import use_units
from touchdown.boundaries import Band, Boundary, boundary
from touchdown.cases import land_many, land_row
from touchdown.errors import EngineError, InputError, LandingWarning
from touchdown.landing import Landing, land
from touchdown.reading import read
from touchdown.scene import Scene
from touchdown.sweeps import map, run, sample, sensitivity, sweep
from touchdown.vehicle import Vehicle

__all__ = [
    "Band",
    "Boundary",
    "EngineError",
    "InputError",
    "Landing",
    "LandingWarning",
    "Scene",
    "Vehicle",
    "boundary",
    "land",
    "land_many",
    "land_row",
    "map",
    "read",
    "run",
    "sample",
    "sensitivity",
    "sweep",
    "use_units",
    "vehicles",
]


__version__ = _engine.VERSION


def __dir__() -> list[str]:
    return sorted([*__all__, "__version__", "plot"])


def __getattr__(name: str) -> Any:
    # Nobody loads matplotlib, or needs to have it, but for pictures.
    if name == "plot":
        return import_module("touchdown.plot")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
