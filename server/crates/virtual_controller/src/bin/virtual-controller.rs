//! Runs one virtual controller by itself, for a look at it with other clients.
//!
//! `virtual-controller [EGM-SERVER [RWS-LISTEN]] [--https]`, for example
//! `virtual-controller 127.0.0.1:6510 127.0.0.1:8081`. With `--https` it makes a certificate and
//! prints its fingerprint.

use std::error::Error;
use std::net::{Ipv4Addr, SocketAddr};

use virtual_controller::{Config, VirtualController};

const EGM_PORT: u16 = 6510;

#[tokio::main(flavor = "current_thread")]
async fn main() -> Result<(), Box<dyn Error>> {
    let (flags, addresses): (Vec<_>, Vec<_>) = std::env::args()
        .skip(1)
        .partition(|argument| argument == "--https");
    let mut arguments = addresses.into_iter();
    let egm_remote = match arguments.next() {
        Some(address) => address.parse()?,
        None => SocketAddr::from((Ipv4Addr::LOCALHOST, EGM_PORT)),
    };
    let mut config = Config::new(egm_remote);
    config.rws_https = !flags.is_empty();
    if let Some(address) = arguments.next() {
        config.rws_listen = address.parse()?;
    }
    let controller = VirtualController::start(config).await?;
    println!(
        "The virtual GoFa sends EGM to {egm_remote} and serves Robot Web Services at {}/",
        controller.rws_url()
    );
    if let Some(sha256) = controller.certificate_sha256() {
        println!("The SHA-256 fingerprint of its certificate is {sha256}");
    }
    tokio::signal::ctrl_c().await?;
    controller.stop().await;
    Ok(())
}
