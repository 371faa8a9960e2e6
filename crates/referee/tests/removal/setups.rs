//! Bodies, motions and worms for the tests; only here do other rooms help the referee.

use contact::Pair;
use dressing::{DresserTool, GeometricRange};
use foundation::geometry::{Flank, Gear, GearData, InvoluteFlank, Sides, WormChoice, worm_for_gear};
use foundation::kinematics::{DressingChain, GeneratingChain, GeneratingMotion, MotionLaw};
use foundation::numerics::{Chebyshev, Polynomial2};
use referee::{RayGrid, WormArea};
use serde_json::Value;

/// The parsed reference file of a spec.
pub fn reference(name: &str) -> Value {
    let path = format!("{}/../../tests/reference/{name}", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

pub fn num(v: &Value) -> f64 {
    v.as_f64().unwrap()
}

pub fn list(v: &Value) -> Vec<f64> {
    v.as_array().unwrap().iter().map(num).collect()
}

pub fn gear(v: &Value) -> Gear {
    Gear::new(GearData {
        teeth: v["z"].as_i64().unwrap() as i32,
        normal_module: num(&v["m_n_mm"]),
        pressure_angle: Sides {
            left: num(&v["alpha_n_left_deg"]).to_radians(),
            right: num(&v["alpha_n_right_deg"]).to_radians(),
        },
        helix_angle: num(&v["beta_deg"]).to_radians(),
        profile_shift: num(&v["x"]),
        cone_angle: num(&v["theta_deg"]).to_radians(),
    })
    .unwrap()
}

/// Worm, workpiece and chain of a case of the contact reference.
pub fn pair(input: &Value) -> Pair {
    let c = &input["chain"];
    let chain = GeneratingChain {
        centre_distance: num(&c["d_mm"]),
        crossed_axes_angle: num(&c["gamma_deg"]).to_radians(),
        worm_cone: num(&c["theta_1_deg"]).to_radians(),
        work_cone: num(&c["theta_2_deg"]).to_radians(),
        worm_pivot: num(&c["r_w1_mm"]),
        work_pivot: num(&c["r_w2_mm"]),
    };
    Pair::new(gear(&input["worm"]), gear(&input["work"]), chain).unwrap()
}

/// A polynomial law of the reference; `unit` brings its coefficients to mm or rad.
fn law(v: &Value, unit: f64) -> MotionLaw {
    let coefficients = list(&v["coefficients"]).iter().map(|c| c * unit).collect();
    MotionLaw::polynomial(num(&v["z_V2_origin_mm"]), coefficients)
}

/// The motion of a `ground_flank` case for one flank.
pub fn motion(input: &Value, pair: &Pair, flank: Flank) -> GeneratingMotion {
    let side = &input[flank.name()];
    GeneratingMotion {
        delta_d: law(&side["Delta_d"], 1e-3),
        delta_phi_2: law(&side["Delta_phi_2"], 1e-6),
        delta_gamma: law(&side["Delta_gamma"], 1e-6),
        ..pair.motion(law(&input["z_V1_mm"], 1.0))
    }
}

/// The worm function of a `ground_flank` case, mm.
pub fn worm_function(input: &Value, flank: Flank) -> Polynomial2 {
    let f = &input[flank.name()]["f_n1"];
    if f.is_null() {
        return Polynomial2::constant(0.0);
    }
    let terms = f["terms"].as_array().unwrap().iter().map(|t| {
        let exponent = |k: usize| t[k].as_u64().unwrap() as usize;
        (exponent(0), exponent(1), num(&t[2]) * 1e-3)
    });
    Polynomial2::from_terms(terms).shifted(-num(&f["w_0_mm"]), -num(&f["z_0_mm"]))
}

/// The worm points that touch a workpiece field in the unmodified pair, with margins: the area a worm needs.
pub fn area(
    pair: &Pair,
    flank: Flank,
    grid: &RayGrid,
    motion: &GeneratingMotion,
    margin: [f64; 2],
) -> WormArea {
    let f = &pair.flanks[flank];
    let mut area = WormArea { w: [f64::INFINITY, 0.0], z: [f64::INFINITY, f64::NEG_INFINITY] };
    for index in 0..grid.count() {
        let (w_2, z_2) = grid.ray(index);
        let feed = feed_of(pair, flank, motion, w_2, z_2);
        let shift = motion.shift.value(feed);
        let w_1 = f.worm_roll(w_2, shift, feed);
        let z_1 = f.worm_z(w_1, shift, feed);
        area.w = [area.w[0].min(w_1 - margin[0]), area.w[1].max(w_1 + margin[0])];
        area.z = [area.z[0].min(z_1 - margin[1]), area.z[1].max(z_1 + margin[1])];
    }
    area.w[0] = area.w[0].max(0.1);
    area
}

/// Feed at which the unmodified pair touches (w_2, z_2).
pub fn feed_of(pair: &Pair, flank: Flank, motion: &GeneratingMotion, w_2: f64, z_2: f64) -> f64 {
    let f = &pair.flanks[flank];
    let mut v = 0.0;
    for _ in 0..50 {
        let [shift, slope, _] = motion.shift.jet(v);
        v -= (f.work_z(w_2, shift, v) - z_2) / (f.c_zv12 * slope + f.c_zv22);
    }
    v
}

/// Feeds that a field needs, with a margin, mm.
pub fn feeds(pair: &Pair, flank: Flank, grid: &RayGrid, motion: &GeneratingMotion, margin: f64) -> [f64; 2] {
    let all = (0..grid.count()).map(|i| grid.ray(i)).map(|(w, z)| feed_of(pair, flank, motion, w, z));
    let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
    [low - margin, high + margin]
}

/// A gear with a worm on its own rack, both flanks without backlash.
pub fn meshing(
    teeth: i32,
    module: f64,
    alpha_deg: f64,
    beta_deg: f64,
    threads: i32,
    worm_diameter: f64,
) -> Pair {
    let work = GearData {
        teeth,
        normal_module: module,
        pressure_angle: Sides::both(alpha_deg.to_radians()),
        helix_angle: beta_deg.to_radians(),
        profile_shift: 0.1,
        cone_angle: 0.0,
    };
    meshing_with(work, (threads, 1.0), worm_diameter, 0.0)
}

/// The same for any workpiece and a worm of either hand with a cone angle, rad.
pub fn meshing_with(work: GearData, (threads, hand): (i32, f64), worm_diameter: f64, worm_cone: f64) -> Pair {
    let work = Gear::new(work).unwrap();
    let choice = WormChoice {
        threads,
        hand,
        pitch_diameter: Some(worm_diameter),
        tip_diameter: None,
        pressure_angle: None,
        profile_shift: 0.0,
        cone_angle: worm_cone,
    };
    let worm = worm_for_gear(&work, &choice).unwrap();
    Pair::without_backlash(worm.worm, work, worm.crossed_axes_angle).unwrap()
}

/// Rays over the working depth of a gear.
pub fn field(work: &Gear, flank: Flank, rows: usize, width: f64, columns: usize) -> RayGrid {
    let f: &InvoluteFlank = work.flank(flank);
    let (m, r) = (work.data().normal_module, work.pitch_radius());
    let low = f.length_of_roll((r - 0.8 * m).max(1.01 * f.base_radius)).unwrap();
    let high = f.length_of_roll(r + 1.1 * m).unwrap();
    RayGrid::equidistant([low, high], rows, [-0.5 * width, 0.5 * width], columns).unwrap()
}

/// A worm with its conjugate dresser and a dressing motion DK(v) of a case of the dressing reference.
pub struct DressingCase {
    pub worm: Gear,
    pub tool: DresserTool,
    pub range: GeometricRange,
    pub corrections: [Chebyshev; 4],
    pub expected: Value,
}

pub fn dressing_cases() -> Vec<DressingCase> {
    reference("30-dressing.json")["cases"].as_array().unwrap().iter().map(dressing_case).collect()
}

fn dressing_case(case: &Value) -> DressingCase {
    let i = &case["input"];
    let (z_s, d_s, m_n) = (num(&i["z_S"]), num(&i["d_S"]), num(&i["m_n"]));
    let alpha = num(&i["alpha_nS_deg"]).to_radians();
    let space = num(&case["worm"]["e_n_mm"]);
    let worm = Gear::new(GearData {
        teeth: z_s as i32,
        normal_module: m_n,
        pressure_angle: Sides::both(alpha),
        helix_angle: num(&i["hand"]) * (z_s * m_n / d_s).acos(),
        profile_shift: (std::f64::consts::FRAC_PI_2 - space / m_n) / (2.0 * alpha.tan()),
        cone_angle: 0.0,
    })
    .unwrap();
    let nominal = &case["nominal_kinematics"];
    let chain = DressingChain {
        worm_angle: num(&nominal["phi_S_deg"]).to_radians(),
        crossing_angle: num(&nominal["gamma_A_deg"]).to_radians(),
        centre_distance: num(&nominal["d_mm"]),
        offset: 0.0,
        screw_parameter: worm.screw_parameter(Flank::Left),
    };
    let range = GeometricRange { w_nf: num(&case["worm"]["w_NfS_mm"]), w_na: num(&case["worm"]["w_NaS_mm"]) };
    let tool = DresserTool::conjugate(&worm, Sides::both(chain), Sides::both(range)).unwrap();
    let t = &case["topological"];
    let (lin, quad) = (list(&t["DK_lin_deg_mm_per_mm"]), list(&t["DK_quad_deg_mm_per_mm2"]));
    let corrections = std::array::from_fn(|j| {
        let unit = if j < 2 { 1f64.to_radians() } else { 1.0 };
        Chebyshev::fit(-40.0, 40.0, 5, |v| Ok::<_, ()>(unit * (lin[j] * v + quad[j] * v * v))).unwrap()
    });
    DressingCase { worm, tool, range, corrections, expected: t.clone() }
}
