//! Puts the sections of a generating-grinding report in their order.

use super::data::{GeneratingReport, RatioChoice, Verification};
use super::{motions, result, strokes, topographies};
use crate::charts::{
    ChartError, DressingSectionChart, dressing_section_chart, format_fixed, format_significant,
    worm_occupation_chart,
};
use crate::control::ControlReport;
use crate::data::{Block, Column, Fact, Figure, PlanReport, Section, Table};
use crate::head::scope_blocks;
use crate::ids::kebab;
use crate::programs::ProgramsReport;

/// Id of the section with the pictures of the flanks.
pub const TOPOGRAPHIES: &str = "topographies";
/// Id of the section on the referee.
pub const VERIFICATION: &str = "verification";

impl GeneratingReport {
    /// Arranges the figures as a page.
    ///
    /// # Errors
    /// [`ChartError`] if a motion or trace holds values that are not finite or lists of different length.
    pub fn to_page(&self) -> Result<PlanReport, ChartError> {
        let mut dressing = motions::dressing(&self.dressing)?;
        dressing.extend(strokes::figures(&self.strokes)?);
        let sections = vec![
            Section::new("result-per-flank", "Result per flank", result::summary(self)),
            Section::new("scope-of-the-verdict", "Scope of the verdict", scope_blocks(&self.verdict)),
            warnings(self),
            Section::new("gear-and-tools", "Gear and tools", data_sheets(self)),
            Section::new("settings", "Settings", settings(self)?),
            Section::new(TOPOGRAPHIES, "Topographies", topographies::figures(&self.flanks)?),
            Section::new("profile-and-helix", "Profile and helix", topographies::diagram(&self.flanks)?),
            Section::new("grinding-motion", "Grinding motion", motions::grinding(&self.grinding_motions)?),
            Section::new("dressing-corrections", "Dressing corrections", dressing),
            Section::new("room-for-the-dresser", "Room for the dresser", sections(self)?),
            Section::new(
                "gearbox-and-servo",
                "Gearbox and servo",
                self.control.as_ref().map_or(Ok(Vec::new()), ControlReport::blocks)?,
            ),
            Section::new("nc-programs", "NC programs", programs(self)?),
            Section::new(
                VERIFICATION,
                "How it was verified",
                self.verification.as_ref().map(verification).unwrap_or_default(),
            ),
            Section::new(
                "convergence-of-the-precompensation",
                "Convergence of the precompensation",
                motions::convergence(&self.convergence)?,
            ),
            Section::new("time-and-files", "Time and files", time_and_files(self)),
        ];
        Ok(PlanReport {
            title: self.job_name.clone(),
            subtitle: self.description.clone(),
            facts: vec![Fact::new("Process", &self.process), Fact::new("flankwright", &self.version)],
            banner: result::banner(self),
            sections: sections.into_iter().filter(|section| !section.blocks.is_empty()).collect(),
        })
    }
}

fn warnings(report: &GeneratingReport) -> Section {
    let blocks =
        if report.warnings.is_empty() { Vec::new() } else { vec![Block::Warnings(report.warnings.clone())] };
    Section::new("warnings", "Warnings", blocks)
}

fn data_sheets(report: &GeneratingReport) -> Vec<Block> {
    let sheets = [("Gear", &report.gear), ("Worm", &report.worm), ("Dresser", &report.dresser)];
    let tables: Vec<Table> = sheets
        .into_iter()
        .filter(|(_, quantities)| !quantities.is_empty())
        .map(|(caption, quantities)| Table::of_quantities(caption, quantities))
        .collect();
    if tables.is_empty() { Vec::new() } else { vec![Block::Tables(tables)] }
}

fn settings(report: &GeneratingReport) -> Result<Vec<Block>, ChartError> {
    let mut blocks = Vec::new();
    if !report.settings.is_empty() {
        blocks.push(Block::Table(Table::of_quantities("", &report.settings)));
    }
    if let Some(ratio) = &report.ratio {
        blocks.extend(ratio_choice(ratio));
    }
    if let Some(chart) = &report.occupation {
        let caption =
            "Which part of the tool's width each area takes; areas a pitch apart share no line of the tool.";
        let svg = worm_occupation_chart(chart)?;
        blocks.push(Block::Figure(Figure::new("areas-over-the-width-of-the-tool", svg, caption)));
    }
    Ok(blocks)
}

