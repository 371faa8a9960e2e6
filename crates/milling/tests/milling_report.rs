//! The page of five-axis milling: every section present, well-formed, and nothing drawn from numbers that are none.

use crate::milling_example::example;
use foundation::numerics::Silent;
use milling::page::html_page;
use milling::workflow::{MillingOutcome, OrientationFigures, run_milling};
use milling::{DensityLimits, DistanceLimits, Lines, Violated};
use nalgebra::Vector3;
use report::charts::{
    ContourMap, Drawing, DrawingLayer, DrawingLook, DrawingNote, MapFrame, MapMark, MapValues,
    NamedTopography, Svg, Topography, contour_map_in, drawing,
};
use std::sync::OnceLock;

/// One space of a narrow spur gear with its root on a machine.
fn spur() -> MillingOutcome {
    static MADE: OnceLock<MillingOutcome> = OnceLock::new();
    let made = || {
        let changes = [
            ("face_width = 60.0", "face_width = 12.0"),
            ("rays_profile = 31\nrays_length = 11", "rays_profile = 13\nrays_length = 9"),
            ("spindle_rpm = 8000.0", "spindle_rpm = 8000.0\nteeth = \"one\""),
            ("tolerance_um = 40.0", "tolerance_um = 1.0"),
        ];
        run_milling(&example("spur-on-ac-table", &changes), &Silent).unwrap_or_else(|e| panic!("{e:?}"))
    };
    MADE.get_or_init(made).clone()
}

/// A bevel gear with few rows and rays, rolled against its mate, without a machine.
fn bevel() -> MillingOutcome {
    static MADE: OnceLock<MillingOutcome> = OnceLock::new();
    let made = || {
        let changes = [
            ("rays_profile = 81\nrays_length = 31", "rays_profile = 9\nrays_length = 7"),
            ("rows = 14", "rows = 6"),
            ("columns = 15", "columns = 9"),
            ("spindle_rpm = 18000.0", "spindle_rpm = 18000.0\nteeth = \"one\""),
        ];
        run_milling(&example("straight-bevel-16", &changes), &Silent).unwrap_or_else(|e| panic!("{e:?}"))
    };
    MADE.get_or_init(made).clone()
}

fn page(outcome: &MillingOutcome) -> String {
    html_page(outcome, &[("result.json".into(), "result with rows and flanks")]).unwrap()
}

/// A section of a page, from its heading to the next one.
fn section<'a>(page: &'a str, heading: &str) -> &'a str {
    let from = page.find(&format!("<h2>{heading}</h2>")).unwrap_or_else(|| panic!("{heading}"));
    let rest = &page[from + 4..];
    rest.split("<h2>").next().unwrap()
}

/// Every chart of a page is XML that holds numbers only.
fn assert_well_formed(page: &str) -> usize {
    let mut charts = 0;
    let mut rest = page;
    while let Some(from) = rest.find("<svg ") {
        let to = from + rest[from..].find("</svg>").unwrap() + "</svg>".len();
        let tree = roxmltree::Document::parse(&rest[from..to]).expect("well-formed");
        for attribute in tree.descendants().flat_map(|node| node.attributes()) {
            for wrong in ["NaN", "inf"] {
                assert!(!attribute.value().contains(wrong), "{wrong} in {}", attribute.name());
            }
        }
        charts += 1;
        rest = &rest[to..];
    }
    charts
}

