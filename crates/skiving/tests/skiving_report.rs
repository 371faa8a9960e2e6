//! The page of a skiving tool's measurement: every section present, well-formed, readable without colour, and nothing drawn from
//! numbers that are none.

use foundation::geometry::Flank;
use foundation::numerics::Silent;
use job::{Source, parse_job_of};
use report::charts::{ChartError, LineChart, LineFrame, Marks, Panel, Series, line_chart_in};
use skiving::job::SkivingJob;
use skiving::page::html_page;
use skiving::workflow::{SkivingOutcome, run_skiving};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/skiving")
}

/// An example with other things in it.
fn ran(name: &str, changes: &[(&str, &str)]) -> SkivingOutcome {
    let mut text = std::fs::read_to_string(examples().join(format!("{name}.toml"))).unwrap();
    text = text.replace("../../machines", examples().join("../../machines").to_str().unwrap());
    for (from, to) in changes {
        assert!(text.contains(from), "{name} has no {from}");
        text = text.replace(from, to);
    }
    let loaded = parse_job_of::<SkivingJob>(Source::new("job.toml", &text)).unwrap();
    run_skiving(&loaded, &Silent).unwrap_or_else(|failure| panic!("{failure:?}"))
}

/// A ring gear's tool with repeated measurements and programs.
fn ring() -> SkivingOutcome {
    static MADE: OnceLock<SkivingOutcome> = OnceLock::new();
    MADE.get_or_init(|| ran("internal-ring", &[("measurements = 1000", "measurements = 20")])).clone()
}

/// A tool of 75 teeth with a chip on tooth 17, and tooth 30 broken off.
fn damaged() -> SkivingOutcome {
    static MADE: OnceLock<SkivingOutcome> = OnceLock::new();
    let broken = "teeth = [ { tooth = 30, broken = true }, { tooth = 17,";
    MADE.get_or_init(|| ran("damaged-tooth", &[("teeth = [ { tooth = 17,", broken)])).clone()
}

/// A worn tool with its history.
fn worn() -> SkivingOutcome {
    static MADE: OnceLock<SkivingOutcome> = OnceLock::new();
    let made = || {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("history.jsonl");
        std::fs::copy(examples().join("history.jsonl"), &file).unwrap();
        ran("worn-tool", &[("history.jsonl", file.to_str().unwrap())])
    };
    MADE.get_or_init(made).clone()
}

fn page(outcome: &SkivingOutcome) -> String {
    html_page(outcome, &[("result.json".into(), "result with tracks")]).expect("finite numbers")
}

/// A section of a page, from its heading to the next one.
fn section<'a>(page: &'a str, heading: &str) -> &'a str {
    let from = page.find(&format!("<h2>{heading}</h2>")).unwrap_or_else(|| panic!("{heading}"));
    page[from + 4..].split("<h2>").next().unwrap()
}

/// The charts of a part of a page.
fn charts(part: &str) -> Vec<&str> {
    let from = part.match_indices("<svg ").map(|(at, _)| at);
    from.map(|at| &part[at..at + part[at..].find("</svg>").unwrap() + "</svg>".len()]).collect()
}

/// The cells of the rows of a part of a page.
fn rows(part: &str) -> Vec<Vec<&str>> {
    part.split("<tr>")
        .skip(1)
        .map(|row| {
            row.split("<td")
                .skip(1)
                .filter_map(|cell| cell.split_once('>')?.1.split("</td>").next())
                .collect()
        })
        .collect()
}

/// All text of a chart; panics if it is not well-formed or holds what is no number.
fn text_of(svg: &str) -> String {
    let tree = roxmltree::Document::parse(svg).expect("well-formed");
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
    let outcome = ring();
    let text = page(&outcome);
    let titles: Vec<&str> =
        text.split("<h2>").skip(1).filter_map(|part| part.split("</h2>").next()).collect();
    let wanted = [
        "Scope of the verdict",
        "Measured deviations",
        "Angles of the edges",
        "Signal over one turn",
        "Concentricity",
        "Pitch",
        "Tooth and contact points",
        "Measuring poses",
        "Profile of the workpiece",
        "Corrections",
        "Tool, workpiece and measurement",
        "Programs",
        "Files",
        "Comparison with the conventional method",
        "Monte Carlo",
    ];
    assert_eq!(titles, wanted);
    let drawn = charts(&text);
    assert_eq!(drawn.len(), 12);
    for svg in drawn {
        let text = text_of(svg);
        assert!(text.contains('['), "no unit in {text}");
    }
    for program in &outcome.result.programs {
        assert!(text.contains(&program.file), "{}", program.file);
    }
    assert_eq!(text, page(&ring()), "not the same bytes twice");
}

