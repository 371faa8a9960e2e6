//! Stock, strokes, load of the worm, time and cost.

use crate::workflow::removal::{RemovalResult, StrokeResult};
use report::charts::{
    ChartError, LineChart, Panel, Series, YScale, format_fixed, format_significant, line_chart,
};
use report::{Block, Column, Figure, Quantity, Table};

/// The section.
///
/// # Errors
/// [`ChartError`].
pub(super) fn removal(result: &RemovalResult) -> Result<Vec<Block>, ChartError> {
    let mut blocks = vec![Block::Table(strokes(&result.strokes, result.stock.volume_mm3))];
    blocks.push(Block::Figure(Figure::new(
        "removal-rate-over-time",
        line_chart(&rates(&result.strokes))?,
        "Each stroke from its first contact on; ways between strokes are left out.",
    )));
    if let Some(load) = &result.worm_load {
        let caption = format!(
            "What each millimetre of the worm's width has removed, the largest over the profile; parts between two dressings: {}.",
            load.parts_per_dressing
        );
        let place = |k: usize| load.from_mm + k as f64 + 0.5;
        let series = |name: &str, values: &[f64]| {
            Series::new(name, (0..values.len()).map(place).collect(), values.to_vec())
        };
        let removed = &load.removed_mm3_per_mm;
        let chart = LineChart {
            title: "Load of the worm".to_owned(),
            x_title: "Place on the worm z_1 [mm]".to_owned(),
            panels: vec![Panel {
                y_title: "Removed volume [mm³/mm]".to_owned(),
                least_span: 0.0,
                scale: YScale::Linear,
                series: vec![series("left", &removed.left), series("right", &removed.right)],
            }],
        };
        blocks.push(Block::Figure(Figure::new("load-of-the-worm", line_chart(&chart)?, &caption)));
    }
    blocks.push(Block::Tables(vec![Table::of_quantities("Worm, time and cost", &quantities(result))]));
    if !result.indicators.is_empty() {
        blocks.push(Block::Table(indicators(result)));
    }
    Ok(blocks)
}

fn strokes(strokes: &[StrokeResult], volume_mm3: f64) -> Table {
    let row = |(k, stroke): (usize, &StrokeResult)| {
        let most = |figure: fn(&crate::workflow::removal::FlankRemovalResult) -> f64| {
            figure(&stroke.flanks.left).max(figure(&stroke.flanks.right))
        };
        vec![
            format!("{} {}", k + 1, stroke.stage),
            format_fixed(stroke.left_um, 1),
            format_fixed(most(|f| f.depth_um), 1),
            format_fixed(stroke.worm_speed_rpm, 0),
            format_fixed(stroke.feed_mm_per_s, 3),
            stroke.sense.to_owned(),
            format_fixed(stroke.approach_mm, 1),
            format_fixed(stroke.travel_mm, 1),
            format_fixed(stroke.volume_mm3, 1),
            format_fixed(stroke.largest_rate_mm3_per_s, 1),
            format_fixed(most(|f| f.specific_rate_mm3_per_mm_s), 2),
            format_fixed(most(|f| f.contact_length_mm), 1),
        ]
    };
    Table {
        caption: "Strokes".to_owned(),
        columns: vec![
            Column::text("Stroke"),
            Column::number("Left", "µm"),
            Column::number("Depth of cut", "µm"),
            Column::number("Worm", "1/min"),
            Column::number("Feed", "mm/s"),
            Column::text("Sense"),
            Column::number("Approach", "mm"),
            Column::number("Travel", "mm"),
            Column::number("Volume", "mm³"),
            Column::number("Largest rate Q_w", "mm³/s"),
            Column::number("Largest Q'_w", "mm³/(mm s)"),
            Column::number("Contact length", "mm"),
        ],
        rows: strokes.iter().enumerate().map(row).collect(),
        note: format!(
            "Stock of all spaces: {} mm³. Depth of cut, Q'_w and contact length are the largest over both flanks; the approach is the way before the contact lines on which stock is ground already.",
            format_significant(volume_mm3, 5)
        ),
    }
}

fn rates(strokes: &[StrokeResult]) -> LineChart {
    let mut begun = 0.0;
    let mut series = Vec::new();
    for (k, stroke) in strokes.iter().enumerate() {
        let times: Vec<f64> = stroke.time_s.iter().map(|time| begun + time).collect();
        begun = times.last().copied().unwrap_or(begun);
        series.push(Series::new(format!("{} {}", k + 1, stroke.stage), times, stroke.rate_mm3_per_s.clone()));
    }
    LineChart {
        title: "Removal rate".to_owned(),
        x_title: "Time in contact [s]".to_owned(),
        panels: vec![Panel {
            y_title: "Q_w [mm³/s]".to_owned(),
            least_span: 0.0,
            scale: YScale::Linear,
            series,
        }],
    }
}

fn quantities(result: &RemovalResult) -> Vec<Quantity> {
    let number = Quantity::number;
    let mut found = vec![number("Stock of all spaces", "", result.stock.volume_mm3, "mm³")];
    if let Some(load) = &result.worm_load {
        found.push(Quantity::count("Parts per dressing", "", load.parts_per_dressing as i64));
        found.push(number("Parts if the width were used at its best", "", load.parts_by_load, ""));
    }
    if let Some(life) = &result.worm_life {
        found.push(Quantity::count("Dressings per worm", "", life.dressings as i64));
        found.push(Quantity::count("Parts per worm", "", life.parts_per_worm as i64));
    }
    if let Some(time) = &result.part_time {
        found.push(number("Grinding", "", time.grinding_s, "s"));
        found.push(number("Dressing", "", time.dressing_s, "s"));
        found.push(number("Dressing, share of a part", "", time.dressing_per_part_s, "s"));
        found.push(number("Beside grinding", "", time.auxiliary_s, "s"));
        found.push(number("Part", "", time.part_s, "s"));
    }
    if let Some(cost) = &result.cost_per_part {
        found.push(number("Cost of the machine", "", cost.machine, ""));
        found.push(number("Cost of the worm", "", cost.worm, ""));
        found.push(number("Cost of the dresser", "", cost.dresser, ""));
        found.push(number("Cost of changing the worm", "", cost.change, ""));
        found.push(number("Cost per part", "", cost.total, ""));
    }
    found
}

fn indicators(result: &RemovalResult) -> Table {
    let rows = result.indicators.iter().map(|indicator| {
        vec![
            indicator.limit.to_owned(),
            format_fixed(indicator.value, 2),
            format_significant(indicator.allowed, 5),
            format_fixed(indicator.share, 2),
        ]
    });
    Table {
        caption: "Figures over the shop's limits".to_owned(),
        columns: vec![
            Column::text("Limit"),
            Column::number("Largest", ""),
            Column::number("Allowed", ""),
            Column::number("Share", ""),
        ],
        rows: rows.collect(),
        note: "The limits are the shop's own (grit, coolant, steel, dressing): a share above 1 says harder than what it calls safe, not burnt. No temperature is given."
            .to_owned(),
    }
}
