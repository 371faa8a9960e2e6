//! A bevel pair rolled against each other shows contact where its ease-off says (`docs/mathematics/milling.md#flanks-as-patches`).

use contact::{
    Arrangement, ConjugateFlanks, ContactPattern, FlankPlaces, GapField, RollCourse, RolledGear, RolledPair,
    overlap,
};
use foundation::geometry::{
    BevelData, BevelGear, EaseOff, EaseOffAmounts, Flank, Hand, LineForm, Modified, NormalOffset, Octoid,
    SphericalInvolute, Spiral, Surface,
};
use foundation::numerics::equidistant;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// The marking, mm.
const MARKING: f64 = 6e-3;
const POSITIONS: usize = 24;

/// Pairs of the examples: teeth, face width, spiral angle and cutter radius.
type Pair = ([u32; 2], f64, Option<(f64, f64)>);
const STRAIGHT: Pair = ([16, 24], 20.0, None);
const SPIRAL: Pair = ([15, 35], 25.0, Some((35.0, 63.0)));
const TURNED: Pair = ([35, 15], 25.0, Some((35.0, 63.0)));

/// Amounts in um: along, across, bias; and by which share of the flank their middle is shifted, over height and length.
type Ease = ([f64; 3], [f64; 2]);
const CROSSED: Arrangement = Arrangement::Crossing { shaft_angle: FRAC_PI_2 };
const NONE: Ease = ([0.0; 3], [0.0; 2]);

/// Axes at a right angle, module 5; the first gear is right-handed.
fn gears((teeth, face, spiral): Pair) -> [BevelGear; 2] {
    let angle = (f64::from(teeth[0]) / f64::from(teeth[1])).atan();
    let gear = |teeth, angle, hand| {
        let spiral = spiral.map(|(mean_angle, cutter_radius): (f64, f64)| Spiral {
            mean_angle: mean_angle.to_radians(),
            form: LineForm::Circle { radius: cutter_radius },
            hand,
        });
        let data = BevelData::new(5.0, teeth, angle, 20f64.to_radians(), face);
        BevelGear::new(BevelData { spiral, ..data }).unwrap()
    };
    [gear(teeth[0], angle, Hand::Right), gear(teeth[1], FRAC_PI_2 - angle, Hand::Left)]
}

fn ease_off((um, shift): Ease, gear: &BevelGear) -> Arc<dyn NormalOffset> {
    let shifted = |[from, to]: [f64; 2], share: f64| [from, to].map(|x| x + share * (to - from));
    let amounts =
        EaseOffAmounts { length_crowning: 1e-3 * um[0], profile_crowning: 1e-3 * um[1], bias: 1e-3 * um[2] };
    Arc::new(
        EaseOff::new(amounts, shifted(gear.heights(), shift[0]), shifted(gear.face(), shift[1])).unwrap(),
    )
}

/// Both gears with their ease-offs.
struct Rolled {
    pair: RolledPair,
    conjugate: ConjugateFlanks,
    ease: [Arc<dyn NormalOffset>; 2],
    places: FlankPlaces,
}

fn rolled(which: Pair, flank: Flank, eases: [Ease; 2]) -> Rolled {
    let gears = gears(which);
    let ease = [ease_off(eases[0], &gears[0]), ease_off(eases[1], &gears[1])];
    let gear = |k: usize| {
        let involute = SphericalInvolute::new(&gears[k], flank);
        let surface: Arc<dyn Surface> = if eases[k] == NONE {
            Arc::new(involute)
        } else {
            Arc::new(Modified::new(involute, ease[k].clone()))
        };
        RolledGear {
            surface,
            heights: gears[k].heights(),
            lengths: gears[k].face(),
            teeth: gears[k].data().teeth,
        }
    };
    let pair = RolledPair::new([gear(0), gear(1)], CROSSED, flank).unwrap();
    let places = FlankPlaces {
        heights: equidistant(gears[0].heights(), 31),
        lengths: equidistant(gears[0].face(), 41),
    };
    Rolled { pair, conjugate: ConjugateFlanks::involute(gears, flank), ease, places }
}

impl Rolled {
    fn found(&self) -> (RollCourse, GapField) {
        let course = self.pair.roll(POSITIONS).unwrap();
        let field = self.pair.field(&self.places, &course);
        (course, field)
    }

    fn said(&self) -> (RollCourse, GapField) {
        let ease = [&*self.ease[0], &*self.ease[1]];
        let course = self.conjugate.course(ease, POSITIONS);
        let field = self.conjugate.field(&self.places, ease, &course);
        (course, field)
    }
}

/// Places of the first flank whose partner lies inside the second one.
fn facing(rolled: &Rolled) -> Vec<[f64; 2]> {
    let [_, [from, to]] = rolled.conjugate.heights();
    rolled.places.iter().filter(|place| (from..=to).contains(&rolled.conjugate.partner(place[0]))).collect()
}

