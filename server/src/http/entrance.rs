//! HTTPS and plain HTTP on one port. The first byte of a connection says which it is, so there is
//! one address to remember and one port to open, and a phone without the certificate still works.

use std::io;
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use axum::extract::connect_info::Connected;
use axum::extract::{ConnectInfo, Request};
use axum::serve::{IncomingStream, Listener};
use rustls::ServerConfig;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::mpsc;
use tokio::time::timeout;
use tokio_rustls::TlsAcceptor;
use tokio_rustls::server::TlsStream;

use crate::shutdown::Shutdown;

/// A connection has to say what it wants within this time, and to end its handshake.
const PATIENCE: Duration = Duration::from_secs(10);
/// So many connections may wait to be served.
const WAITING: usize = 64;
/// With this byte a TLS handshake begins; no HTTP request does.
const HANDSHAKE: u8 = 0x16;

/// How a request came in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scheme {
    /// Readable for everybody on the network.
    #[default]
    Http,
    /// Over TLS.
    Https,
}

/// Connections of one kind, ready to be served.
pub struct Ready<Io> {
    connections: mpsc::Receiver<(Io, SocketAddr)>,
    address: SocketAddr,
}

/// Sorts the connections that come in until the server stops. Handshakes run beside each other, so
/// a client that is slow at it keeps nobody waiting.
pub fn open(
    listener: TcpListener,
    config: Arc<ServerConfig>,
    shutdown: Shutdown,
) -> io::Result<(Ready<TcpStream>, Ready<TlsStream<TcpStream>>)> {
    let address = listener.local_addr()?;
    let (plain, plain_ready) = mpsc::channel(WAITING);
    let (secured, secured_ready) = mpsc::channel(WAITING);
    let door = Door {
        plain,
        secured,
        acceptor: TlsAcceptor::from(config),
    };
    tokio::spawn(accept(listener, door, shutdown));
    let ready = (
        Ready {
            connections: plain_ready,
            address,
        },
        Ready {
            connections: secured_ready,
            address,
        },
    );
    Ok(ready)
}

#[derive(Clone)]
struct Door {
    plain: mpsc::Sender<(TcpStream, SocketAddr)>,
    secured: mpsc::Sender<(TlsStream<TcpStream>, SocketAddr)>,
    acceptor: TlsAcceptor,
}

async fn accept(mut listener: TcpListener, door: Door, shutdown: Shutdown) {
    loop {
        let (stream, peer) = tokio::select! {
            connection = Listener::accept(&mut listener) => connection,
            () = shutdown.raised() => return,
        };
        let door = door.clone();
        tokio::spawn(async move {
            match timeout(PATIENCE, door.enter(stream, peer)).await {
                Ok(Ok(())) => {}
                Ok(Err(error)) => tracing::debug!(%peer, %error, "a connection was not opened"),
                Err(_) => tracing::debug!(%peer, "a connection said nothing for too long"),
            }
        });
    }
}

impl Door {
    async fn enter(&self, stream: TcpStream, peer: SocketAddr) -> io::Result<()> {
        // Live messages are small and must not wait for each other.
        stream.set_nodelay(true)?;
        let mut first = [0];
        if stream.peek(&mut first).await? == 0 {
            return Ok(());
        }
        // A send fails when nobody serves any more; the connection closes then.
        if first[0] == HANDSHAKE {
            let stream = self.acceptor.accept(stream).await?;
            self.secured.send((stream, peer)).await.unwrap_or_default();
        } else {
            self.plain.send((stream, peer)).await.unwrap_or_default();
        }
        Ok(())
    }
}

impl<Io: tokio::io::AsyncRead + tokio::io::AsyncWrite + Unpin + Send + 'static> Listener
    for Ready<Io>
{
    type Io = Io;
    type Addr = SocketAddr;

    async fn accept(&mut self) -> (Io, SocketAddr) {
        match self.connections.recv().await {
            Some(connection) => connection,
            // The server stops, and no more connections come.
            None => std::future::pending().await,
        }
    }

    fn local_addr(&self) -> io::Result<SocketAddr> {
        Ok(self.address)
    }
}

/// The other end of a connection from the entrance.
#[derive(Clone, Copy)]
pub struct Peer(SocketAddr);

impl<Io> Connected<IncomingStream<'_, Ready<Io>>> for Peer
where
    Ready<Io>: Listener<Addr = SocketAddr>,
{
    fn connect_info(stream: IncomingStream<'_, Ready<Io>>) -> Self {
        Self(*stream.remote_addr())
    }
}

/// Tells the handlers what they would know from a listener of the system: who calls, and how.
pub async fn introduce(
    axum::extract::State(scheme): axum::extract::State<Scheme>,
    ConnectInfo(Peer(address)): ConnectInfo<Peer>,
    mut request: Request,
) -> Request {
    request.extensions_mut().insert(ConnectInfo(address));
    request.extensions_mut().insert(scheme);
    request
}
