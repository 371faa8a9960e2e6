//! Bundled files: machines and examples.

use std::borrow::Cow;

use rust_embed::RustEmbed;

/// Machine descriptions.
#[derive(RustEmbed)]
#[folder = "../../machines"]
#[include = "*.toml"]
struct Machines;

/// Example jobs and the files that they name.
#[derive(RustEmbed)]
#[folder = "../../examples"]
#[include = "*.toml"]
#[include = "*.csv"]
#[include = "*.jsonl"]
struct Examples;

fn text(data: Cow<'static, [u8]>) -> Option<String> {
    String::from_utf8(data.into_owned()).ok()
}

/// Names of all machines, in order.
pub fn machines() -> Vec<String> {
    let mut names: Vec<String> = Machines::iter().map(Cow::into_owned).collect();
    names.sort();
    names
}

/// The description of a machine.
pub fn machine(name: &str) -> Option<String> {
    text(Machines::get(name)?.data)
}

/// Paths of all files of the examples, in order.
pub fn examples() -> Vec<String> {
    let mut names: Vec<String> = Examples::iter().map(Cow::into_owned).collect();
    names.sort();
    names
}

/// The text of an example.
pub fn example(path: &str) -> Option<String> {
    text(Examples::get(path)?.data)
}
