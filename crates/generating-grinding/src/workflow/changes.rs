//! Changes of a job that would meet a target which its plan misses, found by planning them, the cheapest first
//! (`docs/mathematics/best-fit.md#what-would-meet-it`).

use super::result::{ChangeResult, KeyChange};
use super::run::{Outcome, plan_as_trial};
use super::worm_life::plain;
use crate::job::{DiagonalRatio, DiagonalRule, LoadedJob, Method, Tool};
use foundation::modification::{ModificationSpec, ReliefSpec};
use foundation::numerics::{Progress, Silent};
use job::shown_number;
use job::tables::Flanks;
use report::charts::format_significant;
use run::RunFailure;
use verdict::Status;

/// A smaller worm as a share of the tip diameter of the job's, and a wider one of its width.
const SMALLER: f64 = 0.85;
const WIDER: f64 = 1.5;
/// Causes of a miss that name their cure.
const CURED: [&str; 1] = ["scallops-above-tolerance"];
/// A relief as long as this share of its length, and its start rounded over this share of it on both sides.
const LONGER: f64 = 1.3;
const ROUNDED: f64 = 0.4;

/// A job that differs in little from the one whose target is missed.
struct Change {
    /// What it costs.
    cost: &'static str,
    /// The jobs that together make the gear, one or one for each flank, with what is new in them.
    jobs: Vec<(LoadedJob, Vec<KeyChange>)>,
}

impl Change {
    fn of(
        loaded: &LoadedJob,
        cost: &'static str,
        change: impl FnOnce(&mut LoadedJob) -> Vec<KeyChange>,
    ) -> Option<Self> {
        let mut job = plain(loaded);
        let keys = change(&mut job);
        (!keys.is_empty()).then(|| Self { cost, jobs: vec![(job, keys)] })
    }
}

fn key(name: &str, value: impl ToString) -> KeyChange {
    KeyChange { key: name.to_owned(), value: value.to_string() }
}

/// Plans changes of a job whose flank its plan misses until one meets the target; what was found stands in the result, and the way out of
/// the miss names it. A job that wants no such trials, or a worm topography in place of a gear, whose flank is not what is missed, or whose miss has a
/// cure that is known, is left as it is.
pub fn try_changes(loaded: &LoadedJob, outcome: &mut Outcome, progress: &dyn Progress) {
    let missed = outcome.result.flanks.values().any(|flank| flank.tolerance_share > 1.0);
    let known = outcome.result.verdict.reason().is_some_and(|reason| CURED.contains(&reason.code));
    let left_out = loaded.job.grinding.try_changes == Some(false) || loaded.job.wants_worm();
    if !missed || known || outcome.plan.is_none() || left_out {
        return;
    }
    let changes = changes(loaded, outcome.prepared.setup.worm_tip_radius);
    progress.start("changes that would meet the target", changes.len() as u64);
    let mut tried = Vec::new();
    for change in changes {
        let found = planned(change);
        progress.advance(1);
        let met = found.status == Some(Status::Met);
        tried.push(found);
        if met {
            break;
        }
    }
    progress.finish();
    outcome.result.changes = tried;
    if let Some(advice) = advice(&outcome.result.changes, outcome.result.tolerance_um) {
        outcome.result.verdict.advise(&advice);
    }
}

/// The way out of a miss that the trials found; `None` where none was made.
fn advice(tried: &[ChangeResult], tolerance_um: f64) -> Option<String> {
    let last = tried.last()?;
    let um = |change: &ChangeResult| change.deviation_um.map(|um| format_significant(um, 3));
    if last.status == Some(Status::Met) {
        let deviation = um(last).unwrap_or_default();
        return Some(format!(
            "Set {}: planned and simulated, that meets the target with {deviation} um of {} um; it costs {}.",
            last.keys(),
            format_significant(tolerance_um, 4),
            last.cost,
        ));
    }
    let names: Vec<String> = tried
        .iter()
        .map(|change| match um(change) {
            Some(um) => format!("{} ({um} um)", change.keys()),
            None => change.keys(),
        })
        .collect();
    Some(format!(
        "None of the changes that were planned meets it: {}. Widen the tolerance, or take smoother modifications.",
        names.join("; ")
    ))
}

