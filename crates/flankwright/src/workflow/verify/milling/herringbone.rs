//! Block `herringbone`: how near to the middle of a double helical gear a cutter gets (spec 50 section 1.5).

use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::{Body, MilledCase, located};
use super::cutter::{EDGES, of_shape};
use super::cylinder_cases::side;
use super::given::{Checked, check_block, check_items, number, text, tolerance};
use crate::geometry::{Cutter, CutterShape, Mirrored};
use crate::process::milling::{ActiveFlank, Column, ColumnPlane, LeadCurve, Patch, lead_range};
use serde_json::Value;

/// What follows the name of the case.
const HALVES: &str = ", half z < 0; other half mirrored in z = 0";

/// Halvings of the way from the end of the face to the middle: 1e-12 of it.
const HALVINGS: usize = 40;

/// One row of the half z < 0.
struct HalfRow<'a> {
    flank: &'a ActiveFlank,
    lead: &'a dyn LeadCurve,
    cutter: &'a Cutter,
    row: f64,
    contact_height: f64,
}

impl HalfRow<'_> {
    /// z of the contact in the column at u, and how far the cutter stays away from the same flank of the other half.
    fn at(&self, u: f64) -> Checked<[f64; 2]> {
        let plane = ColumnPlane::new(self.flank, self.lead.at(u)?);
        let column = Column::at_heights(self.flank, &plane, &[self.row])?;
        let place = &column.places[0];
        let location = located(place, &column.lead, self.cutter, self.contact_height, 0.0)?;
        let other = Mirrored::new(self.flank.surface.clone(), 0.0);
        let [root, tip] = self.flank.height_span();
        let patch = Patch {
            surface: &other,
            heights: [root.min(tip), root.max(tip)],
            lengths: [0.0, self.flank.face[1]],
            turn: 0.0,
        };
        let clearance = patch.clearance(self.cutter, &location.tip, &location.axis);
        Ok([place.length, clearance.value])
    }

    /// z of the contact where the cutter meets the other half; 0 if it does not before the middle.
    fn limit(&self) -> Checked<f64> {
        let free = |[z, clearance]: [f64; 2]| z < 0.0 && clearance >= 0.0;
        let [mut far, mut near] = lead_range(self.flank, self.lead)?;
        if !free(self.at(far)?) || free(self.at(near)?) {
            return Err("the cutter has to pass the middle between the ends of the face".into());
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (far + near);
            if free(self.at(middle)?) {
                far = middle;
            } else {
                near = middle;
            }
        }
        Ok(self.at(far)?[0])
    }
}

/// Block `herringbone`.
pub(in super::super::super) fn herringbone(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("herringbone", block, ledger, |expected, ledger| {
        let halves = text(expected, "case", ledger)?;
        let name = halves.strip_suffix(HALVES).ok_or_else(|| format!("case: <name>{HALVES} is needed here"))?;
        let case = MilledCase::named(reference, name)?;
        let own = side(reference.root["cases"][name]["input"]["flank"].as_str().unwrap_or_default())?;
        let (Body::Cylinder { helicoid, .. }, Some(opposite)) = (&case.body, &case.opposite) else {
            return Err("a cylindrical gear is needed here".into());
        };
        let radius = number(expected, "R_mm", ledger)?;
        let cutter = of_shape(CutterShape::end_mill(radius, 0.0), EDGES)?;
        let contact_height = number(expected, "h_mm", ledger)?;
        let row = number(expected, "row_w_mm", ledger)?;
        let mm = tolerance(expected, "tolerance_mm", ledger);
        let flat = -radius * helicoid.base_helix_angle().sin().abs();
        check_items(expected, "items", ledger, |item, ledger| {
            let wanted = side(text(item, "flank", ledger)?)?;
            let flank = if wanted == own { &case.flank } else { opposite };
            let half = HalfRow { flank, lead: &*case.lead, cutter: &cutter, row, contact_height };
            item.number("z_limit_mm", half.limit()?, mm, ledger);
            item.number("flat_formula_mm", flat, mm, ledger);
            Ok(())
        })
    });
}
