//! The structure that the schema demands, and what is kept as it is.

use super::super::*;

const HEAD: &str = r#"<model version="2.0.0" applicationId="x" applicationVersion="1" date="d">"#;

fn xml(inside: &str) -> Result<RexsDocument, RexsError> {
    parse_rexs(format!("{HEAD}{inside}</model>").as_bytes())
}

#[test]
fn elements_stand_where_the_schema_has_them() {
    let shaft = r#"<component id="1" type="shaft"><attribute id="density">1</attribute></component>"#;
    let relation = r#"<relations><relation id="1" type="t"><ref id="1" role="r"/></relation></relations>"#;
    assert!(xml(&format!("{relation}<components>{shaft}</components>")).is_ok());
    assert!(xml("").is_ok());
    let wrong = [
        format!("<components>{shaft}</components>{relation}"),
        format!("<components>{shaft}</components><components/>"),
        "<other/>".into(),
        "text".into(),
        "<components><relation/></components>".into(),
        "<components><component id=\"1\"/></components>".into(),
        "<components><component id=\"1.5\" type=\"shaft\"/></components>".into(),
        format!("<components>{shaft}{shaft}</components>"),
        relation.into(),
        "<relations><relation id=\"1\" type=\"t\"/></relations>".into(),
        "<components><component id=\"1\" type=\"shaft\"><attribute/></component></components>".into(),
        "<components><component id=\"1\" type=\"shaft\"><attribute id=\"a\"><list/></attribute></component></components>".into(),
        "<components><component id=\"1\" type=\"shaft\"><attribute id=\"a\"><array code=\"float16\"/></attribute></component></components>".into(),
        "<components><component id=\"1\" type=\"shaft\"><attribute id=\"a\"><array><r/></array></attribute></component></components>".into(),
        "<load_spectrum/>".into(),
        "<load_spectrum id=\"1\"/>".into(),
        "<load_spectrum id=\"1\"><accumulation/></load_spectrum>".into(),
        "<load_spectrum id=\"1\"><load_case/></load_spectrum>".into(),
        "<load_spectrum id=\"1\"><load_case id=\"1\"/><load_case id=\"1\"/></load_spectrum>".into(),
        "<load_spectrum id=\"1\"><load_case id=\"1\"><component id=\"7\" type=\"shaft\"/></load_case></load_spectrum>".into(),
        format!(
            "<components>{shaft}</components>{}",
            "<load_spectrum id=\"1\"><load_case id=\"1\"/></load_spectrum>".repeat(2)
        ),
        "<components><component id=\"1\" type=\"shaft\"><attribute id=\"a\"><matrix><r/></matrix></attribute></component></components>".into(),
    ];
    for text in wrong {
        let error = xml(&text).unwrap_err();
        assert_eq!(error.code(), "rexs-structure", "{text}: {error}");
    }
    for key in ["version", "applicationId", "applicationVersion", "date"] {
        let text = format!("{HEAD}</model>").replace(&format!(" {key}="), " other=");
        assert_eq!(parse_rexs(text.as_bytes()).unwrap_err().code(), "rexs-structure", "{key}");
    }
}

