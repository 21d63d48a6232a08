//! The portrait on the sphere: against its own differential equations, against the averaged motion, and at its edges.

use kugelpendel::{
    Drive, EllipseForm, Envelope, EnvelopeMotion, EnvelopeWalks, Forces, Orbit, Pendulum, Portrait, Verdict,
    critical_amplitude, critical_anisotropy, intrinsic,
};
use std::f64::consts::{FRAC_PI_2, PI};

/// A sequence of numbers between 0 and 1 that is the same every time (SplitMix64).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// The shape as a unit vector: its equations have no poles, d/dt (x, y, u) = rates × … .
fn rates(portrait: &Portrait, [x, y, u]: [f64; 3]) -> [f64; 3] {
    // x + iy = √(1−u²) e^{iφ}: φ' without the clamp turns it, the clamp turns it about the x axis.
    let spin = portrait.intrinsic * u - 2.0 * portrait.rotation;
    let delta = portrait.anisotropy;
    [-spin * y, spin * x - delta * u, delta * y]
}

/// Integrated for a time: the least and the largest u, the turns of φ, the least and the largest of φ against the start.
fn followed(portrait: &Portrait, start: EllipseForm, time: f64) -> ([f64; 2], f64, [f64; 2], [f64; 3]) {
    let straight = (1.0 - start.circularity * start.circularity).sqrt();
    let mut state = [straight * start.longitude.cos(), straight * start.longitude.sin(), start.circularity];
    let fastest = portrait.anisotropy.abs() + portrait.intrinsic + 2.0 * portrait.rotation.abs();
    let steps = (200.0 * time * fastest).ceil() as usize;
    let step = time / steps as f64;
    let (mut limits, mut turned, mut reach) = ([state[2]; 2], 0.0, [0.0_f64; 2]);
    for _ in 0..steps {
        let moved = |k: [f64; 3], share: f64| std::array::from_fn(|i| state[i] + share * step * k[i]);
        let first = rates(portrait, state);
        let second = rates(portrait, moved(first, 0.5));
        let third = rates(portrait, moved(second, 0.5));
        let fourth = rates(portrait, moved(third, 1.0));
        let next: [f64; 3] =
            std::array::from_fn(|i| state[i] + step / 6.0 * (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i]));
        turned += (state[0] * next[1] - state[1] * next[0]).atan2(state[0] * next[0] + state[1] * next[1]);
        limits = [limits[0].min(next[2]), limits[1].max(next[2])];
        reach = [reach[0].min(turned), reach[1].max(turned)];
        state = next;
    }
    (limits, turned, reach, state)
}

fn random_case(numbers: &mut Numbers) -> (Portrait, EllipseForm) {
    let rotation = numbers.between(-1.0, 1.0);
    let portrait = Portrait {
        rotation,
        anisotropy: rotation * 10f64.powf(numbers.between(-1.5, 1.0)) * if numbers.next() < 0.5 { -1.0 } else { 1.0 },
        axis: numbers.between(-2.0, 2.0),
        intrinsic: rotation.abs() * 10f64.powf(numbers.between(-2.0, 1.5)),
    };
    let form = EllipseForm { circularity: numbers.between(-0.9, 0.9), longitude: numbers.between(-PI, PI) };
    (portrait, form)
}

#[test]
fn an_orbit_is_what_its_equations_give() {
    let mut numbers = Numbers(7);
    for _ in 0..60 {
        let (portrait, start) = random_case(&mut numbers);
        let orbit = portrait.orbit(start);
        if orbit.period > 60.0 / portrait.rotation.abs() {
            continue; // next to the separatrix
        }
        let (limits, turned, reach, end) = followed(&portrait, start, orbit.period);
        let case = format!("{portrait:?} from {start:?}: {orbit:?}");
        for k in 0..2 {
            assert!((limits[k] - orbit.limits[k]).abs() < 2e-4, "{limits:?}, {case}");
        }
        // Back where it was after a period.
        assert!((end[2] - start.circularity).abs() < 1e-6, "{end:?}, {case}");
        match orbit.verdict {
            Verdict::Round => {
                let way = orbit.rate.signum();
                assert!((turned - way * 2.0 * PI).abs() < 1e-6, "{turned}, {case}");
                assert!((orbit.rate * orbit.period - way * PI).abs() < 1e-12, "{case}");
            }
            _ => {
                assert!(turned.abs() < 1e-6, "{turned}, {case}");
                assert_eq!(orbit.rate, 0.0);
                let azimuth = portrait.axis + 0.5 * start.longitude;
                for k in 0..2 {
                    let seen = azimuth + 0.5 * reach[k];
                    assert!((seen - orbit.azimuths[k]).abs() < 2e-3, "{reach:?}, {case}");
                }
            }
        }
    }
}