fn planned(change: Change) -> ChangeResult {
    let (mut deviation, mut status, mut reason): (f64, _, _) = (0.0, Status::Met, None);
    let Change { cost, jobs } = change;
    let (loaded, jobs): (Vec<LoadedJob>, Vec<_>) = jobs.into_iter().unzip();
    for job in &loaded {
        match plan_as_trial(job, &Silent) {
            Ok(outcome) => {
                let off = outcome.result.flanks.values().map(|flank| flank.max_deviation_um);
                deviation = off.fold(deviation, f64::max);
                let verdict = &outcome.result.verdict;
                if verdict.status() != Status::Met && status == Status::Met {
                    (status, reason) = (verdict.status(), verdict.reason().map(|reason| reason.text.clone()));
                }
            }
            Err(RunFailure::NotProducible(finding) | RunFailure::BadInput(finding)) => {
                let reason = Some(finding.message.into());
                return ChangeResult { jobs, cost, status: None, deviation_um: None, reason };
            }
        }
    }
    ChangeResult { jobs, cost, status: Some(status), deviation_um: Some(deviation), reason }
}

/// What may be changed, the cheapest first: how the gear is ground, then a worm that is dressed smaller, then the drawing, then another
/// worm.
fn changes(loaded: &LoadedJob, worm_tip_radius: f64) -> Vec<Change> {
    let job = &loaded.job;
    let another = |cost, change: fn(&mut LoadedJob) -> Vec<KeyChange>| Change::of(loaded, cost, change);
    let mut all: Vec<Change> = Vec::new();
    if job.grinding.method == Method::Radial {
        all.extend(another("a shift of the worm: a little more of its width", |loaded| {
            let grinding = &mut loaded.job.grinding;
            grinding.method = Method::Diagonal;
            grinding.diagonal_ratio = None;
            vec![key("grinding.method", "\"diagonal\"")]
        }));
    } else if matches!(job.grinding.diagonal_ratio, Some(DiagonalRatio::Number(_))) {
        all.extend(another("another shift of the worm", |loaded| {
            loaded.job.grinding.diagonal_ratio = Some(DiagonalRatio::Rule(DiagonalRule::Auto));
            vec![key("grinding.diagonal_ratio", "\"auto\"")]
        }));
    }
    all.extend(one_by_one(loaded));
    let dressed = job.worm.tool == Tool::Dressed;
    if dressed {
        let tip = SMALLER * 2.0 * worm_tip_radius;
        all.extend(Change::of(loaded, "a worm that is dressed smaller", |loaded| {
            let tip = round_to(tip, 0.1);
            let given = loaded.job.worm.pitch_diameter.is_some();
            *loaded = super::worm_life::worn(loaded, tip);
            let pitch = loaded.job.worm.pitch_diameter.map_or("left out".to_owned(), shown_number);
            let pitch = given.then(|| key("worm.pitch_diameter", pitch));
            pitch.into_iter().chain([key("worm.tip_diameter", shown_number(tip))]).collect()
        }));
    }
    all.extend(another("a drawing with smoother reliefs: ask for it", smoother_reliefs));
    if dressed {
        all.extend(another("another worm", |loaded| {
            let threads = &mut loaded.job.worm.threads;
            *threads += 1;
            vec![key("worm.threads", *threads)]
        }));
        all.extend(another("another worm", |loaded| match &mut loaded.job.worm.threads {
            1 => Vec::new(),
            threads => {
                *threads -= 1;
                vec![key("worm.threads", *threads)]
            }
        }));
        all.extend(another("a wider worm", |loaded| match &mut loaded.job.worm.width {
            None => Vec::new(),
            Some(width) => {
                *width = round_to(WIDER * *width, 1.0);
                vec![key("worm.width", shown_number(*width))]
            }
        }));
    }
    all
}

fn round_to(value: f64, step: f64) -> f64 {
    // Tenths as division makes them have no digits that rounding left behind.
    (value / step).round() / (1.0 / step)
}

/// The flanks in two jobs, each with a shift and dressing of its own.
fn one_by_one(loaded: &LoadedJob) -> Option<Change> {
    (loaded.job.grinding.flanks == Flanks::Both).then(|| {
        let only = |flank, name| {
            let mut job = plain(loaded);
            job.job.grinding.flanks = flank;
            (job, vec![key("grinding.flanks", name)])
        };
        Change {
            cost: "a job for each flank, and twice the strokes",
            jobs: vec![only(Flanks::Left, "\"left\""), only(Flanks::Right, "\"right\"")],
        }
    })
}

/// Straight reliefs that begin rounder, and others that are longer.
fn smoother_reliefs(loaded: &mut LoadedJob) -> Vec<KeyChange> {
    let mut keys = Vec::new();
    for (k, modification) in loaded.job.target.modifications.iter_mut().flatten().enumerate() {
        let Some(ReliefSpec { length_mm, exponent, transition_mm, .. }) = relief(modification) else {
            continue;
        };
        if *exponent == 1.0 {
            let rounded = round_to(ROUNDED * *length_mm, 0.01);
            if rounded > *transition_mm {
                *transition_mm = rounded;
                keys.push(key(&format!("target.modifications[{k}].transition_mm"), shown_number(rounded)));
            }
        } else {
            *length_mm = round_to(LONGER * *length_mm, 0.01);
            keys.push(key(&format!("target.modifications[{k}].length_mm"), shown_number(*length_mm)));
        }
    }
    keys
}

