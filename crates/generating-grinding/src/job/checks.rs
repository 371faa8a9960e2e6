//! Contradictions between entries of a job that are each in range. Knows the job, no geometry beyond the order of diameters.

mod catalogue;
mod conditions;
mod explore;
mod gear_root;
mod grinding;
mod profile_parts;
mod roughing;
mod stroke_study;
mod strokes;
mod technology;
mod tool;
mod wanted_worm;

pub use explore::ascending;
pub use tool::existing_dresser;

use super::Job;
use job::checks::{clamping_bodies, control_of_job, every_job, falling_stock};
use job::{Diagnostic, Problem, shown_number};

/// All contradictions in a job; without places, which the caller knows.
pub(crate) fn check(job: &Job) -> Vec<Diagnostic> {
    let mut findings = Vec::new();
    every_job(&job.job, &job.gear, &job.grid, &mut findings);
    if job.wants_worm() {
        wanted_worm::check(job, &mut findings);
    } else {
        job.target.check(&mut findings);
    }
    catalogue::check(job, &mut findings);
    // Without a worm there is nothing to say about it.
    if !job.worm.is_absent() {
        tool::check(job, &mut findings);
        gear_root::check(job, &mut findings);
    }
    strokes::check(job, &mut findings);
    grinding::check(job, &mut findings);
    explore::check(job, &mut findings);
    technology::check(job, &mut findings);
    control_of_job(job.control.as_ref(), job.grinding.feed_per_revolution, &mut findings);
    clamping_bodies(job.machine.as_ref().map_or(&[], |machine| &machine.clamping), &mut findings);
    falling_stock(job.machine.as_ref(), &mut findings);
    if let Some(deviations) = &job.deviations {
        deviations.check(&mut findings);
    }
    if let Some(measured) = &job.measured_worm {
        measured.check(&mut findings);
        tool::dressed_in_one_stroke(job, "measured_worm", &mut findings);
    }
    settings(job, &mut findings);
    findings
}

/// Largest coefficient of a setting in its own unit: beyond it no machine follows.
const LARGEST_COEFFICIENT: f64 = 1e6;

/// Strokes that have a length, coefficients that no machine exceeds.
fn settings(job: &Job, findings: &mut Vec<Diagnostic>) {
    let Some(settings) = &job.settings else { return };
    let mut lists = vec![
        ("delta_d_um".to_owned(), &settings.delta_d_um),
        ("delta_phi_2_urad".to_owned(), &settings.delta_phi_2_urad),
    ];
    for (flank, given) in [("left", &settings.left), ("right", &settings.right)] {
        let Some(s) = given else { continue };
        for (key, list) in [
            ("d_phi_S_deg", &s.d_phi_s_deg),
            ("d_gamma_deg", &s.d_gamma_deg),
            ("d_d_mm", &s.d_d_mm),
            ("d_v_yA_mm", &s.d_v_ya_mm),
            ("profile_um", &s.profile_um),
        ] {
            lists.push((format!("{flank}.{key}"), list));
        }
    }
    let tables = &settings.strokes;
    for (flank, strokes) in [("left", &tables.left), ("right", &tables.right)] {
        for (k, s) in strokes.iter().enumerate() {
            for (key, list) in [
                ("d_phi_S_deg", &s.d_phi_s_deg),
                ("d_gamma_deg", &s.d_gamma_deg),
                ("d_d_mm", &s.d_d_mm),
                ("d_v_yA_mm", &s.d_v_ya_mm),
            ] {
                lists.push((format!("strokes.{flank}[{k}].{key}"), list));
            }
        }
    }
    for (key, list) in lists {
        for (i, c) in list.iter().enumerate().filter(|(_, c)| c.abs() > LARGEST_COEFFICIENT) {
            findings.push(
                Diagnostic::new(Problem::InvalidNumber, "a coefficient that no machine follows")
                    .field(format!("settings.{key}[{i}]"))
                    .value(shown_number(*c))
                    .allowed(format!("-{LARGEST_COEFFICIENT:e} to {LARGEST_COEFFICIENT:e}"))
                    .way_out("check the unit of the coefficient"),
            );
        }
    }
    for (flank, given) in [("left", &settings.left), ("right", &settings.right)] {
        let Some(given) = given else { continue };
        if given.v_to_mm <= given.v_from_mm {
            findings.push(
                Diagnostic::new(Problem::InvalidJob, "the dressing stroke has no length")
                    .field(format!("settings.{flank}.v_to_mm"))
                    .value(shown_number(given.v_to_mm))
                    .allowed(format!("> v_from_mm = {}", shown_number(given.v_from_mm)))
                    .way_out("give the stroke from its smaller to its larger worm position"),
            );
        }
    }
}
