//! Errors of scale, ball screw and encoder of a job, part by part.

use crate::job::{BallScrewErrors, GearboxErrors, ScaleErrors, WorkpieceEncoderErrors};
use control::{ControlError, EncoderErrors, EncoderWave, LineErrors, LineWave};
use run::RunFailure;
use run::control::control_refused;

/// Millimetres.
const UM: f64 = 1e-3;

/// A part of the errors of lines, with its name.
#[derive(Clone, Debug)]
pub struct LinePart {
    /// What it is.
    pub name: &'static str,
    /// Its errors alone.
    pub lines: LineErrors,
}

/// A part of the errors of the encoder.
#[derive(Clone, Debug)]
pub struct EncoderPart {
    /// What it is.
    pub name: &'static str,
    /// Its errors alone.
    pub errors: EncoderErrors,
}

/// What is measured wrongly.
#[derive(Clone, Debug, Default)]
pub struct Measured {
    /// All errors of the lines.
    pub lines: LineErrors,
    /// The same in parts.
    pub line_parts: Vec<LinePart>,
    /// All errors of the encoder; `None` where the job gives none.
    pub encoder: Option<EncoderErrors>,
    /// The same in parts.
    pub encoder_parts: Vec<EncoderPart>,
}

impl Measured {
    /// Of a table.
    ///
    /// # Errors
    /// [`RunFailure`] on keys of `errors`: lines that would change places.
    pub(super) fn of_job(given: Option<&GearboxErrors>) -> Result<Self, RunFailure> {
        let Some(given) = given else { return Ok(Self::default()) };
        let mut measured = Self::default();
        if let Some(scale) = &given.scale {
            let refused = |error: ControlError| control_refused(&error, "errors.scale");
            (measured.lines, measured.line_parts) = of_scale(scale).map_err(refused)?;
        }
        if let Some(screw) = &given.ball_screw {
            let refused = |error: ControlError| control_refused(&error, "errors.ball_screw");
            (measured.lines, measured.line_parts) = of_screw(screw).map_err(refused)?;
        }
        if let Some(encoder) = &given.encoder {
            let refused = |error: ControlError| control_refused(&error, "errors.encoder");
            let (errors, parts) = of_encoder(encoder).map_err(refused)?;
            (measured.encoder, measured.encoder_parts) = (Some(errors), parts);
        }
        Ok(measured)
    }
}

fn of_scale(scale: &ScaleErrors) -> Result<(LineErrors, Vec<LinePart>), ControlError> {
    let slope = 1e-6 * scale.slope_um_per_m;
    let waves: Vec<LineWave> = scale
        .periodic
        .iter()
        .map(|wave| LineWave {
            amplitude: UM * wave.amplitude_um,
            period: wave.period_mm,
            phase: wave.phase_deg.to_radians(),
        })
        .collect();
    let mut parts = Vec::new();
    if slope != 0.0 {
        parts.push(LinePart { name: "slope of the scale", lines: LineErrors::new(slope, vec![], 0.0)? });
    }
    if !waves.is_empty() {
        let lines = LineErrors::new(0.0, waves.clone(), 0.0)?;
        parts.push(LinePart { name: "periodic errors of the scale", lines });
    }
    Ok((LineErrors::new(slope, waves, 0.0)?, parts))
}

fn of_screw(screw: &BallScrewErrors) -> Result<(LineErrors, Vec<LinePart>), ControlError> {
    let slope = UM * screw.travel_um_per_300mm / 300.0;
    let wobble = LineWave {
        amplitude: UM * screw.wobble_um,
        period: screw.lead_mm,
        phase: screw.wobble_phase_deg.to_radians(),
    };
    let backlash = UM * screw.backlash_um;
    let parts = vec![
        LinePart { name: "travel deviation of the ball screw", lines: LineErrors::new(slope, vec![], 0.0)? },
        LinePart { name: "wobble of the ball screw", lines: LineErrors::new(0.0, vec![wobble], 0.0)? },
        LinePart { name: "backlash of the ball screw", lines: LineErrors::new(0.0, vec![], backlash)? },
    ];
    Ok((LineErrors::new(slope, vec![wobble], backlash)?, parts))
}

fn of_encoder(encoder: &WorkpieceEncoderErrors) -> Result<(EncoderErrors, Vec<EncoderPart>), ControlError> {
    let eccentric = EncoderWave {
        order: 1,
        amplitude: UM * encoder.eccentricity_um / encoder.radius_mm,
        phase: encoder.eccentricity_phase_deg.to_radians(),
    };
    let graduation = encoder.periodic.iter().map(|wave| EncoderWave {
        order: wave.order,
        amplitude: (wave.amplitude_arcsec / 3600.0).to_radians(),
        phase: wave.phase_deg.to_radians(),
    });
    let graduation: Vec<EncoderWave> = graduation.collect();
    let mut parts = Vec::new();
    if encoder.eccentricity_um > 0.0 {
        let errors = EncoderErrors::new(vec![eccentric])?;
        parts.push(EncoderPart { name: "eccentricity of the encoder", errors });
    }
    if !graduation.is_empty() {
        let errors = EncoderErrors::new(graduation.clone())?;
        parts.push(EncoderPart { name: "graduation of the encoder", errors });
    }
    Ok((EncoderErrors::new([vec![eccentric], graduation].concat())?, parts))
}
