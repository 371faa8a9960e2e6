//! An axis that is off is found again from the gear that it grinds: ground by rays, measured with noise, explained by the exact contact.

use foundation::numerics::Silent;
use generating_grinding::job::{Job, LoadedJob, MachineDeviations, SimulatedMeasurement};
use inspection::workflow::{AxesTogether, AxisResult, inspect_simulated};
use job::read_job_of;
use std::path::Path;

/// The axes named each by itself, and together.
fn asked(off: MachineDeviations) -> (Vec<AxisResult>, Option<AxesTogether>) {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/inspection/closed-loop.toml");
    let mut loaded: LoadedJob = read_job_of::<Job>(Path::new(file)).unwrap();
    let table = loaded.job.inspection.get_or_insert_default();
    let MachineDeviations { radial_feed_um, work_angle_arcsec, crossing_angle_deg, dressing } = off;
    table.simulated = Some(SimulatedMeasurement {
        radial_feed_um,
        work_angle_arcsec,
        crossing_angle_deg,
        dressing,
        noise_um: 0.1,
        teeth: 4,
        rounds: 1,
        ..SimulatedMeasurement::default()
    });
    let found = inspect_simulated(&loaded, None, &Silent).unwrap();
    let round = &found.result.rounds[0];
    (round.axes.clone(), round.axes_together.clone())
}

fn axes(off: MachineDeviations) -> Vec<AxisResult> {
    asked(off).0
}

/// The axis that explains most, with what it was off by.
fn is_found(off: MachineDeviations, name: &str, value: f64) {
    let axes = axes(off);
    let first = axes.first().unwrap_or_else(|| panic!("no axis for {name}"));
    assert!(first.axis == name || first.not_told_apart.iter().any(|other| other == name), "{name}: {axes:?}");
    assert!(first.explains > 0.9, "{axes:?}");
    let axis = axes.iter().find(|axis| axis.axis == name).unwrap();
    // Three standard uncertainties, and a per cent for what the referee's rays leave between their points.
    let allowed = 3.0 * axis.uncertainty + 0.01 * value.abs();
    assert!((axis.value - value).abs() < allowed, "{axes:?}");
}

#[test]
fn an_axis_that_is_off_is_named_with_its_deviation() {
    let off = MachineDeviations::default;
    is_found(MachineDeviations { radial_feed_um: vec![0.0, 0.0, 6.0], ..off() }, "radial_feed_2_um", 6.0);
    is_found(MachineDeviations { work_angle_arcsec: vec![0.0, 8.0], ..off() }, "work_angle_1_arcsec", 8.0);
    let mut dressing = off();
    dressing.dressing.d_gamma_deg = 0.1;
    is_found(dressing, "dressing_gamma_deg", 0.1);
}

/// Feed, workpiece and dressing off at once: none explains it alone, and each is found with its own deviation.
#[test]
fn axes_that_are_off_at_once_are_found_together() {
    let mut off = MachineDeviations {
        radial_feed_um: vec![0.0, 0.0, 6.0],
        work_angle_arcsec: vec![0.0, 8.0],
        ..MachineDeviations::default()
    };
    off.dressing.d_gamma_deg = 0.1;
    let (alone, together) = asked(off);
    assert!(alone[0].explains < 0.9, "{alone:?}");
    let together = together.expect("several axes");
    assert!(together.explains > 0.98, "{together:?}");
    let expected = [("radial_feed_2_um", 6.0), ("work_angle_1_arcsec", 8.0), ("dressing_gamma_deg", 0.1)];
    for (name, value) in expected {
        let axis = together.axes.iter().find(|axis| axis.axis == name);
        let axis = axis.unwrap_or_else(|| panic!("{name}: {together:?}"));
        // Three standard uncertainties, and two per cent for what patterns of several axes leave beside their sum.
        let allowed = 3.0 * axis.uncertainty + 0.02 * value;
        assert!((axis.value - value).abs() < allowed, "{name}: {together:?}");
    }
}

#[test]
fn a_good_machine_gives_no_axis() {
    assert_eq!(asked(MachineDeviations::default()), (vec![], None));
}
