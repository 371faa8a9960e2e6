//! Characteristic values of the traces, flanks as surfaces, twist, pitches and classes.

use crate::workflow::{
    ArealResult, ClassResult, GearInspectionResult, PitchInspectionResult, SummaryResult, TwistResult,
    class_in_words,
};
use report::cells::{fixed, fixed_or_none};
use report::charts::{ChartError, format_fixed};
use report::{Block, Column, Table};
use std::collections::BTreeMap;

pub(super) fn blocks(result: &GearInspectionResult) -> Result<Vec<Block>, ChartError> {
    let mut blocks = Vec::new();
    if !result.summary.is_empty() {
        blocks.push(Block::Table(lines_table(&result.summary, result.section)?));
    }
    if !result.areal.is_empty() {
        blocks.push(Block::Table(areal_table(&result.areal)?));
    }
    if !result.twist.is_empty() {
        blocks.push(Block::Table(twist_table(&result.twist)?));
    }
    let mut beside = Vec::new();
    if !result.pitch.is_empty() {
        beside.push(pitch_table(&result.pitch)?);
    }
    if !result.classes.is_empty() {
        beside.push(classes_table(&result.classes)?);
    }
    if !beside.is_empty() {
        blocks.push(Block::Tables(beside));
    }
    blocks.extend(remarks(result).into_iter().map(Block::Paragraph));
    Ok(blocks)
}

/// Mean and range over the teeth, the characteristics of a line and flank after each other.
fn lines_table(summary: &[SummaryResult], section: &str) -> Result<Table, ChartError> {
    let mut rows = Vec::new();
    // A line has the number of teeth of its first characteristic.
    let (mut line, mut teeth) = (String::new(), 0);
    for row in summary {
        let tag = if row.tag.is_empty() { String::new() } else { format!(" {}", row.tag) };
        let name = format!("{}, {}{tag}", row.kind, row.flank);
        if name != line {
            (line, teeth) = (name, row.teeth);
        }
        let symbol = symbol(row);
        rows.push(vec![
            line.clone(),
            symbol.clone(),
            teeth.to_string(),
            fixed(&symbol, row.mean_um, 2)?,
            fixed_or_none(&symbol, row.range_um, 2)?,
        ]);
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
        note: format!("Deviations are those of the {section} section."),
    })
}

fn symbol(row: &SummaryResult) -> String {
    let of = if row.kind == "profile" { "α" } else { "β" };
    match row.characteristic {
        "fH" => format!("f_H{of}"),
        "F" => format!("F_{of}"),
        "ff" => format!("f_f{of}"),
        "C" => format!("C_{of}"),
        "fKo" => "f_Ko".to_owned(),
        other => other.to_owned(),
    }
}

fn areal_table(areal: &BTreeMap<&str, ArealResult>) -> Result<Table, ChartError> {
    let row = |(flank, of): (&&str, &ArealResult)| {
        let values = [
            Some(of.profile_slope_um),
            Some(of.profile_crowning_um),
            Some(of.helix_slope_um),
            Some(of.helix_crowning_um),
            of.twist_um,
            Some(of.rest_rms_um),
        ];
        let values = values.into_iter().map(|value| fixed_or_none("feature", value, 2));
        std::iter::once(Ok((*flank).to_owned())).chain(values).collect::<Result<Vec<String>, ChartError>>()
    };
    let mut columns = vec![Column::name("Flank")];
    let symbols = ["f_Hα", "C_α", "f_Hβ", "C_β", "S", "rest rms"];
    let surfaces: Vec<String> =
        areal.iter().map(|(flank, of)| format!("Flank {flank}: {}.", surface(of))).collect();
    columns.extend(symbols.map(|symbol| Column::number(symbol, "µm")));
    Ok(Table {
        caption: "Flanks as surfaces, mean of the teeth".into(),
        columns,
        rows: areal.iter().map(row).collect::<Result<_, ChartError>>()?,
        note: format!(
            "Normal to the flank; slope of the profile + = material rising to the tip, of the helix + = material rising to +z. Between \
             the lines the surface is reconstructed and was not measured. {}",
            surfaces.join(" ")
        ),
    })
}