#[test]
fn the_page_is_complete() {
    let outcome = spur();
    let text = page(&outcome);
    for heading in [
        "Flanks",
        "Scope of the verdict",
        "Workpiece, cutter and paths",
        "Deviations",
        "Rows",
        "Wear of the edge",
        "Density",
        "Root",
        "Operations",
        "Orientation of the cutter",
        "Programs",
        "Files",
    ] {
        assert!(text.contains(&format!("<h2>{heading}</h2>")), "{heading}");
    }
    for part in [
        "Remedy: lay more rows",
        "Tolerance 1 µm",
        "greatest allowed",
        "one height for all rows",
        "end mill 6 mm, corner radius 1.5 mm",
        "Read back by a reader that shares no code with the writer",
        "Cycle times: ",
        "result with rows and flanks",
    ] {
        assert!(text.contains(part), "{part}");
    }
    for program in &outcome.result.programs {
        assert!(text.contains(&program.file), "{}", program.file);
    }
    // A map on the first page; three views, two maps, two sections, two charts of rows, wear, root, both flanks' rotary axes, axes of the space and of a row.
    assert_eq!(assert_well_formed(&text), 16);
    assert_eq!(text, page(&spur()));
}

#[test]
fn the_page_of_a_bevel_gear_shows_its_contact_and_no_program() {
    let outcome = bevel();
    let text = page(&outcome);
    let mate = section(&text, "Contact with the mate");
    let flank = &outcome.result.mate.as_ref().unwrap().flanks["left"];
    let common = format!("{} % are common", report::charts::format_fixed(flank.overlap_percent, 1));
    for part in [common.as_str(), "teeth of the mate", "Transmission error", "Left flank", "Right flank"] {
        assert!(mate.contains(part), "{part}");
    }
    // Two patterns for each flank, wanted and as milled, and the transmission error of both.
    assert_eq!(assert_well_formed(mate), 5);
    for absent in ["<h2>Root", "<h2>Programs"] {
        assert!(!text.contains(absent), "{absent}");
    }
}

#[test]
fn absent_data_leave_no_section() {
    let mut outcome = bevel();
    outcome.mate = None;
    outcome.orientations.clear();
    outcome.result.warnings.clear();
    outcome.result.flanks.remove("right");
    let left = outcome.result.flanks.get_mut("left").unwrap();
    left.wear = None;
    left.rows.iter_mut().for_each(|row| row.allowed_mm = None);
    let text = page(&outcome);
    for absent in [
        "<h2>Contact with the mate",
        "<h2>Orientation",
        "<h2>Warnings",
        "<h2>Wear",
        "least allowed",
        "Right flank",
    ] {
        assert!(!text.contains(absent), "{absent}");
    }
    // A map on the first page; three views, a map, two sections, two charts of rows.
    assert_eq!(assert_well_formed(&text), 9);
}

#[test]
fn orientations_are_told_side_by_side() {
    let mut outcome = bevel();
    let compared = &mut outcome.orientations[0];
    for (figures, travel, lean) in
        [(&mut compared.result.column, [40.0, 2.0], 4.0), (&mut compared.result.iso, [67.0, 1.0], 16.0)]
    {
        let OrientationFigures::Reached(figures) = figures else { panic!("reached") };
        (figures.travel_deg, figures.lean_deg) = (travel, [-lean, 0.5 * lean]);
    }
    compared.result.sheared = OrientationFigures::not_reached("beyond the travel of A".into());
    outcome.orientations.truncate(1);
    let told = page(&outcome);
    let told = section(&told, "Orientation of the cutter");
    assert!(told.contains("42.00° along the row, 26.00° less than"), "{told}");
    assert!(told.contains("at most 4.00° instead of 16.00°"), "{told}");
    assert!(told.contains("does not generally save rotary motion"));
    assert!(told.contains("beyond the travel of A"));
    // What the machine does not reach has no line.
    let chart = told.split("<svg").nth(1).unwrap();
    assert!(chart.contains("along the parameter lines") && !chart.contains("sheared"));
    let result = &mut outcome.orientations[0].result;
    result.iso = result.column.clone();
    assert!(page(&outcome).contains("as much as with the axis along the parameter lines"));
    outcome.orientations[0].result.column = OrientationFigures::not_reached("beyond".into());
    assert!(page(&outcome).contains("not all orientations are within reach of the machine"));
}