#[test]
fn nominal_flanks_touch_along_whole_lines_at_an_even_turn() {
    for which in [STRAIGHT, SPIRAL, TURNED] {
        for flank in Flank::BOTH {
            let rolled = rolled(which, flank, [NONE, NONE]);
            let places = facing(&rolled);
            assert!(places.len() > 500, "{}", places.len());
            for place in places {
                let roll = rolled.conjugate.roll(place);
                let gap = rolled.pair.gap(place, roll, None).expect("a partner");
                // 1e-9 mm = 1e-6 um.
                assert!((gap.angle * gap.arm).abs() <= 1e-9, "{which:?} {flank:?} {place:?}: {gap:?}");
                let [height, length] = gap.partner;
                assert!((height - rolled.conjugate.partner(place[0])).abs() < 1e-9, "{gap:?}");
                assert!((length - place[1]).abs() < 1e-9, "{gap:?}");
            }
            let (course, field) = rolled.found();
            assert!(course.peak_to_peak() < 1e-12, "{}", course.peak_to_peak());
            assert!(course.at(0.1).abs() < 1e-12);
            let least = field.gaps.iter().copied().fold(f64::INFINITY, f64::min);
            assert!(least.abs() < 1e-9, "{least}");
        }
    }
}

/// Octoids are conjugate as well: one crown gear cuts both.
#[test]
fn octoids_touch_along_lines_too() {
    let gears = gears(STRAIGHT);
    for flank in Flank::BOTH {
        let conjugate = ConjugateFlanks::octoid(gears.clone(), flank).unwrap();
        let gear = |k: usize| RolledGear {
            surface: Arc::new(Octoid::new(&gears[k], flank)) as Arc<dyn Surface>,
            heights: conjugate.heights()[k],
            lengths: gears[k].face(),
            teeth: gears[k].data().teeth,
        };
        let pair = RolledPair::new([gear(0), gear(1)], CROSSED, flank).unwrap();
        let [[from, to], _] = conjugate.heights();
        let place = [0.5 * (from + to), 70.0];
        let gap = pair.gap(place, conjugate.roll(place), None).unwrap();
        assert!((gap.angle * gap.arm).abs() <= 1e-9 && (gap.partner[1] - 70.0).abs() < 1e-9, "{gap:?}");
        assert!((gap.partner[0] - conjugate.partner(place[0])).abs() < 1e-9, "{gap:?}");
        assert!(pair.roll(POSITIONS).unwrap().peak_to_peak() < 1e-12);
    }
}

/// What is compared: name, pair, ease-offs of both gears.
const CASES: [(&str, Pair, [Ease; 2]); 8] = [
    ("straight, as the examples", STRAIGHT, [([10.0, 5.0, 0.0], [0.0; 2]); 2]),
    ("straight, shifted to the heel", STRAIGHT, [([20.0, 10.0, 0.0], [0.0, 0.2]), NONE]),
    ("straight, bias", STRAIGHT, [([20.0, 10.0, 8.0], [0.1, -0.1]), NONE]),
    ("spiral, as the examples", SPIRAL, [([10.0, 6.0, 2.0], [0.0; 2]); 2]),
    ("spiral, shifted to the heel", SPIRAL, [([20.0, 10.0, 0.0], [0.0, 0.2]), NONE]),
    ("spiral, bias", SPIRAL, [([20.0, 10.0, 8.0], [0.1, -0.1]), NONE]),
    ("spiral gear, as the examples", TURNED, [([10.0, 6.0, 2.0], [0.0; 2]); 2]),
    ("spiral gear, shifted to the toe", TURNED, [([20.0, 10.0, 0.0], [0.0, -0.2]), NONE]),
];

/// Both patterns are the same but for what the ease-off alone does not say:
/// - Beyond the edge of the mate its flank still passes at a distance d with the gap d^2/(2 rho), rho some 4 mm: 6 um of marking show
///   a band of 0.2 mm there, which no contact line reaches. It is up to 5 % of a pattern that ends at that edge.
/// - The slope f' of an ease-off moves the contact by f' rho and the gap by f'^2 rho/2, 0.05 to 0.3 um at the ends of the profile.
#[test]
fn the_rolled_pattern_is_that_of_the_ease_off() {
    for (name, which, eases) in CASES {
        for flank in Flank::BOTH {
            let rolled = rolled(which, flank, eases);
            let (found, field) = rolled.found();
            let (said, told) = rolled.said();
            let areas = rolled.places.areas(&*rolled.pair.first().surface);
            let common = overlap([&field, &told], MARKING, &areas);
            let reached = |(gap, told): (&f64, &f64)| if told.is_finite() { *gap } else { f64::INFINITY };
            let reached = GapField { gaps: field.gaps.iter().zip(&told.gaps).map(reached).collect() };
            let on_lines = overlap([&reached, &told], MARKING, &areas);
            let pattern = |field| ContactPattern::of(field, MARKING, &rolled.places, &areas).unwrap();
            let (by_roll, by_ease) = (pattern(&reached), pattern(&told));
            let about = format!(
                "{name} {flank:?}: overlap {common:.4}, where lines reach {on_lines:.4}\n{by_roll:?}\n{by_ease:?}"
            );
            assert!(common >= 0.94 && on_lines >= 0.98, "{about}");
            for axis in 0..2 {
                assert!((by_roll.centre[axis] - by_ease.centre[axis]).abs() < 0.005, "{about}");
                for end in 0..2 {
                    assert!((by_roll.ends[axis][end] - by_ease.ends[axis][end]).abs() < 0.01, "{about}");
                }
            }
            for (gap, other) in reached.gaps.iter().zip(&told.gaps).filter(|(_, other)| **other <= MARKING) {
                assert!((gap - other).abs() < 3.5e-4, "{about}\n{gap} and {other}");
            }
            let [is, wanted] = [found.peak_to_peak(), said.peak_to_peak()];
            assert!((is / wanted - 1.0).abs() < 0.05 && wanted > 1e-5, "{about}\n{is:e} and {wanted:e}");
        }
    }
}

