//! What only the inside can show: the two arithmetics, the two ways through the iterations, double-double itself.

use crate::exact::invariants::constants::Invariants;
use crate::exact::motion::{ExactMotion, solve_with};
use crate::exact::plan::Plan;
use crate::exact::sampling::fill_part_with;
use crate::given::launch::Launch;
use crate::given::pendulum::Pendulum;
use crate::given::times::{Quantity, Times};
use crate::numbers::arithmetic::{Arithmetic, Fused, Portable, two_prod_split};
use crate::numbers::double_double::Dd;
use std::f64::consts::PI;

const PENDULUM: Pendulum = Pendulum { length: 1.3, gravity: 9.81, mass: 2.0 };

/// Every kind of motion: ellipses of all sizes, cones, planes, over the top, near the separatrix, fast spin.
fn launches() -> Vec<Launch> {
    let angles = |theta, theta_rate, phi_rate| Launch::Angles { theta, phi: 0.3, theta_rate, phi_rate };
    let mut launches = vec![
        angles(0.0, 7.0, 0.0),
        angles(0.3, 5.6, 1e-3),
        angles(1.2, 0.0, (9.81 / 1.3 / 1.2_f64.cos()).sqrt()),
        angles(1.2, 1e-7, (9.81 / 1.3 / 1.2_f64.cos()).sqrt()),
        angles(2.0, 0.4, 3.0),
        angles(1.5, 0.1, 80.0),
        angles(3.1, 0.0, 1e-3),
        angles(PI, 0.0, 0.0),
        angles(2.9, 0.3, -0.2),
    ];
    for k in 0..10 {
        let a = 1.29 * 0.1_f64.powi(k);
        launches.extend([1.0, 0.5, -1e-6].map(|ratio| Launch::Apsides { a, b: ratio * a, azimuth: 1.0 }));
    }
    launches
}

fn solved<A: Arithmetic>(arithmetic: A, launch: Launch) -> ExactMotion {
    let mut motion = [ExactMotion::UNSOLVED];
    solve_with(arithmetic, &[(PENDULUM, launch)], &mut motion);
    motion[0]
}

fn filled<A: Arithmetic>(arithmetic: A, motion: &ExactMotion, quantity: Quantity, times: Times<'_>) -> Vec<f64> {
    let mut out = vec![0.0; 3 * 500];
    fill_part_with(arithmetic, &Plan::new(motion, &times), quantity, times, &mut out);
    out
}

#[test]
fn both_products_are_exact() {
    for k in 1..200 {
        let (a, b) = ((f64::from(k)).sqrt() * 1e7, (f64::from(k) * 0.7).sin());
        assert_eq!(Fused::two_prod(a, b), two_prod_split(a, b));
    }
}

#[test]
fn double_double_is_good_to_thirty_digits() {
    type Number = Dd<Portable>;
    for k in 1..300 {
        let x = Number::from(f64::from(k)) / Number::from(7.0);
        let root = x.sqrt();
        assert!((root.square() - x).hi.abs() < 1e-30 * x.hi, "√{k}/7");
        assert!((x * Number::from(7.0) - Number::from(f64::from(k))).hi.abs() < 1e-29 * x.hi, "{k}/7");
        let (sin, cos) = Number::sin_cos(f64::from(k) * 0.37 - 40.0);
        assert!((sin.square() + cos.square() - Number::ONE).hi.abs() < 1e-30, "sin² + cos² at {k}");
        let (double_sin, _) = Number::sin_cos(2.0 * (f64::from(k) * 0.37 - 40.0));
        assert!(((sin * cos).scale(2.0) - double_sin).hi.abs() < 1e-30, "sin of the double angle at {k}");
    }
    // sin(binary64 π) is what π lacks.
    let (sin, _) = Number::sin_cos(PI);
    assert_eq!(sin.hi, 1.2246467991473532e-16);
}

#[test]
fn both_arithmetics_find_the_same_constants() {
    for launch in launches() {
        let (a, b) = (solved(Fused, launch), solved(Portable, launch));
        for (name, a, b) in [
            ("frequency", a.frequency(), b.frequency()),
            ("precession", a.precession(), b.precession()),
            ("radial period", a.radial_period(), b.radial_period()),
            ("energy", a.energy(), b.energy()),
            ("angular momentum", a.angular_momentum(), b.angular_momentum()),
        ] {
            assert!((a - b).abs() <= 4e-16 * a.abs(), "{name} of {launch:?}: {a:e} and {b:e}");
        }
    }
}

#[test]
fn both_arithmetics_draw_the_same_path() {
    let scattered: Vec<f64> = (0..500).map(|k| -300.0 + f64::from(k).powi(2) * 0.7).collect();
    for launch in launches() {
        let motion = solved(Portable, launch);
        let size = motion.turning_radii().into_iter().fold(motion.turning_heights()[0], f64::max);
        for times in [Times::Scattered(&scattered), Times::Grid { start: -5.0, step: 0.013, first: 7 }] {
            for (quantity, scale) in [
                (Quantity::Position, size),
                (Quantity::Velocity, (2.0 * motion.energy()).sqrt() + motion.pendulum().angular_frequency() * size),
            ] {
                let fused = filled(Fused, &motion, quantity, times);
                let portable = filled(Portable, &motion, quantity, times);
                for (a, b) in fused.iter().zip(&portable) {
                    // z itself is rounded at the size of the length
                    let limit = 4e-15 * scale + 5e-16 * PENDULUM.length;
                    assert!((a - b).abs() <= limit, "{quantity:?} of {launch:?}: {a:e} and {b:e}");
                }
            }
        }
    }
}

#[test]
fn a_straight_line_and_an_iteration_agree() {
    for launch in launches() {
        let omega0 = PENDULUM.precise_angular_frequency::<Fused>();
        let state = launch.state(&PENDULUM, omega0);
        let (quick, thorough) = (Invariants::of::<_, true>(&state), Invariants::of::<_, false>(&state));
        assert!(thorough.settled, "{launch:?}");
        if quick.settled {
            for (a, b) in [(quick.frequency, thorough.frequency), (quick.precession, thorough.precession)] {
                let difference = Dd::<Fused>::of(a) - Dd::of(b);
                // What `finish` leaves to binary64 is below 1e-12 of the mean.
                let limit = 1e-27 * thorough.frequency.hi;
                assert!(difference.hi.abs() <= limit, "{launch:?}: {a:?} and {b:?}");
            }
        }
    }
}
