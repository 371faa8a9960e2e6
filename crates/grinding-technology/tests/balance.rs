//! What goes in comes out: volumes, rates over a stroke, the load of the worm; and the parabola of the gap against the exact one.

use crate::bodies::{axes, helical, spur, stroke, uneven};
use foundation::geometry::{Flank, Sides};
use grinding_technology::{Cycle, Direction, Stock, StockField, StockMap, exact_gap, hob_mark_height};

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

/// A table over flank and face, every space its own: what goes in comes out, and the volume of an amount that is linear in both is known.
#[test]
fn stock_of_a_table_is_balanced() {
    let bodies = helical();
    let spaces = bodies.teeth() as usize;
    let maps = Sides::from_fn(|flank| {
        let [from, to] = bodies.flanks[flank].roll;
        let w: Vec<f64> = (0..9).map(|k| from + (to - from) * f64::from(k) / 8.0).collect();
        let z: Vec<f64> = (0..13).map(|k| bodies.face_width * (f64::from(k) / 12.0 - 0.5)).collect();
        let of_space = |space: usize| -> Vec<f64> {
            let own = 0.01 * (space as f64 * 0.7).sin();
            let at = |w: f64, z: f64| 0.1 + own + 0.004 * (w - from) + 0.0005 * z;
            w.iter().flat_map(|&w| z.iter().map(move |&z| at(w, z))).collect()
        };
        Some(StockMap::new(w.clone(), z.clone(), (0..spaces).map(of_space).collect()).unwrap())
    });
    let stock = Stock { map: maps, ..Stock::constant(Sides::both(0.0)) };
    let field = StockField::new(stock, &bodies).unwrap();
    let strokes = vec![stroke(0.03, 0.0, Direction::Up), stroke(0.0, -1.9, Direction::Down)];
    let cycle = Cycle::new(bodies, field, strokes).unwrap();
    // Integral of J (c + g (w - from)), J = w/(r_b cos beta_b), over profile and face; the slope along the face adds nothing.
    let own: f64 = (0..spaces).map(|space| 0.01 * (space as f64 * 0.7).sin()).sum();
    let want: f64 = Flank::BOTH
        .iter()
        .map(|&flank| {
            let engagement = &cycle.bodies.flanks[flank];
            let ([a, b], work) = (engagement.roll, engagement.work());
            let (area, moment) =
                (0.5 * (b * b - a * a), (b.powi(3) - a.powi(3)) / 3.0 - 0.5 * a * (b * b - a * a));
            let by = cycle.bodies.face_width / (work.base_radius * work.base_helix_angle.cos());
            by * ((0.1 * spaces as f64 + own) * area + 0.004 * spaces as f64 * moment)
        })
        .sum();
    // The rule between the places of the table leaves some 1e-6.
    assert!((cycle.stock_volume() / want - 1.0).abs() < 1e-5, "{} for {want}", cycle.stock_volume());
    for k in 0..2 {
        let off = removed(&cycle, k, 200) / cycle.strokes[k].volume - 1.0;
        assert!(off.abs() < 1e-4, "stroke {k}: {off:e}");
    }
}

/// The hob as worm: marks grow with the square of the feed and are lower for a larger hob.
#[test]
fn marks_of_a_hob_follow_from_the_hob() {
    let bodies = helical();
    let height = |tip: f64, threads: i32, feed: f64| hob_mark_height(&bodies, (threads, tip), feed).unwrap();
    let one = height(80.0, 1, 2.0);
    assert!((height(80.0, 1, 4.0) / one - 4.0).abs() < 1e-9);
    assert!(height(160.0, 1, 2.0) < 0.6 * one, "{} of {one}", height(160.0, 1, 2.0));
    // Of about the height f^2 sin(alpha)/(4 d) of the textbooks for a spur gear; a helical one has the contact askew.
    let textbook = 4.0 * 20f64.to_radians().sin() / (4.0 * 80.0);
    assert!(one > 0.5 * textbook && one < 2.0 * textbook, "{one} {textbook}");
    assert!(
        hob_mark_height(&bodies, (9, 8.0), 2.0).is_err() && hob_mark_height(&bodies, (1, 80.0), 0.0).is_err()
    );
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
