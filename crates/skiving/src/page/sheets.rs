//! Tool, workpiece, setting, light barrier and calibration in figures.

use crate::job::RakeForm;
use crate::workflow::prepare::{Drawn, PreparedSkiving, Recording};
use crate::workflow::{CalibrationResult, SkivingResult};
use report::{Quantity, Table};

/// The sheets of a run.
pub(super) fn tables(prepared: &PreparedSkiving, result: &SkivingResult) -> Vec<Table> {
    let number = Quantity::number;
    let Drawn { tool, gear, .. } = &prepared.drawn;
    let settings = &result.settings;
    let chamfer = tool.rake_chamfer;
    let pressure = gear.normal_pressure_angle_deg.sides();
    let mut of_tool = vec![
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
    ];
    let changes = tool.rake.changes().into_iter().filter(|(_, change)| *change != 0.0);
    of_tool.extend(changes.map(|(key, change)| {
        let (name, unit) = match key {
            "height_deg_per_mm" => ("rake towards the tip", "deg/mm"),
            "height_deg_per_mm2" => ("rake towards the tip, quadratic", "deg/mm²"),
            "hollow_deg_per_mm" => ("hollow across the tooth", "deg/mm"),
            _ => ("twist of the rake face", "deg/mm"),
        };
        number(name, "", change, unit)
    }));
    let mut sheets = vec![
        Table::of_quantities("Tool", &of_tool),
        Table::of_quantities(
            "Workpiece",
            &[
                Quantity::count("teeth", "z_2", i64::from(gear.teeth)),
                number("normal module", "m_n", gear.normal_module, "mm"),
                Quantity::per_flank("normal pressure angle", "α_n", pressure.left, pressure.right, "deg"),
                number("helix angle", "β_2", gear.helix_angle_deg, "deg"),
            ],
        ),
        Table::of_quantities(
            "Setting",
            &[
                Quantity::text("motion", motion(result)),
                number("centre distance", "d", settings.centre_distance_mm, "mm"),
                number("crossed-axes angle", "γ", settings.crossed_axes_angle_deg, "deg"),
                number("tool shift", "z_V1", settings.tool_shift_mm, "mm"),
                number("workpiece angle per tool angle", "i_21", settings.ratio, ""),
            ],
        ),
        light_barrier(&prepared.drawn, &prepared.recording),
    ];
    sheets.extend(result.calibration.as_ref().map(calibration));
    sheets
}

/// How tool and workpiece move.
fn motion(result: &SkivingResult) -> &'static str {
    // A tool on a parallel axis does not skive.
    if result.settings.crossed_axes_angle_deg == 0.0 {
        "shaping on parallel axes"
    } else {
        "skiving on crossed axes"
    }
}

fn rake_form(form: RakeForm) -> &'static str {
    match form {
        RakeForm::Plane => "a plane for every tooth",
        RakeForm::Cone => "one cone",
        RakeForm::Sphere => "one hollow sphere",
        RakeForm::Variable => "a face for every tooth whose angle changes",
    }
}

fn light_barrier(Drawn { barrier, .. }: &Drawn, recording: &Recording) -> Table {
    let number = Quantity::number;
    let stands = match barrier.direction {
        None => vec![
            number("tilt in X-Z", "δ", barrier.tilt_x_deg, "deg"),
            number("tilt in Y-Z", "ε", barrier.tilt_y_deg, "deg"),
        ],
        Some([x, y, z]) => {
            // Leaning out of the vertical, and towards where seen from above.
            let (lean, towards) = (x.hypot(y).atan2(z).to_degrees(), y.atan2(x).to_degrees());
            vec![
                number("angle of the beam to the vertical", "", lean, "deg"),
                number("where it leans to, from X towards Y", "", towards, "deg"),
            ]
        }
    };
    let mut quantities = vec![number("radius of the beam", "r_L", 1e3 * barrier.radius, "µm")];
    quantities.extend(stands);
    quantities.extend([
        number("hysteresis", "", barrier.hysteresis_um, "µm"),
        number("delay", "", barrier.latency_us, "µs"),
        number("jitter", "", barrier.jitter_us, "µs"),
        number("noise of the edge", "", barrier.noise_um, "µm"),
        number("step of the encoder", "q", 3600.0 * barrier.encoder_step_deg, "arcsec"),
        number("speed of the spindle", "n_B", recording.speed_rpm, "1/min"),
        Quantity::count("revolutions in each sense", "", recording.revolutions as i64),
        Quantity::count("senses", "", recording.senses.len() as i64),
    ]);
    Table::of_quantities("Light barrier and measurement", &quantities)
}

fn calibration(found: &CalibrationResult) -> Table {
    let uncertain = |name: &str, value: f64, unit: &str, sigma: f64, sigma_unit: &str| {
        Quantity::text(name, format!("{value:.6} {unit} (standard deviation {sigma:.4} {sigma_unit})"))
    };
    let what = if found.measured { "Beam by the mandrel" } else { "Beam by the mandrel, as expected" };
    let [x, y, z] = found.point_mm;
    Table::of_quantities(
        what,
        &[
            uncertain("X", x, "mm", found.point_sigma_um[0], "µm"),
            uncertain("Y", y, "mm", found.point_sigma_um[1], "µm"),
            Quantity::number("at the height", "Z", z, "mm"),
            uncertain("tilt in X-Z", found.tilt_x_deg, "deg", found.tilt_sigma_deg[0], "deg"),
            uncertain("tilt in Y-Z", found.tilt_y_deg, "deg", found.tilt_sigma_deg[1], "deg"),
            uncertain("radius", found.radius_mm, "mm", found.radius_sigma_um, "µm"),
            Quantity::number("largest residual", "", found.residual_um, "µm"),
            Quantity::count("switches", "", found.switches.len() as i64),
        ],
    )
}