/// What a surface was made of, in words.
fn surface(of: &ArealResult) -> String {
    of.outside_traces.iter().fold(of.surface.clone(), |text, (along, share)| {
        text + &format!("; {:.0} % beyond the lines by {along}", 100.0 * share)
    })
}

fn twist_table(twist: &[TwistResult]) -> Result<Table, ChartError> {
    let row = |of: &TwistResult| {
        let values = [of.by_profiles_um, of.by_leads_um, of.difference_um];
        let values = values.into_iter().map(|value| fixed_or_none("S", value, 2));
        std::iter::once(Ok(format!("{}, {}", of.tooth, of.flank)))
            .chain(values)
            .collect::<Result<Vec<String>, ChartError>>()
    };
    Ok(Table {
        caption: "Twist S by the outer lines".into(),
        columns: vec![
            Column::name("Tooth, flank"),
            Column::number("by profiles", "µm"),
            Column::number("by helix traces", "µm"),
            Column::number("difference", "µm"),
        ],
        rows: twist.iter().map(row).collect::<Result<_, ChartError>>()?,
        note: "Transverse section. A bilinear twist is the same by both; the difference is what is none."
            .into(),
    })
}

fn pitch_table(pitch: &BTreeMap<&str, PitchInspectionResult>) -> Result<Table, ChartError> {
    let row = |(flank, of): (&&str, &PitchInspectionResult)| {
        let values = [of.single_um, of.neighbours_um, of.range_um, of.total_um];
        let values = values.into_iter().map(|value| fixed("pitch", value, 2));
        std::iter::once(Ok((*flank).to_owned())).chain(values).collect::<Result<Vec<String>, ChartError>>()
    };
    let mut columns = vec![Column::name("Flank")];
    columns.extend(["f_p", "f_u", "R_p", "F_p"].map(|symbol| Column::number(symbol, "µm")));
    Ok(Table {
        caption: "Pitch".into(),
        columns,
        rows: pitch.iter().map(row).collect::<Result<_, ChartError>>()?,
        note: String::new(),
    })
}

fn classes_table(classes: &[ClassResult]) -> Result<Table, ChartError> {
    let row = |class: &ClassResult| {
        let symbol = match class.flank {
            Some(flank) => format!("{}, {flank}", class.quantity),
            None => class.quantity.to_owned(),
        };
        Ok(vec![symbol.clone(), fixed(&symbol, class.value_um, 2)?, class_in_words(class.class)])
    };
    Ok(Table {
        caption: "Classes of ISO 1328-1:2013".into(),
        columns: vec![
            Column::symbols("Quantity"),
            Column::number("Value", "µm"),
            Column::number("Class", ""),
        ],
        rows: classes.iter().map(row).collect::<Result<_, ChartError>>()?,
        note: String::new(),
    })
}

/// What else was evaluated, in sentences.
fn remarks(result: &GearInspectionResult) -> Vec<String> {
    let mut remarks = Vec::new();
    if !result.stated.is_empty() {
        remarks.push(format!("Stated about the measurement: {}.", result.stated.join("; ")));
    }
    let um = |value: f64| format_fixed(value, 2);
    if let Some(run_out) = result.run_out_um {
        remarks.push(format!("Run-out F_r {} µm from the pitches.", um(run_out)));
    }
    if let Some([amount, direction]) = result.eccentricity {
        remarks.push(format!("Eccentricity {} µm at {}°.", um(amount), format_fixed(direction, 1)));
    }
    if !result.printed.is_empty() {
        remarks.push(format!(
            "{} of the {} values that the measuring machine printed were evaluated here too; the largest difference is {} µm.",
            result.printed.len(),
            result.printed_values,
            format_fixed(result.printed_difference_um, 3)
        ));
    }
    remarks
}
