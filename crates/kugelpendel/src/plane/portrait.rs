//! The portrait on the sphere: what an uneven clamp does to the plane of every swing of one size.
//!
//! The shape of an ellipse is put on a sphere as polarised light is on Poincaré's: its latitude has the sine
//! u = 2ab/(a² + b²), its longitude is φ = 2(ψ − χ), twice the azimuth from the axis of the clamp. The poles are circles, the
//! equator are straight swings. Without drag and drive the averaged equations keep a² + b², and with
//! μ = (3/8)ω0 n(1 + 7n/32), n = (a² + b²)/l²,
//!
//! > u' = δ√(1−u²) sin φ,  φ' = −2Ω_z + μu − δ(u/√(1−u²)) cos φ,  H = δ√(1−u²) cos φ − 2Ω_z u + μu²/2 is constant.
//!
//! From here on everything is algebra: u'² = δ²(1−u²) − G(u)², G = h + 2Ω_z u − μu²/2, is of the fourth degree in u.
//!
//! Sources: H. Kamerlingh Onnes (1879); E. O. Schulz-DuBois, Am. J. Phys. 38, 173 (1970); N. N. Salva and H. R. Salva,
//! arXiv:2502.12230 (2025); the second term of μ is the next order of the precession of the exact motion.

use crate::given::forces::Forces;
use crate::given::pendulum::Pendulum;
use crate::numbers::elliptic::Ladder;
use crate::numbers::polynomial::{value, zeros};
use std::f64::consts::{PI, TAU};

/// Swings of one size in one clamp on one ground; rates in rad/s, positive counter-clockwise seen from above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Portrait {
    /// The vertical part of the ground's rotation, Ω_z.
    pub rotation: f64,
    /// By how much the frequency along the axis of the clamp is higher than across it, δ.
    pub anisotropy: f64,
    /// The azimuth of that axis, χ, rad.
    pub axis: f64,
    /// What a circle of this size turns by itself, times two: μ.
    pub intrinsic: f64,
}

/// A place on the sphere: the shape and direction of an ellipse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EllipseForm {
    /// u = 2ab/(a² + b²), from −1 (a circle run through clockwise) by 0 (a straight swing) to 1.
    pub circularity: f64,
    /// φ = 2(ψ − χ), rad.
    pub longitude: f64,
}

impl EllipseForm {
    /// a and b over √(a² + b²): with u = sin β these are cos ½β and sin ½β.
    pub fn semi_axes(&self) -> [f64; 2] {
        let (sin, cos) = (0.5 * self.circularity.asin()).sin_cos();
        [cos, sin]
    }
}

/// What the plane does for ever after, without drag and drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The plane goes round and round.
    Round,
    /// The plane turns back again and again.
    ToAndFro,
    /// The ellipse keeps its shape and its direction.
    Stands,
}

/// The path of one shape over the sphere: closed, and gone through again and again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit {
    /// H, rad/s.
    pub invariant: f64,
    /// Least and largest circularity on the way.
    pub limits: [f64; 2],
    /// Whether the plane goes round.
    pub verdict: Verdict,
    /// Time once round the orbit, s; the plane of a swing that goes round turns by half a turn in it. Infinite on the
    /// separatrix.
    pub period: f64,
    /// Mean rate of the plane, rad/s; 0 where it swings to and fro.
    pub rate: f64,
    /// The rate of the plane where it is least in the sense of the Earth's, rad/s.
    pub slowest: f64,
    /// The rate of the plane where it is largest in the sense of the Earth's, rad/s.
    pub fastest: f64,
    /// Azimuths between which a plane swings to and fro, rad; infinite for one that goes round.
    pub azimuths: [f64; 2],
}

/// A shape that stays as it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equilibrium {
    /// The shape itself.
    pub form: EllipseForm,
    /// Whether neighbours stay near it; otherwise it is a saddle, through which the separatrix runs.
    pub stable: bool,
}

impl Portrait {
    /// Of all ellipses with the a² + b² of the given one, m. Only the rotation and the anisotropy of the forces count.
    pub fn new(pendulum: &Pendulum, forces: &Forces, a: f64, b: f64) -> Self {
        let omega0 = pendulum.angular_frequency();
        Self {
            rotation: forces.rotation[1],
            // The frequency along the axis is √(ω0² + 2ω0δ).
            anisotropy: omega0 * ((1.0 + 2.0 * forces.anisotropy / omega0).sqrt() - 1.0),
            axis: forces.axis,
            intrinsic: intrinsic(omega0, (a * a + b * b) / (pendulum.length * pendulum.length)),
        }
    }

