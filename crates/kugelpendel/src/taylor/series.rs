//! Integration by Taylor series of the order [`ORDER`], with steps as long as their last terms allow.
//!
//! Source: Jorba & Zou, Experimental Mathematics 14, 99 (2005), where for errors at the last bit the best order is
//! −½ ln ε, and the step that for which the last two terms fall below ε. Series are kept with the three directions of
//! space side by side, as one vector of the processor: a product of two series is then a few multiplications to a term.

use crate::numbers::arithmetic::{Arithmetic, horner};

/// Of the last term.
pub(crate) const ORDER: usize = 20;

/// Of the last terms against the state: where a step is no longer better for being shorter.
pub(crate) const FINEST: f64 = 1e-17;

/// x, y, z and a fourth number that is zero, so that a vector fills a register.
pub(crate) type Vector = [f64; 4];

/// Coefficients of a scalar function of the time over a step.
pub(crate) type Coefficients = [f64; ORDER + 1];

/// Coefficients of a vector.
pub(crate) type Vectors = [Vector; ORDER + 1];

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
pub(crate) struct Point {
    pub(crate) position: Vector,
    pub(crate) velocity: Vector,
}

/// The motion over a step, as polynomials in the time since its start.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Series {
    pub(crate) position: Vectors,
    pub(crate) velocity: Vectors,
    /// A function that reaches zero where the law ends.
    pub(crate) guard: Coefficients,
    /// v², where the law needs it.
    pub(crate) speed_squared: Coefficients,
}

/// r̈ as a function of r and ṙ, without dimensions: lengths in l, times in 1/ω0.
pub(crate) trait VectorField<A: Arithmetic> {
    /// Series that are needed on the way.
    type Terms: Default;

    /// From the K-th coefficients of position and velocity to those after.
    fn next_order<const K: usize>(&self, series: &mut Series, terms: &mut Self::Terms);

    /// Continues the series from their first coefficients. Every order is known to the compiler, so that the loops
    /// within become straight lines.
    #[inline(always)]
    fn continue_series(&self, series: &mut Series) {
        let terms = &mut Self::Terms::default();
        macro_rules! orders {
            ($($order:literal)+) => {
                const { assert!([$($order),+].len() == ORDER) }
                $(self.next_order::<$order>(series, terms);)+
            };
        }
        orders!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19);
    }
}

impl Series {
    pub(crate) const ZERO: Self = Self {
        position: [[0.0; 4]; ORDER + 1],
        velocity: [[0.0; 4]; ORDER + 1],
        guard: [0.0; ORDER + 1],
        speed_squared: [0.0; ORDER + 1],
    };

    #[inline(always)]
    pub(crate) fn start(&mut self, point: &Point) {
        self.position[0] = point.position;
        self.velocity[0] = point.velocity;
    }

    #[inline(always)]
    pub(crate) fn at<A: Arithmetic>(&self, since: f64) -> Point {
        let time = A::same(since);
        let [mut position, mut velocity] = [A::lanes(&self.position[ORDER]), A::lanes(&self.velocity[ORDER])];
        for k in (0..ORDER).rev() {
            position = A::mul_add_lanes(position, time, A::lanes(&self.position[k]));
            velocity = A::mul_add_lanes(velocity, time, A::lanes(&self.velocity[k]));
        }
        Point { position: A::array(position), velocity: A::array(velocity) }
    }

    #[inline(always)]
    pub(crate) fn position_at<A: Arithmetic>(&self, since: f64) -> Vector {
        let time = A::same(since);
        let mut position = A::lanes(&self.position[ORDER]);
        for k in (0..ORDER).rev() {
            position = A::mul_add_lanes(position, time, A::lanes(&self.position[k]));
        }
        A::array(position)
    }

    /// The guard's value.
    #[inline(always)]
    pub(crate) fn guard_at<A: Arithmetic>(&self, since: f64) -> f64 {
        horner::<A, _>(&self.guard, ORDER, since)
    }

    /// Whether the guard stays above zero, by a bound that costs less than looking for a zero.
    #[inline(always)]
    pub(crate) fn guard_holds(&self, size: f64) -> bool {
        let size = size.abs();
        let tail = self.guard[1..].iter().rev().fold(0.0, |sum, c| (sum + c.abs()) * size);
        self.guard[0] > tail
    }

