//! Rules on program text and on what kinds of files there are.

use super::{Tracked, none, tracked};

/// Lines of program text (not of this folder, which has to name what it forbids) that contain one
/// of the words, outside the places where they are at home.
fn lines_with(
    files: &[Tracked],
    extensions: &[&str],
    words: &[&str],
    at_home: &[&str],
) -> Vec<String> {
    let mut found = Vec::new();
    for file in files {
        if !file.has_extension(extensions)
            || file.is_in(at_home)
            || file.is_in(&["tests/end_to_end/tidy"])
        {
            continue;
        }
        for (number, line) in file.text().lines().enumerate() {
            if words.iter().any(|word| contains_word(line, word)) {
                found.push(format!("{}:{}: {}", file.path, number + 1, line.trim()));
            }
        }
    }
    found
}

/// Whether the word stands in the line with no letter, digit or underscore touching it. An end of
/// the word that is itself a sign may touch anything.
fn contains_word(line: &str, word: &str) -> bool {
    let part = |c: char| c.is_alphanumeric() || c == '_';
    let open = |end: Option<char>, neighbour: Option<char>| {
        !(end.is_some_and(part) && neighbour.is_some_and(part))
    };
    line.match_indices(word).any(|(at, _)| {
        open(word.chars().next(), line[..at].chars().next_back())
            && open(
                word.chars().next_back(),
                line[at + word.len()..].chars().next(),
            )
    })
}

#[test]
fn sql_is_written_in_the_store_only() {
    let words = [
        "SELECT",
        "INSERT INTO",
        "DELETE FROM",
        "CREATE TABLE",
        "PRAGMA",
        "sqlx::",
    ];
    let found = lines_with(&tracked(), &["rs"], &words, &["server/src/store/"]);
    none("SQL belongs into server/src/store and migrations", &found);
}

#[test]
fn http_is_served_from_two_folders_only() {
    let at_home = [
        "server/src/http/",
        "server/crates/virtual_controller/src/rws",
        // The client's tests answer it from a script.
        "server/crates/rws/tests/",
    ];
    let found = lines_with(&tracked(), &["rs"], &["axum"], &at_home);
    none(
        "axum belongs into server/src/http and the virtual controller's rws",
        &found,
    );
}

#[test]
fn protobuf_is_spoken_in_egm_only() {
    let found = lines_with(&tracked(), &["rs"], &["prost"], &["server/crates/egm/"]);
    none("prost belongs into egm", &found);
}

#[test]
fn radians_live_in_kinematics_only() {
    let words = [
        "to_radians",
        "to_degrees",
        "PI / 180",
        "180 / Math.PI",
        "Radians",
    ];
    // Drawing libraries count in radians too.
    let at_home = ["server/crates/motion/src/kinematics", "webapp/src/arm3d/"];
    let mut files = tracked();
    // A test may write down a closed form in the way its source does.
    files.retain(|file| !file.path.ends_with("tests.rs"));
    let found = lines_with(&files, &["rs", "ts", "tsx"], &words, &at_home);
    none("angles are degrees outside kinematics and pictures", &found);
}

#[test]
fn the_core_knows_no_clock_and_no_chance() {
    let words = [
        "SystemTime",
        "Instant::now",
        "rand::rng",
        "thread_rng",
        "std::fs",
        "UdpSocket",
        "TcpStream",
    ];
    let core = [
        "server/crates/motion/src/",
        "server/crates/learning/src/",
        "server/crates/egm/src/",
    ];
    let files: Vec<Tracked> = tracked()
        .into_iter()
        .filter(|file| file.is_in(&core))
        .collect();
    none(
        "motion, learning and egm are pure",
        &lines_with(&files, &["rs"], &words, &[]),
    );
}

#[test]
fn nothing_is_left_for_later() {
    let words = [
        "TODO",
        "FIXME",
        "XXX",
        "todo!",
        "unimplemented!",
        "dbg!",
        "#[ignore",
    ];
    let more = [
        "test.only",
        "test.skip",
        "it.only",
        "it.skip",
        "describe.only",
        "describe.skip",
    ];
    let kinds = ["rs", "ts", "tsx", "css", "html", "sql", "toml", "sh"];
    let found = lines_with(&tracked(), &kinds, &[&words[..], &more[..]].concat(), &[]);
    none("finish it or leave it out", &found);
}

#[test]
fn tests_wait_for_conditions_and_never_sleep() {
    let words = ["thread::sleep", "time::sleep", "waitForTimeout"];
    let mut found = Vec::new();
    for file in tracked() {
        let test_file = file.is_in(&["tests/"])
            || file.path.contains("/tests")
            || file.path.contains(".test.")
            || file.path.contains(".spec.");
        let text = file.text();
        let tests_begin = if test_file {
            Some(0)
        } else {
            text.find("#[cfg(test)]")
        };
        let Some(tests_begin) = tests_begin else {
            continue;
        };
        let only_tests = Tracked {
            path: file.path,
            bytes: text[tests_begin..].into(),
        };
        found.extend(lines_with(
            &[only_tests],
            &["rs", "ts", "tsx", "js", "mjs"],
            &words,
            &[],
        ));
    }
    none("wait for the condition instead", &found);
}

#[test]
fn every_module_says_what_lives_in_it() {
    let found: Vec<String> = tracked()
        .iter()
        .filter(|file| file.has_extension(&["rs"]) && !file.text().starts_with("//! "))
        .map(|file| file.path.clone())
        .collect();
    none("a module begins with a //! header", &found);
}

#[test]
fn files_stay_short() {
    let mut found = Vec::new();
    for file in tracked() {
        let lines = file.text().lines().count();
        if file.has_extension(&["rs", "ts", "tsx", "css", "sql"]) && lines > 450 {
            found.push(format!("{}: {lines} lines", file.path));
        }
    }
    none("split what is longer than 450 lines", &found);
}

#[test]
fn nobodys_machine_is_in_the_sources() {
    let words = ["/home/", "/root/", "/Users/"];
    let kinds = [
        "rs", "ts", "tsx", "toml", "sh", "md", "json", "service", "html",
    ];
    none(
        "paths of one machine do not belong here",
        &lines_with(&tracked(), &kinds, &words, &[]),
    );
}

#[test]
fn only_sources_are_in_the_repository() {
    let binaries = [
        "zip", "gz", "tgz", "xz", "zst", "7z", "so", "dll", "exe", "o", "a", "wasm", "jar", "pdf",
        "woff", "woff2", "ttf", "otf", "eot", "min.js", "onnx", "pt", "npy", "npz", "pkl", "mcap",
        "parquet", "sqlite", "db", "proto", "stl", "dae", "map",
    ];
    let mut found = Vec::new();
    for file in tracked() {
        let generated = ["node_modules", "dist", "target"]
            .iter()
            .any(|folder| file.path.split('/').any(|part| part == *folder));
        if generated || file.has_extension(&binaries) {
            found.push(format!("{}: not a source file", file.path));
        }
        if file.bytes.len() > 500_000 {
            found.push(format!("{}: {} bytes", file.path, file.bytes.len()));
        }
        // The published recordings may not be redistributed; this is how their files begin to look.
        if file.has_extension(&["json", "csv"]) && file.text().contains("\"tcp_q1\"") {
            found.push(format!("{}: looks like a published recording", file.path));
        }
    }
    none("no bundles, binaries, fonts, models or recordings", &found);
}
