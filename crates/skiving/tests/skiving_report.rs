//! The page of a skiving tool's measurement: every section present, well-formed, readable without colour, and nothing drawn from
//! numbers that are none.

use crate::skiving_report_sample::{BROKEN, OUTLIER, PLACES, TEETH, report};
use foundation::geometry::{Flank, Sides};
use report::charts::{ChartError, LineChart, LineFrame, Marks, Panel, Series, Svg, line_chart_in};
use report::{Block, PlanReport, Section, Table, html};
use skiving::page::{SkivingReport, ToothMark};

const SECTIONS: [&str; 16] = [
    "Warnings",
    "Measured deviations",
    "Angles of the edges",
    "Signal over one turn",
    "Concentricity",
    "Pitch",
    "Tooth and contact points",
    "Measuring poses",
    "Profile of the workpiece",
    "Corrections",
    "Comparison with the conventional method",
    "History",
    "Monte Carlo",
    "Tool, workpiece and measurement",
    "Programs",
    "Files",
];

fn page(report: &SkivingReport) -> PlanReport {
    report.to_page().expect("finite numbers")
}

fn section<'a>(page: &'a PlanReport, title: &str) -> &'a Section {
    page.sections.iter().find(|section| section.title == title).expect(title)
}

fn charts(section: &Section) -> Vec<&Svg> {
    let figures = section.blocks.iter().filter_map(|block| match block {
        Block::Figure(figure) => Some(&figure.svg),
        _ => None,
    });
    figures.collect()
}

fn tables(section: &Section) -> Vec<&Table> {
    section
        .blocks
        .iter()
        .flat_map(|block| match block {
            Block::Table(table) => std::slice::from_ref(table),
            Block::Tables(tables) => tables.as_slice(),
            _ => &[],
        })
        .collect()
}

/// All text of a chart; panics if it is not well-formed or holds what is no number.
fn text_of(svg: &Svg) -> String {
    let document = svg.to_document();
    let tree = roxmltree::Document::parse(&document).expect("well-formed");
    for node in tree.descendants().filter(|node| node.is_element()) {
        for attribute in node.attributes() {
            for wrong in ["NaN", "inf"] {
                assert!(!attribute.value().contains(wrong), "{wrong} in {}", attribute.name());
            }
        }
    }
    tree.descendants().filter(|node| node.is_text()).filter_map(|node| node.text()).collect()
}

fn assert_holds(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "\"{part}\" is missing in: {text}");
    }
}

#[test]
fn every_section_stands_in_its_order_and_every_chart_is_well_formed() {
    let page = page(&report());
    let titles: Vec<&str> = page.sections.iter().map(|section| section.title.as_str()).collect();
    assert_eq!(titles, SECTIONS);
    let mut count = 0;
    for section in &page.sections {
        for svg in charts(section) {
            let text = text_of(svg);
            assert!(text.contains('['), "no unit in {text}");
            count += 1;
        }
    }
    assert_eq!(count, 12);
}

#[test]
fn the_same_data_give_the_same_bytes() {
    let write = || html::render(&page(&report()));
    let first = write();
    assert_eq!(first, write());
    assert!(first.len() > 50_000, "{}", first.len());
}

#[test]
fn what_is_missing_is_left_out() {
    let full = report();
    let bare = SkivingReport {
        measured: None,
        angles: Vec::new(),
        strip: None,
        pitch: None,
        tooth: None,
        edge_sections: Vec::new(),
        profile: None,
        corrections: None,
        conventional: Vec::new(),
        history: None,
        monte_carlo: None,
        sheets: Vec::new(),
        programs: None,
        ..full
    };
    let titles: Vec<String> = page(&bare).sections.into_iter().map(|section| section.title).collect();
    assert_eq!(titles, ["Warnings", "Measuring poses", "Files"]);
}

#[test]
fn tracks_are_named_and_the_tooth_that_stands_out_is_ringed() {
    let page = page(&report());
    let deviations = charts(section(&page, "Measured deviations"));
    for svg in &deviations[..2] {
        let text = text_of(svg);
        for track in 1..=PLACES.len() {
            assert_holds(&text, &[&format!("track {track}")]);
        }
        assert_holds(&text, &["Left flank: deviation [µm]", "Right flank: deviation [µm]"]);
    }
    assert!(!text_of(deviations[0]).contains("tooth 6"));
    assert_holds(&text_of(deviations[1]), &["± D/2", "tooth to look at", "tooth 6", "tooth 26"]);
    // One ring in the legend and one for each tooth of the table, drawn on top of the lines.
    assert_eq!(deviations[1].as_str().matches("r=\"6.5\" fill=\"none\"").count(), 3);
    let worst = tables(section(&page, "Measured deviations"))[0];
    assert_eq!(worst.rows[0][..3], [OUTLIER.to_string(), "right".to_owned(), "1".to_owned()]);
}

