//! Bevel flanks: octoid against reference and spherical involute, and pairs that mesh.

use super::cases::{bevel_data, bevel_gear, number, reference, vector};
use foundation::geometry::{
    BevelData, BevelGear, Flank, FlankLine, Hand, LineForm, Octoid, SphericalInvolute, Spiral, Surface,
};
use foundation::numerics::brent;
use nalgebra::{Rotation3, Vector3};
use std::f64::consts::{FRAC_PI_2, PI};

/// Signed distance of a point from a flank along the flank's normal: Newton on both parameters.
fn deviation(surface: &dyn Surface, point: &Vector3<f64>, start: [f64; 2]) -> f64 {
    let [mut a, mut b] = start;
    for _ in 0..50 {
        let jet = surface.jet(a, b);
        let miss = point - jet.point;
        let (s_a, s_b) = (jet.by_height, jet.by_length);
        let (aa, ab, bb) = (s_a.dot(&s_a), s_a.dot(&s_b), s_b.dot(&s_b));
        let (m_a, m_b) = (s_a.dot(&miss), s_b.dot(&miss));
        let determinant = aa * bb - ab * ab;
        let step = [(bb * m_a - ab * m_b) / determinant, (aa * m_b - ab * m_a) / determinant];
        a += step[0];
        b += step[1];
        if step[0].abs() < 1e-14 && step[1].abs() < 1e-12 {
            break;
        }
    }
    let jet = surface.jet(a, b);
    (point - jet.point).dot(&jet.normal)
}

#[test]
fn the_octoid_is_that_of_the_reference() {
    let reference = reference();
    let gear = bevel_gear("straight_bevel");
    let octoid = Octoid::new(&gear, Flank::Left);
    let involute = SphericalInvolute::new(&gear, Flank::Left);
    let distance = number(&reference["octoid"]["R_mm"]);
    let items = reference["octoid"]["items"].as_array().unwrap();
    assert_eq!(items.len(), 6);
    let eta = PI / (2.0 * 16.0);
    for item in items {
        let theta = number(&item["theta_deg"]).to_radians();
        let height = octoid.height_of(theta).unwrap();
        assert!((-(height + eta) - number(&item["gamma_rad"])).abs() < 1e-12);
        assert!((octoid.polar_angle(height) - theta).abs() < 1e-14);
        let jet = octoid.jet(height, distance);
        assert!((jet.point - vector(&item["P_octoid_mm"])).norm() < 1e-10);
        assert!((jet.normal - vector(&item["n_octoid"])).norm() < 1e-12);
        let start = [gear.roll_angle(theta).unwrap(), distance];
        let difference = 1e3 * deviation(&involute, &jet.point, start);
        let expected = number(&item["normal_difference_um"]);
        assert!((difference - expected).abs() < 1e-4, "{difference} against {expected} um");
    }
}

#[test]
fn both_octoid_flanks_are_mirror_images_and_share_the_pitch_point() {
    let gear = bevel_gear("straight_bevel");
    let [left, right] = Flank::BOTH.map(|flank| Octoid::new(&gear, flank));
    for height in [-0.1, 0.0, 0.3] {
        let (l, r) = (left.point(height, 60.0), right.point(height, 60.0));
        assert!((l - Vector3::new(-r.x, r.y, r.z)).norm() < 1e-13 && l.x > 0.0);
    }
    let pitch = left.point(0.0, 60.0);
    let involute = SphericalInvolute::new(&gear, Flank::Left);
    let omega = gear.pitch_roll() / gear.base_angle().sin();
    assert!((pitch - involute.point(omega, 60.0)).norm() < 1e-13);
}

#[test]
fn undercut_begins_where_the_reference_has_it() {
    let gear = bevel_gear("straight_bevel");
    let octoid = Octoid::new(&gear, Flank::Left);
    let lowest = octoid.lowest_polar_angle();
    assert!((lowest.to_degrees() - 31.2803).abs() < 5e-5, "{}", lowest.to_degrees());
    let [from, to] = octoid.domain()[0];
    let mut angle = lowest;
    for i in 1..200 {
        let next = octoid.polar_angle(from + (to - from) * f64::from(i) / 200.0);
        assert!(next > angle, "the polar angle grows on the regular branch");
        angle = next;
    }
    assert!(octoid.polar_angle(from - 1e-3) > lowest, "and turns back below it");
}

