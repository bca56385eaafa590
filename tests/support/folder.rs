//! A folder for one test, under the target folder, removed afterwards.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

static COUNT: AtomicU32 = AtomicU32::new(0);

/// An empty folder that vanishes when the value is dropped.
pub struct Folder(PathBuf);

impl Folder {
    /// Makes it inside `parent`, which is `env!("CARGO_TARGET_TMPDIR")` of the test.
    ///
    /// # Panics
    /// When the folder cannot be made.
    #[must_use]
    pub fn new(parent: &str, label: &str) -> Self {
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        let path = Path::new(parent).join(format!("{label}-{}-{number}", std::process::id()));
        std::fs::create_dir_all(&path)
            .unwrap_or_else(|error| panic!("can't make {}: {error}", path.display()));
        Self(path)
    }

    /// Makes it under a fixed name, in the place of what an earlier run may have left there.
    ///
    /// # Panics
    /// When the folder cannot be made.
    #[must_use]
    pub fn replacing(parent: &str, name: &str) -> Self {
        let path = Path::new(parent).join(name);
        let _ = std::fs::remove_dir_all(&path);
        std::fs::create_dir_all(&path)
            .unwrap_or_else(|error| panic!("can't make {}: {error}", path.display()));
        Self(path)
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.0
    }

    /// Writes a file into it and tells where.
    ///
    /// # Panics
    /// When the file cannot be written.
    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, content)
            .unwrap_or_else(|error| panic!("can't write {}: {error}", path.display()));
        path
    }

    /// Makes this folder hold the same files as another (one level deep).
    ///
    /// # Panics
    /// When a file cannot be read or written.
    pub fn copy_from(&self, other: &Folder) {
        let entries = std::fs::read_dir(other.path()).expect("the other folder can be listed");
        for entry in entries {
            let from = entry.expect("the other folder can be listed").path();
            if from.is_file() {
                let to = self.0.join(from.file_name().unwrap_or_default());
                std::fs::copy(&from, &to)
                    .unwrap_or_else(|error| panic!("can't copy {}: {error}", from.display()));
            }
        }
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // A leftover under the target folder harms nobody, and a drop must not panic.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}
