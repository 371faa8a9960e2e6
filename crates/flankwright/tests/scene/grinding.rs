//! Scenes of generating grinding.

use super::bodies::{Extent, holds_its_volume, on_flanks};
use super::checks::{body, check, examples, in_body, job, off_mesh, vertices};
use flankwright::exchange::Job;
use flankwright::geometry::{Flank, Gear};
use flankwright::numerics::Silent;
use flankwright::process::dressing::DressedWorm;
use flankwright::workflow::scene::{Body, Frame, Scene, scene_of_grinding};
use flankwright::workflow::{Outcome, plan_job, simulate_job};
use nalgebra::Vector3;
use std::path::Path;
use std::time::Instant;

/// A contact may stand off the flank of its formula by what f32 leaves of it, mm; off facets by what they cut.
const ROUNDING: f64 = 1e-4;
const FACETS: f64 = 0.03;

/// The run of a job that takes one worm.
fn run(path: &Path) -> Option<Outcome> {
    let loaded = job(path).of::<Job>().cloned()?;
    if loaded.job.catalogue.is_some() {
        return None;
    }
    let outcome = match loaded.job.settings {
        Some(_) => simulate_job(&loaded, &Silent),
        None => plan_job(&loaded, &Silent),
    };
    Some(outcome.unwrap_or_else(|e| panic!("{}: {e:?}", path.display())))
}

fn worm_extent(scene: &Scene, outcome: &Outcome) -> Extent {
    let setup = &outcome.prepared.setup;
    let z = || vertices(body(scene, "worm")).into_iter().map(|p| p.z);
    let faces = [z().fold(f64::INFINITY, f64::min), z().fold(f64::NEG_INFINITY, f64::max)];
    Extent { tip: setup.worm_tip_radius, root: setup.worm_root_radius, form: setup.worm_root_radius, faces }
}

fn gear_extent(outcome: &Outcome) -> Extent {
    let blank = outcome.prepared.setup.input.blank;
    let half = 0.5 * blank.face_width;
    Extent {
        tip: 0.5 * blank.tip_diameter,
        root: 0.5 * blank.root_diameter,
        form: 0.5 * blank.form_diameter,
        faces: [-half, half],
    }
}

/// The flank nearest to a point, with its deviation.
fn nearest(gear: &Gear, point: &Vector3<f64>) -> (Flank, f64, [f64; 2]) {
    Flank::BOTH
        .map(|flank| {
            let at = gear.flank(flank).deviation(point);
            (flank, at.f_n, [at.w, at.z])
        })
        .into_iter()
        .min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))
        .unwrap()
}

/// Largest |f| planned on a flank, mm.
fn planned(outcome: &Outcome, flank: Flank) -> f64 {
    outcome.execution.flanks[flank].as_ref().map_or(0.0, |f| f.planned.largest())
}

/// The worm of a flank as it is dressed; none of a tool that is not, or in strokes.
fn dressed(outcome: &Outcome, flank: Flank) -> Option<DressedWorm> {
    let dressing = outcome.execution.flanks[flank].as_ref()?.dressing()?;
    Some(DressedWorm::new(outcome.execution.dresser.as_ref()?, flank, &dressing.corrections))
}

/// A point in coordinates of the worm lies on the flank that the dresser leaves.
fn on_worm(name: &str, outcome: &Outcome, point: &Vector3<f64>) -> bool {
    let (flank, off, [w, z]) = nearest(&outcome.prepared.setup.pair.worm, point);
    assert!(off.abs() < 0.5, "{name}: {off} off the worm");
    let found = dressed(outcome, flank).and_then(|worm| worm.modification(w, z));
    if let Some((f, ..)) = found {
        assert!((off - f).abs() < ROUNDING, "{name}: {off} off the worm, dressed to {f}");
    }
    found.is_some()
}

fn check_grinding(name: &str, outcome: &Outcome, frames: &[Frame]) {
    let pair = &outcome.prepared.setup.pair;
    let (mut seen, mut exact) = (0, 0);
    for frame in frames {
        for contact in &frame.contact {
            let (flank, off, _) = nearest(&pair.work, &in_body(frame, "gear", contact));
            let allowed = planned(outcome, flank) + 2e-3;
            assert!(off.abs() < allowed, "{name}: {off} off the gear at {}", frame.at);
            exact += usize::from(on_worm(name, outcome, &in_body(frame, "worm", contact)));
            seen += 1;
        }
        for point in frame.trace.iter().flatten() {
            let (_, off, [_, z]) = nearest(&pair.work, &in_body(frame, "gear", point));
            assert!(off.abs() < ROUNDING, "{name}: {off} off the gear");
            assert!(z.abs() < 0.5 * outcome.prepared.setup.input.blank.face_width + ROUNDING, "{name}: {z}");
        }
    }
    let touching = frames.iter().filter(|frame| !frame.contact.is_empty()).count();
    assert!(2 * touching > frames.len(), "{name}: contact in {touching} of {} frames only", frames.len());
    let is_dressed = Flank::BOTH.iter().any(|&flank| dressed(outcome, flank).is_some());
    assert!(!is_dressed || 10 * exact > 9 * seen, "{name}: {exact} of {seen} contacts on the dressed worm");
}

