//! The stock of measured blanks as a user asks for it: of a file, and of a part of the store.

use std::fs;
use std::path::Path;

use serde_json::Value;
use tempfile::TempDir;

use crate::command::{Run, repository, run};
use crate::store::made_file;

/// The gear of the made files, ground by a job that knows its mean stock.
const JOB: &str = r#"
[job]
name = "ground"
process = "generating-grinding"
[gear]
teeth = 23
normal_module = 2.0
normal_pressure_angle_deg = 20.0
helix_angle_deg = 0.0
profile_shift = 0.25
face_width = 20.0
tip_diameter = 49.6
root_diameter = 41.4
form_diameter = 44.2
[target]
tolerance_um = 2.0
modifications = []
[stock]
allowance_um = 100.0
[worm]
threads = 1
tip_diameter = 240.0
[dresser]
tip_diameter = 140.0
[grinding]
method = "diagonal"
"#;

/// A folder with measured blanks, the job, and a store of the blanks.
struct Shop(TempDir);

impl Shop {
    fn new() -> Self {
        let shop = Self(tempfile::tempdir().unwrap());
        fs::create_dir(shop.0.path().join("measured")).unwrap();
        for number in 1..=2 {
            let file = shop.path(&format!("measured/blank-{number}.mka"));
            fs::write(file, made_file::mka(number)).unwrap();
        }
        fs::write(shop.path("ground.toml"), JOB).unwrap();
        let imported =
            run(&["store", "import", &shop.path("measured"), "--store", &shop.path("store.sqlite")]);
        assert_eq!(imported.exit, Some(0), "{imported:?}");
        shop
    }

    fn path(&self, name: &str) -> String {
        self.0.path().join(name).to_str().unwrap().to_owned()
    }

    fn blank(&self, words: &[&str]) -> Run {
        run(&[&["inspect", "--blank", "--job", &self.path("ground.toml")], words].concat())
    }

    fn of_part(&self, part: &str, words: &[&str]) -> Run {
        self.blank(&[&["--part", part, "--store", &self.path("store.sqlite")], words].concat())
    }
}

fn table(folder: &str) -> String {
    fs::read_to_string(Path::new(folder).join("stock.csv")).unwrap()
}

#[test]
fn a_part_of_the_store_has_the_stock_of_its_file() {
    let shop = Shop::new();
    let (of_file, of_part) = (shop.path("of-file"), shop.path("of-part"));
    let file = shop.blank(&[&shop.path("measured/blank-2.mka"), "-o", &of_file, "--json"]);
    let part = shop.of_part("2", &["-o", &of_part, "--json"]);
    assert_eq!((file.exit, part.exit), (Some(0), Some(0)), "{file:?}\n{part:?}");
    assert_eq!(table(&of_file), table(&of_part));
    assert_eq!(file.json(), part.json());
    assert_eq!(part.json()["files"][0], "blank-2.mka");
    let document = fs::read_to_string(Path::new(&of_part).join("blank.json")).unwrap();
    assert_eq!(serde_json::from_str::<Value>(&document).unwrap(), part.json());
    // Another part has another stock; its digest names it as well.
    let parts = run(&["store", "parts", "--store", &shop.path("store.sqlite"), "--json"]).json();
    let one = parts.as_array().unwrap().iter().find(|part| part["part"] == "1").unwrap();
    assert_eq!(one["has_files"], true);
    let other = shop.path("other");
    let run = shop.of_part(&one["digest"].as_str().unwrap()[..12], &["-o", &other]);
    assert_eq!(run.exit, Some(0), "{run:?}");
    assert!(run.stdout.contains("[stock]\nmap = ") && run.stdout.contains("level from stock.allowance_um"));
    assert_ne!(table(&other), table(&of_part));
    // What is stated now holds in place of what was stated then.
    let turned = shop.path("turned");
    let run = shop.of_part("2", &["-o", &turned, "--from-other-end"]);
    assert_eq!(run.exit, Some(0), "{run:?}");
    assert_ne!(table(&turned), table(&of_part));
    // The job takes the table.
    let text = JOB.replace("allowance_um = 100.0", "allowance_um = 100.0\nmap = \"of-part/stock.csv\"");
    fs::write(shop.path("with-map.toml"), text).unwrap();
    let checked = crate::command::run(&["check", &shop.path("with-map.toml")]);
    assert_eq!(checked.exit, Some(0), "{checked:?}");
}

#[test]
fn what_the_store_does_not_have_is_named() {
    let shop = Shop::new();
    let out = shop.path("out");
    let refused = |run: Run, code: &str, field: &str| {
        let told = run.json()["error"].clone();
        assert_eq!(
            (run.exit, &told["code"], &told["field"]),
            (Some(2), &code.into(), &field.into()),
            "{told}"
        );
        assert!(told["way_out"].is_string(), "{told}");
        told
    };
    let told = refused(shop.of_part("17", &["-o", &out, "--json"]), "unknown-value", "part");
    assert_eq!((&told["value"], told["allowed"].is_string()), (&"17".into(), true));
    let none = shop.path("none.sqlite");
    refused(shop.blank(&["--part", "1", "--store", &none, "--json"]), "missing-store", "store");
    assert!(!Path::new(&none).exists() && !Path::new(&out).exists());
    // The gear of the job is another one.
    let text = JOB.replace("face_width = 20.0", "face_width = 21.0");
    fs::write(shop.path("ground.toml"), text).unwrap();
    refused(shop.of_part("1", &["-o", &out, "--json"]), "other-gear", "gear.face_width");
    assert!(!Path::new(&out).exists());
    // A part is for a blank, and in place of a file.
    let job = shop.path("ground.toml");
    for words in [
        &["inspect", "--part", "1", "--job", &job][..],
        &["inspect", "--blank", "--job", &job],
        &["inspect", "--blank", "--job", &job, "--part", "1", &shop.path("measured/blank-1.mka")],
        &["inspect", "--store", "x.sqlite", "--job", &job],
    ] {
        assert_eq!(run(words).exit, Some(2), "{words:?}");
    }
    let milling = repository().join("examples/milling/spur-module-8.toml").display().to_string();
    let store = shop.path("store.sqlite");
    let words = ["inspect", "--blank", "--part", "1", "--job", &milling, "--store", &store, "--json"];
    refused(run(&words), "process-not-available", "job.process");
}
