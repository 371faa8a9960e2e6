//! Block `real_parts`: measured gears whose files lie outside the repository: what is read of them, what the library evaluates from that,
//! and what the measuring machine printed beside it. A case whose files are absent is noted as not run.

mod allowed;
mod gear;
mod printed;
mod traces;

use super::super::expected::Expected;
use super::super::given::{Checked, text};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use allowed::Allowed;
use flankwright::workflow::inspection::{EvaluatedGear, evaluate_inspection};
use measured_files::inspection::{Inspection, KlingelnbergFile, inspection_of, read_klingelnberg};
use serde_json::Value;

/// Block `real_parts`; an empty list is allowed.
pub(crate) fn real_parts(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let Some(list) = block.as_array() else {
        return ledger.fail("real_parts", "", block.clone(), "a list is needed here".into());
    };
    for item in list {
        let case = item["name"].as_str().unwrap_or("real_parts");
        let mut expected = Expected::new(case, "", item, ledger);
        expected.informative(&["name", "note"]);
        let outcome = match opened(reference, &mut expected, ledger) {
            Ok(Some(inspection)) => compare(&inspection, &mut expected, ledger),
            // Nothing is known of what else the case expects.
            Ok(None) => continue,
            Err(error) => Err(error),
        };
        if let Err(error) = outcome {
            expected.refused(&error, ledger);
        }
        expected.finish(ledger);
    }
}

/// Reads the files of a case and checks how they were read; `None` and a note if a file is absent.
fn opened(
    reference: &Reference<'_>,
    expected: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked<Option<Inspection>> {
    let mut names = vec![text(expected, "file", ledger)?];
    if expected.peek("values_file").is_some() {
        names.push(text(expected, "values_file", ledger)?);
    }
    let mut files: Vec<KlingelnbergFile> = Vec::new();
    for name in &names {
        let Some(path) = reference.data_file(name) else {
            let tried = reference.data_paths(name).join(", ");
            ledger.not_run(expected.case(), &format!("{name} is absent; tried: {tried}"));
            return Ok(None);
        };
        files.push(read_klingelnberg(&path)?);
    }
    expected.text("encoding", files[0].encoding.name(), ledger);
    expected.whole(
        "number_of_results",
        files.iter().map(|file| file.results.len()).sum::<usize>() as i64,
        ledger,
    );
    let unknown = files.iter().map(|file| file.unknown_lines.len()).sum::<usize>();
    ledger.equal(expected.case(), "lines not understood", 0.into(), unknown.into());
    let named: Vec<(&str, &KlingelnbergFile)> = names.into_iter().zip(&files).collect();
    Ok(Some(inspection_of(&named)?))
}

/// Compares what is evaluated from the files with what is expected and with what the machine printed.
fn compare(inspection: &Inspection, expected: &mut Expected<'_>, ledger: &mut Ledger) -> Checked {
    let allowed = Allowed::take(expected, ledger)?;
    let found = evaluate_inspection(inspection, None)?;
    if let Some((what, error)) = found.left_out.0.first() {
        return Err(format!("{what}: {error}").into());
    }
    gear::compare(inspection, &found, &allowed, expected, ledger);
    if let Some(mut printed) = expected.object("printed", ledger) {
        printed::of_gear(inspection, &found, &allowed, &mut printed, ledger);
        printed.finish(ledger);
    }
    for mut item in expected.objects("traces", ledger) {
        if let Err(error) = traces::compare(inspection, &found, &allowed, &mut item, ledger) {
            item.refused(&error, ledger);
        }
        item.finish(ledger);
    }
    Ok(())
}

#[cfg(test)]
mod tests;