    /// Where an ellipse lies on the sphere: a and b in m, b with the sign of the sense, the azimuth in rad.
    pub fn form(&self, a: f64, b: f64, azimuth: f64) -> EllipseForm {
        EllipseForm { circularity: 2.0 * a * b / (a * a + b * b), longitude: 2.0 * (azimuth - self.axis) }
    }

    /// H, rad/s.
    pub fn invariant(&self, form: EllipseForm) -> f64 {
        let (u, straight) = (form.circularity, straightness(form.circularity));
        self.anisotropy * straight * form.longitude.cos() - 2.0 * self.rotation * u + 0.5 * self.intrinsic * u * u
    }

    /// The rate of the plane of a shape, φ'/2, rad/s; infinite on a circle, which has no plane.
    pub fn rate(&self, form: EllipseForm) -> f64 {
        let u = form.circularity;
        let clamp = if self.anisotropy == 0.0 || u == 0.0 {
            0.0
        } else {
            self.anisotropy * u / straightness(u) * form.longitude.cos()
        };
        0.5 * (self.intrinsic * u - clamp) - self.rotation
    }

    /// The orbit on which a shape moves.
    pub fn orbit(&self, start: EllipseForm) -> Orbit {
        let h = self.invariant(start);
        let u = start.circularity;
        if self.anisotropy == 0.0 {
            return self.undisturbed(start, h);
        }
        let speed = Speed::at(self, start);
        let [back, ahead] = [speed.end(u, -1.0), speed.end(u, 1.0)];
        let limits = [(u + back).max(-1.0), (u + ahead).min(1.0)];
        let (sides, rate) = ([speed.side(back), speed.side(ahead)], self.rate(start));
        let verdict = if back == 0.0 && ahead == 0.0 {
            Verdict::Stands
        } else if sides[0] == sides[1] {
            Verdict::ToAndFro
        } else {
            Verdict::Round
        };
        let period = speed.period(back, ahead);
        let [slowest, fastest] = if verdict == Verdict::Stands { [rate; 2] } else { self.extremes(h, limits) };
        let sense = match verdict {
            // At its lowest latitude an orbit round the pole goes the way in which it goes round.
            Verdict::Round => self.rate_on(h, limits[0]).signum(),
            _ => 0.0,
        };
        let azimuths = if verdict == Verdict::Round {
            [f64::NEG_INFINITY, f64::INFINITY]
        } else {
            self.reach(h, limits, sides[0], start)
        };
        Orbit { invariant: h, limits, verdict, period, rate: sense * PI / period, slowest, fastest, azimuths }
    }

    /// So many places along the orbit of a shape, at least 2, once round in the sense in which it is run through; longitudes
    /// from −π to π. Evenly apart in an angle that goes round the orbit, not in time.
    pub fn path(&self, start: EllipseForm, count: usize) -> Vec<EllipseForm> {
        let Orbit { invariant, limits: [low, high], rate, .. } = self.orbit(start);
        let turn = |k: usize| TAU * k as f64 / (count.max(2) - 1) as f64;
        let place = |k: usize| {
            if self.anisotropy == 0.0 {
                let longitude = (PI - turn(k)).copysign((PI - turn(k)) * -rate.signum());
                return EllipseForm { circularity: start.circularity, longitude };
            }
            let (sin, cos) = turn(k).sin_cos();
            let u = 0.5 * ((low + high) - (high - low) * cos);
            let g = value(&[invariant, 2.0 * self.rotation, -0.5 * self.intrinsic], u);
            let cosine = (g / (self.anisotropy * straightness(u))).clamp(-1.0, 1.0);
            // u grows where δ sin φ > 0.
            EllipseForm { circularity: u, longitude: cosine.acos().copysign(sin * self.anisotropy) }
        };
        (0..count).map(place).collect()
    }

    /// Without a clamp the ellipse keeps its shape.
    fn undisturbed(&self, start: EllipseForm, h: f64) -> Orbit {
        let rate = self.rate(start);
        let azimuth = 0.5 * start.longitude + self.axis;
        let (verdict, azimuths) = if rate == 0.0 {
            (Verdict::Stands, [azimuth; 2])
        } else {
            (Verdict::Round, [f64::NEG_INFINITY, f64::INFINITY])
        };
        let limits = [start.circularity; 2];
        Orbit { invariant: h, limits, verdict, period: PI / rate.abs(), rate, slowest: rate, fastest: rate, azimuths }
    }

