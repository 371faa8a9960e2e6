//! The measured flank as a surface on the grid of the result: through the lines of every tooth, or through the points of a field, mean over
//! the teeth about their means. Deviations from the design, normal, mm; NaN where nothing was measured.

use super::averaged::averaged;
use super::evaluate::{Design, transverse_samples};
use super::readings::readings;
use foundation::geometry::{Flank, Gear};
use foundation::numerics::root_mean_square;
use measured_files::inspection::{Inspection, Section, Topography as MeasuredField, Trace, TraceKind};
use metrology::Topography;
use metrology::areal::{
    ArealDegree, ArealField, ArealFit, ArealPoint, Mismatch, OutsideTraces, Reconstruction,
    Trace as ArealTrace, Zeros,
};
use metrology::inspection::InspectionError;
use std::collections::BTreeMap;

/// A surface of one flank.
#[derive(Clone, Debug)]
pub(super) struct MeasuredSurface {
    /// Deviation from the design on the grid.
    pub deviation: Topography,
    /// The surface of every tooth that it is the mean of.
    pub teeth: Vec<(u32, Topography)>,
    /// How it came about.
    pub how: String,
    /// How far profiles and helix traces of a tooth disagree where they cross: root mean square over the teeth, and the largest.
    pub mismatch: Option<Mismatch>,
    /// Where the grid goes far beyond the outermost lines.
    pub outside: Vec<OutsideTraces>,
    /// Whether the twist shows in it: one profile and one helix trace tell nothing of it.
    pub sees_twist: bool,
}

impl MeasuredSurface {
    /// Root mean square and largest disagreement of profiles and helix traces, um.
    pub fn mismatch_um(&self) -> Option<[f64; 2]> {
        self.mismatch.map(|m| [1e3 * m.rms, 1e3 * m.largest])
    }

    /// Shares of the field beyond the outermost lines, by direction.
    pub fn outside_traces(&self) -> BTreeMap<&'static str, f64> {
        self.outside.iter().map(|far| (far.along, far.share)).collect()
    }
}

/// Points (w, z, deviation) of a measured field.
pub(super) fn field_points(
    inspection: &Inspection,
    gear: &Gear,
    field: &MeasuredField,
    design: Design<'_>,
) -> Result<Vec<(f64, f64, f64)>, InspectionError> {
    let cos = gear.flank(field.flank).base_helix_angle.cos();
    let to_normal = if inspection.conditions.section == Section::Transverse { cos } else { 1.0 };
    let point =
        |([w, z], um): (&[f64; 2], &f64)| (*w, *z, 1e-3 * um * to_normal - cos * design(field.flank, *w, *z));
    Ok(field.points_mm.iter().zip(&field.f_um).filter(|(_, f)| f.is_finite()).map(point).collect())
}

