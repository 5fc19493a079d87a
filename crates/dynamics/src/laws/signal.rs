//! Signals watched on a leg.

/// Declares the signals and the list of them all.
macro_rules! signals {
    ($(#[$doc:meta])* $name:ident { $($(#[$of:meta])* $signal:ident,)+ }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum $name { $($(#[$of])* $signal,)+ }

        impl $name {
            /// Every signal, in storage order.
            pub const ALL: [Self; Self::COUNT] = [$(Self::$signal),+];
            /// Number of signals of a leg.
            pub const COUNT: usize = [$(Self::$signal),+].len();
        }
    };
}

signals! {
    /// A signal watched on a leg. Most have a range over which the active pieces hold. First come those whose rates are
    /// signals too, then those rates in the same order.
    Signal {
        /// I of the outboard pad section, ft.
        OuterInterference,
        /// I of the inboard pad section, ft.
        InnerInterference,
        /// I of the block, ft.
        BlockInterference,
        /// Strut stroke δ, ft.
        Stroke,
        /// dI/dt of the outboard pad section, ft/s.
        OuterRate,
        /// dI/dt of the inboard pad section, ft/s.
        InnerRate,
        /// dI/dt of the block, ft/s.
        BlockRate,
        /// dδ/dt, ft/s.
        StrokeRate,
        /// Rate of the pad pivot into the ground, ft/s.
        PivotRate,
        /// Rate of the crushed block centre into the ground, ft/s.
        BlockCentreRate,
        /// S² of the pad, ft²/s².
        PadSliding,
        /// S² of the block, ft²/s².
        BlockSliding,
        /// Link rate γ̇, rad/s.
        LinkRate,
        /// Torque of the surface on the link, ft·lb.
        LinkTorque,
        /// Turn of the pad, rad: α, unless the pad presses on a stop.
        PadTurn,
        /// Pad rate state α̇, rad/s.
        PadRate,
        /// Drive of the hinge: its speed before the clip, rad/s; under [`crate::rules::ContactRule::Face`] the torque that
        /// turns the pad outward against its link, ft·lb.
        HingeDrive,
        /// cos ξ of the pad.
        PadInclination,
        /// Strut force F, lb: for the record, without a range.
        StrutForce,
        /// Strut lever dl_D/dγ (12), ft: for the record, as are the next.
        StrutLever,
        /// X of the footpad pivot (7) relative to the CG, ground axes, ft.
        FootX,
        /// Y of the same, ft.
        FootY,
        /// Z of the same, ft.
        FootZ,
        /// Depth of the lower hardpoint (6) below the ground of the block (negative above), ft.
        HardpointDepth,
    }
}

impl Signal {
    /// Number of leading signals with ranges.
    pub const RANGED: usize = Self::PadInclination as usize + 1;
    /// Number of leading signals with rates among the signals, that many places on.
    pub const RATED: usize = Self::Stroke as usize + 1;

    /// Panics, at compile time, unless these are the first signals in storage order.
    pub(crate) const fn assert_in_order(signals: &[Self]) {
        let mut place = 0;
        while place < signals.len() {
            assert!(
                signals[place] as usize == place,
                "signals are in storage order"
            );
            place += 1;
        }
    }
}

/// The values of the first signals, each with its name.
macro_rules! by_signal {
    ($($signal:ident: $value:expr),+ $(,)?) => {{
        const { $crate::signal::Signal::assert_in_order(&[$($crate::signal::Signal::$signal),+]) };
        [$($value),+]
    }};
}
pub(crate) use by_signal;

/// The signals of one leg, indexed by [`Signal`].
pub type LegSignals<S> = [S; Signal::COUNT];
