//! The first page: values and classes to ISO 1328-1, the picture of the flanks, pitches, and what the correction asks for.

use super::pictures;
use crate::page::class_table::class_table;
use crate::workflow::{ClassResult, GearInspection, GearInspectionResult, class_in_words};
use foundation::geometry::Flank;
use measured_files::inspection::TraceKind;
use report::cells::NONE;
use report::charts::{
    ChartError, FlankSections, ProfileHelixDiagram, RangeMark, SectionTrace, format_significant,
    profile_helix_diagram,
};
use report::{Figure, FirstPage, Quantity, Sheet, Table};

/// Rows that the page has room for.
const MOST_ROWS: usize = 12;
/// Traces of a kind that a flank has room for.
const MOST_TRACES: usize = 4;

/// # Errors
/// Values that cannot be drawn.
pub(super) fn first_page(found: &GearInspection) -> Result<FirstPage, ChartError> {
    let result = &found.result;
    let of_job = pictures::last_deviation(&result.rounds)?;
    Ok(FirstPage {
        scope: result.verdict.scope_in_short(),
        picture: match of_job {
            Some(picture) => Some(picture),
            None => traces(found)?,
        },
        values: values(result),
        sheets: vec![pitch(result), sizes(result), measurement(result), correction(result)],
    })
}

/// Values with their classes, worst first where they do not all fit.
fn values(result: &GearInspectionResult) -> Option<Table> {
    if result.classes.is_empty() {
        return None;
    }
    let mut shown: Vec<&ClassResult> = Vec::new();
    for one in &result.classes {
        let worse = |other: &ClassResult| worth(one) > worth(other);
        match shown.iter_mut().find(|of| of.quantity == one.quantity && of.flank == one.flank) {
            Some(known) if worse(known) => *known = one,
            Some(_) => {}
            None => shown.push(one),
        }
    }
    if shown.len() > MOST_ROWS {
        shown.sort_by(|a, b| worth(b).partial_cmp(&worth(a)).unwrap_or(std::cmp::Ordering::Equal));
        shown.truncate(MOST_ROWS);
    }
    let note = "The worst value of each characteristic; all of them stand in the details.";
    Some(class_table("ISO 1328-1:2013", shown, result.tolerance_class, note))
}

/// What makes a value worse than another: its class, then its amount.
fn worth(one: &ClassResult) -> (i32, f64) {
    (one.class.unwrap_or(i32::MAX), one.value_um.abs())
}

/// Profiles and helix traces as measured, where no job gives a target to compare with.
fn traces(found: &GearInspection) -> Result<Option<Figure>, ChartError> {
    let of = |flank: Flank, kind: TraceKind| -> Vec<SectionTrace> {
        let all = found.inspection.traces.iter().filter(|trace| trace.flank == flank && trace.kind == kind);
        let one = |trace: &measured_files::inspection::Trace| {
            let mut samples: Vec<(f64, f64)> = trace
                .abscissa_mm
                .iter()
                .zip(&trace.f_um)
                .filter(|(x, f)| x.is_finite() && f.is_finite() && f.abs() < LARGEST_UM)
                .map(|(x, f)| (*x, *f))
                .collect();
            samples.sort_by(|a, b| a.0.total_cmp(&b.0));
            samples.dedup_by(|a, b| a.0 == b.0);
            let (coordinate_mm, simulated_um) = samples.into_iter().unzip();
            SectionTrace {
                position_mm: trace.position_mm,
                coordinate_mm,
                target_um: None,
                simulated_um,
                values_um: Vec::new(),
            }
        };
        all.map(one)
            .filter(|trace| trace.coordinate_mm.len() > 1 && trace.position_mm.is_finite())
            .take(MOST_TRACES)
            .collect()
    };
    let flanks: Vec<FlankSections> = Flank::BOTH
        .into_iter()
        .map(|flank| FlankSections {
            flank,
            profile_marks: marks(found, flank, "profile"),
            helix_marks: marks(found, flank, "helix"),
            profiles: of(flank, TraceKind::Profile),
            helices: of(flank, TraceKind::Helix),
        })
        .filter(|flank| !flank.profiles.is_empty() || !flank.helices.is_empty())
        .collect();
    if flanks.is_empty() {
        return Ok(None);
    }
    let svg = profile_helix_diagram(&ProfileHelixDiagram {
        title: "Measured traces".to_owned(),
        flanks,
        external: found.inspection.gear.teeth > 0,
        target_name: String::new(),
        simulated_name: "measured".to_owned(),
    })?;
    Ok(Some(Figure::new("measured-traces", svg, "")))
}

