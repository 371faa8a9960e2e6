//! The store as a user meets it: import, lists, catalogue, plans, histories, check, and what is refused. Uses files of SQLite; the same
//! library on a server is tested in flankwright-store.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use tempfile::TempDir;

use crate::command::{Run, repository, run};

#[path = "../../../flankwright-store/tests/store/made_file.rs"]
pub mod made_file;

use made_file::mka;

/// A directory with a store and a folder of measurements.
struct Shop(TempDir);

impl Shop {
    fn new(parts: u32) -> Self {
        let directory = tempfile::tempdir().unwrap();
        fs::create_dir(directory.path().join("measured")).unwrap();
        for number in 0..parts {
            fs::write(directory.path().join(format!("measured/part-{number:04}.mka")), mka(number)).unwrap();
        }
        Self(directory)
    }

    fn path(&self, name: &str) -> String {
        self.0.path().join(name).to_str().unwrap().to_owned()
    }

    /// `store` with these words on the store of this shop.
    fn store(&self, words: &[&str]) -> Run {
        let place = self.path("data/store.sqlite");
        run(&[&["store"], words, &["--store", &place]].concat())
    }

    fn json(&self, words: &[&str], exit: i32) -> Value {
        let run = self.store(&[words, &["--json"]].concat());
        assert_eq!((run.exit, run.stderr.as_str()), (Some(exit), ""), "{run:?}");
        run.json()
    }
}

#[test]
fn measurements_are_imported_once_and_listed() {
    let shop = Shop::new(5);
    let run = shop.store(&["import", &shop.path("measured"), "--class", "6"]);
    assert_eq!(
        (run.exit, run.stdout.as_str()),
        (Some(0), "5 parts imported, 0 known, 0 files refused\n"),
        "{run:?}"
    );
    let again = shop.json(&["import", &shop.path("measured"), &shop.path("measured/part-0001.mka")], 0);
    assert_eq!(
        (again["imported"].as_array().unwrap().len(), again["known"].as_array().unwrap().len()),
        (0, 5)
    );

    let parts = shop.json(&["parts", "--series", "Z-17", "--from", "2026-02-01"], 0);
    let numbers: Vec<&str> =
        parts.as_array().unwrap().iter().map(|part| part["part"].as_str().unwrap()).collect();
    assert_eq!(numbers, ["0", "1", "2", "3", "4"]);
    assert_eq!(parts[1]["date"], "2026-02-01T08:01:31");
    assert_eq!(shop.json(&["parts", "--to", "2026-01-31"], 0), json!([]));

    let values =
        shop.json(&["parts", "--characteristic", "fHb", "--flank", "left", "--statistic", "mean"], 0);
    assert_eq!(values.as_array().unwrap().len(), 5);
    assert_eq!(
        (&values[0]["name"], &values[0]["flank"], &values[0]["unit"]),
        (&json!("fHb"), &json!("left"), &json!("um"))
    );
    assert!(values[0]["upper_limit"].as_f64().unwrap() > 0.0);
    // The slope of the made parts grows with their number.
    let slope = |k: usize| values[k]["value"].as_f64().unwrap().abs();
    assert!(slope(4) > slope(0) + 0.5, "{values}");

    let listed = shop.store(&["parts", "--part", "3", "--characteristic", "Fa"]);
    assert!(
        listed.stdout.starts_with("10 values\n") && listed.stdout.contains("Fa.right.tooth-12.single"),
        "{listed:?}"
    );
    let listed = shop.store(&["parts"]);
    assert!(listed.stdout.contains("2026-02-01T08:04:31  Z-17"), "{listed:?}");

    let health = shop.json(&["check"], 0);
    assert_eq!(
        (&health["parts"], &health["faults"], &health["kind"]),
        (&json!(5), &json!([]), &json!("sqlite"))
    );
}

#[test]
fn refused_files_are_told_and_the_others_go_on() {
    let shop = Shop::new(2);
    let (bad, missing) = (shop.path("measured/bad.mka"), shop.path("none.mka"));
    fs::write(&bad, "HEADER KS.MK.FILE\n21 :mn : 1\n").unwrap();
    let report = shop.json(&["import", &missing, &shop.path("measured")], 3);
    assert_eq!(report["imported"].as_array().unwrap().len(), 2);
    let refused = report["refused"].as_array().unwrap();
    let told: Vec<(&str, &str)> =
        refused.iter().map(|one| (one["file"].as_str().unwrap(), one["code"].as_str().unwrap())).collect();
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(
        told.contains(&(&bad, "missing-code")) && told.contains(&(&missing, "unreadable-file")),
        "{told:?}"
    );
    let run = shop.store(&["import", &bad]);
    assert_eq!(run.exit, Some(2), "{run:?}");
    assert!(run.stdout.contains("1 files refused") && run.stdout.contains("remedy: "), "{run:?}");
}

