//! The content of a part: the files that it was measured by, and what was stated about them. Files are packed here and nowhere else.

use std::io::{self, Read, Write};

use flankwright::exchange::rexs::MAXIMUM_FILE_BYTES;
use flankwright::workflow::inspection::{MeasurementFile, Statements};
use flate2::Compression;
use flate2::read::ZlibDecoder;
use flate2::write::ZlibEncoder;

use crate::digest::{digest_of, joined};

/// What a part was measured by.
#[derive(Clone, Debug, PartialEq)]
pub struct PartContent {
    files: Vec<PackedFile>,
    statements: Statements,
}

/// A file as the store holds it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct PackedFile {
    /// Its name.
    pub name: String,
    /// SHA-256 of its bytes.
    pub digest: String,
    /// Their number.
    pub size: u64,
    /// The bytes, packed.
    pub packed: Vec<u8>,
}

impl PartContent {
    /// The files of a measurement, curves before values, and what the user stated about them.
    pub fn new(files: &[MeasurementFile], statements: Statements) -> Self {
        Self { files: files.iter().map(PackedFile::of).collect(), statements }
    }

    /// As it was read from the store.
    pub(crate) fn of_packed(files: Vec<PackedFile>, statements: Statements) -> Self {
        Self { files, statements }
    }

    /// The identity of its part: the digest of its file, of several that of their digests.
    pub fn digest(&self) -> String {
        let digests: Vec<&str> = self.files.iter().map(|file| file.digest.as_str()).collect();
        joined(&digests)
    }

    /// What the user stated about the files.
    pub fn statements(&self) -> &Statements {
        &self.statements
    }

    /// The files as they were.
    ///
    /// # Errors
    /// The name of a file that is not what was stored, and what is wrong with it.
    pub fn files(&self) -> Result<Vec<MeasurementFile>, String> {
        self.files.iter().map(PackedFile::unpacked).collect()
    }

    pub(crate) fn packed(&self) -> &[PackedFile] {
        &self.files
    }
}

impl PackedFile {
    fn of(file: &MeasurementFile) -> Self {
        // Writing to memory cannot fail.
        let packed = packed(&file.bytes).unwrap_or_default();
        let (name, size) = (file.name.clone(), file.bytes.len() as u64);
        Self { name, digest: digest_of(&file.bytes), size, packed }
    }

    /// The file as it was. No more is unpacked than was packed: a damaged file must not fill the memory.
    pub fn unpacked(&self) -> Result<MeasurementFile, String> {
        let wrong = |what: &str| format!("{}: {what}", self.name);
        let most = self.size.min(MAXIMUM_FILE_BYTES as u64);
        let mut bytes = Vec::new();
        ZlibDecoder::new(&self.packed[..])
            .take(most + 1)
            .read_to_end(&mut bytes)
            .map_err(|error| wrong(&error.to_string()))?;
        if bytes.len() as u64 != self.size || digest_of(&bytes) != self.digest {
            return Err(wrong("its bytes are not those of its digest"));
        }
        Ok(MeasurementFile { name: self.name.clone(), bytes })
    }
}

fn packed(bytes: &[u8]) -> io::Result<Vec<u8>> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes)?;
    encoder.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn content(texts: &[&str]) -> PartContent {
        let file = |(k, text): (usize, &&str)| MeasurementFile {
            name: format!("part.{k}"),
            bytes: text.as_bytes().to_vec(),
        };
        let files: Vec<MeasurementFile> = texts.iter().enumerate().map(file).collect();
        PartContent::new(&files, Statements::default())
    }

    #[test]
    fn files_come_out_as_they_went_in_and_take_less_room() {
        let long = "0.125 0.126 0.127\n".repeat(5000);
        let made = content(&[&long, ""]);
        let files = made.files().unwrap();
        assert_eq!((files[0].bytes.as_slice(), files[1].bytes.len()), (long.as_bytes(), 0));
        assert!(made.packed()[0].packed.len() * 20 < long.len());
        // The identity of a part: its only file, or all of them.
        assert_eq!(content(&["abc"]).digest(), digest_of(b"abc"));
        let both = [digest_of(b"abc"), digest_of(b"d")].join("\n");
        assert_eq!(content(&["abc", "d"]).digest(), digest_of(both.as_bytes()));
    }

    #[test]
    fn what_is_not_what_was_stored_is_refused() {
        let made = content(&["a measurement"]);
        let damaged = |change: fn(&mut PackedFile)| {
            let mut file = made.packed()[0].clone();
            change(&mut file);
            file.unpacked().unwrap_err()
        };
        assert!(damaged(|file| file.packed.truncate(3)).contains("part.0"));
        for change in [
            (|file| file.size = 3) as fn(&mut PackedFile),
            |file| file.size = 1 << 40,
            |file| file.digest = digest_of(b"another"),
        ] {
            assert!(damaged(change).contains("not those of its digest"));
        }
    }
}
