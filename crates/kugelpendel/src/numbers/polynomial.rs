//! Real zeros of short polynomials, and their values.

use crate::numbers::arithmetic::Portable;
use crate::numbers::roots::zero_between;

/// The highest power is below this one.
const MOST: usize = 6;

/// The value at `x` of a polynomial with the coefficients c₀, c₁, … .
pub(crate) fn value(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * x + coefficient)
}

/// Where the polynomial changes its sign between `low` and `high`, in ascending order.
///
/// Between the zeros of its derivative a polynomial is monotone, so each stretch between two of these holds at most one
/// zero. A zero that is touched and not crossed is none here.
pub(crate) fn zeros(coefficients: &[f64], low: f64, high: f64) -> Vec<f64> {
    let highest = coefficients.iter().rposition(|coefficient| *coefficient != 0.0).unwrap_or(0);
    debug_assert!(highest < MOST, "a polynomial of degree {highest} is too long for this");
    if highest == 0 {
        return Vec::new();
    }
    let coefficients = &coefficients[..=highest];
    let slope: Vec<f64> = coefficients.iter().enumerate().skip(1).map(|(power, c)| power as f64 * c).collect();
    let mut edges = vec![low];
    edges.extend(zeros(&slope, low, high));
    edges.push(high);
    let mut found: Vec<f64> = Vec::new();
    for pair in edges.windows(2) {
        if let Some(zero) = between(coefficients, pair[0], pair[1])
            && found.last() != Some(&zero)
        {
            found.push(zero);
        }
    }
    found
}

fn between(coefficients: &[f64], low: f64, high: f64) -> Option<f64> {
    let polynomial = |x: f64| value(coefficients, x);
    let values = [low, high].map(polynomial);
    match values {
        [0.0, _] => Some(low),
        [_, 0.0] => Some(high),
        // A NaN has no sign.
        [first, last] if first.is_nan() || last.is_nan() || (first < 0.0) == (last < 0.0) => None,
        [first, _] => {
            let sign = if first < 0.0 { 1.0 } else { -1.0 };
            Some(zero_between::<Portable>(&polynomial, sign, [low, high], values.map(|value| sign * value)))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{value, zeros};

    #[test]
    fn zeros_that_are_known() {
        // (x − 1)(x + 2)(x − 1/2)(x − 4)
        let quartic = [-4.0, 11.0, -4.5, -3.5, 1.0];
        let found = zeros(&quartic, -3.0, 5.0);
        assert_eq!(found.len(), 4);
        for (zero, known) in found.iter().zip([-2.0, 0.5, 1.0, 4.0]) {
            assert!((zero - known).abs() < 1e-14, "{zero} for {known}");
        }
        assert_eq!(zeros(&quartic, -1.0, 0.75).len(), 1);
    }

    #[test]
    fn neither_touched_nor_missing_zeros_are_found() {
        assert!(zeros(&[1.0, 0.0, 1.0], -5.0, 5.0).is_empty());
        assert!(zeros(&[3.0], -5.0, 5.0).is_empty());
        assert!(zeros(&[0.0; 5], -5.0, 5.0).is_empty());
        assert_eq!(zeros(&[-3.0, 2.0, 0.0, 0.0, 0.0], -5.0, 5.0), [1.5]);
    }

    #[test]
    fn zeros_far_below_one_keep_their_digits() {
        let found = zeros(&[1e-40, -1.0, 0.5], 0.0, 1.0);
        assert!((found[0] / 1e-40 - 1.0).abs() < 1e-12, "{found:?}");
        assert!(value(&[1e-40, -1.0, 0.5], found[0]).abs() < 1e-52);
    }
}
