//! The threads that share long work, also in a process that was forked.

use rayon::{ThreadPool, ThreadPoolBuilder};
use std::process;
use std::sync::OnceLock;

/// The threads of one process, and those of its forked child. The threads themselves do not come along with a fork, so a
/// child that waited for its parent's, as with rayon's own pool, would wait for ever.
struct Threads {
    process: u32,
    pool: ThreadPool,
    of_child: OnceLock<Box<Self>>,
}

static THREADS: OnceLock<Box<Threads>> = OnceLock::new();

/// Does the work where rayon's parallel iterators find the threads of this process: as many as there are processors, or as
/// `RAYON_NUM_THREADS` says. Within a pool of somebody else's it stays there.
///
/// # Panics
/// If the system gives no threads.
pub fn in_parallel<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    if rayon::current_thread_index().is_some() {
        return work();
    }
    let process = process::id();
    let mut slot = &THREADS;
    loop {
        match slot.get() {
            Some(threads) if threads.process == process => return threads.pool.install(work),
            Some(threads) => slot = &threads.of_child,
            None => {
                let pool = ThreadPoolBuilder::new().build().expect("the system gives threads");
                // Whoever was faster has set the same; then this pool goes again.
                let _ = slot.set(Box::new(Threads { process, pool, of_child: OnceLock::new() }));
            }
        }
    }
}
