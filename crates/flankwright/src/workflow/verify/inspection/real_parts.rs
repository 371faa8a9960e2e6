//! Block `real_parts`: measured gears whose files lie outside the repository. Here: what is read of them. A case whose files are absent is
//! noted as not run.

use super::super::expected::Expected;
use super::super::given::{Checked, text};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use crate::exchange::inspection::{
    Characteristic, Inspection, KlingelnbergFile, Statistic, Trace, inspection_of, read_klingelnberg,
};
use crate::geometry::Flank;
use serde_json::Value;

/// Printed values are compared as printed; this is the rounding of reading them.
const PRINTED: f64 = 1e-9;

/// Block `real_parts`; an empty list is allowed.
pub(in super::super::super) fn real_parts(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let Some(list) = block.as_array() else {
        return ledger.fail("real_parts", "", block.clone(), "a list is needed here".into());
    };
    for item in list {
        let case = item["name"].as_str().unwrap_or("real_parts");
        let mut expected = Expected::new(case, "", item, ledger);
        match opened(reference, &mut expected, ledger) {
            Ok(Some(part)) => {
                for (_, of_trace) in part.traces {
                    of_trace.finish(ledger);
                }
            }
            Ok(None) => continue,
            Err(error) => expected.refused(&error, ledger),
        }
        expected.finish(ledger);
    }
}

/// A part as its files have it, and what is expected of each of its traces.
pub(super) struct RealPart<'a> {
    pub inspection: Inspection,
    /// The quantities under `expected` of each trace are not asked for yet.
    pub traces: Vec<(Trace, Expected<'a>)>,
}

/// Opens the files of a case and checks what was read; `None` and a note if a file is absent.
pub(super) fn opened<'a>(
    reference: &Reference<'_>,
    expected: &mut Expected<'a>,
    ledger: &mut Ledger,
) -> Checked<Option<RealPart<'a>>> {
    expected.informative(&["name", "note"]);
    let names = [text(expected, "file", ledger)?, text(expected, "values_file", ledger)?];
    let mut files: Vec<KlingelnbergFile> = Vec::new();
    for name in names {
        let Some(path) = reference.data_file(name) else {
            let tried = reference.data_paths(name).join(", ");
            ledger.not_run(expected.case(), &format!("{name} is absent; tried: {tried}"));
            return Ok(None);
        };
        files.push(read_klingelnberg(&path)?);
    }
    expected.text("encoding", files[0].encoding.name(), ledger);
    expected.whole("number_of_results", files[1].results.len() as i64, ledger);
    let unknown = files.iter().map(|file| file.unknown_lines.len()).sum::<usize>();
    ledger.equal(expected.case(), "lines not understood", 0.into(), unknown.into());
    let inspection = inspection_of(&[(names[0], &files[0]), (names[1], &files[1])])?;
    if let Some(mut printed) = expected.object("printed", ledger) {
        whole_gear(&inspection, &mut printed, ledger);
        printed.finish(ledger);
    }
    let traces = expected.objects("traces", ledger).into_iter();
    let traces = traces.map(|item| of_trace(&inspection, item, ledger)).collect::<Checked<_>>()?;
    Ok(Some(RealPart { inspection, traces }))
}

/// The trace that an item names; its printed values must stand in the file of values.
fn of_trace<'a>(
    inspection: &Inspection,
    mut item: Expected<'a>,
    ledger: &mut Ledger,
) -> Checked<(Trace, Expected<'a>)> {
    let kind = text(&mut item, "kind", ledger)?;
    let tag = text(&mut item, "tag", ledger)?;
    let flank = item.given_flank(ledger).ok_or("flank is missing")?;
    let tooth = item.take("tooth").and_then(Value::as_u64).ok_or("tooth is missing")?;
    let is_it =
        |t: &&Trace| t.kind.name() == kind && u64::from(t.tooth) == tooth && t.tag == tag && t.flank == flank;
    let trace = inspection.traces.iter().find(is_it).cloned();
    let trace =
        trace.ok_or_else(|| format!("the file has no {kind} of tooth {tooth}{tag}, {flank} flank"))?;
    if let Some(mut printed) = item.object("printed_um", ledger) {
        let helix = kind == "helix";
        for (key, of_helix, of_profile) in [
            ("fH", Characteristic::HelixSlope, Characteristic::ProfileSlope),
            ("F", Characteristic::HelixTotal, Characteristic::ProfileTotal),
            ("ff", Characteristic::HelixForm, Characteristic::ProfileForm),
            ("fKo", Characteristic::TipRelief, Characteristic::TipRelief),
        ] {
            let Some(wanted) = printed.peek(key).and_then(Value::as_f64) else { continue };
            let characteristic = if helix { of_helix } else { of_profile };
            // Codes count the measured teeth and do not name them: one of them must have the value.
            let values = inspection.results.iter().filter(|q| {
                q.meaning.characteristic == characteristic
                    && q.meaning.flank == Some(flank)
                    && matches!(q.meaning.statistic, Statistic::Tooth(_))
            });
            let nearest = values
                .filter_map(|q| q.value)
                .min_by(|a, b| (a - wanted).abs().total_cmp(&(b - wanted).abs()));
            printed.number(key, nearest.unwrap_or(f64::NAN), PRINTED, ledger);
        }
        printed.finish(ledger);
    }
    Ok((trace, item))
}

/// Printed values of the whole gear: pairs left and right, or one number.
fn whole_gear(inspection: &Inspection, printed: &mut Expected<'_>, ledger: &mut Ledger) {
    let of = |characteristic: Characteristic, flank: Option<Flank>, statistic: Statistic| {
        let found = inspection.results.iter().find(|q| {
            let m = q.meaning;
            (m.characteristic, m.flank, m.statistic) == (characteristic, flank, statistic)
        });
        found.and_then(|q| q.value).unwrap_or(f64::NAN)
    };
    for (key, characteristic) in [
        ("fp", Characteristic::SinglePitch),
        ("fu", Characteristic::AdjacentPitch),
        ("Rp", Characteristic::PitchRange),
        ("Fp", Characteristic::CumulativePitch),
        ("Fpk", Characteristic::SectorPitch),
    ] {
        let both = Flank::BOTH.map(|flank| of(characteristic, Some(flank), Statistic::Gear));
        printed.list(key, &both, PRINTED, ledger);
    }
    for (key, characteristic, statistic) in [
        ("Fr", Characteristic::RunOut, Statistic::Gear),
        ("Rs", Characteristic::ThicknessRange, Statistic::Gear),
        ("MdK", Characteristic::OverBalls, Statistic::Mean),
        ("Wk", Characteristic::Span, Statistic::Mean),
    ] {
        printed.number(key, of(characteristic, None, statistic), PRINTED, ledger);
    }
}
