//! Properties of random toothed bodies, and every refusal of the geometry room.

mod random_bodies;

use foundation::geometry::{
    Blank, Flank, Gear, GearData, GeometryError, Sides, ThicknessMeasure, WormChoice, check_mating,
    worm_for_gear,
};
use foundation::numerics::{gradient_of, value_of, variables};
use nalgebra::Vector3;
use proptest::prelude::*;
use random_bodies::{gear, gear_data};
use std::f64::consts::PI;

fn flank() -> impl Strategy<Value = Flank> {
    any::<bool>().prop_map(|left| if left { Flank::Left } else { Flank::Right })
}

/// The same body seen in a mirror that exchanges x and -x: other hand, flanks exchanged.
fn mirrored(data: GearData) -> Gear {
    Gear::new(GearData {
        helix_angle: -data.helix_angle,
        pressure_angle: Sides { left: data.pressure_angle.right, right: data.pressure_angle.left },
        ..data
    })
    .unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// Stock on the flanks thickens the tooth by what it measures along the base tangents; the span grows by both flanks' stock.
    #[test]
    fn stock_thickens_the_tooth(gear in gear(), left in 0.0..0.02f64, right in 0.0..0.02f64) {
        let module = gear.data().normal_module;
        let stock = Sides { left: left * module, right: right * module };
        if let Ok(before) = gear.with_allowance(&stock) {
            let r = gear.pitch_radius();
            let base = gear.flanks().left.base_radius.max(gear.flanks().right.base_radius);
            if let (Ok(thick), Ok(finished)) = (before.transverse_thickness(r, 0.0), gear.transverse_thickness(r, 0.0)) {
                let wanted: f64 = Flank::BOTH
                    .into_iter()
                    .map(|side| {
                        let f = gear.flank(side);
                        stock[side] * r / (f.base_radius * f.base_helix_angle.cos())
                    })
                    .sum();
                prop_assert!((thick - finished - wanted).abs() < 1e-9 * base, "{} {wanted}", thick - finished);
            }
            if let (Ok(wide), Ok(finished)) = (before.span(3), gear.span(3)) {
                let grown = gear.external_sign() * (wide.length - finished.length);
                prop_assert!((grown - stock.left - stock.right).abs() < 1e-9 * base, "{grown}");
            }
        }
    }

    /// A point at a known distance over a known flank point is found again: f to 1e-10 mm, w and z to 1e-10 mm.
    #[test]
    fn offset_points_are_found_again(
        gear in gear(), side in flank(), share in 0.15..1.3f64, z in -30.0..30.0f64, f in -0.2..0.2f64,
    ) {
        let flank = gear.flank(side);
        let w = share * 0.3 * gear.pitch_radius();
        let x = flank.point(w, z) + flank.normal(w, z) * f;
        let found = flank.deviation(&x);
        prop_assert!((found.f_n - f).abs() < 1e-10, "f {} for {f}", found.f_n);
        prop_assert!((found.w - w).abs() < 1e-10, "w {} for {w}", found.w);
        prop_assert!((found.z - z).abs() < 1e-10, "z {} for {z}", found.z);
        // The deviation from any other tooth's flank is the same.
        let (s, c) = (2.0 * PI / gear.tooth_count()).sin_cos();
        let turned = Vector3::new(c * x.x - s * x.y, s * x.x + c * x.y, x.z);
        prop_assert!((flank.deviation(&turned).f_n - f).abs() < 1e-10);
        prop_assert!((flank.radius(w) - flank.point(w, z).xy().norm()).abs() < 1e-11);
        prop_assert!((flank.length_of_roll(flank.radius(w)).unwrap() - w).abs() < 1e-9);
    }

    /// The right flank is the mirror image (x -> -x at the same w and z) of the left flank of the gear of the other hand.
    #[test]
    fn flanks_and_hands_mirror(data in gear_data(), side in flank(), w in 0.5..20.0f64, z in -30.0..30.0f64) {
        let Ok(gear) = Gear::new(data) else { return Ok(()) };
        let other = mirrored(data);
        let (a, b) = (gear.flank(side), other.flank(side.other()));
        let across = |v: Vector3<f64>| Vector3::new(-v.x, v.y, v.z);
        let scale = 1.0 + a.base_radius + w;
        prop_assert!((across(a.point(w, z)) - b.point(w, z)).norm() < 1e-13 * scale);
        prop_assert!((across(a.normal(w, z)) - b.normal(w, z)).norm() < 1e-13);
        prop_assert!((a.base_helix_angle + b.base_helix_angle).abs() < 1e-14);
    }

    /// A half turn about y carries each flank onto the other one; the cone opens to the other side.
    #[test]
    fn a_half_turn_exchanges_the_flanks(data in gear_data(), side in flank(), w in 0.5..20.0f64, z in -30.0..30.0f64) {
        let Ok(gear) = Gear::new(data) else { return Ok(()) };
        let turned = Gear::new(GearData {
            pressure_angle: Sides { left: data.pressure_angle.right, right: data.pressure_angle.left },
            cone_angle: -data.cone_angle,
            ..data
        });
        let turned = turned.unwrap();
        let p = gear.flank(side).point(w, z);
        let q = turned.flank(side.other()).point(w, -z);
        prop_assert!((Vector3::new(-p.x, p.y, -p.z) - q).norm() < 1e-12 * (1.0 + p.norm()));
    }

    /// Normals are unit vectors across both tangents (dual numbers) and lead out of the material.
    #[test]
    fn normals_stand_across_the_surface(
        gear in gear(), side in flank(), w in 0.5..20.0f64, z in -30.0..30.0f64,
    ) {
        let flank = gear.flank(side);
        let [w_d, z_d] = variables([w, z]);
        let p = flank.point(w_d, z_d);
        let n = flank.normal(w, z);
        let columns = [gradient_of(&p.x), gradient_of(&p.y), gradient_of(&p.z)];
        let tangent = |k: usize| Vector3::new(columns[0][k], columns[1][k], columns[2][k]);
        prop_assert!((n.norm() - 1.0).abs() < 1e-14);
        for k in 0..2 {
            prop_assert!(n.dot(&tangent(k)).abs() < 1e-13 * (1.0 + tangent(k).norm()));
        }
        let frame = flank.frame(w, z);
        prop_assert!(frame.g.dot(&n).abs() < 1e-14 && (frame.g.norm() - 1.0).abs() < 1e-14);
        prop_assert!((frame.g.cross(&frame.e_r).cross(&n)).norm() < 1e-14);
        // The normal turns along e_r by kappa_1 and not along g.
        let n_d = flank.normal(w_d, z_d);
        let slope = [gradient_of(&n_d.x), gradient_of(&n_d.y), gradient_of(&n_d.z)];
        let dn = Vector3::new(slope[0][0], slope[1][0], slope[2][0]);
        let length = tangent(0).dot(&frame.e_r);
        prop_assert!((dn.dot(&frame.e_r) / length - flank.principal_curvatures(w)[0]).abs() < 1e-11);
        // A step outwards is a positive deviation.
        prop_assert!(flank.deviation(&(flank.point(w, z) + n * 1e-3)).f_n > 0.0);
    }

    /// The deviation's derivative along the surface vanishes and along the normal is 1 (dual numbers through the inverse).
    #[test]
    fn the_deviation_is_a_distance(gear in gear(), side in flank(), w in 2.0..20.0f64, z in -30.0..30.0f64) {
        let flank = gear.flank(side);
        let n = flank.normal(w, z);
        let p = flank.point(w, z);
        let x = variables([p.x, p.y, p.z]);
        let d = flank.deviation(&Vector3::from(x));
        let gradient = Vector3::from(gradient_of(&d.f_n));
        prop_assert!((gradient - n).norm() < 1e-10, "{gradient} {n}");
        prop_assert!(value_of(d.f_n).abs() < 1e-11);
    }

    /// Every measure of the tooth thickness leads back to the profile shift.
    #[test]
    fn thickness_measures_lead_back(data in gear_data(), ball in 1.2..2.2f64) {
        let Ok(gear) = Gear::new(data) else { return Ok(()) };
        let x = data.profile_shift;
        let back = |m: ThicknessMeasure| m.profile_shift(data).unwrap();
        prop_assert_eq!(back(ThicknessMeasure::ProfileShift(x)), x);
        let tangents = data.pressure_angle.left.tan() + data.pressure_angle.right.tan();
        if gear.is_cylindrical() {
            let s_n = data.normal_module * (PI / 2.0 + x * tangents);
            prop_assert!((back(ThicknessMeasure::NormalThickness(s_n)) - x).abs() < 1e-12);
            // The arc at the pitch cylinder is s_n over cos(beta).
            let s_t = gear.transverse_thickness(gear.pitch_radius(), 0.0).unwrap();
            prop_assert!((s_t * data.helix_angle.cos() - s_n).abs() < 1e-11 * (1.0 + gear.pitch_radius()));
        } else {
            let e = ThicknessMeasure::NormalThickness(3.0).profile_shift(data).unwrap_err();
            prop_assert_eq!(e.code(), "cylindrical-only");
        }
        match gear.span(3) {
            Ok(span) => {
                let measure = ThicknessMeasure::Span { teeth: 3, length: span.length };
                prop_assert!((back(measure) - x).abs() < 1e-10);
            }
            Err(e) => prop_assert_eq!(e.code(), "span-undefined"),
        }
        let ball = ball * data.normal_module;
        if let Ok(m) = gear.over_balls(ball, 0.0) {
            let measure = ThicknessMeasure::OverBalls { ball, size: m.size };
            prop_assert!((back(measure) - x).abs() < 1e-7, "{} for {x}", back(measure));
            // The ball touches both flanks: its centre lies D/2 over them.
            for (side, flank) in gear.flanks().iter() {
                let touch = flank.point(m.contact_w[side].abs(), m.contact_z[side]);
                let centre = touch + flank.normal(m.contact_w[side].abs(), m.contact_z[side]) * (ball / 2.0);
                if m.contact_w[side] * gear.external_sign() > 0.0 || gear.external_sign() < 0.0 {
                    prop_assert!((centre.xy().norm() - m.centre_radius).abs() < 1e-9);
                    prop_assert!(centre.z.abs() < 1e-9);
                }
            }
        }
    }

    /// Another rack of a cylindrical gear makes the same base cylinder and helix.
    #[test]
    fn other_racks_make_the_same_gear(data in gear_data(), more in 0.2..6.0f64) {
        let Ok(gear) = Gear::new(data) else { return Ok(()) };
        let angle = data.pressure_angle.left + more.to_radians();
        match gear.rack_with_pressure_angle(Flank::Left, angle) {
            Ok(rack) => {
                prop_assert!((rack.pressure_angle.left - angle).abs() < 1e-12);
                let again = Gear::new(GearData {
                    normal_module: rack.normal_module,
                    pressure_angle: rack.pressure_angle,
                    helix_angle: rack.helix_angle,
                    ..data
                })
                .unwrap();
                for side in Flank::BOTH {
                    let (a, b) = (gear.flank(side), again.flank(side));
                    prop_assert!((a.base_radius - b.base_radius).abs() < 1e-11 * a.base_radius);
                    prop_assert!((a.base_helix_angle - b.base_helix_angle).abs() < 1e-12);
                }
                let by_radius = gear.rack_at_pitch_radius(rack.pitch_radius).unwrap();
                prop_assert!((by_radius.normal_module - rack.normal_module).abs() < 1e-12 * rack.normal_module);
            }
            Err(e) => prop_assert!(["cylindrical-only", "no-rack"].contains(&e.code())),
        }
    }

    /// Rack heights lead to lengths of roll and back.
    #[test]
    fn rack_heights_lead_back(gear in gear(), side in flank(), h in -3.0..3.0f64, z in -20.0..20.0f64) {
        let w = gear.roll_of_rack_height(side, h, z);
        prop_assert!((gear.rack_height_of_roll(side, w, z) - h).abs() < 1e-11);
    }

    /// A worm built for a gear meshes with it on both flanks, with the gear's rack or another one.
    #[test]
    fn worms_mesh(
        data in gear_data(), threads in 1..6i32, right in any::<bool>(), factor in 20.0..90.0f64, own in any::<bool>(),
    ) {
        let Ok(gear) = Gear::new(data) else { return Ok(()) };
        let choice = WormChoice {
            threads,
            hand: if right { 1.0 } else { -1.0 },
            pitch_diameter: Some(factor * data.normal_module),
            tip_diameter: None,
            pressure_angle: (!own).then_some(data.pressure_angle.left + 0.01),
            profile_shift: 0.0,
            cone_angle: 0.0,
        };
        match worm_for_gear(&gear, &choice) {
            Ok(found) => {
                check_mating(&found.worm, &gear).unwrap();
                prop_assert!((found.worm.pitch_radius() - factor * data.normal_module / 2.0).abs() < 1e-9);
                let sum = found.crossed_axes_angle + found.worm.data().helix_angle + found.rack.helix_angle;
                prop_assert!((sum - 2.0 * PI * (sum / (2.0 * PI)).round()).abs() < 1e-12);
            }
            Err(e) => prop_assert!(["cylindrical-only", "no-rack"].contains(&e.code()), "{e}"),
        }
    }
}

