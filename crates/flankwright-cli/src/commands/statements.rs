//! What the user states about measurements whose files do not tell it.

use clap::{Args, ValueEnum};
use flankwright::exchange::inspection::{DatumFace, SlopeReference};
use flankwright::geometry::{Flank, Sides};
use flankwright::workflow::inspection::Statements;

/// Statements about measurements.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "About the measurement, where its file does not tell")]
pub struct StatementArguments {
    /// The gear was measured from the other end: left and right are exchanged, heights turned
    #[arg(long)]
    from_other_end: bool,
    /// Signs of printed helix slopes: `material` (rising to the upper end of the file), `din` (right-handed turn), or typed for left and
    /// right flank, e.g. `+-`
    #[arg(long, value_name = "SIGNS", allow_hyphen_values = true, value_parser = slope_signs)]
    slope_signs: Option<Sides<f64>>,
    /// Face from which distances along the face count: `+z` (upper) or `-z`
    #[arg(long, value_name = "FACE", allow_hyphen_values = true, value_parser = datum_face)]
    datum_face: Option<DatumFace>,
    /// Length to which helix slopes refer
    #[arg(long, value_name = "LENGTH")]
    helix_slope_over: Option<Length>,
    /// Length to which profile slopes refer
    #[arg(long, value_name = "LENGTH")]
    profile_slope_over: Option<Length>,
}

#[derive(ValueEnum, Clone, Copy, Debug)]
enum Length {
    /// The face width
    FaceWidth,
    /// The evaluated range
    Range,
}

impl From<Length> for SlopeReference {
    fn from(length: Length) -> Self {
        match length {
            Length::FaceWidth => Self::FaceWidth,
            Length::Range => Self::Range,
        }
    }
}

impl StatementArguments {
    /// The statements.
    pub fn statements(&self) -> Statements {
        Statements {
            other_end: self.from_other_end,
            slope_signs: self.slope_signs,
            datum_face: self.datum_face,
            helix_slope_over: self.helix_slope_over.map(Into::into),
            profile_slope_over: self.profile_slope_over.map(Into::into),
        }
    }
}

fn slope_signs(text: &str) -> Result<Sides<f64>, String> {
    let sign = |sign: char| match sign {
        '+' => Some(1.0),
        '-' => Some(-1.0),
        _ => None,
    };
    let mut typed = text.chars().map(sign);
    match (text, typed.next(), typed.next(), typed.next()) {
        ("material", ..) => Ok(Sides::both(1.0)),
        ("din", ..) => Ok(Sides::from_fn(Flank::sign)),
        (_, Some(Some(left)), Some(Some(right)), None) => Ok(Sides { left, right }),
        _ => Err("allowed: material, din, or a sign for each flank, left first: ++, +-, -+, --".into()),
    }
}

fn datum_face(text: &str) -> Result<DatumFace, String> {
    match text {
        "+z" => Ok(DatumFace::PlusZ),
        "-z" => Ok(DatumFace::MinusZ),
        _ => Err("allowed: +z, -z".into()),
    }
}
