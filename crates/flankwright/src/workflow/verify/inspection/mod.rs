//! 85-inspection: readers, measured parts, REXS.

mod reader;
mod real_parts;
mod rexs;

pub(in super::super) use reader::reader;
pub(in super::super) use real_parts::real_parts;
pub(in super::super) use rexs::rexs;
