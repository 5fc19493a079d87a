"""What tests share."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

import touchdown as td

ROOT = Path(__file__).resolve().parents[3]
#: A search that takes some twenty landings.
SHORT = {"from_fps": 8, "to_fps": 16, "scan_step_fps": 1, "tolerance_fps": 0.05}


@pytest.fixture(scope="session")
def root() -> Path:
    """The root of the repository."""
    return ROOT


@pytest.fixture
def lander() -> td.Vehicle:
    return td.vehicles.surveyor()


@pytest.fixture
def scene() -> td.Scene:
    """The baseline of the report of 1966."""
    return td.Scene(
        vertical_velocity_fps=14, horizontal_velocity_fps=11.25, cross_slope_deg=180, slope_deg=15, friction=1.0
    )


@pytest.fixture(scope="session")
def program() -> Callable[..., str]:
    """The command line, which `cargo build --release` has built."""
    path = ROOT / "target" / "release" / "touchdown"

    def run(*arguments: object) -> str:
        words = [str(path), *map(str, arguments)]
        done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return done.stdout

    return run