#[test]
fn limits_of_distances_are_told_with_whether_they_are_kept() {
    let mut outcome = bevel();
    let row = DistanceLimits { greatest: Some(9.0), least: Some(8.0), ..DistanceLimits::default() };
    let limits = DensityLimits { row, column: DistanceLimits::default() };
    outcome.prepared.bodies.options.lines = Lines::Limited { limits, scallop: None, chord: None };
    outcome.plan.flanks[0].lines.dense.violated =
        vec![Violated { name: "row_min", measured: 2.0, limit: 8.0 }];
    let text = page(&outcome);
    let density = section(&text, "Density");
    let line = |name: &str| density.split("<tr>").find(|row| row.contains(name)).unwrap().to_owned();
    let (least, greatest) = (line("along rows, least<"), line("along rows, greatest<"));
    assert!(least.contains("NO") && least.contains("yes"), "{least}");
    assert!(greatest.contains("yes") && !greatest.contains("NO"), "{greatest}");
    assert!(!line("along columns, least<").contains("yes"));
}

/// Heights of internal gears fall from root to tip: the map is the same, its coordinate ascends.
#[test]
fn falling_heights_are_turned_over() {
    let mut outcome = bevel();
    let whole = assert_well_formed(&page(&outcome));
    outcome.result.flanks.values_mut().for_each(|flank| flank.height.reverse());
    assert_eq!(assert_well_formed(&page(&outcome)), whole);
}

/// The pattern ends where the mate ends, and is drawn on the developed flank.
#[test]
fn the_contact_pattern_is_drawn_where_the_gap_is_small() {
    let drawn = |outcome: &MillingOutcome| {
        let text = page(outcome);
        let mut charts = text.split("<svg ").skip(1).filter_map(|svg| svg.split("</svg>").next());
        charts.find(|svg| svg.contains("contact pattern")).unwrap().to_owned()
    };
    let mut other = bevel();
    let whole = drawn(&other);
    for word in ["root", "tip", "toe", "heel", "centre", "rolled", "by the ease-offs", "[mm]"] {
        assert!(whole.contains(word), "{word}");
    }
    other.mate.as_mut().unwrap().flanks[0].gaps[0].gaps.fill(f64::INFINITY);
    assert!(drawn(&other).len() < whole.len());
    other.mate.as_mut().unwrap().result.mean_pitch_radius_mm = f64::NAN;
    assert_eq!(html_page(&other, &[]).unwrap_err().code(), "invalid-number");
}

#[test]
fn the_worst_place_is_marked_and_a_hole_crossed_out() {
    let mut outcome = bevel();
    let left = outcome.result.flanks.get_mut("left").unwrap();
    left.simulated_um[23] = Some(-45.67);
    left.simulated_um[4] = None;
    left.unmilled.insert("no cutter comes by".into(), 1);
    let at = left.length[23 % left.length.len()];
    let text = page(&outcome);
    assert!(text.contains(">−45.7</text>"));
    assert!(text.contains("1 (no cutter comes by)"));
    let at = report::charts::format_significant(at, 4);
    assert!(text.contains(&format!("at distance from the apex [mm] = {at}")), "{at}");
}

#[test]
fn numbers_that_are_none_are_refused() {
    let refused = |change: &dyn Fn(&mut MillingOutcome)| {
        let mut outcome = bevel();
        change(&mut outcome);
        html_page(&outcome, &[]).err().map_or("accepted", |error| error.code())
    };
    assert_eq!(
        refused(&|made| made.result.flanks.get_mut("left").unwrap().simulated_um[7] = Some(f64::NAN)),
        "invalid-number"
    );
    assert_eq!(
        refused(&|made| made.result.flanks.get_mut("right").unwrap().rows[2].chord_um = f64::INFINITY),
        "invalid-number"
    );
    assert_eq!(
        refused(&|made| made.plan.operations[0].paths[0].places[0].contact = Some(Vector3::repeat(f64::NAN))),
        "invalid-number"
    );
    assert_eq!(refused(&|made| made.result.flanks.get_mut("left").unwrap().height[3] = 0.0), "not-ascending");
}

