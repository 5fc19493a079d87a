"""Vehicles, scenes and results: they never change, compare by what they are, and survive pickling."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

import touchdown as td

from conftest import SHORT


def test_a_vehicle_goes_through_a_dictionary_and_through_its_text(lander):
    assert td.Vehicle.from_dict(lander.to_dict()) == lander
    assert td.Vehicle(lander.to_toml()) == lander
    assert lander.name == "Surveyor, Table 4-1" and lander.legs == 3
    assert td.vehicles.four_legs().legs == 4 and td.vehicles.six_legs().legs == 6


def test_numbers_are_replaced_under_any_spelling(lander):
    softer = lander.replace({"strut.preload_lb": 150, "vehicle.legs[2].strut.preload_n": 800})
    assert softer.to_dict()["strut"]["preload_lb"] == 150
    assert softer.to_dict()["legs"][1]["strut"]["preload_lb"] == pytest.approx(800 / 4.4482216152605)
    assert softer != lander and lander == td.vehicles.surveyor()
    assert lander.replace({"strut.preload_lb": lander.to_dict()["strut"]["preload_lb"]}) == lander


def test_units_make_no_other_scene():
    feet = td.Scene(vertical_velocity_fps=10, slope_deg=15, friction=1)
    metres = td.Scene(slope_deg=15.0, friction=1.0, vertical_velocity_mps=3.048)
    assert feet == metres and hash(feet) == hash(metres)
    assert feet != feet.replace(friction=0.9)
    assert feet.replace({"vertical_velocity_mps": 3.0}).to_dict() == {"slope_deg": 15, "friction": 1, "vertical_velocity_mps": 3}


def test_one_form_of_the_attitude_replaces_the_other(scene):
    tipped = scene.replace(roll_deg=10).replace(tip_deg=5, tip_azimuth_deg=90)
    assert "roll_deg" not in tipped.to_dict() and tipped.tip_deg == 5
    assert "tip_deg" not in tipped.replace(pitch_deg=1).to_dict()
    assert scene.replace(gravity="mars").replace(gravity_mps2=1.6).to_dict()["gravity_mps2"] == 1.6


def test_scenes_have_conditions_as_attributes(scene):
    assert scene.slope_deg == 15 and "slope_deg" in dir(scene)
    with pytest.raises(AttributeError, match="has no roll_deg: it has vertical_velocity_fps"):
        scene.roll_deg


def test_everything_pickles_compares_and_hashes(lander, scene):
    landing = td.land(lander, scene)
    boundary = td.boundary(lander, scene, search=SHORT, progress=False)
    for one in (lander, scene, landing, boundary):
        again = pickle.loads(pickle.dumps(one))
        assert again == one and hash(again) == hash(one)


def test_errors_pickle_with_what_they_are_about():
    with pytest.raises(td.InputError) as caught:
        td.Scene(slope_deg=95)
    again = pickle.loads(pickle.dumps(caught.value))
    assert (str(again), again.key, again.value) == (str(caught.value), "slope_deg", "95")


def test_notebooks_show_short_tables(lander, scene):
    landing = td.land(lander, scene)
    assert "stable-rockback at 2.843616 s" in landing._repr_html_()
    assert "slope_deg" in scene._repr_html_() and "mass_slug" in lander._repr_html_()
    bands = td.boundary(lander, scene, search=SHORT | {"bands": "all"}, progress=False)
    picture = bands._repr_html_()
    assert picture.count("<div title=") == len(bands.bands) and "unstable" in picture
    assert repr(scene).startswith("Scene(vertical_velocity_fps=14, ")


def test_a_landing_is_told_in_a_line(lander, scene):
    told = repr(td.land(lander, scene))
    assert told.startswith("<Landing of Surveyor") and "stable-rockback at 2.844 s" in told and len(told) < 160


def test_boundaries_are_told_in_si(lander, scene):
    found = td.boundary(lander, scene, search=SHORT | {"bands": "all"}, progress=False)
    known, told = found.to_frame(), found.to_frame("SI")
    assert list(told)[:3] == ["from_mps", "to_mps", "outcome"]
    assert np.allclose(told.to_mps, known.to_fps * 0.3048, rtol=1e-15) and told.solver_tolerance.equals(known.solver_tolerance)
    row = found.to_series("SI")
    assert row.first_transition_mps == pytest.approx(found.first_transition_fps * 0.3048, rel=1e-15)
    assert row.first_transition_to == found.first_transition_to and row.landings == found.landings
    with pytest.raises(td.InputError, match="US"):
        found.to_frame("metric")
