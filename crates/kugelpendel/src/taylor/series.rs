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

    /// From which [`reach`] finds how far the series may be followed: what `tolerance` leaves of the state, against the
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

/// How far a series may be followed: until its last two terms reach the tolerance.
///
/// The roots are right to 4e-6, which is more than a step needs, and without a branch, so that several lanes go at once.
#[inline(always)]
pub(crate) fn reach([last, before]: [f64; 2]) -> f64 {
    let [last, before] = [log2(last) * RECIPROCALS[ORDER], log2(before) * RECIPROCALS[ORDER - 1]];
    let reach = exp2(if last < before { last } else { before });
    // At rest nothing limits the step: the shares are infinite or not numbers, and their roots come out beyond this.
    if reach < MOST { reach } else { 1.0 }
}

/// 2⁵⁰.
const MOST: f64 = (1_u64 << 50) as f64;

/// Bits of the mantissa that binary64 stores.
const MANTISSA: u32 = 52;

/// Of a positive number, right to 2e-6; 1024 or more for what is not finite, −1023 for 0.
#[inline(always)]
fn log2(value: f64) -> f64 {
    /// Of √½: mantissas are taken from there to √2.
    const LEAST: u64 = std::f64::consts::FRAC_1_SQRT_2.to_bits();
    const ONE: u64 = 1.0_f64.to_bits();
    /// An integer below 2⁵² in the mantissa of 2⁵² is that number more.
    const WHOLE: f64 = (1_u64 << MANTISSA) as f64;
    const BIAS: f64 = 1023.0;
    let bits = value.abs().to_bits() + (ONE - LEAST);
    let exponent = f64::from_bits(bits >> MANTISSA | WHOLE.to_bits()) - (WHOLE + BIAS);
    let mantissa = f64::from_bits((bits & ((1 << MANTISSA) - 1)) + LEAST);
    // ln m = 2 artanh s.
    let s = (mantissa - 1.0) / (mantissa + 1.0);
    let square = s * s;
    exponent + 2.0 * std::f64::consts::LOG2_E * s * (1.0 + square * (1.0 / 3.0 + square * (1.0 / 5.0)))
}

/// Right to 4e-6, for exponents between −1000 and 1000.
#[inline(always)]
fn exp2(exponent: f64) -> f64 {
    /// Adding it pushes the fraction out, and leaves the integer in the lowest bits.
    const PUSH: f64 = 1.5 * (1_u64 << MANTISSA) as f64;
    let pushed = exponent + PUSH;
    let x = (exponent - (pushed - PUSH)) * std::f64::consts::LN_2;
    let fraction = 1.0 + x * (1.0 + x * (0.5 + x * (1.0 / 6.0 + x * (1.0 / 24.0 + x * (1.0 / 120.0)))));
    f64::from_bits(fraction.to_bits().wrapping_add(pushed.to_bits() << MANTISSA))
}

/// The k-th coefficient of a product of two vectors, direction by direction.
#[inline(always)]
pub(crate) fn dot<L: Layout>(k: usize, a: &Vectors<L::Vector>, b: &Vectors<L::Vector>) -> L::Vector {
    sum::<L, _>(k, &Directed(a), b)
}

/// Of a scalar and a vector.
#[inline(always)]
pub(crate) fn product<L: Layout>(k: usize, a: &Coefficients<L::Scalar>, b: &Vectors<L::Vector>) -> L::Vector {
    sum::<L, _>(k, &Everywhere(a), b)
}

/// Of two scalars, but for the terms with the k-th coefficient of either.
#[inline(always)]
pub(crate) fn inner_terms<L: Layout>(k: usize, a: &Coefficients<L::Scalar>, b: &Coefficients<L::Scalar>) -> L::Scalar {
    assert!(k <= ORDER);
    let [mut even, mut odd] = [L::same(0.0); 2];
    let mut i = 1;
    while i + 1 < k {
        odd = L::mul_add(a[i], b[k - i], odd);
        even = L::mul_add(a[i + 1], b[k - i - 1], even);
        i += 2;
    }
    if i < k {
        odd = L::mul_add(a[i], b[k - i], odd);
    }
    even + odd
}

