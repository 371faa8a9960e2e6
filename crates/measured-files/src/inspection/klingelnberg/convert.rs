//! From the signs and coordinates of the files to those of the library: f = -s v material, z from the middle of the face width, lengths of
//! roll for diameters.

mod conditions;
mod tables;

use super::settings::Settings;
use super::{Curve, FileKind, HeaderEntry, KlingelnbergFile};
use crate::inspection::{
    InspectedGear, Inspection, InspectionError, InspectionWarning, Trace, TraceKind, WarningKind, Zero,
};
use foundation::geometry::{Flank, Gear};

/// The inspection of one part from its files, curves and values in any order, each with the name under which it is reported. The
/// header of the first file that has a code holds.
///
/// # Errors
/// [`InspectionError::MissingCode`] where a trace or the gear needs a line of the header; [`InspectionError::BelowBaseCircle`],
/// [`InspectionError::BadInput`], [`InspectionError::UnverifiedSetting`], [`InspectionError::DifferentParts`];
/// [`InspectionError::BadInput`] without any file.
pub fn inspection_of(files: &[(&str, &KlingelnbergFile)]) -> Result<Inspection, InspectionError> {
    let mut whole = joined(files)?;
    without_implausible_results(&mut whole);
    let settings = Settings::of(&whole)?;
    let gear = gear(&whole)?;
    let body = gear.checked()?;
    let place = Place { file: &whole, gear: &gear, body: &body };
    let mut conditions = place.conditions(&settings)?;
    for (key, filter) in
        [("FILTER LEAD", &mut conditions.helix_filter), ("FILTER PROFILE", &mut conditions.profile_filter)]
    {
        *filter = whole.preamble.iter().find(|e| e.key == key).map(|e| e.value.clone());
    }
    let text = |code| whole.header.get(&code).and_then(HeaderEntry::text);
    let mut warnings = whole.warnings.clone();
    warnings.extend(settings.warnings.iter().cloned());
    let (placed, nowhere): (Vec<&Curve>, Vec<&Curve>) =
        whole.curves.iter().partition(|curve| curve.position_mm.abs() <= LONGEST);
    for curve in nowhere {
        let message =
            format!("the trace lies at {:e} mm, where no gear is, and is dropped", curve.position_mm);
        warnings.push(InspectionWarning::at(WarningKind::Implausible, curve.line, message));
    }
    let traces: Result<Vec<Trace>, _> =
        placed.into_iter().map(|curve| place.trace(curve, &mut warnings)).collect();
    if gear.helix_angle_deg != 0.0 {
        let message = "signs and axes of helical gears follow the rules for spur gears; no helical file has proven them";
        warnings.push(InspectionWarning::new(WarningKind::UnverifiedSetting, message));
    }
    let pitch = place.pitch(&settings, &mut warnings);
    Ok(Inspection {
        part: text(7),
        name: text(8),
        drawing: text(6),
        date: text(2),
        time: text(3),
        machine: whole.header.get(&1).map(|entry| entry.label.clone()).filter(|label| !label.is_empty()),
        operator: text(4),
        sources: files.iter().map(|(name, _)| (*name).to_owned()).collect(),
        traces: traces?,
        topographies: Vec::new(),
        pitch,
        run_out: place.run_out(),
        thickness: place.thickness(),
        circles: place.circles()?,
        results: place.results(&conditions),
        warnings,
        gear,
        conditions,
    })
}

/// One file that has what all have.
fn joined(files: &[(&str, &KlingelnbergFile)]) -> Result<KlingelnbergFile, InspectionError> {
    let Some(((_, first), rest)) = files.split_first() else {
        let what = "number of files".into();
        return Err(InspectionError::BadInput { what, value: 0.0, allowed: "one or more" });
    };
    let mut whole = (*first).clone();
    for (name, file) in rest {
        same_part(&whole, file)?;
        if file.kind == FileKind::Curves {
            whole.kind = FileKind::Curves;
        }
        for (code, entry) in &file.header {
            whole.header.entry(*code).or_insert_with(|| entry.clone());
        }
        whole.preamble.extend(file.preamble.iter().cloned());
        whole.curves.extend(file.curves.iter().cloned());
        whole.circles.extend(file.circles.iter().cloned());
        whole.positions.extend(file.positions.iter().copied());
        for flank in Flank::BOTH {
            whole.pitch[flank].extend(file.pitch[flank].iter().copied());
        }
        for (code, value) in &file.results {
            if whole.results.insert(*code, *value).is_some_and(|earlier| earlier != *value) {
                let message = format!("the value {code} differs between the files; that of `{name}` holds");
                whole.warnings.push(InspectionWarning::new(WarningKind::FilesDiffer, message));
            }
        }
        whole.warnings.extend(file.warnings.iter().cloned());
        whole.unknown_lines.extend(file.unknown_lines.iter().cloned());
    }
    Ok(whole)
}

