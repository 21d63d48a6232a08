//! The exact harmonics.
//!
//! In the frame that turns with Ω the motion has the frequencies (2k + 1)ω only. In the complex plane of time x + iy has
//! one pole per cell, and it is double with no simple part: near it s = 2/u² + O(1) and x + iy = c/u² (1 + O(u²)), as
//! ṡ² = 2s³ + … and the equation of motion show. Its residue gives every Fourier coefficient at once, and
//! (x + iy)(x − iy) = s(2 − s) gives c. In units of l and 1/ω0, with the theta functions' arguments of `trigonometric`,
//!
//! ```text
//! x + iy = Σ 2ω ν_k/cosh((k + ½)L − η0 + η2) e^{iν_k t},   ν_k = Ω + (2k + 1)ω,   L = πK'/K,
//! s = s_b + Σ 8ω² n/sinh(nL) (1 − cos 2nωt),               both from a lowest point on.
//! ```
//!
//! Olsson's ansatz (20) is k = 0 and k = −1.

use crate::exact::chart::Chart;
use crate::exact::motion::ExactMotion;
use crate::exact::phase::Phase;
use crate::given::invalid::{Invalid, require};
use std::f64::consts::{PI, TAU};

/// One term, amplitude·exp(i·frequency·t).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Harmonic {
    /// Multiple of ω in the turning frame, signed.
    pub order: i32,
    /// The frequency, rad/s.
    pub frequency: f64,
    /// (real, imaginary) part, m.
    pub amplitude: [f64; 2],
}

/// The motion as a sum of harmonics.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum {
    /// x + iy = Σ; orders −(2n − 1), …, −1, 1, …, 2n − 1 and frequencies Ω + order·ω.
    pub plan: Vec<Harmonic>,
    /// z = Re Σ; orders 0, 2, …, 2n and frequencies order·ω.
    pub vertical: Vec<Harmonic>,
}

/// L, the arguments' difference L/2 − η0 + η2, phase of the swing and azimuth of the frame at the launch.
struct Poles {
    span: f64,
    offset: f64,
    phase: f64,
    azimuth: f64,
}

impl ExactMotion {
    /// The first `pairs` pairs of harmonics in the plan view, and as many in the height besides the mean.
    ///
    /// # Errors
    /// On the separatrix, where the motion does not repeat.
    pub fn spectrum(&self, pairs: usize) -> Result<Spectrum, Invalid> {
        let poles = self.poles()?;
        let length = self.pendulum.length;
        let (sense, omega0) = (self.invariants.sense, self.omega0.hi);
        let (omega, precession) = (self.invariants.frequency.hi, self.invariants.precession.hi);
        let (still, revolves) = (self.launch.still, self.invariants.revolves());
        let pairs = pairs as i32;
        let plan = (-pairs..pairs).map(|k| {
            let frequency = precession + f64::from(2 * k + 1) * omega;
            let argument = if k == 0 { poles.offset } else { f64::from(k) * poles.span + poles.offset };
            let size = if still { 0.0 } else { 2.0 * length * omega * frequency / argument.cosh() };
            let (sin, cos) = (f64::from(2 * k + 1) * poles.phase).sin_cos();
            let (azimuth_sin, azimuth_cos) = poles.azimuth.sin_cos();
            let (re, im) = (size * cos, sense * size * sin);
            Harmonic {
                order: sense as i32 * if revolves { k + 1 } else { 2 * k + 1 },
                frequency: sense * frequency * omega0,
                amplitude: [re * azimuth_cos - im * azimuth_sin, re * azimuth_sin + im * azimuth_cos],
            }
        });
        let mut plan: Vec<_> = plan.collect();
        plan.sort_by_key(|harmonic| harmonic.order);

        let weight = |n: i32| 8.0 * length * omega * omega * f64::from(n) / (f64::from(n) * poles.span).sinh();
        let lowest = length * self.invariants.turning.low;
        let first = weight(1);
        let mean: f64 = (1..).map(weight).take_while(|w| *w > 1e-17 * first).sum();
        let mut vertical = vec![Harmonic { order: 0, frequency: 0.0, amplitude: [length - lowest - mean, 0.0] }];
        vertical.extend((1..=pairs).map(|n| {
            let (sin, cos) = (f64::from(2 * n) * poles.phase).sin_cos();
            Harmonic {
                order: if revolves { n } else { 2 * n },
                frequency: f64::from(2 * n) * omega * omega0,
                amplitude: [weight(n) * cos, weight(n) * sin],
            }
        }));
        Ok(Spectrum { plan, vertical })
    }

    fn poles(&self) -> Result<Poles, Invalid> {
        let at_launch = self.phase();
        let (chart, turn) = self.chart(&at_launch);
        let phase = if let Phase::Periodic { start, .. } = at_launch { PI * start.hi } else { 0.0 };
        Ok(match chart {
            Chart::Trigonometric(chart) => {
                let [nome, lower_reduced, upper] = chart.poles;
                let span = -nome.ln();
                // L/2 − η0 = −½ ln(q e^{2η0}), finite on cones
                let from_lower = -0.5 * lower_reduced.ln();
                let upper = if chart.from_above { 0.5 * span - upper } else { upper };
                let ahead = if chart.from_above { self.invariants.sense * phase } else { 0.0 };
                Poles { span, offset: from_lower + upper, phase, azimuth: TAU * turn + ahead }
            }
            Chart::Hyperbolic(chart) => {
                require(chart.span.is_finite(), || Invalid::Separatrix { energy: self.energy() })?;
                let span = PI * PI / chart.span;
                let offset = 0.5 * span - chart.argument_difference() * span / PI;
                Poles { span, offset, phase, azimuth: TAU * turn }
            }
            Chart::Still(_) => Poles { span: f64::INFINITY, offset: f64::INFINITY, phase, azimuth: 0.0 },
        })
    }
}
