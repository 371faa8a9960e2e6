//! Why a measurement cannot be read or is no use, each with the data of the case.

use finding::Finding;
use foundation::geometry::Flank;
use thiserror::Error;

/// Errors of reading measurements.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum InspectionError {
    /// The file is absent or cannot be read.
    #[error("the file `{file}` cannot be read: {cause}")]
    #[finding(code = "unreadable-file")]
    #[way_out("check the path and the permissions of the file")]
    Unreadable {
        /// Its path.
        file: String,
        /// What the system says.
        cause: String,
    },
    /// More bytes, traces or samples than a measurement has.
    #[error("{what}: {found}; at most {most} are read")]
    #[finding(code = "file-too-large")]
    #[way_out("check that this is one measurement of one gear, and split it if it is not")]
    FileTooLarge {
        /// What there is too much of.
        what: String,
        /// How much there is, at least.
        found: usize,
        /// How much is read.
        most: usize,
    },
    /// UTF-16, binary content or broken UTF-8.
    #[error("the encoding of the file is not supported: {what}")]
    #[finding(code = "unsupported-encoding")]
    #[way_out("export the file again as text in UTF-8 or in code page 1252")]
    UnsupportedEncoding {
        /// What was found.
        what: String,
    },
    /// The first line is not that of an .mka or .mew file.
    #[error(
        "the file does not begin with HEADER KS.MK.FILE or HEADER KS.MW.FILE, but with {found:?} in line {line}"
    )]
    #[finding(code = "not-klingelnberg")]
    #[way_out("check that this is an .mka or .mew file, and that its beginning is complete")]
    NotKlingelnberg {
        /// Line of the first text, from 1; 0 in a file without any.
        line: usize,
        /// The beginning of that line.
        found: String,
    },
    /// Most of the file is not understood.
    #[error("more than {most} lines are not understood; the first is line {line}: {text:?}")]
    #[finding(code = "too-many-unknown-lines")]
    #[way_out("export the measurement again; the file is damaged or of another kind")]
    TooManyUnknownLines {
        /// How many are passed over.
        most: usize,
        /// The first of them, from 1.
        line: usize,
        /// Its beginning.
        text: String,
    },
    /// A line of the header that is needed is absent or holds no number.
    #[error("the header has no usable line {code} ({meaning})")]
    #[finding(code = "missing-code")]
    #[way_out("export the measurement with its complete header")]
    MissingCode {
        /// The code.
        code: u16,
        /// What it stands for.
        meaning: &'static str,
    },
    /// A setting whose meaning no measurement at hand has proven.
    #[error("{setting} = {value}: {reason}")]
    #[finding(code = "unverified-setting")]
    #[way_out("measure with the setting that is verified, or export the values as a table (.csv)")]
    UnverifiedSetting {
        /// Name or code of the setting.
        setting: String,
        /// Its value.
        value: String,
        /// What is not known about it.
        reason: &'static str,
    },
    /// A diameter that the involute does not reach.
    #[error("{what} = {diameter} mm lies below the base circle of the {flank} flank, {base_diameter} mm")]
    #[finding(code = "below-base-circle")]
    #[way_out("correct the diameter, or module, teeth and pressure angle of the header")]
    BelowBaseCircle {
        /// The diameter's name.
        what: String,
        /// The flank.
        flank: Flank,
        /// The diameter, mm.
        diameter: f64,
        /// Base diameter, mm.
        base_diameter: f64,
    },
    /// A number that makes no gear or no trace.
    #[error("{what} = {value:?} is not usable; allowed: {allowed}")]
    #[finding(code = "bad-input")]
    #[way_out("correct the value in the header of the file")]
    BadInput {
        /// The quantity.
        what: String,
        /// Its value.
        value: f64,
        /// Allowed range in words.
        allowed: &'static str,
    },
    /// Files of two different parts.
    #[error("the files belong to different parts: {what} is {first:?} and {second:?}")]
    #[finding(code = "different-parts")]
    #[way_out("give only the files of one part together")]
    DifferentParts {
        /// What differs.
        what: &'static str,
        /// In the first file.
        first: String,
        /// In a later file.
        second: String,
    },
}
