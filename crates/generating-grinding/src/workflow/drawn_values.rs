//! The values of a drawing as made: traces of the simulated flank and of the target where the drawing has them, evaluated as `inspect`
//! evaluates a measured gear (`docs/mathematics/inspection.md#one-trace`).

use super::execution::Execution;
use super::prepare::Prepared;
use super::referee::{Cutting, Verdict, rays_at};
use super::result::FlankResult;
use foundation::geometry::Flank;
use foundation::modification::{EvaluationField, ModificationSpec as Spec, Reference, ReliefSpec};
use foundation::numerics::equidistant;
use metrology::inspection::{
    EvaluationRange, InspectionError, SlopeReference, SlopeRule, SlopeSign, TraceEvaluation, TraceSamples,
    evaluate_trace,
};
use referee::{RayGrid, RemovalError};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use verdict::{Remark, Verdict as RunVerdict};

/// Samples of a trace, at least and at most, and those that the shortest relief is to have.
const SAMPLES: [usize; 2] = [81, 401];
const SAMPLES_OF_RELIEF: f64 = 12.0;

/// The direction of a trace.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum TraceDirection {
    /// Along the length of roll.
    Profile,
    /// Along the face width.
    Helix,
}

/// A value that drawings state, transverse; > 0 material removed.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DrawnValue {
    /// Symbol of ISO 21771: `C_alpha`, `C_Halpha`, `C_alpha_a` (tip), `C_alpha_f` (root), `C_beta`, `C_Hbeta`, `C_beta_I`, `C_beta_II`.
    pub symbol: &'static str,
    /// Amount in the drawing, over the whole evaluated length; absent where it names none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub drawn_um: Option<f64>,
    /// The target, evaluated as the flank is.
    pub target_um: f64,
    /// The simulated flank.
    pub made_um: f64,
}

/// A trace of the simulated flank. um, transverse.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TraceResult {
    /// Its direction.
    pub direction: TraceDirection,
    /// Face position of a profile, length of roll of a helix.
    pub position_mm: f64,
    /// Evaluated length: lengths of roll or face positions.
    pub range_mm: [f64; 2],
    /// The part of it without reliefs, for which crowning and slope stand.
    pub unrelieved_mm: [f64; 2],
    /// F: range of simulated - target.
    pub total_um: f64,
    /// f_f: range of what is left beside its line by least squares.
    pub form_um: f64,
    /// f_H: rise of that line over the evaluated length, > 0 towards the tip or face II.
    pub slope_um: f64,
    /// Largest |simulated - target| over the tolerance at its place.
    pub tolerance_share: f64,
    /// What the drawing states, as made.
    pub values: Vec<DrawnValue>,
    /// Values that the trace does not tell, each with the reason.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub not_evaluated: Vec<String>,
}

/// A relief at one end of a trace.
struct Relief {
    symbol: &'static str,
    /// Whether it stands at the end with the greater abscissa.
    at_end: bool,
    /// Amount, um, transverse; length and rounding of its start, mm.
    amount: f64,
    length: f64,
    transition: f64,
}

/// Where a relief stands: its symbol, its amount, um, and its ends on the trace, the near one first, mm.
struct Zone {
    symbol: &'static str,
    amount: f64,
    ends: [f64; 2],
}

/// What a drawing states along one direction.
struct Drawn {
    direction: TraceDirection,
    crowning: Option<f64>,
    slope: Option<f64>,
    reliefs: Vec<Relief>,
}

impl Drawn {
    fn of(direction: TraceDirection, specs: &[Spec], flank: Flank, field: &EvaluationField) -> Self {
        let mut drawn = Self { direction, crowning: None, slope: None, reliefs: Vec::new() };
        specs.iter().filter(|spec| spec.flank().includes(flank)).for_each(|spec| drawn.take(spec, field));
        drawn
    }

