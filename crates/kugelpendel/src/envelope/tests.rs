//! Each average against its definition.

use super::closed_form::ClosedForm;
use super::drag::Speeds;
use super::swing::{Swing, half_angle};
use super::tableau::{ALL, DENSE, ERROR, STAGE, STAGES};
use crate::{Acting, Drag, Envelope, EnvelopeMotion, EnvelopeWalks, ExactMotion, Launch, Pendulum, Quantity, Times};
use num_complex::Complex64;
use std::f64::consts::TAU;

const UNIT: Pendulum = Pendulum { length: 1.0, gravity: 1.0, mass: 1.0 };
const RADII: [f64; 7] = [1e-6, 1e-3, 0.045, 0.3, 0.7, 0.95, 0.999];
const SHARES: [f64; 9] = [-1.0, -0.999, -0.5, -1e-6, 0.0, 1e-3, 0.3, 0.9, 1.0];

fn close(found: f64, expected: f64, relative: f64) {
    assert!((found - expected).abs() <= relative * expected.abs() + 1e-300, "{found} is not {expected}");
}

fn exact(a: f64, b: f64) -> ExactMotion {
    let Ok(motion) = ExactMotion::new(UNIT, Launch::Apsides { a, b, azimuth: 0.0 }) else { unreachable!("{a}, {b}") };
    motion
}

/// x and y of the radii a and b, b with the sign of the sense.
fn squares(a: f64, b: f64) -> [f64; 2] {
    let mut squares = half_angle([a, b.abs()]);
    if b < 0.0 {
        squares.reverse();
    }
    let [x, y] = squares;
    [x.max(1e-32 * (x + y)), y.max(1e-32 * (x + y))]
}

fn form(a: f64, b: f64) -> ClosedForm<f64> {
    let [x, y] = squares(a, b);
    ClosedForm::of(x, y)
}

#[test]
fn rates_are_those_of_the_closed_form() {
    for a in RADII {
        for share in SHARES {
            let (b, motion) = (a * share, exact(a, a * share));
            let ideal = form(a, b);
            close(ideal.frequency, motion.frequency(), 4e-15);
            // b, of which Ω has the relative error, is a difference here: an ulp of a.
            let error = (ideal.precession - motion.precession()).abs();
            assert!(error <= 1e-13 * motion.precession().abs() + 1e-15 * a * a, "{a}, {b}: {error}");
        }
    }
}

#[test]
fn places_after_a_step_are_those_of_the_swing_there() {
    for a in RADII {
        for share in SHARES {
            let from = form(a, a * share).actions();
            let Some(swing) = Swing::of(from) else { unreachable!("{a}, {share}") };
            // Just below where the swing itself is looked for, its derivatives leave out 1e-16 l.
            let edge = (1e-16 / (swing.x + swing.y).powf(1.5)).sqrt().min(0.1);
            let around = [(0.9 * edge, 1e-16), (0.99 * edge, 1e-16), (1.1 * edge, 0.0)];
            for (step, left_out) in [1e-3, 1e-6, 1e-7, 1e-9, 0.0].map(|step| (step, 0.0)).into_iter().chain(around) {
                let to = [from[0] * (1.0 - step), from[1] * (1.0 - 0.3 * step)];
                let Some(there) = Swing::of(to) else { unreachable!("{a}, {share}, {step}") };
                for phase in [0.0, 0.7, 2.5] {
                    let turn = Complex64::cis(phase);
                    let found = swing.place_after(from.map(f64::sqrt), to.map(f64::sqrt), turn);
                    let expected = there.form.place(turn, |harmonic| harmonic.value);
                    let error = found.map_or(f64::NAN, |found| (found - expected).norm());
                    assert!(error <= 2e-15 * a.sqrt() + left_out, "{a}, {share}, {step}, {phase}: off by {error}");
                }
            }
        }
    }
}

