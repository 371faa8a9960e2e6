//! The command `flankwright`.

fn main() -> std::process::ExitCode {
    flankwright_cli::run()
}
