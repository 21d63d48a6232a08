//! Many launches solved at once.

use crate::exact::invariants::constants::{Invariants, Turning};
use crate::given::launch::{LaunchState, STATE_NUMBERS};
use crate::numbers::arithmetic::Arithmetic;
use crate::numbers::double_double::Pair;

/// Launches solved together.
pub(crate) const LAUNCHES_PER_BLOCK: usize = 64;

/// What a solution consists of.
const NUMBERS: usize = 19;

impl Invariants {
    /// All of them for many launches: a straight line that the compiler vectorises, and the few that need more steps of
    /// an iteration once more. One launch takes the same way, so that it has the same result in any ensemble.
    #[inline(always)]
    pub(crate) fn fill_block<A: Arithmetic>(states: &[LaunchState<A>], out: &mut [Self]) {
        // In columns, since records of numbers are what the compiler does not vectorise.
        let mut given = [[0.0; LAUNCHES_PER_BLOCK]; STATE_NUMBERS];
        let mut found = [[0.0; LAUNCHES_PER_BLOCK]; NUMBERS];
        let count = states.len().min(LAUNCHES_PER_BLOCK);
        for (k, state) in states.iter().enumerate() {
            for (column, number) in given.iter_mut().zip(state.numbers()) {
                column[k] = number;
            }
        }
        for k in 0..count {
            let mut row = [0.0; STATE_NUMBERS];
            for n in 0..STATE_NUMBERS {
                row[n] = given[n][k];
            }
            let row = Self::of::<A, true>(&LaunchState::from_numbers(row)).numbers();
            for n in 0..NUMBERS {
                found[n][k] = row[n];
            }
        }
        for (k, (state, out)) in states.iter().zip(out).enumerate() {
            *out = Self::from_numbers(std::array::from_fn(|n| found[n][k]));
            if !out.settled {
                *out = Self::of::<A, false>(state);
            }
        }
    }

    #[inline(always)]
    fn numbers(&self) -> [f64; NUMBERS] {
        let t = &self.turning;
        let flag = |flag: bool| if flag { 1.0 } else { 0.0 };
        [
            self.energy,
            self.angular_momentum,
            self.sense,
            t.high,
            t.low,
            t.high_depth,
            t.low_depth,
            t.excess,
            t.half_range,
            self.frequency.hi,
            self.frequency.lo,
            self.precession.hi,
            self.precession.lo,
            self.frame.hi,
            self.frame.lo,
            self.circle[0],
            self.circle[1],
            flag(self.from_above),
            flag(self.settled),
        ]
    }

    fn from_numbers(numbers: [f64; NUMBERS]) -> Self {
        let [energy, angular_momentum, sense, high, low, high_depth, low_depth, excess, half_range, ..] = numbers;
        let pair = |n: usize| Pair { hi: numbers[n], lo: numbers[n + 1] };
        Self {
            energy,
            angular_momentum,
            sense,
            turning: Turning { high, low, high_depth, low_depth, excess, half_range },
            frequency: pair(9),
            precession: pair(11),
            frame: pair(13),
            circle: [numbers[15], numbers[16]],
            from_above: numbers[17] != 0.0,
            settled: numbers[18] != 0.0,
        }
    }
}
