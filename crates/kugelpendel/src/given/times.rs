//! What is asked for, and when.

use crate::numbers::arithmetic::Arithmetic;
use crate::numbers::double_double::{Dd, Pair};

/// What is written, three numbers to a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// x, y, z in m.
    Position,
    /// Their rates in m/s.
    Velocity,
}

/// The times at which a motion is asked.
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

/// Indices of times, in the order in which a sweep comes to them.
pub(crate) type Order = Box<dyn Iterator<Item = usize>>;

/// The indices of the times for a sweep that goes forwards from t = 0 and for one that goes backwards.
pub(crate) fn orders(times: &[f64]) -> [Order; 2] {
    // Times in order need no list of their indices, which would take as much memory as they do.
    if times.is_sorted() && times.first().is_some_and(|first| *first >= 0.0) {
        return [Box::new(0..times.len()), Box::new(0..0)];
    }
    let mut order: Vec<usize> = (0..times.len()).collect();
    order.sort_by(|a, b| times[*a].total_cmp(&times[*b]));
    let ahead = order.split_off(order.partition_point(|index| times[*index] < 0.0));
    [Box::new(ahead.into_iter()), Box::new(order.into_iter().rev())]
}

/// Hands these indices to a sweep that goes forwards (side 0) and to one that goes backwards (side 1).
///
/// # Errors
/// The first of the two.
pub(crate) fn both_ways<E>(
    times: &[f64],
    mut sweep: impl FnMut(usize, &mut dyn Iterator<Item = usize>) -> Result<(), E>,
) -> Result<(), E> {
    let [mut ahead, mut behind] = orders(times);
    let ahead = sweep(0, &mut ahead);
    ahead.and(sweep(1, &mut behind))
}
