//! For tests of bad input: what is expected of every message: code, key, value, allowed range, hint, place. Used by the tests of every
//! process that has jobs.

use crate::load::parse_job_of;
use crate::process_job::ProcessJob;
use crate::source::Source;

/// A change to a job, the code and the key that it is answered with, and parts of the message.
pub type Case = (&'static str, &'static str, &'static str, &'static str, &'static [&'static str]);

/// Changes a job by every case and looks at the answer.
///
/// # Panics
/// Where the answer lacks something.
pub fn assert_found<J: ProcessJob>(job: &str, cases: &[Case]) {
    parse_job_of::<J>(Source::new("job.toml", job)).unwrap_or_else(|error| panic!("{error}"));
    for (from, to, code, field, says) in cases {
        assert!(job.contains(from), "the job has no `{from}`");
        let text = job.replacen(from, to, 1);
        let read = parse_job_of::<J>(Source::new("job.toml", &text));
        let Err(error) = read else { panic!("{from} -> {to} is taken") };
        let about = format!("{from} -> {to}\n{error}");
        let found = error.diagnostics.iter().find(|d| d.code == *code && d.field.as_deref() == Some(field));
        let finding = found.unwrap_or_else(|| panic!("no {code} of {field}: {about}"));
        assert!(finding.allowed.is_some() && finding.way_out.is_some(), "{about}");
        let span = finding.span.clone().unwrap_or_else(|| panic!("no place: {about}"));
        if *code != "missing-key" {
            assert!(finding.value.is_some(), "{about}");
            // The place is that of the key, or of the table that the key is in.
            let (line, _) = error.source.line_column(span.start);
            let at = text.lines().nth(line - 1).unwrap_or_default();
            let key = field.rsplit('.').next().unwrap_or_default().split('[').next().unwrap_or_default();
            assert!(at.contains(key), "line {line} `{at}` has no `{key}`: {about}");
        }
        let message = finding.to_string();
        for said in *says {
            assert!(message.contains(said), "`{said}` is not said: {about}");
        }
    }
}
