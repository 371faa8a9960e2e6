//! What was read in spite of a doubt: kind, place and words.

use serde::{Deserialize, Serialize};

/// Kinds of doubt.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub enum WarningKind {
    /// A trace ends before its last sample; it is dropped.
    TraceTruncated,
    /// A trace has more samples than it states; they are cut.
    TraceTooLong,
    /// A trace of fewer than two samples; it is dropped.
    TraceEmpty,
    /// A code stands twice; the last one holds.
    DuplicateCode,
    /// The labels are not German; codes are read, sections may not be.
    Language,
    /// A setting whose meaning is not proven.
    UnverifiedSetting,
    /// A table of pitches without one row for each tooth.
    PitchIncomplete,
    /// A line that states what cannot be used.
    Unusable,
    /// A number that no measurement gives; it counts as undefined.
    Implausible,
    /// Two files say different things.
    FilesDiffer,
    /// The last line has no end: the file may be cut short.
    FileCutShort,
    /// There are more warnings than are kept.
    MoreWarnings,
}

impl WarningKind {
    /// A stable name of the warning, for scripts.
    pub fn code(self) -> &'static str {
        match self {
            Self::TraceTruncated => "trace-truncated",
            Self::TraceTooLong => "trace-too-long",
            Self::TraceEmpty => "trace-empty",
            Self::DuplicateCode => "duplicate-code",
            Self::Language => "language",
            Self::UnverifiedSetting => "unverified-setting",
            Self::PitchIncomplete => "pitch-incomplete",
            Self::Unusable => "unusable",
            Self::Implausible => "implausible",
            Self::FilesDiffer => "files-differ",
            Self::FileCutShort => "file-cut-short",
            Self::MoreWarnings => "more-warnings",
        }
    }

    /// Whether something that was measured is missing because of it.
    pub fn loses_values(self) -> bool {
        match self {
            Self::TraceTruncated
            | Self::TraceEmpty
            | Self::PitchIncomplete
            | Self::Unusable
            | Self::Implausible
            | Self::FileCutShort
            | Self::MoreWarnings => true,
            Self::TraceTooLong
            | Self::DuplicateCode
            | Self::Language
            | Self::UnverifiedSetting
            | Self::FilesDiffer => false,
        }
    }

    /// The name in reference files.
    pub fn name(self) -> &'static str {
        match self {
            Self::TraceTruncated => "TraceTruncated",
            Self::TraceTooLong => "TraceTooLong",
            Self::TraceEmpty => "TraceEmpty",
            Self::DuplicateCode => "DuplicateCode",
            Self::Language => "Language",
            Self::UnverifiedSetting => "UnverifiedSetting",
            Self::PitchIncomplete => "PitchIncomplete",
            Self::Unusable => "Unusable",
            Self::Implausible => "Implausible",
            Self::FilesDiffer => "FilesDiffer",
            Self::FileCutShort => "FileCutShort",
            Self::MoreWarnings => "MoreWarnings",
        }
    }
}

/// A doubt about a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct InspectionWarning {
    /// Its kind.
    pub kind: WarningKind,
    /// Line of the file, from 1, where there is one.
    pub line: Option<usize>,
    /// The case in one sentence.
    pub message: String,
}

impl InspectionWarning {
    /// A doubt about the whole file.
    pub fn new(kind: WarningKind, message: impl Into<String>) -> Self {
        Self { kind, line: None, message: message.into() }
    }

    /// A doubt about a line, from 1.
    pub fn at(kind: WarningKind, line: usize, message: impl Into<String>) -> Self {
        Self { kind, line: Some(line), message: message.into() }
    }
}

impl std::fmt::Display for InspectionWarning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if let Some(line) = self.line {
            write!(f, "line {line}: ")?;
        }
        write!(f, "{} [{}]", self.message, self.kind.code())
    }
}