    fn take(&mut self, spec: &Spec, field: &EvaluationField) {
        let to_transverse = match spec.reference() {
            Reference::Normal => field.normal_factor().recip(),
            Reference::Transverse => 1.0,
        };
        let add = |sum: &mut Option<f64>, um: f64| *sum = Some(sum.unwrap_or(0.0) + um * to_transverse);
        let mut relief = |symbol, at_end, s: &ReliefSpec| {
            self.reliefs.push(Relief {
                symbol,
                at_end,
                amount: s.amount_um * to_transverse,
                length: s.length_mm,
                transition: s.transition_mm,
            });
        };
        match (self.direction, spec) {
            (TraceDirection::Profile, Spec::ProfileCrowning(s)) => add(&mut self.crowning, s.amount_um),
            (TraceDirection::Helix, Spec::HelixCrowning(s)) => add(&mut self.crowning, s.amount_um),
            (TraceDirection::Profile, Spec::ProfileSlope(s)) => add(&mut self.slope, s.amount_um),
            (TraceDirection::Helix, Spec::HelixSlope(s)) => add(&mut self.slope, s.amount_um),
            (TraceDirection::Profile, Spec::TipRelief(s)) => relief("C_alpha_a", true, s),
            (TraceDirection::Profile, Spec::RootRelief(s)) => relief("C_alpha_f", false, s),
            (TraceDirection::Helix, Spec::EndReliefI(s) | Spec::EndReliefNonDatumFace(s)) => {
                relief("C_beta_I", false, s);
            }
            (TraceDirection::Helix, Spec::EndReliefII(s) | Spec::EndReliefDatumFace(s)) => {
                relief("C_beta_II", true, s);
            }
            (_, Spec::Sum(sum)) => sum.children.iter().for_each(|child| self.take(child, field)),
            _ => {}
        }
    }

    /// The part of a range without reliefs, and the zones of those that stand at its ends.
    fn zones(&self, [from, to]: [f64; 2]) -> ([f64; 2], Vec<Zone>) {
        let mut rest = [from, to];
        let mut zones: Vec<Zone> = Vec::new();
        for relief in &self.reliefs {
            let [rounded, straight] = [relief.length + relief.transition, relief.length - relief.transition];
            let (near, far) = match relief.at_end {
                true => {
                    rest[1] = rest[1].min(to - rounded);
                    (to - straight.max(0.0), to)
                }
                false => {
                    rest[0] = rest[0].max(from + rounded);
                    (from + straight.max(0.0), from)
                }
            };
            match zones.iter_mut().find(|zone| zone.symbol == relief.symbol) {
                // Two at one end are measured as one, where both are.
                Some(zone) => {
                    zone.amount += relief.amount;
                    if (far - near).abs() < (far - zone.ends[0]).abs() {
                        zone.ends[0] = near;
                    }
                }
                None => zones.push(Zone { symbol: relief.symbol, amount: relief.amount, ends: [near, far] }),
            }
        }
        (rest, zones)
    }

    /// So many samples that the shortest relief has enough of them.
    fn samples(&self, length: f64) -> usize {
        let [least, most] = SAMPLES;
        let zones = self.reliefs.iter().map(|relief| relief.length - relief.transition);
        let shortest = zones.filter(|zone| *zone > 0.0).fold(length, f64::min);
        ((SAMPLES_OF_RELIEF * length / shortest).ceil() as usize + 1).clamp(least, most)
    }
}

/// A trace before it is evaluated: abscissae, mm, with simulated flank and target, transverse, mm.
struct Sampled {
    position: f64,
    a: Vec<f64>,
    made: Vec<f64>,
    target: Vec<f64>,
    tolerance_share: f64,
}

