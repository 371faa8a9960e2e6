//! Scenes of five-axis milling.

use super::checks::{check, examples, in_body, job, off_mesh, vertices};
use flankwright::exchange::MillingJob;
use flankwright::numerics::Silent;
use flankwright::workflow::milling::run_milling;
use flankwright::workflow::scene::scene_of_milling;
use nalgebra::Vector3;

/// How far a flank of a dozen points over the height stands off the surface through them, mm.
const FACETS: f64 = 0.1;

#[test]
fn every_example_of_milling_has_a_scene() {
    for path in examples("milling") {
        let Some(loaded) = job(&path).of::<MillingJob>().cloned() else { panic!("{}", path.display()) };
        let outcome = run_milling(&loaded, &Silent).unwrap_or_else(|e| panic!("{}: {e:?}", path.display()));
        let scene = scene_of_milling(&outcome).unwrap_or_else(|e| panic!("{}: {e:?}", path.display()));
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        check(&name, &scene);
        let part = &scene.bodies[0];
        assert_eq!(part.closed, part.id == "gear", "{name}");
        let at_part = vertices(part);
        let cutter = &outcome.prepared.bodies.options.cutter;
        let mut seen = 0;
        for stage in &scene.stages {
            let name = format!("{name}, {}", stage.id);
            for (number, frame) in stage.frames.iter().enumerate() {
                for contact in &frame.contact {
                    let on_tool = in_body(frame, "cutter", contact);
                    let off = cutter.distance(on_tool.xy().norm(), on_tool.z);
                    assert!(off.abs() < 1e-3, "{name}: {off} off the cutter");
                    if number % 9 == 0 {
                        let off = off_mesh(part, &at_part, &in_body(frame, &part.id, contact));
                        assert!(off < FACETS, "{name}: {off} off the part");
                    }
                    seen += 1;
                }
            }
        }
        assert!(seen > 20, "{name}: {seen} contacts");
        // The waiting cutters stand outside.
        let reach = at_part.iter().map(Vector3::norm).fold(0.0, f64::max);
        for stage in &scene.stages {
            let tips =
                stage.frames[0].poses.values().filter(|p| Vector3::new(p[9], p[10], p[11]).norm() > reach);
            assert!(tips.count() + 1 >= scene.bodies.len() - 1, "{name}, {}", stage.id);
        }
    }
}
