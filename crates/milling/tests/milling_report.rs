//! The page of five-axis milling: every section present, well-formed, and nothing drawn from numbers that are none.

use milling::page::{
    AxisCourse, CourseChart, CourseLine, DensityRow, FlankFigures, FlankView, MateFlankView, MateView,
    MillingReport, OperationRow, OrientationView, OrientedRowView, PatternFigures, ProgramsView, RotaryView,
    RowView, SpaceView, Titled, WearView,
};
use report::charts::{
    ChartError, ContourMap, Drawing, DrawingLayer, DrawingLook, DrawingNote, MapFrame, MapMark,
    NamedTopography, Svg, Topography, contour_map_in, drawing,
};
use report::{Column, PlanReport, Quantity, ReportHead, Table, Warning, html};
use verdict::{Status, Verdict};

const HEIGHTS: usize = 13;
const LENGTHS: usize = 9;

fn spread(from: f64, to: f64, count: usize) -> Vec<f64> {
    (0..count).map(|k| from + (to - from) * k as f64 / (count - 1) as f64).collect()
}

/// Scallops of four rows, and a place that no cutter comes by.
fn flank(name: &str, heights: [f64; 2]) -> FlankView {
    let height = spread(heights[0], heights[1], HEIGHTS);
    let um = |k: usize| 2.0 * (0.25 * std::f64::consts::PI * (k / LENGTHS) as f64).sin().abs();
    let planned_um: Vec<Option<f64>> = (0..HEIGHTS * LENGTHS).map(|k| Some(um(k))).collect();
    let mut simulated_um: Vec<Option<f64>> = planned_um.iter().map(|um| um.map(|um| um + 0.01)).collect();
    simulated_um[4] = None;
    let row = |k: usize| RowView {
        scallop_um: (k < 3).then_some(2.0),
        chord_um: -0.1 * k as f64,
        out_of_plane_deg: 0.2 * k as f64,
        axis_out_of_plane_deg: 0.0,
        contact_height_mm: 4.0 + k as f64,
        allowed_mm: Some([2.0, 9.0]),
    };
    FlankView {
        name: name.into(),
        height_title: "length of roll w [mm]".into(),
        length_title: "z [mm]".into(),
        height,
        length: spread(-10.0, 10.0, LENGTHS),
        planned_um,
        simulated_um,
        figures: FlankFigures {
            max_um: 2.01,
            rms_um: 1.2,
            least_um: 0.01,
            greatest_um: 2.01,
            model_difference_um: 0.01,
            referee_error_um: 0.001,
        },
        unmilled: vec![("no cutter comes by".into(), 1)],
        rows: (0..4).map(row).collect(),
        wear: Some(WearView {
            bin_mm: 0.5,
            load_m_per_mm: vec![0.0, 0.1, 0.1],
            fixed_m_per_mm: vec![0.0, 0.2, 0.0],
            peak_over_fixed: 0.5,
            spread_mm: 1.0,
        }),
        density: vec![
            DensityRow {
                name: "along rows, least".into(),
                measured_mm: 0.7,
                limit_mm: Some(0.8),
                violated: true,
            },
            DensityRow {
                name: "along rows, greatest".into(),
                measured_mm: 1.5,
                limit_mm: Some(2.0),
                violated: false,
            },
        ],
    }
}

