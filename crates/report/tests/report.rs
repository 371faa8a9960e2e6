//! Charts and pages: well-formed, complete, escaped, repeatable, and refusing what can't be drawn.

use crate::report_sample::{crowned, field, ripple, spread, swinging};
use foundation::geometry::Flank;
use proptest::prelude::*;
use report::charts::{
    AxisChart, AxisChartLimits, ChartError, ContourMap, DressingSectionChart, FlankSections, LevelScale,
    LineChart, MarkedClearance, NamedTopography, OccupationBar, OccupationKind, OccupationRow, Panel,
    ProfileHelixDiagram, RangeMark, SectionKind, SectionStretch, SectionTrace, Series, SpaceFlank, Svg,
    Topography, TopographyNet, WormOccupationChart, YScale, axis_chart, contour_map, dressing_section_chart,
    format_fixed, format_significant, line_chart, profile_helix_diagram, topography_net,
    worm_occupation_chart,
};
use report::{
    Banner, Block, Column, Fact, FirstPage, Language, PlanReport, Quantity, Section, Sheet, Table,
    TitleBlock, Warning, html,
};
use verdict::Status;

/// All text of a chart without its markup; panics if the chart is not well-formed XML or holds no number.
fn text_of(svg: &Svg) -> String {
    let document = svg.to_document();
    let tree = roxmltree::Document::parse(&document).expect("well-formed");
    assert_eq!(tree.root_element().tag_name().name(), "svg");
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

fn both(topography: impl Fn(Flank) -> Topography) -> Vec<NamedTopography> {
    vec![
        NamedTopography::new("Left flank", topography(Flank::Left)),
        NamedTopography::new("Right flank", topography(Flank::Right)),
    ]
}

fn net(panels: Vec<NamedTopography>) -> Svg {
    topography_net(&TopographyNet { title: "Deviation".into(), panels, range_um: None }).unwrap()
}

fn map(panels: Vec<NamedTopography>) -> Svg {
    let quantity = "f_n [µm]".into();
    contour_map(&ContourMap { title: "Topography".into(), quantity, panels, scale: None }).unwrap()
}

fn diagram(flank: Flank, topography: &Topography) -> ProfileHelixDiagram {
    let mut profile = SectionTrace::profile(topography, Some(topography), 20);
    profile.values_um = vec![("C_α".into(), 5.0)];
    ProfileHelixDiagram {
        title: "Diagram".into(),
        flanks: vec![FlankSections {
            flank,
            profiles: vec![profile],
            helices: vec![SectionTrace::helix(topography, None, 20)],
            profile_marks: vec![RangeMark { at_mm: 5.0, ends_range: true }],
            helix_marks: vec![RangeMark { at_mm: 12.0, ends_range: false }],
        }],
        external: true,
        target_name: "target".into(),
        simulated_name: "simulated".into(),
    }
}

fn one_line(name: &str, x: Vec<f64>, y: Vec<f64>, least_span: f64) -> Result<Svg, ChartError> {
    line_chart(&LineChart {
        title: "Corrections".into(),
        x_title: "v_zS [mm]".into(),
        panels: vec![Panel::linear("d_d [mm]", least_span, vec![Series::new(name, x, y)])],
    })
}

#[test]
fn a_net_states_its_scale_and_its_sides() {
    let text = text_of(&net(both(|_| field(crowned))));
    assert_holds(&text, &["Deviation", "Left flank", "Right flank", "5 µm", "z [mm]", "w [mm]"]);
    assert_holds(&text, &["root", "tip", "face I", "face II", "nominal", "−20.9"]);
}

#[test]
fn corner_values_of_a_tiny_net_are_powers_of_ten() {
    let text = text_of(&net(both(|_| field(|w, z| 1e-7 * crowned(w, z)))));
    assert_holds(&text, &["−2·10⁻⁶"]);
    assert!(!text.contains("0.00000"), "{text}");
}

#[test]
fn a_map_labels_its_isolines_and_its_bar() {
    let svg = map(both(|side| field(|w, z| 1000.0 * ripple(w, z, side))));
    let text = text_of(&svg);
    assert_holds(
        &text,
        &["Topography", "Right flank", "fn [µm]", "z [mm]", "w [mm]", "hatched", "min −", "max "],
    );
    // Each level stands at the bar and on at least one isoline.
    for level in ["−2", "−1", "1", "2"] {
        assert!(svg.as_str().matches(&format!(">{level}</text>")).count() >= 2, "level {level}");
    }
    assert!(svg.as_str().contains("stroke-dasharray"), "negative isolines are dashed");
}

#[test]
fn a_shared_scale_gives_equal_colours_to_equal_values() {
    let (deep, shallow) = (field(crowned), field(|w, z| 0.5 * crowned(w, z)));
    let scale = LevelScale::covering([&deep, &shallow]);
    let draw = |topography| {
        let panels = vec![NamedTopography::new("Left flank", topography)];
        let map = ContourMap { title: "t".into(), quantity: "f".into(), panels, scale: Some(scale) };
        contour_map(&map).unwrap()
    };
    let edges = scale.edges_um();
    assert_eq!((edges[0], edges[edges.len() - 1], scale.step_um()), (-22.0, 0.0, 2.0));
    for svg in [draw(deep), draw(shallow)] {
        assert_holds(&text_of(&svg), &["−22", "−20", "−2"]);
    }
}

#[test]
fn a_diagram_has_bars_ends_and_values() {
    let topography = field(crowned);
    let text = text_of(&profile_helix_diagram(&diagram(Flank::Left, &topography)).unwrap());
    assert_holds(&text, &["Diagram", "Profile, left flank", "Helix, left flank", "target", "simulated"]);
    assert_holds(
        &text,
        &[
            "w [mm]",
            "z [mm]",
            "root",
            "tip",
            "face I (not datum)",
            "face II (datum)",
            "evaluated range",
            "material",
        ],
    );
    assert_holds(&text, &["z = 0.00 mm", "w = 13.50 mm", "Cα = 5.00 µm"]);
}

#[test]
fn a_line_chart_names_its_series_and_axes() {
    let text = text_of(&one_line("left flank", vec![-1.0, 0.0, 2.5], vec![0.0, 1.0, -3.0], 0.0).unwrap());
    assert_holds(&text, &["Corrections", "left flank", "vzS [mm]", "dd [mm]", "−3", "2.0"]);
}

fn occupation() -> WormOccupationChart {
    use OccupationKind::{Finishing, Modified, Roughing, Unused};
    let bar = |kind, label: &str, from: f64, to: f64| OccupationBar {
        kind,
        label: label.into(),
        z_1_mm: [from, to],
    };
    let row = |name: &str, moved: f64| OccupationRow {
        name: name.into(),
        bars: vec![
            bar(Finishing, "1", -80.0, -47.8 + moved),
            bar(Modified, "1", -71.0, -47.8 + moved),
            bar(Finishing, "2", -45.9 - 4.0 * moved, -13.7),
            bar(Modified, "2", -45.9, -22.8),
            bar(Roughing, "3", -11.8, 10.4),
            bar(Roughing, "4", 12.0, 34.2),
            bar(Unused, "", 34.2, 80.0),
        ],
    };
    WormOccupationChart {
        title: "Occupation of the worm".into(),
        width_mm: [-80.0, 80.0],
        rows: vec![row("Left flank", 0.0), row("Right flank", 1.5)],
    }
}

#[test]
fn an_occupied_worm_shows_every_use_without_colour() {
    let svg = worm_occupation_chart(&occupation()).unwrap();
    let text = text_of(&svg);
    assert_holds(&text, &["Occupation of the worm", "Left flank", "Right flank", "z1 [mm]", "usable width"]);
    assert_holds(&text, &["finishing, modified lines", "finishing, unmodified lines", "roughing", "unused"]);
    for label in ["1", "2", "3", "4"] {
        assert_eq!(svg.as_str().matches(&format!(">{label}</text>")).count(), 2, "label {label}");
    }
    // Seven bars a flank, four in the legend, the ground and the outline.
    assert_eq!(svg.as_str().matches("<rect").count(), 14 + 4 + 2);
    // Hatched: per flank two modified and two roughing bars, and one of each in the legend.
    assert_eq!(svg.as_str().matches("<path").count(), 2 * 4 + 2);
    assert_eq!(svg, worm_occupation_chart(&occupation()).unwrap());
    // Only what occurs stands in the legend.
    let mut plain = occupation();
    plain.rows.iter_mut().for_each(|row| row.bars.retain(|bar| bar.kind == OccupationKind::Finishing));
    assert!(!text_of(&worm_occupation_chart(&plain).unwrap()).contains("roughing"));
}

#[test]
fn bars_that_overlap_lie_below_each_other() {
    let height = |chart: &WormOccupationChart| {
        let svg = worm_occupation_chart(chart).unwrap();
        let document = svg.to_document();
        let tree = roxmltree::Document::parse(&document).unwrap();
        tree.root_element().attribute("height").unwrap().parse::<f64>().unwrap()
    };
    let mut apart = occupation();
    apart.rows.truncate(1);
    let mut over = apart.clone();
    over.rows[0].bars[0].z_1_mm[1] = -40.0;
    assert!(height(&over) > height(&apart) + 30.0);
}

#[test]
fn occupations_that_cannot_be_drawn_are_refused() {
    let code = |change: &dyn Fn(&mut WormOccupationChart)| {
        let mut chart = occupation();
        change(&mut chart);
        worm_occupation_chart(&chart).unwrap_err().code()
    };
    assert_eq!(code(&|c| c.rows.clear()), "too-few-values");
    assert_eq!(code(&|c| c.rows[1].bars.clear()), "too-few-values");
    assert_eq!(code(&|c| c.width_mm = [1.0, 1.0]), "not-ascending");
    assert_eq!(code(&|c| c.width_mm[0] = f64::NAN), "invalid-number");
    assert_eq!(code(&|c| c.rows[0].bars[2].z_1_mm = [5.0, 4.0]), "not-ascending");
    assert_eq!(code(&|c| c.rows[0].bars[2].z_1_mm[1] = f64::INFINITY), "invalid-number");
}

/// A thread space 7 mm deep with a dresser that collides with one flank by half a millimetre.
fn dressing_section() -> DressingSectionChart {
    let flank = |name: &str, side: f64, clearance| SpaceFlank {
        name: name.into(),
        line_mm: (0..=14).map(|k| [side * (1.5 + 0.16 * f64::from(k)), 46.0 + 0.5 * f64::from(k)]).collect(),
        used_radius_mm: [47.0, 52.0],
        clearance,
    };
    let mark = MarkedClearance {
        normal_mm: -0.5,
        dresser_mm: [-3.9, 51.85],
        flank_mm: [-3.42, 52.0],
        dresser_radius_mm: 54.451,
    };
    let stretch = |kind, line: &[[f64; 2]]| SectionStretch { kind, line_mm: line.to_vec() };
    DressingSectionChart {
        title: "Dresser in the thread space".into(),
        subtitle: "d_S 100 mm".into(),
        flanks: [flank("right flank", -1.0, Some(mark)), flank("left flank, dressed", 1.0, None)],
        dresser: vec![
            stretch(SectionKind::CounterFlank, &[[-4.5, 54.0], [-2.0, 45.5]]),
            stretch(SectionKind::TipLand, &[[-2.0, 45.5], [1.4, 45.5]]),
            stretch(SectionKind::ActiveFlank, &[[1.4, 45.5], [4.2, 54.0]]),
        ],
    }
}

#[test]
fn a_section_names_its_parts_and_marks_the_collision() {
    let svg = dressing_section_chart(&dressing_section()).unwrap();
    let text = text_of(&svg);
    assert_holds(
        &text,
        &["Dresser in the thread space", "dS 100 mm", "axial position [mm]", "radius of the worm [mm]"],
    );
    assert_holds(&text, &["active flank", "tip land", "opposite flank", "used part", "worm"]);
    assert_holds(
        &text,
        &["right flank", "collision 0.500 mm", "dresser radius 54.45 mm", "worm radius 52.00 mm"],
    );
    assert_holds(&text, &["left flank, dressed"]);
    assert!(!text.contains("clearance"), "{text}");
    assert_eq!(svg, dressing_section_chart(&dressing_section()).unwrap());
    // Dashes tell the parts apart without colour: once in the section, once in the legend.
    for dash in ["2 2.5", "9 4"] {
        assert_eq!(svg.as_str().matches(&format!("stroke-dasharray=\"{dash}\"")).count(), 2);
    }
    let mut clear = dressing_section();
    clear.flanks[0].clearance =
        clear.flanks[0].clearance.map(|mark| MarkedClearance { normal_mm: 0.5, ..mark });
    clear.flanks[1].clearance = clear.flanks[0].clearance.map(|mark| MarkedClearance {
        dresser_mm: [3.42, 52.0],
        flank_mm: [3.42, 52.0],
        normal_mm: 0.0,
        ..mark
    });
    let text = text_of(&dressing_section_chart(&clear).unwrap());
    assert_holds(&text, &["clearance 0.500 mm", "clearance 0.000 mm"]);
}

/// A millimetre along the worm is as long on the page as one across it.
#[test]
fn both_axes_of_a_section_have_the_same_scale() {
    let svg = dressing_section_chart(&dressing_section()).unwrap();
    let document = svg.to_document();
    let tree = roxmltree::Document::parse(&document).unwrap();
    // Ticks: short lines below and left of the frame; the steps of both axes are 1 or 2 mm.
    let number =
        |node: &roxmltree::Node<'_, '_>, name: &str| node.attribute(name).unwrap().parse::<f64>().unwrap();
    let label = |text: &str| text.replace('−', "-").parse::<f64>().ok();
    let mut places: [Vec<(f64, f64)>; 2] = [Vec::new(), Vec::new()];
    for node in tree.descendants().filter(|node| node.has_tag_name("text")) {
        let Some(value) = node.text().and_then(label) else { continue };
        match node.attribute("text-anchor") {
            Some("middle") => places[0].push((value, number(&node, "x"))),
            Some("end") => places[1].push((value, -number(&node, "y"))),
            _ => {}
        }
    }
    let scales = places.map(|at| (at[1].1 - at[0].1) / (at[1].0 - at[0].0));
    assert!((scales[0] - scales[1]).abs() < 0.01 * scales[0] && scales[0] > 20.0, "{scales:?}");
}

#[test]
fn sections_that_cannot_be_drawn_are_refused() {
    let code = |change: &dyn Fn(&mut DressingSectionChart)| {
        let mut chart = dressing_section();
        change(&mut chart);
        dressing_section_chart(&chart).unwrap_err().code()
    };
    assert_eq!(code(&|c| c.dresser.clear()), "too-few-values");
    assert_eq!(code(&|c| c.dresser[1].line_mm.clear()), "too-few-values");
    assert_eq!(code(&|c| c.flanks[0].line_mm.truncate(1)), "too-few-values");
    assert_eq!(code(&|c| c.flanks[1].line_mm.reverse()), "not-ascending");
    assert_eq!(code(&|c| c.flanks[1].used_radius_mm = [50.0, 50.0]), "not-ascending");
    assert_eq!(code(&|c| c.dresser[2].line_mm[0][1] = f64::NAN), "invalid-number");
    assert_eq!(code(&|c| c.flanks[0].line_mm[3][0] = f64::INFINITY), "invalid-number");
    assert_eq!(code(&|c| c.flanks[0].clearance.as_mut().unwrap().normal_mm = f64::NAN), "invalid-number");
}

/// Dashed lines of a limit, without the one of the legend.
fn limits_drawn(svg: &Svg) -> usize {
    svg.as_str().matches("stroke-dasharray=\"6 3\"").count().saturating_sub(1)
}

#[test]
fn an_axis_chart_names_axis_word_units_and_limits() {
    let svg = axis_chart(&swinging(400, 2.0, -131.0, 5.0)).unwrap();
    let text = text_of(&svg);
    assert_holds(&text, &["Axis X1, word X", "position [mm]", "velocity [mm/s]", "acceleration [mm/s²]"]);
    assert_holds(&text, &["time [s]", "axis"]);
    // Far limits are said, not drawn: the curves keep their height.
    assert!(!svg.as_str().contains("stroke-dasharray") && !svg.as_str().contains(">limit</text>"));
    assert_holds(&text, &["travel −420 .. −20 (beyond the scale), 106 mm to spare"]);
    assert_holds(&text, &["limit ±250 (beyond the scale), 2.51 % used"]);
    assert_eq!(svg, axis_chart(&swinging(400, 2.0, -131.0, 5.0)).unwrap());
}

#[test]
fn near_limits_of_an_axis_are_drawn_dashed() {
    // Velocity up to 251.3, acceleration up to 3158 in both senses, travel near at its upper end only.
    let mut chart = swinging(400, 20.0, -51.0, 20.0);
    chart.limits =
        AxisChartLimits { travel: Some([-420.0, -20.0]), velocity: Some(300.0), acceleration: Some(3200.0) };
    let svg = axis_chart(&chart).unwrap();
    let text = text_of(&svg);
    assert_eq!(limits_drawn(&svg), 1 + 2 + 2);
    for value in ["−20", "300", "−300", "3200", "−3200"] {
        assert!(svg.as_str().contains(&format!(">{value}</text>")), "{value}");
    }
    assert_holds(&text, &["travel −420 .. −20, 11 mm to spare", "83.8 % used", "98.7 % used"]);
    assert!(!text.contains("beyond the scale") && svg.as_str().contains(">limit</text>"), "{text}");
}

#[test]
fn an_axis_without_limits_and_one_at_rest_are_drawn() {
    let endless = AxisChart { limits: AxisChartLimits::default(), ..swinging(400, 2.0, 0.0, 720.0) };
    let svg = axis_chart(&endless).unwrap();
    assert_holds(&text_of(&svg), &["travel without ends", "no limit given"]);
    assert!(!svg.as_str().contains("stroke-dasharray"));
    for at in [0.0, -131.0, 1e-12, -420.0] {
        text_of(&axis_chart(&swinging(50, 1.0, at, 0.0)).unwrap());
        text_of(&axis_chart(&swinging(50, 0.0, at, 3.0)).unwrap());
        let mut instant = swinging(3, 1.0, at, 1.0);
        instant.time_s = vec![2.0; 3];
        text_of(&axis_chart(&instant).unwrap());
    }
}

#[test]
fn a_long_trace_of_an_axis_is_thinned_and_keeps_its_peaks() {
    let mut chart = swinging(20_000, 3.0, -131.0, 5.0);
    chart.velocity[12_345] = 200.0;
    let svg = axis_chart(&chart).unwrap();
    assert!(svg.as_str().len() < 40_000, "{} bytes", svg.as_str().len());
    chart.velocity[12_345] = 0.0;
    assert_ne!(svg, axis_chart(&chart).unwrap());
    assert_holds(&text_of(&svg), &["80 % used"]);
}

#[test]
fn axes_that_cannot_be_drawn_are_refused() {
    let code = |change: &dyn Fn(&mut AxisChart)| {
        let mut chart = swinging(50, 1.0, -131.0, 5.0);
        change(&mut chart);
        axis_chart(&chart).unwrap_err().code()
    };
    assert_eq!(code(&|c| c.time_s.clear()), "too-few-values");
    assert_eq!(code(&|c| c.time_s[7] = 9.0), "not-ascending");
    assert_eq!(code(&|c| c.velocity.truncate(49)), "length-mismatch");
    assert_eq!(code(&|c| c.acceleration[3] = f64::NAN), "invalid-number");
    assert_eq!(code(&|c| c.position[3] = f64::INFINITY), "invalid-number");
    assert_eq!(code(&|c| c.limits.velocity = Some(f64::NAN)), "invalid-number");
    assert_eq!(code(&|c| c.limits.travel = Some([0.0, f64::INFINITY])), "invalid-number");
}

#[test]
fn decades_stand_on_a_logarithmic_ordinate() {
    let panel = Panel {
        y_title: "error [µm]".into(),
        least_span: 0.0,
        scale: YScale::Logarithmic,
        series: vec![Series::new("left", vec![0.0, 1.0, 2.0], vec![0.45, 0.03, 0.0])],
    };
    let chart = LineChart { title: "t".into(), x_title: "round".into(), panels: vec![panel.clone()] };
    assert_holds(&text_of(&line_chart(&chart).unwrap()), &["0.01", "0.1", "round"]);
    // Nothing positive: there are no decades, and still a chart.
    let zero = Panel { series: vec![Series::new("left", vec![0.0, 1.0], vec![0.0, 0.0])], ..panel };
    text_of(&line_chart(&LineChart { panels: vec![zero], ..chart }).unwrap());
}

#[test]
fn constant_data_are_drawn() {
    for value in [0.0, 3.7, -1e-9, -20.0, 1e9, 1e-310] {
        let constant = || both(|_| field(|_, _| value));
        text_of(&net(constant()));
        text_of(&map(constant()));
        text_of(&profile_helix_diagram(&diagram(Flank::Left, &field(|_, _| value))).unwrap());
        text_of(&one_line("a", vec![0.0, 1.0], vec![value; 2], 0.0).unwrap());
        text_of(&one_line("a", vec![value], vec![value], 0.0).unwrap());
    }
    assert_holds(&text_of(&map(both(|_| field(|_, _| 0.0)))), &["0 everywhere"]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Whatever finite numbers come, of any size, the charts are well-formed and hold no number that isn't one.
    #[test]
    fn any_finite_data_are_drawn(
        corners in prop::collection::vec((-1.0..1.0_f64, -330..12_i32), 6),
        coordinates in prop::collection::vec((-1.0..1.0_f64, -320..12_i32), 3),
        least_span in 0.0..1.0_f64,
    ) {
        let sized = |pairs: &[(f64, i32)]| -> Vec<f64> { pairs.iter().map(|(m, e)| m * 10f64.powi(*e)).collect() };
        let (values, mut x) = (sized(&corners), sized(&coordinates));
        text_of(&one_line("a", x.clone(), values[..3].to_vec(), least_span).unwrap());
        let series = vec![Series::new("a", x.clone(), values[3..].to_vec())];
        let panel = Panel { y_title: "y".into(), least_span, scale: YScale::Logarithmic, series };
        text_of(&line_chart(&LineChart { title: "t".into(), x_title: "x".into(), panels: vec![panel] }).unwrap());
        x.sort_by(f64::total_cmp);
        if let Ok(topography) = Topography::from_row_major(vec![0.0, 1.0], x, &values) {
            text_of(&map(both(|_| topography.clone())));
            text_of(&net(both(|_| topography.clone())));
            let trace = SectionTrace::helix(&topography, Some(&topography), 1);
            let mut sheet = diagram(Flank::Left, &field(crowned));
            sheet.flanks[0].helices = vec![trace];
            text_of(&profile_helix_diagram(&sheet).unwrap());
        }
    }
}

#[test]
fn noise_below_the_least_span_stays_flat() {
    let noise = vec![1e-15, -2e-15, 3e-15];
    let svg = one_line("a", vec![0.0, 1.0, 2.0], noise, 1e-3).unwrap();
    let tree = roxmltree::Document::parse(svg.as_str()).unwrap();
    let line = tree
        .descendants()
        .filter(|node| node.attribute("stroke-width") == Some("1.8"))
        .find_map(|node| node.attribute("d"))
        .unwrap();
    let heights: Vec<&str> = line.split(['M', 'L']).filter_map(|p| p.split_once(' ')).map(|p| p.1).collect();
    assert_eq!(heights.len(), 3);
    assert!(heights.iter().all(|y| *y == heights[0]), "{line}");
}

#[test]
fn tick_labels_of_an_axis_do_not_touch() {
    for span in [1e-9, 3e-4, 0.7, 12.0, 4567.0, 2e8] {
        let svg = one_line("a", vec![-span, 0.3 * span, span], vec![0.0, 0.6 * span, span], 0.0).unwrap();
        let tree = roxmltree::Document::parse(svg.as_str()).unwrap();
        let number = |node: &roxmltree::Node, name| node.attribute(name).unwrap().parse::<f64>().unwrap();
        let labels: Vec<(f64, f64, usize)> = tree
            .descendants()
            .filter(|node| node.attribute("text-anchor") == Some("middle"))
            .filter(|node| node.text().is_some_and(|text| text.chars().all(|c| "−.0123456789".contains(c))))
            .map(|node| (number(&node, "x"), number(&node, "y"), node.text().unwrap().chars().count()))
            .collect();
        assert!(labels.len() >= 3, "span {span}: {labels:?}");
        for pair in labels.windows(2) {
            let half = 0.25 * 12.0 * (pair[0].2 + pair[1].2) as f64;
            assert!(pair[1].0 - pair[0].0 > half, "span {span}: {labels:?}");
        }
    }
}

#[test]
fn what_is_not_finite_is_refused() {
    let (w, z) = (spread(4.0, 22.0, 3), spread(-20.0, 20.0, 4));
    let mut values = vec![vec![0.0; 4]; 3];
    values[1][2] = f64::NAN;
    let error = Topography::new(w.clone(), z.clone(), values).unwrap_err();
    assert!(matches!(error, ChartError::InvalidNumber { index: 6, .. }), "{error}");
    assert_eq!(error.code(), "invalid-number");
    assert!(error.to_string().contains("NaN") && !error.way_out().is_empty());

    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
        let error = one_line("a", vec![0.0, 1.0], vec![0.0, wrong], 0.0).unwrap_err();
        assert!(matches!(error, ChartError::InvalidNumber { index: 1, .. }));
        assert!(one_line("a", vec![wrong, 1.0], vec![0.0, 0.0], 0.0).is_err());
        let mut sheet = diagram(Flank::Left, &field(crowned));
        sheet.flanks[0].profiles[0].simulated_um[3] = wrong;
        assert!(matches!(profile_helix_diagram(&sheet), Err(ChartError::InvalidNumber { index: 3, .. })));
        let mut sheet = diagram(Flank::Left, &field(crowned));
        sheet.flanks[0].profiles[0].values_um[0].1 = wrong;
        assert!(profile_helix_diagram(&sheet).is_err());
        let range_um = Some((0.0, wrong));
        assert!(
            topography_net(&TopographyNet { title: "t".into(), panels: both(|_| field(crowned)), range_um })
                .is_err()
        );
    }
}

#[test]
fn incomplete_data_are_refused() {
    let (w, z) = (spread(4.0, 22.0, 3), spread(-20.0, 20.0, 4));
    let rows = |n: usize, m: usize| vec![vec![0.0; m]; n];
    let new = Topography::new;
    assert_eq!(new(w.clone(), z.clone(), rows(2, 4)).unwrap_err().code(), "length-mismatch");
    assert_eq!(new(w.clone(), z.clone(), rows(3, 3)).unwrap_err().code(), "length-mismatch");
    assert_eq!(new(vec![1.0], z.clone(), rows(1, 4)).unwrap_err().code(), "too-few-values");
    assert_eq!(new(vec![1.0, 3.0, 3.0], z.clone(), rows(3, 4)).unwrap_err().code(), "not-ascending");
    assert!(Topography::from_row_major(w.clone(), z.clone(), &[0.0; 11]).is_err());
    assert_eq!(Topography::from_row_major(w, z.clone(), &[0.5; 12]).unwrap().f_um()[2][3], 0.5);
    assert!(Topography::from_row_major(vec![], vec![], &[]).is_err());

    assert_eq!(one_line("a", vec![0.0], vec![], 0.0).unwrap_err().code(), "length-mismatch");
    assert_eq!(one_line("a", vec![], vec![], 0.0).unwrap_err().code(), "too-few-values");
    let empty = TopographyNet { title: "t".into(), panels: vec![], range_um: None };
    assert_eq!(topography_net(&empty).unwrap_err().code(), "too-few-values");
    let empty = ContourMap { title: "t".into(), quantity: "f".into(), panels: vec![], scale: None };
    assert_eq!(contour_map(&empty).unwrap_err().code(), "too-few-values");
}

const NASTY: &str = "<script>alert(\"1\")</script> & 'x' \u{0}\u{1b}";

#[test]
fn texts_are_escaped_in_charts() {
    let topography = field(crowned);
    let panels = || vec![NamedTopography::new(NASTY, topography.clone())];
    let mut sheet = diagram(Flank::Right, &topography);
    sheet.title = NASTY.into();
    let charts = [
        topography_net(&TopographyNet { title: NASTY.into(), panels: panels(), range_um: None }).unwrap(),
        contour_map(&ContourMap {
            title: NASTY.into(),
            quantity: NASTY.into(),
            panels: panels(),
            scale: None,
        })
        .unwrap(),
        profile_helix_diagram(&sheet).unwrap(),
        one_line(NASTY, vec![0.0, 1.0], vec![0.0, 1.0], 0.0).unwrap(),
    ];
    for svg in charts {
        assert!(!svg.as_str().contains("<script"));
        assert_holds(&text_of(&svg), &["<script>alert(\"1\")</script> & 'x'"]);
    }
}

#[test]
fn texts_are_escaped_on_the_page() {
    let nasty = || NASTY.to_owned();
    let page = html::render(&PlanReport {
        title: nasty(),
        subtitle: Some(nasty()),
        language: Language::English,
        title_block: TitleBlock {
            part_number: Some(nasty()),
            drawing_number: Some(nasty()),
            customer: Some(nasty()),
            machine: Some(nasty()),
            date: Some(nasty()),
            author: Some(nasty()),
            process: nasty(),
            version: nasty(),
        },
        first_page: FirstPage {
            scope: nasty(),
            picture: None,
            values: None,
            sheets: vec![Sheet::new(NASTY, vec![Quantity::shown(NASTY, NASTY, NASTY, NASTY)]).remark(NASTY)],
        },
        banner: Banner {
            status: Status::Missed.into(),
            headline: nasty(),
            figures: vec![Fact::new(NASTY, NASTY)],
        },
        sections: vec![Section::new(
            NASTY,
            NASTY,
            vec![
                Block::Paragraph(nasty()),
                Block::Table(Table {
                    caption: nasty(),
                    columns: vec![Column::text(NASTY), Column::number(NASTY, NASTY), Column::symbols(NASTY)],
                    rows: vec![vec![nasty(); 4]],
                    note: nasty(),
                }),
                Block::Tables(vec![Table::of_quantities(NASTY, &[Quantity::text(NASTY, NASTY)])]),
                Block::Warnings(vec![Warning { text: nasty(), way_out: nasty() }]),
            ],
        )],
    });
    assert!(!page.contains("<script"));
    assert!(!page.contains("\"1\"") && !page.contains('\u{1b}'));
    assert!(page.matches("&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt; &amp; &#39;x&#39;").count() > 18);
}

#[test]
fn numbers_are_written_for_readers() {
    assert_eq!(format_fixed(-0.0004, 3), "0.000");
    assert_eq!(format_fixed(-1.25, 1), "−1.2");
    assert_eq!(format_fixed(f64::NAN, 1), "–");
    assert_eq!(format_significant(0.0, 3), "0");
    assert_eq!(format_significant(88.5315, 7), "88.5315");
    assert_eq!(format_significant(0.001, 2), "0.001");
    assert_eq!(format_significant(-123_456_789.0, 3), "−1.23·10⁸");
    assert_eq!(Quantity::per_flank("a", "", 1.0, 1.0, "mm").value_text(), "1");
    assert_eq!(Quantity::per_flank("a", "", 1.0, -2.5, "mm").value_text(), "1 / −2.5");
    assert_eq!(Quantity::count("z", "", -30).value_text(), "−30");
}
