//! Everything that can be wrong with a job ends with exit status 2 and a message that names file, line, key, value,
//! what is allowed and a way out; never with a panic.

use std::time::{Duration, Instant};

use crate::command::{check, example, run, run_with};
use flankwright::exchange::job_template;
use serde_json::Value;

/// What a change to a job has to be answered with.
struct Case {
    from: &'static str,
    to: &'static str,
    code: &'static str,
    field: &'static str,
    /// Parts of value, allowed and way out.
    says: &'static [&'static str],
}

const fn case(
    from: &'static str,
    to: &'static str,
    code: &'static str,
    field: &'static str,
    says: &'static [&'static str],
) -> Case {
    Case { from, to, code, field, says }
}

const CASES: &[Case] = &[
    // keys
    case(
        "normal_module = 3.5",
        "normal_modul = 3.5",
        "unknown-key",
        "gear.normal_modul",
        &["did you mean `normal_module`", "teeth"],
    ),
    case(
        "amount_um = 20.0",
        "amount = 20.0",
        "unknown-key",
        "target.modifications[0].amount",
        &["did you mean `amount_um`"],
    ),
    case(
        "z_start = -20.0",
        "zstart = -20.0",
        "unknown-key",
        "gear.evaluation.zstart",
        &["did you mean `z_start`"],
    ),
    case("[grid]", "[grids]", "unknown-key", "grids", &["did you mean `grid`"]),
    case("teeth = 19\n", "", "missing-key", "gear.teeth", &["whole number", "number of teeth"]),
    case(
        "tip_diameter = 123.0\n",
        "",
        "missing-key",
        "dresser.tip_diameter",
        &["tip diameter of the dresser"],
    ),
    case("kind = \"helix_crowning\", ", "", "missing-key", "target.modifications[0].kind", &["twist"]),
    case("profile_shift = 0.0\n", "", "missing-key", "gear.profile_shift", &["exactly one of", "over_balls"]),
    case(
        "form_diameter = 76.2065\nevaluation = { start_diameter = 76.2065,",
        "evaluation = {",
        "missing-key",
        "gear.form_diameter",
        &["start_diameter"],
    ),
    case("tip_diameter = 200.0", "# none", "missing-key", "worm.tip_diameter", &["pitch_diameter"]),
    case(
        "modifications = [",
        "modification = [",
        "unknown-key",
        "target.modification",
        &["did you mean `modifications`"],
    ),
    // types
    case(
        "normal_module = 3.5",
        "normal_module = \"3.5\"",
        "wrong-type",
        "gear.normal_module",
        &["\"3.5\"", "number", "remove the quotes"],
    ),
    case("teeth = 19", "teeth = 19.5", "wrong-type", "gear.teeth", &["19.5", "whole number"]),
    case("threads = 3", "threads = [3]", "wrong-type", "worm.threads", &["a list", "whole number"]),
    case(
        "threads = 3",
        "threads = 2026-01-01",
        "wrong-type",
        "worm.threads",
        &["2026-01-01", "whole number"],
    ),
    case("evaluation = {", "evaluation = 3 # {", "wrong-type", "gear.evaluation", &["a table", "z_end"]),
    case("name = \"twist-free-crowning\"", "name = true", "wrong-type", "job.name", &["true", "a text"]),
    case("[job]", "job = 3\n[jobs]", "wrong-type", "job", &["a table"]),
    // words
    case(
        "[output]\n",
        "[output]\nlanguage = \"fr\"\n",
        "unknown-value",
        "output.language",
        &["\"fr\"", "\"en\", \"de\""],
    ),
    case(
        "hand = \"left\"",
        "hand = \"lefthand\"",
        "unknown-value",
        "worm.hand",
        &["\"left\", \"right\"", "did you mean \"left\""],
    ),
    case(
        "kind = \"helix_crowning\"",
        "kind = \"helix_crown\"",
        "unknown-value",
        "target.modifications[0].kind",
        &["did you mean \"helix_crowning\""],
    ),
    case(
        "diagonal_ratio = \"auto\"",
        "diagonal_ratio = \"best\"",
        "unknown-value",
        "grinding.diagonal_ratio",
        &["\"auto\", \"areas\"", "or a number"],
    ),
    case("\"siemens\"", "\"simens\"", "unknown-value", "output.programs[1]", &["did you mean \"siemens\""]),
    case(
        "\"generating-grinding\"",
        "\"generating\"",
        "unknown-value",
        "job.process",
        &["did you mean \"generating-grinding\""],
    ),
    // numbers
    case(
        "normal_module = 3.5",
        "normal_module = nan",
        "invalid-number",
        "gear.normal_module",
        &["NaN", "> 0"],
    ),
    case(
        "normal_module = 3.5",
        "normal_module = inf",
        "invalid-number",
        "gear.normal_module",
        &["inf", "> 0"],
    ),
    case(
        "normal_module = 3.5",
        "normal_module = 1e308",
        "invalid-number",
        "gear.normal_module",
        &["1e308", "<= 100"],
    ),
    case("normal_module = 3.5", "normal_module = 0", "invalid-number", "gear.normal_module", &["0", "> 0"]),
    case(
        "normal_module = 3.5",
        "normal_module = -3.5",
        "invalid-number",
        "gear.normal_module",
        &["-3.5", "> 0"],
    ),
    case("teeth = 19", "teeth = 0", "invalid-number", "gear.teeth", &["not 0", "internal gear"]),
    case(
        "teeth = 19",
        "teeth = 99999999999999999999999",
        "invalid-number",
        "gear.teeth",
        &["1e23", "<= 2000"],
    ),
    case("teeth = 19", "teeth = 2001", "invalid-number", "gear.teeth", &["<= 2000"]),
    case(
        "normal_pressure_angle_deg = 17.5",
        "normal_pressure_angle_deg = 4",
        "invalid-number",
        "gear.normal_pressure_angle_deg",
        &[">= 5 and <= 45"],
    ),
    case(
        "normal_pressure_angle_deg = 17.5",
        "normal_pressure_angle_deg = {left = 17.5, right = 91}",
        "invalid-number",
        "gear.normal_pressure_angle_deg.right",
        &["91", "<= 45"],
    ),
    case(
        "helix_angle_deg = -35.0",
        "helix_angle_deg = 90",
        "invalid-number",
        "gear.helix_angle_deg",
        &["< 90"],
    ),
    case("face_width = 40.0", "face_width = 0.0", "invalid-number", "gear.face_width", &["> 0"]),
    case(
        "amount_um = 20.0",
        "amount_um = -inf",
        "invalid-number",
        "target.modifications[0].amount_um",
        &["-inf"],
    ),
    case("tolerance_um = 1.0", "tolerance_um = 0.0", "invalid-number", "target.tolerance_um", &["> 0"]),
    case("threads = 3", "threads = 0", "invalid-number", "worm.threads", &[">= 1"]),
    case("width = 100.0", "width = -1", "invalid-number", "worm.width", &["> 0"]),
    case(
        "feed_per_revolution = 0.3",
        "feed_per_revolution = 0",
        "invalid-number",
        "grinding.feed_per_revolution",
        &["> 0"],
    ),
    case(
        "profile_points = 41",
        "profile_points = 2",
        "invalid-number",
        "grid.profile_points",
        &[">= 3 and <= 1001"],
    ),
    case("helix_points = 41", "helix_points = 1002", "invalid-number", "grid.helix_points", &["<= 1001"]),
    case("profile_points = 41", "profile_points = -1", "invalid-number", "grid.profile_points", &[">= 3"]),
    // lists
    case(
        "conditions = [\"three-point\", \"radius-map\"]",
        "conditions = []",
        "invalid-list",
        "dressing.conditions",
        &["1 to 12"],
    ),
    case("\"siemens\"", "\"linuxcnc\"", "invalid-list", "output.programs[1]", &["each entry once"]),
    // contradictions
    case(
        "conditions = [\"three-point\", \"radius-map\"]",
        "conditions = [\"four-point\", \"head\"]",
        "invalid-job",
        "dressing.conditions",
        &["4", "three-point"],
    ),
    case(
        "profile_shift = 0.0",
        "profile_shift = 0.0\nspan = {teeth = 3, length = 27.5}",
        "invalid-job",
        "gear.span",
        &["exactly one of"],
    ),
    case(
        "method = \"diagonal\"",
        "method = \"radial\"",
        "invalid-job",
        "grinding.diagonal_ratio",
        &["radial", "diagonal"],
    ),
    case(
        "method = \"diagonal\"\nflanks = \"both\"\ndiagonal_ratio = \"auto\"",
        "method = \"radial\"\ndiagonal_ratio = -1.9",
        "invalid-job",
        "grinding.diagonal_ratio",
        &["-1.9"],
    ),
    case(
        "tolerance_um = 1.0",
        "tolerance_um = 1.0\nfile = \"grid.csv\"",
        "invalid-job",
        "target.file",
        &["either"],
    ),
    case(
        "name = \"twist-free-crowning\"",
        "name = \"../elsewhere\"",
        "invalid-job",
        "job.name",
        &["plain name"],
    ),
    case(
        "name = \"twist-free-crowning\"",
        "name = \"\"",
        "unknown-value",
        "job.name",
        &["1 to 100 characters"],
    ),
    case(
        "name = \"twist-free-crowning\"",
        "name = \"twist-free-crowning\"\ndate = \"31.03.2026\"",
        "unknown-value",
        "job.date",
        &["31.03.2026", "YYYY-MM-DD", "year, month and day"],
    ),
    case(
        "name = \"twist-free-crowning\"",
        "name = \"twist-free-crowning\"\ndate = 2026-03-31T10:00:00",
        "unknown-value",
        "job.date",
        &["2026-03-31T10:00:00", "YYYY-MM-DD"],
    ),
    case(
        "name = \"twist-free-crowning\"",
        "name = \"twist-free-crowning\"\ndate = 20260331",
        "wrong-type",
        "job.date",
        &["20260331", "a date YYYY-MM-DD"],
    ),
    case(
        "name = \"twist-free-crowning\"",
        "name = \"twist-free-crowning\"\npart_number = 4711",
        "wrong-type",
        "job.part_number",
        &["4711", "a text"],
    ),
    case(
        "name = \"twist-free-crowning\"",
        "name = \"twist-free-crowning\"\ndrawing_number = \"\"",
        "unknown-value",
        "job.drawing_number",
        &["1 to 100 characters"],
    ),
    case(
        "name = \"twist-free-crowning\"",
        "name = \"twist-free-crowning\"\ncustommer = \"A\"",
        "unknown-key",
        "job.custommer",
        &["did you mean `customer`"],
    ),
    case(
        "[gear]\n",
        "machine_name = \"grinder\"\n[machine]\nfile = \"grinder.toml\"\n[gear]\n",
        "invalid-job",
        "job.machine_name",
        &["grinder", "no `machine.file`", "delete job.machine_name"],
    ),
    // targets
    case(
        "tolerance_um = 1.0",
        "tolerance_map = { w_mm = [1.0], z_mm = [], tolerance_um = [[1.0]] }",
        "invalid-list",
        "target.tolerance_map.z_mm",
        &["1 to 1000"],
    ),
    case(
        "tolerance_um = 1.0",
        "tolerance_map = { w_mm = [1.0], z_mm = [1.0] }",
        "missing-key",
        "target.tolerance_map.tolerance_um",
        &["a list"],
    ),
    case(
        "tolerance_um = 1.0",
        "tolerance_map = 3",
        "wrong-type",
        "target.tolerance_map",
        &["a text or a table"],
    ),
    case(
        "kind = \"helix_crowning\", amount_um = 20.0",
        "kind = \"formula\"",
        "missing-key",
        "target.modifications[0].f_um",
        &["a text"],
    ),
    case(
        "kind = \"helix_crowning\", amount_um = 20.0",
        "kind = \"helix_traces\", f_mm = []",
        "unknown-key",
        "target.modifications[0].f_mm",
        &["did you mean `f_um`"],
    ),
    // the shift and the tool
    case(
        "diagonal_ratio = \"auto\"",
        "diagonal_ratio = { z = [1], ratio = [2] }",
        "unknown-key",
        "grinding.diagonal_ratio.ratio",
        &["curve, table"],
    ),
    case(
        "diagonal_ratio = \"auto\"",
        "diagonal_ratio = {}",
        "missing-key",
        "grinding.diagonal_ratio.curve",
        &["exactly one of"],
    ),
    case(
        "diagonal_ratio = \"auto\"",
        "diagonal_ratio = { curve = { kind = \"line_sine\", slope = 2, w_0_mm = 14, a_mm = 1, p_mm = 3, flank = \"left\" }, table = { z_v2_mm = [0, 1], z_v1_mm = [0, 2] } }",
        "invalid-job",
        "grinding.diagonal_ratio.table",
        &["keep one"],
    ),
    case(
        "diagonal_ratio = \"auto\"",
        "diagonal_ratio = { curve = { kind = \"line_bend\", slope = 2 } }",
        "unknown-value",
        "grinding.diagonal_ratio.curve.kind",
        &["did you mean \"line_blend\""],
    ),
    case(
        "diagonal_ratio = \"auto\"",
        "diagonal_ratio = { curve = { kind = \"line_blend\", slope = 2, w_t_mm = 14, h_mm = 0, z_e_mm = 0, flank = \"left\" } }",
        "invalid-number",
        "grinding.diagonal_ratio.curve.h_mm",
        &["> 0"],
    ),
    case(
        "diagonal_ratio = \"auto\"",
        "diagonal_ratio = { curve = { kind = \"points\", w_mm = [0, 1, 2], z_mm = [0, 1], flank = \"left\" } }",
        "invalid-list",
        "grinding.diagonal_ratio.curve.z_mm",
        &["3 entries"],
    ),
    case(
        "diagonal_ratio = \"auto\"",
        "diagonal_ratio = { table = { z_v2_mm = [0, 1, 1], z_v1_mm = [0, 2, 3] } }",
        "invalid-list",
        "grinding.diagonal_ratio.table.z_v2_mm[2]",
        &["does not ascend", "> 1"],
    ),
    case(
        "diagonal_ratio = \"auto\"",
        "diagonal_ratio = { table = { z_v2_mm = [0], z_v1_mm = [0] } }",
        "invalid-list",
        "grinding.diagonal_ratio.table.z_v2_mm",
        &["2 to 100000 entries"],
    ),
    case(
        "method = \"diagonal\"\nflanks = \"both\"\ndiagonal_ratio = \"auto\"",
        "method = \"radial\"\ndiagonal_ratio = \"areas\"",
        "invalid-job",
        "grinding.diagonal_ratio",
        &["areas"],
    ),
    case(
        "[target]",
        "[deviations]\n[target]",
        "invalid-job",
        "deviations",
        &["no axis is off", "leave the table out"],
    ),
    case(
        "[target]",
        "[measured_worm]\nfile = \"nowhere.csv\"\n[target]",
        "invalid-table",
        "measured_worm.file",
        &["nowhere.csv", "w_mm", "correct the table"],
    ),
    case(
        "[target]",
        "[measured_worm]\nfile = \"worm.csv\"\nnoise_um = 0\n[target]",
        "invalid-number",
        "measured_worm.noise_um",
        &["0", "100", "repeatability"],
    ),
    case(
        "[target]",
        "[measured_worm]\nfile = \"worm.csv\"\nthickness = \"yes\"\n[target]",
        "wrong-type",
        "measured_worm.thickness",
        &["true or false"],
    ),
    case(
        "[target]",
        "[measured_worm]\nfile = \"worm.csv\"\nheld = [\"gamma\", \"d\", \"v_y\"]\n[target]",
        "invalid-job",
        "measured_worm.held",
        &["no axis is left", "thickness"],
    ),
    case(
        "[target]",
        "[deviations]\ncrossing_angle_deg = 2.0\n[target]",
        "invalid-number",
        "deviations.crossing_angle_deg",
        &[">= -1 and <= 1", "thousandths of a degree"],
    ),
    case(
        "[target]",
        "[deviations]\nradial_feed_um = [0, 0, 0, 0, 0, 0, 1]\n[target]",
        "invalid-list",
        "deviations.radial_feed_um",
        &["6"],
    ),
    case(
        "[target]",
        "[deviations]\nwork_angle_arcsec = [1e4]\n[target]",
        "invalid-number",
        "deviations.work_angle_arcsec[0]",
        &["3600"],
    ),
    case(
        "[target]",
        "[deviations]\ndressing = { d_d_mm = 3 }\n[target]",
        "invalid-number",
        "deviations.dressing.d_d_mm",
        &[">= -1 and <= 1"],
    ),
    case(
        "kind = \"helix_crowning\", amount_um = 20.0",
        "kind = \"profile_trace\", noise_um = \"much\"",
        "wrong-type",
        "target.modifications[0].noise_um",
        &["a number"],
    ),
    case(
        "kind = \"helix_crowning\", amount_um = 20.0",
        "kind = \"profile_trace\", points = [[1, 2, 3]]",
        "invalid-list",
        "target.modifications[0].points[0]",
        &["2 to 2 entries"],
    ),
    case(
        "method = \"diagonal\"",
        "method = \"diagonal\"\ntry_changes = \"never\"",
        "wrong-type",
        "grinding.try_changes",
        &["true or false"],
    ),
    case("[target]", "[target]\ntraces = { beside_um = 5.0 }", "invalid-job", "target.traces", &["judged"]),
    case(
        "[target]",
        "[target]\njudged = \"traces\"\ntraces = { beside_um = 0.01 }",
        "invalid-number",
        "target.traces.beside_um",
        &["at least tolerance_um"],
    ),
    case(
        "[target]",
        "[target]\njudged = \"traces\"\ntraces = { profile_z_mm = [0.0, 500.0] }",
        "invalid-number",
        "target.traces.profile_z_mm[1]",
        &["outside the evaluated range", " to "],
    ),
    case("[target]", "[target]\njudged = \"lines\"", "unknown-value", "target.judged", &["field", "traces"]),
    case(
        "overrun = 1.0",
        "prefer = \"cost\"",
        "unknown-value",
        "grinding.prefer",
        &["accuracy", "worm", "time"],
    ),
    case(
        "overrun = 1.0",
        "axis_limits = { d_d_mm = 0.0 }",
        "invalid-number",
        "grinding.axis_limits.d_d_mm",
        &["> 0", "100"],
    ),
    case(
        "overrun = 1.0",
        "axis_limits = { d_x_mm = 1.0 }",
        "unknown-key",
        "grinding.axis_limits.d_x_mm",
        &["d_v_yA_mm"],
    ),
    case(
        "overrun = 1.0",
        "least_determinant_ratio = 1.0",
        "invalid-number",
        "grinding.least_determinant_ratio",
        &["< 1"],
    ),
    case("overrun = 1.0", "free_ratio = 0.5", "invalid-job", "grinding.free_ratio", &["areas"]),
    case(
        "[grid]",
        "[stock]\nallowance_um = -5.0\n[grid]",
        "invalid-number",
        "stock.allowance_um",
        &["> 0", "5000"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\nprofile = [{ diameter = 1.0, um = 5.0 }]\n[grid]",
        "invalid-number",
        "stock.profile[0].diameter",
        &["base circle"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\nrun_out = { eccentricity_um = -1.0 }\n[grid]",
        "invalid-number",
        "stock.run_out.eccentricity_um",
        &[">= 0", "half the run-out"],
    ),
    case("[grid]", "[stock]\nprofile = []\n[grid]", "missing-key", "stock.allowance_um", &["map", "100"]),
    case(
        "[grid]",
        "[stock]\nmap = \"nowhere.csv\"\n[grid]",
        "invalid-table",
        "stock.map",
        &["nowhere.csv", "w_mm", "inspect"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\nhob = { feed = 2.0, tip_diameter = 80.0 }\n[grid]",
        "invalid-job",
        "stock.hob",
        &["height_um", "threads"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\nhob = { feed = 2.0, tip_diameter = 8.0, threads = 9 }\n[grid]",
        "worm-too-small",
        "stock.hob.tip_diameter",
        &["8", "height_um"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\ndressing = { depth_um = 0.0 }\n[grid]",
        "invalid-number",
        "technology.dressing.depth_um",
        &["> 0", "10"],
    ),
    case("[grid]", "[technology]\n[grid]", "invalid-job", "technology", &["[stock]", "stock.allowance_um"]),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\nlimits = { Vw_finishing = 0.0 }\n[grid]",
        "invalid-number",
        "technology.limits.Vw_finishing",
        &["> 0", "mm^3/mm"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\ntimes = {}\n[grid]",
        "invalid-job",
        "technology.times",
        &["[machine]"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\ncycle = \"cheapest\"\nlimits = { Qw_roughing = 5.0, Qw_finishing = 2.0 }\n[grid]",
        "invalid-job",
        "technology.cycle",
        &["technology.cost"],
    ),
    case(
        "[grid]",
        "[explore.worm_life]\nlast_tip_diameter = 0.0\n[grid]",
        "invalid-number",
        "explore.worm_life.last_tip_diameter",
        &["> 0"],
    ),
    case(
        "[grid]",
        "[explore.worm_life]\nlast_tip_diameter = 200.0\ncount = 1\n[grid]",
        "invalid-number",
        "explore.worm_life.count",
        &["2"],
    ),
    case(
        "[grid]",
        "[explore]\ndiagonal_ratio = { from = -3.0, to = 3.0, count = 5 }\nworm_life = { last_tip_diameter = 200.0 }\n[grid]",
        "invalid-job",
        "explore.worm_life",
        &["two jobs"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\nlife = { last_tip_diameter = 999.0, radial_per_dressing = 0.1 }\nlimits = { Vw_finishing = 800.0, zone_width = 100.0 }\n[grid]",
        "invalid-job",
        "technology.life.last_tip_diameter",
        &["worm.tip_diameter"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\nstrokes = [{ left_um = 30.0 }, { left_um = 40.0 }, { left_um = 0.0 }]\n[grid]",
        "stroke-order",
        "technology.strokes[1].left_um",
        &["0 to 30 um"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\nstrokes = [{ left_um = 30.0 }]\n[grid]",
        "stroke-order",
        "technology.strokes[0].left_um",
        &["last stroke"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\nstrokes = [{ left_um = -1.0 }]\n[grid]",
        "invalid-number",
        "technology.strokes[0].left_um",
        &[">= 0"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\nstrokes = [{ left_um = 0.0, feed_per_revolution = 0.0 }]\n[grid]",
        "invalid-number",
        "technology.strokes[0].feed_per_revolution",
        &["> 0"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\nlimits = { largest_feed = 0.5 }\nstrokes = [{ left_um = 0.0, feed_per_revolution = 0.8 }]\n[grid]",
        "invalid-number",
        "technology.strokes[0].feed_per_revolution",
        &["0.5 mm"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\nstrokes = [{ left_um = 0.0, shift = { ratio = 1.0 } }]\n[grid]",
        "invalid-job",
        "technology.strokes[0].shift.ratio",
        &["grinding.diagonal_ratio"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\nstrokes = [{ left_um = 0.0, zone = \"roughing\" }]\n[grid]",
        "invalid-job",
        "technology.strokes[0].zone",
        &["roughing_areas"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\ncycle = \"fastest\"\nlimits = { Qw_roughing = 5.0 }\n[grid]",
        "invalid-job",
        "technology.cycle",
        &["Qw_finishing"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\ncycle = \"fastest\"\nlimits = { Qw_roughing = 5.0, Qw_finishing = 2.0 }\nstrokes = [{ left_um = 0.0 }]\n[grid]",
        "invalid-job",
        "technology.cycle",
        &["one of both"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\nlimits = { least_feed = 0.5, largest_feed = 0.4 }\n[grid]",
        "invalid-number",
        "technology.limits.largest_feed",
        &["least_feed"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\nlimits = { Qw_roughing = 0.0 }\n[grid]",
        "invalid-number",
        "technology.limits.Qw_roughing",
        &["> 0"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\nlimits = { wheel_speed_m_per_s = 40.0 }\n[grid]",
        "invalid-number",
        "technology.limits.wheel_speed_m_per_s",
        &["50 or more"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\npitch_um = { left = [1.0], right = [1.0] }\n[grid]",
        "invalid-job",
        "stock.pitch_um.left",
        &["one for each tooth space"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\nstrokes = [{ left_um = 30.0, modification_share = 0.5 }, { left_um = 0.0 }]\n[grid]",
        "invalid-job",
        "technology.strokes[0].modification_share",
        &["0.5", "grinding.roughing_areas"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\nstrokes = [{ left_um = 0.0, modification_share = 0.5 }]\n[grid]",
        "invalid-job",
        "technology.strokes[0].modification_share",
        &["leaves nothing"],
    ),
    case(
        "[grid]",
        "[stock]\nallowance_um = 90.0\n[technology]\nstrokes = [{ left_um = 30.0, modification_share = 2.5 }, { left_um = 0.0 }]\n[grid]",
        "invalid-number",
        "technology.strokes[0].modification_share",
        &["<= 2", "a share of the wanted modification"],
    ),
    case(
        "overrun = 1.0",
        "roughing_ratio = 0.5",
        "invalid-job",
        "grinding.roughing_ratio",
        &["roughing_areas"],
    ),
    case(
        "threads = 3",
        "threads = 3\nflank_form = \"ZA\"",
        "invalid-job",
        "worm.flank_form",
        &["\"ZA\"", "worm.tool = \"given\""],
    ),
    case("threads = 3", "threads = 3\nflank_form = \"ZX\"", "unknown-value", "worm.flank_form", &["\"ZN\""]),
    case(
        "threads = 3",
        "threads = 3\nform_disc_diameter = 150.0",
        "invalid-job",
        "worm.form_disc_diameter",
        &["ZK", "leave the diameter out"],
    ),
    case(
        "threads = 3",
        "threads = 3\nflank_form = \"ZK\"",
        "missing-key",
        "worm.form_disc_diameter",
        &["diameter of the disc"],
    ),
    case("overrun = 1.0", "roughing_areas = 1001", "invalid-number", "grinding.roughing_areas", &["1000"]),
    case("overrun = 1.0", "active_threads = []", "invalid-list", "grinding.active_threads", &["1 to 100"]),
    case(
        "overrun = 1.0",
        "active_threads = [0, 3]",
        "invalid-list",
        "grinding.active_threads[1]",
        &["0 to 2"],
    ),
    case(
        "overrun = 1.0",
        "active_threads = [1, 1]",
        "invalid-list",
        "grinding.active_threads[1]",
        &["twice"],
    ),
    case(
        "overrun = 1.0",
        "gauge = \"centered\"",
        "unknown-value",
        "grinding.gauge",
        &["\"centred\"", "k_10"],
    ),
    case("overrun = 1.0", "gauge = { k_11 = 1 }", "unknown-key", "grinding.gauge.k_11", &["k_k0"]),
    case("threads = 3", "threads = 3\ntool = \"made\"", "invalid-job", "dresser", &["not dressed", "remove"]),
    case(
        "threads = 3",
        "threads = 3\nmodifications = []",
        "invalid-job",
        "target.modifications",
        &["no key beside worm.modifications", "the gear follows"],
    ),
    case(
        "threads = 3",
        "threads = 3\ntool = \"made\"\nmodifications = []",
        "invalid-job",
        "worm.modifications",
        &["\"given\""],
    ),
    case(
        "threads = 3",
        "threads = 3\nmodifications = [{ kind = \"twist\", amount_um = 1 }]",
        "invalid-job",
        "worm.modifications[0].kind",
        &["\"polynomial\""],
    ),
    case("threads = 3", "threads = 3\ndirection_deg = 80", "invalid-job", "worm.direction_deg", &["leave"]),
    case(
        "threads = 3",
        "threads = 3\ndirection_deg = { left = 90, right = 0 }",
        "invalid-number",
        "worm.direction_deg.left",
        &["< 90"],
    ),
    case(
        "[grid]",
        "[explore]\ndiagonal_ratio = { from = 1, to = -1, count = 3 }\n[grid]",
        "invalid-job",
        "explore.diagonal_ratio.to",
        &["ascend"],
    ),
    case(
        "[grid]",
        "[explore]\nworm_cone_angle_deg = { from = 0, to = 2, count = 1 }\n[grid]",
        "invalid-number",
        "explore.worm_cone_angle_deg.count",
        &[">= 2"],
    ),
    case("[grid]", "[explore]\n[grid]", "missing-key", "explore.diagonal_ratio", &["crossed_axes_angle_deg"]),
    // bodies
    case(
        "root_diameter = 72.4315",
        "root_diameter = 90.0",
        "invalid-geometry",
        "gear.tip_diameter",
        &["root diameter <= form diameter < tip diameter"],
    ),
    case(
        "form_diameter = 76.2065",
        "form_diameter = 70.0",
        "invalid-geometry",
        "gear.form_diameter",
        &["70", "drawing"],
    ),
    case(
        "form_diameter = 76.2065",
        "form_diameter = 88.6",
        "invalid-geometry",
        "gear.form_diameter",
        &["88.6"],
    ),
    case(
        "start_diameter = 76.2065",
        "start_diameter = 76.0",
        "invalid-geometry",
        "gear.evaluation.start_diameter",
        &["76.2065"],
    ),
    case(
        "end_diameter = 88.5315",
        "end_diameter = 89.0",
        "invalid-geometry",
        "gear.evaluation.end_diameter",
        &["88.5315"],
    ),
    case(
        "end_diameter = 88.5315",
        "end_diameter = 76.2",
        "invalid-geometry",
        "gear.evaluation.end_diameter",
        &["exchange"],
    ),
    case("z_start = -20.0", "z_start = -20.1", "invalid-geometry", "gear.evaluation.z_start", &["-20 to 20"]),
    case("z_end = 20.0", "z_end = 20.1", "invalid-geometry", "gear.evaluation.z_end", &["-20 to 20"]),
    case(
        "z_start = -20.0, z_end = 20.0",
        "z_start = 5.0, z_end = 5.0",
        "invalid-geometry",
        "gear.evaluation.z_end",
        &["exchange"],
    ),
    case(
        "threads = 3",
        "threads = 3\npitch_diameter = 200.0",
        "invalid-geometry",
        "worm.pitch_diameter",
        &["< 200"],
    ),
    case(
        "pitch_diameter = 115.65",
        "pitch_diameter = 123.0",
        "invalid-geometry",
        "dresser.pitch_diameter",
        &["< 123"],
    ),
    case("teeth = 19", "teeth = -19", "invalid-geometry", "gear.tip_diameter", &["internal gear"]),
    // strokes
    case("[dressing]", "[dressing]\nstrokes = 3", "wrong-type", "dressing.strokes", &["3", "a table"]),
    case(
        "[dressing]",
        "[dressing]\nstrokes = { areas = [{ from = 0.0, to = 1.0 }], sections = [{ to = 0.9 }] }",
        "invalid-job",
        "dressing.strokes.sections[0].to",
        &["0.9", "1", "let the last section end"],
    ),
    case(
        "[dressing]",
        "[dressing]\nstrokes = { areas = [{ from = 0.5, to = 0.2 }], sections = [{ to = 1.0 }] }",
        "invalid-job",
        "dressing.strokes.areas[0].to",
        &["> 0.5", "ascending"],
    ),
    case(
        "[dressing]",
        "[dressing]\nstrokes = { areas = [{ from = 0.0, to = 1.0 }], sections = [{ to = 1.0, area = 2 }] }",
        "invalid-job",
        "dressing.strokes.sections[0].area",
        &["1 to 1", "add one"],
    ),
    case(
        "[dressing]",
        "[dressing]\nstrokes = { areas = [{ from = 0.0, to = 1.0, dresser = 2 }], sections = [{ to = 1.0 }] }",
        "invalid-job",
        "dressing.strokes.areas[0].dresser",
        &["dresser.others"],
    ),
    case(
        "[dressing]",
        "[dressing]\nstrokes = { areas = [{ from = 0.0, to = 1.0 }], sections = [{ to = 1.0 }], overlap = -0.1 }",
        "invalid-number",
        "dressing.strokes.overlap",
        &["-0.1", ">= 0"],
    ),
    case(
        "[dressing]",
        "[dressing]\nstrokes = { areas = [{ from = 0.0, to = 1.0 }], sections = [{ to = 1.0 }] }",
        "invalid-job",
        "dressing.profile_crowning_by",
        &["auto"],
    ),
    case(
        "[dressing]",
        "modification = \"target\"\n\n[dressing]\nstrokes = { areas = [{ from = 0.0, to = 1.0 }], sections = [{ to = 1.0 }] }",
        "invalid-job",
        "dresser.modification",
        &["target", "none"],
    ),
    case(
        "[dressing]",
        "[[dresser.others]]\ntip_diameter = 100.0\n\n[dressing]",
        "invalid-job",
        "dresser.others",
        &["dressing.strokes"],
    ),
    case(
        "[dressing]",
        "[[dresser.others]]\ntip_diameter = 100.0\npitch_diameter = 110.0\n\n[dressing]",
        "invalid-geometry",
        "dresser.others[0].pitch_diameter",
        &["< 100"],
    ),
    // the root of the gear
    case(
        "[dressing]",
        "[dressing]\ngear_root = { corner_radius = 0.8 }",
        "invalid-job",
        "dressing.conditions",
        &["head", "three-point"],
    ),
    case(
        "[dressing]",
        "[dressing]\ngear_root = { corner_radius = 0.8 }",
        "invalid-job",
        "worm.tip_diameter",
        &["200", "worm.pitch_diameter"],
    ),
    case(
        "[dressing]",
        "[dressing]\ngear_root = { corner_radius = -0.8 }",
        "invalid-number",
        "dressing.gear_root.corner_radius",
        &["-0.8", "radius of the worm's edge"],
    ),
    case(
        "[dressing]",
        "[dressing]\ngear_root = { along = \"constant\" }",
        "missing-key",
        "dressing.gear_root.corner_radius",
        &[],
    ),
    case(
        "[dresser]",
        "[dresser]\ndesigned_for = { threads = 2 }",
        "missing-key",
        "dresser.designed_for.pitch_diameter",
        &["tip_diameter"],
    ),
];

/// Changes to the template of tangential dressing.
const TANGENTIAL_CASES: &[Case] = &[
    // keys
    case(
        "edge_amounts = {",
        "edge_amount = {",
        "unknown-key",
        "target.edge_amount",
        &["did you mean `edge_amounts`"],
    ),
    case(
        "lead_crowning_um = 10.0",
        "lead_crown_um = 10.0",
        "unknown-key",
        "target.edge_amounts.lead_crown_um",
        &["did you mean `lead_crowning_um`", "pressure_angle_um"],
    ),
    case(
        "edge_amounts = {",
        "edge_amounts = { left = { lead_crowning_um = 10.0 } } # {",
        "missing-key",
        "target.edge_amounts.right",
        &["profile_crowning_um"],
    ),
    case(
        "edge_amounts = {",
        "edge_amounts = { left = {}, right = { crowning_um = 3 } } # {",
        "unknown-key",
        "target.edge_amounts.right.crowning_um",
        &["lead_conical_um"],
    ),
    case("threads = 3", "threads = 3\ncone_angle_deg = 1.0", "unknown-key", "worm.cone_angle_deg", &["hand"]),
    case(
        "tip_diameter = 123.0\n",
        "",
        "missing-key",
        "dresser.tip_diameter",
        &["tip diameter of the dresser"],
    ),
    case("threads = 3\n", "", "missing-key", "worm.threads", &["number of threads"]),
    // words
    case(
        "process = \"tangential-dressing\"",
        "process = \"tangential-dresing\"",
        "unknown-value",
        "job.process",
        &["did you mean \"tangential-dressing\"", "\"generating-grinding\""],
    ),
    case(
        "shift_ratio = 1.202605",
        "shift_ratio = \"neutal\"",
        "unknown-value",
        "grinding.shift_ratio",
        &["did you mean \"neutral\"", "or a number"],
    ),
    case(
        "[dressing]",
        "shift_offset = \"contacts\"\n[dressing]",
        "unknown-value",
        "grinding.shift_offset",
        &["did you mean \"contact\"", "or a number"],
    ),
    case(
        "[dressing]",
        "[dressing]\nmethod = \"newton\"",
        "unknown-value",
        "dressing.method",
        &["\"auto\", \"svd\", \"damped\", \"gauss-newton\""],
    ),
    case("[dressing]", "[dressing]\npasses = 2", "wrong-type", "dressing.passes", &["\"one\" or \"each\""]),
    case(
        "[dressing]",
        "[dressing]\nexclude = [\"Fz\", \"FpL\"]",
        "unknown-value",
        "dressing.exclude[1]",
        &["\"Fp\", \"Fz\"", "\"kap\""],
    ),
    case(
        "[dressing]",
        "[dressing]\nsplines = [{ channel = \"kap\", intervals = 6 }]",
        "unknown-value",
        "dressing.splines[0].channel",
        &["\"FpL\", \"FpR\""],
    ),
    // names of variables
    case(
        "[dressing]",
        "[dressing]\nvariables = \"all\"",
        "unknown-value",
        "dressing.variables",
        &["\"auto\", \"source\" or a list"],
    ),
    case(
        "[dressing]",
        "[dressing]\nvariables = [\"dX2\", \"dx3\"]",
        "unknown-value",
        "dressing.variables[1]",
        &["did you mean \"dX3\"", "Fp1..Fp9"],
    ),
    case(
        "[dressing]",
        "[dressing]\nvariables = [\"Fp0\"]",
        "unknown-value",
        "dressing.variables[0]",
        &["thickness", "dist0"],
    ),
    case(
        "[dressing]",
        "[dressing]\nvariables = [\"crowning\"]",
        "unknown-value",
        "dressing.variables[0]",
        &["\"dX2\""],
    ),
    case("[dressing]", "[dressing]\nvariables = [2]", "wrong-type", "dressing.variables[0]", &["a text"]),
    case(
        "[dressing]",
        "[dressing]\nvariables = [\"dX2\", \"kap\", \"dX2\"]",
        "invalid-list",
        "dressing.variables[2]",
        &["twice", "each entry once"],
    ),
    case("[dressing]", "[dressing]\nvariables = []", "invalid-list", "dressing.variables", &["1 to 60"]),
    case(
        "[grid]",
        "[settings]\nleft = { values = { Fp0 = 0.001 } }\n[grid]",
        "unknown-key",
        "settings.left.values.Fp0",
        &["dist0"],
    ),
    case(
        "[grid]",
        "[settings]\nboth = { values = { kap = 1.2 } }\n[grid]",
        "unknown-key",
        "settings.both.values.kap",
        &["settings.both", "kap = .."],
    ),
    case(
        "[grid]",
        "[settings]\nright = { values = { FC10 = 0.001 } }\n[grid]",
        "unknown-key",
        "settings.right.values.FC10",
        &["did you mean \"FC1\""],
    ),
    // numbers
    case(
        "profile_crowning_um = 5.0",
        "profile_crowning_um = nan",
        "invalid-number",
        "target.edge_amounts.profile_crowning_um",
        &["NaN", "-1000"],
    ),
    case(
        "edge_amounts = {",
        "edge_amounts = { left = { lead_conical_um = 1001 }, right = {} } # {",
        "invalid-number",
        "target.edge_amounts.left.lead_conical_um",
        &["1001", "<= 1000"],
    ),
    case("tolerance_um = 1.0", "tolerance_um = 0.0", "invalid-number", "target.tolerance_um", &["> 0"]),
    case("shift_width = 48.1042", "shift_width = 0", "invalid-number", "grinding.shift_width", &["> 0"]),
    case(
        "shift_ratio = 1.202605",
        "shift_ratio = 1001",
        "invalid-number",
        "grinding.shift_ratio",
        &["<= 1000", "neutral"],
    ),
    case(
        "[dressing]",
        "shift_offset = inf\n[dressing]",
        "invalid-number",
        "grinding.shift_offset",
        &["inf", "contact"],
    ),
    case(
        "[dressing]",
        "[dressing]\nmost_variables = 61",
        "invalid-number",
        "dressing.most_variables",
        &[">= 1 and <= 60"],
    ),
    case("[dressing]", "[dressing]\nsteps = 0", "invalid-number", "dressing.steps", &[">= 1 and <= 64"]),
    case(
        "[dressing]",
        "[dressing]\nfit_points = 4",
        "invalid-number",
        "dressing.fit_points",
        &[">= 5 and <= 41"],
    ),
    case(
        "[dressing]",
        "[dressing]\nsplines = [{ channel = \"dX\", intervals = 0 }]",
        "invalid-number",
        "dressing.splines[0].intervals",
        &[">= 1 and <= 64"],
    ),
    case(
        "[grid]",
        "[settings]\nleft = { values = { dX2 = 1e4 } }\n[grid]",
        "invalid-number",
        "settings.left.values.dX2",
        &["<= 1000", "coefficient in mm"],
    ),
    case(
        "[grid]",
        "[settings]\nleft = { values = { dX2 = \"0.1\" } }\n[grid]",
        "wrong-type",
        "settings.left.values.dX2",
        &["remove the quotes"],
    ),
    case(
        "[grid]",
        "[settings]\nleft = { values = { gA1 = 2.0 } }\n[grid]",
        "invalid-number",
        "settings.left.values.gA1",
        &["-1.5 to 1.5 rad"],
    ),
    case(
        "[grid]",
        "[settings]\nleft = { splines = [{ channel = \"gA\", intervals = 1, coefficients = [0.0, -2.0] }] }\n[grid]",
        "invalid-number",
        "settings.left.splines[0].coefficients[1]",
        &["rad"],
    ),
    case(
        "[grid]",
        "[settings]\nleft = { splines = [{ channel = \"dX\", intervals = 1, coefficients = [] }] }\n[grid]",
        "invalid-list",
        "settings.left.splines[0].coefficients",
        &["1 to 100"],
    ),
    // contradictions
    case(
        "name = \"tangential-dressing\"",
        "name = \"../elsewhere\"",
        "invalid-job",
        "job.name",
        &["plain name"],
    ),
    case(
        "edge_amounts = { profile_crowning_um = 5.0, lead_crowning_um = 10.0 }\n",
        "",
        "missing-key",
        "target.modifications",
        &["either", "edge_amounts"],
    ),
    case(
        "tolerance_um = 1.0",
        "tolerance_um = 1.0\nmodifications = []",
        "invalid-job",
        "target.edge_amounts",
        &["twice", "keep one"],
    ),
    case("teeth = 19", "teeth = -19", "not-yet-supported", "gear.teeth", &["-19", "> 0", "external"]),
    case(
        "pitch_diameter = 115.65",
        "pitch_diameter = 115.65\nmodification = \"target\"\ndesigned_for = { threads = 3, tip_diameter = 240.0 }",
        "invalid-job",
        "dresser.modification",
        &["\"none\"", "is there"],
    ),
    case(
        "pitch_diameter = 115.65",
        "pitch_diameter = 115.65\nmodification = \"none\"\ndesigned_for = { threads = 3 }",
        "missing-key",
        "dresser.designed_for.pitch_diameter",
        &["tip_diameter"],
    ),
    case(
        "pitch_diameter = 115.65",
        "pitch_diameter = 115.65\nmodification = { kind = \"helix_crowning\", amount_um = 5.0 }",
        "invalid-job",
        "dresser.modification.kind",
        &["profile only", "profile_crowning"],
    ),
    case(
        "pitch_diameter = 115.65\n[grinding]\nflanks = \"right\"\nshift_ratio = 1.202605\nshift_width = 48.1042\n[dressing]\n",
        "pitch_diameter = 115.65\nmodification = \"none\"\n[grinding]\nflanks = \"right\"\nshift_ratio = 1.202605\nshift_width = 48.1042\n[dressing]\nvariables = [\"dX2\", \"Fp2\"]\n",
        "invalid-job",
        "dressing.variables[1]",
        &["\"Fp2\"", "not free", "dresser.modification"],
    ),
    case(
        "pitch_diameter = 115.65\n[grinding]\nflanks = \"right\"\nshift_ratio = 1.202605\nshift_width = 48.1042\n[dressing]\n",
        "pitch_diameter = 115.65\nmodification = \"none\"\n[grinding]\nflanks = \"right\"\nshift_ratio = 1.202605\nshift_width = 48.1042\n[dressing]\nvariables = \"source\"\n",
        "invalid-job",
        "dressing.variables",
        &["\"source\"", "\"auto\""],
    ),
    case(
        "pitch_diameter = 115.65\n[grinding]\nflanks = \"right\"\nshift_ratio = 1.202605\nshift_width = 48.1042\n[dressing]\n",
        "pitch_diameter = 115.65\nmodification = \"none\"\n[grinding]\nflanks = \"right\"\nshift_ratio = 1.202605\nshift_width = 48.1042\n[dressing]\nsplines = [{ channel = \"FpL\", intervals = 4 }]\n",
        "invalid-job",
        "dressing.splines[0].channel",
        &["\"FpL\"", "not free"],
    ),
    case("[grid]", "[explore]\n[grid]", "missing-key", "explore.shift_ratio", &["worm_threads", "count = 9"]),
    case(
        "[grid]",
        "[explore]\nshift_ratio = { from = 2.0, to = 1.0, count = 3 }\n[grid]",
        "invalid-job",
        "explore.shift_ratio.to",
        &["> from = 2", "smaller value"],
    ),
    case(
        "[grid]",
        "[explore]\nworm_tip_diameter = { from = 0.0, to = 100.0, count = 3 }\n[grid]",
        "invalid-number",
        "explore.worm_tip_diameter.from",
        &["> 0", "in mm"],
    ),
    case(
        "[grid]",
        "[explore]\nworm_threads = [0]\n[grid]",
        "invalid-number",
        "explore.worm_threads[0]",
        &["<= 100", "1 or more"],
    ),
    case(
        "profile_shift = 0.0",
        "profile_shift = 0.0\nspan = { teeth = 3, length = 27.5 }",
        "invalid-job",
        "gear.span",
        &["exactly one of"],
    ),
    case("z_end = 20.0", "z_end = 20.1", "invalid-geometry", "gear.evaluation.z_end", &["-20 to 20"]),
    case("tip_diameter = 200.0\n", "", "missing-key", "worm.tip_diameter", &["pitch_diameter"]),
    case(
        "threads = 3",
        "threads = 3\npitch_diameter = 200.0",
        "invalid-geometry",
        "worm.pitch_diameter",
        &["< 200"],
    ),
    case(
        "pitch_diameter = 115.65",
        "pitch_diameter = 123.0",
        "invalid-geometry",
        "dresser.pitch_diameter",
        &["< 123"],
    ),
    case(
        "shift_ratio = 1.202605\nshift_width = 48.1042\n",
        "",
        "missing-key",
        "grinding.shift_width",
        &["neutral", "1.2 times the face width"],
    ),
    case(
        "shift_ratio = 1.202605\nshift_width = 48.1042\n",
        "shift_ratio = \"width\"\n",
        "missing-key",
        "grinding.shift_width",
        &["range of the tool shift"],
    ),
    case(
        "[dressing]",
        "[dressing]\npasses = \"one\"",
        "invalid-job",
        "dressing.passes",
        &["right flank", "\"each\""],
    ),
    case(
        "flanks = \"right\"\nshift_ratio = 1.202605\nshift_width = 48.1042\n[dressing]",
        "shift_ratio = 1.2\n[settings]\nleft = { kap = 1.2 }\n[dressing]\npasses = \"one\"",
        "invalid-job",
        "settings.left",
        &["settings.both", "FpL"],
    ),
    case(
        "[dressing]",
        "[dressing]\nexclude = [\"dX\"]\nvariables = [\"Fp1\", \"dX2\"]",
        "invalid-job",
        "dressing.variables[1]",
        &["\"dX2\"", "exclude"],
    ),
    case(
        "[dressing]",
        "[dressing]\nexclude = [\"Fp\"]\nvariables = [\"dX2\", \"FpL2\"]",
        "invalid-job",
        "dressing.variables[1]",
        &["Fp is excluded"],
    ),
    case(
        "[dressing]",
        "[dressing]\nexclude = [\"Fz\"]\nvariables = \"source\"",
        "invalid-job",
        "dressing.variables",
        &["Fz is excluded", "auto"],
    ),
    case(
        "[dressing]",
        "[dressing]\nexclude = [\"dX\"]\nsplines = [{ channel = \"dX\", intervals = 6 }]",
        "invalid-job",
        "dressing.splines[0].channel",
        &["delete the spline"],
    ),
    case(
        "[dressing]",
        "[dressing]\nsplines = [{ channel = \"dX\", intervals = 6 }, { channel = \"dX\", intervals = 3 }]",
        "invalid-list",
        "dressing.splines[1].channel",
        &["each channel once"],
    ),
    case(
        "[dressing]",
        "[dressing]\nexclude = [\"dX\", \"dX\"]",
        "invalid-list",
        "dressing.exclude[1]",
        &["twice"],
    ),
    case(
        "[dressing]",
        "[dressing]\nexclude = [\"Fp\", \"Fz\", \"dX\", \"dA\", \"gA\", \"gam\", \"dist\", \"FC\", \"FT\", \"kap\"]",
        "invalid-list",
        "dressing.exclude",
        &["0 to 9"],
    ),
    case(
        "profile_points = 41\nhelix_points = 41",
        "profile_points = 1001\nhelix_points = 101",
        "invalid-job",
        "grid.profile_points",
        &["40401"],
    ),
];

/// Changes to the template of the electronic gearbox.
const GEARBOX_CASES: &[Case] = &[
    // keys, types and words
    case("teeth = 40\n", "", "missing-key", "gear.teeth", &["whole number", "number of teeth"]),
    case(
        "helix_angle_deg = 20.0",
        "helix_angle_deg = 20.0\nface_width = 30.0",
        "unknown-key",
        "gear.face_width",
        &["normal_module"],
    ),
    case(
        "pulses_per_metre = 100000\n",
        "",
        "missing-key",
        "feed.pulses_per_metre",
        &["number > 0 and <= 1e9", "pulses per metre of the scale"],
    ),
    case(
        "pulses_per_metre = 100000",
        "pulses_per_metre = 100000\nmode = \"no_backlash\"",
        "unknown-value",
        "feed.mode",
        &["\"one-way\", \"no-backlash\", \"literal\"", "did you mean \"no-backlash\""],
    ),
    case(
        "pulses_per_revolution = 36000",
        "pulses_per_revolution = 36000.5",
        "wrong-type",
        "workpiece.pulses_per_revolution",
        &["36000.5", "whole number"],
    ),
    case(
        "pulses_per_revolution = 36000",
        "pulses_per_revolution = 36000\nrate = \"bresenheim\"",
        "unknown-value",
        "workpiece.rate",
        &["did you mean \"bresenham\"", "\"binary\""],
    ),
    case(
        "pulses_per_revolution = 36000",
        "pulses_per_revolution = 36000\nreversed = 1",
        "wrong-type",
        "workpiece.reversed",
        &["true or false"],
    ),
    case("[output]", "[outputs]", "unknown-key", "outputs", &["did you mean `output`"]),
    case(
        "[output]",
        "[output]\ntables = [\"csv\"]",
        "unknown-key",
        "output.tables",
        &["pulse_trace", "remove the key"],
    ),
    case(
        "kind = \"constant\"",
        "kind = \"constand\"",
        "unknown-value",
        "servo.disturbances[0].kind",
        &["did you mean \"constant\"", "\"pulses\""],
    ),
    case(
        "torque_n_m = 2.0 }",
        "torque_n_m = 2.0, frequency_hz = 50.0 }",
        "unknown-key",
        "servo.disturbances[0].frequency_hz",
        &["torque_n_m"],
    ),
    case(
        "axis = \"workpiece\"",
        "axis = \"work\"",
        "unknown-value",
        "servo.disturbances[3].axis",
        &["\"worm\", \"workpiece\""],
    ),
    // numbers
    case("teeth = 40", "teeth = 0", "invalid-number", "gear.teeth", &["not 0", "internal gear"]),
    case(
        "normal_pressure_angle_deg = 20.0",
        "normal_pressure_angle_deg = 4.0",
        "invalid-number",
        "gear.normal_pressure_angle_deg",
        &[">= 5 and <= 45"],
    ),
    case(
        "helix_angle_deg = 20.0",
        "helix_angle_deg = 90.0",
        "invalid-number",
        "gear.helix_angle_deg",
        &["< 90", "spur gear"],
    ),
    case(
        "pulses_per_metre = 100000",
        "pulses_per_metre = 0",
        "invalid-number",
        "feed.pulses_per_metre",
        &["> 0", "pitch"],
    ),
    case(
        "pulses_per_metre = 100000",
        "pulses_per_metre = 1e5\nclock_hz = nan",
        "invalid-number",
        "feed.clock_hz",
        &["NaN", "> 0 and <= 1e9", "Hz"],
    ),
    case(
        "pulses_per_metre = 100000",
        "pulses_per_metre = 1e5\npulses_per_interval = 257",
        "invalid-number",
        "feed.pulses_per_interval",
        &[">= 2 and <= 256"],
    ),
    case(
        "pulses_per_metre = 100000",
        "pulses_per_metre = 1e5\ncounter_limit = 4294967296",
        "invalid-number",
        "feed.counter_limit",
        &["4294967296", ">= 1", "16777215"],
    ),
    case(
        "pulses_per_revolution = 36000",
        "pulses_per_revolution = 2147483649",
        "invalid-number",
        "workpiece.pulses_per_revolution",
        &["2147483649", ">= 1"],
    ),
    case("threads = 3", "threads = 0", "invalid-number", "worm.threads", &[">= 1"]),
    case(
        "pulses_per_revolution = 4096",
        "pulses_per_revolution = 0",
        "invalid-number",
        "worm.pulses_per_revolution",
        &[">= 1"],
    ),
    case("speed_rpm = 3000.0", "speed_rpm = 0", "invalid-number", "worm.speed_rpm", &["> 0", "1/min"]),
    case(
        "speed_mm_per_min = 300.0",
        "speed_mm_per_min = -300.0",
        "invalid-number",
        "stimulus.motion[0].speed_mm_per_min",
        &["> 0", "mm/min"],
    ),
    case("dwell_s = 0.5", "dwell_s = 0", "invalid-number", "stimulus.motion[1].dwell_s", &["> 0"]),
    case("[stimulus]", "[stimulus]\nrest_s = -1", "invalid-number", "stimulus.rest_s", &[">= 0"]),
    case("[servo]", "[servo]\nsample_time_us = 0", "invalid-number", "servo.sample_time_us", &["> 0", "125"]),
    case("inertia_kg_m2 = 0.12", "inertia_kg_m2 = 0", "invalid-number", "servo.inertia_kg_m2", &["> 0"]),
    case("[servo]", "[servo]\ndamping_n_m_s = -1", "invalid-number", "servo.damping_n_m_s", &[">= 0"]),
    case("[servo]", "[servo]\nfriction_n_m = -1", "invalid-number", "servo.friction_n_m", &[">= 0"]),
    case(
        "[servo]",
        "[servo]\nfriction_speed_rad_per_s = 0",
        "invalid-number",
        "servo.friction_speed_rad_per_s",
        &["> 0", "0.05"],
    ),
    case(
        "torque_limit_n_m = 60.0",
        "torque_limit_n_m = 0",
        "invalid-number",
        "servo.torque_limit_n_m",
        &["> 0"],
    ),
    case("bandwidth_hz = 40.0", "bandwidth_hz = 0", "invalid-number", "servo.bandwidth_hz", &["> 0", "Hz"]),
    case(
        "[servo]",
        "[servo]\nfeed_forward = 1.5",
        "invalid-number",
        "servo.feed_forward",
        &["<= 1", "share"],
    ),
    case(
        "bandwidth_hz = 40.0",
        "gains = { proportional_n_m_per_rad = 0, integral_n_m_per_rad_s = 0, derivative_n_m_s_per_rad = 0 }",
        "invalid-number",
        "servo.gains.proportional_n_m_per_rad",
        &["> 0", "N m/rad"],
    ),
    case(
        "per_revolution = 3,",
        "per_revolution = 0,",
        "invalid-number",
        "servo.disturbances[4].per_revolution",
        &[">= 1"],
    ),
    case("at_s = 1.0", "at_s = -1.0", "invalid-number", "servo.disturbances[1].at_s", &[">= 0"]),
    case("order = 40.0", "order = 0", "invalid-number", "servo.disturbances[3].order", &["> 0"]),
    // the stimulus
    case(
        "[stimulus]",
        "[stimulus]\nreferences = \"train.csv\"",
        "invalid-job",
        "stimulus.motion",
        &["exactly one of", "references"],
    ),
    case(
        "[stimulus]",
        "[stimulus]\nreference_ticks = [1, 2]\nreference_signs = [1, 1]",
        "invalid-job",
        "stimulus.motion",
        &["exactly one of"],
    ),
    case(
        "[stimulus]",
        "[stimulus]\nreference_signs = [1, 1]",
        "invalid-job",
        "stimulus.reference_signs",
        &["reference_ticks"],
    ),
    case(
        "[stimulus]",
        "[stimulus]\nreference_ticks = [1, 2]",
        "missing-key",
        "stimulus.reference_signs",
        &["2 signs"],
    ),
    case(
        "[stimulus]",
        "[stimulus]\nreference_ticks = [1, 2, 3]\nreference_signs = [1, 1]",
        "invalid-list",
        "stimulus.reference_signs",
        &["2 signs for 3", "3 entries"],
    ),
    case(
        "[stimulus]",
        "[stimulus]\nreference_ticks = [-1]\nreference_signs = [1]",
        "invalid-number",
        "stimulus.reference_ticks[0]",
        &[">= 0", "counted from 1"],
    ),
    case(
        "[stimulus]",
        "[stimulus]\nreference_ticks = []\nreference_signs = []",
        "invalid-list",
        "stimulus.reference_ticks",
        &["1 or more"],
    ),
    case(
        "[stimulus]",
        "[stimulus]\nlast_tick = 1000",
        "invalid-job",
        "stimulus.last_tick",
        &["1000", "no key beside `motion`", "rest_s"],
    ),
    case(
        "[stimulus]",
        "[stimulus]\nstart = 30.0",
        "invalid-job",
        "stimulus.motion[0].to",
        &["30", "dwell_s"],
    ),
    case(
        "{ to = 30.0, speed_mm_per_min = 300.0, acceleration_mm_per_s2 = 200.0 },",
        "{ to = 30.0, speed_mm_per_min = 300.0 },",
        "missing-key",
        "stimulus.motion[0].acceleration_mm_per_s2",
        &["mm/s^2"],
    ),
    case(
        "{ dwell_s = 0.5 }",
        "{ dwell_s = 0.5, at = 3.0 }",
        "unknown-key",
        "stimulus.motion[1].at",
        &["dwell_s"],
    ),
    // amounts that no run can take
    case(
        "speed_mm_per_min = 300.0",
        "speed_mm_per_min = 1e-3",
        "invalid-job",
        "stimulus.motion",
        &["longer than a day", "86400 s"],
    ),
    case(
        "pulses_per_metre = 100000",
        "pulses_per_metre = 1e9\npulses_per_interval = 32",
        "invalid-job",
        "stimulus.motion",
        &["1.92e9 pulses", "coarser scale"],
    ),
    case(
        "[servo]",
        "[servo]\nsample_time_us = 1e-3",
        "invalid-job",
        "stimulus.motion",
        &["samples", "servo.sample_time_us"],
    ),
    // the servo
    case("bandwidth_hz = 40.0\n", "", "missing-key", "servo.bandwidth_hz", &["exactly one of", "gains"]),
    case(
        "[servo]",
        "[servo]\ngains = { proportional_n_m_per_rad = 1, integral_n_m_per_rad_s = 0, derivative_n_m_s_per_rad = 0 }",
        "invalid-job",
        "servo.gains",
        &["beside `bandwidth_hz`", "keep one"],
    ),
    case(
        "[worm]\nthreads = 3\npulses_per_revolution = 4096\nspeed_rpm = 3000.0\n",
        "",
        "invalid-job",
        "servo.disturbances[4].axis",
        &["no worm", "[worm]"],
    ),
    case(
        "width_deg = 20.0",
        "width_deg = 120.0",
        "invalid-job",
        "servo.disturbances[4].width_deg",
        &["< 120", "\"constant\""],
    ),
    // the tolerance
    case("[output]", "[target]\n[output]", "missing-key", "target.tolerance_um", &["> 0", "micrometres"]),
    case(
        "[output]",
        "[target]\ntolerance_um = 0\n[output]",
        "invalid-number",
        "target.tolerance_um",
        &["> 0"],
    ),
    case(
        "[output]",
        "[target]\ntolerance_um = 2000.0\n[output]",
        "invalid-number",
        "target.tolerance_um",
        &["<= 1000"],
    ),
    case(
        "[output]",
        "[target]\ntolerance = 1.0\n[output]",
        "unknown-key",
        "target.tolerance",
        &["tolerance_um"],
    ),
    // the choice
    case("[output]", "[explore]\nwanted_um = 0.5\n[output]", "missing-key", "explore.scales", &["encoders"]),
    case(
        "[output]",
        "[explore]\nscales = [{ pulses_per_metre = 1e5, cost = 1 }]\n[output]",
        "missing-key",
        "explore.wanted_um",
        &["> 0", "micrometres"],
    ),
    case(
        "[output]",
        "[explore]\nwanted_um = 0\nclocks = [{ clock_hz = 1e6, cost = 1 }]\n[output]",
        "invalid-number",
        "explore.wanted_um",
        &["> 0"],
    ),
    case(
        "[output]",
        "[explore]\nwanted_um = 0.5\nclocks = [{ clock_hz = 1e6, cost = -1 }]\n[output]",
        "invalid-number",
        "explore.clocks[0].cost",
        &[">= 0"],
    ),
    case(
        "[output]",
        "[explore]\nwanted_um = 0.5\nencoders = []\n[output]",
        "invalid-list",
        "explore.encoders",
        &["1 to 50"],
    ),
    case(
        "[output]",
        "[explore]\nwanted_um = 0.5\ninterpolations = [{ pulses_per_interval = 1, cost = 0 }]\n[output]",
        "invalid-number",
        "explore.interpolations[0].pulses_per_interval",
        &[">= 2"],
    ),
    case("[output]", "[errors]\n[output]", "missing-key", "errors.scale", &["scale, ball_screw, encoder"]),
    case(
        "[output]",
        "[errors]\nscale = { slope_um_per_m = 20000.0 }\n[output]",
        "invalid-number",
        "errors.scale.slope_um_per_m",
        &["<= 10000", "micrometres a metre"],
    ),
    case(
        "[output]",
        "[errors]\nscale = { periodic = [{ amplitude_um = 0.0, period_mm = 20.0 }] }\n[output]",
        "invalid-number",
        "errors.scale.periodic[0].amplitude_um",
        &["> 0"],
    ),
    case(
        "[output]",
        "[errors]\nscale = { periodic = [{ amplitude_um = 1.0, period_mm = 0.0 }] }\n[output]",
        "invalid-number",
        "errors.scale.periodic[0].period_mm",
        &["> 0"],
    ),
    case(
        "[output]",
        "[errors]\nscale = { periodic = [{ amplitude_um = 1.0, period_mm = 1.0, phase_deg = 361.0 }] }\n[output]",
        "invalid-number",
        "errors.scale.periodic[0].phase_deg",
        &["<= 360"],
    ),
    case(
        "[output]",
        "[errors]\nscale = { slope_um_per_m = 1.0 }\nball_screw = { lead_mm = 10.0 }\n[output]",
        "invalid-job",
        "errors.ball_screw",
        &["not from both"],
    ),
    case(
        "[output]",
        "[errors]\nball_screw = { lead_mm = 0.0 }\n[output]",
        "invalid-number",
        "errors.ball_screw.lead_mm",
        &["> 0"],
    ),
    case(
        "[output]",
        "[errors]\nball_screw = { lead_mm = 10.0, travel_um_per_300mm = 4000.0 }\n[output]",
        "invalid-number",
        "errors.ball_screw.travel_um_per_300mm",
        &["<= 3000", "class 3"],
    ),
    case(
        "[output]",
        "[errors]\nball_screw = { lead_mm = 10.0, wobble_um = -1.0 }\n[output]",
        "invalid-number",
        "errors.ball_screw.wobble_um",
        &[">= 0"],
    ),
    case(
        "[output]",
        "[errors]\nball_screw = { lead_mm = 10.0, wobble_phase_deg = 400.0 }\n[output]",
        "invalid-number",
        "errors.ball_screw.wobble_phase_deg",
        &["<= 360"],
    ),
    case(
        "[output]",
        "[errors]\nball_screw = { lead_mm = 10.0, backlash_um = -1.0 }\n[output]",
        "invalid-number",
        "errors.ball_screw.backlash_um",
        &[">= 0", "preloaded"],
    ),
    case(
        "[output]",
        "[errors]\nencoder = { eccentricity_um = 1.0 }\n[output]",
        "missing-key",
        "errors.encoder.radius_mm",
        &["radius"],
    ),
    case(
        "[output]",
        "[errors]\nencoder = { radius_mm = 0.0 }\n[output]",
        "invalid-number",
        "errors.encoder.radius_mm",
        &["> 0"],
    ),
    case(
        "[output]",
        "[errors]\nencoder = { radius_mm = 50.0, eccentricity_um = -1.0 }\n[output]",
        "invalid-number",
        "errors.encoder.eccentricity_um",
        &[">= 0", "dial gauge"],
    ),
    case(
        "[output]",
        "[errors]\nencoder = { radius_mm = 50.0, eccentricity_phase_deg = 400.0 }\n[output]",
        "invalid-number",
        "errors.encoder.eccentricity_phase_deg",
        &["<= 360"],
    ),
    case(
        "[output]",
        "[errors]\nencoder = { radius_mm = 50.0, periodic = [{ order = 0, amplitude_arcsec = 1.0 }] }\n[output]",
        "invalid-number",
        "errors.encoder.periodic[0].order",
        &[">= 1"],
    ),
    case(
        "[output]",
        "[errors]\nencoder = { radius_mm = 50.0, periodic = [{ order = 1, amplitude_arcsec = 0.0 }] }\n[output]",
        "invalid-number",
        "errors.encoder.periodic[0].amplitude_arcsec",
        &["> 0"],
    ),
    case(
        "[output]",
        "[errors]\nencoder = { radius_mm = 50.0, periodic = [{ order = 1, amplitude_arcsec = 1.0, phase_deg = -400.0 }] }\n[output]",
        "invalid-number",
        "errors.encoder.periodic[0].phase_deg",
        &[">= -360"],
    ),
    case("[output]", "[correction]\n[output]", "missing-key", "correction.curves", &["curves"]),
    case(
        "[output]",
        "[correction]\ncurves = []\n[output]",
        "invalid-list",
        "correction.curves",
        &["1 to 20"],
    ),
    case(
        "[output]",
        "[correction]\ncurves = [{ kind = \"polynom\", coefficients_um = [1.0] }]\n[output]",
        "unknown-value",
        "correction.curves[0].kind",
        &["polynomial"],
    ),
    case(
        "[output]",
        "[correction]\ncurves = [{ kind = \"polynomial\", coefficients_um = [] }]\n[output]",
        "invalid-list",
        "correction.curves[0].coefficients_um",
        &["1 to 8"],
    ),
    case(
        "[output]",
        "[correction]\ncurves = [{ kind = \"polynomial\", coefficients_um = [nan] }]\n[output]",
        "invalid-number",
        "correction.curves[0].coefficients_um[0]",
        &["micrometres"],
    ),
    case(
        "[output]",
        "[correction]\ncurves = [{ kind = \"table\", axis = \"z\", spacing = 1.0, values_um = [0.0, 1.0] }]\n[output]",
        "unknown-value",
        "correction.curves[0].axis",
        &["feed", "worm"],
    ),
    case(
        "[output]",
        "[correction]\ncurves = [{ kind = \"table\", axis = \"feed\", start = 2e6, spacing = 1.0, values_um = [0.0, 1.0] }]\n[output]",
        "invalid-number",
        "correction.curves[0].start",
        &["<= 1000000"],
    ),
    case(
        "[output]",
        "[correction]\ncurves = [{ kind = \"table\", axis = \"feed\", spacing = 0.0, values_um = [0.0, 1.0] }]\n[output]",
        "invalid-number",
        "correction.curves[0].spacing",
        &["> 0"],
    ),
    case(
        "[output]",
        "[correction]\ncurves = [{ kind = \"table\", axis = \"feed\", spacing = 1.0, values_um = [0.0] }]\n[output]",
        "invalid-list",
        "correction.curves[0].values_um",
        &["2 to 10000"],
    ),
    case(
        "[output]",
        "[correction]\ncurves = [{ kind = \"table\", axis = \"feed\", spacing = 1.0, values_um = [0.0, 1e6] }]\n[output]",
        "invalid-number",
        "correction.curves[0].values_um[1]",
        &["micrometres at the flank"],
    ),
    case(
        "[output]",
        "[correction]\ncurves = [{ kind = \"table\", axis = \"feed\", spacing = 1.0, values_um = [0.0, 1.0], ends = \"open\" }]\n[output]",
        "unknown-value",
        "correction.curves[0].ends",
        &["natural", "periodic"],
    ),
    case(
        "[output]",
        "[correction]\ncurves = [{ kind = \"table\", axis = \"worm\", spacing = 1.0, values_um = [0.0, 1.0], ends = \"natural\" }]\n[output]",
        "invalid-job",
        "correction.curves[0].ends",
        &["without end", "periodic"],
    ),
    case(
        "[output]",
        "[correction]\ncurves = [{ kind = \"table\", axis = \"worm\", spacing = 1.0, values_um = [0.0, 1.0], ends = \"periodic\" }]\n[output]",
        "invalid-job",
        "correction.curves[0].values_um[1]",
        &["first value"],
    ),
    case(
        "[output]",
        "[split]\nvolts_per_pulse = 0.0\n[output]",
        "invalid-number",
        "split.volts_per_pulse",
        &["> 0"],
    ),
    case(
        "[output]",
        "[split]\nvolts_per_pulse = 10.0\nbits = 25\n[output]",
        "invalid-number",
        "split.bits",
        &["<= 24"],
    ),
    case(
        "[output]",
        "[split]\nvolts_per_pulse = 10.0\noffset_mv = 1e5\n[output]",
        "invalid-number",
        "split.offset_mv",
        &["<= 10000"],
    ),
    case(
        "[output]",
        "[split]\nvolts_per_pulse = 10.0\ngain_error_percent = 60.0\n[output]",
        "invalid-number",
        "split.gain_error_percent",
        &["<= 50"],
    ),
    case(
        "[output]",
        "[engagement]\nphase_speed_deg_per_s = 0.0\nacceleration_deg_per_s2 = 3600.0\n[output]",
        "invalid-number",
        "engagement.phase_speed_deg_per_s",
        &["> 0"],
    ),
    case(
        "[output]",
        "[engagement]\nphase_speed_deg_per_s = 90.0\nacceleration_deg_per_s2 = 0.0\n[output]",
        "invalid-number",
        "engagement.acceleration_deg_per_s2",
        &["> 0"],
    ),
    case(
        "[output]",
        "[engagement]\nphase_speed_deg_per_s = 90.0\nacceleration_deg_per_s2 = 3600.0\ngap_deg = 400.0\n[output]",
        "invalid-number",
        "engagement.gap_deg",
        &["<= 360"],
    ),
    case(
        "[output]",
        "[engagement]\nphase_speed_deg_per_s = 90.0\nacceleration_deg_per_s2 = 3600.0\ncycle_us = 0.5\n[output]",
        "invalid-number",
        "engagement.cycle_us",
        &[">= 1"],
    ),
    case(
        "[output]",
        "[engagement]\nphase_speed_deg_per_s = 90.0\nacceleration_deg_per_s2 = 3600.0\ncounter_bits = 1\n[output]",
        "invalid-number",
        "engagement.counter_bits",
        &[">= 2"],
    ),
    case(
        "[output]",
        "[engagement]\nphase_speed_deg_per_s = 90.0\nacceleration_deg_per_s2 = 3600.0\ncounter_bits = 8\n[output]",
        "invalid-job",
        "engagement.counter_bits",
        &["204.8 counts a cycle", "9 to 63", "wider counter"],
    ),
    case("[output]", "[compare]\n[output]", "missing-key", "compare.pll", &["pll, amplitude"]),
    case(
        "[output]",
        "[compare]\npll = { bandwidth_hz = 0.0 }\n[output]",
        "invalid-number",
        "compare.pll.bandwidth_hz",
        &[">= 0.01"],
    ),
    case(
        "[output]",
        "[compare]\npll = { bandwidth_hz = 50.0, damping = 0.0 }\n[output]",
        "invalid-number",
        "compare.pll.damping",
        &[">= 0.05"],
    ),
    case(
        "[output]",
        "[compare]\namplitude = { offset_percent = 60.0 }\n[output]",
        "invalid-number",
        "compare.amplitude.offset_percent",
        &["<= 50"],
    ),
    case(
        "[output]",
        "[compare]\namplitude = { mismatch_percent = 60.0 }\n[output]",
        "invalid-number",
        "compare.amplitude.mismatch_percent",
        &["<= 50"],
    ),
    case(
        "[output]",
        "[compare]\namplitude = { phase_error_deg = 30.0 }\n[output]",
        "invalid-number",
        "compare.amplitude.phase_error_deg",
        &["<= 25"],
    ),
    case(
        "[output]",
        "[compare]\namplitude = { delay_us = -1.0 }\n[output]",
        "invalid-number",
        "compare.amplitude.delay_us",
        &[">= 0"],
    ),
    case(
        "[output]",
        "[output]\nsplit_trace = true",
        "invalid-job",
        "output.split_trace",
        &["no voltage to trace", "volts_per_pulse"],
    ),
    case("[output]", "[output]\nsplit_trace = 1", "wrong-type", "output.split_trace", &["true or false"]),
];

/// Changes to the template of the electronic gearbox with a train of reference pulses in place of its motion.
const TRAIN_CASES: &[Case] = &[
    case(
        "[output]",
        "[errors]\nscale = { slope_um_per_m = 1.0 }\n[output]",
        "invalid-job",
        "errors.scale",
        &["train of pulses", "motion"],
    ),
    case(
        "[output]",
        "[compare]\npll = { bandwidth_hz = 50.0 }\n[output]",
        "invalid-job",
        "compare",
        &["train of pulses", "motion"],
    ),
    case(
        "reference_ticks = [100, 260, 420]\nreference_signs = [1, 1, -1]",
        "",
        "missing-key",
        "stimulus.motion",
        &["exactly one of", "references"],
    ),
    case(
        "reference_ticks = [100, 260, 420]\nreference_signs = [1, 1, -1]",
        "motion = [{ dwell_s = 1.0 }]",
        "invalid-job",
        "stimulus.motion",
        &["goes nowhere", "add a travel"],
    ),
    case(
        "reference_ticks = [100, 260, 420]\nreference_signs = [1, 1, -1]",
        "motion = []",
        "invalid-list",
        "stimulus.motion",
        &["1 to 1000 entries"],
    ),
    case("[stimulus]", "[stimulus]\nstart = 1.0", "invalid-job", "stimulus.start", &["motion"]),
    case("[stimulus]", "[stimulus]\nrest_s = 1.0", "invalid-job", "stimulus.rest_s", &["last_tick"]),
    case(
        "[stimulus]",
        "[stimulus]\nlast_tick = 419",
        "invalid-job",
        "stimulus.last_tick",
        &[">= 420", "later tick"],
    ),
    case(
        "[stimulus]",
        "[stimulus]\nlast_tick = 86400000001",
        "invalid-job",
        "stimulus.last_tick",
        &["longer than a day"],
    ),
    case(
        "[output]",
        "[explore]\nwanted_um = 0.5\nclocks = [{ clock_hz = 1e6, cost = 1 }]\nspeed_mm_per_min = 300.0\n[output]",
        "missing-key",
        "explore.acceleration_mm_per_s2",
        &["no motion"],
    ),
    case(
        "[output]",
        "[explore]\nwanted_um = 0.5\nclocks = [{ clock_hz = 1e6, cost = 1 }]\n[output]",
        "missing-key",
        "explore.speed_mm_per_min",
        &["e.g. speed_mm_per_min"],
    ),
];

/// Changes to a job of either grinding process with a sound table [control].
const CONTROL_CASES: &[Case] = &[
    case(
        "feed_per_revolution = 0.3\n",
        "",
        "missing-key",
        "grinding.feed_per_revolution",
        &["when each place is ground", "e.g. 0.3", "[control]"],
    ),
    case("worm = {", "worms = {", "unknown-key", "control.worms", &["did you mean `worm`"]),
    case(
        "worm = { pulses_per_revolution = 4096 }\n",
        "",
        "missing-key",
        "control.worm",
        &["pulses_per_revolution"],
    ),
    case("feed = { pulses_per_metre = 100000 }\n", "", "missing-key", "control.feed", &["pulses_per_metre"]),
    case(
        "servo = {",
        "servo = { gains = { proportional_n_m_per_rad = 1, integral_n_m_per_rad_s = 0, derivative_n_m_s_per_rad = 0 }, ",
        "invalid-job",
        "control.servo.gains",
        &["exactly one of"],
    ),
    case(", bandwidth_hz = 40.0", "", "missing-key", "control.servo.bandwidth_hz", &["exactly one of"]),
    case(
        "bandwidth_hz = 40.0",
        "bandwidth_hz = 40.0, disturbances = [{ kind = \"pulses\", torque_n_m = 1, axis = \"worm\", per_revolution = 2, width_deg = 180 }]",
        "invalid-job",
        "control.servo.disturbances[0].width_deg",
        &["180", "< 180"],
    ),
    case(
        "worm = {",
        "worm_speed_rpm = 0\nworm = {",
        "invalid-number",
        "control.worm_speed_rpm",
        &["> 0", "1/min"],
    ),
    case(
        "worm = {",
        "shift = { pulses_per_metre = -1 }\nworm = {",
        "invalid-number",
        "control.shift.pulses_per_metre",
        &["> 0"],
    ),
    case(
        "pulses_per_metre = 100000 }",
        "pulses_per_metre = 100000, pulses_per_interval = 1 }",
        "invalid-number",
        "control.feed.pulses_per_interval",
        &[">= 2"],
    ),
    case(
        "pulses_per_revolution = 36000",
        "pulses_per_revolution = 0",
        "invalid-number",
        "control.workpiece.pulses_per_revolution",
        &[">= 1"],
    ),
];

/// The example without its comments, so that changes meet entries.
fn job() -> String {
    without_comments(&example("twist-free-crowning.toml"))
}

/// The template of tangential dressing without its comments and empty lines.
fn tangential_job() -> String {
    let text = without_comments(job_template("tangential-dressing").expect("a template"));
    text.lines().filter(|line| !line.is_empty()).map(|line| line.to_owned() + "\n").collect()
}

/// The template of the electronic gearbox without its comments and empty lines.
fn gearbox_job() -> String {
    let text = without_comments(job_template("electronic-gearbox").expect("a template"));
    text.lines().filter(|line| !line.is_empty()).map(|line| line.to_owned() + "\n").collect()
}

/// The same with a train of reference pulses in place of its motion.
fn train_job() -> String {
    let job = gearbox_job();
    let (begin, end) = (job.find("motion = [").unwrap(), job.find("[servo]").unwrap());
    let train = "reference_ticks = [100, 260, 420]\nreference_signs = [1, 1, -1]\n";
    format!("{}{train}{}", &job[..begin], &job[end..])
}

/// The example with a sound table [control].
fn control_job() -> String {
    with_control(&job())
}

/// The template of tangential dressing with the same one.
fn tangential_control_job() -> String {
    let job = tangential_job();
    let feed = "[grinding]\nfeed_per_revolution = 0.3\n";
    assert!(job.contains("[grinding]\n"));
    with_control(&job.replacen("[grinding]\n", feed, 1))
}

fn with_control(job: &str) -> String {
    let control = "[control]\nfeed = { pulses_per_metre = 100000 }\nworkpiece = { pulses_per_revolution = 36000 }\n\
        worm = { pulses_per_revolution = 4096 }\n\
        servo = { inertia_kg_m2 = 0.12, torque_limit_n_m = 60.0, bandwidth_hz = 40.0 }\n[grid]";
    job.replacen("[grid]", control, 1)
}

fn without_comments(text: &str) -> String {
    text.lines().map(|line| line.split('#').next().unwrap_or(line).trim_end().to_owned() + "\n").collect()
}

#[test]
fn every_case_is_told_in_full() {
    told_in_full(&job(), CASES);
}

#[test]
fn every_case_of_tangential_dressing_is_told_in_full() {
    told_in_full(&tangential_job(), TANGENTIAL_CASES);
}

#[test]
fn every_case_of_the_electronic_gearbox_is_told_in_full() {
    told_in_full(&gearbox_job(), GEARBOX_CASES);
    told_in_full(&train_job(), TRAIN_CASES);
    told_in_full(&control_job(), CONTROL_CASES);
    told_in_full(&tangential_control_job(), CONTROL_CASES);
}

#[test]
fn jobs_with_trains_and_control_are_sound() {
    for text in [gearbox_job(), train_job(), control_job(), tangential_control_job()] {
        let (human, machine) = check("job.toml", text.as_bytes());
        assert_eq!((human.exit, machine.exit), (Some(0), Some(0)), "{}", human.stderr);
    }
}

fn told_in_full(job: &str, cases: &[Case]) {
    for case in cases {
        assert!(job.contains(case.from), "the job has no `{}`", case.from);
        let text = job.replacen(case.from, case.to, 1);
        let (human, machine) = check("bad.toml", text.as_bytes());
        let about = format!("{} -> {}\n{}\n{}", case.from, case.to, human.stderr, machine.stdout);
        assert_eq!((human.exit, machine.exit), (Some(2), Some(2)), "{about}");
        assert_eq!(human.stdout, "", "{about}");
        assert_eq!(machine.stderr, "", "{about}");

        let answer = machine.json();
        let errors = answer["errors"].as_array().unwrap();
        assert_eq!(answer["error"], errors[0], "{about}");
        let found = errors.iter().find(|e| e["code"] == case.code && e["field"] == case.field);
        let error = found.unwrap_or_else(|| panic!("no {} of {}: {about}", case.code, case.field));
        assert!(error["file"].as_str().unwrap().ends_with("bad.toml"), "{about}");
        for part in ["message", "allowed", "way_out"] {
            assert!(error[part].as_str().is_some_and(|t| !t.is_empty()), "{part}: {about}");
        }
        assert!(case.code == "missing-key" || error["value"].is_string(), "{about}");
        let line = error["line"].as_u64().unwrap_or_else(|| panic!("no line: {about}"));
        let column = error["column"].as_u64().unwrap();

        let message = human.message();
        let place = format!("bad.toml:{line}:{column}");
        for said in case.says.iter().copied().chain([case.code, case.field, place.as_str()]) {
            assert!(message.contains(said), "`{said}` is not said: {about}");
        }
        // The place is that of the changed entry, or of the table that lacks a key.
        if case.code != "missing-key" {
            let at = text.lines().nth(line as usize - 1).unwrap();
            let key = case.field.rsplit('.').next().unwrap().split('[').next().unwrap();
            assert!(at.contains(key), "line {line} `{at}` has no `{key}`: {about}");
        }
    }
}

#[test]
fn a_spur_gear_has_no_neutral_shift_ratio() {
    let text = tangential_job().replace("-35.0", "0.0").replace("= 1.202605", "= \"neutral\"");
    let (human, machine) = check("bad.toml", text.as_bytes());
    assert_eq!((human.exit, machine.exit), (Some(2), Some(2)));
    let error = &machine.json()["error"];
    assert_eq!(
        (&error["code"], &error["field"]),
        (&"invalid-job".into(), &"grinding.shift_ratio".into()),
        "{error}"
    );
}

#[test]
fn all_findings_are_told_at_once() {
    let text =
        job().replace("teeth", "tooth").replace("threads", "thread").replace("width = 100.0", "width = nan");
    let (human, machine) = check("bad.toml", text.as_bytes());
    let fields: Vec<Value> =
        machine.json()["errors"].as_array().unwrap().iter().map(|e| e["field"].clone()).collect();
    for field in ["gear.tooth", "gear.teeth", "worm.thread", "worm.threads", "worm.width"] {
        assert!(fields.iter().any(|f| f == field), "{field}: {fields:?}");
        assert!(human.message().contains(field), "{field}: {}", human.stderr);
    }
}

#[test]
fn missing_tables_are_named() {
    for name in ["empty.toml", "empty.json"] {
        let text = if name.ends_with("toml") { "" } else { "{}" };
        let (human, machine) = check(name, text.as_bytes());
        assert_eq!(human.exit, Some(2));
        for table in ["[job]", "[gear]", "[target]", "[worm]", "[grinding]"] {
            assert!(human.message().contains(table), "{table}: {}", human.stderr);
        }
        assert!(human.message().contains(name));
        assert_eq!(machine.json()["error"]["code"], "missing-key");
    }
}

/// The example without its tables [dresser] and [dressing].
fn without_dresser() -> String {
    let job = job();
    let (begin, end) = (job.find("[dresser]").unwrap(), job.find("[grinding]").unwrap());
    format!("{}{}", &job[..begin], &job[end..])
}

#[test]
fn a_dressed_tool_needs_its_dresser_and_others_have_none() {
    let (human, machine) = check("bad.toml", without_dresser().as_bytes());
    assert_eq!((human.exit, machine.exit), (Some(2), Some(2)));
    let error = &machine.json()["error"];
    assert_eq!((&error["code"], &error["field"]), (&"missing-key".into(), &"dresser".into()), "{error}");
    assert!(human.message().contains("[dresser]") && human.message().contains("worm.tool"));

    // Without both tables the job of a made or given tool is sound.
    let tools = [
        "tool = \"made\"\ndirection_deg = { left = 80.0, right = -80.0 }",
        "tool = \"given\"\nmodifications = [{ kind = \"polynomial\", terms = [[2, 0, -0.05]], flank = \"left\" }]",
    ];
    for tool in tools {
        let text = without_dresser().replace("threads = 3", &format!("threads = 3\n{tool}"));
        let (human, _) = check("tool.toml", text.as_bytes());
        assert_eq!(human.exit, Some(0), "{human:?}");

        let dressing = text.replace("[grinding]", "[dressing]\nflanks = \"two\"\n[grinding]");
        let (_, machine) = check("tool.toml", dressing.as_bytes());
        let error = &machine.json()["error"];
        assert_eq!((&error["code"], &error["field"]), (&"invalid-job".into(), &"dressing".into()), "{error}");
    }
}

#[test]
fn malformed_texts_name_file_line_and_column() {
    let cases: &[(&str, &[u8], &str, &str)] = &[
        ("a.toml", b"[gear]\nteeth = = 3", "invalid-toml", "a.toml:2:"),
        ("a.toml", b"[gear]\nteeth = 3\nteeth = 4\n", "duplicate-key", "a.toml:3:"),
        ("a.toml", b"[gear]\n[gear]\n", "duplicate-key", "a.toml:2:"),
        ("a.toml", b"[gear]\nname = \"open\n", "invalid-toml", "a.toml:2:"),
        ("a.json", b"{\"gear\": {\"teeth\": 3\n \"x\": 1}}", "invalid-json", "a.json:1:21"),
        ("a.json", b"{\"gear\": 1,\n\"gear\": 2}", "duplicate-key", "a.json:2:"),
        ("a.json", b"{\"gear\":\n{\"teeth\": NaN}}", "invalid-json", "a.json:2:"),
        ("a.json", b"", "invalid-json", "a.json:1:1"),
        ("a.json", b"[1, 2]", "wrong-type", "a.json:1:1"),
        ("a.json", b"{\"worm\": null}", "wrong-type", "a.json:1:10"),
        ("a.toml", b"\x7fELF\x02\x01\x01\xff\xfe\x00", "invalid-text", "line 1"),
        ("a.toml", b"a = 1\nb = \"\x00\"\n", "invalid-text", "line 2"),
        ("a.toml", b"\xff\xfea\x00", "invalid-text", "line 1"),
    ];
    for (name, bytes, code, place) in cases {
        let (human, machine) = check(name, bytes);
        assert_eq!((human.exit, machine.exit), (Some(2), Some(2)), "{}", human.stderr);
        let answer = machine.json();
        assert!(answer["errors"].as_array().unwrap().iter().any(|e| e["code"] == *code), "{code}: {answer}");
        assert!(human.message().contains(place), "{place}: {}", human.stderr);
    }
}

#[test]
fn nesting_without_end_is_refused() {
    let brackets = "[".repeat(1_000_000);
    let objects = "{\"a\":".repeat(500_000);
    let tables = "a = {a = ".repeat(100_000);
    let keys = format!("a{} = 1", ".a".repeat(200_000));
    let texts = [
        ("a.toml", format!("a = {brackets}")),
        ("a.json", brackets),
        ("a.json", objects),
        ("a.toml", tables),
        ("a.toml", keys),
    ];
    for (name, text) in texts {
        let (human, machine) = check(name, text.as_bytes());
        assert_eq!(
            (human.exit, machine.exit),
            (Some(2), Some(2)),
            "{}",
            &human.stderr[..human.stderr.len().min(500)]
        );
        assert!(human.stderr.len() < 5000, "{} bytes of message", human.stderr.len());
    }
}

#[test]
fn large_files_are_refused_quickly() {
    let mut line = b"x = 1.0 # a file of ten megabytes\n".repeat(300_000);
    line.truncate(10_000_000);
    for bytes in [line, vec![b'['; 10_000_000], vec![0; 10_000_000]] {
        let begun = Instant::now();
        let (human, machine) = check("large.toml", &bytes);
        assert!(begun.elapsed() < Duration::from_secs(5), "{:?}", begun.elapsed());
        assert_eq!((human.exit, machine.exit), (Some(2), Some(2)));
        assert!(human.message().contains("4 MiB"), "{}", human.stderr);
        assert_eq!(machine.json()["error"]["code"], "file-too-large");
    }
}

#[test]
fn many_findings_stay_readable() {
    let text: String = (0..50_000).map(|i| format!("unknown{i} = nan\n")).collect();
    let begun = Instant::now();
    let (human, machine) = check("many.toml", text.as_bytes());
    assert!(begun.elapsed() < Duration::from_secs(20), "{:?}", begun.elapsed());
    assert_eq!((human.exit, machine.exit), (Some(2), Some(2)));
    assert_eq!(machine.json()["errors"].as_array().unwrap().len(), 100);
    assert!(human.stderr.len() < 20_000);
    assert!(human.message().contains("more"));
}

#[test]
fn files_that_are_none() {
    for (path, says) in [("no/such/job.toml", "does not exist"), ("examples", "is a directory")] {
        let (human, machine) = (run(&["check", path]), run(&["check", "--json", path]));
        assert_eq!((human.exit, machine.exit), (Some(2), Some(2)));
        assert!(human.message().contains(says), "{}", human.stderr);
        assert_eq!(machine.json()["error"]["code"], "unreadable-file");
        assert_eq!(machine.json()["error"]["file"], path);
    }
}

#[test]
fn a_wrong_command_line_is_bad_input() {
    for arguments in [&["check"][..], &["nonsense"], &["new", "nonsense"], &["check", "--nonsense", "x"]] {
        let human = run(arguments);
        assert_eq!(human.exit, Some(2), "{human:?}");
        assert!(human.stderr.contains("Usage") || human.stderr.contains("--help"), "{human:?}");
        let machine = run(&[arguments, &["--json"]].concat());
        assert_eq!(machine.exit, Some(2));
        assert_eq!(machine.json()["error"]["code"], "usage");
    }
}

#[test]
fn marks_and_line_ends_do_no_harm() {
    let text = job();
    let marked = [b"\xef\xbb\xbf", text.as_bytes()].concat();
    let dos = text.replace('\n', "\r\n");
    for bytes in [marked.as_slice(), dos.as_bytes()] {
        let (human, machine) = check("job.toml", bytes);
        assert_eq!((human.exit, machine.exit), (Some(0), Some(0)), "{}", human.stderr);
        let plain = run_with(&["check", "--json", "-"], text.as_bytes());
        assert_eq!(machine.json()["job"], plain.json()["job"]);
    }
    let (wrong, _) = check("job.toml", dos.replace("teeth = 19", "teeth = 0").as_bytes());
    assert!(wrong.message().contains("job.toml:10:9"), "{}", wrong.stderr);
}

#[test]
fn empty_lists_are_no_error_where_they_mean_something() {
    let start = job();
    let list = start.find("modifications = [").unwrap();
    let end = list + start[list..].find("\n]").unwrap() + 2;
    let text = format!("{}modifications = []{}", &start[..list], &start[end..]);
    let text = text.replace("[\"linuxcnc\", \"siemens\", \"fanuc\"]", "[]").replace("[\"csv\"]", "[]");
    let (human, _) = check("job.toml", text.as_bytes());
    assert_eq!(human.exit, Some(0), "{}", human.stderr);
}
