//! Light barriers that are carried, and tools whose whole chain is: brought before one another, measured, parked; a wrong place of the
//! carrier is noticed.

use crate::skiving::samples::STEPPED;
use job::machine::{LoadedMachine, parse_machine};
use job::tables::Program as DialectName;
use machine::Mount;
use nc::Block;
use run::RunFailure;
use skiving::measuring::Sense;
use skiving::workflow::programs::{
    Carried, Carrier, MeasuringWork, Retreat, ToolMachining, measuring_programs, prove_measuring,
};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::path::Path;

const ALL: [DialectName; 3] = [DialectName::Linuxcnc, DialectName::Siemens, DialectName::Fanuc];

fn text(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../machines/{name}.toml"));
    std::fs::read_to_string(path).expect("a shipped machine")
}

fn machine(text: &str) -> LoadedMachine {
    parse_machine(job::Source::new("machine.toml", text)).unwrap_or_else(|e| panic!("{e}"))
}

/// A barrier on a swivelling carrier, one on a sliding one, and a tool on a swivelling one.
fn carriers() -> Vec<(LoadedMachine, Carrier)> {
    let carrier = |machine: &LoadedMachine, measuring, parked, carries| Carrier {
        axis: machine.machine.axis_named("V").expect("V"),
        measuring,
        parked,
        carries,
    };
    let turning = text("skiving-carrier");
    let (before, after) = turning.split_once("[axes.V]").expect("V");
    let (_, behind) = after.split_once("[axes.C]").expect("C");
    let sliding = "[axes.V]\ntype = \"linear\"\ndirection = [0, 1, 0]\nmin_mm = -900\nmax_mm = 100\nletter = \"V\"\nmax_velocity = 300\n\n";
    let slides = format!("{before}{sliding}[axes.C]{behind}");
    let tool = turning
        .replace("point_mm = [-250, 0, 0]", "point_mm = [250, 0, 0]")
        .replace(
            "axes = [\"X\", \"Y\", \"Z\", \"A\", \"B\"]",
            "axes = [\"V\", \"X\", \"Y\", \"Z\", \"A\", \"B\"]",
        )
        .replace("axes = [\"V\", \"C\"]", "axes = [\"C\"]");
    let [turning, slides, tool] = [turning, slides, tool].map(|text| machine(&text));
    let of = [
        carrier(&turning, FRAC_PI_2, 0.0, Carried::Barrier),
        carrier(&slides, -12.5, -700.0, Carried::Barrier),
        // By half a turn: the head swivels about the same direction again.
        carrier(&tool, PI, 0.3, Carried::Tool),
    ];
    [turning, slides, tool].into_iter().zip(of).collect()
}

fn machining(machine: &LoadedMachine, carrier: Carrier) -> ToolMachining<'_> {
    ToolMachining {
        machine,
        mount: Mount { reversed: false, axial: 62.5, angle: 0.3 },
        carrier: Some(carrier),
        retreat: Retreat { distance: 30.0, direction: None, speed: 20.0 },
        output: 3,
        dialects: &ALL,
    }
}

fn message(failure: RunFailure) -> String {
    match failure {
        RunFailure::BadInput(finding) | RunFailure::NotProducible(finding) => format!("{finding:?}"),
    }
}

#[test]
fn carriers_are_brought_and_parked() {
    let (flanks, beam) = (STEPPED.flanks(), STEPPED.beam());
    let work = MeasuringWork {
        name: "tool 7",
        flanks: &flanks,
        beam: &beam,
        senses: &Sense::BOTH,
        revolutions: 2,
        speed: 2.0 * TAU,
    };
    let mut proven = 0;
    for (machine, carrier) in carriers() {
        let machining = machining(&machine, carrier);
        let made = measuring_programs(&work, &machining).unwrap_or_else(|e| panic!("{}", message(e)));
        for program in &made {
            proven += 1;
            let proof = program.proof;
            assert!(proof.difference <= proof.allowed && proof.axis_distance <= proof.allowed, "{proof:?}");
            let word = program.words.place(carrier.axis).expect("a word of the carrier");
            let places: Vec<f64> = program
                .read
                .iter()
                .filter_map(|block| match block {
                    Block::Rapid(target) | Block::Linear { target, .. } => target.get(word),
                    _ => None,
                })
                .collect();
            // Parked, measuring, parked, and never moved in between.
            let wanted = [carrier.parked, carrier.measuring, carrier.parked];
            assert_eq!(places.len(), 3, "{places:?}");
            assert!(places.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-8), "{places:?}");
            // A carrier that stands elsewhere by a hundredth of a degree or millimetre moves the beam off the contact.
            let text = &program.written.text;
            let line = text.lines().find(|line| {
                let value = line
                    .split_whitespace()
                    .find_map(|word| word.strip_prefix('V')?.trim_start_matches('=').parse::<f64>().ok());
                let shown = if machine.machine.axes()[carrier.axis].joint == machine::Joint::Linear {
                    carrier.measuring
                } else {
                    carrier.measuring.to_degrees()
                };
                value.is_some_and(|value| (value - shown).abs() < 1e-6)
            });
            let line = line.unwrap_or_else(|| panic!("{text}"));
            let v = line.split_whitespace().find_map(|word| word.strip_prefix('V')).expect("V");
            let changed = line.replace(v, &format!("{:.6}", v.parse::<f64>().expect("a number") + 0.01));
            let changed = text.replacen(line, &changed, 1);
            assert!(prove_measuring(&work, &machining, program.dialect, text).is_ok());
            let refused = prove_measuring(&work, &machining, program.dialect, &changed).expect_err("moved");
            let refused = message(refused);
            assert!(refused.contains("program-not-proven") || refused.contains("touch"), "{refused}");
        }
    }
    assert_eq!(proven, 9);
}
