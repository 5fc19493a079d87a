"""Vehicles, scenes and results: they never change, compare by what they are, and survive pickling."""

from __future__ import annotations

import dataclasses
import pickle
import re
from importlib.metadata import version
from inspect import getdoc, signature
from typing import Literal, get_args, get_origin, get_type_hints

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


def test_lists_and_words_are_replaced(lander):
    four = td.vehicles.four_legs()
    profile = {"footpad.profile.interference_mm": np.array([0, 10, 20]), "vehicle.footpad.profile.relative_pressure": [0, 1, 1]}
    other = four.replace(profile | {"name": "Other", "mass_kg": 500})
    assert other.to_dict()["footpad"]["profile"] == {"interference_mm": [0, 10, 20], "relative_pressure": [0, 1, 1]}
    assert other.name == "Other" and other != four
    assert lander.replace({"rules": "physical"}).to_dict()["rules"] == "physical"
    own = four.replace({"legs[2].footpad": four.to_dict()["footpad"], "legs[2].footpad.diameter_m": 0.4})
    assert own.to_dict()["legs"][1]["footpad"]["diameter_ft"] == pytest.approx(0.4 / 0.3048)
    for change, said in [
        ({"rules": "lunar"}, 'rules = "lunar": expected "1966" or "physical"'),
        ({"footpad.profile.relative_pressure": [0, 1]}, "footpad.profile.relative_pressure = [0, 1]: 2 numbers: expected as many"),
        ({"name.short": "A"}, "name = 'Surveyor, Table 4-1': expected a table"),
        ({"legs[7].strut.preload_lb": 1}, "vehicle.legs[7].strut.preload_lb: the vehicle has 3 legs"),
    ]:
        with pytest.raises(td.InputError, match=re.escape(said)):
            (four if "footpad" in next(iter(change)) else lander).replace(change)


def test_parts_of_thrust_and_footing_are_replaced(scene):
    pushed = scene.replace(thrust={"time_s": [0, 1], "force_lb": [100, 0]})
    assert pushed.replace({"thrust.scale": 2}).thrust == pushed.thrust | {"scale": 2}
    assert "scale" not in pushed.thrust
    rough = scene.replace({"footing[2].height_m": 0.1})
    assert rough.footing == [{}, {"height_m": 0.1}]
    assert rough.replace({"footing[2].height_ft": 0.5}).footing == [{}, {"height_ft": 0.5}]


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


def test_nothing_can_be_set(lander, scene):
    with pytest.raises(AttributeError, match=r"slope_deg cannot be set: a scene never changes; scene\.replace"):
        scene.slope_deg = 3
    with pytest.raises(AttributeError, match=r"mass_kg cannot be set: a vehicle never changes; vehicle\.replace"):
        lander.mass_kg = 5000
    landing = td.land(lander, scene, {"tolerance": 1e-7})
    with pytest.raises(TypeError, match="does not support item assignment"):
        landing.solver["tolerance"] = 1
    assert landing.solver == {"tolerance": 1e-7}
    found = td.boundary(lander, scene, search=SHORT | {"bands": "all"}, progress=False)
    for result, name in [(landing, "steps"), (landing, "min_clearance_m"), (found, "landings"), (found.bands[0], "unknown")]:
        with pytest.raises(AttributeError, match=f"cannot assign to field '{name}'"):
            setattr(result, name, 1)


def test_what_is_within_a_scene_stays(scene):
    lifted = scene.replace(thrust={"time_s": [0, 1], "force_lb": [100, 0]}, footing=[{"height_ft": 0.1}])
    lifted.thrust["scale"] = 3
    lifted.footing[0]["height_ft"] = 1
    lifted.to_dict()["thrust"]["force_lb"][0] = 7
    assert "scale" not in lifted.thrust and lifted.footing == [{"height_ft": 0.1}]
    assert lifted.thrust["force_lb"] == [100, 0]


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


