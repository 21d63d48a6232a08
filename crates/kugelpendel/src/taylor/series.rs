//! Integration by Taylor series of the order [`ORDER`], with steps as long as their last terms allow.
//!
//! Source: Jorba & Zou, Experimental Mathematics 14, 99 (2005), where for errors at the last bit the best order is
//! −½ ln ε, and the step that for which the last two terms fall below ε. Series are kept with the three directions of
//! space side by side, as one vector of the processor, or with several cases side by side: a product of two series is then
//! a few multiplications to a term.

use crate::numbers::arithmetic::Arithmetic;
use crate::numbers::lanes::{Lanes, Number};
use crate::taylor::layout::{Alone, Layout, Vector};

/// Of the last term.
pub(crate) const ORDER: usize = 20;

/// Of the last terms against the state: where a step is no longer better for being shorter.
pub(crate) const FINEST: f64 = 1e-17;

/// Coefficients of a scalar function of the time over a step.
pub(crate) type Coefficients<S = f64> = [S; ORDER + 1];

/// Coefficients of a vector.
pub(crate) type Vectors<V = Vector> = [V; ORDER + 1];

/// 1/k.
pub(crate) const RECIPROCALS: Coefficients = {
    let mut reciprocals = [0.0; ORDER + 1];
    let mut k = 1;
    while k <= ORDER {
        reciprocals[k] = 1.0 / k as f64;
        k += 1;
    }
    reciprocals
};

/// Where the bob is, and how fast.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Point<V = Vector> {
    pub(crate) position: V,
    pub(crate) velocity: V,
}

/// The motion over a step, as polynomials in the time since its start.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Series<S = f64, V = Vector> {
    pub(crate) position: Vectors<V>,
    pub(crate) velocity: Vectors<V>,
    /// A function that reaches zero where the law ends.
    pub(crate) guard: Coefficients<S>,
    /// v², where the law needs it.
    pub(crate) speed_squared: Coefficients<S>,
}

/// The series of a layout.
pub(crate) type SeriesOf<L> = Series<<L as Layout>::Scalar, <L as Layout>::Vector>;

/// r̈ as a function of r and ṙ, without dimensions: lengths in l, times in 1/ω0.
pub(crate) trait VectorField<L: Layout> {
    /// Series that are needed on the way.
    type Terms;

    /// From the coefficients of position and velocity of an order to those after.
    fn next_order(&self, order: usize, series: &mut SeriesOf<L>, terms: &mut Self::Terms);

    /// Continues the series from their first coefficients. What `terms` held before does not matter.
    #[inline(always)]
    fn continue_series(&self, series: &mut SeriesOf<L>, terms: &mut Self::Terms) {
        macro_rules! orders {
            ($($order:literal)+) => {
                const { assert!([$($order),+].len() == ORDER) }
                $(self.next_order($order, series, terms);)+
            };
        }
        if L::WRITTEN_OUT {
            orders!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19);
        } else {
            for order in 0..ORDER {
                self.next_order(order, series, terms);
            }
        }
    }
}

impl Series {
    pub(crate) const ZERO: Self = Self {
        position: [[0.0; 4]; ORDER + 1],
        velocity: [[0.0; 4]; ORDER + 1],
        guard: [0.0; ORDER + 1],
        speed_squared: [0.0; ORDER + 1],
    };

    /// Whether the guard stays above zero; where it seems not to, it has to be looked at more closely.
    #[inline(always)]
    pub(crate) fn guard_holds<A: Arithmetic>(&self, size: f64) -> bool {
        self.guard_margin::<Alone<A>>(size) > 0.0
    }
}

impl<S: Number, V: Copy> Series<S, V> {
    #[inline(always)]
    pub(crate) fn start(&mut self, point: &Point<V>) {
        self.position[0] = point.position;
        self.velocity[0] = point.velocity;
    }

    #[inline(always)]
    pub(crate) fn at<L: Layout<Scalar = S, Vector = V>>(&self, since: S) -> Point<V> {
        let time = L::everywhere(since);
        let [mut position, mut velocity] = [L::registers(&self.position[ORDER]), L::registers(&self.velocity[ORDER])];
        for k in (0..ORDER).rev() {
            position = L::mul_add_registers(position, time, L::registers(&self.position[k]));
            velocity = L::mul_add_registers(velocity, time, L::registers(&self.velocity[k]));
        }
        Point { position: L::kept(position), velocity: L::kept(velocity) }
    }

