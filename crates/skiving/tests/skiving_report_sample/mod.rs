//! A measured skiving tool as the page takes it: 41 teeth, five tracks, one outlier tooth. Made up, but as large as real ones.

use foundation::geometry::{Flank, Sides};
use report::{Quantity, ReportHead, Warning};
use skiving::page::{
    AngleEdge, AngleStation, AngleTrack, AngleView, ConventionalRow, CorrectionsView, DataSheet,
    EdgeSectionView, FlankDeviations, FlankProfile, HistoryRow, HistoryView, MeasuredView, MonteCarloRow,
    MonteCarloView, PitchView, PoseRow, ProfileView, ProgramRow, ProgramsView, SettingChange, SkivingReport,
    StripView, ToothMark, ToothSignal, ToothView, TrackDeviations, UncertainFigure, WearRow, WearTrend,
    WorstTooth,
};
use std::f64::consts::TAU;
use verdict::Status;

pub const TEETH: usize = 41;
pub const PLACES: [f64; 5] = [-0.8, -0.4, 0.0, 0.4, 0.8];
/// The outlier tooth, on the right flank.
pub const OUTLIER: usize = 6;
/// A tooth that leaves the beam light.
pub const BROKEN: usize = 18;
const BASE: f64 = 38.527;
const BAND: f64 = 12.0;

