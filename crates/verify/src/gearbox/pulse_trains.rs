//! Block `pulse_trains`: the pulses of the interpolator, in both forms.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Reference;
use super::case::{check_each, require_exact};
use super::fingerprint::Fingerprint;
use super::refusal::Refusal;
use super::train::{Train, TrainInput};
use electronic_gearbox::pulse::{
    ClockedInterpolator, Direction, EventInterpolator, PulseKind, Settings, Status, TimedPulse,
};
use serde_json::Value;

/// Block `pulse_trains`.
pub(crate) fn pulse_trains(_: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    check_each(
        "pulse_trains",
        block,
        ["tolerance"],
        ledger,
        |input: &TrainInput, [tolerance], expected, ledger| {
            let (settings, train) = (input.settings()?, input.train()?);
            // The event form refuses bad trains; the clocked one cannot be given any.
            let forms = [("event", events(settings, &train)?), ("clocked", clocked(settings, &train))];
            require_exact(expected.case(), tolerance, ledger);
            let name = expected.case().to_owned();
            for (form, run) in &forms {
                expected.rename(&format!("{name}, {form} form"));
                compare(run, expected, ledger);
            }
            Ok(())
        },
    );
}

/// What a form sent, and its state at the end.
pub(super) struct Run {
    pub pulses: Vec<TimedPulse>,
    status: Status,
}

/// The event form over a train.
pub(super) fn events(settings: Settings, train: &Train) -> Result<Run, Refusal> {
    let mut machine = EventInterpolator::new(settings);
    let mut pulses = Vec::new();
    for &(tick, sign) in &train.references {
        machine.reference(tick, sign, |pulse| pulses.push(pulse))?;
    }
    machine.advance(train.last_tick, |pulse| pulses.push(pulse));
    Ok(Run { pulses, status: machine.status() })
}

/// The clocked machine tick by tick over a train that the event form has accepted.
fn clocked(settings: Settings, train: &Train) -> Run {
    let mut machine = ClockedInterpolator::new(settings);
    let mut references = train.references.iter().peekable();
    let mut pulses = Vec::new();
    for tick in 1..=train.last_tick {
        let reference = references.next_if(|(at, _)| *at == tick);
        let reference = reference.and_then(|(_, sign)| Direction::from_sign(*sign));
        pulses.extend(machine.tick(reference).map(|pulse| TimedPulse { tick, pulse }));
    }
    Run { pulses, status: machine.status() }
}

fn compare(run: &Run, expected: &mut Expected<'_>, ledger: &mut Ledger) {
    let mut counts = [0; 3];
    let (mut net, mut net_reference) = (0, 0);
    let mut fingerprint = Fingerprint::EMPTY;
    let (mut ticks, mut signs, mut kinds) = (Vec::new(), Vec::new(), String::new());
    for &TimedPulse { tick, pulse } in &run.pulses {
        let sign = pulse.direction.sign();
        let (kind, letter) = match pulse.kind {
            PulseKind::Reference => (0, 'R'),
            PulseKind::Intermediate => (1, 'Z'),
            PulseKind::Correction => (2, 'K'),
        };
        counts[kind] += 1;
        net += sign;
        net_reference += if kind == 0 { sign } else { 0 };
        fingerprint.add(tick, sign);
        // Trains end below 2^30 ticks.
        ticks.push(tick as i64);
        signs.push(sign);
        kinds.push(letter);
    }
    let [reference, intermediate, correction] = counts;
    let status = &run.status;
    for (key, actual) in [
        ("pulses", ticks.len() as i64),
        ("reference", reference),
        ("intermediate", intermediate),
        ("correction", correction),
        ("net_count", net),
        ("net_reference", net_reference),
        ("pending_signed", status.pending),
        ("e", status.inserted.into()),
        ("direction", status.direction.map_or(0, Direction::sign)),
        ("C", status.spacing.into()),
        // Files count intervals of either end; what a reversal ends is no alarm here.
        ("overrun", (status.overruns + status.overruns_at_reversals) as i64),
        ("too_fast", (status.too_fast + status.short_reversals) as i64),
    ] {
        expected.whole(key, actual, ledger);
    }
    expected.text("fnv1a64", &fingerprint.text(), ledger);
    expected.wholes("tick", &ticks, ledger);
    expected.wholes("sign", &signs, ledger);
    expected.text("kind", &kinds, ledger);
}
