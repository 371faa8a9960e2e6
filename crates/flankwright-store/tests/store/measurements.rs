//! Files of measuring machines into the store: each content once, what is refused is told, the rest goes on.

use std::fs;
use std::path::{Path, PathBuf};

use flankwright::numerics::Silent;
use flankwright_store::blocking::Store;
use flankwright_store::{CharacteristicFilter, ImportSettings, MeasurementReport, PartFilter};

use crate::made_file::mka;
use crate::place::{Place, on_both};

on_both! {
    a_folder_is_imported_once
    a_refused_file_does_not_keep_the_others_out
    a_class_gives_the_limits
}

fn import(store: &Store, paths: &[&Path], settings: &ImportSettings) -> MeasurementReport {
    let paths: Vec<PathBuf> = paths.iter().map(|path| path.to_path_buf()).collect();
    store.import_measurements(&paths, settings, &Silent).unwrap()
}

/// A folder with the measurements of some parts.
fn folder(parts: u32) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for number in 0..parts {
        fs::write(folder.path().join(format!("part-{number:03}.mka")), mka(number)).unwrap();
    }
    folder
}

fn a_folder_is_imported_once(place: &Place) {
    let (store, folder) = (place.open(), folder(12));
    // The same content under another name.
    fs::write(folder.path().join("copy.MKA"), mka(3)).unwrap();
    let report = import(&store, &[folder.path()], &ImportSettings::default());
    assert_eq!((report.imported.len(), report.known.len(), report.refused.len()), (12, 1, 0), "{report:?}");
    let first = &report.imported[1];
    assert_eq!(
        (first.series.as_str(), first.part.as_str(), first.source.as_str()),
        ("Z-17", "0", "part-000.mka")
    );
    assert_eq!(first.date.as_deref(), Some("2026-02-01T08:00:31"));
    let again =
        import(&store, &[folder.path(), &folder.path().join("part-001.mka")], &ImportSettings::default());
    assert_eq!((again.imported.len(), again.known.len(), again.refused.len()), (0, 13, 0));
    let parts = store.parts(&PartFilter { series: Some("Z-17".into()), ..PartFilter::default() }).unwrap();
    assert_eq!(
        parts.iter().map(|part| part.part.parse().unwrap()).collect::<Vec<u32>>(),
        (0..12).collect::<Vec<_>>()
    );
    assert_eq!(store.health().unwrap().faults, [""; 0]);
}

fn a_refused_file_does_not_keep_the_others_out(place: &Place) {
    let (store, folder) = (place.open(), folder(3));
    let path = |name: &str| folder.path().join(name);
    fs::write(path("part-001.mka"), "HEADER KS.MK.FILE\n21 :mn : 1\n").unwrap();
    fs::write(path("table.csv"), "kind,tooth\n").unwrap();
    fs::write(path("notes.txt"), "no measurement").unwrap();
    fs::create_dir(path("empty")).unwrap();
    let (none, table, empty) = (path("none.mka"), path("table.csv"), path("empty"));
    let report = import(&store, &[folder.path(), &none, &table, &empty], &ImportSettings::default());
    assert_eq!((report.imported.len(), report.known.len()), (2, 0), "{report:?}");
    let told: Vec<(&str, &str)> = report
        .refused
        .iter()
        .map(|refused| {
            (Path::new(&refused.file).file_name().unwrap().to_str().unwrap(), refused.finding.code)
        })
        .collect();
    assert_eq!(told.len(), 4);
    for one in
        [("empty", "no-measurement"), ("part-001.mka", "missing-code"), ("none.mka", "unreadable-file")]
    {
        assert!(told.contains(&one), "{told:?}");
    }
    assert!(told.iter().any(|(file, _)| *file == "table.csv"));
    assert!(report.refused.iter().all(|refused| refused.finding.way_out.is_some()));
    // The file is corrected, and the same is done again.
    fs::write(path("part-001.mka"), mka(1)).unwrap();
    let again = import(&store, &[folder.path()], &ImportSettings::default());
    assert_eq!((again.imported.len(), again.known.len(), again.refused.len()), (1, 2, 0));
}

fn a_class_gives_the_limits(place: &Place) {
    let (store, folder) = (place.open(), folder(2));
    let settings =
        ImportSettings { series: Some("trial".into()), class: Some(6), ..ImportSettings::default() };
    let report = import(&store, &[folder.path()], &settings);
    assert_eq!(report.imported[0].series, "trial");
    let of = |name: &str, statistic: &str| {
        let filter = CharacteristicFilter {
            name: Some(name.into()),
            statistic: Some(statistic.into()),
            ..CharacteristicFilter::default()
        };
        store.characteristics(&filter).unwrap()
    };
    // ISO 1328-1:2013, class 5: fHa = 0.4 m + 0.001 d + 4 with m 2, d 46; times sqrt 2, rounded to half um below 10.
    let slopes = of("fHa", "mean");
    assert_eq!(slopes.len(), 4);
    assert!(
        slopes.iter().all(|one| (one.lower_limit, one.upper_limit) == (Some(-7.0), Some(7.0))),
        "{slopes:?}"
    );
    let forms = of("ffa", "max");
    assert!(
        forms.len() == 4 && forms.iter().all(|one| one.lower_limit.is_none() && one.upper_limit.is_some())
    );
    for (name, statistic) in [("fHa", "range"), ("fHa", "single"), ("ffa", "mean"), ("Ca", "mean")] {
        assert!(of(name, statistic).iter().all(|one| one.upper_limit.is_none()), "{name} {statistic}");
    }
    assert_eq!(of("fHb", "single").len(), 8);
}

#[test]
fn real_measurements_are_imported_where_they_lie_beside_the_repository() {
    let real = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/measurements");
    if !real.is_dir() {
        eprintln!("passed over: {} is not there", real.display());
        return;
    }
    let place = Place::sqlite();
    let store = place.open();
    let report = import(&store, &[&real], &ImportSettings::default());
    assert_eq!((report.imported.len(), report.refused.len()), (2, 0), "{report:?}");
    assert_eq!(report.imported[0].date.as_deref(), Some("2025-10-13T08:21:31"));
    // Curves and values are one part, whichever is named.
    let values = import(&store, &[&real.join("wheel_97340.mew")], &ImportSettings::default());
    assert_eq!((values.imported.len(), values.known.len()), (0, 1));
}