fn view(title: &str) -> Drawing {
    let layer = |name: &str, look, lines_mm| DrawingLayer { name: name.into(), look, lines_mm };
    Drawing {
        title: title.into(),
        subtitle: "one space".into(),
        axes: Some(["x [mm]".into(), "y [mm]".into()]),
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

fn report() -> MillingReport {
    let time: Vec<f64> = spread(0.0, 60.0, 5001);
    let mut angle: Vec<f64> = time.iter().map(|t| t.sin()).collect();
    angle[777] = 7.5;
    MillingReport {
        head: ReportHead {
            job_name: "spur".into(),
            description: Some("a spur gear".into()),
            process: "Five-axis milling",
            version: "0.1.0".into(),
            status: Status::Missed.into(),
            headline: "the flank deviates by 2.01 um.".into(),
            way_out: "lay more rows".into(),
            figures: vec![("largest deviation".into(), "2.01 µm".into())],
            warnings: vec![Warning { text: "row_min cannot be kept".into(), way_out: "relax it".into() }],
            files: vec![("result.json".into(), "result".into())],
        },
        verdict: Verdict::new(),
        tolerance_um: 1.0,
        bodies: vec![Quantity::count("spaces", "z", 20)],
        views: vec![
            SpaceView { id: "along-the-axis", drawing: view("The space along the axis") },
            SpaceView { id: "oblique", drawing: Drawing { axes: None, ..view("The space, oblique view") } },
        ],
        flanks: vec![flank("Left flank", [10.0, 30.0]), flank("Right flank", [10.0, 30.0])],
        root: Some(Titled {
            drawing: view("Root in the column plane"),
            caption: "fillet".into(),
            quantities: vec![Quantity::number("straight piece", "h_b", 4.76, "mm")],
        }),
        mate: Some(mate()),
        operations: vec![OperationRow {
            name: "left flank".into(),
            cutter: "end mill 6 mm".into(),
            paths: 14,
            places: 350,
            way_mm: 840.0,
        }],
        orientations: vec![orientation()],
        programs: Some(ProgramsView {
            proof: vec!["The texts were read back.".into()],
            remarks: vec!["C is turned back twice.".into()],
            courses: vec![CourseChart {
                id: "axes-over-time".into(),
                title: "Axes over time".into(),
                caption: String::new(),
                axes: vec![AxisCourse {
                    name: "A".into(),
                    unit: "deg".into(),
                    lines: vec![CourseLine { name: "program".into(), time_s: time, value: angle }],
                }],
            }],
            cycle_times: vec![Table {
                caption: "Cycle times".into(),
                columns: vec![Column::text("Operation"), Column::number("Time", "s")],
                rows: vec![vec!["left flank".into(), "60".into()]],
                note: String::new(),
            }],
        }),
    }
}

/// A pattern of 2 mm round the middle of a flank of 10 mm by 6 mm; at one end the mate never comes by.
fn mate() -> MateView {
    let place = |i: usize, j: usize| [j as f64, i as f64];
    let gap = |i: usize, j: usize| {
        let [x, y] = place(i, j);
        (j < 10).then(|| 1.5 * ((x - 5.0).powi(2) + (y - 3.0).powi(2)))
    };
    let rows = |value: &dyn Fn(usize, usize) -> Option<f64>| -> Vec<Vec<Option<f64>>> {
        (0..7).map(|i| (0..11).map(|j| value(i, j)).collect()).collect()
    };
    let pattern =
        PatternFigures { area: 20.9, centre: [50.0, 50.0], length: [30.0, 70.0], height: [16.7, 83.3] };
    MateView {
        quantities: vec![Quantity::count("teeth of the mate", "z_2", 24)],
        marking_um: 6.0,
        flanks: vec![MateFlankView {
            name: "Left flank".into(),
            places_mm: (0..7).map(|i| (0..11).map(|j| place(i, j)).collect()).collect(),
            rolled_um: rows(&gap),
            ease_off_um: rows(&|i, j| gap(i, j).map(|um| 1.1 * um)),
            centre_mm: Some([5.0, 3.0]),
            roll_deg: spread(-30.0, 30.0, 61),
            transmission_um: (0..61).map(|k| -0.05 * f64::from(k % 20 - 10).powi(2)).collect(),
            transmission_ease_off_um: vec![-1.0; 61],
            patterns: [Some(pattern), None],
            overlap_percent: 90.9,
            peak_to_peak: [12.3, 4.56],
        }],
    }
}

/// A row on which the column plane saves 26 degrees, and one that the machine does not reach.
fn orientation() -> OrientationView {
    let figures = |travel: [f64; 2], lean: f64| RotaryView {
        travel_deg: travel,
        second: [0.02, 0.0],
        reversals: [0, 1],
        lean_deg: [-lean, 0.5 * lean],
    };
    let row = |name: &str, figures: Result<RotaryView, String>| OrientedRowView {
        name: name.into(),
        figures,
        arc_mm: vec![0.0, 10.0, 20.0],
        angles_deg: [vec![0.0, 20.0, 40.0], vec![80.0, 81.0, 80.0]],
    };
    OrientationView {
        flank: "Left flank".into(),
        machine: "the machine mill".into(),
        axes: ["C".into(), "A".into()],
        rows: vec![
            row("in the column planes", Ok(figures([40.0, 2.0], 4.0))),
            row("along the parameter lines", Ok(figures([67.0, 1.0], 16.0))),
            row("along lines sheared by 2 % of the face", Err("beyond the travel of A".into())),
        ],
    }
}

#[test]
fn orientations_are_told_side_by_side() {
    let told = page(&report());
    let section = told.split("<h2>Orientation of the cutter").nth(1).unwrap().split("<h2>").next().unwrap();
    assert!(section.contains("42.00° along the row, 26.00° less than"), "{section}");
    assert!(section.contains("at most 4.00° instead of 16.00°"), "{section}");
    assert!(section.contains("does not generally save rotary motion"));
    assert!(section.contains("beyond the travel of A"));
    // What the machine does not reach has no line.
    let chart = section.split("<svg").nth(1).unwrap();
    assert!(chart.contains("along the parameter lines") && !chart.contains("sheared"));
    let mut alike = report();
    alike.orientations[0].rows[1] = alike.orientations[0].rows[0].clone();
    assert!(page(&alike).contains("as much as with the axis along the parameter lines"));
    let mut out_of_reach = report();
    out_of_reach.orientations[0].rows[0].figures = Err("beyond".into());
    assert!(page(&out_of_reach).contains("not all orientations are within reach of the machine mill"));
}

fn page(report: &MillingReport) -> String {
    html::render(&report.to_page().unwrap())
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
    let text = page(&report());
    for heading in [
        "Warnings",
        "Flanks",
        "Workpiece, cutter and paths",
        "Deviations",
        "Rows",
        "Wear of the edge",
        "Density",
        "Root",
        "Contact with the mate",
        "Operations",
        "Programs",
        "Files",
    ] {
        assert!(text.contains(&format!("<h2>{heading}</h2>")), "{heading}");
    }
    for part in [
        "Remedy: lay more rows.",
        "Remedy: relax it",
        "no cutter comes by",
        "Tolerance 1 µm",
        "greatest allowed",
        "one height for all rows",
        "<td>NO</td>",
        "The texts were read back.",
        "90.9 % are common",
        "30.0 to 70.0",
        "12.3",
    ] {
        assert!(text.contains(part), "{part}");
    }
    // Two views, two maps, two sections, two charts of rows, wear, root, pattern, transmission error, orientation, axes.
    assert_eq!(assert_well_formed(&text), 14);
    assert_eq!(text, page(&report()));
}

#[test]
fn absent_data_leave_no_section() {
    let mut report = report();
    (report.root, report.mate, report.programs, report.head.warnings) = (None, None, None, vec![]);
    report.orientations.clear();
    for flank in &mut report.flanks {
        (flank.wear, flank.density) = (None, vec![]);
        for row in &mut flank.rows {
            row.allowed_mm = None;
        }
    }
    report.flanks.pop();
    let text = page(&report);
    for absent in [
        "<h2>Root",
        "<h2>Contact with the mate",
        "<h2>Orientation",
        "<h2>Programs",
        "<h2>Warnings",
        "<h2>Wear",
        "<h2>Density",
        "least allowed",
        "Right flank",
    ] {
        assert!(!text.contains(absent), "{absent}");
    }
    assert_eq!(assert_well_formed(&text), 7);
}

/// Heights of internal gears fall from root to tip: the map is the same, its coordinate ascends.
#[test]
fn falling_heights_are_turned_over() {
    let mut report = report();
    report.flanks = vec![flank("Left flank", [30.0, 10.0])];
    assert_eq!(assert_well_formed(&page(&report)), 13);
}

/// The pattern is a closed ring of 2 mm about its centre, in the scale of the drawing, and ends where the mate ends.
#[test]
fn the_contact_pattern_is_drawn_where_the_gap_is_small() {
    let ring = |report: &MillingReport| {
        let text = page(report);
        let mut drawn = text.split("<svg ").skip(1).filter_map(|svg| svg.split("</svg>").next());
        drawn.find(|svg| svg.contains("contact pattern")).unwrap().to_owned()
    };
    let mut other = report();
    let whole = ring(&other);
    for word in ["root", "tip", "toe", "heel", "centre", "rolled", "by the ease-offs", "[mm]"] {
        assert!(whole.contains(word), "{word}");
    }
    other.mate.as_mut().unwrap().flanks[0].rolled_um.iter_mut().flatten().for_each(|gap| *gap = None);
    assert!(ring(&other).len() < whole.len());
    other.mate.as_mut().unwrap().flanks[0].transmission_um[7] = f64::NAN;
    assert_eq!(other.to_page().unwrap_err().code(), "invalid-number");
}

#[test]
fn the_worst_place_is_marked_and_a_hole_crossed_out() {
    let mut report = report();
    report.flanks.truncate(1);
    report.flanks[0].simulated_um[60] = Some(-4.567);
    let text = page(&report);
    assert!(text.contains(">−4.57</text>"));
    let at = report.flanks[0].length[60 % LENGTHS];
    assert!(text.contains(&format!("at z [mm] = {}", format!("{at}").replace('-', "−"))), "{at}");
}

/// Thinning of long lines keeps their peaks.
#[test]
fn a_peak_of_an_axis_stays_in_its_chart() {
    let axis = |text: &str| {
        let from = text.find("Axes over time").unwrap();
        text[from..].split("</svg>").next().unwrap().to_owned()
    };
    let mut low = report();
    low.programs.as_mut().unwrap().courses[0].axes[0].lines[0].value[777] = 0.0;
    assert!(axis(&page(&report())).contains(">8</text>"));
    assert!(!axis(&page(&low)).contains(">8</text>"));
}

#[test]
fn numbers_that_are_none_are_refused() {
    let refused = |change: &dyn Fn(&mut MillingReport)| {
        let mut report = report();
        change(&mut report);
        let made: Result<PlanReport, ChartError> = report.to_page();
        made.expect_err("refused").code()
    };
    assert_eq!(refused(&|report| report.flanks[0].simulated_um[7] = Some(f64::NAN)), "invalid-number");
    assert_eq!(refused(&|report| report.flanks[1].rows[2].chord_um = f64::INFINITY), "invalid-number");
    assert_eq!(
        refused(&|report| report.views[0].drawing.layers[1].lines_mm[0][0][1] = f64::NAN),
        "invalid-number"
    );
    assert_eq!(refused(&|report| report.views[0].drawing.notes[0].at_mm[0] = f64::NAN), "invalid-number");
    assert_eq!(refused(&|report| report.views[0].drawing.layers.clear()), "too-few-values");
    assert_eq!(refused(&|report| report.flanks[0].height[3] = 0.0), "not-ascending");
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
        let [width, height] = rectangle(&drawing(&Drawing { axes, ..view("view") }).unwrap());
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
            &MapFrame { titles: ["z [mm]".into(), "roll angle [rad]".into()], marks, grounds_only: false },
        )
    };
    let svg = marked([0.5, 0.5]).unwrap();
    assert!(svg.as_str().contains("worst") && svg.as_str().contains("roll angle [rad]"));
    assert_eq!(marked([f64::NAN, 0.5]).unwrap_err().code(), "invalid-number");
}