/// Of the square of a scalar, but for the terms with the k-th coefficient.
#[inline(always)]
pub(crate) fn inner_square<L: Layout>(k: usize, a: &Coefficients<L::Scalar>) -> L::Scalar {
    assert!(k <= ORDER);
    let [mut even, mut odd] = [L::same(0.0); 2];
    let mut i = 1;
    while i + 1 < k.div_ceil(2) {
        odd = L::mul_add(a[i], a[k - i], odd);
        even = L::mul_add(a[i + 1], a[k - i - 1], even);
        i += 2;
    }
    if i < k.div_ceil(2) {
        odd = L::mul_add(a[i], a[k - i], odd);
    }
    let pairs = even + odd;
    let sum = pairs + pairs;
    if k >= 2 && k.is_multiple_of(2) { L::mul_add(a[k / 2], a[k / 2], sum) } else { sum }
}

/// What the terms of a product are made of: a trait and not a closure, since what is not inlined is not compiled for the
/// processor.
trait TermFactors<L: Layout> {
    fn at(&self, order: usize) -> L::Registers;
}

/// One number for each direction.
struct Directed<'a, V>(&'a Vectors<V>);

impl<L: Layout> TermFactors<L> for Directed<'_, L::Vector> {
    #[inline(always)]
    fn at(&self, order: usize) -> L::Registers {
        L::registers(&self.0[order])
    }
}

/// The same number for all directions.
struct Everywhere<'a, S>(&'a Coefficients<S>);

impl<L: Layout> TermFactors<L> for Everywhere<'_, L::Scalar> {
    #[inline(always)]
    fn at(&self, order: usize) -> L::Registers {
        L::everywhere(self.0[order])
    }
}

/// Σ a_i b_{k−i}; a_k comes last, since it is known last.
#[inline(always)]
fn sum<L: Layout, F: TermFactors<L>>(k: usize, a: &F, b: &Vectors<L::Vector>) -> L::Vector {
    let early = early_terms::<L, F>(k, a, b);
    L::kept(L::mul_add_registers(a.at(k), L::registers(&b[0]), early))
}

/// The same without a_k, in four sums, so that one multiplication need not wait for the other. The sums have names, since
/// those of an array would not stay in registers where the loop is not unrolled.
#[inline(always)]
fn early_terms<L: Layout, F: TermFactors<L>>(k: usize, a: &F, b: &Vectors<L::Vector>) -> L::Registers {
    assert!(k <= ORDER);
    let [mut s0, mut s1, mut s2, mut s3] = [L::everywhere(L::same(0.0)); 4];
    let mut i = 0;
    while i + 4 <= k {
        s0 = L::mul_add_registers(a.at(i), L::registers(&b[k - i]), s0);
        s1 = L::mul_add_registers(a.at(i + 1), L::registers(&b[k - i - 1]), s1);
        s2 = L::mul_add_registers(a.at(i + 2), L::registers(&b[k - i - 2]), s2);
        s3 = L::mul_add_registers(a.at(i + 3), L::registers(&b[k - i - 3]), s3);
        i += 4;
    }
    if i < k {
        s0 = L::mul_add_registers(a.at(i), L::registers(&b[k - i]), s0);
    }
    if i + 1 < k {
        s1 = L::mul_add_registers(a.at(i + 1), L::registers(&b[k - i - 1]), s1);
    }
    if i + 2 < k {
        s2 = L::mul_add_registers(a.at(i + 2), L::registers(&b[k - i - 2]), s2);
    }
    L::add_registers(L::add_registers(s0, s1), L::add_registers(s2, s3))
}

/// [`early_terms`] of two products with the same second factor, to the same bits: each of its numbers is loaded once for
/// both, and a quarter of the sums after the other, so that they stay in registers.
#[inline(always)]
pub(crate) fn early_terms_of_two<L: Layout>(
    k: usize,
    vectors: &Vectors<L::Vector>,
    scalars: &Coefficients<L::Scalar>,
    b: &Vectors<L::Vector>,
) -> [L::Registers; 2] {
    assert!(k <= ORDER);
    macro_rules! quarter {
        ($first:literal) => {{
            let [mut one, mut other] = [L::everywhere(L::same(0.0)); 2];
            let mut i = $first;
            while i < k {
                let factor = L::registers(&b[k - i]);
                one = L::mul_add_registers(L::registers(&vectors[i]), factor, one);
                other = L::mul_add_registers(L::everywhere(scalars[i]), factor, other);
                i += 4;
            }
            [one, other]
        }};
    }
    let [[a0, b0], [a1, b1]] = [quarter!(0), quarter!(1)];
    let [one, other] = [L::add_registers(a0, a1), L::add_registers(b0, b1)];
    let [[a2, b2], [a3, b3]] = [quarter!(2), quarter!(3)];
    [L::add_registers(one, L::add_registers(a2, a3)), L::add_registers(other, L::add_registers(b2, b3))]
}

