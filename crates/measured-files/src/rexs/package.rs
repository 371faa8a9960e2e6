//! Files: which form one has, how large it may be, and the packed form of either.

use std::io::{Cursor, Read, Write};
use std::path::Path;

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, System, ZipArchive, ZipWriter};

use super::document::{RexsDocument, RexsFormat};
use super::error::RexsError;
use super::warning::RexsWarning;
use super::{json_read, json_write, xml_read, xml_write};
use job::{Unread, read_bounded};

/// Largest file that is read, packed or unpacked: 64 MiB.
pub const MAXIMUM_FILE_BYTES: usize = 64 << 20;

/// What a file is too large in.
const BYTES: &str = "bytes of the file";

/// Reads a .rexs, .rexsj or .rexsz file; its content decides which it is.
///
/// # Errors
/// [`RexsError::Unreadable`], also for a pipe or a device, and those of [`parse_rexs`]. A file of more than [`MAXIMUM_FILE_BYTES`] is not
/// read.
pub fn read_rexs(path: &Path) -> Result<RexsDocument, RexsError> {
    match read_bounded(path, MAXIMUM_FILE_BYTES) {
        Ok(bytes) => parse_rexs(&bytes),
        Err(Unread::System(error)) => {
            Err(RexsError::Unreadable { file: path.display().to_string(), cause: error.to_string() })
        }
        Err(Unread::TooLarge(found)) => {
            Err(RexsError::FileTooLarge { what: BYTES, found, most: MAXIMUM_FILE_BYTES })
        }
    }
}

/// Reads the content of a file: XML, JSON, or one of them packed.
///
/// # Errors
/// [`RexsError::FileTooLarge`], [`RexsError::NotRexs`], [`RexsError::EntitiesRefused`], [`RexsError::Structure`],
/// [`RexsError::BadValue`].
pub fn parse_rexs(bytes: &[u8]) -> Result<RexsDocument, RexsError> {
    bounded(BYTES, bytes.len())?;
    if bytes.starts_with(b"PK\x03\x04") {
        return text(&unpacked(bytes)?);
    }
    text(bytes)
}

fn bounded(what: &'static str, found: usize) -> Result<(), RexsError> {
    let most = MAXIMUM_FILE_BYTES;
    if found > most { Err(RexsError::FileTooLarge { what, found, most }) } else { Ok(()) }
}

fn text(bytes: &[u8]) -> Result<RexsDocument, RexsError> {
    let text = std::str::from_utf8(bytes).map_err(|error| RexsError::NotRexs {
        what: format!("the byte at offset {} is not UTF-8", error.valid_up_to()),
    })?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    match text.trim_start().chars().next() {
        Some('<') => xml_read::document(text),
        Some('{') => json_read::document(text),
        _ => Err(RexsError::NotRexs { what: "it begins neither as XML nor as JSON".into() }),
    }
}

/// The one REXS file of a package.
fn unpacked(bytes: &[u8]) -> Result<Vec<u8>, RexsError> {
    let broken =
        |error: &dyn std::fmt::Display| RexsError::NotRexs { what: format!("a broken package: {error}") };
    let mut package = ZipArchive::new(Cursor::new(bytes)).map_err(|e| broken(&e))?;
    let name = {
        let readable = package.file_names().filter_map(Result::ok);
        let mut names = readable.filter(|name| name.ends_with(".rexs") || name.ends_with(".rexsj"));
        match (names.next(), names.next()) {
            (Some(name), None) => name.into_owned(),
            (None, _) => return Err(RexsError::NotRexs { what: "a package without .rexs or .rexsj".into() }),
            _ => return Err(RexsError::NotRexs { what: "a package with more than one model".into() }),
        }
    };
    let mut content = Vec::new();
    let entry = package.by_name(&name).map_err(|e| broken(&e))?;
    // What the package says about the size is not believed.
    entry.take(MAXIMUM_FILE_BYTES as u64 + 1).read_to_end(&mut content).map_err(|e| broken(&e))?;
    bounded("unpacked bytes of the file", content.len())?;
    Ok(content)
}

/// The bytes of a file, packed or not, and what they do not hold. A package holds no time: the same model gives the same bytes.
///
/// # Errors
/// [`RexsError::NotExpressibleInRexs`] if the package cannot be made.
pub fn rexs_bytes(
    document: &RexsDocument,
    format: RexsFormat,
    packed: bool,
) -> Result<(Vec<u8>, Vec<RexsWarning>), RexsError> {
    let mut warnings = Vec::new();
    let text = match format {
        RexsFormat::Xml => xml_write::xml(document, &mut warnings),
        RexsFormat::Json => json_write::json(document, &mut warnings),
    };
    if !packed {
        return Ok((text.into_bytes(), warnings));
    }
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .last_modified_time(DateTime::DEFAULT)
        .system(System::Unix)
        .unix_permissions(0o644);
    let failed = |error: &dyn std::fmt::Display| RexsError::NotExpressibleInRexs {
        what: "the package".into(),
        reason: error.to_string(),
    };
    let mut package = ZipWriter::new(Cursor::new(Vec::new()));
    package.start_file(format!("model.{}", format.extension()), options).map_err(|e| failed(&e))?;
    package.write_all(text.as_bytes()).map_err(|e| failed(&e))?;
    Ok((package.finish().map_err(|e| failed(&e))?.into_inner(), warnings))
}
