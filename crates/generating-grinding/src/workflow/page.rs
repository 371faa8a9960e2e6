//! Fills the report of a run. Timing stays out of it, so that the same job gives the same bytes.

use super::executed_strokes::ExecutedStroke;
use super::prepare::PointDresser;
use super::referee::Verdict;
use super::result::FlankResult;
use super::run::{Outcome, ratio_reason};
use super::tables::ROWS;
use crate::workflow::control::page::control_report;
use crate::workflow::programs::page::programs_report;
use dressing::stretch as profile_stretch;
use foundation::geometry::{Blank, Flank, Gear, Sides};
use foundation::kinematics::{DressingMotion as Motion, GeneratingMotion};
use foundation::numerics::equidistant;
use job::tables::Modification as Spec;
use report::charts::{ChartError, SectionTrace, Topography, format_significant};
use report::generating::{
    ConvergenceRound, DressingMotion, FlankReport, GeneratingReport, GrindingMotion, OutsideTerm,
    RatioCandidate, RatioChoice, Reason, RefereeStage, StrokeReport, TargetAmount, Verification, WrittenFile,
};
use report::{Quantity, Warning, html};
use run::CharacteristicsUm;

/// The amount of a target entry as the job has it, where its kind has one.
pub fn target_amounts(drawn: &[Spec], flank: Flank, target: &CharacteristicsUm) -> Vec<TargetAmount> {
    let entries = drawn.iter().filter(|spec| spec.flank().includes(flank));
    entries
        .map(|spec: &Spec| {
            let keys = serde_json::to_value(spec).unwrap_or_default();
            let amount_um = keys.get("amount_um").and_then(serde_json::Value::as_f64);
            let detail = keys
                .as_object()
                .into_iter()
                .flatten()
                .filter(|(key, value)| {
                    !["kind", "amount_um", "flank", "w_mm", "z_mm", "f_um", "points"].contains(&key.as_str())
                        && !value.is_null()
                })
                .map(|(key, value)| entry_in_words(key, value))
                .collect::<Vec<_>>()
                .join(", ");
            let name = match spec {
                Spec::EndReliefI(_) => "end relief at face I (not the datum face)".to_owned(),
                Spec::EndReliefII(_) => "end relief at face II (datum face)".to_owned(),
                Spec::EndReliefDatumFace(_) => "end relief at the datum face (face II)".to_owned(),
                Spec::EndReliefNonDatumFace(_) => "end relief opposite the datum face (face I)".to_owned(),
                _ => spec.kind().replace('_', " "),
            };
            TargetAmount { name, amount_um, detail }
        })
        .chain((target.twist_fit_um.abs() < 1e-9).then(|| TargetAmount {
            name: "twist".into(),
            amount_um: Some(0.0),
            detail: "no entry: zero twist is wanted".into(),
        }))
        .collect()
}

/// A key of a modification and its value as a drawing has them: `length_mm = 6.0` is "length 6 mm".
fn entry_in_words(key: &str, value: &serde_json::Value) -> String {
    let text = match value {
        serde_json::Value::String(word) => word.replace('_', " "),
        other => other.as_f64().map_or_else(|| other.to_string(), |number| format_significant(number, 6)),
    };
    let (name, unit) = match key.rsplit_once('_') {
        Some((name, "mm")) => (name, " mm"),
        Some((name, "um")) => (name, " µm"),
        Some((name, "deg")) => (name, "°"),
        _ => (key, ""),
    };
    format!("{} {text}{unit}", name.replace('_', " "))
}

/// Sections at the ends and in the middle, each with its own characteristic values.
fn traces(simulated: &Topography, target: &Topography) -> (Vec<SectionTrace>, Vec<SectionTrace>) {
    let thirds = |n: usize| [0, n / 2, n - 1];
    let values = |trace: &mut SectionTrace, crowning: &str, slope: &str| {
        let (c, s) = trace_values(&trace.coordinate_mm, &trace.simulated_um);
        trace.values_um = vec![(crowning.to_string(), c), (slope.to_string(), s)];
    };
    let profiles = thirds(simulated.z_mm().len()).map(|j| {
        let mut trace = SectionTrace::profile(simulated, Some(target), j);
        values(&mut trace, "C_α n", "C_Hα n");
        trace
    });
    let helices = thirds(simulated.w_mm().len()).map(|i| {
        let mut trace = SectionTrace::helix(simulated, Some(target), i);
        values(&mut trace, "C_β n", "C_Hβ n");
        trace
    });
    (profiles.to_vec(), helices.to_vec())
}

