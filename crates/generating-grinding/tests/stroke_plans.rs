//! Jobs whose worm is dressed in strokes, from file to referee: groupings of strokes, hands, several dressers, settings that go round.

use foundation::geometry::Flank;
use foundation::numerics::Silent;
use generating_grinding::job::LoadedJob;
use generating_grinding::workflow::{JobResult, Outcome, plan_job, simulate_job};
use job::{Source, parse_job_of as parse_job};
use run::RunFailure;
use verdict::Status;

const EXAMPLE: &str = include_str!("../../../examples/dressing/strokes.toml");

/// The example on a coarse grid with replacements.
fn job(replacements: &[(&str, &str)]) -> LoadedJob {
    let mut text = EXAMPLE.to_owned() + "\n[grid]\nprofile_points = 17\nhelix_points = 7\n";
    for (from, to) in replacements {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    parse_job(Source::new("strokes.toml", &text)).unwrap_or_else(|e| panic!("{e:?}"))
}

fn finished(outcome: Result<Outcome, RunFailure>) -> Outcome {
    match outcome {
        Ok(outcome) => outcome,
        Err(RunFailure::BadInput(d) | RunFailure::NotProducible(d)) => panic!("{d:?}"),
    }
}

fn planned(replacements: &[(&str, &str)]) -> Outcome {
    finished(plan_job(&job(replacements), &Silent))
}

/// Largest distance of the simulated flanks, um.
fn apart(a: &JobResult, b: &JobResult) -> f64 {
    let values = |r: &JobResult| -> Vec<f64> {
        r.flanks.values().flat_map(|f| f.simulated_um.iter().flatten().copied().collect::<Vec<_>>()).collect()
    };
    let (a, b) = (values(a), values(b));
    assert_eq!(a.len(), b.len());
    a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

const SECTIONS: &str = "sections = [
  { to = 0.155, area = 2 },                # begins with the gear's tip
  { to = 0.85, area = 1 },                 # longer than its area: two strokes
  { to = 1.0, area = 2 },                  # ends with its root form circle
]";
const AREAS: &str = "areas = [
  { from = 0.30, to = 0.70 },              # of the first dresser: the main profile
  { from = 0.40, to = 0.61, dresser = 2 }, # of the second: the reliefs
]";
const RELIEFS: &str = "  { kind = \"tip_relief\", amount_um = 4.0, length_mm = 2.6 },
  { kind = \"root_relief\", amount_um = 3.0, length_mm = 2.5 },
";
const OTHERS: &str = "[[dresser.others]]\ntip_diameter = 100.0\n";

#[test]
fn reliefs_of_plain_dressers_on_both_hands() {
    let right = planned(&[]);
    let hands =
        [("helix_angle_deg = 35.0", "helix_angle_deg = -35.0"), ("hand = \"right\"", "hand = \"left\"")];
    let left = planned(&hands);
    for outcome in [&right, &left] {
        assert_eq!(outcome.result.verdict.status(), Status::Met, "{:?}", outcome.result.verdict.reason());
        for (flank, f) in &outcome.result.flanks {
            assert!(f.model_difference_um < 0.05, "{flank}: {}", f.model_difference_um);
            assert!(f.max_deviation_um < 0.3, "{flank}: {}", f.max_deviation_um);
            assert!(f.referee_error_um < 0.1, "{flank}: {}", f.referee_error_um);
        }
    }
    // The left-hand gear is the mirror image of the right-hand one in the middle of its face.
    let (a, b) = (&right.result.flanks["left"], &left.result.flanks["left"]);
    for (a, b) in a.planned_um.iter().zip(&b.planned_um) {
        for (a, b) in a.iter().zip(b.iter().rev()) {
            assert!((a - b).abs() < 2e-3, "{a} {b}");
        }
    }
}

#[test]
fn another_grouping_of_strokes_gives_the_same_flank() {
    let smooth = (RELIEFS, "");
    let one = "areas = [{ from = -0.1, to = 1.1 }]";
    let two = "areas = [{ from = -0.1, to = 0.5 }, { from = 0.5, to = 1.1 }]";
    let whole = planned(&[smooth, (OTHERS, ""), (AREAS, one), (SECTIONS, "sections = [{ to = 1.0 }]")]);
    let halves = planned(&[
        smooth,
        (OTHERS, ""),
        (AREAS, two),
        (SECTIONS, "sections = [{ to = 0.5, area = 1 }, { to = 1.0, area = 2 }]"),
    ]);
    let four = planned(&[smooth]);
    let strokes = |outcome: &Outcome| outcome.result.settings.settings.strokes.left.len();
    assert_eq!((strokes(&whole), strokes(&halves)), (1, 2));
    for outcome in [&whole, &halves, &four] {
        assert_eq!(outcome.result.verdict.status(), Status::Met);
        for f in outcome.result.flanks.values() {
            assert!(f.model_difference_um < 0.05, "{}", f.model_difference_um);
            assert!(f.max_deviation_um < 0.05, "{}", f.max_deviation_um);
        }
    }
    assert!(apart(&whole.result, &halves.result) < 0.05, "{}", apart(&whole.result, &halves.result));
    assert!(apart(&whole.result, &four.result) < 0.05, "{}", apart(&whole.result, &four.result));
}

#[test]
fn a_dresser_with_a_profile_of_its_own_takes_other_corrections_for_the_same_flank() {
    let smooth = (RELIEFS, "");
    let plain = planned(&[smooth]);
    let kind = "modification = { kind = \"profile_crowning\", amount_um = 3.0 }";
    let own = planned(&[smooth, ("modification = \"none\"", kind)]);
    assert!(apart(&plain.result, &own.result) < 0.05, "{}", apart(&plain.result, &own.result));
    let gamma = |outcome: &Outcome| outcome.result.settings.settings.strokes.left[1].d_gamma_deg[0];
    assert!((gamma(&own) - gamma(&plain)).abs() > 0.1, "{} {}", gamma(&own), gamma(&plain));
}

#[test]
fn without_a_shift_the_corrections_are_constant() {
    let outcome = planned(&[
        ("  { kind = \"helix_crowning\", amount_um = 6.0 },\n", ""),
        ("method = \"diagonal\"", "method = \"radial\""),
    ]);
    assert_eq!(outcome.result.verdict.status(), Status::Met, "{:?}", outcome.result.verdict.reason());
    for stroke in &outcome.result.settings.settings.strokes.left {
        assert_eq!(stroke.d_gamma_deg.len(), 1);
    }
    for f in outcome.result.flanks.values() {
        assert!(f.model_difference_um < 0.05, "{}", f.model_difference_um);
    }
}

#[test]
fn settings_go_round_and_threads_change_nothing() {
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| planned(&[]))
    };
    let (one, three) = (run(1), run(3));
    let text = |outcome: &Outcome| serde_json::to_string(&outcome.execution.settings()).unwrap();
    assert_eq!(text(&one), text(&three));
    assert_eq!(one.result.flanks, three.result.flanks);
    let mut loaded = job(&[]);
    loaded.job.settings = Some(serde_json::from_str(&text(&one)).unwrap());
    let again = finished(simulate_job(&loaded, &Silent));
    assert!(apart(&one.result, &again.result) < 1e-3, "{}", apart(&one.result, &again.result));
    for flank in Flank::BOTH {
        let (a, b) = (&one.result.flanks[flank.name()], &again.result.flanks[flank.name()]);
        for (a, b) in a.planned_um.iter().flatten().zip(b.planned_um.iter().flatten()) {
            assert!((a - b).abs() < 1e-6, "{flank}: {a} {b}");
        }
    }
}

