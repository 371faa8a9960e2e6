//! Gears rolled against their mates: what modifications do to the contact, and the flank as it is milled, by the plan and by the
//! referee's rays.

use contact::{FlankDeviation, RolledGear, RolledPair};
use foundation::geometry::Flank;
use foundation::numerics::{Silent, equidistant};
use job::{Source, parse_job_of};
use milling::job::MillingJob;
use milling::workflow::{MillingOutcome, deviations_at, run_milling};
use serde_json::{Value, json};

fn run(job: &Value) -> MillingOutcome {
    let text = job.to_string();
    let loaded = parse_job_of::<MillingJob>(Source::new("job.json", &text))
        .unwrap_or_else(|error| panic!("{error}\n{text}"));
    run_milling(&loaded, &Silent).unwrap_or_else(|failure| panic!("{failure:?}\n{text}"))
}

/// The straight pinion of the examples against its mate.
fn bevel() -> Value {
    json!({
        "job": { "name": "mate", "process": "five-axis-milling" },
        "bevel": { "outer_transverse_module": 5.0, "teeth": 16, "pitch_cone_angle_deg": 33.690067525979785, "face_width": 20.0 },
        "mate": { "teeth": 24, "ease_off": { "lengthwise_um": 4.0, "profile_um": 2.0 }, "roll_positions": 16 },
        "target": { "tolerance_um": 8.0, "ease_off": { "lengthwise_um": 4.0, "profile_um": 2.0 } },
        "cutter": { "shape": "end-mill", "diameter": 2.4, "corner_radius": 0.5, "cutting_length": 12.0 },
        "milling": { "rows": 10, "columns": 9, "contact_height": { "from": 2.1, "to": 3.0 }, "row_spacing": "scallop",
            "feed_mm_per_min": 600.0, "spindle_rpm": 18000.0, "flanks": "left" },
        "simulation": { "rays_profile": 21, "rays_length": 7, "compare_orientation": false }
    })
}

/// A helical gear against a wheel.
fn helical() -> Value {
    let gear = |teeth: i32, helix: f64, diameters: [f64; 3]| {
        json!({ "teeth": teeth, "normal_module": 6.0, "normal_pressure_angle_deg": 20.0, "helix_angle_deg": helix,
            "profile_shift": 0.0, "face_width": 30.0, "tip_diameter": diameters[0], "root_diameter": diameters[1],
            "form_diameter": diameters[2] })
    };
    json!({
        "job": { "name": "mate", "process": "five-axis-milling" },
        "gear": gear(23, 25.0, [164.266, 137.266, 143.0]),
        "mate": { "gear": gear(41, -25.0, [283.432, 256.432, 262.0]), "centre_distance": 211.95, "roll_positions": 16,
            "modifications": [{ "kind": "profile_crowning", "amount_um": 6.0, "flank": "both" }] },
        "target": { "tolerance_um": 30.0,
            "modifications": [{ "kind": "helix_crowning", "amount_um": 10.0, "flank": "both" }] },
        "cutter": { "shape": "end-mill", "diameter": 5.0, "corner_radius": 1.0, "cutting_length": 16.0 },
        "milling": { "rows": 8, "columns": 25, "contact_height": 2.91, "feed_mm_per_min": 1200.0, "spindle_rpm": 10000.0,
            "flanks": "right" },
        "simulation": { "rays_profile": 21, "rays_length": 7, "compare_orientation": false }
    })
}

/// What the rays find on the milled flank, rolled against the mate, is what was predicted of it.
#[test]
fn the_milled_flank_rolls_as_the_rays_of_the_referee_have_it() {
    for (job, flank) in [(bevel(), Flank::Left), (helical(), Flank::Right)] {
        let outcome = run(&job);
        let mate = outcome.mate.as_ref().unwrap();
        let contact = mate.flanks[0].milled.as_ref().unwrap();
        assert_eq!(contact.unknown, 0, "rows come by everywhere");
        let bodies = &outcome.prepared.bodies;
        let planned = &outcome.plan.flanks[0];
        let (heights, lengths) = (planned.active.height_span(), planned.active.face);
        let counts = [contact.places.heights.len(), contact.places.lengths.len()];
        let places = |_| [equidistant(heights, counts[0]), equidistant(lengths, counts[1])];
        let (_, rays) = deviations_at(bodies, &outcome.plan, places, &Silent).unwrap().remove(0);
        let deviation = FlankDeviation::new(heights, lengths, counts, &rays).unwrap();
        let pair = outcome.prepared.mate.as_ref().unwrap();
        let side = &pair.sides[flank];
        let own = RolledGear {
            surface: planned.active.surface.clone(),
            heights,
            lengths,
            teeth: side.gears[0].teeth,
        };
        let rolled = RolledPair::new([own, side.gears[1].clone()], pair.arrangement, flank).unwrap();
        let rolled = rolled.with_play_of(&side.nominal).deviating(Some(deviation));
        let course = rolled.roll(contact.course.per_pitch()).unwrap();
        let tolerance_mm = 1e-3 * outcome.result.tolerance_um;
        for k in 0..=20 {
            let roll = 0.02 * f64::from(k);
            let off = pair.radius * (course.at(roll) - contact.course.at(roll));
            // A tenth of the tolerance is asked for.
            assert!(off.abs() < 0.01 * tolerance_mm, "{flank:?} {roll}: {off} mm");
        }
        let result = &mate.result.flanks[flank.name()];
        let um = 1e3 * pair.radius * course.peak_to_peak();
        let told = result.transmission_error_milled_um.unwrap();
        assert!((um - told).abs() < 0.05 && um > 0.0, "{um} {told}");
        let pattern = result.milled.unwrap();
        assert!(pattern.area_percent > 1.0 && pattern.area_percent < 100.0, "{pattern:?}");
    }
}

