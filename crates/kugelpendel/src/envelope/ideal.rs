//! Frequency and precession of the ideal motion between two turning radii, and what linear drag does to them, in binary64.
//!
//! The sums are those of [`crate::exact::invariants::zeta`] and [`crate::exact::invariants::constants`]; here they are taken thousands of times, and the
//! last bits do not matter. Regular on the circle (one of the circular amplitudes 0) and in the plane (both alike).

use std::f64::consts::FRAC_1_SQRT_2;

/// Dimensionless: lengths in l, rates in ω0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ideal {
    /// ω of the swing in the turning frame.
    pub(super) frequency: f64,
    /// Ω of that frame.
    pub(super) precession: f64,
    /// p'/p and q'/q of the two circular amplitudes under a drag −2v: −1 for small swings.
    pub(super) decay: [f64; 2],
}

impl Ideal {
    /// The first-order brackets, Olsson's (25) and (26).
    pub(super) fn bracketed(p: f64, q: f64) -> Self {
        let (p2, q2) = (p * p, q * q);
        Self { frequency: 1.0 - 0.125 * (p2 + q2), precession: 0.375 * (p2 - q2), decay: [-1.0; 2] }
    }

    /// Of the radii a = p + q < 1 and b = p − q, of which the sign is the sense. With DECAY the last field is right too.
    pub(super) fn exact<const DECAY: bool>(p: f64, q: f64) -> Self {
        if p + q < 1e-9 {
            return Self::bracketed(p, q); // and nothing underflows
        }
        let height = |radius: f64| radius * radius / (1.0 + (1.0 - radius * radius).sqrt());
        let inner = (p - q).abs();
        let (high, low) = (height(p + q), height(inner));
        let sum = high + low;
        let rest = 2.0 - sum;
        let product = high * low;
        let third = 2.0 + product / rest;
        let range = 4.0 * p * q / rest; // high − low
        let low_depth = 2.0 - low;
        let lambda = inner * (2.0 * third * high / low_depth).sqrt();
        let eighth = 0.5 * FRAC_1_SQRT_2 * lambda;
        let share = eighth / ((2.0 - high) * low_depth);
        let (mut lower, mut upper) = (eighth / third, share * range);
        let mut sums = lower + share * (2.0 + rest);

        let (outer, inner) = ((third - low).sqrt(), (third - high).sqrt());
        let (mut a, mut b) = (0.5 * (outer + inner), (outer * inner).sqrt());
        // c_n over the range, so that what follows is right on the circle as well.
        let mut c = 0.25 / a;
        let (mut lag, mut weight) = (c * c, 2.0);
        let mut rung = range * c;
        for _ in 0..8 {
            let next = |w: f64| 0.5 * w * ((rung * rung + w * w) / (a * a + w * w)).sqrt();
            (lower, upper) = (next(lower), next(upper));
            sums += lower - upper;
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
            c *= rung / (4.0 * a);
            lag += weight * c * c;
            weight *= 2.0;
            rung = range * c;
            if rung.max(lower).max(upper) < 1e-9 {
                break;
            }
        }
        let decay = if DECAY { fading(sum, product, range, lag, [p, q]) } else { [-1.0; 2] };
        let sense = if p < q { -1.0 } else { 1.0 };
        Self { frequency: FRAC_1_SQRT_2 * a, precession: sense * FRAC_1_SQRT_2 * sums, decay }
    }
}

/// p'/p and q'/q under a drag −2v, from dλ/dt = −2λ and dε/dt = −2⟨v²⟩ = −4(ε − ⟨s⟩).
///
/// With S = s_a + s_b, w = s_a s_b, u = 2 − S, D = s_a − s_b: ε = S + w/u, λ² = w(4 + 2w/u), ⟨s⟩ = S/2 + lag·D², lag by
/// the same mean as the frequency (⟨sn²⟩ = (K − E)/mK; DLMF 19.8). a² + b² = 2S − S² + 2w, a²b² = w(2u + w),
/// a² − b² = Du. Solved for S' and w' once and for all, D²' has D² as a factor.
fn fading(sum: f64, w: f64, range: f64, lag: f64, [p, q]: [f64; 2]) -> [f64; 2] {
    let u = 2.0 - sum;
    let (r, r2) = (w / u, w / (u * u));
    let determinant = 4.0 * (1.0 + r + r2) + 2.0 * r * r2;
    let energy_rate = -4.0 * (0.5 * sum + r - lag * range * range);
    let slope = 4.0 + 2.0 * r; // λ²/w
    let sum_rate = 4.0 * (energy_rate * (1.0 + r) + r * slope) / determinant;
    let w_rate = 2.0 * w * (-2.0 * (1.0 + r2) * slope - r2 * energy_rate) / determinant;
    let range_share = -8.0 * ((1.0 + r) - 2.0 * lag * (sum * (1.0 + r) + r * r)) / determinant; // D'/D
    let product_share = range_share - sum_rate / u; // (pq)'/(pq)
    let squares_rate = 2.0 * (1.0 - sum) * sum_rate + 2.0 * w_rate;
    let area = (p * p - q * q).abs();
    let area_rate = if w > 0.0 { 0.5 * area * (w_rate / w + (w_rate - 2.0 * sum_rate) / (2.0 * u + w)) } else { 0.0 };
    let larger = p.max(q);
    let major = (squares_rate + 2.0 * area_rate) / (8.0 * larger * larger);
    let minor = product_share - major;
    if p >= q { [major, minor] } else { [minor, major] }
}
