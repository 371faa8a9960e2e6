//! The document that describes the interface.

use utoipa::OpenApi;

use crate::api;

#[derive(OpenApi)]
#[openapi(
    info(title = "flankwright", description = "Plans, simulates and proves the manufacture of gear teeth."),
    paths(
        api::about::about,
        api::about::document,
        api::about::schema,
        api::examples::list,
        api::examples::one,
        api::examples::template,
        api::examples::machines,
        api::jobs::check,
        api::jobs::edit,
        api::jobs::preview,
        api::runs::list,
        api::runs::begin,
        api::runs::one,
        api::runs::remove,
        api::runs::cancel,
        api::runs::again,
        api::events::events,
        api::files::archive,
        api::files::file,
        api::measurements::begin,
        api::programs::check,
        api::kept::series,
        api::kept::parts,
        api::kept::part,
        api::kept::trends,
        api::kept::catalogue,
        api::kept::tools,
        api::kept::history,
    )
)]
struct Interface;

/// The OpenAPI document of the interface.
pub fn openapi() -> utoipa::openapi::OpenApi {
    Interface::openapi()
}
