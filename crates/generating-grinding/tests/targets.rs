//! What a target can be beside the catalogue of modifications: formulas, helix traces, tables that are grids or clouds;
//! and the tolerances that come with it.

use foundation::modification::{
    EvaluationField, Modification, ModificationError, ModificationSpec, Smoothness,
};
use foundation::numerics::{CubicSpline, Jet2};
use generating_grinding::job::{Job, LoadedJob};
use generating_grinding::workflow::{prepare, tolerance_of_job};
use job::{ProcessJob, read_job_of as read_job};
use proptest::prelude::*;
use run::RunFailure;
use serde_json::{Value, json};

fn field() -> EvaluationField {
    EvaluationField::new([6.0, 20.0], [-12.0, 18.0], 38.0, 18f64.to_radians()).unwrap()
}

fn try_build(value: &Value) -> Result<Modification, ModificationError> {
    ModificationSpec::from_json(value).and_then(|spec| Modification::build(&spec, &field()))
}

fn build(value: Value) -> Modification {
    try_build(&value).unwrap_or_else(|error| panic!("{value}: {error}"))
}

fn formula(text: &str) -> Modification {
    build(json!({ "kind": "formula", "f_um": text }))
}

fn refused(text: &str) -> ModificationError {
    try_build(&json!({ "kind": "formula", "f_um": text })).map(|_| ()).unwrap_err()
}

fn list(jet: Jet2) -> [f64; 6] {
    [jet.f, jet.fu, jet.fv, jet.fuu, jet.fuv, jet.fvv]
}

#[test]
fn formulas_equal_the_kinds_they_spell() {
    let cases = [
        ("-8*u^2", json!({"kind": "profile_crowning", "amount_um": 8.0})),
        (
            "-12*(w - (w_f+w_a)/2)*(z - (z_I+z_II)/2)/((w_a-w_f)*(z_II-z_I))",
            json!({"kind": "twist", "amount_um": 12.0}),
        ),
        ("-20*max(w - (w_a - 4), 0)/4", json!({"kind": "tip_relief", "amount_um": 20.0, "length_mm": 4.0})),
        (
            "-18*(max(z_I + 5 - z, 0)/5)^2",
            json!({"kind": "end_relief_I", "amount_um": 18.0, "length_mm": 5.0, "exponent": 2}),
        ),
        (
            "-18*(max(0, z - (z_II - 6))/6)^2.6",
            json!({"kind": "end_relief_II", "amount_um": 18.0, "length_mm": 6.0, "exponent": 2.6}),
        ),
        (
            "(1 + 0.8*u^2)*sin(2*pi*z/3 + 25*pi/180)",
            json!({"kind": "waviness", "rho_deg": 0.0, "wavelength_mm": 3.0, "phase_deg": 25.0, "amp_0_um": 1.0, "amp_uu_um": 0.8}),
        ),
        (
            "-8*(sqrt(w^2 + 38^2) - (sqrt(w_f^2 + 38^2) + sqrt(w_a^2 + 38^2))/2)^2/((sqrt(w_a^2 + 38^2) - sqrt(w_f^2 + 38^2))/2)^2",
            json!({"kind": "profile_crowning_radius", "amount_um": 8.0}),
        ),
    ];
    for (text, value) in cases {
        let (written, known) = (formula(text), build(value));
        assert_eq!(written.smoothness(), known.smoothness(), "{text}");
        assert_eq!(written.depends_on_profile_only(), known.depends_on_profile_only(), "{text}");
        assert_eq!(written.polynomial().is_some(), known.polynomial().is_some(), "{text}");
        // Points on the kinks (w = 16, z = -7, z = 12), on the borders and beyond them.
        for w in [5.0, 6.0, 9.37, 13.0, 16.0, 17.21, 20.0, 21.0] {
            for z in [-14.0, -12.0, -7.0, -3.3, 3.0, 12.0, 15.7, 18.0] {
                let (a, b) = (list(written.jet(w, z).unwrap()), list(known.jet(w, z).unwrap()));
                for (k, (a, b)) in a.into_iter().zip(b).enumerate() {
                    assert!((a - b).abs() < 2e-15, "{text} entry {k} at {w}, {z}: {a} for {b}");
                }
            }
        }
    }
}

