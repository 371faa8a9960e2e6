//! The keys of each kind of modification, as a schema. Knows no formula.

use schemars::{Schema, SchemaGenerator, json_schema};
use serde_json::{Map, Value, json};

const NAME: &str = "Modification";

/// Kind, keys that have to be there, keys that may.
const KINDS: &[(&[&str], &[&str], &[&str])] = &[
    (
        &[
            "profile_crowning",
            "profile_crowning_arc",
            "profile_crowning_radius",
            "profile_slope_radius",
            "helix_crowning",
            "helix_crowning_arc",
            "profile_slope",
            "helix_slope",
            "twist",
        ],
        &["amount_um"],
        &[],
    ),
    (&["helix_crowning_two_arc"], &["apex_z_mm", "amount_I_um", "amount_II_um"], &[]),
    (&["profile_crowning_two_arc"], &["apex_w_mm", "amount_I_um", "amount_II_um"], &[]),
    (
        &["tip_relief", "root_relief", "end_relief_I", "end_relief_II"],
        &["amount_um", "length_mm"],
        &["exponent", "transition_mm"],
    ),
    (
        &["triangular_end_relief"],
        &["amount_um", "corner_profile", "corner_face", "length_w_mm", "length_z_mm"],
        &["exponent", "transition"],
    ),
    (&["directed_crowning"], &["amount_um", "rho_deg"], &[]),
    (&["waviness"], &["rho_deg", "wavelength_mm"], &["phase_deg", "amp_0_um", "amp_uu_um", "amp_vv_um"]),
    (&["polynomial"], &["terms"], &["w0_mm", "z0_mm"]),
    (&["grid"], &[], &["w_mm", "z_mm", "f_um", "file"]),
    (&["points"], &[], &["points", "file", "method"]),
    (&["sum", "product"], &["children"], &[]),
    (&["scale"], &["children", "factor"], &[]),
    (&["mirror"], &["children"], &["axis"]),
];

/// Schema of `[target] modifications`.
pub(super) fn modifications_schema(generator: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "array", "items": modification_schema(generator) })
}

/// Schema of one entry; children refer back to it.
pub(super) fn modification_schema(generator: &mut SchemaGenerator) -> Schema {
    let variants: Vec<Value> = KINDS
        .iter()
        .flat_map(|(kinds, required, optional)| kinds.iter().map(|k| variant(k, required, optional)))
        .collect();
    generator.definitions_mut().insert(NAME.to_owned(), json!({ "oneOf": variants }));
    json_schema!({ "$ref": format!("#/$defs/{NAME}") })
}

fn variant(kind: &str, required: &[&str], optional: &[&str]) -> Value {
    let mut properties = Map::new();
    properties.insert("kind".to_owned(), json!({ "const": kind }));
    properties.insert("flank".to_owned(), json!({ "enum": ["left", "right", "both"] }));
    properties.insert("reference".to_owned(), json!({ "enum": ["transverse", "normal"] }));
    for key in required.iter().chain(optional) {
        properties.insert((*key).to_owned(), value_schema(key));
    }
    let required: Vec<&str> = std::iter::once("kind").chain(required.iter().copied()).collect();
    json!({ "type": "object", "properties": properties, "required": required, "additionalProperties": false })
}

fn value_schema(key: &str) -> Value {
    let numbers = json!({ "type": "array", "items": { "type": "number" } });
    match key {
        "corner_profile" => json!({ "enum": ["tip", "root"] }),
        "corner_face" => json!({ "enum": ["I", "II"] }),
        "method" => json!({ "enum": ["linear", "spline"] }),
        "axis" => json!({ "enum": ["z"] }),
        "file" => json!({ "type": "string" }),
        "children" => json!({ "type": "array", "items": { "$ref": format!("#/$defs/{NAME}") } }),
        "w_mm" | "z_mm" => numbers,
        "f_um" | "points" | "terms" => json!({ "type": "array", "items": numbers }),
        "exponent" => json!({ "type": "number", "minimum": 1, "maximum": 10 }),
        "length_mm" | "length_w_mm" | "length_z_mm" | "wavelength_mm" => {
            json!({ "type": "number", "exclusiveMinimum": 0, "maximum": 10000,
                "x-way-out": "give a length > 0 in mm" })
        }
        "transition" | "transition_mm" => json!({ "type": "number", "minimum": 0, "maximum": 10000 }),
        _ => json!({ "type": "number", "minimum": -10000, "maximum": 10000 }),
    }
}
