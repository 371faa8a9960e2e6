//! Adds a measurement to a history. The file is written anew and renamed, so that no reader sees half of it; two programs that add at the
//! same time may lose one of the two lines.

use std::collections::HashMap;
use std::path::Path;

use super::order::CODE;
use super::read::{History, parse_history, read_history};
use super::time::Moment;
use super::{HistoryRecord, RecordedFlank};
use job::{Diagnostic, JobError, MAXIMUM_BYTES, Problem, Source, write_atomically};

/// Adds a measurement at the end of a history (made if missing) and returns the whole. One that is there already, the same in all but the
/// version of the program, is left as it is.
///
/// # Errors
/// Those of [`read_history`]; `invalid-history` for another measurement of the same tool and time or one against the order,
/// `invalid-number`, `file-too-large`, `unwritable-file`. The file stays as it was.
pub fn append_history(path: &Path, record: &HistoryRecord) -> Result<History, JobError> {
    let name = path.display().to_string();
    let there = std::fs::symlink_metadata(path).is_ok();
    let history = if there { read_history(path)? } else { parse_history(Source::new(name.as_str(), ""))? };
    let (longer, added) = extend_history(&history, std::slice::from_ref(record))?;
    if added.is_empty() {
        return Ok(history);
    }
    let text = longer.source().text();
    if text.len() > MAXIMUM_BYTES {
        let finding =
            Diagnostic::new(Problem::FileTooLarge, format!("`{name}` would become too large for a history"))
                .value(format!("{} bytes", text.len()))
                .allowed(format!("at most {MAXIMUM_BYTES} bytes (4 MiB)"))
                .way_out("begin a new history for further measurements, best when the tool is resharpened");
        return Err(JobError::single(history.source().clone(), finding));
    }
    write_atomically(path, text.as_bytes()).map_err(|error| {
        let message = format!("the history `{name}` cannot be written: {error}");
        let finding = Diagnostic::with_code("unwritable-file", message)
            .way_out("check the path and the permissions of its directory");
        JobError::single(history.source().clone(), finding)
    })?;
    Ok(longer)
}

/// A history with further measurements behind it, and those of them that are new: the others are there already, the same in all but
/// the version of the program. Writes nothing.
///
/// # Errors
/// `invalid-history` for another measurement of the same tool and time or one against the order, `invalid-number`.
pub fn extend_history<'a>(
    history: &History,
    records: &'a [HistoryRecord],
) -> Result<(History, Vec<&'a HistoryRecord>), JobError> {
    let refuse = |finding| Err(JobError::single(history.source().clone(), finding));
    let mut there: HashMap<(&str, Option<Moment>), &HistoryRecord> =
        history.records().iter().map(|record| (place(record), record)).collect();
    let mut text = history.source().text().to_owned();
    if !text.is_empty() && !text.ends_with('\n') {
        text.push('\n');
    }
    let kept = text.len();
    let mut added = Vec::new();
    for record in records {
        if let Some(finding) = not_finite(record) {
            return refuse(finding);
        }
        match there.get(&place(record)) {
            Some(old) if same_measurement(old, record) => continue,
            Some(_) => return refuse(taken(record)),
            None => _ = there.insert(place(record), record),
        }
        match serde_json::to_string(record) {
            Ok(line) => text += &(line + "\n"),
            Err(error) => {
                let message = format!("the record cannot be written as JSON: {error}");
                let finding =
                    Diagnostic::new(Problem::InvalidJson, message).way_out("report this with the job");
                return refuse(finding);
            }
        }
        added.push(record);
    }
    let longer = parse_history(Source::new(history.source().name(), &text)).map_err(|mut error| {
        // The new lines are not in the file: they have no place.
        for finding in &mut error.diagnostics {
            finding.span = finding.span.take().filter(|span| span.start < kept);
        }
        JobError { source: history.source().clone(), ..error }
    })?;
    Ok((longer, added))
}

fn taken(record: &HistoryRecord) -> Diagnostic {
    Diagnostic::with_code(
        CODE,
        format!("the history has another measurement of the tool `{}` at this time", record.tool),
    )
    .field("time")
    .value(&record.time)
    .allowed("a time of its own for every measurement of a tool")
    .way_out("give the time of this measurement, or delete the line of the old one if it was wrong")
}

/// Of two measurements in one place, one is wrong or both are the same.
fn place(record: &HistoryRecord) -> (&str, Option<Moment>) {
    (&record.tool, Moment::parse(&record.time))
}

/// The same numbers; version and spelling of the time do not count.
fn same_measurement(old: &HistoryRecord, new: &HistoryRecord) -> bool {
    *old == HistoryRecord { version: old.version.clone(), time: old.time.clone(), ..new.clone() }
}

/// JSON has no word for what is not finite.
fn not_finite(record: &HistoryRecord) -> Option<Diagnostic> {
    let flank = |name: &str, of: &RecordedFlank| {
        let mut numbers = vec![(format!("flanks.{name}.sigma_um"), of.sigma_um)];
        let mut list = |key: &str, values: &[f64]| {
            numbers.extend(values.iter().enumerate().map(|(i, v)| (format!("flanks.{name}.{key}[{i}]"), *v)));
        };
        list("places", &of.places);
        list("track_mean_um", &of.track_mean_um);
        numbers
    };
    let mut numbers = flank("left", &record.flanks.left);
    numbers.extend(flank("right", &record.flanks.right));
    let of_mounting = [
        ("parts", record.parts),
        ("pitch.total_um", record.pitch.total_um),
        ("pitch.largest_single_um", record.pitch.largest_single_um),
        ("mounting.eccentricity_um[0]", record.mounting.eccentricity_um[0]),
        ("mounting.eccentricity_um[1]", record.mounting.eccentricity_um[1]),
        ("mounting.wobble_urad[0]", record.mounting.wobble_urad[0]),
        ("mounting.wobble_urad[1]", record.mounting.wobble_urad[1]),
    ];
    numbers.extend(of_mounting.map(|(field, value)| (field.to_owned(), value)));
    let (field, value) = numbers.into_iter().find(|(_, value)| !value.is_finite())?;
    Some(
        Diagnostic::new(Problem::InvalidNumber, format!("`{field}` = {value} is not a finite number"))
            .field(field)
            .value(value)
            .allowed("a finite number")
            .way_out("measure the tool again; a number like this is no result"),
    )
}
