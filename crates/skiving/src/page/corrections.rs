//! What to change in the setting, whether the tool is worn, and when it must be reground.

use super::regrinding;
use super::spread::spread;
use crate::Setting;
use crate::workflow::{MeasurementResult, ProfileResult, SkivingOutcome};
use foundation::geometry::Flank;
use report::cells::{fixed, significant, significant_or_none, yes_no};
use report::charts::ChartError;
use report::{Block, Column, Table};

/// Changes, wear and regrinding; nothing where nothing is measured.
pub(super) fn blocks(outcome: &SkivingOutcome) -> Result<Vec<Block>, ChartError> {
    let Some(measured) = &outcome.result.measurement else { return Ok(Vec::new()) };
    let mut blocks = Vec::new();
    let changes = changes(outcome, measured)?;
    if !changes.rows.is_empty() {
        blocks.push(Block::Table(changes));
    }
    let regrinding = regrinding::quantities(&measured.resharpening, outcome.result.history.as_ref());
    let beside = vec![wear(&measured.profile)?, Table::of_quantities("Regrinding", &regrinding)];
    blocks.push(Block::Tables(beside));
    Ok(blocks)
}

/// The settings that may be changed: by how much, how exactly, within which limit.
fn changes(outcome: &SkivingOutcome, measured: &MeasurementResult) -> Result<Table, ChartError> {
    let correction = &measured.correction;
    let bodies = &outcome.prepared.bodies;
    let [distance, angle, shift, turn] = bodies.setting_limits.of;
    let (angle, turn) = (angle.to_degrees(), turn.to_degrees());
    let all = [
        (
            Setting::CentreDistance,
            "centre distance",
            "Δd",
            correction.centre_distance_um,
            "µm",
            1e3 * distance,
        ),
        (
            Setting::CrossedAxesAngle,
            "crossed-axes angle",
            "Δγ",
            correction.crossed_axes_angle_deg,
            "deg",
            angle,
        ),
        (Setting::ToolShift, "tool shift", "Δz_V1", correction.tool_shift_um, "µm", 1e3 * shift),
        (Setting::ToolAngle, "tool angle", "Δφ_1", correction.tool_angle_deg, "deg", turn),
    ];
    let free = all.into_iter().filter(|(setting, ..)| bodies.free.contains(setting));
    let row = |(_, name, symbol, change, unit, limit): (Setting, &str, &str, f64, &str, f64)| {
        let deviation = spread(&outcome.result, &format!("correction {name}"));
        Ok(vec![
            name.to_owned(),
            symbol.to_owned(),
            significant(name, change, 5)?,
            unit.to_owned(),
            significant_or_none(name, deviation, 2)?,
            significant(name, limit, 4)?,
            yes_no(correction.at_limit.contains(&name)),
        ])
    };
    let [before, after] = correction.rms_um;
    let note = format!(
        "Root mean square of the workpiece's profile deviations: {} µm before, {} µm after the changes.",
        fixed("RMS before", before, 3)?,
        fixed("RMS after", after, 3)?
    );
    Ok(Table {
        caption: "Changes of the setting".into(),
        columns: vec![
            Column::text("Quantity"),
            Column::symbols("Symbol"),
            Column::number("Change", ""),
            Column::text("Unit"),
            Column::number("Standard deviation", ""),
            Column::number("Limit ±", ""),
            Column::text("At its limit"),
        ],
        rows: free.map(row).collect::<Result<_, ChartError>>()?,
        note,
    })
}

/// The track with the least material on each flank.
fn wear(profile: &ProfileResult) -> Result<Table, ChartError> {
    let row = |flank: Flank| -> Option<Result<Vec<String>, ChartError>> {
        let means = profile.track_mean_um.get(flank.name())?;
        let (track, mean) = means.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1))?;
        let name = format!("wear of the {flank} flank");
        let cells = || {
            Ok(vec![
                flank.to_string(),
                (track + 1).to_string(),
                fixed(&name, *mean, 2)?,
                fixed(&name, -profile.wear_limit_um, 2)?,
                yes_no(profile.worn[flank.name()]),
            ])
        };
        Some(cells())
    };
    Ok(Table {
        caption: "Wear".into(),
        columns: vec![
            Column::text("Flank"),
            Column::number("Track", ""),
            Column::number("Mean of the teeth", "µm"),
            Column::number("Limit", "µm"),
            Column::text("Worn"),
        ],
        rows: Flank::BOTH.into_iter().filter_map(row).collect::<Result<_, ChartError>>()?,
        note: "The track with the least material; below zero it is missing.".into(),
    })
}
