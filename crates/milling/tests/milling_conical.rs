//! Involute gears with a cone angle: the flank by the rack that generates it, where it begins and ends, and what the cutter keeps from.

use foundation::geometry::Flank;
use foundation::numerics::Silent;
use job::{Source, parse_job_of};
use milling::job::MillingJob;
use milling::workflow::{prepare_milling, run_milling};
use nalgebra::{Rotation3, Vector3};
use run::RunFailure;
use std::f64::consts::PI;

fn text() -> String {
    let path = format!("{}/../../examples/milling/beveloid.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).unwrap()
}

fn job(text: &str) -> job::Loaded<MillingJob> {
    parse_job_of::<MillingJob>(Source::new("job.toml", text)).unwrap_or_else(|error| panic!("{error}"))
}

/// The gear rolls on a rack whose flanks are planes: its datum plane leans by the cone angle. Every point of a flank lies on the plane of
/// the rack in the one turn in which the plane's normal there is that of the flank.
#[test]
fn flanks_are_those_that_a_leaning_rack_generates() {
    let all = text();
    let nominal = all.lines().filter(|line| !line.starts_with("modifications"));
    let loaded = job(&nominal.map(|line| line.to_owned() + "\n").collect::<String>());
    let drawing = &loaded.job.gear.as_ref().unwrap().drawing;
    let (teeth, module) = (f64::from(drawing.teeth), drawing.normal_module);
    let (beta, theta) = (drawing.helix_angle_deg.to_radians(), drawing.cone_angle_deg.to_radians());
    let alpha = 20f64.to_radians();
    let shift = drawing.profile_shift.unwrap();
    let radius = 0.5 * teeth * module / beta.cos();
    let bodies = prepare_milling(&loaded).unwrap().bodies;
    let space = &bodies.parts[0];
    for flank in &space.flanks {
        let s = if flank.side == Flank::Left { 1.0 } else { -1.0 };
        // In the datum plane: the direction of the rack's teeth, leaning with the cone and turned by the helix; across them in the
        // plane; out of the plane, away from the gear's axis.
        let lean = Rotation3::from_axis_angle(&Vector3::x_axis(), theta);
        let (along, across) = (
            lean * Vector3::new(-beta.sin(), 0.0, beta.cos()),
            lean * Vector3::new(beta.cos(), 0.0, beta.sin()),
        );
        let out = lean * Vector3::y();
        assert!(along.cross(&across).dot(&out).abs() > 1.0 - 1e-12);
        // Half a tooth of the rack stands in the space at the datum plane, which lies x m_n outside of the pitch plane.
        let half = 0.25 * PI * module;
        let datum = Vector3::y() * (radius + shift * module);
        // Normal of the rack's flank, out of the material of the gear: the left flank of the space lies towards +x.
        let normal = (out * alpha.sin() - across * (s * alpha.cos())).normalize();
        let mut worst = 0.0f64;
        for height in [0.0, 0.3, 0.7, 1.0] {
            for z in [-9.0, 0.0, 9.0] {
                let jet = flank.active.surface.jet(height, z);
                // The turn in which the normal is that of the rack, by its part in the transverse plane.
                let azimuth = |v: &Vector3<f64>| v.y.atan2(v.x);
                let turn = azimuth(&normal) - azimuth(&jet.normal);
                let turn = turn - 2.0 * PI * (turn / (2.0 * PI)).round();
                let back = Rotation3::from_axis_angle(&Vector3::z_axis(), turn);
                assert!((back * jet.normal - normal).norm() < 1e-12, "{}: the same lean", flank.side);
                // While the gear turns the rack goes with its pitch plane.
                let moved = -radius * turn;
                let on_rack = datum + Vector3::x() * moved + across * (s * half);
                let off = (back * jet.point - on_rack).dot(&normal);
                worst = worst.max(off.abs());
            }
        }
        assert!(worst < 1e-9, "{}: {worst}", flank.side);
    }
}

#[test]
fn a_conical_gear_is_milled_between_its_cones() {
    let loaded = job(&text());
    let drawing = loaded.job.gear.as_ref().unwrap().drawing.clone();
    let outcome = match run_milling(&loaded, &Silent) {
        Ok(outcome) => outcome,
        Err(RunFailure::BadInput(finding) | RunFailure::NotProducible(finding)) => panic!("{finding:?}"),
    };
    assert!(outcome.result.verdict.is_accepted(), "{:?}", outcome.result.verdict.reason());
    assert_eq!(outcome.flanks.len(), 2);
    let slope = -drawing.cone_angle_deg.to_radians().tan();
    for flank in &outcome.plan.flanks {
        for z in [-10.0, -2.0, 10.0] {
            for (height, diameter) in [(0.0, drawing.root_form_diameter()), (1.0, drawing.tip_diameter)] {
                let radius = flank.active.surface.point(height, z).xy().norm();
                // The crowning moves them by some micrometres.
                assert!((radius - 0.5 * diameter - slope * z).abs() < 0.01);
            }
        }
    }
    for flank in &outcome.flanks {
        let measured = flank.simulated.iter().filter(|length| length.is_some()).count();
        assert_eq!(measured, flank.heights.len() * flank.lengths.len());
    }
}

#[test]
fn cones_that_make_no_gear_are_refused_at_their_keys() {
    let refused = |from: &str, to: &str| {
        let text = text();
        assert!(text.contains(from));
        match prepare_milling(&job(&text.replace(from, to))) {
            Err(RunFailure::BadInput(finding)) => (finding.code, finding.field.unwrap_or_default()),
            Err(RunFailure::NotProducible(finding)) => panic!("{finding:?}"),
            Ok(_) => panic!("{to} is taken"),
        }
    };
    let (code, field) = refused("form_diameter = 79.0", "form_diameter = 77.0");
    assert!(code.contains("base") && field.starts_with("gear"), "{code} {field}");
}
