//! Internal faults are reported in two lines instead of a stack of frames.

use std::panic;

/// Replaces the panic message by a short one. `RUST_BACKTRACE=1` brings the frames back.
pub fn report_briefly() {
    let detailed = panic::take_hook();
    panic::set_hook(Box::new(move |fault| {
        if std::env::var_os("RUST_BACKTRACE").is_some_and(|value| value != "0") {
            return detailed(fault);
        }
        let what = fault.payload_as_str().unwrap_or("unknown fault");
        let place = fault.location().map_or_else(String::new, |l| format!(" ({}:{})", l.file(), l.line()));
        eprintln!("internal error: {what}{place}");
    }));
}
