//! Whether a job fits its machine, before any plan: where the axes stand at the ends of feed, shift and dressing in the kinematics of the
//! bodies alone. Corrections of a plan, approaches and turns of the spindles come on top.

use super::prepare::Prepared;
use foundation::kinematics::{DressingMotion, GeneratingState, MotionLaw};
use foundation::numerics::extremes;
use generating::{FeedLaw, dressing_interval};
use job::machine::LoadedMachine;
use machine::{DressingRule, Machine, MachineError, Positions, Solution, Station};
use verdict::Remark;

/// Beside the used part of the worm the dresser drives on by this, mm, as a plan has it do.
const DRESSING_MARGIN: f64 = 3.0;

/// An axis and where it stands. mm or deg.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisNeed {
    /// Its name.
    pub axis: String,
    /// "mm" or "deg".
    pub unit: &'static str,
    /// Least and greatest place.
    pub needed: [f64; 2],
    /// Ends of its travel.
    pub travel: [f64; 2],
}

impl AxisNeed {
    /// Room to the nearer end of the travel, below 0 beyond it.
    pub fn room(&self) -> f64 {
        (self.needed[0] - self.travel[0]).min(self.travel[1] - self.needed[1])
    }
}

/// What a job asks of its machine.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MachineFit {
    /// Axes with ends of travel that grinding or dressing moves, in the machine's order.
    pub axes: Vec<AxisNeed>,
    /// What does not fit.
    pub remarks: Vec<Remark>,
}

/// The shift that the fit is worked out for: the job's own law or ratio, else none.
pub fn shift_known_before(prepared: &Prepared) -> (f64, MotionLaw) {
    let ratio = prepared.rules.known_ratio().unwrap_or(0.0);
    let centred = || FeedLaw::Ratio(ratio).law(&prepared.setup, &prepared.ground_flanks());
    (ratio, prepared.law.clone().unwrap_or_else(centred))
}

/// Feeds z_V2 at which grinding begins and ends, mm: contact on the evaluated field with the overrun at both ends.
pub fn feeds(prepared: &Prepared, law: &MotionLaw) -> [f64; 2] {
    let [from, to] = prepared.setup.feed_range(law, &prepared.ground_flanks());
    [from - prepared.cycle.overrun, to + prepared.cycle.overrun]
}

/// The axes of the machine at the ends of all motions.
pub fn machine_fit(prepared: &Prepared, loaded: &LoadedMachine) -> MachineFit {
    let machine = &loaded.machine;
    let mut fit = MachineFit::default();
    let mut places: Vec<Positions> = Vec::new();
    let mut stations: Vec<Station> = Vec::new();
    for (station, what, found) in [
        (Station::Work, "grinding", grinding_places(prepared, machine)),
        (Station::Dresser, "dressing", dressing_places(prepared, machine)),
    ] {
        match found {
            Ok(found) if found.is_empty() => {}
            Ok(found) => {
                stations.push(station);
                places.extend(found);
            }
            Err(error) => fit.remarks.push(Remark {
                code: "machine-does-not-fit",
                text: format!("{what} on {}: {error}", machine.name()),
                way_out: "compare the bodies and their clamping ([machine]) with the machine's description"
                    .into(),
            }),
        }
    }
    for (number, axis) in machine.axes().iter().enumerate() {
        let moves =
            stations.iter().any(|&station| machine.axes_at(station).is_ok_and(|axes| axes.contains(&number)));
        let Some(travel) = axis.travel.filter(|_| moves) else { continue };
        let shown = |x: f64| axis.joint.shown(x);
        let needed = extremes(places.iter().map(|at| at[number])).map(shown);
        let need =
            AxisNeed { axis: axis.name.clone(), unit: axis.joint.unit(), needed, travel: travel.map(shown) };
        if need.room() < 0.0 {
            fit.remarks.push(beyond(&need));
        }
        fit.axes.push(need);
    }
    fit
}

fn beyond(need: &AxisNeed) -> Remark {
    let AxisNeed { axis, unit, needed: [a, b], travel: [from, to] } = need;
    Remark {
        code: "beyond-travel",
        text: format!(
            "{axis} would stand from {a:.3} to {b:.3} {unit}, its travel is {from:.3} to {to:.3} {unit}: no plan of these bodies fits"
        ),
        way_out: "clamp the body elsewhere (machine.worm, machine.work, machine.dresser), use a narrower or smaller worm, or another machine"
            .into(),
    }
}

/// The best way to take up a pose; where each leaves the travel, the one that the machine would take with longer ways.
fn placed(machine: &Machine, station: Station, found: Vec<Positions>) -> Result<Positions, MachineError> {
    let solutions: Vec<Solution> = machine.judged(station, found)?;
    if let Ok(best) = machine.first(&solutions) {
        return Ok(best.at);
    }
    let fewest = solutions.iter().min_by_key(|solution| solution.beyond.len());
    fewest.map(|solution| solution.at).ok_or_else(|| machine.limit_of(&solutions))
}

fn grinding_places(prepared: &Prepared, machine: &Machine) -> Result<Vec<Positions>, MachineError> {
    let (_, law) = shift_known_before(prepared);
    let technology = &prepared.technology;
    let mut places = Vec::new();
    for feed in feeds(prepared, &law) {
        for stand_off in [0.0, technology.clearance] {
            let state = GeneratingState {
                worm_angle: 0.0,
                work_angle: 0.0,
                shift: law.value(feed),
                feed,
                delta_d: stand_off,
                delta_gamma: 0.0,
            };
            let pose = technology.grinding.spindles(&prepared.setup.pair.chain.pose(&state));
            places.push(placed(machine, Station::Work, machine.grinding(&pose)?)?);
        }
    }
    Ok(places)
}

/// None for a worm that is not dressed by a profiled disc.
fn dressing_places(prepared: &Prepared, machine: &Machine) -> Result<Vec<Positions>, MachineError> {
    let Ok(dresser) = prepared.setup.dresser() else { return Ok(Vec::new()) };
    let (_, law) = shift_known_before(prepared);
    let technology = &prepared.technology;
    let mut places = Vec::new();
    for flank in prepared.ground_flanks() {
        let (from, to) = dressing_interval(&prepared.setup, dresser, &law, flank, DRESSING_MARGIN);
        let motion = DressingMotion::constant(dresser.flanks[flank].chain, [0.0; 4]);
        // A worm with a stated width passes the dresser from end to end.
        let end = technology.worm_end.unwrap_or(0.0);
        for v in [from.min(-end), to.max(end)] {
            for stand_off in [0.0, technology.clearance] {
                let mut position = motion.position(v);
                position.centre_distance += stand_off;
                let pose = technology.dressing.spindles(&position.pose());
                let rule = DressingRule::Swivel(technology.swivel);
                let found = machine.dressing(&pose, rule, Some(0.0))?;
                places.push(placed(machine, Station::Dresser, found)?);
            }
        }
    }
    Ok(places)
}