#[test]
fn what_is_missing_is_left_out() {
    let mut outcome = ring();
    (outcome.measurement, outcome.history) = (None, None);
    let result = &mut outcome.result;
    (result.measurement, result.monte_carlo) = (None, None);
    result.conventional.clear();
    result.programs.clear();
    let text = page(&outcome);
    for absent in [
        "Measured",
        "Angles",
        "Concentricity",
        "Pitch",
        "Corrections",
        "Comparison",
        "Monte Carlo",
        "Programs",
    ] {
        assert!(!text.contains(&format!("<h2>{absent}")), "{absent}");
    }
    // Of the ideal tool the prediction alone is drawn.
    let profile = text_of(charts(section(&text, "Profile of the workpiece"))[0]);
    assert!(profile.contains("mean tooth, predicted") && !profile.contains("after the correction"));
}

#[test]
fn tracks_are_named_and_the_tooth_that_stands_out_is_ringed() {
    let text = page(&damaged());
    let part = section(&text, "Measured deviations");
    let deviations = charts(part);
    for svg in &deviations[..2] {
        assert_holds(
            &text_of(svg),
            &["track 1", "track 5", "Left flank: deviation [µm]", "Right flank: deviation [µm]"],
        );
    }
    assert!(!text_of(deviations[0]).contains("tooth 17"));
    assert_holds(&text_of(deviations[1]), &["± D/2", "tooth to look at", "tooth 17"]);
    let worst = rows(part);
    let of = |tooth: &str| worst.iter().find(|row| row.first() == Some(&tooth)).unwrap();
    assert_eq!(of("30")[1..4], ["both", "–", "–"]);
    assert_eq!(of("17")[1], "left");
    assert!(of("17")[4].starts_with("out of the band"), "{:?}", of("17"));
}

#[test]
fn the_angle_chart_says_how_much_it_magnifies() {
    let text = page(&ring());
    let part = section(&text, "Angles of the edges");
    assert_holds(
        &text_of(charts(part)[0]),
        &["compensation curve", "tolerance band D", "measured tooth centre", "Left flank", "°", "mm"],
    );
    assert_holds(part, &["times as large", "D = 8 µm"]);
    let tracks = ring().prepared.bodies.flanks.left.tracks.len();
    assert_eq!(rows(part).iter().filter(|row| row.len() == 6).count(), 2 * tracks);
    // Beside tooth 0 stands the tooth that leaves its band the farthest.
    let text = page(&damaged());
    assert_holds(section(&text, "Angles of the edges"), &["Angles of tooth 0", "Angles of tooth 17"]);
}

#[test]
fn the_strip_has_every_tooth_and_tells_broken_ones_by_a_sign() {
    let outcome = damaged();
    let text = page(&outcome);
    let strip = charts(section(&text, "Signal over one turn"))[0];
    for tooth in 0..outcome.prepared.bodies.teeth() {
        assert!(strip.contains(&format!(">{tooth}</text>")), "{tooth}");
    }
    assert_holds(&text_of(strip), &["broken: stays light", "out of the band"]);
}

#[test]
fn the_comparison_says_where_the_conventional_beam_is_blind() {
    let mut outcome = ring();
    for row in outcome.result.conventional.iter_mut().filter(|row| row.flank == "right") {
        (row.ideal_um, row.reported_um) = (None, None);
    }
    let text = page(&outcome);
    let part = section(&text, "Comparison with the conventional method");
    for row in rows(part).iter().filter(|row| row.len() == 8) {
        let blind = row[0] == "right";
        assert_eq!(row[3] == "beam rests on the body", blind, "{row:?}");
        assert_eq!(row[4] == "–", blind, "{row:?}");
    }
    assert_holds(part, &["On 5 of 10 tracks"]);
}

#[test]
fn verdicts_are_words() {
    let mut outcome = ring();
    let measured = outcome.result.measurement.as_mut().unwrap();
    measured.correction.at_limit = vec!["tool angle"];
    measured.correction.rms_um = [1.448, 0.589];
    measured.profile.worn.insert("right", true);
    let text = page(&outcome);
    let part = section(&text, "Corrections");
    let of = |first: &str| rows(part).into_iter().find(|row| row.first() == Some(&first)).unwrap();
    assert_eq!([of("centre distance")[6], of("tool angle")[6]], ["no", "YES"]);
    assert_eq!([of("left")[4], of("right")[4]], ["no", "YES"]);
    assert_holds(part, &["1.448 µm before", "0.589 µm after"]);
    // What may not be changed has no row.
    assert!(!part.contains("tool shift"));
}

