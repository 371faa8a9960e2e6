//! The verdict on a measured gear: nothing asked is not judged, a class is judged for a file as for a folder, what the class needs and the
//! file does not hold is named.

use crate::measured_parts::MadePart;
use foundation::geometry::Sides;
use inspection::workflow::series::{SeriesOptions, inspect_series, series_summary, write_inspection_series};
use inspection::workflow::{GearInspection, SheetOptions, Statements, inspect_gear, write_gear_inspection};
use run::{JobFailure, RunFailure};
use std::path::PathBuf;
use tempfile::TempDir;
use verdict::Status;

struct Measured(TempDir);

impl Measured {
    fn new(text: &str) -> Self {
        let folder = Self(tempfile::tempdir().expect("a directory"));
        std::fs::write(folder.file(), text).expect("a file");
        folder
    }

    fn file(&self) -> PathBuf {
        self.0.path().join("part.mka")
    }

    fn inspected(&self, class: Option<i32>) -> GearInspection {
        inspect_gear(&self.file(), &Statements::default(), class).expect("an inspection")
    }

    /// The report, as it is written.
    fn page(&self, found: &GearInspection) -> String {
        let out = self.0.path().join("out");
        write_gear_inspection(found, &SheetOptions::default(), &out).expect("written files");
        std::fs::read_to_string(out.join("report.html")).expect("a report")
    }
}

fn part() -> MadePart {
    let mut part = MadePart::new("part 1", 11);
    // 25 um over the evaluated 18 mm are 27.8 um over the face; class 5 allows 6 um.
    part.helix_slope = Sides { left: 25.0, right: 1.0 };
    part
}

#[test]
fn without_class_and_job_nothing_is_judged() {
    let measured = Measured::new(&part().text());
    let found = measured.inspected(None);
    let verdict = &found.result.verdict;
    assert_eq!((verdict.status(), verdict.is_accepted()), (Status::NotJudged, true));
    assert!(verdict.reason().is_none());
    let page = measured.page(&found);
    assert!(page.contains("banner not-judged") && !page.contains("banner met"), "the banner");
    assert!(page.contains("Nothing is judged"), "the headline");
}

#[test]
fn a_class_is_judged_for_a_file_as_for_a_folder() {
    let measured = Measured::new(&part().text());
    for (class, status) in [(5, Status::Missed), (11, Status::Met)] {
        let found = measured.inspected(Some(class));
        let verdict = &found.result.verdict;
        assert_eq!(verdict.status(), status, "class {class}: {verdict:?}");
        assert_eq!(verdict.is_accepted(), status == Status::Met);
        let items: Vec<&str> = verdict.judged().iter().map(|one| one.item.as_str()).collect();
        for wanted in ["left flank, profile", "left flank, helix", "left flank, pitch", "right flank, helix"]
        {
            assert!(items.contains(&wanted), "{wanted}: {items:?}");
        }
        let sheet = SheetOptions { tolerance_class: Some(class), ..SheetOptions::default() };
        let options = SeriesOptions { sheet, ..SeriesOptions::default() };
        let series = inspect_series(&[measured.file()], &options).expect("a series");
        assert_eq!(series.result.verdict.status(), status, "the folder, class {class}");
        let document = serde_json::to_value(&found.result).expect("a document");
        assert_eq!(document["tolerance_class"], class);
        let page = measured.page(&found);
        assert!(page.contains("class asked for") && page.contains("Scope of the verdict"), "the report");
        let sheet = std::fs::read_to_string(measured.0.path().join("out/sheet.html")).expect("a sheet");
        assert!(sheet.contains(&format!("class {class}")), "the sheet names the class");
    }
    let missed = measured.inspected(Some(5));
    let reason = missed.result.verdict.reason().expect("a reason");
    assert_eq!(reason.code, "class-not-reached");
    assert!(reason.text.starts_with("left flank, helix: fHb is 27.8 um, class 5"), "{}", reason.text);
    assert!(measured.page(&missed).contains("banner missed"));
    let of = missed.result.classes.iter().filter(|of| of.quantity == "fHb").map(|of| of.flank);
    assert_eq!(of.collect::<Vec<_>>(), [Some("left"), Some("right")]);
}

#[test]
fn what_the_class_needs_and_the_file_lacks_is_named() {
    let mut without = part();
    without.helix_slope = Sides { left: 1.0, right: 1.0 };
    without.pitch = false;
    let measured = Measured::new(&without.text());
    let found = measured.inspected(Some(11));
    let verdict = &found.result.verdict;
    assert_eq!((verdict.status(), verdict.is_accepted()), (Status::NotJudged, false));
    let owed: Vec<&str> =
        verdict.not_judged().iter().filter(|of| of.asked).map(|of| of.item.as_str()).collect();
    assert_eq!(owed, ["left flank, pitch", "right flank, pitch"]);
    assert_eq!(verdict.reason().expect("a reason").code, "not-measured");
    // A folder says the same, and names them beside the part.
    let sheet = SheetOptions { tolerance_class: Some(11), ..SheetOptions::default() };
    let options = SeriesOptions { sheet, ..SeriesOptions::default() };
    let series = inspect_series(&[measured.file()], &options).expect("a series");
    assert_eq!(series.result.verdict.status(), Status::NotJudged);
    assert_eq!(series.result.groups[0].parts[0].not_judged, ["left flank, pitch", "right flank, pitch"]);
    let summary = series_summary(&series);
    assert!(summary.contains("1 part\n") || summary.contains("1 part,"), "{summary}");
    let out = measured.0.path().join("series");
    write_inspection_series(&series, &out).expect("written files");
    let page = std::fs::read_to_string(out.join("series.html")).expect("a page");
    assert!(page.contains("left flank, pitch: not judged") && page.contains("banner not-judged"));
    // A part beyond the class is missed, whatever else was not measured.
    without.helix_slope.left = 80.0;
    let measured = Measured::new(&without.text());
    assert_eq!(measured.inspected(Some(5)).result.verdict.status(), Status::Missed);
}

#[test]
fn a_file_of_which_nothing_can_be_evaluated_is_not_judged() {
    let text = part().text();
    // Cut short behind its header.
    let lines: Vec<&str> = text.lines().take(40).collect();
    let measured = Measured::new(&lines.join("\n"));
    let found = measured.inspected(None);
    assert!(found.result.traces.is_empty());
    let verdict = &found.result.verdict;
    assert_eq!((verdict.status(), verdict.is_accepted()), (Status::NotJudged, false));
    assert_eq!(verdict.reason().expect("a reason").code, "nothing-evaluated");
}

#[test]
fn a_class_outside_the_standard_is_refused() {
    let measured = Measured::new(&part().text());
    for class in [0, 12, -5] {
        let Err(JobFailure::Job(RunFailure::BadInput(finding))) =
            inspect_gear(&measured.file(), &Statements::default(), Some(class))
        else {
            panic!("class {class} was not refused")
        };
        assert_eq!(finding.code, "out-of-standard-range");
    }
}