/// A drawing with a cutter of 10 mm by 20 mm.
fn view(axes: Option<[String; 2]>) -> Drawing {
    let layer = |name: &str, look, lines_mm| DrawingLayer { name: name.into(), look, lines_mm };
    Drawing {
        title: "view".into(),
        subtitle: "one space".into(),
        axes,
        layers: vec![
            layer(
                "cutter",
                DrawingLook::Body,
                vec![vec![[0.0, 0.0], [10.0, 0.0], [10.0, 20.0], [0.0, 20.0]]],
            ),
            layer("flank", DrawingLook::Net, vec![vec![[0.0, 5.0], [4.0, 15.0]]]),
            layer("left flank", DrawingLook::Path(1), vec![vec![[2.0, 5.0], [2.0, 9.0]], vec![]]),
        ],
        notes: vec![DrawingNote { at_mm: [5.0, 5.0], text: "lowest place".into() }],
    }
}

#[test]
fn drawings_of_no_numbers_are_refused() {
    let refused = |change: &dyn Fn(&mut Drawing)| {
        let mut shown = view(None);
        change(&mut shown);
        drawing(&shown).expect_err("refused").code()
    };
    assert_eq!(refused(&|shown| shown.layers[1].lines_mm[0][0][1] = f64::NAN), "invalid-number");
    assert_eq!(refused(&|shown| shown.notes[0].at_mm[0] = f64::NAN), "invalid-number");
    assert_eq!(refused(&|shown| shown.layers.clear()), "too-few-values");
}

/// Width and height of the body in a drawing that has one.
fn rectangle(svg: &Svg) -> [f64; 2] {
    let document = svg.to_document();
    let tree = roxmltree::Document::parse(&document).unwrap();
    let bodies: Vec<_> = tree.descendants().filter(|n| n.attribute("fill") == Some("#e8edf2")).collect();
    assert_eq!(bodies.len(), 2, "one in the legend, one in the drawing");
    let path = bodies[1].attribute("d").unwrap();
    let numbers: Vec<f64> =
        path.split(['M', 'L', 'Z', ' ']).filter(|t| !t.is_empty()).map(|t| t.parse().unwrap()).collect();
    let span = |k: usize| {
        let of = || numbers.iter().skip(k).step_by(2).copied();
        of().fold(f64::NEG_INFINITY, f64::max) - of().fold(f64::INFINITY, f64::min)
    };
    [span(0), span(1)]
}

/// The cutter of 10 mm by 20 mm is twice as high as it is wide, with and without axes.
#[test]
fn both_directions_of_a_drawing_have_the_same_scale() {
    for axes in [None, Some(["x [mm]".to_owned(), "y [mm]".to_owned()])] {
        let [width, height] = rectangle(&drawing(&view(axes)).unwrap());
        assert!((height - 2.0 * width).abs() < 0.02 && width > 50.0, "{width} by {height}");
    }
}

#[test]
fn a_mark_that_is_nowhere_is_refused() {
    let field = Topography::new(vec![0.0, 1.0], vec![0.0, 1.0], vec![vec![0.0, 1.0]; 2]).unwrap();
    let map = ContourMap {
        title: "map".into(),
        quantity: "f_n [µm]".into(),
        panels: vec![NamedTopography::new("flank", field)],
        scale: None,
    };
    let marked = |at| {
        let marks = vec![vec![MapMark { at, text: "worst".into() }]];
        contour_map_in(
            &map,
            &MapFrame {
                titles: ["z [mm]".into(), "roll angle [rad]".into()],
                marks,
                values: MapValues::Deviation,
            },
        )
    };
    let svg = marked([0.5, 0.5]).unwrap();
    assert!(svg.as_str().contains("worst") && svg.as_str().contains("roll angle [rad]"));
    assert_eq!(marked([f64::NAN, 0.5]).unwrap_err().code(), "invalid-number");
}
