//! Reports in German: every heading, column, label, name of a quantity, caption and text of a chart of the examples has a German text.

use flankwright::exchange::{
    AnyJob, GearboxJob, Job, LoadedJob, MillingJob, SkivingJob, TangentialJob, read_any_job,
};
use flankwright::numerics::Silent;
use foundation::numerics::Progress;
use report::{Language, PlanReport, TextKind, html, texts};
use std::collections::BTreeSet;
use std::path::PathBuf;

fn example(path: &str) -> AnyJob {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(path);
    read_any_job(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

const SILENT: &dyn Progress = &Silent;

fn grinding(path: &str) -> PlanReport {
    let job = example(path);
    let outcome = generating_grinding::workflow::run::plan_job(job.of::<Job>().unwrap(), SILENT);
    generating_grinding::page::page(&outcome.unwrap_or_else(|_| panic!("{path}")), &files()).unwrap()
}

/// The files of a page, with one that every run writes.
fn files() -> Vec<(String, &'static str)> {
    vec![("result.json".into(), "all figures of this report")]
}

/// Whether a text has words of a language: four letters in a row are no unit and no symbol.
fn has_words(text: &str) -> bool {
    text.split(|c: char| !c.is_alphabetic()).any(|word| word.chars().count() >= 4)
}

/// Texts that must be German and are not.
fn without_german(page: &PlanReport) -> BTreeSet<(TextKind, String)> {
    let fixed = |kind: &TextKind| !matches!(kind, TextKind::Running | TextKind::Unit);
    texts(page)
        .into_iter()
        .filter(|(kind, text)| fixed(kind) && has_words(text) && !Language::German.knows(text))
        .map(|(kind, text)| (kind, text.to_owned()))
        .collect()
}

/// Checks the page, and that it is written in German from its first line to its last number.
fn check(name: &str, mut page: PlanReport) {
    let missing = without_german(&page);
    assert!(missing.is_empty(), "{name}: {missing:#?}");
    page.language = Language::German;
    let german = html::render(&page);
    assert!(german.contains("<html lang=\"de\">") && german.contains("Maschine"), "{name}");
    for english in ["<h2>Settings</h2>", "Deviation from the target", "<th scope=\"col\">Quantity</th>"] {
        assert!(!german.contains(english), "{name}: {english}");
    }
}

#[test]
fn grinding_reports_are_german() {
    for path in [
        "cycles/planet-gear.toml",
        "cycles/ev-gear.toml",
        "cycles/spur-gear.toml",
        "two-end-reliefs.toml",
        "control/with-real-control.toml",
        "line-dressing.toml",
    ] {
        check(path, grinding(path));
    }
}

#[test]
fn strokes_areas_and_tools_that_are_not_dressed_are_german() {
    for path in ["dressing/gear-root.toml", "plated-worm.toml", "left-out-thread.toml"] {
        let job = example(path);
        let Some(loaded) = job.of::<Job>() else { panic!("{path}") };
        if let Ok(outcome) = generating_grinding::workflow::run::plan_job(loaded, SILENT) {
            check(path, generating_grinding::page::page(&outcome, &files()).unwrap());
        }
    }
}

#[test]
fn tangential_dressing_is_german() {
    for path in ["tangential/automotive.toml", "tangential/example-1-small.toml"] {
        let job = example(path);
        let loaded = job.of::<TangentialJob>().unwrap();
        let Ok(outcome) = tangential_dressing::workflow::plan_tangential(loaded, SILENT) else {
            panic!("{path}")
        };
        check(path, tangential_dressing::page::page(&outcome, &files()).unwrap());
    }
}

#[test]
fn milling_is_german() {
    for path in ["milling/spur-on-ac-table.toml", "milling/spiral-bevel-15.toml", "milling/blisk-blade.toml"]
    {
        let job = example(path);
        let loaded = job.of::<MillingJob>().unwrap();
        let Ok(outcome) = milling::workflow::run_milling(loaded, SILENT) else { panic!("{path}") };
        check(path, milling::page::page(&outcome, &files()).unwrap());
    }
}

#[test]
fn measuring_a_skiving_tool_is_german() {
    for path in ["skiving/measured-ring.toml", "skiving/damaged-tooth.toml", "skiving/internal-ring.toml"] {
        let job = example(path);
        let loaded = job.of::<SkivingJob>().unwrap();
        let Ok(outcome) = skiving::workflow::run_skiving(loaded, SILENT) else { panic!("{path}") };
        check(path, skiving::page::page(&outcome, &files()).unwrap());
    }
}

#[test]
fn the_electronic_gearbox_is_german() {
    for path in [
        "gearbox/cheapest-set-up.toml",
        "gearbox/following-with-disturbances.toml",
        "gearbox/reference-train.toml",
    ] {
        let job = example(path);
        let loaded = job.of::<GearboxJob>().unwrap();
        let Ok(outcome) = gearbox::workflow::run_gearbox(loaded, SILENT) else { panic!("{path}") };
        check(path, gearbox::page::page(&outcome, &files()).unwrap());
    }
}

#[test]
fn inspections_are_german() {
    let job = example("inspection/closed-loop.toml");
    let loaded: &LoadedJob = job.of::<Job>().unwrap();
    let Ok(found) = inspection::workflow::inspect_simulated(loaded, Some(5), SILENT) else {
        panic!("no inspection")
    };
    check("closed loop", inspection::page::measured_gear::page(&found, &files()).unwrap());
}

#[test]
fn the_language_of_a_job_is_that_of_its_report() {
    let text = "[job]\nname = \"language\"\nprocess = \"electronic-gearbox\"\npart_number = \"A 1\"\nauthor = \"B & C\"\n";
    let template = flankwright::exchange::job_template("electronic-gearbox").unwrap();
    let (_, rest) = template.split_once("[gear]").unwrap();
    let with = |output: &str| {
        let text = format!("{text}\n[gear]{rest}").replace("[output]", &format!("[output]\n{output}\n#"));
        let source = flankwright::exchange::Source::new("job.toml", &text);
        let job = flankwright::exchange::parse_any_job(source).unwrap_or_else(|error| panic!("{error}"));
        let Ok(outcome) = gearbox::workflow::run_gearbox(job.of::<GearboxJob>().unwrap(), SILENT) else {
            panic!("no run")
        };
        gearbox::page::html_page(&outcome, &files()).unwrap()
    };
    let (english, german) = (with(""), with("language = \"de\""));
    assert!(english.contains("<html lang=\"en\">") && german.contains("<html lang=\"de\">"));
    assert!(english.contains("Part number") && german.contains("Teilenummer"));
    for page in [&english, &german] {
        assert!(page.contains("<dd>A 1</dd>") && page.contains("<dd>B &amp; C</dd>"));
        assert!(page.contains("@bottom-left { content: \"A 1 · language\"; }"), "{}", &page[..3000]);
        assert!(!page.contains("<dt>Customer</dt>") && !page.contains("<dt>Kunde</dt>"));
    }
    assert_eq!(german, with("language = \"de\""));
}
