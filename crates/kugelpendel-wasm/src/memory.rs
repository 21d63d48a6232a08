//! Memory that the page fills with times and reads numbers from.

/// Room for so many numbers, all 0; [`release`] it.
#[unsafe(no_mangle)]
pub extern "C" fn allocate(count: usize) -> *mut f64 {
    Box::into_raw(vec![0.0; count].into_boxed_slice()).cast()
}

/// Gives back what [`allocate`] gave.
///
/// # Safety
/// Place and count are those of one call of [`allocate`] that has not been released.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn release(place: *mut f64, count: usize) {
    // SAFETY: the caller's promise.
    drop(unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(place, count)) });
}

/// Numbers at a place.
///
/// # Safety
/// So many lie there, and nothing writes to them while the slice is alive.
pub(crate) unsafe fn numbers<'a>(place: *const f64, count: usize) -> &'a [f64] {
    // SAFETY: the caller's promise.
    unsafe { std::slice::from_raw_parts(place, count) }
}

/// Room at a place.
///
/// # Safety
/// So many numbers have room there, and nothing else reads or writes them while the slice is alive.
pub(crate) unsafe fn room<'a>(place: *mut f64, count: usize) -> &'a mut [f64] {
    // SAFETY: the caller's promise.
    unsafe { std::slice::from_raw_parts_mut(place, count) }
}
