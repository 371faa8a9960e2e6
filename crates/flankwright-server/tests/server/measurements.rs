//! Measurements that are handed in, and what the store keeps of them.

use crate::client::Served;
use serde_json::json;

#[test]
fn a_table_is_judged_by_its_job() {
    let served = Served::new();
    let job = served.example("inspection/measured");
    let table = include_bytes!("../../../../examples/inspection/measured.csv");
    let answer = served.hand_in(&[("file", "measured.csv", table), ("job", "", job.to_string().as_bytes())]);
    assert_eq!(answer.status, 202, "{}", answer.text());
    let run = served.ended(answer.json()["id"].as_i64().unwrap());
    assert_eq!(
        (&run["state"], &run["kind"], &run["measurements"]),
        (&json!("done"), &json!("inspect"), &json!(["measured.csv"])),
        "{run}"
    );
    let files: Vec<&str> =
        run["files"].as_array().unwrap().iter().map(|f| f["name"].as_str().unwrap()).collect();
    for name in ["sheet.html", "report.html", "corrected-job.json"] {
        assert!(files.contains(&name), "{files:?}");
    }
    // The corrected job is one that the server takes again.
    let corrected = served.get(&format!("/api/runs/{}/files/corrected-job.json", run["id"])).text();
    assert_eq!(served.post("/api/check", &json!({ "text": corrected })).json()["valid"], json!(true));
    let again = served.post(&format!("/api/runs/{}/again", run["id"]), &json!(null)).json();
    assert_eq!(served.ended(again["id"].as_i64().unwrap())["document"]["status"], run["document"]["status"]);
}

#[test]
fn measured_parts_are_kept_and_followed() {
    let served = Served::new();
    let part = include_bytes!("../../../../fuzz/seeds/klingelnberg/curves.mka");
    let options = json!({ "class": 6, "keep": true, "series": "pinions" }).to_string();
    let parts = [("file", "part-1.mka", &part[..]), ("options", "", options.as_bytes())];
    let run = served.ended(served.hand_in(&parts).json()["id"].as_i64().unwrap());
    assert_eq!(run["state"], "done", "{run}");
    assert_eq!(run["document"]["kept"]["imported"][0]["series"], "pinions", "{run}");
    let series = served.get("/api/series").json();
    assert_eq!((&series[0]["series"], &series[0]["parts"]), (&json!("pinions"), &json!(1)), "{series}");
    let kept = served.get("/api/parts?series=pinions").json();
    let digest = kept[0]["digest"].as_str().unwrap();
    assert_eq!(served.get(&format!("/api/parts/{digest}")).json()["series"], "pinions");
    let values = served.get("/api/trends?series=pinions").json();
    let name = values[0]["name"].as_str().unwrap_or_else(|| panic!("{values}"));
    let of_name = served.get(&format!("/api/trends?series=pinions&name={name}")).json();
    assert_eq!(of_name[0], values[0]);
    assert_eq!(served.get("/api/trends?series=others").json(), json!([]));
    // Handed in again, it is known.
    let again = served.ended(served.hand_in(&parts).json()["id"].as_i64().unwrap());
    let told = &again["document"]["kept"];
    assert_eq!((told["imported"].as_array().unwrap().len(), told["known"].as_array().unwrap().len()), (0, 1));
    assert_eq!(told["known"][0]["file"], "part-1.mka");
    // Without a wish nothing is kept.
    let alone = served.ended(served.hand_in(&parts[..1]).json()["id"].as_i64().unwrap());
    assert_eq!(alone["document"].get("kept"), None);
}

#[test]
fn what_is_not_kept_is_not_there() {
    let served = Served::new();
    for path in [
        "/api/series",
        "/api/parts?series=pinions",
        "/api/trends?series=pinions&name=fHa&flank=left",
        "/api/tools",
    ] {
        assert_eq!(served.get(path).json(), json!([]), "{path}");
    }
    for path in [
        "/api/trends?flank=upper",
        "/api/parts?from=yesterday",
        "/api/parts?newest=0",
        "/api/trends?newest=10001",
    ] {
        assert_eq!(served.get(path).status, 422, "{path}");
    }
    for path in ["/api/parts/none", "/api/tools/none"] {
        assert_eq!(served.get(path).status, 404, "{path}");
    }
    assert!(served.get("/api/catalogue").json()["worm"].is_array());
}

#[test]
fn what_lies_beside_a_measurement_is_told() {
    let served = Served::new();
    let part = include_bytes!("../../../../fuzz/seeds/klingelnberg/curves.mka");
    let table = include_bytes!("../../../../examples/inspection/measured.csv");
    let parts = [("file", "part-1.mka", &part[..]), ("file", "measured.csv", &table[..])];
    let run = served.ended(served.hand_in(&parts).json()["id"].as_i64().unwrap());
    assert_eq!(
        (&run["state"], &run["document"]["left_out"][0]["file"]),
        (&json!("done"), &json!("measured.csv")),
        "{run}"
    );
}

