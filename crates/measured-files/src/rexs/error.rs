//! Why a REXS file cannot be read or written, each with the data of the case.

use finding::Finding;
use foundation::geometry::{Flank, GeometryError};
use foundation::modification::{EvaluationError, ModificationError};
use thiserror::Error;

/// Errors of REXS files.
#[derive(Clone, Debug, PartialEq, Error, Finding)]
pub enum RexsError {
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
    /// More bytes, packed or unpacked, than a model has.
    #[error("{what}: {found}; at most {most} are read")]
    #[finding(code = "file-too-large")]
    #[way_out("export only the gear, without load spectra and results")]
    FileTooLarge {
        /// What there is too much of.
        what: &'static str,
        /// How much there is, at least.
        found: usize,
        /// How much is read.
        most: usize,
    },
    /// Neither XML nor JSON nor a packed file, or not well-formed.
    #[error("the file is no REXS file: {what}")]
    #[finding(code = "not-rexs")]
    #[way_out("give a .rexs, .rexsj or .rexsz file in UTF-8")]
    NotRexs {
        /// What was found.
        what: String,
    },
    /// The file declares entities or a document type.
    #[error("the file declares a document type; entities are not expanded")]
    #[finding(code = "entities-refused")]
    #[way_out("remove the document type from the file")]
    EntitiesRefused,
    /// The structure is not that of a REXS file.
    #[error("{place}: {what}")]
    #[finding(code = "rexs-structure")]
    #[way_out("have the file checked against the schema of REXS 2.0 by the program that wrote it")]
    Structure {
        /// Where.
        place: String,
        /// What is wrong there.
        what: String,
    },
    /// An attribute that must be there is absent.
    #[error("{component} has no attribute `{attribute}`")]
    #[finding(code = "missing-attribute")]
    #[way_out("state the attribute in the program that wrote the file")]
    MissingAttribute {
        /// The component.
        component: String,
        /// The attribute.
        attribute: &'static str,
    },
    /// A value of another type than the attribute has, or out of range.
    #[error("the attribute `{attribute}` of {component} cannot be {value:?}; allowed: {allowed}")]
    #[finding(code = "bad-value")]
    #[way_out("correct the value in the program that wrote the file")]
    BadValue {
        /// The component.
        component: String,
        /// The attribute.
        attribute: String,
        /// The value as given.
        value: String,
        /// What would be allowed.
        allowed: &'static str,
    },
    /// A unit that the attribute cannot have.
    #[error("the attribute `{attribute}` of {component} has the unit {unit:?}; allowed: {allowed}")]
    #[finding(code = "unknown-unit")]
    #[way_out("export the file with the units of the schema")]
    UnknownUnit {
        /// The component.
        component: String,
        /// The attribute.
        attribute: String,
        /// The unit as given.
        unit: String,
        /// Units that are converted.
        allowed: &'static str,
    },
    /// A gear without names of its flanks.
    #[error("no relation `flank` says which flanks the gear {gear} has")]
    #[finding(code = "no-flank-relation")]
    #[way_out("export the gear with its flanks and the relation between them")]
    NoFlankRelation {
        /// Number of the gear's component.
        gear: i32,
    },
    /// Lists that belong together are of different lengths.
    #[error("{component}: {what}")]
    #[finding(code = "array-length")]
    #[way_out("give one coordinate, one diameter and one amount for each point")]
    ArrayLength {
        /// The component.
        component: String,
        /// The lengths.
        what: String,
    },
    /// Points of a topography that make no grid.
    #[error(
        "{component}: {points} points, but {coordinates} coordinates with {diameters} diameters each make a grid"
    )]
    #[finding(code = "grid-incomplete")]
    #[way_out("give every diameter at every coordinate, each once")]
    GridIncomplete {
        /// The component.
        component: String,
        /// Points given.
        points: usize,
        /// Different coordinates along the face.
        coordinates: usize,
        /// Different diameters.
        diameters: usize,
    },
    /// A crowning with two amounts and no highest point.
    #[error("{component} has different amounts at its two ends and no highest point")]
    #[finding(code = "two-arc-crowning")]
    #[way_out("state the highest point of the crowning")]
    TwoArcCrowning {
        /// The component.
        component: String,
    },
    /// Something that the format has no place for.
    #[error("{what} cannot be expressed in REXS: {reason}")]
    #[finding(code = "not-expressible-in-rexs")]
    #[way_out("leave it out, or hand it over in a file of its own")]
    NotExpressibleInRexs {
        /// The body or the modification.
        what: String,
        /// Why.
        reason: String,
    },
    /// Numbers that make no gear.
    #[error("the gear {gear} is none: {error}")]
    #[finding(code = "no-gear")]
    #[way_out("correct the data of the gear")]
    NoGear {
        /// Number of the gear's component; 0 for one that is to be written.
        gear: i32,
        /// What is wrong with it.
        error: GeometryError,
    },
    /// A modification that is wrong by itself.
    #[error("a modification of the {flank} flank cannot be built: {error}")]
    #[finding(code = "modification")]
    #[way_out("correct the modification in the job")]
    Modification {
        /// The flank.
        flank: Flank,
        /// What is wrong with it.
        error: ModificationError,
    },
    /// A modification without a value somewhere on the flank.
    #[error("a modification of the {flank} flank has no value: {error}")]
    #[finding(code = "no-value")]
    #[way_out("correct the modification in the job")]
    NoValue {
        /// The flank.
        flank: Flank,
        /// Where and why.
        error: EvaluationError,
    },
}
