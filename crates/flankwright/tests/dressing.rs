//! Dressing against the reference numbers of spec 30.
use flankwright::geometry::*;
use flankwright::kinematics::*;
use flankwright::process::dressing::*;
use serde_json::Value;

fn num(v: &Value) -> f64 {
    v.as_f64().unwrap()
}
fn arr(v: &Value) -> Vec<f64> {
    v.as_array().unwrap().iter().map(num).collect()
}

#[test]
fn reference() {
    let text = std::fs::read_to_string(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../tests/reference/30-dressing.json"
    ))
    .unwrap();
    let file: Value = serde_json::from_str(&text).unwrap();
    for case in file["cases"].as_array().unwrap() {
        let i = &case["input"];
        let (z_s, d_s, hand) = (num(&i["z_S"]), num(&i["d_S"]), num(&i["hand"]));
        let m_n = num(&i["m_n"]);
        let beta = hand * (z_s * m_n / d_s).acos();
        let alpha = num(&i["alpha_nS_deg"]).to_radians();
        let e_n = num(&case["worm"]["e_n_mm"]);
        let x = (std::f64::consts::PI / 2.0 - e_n / m_n) / (2.0 * alpha.tan());
        let worm = Gear::new(GearData {
            teeth: z_s as i32,
            normal_module: m_n,
            pressure_angle: Sides::both(alpha),
            helix_angle: beta,
            profile_shift: x,
            cone_angle: 0.0,
        })
        .unwrap();
        println!("eta {} {}", worm.flank(Flank::Left).base_space_half_angle, case["worm"]["eta_b_rad"]);
        let nk = &case["nominal_kinematics"];
        let chain = DressingChain {
            worm_angle: num(&nk["phi_S_deg"]).to_radians(),
            crossing_angle: num(&nk["gamma_A_deg"]).to_radians(),
            centre_distance: num(&nk["d_mm"]),
            offset: 0.0,
            screw_parameter: worm.screw_parameter(Flank::Left),
        };
        let range =
            GeometricRange { w_nf: num(&case["worm"]["w_NfS_mm"]), w_na: num(&case["worm"]["w_NaS_mm"]) };
        let tool = DresserTool::conjugate(&worm, chain, Sides::both(range)).unwrap();
        for flank in Flank::BOTH {
            let d = &case["dresser"][flank.name()];
            for (k, w) in arr(&d["w_mm"]).into_iter().enumerate() {
                let c = nominal_contact(worm.flank(flank), &chain, w).unwrap();
                let m = tool.flanks[flank].profile.at(w);
                assert!((m.r - arr(&d["r_A_mm"])[k]).abs() < 1e-9, "{} {}", m.r, arr(&d["r_A_mm"])[k]);
                assert!((m.z - arr(&d["z_A_mm"])[k]).abs() < 1e-9);
                assert!((m.n_r - arr(&d["n_r"])[k]).abs() < 1e-10);
                assert!((c.b - arr(&d["b_mm"])[k]).abs() < 1e-9);
            }
            let l = ContactLine::fit(&tool, flank, [0.0; 4]).unwrap();
            println!(
                "rho {} {} X {} {} st {} {}",
                l.rho.to_degrees(),
                d["rho_fit_deg"],
                l.coordinate,
                d["X_fit_mm"],
                l.straightness * 1e3,
                d["straightness_peak_to_peak_um"]
            );
        }
        let dk_of = |v: &Value| -> [f64; 4] {
            [
                num(&v["d_phi_S_deg"]).to_radians(),
                num(&v["d_gamma_deg"]).to_radians(),
                num(&v["d_d_mm"]),
                num(&v["d_v_yA_mm"]),
            ]
        };
        let mut worst = 0f64;
        for p in case["profile"].as_array().unwrap() {
            if !p["dresser_mod_mm"].is_null() {
                continue;
            }
            let flank = if p["flank"] == "left" { Flank::Left } else { Flank::Right };
            let dk = dk_of(&p["DK"]);
            let prof = DressedProfile::new(&tool, flank, dk);
            for (k, w) in arr(&p["w_mm"]).into_iter().enumerate() {
                let at = prof.at_roll(w).unwrap();
                worst = worst.max((at.f * 1e3 - arr(&p["f_n_um"])[k]).abs());
                assert!((at.b - arr(&p["b_mm"])[k]).abs() < 1e-8);
                assert!((at.t - arr(&p["t_mm"])[k]).abs() < 1e-8);
                let j = arr(&p["jacobian_mm_per_rad_or_mm"][k]);
                for c in 0..4 {
                    assert!((at.df_dk[c] - j[c]).abs() < 1e-9 * j[0].abs(), "{:?} {:?}", at.df_dk, j);
                }
            }
        }
        println!("profile worst {worst} um");
        assert!(worst < 1e-6);
        for tp in case["three_point"].as_array().unwrap() {
            let c = num(&tp["c_alpha_V_um"]) * 1e-3;
            let bbv = num(&case["worm"]["gear_beta_b_deg"]).to_radians();
            let wanted =
                move |w: f64, _b: f64| if (w - range.middle()).abs() < 1e-9 { -c * bbv.cos() } else { 0.0 };
            let t0 = std::time::Instant::now();
            let dk = solve_node(&tool, Flank::Left, d_s / 2.0, 0.0, &[0.0; 4], &wanted);
            println!("c {c} {:?} {:?} want {:?}", t0.elapsed(), dk, dk_of(&tp["DK"]));
        }
        let t = &case["topological"];
        let (lin, quad) = (arr(&t["DK_lin_deg_mm_per_mm"]), arr(&t["DK_quad_deg_mm_per_mm2"]));
        let series: [flankwright::numerics::Chebyshev; 4] = std::array::from_fn(|j| {
            let u = if j < 2 { 1f64.to_radians() } else { 1.0 };
            flankwright::numerics::Chebyshev::fit(-40.0, 40.0, 5, |v| {
                Ok::<_, ()>(u * (lin[j] * v + quad[j] * v * v))
            })
            .unwrap()
        });
        let dressed = DressedWorm::new(&tool, Flank::Left, &series);
        let (w, b, f, v) = (arr(&t["w_mm"]), arr(&t["b_mm"]), arr(&t["f_exact_um"]), arr(&t["v_zS_mm"]));
        for k in 0..w.len() {
            let m = dressed.modification(w[k], b[k]);
            println!("{:?} want {} {}", m.map(|m| (m.0 * 1e3, m.2)), f[k], v[k]);
        }
    }
}
