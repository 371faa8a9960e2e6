//! Contact points and predicted flanks against balls that roll through the space.

use super::samples::{CROWNED, RING, STEPPED, Sample};
use foundation::geometry::{Flank, RakeChange, SkivingTool, SphericalRake, VariableRake};
use foundation::kinematics::SkivingMotion;
use nalgebra::Vector3;
use referee::{SkivedPlace, Skiving};
use skiving::measuring::{EdgeErrors, RealTool, first_order_deviation};
use skiving::{
    Kinematics, MeasuringTrack, PairData, SkivingPair, VirtualEdge, default_track_places, setting_sensitivity,
};
use std::sync::Arc;

/// The edge passes the space within this turn of the tool to both sides, rad.
const PASSING: f64 = 0.22;

fn skived(
    edge: &VirtualEdge,
    motion: &SkivingMotion,
    errors: &EdgeErrors,
    lengths: &[f64],
) -> Vec<SkivedPlace> {
    let radius = edge.pair().tool().rounding().radius;
    let ball = |w: f64| {
        let x = edge.flank().edge_coordinate(w);
        let section = edge.section(w);
        let normal = Vector3::from_fn(|k, _| edge.piece(w).normal[k].value(w));
        let (profile, growth) = (errors.profile_at(x), errors.growth_at(x));
        (section.centre + normal * profile - section.growth() * growth, radius + growth)
    };
    let skiving = Skiving {
        law: None,
        flank: edge.flank().helicoid().flank(),
        motion,
        edge: &ball,
        places: edge.flank().range(),
        tool_angles: [motion.tool_angle - PASSING, motion.tool_angle + PASSING],
    };
    skiving.profile(lengths).unwrap().into_iter().map(Option::unwrap).collect()
}

fn tracks(edge: &VirtualEdge) -> Vec<MeasuringTrack> {
    default_track_places().into_iter().map(|x| MeasuringTrack::new(edge, x).unwrap()).collect()
}

fn lengths(tracks: &[MeasuringTrack]) -> Vec<f64> {
    tracks.iter().map(|track| track.contact.w).collect()
}

/// A flat minimum tells its place by the root of what it tells its value by.
fn agree(edge: &VirtualEdge, um: f64) {
    let tracks = tracks(edge);
    let found = skived(edge, edge.pair().motion(), &EdgeErrors::default(), &lengths(&tracks));
    for (track, found) in tracks.iter().zip(found) {
        let contact = &track.contact;
        assert!((found.left - contact.modification).abs() < 1e-3 * um, "{found:?} {contact:?}");
        assert!((found.place - contact.w).abs() < 2e-5, "{found:?} {contact:?}");
        assert!((found.tool_angle - contact.tool_angle).abs() < 1e-6, "{found:?} {contact:?}");
    }
}

#[test]
fn edges_make_their_flanks() {
    // A crowned flank leans against its helicoid by 8 um over 4 mm; the circle of a ball there is right to the second order only.
    for (sample, um) in [(RING, 1e-8), (STEPPED, 1e-8), (CROWNED, 3e-5)] {
        for (_, edge) in sample.edges().iter() {
            agree(edge, um);
        }
    }
}

#[test]
fn any_rake_face_will_do() {
    let sample = Sample { rounding: [0.02, 8.0, 0.0, 0.0, 0.0], ..STEPPED };
    let hollow = |radius: f64| -> Arc<dyn foundation::geometry::RakeFace> {
        Arc::new(SphericalRake::new(8f64.to_radians(), radius))
    };
    let tool = foundation::geometry::SkivingTool::new(
        75,
        sample.helix[0].to_radians(),
        sample.module,
        hollow,
        sample.rounding(),
    );
    let pair = SkivingPair::new(tool.unwrap(), sample.gear(), sample.setting()).unwrap();
    for flank in Flank::BOTH {
        agree(&VirtualEdge::new(&pair, sample.flank(&pair, flank)).unwrap(), 1e-8);
    }
}

/// Rake faces whose angle changes over the tooth, each way alone and all together.
#[test]
fn rake_faces_that_change_make_the_flank() {
    let changes = [
        RakeChange { by_height: [0.03, 0.0], ..RakeChange::default() },
        RakeChange { by_height: [0.0, 0.01], ..RakeChange::default() },
        RakeChange { hollow: 0.06, ..RakeChange::default() },
        RakeChange { twist: -0.04, ..RakeChange::default() },
        RakeChange { by_height: [0.02, -0.005], hollow: 0.05, twist: 0.02 },
    ];
    for sample in [RING, STEPPED] {
        let plane: Vec<VirtualEdge> = sample.edges().iter().map(|(_, edge)| edge.clone()).collect();
        for change in changes {
            let (rake, step) = (sample.rake.to_radians(), sample.step.to_radians());
            let face = |radius: f64| -> Arc<dyn foundation::geometry::RakeFace> {
                Arc::new(VariableRake::new(rake, step, change, radius))
            };
            let (teeth, helix) = (sample.teeth[0].unsigned_abs(), sample.helix[0].to_radians());
            let tool = SkivingTool::new(teeth, helix, sample.module, face, sample.rounding()).unwrap();
            let pair = SkivingPair::new(tool, sample.gear(), sample.setting()).unwrap();
            for (flank, plane) in Flank::BOTH.into_iter().zip(&plane) {
                let edge = VirtualEdge::new(&pair, sample.flank(&pair, flank)).unwrap();
                agree(&edge, 1e-8);
                // Not the edge of the plane.
                let at = |edge: &VirtualEdge| tracks(edge)[0].contact.point;
                assert!((at(&edge) - at(plane)).norm() > 1e-3);
            }
        }
    }
}

