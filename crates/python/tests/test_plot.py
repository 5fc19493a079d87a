"""Pictures."""

from __future__ import annotations

import subprocess
import sys

import matplotlib
import matplotlib.pyplot
import numpy as np
import pytest

import touchdown as td

from conftest import SHORT

matplotlib.use("agg")


def test_each_picture_takes_axes_and_returns_them(root, lander, scene):
    figure, axes = matplotlib.pyplot.subplots(2, 2)
    profile = td.read(root / "results/figure-4-09.csv")
    surface = td.read(root / "results/surface-4-20.csv")
    history = td.land(lander, scene).history(0.05)
    dependence = td.sensitivity(lander, scene, ["friction", "slope_deg"], search=SHORT, progress=False)
    assert td.plot.profile(profile, ax=axes[0, 0]) is axes[0, 0]
    assert td.plot.contours(surface, ax=axes[0, 1]) is axes[0, 1]
    assert td.plot.history(history, ax=axes[1, 0], columns=["strut_force_#_lb"]) is axes[1, 0]
    assert td.plot.tornado(dependence, ax=axes[1, 1]) is axes[1, 1]
    assert [axes.get_xlabel() for axes in axes[0]] == ["roll, deg", "roll, deg"]
    assert len(axes[1, 0].lines) == 3 and len(axes[1, 1].patches) == 2
    figure.canvas.draw()


def test_a_map_shows_its_edges(lander, scene):
    axes = {"cross_slope_deg": [160, 180], "roll_deg": [20, 60]}
    found = td.map(lander, scene, axes, {"cross_slope_deg": 10, "roll_deg": 20}, error_fps=2, search=SHORT, progress=False)
    assert len(td.plot.contours(found).lines) == len(set(found.edge.values))


def test_rows_that_jump_are_bars_of_a_tornado(lander, scene):
    parameters = ["friction", "slope_deg", "roll_deg"]
    table = td.sensitivity(lander, scene, parameters, search=SHORT, progress=False)
    known = table.loc["friction", "vh_change_fps"]
    # What the engine tells of a parameter at which V_H jumps, and of one of which it knows nothing.
    table.loc["slope_deg", ["vh_change_fps", "vh_change_error_fps"]] = np.nan
    table.loc["slope_deg", "vh_at_plus_span_fps"] = table.loc["slope_deg", "first_transition_fps"] - 9
    table.loc["roll_deg", ["vh_change_fps", "vh_change_error_fps", "vh_at_plus_span_fps"]] = np.nan
    ax = td.plot.tornado(table)
    assert [label.get_text() for label in ax.get_yticklabels()] == ["friction", "slope_deg"]
    assert [bar.get_width() for bar in ax.patches] == pytest.approx([known, -9])


def test_what_cannot_be_drawn(root, lander, scene):
    surface = td.read(root / "results/surface-4-20.csv")
    with pytest.raises(td.InputError, match="over 1 axis"):
        td.plot.profile(surface)
    history = td.land(lander, scene).history(0.5)
    with pytest.raises(td.InputError, match="columns = 'sigma'"):
        td.plot.history(history, columns=["sigma"])
    with pytest.raises(td.InputError, match="columns of one unit"):
        td.plot.history(history, columns=["sigma_deg", "clearance_ft"])


def test_matplotlib_is_loaded_for_pictures_only():
    script = "import sys, touchdown; assert 'matplotlib' not in sys.modules; touchdown.plot; assert 'matplotlib' in sys.modules"
    subprocess.run([sys.executable, "-c", script], check=True)
