//! `flankwright store plans`: results of jobs.

use std::path::PathBuf;

use clap::{Args, Subcommand};
use flankwright::exchange::Diagnostic;
use flankwright_store::{PlanRecord, PlanSummary};
use serde_json::{Value, json};

use super::place::{PlaceArguments, bytes_of, failed};
use super::table::table;
use crate::exit::Exit;
use crate::failure::Failure;

/// Arguments of `store plans`.
#[derive(Args, Debug)]
#[command(arg_required_else_help = true)]
pub struct PlansArguments {
    /// What to do with them.
    #[command(subcommand)]
    pub action: PlansAction,
}

/// What to do with plans.
#[derive(Debug, Subcommand)]
pub enum PlansAction {
    /// Keep a result with the job that it belongs to; the same result of the same job once
    Add {
        /// result.json of `flankwright plan`
        #[arg(value_name = "RESULT")]
        result: PathBuf,
        /// The job that was planned
        #[arg(long, value_name = "JOB")]
        job: PathBuf,
        /// Store, and arguments that every command has.
        #[command(flatten)]
        place: PlaceArguments,
    },
    /// List the plans
    List {
        /// Store, and arguments that every command has.
        #[command(flatten)]
        place: PlaceArguments,
    },
    /// Print the result of a plan
    Show {
        /// Its number in the list
        #[arg(value_name = "NUMBER")]
        number: i64,
        /// Store, and arguments that every command has.
        #[command(flatten)]
        place: PlaceArguments,
    },
}

impl PlansArguments {
    /// Store, and arguments that every command has.
    pub fn place(&self) -> &PlaceArguments {
        match &self.action {
            PlansAction::Add { place, .. }
            | PlansAction::List { place }
            | PlansAction::Show { place, .. } => place,
        }
    }
}

/// Does it.
pub fn run(arguments: &PlansArguments) -> Result<Exit, Failure> {
    let place = arguments.place();
    match &arguments.action {
        PlansAction::Add { result, job, .. } => {
            let document = serde_json::from_slice(&bytes_of(result)?).map_err(|error| {
                let finding = Diagnostic::with_code(
                    "invalid-json",
                    format!("{} is no JSON: {error}", result.display()),
                );
                let way_out = "give the result.json that `flankwright plan` wrote";
                Failure::new(Exit::BadInput, finding.field("RESULT").way_out(way_out))
            })?;
            let plan = PlanRecord::of_result(document, &bytes_of(job)?).map_err(failed)?;
            let added = place.open()?.add_plan(&plan).map_err(failed)?;
            let word = if added { "added" } else { "known" };
            place.print(&json!({ "job": plan.job, "added": added }), || format!("{}: {word}\n", plan.job))?;
        }
        PlansAction::List { .. } => {
            let plans = place.open_existing()?.plans().map_err(failed)?;
            place.print(&plans, || text(&plans))?;
        }
        PlansAction::Show { number, .. } => {
            let found = place.open_existing()?.plan(*number).map_err(failed)?;
            let Some(plan) = found else {
                let finding = Diagnostic::with_code("unknown-plan", "the store has no plan of this number")
                    .field("NUMBER")
                    .value(number)
                    .way_out("look into `flankwright store plans list`");
                return Err(Failure::new(Exit::BadInput, finding));
            };
            let document: &Value = &plan.document;
            place.print(document, || format!("{document:#}\n"))?;
        }
    }
    Ok(Exit::Done)
}

fn text(plans: &[PlanSummary]) -> String {
    let row = |plan: &PlanSummary| {
        vec![
            plan.id.to_string(),
            plan.job.clone(),
            plan.status.clone(),
            plan.version.clone(),
            plan.digest.chars().take(12).collect(),
        ]
    };
    let rows: Vec<Vec<String>> = plans.iter().map(row).collect();
    format!("{} plans\n", plans.len())
        + &table(&["number", "job", "status", "version", "job's digest"], &rows)
}
