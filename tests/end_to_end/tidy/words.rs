//! What the server says to people is English in its sources, and the web app says it in other
//! languages by catalogues (ADR 0032). Here every sentence of the sources is looked up in each of
//! them, and every entry of theirs in the sources.

mod literals;

use std::collections::BTreeMap;

use super::{Tracked, none, tracked};
use literals::{Literal, literals};

/// Where sentences for people are made.
const SPEAKERS: [&str; 5] = [
    "server/src/",
    "server/crates/learning/src/",
    "server/crates/motion/src/",
    "server/crates/robot/src/",
    "server/crates/rws/src/",
];

/// Where the catalogues are: a folder for each language.
const CATALOGUES: &str = "webapp/src/words/";
const LANGUAGES: [&str; 3] = ["de", "fr", "it"];

/// Sources whose words no phone ever shows, and where they are read instead.
const NOT_FOR_PHONES: [(&str, &str); 12] = [
    ("server/src/announce.rs", "the terminal: that it is ready"),
    ("server/src/app.rs", "the terminal: why it does not start"),
    ("server/src/cell/", "the terminal: the configuration file"),
    ("server/src/cli", "the terminal: its commands"),
    ("server/src/config.rs", "the terminal: --help"),
    ("server/src/http/assets.rs", "browsers: headers"),
    ("server/src/http/headers.rs", "browsers: headers"),
    ("server/src/program.rs", "the terminal"),
    (
        "server/crates/learning/src/model.rs",
        "the terminal: model files made by hand",
    ),
    (
        "server/crates/learning/src/regression.rs",
        "the terminal: model files made by hand",
    ),
    (
        "server/crates/learning/src/write.rs",
        "programs: what the columns of a file are",
    ),
    (
        "server/crates/rws/src/tls.rs",
        "the terminal: the doctor reads a certificate",
    ),
];

/// Single literals that no phone shows: to be found by how they begin, with where they are read instead.
const EXCEPTIONS: [(&str, &[&str]); 8] = [
    (
        "the list of who did what",
        &[
            "asked for control",
            "changed the speed of a motion",
            "discarded a demonstration",
            "gave control away",
            "kept a demonstration",
            "kept control",
            "let a motion go on",
            "made the arm s",
            "paired {",
            "paused a motion",
            "released control",
            "reset a signal",
            "said that a motion",
            "set a signal",
            "this computer",
            "took a decision about a demonstration back",
        ],
    ),
    (
        "the log; a phone hears that something went wrong inside the server",
        &[
            "called off",
            "the MCAP file",
            "comparing the takes broke off",
            "reading broke off",
            "reading the file broke off",
            "a route is not behind the guard",
            "a time out of range",
            "nobody was there any more",
            "the connection ended",
            "the controller closed the connection",
            "the file could not be worked out",
            "the robot is gone",
            "the session ended",
            "the stored model can't be read",
            "the training broke off with a program error",
            "the way back could not be worked out",
        ],
    ),
    (
        "programs; the app asks for nothing of the kind",
        &[
            "The key must be",
            "The stretch ends",
            "Choose an end after",
            "max_points must be",
            "points must be",
            "{field} must be a number of seconds",
            "The request names no host",
        ],
    ),
    (
        "browsers: headers",
        &[
            "text/csv;",
            "inline; filename",
            "private, max-age",
            "attachment; filename",
            "; Secure",
            "{}={}; Path=/",
        ],
    ),
    (
        "the database: changes of its tables, and its keys",
        &[
            "the database could not be brought up to date",
            "jobs and models",
            "pairing and audit",
            "pictures pauses and trims",
            "positions outcomes questionnaire",
            "tasks and demonstrations",
            "train_model {}",
        ],
    ),
    (
        "the terminal: the configuration file, checked before anything runs",
        &[
            "the configuration file",
            "{}, line {line}",
            "Default User",
            "it must be 64 hexadecimal digits",
            "it must look like https",
            "a certificate is pinned, so",
        ],
    ),
    (
        "the terminal: the certificate authority, looked at before the pages are served",
        &[
            "TEAM's own certificate authority",
            "no certificate could be made",
            "the certificate authority",
            "the key belongs to another certificate",
        ],
    ),
    (
        "inside the words of the JSON reader, which are English",
        &["an object of columns", "the signals do not fit the motion"],
    ),
];

/// Called with what somebody did, for the list of that, which no phone shows.
const LIST: &str = "audit";

/// A literal of one word is a part of a sentence when it is given to one of these...
const FIELDS: [&str; 10] = [
    "what", "WHAT", "wanted", "which", "reason", "label", "on", "off", "state", "mode",
];
/// ... when one of these is called with it...
const CALLS: [&str; 3] = ["judge", "not_found", "resolve"];
/// ... or in the body of one of these: what a state is called.
const BODIES: [(&str, &str); 6] = [
    ("server/crates/robot/src/view.rs", "words"),
    ("server/crates/rws/src/panel.rs", "fmt"),
    ("server/src/store/demonstrations.rs", "words"),
    ("server/src/store/jobs.rs", "words"),
    ("server/src/store/models.rs", "words"),
    ("server/src/store/reproductions.rs", "words"),
];

