//! The server as a process of its own, which a test can kill.

use std::path::Path;
use std::process::{Output, Stdio};
use std::sync::{Arc, Mutex, PoisonError};

use tokio::io::{AsyncBufReadExt, AsyncRead, BufReader};
use tokio::process::{Child, Command};
use tokio::sync::watch;
use tokio::time::timeout;

use super::{Client, SHORT};

const READY: &str = "TEAM is ready: ";

/// A running server. Dropping it kills it.
pub struct Process {
    child: Child,
    client: Client,
    output: Arc<Mutex<String>>,
}

impl Process {
    /// Starts `program serve` on free ports with its data in `data`, and waits until it is ready.
    ///
    /// # Panics
    /// When it does not become ready.
    pub async fn start(program: &str, data: &Path, more: &[&str]) -> Self {
        Self::start_on(program, "127.0.0.1:0", data, more).await
    }

    /// The same with an address of the caller's choice. The client speaks to the port on this
    /// machine, wherever else the server listens.
    ///
    /// # Panics
    /// When it does not become ready.
    pub async fn start_on(program: &str, listen: &str, data: &Path, more: &[&str]) -> Self {
        let mut command = Command::new(program);
        command
            .args(["serve", "--listen", listen, "--data"])
            .arg(data);
        // A configuration file says itself where each robot is awaited.
        if !more.contains(&"--config") {
            command.args(["--egm-port", "0"]);
        }
        command
            .args(more)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        // A process that a failing test leaves behind would hold the data folder.
        command.kill_on_drop(true);
        let mut child = command.spawn().expect("the server starts");
        let output = Arc::new(Mutex::new(String::new()));
        let (ready, mut address) = watch::channel(None);
        collect(child.stdout.take(), output.clone(), Some(ready));
        collect(child.stderr.take(), output.clone(), None);
        let ready = timeout(SHORT, address.wait_for(Option::is_some)).await;
        // The sender goes when the process closes its output, that is, when it has ended.
        let address = match ready {
            Ok(Ok(address)) => address.clone().unwrap_or_default(),
            _ => panic!("the server does not become ready:\n{}", text(&output)),
        };
        let port = address
            .trim_end_matches('/')
            .rsplit(':')
            .next()
            .unwrap_or_default();
        let client = Client::new(&format!("http://127.0.0.1:{port}"));
        Self {
            child,
            client,
            output,
        }
    }

    /// A client for this server.
    #[must_use]
    pub fn client(&self) -> Client {
        self.client.clone()
    }

    /// Its number in the system.
    ///
    /// # Panics
    /// When it has ended.
    #[must_use]
    pub fn id(&self) -> u32 {
        self.child.id().expect("the server still runs")
    }

    /// What it has printed up to now, on both streams.
    #[must_use]
    pub fn output(&self) -> String {
        text(&self.output)
    }

    /// Ends it the way a power failure would, without a chance to tidy up.
    ///
    /// # Panics
    /// When the system refuses.
    pub async fn kill(mut self) {
        self.child.kill().await.expect("the process can be killed");
    }

    /// Asks it to end, as a service manager does, and waits until it has.
    ///
    /// # Panics
    /// When it does not end, or not with success.
    pub async fn terminate(mut self) {
        let id = self.id().to_string();
        let asked = Command::new("kill").args(["-TERM", &id]).status().await;
        assert!(asked.expect("kill can be run").success(), "kill -TERM {id}");
        let ended = timeout(SHORT, self.child.wait()).await;
        let status = ended
            .expect("the server ends when asked")
            .expect("its status is known");
        assert!(
            status.success(),
            "the server ended with {status}:\n{}",
            text(&self.output)
        );
    }
}

fn text(output: &Mutex<String>) -> String {
    output
        .lock()
        .unwrap_or_else(PoisonError::into_inner)
        .clone()
}

/// Reads a stream to its end so that the server never blocks on it.
fn collect(
    stream: Option<impl AsyncRead + Unpin + Send + 'static>,
    output: Arc<Mutex<String>>,
    ready: Option<watch::Sender<Option<String>>>,
) {
    let Some(stream) = stream else { return };
    tokio::spawn(async move {
        let mut lines = BufReader::new(stream).lines();
        while let Ok(Some(line)) = lines.next_line().await {
            if let (Some(ready), Some(address)) = (&ready, line.trim().strip_prefix(READY)) {
                ready.send_replace(Some(address.trim().to_owned()));
            }
            let mut output = output.lock().unwrap_or_else(PoisonError::into_inner);
            output.push_str(&line);
            output.push('\n');
        }
    });
}

/// Runs a command of the program to its end.
///
/// # Panics
/// When it cannot be started.
pub async fn run_to_end(program: &str, arguments: &[&str]) -> Output {
    let mut command = Command::new(program);
    command
        .args(arguments)
        .stdin(Stdio::null())
        .kill_on_drop(true);
    let ended = timeout(super::LONG, command.output()).await;
    ended
        .expect("the command ends")
        .expect("the command starts")
}
