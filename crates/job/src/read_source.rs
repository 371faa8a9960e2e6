//! Reads the text of an input within a size limit.

use std::io::{self, Read};
use std::path::Path;

use super::bounded::{Unread, read_bounded};
use super::diagnostic::{Diagnostic, Problem};
use super::job_error::JobError;
use super::source::Source;

/// Largest job or table that is read: 4 MiB. A job holds a few hundred numbers, a measured topography some
/// ten thousand; anything larger is a wrong file, and saying so must not take the time of reading it.
pub const MAXIMUM_BYTES: usize = 4 << 20;

impl Source {
    /// Reads a file: a regular one of at most [`MAXIMUM_BYTES`]. Pipes and devices are not opened, a larger file is not read.
    ///
    /// # Errors
    /// `unreadable-file`, `file-too-large`, `invalid-text`.
    pub fn read(path: &Path) -> Result<Self, JobError> {
        let name = path.display().to_string();
        let unreadable = |error: &io::Error| {
            let way_out = match error.kind() {
                io::ErrorKind::NotFound => {
                    "check the path; `flankwright new generating-grinding` prints an example job"
                }
                io::ErrorKind::IsADirectory => "name a file in this directory",
                io::ErrorKind::Unsupported => "save the text as a file; `-` reads a job from standard input",
                _ => "check the path and the permissions of the file",
            };
            let message = match error.kind() {
                io::ErrorKind::NotFound => format!("the file `{name}` does not exist"),
                io::ErrorKind::IsADirectory => format!("`{name}` is a directory, not a file"),
                _ => format!("the file `{name}` cannot be read: {error}"),
            };
            let finding = Diagnostic::new(Problem::UnreadableFile, message).way_out(way_out);
            JobError::single(Source::new(name.as_str(), ""), finding)
        };
        match read_bounded(path, MAXIMUM_BYTES) {
            Ok(bytes) => Self::from_bytes(&name, &bytes),
            Err(Unread::System(error)) => Err(unreadable(&error)),
            Err(Unread::TooLarge(size)) => Err(Self::too_large(&name, format!("{size} bytes"))),
        }
    }

    /// Reads a stream, e.g. standard input; `name` is what messages call it.
    ///
    /// # Errors
    /// The outer error is the stream's own; the inner one `file-too-large` or `invalid-text`.
    pub fn read_from(name: &str, stream: impl Read) -> io::Result<Result<Self, JobError>> {
        let mut bytes = Vec::new();
        stream.take(MAXIMUM_BYTES as u64 + 1).read_to_end(&mut bytes)?;
        Ok(Self::from_bytes(name, &bytes))
    }

    /// Takes bytes as text.
    ///
    /// # Errors
    /// `file-too-large`, `invalid-text`.
    pub fn from_bytes(name: &str, bytes: &[u8]) -> Result<Self, JobError> {
        let refuse = |finding| Err(JobError::single(Source::new(name, ""), finding));
        if bytes.len() > MAXIMUM_BYTES {
            return Err(Self::too_large(name, format!("more than {MAXIMUM_BYTES} bytes")));
        }
        let not_text = |offset: usize, what: String| {
            let line = 1 + bytes[..offset].iter().filter(|&&b| b == b'\n').count();
            Diagnostic::new(
                Problem::InvalidText,
                format!("`{name}` is not a text file: {what} in line {line}"),
            )
            .allowed("UTF-8 text")
            .way_out("check that this is the right file, or save it with the encoding UTF-8")
        };
        let text = match std::str::from_utf8(bytes) {
            Ok(text) => text,
            Err(error) => {
                let offset = error.valid_up_to();
                return refuse(not_text(offset, format!("byte 0x{:02x} is not UTF-8", bytes[offset])));
            }
        };
        if let Some(offset) = bytes.iter().position(|&b| b == 0) {
            return refuse(not_text(offset, "a NUL byte".to_owned()));
        }
        Ok(Self::new(name, text))
    }

    fn too_large(name: &str, size: String) -> JobError {
        let message = format!("`{name}` is too large for a job or a table");
        let finding = Diagnostic::new(Problem::FileTooLarge, message)
            .value(size)
            .allowed(format!("at most {MAXIMUM_BYTES} bytes (4 MiB)"))
            .way_out("check that this is the right file; thin out a measured topography");
        JobError::single(Self::new(name, ""), finding)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn byte_order_mark_is_dropped() {
        assert_eq!(
            Source::from_bytes("x", b"\xef\xbb\xbfa = 1").map(|s| s.text().to_owned()),
            Ok("a = 1".into())
        );
    }

    #[test]
    fn size_limit_is_exact() {
        assert!(Source::from_bytes("x", &vec![b' '; MAXIMUM_BYTES]).is_ok());
        let error = Source::from_bytes("x", &vec![b' '; MAXIMUM_BYTES + 1]).unwrap_err();
        assert_eq!(error.diagnostics[0].code, "file-too-large");
    }

    #[test]
    fn binary_input_names_its_line() {
        for (bytes, line) in [(&b"a = 1\n\xff"[..], "line 2"), (&b"\0"[..], "line 1")] {
            let error = Source::from_bytes("x", bytes).unwrap_err();
            assert_eq!(error.diagnostics[0].code, "invalid-text");
            assert!(error.diagnostics[0].message.contains(line));
        }
    }
}
