//! Certificates as a phone judges them that trusts the cell's authority and nobody else.

use std::fs;
use std::net::IpAddr;
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use rustls::RootCertStore;
use rustls::client::WebPkiServerVerifier;
use rustls::client::danger::ServerCertVerifier;
use rustls::crypto::ring;
use rustls::pki_types::{CertificateDer, ServerName, UnixTime};

use super::{Certificates, Error, Machine, day};
use crate::clock::WallTime;
use crate::test_support::TestFolder;

const DAY_MS: i64 = 24 * 3_600 * 1_000;
const NOW: WallTime = WallTime(1_780_000_000_000);

fn machine(last: u8) -> Machine {
    Machine::new("cell-pc", vec![[192, 168, 7, last].into()])
}

fn in_days(days: i64) -> WallTime {
    NOW.plus_ms(days * DAY_MS)
}

fn served(certificates: &Certificates) -> CertificateDer<'static> {
    certificates.leaf.read().unwrap().certified.cert[0].clone()
}

/// Whether a phone with the authority's certificate opens `https://host/` at this time.
fn trusted(authority: &[u8], leaf: &CertificateDer<'_>, host: &str, now: WallTime) -> bool {
    let mut roots = RootCertStore::empty();
    roots.add(authority.to_vec().into()).unwrap();
    let provider = Arc::new(ring::default_provider());
    let verifier = WebPkiServerVerifier::builder_with_provider(Arc::new(roots), provider);
    let name = ServerName::try_from(host.to_owned()).unwrap();
    let now = Duration::from_millis(u64::try_from(now.0).unwrap());
    let now = UnixTime::since_unix_epoch(now);
    let verifier = verifier.build().unwrap();
    verifier
        .verify_server_cert(leaf, &[], &name, &[], now)
        .is_ok()
}

fn open(folder: &Path, last: u8, now: WallTime) -> Result<Arc<Certificates>, Error> {
    Certificates::open(&folder.join("https"), &machine(last), now)
}

#[test]
fn the_computer_is_trusted_under_its_names_and_addresses_and_under_no_other() {
    let folder = TestFolder::new();
    let certificates = open(folder.path(), 20, NOW).unwrap();
    let (authority, leaf) = (certificates.authority(), served(&certificates));
    for host in [
        "192.168.7.20",
        "127.0.0.1",
        "::1",
        "localhost",
        "cell-pc",
        "cell-pc.local",
    ] {
        assert!(trusted(authority, &leaf, host, NOW), "{host}");
    }
    for host in ["192.168.7.21", "8.8.8.8", "other.local", "example.com"] {
        assert!(!trusted(authority, &leaf, host, NOW), "{host}");
    }
    let other = TestFolder::new();
    let other = open(other.path(), 20, NOW).unwrap();
    assert!(!trusted(other.authority(), &leaf, "192.168.7.20", NOW));
}

#[test]
fn whoever_steals_the_authority_can_pretend_to_be_nobody_in_the_world() {
    let folder = TestFolder::new();
    let certificates = open(folder.path(), 20, NOW).unwrap();
    let hosts = ["bank.example", "example.com"];
    let addresses: [IpAddr; 1] = [[8, 8, 8, 8].into()];
    for (names, addresses) in [(&hosts[..], &[][..]), (&[], &addresses[..])] {
        let world = Machine {
            names: names.iter().map(|name| (*name).to_owned()).collect(),
            addresses: addresses.iter().copied().collect(),
        };
        let today = day(NOW).unwrap();
        let until = day(in_days(300)).unwrap();
        let (forged, _) = certificates.authority.sign(&world, today, until).unwrap();
        for host in names.iter().copied().chain(["8.8.8.8"]) {
            assert!(
                !trusted(certificates.authority(), &forged, host, NOW),
                "{host}"
            );
        }
    }
}

#[test]
fn a_certificate_is_valid_since_yesterday_and_for_less_than_the_397_days_that_phones_allow() {
    let folder = TestFolder::new();
    let certificates = open(folder.path(), 20, NOW).unwrap();
    let leaf = served(&certificates);
    let valid = |days| trusted(certificates.authority(), &leaf, "cell-pc", in_days(days));
    assert!(valid(-1) && valid(0) && valid(379));
    assert!(!valid(-2) && !valid(381));
}

#[test]
fn the_authority_stays_the_same_from_start_to_start() {
    let folder = TestFolder::new();
    let first = open(folder.path(), 20, NOW).unwrap();
    let again = open(folder.path(), 99, in_days(3_000)).unwrap();
    assert_eq!(first.authority(), again.authority());
    assert_eq!(first.authority_sha256(), again.authority_sha256());
    let leaf = served(&again);
    let phone = |host| trusted(first.authority(), &leaf, host, in_days(3_000));
    assert!(phone("192.168.7.99"));
    assert!(
        !phone("192.168.7.20"),
        "the computer has another address now"
    );
}

