//! Channels and variables of the process with the names that a job uses.

use crate::workflow::finding;
use crate::{Channel, TangentialError, Variable, job as drawn};
use run::RunFailure;

/// The channel of the process with the name of the one in the job.
///
/// # Errors
/// A finding on `field` if the process knows no such channel.
pub(super) fn channel_of(channel: drawn::Channel, field: &str) -> Result<Channel, RunFailure> {
    Channel::of_name(channel.name()).ok_or_else(|| {
        let error = TangentialError::UnknownVariable { name: channel.name().to_owned() };
        finding::on_field(&error, field)
    })
}

/// The variable of the process with the name of the one in the job.
///
/// # Errors
/// A finding on `field` if the process knows no such variable.
pub(super) fn variable_of(variable: drawn::Variable, field: &str) -> Result<Variable, RunFailure> {
    variable.to_string().parse().map_err(|error| finding::on_field(&error, field))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_words_of_jobs_are_those_of_the_process() {
        let mut count = 0;
        for variable in drawn::Variable::all() {
            let own = variable_of(variable, "dressing.variables").unwrap();
            assert_eq!(own.to_string(), variable.to_string());
            assert_eq!(own.channel, channel_of(variable.channel(), "dressing.exclude").unwrap());
            count += 1;
        }
        // All powers of all channels but the constant of a profile, which is a thickness.
        let profiles = Channel::ALL.iter().filter(|c| matches!(c, Channel::Profile(_))).count();
        assert_eq!(count, (Channel::ALL.len() - 1) * 10 - profiles + 1);
        assert_eq!(drawn::Channel::ALL.map(drawn::Channel::name), Channel::ALL.map(Channel::name));
    }
}