/// Crowning and slope of one trace by least squares of {1, x, x^2} over x in [-1, 1]; positive = material removed.
fn trace_values(x: &[f64], f: &[f64]) -> (f64, f64) {
    let (a, b) = (x[0], x[x.len() - 1]);
    let n = x.len() as f64;
    let t: Vec<f64> = x.iter().map(|x| (2.0 * x - a - b) / (b - a)).collect();
    // Orthogonal polynomials on the given abscissae: 1, t - t0, t^2 - p t - q.
    let mean = |g: &dyn Fn(usize) -> f64| (0..t.len()).map(g).sum::<f64>() / n;
    let t0 = mean(&|i| t[i]);
    let l = |i: usize| t[i] - t0;
    let l2 = mean(&|i| l(i) * l(i));
    let p = mean(&|i| t[i] * t[i] * l(i)) / l2;
    let q = mean(&|i| t[i] * t[i]);
    let quadratic = |i: usize| t[i] * t[i] - q - p * l(i);
    let c2 = mean(&|i| f[i] * quadratic(i)) / mean(&|i| quadratic(i) * quadratic(i));
    let c1 = mean(&|i| f[i] * l(i)) / l2 - c2 * p;
    (-c2, -2.0 * c1)
}

/// Parts outside the producible class below this are rounding, um.
const LEAST_OUTSIDE_UM: f64 = 5e-4;

/// A flank as the page shows it.
pub fn flank_report(
    amounts: Vec<TargetAmount>,
    f: &FlankResult,
    planned: &CharacteristicsUm,
) -> Result<FlankReport, ChartError> {
    let map = |rows: &Vec<Vec<f64>>| Topography::new(f.w_mm.clone(), f.z_mm.clone(), rows.clone());
    let (target, simulated) = (map(&f.target_um)?, map(&f.simulated_um)?);
    let (profiles, helices) = traces(&simulated, &target);
    let outside = if f.outside_class_um > LEAST_OUTSIDE_UM {
        vec![OutsideTerm {
            name: "parts of the target that are best-fitted only (normal)".into(),
            wanted_um: f.outside_class_um,
            residual_um: f.outside_class_um,
        }]
    } else {
        Vec::new()
    };
    Ok(FlankReport {
        amounts,
        target,
        planned: Some(map(&f.planned_um)?),
        simulated: Some(simulated),
        target_values: run::reported(&f.target_characteristics),
        planned_values: Some(run::reported(planned)),
        simulated_values: Some(run::reported(&f.simulated_characteristics)),
        max_deviation_um: Some(f.max_deviation_um),
        rms_deviation_um: Some(f.rms_deviation_um),
        model_difference_um: Some(f.model_difference_um),
        outside,
        profiles,
        helices,
    })
}

/// Data of the gear as the page shows them.
pub fn gear_quantities(gear: &Gear, blank: &Blank, evaluation: [f64; 4]) -> Vec<Quantity> {
    let d = gear.data();
    let (l, r) = (gear.flank(Flank::Left), gear.flank(Flank::Right));
    vec![
        Quantity::count("number of teeth", "z", i64::from(d.teeth)),
        Quantity::number("normal module", "m_n", d.normal_module, "mm"),
        Quantity::per_flank(
            "normal pressure angle",
            "α_n",
            d.pressure_angle.left.to_degrees(),
            d.pressure_angle.right.to_degrees(),
            "deg",
        ),
        Quantity::number("helix angle", "β", d.helix_angle.to_degrees(), "deg"),
        Quantity::number("profile shift coefficient", "x", d.profile_shift, ""),
        Quantity::number("face width", "b", blank.face_width, "mm"),
        Quantity::number("tip diameter", "d_a", blank.tip_diameter, "mm"),
        Quantity::number("root form diameter", "d_Ff", blank.form_diameter, "mm"),
        Quantity::number("root diameter", "d_f", blank.root_diameter, "mm"),
        Quantity::number("evaluation from diameter", "", evaluation[0], "mm"),
        Quantity::number("evaluation to diameter", "", evaluation[1], "mm"),
        Quantity::number("evaluation from face position", "z", evaluation[2], "mm"),
        Quantity::number("evaluation to face position", "z", evaluation[3], "mm"),
        Quantity::per_flank("base diameter", "d_b", 2.0 * l.base_radius, 2.0 * r.base_radius, "mm"),
        Quantity::per_flank(
            "base helix angle",
            "β_b",
            l.base_helix_angle.to_degrees(),
            r.base_helix_angle.to_degrees(),
            "deg",
        ),
    ]
}

