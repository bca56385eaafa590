//! Who may talk to the server: pairing code, cookie tokens, and the limit on wrong guesses.
//!
//! Not here: headers and cookies (`http::auth`), and the table of paired clients (`store`).

use std::collections::{HashMap, VecDeque};
use std::net::IpAddr;
use std::sync::{Mutex, PoisonError};

use sha2::{Digest, Sha256};

use crate::clock::WallTime;

/// Wrong codes that one address may send within [`WINDOW_MS`].
const GUESSES_PER_ADDRESS: usize = 5;
/// Wrong codes from everybody together within [`WINDOW_MS`].
const GUESSES_ALTOGETHER: usize = 60;
const WINDOW_MS: i64 = 60_000;

/// The code that a person types into the phone: eight digits, new with every start.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PairingCode(String);

impl PairingCode {
    /// A random code.
    ///
    /// # Errors
    /// When the operating system has no random numbers.
    pub fn random() -> Result<Self, getrandom::Error> {
        let mut bytes = [0; 8];
        getrandom::fill(&mut bytes)?;
        Ok(Self(format!(
            "{:08}",
            u64::from_le_bytes(bytes) % 100_000_000
        )))
    }

    /// The digits.
    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// Whether `guess` is the code; spaces are no matter. The time taken says nothing about it.
    fn is(&self, guess: &str) -> bool {
        let digits: String = guess.chars().filter(|c| !c.is_whitespace()).collect();
        let (ours, theirs) = (Sha256::digest(&self.0), Sha256::digest(digits));
        let differences = ours.iter().zip(theirs).fold(0, |sum, (a, b)| sum | (a ^ b));
        differences == 0
    }
}

/// What a paired client sends with every request; only its hash is stored.
pub struct Token(String);

impl Token {
    /// A random token of 256 bits.
    ///
    /// # Errors
    /// When the operating system has no random numbers.
    pub fn random() -> Result<Self, getrandom::Error> {
        let mut bytes = [0; 32];
        getrandom::fill(&mut bytes)?;
        Ok(Self(
            bytes.iter().map(|byte| format!("{byte:02x}")).collect(),
        ))
    }

    /// A token as it came from a client.
    pub fn received(text: &str) -> Self {
        Self(text.to_owned())
    }

    /// The text of the cookie.
    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// What the store keeps.
    pub fn sha256(&self) -> [u8; 32] {
        Sha256::digest(&self.0).into()
    }
}

/// How a guess came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It is the code.
    Right,
    /// It is not.
    Wrong,
    /// It was not looked at, because there were too many wrong ones.
    TooMany {
        /// When to try again.
        wait_s: u64,
    },
}

/// Checks guesses, and counts the wrong ones.
pub struct Gatekeeper {
    code: PairingCode,
    wrong: Mutex<Wrong>,
}

#[derive(Default)]
struct Wrong {
    by_address: HashMap<IpAddr, VecDeque<WallTime>>,
    all: VecDeque<WallTime>,
}

impl Gatekeeper {
    /// A gatekeeper for this code.
    pub fn new(code: PairingCode) -> Self {
        Self {
            code,
            wrong: Mutex::default(),
        }
    }

    /// The code.
    pub fn code(&self) -> &PairingCode {
        &self.code
    }

    /// Judges a guess.
    pub fn judge(&self, address: IpAddr, guess: &str, now: WallTime) -> Verdict {
        let mut wrong = self.wrong.lock().unwrap_or_else(PoisonError::into_inner);
        wrong.forget_before(now.plus_ms(-WINDOW_MS));
        let oldest = wrong.limiting(address);
        if let Some(oldest) = oldest {
            let wait_ms = oldest.plus_ms(WINDOW_MS).0 - now.0;
            let wait_s = u64::try_from(wait_ms).unwrap_or(0).div_ceil(1_000).max(1);
            return Verdict::TooMany { wait_s };
        }
        if self.code.is(guess) {
            return Verdict::Right;
        }
        wrong.by_address.entry(address).or_default().push_back(now);
        wrong.all.push_back(now);
        Verdict::Wrong
    }
}

impl Wrong {
    fn forget_before(&mut self, limit: WallTime) {
        let forget = |times: &mut VecDeque<WallTime>| {
            while times.front().is_some_and(|time| *time <= limit) {
                times.pop_front();
            }
        };
        forget(&mut self.all);
        self.by_address.values_mut().for_each(forget);
        self.by_address.retain(|_, times| !times.is_empty());
    }

    /// The guess that has to grow old before the next one is looked at.
    fn limiting(&self, address: IpAddr) -> Option<WallTime> {
        let ours = self.by_address.get(&address);
        let ours = ours.filter(|times| times.len() >= GUESSES_PER_ADDRESS);
        let all = Some(&self.all).filter(|times| times.len() >= GUESSES_ALTOGETHER);
        ours.or(all)?.front().copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::net::Ipv4Addr;

    const NOW: WallTime = WallTime(1_000_000);

    fn gatekeeper() -> Gatekeeper {
        Gatekeeper::new(PairingCode("04711815".into()))
    }

    fn address(last: u8) -> IpAddr {
        Ipv4Addr::new(192, 0, 2, last).into()
    }

    #[test]
    fn a_code_has_eight_digits_and_changes() {
        let codes: Vec<PairingCode> = (0..4).map(|_| PairingCode::random().unwrap()).collect();
        for code in &codes {
            assert_eq!(code.as_str().len(), 8);
            assert!(code.as_str().bytes().all(|b| b.is_ascii_digit()));
        }
        assert!(codes.windows(2).any(|pair| pair[0] != pair[1]));
    }

    #[test]
    fn the_code_may_be_typed_with_spaces() {
        let gatekeeper = gatekeeper();
        assert_eq!(
            gatekeeper.judge(address(1), " 0471 1815", NOW),
            Verdict::Right
        );
        assert_eq!(gatekeeper.judge(address(1), "4711815", NOW), Verdict::Wrong);
        assert_eq!(gatekeeper.judge(address(1), "", NOW), Verdict::Wrong);
    }

    #[test]
    fn after_five_wrong_codes_even_the_right_one_waits_for_a_minute() {
        let gatekeeper = gatekeeper();
        for _ in 0..5 {
            assert_eq!(gatekeeper.judge(address(1), "1", NOW), Verdict::Wrong);
        }
        let limited = gatekeeper.judge(address(1), "04711815", NOW.plus_ms(10_000));
        assert_eq!(limited, Verdict::TooMany { wait_s: 50 });
        assert_eq!(
            gatekeeper.judge(address(2), "04711815", NOW),
            Verdict::Right
        );
        let later = NOW.plus_ms(60_000);
        assert_eq!(
            gatekeeper.judge(address(1), "04711815", later),
            Verdict::Right
        );
    }

    #[test]
    fn many_addresses_together_are_limited_too() {
        let gatekeeper = gatekeeper();
        for i in 0..60 {
            assert_eq!(gatekeeper.judge(address(i), "1", NOW), Verdict::Wrong);
        }
        let limited = gatekeeper.judge(address(99), "04711815", NOW);
        assert_eq!(limited, Verdict::TooMany { wait_s: 60 });
    }

    #[test]
    fn a_token_is_not_what_is_stored() {
        let token = Token::random().unwrap();
        assert_eq!(token.as_str().len(), 64);
        assert_eq!(Token::received(token.as_str()).sha256(), token.sha256());
        assert_ne!(Token::random().unwrap().sha256(), token.sha256());
    }
}