#[test]
fn what_is_known_can_be_evaluated_again() {
    let shop = Shop::new(3);
    let measured = shop.path("measured");
    shop.json(&["import", &measured], 0);
    fs::write(shop.0.path().join("measured/lines.csv"), "tooth\n").unwrap();
    let again = shop.json(&["import", &measured, "--again", "--class", "5", "--series", "trial"], 0);
    assert_eq!((&again["replaced"], again["imported"].as_array().unwrap().len()), (&json!(3), 3));
    assert_eq!(again["left_out"][0]["file"], "lines.csv");
    let parts = shop.json(&["parts"], 0);
    let series: Vec<_> = parts.as_array().unwrap().iter().map(|part| part["series"].clone()).collect();
    assert_eq!(series, ["trial", "trial", "trial"]);
    let text = shop.store(&["import", &measured, "--again"]);
    assert!(text.stdout.contains("3 parts imported (3 of them again), 0 known"), "{text:?}");
    assert!(text.stdout.contains("left out: lines.csv"), "{text:?}");
}

#[test]
fn the_catalogue_goes_in_and_out() {
    let shop = Shop::new(0);
    let added = shop.json(&["catalogue", "add", "examples/catalogue/bodies.toml"], 0);
    assert!(added["added"].as_u64().unwrap() > 10);
    let file = shop.path("bodies.json");
    assert_eq!(shop.store(&["catalogue", "export", &file]).exit, Some(0));
    let again = shop.json(&["catalogue", "add", &file, "--replace"], 0);
    assert_eq!(again, json!({ "added": 0, "changed": 0, "unchanged": added["added"], "removed": 0 }));
    let listed = shop.store(&["catalogue", "list"]);
    assert!(listed.stdout.contains("worm     W1-01"), "{listed:?}");
    let printed = shop.store(&["catalogue", "export"]);
    assert_eq!(printed.stdout, fs::read_to_string(&file).unwrap());
    // A job takes the exported file.
    let job = fs::read_to_string(repository().join("examples/catalogue.toml")).unwrap();
    let job = job.replace("catalogue/bodies.toml", "bodies.json");
    fs::write(shop.path("job.toml"), job).unwrap();
    let checked = run(&["check", &shop.path("job.toml")]);
    assert_eq!(checked.exit, Some(0), "{checked:?}");

    fs::write(&file, "{\"worm\": 3}").unwrap();
    let run = shop.store(&["catalogue", "add", &file, "--json"]);
    assert_eq!((run.exit, &run.json()["error"]["code"]), (Some(2), &json!("wrong-type")), "{run:?}");
}

