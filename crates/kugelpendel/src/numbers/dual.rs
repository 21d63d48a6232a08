//! Numbers with their derivatives in two directions, and what these and plain numbers have in common.
//!
//! Formulas that are written for [`Real`] are differentiated by the arithmetic itself, to the last digits.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// What a formula may do with its numbers.
pub(crate) trait Real:
    Copy
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Mul<f64, Output = Self>
{
    /// The number without its derivatives.
    fn value(self) -> f64;
    fn sqrt(self) -> Self;
    fn recip(self) -> Self;
}

impl Real for f64 {
    #[inline(always)]
    fn value(self) -> f64 {
        self
    }
    #[inline(always)]
    fn sqrt(self) -> f64 {
        self.sqrt()
    }
    #[inline(always)]
    fn recip(self) -> f64 {
        1.0 / self
    }
}

/// A number and its derivatives in two directions.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Dual {
    pub(crate) value: f64,
    pub(crate) slope: [f64; 2],
}

impl Dual {
    /// The value after a step in both directions, to first order.
    #[inline(always)]
    pub(crate) fn after(self, step: [f64; 2]) -> f64 {
        self.value + self.slope[0] * step[0] + self.slope[1] * step[1]
    }

    /// A function of `self` with this value and this derivative with respect to it.
    #[inline(always)]
    fn chain(self, value: f64, derivative: f64) -> Self {
        Self { value, slope: self.slope.map(|slope| derivative * slope) }
    }
}

impl Real for Dual {
    #[inline(always)]
    fn value(self) -> f64 {
        self.value
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root)
    }
    #[inline(always)]
    fn recip(self) -> Self {
        let inverse = 1.0 / self.value;
        self.chain(inverse, -inverse * inverse)
    }
}

impl Neg for Dual {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.chain(-self.value, -1.0)
    }
}

impl Add for Dual {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, slope: std::array::from_fn(|k| self.slope[k] + other.slope[k]) }
    }
}

impl Sub for Dual {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { value: self.value - other.value, slope: std::array::from_fn(|k| self.slope[k] - other.slope[k]) }
    }
}

impl Mul for Dual {
    type Output = Self;
    #[inline(always)]
    #[expect(clippy::suspicious_arithmetic_impl, reason = "a product's derivative is a sum")]
    fn mul(self, other: Self) -> Self {
        let slope = std::array::from_fn(|k| self.value * other.slope[k] + self.slope[k] * other.value);
        Self { value: self.value * other.value, slope }
    }
}

impl Div for Dual {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let inverse = 1.0 / other.value;
        let value = self.value * inverse;
        Self { value, slope: std::array::from_fn(|k| (self.slope[k] - value * other.slope[k]) * inverse) }
    }
}

impl Add<f64> for Dual {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: f64) -> Self {
        Self { value: self.value + other, ..self }
    }
}

impl Mul<f64> for Dual {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        self.chain(self.value * other, other)
    }
}
