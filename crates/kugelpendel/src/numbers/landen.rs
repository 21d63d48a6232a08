//! The arithmetic-geometric mean, step by step: Gauss's and Landen's descending transformation.
//!
//! Frequencies, precession, nomes, arguments and averages are all made of its a_n, b_n and c_n = √(a_n² − b_n²), which
//! falls quadratically. Sources: NIST DLMF 19.8, 22.7; Abramowitz & Stegun 17.6.

use crate::numbers::arithmetic::Arithmetic;
use crate::numbers::double_double::Dd;
use crate::numbers::dual::{Dual, Real};

/// Positive numbers of which both means can be taken.
pub(crate) trait Mean: Copy {
    /// (a + b)/2.
    fn arithmetic(a: Self, b: Self) -> Self;
    /// √(ab).
    fn geometric(a: Self, b: Self) -> Self;
    /// c²/4a.
    fn quarter(c: Self, a: Self) -> Self;
}

/// a_n, b_n and c_n; or, in place of c_n, c_n over a power 2^n of something, which takes the same step.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Landen<T> {
    pub(crate) a: T,
    pub(crate) b: T,
    pub(crate) c: T,
}

impl<T: Mean> Landen<T> {
    #[inline(always)]
    pub(crate) fn next(self) -> Self {
        let a = T::arithmetic(self.a, self.b);
        Self { a, b: T::geometric(self.a, self.b), c: T::quarter(self.c, a) }
    }
}

macro_rules! mean_of_reals {
    ($number:ty) => {
        impl Mean for $number {
            #[inline(always)]
            fn arithmetic(a: Self, b: Self) -> Self {
                (a + b) * 0.5
            }
            #[inline(always)]
            fn geometric(a: Self, b: Self) -> Self {
                Real::sqrt(a * b)
            }
            #[inline(always)]
            fn quarter(c: Self, a: Self) -> Self {
                c * c / (a * 4.0)
            }
        }
    };
}
mean_of_reals!(f64);
mean_of_reals!(Dual);

impl<A: Arithmetic> Mean for Dd<A> {
    #[inline(always)]
    fn arithmetic(a: Self, b: Self) -> Self {
        a.plus(b).scale(0.5)
    }
    #[inline(always)]
    fn geometric(a: Self, b: Self) -> Self {
        (a * b).sqrt()
    }
    #[inline(always)]
    fn quarter(c: Self, a: Self) -> Self {
        c.square() / a.scale(4.0)
    }
}
