//! Reading demonstrations from text: the recordings of the paper (JSON, 18
//! columns), this program's own JSON, and CSV. No file is opened here.

mod csv;
mod json;

use crate::{Demonstration, Error};

pub use csv::from_csv_str;
pub use json::{FORMAT, from_json_str};

/// Reads a demonstration in whichever of the known formats the text is.
///
/// Errors: [`Error::Unreadable`] when it is none of them, else what
/// [`Demonstration::new`] refuses.
pub fn from_str(name: &str, text: &str) -> Result<Demonstration, Error> {
    match text.trim_start().chars().next() {
        None => Err(Error::Unreadable {
            name: name.into(),
            reason: "the file is empty".into(),
        }),
        Some('{' | '[') => from_json_str(name, text),
        Some(_) => from_csv_str(name, text),
    }
}
