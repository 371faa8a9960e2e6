//! The measured flank as a surface on the grid of the result: through the lines of every tooth, or through the points of a field, mean over
//! the teeth about their means. Deviations from the design, normal, mm; NaN where nothing was measured.

use super::evaluate::{Design, transverse_samples};
use super::readings::readings;
use crate::exchange::inspection::{Inspection, Section, Topography as MeasuredField, Trace, TraceKind};
use crate::geometry::{Flank, Gear};
use crate::metrology::Topography;
use crate::metrology::areal::{
    ArealDegree, ArealField, ArealFit, ArealPoint, Mismatch, OutsideTraces, Reconstruction,
    Trace as ArealTrace, Zeros,
};
use crate::metrology::inspection::InspectionError;
use crate::numerics::{root_mean_square, student_two_sided};
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// A surface of one flank.
#[derive(Clone, Debug)]
pub(super) struct MeasuredSurface {
    /// Deviation from the design on the grid.
    pub deviation: Topography,
    /// Teeth that it is the mean of.
    pub teeth: usize,
    /// How it came about.
    pub how: String,
    /// How far profiles and helix traces of a tooth disagree where they cross: root mean square over the teeth, and the largest.
    pub mismatch: Option<Mismatch>,
    /// Where the grid goes far beyond the outermost lines.
    pub outside: Vec<OutsideTraces>,
    /// Whether the twist shows in it: one profile and one helix trace tell nothing of it.
    pub sees_twist: bool,
    /// Teeth that differ from the others.
    pub standing_out: Vec<StandingOut>,
}

/// A tooth that differs from the others by more than those do among themselves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct StandingOut {
    /// Its number.
    pub tooth: u32,
    /// Its largest difference from what all teeth share and what goes around the gear once a turn, about its mean, mm.
    pub largest: f64,
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
        surfaces.extend(mean(of_tooth).map(|surface| (*tooth, surface)));
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
    surfaces.extend(fields.into_iter().filter_map(|(tooth, of)| Some((tooth, mean(of)?))));
    let count = surfaces.len();
    let mismatch = (!mismatches.is_empty()).then(|| Mismatch {
        rms: root_mean_square(&mismatches.iter().map(|m| m.rms).collect::<Vec<f64>>()),
        largest: mismatches.iter().map(|m| m.largest).fold(0.0, f64::max),
    });
    let pitch = TAU / f64::from(inspection.gear.teeth.unsigned_abs());
    let standing_out = standing_out(&surfaces, |tooth| f64::from(tooth) * pitch);
    let made = |deviation| MeasuredSurface {
        deviation,
        teeth: count,
        how,
        mismatch,
        outside,
        sees_twist,
        standing_out,
    };
    Ok(mean(surfaces.into_iter().map(|(_, surface)| surface).collect()).map(made))
}

/// A trace on some places, each the value there of the parabola through the samples around it: what lies between the places counts too.
/// Where there are too few, it runs straight between its samples, and as far as one step beyond them. `None` for a trace that is none.
fn averaged(position: f64, abscissa: &[f64], f: &[f64], places: &[f64], spacing: f64) -> Option<ArealTrace> {
    let samples: Vec<(f64, f64)> =
        abscissa.iter().copied().zip(f.iter().copied()).filter(|(_, f)| f.is_finite()).collect();
    let (first, last) = (samples.first()?.0, samples.last()?.0);
    let step = (abscissa.last()? - abscissa.first()?) / (abscissa.len().max(2) - 1) as f64;
    let reach = step * (1.0 + 1e-6);
    let value = |x: f64| {
        let from = samples.partition_point(|(a, _)| *a < x - spacing);
        let to = samples.partition_point(|(a, _)| *a <= x + spacing);
        parabola(&samples[from..to], x).or_else(|| {
            let k = samples.partition_point(|(a, _)| *a <= x).clamp(1, samples.len() - 1);
            let ((a, f), (b, g)) = (samples[k - 1], samples[k]);
            Some(f + (g - f) * (x - a) / (b - a))
        })
    };
    if samples.len() < 2 {
        return None;
    }
    let within = places.iter().copied().filter(|x| *x >= first - reach && *x <= last + reach);
    let (places, values): (Vec<f64>, Vec<f64>) = within.filter_map(|x| Some((x, value(x)?))).unzip();
    ArealTrace::new(position, &places, &values).ok()
}

/// Fewest samples of a parabola: with fewer it would run through their noise.
const FEWEST: usize = 6;

/// The value at x of the least-squares parabola through samples on both sides of x, or beside the end of a trace; `None` with too few.
fn parabola(samples: &[(f64, f64)], x: f64) -> Option<f64> {
    if samples.len() < FEWEST {
        return None;
    }
    let half = samples.iter().map(|(a, _)| (a - x).abs()).fold(0.0, f64::max);
    let rows = samples.iter().map(|(a, f)| (Vector3::new(1.0, (a - x) / half, ((a - x) / half).powi(2)), *f));
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for (row, f) in rows {
        matrix += row * row.transpose();
        right += row * f;
    }
    Some(matrix.cholesky()?.solve(&right)[0])
}

