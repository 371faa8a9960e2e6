//! Round trips through every form and both datum faces, structures that are refused, damaged files.

mod damaged;
mod gear;
mod jobs;
mod reading;
mod round_trips;
mod structure;
mod thickness;