#[test]
fn entities_are_not_expanded() {
    let bomb = r#"<!DOCTYPE model [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;">]>"#;
    let text = format!("{bomb}{}&b;</model>", HEAD);
    assert_eq!(parse_rexs(text.as_bytes()).unwrap_err().code(), "entities-refused");
    let outside = format!(r#"<!DOCTYPE model SYSTEM "file:///etc/passwd">{HEAD}</model>"#);
    assert_eq!(parse_rexs(outside.as_bytes()).unwrap_err().code(), "entities-refused");
    assert_eq!(xml("&b;").unwrap_err().code(), "not-rexs");
}

#[test]
fn other_components_and_spectra_are_kept_as_they_are() {
    let inside = concat!(
        r#"<components><component id="7" type="shaft" name="a &amp; b"><attribute id="x" unit="mm"><matrix><r><c>1</c></r></matrix></attribute></component>"#,
        r#"<component id="8" type="ring_gear"><attribute id="number_of_teeth" unit="none">70</attribute>"#,
        r#"<attribute id="other" unit="HRC">5</attribute></component></components>"#,
        r#"<load_spectrum id="1"><load_case id="1"><component id="7" type="shaft"/></load_case></load_spectrum>"#
    );
    let document = xml(inside).unwrap();
    let (bytes, lost) = rexs_bytes(&document, RexsFormat::Xml, false).unwrap();
    assert!(lost.is_empty());
    let text = String::from_utf8(bytes).unwrap();
    assert!(
        text.contains(
            r#"name="a &amp; b"><attribute id="x" unit="mm"><matrix><r><c>1</c></r></matrix></attribute>"#
        ),
        "{text}"
    );
    assert!(text.contains(r#"<attribute id="other" unit="HRC">5</attribute>"#), "{text}");
    assert_eq!(parse_rexs(text.as_bytes()).unwrap(), document);
    let (bytes, lost) = rexs_bytes(&document, RexsFormat::Json, false).unwrap();
    assert_eq!(lost.len(), 3, "{lost:?}");
    assert!(lost.iter().all(|w| w.kind == RexsWarningKind::Lost));
    assert_eq!(parse_rexs(&bytes).unwrap().components.len(), 2);
    let prefixed = format!("{HEAD}{inside}</model>")
        .replace("<model", "<r:model xmlns:r=\"https://www.rexs.info\"")
        .replace("</model", "</r:model")
        .replace("<component", "<r:component")
        .replace("</component", "</r:component");
    assert_eq!(parse_rexs(prefixed.as_bytes()).unwrap().components, document.components);
}

#[test]
fn json_has_the_same_structure() {
    let of = |model: &str| parse_rexs(format!(r#"{{"model": {model}}}"#).as_bytes());
    let head = r#""version":"2.0.0","applicationId":"x","applicationVersion":"1","date":"d""#;
    let kept = of(&format!(r#"{{{head},"components":[{{"id":1,"type":"shaft","attributes":[{{"id":"a","string":"b"}}]}}],"loadSpectrum":{{"id":1}}}}"#)).unwrap();
    let (bytes, lost) = rexs_bytes(&kept, RexsFormat::Json, true).unwrap();
    assert!(lost.is_empty());
    assert_eq!(parse_rexs(&bytes).unwrap(), kept);
    assert_eq!(rexs_bytes(&kept, RexsFormat::Xml, false).unwrap().1.len(), 2);
    for (model, code) in [
        ("[]".to_owned(), "not-rexs"),
        ("{}".to_owned(), "rexs-structure"),
        (format!(r#"{{{head},"components":{{}}}}"#), "rexs-structure"),
        (format!(r#"{{{head},"components":[1]}}"#), "rexs-structure"),
        (format!(r#"{{{head},"components":[{{"id":"1","type":"shaft"}}]}}"#), "rexs-structure"),
        (
            format!(r#"{{{head},"components":[{{"id":1,"type":"shaft"}},{{"id":1,"type":"shaft"}}]}}"#),
            "rexs-structure",
        ),
        (
            format!(r#"{{{head},"relations":[{{"id":1,"type":"t","refs":[{{"id":5,"role":"r"}}]}}]}}"#),
            "rexs-structure",
        ),
        (
            format!(
                r#"{{{head},"components":[{{"id":1,"type":"ring_gear","attributes":[{{"id":"face_width","enum":"x"}}]}}]}}"#
            ),
            "bad-value",
        ),
    ] {
        assert_eq!(of(&model).unwrap_err().code(), code, "{model}");
    }
}

#[test]
fn texts_come_back_character_by_character() {
    let of = |word: &str| {
        let text = format!(
            r#"{{"model":{{"version":"2.0.0","applicationId":"x","applicationVersion":"1","date":"d","components":[{{"id":1,"type":"cylindrical_gear","name":"{word}","attributes":[{{"id":"datum_face_orientation","unit":"{word}","enum":"positive"}}]}}]}}}}"#
        );
        parse_rexs(text.as_bytes())
    };
    // A reader of XML makes blanks of what is not written as a number.
    for word in [r"a\u007fb\u0085c", r"a\tb\r\nc\nd", r#"\u00b5<&>\"'"#] {
        let document = of(word).unwrap();
        let (bytes, lost) = rexs_bytes(&document, RexsFormat::Xml, false).unwrap();
        assert!(lost.is_empty());
        assert_eq!(parse_rexs(&bytes).unwrap(), document);
    }
    // XML has no way to write these.
    for word in [r"a\u0000", r"a\u001f", r"a\uffff"] {
        assert_eq!(of(word).unwrap_err().code(), "rexs-structure", "{word}");
    }
}

#[test]
fn sizes_and_packages_are_bounded() {
    use std::io::Write;
    let code = |bytes: &[u8]| parse_rexs(bytes).unwrap_err().code();
    assert_eq!(code(b""), "not-rexs");
    assert_eq!(code(b"hello"), "not-rexs");
    assert_eq!(code(b"<a/>"), "not-rexs");
    assert_eq!(code(b"{}"), "not-rexs");
    assert_eq!(code(b"<model \xff/>"), "not-rexs");
    assert_eq!(code(b"PK\x03\x04 broken"), "not-rexs");
    assert_eq!(code(&vec![b' '; MAXIMUM_FILE_BYTES + 1]), "file-too-large");
    let package = |entries: &[(&str, usize)]| {
        let mut package = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
        let options =
            zip::write::SimpleFileOptions::default().compression_method(zip::CompressionMethod::Deflated);
        for (name, size) in entries {
            package.start_file(*name, options).unwrap();
            package.write_all(&vec![b' '; *size]).unwrap();
        }
        package.finish().unwrap().into_inner()
    };
    // A small package that unpacks to more than is read.
    let bomb = package(&[("a.rexs", MAXIMUM_FILE_BYTES + 1)]);
    assert!(bomb.len() < 1 << 20);
    assert_eq!(code(&bomb), "file-too-large");
    assert_eq!(code(&package(&[("a.txt", 5)])), "not-rexs");
    assert_eq!(code(&package(&[("a.rexs", 5), ("b.rexsj", 5)])), "not-rexs");
    let missing = read_rexs(std::path::Path::new("/nowhere/x.rexs")).unwrap_err();
    assert_eq!(missing.code(), "unreadable-file");
}

#[test]
fn deep_nesting_does_not_overflow() {
    let deep = format!("{}{}", "<a>".repeat(200_000), "</a>".repeat(200_000));
    for text in [
        deep.clone(),
        format!("{HEAD}{deep}</model>"),
        format!("{HEAD}<load_spectrum id=\"1\">{deep}</load_spectrum></model>"),
        format!(
            "{HEAD}<components><component id=\"1\" type=\"x\"><attribute id=\"a\">{deep}</attribute></component></components></model>"
        ),
    ] {
        assert!(parse_rexs(text.as_bytes()).is_err());
    }
    assert!(parse_rexs("[".repeat(100_000).as_bytes()).is_err());
    assert!(parse_rexs(format!("{{\"model\":{}", "[".repeat(100_000)).as_bytes()).is_err());
}
