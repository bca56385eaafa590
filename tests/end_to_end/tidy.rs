//! The house rules as tests. Most are absences: something that must not be found anywhere.
//!
//! What the compiler already proves (no `unsafe`, no cycles between crates) is only checked to be
//! switched on.

mod dependencies;
mod documents;
mod sources;
mod words;

use std::path::{Path, PathBuf};
use std::process::Command;

/// The top of the repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// One file that belongs to the repository.
struct Tracked {
    /// Path from the top, with slashes.
    path: String,
    bytes: Vec<u8>,
}

impl Tracked {
    fn text(&self) -> String {
        String::from_utf8_lossy(&self.bytes).into_owned()
    }

    fn has_extension(&self, extensions: &[&str]) -> bool {
        extensions
            .iter()
            .any(|extension| self.path.ends_with(&format!(".{extension}")))
    }

    fn is_in(&self, folders: &[&str]) -> bool {
        folders.iter().any(|folder| self.path.starts_with(folder))
    }
}

/// Everything Git knows or would take at the next `git add`.
fn tracked() -> Vec<Tracked> {
    let root = root();
    let listing = Command::new("git")
        .args([
            "ls-files",
            "-z",
            "--cached",
            "--others",
            "--exclude-standard",
        ])
        .current_dir(&root)
        .output()
        .expect("git can be run");
    assert!(
        listing.status.success(),
        "git ls-files: {}",
        String::from_utf8_lossy(&listing.stderr)
    );
    let names = String::from_utf8(listing.stdout).expect("file names are UTF-8");
    let mut files = Vec::new();
    for path in names.split('\0').filter(|path| !path.is_empty()) {
        // A file deleted but not yet committed is still listed.
        if let Ok(bytes) = std::fs::read(root.join(path)) {
            files.push(Tracked {
                path: path.to_owned(),
                bytes,
            });
        }
    }
    assert!(
        files.len() > 100,
        "only {} files: is this the repository?",
        files.len()
    );
    files
}

/// Fails with the whole list, so that one run shows everything there is to mend.
fn none(rule: &str, found: &[String]) {
    assert!(found.is_empty(), "{rule}:\n{}", found.join("\n"));
}
