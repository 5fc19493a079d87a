//! The catalogue: every number of a lander and of a touchdown.
//!
//! A number is one entry. Adding one means an entry here, a field in [`crate::parts`] or in the conditions of a scene, and its
//! use; its key, its checks, its unit in SI, axes and `--set`, sliders and its row in `docs/reference.md` follow.

use super::quantity::{Field, Quantity, Range, Usual};
use crate::parts::{
    Block, Body, Damper, Footpad, Honeycomb, Inertia, LegDesign, Linkage, PadEdge, Strut,
};
use crate::three_struts::{BallFootpad, Foot, LegStrut, Telescope, ThreeStrutDesign};

use Usual::{Around, Beside, Between, Times};

const POSITIVE: Range = Range::POSITIVE;
const NOT_NEGATIVE: Range = Range::NOT_NEGATIVE;
const ANY: Range = Range::ANY;
/// A hundred turns either way: precision is lost beyond it.
const TURNS: Range = Range::closed(-36_000.0, 36_000.0);
/// Angles short of a right angle.
const ACUTE: Range = Range::closed(-90.0, 90.0).above_lower().below_upper();

/// A number of a part, at this place in its struct.
macro_rules! field {
    ($($place:ident).+: $($quantity:tt)+) => {
        $crate::quantity::Field {
            quantity: $crate::quantity::Quantity::$($quantity)+,
            read: |part| part.$($place).+,
            write: |part, value| part.$($place).+ = value,
        }
    };
    ([$index:literal]: $($quantity:tt)+) => {
        $crate::quantity::Field {
            quantity: $crate::quantity::Quantity::$($quantity)+,
            read: |part| part[$index],
            write: |part, value| part[$index] = value,
        }
    };
}
pub(crate) use field;

