//! Whatever stands in a job file: an answer, never a panic.

use flankwright::exchange::{Source, job_template, parse_any_job};
use flankwright::processes;
use flankwright::workflow::AnyProcess;
use flankwright_cli::failure::Failure;
use proptest::prelude::*;

/// Reads the bytes as both formats and draws every message.
fn read(bytes: &[u8]) {
    for name in ["a.toml", "a.json", "a"] {
        if let Err(error) = Source::from_bytes(name, bytes).and_then(parse_any_job) {
            assert!(!error.diagnostics.is_empty());
            for diagnostic in &error.diagnostics {
                if let Some(span) = &diagnostic.span {
                    assert!(
                        span.start <= span.end && span.end <= error.source.text().len(),
                        "{diagnostic:?}"
                    );
                }
                assert!(!diagnostic.message.is_empty());
            }
            let failure = Failure::from(error);
            assert!(!failure.to_text(false).is_empty());
            assert!(failure.to_json()["error"]["code"].is_string());
        }
    }
}

fn names() -> Vec<&'static str> {
    processes().all().map(AnyProcess::name).collect()
}

/// A job of each process as TOML and as JSON.
fn job(process: &str) -> (String, String) {
    let template = job_template(process).expect("a template");
    let toml = match process {
        // With the keys that hold names and with settings, which the template has in comments only.
        "tangential-dressing" => {
            let named = "[dressing]\nvariables = [\"Fp1\", \"dX2\"]\nsplines = [{ channel = \"dX\", intervals = 6 }]\nexclude = [\"gA\"]\n";
            let settings = "[settings.right]\nkap = 1.2\nvalues = { Fp1 = 0.001, dX2 = -0.006 }\n";
            template.replacen("[dressing]\n", named, 1) + settings
        }
        // With choices, which the template has in comments only.
        "electronic-gearbox" => {
            let explore = "[explore]\nwanted_um = 0.5\nscales = [{ pulses_per_metre = 1e5, cost = 1 }]\n";
            template.to_owned() + explore
        }
        // With contact heights from root to tip, which the template has in a comment only.
        "five-axis-milling" => {
            let heights = "contact_height = { from = 6.0, to = 15.0 }\ntraverse = \"zigzag\"\n";
            template.replacen("contact_height = 6.16", heights, 1)
        }
        // With a stylus and a mandrel, which the template has in comments only.
        "skiving-tool-measuring" => {
            let stylus = "[stylus]\npoint = [300.0, 20.0, 150.0]\nradius = 0.5\nteeth = [0, 14, 28]\n";
            let mandrel = "[calibration]\nradius = 10.0\nheight = 5.0\nheights = [140.0, 240.0]\n";
            template.to_owned() + stylus + mandrel
        }
        _ => crate::command::example("automotive-bias.toml"),
    };
    let json = parse_any_job(Source::new("job.toml", &toml)).expect("a valid example").to_json();
    (toml, json.expect("JSON"))
}

/// What is put into a job in place of something else.
fn piece() -> impl Strategy<Value = String> {
    prop_oneof![
        prop::sample::select(vec![
            "",
            "nan",
            "-inf",
            "1e308",
            "-1e-308",
            "0",
            "-1",
            "999999999999999999999",
            "\"",
            "'",
            "[",
            "]",
            "{",
            "}",
            "{}",
            "[]",
            "=",
            ",",
            "\n",
            "\n\n[gear]\n",
            "true",
            "null",
            "\"auto\"",
            "µ",
            "\u{feff}",
            "1979-05-27",
            "#",
            ".",
            "\\u00e4",
            "\"\\ud800\"",
            "x = 1\n",
            "kind",
            "\t",
            "\r",
        ])
        .prop_map(str::to_owned),
        any::<f64>().prop_map(|v| format!("{v:e}")),
        any::<i64>().prop_map(|v| v.to_string()),
        "\\PC{0,12}",
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        read(&bytes);
    }

    #[test]
    fn any_text(text in "[\\[\\]{}=\",.:a-z0-9#\\n \\\\-]{0,200}") {
        read(text.as_bytes());
    }

    #[test]
    fn changed_jobs(changes in prop::collection::vec((any::<prop::sample::Index>(), 0usize..12, piece()), 1..5), json in any::<bool>(), process in prop::sample::select(names())) {
        let (toml, as_json) = job(process);
        let mut text: Vec<char> = if json { as_json } else { toml }.chars().collect();
        for (place, length, piece) in changes {
            let start = place.index(text.len() + 1);
            let end = (start + length).min(text.len());
            text.splice(start..end, piece.chars());
        }
        read(text.into_iter().collect::<String>().as_bytes());
    }

    #[test]
    fn changed_values(place in any::<prop::sample::Index>(), piece in piece(), process in prop::sample::select(names())) {
        let (toml, _) = job(process);
        // Entries of the form `key = value` on a line of their own.
        let lines: Vec<&str> = toml.lines().collect();
        let entries: Vec<usize> = (0..lines.len()).filter(|&i| lines[i].contains(" = ") && !lines[i].starts_with([' ', '#'])).collect();
        let changed = entries[place.index(entries.len())];
        let text: String = lines.iter().enumerate().map(|(i, line)| {
            let key = line.split(" = ").next().unwrap_or_default();
            if i == changed { format!("{key} = {piece}\n") } else { format!("{line}\n") }
        }).collect();
        read(text.as_bytes());
    }

    #[test]
    fn cut_jobs(place in any::<prop::sample::Index>(), json in any::<bool>(), process in prop::sample::select(names())) {
        let (toml, as_json) = job(process);
        let text = if json { as_json } else { toml };
        read(&text.as_bytes()[..place.index(text.len())]);
    }
}
