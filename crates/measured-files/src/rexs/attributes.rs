//! The part of the schema of REXS 2.0.0 that is read and written here: types of components, their attributes, units and types of values.

/// The dimension of a number; it decides which units are converted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// A number, mm.
    Length,
    /// A number, um.
    Micrometres,
    /// A number, degree.
    Angle,
    /// A number without unit.
    Plain,
    /// A whole number.
    Integer,
    /// Yes or no.
    Boolean,
    /// One word.
    Word,
    /// A list of numbers, mm.
    Lengths,
}

impl Form {
    /// The unit in which values are written.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Length | Self::Lengths => "mm",
            Self::Micrometres => "mum",
            Self::Angle => "deg",
            Self::Plain | Self::Integer | Self::Boolean | Self::Word => "none",
        }
    }
}

use Form::{Angle, Boolean, Integer, Length, Lengths, Micrometres, Plain, Word};

/// Attributes of a type of component.
type List = &'static [(&'static str, Form)];

const GEAR: List = &[
    ("number_of_teeth", Integer),
    ("normal_module", Length),
    ("helix_angle_reference_diameter", Angle),
    ("face_width", Length),
    ("tip_diameter", Length),
    ("root_diameter", Length),
    ("root_form_diameter", Length),
    ("datum_face_orientation", Word),
    ("number_of_teeth_for_span_measurement", Integer),
    ("span_measurement", Length),
    ("lower_backlash_allowance_referenced_to_span", Micrometres),
    ("upper_backlash_allowance_referenced_to_span", Micrometres),
    ("diameter_of_measuring_ball_or_pin", Length),
    ("size_over_balls", Length),
    ("lower_backlash_allowance_balls_or_pins", Length),
    ("upper_backlash_allowance_balls_or_pins", Length),
    ("global_tolerance_class_iso_1328_2013", Word),
];

const TYPES: &[(&str, List)] = &[
    ("cylindrical_gear", GEAR),
    ("ring_gear", GEAR),
    (
        "cylindrical_gear_flank",
        &[("normal_pressure_angle", Angle), ("addendum_modification_coefficient", Plain)],
    ),
    (
        "tip_relief",
        &[
            ("tip_relief_depth", Length),
            ("tip_relief_datum_diameter", Length),
            ("tip_relief_evaluation_reference", Length),
            ("shape_of_relief", Word),
            ("tip_relief_length_of_tangential_transition_start", Length),
            ("tip_relief_length_of_tangential_transition_end", Length),
        ],
    ),
    (
        "root_relief",
        &[
            ("root_relief_depth", Length),
            ("root_relief_datum_diameter", Length),
            ("root_relief_evaluation_reference", Length),
            ("shape_of_relief", Word),
            ("root_relief_length_of_tangential_transition_start", Length),
            ("root_relief_length_of_tangential_transition_end", Length),
        ],
    ),
    (
        "profile_crowning",
        &[
            ("profile_crowning_at_root", Length),
            ("profile_crowning_at_tip", Length),
            ("profile_highest_point", Length),
            ("diameter_where_profile_crowning_root_is_specified", Length),
            ("diameter_where_profile_crowning_tip_is_specified", Length),
            ("shape_of_profile_crowning", Word),
        ],
    ),
    (
        "profile_slope",
        &[
            ("profile_slope", Length),
            ("profile_evaluation_start", Length),
            ("profile_evaluation_end", Length),
            ("diameter_where_profile_slope_amount_is_specified", Length),
        ],
    ),
    (
        "helix_crowning",
        &[
            ("helix_crowning_amount_datum_face", Length),
            ("helix_crowning_amount_non_datum_face", Length),
            ("helix_highest_point", Length),
            ("coordinate_where_helix_crowning_is_specified_datum_face", Length),
            ("coordinate_where_helix_crowning_is_specified_non_datum_face", Length),
            ("shape_of_helix_crowning", Word),
        ],
    ),
    (
        "helix_slope",
        &[
            ("helix_slope", Length),
            ("helix_evaluation_start", Length),
            ("helix_evaluation_end", Length),
            ("helix_evaluation_reference", Word),
        ],
    ),
    (
        "end_relief_datum_face",
        &[
            ("end_relief_depth_datum_face", Length),
            ("end_relief_length_datum_face", Length),
            ("shape_of_relief", Word),
            ("end_relief_datum_face_length_of_tangential_transition_start", Length),
            ("end_relief_datum_face_length_of_tangential_transition_end", Length),
        ],
    ),
    (
        "end_relief_non_datum_face",
        &[
            ("end_relief_depth_non_datum_face", Length),
            ("end_relief_length_non_datum_face", Length),
            ("shape_of_relief", Word),
            ("end_relief_non_datum_face_length_of_tangential_transition_start", Length),
            ("end_relief_non_datum_face_length_of_tangential_transition_end", Length),
        ],
    ),
    (
        "profile_twist",
        &[
            ("profile_twist", Length),
            ("profile_twist_evaluation_start", Length),
            ("profile_twist_evaluation_end", Length),
            ("position_of_profile_twist_datum_face", Length),
            ("position_of_profile_twist_non_datum_face", Length),
        ],
    ),
    (
        "topographical_modification",
        &[
            ("topographical_modification_amounts", Lengths),
            ("coordinates_of_topographical_modification", Lengths),
            ("diameters_of_topographical_modification", Lengths),
            ("length_of_topographical_modification", Lengths),
            ("type_of_interpolation_topographical_modification", Word),
            ("is_additive_modification", Boolean),
        ],
    ),
    (
        "profile_deviation",
        &[
            ("diameters_of_profile_deviation", Lengths),
            ("profile_deviation_amounts", Lengths),
            ("position_of_profile_deviation", Length),
        ],
    ),
    (
        "helix_deviation",
        &[
            ("coordinates_of_helix_deviation", Lengths),
            ("helix_deviation_amounts", Lengths),
            ("diameter_of_helix_deviation", Length),
        ],
    ),
];

/// Whether components of that type are read here.
pub(super) fn is_known(kind: &str) -> bool {
    TYPES.iter().any(|(name, _)| *name == kind)
}

/// The attribute of a type of component, if it is read here.
pub(super) fn form(kind: &str, id: &str) -> Option<Form> {
    let (_, list) = TYPES.iter().find(|(name, _)| *name == kind)?;
    list.iter().find(|(name, _)| *name == id).map(|(_, form)| *form)
}

/// As [`form`], with the identifier as it stands in the table: for callers that need it to live on.
pub(super) fn known(kind: &str, id: &str) -> Option<(&'static str, Form)> {
    let (_, list) = TYPES.iter().find(|(name, _)| *name == kind)?;
    list.iter().find(|(name, _)| *name == id).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_type_and_no_attribute_stands_twice() {
        for (k, (kind, list)) in TYPES.iter().enumerate() {
            assert!(TYPES[..k].iter().all(|(other, _)| other != kind), "{kind}");
            for (j, (id, _)) in list.iter().enumerate() {
                assert!(list[..j].iter().all(|(other, _)| other != id), "{kind}.{id}");
                assert_eq!(known(kind, id).map(|(id, _)| id), Some(*id));
            }
        }
        assert!(is_known("ring_gear") && !is_known("shaft"));
        assert_eq!(form("tip_relief", "face_width"), None);
    }
}
