//! Requests as plain text to a server at an address.

use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use super::description;

/// Where a server listens.
#[derive(Clone, Copy, Debug)]
pub struct At(pub SocketAddr);

/// An answer.
#[derive(Debug)]
pub struct Answer {
    pub status: u16,
    pub head: String,
    pub body: Vec<u8>,
}

impl Answer {
    pub fn json(&self) -> Value {
        serde_json::from_slice(&self.body).unwrap_or_else(|error| panic!("{error}: {}", self.text()))
    }

    pub fn text(&self) -> String {
        String::from_utf8_lossy(&self.body).into_owned()
    }

    pub fn header(&self, name: &str) -> Option<&str> {
        let line =
            |line: &'_ str| line.split_once(": ").filter(|(key, _)| key.eq_ignore_ascii_case(name)).is_some();
        self.head.lines().find(|l| line(l)).and_then(|l| l.split_once(": ")).map(|(_, value)| value)
    }

    /// The code of the first finding.
    pub fn code(&self) -> String {
        self.json()["errors"][0]["code"].as_str().unwrap_or_default().to_owned()
    }
}

impl At {
    /// Sends a request as it stands; HTTP/1.0, so that the answer ends with the connection.
    pub fn raw(&self, request: &[u8]) -> Answer {
        let mut stream = TcpStream::connect(self.0).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(120))).unwrap();
        // A server that refuses a large body closes before all of it is sent.
        let _ = stream.write_all(request);
        let mut bytes = Vec::new();
        let _ = stream.read_to_end(&mut bytes);
        let end = bytes.windows(4).position(|four| four == b"\r\n\r\n").expect("an answer");
        let head = String::from_utf8_lossy(&bytes[..end]).into_owned();
        let status = head.split(' ').nth(1).and_then(|status| status.parse().ok()).expect("a status");
        Answer { status, head, body: bytes[end + 4..].to_vec() }
    }

    pub fn ask(&self, method: &str, path: &str, headers: &[(&str, &str)], body: &[u8]) -> Answer {
        let mut request = format!("{method} {path} HTTP/1.0\r\n");
        if !headers.iter().any(|(name, _)| *name == "Host") {
            request += &format!("Host: {}\r\n", self.0);
        }
        for (name, value) in headers {
            request += &format!("{name}: {value}\r\n");
        }
        request += &format!("Content-Length: {}\r\n\r\n", body.len());
        let answer = self.raw(&[request.as_bytes(), body].concat());
        description::hold(method, path, &answer);
        answer
    }

    pub fn get(&self, path: &str) -> Answer {
        self.ask("GET", path, &[], b"")
    }

    pub fn post(&self, path: &str, body: &Value) -> Answer {
        self.ask("POST", path, &[("Content-Type", "application/json")], body.to_string().as_bytes())
    }

    pub fn example(&self, id: &str) -> Value {
        self.get(&format!("/api/examples/{id}")).json()
    }

    /// Begins a run; its number.
    pub fn begin(&self, kind: &str, job: &Value) -> i64 {
        let answer = self.post("/api/runs", &json!({ "kind": kind, "job": job }));
        assert_eq!(answer.status, 202, "{}", answer.text());
        answer.json()["id"].as_i64().unwrap()
    }

    /// Waits for the end of a run.
    pub fn ended(&self, id: i64) -> Value {
        let begun = Instant::now();
        loop {
            let run = self.get(&format!("/api/runs/{id}")).json();
            if !["queued", "running"].contains(&run["state"].as_str().unwrap()) {
                return run;
            }
            assert!(begun.elapsed() < Duration::from_secs(240), "the run {id} does not end: {run}");
            thread::sleep(Duration::from_millis(30));
        }
    }

    /// Hands measurements in: name and bytes of each part; parts of the name `file` are files.
    pub fn hand_in(&self, parts: &[(&str, &str, &[u8])]) -> Answer {
        const EDGE: &str = "edge-of-the-parts";
        let mut body = Vec::new();
        for (part, name, bytes) in parts {
            let file = if *part == "file" { format!("; filename=\"{name}\"") } else { String::new() };
            body.extend(
                format!("--{EDGE}\r\nContent-Disposition: form-data; name=\"{part}\"{file}\r\n\r\n").bytes(),
            );
            body.extend_from_slice(bytes);
            body.extend(b"\r\n");
        }
        body.extend(format!("--{EDGE}--\r\n").bytes());
        let form = format!("multipart/form-data; boundary={EDGE}");
        self.ask("POST", "/api/measurements", &[("Content-Type", &form)], &body)
    }
}
