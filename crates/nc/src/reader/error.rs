//! What a reader refuses, with the place in the text. Knows no grammar.

use thiserror::Error;

/// What is wrong with a text that should be a control program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ReadProblem {
    /// The text cannot be read from where it stands.
    Unreadable,
    /// The text is longer than [`super::MAXIMUM_BYTES`].
    TextTooLong,
    /// A line is longer than the control reads.
    LineTooLong,
    /// A character that no program has.
    BadCharacter,
    /// No number where one has to be.
    BadNumber,
    /// A number of more digits than are read.
    NumberTooLong,
    /// A number outside what the word takes.
    OutOfRange,
    /// A word, code, call or axis that is not read.
    UnknownWord,
    /// A word that stands twice, or beside one that excludes it.
    Conflict,
    /// Something that has to be there is absent.
    Missing,
    /// A polynomial or spline of another degree than is read.
    DegreeNotSupported,
    /// The program does not end, or goes on after its end.
    End,
}

/// Why a text is no program that can be read, and where.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("line {line}, column {column}: {what} {word:?}; allowed: {allowed}", what = .problem.what())]
pub struct ReadError {
    /// Line, counted from 1.
    pub line: usize,
    /// Column, counted from 1.
    pub column: usize,
    /// What is wrong.
    pub problem: ReadProblem,
    /// What stands there.
    pub word: Box<str>,
    /// What would be allowed.
    pub allowed: &'static str,
}

impl ReadProblem {
    fn what(self) -> &'static str {
        match self {
            Self::Unreadable => "the text cannot be read:",
            Self::TextTooLong => "the text is too long at",
            Self::LineTooLong => "the line is too long at",
            Self::BadCharacter => "a character that no program has:",
            Self::BadNumber => "no number that can be read:",
            Self::NumberTooLong => "a number of too many digits:",
            Self::OutOfRange => "a number out of range:",
            Self::UnknownWord => "a word that is not read:",
            Self::Conflict => "a word that excludes another one, or stands twice:",
            Self::Missing => "something is missing with",
            Self::DegreeNotSupported => "a curve of too high a degree:",
            Self::End => "the end of the program is not as it has to be at",
        }
    }
}

impl ReadError {
    /// Stable kebab-case code.
    pub fn code(&self) -> &'static str {
        match self.problem {
            ReadProblem::Unreadable => "nc-read-unreadable",
            ReadProblem::TextTooLong => "nc-read-text-too-long",
            ReadProblem::LineTooLong => "nc-read-line-too-long",
            ReadProblem::BadCharacter => "nc-read-bad-character",
            ReadProblem::BadNumber => "nc-read-bad-number",
            ReadProblem::NumberTooLong => "nc-read-number-too-long",
            ReadProblem::OutOfRange => "nc-read-out-of-range",
            ReadProblem::UnknownWord => "nc-read-unknown-word",
            ReadProblem::Conflict => "nc-read-conflict",
            ReadProblem::Missing => "nc-read-missing",
            ReadProblem::DegreeNotSupported => "nc-read-degree-not-supported",
            ReadProblem::End => "nc-read-end",
        }
    }

    /// What the user can do about it, in one sentence.
    pub fn way_out(&self) -> &'static str {
        match self.problem {
            ReadProblem::Unreadable => "give a file that can be read",
            ReadProblem::TextTooLong => "divide the program",
            ReadProblem::LineTooLong => "break the line, or check that this is a program of the dialect",
            ReadProblem::BadCharacter | ReadProblem::BadNumber => {
                "check that this is a program of the dialect"
            }
            ReadProblem::NumberTooLong => "give at most 18 digits",
            ReadProblem::OutOfRange => "give a number within the range",
            ReadProblem::UnknownWord => "use only the words that are read, or check dialect and axis map",
            ReadProblem::Conflict => {
                "give each word once, in blocks of their own where they exclude each other"
            }
            ReadProblem::Missing => "add what is missing",
            ReadProblem::DegreeNotSupported => "divide the curve into cubics",
            ReadProblem::End => "end the program once, at its end",
        }
    }
}
