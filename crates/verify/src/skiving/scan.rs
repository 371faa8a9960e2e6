//! Block `scan_fixed_Y_vertical_stylus`: the axes along an edge with Y held.

use super::super::expected::Expected;
use super::super::given::{Checked, check_object, number, text};
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::example::SkivingExample;
use foundation::geometry::Flank;
use serde_json::Value;
use skiving::measuring::{ScanAxes, scan_curve};

/// The stylus touches tangentially: what may be left of l.n.
const TANGENCY: f64 = 1e-14;

/// Block `scan_fixed_Y_vertical_stylus`.
pub(crate) fn scan(reference: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let Some(list) = block.as_array() else {
        return ledger.fail("scan", "", block.clone(), "a list is needed here".into());
    };
    for item in list {
        let name = format!("scan {}", item["example"].as_str().unwrap_or_default());
        let expected = Expected::new(&name, "", item, ledger);
        check_object(expected, ledger, |expected, ledger| {
            let example = SkivingExample::named(reference, text(expected, "example", ledger)?)?;
            let mut curves = expected.object("curve", ledger).ok_or("curve is missing")?;
            for flank in Flank::BOTH {
                let curve = curves.object(flank.name(), ledger).ok_or("a curve for each flank is needed")?;
                check_object(curve, ledger, |curve, ledger| {
                    check_curve(reference, &example, flank, curve, ledger)
                });
            }
            curves.finish(ledger);
            Ok(())
        });
    }
}

fn check_curve(
    reference: &Reference<'_>,
    example: &SkivingExample,
    flank: Flank,
    curve: &mut Expected<'_>,
    ledger: &mut Ledger,
) -> Checked {
    let edge = &example.edges[flank];
    let rows = curve.objects("rows", ledger);
    let ends =
        [rows.first(), rows.last()].map(|row| row.and_then(|row| row.peek("w")).and_then(Value::as_f64));
    let [Some(from), Some(to)] = ends else {
        return Err("rows: w is needed in the first and last row".into());
    };
    let range = [from, to].map(|w| edge.flank().edge_coordinate(w));
    let found = scan_curve(edge, &example.beam, ScanAxes::WithoutY, range, rows.len())?;
    let tolerances = reference.tolerances();
    let (mm, degrees) = (tolerances.get("length_mm"), tolerances.get("angle_deg"));
    curve.number("Y", found[found.len() / 2].pose.position.y, mm, ledger);
    for (place, row) in found.iter().zip(rows) {
        check_object(row, ledger, |row, ledger| {
            let (contact, pose) = (&place.track.contact, &place.pose);
            let w = number(row, "w", ledger)?;
            ledger.number(row.case(), &row.name("w"), w, contact.w, mm);
            row.number("X", pose.position.x, mm, ledger);
            for (key, angle) in [
                ("phi_1_deg", contact.tool_angle),
                ("A_deg", pose.swivel),
                ("B_deg", pose.turn),
                ("eta_deg", pose.off_flank),
            ] {
                row.periodic(key, angle.to_degrees(), 360.0, degrees, ledger);
            }
            row.at_most("tangency", pose.beam_in_tool.dot(&contact.normal).abs(), TANGENCY, ledger);
            Ok(())
        });
    }
    Ok(())
}
