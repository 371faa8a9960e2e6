//! Whether the worm can go on shrinking after today's dressing: down to which diameter the dresser has not cut into it
//! (`docs/mathematics/dressing.md#limits-of-a-correction`).

use super::execution::Execution;
use super::prepare::Prepared;
use foundation::geometry::Sides;
use generating::{SparedWorms, Undermined};
use report::charts::format_significant;
use schemars::JsonSchema;
use serde::Serialize;
use verdict::Remark;

/// The smaller worms that today's dressing leaves whole, the addendum kept.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SparedWormsResult {
    /// Tip diameter of the smallest worm that was looked at: that of `technology.life`, but no smaller than today's root diameter,
    /// which the dresser reaches; smaller worms are whole.
    pub looked_down_to_mm: f64,
    /// Tip diameter of the smallest that is left whole.
    pub spared_down_to_mm: f64,
    /// The cut into the smallest that was looked at, if there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cut: Option<UnderminedResult>,
}

/// Where today's dressing cuts into a smaller worm.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct UnderminedResult {
    /// Flank that is dressed.
    pub dressed: &'static str,
    /// Flank of the smaller worm.
    pub flank: &'static str,
    /// Depth, normal.
    pub depth_um: f64,
    /// Place along the worm.
    pub z_mm: f64,
}

/// Of the motions of a run, with what is wrong for the life that the job states. Nothing where no single dresser works on a
/// cylindrical worm of a plain root.
pub fn spared_worms(
    prepared: &Prepared,
    execution: &Execution,
) -> (Option<SparedWormsResult>, Option<Remark>) {
    let setup = &prepared.setup;
    let Some(dresser) = &execution.dresser else { return (None, None) };
    let beyond = !setup.pair.worm.is_cylindrical()
        || setup.input.gear_root.is_some()
        || prepared.dressing.two_flanks
        || execution.flanks.iter().any(|(_, flank)| flank.as_ref().is_some_and(|f| f.strokes().is_some()));
    if beyond {
        return (None, None);
    }
    let corrections =
        Sides::from_fn(|flank| Some(&execution.flanks[flank].as_ref()?.dressing()?.corrections));
    let stated = prepared.removal.as_ref().and_then(|task| task.life).map(|[last, _]| last);
    let land = prepared.dressing.tip_land.unwrap_or(0.0);
    match setup.spared_worms(dresser, &corrections, land, stated) {
        Ok(found) => (Some(SparedWormsResult::of(&found)), stated.and_then(|last| remark(&found, last))),
        Err(error) => {
            let remark = stated.map(|last| Remark {
                code: "smaller-worms-unknown",
                text: format!("whether the worm of {last} mm is left whole is not known: {error}"),
                way_out: error.way_out().into(),
            });
            (None, remark)
        }
    }
}

/// What a job that states the last diameter has to know.
fn remark(found: &SparedWorms, last: f64) -> Option<Remark> {
    let Undermined { flank, depth, z, .. } = found.cut?;
    let mm = |value: f64| format_significant(value, 5);
    Some(Remark {
        code: "smaller-worm-cut",
        text: format!(
            "dressing now cuts up to {} um into the {flank} flank of the worm of {} mm that is left later, at z = {} mm; worms down to \
             {} mm stay whole",
            format_significant(depth * 1e3, 3),
            mm(found.looked_down_to),
            mm(z),
            mm(found.spared_down_to),
        ),
        way_out: format!(
            "end the life of the worm there (technology.life.last_tip_diameter = {last} now), take a smaller dresser, or design it for \
             a smaller worm (dresser.designed_for)"
        ),
    })
}

impl SparedWormsResult {
    fn of(found: &SparedWorms) -> Self {
        Self {
            looked_down_to_mm: found.looked_down_to,
            spared_down_to_mm: found.spared_down_to,
            cut: found.cut.map(|cut| UnderminedResult {
                dressed: cut.dressed.name(),
                flank: cut.flank.name(),
                depth_um: cut.depth * 1e3,
                z_mm: cut.z,
            }),
        }
    }
}
