//! What this cell's authority may sign for: private networks, local names, and the names and
//! addresses that this computer had when the authority was made.

use std::net::IpAddr;

use rcgen::{CidrSubnet, GeneralSubtree, NameConstraints};
use serde::{Deserialize, Serialize};

use super::machine::Machine;

/// Networks that belong to nobody and are reached by nobody from outside.
const PRIVATE: [(&str, u8); 8] = [
    ("10.0.0.0", 8),
    ("127.0.0.0", 8),
    ("169.254.0.0", 16),
    ("172.16.0.0", 12),
    ("192.168.0.0", 16),
    ("::1", 128),
    ("fc00::", 7),
    ("fe80::", 10),
];

/// Names that mean something in the own network only; each stands for those below it too.
const LOCAL: [&str; 2] = ["local", "localhost"];

/// The names and networks that an authority may sign for.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Permitted {
    /// Names, with everything below them.
    names: Vec<String>,
    /// First address and length of the prefix.
    networks: Vec<(IpAddr, u8)>,
}

impl Permitted {
    /// For an authority that is made on this machine.
    pub fn on(machine: &Machine) -> Self {
        let private = PRIVATE
            .iter()
            .filter_map(|(text, prefix)| Some((text.parse().ok()?, *prefix)));
        let mut permitted = Self {
            names: LOCAL.map(str::to_owned).to_vec(),
            networks: private.collect(),
        };
        let more = machine.names.iter().filter(|name| !permitted.name(name));
        let more: Vec<String> = more.cloned().collect();
        permitted.names.extend(more);
        // A network of a company may use public addresses inside: those of this machine alone.
        let more = machine
            .addresses
            .iter()
            .filter(|ip| !permitted.address(**ip));
        let more: Vec<(IpAddr, u8)> = more.map(|ip| (*ip, length(*ip))).collect();
        permitted.networks.extend(more);
        permitted
    }

    /// What of the machine may stand in a certificate.
    pub fn of(&self, machine: &Machine) -> Machine {
        let (mut names, mut addresses) = (machine.names.clone(), machine.addresses.clone());
        names.retain(|name| self.name(name));
        addresses.retain(|ip| self.address(*ip));
        Machine { names, addresses }
    }

    /// As it stands in the authority's certificate.
    pub fn constraints(&self) -> NameConstraints {
        let names = self.names.iter().cloned().map(GeneralSubtree::DnsName);
        let networks = self.networks.iter().map(|(ip, prefix)| {
            GeneralSubtree::IpAddress(CidrSubnet::from_addr_prefix(*ip, *prefix))
        });
        NameConstraints {
            permitted_subtrees: names.chain(networks).collect(),
            excluded_subtrees: Vec::new(),
        }
    }

    fn name(&self, name: &str) -> bool {
        let below = |top: &str| {
            let rest = name.strip_suffix(top);
            rest.is_some_and(|rest| rest.is_empty() || rest.ends_with('.'))
        };
        self.names.iter().any(|top| below(top))
    }

    fn address(&self, ip: IpAddr) -> bool {
        self.networks.iter().any(|(network, prefix)| {
            let same_kind = network.is_ipv4() == ip.is_ipv4();
            let unequal = bits(*network) ^ bits(ip);
            same_kind && unequal.leading_zeros() >= u32::from(*prefix)
        })
    }
}

fn length(ip: IpAddr) -> u8 {
    if ip.is_ipv4() { 32 } else { 128 }
}

/// The address with its first bit at the top.
fn bits(ip: IpAddr) -> u128 {
    match ip {
        IpAddr::V4(v4) => u128::from(v4.to_bits()) << 96,
        IpAddr::V6(v6) => v6.to_bits(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn permitted() -> Permitted {
        let addresses = vec![[192, 0, 2, 9].into(), [192, 168, 7, 20].into()];
        Permitted::on(&Machine::new("cell-pc.factory.example", addresses))
    }

    #[test]
    fn private_networks_and_local_names_are_permitted() {
        let permitted = permitted();
        for ip in ["10.255.0.1", "172.16.0.1", "172.31.255.255", "192.168.0.1"] {
            assert!(permitted.address(ip.parse().unwrap()), "{ip}");
        }
        for ip in ["127.0.0.1", "169.254.3.4", "::1", "fd12::7", "fe80::1"] {
            assert!(permitted.address(ip.parse().unwrap()), "{ip}");
        }
        for name in ["localhost", "cell-pc.local", "other.local"] {
            assert!(permitted.name(name), "{name}");
        }
    }

    #[test]
    fn the_world_is_not() {
        let permitted = permitted();
        for ip in [
            "8.8.8.8",
            "172.32.0.1",
            "11.0.0.1",
            "192.0.2.8",
            "2001:db8::1",
            "::a00:1",
        ] {
            assert!(!permitted.address(ip.parse().unwrap()), "{ip}");
        }
        for name in [
            "example.com",
            "evillocal",
            "local.example",
            "factory.example",
        ] {
            assert!(!permitted.name(name), "{name}");
        }
    }

    #[test]
    fn what_this_computer_is_called_is_permitted_by_itself() {
        let permitted = permitted();
        assert!(permitted.name("cell-pc.factory.example"));
        assert!(permitted.address([192, 0, 2, 9].into()));
        let moved = Machine::new("other", vec![[192, 0, 2, 10].into(), [10, 0, 0, 1].into()]);
        let covered = permitted.of(&moved);
        assert!(!covered.names.contains("other") && covered.names.contains("other.local"));
        assert!(!covered.addresses.contains(&[192, 0, 2, 10].into()));
        assert!(covered.addresses.contains(&[10, 0, 0, 1].into()));
    }
}
