//! Runs one virtual controller by itself, for a look at it with other clients.
//!
//! `virtual-controller [EGM-SERVER [RWS-LISTEN]]`, for example
//! `virtual-controller 127.0.0.1:6510 127.0.0.1:8081`.

use std::error::Error;
use std::net::{Ipv4Addr, SocketAddr};

use virtual_controller::{Config, VirtualController};

const EGM_PORT: u16 = 6510;

#[tokio::main(flavor = "current_thread")]
async fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let egm_remote = match arguments.next() {
        Some(address) => address.parse()?,
        None => SocketAddr::from((Ipv4Addr::LOCALHOST, EGM_PORT)),
    };
    let mut config = Config::new(egm_remote);
    if let Some(address) = arguments.next() {
        config.rws_listen = address.parse()?;
    }
    let controller = VirtualController::start(config).await?;
    println!(
        "The virtual GoFa sends EGM to {egm_remote} and serves Robot Web Services at http://{}/",
        controller.rws_addr()
    );
    tokio::signal::ctrl_c().await?;
    controller.stop().await;
    Ok(())
}