#[test]
fn places_and_velocities_are_those_of_the_exact_motion() {
    for a in RADII {
        for share in SHARES {
            let (b, motion) = (a * share, exact(a, a * share));
            let ideal = form(a, b);
            for time in [0.0, 0.4, 1.7, 2.9] {
                let turn = Complex64::cis(ideal.frequency * time);
                let frame = Complex64::cis(ideal.precession * time);
                for (found, quantity) in [
                    (ideal.place(turn, |harmonic| harmonic), Quantity::Position),
                    (ideal.velocity(turn), Quantity::Velocity),
                ] {
                    let mut expected = [0.0; 3];
                    motion.fill(quantity, Times::Scattered(&[time]), &mut expected);
                    let found = frame * found;
                    let error = (found - Complex64::new(expected[0], expected[1])).norm();
                    let size = expected[0].hypot(expected[1]).max(a);
                    // The rates' relative errors, times the time: next to the support the circle's rate is 5.
                    let turned = (ideal.frequency + ideal.precession.abs()) * time;
                    assert!(error <= (4e-14 + 4e-15 * turned) * size, "{a}, {b}, {time}: {quantity:?} off by {error}");
                }
            }
        }
    }
}

#[test]
fn actions_are_those_of_the_field() {
    // Their difference is the angular momentum, and of the energy they have the derivatives ω ± Ω.
    let step = 1e-5;
    for a in [1e-3, 0.1, 0.5, 0.9] {
        for share in [-0.8, 0.01_f64, 0.2, 0.7, 0.99] {
            let b = a * share;
            let ideal = form(a, b);
            let [first, second] = ideal.actions();
            close(first - second, exact(a, b).angular_momentum(), 1e-13 * (first + second) / (first - second).abs());
            let varied = |a: f64| {
                let [first, second] = form(a, b).actions();
                [exact(a, b).energy(), first, second]
            };
            let ([after, x_after, y_after], [before, x_before, y_before]) =
                (varied(a * (1.0 + step)), varied(a * (1.0 - step)));
            let by_actions = (ideal.frequency + ideal.precession) * (x_after - x_before)
                + (ideal.frequency - ideal.precession) * (y_after - y_before);
            close(by_actions, after - before, 1e-8);
        }
    }
}

#[test]
fn a_swing_is_found_by_its_actions() {
    for a in RADII {
        for share in SHARES {
            let b = a * share;
            let actions = form(a, b).actions();
            let Some(swing) = Swing::of(actions) else { unreachable!("{a}, {b}") };
            let [outer, inner] = swing.radii();
            close(outer, a, 4e-15);
            assert!((inner - b).abs() <= 4e-15 * a, "{a}, {b}: {inner}");
            // Derivatives along the actions: of the energy they are the rates.
            let energy = |actions: [f64; 2]| {
                let radii = Swing::of(actions).map(|swing| swing.radii());
                let Some([a, b]) = radii else { unreachable!("{actions:?}") };
                exact(a.min(0.9999), b.clamp(-a, a)).energy()
            };
            if (0.01..0.96).contains(&a) && share.abs() < 0.99 {
                let step = 1e-5;
                let [x, y] = actions;
                let slope = (energy([x * (1.0 + step), y]) - energy([x * (1.0 - step), y])) / (2.0 * step * x);
                close(slope, swing.form.frequency.value + swing.form.precession.value, 1e-7);
            }
        }
    }
}

