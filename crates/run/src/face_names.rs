//! A remark on modifications that name a face by number: which end of the gear is meant, by its datum face.

use foundation::modification::ModificationSpec;
use std::collections::BTreeSet;
use verdict::Remark;

/// Says of every number of a face in these modifications which face it is; `None` where none stands.
pub fn face_names_remark<'a>(specs: impl IntoIterator<Item = &'a ModificationSpec>) -> Option<Remark> {
    let named: BTreeSet<(String, bool)> =
        specs.into_iter().flat_map(ModificationSpec::faces_by_number).collect();
    if named.is_empty() {
        return None;
    }
    let meaning = |datum: bool| {
        let names: Vec<&str> =
            named.iter().filter(|(_, of_datum)| *of_datum == datum).map(|(name, _)| name.as_str()).collect();
        let face = if datum {
            "the datum face (upper z, face II)"
        } else {
            "the face opposite the datum face (lower z, face I)"
        };
        (!names.is_empty()).then(|| format!("{} means {face}", names.join(" and ")))
    };
    let text: Vec<String> = [false, true].into_iter().filter_map(meaning).collect();
    Some(Remark {
        code: "face-names",
        text: format!("{}; drawings often call the datum face I", text.join(", ")),
        way_out: "compare with the drawing; names that cannot be misread are end_relief_datum_face, end_relief_non_datum_face, \
                  corner_face = \"datum_face\" or \"non_datum_face\", amount_datum_face_um, amount_non_datum_face_um"
            .into(),
    })
}