/// Ends of the ranges in which the traces of a kind were evaluated.
fn marks(found: &GearInspection, flank: Flank, kind: &str) -> Vec<RangeMark> {
    let evaluated = found.result.traces.iter().filter(|t| t.flank == flank.name() && t.kind == kind);
    let ends = evaluated.map(|trace| trace.range_mm).reduce(|[a, b], [c, d]| [a.min(c), b.max(d)]);
    ends.into_iter().flatten().map(|at_mm| RangeMark { at_mm, ends_range: true }).collect()
}

/// Deviations beyond this are no measurement of a tooth, um.
const LARGEST_UM: f64 = 1e7;

fn pitch(result: &GearInspectionResult) -> Sheet {
    let um = |name: &str, symbol: &str, value: f64| Quantity::rounded(name, symbol, value, 2, "µm");
    let mut list = Vec::new();
    for (flank, pitch) in &result.pitch {
        list.push(um(&format!("single pitch deviation, {flank}"), "f_p", pitch.single_um));
        list.push(um(&format!("cumulative pitch deviation, {flank}"), "F_p", pitch.total_um));
    }
    list.extend(result.run_out_um.map(|value| um("run-out from the pitches", "F_r", value)));
    list.extend(
        result.thickness_variation_um.map(|value| um("variation of the tooth thickness", "R_s", value)),
    );
    let sheet = Sheet::new("Pitch and run-out", list);
    if result.pitch.is_empty() { sheet.remark("Pitches were not measured.") } else { sheet }
}

fn sizes(result: &GearInspectionResult) -> Sheet {
    let sizes =
        [("by the span", result.thickness.x_from_span), ("by the balls", result.thickness.x_from_balls)];
    let list: Vec<Quantity> = sizes
        .into_iter()
        .filter_map(|(how, x)| {
            Some(Quantity::rounded(&format!("profile shift coefficient, {how}"), "x", x?, 4, ""))
        })
        .collect();
    let none = list.is_empty();
    let sheet = Sheet::new("Tooth thickness", list);
    if none { sheet.remark("Neither span nor balls were measured.") } else { sheet }
}

fn measurement(result: &GearInspectionResult) -> Sheet {
    let count = |n: usize| i64::try_from(n).unwrap_or(i64::MAX);
    let mut list = vec![Quantity::count("traces evaluated", "", count(result.traces.len()))];
    let class = match result.class {
        None if result.classes.is_empty() => NONE.to_owned(),
        class => class_in_words(class),
    };
    list.push(Quantity::shown("class of ISO 1328-1", "", class, ""));
    list.extend(
        result
            .tolerance_um
            .map(|um| Quantity::shown("tolerance of the job", "", format_significant(um, 4), "µm")),
    );
    Sheet::new("Measurement", list)
}

/// What a job's correction comes to.
fn correction(result: &GearInspectionResult) -> Sheet {
    let um = |name: String, value: f64| Quantity::rounded(&name, "", value, 3, "µm");
    let mut list = Vec::new();
    if let Some(last) = result.rounds.last() {
        list.extend(
            last.flanks.iter().map(|(flank, of)| um(format!("deviation rms, {flank}"), of.measured.rms_um)),
        );
        let proofs = last.correction.iter().flat_map(|correction| &correction.proof);
        list.extend(
            proofs.map(|(flank, proof)| um(format!("after the correction, {flank}"), proof.after.rms_um)),
        );
    }
    Sheet::new("Correction", list)
}
