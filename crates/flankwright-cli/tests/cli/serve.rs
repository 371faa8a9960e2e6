//! `serve` as a process: what it prints, what it refuses, what is left of it when it is killed.

use std::io::{BufRead, BufReader};
use std::net::{SocketAddr, TcpListener};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::command::run;
use serde_json::{Value, json};

#[allow(dead_code, reason = "the tests of the server ask for more")]
#[path = "../../../flankwright-server/tests/server/http.rs"]
mod http;

/// The tests of the server hold its answers against their description; here the command that serves is tested.
mod description {
    pub fn hold(_method: &str, _path: &str, _answer: &super::http::Answer) {}
}

use http::At;

/// A server in a process of its own; it is killed with this.
struct Server {
    child: Child,
    at: At,
}

impl Server {
    fn new(store: &str) -> Self {
        let mut child = Command::new(env!("CARGO_BIN_EXE_flankwright"))
            .args(["serve", "--json", "--port", "0", "--store", store])
            .env_remove("FLANKWRIGHT_TOKEN")
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let told: Value = serde_json::from_str(&line).unwrap();
        let address = told["address"].as_str().unwrap();
        let address: SocketAddr =
            address.trim_start_matches("http://").trim_end_matches('/').parse().unwrap();
        assert!(address.ip().is_loopback());
        Self { child, at: At(address) }
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // SIGKILL: nothing can be put in order.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[test]
fn a_run_whose_server_is_killed_is_interrupted_and_can_be_begun_again() {
    let folder = tempfile::tempdir().unwrap();
    let store = folder.path().join("store.sqlite").display().to_string();
    let server = Server::new(&store);
    let short = server.at.begin("plan", &server.at.example("gearbox/reference-train"));
    let whole = server.at.ended(short);
    assert_eq!(whole["state"], "done");
    let job = server.at.example("catalogue-free-diameter");
    let long: Vec<i64> = (0..3).map(|_| server.at.begin("explore", &job)).collect();
    let state = |at: &At, id: i64| at.get(&format!("/api/runs/{id}")).json()["state"].clone();
    let begun = Instant::now();
    while state(&server.at, long[0]) != "running" {
        assert!(begun.elapsed() < Duration::from_secs(60), "the run does not begin");
    }
    drop(server);
    // Another port, and another name of the same file: it is the store that they share.
    let server = Server::new(
        &folder
            .path()
            .join("../")
            .join(folder.path().file_name().unwrap())
            .join("store.sqlite")
            .display()
            .to_string(),
    );
    for &id in &long {
        assert_eq!(state(&server.at, id), "interrupted");
    }
    assert_eq!(server.at.ended(short), whole, "what had ended is whole");
    let again = server.at.post(&format!("/api/runs/{}/again", long[0]), &Value::Null);
    let id = again.json()["id"].as_i64().unwrap();
    assert!(["queued", "running"].contains(&state(&server.at, id).as_str().unwrap()));
    assert_eq!(server.at.post(&format!("/api/runs/{id}/cancel"), &Value::Null).status, 200);
    assert_eq!(server.at.ended(id)["job"], json!(job));
}

#[test]
fn a_server_that_is_told_to_end_ends_though_clients_hold_on() {
    let folder = tempfile::tempdir().unwrap();
    let store = folder.path().join("store.sqlite").display().to_string();
    let mut server = Server::new(&store);
    let id = server.at.begin("explore", &server.at.example("catalogue-free-diameter"));
    let held: Vec<_> = [
        "GET /api/ab".to_owned(),
        format!("GET /api/runs/{id}/events HTTP/1.1\r\nHost: {}\r\n\r\n", server.at.0),
    ]
    .iter()
    .map(|text| {
        let mut stream = std::net::TcpStream::connect(server.at.0).unwrap();
        std::io::Write::write_all(&mut stream, text.as_bytes()).unwrap();
        stream
    })
    .collect();
    let told = Command::new("kill").args(["-TERM", &server.child.id().to_string()]).status().unwrap();
    assert!(told.success());
    let begun = Instant::now();
    let status = loop {
        match server.child.try_wait().unwrap() {
            Some(status) => break status,
            None => assert!(begun.elapsed() < Duration::from_secs(30), "it does not end"),
        }
        std::thread::sleep(Duration::from_millis(50));
    };
    assert_eq!(status.code(), Some(0));
    drop(held);
    // What was under way is told as interrupted.
    let next = Server::new(&store);
    assert_eq!(next.at.get(&format!("/api/runs/{id}")).json()["state"], "interrupted");
}

#[test]
fn what_cannot_be_served_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let store = folder.path().join("store.sqlite").display().to_string();
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    let refused = run(&["serve", "--port", &port, "--store", &store, "--json"]);
    assert_eq!((refused.exit, &refused.json()["error"]["code"]), (Some(2), &json!("address-not-available")));
    let refused = run(&["serve", "--port", "0", "--store", "postgres://127.0.0.1:1/none", "--json"]);
    assert_eq!((refused.exit, &refused.json()["error"]["code"]), (Some(2), &json!("unreachable-store")));
    let refused = Command::new(env!("CARGO_BIN_EXE_flankwright"))
        .args(["serve", "--port", "0", "--store", &store, "--json"])
        .env("FLANKWRIGHT_TOKEN", "short")
        .output()
        .unwrap();
    let told: Value = serde_json::from_slice(&refused.stdout).unwrap();
    assert_eq!((refused.status.code(), &told["error"]["code"]), (Some(2), &json!("invalid-token")));
    assert_eq!(run(&["serve", "--host", "nowhere"]).exit, Some(2));
}
