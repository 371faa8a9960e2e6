//! The sheet of a measured gear tells what was evaluated, to scale, and loses nothing: its texts and lines are read back from the pages.

use crate::measured_parts::MadePart;
use foundation::geometry::{Flank, Sides};
use inspection::page::sheet as drawing;
use inspection::workflow::{
    EvaluatedGear, SheetOptions, Statements, evaluate_inspection, inspect_gear, inspection_sheet, sheet_data,
    sheet_pages,
};
use measured_files::inspection::{Inspection, TraceKind, inspection_of, parse_klingelnberg};
use metrology::inspection::{BandFit, KBand};
use report::charts::{ChartError, format_fixed};
use std::path::Path;

struct Sheet {
    inspection: Inspection,
    gear: EvaluatedGear,
    pages: Vec<String>,
}

fn class(class: i32) -> SheetOptions {
    SheetOptions { tolerance_class: Some(class), ..SheetOptions::default() }
}

fn inspection(part: &MadePart) -> Inspection {
    let file = parse_klingelnberg(part.text().as_bytes()).expect("a file of the grammar");
    inspection_of(&[("part.mka", &file)]).expect("an inspection")
}

fn sheet_of(inspection: Inspection, options: &SheetOptions) -> Sheet {
    let gear = evaluate_inspection(&inspection, None).expect("a gear");
    let pages = sheet_pages(&inspection, &gear, options).expect("pages");
    let pages = pages.into_iter().map(|page| page.svg.as_str().to_owned()).collect();
    Sheet { inspection, gear, pages }
}

fn sheet(part: &MadePart, options: &SheetOptions) -> Sheet {
    sheet_of(inspection(part), options)
}

/// Texts of a page with their places, without the marks of indices.
fn texts(page: &str) -> Vec<([f64; 2], String)> {
    let number = |element: &str, name: &str| -> f64 {
        let from = element.find(&format!(" {name}=\"")).expect("an attribute") + name.len() + 3;
        element[from..].split('"').next().expect("a value").parse().expect("a number")
    };
    page.lines()
        .filter(|line| line.starts_with("<text"))
        .map(|line| {
            let (mut plain, mut inside) = (String::new(), false);
            for c in line.chars() {
                match c {
                    '<' => inside = true,
                    '>' => inside = false,
                    c if !inside => plain.push(c),
                    _ => {}
                }
            }
            ([number(line, "x"), number(line, "y")], plain)
        })
        .collect()
}

fn says(page: &str, text: &str) -> bool {
    texts(page).iter().any(|(_, found)| found == text)
}

/// Every line of a page with the width of the traces, in pieces between its gaps.
fn traces(page: &str) -> Vec<Vec<Vec<[f64; 2]>>> {
    let of = |line: &str| -> Option<Vec<Vec<[f64; 2]>>> {
        let path = line.strip_prefix("<path d=\"M")?;
        let (path, look) = path.split_once('"')?;
        look.contains("stroke-width=\"0.25\"").then_some(())?;
        let point = |text: &str| -> [f64; 2] {
            let (x, y) = text.split_once(' ').expect("two coordinates");
            [x, y].map(|c| c.parse().expect("a number"))
        };
        Some(path.split('M').map(|piece| piece.split('L').map(point).collect()).collect())
    };
    page.lines().filter_map(of).filter(|pieces| pieces.iter().map(Vec::len).sum::<usize>() > 50).collect()
}