#[test]
fn the_angle_chart_says_how_much_it_magnifies() {
    let page = page(&report());
    let angles = section(&page, "Angles of the edges");
    assert_holds(
        &text_of(charts(angles)[0]),
        &["compensation curve", "tolerance band D", "measured tooth centre", "Left flank", "deg", "mm"],
    );
    let Block::Figure(figure) = &angles.blocks[0] else { panic!("a figure first") };
    assert_holds(&figure.caption, &["drawn 20 times as large", "D = 12 µm"]);
    assert_eq!(tables(angles)[0].rows.len(), 2 * PLACES.len());
}

#[test]
fn a_tooth_without_measurement_has_its_nominal_edges_only() {
    let mut nominal = report();
    for flank in Flank::BOTH {
        let side = &mut nominal.angles[0].edges[flank];
        side.tracks.iter_mut().for_each(|track| track.measured_deg = None);
        side.stations.iter_mut().for_each(|at| (at.curve_deg, at.half_band_deg) = (None, None));
    }
    let page = page(&nominal);
    let text = text_of(charts(section(&page, "Angles of the edges"))[0]);
    assert_holds(&text, &["nominal edges and middle"]);
    assert!(!text.contains("measured") && !text.contains("tolerance"), "{text}");
}

#[test]
fn the_strip_has_every_tooth_and_tells_broken_ones_by_a_sign() {
    let whole = report();
    let page = page(&whole);
    let svg = charts(section(&page, "Signal over one turn"))[0].as_str().to_owned();
    for tooth in 0..TEETH {
        assert!(svg.contains(&format!(">{tooth}</text>")), "{tooth}");
    }
    let mut sound = whole.clone();
    for signal in &mut sound.strip.as_mut().expect("a strip").teeth {
        if signal.tooth == BROKEN {
            assert_eq!(signal.mark, Some(ToothMark::Broken));
        }
        signal.mark = None;
    }
    let without = sound.to_page().expect("finite numbers");
    let without = charts(section(&without, "Signal over one turn"))[0].as_str();
    assert!(svg.matches("font-weight").count() == without.matches("font-weight").count() + 2);
}

#[test]
fn the_comparison_says_where_the_conventional_beam_is_blind() {
    let page = page(&report());
    let comparison = section(&page, "Comparison with the conventional method");
    let table = tables(comparison)[0];
    for row in &table.rows {
        let blind = row[0] == "right";
        assert_eq!(row[3] == "beam rests on the body", blind, "{row:?}");
        assert_eq!(row[4] == "–", blind, "{row:?}");
    }
    assert!(matches!(&comparison.blocks[1], Block::Paragraph(text) if text.starts_with("On 5 of 10 tracks")));
}

#[test]
fn verdicts_are_words() {
    let page = page(&report());
    let tables = tables(section(&page, "Corrections"));
    let last =
        |table: &Table| -> Vec<String> { table.rows.iter().filter_map(|row| row.last().cloned()).collect() };
    assert_eq!(last(tables[0]), ["no", "YES", "no"]);
    assert_holds(&tables[0].note, &["1.448 µm before", "0.589 µm after"]);
    assert_eq!(last(tables[1]), ["no", "YES"]);
}

#[test]
fn the_forecast_is_ringed_and_a_missing_measurement_is_a_dash() {
    let page = page(&report());
    let history = section(&page, "History");
    assert_holds(&text_of(charts(history)[0]), &["657 parts", "524 parts", "fitted line", "limit"]);
    let table = tables(history)[0];
    assert_eq!(table.rows[3][3], "–");
    assert_holds(&table.note, &["Left flank: limit at 657 parts ± 31"]);
}

#[test]
fn an_edge_section_shows_its_angles_chamfers_and_the_beam() {
    let page = page(&report());
    let charts = charts(section(&page, "Tooth and contact points"));
    assert_holds(&text_of(charts[0]), &["L1", "L5", "R1", "R5", "x [mm]"]);
    let (plain, chamfered) = (text_of(charts[1]), text_of(charts[2]));
    assert_holds(&plain, &["light beam", "contact θ", "conventional"]);
    assert!(!plain.contains("chamfer") && chamfered.contains("chamfer"));
    assert!(!chamfered.contains("conventional"));
}

/// Each spoils one number of the page.
type Spoil = fn(&mut SkivingReport);

