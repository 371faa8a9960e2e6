//! The algebra of modifications against the reference numbers, dual numbers, and bad input.

use foundation::geometry::Flank;
use foundation::modification::{
    EvaluationError, EvaluationField, GridTable, Modification, ModificationError, ModificationFiles,
    ModificationSpec, ModificationWarning, NoFiles, Smoothness,
};
use foundation::numerics::{Jet2, Polynomial2};
use num_dual::{DualNum, HyperDual64};
use proptest::prelude::*;
use serde_json::{Value, json};

/// w_f = 6, w_a = 20, z = -12 .. 18 (deliberately not symmetric), r_b = 38 mm, beta_b = 18 degrees.
fn field() -> EvaluationField {
    EvaluationField::new([6.0, 20.0], [-12.0, 18.0], 38.0, 18f64.to_radians()).unwrap()
}

fn spec(value: Value) -> ModificationSpec {
    ModificationSpec::from_json(&value).unwrap_or_else(|error| panic!("{value}: {error}"))
}

fn build(value: Value) -> Modification {
    Modification::build(&spec(value.clone()), &field()).unwrap_or_else(|error| panic!("{value}: {error}"))
}

fn refusal(value: Value) -> ModificationError {
    match ModificationSpec::from_json(&value) {
        Ok(spec) => Modification::build(&spec, &field()).map(|_| ()).unwrap_err(),
        Err(error) => error,
    }
}

fn table() -> Value {
    let w: Vec<f64> = (0..6).map(|i| 5.0 + 3.1 * f64::from(i)).collect();
    let z = [-13.0, -6.0, 0.0, 4.0, 11.0, 15.0, 19.0];
    let f: Vec<Vec<f64>> = w
        .iter()
        .map(|w| z.iter().map(|z| 5.0 * (0.2 * w + 0.1 * z).sin() - 0.01 * w * z).collect())
        .collect();
    json!({ "kind": "grid", "w_mm": w, "z_mm": z, "f_um": f })
}

fn cloud(method: &str) -> Value {
    let mut points = Vec::new();
    for i in 0..12 {
        for j in 0..10 {
            let (w, z) = (5.5 + 1.4 * f64::from(i), -13.0 + 3.6 * f64::from(j));
            points.push([w, z, 0.1 * w * w - 0.02 * z * z + 0.05 * w * z]);
        }
    }
    json!({ "kind": "points", "points": points, "method": method })
}

fn traces(count: usize) -> Value {
    let w = &[7.0, 12.0, 19.0][..count];
    let z = [-12.0, -7.0, 0.0, 4.0, 9.0, 18.0];
    let f: Vec<Vec<f64>> =
        w.iter().map(|w| z.iter().map(|z| 3.0 * (0.1 * w + 0.2 * z).cos() + 0.1 * w).collect()).collect();
    json!({ "kind": "helix_traces", "w_mm": w, "z_mm": z, "f_um": f })
}

/// One example of every kind, with its expected smoothness.
fn every_kind() -> Vec<(Value, Smoothness)> {
    use Smoothness::{C0, C1, C2, Cinf};
    vec![
        (json!({"kind": "profile_crowning", "amount_um": 8.0}), Cinf),
        (json!({"kind": "profile_crowning_arc", "amount_um": -2500.0}), Cinf),
        (json!({"kind": "profile_crowning_radius", "amount_um": 8.0}), Cinf),
        (json!({"kind": "profile_slope_radius", "amount_um": -3.0}), Cinf),
        (json!({"kind": "helix_crowning", "amount_um": 10.0, "reference": "normal"}), Cinf),
        (json!({"kind": "helix_crowning_arc", "amount_um": 4000.0}), Cinf),
        (
            json!({"kind": "helix_crowning_two_arc", "apex_z_mm": 2.0, "amount_I_um": 6.0, "amount_II_um": 14.0}),
            C1,
        ),
        (
            json!({"kind": "profile_crowning_two_arc", "apex_w_mm": 11.0, "amount_I_um": -6.0, "amount_II_um": 9.0}),
            C1,
        ),
        (json!({"kind": "profile_slope", "amount_um": 5.0}), Cinf),
        (json!({"kind": "helix_slope", "amount_um": -7.0}), Cinf),
        (json!({"kind": "twist", "amount_um": 12.0}), Cinf),
        (json!({"kind": "tip_relief", "amount_um": 20.0, "length_mm": 4.0}), C0),
        (json!({"kind": "root_relief", "amount_um": 15.0, "length_mm": 3.0, "transition_mm": 1.0}), C1),
        (json!({"kind": "end_relief_I", "amount_um": 18.0, "length_mm": 5.0, "exponent": 2}), C1),
        (json!({"kind": "end_relief_II", "amount_um": 18.0, "length_mm": 6.0, "exponent": 2.6}), C2),
        (
            json!({"kind": "triangular_end_relief", "amount_um": 30.0, "corner_profile": "tip", "corner_face": "II",
                   "length_w_mm": 6.0, "length_z_mm": 9.0, "transition": 0.2}),
            C1,
        ),
        (
            json!({"kind": "triangular_end_relief", "amount_um": 25.0, "corner_profile": "root", "corner_face": "I",
                   "length_w_mm": 7.0, "length_z_mm": 8.0, "exponent": 2}),
            C1,
        ),
        (json!({"kind": "directed_crowning", "amount_um": 10.0, "rho_deg": 35.0}), Cinf),
        (
            json!({"kind": "waviness", "rho_deg": -40.0, "wavelength_mm": 3.0, "phase_deg": 25.0, "amp_0_um": 1.0,
                   "amp_uu_um": 0.8, "amp_vv_um": 0.6}),
            Cinf,
        ),
        (
            json!({"kind": "polynomial", "w0_mm": 12.0, "z0_mm": 1.0,
                   "terms": [[0, 0, 1.0], [1, 0, -0.4], [1, 1, 0.05], [2, 1, 0.01], [0, 3, -0.002]]}),
            Cinf,
        ),
        (table(), C2),
        (cloud("linear"), C0),
        (cloud("spline"), C2),
        (
            json!({"kind": "sum", "children": [{"kind": "twist", "amount_um": 3.0}, table(),
                   {"kind": "tip_relief", "amount_um": 9.0, "length_mm": 4.0, "exponent": 2}]}),
            C1,
        ),
        (
            json!({"kind": "product", "children": [{"kind": "helix_crowning_arc", "amount_um": 5000.0},
                   {"kind": "waviness", "rho_deg": 20.0, "wavelength_mm": 9.0, "amp_0_um": 700.0}, table()]}),
            C2,
        ),
        (json!({"kind": "scale", "factor": -1.5, "children": [table()]}), C2),
        (
            json!({"kind": "mirror", "axis": "z", "children": [table(),
                   {"kind": "end_relief_II", "amount_um": 18.0, "length_mm": 6.0, "exponent": 3}]}),
            C2,
        ),
        (json!({"kind": "formula", "f_um": "3 - 20*v^2 + 4*u*v - 0.01*(w - w_f)^2*(z - z_I)/2"}), Cinf),
        (
            json!({"kind": "formula", "f_um": "5*sin(2*pi*(w + 0.3*z)/9)*exp(-v^2) + sqrt(w^2 + 38^2) - ln(w)*tanh(u) + 2^u/(2 + v)"}),
            Cinf,
        ),
        (json!({"kind": "formula", "f_um": "-20*max(w - (w_a - 4), 0)/4 - 3*abs(u + 0.007)"}), C0),
        (json!({"kind": "formula", "f_um": "-8*max(0, -v - 0.501)^2 - min(u - 0.303, 0)^3"}), C1),
        (traces(2), C2),
        (traces(3), C2),
    ]
}

