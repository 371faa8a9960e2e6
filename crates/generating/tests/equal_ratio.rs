//! Worms with the same diagonal ratio on both flanks: every lever, and what cannot be searched.

use contact::DiagonalLine;
use foundation::geometry::{Flank, Gear, GearData, Sides, WormChoice};
use generating::{EqualRatioSearch, GeneratingError, Lever, WormLine, generatrix};

fn work(left_deg: f64, right_deg: f64, beta_deg: f64, cone_deg: f64) -> Gear {
    Gear::new(GearData {
        teeth: 31,
        normal_module: 2.5,
        pressure_angle: Sides { left: left_deg.to_radians(), right: right_deg.to_radians() },
        helix_angle: beta_deg.to_radians(),
        profile_shift: 0.15,
        cone_angle: cone_deg.to_radians(),
    })
    .unwrap()
}

fn worm(diameter: f64) -> WormChoice {
    WormChoice {
        threads: 2,
        hand: 1.0,
        pitch_diameter: Some(diameter),
        tip_diameter: None,
        pressure_angle: None,
        profile_shift: 0.0,
        cone_angle: 0.0,
    }
}

fn lines(left_deg: f64, right_deg: f64) -> Sides<DiagonalLine> {
    Sides { left: left_deg, right: right_deg }.map(|_, deg: &f64| DiagonalLine { rho: deg.to_radians() })
}

fn search(work: &Gear, left_deg: f64, right_deg: f64) -> EqualRatioSearch<'_> {
    let worm_line: WormLine<'_> = &generatrix;
    EqualRatioSearch { work, worm: worm(240.0), work_lines: lines(left_deg, right_deg), worm_line }
}

fn range(from_deg: f64, to_deg: f64) -> [f64; 2] {
    [from_deg.to_radians(), to_deg.to_radians()]
}

/// At every root both flanks lay their worm lines onto the wanted lines with one ratio, judged by the points of a line:
/// no formula of the ratio enters.
fn is_common(search: &EqualRatioSearch<'_>, lever: Lever, range: [f64; 2]) -> Vec<f64> {
    let found = search.search(lever, range).unwrap();
    for root in &found.roots {
        assert!(root.value >= range[0] && root.value <= range[1] && root.ratio.is_finite());
        for flank in Flank::BOTH {
            let f = &root.pair.flanks[flank];
            let line = (search.worm_line)(f).unwrap();
            let wanted = search.work_lines[flank];
            let middle =
                root.pair.work.pitch_radius() * root.pair.work.transverse_pressure_angle(flank).sin();
            let at = |x: f64| {
                let (w, z) = (middle + x * wanted.rho.cos(), -x * wanted.rho.sin());
                let diagonal = contact::DiagonalRatio { ratio: root.ratio, shift_origin: 3.0 };
                let point = f.point_map(w, z, diagonal).unwrap();
                line.coordinate(point.w_1, point.z_1)
            };
            let spread = (at(4.0) - at(-4.0)).abs();
            assert!(spread < 1e-8, "{lever:?} {flank} {}: {spread}", root.value.to_degrees());
        }
        let other = match lever {
            Lever::ConeAngle => root.design.worm.data().cone_angle,
            Lever::ProfileAngle => root.design.worm.data().pressure_angle.left,
            Lever::CrossingAngle => root.design.crossed_axes_angle,
        };
        assert!((other - root.value).abs() < 1e-12, "{lever:?} {other} {}", root.value);
    }
    found.roots.iter().map(|root| root.value).collect()
}

#[test]
fn every_lever_finds_common_ratios() {
    let asymmetric = work(25.0, 18.0, 20.0, 0.0);
    let plain = search(&asymmetric, 30.0, -30.0);
    let cones = is_common(&plain, Lever::ConeAngle, range(-12.0, 12.0));
    assert!((cones[0].to_degrees() + 3.197009462252167).abs() < 1e-9, "{cones:?}");
    // From the root's worm with another cone angle the search finds the same worm.
    let tilted = EqualRatioSearch { worm: WormChoice { cone_angle: 0.02, ..plain.worm }, ..plain };
    assert!((is_common(&tilted, Lever::ConeAngle, range(-9.0, 7.0))[0] - cones[0]).abs() < 1e-13);

    // Lines along the generatrix feel neither the crossing angle nor the rack: sin(beta_b1) = cos(alpha_n) sin(beta_w1) keeps
    // its proportion between the flanks. Lines of axial sections feel both. The wanted directions are those that a known
    // worm makes with one ratio.
    let axial: WormLine<'_> = &|f| Ok(f.axial_section_line(14.0));
    for (lever, values) in
        [(Lever::CrossingAngle, range(-109.8, -104.0)), (Lever::ProfileAngle, range(24.0, 28.5))]
    {
        let known = values[0] + 0.37 * (values[1] - values[0]);
        // K of the left flank at the known worm; the right direction is the one that gives the same there.
        let worm = match lever {
            Lever::ProfileAngle => WormChoice { pressure_angle: Some(known), ..plain.worm },
            _ => {
                let helix = -known - asymmetric.data().helix_angle;
                WormChoice { pitch_diameter: Some(2.0 * 2.5 / helix.cos()), ..plain.worm }
            }
        };
        let there = EqualRatioSearch { worm, worm_line: axial, ..plain };
        let mut wanted = EqualRatioSearch { worm_line: axial, ..plain };
        let ratio = there.ratios().unwrap().left;
        let made = foundation::geometry::worm_for_gear(&asymmetric, &there.worm).unwrap();
        let pair = contact::Pair::without_backlash(made.worm, asymmetric, made.crossed_axes_angle).unwrap();
        let right = &pair.flanks.right;
        wanted.work_lines.right = right.work_direction(axial(right).unwrap(), ratio).unwrap();
        let roots = is_common(&wanted, lever, values);
        assert!(roots.iter().any(|root| (root - known).abs() < 1e-9), "{lever:?} {known} {roots:?}");
    }
}

