//! HTTP Basic authentication against the accounts a controller has when it leaves the factory.

const ACCOUNTS: [(&str, &str); 2] = [("Default User", "robotics"), ("Admin", "robotics")];
const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// True when the value of an `Authorization` header names one of the accounts.
pub fn is_known(authorization: &str) -> bool {
    let Some((scheme, credentials)) = authorization.split_once(' ') else {
        return false;
    };
    scheme.eq_ignore_ascii_case("basic")
        && ACCOUNTS
            .iter()
            .any(|(user, password)| base64(&format!("{user}:{password}")) == credentials.trim())
}

fn base64(text: &str) -> String {
    let mut out = String::new();
    for chunk in text.as_bytes().chunks(3) {
        let bits = chunk.iter().enumerate().fold(0u32, |bits, (place, byte)| {
            bits | u32::from(*byte) << (16 - 8 * place)
        });
        for place in 0..4 {
            if place <= chunk.len() {
                out.push(char::from(
                    ALPHABET[(bits >> (18 - 6 * place) & 63) as usize],
                ));
            } else {
                out.push('=');
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_agrees_with_the_examples_of_rfc_4648() {
        let examples = [
            "", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy",
        ];
        for (length, expected) in examples.iter().enumerate() {
            assert_eq!(base64(&"foobar"[..length]), *expected);
        }
    }

    #[test]
    fn only_the_accounts_with_their_password_are_known() {
        assert!(is_known("Basic RGVmYXVsdCBVc2VyOnJvYm90aWNz"));
        assert!(!is_known("Basic RGVmYXVsdCBVc2VyOndyb25n"));
        assert!(!is_known("Digest RGVmYXVsdCBVc2VyOnJvYm90aWNz"));
        assert!(!is_known(""));
    }
}
