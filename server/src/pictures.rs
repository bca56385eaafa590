//! Photos of tasks: what may be stored as one. The first bytes decide what a file is; a name or a
//! header that says something else is not believed.

use sha2::{Digest, Sha256};

use crate::ids::TaskId;
use crate::store::pictures::{Picture, PictureKind};
use crate::store::{self, Store, Task};

/// The largest photo that is stored. The phone sends smaller ones.
pub(crate) const MAX_BYTES: usize = 100 * 1024;

/// Why a photo was not stored.
#[derive(Debug, thiserror::Error)]
pub enum PictureError {
    /// The store refused.
    #[error(transparent)]
    Store(#[from] store::Error),
    /// It is none of the kinds that are shown.
    #[error("this is no JPEG, PNG or WebP picture")]
    Unknown,
    /// It is too large.
    #[error("the picture is larger than {} kB", MAX_BYTES / 1024)]
    TooLarge,
}

/// Gives a task a photo.
///
/// # Errors
/// When it can't be shown; then the task keeps the one it had.
pub(crate) async fn store(store: &Store, task: TaskId, body: &[u8]) -> Result<Task, PictureError> {
    if body.len() > MAX_BYTES {
        return Err(PictureError::TooLarge);
    }
    let kind = kind_of(body).ok_or(PictureError::Unknown)?;
    let sha256: String = Sha256::digest(body)
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect();
    let body = body.to_vec();
    store
        .set_picture(task, &Picture { kind, body }, &sha256)
        .await?;
    Ok(store.task(task).await?)
}

fn kind_of(body: &[u8]) -> Option<PictureKind> {
    match body {
        [0xff, 0xd8, 0xff, ..] => Some(PictureKind::Jpeg),
        [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n', ..] => Some(PictureKind::Png),
        [
            b'R',
            b'I',
            b'F',
            b'F',
            _,
            _,
            _,
            _,
            b'W',
            b'E',
            b'B',
            b'P',
            ..,
        ] => Some(PictureKind::Webp),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_bytes_say_what_a_picture_is() {
        assert_eq!(kind_of(b"\xff\xd8\xff\xe0\x00"), Some(PictureKind::Jpeg));
        assert_eq!(kind_of(b"\x89PNG\r\n\x1a\n\x00"), Some(PictureKind::Png));
        assert_eq!(
            kind_of(b"RIFF\x10\x00\x00\x00WEBPVP8 "),
            Some(PictureKind::Webp)
        );
        for other in [
            &b""[..],
            b"\xff\xd8",
            b"<svg xmlns=",
            b"GIF89a",
            b"RIFF\x10\x00\x00\x00WAVE",
        ] {
            assert_eq!(kind_of(other), None);
        }
    }
}
