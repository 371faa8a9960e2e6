//! REXS models as XML, as JSON and packed, the gears in them, and both ways back.

use flankwright::exchange::rexs::{
    Author, Content, RexsDocument, RexsError, RexsFormat, RexsGear, document_of, gear_ids, gear_of,
    parse_rexs, rexs_bytes,
};
use flankwright::geometry::Flank;
use flankwright::modification::NoFiles;

use crate::complaints::told_in_full;

/// A model as XML.
pub fn rexs_xml(data: &[u8]) {
    // What is no XML has a target of its own.
    if data.first() == Some(&b'<') {
        any(data);
    }
}

/// A model as JSON.
pub fn rexs_json(data: &[u8]) {
    if data.first() == Some(&b'{') {
        any(data);
    }
}

/// A package; the mark of one is set, so that none is passed over.
pub fn rexs_packed(data: &[u8]) {
    any(&[b"PK\x03\x04", data.get(4..).unwrap_or_default()].concat());
}

fn refused(error: &RexsError) {
    told_in_full(error.code(), &error.to_string(), &error.way_out());
}

fn any(data: &[u8]) {
    let document = match parse_rexs(data) {
        Ok(document) => document,
        Err(error) => return refused(&error),
    };
    for format in [RexsFormat::Xml, RexsFormat::Json] {
        written_and_read(&document, format);
    }
    // More gears than a file of this size can describe in full would only take time.
    for id in gear_ids(&document).into_iter().take(8) {
        match gear_of(&document, id) {
            Ok((gear, _)) => gear_and_back(&gear),
            Err(error) => refused(&error),
        }
    }
}

fn written_and_read(document: &RexsDocument, format: RexsFormat) {
    let (bytes, lost) = rexs_bytes(document, format, false).expect("a file of the model");
    let back = parse_rexs(&bytes).unwrap_or_else(|error| panic!("{error}: {}", bytes.escape_ascii()));
    if lost.is_empty() {
        assert_eq!(with_units(&back), with_units(document), "{}", bytes.escape_ascii());
    }
    // What was lost once is not lost again.
    let (second, lost) = rexs_bytes(&back, format, false).expect("a file of the model");
    assert!(lost.is_empty(), "{lost:?}");
    assert_eq!(second.escape_ascii().to_string(), bytes.escape_ascii().to_string());
    let (packed, _) = rexs_bytes(&back, format, true).expect("a package of the model");
    assert_eq!(parse_rexs(&packed).expect("the package"), back);
}

/// An absent unit is written as what it means.
fn with_units(document: &RexsDocument) -> RexsDocument {
    let mut document = document.clone();
    for component in &mut document.components {
        if let Content::Attributes(list) = &mut component.content {
            for attribute in list {
                attribute.unit.get_or_insert_with(|| "none".into());
            }
        }
    }
    document
}

fn gear_and_back(gear: &RexsGear) {
    let numbers = [gear.normal_module_mm, gear.helix_angle_deg, gear.profile_shift, gear.face_width_mm];
    assert!(numbers.into_iter().all(f64::is_finite) && gear.face_width_mm > 0.0, "{gear:?}");
    for trace in &gear.deviations {
        assert_eq!(trace.abscissa_mm.len(), trace.f_um.len());
        assert!(trace.abscissa_mm.iter().all(|v| v.is_finite()) && trace.position_mm.is_finite());
        assert!(trace.f_um.iter().all(|v| !v.is_infinite()));
    }
    let author = Author::flankwright("2026-01-01T00:00:00Z");
    let (document, _) = match document_of(gear, &NoFiles, &author) {
        Ok(document) => document,
        Err(error) => return refused(&error),
    };
    let (bytes, lost) = rexs_bytes(&document, RexsFormat::Xml, false).expect("a file of the gear");
    assert!(lost.is_empty(), "{lost:?}");
    let read = parse_rexs(&bytes).expect("the file of the gear");
    let (back, _) = gear_of(&read, gear_ids(&read)[0]).unwrap_or_else(|error| panic!("{error}: {gear:?}"));
    assert_eq!((back.teeth, back.datum_face), (gear.teeth, gear.datum_face));
    assert_eq!(
        [back.normal_module_mm, back.helix_angle_deg, back.profile_shift, back.face_width_mm],
        [gear.normal_module_mm, gear.helix_angle_deg, gear.profile_shift, gear.face_width_mm]
    );
    for flank in Flank::BOTH {
        assert_eq!(back.normal_pressure_angle_deg[flank], gear.normal_pressure_angle_deg[flank]);
        assert_eq!(back.modifications[flank].len(), gear.modifications[flank].len(), "{gear:?}");
    }
}
