//! Blocks `machines`, `forward`, `gearbox`, `influence`, `errors`.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::{Reference, read};
use super::input::{JobName, MountsInput, PoseInput, RuleInput, machine, positions};
use foundation::kinematics::{Direction, Point, Pose};
use machine::{
    Follower, GearCoupling, Joint, Machine, MachineError, Mount, Mounts, Role, Station, StationSpindle,
    ToolSpindle,
};
use serde::Deserialize;
use serde_json::Value;
use std::error::Error;

/// What a case ends with: an error is a failure of all that it expects.
type Outcome = Result<(), Box<dyn Error>>;

/// Block `machines`: every description is a machine.
pub(crate) fn machines(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let machines = block.as_object().into_iter().flatten();
    for (name, _) in machines {
        match machine(file, name) {
            Ok(_) => ledger.equal(name, "machine", true.into(), true.into()),
            Err(error) => ledger.fail(name, "machine", "a machine".into(), error.to_string().into()),
        }
    }
}

/// Every case of a list with its expected quantities.
pub(super) fn each<C: for<'de> Deserialize<'de>>(
    block: &str,
    list: &Value,
    ledger: &mut Ledger,
    check: impl Fn(&C, &mut Expected<'_>, &mut Ledger) -> Outcome,
) {
    let Some(items) = list.as_array() else {
        return ledger.fail(block, block, list.clone(), "a list of cases is needed here".into());
    };
    for (k, item) in items.iter().enumerate() {
        let own = item["name"].as_str().map_or_else(String::new, |name| format!(" {name}"));
        let on = item["machine"].as_str().unwrap_or("?");
        let name = format!("{block}[{k}]{own} on {on}");
        let Some(case) = read::<C>(&name, item, ledger) else { continue };
        let mut expected = Expected::new(&name, "", &item["expected"], ledger);
        if let Err(error) = check(&case, &mut expected, ledger) {
            expected.refused(&error, ledger);
        }
        expected.finish(ledger);
    }
}

/// First three rows of a pose.
pub(super) fn pose_rows(
    expected: &mut Expected<'_>,
    pose: &Pose<ToolSpindle, StationSpindle>,
    file: &Reference<'_>,
    ledger: &mut Ledger,
) {
    let tolerances = file.tolerances();
    let (rotation, length) = (tolerances.get("rotation"), tolerances.get("pose_mm"));
    let Some(entries) = expected.take_table("pose", [3, 4], ledger) else { return };
    for (k, entry) in entries.into_iter().enumerate() {
        let (i, j) = (k / 4, k % 4);
        let (actual, tolerance) =
            if j < 3 { (pose.rotation()[(i, j)], rotation) } else { (pose.translation()[i], length) };
        let quantity = format!("pose[{i}][{j}]");
        match entry.as_f64() {
            Some(number) => ledger.number(expected.case(), &quantity, number, actual, tolerance),
            None => ledger.fail(expected.case(), &quantity, entry.clone(), actual.into()),
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ForwardCase {
    machine: String,
    job: JobName,
    axes: Value,
    #[serde(rename = "expected")]
    _expected: Value,
}

/// Block `forward`.
pub(crate) fn forward(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    each("forward", block, ledger, |case: &ForwardCase, expected, ledger| {
        let machine = machine(file, &case.machine)?.machine;
        let station = case.job.station();
        let pose = machine.pose(station, &positions(&machine, station, &case.axes)?)?;
        pose_rows(expected, &pose, file, ledger);
        Ok(())
    });
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct GearboxCase {
    machine: String,
    input: GearboxInput,
    #[serde(rename = "expected")]
    _expected: Value,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct GearboxInput {
    z_1: u32,
    z_2: i32,
    m_n_mm: f64,
    beta_w1_deg: f64,
    beta_w2_deg: f64,
    worm_reversed: bool,
    work_reversed: bool,
}

/// Block `gearbox`: names are those of the machine's own axes.
pub(crate) fn gearbox(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let relative = file.tolerances().get("gearbox_relative");
    each("gearbox", block, ledger, |case: &GearboxCase, expected, ledger| {
        let machine = machine(file, &case.machine)?.machine;
        let input = &case.input;
        let mount = |reversed| Mount { reversed, ..Mount::default() };
        let mounts = Mounts { tool: mount(input.worm_reversed), counterpart: mount(input.work_reversed) };
        // k_Vi = 2 sin(beta_wi)/m_n (`docs/mathematics/generating-contact.md#coupling-of-the-rotations`).
        let by = |degrees: f64| 2.0 * degrees.to_radians().sin() / input.m_n_mm;
        let coupling = GearCoupling {
            threads: input.z_1,
            teeth: input.z_2,
            shift: by(input.beta_w1_deg),
            feed: by(input.beta_w2_deg),
            crossed_axes_angle: -(input.beta_w1_deg + input.beta_w2_deg).to_radians(),
        };
        let rates = machine.gearbox(&coupling, &mounts)?;
        let name = |role: Role| machine.role(role).map_or("", |axis| machine.axes()[axis].name.as_str());
        let (work, worm, axial, tilt) =
            (name(Role::Work), name(Role::Worm), name(Role::Axial), name(Role::Tilt));
        let shift = [Role::Shift, Role::Tangential].map(name).into_iter().find(|n| !n.is_empty());
        let mut one = |key: String, actual: f64| {
            let tolerance = relative * actual.abs();
            expected.number(&key, actual, tolerance, ledger);
        };
        one(format!("d{work}_d{worm}"), rates.worm());
        one(format!("d{work}_d{axial}_deg_per_mm"), rates.axial.to_degrees());
        one(format!("d{work}_d{}_deg_per_mm", shift.unwrap_or("")), rates.shift.to_degrees());
        one(format!("{tilt}_deg"), rates.tilt.to_degrees());
        Ok(())
    });
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct InfluenceCase {
    machine: String,
    job: JobName,
    axes: Value,
    worm_spindle_point_mm: [f64; 3],
    worm_normal: [f64; 3],
    #[serde(rename = "expected")]
    _expected: Value,
}

/// Block `influence`.
pub(crate) fn influence(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    let tolerances = file.tolerances();
    each("influence", block, ledger, |case: &InfluenceCase, expected, ledger| {
        let machine = machine(file, &case.machine)?.machine;
        let station = case.job.station();
        let at = positions(&machine, station, &case.axes)?;
        let point = Point::from_vector(case.worm_spindle_point_mm.into());
        let normal = Direction::from_vector(case.worm_normal.into());
        for (axis, left) in machine.influence(station, &at, &point, &normal)? {
            let name = &machine.axes()[axis].name;
            let (key, actual, tolerance) = match machine.axes()[axis].joint {
                Joint::Linear => (format!("{name}_um_per_um"), left, "influence_um_per_um"),
                Joint::Rotary => {
                    (format!("{name}_um_per_deg"), left.to_radians() * 1e3, "influence_um_per_deg")
                }
            };
            expected.number(&key, actual, tolerances.get(tolerance), ledger);
        }
        Ok(())
    });
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ErrorCase {
    machine: String,
    job: JobName,
    pose: PoseInput,
    mount: MountsInput,
    #[serde(default)]
    rule: RuleInput,
    #[serde(rename = "expected")]
    _expected: Value,
}

/// Name of an error as the specification spells it.
fn error_name(error: &MachineError) -> &'static str {
    match error {
        MachineError::InvalidNumber { .. } => "InvalidNumber",
        MachineError::InvalidPose { .. } => "InvalidPose",
        MachineError::Singular { .. } => "Singular",
        MachineError::PoleOfChart { .. } => "PoleOfChart",
        MachineError::MissingAxis { .. } => "MissingAxis",
        MachineError::NotDetermined { .. } => "NotDetermined",
        MachineError::Unreachable { .. } | MachineError::NoSolution { .. } => "Unreachable",
        MachineError::AxisLimit { .. } => "AxisLimit",
    }
}

/// Block `errors`.
pub(crate) fn errors(file: &Reference<'_>, block: &Value, ledger: &mut Ledger) {
    each("errors", block, ledger, |case: &ErrorCase, expected, ledger| {
        let machine = machine(file, &case.machine)?.machine;
        let station = case.job.station();
        let outcome = begin(&machine, station, case);
        let actual = outcome.err().map_or("none", |error| error_name(&error));
        if let Some(wanted) = expected.take("error") {
            ledger.equal(expected.case(), "error", wanted.clone(), actual.into());
        }
        Ok(())
    });
}

/// The first position of a stroke.
fn begin(machine: &Machine, station: Station, case: &ErrorCase) -> Result<(), MachineError> {
    let mounts = case.mount.at(station);
    let found = case.rule.solve(machine, station, &case.pose.spindles(&mounts), None)?;
    let senses = [mounts.tool.sense(), mounts.counterpart.sense()];
    Follower::new(machine, station, senses).next(found, case.pose.angles()).map(|_| ())
}