fn plain() -> GearData {
    GearData {
        teeth: 24,
        normal_module: 3.0,
        pressure_angle: Sides::both(20f64.to_radians()),
        helix_angle: 0.2,
        profile_shift: 0.0,
        cone_angle: 0.0,
    }
}

fn blank() -> Blank {
    Blank {
        face_width: 20.0,
        tip_diameter: 79.0,
        root_diameter: 65.5,
        tip_form_diameter: 78.6,
        form_diameter: 70.0,
        rack_addendum: Some(3.0),
    }
}

/// The code, and that the message names what is wrong and the way out is there.
fn refused<T: std::fmt::Debug>(result: Result<T, GeometryError>, code: &str, words: &[&str]) {
    let error = result.unwrap_err();
    assert_eq!(error.code(), code, "{error}");
    for word in words {
        assert!(error.to_string().contains(word), "{error} does not say {word}");
    }
    assert!(!error.way_out().is_empty());
}

#[test]
fn impossible_numbers_are_refused_by_name() {
    let with = |change: &dyn Fn(&mut GearData)| {
        let mut data = plain();
        change(&mut data);
        Gear::new(data)
    };
    refused(with(&|d| d.teeth = 0), "invalid-number", &["teeth = 0", "integer"]);
    for module in [0.0, -2.0, f64::NAN, f64::INFINITY] {
        refused(
            with(&|d| d.normal_module = module),
            "invalid-number",
            &["normal_module", &module.to_string()],
        );
    }
    for angle in [0.0, -0.1, PI / 2.0, f64::NAN] {
        refused(with(&|d| d.pressure_angle.right = angle), "invalid-number", &["normal_pressure_angle_deg"]);
    }
    for angle in [PI / 2.0, -PI / 2.0, f64::NAN, f64::INFINITY] {
        refused(with(&|d| d.helix_angle = angle), "invalid-number", &["helix_angle_deg"]);
        refused(with(&|d| d.cone_angle = angle), "invalid-number", &["cone_angle_deg"]);
    }
    refused(with(&|d| d.profile_shift = f64::NAN), "invalid-number", &["profile_shift = NaN"]);
    refused(with(&|d| d.normal_module = 1e308), "invalid-geometry", &["base radius"]);
    refused(
        with(&|d| (d.teeth, d.cone_angle) = (-40, 0.1)),
        "internal-conical-unsupported",
        &["-40 teeth", "cone angle"],
    );
    refused(
        with(&|d| (d.helix_angle, d.cone_angle, d.pressure_angle) = (1.05, 0.21, Sides::both(0.14))),
        "pressure-angle-not-positive",
        &["right flank"],
    );
    // The first failing check is reported.
    refused(with(&|d| (d.teeth, d.normal_module) = (0, -1.0)), "invalid-number", &["teeth"]);
}

