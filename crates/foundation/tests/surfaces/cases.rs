//! The reference cases as surfaces, and more surfaces of every kind.

use foundation::geometry::{
    BevelData, BevelGear, BladeData, CylindricalCurve, EaseOff, EaseOffAmounts, Flank, FlankLine, Gear,
    GearData, GridSurface, Hand, Helicoid, LineForm, Mirrored, Modified, NormalSide, Octoid, OffsetBase,
    RuledBlade, Sides, SphericalInvolute, Spiral, SplineCurve, Surface,
};
use foundation::numerics::{CubicSpline, equidistant};
use nalgebra::Vector3;
use serde_json::Value;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

pub fn reference() -> Value {
    serde_json::from_str(include_str!("reference.json")).unwrap()
}

pub fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

pub fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

pub fn vector(value: &Value) -> Vector3<f64> {
    Vector3::from_vec(numbers(value))
}

pub fn cylindrical_gear(input: &Value) -> Gear {
    Gear::new(GearData {
        teeth: number(&input["z"]) as i32,
        normal_module: number(&input["mn"]),
        pressure_angle: Sides::both(number(&input["alpha_n_deg"]).to_radians()),
        helix_angle: number(&input["beta_deg"]).to_radians(),
        profile_shift: number(&input["x"]),
        cone_angle: 0.0,
    })
    .unwrap()
}

pub fn bevel_data(input: &Value) -> BevelData {
    let angle = |key: &str| number(&input[key]).to_radians();
    let mut data = BevelData::new(
        number(&input["met"]),
        number(&input["z"]) as u32,
        angle("delta_deg"),
        angle("alpha_deg"),
        number(&input["b"]),
    );
    if input.get("rc").is_some() {
        assert_eq!(number(&input["hand"]), 1.0);
        data.spiral = Some(Spiral {
            mean_angle: angle("beta_m_deg"),
            form: LineForm::Circle { radius: number(&input["rc"]) },
            hand: Hand::Right,
        });
    }
    data
}

pub fn bevel_gear(case: &str) -> BevelGear {
    BevelGear::new(bevel_data(&reference()["cases"][case]["input"])).unwrap()
}

pub fn ease_off(gear: &BevelGear) -> EaseOff {
    let [length_crowning, profile_crowning, bias] = [0.01, 0.006, 0.002];
    EaseOff::of_bevel(EaseOffAmounts { length_crowning, profile_crowning, bias }, gear).unwrap()
}

pub fn blade_data(input: &Value) -> BladeData {
    let pair = |a: &str, b: &str| [number(&input[a]), number(&input[b])];
    BladeData {
        hub_radius: pair("r_hub0", "r_hub1"),
        tip_radius: number(&input["r_tip"]),
        length: number(&input["length"]),
        hub_azimuth: pair("th0", "th1"),
        tip_lead: pair("dth_tip0", "dth_tip1"),
        side: NormalSide::Along,
    }
}

/// The surface of a case of the reference file.
pub fn surface(case: &str) -> Arc<dyn Surface> {
    let input = &reference()["cases"][case]["input"];
    match input["type"].as_str().unwrap() {
        "cylindrical" => Arc::new(Helicoid::new(&cylindrical_gear(input), Flank::Left)),
        "bevel" => {
            let gear = bevel_gear(case);
            let flank = SphericalInvolute::new(&gear, Flank::Left);
            match input.get("ease") {
                None => Arc::new(flank),
                Some(_) => Arc::new(Modified::new(flank, Arc::new(ease_off(&gear)))),
            }
        }
        "ruled" => Arc::new(RuledBlade::of_data(&blade_data(input)).unwrap()),
        other => panic!("{other}"),
    }
}

/// A surface that can carry an offset, and the box of parameters to look at.
pub struct Sample {
    pub name: &'static str,
    pub surface: Arc<dyn OffsetBase>,
    pub heights: [f64; 2],
    pub lengths: [f64; 2],
}

