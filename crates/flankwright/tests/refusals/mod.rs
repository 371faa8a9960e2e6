//! Jobs that these bodies cannot make: the true cause, a remedy that exists, and a report all the same.

use flankwright::exchange::{AnyJob, Diagnostic, LoadedJob, Source, parse_any_job, parse_job};
use flankwright::numerics::Silent;
use flankwright::verdict::Status;
use flankwright::workflow::{RunFailure, Task, carry_out, plan_job, write_refusal};

fn job(text: &str) -> LoadedJob {
    parse_job(Source::new("job.toml", text)).unwrap_or_else(|e| panic!("{e:?}"))
}

fn refused(loaded: &LoadedJob) -> Diagnostic {
    match plan_job(loaded, &Silent) {
        Err(RunFailure::NotProducible(finding)) => *finding,
        Err(RunFailure::BadInput(finding)) => panic!("{finding}"),
        Ok(outcome) => panic!("it was made: {:?}", outcome.result.verdict),
    }
}

fn way_out(finding: &Diagnostic) -> &str {
    finding.way_out.as_deref().expect("a remedy")
}

/// m 1.5, z 95, beta 32 deg with helix crowning, helix slope and profile slope.
fn with_slopes(grinding: &str) -> LoadedJob {
    job(&format!(
        r#"
[job]
name = "slopes"
process = "generating-grinding"
[gear]
teeth = 95
normal_module = 1.5
normal_pressure_angle_deg = 20.0
helix_angle_deg = 32.0
profile_shift = 0.0
face_width = 30.0
tip_diameter = 171.035
root_diameter = 164.285
form_diameter = 165.185
[target]
tolerance_um = 2.0
modifications = [
  {{ kind = "helix_crowning", amount_um = 8.0 }},
  {{ kind = "helix_slope", amount_um = 10.0 }},
  {{ kind = "profile_slope", amount_um = 6.0 }},
]
[worm]
threads = 5
tip_diameter = 280.0
width = 160.0
[dresser]
tip_diameter = 123.0
[grinding]
method = "diagonal"
{grinding}
[grid]
profile_points = 9
helix_points = 9
"#
    ))
}

/// No best fit follows where the command is not corrected.
const BY_RULES: &str = "precompensation = false";

/// What the rules refuse is made by a best fit.
#[test]
fn slopes_beyond_the_limits_of_the_rules_are_made_by_a_fit() {
    let outcome = plan_job(&with_slopes(""), &Silent).unwrap_or_else(|e| panic!("{e:?}"));
    assert_eq!(outcome.result.verdict.status(), Status::Met, "{:?}", outcome.result.verdict.reason());
    assert!(outcome.result.settings.settings.left.is_some_and(|left| left.profile_pieces.is_some()));
}

/// The default limits of planning are no limit of the machine: the finding says so and names a ratio, which is met.
#[test]
fn a_default_limit_of_planning_is_told_with_the_ratio_that_lifts_it() {
    let loaded = with_slopes(BY_RULES);
    let finding = refused(&loaded);
    assert_eq!((finding.code, finding.field.as_deref()), ("axis-limit", Some("grinding.diagonal_ratio")));
    assert!(finding.message.contains("offset the dresser tangentially"), "{finding}");
    let remedy = way_out(&finding);
    assert!(remedy.contains("one of planning (grinding.axis_limits)"), "{remedy}");
    let stated = remedy.split_once("diagonal_ratio = ").expect("a ratio").1;
    let ratio = stated.split_whitespace().next().expect("a number");
    let outcome = plan_job(&with_slopes(&format!("diagonal_ratio = {ratio}")), &Silent);
    let outcome = outcome.unwrap_or_else(|e| panic!("{e:?}"));
    assert_eq!(outcome.result.verdict.status(), Status::Met, "{:?}", outcome.result.verdict.reason());
}