#[test]
fn the_regular_branch_reaches_below_every_base_cone() {
    let mut gears = 0;
    for delta in (2..80).step_by(6) {
        for alpha in (5..45).step_by(4) {
            let [delta, alpha] = [delta, alpha].map(|angle| f64::from(angle).to_radians());
            let data = BevelData { addendum_factor: 0.1, ..BevelData::new(1.0, 40, delta, alpha, 0.1) };
            let Ok(gear) = BevelGear::new(data) else { continue };
            let octoid = Octoid::new(&gear, Flank::Left);
            assert!(octoid.lowest_polar_angle() < gear.base_angle(), "{delta} {alpha}");
            assert!(
                octoid.height_of(gear.form_angle()).is_ok() && octoid.height_of(gear.tip_angle()).is_ok()
            );
            gears += 1;
        }
    }
    assert!(gears > 80, "{gears}");
}

/// A member of a pair turned by its angle, in the frame of the first at its middle position.
struct Member {
    gear: BevelGear,
    flank: SphericalInvolute,
    to_common: Rotation3<f64>,
}

impl Member {
    fn new(data: BevelData, to_common: Rotation3<f64>) -> Self {
        let gear = BevelGear::new(data).unwrap();
        let flank = SphericalInvolute::new(&gear, Flank::Left);
        Self { gear, flank, to_common }
    }

    fn pose(&self, angle: f64) -> Rotation3<f64> {
        self.to_common * Rotation3::from_axis_angle(&Vector3::z_axis(), angle)
    }
}

/// The pitch cone angle of 16 teeth beside 24 on axes at a right angle.
fn right_angle() -> [f64; 2] {
    let first = 16f64.atan2(24.0);
    [first, FRAC_PI_2 - first]
}

/// The largest distance of contact points of the first member from the flank of the second, mm.
fn worst_of_pair(spiral: Option<(f64, LineForm)>, [delta_1, delta_2]: [f64; 2]) -> f64 {
    let input = &reference()["cases"]["straight_bevel"]["input"];
    let (z_1, z_2) = (16u32, 24u32);
    let data = |teeth, pitch_angle, hand| {
        let spiral = spiral.map(|(mean_angle, form)| Spiral { mean_angle, form, hand });
        BevelData { teeth, pitch_angle, spiral, ..bevel_data(input) }
    };
    // The axis of the second lies on the other side of the pitch line (0, sin delta_1, cos delta_1); its y points back.
    let shaft: f64 = delta_1 + delta_2;
    let (sin, cos) = shaft.sin_cos();
    let to_common = Rotation3::from_basis_unchecked(&[
        Vector3::new(-1.0, 0.0, 0.0),
        Vector3::new(0.0, -cos, sin),
        Vector3::new(0.0, sin, cos),
    ]);
    let first = Member::new(data(z_1, delta_1, Hand::Right), Rotation3::identity());
    let second = Member::new(data(z_2, delta_2, Hand::Left), to_common);
    let pitch_line = Vector3::new(0.0, delta_1.sin(), delta_1.cos());
    let (mut worst, mut contacts) = (0.0f64, 0);
    for step in -20..=20 {
        let angle = 0.015 * f64::from(step);
        let pose_1 = first.pose(angle);
        // A tooth of the second stands in the space of the first.
        let pose_2 = second.pose(-angle * f64::from(z_1) / f64::from(z_2) + PI / f64::from(z_2));
        for share in [0.08, 0.33, 0.53, 0.78, 0.98] {
            let [toe, heel] = first.gear.face();
            let distance = toe + share * (heel - toe);
            // Contact: the members roll about the pitch line, so that the normal has no part along that motion.
            let rolling = |omega: f64| {
                let jet = first.flank.jet(omega, distance);
                Some((pose_1 * jet.normal).dot(&pitch_line.cross(&(pose_1 * jet.point))))
            };
            let [from, to] = first.gear.heights();
            let ends = [rolling(from).unwrap(), rolling(to).unwrap()];
            let Some(omega) = brent([from, to], ends, 0.0, rolling) else { continue };
            let point = pose_2.inverse() * (pose_1 * first.flank.point(omega, distance));
            let theta = point.x.hypot(point.y).atan2(point.z);
            let Ok(omega_2) = second.gear.roll_angle(theta) else { continue };
            worst = worst.max((point - second.flank.point(omega_2, distance)).norm());
            contacts += 1;
        }
    }
    assert!(contacts > 40, "only {contacts} places of contact");
    worst
}

#[test]
fn straight_pairs_are_conjugate() {
    let worst = worst_of_pair(None, right_angle());
    assert!(worst < 2e-13, "{worst:e}");
}

#[test]
fn spiral_pairs_are_conjugate() {
    for form in [
        LineForm::Circle { radius: 60.0 },
        LineForm::Epicycloid { radius: 60.0, groups: 5.0 },
        LineForm::Straight,
        LineForm::Involute,
    ] {
        let worst = worst_of_pair(Some((35f64.to_radians(), form)), right_angle());
        assert!(worst < 2e-13, "{form:?}: {worst:e}");
    }
}