/// Every sentence and part of one, with where it is said.
fn spoken(files: &[Tracked]) -> BTreeMap<String, String> {
    let mut spoken = BTreeMap::new();
    for file in speakers(files) {
        for literal in literals(&file.text()) {
            let text = literal.text.trim();
            let mut exceptions = EXCEPTIONS.iter().flat_map(|(_, parts)| parts.iter());
            let excepted = exceptions.any(|part| text.starts_with(part));
            if literal.call != LIST
                && !excepted
                && (is_sentence(text) || is_part(&file.path, &literal))
            {
                let place = format!("{}:{}", file.path, literal.line);
                spoken.entry(text.to_owned()).or_insert(place);
            }
        }
    }
    spoken
}

/// The sources that make sentences for phones.
fn speakers(files: &[Tracked]) -> impl Iterator<Item = &Tracked> {
    let elsewhere = |file: &Tracked| {
        let mut folders = NOT_FOR_PHONES.iter().map(|(path, _)| path);
        folders.any(|path| file.path.starts_with(path))
    };
    files.iter().filter(move |file| {
        let speaks = file.has_extension(&["rs"]) && file.is_in(&SPEAKERS);
        speaks && !is_test(file) && !elsewhere(file)
    })
}

fn is_test(file: &Tracked) -> bool {
    let test_files = ["tests.rs", "testing.rs", "properties.rs"];
    file.path.contains("/tests/") || test_files.iter().any(|name| file.path.ends_with(name))
}

/// Words with a space between them, not counting what stands in gaps; and no SQL.
fn is_sentence(text: &str) -> bool {
    let mut in_gap = false;
    let plain: String = text
        .chars()
        .map(|letter| {
            in_gap = letter == '{' || in_gap && letter != '}';
            if in_gap { ' ' } else { letter }
        })
        .collect();
    let sql = ["SELECT ", "INSERT ", "UPDATE ", "DELETE ", "BEGIN "];
    let mut words = plain.split(|letter: char| !letter.is_alphabetic());
    text.contains(' ')
        && !sql.iter().any(|word| text.starts_with(word))
        && words.any(|word| word.len() > 1 && word.chars().any(char::is_lowercase))
}

fn is_part(path: &str, literal: &Literal) -> bool {
    !literal.text.is_empty()
        && literal.text.chars().all(char::is_alphabetic)
        && (FIELDS.contains(&literal.before.as_str())
            || CALLS.contains(&literal.call.as_str())
            || BODIES.contains(&(path, literal.inside.as_str())))
}

/// A language's entries, each with the file it stands in.
fn catalogue(files: &[Tracked], language: &str) -> BTreeMap<String, String> {
    let folder = format!("{CATALOGUES}{language}/");
    let mut entries = BTreeMap::new();
    for file in files {
        if file.is_in(&[&folder]) && file.has_extension(&["json"]) {
            let read: BTreeMap<String, String> =
                serde_json::from_str(&file.text()).unwrap_or_else(|error| {
                    panic!("{}: {error}", file.path);
                });
            entries.extend(read.into_keys().map(|entry| (entry, file.path.clone())));
        }
    }
    entries
}

#[test]
fn whatever_the_server_says_is_said_in_every_language() {
    let files = tracked();
    let spoken = spoken(&files);
    let mut found = Vec::new();
    for language in LANGUAGES {
        let entries = catalogue(&files, language);
        let missing = spoken
            .iter()
            .filter(|(text, _)| !entries.contains_key(*text));
        found.extend(missing.map(|(text, place)| format!("{place}: not in {language}: {text}")));
        let left = entries
            .iter()
            .filter(|(text, _)| !spoken.contains_key(*text));
        found.extend(left.map(|(text, file)| format!("{file}: no source says: {text}")));
    }
    none(
        "translate what is said, and drop what is not said any more; what no phone shows goes into \
         the short lists here",
        &found,
    );
    assert!(spoken.len() > 300, "only {} sentences found", spoken.len());
}

#[test]
fn no_exception_is_left_over() {
    let files = tracked();
    let mut found: Vec<String> = NOT_FOR_PHONES
        .iter()
        .filter(|(path, _)| !files.iter().any(|file| file.path.starts_with(path)))
        .map(|(path, _)| format!("there is no {path}"))
        .collect();
    let said: Vec<String> = speakers(&files)
        .flat_map(|file| literals(&file.text()))
        .map(|literal| literal.text)
        .collect();
    let parts = EXCEPTIONS.iter().flat_map(|(_, parts)| parts.iter());
    let unsaid = parts.filter(|part| !said.iter().any(|text| text.trim().starts_with(**part)));
    found.extend(unsaid.map(|part| format!("nobody says: {part}")));
    none("an exception that is none any more", &found);
}