#[test]
fn reference_items_agree() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/reference/25-modifications.json");
    let file: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let block = &file["elementary"];
    let length = |key: &str| block["geometry_mm"][key].as_f64().unwrap();
    let beta_b = block["beta_b_deg"].as_f64().unwrap().to_radians();
    let field = EvaluationField::new(
        [length("w_f"), length("w_a")],
        [length("z_I"), length("z_II")],
        length("r_b"),
        beta_b,
    )
    .unwrap();
    let tolerance = block["tolerance_um"].as_f64().unwrap();
    let list = |value: &Value| -> Vec<f64> {
        value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
    };
    let (w, z) = (list(&block["points_w_mm"]), list(&block["points_z_mm"]));
    let items = block["items"].as_array().unwrap();
    assert_eq!(items.len(), 23);
    for item in items {
        let modification = Modification::build(&spec(item["spec"].clone()), &field).unwrap();
        for (k, expected) in list(&item["f_t_um"]).into_iter().enumerate() {
            let found = 1e3 * modification.value(w[k], z[k]).unwrap();
            assert!(
                (found - expected).abs() <= tolerance,
                "{} at point {k}: {found} for {expected}",
                item["spec"]
            );
        }
    }
}

/// The table of the specification in plain formulas (mm), for dual numbers.
fn formula<D: DualNum<Primitive = f64> + Copy>(kind: usize, w: D, z: D) -> D {
    let (w_m, z_m, half_a, half_b) = (13.0, 3.0, 7.0, 15.0);
    let um = 1e-3;
    let arc = |x: D, half: f64, c: f64| {
        let r = (half * half + c * c) / (2.0 * c);
        (x * x).neg() * c.signum() / ((-(x * x) + r * r).sqrt() + r.abs())
    };
    let radius = |w: D| (w * w + 38.0 * 38.0).sqrt();
    let (r_f, r_a) = (6f64.hypot(38.0), 20f64.hypot(38.0));
    let xi = |w: D| (radius(w) - 0.5 * (r_f + r_a)) / (0.5 * (r_a - r_f));
    let ramp_h = |x: D, h: f64| {
        if x.re() <= -h {
            D::from(0.0)
        } else if x.re() < h {
            (x + h) * (x + h) / (4.0 * h)
        } else {
            x
        }
    };
    let power = |x: D, p: f64| if x.re() > 0.0 { x.powf(p) } else { D::from(0.0) };
    let two = |x: D, below: f64, above: f64| x * x * if x.re() < 0.0 { below } else { above };
    match kind {
        0 => -((w - w_m) / half_a).powi(2) * (8.0 * um),
        1 => arc(w - w_m, half_a, -2500.0 * um),
        2 => -xi(w) * xi(w) * (8.0 * um),
        3 => xi(w) * (3.0 * um),
        4 => -((z - z_m) / half_b).powi(2) * (10.0 * um / 18f64.to_radians().cos()),
        5 => arc(z - z_m, half_b, 4000.0 * um),
        6 => -two(z - 2.0, 6.0 * um / (14.0 * 14.0), 14.0 * um / (16.0 * 16.0)),
        7 => -two(w - 11.0, -6.0 * um / 25.0, 9.0 * um / 81.0),
        8 => -(w - 6.0) * (5.0 * um / 14.0),
        9 => (z + 12.0) * (7.0 * um / 30.0),
        10 => -(w - w_m) * (z - z_m) * (12.0 * um / (14.0 * 30.0)),
        11 => -ramp_h(w - 16.0, 0.0) * (20.0 * um / 4.0),
        12 => -ramp_h(-w + 9.0, 1.0) * (15.0 * um / 3.0),
        13 => -power((-z - 7.0) / 5.0, 2.0) * (18.0 * um),
        14 => -power((z - 12.0) / 6.0, 2.6) * (18.0 * um),
        15 => -ramp_h((w - 20.0) / 6.0 + (z - 18.0) / 9.0 + 1.0, 0.2) * (30.0 * um),
        16 => -power(-(w - 6.0) / 7.0 - (z + 12.0) / 8.0 + 1.0, 2.0) * (25.0 * um),
        17 => {
            let (sin, cos) = 35f64.to_radians().sin_cos();
            let x = ((w - w_m) * sin + (z - z_m) * cos) * 2.0 / (14.0 * sin + 30.0 * cos);
            -x * x * (10.0 * um)
        }
        18 => {
            let (sin, cos) = (-40f64).to_radians().sin_cos();
            let (u, v) = ((w - w_m) / half_a, (z - z_m) / half_b);
            let wave = (w * sin + z * cos) * (std::f64::consts::TAU / 3.0) + 25f64.to_radians();
            (u * u * 0.8 + v * v * 0.6 + 1.0) * wave.sin() * um
        }
        _ => {
            let (x, y) = (w - 12.0, z - 1.0);
            (x * -0.4 + x * y * 0.05 + x * x * y * 0.01 - y * y * y * 0.002 + 1.0) * um
        }
    }
}

