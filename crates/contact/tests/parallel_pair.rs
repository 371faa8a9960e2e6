//! Cylindrical pairs rolled against each other: nominal flanks touch along lines, and what stands beside them shows
//! (`docs/mathematics/milling.md#contact-with-the-mate`).

use contact::{
    Arrangement, ConjugateFlanks, ContactPattern, FlankDeviation, FlankPlaces, RolledGear, RolledPair,
    overlap, parts,
};
use foundation::geometry::{
    EaseOff, EaseOffAmounts, Flank, Gear, GearData, Helicoid, Modified, NormalOffset, Sides, Surface,
};
use foundation::numerics::equidistant;
use std::sync::Arc;

const POSITIONS: usize = 16;

/// Teeth of both, helix angle of the first (degrees) and working centre distance over the standard one.
const PAIRS: [([i32; 2], f64, f64); 6] = [
    ([20, 33], 0.0, 1.003),
    ([20, 33], 18.0, 1.002),
    ([33, 20], -18.0, 1.004),
    ([19, -70], 0.0, 0.997),
    ([19, -70], 12.0, 0.998),
    ([-70, 19], 12.0, 0.998),
];

fn gear(teeth: i32, helix_deg: f64) -> Gear {
    Gear::new(GearData {
        teeth,
        normal_module: 3.0,
        pressure_angle: Sides::both(20f64.to_radians()),
        helix_angle: helix_deg.to_radians(),
        profile_shift: 0.0,
        cone_angle: 0.0,
    })
    .unwrap()
}

struct Rolled {
    pair: RolledPair,
    conjugate: ConjugateFlanks,
    ease: [Arc<dyn NormalOffset>; 2],
}

/// A pair whose first gear has an ease-off of these amounts, um.
fn rolled((teeth, helix, stretch): ([i32; 2], f64, f64), flank: Flank, um: [f64; 3]) -> Rolled {
    let inside = teeth[0] * teeth[1] < 0;
    let gears = [gear(teeth[0], helix), gear(teeth[1], if inside { helix } else { -helix })];
    let other = match (inside, flank) {
        (false, side) => side,
        (true, Flank::Left) => Flank::Right,
        (true, Flank::Right) => Flank::Left,
    };
    let flanks = [Helicoid::new(&gears[0], flank), Helicoid::new(&gears[1], other)];
    let radii = gears.each_ref().map(Gear::pitch_radius);
    let centre_distance = stretch * if inside { (radii[0] - radii[1]).abs() } else { radii[0] + radii[1] };
    let arrangement = if inside {
        Arrangement::Inside { centre_distance, first_is_ring: teeth[0] < 0 }
    } else {
        Arrangement::Outside { centre_distance }
    };
    let heights = flanks.each_ref().map(|of| {
        let sign = of.external_sign();
        let pitch = of.pitch_radius();
        [pitch - sign * 2.6, pitch + sign * 2.6]
            .map(|radius| of.length_of_roll(radius.max(1.001 * of.base_radius())).unwrap())
    });
    let face = [-15.0, 15.0];
    let conjugate =
        ConjugateFlanks::cylindrical(flanks.each_ref(), arrangement, heights, [face, face]).unwrap();
    let amounts = |k: usize| {
        let [along, across, bias] = if k == 0 { um.map(|x| 1e-3 * x) } else { [0.0; 3] };
        EaseOffAmounts { length_crowning: along, profile_crowning: across, bias }
    };
    let ease = [0, 1]
        .map(|k| Arc::new(EaseOff::new(amounts(k), heights[k], face).unwrap()) as Arc<dyn NormalOffset>);
    let side = |k: usize, offset: bool| {
        let surface: Arc<dyn Surface> =
            if offset { Arc::new(Modified::new(flanks[k], ease[k].clone())) } else { Arc::new(flanks[k]) };
        RolledGear { surface, heights: heights[k], lengths: face, teeth: teeth[k].unsigned_abs() }
    };
    let place = touching(&conjugate, heights[0]);
    let nominal = RolledPair::new([side(0, false), side(1, false)], arrangement, flank).unwrap();
    let nominal = nominal.without_play(place, conjugate.roll(place)).unwrap();
    let pair = RolledPair::new([side(0, um != [0.0; 3]), side(1, false)], arrangement, flank).unwrap();
    let pair = pair.with_play_of(&nominal);
    Rolled { pair, conjugate, ease }
}