#[test]
fn derivatives_are_differences() {
    let step = 1e-4;
    for a in [0.05, 0.4, 0.9] {
        for share in [-0.7, 0.02, 0.5, 0.95] {
            let [x, y] = form(a, a * share).actions();
            let of = |x: f64, y: f64| {
                let Some(swing) = Swing::of([x, y]) else { unreachable!() };
                let m = swing.form.sum(|(_, ahead, behind)| ahead * behind);
                let r = swing.form.sum(|(order, ahead, behind)| (ahead * ahead + behind * behind) * order);
                [(m.value, swing.along_actions(m)), (r.value, swing.along_actions(r))]
            };
            let here = of(x, y);
            for (k, (up, down)) in
                [(of(x * (1.0 + step), y), of(x * (1.0 - step), y)), (of(x, y * (1.0 + step)), of(x, y * (1.0 - step)))]
                    .into_iter()
                    .enumerate()
            {
                for n in 0..2 {
                    let difference = (up[n].0 - down[n].0) / (2.0 * step);
                    assert!((difference - here[n].1[k]).abs() < 3e-8 * here[n].0.abs(), "{a}, {share}, {k}, {n}");
                }
            }
        }
    }
}

#[test]
fn brackets_are_their_beginning() {
    let (p, q) = (2e-3, 1.5e-3);
    let ideal = form(p + q, p - q);
    let bracketed = Swing::first_order([p * p, q * q]).form;
    close(bracketed.frequency.value, ideal.frequency, 1e-10);
    close(bracketed.precession.value, ideal.precession, 1e-5);
}

/// Energy and angular momentum of the radii p + q, p − q.
fn constants(p: f64, q: f64) -> [f64; 2] {
    let height = |r: f64| r * r / (1.0 + (1.0 - r * r).sqrt());
    let (high, low) = (height(p + q), height((p - q).abs()));
    let excess = high * low / (2.0 - high - low);
    [high + low + excess, (2.0 * high * low * (2.0 + excess)).sqrt()]
}

#[test]
fn linear_drag_takes_its_share_of_energy_and_angular_momentum() {
    // It takes both actions alike, like e^{−2t} for a drag −2v.
    for a in [1e-3, 0.1, 0.5, 0.9] {
        for share in [0.01_f64, 0.2, 0.7, 0.99] {
            let b = a * share;
            let (p, q) = (0.5 * (a + b), 0.5 * (a - b));
            let motion = exact(a, b);
            // ⟨v²⟩ over a swing, in which the trapezoidal rule converges geometrically.
            let (count, period) = (200, motion.radial_period());
            let mut mean_square = 0.0;
            for k in 0..count {
                let mut v = [0.0; 3];
                let time = [period * f64::from(k) / f64::from(count)];
                motion.fill(Quantity::Velocity, Times::Scattered(&time), &mut v);
                mean_square += v.iter().map(|v| v * v).sum::<f64>() / f64::from(count);
            }
            let h = 1e-5;
            let faded = |h: f64| {
                let Some(swing) = Swing::of(form(a, b).actions().map(|action| action * (-2.0 * h).exp())) else {
                    unreachable!("{a}, {b}")
                };
                let [a, b] = swing.radii();
                constants(0.5 * (a + b), 0.5 * (a - b))
            };
            let ([after, spin_after], [before, spin_before]) = (faded(h), faded(-h));
            close((after - before) / (2.0 * h), -2.0 * mean_square, 1e-8);
            close((spin_after - spin_before) / (2.0 * h), -2.0 * constants(p, q)[1], 1e-8);
        }
    }
}

/// ⟨|v|⟩ and Cov(v², |v|) over the square of the heights' range, by the trapezoidal rule in time.
fn speeds(a: f64, b: f64, count: u32) -> [f64; 2] {
    let motion = exact(a, b);
    let period = motion.radial_period();
    let times: Vec<f64> = (0..count).map(|k| period * (f64::from(k) + 0.5) / f64::from(count)).collect();
    let mut velocities = vec![0.0; 3 * times.len()];
    motion.fill(Quantity::Velocity, Times::Scattered(&times), &mut velocities);
    let squares: Vec<f64> = velocities.chunks_exact(3).map(|v| v.iter().map(|v| v * v).sum()).collect();
    let mean = |f: &dyn Fn(f64) -> f64| squares.iter().map(|square| f(*square)).sum::<f64>() / f64::from(count);
    let (speed, square) = (mean(&f64::sqrt), mean(&|square| square));
    let [high, low] = motion.turning_heights();
    [speed, mean(&|v| (v - square) * (v.sqrt() - speed)) / ((high - low) * (high - low))]
}

