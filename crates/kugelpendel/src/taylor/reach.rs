//! How far a series may be followed, by its last two terms.

use crate::taylor::series::{ORDER, RECIPROCALS};

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
