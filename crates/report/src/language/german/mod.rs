//! German texts of pages, by what they are about. Terms are those of the glossary (DIN 3960, ISO 21771, ISO 1328) and of the web
//! application.

mod common;
mod errors;
mod explained;
mod first_page;
mod flanks;
mod gearbox;
mod grinding;
mod inspection;
mod milling;
mod programs;
mod remarks;
mod removal;
mod scope;
mod sheet;
mod skiving;
mod studies;
mod tangential;
mod verification;

/// English text and German text; `{}` stands for what is put in.
pub(super) type Text = (&'static str, &'static str);

/// All texts.
pub(super) const TEXTS: &[&[Text]] = &[
    first_page::TEXTS,
    scope::TEXTS,
    common::TEXTS,
    flanks::TEXTS,
    grinding::TEXTS,
    verification::TEXTS,
    removal::TEXTS,
    programs::TEXTS,
    milling::TEXTS,
    skiving::TEXTS,
    gearbox::TEXTS,
    tangential::TEXTS,
    inspection::TEXTS,
    studies::TEXTS,
    sheet::TEXTS,
    errors::TEXTS,
    remarks::TEXTS,
    explained::TEXTS,
];