/// Adds the last term of a product of a vector or a scalar, which is given in all directions, with b.
#[inline(always)]
pub(crate) fn with_last_term<L: Layout>(early: L::Registers, last: L::Registers, b: &Vectors<L::Vector>) -> L::Vector {
    L::kept(L::mul_add_registers(last, L::registers(&b[0]), early))
}

/// The k-th coefficient of the square of a vector.
#[inline(always)]
pub(crate) fn square<L: Layout>(k: usize, a: &Vectors<L::Vector>) -> L::Scalar {
    assert!(k <= ORDER);
    let [mut even, mut odd] = [L::everywhere(L::same(0.0)); 2];
    let mut i = 1;
    while i + 1 < k.div_ceil(2) {
        odd = L::mul_add_registers(L::registers(&a[i]), L::registers(&a[k - i]), odd);
        even = L::mul_add_registers(L::registers(&a[i + 1]), L::registers(&a[k - i - 1]), even);
        i += 2;
    }
    if i < k.div_ceil(2) {
        odd = L::mul_add_registers(L::registers(&a[i]), L::registers(&a[k - i]), odd);
    }
    square_of_pairs::<L>(k, L::add_registers(even, odd), a)
}

/// From the products of the coefficients before the middle with those after it, but for the first with the last.
#[inline(always)]
fn square_of_pairs<L: Layout>(k: usize, pairs: L::Registers, a: &Vectors<L::Vector>) -> L::Scalar {
    let mut sum = L::add_registers(pairs, pairs);
    if k >= 2 && k.is_multiple_of(2) {
        sum = L::mul_add_registers(L::registers(&a[k / 2]), L::registers(&a[k / 2]), sum);
    }
    let first = L::registers(&a[0]);
    let first = if k == 0 { first } else { L::add_registers(first, first) };
    total::<L>(&L::kept(L::mul_add_registers(L::registers(&a[k]), first, sum)))
}

/// [`square`], and the early terms of the product with a scalar: each vector is loaded once for both.
#[inline(always)]
pub(crate) fn square_and_early_terms<L: Layout>(
    k: usize,
    a: &Vectors<L::Vector>,
    scalars: &Coefficients<L::Scalar>,
) -> (L::Scalar, L::Registers) {
    assert!(k <= ORDER);
    let zero = L::everywhere(L::same(0.0));
    macro_rules! half {
        ($first:literal) => {{
            let [mut pairs, mut near, mut far] = [zero; 3];
            let mut i = $first;
            while i < k.div_ceil(2) {
                let (one, other) = (L::registers(&a[i]), L::registers(&a[k - i]));
                pairs = L::mul_add_registers(one, other, pairs);
                near = L::mul_add_registers(L::everywhere(scalars[i]), other, near);
                far = L::mul_add_registers(L::everywhere(scalars[k - i]), one, far);
                i += 2;
            }
            (pairs, L::add_registers(near, far))
        }};
    }
    let ((odd, one), (even, other)) = (half!(1), half!(2));
    let mut early = L::add_registers(one, other);
    if k >= 2 && k.is_multiple_of(2) {
        early = L::mul_add_registers(L::everywhere(scalars[k / 2]), L::registers(&a[k / 2]), early);
    }
    if k > 0 {
        early = L::mul_add_registers(L::everywhere(scalars[0]), L::registers(&a[k]), early);
    }
    (square_of_pairs::<L>(k, L::add_registers(even, odd), a), early)
}

/// The sum over the three directions.
#[inline(always)]
pub(crate) fn total<L: Layout>(vector: &L::Vector) -> L::Scalar {
    let [x, y, z] = L::parts(vector);
    (x + y) + z
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reach_is_the_smaller_root() {
        for exponent in -1000..=1000 {
            let last = 1.37_f64.powi(exponent * 2);
            for before in [last * 1e-3, last, last * 7.0] {
                let exact = last.powf(1.0 / ORDER as f64).min(before.powf(1.0 / (ORDER - 1) as f64));
                let off = reach([last, before]) / exact - 1.0;
                assert!(off.abs() < 4e-6, "{last:e} {before:e}: {off:e}");
            }
        }
    }

    #[test]
    fn at_rest_nothing_limits_a_step() {
        for at_rest in [[f64::INFINITY; 2], [f64::NAN, -f64::NAN], [f64::NAN, f64::INFINITY]] {
            assert_eq!(reach(at_rest), 1.0);
        }
        assert_eq!(reach([f64::INFINITY, 1.0]).to_bits(), reach([1.0, 1.0]).to_bits());
        // A state that has run away leaves nothing.
        assert!(reach([0.0, 0.0]) < 1e-15);
    }
}