fn tool_quantities(outcome: &Outcome) -> (Vec<Quantity>, Vec<Quantity>) {
    let setup = &outcome.prepared.setup;
    let worm = &setup.pair.worm;
    let mut of_worm = vec![
        Quantity::count("number of threads", "z_S", i64::from(worm.data().teeth)),
        Quantity::text("hand", if worm.data().helix_angle > 0.0 { "right" } else { "left" }),
        Quantity::number("normal module", "m_nS", worm.data().normal_module, "mm"),
        Quantity::per_flank(
            "normal pressure angle",
            "α_nS",
            worm.data().pressure_angle.left.to_degrees(),
            worm.data().pressure_angle.right.to_degrees(),
            "deg",
        ),
        Quantity::number("pitch diameter", "d_S", 2.0 * setup.worm_pitch_radius, "mm"),
        Quantity::number("tip diameter", "d_aS", 2.0 * setup.worm_tip_radius, "mm"),
        Quantity::number("root diameter", "d_fS", 2.0 * setup.worm_root_radius, "mm"),
        Quantity::number("lead angle", "γ", 90.0 - worm.data().helix_angle.to_degrees().abs(), "deg"),
        Quantity::number("worm length used", "", outcome.result.settings.worm_length_mm, "mm"),
    ];
    of_worm.extend(setup.input.worm_width.map(|w| Quantity::number("worm width", "", w, "mm")));
    let dressing = &outcome.prepared.dressing;
    if let Some(point) = &dressing.point {
        return (of_worm, point_dresser_quantities(outcome, point));
    }
    let (Some(dresser), Some(choice)) = (&outcome.execution.dresser, &setup.input.dresser) else {
        return (of_worm, vec![Quantity::text("tool", "not dressed: its flanks are given as tables")]);
    };
    let chain = &dresser.flanks.left.chain;
    let modified = dresser.flanks.iter().any(|(_, flank)| flank.profile.offset().is_some());
    let mut of_dresser = vec![
        Quantity::number("tip diameter", "d_aA", choice.tip_diameter, "mm"),
        Quantity::number("nominal centre distance", "d_A0", chain.centre_distance, "mm"),
        Quantity::number("nominal crossing angle", "γ_A0", chain.crossing_angle.to_degrees(), "deg"),
        Quantity::text(
            "profile",
            match (&choice.designed_for, modified) {
                (None, true) if setup.strokes.is_some() => "conjugate to the worm, with its own modification",
                (None, true) => "conjugate to the worm, with the profile modifications of the target",
                (None, false) => "conjugate to the unmodified worm",
                (Some(_), true) => "conjugate to the worm it was designed for, with its own modification",
                (Some(_), false) => "conjugate to the unmodified worm it was designed for",
            },
        ),
    ];
    for (k, &tip_diameter) in dressing.other_tip_diameters.iter().enumerate() {
        let name = format!("tip diameter of dresser {}", k + 2);
        of_dresser.push(Quantity::number(&name, "d_aA", tip_diameter, "mm"));
    }
    if let (Some(designed), Ok(settled)) = (&choice.designed_for, setup.dresser()) {
        of_dresser.push(Quantity::count("designed for threads", "z_S", i64::from(designed.threads)));
        of_dresser.extend(
            designed.pitch_diameter.map(|d| Quantity::number("designed for pitch diameter", "d_S", d, "mm")),
        );
        of_dresser.extend(
            designed.tip_diameter.map(|d| Quantity::number("designed for tip diameter", "d_aS", d, "mm")),
        );
        let stretch = settled.flanks.map(|flank, _| profile_stretch(settled, flank, [0.0; 4]).ok());
        if let Sides { left: Some(left), right: Some(right) } = stretch {
            of_dresser.push(Quantity::per_flank("profile stretch", "P", 100.0 * left, 100.0 * right, "%"));
        }
    }
    let lands = outcome.result.settings.largest_tip_land_mm;
    let least = lands.iter().flat_map(|lands| [lands.left, lands.right]).flatten().reduce(f64::min);
    of_dresser
        .extend(least.map(|land| Quantity::number("largest tip land without collision", "b_A", land, "mm")));
    of_dresser.extend(dressing.tip_land.map(|land| Quantity::number("tip land", "b_A", land, "mm")));
    (of_worm, of_dresser)
}

