//! The schemas of reference files: how each is recognised from its content and which blocks it consists of.
//!
//! A new block gets its line in [`Schema::blocks`].

use super::ledger::Ledger;
use super::reference::Reference;
use super::{
    areas, contact, decompositions, dressing, equal_ratio, gearbox, gears, ground_flank,
    ground_modifications, inspection, least_squares, machines, milling, modifications, planning, skiving,
    tangential, technology, variable_ratio,
};
use serde::Serialize;
use serde_json::Value;

/// A schema of reference files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Schema {
    /// Involute geometry.
    #[serde(rename = "10-gears")]
    Gears,
    /// Contact of worm and workpiece.
    #[serde(rename = "20-generating-contact")]
    Contact,
    /// Flank modifications and their manufacture.
    #[serde(rename = "25-modifications")]
    Modifications,
    /// Machine chains.
    #[serde(rename = "26-machine-chains")]
    MachineChains,
    /// Planning.
    #[serde(rename = "28-planning")]
    Planning,
    /// Dressing.
    #[serde(rename = "30-dressing")]
    Dressing,
    /// Tangential dressing.
    #[serde(rename = "40-tdm")]
    TangentialDressing,
    /// Stock, removal, wear, time and cost of generating grinding.
    #[serde(rename = "45-grinding-technology")]
    GrindingTechnology,
    /// Five-axis milling.
    #[serde(rename = "50-milling")]
    Milling,
    /// Measuring of skiving tools.
    #[serde(rename = "60-skiving")]
    Skiving,
    /// Electronic gearbox.
    #[serde(rename = "70-gearbox")]
    Gearbox,
    /// Inspection.
    #[serde(rename = "85-inspection")]
    Inspection,
}

