//! Quadratic drag, averaged over a swing of any amplitude.
//!
//! Drag −f(|v|)v takes X' = −⟨f⟩X − Cov(v², f)/2ω, and the same from Y: with f = |v| the mean speed and one covariance are
//! all that is asked. With s = (s_a + s_b)/2 + (D/2) cos φ, v² = V(1 − κ cos φ) and dt ∝ dφ/√(1 − μ cos φ). Over φ the
//! trapezoidal rule converges like powers of (1 − √(1 − κ²))/κ; next to the plane, where κ → 1 and the speed at the outer
//! turning points goes to zero, what is not smooth there is taken off before and its integrals are known: with
//! Y = 1 − κ cos φ, those of Y^(n + ½) follow from two by Legendre's recurrence, (ν + 1)m_{ν+1} = (2ν + 1)m_ν − ν(1 − κ²)m_{ν−1}.

use crate::numbers::landen::Landen;
use std::f64::consts::PI;
use std::sync::LazyLock;

/// Points of the rule on half a turn.
const POINTS: usize = 16;

/// Their cosines.
static NODES: LazyLock<[f64; POINTS]> =
    LazyLock::new(|| std::array::from_fn(|k| (PI * (k as f64 + 0.5) / POINTS as f64).cos()));

/// Above this κ the speed is not smooth enough for the rule by itself.
const THIN: f64 = 0.7;

/// Of the swing between two turning points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Speeds {
    /// ⟨|v|⟩.
    pub(super) mean: f64,
    /// Cov(v², |v|) over (s_a − s_b)².
    pub(super) covariance: f64,
}

impl Speeds {
    /// From the squares of the half-angle amplitudes.
    pub(super) fn of(x: f64, y: f64) -> Self {
        let sum = x + y;
        let rest = 2.0 - sum;
        let ratio = 0.25 * (x - y) * (x - y) / rest;
        let range = 2.0 * (x * y).sqrt();
        let square = sum + 2.0 * ratio; // V
        if square == 0.0 {
            return Self { mean: 0.0, covariance: 0.0 };
        }
        let kappa = (range / square).min(1.0);
        let mu = 0.5 * range / (2.0 + ratio - 0.5 * sum);
        let speed = square.sqrt();
        // Over the nodes: w = 1/√(1 − μ cos φ), and √Y.
        let nodes = &*NODES;
        let weights = nodes.map(|cos| 1.0 / (1.0 - mu * cos).sqrt());
        let roots = nodes.map(|cos| (1.0 - kappa * cos).max(0.0).sqrt());
        let mean = |values: [f64; POINTS]| values.iter().sum::<f64>() / POINTS as f64;
        let total = mean(weights);
        let centre = mean(std::array::from_fn(|k| weights[k] * nodes[k])) / total;
        if kappa <= THIN {
            let slow = mean(std::array::from_fn(|k| weights[k] * roots[k])) / total;
            // √Y − 1 over −κ, and Y over −κ: nothing cancels on the circle.
            let both = |k: usize| weights[k] * (nodes[k] - centre) * nodes[k] / (roots[k] + 1.0);
            let apart = mean(std::array::from_fn(both)) / total;
            return Self { mean: speed * slow, covariance: apart / speed };
        }
        let Thin { series, moments } = Thin::new(kappa, mu);
        let known =
            |n: usize| series.iter().zip(&moments[n..]).map(|(coefficient, moment)| coefficient * moment).sum::<f64>();
        let rest: [f64; POINTS] = std::array::from_fn(|k| {
            let y = roots[k] * roots[k];
            roots[k] * (weights[k] - (series[0] + y * (series[1] + y * series[2])))
        });
        let slow = (mean(rest) + known(0)) / total;
        let cubed = (mean(std::array::from_fn(|k| rest[k] * roots[k] * roots[k])) + known(1)) / total; // of Y√Y
        // Cov(Y, √Y) = ⟨Y√Y⟩ − ⟨Y⟩⟨√Y⟩, and κ² of it belongs to the range.
        let covariance = (cubed - (1.0 - kappa * centre) * slow) / (kappa * kappa);
        Self { mean: speed * slow, covariance: covariance / speed }
    }