#[test]
fn a_value_that_is_no_number_is_refused_in_every_section() {
    let spoils: [(&str, Spoil); 13] = [
        ("measured", |r| first(r, |m| m.measured_um[3] = f64::NAN)),
        ("remaining", |r| first(r, |m| m.remaining_um[3] = f64::INFINITY)),
        ("angles", |r| r.angles[0].edges.left.tracks[1].measured_deg = Some(f64::NAN)),
        ("strip", |r| r.strip.iter_mut().for_each(|s| s.teeth[4].middle_deg = f64::NAN)),
        ("pitch", |r| r.pitch.iter_mut().for_each(|p| p.harmonic_um[1] = f64::NAN)),
        ("tooth", |r| r.tooth.iter_mut().for_each(|t| t.edges_mm.right[2][0] = f64::NAN)),
        ("edge section", |r| r.edge_sections[0].contact_deg = f64::NAN),
        ("poses", |r| r.poses[7].position_mm[2] = f64::NAN),
        ("profile", |r| r.profile.iter_mut().for_each(|p| p.flanks.left.simulated[0][1] = f64::NAN)),
        ("corrections", |r| r.corrections.iter_mut().for_each(|c| c.rms_um = Some([1.0, f64::NAN]))),
        ("conventional", |r| r.conventional[2].virtual_um = f64::NAN),
        ("history", |r| r.history.iter_mut().for_each(|h| h.measurements[1].parts = f64::NAN)),
        ("Monte Carlo", |r| r.monte_carlo.iter_mut().for_each(|m| m.rows[0].interval[0] = f64::NAN)),
    ];
    for (name, spoil) in spoils {
        let mut spoiled = report();
        spoil(&mut spoiled);
        let result = spoiled.to_page();
        assert!(matches!(result, Err(ChartError::InvalidNumber { .. })), "{name}: {result:?}");
    }
}

fn first(report: &mut SkivingReport, spoil: fn(&mut skiving::page::TrackDeviations)) {
    report.measured.iter_mut().for_each(|m| spoil(&mut m.flanks[Flank::Right].tracks[2]));
}

#[test]
fn lists_of_different_length_are_refused() {
    let mut spoiled = report();
    first(&mut spoiled, |track| track.remaining_um.truncate(5));
    let error = spoiled.to_page().expect_err("a list is short");
    assert_eq!(error.code(), "length-mismatch");
    assert_holds(&error.to_string(), &["right flank, track 3"]);
    let mut spoiled = report();
    spoiled.pitch.iter_mut().for_each(|pitch| pitch.single_um.truncate(5));
    assert_eq!(spoiled.to_page().expect_err("a list is short").code(), "length-mismatch");
}

#[test]
fn a_tool_of_75_teeth_and_one_track_fits_as_well() {
    let mut other = report();
    let measured = other.measured.as_mut().expect("measured");
    for flank in Flank::BOTH {
        let tracks = &mut measured.flanks[flank].tracks;
        tracks.truncate(1);
        tracks[0].measured_um = (0..75).map(|k| f64::from(k % 7)).collect();
        tracks[0].remaining_um = vec![0.0; 75];
    }
    measured.band_um = None;
    let page = page(&other);
    let text = text_of(charts(section(&page, "Measured deviations"))[1]);
    assert!(!text.contains("D/2") && !text.contains("track 2"), "{text}");
}

#[test]
fn line_charts_draw_bars_limits_texts_and_rings() {
    let x = vec![0.0, 1.0, 2.0];
    let chart = |series| LineChart {
        title: "t".into(),
        x_title: "tooth".into(),
        panels: vec![Panel::linear("f_p [µm]", 0.0, series)],
    };
    let layout = LineFrame { panel_height: Some(100.0), beside: 0.5 };
    let svg = line_chart_in(
        &chart(vec![
            Series::bars("single", x.clone(), vec![1.0, -2.0, 3.0]),
            Series::limit("allowed", vec![0.0, 2.0], vec![3.5; 2]),
            Series::texts("hidden name", vec![([1.0, 1.0], "here".into())]),
            Series::rings("worst", vec![([2.0, 3.0], "tooth 2".into())]),
        ]),
        &layout,
    )
    .expect("finite");
    let text = text_of(&svg);
    assert_holds(&text, &["single", "allowed", "here", "worst", "tooth 2"]);
    assert!(!text.contains("hidden name"));
    // Three bars and one in the legend; the limit is dashed.
    assert_eq!(svg.as_str().matches("fill=\"#d5dde6\"").count(), 4);
    assert!(svg.as_str().contains("stroke-dasharray=\"5 3\""));
    let short = Series { marks: Marks::Rings(Vec::new()), ..Series::new("worst", x.clone(), x.clone()) };
    let error = line_chart_in(&chart(vec![short]), &layout).expect_err("no text for a ring");
    assert_eq!(error.code(), "length-mismatch");
    let wide = LineFrame { beside: f64::NAN, ..layout };
    let error = line_chart_in(&chart(vec![Series::new("a", x.clone(), x)]), &wide).expect_err("no layout");
    assert_eq!(error.code(), "invalid-number");
}

#[test]
fn flanks_without_a_trend_are_shown_without_one() {
    let mut young = report();
    let history = young.history.as_mut().expect("history");
    history.trends = Sides::default();
    history.limit_um = None;
    history.measurements.truncate(1);
    let page = page(&young);
    let text = text_of(charts(section(&page, "History"))[0]);
    assert!(text.contains("measured") && !text.contains("forecast") && !text.contains("limit"), "{text}");
}
