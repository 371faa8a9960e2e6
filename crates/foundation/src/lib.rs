//! The foundation of flankwright: mathematics, shapes, poses and motions, modifications of flanks. Knows no contact, no process,
//! no file but the words in which a modification is described.

pub mod numerics;

pub mod geometry;

pub mod modification;

pub mod kinematics;

pub mod inverse;
