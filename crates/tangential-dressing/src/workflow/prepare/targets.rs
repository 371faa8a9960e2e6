//! The wanted flank of a job, as the drawing states it and as a function over the flank.

use crate::job::{EdgeAmounts as DrawnAmounts, LoadedTangentialJob, TangentialTarget};
use crate::{EdgeAmounts, TangentialModel};
use foundation::geometry::{Flank, Sides};
use foundation::modification::{EvaluationField, Modification, ModificationSpec};
use job::Diagnostic;
use run::specs_of_flank;

/// The entries of the target as the drawing states them.
#[derive(Clone, Debug)]
pub enum Drawn {
    /// Amounts at the edge of the evaluated range.
    Edge(Sides<DrawnAmounts>),
    /// Modifications.
    Modifications(Vec<ModificationSpec>),
}

impl Drawn {
    /// Of a target.
    pub(super) fn of(target: &TangentialTarget) -> Self {
        match &target.edge_amounts {
            Some(amounts) => Self::Edge(amounts.sides()),
            None => Self::Modifications(target.modifications.clone().unwrap_or_default()),
        }
    }
}

/// What is wanted of a flank.
pub enum WantedFlank {
    /// Amounts at the edge of the evaluated range, normal.
    Edge(EdgeAmounts),
    /// Modifications, transverse.
    Modifications(Box<Modification>),
}

impl WantedFlank {
    /// Material left, normal, mm; NaN where the modification has no value.
    pub fn value(&self, model: &TangentialModel, flank: Flank, w: f64, z: f64) -> f64 {
        match self {
            Self::Edge(amounts) => amounts.value(model, flank, w, z),
            Self::Modifications(modification) => {
                let normal = modification.field().normal_factor();
                modification.value(w, z).map_or(f64::NAN, |f| f * normal)
            }
        }
    }
}

/// What the drawing wants of a flank of a job.
///
/// # Errors
/// A finding on `target.modifications`.
pub(super) fn wanted_flank(
    loaded: &LoadedTangentialJob,
    drawn: &Drawn,
    model: &TangentialModel,
    flank: Flank,
) -> Result<WantedFlank, Diagnostic> {
    let specs = match drawn {
        Drawn::Edge(amounts) => {
            let um = &amounts[flank];
            return Ok(WantedFlank::Edge(EdgeAmounts {
                pressure_angle: um.pressure_angle_um * 1e-3,
                profile_crowning: um.profile_crowning_um * 1e-3,
                lead_conical: um.lead_conical_um * 1e-3,
                lead_crowning: um.lead_crowning_um * 1e-3,
            }));
        }
        Drawn::Modifications(specs) => specs,
    };
    let field = evaluation_field(model, flank, "target.modifications")?;
    specs_of_flank(loaded, specs, flank, &field).map(|m| WantedFlank::Modifications(Box::new(m)))
}

/// The evaluated range of a flank, over which modifications are stated; `key` is where they stand.
///
/// # Errors
/// A finding on that key.
pub(super) fn evaluation_field(
    model: &TangentialModel,
    flank: Flank,
    key: &str,
) -> Result<EvaluationField, Diagnostic> {
    let f = model.pair.work.flank(flank);
    EvaluationField::new(model.rolls(flank), model.input().faces, f.base_radius, f.base_helix_angle)
        .map_err(|e| run::modification_finding(&e, key))
}
