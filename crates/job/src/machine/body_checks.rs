//! Contradictions between the bodies of a machine and its axes.

use super::MachineFile;
use super::contradiction::contradiction;
use crate::diagnostic::Diagnostic;
use crate::machine::AxisType;
use nalgebra::Vector3;

/// A body on a spindle may lie beside the axis of that spindle by this, mm: as measured machines have it.
const COAXIAL: f64 = 0.1;

/// Bodies without length, of one name, on an axis that is none, or on a spindle that would swing them around.
pub(super) fn check(file: &MachineFile, findings: &mut Vec<Diagnostic>) {
    for (number, body) in file.bodies.iter().enumerate() {
        let field = |key: &str| format!("bodies[{number}].{key}");
        if file.bodies[..number].iter().any(|other| other.name == body.name) {
            let message = format!("two bodies are called {:?}", body.name);
            findings.push(contradiction(field("name"), message, "each name once", "give it another name"));
        }
        if body.body().is_none() {
            let message = format!("the body {:?} has no length", body.name);
            findings.push(contradiction(
                field("to_mm"),
                message,
                "another place than from_mm",
                "give the middles of both ends",
            ));
        }
        let Some(axis) = &body.axis else { continue };
        let Some(entry) = file.axes.get(axis) else {
            let known: Vec<&str> = file.axes.keys().map(String::as_str).collect();
            let message = format!("`{}` names no axis of the machine: {axis:?}", field("axis"));
            findings.push(contradiction(
                field("axis"),
                message,
                &known.join(", "),
                "write the name of an axis, or leave it out for a body on the bed",
            ));
            continue;
        };
        let roles = &file.roles;
        let spindles = [&roles.worm, &roles.work, &roles.dresser];
        if entry.kind != AxisType::Rotary || !spindles.contains(&&Some(axis.clone())) {
            continue;
        }
        let (direction, point) =
            (Vector3::from(entry.direction), entry.point_mm.map_or_else(Vector3::zeros, Vector3::from));
        let beside =
            [body.from_mm, body.to_mm].map(|end| (Vector3::from(end) - point).cross(&direction).norm());
        let most = beside[0].max(beside[1]);
        if most > COAXIAL {
            let message = format!(
                "the spindle {axis} would swing the body {:?} around: it lies {most:.3} mm beside it",
                body.name
            );
            let way_out = "let the axis before the spindle carry it, or lay it on the spindle's axis";
            findings.push(contradiction(
                field("axis"),
                message,
                &format!("both ends on the axis of {axis} up to {COAXIAL} mm"),
                way_out,
            ));
        }
    }
}
