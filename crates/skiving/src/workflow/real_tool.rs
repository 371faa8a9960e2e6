//! The tool of `[tool_errors]`: errors of the whole tool, of every tooth by chance, of single teeth.

use super::prepare::SkivingBodies;
use crate::job::{EdgeErrorsUm, ToolErrors};
use crate::measuring::{EdgeErrors, Noise, RealTool};
use foundation::geometry::{Flank, Sides};
use job::Diagnostic;
use run::RunFailure;

/// Places along an edge at which its rounding must not vanish.
const PLACES: usize = 41;
/// Coefficients of 1, x and x^2 that chance adds to a profile.
const RANDOM_COEFFICIENTS: usize = 3;

/// The tool with its errors.
///
/// # Errors
/// A rounding that would have a radius below 0.
pub(super) fn real_tool(bodies: &SkivingBodies, errors: &ToolErrors) -> Result<RealTool, RunFailure> {
    let teeth = bodies.teeth();
    let radius = bodies.pair.tool().pitch_radius();
    let mut tool = RealTool::ideal(teeth);
    tool.eccentricity = errors.eccentricity_um.map(|um| 1e-3 * um);
    tool.wobble = errors.wobble_urad.map(|urad| 1e-6 * urad);
    for (pitch, um) in tool.pitch.iter_mut().zip(&errors.pitch_um) {
        *pitch += 1e-3 * um / radius;
    }
    let none = || Sides::both(Vec::new());
    let profile = errors.profile_um.as_ref().map_or_else(none, |given| given.sides());
    let growth = errors.edge_growth_um.as_ref().map_or_else(none, |given| given.sides());
    for flank in Flank::BOTH {
        for edge in &mut tool.edges[flank] {
            add(&mut edge.profile, &profile[flank]);
            add(&mut edge.growth, &growth[flank]);
        }
    }
    if let Some(random) = &errors.random {
        let mut noise = Noise::new(random.seed);
        for tooth in 0..teeth {
            tool.pitch[tooth] += 1e-3 * random.pitch_um * noise.normal() / radius;
            for flank in Flank::BOTH {
                let edge = &mut tool.edges[flank][tooth];
                let draw: Vec<f64> =
                    (0..RANDOM_COEFFICIENTS).map(|_| random.profile_um * noise.normal()).collect();
                add(&mut edge.profile, &draw);
                add(&mut edge.growth, &[random.edge_growth_um * noise.normal()]);
            }
        }
    }
    for one in &errors.teeth {
        tool.broken[one.tooth] |= one.broken;
        tool.pitch[one.tooth] += 1e-3 * one.pitch_um / radius;
        for (flank, given) in [(Flank::Left, &one.left), (Flank::Right, &one.right)] {
            let Some(EdgeErrorsUm { profile_um, edge_growth_um }) = given else { continue };
            let edge = &mut tool.edges[flank][one.tooth];
            add(&mut edge.profile, profile_um);
            add(&mut edge.growth, edge_growth_um);
        }
    }
    check_rounding(bodies, &tool)?;
    Ok(tool)
}

/// Adds coefficients in um to coefficients in mm.
fn add(coefficients: &mut Vec<f64>, um: &[f64]) {
    if coefficients.len() < um.len() {
        coefficients.resize(um.len(), 0.0);
    }
    coefficients.iter_mut().zip(um).for_each(|(sum, um)| *sum += 1e-3 * um);
}

fn check_rounding(bodies: &SkivingBodies, tool: &RealTool) -> Result<(), RunFailure> {
    let radius = bodies.pair.tool().rounding().radius;
    let least = |edge: &EdgeErrors| {
        let places = foundation::numerics::equidistant([-1.0, 1.0], PLACES);
        places.into_iter().map(|x| edge.growth_at(x)).fold(f64::INFINITY, f64::min)
    };
    for (flank, edges) in tool.edges.iter() {
        let found = edges.iter().map(least).enumerate().find(|(_, growth)| radius + growth < 0.0);
        if let Some((tooth, growth)) = found {
            let message =
                format!("the {flank} edge of tooth {tooth} would have a rounding of less than nothing");
            let finding = Diagnostic::with_code("invalid-number", message)
                .field("tool_errors.edge_growth_um")
                .value(1e3 * growth)
                .allowed(format!(">= {} um, the rounding's own radius", -1e3 * radius))
                .way_out("give a smaller reduction of the rounding, or a larger `edge_radius`");
            return Err(RunFailure::bad_input(finding));
        }
    }
    Ok(())
}
