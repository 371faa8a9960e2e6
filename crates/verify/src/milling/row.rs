//! The row of block `feed`, which `screw_row` and `output` speak of as well.

use super::super::given::{Checked, MOST, whole};
use super::super::reference::Reference;
use super::case::{MilledCase, located};
use super::chain::{Places, chain};
use super::cutter::{EDGES, of_shape};
use foundation::geometry::CutterShape;
use foundation::kinematics::{Direction, Point, Pose};
use machine::{Machine, Positions};
use milling::{Column, RowSpacing};
use motion::milling::{AxisCourse, CutterPlace, MillingSetup, PoleStrategy, choose};
use nalgebra::Vector3;
use serde::Deserialize;

/// The input of block `feed`; what else the block holds is expected.
#[derive(Deserialize)]
pub(super) struct RowInput {
    case: String,
    u_mm: Vec<f64>,
    row: u64,
    of_rows: u64,
    h_mm: f64,
    #[serde(rename = "R_mm")]
    radius: f64,
    /// Speed of the contact along the flank, mm/min.
    pub contact_feed_mm_per_min: f64,
    rotary_limit_deg_per_s: f64,
    linear_limit_mm_per_min: f64,
    q1_mm: [f64; 3],
    q2_mm: [f64; 3],
}

impl RowInput {
    /// Keys of the input.
    pub const KEYS: [&'static str; 11] = [
        "case",
        "u_mm",
        "row",
        "of_rows",
        "h_mm",
        "R_mm",
        "contact_feed_mm_per_min",
        "rotary_limit_deg_per_s",
        "linear_limit_mm_per_min",
        "q1_mm",
        "q2_mm",
    ];

    /// The block `feed` of the file.
    pub fn of(reference: &Reference<'_>) -> Checked<Self> {
        Ok(Self::deserialize(reference.root.get("feed").ok_or("the file has no block feed")?)?)
    }

    /// The machine: C and A under the workpiece.
    pub fn machine(&self) -> Checked<Machine> {
        let points = [self.q1_mm, self.q2_mm].map(Vector3::from);
        let speeds = [self.rotary_limit_deg_per_s.to_radians(), self.linear_limit_mm_per_min / 60.0];
        chain("AC_table_table", &Places { points, pivot: 0.0, speeds: Some(speeds) })
    }

    /// The cutter's places in the columns of the row, `between` (>= 1) steps from one to the next.
    pub fn places(&self, reference: &Reference<'_>, between: usize) -> Checked<Vec<CutterPlace>> {
        let case = MilledCase::named(reference, &self.case)?;
        whole("u_mm", Some(&self.u_mm.len().into()), 2..=MOST)?;
        let rows = whole("of_rows", Some(&self.of_rows.into()), 2..=MOST)?;
        let row = whole("row", Some(&self.row.into()), 0..=self.of_rows - 1)?;
        let cutter = of_shape(CutterShape::end_mill(self.radius, 0.0), EDGES)?;
        let place = |u: f64| -> Checked<CutterPlace> {
            let column = Column::build(&case.flank, &*case.lead, u, rows, RowSpacing::Arc)?;
            let at = &column.places[row];
            let location = located(at, &column.lead, &cutter, self.h_mm, 0.0)?;
            Ok(CutterPlace {
                contact: Point::from_vector(at.jet.point),
                tip: Point::from_vector(location.tip),
                axis: Direction::from_vector(location.axis),
            })
        };
        let steps = self
            .u_mm
            .windows(2)
            .flat_map(|ends| (0..between).map(|k| ends[0] + (ends[1] - ends[0]) * k as f64 / between as f64));
        steps.chain(self.u_mm.last().copied()).map(place).collect()
    }
}

/// The axes along a row, the workpiece standing on the table as it is modelled.
pub(super) fn course<'m>(
    machine: &'m Machine,
    places: &[CutterPlace],
) -> Checked<(MillingSetup<'m>, AxisCourse)> {
    let setup = MillingSetup::new(machine, Pose::identity(), 0.0)?;
    let course = choose(&setup, places, &Positions::default(), PoleStrategy::Slow)?;
    Ok((setup, course))
}
