//! What goes in comes out: volumes, rates over a stroke, the load of the worm; and the parabola of the gap against the exact one.

use crate::bodies::{axes, helical, spur, stroke, uneven};
use foundation::geometry::{Flank, Sides};
use grinding_technology::{Cycle, Direction, Stock, StockField, exact_gap};

fn cycle(uneven_stock: bool, direction: Direction) -> Cycle {
    let bodies = helical();
    let stock = if uneven_stock { uneven() } else { Stock::constant(Sides::both(0.1)) };
    let stock = StockField::new(stock, &bodies).unwrap();
    let strokes = vec![stroke(0.03, 0.0, direction), stroke(0.0, -1.9, direction)];
    Cycle::new(bodies, stock, strokes).unwrap()
}

/// Simpson's rule over a stroke.
fn removed(cycle: &Cycle, k: usize, intervals: usize) -> f64 {
    let [first, last] = cycle.strokes[k].contact;
    let at = |i: usize| first + (last - first) * i as f64 / intervals as f64;
    let weight = |i: usize| match i {
        0 => 1.0,
        i if i == intervals => 1.0,
        i if i % 2 == 1 => 4.0,
        _ => 2.0,
    };
    let sum: f64 = (0..=intervals).map(|i| weight(i) * cycle.rate(k, at(i))).sum();
    sum * (last - first).abs() / (3.0 * intervals as f64) / cycle.strokes[k].feed
}

#[test]
fn a_stroke_takes_what_stood_there() {
    for direction in [Direction::Up, Direction::Down] {
        let cycle = cycle(false, direction);
        let area = cycle.bodies.flanks.left.area() + cycle.bodies.flanks.right.area();
        assert!((cycle.stock_volume() - 19.0 * 0.1 * area).abs() < 1e-9);
        for k in 0..2 {
            let off = removed(&cycle, k, 400) / cycle.strokes[k].volume - 1.0;
            assert!(off.abs() < 1e-6, "constant stock, stroke {k}: {off:e}");
        }
    }
}

#[test]
fn uneven_stock_is_balanced_too() {
    let cycle = cycle(true, Direction::Up);
    let strokes: f64 = cycle.strokes.iter().map(|figures| figures.volume).sum();
    assert!((strokes / cycle.stock_volume() - 1.0).abs() < 1e-6, "the last stroke leaves nothing");
    for k in 0..2 {
        let off = removed(&cycle, k, 200) / cycle.strokes[k].volume - 1.0;
        assert!(off.abs() < 1e-4, "stroke {k}: {off:e}");
    }
}

#[test]
fn the_worm_loses_what_the_workpiece_loses() {
    // V'_w over width and profile: each station has taken M times the section that the spaces lost there.
    for uneven in [false, true] {
        let cycle = cycle(uneven, Direction::Up);
        let level: Vec<f64> = cycle
            .level(&grinding_technology::ZoneLimits {
                zone_width: 100.0,
                zone_gap: 0.0,
                allowed_roughing: 1.0,
                allowed_finishing: 1.0,
            })
            .wear_per_part
            .iter()
            .map(|(_, wear)| *wear)
            .collect();
        let maps = cycle.wear().after(3);
        let taken =
            |flank: Flank| maps[flank].removed.iter().map(|row| row.iter().sum::<f64>()).fold(0.0, f64::max);
        let most = f64::max(taken(Flank::Left), taken(Flank::Right));
        assert!((most / (3.0 * level[0]) - 1.0).abs() < 1e-3, "{most} for {}", 3.0 * level[0]);
    }
}

#[test]
fn a_long_diagonal_stroke_loads_the_worm_evenly() {
    // Plateau of a stroke with shift: V'_w = M a_e/|K|.
    let bodies = helical();
    let stock = StockField::new(Stock::constant(Sides::both(0.05)), &bodies).unwrap();
    let cycle = Cycle::new(bodies, stock, vec![stroke(0.0, -1.9, Direction::Up)]).unwrap();
    let map = &cycle.wear().after(1).left;
    for (w, row) in cycle.bodies.flanks.left.stations().into_iter().zip(&map.removed) {
        let plateau = cycle.bodies.flanks.left.wear_factor(w) * 0.05 / 1.9;
        let largest = row.iter().copied().fold(0.0, f64::max);
        assert!((largest / plateau - 1.0).abs() < 1e-3, "{largest} for {plateau}");
    }
}

#[test]
fn the_parabola_is_near_the_exact_gap() {
    for bodies in [helical(), spur()] {
        for flank in Flank::BOTH {
            for (i, w) in bodies.flanks[flank].stations().into_iter().enumerate().skip(2) {
                for ahead in [-1.0, 0.5, 2.0] {
                    let parabola = 0.5 * bodies.flanks[flank].gap_curvature(w) * ahead * ahead;
                    let exact = exact_gap(&bodies, flank, w, ahead).unwrap();
                    assert!((exact / parabola - 1.0).abs() < 0.03, "{flank} {i} {ahead}: {exact} {parabola}");
                }
            }
        }
    }
}

#[test]
fn spark_out_takes_nothing_and_costs_time() {
    let bodies = spur();
    let stock = StockField::new(Stock::constant(Sides::both(0.08)), &bodies).unwrap();
    let strokes = vec![stroke(0.0, 0.0, Direction::Up), stroke(0.0, 0.0, Direction::Down)];
    let cycle = Cycle::new(bodies, stock, strokes).unwrap();
    assert_eq!(cycle.strokes[1].volume, 0.0);
    assert_eq!(cycle.rate(1, 0.0), 0.0);
    let times = cycle.times(&axes(), 15.0).unwrap();
    assert!(times[1].total > 10.0, "{}", times[1].total);
    // The contact of a stroke that takes nothing begins at the contact lines.
    assert!(cycle.strokes[1].approach < 1e-12 && cycle.strokes[0].approach > 5.0);
}

#[test]
fn results_do_not_depend_on_the_number_of_threads() {
    let pool = |threads: usize| rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    let run = || {
        let cycle = cycle(true, Direction::Down);
        (cycle.stock_volume(), cycle.rate(0, -3.0), cycle.wear().after(2))
    };
    assert_eq!(pool(1).install(run), pool(3).install(run));
}
