//! A gear for LinuxCNC as a HAL netlist beside the program (`docs/mathematics/programs.md#the-independent-reader`): leaders times ratios
//! plus an offset through `scale` and `sum2`, a switch that the program's M64 and M65 work, and a guard of the following error.
//! `encoder_ratio` is not used: its error sum is a 32-bit integer. The order of HAL is kept here; the program is made in `linuxcnc.rs`.

use super::lines::Lines;
use super::options::HalOptions;
use crate::{AxisMotion, Coupling, Gear, GearSynchronisation, NcError, Word};

/// The netlist of one gear.
///
/// # Errors
/// `UnsupportedCoupling` for a table, and without synchronous positions: a netlist knows no "as they stand now".
pub(super) fn netlist(
    out: &Lines<'_>,
    gear: &Gear,
    at: Option<&GearSynchronisation>,
    options: &HalOptions,
) -> Result<String, NcError> {
    let refused = |reason| NcError::UnsupportedCoupling { block: out.block, reason };
    let at = at.ok_or(refused("a HAL netlist couples at synchronous positions, which are not given"))?;
    let axes = out.program.axes();
    let follower = &axes[gear.follower];
    let name = format!("gear-{}", out.axes[gear.follower].address.to_ascii_lowercase());
    let follower_scale = out.axes[gear.follower].scale;
    let unit = if follower.motion == AxisMotion::Rotary { "deg" } else { "mm" };

    let mut gains = Vec::new();
    let mut offset = at.follower * follower_scale;
    for (leader, &stands) in gear.leaders.iter().zip(&at.leaders) {
        let Coupling::Ratio { num, den } = leader.coupling else {
            return Err(refused("a HAL netlist has no curve tables"));
        };
        // A spindle counts revolutions, an axis its unit of the text.
        let leader_scale = match axes[leader.axis].word {
            Word::Spindle(_) => 0.5 / std::f64::consts::PI,
            _ => out.axes[leader.axis].scale,
        };
        let gain = num / den * (follower_scale / leader_scale);
        offset -= gain * (stands * leader_scale);
        gains.push(gain);
    }
    let sums = gains.len().max(2) - 1;
    let scales = (0..gains.len()).map(|k| format!("{name}-scale-{k}")).collect::<Vec<_>>();
    let sums = (0..sums).map(|k| format!("{name}-sum-{k}")).collect::<Vec<_>>();
    let (error, guard) = (format!("{name}-error"), format!("{name}-guard"));
    let (switch, off, fit) = (format!("{name}-switch"), format!("{name}-off"), format!("{name}-fit"));

    let mut text = String::new();
    let mut line = |arguments: std::fmt::Arguments<'_>| {
        text.push_str(&arguments.to_string());
        text.push('\n');
    };
    line(format_args!("# Gear of the axis {} for the program {}.", follower.name, out.program.header().name));
    line(format_args!(
        "# M64 P{0} in the program couples, M65 P{0} opens; motmod needs num_dio above {0}.",
        gear.follower
    ));
    line(format_args!(
        "# To connect: {name}-leader-N for spindles (revolutions), {name}-actual (feedback, {unit}),"
    ));
    line(format_args!("# {name}-command (to the drive, {unit}), {name}-ok (false: stop the machine)."));
    line(format_args!("loadrt scale names={}", scales.join(",")));
    line(format_args!("loadrt sum2 names={},{error}", sums.join(",")));
    line(format_args!("loadrt mux2 names={switch}"));
    line(format_args!("loadrt wcomp names={guard}"));
    line(format_args!("loadrt not names={off}"));
    line(format_args!("loadrt or2 names={fit}"));
    for function in scales.iter().chain(&sums).chain([&switch, &error, &guard, &off, &fit]) {
        line(format_args!("addf {function} servo-thread"));
    }
    for ((scale, gain), (k, leader)) in scales.iter().zip(&gains).zip(gear.leaders.iter().enumerate()) {
        line(format_args!("setp {scale}.gain {gain:?}"));
        match axes[leader.axis].word {
            Word::Letter(letter) => {
                let letter = letter.to_ascii_lowercase();
                line(format_args!("net {name}-leader-{k} axis.{letter}.pos-cmd => {scale}.in"));
            }
            _ => line(format_args!("net {name}-leader-{k} => {scale}.in")),
        }
        // The first sum takes two terms, every further one the sum before and one term.
        let (sum, pin) = if k == 0 { (&sums[0], 0) } else { (&sums[k - 1], 1) };
        line(format_args!("net {name}-term-{k} {scale}.out => {sum}.in{pin}"));
    }
    for (k, pair) in sums.windows(2).enumerate() {
        line(format_args!("net {name}-partial-{k} {}.out => {}.in0", pair[0], pair[1]));
    }
    let last = &sums[sums.len() - 1];
    line(format_args!("setp {last}.offset {offset:?}"));
    line(format_args!("net {name}-wanted {last}.out => {switch}.in1"));
    if let Word::Letter(letter) = follower.word {
        let letter = letter.to_ascii_lowercase();
        line(format_args!("net {name}-own axis.{letter}.pos-cmd => {switch}.in0"));
    }
    line(format_args!("net {name}-on motion.digital-out-{:02} => {switch}.sel {off}.in", gear.follower));
    line(format_args!("net {name}-command {switch}.out => {error}.in0"));
    line(format_args!("net {name}-actual => {error}.in1"));
    line(format_args!("setp {error}.gain1 -1.0"));
    let limit = options.following_error * follower_scale;
    line(format_args!("net {name}-deviation {error}.out => {guard}.in"));
    line(format_args!("setp {guard}.min -{limit:?}"));
    line(format_args!("setp {guard}.max {limit:?}"));
    line(format_args!("net {name}-inside {guard}.out => {fit}.in0"));
    line(format_args!("net {name}-free {off}.out => {fit}.in1"));
    line(format_args!("net {name}-ok {fit}.out"));
    Ok(text)
}
