//! Block `servo`: gains, poles, the answer to disturbances in closed form, and runs sample by sample.

use super::super::expected::{Expected, numbers};
use super::super::ledger::Ledger;
use super::super::reference::{Reference, read};
use super::formula::Formula;
use control::ControlError;
use control::servo::{Drive, FlankRecord, Gains, Quantisation, ServoLoop, ServoParameters, Setpoint};
use num_dual::Dual2_64;
use serde::Deserialize;
use serde_json::Value;
use std::collections::BTreeMap;
use std::error::Error;

/// The loop to which gains, poles and answers of the block belong.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct LinearInput {
    #[serde(rename = "J_kg_m2")]
    inertia: f64,
    #[serde(rename = "B_Nms_per_rad")]
    viscous_friction: f64,
    #[serde(rename = "Ts_s")]
    sample_time: f64,
    bandwidth_hz: f64,
}

impl LinearInput {
    fn parameters(&self) -> Result<ServoParameters, ControlError> {
        let drive = Drive {
            inertia: self.inertia,
            viscous_friction: self.viscous_friction,
            coulomb_friction: 0.0,
            // Without effect on the linear loop, but a drive has them.
            friction_speed: 1.0,
            torque_limit: 1.0,
        };
        let gains = Gains::triple_pole(self.bandwidth_hz, &drive)?;
        Ok(ServoParameters {
            sample_time: self.sample_time,
            drive,
            gains,
            feed_forward: 0.0,
            quantisation: None,
        })
    }
}

/// Block `servo`.
pub(crate) fn servo(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let mut outer = Expected::new("servo", "", block, ledger);
    let input = outer.take("input").and_then(|input| read::<LinearInput>("servo", input, ledger));
    for key in ["gains", "poles_abs", "e_per_torque_rad_per_Nm"] {
        if outer.peek(key).is_some() && input.is_none() {
            ledger.fail("servo", key, "computed values".into(), "the block has no usable input".into());
            outer.informative(&[key]);
        }
    }
    if let Some(input) = input
        && let Err(error) = linear(&input, &mut outer, ledger)
    {
        outer.refused(&error, ledger);
    }
    outer.informative(&["note", "tolerance_poles_abs", "tolerance_gain_rel", "frequency_hz"]);
    match outer.take("runs") {
        Some(Value::Array(runs)) => {
            for (k, item) in runs.iter().enumerate() {
                let own = item["name"].as_str().map_or_else(|| format!("run {k}"), str::to_owned);
                check_run(&format!("servo {own}"), item, ledger);
            }
        }
        Some(other) => ledger.fail("servo", "runs", other.clone(), "a list of runs is needed here".into()),
        None => {}
    }
    outer.finish(ledger);
}

/// The quantities of the linear loop.
fn linear(input: &LinearInput, outer: &mut Expected<'_>, ledger: &mut Ledger) -> Result<(), ControlError> {
    let parameters = input.parameters()?;
    if let Some(mut expected) = outer.object("gains", ledger) {
        let relative = expected.given("tolerance_rel", ledger).unwrap_or(f64::NAN);
        let Gains { proportional, integral, derivative } = parameters.gains;
        let bandwidth = input.bandwidth_hz;
        for (key, actual) in
            [("bandwidth_hz", bandwidth), ("Kp", proportional), ("Ki", integral), ("Kd", derivative)]
        {
            expected.number(key, actual, relative * actual.abs(), ledger);
        }
        expected.finish(ledger);
    }
    if outer.peek("poles_abs").is_some() {
        let tolerance = outer.given("tolerance_poles_abs", ledger).unwrap_or(f64::NAN);
        outer.list("poles_abs", &parameters.poles()?.map(|z| z.norm()), tolerance, ledger);
    }
    if outer.peek("e_per_torque_rad_per_Nm").is_some() {
        let relative = outer.given("tolerance_gain_rel", ledger).unwrap_or(f64::NAN);
        let frequencies = outer.given_list("frequency_hz", ledger).unwrap_or_default();
        let answer = |f: f64| parameters.disturbance_response(f).map(|answer| answer.norm());
        let answers: Vec<f64> = frequencies.into_iter().map(answer).collect::<Result<_, _>>()?;
        outer.list_to("e_per_torque_rad_per_Nm", &answers, |expected| relative * expected.abs(), ledger);
    }
    Ok(())
}

/// Numbers of a run, by the symbols of `docs/mathematics/gearbox.md#position-loop`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Symbols {
    #[serde(rename = "Ts")]
    sample_time: f64,
    #[serde(rename = "J")]
    inertia: f64,
    #[serde(rename = "B")]
    viscous_friction: f64,
    #[serde(rename = "Tc")]
    coulomb_friction: f64,
    #[serde(rename = "ws")]
    friction_speed: f64,
    #[serde(rename = "Kp")]
    proportional: f64,
    #[serde(rename = "Ki")]
    integral: f64,
    #[serde(rename = "Kd")]
    derivative: f64,
    #[serde(rename = "Tmax")]
    torque_limit: f64,
    #[serde(rename = "Nw")]
    counts_per_revolution: u32,
    #[serde(rename = "P")]
    multiplier: u32,
    #[serde(rename = "ff")]
    feed_forward: f64,
    quant: u8,
    #[serde(rename = "w0")]
    start_speed: f64,
    #[serde(rename = "th0")]
    start_angle: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RunInput {
    par: Symbols,
    steps: usize,
    reference_rad: String,
    #[serde(rename = "torque_Nm")]
    torque: String,
    t: String,
}

