//! `team`.

fn main() -> std::process::ExitCode {
    server::program::run()
}
