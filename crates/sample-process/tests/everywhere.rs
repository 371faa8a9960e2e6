//! A process that a program adds appears wherever processes appear: templates, schema, check, plan with its files, the answer to a job of
//! another command, the web application.

use serde_json::Value;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Command, Output, Stdio};

const PROGRAM: &str = env!("CARGO_BIN_EXE_flankwright-sample-process");
const NAME: &str = "tip-chamfering";

fn run(arguments: &[&str]) -> Output {
    Command::new(PROGRAM).args(arguments).output().expect("the program runs")
}

fn printed(arguments: &[&str]) -> String {
    let output = run(arguments);
    assert!(output.status.success(), "{arguments:?}: {output:?}");
    String::from_utf8(output.stdout).expect("text")
}

fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&printed(arguments)).expect("JSON")
}

/// The template in a folder, with one line changed.
fn job(folder: &Path, from: &str, to: &str) -> String {
    let path = folder.join("chamfer.toml");
    std::fs::write(&path, printed(&["new", NAME]).replace(from, to)).expect("a job");
    path.display().to_string()
}

#[test]
fn the_command_knows_it() {
    assert!(printed(&["new", "--help"]).contains(NAME));
    assert_eq!(json(&["new", NAME, "--json"])["chamfer"]["width"], 0.3);
    let schema = json(&["schema"]);
    let names = schema["$defs"]["Process"]["oneOf"].as_array().expect("names");
    assert!(names.iter().any(|name| name["const"] == NAME), "{names:?}");
    assert!(schema["$defs"]["Chamfer"]["properties"]["width"].is_object());
}

#[test]
fn a_job_is_checked_planned_and_judged() {
    let folder = tempfile::tempdir().expect("a folder");
    let sound = job(folder.path(), "", "");
    let derived = json(&["check", &sound, "--json"]);
    let land = derived["derived"]["tip"]["tip_land_mm"].as_f64().expect("a width");
    // Half the pitch angle less the involute functions: written down from the drawing, not from the program.
    let (z, m, x, alpha, beta) = (29.0f64, 2.5f64, 0.1f64, 20f64.to_radians(), 15f64.to_radians());
    let alpha_t = (alpha.tan() / beta.cos()).atan();
    let base = z * m / beta.cos() * alpha_t.cos();
    let inv = |angle: f64| angle.tan() - angle;
    let thickness = std::f64::consts::FRAC_PI_2 / z + 2.0 * x * alpha.tan() / z;
    let expected = 80.5 * (thickness + inv(alpha_t) - inv((base / 80.5).acos()));
    assert!((land - expected).abs() < 1e-6, "{land} {expected}");

    let planned = run(&["plan", &sound]);
    assert_eq!(planned.status.code(), Some(0), "{planned:?}");
    let out = folder.path().join("chamfer.out");
    let result: Value =
        serde_json::from_slice(&std::fs::read(out.join("result.json")).expect("a result")).expect("JSON");
    assert_eq!((&result["status"], &result["process"]), (&"met".into(), &NAME.into()));
    let page = std::fs::read_to_string(out.join("report.html")).expect("a report");
    assert!(page.contains("The chamfers leave a tip land"), "{page}");

    let wide = job(folder.path(), "width = 0.3 ", "width = 2.0 ");
    assert_eq!(run(&["plan", &wide]).status.code(), Some(3));
}

#[test]
fn what_is_wrong_is_named_and_other_commands_refuse_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let wrong = run(&["check", &job(folder.path(), "width = 0.3 ", "width = -0.3 "), "--json"]);
    let error: Value = serde_json::from_slice(&wrong.stdout).expect("JSON");
    assert_eq!((wrong.status.code(), &error["error"]["field"]), (Some(2), &"chamfer.width".into()));
    let sound = job(folder.path(), "", "");
    for command in ["simulate", "explore", "gearbox"] {
        let refused = run(&[command, &sound, "--json"]);
        let error: Value = serde_json::from_slice(&refused.stdout).expect("JSON");
        assert_eq!(error["error"]["code"], "process-not-available", "{command}");
        assert_eq!(refused.status.code(), Some(2), "{command}");
    }
}

#[test]
fn the_web_application_lists_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let store = folder.path().join("store.sqlite");
    let mut server = Command::new(PROGRAM)
        .args(["serve", "--port", "0", "--store"])
        .arg(store)
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("the server runs");
    let mut lines = BufReader::new(server.stdout.take().expect("its output")).lines();
    let address = lines.by_ref().map_while(Result::ok).find_map(|line| {
        let from = line.find("http://")? + "http://".len();
        line[from..].split('/').next().map(str::to_owned)
    });
    let about = address.map(|address| {
        let mut stream = TcpStream::connect(&address).expect("a connection");
        write!(stream, "GET /api/about HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n")
            .expect("a request");
        let mut answer = String::new();
        stream.read_to_string(&mut answer).expect("an answer");
        answer
    });
    server.kill().expect("the server stops");
    server.wait().expect("the server has stopped");
    let about = about.expect("the server names its address");
    assert!(about.contains(NAME) && about.contains("Tip chamfering"), "{about}");
}
