//! Reliefs towards tip, root and faces.

use super::super::error::RexsError;
use super::super::values::title;
use super::Reader;
use foundation::modification::{ModificationSpec, Reference, ReliefSpec};

/// The identifiers of a relief's attributes.
struct Ids {
    depth: &'static str,
    /// Diameter at which a profile relief begins, or length of an end relief.
    extent: &'static str,
    transition: [&'static str; 2],
}

fn ids(kind: &str) -> Ids {
    match kind {
        "tip_relief" => Ids {
            depth: "tip_relief_depth",
            extent: "tip_relief_datum_diameter",
            transition: [
                "tip_relief_length_of_tangential_transition_start",
                "tip_relief_length_of_tangential_transition_end",
            ],
        },
        "root_relief" => Ids {
            depth: "root_relief_depth",
            extent: "root_relief_datum_diameter",
            transition: [
                "root_relief_length_of_tangential_transition_start",
                "root_relief_length_of_tangential_transition_end",
            ],
        },
        "end_relief_datum_face" => Ids {
            depth: "end_relief_depth_datum_face",
            extent: "end_relief_length_datum_face",
            transition: [
                "end_relief_datum_face_length_of_tangential_transition_start",
                "end_relief_datum_face_length_of_tangential_transition_end",
            ],
        },
        _ => Ids {
            depth: "end_relief_depth_non_datum_face",
            extent: "end_relief_length_non_datum_face",
            transition: [
                "end_relief_non_datum_face_length_of_tangential_transition_start",
                "end_relief_non_datum_face_length_of_tangential_transition_end",
            ],
        },
    }
}

impl Reader<'_> {
    /// A relief towards one border of the flank.
    pub(super) fn relief(&mut self) -> Result<ModificationSpec, RexsError> {
        let kind = self.part.kind.as_str();
        let ids = ids(kind);
        let [w_f, w_a] = self.field.roll();
        let stated = self.of.number(ids.extent)?;
        let length = match kind {
            "tip_relief" => w_a - self.place.roll(self.part, ids.extent, stated)?,
            "root_relief" => self.place.roll(self.part, ids.extent, stated)? - w_f,
            _ => stated,
        };
        if length.is_nan() || length <= 0.0 {
            return Err(RexsError::BadValue {
                component: title(self.part),
                attribute: ids.extent.into(),
                value: stated.to_string(),
                allowed: "one that leaves the relief a length",
            });
        }
        let exponent = match self.of.word("shape_of_relief")? {
            Some("linear") => 1.0,
            Some("parabolic") => 2.0,
            None => {
                self.assume("does not state its shape; a straight relief is taken");
                1.0
            }
            Some(other) => {
                let other: String = other.chars().take(40).collect();
                self.assume(format_args!("has the shape `{other}`; a straight relief is taken"));
                1.0
            }
        };
        let spec = ReliefSpec {
            amount_um: 1e3 * self.of.number(ids.depth)?,
            length_mm: length,
            exponent,
            transition_mm: if exponent == 1.0 { self.transition(ids.transition)? } else { 0.0 },
            flank: self.flank(),
            reference: Reference::Transverse,
        };
        Ok(match kind {
            "tip_relief" => ModificationSpec::TipRelief(spec),
            "root_relief" => ModificationSpec::RootRelief(spec),
            _ => {
                let at_datum = kind == "end_relief_datum_face";
                // Whether the datum face is face I.
                if self.place.faces((at_datum, !at_datum)).0 {
                    ModificationSpec::EndReliefI(spec)
                } else {
                    ModificationSpec::EndReliefII(spec)
                }
            }
        })
    }

    /// Half length of a rounded start: both ends are lengths from the far end of the relief.
    fn transition(&mut self, [start, end]: [&'static str; 2]) -> Result<f64, RexsError> {
        let ends = self.of.optional(start)?.zip(self.of.optional(end)?);
        let Some((start, end)) = ends else { return Ok(0.0) };
        let half = 0.5 * (start - end);
        if half > 0.0 {
            return Ok(half);
        }
        self.assume("ends its tangential transition before it begins; the relief starts with an edge");
        Ok(0.0)
    }
}
