//! Smaller worms under today's dressing: left whole where the used part is short, cut at its ends where it is long, because the leads differ.

use super::generating::input;
use foundation::geometry::{Sides, WormChoice};
use foundation::numerics::Chebyshev;
use generating::{GrindingSetup, SetupInput, SparedWorms};

/// A worm of many threads, whose lead changes fast with its diameter, dressed without corrections over `half` to both sides.
fn spared(half: f64, last: Option<f64>) -> SparedWorms {
    let worm = WormChoice { threads: 7, pitch_diameter: Some(110.0), tip_diameter: None, ..input().worm };
    let setup = GrindingSetup::new(SetupInput { worm, ..input() }).unwrap();
    let still = std::array::from_fn(|_| Chebyshev::interpolate(-half, half, &[0.0]));
    let corrections = Sides::both(Some(&still));
    setup.spared_worms(setup.dresser().unwrap(), &corrections, 0.0, last).unwrap()
}

#[test]
fn short_worms_are_left_whole_down_to_the_root() {
    let found = spared(60.0, None);
    assert_eq!((found.cut, found.spared_down_to), (None, found.looked_down_to));
    // Nothing reaches below the root, whatever is asked for.
    assert_eq!(spared(60.0, Some(20.0)), found);
}

#[test]
fn long_worms_are_cut_at_their_ends() {
    let found = spared(600.0, None);
    let cut = found.cut.unwrap();
    assert!(cut.depth > 0.0 && cut.z.abs() == 600.0, "{cut:?}");
    let tip = 2.0 * 110.0f64.mul_add(0.5, 1.25 * 3.5);
    assert!(found.looked_down_to < tip && found.spared_down_to > found.looked_down_to, "{found:?}");
    // The gap between the flanks grows with the difference of the diameters, and the offset of the threads faster.
    let smaller = spared(600.0, Some(found.spared_down_to - 2.0)).cut.unwrap();
    assert!(smaller.depth > 0.0 && smaller.z.abs() == 600.0, "{smaller:?}");
}
