//! Work that a signal, such as Ctrl-C, ends at once.

use crate::columns::{Numbers, new_array};
use pyo3::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Between two looks at whether a signal has come; a person notices 0.2 s.
const PATIENCE: Duration = Duration::from_millis(50);

/// A signal that Python wants to raise, and until when the work may last.
pub(crate) struct Signal {
    looked: Mutex<Instant>,
    arrived: AtomicBool,
    raised: Mutex<Option<PyErr>>,
    deadline: Option<Instant>,
}

impl Default for Signal {
    fn default() -> Self {
        Self::within(None)
    }
}

impl Signal {
    /// Work that is also over after so many seconds, if any are given.
    pub(crate) fn within(seconds: Option<f64>) -> Self {
        let now = Instant::now();
        let deadline = seconds.and_then(|s| Duration::try_from_secs_f64(s).ok()).and_then(|d| now.checked_add(d));
        Self { looked: Mutex::new(now), arrived: AtomicBool::new(false), raised: Mutex::default(), deadline }
    }

    /// Whether the work is to end: asked by the thread that Python has called.
    pub(crate) fn ends_work(&self) -> bool {
        if self.has_arrived() {
            return true;
        }
        let now = Instant::now();
        let mut looked = lock(&self.looked);
        if now.duration_since(*looked) >= PATIENCE {
            *looked = now;
            self.look();
        }
        self.has_arrived() || self.deadline.is_some_and(|deadline| now >= deadline)
    }

    /// Whether the work is to end: asked by the threads that share it.
    pub(crate) fn has_arrived(&self) -> bool {
        self.arrived.load(Ordering::Relaxed)
    }

    /// Only Python's main thread ever sees a signal.
    fn look(&self) {
        if let Err(error) = Python::attach(|py| py.check_signals()) {
            *lock(&self.raised) = Some(error);
            self.arrived.store(true, Ordering::Relaxed);
        }
    }

    /// # Errors
    /// What the signal's handler has raised.
    pub(crate) fn raised(self) -> PyResult<()> {
        lock(&self.raised).take().map_or(Ok(()), Err)
    }

    /// Does work that other threads share, while the one that Python has called looks for signals. The work has to ask
    /// [`Signal::has_arrived`] now and then.
    pub(crate) fn watch<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        let (sender, receiver) = channel();
        std::thread::scope(|scope| {
            let worker = scope.spawn(move || {
                // The receiver lives until the worker is joined.
                let _ = sender.send(work());
            });
            loop {
                match receiver.recv_timeout(PATIENCE) {
                    Ok(result) => return result,
                    Err(RecvTimeoutError::Timeout) => self.look(),
                    Err(RecvTimeoutError::Disconnected) => match worker.join() {
                        Err(panic) => std::panic::resume_unwind(panic),
                        Ok(()) => unreachable!("the work is done and has left no result"),
                    },
                }
            }
        })
    }
}

/// Times of one motion that are worked out between two looks: some milliseconds. 1024 of the core's blocks, so that a
/// grid is cut where the core cuts it, and has the same bits.
const TIMES_TOGETHER: usize = 1024 * 384;

/// Numbers that are worked out between two looks where each is a matter of a microsecond or less.
const ROWS_TOGETHER: usize = 1 << 12;

/// A new array of `width` numbers for each of so many times of each motion, filled in pieces: `fill` is told which
/// motions, and which of the times if it is one motion only.
///
/// # Errors
/// What a signal's handler has raised.
pub(crate) fn filled<'py>(
    py: Python<'py>,
    [motions, times, width]: [usize; 3],
    fill: impl Fn(Range<usize>, Range<usize>, &mut [f64]) + Send,
) -> PyResult<Numbers<'py>> {
    let signal = Signal::default();
    let array = new_array(py, motions * times * width, |out| fill_in_pieces(&signal, [times, width], out, fill));
    signal.raised()?;
    Ok(array)
}

/// The same into an array that is there already.
pub(crate) fn fill_in_pieces(
    signal: &Signal,
    [times, width]: [usize; 2],
    out: &mut [f64],
    fill: impl Fn(Range<usize>, Range<usize>, &mut [f64]),
) {
    if out.is_empty() {
        return;
    }
    let together = (TIMES_TOGETHER / times).max(1);
    for (group, rows) in out.chunks_mut(together * times * width).enumerate() {
        let first = group * together;
        let motions = first..first + rows.len() / (times * width);
        let most = if motions.len() > 1 { times } else { TIMES_TOGETHER };
        for (piece, out) in rows.chunks_mut(motions.len() * most * width).enumerate() {
            let start = piece * most;
            fill(motions.clone(), start..start + out.len() / (motions.len() * width), out);
            if signal.ends_work() {
                return;
            }
        }
    }
}

/// N numbers for each of so many cases, one after the other.
///
/// # Errors
/// What a signal's handler has raised.
pub(crate) fn collected<const N: usize>(
    py: Python<'_>,
    count: usize,
    row: impl Fn(usize) -> [f64; N] + Send,
) -> PyResult<Vec<f64>> {
    let signal = Signal::default();
    let rows = py.detach(|| {
        let goes_on = |index: &usize| !index.is_multiple_of(ROWS_TOGETHER) || !signal.ends_work();
        let mut rows = Vec::with_capacity(N * count);
        rows.extend((0..count).take_while(goes_on).flat_map(row));
        rows
    });
    signal.raised()?;
    Ok(rows)
}

pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
