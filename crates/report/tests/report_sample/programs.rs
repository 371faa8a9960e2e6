//! Made-up programs of a run: an infeed and a stroke of two axes, for three controls.

use super::spread;
use report::charts::{AxisChart, AxisChartLimits};
use report::programs::{
    AxisRow, ControlWords, FlankProofRow, PassRow, PassTable, ProgramRow, ProgramsReport, ProofReport,
    RestingAxis, SpindleRow, StationReport,
};

/// An axis that runs to and fro `turns` times over 10 s on `rows` instants, by `stroke` about `middle`.
pub fn swinging(rows: usize, turns: f64, middle: f64, stroke: f64) -> AxisChart {
    let time_s = spread(0.0, 10.0, rows);
    let rate = 2.0 * std::f64::consts::PI * turns / 10.0;
    let over = |f: &dyn Fn(f64) -> f64| time_s.iter().map(|&t| f(rate * t)).collect::<Vec<f64>>();
    AxisChart {
        axis: "X1".into(),
        word: "X".into(),
        unit: "mm".into(),
        position: over(&|u| middle - stroke * u.cos()),
        velocity: over(&|u| stroke * rate * u.sin()),
        acceleration: over(&|u| stroke * rate * rate * u.cos()),
        limits: AxisChartLimits {
            travel: Some([-420.0, -20.0]),
            velocity: Some(250.0),
            acceleration: Some(2500.0),
        },
        time_s,
    }
}

fn names(names: &[&str]) -> Vec<String> {
    names.iter().map(|&name| name.into()).collect()
}

/// Programs of grinding alone.
pub fn programs() -> ProgramsReport {
    let pass = |name: &str, braked| PassRow {
        name: name.into(),
        driven_mm: [-22.5, 22.5],
        blocks: 120,
        speed_mm_per_s: 1.25,
        braked,
        chords_um: 0.0041,
        rounding_um: 0.0007,
        time_s: 36.4,
    };
    let row = |file: &str, control: &str| ProgramRow {
        file: file.into(),
        control: control.into(),
        job: "grinding".into(),
        blocks: 240,
        time_s: 125.4,
    };
    let proof = |controls: &[&str], left: f64| ProofReport {
        controls: names(controls),
        statement: format!("proven from the program text: max deviation {left:.4} um"),
        flanks: [("left", left), ("right", 0.9 * left)]
            .map(|(flank, um)| FlankProofRow {
                flank: flank.into(),
                max_deviation_um: um,
                difference_um: 0.0042,
            })
            .into(),
        chords_um: 0.0041,
        rounding_um: 0.0007,
        allowed_difference_um: 0.0139,
    };
    ProgramsReport {
        machine: "grinder <8>".into(),
        work_reversed: true,
        proofs: vec![proof(&["linuxcnc", "fanuc"], 0.0123), proof(&["siemens"], 0.0119)],
        programs: vec![
            row("programs/grinding-linuxcnc.ngc", "linuxcnc"),
            row("programs/grinding-siemens.mpf", "siemens"),
            row("programs/grinding-fanuc.nc", "fanuc"),
        ],
        stations: vec![StationReport {
            job: "grinding".into(),
            parameter: "feed z_V2".into(),
            control: "linuxcnc".into(),
            alike: names(&["fanuc"]),
            different: names(&["siemens"]),
            passes: vec![
                PassTable {
                    controls: names(&["linuxcnc", "fanuc"]),
                    rows: vec![
                        pass("GRINDING ROUGHING", Some((0.83, "C2 acceleration".into()))),
                        pass("GRINDING FINISHING", None),
                    ],
                },
                PassTable { controls: names(&["siemens"]), rows: vec![pass("GRINDING FINISHING", None)] },
            ],
            axes: vec![AxisRow {
                axis: "X1".into(),
                role: "radial".into(),
                words: vec![
                    ControlWords { word: "X".into(), controls: names(&["linuxcnc", "fanuc"]) },
                    ControlWords { word: "X1".into(), controls: names(&["siemens"]) },
                ],
                reversed: true,
                unit: "mm".into(),
                range: [-136.2214, -126.2214],
                way: 40.0,
                velocity: (125.0, Some(250.0)),
                acceleration: (2000.0, None),
            }],
            resting: vec![RestingAxis { axis: "A1".into(), at: 3.1468, unit: "deg".into() }],
            spindles: vec![SpindleRow { axis: "B3".into(), word: "spindle 1".into(), speed_per_min: 4000.0 }],
            charts: vec![swinging(400, 2.0, -131.0, 5.0)],
            jumping: names(&["V1"]),
        }],
    }
}
