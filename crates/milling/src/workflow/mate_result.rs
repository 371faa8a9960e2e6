//! What `result.json` says of the contact with the mate.

use contact::ContactPattern;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// A gear rolled against its mate, both with the flanks that are wanted, and the flanks of the gear as they are milled.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MateResult {
    /// Teeth of the mate.
    pub teeth: u32,
    /// Pitch cone angle of a bevel gear.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pitch_cone_angle_deg: Option<f64>,
    /// Angle between the axes of bevel gears.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shaft_angle_deg: Option<f64>,
    /// Centre distance of cylindrical gears.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centre_distance_mm: Option<f64>,
    /// Circumferential backlash of nominal cylindrical gears at the working pitch circle.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub backlash_um: Option<f64>,
    /// Radius of its pitch cone in the middle of the face, or of its working pitch circle; transmission errors in um are ways there.
    pub mean_pitch_radius_mm: f64,
    /// Gaps up to here show contact.
    pub marking_um: f64,
    /// Where the milled flank begins and where the mate needs it to.
    pub start_of_flank: MateStartResult,
    /// Flanks that are milled.
    pub flanks: BTreeMap<&'static str, MateFlankResult>,
}

/// Where a flank begins: polar angles of a bevel gear in degrees, or diameters.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MateStartResult {
    /// Where the flank that is milled begins.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub active_deg: Option<f64>,
    /// Where the tip of the mate engages; absent where it reaches below the base cone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub needed_deg: Option<f64>,
    /// Where the flank of a cylindrical gear begins.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub active_diameter_mm: Option<f64>,
    /// Where the tip of the mate engages; absent where it reaches below the base circle.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub needed_diameter_mm: Option<f64>,
    /// Whether all that the mate needs is milled.
    pub covered: bool,
}

/// Contact on one flank of the gear, without load.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MateFlankResult {
    /// Pattern that rolling leaves; absent if nothing is marked.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rolled: Option<PatternResult>,
    /// Its separate parts, the largest first; one where the pattern hangs together.
    pub parts: Vec<PatternResult>,
    /// Pattern of the flank as it is milled, with its scallops and chords; absent if nothing is marked or predicted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub milled: Option<PatternResult>,
    /// Pattern that both ease-offs say.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ease_off: Option<PatternResult>,
    /// Common area of both patterns over the area that either covers.
    pub overlap_percent: f64,
    /// Peak to peak of a mesh period, as turn of the mate.
    pub transmission_error_arcsec: f64,
    /// The same at the mate's mean pitch radius.
    pub transmission_error_um: f64,
    /// What both ease-offs say for it.
    pub transmission_error_ease_off_um: f64,
    /// Peak to peak of the flank as it is milled, as turn of the mate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub transmission_error_milled_arcsec: Option<f64>,
    /// The same at the mate's mean pitch radius.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub transmission_error_milled_um: Option<f64>,
    /// Places of the milled flank of which nothing is predicted, so that they are not rolled.
    pub places_not_predicted: usize,
}

/// A contact pattern on the active flank: 0 % at root and toe, 100 % at tip and heel.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PatternResult {
    /// Covered share of the flank.
    pub area_percent: f64,
    /// Centre along the tooth.
    pub centre_length_percent: f64,
    /// Centre over the height.
    pub centre_height_percent: f64,
    /// From where to where along the tooth.
    pub length_percent: [f64; 2],
    /// From where to where over the height.
    pub height_percent: [f64; 2],
}

impl PatternResult {
    /// In percent.
    pub fn new(pattern: &ContactPattern) -> Self {
        let [height, length] = pattern.ends.map(|ends| ends.map(|share| 100.0 * share));
        Self {
            area_percent: 100.0 * pattern.area,
            centre_length_percent: 100.0 * pattern.centre[1],
            centre_height_percent: 100.0 * pattern.centre[0],
            length_percent: length,
            height_percent: height,
        }
    }
}
