//! A push away from the axis once in each half swing, averaged.
//!
//! It leaves the angular momentum as it is and adds push·dρ/dt + (push cos θ)²/2 to the energy, at any amplitude; what
//! it does to plane and phase is that of small swings: Δ(x + iy)' = push·(x + iy)/ρ, seen from A±.

use crate::given::drive::Drive;
use std::f64::consts::{FRAC_PI_2, PI};

/// B±' over e^{i arg B±}: the real parts are p' and q'. None where there is no push in this swing, or no swing.
pub(super) fn averaged(drive: &Drive, p: f64, q: f64, frequency: f64) -> Option<[[f64; 2]; 2]> {
    let height = |square: f64| square / (1.0 + (1.0 - square).sqrt());
    let (outer, inner) = ((p + q) * (p + q), (p - q) * (p - q));
    let (high, low) = (height(outer), height(inner));
    let (sum, product) = (high + low, high * low);
    let rest = 2.0 - sum;
    let range = 4.0 * p * q / rest; // high − low
    if range <= 0.0 {
        return None; // a circle passes no closest point
    }
    let third = 2.0 + product / rest;
    // Height of the push, and 2Θ there, Θ from an outer turning point.
    let (push, at, [cos, sin]) = match *drive {
        Drive::Absent => return None,
        Drive::Phase { push, phase } => {
            let angle = phase * frequency;
            // sn by the first two terms of its Fourier series, q = m/16 + m²/32: DLMF 22.11.1.
            let m = range / (third - low);
            let nome = m * (2.0 + m) / 32.0;
            let sn = (angle.sin() + nome * (3.0 * angle).sin()) / (1.0 - nome);
            let (sin, cos) = (2.0 * (FRAC_PI_2 + angle)).sin_cos();
            (push, low + range * (sn * sn).min(1.0), [cos, sin])
        }
        Drive::Radius { push, radius } => {
            let square = radius * radius;
            if !(inner..=outer).contains(&square) {
                return None;
            }
            // ρ² = p² + q² + 2pq cos 2Θ, and ρ grows where sin 2Θ < 0.
            let cos = ((square - p * p - q * q) / (2.0 * p * q)).clamp(-1.0, 1.0);
            (push, height(square), [cos, -(1.0 - cos * cos).sqrt()])
        }
    };
    let rising = (2.0 * ((at - low) * (high - at)).max(0.0) * (third - at)).sqrt(); // |ds/dt|
    let (depth, radius_squared) = (1.0 - at, at * (2.0 - at));
    let outward = if radius_squared > 0.0 {
        depth * if sin > 0.0 { -rising } else { rising } / radius_squared.sqrt()
    } else {
        (2.0 * high * third).sqrt() // straight through the lowest point
    };
    let gain = frequency / PI * push * (outward + 0.5 * push * depth * depth);

    // From ε = S + w/u and λ² = w(4 + 2w/u) at constant λ; S, w, u, D as in `ideal`.
    let (r, r2) = (product / rest, product / (rest * rest));
    let determinant = 4.0 * (1.0 + r + r2) + 2.0 * r * r2;
    let (sum_rate, product_rate) = (4.0 * gain * (1.0 + r) / determinant, -2.0 * product * r2 * gain / determinant);
    let squares_rate = 2.0 * (1.0 - sum) * sum_rate + 2.0 * product_rate; // of a² + b²
    let area = (p * p - q * q).abs(); // |ab| = √(w(2u + w))
    let per_product = if product > 0.0 { product_rate / product } else { 0.0 };
    let area_rate = 0.5 * area * (per_product + (product_rate - 2.0 * sum_rate) / (2.0 * rest + product));
    let larger_rate = (squares_rate + 2.0 * area_rate) / (8.0 * p.max(q));
    let range_rate = (sum * sum_rate - 2.0 * product_rate) / range;
    let both_rate = 0.25 * (range_rate * rest - range * sum_rate); // of pq
    let smaller_rate = (both_rate - larger_rate * p.min(q)) / p.max(q);
    let [first, second] = if p >= q { [larger_rate, smaller_rate] } else { [smaller_rate, larger_rate] };

    // ±(1/2i) push e^{∓iΘ}(x + iy)/ρ: the imaginary parts.
    let sideways = |own: f64, other: f64| {
        let (re, im) = (own + other * cos, other * sin);
        let radius = re.hypot(im);
        if radius > 0.0 { 0.5 * frequency / PI * push * re / radius } else { 0.0 }
    };
    Some([[first, -sideways(p, q)], [second, sideways(q, p)]])
}
