//! The cookies of the one session with the controller.
//!
//! Every call must travel in the same session: the controller counts sessions, and mastership
//! belongs to one. The jar can be emptied, because a session that idled out answers 401 for ever.

use reqwest::Url;
use reqwest::cookie::{CookieStore, Jar};
use reqwest::header::HeaderValue;
use std::sync::{PoisonError, RwLock};

const SESSION: &str = "-http-session-";

/// A cookie jar that can be emptied.
#[derive(Debug, Default)]
pub(crate) struct SessionCookies(RwLock<Jar>);

impl SessionCookies {
    /// Forgets the session.
    pub(crate) fn clear(&self) {
        *self.0.write().unwrap_or_else(PoisonError::into_inner) = Jar::default();
    }

    /// The name of the session with the controller at `url`. The other cookie may change within a
    /// session.
    pub(crate) fn id(&self, url: &Url) -> Option<String> {
        let cookies = self.cookies(url)?;
        cookies
            .to_str()
            .ok()?
            .split(';')
            .filter_map(|pair| pair.trim().split_once('='))
            .find_map(|(name, value)| (name == SESSION).then(|| value.to_owned()))
    }

    /// Whether a session was opened with the controller at `url`.
    pub(crate) fn is_open(&self, url: &Url) -> bool {
        self.cookies(url).is_some()
    }
}

impl CookieStore for SessionCookies {
    fn set_cookies(&self, headers: &mut dyn Iterator<Item = &HeaderValue>, url: &Url) {
        self.0
            .read()
            .unwrap_or_else(PoisonError::into_inner)
            .set_cookies(headers, url);
    }

    fn cookies(&self, url: &Url) -> Option<HeaderValue> {
        self.0
            .read()
            .unwrap_or_else(PoisonError::into_inner)
            .cookies(url)
    }
}
