//! What is given: refusals as data, the Earth's numbers, and what acts from numbers by their names.

use kugelpendel::{
    Acting, Bob, Drag, Drive, EXTREMES, EnvelopeMotion, ExactMotion, FASTEST, Forces, Invalid, Launch, Pendulum,
    ROTATION, RealMotion, SMALLEST, Seen, Site, Suspension, Thread, Wire,
};
use std::collections::BTreeSet;

const UNIT: Pendulum = Pendulum { length: 1.0, gravity: 1.0, mass: 1.0 };
const POLE: Site = Site { latitude: std::f64::consts::FRAC_PI_2, gravity: None, height: 0.0, rotation: ROTATION };

#[test]
fn every_kind_has_a_number_and_a_word_of_its_own() {
    let numbers: BTreeSet<_> = Invalid::KINDS.iter().map(|(number, _)| *number).collect();
    let words: BTreeSet<_> = Invalid::KINDS.iter().map(|(_, word)| *word).collect();
    assert_eq!((numbers.len(), words.len()), (Invalid::KINDS.len(), Invalid::KINDS.len()));
    assert!(!numbers.contains(&0)); // which is what a good case has
    assert!(Invalid::KINDS.is_sorted());
}

#[test]
fn a_refusal_says_kind_values_and_units_and_no_more() {
    let invalid = Pendulum { length: -1.5, ..UNIT }.check().expect_err("a negative length");
    let seen = Seen { name: "pendulum.length", value: -1.5, unit: "m" };
    assert_eq!(invalid, Invalid::NotPositive { value: seen });
    assert_eq!((invalid.number(), invalid.word(), invalid.seen()), (2, "not_positive", vec![seen]));
    assert_eq!(invalid.to_string(), "not_positive: pendulum.length = -1.5 m");
    let wide = Launch::Ellipse { a: 2.0, b: 0.0, azimuth: 0.0 }.check(&UNIT).expect_err("off the sphere");
    assert_eq!(wide.to_string(), "ellipse_too_wide: a = 2 m, length = 1 m");
    // Small enough to stand where a motion would.
    assert!(size_of::<Invalid>() <= 72 && size_of::<Invalid>() < size_of::<ExactMotion>());
}

#[test]
fn the_range_of_the_numbers_is_named() {
    let swing = |a: f64, b: f64| Launch::Ellipse { a, b, azimuth: 0.0 };
    let pendulum = Pendulum { length: 4.0, ..UNIT };
    for launch in [swing(0.0, 0.0), swing(4.0 * SMALLEST, 0.0), swing(0.0, 4.0 * SMALLEST), swing(0.5, 3.9 * FASTEST)] {
        assert_eq!(launch.check(&pendulum), Ok(()));
    }
    let small = swing(3.9 * SMALLEST, 0.0).check(&pendulum);
    assert!(matches!(small, Err(Invalid::TooSmall { least, .. }) if least == 4.0 * SMALLEST), "{small:?}");
    let fast = swing(0.5, 4.1 * FASTEST).check(&pendulum);
    // lω0 = √(gl) = 2.
    assert!(matches!(fast, Err(Invalid::TooFast { most, .. }) if most == 2.0 * FASTEST), "{fast:?}");
    let rising = Launch::Plane { x: 4.0 * (1.0 - 1e-15), y: 0.0, vx: 1e72, vy: 0.0 };
    // Next to the support's level the bob goes up far faster than outwards.
    assert!(matches!(rising.check(&pendulum), Err(Invalid::TooFast { .. })));
    for extreme in EXTREMES {
        assert_eq!(Pendulum { length: extreme, gravity: extreme, mass: extreme }.check(), Ok(()));
        let beyond = extreme * extreme.sqrt();
        for pendulum in [
            Pendulum { length: beyond, ..UNIT },
            Pendulum { gravity: beyond, ..UNIT },
            Pendulum { mass: beyond, ..UNIT },
        ] {
            let wrong = pendulum.check();
            assert!(
                matches!(wrong, Err(Invalid::BeyondNumbers { value, least, most })
                    if value.value == beyond && [least, most] == EXTREMES),
                "{wrong:?}"
            );
        }
    }
}

/// At both ends of the range the motion has the digits that it has elsewhere.
#[test]
fn within_the_range_no_digits_are_lost() {
    let near = |value: f64, expected: f64| (value / expected - 1.0).abs() < 1e-14;
    for b in [1.0, 0.5] {
        let a = SMALLEST;
        let launch = Launch::Apsides { a, b: a * b, azimuth: 0.0 };
        let motion = ExactMotion::new(UNIT, launch).expect("within the range");
        let [outer, inner] = motion.turning_radii();
        assert!(near(outer, a) && near(inner, a * b), "{outer:e} {inner:e}");
        assert!(near(motion.precession(), 0.375 * a * a * b));
        assert_eq!(motion.frequency(), 1.0);
    }
    let speed = 0.99 * FASTEST;
    let motion = ExactMotion::new(UNIT, Launch::Ellipse { a: 0.5, b: speed, azimuth: 0.0 }).expect("within the range");
    let mut place = [0.0; 3];
    motion.fill(kugelpendel::Quantity::Position, kugelpendel::Times::Scattered(&[1.0 / speed]), &mut place);
    // A great circle, run through with this speed.
    let expected = [0.5 * 1f64.cos(), 1f64.sin(), 0.75f64.sqrt() * 1f64.cos()];
    assert!(place.iter().zip(expected).all(|(p, q)| (p - q).abs() < 1e-15), "{place:?}");
}

