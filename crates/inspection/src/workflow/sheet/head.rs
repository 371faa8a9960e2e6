//! The head: part, gear, how it was measured and how its values are counted.

use super::Filling;
use crate::page::sheet::SheetHead;
use foundation::geometry::{Flank, Sides};
use measured_files::inspection::{CountingDirection, Inspection, Section, TraceKind};
use metrology::inspection::SlopeSign;
use report::Fact;
use report::charts::{format_fixed, format_significant};
use std::path::Path;

/// What the sheet is of: the part, else its name, else its file.
pub(super) fn title(inspection: &Inspection) -> String {
    let file = inspection.sources.first().map(|path| file_name(path));
    [inspection.part.clone(), inspection.name.clone(), file].into_iter().flatten().next().unwrap_or_default()
}

fn file_name(path: &str) -> String {
    Path::new(path).file_name().map_or_else(|| path.to_owned(), |name| name.to_string_lossy().into_owned())
}

impl Filling<'_> {
    pub(super) fn head(&self) -> SheetHead {
        SheetHead { part: self.part(), gear: self.gear_data(), conditions: self.conditions() }
    }

    fn part(&self) -> Vec<Fact> {
        let of = self.inspection;
        let files: Vec<String> = of.sources.iter().map(|path| file_name(path)).collect();
        let files = (!files.is_empty()).then(|| files.join(", "));
        let not_stated = || "not stated".to_owned();
        let date = of.date.as_ref().map(|date| match &of.time {
            Some(time) => format!("{date}, {}", time.split_whitespace().collect::<Vec<_>>().join(" ")),
            None => date.clone(),
        });
        let stated =
            [("part", &of.part), ("drawing", &of.drawing), ("date", &date), ("machine", &of.machine)];
        let stated = stated.map(|(label, text)| Fact::new(label, text.clone().unwrap_or_else(not_stated)));
        let further = [("name", of.name.clone()), ("inspector", of.operator.clone()), ("files", files)];
        let further = further.into_iter().filter_map(|(label, text)| Some(Fact::new(label, text?)));
        stated.into_iter().chain(further).collect()
    }

    fn gear_data(&self) -> Vec<Fact> {
        let gear = &self.inspection.gear;
        let mm = |value: f64| format!("{} mm", format_significant(value, 7));
        let degrees = |value: f64| format!("{}°", format_significant(value, 7));
        let kind = if gear.teeth < 0 { "internal" } else { "external" };
        let hand = match gear.helix_angle_deg {
            0.0 => "",
            beta if beta > 0.0 => " right-handed",
            _ => " left-handed",
        };
        let mut facts = vec![
            Fact::new("teeth z", format!("{} {kind}", gear.teeth.unsigned_abs())),
            Fact::new("module mn", mm(gear.normal_module_mm)),
            Fact::new("pressure angle αn", degrees(gear.normal_pressure_angle_deg)),
            Fact::new("helix angle β", degrees(gear.helix_angle_deg.abs()) + hand),
        ];
        if let Some(x) = gear.profile_shift {
            facts.push(Fact::new("x of the file", format_significant(x, 5)));
        }
        let measured = [("span", self.gear.thickness.by_span), ("balls", self.gear.thickness.by_balls)];
        let (by, x): (Vec<&str>, Vec<String>) =
            measured.into_iter().filter_map(|(by, x)| Some((by, format_fixed(x?, 4)))).unzip();
        if !x.is_empty() {
            facts.push(Fact::new(format!("x by {}", by.join(" / ")), x.join(" / ")));
        }
        if let Some(width) = gear.face_width_mm {
            facts.push(Fact::new("face width b", mm(width)));
        }
        match (gear.tip_diameter_mm, gear.root_diameter_mm) {
            (Some(tip), Some(root)) => {
                let both = format!("{} / {}", format_significant(tip, 7), mm(root));
                facts.push(Fact::new("da / df", both));
            }
            (tip, root) => {
                let known = [("tip diameter da", tip), ("root diameter df", root)];
                facts.extend(known.into_iter().filter_map(|(label, d)| Some(Fact::new(label, mm(d?)))));
            }
        }
        facts
    }

    fn conditions(&self) -> Vec<Fact> {
        let of = &self.inspection.conditions;
        let section = match of.section {
            Section::Transverse => "transverse",
            Section::Normal => "transverse (the file has normal values)",
        };
        let filter = match (&of.profile_filter, &of.helix_filter) {
            (None, None) => "not stated".to_owned(),
            (Some(profile), Some(helix)) if profile == helix => profile.clone(),
            (profile, helix) => {
                let word = |text: &Option<String>| text.clone().unwrap_or_else(|| "not stated".into());
                format!("profile {}, helix {}", word(profile), word(helix))
            }
        };
        let datum = match self.face.datum {
            measured_files::inspection::DatumFace::PlusZ => {
                "+z, upper face (face II); left and right as seen from +z"
            }
            measured_files::inspection::DatumFace::MinusZ => {
                "−z, lower face (face I); left and right as seen from +z"
            }
        };
        let counting = self.inspection.pitch.as_ref().and_then(|pitch| pitch.counting);
        let counting = counting.map_or("not stated", direction);
        let class = match (self.options.tolerance_class, &self.gear.tolerances) {
            (Some(class), Some(_)) => format!("ISO 1328-1:2013 class {class}"),
            (Some(class), None) => format!("class {class} asked for, no tolerances for this gear"),
            (None, _) => "none given; reached classes of ISO 1328-1:2013".into(),
        };
        let mut facts = vec![
            Fact::new("section", section),
            Fact::new("filter", filter),
            Fact::new("datum face", datum),
            Fact::new("counting", counting),
            Fact::new("sign of fHα", self.sign_words(TraceKind::Profile)),
            Fact::new("sign of fHβ", self.sign_words(TraceKind::Helix)),
            Fact::new("tolerances", class),
        ];
        let stylus = of.stylus_diameter_mm.map(|d| format!("ball {} mm", format_significant(d, 5)));
        let warm = of.temperature_c.map(|t| format!("{} °C", format_significant(t, 4)));
        let reference = self.options.reference.clone();
        let stated = (!self.options.stated.is_empty()).then(|| self.options.stated.join("; "));
        let further =
            [("deviations from", reference), ("stated", stated), ("stylus", stylus), ("temperature", warm)];
        facts.extend(further.into_iter().filter_map(|(label, text)| Some(Fact::new(label, text?))));
        facts
    }

    /// What counts as a positive slope, in words.
    pub(super) fn sign_words(&self, kind: TraceKind) -> String {
        if kind == TraceKind::Profile {
            let end = if self.inspection.gear.teeth < 0 { "root" } else { "tip" };
            return format!("+ = material rising with w, to the {end}");
        }
        let stated = self.gear.traces.iter().find(|one| self.inspection.traces[one.trace].kind == kind);
        match stated.map_or(SlopeSign::Din, |one| one.evaluation.slope.rule.sign) {
            SlopeSign::Material => "+ = material rising to +z".into(),
            SlopeSign::Din => "+ = flank turned right-handed (DIN)".into(),
            SlopeSign::Custom(signs) => {
                let of = signs.map(|_, sign| sign.factor());
                custom_words(of)
            }
        }
    }
}

/// Signs of a file; those that mean a hand or the material are named so.
fn custom_words(sigma: Sides<f64>) -> String {
    let hand = Flank::BOTH.into_iter().all(|flank| sigma[flank] == flank.sign());
    match (sigma.left > 0.0, sigma.right > 0.0) {
        (true, true) => "+ = material rising to +z".into(),
        (false, false) => "+ = material falling to +z".into(),
        _ if hand => "+ = flank turned right-handed (DIN)".into(),
        _ => "+ = flank turned left-handed".into(),
    }
}

/// The sense of counting in words.
pub(super) fn direction(counting: CountingDirection) -> &'static str {
    match counting {
        CountingDirection::Clockwise => "clockwise, seen from +z",
        CountingDirection::CounterClockwise => "counter-clockwise, seen from +z",
    }
}
