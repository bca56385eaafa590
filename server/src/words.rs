//! Errors' words as sentences for people.

/// Words with a capital at the beginning and a full stop at the end. The name of a file at the
/// beginning stays as it is.
pub fn sentence(words: &dyn std::fmt::Display) -> String {
    let words = words.to_string();
    let first = words.split(' ').next().unwrap_or_default();
    let mut letters = words.chars();
    let mut text = String::new();
    if first.chars().all(char::is_alphabetic) {
        text.extend(letters.next().into_iter().flat_map(char::to_uppercase));
    }
    text.push_str(letters.as_str());
    if !text.is_empty() && !text.ends_with(['.', '!', '?']) {
        text.push('.');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_become_a_sentence() {
        assert_eq!(sentence(&"the arm is busy"), "The arm is busy.");
        assert_eq!(sentence(&"Done!"), "Done!");
        assert_eq!(sentence(&""), "");
        assert_eq!(sentence(&"bad.csv: no rows"), "bad.csv: no rows.");
    }
}
