//! The two ends of a flank by name. Face I is the end with the smaller z, face II that with the greater. Left and right flank are
//! those that a viewer sees who looks at the datum face (ISO 21771); here they are seen from +z, so the datum face is face II.
//! Drawings often call the datum face I: keys with `datum_face` in their name cannot be misread, those with I and II can.

use super::error::ModificationError;
use super::spec::{CornerFace, HelixTwoArcSpec, ModificationSpec};

impl CornerFace {
    /// Whether it is the datum face, that with the greater z.
    pub fn is_datum(self) -> bool {
        matches!(self, Self::II | Self::DatumFace)
    }
}

impl HelixTwoArcSpec {
    /// The keys under which the amounts of [`HelixTwoArcSpec::amounts_um`] stand.
    pub(super) fn keys(&self) -> [&'static str; 2] {
        [
            if self.amount_1_um.is_some() { "amount_I_um" } else { "amount_non_datum_face_um" },
            if self.amount_2_um.is_some() { "amount_II_um" } else { "amount_datum_face_um" },
        ]
    }

    /// Amounts at the face opposite the datum face (face I) and at the datum face (face II), um.
    ///
    /// # Errors
    /// [`ModificationError`]: an amount that is given under both of its names or under none.
    pub fn amounts_um(&self) -> Result<[f64; 2], ModificationError> {
        let one = |by_number, by_name, keys: [&'static str; 2]| match (by_number, by_name) {
            (Some(amount), None) | (None, Some(amount)) => Ok(amount),
            (given, _) => Err(ModificationError::InvalidModification {
                kind: "helix_crowning_two_arc".to_owned(),
                key: keys[0].to_owned(),
                value: if given.is_some() { "given under both of its names" } else { "missing" }.to_owned(),
                allowed: format!("{} or {}, one of the two", keys[0], keys[1]),
            }),
        };
        Ok([
            one(
                self.amount_1_um,
                self.amount_non_datum_face_um,
                ["amount_non_datum_face_um", "amount_I_um"],
            )?,
            one(self.amount_2_um, self.amount_datum_face_um, ["amount_datum_face_um", "amount_II_um"])?,
        ])
    }
}

impl ModificationSpec {
    /// Names of faces by number in this modification and its children, each with whether the datum face is meant.
    pub fn faces_by_number(&self) -> Vec<(String, bool)> {
        let of = |children: &[Self]| children.iter().flat_map(Self::faces_by_number).collect();
        match self {
            Self::EndReliefI(_) => vec![("end_relief_I".to_owned(), false)],
            Self::EndReliefII(_) => vec![("end_relief_II".to_owned(), true)],
            Self::TriangularEndRelief(s) => match s.corner_face {
                CornerFace::I => vec![("corner_face = \"I\"".to_owned(), false)],
                CornerFace::II => vec![("corner_face = \"II\"".to_owned(), true)],
                CornerFace::DatumFace | CornerFace::NonDatumFace => Vec::new(),
            },
            Self::HelixCrowningTwoArc(s) => {
                let named = [(s.amount_1_um, "amount_I_um", false), (s.amount_2_um, "amount_II_um", true)];
                named
                    .iter()
                    .filter(|(a, ..)| a.is_some())
                    .map(|(_, key, datum)| ((*key).to_owned(), *datum))
                    .collect()
            }
            Self::Sum(s) | Self::Product(s) => of(&s.children),
            Self::Scale(s) => of(&s.children),
            Self::Mirror(s) => of(&s.children),
            _ => Vec::new(),
        }
    }
}
