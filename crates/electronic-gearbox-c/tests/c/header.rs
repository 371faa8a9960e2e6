//! The header beside the library: every function of one stands in the other, statuses and choices have the numbers and names of both.

use crate::archive::{archive, functions, made, place};
use electronic_gearbox_c as library;
use std::collections::BTreeSet;
use std::ffi::CStr;
use std::process::Command;

fn header() -> String {
    std::fs::read_to_string(place("include/electronic_gearbox.h")).unwrap()
}

/// Names `eg_...` before an opening bracket.
fn declared(header: &str) -> BTreeSet<String> {
    let word = |text: &str| {
        let start = text.rfind(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).map_or(0, |at| at + 1);
        text[start..].to_owned()
    };
    header
        .lines()
        .filter(|line| line.starts_with("eg_status ") || line.starts_with("const char *"))
        .filter_map(|line| Some(word(line.split_once('(')?.0)))
        .filter(|name| name.starts_with("eg_"))
        .collect()
}

#[test]
fn header_and_library_have_the_same_functions() {
    let declared = declared(&header());
    assert!(declared.len() > 25, "{declared:?}");
    assert_eq!(declared, functions(archive()));
}

/// For a Cortex-M4 the library has the same functions, and its storage fits into that of the header there too, which its build checks.
#[test]
fn the_library_is_made_for_a_microcontroller() {
    const TARGET: &str = "thumbv7em-none-eabihf";
    let root = Command::new("rustc").args(["--print", "sysroot"]).output().expect("rustc runs");
    let root = std::path::PathBuf::from(String::from_utf8_lossy(&root.stdout).trim());
    if !root.join("lib/rustlib").join(TARGET).is_dir() {
        use std::io::Write as _;
        // Not by `eprintln!`, which is only shown when a test fails: what was not tested has to be seen.
        drop(writeln!(
            std::io::stderr(),
            "embedded target absent: no core library of {TARGET}, the C library was not made; scripts/embedded-target gets it"
        ));
        return;
    }
    assert_eq!(declared(&header()), functions(&made(Some(TARGET))));
}

#[test]
fn statuses_have_their_names() {
    let header = header();
    let mut seen = 0;
    for line in header.lines().skip_while(|line| !line.contains("EG_OK = 0")) {
        if line.starts_with("};") {
            break;
        }
        let (name, number) = line.trim().split_once(" = ").expect("a constant");
        let number: i32 =
            number.chars().take_while(char::is_ascii_digit).collect::<String>().parse().unwrap();
        let text = |pointer| unsafe_text(pointer);
        let spelled = name.trim_start_matches("EG_").to_ascii_lowercase().replace('_', "-");
        let wanted = if number == 3 { "bad-reference-train".to_owned() } else { spelled };
        assert_eq!(text(library::eg_status_name(number)), wanted);
        assert_eq!(text(library::eg_status_way_out(number)).is_empty(), number == 0);
        seen += 1;
    }
    assert_eq!(seen, 15);
}

#[expect(unsafe_code, reason = "a text of C")]
fn unsafe_text(pointer: *const std::ffi::c_char) -> String {
    // SAFETY: the texts of statuses are constants that end with 0.
    unsafe { CStr::from_ptr(pointer) }.to_str().unwrap().to_owned()
}

/// The words that the header gives an object are those that the library checks itself to fit into.
#[test]
fn objects_have_the_storage_of_the_header() {
    use electronic_gearbox::chain::AdditionalRotation;
    use electronic_gearbox::coupling::{
        Bresenham, CubicTable, Engagement, PolynomialCoupling, WrappingCounter,
    };
    use electronic_gearbox::pulse::ClockedInterpolator;
    use library::Stored;

    let header = header();
    for (object, words) in [
        ("eg_interpolator", ClockedInterpolator::WORDS),
        ("eg_rotation", AdditionalRotation::WORDS),
        ("eg_gearbox", library::Axes::WORDS),
        ("eg_counter", WrappingCounter::WORDS),
        ("eg_line", Bresenham::WORDS),
        ("eg_polynomial", PolynomialCoupling::WORDS),
        ("eg_table", CubicTable::<'static>::WORDS),
        ("eg_engagement", Engagement::WORDS),
    ] {
        let declared = format!("    uint64_t storage[{words}];\n}} {object};");
        assert!(header.contains(&declared), "{object} has {words} words in the library");
    }
}

#[test]
fn the_header_is_one_of_cpp_too() {
    let directory = tempfile::tempdir().unwrap();
    let source = directory.path().join("header.cpp");
    std::fs::write(&source, "#include \"electronic_gearbox.h\"\neg_gearbox gearbox;\n").unwrap();
    let made = Command::new("c++")
        .args(["-std=c++11", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only", "-I"])
        .arg(place("include"))
        .arg(&source)
        .output();
    match made {
        Ok(made) => assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr)),
        Err(error) => {
            use std::io::Write as _;
            // Not by `eprintln!`, which is only shown when a test fails: what was not tested has to be seen.
            drop(writeln!(
                std::io::stderr(),
                "C++ compiler absent: the header in C++ skipped; no c++ here: {error}"
            ));
        }
    }
}
