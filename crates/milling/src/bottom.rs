//! The passes that join both fillets by the bottom, side by side with an upright axis (`docs/mathematics/milling.md#root-and-clearance`).

use super::root_pass::RootSection;
use super::{
    Column, CutterLocation, CutterPath, CutterPlace, FlankPlan, LeadPoint, MillingError, OperationKind,
    PlanOptions,
};
use foundation::geometry::CutterShape;
use foundation::numerics::equidistant;

/// The passes between both fillets, axis upright.
pub(super) fn bottom(options: &PlanOptions, flanks: &[FlankPlan]) -> Result<Vec<CutterPath>, MillingError> {
    let cutter = options.cutter_of(OperationKind::Bottom);
    let radius = match cutter.shape() {
        CutterShape::Conical { radius, half_angle, .. } if *half_angle == 0.0 => *radius,
        _ => return Err(MillingError::RootTool),
    };
    // Each flank tells one end of the travel across; with one flank only, both ends are its own, mirrored.
    let mut ends: Vec<Vec<(LeadPoint, f64, f64)>> = Vec::new();
    for flank in flanks {
        let of_column = |(column, (section, _)): (&Column, &(RootSection, CutterLocation))| {
            let pass = section.bottom_pass(column.lead.u, radius)?;
            Ok::<_, MillingError>((column.lead, pass.half_travel.copysign(section.lowest[0]), pass.height))
        };
        ends.push(flank.lines.path.columns.iter().zip(&flank.root).map(of_column).collect::<Result<_, _>>()?);
    }
    let [first, .., last] = ends.as_slice() else {
        let Some(only) = ends.first() else { return Ok(Vec::new()) };
        let mirrored: Vec<_> = only.iter().map(|(lead, aside, height)| (*lead, -aside, *height)).collect();
        return Ok(across(only, &mirrored, radius));
    };
    // Both flanks have their own columns; the travel of the second one is read at the columns of the first one.
    let at: Vec<f64> = last.iter().map(|(lead, ..)| lead.u).collect();
    let read = |u: f64, value: &dyn Fn(usize) -> f64| {
        let k = at.partition_point(|x| *x <= u).clamp(1, at.len() - 1);
        let share = ((u - at[k - 1]) / (at[k] - at[k - 1])).clamp(0.0, 1.0);
        value(k - 1) + (value(k) - value(k - 1)) * share
    };
    let other: Vec<_> = first
        .iter()
        .map(|(lead, ..)| (*lead, read(lead.u, &|k| last[k].1), read(lead.u, &|k| last[k].2)))
        .collect();
    Ok(across(first, &other, radius))
}

/// Passes side by side from one end of the travel to the other, at most half a tool apart.
fn across(first: &[(LeadPoint, f64, f64)], last: &[(LeadPoint, f64, f64)], radius: f64) -> Vec<CutterPath> {
    let widest = first.iter().zip(last).map(|(a, b)| (a.1 - b.1).abs()).fold(0.0, f64::max);
    let passes = (widest / radius).ceil() as usize + 1;
    let pass = |share: f64| {
        let place = |(a, b): (&(LeadPoint, f64, f64), &(LeadPoint, f64, f64))| {
            let lead = &a.0;
            let [aside, height] = [[a.1, b.1], [a.2, b.2]].map(|[from, to]| from + (to - from) * share);
            let tip = lead.point + lead.abscissa() * aside + lead.base_normal * height;
            CutterPlace { tip, axis: lead.base_normal, contact: None }
        };
        CutterPath { places: first.iter().zip(last).map(place).collect() }
    };
    if passes == 1 {
        return vec![pass(0.5)];
    }
    equidistant([0.0, 1.0], passes).into_iter().map(pass).collect()
}