/// What a field's points share with a surface of third degree; NaN beyond them.
fn fitted(points: &[(f64, f64, f64)], w: &[f64], z: &[f64]) -> Option<Topography> {
    let ends = |of: fn(&(f64, f64, f64)) -> f64| crate::numerics::extremes(points.iter().map(of));
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

/// Teeth from which on what goes around the gear once a turn is told apart, and fewest teeth.
const TEETH_WITH_HARMONIC: usize = 6;
const TEETH_WITHOUT: usize = 4;
/// Teeth that differ by less are alike, mm.
const ALIKE: f64 = 1e-4;
/// A tooth stands out if by chance one gear in so many has one whose feature differs as much.
const ONE_IN: f64 = 20.0;

/// What of a tooth's surface is compared: five features and what they leave.
const COMPARED: usize = 6;

/// Teeth that stand out: a feature of their surface, or what the features leave, differs from what the other teeth let expect at that place
/// around the gear by more than those differ themselves (externally studentised residuals). `angle` of a tooth, rad.
fn standing_out(surfaces: &[(u32, Topography)], angle: impl Fn(u32) -> f64) -> Vec<StandingOut> {
    let count = surfaces.len();
    if count < TEETH_WITHOUT {
        return Vec::new();
    }
    let columns = if count < TEETH_WITH_HARMONIC { 1 } else { 3 };
    let angles: Vec<f64> = surfaces.iter().map(|(tooth, _)| angle(*tooth)).collect();
    let terms = DMatrix::from_fn(count, columns, |i, k| [1.0, angles[i].cos(), angles[i].sin()][k]);
    let Some(solver) = (terms.transpose() * &terms).cholesky() else { return Vec::new() };
    // From the values of the teeth to what they differ by from what all share and from the harmonic.
    let rest = DMatrix::identity(count, count) - &terms * solver.inverse() * terms.transpose();
    let Some(compared) = surfaces.iter().map(|(_, s)| numbers(s)).collect::<Option<Vec<_>>>() else {
        return Vec::new();
    };
    let freedom = (count - columns - 1) as f64;
    let beyond_chance = |i: usize, k: usize| {
        let residual = &rest * DVector::from_iterator(count, compared.iter().map(|of| of[k]));
        let own = rest[(i, i)];
        // A tooth that alone tells a term differs from nothing.
        if own < 0.1 {
            return false;
        }
        let square = residual[i].powi(2) / own;
        let others = ((residual.norm_squared() - square) / freedom).max(ALIKE * ALIKE);
        student_two_sided((square / others).sqrt(), freedom) < 1.0 / (ONE_IN * count as f64)
    };
    let odd = (0..count).filter(|&i| (0..COMPARED).any(|k| beyond_chance(i, k)));
    odd.map(|i| StandingOut { tooth: surfaces[i].0, largest: largest_difference(surfaces, &rest, i) })
        .collect()
}

/// Features and rest of a surface, mm; `None` for one that has none.
fn numbers(surface: &Topography) -> Option<[f64; COMPARED]> {
    let ends = |x: &[f64]| Some([*x.first()?, *x.last()?]);
    let field = ArealField::new(ends(&surface.w)?, ends(&surface.z)?).ok()?;
    let fit = ArealFit::of_grid(surface, &field, ArealDegree::Second).ok()?;
    let of = fit.features();
    let values = [
        of.profile_slope,
        of.profile_crowning,
        of.helix_slope,
        of.helix_crowning,
        of.twist,
        fit.residual_rms,
    ];
    Some(values)
}

/// How far a tooth, about its mean, differs at most from what all share and what goes around the gear.
fn largest_difference(surfaces: &[(u32, Topography)], rest: &DMatrix<f64>, tooth: usize) -> f64 {
    let places = surfaces[tooth].1.f.len();
    let common = (0..places).filter(|&k| surfaces.iter().all(|(_, s)| s.f[k].is_finite()));
    let difference = |k: usize| {
        let values = DVector::from_iterator(surfaces.len(), surfaces.iter().map(|(_, s)| s.f[k]));
        (rest.row(tooth) * &values)[0]
    };
    let values: Vec<f64> = common.map(difference).collect();
    let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
    values.iter().fold(0.0, |most: f64, f| most.max((f - mean).abs()))
}

/// The mean of surfaces, each about its own mean over the places that all have.
fn mean(surfaces: Vec<Topography>) -> Option<Topography> {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Teeth whose slope over z goes around the gear, one of them with more.
    fn teeth(count: u32, odd: f64) -> Vec<StandingOut> {
        let places: Vec<f64> = (0..5).map(f64::from).collect();
        let angle = |tooth: u32| TAU * f64::from(tooth) / f64::from(count);
        let surfaces: Vec<(u32, Topography)> = (1..=count)
            .map(|tooth| {
                let own = 1e-4 * (f64::from(tooth) * 2.3).sin() + if tooth == 2 { odd } else { 0.0 };
                let slope = 0.003 * (angle(tooth) + 0.7).cos() + own;
                let f = (0..25).map(|k| slope * (f64::from(k % 5) - 2.0)).collect();
                (tooth, Topography::new(places.clone(), places.clone(), f).unwrap())
            })
            .collect();
        standing_out(&surfaces, angle)
    }

    #[test]
    fn one_tooth_stands_out_of_a_wobble() {
        for count in [7, 8, 9, 13] {
            assert!(teeth(count, 0.0).is_empty(), "{count}");
            let found = teeth(count, 0.003);
            assert_eq!(found.iter().map(|odd| odd.tooth).collect::<Vec<_>>(), [2], "{count}");
            // 3 um at the outermost of places that reach to 2; the fit gives some of it to the other teeth.
            assert!((0.003..=0.006).contains(&found[0].largest), "{count}: {}", found[0].largest);
        }
        assert!(teeth(3, 0.1).is_empty());
    }
}
