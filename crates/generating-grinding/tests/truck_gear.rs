//! The gear of a truck that several tests grind.

/// Its table in a job.
pub const TRUCK_GEAR: &str = r#"
[gear]
teeth = 31
normal_module = 4.0
normal_pressure_angle_deg = 20.0
helix_angle_deg = 18.0
profile_shift = 0.2
face_width = 42.0
tip_diameter = 139.9
root_diameter = 121.9
form_diameter = 125.5
"#;
