//! Files in which measured gears come and go: curves and values of measuring machines, tables of traces, REXS. What is not understood is
//! said, never dropped.

pub mod inspection;

pub mod rexs;
