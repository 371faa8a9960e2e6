//! The beam by the switches of a mandrel, or where they are to be expected and how well they will tell it.

use super::beam::nominal_beam;
use crate::SkivingError;
use crate::job::{CalibrationMove, LightBarrier, MandrelCalibration};
use crate::measuring::{Approach, Beam, BeamLine, Calibration, Mandrel, Observation};
use crate::workflow::finding::failure;
use crate::workflow::result::{CalibrationResult, MandrelSwitchResult};
use nalgebra::{Vector2, Vector3};
use run::RunFailure;

/// A calibration and what it says.
#[derive(Clone, Debug)]
pub struct CalibrationOutcome {
    /// The beam that the switches tell; `None` where they are only expected.
    pub beam: Option<Beam>,
    /// Standard deviation of a switch, um.
    pub noise_um: f64,
    /// How the mandrel is driven into the beam.
    pub drive: MandrelDrive,
    /// Figures.
    pub result: CalibrationResult,
}

/// A mandrel and how it is driven into the beam.
#[derive(Clone, Debug, PartialEq)]
pub struct MandrelDrive {
    /// The mandrel.
    pub mandrel: Mandrel,
    /// Z of its lower face, at two heights.
    pub heights: [f64; 2],
    /// From the spindle's origin to its lower face, mm; that of the tool where it is not given.
    pub length: Option<f64>,
    /// Turns of the spindle, evenly spaced.
    pub spindle_positions: usize,
    /// Speed, mm/s.
    pub speed: f64,
    /// How far the beam may be from where it is given, mm.
    pub reach: f64,
}

/// What the mandrel keeps from the beam before it is driven in, mm.
const BESIDE: f64 = 5.0;

/// Fits the beam to the switches of a job, or works out those that the job's beam will give.
///
/// # Errors
/// [`RunFailure`]: the switches do not tell five unknowns apart, or the mandrel does not meet the beam.
pub(super) fn calibrate(
    barrier: &LightBarrier,
    given: &MandrelCalibration,
) -> Result<CalibrationOutcome, RunFailure> {
    let on = |error: SkivingError| failure(&error);
    let beam = nominal_beam(barrier).map_err(on)?;
    let nominal = line_of(&beam);
    let mandrel = Mandrel { radius: given.radius, height: given.height };
    let measured = !given.switches.is_empty();
    let seen = if measured { switches(given) } else { expected(&mandrel, &nominal, given).map_err(on)? };
    let start = if measured {
        let along_x: Vec<f64> = seen.iter().filter(|o| o.along == Approach::X).map(|o| o.place.x).collect();
        let mean = along_x.iter().sum::<f64>() / along_x.len().max(1) as f64;
        Calibration::start(&mandrel, &seen, beam.radius, mean > beam.point.x).map_err(on)?
    } else {
        nominal
    };
    let fitted = Calibration::fit(&mandrel, &seen, &start).map_err(on)?;
    let height = beam.point.z;
    let at = fitted.line.at(height);
    let [x, y, delta, eps, radius] = fitted.deviations_at(height).map(|d| 1e-3 * given.noise_um * d);
    let [delta_deg, eps_deg] = [fitted.line.slope.x, fitted.line.slope.y].map(|t| t.atan().to_degrees());
    // d(atan t) = dt/(1 + t^2).
    let angle = |tangent: f64, sigma: f64| (sigma / (1.0 + tangent * tangent)).to_degrees();
    let result = CalibrationResult {
        measured,
        point_mm: [at.x, at.y, height],
        tilt_x_deg: delta_deg,
        tilt_y_deg: eps_deg,
        radius_mm: fitted.line.radius,
        point_sigma_um: [1e3 * x, 1e3 * y],
        tilt_sigma_deg: [angle(fitted.line.slope.x, delta), angle(fitted.line.slope.y, eps)],
        radius_sigma_um: 1e3 * radius,
        residual_um: 1e3 * fitted.residual,
        switches: seen.iter().map(switch_result).collect(),
    };
    let point = Vector3::new(at.x, at.y, height);
    let found = || {
        let slope = fitted.line.slope;
        match barrier.direction {
            Some(_) => Beam::along(point, slope.push(1.0), fitted.line.radius),
            None => Beam::new(point, [slope.x.atan(), slope.y.atan()], fitted.line.radius),
        }
    };
    let beam = measured.then(found).transpose().map_err(on)?;
    let low = seen.iter().map(|o| o.place.z).fold(f64::INFINITY, f64::min);
    let high = seen.iter().map(|o| o.place.z).fold(f64::NEG_INFINITY, f64::max);
    let drive = MandrelDrive {
        mandrel,
        heights: given.heights.unwrap_or([low, high]),
        length: given.mandrel_length,
        spindle_positions: given.spindle_positions,
        speed: given.speed_mm_per_min / 60.0,
        reach: given.reach,
    };
    Ok(CalibrationOutcome { beam, noise_um: given.noise_um, drive, result })
}

fn line_of(beam: &Beam) -> BeamLine {
    let slope = beam.direction.xy() / beam.direction.z;
    BeamLine { point: beam.point.xy() - slope * beam.point.z, slope, radius: beam.radius }
}

fn switches(given: &MandrelCalibration) -> Vec<Observation> {
    let observation = |switch: &crate::job::MandrelSwitch| Observation {
        place: Vector3::from(switch.place),
        along: match switch.along {
            CalibrationMove::X => Approach::X,
            CalibrationMove::Y => Approach::Y,
        },
    };
    given.switches.iter().map(observation).collect()
}

/// At each height through the beam along Y, and into it along X from the side of smaller X.
fn expected(
    mandrel: &Mandrel,
    line: &BeamLine,
    given: &MandrelCalibration,
) -> Result<Vec<Observation>, SkivingError> {
    let mut seen = Vec::new();
    for z in given.heights.into_iter().flatten() {
        let centre: Vector2<f64> = line.at(z + 0.5 * mandrel.height);
        let far = mandrel.radius
            + line.radius * line.slope.norm().hypot(1.0)
            + mandrel.height * line.slope.norm()
            + BESIDE;
        let middle = Vector3::new(centre.x, centre.y, z);
        for (along, axis) in
            [(Approach::Y, Vector3::y()), (Approach::Y, -Vector3::y()), (Approach::X, Vector3::x())]
        {
            let place = mandrel
                .switch(line, &(middle - axis * far), &axis, [0.0, far])
                .ok_or(SkivingError::CalibrationSingular { reason: "the mandrel does not meet the beam" })?;
            seen.push(Observation { place, along });
        }
    }
    Ok(seen)
}

fn switch_result(seen: &Observation) -> MandrelSwitchResult {
    let along = match seen.along {
        Approach::X => "X",
        Approach::Y => "Y",
    };
    MandrelSwitchResult { along, place_mm: seen.place.into() }
}
