//! Settings of the measuring program that decide what a number means. What no measurement has proven is refused or reported, never guessed.

use super::KlingelnbergFile;
use crate::inspection::{
    CountingDirection, InspectionError, InspectionWarning, Section, SlopeReference, WarningKind,
};
use foundation::geometry::Sides;

/// What the settings say.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Settings {
    pub section: Section,
    pub counting: Option<CountingDirection>,
    pub printed_signs: Option<Sides<f64>>,
    pub helix_reference: Option<SlopeReference>,
    pub profile_reference: Option<SlopeReference>,
    pub warnings: Vec<InspectionWarning>,
}

impl Settings {
    /// Reads the settings of a file.
    pub fn of(file: &KlingelnbergFile) -> Result<Self, InspectionError> {
        units(file)?;
        let mode = |code: u16| {
            let entry = file.header.get(&code)?;
            entry.fields().first().and_then(|field| field.split_whitespace().next()?.parse::<i64>().ok())
        };
        let refuse = |code: u16, value: &str, reason| {
            Err(InspectionError::UnverifiedSetting {
                setting: format!("code {code}"),
                value: value.to_owned(),
                reason,
            })
        };
        if mode(164) == Some(1) {
            return refuse(
                164,
                "1",
                "the names of the flanks are those of the USA, left and right may be swapped",
            );
        }
        let section = match mode(183) {
            None | Some(0) => Section::Transverse,
            Some(1) => Section::Normal,
            Some(2) => return refuse(183, "2", "deviations in the axial section are not proven"),
            Some(other) => return refuse(183, &other.to_string(), "no section of this number is known"),
        };
        let mut settings = Self {
            section,
            counting: mode(161).and_then(|value| match value {
                0 => Some(CountingDirection::Clockwise),
                1 => Some(CountingDirection::CounterClockwise),
                _ => None,
            }),
            printed_signs: printed_signs(file),
            helix_reference: mode(179).and_then(reference),
            profile_reference: mode(180).and_then(reference),
            warnings: Vec::new(),
        };
        let doubts = [
            (162, 1, "the teeth are distributed as in the USA; what their numbers mean is not proven"),
            (163, 1, "spaces were measured, not teeth; which numbers belong to which flanks is not proven"),
            (
                178,
                0,
                "the signs of the curves are those of VDI; they are read as those of DIN, which is not proven",
            ),
        ];
        for (code, doubtful, message) in doubts {
            if mode(code) == Some(doubtful) {
                settings.doubt(code, message);
            }
        }
        if mode(165).is_some_and(|value| value != 1) {
            settings.doubt(165, "only the signs of DIN (mode 1) are proven; those of the file are taken");
        }
        settings.assume(file);
        Ok(settings)
    }

    /// Where there are traces: what was taken for settings that the file does not state.
    fn assume(&mut self, file: &KlingelnbergFile) {
        let assumed = [
            (165, "signs of helix slopes not stated; they are given as those of DIN"),
            (178, "signs of the curves not stated; they are read as those of DIN"),
            (183, "section not stated; values are read as transverse"),
        ];
        for (code, message) in assumed {
            if !file.curves.is_empty() && !file.header.contains_key(&code) {
                self.doubt(code, message);
            }
        }
    }

    fn doubt(&mut self, code: u16, message: &str) {
        let message = format!("code {code}: {message}");
        self.warnings.push(InspectionWarning::new(WarningKind::UnverifiedSetting, message));
    }
}

/// Lengths in mm, angles as decimal degrees, profiles by diameters: nothing else is proven.
fn units(file: &KlingelnbergFile) -> Result<(), InspectionError> {
    let known = [
        ("UNITS", "mm", "only files in mm are read"),
        ("ANGLE", "decimal", "only angles in decimal degrees are read"),
        ("PROFILE", "diameter", "only profiles whose ends are diameters are read"),
        ("SEPARATOR", ":", "only files whose columns are separated by colons are read"),
    ];
    for (key, expected, reason) in known {
        let Some(entry) = file.preamble.iter().rev().find(|entry| entry.key == key) else { continue };
        let value = entry.value.split_whitespace().next().unwrap_or("");
        if value != expected {
            return Err(InspectionError::UnverifiedSetting {
                setting: key.into(),
                value: value.chars().take(40).collect(),
                reason,
            });
        }
    }
    Ok(())
}

/// sigma_F of both flanks, from `mode : L: + : R: -`.
fn printed_signs(file: &KlingelnbergFile) -> Option<Sides<f64>> {
    let entry = file.header.get(&165)?;
    let fields = entry.fields();
    let of = |name: &str| {
        let at = fields.iter().position(|field| *field == name)?;
        match *fields.get(at + 1)? {
            "+" => Some(1.0),
            "-" => Some(-1.0),
            _ => None,
        }
    };
    Some(Sides { left: of("L")?, right: of("R")? })
}

fn reference(mode: i64) -> Option<SlopeReference> {
    match mode {
        0 => Some(SlopeReference::Range),
        1 => Some(SlopeReference::FaceWidth),
        _ => None,
    }
}
