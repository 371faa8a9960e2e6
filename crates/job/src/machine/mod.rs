//! Machine descriptions (`machines/*.toml`): axes, limbs, roles and what the controls call them. Knows no job.

mod axis;
mod body;
mod body_checks;
mod build;
mod checks;
mod contradiction;
pub mod control;
mod description;
pub mod read;

pub use axis::{AxisEntry, AxisType};
pub use body::BodyEntry;
pub use control::{Control, ControlCoupling, Controls, Decimals};
pub use description::{ChainEntry, Chains, FrameEntry, MachineFile, Roles};
pub use read::{LoadedMachine, machine_schema, parse_machine, read_machine};