#[test]
fn quadratic_drag_takes_what_the_mean_speed_and_one_covariance_say() {
    for a in [1e-3, 0.1, 0.5, 0.9, 0.99] {
        for (share, count, relative) in
            [(0.99, 400, 1e-10), (0.7, 400, 1e-11), (0.3, 400, 1e-11), (0.1, 2000, 1e-11), (0.0, 40_000, 2e-9)]
        {
            let [x, y] = squares(a, a * share);
            let found = Speeds::of(x, y);
            let [mean, covariance] = speeds(a, a * share, count);
            close(found.mean, mean, relative);
            close(found.covariance, covariance, 10.0 * relative);
        }
    }
}

#[test]
fn quadratic_drag_is_regular_on_the_circle_and_where_the_rule_changes() {
    for a in [0.01, 0.5, 0.9] {
        let (on, near) = (Speeds::of(0.5 * a * a, 0.0), Speeds::of(0.5 * a * a, 1e-14 * a * a));
        close(near.mean, on.mean, 1e-12);
        close(near.covariance, on.covariance, 1e-12);
        // κ passes 0.7 between these two.
        let thin = |share: f64| Speeds::of(a * a * 0.3, a * a * 0.3 * share);
        let bounds: Vec<f64> = (0..200).map(|k| thin(0.12 + 1e-3 * f64::from(k)).covariance).collect();
        let bends = bounds.windows(4).map(|w| (w[3] - 3.0 * w[2] + 3.0 * w[1] - w[0]).abs());
        let most = bends.fold(0.0, f64::max);
        assert!(most < 2e-7 * bounds[0], "{a}: {most}");
    }
}

/// p'/p and q'/q of small swings under quadratic drag, over c.
fn decay(p: f64, q: f64) -> [f64; 2] {
    let Speeds { mean, covariance } = Speeds::of_small(p, q);
    [q, p].map(|other| -0.5 * mean - other * other * covariance)
}

#[test]
fn quadratic_drag_is_the_average_of_the_textbook() {
    for (a, b) in [(1.0, 0.3), (0.7, -0.65), (0.2, 0.2), (0.5, 0.499_999), (0.4, 0.01)] {
        let (p, q) = (0.5 * (a + b), 0.5 * (a - b));
        let [dp, dq] = decay(p, q);
        let count = 20_000;
        let (mut with_sin, mut with_cos) = (0.0, 0.0);
        for k in 0..count {
            let (s, c) = (TAU * (f64::from(k) + 0.5) / f64::from(count)).sin_cos();
            let speed = (a * s).hypot(b * c);
            with_sin += speed * s * s / f64::from(count);
            with_cos += speed * c * c / f64::from(count);
        }
        let (da, db) = (-a * with_sin, -b * with_cos);
        close(p * dp + q * dq, da, 1e-12);
        close(p * dp - q * dq, db, 1e-12);
    }
}

#[test]
fn quadratic_drag_in_the_plane() {
    // −(4/3π)cω0 a² and −(2/3π)cω0 ab, docs/conventions.md.
    for b in [0.0, 1e-9] {
        let (a, pi) = (0.3, std::f64::consts::PI);
        let (p, q) = (0.5 * (a + b), 0.5 * (a - b));
        let [dp, dq] = decay(p, q);
        close(p * dp + q * dq, -4.0 / (3.0 * pi) * a * a, 1e-12);
        assert!((p * dp - q * dq + 2.0 / (3.0 * pi) * a * b).abs() < 1e-13);
    }
}