/// Part, drawing and gear must be the same in both files, as far as both state them.
fn same_part(first: &KlingelnbergFile, second: &KlingelnbergFile) -> Result<(), InspectionError> {
    let codes = [
        (7, "the part"),
        (6, "the drawing"),
        (21, "the normal module"),
        (22, "the number of teeth"),
        (23, "the helix angle"),
        (24, "the pressure angle"),
    ];
    for (code, what) in codes {
        let of = |file: &KlingelnbergFile| {
            let entry = file.header.get(&code)?;
            if code < 20 { entry.text() } else { entry.number().map(|number| number.to_string()) }
        };
        if let (Some(first), Some(second)) = (of(first), of(second))
            && first != second
        {
            return Err(InspectionError::DifferentParts { what, first, second });
        }
    }
    Ok(())
}

fn gear(file: &KlingelnbergFile) -> Result<InspectedGear, InspectionError> {
    let optional = |code: u16| file.header.get(&code).and_then(HeaderEntry::number);
    let needed = |code, meaning| optional(code).ok_or(InspectionError::MissingCode { code, meaning });
    let module = needed(21, "normal module")?;
    let teeth = needed(22, "number of teeth")?;
    let most = f64::from(u16::MAX);
    if teeth.fract() != 0.0 || teeth == 0.0 || teeth.abs() > most {
        let allowed = "a whole number other than 0, at most 65535";
        return Err(InspectionError::BadInput { what: "number of teeth".into(), value: teeth, allowed });
    }
    let internal = file.header.get(&22).is_some_and(|entry| entry.value.contains("Innen"));
    let length = |code, what| optional(code).map(|value| plausible(what, value)).transpose();
    let shift = file.header.get(&25).and_then(|entry| {
        // Older and newer dialects: the coefficient, or the length.
        let value = entry.number()?;
        Some(if entry.label.contains("faktor") { value } else { value / module })
    });
    Ok(InspectedGear {
        teeth: if internal { -(teeth.abs() as i32) } else { teeth as i32 },
        normal_module_mm: module,
        normal_pressure_angle_deg: needed(24, "normal pressure angle")?,
        helix_angle_deg: needed(23, "helix angle")?,
        profile_shift: shift.filter(|x| x.is_finite()),
        face_width_mm: length(26, "face width")?,
        tip_diameter_mm: length(27, "tip diameter")?,
        root_diameter_mm: length(272, "root diameter")?,
    })
}

/// Longest length that a header may state, mm.
const LONGEST: f64 = 1e5;
/// Largest deviation, um, and largest size, mm, that a measurement gives.
const LARGEST: f64 = 1e5;

fn plausible(what: &str, value: f64) -> Result<f64, InspectionError> {
    if value.abs() <= LONGEST {
        return Ok(value);
    }
    Err(InspectionError::BadInput { what: what.into(), value, allowed: "a length up to 100000 mm" })
}

/// A value, undefined where no measurement gives it.
fn defined(value: f64) -> f64 {
    if value.abs() > LARGEST { f64::NAN } else { value }
}

/// Values of a table or a trace; those that no measurement gives are undefined and reported.
fn plausible_values(
    values: impl Iterator<Item = f64>,
    what: &str,
    line: Option<usize>,
    warnings: &mut Vec<InspectionWarning>,
) -> Vec<f64> {
    let values: Vec<f64> = values.collect();
    let count = values.iter().filter(|v| v.abs() > LARGEST).count();
    if count > 0 {
        let message = format!("{what}: {count} of the values are beyond {LARGEST} um and count as undefined");
        warnings.push(InspectionWarning { kind: WarningKind::Implausible, line, message });
    }
    values.into_iter().map(defined).collect()
}

