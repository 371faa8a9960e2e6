//! What a record must be before it is stored. Texts have bounds, numbers are finite, nothing stands twice.

use std::collections::HashSet;

use flankwright::exchange::Diagnostic;
use flankwright::exchange::inspection::{SORTABLE_DATE, is_sortable_date};
use flankwright::exchange::rexs::MAXIMUM_FILE_BYTES;
use serde_json::Value;

use crate::content::PartContent;
use crate::records::{CharacteristicValue, PartRecord, PlanRecord};

/// Characters of a name, a unit, a version.
const SHORT: usize = 200;
/// Characters of a file name.
const LONG: usize = 4096;
/// Characteristics of a part: all values of single teeth of a gear with some thousand teeth.
const CHARACTERISTICS: usize = 100_000;

/// Everything that a part must be.
pub(crate) fn part(place: usize, part: &PartRecord) -> Result<(), Diagnostic> {
    let at = |key: &str| format!("parts[{place}].{key}");
    text(&at("series"), &part.series, SHORT)?;
    text(&at("part"), &part.part, SHORT)?;
    for (key, value) in [("drawing", &part.drawing), ("machine", &part.machine)] {
        if let Some(value) = value {
            text(&at(key), value, SHORT)?;
        }
    }
    text(&at("source"), &part.source, LONG)?;
    digest(&at("digest"), &part.digest)?;
    if let Some(value) = &part.date
        && !is_sortable_date(value)
    {
        return Err(invalid(&at("date"), "is no date of this form")
            .value(format!("{value:?}"))
            .allowed(SORTABLE_DATE)
            .way_out("write the date in this form, or leave it out"));
    }
    let count = part.characteristics.len();
    if count > CHARACTERISTICS {
        return Err(invalid(&at("characteristics"), "has too many entries")
            .value(count)
            .allowed(format!("at most {CHARACTERISTICS}"))
            .way_out("keep the characteristics that a series is evaluated from"));
    }
    document(&at("document"), &part.document)?;
    let mut seen = HashSet::with_capacity(count);
    for (i, entry) in part.characteristics.iter().enumerate() {
        let at = format!("{}[{i}]", at("characteristics"));
        characteristic(&at, entry)?;
        if !seen.insert((&entry.name, entry.flank, entry.tooth, &entry.statistic, &entry.unit)) {
            return Err(invalid(&at, "stands twice")
                .value(format!("{} {}", entry.name, entry.statistic))
                .allowed("each name with its flank, tooth, statistic and unit once")
                .way_out("give the part one value of each characteristic"));
        }
    }
    Ok(())
}

/// Everything that the files of a part must be; `digest` is that of the part.
pub(crate) fn content(at: &str, content: &PartContent, digest: &str) -> Result<(), Diagnostic> {
    if content.packed().is_empty() {
        return Err(invalid(at, "has no file")
            .value(0)
            .allowed("the files of one measurement")
            .way_out("give the files that the part was measured by"));
    }
    for (k, file) in content.packed().iter().enumerate() {
        text(&format!("{at}.files[{k}].name"), &file.name, LONG)?;
        if file.size > MAXIMUM_FILE_BYTES as u64 {
            return Err(invalid(&format!("{at}.files[{k}]"), "is too large")
                .value(format!("{} bytes", file.size))
                .allowed(format!("at most {MAXIMUM_FILE_BYTES} bytes"))
                .way_out("give the file of one part"));
        }
    }
    if content.digest() != digest {
        return Err(invalid(at, "is that of another part")
            .value(content.digest())
            .allowed(format!("files with the digest {digest}"))
            .way_out("give the files that the part was evaluated from"));
    }
    Ok(())
}

fn characteristic(at: &str, entry: &CharacteristicValue) -> Result<(), Diagnostic> {
    text(&format!("{at}.name"), &entry.name, SHORT)?;
    text(&format!("{at}.statistic"), &entry.statistic, SHORT)?;
    text(&format!("{at}.unit"), &entry.unit, SHORT)?;
    let numbers = [
        ("value", Some(entry.value)),
        ("lower_limit", entry.lower_limit),
        ("upper_limit", entry.upper_limit),
    ];
    for (key, number) in numbers {
        if let Some(number) = number.filter(|number| !number.is_finite()) {
            return Err(invalid(&format!("{at}.{key}"), "is not finite")
                .value(number)
                .allowed("a finite number")
                .way_out("leave out what was not measured"));
        }
    }
    if let (Some(lower), Some(upper)) = (entry.lower_limit, entry.upper_limit)
        && lower > upper
    {
        return Err(invalid(&format!("{at}.lower_limit"), "is above the upper limit")
            .value(lower)
            .allowed(format!("<= upper_limit = {upper}"))
            .way_out("exchange the limits"));
    }
    Ok(())
}

/// Everything that a plan must be.
pub(crate) fn plan(plan: &PlanRecord) -> Result<(), Diagnostic> {
    text("job", &plan.job, SHORT)?;
    digest("digest", &plan.digest)?;
    text("status", &plan.status, SHORT)?;
    text("version", &plan.version, SHORT)?;
    document("document", &plan.document)
}

/// Without the character NUL, which PostgreSQL does not take: a store has to move from one database to the other.
fn document(field: &str, value: &Value) -> Result<(), Diagnostic> {
    let has_nul = match value {
        Value::String(text) => text.contains('\0'),
        Value::Array(entries) => return entries.iter().try_for_each(|entry| document(field, entry)),
        Value::Object(entries) => {
            entries.values().try_for_each(|entry| document(field, entry))?;
            entries.keys().any(|key| key.contains('\0'))
        }
        _ => false,
    };
    if has_nul {
        return Err(invalid(field, "has a character NUL")
            .value("\\u0000")
            .allowed("texts without it")
            .way_out("take the character out of the file"));
    }
    Ok(())
}

fn invalid(field: &str, what: &str) -> Diagnostic {
    Diagnostic::with_code("invalid-record", format!("`{field}` {what}")).field(field)
}

/// Neither empty nor too long, and without control characters, of which databases do not take all.
fn text(field: &str, value: &str, most: usize) -> Result<(), Diagnostic> {
    let count = value.chars().count();
    if value.trim().is_empty() || count > most || value.chars().any(char::is_control) {
        return Err(invalid(field, "is no text of one line")
            .value(format!("{:?} ({count} characters)", value.chars().take(40).collect::<String>()))
            .allowed(format!("1 to {most} characters, no line ends"))
            .way_out("give a short name"));
    }
    Ok(())
}

fn digest(field: &str, value: &str) -> Result<(), Diagnostic> {
    if value.len() != 64 || !value.bytes().all(|b| matches!(b, b'0'..=b'9' | b'a'..=b'f')) {
        return Err(invalid(field, "is no SHA-256 digest")
            .value(format!("{:?}", value.chars().take(80).collect::<String>()))
            .allowed("64 hexadecimal digits in lower case")
            .way_out("make it of the bytes of the file"));
    }
    Ok(())
}
