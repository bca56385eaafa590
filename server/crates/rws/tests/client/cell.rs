//! The virtual controller on its sockets.

use rws::{Client, Config};
use std::net::{SocketAddr, UdpSocket};
use std::time::Duration;
use virtual_controller::VirtualController;

/// Longer than anything in these tests takes.
pub const PATIENCE: Duration = Duration::from_secs(20);

pub struct Cell {
    pub controller: VirtualController,
    /// Where the controller sends EGM; nobody answers.
    _egm: UdpSocket,
}

impl Cell {
    /// A client that accepts this controller and no other.
    pub fn client(&self) -> Client {
        let pin = self.controller.certificate_sha256();
        Client::new(config(self.controller.rws_url(), pin)).unwrap()
    }
}

pub async fn cell(https: bool) -> Cell {
    cell_at(SocketAddr::from(([127, 0, 0, 1], 0)), https).await
}

/// A controller whose web services are at `address`.
pub async fn cell_at(address: SocketAddr, https: bool) -> Cell {
    let egm = UdpSocket::bind("127.0.0.1:0").unwrap();
    let mut config = virtual_controller::Config::new(egm.local_addr().unwrap());
    config.rws_listen = address;
    config.rws_https = https;
    Cell {
        controller: VirtualController::start(config).await.unwrap(),
        _egm: egm,
    }
}

pub fn config(url: impl Into<String>, pin: Option<&str>) -> Config {
    Config {
        certificate_sha256: pin.map(str::to_owned),
        timeout: PATIENCE,
        ..Config::new(url)
    }
}
