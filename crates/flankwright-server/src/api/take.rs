//! Extractors whose refusals have the same form as all others.

use axum::extract::{FromRequest, FromRequestParts};

use super::error::{Answer, Refused};
use crate::wire::{Failure, Finding};

/// A JSON body.
#[derive(FromRequest)]
#[from_request(via(axum::Json), rejection(Refused))]
pub struct Body<T>(pub T);

/// Parts of the path.
#[derive(FromRequestParts)]
#[from_request(via(axum::extract::Path), rejection(Refused))]
pub struct InPath<T>(pub T);

/// The query.
#[derive(FromRequestParts)]
#[from_request(via(axum::extract::Query), rejection(Refused))]
pub struct InQuery<T>(pub T);

/// A number of the query within its range, from 1.
pub fn bounded(field: &str, given: u32, most: u32) -> Answer<u32> {
    if (1..=most).contains(&given) {
        return Ok(given);
    }
    let message = format!("{field} = {given} is outside its range");
    let finding = Finding::new("invalid-number", message, "ask for fewer").field(field);
    Err(Refused::bad(Failure::single(finding.allowed(format!("1 to {most}")))))
}
