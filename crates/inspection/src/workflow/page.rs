//! Fills the page of a measured gear. Timing stays out of it, so that the same measurement gives the same bytes.

use super::closed_loop::{
    CharacteristicResult, CorrectedSettingResult, CorrectionResult, DifferenceResult, MeasuredFlankResult,
    RoundResult,
};
use super::result::{GearInspectionResult, SummaryResult};
use super::run::GearInspection;
use crate::page::measured_gear::{
    ArealRow, ClassRow, CorrectionView, DifferenceRow, EvaluationView, FlankView, LineRow,
    MeasuredGearReport, PitchRow, ProofRow, RoundView, SettingRow, TestRow, TwistRow,
};
use foundation::geometry::{Flank, Sides};
use generating_grinding::job::Job;
use job::ProcessJob;
use job::tables::{JobInfo, ProcessName};
use report::charts::{ChartError, Topography, format_fixed};
use report::{Quantity, html};
use run::{Answer, report_head, sentence};

/// The report of a measured gear as a self-contained HTML page.
///
/// # Errors
/// A number that is not finite.
pub fn html_page(found: &GearInspection, files: &[(String, &'static str)]) -> Result<String, ChartError> {
    let result = &found.result;
    let job = JobInfo {
        name: result.job.clone(),
        process: ProcessName::new(Job::NAME),
        description: described(result),
    };
    let answer = Answer {
        process: "Inspection of a gear",
        status: result.verdict.status(),
        reason: result.verdict.reason(),
        warnings: &result.warnings,
        headline: headline(result),
        figures: figures(result),
    };
    let report = MeasuredGearReport {
        head: report_head(&job, answer, files),
        rounds: result.rounds.iter().map(round).collect::<Result<_, ChartError>>()?,
        verdict: result.verdict.clone(),
        evaluation: evaluation(result),
        not_understood: result
            .not_understood
            .iter()
            .map(|line| (line.file.clone(), line.line, line.text.clone()))
            .collect(),
    };
    Ok(html::render(&report.to_page()?))
}

/// Part, drawing, date and machine in a line.
fn described(result: &GearInspectionResult) -> Option<String> {
    let told: Vec<String> = ["part", "name", "drawing", "date", "machine"]
        .into_iter()
        .filter_map(|key| Some(format!("{key} {}", result.head.get(key)?)))
        .collect();
    (!told.is_empty()).then(|| told.join(", "))
}

fn headline(result: &GearInspectionResult) -> String {
    if let Some(reason) = result.verdict.reason() {
        return sentence(reason);
    }
    match (result.tolerance_um, result.tolerance_class) {
        (None, None) => format!(
            "{} traces were evaluated. Nothing is judged: neither a job nor a class of ISO 1328-1 was given.",
            result.traces.len()
        ),
        (None, Some(class)) => {
            format!("The gear reaches class {class} of ISO 1328-1:2013, which was asked for.")
        }
        (Some(tolerance), None) => format!("The measured flanks are within {tolerance} µm of the target."),
        (Some(tolerance), Some(class)) => format!(
            "The measured flanks are within {tolerance} µm of the target, and the gear reaches class {class} of ISO 1328-1:2013."
        ),
    }
}

fn figures(result: &GearInspectionResult) -> Vec<(String, String)> {
    let um = |value: f64| format!("{} µm", format_fixed(value, 3));
    let mut figures = Vec::new();
    let worst = |round: &RoundResult| round.flanks.values().map(|f| f.measured.rms_um).reduce(f64::max);
    if let [first, .., last] = &result.rounds[..]
        && let (Some(before), Some(after)) = (worst(first), worst(last))
    {
        let text = format!("{} → {}", format_fixed(before, 3), um(after));
        figures.push(("deviation rms, first and last round".into(), text));
    } else if let Some(rms) = result.rounds.last().and_then(worst) {
        figures.push(("deviation rms".into(), um(rms)));
    }
    let last = result.rounds.last().and_then(|round| round.correction.as_ref());
    if let Some(after) = last.and_then(|c| c.proof.values().map(|p| p.after.rms_um).reduce(f64::max)) {
        figures.push(("after the correction, by the referee".into(), um(after)));
    }
    if let Some(class) = result.tolerance_class {
        figures.push(("class asked for".into(), class.to_string()));
    }
    if !result.classes.is_empty() {
        let class = result.class.map_or_else(|| "worse than 11".to_owned(), |class| class.to_string());
        let part = if result.class_is_partial { ", of what could be evaluated" } else { "" };
        figures.push(("class of ISO 1328-1".into(), class + part));
    }
    if !result.printed.is_empty() {
        figures.push(("largest difference from printed values".into(), um(result.printed_difference_um)));
    }
    figures
}

fn round(of: &RoundResult) -> Result<RoundView, ChartError> {
    let ends = of.flanks.values().flat_map(|flank| &flank.z_mm);
    let half_mm = ends.fold(0.0, |most: f64, z| most.max(z.abs()));
    let flanks = Sides::try_from_fn(|side| of.flanks.get(side.name()).map(flank).transpose())?;
    Ok(RoundView {
        number: of.round,
        flanks,
        tests: of.characteristics.iter().filter_map(test).collect(),
        correction: of.correction.as_ref().map(|found| correction(found, half_mm)),
        no_correction: of.no_correction.clone(),
    })
}

fn flank(of: &MeasuredFlankResult) -> Result<FlankView, ChartError> {
    let map = |rows: &[Vec<f64>]| Topography::new(of.w_mm.clone(), of.z_mm.clone(), rows.to_vec());
    let whole: Option<Vec<Vec<f64>>> =
        of.measured_um.iter().map(|row| row.iter().copied().collect()).collect();
    Ok(FlankView {
        target: map(&of.target_um)?,
        planned: map(&of.planned_um)?,
        simulated: map(&of.simulated_um)?,
        measured: whole.as_deref().map(map).transpose()?,
        surface: match of.mismatch_um {
            None => of.surface.clone(),
            Some([rms, most]) => format!(
                "{}; where they cross they disagree by {} µm rms, {} µm at most",
                of.surface,
                format_fixed(rms, 2),
                format_fixed(most, 2)
            ),
        },
        deviation: difference(&of.measured),
        model: difference(&of.model),
        correlation: of.correlation,
        explained: of.explained,
    })
}

fn difference(of: &DifferenceResult) -> DifferenceRow {
    DifferenceRow {
        rms_um: of.rms_um,
        largest_um: of.largest_um,
        features_um: [
            of.profile_slope_um,
            of.profile_crowning_um,
            of.helix_slope_um,
            of.helix_crowning_um,
            of.twist_um,
        ],
        within_tolerance: of.within_tolerance,
    }
}

fn side(name: &str) -> Option<Flank> {
    Flank::BOTH.into_iter().find(|flank| flank.name() == name)
}

fn test(of: &CharacteristicResult) -> Option<TestRow> {
    Some(TestRow {
        flank: side(of.flank)?,
        symbol: match of.characteristic {
            "fHa" => "f_Hα",
            "Ca" => "C_α",
            "fHb" => "f_Hβ",
            "Cb" => "C_β",
            other => other,
        }
        .to_owned(),
        teeth: of.teeth.len(),
        common_um: of.common_um,
        uncertainty_um: of.uncertainty_um,
        limit_um: of.limit_um,
        p: of.p,
        harmonic_um: of.harmonic_um,
        decision: match of.decision {
            "correct" => "CORRECT",
            "below-dead-band" => "too small to correct",
            "not-systematic" => "not systematic",
            "first-harmonic" => "clamping, no correction",
            "not-tested" => "one tooth tells nothing",
            other => other,
        }
        .to_owned(),
    })
}

fn correction(of: &CorrectionResult, half_mm: f64) -> CorrectionView {
    let proof = Flank::BOTH.into_iter().filter_map(|flank| {
        let proof = of.proof.get(flank.name())?;
        Some(ProofRow {
            flank,
            before: difference(&proof.before),
            after: difference(&proof.after),
            first_order_off_um: proof.first_order_off_um,
        })
    });
    CorrectionView {
        settings: of.settings.iter().filter(|setting| !setting.dropped).map(setting).collect(),
        left_alone: of.settings.iter().filter(|setting| setting.dropped).map(|s| words(&s.name)).collect(),
        rms_um: [of.rms_before_um, of.rms_predicted_um, of.rms_unremovable_um],
        not_told_apart: of
            .not_told_apart
            .iter()
            .map(|group| {
                let named: Vec<String> = group.iter().map(|(name, _)| words(&format!("{name}_"))).collect();
                format!("The measured lines do not tell these settings apart: {}.", named.join("; "))
            })
            .collect(),
        proof: proof.collect(),
        machine: machine(of, half_mm),
    }
}

fn setting(of: &CorrectedSettingResult) -> SettingRow {
    let unit = of.name.rsplit_once('_').map_or("", |(_, unit)| unit);
    SettingRow {
        name: words(&of.name),
        unit: if unit == "um" { "µm".into() } else { unit.into() },
        change: of.change,
        deviation: of.deviation,
        total: of.total,
        remark: if of.at_bound { "held by its bound".into() } else { String::new() },
    }
}

/// A setting in words.
fn words(name: &str) -> String {
    match name.rsplit_once('_').map_or(name, |(name, _)| name) {
        "d0" => "centre distance".into(),
        "d1" => "centre distance, linear over the feed".into(),
        "d2" => "centre distance, quadratic over the feed".into(),
        "phi0" => "angle of the workpiece".into(),
        "phi1" => "angle of the workpiece, linear over the feed".into(),
        "phi2" => "angle of the workpiece, quadratic over the feed".into(),
        other => other.replace('_', " ") + " of the worm",
    }
}

/// Changes of feed coefficients that move no point by as much are not shown, um.
const SHOWN_UM: f64 = 1e-3;

/// Half a face, mm, turns coefficients into what they move at its ends.
fn machine(of: &CorrectionResult, half_mm: f64) -> Vec<Quantity> {
    let mut rows = Vec::new();
    for (symbol, unit, coefficients) in
        [("Δd", "µm", &of.machine.delta_d_um), ("Δφ_2", "µrad", &of.machine.delta_phi_2_urad)]
    {
        for (k, value) in coefficients.iter().enumerate() {
            let shown = (value * half_mm.powi(i32::try_from(k).unwrap_or(0))).abs() > SHOWN_UM;
            if !shown {
                continue;
            }
            let power = if k == 0 { unit.to_owned() } else { format!("{unit}/mm^{k}") };
            rows.push(Quantity::number(
                &format!("coefficient of z_V2 to the power {k}"),
                symbol,
                *value,
                &power,
            ));
        }
    }
    for (flank, axes) in &of.machine.dressing {
        let named = [("Δφ_S", "deg"), ("Δγ", "deg"), ("Δd", "mm"), ("Δv_yA", "mm")];
        for ((symbol, unit), value) in named.into_iter().zip(axes) {
            rows.push(Quantity::number(
                &format!("dressing the {flank} flank, at most"),
                symbol,
                *value,
                unit,
            ));
        }
    }
    rows
}

fn evaluation(result: &GearInspectionResult) -> EvaluationView {
    let mut lines: Vec<LineRow> = Vec::new();
    for row in &result.summary {
        let tag = if row.tag.is_empty() { String::new() } else { format!(" {}", row.tag) };
        let name = format!("{}, {}{tag}", row.kind, row.flank);
        let value = (symbol(row), row.mean_um, row.range_um);
        match lines.last_mut().filter(|line| line.name == name) {
            Some(line) => line.values.push(value),
            None => lines.push(LineRow { name, values: vec![value], teeth: row.teeth }),
        }
    }
    let mut remarks = Vec::new();
    if !result.stated.is_empty() {
        remarks.push(format!("Stated about the measurement: {}.", result.stated.join("; ")));
    }
    let um = |value: f64| format_fixed(value, 2);
    if let Some(run_out) = result.run_out_um {
        remarks.push(format!("Run-out F_r {} µm from the pitches.", um(run_out)));
    }
    if let Some([amount, direction]) = result.eccentricity {
        remarks.push(format!("Eccentricity {} µm at {}°.", um(amount), format_fixed(direction, 1)));
    }
    if !result.printed.is_empty() {
        remarks.push(format!(
            "{} of the {} values that the measuring machine printed were evaluated here too; the largest difference is {} µm.",
            result.printed.len(),
            result.printed_values,
            format_fixed(result.printed_difference_um, 3)
        ));
    }
    EvaluationView {
        section: format!("Deviations are those of the {}", result.section),
        lines,
        areal: result
            .areal
            .iter()
            .map(|(flank, of)| ArealRow {
                flank: (*flank).to_owned(),
                surface: of.outside_traces.iter().fold(of.surface.clone(), |text, (along, share)| {
                    text + &format!("; {:.0} % beyond the lines by {along}", 100.0 * share)
                }),
                values_um: [
                    Some(of.profile_slope_um),
                    Some(of.profile_crowning_um),
                    Some(of.helix_slope_um),
                    Some(of.helix_crowning_um),
                    of.twist_um,
                    Some(of.rest_rms_um),
                ],
            })
            .collect(),
        twist: result
            .twist
            .iter()
            .map(|of| TwistRow {
                name: format!("{}, {}", of.tooth, of.flank),
                values_um: [of.by_profiles_um, of.by_leads_um, of.difference_um],
            })
            .collect(),
        pitch: result
            .pitch
            .iter()
            .map(|(flank, pitch)| PitchRow {
                flank: (*flank).to_owned(),
                values_um: [pitch.single_um, pitch.neighbours_um, pitch.range_um, pitch.total_um],
            })
            .collect(),
        classes: result
            .classes
            .iter()
            .map(|class| ClassRow {
                symbol: match class.flank {
                    Some(flank) => format!("{}, {flank}", class.quantity),
                    None => class.quantity.to_owned(),
                },
                value_um: class.value_um,
                class: class.class,
            })
            .collect(),
        remarks,
    }
}

fn symbol(row: &SummaryResult) -> String {
    let of = if row.kind == "profile" { "α" } else { "β" };
    match row.characteristic {
        "fH" => format!("f_H{of}"),
        "F" => format!("F_{of}"),
        "ff" => format!("f_f{of}"),
        "C" => format!("C_{of}"),
        "fKo" => "f_Ko".to_owned(),
        other => other.to_owned(),
    }
}