/// Evaluates the traces of a flank that the drawing has values for.
///
/// # Errors
/// Those of the rays.
pub fn drawn_values(
    prepared: &Prepared,
    execution: &Execution,
    (flank, verdict): (Flank, &Verdict),
    cutting: Cutting<'_>,
) -> Result<Vec<TraceResult>, RemovalError> {
    let setup = &prepared.setup;
    let (field, places) = (&setup.fields[flank], &prepared.traces[flank]);
    let Some(target) = &prepared.targets[flank] else { return Ok(Vec::new()) };
    let cos = setup.lines[flank].cos_b2;
    let mut results = Vec::new();
    for direction in [TraceDirection::Profile, TraceDirection::Helix] {
        let drawn = Drawn::of(direction, &prepared.drawn, flank, field);
        let (range, positions) = match direction {
            TraceDirection::Profile => (field.roll(), &places.profile_z),
            TraceDirection::Helix => (field.face(), &places.helix_w),
        };
        let a = equidistant(range, drawn.samples(range[1] - range[0]));
        let grid = match direction {
            TraceDirection::Profile => RayGrid::new(a.clone(), positions.clone())?,
            TraceDirection::Helix => RayGrid::new(positions.clone(), a.clone())?,
        };
        let Some(rays) = rays_at(setup, execution, (flank, verdict), cutting, &grid)? else { continue };
        for (k, &position) in positions.iter().enumerate() {
            let mut sampled = Sampled {
                position,
                a: a.clone(),
                made: Vec::new(),
                target: Vec::new(),
                tolerance_share: 0.0,
            };
            for (i, &a) in a.iter().enumerate() {
                let ((w, z), ray) = match direction {
                    TraceDirection::Profile => ((a, position), rays[i * positions.len() + k]),
                    TraceDirection::Helix => ((position, a), rays[k * sampled.a.len() + i]),
                };
                // The target was evaluated on the whole field; a formula may be undefined beside its grid.
                let wanted = target.value(w, z).unwrap_or(f64::NAN);
                let share = (ray - wanted * cos).abs() / prepared.tolerance.value(w, z);
                sampled.tolerance_share = sampled.tolerance_share.max(share);
                sampled.made.push(ray / cos);
                sampled.target.push(wanted);
            }
            results.extend(evaluated(&drawn, flank, range, sampled));
        }
    }
    Ok(results)
}

/// A trace with its values; `None` where it cannot be evaluated at all.
fn evaluated(drawn: &Drawn, flank: Flank, range: [f64; 2], sampled: Sampled) -> Option<TraceResult> {
    let length = range[1] - range[0];
    let rule = SlopeRule { flank, sign: SlopeSign::Material, reference: SlopeReference::Given(length) };
    let samples = |f: &[f64]| TraceSamples::new(sampled.a.clone(), f.to_vec());
    let difference: Vec<f64> = sampled.made.iter().zip(&sampled.target).map(|(m, t)| m - t).collect();
    let whole = EvaluationRange::new(range[0], range[1]).ok()?;
    let against = evaluate_trace(&samples(&difference).ok()?, whole, rule).ok()?;
    let (made, target) = (samples(&sampled.made).ok()?, samples(&sampled.target).ok()?);
    let (unrelieved, zones) = drawn.zones(range);
    let mut result = TraceResult {
        direction: drawn.direction,
        position_mm: sampled.position,
        range_mm: range,
        unrelieved_mm: unrelieved,
        total_um: against.total * 1e3,
        form_um: against.form * 1e3,
        slope_um: against.slope.material() * 1e3,
        tolerance_share: sampled.tolerance_share,
        values: Vec::new(),
        not_evaluated: Vec::new(),
    };
    let within = |trace: &TraceSamples| {
        EvaluationRange::new(unrelieved[0], unrelieved[1])
            .and_then(|range| evaluate_trace(trace, range, rule))
    };
    let both = within(&made).and_then(|made| Ok((made, within(&target)?)));
    let (made_in, target_in) = match both {
        Ok(both) => both,
        Err(reason) => {
            result.not_evaluated.push(format!("between the reliefs: {reason}"));
            return Some(result);
        }
    };
    let [crowning, slope] = match drawn.direction {
        TraceDirection::Profile => ["C_alpha", "C_Halpha"],
        TraceDirection::Helix => ["C_beta", "C_Hbeta"],
    };
    let of =
        |evaluation: &TraceEvaluation| [evaluation.crowning.height * 1e3, -evaluation.slope.material() * 1e3];
    let ([made_crowning, made_slope], [target_crowning, target_slope]) = (of(&made_in), of(&target_in));
    result.values.extend([
        DrawnValue {
            symbol: crowning,
            drawn_um: drawn.crowning,
            target_um: target_crowning,
            made_um: made_crowning,
        },
        DrawnValue { symbol: slope, drawn_um: drawn.slope, target_um: target_slope, made_um: made_slope },
    ]);
    for Zone { symbol, amount, ends } in zones {
        let relief = |trace: &TraceSamples, within: &TraceEvaluation| -> Result<f64, InspectionError> {
            Ok(-within.relief(trace, ends)?.amount * 1e3)
        };
        match relief(&made, &made_in).and_then(|m| Ok((m, relief(&target, &target_in)?))) {
            Ok((made_um, target_um)) => {
                result.values.push(DrawnValue { symbol, drawn_um: Some(amount), target_um, made_um });
            }
            Err(reason) => result.not_evaluated.push(format!("{symbol}: {reason}")),
        }
    }
    Some(result)
}

