//! From made files to the model: signs, axes, places, tables, printed values.

use super::super::*;
use super::made::{Made, TEETH, WIDTH, latin1};
use foundation::geometry::Flank;

fn read(made: &Made) -> KlingelnbergFile {
    parse_klingelnberg(made.text().as_bytes()).unwrap()
}

fn whole(made: &Made) -> Inspection {
    inspection_of(&[("made.mka", &read(made))]).unwrap()
}

/// Length of roll on the gear of `Made`, by a formula of its own.
fn roll(diameter: f64) -> f64 {
    let base = 2.0 * f64::from(TEETH) * 20f64.to_radians().cos();
    0.5 * (diameter * diameter - base * base).sqrt()
}

#[test]
fn curves_get_the_sign_of_the_material_and_places_in_mm() {
    let values: Vec<f64> =
        (0..25).map(|i| if i == 3 { f64::NAN } else { 0.25 * f64::from(i) - 2.0 }).collect();
    let made = Made::gear()
        .curve("Flankenlinie:", "Zahn-Nr.: 7 links / 25  Werte  x= 8.953", &values)
        .curve("", "Zahn-Nr.: 7 rechts / 25  Werte  x= 8.953", &values)
        .curve("Profil:", "Zahn-Nr.: 9o rechts / 25  Werte  z= 16", &values);
    let file = read(&made);
    assert!(file.unknown_lines.is_empty() && file.warnings.is_empty(), "{:?}", file.unknown_lines);
    let found = whole(&made);
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    let [left, right, profile] = &found.traces[..] else { panic!("{:?}", found.traces.len()) };
    assert_eq!((left.kind, left.flank, left.tooth), (TraceKind::Helix, Flank::Left, 7));
    // s = +1: a curve that rises is a material that falls; s = -1: the other way.
    assert_eq!((left.f_um[0], right.f_um[0], left.f_um[24]), (2.0, -2.0, -4.0));
    assert!(left.f_um[3].is_nan() && right.f_um[3].is_nan());
    assert_eq!((left.abscissa_mm[0], left.abscissa_mm[24]), (-WIDTH / 2.0, WIDTH / 2.0));
    assert!((left.abscissa_mm[1] - (-10.0 + WIDTH / 24.0)).abs() < 1e-12);
    assert_eq!((left.position_mm, profile.position_mm), (8.953, 6.0));
    // Uniform in the length of roll, not in the diameter; the right flank begins at 44.2 mm.
    assert!((profile.abscissa_mm[0] - roll(44.2)).abs() < 1e-12);
    assert!((profile.abscissa_mm[24] - roll(49.5)).abs() < 1e-12);
    let middle = 0.5 * (roll(44.2) + roll(49.5));
    assert!((profile.abscissa_mm[12] - middle).abs() < 1e-12);
    assert_eq!((profile.tag.as_str(), profile.zero), ("o", Zero::Free));
}

#[test]
fn conditions_state_ranges_signs_and_lengths() {
    let found = whole(&Made::gear());
    let c = &found.conditions;
    assert_eq!(c.range(TraceKind::Helix, Flank::Left), Ok([-9.0, 9.0]));
    assert_eq!(c.range(TraceKind::Helix, Flank::Right), Ok([-8.5, 8.5]));
    // With tip relief the profile ends where the relief begins, whatever code 43 says.
    let [lo, hi] = c.range(TraceKind::Profile, Flank::Left).unwrap();
    assert!((lo - roll(44.5)).abs() < 1e-12 && (hi - roll(48.6)).abs() < 1e-12);
    assert_eq!(c.reference_length(TraceKind::Helix, Flank::Left, found.gear.face_width_mm), Ok(WIDTH));
    assert_eq!(c.reference_length(TraceKind::Profile, Flank::Left, None), Ok(hi - lo));
    assert_eq!(c.flanks.left.printed_sign, Some(1.0));
    assert_eq!(c.flanks.right.printed_sign, Some(-1.0));
    assert_eq!((c.section, c.datum_face), (Section::Transverse, DatumFace::PlusZ));
    assert_eq!((c.stylus_diameter_mm, c.helix_filter.as_deref()), (Some(0.5), Some("F:S 2")));
    assert_eq!(found.gear.profile_shift, Some(0.25));
    assert_eq!((found.part.as_deref(), found.name.as_deref()), (Some("4711"), Some("Prüfrad")));
    let factor = whole(&Made::gear().with(25, "Profilverschiebungsfaktor x ....: .011"));
    assert_eq!(factor.gear.profile_shift, Some(0.011));
    let internal = whole(&Made::gear().with(22, "Zähnezahl z....: 23   Innenverzahnung"));
    assert_eq!(internal.gear.teeth, -23);
}