/// A place that touches something.
fn touching(conjugate: &ConjugateFlanks, heights: [f64; 2]) -> [f64; 2] {
    let at = equidistant(heights, 101).into_iter().map(|height| [height, 0.0]);
    let found: Vec<[f64; 2]> = at.filter(|place| conjugate.touches(*place)).collect();
    found[found.len() / 2]
}

fn places(rolled: &Rolled, counts: [usize; 2]) -> FlankPlaces {
    let gear = rolled.pair.first();
    FlankPlaces {
        heights: equidistant(gear.heights, counts[0]),
        lengths: equidistant(gear.lengths, counts[1]),
    }
}

#[test]
fn nominal_helicoids_touch_along_whole_lines_at_an_even_turn() {
    for which in PAIRS {
        for flank in Flank::BOTH {
            let rolled = rolled(which, flank, [0.0; 3]);
            let all = places(&rolled, [21, 9]);
            let touching: Vec<[f64; 2]> =
                all.iter().filter(|place| rolled.conjugate.touches(*place)).collect();
            assert!(touching.len() > 80, "{which:?} {}", touching.len());
            for place in touching {
                let roll = rolled.conjugate.roll(place);
                let condition = rolled.pair.roll_of(place).unwrap();
                assert!((condition - roll).abs() < 1e-9, "{which:?} {flank:?} {place:?}: {condition} {roll}");
                let Some(gap) = rolled.pair.gap(place, roll, None) else {
                    panic!("{which:?} {flank:?} {place:?}: no partner")
                };
                assert!((gap.angle * gap.arm).abs() < 1e-9, "{which:?} {flank:?} {place:?}: {gap:?}");
                assert!((gap.partner[0] - rolled.conjugate.partner(place[0])).abs() < 1e-6, "{gap:?}");
            }
            let course = rolled.pair.roll(POSITIONS).unwrap();
            assert!(course.peak_to_peak() * 50.0 < 1e-9, "{which:?} {}", course.peak_to_peak());
        }
    }
}

/// Crowning removes material: the second gear lags, and the pattern lies where the closed form has it.
#[test]
fn the_rolled_pattern_is_that_of_the_ease_off() {
    for which in PAIRS {
        let rolled = rolled(which, Flank::Left, [18.0, 8.0, 3.0]);
        let all = places(&rolled, [31, 31]);
        let found = rolled.pair.roll(POSITIONS).unwrap();
        let ease = [&*rolled.ease[0], &*rolled.ease[1]];
        let said = rolled.conjugate.course(ease, POSITIONS);
        let [is, wanted] = [&found, &said].map(contact::RollCourse::peak_to_peak);
        assert!((is / wanted - 1.0).abs() < 0.05 && wanted > 1e-6, "{which:?} {is:e} {wanted:e}");
        assert!(found.at(0.1) > -1e-9 && said.at(0.1) > -1e-9, "{which:?}: it lags");
        let fields = [rolled.pair.field(&all, &found), rolled.conjugate.field(&all, ease, &said)];
        let areas = all.areas(&*rolled.pair.first().surface);
        // Where lines reach; beyond the tip of the second gear a narrow band shows that no line reaches.
        for (gap, other) in fields[0].gaps.iter().zip(&fields[1].gaps).filter(|(_, other)| **other < 6e-3) {
            assert!((gap - other).abs() < 5e-4, "{which:?}: {gap} {other}");
        }
        assert!(overlap(fields.each_ref(), 6e-3, &areas) > 0.9, "{which:?}");
        assert!(ContactPattern::of(&fields[0], 6e-3, &all, &areas).is_some());
    }
}

