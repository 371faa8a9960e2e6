//! NC programs of the three controls, cutter locations, and the netlist beside a LinuxCNC program.

use flankwright::nc::{
    AxisMotion, AxisWord, Block, ClProgram, Dialect, Header, NcError, Program, ReadError, ReadProgram,
    WriteOptions, detect_dialect, read, read_cl, read_with_netlist, write_checked, write_cl_checked,
};

use crate::complaints::told_in_full;
use crate::two_files;

/// Every dialect takes the text or says why not; what is taken can be written and read again.
pub fn program(data: &[u8]) {
    let (text, netlist) = two_files(data);
    let _ = detect_dialect(text);
    for dialect in Dialect::ALL {
        match read(text, dialect, &axes(dialect)) {
            Ok(found) => written_again(found, dialect),
            Err(error) => refused(&error, text),
        }
    }
    if let Some(netlist) = netlist.and_then(|netlist| std::str::from_utf8(netlist).ok()) {
        match read_with_netlist(text, netlist, &axes(Dialect::LinuxCnc)) {
            Ok(found) => written_again(found, Dialect::LinuxCnc),
            Err(error) => told_in_full(error.code(), &error.to_string(), error.way_out()),
        }
    }
    match read_cl(text) {
        Ok(ClProgram { cutter, blocks, .. }) => {
            if let Ok(program) = Program::new(header(Dialect::Siemens), blocks) {
                equal(write_cl_checked(&program, cutter.as_ref()).map(|_| ()), text);
            }
        }
        Err(error) => refused(&error, text),
    }
}

fn written_again(found: ReadProgram, dialect: Dialect) {
    let shown = found.blocks.iter().filter(|block| !matches!(block, Block::Comment(_)));
    let shown = format!("{:?}", shown.collect::<Vec<_>>());
    // Bodies behind a coupling that a program need not tell.
    let shown = shown.replace("normal_module: NaN, helix_angle: NaN", "");
    assert!(!shown.contains("NaN") && !shown.contains("inf"), "{shown}");
    if let Ok(program) = Program::new(header(dialect), found.blocks) {
        equal(write_checked(&program, dialect, &WriteOptions::default()).map(|_| ()), shown.as_bytes());
    }
}

/// A program may have no words in a dialect; what is written must be read back as it was.
fn equal(written: Result<(), NcError>, of: &[u8]) {
    if let Err(error) = written {
        told_in_full(error.code(), &error.to_string(), error.way_out());
        let unequal = matches!(error, NcError::NotReadBack(_) | NcError::ReadBackMismatch { .. });
        assert!(!unequal, "{error}: {}", of.escape_ascii());
    }
}

fn refused(error: &ReadError, text: &[u8]) {
    told_in_full(error.code(), &error.to_string(), error.way_out());
    let lines = text.split(|byte| *byte == b'\n').count();
    assert!((1..=lines + 1).contains(&error.line), "{error}");
    assert!((1..=514).contains(&error.column) && error.word.len() < 300, "{error}");
}

/// Five axes and two spindles under the names of every dialect.
fn axes(dialect: Dialect) -> Vec<AxisWord> {
    use AxisMotion::{Linear, Rotary};
    let siemens = dialect == Dialect::Siemens;
    let names = [
        ("X1", Linear, 'X'),
        ("V1", Linear, 'Y'),
        ("Z1", Linear, 'Z'),
        ("A1", Rotary, 'A'),
        ("C2", Rotary, 'C'),
    ];
    let named = names.into_iter().map(|(name, motion, letter)| match siemens && letter != 'A' {
        true => AxisWord::named(name, motion),
        false => AxisWord::letter(name, motion, letter),
    });
    let worm = if siemens { AxisWord::named("B1", Rotary) } else { AxisWord::spindle("B1", 0) };
    named.chain([worm, AxisWord::spindle("B3", 1)]).collect()
}

fn header(dialect: Dialect) -> Header {
    Header { name: "FUZZ_1".into(), axes: axes(dialect), chord_tolerance: 5e-5 }
}
