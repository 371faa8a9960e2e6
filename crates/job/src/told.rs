//! What tests of bad input expect of every message: code, key, value, allowed range, way out, place.

use super::{Source, parse_any_job};

/// A change to a job, the code and the key that it is answered with, and parts of the message.
pub(super) type Case = (&'static str, &'static str, &'static str, &'static str, &'static [&'static str]);

/// Changes a job by every case and looks at the answer.
pub(super) fn told_in_full(job: &str, cases: &[Case]) {
    parse_any_job(Source::new("job.toml", job)).unwrap_or_else(|error| panic!("{error}"));
    for (from, to, code, field, says) in cases {
        assert!(job.contains(from), "the job has no `{from}`");
        let text = job.replacen(from, to, 1);
        let error = parse_any_job(Source::new("job.toml", &text)).expect_err(&format!("{from} -> {to}"));
        let about = format!("{from} -> {to}\n{error}");
        let found = error.diagnostics.iter().find(|d| d.code == *code && d.field.as_deref() == Some(field));
        let finding = found.unwrap_or_else(|| panic!("no {code} of {field}: {about}"));
        assert!(finding.allowed.is_some() && finding.way_out.is_some(), "{about}");
        let span = finding.span.clone().unwrap_or_else(|| panic!("no place: {about}"));
        if *code != "missing-key" {
            assert!(finding.value.is_some(), "{about}");
            // The place is that of the key, or of the table that the key is in.
            let (line, _) = error.source.line_column(span.start);
            let at = text.lines().nth(line - 1).unwrap();
            let key = field.rsplit('.').next().unwrap().split('[').next().unwrap();
            assert!(at.contains(key), "line {line} `{at}` has no `{key}`: {about}");
        }
        let message = finding.to_string();
        for said in *says {
            assert!(message.contains(said), "`{said}` is not said: {about}");
        }
    }
}
