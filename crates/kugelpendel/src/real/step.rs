//! One step of the real motion: how far it may go, and what happens at its end. The thread goes slack, or taut; the
//! drive pushes.

use crate::given::drive::Drive;
use crate::given::forces::Thread;
use crate::numbers::arithmetic::{Arithmetic, dispatch};
use crate::real::problem::Problem;
use crate::real::sphere::{FieldKind, SphereTerms, slowest_point};
use crate::taylor::events::{Beyond, Guard, Outside, Outward, first};
use crate::taylor::layout::{Alone, Layout};
use crate::taylor::reach::reach;
use crate::taylor::series::{Point, Series};
use crate::taylor::step::{Checkpoint, Ending, Step, ThreadChange};

/// In 1/ω0. Longer steps are never worth their last terms, and an event could come and go within.
const LONGEST: f64 = 1.5;

dispatch! {
    /// Goes from a step to the one that begins where it ends.
    pub(crate) fn advance(problem: &Problem, direction: f64, step: &mut Step) = advance_with
}

#[inline(always)]
fn advance_with<A: Arithmetic>(_: A, problem: &Problem, direction: f64, step: &mut Step) {
    advance_by::<A, true>(problem, direction, step);
}

/// With the orders of the series written out, or in a loop: the same bits.
#[inline(always)]
pub(crate) fn advance_by<A: Arithmetic, const WRITTEN_OUT: bool>(problem: &Problem, direction: f64, step: &mut Step) {
    let series = &mut step.series;
    series.start(&step.next.point);
    let terms = &mut SphereTerms::default();
    problem.field.continue_series::<Alone<A, WRITTEN_OUT>>(!step.next.free, series, terms);
    let size = longest(series.shares::<Alone<A>>(problem.tolerance), direction);
    conclude::<A>(problem, direction, size, step);
}

/// How far the series is good, and long enough; with the sign of the direction.
#[inline(always)]
pub(crate) fn longest(shares: [f64; 2], direction: f64) -> f64 {
    direction * reach(shares).min(LONGEST)
}

/// Concludes a step whose series is there. It ends at the earliest of: so far; the slowest point, for quadratic drag; where
/// the thread goes slack or taut; and the push. Each of them is looked for up to the one before.
#[inline(always)]
pub(crate) fn conclude<A: Arithmetic>(problem: &Problem, direction: f64, mut size: f64, step: &mut Step) {
    let start = step.next;
    let series = &step.series;
    if problem.field.kind == FieldKind::Braked {
        size = slowest_point::<A>(series, direction, size).unwrap_or(size);
    }
    let mut thread = ThreadChange::None;
    if let Some((at, change)) = thread_changes::<A>(problem.thread, series, start.free, size) {
        (size, thread) = (at, change);
    }
    let mut clock = PushClock::of(&start);
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
    let mut point = series.at::<Alone<A>>(size);
    if !free {
        onto_sphere::<Alone<A>>(&mut point);
    }
    if let Some((_, push)) = push {
        kick(&mut point, push);
        if !free {
            onto_sphere::<Alone<A>>(&mut point);
        }
    }
    let goes_on = size != 0.0 || thread != ThreadChange::None || push.is_some();
    (step.ending, step.size) = match (is_finite(&point) && goes_on, thread) {
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

/// Ends a step on a taut thread in which nothing happens, as [`conclude`] does, at a point that is known.
#[inline(always)]
pub(crate) fn conclude_quietly<A: Arithmetic>(size: f64, point: Point, step: &mut Step) {
    let start = step.next;
    (step.ending, step.size, step.thread, step.start) = (None, size, ThreadChange::None, start);
    step.next = start.after::<A>(size, point);
    step.next.push_in = start.push_in.map(|time| time - size);
}

#[inline(always)]
pub(crate) fn is_finite(point: &Point) -> bool {
    point.position.iter().chain(&point.velocity).all(|value| value.is_finite())
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
    if thread == Thread::Rod || series.guard_holds::<A>(size) {
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
    fn of(start: &Checkpoint) -> Self {
        Self { armed: start.armed, push_in: start.push_in }
    }

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
pub(crate) fn onto_sphere<L: Layout>(point: &mut Point<L::Vector>) {
    let ([x, y, z], [vx, vy, vz]) = (L::parts(&point.position), L::parts(&point.velocity));
    let one = L::same(1.0);
    let excess = L::same(0.5) * (x * x + y * y + (z - one) * (z + one));
    let along = x * vx + y * vy + z * vz;
    point.velocity = L::vector([vx - along * x, vy - along * y, vz - along * z]);
    point.position = L::vector([x - excess * x, y - excess * y, z - excess * z]);
}
