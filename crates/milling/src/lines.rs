//! Rows and columns of a flank from what the user asks for: counts, limits of distances, scallop and chord; and columns beyond the
//! face, so that the tool comes and goes beside it.

use super::finish::{FinishOptions, least_height};
use super::{
    ActiveFlank, ColumnPlane, CutterLocation, DenseGrid, DensityLimits, FlankGrid, LeadCurve, LocalContact,
    MillingError, RowSpacing, Section, dense_grid, lead_range,
};
use foundation::numerics::equidistant;

/// How many rows and columns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lines {
    /// As many.
    Counted {
        /// Rows, >= 2.
        rows: usize,
        /// Columns over the lead range, without overrun, >= 2.
        columns: usize,
    },
    /// As few as keep the limits.
    Limited {
        /// Limits of distances.
        limits: DensityLimits,
        /// h_s: greatest scallop, mm.
        scallop: Option<f64>,
        /// e_c: greatest error of a straight block, mm.
        chord: Option<f64>,
    },
}

/// The law of the rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpacingLaw {
    /// Equal steps of the height parameter.
    Parameter,
    /// Equal arcs of the column.
    Arc,
    /// Equal scallops.
    Scallop,
}

/// A flank's grid for the path.
#[derive(Clone, Debug, PartialEq)]
pub struct LaidLines {
    /// [u_min, u_max] of the flank, without overrun.
    pub range: [f64; 2],
    /// The grid over that range with its eight figures and the limits that it does not keep.
    pub dense: DenseGrid,
    /// The grid with overrun.
    pub path: FlankGrid,
    /// Number of the first column of the range within the path's grid.
    pub first: usize,
}

/// Points of each kind at which curvatures are looked at for the limits from scallop and chord.
const SAMPLES: usize = 9;

impl SpacingLaw {
    /// Runs `with` under this law; equal scallops need the cutter.
    pub fn apply<R>(self, options: &FinishOptions, with: impl FnOnce(RowSpacing) -> R) -> R {
        let weight = |plane: &ColumnPlane, section: &Section| {
            let (local, _) = local_contact(plane, section, options)?;
            let curvature = local.effective_curvature(&section.jet.by_length);
            Ok(curvature.max(0.0).sqrt())
        };
        match self {
            Self::Parameter => with(RowSpacing::Parameter),
            Self::Arc => with(RowSpacing::Arc),
            Self::Scallop => with(RowSpacing::Weighted(&weight)),
        }
    }
}

/// The cutter at a section, for curvatures only: at a contact height that every straight side has.
fn local_contact(
    plane: &ColumnPlane,
    section: &Section,
    options: &FinishOptions,
) -> Result<(LocalContact, CutterLocation), MillingError> {
    let cutter = options.cutter;
    let location = CutterLocation::new(
        &section.jet,
        plane.lead(),
        cutter.shape(),
        cutter.cutting_length(),
        options.heights.wanted(0, 2).unwrap_or(0.0).max(least_height(cutter.shape())),
        options.orientation_of(0, 2),
    )?;
    Ok((LocalContact::new(&section.jet, &location, cutter.shape()), location))
}

/// Lays rows and columns over a flank; `overrun` is the length that the path goes on beyond both ends of the range, mm along the lead
/// curve.
///
/// # Errors
/// Those of range, density and grid.
pub fn lay_lines(
    flank: &ActiveFlank,
    lead: &dyn LeadCurve,
    range: Option<[f64; 2]>,
    lines: &Lines,
    law: SpacingLaw,
    options: &FinishOptions,
    overrun: f64,
) -> Result<LaidLines, MillingError> {
    let range = range.map_or_else(|| lead_range(flank, lead), Ok)?;
    let dense = match lines {
        Lines::Counted { rows, columns } => {
            let at = equidistant(range, *columns);
            let grid = law.apply(options, |law| FlankGrid::build(flank, lead, &at, *rows, law))?;
            let (along_rows, along_columns) = (grid.along_rows(), grid.along_columns());
            DenseGrid { grid, along_rows, along_columns, violated: Vec::new() }
        }
        Lines::Limited { limits, scallop, chord } => {
            let mut limits = *limits;
            let [column, row] = tolerated(flank, lead, range, options, [*scallop, *chord])?;
            limits.column.greatest = limits.column.greatest.into_iter().chain(column).reduce(f64::min);
            limits.row.greatest = limits.row.greatest.into_iter().chain(row).reduce(f64::min);
            law.apply(options, |law| dense_grid(flank, lead, range, law, &limits))?
        }
    };
    let (rows, columns) = (dense.grid.rows(), dense.grid.columns.len());
    let step = (range[1] - range[0]) / (columns - 1) as f64;
    // The lead parameter is a length on gears and a share on blades.
    let [start, end] = range.map(|u| lead.at(u));
    let per_step = (end?.point - start?.point).norm() / (columns - 1) as f64;
    let first = (overrun / per_step).ceil() as usize;
    let before = (1..=first).rev().map(|n| range[0] - n as f64 * step);
    let inside = dense.grid.columns.iter().map(|column| column.lead.u);
    let after = (1..=first).map(|n| range[1] + n as f64 * step);
    let at: Vec<f64> = before.chain(inside).chain(after).collect();
    let path = law.apply(options, |law| FlankGrid::build(flank, lead, &at, rows, law))?;
    Ok(LaidLines { range, dense, path, first })
}

/// Greatest distances of rows (along columns) and of columns (along rows) that keep scallop and chord everywhere.
fn tolerated(
    flank: &ActiveFlank,
    lead: &dyn LeadCurve,
    range: [f64; 2],
    options: &FinishOptions,
    [scallop, chord]: [Option<f64>; 2],
) -> Result<[Option<f64>; 2], MillingError> {
    let mut limits = [None, None];
    if scallop.is_none() && chord.is_none() {
        return Ok(limits);
    }
    for u in equidistant(range, SAMPLES) {
        let plane = ColumnPlane::new(flank, lead.at(u)?);
        let mut start = u;
        for height in equidistant(plane.heights()?, SAMPLES) {
            let section = plane.section(height, start)?;
            start = section.length;
            let (local, _) = local_contact(&plane, &section, options)?;
            let feed = &section.jet.by_length;
            let curvatures = [local.effective_curvature(feed), local.chord_curvature(feed).abs()];
            for ((limit, tolerance), curvature) in limits.iter_mut().zip([scallop, chord]).zip(curvatures) {
                let distance = tolerance.map(|tolerance| (8.0 * tolerance / curvature).sqrt());
                let distance = distance.filter(|distance| distance.is_finite());
                *limit = (*limit).into_iter().chain(distance).reduce(f64::min);
            }
        }
    }
    Ok(limits)
}
