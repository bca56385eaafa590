//! The authority's one file: written once and whole, readable for this program's user alone.

use std::fs::{self, DirBuilder, File, OpenOptions};
use std::io::{ErrorKind, Write};
use std::os::unix::fs::{DirBuilderExt, MetadataExt, OpenOptionsExt};
use std::path::Path;

use jiff::civil::Date;
use rcgen::KeyPair;
use rustls::pki_types::CertificateDer;
use rustls::pki_types::pem::PemObject;
use serde::{Deserialize, Serialize};

use super::authority::Authority;
use super::names::Permitted;
use super::{Error, refused};

const NOTE: &str = "TEAM's own certificate authority for this cell. Keep it secret and keep a \
     copy: without it the certificate has to be installed on every phone again.";

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Saved {
    note: String,
    name: String,
    made_on: Date,
    valid_until: Date,
    permitted: Permitted,
    certificate: String,
    key: String,
}

/// The authority of this file; nothing when there is no file.
pub fn load(path: &Path) -> Result<Option<Authority>, Error> {
    let failed = |source| Error::file(path, source);
    let mode = match fs::metadata(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        found => found.map_err(failed)?.mode(),
    };
    if mode & 0o077 != 0 {
        return Err(Error::Exposed {
            path: path.to_owned(),
            mode: mode & 0o777,
        });
    }
    let text = fs::read_to_string(path).map_err(failed)?;
    let damaged = |what: String| Error::Damaged {
        path: path.to_owned(),
        what,
    };
    let saved: Saved = serde_json::from_str(&text).map_err(|error| damaged(error.to_string()))?;
    let key = KeyPair::from_pem(&saved.key).map_err(|error| damaged(error.to_string()))?;
    let certificate = CertificateDer::from_pem_slice(saved.certificate.as_bytes())
        .map_err(|error| damaged(error.to_string()))?;
    // The public key stands in the certificate as it is.
    let public = key.public_key_raw();
    if !certificate.windows(public.len()).any(|part| part == public) {
        return Err(damaged("the key belongs to another certificate".to_owned()));
    }
    Ok(Some(Authority {
        name: saved.name,
        made_on: saved.made_on,
        valid_until: saved.valid_until,
        permitted: saved.permitted,
        key,
        certificate,
        pem: saved.certificate,
    }))
}

/// Writes a new authority's file. What a power failure leaves is no file or the whole one.
pub fn save(path: &Path, authority: &Authority) -> Result<(), Error> {
    let failed = |source| Error::file(path, source);
    let saved = Saved {
        note: NOTE.to_owned(),
        name: authority.name.clone(),
        made_on: authority.made_on,
        valid_until: authority.valid_until,
        permitted: authority.permitted.clone(),
        certificate: authority.pem.clone(),
        key: authority.key.serialize_pem(),
    };
    let text = serde_json::to_string_pretty(&saved).map_err(refused)?;
    let folder = path.parent().unwrap_or(Path::new("."));
    let mut private = DirBuilder::new();
    private.recursive(true).mode(0o700);
    private.create(folder).map_err(failed)?;
    let unfinished = path.with_extension("unfinished");
    match fs::remove_file(&unfinished) {
        Err(error) if error.kind() != ErrorKind::NotFound => return Err(failed(error)),
        _ => {}
    }
    let mut options = OpenOptions::new();
    let mut file = options
        .write(true)
        .create_new(true)
        .mode(0o600)
        .open(&unfinished)
        .map_err(failed)?;
    file.write_all(text.as_bytes()).map_err(failed)?;
    file.sync_all().map_err(failed)?;
    fs::rename(&unfinished, path).map_err(failed)?;
    let folder = File::open(folder).map_err(failed)?;
    folder.sync_all().map_err(failed)
}
