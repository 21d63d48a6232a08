//! What is asked for, and when.

use crate::arithmetic::Arithmetic;
use crate::double_double::{Dd, Pair};

/// What is written, three numbers to a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// x, y, z in m.
    Position,
    /// Their rates in m/s.
    Velocity,
}

/// When.
#[derive(Clone, Copy, Debug)]
pub enum Times<'a> {
    /// Any times, s.
    Scattered(&'a [f64]),
    /// start + step·k for k = first, first + 1, …: the sum is taken exactly, not rounded to a binary64 time.
    Grid {
        /// s.
        start: f64,
        /// s.
        step: f64,
        /// Index of the first time wanted.
        first: usize,
    },
}

impl Times<'_> {
    #[inline(always)]
    pub(crate) fn at<A: Arithmetic>(&self, index: usize) -> Pair {
        match *self {
            Times::Scattered(times) => Pair { hi: times[index], lo: 0.0 },
            Times::Grid { start, step, first } => {
                (Dd::<A>::product(step, (first + index) as f64) + Dd::from(start)).pair()
            }
        }
    }

    #[cfg(feature = "threads")]
    pub(crate) fn from(&self, index: usize) -> Self {
        match *self {
            Times::Scattered(times) => Times::Scattered(&times[index..]),
            Times::Grid { start, step, first } => Times::Grid { start, step, first: first + index },
        }
    }
}