#[test]
fn tables_hold_the_evaluated_values() {
    let sheet = sheet(&MadePart::new("4711", 2), &class(5));
    let found = texts(&sheet.pages[0]);
    assert_eq!(sheet.pages.len(), 1);
    assert_eq!(sheet.gear.traces.len(), 12);
    for one in &sheet.gear.traces {
        let trace = &sheet.inspection.traces[one.trace];
        let index = if trace.kind == TraceKind::Profile { "α" } else { "β" };
        let left = trace.flank == Flank::Left;
        let in_field = |x: f64| if left { x < 95.0 } else { x > 115.0 };
        let e = &one.evaluation;
        for (symbol, mm) in
            [("fH", e.slope.printed()), ("F", e.total), ("ff", e.form), ("C", e.crowning.height)]
        {
            let name = format!("{symbol}{index} µm");
            let (row, _) = found
                .iter()
                .find(|(at, text)| *text == name && in_field(at[0]))
                .unwrap_or_else(|| panic!("a row {name}"));
            let value = format_fixed(1e3 * mm, 1);
            let in_row = |at: &[f64; 2]| in_field(at[0]) && (at[1] - row[1]).abs() < 0.01;
            let cells: Vec<&str> =
                found.iter().filter(|(at, _)| in_row(at)).map(|(_, t)| t.trim_end_matches('*')).collect();
            assert!(cells.contains(&value.as_str()), "tooth {}, {name}: {value} in {cells:?}", trace.tooth);
        }
    }
    let pitch = sheet.gear.pitch.as_ref().expect("pitches");
    for flank in Flank::BOTH {
        let of = pitch.flanks[flank].as_ref().expect("a flank");
        for mm in [of.single, of.neighbours, of.total, of.sector] {
            assert!(says(&sheet.pages[0], &format_fixed(1e3 * mm, 1)), "{flank} {mm}");
        }
    }
    // Limits of class 5 with the class that was reached; signs of slopes once per block.
    let tolerances = sheet.gear.tolerances.as_ref().expect("tolerances");
    use metrology::inspection::ToleranceQuantity as Q;
    for (quantity, sign) in [(Q::ProfileSlope, "±"), (Q::HelixTotal, ""), (Q::HelixSlope, "±")] {
        let limit = 1e3 * tolerances.rounded(quantity, 5).expect("a class");
        assert!(says(&sheet.pages[0], &format!("{sign}{limit:.1}")), "{sign}{limit}");
    }
    let words: Vec<&str> = found.iter().map(|(_, text)| text.as_str()).collect();
    let words = words.join(" ");
    for part in ["class 5 kept, worst class", "fHβ + = flank turned right-handed (DIN); per 20.000 mm"] {
        assert!(words.contains(part), "{part}: {words}");
    }
}

#[test]
fn what_exceeds_its_limit_has_a_star() {
    let part = MadePart { helix_slope: Sides { left: 30.0, right: 1.0 }, ..MadePart::new("4711", 2) };
    let page = &sheet(&part, &class(5)).pages[0];
    let stars: Vec<String> =
        texts(page).into_iter().map(|(_, text)| text).filter(|text| text.ends_with('*')).collect();
    // The mean slope in its table and in the result, F of three teeth and its worst.
    assert_eq!(stars.len(), 6, "{stars:?}");
    assert!(page.contains("font-weight=\"600\">3") && texts(page).iter().any(|t| t.1.contains("EXCEEDED")));
    let kept = &sheet(&part, &class(11)).pages[0];
    assert!(texts(kept).iter().all(|(_, text)| !text.ends_with('*')));
    let free = &sheet(&part, &SheetOptions::default()).pages[0];
    assert!(texts(free).iter().all(|(_, text)| !text.ends_with('*') && !text.contains('±')));
}

#[test]
fn traces_are_drawn_to_the_scale_that_is_told() {
    let sheet = sheet(&MadePart::new("4711", 2), &class(5));
    let page = &sheet.pages[0];
    let lines = traces(page);
    // Three teeth, two flanks, two kinds; then pitch lines of fewer points.
    assert_eq!(lines.len(), 12);
    let scales: Vec<(f64, f64)> = texts(page)
        .iter()
        .filter_map(|(_, text)| {
            let (f, along) = text.strip_prefix("f ")?.split_once(", ")?;
            let factor =
                |text: &str| text.split(':').next().and_then(|n| n.split(' ').next_back()?.parse().ok());
            Some((factor(f)?, factor(along)?))
        })
        .collect();
    assert_eq!(scales.len(), 2, "{scales:?}");
    let size = |list: &mut dyn Iterator<Item = f64>| {
        let (lo, hi) = list.fold((f64::MAX, f64::MIN), |(lo, hi), v| (lo.min(v), hi.max(v)));
        hi - lo
    };
    for (kind, (across, along)) in [TraceKind::Profile, TraceKind::Helix].into_iter().zip(scales) {
        assert!([500.0, 1000.0, 2000.0].contains(&across), "{across}");
        for trace in sheet.inspection.traces.iter().filter(|trace| trace.kind == kind) {
            let width = 1e-3 * across * size(&mut trace.f_um.iter().copied());
            let height = along * size(&mut trace.abscissa_mm.iter().copied());
            let same = |line: &&Vec<Vec<[f64; 2]>>| {
                let points = || line.iter().flatten();
                let [w, h] = [size(&mut points().map(|p| p[0])), size(&mut points().map(|p| p[1]))];
                (w - width).abs() < 0.021 && (h - height).abs() < 0.021
            };
            assert!(lines.iter().any(|line| same(&line)), "{kind:?} {width} {height}");
        }
    }
}

