//! Block `machine`: positions of the machine's axes for one pose of the dresser, all branches at several swivels.

use super::super::expected::Expected;
use super::super::ledger::Ledger;
use super::super::reference::Tolerances;
use foundation::kinematics::{
    DressingAxis, DressingBranch, DressingMachine, DressingPosition, DressingRule, MachineError,
};
use serde_json::Value;

/// Block `machine`.
pub(super) fn machine(item: &mut Expected<'_>, ledger: &mut Ledger) -> Result<(), MachineError> {
    let tolerances = Tolerances::table(item.take("tolerance").unwrap_or(&Value::Null));
    let Some(mut relative) = item.object("relative", ledger) else {
        item.refused(&"the pose is missing", ledger);
        return Ok(());
    };
    let keys = ["phi_S_deg", "v_zS_mm", "gamma_deg", "d_mm", "v_yA_mm"];
    let numbers = keys.map(|key| relative.given(key, ledger));
    relative.finish(ledger);
    let [Some(phi), Some(v), Some(gamma), Some(d), Some(v_y)] = numbers else { return Ok(()) };
    let position = DressingPosition {
        worm_angle: phi.to_radians(),
        worm_shift: v,
        crossing_angle: gamma.to_radians(),
        centre_distance: d,
        offset: v_y,
    };
    let mut listed: Vec<(f64, usize)> = Vec::new();
    for mut row in item.objects("solutions_deg_mm", ledger) {
        let (Some(swivel), Some(sign)) = (row.given("C5", ledger), row.given("branch", ledger)) else {
            row.finish(ledger);
            continue;
        };
        let found =
            DressingMachine::UNLIMITED.axes(&position, DressingRule::Swivel(swivel.to_radians()), None)?;
        match listed.iter_mut().find(|(c, _)| *c == swivel) {
            Some((_, count)) => *count += 1,
            None => listed.push((swivel, 1)),
        }
        let branch = DressingBranch::BOTH.into_iter().find(|branch| branch.sign() == sign);
        match found.iter().find(|solution| Some(solution.branch) == branch) {
            Some(solution) => {
                for axis in DressingAxis::ALL {
                    let actual = axis.shown(solution.axes.get(axis));
                    if axis.is_rotary() {
                        row.periodic(axis.name(), actual, 360.0, tolerances.get("deg"), ledger);
                    } else {
                        row.number(axis.name(), actual, tolerances.get("mm"), ledger);
                    }
                }
            }
            None => row.refused(&format!("there is no branch {sign}"), ledger),
        }
        row.finish(ledger);
    }
    // The file lists all solutions at each of its swivels.
    for (swivel, count) in listed {
        let rule = DressingRule::Swivel(swivel.to_radians());
        let all = DressingMachine::UNLIMITED.axes(&position, rule, None)?.len();
        let quantity = format!("machine: solutions at C5 = {swivel} deg");
        ledger.equal(item.case(), &quantity, count.into(), all.into());
    }
    Ok(())
}
