//! How the gear was measured: ranges and places of the header in the coordinates of the library.

use super::super::HeaderEntry;
use super::super::settings::Settings;
use super::Place;
use crate::inspection::{
    Conditions, DatumFace, FlankConditions, InspectionError, LeadPositions, ProfilePositions,
};
use foundation::geometry::{Flank, Sides};

impl Place<'_> {
    pub fn conditions(&self, settings: &Settings) -> Result<Conditions, InspectionError> {
        let stylus = self.file.header.get(&101).and_then(HeaderEntry::number);
        Ok(Conditions {
            flanks: Sides::try_from_fn(|flank| self.flank_conditions(settings, flank))?,
            section: settings.section,
            stylus_diameter_mm: stylus.filter(|d| *d > 0.0),
            helix_filter: None,
            profile_filter: None,
            temperature_c: None,
            turned: false,
            datum_face: DatumFace::PlusZ,
            helix_slope_reference: settings.helix_reference,
            profile_slope_reference: settings.profile_reference,
        })
    }

    fn flank_conditions(
        &self,
        settings: &Settings,
        flank: Flank,
    ) -> Result<FlankConditions, InspectionError> {
        // A line that a program left at 0 states no diameter.
        let roll = |code: u16| {
            let stated = self.two_sided(code, flank).filter(|d| *d > 0.0);
            stated.map(|diameter| self.roll(code, flank, diameter)).transpose()
        };
        // Without a face width no height of the file has a place; traces that need one say so.
        let height = |code: u16| self.two_sided(code, flank).and_then(|z| self.height(z).ok());
        let (relief_start, relief_end) = (roll(431)?, roll(432)?);
        Ok(FlankConditions {
            w_start_mm: roll(41)?,
            w_1_mm: roll(42)?,
            w_2_mm: roll(43)?,
            w_end_mm: roll(44)?,
            tip_relief_mm: relief_start.zip(relief_end).map(|(start, end)| [start, end]),
            root_relief_mm: None,
            z_a_mm: height(61),
            z_1_mm: height(62),
            z_2_mm: height(63),
            z_b_mm: height(64),
            profiles: ProfilePositions { bottom_mm: height(68), middle_mm: height(65), top_mm: height(69) },
            leads: LeadPositions { inner_mm: roll(48)?, middle_mm: roll(46)?, outer_mm: roll(49)? },
            printed_sign: settings.printed_signs.map(|signs| signs[flank]),
        })
    }
}
