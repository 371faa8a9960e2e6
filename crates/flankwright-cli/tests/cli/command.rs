//! Runs the built command.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::Value;

/// The directory of the repository.
pub fn repository() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().expect("the repository")
}

/// What a run of the command gave.
#[derive(Debug)]
pub struct Run {
    pub exit: Option<i32>,
    pub stdout: String,
    pub stderr: String,
}

impl Run {
    /// Standard output as one JSON document.
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.stdout).unwrap_or_else(|e| panic!("{e}: {self:?}"))
    }

    /// Standard error with all white space and drawn frames as single blanks, since long lines are wrapped.
    pub fn message(&self) -> String {
        self.stderr.split_whitespace().filter(|w| *w != "│").collect::<Vec<_>>().join(" ")
    }
}

/// Runs the command in the repository with the input on standard input.
pub fn run_with(arguments: &[&str], input: &[u8]) -> Run {
    let mut child = Command::new(env!("CARGO_BIN_EXE_flankwright"))
        .args(arguments)
        .current_dir(repository())
        .env_remove("RUST_BACKTRACE")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    // A command that refuses its input early closes the pipe; its answer is what counts.
    let _ = child.stdin.take().expect("standard input").write_all(input);
    let Output { status, stdout, stderr } = child.wait_with_output().expect("the command ends");
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8 output");
    Run { exit: status.code(), stdout: text(stdout), stderr: text(stderr) }
}

/// Runs the command without input.
pub fn run(arguments: &[&str]) -> Run {
    run_with(arguments, b"")
}

/// `check --json` of a text as a file with this name.
pub fn check(name: &str, bytes: &[u8]) -> (Run, Run) {
    let directory = tempfile::tempdir().expect("a temporary directory");
    let path = directory.path().join(name);
    std::fs::write(&path, bytes).expect("a written job");
    let path = path.to_str().expect("a plain path");
    (run(&["check", path]), run(&["check", "--json", path]))
}

/// The text of an example job, without its machine: the description stands beside the example, not beside copies of it.
pub fn example(name: &str) -> String {
    let text = std::fs::read_to_string(repository().join("examples").join(name)).expect("an example");
    let Some(from) = text.find("[machine]\n") else { return text };
    let to = text[from..].find("\n\n").map_or(text.len(), |length| from + length + 2);
    text[..from].to_owned() + &text[to..]
}

/// A text with replacements, each of something that stands in it.
pub fn replaced(text: String, replacements: &[(&str, &str)]) -> String {
    replacements.iter().fold(text, |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    })
}

/// A text with replacements as the job of a directory; the path of its file.
pub fn write_job(directory: &Path, text: String, replacements: &[(&str, &str)]) -> String {
    let path = directory.join("job.toml");
    std::fs::write(&path, replaced(text, replacements)).expect("a file");
    path.to_str().expect("a path of UTF-8").to_owned()
}

/// `plan --json` of a text with replacements, written into `out` of a directory.
pub fn plan_in(directory: &Path, text: String, replacements: &[(&str, &str)]) -> Run {
    let path = write_job(directory, text, replacements);
    let output = directory.join("out");
    run(&["plan", &path, "-o", output.to_str().expect("a plain path"), "--json"])
}

/// The largest value of a figure over the flanks of a result.
pub fn largest(result: &Value, key: &str) -> f64 {
    let flanks = result["flanks"].as_object().expect("flanks");
    assert!(!flanks.is_empty());
    flanks.values().map(|flank| flank[key].as_f64().expect(key)).fold(0.0, f64::max)
}