#[test]
fn the_forecast_is_ringed_and_flanks_without_a_trend_have_none() {
    let mut outcome = worn();
    let text = page(&outcome);
    let part = section(&text, "History");
    assert_holds(&text_of(charts(part)[0]), &["measured", "fitted line", "limit"]);
    let noted = outcome.history.as_ref().unwrap();
    assert_eq!(rows(part).iter().filter(|row| row.len() == 5).count(), noted.cycle.len());
    let shown = noted.trends.left.as_ref().unwrap().forecast.as_ref().unwrap();
    assert_holds(
        part,
        &[&format!("Left flank: limit at {:.0} parts ±", shown.parts), "one standard deviation"],
    );
    let noted = outcome.history.as_mut().unwrap();
    (noted.trends.left, noted.trends.right) = (None, None);
    let text = page(&outcome);
    let young = text_of(charts(section(&text, "History"))[0]);
    assert!(
        young.contains("measured") && !young.contains("forecast") && !young.contains("fitted"),
        "{young}"
    );
}

#[test]
fn an_edge_section_shows_its_angles_and_the_beam() {
    let text = page(&ring());
    let charts = charts(section(&text, "Tooth and contact points"));
    assert_holds(&text_of(charts[0]), &["L1", "L5", "R1", "R5", "x [mm]"]);
    assert_holds(&text_of(charts[1]), &["light beam", "contact θ"]);
    assert!(!text_of(charts[1]).contains("chamfer"));
    let chamfered = "edge_radius = 0.03\nrake_chamfer = { width = 0.02, angle_deg = 20.0 }";
    let text = page(&ran(
        "internal-ring",
        &[("edge_radius = 0.03", chamfered), ("[monte_carlo]\nmeasurements = 1000", "")],
    ));
    assert_holds(&text_of(self::charts(section(&text, "Tooth and contact points"))[1]), &["chamfer"]);
}

/// Each spoils one number of the page.
type Spoil = fn(&mut SkivingOutcome);

#[test]
fn a_value_that_is_no_number_is_refused_in_every_section() {
    let spoils: [(&str, Spoil); 10] = [
        ("measured", |made| evaluation(made).clocked.of[Flank::Right][2][3] = f64::NAN),
        ("remaining", |made| evaluation(made).remaining.of[Flank::Right][2][3] = f64::INFINITY),
        ("pitch", |made| evaluation(made).pitch.first_harmonic[1] = f64::NAN),
        ("edge section", |made| made.prepared.bodies.beam.radius = f64::NAN),
        ("poses", |made| made.result.tracks.get_mut("right").unwrap()[2].position_mm[2] = f64::NAN),
        ("profile", |made| made.result.flanks.get_mut("left").unwrap().simulated_um[0][0] = f64::NAN),
        ("corrections", |made| {
            made.result.measurement.as_mut().unwrap().correction.rms_um[1] = f64::NAN;
        }),
        ("conventional", |made| made.result.conventional[2].reported_um = Some(f64::NAN)),
        ("Monte Carlo", |made| {
            let results = &mut made.result.monte_carlo.as_mut().unwrap().results;
            results.iter_mut().for_each(|scatter| scatter.interval[0] = f64::NAN);
        }),
        ("programs", |made| made.result.programs[0].duration_s = f64::NAN),
    ];
    for (name, spoil) in spoils {
        let mut spoiled = ring();
        spoil(&mut spoiled);
        let refused = html_page(&spoiled, &[]).err();
        assert!(matches!(refused, Some(ChartError::InvalidNumber { .. })), "{name}: {refused:?}");
    }
    let mut spoiled = worn();
    spoiled.history.as_mut().unwrap().cycle[1].parts = f64::NAN;
    assert!(matches!(html_page(&spoiled, &[]), Err(ChartError::InvalidNumber { .. })));
}

fn evaluation(outcome: &mut SkivingOutcome) -> &mut skiving::evaluation::Evaluation {
    &mut outcome.measurement.as_mut().unwrap().evaluation
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
    let text = text_of(&svg.to_document());
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