/// The disc in point contact and what its lines come to.
fn point_dresser_quantities(outcome: &Outcome, point: &PointDresser) -> Vec<Quantity> {
    let mut list = vec![
        Quantity::text("contact", "in a point, line by line"),
        Quantity::number("tip diameter", "d_aA", point.tip_diameter, "mm"),
        Quantity::number("tip radius", "r_T", point.tip_radius, "mm"),
    ];
    for (flank, written) in outcome.written.iter() {
        let Some(r) = written.as_ref().map(|w| &w.result) else { continue };
        let named = |what: &str| format!("{flank} flank: {what}");
        let count = i64::try_from(r.lines).unwrap_or(i64::MAX);
        list.extend([
            Quantity::number(&named("direction of the lines"), "ρ_1", r.line_direction_deg, "deg"),
            Quantity::count(&named("lines a thread"), "", count),
            Quantity::number(&named("pitch of the lines"), "p_X", r.pitch_mm, "mm"),
            Quantity::number(&named("contact path a thread"), "", r.path_length_m, "m"),
            Quantity::number(&named("scallops by curvature"), "", r.scallop_um, "µm"),
            Quantity::number(&named("scallops by rays"), "", r.simulated_scallop_um, "µm"),
            Quantity::number(&named("room at the opposite flank"), "", r.clearance_mm, "mm"),
        ]);
    }
    list
}

fn settings_quantities(outcome: &Outcome) -> Vec<Quantity> {
    let s = &outcome.result.settings;
    let mut list = vec![
        Quantity::number("centre distance", "d", s.centre_distance_mm, "mm"),
        Quantity::number("crossed-axes angle", "γ", s.crossed_axes_angle_deg, "deg"),
        Quantity::number("diagonal ratio", "K", s.settings.diagonal_ratio, ""),
        Quantity::number("tool shift at z_V2 = 0", "z_V01", s.settings.shift_origin_mm, "mm"),
        Quantity::number("feed stroke from", "z_V2", s.feed_stroke_mm[0], "mm"),
        Quantity::number("feed stroke to", "z_V2", s.feed_stroke_mm[1], "mm"),
    ];
    if let Some(Sides { left: Some(l), right: Some(r) }) = s.lead_correction_ratio {
        list.push(Quantity::per_flank("lead-correction ratio", "K*", l, r, ""));
    }
    if let Some(place) = s.profile_crowning_by {
        list.push(Quantity::text("profile crowning made by", place));
    }
    if let Some(partition) = &s.partition {
        list.push(Quantity::number("length of an area on the tool", "", partition.area_length_mm, "mm"));
        list.push(Quantity::number("pitch of areas", "P", partition.area_pitch_mm, "mm"));
        let count = |n: usize| i64::try_from(n).unwrap_or(i64::MAX);
        list.extend(
            partition.areas_that_fit.map(|n| Quantity::count("finishing areas that fit", "n", count(n))),
        );
        if partition.roughing_areas > 0 {
            list.push(Quantity::count("roughing areas", "", count(partition.roughing_areas)));
        }
    }
    if let Some(strokes) = &s.index_strokes {
        let joined = |n: &[u32]| n.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
        list.push(Quantity::text("threads that grind", joined(&strokes.active_threads)));
        list.push(Quantity::text("index offsets of the strokes (pitches)", joined(&strokes.index_pitches)));
        list.push(Quantity::number("share of the full feed", "", strokes.feed_factor, ""));
    }
    if let Some(root) = &outcome.result.gear_root {
        list.push(Quantity::number("ground root diameter from", "d_fE", root.root_diameter_mm[0], "mm"));
        list.push(Quantity::number("ground root diameter to", "d_fE", root.root_diameter_mm[1], "mm"));
        list.push(Quantity::number(
            "tip diameter of the worm from",
            "d_aS",
            root.worm_tip_diameter_mm[0],
            "mm",
        ));
        list.push(Quantity::number(
            "tip diameter of the worm to",
            "d_aS",
            root.worm_tip_diameter_mm[1],
            "mm",
        ));
        for (flank, fillet) in root.flanks.iter() {
            let Some(fillet) = fillet else { continue };
            let of = |what: &str| format!("{what}, {flank}");
            list.push(Quantity::number(
                &of("fillet begins at diameter"),
                "d_Ff",
                fillet.form_diameter_mm,
                "mm",
            ));
            list.push(Quantity::number(
                &of("least radius of the fillet"),
                "ρ_F",
                fillet.least_radius_mm,
                "mm",
            ));
            list.push(Quantity::number(
                &of("fillet, plan against referee"),
                "",
                fillet.model_difference_um,
                "um",
            ));
        }
    }
    if let Some(feed) = outcome.prepared.cycle.feed_per_revolution {
        list.push(Quantity::number("feed per revolution of the gear", "", feed, "mm"));
    }
    list
}

