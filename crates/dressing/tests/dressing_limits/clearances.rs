//! The search for the least clearance against sampling: nothing that it says is wrong, nothing that sampling finds is missed.

use super::setup::{Choice, Seat, View, choices, circles, corrections, flanks, is_the_least, section};
use dressing::{DressingError, ThreadSpace};
use foundation::geometry::{Flank, Sides};
use proptest::prelude::*;
use std::f64::consts::PI;

/// A dresser that has lost the flank it dresses tells nothing.
fn touching<T>(found: Result<T, DressingError>) -> Result<T, TestCaseError> {
    match found {
        Err(DressingError::NoContact { .. }) => Err(TestCaseError::reject("no contact")),
        found => Ok(found.unwrap()),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn the_counter_flank_is_seen_as_sampling_sees_it(
        choice in choices(),
        flank in flanks(),
        dk in corrections(),
        share in 0.0..1.0f64,
        left_out in 0..3u32,
    ) {
        let left_out = left_out.min(choice.threads.unsigned_abs() - 1);
        let tool = choice.tool();
        let section = section(&tool, flank, &choice)?;
        let land = share * section.full_land();
        let found = touching(section.counter_flank(&dk, land, left_out.into()))?;
        let view = View { worm: choice.flank(flank.other()), left_out, b: 0.0 };
        is_the_least(&section, land, &view, &Seat::new(&tool, flank, &dk), found)?;
    }

    #[test]
    fn another_worm_is_seen_as_sampling_sees_it(
        choice in choices(),
        flank in flanks(),
        dk in corrections(),
        smaller in 0.7..1.05f64,
        b in -60.0..60.0f64,
    ) {
        let other = Choice { diameter: (smaller * choice.diameter).max(choice.least_diameter()), ..choice };
        let tool = choice.tool();
        let section = section(&tool, flank, &choice)?;
        let land = 0.4 * section.full_land();
        let worms = Sides::from_fn(|f| other.flank(f));
        let found = touching(section.undermining(&dk, land, &worms, &[b]))?;
        for (f, at) in found.iter() {
            let view = View { worm: worms[f], left_out: 0, b };
            is_the_least(&section, land, &view, &Seat::new(&tool, flank, &dk), at[0])?;
        }
    }

    #[test]
    fn on_a_conical_worm_the_least_clearance_is_at_an_end(
        choice in choices(),
        cone in -4.0..4.0f64,
        flank in flanks(),
        dk in corrections(),
        left_out in 0..2u32,
        from in -60.0..0.0f64,
        length in 0.0..80.0f64,
    ) {
        // The cone lifts the base cylinder of one flank.
        let choice = Choice { cone, diameter: choice.diameter.max(1.3 * choice.least_diameter()), ..choice };
        let left_out = left_out.min(choice.threads.unsigned_abs() - 1);
        let tool = choice.tool();
        let section = section(&tool, flank, &choice)?;
        let land = 0.5 * section.full_land();
        let to = from + length;
        let seat = Seat::new(&tool, flank, &dk);
        let space = ThreadSpace { left_out, width: Some([from, to]) };
        let found = touching(section.counter_flank(&dk, land, space))?;
        let view = |b| View { worm: choice.flank(flank.other()), left_out, b };
        // The end that was named is seen right, and no other plane has less.
        let named = found.map_or(from, |at| at.b);
        // Without cone the space is the same everywhere and looked at where b = 0.
        prop_assert!(named == from || named == to || cone == 0.0, "b = {named}");
        is_the_least(&section, land, &view(named), &seat, found)?;
        let least = found.map_or(f64::INFINITY, |at| at.f);
        for k in 0..=4 {
            let b = from + length * f64::from(k) / 4.0;
            let sampled = view(b).brute(&seat, &circles(&section, land, 20), 300);
            prop_assert!(sampled > least - 1e-9, "b = {b}: {sampled} < {least}");
        }
    }

    #[test]
    fn the_largest_tip_land_just_clears(
        choice in choices(),
        flank in flanks(),
        dk in corrections(),
        limit in -0.1..0.5f64,
    ) {
        let tool = choice.tool();
        let section = section(&tool, flank, &choice)?;
        let full = section.full_land();
        let clearance = |land: f64| section.counter_flank_clearance(&dk, land, 0.into()).unwrap();
        let seat = Seat::new(&tool, flank, &dk);
        let view = View { worm: choice.flank(flank.other()), left_out: 0, b: 0.0 };
        let sampled = |land: f64| view.brute(&seat, &circles(&section, land, 40), 600);
        match touching(section.largest_tip_land(&dk, limit, 0.into()))? {
            None => prop_assert!(clearance(0.0) < limit && sampled(0.0) < limit + 0.02),
            Some(land) if land == full => prop_assert!(clearance(full) >= limit && sampled(full) >= limit),
            Some(land) => {
                prop_assert!((0.0..full).contains(&land));
                prop_assert!((clearance(land) - limit).abs() < 1e-7, "{} {limit}", clearance(land));
                // Sampling misses the least place by some micrometres.
                let step = 0.02;
                if land > step {
                    prop_assert!(clearance(land - step) > limit && sampled(land - step) > limit);
                }
                if land + step < full {
                    prop_assert!(clearance(land + step) < limit && sampled(land + step) < limit);
                }
            }
        }
    }
}

/// Threads left out open the space: the clearance grows by whole threads, and every land fits.
#[test]
fn left_out_threads_widen_the_space() {
    let choice = Choice::EXAMPLE;
    let tool = choice.tool();
    let section = section(&tool, Flank::Left, &choice).unwrap();
    // The corrections of a profile crowning of 10 um, with which a land of 1 mm collides.
    let dk = [-0.0609, -0.1081, -2.72, 11.76];
    let clear = |k: u32| section.counter_flank_clearance(&dk, section.full_land(), k.into()).unwrap();
    assert!(clear(0) < -1.0, "{}", clear(0));
    let worm = choice.flank(Flank::Right).flank;
    let pitch = 2.0 * PI / worm.teeth * worm.base_radius * worm.base_helix_angle.cos();
    for k in 0..4 {
        let wider = clear(k + 1) - clear(k);
        // The place of the least clearance moves out of the space and is met by other circles.
        assert!(wider > 0.7 * pitch && wider < 1.01 * pitch, "{k}: {wider} {pitch}");
    }
    let lands = [0, 1].map(|k| section.largest_tip_land(&dk, 0.0, ThreadSpace::from(k)).unwrap());
    assert!(lands[0].is_none_or(|land| land < 0.3 * section.full_land()), "{lands:?}");
    assert_eq!(lands[1], Some(section.full_land()));
}
