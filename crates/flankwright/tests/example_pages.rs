//! The pages of all examples, each made once, for the tests of what stands on them.

use crate::measured_parts::MadePart;
use flankwright::exchange::{
    AnyJob, GearboxJob, Job, LoadedJob, MillingJob, SkivingJob, TangentialJob, read_any_job,
};
use flankwright::numerics::{Progress, Silent};
use generating_grinding::workflow as grinding;
use inspection::workflow::Statements;
use inspection::workflow::series::{SeriesOptions, inspect_series, measured_parts_in};
use rayon::prelude::*;
use report::PlanReport;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

const SILENT: &dyn Progress = &Silent;

/// A page with the job that it is of.
pub struct ExamplePage {
    /// Path below `examples/`, with what was made of it where that is not its plan.
    pub name: String,
    /// The text of its job with the names of machines, or what its files say; empty for a page that has neither.
    pub job: String,
    /// The page, in English.
    pub page: PlanReport,
}

/// Pages of all examples.
pub fn pages() -> &'static [ExamplePage] {
    static PAGES: LazyLock<Vec<ExamplePage>> = LazyLock::new(|| {
        let mut pages: Vec<ExamplePage> =
            examples().par_iter().flat_map_iter(|path| of_example(path)).collect();
        pages.extend([measured_alone(), series(None), series(Some(5))]);
        pages
    });
    &PAGES
}

/// The folder of the examples.
pub fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

/// All jobs among the examples, in the order of their names.
fn examples() -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut open = vec![folder()];
    while let Some(folder) = open.pop() {
        for entry in
            std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|end| end == "toml") && is_job(&path) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// The names of the machines that jobs may name.
fn machines() -> String {
    let folder = folder().join("../machines");
    let files = std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let texts = files.filter_map(|file| std::fs::read_to_string(file.ok()?.path()).ok());
    texts
        .map(|text| text.lines().filter(|line| line.starts_with("name =")).collect::<Vec<_>>().join("\n"))
        .collect()
}

/// Whether a file is a job: bodies of a catalogue are not.
fn is_job(path: &Path) -> bool {
    std::fs::read_to_string(path).is_ok_and(|text| text.contains("[job]"))
}

/// The files of a page, with one that every run writes.
pub fn files() -> Vec<(String, &'static str)> {
    vec![("result.json".into(), "all figures of this report")]
}

fn of_example(path: &Path) -> Vec<ExamplePage> {
    let name = path.strip_prefix(folder()).expect("an example").to_string_lossy().into_owned();
    let job = read_any_job(path).unwrap_or_else(|error| panic!("{name}: {error}"));
    let text = std::fs::read_to_string(path).expect("an example") + &machines();
    let page =
        |what: &str, page: PlanReport| ExamplePage { name: format!("{name}{what}"), job: text.clone(), page };
    if let Some(loaded) = job.of::<Job>() {
        return of_grinding(&name, loaded).into_iter().map(|(what, made)| page(what, made)).collect();
    }
    let inspected = milled_inspected(&name, &job).map(|made| page(" inspected", made));
    inspected.into_iter().chain([page("", of_other(&name, &job))]).collect()
}

/// What came of an example.
fn made<T, E>(name: &str, result: Result<T, E>) -> T {
    result.unwrap_or_else(|_| panic!("{name} is not made"))
}

fn of_grinding(name: &str, loaded: &LoadedJob) -> Vec<(&'static str, PlanReport)> {
    let explore = loaded.job.explore.as_ref();
    if loaded.job.catalogue.is_some() {
        let bodies = generating_grinding::catalogue::catalogue_of_job(loaded);
        let Ok(Some(bodies)) = bodies else { panic!("{name}: the catalogue is not read") };
        if explore.is_some_and(|explore| explore.catalogue.is_some()) {
            let found = made(name, grinding::study_free_worm(loaded, &bodies, SILENT));
            return vec![(" explored", grinding::catalogue::free_files::page(&found).unwrap())];
        }
        let found = made(name, grinding::rank_catalogue(loaded, &bodies, SILENT));
        return vec![(" explored", grinding::catalogue::files::page(&found).unwrap())];
    }
    if explore.is_some_and(|explore| explore.dressing.is_some()) {
        let found = made(name, grinding::study_dressing(loaded, SILENT));
        return vec![(" explored", grinding::dressing_study::files::page(&found).unwrap())];
    }
    if let Some(study) = explore.and_then(|explore| explore.worm_life) {
        let found = made(name, grinding::study_worm_life(loaded, study, SILENT));
        return vec![(" explored", grinding::worm_life::files::page(&found).unwrap())];
    }
    if name == "inspection/closed-loop.toml" {
        let found = made(name, inspection::workflow::inspect_simulated(loaded, Some(5), SILENT));
        return vec![(" inspected", inspection::page::measured_gear::page(&found, &files()).unwrap())];
    }
    let mut pages = Vec::new();
    if name == "inspection/measured.toml" {
        let measured = folder().join("inspection/measured.csv");
        let found =
            inspection::workflow::inspect_for_job(loaded, &measured, &Statements::default(), None, SILENT);
        let found = made(name, found);
        pages.push((" inspected", inspection::page::measured_gear::page(&found, &files()).unwrap()));
    }
    if name == "two-end-reliefs.toml" {
        let found = made(name, grinding::explore_job(loaded, SILENT));
        pages.push((" explored", grinding::explore::files::page(&found).unwrap()));
    }
    // What the bodies cannot make has no plan.
    if let Ok(outcome) = grinding::plan_job(loaded, SILENT) {
        pages.push(("", generating_grinding::page::page(&outcome, &files()).unwrap()));
    }
    pages
}

