//! What stands on the flanks before they are finished: what roughing leaves, by the referee's rays, or the allowance of a pre-cut part with
//! what its clocking may be off.

use super::prepare::{MillingBodies, PreStock};
use super::referee::{RefereedFlank, STOCK, mill_paths, rays, swept};
use crate::{MilledSide, MillingPlan, OperationKind};
use foundation::numerics::{Progress, extremes};
use nalgebra::Vector3;
use referee::Unmilled;
use run::RunFailure;
use schemars::JsonSchema;
use serde::Serialize;
use verdict::{Remark, Verdict};

/// Stock of a flank before it is finished. mm, normal to the wanted flank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StandingStock {
    /// Which flank.
    pub side: MilledSide,
    /// Least and greatest stock at the referee's rays.
    pub stock: [f64; 2],
    /// Rays at which more stands than the referee looks for: as much as nothing had cut there.
    pub uncut: usize,
    /// Rays.
    pub rays: usize,
}

/// The same in `result.json`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct StockResult {
    /// Least and greatest stock.
    pub before_mm: [f64; 2],
    /// Rays at which nothing has cut before.
    pub uncut: usize,
    /// Rays.
    pub rays: usize,
}

impl StandingStock {
    /// In the result.
    pub fn result(&self) -> StockResult {
        StockResult { before_mm: self.stock, uncut: self.uncut, rays: self.rays }
    }

    /// Stock that is missing makes a flank that does not clean up.
    pub(super) fn judge(&self, verdict: &mut Verdict) {
        let name = self.side.name();
        let [least, greatest] = self.stock;
        let detail = format!("{least:.4} to {greatest:.4} mm");
        verdict.judge(format!("stock on the {name} flank"), least >= 0.0, detail, || {
            Remark::new(
                "no-stock",
                format!("{:.4} mm of stock are missing on the {name} flank, which does not clean up", -least),
                "leave more in the operation before, or know the clocking angle better (stock.clocking_error_deg)",
            )
        });
    }
}

/// What stands on the flanks of a plan; nothing where neither stock is given nor the space is cleared.
///
/// # Errors
/// [`RunFailure`] for motions that the referee cannot follow.
pub(super) fn standing_stock(
    bodies: &MillingBodies,
    given: Option<&PreStock>,
    plan: &MillingPlan,
    flanks: &[RefereedFlank],
    progress: &dyn Progress,
) -> Result<Vec<StandingStock>, RunFailure> {
    let all = plan
        .flanks
        .iter()
        .zip(flanks)
        .map(|(made, flank)| (made, rays(made, &flank.heights, &flank.lengths)));
    if let Some(PreStock { allowance, clocking_error }) = given {
        // A turn by x moves a point of the flank along its normal by x n.(z x P).
        let found = all.map(|(made, rays)| {
            let off =
                rays.iter().map(|ray| clocking_error * ray.normal.dot(&Vector3::z().cross(&ray.point)).abs());
            let most = off.fold(0.0, f64::max);
            let stock = [allowance - most, allowance + most];
            StandingStock { side: made.side, stock, uncut: 0, rays: rays.len() }
        });
        return Ok(found.collect());
    }
    let (cutters, mut paths) = mill_paths(bodies, plan);
    let roughing = plan.operations.iter().position(|operation| operation.kind == OperationKind::Roughing);
    let Some(roughing) = roughing else { return Ok(Vec::new()) };
    paths.retain(|path| path.cutter == roughing);
    let swept = swept(&cutters, &paths, STOCK)?;
    let mut standing = Vec::new();
    for (made, rays) in all {
        let milled =
            swept.mill(&rays, progress).map_err(|error| RunFailure::of_removal(&error, "milling"))?;
        let length = |ray: &Result<referee::MilledRay, Unmilled>| match ray {
            Ok(ray) => ray.length,
            Err(Unmilled::TooDeep { .. }) => -super::referee::DEPTH,
            Err(_) => STOCK,
        };
        let lengths: Vec<f64> = milled.rays.iter().map(length).collect();
        let uncut = lengths.iter().filter(|length| **length >= STOCK).count();
        let stock = extremes(lengths.iter().copied());
        standing.push(StandingStock { side: made.side, stock, uncut, rays: lengths.len() });
    }
    Ok(standing)
}