#[test]
fn every_function_has_exact_derivatives() {
    // Each over the field with an argument inside its domain.
    let functions = [
        "sin(w)",
        "cos(z)",
        "tan(0.7*u)",
        "asin(0.9*u)",
        "acos(0.9*v)",
        "atan(w - z)",
        "sinh(u*v)",
        "cosh(u - v)",
        "tanh(3*v)",
        "exp(u)",
        "ln(w)",
        "log10(w*w)",
        "sqrt(w + z + 7)",
        "abs(u + 0.123)",
        "min(u, v + 0.01, 0.3)",
        "max(u, v + 0.01)",
        "w^3",
        "w^-2",
        "w^1.7",
        "2^v",
        "w^v",
        "(u*v)^3",
        "(u - 2)^-3",
        "1/(u*v + 2)",
        "-u^2",
        "u/v^0",
    ];
    let step = 1e-4;
    for text in functions {
        let modification = formula(&format!("10*({text})"));
        for i in 0..9 {
            for j in 0..9 {
                let (w, z) = (6.1 + 1.71 * f64::from(i), -11.3 + 3.37 * f64::from(j));
                let at = |i: f64, j: f64| modification.jet(w + i * step, z + j * step).unwrap();
                let (e, west, n, s) = (at(1.0, 0.0), at(-1.0, 0.0), at(0.0, 1.0), at(0.0, -1.0));
                let slope = |a: f64, b: f64| (a - b) / (2.0 * step);
                let expected = [
                    slope(e.f, west.f),
                    slope(n.f, s.f),
                    slope(e.fu, west.fu),
                    slope(e.fv, west.fv),
                    slope(n.fv, s.fv),
                ];
                let found = list(at(0.0, 0.0));
                for (a, b) in found[1..].iter().zip(expected) {
                    // The difference quotient errs by step^2/6 times the third derivative, which stays below 0.5.
                    assert!((a - b).abs() < 1e-9 * (1.0 + b.abs()), "{text} at {w}, {z}: {a} for {b}");
                }
            }
        }
    }
}