/// Repeatable, between -1 and 1.
fn noise(seed: usize) -> f64 {
    let mixed =
        (seed as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15).rotate_left(29).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    (mixed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

fn radius(place: f64) -> f64 {
    41.2 + 1.85 * place
}

/// Angle of an edge about the middle of its tooth, deg; the left flank's edge lies at negative angles.
fn nominal(flank: Flank, radius: f64) -> f64 {
    let inv = |cos: f64| {
        let angle = cos.acos();
        angle.tan() - angle
    };
    let half = 0.25 * TAU / 41.0 + inv(BASE / 41.0) - inv(BASE / radius);
    -flank.sign() * half.to_degrees()
}

fn curve(flank: Flank, x: f64) -> f64 {
    -0.9 + 1.2 * flank.sign() * x - 1.4 * x * x
}

fn remaining(flank: Flank, x: f64, tooth: usize) -> f64 {
    let own = 2.6 * noise(17 * tooth + 5 + usize::from(flank == Flank::Right));
    let outlier = if flank == Flank::Right && tooth == OUTLIER { 9.0 - 3.0 * x } else { 0.0 };
    curve(flank, x) + own + 0.5 * noise(1000 + 31 * tooth + (50.0 * (x + 1.0)) as usize) + outlier
}

fn mounting(flank: Flank, tooth: usize) -> f64 {
    let angle = TAU * tooth as f64 / TEETH as f64;
    9.0 * (angle + 0.6 - 1.2 * flank.sign()).cos()
}

fn measured() -> MeasuredView {
    let track = |flank: Flank, place: f64| TrackDeviations {
        place,
        curve_um: curve(flank, place),
        measured_um: (0..TEETH).map(|k| remaining(flank, place, k) + mounting(flank, k)).collect(),
        remaining_um: (0..TEETH).map(|k| remaining(flank, place, k)).collect(),
    };
    MeasuredView {
        flanks: Sides::from_fn(|flank| FlankDeviations {
            tracks: PLACES.map(|place| track(flank, place)).to_vec(),
        }),
        band_um: Some(BAND),
        worst: vec![
            WorstTooth {
                tooth: OUTLIER,
                flank: Some(Flank::Right),
                track: Some(1),
                from_curve_um: Some(remaining(Flank::Right, -0.8, OUTLIER) - curve(Flank::Right, -0.8)),
                why: "out of the band; left out of the mounting fit".into(),
            },
            WorstTooth {
                tooth: 26,
                flank: Some(Flank::Left),
                track: Some(4),
                from_curve_um: Some(remaining(Flank::Left, 0.4, 26) - curve(Flank::Left, 0.4)),
                why: "largest on its flank".into(),
            },
        ],
    }
}

fn degrees(um: f64) -> f64 {
    (1e-3 * um / BASE).to_degrees()
}

fn angles(tooth: usize) -> AngleView {
    let edge = |flank: Flank| {
        let station = |k: usize| {
            let x = -1.0 + k as f64 / 20.0;
            let radius_mm = radius(x);
            AngleStation {
                radius_mm,
                nominal_deg: nominal(flank, radius_mm),
                curve_deg: Some(-flank.sign() * degrees(curve(flank, x))),
                half_band_deg: Some(degrees(0.5 * BAND)),
            }
        };
        let track = |place: f64| {
            let radius_mm = radius(place);
            let nominal_deg = nominal(flank, radius_mm);
            let off = -flank.sign() * degrees(remaining(flank, place, tooth));
            AngleTrack { radius_mm, nominal_deg, measured_deg: Some(nominal_deg + off) }
        };
        AngleEdge { stations: (0..41).map(station).collect(), tracks: PLACES.map(track).to_vec() }
    };
    AngleView { tooth, band_um: Some(BAND), edges: Sides::from_fn(edge) }
}

fn strip() -> StripView {
    let pitch = 360.0 / TEETH as f64;
    let tooth = |k: usize| {
        let middle_deg = k as f64 * pitch;
        let tooth = (TEETH - k) % TEETH;
        let mark = match tooth {
            OUTLIER => Some(ToothMark::OutOfBand),
            BROKEN => Some(ToothMark::Broken),
            _ => None,
        };
        let dark_deg = (tooth != BROKEN).then_some([middle_deg - 2.28, middle_deg + 2.28]);
        ToothSignal { tooth, middle_deg, dark_deg, mark }
    };
    StripView { flank: Flank::Left, track: 3, teeth: (0..TEETH).map(tooth).collect() }
}

fn pitch() -> PitchView {
    let centre = |k: usize| {
        let angle = TAU * (k % TEETH) as f64 / TEETH as f64;
        8.1 * angle.cos() - 5.0 * angle.sin() + 1.8 * noise(3 * (k % TEETH) + 1)
    };
    let figure = |name: &str, symbol: &str, value, unit: &str, deviation| UncertainFigure {
        name: name.into(),
        symbol: symbol.into(),
        value,
        unit: unit.into(),
        deviation,
    };
    PitchView {
        radius_mm: 41.2,
        single_um: (0..TEETH).map(|k| centre(k + 1) - centre(k)).collect(),
        cumulative_um: (0..TEETH).map(|k| centre(k) - centre(0)).collect(),
        centre_um: (0..TEETH).map(centre).collect(),
        harmonic_um: [8.1, -5.0],
        outliers: vec![OUTLIER],
        figures: vec![
            figure("total cumulative pitch deviation", "F_p", 22.83, "µm", Some(0.21)),
            figure("largest single pitch deviation", "f_pmax", 4.91, "µm", Some(0.18)),
            figure("eccentricity", "e", 9.43, "µm", Some(0.04)),
            figure("wobble", "ω", 0.23, "mrad", None),
        ],
    }
}

fn edge_point(flank: Flank, place: f64) -> [f64; 2] {
    let r = radius(place);
    let (sin, cos) = nominal(flank, r).to_radians().sin_cos();
    [-r * sin, r * cos]
}

fn section(conventional_deg: Option<f64>, chamfer_um: f64) -> EdgeSectionView {
    EdgeSectionView {
        flank: Flank::Left,
        track: 3,
        rounding_um: 30.0,
        contact_deg: 92.58,
        range_deg: [if chamfer_um > 0.0 { 10.0 } else { 0.0 }, 98.6],
        clearance_deg: if chamfer_um > 0.0 { 101.6 } else { 98.6 },
        rake_chamfer_um: chamfer_um,
        clearance_chamfer_um: 0.5 * chamfer_um,
        beam_um: Some(50.0),
        beam_across_deg: 1.3,
        conventional_deg,
    }
}

fn poses() -> Vec<PoseRow> {
    let row = |flank: Flank, k: usize| {
        let place = PLACES[k];
        PoseRow {
            flank,
            track: k + 1,
            place,
            roll_mm: 32.5813 + 5.1415 * place,
            radius_mm: radius(place),
            height_mm: -0.0364,
            tool_angle_deg: flank.sign() * (2.3233 - 8.0 * place),
            contact_deg: 91.52,
            lever_mm: -flank.sign() * 38.5274,
            swivel_deg: 0.0016 * flank.sign(),
            turn_deg: 90.0 + flank.sign() * (2.3233 - 8.0 * place),
            position_mm: [340.9123 - place, 20.0 + 4.0 * flank.sign(), 150.0364],
            off_flank_deg: 0.89,
            gap_mm: Some(2.1),
            sigma_um: Some(0.52),
        }
    };
    Flank::BOTH.iter().flat_map(|&flank| (0..PLACES.len()).map(move |k| row(flank, k))).collect()
}

fn profile() -> ProfileView {
    let of = |flank: Flank| {
        let x: Vec<f64> = (0..21).map(|k| -1.0 + 0.1 * f64::from(k)).collect();
        let line = |by: f64| x.iter().map(|x| by - curve(flank, *x)).collect::<Vec<f64>>();
        FlankProfile {
            roll_mm: x.iter().map(|x| 32.5813 + 5.1415 * x).collect(),
            mean_um: line(0.0),
            least_um: line(-3.1),
            greatest_um: line(2.8),
            corrected_um: x.iter().map(|x| 0.5 * x * x - 0.2).collect(),
            simulated: PLACES.map(|x| [32.5813 + 5.1415 * x, 0.02 - curve(flank, x)]).to_vec(),
            tolerance_um: Some([-6.0, 6.0]),
        }
    };
    ProfileView { flanks: Sides::from_fn(of) }
}

fn corrections() -> CorrectionsView {
    let change = |name: &str, symbol: &str, change, unit: &str, limit, at_limit, deviation| SettingChange {
        name: name.into(),
        symbol: symbol.into(),
        change,
        unit: unit.into(),
        limit: Some(limit),
        at_limit,
        deviation: Some(deviation),
    };
    CorrectionsView {
        changes: vec![
            change("centre distance", "Δd", -0.00366, "mm", 0.05, false, 0.00012),
            change("crossed-axes angle", "Δγ", 0.1, "deg", 0.1, true, 0.021),
            change("roll angle of the tool", "Δφ_1", 6.65e-5, "deg", 0.1, false, 2.4e-5),
        ],
        rms_um: Some([1.448, 0.589]),
        wear: vec![
            WearRow { flank: Flank::Left, track: 1, mean_um: -2.52, limit_um: 2.6, worn: false },
            WearRow { flank: Flank::Right, track: 5, mean_um: -2.71, limit_um: 2.6, worn: true },
        ],
        regrind: vec![
            Quantity::text("verdict", "regrind before the next lot"),
            Quantity::number("parts until the limit, left", "", 240.0, ""),
        ],
    }
}

fn conventional() -> Vec<ConventionalRow> {
    let row = |flank: Flank, k: usize| {
        let rests = flank == Flank::Right;
        ConventionalRow {
            flank,
            track: k + 1,
            virtual_um: curve(flank, PLACES[k]),
            conventional_um: (!rests).then_some(0.44 + 1.98 * curve(flank, PLACES[k])),
            contact_deg: if rests { 92.9 } else { 93.2 },
            touch_deg: (!rests).then_some(83.5),
            end_deg: 101.2,
        }
    };
    Flank::BOTH.iter().flat_map(|&flank| (0..PLACES.len()).map(move |k| row(flank, k))).collect()
}

fn history() -> HistoryView {
    let row = |k: usize| HistoryRow {
        name: format!("2026-03-{:02}", 2 + 3 * k),
        parts: 120.0 * k as f64,
        wear_um: Sides {
            left: Some(0.3 + 0.42 * k as f64 + 0.15 * noise(k)),
            right: (k != 3).then_some(0.2 + 0.55 * k as f64 + 0.15 * noise(k + 50)),
        },
        remark: if k == 0 { "after regrinding".into() } else { String::new() },
    };
    let trend = |slope: f64, begin: f64| {
        let at = (2.6 - begin) / slope;
        WearTrend {
            line: vec![[0.0, begin], [at, 2.6]],
            forecast: Some([at, 2.6]),
            forecast_deviation: Some(31.0),
        }
    };
    HistoryView {
        measurements: (0..5).map(row).collect(),
        trends: Sides { left: trend(0.42 / 120.0, 0.3), right: trend(0.55 / 120.0, 0.2) },
        limit_um: Some(2.6),
    }
}

fn monte_carlo() -> MonteCarloView {
    let row = |name: &str, symbol: &str, unit: &str, mean: f64, deviation: f64, stated| MonteCarloRow {
        name: name.into(),
        symbol: symbol.into(),
        unit: unit.into(),
        mean,
        deviation,
        stated_deviation: stated,
        interval: [mean - 1.96 * deviation, mean + 1.96 * deviation],
    };
    MonteCarloView {
        runs: 500,
        noise: "120 rpm, jitter 1 µs, beam 0.2 µm, step 0.0001°, 8 revolutions, both senses.".into(),
        rows: vec![
            row("eccentricity", "e_x", "µm", 8.002, 0.0093, Some(0.0095)),
            row("total cumulative pitch deviation", "F_p", "µm", 22.91, 0.21, None),
            row("left flank, track 1", "f", "µm", -2.52, 0.021, Some(0.0205)),
        ],
    }
}

/// A page with every section.
pub fn report() -> SkivingReport {
    let contact = |flank: Flank| PLACES.map(|place| edge_point(flank, place)).to_vec();
    let edge = |flank: Flank| (0..41).map(|k| edge_point(flank, -1.0 + f64::from(k) / 20.0)).collect();
    SkivingReport {
        head: ReportHead {
            job_name: "int85 tool 41".into(),
            description: Some(
                "Skiving tool of 41 teeth for an internal gear, measured after 480 parts.".into(),
            ),
            process: "Measuring of a power-skiving tool",
            version: "0.1.0".into(),
            status: Status::Missed.into(),
            headline: "Tooth 6 leaves the band of 12 µm on the right flank, and the right flank is worn."
                .into(),
            way_out: "regrind the tool".into(),
            figures: vec![
                ("total cumulative pitch".into(), "22.8 µm".into()),
                ("eccentricity".into(), "9.4 µm".into()),
                ("profile, left / right".into(), "2.5 / 2.7 µm".into()),
            ],
            warnings: vec![Warning {
                text: "The wobble is not told by this tool: its contact points lie in one plane.".into(),
                way_out: String::new(),
            }],
            files: vec![("result.json".into(), "all numbers".into())],
        },
        verdict: verdict::Verdict::new(),
        measured: Some(measured()),
        angles: vec![angles(OUTLIER)],
        strip: Some(strip()),
        pitch: Some(pitch()),
        tooth: Some(ToothView { edges_mm: Sides::from_fn(edge), contacts_mm: Sides::from_fn(contact) }),
        edge_sections: vec![section(Some(83.5), 0.0), section(None, 12.0)],
        poses: poses(),
        profile: Some(profile()),
        corrections: Some(corrections()),
        conventional: conventional(),
        history: Some(history()),
        monte_carlo: Some(monte_carlo()),
        sheets: vec![
            DataSheet {
                caption: "Tool".into(),
                quantities: vec![Quantity::count("teeth", "z_1", TEETH as i64)],
            },
            DataSheet { caption: "Workpiece".into(), quantities: vec![Quantity::count("teeth", "z_2", -85)] },
        ],
        programs: Some(ProgramsView {
            proof: vec!["The texts were read back; the poses they command are those above.".into()],
            programs: vec![ProgramRow {
                file: "nc/measure.mpf".into(),
                control: "siemens 840d".into(),
                blocks: 143,
                duration_s: 38.4,
            }],
            figures: vec![Quantity::number("largest difference of a position", "", 4.6e-5, "mm")],
        }),
    }
}