def test_objects_are_told_in_a_line(lander, scene):
    assert repr(td.land(lander, scene)) == (
        "<Landing of Surveyor, Table 4-1: stable-rockback at 2.844 s, least stability angle 10.834 deg at 2.811 s, "
        "least clearance 0.539 ft, largest strut force 3184.480 lb>"
    )
    found = td.boundary(lander, scene, search=SHORT | {"bands": "all"}, progress=False)
    assert repr(found) == "<Boundary of Surveyor, Table 4-1: V_H 11.391 ft/s to unstable, certain, 2 bands>"
    assert repr(found.bands[0]) == "<Band from 8.000 ft/s to 11.391 ft/s: stable-subsided>"
    patchy = dataclasses.replace(found, patchy_to_fps=12.5, patchy_landings=8, patchy_not_stable=3)
    assert repr(patchy).endswith("V_H 11.391 ft/s to unstable, certain, patchy up to 12.500 ft/s, 2 bands>")
    assert "patchy up to 3.810 m/s" in repr(dataclasses.replace(patchy, units="SI"))
    nothing = td.boundary(lander, scene, search={"from_fps": 1, "to_fps": 2, "tolerance_fps": 0.1}, progress=False)
    assert repr(nothing) == "<Boundary of Surveyor, Table 4-1: no transition, 1 band>"


def test_a_boundary_whose_lowest_velocity_topples_says_so(lander, scene):
    with pytest.warns(td.LandingWarning, match="at or below"):
        found = td.boundary(lander, scene, search=SHORT | {"from_fps": 13}, progress=False)
    assert found.first_transition_fps == found.bracket_high_fps == 13 and found.bracket_low_fps is None
    assert repr(found) == "<Boundary of Surveyor, Table 4-1: V_H at or below 13.000 ft/s, already unstable, 1 band>"
    assert "transitions: at or below 13<" in found._repr_html_()


def test_landings_come_in_si(lander, scene):
    known, told = td.land(lander, scene), td.land(lander, scene, units="SI")
    assert told == known and hash(told) == hash(known)
    for name, si, factor in [
        ("min_clearance_ft", "min_clearance_m", 0.3048),
        ("strut_work_ftlb", "strut_work_j", 1.3558179483314003),
        ("max_strut_force_lb", "max_strut_force_n", 4.4482216152605),
    ]:
        assert np.allclose(getattr(told, si), np.array(getattr(known, name)) * factor, rtol=1e-14)
        assert getattr(known, si) == getattr(told, si) and si in dir(known)
    assert None in told.block_contact_s
    assert told.history(0.5).equals(known.history(0.5, "SI")) and "clearance_m" in told.history(0.5)
    assert told.to_series().equals(known.to_series("SI")) and told.to_series("US").equals(known.to_series())
    assert f"{told.min_clearance_m:.3f} m, " in repr(told) and " N>" in repr(told)
    assert "least ground clearance, m" in told._repr_html_() and "energy closure, J" in told._repr_html_()
    assert pickle.loads(pickle.dumps(told)).units == "SI"
    with pytest.raises(AttributeError, match="the landing has no min_clearance_km"):
        told.min_clearance_km
    with pytest.raises(td.InputError, match='units = "cgs"'):
        td.land(lander, scene, units="cgs")


def test_boundaries_come_in_si(lander, scene):
    search = SHORT | {"bands": "all"}
    known = td.boundary(lander, scene, search=search, progress=False)
    told = td.boundary(lander, scene, search=search, units="SI", progress=False)
    assert told == known
    # As sweeps convert it, to the last bit.
    swept = td.sweep(lander, scene, {"roll_deg": [0]}, search=search, units="SI", progress=False).squeeze()
    assert told.first_transition_mps == known.first_transition_mps == swept.first_transition.item()
    assert told.first_transition_mps == pytest.approx(known.first_transition_fps * 0.3048, rel=1e-15)
    assert [band.to_mps for band in known.bands] == swept.band_to.values.tolist()
    frame = told.to_frame()
    assert list(frame)[:3] == ["from_mps", "to_mps", "outcome"] and frame.equals(known.to_frame("SI"))
    assert frame.to_mps.tolist() == swept.band_to.values.tolist()
    assert frame.solver_tolerance.equals(known.to_frame().solver_tolerance)
    row = told.to_series()
    assert row.first_transition_mps == told.first_transition_mps and row.landings == known.landings
    assert row.first_transition_to == known.first_transition_to and "units" not in row
    assert "V_H 3.472 m/s" in repr(told) and repr(told.bands[0]).startswith("<Band from 2.438 m/s")
    assert "V_H, m/s" in told._repr_html_() and "V_H, ft/s" in known._repr_html_()
    assert pickle.loads(pickle.dumps(told)).units == "SI"
    with pytest.raises(td.InputError, match="US"):
        known.to_frame("metric")


