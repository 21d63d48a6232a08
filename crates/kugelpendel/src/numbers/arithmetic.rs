//! The two ways to do the same arithmetic: with fused multiply-add where the processor has it, and without.
//!
//! Rust compiles for the oldest processor of an architecture, where `f64::mul_add` is a call into the C library.
//! Everything numerical is therefore generic over [`Arithmetic`] and inlined into one of two entry points made by
//! [`dispatch!`]; the processor is asked once, at run time. The two agree to the last few bits, not to the last.

use crate::numbers::lanes::Instructions;
#[cfg(target_arch = "x86_64")]
use std::arch::x86_64::{__m256d, _mm256_add_pd, _mm256_fmadd_pd, _mm256_loadu_pd, _mm256_set1_pd, _mm256_storeu_pd};
use std::sync::OnceLock;

pub(crate) trait Arithmetic: Copy + Send + Sync + 'static {
    /// Only where the processor has these.
    const NEEDS: Instructions;

    /// a·b + c, rounded once or twice.
    fn mul_add(a: f64, b: f64, c: f64) -> f64;
    /// a·b as an unevaluated sum (rounded product, error).
    fn two_prod(a: f64, b: f64) -> (f64, f64);
    /// The nearest integer; ties either way.
    fn round(a: f64) -> f64;

    /// Four numbers side by side, where the processor has it in one register: left to itself, the compiler takes such
    /// loops apart again.
    type Lanes: Copy;
    fn lanes(array: &[f64; 4]) -> Self::Lanes;
    fn same(value: f64) -> Self::Lanes;
    fn array(lanes: Self::Lanes) -> [f64; 4];
    fn mul_add_lanes(a: Self::Lanes, b: Self::Lanes, c: Self::Lanes) -> Self::Lanes;
    fn add_lanes(a: Self::Lanes, b: Self::Lanes) -> Self::Lanes;
}

/// Lanes of any processor.
macro_rules! portable_lanes {
    () => {
        type Lanes = [f64; 4];
        #[inline(always)]
        fn lanes(array: &[f64; 4]) -> [f64; 4] {
            *array
        }
        #[inline(always)]
        fn same(value: f64) -> [f64; 4] {
            [value; 4]
        }
        #[inline(always)]
        fn array(lanes: [f64; 4]) -> [f64; 4] {
            lanes
        }
        #[inline(always)]
        fn mul_add_lanes(a: [f64; 4], b: [f64; 4], c: [f64; 4]) -> [f64; 4] {
            std::array::from_fn(|lane| Self::mul_add(a[lane], b[lane], c[lane]))
        }
        #[inline(always)]
        fn add_lanes(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
            std::array::from_fn(|lane| a[lane] + b[lane])
        }
    };
}

/// One rounding: FMA, AVX2 or NEON.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fused;

/// Two roundings: any processor, and WebAssembly.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Portable;

impl Arithmetic for Fused {
    const NEEDS: Instructions = if cfg!(target_arch = "x86_64") { Instructions::Avx2 } else { Instructions::Common };

    #[inline(always)]
    fn mul_add(a: f64, b: f64, c: f64) -> f64 {
        a.mul_add(b, c)
    }
    #[inline(always)]
    fn two_prod(a: f64, b: f64) -> (f64, f64) {
        let product = a * b;
        (product, a.mul_add(b, -product))
    }
    #[inline(always)]
    fn round(a: f64) -> f64 {
        a.round_ties_even()
    }

    #[cfg(not(target_arch = "x86_64"))]
    portable_lanes!();

    #[cfg(target_arch = "x86_64")]
    type Lanes = __m256d;
    #[cfg(target_arch = "x86_64")]
    #[inline(always)]
    fn lanes(array: &[f64; 4]) -> __m256d {
        // SAFETY: four numbers are there, and `Fused` is only used where `dispatch!` has found AVX2 and FMA.
        unsafe { _mm256_loadu_pd(array.as_ptr()) }
    }
    #[cfg(target_arch = "x86_64")]
    #[inline(always)]
    fn same(value: f64) -> __m256d {
        // SAFETY: as above.
        unsafe { _mm256_set1_pd(value) }
    }
    #[cfg(target_arch = "x86_64")]
    #[inline(always)]
    fn array(lanes: __m256d) -> [f64; 4] {
        let mut array = [0.0; 4];
        // SAFETY: there is room for four numbers; as above.
        unsafe { _mm256_storeu_pd(array.as_mut_ptr(), lanes) };
        array
    }
    #[cfg(target_arch = "x86_64")]
    #[inline(always)]
    fn mul_add_lanes(a: __m256d, b: __m256d, c: __m256d) -> __m256d {
        // SAFETY: as above.
        unsafe { _mm256_fmadd_pd(a, b, c) }
    }
    #[cfg(target_arch = "x86_64")]
    #[inline(always)]
    fn add_lanes(a: __m256d, b: __m256d) -> __m256d {
        // SAFETY: as above.
        unsafe { _mm256_add_pd(a, b) }
    }
}

