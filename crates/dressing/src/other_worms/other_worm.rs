//! A dresser put on another worm than the one it was designed for (`docs/mathematics/dressing.md#conditions`): same gear, other diameter,
//! profile angle or number of threads. Knows no wanted profile and no limit.

use crate::dresser::conjugate_line;
use crate::{DresserTool, DressingError, FlankDresser, GeometricRange};
use foundation::geometry::{Flank, Gear, GeometryError, InvoluteFlank, Sides};
use foundation::kinematics::DressingChain;

/// A worm under a dresser: body, nominal kinematics of dressing and what of its profile generates the gear. mm, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WormSeat {
    /// The worm as a toothed body.
    pub worm: Gear,
    /// Nominal kinematics per flank.
    pub chains: Sides<DressingChain>,
    /// Used lengths of roll per flank.
    pub ranges: Sides<GeometricRange>,
    /// Tip radius of the worm.
    pub tip_radius: f64,
}

/// Normal base pitches of two worms for one gear may differ by this share (`docs/mathematics/dressing.md#limits-of-a-correction`).
const MATING: f64 = 1e-6;
/// Share of the used range by which the start line of the contact is continued at each end.
pub(crate) const LINE_MARGIN: f64 = 0.1;
/// Profile angles of grinding worms, degrees (`docs/mathematics/dressing.md#limits-of-a-correction`).
const ANGLES: std::ops::RangeInclusive<f64> = 5.0..=45.0;

impl WormSeat {
    /// Refuses worms outside the range in which `docs/mathematics/dressing.md` holds.
    ///
    /// # Errors
    /// [`GeometryError::InvalidGeometry`] for a profile angle outside 5 to 45 degrees or a used range that is empty or reaches
    /// the base cylinder.
    pub fn check(&self) -> Result<(), DressingError> {
        for flank in Flank::BOTH {
            let angle = self.worm.data().pressure_angle[flank].to_degrees();
            if !ANGLES.contains(&angle) {
                return Err(GeometryError::InvalidGeometry {
                    what: format!("normal profile angle of the {flank} worm flank (deg)"),
                    value: angle,
                    allowed: format!("{} to {}", ANGLES.start(), ANGLES.end()),
                }
                .into());
            }
            let range = self.ranges[flank];
            if !(range.w_nf > 0.0 && range.w_na > range.w_nf && range.w_na.is_finite()) {
                return Err(GeometryError::InvalidGeometry {
                    what: format!(
                        "smallest length of roll w_NfS used on the {flank} worm flank (mm), up to w_NaS = {:.4}",
                        range.w_na
                    ),
                    value: range.w_nf,
                    allowed: "> 0 and below w_NaS".into(),
                }
                .into());
            }
        }
        Ok(())
    }

    /// Pitch radius r_S, mm.
    pub fn reference_radius(&self) -> f64 {
        self.worm.pitch_radius()
    }
}

impl DresserTool {
    /// This dresser on another worm for the same gear. Profiles and the range they were designed for stay; what DK = 0 dresses
    /// there is no involute any more: see [`crate::fit_profile`].
    ///
    /// # Errors
    /// Those of [`WormSeat::check`]; [`GeometryError::NotMating`] where the normal base pitch differs by more than 1e-6;
    /// [`DressingError::NoConjugate`] for a worm that no disc dresses in these kinematics.
    pub fn on_worm(&self, seat: &WormSeat) -> Result<Self, DressingError> {
        seat.check()?;
        let flanks = Sides::try_from_fn(|flank| {
            let own = &self.flanks[flank];
            let worm = *seat.worm.flank(flank);
            let (there, here) = (base_pitch(&worm), base_pitch(&own.worm));
            if (there - here).abs() > MATING * here {
                return Err(GeometryError::NotMating { flank, worm: there, gear: here }.into());
            }
            let (chain, range) = (seat.chains[flank], seat.ranges[flank]);
            let line = conjugate_line(&worm, &chain, &range, LINE_MARGIN)?;
            Ok::<_, DressingError>(FlankDresser {
                worm,
                chain,
                settled: [0.0; 4],
                range,
                line,
                ..own.clone()
            })
        })?;
        Ok(Self { flanks, head: self.head.clone() })
    }
}

/// Normal base pitch, mm; m_n cos(alpha_n) times pi.
fn base_pitch(flank: &InvoluteFlank) -> f64 {
    2.0 * std::f64::consts::PI * flank.base_radius * flank.base_helix_angle.cos() / flank.teeth
}