#[test]
fn a_path_keeps_the_invariant_and_goes_the_way_of_the_motion() {
    let mut numbers = Numbers(12);
    for _ in 0..60 {
        let (portrait, start) = random_case(&mut numbers);
        let path = portrait.path(start, 401);
        let h = portrait.invariant(start);
        let scale = portrait.anisotropy.abs() + portrait.intrinsic + portrait.rotation.abs();
        for pair in path.windows(2) {
            assert!((portrait.invariant(pair[0]) - h).abs() < 1e-12 * scale, "{portrait:?}, {start:?}");
            let risen = pair[1].circularity - pair[0].circularity;
            let rises = portrait.anisotropy * (pair[0].longitude.sin() + pair[1].longitude.sin());
            assert!(risen * rises >= -1e-12, "{portrait:?}, {pair:?}");
        }
    }
    for rotation in [1.0, -1.0] {
        let even = Portrait { rotation, anisotropy: 0.0, axis: 0.0, intrinsic: 0.0 };
        let path = even.path(EllipseForm { circularity: 0.1, longitude: 0.0 }, 5);
        let ahead: Vec<f64> = path.windows(2).map(|pair| pair[1].longitude - pair[0].longitude).collect();
        assert!(ahead.iter().all(|step| step * rotation < 0.0), "{path:?}");
    }
}

#[test]
fn slowest_and_fastest_are_passed_on_the_way() {
    let mut numbers = Numbers(8);
    for _ in 0..40 {
        let (portrait, start) = random_case(&mut numbers);
        let orbit = portrait.orbit(start);
        let way = -portrait.rotation.signum();
        let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
        let [low, high] = orbit.limits;
        for step in 0..=4000 {
            let u = low + (high - low) * f64::from(step) / 4000.0;
            let g = orbit.invariant + 2.0 * portrait.rotation * u - 0.5 * portrait.intrinsic * u * u;
            let cos = g / (portrait.anisotropy * (1.0 - u * u).sqrt());
            let rate = portrait.rate(EllipseForm { circularity: u, longitude: cos.clamp(-1.0, 1.0).acos() });
            (least, most) = (least.min(way * rate), most.max(way * rate));
        }
        let scale = most.abs().max(least.abs());
        assert!((way * orbit.slowest - least).abs() < 1e-4 * scale, "{portrait:?}, {start:?}, {orbit:?}, {least}");
        assert!((way * orbit.fastest - most).abs() < 1e-4 * scale, "{portrait:?}, {start:?}, {orbit:?}, {most}");
    }
}

#[test]
fn small_swings_turn_about_a_tilted_axis() {
    // Round where cos φ0, from the axis on whose side it starts, is below 2|Ω_z|/|δ|.
    for rotation in [1.0, -1.0] {
        for anisotropy in [3.0, -3.0] {
            let portrait = Portrait { rotation, anisotropy, axis: 0.0, intrinsic: 0.0 };
            for middle in [0.0, PI] {
                let edge = f64::acos(2.0 / 3.0);
                for (longitude, verdict) in
                    [(edge - 1e-9, Verdict::ToAndFro), (edge + 1e-9, Verdict::Round), (0.0, Verdict::ToAndFro)]
                {
                    let start = EllipseForm { circularity: 0.0, longitude: middle + longitude };
                    assert_eq!(portrait.orbit(start).verdict, verdict, "{portrait:?}, {longitude}");
                }
            }
            // A turn of the sphere takes 2π/√(δ² + 4Ω_z²), whatever the start.
            let start = EllipseForm { circularity: 0.3, longitude: 1.0 };
            assert!((portrait.orbit(start).period - 2.0 * PI / 13f64.sqrt()).abs() < 1e-13);
        }
    }
}