/// Shaping cutters: an internal helical one that is ground in steps, an external spur one with a cone, an external helical one.
fn shaping() -> [Sample; 3] {
    let ring = Sample { helix: [15.0, 15.0], step: 15.0, radii: [86.3, 90.0], tool_shift: 0.4, ..RING };
    let spur = Sample {
        teeth: [25, 34],
        module: 3.0,
        helix: [0.0, 0.0],
        cone: true,
        radii: [48.8, 53.0],
        rounding: [0.03, 6.0, 0.0, 0.0, 0.0],
        ..RING
    };
    let helical = Sample { helix: [-20.0, 20.0], step: -20.0, cone: false, radii: [52.4, 56.0], ..spur };
    [ring, spur, helical]
}

fn shaped(sample: &Sample) -> Vec<VirtualEdge> {
    let setting = PairData { kinematics: Kinematics::Shaping, ..sample.setting() };
    let pair = SkivingPair::new(sample.tool(), sample.gear(), setting).unwrap();
    Flank::BOTH.map(|flank| VirtualEdge::new(&pair, sample.flank(&pair, flank)).unwrap()).into()
}

/// The referee knows of no stroke: balls that roll on parallel axes leave the flank, and touch it where planning says.
#[test]
fn shaping_cutters_make_their_flanks() {
    for sample in shaping() {
        for edge in shaped(&sample) {
            agree(&edge, 1e-8);
            assert_eq!(edge.cutting_direction(), 1.0);
            // The lever of an unmodified flank: -i21 s_F r_b cos(beta_b), the same all over the edge.
            let flank = edge.flank().helicoid().flank();
            let side = if edge.side() == Flank::Left { 1.0 } else { -1.0 };
            let lever = -edge.pair().motion().ratio * side * flank.base_radius * flank.base_helix_angle.cos();
            for track in tracks(&edge) {
                assert!((track.contact.lever - lever).abs() < 1e-9, "{} {lever}", track.contact.lever);
            }
        }
    }
}

#[test]
fn worn_shaping_cutters_and_their_settings_leave_what_is_predicted() {
    let errors = EdgeErrors { profile: vec![0.004, -0.003, 0.002], growth: vec![0.008, 0.002] };
    for sample in shaping() {
        for edge in shaped(&sample) {
            let tracks = tracks(&edge);
            let motion = *edge.pair().motion();
            let mut tool = RealTool::ideal(edge.pair().tool().teeth() as usize);
            tool.edges[edge.side()][0] = errors.clone();
            let worn = skived(&edge, &motion, &errors, &lengths(&tracks));
            for (track, found) in tracks.iter().zip(&worn) {
                let predicted = -first_order_deviation(&edge, &tool, track, 0);
                assert!((found.left - predicted).abs() < 5e-5, "{}: {found:?} {predicted}", track.place);
            }
            for (k, step) in [(0, 0.005), (2, 0.02), (3, 1e-4)] {
                let mut other = motion;
                match k {
                    0 => other.centre_distance += step,
                    2 => other.tool_shift += step,
                    _ => other.work_angle -= other.ratio * step,
                }
                let changed = skived(&edge, &other, &EdgeErrors::default(), &lengths(&tracks));
                for (track, after) in tracks.iter().zip(&changed) {
                    let predicted = setting_sensitivity(&motion, &track.contact)[k] * step;
                    assert!((after.left - predicted).abs() < 1e-5, "{k}: {after:?} {predicted}");
                }
            }
        }
    }
}

/// What a measured tool leaves is predicted to the first order; so is what a changed setting does
/// (`docs/mathematics/skiving.md#how-it-is-verified`).
#[test]
fn worn_edges_and_changed_settings_leave_what_is_predicted() {
    let errors = EdgeErrors { profile: vec![0.004, -0.003, 0.002], growth: vec![0.008, 0.002] };
    for sample in [RING, STEPPED] {
        for (flank, edge) in sample.edges().iter() {
            let tracks = tracks(edge);
            let mut tool = RealTool::ideal(edge.pair().tool().teeth() as usize);
            tool.edges[flank][0] = errors.clone();
            let nominal = skived(edge, edge.pair().motion(), &EdgeErrors::default(), &lengths(&tracks));
            let worn = skived(edge, edge.pair().motion(), &errors, &lengths(&tracks));
            for (track, found) in tracks.iter().zip(&worn) {
                let predicted = -first_order_deviation(edge, &tool, track, 0);
                assert!(
                    (found.left - predicted).abs() < 3e-5,
                    "{flank} {}: {found:?} {predicted}",
                    track.place
                );
            }
            let motion = *edge.pair().motion();
            for (k, step) in [0.005, 2e-4, 0.02, 1e-4].into_iter().enumerate() {
                let mut other = motion;
                match k {
                    0 => other.centre_distance += step,
                    1 => other.crossed_axes_angle += step,
                    2 => other.tool_shift += step,
                    // The coupling stays where it was: the workpiece stands at phi_20 when the tool is turned further.
                    _ => other.work_angle -= other.ratio * step,
                }
                let changed = skived(edge, &other, &EdgeErrors::default(), &lengths(&tracks));
                for ((track, before), after) in tracks.iter().zip(&nominal).zip(&changed) {
                    let predicted = setting_sensitivity(&motion, &track.contact)[k] * step;
                    let found = after.left - before.left;
                    assert!(
                        (found - predicted).abs() < 2e-5,
                        "{flank} {k} {}: {found} {predicted}",
                        track.place
                    );
                }
            }
        }
    }
}