/// A refusal hands over reason, bodies, candidates and the picture of what limits.
#[test]
fn a_refused_plan_writes_a_report() {
    let loaded = with_slopes(BY_RULES);
    let finding = refused(&loaded);
    let directory = tempfile::tempdir().expect("a directory");
    std::fs::write(directory.path().join("topography.csv"), "of an earlier run").expect("a file");
    let written = write_refusal(&AnyJob::from(loaded), &finding, directory.path()).expect("files");
    let names: Vec<_> = written.iter().filter_map(|path| path.file_name()?.to_str()).collect();
    assert_eq!(names, ["result.json", "report.html"]);
    assert!(!directory.path().join("topography.csv").exists(), "a result of an earlier run stays");
    let result: serde_json::Value =
        serde_json::from_slice(&std::fs::read(&written[0]).expect("a result")).expect("JSON");
    assert_eq!(result["status"], "not_producible");
    assert_eq!(result["reason"]["code"], "axis-limit");
    assert!(result["bodies"]["gear"].is_object() && result["bodies"]["worm"].is_object(), "{result}");
    let candidates = result["candidates"].as_array().expect("candidates");
    assert!(candidates.len() > 10, "{}", candidates.len());
    let named = |c: &serde_json::Value| {
        c["refused"].as_str().is_some_and(|why| why.contains("planning takes at most"))
    };
    assert!(candidates.iter().any(named));
    let page = std::fs::read_to_string(&written[1]).expect("a page");
    for part in [
        "not producible",
        "What limits",
        "Share of the axis limits",
        "Reach of the worm",
        "Candidates tried",
        "Bodies",
        "Remedy: ",
    ] {
        assert!(page.contains(part), "{part}");
    }
    assert!(page.matches("<svg").count() >= 2);
}

/// A machine whose travel is too short: the message tells the whole way, and the report draws the axis with its travel.
#[test]
fn a_travel_that_is_too_short_is_drawn() {
    let directory = tempfile::tempdir().expect("a directory");
    let machine = include_str!("../../../../machines/eight-axis.toml");
    let (before, shift) = machine.split_once("[axes.V1]").expect("the shift");
    let shift = shift.replacen("min_mm = -140", "min_mm = -20", 1).replacen("max_mm = 140", "max_mm = 20", 1);
    std::fs::write(directory.path().join("short.toml"), format!("{before}[axes.V1]{shift}")).expect("a file");
    let text = include_str!("../../../../examples/twist-free-crowning.toml")
        .replace("../machines/eight-axis.toml", "short.toml");
    let path = directory.path().join("job.toml");
    let loaded =
        parse_job(Source::new(path.display().to_string(), &text)).unwrap_or_else(|e| panic!("{e:?}"));
    let finding = refused(&loaded);
    assert_eq!((finding.code, finding.field.as_deref()), ("axis-limit", Some("machine")));
    let way = finding.message.split_once("the whole way needs V1 from ").expect("the way").1;
    let numbers: Vec<f64> =
        way.split(|c: char| !"-.0123456789".contains(c)).filter_map(|word| word.parse().ok()).collect();
    let [from, to, least, greatest] = numbers[..] else { panic!("{way}") };
    assert_eq!((least, greatest), (-20.0, 20.0));
    assert!(from < -20.0 && to > 20.0 && to - from < 400.0, "{way}");
    let out = directory.path().join("out");
    let written = write_refusal(&AnyJob::from(loaded), &finding, &out).expect("files");
    let page = std::fs::read_to_string(written.last().expect("a page")).expect("a page");
    let limits = page.split("<h2>What limits</h2>").nth(1).expect("the section");
    assert!(limits.contains("aria-label=\"Axis V1, word Y\""));
    assert!(limits.contains("Its travel is -20.0 to 20.0 mm."));
}

/// The worm of this planet gear reaches d 49.27 mm.
fn planet(form_diameter: f64, worm_tip: f64) -> LoadedJob {
    job(&format!(
        r#"
[job]
name = "planet"
process = "generating-grinding"
[gear]
teeth = 27
normal_module = 1.8
normal_pressure_angle_deg = 20.0
helix_angle_deg = 22.0
profile_shift = 0.0
face_width = 22.0
tip_diameter = 56.0
root_diameter = 47.6
form_diameter = {form_diameter}
[target]
tolerance_um = 2.0
modifications = [{{ kind = "helix_crowning", amount_um = 5.0 }}]
[worm]
threads = 3
pitch_diameter = 220.0
tip_diameter = {worm_tip}
[dresser]
tip_diameter = 123.0
[grinding]
method = "diagonal"
[grid]
profile_points = 9
helix_points = 5
"#
    ))
}

