//! Walks of jobs that lie in files: for processes whose keys no few jobs give. The first line of a file says the command that runs it
//! and, behind it, the tables whose keys are walked there; `# then:` in the second line does the same for the settings that it writes.
//! `inspect-measured` is `inspect` with a measured file, which the job itself simulates before.

use super::{changed, head_of_report, key, keys_of_schema, leaves, others, without};
use crate::command::{Run, repository, run, run_with};
use flankwright::exchange::{Document, Source};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::Arc;
use tempfile::TempDir;

/// Refusals of a value before anything is made of it. They do not show that a key does anything.
const OF_FORM: [&str; 7] = [
    "invalid-number",
    "wrong-type",
    "unknown-value",
    "unknown-key",
    "missing-key",
    "invalid-list",
    "invalid-job",
];

/// The keys of a process, and how they are walked.
pub(super) struct FileWalk {
    /// Name of the type in the schema.
    pub definition: &'static str,
    /// Folder of the jobs, beside this file.
    pub folder: &'static str,
    /// Keys that change nothing, each with the reason.
    pub exceptions: &'static [(&'static str, &'static str)],
    /// Values to try for a key before those that follow from its type.
    pub values: Vec<(&'static str, Value)>,
    /// Keys of results that repeat the job.
    pub echoes: &'static [&'static str],
}

/// A job, how it is run, and the tables whose keys are walked in it; all of them for none.
struct Walked {
    name: String,
    command: String,
    tables: Vec<String>,
    job: Value,
    /// The measured gear that the command reads.
    measured: Option<Arc<TempDir>>,
}

/// The command that reads a measured gear, and the file in which the job's own simulation writes it.
const WITH_MEASURED: &str = "inspect-measured";
const MEASURED: &str = "measured-1.csv";

/// What a run gave without what repeats the job.
#[derive(PartialEq)]
struct Outcome {
    result: Value,
    tables: BTreeMap<String, Vec<u8>>,
}

impl Walked {
    /// Has the job simulate the measured gear that its command reads, if it reads one.
    fn measure(&mut self) {
        if self.command != WITH_MEASURED {
            return;
        }
        let directory = tempfile::tempdir().unwrap();
        let out = directory.path().to_str().unwrap();
        let answer =
            run_with(&["inspect", "--job", "-", "--json", "-o", out], self.job.to_string().as_bytes());
        assert!(directory.path().join(MEASURED).is_file(), "{}: {answer:?}", self.name);
        self.measured = Some(Arc::new(directory));
    }

    /// Runs a job as its file says.
    fn run(&self, job: &Value, out: &str) -> Run {
        let input = job.to_string();
        let measured = self.measured.as_ref().map(|of| of.path().join(MEASURED).display().to_string());
        let mut arguments = match (self.command.as_str(), &measured) {
            (WITH_MEASURED, Some(file)) => vec!["inspect", file, "--job", "-"],
            ("inspect", _) => vec!["inspect", "--job", "-"],
            (command, _) => vec![command, "-"],
        };
        arguments.extend(["--json", "-o", out]);
        run_with(&arguments, input.as_bytes())
    }
}

/// A command that is run behind the first, with the tables that it reads.
type Then = (String, Vec<String>);

impl FileWalk {
    /// Walks the keys; gives those that change nothing, and those that no job gives.
    pub fn run(&self) -> (BTreeSet<String>, BTreeSet<String>) {
        let schema = run(&["schema"]).json();
        let mut known = BTreeSet::new();
        keys_of_schema(&schema, &schema["$defs"][self.definition], "", &mut known);
        for (name, reason) in self.exceptions {
            assert!(known.contains(*name) && !reason.is_empty(), "{name} is no key, or has no reason");
        }
        let excepted = |key: &str| self.exceptions.iter().any(|(name, _)| *name == key);
        let (mut counted, mut ignored) = (BTreeSet::new(), BTreeSet::new());
        let mut jobs = self.jobs();
        jobs.reverse();
        while let Some((mut walked, then)) = jobs.pop() {
            walked.measure();
            let (before, settings) =
                self.outcome(&walked).unwrap_or_else(|why| panic!("{}: {why}", walked.name));
            assert!(before.result.is_object(), "{}: {}", walked.name, before.result);
            if let (Some((command, tables)), Some(job)) = (then, settings) {
                let name = format!("{} and then {command}", walked.name);
                jobs.push((Walked { name, command, tables, job, measured: None }, None));
            }
            let mut paths = Vec::new();
            leaves(&walked.job, &mut Vec::new(), &mut paths);
            let mut lists = BTreeSet::new();
            paths.retain(|path| {
                let key = schema_key(path, &known);
                let here = walked.tables.is_empty()
                    || walked
                        .tables
                        .iter()
                        .any(|table| key == *table || key.starts_with(&format!("{table}.")));
                // Of numbers in a list the first speaks for all.
                let is_word =
                    walked.job.pointer(&format!("/{}", path.join("/"))).is_some_and(Value::is_string);
                let in_list = path.last().is_some_and(|last| last.parse::<usize>().is_ok()) && !is_word;
                here && !excepted(&key)
                    && !counted.contains(&key)
                    && (!in_list || lists.insert(self::key(path)))
            });
            let counts = |path: &Vec<String>| self.counts(&walked, &before, path, &known);
            let counts = &counts;
            let found: Vec<bool> = std::thread::scope(|scope| {
                let threads: Vec<_> = (0..2)
                    .map(|k| {
                        let mine = paths.iter().skip(k).step_by(2);
                        scope.spawn(move || mine.map(counts).collect::<Vec<_>>())
                    })
                    .collect();
                let mut found: Vec<_> = threads.into_iter().map(|t| t.join().unwrap().into_iter()).collect();
                (0..paths.len()).map(|i| found[i % 2].next().unwrap()).collect()
            });
            for (path, counts) in paths.iter().zip(&found) {
                if *counts {
                    counted.insert(schema_key(path, &known));
                }
            }
            for (path, counts) in paths.iter().zip(&found) {
                if !counts && !counted.contains(&schema_key(path, &known)) {
                    ignored.insert(format!("{}: {}", walked.name, path.join(".")));
                }
            }
        }
        // A key that does nothing beside one thing may count beside another.
        ignored.retain(|entry| {
            let path: Vec<String> =
                entry.rsplit(": ").next().unwrap().split('.').map(str::to_owned).collect();
            !counted.contains(&schema_key(&path, &known))
        });
        known.retain(|key| !excepted(key) && !counted.contains(key));
        known.retain(|key| !ignored.iter().any(|entry| entry.contains(key.as_str())));
        (ignored, known)
    }

