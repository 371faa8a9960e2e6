//! The list of the security of the application, item by item.

use std::io::{Read, Write};
use std::net::{Ipv4Addr, TcpStream};
use std::time::{Duration, Instant};

use crate::client::Served;
use serde_json::json;

const TOKEN: &str = "0123456789abcdef-TOKEN";

#[test]
fn only_known_names_are_answered() {
    let served = Served::with(Ipv4Addr::LOCALHOST, None, &["press-17.shop", "proxy.shop:443"]);
    let port = served.address.port();
    let status = |host: &str| served.ask("GET", "/api/about", &[("Host", host)], b"").status;
    for own in ["127.0.0.1", "localhost", "LOCALHOST", "[::1]", "press-17.shop"] {
        assert_eq!(status(&format!("{own}:{port}")), 200, "{own}");
    }
    assert_eq!(status("proxy.shop"), 200);
    for other in ["evil.example", "127.0.0.1.evil.example", "192.168.0.7"] {
        assert_eq!(status(&format!("{other}:{port}")), 421, "{other}");
    }
    assert_eq!(status("localhost"), 421, "another port");
    assert_eq!(served.raw(b"GET /api/about HTTP/1.0\r\n\r\n").status, 400, "no host");
}

#[test]
fn pages_of_other_origins_are_refused() {
    let served = Served::new();
    let own = format!("http://{}", served.address);
    let from = |method: &str, header: (&str, &str)| {
        let headers = [("Content-Type", "application/json"), header];
        served.ask(method, "/api/check", &headers, b"{\"text\": \"\"}").status
    };
    assert_eq!(from("POST", ("Origin", &own)), 200);
    assert_eq!(from("POST", ("Sec-Fetch-Site", "same-origin")), 200);
    for other in ["http://evil.example", "null", "http://localhost:1", "file://"] {
        assert_eq!(from("POST", ("Origin", other)), 403, "{other}");
    }
    for site in ["cross-site", "same-site", "none"] {
        assert_eq!(from("POST", ("Sec-Fetch-Site", site)), 403, "{site}");
    }
    // Nor is anything read for them; who opens an address comes from nowhere, and pages may be linked to.
    let read = |path: &str, site: &str| served.ask("GET", path, &[("Sec-Fetch-Site", site)], b"").status;
    for (path, site, status) in [
        ("/api/about", "cross-site", 403),
        ("/api/about", "same-site", 403),
        ("/api/about", "none", 200),
        ("/api/about", "same-origin", 200),
        ("/", "cross-site", 200),
    ] {
        assert_eq!(read(path, site), status, "{path} {site}");
    }
    // A form of another page cannot send JSON without being asked for leave, and leave is never given.
    assert_eq!(served.ask("POST", "/api/check", &[("Content-Type", "text/plain")], b"{}").status, 415);
    assert_eq!(
        served.ask("OPTIONS", "/api/check", &[("Origin", &own)], b"").header("access-control-allow-origin"),
        None
    );
}

#[test]
fn off_the_loopback_a_token_is_needed() {
    let served = Served::with(Ipv4Addr::UNSPECIFIED, None, &[]);
    let made = served.opened.split_once("token=").expect("a token is made").1.to_owned();
    assert_eq!(made.len(), 32);
    let served = Served::with(Ipv4Addr::UNSPECIFIED, Some(TOKEN), &[]);
    assert!(served.opened.ends_with(TOKEN));
    let with = |headers: &[(&str, &str)]| served.ask("GET", "/api/about", headers, b"").status;
    assert_eq!(with(&[]), 401);
    assert_eq!(served.get("/").status, 401);
    assert_eq!(with(&[("Authorization", "Bearer 0123456789abcdef-TOKEM")]), 401);
    assert_eq!(with(&[("Authorization", &format!("Bearer {TOKEN}"))]), 200);
    let name = format!("flankwright-{}", served.address.port());
    assert_eq!(with(&[("Cookie", &format!("a=b; {name}={TOKEN}"))]), 200);
    assert_eq!(with(&[("Cookie", &format!("flankwright-1={TOKEN}"))]), 401, "that of another server");
    assert_eq!(with(&[("Cookie", &format!("other={TOKEN}"))]), 401);
    assert_eq!(served.get("/?token=wrong").status, 401);
    assert_eq!(
        served.get(&format!("/api/about?token={TOKEN}")).status,
        401,
        "only the page takes it from the address"
    );
    let entered = served.get(&format!("/?token={TOKEN}"));
    assert_eq!((entered.status, entered.header("location")), (303, Some("/")));
    let cookie = entered.header("set-cookie").unwrap().to_owned();
    assert!(cookie.starts_with(&format!("{name}={TOKEN}; HttpOnly; SameSite=Lax")), "{cookie}");
    // The token goes out of the address also where the browser has it already.
    let again = served.ask("GET", &format!("/?token={TOKEN}"), &[("Cookie", &cookie)], b"");
    assert_eq!((again.status, again.header("location")), (303, Some("/")));
    assert!(served.opened.starts_with("http://localhost:"), "{}", served.opened);
    // Any address of the machine in figures is its own; names are not.
    let port = served.address.port();
    let bearer = format!("Bearer {TOKEN}");
    let under = |host: &str| with(&[("Host", host), ("Authorization", &bearer)]);
    assert_eq!(under(&format!("192.168.0.7:{port}")), 200);
    assert_eq!(under(&format!("evil.example:{port}")), 421);
}