/// Second-order jet of a formula by dual numbers: hyper-dual numbers give one mixed second derivative a run.
fn dual_jet(kind: usize, w: f64, z: f64) -> Jet2 {
    let run = |a: [f64; 2], b: [f64; 2]| {
        let (w, z) = (HyperDual64::new(w, a[0], b[0], 0.0), HyperDual64::new(z, a[1], b[1], 0.0));
        formula(kind, w, z)
    };
    let (ww, wz, zz) =
        (run([1.0, 0.0], [1.0, 0.0]), run([1.0, 0.0], [0.0, 1.0]), run([0.0, 1.0], [0.0, 1.0]));
    Jet2 { f: ww.re, fu: ww.eps1, fv: zz.eps1, fuu: ww.eps1eps2, fuv: wz.eps1eps2, fvv: zz.eps1eps2 }
}

fn list(jet: Jet2) -> [f64; 6] {
    [jet.f, jet.fu, jet.fv, jet.fuu, jet.fuv, jet.fvv]
}

/// Points over the field and a little beyond, none of them on a kink.
fn sample() -> impl Iterator<Item = (f64, f64)> {
    (0..15).flat_map(|i| (0..15).map(move |j| (5.613 + 1.03 * f64::from(i), -12.31 + 2.171 * f64::from(j))))
}

#[test]
fn derivatives_of_closed_forms_agree_with_dual_numbers() {
    for (kind, (value, _)) in every_kind().into_iter().take(20).enumerate() {
        let modification = build(value.clone());
        for (w, z) in sample() {
            let expected = list(dual_jet(kind, w, z));
            let found = list(modification.jet(w, z).unwrap());
            for (k, (a, b)) in found.into_iter().zip(expected).enumerate() {
                assert!(
                    (a - b).abs() <= 1e-12 * (1.0 + b.abs()),
                    "{value} entry {k} at {w}, {z}: {a} for {b}"
                );
            }
        }
    }
}

#[test]
fn derivatives_of_every_kind_agree_with_differences() {
    for (value, smoothness) in every_kind() {
        let modification = build(value.clone());
        // Central differences over cells that hold no kink: the pieces are smooth there.
        let step = 1e-4;
        for (w, z) in sample().filter(|(w, z)| (6.0..=20.0).contains(w) && (-12.0..=18.0).contains(z)) {
            let at = |i: f64, j: f64| modification.jet(w + i * step, z + j * step).unwrap();
            let jet = at(0.0, 0.0);
            let (e, west, n, s) = (at(1.0, 0.0), at(-1.0, 0.0), at(0.0, 1.0), at(0.0, -1.0));
            let slope = |a: f64, b: f64| (a - b) / (2.0 * step);
            let expected = [
                modification.value(w, z).unwrap(),
                slope(e.f, west.f),
                slope(n.f, s.f),
                slope(e.fu, west.fu),
                slope(e.fv, west.fv),
                slope(n.fv, s.fv),
            ];
            let tolerance = if smoothness == Smoothness::C0 { 1e-7 } else { 2e-6 };
            for (k, (a, b)) in list(jet).into_iter().zip(expected).enumerate() {
                assert!((a - b).abs() < tolerance, "{value} entry {k} at {w}, {z}: {a} for {b}");
            }
            assert_eq!(modification.gradient(w, z).unwrap(), (jet.fu, jet.fv));
        }
    }
}

#[test]
fn kinks_give_the_mean_of_both_sides() {
    let relief = build(json!({"kind": "tip_relief", "amount_um": 20.0, "length_mm": 4.0}));
    assert!((relief.gradient(16.0, 0.0).unwrap().0 + 0.5 * 0.020 / 4.0).abs() < 1e-15);
    let parabola = build(json!({"kind": "end_relief_I", "amount_um": 20.0, "length_mm": 4.0, "exponent": 2}));
    assert!((parabola.jet(10.0, -8.0).unwrap().fvv + 0.020 / 16.0).abs() < 1e-15);
    let rounded =
        build(json!({"kind": "tip_relief", "amount_um": 8.0, "length_mm": 4.0, "transition_mm": 1.0}));
    for (w, slope, bend) in
        [(15.0, 0.0, -5e-4), (16.0, -1e-3, -1e-3), (17.0, -2e-3, -5e-4), (18.0, -2e-3, 0.0)]
    {
        let jet = rounded.jet(w, 0.0).unwrap();
        assert!((jet.fu - slope).abs() < 1e-15 && (jet.fuu - bend).abs() < 1e-15, "{w}: {jet:?}");
    }
    let two = build(
        json!({"kind": "helix_crowning_two_arc", "apex_z_mm": 3.0, "amount_I_um": 9.0, "amount_II_um": 18.0}),
    );
    assert!((two.jet(9.0, 3.0).unwrap().fvv + 0.027 / 225.0).abs() < 1e-15);

    // A roof over two triangles and four: on an edge and on a vertex.
    let square = json!([[6, -12, 0], [20, -12, 0], [6, 18, 0], [20, 18, 0], [13, 3, 7]]);
    let roof = build(json!({"kind": "points", "points": square}));
    assert_eq!(roof.gradient(13.0, 3.0).unwrap(), (0.0, 0.0));
    assert!((roof.value(13.0, 3.0).unwrap() - 0.007).abs() < 1e-15);
    let (west, south) = (0.001, 0.007 / 15.0);
    let (fu, fv) = roof.gradient(9.5, -4.5).unwrap();
    assert!((fu - 0.5 * west).abs() < 1e-12 && (fv - 0.5 * south).abs() < 1e-12, "{fu}, {fv}");
}

