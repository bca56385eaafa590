//! The names and addresses of this computer, which its certificate has to carry.

use std::collections::BTreeSet;
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr};

/// Under what a browser can reach this computer.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Machine {
    /// Host names in small letters.
    pub names: BTreeSet<String>,
    /// Addresses of its network interfaces.
    pub addresses: BTreeSet<IpAddr>,
}

impl Machine {
    /// This computer as it is now. When the system does not list its interfaces, the addresses
    /// that the caller knows are all there is.
    pub fn here(known: IpAddr) -> Self {
        let listed = if_addrs::get_if_addrs().unwrap_or_else(|error| {
            tracing::warn!(%error, "the system does not list its addresses");
            Vec::new()
        });
        let listed = listed.iter().map(if_addrs::Interface::ip);
        let host = rustix::system::uname();
        Self::new(
            &host.nodename().to_string_lossy(),
            listed.chain([known]).collect(),
        )
    }

    /// A computer with this host name and these addresses.
    pub fn new(host: &str, addresses: Vec<IpAddr>) -> Self {
        let host = host.to_ascii_lowercase();
        let mut names = BTreeSet::from(["localhost".to_owned()]);
        if is_name(&host) {
            let first = host.split('.').next().unwrap_or_default();
            // What a computer that answers to mDNS is found under.
            names.insert(format!("{first}.local"));
            names.insert(host);
        }
        let own: [IpAddr; 2] = [Ipv4Addr::LOCALHOST.into(), Ipv6Addr::LOCALHOST.into()];
        let addresses = addresses.into_iter().filter(|ip| is_reached_by(*ip));
        Self {
            names,
            addresses: addresses.chain(own).collect(),
        }
    }
}

/// Whether a browser could be given this address. Link-local IPv6 addresses need the name of an
/// interface beside them, which no certificate can carry.
fn is_reached_by(ip: IpAddr) -> bool {
    let link_local = matches!(ip, IpAddr::V6(v6) if v6.is_unicast_link_local());
    !(ip.is_unspecified() || ip.is_multicast() || link_local)
}

/// Whether it is a host name that certificates take.
fn is_name(text: &str) -> bool {
    let label = |label: &str| {
        let known = |c: char| c.is_ascii_alphanumeric() || c == '-';
        !label.is_empty()
            && label.len() < 64
            && label.chars().all(known)
            && !label.starts_with('-')
            && !label.ends_with('-')
    };
    // A last part of digits only would be read as an address.
    let last = text.rsplit('.').next().unwrap_or_default();
    text.len() < 200 && text.split('.').all(label) && !last.chars().all(|c| c.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_computer_is_found_by_its_names_and_its_addresses() {
        let lan: IpAddr = [192, 168, 7, 20].into();
        let machine = Machine::new("Cell-PC.factory.example", vec![lan]);
        let names: Vec<&str> = machine.names.iter().map(String::as_str).collect();
        assert_eq!(
            names,
            ["cell-pc.factory.example", "cell-pc.local", "localhost"]
        );
        for address in ["192.168.7.20", "127.0.0.1", "::1"] {
            assert!(machine.addresses.contains(&address.parse().unwrap()));
        }
    }

    #[test]
    fn what_no_certificate_can_carry_is_left_out() {
        for host in ["", "under_score", "-dash", "a..b", "4711", "host.12"] {
            let machine = Machine::new(host, vec!["fe80::1".parse().unwrap(), [0; 4].into()]);
            assert_eq!(machine.names.len(), 1, "{host:?}");
            assert_eq!(machine.addresses.len(), 2);
        }
    }

    #[test]
    fn this_computer_is_found_under_loopback_whatever_the_system_says() {
        let machine = Machine::here([192, 168, 7, 20].into());
        assert!(machine.names.contains("localhost"));
        assert!(machine.addresses.contains(&[127, 0, 0, 1].into()));
        assert!(machine.addresses.contains(&[192, 168, 7, 20].into()));
    }
}
