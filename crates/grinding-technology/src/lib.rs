//! What a process engineer asks of generating grinding beside the flank: what is ground off where and how fast, how long a worm lasts, what a
//! part takes and costs, and which cycle is the fastest within the shop's limits (`docs/mathematics/grinding-technology.md`).
//!
//! Cylindrical external workpieces and cylindrical worms. mm, rad, s; amounts normal to the flank. Knows no target, no dressing motion, no file.

mod bodies;
mod column;
mod cost;
mod cycle;
mod dressing;
mod error;
mod exact_gap;
mod hob;
mod level;
mod life;
mod optimum;
mod rates;
mod sampled;
mod stock;
mod stock_map;
mod stroke;
mod time;
mod volumes;
mod wear;

pub use bodies::{Bodies, Engagement, STATIONS};
pub use cost::{CostGoal, CostPerPart, Rates};
pub use cycle::{Cycle, FlankStroke, Sense, StrokeFigures};
pub use dressing::{DressingFigures, DressingTechnology, Rotation};
pub use error::TechnologyError;
pub use exact_gap::exact_gap;
pub use hob::hob_mark_height;
pub use level::{Level, ROUGHING, WidthUse, ZoneLimits};
pub use life::{Life, LifeRow, WormLife};
pub use optimum::{BestCycle, Optimum, OptimumRow, OptimumTask};
pub use stock::{HobMarks, RunOut, Stock, StockField, StockTerm};
pub use stock_map::StockMap;
pub use stroke::{Direction, Ground, Shift, ShiftRatios, Stroke};
pub use time::{Axes, Axis, DressingTime, PartTimes, StrokeTime};
pub use wear::{WearMap, WearTask};