#[test]
fn kinks_of_formulas_give_the_mean_of_the_sides() {
    let at = |text: &str, w: f64, z: f64| list(formula(text).jet(w, z).unwrap()).map(|x| x * 1e3);
    let close = |found: [f64; 6], expected: [f64; 6]| {
        for (a, b) in found.into_iter().zip(expected) {
            assert!((a - b).abs() < 1e-12, "{found:?} for {expected:?}");
        }
    };
    close(at("abs(w - 13)", 13.0, 0.0), [0.0; 6]);
    close(at("max(w - 13, 2*(w - 13))", 13.0, 0.0), [0.0, 1.5, 0.0, 0.0, 0.0, 0.0]);
    // The means of the branches, not powers of the mean: (0 + 2)/2 and not 2 (1/2)^2.
    close(at("max(w - 13, 0)^2", 13.0, 0.0), [0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    // Two kinks at once: (w - 13) and -(w - 13) are never both positive.
    close(at("max(w - 13, 0)*max(13 - w, 0)", 13.0, 0.0), [0.0; 6]);
    // Four sides of a corner: w z lives in one quarter of the plane.
    close(at("max(w - 13, 0)*max(z, 0)", 13.0, 0.0), [0.0, 0.0, 0.0, 0.0, 0.25, 0.0]);
    // Tangent branches: equal slopes, other curvatures.
    close(at("max(3*(w - 13)^2, (w - 13)^2) + 1", 13.0, 0.0), [1.0, 0.0, 0.0, 6.0, 0.0, 0.0]);
    // A curvature without bound on one side is taken from the other, a slope without bound is an error.
    close(at("max(w - 13, 0)^1.5", 13.0, 0.0), [0.0; 6]);
    assert_eq!(formula("max(w - 13.0001, 0)^0.5").jet(13.0001, 0.0).unwrap_err().code(), "amount-not-finite");
    assert_eq!(formula("max(w - 13.0001, 0)^0.5").value(13.0001, 0.0), Ok(0.0));
}

#[test]
fn smoothness_of_formulas_is_told() {
    use Smoothness::{C0, C1, C2, Cinf};
    for (text, expected) in [
        ("max(u, 2)", Cinf),
        ("abs(w)", Cinf),
        ("abs(z)", C0),
        ("abs(z)^1.5 + u", C1),
        ("max(z, 0)^3", C2),
        ("(2*max(z, 0))^2", C1),
        ("(max(z, 0) + 1)^2", C0),
        ("max(max(z, 0), u)^2", C0),
        ("sqrt(w)", Cinf),
        ("sqrt(w - 5.9)", Cinf),
        ("max(u, v)*w", C0),
        ("w^2.5 + 1/w + ln(w_a) + 3^u", Cinf),
        ("sin(abs(v))", C0),
    ] {
        assert_eq!(formula(text).smoothness(), expected, "{text}");
    }
    // Nothing of the face: such a formula can go into the dresser.
    assert!(formula("-9*max(u, 0)^2 + z_I").depends_on_profile_only());
    assert!(!formula("u + 0*v").depends_on_profile_only());
    assert_eq!(formula("(w - z)^3 - w^3 + 0^0").polynomial().map(|p| p.degree()), Some(3));
    assert!(formula("u^40*v^40").polynomial().is_none());
}

#[test]
fn formulas_that_are_none_are_told_why() {
    let cases = [
        ("", "f_um", "not understood near character 1"),
        ("2u", "f_um", "\"u\""),
        ("u +", "f_um", "its end"),
        ("(u", "f_um", "not understood"),
        ("q + 1", "f_um", "w_f, w_a, z_I, z_II, pi"),
        ("sine(u)", "f_um", "sin, cos"),
        ("sin + 1", "f_um", "\"sin\""),
        ("u(2)", "f_um", "\"u\""),
        ("sin(u, v)", "f_um", "sin with 2 arguments"),
        ("max(u)", "f_um", "2 or more"),
        ("abs(u, v)", "f_um", "abs with 2 arguments"),
        ("1e999", "f_um", "too large"),
        ("1/0", "f_um", "w = 6 mm, z = -12 mm"),
        ("ln(w - 7)", "f_um", "w = 6 mm"),
        ("1/u", "f_um", "w = 13 mm"),
        ("sqrt(z)", "f_um", "z = -12 mm"),
        ("sqrt(-1)^2", "f_um", "w = 6 mm"),
        ("max(ln(-1), 5)", "f_um", "w = 6 mm"),
        ("min(5, ln(-1))", "f_um", "w = 6 mm"),
        ("exp(1000*w)", "f_um", "w = 6 mm"),
        ("1e300", "f_um", "1e300"),
        ("200000*u", "f_um", "200000"),
    ];
    for (text, key, says) in cases {
        let error = refused(text);
        let (code, told) = (error.code(), error.to_string());
        assert!(["invalid-modification", "invalid-number"].contains(&code), "{text}: {told}");
        assert!(told.contains(key) && (told.contains(says) || says == "1e300"), "{text}: {told}");
        assert!(!error.way_out().is_empty());
    }
    let long = "+u".repeat(5000);
    for text in
        [long.as_str(), &"(".repeat(1000), &"2^".repeat(900), &"-(".repeat(500), &"max(u,".repeat(300)]
    {
        assert_eq!(refused(text).code(), "invalid-modification");
    }
    let refused = |value: Value| try_build(&value).map(|_| ()).unwrap_err().to_string();
    assert!(refused(json!({"kind": "formula", "f_um": 3})).contains("f_um"));
    assert!(refused(json!({"kind": "formula"})).contains("missing"));
    assert!(refused(json!({"kind": "formula", "f_um": "u", "reference": "normal"})).contains("transverse"));
}

#[test]
fn traces_are_met_and_joined() {
    let (w, z) = ([7.0, 12.0, 19.0], [-12.0, -7.0, 0.0, 4.0, 9.0, 18.0]);
    let f = |w: f64, z: f64| 3.0 * (0.1 * w + 0.2 * z).cos() + 0.1 * w;
    for count in [2, 3] {
        let rows: Vec<Vec<f64>> = w[..count].iter().map(|w| z.iter().map(|z| f(*w, *z)).collect()).collect();
        let traces = build(json!({"kind": "helix_traces", "w_mm": w[..count], "z_mm": z, "f_um": rows}));
        let splines: Vec<CubicSpline> = rows.iter().map(|row| CubicSpline::new(&z, row).unwrap()).collect();
        for (w, spline) in w.iter().zip(&splines) {
            for i in 0..=30 {
                let z = -12.0 + f64::from(i);
                assert!((traces.value(*w, z).unwrap() - 1e-3 * spline.value(z)).abs() < 1e-15);
            }
        }
        assert_eq!(traces.smoothness(), Smoothness::C2);
        assert!(traces.polynomial().is_none() && !traces.depends_on_profile_only());
        // Straight or parabolic across: the next difference over w vanishes.
        let along: Vec<f64> = (0..4).map(|i| traces.value(6.0 + 4.0 * f64::from(i), 2.5).unwrap()).collect();
        let second = |i: usize| along[i] - 2.0 * along[i + 1] + along[i + 2];
        let (bend, change) = (second(0), second(1) - second(0));
        assert!(change.abs() < 1e-15, "{change}");
        assert_eq!(bend.abs() < 1e-15, count == 2, "{bend}");
    }
    // A parabola over w times a cubic over z is met exactly by three traces.
    let exact = |w: f64, z: f64| (1.0 + 0.2 * w - 0.01 * w * w) * (2.0 + 0.1 * z - 0.003 * z * z * z);
    let rows: Vec<Vec<f64>> = w.iter().map(|w| z.iter().map(|z| exact(*w, *z)).collect()).collect();
    let traces = build(json!({"kind": "helix_traces", "w_mm": w, "z_mm": z, "f_um": rows}));
    for (w, z) in [(6.0, -12.0), (9.3, 1.7), (20.0, 18.0), (15.5, -9.9)] {
        assert!((traces.value(w, z).unwrap() - 1e-3 * exact(w, z)).abs() < 1e-14);
    }
    assert!(traces.warnings().is_empty());
}

#[test]
fn traces_are_checked() {
    let z = [-12.0, 0.0, 4.0, 18.0];
    let row = [1.0, 2.0, 3.0, 4.0];
    let key = |value: Value| match try_build(&value).map(|_| ()).unwrap_err() {
        ModificationError::InvalidModification { key, .. } | ModificationError::InvalidNumber { key, .. } => {
            key
        }
        other => panic!("{value}: {other}"),
    };
    let traces =
        |w: Value, z: Value, f: Value| json!({"kind": "helix_traces", "w_mm": w, "z_mm": z, "f_um": f});
    assert_eq!(key(traces(json!([8]), json!(z), json!([row]))), "w_mm");
    assert_eq!(key(traces(json!([8, 9, 10, 11]), json!(z), json!([row, row, row, row]))), "w_mm");
    assert_eq!(key(traces(json!([9, 8]), json!(z), json!([row, row]))), "w_mm");
    assert_eq!(key(traces(json!([8, 8.0001]), json!(z), json!([row, row]))), "w_mm");
    assert_eq!(key(traces(json!([8, 18]), json!([-12, 0, 18]), json!([[1, 2, 3], [1, 2, 3]]))), "z_mm");
    assert_eq!(key(traces(json!([8, 18]), json!([-12, 4, 4, 18]), json!([row, row]))), "z_mm");
    assert_eq!(key(traces(json!([8, 18]), json!([-12, 0, 4, 12]), json!([row, row]))), "z_mm");
    assert_eq!(key(traces(json!([8, 18]), json!(z), json!([row]))), "f_um");
    assert_eq!(key(traces(json!([8, 18]), json!(z), json!([row, [1, 2, 3]]))), "f_um");
    assert_eq!(key(traces(json!([8, 18]), json!(z), json!([row, [1, 2, 3, 1e9]]))), "f_um");
    let mut both = traces(json!([8, 18]), json!(z), json!([row, row]));
    both["file"] = "t.csv".into();
    assert_eq!(key(both), "file");
    assert!(key(json!({"kind": "helix_traces"})) == "w_mm");
    let narrow = build(traces(json!([11, 14]), json!(z), json!([row, row])));
    let [warning] = narrow.warnings() else { panic!("{:?}", narrow.warnings()) };
    assert_eq!(warning.code(), "outside-traces");
    assert!(warning.to_string().contains("6 mm beyond"), "{warning}");
}

#[test]
fn measured_profiles_are_checked() {
    let key = |value: Value| match try_build(&value).map(|_| ()).unwrap_err() {
        ModificationError::InvalidModification { key, allowed, .. } => (key, allowed),
        ModificationError::InvalidNumber { key, limit, .. } => (key, limit.to_string()),
        other => panic!("{value}: {other}"),
    };
    let points: Vec<[f64; 2]> = (0..12).map(|k| [2.0 * f64::from(k) + 1.0, 0.5 * f64::from(k % 2)]).collect();
    let trace = |points: &[[f64; 2]], noise: Value| json!({"kind": "profile_trace", "points": points, "noise_um": noise});
    let made = build(trace(&points, json!(0.3)));
    // Nothing of the face width, and a curve between the points.
    assert_eq!(made.value(9.3, -4.0).unwrap(), made.value(9.3, 7.0).unwrap());
    assert!(made.depends_on_profile_only() && made.measured_deviation(9.3) > 0.0);
    assert_eq!(build(json!({"kind": "profile_crowning", "amount_um": 3})).measured_deviation(9.3), 0.0);
    let doubled = build(json!({"kind": "scale", "factor": 2.0, "children": [trace(&points, json!(0.3))]}));
    assert!((doubled.measured_deviation(9.3) - 2.0 * made.measured_deviation(9.3)).abs() < 1e-15);
    for noise in [json!(0.0), json!(-0.1)] {
        assert_eq!(key(trace(&points, noise)), ("noise_um".into(), "a number above 0".into()));
    }
    assert_eq!(key(trace(&points, json!(1e6))).0, "noise_um");
    assert_eq!(key(trace(&points[..7], Value::Null)), ("points".into(), "8 points or more".into()));
    let (field, allowed) = key(trace(&points[5..], Value::Null));
    assert_eq!(field, "points");
    assert!(allowed.contains("8 points"), "{allowed}");
    let short: Vec<[f64; 2]> = points.iter().map(|[w, f]| [0.2 * w + 12.0, *f]).collect();
    assert!(key(trace(&short, Value::Null)).1.starts_with("numbers that cover the evaluation range"));
    let piled: Vec<[f64; 2]> = points.iter().map(|[w, f]| [if *w < 12.0 { 1.0 } else { 23.0 }, *f]).collect();
    assert_eq!(key(trace(&piled, Value::Null)).1, "points spread over the evaluation range");
    let mut both = trace(&points, Value::Null);
    both["file"] = "t.csv".into();
    assert_eq!(key(both).0, "file");
}

/// The template with another target and the given files beside it.
fn job(target: &str, files: &[(&str, String)]) -> (tempfile::TempDir, LoadedJob) {
    let template = Job::TEMPLATE;
    let (begin, end) = (template.find("[target]").unwrap(), template.find("[worm]").unwrap());
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("job.toml");
    std::fs::write(&path, format!("{}[target]\n{target}\n{}", &template[..begin], &template[end..])).unwrap();
    for (name, text) in files {
        std::fs::write(directory.path().join(name), text).unwrap();
    }
    let loaded = read_job(&path).unwrap_or_else(|error| panic!("{target}: {error}"));
    (directory, loaded)
}

/// Rows of a table over more than the template's flank, without those that `left_out` names.
fn rows(value: &str, places: usize, left_out: impl Fn(usize, usize) -> bool) -> String {
    let mut text = format!("w_mm,z_mm,{value}\n");
    for i in 0..places {
        for j in 0..places {
            if !left_out(i, j) {
                let share = |k: usize| k as f64 / (places - 1) as f64;
                let (w, z) = (40.0 * share(i) - 5.0, 50.0 * share(j) - 25.0);
                text += &format!("{w},{z},{}\n", 1.0 + 0.01 * w + 0.02 * z * z);
            }
        }
    }
    text
}

#[test]
fn target_tables_are_grids_or_clouds() {
    let cases: [(String, Option<&str>); 4] = [
        (rows("f_um", 9, |_, _| false), None),
        (rows("f_um", 9, |i, j| i == 3 && j == 4), Some("spline")),
        (rows("f_um", 9, |i, j| (i * 9 + j) % 7 == 3), Some("spline")),
        (rows("f_um", 3, |_, _| false), Some("linear")),
    ];
    for (text, method) in cases {
        let (_directory, loaded) = job("file = \"t.csv\"", &[("t.csv", text)]);
        let prepared = match prepare(&loaded) {
            Ok(prepared) => prepared,
            Err(RunFailure::BadInput(finding) | RunFailure::NotProducible(finding)) => panic!("{finding}"),
        };
        let said = prepared.warnings.iter().filter(|w| w.code == "target-scattered").collect::<Vec<_>>();
        assert_eq!(said.len(), usize::from(method.is_some()));
        if let Some(method) = method {
            assert!(said[0].text.contains(method), "{}", said[0].text);
        }
        for (_, target) in prepared.targets.iter() {
            let wanted = &target.as_ref().unwrap().modification;
            let expected = if method == Some("linear") { Smoothness::C0 } else { Smoothness::C2 };
            assert_eq!(wanted.smoothness(), expected);
            if expected == Smoothness::C2 {
                let f = wanted.value(15.0, 7.0).unwrap();
                assert!((f - 1e-3 * (1.15 + 0.98)).abs() < 1e-12, "{f}");
            }
        }
    }
    let broken = rows("f_um", 9, |_, _| false).replacen("\n-5,", "\n-5x,", 1);
    let (_directory, loaded) = job("file = \"t.csv\"", &[("t.csv", broken)]);
    let Err(RunFailure::BadInput(finding)) = prepare(&loaded) else { panic!("accepted") };
    assert_eq!(finding.field.as_deref(), Some("target.file"));
    assert!(finding.message.contains("-5x"), "{finding}");
}

#[test]
fn tolerances_come_from_number_table_or_file() {
    let modifications = "modifications = []";
    let (_d, loaded) = job(&format!("tolerance_um = 1.5\n{modifications}"), &[]);
    let map = tolerance_of_job(&loaded).unwrap();
    assert!(map.is_uniform() && (map.value(3.0, 4.0) - 1.5e-3).abs() < 1e-18);

    let table = "tolerance_map = { w_mm = [10.0, 20.0], z_mm = [0.0], tolerance_um = [[1.0], [3.0]] }";
    let (_d, loaded) = job(&format!("{table}\n{modifications}"), &[]);
    let map = tolerance_of_job(&loaded).unwrap();
    assert!((map.value(15.0, -9.0) - 2e-3).abs() < 1e-17 && map.value(99.0, 0.0) == 3e-3);

    let target = format!("tolerance_map = \"tol.csv\"\n{modifications}");
    let text = rows("tolerance_um", 5, |_, _| false);
    let (_d, loaded) = job(&target, &[("tol.csv", text.clone())]);
    let map = tolerance_of_job(&loaded).unwrap();
    assert!((map.value(5.0, 0.0) - 1.05e-3).abs() < 1e-17);

    let cases = [
        (text.replacen("\n5,0,", "\n5,0,-", 1), "tolerance_um"),
        (rows("tolerance_um", 5, |i, j| i == j && i == 2), "no full grid"),
        (rows("f_um", 5, |_, _| false), "no column `tolerance_um`"),
    ];
    for (text, says) in cases {
        let (_d, loaded) = job(&target, &[("tol.csv", text)]);
        let finding = tolerance_of_job(&loaded).unwrap_err();
        assert_eq!(finding.field.as_deref(), Some("target.tolerance_map"));
        assert!(finding.message.contains(says), "{finding}");
    }
    let (_d, loaded) = job(&target, &[]);
    assert_eq!(tolerance_of_job(&loaded).unwrap_err().code, "file-unavailable");
    let zero = "tolerance_map = { w_mm = [10.0], z_mm = [0.0, 1.0], tolerance_um = [[1.0, 0.0]] }";
    let (_d, loaded) = job(&format!("{zero}\n{modifications}"), &[]);
    let finding = tolerance_of_job(&loaded).unwrap_err();
    assert!(finding.message.contains("tolerance_um[0][1]"), "{finding}");
}

fn any_text() -> impl Strategy<Value = String> {
    let part = proptest::sample::select(vec![
        "u", "v", "w", "z", "z_I", "pi", "1", "2.5", "1e-3", "0", "+", "-", "*", "/", "^", "(", ")", ",",
        "sin(", "max(", "abs(", "sqrt(", "ln(", " ", "\u{e9}", "{", "e", ".",
    ]);
    proptest::collection::vec(part, 0..24).prop_map(|parts| parts.concat())
}

fn any_expression() -> impl Strategy<Value = String> {
    let leaf = proptest::sample::select(vec!["u", "v", "w", "z", "0", "1", "-2.5", "1e-3", "pi", "w_a", "3"]);
    leaf.prop_map(str::to_owned).prop_recursive(5, 40, 3, |inner| {
        let pair = proptest::sample::select(vec![
            "{}+{}",
            "{}-{}",
            "({})*({})",
            "({})/({})",
            "({})^({})",
            "max({},{})",
            "min({},{})",
        ]);
        let single = proptest::sample::select(vec![
            "-{}", "({})", "sin({})", "exp({})", "sqrt({})", "abs({})", "ln({})", "acos({})",
        ]);
        prop_oneof![
            (pair, inner.clone(), inner.clone())
                .prop_map(|(p, a, b)| p.replacen("{}", &a, 1).replacen("{}", &b, 1)),
            (single, inner).prop_map(|(p, a)| p.replacen("{}", &a, 1)),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_text_panics(text in prop_oneof![any_text(), any_expression(), "\\PC{0,40}"]) {
        match try_build(&json!({ "kind": "formula", "f_um": text })) {
            Ok(modification) => {
                for (w, z) in [(6.0, -12.0), (13.0, 3.0), (17.3, 11.1), (-5.0, 40.0), (13.0, 0.0)] {
                    if let Ok(f) = modification.value(w, z) {
                        prop_assert!(f.is_finite());
                    }
                    if let Ok(jet) = modification.jet(w, z) {
                        prop_assert!(jet.is_finite());
                    }
                }
                if let Some(polynomial) = modification.polynomial() {
                    let (a, b) = (polynomial.value(0.7, -0.3), modification.value(13.7, 2.7).unwrap());
                    // Powers of lengths of some tens of mm lose digits when they are moved to the middle.
                    prop_assert!((a - b).abs() <= 1e-9 * (1.0 + b.abs()), "{text}: {a} {b}");
                }
            }
            Err(error) => {
                prop_assert!(!error.to_string().is_empty() && !error.way_out().is_empty());
                prop_assert!(error.to_string().len() < 600, "{}", error);
            }
        }
    }
}
