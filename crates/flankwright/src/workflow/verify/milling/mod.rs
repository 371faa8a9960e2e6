//! 50-milling: flanks, columns, cutter locations, what stays between rows, roots, wear, machines and output of five-axis milling.
//!
//! The cases are a table of named flanks with their cutters; the other blocks refer to them by name.

mod bevel_cases;
mod blade_cases;
mod blade_limits;
mod case;
mod chain;
mod columns;
mod cutter;
mod cylinder_cases;
mod density;
mod equal_scallop;
mod feed;
mod flank;
mod full_flank;
mod grid_surface;
mod herringbone;
mod internal_cylinder;
mod lead_radius;
mod near_foot;
mod octoid;
mod orientation;
mod output;
mod pole;
mod referee;
mod residual;
mod root;
mod rotary;
mod row;
mod shift;
mod spur_stock;
mod swept_root;
mod wear;

pub(in super::super) use blade_limits::blade_limits;
pub(in super::super) use case::cases;
pub(in super::super) use density::density;
pub(in super::super) use equal_scallop::equal_scallop;
pub(in super::super) use feed::{feed, screw_row};
pub(in super::super) use full_flank::full_flank;
pub(in super::super) use grid_surface::grid_surface;
pub(in super::super) use herringbone::herringbone;
pub(in super::super) use internal_cylinder::internal_cylinder;
pub(in super::super) use lead_radius::helical_zero_eps_lead_radius;
pub(in super::super) use octoid::octoid;
pub(in super::super) use orientation::{orientation_comparison, shear_scan};
pub(in super::super) use output::output;
pub(in super::super) use pole::pole;
pub(in super::super) use root::{root, tool_too_big};
pub(in super::super) use rotary::{inverse_kinematics, linear_axes};
pub(in super::super) use shift::shift_invariance;
pub(in super::super) use spur_stock::spur_exact_stock;
pub(in super::super) use wear::wear;