    /// The rate of the plane at the circularity u of the orbit with the invariant h.
    fn rate_on(&self, h: f64, u: f64) -> f64 {
        // −Ω_z + μu/2 − uG/2(1−u²) over one denominator.
        let above = [-2.0 * self.rotation, self.intrinsic - h, 0.0, -0.5 * self.intrinsic];
        value(&above, u) / (2.0 * (1.0 - u) * (1.0 + u))
    }

    /// Least and largest rate of the plane on the orbit, in the sense in which the Earth turns it.
    fn extremes(&self, h: f64, [low, high]: [f64; 2]) -> [f64; 2] {
        let way = if self.rotation > 0.0 { -1.0 } else { 1.0 };
        let (mu, rest) = (self.intrinsic, self.intrinsic - h);
        let stationary = [rest, -4.0 * self.rotation, rest - 1.5 * mu, 0.0, 0.5 * mu];
        let mut rates = vec![way * self.rate_on(h, low), way * self.rate_on(h, high)];
        rates.extend(zeros(&stationary, low, high).into_iter().map(|u| way * self.rate_on(h, u)));
        [
            way * rates.iter().copied().fold(f64::INFINITY, f64::min),
            way * rates.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        ]
    }

    /// The azimuths between which the plane swings to and fro, on the side of the axis where cos φ has the sign `side`, next to
    /// the start.
    fn reach(&self, h: f64, [low, high]: [f64; 2], side: f64, start: EllipseForm) -> [f64; 2] {
        let turning = [-2.0 * self.rotation, self.intrinsic - h, 0.0, -0.5 * self.intrinsic];
        let cosine = |u: f64| {
            let g = value(&[h, 2.0 * self.rotation, -0.5 * self.intrinsic], u);
            (side * g / (self.anisotropy * straightness(u))).clamp(-1.0, 1.0)
        };
        let least = zeros(&turning, low, high).into_iter().map(cosine).fold(1.0, f64::min);
        let wide = 0.5 * least.acos();
        let middle = if side > 0.0 { 0.0 } else { PI };
        let turns = ((start.longitude - middle) / TAU).round();
        let centre = self.axis + 0.5 * middle + PI * turns;
        [centre - wide, centre + wide]
    }

    /// The shapes that stay as they are: two that are stable, or three and a saddle.
    pub fn equilibria(&self) -> Vec<Equilibrium> {
        let (delta, mu, turn) = (self.anisotropy, self.intrinsic, 2.0 * self.rotation);
        // (μu − 2Ω_z)√(1−u²) = ±δu, squared.
        let square = [turn * turn, -2.0 * mu * turn, mu * mu];
        let polynomial = [square[0], square[1], square[2] - square[0] - delta * delta, -square[1], -square[2]];
        let mut found = Vec::new();
        for u in zeros(&polynomial, -1.0, 1.0) {
            let straight = straightness(u);
            for (side, longitude) in [(1.0, 0.0), (-1.0, PI)] {
                let (push, pull) = ((mu * u - turn) * straight, side * delta * u);
                // Only one of the two signs solves the equation itself; on the equator, without rotation, both do.
                if (push - pull).abs() <= (push + pull).abs() {
                    let curved = mu - side * delta / (straight * straight * straight);
                    found.push(Equilibrium {
                        form: EllipseForm { circularity: u, longitude },
                        stable: side * delta * curved < 0.0,
                    });
                }
            }
        }
        found
    }
}

/// The least |δ| in rad/s with which the plane of some straight swing of this size does not go round.
///
/// From u = 0 it is the swing across the axis of the higher frequency that comes to its end first: it goes round if
/// 2|Ω_z|u − μu²/2 reaches |δ|(1 + √(1−u²)) somewhere. With u = 2t/(1 + t²) this is
/// |δ| < 2|Ω_z| max (t − m t²/(1 + t²)) over 0 ≤ t ≤ 1, m = μ/2|Ω_z|: 2|Ω_z| for small swings, Ω_z²/μ for large ones.
pub fn critical_anisotropy(rotation: f64, intrinsic: f64) -> f64 {
    let turn = 2.0 * rotation.abs();
    if turn == 0.0 {
        return 0.0;
    }
    let m = intrinsic / turn;
    let share = |t: f64| t - m * t * t / (1.0 + t * t);
    // (1 + t²)² = 2mt
    let stationary = zeros(&[1.0, -2.0 * m, 2.0, 0.0, 1.0], 0.0, 1.0);
    turn * stationary.into_iter().map(share).fold(share(1.0), f64::max)
}