#[test]
fn smoothness_is_that_of_the_worst_child() {
    for (value, expected) in every_kind() {
        assert_eq!(build(value.clone()).smoothness(), expected, "{value}");
    }
}

#[test]
fn polynomials_are_recognised_with_exact_centred_coefficients() {
    let product = json!({"kind": "product", "children": [
        {"kind": "profile_crowning", "amount_um": 800.0},
        {"kind": "scale", "factor": 1.5, "children": [{"kind": "directed_crowning", "amount_um": 500.0, "rho_deg": 70.0}]}]});
    let mirrored = json!({"kind": "mirror", "children": [product, {"kind": "helix_slope", "amount_um": 4.0},
        {"kind": "twist", "amount_um": 5.0}]});
    let polynomials = [0, 4, 8, 9, 10, 17, 19, 27].map(|i| every_kind()[i].0.clone());
    for value in polynomials.into_iter().chain([product.clone(), mirrored]) {
        let modification = build(value.clone());
        let polynomial = modification.polynomial().unwrap_or_else(|| panic!("{value} is a polynomial"));
        for (w, z) in sample() {
            let (a, b) = (polynomial.jet(w - 13.0, z - 3.0), modification.jet(w, z).unwrap());
            for (a, b) in list(a).into_iter().zip(list(b)) {
                assert!((a - b).abs() < 1e-13, "{value}");
            }
        }
    }
    let crowning = build(json!({"kind": "helix_crowning", "amount_um": 10.0})).polynomial().unwrap();
    assert_eq!(crowning, Polynomial2::from_terms([(0, 2, -0.010 / 225.0)]));
    let others =
        [1, 2, 3, 5, 6, 7, 11, 12, 13, 14, 15, 16, 18, 20, 21, 22, 23, 24, 25, 26, 28, 29, 30, 31, 32];
    for i in others {
        let value = every_kind()[i].0.clone();
        assert!(build(value.clone()).polynomial().is_none(), "{value}");
    }
    let high = json!({"kind": "polynomial", "terms": [[40, 30, 1e-60]]});
    assert!(build(high).polynomial().is_none());
}

#[test]
fn functions_of_the_profile_alone_are_recognised() {
    let profile = [0, 1, 2, 3, 7, 8, 11, 12, 29];
    for (i, (value, _)) in every_kind().into_iter().enumerate() {
        assert_eq!(build(value.clone()).depends_on_profile_only(), profile.contains(&i), "{value}");
    }
    let composed = json!({"kind": "mirror", "children": [
        {"kind": "product", "children": [{"kind": "tip_relief", "amount_um": 9.0, "length_mm": 2.0},
            {"kind": "polynomial", "terms": [[3, 0, 1.0], [0, 1, 0.0]]}]},
        {"kind": "directed_crowning", "amount_um": 9.0, "rho_deg": -90.0}]});
    assert!(build(composed).depends_on_profile_only());
}

#[test]
fn sums_open_into_their_terms() {
    let nested = json!({"kind": "sum", "children": [{"kind": "twist", "amount_um": 3.0},
        {"kind": "sum", "children": [{"kind": "tip_relief", "amount_um": 9.0, "length_mm": 2.0}, table()]}]});
    let modification = build(nested);
    let terms = modification.terms();
    assert_eq!(terms.len(), 3);
    let sum: f64 = terms.iter().map(|term| term.value(19.0, 7.0).unwrap()).sum();
    assert!((sum - modification.value(19.0, 7.0).unwrap()).abs() < 1e-16);
}

#[test]
fn flanks_choose_their_modifications() {
    let specs = [
        spec(json!({"kind": "helix_slope", "amount_um": 30.0, "flank": "left"})),
        spec(json!({"kind": "profile_slope", "amount_um": 14.0})),
    ];
    let value = |flank| {
        Modification::for_flank(&specs, flank, &field(), &NoFiles).unwrap().value(20.0, 18.0).unwrap()
    };
    assert!((value(Flank::Left) + 0.044).abs() < 1e-15);
    assert!((value(Flank::Right) + 0.014).abs() < 1e-15);
    let none = Modification::none(&field());
    assert_eq!(none.value(9.0, 9.0), Ok(0.0));
    assert_eq!(none.polynomial(), Some(Polynomial2::constant(0.0)));
    assert!(none.depends_on_profile_only());
}

#[test]
fn reliefs_continue_beyond_the_field_and_mirrors_turn_the_face() {
    let relief = build(json!({"kind": "tip_relief", "amount_um": 20.0, "length_mm": 4.0}));
    assert!((relief.value(22.0, 0.0).unwrap() + 0.030).abs() < 1e-15);
    let mirrored = build(json!({"kind": "mirror", "axis": "z", "children": [table()]}));
    let plain = build(table());
    assert_eq!(mirrored.value(9.0, 4.3), plain.value(9.0, -4.3));
    assert!((plain.value(8.1, 4.0).unwrap() - 1e-3 * (5.0 * 2.02f64.sin() - 0.324)).abs() < 1e-15);
}

#[test]
fn clouds_interpolate_inside_their_hull_only() {
    // Bilinear data: the triangulation is exact at the points and linear between; the spline is exact.
    let linear = build(cloud("linear"));
    let spline = build(cloud("spline"));
    let f = |w: f64, z: f64| 1e-3 * (0.1 * w * w - 0.02 * z * z + 0.05 * w * z);
    assert!((linear.value(6.9, -9.4).unwrap() - f(6.9, -9.4)).abs() < 1e-15);
    for (w, z) in sample().filter(|(w, _)| *w < 20.9) {
        assert!((spline.value(w, z).unwrap() - f(w, z)).abs() < 1e-12);
        assert!((linear.value(w, z).unwrap() - f(w, z)).abs() < 2e-4);
    }
    assert!(linear.check_field().is_ok() && spline.check_field().is_ok());
    for modification in [&linear, &spline] {
        let error = modification.value(5.4, 0.0).unwrap_err();
        assert_eq!(error, EvaluationError::OutsidePointCloud { w: 5.4, z: 0.0 });
        // Rounded coordinates at the border still count as inside.
        assert!(modification.value(5.5 - 1e-9, 0.0).is_ok());
        assert!(modification.value(5.5 - 1e-9, -13.0 - 1e-9).is_ok());
    }
    let small = build(json!({"kind": "points", "points": [[7, 0, 1], [9, 0, 2], [8, 5, 3]]}));
    assert_eq!(small.check_field().unwrap_err().code(), "outside-point-cloud");
    assert_eq!(small.value(7.1, 4.9).unwrap_err().code(), "outside-point-cloud");
}