#[test]
fn every_answer_says_what_may_be_loaded() {
    let served = Served::new();
    for path in ["/", "/api/about", "/api/none", "/none", "/api/schema"] {
        let answer = served.get(path);
        let policy = answer.header("content-security-policy").unwrap();
        assert!(policy.starts_with("default-src 'none'"), "{path}: {policy}");
        assert!(!policy.contains("unsafe") && !policy.contains("http"), "{path}: {policy}");
        assert_eq!(answer.header("x-content-type-options"), Some("nosniff"), "{path}");
        assert_eq!(answer.header("x-frame-options"), Some("DENY"), "{path}");
        assert_eq!(answer.header("referrer-policy"), Some("no-referrer"), "{path}");
    }
}

#[test]
fn bodies_are_bounded() {
    let served = Served::new();
    let large = vec![b' '; (8 << 20) + 1];
    let answer = served.ask("POST", "/api/check", &[("Content-Type", "application/json")], &large);
    assert_eq!((answer.status, answer.code().as_str()), (413, "body-too-large"));
    assert_eq!(answer.json()["errors"][0]["allowed"], "at most 8388608 bytes");
    // Also where much more is sent than is taken, the answer comes through.
    let large = vec![b'1'; 80 << 20];
    let answer = served.hand_in(&[("file", "a.mka", &large)]);
    assert_eq!((answer.status, answer.code().as_str()), (413, "body-too-large"));
    let blank = " ".repeat((4 << 20) + 1);
    for (path, request) in [
        ("/api/runs", json!({ "kind": "plan", "job": { "text": blank } })),
        ("/api/edit", json!({ "text": "", "edits": [{ "path": ["a"], "value": blank }] })),
    ] {
        let answer = served.post(path, &request);
        assert_eq!(answer.status, 422, "{path}: {}", answer.text());
    }
    assert_eq!(
        served.post("/api/check", &json!({ "text": blank })).json()["findings"][0]["code"],
        "file-too-large"
    );
    let deep = "[".repeat(100_000);
    let answer = served.ask("POST", "/api/check", &[("Content-Type", "application/json")], deep.as_bytes());
    assert_eq!(answer.code(), "invalid-request", "{}", answer.status);
    let nested = format!("a = {}", "[".repeat(100_000));
    let answer = served.post("/api/check", &json!({ "text": nested }));
    assert_eq!((answer.status, answer.json()["valid"].clone()), (200, json!(false)));
}

#[test]
fn requests_with_bodies_are_bounded_in_number() {
    let served = Served::new();
    let half = format!(
        "POST /api/check HTTP/1.1\r\nHost: {}\r\nContent-Type: application/json\r\nContent-Length: 100\r\n\r\n{{",
        served.address
    );
    let open = || {
        let mut stream = TcpStream::connect(served.address).unwrap();
        stream.write_all(half.as_bytes()).unwrap();
        stream
    };
    let check = || served.post("/api/check", &json!({ "text": "" }));
    let mut held = Vec::new();
    let refused = loop {
        let answer = check();
        if answer.status != 200 {
            break answer;
        }
        held.push(open());
        assert!(held.len() < 200, "there is no end of room");
    };
    assert_eq!((refused.status, refused.code().as_str()), (503, "server-busy"));
    assert_eq!(served.get("/api/about").status, 200, "others are answered");
    assert_eq!(served.ask("DELETE", "/api/runs/1", &[], b"").status, 404, "without a body there is room");
    drop(held);
    let begun = Instant::now();
    while check().status != 200 {
        assert!(begun.elapsed() < Duration::from_secs(10), "room does not come back");
    }
}

#[test]
fn connections_without_a_request_are_closed() {
    let served = Served::new();
    let begun = Instant::now();
    let mut half = TcpStream::connect(served.address).unwrap();
    half.write_all(b"GET /api/about HTTP/1.1\r\nHost:").unwrap();
    let mut idle = TcpStream::connect(served.address).unwrap();
    idle.write_all(format!("GET /api/about HTTP/1.1\r\nHost: {}\r\n\r\n", served.address).as_bytes())
        .unwrap();
    for stream in [&mut half, &mut idle] {
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        let mut told = Vec::new();
        stream.read_to_end(&mut told).expect("it is closed in time");
    }
    assert!(begun.elapsed() > Duration::from_secs(5), "slow clients are given some time");
}

