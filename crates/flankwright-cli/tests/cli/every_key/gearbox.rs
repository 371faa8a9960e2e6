//! The walk of the electronic gearbox.

use super::{Walk, title_block, walk};
use serde_json::json;

#[test]
fn every_key_of_the_electronic_gearbox_counts() {
    let gear = json!({ "teeth": 40, "normal_module": 2.5, "normal_pressure_angle_deg": 20.0, "helix_angle_deg": 20.0 });
    let info = json!({ "name": "every-key", "process": "electronic-gearbox", "description": "each key once",
        "part_number": "4711", "drawing_number": "Z-12 b", "customer": "a customer", "machine_name": "a machine",
        "date": "2026-03-31", "author": "an author" });
    let choices = |key: &str, values: [f64; 2]| json!([{ key: values[0], "cost": 1.0 }, { key: values[1], "cost": 1.5 }]);
    let whole = |key: &str, values: [u32; 2]| json!([{ key: values[0], "cost": 1.0 }, { key: values[1], "cost": 1.5 }]);
    let motion = json!({
        "job": info, "gear": gear,
        "target": { "tolerance_um": 50.0 },
        "feed": { "pulses_per_metre": 100_000.0, "clock_hz": 1e6, "pulses_per_interval": 16, "mode": "no-backlash",
            "counter_limit": 16_777_215 },
        "workpiece": { "pulses_per_revolution": 36_000, "rate": "exact", "reversed": false },
        "worm": { "threads": 3, "pulses_per_revolution": 65_536, "speed_rpm": 3000.0 },
        "stimulus": { "start": 0.002, "rest_s": 0.05, "motion": [
            { "to": 1.003, "speed_mm_per_min": 600.0, "acceleration_mm_per_s2": 300.0 },
            { "dwell_s": 0.02 },
            { "to": 0.002, "speed_mm_per_min": 500.0, "acceleration_mm_per_s2": 200.0 } ] },
        "servo": { "sample_time_us": 125.0, "inertia_kg_m2": 0.12, "damping_n_m_s": 0.05, "friction_n_m": 0.5,
            "friction_speed_rad_per_s": 5.0, "torque_limit_n_m": 60.0, "bandwidth_hz": 60.0, "feed_forward": 0.5,
            "quantised": true, "disturbances": [
                { "kind": "constant", "torque_n_m": 0.5 },
                { "kind": "step", "torque_n_m": -0.6, "at_s": 0.1 },
                { "kind": "harmonic", "torque_n_m": 0.3, "frequency_hz": 50.0, "phase_deg": 10.0 },
                { "kind": "order", "torque_n_m": 0.3, "axis": "workpiece", "order": 40.0, "phase_deg": 10.0 },
                { "kind": "pulses", "torque_n_m": 0.3, "axis": "workpiece", "per_revolution": 3, "width_deg": 20.0 } ] },
        "explore": { "wanted_um": 1.6, "speed_mm_per_min": 600.0, "acceleration_mm_per_s2": 100.0,
            "scales": choices("pulses_per_metre", [100_000.0, 250_000.0]), "clocks": choices("clock_hz", [1e6, 1e7]),
            "interpolations": whole("pulses_per_interval", [16, 64]),
            "encoders": whole("pulses_per_revolution", [36_000, 90_000]) },
        "errors": {
            "scale": { "slope_um_per_m": 3.0, "periodic": [{ "amplitude_um": 0.5, "period_mm": 0.4, "phase_deg": 20.0 }] },
            "encoder": { "radius_mm": 50.0, "eccentricity_um": 0.5, "eccentricity_phase_deg": 15.0,
                "periodic": [{ "order": 3, "amplitude_arcsec": 0.2, "phase_deg": 30.0 }] } },
        "correction": { "curves": [
            { "kind": "polynomial", "coefficients_um": [0.1, 0.5] },
            { "kind": "table", "axis": "feed", "start": 0.1, "spacing": 0.2, "values_um": [0.0, 1.0, -1.0, 0.0],
              "ends": "natural" } ] },
        "split": { "volts_per_pulse": 10.0, "bits": 5, "offset_mv": 20.0, "gain_error_percent": 1.0 },
        "engagement": { "phase_speed_deg_per_s": 90.0, "acceleration_deg_per_s2": 3600.0, "gap_deg": 2.5, "cycle_us": 1000.0,
            "counter_bits": 16 },
        "compare": { "pll": { "bandwidth_hz": 50.0, "damping": 0.7 },
            "amplitude": { "offset_percent": 1.0, "mismatch_percent": 2.0, "phase_error_deg": 1.0, "delay_us": 30.0 } },
        "output": { "pulse_trace": true, "split_trace": true, "language": "en" },
    });
    let mut gains = motion.clone();
    gains["servo"].as_object_mut().unwrap().remove("bandwidth_hz");
    gains["servo"]["gains"] = json!({
        "proportional_n_m_per_rad": 22_740.0, "integral_n_m_per_rad_s": 1.9e6, "derivative_n_m_s_per_rad": 90.4
    });
    let mut screw = motion.clone();
    screw["errors"].as_object_mut().unwrap().remove("scale");
    screw["errors"]["ball_screw"] = json!({ "lead_mm": 0.8, "travel_um_per_300mm": 12.0, "wobble_um": 1.0,
        "wobble_phase_deg": 20.0, "backlash_um": 2.0 });
    let mut train = motion.clone();
    train["errors"].as_object_mut().unwrap().remove("scale");
    train.as_object_mut().unwrap().remove("compare");
    train["stimulus"] =
        json!({ "reference_ticks": [100, 260, 420], "reference_signs": [1, 1, 1], "last_tick": 1000 });
    let (ignored, missing) = walk(&Walk {
        definition: "GearboxJob",
        jobs: vec![motion, gains, screw, train],
        command: "gearbox",
        exceptions: &[
            ("job.name", "a name"),
            ("job.description", "a comment"),
            ("job.process", "says which keys there are"),
            ("servo.disturbances.kind", "says which keys there are"),
            ("correction.curves.kind", "says which keys there are"),
            ("correction.curves.axis", "a table over the worm is periodic, this one over the feed is not"),
            (
                "stimulus.references",
                "the name of a table, whose rows are those of reference_ticks and reference_signs",
            ),
        ],
        values: title_block()
            .into_iter()
            .chain([
                ("feed.mode", json!("one-way")),
                ("feed.counter_limit", json!(3)),
                ("workpiece.rate", json!("bresenham")),
                ("servo.disturbances.axis", json!("worm")),
                ("correction.curves.ends", json!("periodic")),
                ("engagement.counter_bits", json!(20)),
                ("split.bits", json!(3)),
            ])
            .collect(),
        echoes: &[
            "job",
            "version",
            "settings",
            "timing_s",
            "tolerance_um",
            "scope",
            "reason",
            "warnings",
            "wanted_um",
            "speed_mm_per_min",
            "acceleration_mm_per_s2",
            "pulses_per_metre",
            "clock_hz",
            "pulses_per_interval",
            "pulses_per_revolution",
            "cost",
        ],
    });
    assert!(ignored.is_empty(), "ignored: {ignored:?}");
    assert!(missing.is_empty(), "in no job of the walk: {missing:?}");
}