/// One surface of every kind, both flanks, hands and signs.
pub fn samples() -> Vec<Sample> {
    let reference = reference();
    let input = |case: &str| reference["cases"][case]["input"].clone();
    let mut samples = Vec::new();
    let mut add = |name, surface: Arc<dyn OffsetBase>, heights, lengths| {
        samples.push(Sample { name, surface, heights, lengths });
    };
    let helical = cylindrical_gear(&input("helical"));
    let internal = cylindrical_gear(&input("internal"));
    add("helical left", Arc::new(Helicoid::new(&helical, Flank::Left)), [5.0, 42.0], [-25.0, 25.0]);
    let thinned = Helicoid::thinned(&helical, Flank::Right, 0.3).unwrap();
    add("helical right, thinned", Arc::new(thinned), [5.0, 42.0], [-25.0, 25.0]);
    add("mirrored", Arc::new(Mirrored::new(thinned, 3.0)), [5.0, 42.0], [3.0, 28.0]);
    add("internal", Arc::new(Helicoid::new(&internal, Flank::Right)), [27.0, 52.0], [-15.0, 15.0]);

    let straight = bevel_gear("straight_bevel");
    let flank = Flank::Right;
    add("straight bevel", Arc::new(SphericalInvolute::new(&straight, flank)), [0.1, 0.75], [50.0, 73.0]);
    for (name, flank) in [("octoid left", Flank::Left), ("octoid right", Flank::Right)] {
        let octoid = Octoid::new(&straight, flank);
        let heights = [octoid.domain()[0][0] + 0.1, octoid.height_of(0.656).unwrap()];
        add(name, Arc::new(octoid), heights, [50.0, 73.0]);
    }
    // Its pitch cone is a plane: the involute bends the other way on the tip, the octoid is flat.
    let crown = BevelGear::new(BevelData { pitch_angle: FRAC_PI_2, ..*straight.data() }).unwrap();
    add("crown", Arc::new(SphericalInvolute::new(&crown, flank)), [1.3, 2.0], [22.0, 39.0]);
    add("crown octoid", Arc::new(Octoid::new(&crown, flank)), [-0.15, 0.15], [22.0, 39.0]);
    let spiral = bevel_gear("spiral_bevel");
    add("spiral left", Arc::new(SphericalInvolute::new(&spiral, Flank::Left)), [0.1, 0.75], [66.0, 98.0]);
    let mut data = bevel_data(&input("spiral_bevel"));
    data.spiral =
        data.spiral.map(|s| Spiral { hand: Hand::Left, form: LineForm::Circle { radius: 90.0 }, ..s });
    let other = BevelGear::new(data).unwrap();
    add(
        "spiral right, left-handed",
        Arc::new(SphericalInvolute::new(&other, flank)),
        [0.1, 0.75],
        [66.0, 98.0],
    );
    for (name, form) in [
        ("skew", LineForm::Straight),
        ("palloid", LineForm::Involute),
        ("epicycloid", LineForm::Epicycloid { radius: 80.0, groups: 5.0 }),
    ] {
        data.spiral = data.spiral.map(|s| Spiral { form, ..s });
        let gear = BevelGear::new(data).unwrap();
        add(name, Arc::new(SphericalInvolute::new(&gear, Flank::Left)), [0.1, 0.75], [84.0, 98.0]);
    }
    let knots = equidistant([60.0, 105.0], 10);
    let turns: Vec<f64> = knots.iter().map(|r| 0.4 * (r / 30.0).sin()).collect();
    let line = FlankLine::Spline(CubicSpline::new(&knots, &turns).unwrap());
    let free = SphericalInvolute::with_line(&spiral, Flank::Left, line).unwrap();
    add("bevel with a spline", Arc::new(free), [0.1, 0.75], [66.0, 98.0]);

    let blade = RuledBlade::of_data(&blade_data(&input("blade"))).unwrap();
    let rows: Vec<Vec<Vector3<f64>>> = equidistant([0.0, 1.0], 7)
        .into_iter()
        .map(|v| equidistant([0.0, 1.0], 9).into_iter().map(|u| blade.point(v, u)).collect())
        .collect();
    let knots = equidistant([0.0, 1.0], 9);
    let hub = SplineCurve::new(&knots, &rows[0]).unwrap();
    let tip =
        CylindricalCurve::new([75.0, 0.0, -1.0, 2.0], [0.05, 0.1, 0.5, 0.1], [0.0, 60.0, 2.0, -1.0]).unwrap();
    let mixed = RuledBlade::new(Arc::new(hub), Arc::new(tip), NormalSide::Against).unwrap();
    add("blade", Arc::new(blade), [0.05, 1.0], [0.0, 1.1]);
    add("blade of a spline and a cubic", Arc::new(mixed), [0.05, 1.0], [0.0, 1.0]);
    add("grid", Arc::new(GridSurface::new(&rows, NormalSide::Along).unwrap()), [0.0, 1.0], [0.0, 1.0]);
    samples
}

/// An offset of the size of a real one over a box of parameters.
pub fn offset(heights: [f64; 2], lengths: [f64; 2]) -> Arc<EaseOff> {
    let amounts = EaseOffAmounts { length_crowning: 0.02, profile_crowning: -0.013, bias: 0.008 };
    Arc::new(EaseOff::new(amounts, heights, lengths).unwrap())
}

/// Numbers in 0..1 that look like chance and are the same in every run.
pub fn chances() -> impl FnMut() -> f64 {
    let mut state: u64 = 0x2545_f491_4f6c_dd1d;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    }
}

pub fn between([from, to]: [f64; 2], share: f64) -> f64 {
    from + (to - from) * share
}
