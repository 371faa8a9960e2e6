//! Bad input: the field, its value, what is allowed.

use crate::bodies::{axes, spur, stroke};
use foundation::geometry::Sides;
use grinding_technology::{Cycle, Direction, Shift, Stock, StockField, Stroke, TechnologyError};

fn refused(strokes: Vec<Stroke>) -> TechnologyError {
    let bodies = spur();
    let stock = StockField::new(Stock::constant(Sides::both(0.08)), &bodies).unwrap();
    Cycle::new(bodies, stock, strokes).unwrap_err()
}

#[test]
fn strokes_fall_to_nothing() {
    let rising = refused(vec![stroke(0.02, 0.0, Direction::Up), stroke(0.05, 0.0, Direction::Up)]);
    assert_eq!(rising.code(), "stroke-order");
    assert!(rising.to_string().contains("stroke 2 leaves 50 um"), "{rising}");
    let short = refused(vec![stroke(0.02, 0.0, Direction::Up)]);
    assert_eq!(short.code(), "stroke-order");
    assert!(!short.way_out().is_empty());
}

#[test]
fn numbers_name_their_field() {
    for (spoil, field) in [
        ((|s: &mut Stroke| s.feed_per_revolution = 0.0) as fn(&mut Stroke), "feed_per_revolution"),
        (|s| s.cutting_speed = -1.0, "cutting_speed_m_per_s"),
        (|s| s.overrun = f64::NAN, "overrun"),
        (|s| s.left.left = -0.01, "left_um"),
        (|s| s.shift = Shift::straight(f64::INFINITY, 0.0), "shift.ratio"),
    ] {
        let mut spoiled = stroke(0.0, 0.0, Direction::Up);
        spoil(&mut spoiled);
        let error = refused(vec![spoiled]);
        let TechnologyError::OutOfRange { field: named, .. } = &error else { panic!("{error}") };
        assert!(named.ends_with(field), "{named}");
    }
    let mut no_jerk = axes();
    no_jerk.z.jerk = 0.0;
    let bodies = spur();
    let stock = StockField::new(Stock::constant(Sides::both(0.08)), &bodies).unwrap();
    let cycle = Cycle::new(bodies, stock, vec![stroke(0.0, 0.0, Direction::Up)]).unwrap();
    assert!(cycle.times(&no_jerk, 15.0).unwrap_err().to_string().contains("axes.Z.jerk = 0"));
}

#[test]
fn lists_of_spaces_are_whole() {
    let stock = Stock {
        pitch: Some(Sides { left: vec![0.0; 40], right: vec![0.0; 39] }),
        ..Stock::constant(Sides::both(0.08))
    };
    let error = StockField::new(stock, &spur()).unwrap_err();
    assert!(error.to_string().contains("stock.pitch_um.right = 39"), "{error}");
    assert!(error.to_string().contains("40 values"), "{error}");
}
