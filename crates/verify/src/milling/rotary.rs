//! Blocks `inverse_kinematics` and `linear_axes`: both solutions of the rotary axes, and the slides for given angles.

use super::super::given::{array, check_block, check_items, compare_vector, number, text, tolerance, vector};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::chain::{Places, chain};
use foundation::kinematics::{Direction, Point, Pose};
use machine::{AxisSolutions, MachineError, Positions};
use motion::milling::{CutterPlace, MillingSetup};
use nalgebra::Vector3;
use serde_json::Value;

/// A cutter at a tip with an axis; the contact is of no interest.
pub(super) fn place(tip: Vector3<f64>, axis: Vector3<f64>) -> CutterPlace {
    CutterPlace {
        contact: Point::from_vector(tip),
        tip: Point::from_vector(tip),
        axis: Direction::from_vector(axis),
    }
}

/// Angles of C and tilt, deg.
pub(super) fn degrees(setup: &MillingSetup<'_>, at: &Positions) -> [f64; 2] {
    setup.axes().rotary.map(|axis| at[axis].to_degrees())
}

/// Block `inverse_kinematics`.
pub(crate) fn inverse_kinematics(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("inverse_kinematics", block, ledger, |expected, ledger| {
        super::super::given::requires(
            expected,
            "order",
            &["[first rotary (C), second rotary (tilt)]"],
            ledger,
        )?;
        let deg = tolerance(expected, "tolerance_deg", ledger);
        check_items(expected, "items", ledger, |item, ledger| {
            let machine = chain(text(item, "chain", ledger)?, &Places::default())?;
            let setup = MillingSetup::new(&machine, Pose::identity(), 0.0)?;
            let axis = vector(item, "axis", ledger)?;
            let found = match setup.solutions(&place(Vector3::zeros(), axis)) {
                Ok(AxisSolutions::Positions(found)) => found,
                Ok(AxisSolutions::Pole { .. }) => return Err("the axis stands at the pole".into()),
                Err(MachineError::Unreachable { .. }) => Vec::new(),
                Err(error) => return Err(error.into()),
            };
            let found: Vec<f64> = found.iter().flat_map(|at| degrees(&setup, at)).collect();
            let name = item.name("solutions_deg");
            let rows = found.len() / 2;
            let Some(wanted) = item.take_table("solutions_deg", [rows, 2], ledger) else { return Ok(()) };
            if rows == 0 {
                ledger.equal(item.case(), &name, Value::Array(Vec::new()), Value::Array(Vec::new()));
            }
            for (k, (wanted, found)) in wanted.into_iter().zip(found).enumerate() {
                let name = format!("{name}[{}][{}]", k / 2, k % 2);
                let wanted = wanted.as_f64().unwrap_or(f64::NAN);
                ledger.periodic((item.case(), &name), wanted, found, 360.0, deg);
            }
            Ok(())
        })
    });
}

/// Block `linear_axes`.
pub(crate) fn linear_axes(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("linear_axes", block, ledger, |expected, ledger| {
        let mm = tolerance(expected, "tolerance_mm", ledger);
        check_items(expected, "items", ledger, |item, ledger| {
            let name = text(item, "chain", ledger)?;
            let tip = vector(item, "tip_table_mm", ledger)?;
            let wanted: [f64; 2] = array(item, "theta_deg", ledger)?;
            let places = Places {
                points: [vector(item, "q1_mm", ledger)?, vector(item, "q2_mm", ledger)?],
                pivot: number(item, "pivot_to_tip_mm", ledger)?,
                speeds: None,
            };
            let machine = chain(name, &places)?;
            let setup = MillingSetup::new(&machine, Pose::identity(), 0.0)?;
            let mut turned = Positions::default();
            for (axis, angle) in setup.axes().rotary.into_iter().zip(wanted) {
                turned[axis] = angle.to_radians();
            }
            let (_, axis) = setup.stands(&turned)?;
            compare_vector(item, "axis_of_theta", &axis.xyz, mm, ledger);
            let AxisSolutions::Positions(found) = setup.solutions(&place(tip, axis.xyz))? else {
                return Err("the axis stands at the pole".into());
            };
            let off = |at: &Positions| -> f64 {
                let apart = |k: usize| (degrees(&setup, at)[k] - wanted[k]) / 360.0;
                (0..2).map(|k| (apart(k) - apart(k).round()).abs()).sum()
            };
            let nearest = found.iter().min_by(|a, b| off(a).total_cmp(&off(b))).ok_or("no solution")?;
            let slides = Vector3::from(setup.axes().linear.map(|axis| nearest[axis]));
            compare_vector(item, "XYZ_mm", &slides, mm, ledger);
            Ok(())
        })
    });
}