/// A grinding motion over the feed as the page draws it.
pub fn grinding_motion(flanks: &str, motion: &GeneratingMotion, feed_range: [f64; 2]) -> GrindingMotion {
    let feeds: Vec<f64> = equidistant(feed_range, ROWS);
    GrindingMotion {
        z_v1_mm: feeds.iter().map(|&v| motion.shift.value(v)).collect(),
        delta_d_um: feeds.iter().map(|&v| motion.delta_d.value(v) * 1e3).collect(),
        delta_phi_2_urad: feeds.iter().map(|&v| motion.delta_phi_2.value(v) * 1e6).collect(),
        delta_gamma_deg: feeds.iter().map(|&v| motion.delta_gamma.value(v).to_degrees()).collect(),
        flanks: flanks.to_owned(),
        z_v2_mm: feeds,
    }
}

fn dressing_motion(outcome: &Outcome, flank: Flank) -> Option<DressingMotion> {
    let dressing = outcome.execution.flanks[flank].as_ref()?.dressing()?;
    Some(motion_over(&dressing.motion, dressing.corrections[0].interval()))
}

fn strokes(outcome: &Outcome, flank: Flank) -> Vec<StrokeReport> {
    let executed = outcome.execution.flanks[flank].as_ref().and_then(|f| f.strokes());
    let report = |stroke: &ExecutedStroke| StrokeReport {
        dresser: stroke.place.dresser + 1,
        range_mm: stroke.place.range,
        motion: motion_over(&stroke.motion, stroke.corrections[0].interval()),
    };
    executed.map_or(Vec::new(), |executed| executed.strokes.iter().map(report).collect())
}

/// A dressing motion over the worm position as the page draws it.
pub fn motion_over(motion: &Motion, (from, to): (f64, f64)) -> DressingMotion {
    let v: Vec<f64> = equidistant([from, to], ROWS);
    let component = |j: usize, unit: f64| v.iter().map(|&v| motion.correction_at(v)[j] * unit).collect();
    let deg = 180.0 / std::f64::consts::PI;
    DressingMotion {
        d_phi_s_deg: component(0, deg),
        d_gamma_deg: component(1, deg),
        d_d_mm: component(2, 1.0),
        d_v_ya_mm: component(3, 1.0),
        v_zs_mm: v,
    }
}

fn feed_marks(outcome: &Outcome) -> Option<String> {
    let heights: Vec<String> = outcome
        .result
        .flanks
        .iter()
        .filter_map(|(flank, f)| Some(format!("{flank} flank {} um", format_significant(f.feed_mark_um?, 2))))
        .collect();
    (!heights.is_empty()).then(|| {
        format!(
            "The simulated flank is the envelope, as an endlessly slow feed leaves it. At the feed of the job the marks stand \
             above it by up to: {}.",
            heights.join(", ")
        )
    })
}

fn line_sample(outcome: &Outcome) -> Option<String> {
    let seen: Vec<String> = outcome
        .result
        .flanks
        .iter()
        .filter_map(|(flank, f)| {
            let lines = f.line_dressing.as_ref()?;
            let um = |x| format_significant(x, 2);
            let (over, under) = (um(lines.simulated_scallop_um), um(lines.simulated_undercut_um));
            Some(format!("{flank} flank {over} um above and {under} um below"))
        })
        .collect();
    (!seen.is_empty()).then(|| {
        format!(
            "The worm is written line by line. The flank above is ground by the wanted worm; what the lines leave of it was seen by \
             normal rays of the worm, a sample of them, shortened by the rounded disc on all its lines: {} the wanted worm \
             flank at most.",
            seen.join(", ")
        )
    })
}

/// Why planned and simulated flank may be compared.
pub const TWO_CALCULATIONS: [&str; 2] = [
    "The planned flank is the exact contact of the worm as dressed with the workpiece, solved point by point.",
    "The simulated flank comes from a second calculation that shares no formula with the first: normal rays of the worm are \
     shortened by the dresser over the real dressing motion, a smooth surface through their ends is the worm, and normal rays of \
     the workpiece are shortened by that worm over the real grinding motion. Only the shapes, the chain of axes and the motions are \
     common to both; the plan only tells on which part of the worm the rays stand.",
];

