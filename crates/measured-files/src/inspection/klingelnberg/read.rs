//! From bytes to what they say: size, encoding, first line, then line by line.

use std::path::Path;

use super::limits::{MAXIMUM_FILE_BYTES, shown, too_large};
use super::reader::Reader;
use super::{FileKind, KlingelnbergFile};
use crate::inspection::InspectionError;
use crate::inspection::encoding::decode;
use foundation::geometry::Sides;
use job::{Unread, read_bounded};
/// What a file is too large in.
const BYTES: &str = "bytes of the file";

/// Reads a file.
///
/// # Errors
/// [`InspectionError::Unreadable`], also for a pipe or a device, and those of [`parse_klingelnberg`]. A file of more than
/// [`MAXIMUM_FILE_BYTES`] is not read.
pub fn read_klingelnberg(path: &Path) -> Result<KlingelnbergFile, InspectionError> {
    match read_bounded(path, MAXIMUM_FILE_BYTES) {
        Ok(bytes) => parse_klingelnberg(&bytes),
        Err(Unread::System(error)) => {
            Err(InspectionError::Unreadable { file: path.display().to_string(), cause: error.to_string() })
        }
        Err(Unread::TooLarge(found)) => {
            Err(InspectionError::FileTooLarge { what: BYTES.into(), found, most: MAXIMUM_FILE_BYTES })
        }
    }
}

/// Reads the content of a file (`docs/inspection.md`).
///
/// # Errors
/// [`InspectionError::FileTooLarge`], [`InspectionError::UnsupportedEncoding`], [`InspectionError::NotKlingelnberg`],
/// [`InspectionError::TooManyUnknownLines`]. Everything else that is wrong is reported in `warnings` and `unknown_lines`.
pub fn parse_klingelnberg(bytes: &[u8]) -> Result<KlingelnbergFile, InspectionError> {
    too_large(BYTES, bytes.len(), MAXIMUM_FILE_BYTES)?;
    let (text, encoding) = decode(bytes)?;
    let mut lines = lines(&text).filter(|(_, line)| !line.trim().is_empty());
    let (at, first) = lines.next().unwrap_or((0, ""));
    let kind = match first.split_whitespace().collect::<Vec<_>>()[..] {
        ["HEADER", "KS.MK.FILE"] => FileKind::Curves,
        ["HEADER", "KS.MW.FILE"] => FileKind::Values,
        _ => return Err(InspectionError::NotKlingelnberg { line: at, found: shown(first) }),
    };
    let mut reader = Reader::new(KlingelnbergFile {
        kind,
        encoding,
        preamble: Vec::new(),
        header: Default::default(),
        curves: Vec::new(),
        circles: Vec::new(),
        pitch: Sides::default(),
        positions: Vec::new(),
        results: Default::default(),
        warnings: Vec::new(),
        unknown_lines: Vec::new(),
    });
    let mut last = at;
    for (number, line) in lines {
        reader.line(number, line.trim())?;
        last = number;
    }
    // The machine ends every line; without that end nobody knows whether the last number is whole.
    Ok(reader.finish((!text.ends_with(['\r', '\n'])).then_some(last)))
}

/// Lines with their numbers, from 1; they end with CRLF, LF or CR.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut rest = Some(text);
    let next = move || {
        let text = rest?;
        let end = text.find(['\r', '\n']);
        let Some(end) = end else {
            rest = None;
            return Some(text);
        };
        let width = if text[end..].starts_with("\r\n") { 2 } else { 1 };
        rest = Some(&text[end + width..]);
        Some(&text[..end])
    };
    std::iter::from_fn(next).enumerate().map(|(k, line)| (k + 1, line))
}
