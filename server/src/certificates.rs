//! HTTPS without anybody's help: this cell's own certificate authority in the data folder, and the
//! certificate of the pages that it signs.
//!
//! The authority lives for years, because its certificate is what people install on phones. The
//! pages' certificate lives in memory: it is made at every start, and again while the server runs
//! when it nears its end or this computer's addresses change. Not here: sockets (`http`).

mod authority;
mod file;
mod machine;
mod names;
#[cfg(test)]
mod tests;

use std::fmt::{self, Display};
use std::path::{Path, PathBuf};
use std::sync::{Arc, PoisonError, RwLock};

use jiff::civil::Date;
use jiff::{Timestamp, ToSpan, tz::TimeZone};
use rustls::ServerConfig;
use rustls::crypto::ring;
use rustls::server::{ClientHello, ResolvesServerCert};
use rustls::sign::CertifiedKey;
use sha2::{Digest, Sha256};

pub use machine::Machine;

use crate::clock::WallTime;
use authority::{Authority, Leaf};

/// A certificate with less than this left is made again.
const RENEW_DAYS: i32 = 100;
/// From then on every start warns of the authority's end.
const WARN_DAYS: i32 = 365;

/// Why there is no HTTPS.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The authority's file can't be read or written.
    #[error("the certificate authority {path} can't be used: {source}")]
    File {
        /// Which file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// The secret key is open to others.
    #[error(
        "the certificate authority {path} can be read by other users of this computer (mode {mode:o}); if nobody did, close it with \"chmod 600 {path}\", otherwise delete it and install the new certificate on the phones"
    )]
    Exposed {
        /// Which file.
        path: PathBuf,
        /// Its permissions.
        mode: u32,
    },
    /// The file is not what was written.
    #[error(
        "the certificate authority {path} is damaged ({what}); bring the file back from a copy, or delete it and install the new certificate on the phones"
    )]
    Damaged {
        /// Which file.
        path: PathBuf,
        /// What is wrong with it.
        what: String,
    },
    /// The authority and the clock do not agree.
    #[error(
        "the certificate authority {path} is valid from {made_on} to {valid_until}, but this computer's clock says {today}; set the clock, or when that date is right delete the file and install the new certificate on the phones"
    )]
    OutOfTime {
        /// Which file.
        path: PathBuf,
        /// Its first day.
        made_on: Date,
        /// Its last day.
        valid_until: Date,
        /// Today.
        today: Date,
    },
    /// No certificate could be made.
    #[error("no certificate could be made: {0}")]
    Refused(String),
}

impl Error {
    fn file(path: &Path, source: std::io::Error) -> Self {
        Self::File {
            path: path.to_owned(),
            source,
        }
    }
}

fn refused(error: impl Display) -> Error {
    Error::Refused(error.to_string())
}

/// The authority, and the certificate in use.
pub struct Certificates {
    authority: Authority,
    leaf: RwLock<Leaf>,
}

impl Certificates {
    /// Takes the authority from the folder, or makes one there, and makes a certificate for this
    /// machine.
    ///
    /// # Errors
    /// When the authority's file is damaged, open to others or out of its time; it stays as it is.
    pub fn open(folder: &Path, machine: &Machine, now: WallTime) -> Result<Arc<Self>, Error> {
        let path = folder.join("authority.json");
        let today = day(now)?;
        let authority = match file::load(&path)? {
            Some(authority) => authority,
            None => {
                let authority = Authority::new(machine, today)?;
                file::save(&path, &authority)?;
                authority
            }
        };
        let (made_on, valid_until) = (authority.made_on, authority.valid_until);
        // A day of grace, as the certificate has it: time zones, and clocks a little apart.
        if today.tomorrow().map_err(refused)? < made_on || today >= valid_until {
            return Err(Error::OutOfTime {
                path,
                made_on,
                valid_until,
                today,
            });
        }
        if ends_within(valid_until, today, WARN_DAYS) {
            tracing::warn!(
                "the certificate authority {} ends on {valid_until}; delete it before, and install the new certificate on the phones",
                path.display()
            );
        }
        let leaf = authority.issue(machine, today)?;
        for ip in machine.addresses.difference(&leaf.covers.addresses) {
            tracing::warn!(%ip, "this address is not one that the certificate authority may sign for");
        }
        let leaf = RwLock::new(leaf);
        Ok(Arc::new(Self { authority, leaf }))
    }

    /// Makes the certificate anew if it nears its end or the machine has changed; says whether it
    /// did. Open connections stay.
    ///
    /// # Errors
    /// When none can be made; the present one stays in use.
    pub fn refresh(&self, machine: &Machine, now: WallTime) -> Result<bool, Error> {
        let today = day(now)?;
        let covers = self.authority.permitted.of(machine);
        {
            let leaf = self.leaf.read().unwrap_or_else(PoisonError::into_inner);
            // One that lasts as long as the authority can't be made to last longer.
            let old = ends_within(leaf.valid_until, today, RENEW_DAYS)
                && leaf.valid_until < self.authority.valid_until;
            if !old && leaf.covers == covers {
                return Ok(false);
            }
        }
        let leaf = self.authority.issue(machine, today)?;
        *self.leaf.write().unwrap_or_else(PoisonError::into_inner) = leaf;
        Ok(true)
    }

    /// How connections are secured: TLS 1.2 or 1.3, with the certificate of the moment.
    ///
    /// # Errors
    /// When the cryptography refuses.
    pub fn tls(self: &Arc<Self>) -> Result<Arc<ServerConfig>, Error> {
        let builder = ServerConfig::builder_with_provider(Arc::new(ring::default_provider()))
            .with_safe_default_protocol_versions()
            .map_err(refused)?;
        let resolver = Arc::clone(self);
        let mut config = builder.with_no_client_auth().with_cert_resolver(resolver);
        config.alpn_protocols = vec![b"http/1.1".to_vec()];
        Ok(Arc::new(config))
    }

    /// The authority's certificate (DER), for phones.
    pub fn authority(&self) -> &[u8] {
        &self.authority.certificate
    }

    /// Its fingerprint, for people to compare.
    pub fn authority_sha256(&self) -> String {
        let pairs: Vec<String> = Sha256::digest(self.authority())
            .iter()
            .map(|byte| format!("{byte:02X}"))
            .collect();
        pairs.join(":")
    }
}

impl ResolvesServerCert for Certificates {
    fn resolve(&self, _hello: ClientHello<'_>) -> Option<Arc<CertifiedKey>> {
        let leaf = self.leaf.read().unwrap_or_else(PoisonError::into_inner);
        Some(Arc::clone(&leaf.certified))
    }
}

impl fmt::Debug for Certificates {
    /// Without the key.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Certificates")
            .field("authority", &self.authority.name)
            .finish_non_exhaustive()
    }
}

fn day(now: WallTime) -> Result<Date, Error> {
    let now = Timestamp::from_millisecond(now.0).map_err(refused)?;
    Ok(TimeZone::UTC.to_datetime(now).date())
}

fn ends_within(end: Date, today: Date, days: i32) -> bool {
    today.checked_add(days.days()).is_ok_and(|soon| end < soon)
}
