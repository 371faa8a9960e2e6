//! Scenes of measuring skiving tools.

use super::checks::{body, check, examples, in_body, job, off_mesh, vertices};
use flankwright::exchange::SkivingJob;
use flankwright::numerics::Silent;
use flankwright::workflow::scene::scene_of_skiving;
use flankwright::workflow::skiving::run_skiving;
use nalgebra::Vector3;

#[test]
fn every_example_of_measuring_a_skiving_tool_has_a_scene() {
    for path in examples("skiving") {
        let Some(loaded) = job(&path).of::<SkivingJob>().cloned() else { panic!("{}", path.display()) };
        let outcome = run_skiving(&loaded, &Silent).unwrap_or_else(|_| panic!("{}", path.display()));
        let scene = scene_of_skiving(&outcome).unwrap_or_else(|e| panic!("{}: {e:?}", path.display()));
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        check(&name, &scene);
        let tool = body(&scene, "tool");
        let at_tool = vertices(tool);
        for stage in &scene.stages {
            let name = format!("{name}, {}", stage.id);
            let beam = match &outcome.scan {
                Some(scan) if stage.id.starts_with("scanning") => scan.stylus,
                _ => outcome.prepared.bodies.beam,
            };
            for frame in &stage.frames {
                let [contact] = frame.contact[..] else { panic!("{name}: one contact in every frame") };
                let from = Vector3::from(contact.map(f64::from)) - beam.point;
                let off = (from - beam.unit() * from.dot(&beam.unit())).norm() - beam.radius;
                assert!(off.abs() < 1e-4, "{name}: {off} off the beam at {}", frame.at);
                let off = off_mesh(tool, &at_tool, &in_body(frame, "tool", &contact));
                assert!(off < 0.02, "{name}: {off} off the edge at {}", frame.at);
            }
        }
    }
}
