//! The job file of generating grinding as types: one table of the file, one file here. A `Job` has the right keys, types and ranges;
//! contradictions between entries are found when it is read. The ranges stand beside the fields, so that the published schema and the
//! messages cannot disagree.

mod catalogue;
pub mod checks;
pub mod compensation;
mod conditions;
mod designed_for;
mod deviations;
pub mod diagonal_ratio;
mod dresser;
mod dressing;
mod dressing_study;
mod economy;
mod explore;
mod gauge;
mod gear_root;
pub mod grinding;
pub mod inspection;
pub mod measured_gear;
mod measured_worm;
mod over_width;
mod settings;
mod steps;
mod stock;
mod stroke;
mod stroke_study;
mod strokes;
mod target;
mod technology;
mod worm;
mod worm_life;

pub use catalogue::{CatalogueSource, FreeQuantity, FreeWorm, RankBy};
pub use compensation::Compensation;
pub use conditions::{
    Condition, ConditionOf, ConditionWord, DegreeOfFreedom, FixedCondition, HeadCondition, MapCondition,
    PointCondition, StretchCondition,
};
pub use designed_for::DesignedFor;
pub use deviations::{DressingDeviation, MachineDeviations};
pub use diagonal_ratio::{
    DiagonalRatio, DiagonalRule, LineBlendCurve, LineSineCurve, PointsCurve, ShiftCurve, ShiftLaw, ShiftTable,
};
pub use dresser::{Dresser, DresserContact, DresserModification, FixedDresser, OtherDresser};
pub use dressing::{Dressing, DressingFlanks, ProfileCrowningBy};
pub use dressing_study::{Compare, DressingStudy, StudyOver};
pub use economy::{AxisLimits, Prefer};
pub use explore::Explore;
pub use gauge::{Gauge, GaugeRule, GivenGauge};
pub use gear_root::{GearRoot, RootAlong};
pub use grinding::{Grinding, Method};
pub use inspection::{Band, CorrectionLimits, CorrectionSetting, Inspection};
pub use measured_gear::SimulatedMeasurement;
pub use measured_worm::MeasuredWorm;
pub use over_width::OverWidth;
use over_width::{SHARES, STRETCHES};
pub use settings::{FlankSettings, Pieces, Settings, StrokeSettings, StrokeTables, ToolTable, ToolTables};
pub use steps::Steps;
pub use stock::{HobMarks, PitchStock, RunOut, Stock, StockPlace, StockTerm};
pub use stroke::{FeedDirection, StrokeOfJob, StrokeShift, StrokeZone};
pub use stroke_study::{AxisDeviations, Distribution, DresserArea, StrokeSection, StrokeStudy};
pub use strokes::{DressedSection, StrokeArea, Strokes};
pub use target::{Fit, Judged, JudgedTraces, Target, ToleranceMapSource, ToleranceTable};
pub use technology::{
    CostRates, CycleRule, DressingOfShop, DressingRotation, PartTimes, Technology, TechnologyLimits, WormLife,
};
pub use worm::{FlankForm, Tool, Worm};
pub use worm_life::WormLifeStudy;

