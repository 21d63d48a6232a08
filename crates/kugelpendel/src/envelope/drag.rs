//! Quadratic drag on a small elliptical swing, averaged: complete elliptic integrals by the arithmetic-geometric mean.
//!
//! With σ = √(p² + q² − 2pq cos 2Θ), the speed over ω0: p'/p = −(cω0/2)(H + q²G), q'/q = −(cω0/2)(H + p²G), where
//! H = ⟨σ⟩ and G = ⟨sin² 2Θ/σ⟩: the averages ⟨σ sin²⟩, ⟨σ cos²⟩ of docs/conventions.md in the circular amplitudes, regular
//! on the circle and in the plane. With A the larger of p, q and k the smaller over it, ∫ over a turn gives
//! ⟨σ⟩ = (2A/π)(2E(k) − (1 − k²)K(k)) and ⟨sin² 2Θ/σ⟩ = (2/3πAk²)(2k²K − (1 + k²)(K − E)); K − E from the mean's
//! own sums (DLMF 19.8). Air that turns with Ω blows with iΩ(x + iy): ±(cΩ/2)(H − q²G), ±(cΩ/2)(H − p²G).

/// c in 1/l, time in 1/ω0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quadratic {
    /// p'/p and q'/q over c.
    pub(super) decay: [f64; 2],
    /// What air that turns with Ω adds to them, over cΩ and −cΩ.
    pub(super) wind: [f64; 2],
}

impl Quadratic {
    pub(super) fn of(p: f64, q: f64) -> Self {
        let (larger, smaller) = (p.max(q), p.min(q));
        if larger == 0.0 {
            return Self { decay: [0.0; 2], wind: [0.0; 2] };
        }
        let k = smaller / larger;
        let k2 = k * k;
        // In the plane both integrals stay finite while the mean goes to zero: near enough to it they are the same.
        let (mut a, mut b) = (1.0, (1.0 - k2).max(1e-30).sqrt());
        // c_n over c_0 = k, and (K − E)/K over k².
        let (mut share, mut weight, mut sum) = (1.0, 1.0, 0.5);
        for _ in 0..12 {
            let mean = 0.5 * (a + b);
            share *= 0.25 * k * share / mean; // c_{n+1} = c_n²/4a_{n+1}
            (a, b) = (mean, (a * b).sqrt());
            sum += weight * share * share;
            weight *= 2.0;
            if share * share < 1e-18 {
                break;
            }
        }
        let mean_speed = larger * (1.0 + k2 - 2.0 * k2 * sum) / a;
        let weighted = (2.0 - (1.0 + k2) * sum) / (3.0 * a * larger);
        let half = |sign: f64, other: f64| 0.5 * (mean_speed + sign * other * other * weighted);
        Self { decay: [q, p].map(|other| -half(1.0, other)), wind: [q, p].map(|other| half(-1.0, other)) }
    }
}
