//! Jobs of the electronic gearbox at the command line: what `check` derives, the table of reference pulses, and the commands
//! that do not take them.

use crate::command::{repository, run, run_with};
use std::path::Path;

/// The template with a table of reference pulses in place of its motion.
fn job_with_table(directory: &Path, table: &str) -> String {
    let template = run(&["new", "electronic-gearbox"]).stdout;
    let (begin, end) = (template.find("motion = [").unwrap(), template.find("# start").unwrap());
    let text = format!("{}references = \"train.csv\"\n{}", &template[..begin], &template[end..]);
    std::fs::write(directory.join("train.csv"), table).unwrap();
    let path = directory.join("job.toml");
    std::fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn check_derives_pitch_speed_and_lead() {
    let job = run(&["new", "electronic-gearbox"]).stdout;
    let derived = run_with(&["check", "-", "--json"], job.as_bytes()).json()["derived"].take();
    assert_eq!(derived["feed"]["pitch_mm"], 0.01);
    // 1 MHz, 10 um, 16 pulses: 625 mm/s.
    assert_eq!(derived["feed"]["greatest_speed_mm_per_min"], 37500.0);
    // pi 2.5 40/sin(20 deg)
    let lead = derived["gear"]["lead_mm"].as_f64().unwrap();
    assert!((lead - 918.540_242_4).abs() < 1e-6, "{lead}");
    let human = run_with(&["check", "-"], job.as_bytes());
    assert!(human.stdout.contains("greatest speed v_max"), "{human:?}");
    let spur = job.replace("helix_angle_deg = 20.0", "helix_angle_deg = 0.0");
    let answer = run_with(&["check", "-", "--json"], spur.as_bytes());
    assert_eq!(answer.exit, Some(0));
    assert!(answer.json()["derived"]["gear"].is_null());
}

#[test]
fn check_reads_the_table_of_reference_pulses() {
    let directory = tempfile::tempdir().unwrap();
    let path = job_with_table(directory.path(), "tick,sign\n100,1\n260,1\n420,-1\n");
    let sound = run(&["check", "--json", &path]);
    assert_eq!(sound.exit, Some(0), "{sound:?}");
    assert_eq!(sound.json()["derived"]["stimulus"]["reference_pulses"], 3);

    let path = job_with_table(directory.path(), "tick,sign\n100,1\n260,up\n");
    let (human, machine) = (run(&["check", &path]), run(&["check", "--json", &path]));
    assert_eq!((human.exit, machine.exit), (Some(2), Some(2)));
    let error = machine.json()["error"].take();
    assert_eq!((&error["line"], &error["column"]), (&3.into(), &5.into()), "{error}");
    assert_eq!((&error["code"], &error["field"]), (&"invalid-number".into(), &"sign".into()));
    assert!(error["file"].as_str().unwrap().ends_with("train.csv"));
    assert!(human.message().contains("train.csv:3:5"), "{}", human.stderr);

    std::fs::remove_file(directory.path().join("train.csv")).unwrap();
    assert_eq!(run(&["check", "--json", &path]).json()["error"]["code"], "unreadable-file");
}

#[test]
fn other_commands_name_the_one_that_takes_the_job() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("job.toml");
    std::fs::write(&path, run(&["new", "electronic-gearbox"]).stdout).unwrap();
    let path = path.to_str().unwrap();
    let program = directory.path().join("program.ngc");
    std::fs::write(&program, "G21 G90\nG1 Z1 F100\nM2\n").unwrap();
    let machine = repository().join("machines/no-swivel.toml");
    let checked = [
        "program",
        "check",
        program.to_str().unwrap(),
        "--machine",
        machine.to_str().unwrap(),
        "--dialect",
        "linuxcnc",
        "--job",
        path,
    ];
    for arguments in [&["plan", path][..], &["simulate", path], &["explore", path], &checked] {
        let (human, answer) = (run(arguments), run(&[arguments, &["--json"]].concat()));
        assert_eq!((human.exit, answer.exit), (Some(2), Some(2)), "{human:?}");
        let error = answer.json()["error"].take();
        assert_eq!(
            (&error["code"], &error["field"]),
            (&"process-not-available".into(), &"job.process".into()),
            "{error}"
        );
        assert!(error["line"].is_u64(), "{error}");
        assert!(human.message().contains("flankwright gearbox FILE"), "{}", human.stderr);
    }
    assert_eq!(std::fs::read_dir(directory.path()).unwrap().count(), 2);
}