use job::tables::{Control, Gear, Grid, Hand, JobInfo, Language, Machine, OneOrSides, Output};
use job::{Diagnostic, Document, Loaded, Problem, ProcessJob};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A job of generating grinding: what flank is wanted, with which bodies, by which motions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "if" = { "required": ["catalogue"] },
    "then" = { "not": { "anyOf": [{ "required": ["worm"] }, { "required": ["dresser"] }, { "required": ["settings"] }] } },
    "else" = {
        "required": ["worm"],
        "if": {
            "properties": { "worm": { "properties": { "tool": { "enum": ["given", "made"] } }, "required": ["tool"] } },
            "required": ["worm"]
        },
        "then": { "not": { "required": ["dresser"] } },
        "else": { "required": ["dresser"] }
    }
))]
pub struct Job {
    /// Name and process.
    pub job: JobInfo,
    /// The workpiece.
    pub gear: Gear,
    /// The wanted flank.
    pub target: Target,
    /// The grinding worm; absent exactly if there is a catalogue.
    #[serde(default = "Worm::absent", skip_serializing_if = "Worm::is_absent")]
    pub worm: Worm,
    /// The catalogue from which worm and dresser are chosen, in place of `worm` and `dresser`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub catalogue: Option<CatalogueSource>,
    /// The disc dresser that profiles the worm; there is one exactly if `worm.tool` is `"dressed"`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub dresser: Option<Dresser>,
    /// How the worm is dressed.
    #[serde(default)]
    pub dressing: Dressing,
    /// How the gear is ground.
    pub grinding: Grinding,
    /// What stands on the flanks before grinding; with it a plan says what each stroke takes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stock: Option<Stock>,
    /// What the shop allows, and what a part takes and costs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub technology: Option<Technology>,
    /// The machine; without one the default limits hold.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub machine: Option<Machine>,
    /// The control that couples the axes; without one they move exactly as commanded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub control: Option<Control>,
    /// Points of the result grid.
    #[serde(default)]
    pub grid: Grid,
    /// What to write beside result and report.
    #[serde(default)]
    pub output: Output,
    /// Axes that are off: what the planned settings leave then.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub deviations: Option<MachineDeviations>,
    /// A worm as it was measured after dressing: which axes of dressing it points to.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub measured_worm: Option<MeasuredWorm>,
    /// How a measured gear is judged and corrected.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inspection: Option<Inspection>,
    /// What plans add to the target because of a measurement.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub compensation: Option<Compensation>,
    /// Settings that a study varies.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub explore: Option<Explore>,
    /// Settings of motions and dresser that `simulate` runs; `plan` writes them and does not read them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub settings: Option<Settings>,
}

impl Job {
    /// Hand of the worm: as given, else that of the gear (spur: right).
    pub fn worm_hand(&self) -> Hand {
        self.worm.hand.unwrap_or(self.gear.default_worm_hand())
    }

    /// The disc that writes the worm line by line, with its tip radius, mm; `None` for every other tool.
    pub fn point_dresser(&self) -> Option<(&Dresser, f64)> {
        let point = |d: &&Dresser| self.worm.tool == Tool::Dressed && d.contact == DresserContact::Point;
        self.dresser.as_ref().filter(point).and_then(|d| Some((d, d.tip_radius?)))
    }

    /// Whether the job wants a worm topography, from which the gear follows, in place of a gear.
    pub fn wants_worm(&self) -> bool {
        self.worm.tool == Tool::Dressed && self.worm.modifications.is_some()
    }

    /// Normal pressure angles of the worm in degrees: as given, else those of the gear.
    pub fn worm_pressure_angle_deg(&self) -> OneOrSides<f64> {
        self.worm.normal_pressure_angle_deg.unwrap_or(self.gear.normal_pressure_angle_deg)
    }
}

/// A checked job of generating grinding.
pub type LoadedJob = Loaded<Job>;

impl ProcessJob for Job {
    const NAME: &'static str = "generating-grinding";
    const ABOUT: &'static str = "Generating grinding with a dressed worm.";
    const TEMPLATE: &'static str = include_str!("job/template.toml");

    fn info(&self) -> &JobInfo {
        &self.job
    }

    fn language(&self) -> Language {
        self.output.language
    }

    /// Each of the tables `[worm]` and `[catalogue]` may be absent because the other is there.
    fn shape(document: &Document) -> Vec<Diagnostic> {
        let has = |table: &str| document.root().follow(table).is_some();
        if has("worm") || has("catalogue") {
            return Vec::new();
        }
        let finding = Diagnostic::new(Problem::MissingKey, "the table `[worm]` is missing")
            .field("worm")
            .allowed("a table [worm], or a table [catalogue] to choose worm and dresser from")
            .way_out("add `[worm]`; `flankwright new generating-grinding` prints a complete example")
            .span(Some(document.root().span.clone()));
        vec![finding]
    }

    fn contradictions(&self) -> Vec<Diagnostic> {
        checks::check(self)
    }
}
