//! What turns the plane: shares by causes, the portrait of the clamp, and what comes of all of it.

use crate::exchange::{refuse, tell};
use crate::given::Given;
use crate::memory::{numbers, room};
use crate::motion::Motion;
use kugelpendel::{EllipseForm, Pace, Portrait, PrecessionBudget, Verdict, settle};

/// Tells the shares of the Earth, the ellipse itself, the clamp, the damping and the drive, their sum, the rates of a and of b,
/// and the pace: 0 hurries, 1 lags, 2 stalls, 3 as it should, −1 for none. Whether there are any, as there are for the averaged
/// motion before its end.
#[unsafe(no_mangle)]
pub extern "C" fn shares(motion: &mut Motion, time: f64) -> u32 {
    let Some([earth, intrinsic, anisotropy, damping, drive, outer, inner]) = motion.rates(time) else { return 0 };
    let budget = PrecessionBudget([earth, intrinsic, anisotropy, damping, drive]);
    let pace = match budget.pace() {
        None => -1.0,
        Some(Pace::Hurries) => 0.0,
        Some(Pace::Lags) => 1.0,
        Some(Pace::Stalls) => 2.0,
        Some(Pace::AsItShould) => 3.0,
    };
    tell(&[earth, intrinsic, anisotropy, damping, drive, budget.total(), outer, inner, pace]);
    1
}

/// Tells the portrait of all ellipses of the size of one, m, in what is given: its four numbers Ω_z, δ, χ and μ, then circularity
/// and longitude of that one; its orbit, which is invariant, least and largest circularity, verdict (0 round, 1 to and fro,
/// 2 stands), period, rate, slowest, fastest and two azimuths; then how many shapes stay as they are, and of each
/// circularity, longitude and whether it is stable.
#[unsafe(no_mangle)]
pub extern "C" fn portrait(a: f64, b: f64, azimuth: f64) -> u32 {
    let given = match Given::receive() {
        Ok(given) => given,
        Err(invalid) => {
            refuse(&invalid);
            return 0;
        }
    };
    let portrait = Portrait::new(&given.effective, &given.acting.forces(), a, b);
    let form = portrait.form(a, b, azimuth);
    let orbit = portrait.orbit(form);
    let mut told = vec![portrait.rotation, portrait.anisotropy, portrait.axis, portrait.intrinsic];
    told.extend([form.circularity, form.longitude]);
    told.push(orbit.invariant);
    told.extend(orbit.limits);
    told.push(word(orbit.verdict));
    told.extend([orbit.period, orbit.rate, orbit.slowest, orbit.fastest]);
    told.extend(orbit.azimuths);
    let equilibria = portrait.equilibria();
    told.push(equilibria.len() as f64);
    for still in equilibria {
        told.extend([still.form.circularity, still.form.longitude, f64::from(still.stable)]);
    }
    tell(&told);
    1
}

/// Where another ellipse lies on the portrait of these four numbers: circularity and longitude are told.
#[unsafe(no_mangle)]
pub extern "C" fn portrait_form(axis: f64, a: f64, b: f64, azimuth: f64) {
    let form = Portrait { rotation: 0.0, anisotropy: 0.0, axis, intrinsic: 0.0 }.form(a, b, azimuth);
    tell(&[form.circularity, form.longitude]);
}

/// Places along the orbit of a form, once round: circularity and longitude, and so on.
///
/// # Safety
/// `out` has room for two numbers to each of `count` places.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn portrait_path(
    rotation: f64,
    anisotropy: f64,
    axis: f64,
    intrinsic: f64,
    circularity: f64,
    longitude: f64,
    count: usize,
    out: *mut f64,
) {
    let path = Portrait { rotation, anisotropy, axis, intrinsic }.path(EllipseForm { circularity, longitude }, count);
    // SAFETY: the caller's promise.
    let out = unsafe { room(out, 2 * count) };
    for (out, form) in out.chunks_exact_mut(2).zip(path) {
        out.copy_from_slice(&[form.circularity, form.longitude]);
    }
}

/// For each form the verdict on its orbit: 0 round, 1 to and fro, 2 stands.
///
/// # Safety
/// At `forms` lie `count` pairs of circularity and longitude, and `out` has room for a number to each.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn portrait_verdicts(
    rotation: f64,
    anisotropy: f64,
    axis: f64,
    intrinsic: f64,
    forms: *const f64,
    count: usize,
    out: *mut f64,
) {
    let portrait = Portrait { rotation, anisotropy, axis, intrinsic };
    // SAFETY: the caller's promise.
    let (forms, out) = unsafe { (numbers(forms, 2 * count), room(out, count)) };
    for (out, form) in out.iter_mut().zip(forms.chunks_exact(2)) {
        let form = EllipseForm { circularity: form[0], longitude: form[1] };
        *out = word(portrait.orbit(form).verdict);
    }
}

/// Tells what the plane comes to with all that acts: verdict as above, from when and until when it was looked at, by how much it
/// turned, two azimuths, the largest |b|, the amplitude at the end, whether the swing dies away. 0 where it is refused, which is
/// told, and 2 where it cannot be told: without a turning ground, and where it would take too long.
#[unsafe(no_mangle)]
pub extern "C" fn settles() -> u32 {
    let found = Motion::new(AVERAGED).map(|motion| motion.averaged().and_then(|motion| settle(motion, &|| false)));
    match found {
        Err(invalid) => {
            refuse(&invalid);
            0
        }
        Ok(None) => 2,
        Ok(Some(s)) => {
            let [from, to] = s.azimuths;
            let dies = f64::from(s.dies);
            tell(&[word(s.verdict), s.from, s.until, s.turned, from, to, s.widest, s.amplitude, dies]);
            1
        }
    }
}

/// The number of the law by which what settles is followed.
const AVERAGED: u32 = 4;

fn word(verdict: Verdict) -> f64 {
    match verdict {
        Verdict::Round => 0.0,
        Verdict::ToAndFro => 1.0,
        Verdict::Stands => 2.0,
    }
}
