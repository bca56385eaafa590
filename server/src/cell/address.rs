//! The forms of a web address and of a certificate's fingerprint.

/// Why this is not the address of a controller's web services; nothing when it is.
pub(super) fn wrong_url(url: &str) -> Option<&'static str> {
    let Some(rest) = url
        .strip_prefix("http://")
        .or_else(|| url.strip_prefix("https://"))
    else {
        return Some("it does not begin with http:// or https://");
    };
    if rest.contains('@') {
        return Some("it holds an account");
    }
    let place = rest.strip_suffix('/').unwrap_or(rest);
    // An IPv6 address has colons of its own, and stands in brackets for that.
    let (host, port) = match place.strip_prefix('[').and_then(|v6| v6.split_once(']')) {
        Some((v6, "")) => (v6, None),
        Some((v6, after)) => match after.strip_prefix(':') {
            Some(port) => (v6, Some(port)),
            None => return Some("it goes on after the host"),
        },
        None => match place.split_once(':') {
            Some((host, port)) => (host, Some(port)),
            None => (place, None),
        },
    };
    let v6 = place.starts_with('[');
    let known = |c: char| c.is_ascii_alphanumeric() || "-._".contains(c) || (v6 && c == ':');
    if host.is_empty() || !host.chars().all(known) {
        return Some("its host is not a name or an address");
    }
    match port.map(str::parse::<u16>) {
        Some(Err(_) | Ok(0)) => Some("its port is not a number from 1 to 65535"),
        _ => None,
    }
}

/// A SHA-256 fingerprint as 64 lower-case digits; nothing when it is none. People copy it with
/// colons between the bytes.
pub(super) fn fingerprint(text: &str) -> Option<String> {
    let digits: String = text.chars().filter(|c| *c != ':').collect();
    let whole = digits.len() == 64 && digits.chars().all(|c| c.is_ascii_hexdigit());
    whole.then(|| digits.to_ascii_lowercase())
}
