//! The root of the gear where the worm's tip grinds it: figures, sections, and what the referee's rays find on them.

use super::execution::Execution;
use super::prepare::Prepared;
use crate::workflow::generating_finding;
use foundation::geometry::{Flank, Sides};
use foundation::numerics::extremes;
use generating::{GeneratingError, GroundRoot};
use nalgebra::Vector3;
use referee::{RootGrinding, RootRay, Unmodified};
use run::RunFailure;
use schemars::JsonSchema;
use serde::Serialize;

/// The ground root in `result.json`.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct GearRootResult {
    /// Smallest and largest root diameter over the evaluated face.
    pub root_diameter_mm: [f64; 2],
    /// Smallest and largest tip diameter of the worm over the length used.
    pub worm_tip_diameter_mm: [f64; 2],
    /// Each flank that is ground.
    pub flanks: Sides<Option<FilletResult>>,
}

/// The fillet beside one flank.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FilletResult {
    /// Largest diameter at which it begins: the root form diameter that is ground.
    pub form_diameter_mm: f64,
    /// Least radius of curvature in the transverse section.
    pub least_radius_mm: f64,
    /// Largest |length| of the referee's rays on it: what planning and simulation differ by.
    pub model_difference_um: f64,
    /// Sections from the flank to the root: z, then x and y with the tooth space on +y.
    pub sections: Vec<FilletSection>,
}

/// One transverse section.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FilletSection {
    /// Axial position.
    pub z_mm: f64,
    /// Points.
    pub points_mm: Vec<[f64; 2]>,
}

/// Points of a section that is written, and of one that is refereed.
const POINTS: usize = 41;
const RAYS: usize = 5;
/// Half the width along the worm's axis in which the referee looks for the edge that grinds the fillet, mm.
const FILLET_ALONG: f64 = 6.0;
/// The referee's rays may differ by this much from the planned fillet, mm: it is interpolated to some 1e-8 mm, and the place of a
/// ball on a changing tip is taken to second order of its slope.
const AGREED: f64 = 1e-4;

/// The root as this process grinds it; `None` if the job does not ask for it.
///
/// # Errors
/// [`RunFailure`]: a fillet that is notched, reaches the flank or is too sharp; one that the referee does not find.
pub fn gear_root(prepared: &Prepared, execution: &Execution) -> Result<Option<GearRootResult>, RunFailure> {
    let setup = &prepared.setup;
    let Some(choice) = &setup.input.gear_root else { return Ok(None) };
    let motion = &execution.motion;
    let mut roots = Vec::new();
    let mut tips = Vec::new();
    let flanks = Sides::try_from_fn(|flank| -> Result<_, RunFailure> {
        if execution.flanks[flank].is_none() {
            return Ok(None);
        }
        let ground = GroundRoot::new(setup, choice, motion, flank, execution.occupation)
            .map_err(|e| generating_finding::on_field(&e, "dressing.gear_root"))?;
        roots.extend(ground.fillets.iter().map(|fillet| 2.0 * fillet.root_radius()));
        tips.extend(
            ground.fillets.iter().map(|fillet| 2.0 * ground.tip.value(-motion.shift.value(-fillet.z))),
        );
        let difference = refereed(prepared, execution, flank, &ground, choice.corner_radius)?;
        Ok(Some(FilletResult {
            form_diameter_mm: ground.fillets.iter().map(|f| 2.0 * f.form_radius()).fold(0.0, f64::max),
            least_radius_mm: ground
                .fillets
                .iter()
                .map(|f| f.least_radius_of_curvature())
                .fold(f64::INFINITY, f64::min),
            model_difference_um: difference * 1e3,
            sections: ground
                .fillets
                .iter()
                .map(|f| FilletSection { z_mm: f.z, points_mm: f.points(POINTS) })
                .collect(),
        }))
    })?;
    Ok(Some(GearRootResult {
        root_diameter_mm: extremes(roots),
        worm_tip_diameter_mm: extremes(tips),
        flanks,
    }))
}

/// Largest length of rays that stand on the planned fillets, across them in the transverse section, mm.
fn refereed(
    prepared: &Prepared,
    execution: &Execution,
    flank: Flank,
    ground: &GroundRoot,
    corner_radius: f64,
) -> Result<f64, RunFailure> {
    let setup = &prepared.setup;
    let grinding = RootGrinding {
        worm: setup.pair.worm.flank(flank),
        modification: &Unmodified,
        corner_radius,
        tip: &ground.tip,
        motion: &execution.motion,
        feeds: [f64::NEG_INFINITY, f64::INFINITY],
        along: FILLET_ALONG,
    };
    let rays: Vec<RootRay> = ground
        .fillets
        .iter()
        .flat_map(|fillet| {
            fillet.rays(RAYS).into_iter().map(|([x, y], [n_x, n_y])| RootRay {
                foot: Vector3::new(x, y, fillet.z),
                direction: Vector3::new(n_x, n_y, 0.0),
            })
        })
        .collect();
    let lengths = grinding.lengths(&rays).map_err(|e| RunFailure::of_removal(&e, "dressing.gear_root"))?;
    let mut largest: f64 = 0.0;
    for (ray, length) in rays.iter().zip(lengths) {
        match length {
            Some(length) if length.abs() <= AGREED => largest = largest.max(length.abs()),
            found => {
                let error = GeneratingError::RootNotConfirmed { flank, z: ray.foot.z, difference: found };
                return Err(generating_finding::on_field(&error, "dressing.gear_root"));
            }
        }
    }
    Ok(largest)
}
