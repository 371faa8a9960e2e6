//! Numbers that describe a dressed profile or a dresser as a whole: stretch, tip land, and the flank of a slowly changing
//! correction (`docs/mathematics/dressing.md`). Knows no wanted modification.

use super::{DressedProfile, DresserTool, DressingError, FlankDresser, nominal_contact};
use foundation::geometry::Flank;
use foundation::kinematics::{DressingCorrection, DressingMotion};

/// Relative stretch P_FS of the profile at correction `dk`: > 0 where the dressed profile is longer than the used range.
///
/// # Errors
/// As [`DressedProfile::at_parameter`].
pub fn stretch(tool: &DresserTool, flank: Flank, dk: DressingCorrection) -> Result<f64, DressingError> {
    let (range, designed) = (tool.flanks[flank].range, tool.flanks[flank].designed);
    let dressed = DressedProfile::new(tool, flank, dk).at_parameter(designed.w_nf)?;
    Ok((dressed.w - range.w_nf) / (range.w_nf - range.w_na))
}

/// Secant steps at most; the radius of the meridian is nearly linear in the length of roll.
const STEPS: usize = 40;

/// Width of the land that the conjugate flanks leave between them on the cylinder of radius `tip_radius`, mm: the largest tip
/// land of the dresser without its modification.
///
/// # Errors
/// [`DressingError::NoConjugate`] where a flank does not reach that radius.
pub fn full_tip_land(tool: &DresserTool, tip_radius: f64) -> Result<f64, DressingError> {
    let axial = |flank: Flank| -> Result<f64, DressingError> {
        let FlankDresser { worm, chain, range, .. } = &tool.flanks[flank];
        let at = |w: f64| nominal_contact(worm, chain, w);
        let (mut w_0, mut w_1) = (range.middle(), range.w_nf);
        let mut r_0 = at(w_0)?.r;
        for _ in 0..STEPS {
            let here = at(w_1)?;
            let step = (here.r - tip_radius) * (w_1 - w_0) / (here.r - r_0);
            if step.abs() < 1e-13 * range.w_na || here.r == tip_radius {
                return Ok(here.z);
            }
            (w_0, r_0, w_1) = (w_1, here.r, w_1 - step);
        }
        Err(DressingError::NoConjugate { flank, w: w_1 })
    };
    Ok((axial(Flank::Left)? - axial(Flank::Right)?).abs())
}

/// Rounds of the fixed point in v; the contact line moves by a small share of v only.
const ROUNDS: usize = 200;

/// First-order flank of a dressing motion at worm point (w, b): the profile of the correction that stands still at the worm
/// position v at which that point lies on the contact line. Returns (f, v), mm.
///
/// The exact envelope is [`super::DressedWorm`]; the difference is what the motion itself adds.
///
/// # Errors
/// As [`DressedProfile::at_roll`]; [`DressingError::OutOfDresser`] where no position puts the point on the contact line.
pub fn quasi_static_modification(
    tool: &DresserTool,
    flank: Flank,
    motion: &DressingMotion,
    w: f64,
    b: f64,
) -> Result<(f64, f64), DressingError> {
    let mut v = tool.flanks[flank].line.value(w) - b;
    for _ in 0..ROUNDS {
        let at = DressedProfile::new(tool, flank, motion.correction_at(v)).at_roll(w)?;
        let moved = at.b - b - v;
        v += moved;
        if moved.abs() < 1e-11 * (1.0 + v.abs()) {
            return Ok((at.f, v));
        }
    }
    let (from, to) = tool.flanks[flank].profile.interval();
    Err(DressingError::OutOfDresser { flank, w, from, to })
}
