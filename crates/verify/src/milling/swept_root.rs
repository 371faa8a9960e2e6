//! How far the root that the cutter sweeps is off the drawn section (end of `docs/mathematics/milling.md#root-and-clearance`).

use super::super::given::Checked;
use super::case::{MilledCase, located};
use super::referee::left_um;
use foundation::geometry::{Cutter, CutterShape};
use foundation::numerics::equidistant;
use milling::{Column, ColumnPlane, RootSection};
use nalgebra::Vector3;
use referee::{CutterPlace, MillPath, NormalRay};

/// Rays on each part of the section.
const RAYS: usize = 41;
/// Places of the cutter on its way, which is this many of its radii long to either side.
const PLACES: usize = 161;
const RADII: f64 = 2.0;

/// Greatest deviation of the straight part 3b and of the fillet, um: the cutter runs along the lowest row with the contact height of
/// the section, rays stand on the drawn section in the column plane.
pub(super) fn swept_um(
    case: &MilledCase,
    column: &Column,
    cutter: &Cutter,
    section: &RootSection,
) -> Checked<[f64; 2]> {
    let lead = column.lead;
    let CutterShape::Conical { radius, corner_radius, .. } = *cutter.shape() else {
        return Err("a rounded end mill is needed here".into());
    };
    let step = 1e-6 * (case.flank.face[1] - case.flank.face[0]);
    let speed = (case.lead.at(lead.u + step)?.point - lead.point).norm() / step;
    let half = RADII * radius / speed;
    let mut places = Vec::with_capacity(PLACES);
    for u in equidistant([lead.u - half, lead.u + half], PLACES) {
        let plane = ColumnPlane::new(&case.flank, case.lead.at(u)?);
        let at = Column::at_heights(&case.flank, &plane, &[column.places[0].height])?;
        let at = located(&at.places[0], &at.lead, cutter, section.contact_height, 0.0)?;
        places.push(CutterPlace { tip: at.tip, axis: at.axis });
    }
    let paths = [MillPath { cutter: 0, places }];
    let (x, y) = (lead.abscissa(), lead.base_normal);
    let in_space = |[a, b]: [f64; 2]| -> Vector3<f64> { x * a + y * b };
    let ray = |point: [f64; 2], normal: [f64; 2]| NormalRay {
        point: lead.point + in_space(point),
        normal: in_space(normal).normalize(),
    };
    let (g, q, o) = (section.lowest_active, section.fillet_start, section.fillet_centre);
    // From the begin of the fillet towards its centre, out of the material; the same all along the straight part.
    let out = [(o[0] - q[0]) / corner_radius, (o[1] - q[1]) / corner_radius];
    let shares = equidistant([0.0, 1.0], RAYS);
    let between = |share: f64, k: usize| g[k] + share * (q[k] - g[k]);
    let straight: Vec<NormalRay> = shares.iter().map(|&t| ray([between(t, 0), between(t, 1)], out)).collect();
    let fillet: Vec<NormalRay> = section.fillet(RAYS).into_iter().map(|[at, out]| ray(at, out)).collect();
    let off = |rays: &[NormalRay]| -> Checked<f64> {
        Ok(left_um(cutter, &paths, rays)?.iter().fold(0.0, |most: f64, x| most.max(x.abs())))
    };
    Ok([off(&straight)?, off(&fillet)?])
}
