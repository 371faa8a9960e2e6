//! `encoder_ratio` of LinuxCNC under `scripts/hal-peer`: one thread takes a line of the stream, has every channel count and
//! divide, and keeps what they say. All is loaded before it starts, so that nothing depends on the time it takes.

use super::pair::Pair;
use super::stream::{self, Counts};
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;
use std::process::Command;

/// Greatest number of channels of the component.
pub const CHANNELS: usize = 8;

/// Errors in millionths of a revolution of the slave, all that is printed of them: for every line, for every pair.
pub type Samples = Vec<Vec<i64>>;

/// What the peer says to a stream; none, and that said, if it cannot run here.
pub fn errors(pairs: &[Pair], motions: &[Counts], test: &str) -> Option<Samples> {
    assert!(pairs.len() <= CHANNELS);
    let directory = tempfile::tempdir().expect("a directory");
    let place = |name: &str| directory.path().join(name);
    std::fs::write(place("stream.txt"), stream::text(pairs, motions)).expect("a file");
    std::fs::write(place("peer.hal"), netlist(pairs, motions.len())).expect("a file");

    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scripts/hal-peer");
    let output = Command::new(script)
        .arg(place("peer.hal"))
        .arg(directory.path())
        .output()
        .expect("the script starts");
    let message = String::from_utf8_lossy(&output.stderr);
    let missing = match output.status.code() {
        Some(76) => "LinuxCNC client absent",
        Some(77) => "LinuxCNC HAL not runnable",
        _ => {
            assert!(output.status.success(), "{}: {message}", output.status);
            let text = std::fs::read_to_string(place("samples.txt")).expect("samples");
            return Some(text.lines().map(sample).collect());
        }
    };
    // Not by `eprintln!`, which is only shown when a test fails: what was not tested has to be seen.
    drop(writeln!(
        std::io::stderr(),
        "{missing}: {test} skipped; {}",
        message.trim_end().replace('\n', "; ")
    ));
    None
}

/// The HAL file. Buffers hold more than the stream: a full one would lose lines.
fn netlist(pairs: &[Pair], lines: usize) -> String {
    let depth = lines + 100;
    let signals = "b".repeat(2 * pairs.len() + 2);
    let floats = "f".repeat(pairs.len());
    let mut text = format!(
        "loadrt threads name1=t period1=100000\n\
         loadrt streamer depth={depth} cfg={signals}\n\
         loadrt sampler depth={depth} cfg={floats}\n\
         loadrt encoder_ratio num_chan={}\n",
        pairs.len()
    );
    for function in ["streamer.0", "encoder-ratio.sample", "encoder-ratio.update", "sampler.0"] {
        text += &format!("addf {function} t\n");
    }
    for (signal, name) in ["A", "B"].into_iter().enumerate() {
        write!(text, "net master-{name} streamer.0.pin.{signal} =>").expect("text");
        for channel in 0..pairs.len() {
            write!(text, " encoder-ratio.{channel}.master-{name}").expect("text");
        }
        text.push('\n');
    }
    for (channel, pair) in pairs.iter().enumerate() {
        let unit = format!("encoder-ratio.{channel}");
        for (signal, name) in ["A", "B"].into_iter().enumerate() {
            let pin = 2 * channel + 2 + signal;
            text += &format!("net slave-{channel}-{name} streamer.0.pin.{pin} => {unit}.slave-{name}\n");
        }
        text += &format!("net error-{channel} {unit}.error => sampler.0.pin.{channel}\n");
        text += &format!(
            "setp {unit}.master-ppr {}\nsetp {unit}.slave-ppr {}\n",
            pair.master_counts, pair.slave_counts
        );
        text += &format!(
            "setp {unit}.master-teeth {}\nsetp {unit}.slave-teeth {}\n",
            pair.master_teeth, pair.slave_teeth
        );
        text += &format!("setp {unit}.enable 1\n");
    }
    text + "loadusr -w halstreamer -c 0 stream.txt\n\
            start\n"
        + &format!("loadusr -w halsampler -c 0 -n {lines} samples.txt\n")
}

/// One line of the sampler. Where it lost some it says "overrun", which is no number.
fn sample(line: &str) -> Vec<i64> {
    line.split_whitespace().map(millionths).collect()
}

fn millionths(number: &str) -> i64 {
    let (sign, digits) = number.strip_prefix('-').map_or((1, number), |digits| (-1, digits));
    let (whole, decimals) = digits.split_once('.').unwrap_or_else(|| panic!("{number} is no sample"));
    assert_eq!(decimals.len(), 6, "{number}");
    let [whole, decimals] = [whole, decimals].map(|part| part.parse::<i64>().expect("digits"));
    sign * (whole * 1_000_000 + decimals)
}