    fn counts(&self, walked: &Walked, before: &Outcome, path: &[String], known: &BTreeSet<String>) -> bool {
        let value = walked.job.pointer(&format!("/{}", path.join("/"))).unwrap();
        let key = schema_key(path, known);
        let own = self.values.iter().filter(|(name, _)| *name == key).map(|(_, value)| value.clone());
        own.chain(others(value)).filter(|other| other != value).any(|other| {
            let job = changed(&walked.job, path, &other);
            let (command, measured) = (walked.command.clone(), walked.measured.clone());
            let other = Walked { job, name: String::new(), tables: Vec::new(), command, measured };
            self.outcome(&other).is_ok_and(|(after, _)| after != *before)
        })
    }

    /// The outcome, and the settings that were written; a refusal in its words.
    fn outcome(&self, walked: &Walked) -> Result<(Outcome, Option<Value>), String> {
        let directory = tempfile::tempdir().unwrap();
        let out = directory.path().to_str().unwrap();
        // A run adds to its history.
        let beside = tempfile::tempdir().unwrap();
        let mut job = walked.job.clone();
        if let Some(file) = job.pointer_mut("/history/file") {
            let own = beside.path().join("history.jsonl");
            std::fs::copy(file.as_str().unwrap(), &own).unwrap();
            *file = Value::from(own.to_str().unwrap());
        }
        let answer = walked.run(&job, out);
        assert!(matches!(answer.exit, Some(0 | 2 | 3 | 4)), "{answer:?}");
        let mut result = answer.json();
        if !result["error"].is_null() {
            let code = result["error"]["code"].as_str().unwrap().to_owned();
            if OF_FORM.contains(&code.as_str()) {
                return Err(result["error"].to_string());
            }
            // Bodies that cannot be, or a limit that is passed: the key was read and decided something.
            return Ok((Outcome { result: Value::String(code), tables: BTreeMap::new() }, None));
        }
        without(&mut result, self.echoes);
        let mut tables = BTreeMap::new();
        let mut settings = None;
        collect(directory.path(), &mut tables, &mut settings);
        tables.extend(head_of_report(directory.path()).map(|head| ("head of the report".to_owned(), head)));
        Ok((Outcome { result, tables }, settings))
    }

    /// The jobs of the folder in the order of their names.
    fn jobs(&self) -> Vec<(Walked, Option<Then>)> {
        let folder = repository().join("crates/flankwright-cli/tests/cli/every_key").join(self.folder);
        let mut paths: Vec<_> =
            std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
        paths.sort();
        let repository = repository().display().to_string();
        let asked = |line: &str| {
            let (command, tables) = line
                .rsplit(": ")
                .next()
                .unwrap()
                .split_once(' ')
                .unwrap_or((line.rsplit(": ").next().unwrap(), ""));
            let tables = tables.split(',').filter(|t| !t.is_empty()).map(str::to_owned).collect();
            (command.to_owned(), tables)
        };
        let read = |path: &Path| {
            let text = std::fs::read_to_string(path).unwrap().replace("REPOSITORY", &repository);
            let mut lines = text.lines();
            let (command, tables) = asked(lines.next().unwrap());
            let then = lines.next().filter(|line| line.starts_with("# then:")).map(asked);
            let name = path.file_name().unwrap().to_str().unwrap().to_owned();
            let document = Document::parse(Source::new(name.as_str(), &text));
            let job = document.unwrap_or_else(|error| panic!("{name}: {error}")).to_value();
            (Walked { name, command, tables, job, measured: None }, then)
        };
        paths.iter().map(|path| read(path)).collect()
    }
}

/// A path as the schema has it: without indices, and down to modifications only.
fn schema_key(path: &[String], known: &BTreeSet<String>) -> String {
    let whole = key(path);
    let mut at = whole.as_str();
    while !known.contains(at) {
        let Some((above, _)) = at.rsplit_once('.') else { return whole };
        at = above;
    }
    at.to_owned()
}

/// All files below a folder but documents and pages, which repeat the job; and the settings.
fn collect(folder: &Path, tables: &mut BTreeMap<String, Vec<u8>>, settings: &mut Option<Value>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(&path, tables, settings);
            continue;
        }
        let (bytes, name) = (std::fs::read(&path).unwrap(), path.file_name().unwrap().to_str().unwrap());
        if name == "settings.json" {
            *settings = Some(serde_json::from_slice(&bytes).unwrap());
        }
        if !name.ends_with(".json") && !name.ends_with(".html") {
            tables.insert(name.to_owned(), bytes);
        }
    }
}
