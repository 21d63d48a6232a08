//! The ellipse that a bob runs through at the moment.

use crate::exact::ensemble::Ensemble;
use crate::exact::motion::ExactMotion;
use crate::given::launch::Launch;
use crate::given::pendulum::Pendulum;
use crate::meaning::azimuth::nearest;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The ellipse of the ideal motion that passes through a position with a velocity: osculating, not averaged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    /// The outer turning radius, in m.
    pub a: f64,
    /// The inner turning radius, in m, positive where the ellipse is run through counter-clockwise seen from above.
    pub b: f64,
    /// The azimuth of the major axis in rad, counter-clockwise from x, on the side of the turning point that is nearest
    /// to the bob.
    pub azimuth: f64,
    /// The phase of the swing since that turning point, in rad, in (−π/2, π/2].
    pub phase: f64,
}

impl Ellipse {
    const UNKNOWN: Self = Self { a: f64::NAN, b: f64::NAN, azimuth: f64::NAN, phase: f64::NAN };

    /// The ellipses at many positions (m) and velocities (m/s) of a pendulum.
    ///
    /// `case(k)` is the pendulum, the position, the velocity and the rate in rad/s at which the ground turns about the
    /// vertical: the ellipse is that of the plane at rest, so that a bob let go at rest on the turning Earth runs
    /// through one. All four are not numbers where the bob is off its sphere. A component of the velocity along the
    /// thread is taken away: beside the small speed of a turning point rounding of the position alone makes one.
    pub fn osculating(count: usize, case: impl Fn(usize) -> (Pendulum, [f64; 3], [f64; 3], f64) + Sync) -> Vec<Self> {
        let ideal = Ensemble::new(count, |index| {
            let (pendulum, position, velocity, rotation) = case(index);
            let [x, y, _] = position;
            let [vx, vy, vz] = velocity;
            let resting = [vx - rotation * y, vy + rotation * x, vz];
            let along = dot(resting, position) / dot(position, position);
            let velocity = std::array::from_fn(|k| resting[k] - along * position[k]);
            (pendulum, Launch::State { position, velocity })
        });
        let ellipses = (0..count).map(|index| ideal.motion(index).as_ref().map_or(Self::UNKNOWN, ExactMotion::ellipse));
        ellipses.collect()
    }
}

impl ExactMotion {
    /// The ellipse of the motion as it stands at the launch.
    pub fn ellipse(&self) -> Ellipse {
        let [a, b] = self.turning_radii();
        let time = self.apsis_time();
        let mut phase = -self.frequency() * time;
        let mut azimuth = self.apsis_azimuth() - self.precession() * time;
        // Of the two turning points between which the bob is, the nearer one.
        if phase < -FRAC_PI_2 {
            (phase, azimuth) = (phase + PI, azimuth - PI);
        }
        let b = if self.angular_momentum() < 0.0 { -b } else { b };
        Ellipse { a, b, azimuth: nearest(azimuth, 0.0, TAU), phase }
    }
}

fn dot(first: [f64; 3], second: [f64; 3]) -> f64 {
    first[0] * second[0] + first[1] * second[1] + first[2] * second[2]
}