fn check_dressing(name: &str, scene: &Scene, outcome: &Outcome, frames: &[Frame]) {
    let discs = scene.bodies.iter().filter(|body| body.id.starts_with("dresser"));
    let discs: Vec<_> = discs.map(|body| (body, vertices(body))).collect();
    let worm = body(scene, "worm");
    let at_worm = vertices(worm);
    let mut seen = 0;
    for frame in frames.iter().step_by(17) {
        for contact in frame.contact.iter().step_by(6) {
            let on_it = in_body(frame, "worm", contact);
            on_worm(name, outcome, &on_it);
            // The mesh is that of the worm before it is dressed.
            let (_, modified, _) = nearest(&outcome.prepared.setup.pair.worm, &on_it);
            let off = off_mesh(worm, &at_worm, &on_it) - modified.abs();
            assert!(off < FACETS, "{name}: {off} off the worm's mesh at {}", frame.at);
            // Of several dressers the one that works; the others stand aside.
            let of = |(disc, at): &(&Body, Vec<_>)| off_mesh(disc, at, &in_body(frame, &disc.id, contact));
            let off = discs.iter().map(of).fold(f64::INFINITY, f64::min);
            assert!(off < FACETS, "{name}: {off} off the dresser's mesh at {}", frame.at);
            seen += 1;
        }
    }
    assert!(seen > 3, "{name}: no contact");
}

fn check_scene(name: &str, scene: &Scene, outcome: &Outcome) {
    check(name, scene);
    let pair = &outcome.prepared.setup.pair;
    let (gear, worm) = (gear_extent(outcome), worm_extent(scene, outcome));
    for (id, of, extent) in [("gear", &pair.work, &gear), ("worm", &pair.worm, &worm)] {
        on_flanks(&format!("{name}, {id}"), body(scene, id), of, extent);
        holds_its_volume(&format!("{name}, {id}"), body(scene, id), of, extent);
    }
    for stage in &scene.stages {
        let name = format!("{name}, {}", stage.id);
        if stage.id == "grinding" {
            assert_eq!(stage.coordinate.unit, "mm");
            check_grinding(&name, outcome, &stage.frames);
        } else {
            check_dressing(&name, scene, outcome, &stage.frames);
        }
    }
}

fn check_examples(of: impl Fn(usize) -> bool) {
    let paths = examples(".");
    let chosen = paths.iter().enumerate().filter(|(k, _)| of(*k));
    let mut seen = 0;
    for (_, path) in chosen {
        let Some(outcome) = run(path) else { continue };
        let scene = scene_of_grinding(&outcome).unwrap_or_else(|e| panic!("{}: {e:?}", path.display()));
        check_scene(&path.file_stem().unwrap().to_string_lossy(), &scene, &outcome);
        seen += 1;
    }
    assert!(seen > 3, "{seen}");
}

#[test]
fn every_example_of_grinding_has_a_scene() {
    check_examples(|k| k % 2 == 0);
}

#[test]
fn the_other_examples_of_grinding_have_scenes() {
    check_examples(|k| k % 2 == 1);
}

#[test]
fn strokes_and_other_ways_of_dressing_have_scenes() {
    let names = ["strokes", "two-flanks", "conical-worm", "gear-root"];
    for path in
        examples("dressing").into_iter().filter(|p| names.iter().any(|n| p.file_stem().unwrap() == *n))
    {
        let Some(outcome) = run(&path) else { panic!("{}", path.display()) };
        let scene = scene_of_grinding(&outcome).unwrap_or_else(|e| panic!("{}: {e:?}", path.display()));
        check_scene(&path.file_stem().unwrap().to_string_lossy(), &scene, &outcome);
    }
}

#[test]
fn a_scene_has_the_same_bytes_each_time_and_is_made_at_once() {
    let path = examples(".").into_iter().find(|p| p.ends_with("twist-free-crowning.toml")).unwrap();
    let text = || {
        let outcome = run(&path).unwrap();
        let begun = Instant::now();
        let scene = scene_of_grinding(&outcome).unwrap();
        let seconds = begun.elapsed().as_secs_f64();
        assert!(seconds < 3.0, "{seconds} s");
        serde_json::to_string(&scene).unwrap()
    };
    let first = text();
    assert!(first.len() < 6_000_000, "{} bytes", first.len());
    assert!(first == text());
    assert!(
        first.starts_with(r#"{"bodies":[{"id":"gear","kind":"gear","closed":true,"positions":["#),
        "{}",
        &first[..80]
    );
}
