//! The closed loop of settings: what grinding and dressing change of a measured flank, and corrections by it.

mod correction;
mod dressing;
mod grinding;
mod second_order;
