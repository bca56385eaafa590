//! One signal that tells every part of the server to finish, and what raises it.
//!
//! The order of stopping is in `RunningApp::shutdown`.

use tokio::sync::watch;

/// Raised once; everybody who holds a clone sees it.
#[derive(Clone)]
pub struct Shutdown(watch::Sender<bool>);

impl Default for Shutdown {
    fn default() -> Self {
        Self(watch::channel(false).0)
    }
}

impl Shutdown {
    /// Asks every part to finish. Raising it again changes nothing.
    pub fn raise(&self) {
        self.0.send_replace(true);
    }

    /// Whether it was raised.
    pub fn is_raised(&self) -> bool {
        *self.0.borrow()
    }

    /// Waits until it is raised.
    pub async fn raised(&self) {
        let mut receiver = self.0.subscribe();
        // The sender lives in `self`, so the wait can't end early.
        let _ = receiver.wait_for(|raised| *raised).await;
    }
}

/// Waits for Ctrl-C or a polite kill.
///
/// # Errors
/// When the operating system refuses to hand over the signals.
pub async fn asked_by_the_system() -> std::io::Result<()> {
    use tokio::signal::unix::{SignalKind, signal};
    let mut interrupt = signal(SignalKind::interrupt())?;
    let mut terminate = signal(SignalKind::terminate())?;
    tokio::select! {
        _ = interrupt.recv() => {}
        _ = terminate.recv() => {}
    }
    Ok(())
}
