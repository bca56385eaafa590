//! Which certificate is believed. OmniCore controllers make their own, which no authority has
//! signed: a person compares its fingerprint once, and from then on exactly that one is accepted.
//!
//! The proof that the peer holds the certificate's key is checked in every case.

use crate::{Fingerprint, RwsError};
use reqwest::Url;
use rustls::client::danger::{HandshakeSignatureValid, ServerCertVerified, ServerCertVerifier};
use rustls::crypto::{CryptoProvider, ring, verify_tls12_signature, verify_tls13_signature};
use rustls::pki_types::{CertificateDer, ServerName, UnixTime};
use rustls::{CertificateError, ClientConfig, DigitallySignedStruct, Error, SignatureScheme};
use rustls_platform_verifier::Verifier as SystemVerifier;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;
use tokio::net::TcpStream;
use tokio_rustls::TlsConnector;
use tokio_rustls::client::TlsStream;

/// Whose word counts.
#[derive(Debug)]
enum Trust {
    /// One certificate, whatever its name and its dates.
    Pinned(Fingerprint),
    /// The authorities that this computer trusts, with name and dates.
    System(SystemVerifier),
    /// Nobody: the certificate is only looked at.
    Nobody,
}

#[derive(Debug)]
struct Verifier {
    trust: Trust,
    provider: Arc<CryptoProvider>,
    /// The certificate refused last, for the words of the error.
    refused: Mutex<Option<Fingerprint>>,
}

impl Verifier {
    fn is_trusted(
        &self,
        certificate: &CertificateDer<'_>,
        rest: (&[CertificateDer<'_>], &ServerName<'_>, &[u8], UnixTime),
    ) -> Result<ServerCertVerified, Error> {
        match &self.trust {
            Trust::Pinned(pinned) if *pinned == Fingerprint::of(certificate) => {
                Ok(ServerCertVerified::assertion())
            }
            Trust::System(system) => {
                let (intermediates, name, ocsp, now) = rest;
                system.verify_server_cert(certificate, intermediates, name, ocsp, now)
            }
            Trust::Pinned(_) | Trust::Nobody => Err(Error::InvalidCertificate(
                CertificateError::ApplicationVerificationFailure,
            )),
        }
    }
}

impl ServerCertVerifier for Verifier {
    fn verify_server_cert(
        &self,
        end_entity: &CertificateDer<'_>,
        intermediates: &[CertificateDer<'_>],
        server_name: &ServerName<'_>,
        ocsp_response: &[u8],
        now: UnixTime,
    ) -> Result<ServerCertVerified, Error> {
        let verdict = self.is_trusted(end_entity, (intermediates, server_name, ocsp_response, now));
        *self.refused.lock().unwrap_or_else(PoisonError::into_inner) =
            verdict.is_err().then(|| Fingerprint::of(end_entity));
        verdict
    }

    fn verify_tls12_signature(
        &self,
        message: &[u8],
        cert: &CertificateDer<'_>,
        dss: &DigitallySignedStruct,
    ) -> Result<HandshakeSignatureValid, Error> {
        let algorithms = &self.provider.signature_verification_algorithms;
        verify_tls12_signature(message, cert, dss, algorithms)
    }

    fn verify_tls13_signature(
        &self,
        message: &[u8],
        cert: &CertificateDer<'_>,
        dss: &DigitallySignedStruct,
    ) -> Result<HandshakeSignatureValid, Error> {
        let algorithms = &self.provider.signature_verification_algorithms;
        verify_tls13_signature(message, cert, dss, algorithms)
    }

    fn supported_verify_schemes(&self) -> Vec<SignatureScheme> {
        self.provider
            .signature_verification_algorithms
            .supported_schemes()
    }
}

/// How connections to one controller are secured.
#[derive(Debug, Clone)]
pub(crate) struct Tls {
    verifier: Arc<Verifier>,
    pub(crate) config: Arc<ClientConfig>,
}

impl Tls {
    /// Accepts the certificate `pinned`, or without it what this computer's authorities signed.
    pub(crate) fn new(pinned: Option<Fingerprint>) -> Result<Self, Error> {
        let provider = Arc::new(ring::default_provider());
        let trust = match pinned {
            Some(fingerprint) => Trust::Pinned(fingerprint),
            // A computer that trusts no authority at all knows no certificate.
            None => SystemVerifier::new(Arc::clone(&provider)).map_or(Trust::Nobody, Trust::System),
        };
        Self::with(trust, provider)
    }

