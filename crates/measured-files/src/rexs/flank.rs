//! One flank between the coordinates of this program, length of roll and height, and those of REXS, diameter and distance from the datum face.

use super::document::Component;
use super::error::RexsError;
use super::flank_field::FlankField;
use super::values::title;
use crate::inspection::DatumFace;
use foundation::geometry::InvoluteFlank;
use foundation::modification::EvaluationField;

/// A flank with the face that coordinates count from.
#[derive(Clone, Copy, Debug)]
pub(super) struct FlankPlace {
    pub involute: InvoluteFlank,
    pub face_width: f64,
    pub datum_face: DatumFace,
}

impl FlankPlace {
    /// Diameter at a length of roll, mm.
    pub fn diameter(&self, w: f64) -> f64 {
        2.0 * self.involute.radius(w)
    }

    /// Length of roll at a diameter of a component, mm.
    pub fn roll(&self, component: &Component, attribute: &str, diameter: f64) -> Result<f64, RexsError> {
        self.involute.length_of_roll(0.5 * diameter).map_err(|_| RexsError::BadValue {
            component: title(component),
            attribute: attribute.into(),
            value: diameter.to_string(),
            allowed: "a diameter on the involute, not below its base circle",
        })
    }

    /// Distance xi of a height from the datum face, mm.
    pub fn distance(&self, z: f64) -> f64 {
        self.datum_face.distance(z, self.face_width)
    }

    /// Height of a distance xi from the datum face, mm.
    pub fn height(&self, xi: f64) -> f64 {
        self.datum_face.height(xi, self.face_width)
    }

    /// What slopes along the face are multiplied by: ours rise from face I to face II, those of REXS from the datum face.
    pub fn slope_sign(&self) -> f64 {
        match self.datum_face {
            DatumFace::PlusZ => -1.0,
            DatumFace::MinusZ => 1.0,
        }
    }

    /// Values at face I and face II as (datum face, other face), and back.
    pub fn faces<T>(&self, (one, two): (T, T)) -> (T, T) {
        match self.datum_face {
            DatumFace::PlusZ => (two, one),
            DatumFace::MinusZ => (one, two),
        }
    }

    /// The evaluated field of the flank.
    pub fn field(&self, field: &FlankField) -> Result<EvaluationField, RexsError> {
        let flank = self.involute.flank;
        let lack = |what: &str| RexsError::NotExpressibleInRexs {
            what: format!("the evaluated field of the {flank} flank"),
            reason: format!("{what} is not known"),
        };
        let roll = |diameter: Option<f64>, what: &str| {
            let diameter = diameter.ok_or_else(|| lack(what))?;
            self.involute.length_of_roll(0.5 * diameter).map_err(|error| RexsError::NoGear { gear: 0, error })
        };
        let mut w = [
            roll(field.start_diameter_mm, "the diameter at which it begins")?,
            roll(field.end_diameter_mm, "the diameter at which it ends")?,
        ];
        // An internal gear has its tip at the shorter length of roll.
        w.sort_by(f64::total_cmp);
        let half = 0.5 * self.face_width;
        let z = [field.z_start_mm.unwrap_or(-half), field.z_end_mm.unwrap_or(half)];
        EvaluationField::new(w, z, self.involute.base_radius, self.involute.base_helix_angle)
            .map_err(|error| RexsError::Modification { flank, error })
    }
}
