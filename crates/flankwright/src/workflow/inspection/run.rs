//! `inspect` of a measured gear: its files, the evaluation, the result.

use super::evaluate::{EvaluatedGear, evaluate_inspection};
use super::printed::printed;
use super::result::{
    ClassResult, GearInspectionResult, LinesResult, PitchInspectionResult, SummaryResult, ThicknessResult,
    TraceInspectionResult,
};
use crate::exchange::Diagnostic;
use crate::exchange::inspection::{
    Inspection, InspectionError, KlingelnbergFile, Section, inspection_of, read_klingelnberg,
};
use crate::geometry::Flank;
use crate::metrology::inspection::{SlopeSign, TeethSummary};
use crate::workflow::finding::{Remark, RunFailure};
use crate::workflow::result::Status;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Everything that is known of a measured gear.
pub struct GearInspection {
    /// The document of `result.json`.
    pub result: GearInspectionResult,
    /// What was read.
    pub inspection: Inspection,
    /// Its evaluation.
    pub gear: EvaluatedGear,
}

/// Endings of curves and of values; the files of a part have one stem.
const ENDINGS: [&str; 2] = ["mka", "mew"];

/// Reads a measurement, and the file beside it that holds the curves to its values or the values to its curves, and evaluates it.
///
/// # Errors
/// [`RunFailure`]: a file that is no measurement, a header that makes no gear. What single traces lack is told by warnings.
pub fn inspect_gear(path: &Path) -> Result<GearInspection, RunFailure> {
    let mut timing = BTreeMap::new();
    let begun = Instant::now();
    let paths = parts_of(path);
    let files = paths
        .iter()
        .map(|path| read_klingelnberg(path).map_err(|error| refused(path, &error)))
        .collect::<Result<Vec<KlingelnbergFile>, RunFailure>>()?;
    let names: Vec<String> = paths.iter().map(|path| path.display().to_string()).collect();
    let named: Vec<(&str, &KlingelnbergFile)> = names.iter().map(String::as_str).zip(&files).collect();
    let inspection = inspection_of(&named).map_err(|error| refused(path, &error))?;
    timing.insert("reading", begun.elapsed().as_secs_f64());

    let begun = Instant::now();
    let gear = evaluate_inspection(&inspection).map_err(|error| refused(path, &error))?;
    timing.insert("evaluation", begun.elapsed().as_secs_f64());
    let result = result(path, &named, &inspection, &gear, timing);
    Ok(GearInspection { result, inspection, gear })
}

/// The file and the one of the same stem with the other ending, if it is there.
fn parts_of(path: &Path) -> Vec<PathBuf> {
    let ending = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
    let other = ENDINGS.into_iter().find(|other| {
        ENDINGS.iter().any(|own| own.eq_ignore_ascii_case(ending)) && !other.eq_ignore_ascii_case(ending)
    });
    let spelled =
        |other: &str| if ending == ending.to_uppercase() { other.to_uppercase() } else { other.to_owned() };
    let beside = other.map(|other| path.with_extension(spelled(other))).filter(|path| path.is_file());
    [Some(path.to_owned()), beside].into_iter().flatten().collect()
}

fn refused(path: &Path, error: &InspectionError) -> RunFailure {
    let message = match error {
        InspectionError::Unreadable { .. } => error.to_string(),
        _ => format!("{}: {error}", path.display()),
    };
    RunFailure::bad_input(Diagnostic::with_code(error.code(), message).way_out(error.way_out()))
}

fn result(
    path: &Path,
    files: &[(&str, &KlingelnbergFile)],
    inspection: &Inspection,
    gear: &EvaluatedGear,
    timing_s: BTreeMap<&'static str, f64>,
) -> GearInspectionResult {
    let stem = path.file_stem().map_or_else(|| "part".into(), |stem| stem.to_string_lossy().into_owned());
    let head = [
        ("part", &inspection.part),
        ("name", &inspection.name),
        ("drawing", &inspection.drawing),
        ("date", &inspection.date),
        ("machine", &inspection.machine),
    ];
    let printed = printed(inspection, gear);
    let difference = printed.iter().map(|p| (p.printed_um - p.evaluated_um).abs()).fold(0.0, f64::max);
    let pitch = gear.pitch.as_ref();
    let eccentric = pitch.and_then(|p| p.eccentricity.as_ref());
    GearInspectionResult {
        job: stem,
        process: "inspection",
        version: env!("CARGO_PKG_VERSION"),
        status: Status::Met,
        files: files.iter().map(|(name, _)| (*name).to_owned()).collect(),
        head: head.into_iter().filter_map(|(key, text)| Some((key, text.clone()?))).collect(),
        warnings: warnings(inspection, gear),
        not_understood: files.iter().flat_map(|(name, file)| not_understood(name, file)).collect(),
        section: match inspection.conditions.section {
            Section::Transverse => "transverse",
            Section::Normal => "normal",
        },
        traces: gear.traces.iter().map(|one| trace(inspection, one)).collect(),
        summary: summary(inspection, gear),
        pitch: Flank::BOTH
            .into_iter()
            .filter_map(|flank| Some((flank.name(), of_pitch(gear, flank)?)))
            .collect(),
        thickness_variation_um: pitch.and_then(|p| p.thickness_variation).map(|mm| 1e3 * mm),
        run_out_um: pitch.and_then(|p| p.run_out.as_ref()).map(|r| 1e3 * r.total),
        eccentricity: eccentric.map(|e| [1e3 * e.amount(), e.direction().to_degrees()]),
        pitch_without_eccentricity_um: eccentric.map(|e| {
            let total = e.total_without();
            [1e3 * total.left, 1e3 * total.right]
        }),
        thickness: ThicknessResult {
            x_from_span: gear.thickness.by_span,
            x_from_balls: gear.thickness.by_balls,
        },
        classes: gear
            .classes
            .iter()
            .flat_map(|classes| &classes.each)
            .zip(&gear.judged)
            .map(|((quantity, class), (_, value))| ClassResult {
                quantity: quantity.symbol(),
                value_um: 1e3 * value,
                class: *class,
            })
            .collect(),
        class: gear.classes.as_ref().and_then(|classes| classes.overall),
        printed,
        printed_difference_um: difference,
        timing_s,
    }
}