@pytest.mark.parametrize("kind", [td.Landing, td.Boundary, td.Band])
def test_every_attribute_is_described_once(kind):
    described = re.findall(r"^(\w+) : ", getdoc(kind), re.MULTILINE)
    assert sorted(described) == sorted(field.name.removeprefix("_") for field in dataclasses.fields(kind))


def test_attributes_are_described_in_the_words_of_the_catalogue():
    assert "\nmax_stroke_ft : tuple[float, ...]\n    Greatest stroke of the strut.\n" in getdoc(td.Landing)
    assert "How it ended; words (docs/guide.md#1-one-landing)." in getdoc(td.Landing)
    assert "Of the transition at `to_fps`, as in transitions." in getdoc(td.Band)
    assert "- ``slope_deg``: slope θ_s of the surface; -90 < value < 90\n" in getdoc(td.Scene)


def test_units_are_chosen_once(lander, scene):
    td.use_units("SI")
    try:
        assert td.land(lander, scene).units == "SI" and td.land(lander, scene, units="US").units == "US"
        assert "min_clearance_m" in td.land_many(lander, {"roll_deg": [0]}, scene=scene, progress=False)
        assert td.boundary(lander, scene, search=SHORT, progress=False).units == "SI"
        assert td.sweep(lander, scene, {"roll_deg": [0]}, search=SHORT, progress=False).first_transition.units == "m/s"
        with pytest.raises(td.InputError, match='units = "cgs": expected "US" or "SI"'):
            td.use_units("cgs")
        assert td.land(lander, scene).units == "SI"
    finally:
        td.use_units("US")
    assert td.land(lander, scene).units == "US"


def words_of(call, name: str) -> str:
    """The words that an argument takes by its type, as complaints tell them."""
    [words] = [one for one in [*get_args(get_type_hints(call)[name]), get_type_hints(call)[name]] if get_origin(one) is Literal]
    return [word for word in get_args(words)]


def test_options_are_in_the_signatures(lander, scene):
    for call in (td.sweep, td.map, td.sample, td.sensitivity):
        parameters = signature(call).parameters
        assert {"out", "name", "title", "units", "parquet", "overwrite", "threads", "progress"} <= set(parameters)
        assert not [one for one in parameters.values() if one.kind is one.VAR_KEYWORD]
    with pytest.raises(TypeError, match=r"sweep\(\) got an unexpected keyword argument 'thread'"):
        td.sweep(lander, scene, {"roll_deg": [0]}, thread=1)


@pytest.mark.parametrize(("call", "name"), [(td.sweep, "job"), (td.sweep, "units"), (td.sample, "design"), (td.sample, "job")])
def test_types_name_the_words_of_the_engine(call, name, lander, scene):
    rest = {"count": 3, "seed": 1} if call is td.sample else {}
    with pytest.raises(td.InputError) as caught:
        call(lander, scene, {"roll_deg": {"from": 0, "to": 1}}, **{name: "unknown"}, **rest, progress=False)
    assert re.findall(r'"([\w-]+)"', caught.value.allowed) == words_of(call, name)


def test_the_package_shows_what_is_public():
    assert td.__version__ == version("touchdown")
    assert {"land", "plot", "vehicles", "__version__"} <= set(dir(td))
    assert not {"Any", "import_module", "errors", "landing"} & set(dir(td))


def test_legs_of_three_struts_land_as_hinged_ones_do(scene):
    lander = td.vehicles.apollo_like()
    stiffer = lander.replace({"secondary.stiffness_n_per_m": 2e7, "legs[2].primary.damping_n_s_per_m": 900})
    assert stiffer.legs == 4 and stiffer != lander
    for vehicle in (lander, stiffer):
        landing = td.land(vehicle, scene.replace(vertical_velocity_fps=8, horizontal_velocity_fps=2, slope_deg=5))
        assert landing.outcome == "stable-subsided" and max(landing.max_stroke_share) < 1
        table = landing.history(0.1)
        assert {"foot_x_1_ft", "stroke_a_4_ft", "strut_force_b_2_lb"} <= set(table.columns)
        assert "gamma_1_deg" not in table.columns
    with pytest.raises(td.InputError, match="only legs of kind"):
        td.vehicles.four_legs().replace({"secondary.stiffness_n_per_m": 2e7})
