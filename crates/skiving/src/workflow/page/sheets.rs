//! Tool, workpiece, setting, light barrier and calibration in figures.

use crate::job::{RakeForm, SkivingJob};
use crate::page::DataSheet;
use crate::workflow::result::{CalibrationResult, SkivingResult};
use report::Quantity;

/// The sheets of a job.
pub(super) fn sheets(job: &SkivingJob, result: &SkivingResult) -> Vec<DataSheet> {
    let number = Quantity::number;
    let (tool, gear, settings) = (&job.skiving_tool, &job.gear, &result.settings);
    let chamfer = tool.rake_chamfer;
    let pressure = gear.normal_pressure_angle_deg.sides();
    let mut sheets = vec![
        DataSheet {
            caption: "Tool".into(),
            quantities: vec![
                Quantity::count("teeth", "z_1", i64::from(tool.teeth)),
                number("helix angle", "β_1", tool.helix_angle_deg, "deg"),
                number("pitch radius", "r_1", settings.tool_pitch_radius_mm, "mm"),
                Quantity::text("rake face", rake_form(tool.rake.form)),
                number("rake angle", "γ_r", tool.rake.angle_deg, "deg"),
                number("step angle", "σ", tool.rake.step_angle_deg, "deg"),
                number("radius of the edge", "ρ_e", 1e3 * tool.edge_radius, "µm"),
                number("clearance angle", "α_c", tool.clearance_angle_deg, "deg"),
                number("chamfer on the rake face", "b_r", chamfer.map_or(0.0, |c| 1e3 * c.width), "µm"),
                number("its angle", "κ_r", chamfer.map_or(0.0, |c| c.angle_deg), "deg"),
                number("chamfer on the clearance face", "κ_c", tool.clearance_chamfer_angle_deg, "deg"),
            ],
        },
        DataSheet {
            caption: "Workpiece".into(),
            quantities: vec![
                Quantity::count("teeth", "z_2", i64::from(gear.teeth)),
                number("normal module", "m_n", gear.normal_module, "mm"),
                Quantity::per_flank("normal pressure angle", "α_n", pressure.left, pressure.right, "deg"),
                number("helix angle", "β_2", gear.helix_angle_deg, "deg"),
            ],
        },
        DataSheet {
            caption: "Setting".into(),
            quantities: vec![
                number("centre distance", "d", settings.centre_distance_mm, "mm"),
                number("crossed-axes angle", "γ", settings.crossed_axes_angle_deg, "deg"),
                number("tool shift", "z_V1", settings.tool_shift_mm, "mm"),
                number("workpiece angle per tool angle", "i_21", settings.ratio, ""),
            ],
        },
        light_barrier(job),
    ];
    sheets.extend(result.calibration.as_ref().map(calibration));
    sheets
}

fn rake_form(form: RakeForm) -> &'static str {
    match form {
        RakeForm::Plane => "a plane for every tooth",
        RakeForm::Cone => "one cone",
        RakeForm::Sphere => "one hollow sphere",
    }
}

fn light_barrier(job: &SkivingJob) -> DataSheet {
    let number = Quantity::number;
    let (barrier, measuring) = (&job.light_barrier, &job.measuring);
    DataSheet {
        caption: "Light barrier and measurement".into(),
        quantities: vec![
            number("radius of the beam", "r_L", 1e3 * barrier.radius, "µm"),
            number("tilt in X-Z", "δ", barrier.tilt_x_deg, "deg"),
            number("tilt in Y-Z", "ε", barrier.tilt_y_deg, "deg"),
            number("hysteresis", "", barrier.hysteresis_um, "µm"),
            number("delay", "", barrier.latency_us, "µs"),
            number("jitter", "", barrier.jitter_us, "µs"),
            number("noise of the edge", "", barrier.noise_um, "µm"),
            number("step of the encoder", "q", 3600.0 * barrier.encoder_step_deg, "arcsec"),
            number("speed of the spindle", "n_B", measuring.speed_rpm, "1/min"),
            Quantity::count("revolutions in each sense", "", measuring.revolutions as i64),
            Quantity::count("senses", "", measuring.senses.list().len() as i64),
        ],
    }
}

fn calibration(found: &CalibrationResult) -> DataSheet {
    let uncertain = |name: &str, value: f64, unit: &str, sigma: f64, sigma_unit: &str| {
        Quantity::text(name, format!("{value:.6} {unit} (standard deviation {sigma:.4} {sigma_unit})"))
    };
    let what = if found.measured { "Beam by the mandrel" } else { "Beam by the mandrel, as expected" };
    let [x, y, z] = found.point_mm;
    DataSheet {
        caption: what.into(),
        quantities: vec![
            uncertain("X", x, "mm", found.point_sigma_um[0], "µm"),
            uncertain("Y", y, "mm", found.point_sigma_um[1], "µm"),
            Quantity::number("at the height", "Z", z, "mm"),
            uncertain("tilt in X-Z", found.tilt_x_deg, "deg", found.tilt_sigma_deg[0], "deg"),
            uncertain("tilt in Y-Z", found.tilt_y_deg, "deg", found.tilt_sigma_deg[1], "deg"),
            uncertain("radius", found.radius_mm, "mm", found.radius_sigma_um, "µm"),
            Quantity::number("largest residual", "", found.residual_um, "µm"),
            Quantity::count("switches", "", found.switches.len() as i64),
        ],
    }
}
