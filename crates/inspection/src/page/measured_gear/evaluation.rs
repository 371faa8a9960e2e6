//! Characteristic values of the traces, pitches and classes.

use report::cells::{fixed, fixed_or_none};
use report::charts::ChartError;
use report::data::{Block, Column, Table};

/// Evaluation to ISO 1328-1.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EvaluationView {
    /// Section in which the file counts.
    pub section: String,
    /// Mean and range over the teeth, a row for each line and flank.
    pub lines: Vec<LineRow>,
    /// Features of the flanks as surfaces.
    pub areal: Vec<ArealRow>,
    /// Twist of each tooth flank.
    pub twist: Vec<TwistRow>,
    /// Pitches.
    pub pitch: Vec<PitchRow>,
    /// Classes.
    pub classes: Vec<ClassRow>,
    /// What else was evaluated, in sentences.
    pub remarks: Vec<String>,
}

/// A line of a flank.
#[derive(Clone, Debug, PartialEq)]
pub struct LineRow {
    /// Name, for example "profile, left".
    pub name: String,
    /// Symbol, mean and range of each characteristic; no range with one tooth.
    pub values: Vec<(String, f64, Option<f64>)>,
    /// Teeth.
    pub teeth: usize,
}

/// A flank as a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct ArealRow {
    /// Flank.
    pub flank: String,
    /// What the surface was made of.
    pub surface: String,
    /// f_Ha, C_a, f_Hb, C_b, S, rest rms; no twist where the lines do not tell it.
    pub values_um: [Option<f64>; 6],
}

/// Twist of a tooth flank.
#[derive(Clone, Debug, PartialEq)]
pub struct TwistRow {
    /// Tooth and flank, for example "1, left".
    pub name: String,
    /// By profiles, by helix traces, their difference.
    pub values_um: [Option<f64>; 3],
}

/// Pitches of a flank.
#[derive(Clone, Debug, PartialEq)]
pub struct PitchRow {
    /// Flank.
    pub flank: String,
    /// f_p, f_u, R_p, F_p.
    pub values_um: [f64; 4],
}

/// The class of a value.
#[derive(Clone, Debug, PartialEq)]
pub struct ClassRow {
    /// Symbol.
    pub symbol: String,
    /// Value.
    pub value_um: f64,
    /// Class; none beyond the last.
    pub class: Option<i32>,
}

impl EvaluationView {
    pub(super) fn blocks(&self) -> Result<Vec<Block>, ChartError> {
        let mut blocks = Vec::new();
        if !self.lines.is_empty() {
            blocks.push(Block::Table(self.lines_table()?));
        }
        if !self.areal.is_empty() {
            blocks.push(Block::Table(self.areal_table()?));
        }
        if !self.twist.is_empty() {
            blocks.push(Block::Table(self.twist_table()?));
        }
        let mut beside = Vec::new();
        if !self.pitch.is_empty() {
            beside.push(self.pitch_table()?);
        }
        if !self.classes.is_empty() {
            beside.push(self.classes_table()?);
        }
        if !beside.is_empty() {
            blocks.push(Block::Tables(beside));
        }
        blocks.extend(self.remarks.iter().map(|text| Block::Paragraph(text.clone())));
        Ok(blocks)
    }

    fn lines_table(&self) -> Result<Table, ChartError> {
        let mut rows = Vec::new();
        for line in &self.lines {
            for (symbol, mean, range) in &line.values {
                rows.push(vec![
                    line.name.clone(),
                    symbol.clone(),
                    line.teeth.to_string(),
                    fixed(symbol, *mean, 2)?,
                    fixed_or_none(symbol, *range, 2)?,
                ]);
            }
        }
        Ok(Table {
            caption: "Characteristic values of the traces".into(),
            columns: vec![
                Column::name("Line"),
                Column::symbols("Characteristic"),
                Column::number("Teeth", ""),
                Column::number("Mean", "µm"),
                Column::number("Range", "µm"),
            ],
            rows,
            note: format!("{} section.", self.section),
        })
    }

    fn areal_table(&self) -> Result<Table, ChartError> {
        let row = |of: &ArealRow| {
            let values = of.values_um.iter().map(|value| fixed_or_none("feature", *value, 2));
            std::iter::once(Ok(of.flank.clone())).chain(values).collect::<Result<Vec<String>, ChartError>>()
        };
        let mut columns = vec![Column::name("Flank")];
        let symbols = ["f_Hα", "C_α", "f_Hβ", "C_β", "S", "rest rms"];
        let surfaces: Vec<String> =
            self.areal.iter().map(|of| format!("Flank {}: {}.", of.flank, of.surface)).collect();
        columns.extend(symbols.map(|symbol| Column::number(symbol, "µm")));
        Ok(Table {
            caption: "Flanks as surfaces, mean of the teeth".into(),
            columns,
            rows: self.areal.iter().map(row).collect::<Result<_, ChartError>>()?,
            note: format!(
                "Normal to the flank; slope of the profile + = material rising to the tip, of the helix + = material rising to +z. Between \
                 the lines the surface is reconstructed and was not measured. {}",
                surfaces.join(" ")
            ),
        })
    }

    fn twist_table(&self) -> Result<Table, ChartError> {
        let row = |of: &TwistRow| {
            let values = of.values_um.iter().map(|value| fixed_or_none("S", *value, 2));
            std::iter::once(Ok(of.name.clone())).chain(values).collect::<Result<Vec<String>, ChartError>>()
        };
        Ok(Table {
            caption: "Twist S by the outer lines".into(),
            columns: vec![
                Column::name("Tooth, flank"),
                Column::number("by profiles", "µm"),
                Column::number("by helix traces", "µm"),
                Column::number("difference", "µm"),
            ],
            rows: self.twist.iter().map(row).collect::<Result<_, ChartError>>()?,
            note: "Transverse section. A bilinear twist is the same by both; the difference is what is none."
                .into(),
        })
    }

    fn pitch_table(&self) -> Result<Table, ChartError> {
        let row = |pitch: &PitchRow| {
            let values = pitch.values_um.iter().map(|value| fixed("pitch", *value, 2));
            std::iter::once(Ok(pitch.flank.clone()))
                .chain(values)
                .collect::<Result<Vec<String>, ChartError>>()
        };
        let mut columns = vec![Column::name("Flank")];
        columns.extend(["f_p", "f_u", "R_p", "F_p"].map(|symbol| Column::number(symbol, "µm")));
        Ok(Table {
            caption: "Pitch".into(),
            columns,
            rows: self.pitch.iter().map(row).collect::<Result<_, ChartError>>()?,
            note: String::new(),
        })
    }

    fn classes_table(&self) -> Result<Table, ChartError> {
        let row = |class: &ClassRow| {
            Ok(vec![
                class.symbol.clone(),
                fixed(&class.symbol, class.value_um, 2)?,
                class.class.map_or_else(|| "worse than 11".into(), |class| class.to_string()),
            ])
        };
        Ok(Table {
            caption: "Classes of ISO 1328-1:2013".into(),
            columns: vec![
                Column::symbols("Quantity"),
                Column::number("Value", "µm"),
                Column::number("Class", ""),
            ],
            rows: self.classes.iter().map(row).collect::<Result<_, ChartError>>()?,
            note: String::new(),
        })
    }
}