#[test]
fn tables_and_printed_values_find_their_places() {
    let mut rows = String::from("linke Zahnflanke\nZahn-Nr.  fp  Fp  Fr\n");
    for tooth in 1..=TEETH {
        rows.push_str(&format!("  {tooth}   .{tooth:03}   -1.5   -2147483.648\n"));
    }
    rows.push_str("Fußkreisdurchmesser / Höhe :     8.500\n   48.3802   48.3887\n   48.3701\n");
    rows.push_str("Teilung:\nZ-Nr. Seite PHI X Y Z\n 1 R 0.0 .1198 25.5249 87.2302\n");
    let curves = read(&Made::gear().lines(&rows));
    assert!(curves.unknown_lines.is_empty(), "{:?}", curves.unknown_lines);
    let values = read(&Made::gear().printing(&[
        (10112, "3.8"),
        (20121, "-1.5"),
        (26511, "-9999.0"),
        (34610, "16.826"),
        (99999, "1"),
    ]));
    let found = inspection_of(&[("a.mka", &curves), ("a.mew", &values)]).unwrap();
    let pitch = found.pitch.unwrap();
    let left = pitch.flanks.left.unwrap();
    assert_eq!((left.fp_um.len(), left.fp_um[1], left.cumulative_um[22]), (23, 0.002, -1.5));
    assert!(pitch.flanks.right.is_none() && found.run_out.is_none());
    assert_eq!((pitch.diameter_mm, pitch.counting), (Some(46.0), Some(CountingDirection::CounterClockwise)));
    assert_eq!(pitch.positions[0].centre_mm, [0.1198, 25.5249, 87.2302]);
    let root = found.circles.root.unwrap();
    assert_eq!((root.z_mm, root.diameters_mm.len()), (-1.5, 3));
    assert_eq!((found.thickness.span.unwrap().mean_mm, found.thickness.span_teeth), (Some(16.826), Some(3)));
    let of = |code| found.results.iter().find(|q| q.code == code).unwrap();
    assert_eq!(
        (of(10112).value, of(10112).sigma, of(10112).reference_length_mm),
        (Some(3.8), Some(1.0), Some(WIDTH))
    );
    assert_eq!((of(20121).value, of(20121).sigma), (Some(-1.5), Some(1.0)));
    assert_eq!((of(26511).value, of(99999).meaning.characteristic), (None, Characteristic::Unknown));
    assert_eq!(found.sources, ["a.mka", "a.mew"]);
}

#[test]
fn the_same_file_in_every_encoding_and_line_end() {
    let text = Made::gear()
        .curve(
            "Verschränkung: Zahn-Nr.: 1k /Flankenlinie:3 rechts / 3  Werte  x= 10.263",
            "1.5 -2.5 .25",
            &[],
        )
        .text();
    let plain = parse_klingelnberg(text.as_bytes()).unwrap();
    assert_eq!((plain.encoding, plain.curves.len()), (Encoding::Utf8, 1));
    let marked = parse_klingelnberg(&[b"\xef\xbb\xbf", text.as_bytes()].concat()).unwrap();
    let latin = parse_klingelnberg(&latin1(&text)).unwrap();
    assert_eq!((marked.encoding, latin.encoding), (Encoding::Utf8WithMark, Encoding::Cp1252));
    let unix = parse_klingelnberg(text.replace("\r\n", "\n").as_bytes()).unwrap();
    let mac = parse_klingelnberg(text.replace("\r\n", "\r").as_bytes()).unwrap();
    for mut other in [marked, latin, unix, mac] {
        other.encoding = plain.encoding;
        assert_eq!(other, plain);
    }
}

#[test]
fn the_model_survives_json() {
    let made = Made::gear()
        .curve("Profil:", "Zahn-Nr.: 1 links / 3 Werte z= 10", &[1.0, f64::NAN, -2.0])
        .lines("linke Zahnflanke\n 1 .5 .5 .5\n");
    let found = whole(&made);
    let text = serde_json::to_string(&found).unwrap();
    assert!(text.contains("[-1.0,null,2.0]"), "{text}");
    let back: Inspection = serde_json::from_str(&text).unwrap();
    // NaN is not equal to itself: the text is.
    assert_eq!(serde_json::to_string(&back).unwrap(), text);
    assert!(back.traces[0].f_um[1].is_nan());
}