#[test]
fn the_method_has_the_order_it_should() {
    // Sums of each row give the nodes; the weights integrate the powers of the nodes up to the seventh.
    let nodes: Vec<f64> = std::iter::once(0.0).chain(STAGE.iter().map(|row| row.iter().sum())).collect();
    assert_eq!(nodes.len(), ALL);
    for power in 0..8 {
        let sum: f64 = STAGE[STAGES - 1].iter().zip(&nodes).map(|(weight, node)| weight * node.powi(power)).sum();
        close(sum, 1.0 / f64::from(power + 1), 1e-13);
    }
    for weights in ERROR {
        assert!(weights.iter().sum::<f64>().abs() < 1e-14);
    }
    for weights in DENSE {
        assert!(weights.iter().sum::<f64>().abs() < 1e-12);
    }
}

fn read(motion: &EnvelopeMotion, what: Envelope, time: f64) -> Vec<f64> {
    let mut out = vec![f64::NAN; what.width()];
    assert!(motion.fill(what, &[time], &mut out, &mut EnvelopeWalks::default(), &|| false).is_ok());
    out
}

#[test]
fn the_intrinsic_precession_is_multiplied_and_nothing_else() {
    let launch = Launch::Ellipse { a: 0.3, b: 0.1, azimuth: 0.4 };
    let still = Acting::default();
    let dragged = Acting { drag: Some(Drag { linear: 1e-4, quadratic: 1e-3 }), ..still };
    for acting in [still, dragged] {
        let under = |intrinsic: f64| {
            let Ok(motion) = EnvelopeMotion::under(&acting, UNIT, launch, true, intrinsic) else { unreachable!() };
            motion
        };
        let (one, more) = (under(1.0), under(1.7));
        let places = [Quantity::Position, Quantity::Velocity].map(Envelope::Point);
        for what in places {
            let launched = read(&one, what, 0.0).into_iter().zip(read(&more, what, 0.0));
            launched.for_each(|(one, more)| assert!((one - more).abs() < 1e-15, "{what:?}: {one} and {more}"));
        }
        for time in [0.0, 30.0, 300.0] {
            let (free, turned) = (exact_at(&one, time), exact_at(&more, time));
            let [own, by_itself, _, _, _, da, db] = read(&more, Envelope::Rates, time)[..] else { unreachable!() };
            assert_eq!(own, 0.0);
            close(by_itself, 1.7 * turned.precession(), 1e-13);
            let [_, ideal, _, _, _, fading, narrowing] = read(&one, Envelope::Rates, time)[..] else { unreachable!() };
            close(ideal, free.precession(), 1e-13);
            // The swing itself is a little another one, whose velocity at the launch has more from its turning.
            close(da, fading, 1e-2);
            close(db, narrowing, 3e-2);
            // The velocity is the rate of the place.
            let step = 1e-4;
            let [after, before] = [step, -step].map(|step| read(&more, places[0], time + step));
            for (k, velocity) in read(&more, places[1], time).into_iter().enumerate() {
                let rate = (after[k] - before[k]) / (2.0 * step);
                assert!((rate - velocity).abs() < 2e-6, "{time}: {velocity} is not {rate}");
            }
        }
    }
    let turned = |factor: f64| {
        let Ok(motion) = EnvelopeMotion::under(&still, UNIT, launch, true, factor) else { unreachable!() };
        read(&motion, Envelope::Azimuth, 100.0)[0] - read(&motion, Envelope::Azimuth, 0.0)[0]
    };
    assert_eq!(turned(0.0), 0.0);
    let axes = {
        let Ok(motion) = EnvelopeMotion::under(&still, UNIT, launch, true, 1.7) else { unreachable!() };
        read(&motion, Envelope::SemiAxes, 50.0)
    };
    close(turned(1.7), 1.7 * exact(axes[0], axes[1]).precession() * 100.0, 1e-12);
}

/// The ideal motion between the turning radii of an averaged one.
fn exact_at(motion: &EnvelopeMotion, time: f64) -> ExactMotion {
    let axes = read(motion, Envelope::SemiAxes, time);
    exact(axes[0], axes[1])
}
