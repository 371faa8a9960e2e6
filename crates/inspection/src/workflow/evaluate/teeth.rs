//! What is measured on every tooth: pitch, run-out, eccentricity, thickness. mm, rad

use super::{EvaluatedPitch, LeftOut};
use foundation::geometry::{Flank, Gear, GearData, Sides};
use measured_files::inspection::{CountingDirection, Inspection};
use metrology::inspection::{
    BallContact, Eccentricity, FlankAngles, InspectionError, MeasuredThickness, PitchDeviations,
    ProbePosition, ThicknessSizes, eccentricity, measured_thickness, pitch_from_positions,
    run_out_from_pitch, thickness_variation,
};

/// What a measuring machine rounds values to, mm.
const PRINTED: f64 = 1e-4;

/// What the sizes say of the thickness.
pub(super) fn thickness(inspection: &Inspection, left_out: &mut LeftOut) -> MeasuredThickness {
    let measured = &inspection.thickness;
    let sizes = ThicknessSizes {
        span: measured.span_teeth.zip(measured.span.and_then(|size| size.mean_mm)),
        balls: measured.ball_diameter_mm.zip(measured.over_balls.and_then(|size| size.mean_mm)),
    };
    let gear = &inspection.gear;
    let data = GearData {
        teeth: gear.teeth,
        normal_module: gear.normal_module_mm,
        pressure_angle: Sides::both(gear.normal_pressure_angle_deg.to_radians()),
        helix_angle: gear.helix_angle_deg.to_radians(),
        profile_shift: 0.0,
        cone_angle: 0.0,
    };
    let none = MeasuredThickness { by_span: None, by_balls: None, warning: None };
    left_out.take("thickness", measured_thickness(data, &sizes)).unwrap_or(none)
}

/// Everything that the pitches tell; `gear` with its measured thickness, where that is known.
pub(super) fn pitch(
    inspection: &Inspection,
    nominal: &Gear,
    measured: Option<&Gear>,
    left_out: &mut LeftOut,
) -> Option<EvaluatedPitch> {
    let table = inspection.pitch.as_ref()?;
    let teeth = inspection.gear.teeth.unsigned_abs() as usize;
    let mut of_flank = |flank: Flank| {
        let single = table.flanks[flank].as_ref()?.fp_um.iter().map(|um| 1e-3 * um).collect();
        let found = PitchDeviations::new(single, teeth)
            .and_then(|pitch| Ok((pitch.evaluate(None)?, pitch.printed_single_range(PRINTED))));
        left_out.take(&format!("pitch, {flank} flank"), found)
    };
    let found = Sides { left: of_flank(Flank::Left), right: of_flank(Flank::Right) };
    let printed_range = found.map(|_, of| of.as_ref().map(|(_, range)| *range));
    let flanks = found.map(|_, of| of.as_ref().map(|(evaluation, _)| evaluation.clone()));
    // Run-out, eccentricity and thickness variation pair the flanks of neighbouring teeth in the sense in which the machine counted them,
    // so that they are evaluated as it saw the gear.
    let turned = inspection.conditions.turned;
    let seen = |flank: Flank| if turned { flank.other() } else { flank };
    let cumulative = |flank: Flank| flanks[seen(flank)].as_ref().map(|of| of.cumulative.clone());
    let both = cumulative(Flank::Left).zip(cumulative(Flank::Right));
    let both = both.map(|(left, right)| Sides { left, right });
    let clockwise = match table.counting {
        Some(CountingDirection::Clockwise) => !turned,
        Some(CountingDirection::CounterClockwise) => turned,
        None => false,
    };
    let both = if clockwise {
        let setting = "teeth counted clockwise";
        left_out.0.push(("run-out and eccentricity".into(), InspectionError::UnverifiedSetting { setting }));
        None
    } else {
        both
    };
    let ball = inspection.thickness.ball_diameter_mm;
    let run_out = both.as_ref().zip(measured).zip(ball).and_then(|((cumulative, gear), ball)| {
        let found = BallContact::of(gear, ball).and_then(|contact| run_out_from_pitch(cumulative, &contact));
        left_out.take("run-out", found)
    });
    let eccentric = both.as_ref().zip(measured).and_then(|(cumulative, gear)| {
        let found = left_out.take("eccentricity", eccentricity(cumulative, &FlankAngles::of(gear)))?;
        let without = Sides::from_fn(|flank| found.cumulative_without[seen(flank)].clone());
        let y = if turned { -found.y } else { found.y };
        Some(Eccentricity { y, cumulative_without: without, ..found })
    });
    let positions = table.diameter_mm.filter(|_| !table.positions.is_empty() && !clockwise);
    let from_positions = positions.and_then(|diameter| {
        let position = |read: &measured_files::inspection::ProbePosition| ProbePosition {
            flank: read.flank,
            number: read.number as usize,
            table_angle: read.angle_deg.to_radians(),
            x: read.centre_mm[0],
            y: read.centre_mm[1],
        };
        let positions: Vec<ProbePosition> = table.positions.iter().map(position).collect();
        let found = pitch_from_positions(&positions, nominal, diameter);
        let found = left_out.take("pitch from probe positions", found)?;
        Some(Sides::from_fn(|flank| found[seen(flank)].clone()))
    });
    Some(EvaluatedPitch {
        thickness_variation: both.as_ref().map(thickness_variation),
        run_out,
        eccentricity: eccentric,
        from_positions,
        printed_range,
        flanks,
    })
}
