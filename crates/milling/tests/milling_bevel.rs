//! Bevel gears beyond the usual ones: crown gears, whose pitch cone is a plane, and double-helical ones, from a job to the rays and the mesh.

use foundation::geometry::Flank;
use foundation::numerics::Silent;
use job::{Source, parse_job_of};
use milling::job::LoadedMillingJob;
use milling::workflow::part_mesh::{Fineness, part_with};
use milling::workflow::{MillingOutcome, prepare_milling, run_milling};
use milling::{CutterPlace, Half, OperationKind, Retraction, retracted};
use nalgebra::Vector3;
use run::RunFailure;

fn text(example: &str) -> String {
    let path = format!("{}/../../examples/milling/{example}.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).unwrap()
}

fn job(text: &str) -> LoadedMillingJob {
    // Machines are looked for beside the job.
    let name = format!("{}/../../examples/milling/job.toml", env!("CARGO_MANIFEST_DIR"));
    parse_job_of(Source::new(&*name, text)).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn changed(example: &str, changes: &[(&str, &str)]) -> LoadedMillingJob {
    let mut all = text(example);
    for (from, to) in changes {
        assert!(all.contains(from), "{from}");
        all = all.replacen(from, to, 1);
    }
    job(&all)
}

fn run(job: &LoadedMillingJob) -> MillingOutcome {
    run_milling(job, &Silent).unwrap_or_else(|failure| panic!("{failure:?}"))
}

/// Largest deviations of rays and of rays from their prediction, um.
fn worst(outcome: &MillingOutcome) -> [f64; 2] {
    let of = outcome.result.flanks.values().map(|flank| [flank.max_deviation_um, flank.model_difference_um]);
    of.fold([0.0; 2], |[a, b], [x, y]| [a.max(x), b.max(y)])
}

/// Rays and programs that are enough for a test.
const FEW: [(&str, &str); 4] = [
    ("rays_profile = 81", "rays_profile = 21"),
    ("rays_length = 31", "rays_length = 9\ncompare_orientation = false"),
    ("columns = 11", "columns = 11\nteeth = \"one\""),
    ("rows = 8", "rows = 6"),
];

#[test]
fn a_crown_gear_is_milled_with_its_program() {
    let outcome = run(&changed("crown-gear", &FEW));
    let [deviation, difference] = worst(&outcome);
    // Its flanks are flat but for the ease-off of 5 um over the height.
    assert!(deviation < 1.0 && difference < 0.2, "{deviation} {difference}");
    assert!(outcome.result.flanks.values().all(|flank| flank.unmilled.is_empty() && flank.gouged == 0));
    let programs = outcome.texts.programs.as_ref().unwrap();
    assert_eq!(programs.programs.len(), 1);
    let mate = outcome.result.mate.as_ref().unwrap();
    assert!((mate.shaft_angle_deg.unwrap() - 120.0).abs() < 1e-9 && mate.start_of_flank.covered);
    for flank in mate.flanks.values() {
        // Both say the same of the contact, one by rolling and one in closed form.
        let off = flank.transmission_error_um - flank.transmission_error_ease_off_um;
        assert!(flank.overlap_percent > 90.0 && off.abs() < 0.2, "{flank:?}");
    }
}

/// Above the pitch plane the involute is hollow: the side of an end mill gouges there, a ball does not.
#[test]
fn the_involute_of_a_crown_gear_needs_a_round_cutter() {
    let involute = [FEW.as_slice(), &[("flank = \"octoid\"\n", "")]].concat();
    match run_milling(&changed("crown-gear", &involute), &Silent) {
        Err(RunFailure::NotProducible(finding)) => assert_eq!(finding.code, "gouge-local", "{finding}"),
        other => panic!("{:?}", other.map(|outcome| outcome.result.flanks.len())),
    }
    let ball = [
        ("shape = \"end-mill\"", "shape = \"ball\""),
        ("corner_radius = 0.3\n", ""),
        ("contact_height = { from = 0.6, to = 2.4 }\n", "tilt_deg = 12.0\n"),
        ("rows = 6", "rows = 24"),
    ];
    let outcome = run(&changed("crown-gear", &[involute.as_slice(), &ball].concat()));
    let [deviation, difference] = worst(&outcome);
    assert!(deviation < 20.0 && difference < 1.0, "{deviation} {difference}");
    assert!(outcome.result.flanks.values().all(|flank| flank.gouged == 0));
}

#[test]
fn the_body_of_a_crown_gear_is_a_disc_and_its_teeth_are_out_of_reach_below_a_plane() {
    let bodies = prepare_milling(&changed("crown-gear", &[])).unwrap().bodies;
    let mesh = part_with(&bodies, Fineness { height: 9, length: 9 }).unwrap();
    mesh.check_watertight().unwrap();
    // A ring of 42 to 60 mm, 12 mm thick with a bore that widens from 21 to 30 mm.
    let volume = mesh.volume();
    assert!(volume > 5e4 && volume < 1.5e5, "{volume}");
    let Retraction::Below(plane) = bodies.retraction else { panic!("{:?}", bodies.retraction) };
    let lowest = mesh.vertices.iter().map(|point| point.z).fold(f64::INFINITY, f64::min);
    assert!(plane < lowest - 1.9, "{plane} {lowest}");
    for flank in bodies.flanks() {
        let [root, tip] = flank.active.height_span();
        let at = |height: f64| flank.active.surface.point(height, 55.0);
        assert!(at(root).z > 0.0 && at(tip).z < -3.0);
        // Walls and lands look towards -z as the teeth do.
    }
    for space in &bodies.parts {
        for surface in space.lands.iter().map(|land| &land.surface) {
            use foundation::geometry::Surface;
            assert!(surface.jet(0.0, 0.5).normal.z < -0.99);
        }
    }
    let place = |axis: Vector3<f64>| CutterPlace { tip: Vector3::new(0.0, 50.0, -1.0), axis, contact: None };
    let out = retracted(&place(Vector3::new(0.0, 0.6, -0.8)), bodies.retraction).unwrap();
    assert!((out.tip.z - plane).abs() < 1e-12 && out.tip.y > 50.0);
    assert!(retracted(&place(Vector3::z()), bodies.retraction).is_err());
}

/// A double-helical bevel gear with few rays and rows.
fn halves(gap: &str) -> LoadedMillingJob {
    let changes = [
        ("rays_profile = 41", "rays_profile = 11"),
        ("rays_length = 31", "rays_length = 21\ncompare_orientation = false"),
        ("columns = 13", "columns = 13\nteeth = \"one\""),
        ("rows = 22", "rows = 8"),
        ("gap = 4.0", gap),
    ];
    changed("double-helical-bevel", &changes)
}

#[test]
fn halves_have_opposite_hands_and_meet_in_one_line() {
    let plain = ("ease_off = { lengthwise_um = 6.0, profile_um = 5.0, bias_um = 0.0 }\n", "");
    let bodies = prepare_milling(&changed("double-helical-bevel", &[plain, ("gap = 4.0", "gap = 0.0")]))
        .unwrap()
        .bodies;
    let [heel, toe] = bodies.parts.as_slice() else { panic!("{} parts", bodies.parts.len()) };
    for side in Flank::BOTH {
        let of = |part: &milling::Space| part.flanks.iter().find(|flank| flank.side == side).unwrap().clone();
        let [outer, inner] = [of(heel), of(toe)];
        assert_eq!((outer.side().half, inner.side().half), (Some(Half::Heel), Some(Half::Toe)));
        assert_eq!(outer.active.face[0], inner.active.face[1]);
        assert_eq!(outer.active.height_span(), inner.active.height_span());
        for share in [0.0, 0.4, 1.0] {
            let [root, tip] = outer.active.height_span();
            let height = root + share * (tip - root);
            let [a, b] = [&outer, &inner].map(|flank| flank.active.surface.jet(height, outer.active.face[0]));
            assert!((a.point - b.point).norm() < 1e-12);
            // The teeth go apart towards both ends, on the same side of the space.
            let around = |jet: &foundation::geometry::SurfaceJet| {
                jet.by_length.x * jet.point.y - jet.by_length.y * jet.point.x
            };
            assert!(around(&a) * around(&b) < 0.0, "{} {}", around(&a), around(&b));
        }
    }
    let mesh = part_with(&bodies, Fineness { height: 5, length: 7 }).unwrap();
    mesh.check_watertight().unwrap();
}

#[test]
fn nothing_of_a_half_crosses_the_middle_and_rays_find_no_gouge() {
    for gap in ["gap = 0.0", "gap = 4.0"] {
        let job = halves(gap);
        let given = job.job.bevel.as_ref().unwrap();
        let meeting = given.meeting_distance(&given.double_helical.unwrap());
        let outcome = run(&job);
        assert_eq!(
            outcome.result.flanks.keys().copied().collect::<Vec<_>>(),
            ["heel-left", "heel-right", "toe-left", "toe-right"]
        );
        for operation in &outcome.plan.operations {
            let (OperationKind::Flank(side) | OperationKind::Fillet(side)) = operation.kind else { continue };
            let sign = side.half.unwrap().sign();
            let places = operation.paths.iter().flat_map(|path| &path.places);
            let nearest = places.map(|place| sign * (place.contact.unwrap().norm() - meeting));
            let nearest = nearest.fold(f64::INFINITY, f64::min);
            assert!(nearest >= -1e-9, "{gap} {side}: {nearest}");
        }
        let [deviation, difference] = worst(&outcome);
        assert!(deviation < 40.0 && difference < 4.0, "{gap}: {deviation} {difference}");
        if gap == "gap = 0.0" {
            // The corners of one side of the space are hollow; those of the other stand out, with edges that are relieved by micrometres.
            let rest =
                |flank: &milling::workflow::FlankResult| flank.out_of_reach.map_or(0.0, |of| of.length_mm);
            assert_eq!(outcome.result.flanks.values().filter(|flank| rest(flank) > 0.2).count(), 2);
        }
        for (name, flank) in &outcome.result.flanks {
            assert!(flank.gouged == 0 && flank.unmilled.is_empty(), "{gap} {name}: {:?}", flank.unmilled);
            assert!(flank.stock_um[0] > -1.0, "{gap} {name}: {:?}", flank.stock_um);
        }
        let mesh =
            part_with(&prepare_milling(&job).unwrap().bodies, Fineness { height: 5, length: 7 }).unwrap();
        mesh.check_watertight().unwrap();
    }
}