/// Judges the traces: their rays stand closer than those of the field.
pub(super) fn judge_traces(
    verdict: &mut RunVerdict,
    flanks: &BTreeMap<&'static str, FlankResult>,
    missed: impl Fn() -> Remark,
) {
    for (name, flank) in flanks {
        let shares = flank.traces.iter().map(|trace| trace.tolerance_share);
        let Some(worst) = shares.reduce(f64::max) else { continue };
        let item = format!("traces of the {name} flank where the drawing has them");
        let detail = format!("{worst:.3} of the tolerance on {} traces", flank.traces.len());
        verdict.judge(item, worst <= 1.0, detail, &missed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn linear(amount: f64, length: f64, transition: f64, symbol: &'static str, at_end: bool) -> Relief {
        Relief { symbol, at_end, amount, length, transition }
    }

    /// A helix trace with crowning, slope and both end reliefs; what is made has half as much of each.
    #[test]
    fn values_are_read_between_and_on_the_reliefs() {
        let reliefs =
            vec![linear(20.0, 5.0, 0.0, "C_beta_I", false), linear(12.0, 4.0, 0.0, "C_beta_II", true)];
        let drawn =
            Drawn { direction: TraceDirection::Helix, crowning: Some(8.0), slope: Some(6.0), reliefs };
        let range = [-20.0, 20.0];
        let a = equidistant(range, drawn.samples(40.0));
        let f = |z: f64| {
            -1e-3
                * (20.0 * (-15.0 - z).max(0.0) / 5.0
                    + 12.0 * (z - 16.0).max(0.0) / 4.0
                    + 6.0 * (z + 20.0) / 40.0)
        };
        let target: Vec<f64> = a.iter().map(|&z| f(z)).collect();
        let made = target.iter().map(|t| 0.5 * t).collect();
        let sampled = Sampled { position: 9.0, a, made, target, tolerance_share: 0.3 };
        let result = evaluated(&drawn, Flank::Left, range, sampled).unwrap();
        assert_eq!((result.unrelieved_mm, &result.not_evaluated), ([-15.0, 16.0], &Vec::new()));
        let value = |symbol: &str| result.values.iter().find(|value| value.symbol == symbol).unwrap();
        for (symbol, wanted) in [("C_beta", 0.0), ("C_Hbeta", 6.0), ("C_beta_I", 20.0), ("C_beta_II", 12.0)] {
            let value = value(symbol);
            assert!((value.target_um - wanted).abs() < 1e-9, "{symbol}: {value:?}");
            assert!((value.made_um - 0.5 * wanted).abs() < 1e-9, "{symbol}: {value:?}");
        }
        assert_eq!(value("C_beta").drawn_um, Some(8.0));
    }

    #[test]
    fn reliefs_that_leave_nothing_between_them_are_said() {
        let reliefs =
            vec![linear(5.0, 25.0, 0.0, "C_beta_I", false), linear(5.0, 25.0, 0.0, "C_beta_II", true)];
        let drawn = Drawn { direction: TraceDirection::Helix, crowning: None, slope: None, reliefs };
        let a = equidistant([-20.0, 20.0], 81);
        let flat = vec![0.0; 81];
        let sampled = Sampled { position: 9.0, a, made: flat.clone(), target: flat, tolerance_share: 0.0 };
        let result = evaluated(&drawn, Flank::Left, [-20.0, 20.0], sampled).unwrap();
        assert!(result.values.is_empty() && result.not_evaluated.len() == 1, "{result:?}");
    }
}