struct Shelf;

impl ModificationFiles for Shelf {
    fn grid(&self, file: &str) -> Result<GridTable, String> {
        let z_mm = match file {
            "flat.csv" => vec![-15.0, 0.0, 10.0, 20.0],
            "short.csv" => vec![0.0, 5.0, 10.0, 20.0],
            _ => return Err("no such file".into()),
        };
        Ok(GridTable { w_mm: vec![0.0, 10.0, 20.0, 30.0], z_mm, f_um: vec![vec![5.0; 4]; 4] })
    }

    fn traces(&self, file: &str) -> Result<GridTable, String> {
        self.grid(file).map(|table| GridTable {
            w_mm: vec![8.0, 18.0],
            f_um: vec![vec![5.0; 4], vec![7.0; 4]],
            ..table
        })
    }

    fn points(&self, _file: &str) -> Result<Vec<[f64; 3]>, String> {
        Ok(vec![[0.0, 0.0, 2.0], [40.0, 0.0, 2.0], [0.0, 40.0, 2.0]])
    }

    fn profile(&self, _file: &str) -> Result<Vec<[f64; 2]>, String> {
        Ok((0..20).map(|k| [2.0 * f64::from(k), 5.0]).collect())
    }
}

#[test]
fn files_come_from_the_caller() {
    let with = |value: Value| Modification::build_with_files(&spec(value), &field(), &Shelf);
    let grid = with(json!({"kind": "grid", "file": "flat.csv"})).unwrap();
    assert!((grid.value(9.0, 9.0).unwrap() - 0.005).abs() < 1e-15);
    let traces = with(json!({"kind": "helix_traces", "file": "flat.csv"})).unwrap();
    assert!((traces.value(9.0, 9.0).unwrap() - 0.0052).abs() < 1e-15);
    let profile = with(json!({"kind": "profile_trace", "file": "any.csv"})).unwrap();
    assert!((profile.value(9.0, 3.0).unwrap() - 0.005).abs() < 1e-12);
    let gone = with(json!({"kind": "helix_traces", "file": "gone.csv"})).unwrap_err();
    assert_eq!(gone.code(), "file-unavailable");
    let points = with(json!({"kind": "points", "file": "p.csv"})).unwrap();
    assert!((points.value(9.0, 9.0).unwrap() - 0.002).abs() < 1e-15);
    // A grid that ends inside the evaluation range says nothing beyond its last knots.
    let short = with(json!({"kind": "grid", "file": "short.csv"})).unwrap_err();
    assert_eq!(short.code(), "invalid-modification");
    assert!(
        short.to_string().contains("z_mm") && short.to_string().contains("cover the evaluation range"),
        "{short}"
    );
    let missing = with(json!({"kind": "grid", "file": "gone.csv"})).unwrap_err();
    assert_eq!(missing.to_string(), "grid: file is \"gone.csv\", allowed: a readable file (no such file)");
    assert_eq!(refusal(json!({"kind": "points", "file": "p.csv"})).code(), "file-unavailable");
    assert_eq!(
        refusal(json!({"kind": "points", "file": "p", "points": [[1, 2, 3]]})).code(),
        "invalid-modification"
    );
    let mut both = table();
    both["file"] = "flat.csv".into();
    assert_eq!(refusal(both).code(), "invalid-modification");
}

#[test]
fn descriptions_survive_a_round_trip() {
    for (value, _) in every_kind() {
        let parsed = spec(value.clone());
        assert_eq!(parsed.kind(), value["kind"]);
        let written = serde_json::to_value(&parsed).unwrap();
        assert_eq!(written["kind"], value["kind"]);
        assert_eq!(spec(written), parsed);
    }
    // The name that measuring exchange uses for the same list.
    let mut other = table();
    let f = other.as_object_mut().unwrap().remove("f_um").unwrap();
    other["f_t_um"] = f;
    assert_eq!(spec(other), spec(table()));
}

#[test]
fn unknown_keys_are_refused_inside_every_kind() {
    for (value, _) in every_kind() {
        let mut extra = value.clone();
        extra["amout_um"] = json!(1.0);
        assert!(serde_json::from_value::<ModificationSpec>(extra.clone()).is_err(), "{extra}");
        let error = ModificationSpec::from_json(&extra).unwrap_err();
        assert!(
            matches!(&error, ModificationError::InvalidModification { key, value, .. }
                if key == "amout_um" && value == "an unknown key"),
            "{error}"
        );
    }
    // The schema says the same, and lists every kind.
    let schema = schemars::schema_for!(ModificationSpec).to_value();
    let variants = schema["oneOf"].as_array().unwrap();
    assert_eq!(variants.len(), 30);
    for variant in variants {
        assert_eq!(variant["additionalProperties"], json!(false), "{variant}");
        assert!(variant["properties"]["kind"]["const"].is_string());
    }
}

#[test]
fn parse_errors_name_the_key() {
    let unknown = refusal(json!({"kind": "helix_crownig", "amount_um": 3.0}));
    assert_eq!(unknown.code(), "unknown-modification");
    assert!(unknown.way_out().contains("helix_crowning"), "{}", unknown.way_out());
    let key = |value: Value| match refusal(value) {
        ModificationError::InvalidModification { key, .. } => key,
        other => panic!("{other}"),
    };
    assert_eq!(key(json!({"kind": "helix_crowning"})), "amount_um");
    assert_eq!(key(json!({"amount_um": 3.0})), "kind");
    assert_eq!(key(json!(7)), "entry");
    assert_eq!(key(json!({"kind": "twist", "amount_um": "3"})), "amount_um");
    assert_eq!(key(json!({"kind": "twist", "amount_um": 3.0, "reference": "axial"})), "reference");
    assert_eq!(key(json!({"kind": "twist", "amount_um": 3.0, "flank": "upper"})), "flank");
    assert_eq!(
        key(json!({"kind": "mirror", "axis": "w", "children": [{"kind": "twist", "amount_um": 3}]})),
        "axis"
    );
    assert_eq!(key(json!({"kind": "sum", "children": [{"kind": "twist", "amount": 3}]})), "amount");
}

