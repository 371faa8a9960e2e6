//! Types of library and store in the description of the interface: their schemas come from the types themselves.

use std::borrow::Cow;

use flankwright::exchange::{catalogue, skiving_history};
use flankwright::workflow::{self, DocumentFormat, documents};
use flankwright_store as store;
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, SchemaGenerator};
use serde_json::{Map, Value, json};
use utoipa::openapi::{Ref, RefOr, Schema};
use utoipa::{PartialSchema, ToSchema};

use crate::wire::HandedIn;

/// Names for the descriptions of paths and answers, each of which stands for a type with a schema of its own.
macro_rules! described {
    ($($name:ident: $type:ty,)*) => {
        $(
            #[doc = concat!("Stands for `", stringify!($type), "`.")]
            pub struct $name;

            impl ToSchema for $name {
                fn name() -> Cow<'static, str> {
                    <$type>::schema_name()
                }
            }

            impl PartialSchema for $name {
                fn schema() -> RefOr<Schema> {
                    Ref::from_schema_name(Self::name()).into()
                }
            }
        )*

        fn describe(generator: &mut SchemaGenerator) {
            $(generator.subschema_for::<$type>();)*
        }
    };
}

described! {
    CheckedProgram: workflow::CheckedProgram,
    DerivedSection: workflow::DerivedSection,
    DresserEntry: catalogue::DresserEntry,
    HistoryRecord: skiving_history::HistoryRecord,
    MeasuredCharacteristic: store::MeasuredCharacteristic,
    PartRecord: store::PartRecord,
    PartSummary: store::PartSummary,
    Preview: workflow::Preview,
    Remark: workflow::Remark,
    RunState: store::RunState,
    RunSummary: store::RunSummary,
    Scene: workflow::scene::Scene,
    SeriesSummary: store::SeriesSummary,
    Task: workflow::Task,
    ToolSummary: store::ToolSummary,
    WormEntry: catalogue::WormEntry,
}

/// Stands for the document of any run that is done.
pub struct ResultDocument;

impl ToSchema for ResultDocument {}

impl PartialSchema for ResultDocument {
    fn schema() -> RefOr<Schema> {
        Ref::from_schema_name(Self::name()).into()
    }
}

/// The schemas of all these types and of what they are made of, by name.
pub fn schemas() -> Map<String, Value> {
    let settings = SchemaSettings::draft2020_12().for_serialize();
    let mut generator =
        settings.with(|settings| settings.definitions_path = "/components/schemas".into()).into_generator();
    describe(&mut generator);
    // What was refused is told as a failure.
    let of_runs = |document: &DocumentFormat| document.file.ends_with(".json") && document.kind != "refusal";
    let kinds = documents().into_iter().filter(of_runs);
    let any: Vec<Value> = kinds.map(|document| document.schema_in(&mut generator).to_value()).collect();
    let handed_in = generator.subschema_for::<HandedIn>();
    let mut all = generator.take_definitions(true);
    let description = "The document of a result: that of the process, of the study or of the inspection.";
    let document = json!({ "description": description, "anyOf": any, "allOf": [handed_in] });
    all.insert(ResultDocument::name().into_owned(), document);
    all
}
