//! Contact against reference numbers, properties and bodies rolled step by step.

mod gear_root;
mod pairs;
mod parallel_pair;
mod properties;
mod rolled_pair;
