//! Flight records on their way out: thinned out for plots, and as CSV and MCAP files.
//!
//! Records are read in pages, so a long one never has to be in memory. Not here: how a record is
//! made (`reproducing`) and stored (`store::flights`).

mod csv;
mod decimation;
mod mcap;

pub use decimation::{Bucket, Decimation};

use crate::store::cycles::Cycle;
use crate::store::flights::{FlightPages, Stretch};
use crate::store::reproductions::Reproduction;
use crate::store::{self, Store};

/// Why a file could not be written to its end.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// The store refused, or the record is damaged.
    #[error(transparent)]
    Store(#[from] store::Error),
    /// The MCAP writer refused.
    #[error("the MCAP file could not be written: {0}")]
    Mcap(#[from] ::mcap::McapError),
    /// The work was broken off.
    #[error("the file could not be worked out: {0}")]
    Broke(#[from] tokio::task::JoinError),
}

/// The kind of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Comma-separated values, one row per cycle.
    Csv,
    /// MCAP with JSON messages.
    Mcap,
}

impl Format {
    /// The end of a file's name.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Mcap => "mcap",
        }
    }
}

/// A name for the file of a reproduction that sorts by time and is the same every time.
pub fn file_name(reproduction: &Reproduction, format: Format) -> String {
    let began = reproduction.armed_at.unwrap_or(reproduction.created_at);
    let time = jiff::Timestamp::from_millisecond(began.0)
        .unwrap_or(jiff::Timestamp::UNIX_EPOCH)
        .strftime("%Y%m%dT%H%M%SZ")
        .to_string();
    let id = reproduction.id.to_string();
    let end = &id[id.len().saturating_sub(8)..];
    format!("motion_{time}_{end}.{}", format.extension())
}

/// A file in the making.
pub struct Export {
    pages: FlightPages,
    file: Option<File>,
}

enum File {
    Csv { begun: bool },
    Mcap(Box<mcap::Recorder>),
}

impl Export {
    /// Begins the file of a reproduction.
    ///
    /// # Errors
    /// When its events can't be read.
    pub async fn begin(
        store: &Store,
        reproduction: &Reproduction,
        format: Format,
    ) -> Result<Self, ExportError> {
        let file = match format {
            Format::Csv => File::Csv { begun: false },
            Format::Mcap => {
                let events = store.flight_events(reproduction.id).await?;
                File::Mcap(Box::new(mcap::Recorder::new(reproduction, events)?))
            }
        };
        Ok(Self {
            pages: store.flight(reproduction.id, Stretch::ALL),
            file: Some(file),
        })
    }

    /// The next piece of the file; nothing when it is complete.
    ///
    /// # Errors
    /// When the record can't be read to its end.
    pub async fn next(&mut self) -> Result<Option<Vec<u8>>, ExportError> {
        let Some(mut file) = self.file.take() else {
            return Ok(None);
        };
        let page = self.pages.next().await?;
        let (bytes, file) = tokio::task::spawn_blocking(move || {
            let bytes = file.write(page.as_deref())?;
            Ok::<_, ExportError>((bytes, page.map(|_| file)))
        })
        .await??;
        self.file = file;
        Ok(Some(bytes))
    }
}

impl File {
    /// The bytes of a page, or of the end.
    fn write(&mut self, page: Option<&[Cycle]>) -> Result<Vec<u8>, ExportError> {
        match (self, page) {
            (Self::Csv { begun }, page) => {
                let head = (!std::mem::replace(begun, true)).then(csv::header);
                let rows = page.map(csv::rows);
                let text: String = head.into_iter().chain(rows).collect();
                Ok(text.into_bytes())
            }
            (Self::Mcap(recorder), Some(cycles)) => recorder.write(cycles),
            (Self::Mcap(recorder), None) => recorder.finish(),
        }
    }
}

#[cfg(test)]
mod tests;
