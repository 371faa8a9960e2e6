//! Worms for one gear by the table of defaults (`docs/mathematics/involute-gears.md#the-worm-as-a-helical-gear`), put between gear and
//! dresser for the search in a catalogue.

use super::setup::{Placed, check_depth, dressing_place};
use super::{DresserChoice, GeneratingError};
use dressing::catalogue::{DresserSize, Workshop};
use dressing::{DressingError, WormSeat};
use foundation::geometry::{Blank, Gear, WormChoice};

/// A gear and how worms grind it. mm.
#[derive(Clone, Debug, PartialEq)]
pub struct GearWorkshop {
    /// The workpiece.
    pub gear: Gear,
    /// Its diameters and face width.
    pub blank: Blank,
    /// Evaluation range: start diameter, end diameter, z from, z to.
    pub evaluation: [f64; 4],
    /// Clearance between gear tip and worm root; default 0.25 m_n0.
    pub root_clearance: Option<f64>,
}

impl Workshop for GearWorkshop {
    fn seat(&self, worm: &WormChoice, dresser: DresserSize) -> Result<WormSeat, DressingError> {
        let place = || -> Result<WormSeat, GeneratingError> {
            let (gear, blank) = (&self.gear, &self.blank);
            let placed = Placed::new(gear, blank, self.evaluation, worm, None, self.root_clearance)?;
            let choice = DresserChoice {
                tip_diameter: 2.0 * dresser.tip_radius,
                pitch_diameter: dresser.pitch_radius.map(|r| 2.0 * r),
                designed_for: None,
            };
            let made = placed.made;
            let (root_radius, chains) = dressing_place(&choice, &made.worm, placed.root_by_gear);
            check_depth(&made.worm, root_radius)?;
            Ok(WormSeat { worm: made.worm, chains, ranges: placed.ranges, tip_radius: made.tip_radius })
        };
        place().map_err(|error| match error {
            GeneratingError::Geometry(e) => e.into(),
            GeneratingError::Contact(e) => e.into(),
            GeneratingError::Dressing(e) => e,
            GeneratingError::Modification(_) => DressingError::InvalidNumber {
                field: "evaluation range",
                value: self.evaluation[0],
                allowed: "a range of the gear's involute",
            },
            _ => DressingError::InvalidNumber {
                field: "worm pitch diameter",
                value: worm.pitch_diameter.or(worm.tip_diameter).unwrap_or(f64::NAN),
                allowed: "a worm that stands between gear and dresser",
            },
        })
    }
}
