//! Stock, strokes, load of the worm, time and cost.

use super::limit_words::limit_in_words;
use crate::workflow::removal::{
    CycleResult, CyclesResult, DressingFiguresResult, FlankRateResult, FlankRemovalResult, PartTimeResult,
    RateMapResult, RemovalResult, StrokeResult, ZoneLoadResult,
};
use foundation::geometry::{Flank, Sides};
use report::cells::NONE;
use report::charts::{
    ChartError, ContourMap, LineChart, MapFrame, MapValues, NamedTopography, Panel, Series, Topography,
    YScale, contour_map_in, format_fixed, format_significant, line_chart,
};
use report::{Block, Column, Figure, Quantity, Table};

/// The section.
///
/// # Errors
/// [`ChartError`].
pub(super) fn removal(result: &RemovalResult) -> Result<Vec<Block>, ChartError> {
    let mut blocks = vec![
        Block::Table(strokes(&result.strokes)),
        Block::Table(removed(&result.strokes, result.stock.volume_mm3)),
    ];
    blocks.push(Block::Figure(Figure::new(
        "removal-rate-over-time",
        line_chart(&rates(&result.strokes))?,
        "Each stroke from its first contact on; ways between strokes are left out.",
    )));
    for (k, stroke) in result.strokes.iter().enumerate() {
        if let Some(map) = &stroke.rate_map {
            blocks.push(Block::Figure(rate_figure(&named(k, stroke), k, map)?));
        }
    }
    if let Some(load) = &result.worm_load {
        blocks.push(Block::Table(zones(&load.zones)));
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
    if let Some(cycles) = &result.cycles {
        blocks.push(Block::Table(cycles_table(cycles)));
        blocks.push(Block::Figure(Figure::new(
            "time-over-load",
            line_chart(&time_over_load(cycles))?,
            "The fastest cycle with both limits of Q'_w multiplied by the same factor: what a harder or softer grind brings.",
        )));
    }
    if let Some(time) = &result.part_time {
        blocks.push(Block::Table(time_table(time)));
    }
    let mut tables = vec![Table::of_quantities("Worm, time and cost", &quantities(result))];
    tables.extend(
        result.dressing.map(|dressing| Table::of_quantities("Dressing", &dressing_quantities(&dressing))),
    );
    blocks.push(Block::Tables(tables));
    if !result.indicators.is_empty() {
        blocks.push(Block::Table(indicators(result)));
    }
    Ok(blocks)
}

/// Largest of a figure over both flanks.
fn most(stroke: &StrokeResult, figure: fn(&FlankRemovalResult) -> f64) -> f64 {
    stroke.flanks.iter().filter_map(|(_, flank)| flank.as_ref().map(figure)).fold(0.0, f64::max)
}

fn named(k: usize, stroke: &StrokeResult) -> String {
    format!("{} {}", k + 1, stroke.stage)
}

/// How the strokes run.
fn strokes(strokes: &[StrokeResult]) -> Table {
    let row = |(k, stroke): (usize, &StrokeResult)| {
        vec![
            named(k, stroke),
            sides(stroke.left_um, 1),
            format_fixed(most(stroke, |f| f.depth_um), 1),
            format_fixed(stroke.worm_speed_rpm, 0),
            format_fixed(stroke.feed_per_revolution_mm, 3),
            format_fixed(60.0 * stroke.feed_mm_per_s, 1),
            format!("{}, {}", stroke.direction, stroke.sense),
            format_fixed(stroke.approach_mm, 1),
            format_fixed(stroke.travel_mm, 1),
        ]
    };
    Table {
        caption: "Strokes".to_owned(),
        columns: vec![
            Column::name("Stroke"),
            Column::number("Left", "µm"),
            Column::number("Depth of cut", "µm"),
            Column::number("Worm", "1/min"),
            Column::number("Feed per rev.", "mm"),
            Column::number("Feed", "mm/min"),
            Column::name("Sense"),
            Column::number("Approach", "mm"),
            Column::number("Travel", "mm"),
        ],
        rows: strokes.iter().enumerate().map(row).collect(),
        note: String::new(),
    }
}

/// What the strokes take, and how near they come to the limits.
fn removed(strokes: &[StrokeResult], volume_mm3: f64) -> Table {
    let row = |(k, stroke): (usize, &StrokeResult)| {
        vec![
            named(k, stroke),
            format_fixed(stroke.volume_mm3, 1),
            format_fixed(stroke.largest_rate_mm3_per_s, 1),
            format_fixed(most(stroke, |f| f.specific_rate_mm3_per_mm_s), 2),
            format_fixed(most(stroke, |f| f.contact_length_mm), 1),
            stroke.nearest_limit.as_ref().map_or(NONE.to_owned(), |near| {
                format!("{:.0} % of {}", 100.0 * near.share, limit_in_words(near.limit))
            }),
        ]
    };
    Table {
        caption: "Removal rate".to_owned(),
        columns: vec![
            Column::name("Stroke"),
            Column::number("Volume", "mm³"),
            Column::number("Largest rate Q_w", "mm³/s"),
            Column::number("Largest Q'_w", "mm³/(mm s)"),
            Column::number("Contact length", "mm"),
            Column::name("Nearest limit"),
        ],
        rows: strokes.iter().enumerate().map(row).collect(),
        note: format!(
            "Stock of all spaces: {} mm³. Depth of cut, Q'_w and contact length are the largest over both flanks; the approach is the way before the contact lines on which stock is ground already.",
            format_significant(volume_mm3, 5)
        ),
    }
}

/// A value for both flanks, or one for each: left, then right.
fn sides(value: Sides<Option<f64>>, digits: usize) -> String {
    let shown = |value: Option<f64>| value.map_or(NONE.to_owned(), |value| format_fixed(value, digits));
    let Sides { left, right } = value;
    if left == right { shown(left) } else { format!("{} / {}", shown(left), shown(right)) }
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

/// Cycles within the limits, with what a job would state to have them.
fn cycles_table(cycles: &CyclesResult) -> Table {
    let row = |name: &str, cycle: &CycleResult| {
        let [rough, fine] = cycle.feed_per_revolution_mm;
        let [rate_rough, rate_fine] = cycle.specific_rate_mm3_per_mm_s;
        let of_roughing = |value: f64, digits: usize| {
            if cycle.roughing_strokes == 0 { NONE.to_owned() } else { format_fixed(value, digits) }
        };
        vec![
            name.to_owned(),
            cycle.roughing_strokes.to_string(),
            format_fixed(cycle.finishing_um, 1),
            of_roughing(rough, 3),
            format_fixed(fine, 3),
            of_roughing(rate_rough, 2),
            format_fixed(rate_fine, 2),
            format_fixed(cycle.feed_mark_um, 3),
            cycle.parts_per_dressing.map_or(NONE.to_owned(), |parts| format_fixed(parts.floor(), 0)),
            format_fixed(cycle.part_s, 1),
            cycle.cost_per_part.map_or(NONE.to_owned(), |cost| format_fixed(cost, 2)),
        ]
    };
    let mut rows = vec![row("standard", &cycles.standard), row("fastest", &cycles.fastest)];
    rows.extend(cycles.cheapest.as_ref().map(|cycle| row("cheapest", cycle)));
    for (roughing, cycle) in cycles.by_roughing_strokes.iter().enumerate() {
        let name = format!("fastest with {roughing} roughing");
        match cycle {
            Some(cycle) => rows.push(row(&name, cycle)),
            None => rows.push(vec![name, roughing.to_string(), "not within the limits".to_owned()]),
        }
    }
    let axes = if cycles.on_machine { "" } else { " No machine is named: ramps of axes are left out." };
    let dressing = if cycles.with_dressing { "" } else { " Without a limit of V'_w dressing is left out." };
    Table {
        caption: "Cycles within the limits".to_owned(),
        columns: vec![
            Column::name("Cycle"),
            Column::number("Roughing strokes", ""),
            Column::number("Finishing takes", "µm"),
            Column::number("Feed, roughing", "mm/rev"),
            Column::number("Feed, finishing", "mm/rev"),
            Column::number("Q'_w, roughing", "mm³/(mm s)"),
            Column::number("Q'_w, finishing", "mm³/(mm s)"),
            Column::number("Feed marks", "µm"),
            Column::number("Parts per dressing", ""),
            Column::number("Time of a part", "s"),
            Column::number("Cost of a part", ""),
        ],
        rows,
        note: format!(
            "Roughing strokes of equal depth and one finishing stroke on {} µm of stock, every feed at its limit. Parts per dressing: if the width is used at its best. `technology.cycle` takes the standard, the fastest or the cheapest, `technology.strokes` any other.{axes}{dressing}",
            format_significant(cycles.stock_um, 4)
        ),
    }
}

fn time_over_load(cycles: &CyclesResult) -> LineChart {
    let at = |of: &dyn Fn(&CycleResult) -> Option<f64>| -> (Vec<f64>, Vec<f64>) {
        let each = cycles.by_load.iter().filter_map(|cycle| Some((cycle.limit_factor, of(cycle)?)));
        each.unzip()
    };
    let panel = |y_title: &str, name: &str, of: &dyn Fn(&CycleResult) -> Option<f64>| {
        let (x, y) = at(of);
        Panel {
            y_title: y_title.to_owned(),
            least_span: 0.0,
            scale: YScale::Linear,
            series: vec![Series::new(name, x, y)],
        }
    };
    let mut panels = vec![panel("Part [s]", "time of a part", &|cycle| Some(cycle.part_s))];
    if cycles.with_dressing {
        panels.push(panel("Parts", "parts per dressing", &|cycle| cycle.parts_per_dressing));
    }
    LineChart {
        title: "Time over load".to_owned(),
        x_title: "Factor on the limits of Q'_w".to_owned(),
        panels,
    }
}

/// Where the time of a part goes.
fn time_table(time: &PartTimeResult) -> Table {
    let row = |name: &str, seconds: f64| {
        vec![name.to_owned(), format_fixed(seconds, 2), format_fixed(100.0 * seconds / time.part_s, 1)]
    };
    let by_law = time.grinding_by_law_s.map_or(String::new(), |seconds| {
        format!(" By the law of moves from rest to rest grinding takes {} s.", format_fixed(seconds, 2))
    });
    Table {
        caption: "Time of a part".to_owned(),
        columns: vec![Column::text("Part of it"), Column::number("Time", "s"), Column::number("Share", "%")],
        rows: vec![
            row("Grinding", time.grinding_s),
            row("Dressing, share of a part", time.dressing_per_part_s),
            row("Loading, indexing and other", time.auxiliary_s),
            row("All", time.part_s),
        ],
        note: format!("Grinding and dressing as the proven programs take it.{by_law}"),
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
        found.push(number("One dressing", "", time.dressing_s, "s"));
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

/// The last dressing stroke.
fn dressing_quantities(dressing: &DressingFiguresResult) -> Vec<Quantity> {
    let number = Quantity::number;
    let mut found = vec![
        Quantity::count("Dressing strokes of a flank", "", dressing.strokes as i64),
        Quantity::count("Flanks dressed at a time", "", dressing.flanks_at_a_time as i64),
        number("Depth of the last dressing stroke, normal", "", dressing.depth_um, "µm"),
        number("Speed of the worm", "", dressing.worm_speed_rpm, "1/min"),
        number("Speed of the dresser", "", dressing.dresser_speed_rpm, "1/min"),
        number("Speed ratio, > 0 in the same sense", "q_d", dressing.speed_ratio, ""),
        number("Traverse per revolution of the worm", "", dressing.traverse_per_worm_revolution_mm, "mm"),
        number("Thread per revolution of the dresser", "", dressing.thread_per_dresser_revolution_mm, "mm"),
        number("Contact length along the thread", "", dressing.contact_length_mm, "mm"),
        number("Overlap", "U_d", dressing.overlap, ""),
    ];
    if let Some(parts) = dressing.parts_per_dresser {
        found.push(Quantity::count("Parts per dresser", "", parts as i64));
    }
    found
}

/// Areas of the worm, and how wide they are in balance.
fn zones(zones: &[ZoneLoadResult]) -> Table {
    let row = |zone: &ZoneLoadResult| {
        let [from, to] = zone.used_mm;
        vec![
            zone.zone.clone(),
            format_significant(zone.per_part_mm3, 4),
            format_significant(zone.allowed_mm3_per_mm, 4),
            format_fixed(from, 1),
            format_fixed(to, 1),
            format_fixed(zone.balanced_width_mm, 1),
        ]
    };
    Table {
        caption: "Areas of the worm".to_owned(),
        columns: vec![
            Column::name("Area of the worm"),
            Column::number("Removed for a part", "mm³"),
            Column::number("Allowed V'_w", "mm³/mm"),
            Column::number("Used from", "mm"),
            Column::number("Used to", "mm"),
            Column::number("Width in balance", "mm"),
        ],
        rows: zones.iter().map(row).collect(),
        note: "Used: by the strokes of the first part. In balance all areas last equally long within the width of the worm."
            .to_owned(),
    }
}

/// Unit of Q'_w.
const UNIT: &str = "mm³/(mm s)";

/// Q'_w over flank and feed.
fn rate_figure(name: &str, k: usize, map: &RateMapResult) -> Result<Figure, ChartError> {
    let panel = |(flank, rate): (Flank, &FlankRateResult)| {
        let values = rate.specific_rate_mm3_per_mm_s.clone();
        let topography = Topography::new(rate.diameter_mm.clone(), map.feed_mm.clone(), values)?;
        Ok(NamedTopography::new(flank.name(), topography))
    };
    let ground = map.flanks.iter().filter_map(|(flank, rate)| Some((flank, rate.as_ref()?)));
    let chart = ContourMap {
        title: format!("Specific removal rate [mm³/(mm s)], stroke {name}"),
        quantity: "Q'_w".to_owned(),
        panels: ground.map(panel).collect::<Result<_, ChartError>>()?,
        scale: None,
    };
    let frame = MapFrame {
        titles: ["Feed z_V2 [mm]".to_owned(), "Diameter [mm]".to_owned()],
        marks: Vec::new(),
        values: MapValues::Quantity(UNIT.to_owned()),
    };
    Ok(Figure::new(
        format!("specific-removal-rate-{}", k + 1),
        contour_map_in(&chart, &frame)?,
        "Per millimetre of the worm's active profile, the largest over the tooth spaces.",
    ))
}

fn indicators(result: &RemovalResult) -> Table {
    let rows = result.indicators.iter().map(|indicator| {
        vec![
            limit_in_words(indicator.limit),
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
