//! Where on its swing the motion is: the phase, by the time and at the launch.

use crate::exact::invariants::constants::Invariants;
use crate::exact::motion::ExactMotion;
use crate::given::times::{Quantity, Times};
use crate::numbers::arithmetic::Portable;
use crate::numbers::double_double::{Dd, Pair, two_sum};
use crate::numbers::elliptic::Ladder;
use std::f64::consts::PI;

/// How far along the swing the motion is, given the time.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Phase {
    /// Swings (highest point to highest point) per second, turns of the frame per second, and the swing's fraction at
    /// the launch, counted from a lowest point.
    Periodic { swings: Pair, frame: Pair, start: Pair },
    /// On the separatrix: h = rate·t + start.
    Once { rate: f64, start: f64 },
    /// At rest, hanging or upright.
    Still,
}

impl Invariants {
    pub(crate) fn ladder(&self) -> Ladder {
        let t = &self.turning;
        Ladder::new(t.excess + t.low_depth, t.excess + t.high_depth, 2.0 * t.half_range)
    }

    /// The fraction of a swing since the lowest point, in (−½, ½], of a point (s − mean, ∝ ṡ) on the height's circle.
    pub(crate) fn fraction(&self, [cos, sin]: [f64; 2]) -> Pair {
        let (ladder, radius) = (self.ladder(), self.turning.half_range);
        let t = &self.turning;
        let (a, b) = ((t.excess + t.low_depth).sqrt(), (t.excess + t.high_depth).sqrt());
        // sn² = (s − s_b)/(s_a − s_b): tan φ as a quotient without cancellation, whichever half the point is on; and
        // K − F(φ) = F(φ') with tan φ' = cot φ/√(1 − m). Of the two angles the smaller is the well-conditioned one.
        let (rise, run) = if cos <= 0.0 { (sin.abs(), radius - cos) } else { (radius + cos, sin.abs()) };
        if rise * rise * b <= run * run * a {
            let share = ladder.argument(rise.atan2(run)) / PI;
            return Pair { hi: share.copysign(sin), lo: 0.0 };
        }
        let share = ladder.argument((run * a).atan2(rise * b)) / PI;
        let (hi, lo) = two_sum(0.5, -share);
        if sin < 0.0 { Pair { hi: -hi, lo: -lo } } else { Pair { hi, lo } }
    }

    fn start(&self) -> Pair {
        self.fraction(self.circle)
    }

    /// The same on the separatrix, where the swing lasts for ever: h = asinh tan φ.
    fn separatrix_start(&self) -> f64 {
        let ([cos, sin], radius) = (self.circle, self.turning.half_range);
        let tangent = if cos <= 0.0 { sin.abs() / (radius - cos) } else { (radius + cos) / sin.abs() };
        tangent.asinh().copysign(sin)
    }
}

impl ExactMotion {
    pub(crate) fn phase(&self) -> Phase {
        let invariants = &self.invariants;
        if self.launch.still {
            return Phase::Still;
        }
        if invariants.frequency.hi == 0.0 {
            let turning = &invariants.turning;
            let rate = self.omega0.hi * (0.5 * (turning.excess + turning.low_depth)).sqrt();
            return Phase::Once { rate, start: invariants.separatrix_start() };
        }
        let per_second = Dd::<Portable>::of(self.omega0) * Dd::INV_PI;
        let frame = if self.near_separatrix() { invariants.precession } else { invariants.frame };
        Phase::Periodic {
            swings: (per_second * Dd::of(invariants.frequency)).pair(),
            frame: (per_second * Dd::of(frame)).scale(0.5 * invariants.sense).pair(),
            start: invariants.start(),
        }
    }

    /// First time ≥ 0 at a highest point, s; infinite on the separatrix, 0 at rest.
    pub fn apsis_time(&self) -> f64 {
        match self.phase() {
            Phase::Still => 0.0,
            Phase::Once { .. } => f64::INFINITY,
            Phase::Periodic { start, .. } => ((0.5 - start.hi) - start.lo) * self.radial_period(),
        }
    }

    /// Azimuth at that time, rad in (−π, π]; 0 where there is none.
    pub fn apsis_azimuth(&self) -> f64 {
        let time = self.apsis_time();
        if !time.is_finite() {
            return 0.0;
        }
        let mut place = [0.0; 3];
        self.fill(Quantity::Position, Times::Scattered(&[time]), &mut place);
        place[1].atan2(place[0])
    }
}
