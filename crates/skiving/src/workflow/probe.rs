//! The machined workpiece under a probe in the tool spindle: profiles of some tooth spaces, simulated or read, and the correction of the
//! setting that answers them.

use super::finding::failure;
use super::measurement::Measurement;
use super::outcome::correction;
use super::prepare::{PreparedSkiving, SkivingBodies};
use super::referee::{Law, Left, corrected, skived_at};
use super::result::{ProbeResult, ProbedFlankResult};
use crate::job::WorkpieceProbe;
use crate::measuring::{Noise, RealTool};
use crate::probe_readings::{ProbeValue, read_probe_values};
use crate::runout::PeriodicLaw;
use crate::{SettingFit, SkivingError, fit_setting, setting_sensitivity};
use foundation::geometry::{Flank, Sides};
use foundation::kinematics::SkivingMotion;
use foundation::numerics::{Progress, equidistant};
use job::{Diagnostic, Problem};
use run::{JobFailure, RunFailure};
use std::collections::BTreeMap;

/// A measured workpiece.
#[derive(Clone, Debug)]
pub struct Probed {
    /// Values of the probe, in the order in which they are taken.
    pub values: Vec<ProbeValue>,
    /// Whether they are simulated.
    pub simulated: bool,
    /// Figures.
    pub result: ProbeResult,
}

/// What a profile is left out at each end, in shares of the evaluated roll: beside the end of the edge nothing is made.
const ENDS: f64 = 0.01;
/// Values that a profile needs to tell a setting.
const LEAST: usize = 3;

/// Lengths of roll at which both flanks are scanned, mm.
pub(super) fn lengths(bodies: &SkivingBodies, places: usize) -> Sides<Vec<f64>> {
    bodies.edges.map(|_, edge| {
        let [from, to] = edge.flank().range();
        let inset = ENDS * (to - from);
        equidistant([from + inset, to - inset], places)
    })
}

/// The probe of a job; none without its table.
///
/// # Errors
/// [`JobFailure`]: a table that cannot be read or is of other tooth spaces, edges that do not come by.
pub(super) fn probed(
    prepared: &PreparedSkiving,
    measurement: Option<&Measurement>,
    law: Option<&PeriodicLaw>,
    progress: &dyn Progress,
) -> Result<Option<Probed>, JobFailure> {
    let Some(given) = &prepared.probe else { return Ok(None) };
    let bodies = &prepared.bodies;
    let machined = Machined::new(bodies, measurement, law);
    let lengths = lengths(bodies, given.places);
    let shown = measurement.map_or([0.0; 4], |m| m.correction.change);
    let errors = given.setting_errors.unwrap_or_default().change();
    let real: [f64; 4] = std::array::from_fn(|k| shown[k] + errors[k]);
    let (values, before) = match &prepared.probe_readings {
        Some(path) => (known(given, read_probe_values(path)?)?, None),
        None => {
            let left = machined.left(&real, &lengths, progress)?;
            (simulated(bodies, given, &left, &lengths), Some(left))
        }
    };
    let (fit, off) = fitted(bodies, &values)?;
    let mut result = result(bodies, given, (&values, &fit, &off));
    if let Some(before) = &before {
        let change: [f64; 4] = std::array::from_fn(|k| real[k] + fit.change[k]);
        let after = machined.left(&change, &lengths, progress)?;
        compare(bodies, given, (&fit, &lengths), [before, &after], &mut result)?;
    }
    Ok(Some(Probed { values, simulated: before.is_some(), result }))
}

/// What made the workpiece.
struct Machined<'a> {
    bodies: &'a SkivingBodies,
    tool: RealTool,
    clocking: f64,
    law: Option<&'a PeriodicLaw>,
}

impl<'a> Machined<'a> {
    fn new(
        bodies: &'a SkivingBodies,
        measurement: Option<&Measurement>,
        law: Option<&'a PeriodicLaw>,
    ) -> Self {
        let (tool, clocking) = match measurement {
            Some(m) => (m.cutting.clone(), m.cutting_clocking),
            None => (RealTool::ideal(bodies.teeth()), 0.0),
        };
        Self { bodies, tool, clocking, law }
    }