#[test]
fn bad_numbers_and_ranges_are_refused() {
    let relief = |key: &str, value: Value| {
        let mut relief = json!({"kind": "tip_relief", "amount_um": 9.0, "length_mm": 2.0});
        relief[key] = value;
        refusal(relief)
    };
    let cases = [
        (relief("length_mm", json!(0.0)), "length_mm", "0"),
        (relief("length_mm", json!(-1.0)), "length_mm", "-1"),
        (relief("exponent", json!(0.5)), "exponent", "0.5"),
        (relief("exponent", json!(1e9)), "exponent", "1000000000"),
        (relief("transition_mm", json!(-0.1)), "transition_mm", "-0.1"),
        (relief("reference", json!("sideways")), "reference", "\"sideways\""),
        (
            refusal(json!({"kind": "waviness", "rho_deg": 0, "wavelength_mm": 0, "amp_0_um": 1})),
            "wavelength_mm",
            "0",
        ),
        (
            refusal(
                json!({"kind": "helix_crowning_two_arc", "apex_z_mm": 18, "amount_I_um": 1, "amount_II_um": 1}),
            ),
            "apex_z_mm",
            "18",
        ),
        (
            refusal(
                json!({"kind": "profile_crowning_two_arc", "apex_w_mm": 5, "amount_I_um": 1, "amount_II_um": 1}),
            ),
            "apex_w_mm",
            "5",
        ),
        (
            refusal(json!({"kind": "triangular_end_relief", "amount_um": 1, "corner_profile": "tip",
                           "corner_face": "I", "length_w_mm": 1, "length_z_mm": 0})),
            "length_z_mm",
            "0",
        ),
        (refusal(json!({"kind": "polynomial", "terms": [[41, 0, 1.0]]})), "terms", "[41, 0, 1]"),
        (
            refusal(json!({"kind": "waviness", "rho_deg": 0, "wavelength_mm": 1, "amp_0_um": 1,
                        "reference": "normal"})),
            "reference",
            "normal",
        ),
        (refusal(json!({"kind": "sum", "children": []})), "children", "an empty list"),
        (
            refusal(json!({"kind": "sum", "children": [{"kind": "twist", "amount_um": 1, "flank": "left"}]})),
            "flank",
            "set on the part \"twist\"",
        ),
    ];
    for (error, wanted_key, wanted_value) in cases {
        assert_eq!(error.code(), "invalid-modification");
        let ModificationError::InvalidModification { key, value, allowed, .. } = &error else {
            panic!("{error}")
        };
        assert_eq!((key.as_str(), value.as_str()), (wanted_key, wanted_value));
        assert!(error.to_string().contains(wanted_key) && error.to_string().contains(allowed.as_str()));
        assert!(error.way_out().contains(wanted_key));
    }

    let huge = refusal(json!({"kind": "twist", "amount_um": 1e9}));
    assert_eq!(huge.code(), "invalid-number");
    assert_eq!(
        huge.to_string(),
        "twist: amount_um is 1000000000, allowed: finite numbers up to 1e5 in magnitude"
    );
    let mut not_a_number = spec(json!({"kind": "twist", "amount_um": 1.0}));
    if let ModificationSpec::Twist(twist) = &mut not_a_number {
        twist.amount_um = f64::NAN;
    }
    assert_eq!(Modification::build(&not_a_number, &field()).unwrap_err().code(), "invalid-number");

    let mut deep = json!({"kind": "twist", "amount_um": 1.0});
    for _ in 0..70 {
        deep = json!({"kind": "sum", "children": [deep]});
    }
    assert_eq!(refusal(deep).to_string(), "sum: children is nested too deeply, allowed: 64 levels");
}

#[test]
fn grids_and_clouds_are_checked() {
    let grid = |change: &dyn Fn(&mut Value)| {
        let mut grid = table();
        change(&mut grid);
        match refusal(grid) {
            ModificationError::InvalidModification { key, .. } => key,
            other => other.code().into(),
        }
    };
    assert_eq!(grid(&|g| g["w_mm"] = json!([1, 2, 3])), "w_mm");
    assert_eq!(grid(&|g| g["z_mm"][2] = json!(-6.0)), "z_mm");
    assert_eq!(grid(&|g| g["f_um"][2] = json!([1.0])), "f_um");
    assert_eq!(grid(&|g| g["f_um"][2][1] = json!(1e30)), "invalid-number");
    assert_eq!(grid(&|g| g["z_mm"][6] = json!(1e30)), "invalid-number");
    assert_eq!(grid(&|g| g["w_mm"] = json!([])), "w_mm");

    let points = |list: Value, method: &str| {
        refusal(json!({"kind": "points", "points": list, "method": method})).code()
    };
    assert_eq!(points(json!([[1, 2, 3], [2, 3, 4]]), "linear"), "too-few-points");
    assert_eq!(points(json!([[1, 2, 3], [2, 3, 4], [1, 2, 3]]), "linear"), "too-few-points");
    assert_eq!(points(json!([[1, 2, 3], [2, 3, 4], [3, 4, 5], [7, 8, 8]]), "linear"), "collinear-points");
    assert_eq!(points(json!([[1, 2, 3], [2, 3, 4], [3, 5, 5]]), "spline"), "too-few-points");
    assert_eq!(points(json!([[1, 2, 3], [2, 3, 4], [1, 2, 5]]), "linear"), "invalid-modification");
    assert_eq!(points(json!([[1, 2, 3], [2, 3, 4], [1, 5, 1e30]]), "linear"), "invalid-number");
    let line: Vec<[f64; 3]> = (0..20).map(|i| [f64::from(i), 0.1 * f64::from(i), 1.0]).collect();
    assert_eq!(points(json!(line), "spline"), "collinear-points");
    let two_rows: Vec<[f64; 3]> = (0..20).map(|i| [f64::from(i), f64::from(i % 2), 1.0]).collect();
    assert_eq!(points(json!(two_rows), "spline"), "too-few-points");
}

