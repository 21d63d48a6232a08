//! Cases side by side: the bits that each has alone, in any lanes, beside anybody.

use crate::given::drive::Drive;
use crate::given::forces::{Forces, Thread};
use crate::given::launch::Launch;
use crate::given::pendulum::Pendulum;
use crate::numbers::arithmetic::{Arithmetic, Fused, Portable, fused, widest};
#[cfg(target_arch = "x86_64")]
use crate::numbers::lanes::{EightLanes, FourLanes};
use crate::numbers::lanes::{Instructions, Lanes, PlainLanes};
use crate::real::ensemble::{Case, side_by_side};
use crate::real::lanes::{Abreast, LaneStep};
use crate::real::motion::RealMotion;
use crate::real::step::advance_by;
use crate::taylor::step::{Checkpoint, Step};
use crate::taylor::walk::{Halt, Readings, Stepper, Walk};
use std::array::from_fn;
use std::sync::atomic::{AtomicUsize, Ordering};

const PENDULUM: Pendulum = Pendulum { length: 1.0, gravity: 9.81, mass: 2.0 };
const AROUND: Forces = Forces {
    damping: 1e-3,
    quadratic: 0.0,
    rotation: [4e-5, 5e-5],
    anisotropy: 1e-3,
    axis: 0.4,
    damping_anisotropy: 1e-4,
    damping_axis: -0.3,
};

fn real(forces: Forces, drive: Drive, thread: Thread, launch: Launch) -> RealMotion {
    RealMotion::new(PENDULUM, launch, forces, drive, thread, 1e-17).expect("a good case")
}

fn launch(theta: f64, theta_rate: f64, phi_rate: f64) -> Launch {
    Launch::Angles { theta, phi: 0.2, theta_rate, phi_rate }
}

/// Motions whose forces are of the same kind: swings of all sizes, planes, cones, at rest, over the top, slack at once or
/// later, in flight, pushed.
fn of_one_kind(forces: Forces) -> Vec<RealMotion> {
    let mut motions = Vec::new();
    for k in 0..9 {
        let a = 0.9 * 0.4_f64.powi(k);
        let launch = Launch::Ellipse { a, b: a * (0.3 * f64::from(k) - 0.9), azimuth: 0.7 * f64::from(k) };
        motions.push(real(forces, Drive::Absent, Thread::Ends, launch));
    }
    for thread in [Thread::Ends, Thread::Flies, Thread::Rod] {
        for launch in [launch(0.0, 6.5, 0.0), launch(2.5, 0.0, 0.0), launch(2.0, 0.4, 3.0), launch(0.3, 0.0, 0.0)] {
            motions.push(real(forces, Drive::Absent, thread, launch));
        }
    }
    let damped = Forces { damping: 0.01, ..forces };
    for thread in [Thread::Ends, Thread::Flies] {
        for drive in [
            Drive::Phase { push: 0.01, phase: 0.4 },
            Drive::Phase { push: -0.003, phase: 2.9 },
            Drive::Radius { push: 0.01, radius: 0.02 },
            Drive::Radius { push: 0.3, radius: 0.1 },
        ] {
            motions.push(real(damped, drive, thread, Launch::Ellipse { a: 0.2, b: 0.05, azimuth: 0.1 }));
        }
    }
    motions.push(real(forces, Drive::Absent, Thread::Ends, launch(0.0, 0.0, 0.0)));
    motions.push(real(forces, Drive::Absent, Thread::Rod, launch(0.4, 1e3, 0.0)));
    motions
}

fn kinds() -> [Vec<RealMotion>; 3] {
    [Forces { damping: 1e-3, ..Forces::default() }, AROUND, Forces { quadratic: 0.05, ..AROUND }].map(of_one_kind)
}

/// Everything of a step that counts, as bits.
fn bits(step: &Step) -> (Vec<u64>, String) {
    let Step { series, next: Checkpoint { time, point, push_in, .. }, size, .. } = step;
    let parts = series.position.iter().chain(&series.velocity).chain([&point.position, &point.velocity]);
    let directions = parts.flat_map(|vector| &vector[..3]).chain(&series.guard);
    let others = [*size, time.hi, time.lo, push_in.unwrap_or(-1.0)];
    let numbers = directions.chain(&others).map(|number| number.to_bits()).collect();
    (numbers, format!("{:?} {:?} {} {}", step.thread, step.ending, step.next.free, step.next.armed))
}

/// Whether this processor can do it.
fn is_there(needs: Instructions) -> bool {
    match needs {
        Instructions::Common => true,
        Instructions::Avx2 => fused(),
        Instructions::Avx512 => widest() == Instructions::Avx512,
    }
}

