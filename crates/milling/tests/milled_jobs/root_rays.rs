//! The drawn root under the referee's rays.

use super::job;
use foundation::numerics::Silent;
use milling::workflow::{prepare_milling, referee_root};
use milling::{OperationKind, plan};

/// Sections along the face.
const SECTIONS: usize = 5;

fn spur() -> String {
    let text = include_str!("../../../../examples/milling/spur-module-8.toml");
    let (from, to) = (text.find("[milling.roughing]").unwrap(), text.find("[simulation]").unwrap());
    format!("{}{}", &text[..from], &text[to..]).replace("rows = 14", "rows = 5")
}

fn helical() -> String {
    let text = include_str!("../../../../examples/milling/helical-module-6.toml");
    text.replace("rows = 14", "rows = 4").replace("columns = 49", "columns = 25")
}

/// A straight bevel gear with a pass of the root.
fn bevel() -> String {
    let text = include_str!("../../../../examples/milling/straight-bevel-16.toml");
    let root = "[milling.root]\nbottom = 0.0\n\n[bottom_cutter]\nshape = \"end-mill\"\ndiameter = 1.0\ncorner_radius = 0.4\n\
                cutting_length = 8.0\n\n[simulation]";
    text.replace("[simulation]", root)
        .replace("diameter = 2.4", "diameter = 1.6")
        .replace("corner_radius = 0.5", "corner_radius = 0.4")
        .replace("rows = 14", "rows = 4")
        .replace("contact_height = { from = 2.1, to = 3.0 }", "contact_height = 1.5")
        .replace("face_width = 20.0", "face_width = 20.0\nstart_polar_angle_deg = 32.164839")
}

/// Fillets of a spur gear are the drawn ones; elsewhere they leave them by no more than the given um. Every ray is milled, and as was
/// predicted.
#[test]
fn rays_find_the_drawn_root() {
    for (name, text, um) in [("spur", spur(), 1e-6), ("helical", helical(), 3.0), ("bevel", bevel(), 6.7)] {
        let bodies = prepare_milling(&job(&text)).unwrap().bodies;
        let made = plan(&bodies.parts[0], &bodies.options).unwrap_or_else(|error| panic!("{name}: {error}"));
        let root = referee_root(&bodies, &made, SECTIONS, &Silent).unwrap();
        let names: Vec<String> = root.iter().map(|part| part.name()).collect();
        assert_eq!(names, ["left_fillet", "right_fillet", "bottom"], "{name}");
        for part in &root {
            assert!(part.unmilled.is_empty(), "{name} {}: {:?}", part.name(), part.unmilled);
            assert_eq!(part.points.len() % SECTIONS, 0);
            for (found, planned) in part.simulated.iter().zip(&part.predicted) {
                let (found, planned) = (found.unwrap(), planned.unwrap());
                assert!((found - planned).abs() < 2e-8, "{name} {}: {found} {planned}", part.name());
                assert!(part.name() == "bottom" || found.abs() < 1e-3 * um, "{name}: {found}");
            }
        }
        // Between the passes of the bottom their corners leave a roof.
        let roof = root[2].simulated.iter().flatten().fold(0.0, |most: f64, mm| most.max(*mm));
        assert!(roof > 1e-3 && roof < 0.1, "{name}: {roof}");
    }
}

/// The cutter that clears the space keeps its allowance from the fillets and the straight pieces above them.
#[test]
fn clearing_leaves_the_fillets_alone() {
    let text = spur() + "\n[milling.roughing]\nallowance = 0.3\nstep_down = 3.0\nstep_over = 2.0\n";
    let bodies = prepare_milling(&job(&text)).unwrap().bodies;
    let made = plan(&bodies.parts[0], &bodies.options).unwrap();
    assert!(made.layers.iter().any(|layer| !layer.passes.is_empty()));
    for part in referee_root(&bodies, &made, SECTIONS, &Silent).unwrap().iter().take(2) {
        for found in part.simulated.iter().flatten() {
            assert!(found.abs() < 1e-9, "{}: {found}", part.name());
        }
    }
    // The clearing alone: nothing of its allowance is missing.
    let mut cleared = made;
    cleared.operations.truncate(1);
    for part in referee_root(&bodies, &cleared, SECTIONS, &Silent).unwrap().iter().take(2) {
        for found in part.simulated.iter().flatten() {
            assert!(*found > 0.299, "{}: {found}", part.name());
        }
    }
}

/// With one row of one flank only, most of the root is not reached; no ray is forgotten.
#[test]
fn what_no_cutter_meets_is_counted() {
    let bodies = prepare_milling(&job(&spur())).unwrap().bodies;
    let mut made = plan(&bodies.parts[0], &bodies.options).unwrap();
    made.operations.retain(|operation| matches!(operation.kind, OperationKind::Flank(_)));
    made.operations.truncate(1);
    made.operations[0].paths.truncate(1);
    let root = referee_root(&bodies, &made, SECTIONS, &Silent).unwrap();
    let mut unmilled = 0;
    for part in &root {
        let missed: usize = part.unmilled.iter().map(|(_, count)| count).sum();
        assert_eq!(missed + part.simulated.iter().flatten().count(), part.points.len());
        unmilled += missed;
    }
    assert!(unmilled > 100, "{unmilled}");
}