#[test]
fn a_running_server_follows_a_change_of_address_and_the_calendar() {
    let folder = TestFolder::new();
    let certificates = open(folder.path(), 20, NOW).unwrap();
    let first = served(&certificates);
    assert!(!certificates.refresh(&machine(20), in_days(200)).unwrap());
    assert_eq!(served(&certificates), first);

    assert!(certificates.refresh(&machine(21), in_days(200)).unwrap());
    let moved = served(&certificates);
    let valid = |leaf, host, days| trusted(certificates.authority(), leaf, host, in_days(days));
    assert!(valid(&moved, "192.168.7.21", 200));

    assert!(!certificates.refresh(&machine(21), in_days(470)).unwrap());
    assert!(certificates.refresh(&machine(21), in_days(500)).unwrap());
    let later = served(&certificates);
    assert!(!valid(&moved, "192.168.7.21", 600) && valid(&later, "192.168.7.21", 600));
}

#[test]
fn near_the_authoritys_end_certificates_end_with_it_and_after_it_the_start_is_refused() {
    let folder = TestFolder::new();
    open(folder.path(), 20, NOW).unwrap();
    let last_days = open(folder.path(), 20, in_days(3_640)).unwrap();
    assert!(!last_days.refresh(&machine(20), in_days(3_641)).unwrap());
    let leaf = served(&last_days);
    assert!(trusted(
        last_days.authority(),
        &leaf,
        "cell-pc",
        in_days(3_650)
    ));
    for days in [-30, 3_653, 9_000] {
        let refusal = open(folder.path(), 20, in_days(days)).unwrap_err();
        assert!(matches!(refusal, Error::OutOfTime { .. }), "{refusal}");
        assert!(refusal.to_string().contains("set the clock"), "{refusal}");
    }
    open(folder.path(), 20, in_days(1)).unwrap();
}

#[test]
fn nobody_else_can_read_the_key_and_a_key_that_others_can_read_is_refused() {
    let folder = TestFolder::new();
    open(folder.path(), 20, NOW).unwrap();
    let path = folder.path().join("https/authority.json");
    let mode = |path: &Path| fs::metadata(path).unwrap().mode() & 0o777;
    assert_eq!((mode(&path), mode(path.parent().unwrap())), (0o600, 0o700));
    let before = fs::read(&path).unwrap();
    for open_to in [0o640, 0o604, 0o666] {
        fs::set_permissions(&path, fs::Permissions::from_mode(open_to)).unwrap();
        let refusal = open(folder.path(), 20, NOW).unwrap_err();
        assert!(matches!(refusal, Error::Exposed { .. }), "{refusal}");
        assert!(refusal.to_string().contains("chmod 600"), "{refusal}");
    }
    fs::set_permissions(&path, fs::Permissions::from_mode(0o600)).unwrap();
    open(folder.path(), 20, NOW).unwrap();
    assert_eq!(fs::read(&path).unwrap(), before);
}

#[test]
fn a_damaged_file_is_refused_and_left_alone() {
    let folder = TestFolder::new();
    open(folder.path(), 20, NOW).unwrap();
    let path = folder.path().join("https/authority.json");
    let whole = fs::read_to_string(&path).unwrap();
    let other = TestFolder::new();
    open(other.path(), 20, NOW).unwrap();
    let other = fs::read_to_string(other.path().join("https/authority.json")).unwrap();
    let key = |text: &str| {
        let saved: serde_json::Value = serde_json::from_str(text).unwrap();
        saved["key"].clone()
    };
    let mut mixed: serde_json::Value = serde_json::from_str(&whole).unwrap();
    mixed["key"] = key(&other);
    let half = whole[..whole.len() / 2].to_owned();
    for text in [String::new(), half, mixed.to_string()] {
        fs::write(&path, &text).unwrap();
        let refusal = open(folder.path(), 20, NOW).unwrap_err();
        assert!(matches!(refusal, Error::Damaged { .. }), "{refusal}");
        assert_eq!(fs::read_to_string(&path).unwrap(), text);
    }
}

#[test]
fn what_a_power_failure_left_half_written_is_no_obstacle() {
    let folder = TestFolder::new();
    fs::create_dir(folder.path().join("https")).unwrap();
    fs::write(folder.path().join("https/authority.unfinished"), "{").unwrap();
    let certificates = open(folder.path(), 20, NOW).unwrap();
    let again = open(folder.path(), 20, NOW).unwrap();
    assert_eq!(certificates.authority(), again.authority());
}
