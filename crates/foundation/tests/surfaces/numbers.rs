//! The numbers of the reference file: points, normals, derived data, curvatures.

use super::cases::{bevel_gear, blade_data, cylindrical_gear, number, numbers, reference, surface, vector};
use foundation::geometry::{Flank, FlankLine, Helicoid, RuledBlade, SphericalInvolute, Surface};

const CASES: [&str; 6] = ["spur", "helical", "internal", "straight_bevel", "spiral_bevel", "blade"];

fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{what}: {found} against {expected}");
}

#[test]
fn points_and_normals_of_all_cases() {
    let reference = reference();
    for case in CASES {
        let (surface, points) = (surface(case), &reference["cases"][case]["flank_points"]);
        let (a, b) = (numbers(&points["a"]), numbers(&points["b"]));
        assert_eq!(a.len(), 5);
        for i in 0..a.len() {
            let jet = surface.jet(a[i], b[i]);
            let miss = (jet.point - vector(&points["P_mm"][i])).norm();
            assert!(miss < 1e-12, "{case} {i}: {miss:e} mm");
            let tilt = (jet.normal - vector(&points["n"][i])).norm();
            assert!(tilt < 1e-13, "{case} {i}: normal {tilt:e}");
            assert!((jet.point - surface.point(a[i], b[i])).norm() < 1e-13, "{case}");
        }
    }
}

#[test]
fn derived_data_of_cylindrical_gears() {
    for case in &CASES[..3] {
        let case_data = &reference()["cases"][case];
        let (input, derived) = (&case_data["input"], &case_data["derived"]);
        let flank = Helicoid::new(&cylindrical_gear(input), Flank::Left);
        let form = flank.length_of_roll(number(&input["r_form"])).unwrap();
        let tip = flank.length_of_roll(flank.tip_radius(1.0)).unwrap();
        for (key, found) in [
            ("r", flank.pitch_radius()),
            ("rb", flank.base_radius()),
            ("etab", flank.base_space_half_angle()),
            ("ra", flank.tip_radius(1.0)),
            ("rf", flank.root_radius(1.25)),
            ("bb", flank.base_helix_angle()),
            ("k", flank.twist()),
        ] {
            close(key, found, number(&derived[key]), 1e-12);
        }
        close("a_root", form, number(&case_data["a_root"]), 1e-11);
        close("a_tip", tip, number(&case_data["a_tip"]), 1e-11);
        assert!(flank.check_tip(flank.tip_radius(1.0)).is_ok());
    }
}

#[test]
fn derived_data_of_bevel_gears() {
    for case in ["straight_bevel", "spiral_bevel"] {
        let case_data = &reference()["cases"][case];
        let derived = &case_data["derived"];
        let gear = bevel_gear(case);
        for (key, found) in [
            ("etab", gear.base_space_half_angle()),
            ("Re", gear.outer_distance()),
            ("Rm", gear.mean_distance()),
            ("db", gear.base_angle()),
            ("d0", gear.root_angle()),
            ("da", gear.tip_angle()),
            ("xip", gear.pitch_roll()),
        ] {
            close(key, found, number(&derived[key]), 1e-12);
        }
        let [root, tip] = gear.heights();
        close("a_root", root, number(&case_data["a_root"]), 1e-13);
        close("a_tip", tip, number(&case_data["a_tip"]), 1e-13);
        match gear.line() {
            FlankLine::Circular(line) => close("E", line.centre_distance(), number(&derived["E"]), 1e-12),
            line => assert_eq!((line, case), (&FlankLine::Straight, "straight_bevel")),
        }
    }
}

#[test]
fn principal_curvatures_of_the_blade() {
    let reference = reference();
    let blade = RuledBlade::of_data(&blade_data(&reference["cases"]["blade"]["input"])).unwrap();
    let items = reference["blade_limits"]["items"].as_array().unwrap();
    assert_eq!(items.len(), 9);
    for item in items {
        // u is that of the column: the flank's point lies in the plane across the guide curve, which is the hub's.
        let (v, lead) = (number(&item["v"]), number(&item["u"]));
        let [c, tangent, ..] = blade.hub().derivatives(lead);
        let mut u = lead;
        for _ in 0..50 {
            let jet = blade.jet(v, u);
            u -= (jet.point - c).dot(&tangent) / jet.by_length.dot(&tangent);
        }
        let jet = blade.jet(v, u);
        let first = jet.by_height.normalize();
        let second = jet.normal.cross(&first);
        let [k_11, k_12, k_22] = jet.curvatures(&first, &second);
        let back = second.dot(&jet.normal_change(&first));
        assert!((k_12 - back).abs() < 1e-15, "the shape operator is symmetric: {k_12} {back}");
        let (mean, half) = ((k_11 + k_22) / 2.0, ((k_11 - k_22) / 2.0).hypot(k_12));
        let expected = numbers(&item["principal_per_mm"]);
        close("least curvature", mean - half, expected[0], 1e-9 * expected[0].abs());
        close("largest curvature", mean + half, expected[1], 1e-9 * expected[1].abs());
        close("ball", -1.0 / (mean - half), number(&item["R_ball_max_mm"]), 1e-6);
    }
}

#[test]
fn curvatures_of_developable_flanks_are_the_closed_forms() {
    let reference = reference();
    let gear = cylindrical_gear(&reference["cases"]["helical"]["input"]);
    let flank = Helicoid::new(&gear, Flank::Left);
    let jet = principal(&flank, 30.0, 7.0);
    close("helicoid", jet[0], flank.base_helix_angle().cos() / 30.0, 1e-15);
    close("generator", jet[1], 0.0, 1e-15);
    let bevel = bevel_gear("straight_bevel");
    let flank = SphericalInvolute::new(&bevel, Flank::Right);
    let (omega, distance) = (0.4, 60.0);
    let jet = principal(&flank, omega, distance);
    let xi: f64 = omega * bevel.base_angle().sin();
    close("spherical involute", jet[0], 1.0 / (xi.tan() * distance), 1e-15);
    close("ray", jet[1], 0.0, 1e-15);
}

/// Curvature along S_a and across it.
fn principal(surface: &dyn Surface, a: f64, b: f64) -> [f64; 2] {
    let jet = surface.jet(a, b);
    let first = jet.by_height.normalize();
    let [k_11, k_12, k_22] = jet.curvatures(&first, &jet.normal.cross(&first));
    assert!(k_12.abs() < 1e-15, "S_a is a principal direction");
    [k_11, k_22]
}
