//! This cell's own certificate authority: made once, and signing only for what `names` permits.
//!
//! Whoever installs its certificate on a phone trusts it for this cell and for nothing else,
//! because that limit stands in the certificate itself. How it is kept is in `file`.

use std::sync::Arc;

use jiff::civil::Date;
use jiff::{Span, ToSpan};
use rcgen::{
    BasicConstraints, CertificateParams, DistinguishedName, DnType, ExtendedKeyUsagePurpose, IsCa,
    Issuer, KeyPair, KeyUsagePurpose, SanType, date_time_ymd,
};
use rustls::crypto::ring::sign::any_ecdsa_type;
use rustls::pki_types::{CertificateDer, PrivateKeyDer, PrivatePkcs8KeyDer};
use rustls::sign::CertifiedKey;

use super::machine::Machine;
use super::names::Permitted;
use super::{Error, refused};

/// After this time the phones have to be visited again.
const AUTHORITY_YEARS: i32 = 10;
/// Some phones refuse certificates of more than 397 days; this one is renewed long before.
const LEAF_DAYS: i32 = 380;
/// Clocks of phones and computers differ: a certificate of today is valid since yesterday.
const SLACK_DAYS: i32 = 1;

/// The authority, able to sign.
pub struct Authority {
    /// How phones list it.
    pub name: String,
    pub made_on: Date,
    pub valid_until: Date,
    pub permitted: Permitted,
    pub key: KeyPair,
    pub certificate: CertificateDer<'static>,
    /// The certificate as text.
    pub pem: String,
}

/// A certificate for the pages, with its key.
pub struct Leaf {
    /// What it is for.
    pub covers: Machine,
    pub valid_until: Date,
    pub certified: Arc<CertifiedKey>,
}

impl Authority {
    /// A new one for this machine.
    pub fn new(machine: &Machine, today: Date) -> Result<Self, Error> {
        let host = machine.names.iter().find(|name| *name != "localhost");
        let host = host.map_or("cell", String::as_str);
        let name = format!("TEAM {host} {today}");
        let permitted = Permitted::on(machine);
        let valid_until = later(today, AUTHORITY_YEARS.years())?;
        let key = KeyPair::generate().map_err(refused)?;
        let mut params = params(&name, today, valid_until)?;
        params.is_ca = IsCa::Ca(BasicConstraints::Constrained(0));
        params.key_usages = vec![KeyUsagePurpose::KeyCertSign, KeyUsagePurpose::CrlSign];
        params.name_constraints = Some(permitted.constraints());
        let certificate = params.self_signed(&key).map_err(refused)?;
        Ok(Self {
            name,
            made_on: today,
            valid_until,
            permitted,
            key,
            certificate: certificate.der().clone(),
            pem: certificate.pem(),
        })
    }

    /// A certificate for what of this machine the authority may sign for.
    pub fn issue(&self, machine: &Machine, today: Date) -> Result<Leaf, Error> {
        let covers = self.permitted.of(machine);
        let valid_until = later(today, LEAF_DAYS.days())?.min(self.valid_until);
        let (certificate, key) = self.sign(&covers, today, valid_until)?;
        let key = PrivateKeyDer::from(PrivatePkcs8KeyDer::from(key.serialize_der()));
        let key = any_ecdsa_type(&key).map_err(refused)?;
        let chain = vec![certificate, self.certificate.clone()];
        Ok(Leaf {
            covers,
            valid_until,
            certified: Arc::new(CertifiedKey::new(chain, key)),
        })
    }

    /// Signs without asking what is permitted; browsers ask.
    pub(super) fn sign(
        &self,
        machine: &Machine,
        today: Date,
        valid_until: Date,
    ) -> Result<(CertificateDer<'static>, KeyPair), Error> {
        let key = KeyPair::generate().map_err(refused)?;
        let mut leaf = params("TEAM", today, valid_until)?;
        for name in &machine.names {
            let name = name.as_str().try_into().map_err(refused)?;
            leaf.subject_alt_names.push(SanType::DnsName(name));
        }
        let addresses = machine.addresses.iter().copied().map(SanType::IpAddress);
        leaf.subject_alt_names.extend(addresses);
        leaf.key_usages = vec![KeyUsagePurpose::DigitalSignature];
        leaf.extended_key_usages = vec![ExtendedKeyUsagePurpose::ServerAuth];
        leaf.use_authority_key_identifier_extension = true;
        // The issuer needs of the authority's parameters what stands in its certificate.
        let authority = params(&self.name, self.made_on, self.valid_until)?;
        let issuer = Issuer::from_params(&authority, &self.key);
        let certificate = leaf.signed_by(&key, &issuer).map_err(refused)?;
        Ok((certificate.der().clone(), key))
    }
}

fn params(name: &str, today: Date, valid_until: Date) -> Result<CertificateParams, Error> {
    let part = |number: i8| u8::try_from(number).map_err(refused);
    let since = later(today, (-SLACK_DAYS).days())?;
    let mut params = CertificateParams::default();
    params.distinguished_name = DistinguishedName::new();
    params.distinguished_name.push(DnType::CommonName, name);
    let (month, day) = (part(since.month())?, part(since.day())?);
    params.not_before = date_time_ymd(since.year().into(), month, day);
    let (month, day) = (part(valid_until.month())?, part(valid_until.day())?);
    params.not_after = date_time_ymd(valid_until.year().into(), month, day);
    Ok(params)
}

fn later(date: Date, span: Span) -> Result<Date, Error> {
    date.checked_add(span).map_err(refused)
}
