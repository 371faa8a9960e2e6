//! True feed marks: their height against the reference numbers of two fixed feed positions.

use super::setups::{area, feeds, num, pair, reference};
use foundation::geometry::{Flank, InvoluteFlank};
use foundation::kinematics::MotionLaw;
use foundation::numerics::Silent;
use referee::{ActiveThreads, Grinding, GrindingMode, RayGrid, Unmodified, grind};
use std::f64::consts::PI;

#[test]
fn marks_between_two_passes_have_the_height_of_the_reference() {
    let file = reference("20-generating-contact.json");
    let mut seen = 0;
    for case in file["cases"].as_array().unwrap() {
        for flank in Flank::BOTH {
            let expected = &case["expected"][flank.name()]["step_error"];
            if expected.is_null() {
                continue;
            }
            let pair = pair(&case["input"]);
            let motion = pair.motion(MotionLaw::polynomial(0.0, vec![0.0, num(&expected["K_ZV1"])]));
            // The ray that is ground at feed 0: on a conical workpiece the worm's point depends on the feed.
            let w = num(&expected["w_2_mm"]);
            let grid = RayGrid::new(vec![w], vec![pair.flanks[flank].work_z(w, 0.0, 0.0)]).unwrap();
            let mut setup = Grinding {
                worm: pair.worm.flank(flank),
                area: area(&pair, flank, &grid, &motion, [4.0, 12.0]),
                modification: &Unmodified,
                work: pair.work.flank(flank),
                motion: &motion,
                feed_range: feeds(&pair, flank, &grid, &motion, 4.0),
                stock: 0.1,
                threads: ActiveThreads::All,
                mode: GrindingMode::Continuous,
            };
            let envelope = grind(&setup, &grid, &Silent).unwrap().rays[0].unwrap();
            // Two passes as far from the contact as they can be: half a feed before and behind it. A real pass advances
            // while it turns, forwards or backwards; the reference's passes stand still, like the mean of both.
            let step = num(&expected["feed_step_mm"]);
            let simulated = num(&expected["feed_mark_simulated_um"]);
            let mut mean = 0.0;
            for feed in [step, -step] {
                let start = envelope.feed - feed * envelope.work_angle / (2.0 * PI) + 0.5 * feed;
                setup.mode = GrindingMode::FeedMarks { feed_per_revolution: feed, start };
                let height = grind(&setup, &grid, &Silent).unwrap().lengths().unwrap()[0] * 1e3;
                let off = height / simulated - 1.0;
                assert!(off.abs() < 0.001, "{} {flank}: {height} {simulated}", case["name"]);
                mean += 0.5 * height;
                // A pass through the contact itself leaves nothing.
                let through = start - 0.5 * feed;
                setup.mode = GrindingMode::FeedMarks { feed_per_revolution: feed, start: through };
                let ground = grind(&setup, &grid, &Silent).unwrap();
                assert!(ground.lengths().unwrap()[0].abs() * 1e3 <= ground.error_um);
            }
            assert!((mean / simulated - 1.0).abs() < 1e-4, "{} {flank}: {mean} {simulated}", case["name"]);
            seen += 1;
        }
    }
    assert_eq!(seen, 22);
}

#[test]
fn marks_repeat_along_the_tooth_at_the_feed() {
    let file = reference("20-generating-contact.json");
    let case = &file["cases"][0];
    let (pair, flank) = (pair(&case["input"]), Flank::Left);
    let expected = &case["expected"]["left"]["step_error"];
    let motion = pair.motion(MotionLaw::zero());
    let work: &InvoluteFlank = pair.work.flank(flank);
    let w = num(&expected["w_2_mm"]);
    let feed = 0.5;
    // The contact moves by -dz_2 per feed on a cylinder, and the cut turns backwards with z along the helix.
    let along = feed / (1.0 - feed * work.twist_per_length() / (2.0 * PI)).abs();
    let z: Vec<f64> = (0..41).map(|k| -2.0 * along + along * k as f64 / 10.0).collect();
    let grid = RayGrid::new(vec![w], z).unwrap();
    let setup = Grinding {
        worm: pair.worm.flank(flank),
        area: area(&pair, flank, &grid, &motion, [4.0, 12.0]),
        modification: &Unmodified,
        work,
        motion: &motion,
        feed_range: feeds(&pair, flank, &grid, &motion, 4.0),
        stock: 0.1,
        threads: ActiveThreads::All,
        mode: GrindingMode::FeedMarks { feed_per_revolution: feed, start: 0.123 },
    };
    let f = grind(&setup, &grid, &Silent).unwrap().lengths().unwrap();
    let height = num(&expected["feed_mark_simulated_um"]) * 1e-3;
    let highest = f.iter().copied().fold(0.0, f64::max);
    assert!(highest <= 1.01 * height && highest > 0.75 * height, "{highest} {height}");
    for k in 0..31 {
        assert!((f[k] - f[k + 10]).abs() < 1e-6 * height, "{k}: {} {}", f[k], f[k + 10]);
    }
    // Twice the feed, four times the height.
    let doubled =
        Grinding { mode: GrindingMode::FeedMarks { feed_per_revolution: 2.0 * feed, start: 0.123 }, ..setup };
    let f = grind(&doubled, &grid, &Silent).unwrap().lengths().unwrap();
    let highest = f.iter().copied().fold(0.0, f64::max);
    assert!((highest / (4.0 * height) - 1.0).abs() < 0.1, "{highest}");
}
