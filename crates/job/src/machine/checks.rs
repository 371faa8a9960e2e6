//! Contradictions between the entries of a machine description that are each in range.

use super::contradiction::contradiction;
use super::{AxisEntry, AxisType, Control, MachineFile, body_checks};
use crate::diagnostic::Diagnostic;

/// All contradictions; without places, which the caller knows.
pub(super) fn check(file: &MachineFile) -> Vec<Diagnostic> {
    let mut findings = Vec::new();
    let limbs = [
        ("tool", Some(&file.chains.tool)),
        ("work", Some(&file.chains.work)),
        ("dresser", file.chains.dresser.as_ref()),
    ];
    for (limb, chain) in limbs {
        for (k, name) in chain.into_iter().flat_map(|chain| chain.axes.iter().enumerate()) {
            named(file, format!("chains.{limb}.axes[{k}]"), name, &mut findings);
        }
    }
    for (role, name) in file.roles.named() {
        named(file, format!("roles.{}", role.key()), name, &mut findings);
    }
    for (dialect, control) in file.controls.present() {
        for name in control.words.keys() {
            named(file, format!("controls.{dialect}.words.{name}"), name, &mut findings);
        }
        for (k, name) in control.leaders.iter().enumerate() {
            named(file, format!("controls.{dialect}.leaders[{k}]"), name, &mut findings);
        }
        foreign(dialect, control, &mut findings);
    }
    for (name, axis) in &file.axes {
        travel(name, axis, &mut findings);
    }
    body_checks::check(file, &mut findings);
    findings
}

/// Options that another control has.
fn foreign(dialect: &str, control: &Control, findings: &mut Vec<Diagnostic>) {
    let options = [
        ("program_number", "fanuc", control.program_number.is_some()),
        ("contour_mode", "fanuc", control.contour_mode),
        ("following_error_deg", "linuxcnc", control.following_error_deg.is_some()),
    ];
    for (key, owner, given) in options {
        if given && owner != dialect {
            let field = format!("controls.{dialect}.{key}");
            let message = format!("`{field}` is an option of {owner}");
            findings.push(contradiction(field, message, "no key", "leave it out"));
        }
    }
}

/// A name that has to be that of an axis.
fn named(file: &MachineFile, field: String, name: &str, findings: &mut Vec<Diagnostic>) {
    if !file.axes.contains_key(name) {
        let known: Vec<&str> = file.axes.keys().map(String::as_str).collect();
        let message = format!("`{field}` names no axis of the machine: {name:?}");
        findings.push(contradiction(field, message, &known.join(", "), "write the name of an axis"));
    }
}

/// Every axis either has both ends in its own unit or, if it is rotary, none.
fn travel(name: &str, axis: &AxisEntry, findings: &mut Vec<Diagnostic>) {
    let linear = axis.kind == AxisType::Linear;
    let (own, other) = if linear { ("mm", "deg") } else { ("deg", "mm") };
    let ends =
        |unit: &str| if unit == "mm" { [axis.min_mm, axis.max_mm] } else { [axis.min_deg, axis.max_deg] };
    let field = |key: &str| format!("axes.{name}.{key}");
    if ends(other).iter().any(Option::is_some) {
        let message = format!("`axes.{name}` has its travel in {other}");
        let way_out = format!("write min_{own} and max_{own}");
        findings.push(contradiction(field(&format!("min_{other}")), message, own, &way_out));
    }
    if axis.endless && linear {
        let message = format!("`axes.{name}` is linear and cannot be endless");
        findings.push(contradiction(field("endless"), message, "false", "give min_mm and max_mm"));
    }
    match (axis.endless, ends(own)) {
        (true, [None, None]) | (false, [Some(_), Some(_)]) => {}
        (true, _) => findings.push(contradiction(
            field("endless"),
            format!("`axes.{name}` is endless and has ends of travel"),
            "one of both",
            "leave out endless, or the ends",
        )),
        (false, _) => findings.push(contradiction(
            field(&format!("min_{own}")),
            format!("`axes.{name}` lacks an end of its travel"),
            &format!("min_{own} and max_{own}"),
            if linear { "give both ends of travel" } else { "give both ends of travel, or endless = true" },
        )),
    }
    if let [Some(from), Some(to)] = ends(own)
        && from >= to
    {
        let message = format!("`axes.{name}` has no travel: {from} .. {to} {own}");
        findings.push(contradiction(
            field(&format!("max_{own}")),
            message,
            &format!("> {from}"),
            "exchange the ends",
        ));
    }
    if linear && axis.point_mm.is_some() {
        let message = format!("`axes.{name}` is linear: a point means nothing");
        findings.push(contradiction(field("point_mm"), message, "no point", "leave the point out"));
    }
}
