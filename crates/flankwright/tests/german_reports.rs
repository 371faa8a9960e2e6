//! Reports in German: every text of the pages of all examples has a German one, headings and columns as well as sentences with figures,
//! remarks, reasons and ways out. English stays what a job or a file says, and what names something in files.

use crate::example_pages::{ExamplePage, files, pages};
use crate::measured_parts::MadePart;
use flankwright::exchange::GearboxJob;
use flankwright::numerics::Silent;
use inspection::workflow::{
    SheetOptions, Statements, inspect_gear, inspection_sheet, sheet_data, sheet_pages,
};
use report::{Language, TextKind, html, texts};
use std::collections::BTreeSet;

/// What a text leaves English, without what the job or a file itself says.
fn left_of(text: &str, job: &str) -> Vec<String> {
    let said = job.replace('_', " ");
    let is_quoted = |left: &str| left.len() > 1 && left.starts_with('"') && left.ends_with('"');
    let left = Language::German.leaves(text).into_iter();
    left.filter(|left| !is_quoted(left) && !said.contains(&left.replace('_', " "))).collect()
}

/// Texts of a page that must be German and are not.
fn without_german(of: &ExamplePage) -> BTreeSet<String> {
    let texts = texts(&of.page).into_iter().filter(|(kind, _)| *kind != TextKind::Unit);
    texts.flat_map(|(_, text)| left_of(text, &of.job)).collect()
}

#[test]
fn all_texts_of_the_examples_are_german() {
    let mut missing = Vec::new();
    for of in pages() {
        missing.extend(without_german(of).into_iter().map(|text| format!("{}: {text}", of.name)));
    }
    assert!(missing.is_empty(), "{} texts:\n{}", missing.len(), missing.join("\n"));
}

#[test]
fn german_pages_are_german_from_their_first_line_to_their_last_number() {
    for of in pages() {
        let mut page = of.page.clone();
        page.language = Language::German;
        let german = html::render(&page);
        assert!(german.contains("<html lang=\"de\">") && german.contains("<dt>Prozess</dt>"), "{}", of.name);
        for english in ["<h2>Settings</h2>", "Deviation from the target", "<th scope=\"col\">Quantity</th>"] {
            assert!(!german.contains(english), "{}: {english}", of.name);
        }
    }
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
        let Ok(outcome) = gearbox::workflow::run_gearbox(job.of::<GearboxJob>().unwrap(), &Silent) else {
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

/// Texts of a sheet that are its own: what is drawn, and what stands beside words of files.
fn own_texts_of_sheet() -> BTreeSet<String> {
    let folder = tempfile::tempdir().expect("a directory");
    let path = folder.path().join("part.mka");
    std::fs::write(&path, MadePart::new("part", 3).text()).expect("a file");
    let Ok(found) = inspect_gear(&path, &Statements::default(), Some(6)) else { panic!("no part") };
    let mut own = BTreeSet::new();
    for class in [None, Some(3), Some(11)] {
        let options = SheetOptions { tolerance_class: class, ..SheetOptions::default() };
        let data = sheet_data(&found.inspection, &found.gear, &options);
        // Broken into lines where it is drawn.
        let slopes: Vec<&String> = [&data.profiles, &data.helices]
            .into_iter()
            .chain(&data.further)
            .map(|row| &row.slope_words)
            .collect();
        for page in sheet_pages(&found.inspection, &found.gear, &options).expect("a sheet") {
            let of_page = page.svg.texts().filter(|text| !slopes.iter().any(|whole| whole.contains(*text)));
            own.extend(of_page.map(str::to_owned));
        }
        own.extend(slopes.into_iter().cloned());
        own.insert(data.pitch.words.clone());
        own.extend(data.head.gear.iter().map(|fact| fact.text.clone()));
        let own_labels = ["section", "datum face", "counting", "sign of fHα", "sign of fHβ", "tolerances"];
        let conditions = data.head.conditions.iter().filter(|fact| own_labels.contains(&fact.label.as_str()));
        own.extend(conditions.map(|fact| fact.text.clone()));
        own.extend(data.topographies.iter().map(|field| field.note.clone()));
    }
    own
}

#[test]
fn the_inspection_sheet_is_german() {
    let missing: Vec<String> =
        own_texts_of_sheet().iter().flat_map(|text| Language::German.leaves(text)).collect();
    assert!(missing.is_empty(), "{missing:#?}");
}

#[test]
fn report_and_sheet_of_a_measurement_have_the_language_that_is_asked_for() {
    let folder = tempfile::tempdir().expect("a directory");
    let path = folder.path().join("part.mka");
    std::fs::write(&path, MadePart::new("part 12.5", 3).text()).expect("a file");
    let Ok(mut found) = inspect_gear(&path, &Statements::default(), Some(6)) else { panic!("no part") };
    let english = inspection_sheet(&found, &SheetOptions::default()).expect("a sheet");
    found.language = flankwright::exchange::job::Language::De;
    let german = inspection_sheet(&found, &SheetOptions::default()).expect("a sheet");
    assert!(english.contains("<html lang=\"en\">") && english.contains("Inspection sheet"));
    assert!(german.contains("<html lang=\"de\">") && german.contains(">Messblatt<"));
    assert!(!german.contains("Inspection sheet") && !german.contains("not measured"));
    // What the file says stays as it is.
    assert!(german.contains("part 12.5"));
    let report = inspection::page::measured_gear::html_page(&found, &files()).expect("a report");
    assert!(report.contains("<html lang=\"de\">") && report.contains("Messung eines Zahnrads"));
}
