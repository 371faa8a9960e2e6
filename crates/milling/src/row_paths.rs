//! From the rows of a flank to the paths of the cutter: as far as the other half of a double-helical gear lets them go, with their arcs
//! of approach, in the senses that are asked for.

use super::approach::ApproachArcs;
use super::middle::{Ended, Limits};
use super::space::{Space, SpaceFlank};
use super::{
    Column, CutDirection, CutterLocation, CutterPath, FinishedRow, MillingError, PlanOptions, row_path,
};
use foundation::geometry::{Cutter, Flank};
use nalgebra::Vector3;

/// Where a row ends short of its face because of the other half.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowEnd {
    /// Lead parameter of its last place.
    pub u: f64,
    /// Length parameter of its last contact.
    pub length: f64,
}

/// A row as it is milled.
#[derive(Clone, Debug)]
pub(super) struct MilledRow {
    /// The path.
    pub path: CutterPath,
    /// Where it ends short of the face.
    pub end: Option<RowEnd>,
}

/// What makes paths of rows of one flank.
pub(super) struct RowPaths<'a> {
    pub space: &'a Space,
    pub flank: &'a SpaceFlank,
    pub options: &'a PlanOptions,
    pub columns: &'a [Column],
}

/// A row is not said to end short of its face for less than this, mm: rounding.
const SHORT: f64 = 1e-6;

impl RowPaths<'_> {
    /// The path of a row with its number from the root, its cutter column by column, in a sense.
    ///
    /// # Errors
    /// [`MillingError::ToolGap`] and [`MillingError::ColumnKink`] if the other half leaves nothing of it, [`MillingError::Approach`].
    pub fn of_row(
        &self,
        row: usize,
        finished: &FinishedRow,
        wanted: CutDirection,
    ) -> Result<MilledRow, MillingError> {
        let (ended, end) = self.ended(row, &finished.locations)?;
        let backwards = self.backwards(row, &finished.locations, wanted);
        let [lead_in, lead_out] = self.options.leads;
        let leads = if backwards { [lead_out, lead_in] } else { [lead_in, lead_out] };
        let path = if leads == [None; 2] {
            ended.path
        } else {
            let arcs = ApproachArcs {
                leads,
                cutter: &self.options.cutter,
                opposite: self.space.opposite(self.flank.side).map(|opposite| opposite.patch(0.0)),
                safety: self.options.safety,
            };
            arcs.around(ended.path.clone(), self.normals_of_open_ends(row, &ended))?
        };
        Ok(MilledRow { path: directed(path, backwards), end })
    }

    /// The path of the fillet below the flank, in a sense.
    ///
    /// # Errors
    /// As those of a row, without an approach.
    pub fn of_fillet(
        &self,
        locations: &[CutterLocation],
        wanted: CutDirection,
    ) -> Result<CutterPath, MillingError> {
        let (ended, _) = self.ended(0, locations)?;
        Ok(directed(ended.path, self.backwards(0, locations, wanted)))
    }

    fn ended(
        &self,
        row: usize,
        locations: &[CutterLocation],
    ) -> Result<(Ended, Option<RowEnd>), MillingError> {
        let contacts = self.columns.iter().map(|column| column.places[row].jet.point);
        let path = row_path(locations.iter().copied().zip(contacts));
        let Some(limits) = self.limits() else { return Ok((Ended { path, at: None }, None)) };
        let ended = limits.end(path, row)?;
        let side = limits.middle.side;
        let end = ended.at.and_then(|at| {
            let before = (at as usize).min(self.columns.len() - 2);
            let [from, to] = [before, before + 1].map(|column| self.columns[column].lead.u);
            let places = &ended.path.places;
            let last = if side > 0.0 { places.first() } else { places.last() };
            let length = limits.middle.position(&last?.contact?);
            let [least, greatest] = self.flank.active.face;
            let short = if side > 0.0 { length - least } else { greatest - length };
            (short > SHORT).then_some(RowEnd { u: from + (to - from) * (at - before as f64), length })
        });
        Ok((ended, end))
    }

    fn limits(&self) -> Option<Limits<'_>> {
        Limits::of(self.space, &self.options.cutter, Some(self.flank.side), self.options.safety)
    }

    /// The flank's normals at both ends of a row. Where the other half ends it there is no room ahead and none is given: the cutter
    /// leaves along its axis.
    fn normals_of_open_ends(&self, row: usize, ended: &Ended) -> [Option<Vector3<f64>>; 2] {
        let normal = |column: Option<&Column>| column.map(|column| column.places[row].jet.normal);
        let [first, last] = [normal(self.columns.first()), normal(self.columns.last())];
        match (ended.at, self.flank.active.kink) {
            (Some(_), Some(kink)) => [first.filter(|_| kink.side < 0.0), last.filter(|_| kink.side > 0.0)],
            _ => [first, last],
        }
    }

    fn backwards(&self, row: usize, locations: &[CutterLocation], wanted: CutDirection) -> bool {
        let middle = locations.len() / 2;
        let jet = |column: usize| &self.columns[column].places[row].jet;
        let travel = jet(middle).point - jet(middle - 1).point;
        CutDirection::of(&travel, &locations[middle].axis, &jet(middle).normal) != wanted
    }
}

fn directed(mut path: CutterPath, backwards: bool) -> CutterPath {
    if backwards {
        path.places.reverse();
    }
    path
}

impl<'a> Limits<'a> {
    /// What ends the paths of a space; nothing unless it is a half.
    pub fn of(space: &'a Space, cutter: &'a Cutter, on: Option<Flank>, safety: f64) -> Option<Self> {
        let middle = space.flanks.first()?.active.kink?;
        Some(Self { middle, cutter, other_half: space.beyond_middle(on, safety) })
    }
}
