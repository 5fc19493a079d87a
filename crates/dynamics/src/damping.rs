//! What friction and dampers do to the velocities, to first order: the damping matrix.
//!
//! A stuck foot is viscous (model chapter 5's friction below 0.05 ft/s), with rates of thousands
//! per second; so are struts near rest and struts that stroke fast. All of it acts on nine
//! velocities for three legs, through two directions a contact and one a strut. A method that
//! takes this part implicitly is free of its stability limit.
//!
//! The matrix has the shape of an arrow: legs touch the body but not each other, so eliminating
//! them leaves six equations.

use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

use crate::quad::abreast;
use crate::scalar::Real;
use crate::state::State;

/// A change of the velocities, or a force on them: translation (ground axes) and rotation (vehicle
/// axes) of the body, then each lower link.
#[derive(Debug, Clone, Copy)]
pub struct Velocities<S, const LEGS: usize> {
    /// Translation in ground axes (ft/s), then rotation in vehicle axes (rad/s).
    pub body: Vector6<S>,
    /// Rates γ̇ of the links, rad/s.
    pub links: [S; LEGS],
}

impl<S: Real, const LEGS: usize> Velocities<S, LEGS> {
    /// The velocities of a state.
    #[inline(always)]
    pub fn of(state: &State<S, LEGS>) -> Self {
        let (velocity, rate) = state.body_velocities();
        Self {
            body: Vector6::new(
                velocity[0],
                velocity[1],
                velocity[2],
                rate[0],
                rate[1],
                rate[2],
            ),
            links: state.link_rates(),
        }
    }

    /// Adds these velocities to those of a state.
    #[inline(always)]
    pub fn add_to(&self, state: &mut State<S, LEGS>) {
        let b = &self.body;
        state.add_velocities(&[b[0], b[1], b[2], b[3], b[4], b[5]], &self.links);
    }

    /// self + factor · other.
    #[inline(always)]
    pub fn plus(&self, factor: S, other: &Self) -> Self {
        Self {
            body: self.body + other.body * factor,
            links: std::array::from_fn(|j| self.links[j] + factor * other.links[j]),
        }
    }

    /// factor · self.
    #[inline(always)]
    pub fn times(&self, factor: S) -> Self {
        Self {
            body: self.body * factor,
            links: self.links.map(|link| link * factor),
        }
    }

    /// All zero.
    #[inline(always)]
    pub fn zero() -> Self {
        Self {
            body: Vector6::zeros(),
            links: [S::zero(); LEGS],
        }
    }
}

/// Inertia of the velocities: mass, moments of inertia of body and links.
#[derive(Debug, Clone, Copy)]
pub struct Inertia<S, const LEGS: usize> {
    /// Mass, slug.
    pub mass: S,
    /// Inertia about the CG, slug·ft².
    pub body: Matrix3<S>,
    /// Inertia of each lower link about its hardpoint, slug·ft².
    pub links: [S; LEGS],
}

/// What one leg does to the velocities of the body and to its own: its share of the damping matrix.
#[derive(Debug, Clone, Copy)]
pub struct LegDamping<S> {
    /// Lower triangle, column by column.
    body: [S; 21],
    coupling: Vector6<S>,
    link: S,
}

abreast!(LegDamping {
    body,
    coupling,
    link,
});

impl<S: Real> LegDamping<S> {
    /// No damping.
    #[inline(always)]
    pub fn none() -> Self {
        Self {
            body: [S::zero(); 21],
            coupling: Vector6::zeros(),
            link: S::zero(),
        }
    }

    /// Adds a force −k (w·v) w that acts on the body along `force` (ground axes) with `moment`
    /// (vehicle axes) and turns the link with lever `link`, ft.
    #[inline(always)]
    pub fn add(&mut self, k: S, force: &Vector3<S>, moment: &Vector3<S>, link: S) {
        let w = Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z);
        let kw = w * k;
        let mut entries = self.body.iter_mut();
        for column in 0..6 {
            for (row, entry) in (column..6).zip(&mut entries) {
                *entry += kw[row] * w[column];
            }
        }
        self.coupling += kw * link;
        self.link += k * link * link;
    }

    /// Adds `k` (ft·lb·s) to the damping of the link.
    #[inline(always)]
    pub fn add_to_link(&mut self, k: S) {
        self.link += k;
    }
}

/// The damping matrix K: forces −K v for small changes v of the velocities. Symmetric, and nowhere
/// driving: what does drive (friction falling with speed) is left out.
#[derive(Debug, Clone, Copy)]
pub struct Damping<S, const LEGS: usize> {
    body: Matrix6<S>,
    couplings: [Vector6<S>; LEGS],
    links: [S; LEGS],
}

