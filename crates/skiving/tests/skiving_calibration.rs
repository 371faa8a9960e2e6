//! Programs of a calibration: what a recorder would take down on the way of a text tells the beam again, on every control; texts that were
//! changed are not proven.

use job::machine::{LoadedMachine, read_machine};
use job::tables::Program as DialectName;
use machine::Mount;
use nalgebra::{Vector2, Vector3};
use run::RunFailure;
use skiving::measuring::{Approach, Beam, BeamLine, Calibration, Mandrel, Observation};
use skiving::workflow::programs::{
    CalibrationWork, Retreat, TextBlocks, ToolMachining, ToolProgram, calibration_programs, check_calibration,
};
use std::path::Path;

const ALL: [DialectName; 3] = [DialectName::Linuxcnc, DialectName::Siemens, DialectName::Fanuc];
const MANDREL: Mandrel = Mandrel { radius: 10.0, height: 5.0 };

fn machine() -> LoadedMachine {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../machines/skiving-light-barrier.toml");
    read_machine(&path).expect("a shipped machine")
}

fn machining(machine: &LoadedMachine) -> ToolMachining<'_> {
    ToolMachining {
        machine,
        mount: Mount { reversed: false, axial: 62.5, angle: 0.3 },
        carrier: None,
        retreat: Retreat { distance: 12.0, direction: None, speed: 20.0 },
        output: 3,
        dialects: &ALL,
    }
}

fn work(beam: &Beam) -> CalibrationWork<'_> {
    CalibrationWork {
        name: "tool 7",
        beam,
        mandrel: &MANDREL,
        heights: [120.0, 220.0],
        length: 80.0,
        spindle_positions: 2,
        speed: 1.0,
        reach: 3.0,
    }
}

fn beams() -> Vec<Beam> {
    [[0.0, 0.0], [12.0, 0.3], [-7.0, 21.0], [35.0, -30.0]]
        .map(|tilt: [f64; 2]| {
            Beam::new(Vector3::new(300.0, 20.0, 150.0), tilt.map(f64::to_radians), 0.05).unwrap()
        })
        .into()
}

fn code(failure: RunFailure) -> &'static str {
    match failure {
        RunFailure::BadInput(finding) | RunFailure::NotProducible(finding) => {
            assert!(finding.way_out.is_some() && finding.field.is_some(), "{finding:?}");
            finding.code
        }
    }
}

/// Both angles, place and radius of the beam, from the switches of the texts alone.
#[test]
fn the_switches_on_the_ways_tell_the_beam() {
    let machine = machine();
    for beam in beams() {
        let made = calibration_programs(&work(&beam), &machining(&machine)).unwrap();
        assert_eq!(made.len(), 3);
        for program in &made {
            let proof = program.proof;
            assert!(proof.allowed < 2e-6 && proof.difference <= proof.allowed, "{proof:?}");
            // Two heights, two turns of the spindle, one way along Y and one along X.
            assert_eq!(program.mandrel_ways.len(), 8);
            let seen: Vec<Observation> = program
                .mandrel_ways
                .iter()
                .flat_map(|way| {
                    way.switches.iter().map(|place| Observation { place: *place, along: way.along })
                })
                .collect();
            assert_eq!(seen.iter().filter(|o| o.along == Approach::Y).count(), 8);
            let start = Calibration::start(&MANDREL, &seen, 0.08, false).unwrap();
            let found = Calibration::fit(&MANDREL, &seen, &start).unwrap();
            let at = found.line.at(150.0);
            let slope = beam.direction.xy() / beam.direction.z;
            assert!(
                (at - Vector2::new(300.0, 20.0)).norm() < 1e-9 && (found.line.slope - slope).norm() < 1e-11
            );
            assert!((found.line.radius - 0.05).abs() < 1e-9);
        }
    }
}