#[test]
fn material_lies_to_the_outside_and_the_tip_up() {
    let slope = Sides::both(8.0);
    let part = MadePart { profile_slope: slope, wave: 0.0, crowning: 0.0, ..MadePart::new("4711", 2) };
    let page = &sheet(&part, &class(5)).pages[0];
    let lines = traces(page);
    // Profiles come first, the left flank before the right one.
    for (line, outwards) in lines[..6].iter().zip([-1.0, -1.0, -1.0, 1.0, 1.0, 1.0]) {
        let points: Vec<[f64; 2]> = line.iter().flatten().copied().collect();
        let tip = points.iter().copied().min_by(|a, b| a[1].total_cmp(&b[1])).expect("points");
        let root = points.iter().copied().max_by(|a, b| a[1].total_cmp(&b[1])).expect("points");
        assert!(outwards * (tip[0] - root[0]) > 3.0, "{tip:?} {root:?}");
    }
}

#[test]
fn samples_that_were_not_measured_leave_gaps() {
    let part = MadePart { undefined: 200..210, ..MadePart::new("4711", 2) };
    let sheet = sheet(&part, &class(5));
    let lines = traces(&sheet.pages[0]);
    assert_eq!(lines.len(), 12);
    for line in lines {
        assert_eq!(line.iter().map(Vec::len).collect::<Vec<usize>>(), [200, 270]);
        let ends = [line[0][199][1], line[1][0][1]];
        let step = (line[0][0][1] - line[0][199][1]) / 199.0;
        assert!(((ends[0] - ends[1]) / step - 11.0).abs() < 0.3, "{ends:?} {step}");
    }
}

#[test]
fn many_teeth_take_further_pages_and_all_are_drawn() {
    let part = MadePart { traced: (1..=13).collect(), ..MadePart::new("4711", 2) };
    let sheet = sheet(&part, &class(5));
    assert_eq!(sheet.pages.iter().map(|page| traces(page).len()).sum::<usize>(), 4 * 13);
    // Two rows of three parts each: one on the first page, up to three rows on a further one.
    assert_eq!(sheet.pages.len(), 3);
    for (k, page) in sheet.pages.iter().enumerate() {
        assert!(says(page, &format!("page {} of 3", k + 1)));
    }
    let teeth = MadePart { teeth: 200, ..MadePart::new("4711", 2) };
    let page = &sheet_of(inspection(&teeth), &class(5)).pages[0];
    assert!(says(page, "200") && says(page, "line Fp 500:1"));
}

#[test]
fn long_names_stand_in_full_among_the_remarks() {
    let long = "a name of a part that is so long that no head of a sheet can hold it ".repeat(3);
    let name = long.trim();
    let drawing =
        "<b>&\"drawing\"</b> with 車 and more of it, far beyond the room that it has in the head".to_owned();
    let sheet = sheet(&MadePart { drawing, ..MadePart::new(name, 2) }, &class(5));
    let all: String = sheet.pages.iter().flat_map(|page| texts(page)).map(|(_, text)| text + " ").collect();
    let plain = |text: &str| text.split_whitespace().collect::<String>();
    assert!(plain(&all).contains(&plain(name)), "{all}");
    assert!(plain(&all).contains(&plain("&lt;b&gt;&amp;")), "{all}");
    assert!(says(sheet.pages.last().expect("a page"), "Remarks"));
    for page in &sheet.pages {
        assert!(!page.contains("<b>"));
    }
}