    #[inline(always)]
    pub(crate) fn position_at<L: Layout<Scalar = S, Vector = V>>(&self, since: S) -> V {
        let time = L::everywhere(since);
        let mut position = L::registers(&self.position[ORDER]);
        for k in (0..ORDER).rev() {
            position = L::mul_add_registers(position, time, L::registers(&self.position[k]));
        }
        L::kept(position)
    }

    /// The guard's value.
    #[inline(always)]
    pub(crate) fn guard_at<L: Layout<Scalar = S, Vector = V>>(&self, since: S) -> S {
        polynomial::<L>(&self.guard, since)
    }

    /// Above zero where the guard stays so, by a bound that costs less than looking for a zero.
    #[inline(always)]
    pub(crate) fn guard_margin<L: Layout<Scalar = S, Vector = V>>(&self, size: S) -> S {
        let size = L::abs(size);
        let square = size * size;
        let [first, rest @ ..] = &self.guard;
        // Odd and even powers in sums of their own, which need not wait for one another.
        let [mut odd, mut even] = [L::same(0.0); 2];
        for [one, other] in rest.as_chunks::<2>().0.iter().rev() {
            odd = L::mul_add(odd, square, L::abs(*one));
            even = L::mul_add(even, square, L::abs(*other));
        }
        *first - (odd * size + even * square)
    }

    /// From which [`reach`](crate::taylor::reach::reach) finds how far the series may be followed: what `tolerance` leaves of the state, against the
    /// last term and against the one before.
    #[inline(always)]
    pub(crate) fn shares<L: Layout<Scalar = S, Vector = V>>(&self, tolerance: S) -> [S; 2] {
        let [x, y, _] = L::parts(&self.position[0]);
        let state = L::max(L::max(largest::<L>(&self.velocity[0]), L::abs(x)), L::abs(y));
        let size = tolerance * state;
        let [last, before] = [self.largest_term::<L>(ORDER), self.largest_term::<L>(ORDER - 1)];
        [size / last, size / before]
    }

    #[inline(always)]
    fn largest_term<L: Layout<Scalar = S, Vector = V>>(&self, order: usize) -> S {
        L::max(largest::<L>(&self.position[order]), largest::<L>(&self.velocity[order]))
    }
}

/// The value of a scalar's series.
#[inline(always)]
pub(crate) fn polynomial<L: Layout>(coefficients: &Coefficients<L::Scalar>, since: L::Scalar) -> L::Scalar {
    let mut value = coefficients[ORDER];
    for k in (0..ORDER).rev() {
        value = L::mul_add(value, since, coefficients[k]);
    }
    value
}

/// The largest of the three directions, without its sign.
#[inline(always)]
fn largest<L: Layout>(vector: &L::Vector) -> L::Scalar {
    let [x, y, z] = L::parts(vector);
    L::max(L::max(L::abs(x), L::abs(y)), L::abs(z))
}

impl<L: Lanes> Series<L, [L; 3]> {
    pub(crate) fn zero() -> Self {
        let zero = L::same(0.0);
        Self {
            position: [[zero; 3]; ORDER + 1],
            velocity: [[zero; 3]; ORDER + 1],
            guard: [zero; ORDER + 1],
            speed_squared: [zero; ORDER + 1],
        }
    }

    /// Lays a point into a lane, as the start of its series.
    #[inline(always)]
    pub(crate) fn start_lane(&mut self, lane: usize, point: &Point) {
        for direction in 0..3 {
            self.position[0][direction].numbers_mut()[lane] = point.position[direction];
            self.velocity[0][direction].numbers_mut()[lane] = point.velocity[direction];
        }
    }

    /// The series of one lane.
    #[inline(always)]
    pub(crate) fn copy_lane(&self, lane: usize, series: &mut Series) {
        for k in 0..=ORDER {
            series.position[k] = in_lane(&self.position[k], lane);
            series.velocity[k] = in_lane(&self.velocity[k], lane);
            series.guard[k] = self.guard[k].numbers()[lane];
            series.speed_squared[k] = self.speed_squared[k].numbers()[lane];
        }
    }
}

/// The vector of one lane.
#[inline(always)]
pub(crate) fn in_lane<L: Lanes>([x, y, z]: &[L; 3], lane: usize) -> Vector {
    [x.numbers()[lane], y.numbers()[lane], z.numbers()[lane], 0.0]
}