#[test]
fn without_a_clamp_the_plane_turns_evenly() {
    let portrait = Portrait { rotation: 1.0, anisotropy: 0.0, axis: 0.3, intrinsic: 3.0 };
    let orbit = portrait.orbit(EllipseForm { circularity: 0.5, longitude: 0.2 });
    assert_eq!((orbit.verdict, orbit.rate, orbit.slowest), (Verdict::Round, -0.25, -0.25));
    assert!((orbit.period - 4.0 * PI).abs() < 1e-14);
    let still = portrait.orbit(EllipseForm { circularity: 2.0 / 3.0, longitude: 0.2 });
    assert_eq!(still.verdict, Verdict::Stands);
}

#[test]
fn equilibria_stand_and_are_two_more_stable_ones_than_saddles() {
    let mut numbers = Numbers(9);
    let mut saddles = 0;
    for _ in 0..200 {
        let (portrait, _) = random_case(&mut numbers);
        let found = portrait.equilibria();
        let stable = found.iter().filter(|equilibrium| equilibrium.stable).count();
        assert_eq!(stable, found.len() - stable + 2, "{portrait:?}: {found:?}");
        saddles += found.len() - stable;
        for equilibrium in &found {
            let rate = portrait.rate(equilibrium.form);
            let scale = portrait.anisotropy.abs() + portrait.intrinsic + portrait.rotation.abs();
            assert!(rate.abs() < 1e-6 * scale, "{portrait:?}: {equilibrium:?} turns with {rate}");
        }
    }
    assert!(saddles > 10, "{saddles}");
}

#[test]
fn critical_anisotropy_parts_the_straight_starts() {
    let mut numbers = Numbers(10);
    for _ in 0..60 {
        let rotation = numbers.between(0.1, 1.0) * if numbers.next() < 0.5 { -1.0 } else { 1.0 };
        let intrinsic = rotation.abs() * 10f64.powf(numbers.between(-3.0, 2.0));
        let critical = critical_anisotropy(rotation, intrinsic);
        for sign in [1.0, -1.0] {
            let stalls = |share: f64| {
                let portrait = Portrait { rotation, anisotropy: sign * share * critical, axis: 0.0, intrinsic };
                (0..=180).any(|k| {
                    let start = EllipseForm { circularity: 0.0, longitude: PI * f64::from(k) / 90.0 };
                    portrait.orbit(start).verdict != Verdict::Round
                })
            };
            assert!(!stalls(1.0 - 1e-6), "{rotation}, {intrinsic}");
            assert!(stalls(1.0 + 1e-6), "{rotation}, {intrinsic}");
        }
    }
    // Small and large swings.
    assert_eq!(critical_anisotropy(0.5, 0.0), 1.0);
    assert!((critical_anisotropy(0.5, 1e4) / (0.25 / 1e4) - 1.0).abs() < 1e-6);
}

#[test]
fn critical_amplitude_is_the_inverse() {
    let pendulum = Pendulum { length: 20.0, gravity: 9.81, mass: 1.0 };
    let omega0 = pendulum.angular_frequency();
    for rotation in [5e-5, -5e-5] {
        for share in [1e-3, 0.05, 0.17, 0.19, 0.2, 0.5, 0.999] {
            let anisotropy = share * 2.0 * rotation;
            let a = critical_amplitude(&pendulum, rotation, anisotropy);
            let back = critical_anisotropy(rotation, intrinsic(omega0, (a / pendulum.length).powi(2)));
            assert!((back / anisotropy.abs() - 1.0).abs() < 1e-10, "{share}: {a}, {back}");
        }
        assert_eq!(critical_amplitude(&pendulum, rotation, 2.0 * rotation), 0.0);
        assert_eq!(critical_amplitude(&pendulum, rotation, 0.0), f64::INFINITY);
    }
    assert_eq!(critical_amplitude(&pendulum, 0.0, 1e-6), 0.0);
}