impl Symbols {
    fn parameters(&self) -> Result<ServoParameters, Box<dyn Error>> {
        let Symbols { counts_per_revolution, multiplier, .. } = *self;
        let quantisation = match self.quant {
            0 => None,
            1 => Some(Quantisation { counts_per_revolution, multiplier }),
            other => return Err(format!("quant = {other}; allowed: 0 or 1").into()),
        };
        Ok(ServoParameters {
            sample_time: self.sample_time,
            drive: Drive {
                inertia: self.inertia,
                viscous_friction: self.viscous_friction,
                coulomb_friction: self.coulomb_friction,
                friction_speed: self.friction_speed,
                torque_limit: self.torque_limit,
            },
            gains: Gains {
                proportional: self.proportional,
                integral: self.integral,
                derivative: self.derivative,
            },
            feed_forward: self.feed_forward,
            quantisation,
        })
    }
}

/// What a run brought.
struct Run {
    errors: Vec<f64>,
    /// From half the time of the step of the torque to the step: the start has died out.
    settled: FlankRecord,
    /// After the step.
    stepped: FlankRecord,
}

/// Steps of a run: beyond that a file asks for more than a check should take.
const MOST_STEPS: usize = 10_000_000;

fn check_run(name: &str, item: &Value, ledger: &mut Ledger) {
    let mut case = Expected::new(name, "", item, ledger);
    case.informative(&["name", "note", "input"]);
    let given =
        ["flank_um_per_rad", "tolerance_e_rad", "tolerance_flank_rel"].map(|key| case.given(key, ledger));
    let [flank_um_per_rad, tolerance, relative] = given.map(|x| x.unwrap_or(f64::NAN));
    let input = read::<RunInput>(name, &item["input"], ledger);
    match (input, case.object("expected", ledger)) {
        (Some(input), Some(mut expected)) => {
            match simulate(&input, flank_um_per_rad) {
                Ok(run) => compare(&run, &mut expected, [tolerance, relative], ledger),
                Err(error) => expected.refused(&error, ledger),
            }
            expected.finish(ledger);
        }
        (_, None) => ledger.fail(name, "expected", Value::Null, "the run expects nothing".into()),
        // The unreadable input is a failure already.
        (None, Some(_)) => {}
    }
    case.finish(ledger);
}

fn simulate(input: &RunInput, flank_um_per_rad: f64) -> Result<Run, Box<dyn Error>> {
    if input.t != "k*Ts" {
        return Err(format!("the time `{}` is not known; known is `k*Ts`", input.t).into());
    }
    if input.steps > MOST_STEPS {
        return Err(format!("{} steps; allowed: up to {MOST_STEPS}", input.steps).into());
    }
    let par = &input.par;
    let names = BTreeMap::from([("w0", par.start_speed), ("th0", par.start_angle), ("Ts", par.sample_time)]);
    let reference = Formula::parse(&input.reference_rad, &names)?;
    let torque = Formula::parse(&input.torque, &names)?;
    let step = torque.steps().into_iter().reduce(f64::min);
    let mut servo = ServoLoop::new(par.parameters()?)?.starting_at(par.start_angle, par.start_speed)?;
    let record = FlankRecord::new(flank_um_per_rad)?;
    let mut run = Run { errors: Vec::with_capacity(input.steps), settled: record, stepped: record };
    for k in 0..input.steps {
        let t = k as f64 * par.sample_time;
        let Dual2_64 { re, v1, v2, .. } = reference.value(Dual2_64::from_re(t).derivative());
        let setpoint = Setpoint { position: re, speed: v1, acceleration: v2 };
        let error = servo.step(&setpoint, torque.value(t))?.error;
        run.errors.push(error);
        match step {
            Some(step) if t > step => run.stepped.add(error),
            Some(step) if t > 0.5 * step && t < step => run.settled.add(error),
            _ => continue,
        };
    }
    Ok(run)
}

fn compare(run: &Run, expected: &mut Expected<'_>, [tolerance, relative]: [f64; 2], ledger: &mut Ledger) {
    // Samples are whole numbers; one that is none or beyond the run leaves the list without its error.
    let listed = expected.take("k").and_then(numbers).unwrap_or_default();
    let errors: Vec<f64> = listed
        .iter()
        .filter(|k| k.fract() == 0.0 && **k >= 0.0)
        .filter_map(|k| run.errors.get(*k as usize))
        .copied()
        .collect();
    expected.list("e_rad", &errors, tolerance, ledger);
    let rms = run.settled.rms_um();
    expected.optional("flank_um_rms", rms, relative * rms.unwrap_or(f64::NAN), ledger);
    let peak = (run.stepped.samples() > 0).then(|| run.stepped.peak_um());
    expected.optional("flank_um_peak_after_step", peak, relative * peak.unwrap_or(f64::NAN), ledger);
}
