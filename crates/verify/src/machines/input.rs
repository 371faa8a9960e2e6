//! What the cases of machine chains are given: machines, poses, mounts, rules, axis positions.

use super::super::reference::Reference;
use foundation::kinematics::{
    Dresser, DressingPosition, GeneratingChain, GeneratingState, Pose, Workpiece, Worm,
};
use job::Source;
use job::machine::{LoadedMachine, parse_machine};
use machine::{
    DressingRule, Joint, Machine, MachineError, Mount, Mounts, Positions, Station, StationSpindle,
    ToolSpindle,
};
use serde::Deserialize;
use serde_json::Value;
use std::collections::BTreeMap;
use std::error::Error;

/// A machine of the file, read as a machine file is.
pub(super) fn machine(file: &Reference<'_>, name: &str) -> Result<LoadedMachine, Box<dyn Error>> {
    let mut description = file.root["machines"][name].clone();
    let Some(table) = description.as_object_mut() else {
        return Err(format!("the file has no machine {name}").into());
    };
    table.insert("name".into(), name.into());
    Ok(parse_machine(Source::new("machine.json", &description.to_string()))?)
}

/// Which of the two jobs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum JobName {
    Grinding,
    Dressing,
}

impl JobName {
    pub fn station(self) -> Station {
        match self {
            Self::Grinding => Station::Work,
            Self::Dressing => Station::Dresser,
        }
    }
}

/// A body in its spindle; absent keys are 0.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct MountInput {
    reversed: bool,
    z_0_mm: f64,
    phi_0_deg: f64,
}

impl From<MountInput> for Mount {
    fn from(given: MountInput) -> Self {
        Self { reversed: given.reversed, axial: given.z_0_mm, angle: given.phi_0_deg.to_radians() }
    }
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct MountsInput {
    worm: MountInput,
    work: MountInput,
    dresser: MountInput,
}

impl MountsInput {
    pub fn at(self, station: Station) -> Mounts {
        let counterpart = match station {
            Station::Work => self.work,
            Station::Dresser => self.dresser,
        };
        Mounts { tool: self.worm.into(), counterpart: counterpart.into() }
    }
}

/// A pose of two bodies, of whichever job.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(untagged)]
pub(super) enum PoseInput {
    Grinding(GrindingPose),
    Dressing(DressingPose),
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "keys of the reference file")]
pub(super) struct GrindingPose {
    phi_1_deg: f64,
    phi_2_deg: f64,
    z_V1_mm: f64,
    z_V2_mm: f64,
    d_mm: f64,
    gamma_deg: f64,
    #[serde(default)]
    theta_1_deg: f64,
    #[serde(default)]
    r_w1_mm: f64,
    #[serde(default)]
    theta_2_deg: f64,
    #[serde(default)]
    r_w2_mm: f64,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "keys of the reference file")]
pub(super) struct DressingPose {
    phi_S_deg: f64,
    v_zS_mm: f64,
    gamma_A_deg: f64,
    d_A_mm: f64,
    v_yA_mm: f64,
    phi_A_deg: f64,
}

impl PoseInput {
    /// H under the mounts.
    pub fn spindles(&self, mounts: &Mounts) -> Pose<ToolSpindle, StationSpindle> {
        match self {
            Self::Grinding(at) => {
                let chain = GeneratingChain {
                    centre_distance: at.d_mm,
                    crossed_axes_angle: at.gamma_deg.to_radians(),
                    worm_cone: at.theta_1_deg.to_radians(),
                    work_cone: at.theta_2_deg.to_radians(),
                    worm_pivot: at.r_w1_mm,
                    work_pivot: at.r_w2_mm,
                };
                let [worm_angle, work_angle] = self.angles();
                let state = GeneratingState {
                    worm_angle,
                    work_angle,
                    shift: at.z_V1_mm,
                    feed: at.z_V2_mm,
                    delta_d: 0.0,
                    delta_gamma: 0.0,
                };
                let pose: Pose<Worm, Workpiece> = chain.pose(&state);
                mounts.spindles(&pose)
            }
            Self::Dressing(at) => {
                let position = DressingPosition {
                    worm_angle: at.phi_S_deg.to_radians(),
                    worm_shift: at.v_zS_mm,
                    crossing_angle: at.gamma_A_deg.to_radians(),
                    centre_distance: at.d_A_mm,
                    offset: at.v_yA_mm,
                };
                let turned: Pose<Worm, Dresser> = position.pose().then(&Pose::rz(at.phi_A_deg.to_radians()));
                mounts.spindles(&turned)
            }
        }
    }

    /// Own angles of tool and counterpart, rad.
    pub fn angles(&self) -> [f64; 2] {
        let degrees = match self {
            Self::Grinding(at) => [at.phi_1_deg, at.phi_2_deg],
            Self::Dressing(at) => [at.phi_S_deg, at.phi_A_deg],
        };
        degrees.map(f64::to_radians)
    }
}

/// What closes the system in dressing.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct RuleInput {
    swivel_deg: Option<f64>,
    worm_deg: Option<f64>,
    axial_mm: Option<f64>,
    worm_hint_deg: Option<f64>,
}

impl RuleInput {
    /// All positions that give the pose; `worm` stands for the wanted worm angle where the rule names none.
    pub fn solve(
        &self,
        machine: &Machine,
        station: Station,
        pose: &Pose<ToolSpindle, StationSpindle>,
        worm: Option<f64>,
    ) -> Result<Vec<Positions>, MachineError> {
        if station == Station::Work {
            return machine.grinding(pose);
        }
        let rule = match (self.worm_deg, self.axial_mm) {
            (Some(angle), _) => DressingRule::WormAngle(angle.to_radians()),
            (None, Some(slide)) => DressingRule::AxialSlide(slide),
            (None, None) => DressingRule::Swivel(self.swivel_deg.unwrap_or(0.0).to_radians()),
        };
        machine.dressing(pose, rule, self.worm_hint_deg.map(f64::to_radians).or(worm))
    }
}

/// Keys of axis positions: `X1_mm`, `A1_deg`.
pub(super) fn axis_key(machine: &Machine, axis: usize) -> String {
    let axis = &machine.axes()[axis];
    format!("{}_{}", axis.name, axis.joint.unit())
}

/// Axis positions of a case.
pub(super) fn positions(
    machine: &Machine,
    station: Station,
    given: &Value,
) -> Result<Positions, Box<dyn Error>> {
    let mut given: BTreeMap<String, f64> = BTreeMap::deserialize(given)?;
    let mut at = Positions::default();
    for axis in machine.axes_at(station)? {
        let key = axis_key(machine, axis);
        let value = given.remove(&key).ok_or_else(|| format!("{key} is missing"))?;
        at[axis] = machine.axes()[axis].joint.from_shown(value);
    }
    match given.keys().next() {
        Some(unknown) => Err(format!("{unknown} is no axis of this job").into()),
        None => Ok(at),
    }
}

/// Period of an axis position in the unit of files, deg; `None` for mm.
pub(super) fn period(machine: &Machine, axis: usize) -> Option<f64> {
    (machine.axes()[axis].joint == Joint::Rotary).then_some(360.0)
}