#[test]
fn poles_and_equal_signs_give_no_root() {
    let symmetric = work(20.0, 20.0, -30.0, 0.0);
    let same = search(&symmetric, 30.0, 30.0).search(Lever::ConeAngle, range(-12.0, 12.0)).unwrap();
    assert!(same.roots.is_empty() && !same.everywhere);
    let start = same.start.unwrap();
    assert!((start.left - start.right).abs() > 1.0, "{start:?}");
    // Worm lines for which the right flank's ratio goes through infinity at a cone angle of 0.05: a change of sign that is no
    // root. There the denominator of K, Chat_zV1 - p_1 C_zV11 - p_2 C_zV12, vanishes.
    let asymmetric = work(25.0, 18.0, 20.0, 0.0);
    let pole = 0.05;
    let lines = lines(30.0, -30.0);
    let worm_line: WormLine<'_> = &|f| {
        if f.flank() == Flank::Left {
            return generatrix(f);
        }
        let cone = f.a_1.y.atan2(f.a_1.z);
        let p_2 = f.hat_w2 / (lines.right.rho.tan() + f.c_w2);
        let p_1 = (f.hat_zv1 - p_2 * f.c_zv12) / f.c_zv11 + 2.0 * (cone - pole);
        Ok(DiagonalLine { rho: (f.hat_w1 / p_1 - f.c_w1).atan() })
    };
    let search = EqualRatioSearch { worm_line, ..search(&asymmetric, 30.0, -30.0) };
    let difference = |cone_angle: f64| {
        let beside = EqualRatioSearch { worm: WormChoice { cone_angle, ..search.worm }, ..search };
        let ratios = beside.ratios().unwrap();
        ratios.left - ratios.right
    };
    let (below, above) = (difference(pole - 1e-4), difference(pole + 1e-4));
    assert!(below * above < 0.0 && below.abs() > 100.0 && above.abs() > 100.0, "{below} {above}");
    let found = search.search(Lever::ConeAngle, range(-12.0, 12.0)).unwrap();
    assert!(!found.everywhere && found.roots.iter().all(|root| (root.value - pole).abs() > 1e-3));
}

#[test]
fn a_symmetric_gear_with_mirrored_lines_has_equal_ratios_on_every_symmetric_worm() {
    let symmetric = work(20.0, 20.0, -30.0, 0.0);
    let search = search(&symmetric, 30.0, -30.0);
    for (lever, values) in
        [(Lever::ProfileAngle, range(18.0, 23.0)), (Lever::CrossingAngle, range(-60.0, -55.0))]
    {
        let found = search.search(lever, values).unwrap();
        assert!(found.everywhere && found.roots.len() == 1, "{lever:?}");
        assert!((found.roots[0].ratio - found.start.unwrap().left).abs() < 1e-12);
    }
    let cone = search.search(Lever::ConeAngle, range(-12.0, 12.0)).unwrap();
    assert!(!cone.everywhere && cone.roots[0].value.abs() < 1e-15, "{:?}", cone.roots[0].value);
}

#[test]
fn impossible_searches_are_refused() {
    let conical = work(20.0, 20.0, 12.0, 5.0);
    let cylinder = work(20.0, 20.0, 12.0, 0.0);
    let code = |work: &Gear, lever, values, diameter: f64| {
        let search = EqualRatioSearch { worm: worm(diameter), ..search(work, 30.0, -30.0) };
        let error: GeneratingError = search.search(lever, values).unwrap_err();
        assert!(!error.way_out().is_empty());
        error.code()
    };
    assert_eq!(code(&conical, Lever::ProfileAngle, range(18.0, 22.0), 240.0), "cylindrical-only");
    assert_eq!(code(&cylinder, Lever::ConeAngle, range(2.0, 2.0), 240.0), "invalid-number");
    assert_eq!(code(&cylinder, Lever::ConeAngle, [f64::NAN, 0.1], 240.0), "invalid-number");
    assert_eq!(code(&cylinder, Lever::ConeAngle, range(-12.0, 12.0), 4.0), "worm-too-small");
    // No right-handed worm reaches these angles.
    assert_eq!(code(&cylinder, Lever::CrossingAngle, range(20.0, 60.0), 240.0), "invalid-number");
    // A spur gear with lines along the tooth has no finite ratio, whatever the worm.
    let spur = work(20.0, 20.0, 0.0, 0.0);
    let search = search(&spur, 0.0, 0.0);
    let error = search.search(Lever::ProfileAngle, range(18.0, 22.0)).unwrap_err();
    assert!(["direction-is-contact-path", "diagonal-ratio-infinite"].contains(&error.code()), "{error}");
}
