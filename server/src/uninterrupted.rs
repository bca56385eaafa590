//! Work that must come to its end although the client that asked for it may go away.

use std::panic::resume_unwind;

/// Runs `work` to its end. A request whose client hangs up is dropped wherever it waits; what
/// makes the arm soft or sets it in motion must not be cut off half-way by that.
pub async fn uninterrupted<T: Send + 'static>(work: impl Future<Output = T> + Send + 'static) -> T {
    match tokio::spawn(work).await {
        Ok(result) => result,
        Err(error) => match error.try_into_panic() {
            Ok(panic) => resume_unwind(panic),
            // The runtime is being torn down, and this task with it.
            Err(_) => std::future::pending().await,
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use futures_util::FutureExt;
    use std::time::Duration;
    use tokio::sync::oneshot;
    use tokio::time::timeout;

    #[tokio::test]
    async fn work_goes_on_when_the_one_who_asked_goes_away() {
        let (go, wait) = oneshot::channel::<()>();
        let (done, seen) = oneshot::channel();
        let asked = uninterrupted(async move {
            wait.await.unwrap();
            done.send(7).unwrap();
        });
        assert_eq!(asked.now_or_never(), None);
        go.send(()).unwrap();
        let seen = timeout(Duration::from_secs(10), seen).await.unwrap();
        assert_eq!(seen, Ok(7));
    }
}