fn steps_are_those_of_one<L: Lanes>() {
    if !is_there(L::NEEDS) {
        return;
    }
    for motions in kinds() {
        for direction in [1.0, -1.0] {
            let mut lanes = Abreast::<L>::new(&motions[0].problem.field);
            // In each lane other cases, one after the other, with one lane that stays empty for a while.
            for first in (0..motions.len()).step_by(3) {
                let chosen: Vec<_> = (0..L::COUNT).map(|lane| &motions[(first + 5 * lane) % motions.len()]).collect();
                let mut alone: Vec<_> = chosen.iter().map(|motion| Step::before(motion.launch())).collect();
                let mut together = alone.clone();
                for (lane, motion) in chosen.iter().enumerate() {
                    lanes.set_lane(lane, &motion.problem);
                }
                for round in 0..120 {
                    let goes = |lane: usize, step: &Step| step.ending.is_none() && (lane != 1 || round > 7);
                    let mut steps: [Option<LaneStep<'_>>; 8] = from_fn(|_| None);
                    for (lane, (step, slot)) in together.iter_mut().zip(&mut steps).enumerate() {
                        let problem = &chosen[lane].problem;
                        *slot = goes(lane, step).then_some(LaneStep { problem, direction, step, is_watched: false });
                    }
                    let went: Vec<bool> = steps.iter().map(Option::is_some).collect();
                    lanes.advance(&mut steps[..L::COUNT]);
                    for lane in (0..L::COUNT).filter(|lane| went[*lane]) {
                        lanes.complete(lane, &mut together[lane]);
                        one_step::<L::Single>(chosen[lane], direction, &mut alone[lane]);
                        let case = (first + 5 * lane) % motions.len();
                        assert!(
                            bits(&alone[lane]) == bits(&together[lane]),
                            "case {case}, lane {lane}, step {round}: {:?} and {:?}",
                            alone[lane].next,
                            together[lane].next
                        );
                    }
                }
            }
        }
    }
}

/// Compiled for the processor, as [`Fused`] has to be.
fn one_step<A: Arithmetic>(motion: &RealMotion, direction: f64, step: &mut Step) {
    #[cfg(target_arch = "x86_64")]
    if A::NEEDS == Instructions::Avx2 {
        #[target_feature(enable = "avx2,fma")]
        fn vectors<A: Arithmetic>(motion: &RealMotion, direction: f64, step: &mut Step) {
            advance_by::<A, false>(&motion.problem, direction, step);
        }
        // SAFETY: asked for in `steps_are_those_of_one`.
        return unsafe { vectors::<A>(motion, direction, step) };
    }
    advance_by::<A, false>(&motion.problem, direction, step);
}

#[test]
fn portable_lanes_take_the_steps_of_one() {
    steps_are_those_of_one::<PlainLanes<Portable, 4>>();
}

#[test]
fn fused_lanes_take_the_steps_of_one() {
    steps_are_those_of_one::<PlainLanes<Fused, 2>>();
    steps_are_those_of_one::<PlainLanes<Fused, 8>>();
    #[cfg(target_arch = "x86_64")]
    steps_are_those_of_one::<FourLanes>();
}

#[cfg(target_arch = "x86_64")]
#[test]
fn the_widest_lanes_take_the_steps_of_one() {
    steps_are_those_of_one::<EightLanes>();
}

const TIMES: [f64; 9] = [0.0, 3.0, -2.0, 0.7, 0.71, 20.0, -0.1, 8.0, 8.0];

/// What a motion gives, before and after, and how it ends.
type Row = (Vec<u64>, Result<(), Halt>);

/// With positions, velocities and tensions one after the other.
fn readings<'a>(times: &'a [f64], row: &'a mut [f64]) -> Readings<'a> {
    let (position, rest) = row.split_at_mut(3 * times.len());
    let (velocity, tension) = rest.split_at_mut(3 * times.len());
    Readings { times, position, velocity, tension, ..Readings::default() }
}

fn row(numbers: &[f64], halted: Result<(), Halt>) -> Row {
    (numbers.iter().map(|number| number.to_bits()).collect(), halted)
}

fn read_together<L: Lanes>(motions: &[&RealMotion], at_once: usize, walks: &mut [Walk]) -> Vec<Row> {
    let mut rows = vec![[f64::NAN; 7 * TIMES.len()]; motions.len()];
    let mut outcomes = vec![Ok(()); motions.len()];
    let taken = walks.iter_mut().map(Walk::take);
    let cases = motions.iter().zip(&mut rows).zip(taken).enumerate();
    let mut cases =
        cases.map(|(tag, ((motion, row), walk))| Case { tag, motion: *motion, readings: readings(&TIMES, row), walk });
    let mut back = Vec::new();
    let mut done = |case: Case<'_, RealMotion, usize>, halted| {
        outcomes[case.tag] = halted;
        back.push((case.tag, case.walk));
    };
    side_by_side::<L, usize>(&mut cases, at_once, &mut done, &|| false);
    assert_eq!(back.len(), motions.len(), "every case comes back");
    for (tag, walk) in back {
        walks[tag] = walk;
    }
    rows.iter().zip(outcomes).map(|(numbers, halted)| row(numbers, halted)).collect()
}

