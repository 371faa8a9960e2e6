//! A cutter in words.

use crate::workflow::CutterResult;
use report::charts::format_significant;

/// Its shape with the figures that belong to it.
pub(super) fn cutter_words(cutter: &CutterResult) -> String {
    let mm = |x: f64| format_significant(x, 4);
    let diameter = mm(cutter.diameter);
    match cutter.profile {
        "barrel" => format!("barrel {diameter} mm, profile radius {} mm", mm(cutter.profile_radius)),
        _ if cutter.half_angle_deg > 0.0 => format!(
            "cone {diameter} mm, {} deg, corner radius {} mm",
            mm(cutter.half_angle_deg),
            mm(cutter.profile_radius)
        ),
        _ if 2.0 * cutter.profile_radius >= cutter.diameter => format!("ball {diameter} mm"),
        _ => format!("end mill {diameter} mm, corner radius {} mm", mm(cutter.profile_radius)),
    }
}
