//! Fills the report of a run of tangential dressing. Timing stays out of it, so that the same job gives the same bytes.

use super::flank::TangentialRun;
use super::result::{PassResult, SensitivityResult, TangentialFlankResult};
use super::run::TangentialOutcome;
use crate::TangentialFlank;
use crate::job::{DresserProfile, EdgeAmounts, TangentialJob};
use crate::page::{
    ComparedMethod, FitRecord, PassReport, RadialFeedReport, SelectionRow, SensitivityMap, TangentialReport,
    VARIABLES, VariableRow,
};
use contact::Measure;
use foundation::geometry::{Flank, Sides};
use generating_grinding::workflow::control::page::control_report;
use generating_grinding::workflow::page::{
    TWO_CALCULATIONS, flank_report, gear_quantities, grinding_motion, motion_over, referee_stages,
    target_amounts,
};
use generating_grinding::workflow::programs::page::programs_report;
use report::charts::{ChartError, Topography};
use report::generating::{
    GeneratingReport, Reason, TOPOGRAPHIES, TargetAmount, VERIFICATION, Verification, WrittenFile,
};
use report::{Quantity, Section, Warning, html};
use run::CharacteristicsUm;

/// The report of a run as a self-contained HTML page.
///
/// # Errors
/// A number that is not finite.
pub fn html_page(
    job: &TangentialJob,
    outcome: &TangentialOutcome,
    files: &[(String, &'static str)],
) -> Result<String, ChartError> {
    let mut page = common(job, outcome, files)?.to_page()?;
    let own = own(outcome)?.sections()?;
    // After the settings, before the pictures of the flank.
    let (variables, others): (Vec<Section>, Vec<Section>) =
        own.into_iter().partition(|section| section.id == VARIABLES);
    page.insert_before(TOPOGRAPHIES, variables);
    page.insert_before(VERIFICATION, others);
    Ok(html::render(&page))
}

/// What every grinding report shows.
fn common(
    job: &TangentialJob,
    outcome: &TangentialOutcome,
    files: &[(String, &'static str)],
) -> Result<GeneratingReport, ChartError> {
    let result = &outcome.result;
    let model = &outcome.prepared.model;
    let input = model.input();
    let flanks = Sides::try_from_fn(|flank| {
        let (Some(f), Some(run)) = (result.flanks.get(flank.name()), &outcome.flanks[flank]) else {
            return Ok(None);
        };
        let cos_b = model.pair.work.flank(flank).base_helix_angle.cos();
        let amounts = amounts(job, flank, f);
        flank_report(amounts, &f.flank, &CharacteristicsUm::of(&run.planned, cos_b)).map(Some)
    })?;
    let ground = |flank: Flank| {
        let run = outcome.flanks[flank].as_ref()?;
        Some((TangentialFlank::new(model, flank, &run.pass, &run.settings, Measure::Ray), run))
    };
    // Flanks of one pass share the motion.
    let shared = shares_a_pass(outcome);
    let of_flanks = Flank::BOTH.into_iter().filter_map(ground).map(|(flank, run)| {
        let name = if shared { "both flanks".to_owned() } else { format!("{} flank", flank.flank()) };
        grinding_motion(&name, flank.motion(), run.strokes.feed)
    });
    Ok(GeneratingReport {
        job_name: result.job.clone(),
        description: job.job.description.clone(),
        process: "Tangential dressing".into(),
        version: result.version.into(),
        status: result.verdict.status().into(),
        verdict: result.verdict.clone(),
        reason: result.verdict.reason().map(|r| Reason {
            code: r.code.into(),
            cause: r.text.clone(),
            way_out: r.way_out.clone(),
        }),
        tolerance_um: result.tolerance_um,
        flanks,
        gear: gear_quantities(
            &input.gear,
            &outcome.prepared.blank,
            [2.0 * input.radii[0], 2.0 * input.radii[1], input.faces[0], input.faces[1]],
        ),
        worm: worm_quantities(job, outcome),
        dresser: dresser_quantities(job, outcome),
        settings: settings_quantities(outcome),
        ratio: None,
        occupation: None,
        sections: Vec::new(),
        grinding_motions: of_flanks.take(if shared { 1 } else { 2 }).collect(),
        dressing: Sides::from_fn(|flank| {
            let (ground, run) = ground(flank)?;
            let (motion, [from, to]) = ground.dressing_motion(run.strokes.dressing).ok()?;
            Some(motion_over(&motion, (from, to)))
        }),
        strokes: Sides { left: Vec::new(), right: Vec::new() },
        control: result
            .control
            .as_ref()
            .map(|control| {
                control_report(control, |flank| {
                    let f = &result.flanks.get(flank.name())?.flank;
                    Some((f.w_mm.clone(), f.z_mm.clone()))
                })
            })
            .transpose()?,
        programs: outcome.programs.as_ref().map(programs_report),
        warnings: result
            .warnings
            .iter()
            .map(|w| Warning { text: w.text.clone(), way_out: w.way_out.clone() })
            .collect(),
        verification: Some(verification(outcome)),
        convergence: Vec::new(),
        timing: Vec::new(),
        files: files
            .iter()
            .map(|(path, content)| WrittenFile { path: path.clone(), content: (*content).into() })
            .collect(),
    })
}

fn amounts(job: &TangentialJob, flank: Flank, f: &TangentialFlankResult) -> Vec<TargetAmount> {
    let Some(edge) = &job.target.edge_amounts else {
        return target_amounts(
            job.target.modifications.as_deref().unwrap_or_default(),
            flank,
            &f.flank.target_characteristics,
        );
    };
    let EdgeAmounts { pressure_angle_um, profile_crowning_um, lead_conical_um, lead_crowning_um } =
        edge.sides()[flank];
    [
        ("pressure angle over the radius", pressure_angle_um),
        ("profile crowning over the radius", profile_crowning_um),
        ("lead conical", lead_conical_um),
        ("helix crowning", lead_crowning_um),
    ]
    .into_iter()
    .filter(|(_, um)| *um != 0.0)
    .map(|(name, um)| TargetAmount {
        name: name.into(),
        amount_um: Some(um),
        detail: "normal, at the edge of the evaluated range".into(),
    })
    .collect()
}

fn worm_quantities(job: &TangentialJob, outcome: &TangentialOutcome) -> Vec<Quantity> {
    let worm = &outcome.prepared.model.pair.worm;
    let data = worm.data();
    let mut list = vec![
        Quantity::count("number of threads", "z_1", i64::from(data.teeth)),
        Quantity::text("hand", if data.helix_angle > 0.0 { "right" } else { "left" }),
        Quantity::number("pitch diameter", "d_1", 2.0 * worm.pitch_radius(), "mm"),
        Quantity::number("tip diameter", "d_a1", 2.0 * outcome.prepared.worm_tip_radius, "mm"),
        Quantity::number("lead angle", "λ", 90.0 - data.helix_angle.to_degrees().abs(), "deg"),
    ];
    list.extend(job.worm.width.map(|w| Quantity::number("worm width", "", w, "mm")));
    list
}

fn dresser_quantities(job: &TangentialJob, outcome: &TangentialOutcome) -> Vec<Quantity> {
    let s = &outcome.result.settings;
    vec![
        Quantity::number("tip diameter", "d_aA", job.dresser.tip_diameter, "mm"),
        Quantity::number("pitch diameter", "d_A", s.dresser_pitch_diameter_mm, "mm"),
        Quantity::number("nominal centre distance", "d_A0", s.dressing_centre_distance_mm, "mm"),
        Quantity::number("nominal crossing angle", "γ_A0", s.dressing_crossing_angle_deg, "deg"),
        Quantity::text(
            "nominal profile",
            match job.dresser.profile {
                DresserProfile::Conjugate => "conjugate to the involute worm",
                DresserProfile::Straight => "straight line",
            },
        ),
    ]
}

fn settings_quantities(outcome: &TangentialOutcome) -> Vec<Quantity> {
    let s = &outcome.result.settings;
    let mut list = vec![
        Quantity::number("centre distance", "d_0", s.centre_distance_mm, "mm"),
        Quantity::number("crossed-axes angle", "γ_0", s.crossed_axes_angle_deg, "deg"),
        Quantity::number("tool shift per feed", "κ", s.shift_ratio, ""),
        Quantity::number("scale along the worm", "b_w", s.shift_width_mm, "mm"),
    ];
    list.extend(s.neutral_shift_ratio.map(|k| Quantity::number("neutral shift ratio", "κ_0", k, "")));
    for (flank, offset) in &s.contact_shift_offset_mm {
        list.push(Quantity::number(&format!("shift that centres the {flank} flank"), "F_T0*", *offset, "mm"));
    }
    list
}

fn verification(outcome: &TangentialOutcome) -> Verification {
    let mut stages = Vec::new();
    let mut samples = Vec::new();
    for (flank, run) in outcome.flanks.iter() {
        let Some(TangentialRun { refereed, sample_difference, .. }) = run else { continue };
        stages.extend(referee_stages(flank, &refereed.verdict));
        samples.push(format!("{flank} flank {:.1e} µm", sample_difference * 1e3));
    }
    let sample = format!(
        "On a sample of points the rays of the gear were shortened without a surface between the stages: wherever a ray looked for the \
         worm, the dresser itself was asked over its whole stroke. Planned flank and rays differ there by at most: {}.",
        samples.join(", ")
    );
    Verification {
        paragraphs: TWO_CALCULATIONS.map(String::from).into_iter().chain([sample]).collect(),
        stages,
    }
}

/// What tangential dressing adds.
fn own(outcome: &TangentialOutcome) -> Result<TangentialReport, ChartError> {
    let result = &outcome.result;
    let s = &result.settings;
    let mut radial_feed = Vec::new();
    for (name, f) in &result.flanks {
        let flank = Flank::BOTH.into_iter().find(|flank| flank.name() == *name);
        if let (Some(flank), Some(_)) = (flank, &f.radial_feed) {
            radial_feed.extend(radial(outcome, flank, f)?);
        }
    }
    let mut worm_length = Vec::new();
    for (flank, f) in &result.flanks {
        let [from, to] = f.dresser_position_mm;
        worm_length.push(Quantity::number(&format!("dresser position from, {flank}"), "x_D", from, "mm"));
        worm_length.push(Quantity::number(&format!("dresser position to, {flank}"), "x_D", to, "mm"));
        let [from, to] = f.worm_occupation_mm;
        worm_length.push(Quantity::number(&format!("worm used, {flank}"), "", to - from, "mm"));
    }
    let together = s.worm_length_one_after_the_other_mm;
    worm_length.push(Quantity::number("worm length, dressed again before every pass", "", together, "mm"));
    if s.worm_length_side_by_side_mm > together {
        let both = s.worm_length_side_by_side_mm;
        worm_length.push(Quantity::number("worm length, a zone for every pass", "", both, "mm"));
    }
    let remark = if shares_a_pass(outcome) {
        "Both flanks are ground in one pass with the same motions. A half-turn about the common perpendicular exchanges the flanks: even \
         powers of F_z, dX, F_C and F_T then act with opposite signs on them and cannot crown both; what crowns both are the distances \
         dA and dist together with odd powers of dX and F_C."
    } else {
        "Every flank has motions of its own, in a pass of its own: either the worm is dressed again before each pass, or it has a \
         dressed zone for each flank, side by side."
    };
    Ok(TangentialReport {
        passes: result.passes.iter().map(pass_report).collect(),
        radial_feed,
        sensitivities: result.sensitivities.iter().map(sensitivity).collect::<Result<_, _>>()?,
        worm_length,
        remarks: vec![remark.to_owned()],
    })
}

fn shares_a_pass(outcome: &TangentialOutcome) -> bool {
    outcome.flanks.iter().any(|(_, run)| run.as_ref().is_some_and(|r| r.pass.len() > 1))
}

fn heading(flanks: &[&str]) -> String {
    match flanks {
        [one] => format!("{}{} flank", one[..1].to_uppercase(), &one[1..]),
        _ => "Both flanks".to_owned(),
    }
}

fn pass_report(pass: &PassResult) -> PassReport {
    PassReport {
        name: heading(&pass.flanks),
        variables: pass
            .variables
            .iter()
            .map(|v| VariableRow {
                name: v.name.clone(),
                meaning: v.meaning.into(),
                value: v.value,
                unit: v.unit.into(),
            })
            .collect(),
        selection: pass
            .choice
            .iter()
            .map(|c| SelectionRow {
                variable: c.variable.clone(),
                taken: c.taken,
                count: c.count,
                largest_um: c.largest_um,
            })
            .collect(),
        fit: Some(FitRecord {
            method: pass.method.into(),
            steps: pass.steps,
            rounds: pass.rounds,
            converged: pass.converged,
            weighted_rms_um: pass.weighted_rms_um,
            by_round_um: pass.weighted_rms_by_round_um.clone(),
        }),
        compared: pass
            .compared
            .iter()
            .map(|c| ComparedMethod {
                method: c.method.into(),
                steps: c.steps,
                outcome: match (c.rounds, c.weighted_rms_um, c.largest_um, c.converged) {
                    (Some(rounds), Some(rms), Some(largest), Some(converged)) => {
                        Ok((rounds, rms, largest, converged))
                    }
                    _ => Err(c.refused.as_ref().map_or_else(String::new, |r| r.text.clone())),
                },
            })
            .collect(),
    }
}

fn radial(
    outcome: &TangentialOutcome,
    flank: Flank,
    f: &TangentialFlankResult,
) -> Result<Option<RadialFeedReport>, ChartError> {
    let (Some(r), Some(run)) = (&f.radial_feed, &outcome.flanks[flank]) else { return Ok(None) };
    let grid = |rows: Vec<Vec<f64>>| Topography::new(f.flank.w_mm.clone(), f.flank.z_mm.clone(), rows);
    let own = run.simulated.minus(&run.target).rows_um();
    let maps = match &r.deviation_um {
        Some(radial) => Some((grid(radial.clone())?, grid(own)?)),
        None => None,
    };
    let (made, wanted) = (&f.flank.simulated_characteristics, &f.flank.target_characteristics);
    Ok(Some(RadialFeedReport {
        flank: heading(&[flank.name()]),
        crowning_um: r.lead_crowning_normal_um,
        closed_twist_um: r.closed_twist_normal_um,
        twist_um: r.twist_normal_um,
        tangential_twist_um: made.twist_corner_normal_um - wanted.twist_corner_normal_um,
        largest_um: r.max_deviation_um,
        tangential_largest_um: f.flank.max_deviation_um,
        maps,
        refused: r.refused.as_ref().map(|r| r.text.clone()),
    }))
}

fn sensitivity(s: &SensitivityResult) -> Result<SensitivityMap, ChartError> {
    Ok(SensitivityMap {
        flank: heading(&[s.flank]),
        variable: s.variable.clone(),
        channel: s.variable.trim_end_matches(|c: char| c.is_ascii_digit()).to_owned(),
        unit: if s.unit == "um/um" { String::new() } else { s.unit.replace("um", "µm") },
        map: Topography::new(s.w_mm.clone(), s.z_mm.clone(), s.values.clone())?,
    })
}
