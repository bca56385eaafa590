//! Finding and reading the recordings of a task.

use std::path::{Path, PathBuf};

use learning::{Demonstration, read};

use super::CliError;

/// Reads every .json and .csv file directly in `folder`, in the order people
/// count: `take_2` before `take_10`.
pub fn demonstrations(folder: &Path) -> Result<Vec<Demonstration>, CliError> {
    let mut files: Vec<PathBuf> = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(CliError::file(folder))? {
        let path = entry.map_err(CliError::file(folder))?.path();
        let kind = path.extension().and_then(|e| e.to_str());
        if path.is_file() && matches!(kind, Some("json" | "csv")) {
            files.push(path);
        }
    }
    files.sort_by_key(|path| natural_key(&name_of(path)));
    if files.is_empty() {
        return Err(CliError::NoRecordings {
            path: folder.display().to_string(),
        });
    }
    files
        .iter()
        .map(|path| {
            let bytes = std::fs::read(path).map_err(CliError::file(path))?;
            let text = String::from_utf8_lossy(&bytes);
            Ok(read::from_str(&name_of(path), &text)?)
        })
        .collect()
}

/// Name of the task: that of its folder.
pub fn task_name(folder: &Path) -> String {
    folder
        .canonicalize()
        .ok()
        .as_deref()
        .unwrap_or(folder)
        .file_name()
        .map_or_else(|| "task".into(), |name| name.to_string_lossy().into_owned())
}

fn name_of(path: &Path) -> String {
    path.file_name()
        .map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

/// Text and numbers of a name apart, so that numbers compare as numbers.
fn natural_key(name: &str) -> Vec<(u64, String)> {
    let mut key = Vec::new();
    let mut rest = name;
    while !rest.is_empty() {
        let digits = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        if digits > 0 {
            key.push((rest[..digits].parse().unwrap_or(u64::MAX), String::new()));
            rest = &rest[digits..];
        } else {
            let end = rest
                .find(|c: char| c.is_ascii_digit())
                .unwrap_or(rest.len());
            key.push((0, rest[..end].to_string()));
            rest = &rest[end..];
        }
    }
    key
}

#[cfg(test)]
mod tests {
    use super::natural_key;

    #[test]
    fn numbers_in_names_are_counted_as_people_do() {
        let mut names = ["take_10.json", "take_2.json", "take_1.csv", "a.json"];
        names.sort_by_key(|name| natural_key(name));
        assert_eq!(
            names,
            ["a.json", "take_1.csv", "take_2.json", "take_10.json"]
        );
    }
}
