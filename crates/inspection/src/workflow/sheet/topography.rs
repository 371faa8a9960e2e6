//! Measured fields: their grid, or the fitted surface of scattered points, with the features of the flank.

use super::Filling;
use crate::page::sheet::{SheetTopography, SheetValue};
use foundation::numerics::{equidistant, extremes};
use measured_files::inspection::Topography;
use metrology::areal::{ArealDegree, ArealField, ArealFit, ArealPoint};
use report::charts::format_fixed;

/// Places that differ by no more than this are one, mm.
const SAME: f64 = 1e-6;
/// Points of a fitted surface in each direction.
const FITTED: usize = 17;

/// Values on a grid: lengths of roll, heights, um by length of roll.
struct Grid {
    w: Vec<f64>,
    z: Vec<f64>,
    f_um: Vec<Vec<f64>>,
}

impl Filling<'_> {
    pub(super) fn topographies(&self) -> Vec<SheetTopography> {
        self.inspection.topographies.iter().filter_map(|field| self.topography(field)).collect()
    }

    /// None for points that span no field.
    fn topography(&self, measured: &Topography) -> Option<SheetTopography> {
        let factor = self.to_transverse(measured.flank);
        let points: Vec<ArealPoint> = measured
            .points_mm
            .iter()
            .zip(&measured.f_um)
            .filter(|([w, z], f)| w.is_finite() && z.is_finite() && !f.is_infinite())
            .map(|([w, z], f)| ArealPoint { w: *w, z: *z, f: 1e-3 * factor * f, weight: 1.0 })
            .collect();
        let range = |place: fn(&ArealPoint) -> f64| extremes(points.iter().map(place));
        let field = ArealField::new(range(|p| p.w), range(|p| p.z)).ok()?;
        let fit = ArealFit::of_points(&points, &field, ArealDegree::Second);
        let (grid, scattered) = match (grid(&points), &fit) {
            (Some(grid), _) => (grid, false),
            (None, Ok(fit)) => (fitted(fit), true),
            (None, Err(_)) => return None,
        };
        let (face_mm, reversed) = self.face_places(&grid.z);
        let mut f_um = grid.f_um;
        if reversed {
            f_um.iter_mut().for_each(|row| row.reverse());
        }
        let mut note = match &fit {
            Ok(fit) => {
                let [w, z] = [fit.field().roll(), fit.field().face()].map(|[from, to]| to - from);
                format!(
                    "Features of the fit of degree {} over the whole field of {} × {} mm, {} points. Slope of the profile + = material \
                     rising with w; slope of the helix + = material rising to +z; S > 0 removes at the tip of +z.",
                    fit.degree().order(),
                    format_fixed(w, 2),
                    format_fixed(z, 2),
                    fit.points
                )
            }
            Err(error) => format!("No features: {error}."),
        };
        if scattered {
            note.push_str(" Scattered points: the net is the fitted surface.");
        }
        Some(SheetTopography {
            tooth: measured.tooth,
            flank: measured.flank,
            roll_mm: grid.w,
            tip_last: self.inspection.gear.teeth > 0,
            face_mm,
            face_name: if self.face.width.is_some() { "ξ from the datum face".into() } else { "z".into() },
            f_um,
            features: fit.as_ref().map(features).unwrap_or_default(),
            note,
        })
    }

    /// Distances from the datum face, ascending, and whether that turns the heights round.
    fn face_places(&self, z: &[f64]) -> (Vec<f64>, bool) {
        let mut places: Vec<f64> = z.iter().map(|z| self.face.distance(*z)).collect();
        let reversed = !self.face.rises();
        if reversed {
            places.reverse();
        }
        (places, reversed)
    }
}

/// The points as a whole grid; places that were not measured are gaps. None if they lie on no grid.
fn grid(points: &[ArealPoint]) -> Option<Grid> {
    let distinct = |place: fn(&ArealPoint) -> f64| {
        let mut places: Vec<f64> = points.iter().map(place).collect();
        places.sort_by(f64::total_cmp);
        places.dedup_by(|a, b| *a - *b <= SAME);
        places
    };
    let (w, z) = (distinct(|p| p.w), distinct(|p| p.z));
    // Points that lie anywhere share hardly a place: a grid has most of its nodes.
    if w.len() < 2 || z.len() < 2 || 2 * points.len() < w.len() * z.len() {
        return None;
    }
    let nearest = |places: &[f64], x: f64| places.partition_point(|p| *p < x - SAME).min(places.len() - 1);
    let mut f_um = vec![vec![f64::NAN; z.len()]; w.len()];
    for p in points {
        f_um[nearest(&w, p.w)][nearest(&z, p.z)] = 1e3 * p.f;
    }
    Some(Grid { w, z, f_um })
}

fn fitted(fit: &ArealFit) -> Grid {
    let [w, z] = [fit.field().roll(), fit.field().face()].map(|range| equidistant(range, FITTED));
    let f_um = w.iter().map(|w| z.iter().map(|z| 1e3 * fit.value(*w, *z)).collect()).collect();
    Grid { w, z, f_um }
}

fn features(fit: &ArealFit) -> Vec<SheetValue> {
    let of = fit.features();
    let um = |symbol: &str, mm: f64| SheetValue::new(symbol, Some(1e3 * mm), "µm", 2);
    vec![
        um("offset", of.offset),
        um("f_Hα", of.profile_slope),
        um("f_Hβ", of.helix_slope),
        um("C_α", of.profile_crowning),
        um("C_β", of.helix_crowning),
        um("S", of.twist),
        um("rest rms", fit.residual_rms),
        um("form", fit.form),
        SheetValue::new("explained", Some(100.0 * fit.explained_share), "%", 1),
    ]
}