#[test]
fn clients_that_read_nothing_are_given_up() {
    let served = Served::new();
    let request = format!("GET /api/schema HTTP/1.1\r\nHost: {}\r\n\r\n", served.address).repeat(60);
    let held: Vec<TcpStream> = (0..256)
        .map(|_| {
            let mut stream = TcpStream::connect(served.address).unwrap();
            stream.write_all(request.as_bytes()).unwrap();
            stream
        })
        .collect();
    // Every connection is taken by somebody who does not listen; others wait until those are given up.
    let begun = Instant::now();
    assert_eq!(served.get("/api/about").status, 200);
    assert!(begun.elapsed() < Duration::from_secs(100));
    drop(held);
}

#[test]
fn what_no_name_holds_is_refused() {
    let served = Served::new();
    for path in ["/api/parts?series=%00", "/api/parts/%00", "/api/tools/%00", "/api/runs/1/files/%00"] {
        assert_eq!(
            (served.get(path).status, served.get(path).code().as_str()),
            (422, "invalid-request"),
            "{path}"
        );
    }
    let text = "[job]\nname = \"a\\u0000b\"\n";
    let run = served.ended(served.begin("plan", &json!({ "text": text })));
    assert_eq!((&run["name"], &run["state"]), (&json!("a b"), &json!("failed")));
    let options = json!({ "keep": true, "series": "a\0" }).to_string();
    let answer = served.hand_in(&[("file", "a.mka", b"1"), ("options", "", options.as_bytes())]);
    assert_eq!((answer.status, answer.code().as_str()), (422, "invalid-option"));
}

#[test]
fn paths_of_edits_are_bounded() {
    let served = Served::new();
    let edit = |steps: usize, text: &str| {
        let path = vec!["a"; steps];
        served.post("/api/edit", &json!({ "text": text, "edits": [{ "path": path, "value": 1 }] }))
    };
    assert_eq!(edit(64, "").status, 200);
    for steps in [65, 100_000, 1_000_000] {
        let answer = edit(steps, "");
        assert_eq!((answer.status, answer.code().as_str()), (422, "invalid-edit"), "{steps}");
    }
    assert_eq!(edit(1, &" ".repeat((4 << 20) + 1)).code(), "file-too-large");
    assert_eq!(edit(1, "a = \"\0\"").code(), "invalid-text");
    let answer = served.post("/api/check", &json!({ "text": "a = 1\0" })).json();
    assert_eq!(answer["findings"][0]["code"], "invalid-text");
}

#[test]
fn no_path_of_the_disk_can_be_named() {
    let served = Served::new();
    for name in
        ["../x", "/etc/passwd", "a\\b", "a/../../b", "", ".hidden", "a/.measured", "a//b", "a/", "machines"]
    {
        let answer = served.post("/api/check", &json!({ "text": "", "files": { name: "x" } }));
        assert_eq!((answer.status, answer.code().as_str()), (422, "invalid-file-name"), "{name}");
        let answer = served
            .post("/api/runs", &json!({ "kind": "plan", "job": { "text": "", "files": { name: "x" } } }));
        assert_eq!(answer.status, 422, "{name}");
    }
    let text = served.example("variable-ratio")["text"].as_str().unwrap().to_owned();
    for path in ["/etc/passwd", "../../../../../../etc/passwd"] {
        let answer =
            served.post("/api/check", &json!({ "text": text.replace("variable-ratio.csv", path) })).json();
        assert!(answer["findings"][0]["message"].as_str().unwrap().contains("does not exist"), "{answer}");
    }
    for path in
        ["/../Cargo.toml", "/assets/../../Cargo.toml", "/%2e%2e/Cargo.toml", "/api/examples/..%2f..%2fCargo"]
    {
        assert_eq!(served.get(path).status, 404, "{path}");
    }
}

#[test]
fn clients_that_do_nothing_hold_nothing_up() {
    let served = Served::new();
    let id = served.begin("plan", &served.example("twist-free-crowning"));
    let idle: Vec<TcpStream> = (0..100)
        .map(|k| {
            let mut stream = TcpStream::connect(served.address).unwrap();
            // Half a request, or a listener that never reads.
            let text = if k % 2 == 0 {
                "GET /api/ab".to_owned()
            } else {
                format!("GET /api/runs/{id}/events HTTP/1.1\r\nHost: {}\r\n\r\n", served.address)
            };
            stream.write_all(text.as_bytes()).unwrap();
            stream
        })
        .collect();
    assert_eq!(served.ended(id)["state"], "done");
    assert_eq!(served.get("/api/about").status, 200);
    drop(idle);
    assert_eq!(served.get("/api/about").status, 200);
}
