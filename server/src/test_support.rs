//! What several unit tests need: a folder that goes away with the test.

use std::path::{Path, PathBuf};

/// A fresh folder; it is removed when the value is dropped.
pub(crate) struct TestFolder(PathBuf);

impl TestFolder {
    pub(crate) fn new() -> Self {
        let path = std::env::temp_dir().join(format!("team-test-{}", uuid::Uuid::now_v7()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    pub(crate) fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for TestFolder {
    fn drop(&mut self) {
        // A test that failed half-way may have left the folder in any state.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}
