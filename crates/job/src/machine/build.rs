//! From a description to a machine.

use nalgebra::Vector3;

use super::{AxisEntry, AxisType, ChainEntry, Control, Controls, MachineFile, Roles};
use crate::tables::Program;
use machine::{Axis, AxisLimits, InvalidMachine, Joint, Limb, Machine, MachineParts, Role};

impl Roles {
    /// Roles that are played, with the names of their axes.
    pub fn named(&self) -> impl Iterator<Item = (Role, &str)> {
        let all = [
            (Role::Radial, &self.radial),
            (Role::Axial, &self.axial),
            (Role::Tilt, &self.tilt),
            (Role::Shift, &self.shift),
            (Role::Tangential, &self.tangential),
            (Role::Worm, &self.worm),
            (Role::Work, &self.work),
            (Role::Swivel, &self.swivel),
            (Role::Dresser, &self.dresser),
        ];
        all.into_iter().filter_map(|(role, name)| Some((role, name.as_deref()?)))
    }
}

impl Controls {
    /// The control of a dialect.
    pub fn of(&self, dialect: Program) -> Option<&Control> {
        match dialect {
            Program::Linuxcnc => self.linuxcnc.as_ref(),
            Program::Siemens => self.siemens.as_ref(),
            Program::Fanuc => self.fanuc.as_ref(),
        }
    }

    /// The dialects that are there, by their keys.
    pub fn present(&self) -> impl Iterator<Item = (&'static str, &Control)> {
        let all = [("linuxcnc", &self.linuxcnc), ("siemens", &self.siemens), ("fanuc", &self.fanuc)];
        all.into_iter().filter_map(|(key, control)| Some((key, control.as_ref()?)))
    }
}

impl MachineFile {
    /// The machine that is described; its axes in the order of the limbs tool, work, dresser.
    ///
    /// # Errors
    /// [`InvalidMachine`] as [`Machine::new`].
    pub fn machine(&self) -> Result<Machine, InvalidMachine> {
        let chains = &self.chains;
        let mut order: Vec<&str> = Vec::new();
        let limbs = [Some(&chains.tool), Some(&chains.work), chains.dresser.as_ref()];
        for name in limbs.into_iter().flatten().flat_map(|limb| &limb.axes) {
            if !order.contains(&name.as_str()) {
                order.push(name);
            }
        }
        // Axes in no limb are kept, so that the check names them.
        order.extend(
            self.axes
                .keys()
                .map(String::as_str)
                .filter(|name| !limbs.iter().flatten().any(|l| l.axes.iter().any(|a| a == name))),
        );
        let number = |name: &str| order.iter().position(|known| *known == name).unwrap_or(usize::MAX);
        let limb = |chain: &ChainEntry| Limb {
            axes: chain.axes.iter().map(|name| number(name)).collect(),
            origin: chain.frame.origin_mm.map_or_else(Vector3::zeros, Vector3::from),
            x: Vector3::from(chain.frame.x),
            z: Vector3::from(chain.frame.z),
        };
        Machine::new(MachineParts {
            name: self.name.clone(),
            axes: order.iter().filter_map(|name| Some(axis(name, self.axes.get(*name)?))).collect(),
            roles: self.roles.named().map(|(role, name)| (role, number(name))).collect(),
            tool: limb(&chains.tool),
            work: limb(&chains.work),
            dresser: chains.dresser.as_ref().map(limb),
        })
    }
}

fn axis(name: &str, entry: &AxisEntry) -> Axis {
    let joint = match entry.kind {
        AxisType::Linear => Joint::Linear,
        AxisType::Rotary => Joint::Rotary,
    };
    let inner = |x: f64| joint.from_shown(x);
    let ends = match joint {
        Joint::Linear => entry.min_mm.zip(entry.max_mm),
        Joint::Rotary => entry.min_deg.zip(entry.max_deg),
    };
    Axis {
        name: name.to_owned(),
        joint,
        direction: Vector3::from(entry.direction),
        point: entry.point_mm.map_or_else(Vector3::zeros, Vector3::from),
        travel: ends.map(|(from, to)| [inner(from), inner(to)]),
        nc_sign: f64::from(entry.nc_sign.unwrap_or(1)),
        limits: AxisLimits {
            velocity: entry.max_velocity.map(inner),
            acceleration: entry.max_acceleration.map(inner),
            jerk: entry.max_jerk.map(inner),
        },
        resolution: entry.resolution.map(inner),
    }
}
