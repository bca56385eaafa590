//! The server inside the test's own process, where the virtual controller's faults can be reached.

use std::path::Path;

use e2e::Client;
use server::config::{Config, RobotChoice};
use server::{App, RunningApp};

/// A server with the virtual arm on free ports.
pub struct InProcess(RunningApp);

/// Starts it.
pub async fn start(data: &Path) -> InProcess {
    let config = Config {
        listen: ([127, 0, 0, 1], 0).into(),
        https: false,
        egm_port: 0,
        data: data.to_owned(),
        robot: RobotChoice::Virtual,
        config: None,
    };
    InProcess(App::start(config).await.expect("the server starts"))
}

impl InProcess {
    pub fn client(&self) -> Client {
        Client::new(&self.0.url())
    }

    /// Whether the controller keeps its packets to itself.
    pub fn controller_goes_silent(&self, silent: bool) {
        let faults = self.0.virtual_faults().expect("the arm is virtual");
        faults.set(|faults| faults.egm_lost = silent);
    }

    /// Whether signals stay as they are although the controller takes them.
    pub fn signals_get_stuck(&self, stuck: bool) {
        let faults = self.0.virtual_faults().expect("the arm is virtual");
        faults.set(|faults| faults.signals_stuck = stuck);
    }

    pub async fn shutdown(self) {
        self.0.shutdown().await;
    }
}
