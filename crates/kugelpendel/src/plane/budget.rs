//! What turns the plane of a swing, cause by cause, and where it hurries, lags or stalls against the Earth.

use crate::envelope::{Envelope, EnvelopeMotion, EnvelopeWalks};

/// A rate that differs by no more than this fraction from the Earth's share is as it should be.
pub const ALIKE: f64 = 0.01;

/// Slower than this fraction of the Earth's share, or backwards, the plane stalls.
pub const STALL: f64 = 0.1;

/// Whose shares add up to the rate of the plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// The rotation of the ground.
    Earth,
    /// What the ellipse turns by itself.
    Intrinsic,
    /// The suspension's stiffness.
    Anisotropy,
    /// Damping that depends on the direction.
    Damping,
    /// The pushes.
    Drive,
}

impl Cause {
    /// All of them, in the order of the shares of [`PrecessionBudget`].
    pub const ALL: [Self; 5] = [Self::Earth, Self::Intrinsic, Self::Anisotropy, Self::Damping, Self::Drive];

    /// The word for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Earth => "earth",
            Self::Intrinsic => "intrinsic",
            Self::Anisotropy => "anisotropy",
            Self::Damping => "damping",
            Self::Drive => "drive",
        }
    }
}

/// How the plane turns against the Earth's share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pace {
    /// Faster.
    Hurries,
    /// Slower.
    Lags,
    /// Slower than [`STALL`] of it, or backwards.
    Stalls,
    /// Within [`ALIKE`] of it.
    AsItShould,
}

impl Pace {
    /// The word for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Hurries => "hurries",
            Self::Lags => "lags",
            Self::Stalls => "stalls",
            Self::AsItShould => "as it should",
        }
    }
}

/// The rate of the plane by its causes, averaged over a swing: rad/s, counter-clockwise seen from above.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PrecessionBudget(
    /// In the order of [`Cause::ALL`].
    pub [f64; 5],
);

/// A time in which the plane keeps one pace.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// The pace that it keeps.
    pub pace: Pace,
    /// When it begins, s.
    pub start: f64,
    /// When it ends, s.
    pub stop: f64,
    /// The largest share that drives the rate that way; none where the pace is as it should be. Of the ellipse's own
    /// turning and the drive's the larger one counts, with what the other leaves of it.
    pub cause: Option<Cause>,
    /// The largest share the other way, where it is more than half of that.
    pub against: Option<Cause>,
}

impl PrecessionBudget {
    /// Of the averaged motion at its start, and the rates of a and b there in m/s.
    pub fn at_start(motion: &EnvelopeMotion) -> (Self, [f64; 2]) {
        let mut rates = [f64::NAN; 7];
        // The start lies within every motion.
        let _ = motion.fill(Envelope::Rates, &[0.0], &mut rates, &mut EnvelopeWalks::default(), &|| false);
        let [earth, intrinsic, anisotropy, damping, drive, a, b] = rates;
        (Self([earth, intrinsic, anisotropy, damping, drive]), [a, b])
    }

    /// dψ/dt, rad/s.
    pub fn total(&self) -> f64 {
        self.0.iter().sum()
    }

    /// Against the Earth's share; none where it has no share.
    pub fn pace(&self) -> Option<Pace> {
        let [earth, ..] = self.0;
        let ratio = self.total() / earth;
        match ratio {
            _ if earth == 0.0 => None,
            _ if ratio < STALL => Some(Pace::Stalls),
            _ if ratio < 1.0 - ALIKE => Some(Pace::Lags),
            _ if ratio > 1.0 + ALIKE => Some(Pace::Hurries),
            _ => Some(Pace::AsItShould),
        }
    }
}

/// The times of one pace each, in order; none where the Earth has no share. A stretch reaches half-way to the samples of
/// its neighbours. Times and budgets are as many, the times ascending.
pub fn stretches(times: &[f64], budgets: &[PrecessionBudget]) -> Vec<Stretch> {
    let count = times.len().min(budgets.len());
    let mut found = Vec::new();
    let mut first = 0;
    for part in budgets[..count].chunk_by(|one, next| one.pace() == next.pace()) {
        let last = first + part.len() - 1;
        if let Some(pace) = part[0].pace() {
            let (before, after) = (first.saturating_sub(1), (last + 1).min(count - 1));
            let [start, stop] = [0.5 * (times[before] + times[first]), 0.5 * (times[after] + times[last])];
            let [cause, against] = causes(part, pace);
            found.push(Stretch { pace, start, stop, cause, against });
        }
        first = last + 1;
    }
    found
}

/// Whose share drives a stretch of one pace that way, and whose holds against it.
fn causes(part: &[PrecessionBudget], pace: Pace) -> [Option<Cause>; 2] {
    if pace == Pace::AsItShould {
        return [None; 2];
    }
    let earth = part[0].0[0];
    let way = earth.signum() * if pace == Pace::Hurries { 1.0 } else { -1.0 };
    let mean = |cause: usize| way * part.iter().map(|budget| budget.0[cause]).sum::<f64>() / part.len() as f64;
    let mut shares: Vec<(usize, f64)> = (1..5).map(|cause| (cause, mean(cause))).collect();
    // A drive that is timed well takes back what the ellipse turns by itself: both are large, and only what remains of the
    // two can be to blame.
    let (intrinsic, drive) = (shares[0].1, shares[3].1);
    let (greater, lesser) = if drive.abs() > intrinsic.abs() { (3, 0) } else { (0, 3) };
    let held = -shares[lesser].1 > 0.5 * shares[greater].1 && shares[greater].1 > 0.0;
    let (kept, dropped) = (shares[greater].0, shares[lesser]);
    shares[greater].1 += dropped.1;
    shares.remove(lesser);
    let most = shares.iter().copied().reduce(|best, next| if next.1 > best.1 { next } else { best });
    let least = shares.iter().copied().reduce(|best, next| if next.1 < best.1 { next } else { best });
    let (Some(most), Some(least)) = (most, least) else { return [None; 2] };
    let against = if most.0 == kept && held {
        Some(dropped.0)
    } else if -least.1 > 0.5 * most.1 {
        Some(least.0)
    } else {
        None
    };
    [Some(Cause::ALL[most.0]), against.map(|cause| Cause::ALL[cause])]
}
