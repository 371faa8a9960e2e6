//! Programs followed on a machine.

use std::io::Cursor;
use std::sync::Arc;

use axum::Json;
use axum::extract::State;
use flankwright::exchange::machine::read_machine;
use flankwright::nc::detect_dialect;
use flankwright::numerics::Progress;
use flankwright::workflow::{CheckedProgram, check_program};

use super::error::{Answer, Refused};
use super::short::short;
use super::take::Body;
use crate::app::App;
use crate::openapi::library;
use crate::shelf::Shelf;
use crate::wire::{Failure, Finding, Job, ProgramRequest, refused_run, unshelved};

/// What a program does: axes, travel, speed, time; with a job the flank that it leaves.
#[utoipa::path(post, path = "/api/programs/check", operation_id = "check_program", request_body = ProgramRequest,
    responses((status = 200, body = library::CheckedProgram), (status = 422, body = Failure)))]
pub async fn check(
    State(app): State<Arc<App>>,
    Body(request): Body<ProgramRequest>,
) -> Answer<Json<CheckedProgram>> {
    let place = app.clone();
    short(&app, move |progress| checked(&place, &request, progress).map(Json)).await
}

fn checked(app: &App, request: &ProgramRequest, progress: &dyn Progress) -> Answer<CheckedProgram> {
    let none = Job::default();
    let job = request.job.as_ref().unwrap_or(&none);
    let shelf =
        Shelf::new(&app.scratch, &job.files, true).map_err(|error| Refused::bad(unshelved(&error)))?;
    let refuse = |error| Refused::bad(Failure::of_error(&error, &shelf));
    let machine = read_machine(&shelf.source("").beside(&request.machine)).map_err(refuse)?;
    let loaded = request.job.as_ref().map(|job| shelf.load(&job.text)).transpose().map_err(refuse)?;
    let dialect = detect_dialect(request.text.as_bytes()).ok_or_else(|| {
        let message = format!("{} is no program of a known dialect", request.name);
        let finding = Finding::new("unknown-dialect", message, "take a program of one of these");
        Refused::bad(Failure::single(finding.field("text").allowed("linuxcnc, siemens, fanuc")))
    })?;
    let text = (Cursor::new(request.text.as_bytes()), request.netlist.as_deref());
    check_program(text, dialect, &machine, loaded.as_ref(), progress)
        .map_err(|failure| Refused::bad(refused_run(&failure.into(), &job.text, &shelf)))
}
