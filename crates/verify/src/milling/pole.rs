//! Block `pole`: paths across the pole and past it.

use super::super::given::{check_block, check_object, compare_pairs, text, tolerance, vectors};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::chain::{Places, chain};
use super::rotary::{degrees, place};
use foundation::kinematics::Pose;
use machine::Positions;
use motion::milling::{MillingSetup, PoleStrategy, choose, smoothness};
use nalgebra::Vector3;
use serde_json::Value;

/// Block `pole`.
pub(crate) fn pole(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("pole", block, ledger, |expected, ledger| {
        let machine = chain(text(expected, "chain", ledger)?, &Places::default())?;
        let setup = MillingSetup::new(&machine, Pose::identity(), 0.0)?;
        let deg = tolerance(expected, "tolerance_deg", ledger);
        for key in ["through_pole", "near_pole"] {
            let Some(path) = expected.object(key, ledger) else { continue };
            check_object(path, ledger, |path, ledger| {
                let axes = vectors(path, "axis")?;
                let places: Vec<_> = axes.into_iter().map(|axis| place(Vector3::zeros(), axis)).collect();
                let course = choose(&setup, &places, &Positions::default(), PoleStrategy::Slow)?;
                let angles: Vec<[f64; 2]> = course.nodes.iter().map(|at| degrees(&setup, at)).collect();
                compare_pairs(path, "CA_deg", &angles, deg, ledger);
                let figures = smoothness(&setup, &course.places, &course.nodes);
                let travel = figures.rotary.map(|change| change.travel.to_degrees());
                path.list("rotary_travel_deg", &travel, deg, ledger);
                Ok(())
            });
        }
        Ok(())
    });
}