    fn with(trust: Trust, provider: Arc<CryptoProvider>) -> Result<Self, Error> {
        let verifier = Arc::new(Verifier {
            trust,
            provider: Arc::clone(&provider),
            refused: Mutex::default(),
        });
        let config = ClientConfig::builder_with_provider(provider)
            .with_safe_default_protocol_versions()?
            // A verifier of our own counts as dangerous to rustls; ours is stricter than a chain
            // of authorities when a certificate is pinned.
            .dangerous()
            .with_custom_certificate_verifier(Arc::clone(&verifier) as Arc<dyn ServerCertVerifier>)
            .with_no_client_auth();
        Ok(Self {
            verifier,
            config: Arc::new(config),
        })
    }

    /// What to say after a connection failed because of the certificate; nothing when it failed
    /// because of something else.
    pub(crate) fn refusal(&self, url: &str) -> Option<RwsError> {
        let mut refused = self
            .verifier
            .refused
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        let seen = refused.take()?;
        let url = url.to_owned();
        Some(match self.verifier.trust {
            Trust::Pinned(pinned) => RwsError::WrongCertificate { url, seen, pinned },
            Trust::System(_) | Trust::Nobody => RwsError::UnknownCertificate { url, seen },
        })
    }

    /// Secures a connection that is open already.
    pub(crate) async fn secure(
        &self,
        stream: TcpStream,
        url: &Url,
    ) -> Result<TlsStream<TcpStream>, std::io::Error> {
        let host = url.host_str().unwrap_or_default();
        // An IPv6 address stands in brackets in a URL, and without them in a certificate.
        let host = host.trim_matches(['[', ']']).to_owned();
        let name = ServerName::try_from(host).map_err(std::io::Error::other)?;
        TlsConnector::from(Arc::clone(&self.config))
            .connect(name, stream)
            .await
    }
}

/// Looks at the certificate of the controller at `base_url` without trusting it: nothing is sent
/// to the controller but the beginning of a handshake.
///
/// # Errors
/// [`RwsError::BadAddress`] when the address is not an https address,
/// [`RwsError::Unreachable`] when nobody speaks TLS there within `timeout`.
pub async fn read_fingerprint(base_url: &str, timeout: Duration) -> Result<Fingerprint, RwsError> {
    let bad = |reason: String| RwsError::BadAddress {
        url: base_url.to_owned(),
        reason,
    };
    let url = Url::parse(base_url).map_err(|error| bad(error.to_string()))?;
    if url.scheme() != "https" {
        return Err(bad("only https has certificates".to_owned()));
    }
    let provider = Arc::new(ring::default_provider());
    let tls = Tls::with(Trust::Nobody, provider).map_err(|error| bad(error.to_string()))?;
    let unreachable = |reason: String| RwsError::Unreachable {
        url: base_url.to_owned(),
        reason,
    };
    let look = async {
        let stream = connect(&url).await?;
        tls.secure(stream, &url).await.map(|_| ())
    };
    let outcome = tokio::time::timeout(timeout, look).await;
    match (tls.refusal(base_url), outcome) {
        (Some(RwsError::UnknownCertificate { seen, .. }), _) => Ok(seen),
        (_, Err(_)) => Err(unreachable("no answer in time".to_owned())),
        (_, Ok(Err(error))) => Err(unreachable(error.to_string())),
        (_, Ok(Ok(()))) => Err(unreachable("it showed no certificate".to_owned())),
    }
}

/// Opens the connection that `url` asks for, without securing it.
pub(crate) async fn connect(url: &Url) -> Result<TcpStream, std::io::Error> {
    let host = url.host_str().unwrap_or_default();
    let port = url.port_or_known_default().unwrap_or_default();
    let stream = TcpStream::connect((host.trim_matches(['[', ']']), port)).await?;
    stream.set_nodelay(true)?;
    Ok(stream)
}