/// What a flank deviates by counts as if it were its surface: the crowned surface alone, and the nominal one that deviates by the
/// crowning.
#[test]
fn a_deviation_counts_as_the_surface_does() {
    let which = PAIRS[1];
    let crowned = rolled(which, Flank::Left, [18.0, 8.0, 3.0]);
    let plain = rolled(which, Flank::Left, [0.0; 3]);
    let fine = places(&crowned, [161, 81]);
    let values: Vec<Option<f64>> = fine.iter().map(|[a, b]| Some(crowned.ease[0].jet(a, b).f)).collect();
    let gear = plain.pair.first().clone();
    let deviation = FlankDeviation::new(gear.heights, gear.lengths, [161, 81], &values).unwrap();
    let deviating = plain.pair.clone().deviating(Some(deviation));
    let [is, wanted] = [&deviating, &crowned.pair].map(|pair| pair.roll(POSITIONS).unwrap());
    for k in 0..40 {
        let roll = 0.01 * f64::from(k);
        // 4e-7 rad at 50 mm are 0.02 um, a thousandth of the crowning: where the flanks are open their normals differ.
        assert!((is.at(roll) - wanted.at(roll)).abs() < 4e-7, "{roll}: {} {}", is.at(roll), wanted.at(roll));
    }
    assert!((is.peak_to_peak() / wanted.peak_to_peak() - 1.0).abs() < 0.02);
    // Unknown places do not touch.
    let half: Vec<Option<f64>> =
        fine.iter().map(|[a, b]| (b > 0.0).then(|| crowned.ease[0].jet(a, b).f)).collect();
    let deviation = FlankDeviation::new(gear.heights, gear.lengths, [161, 81], &half).unwrap();
    let known = plain.pair.deviating(Some(deviation));
    let course = known.roll(POSITIONS).unwrap();
    let coarse = places(&crowned, [11, 11]);
    let field = known.field(&coarse, &course);
    assert!(coarse.iter().zip(&field.gaps).all(|([_, b], gap)| b > 0.0 || gap.is_infinite()));
}

/// A flank with scallops, against a dense search over all places without windows or refinement; and contact in two places of a flank that
/// is hollow along the tooth.
#[test]
fn what_stands_out_touches_first() {
    let plain = rolled(PAIRS[0], Flank::Right, [0.0; 3]);
    let gear = plain.pair.first().clone();
    let counts = [121, 41];
    let all = places(&plain, counts);
    let [root, tip] = gear.heights;
    let scallop = |a: f64, b: f64| {
        let share = (a - root) / (tip - root);
        5e-3 * (std::f64::consts::PI * 9.0 * share).sin().abs() - 1e-5 * b * b
    };
    let values: Vec<Option<f64>> = all.iter().map(|[a, b]| Some(scallop(a, b))).collect();
    let deviation = FlankDeviation::new(gear.heights, gear.lengths, counts, &values).unwrap();
    let pair = plain.pair.clone().deviating(Some(deviation));
    let course = pair.roll(POSITIONS).unwrap();
    for k in [3, 8, 13] {
        // At a position: between them the course is linear.
        let roll = course.range()[0] + f64::from(k) * course.step();
        let mut least = f64::INFINITY;
        for shift in -2..=2 {
            let roll = roll + f64::from(shift) * pair.pitch();
            for place in all.iter() {
                least = least.min(pair.gap(place, roll, None).map_or(f64::INFINITY, |gap| gap.angle));
            }
        }
        // Places 0.06 mm apart: a scallop of 5 um has a slope of 0.03 at its foot, crests lie on places.
        assert!(least > course.at(roll) - 1e-12, "{roll}: {least:e} {:e}", course.at(roll));
        assert!(least < course.at(roll) + 4e-6, "{roll}: {least:e} {:e}", course.at(roll));
    }
    let hollow = rolled(PAIRS[1], Flank::Left, [-12.0, 2.0, 0.0]);
    let course = hollow.pair.roll(POSITIONS).unwrap();
    let all = places(&hollow, [25, 61]);
    let areas = all.areas(&*hollow.pair.first().surface);
    let field = hollow.pair.field(&all, &course);
    let found = parts(&field, 3e-3, &all, &areas, 0.01);
    assert_eq!(found.len(), 2, "{found:?}");
    assert!((found[0].centre[1] - 0.5) * (found[1].centre[1] - 0.5) < 0.0, "{found:?}");
}
