//! Measured gears, from files to figures: what was read, evaluated to ISO 1328-1, judged by classes, beside what the measuring machine
//! printed; and for a job, what the process has to do with it.

mod areal;
mod asked;
mod assemble;
mod averaged;
mod bands;
pub mod bevel;
pub mod blank;
mod blank_written;
mod characteristics;
mod closed_loop;
pub mod convert;
mod drawn;
mod evaluate;
mod files;
mod files_content;
mod judgement;
mod middle;
mod printed;
mod readings;
mod result;
pub mod run;
pub mod series;
pub mod sheet;
mod standing_out;
mod statements;
mod summary;
mod surface;
mod tables;
mod twist;
pub mod write;

pub use bands::Bands;
pub use bevel::{BevelInspection, BevelInspectionResult, inspect_bevel, write_bevel_inspection};
pub use blank::{BlankStock, BlankStockResult, blank_of_content, blank_of_file};
pub use blank_written::{STOCK_TABLE, write_blank};
pub(crate) use characteristics::characteristic_in_words;
pub use characteristics::{PartCharacteristic, PartIdentity, characteristic_key, part_characteristics};
pub use closed_loop::{
    AxesTogether, AxisResult, CharacteristicResult, CorrectedSettingResult, CorrectionResult,
    DifferenceResult, JointAxis, MachineChange, MeasuredFlankResult, ProofResult, Round, RoundResult,
};
pub use convert::{GearOfRexs, gear_of_rexs, rexs_of_job};
pub use drawn::DrawnGear;
pub use evaluate::{
    Design, EvaluatedGear, EvaluatedPitch, EvaluatedTrace, JudgedValue, LeftOut, evaluate_inspection,
};
pub use files::{
    LeftOutFile, MeasuredFolder, MeasurementFile, files_of_measurement, is_measurement, measurements_in,
    parse_measurement, read_measurement,
};
pub use files_content::MeasuredFiles;
pub use generating_grinding::stock_file::MeasuredStock;
pub use result::{
    ArealResult, BandResult, ClassResult, GearInspectionResult, LinesResult, PitchInspectionResult,
    PrintedResult, SummaryResult, ThicknessResult, TraceInspectionResult, TwistResult, class_in_words,
};
pub use run::{GearInspection, inspect_for_job, inspect_for_milling, inspect_gear, inspect_simulated};
pub use sheet::{SheetOptions, inspection_sheet, sheet_data, sheet_pages};
pub use statements::Statements;
pub use write::write_gear_inspection;
