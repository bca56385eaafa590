//! HTTPS with a certificate that the controller makes itself at its start, as OmniCore does: no
//! authority has signed it, so clients have to know its fingerprint.

use std::io;
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use axum::serve::Listener;
use rcgen::{CertifiedKey, generate_simple_self_signed};
use rustls::ServerConfig;
use rustls::crypto::ring;
use rustls::pki_types::{PrivateKeyDer, PrivatePkcs8KeyDer};
use sha2::{Digest, Sha256};
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::mpsc;
use tokio::task::JoinHandle;
use tokio_rustls::TlsAcceptor;
use tokio_rustls::server::TlsStream;

use crate::error::Error;

/// A client that begins a handshake has to end it within this time.
const HANDSHAKE: Duration = Duration::from_secs(5);
/// So many secured connections may wait to be served.
const WAITING: usize = 16;

/// A certificate and its key.
pub struct Identity {
    sha256: String,
    config: Arc<ServerConfig>,
}

impl Identity {
    /// Makes a new one.
    pub fn new() -> Result<Self, Error> {
        let names = ["localhost".to_owned(), "127.0.0.1".to_owned()];
        let CertifiedKey { cert, signing_key } = generate_simple_self_signed(names)
            .map_err(|error| Error::Certificate(error.to_string()))?;
        let pairs: Vec<String> = Sha256::digest(cert.der())
            .iter()
            .map(|byte| format!("{byte:02X}"))
            .collect();
        let key = PrivateKeyDer::from(PrivatePkcs8KeyDer::from(signing_key.serialize_der()));
        let config = ServerConfig::builder_with_provider(Arc::new(ring::default_provider()))
            .with_safe_default_protocol_versions()
            .and_then(|builder| {
                builder
                    .with_no_client_auth()
                    .with_single_cert(vec![cert.der().clone()], key)
            })
            .map_err(|error| Error::Certificate(error.to_string()))?;
        Ok(Self {
            sha256: pairs.join(":"),
            config: Arc::new(config),
        })
    }

    /// Fingerprint of the certificate.
    pub fn sha256(&self) -> String {
        self.sha256.clone()
    }
}

/// Hands out connections whose handshake is done, so that a client that is slow at it keeps
/// nobody waiting.
pub struct TlsListener {
    secured: mpsc::Receiver<(TlsStream<TcpStream>, SocketAddr)>,
    address: io::Result<SocketAddr>,
    accepting: JoinHandle<()>,
}

impl TlsListener {
    /// Begins to accept.
    pub fn new(listener: TcpListener, identity: &Identity) -> Self {
        let (sender, secured) = mpsc::channel(WAITING);
        let address = listener.local_addr();
        let acceptor = TlsAcceptor::from(Arc::clone(&identity.config));
        let accepting = tokio::spawn(accept(listener, acceptor, sender));
        Self {
            secured,
            address,
            accepting,
        }
    }
}

async fn accept(
    mut listener: TcpListener,
    acceptor: TlsAcceptor,
    secured: mpsc::Sender<(TlsStream<TcpStream>, SocketAddr)>,
) {
    loop {
        let (stream, peer) = Listener::accept(&mut listener).await;
        let (acceptor, secured) = (acceptor.clone(), secured.clone());
        tokio::spawn(async move {
            match tokio::time::timeout(HANDSHAKE, acceptor.accept(stream)).await {
                // An error means that nobody serves any more.
                Ok(Ok(stream)) => secured.send((stream, peer)).await.unwrap_or_default(),
                Ok(Err(error)) => tracing::debug!(%peer, %error, "a TLS handshake failed"),
                Err(_) => tracing::debug!(%peer, "a TLS handshake took too long"),
            }
        });
    }
}

impl Listener for TlsListener {
    type Io = TlsStream<TcpStream>;
    type Addr = SocketAddr;

    async fn accept(&mut self) -> (Self::Io, Self::Addr) {
        match self.secured.recv().await {
            Some(connection) => connection,
            // The accepting task ends only with this listener.
            None => std::future::pending().await,
        }
    }

    fn local_addr(&self) -> io::Result<SocketAddr> {
        match &self.address {
            Ok(address) => Ok(*address),
            Err(error) => Err(error.kind().into()),
        }
    }
}

impl Drop for TlsListener {
    fn drop(&mut self) {
        self.accepting.abort();
    }
}