/// The largest amplitude in m of which every straight swing goes round; 0 where none does, infinite without a clamp.
///
/// The same solved for m: the largest (t − x)(1 + 1/t²) over x ≤ t ≤ 1, x = |δ|/2|Ω_z|, stationary where t³ − t + 2x = 0.
pub fn critical_amplitude(pendulum: &Pendulum, rotation: f64, anisotropy: f64) -> f64 {
    let turn = 2.0 * rotation.abs();
    if anisotropy == 0.0 {
        return f64::INFINITY;
    }
    let x = anisotropy.abs() / turn;
    if x >= 1.0 || x.is_nan() {
        return 0.0;
    }
    let share = |t: f64| (t - x) * (1.0 + 1.0 / (t * t));
    let stationary = zeros(&[2.0 * x, -1.0, 0.0, 1.0], x, 1.0);
    let m = stationary.into_iter().map(share).fold(share(1.0), f64::max);
    // μ = (3/8)ω0 n(1 + 7n/32) = m·2|Ω_z|.
    let first = 8.0 / 3.0 * m * turn / pendulum.angular_frequency();
    pendulum.length * (2.0 * first / (1.0 + (1.0 + 7.0 / 8.0 * first).sqrt())).sqrt()
}

/// μ of swings with (a² + b²)/l² = `size`, rad/s, to the second order.
pub fn intrinsic(omega0: f64, size: f64) -> f64 {
    0.375 * omega0 * size * (1.0 + 7.0 / 32.0 * size)
}

/// √(1 − u²), which is (a² − b²)/(a² + b²).
fn straightness(u: f64) -> f64 {
    ((1.0 - u) * (1.0 + u)).max(0.0).sqrt()
}

/// u'² as a polynomial in the distance from the start, so that an end which is near keeps its digits.
struct Speed {
    anisotropy: f64,
    /// G at the start and its derivatives over their factorials.
    g: [f64; 3],
    square: [f64; 5],
}

impl Speed {
    fn at(portrait: &Portrait, start: EllipseForm) -> Self {
        let u = start.circularity;
        let (delta, straight) = (portrait.anisotropy, straightness(u));
        let (sin, cos) = start.longitude.sin_cos();
        let g = [delta * straight * cos, 2.0 * portrait.rotation - portrait.intrinsic * u, -0.5 * portrait.intrinsic];
        let fast = delta * straight * sin;
        let square = [
            fast * fast,
            -2.0 * (delta * delta * u + g[0] * g[1]),
            -delta * delta - g[1] * g[1] - 2.0 * g[0] * g[2],
            -2.0 * g[1] * g[2],
            -g[2] * g[2],
        ];
        Self { anisotropy: delta, g, square }
    }

    /// How far the orbit goes from the start at u, upwards or downwards.
    fn end(&self, u: f64, way: f64) -> f64 {
        let mirrored: Vec<f64> =
            self.square.iter().enumerate().map(|(k, c)| if k % 2 == 1 { way * c } else { *c }).collect();
        let most = (1.0 - way * u).max(0.0);
        // At an end already: it leads away from there on one side only.
        let polynomial = if mirrored[0] != 0.0 {
            &mirrored[..]
        } else if mirrored[1] > 0.0 {
            &mirrored[1..]
        } else {
            return 0.0;
        };
        way * zeros(polynomial, 0.0, most).into_iter().find(|zero| *zero > 0.0).unwrap_or(most)
    }

    /// The sign of cos φ there.
    fn side(&self, distance: f64) -> f64 {
        if (value(&self.g, distance) < 0.0) == (self.anisotropy < 0.0) { 1.0 } else { -1.0 }
    }

    /// 2∫du/|u'| between the ends, by the arithmetic-geometric mean.
    ///
    /// With u'² = (v − v₁)(v₂ − v)R(v) and v = (v₂ + v₁t²)/(1 + t²) the integral is 2∫dt/√(At⁴ + Bt² + C) over t > 0, A and C the
    /// values of R at v₁ and v₂: π over the mean of (AC)^(1/4) and √(B + 2√(AC))/2.
    fn period(&self, low: f64, high: f64) -> f64 {
        let (sum, product) = (low + high, low * high);
        let [_, _, c2, c3, c4] = self.square;
        let r2 = -c4;
        let r1 = sum * r2 - c3;
        let r0 = sum * r1 - product * r2 - c2;
        let rest = |v: f64| value(&[r0, r1, r2], v).max(0.0);
        let middle = 2.0 * r2 * product + r1 * sum + 2.0 * r0;
        let ends = (rest(low) * rest(high)).sqrt();
        let (first, second) = (ends, 0.25 * (middle + 2.0 * ends).max(0.0));
        let (larger, smaller) = (first.max(second), first.min(second));
        if smaller == 0.0 {
            return f64::INFINITY;
        }
        TAU / Ladder::new(larger, smaller, larger - smaller).mean()
    }
}