impl<S: Real, const LEGS: usize> Damping<S, LEGS> {
    /// No damping.
    #[inline(always)]
    pub fn none() -> Self {
        Self {
            body: Matrix6::zeros(),
            couplings: [Vector6::zeros(); LEGS],
            links: [S::zero(); LEGS],
        }
    }

    /// Adds what one leg does.
    #[inline(always)]
    pub fn add(&mut self, leg: usize, what: &LegDamping<S>) {
        let mut entries = what.body.iter();
        for column in 0..6 {
            for (row, entry) in (column..6).zip(&mut entries) {
                self.body[(row, column)] += *entry;
            }
        }
        self.couplings[leg] += what.coupling;
        self.links[leg] += what.link;
    }

    /// Rate (1/s) that none of the decays exceeds: the trace of M⁻¹K.
    #[inline(always)]
    pub fn greatest_rate(&self, inertia: &Inertia<S, LEGS>) -> S {
        let k = &self.body;
        let mut rate = (k[(0, 0)] + k[(1, 1)] + k[(2, 2)]) / inertia.mass;
        for i in 0..3 {
            rate += k[(3 + i, 3 + i)] / inertia.body[(i, i)];
        }
        for j in 0..LEGS {
            rate += self.links[j] / inertia.links[j];
        }
        rate
    }

    /// Prepares to solve (M + τ K) u = M r, with τ in seconds.
    #[inline(always)]
    pub fn factor(&self, inertia: &Inertia<S, LEGS>, tau: S) -> DampedSolve<S, LEGS> {
        let mut couplings = [Vector6::zeros(); LEGS];
        let mut inverse_links = [S::zero(); LEGS];
        let mut l = self.body * tau;
        for i in 0..3 {
            l[(i, i)] += inertia.mass;
            for k in 0..=i {
                l[(3 + i, 3 + k)] += inertia.body[(i, k)];
            }
        }
        for j in 0..LEGS {
            let inverse = S::one() / (inertia.links[j] + tau * self.links[j]);
            let c = self.couplings[j] * tau;
            for column in 0..6 {
                let scaled = c[column] * inverse;
                for row in column..6 {
                    l[(row, column)] -= c[row] * scaled;
                }
            }
            couplings[j] = c;
            inverse_links[j] = inverse;
        }
        // L D Lᵀ in place: L below the diagonal, 1/D on it.
        for column in 0..6 {
            let inverse = S::one() / l[(column, column)];
            for next in column + 1..6 {
                let multiplier = l[(next, column)] * inverse;
                for row in next..6 {
                    let product = l[(row, column)] * multiplier;
                    l[(row, next)] -= product;
                }
            }
            for row in column + 1..6 {
                l[(row, column)] *= inverse;
            }
            l[(column, column)] = inverse;
        }
        DampedSolve {
            inertia: *inertia,
            factors: l,
            couplings,
            inverse_links,
        }
    }
}

/// M + τK, factored.
#[derive(Debug, Clone, Copy)]
pub struct DampedSolve<S, const LEGS: usize> {
    inertia: Inertia<S, LEGS>,
    factors: Matrix6<S>,
    couplings: [Vector6<S>; LEGS],
    inverse_links: [S; LEGS],
}

impl<S: Real, const LEGS: usize> DampedSolve<S, LEGS> {
    /// u with (M + τK) u = M r.
    #[inline(always)]
    pub fn solve(&self, r: &Velocities<S, LEGS>) -> Velocities<S, LEGS> {
        let turned = self.inertia.body * Vector3::new(r.body[3], r.body[4], r.body[5]);
        let m = self.inertia.mass;
        let mut u = Vector6::new(
            m * r.body[0],
            m * r.body[1],
            m * r.body[2],
            turned.x,
            turned.y,
            turned.z,
        );
        let pushed: [S; LEGS] = std::array::from_fn(|j| self.inertia.links[j] * r.links[j]);
        for ((coupling, inverse), push) in
            self.couplings.iter().zip(&self.inverse_links).zip(&pushed)
        {
            u -= coupling * (*inverse * *push);
        }
        let l = &self.factors;
        for column in 0..5 {
            for row in column + 1..6 {
                let product = l[(row, column)] * u[column];
                u[row] -= product;
            }
        }
        for i in 0..6 {
            u[i] *= l[(i, i)];
        }
        for row in (1..6).rev() {
            for column in 0..row {
                let product = l[(row, column)] * u[row];
                u[column] -= product;
            }
        }
        Velocities {
            links: std::array::from_fn(|j| {
                (pushed[j] - self.couplings[j].dot(&u)) * self.inverse_links[j]
            }),
            body: u,
        }
    }
}
