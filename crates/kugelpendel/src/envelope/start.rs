//! From a launch to the mean motion that begins with it.

use super::LARGEST;
use super::circles::Circles;
use super::equations::AveragedEquations;
use super::stepper::Moment;
use crate::exact::motion::ExactMotion;
use crate::given::launch::Launch;
use crate::given::pendulum::Pendulum;
use num_complex::Complex64;

/// The mean motion that is at this place (m) with this velocity (m/s) at t = 0; none where it rises to the support.
///
/// Mean, not osculating: the velocity is that of the ideal motion and what the forces add to it, by iteration. For
/// forces linear in place and velocity that is exact.
pub(super) fn mean(
    pendulum: &Pendulum,
    equations: &AveragedEquations,
    [x, y]: [f64; 2],
    velocity: [f64; 2],
) -> Option<Moment> {
    let speed = pendulum.length * pendulum.angular_frequency();
    let mut added = Complex64::ZERO;
    let mut moment = osculating(pendulum, equations, [x, y], velocity)?;
    for _ in 0..12 {
        let circles = Circles::of(&moment.state);
        let swing = equations.swing(&circles)?;
        let [ahead, behind] = moment.angles;
        let direction = Complex64::cis(0.5 * (ahead + behind));
        let next = direction * equations.drift(&circles, &swing, 0.5 * (ahead - behind));
        let moved = (next - added).norm();
        added = next;
        moment =
            osculating(pendulum, equations, [x, y], [velocity[0] - speed * added.re, velocity[1] - speed * added.im])?;
        if moved <= 1e-16 {
            break;
        }
    }
    // What is in this place, and from there the slow variables themselves.
    let target = Circles::of(&moment.state).amplitudes();
    let mut found = target;
    for _ in 0..8 {
        let circles = Circles::from(found);
        let Some(placed) = equations.in_place(&circles, &equations.swing(&circles)?) else { break };
        let missing = [0, 1].map(|k| target[k] - placed.amplitudes()[k]);
        found = [found[0] + missing[0], found[1] + missing[1]];
        if missing[0].norm() + missing[1].norm() <= 1e-17 {
            break;
        }
    }
    let turned = [0, 1].map(|k| if target[k].norm() > 0.0 { (found[k] / target[k]).arg() } else { 0.0 });
    let angles = [moment.angles[0] + turned[0], moment.angles[1] + turned[1]];
    let [ahead, behind] = angles;
    let actions =
        equations.settled(found.map(|value| value.norm_sqr()), 0.5 * (ahead + behind), 0.5 * (ahead - behind));
    Some(Moment::of(actions.map(|action| action.max(0.0).sqrt()), angles))
}

/// The ideal motion with this position and velocity; none where it rises to the support.
fn osculating(
    pendulum: &Pendulum,
    equations: &AveragedEquations,
    [x, y]: [f64; 2],
    [vx, vy]: [f64; 2],
) -> Option<Moment> {
    let motion = ExactMotion::new(*pendulum, Launch::Plane { x, y, vx, vy }).ok()?;
    let ellipse = motion.ellipse();
    let [a, b] = [ellipse.a, ellipse.b].map(|radius| radius / pendulum.length);
    if motion.rises_above() || a > LARGEST {
        return None;
    }
    let mut sizes = equations.amplitudes([a, b.abs()]);
    if b < 0.0 {
        sizes.reverse();
    }
    Some(Moment::of(sizes, [ellipse.azimuth + ellipse.phase, ellipse.azimuth - ellipse.phase]))
}
