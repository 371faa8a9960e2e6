//! The trends of the published figures, in the studies of `examples/dressing` (`docs/mathematics/dressing.md#how-it-is-verified`): what the
//! curves must show whoever draws them.

use crate::command::run;
use serde_json::Value;

fn study(name: &str) -> Value {
    let directory = tempfile::tempdir().unwrap();
    let output = directory.path().join("out");
    let run = run(&[
        "explore",
        &format!("examples/dressing/{name}.toml"),
        "--quiet",
        "-o",
        output.to_str().unwrap(),
    ]);
    assert_eq!(run.exit, Some(0), "{run:?}");
    serde_json::from_str(&std::fs::read_to_string(output.join("explore.json")).unwrap()).unwrap()
}

fn number(point: &Value, key: &str) -> f64 {
    point[key].as_f64().unwrap_or_else(|| panic!("{key} of {point}"))
}

fn list<'a>(of: &'a Value, key: &str) -> &'a Vec<Value> {
    of[key].as_array().unwrap()
}

/// Size of a quantity at a profile crowning of 1 um, one for each body of the study.
fn at_one_micrometre(study: &Value, key: &str) -> Vec<f64> {
    let nearest = |curve: &Value| {
        let off = |p: &&Value| (number(p, "crowning_um") - 1.0).abs();
        let point = list(curve, "points").iter().min_by(|a, b| off(a).total_cmp(&off(b))).unwrap().clone();
        assert!((number(&point, "crowning_um") - 1.0).abs() < 0.06);
        number(&point, key).abs()
    };
    list(study, "crowning").iter().map(nearest).collect()
}

fn rises(values: &[f64]) -> bool {
    values.windows(2).all(|w| w[1] > w[0])
}

fn falls(values: &[f64]) -> bool {
    values.windows(2).all(|w| w[1] < w[0])
}

/// Figure 6: steep at both ends; on the left distance, phase and offset run away at the pole of the K chart, the angle does not.
#[test]
fn the_range_of_crownings_ends_steeply() {
    let study = study("figure-06");
    let curve = &study["crowning"][0];
    assert_eq!(
        (&curve["least"]["reason"], &curve["most"]["reason"]),
        (&"fold".into(), &"contact lost".into())
    );
    assert!((number(&curve["least"], "crowning_um") + 0.3571).abs() < 1e-3);
    let points = list(curve, "points");
    let (first, last) = (&points[0], &points[points.len() - 1]);
    assert!(number(first, "d_d_mm") < -100.0 && number(first, "d_phi_S_deg") > 45.0);
    assert!(number(first, "d_v_yA_mm").abs() > 100.0 && number(first, "d_gamma_deg").abs() < 5.0);
    assert!(number(last, "stretch") > 0.5);
}

/// Figures 8 to 11: larger worms, fewer threads, larger dressers and smaller pressure angles take larger corrections.
#[test]
fn bodies_change_the_corrections_as_published() {
    let (worms, threads, dressers, angles) =
        (study("figure-08-13b"), study("figure-09-13a"), study("figure-10-13c"), study("figure-11-13d"));
    for key in ["d_phi_S_deg", "d_gamma_deg", "d_d_mm"] {
        assert!(rises(&at_one_micrometre(&worms, key)), "{key} over the worm's diameter");
        assert!(falls(&at_one_micrometre(&threads, key)), "{key} over the threads");
        assert!(rises(&at_one_micrometre(&dressers, key)), "{key} over the dresser's diameter");
        assert!(falls(&at_one_micrometre(&angles, key)), "{key} over the pressure angle");
    }
    assert!(rises(&at_one_micrometre(&worms, "v_zS_mm")));
    // The numbers of the table, which are rounded and of a used profile that differs by its clearances.
    let near = |found: &[f64], wanted: &[f64]| {
        found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 0.02 * b + 0.01) && found.len() == wanted.len()
    };
    assert!(near(&at_one_micrometre(&worms, "d_phi_S_deg"), &[0.20, 0.27, 0.51, 2.4, 9.4]));
    assert!(near(&at_one_micrometre(&threads, "d_gamma_deg"), &[2.66, 1.78, 1.27, 0.73, 0.46]));
    assert!(near(&at_one_micrometre(&dressers, "d_d_mm"), &[0.05, 0.10, 0.17, 0.27, 0.41]));
    // Figure 13: P rises with the crowning, but at d_S 300 it is not monotone and changes its sign.
    let stretch =
        |curve: &Value| -> Vec<f64> { list(curve, "points").iter().map(|p| number(p, "stretch")).collect() };
    let of_worms = list(&worms, "crowning");
    assert!(rises(&stretch(&of_worms[1])));
    let largest = stretch(&of_worms[of_worms.len() - 1]);
    assert!(!rises(&largest) && !falls(&largest));
    assert!(largest.iter().any(|&p| p > 0.0) && largest.iter().any(|&p| p < 0.0));
}

/// Figure 12: the profile through three points is the parabola to 0.03 um at 10 um, stretched by 13 %.
#[test]
fn three_points_make_a_parabola() {
    let study = study("figure-12");
    let curves = list(&study, "profile");
    let ten = curves.iter().map(|c| &c["point"]).find(|p| number(p, "crowning_um") == 10.0).unwrap();
    assert!(
        (number(ten, "deviation_um") - 0.033).abs() < 0.005 && (number(ten, "stretch") - 0.129).abs() < 0.005
    );
}

/// Figure 19: on smaller worms P leaves 0, the more the more threads; the pressure angle without stretch falls with the diameter.
#[test]
fn a_dresser_on_smaller_worms_stretches() {
    let worms = study("figure-19a-c");
    let smallest: Vec<f64> =
        list(&worms, "worms").iter().map(|c| number(&c["points"][0], "stretch").abs()).collect();
    assert!(rises(&smallest), "{smallest:?}");
    for curve in list(&worms, "worms") {
        let points = list(curve, "points");
        let stretch: Vec<f64> = points.iter().map(|p| number(p, "stretch").abs()).collect();
        assert!(falls(&stretch) && stretch[stretch.len() - 1] < 1e-9, "{stretch:?}");
        let angles: Vec<f64> =
            points.iter().filter_map(|p| p["angle_without_stretch_deg"].as_f64()).collect();
        assert!(rises(&angles) && angles.len() > 5, "{angles:?}");
    }
    for curve in list(&study("figure-19b"), "worms") {
        let stretch: Vec<f64> = list(curve, "points").iter().map(|p| number(p, "stretch")).collect();
        assert!(falls(&stretch) && stretch[0] > 0.0 && stretch[stretch.len() - 1] < 0.0, "{stretch:?}");
    }
}

/// Flanks of an asymmetric gear: one cylindrical worm shares what stretch is left between them, a conical one has none.
#[test]
fn a_cone_takes_the_stretch_off_both_flanks() {
    let worms = study("asymmetric-worm-life");
    let points = list(&list(&worms, "worms")[0], "points");
    for point in &points[..points.len() - 1] {
        let both = &point["both_flanks"];
        let of = |worm: &str, side: &str| number(&both[worm], &format!("stretch_{side}"));
        let (left, right) = (of("cylindrical", "left"), of("cylindrical", "right"));
        assert!((left + right).abs() < 1e-9 && left.abs() > 1e-7, "{both}");
        assert!(left.abs() < 0.01 * number(point, "stretch").abs(), "{point}");
        for side in ["left", "right"] {
            assert!(of("conical", side).abs() < 1e-9, "{both}");
        }
        assert!(number(&both["conical"], "cone_angle_deg") < 0.0, "{both}");
    }
}
