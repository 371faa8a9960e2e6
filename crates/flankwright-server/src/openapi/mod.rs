//! The document that describes the interface.

pub mod library;

use serde_json::Value;
use utoipa::openapi::security::{Http, HttpAuthScheme, SecurityScheme};
use utoipa::openapi::{ContentBuilder, Ref, ResponseBuilder};
use utoipa::{Modify, OpenApi};

use crate::api;
use crate::wire::{Failure, InspectOptions};

#[derive(OpenApi)]
#[openapi(
    modifiers(&Refusals, &Token),
    security((), ("token" = [])),
    components(schemas(Failure, InspectOptions)),
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
        api::charts::chart,
        api::files::archive,
        api::files::scene,
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

/// Every request may be refused, always in the same words.
struct Refusals;

impl Modify for Refusals {
    fn modify(&self, document: &mut utoipa::openapi::OpenApi) {
        let content = ContentBuilder::new().schema(Some(Ref::from_schema_name("Failure"))).build();
        let refused = ResponseBuilder::new()
            .description("The request is refused.")
            .content("application/json", content)
            .build();
        for path in document.paths.paths.values_mut() {
            let methods = [&mut path.get, &mut path.post, &mut path.delete];
            for operation in methods.into_iter().flatten() {
                operation.responses.responses.insert("default".into(), refused.clone().into());
            }
        }
    }
}

/// Where a server has a token, every request needs it.
struct Token;

impl Modify for Token {
    fn modify(&self, document: &mut utoipa::openapi::OpenApi) {
        let scheme = Http::builder()
            .scheme(HttpAuthScheme::Bearer)
            .description(Some("The token that the server has printed; servers on the loopback need none."))
            .build();
        let components = document.components.get_or_insert_default();
        components.add_security_scheme("token", SecurityScheme::Http(scheme));
    }
}

/// The OpenAPI document of the interface, 3.1.
pub fn openapi() -> Value {
    let mut document = serde_json::to_value(Interface::openapi()).unwrap_or_default();
    for (name, schema) in library::schemas() {
        document["components"]["schemas"][name] = schema;
    }
    document
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_types_have_one_name() {
        let own = serde_json::to_value(Interface::openapi()).unwrap();
        let own = own["components"]["schemas"].as_object().unwrap();
        for name in library::schemas().keys() {
            let stands_for_it = |schema: &Value| schema["$ref"] == format!("#/components/schemas/{name}");
            assert!(own.get(name).is_none_or(stands_for_it), "{name}");
        }
    }
}
