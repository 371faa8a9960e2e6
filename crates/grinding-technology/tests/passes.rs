//! Strokes on one flank by itself, and shifts that are not straight.

use crate::bodies::{axes, helical, spur, stroke, uneven};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::MotionLaw;
use grinding_technology::{Bodies, Cycle, Direction, Ground, Shift, Stock, StockField, Stroke};

fn cycle(bodies: &Bodies, stock: Stock, strokes: Vec<Stroke>) -> Cycle {
    Cycle::new(bodies.clone(), StockField::new(stock, bodies).unwrap(), strokes).unwrap()
}

fn strokes(ground: Ground) -> [Stroke; 2] {
    [0.02, 0.0].map(|left| Stroke { ground, ..stroke(left, -1.9, Direction::Up) })
}

/// Flanks that are ground one after the other lose what they lose together, from the same places of the worm but for the infeed.
#[test]
fn flanks_one_after_the_other_lose_what_they_lose_together() {
    let bodies = helical();
    let both = cycle(&bodies, uneven(), strokes(Ground::Both).to_vec());
    let apart: Vec<Stroke> = Flank::BOTH.into_iter().flat_map(|flank| strokes(Ground::Only(flank))).collect();
    let apart = cycle(&bodies, uneven(), apart);
    for k in 0..2 {
        let sum = apart.strokes[k].volume + apart.strokes[k + 2].volume;
        assert!((sum / both.strokes[k].volume - 1.0).abs() < 1e-12);
        let [left, right] = [0, 2].map(|pass| &apart.strokes[k + pass]);
        assert_eq!(left.flanks.right.deepest, 0.0);
        assert_eq!(right.flanks.left.deepest, 0.0);
        assert_eq!(left.flanks.left.deepest, both.strokes[k].flanks.left.deepest);
        // A stroke on one flank begins and ends where that flank does.
        assert!(left.travel < both.strokes[k].travel + 1e-9);
    }
    // The last strokes stand where those on both flanks do.
    let (one, together) = (&apart.strokes[1], &both.strokes[1]);
    assert_eq!(one.infeed.delta_d, 0.0);
    assert_eq!(one.flanks.left.contact_length, together.flanks.left.contact_length);
    let feeds =
        [0.3, 0.5, 0.7].map(|at| together.contact[0] + at * (together.contact[1] - together.contact[0]));
    let sum: Vec<f64> =
        apart.rates(1, &feeds).iter().zip(apart.rates(3, &feeds)).map(|(left, right)| left + right).collect();
    for (sum, together) in sum.iter().zip(both.rates(1, &feeds)) {
        assert!((sum / together - 1.0).abs() < 1e-9);
    }
    assert!(apart.times(&axes(), 15.0).unwrap().len() == 4);
}

/// One flank alone stands off by the centre distance, and nothing is ground on the other.
#[test]
fn one_flank_alone_leaves_the_other() {
    let bodies = spur();
    let alone =
        cycle(&bodies, Stock::constant(Sides::both(0.08)), strokes(Ground::Only(Flank::Right)).to_vec());
    let figures = &alone.strokes[0];
    let sine = bodies.flanks.right.pair.operating_alpha_n.sin();
    assert!((figures.infeed.delta_d - 0.02 / sine).abs() < 1e-15 && figures.infeed.delta_phi_2 == 0.0);
    let volume = 0.08 * bodies.flanks.right.area() * bodies.teeth();
    let ground: f64 = alone.strokes.iter().map(|figures| figures.volume).sum();
    assert!((ground / volume - 1.0).abs() < 1e-12);
    assert!(alone.wear().after(1).left.largest() == 0.0);
}

/// V'_w of a shift whose ratio varies is M a_e/|F'| where the whole depth goes at one place, as on a spur gear.
#[test]
fn a_shift_that_bends_spreads_the_load_by_its_slope() {
    let bodies = spur();
    let (depth, linear, bend) = (0.05, -2.0, -0.03);
    let law = MotionLaw::polynomial(0.0, vec![0.0, linear, bend]);
    let finishing = |shift: Shift| Stroke { shift, ..stroke(0.0, 0.0, Direction::Up) };
    let of = |shift: Shift| cycle(&bodies, Stock::constant(Sides::both(depth)), vec![finishing(shift)]);
    let bent = of(Shift { law: law.clone(), step_per_part: 0.0 });
    let wear = bent.wear();
    let map = &wear.after(1).left;
    let (engagement, station) = (&bodies.flanks.left, 4);
    let factor = engagement.wear_factor(engagement.stations()[station]);
    // The section of the whole tooth is spread, however it is spread: 1/32 mm is the resolution.
    let [from, to] = map.ends();
    let sum: f64 = (from..to).map(|bin| map.value(station, bin)).sum();
    let whole = factor * depth * bodies.face_width;
    assert!((sum / whole - 1.0).abs() < 2e-5, "{sum} of {whole}");
    // z = 0 is ground at v = C_c2, there z_1 = C_c1 - F(v) - s tan(b_1) w_1; the place of the bin tells v by the law itself.
    let at_slope = |v: f64| factor * depth / (linear + 2.0 * bend * v).abs();
    let middle = bent.strokes[0].flanks.left.raised[1];
    let densities: Vec<f64> = (-6..=6).map(|k| at_slope(middle + f64::from(k))).collect();
    let found: Vec<f64> = (from..to).map(|bin| map.value(station, bin)).collect();
    for density in densities {
        let nearest = found.iter().map(|value| (value / density - 1.0).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest < 0.02, "{density} is in no bin: {nearest}");
    }
    // A law that bends by nothing is a straight one.
    let pieces = MotionLaw::broken_line(&[-100.0, 0.0, 100.0], &[200.0, 0.0, -200.0]).unwrap();
    let [piecewise, straight] =
        [Shift { law: pieces, step_per_part: 0.0 }, Shift::straight(linear, 0.0)].map(of);
    let [piecewise, straight] = [&piecewise, &straight].map(|cycle| cycle.wear().after(1).left);
    assert_eq!(piecewise.ends(), straight.ends());
    let [from, to] = straight.ends();
    for bin in from..to {
        let [a, b] = [&piecewise, &straight].map(|map| map.value(station, bin));
        assert!((a - b).abs() < 1e-3 * straight.largest(), "{a} {b}");
    }
}
