//! From JSON lines to checked records, line by line by the way that job files go: text, tree, shape, types, then their order.

use std::path::Path;
use std::sync::LazyLock;

use serde::Deserialize;
use serde_json::Value;

use super::line::{Line, moved};
use super::time::{FORM, Moment};
use super::{HistoryRecord, order};
use job::shape::{self, Subject};
use job::{Diagnostic, JobError, Problem, Source, json_tree, schema_of};

static SCHEMA: LazyLock<Value> =
    LazyLock::new(|| schema_of::<HistoryRecord>("flankwright history of skiving tools, one line"));

const SUBJECT: Subject = Subject {
    document: "the record",
    example: "a line has tool, time, parts, resharpened, flanks, pitch, mounting, out_of_band, version",
};

/// What helps against a line that is none.
const WAY_OUT: &str =
    "every line is one complete JSON object; correct this line, or delete it if a program left it unfinished";

/// All measurements of a file, in its order.
#[derive(Clone, Debug, PartialEq)]
pub struct History {
    records: Vec<HistoryRecord>,
    source: Source,
}

impl History {
    /// The measurements of all tools, in the order of the file.
    pub fn records(&self) -> &[HistoryRecord] {
        &self.records
    }

    /// Name and text of the file.
    pub fn source(&self) -> &Source {
        &self.source
    }

    /// Measurements of the record's tool since it was last resharpened, up to that record: what a trend is fitted to. Later ones do not
    /// count, so that an old run can be repeated.
    pub fn cycle_until(&self, record: &HistoryRecord) -> Vec<&HistoryRecord> {
        let until = Moment::parse(&record.time);
        let of_cycle = |other: &&HistoryRecord| {
            other.tool == record.tool
                && other.resharpened == record.resharpened
                && Moment::parse(&other.time) <= until
        };
        self.records.iter().filter(of_cycle).collect()
    }
}

/// Reads a history. Empty lines are passed over; a line that is wrong is an error.
///
/// # Errors
/// Those of [`Source::read`]; of every line `invalid-json`, unknown and missing keys, types and ranges; then `invalid-history` for
/// records that contradict each other. Each with line, key and value.
pub fn read_history(path: &Path) -> Result<History, JobError> {
    parse_history(Source::read(path).map_err(|mut error| {
        if !path.exists() {
            for finding in &mut error.diagnostics {
                finding.way_out =
                    Some("check the path; the first measurement that is added makes the file".into());
            }
        }
        error
    })?)
}

/// As [`read_history`], from a text.
///
/// # Errors
/// As [`read_history`].
pub fn parse_history(source: Source) -> Result<History, JobError> {
    let (mut findings, mut lines) = (Vec::new(), Vec::new());
    let mut offset = 0;
    for text in source.text().split_inclusive('\n') {
        let start = offset;
        offset += text.len();
        if text.trim().is_empty() {
            continue;
        }
        match line(text.trim_end(), start) {
            Ok(line) => lines.push(line),
            Err(wrong) => findings.extend(wrong),
        }
        if findings.len() > JobError::MAXIMUM_FINDINGS {
            break;
        }
    }
    if findings.is_empty() {
        findings = order::check(&lines);
    }
    if findings.is_empty() {
        Ok(History { records: lines.into_iter().map(|line| line.record).collect(), source })
    } else {
        Err(JobError::new(source, findings))
    }
}

fn line(text: &str, start: usize) -> Result<Line, Vec<Diagnostic>> {
    let place = |mut finding: Diagnostic| {
        let span = finding.span.take().map_or(start..start + text.len(), |span| moved(&span, start));
        finding.span(Some(span))
    };
    let node = json_tree::parse(text).map_err(|finding| {
        let shown: String = text.chars().take(60).collect();
        let finding = if finding.value.is_none() { finding.value(format!("`{shown}`")) } else { finding };
        vec![place(finding.allowed("one JSON object a line").way_out(WAY_OUT))]
    })?;
    let findings = shape::check(&node, &SCHEMA, &SCHEMA, SUBJECT);
    if !findings.is_empty() {
        return Err(findings.into_iter().map(place).collect());
    }
    // The shape check admits what the types take; the error here is the net below it.
    let record = HistoryRecord::deserialize(node.to_value()).map_err(|error| {
        let message = format!("the record cannot be read: {error}");
        vec![place(Diagnostic::new(Problem::WrongType, message).way_out(WAY_OUT))]
    })?;
    let at = |path: &str| node.follow(path).map(|(node, _)| node.span.clone());
    let Some(moment) = Moment::parse(&record.time) else {
        let finding = Diagnostic::new(Problem::UnknownValue, "`time` is no date with time and zone")
            .field("time")
            .value(&record.time)
            .allowed(FORM)
            .way_out("write the time of the measurement in this form")
            .span(at("time"));
        return Err(vec![place(finding)]);
    };
    for (name, of) in [("left", &record.flanks.left), ("right", &record.flanks.right)] {
        let (means, places) = (of.track_mean_um.len(), of.places.len());
        if means != places {
            let path = format!("flanks.{name}.track_mean_um");
            let finding = Diagnostic::new(
                Problem::InvalidList,
                format!("`{path}` has {means} entries, `flanks.{name}.places` has {places}"),
            )
            .value(means)
            .allowed(format!("{places} entries, one for each place"))
            .way_out("give one mean for each track")
            .span(at(&path))
            .field(path);
            return Err(vec![place(finding)]);
        }
    }
    Ok(Line { record, moment, node, start })
}