/// A start of the profile beyond the worm's tip is told in diameters of the gear, with the tip diameter that reaches it.
#[test]
fn a_worm_whose_tip_is_short_is_named() {
    let finding = refused(&planet(48.98, 223.8));
    assert_eq!((finding.code, finding.field.as_deref()), ("worm-tip-short", Some("worm.tip_diameter")));
    assert!(
        finding.message.contains("generates the involute from d 49.")
            && finding.message.contains("asked from 48.980"),
        "{finding}"
    );
    let remedy = way_out(&finding);
    assert!(remedy.contains("gear.form_diameter"), "{remedy}");
    let stated = remedy.split_once("worm.tip_diameter = ").expect("a tip diameter").1;
    let tip: f64 = stated.split_whitespace().next().and_then(|word| word.parse().ok()).expect("a number");
    let outcome = plan_job(&planet(48.98, tip), &Silent).unwrap_or_else(|e| panic!("{e:?}"));
    assert_eq!(outcome.result.verdict.status(), Status::Met, "{:?}", outcome.result.verdict.reason());
}

/// Linear and parabolic reliefs on a large gear: the search for a contact ends, but nothing folds there.
#[test]
fn a_contact_that_is_not_found_is_no_undercut() {
    let large = |factor: f64| {
        job(&format!(
            r#"
[job]
name = "large"
process = "generating-grinding"
[gear]
teeth = 86
normal_module = 5.291
normal_pressure_angle_deg = 16
helix_angle_deg = -12.75
profile_shift = 0.101
face_width = 33.0
tip_diameter = 478.1803
root_diameter = 454.3708
form_diameter = 458.2663
[target]
tolerance_um = 1.0
modifications = [
  {{ kind = "helix_crowning", amount_um = {} }},
  {{ kind = "helix_slope", amount_um = {} }},
  {{ kind = "profile_slope", amount_um = {} }},
  {{ kind = "tip_relief", amount_um = {}, length_mm = 4.845, exponent = 2 }},
  {{ kind = "end_relief_II", amount_um = {}, length_mm = 9.275, exponent = 2 }},
]
[worm]
threads = 2
hand = "left"
tip_diameter = 274.3
[dresser]
tip_diameter = 144.2
[grinding]
method = "diagonal"
[grid]
profile_points = 9
helix_points = 9
"#,
            43.8 * factor,
            -11.7 * factor,
            2.9 * factor,
            13.9 * factor,
            22.5 * factor
        ))
    };
    let fitted = plan_job(&large(1.0), &Silent).unwrap_or_else(|e| panic!("{e:?}"));
    assert_eq!(fitted.result.verdict.status(), Status::Met, "{:?}", fitted.result.verdict.reason());
    let loaded = large(5.0);
    let finding = refused(&loaded);
    assert_eq!(finding.code, "contact-not-found", "{finding}");
    assert!(finding.message.contains("diameter 4") && !finding.message.contains("undercut"), "{finding}");
    // The reliefs are rounded already; the ratio is free.
    assert!(way_out(&finding).contains("diagonal_ratio") && !way_out(&finding).contains("transition_mm"));
}

/// Other processes hand over their reason and bodies.
#[test]
fn a_refusal_of_another_process_is_reported_too() {
    let text = r#"
[job]
name = "source"
process = "tangential-dressing"
[gear]
teeth = 19
normal_module = 3.5
normal_pressure_angle_deg = 17.5
helix_angle_deg = -35.0
profile_shift = 0.0
face_width = 40.0
tip_diameter = 88.5315
root_diameter = 72.4315
form_diameter = 76.2065
[target]
tolerance_um = 1.0
edge_amounts = { profile_crowning_um = 5.0, lead_conical_um = 50.0, lead_crowning_um = 100.0 }
[worm]
threads = 3
tip_diameter = 200.0
[dresser]
tip_diameter = 123.0
pitch_diameter = 115.65
[grinding]
flanks = "right"
shift_width = 48.1042
[dressing]
variables = "source"
"#;
    let loaded = parse_any_job(Source::new("job.toml", text)).unwrap_or_else(|e| panic!("{e:?}"));
    let failure = carry_out(Task::Plan, &loaded, &Silent).err().expect("a refusal");
    let flankwright::workflow::JobFailure::Job(RunFailure::NotProducible(finding)) = failure else {
        panic!("{failure:?}")
    };
    let directory = tempfile::tempdir().expect("a directory");
    let written = write_refusal(&loaded, &finding, directory.path()).expect("files");
    let page = std::fs::read_to_string(&written[1]).expect("a page");
    assert!(page.contains("not producible") && page.contains("Bodies") && page.contains(finding.code));
    // A file in the place of the directory is told as such.
    let file = directory.path().join("report.html");
    let error = write_refusal(&loaded, &finding, &file).expect_err("an error");
    assert!(error.to_string().contains("report.html: it is a file, not a directory"), "{error}");
}