    /// How far the series may be followed: until its last two terms reach `tolerance` of the state.
    #[inline(always)]
    pub(crate) fn reach(&self, tolerance: f64) -> f64 {
        let largest = |vector: &Vector| vector[0].abs().max(vector[1].abs()).max(vector[2].abs());
        let [x, y, _, _] = self.position[0];
        let size = tolerance * largest(&self.velocity[0]).max(x.abs()).max(y.abs());
        let last = largest(&self.position[ORDER]).max(largest(&self.velocity[ORDER]));
        let before = largest(&self.position[ORDER - 1]).max(largest(&self.velocity[ORDER - 1]));
        let reach = root(size / last, ORDER).min(root(size / before, ORDER - 1));
        // At rest nothing limits the step.
        if reach.is_finite() { reach } else { 1.0 }
    }
}

/// By exp2 and log2, which are three times faster than powf and as good as a step needs.
#[inline(always)]
fn root(value: f64, order: usize) -> f64 {
    (value.log2() / order as f64).exp2()
}

/// The K-th coefficient of a product of two vectors, direction by direction.
#[inline(always)]
pub(crate) fn dot<A: Arithmetic, const K: usize>(a: &Vectors, b: &Vectors) -> Vector {
    sum::<A, Vector, K>(a, b)
}

/// Of a scalar and a vector.
#[inline(always)]
pub(crate) fn product<A: Arithmetic, const K: usize>(a: &Coefficients, b: &Vectors) -> Vector {
    sum::<A, f64, K>(a, b)
}

/// Of two scalars, but for the terms with the K-th coefficient of either.
#[inline(always)]
pub(crate) fn inner_terms<A: Arithmetic, const K: usize>(a: &Coefficients, b: &Coefficients) -> f64 {
    let mut sums = [0.0; 2];
    for i in 1..K {
        sums[i % 2] = A::mul_add(a[i], b[K - i], sums[i % 2]);
    }
    sums[0] + sums[1]
}

/// What a term of a product is made of: the same for all directions, or one number for each.
trait TermFactor<A: Arithmetic> {
    fn lanes(&self) -> A::Lanes;
}

impl<A: Arithmetic> TermFactor<A> for f64 {
    #[inline(always)]
    fn lanes(&self) -> A::Lanes {
        A::same(*self)
    }
}

impl<A: Arithmetic> TermFactor<A> for Vector {
    #[inline(always)]
    fn lanes(&self) -> A::Lanes {
        A::lanes(self)
    }
}

/// Σ a_i b_{K−i} in four sums, so that one multiplication need not wait for the other; a_K comes last, since it is known
/// last.
#[inline(always)]
fn sum<A: Arithmetic, F: TermFactor<A>, const K: usize>(a: &[F; ORDER + 1], b: &Vectors) -> Vector {
    let mut sums = [A::same(0.0); 4];
    for i in 0..K {
        sums[i % 4] = A::mul_add_lanes(a[i].lanes(), A::lanes(&b[K - i]), sums[i % 4]);
    }
    let early = A::add_lanes(A::add_lanes(sums[0], sums[1]), A::add_lanes(sums[2], sums[3]));
    A::array(A::mul_add_lanes(a[K].lanes(), A::lanes(&b[0]), early))
}

/// The K-th coefficient of the square of a vector.
#[inline(always)]
pub(crate) fn square<A: Arithmetic, const K: usize>(a: &Vectors) -> f64 {
    let mut sums = [A::same(0.0); 2];
    for i in 1..K.div_ceil(2) {
        sums[i % 2] = A::mul_add_lanes(A::lanes(&a[i]), A::lanes(&a[K - i]), sums[i % 2]);
    }
    let pairs = A::add_lanes(sums[0], sums[1]);
    let mut sum = A::add_lanes(pairs, pairs);
    if K >= 2 && K.is_multiple_of(2) {
        sum = A::mul_add_lanes(A::lanes(&a[K / 2]), A::lanes(&a[K / 2]), sum);
    }
    let first = A::lanes(&a[0]);
    let first = if K == 0 { first } else { A::add_lanes(first, first) };
    total(&A::array(A::mul_add_lanes(A::lanes(&a[K]), first, sum)))
}

/// The sum over the three directions.
#[inline(always)]
pub(crate) fn total(vector: &Vector) -> f64 {
    (vector[0] + vector[1]) + (vector[2] + vector[3])
}
