//! The dresser that a plan made for the new worm, as one that exists.

use crate::job::{DesignedFor, DresserModification, LoadedJob};
use crate::workflow::execution::ExecutedDressing;
use crate::workflow::run::Outcome;
use foundation::geometry::Flank;
use foundation::kinematics::PiecewisePolynomial;
use foundation::modification::{FlankChoice, GridSpec, ModificationSpec, PolynomialSpec, Reference};
use foundation::numerics::equidistant;

/// Places of a table of the profile along the length of roll, and how far it goes beyond the flank, as a share of it.
const ROLLS: usize = 129;
const BEYOND: f64 = 0.25;
/// Rows of a table that is the same all along the face.
const FACES: usize = 4;
const UM: f64 = 1e3;

/// The job of a worn worm, both diameters stated, with the dresser of the new one. A dresser that was there already stays as it is.
pub fn with_dresser_of(new: &LoadedJob, outcome: &Outcome, tip_diameter: f64) -> LoadedJob {
    let mut worn = new.clone();
    let pitch_diameter = 2.0 * outcome.prepared.setup.worm_pitch_radius;
    let worm = &mut worn.job.worm;
    (worm.pitch_diameter, worm.tip_diameter) = (Some(pitch_diameter), Some(tip_diameter));
    let (threads, angle) = (worm.threads, worm.normal_pressure_angle_deg);
    let Some(dresser) = &mut worn.job.dresser else { return worn };
    dresser.designed_for.get_or_insert(DesignedFor {
        threads,
        pitch_diameter: Some(pitch_diameter),
        tip_diameter: Some(tip_diameter),
        normal_pressure_angle_deg: angle,
        normal_module: None,
    });
    if dresser.modification.given().is_none() {
        dresser.modification = DresserModification::Sum(profile_of(outcome));
    }
    worn
}

/// What the dresser of a plan leaves on the gear.
fn profile_of(outcome: &Outcome) -> Vec<ModificationSpec> {
    let mut entries = Vec::new();
    for flank in Flank::BOTH {
        let executed = outcome.execution.flanks[flank].as_ref();
        let Some(dressing) = executed.and_then(|executed| executed.dressing()) else { continue };
        let choice = FlankChoice::from(flank);
        let field = &outcome.prepared.setup.fields[flank];
        entries.extend(polynomial(dressing, field.roll_middle(), choice));
        if let Some(spline) = &dressing.spline {
            entries.push(table(spline, (field.roll(), field.face()), choice));
        }
        // Reliefs of the target say themselves for which flanks they are; those of one flank are the same on both or say so.
        entries.extend(
            dressing
                .reliefs
                .iter()
                .filter(|relief| {
                    relief.flank() == choice || relief.flank() == FlankChoice::Both && flank == Flank::Left
                })
                .cloned(),
        );
    }
    entries
}

fn polynomial(dressing: &ExecutedDressing, w0_mm: f64, flank: FlankChoice) -> Option<ModificationSpec> {
    let terms: Vec<(u32, u32, f64)> =
        (0..).zip(&dressing.profile).map(|(k, c)| (k, 0, UM * c)).filter(|term| term.2 != 0.0).collect();
    if terms.is_empty() {
        return None;
    }
    let reference = Reference::default();
    Some(ModificationSpec::Polynomial(PolynomialSpec { w0_mm, z0_mm: 0.0, terms, flank, reference }))
}

fn table(
    spline: &PiecewisePolynomial,
    ([from, to], face): ([f64; 2], [f64; 2]),
    flank: FlankChoice,
) -> ModificationSpec {
    let beyond = BEYOND * (to - from);
    let w_mm = equidistant([(from - beyond).max(0.0), to + beyond], ROLLS);
    let f_um = w_mm.iter().map(|&w| vec![UM * spline.jet(w)[0]; FACES]).collect();
    ModificationSpec::Grid(GridSpec {
        w_mm,
        z_mm: equidistant(face, FACES),
        f_um,
        flank,
        ..GridSpec::default()
    })
}
