//! The server as a whole: what is started in which order, and what is stopped in which order.

use std::fs::{File, TryLockError};
use std::future::Future;
use std::net::{IpAddr, Ipv4Addr, SocketAddr, UdpSocket};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use futures_util::future::join_all;
use robot::{RobotError, RobotState};
use tokio::net::TcpListener;
use tokio::task::JoinHandle;
use tokio::time::timeout;
use virtual_controller::{FaultSwitches, VirtualController};

use crate::arms::{Arm, StartedRobot};
use crate::cell::{self, CellError, RobotSettings};
use crate::certificates::{self, Certificates, Machine};
use crate::clock::{Clock, SharedClock, SystemClock};
use crate::config::Config;
use crate::http::{self, AppState};
use crate::jobs::Worker;
use crate::pairing::{Gatekeeper, PairingCode};
use crate::shutdown::Shutdown;
use crate::store::{self, Store};

mod robots;
#[cfg(test)]
mod tests;

/// How often the computer's addresses and the calendar are looked at for the certificate's sake.
const LOOK_EVERY: Duration = Duration::from_secs(600);

/// Why the server did not start.
#[derive(Debug, thiserror::Error)]
pub enum StartError {
    /// The data folder can't be made or read.
    #[error("the data folder {folder} can't be used: {source}")]
    Folder {
        /// Which one.
        folder: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// Another server works with the same data.
    #[error(
        "another server is already using the data folder {folder}; stop it, or choose another folder with --data"
    )]
    FolderInUse {
        /// Which one.
        folder: PathBuf,
    },
    /// The database refused.
    #[error(transparent)]
    Store(#[from] store::Error),
    /// The address of the pages is taken or not ours.
    #[error("the address {address} can't be used: {source}; choose another with --listen")]
    Listen {
        /// Which one.
        address: SocketAddr,
        /// Why.
        source: std::io::Error,
    },
    /// There is no HTTPS.
    #[error("{0}; or leave out --https")]
    Https(#[from] certificates::Error),
    /// The configuration of the cell can't be used.
    #[error(transparent)]
    Cell(#[from] CellError),
    /// A robot's side did not start.
    #[error("robot \"{robot}\": {error}. {}", error.advice())]
    Robot {
        /// Which one.
        robot: String,
        /// Why.
        error: RobotError,
    },
    /// A virtual arm did not start.
    #[error("the virtual arm of robot \"{robot}\" did not start: {source}")]
    VirtualArm {
        /// Of which robot.
        robot: String,
        /// Why.
        source: virtual_controller::Error,
    },
    /// No threads or random numbers to be had.
    #[error("the operating system refused: {0}")]
    System(String),
}

/// The server, not yet started.
pub struct App;

/// A server that runs. Dropping it raises the shutdown; only `shutdown` waits for it.
pub struct RunningApp {
    address: SocketAddr,
    state: AppState,
    server: JoinHandle<std::io::Result<()>>,
    worker: Worker,
    robots: Vec<RobotSettings>,
    virtual_arms: Vec<VirtualController>,
    _lock: File,
}

impl App {
    /// Starts everything: store, robots, virtual arms, worker, pages. What the last run left
    /// unfinished is cleared up before the first request is answered.
    ///
    /// # Errors
    /// When a part can't start; nothing is left running then.
    pub async fn start(config: Config) -> Result<RunningApp, StartError> {
        let robots = cell::robots(&config)?;
        let lock = lock_folder(&config.data)?;
        let store = Store::open(&config.data.join("team.sqlite")).await?;
        let listen_error = |source| StartError::Listen {
            address: config.listen,
            source,
        };
        let listener = TcpListener::bind(config.listen)
            .await
            .map_err(listen_error)?;
        let address = listener.local_addr().map_err(listen_error)?;
        let certificates = certificates(&config, address.ip())?;
        let (started, virtual_arms) = robots::start(&robots).await?;
        let mut state = assemble(&config, store, started)?;
        state.certificates = certificates;
        state.found_at = Some(found_at(address)).filter(|_| state.gatekeeper.is_some());
        recover(&state).await?;
        if let Some(certificates) = state.certificates.clone() {
            let shutdown = state.shutdown.clone();
            tokio::spawn(keep_fresh(certificates, address.ip(), shutdown));
        }
        let worker = Worker::start(state.queue.clone(), state.shutdown.clone())
            .map_err(|error| StartError::System(error.to_string()))?;
        Ok(RunningApp {
            address,
            server: tokio::spawn(http::serve(listener, state.clone())),
            state,
            worker,
            robots,
            virtual_arms,
            _lock: lock,
        })
    }
}

impl RunningApp {
    /// Where the pages are, for a browser on this computer or, when bound to the network, on a
    /// phone.
    pub fn url(&self) -> String {
        let scheme = match self.state.certificates {
            Some(_) => "https",
            None => "http",
        };
        format!("{scheme}://{}/", found_at(self.address))
    }

    /// Where a phone without this cell's certificate begins; nothing when there is none.
    pub fn url_without_certificate(&self) -> Option<String> {
        self.state.certificates.as_ref()?;
        Some(format!("http://{}/", found_at(self.address)))
    }

    /// The fingerprint of the certificate that phones install.
    pub fn certificate_sha256(&self) -> Option<String> {
        Some(self.state.certificates.as_ref()?.authority_sha256())
    }

    /// The code that a phone needs; nothing when only this computer can reach the server.
    pub fn pairing_code(&self) -> Option<&str> {
        let gatekeeper = self.state.gatekeeper.as_ref()?;
        Some(gatekeeper.code().as_str())
    }

    /// Where a phone is paired by opening it.
    pub fn pairing_url(&self) -> Option<String> {
        Some(format!("{}#pair={}", self.url(), self.pairing_code()?))
    }

    /// What leads a phone to the certificate and on, by opening it.
    pub fn joining_url(&self) -> Option<String> {
        let url = self.url_without_certificate()?;
        Some(format!("{url}#/join/{}", self.pairing_code()?))
    }

    /// The robots as they are configured.
    pub fn robots(&self) -> &[RobotSettings] {
        &self.robots
    }

    /// The faults that tests can bring about in the first virtual arm.
    pub fn virtual_faults(&self) -> Option<FaultSwitches> {
        self.virtual_arms.first().map(VirtualController::faults)
    }

    /// Stops the arms, closes recordings, gives jobs back to the queue, and ends.
    pub async fn shutdown(mut self) {
        let state = self.state.clone();
        let arms = state.arms.all();
        for arm in arms {
            let moving = arm.robot.view().borrow().state;
            if matches!(moving, RobotState::Reproducing | RobotState::Stopping) {
                arm.robot.stop();
            }
        }
        state.shutdown.raise();
        let closed = async |arm: &Arm| {
            arm.recorder.close().await;
            arm.robot.stop();
        };
        within(5, "closing recordings", all(arms, closed)).await;
        arms.iter().for_each(|arm| arm.robot.stop());
        let settled = async |arm: &Arm| arm.reproducer.settled().await;
        within(10, "the end of motions", all(arms, settled)).await;
        within(5, "giving back the job", self.worker.ended()).await;
        within(5, "the last answers", async {
            if let Err(error) = (&mut self.server).await {
                tracing::error!(%error, "the web server broke off");
            }
        })
        .await;
        self.server.abort();
        let logged_out = async |arm: &Arm| arm.robot.shutdown().await;
        within(5, "logging out of controllers", all(arms, logged_out)).await;
        join_all(self.virtual_arms.drain(..).map(VirtualController::stop)).await;
        state.store.close().await;
    }
}

/// Does the same with every robot at once.
async fn all(arms: &[Arm], work: impl AsyncFn(&Arm)) {
    join_all(arms.iter().map(|arm| work(arm))).await;
}

async fn within(seconds: u64, what: &str, work: impl Future<Output = ()>) {
    if timeout(Duration::from_secs(seconds), work).await.is_err() {
        tracing::warn!("{what} took too long; the server stops all the same");
    }
}

/// Two servers on one database would record and train over each other.
fn lock_folder(folder: &Path) -> Result<File, StartError> {
    let folder_error = |source| StartError::Folder {
        folder: folder.to_owned(),
        source,
    };
    std::fs::create_dir_all(folder).map_err(folder_error)?;
    let lock = File::create(folder.join("lock")).map_err(folder_error)?;
    match lock.try_lock() {
        Ok(()) => Ok(lock),
        Err(TryLockError::WouldBlock) => Err(StartError::FolderInUse {
            folder: folder.to_owned(),
        }),
        Err(TryLockError::Error(source)) => Err(folder_error(source)),
    }
}

fn assemble(
    config: &Config,
    store: Store,
    robots: Vec<StartedRobot>,
) -> Result<AppState, StartError> {
    let clock: SharedClock = Arc::new(SystemClock);
    let gatekeeper = if config.listen.ip().is_loopback() {
        None
    } else {
        let code = PairingCode::random().map_err(|error| StartError::System(error.to_string()))?;
        Some(Arc::new(Gatekeeper::new(code)))
    };
    Ok(AppState::new(store, clock, robots, gatekeeper))
}

async fn recover(state: &AppState) -> Result<(), StartError> {
    // What was left over is in the store for all robots together, so any of them clears it up.
    let Arm {
        recorder,
        reproducer,
        ..
    } = state.arms.that_made(None);
    for demonstration in recorder.recover().await? {
        tracing::warn!(demonstration.id = %demonstration.id, "a recording had been cut off");
    }
    for (count, what) in [
        (reproducer.recover().await?, "motions had been cut off"),
        (
            state.queue.recover().await?,
            "jobs had been cut off and wait again",
        ),
    ] {
        if count > 0 {
            tracing::warn!(count, "{what}");
        }
    }
    Ok(())
}

/// The authority from the data folder, and a certificate for this computer.
fn certificates(config: &Config, ip: IpAddr) -> Result<Option<Arc<Certificates>>, StartError> {
    if !config.https {
        return Ok(None);
    }
    let (folder, machine) = (config.data.join("https"), Machine::here(reachable(ip)));
    let certificates = Certificates::open(&folder, &machine, SystemClock.now())?;
    Ok(Some(certificates))
}

/// Looks again and again whether the certificate still fits this computer and the calendar.
async fn keep_fresh(certificates: Arc<Certificates>, ip: IpAddr, shutdown: Shutdown) {
    while timeout(LOOK_EVERY, shutdown.raised()).await.is_err() {
        let machine = Machine::here(reachable(ip));
        match certificates.refresh(&machine, SystemClock.now()) {
            Ok(false) => {}
            Ok(true) => tracing::info!("the pages have a new certificate"),
            Err(error) => tracing::error!(%error, "the certificate was not renewed"),
        }
    }
}

fn found_at(address: SocketAddr) -> SocketAddr {
    SocketAddr::new(reachable(address.ip()), address.port())
}

/// An address under which a server bound to `ip` is found. A server that is bound to every
/// address is found under the one that leads to the network.
fn reachable(ip: IpAddr) -> IpAddr {
    if !ip.is_unspecified() {
        return ip;
    }
    // Connecting a UDP socket sends nothing; it only makes the system choose an address.
    let towards_the_network = || {
        let socket = UdpSocket::bind((Ipv4Addr::UNSPECIFIED, 0))?;
        socket.connect((Ipv4Addr::new(192, 0, 2, 1), 9))?;
        socket.local_addr()
    };
    towards_the_network().map_or(Ipv4Addr::LOCALHOST.into(), |address| address.ip())
}
