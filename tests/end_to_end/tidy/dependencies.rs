//! Rules on what crates may depend on, and under which licences.

use std::collections::{HashMap, HashSet};
use std::process::Command;

use serde_json::Value;

use super::{none, root, tracked};

/// What Cargo knows of the workspace on Linux.
fn metadata() -> Value {
    let platform = format!("{}-unknown-linux-gnu", std::env::consts::ARCH);
    let output = Command::new(env!("CARGO"))
        .args([
            "metadata",
            "--format-version",
            "1",
            "--locked",
            "--filter-platform",
            &platform,
        ])
        .current_dir(root())
        .output()
        .expect("cargo can be run");
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    serde_json::from_slice(&output.stdout).expect("cargo metadata is JSON")
}

fn text<'a>(value: &'a Value, key: &str) -> &'a str {
    value[key].as_str().unwrap_or_default()
}

fn list<'a>(value: &'a Value, key: &str) -> impl Iterator<Item = &'a Value> {
    value[key].as_array().into_iter().flatten()
}

/// Names of everything that goes into a crate's library, tests excepted.
fn goes_into(metadata: &Value, krate: &str) -> HashSet<String> {
    let names: HashMap<&str, &str> = list(metadata, "packages")
        .map(|p| (text(p, "id"), text(p, "name")))
        .collect();
    let nodes: HashMap<&str, &Value> = list(&metadata["resolve"], "nodes")
        .map(|node| (text(node, "id"), node))
        .collect();
    let start = names
        .iter()
        .find(|(_, name)| **name == krate)
        .map(|(id, _)| *id);
    let mut open = vec![start.unwrap_or_else(|| panic!("there is no crate {krate}"))];
    let mut seen = HashSet::new();
    while let Some(id) = open.pop() {
        if !seen.insert(id) {
            continue;
        }
        for dependency in list(nodes[id], "deps") {
            // Kind null is an ordinary dependency; the others are "dev" and "build".
            if list(dependency, "dep_kinds").any(|kind| kind["kind"].is_null()) {
                open.push(text(dependency, "pkg"));
            }
        }
    }
    seen.into_iter().map(|id| names[id].to_owned()).collect()
}

#[test]
fn the_core_and_the_robot_cannot_reach_database_or_web_server() {
    let metadata = metadata();
    let io = [
        "tokio", "sqlx", "axum", "reqwest", "hyper", "socket2", "rustix", "server",
    ];
    let database_and_web = [
        "sqlx",
        "sqlx-core",
        "libsqlite3-sys",
        "axum",
        "server",
        "learning",
    ];
    let rules: [(&str, &[&str]); 5] = [
        ("motion", &io),
        ("learning", &io),
        ("egm", &io),
        ("robot", &database_and_web),
        (
            "virtual_controller",
            &["sqlx", "sqlx-core", "server", "learning", "robot"],
        ),
    ];
    let mut found = Vec::new();
    for (krate, forbidden) in rules {
        let inside = goes_into(&metadata, krate);
        for name in forbidden.iter().filter(|name| inside.contains(**name)) {
            found.push(format!("{krate} depends on {name}"));
        }
    }
    none("dependencies in the wrong direction", &found);
}

#[test]
fn every_crate_takes_the_workspace_lints_and_unsafe_is_forbidden() {
    let manifests: Vec<_> = tracked()
        .into_iter()
        .filter(|file| file.path.ends_with("Cargo.toml"))
        .collect();
    for manifest in &manifests {
        let (path, text) = (&manifest.path, manifest.text());
        if path == "Cargo.toml" {
            assert!(
                text.contains("unsafe_code = \"forbid\""),
                "unsafe is not forbidden"
            );
        } else {
            assert!(
                text.contains("[lints]\nworkspace = true"),
                "{path} has its own lints"
            );
        }
    }
    assert!(manifests.len() > 5, "where are the crates?");
}

/// Whether an SPDX expression leaves a choice that a permissive project can take.
fn is_permissive(expression: &str) -> bool {
    let allowed = [
        "MIT",
        "Apache-2.0",
        "BSD-2-Clause",
        "BSD-3-Clause",
        "ISC",
        "Zlib",
        "0BSD",
        "CC0-1.0",
        "Unicode-3.0",
        "Unlicense",
        "BSL-1.0",
        "Apache-2.0 WITH LLVM-exception",
        "MPL-2.0",
    ];
    let plain = expression.replace(['(', ')'], "").replace('/', " OR ");
    // Without brackets AND binds closer than OR, but "(A OR B) AND C" also occurs: then C must be
    // allowed and one of A and B. Both readings hold if every AND part has an allowed choice.
    plain.split(" AND ").all(|part| {
        part.split(" OR ")
            .any(|licence| allowed.contains(&licence.trim()))
    })
}

#[test]
fn every_dependency_may_be_used_under_a_permissive_licence() {
    let metadata = metadata();
    let mut found = Vec::new();
    for package in list(&metadata, "packages") {
        if !is_permissive(text(package, "license")) {
            found.push(format!(
                "{}: {:?}",
                text(package, "name"),
                package["license"]
            ));
        }
    }
    none("licences that need a look", &found);
}