#[test]
fn strokes_that_leave_stock_between_them_are_refused() {
    let apart = "areas = [{ from = 0.155, to = 0.85 }, { from = 0.155, to = 0.85, dresser = 2 }]";
    let Err(RunFailure::NotProducible(finding)) = plan_job(&job(&[(AREAS, apart)]), &Silent) else {
        panic!("stock is left")
    };
    assert_eq!((finding.code, finding.field.as_deref()), ("gap", Some("dressing.strokes")));
    assert!(finding.message.contains("do not overlap"), "{}", finding.message);
    assert!(finding.way_out.is_some_and(|way_out| way_out.contains("overlap more")));
}

#[test]
fn a_stroke_that_cannot_be_made_is_named() {
    // A hollow of 8 um over a short section is beyond what corrections bend.
    let hollow = "length_mm = 2.6, exponent = 2 }";
    let refused = plan_job(
        &job(&[("amount_um = 4.0, length_mm = 2.6 }", &format!("amount_um = 12.0, {hollow}"))]),
        &Silent,
    );
    let Err(RunFailure::NotProducible(finding)) = refused else { panic!("a hollow relief is made") };
    assert_eq!(finding.code, "no-zero");
    assert_eq!(finding.field.as_deref(), Some("dressing.strokes"));
    assert!(finding.message.contains("stroke 1 of the dressing"), "{}", finding.message);
    assert!(finding.way_out.is_some_and(|way_out| way_out.contains("hollow")));
}