fn relief(modification: &mut ModificationSpec) -> Option<&mut ReliefSpec> {
    match modification {
        ModificationSpec::TipRelief(relief)
        | ModificationSpec::RootRelief(relief)
        | ModificationSpec::EndReliefI(relief)
        | ModificationSpec::EndReliefII(relief)
        | ModificationSpec::EndReliefDatumFace(relief)
        | ModificationSpec::EndReliefNonDatumFace(relief) => Some(relief),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use job::{Source, parse_job_of};
    use serde_json::{Value, json};

    fn loaded(change: impl FnOnce(&mut Value)) -> LoadedJob {
        let all: Vec<Value> = serde_json::from_str(include_str!("../../tests/drawings.json")).unwrap();
        let mut job = all.into_iter().find(|job| job["job"]["name"] == "d040").unwrap();
        change(&mut job);
        parse_job_of(Source::new("job.json", &job.to_string())).unwrap()
    }

    fn keys(loaded: &LoadedJob) -> Vec<String> {
        let of = |change: &Change| {
            change
                .jobs
                .iter()
                .flat_map(|(_, keys)| keys)
                .map(|key| key.key.clone())
                .collect::<Vec<_>>()
                .join(" ")
        };
        changes(loaded, 131.5).iter().map(of).collect()
    }

    #[test]
    fn what_costs_least_comes_first() {
        let given = loaded(|job| job["grinding"]["diagonal_ratio"] = json!(-1.0));
        let reliefs = "target.modifications[2].transition_mm target.modifications[3].length_mm target.modifications[4].transition_mm";
        assert_eq!(
            keys(&given),
            [
                "grinding.diagonal_ratio",
                "grinding.flanks grinding.flanks",
                "worm.tip_diameter",
                reliefs,
                "worm.threads",
                "worm.threads",
                "worm.width"
            ]
        );
        // What a job leaves open is no change.
        let plain = loaded(|job| {
            job["grinding"] = json!({ "method": "radial", "flanks": "left" });
            job["target"]["modifications"] = json!([{ "kind": "helix_crowning", "amount_um": 5.0 }]);
            job["worm"].as_object_mut().unwrap().remove("width");
            job["worm"]["threads"] = json!(1);
        });
        assert_eq!(keys(&plain), ["grinding.method", "worm.tip_diameter", "worm.threads"]);
    }

    #[test]
    fn changed_values_are_those_of_the_jobs() {
        let of = loaded(|job| job["worm"]["pitch_diameter"] = json!(255.9));
        let smaller = changes(&of, 131.5).into_iter().find(|change| change.cost.contains("smaller")).unwrap();
        let [(job, keys)] = smaller.jobs.as_slice() else { panic!("one job") };
        assert_eq!(job.job.worm.tip_diameter, Some(223.5));
        // The addendum stays.
        let pitch = job.job.worm.pitch_diameter.unwrap();
        assert!((pitch - (223.5 - 263.0 + 255.9)).abs() < 1e-9, "{pitch}");
        assert_eq!(keys[1], KeyChange { key: "worm.tip_diameter".into(), value: "223.5".into() });
        let relief = changes(&of, 131.5).into_iter().find(|change| change.cost.contains("drawing")).unwrap();
        // A start that is rounded by 1.36 of 3.97 mm already is rounded by 0.4 of its length.
        assert_eq!(relief.jobs[0].1[0].value, "1.59");
    }

    #[test]
    fn the_advice_names_what_meets_or_what_was_tried() {
        let change = |key: &str, status: Option<Status>, um: Option<f64>| ChangeResult {
            jobs: vec![vec![KeyChange { key: key.into(), value: "1".into() }]],
            cost: "another worm",
            status,
            deviation_um: um,
            reason: None,
        };
        assert_eq!(advice(&[], 2.0), None);
        let missed = change("a", Some(Status::Missed), Some(2.5));
        let met = advice(&[missed.clone(), change("b", Some(Status::Met), Some(1.5))], 2.0).unwrap();
        assert!(
            met.starts_with("Set `b = 1`") && met.contains("1.5 um of 2 um") && met.contains("another worm"),
            "{met}"
        );
        let none = advice(&[missed, change("c", None, None)], 2.0).unwrap();
        assert!(
            none.starts_with("None of the changes that were planned meets it: `a = 1` (2.5 um); `c = 1`."),
            "{none}"
        );
    }
}
