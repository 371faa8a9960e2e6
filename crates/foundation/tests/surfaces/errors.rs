//! Bad input gives typed errors.

use super::cases::{bevel_data, blade_data, cylindrical_gear, reference};
use foundation::geometry::{
    BevelData, BevelGear, BladeData, CylindricalCurve, EaseOff, EaseOffAmounts, Flank, FlankLine,
    GeometryError, GridSurface, Hand, Helicoid, LineForm, NormalSide, Octoid, RuledBlade, SphericalInvolute,
    Spiral, SplineCurve,
};
use foundation::numerics::CubicSpline;
use nalgebra::Vector3;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

fn straight() -> BevelData {
    bevel_data(&reference()["cases"]["straight_bevel"]["input"])
}

fn refused(data: BevelData) -> GeometryError {
    let error = BevelGear::new(data).unwrap_err();
    assert!(!error.way_out().is_empty() && !error.to_string().is_empty());
    error
}

#[test]
fn bevel_input_that_is_no_gear() {
    let good = straight();
    assert!(BevelGear::new(good).is_ok());
    let spiral = |mean_angle, cutter_radius| {
        Some(Spiral { mean_angle, form: LineForm::Circle { radius: cutter_radius }, hand: Hand::Right })
    };
    for data in [
        BevelData { outer_transverse_module: 0.0, ..good },
        BevelData { outer_transverse_module: f64::NAN, ..good },
        BevelData { teeth: 0, ..good },
        BevelData { pitch_angle: 0.0, ..good },
        BevelData { pitch_angle: 1.6, ..good },
        BevelData { pressure_angle: -0.1, ..good },
        BevelData { pressure_angle: f64::INFINITY, ..good },
        BevelData { face_width: 0.0, ..good },
        BevelData { addendum_factor: f64::NAN, ..good },
        BevelData { dedendum_factor: -1.0, ..good },
        BevelData { spiral: spiral(1.6, 60.0), ..good },
        BevelData { spiral: spiral(-0.1, 60.0), ..good },
        BevelData { spiral: spiral(0.5, 0.0), ..good },
        BevelData { form_angle: Some(f64::NAN), ..good },
    ] {
        assert_eq!(refused(data).code(), "invalid-number", "{data:?}");
    }
    for data in [
        BevelData { face_width: 80.0, ..good },
        BevelData { pitch_angle: FRAC_PI_2, addendum_factor: 3.0, ..good },
        BevelData { dedendum_factor: 12.0, ..good },
        BevelData { form_angle: Some(0.66), ..good },
        BevelData { outer_transverse_module: 1e308, teeth: 4_000_000_000, ..good },
    ] {
        assert_eq!(refused(data).code(), "invalid-geometry", "{data:?}");
    }
}

#[test]
fn bevel_limits() {
    let good = straight();
    let error = refused(BevelData { form_angle: Some(0.54), ..good });
    assert!(matches!(error, GeometryError::BelowBaseCone { angle_deg, base_angle_deg }
        if (angle_deg - 30.94).abs() < 0.01 && (base_angle_deg - 31.416).abs() < 0.01));
    let error = refused(BevelData { addendum_factor: 2.2, ..good });
    assert!(
        matches!(error, GeometryError::BevelToothPointed { half_angle_deg } if half_angle_deg <= 0.0),
        "{error}"
    );
    let short = Spiral { mean_angle: 0.6, form: LineForm::Circle { radius: 12.0 }, hand: Hand::Right };
    let error = refused(BevelData { spiral: Some(short), ..good });
    assert!(matches!(error, GeometryError::FlankLineOutOfReach { from, to, .. } if from < to), "{error}");

    let gear = BevelGear::new(good).unwrap();
    for angle in [0.5, 2.7, f64::NAN] {
        assert_eq!(gear.roll_angle(angle).unwrap_err().code(), "below-base-cone");
    }
    let knots = [55.0, 60.0, 65.0, 70.0];
    let line = FlankLine::Spline(CubicSpline::new(&knots, &[0.0; 4]).unwrap());
    let error = SphericalInvolute::with_line(&gear, Flank::Left, line).unwrap_err();
    assert_eq!(error.code(), "flank-line-out-of-reach");
}

#[test]
fn octoids_below_their_regular_branch() {
    let octoid = Octoid::new(&BevelGear::new(straight()).unwrap(), Flank::Left);
    match octoid.height_of(31.2f64.to_radians()).unwrap_err() {
        GeometryError::OctoidUndercut { angle_deg, begins_deg } => {
            assert!((angle_deg - 31.2).abs() < 1e-12 && (begins_deg - 31.2803).abs() < 5e-5);
        }
        other => panic!("{other}"),
    }
    assert!(octoid.height_of(31.29f64.to_radians()).is_ok());
    assert_eq!(octoid.height_of(3.0).unwrap_err().code(), "invalid-number");
    assert_eq!(octoid.height_of(f64::NAN).unwrap_err().code(), "invalid-number");
}

