//! What both benchmarks need: a runtime of one worker, and every core computing at the priority of a
//! training meanwhile. Nothing is measured here.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// The number on the command line, or `default`.
pub fn argument<T: std::str::FromStr>(default: T) -> T {
    std::env::args()
        .skip(1)
        .find_map(|argument| argument.parse().ok())
        .unwrap_or(default)
}

/// One worker, so that the load and the control loop meet on few cores.
pub fn runtime() -> tokio::runtime::Runtime {
    tokio::runtime::Builder::new_multi_thread()
        .worker_threads(1)
        .enable_all()
        .build()
        .expect("a runtime")
}

/// Every core computes until this is dropped.
pub struct Load(Arc<AtomicBool>);

impl Load {
    /// Begins.
    pub fn on_every_core() -> Self {
        let busy = Arc::new(AtomicBool::new(true));
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        for _ in 0..cores {
            let busy = Arc::clone(&busy);
            std::thread::spawn(move || compute(&busy));
        }
        Self(busy)
    }
}

impl Drop for Load {
    fn drop(&mut self) {
        self.0.store(false, Ordering::Relaxed);
    }
}

/// Floating-point work at the priority of a training.
fn compute(busy: &AtomicBool) {
    // Without the right to it the load is only heavier.
    let _ = rustix::process::setpriority_process(None, 19);
    let mut x = 0.5_f64;
    while busy.load(Ordering::Relaxed) {
        for _ in 0..10_000 {
            x = std::hint::black_box(x * 1.000_1 + 0.5).sqrt();
        }
    }
}