#[test]
fn plans_are_kept_with_their_job() {
    let shop = Shop::new(0);
    let (job, result) = (shop.path("job.toml"), shop.path("result.json"));
    fs::write(&job, "name = \"ring\"").unwrap();
    fs::write(&result, r#"{"job": "ring", "status": "met", "version": "0.1.0", "timing_s": {"all": 1.5}}"#)
        .unwrap();
    assert_eq!(
        shop.json(&["plans", "add", &result, "--job", &job], 0),
        json!({ "job": "ring", "added": true })
    );
    assert_eq!(shop.json(&["plans", "add", &result, "--job", &job], 0)["added"], false);
    let plans = shop.json(&["plans", "list"], 0);
    assert_eq!((plans.as_array().unwrap().len(), &plans[0]["status"]), (1, &json!("met")));
    let number = plans[0]["id"].to_string();
    assert_eq!(shop.json(&["plans", "show", &number], 0)["timing_s"]["all"], 1.5);
    assert!(shop.store(&["plans", "list"]).stdout.contains("ring  met"));
    for (words, code) in [
        (vec!["plans", "show", "77"], "unknown-plan"),
        (vec!["plans", "add", &job, "--job", &job], "invalid-json"),
        (vec!["plans", "add", "none.json", "--job", &job], "unreadable-file"),
    ] {
        let refused = shop.json(&words, 2);
        assert_eq!(refused["error"]["code"], code, "{refused}");
        assert!(
            refused["error"]["field"].is_string() && refused["error"]["way_out"].is_string(),
            "{refused}"
        );
    }
}

#[test]
fn histories_are_added_once() {
    let shop = Shop::new(0);
    let example = "examples/skiving/history.jsonl";
    let added = shop.json(&["history", "add", example], 0)["added"].as_u64().unwrap();
    assert_eq!(shop.json(&["history", "add", example], 0), json!({ "added": 0, "known": added }));
    let listed = shop.json(&["history", "list"], 0);
    let lines: Vec<Value> = fs::read_to_string(repository().join(example))
        .unwrap()
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert_eq!(listed, Value::Array(lines));
    let tool = listed[0]["tool"].as_str().unwrap().to_owned();
    assert!(shop.store(&["history", "list", "--tool", &tool]).stdout.contains(&tool));
    assert_eq!(shop.json(&["history", "list", "--tool", "none"], 0), json!([]));
}

#[test]
fn a_store_that_is_not_there_or_no_store_is_told() {
    let shop = Shop::new(0);
    for words in [
        vec!["parts"],
        vec!["check"],
        vec!["catalogue", "list"],
        vec!["plans", "list"],
        vec!["history", "list"],
    ] {
        let refused = shop.json(&words, 2);
        assert_eq!(
            (&refused["error"]["code"], &refused["error"]["field"]),
            (&json!("missing-store"), &json!("store"))
        );
    }
    assert!(!Path::new(&shop.path("data")).exists(), "asking makes no store");
    fs::write(shop.path("text"), "no store".repeat(1000)).unwrap();
    let refused = |address: &str| {
        let run = run(&["store", "check", "--json", "--store", address]);
        assert_eq!(run.exit, Some(2), "{run:?}");
        assert!(!run.stdout.contains("geheim"), "{run:?}");
        run.json()["error"]["code"].as_str().unwrap().to_owned()
    };
    assert_eq!(refused(&shop.path("text")), "not-a-store");
    assert_eq!(refused("mysql://shop:geheim@host/gears"), "invalid-store-address");
    assert_eq!(refused("postgres://shop:geheim@127.0.0.1:1/gears"), "unreachable-store");
}

/// The command with an environment of its own.
fn with(variables: &[(&str, &str)], words: &[&str]) -> std::process::Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_flankwright"));
    command.args(words).current_dir(repository());
    command.env_remove("FLANKWRIGHT_STORE").env_remove("XDG_DATA_HOME").env_remove("HOME");
    command.envs(variables.iter().copied()).output().unwrap()
}

#[test]
fn the_store_is_named_by_option_variable_or_the_users_data() {
    let shop = Shop::new(0);
    let add = ["store", "history", "add", "examples/skiving/history.jsonl", "--quiet"];
    let made = |variables: &[(&str, &str)], option: Option<&str>, file: &str| {
        let words = [&add[..], &option.map_or(vec![], |path| vec!["--store", path])].concat();
        let output = with(variables, &words);
        assert!(output.status.success() && output.stdout.is_empty(), "{output:?}");
        assert!(Path::new(&shop.path(file)).is_file(), "{file}");
    };
    let home = shop.path("");
    made(&[("HOME", &home)], None, ".local/share/flankwright/store.sqlite");
    made(&[("HOME", &home), ("XDG_DATA_HOME", &shop.path("data"))], None, "data/flankwright/store.sqlite");
    made(&[("HOME", &home), ("FLANKWRIGHT_STORE", &shop.path("variable"))], None, "variable");
    made(&[("FLANKWRIGHT_STORE", "mysql://x/y")], Some(&shop.path("option")), "option");
    let nowhere = with(&[], &[&add[..], &["--json"]].concat());
    let answer: Value = serde_json::from_slice(&nowhere.stdout).unwrap();
    assert_eq!((nowhere.status.code(), &answer["error"]["code"]), (Some(2), &json!("no-data-directory")));
}