impl Arithmetic for Portable {
    const NEEDS: Instructions = Instructions::Common;
    portable_lanes!();

    #[inline(always)]
    fn mul_add(a: f64, b: f64, c: f64) -> f64 {
        a * b + c
    }
    #[inline(always)]
    fn two_prod(a: f64, b: f64) -> (f64, f64) {
        two_prod_split(a, b)
    }
    #[inline(always)]
    fn round(a: f64) -> f64 {
        // Adding 1.5·2^52 pushes the fraction out; beyond 2^51 a binary64 number of turns has no useful fraction left.
        const PUSH: f64 = 6_755_399_441_055_744.0;
        if a.abs() < 2_251_799_813_685_248.0 { (a + PUSH) - PUSH } else { a.round_ties_even() }
    }
}

/// Dekker's product by Veltkamp splitting: exact without FMA. `const`, so tables can be made with it.
#[inline(always)]
pub(crate) const fn two_prod_split(a: f64, b: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0;
    let product = a * b;
    let (ta, tb) = (SPLITTER * a, SPLITTER * b);
    let (ah, bh) = (ta - (ta - a), tb - (tb - b));
    let (al, bl) = (a - ah, b - bh);
    (product, ((ah * bh - product) + ah * bl + al * bh) + al * bl)
}

/// Whether a polynomial is compiled with its highest degree only and not once for each: a page is sent, so there it counts.
/// The coefficients beyond a polynomial's own degree are 0, and the result is the same to the last bit.
pub(crate) const FEW_FORMS: bool = cfg!(target_arch = "wasm32");

/// A polynomial, its degree a constant at every call; coefficients beyond it are not looked at.
#[inline(always)]
pub(crate) fn horner<A: Arithmetic, const SIZE: usize>(coefficients: &[f64; SIZE], degree: usize, x: f64) -> f64 {
    let mut value = coefficients[degree];
    let mut k = degree;
    while k > 0 {
        k -= 1;
        value = A::mul_add(value, x, coefficients[k]);
    }
    value
}

/// Whether this processor takes the fused path. `KUGELPENDEL_PORTABLE=1` in the environment keeps to the portable one.
pub fn fused() -> bool {
    static FUSED: OnceLock<bool> = OnceLock::new();
    *FUSED.get_or_init(|| {
        if std::env::var_os("KUGELPENDEL_PORTABLE").is_some_and(|v| v != "0") {
            return false;
        }
        #[cfg(target_arch = "x86_64")]
        {
            std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma")
        }
        #[cfg(not(target_arch = "x86_64"))]
        {
            cfg!(target_arch = "aarch64")
        }
    })
}

/// The widest vectors that this processor has for numbers side by side, on the path that it takes.
pub(crate) fn widest() -> Instructions {
    match () {
        () if !fused() => Instructions::Common,
        #[cfg(target_arch = "x86_64")]
        () if std::arch::is_x86_feature_detected!("avx512f") => Instructions::Avx512,
        () => Fused::NEEDS,
    }
}

/// Makes `fn name(args) -> T`, which calls the generic `body::<Fused or Portable>(args)` compiled for this processor.
macro_rules! dispatch {
    ($(#[$meta:meta])* $vis:vis fn $name:ident $(<$life:lifetime>)? ($($arg:ident: $ty:ty),* $(,)?) $(-> $ret:ty)? = $body:path) => {
        $(#[$meta])*
        $vis fn $name $(<$life>)? ($($arg: $ty),*) $(-> $ret)? {
            #[cfg(target_arch = "x86_64")]
            {
                #[target_feature(enable = "avx2,fma")]
                fn vectors $(<$life>)? ($($arg: $ty),*) $(-> $ret)? {
                    $body($crate::numbers::arithmetic::Fused, $($arg),*)
                }
                if $crate::numbers::arithmetic::fused() {
                    // SAFETY: `fused()` has just asked the processor for AVX2 and FMA.
                    return unsafe { vectors($($arg),*) };
                }
            }
            #[cfg(target_arch = "aarch64")]
            if $crate::numbers::arithmetic::fused() {
                return $body($crate::numbers::arithmetic::Fused, $($arg),*);
            }
            $body($crate::numbers::arithmetic::Portable, $($arg),*)
        }
    };
}
pub(crate) use dispatch;

/// The product of two complex numbers.
#[inline(always)]
pub(crate) fn product<A: Arithmetic>([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [A::mul_add(a, c, -(b * d)), A::mul_add(a, d, b * c)]
}