/// Where the amounts are shifted to, the pattern is; bias turns it.
#[test]
fn the_pattern_follows_the_ease_off() {
    let centre = |eases: [Ease; 2]| {
        let rolled = rolled(SPIRAL, Flank::Left, eases);
        let (_, field) = rolled.found();
        let areas = rolled.places.areas(&*rolled.pair.first().surface);
        ContactPattern::of(&field, MARKING, &rolled.places, &areas).unwrap().centre
    };
    let along = |share: f64| centre([([30.0, 10.0, 0.0], [0.0, share]), NONE])[1];
    let [toe, middle, heel] = [-0.2, 0.0, 0.2].map(along);
    assert!(
        (middle - 0.5).abs() < 0.03 && (heel - 0.7).abs() < 0.03 && (toe - 0.3).abs() < 0.03,
        "{toe} {middle} {heel}"
    );
    let mate = centre([NONE, ([30.0, 10.0, 0.0], [0.0, 0.2])])[1];
    assert!((mate - heel).abs() < 0.02, "the mate's ease-off counts as the gear's: {mate} {heel}");
}

/// The least gap is that of a dense search without any refinement.
#[test]
fn no_place_comes_nearer_than_the_least_gap() {
    let rolled = rolled(SPIRAL, Flank::Right, [([20.0, 10.0, 6.0], [0.1, -0.1]), NONE]);
    let course = rolled.pair.roll(POSITIONS).unwrap();
    let gear = rolled.pair.first();
    let (heights, lengths) = (equidistant(gear.heights, 400), equidistant(gear.lengths, 41));
    for roll in [-0.3, 0.0, 0.2] {
        let mut least = f64::INFINITY;
        for pair in -2..=2 {
            let roll = roll + f64::from(pair) * rolled.pair.pitch();
            for length in &lengths {
                let mut start = None;
                for height in &heights {
                    let gap = rolled.pair.gap([*height, *length], roll, start);
                    start = gap.map(|gap| gap.partner);
                    least = least.min(gap.map_or(f64::INFINITY, |gap| gap.angle));
                }
            }
        }
        // Between places 0.02 mm apart the gap falls by 0.02^2/8/4 mm, between positions it is linear: 0.1 um at a radius of 70 mm.
        let off = least - course.at(roll);
        assert!(off.abs() < 1.5e-6, "{roll}: {least:e} {:e}", course.at(roll));
    }
}

#[test]
fn what_cannot_be_rolled_is_refused() {
    let good = rolled(STRAIGHT, Flank::Left, [NONE, NONE]);
    let told = |error: contact::ContactError, code: &str| {
        assert_eq!(error.code(), code, "{error}");
        assert!(!error.way_out().is_empty());
    };
    told(good.pair.roll(0).unwrap_err(), "invalid-number");
    let gear = good.pair.first().clone();
    let pair =
        |gears, shaft_angle| RolledPair::new(gears, Arrangement::Crossing { shaft_angle }, Flank::Left);
    for angle in [0.0, 3.2, f64::NAN] {
        told(pair([gear.clone(), gear.clone()], angle).unwrap_err(), "invalid-number");
    }
    let none = RolledGear { teeth: 0, ..gear.clone() };
    told(pair([gear.clone(), none], FRAC_PI_2).unwrap_err(), "invalid-number");
    let endless = RolledGear { lengths: [0.0, f64::INFINITY], ..gear.clone() };
    told(pair([endless, gear.clone()], FRAC_PI_2).unwrap_err(), "invalid-number");
    let apart = Arrangement::Outside { centre_distance: 0.0 };
    told(RolledPair::new([gear.clone(), gear.clone()], apart, Flank::Left).unwrap_err(), "invalid-number");
    // Far from the apex nothing of the mate is left.
    let far = RolledGear { lengths: [500.0, 520.0], ..gear.clone() };
    told(pair([gear, far], FRAC_PI_2).unwrap().roll(POSITIONS).unwrap_err(), "flanks-do-not-mesh");
}
