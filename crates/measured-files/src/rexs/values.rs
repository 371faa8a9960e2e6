//! Values of attributes in the units of this program: mm, degree, whole numbers, words.

use super::attributes::{self, Form};
use super::document::{Component, Value};
use super::error::RexsError;

/// What messages call a component.
pub(super) fn title(component: &Component) -> String {
    format!("component {} ({})", component.id, component.kind)
}

/// The factor from a unit to that of the form.
pub(super) fn factor(form: Form, unit: Option<&str>) -> Option<f64> {
    let unit = unit.unwrap_or("none").trim();
    match (form, unit) {
        (Form::Length | Form::Lengths, "mm") | (Form::Angle, "deg" | "\u{b0}") => Some(1.0),
        (Form::Length | Form::Lengths, "mum") => Some(1e-3),
        (Form::Micrometres, "mum") => Some(1.0),
        (Form::Micrometres, "mm") => Some(1e3),
        (Form::Angle, "rad") => Some(180.0 / std::f64::consts::PI),
        (Form::Plain | Form::Integer | Form::Boolean | Form::Word, "none" | "") => Some(1.0),
        _ => None,
    }
}

/// What is allowed as the unit of a form.
pub(super) fn units(form: Form) -> &'static str {
    match form {
        Form::Length | Form::Lengths | Form::Micrometres => "mm, mum",
        Form::Angle => "deg, rad",
        _ => "none",
    }
}

/// A component whose attributes are asked for.
pub(super) struct Asked<'a>(pub &'a Component);

impl Asked<'_> {
    fn value(&self, id: &str) -> Result<Option<(f64, &Value)>, RexsError> {
        let Some(attribute) = self.0.attribute(id) else { return Ok(None) };
        let form = attributes::form(&self.0.kind, id).unwrap_or(Form::Plain);
        let factor = factor(form, attribute.unit.as_deref()).ok_or_else(|| RexsError::UnknownUnit {
            component: title(self.0),
            attribute: id.into(),
            unit: attribute.unit.clone().unwrap_or_default().chars().take(40).collect(),
            allowed: units(form),
        })?;
        Ok(Some((factor, &attribute.value)))
    }

    fn bad(&self, id: &str, value: &Value, allowed: &'static str) -> RexsError {
        let value: String = format!("{value:?}").chars().take(60).collect();
        RexsError::BadValue { component: title(self.0), attribute: id.into(), value, allowed }
    }

    /// A number in mm, um, degree or without unit.
    pub fn optional(&self, id: &'static str) -> Result<Option<f64>, RexsError> {
        match self.value(id)? {
            None => Ok(None),
            Some((factor, Value::Number(value))) => Ok(Some(factor * value)),
            Some((factor, Value::Integer(value))) => Ok(Some(factor * *value as f64)),
            Some((_, other)) => Err(self.bad(id, other, "a number")),
        }
    }

    /// A number that must be there.
    pub fn number(&self, id: &'static str) -> Result<f64, RexsError> {
        self.optional(id)?
            .ok_or_else(|| RexsError::MissingAttribute { component: title(self.0), attribute: id })
    }

    /// A number of teeth.
    pub fn integer(&self, id: &'static str) -> Result<i32, RexsError> {
        let value = self.number(id)?;
        if value.fract() == 0.0 && value.abs() <= f64::from(i32::MAX) {
            return Ok(value as i32);
        }
        Err(self.bad(id, &Value::Number(value), "a whole number"))
    }

    /// A word.
    pub fn word(&self, id: &'static str) -> Result<Option<&str>, RexsError> {
        match self.value(id)? {
            None => Ok(None),
            Some((_, Value::Word(word))) => Ok(Some(word)),
            Some((_, other)) => Err(self.bad(id, other, "a word")),
        }
    }

    /// Yes or no.
    pub fn boolean(&self, id: &'static str) -> Result<Option<bool>, RexsError> {
        match self.value(id)? {
            None => Ok(None),
            Some((_, Value::Boolean(value))) => Ok(Some(*value)),
            Some((_, other)) => Err(self.bad(id, other, "true or false")),
        }
    }

    /// A list of numbers in mm.
    pub fn list(&self, id: &'static str) -> Result<Option<Vec<f64>>, RexsError> {
        match self.value(id)? {
            None => Ok(None),
            Some((factor, Value::Numbers(list))) => Ok(Some(list.iter().map(|v| factor * v).collect())),
            Some((_, other)) => Err(self.bad(id, other, "a list of numbers")),
        }
    }

    /// A list that must be there.
    pub fn needed_list(&self, id: &'static str) -> Result<Vec<f64>, RexsError> {
        self.list(id)?.ok_or_else(|| RexsError::MissingAttribute { component: title(self.0), attribute: id })
    }
}