/// By how much the plane of the averaged motion turned, and the largest turn from the start on the way.
fn averaged(pendulum: Pendulum, ellipse: [f64; 3], forces: Forces, time: f64) -> (f64, f64) {
    let motion = EnvelopeMotion::at_apsis(pendulum, ellipse, forces, Drive::Absent, 1.0).unwrap();
    let times: Vec<f64> = (0..=2000).map(|k| time * f64::from(k) / 2000.0).collect();
    let mut azimuth = vec![0.0; times.len()];
    motion.fill(Envelope::Azimuth, &times, &mut azimuth, &mut EnvelopeWalks::default(), &|| false).unwrap();
    let turned = azimuth.iter().map(|value| value - azimuth[0]);
    (azimuth[2000] - azimuth[0], turned.map(f64::abs).fold(0.0, f64::max))
}

#[test]
fn the_averaged_motion_follows_the_portrait() {
    let mut numbers = Numbers(11);
    let mut counts = [0, 0];
    for _ in 0..80 {
        let pendulum = Pendulum { length: numbers.between(0.5, 70.0), gravity: 9.81, mass: 1.0 };
        let rotation = 7.292115e-5 * numbers.between(-1.0, 1.0);
        let forces = Forces {
            rotation: [0.0, rotation],
            anisotropy: rotation
                * 10f64.powf(numbers.between(-1.5, 1.0))
                * if numbers.next() < 0.5 { -1.0 } else { 1.0 },
            axis: numbers.between(-1.5, 1.5),
            ..Forces::default()
        };
        let a = pendulum.length * 10f64.powf(numbers.between(-3.0, -0.9));
        let b = a * numbers.between(-0.3, 0.3);
        let azimuth = numbers.between(-1.5, 1.5);
        let portrait = Portrait::new(&pendulum, &forces, a, b);
        let orbit: Orbit = portrait.orbit(portrait.form(a, b, azimuth));
        if orbit.period * rotation.abs() > 40.0 {
            continue; // next to the separatrix neither the average nor the orbit is sharp
        }
        if orbit.limits[0] < -0.999 || orbit.limits[1] > 0.999 {
            continue; // nor is the plane of what comes so near to a circle
        }
        let (turned, most) = averaged(pendulum, [a, b, azimuth], forces, 4.0 * orbit.period);
        let case = format!("{pendulum:?}, {forces:?}, {a}, {b}, {azimuth}: {orbit:?}, {turned}");
        if orbit.verdict == Verdict::Round {
            counts[0] += 1;
            assert!((turned - 4.0 * PI * orbit.rate.signum()).abs() < 0.05, "{case}");
        } else {
            counts[1] += 1;
            assert!(most < PI, "{case}");
            let reach = orbit.azimuths.map(|edge| (edge - azimuth).abs()).into_iter().fold(0.0, f64::max);
            assert!((most - reach).abs() < 0.02, "{case}, {most}");
        }
    }
    assert!(counts[0] > 15 && counts[1] > 15, "{counts:?}");
}

#[test]
fn half_of_the_old_bound_and_yet_it_turns_back() {
    // 4.803 m, periods 4.4000 and 4.4005 s, 41.133° S, 1.2 cm at 5°: −10° in 60 h in place of +593°.
    let pendulum = Pendulum { length: 4.803, gravity: 9.803, mass: 1.0 };
    let rotation = 7.292115e-5 * (-41.133f64).to_radians().sin();
    let anisotropy = 2.0 * PI / 4.4 - 2.0 * PI / 4.4005;
    let forces = Forces { rotation: [0.0, rotation], anisotropy, ..Forces::default() };
    let (a, azimuth) = (0.012, 5f64.to_radians());
    let portrait = Portrait::new(&pendulum, &forces, a, 0.0);
    let orbit = portrait.orbit(portrait.form(a, 0.0, azimuth));
    assert_eq!(orbit.verdict, Verdict::ToAndFro);
    let (turned, most) = averaged(pendulum, [a, 0.0, azimuth], forces, 60.0 * 3600.0);
    assert!((turned.to_degrees() + 10.0).abs() < 2.0, "{}", turned.to_degrees());
    assert!(most < FRAC_PI_2);
    assert_eq!(critical_amplitude(&pendulum, rotation, anisotropy), 0.0);
}