/// What `inspect` makes of a milled gear beside the plan of its job.
fn milled_inspected(name: &str, job: &AnyJob) -> Option<PlanReport> {
    let loaded = job.of::<MillingJob>()?;
    if name == "inspection/bevel.toml" {
        let measured = folder().join("inspection/bevel.csv");
        let found = inspection::workflow::inspect_bevel(loaded, &measured, None, SILENT);
        return Some(inspection::page::bevel::page(&made(name, found), &files()).unwrap());
    }
    if name != "inspection/milled.toml" {
        return None;
    }
    let measured = folder().join("inspection/milled.csv");
    let found =
        inspection::workflow::inspect_for_milling(loaded, &measured, &Statements::default(), None, SILENT);
    Some(inspection::page::measured_gear::page(&made(name, found), &files()).unwrap())
}

fn of_other(name: &str, job: &AnyJob) -> PlanReport {
    if let Some(loaded) = job.of::<TangentialJob>().filter(|_| name == "tangential/explore.toml") {
        let found = made(name, tangential_dressing::workflow::explore_tangential(loaded, SILENT));
        return tangential_dressing::workflow::explore::page(&found).unwrap();
    }
    if let Some(loaded) = job.of::<TangentialJob>() {
        let outcome = made(name, tangential_dressing::workflow::plan_tangential(loaded, SILENT));
        return tangential_dressing::page::page(&outcome, &files()).unwrap();
    }
    if let Some(loaded) = job.of::<MillingJob>() {
        let outcome = made(name, milling::workflow::run_milling(loaded, SILENT));
        return milling::page::page(&outcome, &files()).unwrap();
    }
    if let Some(loaded) = job.of::<SkivingJob>() {
        let outcome = made(name, skiving::workflow::run_skiving(loaded, SILENT));
        return skiving::page::page(&outcome, &files()).unwrap();
    }
    if let Some(loaded) = job.of::<GearboxJob>() {
        let outcome = made(name, gearbox::workflow::run_gearbox(loaded, SILENT));
        return gearbox::page::page(&outcome, &files()).unwrap();
    }
    panic!("{name} is of no process that has pages here")
}

/// A part that a measuring machine wrote, by itself.
fn measured_alone() -> ExamplePage {
    let folder = tempfile::tempdir().expect("a directory");
    let path = folder.path().join("part.mka");
    std::fs::write(&path, MadePart::new("part", 3).text()).expect("a file");
    let found = inspection::workflow::inspect_gear(&path, &Statements::default(), Some(6));
    let found = found.unwrap_or_else(|_| panic!("the part is not evaluated"));
    let page = inspection::page::measured_gear::page(&found, &files()).unwrap();
    ExamplePage { name: "a part by itself".into(), job: String::new(), page }
}

/// A series of measured parts, one of them a file that nothing can be read of.
fn series(class: Option<i32>) -> ExamplePage {
    let folder = tempfile::tempdir().expect("a directory");
    for k in 0..12 {
        let mut part = MadePart::new(&format!("part {k}"), 7 + k);
        part.helix_slope.left += 1.5 * k as f64;
        std::fs::write(folder.path().join(format!("{k:02}.mka")), part.text()).expect("a file");
    }
    std::fs::write(folder.path().join("broken.mka"), "nothing of a gear").expect("a file");
    let mut options = SeriesOptions { without_sheets: true, ..SeriesOptions::default() };
    options.sheet.tolerance_class = class;
    let Ok(parts) = measured_parts_in(folder.path()) else { panic!("no parts") };
    let Ok(series) = inspect_series(&parts.parts, &options) else { panic!("no series") };
    let page = inspection::page::series::series_page(&series).unwrap();
    // The names of the parts are those of their files.
    let job = (0..12).map(|k| format!("part {k} ")).collect();
    ExamplePage { name: format!("a series of class {class:?}"), job, page }
}