fn read_alone(motion: &RealMotion) -> Row {
    let mut numbers = [f64::NAN; 7 * TIMES.len()];
    let halted = motion.read(&mut readings(&TIMES, &mut numbers), &mut Walk::new(16), &|| false);
    row(&numbers, halted)
}

fn groups_are_their_motions<L: Lanes>() {
    let kinds = kinds();
    // Kinds that come one after the other, and kinds that change from case to case.
    let in_blocks: Vec<&RealMotion> = kinds.iter().flatten().collect();
    let mixed: Vec<&RealMotion> = (0..kinds[0].len()).flat_map(|k| kinds.iter().map(move |kind| &kind[k])).collect();
    let many: Vec<&RealMotion> = (0..300).map(|k| mixed[(7 * k) % mixed.len()]).collect();
    for motions in [in_blocks, mixed.clone(), many, mixed[..5].to_vec(), mixed[..1].to_vec(), Vec::new()] {
        let alone: Vec<_> = motions.iter().map(|motion| read_alone(motion)).collect();
        for at_once in [1, 3, 99] {
            let mut walks: Vec<_> = motions.iter().map(|_| Walk::new(16)).collect();
            // The second time from the checkpoints of the first.
            for _ in 0..2 {
                assert!(read_together::<L>(&motions, at_once, &mut walks) == alone, "{at_once} of {}", motions.len());
            }
        }
    }
}

#[test]
fn ensembles_are_their_motions() {
    if !fused() {
        groups_are_their_motions::<PlainLanes<Portable, 4>>();
        return;
    }
    groups_are_their_motions::<PlainLanes<Fused, 2>>();
    groups_are_their_motions::<PlainLanes<Fused, 8>>();
    #[cfg(target_arch = "x86_64")]
    {
        groups_are_their_motions::<FourLanes>();
        if widest() == Instructions::Avx512 {
            groups_are_their_motions::<EightLanes>();
        }
    }
}

#[test]
fn an_ensemble_that_is_interrupted_goes_on_from_there() {
    let kinds = kinds();
    let motions: Vec<&RealMotion> = kinds.iter().flatten().cycle().take(150).collect();
    let alone: Vec<_> = motions.iter().map(|motion| read_alone(motion)).collect();
    let mut walks: Vec<_> = motions.iter().map(|_| Walk::new(16)).collect();
    let mut finished = 0;
    for patience in 1..4 {
        let mut rows = vec![[f64::NAN; 7 * TIMES.len()]; motions.len()];
        let taken: Vec<_> = walks.iter_mut().map(Walk::take).collect();
        let cases = motions.iter().zip(&mut rows).zip(taken).enumerate();
        let mut cases = cases.map(|(tag, ((motion, row), walk))| Case {
            tag,
            motion: *motion,
            readings: readings(&TIMES, row),
            walk,
        });
        let mut back = 0;
        let asked = AtomicUsize::new(0);
        RealMotion::read_all(
            &mut cases,
            99,
            &mut |case, halted| {
                walks[case.tag] = case.walk;
                back += 1;
                finished += usize::from(halted != Err(Halt::Interrupted));
            },
            &|| asked.fetch_add(1, Ordering::Relaxed) >= patience,
        );
        assert_eq!(back, motions.len());
    }
    assert!(finished > 0 && finished < 3 * motions.len(), "{finished} of {}", 3 * motions.len());
    let mut after: Vec<Row> = vec![(Vec::new(), Ok(())); motions.len()];
    let mut rows = vec![[f64::NAN; 7 * TIMES.len()]; motions.len()];
    for ((motion, walk), (numbers, after)) in motions.iter().zip(&mut walks).zip(rows.iter_mut().zip(&mut after)) {
        let halted = motion.read(&mut readings(&TIMES, numbers), walk, &|| false);
        *after = row(numbers, halted);
    }
    assert!(after == alone);
}