#[test]
fn impossible_blanks_are_refused() {
    let gear = Gear::new(plain()).unwrap();
    assert_eq!(blank().check(&gear), Ok(vec![]));
    let with = |change: &dyn Fn(&mut Blank)| {
        let mut b = blank();
        change(&mut b);
        b.check(&gear)
    };
    for width in [0.0, -1.0, f64::NAN] {
        refused(with(&|b| b.face_width = width), "invalid-number", &["face_width"]);
    }
    refused(with(&|b| b.tip_diameter = f64::INFINITY), "invalid-number", &["tip_diameter = inf"]);
    refused(with(&|b| b.form_diameter = 66.0), "radius-below-base-circle", &["33", "flank"]);
    refused(
        with(&|b| b.root_diameter = 71.0),
        "diameters-inconsistent",
        &["root_diameter = 71", "form_diameter"],
    );
    refused(
        with(&|b| b.form_diameter = 78.6),
        "diameters-inconsistent",
        &["form_diameter", "tip_form_diameter"],
    );
    refused(
        with(&|b| b.tip_form_diameter = 80.0),
        "diameters-inconsistent",
        &["tip_form_diameter", "tip_diameter"],
    );
    refused(with(&|b| b.rack_addendum = Some(9.0)), "undercut", &["left flank", "z = "]);
    refused(with(&|b| b.tip_diameter = 90.0), "tooth-pointed", &["radius 45"]);
    assert_eq!(with(&|b| b.tip_diameter = 82.5).unwrap().len(), 1);
    // Internal gears: the order is turned round.
    let ring = Gear::new(GearData { teeth: -61, ..plain() }).unwrap();
    let r = ring.pitch_radius();
    let inside = Blank {
        face_width: 20.0,
        tip_diameter: 2.0 * r - 5.0,
        tip_form_diameter: 2.0 * r - 4.8,
        form_diameter: 2.0 * r + 6.0,
        root_diameter: 2.0 * r + 7.0,
        rack_addendum: None,
    };
    assert!(inside.check(&ring).is_ok());
    let wrong = Blank { root_diameter: 2.0 * r - 1.0, ..inside };
    refused(wrong.check(&ring), "diameters-inconsistent", &["form_diameter", "root_diameter"]);
}

