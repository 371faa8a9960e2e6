//! What holds the workpiece: bodies that have a length and a name of their own.

use crate::contradiction::contradiction;
use crate::diagnostic::Diagnostic;
use crate::node::shown_number;
use crate::tables::ClampingBody;

/// Every body has a length and a name of its own.
pub fn check(bodies: &[ClampingBody], findings: &mut Vec<Diagnostic>) {
    for (number, body) in bodies.iter().enumerate() {
        let field = |key: &str| format!("machine.clamping[{number}].{key}");
        let [from, to] = body.z;
        if from >= to {
            findings.push(contradiction(
                "a body of the clamping has no length",
                field("z"),
                format!("[{}, {}]", shown_number(from), shown_number(to)),
                "two positions, ascending",
                "give the lower position first",
            ));
        }
        if bodies[..number].iter().any(|other| other.name == body.name) {
            findings.push(contradiction(
                "two bodies of the clamping have one name",
                field("name"),
                format!("{:?}", body.name),
                "each name once",
                "give one of them another name: reports tell the bodies apart by it",
            ));
        }
    }
}
