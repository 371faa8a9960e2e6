//! What a person reads: charts drawn as SVG and the self-contained HTML report.
//!
//! The room turns finished numbers into pictures and pages. It must not know how a number came about: no
//! process, no contact, no removal, no workflow. [`charts`] draws, [`PlanReport`] is the page as data
//! (a banner and an ordered list of sections, the same for every process) and [`html`] writes it; the crate of each process
//! composes its pages from its results.
//!
//! ```
//! use report::{Banner, Block, FirstPage, Language, PlanReport, Section, TitleBlock, html};
//! use verdict::Status;
//!
//! let page = PlanReport {
//!     title: "housing <A>".into(),
//!     subtitle: None,
//!     language: Language::English,
//!     title_block: TitleBlock::of_process("Milling", "1.0"),
//!     banner: Banner { status: Status::Met.into(), headline: "within 1 um".into(), figures: vec![] },
//!     first_page: FirstPage::default(),
//!     sections: vec![Section::new("result", "Result", vec![Block::Paragraph("All is well.".into())])],
//! };
//! let text = html::render(&page);
//! assert!(text.contains("housing &lt;A&gt;"));
//! ```

pub mod charts;
pub mod html;

pub mod cells;
pub mod data;
pub mod first_page;
pub mod flank_pictures;
pub mod flank_stages;
pub mod head;
pub mod ids;
mod language;
mod page_head;
pub mod placed;
mod texts;
mod typeset;

pub use data::{
    Banner, Block, Column, ColumnKind, Fact, Figure, PlanReport, Quantity, QuantityValue, Section, Stamp,
    Table, Warning,
};
pub use first_page::{FirstPage, Sheet, TitleBlock};
pub use flank_stages::{
    DrawnFlanks, FlankPicture, FlankStages, first_picture, flank_diagram, flank_figures, flank_picture,
};
pub use head::ReportHead;
pub use ids::kebab;
pub use language::Language;
pub use page_head::PageHead;
pub use placed::{PlacedChart, charts_of_page};
pub use texts::{TextKind, texts};
pub use typeset::unit;