#[test]
fn what_acts_comes_from_numbers_by_their_names() {
    let at = |name: &str| Acting::NAMES.iter().position(|known| *known == name).expect("a name");
    let mut numbers = [None; Acting::NAMES.len()];
    assert_eq!(Acting::of(numbers), Acting::default());
    assert!(!Acting::of(numbers).acts());
    for (name, value) in [
        ("site.latitude", POLE.latitude),
        ("drag.linear", 1e-4),
        ("suspension.axis", 0.3),
        ("bob.density", 8e3),
        ("drive.push", 1e-3),
        ("drive.radius", 0.2),
    ] {
        numbers[at(name)] = Some(value);
    }
    let acting = Acting::of(numbers);
    assert_eq!(acting.site, Some(POLE));
    assert_eq!(acting.drag, Some(Drag { linear: 1e-4, quadratic: 0.0 }));
    assert_eq!(acting.suspension, Some(Suspension { axis: 0.3, ..Suspension::default() }));
    assert_eq!(acting.drive, Drive::Radius { push: 1e-3, radius: 0.2 });
    let Forces { damping, rotation, axis, .. } = acting.forces();
    assert_eq!((damping, rotation[1], axis), (1e-4, ROTATION, 0.3));
    assert!(acting.acts());
    // A bob without a radius.
    assert!(matches!(acting.check(&UNIT), Err(Invalid::NotPositive { value: Seen { name: "bob.radius", .. } })));
}

#[test]
fn the_bob_changes_the_gravity_that_acts_and_keeps_its_weight() {
    let bob = Bob { radius: 0.1, density: 8e3, thread_mass: 0.0, air_density: 1.2 };
    let acting = Acting { bob: Some(bob), ..Acting::default() };
    let effective = acting.effective_pendulum(&UNIT).expect("a bob that fits");
    let beta = 1.2 / 8e3;
    assert!((effective.gravity - (1.0 - beta) / (1.0 + beta / 2.0 + 0.4 * 0.01)).abs() < 1e-15);
    assert!((effective.gravity * effective.mass - 1.0).abs() < 1e-15);
    assert!(acting.effective_pendulum(&Pendulum { length: 0.1, ..UNIT }).is_err());
}

#[test]
fn normal_gravity_is_that_of_the_tables() {
    // NIMA TR8350.2 (2000), table 3.4.
    assert!((POLE.normal_gravity() - 9.8321849378).abs() < 1e-10);
    assert!((Site { latitude: 0.0, ..POLE }.normal_gravity() - 9.7803253359).abs() < 5e-11);
    let wire = Wire { diameter: 2e-3, young: 2e11, expansion: 1.2e-5 };
    assert!((wire.cross_section() - std::f64::consts::PI * 1e-6).abs() < 1e-20);
}

#[test]
fn a_drive_pumps_without_end_or_it_does_not() {
    let launch = Launch::Ellipse { a: 0.2, b: 0.0, azimuth: 0.0 };
    let driven = |push: f64, linear: f64| Acting {
        drag: Some(Drag { linear, quadratic: 0.0 }),
        drive: Drive::Phase { push, phase: 0.0 },
        ..Acting::default()
    };
    let pumping = |acting: Acting| acting.settle(&UNIT, &launch);
    assert!(matches!(pumping(driven(1e-3, 0.0)), Err(Invalid::Pumping { push: 1e-3, .. })));
    // What keeps the amplitude is what the drag takes: γa = p/π.
    let refused = pumping(driven(1.0, 1e-2));
    let Err(Invalid::PumpingTooHard { keeps, amplitude, .. }) = refused else { panic!("{refused:?}") };
    assert!((keeps - std::f64::consts::PI * 1e-2 * 0.2).abs() < 1e-15 && (amplitude - 0.2).abs() < 1e-15);
    assert_eq!(pumping(driven(keeps, 1e-2)), Ok(UNIT));
    assert!(EnvelopeMotion::under(&driven(1.0, 1e-2), UNIT, launch, true, 1.0).is_err());
    assert!(RealMotion::under(&driven(1.0, 1e-2), UNIT, launch, Thread::Ends, 1e-17).is_err());
    assert!(RealMotion::under(&driven(keeps, 1e-2), UNIT, launch, Thread::Ends, 1e-17).is_ok());
}
