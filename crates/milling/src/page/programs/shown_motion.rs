//! A motion of the axes with the controls whose programs make it.

use crate::workflow::ProgramResult;
use crate::workflow::programs::{DrivenMotion, MillingProgram};
use std::sync::Arc;

/// A motion, the controls that make it, and what the result says of the first of them.
pub(super) struct ShownMotion<'a> {
    pub motion: &'a DrivenMotion,
    pub controls: String,
    pub result: &'a ProgramResult,
}

impl<'a> ShownMotion<'a> {
    /// The motions of all programs, each once.
    pub fn of_programs(programs: &'a [MillingProgram], results: &'a [ProgramResult]) -> Vec<Self> {
        let mut motions: Vec<(&Arc<DrivenMotion>, Self)> = Vec::new();
        for (program, result) in programs.iter().zip(results) {
            match motions.iter_mut().find(|(known, _)| Arc::ptr_eq(known, &program.motion)) {
                Some((_, shown)) => shown.controls = format!("{}, {}", shown.controls, result.control),
                None => {
                    let controls = result.control.to_owned();
                    motions.push((&program.motion, Self { motion: &program.motion, controls, result }));
                }
            }
        }
        motions.into_iter().map(|(_, shown)| shown).collect()
    }
}
