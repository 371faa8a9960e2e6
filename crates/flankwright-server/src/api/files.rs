//! Files of results.

use std::io::{Cursor, Write};
use std::sync::Arc;

use axum::extract::State;
use axum::http::header::{CONTENT_DISPOSITION, CONTENT_ENCODING, CONTENT_SECURITY_POLICY, CONTENT_TYPE};
use axum::response::{IntoResponse, Response};
use serde::Deserialize;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use super::error::{Answer, Refused};
use super::runs::{is_listed, record};
use super::short::short;
use super::take::{InPath, InQuery};
use crate::app::App;
use crate::assets::media_type;
use crate::headers::REPORT;
use crate::openapi::library;
use crate::wire::Failure;
use crate::work::SCENE;

/// How a file is wanted.
#[derive(Debug, Deserialize, utoipa::IntoParams)]
#[into_params(parameter_in = Query)]
#[serde(deny_unknown_fields)]
pub struct Wanted {
    /// To be saved, not shown.
    #[serde(default)]
    pub download: bool,
}

/// A name that stands in a header as it is.
fn plain(name: &str) -> String {
    let last = name.rsplit('/').next().unwrap_or_default();
    last.chars().map(|c| if c.is_ascii_alphanumeric() || ".-_".contains(c) { c } else { '_' }).collect()
}

/// A file of a result.
#[utoipa::path(get, path = "/api/runs/{id}/files/{name}", params(("id" = i64, Path, description = "number of the run"),
    ("name" = String, Path, description = "as the run lists it"), Wanted),
    responses((status = 200, content_type = "application/octet-stream"), (status = 404, body = Failure)))]
pub async fn file(
    State(app): State<Arc<App>>,
    InPath((id, name)): InPath<(i64, String)>,
    InQuery(wanted): InQuery<Wanted>,
) -> Answer<Response> {
    let file = match is_listed(&name) {
        true => app.store.run_file(id, &name).await?,
        false => None,
    };
    let file = file.ok_or_else(|| Refused::absent("file"))?;
    let how = if wanted.download { "attachment" } else { "inline" };
    let mut response = file.bytes.into_response();
    let headers = response.headers_mut();
    let mut set = |name, value: &str| {
        if let Ok(value) = value.parse() {
            headers.insert(name, value);
        }
    };
    set(CONTENT_TYPE, media_type(&name));
    set(CONTENT_DISPOSITION, &format!("{how}; filename=\"{}\"", plain(&name)));
    if name.ends_with(".html") {
        set(CONTENT_SECURITY_POLICY, REPORT);
    }
    Ok(response)
}

/// Bodies and motions of a run for a view in space.
#[utoipa::path(get, path = "/api/runs/{id}/scene", params(("id" = i64, Path, description = "number of the run")),
    responses((status = 200, body = library::Scene), (status = 404, body = Failure)))]
pub async fn scene(State(app): State<Arc<App>>, InPath(id): InPath<i64>) -> Answer<Response> {
    let file = app.store.run_file(id, SCENE).await?.ok_or_else(|| Refused::absent("scene"))?;
    // Kept as it goes over the wire.
    let headers = [(CONTENT_TYPE, "application/json"), (CONTENT_ENCODING, "gzip")];
    Ok((headers, file.bytes).into_response())
}

/// All files of a result as ZIP.
#[utoipa::path(get, path = "/api/runs/{id}/archive", params(("id" = i64, Path, description = "number of the run")),
    responses((status = 200, content_type = "application/zip"), (status = 404, body = Failure)))]
pub async fn archive(State(app): State<Arc<App>>, InPath(id): InPath<i64>) -> Answer<Response> {
    // As many as the memory holds; the others wait.
    let _room = app.archives.acquire().await.map_err(|_| Refused::busy("the server ends"))?;
    let run = record(&app, id).await?;
    let mut files = Vec::with_capacity(run.files.len());
    for file in run.files.iter().filter(|file| is_listed(&file.name)) {
        files.extend(app.store.run_file(id, &file.name).await?);
    }
    if files.is_empty() {
        return Err(Refused::absent("result"));
    }
    let packed = short(&app, move |_| {
        let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
        let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
        let failed =
            |error: String| Refused::bad(Failure::internal(format!("the archive cannot be packed: {error}")));
        for file in files {
            archive.start_file(file.name, options).map_err(|error| failed(error.to_string()))?;
            archive.write_all(&file.bytes).map_err(|error| failed(error.to_string()))?;
        }
        archive.finish().map(Cursor::into_inner).map_err(|error| failed(error.to_string()))
    })
    .await?;
    let name = format!("attachment; filename=\"{}-{id}.zip\"", plain(&run.summary.name));
    Ok(([(CONTENT_TYPE, "application/zip".to_owned()), (CONTENT_DISPOSITION, name)], packed).into_response())
}
