//! The report of a run: complete, self-contained, repeatable, and as wide as what was made.

use foundation::numerics::Silent;
use generating_grinding::job::LoadedJob;
use generating_grinding::page::html_page;
use generating_grinding::workflow::{Outcome, plan_job};
use job::read_job_of;
use job::tables::{Flanks, Program};
use report::charts::ChartError;
use std::path::PathBuf;

/// An example on a coarse grid.
fn load(name: &str) -> LoadedJob {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    let mut loaded: LoadedJob = read_job_of(&path).unwrap();
    (loaded.job.grid.profile_points, loaded.job.grid.helix_points) = (5, 5);
    loaded
}

fn run(loaded: &LoadedJob) -> Outcome {
    plan_job(loaded, &Silent).unwrap_or_else(|e| panic!("{e:?}"))
}

fn page(outcome: &Outcome) -> String {
    html_page(outcome, &[("result.json".into(), "all figures of this report")]).unwrap()
}

fn assert_holds(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "\"{part}\" is missing");
    }
}

#[test]
fn the_page_is_complete_and_self_contained() {
    let mut loaded = load("twist-free-crowning.toml");
    loaded.job.output.programs = vec![Program::Linuxcnc, Program::Siemens];
    loaded.job.job.name = "shaft <7>".into();
    let outcome = run(&loaded);
    let page = page(&outcome);
    for heading in [
        "Result per flank",
        "Values of the drawing",
        "Scope of the verdict",
        "Gear and tools",
        "Settings",
        "Topographies",
        "Profile and helix",
        "Grinding motion",
        "Dressing corrections",
        "NC programs",
        "How it was verified",
        "Convergence of the precompensation",
        "Time and files",
    ] {
        assert!(page.contains(&format!("<h2>{heading}</h2>")), "{heading}");
    }
    let ratio = outcome.execution.ratio;
    let ratio = report::charts::format_significant(ratio, 7);
    assert_holds(
        &page,
        &[
            "shaft &lt;7&gt;",
            "within the tolerance of",
            &format!("Diagonal ratio K = {ratio}."),
            "Diagonal ratios compared",
            "C<sub>β</sub>",
            "result.json",
            "@media print",
            "Proven from the program text",
            "Axes that move in grinding",
            "Passes of grinding: linuxcnc",
            "worm against workpiece",
        ],
    );
    // Every proof stands with its sentence, every program with its file.
    let programs = outcome.programs.as_ref().unwrap();
    assert!(!programs.result.proofs.is_empty() && programs.result.programs.len() > 2);
    for program in &programs.result.programs {
        assert!(page.contains(&program.file), "{}", program.file);
    }
    // Nothing is fetched: no script, no link, no image, no address but the name of the SVG namespace.
    for foreign in ["<script", "<link", "<img", "url(", "@import", "src=", "href="] {
        assert!(!page.contains(foreign), "{foreign}");
    }
    assert_eq!(page.matches("http").count(), page.matches("http://www.w3.org/2000/svg").count());
    assert_eq!(page, self::page(&outcome), "not the same bytes twice");
}

#[test]
fn a_missed_target_is_said_with_its_figures_on_the_flanks_that_are_ground() {
    let mut loaded = load("twist-free-crowning.toml");
    loaded.job.machine = None;
    loaded.job.grinding.flanks = Flanks::Left;
    loaded.job.target.tolerance_um = 1e-5;
    let outcome = run(&loaded);
    let page = page(&outcome);
    let code = outcome.result.verdict.reason().unwrap().code;
    assert_holds(&page, &["banner missed", "outside the tolerance of", code, "Left flank"]);
    for absent in ["Right flank", "<h2>NC programs", "<h2>Gearbox and servo"] {
        assert!(!page.contains(absent), "{absent}");
    }
}

#[test]
fn numbers_that_are_none_make_no_page() {
    let mut loaded = load("twist-free-crowning.toml");
    loaded.job.machine = None;
    let mut outcome = run(&loaded);
    outcome.result.flanks.get_mut("left").unwrap().planned_um[2][1] = f64::NAN;
    assert!(matches!(html_page(&outcome, &[]), Err(ChartError::InvalidNumber { .. })));
    outcome.result.flanks.get_mut("left").unwrap().planned_um[2].pop();
    assert!(html_page(&outcome, &[]).is_err());
}
