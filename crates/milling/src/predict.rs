//! What a cutter that runs along the rows leaves at a point of a flank: the exact surface of the cutter met by the point's normal, least
//! over the ways of all rows that can reach it, as straight blocks and as the continuous motion that they stand for.

use super::meeting::{Line, Profile};
use super::sweep::{Lowest, Sweep};
use super::{
    ActiveFlank, ColumnPlane, CutterLocation, FinishedRow, FlankGrid, FlankPlan, LeadCurve, MillingError,
    Orientation, plane_through,
};
use foundation::geometry::{Cutter, SurfaceJet};
use foundation::numerics::{CubicSpline, SplineError, least_value};

/// The rows of a flank and the pass below them.
#[derive(Clone, Debug)]
pub struct FlankModel<'a> {
    flank: &'a ActiveFlank,
    lead: &'a dyn LeadCurve,
    cutter: &'a Cutter,
    rows: Vec<RowModel>,
    fillet: Option<Sweep>,
}

/// A row that the cutter runs along without any gap between its places, and in blocks from column to column.
#[derive(Clone, Debug)]
struct RowModel {
    contact_height: f64,
    orientation: Orientation,
    /// Height and length parameters of the row over the lead parameter.
    heights: CubicSpline,
    lengths: CubicSpline,
    blocks: Sweep,
}

/// What stays at a point, mm, > 0 stock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prediction {
    /// What the continuous motion would leave: by the shape of the cutter and the distance of the rows.
    pub scallop: f64,
    /// What straight blocks change of it.
    pub chord: f64,
}

impl Prediction {
    /// Both together.
    pub fn stock(&self) -> f64 {
        self.scallop + self.chord
    }
}

impl<'a> FlankModel<'a> {
    /// The model of a flank's plan; its path has at least four columns.
    ///
    /// # Errors
    /// [`SplineError`] for fewer columns.
    pub fn new(
        flank: &'a ActiveFlank,
        lead: &'a dyn LeadCurve,
        plan: &FlankPlan,
        cutter: &'a Cutter,
    ) -> Result<Self, SplineError> {
        let grid = &plan.lines.path;
        // As far along a row as the next row is away its cutter can do something beside it.
        let reach = plan.lines.dense.along_columns.greatest;
        let sweep = |locations: &mut dyn Iterator<Item = &CutterLocation>| {
            let columns = grid.columns.iter().map(|column| column.lead.u);
            Sweep::new(cutter.shape(), columns.zip(locations).map(|(u, at)| (u, at.tip, at.axis)), reach)
        };
        let rows = plan.rows.iter().enumerate().filter_map(|(row, finished)| {
            let blocks = sweep(&mut finished.locations.iter())?;
            Some(RowModel::new(grid, row, finished, blocks))
        });
        let rows = rows.collect::<Result<Vec<_>, _>>()?;
        let fillet = sweep(&mut plan.root.iter().map(|(_, at)| at));
        Ok(Self { flank, lead, cutter, rows, fillet })
    }

    /// What all rows together leave on the normal of the flank's point at these parameters.
    ///
    /// # Errors
    /// Those of the sections and locations; [`MillingError::NotMet`] if no row beside the point reaches its normal.
    pub fn at(&self, height: f64, length: f64) -> Result<Prediction, MillingError> {
        let u = plane_through(self.flank, self.lead, height, length)?;
        let jet = self.flank.surface.jet(height, length);
        let line = Line { point: jet.point, direction: jet.normal };
        let (row, mut lowest) = self.lowest(&line, height, u).ok_or_else(|| not_met(&jet))?;
        let scallop = self.scallop(&self.rows[row], &line, &lowest)?;
        if row == 0
            && let Some(fillet) = self.fillet.as_ref().and_then(|sweep| sweep.lowest(&line, u))
            && fillet.length < lowest.length
        {
            lowest = fillet;
        }
        Ok(Prediction { scallop, chord: lowest.length - scallop })
    }

    /// The row that cuts lowest: one of both beside the point, or one farther away while that goes lower.
    fn lowest(&self, line: &Line, height: f64, u: f64) -> Option<(usize, Lowest)> {
        let [root, tip] = self.flank.height_span();
        // Heights of the rows ascend or, on internal gears, descend.
        let sense = (tip - root).signum();
        let above = self.rows.partition_point(|row| sense * (row.heights.value(u) - height) < 0.0);
        let found = |row: usize| {
            let lowest = self.rows.get(row)?.blocks.lowest(line, u)?;
            Some((row, lowest))
        };
        let lower = |a: (usize, Lowest), b: (usize, Lowest)| if b.1.length < a.1.length { b } else { a };
        let beside = [above.checked_sub(1).and_then(found), found(above)];
        let mut best = beside.into_iter().flatten().reduce(lower)?;
        // On the side of the better one the next row may cut even lower.
        while let Some(next) = if best.0 < above { best.0.checked_sub(1) } else { Some(best.0 + 1) } {
            match found(next) {
                Some(next) if next.1.length < best.1.length => best = next,
                _ => break,
            }
        }
        Some(best)
    }

    /// What the continuous motion along a row leaves, around the place where its blocks cut lowest.
    fn scallop(&self, row: &RowModel, line: &Line, lowest: &Lowest) -> Result<f64, MillingError> {
        let [first, last] = row.heights.domain();
        let [step, along] = row.blocks.steps();
        let (from, to) = ((lowest.u - step).max(first), (lowest.u + step).min(last));
        let profile = Profile::new(self.cutter.shape());
        let mut failed = None;
        let mut met = |u: f64| match self.location(row, u) {
            Ok(location) => profile.meeting(&location.tip, &location.axis, line).unwrap_or(f64::INFINITY),
            Err(error) => {
                failed = Some(error);
                f64::INFINITY
            }
        };
        let (_, scallop) = least_value([from, to], along, &mut met);
        match failed {
            _ if scallop.is_finite() => Ok(scallop),
            Some(error) => Err(error),
            None => Err(MillingError::NotMet { point: line.point.into() }),
        }
    }

    /// The cutter of a row at a lead parameter.
    fn location(&self, row: &RowModel, u: f64) -> Result<CutterLocation, MillingError> {
        let lead = self.lead.at(u)?;
        let section =
            ColumnPlane::new(self.flank, lead).section(row.heights.value(u), row.lengths.value(u))?;
        CutterLocation::new(
            &section.jet,
            &lead,
            self.cutter.shape(),
            self.cutter.cutting_length(),
            row.contact_height,
            row.orientation,
        )
    }
}

fn not_met(jet: &SurfaceJet) -> MillingError {
    MillingError::NotMet { point: jet.point.into() }
}

impl RowModel {
    fn new(grid: &FlankGrid, row: usize, finished: &FinishedRow, blocks: Sweep) -> Result<Self, SplineError> {
        let of = |value: fn(&super::GridPlace) -> f64| -> Vec<f64> {
            grid.columns.iter().map(|column| value(&column.places[row])).collect()
        };
        let at: Vec<f64> = grid.columns.iter().map(|column| column.lead.u).collect();
        Ok(Self {
            contact_height: finished.contact_height,
            orientation: finished.orientation,
            heights: CubicSpline::new(&at, &of(|place| place.height))?,
            lengths: CubicSpline::new(&at, &of(|place| place.length))?,
            blocks,
        })
    }
}