#[test]
fn helicoid_limits() {
    let gear = cylindrical_gear(&reference()["cases"]["spur"]["input"]);
    let flank = Helicoid::new(&gear, Flank::Left);
    assert_eq!(flank.length_of_roll(75.0).unwrap_err().code(), "radius-below-base-circle");
    assert_eq!(flank.check_tip(75.0).unwrap_err().code(), "radius-below-base-circle");
    assert!(
        matches!(flank.check_tip(98.0), Err(GeometryError::ToothPointed { thickness, .. }) if thickness < 0.0)
    );
    assert_eq!(Helicoid::thinned(&gear, Flank::Left, f64::NAN).unwrap_err().code(), "invalid-number");
    let thinned = Helicoid::thinned(&gear, Flank::Left, 0.2).unwrap();
    let by = thinned.base_space_half_angle() - flank.base_space_half_angle();
    assert!((by - 0.2 / 160.0).abs() < 1e-15, "{by}");
}

#[test]
fn offsets_and_blades_that_are_none() {
    let none = EaseOffAmounts::default();
    let bad = EaseOffAmounts { bias: f64::NAN, ..none };
    for error in [
        EaseOff::new(bad, [0.0, 1.0], [0.0, 1.0]).unwrap_err(),
        EaseOff::new(none, [1.0, 1.0], [0.0, 1.0]).unwrap_err(),
        EaseOff::new(none, [0.0, 1.0], [0.0, f64::INFINITY]).unwrap_err(),
        CylindricalCurve::new([1.0; 4], [f64::NAN; 4], [0.0; 4]).unwrap_err(),
    ] {
        assert_eq!(error.code(), "invalid-number");
    }
    let good = blade_data(&reference()["cases"]["blade"]["input"]);
    for data in [
        BladeData { hub_radius: [0.0, 55.0], ..good },
        BladeData { hub_radius: [40.0, f64::NAN], ..good },
        BladeData { tip_radius: 50.0, ..good },
        BladeData { length: 0.0, ..good },
        BladeData { hub_azimuth: [0.0, f64::INFINITY], ..good },
        BladeData { tip_lead: [f64::NAN, 0.0], ..good },
    ] {
        assert_eq!(RuledBlade::of_data(&data).unwrap_err().code(), "invalid-number", "{data:?}");
    }
    let curve = |from: f64| {
        let knots = [0.0, 1.0, 2.0, 3.0].map(|u| u + from);
        let points = knots.map(|u| Vector3::new(u, u * u, 0.0));
        Arc::new(SplineCurve::new(&knots, &points).unwrap())
    };
    let error = RuledBlade::new(curve(0.0), curve(5.0), NormalSide::Along).unwrap_err();
    assert_eq!(error.code(), "invalid-geometry");
    assert!(SplineCurve::new(&[0.0, 1.0], &[Vector3::zeros(); 2]).is_err());
}

fn grid(rows: usize, columns: usize) -> Vec<Vec<Vector3<f64>>> {
    (0..rows)
        .map(|i| (0..columns).map(|j| Vector3::new(j as f64, i as f64, 0.1 * (i * j) as f64)).collect())
        .collect()
}

#[test]
fn grids_that_are_no_surface() {
    let build = |rows: &[Vec<Vector3<f64>>]| GridSurface::new(rows, NormalSide::Along);
    assert!(build(&grid(4, 4)).is_ok());
    assert_eq!(build(&grid(3, 9)).unwrap_err(), GeometryError::GridSize { rows: 3, columns: 9 });
    assert_eq!(build(&grid(9, 3)).unwrap_err(), GeometryError::GridSize { rows: 9, columns: 3 });
    assert_eq!(build(&[]).unwrap_err(), GeometryError::GridSize { rows: 0, columns: 0 });

    let mut ragged = grid(5, 6);
    ragged[2].pop();
    assert_eq!(build(&ragged).unwrap_err(), GeometryError::GridRagged { row: 2, expected: 6, found: 5 });
    let mut lost = grid(5, 6);
    lost[3][1].z = f64::NAN;
    assert_eq!(build(&lost).unwrap_err(), GeometryError::GridNotFinite { row: 3, column: 1 });
    let mut double = grid(5, 6);
    double[2][4] = double[2][3];
    assert_eq!(build(&double).unwrap_err(), GeometryError::GridDuplicate { row: 2, column: 4 });
    let mut pole = grid(5, 6);
    let end = pole[0][0];
    pole[0].fill(end);
    assert_eq!(build(&pole).unwrap_err(), GeometryError::GridDuplicate { row: 0, column: 1 });
    let mut twice = grid(5, 6);
    twice[4] = twice[3].clone();
    assert_eq!(build(&twice).unwrap_err(), GeometryError::GridDuplicate { row: 4, column: 0 });
    let line: Vec<Vec<Vector3<f64>>> =
        (0..5).map(|i| (0..5).map(|j| Vector3::new((i * 10 + j) as f64, 0.0, 0.0)).collect()).collect();
    assert!(matches!(build(&line).unwrap_err(), GeometryError::GridFolded { .. }));
    let mut folded = grid(5, 6);
    folded[2].reverse();
    assert!(matches!(build(&folded).unwrap_err(), GeometryError::GridFolded { .. }));
    let mut far = grid(4, 4);
    far[3][3].x = 1e300;
    assert!(build(&far).is_err());
}
