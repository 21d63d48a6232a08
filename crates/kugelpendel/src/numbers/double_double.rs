//! Numbers of twice the precision, as an unevaluated sum of two binary64 numbers (error about 2⁻¹⁰⁴ relative).
//!
//! Used where an error would be multiplied by the time (frequency, precession) or divided by a small difference
//! (turning points of cones, the neighbourhood of the separatrix), never in the per-sample loops.
//! Algorithms: Dekker (1971), Knuth TAOCP 4.2.2, and the accurate variants of Joldes, Muller, Popescu,
//! ACM TOMS 44, 15res (2017).

use crate::numbers::arithmetic::{Arithmetic, two_prod_split};
use std::marker::PhantomData;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The value without its arithmetic: what is stored.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Pair {
    pub(crate) hi: f64,
    pub(crate) lo: f64,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Dd<A> {
    pub(crate) hi: f64,
    pub(crate) lo: f64,
    arithmetic: PhantomData<A>,
}

#[inline(always)]
pub(crate) const fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let t = s - a;
    (s, (a - (s - t)) + (b - t))
}

#[inline(always)]
const fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

// In a page every byte is sent: there the long ones of these are called, and elsewhere written out where they are used.
impl<A: Arithmetic> Dd<A> {
    pub(crate) const ZERO: Self = Self::raw(0.0, 0.0);
    pub(crate) const ONE: Self = Self::raw(1.0, 0.0);
    pub(crate) const SQRT_HALF: Self = Self::raw(std::f64::consts::FRAC_1_SQRT_2, -4.833646656726457e-17);
    pub(crate) const INV_PI: Self = Self::raw(std::f64::consts::FRAC_1_PI, -1.9678676675182486e-17);

    #[inline(always)]
    pub(crate) const fn raw(hi: f64, lo: f64) -> Self {
        Self { hi, lo, arithmetic: PhantomData }
    }
    #[inline(always)]
    pub(crate) fn of(pair: Pair) -> Self {
        Self::raw(pair.hi, pair.lo)
    }
    #[inline(always)]
    pub(crate) fn pair(self) -> Pair {
        Pair { hi: self.hi, lo: self.lo }
    }
    /// a·b, exactly.
    #[inline(always)]
    pub(crate) fn product(a: f64, b: f64) -> Self {
        let (hi, lo) = A::two_prod(a, b);
        Self::raw(hi, lo)
    }
    #[inline(always)]
    pub(crate) fn square(self) -> Self {
        let (p, e) = A::two_prod(self.hi, self.hi);
        let (hi, lo) = quick_two_sum(p, A::mul_add(2.0 * self.hi, self.lo, e));
        Self::raw(hi, lo)
    }
    /// Multiplication by a power of two: exact.
    #[inline(always)]
    pub(crate) fn scale(self, power: f64) -> Self {
        Self::raw(self.hi * power, self.lo * power)
    }
    /// Zero for zero and for the negative rounding noise of a vanishing difference.
    #[inline(always)]
    pub(crate) fn sqrt(self) -> Self {
        Self::sqrt_ratio(self, Self::ONE)
    }
    /// One or the other, without a branch.
    #[inline(always)]
    pub(crate) fn select(condition: bool, yes: Self, no: Self) -> Self {
        let hi = if condition { yes.hi } else { no.hi };
        let lo = if condition { yes.lo } else { no.lo };
        Self::raw(hi, lo)
    }
    #[inline(always)]
    pub(crate) fn abs(self) -> Self {
        Self::select(self.hi < 0.0, -self, self)
    }
    /// The sum of two numbers of the same sign, for half the work of `+`.
    #[inline(always)]
    pub(crate) fn plus(self, other: Self) -> Self {
        let (s, e) = two_sum(self.hi, other.hi);
        let (hi, lo) = quick_two_sum(s, e + (self.lo + other.lo));
        Self::raw(hi, lo)
    }
    /// √(numerator/denominator); zero where the numerator is not positive.
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub(crate) fn sqrt_ratio(numerator: Self, denominator: Self) -> Self {
        let root = (numerator.hi / denominator.hi).sqrt();
        let rest = numerator - Self::product(root, root) * denominator;
        let (hi, lo) = quick_two_sum(root, rest.hi / (2.0 * root * denominator.hi));
        Self::select(numerator.hi > 0.0, Self::raw(hi, lo), Self::ZERO)
    }
    /// √(a² + b²).
    #[inline(always)]
    pub(crate) fn hypot(self, other: Self) -> Self {
        self.square().plus(other.square()).sqrt()
    }
    /// Sine and cosine of a binary64 angle in radians, taken exactly; good to 1e-30 for |angle| up to 1e9.
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub(crate) fn sin_cos(angle: f64) -> (Self, Self) {
        // Three parts of π/2: a multiple of it is subtracted exactly enough even where the difference nearly vanishes.
        const HALF_PI: [f64; 3] = [std::f64::consts::FRAC_PI_2, 6.123233995736766e-17, -1.4973849048591698e-33];
        let turns = A::round(angle * std::f64::consts::FRAC_2_PI);
        let mut r = Self::from(angle);
        for part in HALF_PI {
            r = r - Self::product(turns, part);
        }
        // An eighth of the angle by Taylor, then three doublings of (sine, versine), which lose no digits.
        r = r.scale(0.125);
        let square = r.square();
        let (mut s, mut v) = (Self::ZERO, Self::ZERO);
        for n in (1..10).rev() {
            s = square * (Self::of(INVERSE_FACTORIAL[2 * n + 1]) - s);
            v = square * (Self::of(INVERSE_FACTORIAL[2 * n]) - v);
        }
        let (mut sine, mut versine) = (r - r * s, v);
        for _ in 0..3 {
            (sine, versine) = ((sine - sine * versine).scale(2.0), sine.square().scale(2.0));
        }
        let cosine = Self::ONE - versine;
        match turns.rem_euclid(4.0) as u8 {
            0 => (sine, cosine),
            1 => (cosine, -sine),
            2 => (-sine, -cosine),
            _ => (-cosine, sine),
        }
    }
}