#[test]
fn an_import_that_is_killed_is_completed_by_the_next() {
    let shop = Shop::new(1200);
    let (place, folder) = (shop.path("data/store.sqlite"), shop.path("measured"));
    let words = ["store", "import", &folder, "--store", &place];
    let mut child = Command::new(env!("CARGO_BIN_EXE_flankwright"))
        .args(words)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    // The first set is in; the second is on its way.
    let begun = Instant::now();
    let stored = || {
        let run = run(&["store", "check", "--json", "--store", &place]);
        if run.exit == Some(0) { run.json()["parts"].as_u64().unwrap() } else { 0 }
    };
    while stored() == 0 {
        assert!(begun.elapsed() < Duration::from_secs(120), "nothing was imported");
        assert!(child.try_wait().unwrap().is_none(), "it ended before it could be killed");
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let health = shop.json(&["check"], 0);
    let before = health["parts"].as_u64().unwrap();
    assert!(before > 0 && before < 1200 && before.is_multiple_of(250), "{health}");
    let report = shop.json(&["import", &folder], 0);
    assert_eq!(report["known"].as_array().unwrap().len() as u64, before);
    assert_eq!(report["imported"].as_array().unwrap().len() as u64, 1200 - before);
    assert_eq!(shop.json(&["check"], 0)["parts"], 1200);
}

#[test]
fn parts_are_taken_out_by_their_digests() {
    let shop = Shop::new(3);
    shop.json(&["import", &shop.path("measured")], 0);
    let parts = shop.json(&["parts"], 0);
    let digest = |k: usize| parts[k]["digest"].as_str().unwrap().to_owned();
    let unknown = shop.json(&["remove", &digest(0), "00000000"], 2);
    assert_eq!(unknown["error"]["field"], "DIGEST");
    assert_eq!(shop.json(&["remove", &digest(0)[..4]], 2)["error"]["code"], "unknown-value");
    // Nothing was taken out by what was refused.
    assert_eq!(shop.json(&["parts"], 0).as_array().unwrap().len(), 3);
    assert_eq!(shop.json(&["remove", &digest(1)[..12]], 0)[0]["part"], "1");
    let again = shop.json(&["import", &shop.path("measured"), "--class", "6"], 0);
    assert_eq!(
        (again["imported"].as_array().unwrap().len(), again["known"].as_array().unwrap().len()),
        (1, 2)
    );
}

#[test]
fn a_folder_and_the_store_say_the_same_of_a_series() {
    let shop = Shop::new(12);
    fs::write(shop.0.path().join("measured/broken.mka"), "HEADER KS.MK.FILE\n21 :mn : 1\n").unwrap();
    let [by_files, by_store] = ["files", "stored"].map(|name| shop.path(name));
    let files = run(&["inspect", &shop.path("measured"), "--class", "6", "--json", "-o", &by_files]);
    // One file was refused: it is told, and the others go on.
    assert_eq!(files.exit, Some(3), "{}", files.stderr);
    let files = files.json();
    assert_eq!(files["refused"].as_array().unwrap().len(), 1);
    assert_eq!(files["refused"][0]["file"], "broken.mka");
    for file in ["series.json", "series.csv", "series.html", "sheets/part-0007.html"] {
        assert!(Path::new(&by_files).join(file).is_file(), "{file}");
    }
    shop.json(&["import", &shop.path("measured"), "--class", "6"], 3);
    let stored = shop.store(&["series", "--series", "Z-17", "-o", &by_store, "--json"]);
    assert!(matches!(stored.exit, Some(0 | 3)), "{}", stored.stderr);
    let stored = stored.json();
    assert_eq!(files["groups"][0]["characteristics"], stored["groups"][0]["characteristics"]);
    assert_eq!(stored["groups"][0]["parts"].as_array().unwrap().len(), 12);
    assert!(Path::new(&by_store).join("series.html").is_file());

    let none = shop.store(&["series", "--series", "none", "--json"]);
    assert_eq!(none.exit, Some(2), "{none:?}");
    let empty = tempfile::tempdir().unwrap();
    let refused = run(&["inspect", empty.path().to_str().unwrap(), "--json"]);
    assert_eq!((refused.exit, &refused.json()["error"]["code"]), (Some(2), &json!("no-measurements")));
    let refused = run(&["inspect", &shop.path("measured"), "--class", "12"]);
    assert!(refused.exit == Some(2) && refused.message().contains("1..=11"), "{refused:?}");
}

#[test]
fn a_file_that_was_cut_off_is_no_store_and_stays_as_it_is() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("store.sqlite");
    fs::write(&path, "").unwrap();
    let place = path.to_str().unwrap();
    for words in [&["check"][..], &["parts"], &["plans", "list"]] {
        let refused = run(&[&["store"], words, &["--store", place, "--json"]].concat());
        assert_eq!(refused.exit, Some(2), "{refused:?}");
        assert_eq!(refused.json()["error"]["code"], "not-a-store", "{words:?}");
    }
    let catalogue = repository().join("examples/catalogue/bodies.toml");
    let refused =
        run(&["store", "catalogue", "add", catalogue.to_str().unwrap(), "--store", place, "--json"]);
    assert_eq!(refused.json()["error"]["code"], "not-a-store");
    assert_eq!(fs::metadata(&path).unwrap().len(), 0);
    // A list makes no store either.
    let none = directory.path().join("none/store.sqlite");
    let refused = run(&["store", "parts", "--store", none.to_str().unwrap(), "--json"]);
    assert_eq!(refused.json()["error"]["code"], "missing-store");
    assert!(!none.parent().unwrap().exists());
}