/// Computes the quantities of one block and compares.
type Check = fn(&Reference<'_>, &Value, &mut Ledger);

/// One top-level entry of a schema.
struct Block {
    key: &'static str,
    check: Check,
}

impl Block {
    const fn checked(key: &'static str, check: Check) -> Self {
        Self { key, check }
    }
}

/// Entries that describe a file and expect nothing.
const HEADERS: [&str; 13] = [
    "title",
    "topic",
    "about",
    "_about",
    "_conventions",
    "note",
    "spec",
    "set",
    "units",
    "tolerance",
    "gears_tolerance",
    "random",
    "schema",
];

impl Schema {
    const ALL: [Schema; 12] = [
        Self::Gears,
        Self::Contact,
        Self::Modifications,
        Self::MachineChains,
        Self::Planning,
        Self::Dressing,
        Self::TangentialDressing,
        Self::GrindingTechnology,
        Self::Milling,
        Self::Skiving,
        Self::Gearbox,
        Self::Inspection,
    ];

    /// Name of the schema as files are called.
    pub fn name(self) -> &'static str {
        match self {
            Self::Gears => "10-gears",
            Self::Contact => "20-generating-contact",
            Self::Modifications => "25-modifications",
            Self::MachineChains => "26-machine-chains",
            Self::Planning => "28-planning",
            Self::Dressing => "30-dressing",
            Self::TangentialDressing => "40-tdm",
            Self::GrindingTechnology => "45-grinding-technology",
            Self::Milling => "50-milling",
            Self::Skiving => "60-skiving",
            Self::Gearbox => "70-gearbox",
            Self::Inspection => "85-inspection",
        }
    }

    /// The blocks of the schema, in the order in which they are checked.
    fn blocks(self) -> &'static [Block] {
        match self {
            Self::Gears => {
                const { &[Block::checked("cases", gears::cases), Block::checked("errors", gears::errors)] }
            }
            Self::Contact => {
                const {
                    &[
                        Block::checked("cases", contact::cases),
                        Block::checked("equal_diagonal_ratio", equal_ratio::equal_diagonal_ratio),
                        Block::checked("ground_flank", ground_flank::block),
                        Block::checked("gears", gears::gears_block),
                    ]
                }
            }
            Self::Modifications => {
                const {
                    &[
                        Block::checked("gears", modifications::gears),
                        Block::checked("elementary", modifications::elementary),
                        Block::checked("decomposition_clpk", decompositions::decomposition_clpk),
                        Block::checked("radial_class", decompositions::radial_class),
                        Block::checked("mapping", modifications::mapping),
                        Block::checked("polynomial", ground_modifications::polynomial),
                        Block::checked("precompensation", ground_modifications::precompensation),
                        Block::checked("natural_twist", ground_modifications::natural_twist),
                        Block::checked("two_flank_motion", ground_modifications::two_flank_motion),
                        Block::checked("waviness", decompositions::waviness),
                        Block::checked("figure_29_31", decompositions::figure_29_31),
                        Block::checked("least_squares", least_squares::least_squares),
                        Block::checked("two_flanks", least_squares::two_flanks),
                        Block::checked("equal_swivel", areas::equal_swivel),
                        Block::checked("figure_25", variable_ratio::figure_25),
                        Block::checked("figure_26_28", variable_ratio::figure_26_28),
                        Block::checked("areas", areas::areas),
                        Block::checked("constant_ratio_lengths", modifications::constant_ratio_lengths),
                        Block::checked("left_out_threads", areas::left_out_threads),
                    ]
                }
            }
            Self::MachineChains => {
                const {
                    &[
                        Block::checked("machines", machines::machines),
                        Block::checked("forward", machines::forward),
                        Block::checked("inverse", machines::inverse),
                        Block::checked("stroke", machines::stroke),
                        Block::checked("gearbox", machines::gearbox),
                        Block::checked("influence", machines::influence),
                        Block::checked("errors", machines::errors),
                    ]
                }
            }
            Self::Planning => const { &[Block::checked("cases", planning::cases)] },
            Self::Dressing => const { &[Block::checked("cases", dressing::cases)] },
            Self::TangentialDressing => {
                const {
                    &[
                        Block::checked("input", tangential::input),
                        Block::checked("machine", tangential::machine),
                        Block::checked("grid", tangential::grid),
                        Block::checked("dresser_profile", tangential::dresser_profile),
                        Block::checked("left", tangential::left),
                        Block::checked("right", tangential::right),
                        Block::checked("undercut", tangential::undercut),
                        Block::checked("twist_conventional", tangential::twist_conventional),
                        Block::checked("examples", tangential::examples),
                        Block::checked("two_flank_same_motions", tangential::two_flank_same_motions),
                    ]
                }
            }
            Self::GrindingTechnology => const { &[Block::checked("cases", technology::cases)] },
            Self::Milling => {
                const {
                    &[
                        Block::checked("cases", milling::cases),
                        Block::checked("spur_exact_stock", milling::spur_exact_stock),
                        Block::checked("helical_zero_eps_lead_radius", milling::helical_zero_eps_lead_radius),
                        Block::checked("tool_too_big", milling::tool_too_big),
                        Block::checked("root", milling::root),
                        Block::checked("wear", milling::wear),
                        Block::checked("inverse_kinematics", milling::inverse_kinematics),
                        Block::checked("linear_axes", milling::linear_axes),
                        Block::checked("orientation_comparison", milling::orientation_comparison),
                        Block::checked("pole", milling::pole),
                        Block::checked("density", milling::density),
                        Block::checked("output", milling::output),
                        Block::checked("screw_row", milling::screw_row),
                        Block::checked("feed", milling::feed),
                        Block::checked("octoid", milling::octoid),
                        Block::checked("herringbone", milling::herringbone),
                        Block::checked("full_flank", milling::full_flank),
                        Block::checked("shift_invariance", milling::shift_invariance),
                        Block::checked("equal_scallop", milling::equal_scallop),
                        Block::checked("grid_surface", milling::grid_surface),
                        Block::checked("internal_cylinder", milling::internal_cylinder),
                        Block::checked("blade_limits", milling::blade_limits),
                        Block::checked("shear_scan", milling::shear_scan),
                    ]
                }
            }
            Self::Skiving => {
                const {
                    &[
                        Block::checked("random", skiving::random),
                        Block::checked("examples", skiving::examples),
                        Block::checked("measurement", skiving::measurement),
                        Block::checked("mounting_only", skiving::mounting_only),
                        Block::checked("conventional_axis_parallel_beam", skiving::conventional),
                        Block::checked("calibration", skiving::calibration),
                        Block::checked("scan_fixed_Y_vertical_stylus", skiving::scan),
                    ]
                }
            }
            Self::Gearbox => {
                const {
                    &[
                        Block::checked("pulse_trains", gearbox::pulse_trains),
                        Block::checked("chain", gearbox::chain),
                        Block::checked("rate_multiplier", gearbox::rate_multiplier),
                        Block::checked("coefficients", gearbox::coefficients),
                        Block::checked("error_budget", gearbox::error_budget),
                        Block::checked("literal_reversal_loss", gearbox::literal_reversal_loss),
                        Block::checked("gearbox", gearbox::gearbox),
                        Block::checked("bresenham", gearbox::bresenham),
                        Block::checked("ratio_of_lead", gearbox::ratio_of_lead),
                        Block::checked("couplings", gearbox::couplings),
                        Block::checked("table", gearbox::table),
                        Block::checked("synchroniser", gearbox::synchroniser),
                        Block::checked("servo", gearbox::servo),
                    ]
                }
            }
            Self::Inspection => {
                const {
                    &[
                        Block::checked("reader", inspection::reader),
                        Block::checked("real_parts", inspection::real_parts),
                        Block::checked("traces", inspection::traces),
                        Block::checked("trace_errors", inspection::trace_errors),
                        Block::checked("k_band", inspection::k_band),
                        Block::checked("pitch", inspection::pitch),
                        Block::checked("thickness", inspection::thickness),
                        Block::checked("eccentricity", inspection::eccentricity_and_run_out),
                        Block::checked("tolerances", inspection::tolerances),
                        Block::checked("tolerance_errors", inspection::tolerance_errors),
                        Block::checked("classes", inspection::classes),
                        Block::checked("areal", inspection::areal),
                        Block::checked("reconstruction", inspection::reconstruction),
                        Block::checked("twist_from_traces", inspection::twist_from_traces),
                        Block::checked("closed_loop", inspection::closed_loop),
                        Block::checked("axis_recovery", inspection::axis_recovery),
                        Block::checked("dressing_influence", inspection::dressing_influence),
                        Block::checked("trace_layouts", inspection::trace_layouts),
                        Block::checked("systematic_test", inspection::systematic_test),
                        Block::checked("series", inspection::series),
                        Block::checked("rexs", inspection::rexs),
                    ]
                }
            }
        }
    }

    /// The schema of a file's content: by the shape of its first case where it has a list of cases, else the schema
    /// that knows most of its top-level entries.
    pub fn recognise(root: &Value) -> Option<Schema> {
        let top = root.as_object()?;
        let first = |key: &str| top.get(key).and_then(Value::as_array).and_then(|list| list.first());
        if let Some(case) = first("cases").or_else(|| first("errors")) {
            let has = |key: &str| case["input"].get(key).is_some();
            if has("chain") {
                return Some(Self::Contact);
            } else if has("stock") && has("strokes") {
                return Some(Self::GrindingTechnology);
            } else if has("modifications") || has("worm_threads") {
                return Some(Self::Planning);
            } else if has("z_S") {
                return Some(Self::Dressing);
            } else if has("z") {
                return Some(Self::Gears);
            }
        }
        // `gears` is a list of cases in a contact file and a table of named gears in one of modifications.
        let fits = |schema: Schema, key: &str, value: &Value| match (key, schema) {
            ("cases", _) => false,
            ("gears", Self::Contact) => value.is_array(),
            ("gears", Self::Modifications) => value.is_object(),
            _ => schema.blocks().iter().any(|block| block.key == key),
        };
        let known = |schema: Schema| top.iter().filter(|(key, value)| fits(schema, key, value)).count();
        let best = Self::ALL.into_iter().max_by_key(|&schema| known(schema))?;
        let count = known(best);
        let rivals = Self::ALL.into_iter().filter(|&schema| known(schema) == count).count();
        (count > 0 && rivals == 1).then_some(best)
    }

    /// Checks every block of the file.
    pub(super) fn check(self, reference: &Reference<'_>, ledger: &mut Ledger) {
        let Some(top) = reference.root.as_object() else { return };
        for block in self.blocks() {
            let Some(value) = top.get(block.key) else { continue };
            (block.check)(reference, value, ledger);
        }
        for (key, value) in top {
            let known = HEADERS.contains(&key.as_str()) || self.blocks().iter().any(|b| b.key == key);
            if !known {
                ledger.fail(self.name(), &format!("unknown block {key}"), value.clone(), Value::Null);
            }
        }
    }
}

/// The keys of the top level, for messages.
pub(super) fn top_level_keys(root: &Value) -> String {
    match root.as_object() {
        Some(map) if map.is_empty() => "an empty object".into(),
        Some(map) => map.keys().take(8).cloned().collect::<Vec<_>>().join(", "),
        None => "no object".into(),
    }
}
