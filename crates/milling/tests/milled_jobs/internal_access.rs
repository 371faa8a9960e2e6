//! Tools that have room in an internal gear, and tools that do not.

use super::job;
use foundation::geometry::Flank;
use milling::workflow::prepare_milling;
use milling::{MillingError, plan};

/// The internal ring of the examples with few rows and columns and edges of this length, and what is behind them.
fn planned(edges: f64, shank: &str) -> Result<(), MillingError> {
    let text = include_str!("../../../../examples/milling/internal-ring.toml");
    let text = text.replace("cutting_length = 12.0", &format!("cutting_length = {edges:?}\n{shank}"));
    let text = text.replace("rows = 30", "rows = 4").replace("columns = 11", "columns = 4");
    let bodies = prepare_milling(&job(&text)).unwrap().bodies;
    plan(&bodies.parts[0], &bodies.options).map(|_| ())
}

#[test]
fn a_holder_must_end_before_the_teeth_on_the_other_side() {
    planned(200.0, "").unwrap();
    match planned(250.0, "") {
        // The first column stands beside the ring.
        Err(MillingError::InternalAccess { side, row: 0, column: 1, free, needed }) => {
            assert_eq!(side.flank, Flank::Left);
            // From a tip at a radius of some 122 mm across a tip circle of 116 mm.
            assert!(free > 225.0 && free < 240.0, "{free}");
            assert_eq!(needed, 250.0);
        }
        other => panic!("{other:?}"),
    }
    // A holder has no end of its own: what holds it is behind it.
    let holder = "shank = [{ diameter = 2.0, from = 12.0 }, { diameter = 20.0, from = 200.0 }]";
    match planned(12.0, holder) {
        Err(MillingError::RingMet { side, row: 0, column: 0 | 1, from, wanted, .. }) => {
            assert_eq!((side.flank, from, wanted), (Flank::Left, "teeth of the ring", 0.1));
        }
        other => panic!("{other:?}"),
    }
}