/// The stages behind a verdict.
pub fn referee_stages(flank: Flank, verdict: &Verdict) -> Vec<RefereeStage> {
    let dressing = verdict.dressing.iter().map(|stage| ("dresser against worm", stage));
    dressing
        .chain([("worm against workpiece", &verdict.grinding)])
        .map(|(name, stage)| RefereeStage {
            name: format!("{flank} flank: {name}"),
            rays: stage.statistics.rays,
            poses: stage.statistics.poses,
            discretisation_um: stage.error_um,
        })
        .collect()
}

/// Own error of the rays against lines: the splines of the motions hold 1e-6 mm.
const LINE_STAGE_ERROR_UM: f64 = 1e-3;

fn verification(outcome: &Outcome) -> Verification {
    let mut stages = Vec::new();
    for (flank, verdict) in outcome.verdicts.iter() {
        let Some(v) = verdict else { continue };
        if let Some(written) = &outcome.written[flank] {
            stages.push(RefereeStage {
                name: format!("{flank} flank: disc on its lines against worm, a sample"),
                rays: written.statistics.rays,
                poses: written.statistics.poses,
                discretisation_um: LINE_STAGE_ERROR_UM,
            });
        }
        stages.extend(referee_stages(flank, v));
    }
    Verification {
        paragraphs: TWO_CALCULATIONS
            .map(String::from)
            .into_iter()
            .chain(feed_marks(outcome))
            .chain(line_sample(outcome))
            .collect(),
        stages,
    }
}

/// The report of a run as a self-contained HTML page.
///
/// # Errors
/// A number that is not finite.
pub fn html_page(outcome: &Outcome, files: &[(String, &'static str)]) -> Result<String, ChartError> {
    let result = &outcome.result;
    let flanks = Sides::try_from_fn(|flank| -> Result<_, ChartError> {
        let (Some(f), Some(executed)) = (result.flanks.get(flank.name()), &outcome.execution.flanks[flank])
        else {
            return Ok(None);
        };
        let cos_b = outcome.prepared.setup.lines[flank].cos_b2;
        let drawn = &outcome.prepared.drawn;
        let amounts = target_amounts(drawn, flank, &f.target_characteristics);
        Ok(Some(flank_report(amounts, f, &CharacteristicsUm::of(&executed.planned, cos_b))?))
    })?;
    let rounds = result.ideal_error_by_round_um.left.len().max(result.ideal_error_by_round_um.right.len());
    let (worm, dresser) = tool_quantities(outcome);
    let input = &outcome.prepared.setup.input;
    let report = GeneratingReport {
        job_name: result.job.clone(),
        description: outcome.prepared.info.description.clone(),
        process: "Generating grinding".into(),
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
        gear: gear_quantities(&input.gear, &input.blank, input.evaluation),
        worm,
        dresser,
        settings: settings_quantities(outcome),
        ratio: outcome.plan.as_ref().map(|plan| RatioChoice {
            chosen: Some(plan.choice.ratio),
            reason: ratio_reason(plan.choice.reason).into(),
            candidates: result
                .settings
                .candidates
                .iter()
                .map(|c| RatioCandidate {
                    ratio: c.diagonal_ratio,
                    place: c.profile_crowning_by.into(),
                    score: Some(c.score),
                    occupation_mm: Some(c.worm_occupation_mm),
                    error_um: Some(c.ideal_error_um),
                    note: c.refused.clone().unwrap_or_default(),
                })
                .collect(),
        }),
        occupation: outcome.result.settings.partition.as_ref().map(|p| p.chart().clone()),
        sections: outcome.sections.clone(),
        grinding_motions: vec![grinding_motion(
            "both flanks",
            &outcome.execution.motion,
            outcome.execution.feed_range,
        )],
        dressing: Sides::from_fn(|flank| dressing_motion(outcome, flank)),
        strokes: Sides::from_fn(|flank| strokes(outcome, flank)),
        control: result
            .control
            .as_ref()
            .map(|control| {
                control_report(control, |flank| {
                    let f = result.flanks.get(flank.name())?;
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
        convergence: (0..rounds)
            .map(|k| ConvergenceRound {
                round: k as u32,
                error_um: result.ideal_error_by_round_um.map(|_, e| e.get(k).copied()),
            })
            .collect(),
        timing: Vec::new(),
        files: files
            .iter()
            .map(|(path, content)| WrittenFile { path: path.clone(), content: (*content).into() })
            .collect(),
    };
    Ok(html::render(&report.to_page()?))
}
