//! One step of the real motion: how far it may go, and what happens at its end. The thread goes slack, or taut; the
//! drive pushes.

use crate::given::drive::Drive;
use crate::given::forces::Thread;
use crate::numbers::arithmetic::{Arithmetic, dispatch};
use crate::real::problem::Problem;
use crate::real::sphere::slowest_point;
use crate::taylor::events::{Beyond, Guard, Outside, Outward, first};
use crate::taylor::series::{Point, Series};
use crate::taylor::step::{Ending, Step, ThreadChange};

/// In 1/ω0. Longer steps are never worth their last terms, and an event could come and go within.
const LONGEST: f64 = 1.5;

dispatch! {
    /// Goes from a step to the one that begins where it ends.
    pub(crate) fn advance(problem: &Problem, direction: f64, step: &mut Step) = advance_with
}

/// The step ends at the earliest of: where its series is no longer good, or is long enough; the slowest point, for
/// quadratic drag; where the thread goes slack or taut; and the push. Each of them is looked for up to the one before.
#[inline(always)]
fn advance_with<A: Arithmetic>(_: A, problem: &Problem, direction: f64, step: &mut Step) {
    let start = step.next;
    let series = &mut step.series;
    series.start(&start.point);
    problem.field.continue_series::<A>(!start.free, series);

    let mut size = direction * series.reach(problem.tolerance).min(LONGEST);
    if problem.field.quadratic != 0.0 {
        size = slowest_point::<A>(series, size).unwrap_or(size);
    }
    let mut thread = ThreadChange::None;
    if let Some((at, change)) = thread_changes::<A>(problem.thread, series, start.free, size) {
        (size, thread) = (at, change);
    }
    let mut clock = PushClock { armed: start.armed, push_in: start.push_in };
    let push = clock.push::<A>(problem.drive, series, size);
    if let Some((at, _)) = push {
        // What the thread would have done later it may not do now.
        thread = if at < size { ThreadChange::None } else { thread };
        size = at.max(0.0);
    }

    let free = match thread {
        ThreadChange::None => start.free,
        ThreadChange::Slackens => problem.thread == Thread::Flies,
        ThreadChange::Tautens => false,
    };
    clock.pass::<A>(problem.drive, series, size, push.is_some());
    let mut point = series.at::<A>(size);
    if !free {
        onto_sphere(&mut point);
    }
    if let Some((_, push)) = push {
        kick(&mut point, push);
        if !free {
            onto_sphere(&mut point);
        }
    }
    let is_finite = point.position.iter().chain(&point.velocity).all(|value| value.is_finite());
    let goes_on = size != 0.0 || thread != ThreadChange::None || push.is_some();
    (step.ending, step.size) = match (is_finite && goes_on, thread) {
        (false, _) => (Some(Ending::Runaway), 0.0),
        (true, ThreadChange::Slackens) if !free => (Some(Ending::Slack), size),
        (true, _) => (None, size),
    };
    step.thread = thread;
    step.start = start;
    step.next = start.after::<A>(step.size, point);
    step.next.free = free;
    (step.next.armed, step.next.push_in) = (clock.armed, clock.push_in);
}

/// Where the thread goes slack on the sphere, or taut in flight, within a step.
#[inline(always)]
fn thread_changes<A: Arithmetic>(
    thread: Thread,
    series: &Series,
    free: bool,
    size: f64,
) -> Option<(f64, ThreadChange)> {
    if free {
        // A flight starts on the sphere, which is no return.
        let back = first::<A>(&Outside(series), size, true).filter(|back| *back != 0.0)?;
        return Some((back, ThreadChange::Tautens));
    }
    if thread == Thread::Rod || series.guard_holds(size) {
        return None;
    }
    let already = series.guard[0] <= 0.0;
    let slack = if already { Some(0.0) } else { first::<A>(&Guard(series), size, false) };
    slack.map(|at| (at, ThreadChange::Slackens))
}

/// When the drive pushes next.
struct PushClock {
    /// An outer turning point has passed since the last push.
    armed: bool,
    /// Until a push that is due: from the step's start and, once it has passed, from its end.
    push_in: Option<f64>,
}

impl PushClock {
    /// The push within a step, and how strong it is.
    #[inline(always)]
    fn push<A: Arithmetic>(&mut self, drive: Drive, series: &Series, size: f64) -> Option<(f64, f64)> {
        let (Drive::Phase { push, .. } | Drive::Radius { push, .. }) = drive else { return None };
        if self.armed && self.push_in.is_none() {
            self.push_in = match drive {
                Drive::Radius { radius, .. } => first::<A>(&Beyond(series, radius), size, true),
                Drive::Phase { phase, .. } => first::<A>(&Outward(series), size, true).map(|inner| inner + phase),
                Drive::Absent => None,
            };
            self.armed = self.push_in.is_none();
        }
        self.push_in.filter(|at| *at <= size).map(|at| (at, push))
    }

    /// Lets a step pass.
    #[inline(always)]
    fn pass<A: Arithmetic>(&mut self, drive: Drive, series: &Series, size: f64, pushed: bool) {
        if drive != Drive::Absent {
            self.armed |= first::<A>(&Outward(series), size, false).is_some();
        }
        self.push_in = if pushed { None } else { self.push_in.map(|time| time - size) };
    }
}

/// Changes the horizontal velocity away from the axis; on the axis itself that is where the bob is going.
fn kick(point: &mut Point, push: f64) {
    let Point { position: [x, y, _, _], velocity } = point;
    let distance = x.hypot(*y);
    let [ux, uy] = if distance > 0.0 {
        [*x / distance, *y / distance]
    } else {
        let speed = velocity[0].hypot(velocity[1]);
        if speed == 0.0 { return } else { [velocity[0] / speed, velocity[1] / speed] }
    };
    velocity[0] += push * ux;
    velocity[1] += push * uy;
}

/// Takes away what rounding, or the thread's jerk, has left of r·r − 1 and r·v.
#[inline(always)]
fn onto_sphere(point: &mut Point) {
    let Point { position, velocity } = point;
    let [x, y, z, _] = *position;
    let excess = 0.5 * (x * x + y * y + (z - 1.0) * (z + 1.0));
    let along = x * velocity[0] + y * velocity[1] + z * velocity[2];
    for lane in 0..3 {
        velocity[lane] -= along * position[lane];
        position[lane] -= excess * position[lane];
    }
}
