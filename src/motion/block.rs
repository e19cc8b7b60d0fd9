//! Eight bodies of a batch, component by component.

use crate::motion::{Quaternion, State};
use nalgebra::Vector3;

/// How many bodies stand side by side.
pub const LANES: usize = 8;

/// A number of each of eight bodies.
pub type Lane = [f64; LANES];

/// The inertia tensors of eight bodies, their entries in the order xx, yy, zz, xy, xz, yz.
#[derive(Clone, Copy, Debug)]
pub enum Tensors<'a> {
    /// One of principal axes for all, and the inverses of its moments.
    Principal {
        /// The moments, kg m².
        moments: [f64; 3],
        /// Their inverses.
        inverse: [f64; 3],
    },
    /// One for all, and its inverse.
    Shared {
        /// The entries, kg m².
        entries: [f64; 6],
        /// Those of the inverse.
        inverse: [f64; 6],
    },
    /// One for each, all along their principal axes.
    OwnPrincipal(&'a [Lane; 6]),
    /// One for each.
    Own(&'a [Lane; 6]),
}

/// The states of eight bodies, each component of all eight together: a loop over the bodies in which each takes
/// the same operations runs on whole registers.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub struct Block([Lane; 7]);

impl Block {
    /// The states of eight bodies.
    pub fn new(states: &[State<f64>; LANES]) -> Self {
        let mut block = Self([[0.0; LANES]; 7]);
        for (lane, state) in states.iter().enumerate() {
            block.set(lane, state);
        }
        block
    }

    /// The state of body `lane`, less than [`LANES`].
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn get(&self, lane: usize) -> State<f64> {
        let [w, x, y, z, a, b, c] = &self.0;
        State {
            attitude: Quaternion::new([w[lane], x[lane], y[lane], z[lane]]),
            angular_velocity: Vector3::new(a[lane], b[lane], c[lane]),
        }
    }

    /// Sets the state of body `lane`, less than [`LANES`].
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn set(&mut self, lane: usize, state: &State<f64>) {
        let ([w, x, y, z], o) = (state.attitude.components(), &state.angular_velocity);
        self.0[0][lane] = w;
        self.0[1][lane] = x;
        self.0[2][lane] = y;
        self.0[3][lane] = z;
        self.0[4][lane] = o.x;
        self.0[5][lane] = o.y;
        self.0[6][lane] = o.z;
    }

    /// The components w, x, y, z of the attitudes, then those of ω, of all eight bodies each.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn lanes(&self) -> &[Lane; 7] {
        &self.0
    }

    /// The same, to be written.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn lanes_mut(&mut self) -> &mut [Lane; 7] {
        &mut self.0
    }

    /// Whether every component of every body is a finite number.
    #[cfg(feature = "batch")]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn is_finite(&self) -> bool {
        // 0 times anything else is not 0.
        let mut zeros = [0.0; LANES];
        for values in &self.0 {
            for (zero, value) in zeros.iter_mut().zip(values) {
                *zero += value * 0.0;
            }
        }
        // Straight through: a closure would be compiled apart, for the least of machines.
        let mut sum = 0.0;
        for zero in zeros {
            sum += zero;
        }
        sum == 0.0
    }
}
