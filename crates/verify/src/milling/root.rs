//! Blocks `root` and `tool_too_big`: sections of the root, and what the cutter keeps from the opposite flank there.

use super::super::expected::Expected;
use super::super::given::{Checked, check_block, check_items, number, requires, tolerance};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::{MilledCase, located};
use super::cutter::{EDGES, end_mill};
use super::swept_root::swept_um;
use foundation::geometry::{Cutter, CutterShape};
use milling::{Clearance, Column, HIDDEN, Patch, RootDepth, RootSection, RowSpacing};
use serde_json::Value;

/// A root pass: the column, the cutter, the section.
struct Pass {
    case: MilledCase,
    column: Column,
    cutter: Cutter,
    section: RootSection,
}

impl Pass {
    fn given(reference: &Reference<'_>, item: &mut Expected<'_>, ledger: &mut Ledger) -> Checked<Self> {
        let case = MilledCase::given(reference, item, ledger)?;
        let u = number(item, "u", ledger)?;
        let cutter = end_mill(item, ledger)?;
        let mode = requires(item, "mode", &["h_b", "y_f"], ledger)?;
        let value = number(item, "value_mm", ledger)?;
        let depth = if mode == 0 { RootDepth::Straight(value) } else { RootDepth::Bottom(value) };
        let column = Column::build(&case.flank, &*case.lead, u, 2, RowSpacing::Arc)?;
        let CutterShape::Conical { corner_radius, .. } = *cutter.shape() else {
            return Err("a rounded end mill is needed here".into());
        };
        let place = &column.places[0];
        // The axis is the same at every height of the contact.
        let axis = located(place, &column.lead, &cutter, corner_radius, 0.0)?.axis;
        let jet = &place.jet;
        let section =
            RootSection::new(&column.lead, &jet.point, &jet.normal, &axis, corner_radius, EDGES, depth)?;
        Ok(Self { case, column, cutter, section })
    }

    /// What the cutter keeps from the opposite flank.
    fn clearance(&self) -> Checked<Clearance> {
        let opposite = self.case.opposite.as_ref().ok_or("the case has no opposite flank")?;
        let [root, tip] = opposite.height_span();
        let patch = Patch {
            surface: &*opposite.surface,
            heights: [root.min(tip), root.max(tip)],
            lengths: opposite.face,
            turn: 0.0,
        };
        let place = &self.column.places[0];
        let at = located(place, &self.column.lead, &self.cutter, self.section.contact_height, 0.0)?;
        Ok(patch.clearance(&self.cutter, &at.tip, &at.axis))
    }
}

/// Block `root`.
pub(crate) fn root(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("root", block, ledger, |expected, ledger| {
        let [mm, deg, clear, um] =
            ["tolerance_mm", "tolerance_deg", "tolerance_clearance_mm", "tolerance_dev_um"]
                .map(|key| tolerance(expected, key, ledger));
        check_items(expected, "items", ledger, |item, ledger| {
            let pass = Pass::given(reference, item, ledger)?;
            let section = &pass.section;
            for (key, point) in [
                ("p_g_mm", section.lowest_active),
                ("q_mm", section.fillet_start),
                ("centre_mm", section.fillet_centre),
                ("low_mm", section.lowest),
            ] {
                item.list(key, &point, mm, ledger);
            }
            let lengths = [
                ("h_b_mm", section.straight),
                ("half_width_11_mm", section.half_width),
                ("contact_height_mm", section.contact_height),
            ];
            item.numbers(&lengths, mm, ledger);
            let angles = [
                ("nu_deg", section.lean.to_degrees()),
                ("arc_deg", section.fillet_angle.to_degrees()),
                ("eps_deg", pass.column.places[0].out_of_plane.to_degrees()),
            ];
            item.numbers(&angles, deg, ledger);
            let swept = ["swept_3b_max_dev_um", "swept_fillet_max_dev_um"];
            if swept.iter().any(|key| item.peek(key).is_some()) {
                let off = swept_um(&pass.case, &pass.column, &pass.cutter, section)?;
                for (key, off) in swept.into_iter().zip(off) {
                    item.number(key, off, um, ledger);
                }
            }
            if item.peek("clearance_opposite_mm").is_some() {
                let clearance = pass.clearance()?;
                item.number("clearance_opposite_mm", clearance.value, clear, ledger);
                // A bound proves what it proves: below the value, and not by more than what a search may hide.
                let key = "clearance_opposite_lower_bound_mm";
                let bound = item.peek(key).and_then(Value::as_f64).unwrap_or(f64::NAN);
                let proven = bound.clamp(clearance.value - HIDDEN, clearance.value);
                item.number(key, proven, clear, ledger);
            }
            Ok(())
        })
    });
}

/// Block `tool_too_big`.
pub(crate) fn tool_too_big(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_block("tool_too_big", block, ledger, |expected, ledger| {
        let mm = tolerance(expected, "tolerance_mm", ledger);
        let clearance = Pass::given(reference, expected, ledger)?.clearance()?;
        expected.number("clearance_opposite_mm", clearance.value, mm, ledger);
        let found = if clearance.value < 0.0 { "E_TOOL_GAP" } else { "none" };
        expected.text("expected_error", found, ledger);
        Ok(())
    });
}
