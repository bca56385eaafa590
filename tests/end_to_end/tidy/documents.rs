//! Rules on documents: what they point to exists.

use super::{none, root, tracked};

/// Targets of `[text](target)` that are files of the repository, without their anchors.
fn local_links(text: &str) -> Vec<&str> {
    text.split("](")
        .skip(1)
        .filter_map(|rest| rest.split([')', '#']).next())
        .filter(|target| !target.is_empty() && !target.contains("://"))
        .collect()
}

#[test]
fn every_link_between_documents_leads_somewhere() {
    let root = root();
    let mut found = Vec::new();
    for file in tracked().iter().filter(|file| file.has_extension(&["md"])) {
        let folder = root.join(&file.path);
        let folder = folder.parent().unwrap_or(&root);
        for target in local_links(&file.text()) {
            if !folder.join(target).exists() {
                found.push(format!("{}: {target}", file.path));
            }
        }
    }
    none("links that lead nowhere", &found);
}

#[test]
fn every_decision_is_in_the_list() {
    let list = std::fs::read_to_string(root().join("docs/adr/README.md")).expect("the list exists");
    let found: Vec<String> = tracked()
        .iter()
        .filter_map(|file| file.path.strip_prefix("docs/adr/"))
        .filter(|name| *name != "README.md" && !list.contains(&format!("({name})")))
        .map(str::to_owned)
        .collect();
    none("decisions that docs/adr/README.md does not list", &found);
}

#[test]
fn the_readme_names_what_a_newcomer_needs() {
    let readme = std::fs::read_to_string(root().join("README.md")).expect("a README exists");
    let needed = [
        "cargo run --release",
        "cargo test --workspace",
        "not an emergency stop",
    ];
    for words in needed {
        assert!(readme.contains(words), "README.md does not say {words:?}");
    }
}

#[test]
fn migrations_are_numbered_without_gaps() {
    let mut names: Vec<String> = tracked()
        .iter()
        .filter_map(|file| file.path.strip_prefix("migrations/"))
        .filter(|name| name.ends_with(".sql"))
        .map(str::to_owned)
        .collect();
    names.sort();
    assert!(!names.is_empty(), "no migrations");
    for (at, name) in names.iter().enumerate() {
        assert!(
            name.starts_with(&format!("{:04}_", at + 1)),
            "{name} has the wrong number"
        );
    }
}
