//! Block `herringbone`: how near to the middle of a double helical gear a cutter gets (`docs/mathematics/milling.md#flanks-as-patches`).

use super::super::given::{Checked, check_block, check_items, number, text, tolerance};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::body::{Body, side};
use super::case::{MilledCase, located};
use super::cutter::{EDGES, of_shape};
use foundation::geometry::{Cutter, CutterShape, Mirrored};
use foundation::numerics::brent;
use milling::{ActiveFlank, Column, ColumnPlane, LeadCurve, Patch, lead_range};
use serde_json::Value;

/// What follows the name of the case.
const HALVES: &str = ", half z < 0; other half mirrored in z = 0";

/// A share of the way to the middle: what is free there is free everywhere before the middle.
const NEAR: f64 = 1e-6;

/// Width of the last bracket of the lead parameter, mm.
const ACCURACY: f64 = 1e-9;

/// One row of the half z < 0.
struct HalfRow<'a> {
    flank: &'a ActiveFlank,
    lead: &'a dyn LeadCurve,
    cutter: &'a Cutter,
    row: f64,
    contact_height: f64,
}

impl HalfRow<'_> {
    fn column(&self, u: f64) -> Checked<Column> {
        let plane = ColumnPlane::new(self.flank, self.lead.at(u)?);
        Ok(Column::at_heights(self.flank, &plane, &[self.row])?)
    }

    /// z of the contact in the column at u.
    fn position(&self, u: f64) -> Checked<f64> {
        Ok(self.column(u)?.places[0].length)
    }

    /// How far the cutter in the column at u stays away from the same flank of the other half.
    fn clearance(&self, u: f64) -> Checked<f64> {
        let column = self.column(u)?;
        let location = located(&column.places[0], &column.lead, self.cutter, self.contact_height, 0.0)?;
        let other = Mirrored::new(self.flank.surface.clone(), 0.0);
        let [root, tip] = self.flank.height_span();
        let patch = Patch {
            surface: &other,
            heights: [root.min(tip), root.max(tip)],
            lengths: [0.0, self.flank.face[1]],
            turn: 0.0,
        };
        Ok(patch.clearance(self.cutter, &location.tip, &location.axis).value)
    }

    /// z of the contact where the cutter meets the other half; 0 if it does not before the middle.
    fn limit(&self) -> Checked<f64> {
        let [from, to] = lead_range(self.flank, self.lead)?;
        let ends = [self.position(from)?, self.position(to)?];
        let middle = brent([from, to], ends, ACCURACY, |u| self.position(u).ok());
        let middle = middle.ok_or("the row does not cross the middle")?;
        let near = middle - NEAR * (middle - from);
        let ends = [self.clearance(from)?, self.clearance(near)?];
        if ends[0] < 0.0 {
            return Err("the cutter meets the other half from the end of the face on".into());
        }
        if ends[1] >= 0.0 {
            return Ok(0.0);
        }
        let limit = brent([from, near], ends, ACCURACY, |u| self.clearance(u).ok());
        self.position(limit.ok_or("no place where the cutter meets the other half")?)
    }
}

/// Block `herringbone`.
pub(crate) fn herringbone(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("herringbone", block, ledger, |expected, ledger| {
        let halves = text(expected, "case", ledger)?;
        let name =
            halves.strip_suffix(HALVES).ok_or_else(|| format!("case: <name>{HALVES} is needed here"))?;
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
