//! What `[explore]` of a job offers: every combination of scale, clock, interpolation and encoder with its cost.

use super::driven::Driven;
use super::set_up::SetUp;
use crate::job::GearboxExplore;
use job::Diagnostic;
use run::RunFailure;

/// Set-ups that one job may compare.
pub const MOST_SET_UPS: usize = 20_000;

/// A set-up to choose.
#[derive(Clone, Copy, Debug)]
pub struct Offer {
    /// Scale, clock, interpolation and encoder.
    pub set_up: SetUp,
    /// What it costs.
    pub cost: f64,
}

/// All set-ups to choose from, and what is wanted of them.
#[derive(Clone, Debug)]
pub struct Offers {
    /// Error of the flank that is wanted at most, um.
    pub wanted_um: f64,
    /// Speed of the feed, mm/s.
    pub speed: f64,
    /// Acceleration of the feed, mm/s^2.
    pub acceleration: f64,
    /// The set-ups.
    pub all: Vec<Offer>,
}

impl Offers {
    /// Of a table; what it does not vary is as in `set_up`, speed and acceleration it does not give are the greatest of the motion.
    ///
    /// # Errors
    /// [`RunFailure`]: more than [`MOST_SET_UPS`].
    pub(super) fn of_job(given: &GearboxExplore, set_up: SetUp, driven: &Driven) -> Result<Self, RunFailure> {
        let (speed, acceleration) = driven.motion.as_ref().map_or((0.0, 0.0), |motion| motion.greatest());
        Ok(Self {
            wanted_um: given.wanted_um,
            speed: given.speed_mm_per_min.map_or(speed, |per_minute| per_minute / 60.0),
            acceleration: given.acceleration_mm_per_s2.unwrap_or(acceleration),
            all: combinations(given, set_up)?,
        })
    }
}

fn combinations(given: &GearboxExplore, set_up: SetUp) -> Result<Vec<Offer>, RunFailure> {
    let counts = [given.scales.len(), given.clocks.len(), given.interpolations.len(), given.encoders.len()];
    let combinations: usize = counts.iter().map(|count| count.max(&1)).product();
    if combinations > MOST_SET_UPS {
        let message = format!("the lists of [explore] make {combinations} combinations");
        return Err(RunFailure::bad_input(
            Diagnostic::with_code("too-many-combinations", message)
                .field("explore")
                .value(combinations)
                .allowed(format!("up to {MOST_SET_UPS}"))
                .way_out("leave entries out; compare a few of each first"),
        ));
    }
    let mut all = vec![Offer { set_up, cost: 0.0 }];
    all = varied(all, &given.scales, |set_up, choice| {
        set_up.feed.pulses_per_metre = choice.pulses_per_metre;
        choice.cost
    });
    all = varied(all, &given.clocks, |set_up, choice| {
        set_up.feed.clock_hz = choice.clock_hz;
        choice.cost
    });
    all = varied(all, &given.interpolations, |set_up, choice| {
        set_up.feed.pulses_per_interval = choice.pulses_per_interval;
        choice.cost
    });
    all = varied(all, &given.encoders, |set_up, choice| {
        set_up.workpiece.pulses_per_revolution = choice.pulses_per_revolution;
        choice.cost
    });
    Ok(all)
}

/// Every offer with every choice, which `set` puts into it and gives the cost of; the offers themselves without choices.
fn varied<C>(offers: Vec<Offer>, choices: &[C], set: impl Fn(&mut SetUp, &C) -> f64) -> Vec<Offer> {
    if choices.is_empty() {
        return offers;
    }
    let with = |offer: &Offer, choice: &C| {
        let mut set_up = offer.set_up;
        let more = set(&mut set_up, choice);
        Offer { set_up, cost: offer.cost + more }
    };
    offers.iter().flat_map(|offer| choices.iter().map(move |choice| with(offer, choice))).collect()
}
