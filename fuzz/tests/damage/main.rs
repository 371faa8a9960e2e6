//! Every property of the readers on seeds, examples and damaged copies of both. What libFuzzer searches for longer and guided by coverage
//! (`scripts/fuzz`) is tried here without a second build of the library.

mod mutation;
mod seeds;

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::path::Path;

use mutation::Mutation;

/// Tries `property` on each seed of `target`, then on `copies` damaged ones. An input that breaks the property is written to a file.
fn tried(target: &str, copies: usize, property: fn(&[u8])) {
    let seeds = seeds::of_target(target);
    for seed in &seeds {
        holds(target, seed, property);
    }
    let mut mutation = Mutation::of_target(target, &seeds);
    for _ in 0..copies {
        holds(target, &mutation.damaged(), property);
    }
}

fn holds(target: &str, input: &[u8], property: fn(&[u8])) {
    if let Err(panic) = catch_unwind(AssertUnwindSafe(|| property(input))) {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{target}-finding"));
        std::fs::write(&path, input).expect("the finding as a file");
        eprintln!("the input that breaks the property: {}", path.display());
        resume_unwind(panic);
    }
}

/// One test for each reader, with the number of damaged copies; slow readers get fewer.
macro_rules! readers {
    ($($target:ident: $copies:literal),* $(,)?) => {
        $(#[test]
        fn $target() {
            tried(stringify!($target), $copies, flankwright_fuzz::$target);
        })*

        #[test]
        fn every_target_of_the_fuzzer_is_tried_here() {
            let tried = [$(concat!(stringify!($target), ".rs")),*].map(String::from);
            assert_eq!(seeds::names_in(&seeds::package().join("fuzz_targets")), tried);
        }
    };
}

readers! {
    catalogue: 2000,
    history: 2000,
    job: 1500,
    klingelnberg: 600,
    machine: 2000,
    measured_table: 4000,
    modification: 4000,
    program: 3000,
    rexs_json: 2000,
    rexs_packed: 4000,
    rexs_xml: 2000,
    table: 3000,
}
