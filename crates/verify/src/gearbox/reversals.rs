//! Block `literal_reversal_loss`: how often the circuit as printed loses pulses where the slide turns.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::{Reference, read};
use super::refusal::Refusal;
use control::{Interpolation, SlideMotion};
use electronic_gearbox::pulse::{Mode, Settings};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Input {
    #[serde(rename = "P")]
    multiplier: u32,
    q_per_m: f64,
    f1_hz: f64,
    a_mm_s2: f64,
    n: u32,
    counter_max: u32,
    x_start_mm: f64,
    #[serde(rename = "turning_point_mm")]
    turning_point: String,
    motion: String,
    reference_ticks: String,
    last_tick: String,
    loss: String,
}

/// The experiment in the words of the file. It is this one that is computed, no other.
const TURNING_POINT: &str = "x_i = 20 p + (i + 0.5) p/n, p = 1000/q, i = 0..n-1";
const MOTION: &str = "from rest: +a for T, -a for 2 T, +a for T, T = sqrt(x_i/a): to x_i and back to 0";
const REFERENCE_TICKS: &str =
    "slide crosses k p at time t: tick ceil(t f1), at least 1 and one after the previous; sign = direction";
const LAST_TICK: &str = "floor(4 T f1) + 20000";
const LOSS: &str = "(sum of signs + pending) of mode literal minus that of mode seed; share = part of the n turning points with loss != 0";

/// More turning points are more than a check should take.
const MOST_TURNS: u32 = 100_000;

/// The closed form has nothing but rounding; the tolerance of the file is for turning points that are counted.
const ROUNDING: f64 = 1e-12;

/// Block `literal_reversal_loss`.
pub(crate) fn literal_reversal_loss(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let Some(items) = block.as_array() else {
        let name = "literal_reversal_loss";
        return ledger.fail(name, name, block.clone(), "a list of cases is needed here".into());
    };
    for (k, item) in items.iter().enumerate() {
        let name = format!("literal_reversal_loss[{k}]");
        let mut case = Expected::new(&name, "", item, ledger);
        case.informative(&["name", "note", "input"]);
        let tolerance = case.given("tolerance_share_abs", ledger).unwrap_or(f64::NAN);
        let Some(input) = read::<Input>(&name, &item["input"], ledger) else { continue };
        match simulated_share(&input) {
            Ok(share) => {
                case.whole("P", input.multiplier.into(), ledger);
                let formula = closed_share(input.multiplier);
                case.number("share_formula", formula, ROUNDING * formula, ledger);
                case.number(&format!("share_simulated_{}", input.n), share, tolerance, ledger);
            }
            Err(refusal) => refusal.compare(&mut case, ledger),
        }
        case.finish(ledger);
    }
}

/// Share of reversals with loss under constant deceleration: 1/(((2 + k)/k)^2 - 1), k = (P - 1)/P
/// (`docs/mathematics/gearbox.md#pulses-between-lines`).
fn closed_share(multiplier: u32) -> f64 {
    let p = f64::from(multiplier);
    let k = (p - 1.0) / p;
    1.0 / (((2.0 + k) / k).powi(2) - 1.0)
}

impl Input {
    fn check_texts(&self) -> Result<(), Refusal> {
        for (key, text, known) in [
            ("turning_point_mm", &self.turning_point, TURNING_POINT),
            ("motion", &self.motion, MOTION),
            ("reference_ticks", &self.reference_ticks, REFERENCE_TICKS),
            ("last_tick", &self.last_tick, LAST_TICK),
            ("loss", &self.loss, LOSS),
        ] {
            if text != known {
                return Err(Refusal::of_case(format!("{key} = `{text}` is not known; known is `{known}`")));
            }
        }
        // The motion ends at 0 and its length is x_i: it begins at 0.
        if self.x_start_mm != 0.0 {
            return Err(Refusal::of_case(format!("x_start_mm = {}; allowed: 0", self.x_start_mm)));
        }
        if !(1..=MOST_TURNS).contains(&self.n) {
            return Err(Refusal::of_case(format!("n = {}; allowed: 1 to {MOST_TURNS}", self.n)));
        }
        Ok(())
    }

    fn interpolation(&self, mode: Mode) -> Result<Interpolation, Refusal> {
        let interpolation = Interpolation {
            settings: Settings::new(self.multiplier, self.counter_max, mode)?,
            clock: self.f1_hz,
            pitch: 1e3 / self.q_per_m,
        };
        interpolation.validate()?;
        Ok(interpolation)
    }
}

/// Sum of all signs and of the corrections still owed after one motion.
fn total(interpolation: &Interpolation, motion: &SlideMotion) -> Result<i64, Refusal> {
    let references = interpolation.references(motion)?;
    // The motion lasts 4 T.
    let last_tick = (motion.duration() * interpolation.clock).floor() as u64 + 20_000;
    let run = interpolation.run(&references, last_tick, None, None, &mut |_, _| ())?;
    Ok(run.counts.net + run.status.pending)
}

/// Share of the turning points at which the printed circuit ends elsewhere than the one that conserves pulses.
fn simulated_share(input: &Input) -> Result<f64, Refusal> {
    input.check_texts()?;
    let (printed, conserving) = (input.interpolation(Mode::Literal)?, input.interpolation(Mode::OneWay)?);
    let (pitch, a) = (printed.pitch, input.a_mm_s2);
    let mut losses = 0;
    for i in 0..input.n {
        let turn = 20.0 * pitch + (f64::from(i) + 0.5) * pitch / f64::from(input.n);
        let quarter = (turn / a).sqrt();
        let motion =
            SlideMotion::from_rest(input.x_start_mm, [(quarter, a), (2.0 * quarter, -a), (quarter, a)])?;
        losses += u32::from(total(&printed, &motion)? != total(&conserving, &motion)?);
    }
    Ok(f64::from(losses) / f64::from(input.n))
}
