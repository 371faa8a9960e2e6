//! Measured lines without the target: the deviation that all teeth share along every line, thinned, with its uncertainty. Normal, mm.

use super::super::evaluate::{Design, transverse_samples};
use super::super::readings::SAME_PLACE;
use foundation::geometry::{Flank, Gear};
use generating::correction::{FlankPoint, thinned};
use measured_files::inspection::{Inspection, TraceKind};
use metrology::inspection::{EvaluationRange, InspectionError};

/// Means along a line that take part.
const MOST: usize = 60;
/// What nothing is known better than, mm.
const LEAST_UNCERTAINTY: f64 = 1e-5;

/// One line over all teeth on which it was measured.
#[derive(Clone, Debug)]
pub(super) struct MeanLine {
    pub flank: Flank,
    /// `None` for a field.
    pub kind: Option<TraceKind>,
    position: f64,
    places: Vec<(f64, f64)>,
    teeth: Vec<ToothLine>,
}

/// The line on one tooth: the deviation about its mean, summed over its readings.
#[derive(Clone, Debug)]
struct ToothLine {
    tooth: u32,
    sum: Vec<f64>,
    readings: f64,
}

impl ToothLine {
    fn at(&self, k: usize) -> f64 {
        self.sum[k] / self.readings
    }
}

impl MeanLine {
    /// Points with the mean over the teeth.
    pub fn points(&self) -> impl Iterator<Item = (FlankPoint, f64)> + '_ {
        let count = self.teeth.len() as f64;
        self.places.iter().enumerate().map(move |(k, &(w, z))| {
            let mean = self.teeth.iter().map(|tooth| tooth.at(k)).sum::<f64>() / count;
            (FlankPoint { flank: self.flank, w, z }, mean)
        })
    }

    /// Sum of squares between the teeth and its degrees of freedom.
    fn scatter(&self) -> [f64; 2] {
        let count = self.teeth.len() as f64;
        let square = |(k, (_, mean)): (usize, (FlankPoint, f64))| {
            self.teeth.iter().map(|tooth| (tooth.at(k) - mean).powi(2)).sum::<f64>()
        };
        let sum = self.points().enumerate().map(square).sum();
        [sum, (count - 1.0) * self.places.len() as f64]
    }
}

/// All lines and fields of an inspection, deviations from the design.
pub(super) fn mean_lines(
    inspection: &Inspection,
    gear: &Gear,
    design: Design<'_>,
) -> Result<Vec<MeanLine>, InspectionError> {
    let mut lines: Vec<MeanLine> = Vec::new();
    let mut take =
        |tooth: u32, flank: Flank, kind: Option<TraceKind>, position: f64, found: Vec<(f64, f64, f64)>| {
            if found.len() < 3 {
                return;
            }
            let mean = found.iter().map(|p| p.2).sum::<f64>() / found.len() as f64;
            let values: Vec<f64> = found.iter().map(|p| p.2 - mean).collect();
            let same = |line: &&mut MeanLine| {
                (line.flank, line.kind) == (flank, kind)
                    && (line.position - position).abs() < SAME_PLACE
                    && line.places.len() == found.len()
                    && line
                        .places
                        .iter()
                        .zip(&found)
                        .all(|(a, b)| (a.0 - b.0).abs() + (a.1 - b.1).abs() < SAME_PLACE)
            };
            let new = ToothLine { tooth, sum: values, readings: 1.0 };
            match lines.iter_mut().find(same) {
                Some(line) => match line.teeth.iter_mut().find(|known| known.tooth == tooth) {
                    Some(known) => {
                        known.sum.iter_mut().zip(&new.sum).for_each(|(sum, value)| *sum += value);
                        known.readings += 1.0;
                    }
                    None => line.teeth.push(new),
                },
                None => {
                    let places = found.iter().map(|p| (p.0, p.1)).collect();
                    lines.push(MeanLine { flank, kind, position, places, teeth: vec![new] });
                }
            }
        };
    for trace in &inspection.traces {
        let cos = gear.flank(trace.flank).base_helix_angle.cos();
        // Why a trace is none is told by the evaluation.
        let Ok(samples) = transverse_samples(inspection, gear, trace, Some(design)) else { continue };
        let Ok([from, to]) = inspection.conditions.range(trace.kind, trace.flank) else { continue };
        let range = EvaluationRange::new(from, to)?;
        let within = |a: &f64| (range.from()..=range.to()).contains(a);
        let (a, f): (Vec<f64>, Vec<f64>) = samples
            .abscissa()
            .iter()
            .zip(samples.deviation())
            .filter(|(a, _)| within(a))
            .map(|(a, f)| (*a, f * cos))
            .unzip();
        let placed = |(a, f): (f64, f64)| match trace.kind {
            TraceKind::Profile => (a, trace.position_mm, f),
            TraceKind::Helix => (trace.position_mm, a, f),
        };
        let found = thinned(&a, &f, MOST).into_iter().map(placed).collect();
        take(trace.tooth, trace.flank, Some(trace.kind), trace.position_mm, found);
    }
    for field in &inspection.topographies {
        let found = super::super::surface::field_points(inspection, gear, field, design)?;
        take(field.tooth, field.flank, None, 0.0, found);
    }
    Ok(lines)
}

/// Standard uncertainty of the mean at a point of every line, mm: from what the teeth differ by over all lines, else from what neighbouring
/// points do.
pub(super) fn uncertainties(lines: &[MeanLine]) -> Vec<f64> {
    let [sum, freedom] =
        lines.iter().map(MeanLine::scatter).fold([0.0, 0.0], |[a, b], [c, d]| [a + c, b + d]);
    let tooth = if freedom > 0.0 {
        (sum / freedom).sqrt()
    } else {
        let steps: Vec<f64> = lines
            .iter()
            .flat_map(|line| {
                let values: Vec<f64> = line.points().map(|(_, f)| f).collect();
                values.windows(2).map(|pair| (pair[1] - pair[0]).powi(2)).collect::<Vec<f64>>()
            })
            .collect();
        (0.5 * steps.iter().sum::<f64>() / steps.len().max(1) as f64).sqrt()
    };
    lines.iter().map(|line| (tooth / (line.teeth.len() as f64).sqrt()).max(LEAST_UNCERTAINTY)).collect()
}
