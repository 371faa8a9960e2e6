//! What is wrong with stock, strokes and limits, as findings on keys of the job.

use grinding_technology::TechnologyError;
use job::{Diagnostic, Problem, shown_number};
use run::RunFailure;

/// The key of a job that an input of the technology comes from.
fn key_of(field: &str) -> String {
    match field {
        "optimise.stock_um" => "stock.allowance_um".into(),
        "optimise.cutting_speed_m_per_s" => "machine.cutting_speed_m_per_s".into(),
        "optimise.overrun" => "grinding.overrun".into(),
        "optimise.K_finishing" | "optimise.K_roughing" => "grinding.diagonal_ratio".into(),
        _ => match field.split_once('.') {
            Some(("optimise", key)) => format!("technology.limits.{}", key.trim_start_matches("allowed_")),
            Some(("life" | "times" | "cost", _)) => format!("technology.{field}"),
            _ => field.to_owned(),
        },
    }
}

/// The finding of an error.
pub(super) fn refused(error: &TechnologyError) -> RunFailure {
    match error {
        TechnologyError::OutOfRange { field, value, allowed } => {
            let text = "stock, strokes and limits do not go together";
            let finding = Diagnostic::new(Problem::InvalidNumber, text)
                .field(key_of(field))
                .value(shown_number(*value))
                .allowed(allowed.clone())
                .way_out("see docs/job-file.md for what [stock] and [technology] take");
            RunFailure::bad_input(finding)
        }
        TechnologyError::NoFeasiblePlan { limit, feed, least, needed } => {
            let key = key_of(limit);
            let text = format!(
                "no cycle keeps the limits: {key} allows a feed of {} mm per revolution, the least is {} mm",
                shown_number((feed * 1e5).floor() / 1e5),
                shown_number(*least)
            );
            let way_out = format!(
                "set it to {} or more, allow smaller feeds (technology.limits.least_feed) or more roughing strokes",
                shown_number((needed * 1e3).ceil() / 1e3)
            );
            let finding = Diagnostic::with_code(error.code(), text).field(key);
            RunFailure::not_producible(finding.way_out(way_out))
        }
        _ => {
            let finding = Diagnostic::with_code(error.code(), error.to_string()).field("stock");
            RunFailure::bad_input(finding.way_out(error.way_out().into_owned()))
        }
    }
}