#[test]
fn arcs_end_where_the_circle_ends() {
    let deep = refusal(json!({"kind": "profile_crowning_arc", "amount_um": 7001.0}));
    assert_eq!(deep.code(), "arc-too-deep");
    assert!(deep.to_string().contains("7000") && deep.way_out().contains("profile_crowning\""));
    assert_eq!(refusal(json!({"kind": "helix_crowning_arc", "amount_um": -15000.1})).code(), "arc-too-deep");
    let half_circle = build(json!({"kind": "profile_crowning_arc", "amount_um": 7000.0}));
    assert!((half_circle.value(20.0, 0.0).unwrap() + 7.0).abs() < 1e-6);
    let error = half_circle.value(20.5, 0.0).unwrap_err();
    assert_eq!(error.code(), "beyond-arc");
    assert_eq!(error, EvaluationError::BeyondArc { w: 20.5, z: 0.0, distance: 7.5, radius: 7.0 });
    // A crowning of nothing is flat, one of next to nothing equals the parabola.
    assert_eq!(
        build(json!({"kind": "helix_crowning_arc", "amount_um": 0.0})).value(8.0, 18.0).unwrap().abs(),
        0.0
    );
    let flat = build(json!({"kind": "helix_crowning_arc", "amount_um": 1e-9}));
    assert!((flat.value(8.0, 18.0).unwrap() / -1e-12 - 1.0).abs() < 1e-12);
}

#[test]
fn bad_fields_are_refused() {
    let new = |roll, face, r_b, beta_b| EvaluationField::new(roll, face, r_b, beta_b).unwrap_err();
    let cases = [
        (new([5.0, 5.0], [0.0, 1.0], 30.0, 0.0), "w_f"),
        (new([-1.0, 5.0], [0.0, 1.0], 30.0, 0.0), "w_f"),
        (new([1.0, 5.0], [2.0, 1.0], 30.0, 0.0), "z_I"),
        (new([1.0, 5.0], [0.0, 1.0], 0.0, 0.0), "r_b"),
        (new([1.0, 5.0], [0.0, 1.0], 30.0, 1.57), "beta_b"),
    ];
    for (error, name) in cases {
        assert!(
            matches!(&error, ModificationError::InvalidModification { key, .. } if key == name),
            "{error}"
        );
    }
    assert_eq!(new([1.0, f64::NAN], [0.0, 1.0], 30.0, 0.0).code(), "invalid-number");
    assert_eq!(new([1.0, 5.0], [0.0, 1e300], 30.0, 0.0).code(), "invalid-number");
}

#[test]
fn doubtful_input_is_accepted_with_a_warning() {
    let long = build(json!({"kind": "sum", "children": [
        {"kind": "tip_relief", "amount_um": 9.0, "length_mm": 15.0},
        {"kind": "end_relief_I", "amount_um": 9.0, "length_mm": 15.0, "exponent": 2, "transition_mm": 1.0}]}));
    let [first, second] = long.warnings() else { panic!("{:?}", long.warnings()) };
    assert_eq!(first.code(), "relief-longer-than-field");
    assert!(matches!(
        first,
        ModificationWarning::ReliefLongerThanField { length: 15.0, field_length: 14.0, .. }
    ));
    assert_eq!(second.code(), "transition-without-effect");
    assert!(first.to_string().starts_with("tip_relief: length_mm is 15 mm"));
    assert!(second.to_string().contains("exponent 2"));
}

#[test]
fn points_without_a_finite_value_are_errors() {
    let twist = build(json!({"kind": "twist", "amount_um": 9.0}));
    assert_eq!(twist.value(f64::NAN, 0.0).unwrap_err().code(), "amount-not-finite");
    assert_eq!(twist.jet(0.0, f64::INFINITY).unwrap_err().code(), "amount-not-finite");
    assert_eq!(twist.value(1e300, 1e300).unwrap_err().code(), "amount-not-finite");
    let error: ModificationError = twist.value(1e300, 1e300).unwrap_err().into();
    assert_eq!(error.code(), "amount-not-finite");
    assert!(!error.way_out().is_empty());
}

fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => -50.0..50.0,
        1 => Just(0.0),
        1 => -1e7..1e7,
        1 => proptest::num::f64::NORMAL,
        1 => Just(1e-300),
    ]
}

fn any_leaf() -> impl Strategy<Value = Value> {
    let plain = proptest::sample::select(vec![
        "profile_crowning",
        "profile_crowning_arc",
        "profile_crowning_radius",
        "profile_slope_radius",
        "helix_crowning",
        "helix_crowning_arc",
        "profile_slope",
        "helix_slope",
        "twist",
    ]);
    let relief = proptest::sample::select(vec!["tip_relief", "root_relief", "end_relief_I", "end_relief_II"]);
    prop_oneof![
        (plain, any_number()).prop_map(|(kind, c)| json!({"kind": kind, "amount_um": c})),
        (relief, any_number(), any_number(), 0.5..4.0, any_number()).prop_map(|(kind, c, l, p, h)| json!({
            "kind": kind, "amount_um": c, "length_mm": l, "exponent": if p < 1.0 { 1.0 } else { p }, "transition_mm": h
        })),
        (any_number(), any_number(), any_number()).prop_map(|(a, b, c)| json!({
            "kind": "helix_crowning_two_arc", "apex_z_mm": a, "amount_I_um": b, "amount_II_um": c
        })),
        (any_number(), any_number(), any_number(), any_number()).prop_map(|(c, a, b, h)| json!({
            "kind": "triangular_end_relief", "amount_um": c, "corner_profile": "root", "corner_face": "II",
            "length_w_mm": a, "length_z_mm": b, "transition": h
        })),
        (any_number(), any_number()).prop_map(|(c, rho)| json!({
            "kind": "directed_crowning", "amount_um": c, "rho_deg": rho
        })),
        (any_number(), any_number(), any_number(), any_number()).prop_map(|(rho, l, a, b)| json!({
            "kind": "waviness", "rho_deg": rho, "wavelength_mm": l, "amp_0_um": a, "amp_vv_um": b
        })),
        (any_number(), any_number(), proptest::collection::vec((0u32..44, 0u32..44, any_number()), 0..4))
            .prop_map(|(w, z, terms)| json!({"kind": "polynomial", "w0_mm": w, "z0_mm": z, "terms": terms})),
        (
            proptest::collection::vec([any_number(), any_number(), any_number()], 0..24),
            proptest::sample::select(vec!["linear", "spline"])
        )
            .prop_map(|(points, method)| json!({"kind": "points", "points": points, "method": method})),
        proptest::collection::vec(any_number(), 24).prop_map(|x| {
            let mut w = x[..4].to_vec();
            w.sort_by(f64::total_cmp);
            let mut z = x[4..8].to_vec();
            z.sort_by(f64::total_cmp);
            let f: Vec<&[f64]> = x[8..].chunks(4).collect();
            json!({"kind": "grid", "w_mm": w, "z_mm": z, "f_um": f})
        }),
    ]
}

