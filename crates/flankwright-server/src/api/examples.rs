//! Starting points of a job: examples, templates, machines.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use axum::Json;
use flankwright::exchange::{Document, Source, job_template};
use flankwright::processes;
use serde_json::Value;

use super::error::{Answer, Refused};
use super::take::InPath;
use crate::stock;
use crate::wire::{ExampleAnswer, ExampleSummary, Job, MachineSummary, TemplateAnswer};

static EXAMPLES: LazyLock<Vec<ExampleSummary>> = LazyLock::new(|| {
    let jobs = stock::examples().into_iter().filter_map(|path| summary(&path));
    let mut jobs: Vec<ExampleSummary> = jobs.collect();
    // The way in stands first, then one process after the other.
    jobs.sort_by_key(|job| {
        (order(&job.process), job.id != FIRST, job.id.matches('/').count(), job.id.clone())
    });
    jobs
});

/// The example of the README.
const FIRST: &str = "twist-free-crowning";

fn order(process: &str) -> usize {
    processes().all().position(|known| known.name() == process).unwrap_or(usize::MAX)
}

fn tree(path: &str, text: &str) -> Option<Value> {
    Document::parse(Source::new(path, text)).ok().map(|document| document.to_value())
}

/// A job among the files; tables and catalogues are none.
fn summary(path: &str) -> Option<ExampleSummary> {
    let id = path.strip_suffix(".toml")?;
    let tree = tree(path, &stock::example(path)?)?;
    let info = tree.get("job")?;
    let word = |key: &str| info.get(key).and_then(Value::as_str).map(str::to_owned);
    Some(ExampleSummary {
        id: id.to_owned(),
        name: word("name")?,
        process: word("process")?,
        description: word("description"),
    })
}

/// Examples.
#[utoipa::path(get, path = "/api/examples", operation_id = "examples", responses((status = 200, body = [ExampleSummary])))]
pub async fn list() -> Json<&'static [ExampleSummary]> {
    Json(&EXAMPLES)
}

/// An example with the files that it names.
#[utoipa::path(get, path = "/api/examples/{id}", operation_id = "example",
    params(("id" = String, Path, description = "as in the list")),
    responses((status = 200, body = Job), (status = 404, body = crate::wire::Failure)))]
pub async fn one(InPath(id): InPath<String>) -> Answer<Json<ExampleAnswer>> {
    let path = format!("{id}.toml");
    let text = stock::example(&path).filter(|_| EXAMPLES.iter().any(|job| job.id == id));
    let text = text.ok_or_else(|| Refused::absent("example"))?;
    let mut files = BTreeMap::new();
    if let Some(tree) = tree(&path, &text) {
        named(&tree, &path, &mut files);
    }
    Ok(Json(Job { text, files }))
}

/// Files of the examples that a job names, by the names that it uses.
fn named(value: &Value, job: &str, files: &mut BTreeMap<String, String>) {
    match value {
        Value::String(name) => {
            let beside =
                job.rsplit_once('/').map_or_else(|| name.clone(), |(folder, _)| format!("{folder}/{name}"));
            if let Some(text) = stock::example(&beside) {
                files.insert(name.clone(), text);
            }
        }
        Value::Array(items) => items.iter().for_each(|item| named(item, job, files)),
        Value::Object(keys) => keys.values().for_each(|value| named(value, job, files)),
        _ => {}
    }
}

/// A commented job of a process.
#[utoipa::path(get, path = "/api/templates/{process}", params(("process" = String, Path, description = "its word in a job")),
    responses((status = 200, body = TemplateAnswer), (status = 404, body = crate::wire::Failure)))]
pub async fn template(InPath(process): InPath<String>) -> Answer<Json<TemplateAnswer>> {
    let text = job_template(&process).ok_or_else(|| Refused::absent("process"))?;
    Ok(Json(TemplateAnswer { text }))
}

static MACHINES: LazyLock<Vec<MachineSummary>> = LazyLock::new(|| {
    let one = |file: String| {
        let tree = tree(&file, &stock::machine(&file)?)?;
        let word = |key: &str| tree.get(key).and_then(Value::as_str).map(str::to_owned);
        Some(MachineSummary {
            name: word("name")?,
            description: word("about"),
            file: format!("machines/{file}"),
        })
    };
    stock::machines().into_iter().filter_map(one).collect()
});

/// Machines that jobs may name.
#[utoipa::path(get, path = "/api/machines", responses((status = 200, body = [MachineSummary])))]
pub async fn machines() -> Json<&'static [MachineSummary]> {
    Json(&MACHINES)
}
