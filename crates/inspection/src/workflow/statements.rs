//! What the user states about a measurement because its file does not tell it, or cannot: the end it was taken from, the datum face, signs and
//! lengths of slopes. Nothing of this is ever guessed.

use super::files_content::MeasuredFiles;
use foundation::geometry::Sides;
use job::{Diagnostic, Problem};
use measured_files::inspection::{Characteristic, DatumFace, SlopeReference};
use run::RunFailure;
use serde::{Deserialize, Serialize};
use verdict::Remark;

/// Statements about a measurement; by default none.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
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

    /// In words.
    pub fn words(&self) -> Vec<String> {
        let length = |reference| match reference {
            SlopeReference::FaceWidth => "the face width",
            SlopeReference::Range => "the evaluated range",
        };
        let other_end = self.other_end.then(|| "measured from the other end".to_owned());
        let signs = self.slope_signs.map(|signs| {
            format!(
                "signs of helix slopes {:+} left, {:+} right as the file names them",
                signs.left, signs.right
            )
        });
        let helix = self.helix_slope_over.map(|of| format!("helix slopes over {}", length(of)));
        let profile = self.profile_slope_over.map(|of| format!("profile slopes over {}", length(of)));
        let face = self.datum_face.map(|face| match face {
            DatumFace::PlusZ => "datum face +z".to_owned(),
            DatumFace::MinusZ => "datum face -z".to_owned(),
        });
        [other_end, signs, helix, profile, face].into_iter().flatten().collect()
    }

    /// Gives a measurement what is stated about it; what contradicts its file is reported.
    pub(super) fn apply(&self, mut files: MeasuredFiles) -> MeasuredFiles {
        files.stated = self.words();
        let conditions = &mut files.inspection.conditions;
        let mut otherwise = Vec::new();
        if let Some(signs) = self.slope_signs {
            for (flank, sign) in signs.iter() {
                let own = &mut conditions.flanks[flank].printed_sign;
                if own.is_some_and(|own| own != *sign) {
                    otherwise.push(format!("the sign of helix slopes of the {flank} flank"));
                }
                *own = Some(*sign);
            }
            for result in &mut files.inspection.results {
                if let (Characteristic::HelixSlope, Some(flank)) =
                    (result.meaning.characteristic, result.meaning.flank)
                {
                    result.sigma = Some(signs[flank]);
                }
            }
        }
        for (stated, own, what) in [
            (self.helix_slope_over, &mut conditions.helix_slope_reference, "the length of helix slopes"),
            (
                self.profile_slope_over,
                &mut conditions.profile_slope_reference,
                "the length of profile slopes",
            ),
        ] {
            if stated.is_some() {
                if own.is_some() && *own != stated {
                    otherwise.push(what.into());
                }
                *own = stated;
            }
        }
        if !otherwise.is_empty() {
            files.remarks.push(Remark {
                code: "stated-otherwise",
                text: format!("the file says otherwise than was stated: {}", otherwise.join(", ")),
                way_out: "leave the statement out to take what the file says".into(),
            });
        }
        if self.other_end {
            files.inspection = files.inspection.turned();
        }
        if let Some(face) = self.datum_face {
            files.inspection.conditions.datum_face = face;
        }
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