fn ratio_choice(ratio: &RatioChoice) -> Vec<Block> {
    let text = match ratio.chosen {
        Some(chosen) => format!("Diagonal ratio K = {}. {}", format_significant(chosen, 7), ratio.reason),
        None => format!("No diagonal ratio is allowed. {}", ratio.reason),
    };
    let mut blocks = vec![Block::Paragraph(text)];
    if !ratio.candidates.is_empty() {
        let or_dash =
            |value: Option<f64>, digits| value.map_or("–".to_owned(), |v| format_significant(v, digits));
        blocks.push(Block::Table(Table {
            caption: "Diagonal ratios compared".to_owned(),
            columns: vec![
                Column::number("K", ""),
                Column::text("Profile crowning by"),
                Column::number("Score", "share of limits"),
                Column::number("Occupation", "mm"),
                Column::number("Model error", "µm"),
                Column::text("Remark"),
            ],
            rows: ratio
                .candidates
                .iter()
                .map(|c| {
                    vec![
                        format_fixed(c.ratio, 5),
                        c.place.clone(),
                        or_dash(c.score, 3),
                        c.occupation_mm.map_or("–".to_owned(), |v| format_fixed(v, 1)),
                        or_dash(c.error_um, 2),
                        c.note.clone(),
                    ]
                })
                .collect(),
            note: "Score: largest share of a limit that dressing corrections or centre distance use; least is best, \
                   above 1 is not allowed."
                .to_owned(),
        }));
    }
    blocks
}

fn verification(verification: &Verification) -> Vec<Block> {
    let mut blocks: Vec<Block> = verification.paragraphs.iter().cloned().map(Block::Paragraph).collect();
    if !verification.stages.is_empty() {
        blocks.push(Block::Table(Table {
            caption: "Material removal by normal rays (referee)".to_owned(),
            columns: vec![
                Column::text("Stage"),
                Column::number("Rays", ""),
                Column::number("Poses", "per ray"),
                Column::number("Own discretisation error", "µm"),
            ],
            rows: verification
                .stages
                .iter()
                .map(|s| {
                    vec![
                        s.name.clone(),
                        grouped(s.rays),
                        grouped(s.poses),
                        format_significant(s.discretisation_um, 2),
                    ]
                })
                .collect(),
            note: String::new(),
        }));
    }
    blocks
}

/// Digits in groups of three with narrow blanks.
fn grouped(count: u64) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (k, digit) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

/// The dresser in the thread space.
fn sections(report: &GeneratingReport) -> Result<Vec<Block>, ChartError> {
    let caption = "What the dresser sweeps in a plane through the worm axis, at the worm position with the least clearance of the \
        flank that is not dressed.";
    let figure = |chart: &DressingSectionChart| {
        Ok(Block::Figure(Figure::new(kebab(&chart.title), dressing_section_chart(chart)?, caption)))
    };
    report.sections.iter().map(figure).collect()
}

fn programs(report: &GeneratingReport) -> Result<Vec<Block>, ChartError> {
    report.programs.as_ref().map_or(Ok(Vec::new()), ProgramsReport::blocks)
}

fn time_and_files(report: &GeneratingReport) -> Vec<Block> {
    let mut tables = Vec::new();
    if !report.timing.is_empty() {
        let total: f64 = report.timing.iter().map(|t| t.seconds).sum();
        let row = |stage: &str, seconds: f64| vec![stage.to_owned(), format_fixed(seconds, 3)];
        let mut rows: Vec<_> = report.timing.iter().map(|t| row(&t.stage, t.seconds)).collect();
        rows.push(row("Sum", total));
        tables.push(Table {
            caption: "Time".to_owned(),
            columns: vec![Column::text("Stage"), Column::number("Time", "s")],
            rows,
            note: String::new(),
        });
    }
    if !report.files.is_empty() {
        tables.push(Table {
            caption: "Files written".to_owned(),
            columns: vec![Column::text("File"), Column::text("Content")],
            rows: report.files.iter().map(|f| vec![f.path.clone(), f.content.clone()]).collect(),
            note: String::new(),
        });
    }
    if tables.is_empty() { Vec::new() } else { vec![Block::Tables(tables)] }
}
