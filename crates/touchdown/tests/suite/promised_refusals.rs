//! What `docs/reference.md` promises to refuse, tried in the files that it describes: each with its message. Other tests have what
//! options, maps and covariances refuse, and misspelled keys.

#![allow(missing_docs, reason = "tests are not an interface")]

use crate::common::{BASELINE, Bench, LAND_CASES, SURVEYOR, SWEEP};

const APOLLO_LIKE: &str = include_str!("../../../../sweeps/vehicles/apollo-like.toml");
const FRICTION: &str = "friction = 1.0";
const ROLL: &str = "roll_deg = { from = -10, to = 10, step = 10 }";
const TOLERANCE: &str = "tolerance_fps = 0.1";

/// What is replaced in the vehicle file, by what, and the message.
#[rustfmt::skip]
const VEHICLES: [(&str, &str, &str); 27] = [
    (r#""1966"  "#, r#""1967"  "#, r#"surveyor.toml:3: rules = "1967": expected "1966" or "physical""#),
    ("gravity_fps2 = 5.31", "gravity_fps2 = 0", "surveyor.toml:5: gravity_fps2 = 0: expected 0 < value ≤ 1e9"),
    ("= 1.445", "= -9", "surveyor.toml:6: center_of_gravity_height_ft (over footpad 1) = -7.415522676408691: expected the CG above the footpads"),
    ("= 1.445", "= 1.445\ncenter_of_gravity_offset_x_ft = 9", "surveyor.toml:7: center_of_gravity_offset_x_ft = 9: expected -3.6935 < value < 3.6935, which keeps the CG over the polygon of the feet at center_of_gravity_offset_y_ft = 0"),
    ("angle_deg = 41", "angle_deg = 91", "surveyor.toml:20: linkage.hardpoint_angle_deg = 91: expected 0 ≤ value ≤ 90"),
    ("extended_length_ft = 3.1275", "extended_length_ft = 9", "surveyor.toml:24: strut.extended_length_ft = 9: expected a length that the hardpoints and the lower link can span"),
    ("minimum_length_ft = 2.7525", "minimum_length_ft = 3.2", "surveyor.toml:25: strut.minimum_length_ft = 3.2: expected positive and below strut.extended_length_ft"),
    ("friction_fraction = 0.05", "friction_fraction = 1", "surveyor.toml:29: strut.friction_fraction = 1: expected 0 ≤ value < 1"),
    ("extended_length", "kind = \"spring\"\nextended_length", r#"surveyor.toml:24: strut.kind = "spring": expected "damper" or "honeycomb""#),
    ("preload_lb = 185", "preload_lb = 185\nunloading_stiffness_lb_per_ft = 1e5", r#"surveyor.toml:28: strut.unloading_stiffness_lb_per_ft = 1e5: only struts of kind "honeycomb" have this, and this one is of kind "damper""#),
    ("preload_lb = 185", "", "surveyor.toml:23: strut.preload_lb is missing: expected 0 < value ≤ 1e9 lb, preload F_p of the spring"),
    ("stroke_in = [0, 0.25", "stroke_in = [0.1, 0.25", "surveyor.toml:35: strut.spring_profile.stroke_in[1] = 0.1: expected 0 as the first abscissa"),
    ("multiplier = [1, 1, 1", "multiplier = [1, 1", "surveyor.toml:36: strut.spring_profile.multiplier = […]: 19 numbers: expected as many as in stroke_in, 20"),
    ("multiplier = [1, 1.08", "multiplier = [1, -1.08", "surveyor.toml:40: strut.damping_profile.multiplier[2] = -1.08: expected 0 ≤ value ≤ 1e9, the scale included"),
    ("minimum_angle_deg = 0.75", "minimum_angle_deg = 60", "surveyor.toml:47: footpad.minimum_angle_deg = 60: expected below the angle of the extended link, 17.9978 deg"),
    ("maximum_angle_deg = 45", "maximum_angle_deg = 9", "surveyor.toml:48: footpad.maximum_angle_deg = 9: expected above the angle of the extended link, 17.9978 deg"),
    ("maximum_angle_deg = 45", "maximum_angle_deg = 90", "surveyor.toml:48: footpad.maximum_angle_deg = 90: expected -90 < value < 90"),
    ("maximum_angle_deg = 45", "maximum_angle_deg = 45\nhinge_damping_ftlb_s = 2", "sweep.toml:3: vehicle.footpad.hinge_damping_ftlb_s = 2: expected no damping: only the contact rule \"face\" knows it"),
    ("maximum_angle_deg = 45", "maximum_angle_deg = 45\nedge_angle_deg = 65", "surveyor.toml:42: footpad.edge_load_lb is missing: expected 0 < value ≤ 1e9 lb, load under which its lowest rim crushes"),
    ("maximum_angle_deg = 45", "maximum_angle_deg = 45\nedge_angle_deg = 84\nedge_load_lb = 187", "surveyor.toml:49: footpad.edge_angle_deg = 84: expected 30 ≤ value < 84"),
    ("[0, 1, 1, 21]", "[0, 1, 0.9, 21]", "surveyor.toml:62: block.profile.relative_pressure[3] = 0.9: expected 1 ≤ value ≤ 57.500000: no segment falls, and none is steeper than the first"),
    ("[0, 1, 1, 21]", "[0.1, 1, 1, 21]", "surveyor.toml:62: block.profile.relative_pressure[1] = 0.1: expected 0, the pressure at no interference"),
    ("[0, 1, 1, 21]", "[0, 0.001, 1, 21]", "surveyor.toml:62: block.profile.relative_pressure[3] = 1: expected 0.001 ≤ value ≤ 0.057500: no segment falls, and none is steeper than the first"),
    ("azimuth_deg = 120", "azimuth_deg = 0.5", "surveyor.toml:70: legs[2].azimuth_deg = 0.5: expected 1 deg or more from another leg, that at 0.0000 deg"),
    ("azimuth_deg = 120", "azimuth_deg = 230", "surveyor.toml:70: legs[2].azimuth_deg = 230: expected less than 180 deg from the leg before it, that at 0.0000 deg: legs surround the centreline"),
    ("azimuth_deg = 240", "azimuth_deg = 240\nblock = \"some\"", r#"surveyor.toml:74: legs[3].block = "some": expected a table [block], or "none""#),
    ("mass_slug = 20", "mass_slug = 20\nmass_kg = 300", "surveyor.toml:5: mass_kg = 300: expected one spelling of a quantity, but line 4 says mass_slug"),
];

/// Keys of a strut of kind `"honeycomb"` in place of its crush load.
#[rustfmt::skip]
const CARTRIDGES: [(&str, &str); 9] = [
    ("crush_load = { stroke_in = [0], load_lb = [900] }\npreload_lb = 185", r#"surveyor.toml:30: strut.preload_lb = 185: only struts of kind "damper" have this, and this one is of kind "honeycomb""#),
    ("", "surveyor.toml:23: strut.crush_load is missing: expected a table [strut.crush_load]"),
    ("crush_load = { stroke_in = [0, 2, 2, 2], load_lb = [900, 900, 950, 990] }", "surveyor.toml:29: strut.crush_load.stroke_in = [0, 2, 2, 2]: expected at most two knots at one stroke"),
    ("crush_load = { stroke_in = [0, 2, 1], load_lb = [900, 900, 950] }", "surveyor.toml:29: strut.crush_load.stroke_in = [0, 2, 1]: expected strokes that do not decrease"),
    ("crush_load = { stroke_in = [1, 2], load_lb = [900, 900] }", "surveyor.toml:29: strut.crush_load.stroke_in = [1, 2]: expected first stroke 0"),
    ("crush_load = { stroke_in = [0, 2], load_lb = [900] }", "surveyor.toml:29: strut.crush_load.load_lb = [900]: 1 numbers: expected as many as strokes, 2"),
    ("crush_load = { stroke_in = [0, 2], load_lb = [900, -1] }", "surveyor.toml:29: strut.crush_load.load_lb[2] = -1: expected 0 ≤ value ≤ 1e9, the scale included"),
    ("crush_load = { stroke_in = [0, 2], load_lb = [0, 900] }", "surveyor.toml:29: strut.crush_load.stroke_in = [0, 2]: expected a load > 0 at stroke 0"),
    ("crush_load = { stroke_in = [0], load_lb = [900], scale = 0 }", "surveyor.toml:29: strut.crush_load.scale = 0: expected 0 < value ≤ 1e9"),
];

/// What is replaced in the vehicle file of a lander on legs of three struts, by what, and the message.
#[rustfmt::skip]
const THREE_STRUTS: [(&str, &str, &str); 5] = [
    ("kind = \"cantilever\"\nfoot", "kind = \"tripod\"\nfoot", r#"surveyor.toml:21: linkage.collar_m = 2: only legs of kind "cantilever" have this, and this one is of kind "tripod""#),
    ("name =", "block = \"none\"\nname =", r#"surveyor.toml:3: block = "none": only legs of kind "hinged" have this, and this one is of kind "cantilever""#),
    ("name =", "rules = \"1966\"\nname =", r#"surveyor.toml:3: rules = "1966": expected "physical": legs of three struts land by no other rules"#),
    ("azimuth_deg = 90", "azimuth_deg = 90\nlinkage.kind = \"hinged\"", r#"surveyor.toml:69: legs[2].linkage.kind = "hinged": leg 1 is of kind "cantilever" and leg 2 of kind "hinged": expected one kind for all legs"#),
    ("hardpoint_spread_m = 0.9", "hardpoint_spread_m = 0.001", "surveyor.toml:16: linkage (volume that the directions of the three struts span) = "),
];

/// Choices of `[solver]` that do not go with such a lander.
#[rustfmt::skip]
const BESIDE_THREE_STRUTS: [(&str, &str); 4] = [
    ("method = \"rk4\"", r#"sweep.toml:3: solver.method = "rk4": expected "located": legs of three struts land by nothing else"#),
    ("rules = \"1966\"", r#"sweep.toml:3: solver.rules = "1966": expected "physical": legs of three struts land by nothing else"#),
    ("contact_rule = \"pivot\"", r#"sweep.toml:3: solver.contact_rule = "pivot": expected "face": legs of three struts land by nothing else"#),
    ("rules = \"physical\"\nrest_rule = \"limits\"", r#"sweep.toml:3: solver.rest_rule = "limits": expected "energy": legs of three struts land by nothing else"#),
];

/// What is replaced in the sweep file, by what, and the message.
#[rustfmt::skip]
const SWEEPS: [(&str, &str, &str); 12] = [
    ("title", "units = \"metric\"\ntitle", r#"sweep.toml:1: units = "metric": expected "US" or "SI""#),
    ("title", "job = \"landing\"\ntitle", r#"sweep.toml:1: job = "landing": expected "boundary" or "outcome""#),
    ("title", "job = \"outcome\"\ntitle", r#"sweep.toml:11: search = a table: not used with job = "outcome""#),
    ("title", "statement = 3\ntitle", "sweep.toml:1: statement = 3: expected text in quotes"),
    ("slope_deg = 15\nfriction = 1.0\n[axes]\nroll_deg = { from = -10, to = 10, step = 10 }", "friction = 1.0\ntip_deg = 3\n[axes]\nslope_deg = [1, 2]", "sweep.toml:3: scene.tip_azimuth_deg is missing: expected -36000 ≤ value ≤ 36000 deg, tip form: azimuth Γ"),
    ("slope_deg = 15\nfriction = 1.0\n[axes]\nroll_deg = { from = -10, to = 10, step = 10 }", "friction = 1.0\ntip_deg = 181\ntip_azimuth_deg = 0\n[axes]\nslope_deg = [1, 2]", "sweep.toml:7: scene.tip_deg = 181: expected 0 ≤ value ≤ 180"),
    ("slope_deg = 15\nfriction = 1.0", "slope_deg = 40\nfriction = 1.0\n[[scene.footing]]\ntilt_along_deg = 55", "sweep.toml:9: scene.footing[1].tilt_along_deg = 55: expected a tilt that leaves slope and tilt together between -90 and 90"),
    ("friction = 1.0\n[axes]\nroll_deg = { from = -10, to = 10, step = 10 }", "[axes]\nroll_deg = { values = [1, 2], zip = \"a\" }\nfriction = { values = [1], zip = \"a\" }", r#"sweep.toml:9: axes.friction = { values = [1], zip = "a" }: moves together with roll_deg but has another number of values: expected the same number of values in one zip group"#),
    ("scan_step_fps = 1.25", "scan_step_fps = 1e-6", "sweep.toml:13: search.scan_step_fps = 1e-6: expected at most 1000000 steps"),
    ("scan_step_fps = 1.25", "scan_step_fps = 3", "sweep.toml:13: search.scan_step_fps = 3: expected at most to_fps - from_fps = 2.5"),
    ("from_fps = 10", "from_fps = -1", "sweep.toml:11: search.from_fps = -1: expected 0 ≤ value ≤ 10000"),
    ("tolerance_fps = 0.1", "tolerance_fps = 1e-10", "sweep.toml:14: search.tolerance_fps = 1e-10: expected 1e-9 ≤ value ≤ scan_step_fps = 1.25"),
];

/// Keys behind those of the scene.
#[rustfmt::skip]
const SCENES: [(&str, &str); 16] = [
    ("pitch_deg = 1\ntip_deg = 3\ntip_azimuth_deg = 0", "sweep.toml:8: scene.pitch_deg = 1: expected either pitch_deg, yaw_deg, roll_deg or tip_deg, tip_azimuth_deg, nominal_roll_deg, not both"),
    ("vertical_velocity_mps = 3", "sweep.toml:8: scene.vertical_velocity_mps = 3: expected one spelling of a quantity, but line 4 says vertical_velocity_fps"),
    (r#"gravity = "venus""#, r#"sweep.toml:8: scene.gravity = "venus": expected "moon", "mars", "earth" or "ceres", or a number as gravity_fps2 or gravity_mps2"#),
    ("gravity = \"moon\"\ngravity_fps2 = 5", r#"sweep.toml:8: scene.gravity = "moon": also given as a number: expected one of them"#),
    ("gravity_fps2 = 0", "sweep.toml:8: scene.gravity_fps2 = 0: expected 0 < value ≤ 1e9"),
    ("thrust = { time_s = [1], force_lb = [3] }", "sweep.toml:8: scene.thrust.time_s = [1]: expected 0 as the first time"),
    ("thrust = { time_s = [0, 1], force_lb = [3] }", "sweep.toml:8: scene.thrust.force_lb = [3]: 1 numbers: expected as many as in time_s, 2"),
    ("thrust = { time_s = [0], force_lb = [-3] }", "sweep.toml:8: scene.thrust.force_lb = [-3]: expected 0 ≤ value ≤ 1e9"),
    ("thrust = { time_s = [0, 2, 1], force_lb = [3, 3, 3] }", "sweep.toml:8: scene.thrust.time_s = [0, 2, 1]: expected a time after the one before, 2, and ≤ 10000"),
    ("thrust = { time_s = [], force_lb = [] }", "sweep.toml:8: scene.thrust.time_s = []: expected 1 to 16 numbers"),
    ("thrust = { time_s = [0], force_lb = [3], offset_x_ft = 1001 }", "sweep.toml:8: scene.thrust.offset_x_ft = 1001: expected -1000 ≤ value ≤ 1000"),
    ("thrust = { time_s = [0], force_lb = [3], scale = -1 }", "sweep.toml:8: scene.thrust.scale = -1: expected 0 ≤ value ≤ 1e9"),
    ("[[scene.footing]]\n[[scene.footing]]\n[[scene.footing]]\n[[scene.footing]]\nheight_ft = 1", "sweep.toml:12: scene.footing[4].height_ft = 1: expected the number of a leg: the vehicle has 3"),
    ("footing = [{}, {}, {}, {}, {}, {}, {}, {}, {}]", "sweep.toml:8: scene.footing = [{}, {}, {}, {}, {}, {}, {}, {}, {}]: 9 tables: expected at most one for each leg"),
    ("[[scene.footing]]\nheight_ft = 1001", "sweep.toml:9: scene.footing[1].height_ft = 1001: expected -1000 ≤ value ≤ 1000"),
    ("[[scene.footing]]\ntilt_along_deg = 61", "sweep.toml:9: scene.footing[1].tilt_along_deg = 61: expected -60 ≤ value ≤ 60"),
];

/// Axes in place of that of the sweep.
#[rustfmt::skip]
const AXES: [(&str, &str); 12] = [
    (r#"search.bands = ["first", "all"]"#, r#"sweep.toml:9: axes.search.bands = ["first", "all"]: cannot vary: expected [search] bands, one for the whole sweep"#),
    ("solver.error_per_second.velocity_fps = [1, 2]", "sweep.toml:9: axes.solver.error_per_second.velocity_fps = [1, 2]: unknown parameter"),
    ("roll_deg = { from = 0, to = 10, step = 5, count = 3 }", "sweep.toml:9: axes.roll_deg = { from = 0, to = 10, step = 5, count = 3 }: has step and count: expected only one of them"),
    ("roll_deg = { from = 0, to = 10 }", "sweep.toml:9: axes.roll_deg.step is missing: expected a number, or a count in its place"),
    ("roll_deg = { from = 0, to = 10, count = 1 }", "sweep.toml:9: axes.roll_deg.count = 1: expected a whole number from 2 to 1e7 (from 0 to 10)"),
    ("roll_deg = { from = 0, to = 10, count = 10000001 }", "sweep.toml:9: axes.roll_deg.count = 10000001: expected a whole number from 2 to 1e7 (from 0 to 10)"),
    ("roll_deg = { from = 0, to = 10, step = 1e-9 }", "sweep.toml:9: axes.roll_deg.step = 1e-9: expected a number that gives at most 1e7 values (from 0 to 10)"),
    ("roll_deg = { from = 0, to = 10, step = 0 }", "sweep.toml:9: axes.roll_deg.step = 0: expected a number with the sign of to - from, not 0 (from 0 to 10)"),
    (r#"roll_deg = { from = 0, to = 10, count = 3, spacing = "log" }"#, r#"sweep.toml:9: axes.roll_deg.from = 0: expected a number > 0 where the spacing is "log" (from 0 to 10)"#),
    (r#"roll_deg = { from = 1, to = 10, step = 3, spacing = "log" }"#, "sweep.toml:9: axes.roll_deg.count is missing: expected the number of values, from 2 to 1e7"),
    (r#"roll_deg = { from = 1, to = 10, count = 3, spacing = "cubic" }"#, r#"sweep.toml:9: axes.roll_deg.spacing = "cubic": expected "linear" or "log""#),
    ("roll_deg = { values = [1], from = 1 }", "sweep.toml:9: axes.roll_deg.from = 1: not used here: expected keys among values, zip"),
];

/// Axes of which nine points are drawn.
#[rustfmt::skip]
const DRAWN: [(&str, &str); 10] = [
    ("roll_deg = [1, 2]", "sweep.toml:9: axes.roll_deg = [1, 2]: expected a table such as { from = …, to = … }, { mean = …, sd = … }, { distribution = …, … } or { file = …, column = … }"),
    ("roll_deg = { from = 2, to = 1 }", "sweep.toml:9: axes.roll_deg.from = 2: expected a number below to"),
    (r#"roll_deg = { from = 0, to = 1, spacing = "log" }"#, r#"sweep.toml:9: axes.roll_deg.from = 0: expected a number > 0 where the spacing is "log""#),
    (r#"roll_deg = { distribution = "lognormal", mean = 0, sd = 1 }"#, "sweep.toml:9: axes.roll_deg.mean = 0: expected a number > 0"),
    ("roll_deg = { mean = 0, sd = 0 }", "sweep.toml:9: axes.roll_deg.sd = 0: expected a number > 0"),
    ("roll_deg = { mean = 0 }", "sweep.toml:9: axes.roll_deg.sd is missing: expected a number"),
    ("roll_deg = { mean = 0, sd = 1, from = 7, to = 9 }", "sweep.toml:9: axes.roll_deg.mean = 0: expected at most 6 sd from the range"),
    (r#"roll_deg = { file = "a.csv" }"#, "sweep.toml:9: axes.roll_deg.column is missing: expected the name of a column of the file"),
    (r#"roll_deg = { file = "a.csv", column = "a" }"#, r#"sweep.toml:9: axes.roll_deg.file = "a.csv": there is no file a.csv: expected the path of a table, relative to this file"#),
    (r#"roll_deg = { file = "a.csv", column = "a", zip = "b" }"#, r#"sweep.toml:9: axes.roll_deg.zip = "b": not used here: expected keys among file, column"#),
];

/// Keys of `[sample]`.
#[rustfmt::skip]
const SAMPLES: [(&str, &str); 7] = [
    ("design = \"random\"\ncount = 9\nseed = 1", r#"sweep.toml:11: sample.design = "random": expected "monte-carlo" or "latin-hypercube" or "sobol""#),
    ("design = \"monte-carlo\"\ncount = 0\nseed = 1", "sweep.toml:12: sample.count = 0: expected a whole number from 1 to 1000000000"),
    ("design = \"monte-carlo\"\ncount = 1000000001\nseed = 1", "sweep.toml:12: sample.count = 1000000001: expected a whole number from 1 to 1000000000"),
    ("design = \"latin-hypercube\"\ncount = 1000001\nseed = 1", "sweep.toml:12: sample.count = 1000001: expected a whole number from 1 to 1000000"),
    ("design = \"sobol\"\ncount = 65537\nseed = 1", "sweep.toml:12: sample.count = 65537: expected a whole number from 1 to 65536"),
    ("design = \"sobol\"\ncount = 9\nseed = -1", "sweep.toml:13: sample.seed = -1: expected a whole number from 0 to 9007199254740991"),
    ("design = \"sobol\"\ncount = 9\nseed = 9007199254740992", "sweep.toml:13: sample.seed = 9007199254740992: expected a whole number from 0 to 9007199254740991"),
];

/// What stands behind the keys of the search.
#[rustfmt::skip]
const BEHIND: [(&str, &str); 25] = [
    (r#"scan = "fast""#, r#"sweep.toml:15: search.scan = "fast": expected "full" or "skipping""#),
    ("scan_looseness = 101", "sweep.toml:15: search.scan_looseness = 101: expected 1 ≤ value ≤ 100"),
    (r#"refinement = "newton""#, r#"sweep.toml:15: search.refinement = "newton": expected "margin" or "bisection""#),
    (r#"certainty = "some""#, r#"sweep.toml:15: search.certainty = "some": expected "doubtful" or "all" or "none""#),
    ("[sensitivity]\nparameters = []", "sweep.toml:16: sensitivity.parameters = []: expected a list of at least one name"),
    ("[sensitivity]\nparameters = [\"title\"]", r#"sweep.toml:16: sensitivity.parameters[1] = "title": unknown parameter"#),
    ("[solver]\ntime_limit_s = 10001", "sweep.toml:16: solver.time_limit_s = 10001: expected 0 < value ≤ 10000"),
    ("[solver]\nstop = \"time\"", r#"sweep.toml:16: solver.stop = "time": expected "verdict", at which the landings of a search end"#),
    ("[solver]\nstop = \"rest\"", r#"sweep.toml:16: solver.stop = "rest": expected "verdict", at which the landings of a search end"#),
    ("[solver]\nstop = \"never\"", r#"sweep.toml:16: solver.stop = "never": expected "verdict" or "rest" or "time""#),
    ("[solver]\nerror_scale = 2", "sweep.toml:16: solver.error_scale = 2: expected only with method report or milne; the method is located"),
    ("[solver]\nmethod = \"report\"\ninterval_s = 0.01", "sweep.toml:17: solver.interval_s = 0.01: expected only with method rk4 or trapezoidal; the method is report"),
    ("[solver]\nmethod = \"rk4\"\ntolerance = 1e-5", "sweep.toml:17: solver.tolerance = 1e-5: expected only with method located; the method is rk4"),
    ("[solver]\nmethod = \"rk4\"\nfirst_interval_s = 0.01", "sweep.toml:17: solver.first_interval_s = 0.01: expected only with method report or milne; the method is rk4"),
    ("[solver]\nmethod = \"milne\"\nfirst_interval_s = 2", "sweep.toml:17: solver.first_interval_s = 2: expected 1e-9 ≤ value ≤ 1"),
    ("[solver]\nmethod = \"milne\"\nleast_interval_s = 2", "sweep.toml:17: solver.least_interval_s = 2: expected 1e-9 ≤ value ≤ 1"),
    ("[solver]\nmethod = \"report\"\nerror_scale = 0", "sweep.toml:17: solver.error_scale = 0: expected 0 < value ≤ 1e9"),
    ("[solver]\nmethod = \"report\"\n[solver.error_per_second]\nvelocity_fps = 0", "sweep.toml:18: solver.error_per_second.velocity_fps = 0: expected 0 < value ≤ 1e9"),
    ("[solver]\nfriction_profile = \"D\"", r#"sweep.toml:16: solver.friction_profile = "D": expected "A" or "B" or "C""#),
    ("[solver]\nrules = \"lunar\"", r#"sweep.toml:16: solver.rules = "lunar": expected "1966" or "physical""#),
    ("[solver]\nmethod = \"euler\"", r#"sweep.toml:16: solver.method = "euler": expected "located" or "report" or "rk4" or "trapezoidal" or "milne""#),
    ("[solver]\ncontact_rule = \"edge\"", r#"sweep.toml:16: solver.contact_rule = "edge": expected "pivot" or "face""#),
    ("[solver]\nrest_rule = \"still\"", r#"sweep.toml:16: solver.rest_rule = "still": expected "limits" or "energy""#),
    ("[solver]\ntoppling_rule = \"one\"", r#"sweep.toml:16: solver.toppling_rule = "one": expected "critical-feet" or "hull""#),
    ("[solver]\nmethod = \"rk4\"\n[scene.thrust]\ntime_s = [0]\nforce_lb = [3]", r#"sweep.toml:17: scene.thrust = a table: expected no thrust: only the method "located" knows it"#),
];

/// Cases of a scene file.
#[rustfmt::skip]
const CASES: [(&str, &str); 6] = [
    ("[[case]]\nname = \"a\"\n[[case]]\nname = \"a\"", r#"scene.toml:11: case[2].name = "a": expected letters, digits, - and _ in quotes, not the name of a case before"#),
    ("[[case]]\nsearch.from_fps = 3", "scene.toml:9: case[1].search.from_fps = 3: unknown key of a case"),
    ("[[case]]\nvehicle = \"none.toml\"", r#"scene.toml:9: case[1].vehicle = "none.toml": there is no file none.toml: expected the path of a vehicle file, relative to this file"#),
    ("[[case]]\nvehicle.name = \"b\"", r#"scene.toml:9: case[1].vehicle.name = "b": unknown key of a case"#),
    ("[[case]]\nslope_deg = \"steep\"", r#"scene.toml:9: case[1].slope_deg = "steep": expected a number"#),
    ("[[case]]\nsolver.error_scale = 2", "scene.toml:9: case 1: solver.error_scale = 2: expected only with method report or milne; the method is located"),
];

/// A column and its cell in a table of cases, behind those without default.
#[rustfmt::skip]
const COLUMNS: [(&str, &str, &str); 10] = [
    ("search.from_fps", "3", "cases.csv:1: column search.from_fps: no such column"),
    ("vehicle", "none.toml", "cases.csv:2: row 1: cannot be read: vehicle = none.toml: there is no file none.toml: expected the path of a vehicle file, relative to this file"),
    ("friction", "1", "cases.csv:1: column friction is there twice: expected once"),
    ("slope_rad", "1", "cases.csv:1: columns slope_deg and slope_rad: expected one spelling of a quantity"),
    ("vehicle.strut.kind", "damper", "cases.csv:1: column vehicle.strut.kind: no such column"),
    ("solver.method", "euler", "cases.csv:2: row 1: solver.method = euler: expected one of located, report, rk4, trapezoidal, milne"),
    ("solver.error_scale", "2", "cases.csv:2: row 1: at solver.error_scale = 2: solver.error_scale = 2: expected only with method report or milne; the method is located"),
    ("tip_deg", "2", "cases.csv:2: row 1: tip_azimuth_deg is missing: expected -36000 ≤ value ≤ 36000 deg, tip form: azimuth Γ"),
    ("vehicle.legs[4].strut.preload_lb", "2", "cases.csv:2: row 1: at vehicle.legs[4].strut.preload_lb = 2: vehicle.legs[4].strut.preload_lb: the vehicle has 3 legs"),
    ("block_friction", "1001", "cases.csv:2: row 1: block_friction = 1001: expected 0 ≤ value ≤ 1000"),
];

const SCENE: &str = "vehicle = \"surveyor.toml\"\n[scene]\nvertical_velocity_fps = 14\nhorizontal_velocity_fps = 11.25\n\
                     cross_slope_deg = 180\nslope_deg = 15\nfriction = 1.0\n";
const HEADING: &str =
    "vertical_velocity_fps,horizontal_velocity_fps,cross_slope_deg,slope_deg,friction";

/// A text that has `right` with `wrong` in its place.
fn with(text: &str, right: &str, wrong: &str) -> String {
    assert!(text.contains(right), "{right}");
    text.replacen(right, wrong, 1)
}

/// Runs the sweep of the bench with these files: refused, and nothing is written.
fn refuse_sweep(vehicle: &str, sweep: &str, message: &str) {
    let bench = Bench::new();
    bench.write("surveyor.toml", vehicle);
    bench.write("sweep.toml", sweep);
    bench.run(&["sweep", "sweep.toml"]).refused(&[message]);
    assert_eq!(bench.list("results"), [""; 0], "{message}");
}

#[test]
fn vehicle_files_are_refused() {
    for (right, wrong, message) in VEHICLES {
        refuse_sweep(&with(SURVEYOR, right, wrong), SWEEP, message);
    }
    let (before, rest) = SURVEYOR.split_once("structural_stiffness").unwrap();
    let (_, after) = rest.split_once("[footpad]\n").unwrap();
    for (keys, message) in CARTRIDGES {
        let strut =
            "kind = \"honeycomb\"\nfriction_fraction = 0.05\nunloading_stiffness_lb_per_ft = 1e5";
        let vehicle = format!("{before}{strut}\n{keys}\n[footpad]\n{after}");
        refuse_sweep(&vehicle, SWEEP, message);
    }
    for (right, wrong, message) in THREE_STRUTS {
        refuse_sweep(&with(APOLLO_LIKE, right, wrong), SWEEP, message);
    }
}

#[test]
fn choices_are_refused_beside_legs_of_three_struts() {
    for (keys, message) in BESIDE_THREE_STRUTS {
        refuse_sweep(APOLLO_LIKE, &format!("{SWEEP}[solver]\n{keys}\n"), message);
    }
    let axis = r#"solver.toppling_rule = ["critical-feet"]"#;
    let message = r#"sweep.toml:9: axes.solver.toppling_rule = ["critical-feet"]: includes "critical-feet": expected "hull": legs of three struts"#;
    refuse_sweep(APOLLO_LIKE, &with(SWEEP, ROLL, axis), message);

    let bench = Bench::new();
    bench.write("surveyor.toml", APOLLO_LIKE);
    let said = r#"solver.method = "rk4": expected "located": legs of three struts"#;
    let land = [&BASELINE[..], &["--method", "rk4"]].concat();
    bench.run(&land).refused(&[said]);
    let land = [&BASELINE[..], &["--set", "solver.crush_rule=pivot-rate"]].concat();
    let said = r#"solver.crush_rule=pivot-rate: expected "section": legs of three struts"#;
    bench.run(&land).refused(&[said]);
    bench.write(
        "scene.toml",
        &format!("{SCENE}[[case]]\nsolver.method = \"rk4\"\n"),
    );
    let said = r#"scene.toml:9: case 1: solver.method = "rk4": expected "located""#;
    bench
        .run(&["land", "scene.toml", "--out", "out"])
        .refused(&[said]);
}

#[test]
fn sweep_files_are_refused() {
    for (right, wrong, message) in SWEEPS {
        refuse_sweep(SURVEYOR, &with(SWEEP, right, wrong), message);
    }
    for (rows, place) in [(&SCENES[..], FRICTION), (&BEHIND, TOLERANCE)] {
        for (keys, message) in rows {
            let sweep = with(SWEEP, place, &format!("{place}\n{keys}"));
            refuse_sweep(SURVEYOR, &sweep, message);
        }
    }
}

#[test]
fn axes_and_samples_are_refused() {
    let refuse = |axes: &str, message| refuse_sweep(SURVEYOR, &with(SWEEP, ROLL, axes), message);
    for (axis, message) in AXES {
        refuse(axis, message);
    }
    for (axis, message) in DRAWN {
        let sample = "[sample]\ndesign = \"monte-carlo\"\ncount = 9\nseed = 1";
        refuse(&format!("{axis}\n{sample}"), message);
    }
    for (sample, message) in SAMPLES {
        let axis = "roll_deg = { from = -1, to = 1 }";
        refuse(&format!("{axis}\n[sample]\n{sample}"), message);
    }
}

#[test]
fn cases_are_refused() {
    let bench = Bench::new();
    for (cases, message) in CASES {
        bench.write("scene.toml", &format!("{SCENE}{cases}\n"));
        let land = ["land", "scene.toml", "--out", "out"];
        bench.run(&land).refused(&[message]);
    }
    for (column, cell, message) in COLUMNS {
        let table = format!("{HEADING},{column}\n14,9,180,15,1,{cell}\n");
        bench.write("cases.csv", &table);
        let land = [&LAND_CASES[..], &["out"]].concat();
        bench.run(&land).refused(&[message]);
    }
    assert!(!bench.path("out").exists());
}
