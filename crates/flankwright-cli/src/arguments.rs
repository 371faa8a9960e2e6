//! The command line.

use clap::{Parser, Subcommand};

use crate::commands::check::CheckArguments;
use crate::commands::convert::ConvertArguments;
use crate::commands::explore::ExploreArguments;
use crate::commands::gearbox::GearboxArguments;
use crate::commands::inspect::InspectArguments;
use crate::commands::new::NewArguments;
use crate::commands::plan::PlanArguments;
use crate::commands::program::ProgramArguments;
use crate::commands::schema::SchemaArguments;
use crate::commands::serve::ServeArguments;
use crate::commands::simulate::SimulateArguments;
use crate::commands::store::StoreArguments;
use crate::commands::verify::VerifyArguments;
use crate::common_arguments::CommonArguments;

/// Plans, simulates and proves the manufacture of gear teeth.
#[derive(Debug, Parser)]
#[command(name = "flankwright", version, propagate_version = true, arg_required_else_help = true)]
#[command(
    after_help = "Example:\n  flankwright new generating-grinding > job.toml\n  flankwright check job.toml\n  flankwright plan job.toml\n\n\
    Exit status: 0 done, 1 internal error, 2 bad input, 3 target missed, 4 not producible"
)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Print a commented, runnable example job
    New(NewArguments),
    /// Print the JSON schema of job files, catalogues, machines or results (draft 2020-12)
    Schema(SchemaArguments),
    /// Check a job and print the geometry derived from it
    Check(CheckArguments),
    /// Plan a job: target -> settings -> motions -> simulated flank -> report
    Plan(PlanArguments),
    /// Run the settings that stand in a job: what comes out
    Simulate(SimulateArguments),
    /// Vary diagonal ratio, cone angle and crossing angle: a ranked table and the residual over the ratio
    Explore(ExploreArguments),
    /// Read a measurement and evaluate it: deviations, verdict, correction
    Inspect(InspectArguments),
    /// Pass a gear and its modifications between a job and a REXS model
    Convert(ConvertArguments),
    /// Run the electronic gearbox on a stimulus: pulses, additional rotation, errors, servo, set-ups
    Gearbox(GearboxArguments),
    /// Read an NC program and tell what it does on a machine
    Program(ProgramArguments),
    /// Keep measured parts, catalogue, plans and tool histories beyond one run
    Store(StoreArguments),
    /// The web application on 127.0.0.1
    Serve(ServeArguments),
    /// Recompute every expected value of reference files and compare
    #[cfg_attr(not(feature = "verify"), command(hide = true))]
    Verify(VerifyArguments),
}

impl Command {
    /// The arguments that every command has.
    pub fn common(&self) -> &CommonArguments {
        match self {
            Command::New(arguments) => &arguments.common,
            Command::Schema(arguments) => &arguments.common,
            Command::Check(arguments) => &arguments.common,
            Command::Plan(arguments) => &arguments.common,
            Command::Simulate(arguments) => &arguments.common,
            Command::Explore(arguments) => &arguments.common,
            Command::Inspect(arguments) => &arguments.common,
            Command::Convert(arguments) => &arguments.common,
            Command::Gearbox(arguments) => &arguments.common,
            Command::Program(arguments) => &arguments.common,
            Command::Store(arguments) => arguments.common(),
            Command::Serve(arguments) => &arguments.place.common,
            Command::Verify(arguments) => &arguments.common,
        }
    }
}
