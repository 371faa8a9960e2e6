//! The command `flankwright`.

fn main() {}
