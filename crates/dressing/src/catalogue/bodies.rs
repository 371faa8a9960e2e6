//! Worms and dressers as a catalogue lists them, and the rule that puts a worm between gear and dresser. Knows no target.

use crate::{DresserTool, DressingError, WormSeat};
use foundation::geometry::{Flank, GeometryError, Sides, WormChoice};

/// What of a dresser decides where it stands. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DresserSize {
    /// Outside radius r_aA.
    pub tip_radius: f64,
    /// Pitch radius; without one the disc tip touches the worm root.
    pub pitch_radius: Option<f64>,
}

/// The rule by which a worm for a gear gets its body, its used range and its place under a dresser.
pub trait Workshop: Sync {
    /// The worm of this choice under a dresser of this size.
    ///
    /// # Errors
    /// Worms that are impossible, do not mesh with the gear or cannot be dressed.
    fn seat(&self, worm: &WormChoice, dresser: DresserSize) -> Result<WormSeat, DressingError>;
}

/// A diameter of a worm that dressing has worn down. mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WornDiameter {
    /// Pitch diameter.
    Pitch(f64),
    /// Tip diameter.
    Tip(f64),
}

/// A worm of a catalogue. mm, rad.
#[derive(Clone, Debug, PartialEq)]
pub struct CatalogueWorm {
    /// What the catalogue calls it.
    pub name: String,
    /// The worm as it is now.
    pub choice: WormChoice,
    /// Profile angle of the right flank, if the catalogue states it; that of the left flank decides, and both must mesh.
    pub right_angle: Option<f64>,
    /// Normal module, if the catalogue states it; it must be the one with which the gear meshes.
    pub normal_module: Option<f64>,
    /// Diameter down to which it may be dressed; without one it is looked at as it is now.
    pub smallest: Option<WornDiameter>,
    /// Usable width.
    pub width: f64,
}

/// A dresser of a catalogue. mm, rad.
#[derive(Clone, Debug, PartialEq)]
pub struct CatalogueDresser {
    /// What the catalogue calls it.
    pub name: String,
    /// Where it stands.
    pub size: DresserSize,
    /// The worm it was designed for. The hand is that of the worm it dresses: turned over, a dresser serves the other hand.
    pub designed_for: WormChoice,
    /// Profile angle of its right flank, if the catalogue states it.
    pub designed_right_angle: Option<f64>,
    /// Normal module of that worm, if the catalogue states it.
    pub designed_module: Option<f64>,
    /// Profile crowning of the gear that it makes on that worm, transverse, positive = convex gear.
    pub crowning: Sides<f64>,
    /// Width of its tip land, if the catalogue states it.
    pub tip_land: Option<f64>,
    /// Radii between which its flanks are profiled, if the catalogue states them.
    pub flank: Option<[f64; 2]>,
}

/// A dresser where it was designed, without the crowning that it carries.
#[derive(Clone, Debug)]
pub struct DesignedDresser {
    /// Its profiles on the worm that it was designed for.
    pub tool: DresserTool,
    /// That worm.
    pub seat: WormSeat,
}

/// A module of the catalogue may differ from the one that meshes by this share (`docs/mathematics/dressing.md#limits-of-a-correction`).
const MATING: f64 = 1e-6;

/// Refuses a stated module or right profile angle that does not mesh: the normal base pitch would be another one.
fn check_mating(seat: &WormSeat, module: Option<f64>, right_angle: Option<f64>) -> Result<(), DressingError> {
    let data = seat.worm.data();
    for flank in Flank::BOTH {
        let angle = match (flank, right_angle) {
            (Flank::Right, Some(angle)) => angle,
            _ => data.pressure_angle[flank],
        };
        let share = module.unwrap_or(data.normal_module) * angle.cos()
            / (data.normal_module * data.pressure_angle[flank].cos());
        // A share that is no number is no match either.
        if share.is_nan() || (share - 1.0).abs() > MATING {
            let gear = seat.worm.normal_base_pitch(flank);
            return Err(GeometryError::NotMating { flank, worm: gear * share, gear }.into());
        }
    }
    Ok(())
}

impl CatalogueWorm {
    /// The worm as it is now under a dresser.
    ///
    /// # Errors
    /// Those of [`Workshop::seat`]; [`GeometryError::NotMating`] for a module with which the gear does not mesh.
    pub fn seat(&self, workshop: &dyn Workshop, dresser: DresserSize) -> Result<WormSeat, DressingError> {
        let seat = workshop.seat(&self.choice, dresser)?;
        check_mating(&seat, self.normal_module, self.right_angle)?;
        Ok(seat)
    }

    /// The worm dressed down to a pitch diameter; its addendum stays.
    pub fn worn(&self, now: &WormSeat, pitch_diameter: f64) -> WormChoice {
        let addendum = now.tip_radius - now.reference_radius();
        WormChoice {
            pitch_diameter: Some(pitch_diameter),
            tip_diameter: Some(pitch_diameter + 2.0 * addendum),
            ..self.choice
        }
    }

    /// Smallest pitch diameter that it may reach, mm; the current one if none is stated.
    ///
    /// # Errors
    /// [`DressingError::InvalidNumber`] for one above the current one or not above 0.
    pub fn smallest_pitch_diameter(&self, now: &WormSeat) -> Result<f64, DressingError> {
        let pitch = 2.0 * now.reference_radius();
        let smallest = match self.smallest {
            None => pitch,
            Some(WornDiameter::Pitch(d)) => d,
            Some(WornDiameter::Tip(d)) => d - 2.0 * (now.tip_radius - now.reference_radius()),
        };
        if smallest > 0.0 && smallest <= pitch * (1.0 + 1e-12) {
            return Ok(smallest.min(pitch));
        }
        Err(DressingError::InvalidNumber {
            field: "smallest pitch diameter of the worm",
            value: smallest,
            allowed: "above 0 and at most the present diameter",
        })
    }
}

impl CatalogueDresser {
    /// The worm that it was designed for, with the hand of the one that it shall dress.
    pub fn designed_worm(&self, hand: f64) -> WormChoice {
        WormChoice { hand, ..self.designed_for }
    }

    /// The dresser on the worm for which it was designed.
    ///
    /// # Errors
    /// Those of [`Workshop::seat`] and of [`DresserTool::conjugate`]; [`GeometryError::NotMating`] for a module with which the
    /// gear does not mesh.
    pub fn designed(&self, workshop: &dyn Workshop, hand: f64) -> Result<DesignedDresser, DressingError> {
        let seat = workshop.seat(&self.designed_worm(hand), self.size)?;
        seat.check()?;
        check_mating(&seat, self.designed_module, self.designed_right_angle)?;
        let tool = DresserTool::conjugate(&seat.worm, seat.chains, seat.ranges)?;
        Ok(DesignedDresser { tool, seat })
    }
}
