//! The program `team` under another name, built beside the tests so that they can start and kill it.

fn main() -> std::process::ExitCode {
    server::program::run()
}