    /// What every tooth leaves with a change of the setting, under the referee.
    fn left(
        &self,
        change: &[f64; 4],
        lengths: &Sides<Vec<f64>>,
        progress: &dyn Progress,
    ) -> Result<Left, RunFailure> {
        let motion: SkivingMotion = corrected(self.bodies.pair.motion(), change);
        let law = self.law.map(|law| |angle: f64| law.at(angle));
        let law = law.as_ref().map(|law| law as &Law<'_>);
        skived_at(self.bodies, (&self.tool, self.clocking), (&motion, law), lengths, progress)
    }
}

/// Mean over the teeth that cut a tooth space: tooth K mod z_1 cuts space -s_I K mod z_2.
fn of_gap(bodies: &SkivingBodies, teeth: &[f64], gap: usize) -> f64 {
    let (z1, work) = (teeth.len(), bodies.pair.gear().data().teeth);
    let common = gcd(z1, work.unsigned_abs() as usize);
    let residue = (-i64::from(work.signum()) * gap as i64).rem_euclid(common as i64) as usize;
    let cutting = teeth.iter().enumerate().filter(|(tooth, _)| tooth % common == residue);
    let (sum, count) = cutting.fold((0.0, 0), |(sum, count), (_, f)| (sum + f, count + 1));
    sum / f64::from(count.max(1))
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

fn simulated(
    bodies: &SkivingBodies,
    given: &WorkpieceProbe,
    left: &Left,
    lengths: &Sides<Vec<f64>>,
) -> Vec<ProbeValue> {
    let mut noise = Noise::new(given.seed);
    let mut values = Vec::with_capacity(2 * given.gaps.len() * given.places);
    for &gap in &given.gaps {
        for flank in Flank::BOTH {
            for (w, teeth) in lengths[flank].iter().zip(&left[flank]) {
                let off = 1e-3 * given.noise_um * noise.normal();
                values.push(ProbeValue { flank, gap, w: *w, deviation: of_gap(bodies, teeth, gap) + off });
            }
        }
    }
    values
}

/// Values of the tooth spaces of the job, each of both flanks.
fn known(given: &WorkpieceProbe, values: Vec<ProbeValue>) -> Result<Vec<ProbeValue>, RunFailure> {
    let refused = |text: String, way_out: &str| {
        let finding = Diagnostic::new(Problem::InvalidTable, text).field("workpiece_probe.readings");
        RunFailure::bad_input(finding.allowed(format!("gaps {:?}, both flanks", given.gaps)).way_out(way_out))
    };
    if let Some(value) = values.iter().find(|value| !given.gaps.contains(&value.gap)) {
        let text = format!("the table has values of tooth space {}, which the job does not name", value.gap);
        return Err(refused(text, "give the tooth spaces of the table as `workpiece_probe.gaps`"));
    }
    for &gap in &given.gaps {
        for flank in Flank::BOTH {
            let count = values.iter().filter(|value| value.gap == gap && value.flank == flank).count();
            if count < LEAST {
                let text = format!("{count} values of the {flank} flank of tooth space {gap}");
                return Err(refused(
                    text,
                    "measure both flanks of every tooth space at three places or more",
                ));
            }
        }
    }
    Ok(values)
}

/// The change of the setting that answers the values, and their deviations from the target, mm.
fn fitted(bodies: &SkivingBodies, values: &[ProbeValue]) -> Result<(SettingFit, Vec<f64>), RunFailure> {
    let on = |error: SkivingError| failure(&error);
    let (mut rows, mut off) = (Vec::with_capacity(values.len()), Vec::with_capacity(values.len()));
    for value in values {
        let edge = &bodies.edges[value.flank];
        let [from, to] = edge.flank().range();
        if !(from..=to).contains(&value.w) {
            let text = format!("length of roll {} mm lies beside the evaluated profile", value.w);
            let finding = Diagnostic::new(Problem::InvalidTable, text).field("workpiece_probe.readings");
            let finding = finding.value(value.w).allowed(format!("{from:.4} to {to:.4} mm"));
            return Err(RunFailure::bad_input(finding.way_out("leave values beside `gear.evaluation` out")));
        }
        let contact = edge.contact(value.w).map_err(on)?;
        rows.push(setting_sensitivity(bodies.pair.motion(), &contact));
        off.push(value.deviation - contact.modification);
    }
    let fit = fit_setting(&rows, &off, &bodies.free, &bodies.setting_limits).map_err(on)?;
    Ok((fit, off))
}

fn result(
    bodies: &SkivingBodies,
    given: &WorkpieceProbe,
    (values, fit, off): (&[ProbeValue], &SettingFit, &[f64]),
) -> ProbeResult {
    let mut before = Sides { left: Vec::new(), right: Vec::new() };
    let mut flanks = BTreeMap::new();
    for flank in Flank::BOTH {
        // Length of roll, what is off, and what the change leaves of it.
        let of = |gap: Option<usize>| -> Vec<[f64; 3]> {
            let all = values.iter().zip(off).zip(&fit.residual);
            let own =
                all.filter(|((value, _), _)| value.flank == flank && gap.is_none_or(|gap| value.gap == gap));
            own.map(|((value, off), left)| [value.w, 1e3 * off, 1e3 * left]).collect()
        };
        let whole = of(None);
        let largest = |k: usize| whole.iter().map(|row| row[k].abs()).fold(0.0, f64::max);
        before[flank] = whole.iter().map(|row| 1e-3 * row[1]).collect();
        let found = ProbedFlankResult {
            gaps: given.gaps.iter().map(|gap| (gap.to_string(), of(Some(*gap)))).collect(),
            largest_um: largest(1),
            corrected_largest_um: largest(2),
            corrected_simulated_um: None,
        };
        flanks.insert(flank.name(), found);
    }
    ProbeResult { flanks, correction: correction(bodies, fit, &before), ..ProbeResult::default() }
}

/// Takes in what the referee leaves before and after the change, without the noise of the probe.
fn compare(
    bodies: &SkivingBodies,
    given: &WorkpieceProbe,
    (fit, lengths): (&SettingFit, &Sides<Vec<f64>>),
    [before, after]: [&Left; 2],
    result: &mut ProbeResult,
) -> Result<(), RunFailure> {
    let mut difference = 0.0f64;
    for flank in Flank::BOTH {
        let mut most = 0.0f64;
        for (k, w) in lengths[flank].iter().enumerate() {
            let contact = bodies.edges[flank].contact(*w).map_err(|error| failure(&error))?;
            let by = setting_sensitivity(bodies.pair.motion(), &contact);
            let moved: f64 = by.iter().zip(&fit.change).map(|(by, change)| by * change).sum();
            for &gap in &given.gaps {
                let [was, is] = [before, after].map(|left| of_gap(bodies, &left[flank][k], gap));
                most = most.max((is - contact.modification).abs());
                difference = difference.max((is - was - moved).abs());
            }
        }
        if let Some(found) = result.flanks.get_mut(flank.name()) {
            found.corrected_simulated_um = Some(1e3 * most);
        }
    }
    result.simulated = true;
    result.model_difference_um = Some(1e3 * difference);
    Ok(())
}
