//! The first page: what profile the tool will make, its pitch and mounting, the setting, the tool, times.

use crate::workflow::{SkivingOutcome, SkivingResult};
use foundation::geometry::Flank;
use report::cells::flank_title;
use report::charts::{format_fixed, format_significant};
use report::{Column, FirstPage, Quantity, Section, Sheet, Table};

pub(super) fn first_page(outcome: &SkivingOutcome, sections: &[Section]) -> FirstPage {
    let result = &outcome.result;
    FirstPage {
        scope: result.verdict.scope_in_short(),
        picture: FirstPage::picture_of(sections, "profile-of-the-workpiece"),
        values: Some(values(result)),
        sheets: vec![setting(outcome), tool(outcome), measured(result), times(result)],
    }
}

fn values(result: &SkivingResult) -> Table {
    let rows = Flank::BOTH.into_iter().filter_map(|flank| {
        let of = result.flanks.get(flank.name())?;
        let ends = of.teeth_um.iter().copied().reduce(|[a, b], [c, d]| [a.min(c), b.max(d)]);
        let [least, greatest] = ends.unwrap_or([0.0, 0.0]);
        Some(vec![
            flank_title(flank).to_owned(),
            format_significant(result.tolerance_um, 4),
            format_fixed(of.max_deviation_um, 2),
            format_fixed(of.rms_deviation_um, 2),
            format_fixed(least, 2),
            format_fixed(greatest, 2),
        ])
    });
    Table {
        caption: "Profile of the workpiece to come, deviation from the target".to_owned(),
        columns: vec![
            Column::name("Flank"),
            Column::number("Tolerance", "µm"),
            Column::number("Largest", "µm"),
            Column::number("Rms", "µm"),
            Column::number("Least tooth", "µm"),
            Column::number("Greatest tooth", "µm"),
        ],
        rows: rows.collect(),
        note: "Normal to the flank, positive: material left. Least and greatest: over the single teeth of the tool.".to_owned(),
    }
}

fn setting(outcome: &SkivingOutcome) -> Sheet {
    let settings = &outcome.result.settings;
    let list = vec![
        Quantity::rounded("centre distance", "a", settings.centre_distance_mm, 4, "mm"),
        Quantity::rounded("crossed-axes angle", "Σ", settings.crossed_axes_angle_deg, 4, "deg"),
        Quantity::rounded("tool shift", "z_V1", settings.tool_shift_mm, 4, "mm"),
        Quantity::rounded("workpiece angle per tool angle", "i_21", settings.ratio, 6, ""),
    ];
    let mut sheet = Sheet::new("Machine settings", list);
    if let Some(measured) = &outcome.result.measurement {
        let [x, y] = measured.mounting.eccentricity_um;
        sheet.quantities.push(Quantity::rounded("eccentricity of the tool", "e", x.hypot(y), 2, "µm"));
        sheet.quantities.push(Quantity::rounded("clocking of the tool", "", measured.clocking_deg, 5, "deg"));
    }
    sheet.remark("Speeds and feed: not given, the job measures the tool and does not cut.")
}

fn tool(outcome: &SkivingOutcome) -> Sheet {
    let (tool, gear) = (&outcome.prepared.drawn.tool, &outcome.prepared.drawn.gear);
    Sheet::new(
        "Tool and workpiece",
        vec![
            Quantity::count("teeth of the tool", "z_0", i64::from(tool.teeth)),
            Quantity::rounded("helix angle of the tool", "β_0", tool.helix_angle_deg, 4, "deg"),
            Quantity::rounded(
                "pitch diameter of the tool",
                "d_0",
                2.0 * outcome.result.settings.tool_pitch_radius_mm,
                3,
                "mm",
            ),
            Quantity::count("teeth of the workpiece", "z_2", i64::from(gear.teeth)),
            Quantity::rounded("normal module", "m_n", gear.normal_module, 4, "mm"),
            Quantity::rounded("helix angle of the workpiece", "β_2", gear.helix_angle_deg, 4, "deg"),
        ],
    )
}

fn measured(result: &SkivingResult) -> Sheet {
    let sheet = Sheet::new("Measured tool", Vec::new());
    let Some(measured) = &result.measurement else {
        return sheet.remark("Nothing has been measured yet.");
    };
    let um = |name: &str, symbol: &str, value: f64| Quantity::rounded(name, symbol, value, 2, "µm");
    let [before, after] = measured.correction.rms_um;
    Sheet::new(
        "Measured tool",
        vec![
            um("total pitch deviation", "F_p", measured.pitch.total_um),
            um("largest single pitch deviation", "f_p", measured.pitch.largest_single_um),
            um("profile rms", "", before),
            um("profile rms, after correction", "", after),
            Quantity::rounded("depth to grind off again", "", measured.resharpening.depth_mm, 3, "mm"),
        ],
    )
}

fn times(result: &SkivingResult) -> Sheet {
    let mut list = vec![Quantity::rounded("measuring", "", result.measuring_time_s, 0, "s")];
    list.extend(
        result.programs.first().map(|one| Quantity::rounded("measuring program", "", one.duration_s, 0, "s")),
    );
    Sheet::new("Times", list)
}
