//! A scene before it is handed out: numbers that are none are an error, and so are bodies that cannot be meshed.

use crate::finding::RunFailure;
use job::Diagnostic;
use scene::mesh::MeshError;
use scene::{Scene, Stage};

/// A scene none of whose numbers is NaN or infinite, and whose stages have something to show.
///
/// # Errors
/// [`RunFailure`] with the code `scene-undefined`.
pub fn finished(scene: Scene) -> Result<Scene, RunFailure> {
    for body in &scene.bodies {
        if !body.positions.iter().all(|x| x.is_finite()) {
            return Err(undefined(&format!("the body `{}`", body.id)));
        }
    }
    for stage in &scene.stages {
        if stage.frames.is_empty() || !sound(stage) {
            return Err(undefined(&format!("the stage `{}`", stage.id)));
        }
    }
    Ok(scene)
}

fn sound(stage: &Stage) -> bool {
    stage.frames.iter().all(|frame| {
        let points = frame.contact.iter().chain(frame.trace.iter().flatten());
        frame.at.is_finite()
            && frame.poses.values().flatten().all(|x| x.is_finite())
            && points.flatten().all(|x| x.is_finite())
    })
}

fn undefined(what: &str) -> RunFailure {
    let message = format!("{what} cannot be shown: a number of it is not finite, or there is none");
    RunFailure::not_producible(
        Diagnostic::with_code("scene-undefined", message)
            .way_out("look at the tables and the report of the run"),
    )
}

/// A body that cannot be meshed.
pub fn unmeshed(body: &str, error: &MeshError) -> RunFailure {
    let message = format!("the mesh of the {body} cannot be made: {error}");
    RunFailure::not_producible(Diagnostic::with_code(error.code(), message).way_out(error.way_out()))
}
