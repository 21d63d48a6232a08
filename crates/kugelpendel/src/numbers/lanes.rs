//! Numbers of several cases side by side, one to a lane of the processor's vectors.
//!
//! Every operation does in each lane what it does with a number alone, to the last bit, so that what comes out of a lane
//! depends neither on its neighbours nor on how many there are.

use crate::numbers::arithmetic::Arithmetic;
#[cfg(target_arch = "x86_64")]
use crate::numbers::arithmetic::Fused;
#[cfg(target_arch = "x86_64")]
use std::arch::x86_64::*;
use std::marker::PhantomData;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// What the processor has to understand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Instructions {
    /// Those of every processor of its architecture.
    Common,
    /// AVX2 and FMA.
    Avx2,
    /// AVX-512F beside these.
    #[cfg_attr(not(target_arch = "x86_64"), expect(dead_code, reason = "other processors have other vectors"))]
    Avx512,
}

/// What one reckons with: a number, or one of each case.
pub(crate) trait Number:
    Copy + Default + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
}

impl Number for f64 {}

/// As many numbers as there are lanes.
///
/// # Safety
/// An implementor consists of `COUNT` binary64 numbers and of nothing else.
pub(crate) unsafe trait Lanes: Number {
    /// Of a number alone, with the same results.
    type Single: Arithmetic;
    const COUNT: usize;
    const NEEDS: Instructions;

    fn same(value: f64) -> Self;
    fn mul_add(self, factor: Self, summand: Self) -> Self;
    fn sqrt(self) -> Self;
    fn abs(self) -> Self;
    /// Of numbers: what is not one may come out or not.
    fn max(self, other: Self) -> Self;

    #[inline(always)]
    fn numbers(&self) -> &[f64] {
        // SAFETY: there are `COUNT` numbers, see above.
        unsafe { std::slice::from_raw_parts(std::ptr::from_ref(self).cast(), Self::COUNT) }
    }

    #[inline(always)]
    fn numbers_mut(&mut self) -> &mut [f64] {
        // SAFETY: as above.
        unsafe { std::slice::from_raw_parts_mut(std::ptr::from_mut(self).cast(), Self::COUNT) }
    }
}

/// Lanes of any processor.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub(crate) struct PlainLanes<A, const COUNT: usize>([f64; COUNT], PhantomData<A>);

impl<A: Arithmetic, const COUNT: usize> PlainLanes<A, COUNT> {
    #[inline(always)]
    fn each(lane: impl Fn(usize) -> f64) -> Self {
        Self(std::array::from_fn(lane), PhantomData)
    }
}

impl<A: Arithmetic, const COUNT: usize> Default for PlainLanes<A, COUNT> {
    #[inline(always)]
    fn default() -> Self {
        Self::same(0.0)
    }
}

macro_rules! plain_operator {
    ($operator:ident, $function:ident, $sign:tt) => {
        impl<A: Arithmetic, const COUNT: usize> $operator for PlainLanes<A, COUNT> {
            type Output = Self;
            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                Self::each(|lane| self.0[lane] $sign other.0[lane])
            }
        }
    };
}
plain_operator!(Add, add, +);
plain_operator!(Sub, sub, -);
plain_operator!(Mul, mul, *);
plain_operator!(Div, div, /);

impl<A: Arithmetic, const COUNT: usize> Neg for PlainLanes<A, COUNT> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::each(|lane| -self.0[lane])
    }
}

impl<A: Arithmetic, const COUNT: usize> Number for PlainLanes<A, COUNT> {}

// SAFETY: transparent, an array of so many numbers.
unsafe impl<A: Arithmetic, const COUNT: usize> Lanes for PlainLanes<A, COUNT> {
    type Single = A;
    const COUNT: usize = COUNT;
    const NEEDS: Instructions = A::NEEDS;

    #[inline(always)]
    fn same(value: f64) -> Self {
        Self([value; COUNT], PhantomData)
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        Self::each(|lane| A::mul_add(self.0[lane], factor.0[lane], summand.0[lane]))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self::each(|lane| self.0[lane].sqrt())
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self::each(|lane| self.0[lane].abs())
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self::each(|lane| self.0[lane].max(other.0[lane]))
    }
}

/// A register of the processor as lanes: its name, type, count and instructions, and what these are called.
#[cfg(target_arch = "x86_64")]
macro_rules! register {
    (
        $(#[$meta:meta])*
        $name:ident, $register:ident, $count:literal, $needs:ident,
        $same:ident, $add:ident, $sub:ident, $mul:ident, $div:ident, $mul_add:ident, $sqrt:ident, $max:ident, $abs:expr
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug)]
        #[repr(transparent)]
        pub(crate) struct $name($register);

        impl Default for $name {
            #[inline(always)]
            fn default() -> Self {
                Self::same(0.0)
            }
        }

        register!(@operator $name, Add, add, $add);
        register!(@operator $name, Sub, sub, $sub);
        register!(@operator $name, Mul, mul, $mul);
        register!(@operator $name, Div, div, $div);

        impl Neg for $name {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                self * Self::same(-1.0)
            }
        }

        impl Number for $name {}

        // SAFETY: transparent, a register of so many numbers.
        unsafe impl Lanes for $name {
            type Single = Fused;
            const COUNT: usize = $count;
            const NEEDS: Instructions = Instructions::$needs;

            #[inline(always)]
            fn same(value: f64) -> Self {
                // SAFETY: whoever works with these lanes has asked the processor for what they need.
                Self(unsafe { $same(value) })
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, summand: Self) -> Self {
                // SAFETY: as above.
                Self(unsafe { $mul_add(self.0, factor.0, summand.0) })
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                // SAFETY: as above.
                Self(unsafe { $sqrt(self.0) })
            }
            #[inline(always)]
            fn abs(self) -> Self {
                // SAFETY: as above.
                Self(unsafe { $abs(self.0) })
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                // SAFETY: as above.
                Self(unsafe { $max(self.0, other.0) })
            }
        }
    };
    (@operator $name:ident, $operator:ident, $function:ident, $intrinsic:ident) => {
        impl $operator for $name {
            type Output = Self;
            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                // SAFETY: as for [`Lanes::same`].
                Self(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    };
}

#[cfg(target_arch = "x86_64")]
register!(
    /// Four lanes, of AVX2.
    FourLanes, __m256d, 4, Avx2,
    _mm256_set1_pd, _mm256_add_pd, _mm256_sub_pd, _mm256_mul_pd, _mm256_div_pd, _mm256_fmadd_pd, _mm256_sqrt_pd,
    _mm256_max_pd, |register| _mm256_andnot_pd(_mm256_set1_pd(-0.0), register)
);

#[cfg(target_arch = "x86_64")]
register!(
    /// Eight lanes, of AVX-512.
    EightLanes, __m512d, 8, Avx512,
    _mm512_set1_pd, _mm512_add_pd, _mm512_sub_pd, _mm512_mul_pd, _mm512_div_pd, _mm512_fmadd_pd, _mm512_sqrt_pd,
    _mm512_max_pd, |register| _mm512_abs_pd(register)
);
