//! A fixed place in memory through which the numbers of one call go in and come out.

use kugelpendel::Invalid;
use std::cell::UnsafeCell;

/// Numbers that it holds.
pub(crate) const SLOTS: usize = 96;

struct Exchange(UnsafeCell<[f64; SLOTS]>);

// SAFETY: the module has one thread, and no reference to the numbers outlives a call of the functions below.
unsafe impl Sync for Exchange {}

static EXCHANGE: Exchange = Exchange(UnsafeCell::new([0.0; SLOTS]));

/// Where it lies; it does not move.
#[unsafe(no_mangle)]
pub extern "C" fn exchange() -> *mut f64 {
    EXCHANGE.0.get().cast()
}

/// What has been put in.
pub(crate) fn received() -> [f64; SLOTS] {
    // SAFETY: no reference to it is alive, and all its numbers are initialised.
    unsafe { *EXCHANGE.0.get() }
}

/// Puts numbers out, from the first slot on.
pub(crate) fn tell(numbers: &[f64]) {
    // SAFETY: as above.
    let slots = unsafe { &mut *EXCHANGE.0.get() };
    slots[..numbers.len()].copy_from_slice(numbers);
}

/// Tells what was refused: word, count, then name, value and unit of each value seen. A text is its place and its length
/// in bytes.
pub(crate) fn refuse(invalid: &Invalid) {
    let text = |text: &'static str| [text.as_ptr() as usize as f64, text.len() as f64];
    let seen = invalid.seen();
    let mut told = Vec::from(text(invalid.word()));
    told.push(seen.len() as f64);
    for seen in seen {
        told.extend(text(seen.name));
        told.push(seen.value);
        told.extend(text(seen.unit));
    }
    tell(&told);
}

/// 1 where there is something, with it told; 0 where it was refused, with that told.
pub(crate) fn answer<const N: usize>(found: Result<[f64; N], Invalid>) -> u32 {
    match found {
        Ok(numbers) => tell(&numbers),
        Err(invalid) => {
            refuse(&invalid);
            return 0;
        }
    }
    1
}

/// Tells the word of a kind of refusal by its place in the list of them, as its place and its length in bytes; 0 beyond
/// the end of the list.
#[unsafe(no_mangle)]
pub extern "C" fn refusal_kind(index: usize) -> u32 {
    let Some((_, word)) = Invalid::KINDS.get(index) else { return 0 };
    tell(&[word.as_ptr() as usize as f64, word.len() as f64]);
    1
}