/// Printed values that no measurement gives count as not measured, and are reported.
fn without_implausible_results(file: &mut KlingelnbergFile) {
    let implausible = |value: &&mut Option<f64>| value.is_some_and(|value| value.abs() > LARGEST);
    let count = file.results.values_mut().filter(implausible).map(|value| *value = None).count();
    if count > 0 {
        let message =
            format!("{count} printed values are beyond {LARGEST} um or mm and count as not measured");
        file.warnings.push(InspectionWarning::new(WarningKind::Implausible, message));
    }
}

/// A file with the gear that it describes.
struct Place<'a> {
    file: &'a KlingelnbergFile,
    gear: &'a InspectedGear,
    body: &'a Gear,
}

impl Place<'_> {
    fn number(&self, code: u16) -> Option<f64> {
        self.file.header.get(&code).and_then(HeaderEntry::number)
    }

    fn two_sided(&self, code: u16, flank: Flank) -> Option<f64> {
        let [left, right] = self.file.header.get(&code)?.two_sided()?;
        Some(if flank == Flank::Left { left } else { right })
    }

    /// A height of the file, from the middle of the face width.
    fn height(&self, file_height: f64) -> Result<f64, InspectionError> {
        plausible("height of the file", file_height)?;
        let b = self
            .gear
            .face_width_mm
            .ok_or(InspectionError::MissingCode { code: 26, meaning: "face width" })?;
        Ok(file_height - 0.5 * b)
    }

    fn trace(&self, curve: &Curve, warnings: &mut Vec<InspectionWarning>) -> Result<Trace, InspectionError> {
        let ends = self.ends(curve)?;
        let n = curve.values.len();
        let step = (ends[1] - ends[0]) / (n - 1) as f64;
        let s = curve.flank.sign();
        let position_mm = match curve.kind {
            TraceKind::Helix => curve.position_mm,
            TraceKind::Profile => self.height(curve.position_mm)?,
        };
        let f_um =
            plausible_values(curve.values.iter().map(|v| -s * v), "the trace", Some(curve.line), warnings);
        // The last place is the end itself, not what rounding makes of it.
        let place = |i: usize| if i + 1 == n { ends[1] } else { ends[0] + step * i as f64 };
        Ok(Trace {
            kind: curve.kind,
            tooth: curve.tooth,
            flank: curve.flank,
            tag: curve.tag.clone(),
            position_mm,
            abscissa_mm: (0..n).map(place).collect(),
            f_um,
            zero: Zero::Free,
        })
    }

    /// First and last place of a curve.
    fn ends(&self, curve: &Curve) -> Result<[f64; 2], InspectionError> {
        let codes = match curve.kind {
            TraceKind::Profile => [(41, "start of the profile"), (44, "end of the profile")],
            TraceKind::Helix => [(61, "start of the helix trace"), (64, "end of the helix trace")],
        };
        let mut ends = [0.0; 2];
        for (end, (code, meaning)) in ends.iter_mut().zip(codes) {
            let stated = self.two_sided(code, curve.flank);
            let stated = stated.ok_or(InspectionError::MissingCode { code, meaning })?;
            *end = match curve.kind {
                TraceKind::Profile => self.roll(code, curve.flank, stated)?,
                TraceKind::Helix => self.height(stated)?,
            };
        }
        if ends[0] < ends[1] {
            return Ok(ends);
        }
        let what = format!("end of the {} traces of the {} flank", curve.kind.name(), curve.flank);
        Err(InspectionError::BadInput { what, value: ends[1], allowed: "beyond its start" })
    }

    /// The length of roll at a diameter of the header.
    fn roll(&self, code: u16, flank: Flank, diameter: f64) -> Result<f64, InspectionError> {
        plausible("diameter of the header", diameter)?;
        let involute = self.body.flank(flank);
        involute.length_of_roll(0.5 * diameter).map_err(|_| InspectionError::BelowBaseCircle {
            what: format!("the diameter of code {code}"),
            flank,
            diameter,
            base_diameter: 2.0 * involute.base_radius,
        })
    }
}