/// Numbers by name, and a list of them all.
macro_rules! quantities {
    ($(#[$doc:meta])* $list:ident: $($name:ident = $function:ident($($argument:tt)*)$(.$with:ident($($value:tt)*))*;)+) => {
        $(
            #[allow(missing_docs)]
            pub const $name: Quantity = Quantity::$function($($argument)*)$(.$with($($value)*))*;
        )+
        $(#[$doc])*
        pub const $list: &[Quantity] = &[$($name),+];
    };
}

/// The body of a lander.
pub const BODY: [Field<Body>; 3] = [
    field!(mass: new("mass_slug", POSITIVE, "mass M")),
    field!(gravity: new("gravity_fps2", POSITIVE, "acceleration of gravity g; 5.31 on the Moon")),
    field!(center_of_gravity_height: new(
        "center_of_gravity_height_ft", ANY,
        "height ΔCG of the CG above the plane of the lower hardpoints; may be negative")
        .also("the CG above the footpads")
        .usually(Around(1.0))),
];

/// Offset of the CG from the centreline, along x and y of vehicle axes.
pub const OFFSET: [Field<[f64; 2]>; 2] = [
    field!([0]: new(
        "center_of_gravity_offset_x_ft", ANY,
        "where the CG is off the centreline, along x of vehicle axes (toward azimuth 90 deg)")
        .also("the CG over the polygon of the extended feet")
        .default(0.0)
        .usually(Between(-1.0, 1.0))),
    field!([1]: new("center_of_gravity_offset_y_ft", ANY, "the same along y (toward azimuth 0)")
        .also("the CG over the polygon of the extended feet")
        .default(0.0)
        .usually(Between(-1.0, 1.0))),
];

/// Moments and products of inertia.
pub const INERTIA: [Field<Inertia>; 6] = [
    field!(xx: new("xx", POSITIVE, "moment of inertia about x")),
    field!(yy: new("yy", POSITIVE, "moment of inertia about y (toward azimuth 0)")),
    field!(zz: new("zz", POSITIVE, "moment of inertia about z (the centreline)")),
    field!(xy: new(
        "xy", ANY, "product of inertia, with the sign of the report: the matrix holds −xy (59)")
        .usually(Around(20.0))),
    field!(xz: new("xz", ANY, "product of inertia, likewise").usually(Around(20.0))),
    field!(yz: new("yz", ANY, "product of inertia, likewise").usually(Around(20.0))),
];

/// The place of a leg.
pub const LEG: [Field<LegDesign>; 1] = [field!(azimuth: new(
    "azimuth_deg", TURNS, "azimuth θ_j about the centreline, from y toward x")
    .also("1 deg or more, and less than 180 deg, from the next leg")
    .usually(Beside(20.0)))];

/// The lower link and its hardpoints.
pub const LINKAGE: [Field<Linkage>; 5] = [
    field!(lower_hardpoint_radius: new(
        "lower_hardpoint_radius_ft", POSITIVE, "distance l_p of the lower hardpoint from the centreline")
        .usually(Times(0.75, 1.25))),
    field!(lower_link_length: new(
        "lower_link_length_ft", POSITIVE, "length l_L of the lower link, hardpoint to footpad pivot")
        .usually(Times(0.75, 1.25))),
    field!(hardpoint_distance: new(
        "hardpoint_distance_ft", POSITIVE, "distance l_A between lower and upper hardpoint")
        .usually(Times(0.9, 1.1))),
    field!(hardpoint_angle: new(
        "hardpoint_angle_deg", Range::closed(0.0, 90.0),
        "angle β between the line joining the hardpoints and the centreline")
        .usually(Between(0.0, 90.0))),
    field!(inertia: new(
        "inertia_slug_ft2", POSITIVE, "moment of inertia I_γ of the lower link about the lower hardpoint")),
];

/// A strut of any kind.
pub const STRUT: [Field<Strut>; 3] = [
    field!(extended_length: new("extended_length_ft", POSITIVE, "length l_D0 of the extended strut")
        .also("such that the linkage can span it with the lower link between −60 and 60 deg")
        .usually(Times(0.95, 1.05))),
    field!(minimum_length: new(
        "minimum_length_ft", POSITIVE, "length l_Dmin at which the strut bottoms, which ends the landing")
        .also("below `extended_length_ft`")
        .usually(Times(0.95, 1.05))),
    field!(friction_fraction: new(
        "friction_fraction", Range::closed(0.0, 1.0).below_upper(),
        "friction ν as a fraction of the load of spring or cartridge, against the motion")
        .usually(Between(0.0, 0.9))),
];

/// The shock absorber of a strut of kind `"damper"`.
pub const DAMPER: [Field<Damper>; 6] = [
    field!(structural_stiffness: new(
        "structural_stiffness_lb_per_ft", POSITIVE, "stiffness K_s below the preload")),
    field!(preload: new("preload_lb", POSITIVE, "preload F_p of the spring")),
    field!(spring_constant: new(
        "spring_constant_lb_per_ft", NOT_NEGATIVE, "spring constant K_D above the preload")),
    field!(compression_damping: new(
        "compression_damping", NOT_NEGATIVE, "compression damping R_c, times the square of the stroke rate")),
    field!(rebound_damping: new("rebound_damping", NOT_NEGATIVE, "rebound damping R_R, likewise")),
    field!(rebound_growth: new(
        "rebound_growth_per_ft", NOT_NEGATIVE, "growth SRL of the rebound damping with the stroke")),
];

/// The cartridge of a strut of kind `"honeycomb"`.
pub const HONEYCOMB: [Field<Honeycomb>; 1] = [field!(unloading_stiffness: new(
    "unloading_stiffness_lb_per_ft", POSITIVE,
    "stiffness at which a cartridge takes up load, unloads and reloads"))];

/// The footpad.
pub const FOOTPAD: [Field<Footpad>; 7] = [
    field!(diameter: new("diameter_ft", POSITIVE, "diameter d_f")),
    field!(height: new("height_ft", POSITIVE, "uncrushed height h_f0 below the pivot")),
    field!(crush_pressure: new(
        "crush_pressure_psf", POSITIVE, "crush pressure C_f, times the profile")),
    field!(inertia: new("inertia_slug_ft2", POSITIVE, "moment of inertia I_α about the pivot")),
    field!(hinge_damping: new(
        "hinge_damping_ftlb_s", NOT_NEGATIVE,
        "torque against the speed at which the pad turns about the pivot, per rad/s; only the contact rule `\"face\"` knows it")
        .default(0.0)),
    field!(minimum_angle: new("minimum_angle_deg", ACUTE, "inner stop of the pad angle α")
        .also("below the angle of the extended link")
        .usually(Between(-45.0, 0.0))),
    field!(maximum_angle: new("maximum_angle_deg", ACUTE, "outer stop of the pad angle α")
        .also("above the angle of the extended link")
        .usually(Between(45.0, 85.0))),
];

/// Load capacity of a footpad that has turned over: both numbers or none.
pub const EDGE: [Field<PadEdge>; 2] = [
    field!(angle: new(
        "edge_angle_deg", Range::closed(30.0, 84.0).below_upper(),
        "inclination beyond which the pad is on its edge; without, a loaded pad inclined by more than 65 deg ends the landing as a failure")
        .by_default("none")
        .usually(Between(30.0, 80.0))),
    field!(load: new(
        "edge_load_lb", POSITIVE,
        "load under which its lowest rim crushes there (187 lb beyond 65 deg in the program of 1966); both keys or none")
        .by_default("none")),
];

/// The body block.
pub const BLOCK: [Field<Block>; 4] = [
    field!(radius: new("radius_ft", POSITIVE, "distance l_c of the block from the centreline")),
    field!(height: new(
        "height_ft", ANY, "uncrushed height h_B0 below the plane of the lower hardpoints")
        .usually(Around(1.0))),
    field!(diameter: new("diameter_ft", POSITIVE, "diameter d_B")),
    field!(crush_pressure: new(
        "crush_pressure_psf", POSITIVE, "crush pressure C_B, times the profile")),
];

/// The place of a leg of three struts.
pub const THREE_STRUT_LEG: [Field<ThreeStrutDesign>; 1] = [Field {
    quantity: LEG[0].quantity,
    read: |leg| leg.azimuth,
    write: |leg, value| leg.azimuth = value,
}];

/// The foot of a leg of three struts.
pub const FOOT: [Field<Foot>; 3] = [
    field!(radius: new(
        "foot_radius_ft", POSITIVE, "distance of the foot at rest from the centreline; `\"tripod\"` and `\"cantilever\"` only")
        .usually(Times(0.75, 1.25))),
    field!(depth: new(
        "foot_depth_ft", POSITIVE, "its depth below the plane of the lower hardpoints, likewise")
        .usually(Times(0.75, 1.25))),
    field!(mass: new(
        "foot_mass_slug", POSITIVE, "mass of the foot, which `mass_slug` leaves out, likewise")),
];

/// The primary strut of a leg of kind `"cantilever"`.
pub const TELESCOPE: [Field<Telescope>; 4] = [
    field!(collar: new(
        "collar_ft", POSITIVE,
        "distance along the primary strut from its hardpoint to where the secondary struts end; `\"cantilever\"` only")
        .also("less than the primary strut is long when it bottoms")
        .usually(Times(0.75, 1.25))),
    field!(bearing_friction: new(
        "bearing_friction", FRICTION,
        "friction coefficient of the bearings on which the piston of the primary strut slides in its cylinder; `\"cantilever\"` only")
        .default(0.0)
        .usually(Between(0.0, 0.5))),
    field!(bearing_overhang: new(
        "bearing_overhang_ft", NOT_NEGATIVE,
        "distance at rest from the lower bearing, at the end of the cylinder, to the foot, likewise")
        .also("where there is `bearing_friction` more than the compression stroke, and the bearing beyond the collar")
        .default(0.0)
        .usually(Times(0.75, 1.25))),
    field!(bearing_overlap: new(
        "bearing_overlap_ft", NOT_NEGATIVE,
        "distance at rest between the bearings, likewise")
        .also("where there is `bearing_friction` more than the tension stroke, and room for the piston in the cylinder when the strut bottoms")
        .default(0.0)
        .usually(Times(0.75, 1.25))),
];

/// A strut of a leg of three struts.
pub const LEG_STRUT: [Field<LegStrut>; 7] = [
    field!(hardpoint_radius: new(
        "hardpoint_radius_ft", NOT_NEGATIVE, "distance of the hardpoint from the centreline, in the plane of the leg")
        .usually(Times(0.75, 1.25))),
    field!(hardpoint_height: new(
        "hardpoint_height_ft", ANY, "height of the hardpoint over the plane of the lower hardpoints")
        .usually(Around(1.0))),
    field!(stiffness: new(
        "stiffness_lb_per_ft", POSITIVE, "stiffness at which the strut takes up load, unloads and reloads")),
    field!(damping: new(
        "damping_lb_s_per_ft", NOT_NEGATIVE, "force against the speed of the stroke, per speed")),
    field!(square_damping: new(
        "square_damping", NOT_NEGATIVE, "force against the speed of the stroke, per square of the speed")
        .default(0.0)),
    field!(compression_stroke: new(
        "compression_stroke_ft", POSITIVE, "shortening at which the strut bottoms, which ends the landing")
        .also("less than the strut is long at rest")),
    field!(tension_stroke: new(
        "tension_stroke_ft", POSITIVE, "lengthening at which the strut is drawn out, which ends the landing")),
];

/// Distance of the secondary struts' hardpoints from the plane of the leg.
pub const SPREAD: Quantity = Quantity::new(
    "hardpoint_spread_ft",
    POSITIVE,
    "distance of each hardpoint from the plane of the leg; secondary struts only",
)
.usually(Times(0.75, 1.25));

/// The footpad of a leg of three struts.
pub const BALL_FOOTPAD: [Field<BallFootpad>; 3] = [
    Field {
        quantity: FOOTPAD[0].quantity,
        read: |pad| pad.diameter,
        write: |pad, value| pad.diameter = value,
    },
    Field {
        quantity: FOOTPAD[1].quantity,
        read: |pad| pad.height,
        write: |pad, value| pad.height = value,
    },
    Field {
        quantity: FOOTPAD[2].quantity,
        read: |pad| pad.crush_pressure,
        write: |pad, value| pad.crush_pressure = value,
    },
];

/// Factor on a table of a strut, a footpad or a block.
pub const TABLE_SCALE: Quantity =
    Quantity::new("scale", POSITIVE, "factor on the table").default(1.0);

const ATTITUDE: &str = "attitude";
const GROUND: &str = "ground";
const SPEED: Range = Range::closed(0.0, 10_000.0);
const FRICTION: Range = Range::closed(0.0, 1000.0);
const LEVEL: Usual = Between(-45.0, 45.0);
const HALF_TURNS: Usual = Between(-180.0, 180.0);
const RATES: Usual = Between(-60.0, 60.0);

quantities! {
    /// Touchdown conditions of the whole vehicle.
    CONDITIONS:
    VERTICAL_VELOCITY = new("vertical_velocity_fps", SPEED, "downward velocity V_V of the CG")
        .titled("Vertical velocity V_V")
        .usually(Between(0.0, 30.0));
    HORIZONTAL_VELOCITY = new(
        "horizontal_velocity_fps", SPEED, "horizontal velocity V_H of the CG")
        .titled("Horizontal velocity V_H")
        .usually(Between(0.0, 30.0));
    CROSS_SLOPE = new(
        "cross_slope_deg", TURNS, "direction λ of V_H: 180 is straight downhill, 0 uphill")
        .titled("Cross-slope angle λ")
        .usually(HALF_TURNS);
    SLOPE = new("slope_deg", ACUTE, "slope θ_s of the surface")
        .titled("Slope θ")
        .of(GROUND)
        .usually(Between(-30.0, 45.0));
    PAD_FRICTION = new(
        "friction", FRICTION, "nominal friction coefficient μ0 between footpads and surface")
        .titled("Friction coefficient μ")
        .of(GROUND)
        .usually(Between(0.0, 2.0));
    BLOCK_FRICTION = new("block_friction", FRICTION, "the same between body blocks and surface")
        .titled("Friction coefficient of the blocks")
        .of(GROUND)
        .by_default("`friction`")
        .usually(Between(0.0, 2.0));
    STATIC_FRICTION_RATIO = new(
        "static_friction_ratio", Range::closed(1.0, 100.0),
        "greatest friction near rest, of footpads and blocks, over sliding friction; verdicts count on it")
        .titled("Static over sliding friction")
        .of(GROUND)
        .by_default("1.2, on which no verdict counts")
        .usually(Between(1.0, 5.0));
    PITCH = new("pitch_deg", TURNS, "pitch Ψ, about the horizontal X axis across the slope")
        .titled("Pitch angle Ψ")
        .of(ATTITUDE)
        .default(0.0)
        .usually(LEVEL);
    YAW = new("yaw_deg", TURNS, "yaw Φ, about the once-turned y axis")
        .titled("Yaw angle Φ")
        .of(ATTITUDE).default(0.0).usually(LEVEL);
    ROLL = new("roll_deg", TURNS, "roll Ξ, about the centreline")
        .titled("Roll angle Ξ")
        .of(ATTITUDE).default(0.0).usually(HALF_TURNS);
    TIP = new(
        "tip_deg", Range::closed(0.0, 180.0), "tip form: angle ν between centreline and vertical")
        .titled("Tip angle ν")
        .of(ATTITUDE)
        .by_default("the other form")
        .usually(Between(0.0, 45.0));
    TIP_AZIMUTH = new(
        "tip_azimuth_deg", TURNS, "tip form: azimuth Γ of the axis about which the vehicle is tipped")
        .titled("Tip azimuth Γ")
        .of(ATTITUDE)
        .by_default("the other form")
        .usually(HALF_TURNS);
    NOMINAL_ROLL = new(
        "nominal_roll_deg", TURNS, "tip form: roll K about the centreline before tipping")
        .titled("Nominal roll angle K")
        .of(ATTITUDE)
        .default(0.0)
        .usually(HALF_TURNS);
    ANGULAR_VELOCITY_X = new(
        "angular_velocity_x_dps", TURNS, "angular velocity about the vehicle's x axis")
        .titled("Angular velocity about x")
        .of(ATTITUDE)
        .default(0.0)
        .usually(RATES);
    ANGULAR_VELOCITY_Y = new("angular_velocity_y_dps", TURNS, "the same about y")
        .titled("Angular velocity about y")
        .of(ATTITUDE).default(0.0).usually(RATES);
    ANGULAR_VELOCITY_Z = new("angular_velocity_z_dps", TURNS, "the same about z")
        .titled("Angular velocity about z")
        .of(ATTITUDE).default(0.0).usually(RATES);
    GRAVITY = new("gravity_fps2", POSITIVE, "acceleration of gravity where the vehicle lands")
        .of(GROUND)
        .by_default("that of the vehicle")
        .usually(Between(0.5, 35.0));
}

/// Thrust at a knot of its table.
pub(crate) const THRUST_FORCE: Quantity =
    Quantity::new("force_lb", NOT_NEGATIVE, "thrust at each knot");
const OFF_CENTRE: Range = Range::closed(-1000.0, 1000.0);

quantities! {
    /// Numbers of the thrust after first contact.
    THRUST:
    THRUST_SCALE = new("scale", NOT_NEGATIVE, "factor on all forces").default(1.0).usually(Between(0.0, 2.0));
    THRUST_OFFSET_X = new(
        "offset_x_ft", OFF_CENTRE, "where the line of action passes the centreline, along x of vehicle axes")
        .default(0.0)
        .usually(Between(-1.0, 1.0));
    THRUST_OFFSET_Y = new("offset_y_ft", OFF_CENTRE, "the same along y").default(0.0).usually(Between(-1.0, 1.0));
}

quantities! {
    /// Numbers of the soil; rock without them.
    SOIL:
    BEARING_STRENGTH = new(
        "bearing_strength_psf", POSITIVE, "pressure σ₀ under which a plate sinks by `bearing_depth_ft`")
        .usually(Times(0.25, 4.0));
    BEARING_DEPTH = new(
        "bearing_depth_ft", Range::closed(1e-4, 100.0), "sinkage z₀ of a plate under that pressure");
    BEARING_EXPONENT = new(
        "bearing_exponent", Range::closed(0.5, 2.0), "exponent n of the pressure σ₀ (z/z₀)ⁿ at other sinkages z")
        .default(1.0)
        .usually(Between(0.5, 2.0));
    REBOUND = new(
        "rebound", Range::closed(1e-4, 1.0),
        "part of z₀ by which a plate rises when it is unloaded from σ₀: 0 would be no elasticity, 1 no set")
        .also("no sinking steeper than unloading")
        .usually(Between(0.001, 0.1));
    INERTIAL_DRAG = new(
        "inertial_drag_slug_ft3", Range::closed(0.0, 1000.0),
        "inertial drag α: soil that is pushed aside resists sinking at a rate ż by α ż², about its density times ż²")
        .default(0.0)
        .usually(Between(0.0, 6.0));
}

const HEIGHT: Range = Range::closed(-1000.0, 1000.0);
const TILT: Range = Range::closed(-60.0, 60.0);
const TILTS: Usual = Between(-30.0, 30.0);
const STEEPEST: &str = "slope and tilt together between −90 and 90";

quantities! {
    /// The ground under a leg: under its footpad, then under its block, and its soil.
    FOOTING:
    PAD_GROUND_HEIGHT = new(
        "height_ft", HEIGHT, "height over the surface, along its normal: a rock is positive, a crater negative")
        .default(0.0)
        .usually(Between(-2.0, 2.0));
    PAD_TILT_ALONG = new("tilt_along_deg", TILT, "added to the slope: steeper when positive")
        .also(STEEPEST)
        .default(0.0)
        .usually(TILTS);
    PAD_TILT_ACROSS = new("tilt_across_deg", TILT, "rising toward X of the ground axes when positive")
        .default(0.0)
        .usually(TILTS);
    BLOCK_GROUND_HEIGHT = new("block_height_ft", HEIGHT, "the same under the block")
        .by_default("`height_ft`")
        .usually(Between(-2.0, 2.0));
    BLOCK_TILT_ALONG = new("block_tilt_along_deg", TILT, "the same under the block")
        .also(STEEPEST)
        .by_default("`tilt_along_deg`")
        .usually(TILTS);
    BLOCK_TILT_ACROSS = new("block_tilt_across_deg", TILT, "the same under the block")
        .by_default("`tilt_across_deg`")
        .usually(TILTS);
    BEARING_FACTOR = new(
        "bearing_factor", Range::closed(0.01, 100.0), "factor on the bearing strength of the soil under the leg; 1 on rock")
        .default(1.0)
        .usually(Between(0.5, 2.0));
}

const INTERVALS: Range = Range::closed(1e-9, 1.0);

quantities! {
    /// Numbers of the computation of a landing.
    SOLVER:
    TOLERANCE = new(
        "tolerance", Range::closed(1e-12, 1e-2), "relative error per step; method `\"located\"` only")
        .by_default("3e-5 in sweeps, 1e-6 in scene files");
    TIME_LIMIT = new(
        "time_limit_s", Range::closed(0.0, 10_000.0).above_lower(),
        "a landing without an outcome ends here as `time-expired`")
        .default(40.0)
        .usually(Between(1.0, 60.0));
    ERROR_SCALE = new(
        "error_scale", POSITIVE, "factor on all error limits; `\"report\"` and `\"milne\"` only")
        .default(1.0);
    FIRST_INTERVAL = new(
        "first_interval_s", INTERVALS, "first interval; `\"report\"` and `\"milne\"` only")
        .default(0.0005);
    LEAST_INTERVAL = new(
        "least_interval_s", INTERVALS, "interval that is not cut further; `\"report\"` and `\"milne\"` only")
        .default(1e-6);
    INTERVAL = new(
        "interval_s", Range::closed(1e-6, 1.0), "the fixed interval; `\"rk4\"` and `\"trapezoidal\"` only")
        .default(0.002);
}
