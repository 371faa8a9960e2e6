//! The edges of an example: contact points, tool normals, roundings, levers.

use super::super::expected::Expected;
use super::super::given::{Checked, check_object, compare_vector, number};
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use serde_json::Value;
use skiving::{MeasuringTrack, VirtualEdge};

/// Compares every track of an edge; `sharp` is the same edge without rounding.
pub(super) fn check_edges(
    tolerances: &Tolerances<'_>,
    edge: &VirtualEdge,
    sharp: &VirtualEdge,
    list: &Value,
    ledger: &mut Ledger,
) -> Checked {
    let name = format!("edges.{}", edge.side());
    let items = list.as_array().ok_or_else(|| format!("{name}: a list is needed here"))?;
    let [mm, degrees, unit, theta] =
        ["length_mm", "angle_deg", "unit_vector", "theta_deg"].map(|key| tolerances.get(key));
    for (k, item) in items.iter().enumerate() {
        let expected = Expected::new(&name, &format!("[{k}]"), item, ledger);
        check_object(expected, ledger, |expected, ledger| {
            let track = MeasuringTrack::new(edge, number(expected, "x", ledger)?)?;
            let (contact, section) = (&track.contact, &track.section);
            expected.numbers(
                &[
                    ("w", contact.w),
                    ("f_n2", contact.modification),
                    ("R", track.radius()),
                    ("Z", track.height()),
                    ("lever_mm_per_rad", contact.lever),
                    ("cutting_speed_along_rake_normal", edge.cutting_speed(contact)),
                ],
                mm,
                ledger,
            );
            expected.periodic("phi_1_deg", contact.tool_angle.to_degrees(), 360.0, degrees, ledger);
            expected.periodic("chi_deg", contact.turn.to_degrees(), 360.0, degrees, ledger);
            for (key, point) in [
                ("q_engagement", contact.engagement),
                ("m", contact.point),
                ("centre_c", contact.centre),
                ("sharp_edge_point", sharp.contact(contact.w)?.point),
            ] {
                compare_vector(expected, key, &point, mm, ledger);
            }
            for (key, direction) in [
                ("n2", contact.work_normal),
                ("n_m", contact.normal),
                ("g_flank_direction", contact.flank_direction),
            ] {
                compare_vector(expected, key, &direction, unit, ledger);
            }
            for (key, angle) in [
                ("theta_deg", section.contact_angle),
                ("theta_lo_deg", section.range[0]),
                ("theta_hi_deg", section.range[1]),
            ] {
                expected.number(key, angle.to_degrees(), theta, ledger);
            }
            Ok(())
        });
    }
    Ok(())
}