/// The surface of a flank on the places (w, z); `None` if nothing of it was measured from which one could be made.
pub(super) fn measured_surface(
    inspection: &Inspection,
    gear: &Gear,
    flank: Flank,
    [w, z]: [&[f64]; 2],
    design: Design<'_>,
) -> Result<Option<MeasuredSurface>, InspectionError> {
    let mut surfaces: Vec<(u32, Topography)> = Vec::new();
    let (mut mismatches, mut outside) = (Vec::new(), Vec::<OutsideTraces>::new());
    let mut sees_twist = true;
    let ends = |x: &[f64]| [x.first().copied().unwrap_or(0.0), x.last().copied().unwrap_or(0.0)];
    let field = ArealField::new(ends(w), ends(z)).ok();
    let mut how = String::new();
    let mut teeth: BTreeMap<u32, Vec<&Trace>> = BTreeMap::new();
    for trace in inspection.traces.iter().filter(|t| t.flank == flank) {
        teeth.entry(trace.tooth).or_default().push(trace);
    }
    let cos = gear.flank(flank).base_helix_angle.cos();
    for (tooth, lines) in &teeth {
        let mut of_tooth = Vec::new();
        for reading in readings(lines, |trace| trace) {
            let of = |kind: TraceKind| {
                // On the places of the grid, and where the other lines cross.
                let mut places = if kind == TraceKind::Profile { w.to_vec() } else { z.to_vec() };
                let spacing = (ends(&places)[1] - ends(&places)[0]) / (places.len().max(2) - 1) as f64;
                places.extend(reading.iter().filter(|t| t.kind != kind).map(|t| t.position_mm));
                let one = |trace: &&&Trace| {
                    let samples = transverse_samples(inspection, gear, trace, Some(design)).ok()?;
                    let f: Vec<f64> = samples.deviation().iter().map(|f| f * cos).collect();
                    averaged(trace.position_mm, samples.abscissa(), &f, &places, spacing)
                };
                reading.iter().filter(|trace| trace.kind == kind).filter_map(one).collect::<Vec<ArealTrace>>()
            };
            let (profiles, helices) = (of(TraceKind::Profile), of(TraceKind::Helix));
            let counts = [profiles.len(), helices.len()];
            let Ok(found) = Reconstruction::new(profiles, helices, Zeros::Free) else { continue };
            let Ok(surface) = found.on_grid(w.to_vec(), z.to_vec()) else { continue };
            mismatches.extend(found.mismatch);
            for far in field.iter().flat_map(|field| found.outside(field)) {
                match outside.iter_mut().find(|known| known.along == far.along) {
                    Some(known) => known.share = known.share.max(far.share),
                    None => outside.push(far),
                }
            }
            sees_twist &= counts != [1, 1];
            how = format!("{} profiles and {} helix traces a tooth", counts[0], counts[1]);
            of_tooth.push(surface);
        }
        surfaces.extend(mean(&of_tooth).map(|surface| (*tooth, surface)));
    }
    if !surfaces.is_empty() && surfaces.len() < teeth.len() {
        how +=
            &format!("; {} of {} teeth have no lines that cross", teeth.len() - surfaces.len(), teeth.len());
    }
    let mut fields: BTreeMap<u32, Vec<Topography>> = BTreeMap::new();
    for field in inspection.topographies.iter().filter(|t| t.flank == flank) {
        let points = field_points(inspection, gear, field, design)?;
        if let Some(surface) = fitted(&points, w, z) {
            fields.entry(field.tooth).or_default().push(surface);
            how = "third-degree fit of the points of a field".into();
        }
    }
    surfaces.extend(fields.into_iter().filter_map(|(tooth, of)| Some((tooth, mean(&of)?))));
    let mismatch = (!mismatches.is_empty()).then(|| Mismatch {
        rms: root_mean_square(&mismatches.iter().map(|m| m.rms).collect::<Vec<f64>>()),
        largest: mismatches.iter().map(|m| m.largest).fold(0.0, f64::max),
    });
    let deviation = mean(surfaces.iter().map(|(_, surface)| surface));
    let made = |deviation| MeasuredSurface { deviation, teeth: surfaces, how, mismatch, outside, sees_twist };
    Ok(deviation.map(made))
}

/// What a field's points share with a surface of third degree; NaN beyond them.
fn fitted(points: &[(f64, f64, f64)], w: &[f64], z: &[f64]) -> Option<Topography> {
    let ends = |of: fn(&(f64, f64, f64)) -> f64| foundation::numerics::extremes(points.iter().map(of));
    let (roll, face) = (ends(|p| p.0), ends(|p| p.1));
    let field = ArealField::new(roll, face).ok()?;
    let points: Vec<ArealPoint> =
        points.iter().map(|&(w, z, f)| ArealPoint { w, z, f, weight: 1.0 }).collect();
    let fit = ArealFit::of_points(&points, &field, ArealDegree::Third).ok()?;
    let inside = |x: f64, [from, to]: [f64; 2]| (from - 1e-6..=to + 1e-6).contains(&x);
    let value = |w: f64, z: f64| {
        if inside(w, roll) && inside(z, face) { fit.value(w, z) } else { f64::NAN }
    };
    let f = w.iter().flat_map(|&w| z.iter().map(move |&z| (w, z))).map(|(w, z)| value(w, z)).collect();
    Topography::new(w.to_vec(), z.to_vec(), f)
}

/// The mean of surfaces, each about its own mean over the places that all have.
pub(super) fn mean<'a>(surfaces: impl IntoIterator<Item = &'a Topography>) -> Option<Topography> {
    let surfaces: Vec<&Topography> = surfaces.into_iter().collect();
    let first = surfaces.first()?;
    let common: Vec<bool> = (0..first.f.len()).map(|k| surfaces.iter().all(|s| s.f[k].is_finite())).collect();
    let places = common.iter().filter(|c| **c).count() as f64;
    if places == 0.0 {
        return None;
    }
    let levels: Vec<f64> = surfaces
        .iter()
        .map(|s| s.f.iter().zip(&common).filter(|(_, c)| **c).map(|(f, _)| f).sum::<f64>() / places)
        .collect();
    let count = surfaces.len() as f64;
    let value = |k: usize| {
        if !common[k] {
            return f64::NAN;
        }
        surfaces.iter().zip(&levels).map(|(s, level)| s.f[k] - level).sum::<f64>() / count
    };
    Topography::new(first.w.clone(), first.z.clone(), (0..first.f.len()).map(value).collect())
}
