//! What the drawing asks for, entry by entry, in the words of drawings.

use foundation::geometry::Flank;
use job::tables::Modification as Spec;
use report::charts::format_significant;
use run::CharacteristicsUm;

/// One modification of the target.
#[derive(Clone, Debug, PartialEq)]
pub struct TargetAmount {
    /// Kind in words, for example "helix crowning".
    pub name: String,
    /// Amount, um, as the job gives it; `None` for a kind without a single amount.
    pub amount_um: Option<f64>,
    /// What else belongs to it, for example "transverse" or "over 3 mm of roll".
    pub detail: String,
}

/// The amount of a target entry as the job has it, where its kind has one.
pub fn target_amounts(drawn: &[Spec], flank: Flank, target: &CharacteristicsUm) -> Vec<TargetAmount> {
    let entries = drawn.iter().filter(|spec| spec.flank().includes(flank));
    entries
        .map(|spec: &Spec| {
            let keys = serde_json::to_value(spec).unwrap_or_default();
            let amount_um = keys.get("amount_um").and_then(serde_json::Value::as_f64);
            let detail = keys
                .as_object()
                .into_iter()
                .flatten()
                .filter(|(key, value)| {
                    !["kind", "amount_um", "flank", "w_mm", "z_mm", "f_um", "points"].contains(&key.as_str())
                        && !value.is_null()
                })
                .map(|(key, value)| entry_in_words(key, value))
                .collect::<Vec<_>>()
                .join(", ");
            let name = match spec {
                Spec::EndReliefI(_) => "end relief at face I (not the datum face)".to_owned(),
                Spec::EndReliefII(_) => "end relief at face II (datum face)".to_owned(),
                Spec::EndReliefDatumFace(_) => "end relief at the datum face (face II)".to_owned(),
                Spec::EndReliefNonDatumFace(_) => "end relief opposite the datum face (face I)".to_owned(),
                _ => spec.kind().replace('_', " "),
            };
            TargetAmount { name, amount_um, detail }
        })
        .chain((target.twist_fit_um.abs() < 1e-9).then(|| TargetAmount {
            name: "twist".into(),
            amount_um: Some(0.0),
            detail: "no entry: zero twist is wanted".into(),
        }))
        .collect()
}

/// A key of a modification and its value as a drawing has them: `length_mm = 6.0` is "length 6 mm".
fn entry_in_words(key: &str, value: &serde_json::Value) -> String {
    let text = match value {
        serde_json::Value::String(word) => word.replace('_', " "),
        other => other.as_f64().map_or_else(|| other.to_string(), |number| format_significant(number, 6)),
    };
    let (name, unit) = match key.rsplit_once('_') {
        Some((name, "mm")) => (name, " mm"),
        Some((name, "um")) => (name, " µm"),
        Some((name, "deg")) => (name, "°"),
        _ => (key, ""),
    };
    let (name, text) = match (name, text.as_str()) {
        ("corner_face", face) => return format!("corner at the {}", face.replace("non datum", "other")),
        ("corner_profile", end) => return format!("corner at the {end}"),
        ("length_w", _) => ("length along the profile".to_owned(), text),
        ("length_z", _) => ("length along the tooth".to_owned(), text),
        ("amp_0", _) => ("amplitude".to_owned(), text),
        ("amp_uu", _) => ("growth of the amplitude to tip and root".to_owned(), text),
        ("amp_vv", _) => ("growth of the amplitude to the faces".to_owned(), text),
        ("rho", _) => ("direction ρ".to_owned(), text),
        ("apex_z", _) => ("apex at z".to_owned(), text),
        ("apex_w", _) => ("apex at w".to_owned(), text),
        _ => (name.replace('_', " "), text),
    };
    format!("{name} {text}{unit}")
}