#[test]
fn impossible_measures_are_refused() {
    let gear = Gear::new(plain()).unwrap();
    let bad_ball = |ball| gear.over_balls(ball, 0.0);
    for ball in [0.0, -1.0, f64::NAN] {
        refused(bad_ball(ball), "invalid-number", &["ball"]);
        let measure = ThicknessMeasure::OverBalls { ball, size: 80.0 };
        refused(measure.profile_shift(plain()), "invalid-number", &["ball"]);
    }
    refused(bad_ball(0.5), "ball-too-small", &["0.5 mm"]);
    let ring = Gear::new(GearData { teeth: -61, ..plain() }).unwrap();
    refused(ring.over_balls(40.0, 0.0), "ball-too-large", &["40 mm"]);
    let conical = Gear::new(GearData { cone_angle: 0.05, ..plain() }).unwrap();
    refused(conical.span(3), "span-undefined", &["conical"]);
    let uneven = GearData { pressure_angle: Sides { left: 0.4, right: 0.3 }, ..plain() };
    refused(Gear::new(uneven).unwrap().span(3), "span-undefined", &["asymmetric"]);
    let span = ThicknessMeasure::Span { teeth: 3, length: 23.0 };
    refused(span.profile_shift(uneven), "span-undefined", &["asymmetric"]);
    let absurd = ThicknessMeasure::Span { teeth: 3, length: 400.0 };
    refused(absurd.profile_shift(plain()), "invalid-number", &["tooth thickness"]);
    refused(
        ThicknessMeasure::NormalThickness(f64::NAN).profile_shift(plain()),
        "invalid-number",
        &["tooth thickness"],
    );
    refused(
        gear.flank(Flank::Right).length_of_roll(20.0),
        "radius-below-base-circle",
        &["radius 20 mm", "right"],
    );
    refused(gear.transverse_thickness(f64::NAN, 0.0), "radius-below-base-circle", &["NaN"]);
}

