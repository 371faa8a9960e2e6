//! What the user states about a measurement because its file does not tell it, or cannot: the end it was taken from, the datum face, signs and
//! lengths of slopes. Nothing of this is ever guessed.

use super::files::MeasuredFiles;
use crate::exchange::inspection::{Characteristic, DatumFace, SlopeReference};
use crate::exchange::{Diagnostic, Problem};
use crate::geometry::Sides;
use crate::workflow::finding::RunFailure;

/// Statements about a measurement; by default none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Statements {
    /// The gear was measured from the other end: what the file calls left is right, and its heights count the other way.
    pub other_end: bool,
    /// sigma_F of helix slopes: printed value = sigma_F times the slope of the material towards the upper end of the file; +1 or -1.
    pub slope_signs: Option<Sides<f64>>,
    /// The face from which distances along the face count.
    pub datum_face: Option<DatumFace>,
    /// The length to which helix slopes refer.
    pub helix_slope_over: Option<SlopeReference>,
    /// The length to which profile slopes refer.
    pub profile_slope_over: Option<SlopeReference>,
}

impl Statements {
    /// Whether nothing is stated.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// Gives a measurement what is stated about it, and notes that.
    pub(super) fn apply(&self, mut files: MeasuredFiles) -> MeasuredFiles {
        let mut stated = Vec::new();
        if let Some(signs) = self.slope_signs {
            stated.push(format!("signs of helix slopes {:+} left, {:+} right", signs.left, signs.right));
            for (flank, sign) in signs.iter() {
                files.inspection.conditions.flanks[flank].printed_sign = Some(*sign);
            }
            for result in &mut files.inspection.results {
                if let (Characteristic::HelixSlope, Some(flank)) =
                    (result.meaning.characteristic, result.meaning.flank)
                {
                    result.sigma = Some(signs[flank]);
                }
            }
        }
        let conditions = &mut files.inspection.conditions;
        let words = |reference| match reference {
            SlopeReference::FaceWidth => "the face width",
            SlopeReference::Range => "the evaluated range",
        };
        if let Some(reference) = self.helix_slope_over {
            stated.push(format!("helix slopes over {}", words(reference)));
            conditions.helix_slope_reference = Some(reference);
        }
        if let Some(reference) = self.profile_slope_over {
            stated.push(format!("profile slopes over {}", words(reference)));
            conditions.profile_slope_reference = Some(reference);
        }
        if self.other_end {
            stated.push("measured from the other end: left and right exchanged, heights turned".into());
            files.inspection = files.inspection.turned();
        }
        if let Some(face) = self.datum_face {
            let name = if face == DatumFace::PlusZ { "+z" } else { "-z" };
            stated.push(format!("datum face {name}"));
            files.inspection.conditions.datum_face = face;
        }
        files.stated = stated;
        files
    }

    /// A REXS model tells its datum face, and everything in it stands by that.
    ///
    /// # Errors
    /// [`RunFailure::BadInput`] naming the statement.
    pub(super) fn check_rexs(&self) -> Result<(), RunFailure> {
        let field = match self {
            Self { other_end: true, .. } => "from_other_end",
            Self { datum_face: Some(_), .. } => "datum_face",
            _ => return Ok(()),
        };
        let finding = Diagnostic::new(Problem::InvalidJob, "a REXS model tells its datum face itself")
            .field(field)
            .value("stated for a REXS file")
            .allowed("only for files of measuring machines and tables")
            .way_out("leave the statement out, or correct datum_face_orientation in the model");
        Err(RunFailure::bad_input(finding))
    }
}