/// Relief takes the contact away from the tip; that of the mate from the root; and modifications count beside an ease-off.
#[test]
fn relief_moves_the_contact_of_bevel_gears() {
    let plain = run(&bevel());
    let relief = json!([{ "kind": "tip_relief", "amount_um": 40.0, "length_mm": 5.0, "exponent": 1, "transition_mm": 0.2,
        "flank": "both" }]);
    // A short transition makes the curvature leap, which rows of equal scallops or arcs cannot follow.
    let by_steps = || {
        let mut job = bevel();
        job["milling"]["row_spacing"] = json!("parameter");
        job["milling"]["rows"] = json!(20);
        job
    };
    let mut own = by_steps();
    own["target"]["modifications"] = relief.clone();
    let mut of_mate = by_steps();
    of_mate["mate"]["modifications"] = relief;
    let heights = |outcome: &MillingOutcome| {
        outcome.result.mate.as_ref().unwrap().flanks["left"].rolled.unwrap().height_percent
    };
    let (before, tip, root) = (heights(&plain), heights(&run(&own)), heights(&run(&of_mate)));
    assert!(tip[1] < before[1] - 8.0 && (tip[0] - before[0]).abs() < 8.0, "{before:?} {tip:?}");
    assert!(root[0] > before[0] + 8.0 && (root[1] - before[1]).abs() < 8.0, "{before:?} {root:?}");
    // What is asked for is what comes out, by the rays, but for the scallops of twenty rows; the relief alone is 40 um.
    let worst = run(&own).result.flanks["left"].max_deviation_um;
    assert!(worst < 15.0, "{worst}");
}

/// A topography that is hollow along the tooth carries at both ends.
#[test]
fn a_hollow_flank_has_a_pattern_of_two_parts() {
    let mut hollow = bevel();
    hollow["mate"]["ease_off"] = json!({});
    hollow["target"]["modifications"] =
        json!([{ "kind": "formula", "f_um": "-80*(v^2 - 0.36)^2 - 5*u^2", "flank": "both" }]);
    let outcome = run(&hollow);
    let flank = &outcome.result.mate.as_ref().unwrap().flanks["left"];
    let parts = &flank.parts;
    assert_eq!(parts.len(), 2, "{parts:?}");
    let sides = [parts[0].centre_length_percent, parts[1].centre_length_percent];
    assert!((sides[0] - 50.0) * (sides[1] - 50.0) < 0.0, "{sides:?}");
    let whole = flank.rolled.unwrap().area_percent;
    let together = parts[0].area_percent + parts[1].area_percent;
    assert!((whole - together).abs() < 0.5, "{whole} {together}");
    let plain = run(&bevel());
    assert_eq!(plain.result.mate.as_ref().unwrap().flanks["left"].parts.len(), 1);
}

/// A ring around a milled pinion, and a pinion in a milled ring; distances at which teeth jam are refused.
#[test]
fn cylindrical_pairs_stand_at_distances_with_backlash() {
    let outcome = run(&helical());
    let mate = outcome.result.mate.unwrap();
    // j_t = 2 a' (inv alpha' - inv alpha) to first order 2 (a' - a) tan(alpha_t) at the working pitch circle.
    let backlash = mate.backlash_um.unwrap();
    assert!((backlash - 2.0 * 104.0 * 0.4016).abs() < 4.0, "{backlash}");
    assert!((mate.mean_pitch_radius_mm - 211.95 * 41.0 / 64.0).abs() < 1e-9);
    assert!(mate.start_of_flank.covered, "{:?}", mate.start_of_flank);
    let mut short = helical();
    short["gear"]["form_diameter"] = json!(148.0);
    let start = run(&short).result;
    assert!(
        start.warnings.iter().any(|remark| remark.code == "mate-needs-more-flank"),
        "{:?}",
        start.warnings
    );
    let mut jammed = helical();
    jammed["mate"]["centre_distance"] = json!(211.7);
    let text = jammed.to_string();
    let loaded = parse_job_of::<MillingJob>(Source::new("job.json", &text)).unwrap();
    let failure = format!("{:?}", run_milling(&loaded, &Silent).unwrap_err());
    assert!(failure.contains("mate.centre_distance") && failure.contains("jam"), "{failure}");
}
