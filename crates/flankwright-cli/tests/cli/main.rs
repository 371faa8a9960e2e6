//! The command as its users meet it.

mod bad_input;
mod blanks;
mod catalogue;
mod command;
mod commands;
mod control;
mod documents;
mod every_key;
mod everyday;
mod examples;
mod explore;
mod gearbox;
mod inspection;
mod line_dressing;
mod milling;
mod milling_refusals;
mod planning;
mod programs;
mod robustness;
mod serve;
mod shifts;
mod skiving;
mod store;
mod strokes;
mod tangential;
mod trends;