/// A mandrel that runs out turns with the spindle: its two positions average that.
#[test]
fn two_spindle_positions_average_the_run_out() {
    let beam = beams()[1];
    let slope = beam.direction.xy();
    let line = BeamLine { point: beam.point.xy() - slope * 150.0, slope, radius: 0.05 };
    let machine = machine();
    let off = |positions: usize| {
        let work = CalibrationWork { spindle_positions: positions, ..work(&beam) };
        let made = calibration_programs(&work, &machining(&machine)).unwrap();
        let mut seen = Vec::new();
        for way in &made[0].mandrel_ways {
            // 8 um beside the spindle's axis.
            let out = Vector3::new(way.turn.cos(), way.turn.sin(), 0.0) * 8e-3;
            let axis = (way.ends[1] - way.ends[0]).normalize();
            let length = (way.ends[1] - way.ends[0]).norm();
            let middle = 0.5 * length;
            let forward = MANDREL.switch(&line, &(way.ends[0] + out), &axis, [0.0, middle]);
            let backward = MANDREL.switch(&line, &(way.ends[1] + out), &-axis, [0.0, middle]);
            let places = match way.along {
                Approach::Y => vec![forward, backward],
                Approach::X => vec![MANDREL.switch(&line, &(way.ends[0] + out), &axis, [0.0, length])],
            };
            for place in places {
                seen.push(Observation { place: place.unwrap() - out, along: way.along });
            }
        }
        let start = Calibration::start(&MANDREL, &seen, 0.05, false).unwrap();
        let found = Calibration::fit(&MANDREL, &seen, &start).unwrap();
        (found.line.at(150.0) - Vector2::new(300.0, 20.0)).norm()
    };
    let [one, two] = [off(1), off(2)];
    assert!(one > 5e-3 && two < 1e-5, "{one} {two}");
}

fn judged(
    program: &ToolProgram,
    work: &CalibrationWork<'_>,
    machining: &ToolMachining<'_>,
    text: &str,
) -> Result<Vec<String>, String> {
    let read = nc::read(text.as_bytes(), program.dialect, &program.words.words).map_err(|e| e.to_string())?;
    let blocks = TextBlocks { dialect: program.dialect, words: &program.words, blocks: &read.blocks };
    let found = check_calibration(work, machining, &blocks).unwrap();
    assert_eq!(found.faults.is_empty(), found.sound[0] == found.sound[1] && found.faults.is_empty());
    Ok(found.faults.iter().map(|fault| fault.text.clone()).collect())
}

#[test]
fn a_text_that_was_changed_is_noticed() {
    let machine = machine();
    let beam = beams()[1];
    let (work, machining) = (work(&beam), machining(&machine));
    for program in calibration_programs(&work, &machining).unwrap() {
        let text = program.written.text.clone();
        assert_eq!(judged(&program, &work, &machining, &text).unwrap(), Vec::<String>::new());
        let lines: Vec<&str> = text.lines().collect();
        let mut noticed = 0;
        let moves: Vec<usize> = (0..lines.len())
            .filter(|&k| {
                lines[k].contains('X')
                    && lines[k].contains('.')
                    && !lines[k].contains("MACHINE")
                    && !lines[k].contains("MANDREL")
            })
            .collect();
        assert!(moves.len() > 8, "{text}");
        for k in moves {
            let x = lines[k].split_whitespace().find_map(|word| word.strip_prefix('X')).unwrap_or_default();
            let Ok(value) = x.parse::<f64>() else { continue };
            // Into the beam.
            let changed = lines[k].replace(x, &format!("{:.6}", value + 17.0));
            let mut lines = lines.clone();
            lines[k] = &changed;
            let found = judged(&program, &work, &machining, &(lines.join("\n") + "\n"));
            let faults = found.unwrap_or_else(|refused| vec![refused]);
            assert!(!faults.is_empty(), "{changed}");
            assert!(
                faults.iter().all(|text| text.starts_with("block ") || text.contains("line")),
                "{faults:?}"
            );
            noticed += 1;
        }
        assert!(noticed > 5);
        // Twice as fast: the recorder's delay counts twice.
        let feed = lines.iter().position(|line| line.contains("G1 Y")).expect("through the beam");
        let f = lines[feed].split('F').next_back().unwrap();
        let faster = lines[feed].replace(f, &format!("{:.6}", 2.0 * f.parse::<f64>().unwrap()));
        let changed = text.replace(lines[feed], &faster);
        assert!(!judged(&program, &work, &machining, &changed).unwrap().is_empty());
    }
}

#[test]
fn what_cannot_be_driven_is_refused() {
    let machine = machine();
    let beam = beams()[0];
    let refuse = |change: &dyn Fn(&mut CalibrationWork<'_>)| {
        let mut work = work(&beam);
        change(&mut work);
        code(calibration_programs(&work, &machining(&machine)).unwrap_err())
    };
    assert_eq!(refuse(&|work| work.speed = 0.0), "invalid-number");
    assert_eq!(refuse(&|work| work.reach = f64::NAN), "invalid-number");
    assert_eq!(refuse(&|work| work.length = f64::INFINITY), "invalid-number");
    assert_eq!(refuse(&|work| work.spindle_positions = 0), "invalid-number");
    // Beyond the travel of Z.
    assert_eq!(refuse(&|work| work.heights = [120.0, 900.0]), "axis-limit");
}
