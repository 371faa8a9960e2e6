//! Scenes of tangential dressing.

use super::bodies::{Extent, holds_its_volume, on_flanks};
use super::checks::{body, check, examples, in_body, job, off_mesh, vertices};
use flankwright::exchange::TangentialJob;
use flankwright::geometry::{Flank, Gear};
use flankwright::numerics::Silent;
use flankwright::workflow::scene::scene_of_tangential;
use flankwright::workflow::tangential::{plan_tangential, simulate_tangential};
use nalgebra::Vector3;

fn off(gear: &Gear, point: &Vector3<f64>) -> f64 {
    Flank::BOTH
        .map(|flank| gear.flank(flank).deviation(point).f_n.abs())
        .into_iter()
        .fold(f64::INFINITY, f64::min)
}

#[test]
fn every_example_of_tangential_dressing_has_a_scene() {
    for path in examples("tangential") {
        let Some(loaded) = job(&path).of::<TangentialJob>().cloned() else { panic!("{}", path.display()) };
        let outcome = match loaded.job.settings {
            Some(_) => simulate_tangential(&loaded, &Silent),
            None => plan_tangential(&loaded, &Silent),
        };
        let outcome = outcome.unwrap_or_else(|e| panic!("{}: {e:?}", path.display()));
        let scene = scene_of_tangential(&outcome).unwrap_or_else(|e| panic!("{}: {e:?}", path.display()));
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        check(&name, &scene);
        let ready = &outcome.prepared;
        let (gear, worm) = (&ready.model.pair.work, &ready.model.pair.worm);
        let half = 0.5 * ready.blank.face_width;
        let extent = Extent {
            tip: 0.5 * ready.blank.tip_diameter,
            root: 0.5 * ready.blank.root_diameter,
            form: 0.5 * ready.blank.form_diameter,
            faces: [-half, half],
        };
        on_flanks(&name, body(&scene, "gear"), gear, &extent);
        holds_its_volume(&name, body(&scene, "gear"), gear, &extent);
        let disc = body(&scene, "dresser");
        let at_disc = vertices(disc);
        for stage in &scene.stages {
            let name = format!("{name}, {}", stage.id);
            let touching = stage.frames.iter().filter(|frame| !frame.contact.is_empty()).count();
            assert!(2 * touching > stage.frames.len(), "{name}: {touching} of {}", stage.frames.len());
            for (number, frame) in stage.frames.iter().enumerate() {
                for contact in &frame.contact {
                    // Corrections of some tenths of a millimetre are no error.
                    let off_worm = off(worm, &in_body(frame, "worm", contact));
                    assert!(off_worm < 0.3, "{name}: {off_worm} off the worm");
                    if stage.id.starts_with("grinding") {
                        let off_gear = off(gear, &in_body(frame, "gear", contact));
                        let largest = outcome.flanks.iter().filter_map(|(_, run)| run.as_ref());
                        let largest = largest.map(|run| run.planned.largest()).fold(0.0, f64::max);
                        assert!(off_gear < largest + 5e-3, "{name}: {off_gear} off the gear");
                    } else if number % 20 == 0 {
                        let off_disc = off_mesh(disc, &at_disc, &in_body(frame, "dresser", contact));
                        assert!(off_disc < 0.03, "{name}: {off_disc} off the dresser's mesh");
                    }
                }
            }
        }
    }
}