/// The pitch cone of the second is a plane, whose teeth the first meets on both sides of it.
#[test]
fn crown_gears_are_conjugate_to_their_pinions() {
    let with_crown = [(16f64 / 24.0).asin(), FRAC_PI_2];
    for spiral in [None, Some((20f64.to_radians(), LineForm::Circle { radius: 60.0 }))] {
        let worst = worst_of_pair(spiral, with_crown);
        assert!(worst < 2e-13, "{spiral:?}: {worst:e}");
    }
}

#[test]
fn a_crown_gear_has_its_pitch_cone_in_a_plane_and_flat_octoids() {
    let data =
        BevelData { pitch_angle: FRAC_PI_2, ..bevel_data(&reference()["cases"]["straight_bevel"]["input"]) };
    let gear = BevelGear::new(data).unwrap();
    assert!((gear.base_angle() - (FRAC_PI_2 - data.pressure_angle)).abs() < 1e-15);
    assert!(gear.tip_angle() > FRAC_PI_2 && gear.root_angle() < FRAC_PI_2);
    // Teeth and spaces are equally wide in the pitch plane, where the involute has its inflection.
    for side in Flank::BOTH {
        let involute = SphericalInvolute::new(&gear, side);
        let roll = gear.roll_angle(FRAC_PI_2).unwrap();
        let pitch = involute.jet(roll, 30.0);
        let azimuth = side.sign() * pitch.point.x.atan2(pitch.point.y);
        assert!(pitch.point.z.abs() < 1e-13 && (azimuth - PI / 32.0).abs() < 1e-14, "{azimuth}");
        assert!(pitch.normal_by_height.norm() < 1e-14);
        let [from, to] = gear.heights();
        let bends = [from, to].map(|omega| {
            let jet = involute.jet(omega, 30.0);
            jet.normal_by_height.dot(&jet.by_height)
        });
        assert!(bends[0] > 1e-3 && bends[1] < -1e-3, "{bends:?}");
        let octoid = Octoid::new(&gear, side);
        let heights = [gear.form_angle(), gear.tip_angle()].map(|angle| octoid.height_of(angle).unwrap());
        let [low, high] = heights.map(|height| octoid.jet(height, 30.0));
        assert!((low.normal - high.normal).norm() < 1e-15);
        assert!((high.point - low.point).dot(&low.normal).abs() < 1e-13);
        let flat = octoid.jet(0.0, 30.0);
        assert!((flat.point - pitch.point).norm() < 1e-13 && (flat.normal - pitch.normal).norm() < 1e-13);
    }
}

/// A blade on a head that turns while the crown gear does, z_0 spaces of it for each turn, leaves the line of the flank.
#[test]
fn an_epicycloid_is_what_a_blade_leaves_on_the_turning_crown_gear() {
    let spiral = Spiral {
        mean_angle: 0.6,
        form: LineForm::Epicycloid { radius: 70.0, groups: 5.0 },
        hand: Hand::Left,
    };
    let gear = BevelGear::new(BevelData { spiral: Some(spiral), ..BevelData::new(5.0, 24, 0.8, 0.35, 25.0) })
        .unwrap();
    let (mean, crown_teeth) = (gear.mean_distance(), 24.0 / 0.8f64.sin());
    let line = gear.line();
    // The head's axis stands still and the crown gear turns against the head: as seen from the crown gear the blade runs at
    // (head + crown) about the head's axis and with the crown's turn about the apex.
    let FlankLine::Circular(circle) = line else { panic!("{line:?}") };
    let centre = circle.centre_distance();
    let mut before: Option<[f64; 2]> = None;
    for k in 0..400 {
        let head = 1.2 + 0.004 * f64::from(k);
        let crown = head * 5.0 / crown_teeth;
        // At rest: the blade on its circle about (centre, 0).
        let at = [centre + 70.0 * head.cos(), -70.0 * head.sin()];
        let (distance, angle) = (at[0].hypot(at[1]), at[1].atan2(at[0]) - crown);
        if (distance - mean).abs() > 12.0 {
            before = None;
            continue;
        }
        // Hand left: the section turns against the angle.
        let turn = line.angle(distance) * 0.8f64.sin();
        if let Some([angle_before, turn_before]) = before {
            let (is, wanted) = (angle - angle_before, turn_before - turn);
            assert!((is.abs() - wanted.abs()).abs() < 1e-12 && is.abs() > 1e-6, "{k}: {is} {wanted}");
        }
        before = Some([angle, turn]);
    }
    assert!(before.is_none(), "the whole face was walked");
    let slope = line.derivatives(mean)[1] * mean * 0.8f64.sin();
    assert!((slope + 0.6f64.tan()).abs() < 1e-12, "{slope}");
}
