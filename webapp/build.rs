//! Builds the phone app with npm and Vite, and writes the list of its files for `lib.rs`.
//!
//! Everything happens on a copy inside OUT_DIR: two builds with different target folders do not
//! meet, the source folder may be read-only, and a developer's own `node_modules` is left alone.
//! `WEBAPP_SKIP=1` embeds a one-line page instead, for work on the Rust side without Node.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

/// What the build reads, relative to this crate. Tests and tools of the developer are not in it.
const SOURCES: [&str; 8] = [
    "compress.mjs",
    "src",
    "index.html",
    "package.json",
    "package-lock.json",
    "tsconfig.json",
    "vite.config.ts",
    "vite.worker.ts",
];

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("\nThe phone app could not be built: {message}\n");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), String> {
    let source = PathBuf::from(variable("CARGO_MANIFEST_DIR")?);
    let out = PathBuf::from(variable("OUT_DIR")?);
    for name in SOURCES {
        println!("cargo::rerun-if-changed={name}");
    }
    println!("cargo::rerun-if-changed=../static");
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=WEBAPP_SKIP");

    let dist = out.join("dist");
    if dist.exists() {
        fs::remove_dir_all(&dist).map_err(|error| describe(&dist, &error))?;
    }
    if std::env::var("WEBAPP_SKIP").is_ok_and(|value| value == "1") {
        fs::create_dir_all(&dist).map_err(|error| describe(&dist, &error))?;
        let page = "<!doctype html><title>TEAM</title><p>Built with WEBAPP_SKIP=1: no app inside.";
        fs::write(dist.join("index.html"), page).map_err(|error| describe(&dist, &error))?;
    } else {
        build(&source, &out, &dist)?;
    }
    write_list(&dist, &out.join("files.rs"))
}

fn build(source: &Path, out: &Path, dist: &Path) -> Result<(), String> {
    let copy = out.join("webapp");
    for name in SOURCES {
        replace(&source.join(name), &copy.join(name))?;
    }
    replace(&source.join("../static"), &out.join("static"))?;
    install(&copy)?;
    let vite = copy.join("node_modules/vite/bin/vite.js");
    let mut command = Command::new("node");
    command
        .arg(vite)
        .args(["build", "--logLevel", "warn", "--outDir"])
        .arg(dist);
    execute(command.current_dir(&copy))?;
    let mut command = Command::new("node");
    execute(command.arg("compress.mjs").arg(dist).current_dir(&copy))
}

/// Runs `npm ci` when the lock file is not the one that the installed packages came from.
fn install(copy: &Path) -> Result<(), String> {
    let stamp = copy.join("node_modules/.installed-lock");
    let lock_file = copy.join("package-lock.json");
    let lock = fs::read(&lock_file).map_err(|error| describe(&lock_file, &error))?;
    if fs::read(&stamp).is_ok_and(|installed| installed == lock) {
        return Ok(());
    }
    let npm = if cfg!(windows) { "npm.cmd" } else { "npm" };
    let mut command = Command::new(npm);
    command.args([
        "ci",
        "--omit=dev",
        "--prefer-offline",
        "--no-audit",
        "--no-fund",
    ]);
    execute(command.current_dir(copy))?;
    fs::write(&stamp, lock).map_err(|error| describe(&stamp, &error))
}

/// Runs a tool; its output is shown only when it fails.
fn execute(command: &mut Command) -> Result<(), String> {
    let what = format!("{command:?}");
    let output = command.output().map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => format!(
            "{:?} was not found. Install Node.js 20.19 or newer (with npm), \
             or set WEBAPP_SKIP=1 to build the server without the app.",
            command.get_program()
        ),
        _ => format!("{what} did not start: {error}"),
    })?;
    if output.status.success() {
        return Ok(());
    }
    Err(format!(
        "{what} ended with {}\n{}{}",
        output.status,
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr)
    ))
}

/// Puts a fresh copy of a file or folder in the place of an older one.
fn replace(from: &Path, to: &Path) -> Result<(), String> {
    if to.is_dir() {
        fs::remove_dir_all(to).map_err(|error| describe(to, &error))?;
    }
    copy_all(from, to).map_err(|error| describe(from, &error))
}

fn copy_all(from: &Path, to: &Path) -> io::Result<()> {
    if !from.is_dir() {
        if let Some(folder) = to.parent() {
            fs::create_dir_all(folder)?;
        }
        // Content only: a read-only source file must not make the copy read-only.
        return fs::write(to, fs::read(from)?);
    }
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        copy_all(&entry.path(), &to.join(entry.file_name()))?;
    }
    Ok(())
}

fn write_list(dist: &Path, list: &Path) -> Result<(), String> {
    let mut files = BTreeMap::new();
    collect(dist, "", &mut files).map_err(|error| describe(dist, &error))?;
    let mut code = String::from("static FILES: &[File] = &[\n");
    for (name, path) in &files {
        if packed(name).is_some_and(|plain| files.contains_key(plain)) {
            continue;
        }
        let packed = |ending| match files.get(&format!("{name}.{ending}")) {
            Some(path) => format!("Some(include_bytes!({path:?}))"),
            None => "None".to_owned(),
        };
        // Writing into a String cannot fail.
        let _ = writeln!(
            code,
            "    File {{ name: {name:?}, plain: include_bytes!({path:?}), brotli: {}, gzip: {} }},",
            packed("br"),
            packed("gz")
        );
    }
    code.push_str("];\n");
    fs::write(list, code).map_err(|error| describe(list, &error))
}

/// The name of the file that this one is a compressed copy of.
fn packed(name: &str) -> Option<&str> {
    name.strip_suffix(".br").or(name.strip_suffix(".gz"))
}

fn collect(folder: &Path, prefix: &str, files: &mut BTreeMap<String, PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            collect(&entry.path(), &format!("{name}/"), files)?;
        } else {
            files.insert(name, entry.path());
        }
    }
    Ok(())
}

fn variable(name: &str) -> Result<String, String> {
    std::env::var(name).map_err(|error| format!("{name}: {error}"))
}

fn describe(path: &Path, error: &io::Error) -> String {
    format!("{}: {error}", path.display())
}