    /// Of small swings with these circular amplitudes.
    pub(super) fn of_small(p: f64, q: f64) -> Self {
        let DragAverage { mean, weighted } = DragAverage::of(p, q);
        Self { mean, covariance: 0.5 * weighted }
    }
}

/// What is not smooth next to the plane, w expanded in powers of Y with what is known of these.
struct Thin {
    /// Coefficients of w in Y.
    series: [f64; 3],
    /// Means of Y^(n + ½) over φ.
    moments: [f64; 4],
}

impl Thin {
    fn new(kappa: f64, mu: f64) -> Self {
        let (sum, difference) = ((1.0 + kappa).sqrt(), (1.0 - kappa).sqrt());
        let DragAverage { mean, weighted } = DragAverage::of(0.5 * (sum + difference), 0.5 * (sum - difference));
        let mut moments = [mean, mean + 0.5 * kappa * kappa * weighted, 0.0, 0.0];
        for n in 1..3 {
            let order = n as f64 + 0.5;
            let last = order * (1.0 - kappa * kappa) * moments[n - 1];
            moments[n + 1] = ((2.0 * order + 1.0) * moments[n] - last) / (order + 1.0);
        }
        // 1 − μ cos φ = g + hY.
        let (g, h) = (1.0 - mu / kappa, mu / kappa);
        let first = 1.0 / g.sqrt();
        let second = -0.5 * first * h / g;
        Self { series: [first, second, -0.75 * second * h / g], moments }
    }
}

/// Averages over the angle of σ = √(p² + q² − 2pq cos 2Θ), the speed of a harmonic swing over ω0.
///
/// With A the larger of p, q and k the smaller over it, ⟨σ⟩ = (2A/π)(2E(k) − (1 − k²)K(k)) and
/// ⟨sin² 2Θ/σ⟩ = (2/3πAk²)(2k²K − (1 + k²)(K − E)); K − E from the mean's own sums (DLMF 19.8).
#[derive(Clone, Copy, Debug)]
struct DragAverage {
    /// ⟨σ⟩.
    mean: f64,
    /// ⟨sin² 2Θ/σ⟩.
    weighted: f64,
}

impl DragAverage {
    fn of(p: f64, q: f64) -> Self {
        let (larger, smaller) = (p.max(q), p.min(q));
        if larger == 0.0 {
            return Self { mean: 0.0, weighted: 0.0 };
        }
        let k = smaller / larger;
        let k2 = k * k;
        // In the plane both integrals stay finite while the mean goes to zero: near enough to it they are the same.
        let mut landen = Landen { a: 1.0, b: (1.0 - k2).max(1e-30).sqrt(), c: 1.0 };
        // c_n over k, c_n being k^(2^n) times what the steps have; and (K − E)/K over k².
        let (mut power, mut weight, mut sum) = (1.0, 1.0, 0.5);
        for _ in 0..12 {
            landen = landen.next();
            power = k * (power * power);
            let share = power * landen.c;
            sum += weight * share * share;
            weight *= 2.0;
            if share * share < 1e-18 {
                break;
            }
        }
        let a = landen.a;
        Self { mean: larger * (1.0 + k2 - 2.0 * k2 * sum) / a, weighted: (2.0 - (1.0 + k2) * sum) / (3.0 * a * larger) }
    }
}

/// What air that turns with Ω adds to A±'/A±, over cΩ and −cΩ, for small swings: it blows with iΩ(x + iy).
#[derive(Clone, Copy, Debug)]
pub(super) struct Wind(pub(super) [f64; 2]);

impl Wind {
    pub(super) fn of(p: f64, q: f64) -> Self {
        let DragAverage { mean, weighted } = DragAverage::of(p, q);
        Self([q, p].map(|other| 0.5 * (mean - other * other * weighted)))
    }
}