/// 1/n! to twice the precision; n! itself is a binary64 number up to 22!.
const INVERSE_FACTORIAL: [Pair; 20] = {
    let mut table = [Pair { hi: 1.0, lo: 0.0 }; 20];
    let (mut n, mut factorial) = (1, 1.0);
    while n < 20 {
        factorial *= n as f64;
        let hi = 1.0 / factorial;
        let (product, error) = two_prod_split(hi, factorial);
        table[n] = Pair { hi, lo: ((1.0 - product) - error) / factorial };
        n += 1;
    }
    table
};

impl<A: Arithmetic> From<f64> for Dd<A> {
    #[inline(always)]
    fn from(value: f64) -> Self {
        Self::raw(value, 0.0)
    }
}

impl<A: Arithmetic> Neg for Dd<A> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::raw(-self.hi, -self.lo)
    }
}

impl<A: Arithmetic> Add for Dd<A> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (s, e) = two_sum(self.hi, other.hi);
        let (t, f) = two_sum(self.lo, other.lo);
        let (s, e) = quick_two_sum(s, e + t);
        let (hi, lo) = quick_two_sum(s, e + f);
        Self::raw(hi, lo)
    }
}

impl<A: Arithmetic> Sub for Dd<A> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<A: Arithmetic> Mul for Dd<A> {
    type Output = Self;
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    fn mul(self, other: Self) -> Self {
        let (p, e) = A::two_prod(self.hi, other.hi);
        let cross = A::mul_add(self.hi, other.lo, self.lo * other.hi);
        let (hi, lo) = quick_two_sum(p, e + cross);
        Self::raw(hi, lo)
    }
}

impl<A: Arithmetic> Mul<f64> for Dd<A> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        let (p, e) = A::two_prod(self.hi, other);
        let (hi, lo) = quick_two_sum(p, A::mul_add(self.lo, other, e));
        Self::raw(hi, lo)
    }
}

impl<A: Arithmetic> Div for Dd<A> {
    type Output = Self;
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    fn div(self, other: Self) -> Self {
        let quotient = self.hi / other.hi;
        let rest = self - other * quotient;
        let (hi, lo) = quick_two_sum(quotient, rest.hi / other.hi);
        Self::raw(hi, lo)
    }
}
