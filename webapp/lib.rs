//! The phone app as bytes in the program: what the build script built, looked up by path.
//!
//! Not here: HTTP (the server decides about headers and caching), the app itself (`src/`).

use std::borrow::Cow;

include!(concat!(env!("OUT_DIR"), "/files.rs"));

/// One line of the list that the build script writes.
struct File {
    name: &'static str,
    plain: &'static [u8],
    brotli: Option<&'static [u8]>,
    gzip: Option<&'static [u8]>,
}

/// One file of the app.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Asset {
    /// The content.
    pub bytes: Cow<'static, [u8]>,
    /// The content packed with Brotli, when that is smaller.
    pub brotli: Option<&'static [u8]>,
    /// The content packed with gzip, when that is smaller.
    pub gzip: Option<&'static [u8]>,
    /// The media type to send.
    pub mime: &'static str,
    /// True when the name holds a hash of the content, so that a browser may keep it for ever.
    pub immutable: bool,
}

/// The file under `path` (with or without the leading slash; the empty path is the page itself).
///
/// The app routes in the fragment (`#/teach`), so the server knows no other page.
pub fn asset(path: &str) -> Option<Asset> {
    let name = match path.trim_start_matches('/') {
        "" => "index.html",
        name => name,
    };
    let index = FILES.binary_search_by(|file| file.name.cmp(name)).ok()?;
    let file = FILES.get(index)?;
    Some(Asset {
        bytes: Cow::Borrowed(file.plain),
        brotli: file.brotli,
        gzip: file.gzip,
        mime: mime(name),
        immutable: name.starts_with("assets/"),
    })
}

/// The names of all files, sorted.
pub fn names() -> impl Iterator<Item = &'static str> {
    FILES.iter().map(|file| file.name)
}

fn mime(name: &str) -> &'static str {
    match name.rsplit('.').next() {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("json") => "application/json",
        Some("webmanifest") => "application/manifest+json",
        Some("txt") => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_is_served_under_its_name_and_under_the_bare_slash() {
        let page = asset("/").unwrap();
        assert_eq!(Some(page.clone()), asset("index.html"));
        assert_eq!(page.mime, "text/html; charset=utf-8");
        assert!(!page.immutable);
    }

    #[test]
    fn every_local_file_that_the_page_names_is_there() {
        let page = asset("/").unwrap();
        let text = std::str::from_utf8(&page.bytes).unwrap();
        for attribute in ["src=\"/", "href=\"/"] {
            for rest in text.split(attribute).skip(1) {
                let name = rest.split('"').next().unwrap();
                assert!(asset(name).is_some(), "{name} is named but not embedded");
            }
        }
    }

    #[test]
    fn only_names_with_a_hash_are_immutable() {
        for name in names() {
            assert_eq!(asset(name).unwrap().immutable, name.starts_with("assets/"));
        }
    }

    #[test]
    fn packed_copies_are_smaller_and_no_files_of_their_own() {
        assert!(names().all(|name| !name.ends_with(".br") && !name.ends_with(".gz")));
        for name in names() {
            let asset = asset(name).unwrap();
            for packed in [asset.brotli, asset.gzip].into_iter().flatten() {
                assert!(packed.len() < asset.bytes.len(), "{name}");
            }
        }
    }

    #[test]
    fn unknown_paths_and_steps_upwards_find_nothing() {
        for path in [
            "/nothing",
            "../Cargo.toml",
            "/assets/../index.html",
            "assets",
        ] {
            assert_eq!(asset(path), None, "{path}");
        }
    }
}