#[test]
fn measures_off_the_flank_are_refused() {
    let gear = Gear::new(plain()).unwrap();
    let balls = |d| gear.over_balls(d, 0.0).unwrap();
    assert_eq!(blank().check_balls(&gear, &balls(5.25)), Ok(()));
    refused(blank().check_balls(&gear, &balls(9.0)), "contact-off-flank", &["left flank", "length of roll"]);
    let span = |k| gear.span(k).unwrap();
    assert_eq!(blank().check_span(&gear, &span(3)), Ok(()));
    refused(blank().check_span(&gear, &span(6)), "contact-off-flank", &["left flank", "length of roll"]);
}

#[test]
fn impossible_racks_and_worms_are_refused() {
    let gear = Gear::new(plain()).unwrap();
    let conical = Gear::new(GearData { cone_angle: 0.05, ..plain() }).unwrap();
    refused(gear.rack_at_pitch_radius(10.0), "no-rack", &["pitch radius = 10"]);
    refused(gear.rack_at_pitch_radius(f64::NAN), "no-rack", &["NaN"]);
    refused(gear.rack_with_module(100.0), "no-rack", &["normal module = 100"]);
    refused(gear.rack_with_module(-1.0), "no-rack", &["-1"]);
    refused(gear.rack_with_pressure_angle(Flank::Left, 1.56), "no-rack", &["pressure angle"]);
    refused(gear.rack_with_pressure_angle(Flank::Left, f64::NAN), "no-rack", &["NaN"]);
    refused(conical.rack_at_pitch_radius(40.0), "cylindrical-only", &["conical"]);
    let choice = WormChoice {
        threads: 3,
        hand: 1.0,
        pitch_diameter: Some(200.0),
        tip_diameter: None,
        pressure_angle: None,
        profile_shift: 0.0,
        cone_angle: 0.0,
    };
    assert!(worm_for_gear(&gear, &choice).is_ok());
    let with = |change: &dyn Fn(&mut WormChoice)| {
        let mut c = choice;
        change(&mut c);
        worm_for_gear(&gear, &c)
    };
    refused(with(&|c| c.threads = 0), "invalid-number", &["worm.threads = 0"]);
    refused(with(&|c| c.pitch_diameter = None), "invalid-number", &["worm.pitch_diameter"]);
    refused(with(&|c| c.pitch_diameter = Some(9.0)), "worm-too-small", &["3 threads", "9 mm"]);
    refused(with(&|c| c.pitch_diameter = Some(f64::NAN)), "worm-too-small", &["NaN"]);
    refused(with(&|c| c.tip_diameter = Some(199.0)), "diameters-inconsistent", &["199"]);
    refused(with(&|c| c.pressure_angle = Some(1.5)), "no-rack", &["pressure angle"]);
    let other = Gear::new(GearData { normal_module: 3.01, ..plain() }).unwrap();
    refused(check_mating(&other, &gear), "not-mating", &["left flank", "base pitch"]);
    let half = GearData { pressure_angle: Sides { left: 20f64.to_radians(), right: 0.3 }, ..plain() };
    refused(check_mating(&Gear::new(half).unwrap(), &gear), "not-mating", &["right flank"]);
}
