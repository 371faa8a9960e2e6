//! Beams in any direction, lying ones too: what makes a pose right is looked at in the machine, and whether it is the best one by trying
//! all swivels of the tool.

use super::samples::{CROWNED, RING, STEPPED, Sample};
use foundation::geometry::Flank;
use nalgebra::Vector3;
use skiving::measuring::{
    Barrier, Beam, MeasuringPose, PoseKind, RealTool, measuring_poses, nearest_clamped,
};
use skiving::{MeasuringTrack, SkivingError};

/// Directions all around, none of them along X, where no turn of A brings the flank.
fn directions() -> Vec<Vector3<f64>> {
    let around = |k: usize| {
        let angle = 0.61 * k as f64;
        Vector3::new(0.35 * (1.7 * angle).sin(), angle.sin(), angle.cos())
    };
    (0..24).map(around).chain([Vector3::y(), -Vector3::y(), -Vector3::z()]).collect()
}

fn tracks(sample: &Sample) -> Vec<(Flank, MeasuringTrack)> {
    let edges = sample.edges();
    let of = |flank: Flank| [-0.7, 0.4].map(|x| (flank, MeasuringTrack::new(&edges[flank], x).unwrap()));
    Flank::BOTH.into_iter().flat_map(of).collect()
}

fn in_machine(pose: &MeasuringPose, v: &Vector3<f64>) -> Vector3<f64> {
    pose.to_machine(pose.turn, v) - pose.position
}

#[test]
fn the_beam_touches_where_it_should() {
    for sample in [RING, STEPPED, CROWNED] {
        let edges = sample.edges();
        let ideal = RealTool::ideal(sample.teeth[0].unsigned_abs() as usize);
        for direction in directions() {
            let point = Vector3::new(300.0, 20.0, 150.0);
            let beam = Beam::along(point, direction * 7.0, 0.05).unwrap();
            for (number, (flank, track)) in tracks(&sample).iter().enumerate() {
                let poses = measuring_poses(track, &beam, PoseKind::AlongFlank, (*flank, number)).unwrap();
                let also = measuring_poses(track, &beam, PoseKind::Tangent, (*flank, number));
                for pose in poses.iter().chain(also.iter().flatten()) {
                    let (l, contact) = (beam.unit(), &track.contact);
                    let normal = in_machine(pose, &contact.normal);
                    assert!(l.dot(&normal).abs() < 1e-12, "{direction}");
                    let touch = pose.to_machine(pose.turn, &contact.point);
                    // The contact lies in the plane across the beam through its point, the beam's radius beside its axis.
                    assert!((touch - point).dot(&l).abs() < 1e-10, "{direction}");
                    let axis = touch + normal * beam.radius;
                    assert!((axis - point).cross(&l).norm() < 1e-10, "{direction}");
                    let barrier = Barrier { beam: &beam, pose };
                    match barrier.touch(&edges[*flank], &ideal, track, 0, beam.radius) {
                        Ok(found) => {
                            assert!((contact.lever * (found.turn - pose.turn)).abs() < 1e-9, "{direction}");
                        }
                        // Far off the flank's direction the beam crosses the edge: its end is touched first.
                        Err(
                            SkivingError::EdgeEndTouched { .. }
                            | SkivingError::BodyTouched { .. }
                            | SkivingError::NoTrigger { .. },
                        ) => {
                            assert!(
                                pose.off_flank.to_degrees() > 15.0,
                                "{direction} {}",
                                pose.off_flank.to_degrees()
                            );
                        }
                        Err(other) => panic!("{direction}: {other}"),
                    }
                }
            }
        }
    }
}

#[test]
fn no_swivel_lays_the_beam_nearer_to_the_flank() {
    for sample in [RING, STEPPED, CROWNED] {
        for direction in directions() {
            let beam = Beam::along(Vector3::new(300.0, 20.0, 150.0), direction, 0.05).unwrap();
            for (number, (flank, track)) in tracks(&sample).iter().enumerate() {
                let poses = measuring_poses(track, &beam, PoseKind::AlongFlank, (*flank, number)).unwrap();
                let best = poses.iter().map(|pose| pose.off_flank).fold(f64::INFINITY, f64::min);
                // Every quarter of a degree of A, the tool turned so that the beam is tangential: no better, and at the best nearly as good.
                let tried = (0..1440)
                    .filter_map(|k| nearest_clamped(track, &beam, (0.25 * f64::from(k)).to_radians()))
                    .map(|pose| pose.off_flank)
                    .fold(f64::INFINITY, f64::min);
                assert!(best <= tried + 1e-9, "{direction}: {best} {tried}");
                assert!(tried - best < 1f64.to_radians(), "{direction}: {best} {tried}");
            }
        }
    }
}

/// Upright, a direction means what no tilt means; and a beam of no direction is refused.
#[test]
fn a_direction_means_what_tilts_mean() {
    let point = Vector3::new(300.0, 20.0, 150.0);
    let upright = Beam::new(point, [0.0; 2], 0.05).unwrap();
    let along = Beam::along(point, Vector3::new(0.0, 0.0, 3.0), 0.05).unwrap();
    for (number, (flank, track)) in tracks(&STEPPED).iter().enumerate() {
        let [a, b] = [&upright, &along]
            .map(|beam| measuring_poses(track, beam, PoseKind::Tangent, (*flank, number)).unwrap()[0]);
        assert_eq!(a, b);
    }
    for direction in [Vector3::zeros(), Vector3::new(f64::NAN, 0.0, 1.0)] {
        assert_eq!(Beam::along(point, direction, 0.05).unwrap_err().code(), "invalid-number");
    }
}