#[test]
fn what_is_no_measurement_is_refused_by_name() {
    let served = Served::new();
    let refused = |parts: &[(&str, &str, &[u8])], code: &str| {
        let answer = served.hand_in(parts);
        assert_eq!((answer.status, answer.code().as_str()), (422, code), "{}", answer.text());
    };
    refused(&[], "invalid-request");
    refused(&[("x", "", b"1")], "invalid-request");
    refused(&[("file", "", b"1")], "invalid-request");
    refused(&[("file", "a.mka", b"1"), ("file", "a.mka", b"1")], "invalid-request");
    refused(&[("file", "a.mka", b"1"), ("options", "", b"{\"class\": 99}")], "invalid-option");
    refused(&[("file", "a.mka", b"1"), ("options", "", b"{\"klass\": 9}")], "invalid-request");
    refused(&[("file", "a.mka", b"1"), ("job", "", b"[]")], "invalid-request");
    refused(&[("file", "a.mka", b"1"), ("options", "", b"{}"), ("options", "", b"{}")], "invalid-request");
    for (name, bytes) in [
        ("part.mka", &b"\xff\xfe\x00"[..]),
        ("part.rexsz", b"PK\x03\x04"),
        ("part.rexs", b"<model"),
        ("part.txt", b"hello"),
        ("..\\..\\part.mka", b"1"),
    ] {
        let answer = served.hand_in(&[("file", name, bytes)]);
        assert_eq!(answer.status, 202, "{name}: {}", answer.text());
        let run = served.ended(answer.json()["id"].as_i64().unwrap());
        assert_eq!((&run["state"], &run["failure"]["exit"]), (&json!("failed"), &json!(2)), "{name}: {run}");
    }
}

/// The job of the example as the server lists it, without the table that was made of its blank.
fn job_of_the_blank(served: &Served) -> Vec<u8> {
    let job = served.example("cycles/measured-blank").to_string();
    assert!(job.contains("measured-blank-stock.csv"), "{job}");
    job.into_bytes()
}

#[test]
fn the_stock_of_a_blank_is_a_table_for_its_job() {
    let served = Served::new();
    let job = job_of_the_blank(&served);
    let blank = include_bytes!("../../../../examples/inspection/blank.csv");
    let options = json!({ "blank": true, "language": "de" }).to_string();
    let parts = [("file", "blank.csv", &blank[..]), ("job", "", &job), ("options", "", options.as_bytes())];
    let answer = served.hand_in(&parts);
    assert_eq!(answer.status, 202, "{}", answer.text());
    let run = served.ended(answer.json()["id"].as_i64().unwrap());
    assert_eq!((&run["state"], &run["document"]["job"]), (&json!("done"), &json!("measured-blank")), "{run}");
    assert_eq!(run["document"]["level_from"], "stock.allowance_um");
    let table = served.get(&format!("/api/runs/{}/files/stock.csv?download=true", run["id"])).text();
    // The table that the example has beside it was made in the same way.
    let known = include_str!("../../../../examples/cycles/measured-blank-stock.csv");
    assert_eq!(table, known);
    // Without a job there is no finished gear; a class judges no stock.
    let refused = |parts: &[(&str, &str, &[u8])], code: &str, field: &str| {
        let answer = served.hand_in(parts);
        let told = answer.json();
        let first = &told["errors"][0];
        assert_eq!(
            (answer.status, &first["code"], &first["field"]),
            (422, &json!(code), &json!(field)),
            "{told}"
        );
    };
    refused(&[parts[0], parts[2]], "invalid-request", "job");
    let judged = json!({ "blank": true, "class": 6 }).to_string();
    refused(&[parts[0], parts[1], ("options", "", judged.as_bytes())], "invalid-option", "class");
    let french = json!({ "language": "fr" }).to_string();
    refused(&[parts[0], ("options", "", french.as_bytes())], "invalid-option", "language");
}

#[test]
fn a_stored_part_takes_the_place_of_its_file() {
    let served = Served::new();
    let file = include_bytes!("../../../../fuzz/seeds/klingelnberg/curves.mka");
    let keep = json!({ "keep": true, "from_other_end": true }).to_string();
    let run = served.hand_in(&[("file", "part-1.mka", &file[..]), ("options", "", keep.as_bytes())]);
    served.ended(run.json()["id"].as_i64().unwrap());
    let kept = served.get("/api/parts").json()[0].clone();
    assert_eq!(kept["has_files"], json!(true), "{kept}");
    let digest = kept["digest"].as_str().unwrap();
    // Evaluated again as it was stated then, in German.
    let german = json!({ "language": "de" }).to_string();
    let answer =
        served.hand_in(&[("part", "", &digest.as_bytes()[..12]), ("options", "", german.as_bytes())]);
    assert_eq!(answer.status, 202, "{}", answer.text());
    let run = served.ended(answer.json()["id"].as_i64().unwrap());
    assert_eq!((&run["state"], &run["measurements"]), (&json!("done"), &json!(["part-1.mka"])), "{run}");
    assert_eq!(run["document"]["stated"], json!(["measured from the other end"]));
    let report = served.get(&format!("/api/runs/{}/files/report.html", run["id"])).text();
    assert!(report.contains("<html lang=\"de\""), "{}", &report[..200]);
    // As a blank: the gear of the job is another one, which the run tells.
    let job = job_of_the_blank(&served);
    let blank = json!({ "blank": true }).to_string();
    let parts = [("part", "", digest.as_bytes()), ("job", "", &job[..]), ("options", "", blank.as_bytes())];
    let run = served.ended(served.hand_in(&parts).json()["id"].as_i64().unwrap());
    assert_eq!(
        (&run["state"], &run["failure"]["errors"][0]["code"]),
        (&json!("failed"), &json!("other-gear")),
        "{run}"
    );
    let refused = |parts: &[(&str, &str, &[u8])], code: &str| {
        let answer = served.hand_in(parts);
        let told = answer.json();
        let first = &told["errors"][0];
        assert_eq!(
            (answer.status, &first["code"], &first["field"]),
            (422, &json!(code), &json!("part")),
            "{told}"
        );
        assert!(first["way_out"].is_string());
    };
    refused(&[("part", "", b"none")], "unknown-value");
    refused(&[("part", "", digest.as_bytes()), ("file", "part-1.mka", &file[..])], "invalid-request");
}
