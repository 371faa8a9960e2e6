//! 50-milling: flanks, columns, cutter locations, what stays between rows, roots, wear, machines and output of five-axis milling.
//!
//! The cases are a table of named flanks with their cutters; the other blocks refer to them by name.

mod bevel_cases;
mod blade_cases;
mod blade_limits;
mod body;
mod case;
mod cases;
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

pub(crate) use blade_limits::blade_limits;
pub(crate) use cases::cases;
pub(crate) use density::density;
pub(crate) use equal_scallop::equal_scallop;
pub(crate) use feed::{feed, screw_row};
pub(crate) use full_flank::full_flank;
pub(crate) use grid_surface::grid_surface;
pub(crate) use herringbone::herringbone;
pub(crate) use internal_cylinder::internal_cylinder;
pub(crate) use lead_radius::helical_zero_eps_lead_radius;
pub(crate) use octoid::octoid;
pub(crate) use orientation::{orientation_comparison, shear_scan};
pub(crate) use output::output;
pub(crate) use pole::pole;
pub(crate) use root::{root, tool_too_big};
pub(crate) use rotary::{inverse_kinematics, linear_axes};
pub(crate) use shift::shift_invariance;
pub(crate) use spur_stock::spur_exact_stock;
pub(crate) use wear::wear;