#[test]
fn what_was_not_measured_says_so() {
    let missing = |page: &str| texts(page).iter().filter(|(_, text)| text == "not measured").count();
    let part = MadePart { traced: Vec::new(), pitch: false, positions: false, ..MadePart::new("4711", 2) };
    // Four fields of traces, three strips, the sizes.
    assert_eq!(missing(&sheet(&part, &class(5)).pages[0]), 8);
    let mut one_flank = inspection(&MadePart::new("4711", 2));
    one_flank.traces.retain(|trace| trace.flank == Flank::Right);
    if let Some(pitch) = &mut one_flank.pitch {
        pitch.flanks.left = None;
    }
    let page = &sheet_of(one_flank, &class(5)).pages[0];
    assert_eq!((missing(page), traces(page).len()), (4, 6));
}

#[test]
fn a_trace_beyond_its_band_is_crossed_out() {
    let band = |half: f64| {
        let [from, to] = [5.5, 9.5];
        KBand::new(&[from, to], &[-half, -half], &[half, half]).expect("a band")
    };
    let marks = |half: f64| {
        let options =
            SheetOptions { profile_bands: Sides::both(Some((band(half), BandFit::Free))), ..class(5) };
        let inspection = inspection(&MadePart::new("4711", 2));
        let gear = evaluate_inspection(&inspection, None).expect("a gear");
        let data = sheet_data(&inspection, &gear, &options);
        let traces = data.profiles.flanks.iter().flat_map(|(_, field)| &field.traces);
        let passed: Vec<bool> = traces.map(|trace| trace.band.as_ref().expect("a band").passed).collect();
        sheet_pages(&inspection, &gear, &options).expect("pages");
        passed
    };
    assert_eq!((marks(0.020), marks(0.0005)), (vec![true; 6], vec![false; 6]));
}

#[test]
fn infinite_numbers_are_refused_by_name() {
    let inspection = inspection(&MadePart::new("4711", 2));
    let gear = evaluate_inspection(&inspection, None).expect("a gear");
    let mut data = sheet_data(&inspection, &gear, &class(5));
    data.helices.flanks.right.traces[1].f_um[7] = f64::INFINITY;
    let error = drawing::sheet_pages(&data).expect_err("no page");
    assert!(matches!(error, ChartError::InvalidNumber { .. }));
    assert!(error.to_string().contains("tooth 8") && error.to_string().contains("right flank"), "{error}");
}

#[test]
fn the_file_has_a_page_of_paper_for_each_sheet() {
    let directory = tempfile::tempdir().expect("a directory");
    let path = directory.path().join("4711.mka");
    std::fs::write(&path, MadePart::new("4711", 2).text()).expect("a file");
    let found = inspect_gear(&path, &Statements::default(), None).expect("an inspection");
    let html = inspection_sheet(&found, &class(5)).expect("a sheet");
    assert!(html.starts_with("<!DOCTYPE html>") && html.ends_with("</html>\n"));
    assert!(html.contains("@page { size: A4 portrait; margin: 0; }"));
    assert_eq!((html.matches("<div class=\"sheet\">").count(), html.matches("</svg>").count()), (1, 1));
    assert!(!html.contains("<script") && !html.contains("src="));
    assert_eq!(html, inspection_sheet(&found, &class(5)).expect("a sheet"));
}

/// The real parts lie beside the repository, if at all.
#[test]
fn sheets_of_real_parts_print_what_the_machine_printed() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/measurements");
    let path = folder.join("pinion_95911.mka");
    if !path.is_file() {
        eprintln!("not run: {} is not there", path.display());
        return;
    }
    let found = inspect_gear(&path, &Statements::default(), None).expect("an inspection");
    let pages = sheet_pages(&found.inspection, &found.gear, &class(6)).expect("pages");
    let page = pages[0].svg.as_str();
    // As in the .mew file of the part: fHa, F, ff, fKo of tooth 35 left, fHb of tooth 18 left, Fp left, Fr, Rs.
    for value in ["5.2", "1.4", "−23.2", "3.8", "10.6", "11.8", "7.7"] {
        assert!(says(page, value), "{value}");
    }
    assert!(says(page, "16.826") && says(page, "52.174"));
}