fn warnings(inspection: &Inspection, gear: &EvaluatedGear) -> Vec<Remark> {
    let read = inspection.warnings.iter().map(|warning| Remark {
        code: warning.kind.code(),
        text: warning.line.map_or_else(String::new, |line| format!("line {line}: ")) + &warning.message,
        way_out: "look at the file, or measure again".into(),
    });
    let left_out = gear.left_out.iter().map(|(what, error)| Remark {
        code: error.code(),
        text: format!("{what}: not evaluated, {error}"),
        way_out: error.way_out().into(),
    });
    let doubts = [
        gear.thickness.warning.as_ref(),
        gear.pitch.as_ref().and_then(|pitch| pitch.run_out.as_ref()?.warning.as_ref()),
    ];
    let doubts = doubts.into_iter().flatten().map(|warning| Remark {
        code: warning.code(),
        text: warning.to_string(),
        way_out: "compare with the drawing and with another measurement".into(),
    });
    read.chain(left_out).chain(doubts).collect()
}

fn not_understood(name: &str, file: &KlingelnbergFile) -> Vec<LinesResult> {
    let line = |unknown: &crate::exchange::inspection::UnknownLine| LinesResult {
        file: name.into(),
        line: unknown.line,
        text: unknown.text.clone(),
    };
    file.unknown_lines.iter().map(line).collect()
}

fn trace(inspection: &Inspection, one: &super::evaluate::EvaluatedTrace) -> TraceInspectionResult {
    let (trace, e) = (&inspection.traces[one.trace], &one.evaluation);
    TraceInspectionResult {
        kind: trace.kind.name(),
        tooth: trace.tooth,
        flank: trace.flank.name(),
        tag: trace.tag.clone(),
        position_mm: trace.position_mm,
        range_mm: [e.range.from(), e.range.to()],
        samples: [e.samples, e.undefined],
        slope_um: 1e3 * e.slope.printed(),
        slope_material_um: 1e3 * e.slope.material(),
        slope_length_mm: e.slope.length,
        slope_sign: match e.slope.rule.sign {
            SlopeSign::Material => "material rises along the trace",
            SlopeSign::Din => "the flank turns right-handed",
            SlopeSign::Custom(_) => "as the file states",
        },
        total_um: 1e3 * e.total,
        form_um: 1e3 * e.form,
        crowning_um: 1e3 * e.crowning.height,
        tip_relief_um: one.tip_relief.as_ref().map(|relief| 1e3 * relief.amount),
    }
}

/// Mean and range over the teeth of every line that was measured on several.
fn summary(inspection: &Inspection, gear: &EvaluatedGear) -> Vec<SummaryResult> {
    let mut lines: BTreeMap<(&'static str, &'static str, String), Vec<TraceInspectionResult>> =
        BTreeMap::new();
    for one in &gear.traces {
        let of = trace(inspection, one);
        lines.entry((of.kind, of.flank, of.tag.clone())).or_default().push(of);
    }
    let mut rows = Vec::new();
    for ((kind, flank, tag), traces) in lines {
        let of = |value: fn(&TraceInspectionResult) -> Option<f64>| {
            traces.iter().filter_map(value).collect::<Vec<f64>>()
        };
        for (characteristic, values) in [
            ("fH", of(|t| Some(t.slope_um))),
            ("F", of(|t| Some(t.total_um))),
            ("ff", of(|t| Some(t.form_um))),
            ("C", of(|t| Some(t.crowning_um))),
            ("fKo", of(|t| t.tip_relief_um)),
        ] {
            let Ok(found) = TeethSummary::of(&values) else { continue };
            rows.push(SummaryResult {
                kind,
                flank,
                tag: tag.clone(),
                characteristic,
                teeth: found.teeth,
                mean_um: found.mean,
                range_um: found.range(),
            });
        }
    }
    rows
}

fn of_pitch(gear: &EvaluatedGear, flank: Flank) -> Option<PitchInspectionResult> {
    let p = gear.pitch.as_ref()?.flanks[flank].as_ref()?;
    Some(PitchInspectionResult {
        single_um: 1e3 * p.single,
        neighbours_um: 1e3 * p.neighbours,
        range_um: 1e3 * p.single_range,
        total_um: 1e3 * p.total,
        sector_um: 1e3 * p.sector,
        sector_pitches: p.sector_pitches,
        cumulative_um: p.cumulative.iter().map(|mm| 1e3 * mm).collect(),
    })
}