fn any_spec() -> impl Strategy<Value = Value> {
    any_leaf().prop_recursive(3, 12, 3, |inner| {
        let children = proptest::collection::vec(inner, 1..3);
        let kind = proptest::sample::select(vec!["sum", "product", "scale", "mirror"]);
        (kind, children, any_number()).prop_map(|(kind, children, factor)| match kind {
            "scale" => json!({"kind": kind, "children": children, "factor": factor}),
            _ => json!({"kind": kind, "children": children}),
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_description_gives_nan_or_panics(value in any_spec(), w in any_number(), z in any_number()) {
        let spec = ModificationSpec::from_json(&value).unwrap();
        match Modification::build(&spec, &field()) {
            Ok(modification) => {
                for (w, z) in [(w, z), (13.0, 3.0), (20.0, -12.0)] {
                    if let Ok(f) = modification.value(w, z) {
                        prop_assert!(f.is_finite());
                    }
                    if let Ok(jet) = modification.jet(w, z) {
                        prop_assert!(jet.is_finite());
                    }
                }
                if let Some(polynomial) = modification.polynomial() {
                    prop_assert!(polynomial.terms().all(|term| term.2.is_finite()));
                }
            }
            Err(error) => {
                prop_assert!(!error.to_string().is_empty() && !error.way_out().is_empty());
                prop_assert!(!error.code().is_empty());
            }
        }
    }

    #[test]
    fn plain_modifications_always_have_a_value_on_the_field(
        c in -100.0..100.0f64, u in 0.0..1.0f64, v in 0.0..1.0f64, l in 0.5..40.0f64, p in 1.0..4.0f64,
    ) {
        let (w, z) = (6.0 + 14.0 * u, -12.0 + 30.0 * v);
        for kind in ["profile_crowning", "profile_crowning_arc", "helix_crowning_arc", "twist", "profile_slope_radius"] {
            let modification = build(json!({"kind": kind, "amount_um": c}));
            let f = modification.value(w, z).unwrap();
            prop_assert!(f.abs() <= 1e-3 * c.abs() * (1.0 + 1e-9));
            prop_assert!(modification.jet(w, z).is_ok());
        }
        let relief = build(json!({"kind": "end_relief_II", "amount_um": c, "length_mm": l, "exponent": p}));
        prop_assert!(relief.value(w, z).unwrap().abs() <= 1e-3 * c.abs() * (1.0 + 1e-9));
    }
}

#[test]
fn faces_have_two_names_each() {
    let values = |value: Value| {
        let built = build(value);
        [(7.0, -11.5), (13.0, 17.5), (19.5, 2.0), (19.8, -11.9), (19.9, 17.9)]
            .map(|(w, z)| built.value(w, z).unwrap())
    };
    for (number, name) in [("I", "non_datum_face"), ("II", "datum_face")] {
        let end = |kind: String| {
            values(json!({ "kind": kind, "amount_um": 18.0, "length_mm": 5.0, "exponent": 2.0 }))
        };
        assert_eq!(end(format!("end_relief_{number}")), end(format!("end_relief_{name}")));
        let corner = |face: &str| {
            values(
                json!({ "kind": "triangular_end_relief", "amount_um": 20.0, "corner_profile": "tip", "corner_face": face,
                "length_w_mm": 6.0, "length_z_mm": 8.0 }),
            )
        };
        assert_eq!(corner(number), corner(name));
    }
    // The datum face is the one with the greater z.
    let datum = build(json!({ "kind": "end_relief_datum_face", "amount_um": 18.0, "length_mm": 5.0 }));
    assert!((datum.value(12.0, 18.0).unwrap() + 0.018).abs() < 1e-15);
    assert_eq!(datum.value(12.0, -12.0).unwrap(), 0.0);
    let arcs = |one: &str, two: &str| json!({ "kind": "helix_crowning_two_arc", "apex_z_mm": 2.0, one: 6.0, two: 14.0 });
    let by_number = values(arcs("amount_I_um", "amount_II_um"));
    for (one, two) in [
        ("amount_non_datum_face_um", "amount_datum_face_um"),
        ("amount_I_um", "amount_datum_face_um"),
        ("amount_non_datum_face_um", "amount_II_um"),
    ] {
        assert_eq!(values(arcs(one, two)), by_number, "{one} {two}");
    }
    let twice = refusal(arcs("amount_I_um", "amount_non_datum_face_um")).to_string();
    assert!(twice.contains("amount_non_datum_face_um is given under both of its names"), "{twice}");
    let none = refusal(json!({ "kind": "helix_crowning_two_arc", "apex_z_mm": 2.0, "amount_I_um": 6.0 }))
        .to_string();
    assert!(none.contains("amount_datum_face_um is missing"), "{none}");
}
