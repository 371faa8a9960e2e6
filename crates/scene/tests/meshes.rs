//! Meshes and their files: what is written is read back by readers that share no code with the writers.

use base64::Engine;
use nalgebra::Vector3;
use proptest::prelude::*;
use roxmltree::{Document, Node};
use scene::mesh::{
    MeshError, NamedMesh, PatchSide, PointData, PointValues, Section, TriangleMesh, patch, stl, swept,
    three_mf, vtp_of_mesh, vtp_of_paths,
};
use std::io::{Cursor, Read};
use zip::ZipArchive;

/// Points on a star-shaped loop at height z, turned by `turn`.
fn star(points: usize, radius: f64, wave: f64, turn: f64, z: f64) -> Vec<Vector3<f64>> {
    (0..points)
        .map(|i| {
            let angle = std::f64::consts::TAU * i as f64 / points as f64;
            let r = radius + wave * (7.0 * angle).cos();
            Vector3::new(r * (angle + turn).cos(), r * (angle + turn).sin(), z)
        })
        .collect()
}

/// The area of a loop in a plane z = const, by trapezoids.
fn trapezoids(points: &[Vector3<f64>]) -> f64 {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(p, q)| 0.5 * (p.y + q.y) * (p.x - q.x)).sum::<f64>().abs()
}

fn prism(outline: &[Vector3<f64>], holes: &[Vec<Vector3<f64>>], heights: &[f64]) -> Vec<Section> {
    let at = |points: &[Vector3<f64>], z| points.iter().map(|p| Vector3::new(p.x, p.y, z)).collect();
    let section =
        |&z: &f64| Section { outline: at(outline, z), holes: holes.iter().map(|hole| at(hole, z)).collect() };
    heights.iter().map(section).collect()
}

fn cube() -> TriangleMesh {
    let square = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]].map(|[x, y]| Vector3::new(x, y, 0.0));
    swept(&prism(&square, &[], &[0.0, 10.0])).unwrap()
}

fn wave(rows: usize, columns: usize) -> Vec<Vector3<f64>> {
    (0..rows * columns)
        .map(|i| {
            let (row, column) = ((i / columns) as f64, (i % columns) as f64);
            Vector3::new(0.25 * row, 0.5 * column, 0.3 * (0.4 * row).sin() * (0.2 * column).cos())
        })
        .collect()
}

/// The triangles of a binary STL: normal and three corners each.
fn read_stl(bytes: &[u8]) -> Vec<[Vector3<f64>; 4]> {
    assert!(!bytes.starts_with(b"solid"));
    let count = u32::from_le_bytes(bytes[80..84].try_into().unwrap()) as usize;
    assert_eq!(bytes.len(), 84 + 50 * count);
    let number = |at: usize| f64::from(f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()));
    let vector = |at: usize| Vector3::new(number(at), number(at + 4), number(at + 8));
    (0..count).map(|i| [0, 12, 24, 36].map(|offset| vector(84 + 50 * i + offset))).collect()
}

fn unpack(bytes: &[u8], path: &str) -> String {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).unwrap();
    let mut text = String::new();
    archive.by_name(path).unwrap().read_to_string(&mut text).unwrap();
    text
}

fn child<'a>(node: Node<'a, 'a>, name: &str) -> Node<'a, 'a> {
    node.children().find(|n| n.has_tag_name(name)).unwrap_or_else(|| panic!("no <{name}>"))
}

fn attribute<T: std::str::FromStr>(node: Node<'_, '_>, name: &str) -> T {
    node.attribute(name).and_then(|text| text.parse().ok()).unwrap_or_else(|| panic!("no attribute {name}"))
}

/// The numbers of an array of a .vtp file.
fn numbers(document: &Document<'_>, name: &str) -> Vec<f64> {
    let array = document.descendants().find(|n| n.attribute("Name") == Some(name)).unwrap();
    let appended = document.descendants().find(|n| n.has_tag_name("AppendedData")).unwrap();
    let data = appended.text().unwrap().trim().strip_prefix('_').unwrap();
    let block = &data[attribute::<usize>(array, "offset")..];
    let decode = |text: &str| base64::engine::general_purpose::STANDARD.decode(text).unwrap();
    // Twelve characters are nine bytes: the length and the first byte of the data.
    let length = u64::from_le_bytes(decode(&block[..12])[..8].try_into().unwrap()) as usize;
    let bytes = &decode(&block[..(8 + length).div_ceil(3) * 4])[8..];
    assert_eq!(bytes.len(), length);
    match array.attribute("type") {
        Some("Float64") => bytes.chunks(8).map(|b| f64::from_le_bytes(b.try_into().unwrap())).collect(),
        Some("Int32") => {
            bytes.chunks(4).map(|b| f64::from(i32::from_le_bytes(b.try_into().unwrap()))).collect()
        }
        other => panic!("type {other:?}"),
    }
}

fn flat(points: &[Vector3<f64>]) -> Vec<f64> {
    points.iter().flat_map(|p| [p.x, p.y, p.z]).collect()
}

#[test]
fn a_prism_has_the_volume_of_its_section_times_its_length() {
    // A gear-like section with a bore that runs the other way round, several sections.
    let outline = star(210, 40.0, 4.0, 0.0, 0.0);
    let mut bore = star(32, 12.0, 0.0, 0.1, 0.0);
    bore.reverse();
    let area = trapezoids(&outline) - trapezoids(&bore);
    for heights in [[-15.0, -2.0, 20.0], [20.0, -2.0, -15.0]] {
        let body = swept(&prism(&outline, std::slice::from_ref(&bore), &heights)).unwrap();
        body.check_watertight().unwrap();
        assert!((body.volume() / (35.0 * area) - 1.0).abs() < 1e-13, "{} {}", body.volume(), 35.0 * area);
        let around = |loop_: &[Vector3<f64>]| {
            loop_.iter().zip(loop_.iter().cycle().skip(1)).map(|(p, q)| (q - p).norm()).sum::<f64>()
        };
        let surface = 2.0 * area + 35.0 * (around(&outline) + around(&bore));
        assert!((body.area() / surface - 1.0).abs() < 1e-13);
    }
}

#[test]
fn the_outline_may_run_either_way_and_lie_anywhere() {
    let mut outline = star(60, 20.0, 5.0, 0.0, 0.0);
    let volume = 8.0 * trapezoids(&outline);
    let far = Vector3::new(3000.0, -2000.0, 500.0);
    for turned in [false, true] {
        if turned {
            outline.reverse();
        }
        let mut sections = prism(&outline, &[], &[0.0, 8.0]);
        // z -> x -> y -> z turns the body without a mirror.
        for point in sections.iter_mut().flat_map(|s| &mut s.outline) {
            *point = Vector3::new(point.z, point.x, point.y) + far;
        }
        let body = swept(&sections).unwrap();
        assert!((body.volume() / volume - 1.0).abs() < 1e-10, "{}", body.volume());
    }
}

#[test]
fn a_helical_body_closes() {
    let sections: Vec<Section> = (0..=40)
        .map(|i| {
            let share = f64::from(i) / 40.0;
            let outline = star(140, 30.0 + 2.0 * share, 3.0, 0.6 * share, 25.0 * share);
            Section { outline, holes: vec![star(24, 8.0, 0.0, 0.0, 25.0 * share)] }
        })
        .collect();
    let body = swept(&sections).unwrap();
    // The section grows linearly with its radius, so that the end faces and the middle give the integral (Simpson); the wall between
    // two turned sections sags by the chord.
    let area = |s: &Section| trapezoids(&s.outline) - trapezoids(&s.holes[0]);
    let simpson = 25.0 * (area(&sections[0]) + 4.0 * area(&sections[20]) + area(&sections[40])) / 6.0;
    assert!((body.volume() / simpson - 1.0).abs() < 2e-3, "{} {simpson}", body.volume());
    // n points a loop: n - 2 triangles an end face, two more for the hole and as many as it has points; two a wall cell.
    assert_eq!(body.triangles.len(), 2 * (140 + 24) + 2 * 40 * (140 + 24));
}

#[test]
fn end_faces_need_not_be_plane() {
    // The back cone of a bevel gear: the bore ends higher than the rim.
    let section = |z: f64| Section {
        outline: star(48, 20.0, 1.0, 0.0, z),
        holes: vec![star(16, 6.0, 0.0, 0.0, z + 5.0)],
    };
    let body = swept(&[section(0.0), section(10.0)]).unwrap();
    let area = trapezoids(&section(0.0).outline) - trapezoids(&section(0.0).holes[0]);
    assert!((body.volume() / (10.0 * area) - 1.0).abs() < 1e-12);
}

#[test]
fn outlines_that_bound_nothing_are_refused() {
    let at = |corners: &[[f64; 2]]| corners.iter().map(|c| Vector3::new(c[0], c[1], 0.0)).collect::<Vec<_>>();
    let square = at(&[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]]);
    let small = |x: f64, y: f64| at(&[[x, y], [x + 1.0, y], [x + 1.0, y + 1.0]]);
    let build =
        |outline: &[Vector3<f64>], holes: &[Vec<Vector3<f64>>]| swept(&prism(outline, holes, &[0.0, 1.0]));
    assert!(build(&square, &[small(2.0, 2.0), small(5.0, 5.0)]).is_ok());
    let refused = [
        build(&at(&[[0.0, 0.0], [10.0, 10.0], [10.0, 0.0], [0.0, 9.0]]), &[]),
        build(&at(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [4.0, 0.0]]), &[]),
        build(&at(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0]]), &[]),
        build(&at(&[[0.0, 0.0], [4.0, 0.0], [8.0, 0.0]]), &[]),
        build(&square, &[small(20.0, 2.0)]),
        build(&square, &[small(9.5, 2.0)]),
        build(&square, &[at(&[[2.0, 2.0], [8.0, 2.0], [8.0, 8.0], [2.0, 8.0]]), small(4.0, 3.0)]),
    ];
    for (i, result) in refused.into_iter().enumerate() {
        let error = result.unwrap_err();
        assert!(matches!(error, MeshError::OutlineNotSimple { section: 0, .. }), "{i}: {error:?}");
    }
    assert_eq!(swept(&prism(&square, &[], &[3.0, 3.0])).unwrap_err().code(), "degenerate-triangle");
    assert_eq!(swept(&prism(&square, &[], &[0.0])).unwrap_err().code(), "too-few");
    assert_eq!(swept(&prism(&square[..2], &[], &[0.0, 1.0])).unwrap_err().code(), "too-few");
    let mut unequal = prism(&square, &[], &[0.0, 1.0]);
    unequal[1].outline.pop();
    let error = swept(&unequal).unwrap_err();
    assert!(matches!(error, MeshError::WrongCount { expected: 4, found: 3, .. }), "{error:?}");
    unequal[1] = Section { outline: square, holes: vec![small(2.0, 2.0)] };
    assert_eq!(swept(&unequal).unwrap_err().code(), "wrong-count");
}

#[test]
fn a_patch_has_the_side_that_was_asked_for() {
    let points: Vec<_> =
        (0..12).map(|i| Vector3::new(f64::from(i / 4), 2.0 * f64::from(i % 4), 7.0)).collect();
    for (side, sign) in [(PatchSide::RowsTimesColumns, 1.0), (PatchSide::ColumnsTimesRows, -1.0)] {
        let mesh = patch(&points, 4, side).unwrap();
        assert_eq!(mesh.triangles.len(), 2 * 2 * 3);
        assert!((mesh.area() - 12.0).abs() < 1e-13);
        for [normal, ..] in read_stl(&stl(&mesh).unwrap()) {
            assert_eq!(normal, Vector3::new(0.0, 0.0, sign));
        }
        let open = mesh.check_watertight().unwrap_err();
        assert!(matches!(
            open,
            MeshError::NotWatertight { along: 1, against: 0, .. }
                | MeshError::NotWatertight { along: 0, against: 1, .. }
        ));
    }
    assert_eq!(patch(&points, 1, PatchSide::RowsTimesColumns).unwrap_err().code(), "too-few");
    assert_eq!(patch(&points, 12, PatchSide::RowsTimesColumns).unwrap_err().code(), "too-few");
    assert_eq!(patch(&points, 5, PatchSide::RowsTimesColumns).unwrap_err().code(), "wrong-count");
    assert_eq!(
        patch(&[Vector3::zeros(); 4], 2, PatchSide::RowsTimesColumns).unwrap_err().code(),
        "degenerate-triangle"
    );
}

#[test]
fn six_patches_weld_to_a_cube() {
    let face = |origin: [f64; 3], along: [f64; 3], up: [f64; 3]| {
        let (origin, along, up) = (Vector3::from(origin), Vector3::from(along), Vector3::from(up));
        let points: Vec<_> =
            (0..9).map(|i| origin + along * f64::from(i / 3) + up * f64::from(i % 3)).collect();
        patch(&points, 3, PatchSide::RowsTimesColumns).unwrap()
    };
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let (near, far) = ([-0.0; 3], [2.0; 3]);
    let back = |v: [f64; 3]| v.map(|c| -c);
    let mut faces = vec![face(near, y, x), face(near, z, y), face(near, x, z)];
    faces.extend([face(far, back(x), back(y)), face(far, back(y), back(z)), face(far, back(z), back(x))]);
    let loose = TriangleMesh::joined(&faces).unwrap();
    assert_eq!((loose.vertices.len(), loose.triangles.len()), (54, 48));
    assert_eq!(loose.check_watertight().unwrap_err().code(), "not-watertight");
    let cube = loose.welded();
    assert_eq!(cube.vertices.len(), 26);
    cube.check_watertight().unwrap();
    assert!((cube.volume() - 8.0).abs() < 1e-14);
    assert_eq!(cube.clone().turned().check_watertight(), Err(MeshError::NoVolume));

    faces[3] = faces[3].clone().turned();
    let error = TriangleMesh::joined(&faces).unwrap().welded().check_watertight().unwrap_err();
    assert!(
        matches!(
            error,
            MeshError::NotWatertight { along: 2, against: 0, .. }
                | MeshError::NotWatertight { along: 0, against: 2, .. }
        ),
        "{error:?}"
    );
}

#[test]
fn wrong_meshes_are_refused_by_every_writer() {
    let codes = |mesh: &TriangleMesh| {
        let object = NamedMesh { name: "body", mesh };
        [stl(mesh).unwrap_err(), three_mf("", &[object]).unwrap_err(), vtp_of_mesh(mesh, &[]).unwrap_err()]
            .map(|error| error.code())
    };
    for bad in [f64::NAN, f64::INFINITY, 1e30] {
        let mut mesh = cube();
        mesh.vertices[5].y = bad;
        assert_eq!(codes(&mesh), ["invalid-number"; 3]);
        let error = mesh.check().unwrap_err();
        assert!(matches!(error, MeshError::InvalidNumber { index: 5, .. }), "{error:?}");
    }
    let mut mesh = cube();
    mesh.triangles[3][1] = 8;
    assert_eq!(codes(&mesh), ["index-out-of-range"; 3]);
    assert_eq!(mesh.check(), Err(MeshError::IndexOutOfRange { triangle: 3, vertex: 8, vertices: 8 }));
    assert!(mesh.volume().is_finite() && mesh.area().is_finite());
    assert_eq!(
        TriangleMesh::joined(&[mesh.clone(), cube()]).unwrap().check().unwrap_err().code(),
        "index-out-of-range"
    );
    assert_eq!(mesh.welded().check().unwrap_err().code(), "index-out-of-range");

    let mut mesh = cube();
    mesh.triangles[4] = [1, 2, 2];
    assert_eq!(codes(&mesh), ["degenerate-triangle"; 3]);
    // Points on a line, but for the rounding of their coordinates.
    let direction = Vector3::new(0.3, 0.7, 0.1);
    let line = TriangleMesh {
        vertices: vec![direction, direction * 3.3, direction * 7.7],
        triangles: vec![[0, 1, 2]],
    };
    assert_eq!(line.check(), Err(MeshError::DegenerateTriangle { triangle: 0 }));
    assert_eq!(codes(&TriangleMesh::default()), ["too-few"; 3]);
}

#[test]
fn stl_holds_every_triangle_in_single_precision() {
    let outline = star(70, 30.0, 3.0, 0.0, 0.0);
    let body = swept(&prism(&outline, &[star(20, 9.0, 0.0, 0.0, 0.0)], &[-10.0, 10.0])).unwrap();
    let bytes = stl(&body).unwrap();
    let read = read_stl(&bytes);
    assert_eq!(read.len(), body.triangles.len());
    let mut volume = 0.0;
    for ([normal, a, b, c], corners) in read.iter().zip(&body.triangles) {
        for (corner, written) in corners.iter().zip([a, b, c]) {
            assert!((body.vertices[*corner as usize] - written).amax() < 2e-6);
        }
        let own = (b - a).cross(&(c - a)).normalize();
        assert!((normal - own).norm() < 1e-4, "{normal} {own}");
        volume += a.dot(&b.cross(c)) / 6.0;
    }
    assert!((volume / body.volume() - 1.0).abs() < 1e-6);
    assert_eq!(bytes, stl(&body).unwrap());
}

#[test]
fn three_mf_holds_all_objects() {
    let cube = cube();
    let flank = patch(&wave(5, 6), 6, PatchSide::ColumnsTimesRows).unwrap();
    let objects = [
        NamedMesh { name: "blank \"A\" <1> & more", mesh: &cube },
        NamedMesh { name: "flank\u{7}", mesh: &flank },
    ];
    let bytes = three_mf("Gear & pinion", &objects).unwrap();
    assert_eq!(bytes, three_mf("Gear & pinion", &objects).unwrap());

    let mut archive = ZipArchive::new(Cursor::new(&bytes)).unwrap();
    let names: Vec<String> =
        (0..archive.len()).map(|i| archive.by_index(i).unwrap().name().unwrap().into_owned()).collect();
    assert_eq!(names, ["[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"]);
    let date = archive.by_index(2).unwrap().last_modified().unwrap();
    assert_eq!((date.year(), date.month(), date.day(), date.hour()), (1980, 1, 1, 0));

    let types = unpack(&bytes, "[Content_Types].xml");
    let types = Document::parse(&types).unwrap();
    let type_of = |extension: &str| {
        types
            .descendants()
            .find(|n| n.attribute("Extension") == Some(extension))
            .unwrap()
            .attribute("ContentType")
    };
    assert_eq!(type_of("rels"), Some("application/vnd.openxmlformats-package.relationships+xml"));
    assert_eq!(type_of("model"), Some("application/vnd.ms-package.3dmanufacturing-3dmodel+xml"));
    let relationships = unpack(&bytes, "_rels/.rels");
    let relationships = Document::parse(&relationships).unwrap();
    let relationship = relationships
        .descendants()
        .find(|n| {
            n.has_tag_name(("http://schemas.openxmlformats.org/package/2006/relationships", "Relationship"))
        })
        .unwrap();
    assert_eq!(relationship.attribute("Target"), Some("/3D/3dmodel.model"));

    let model = unpack(&bytes, "3D/3dmodel.model");
    let model = Document::parse(&model).unwrap();
    let root = model.root_element();
    assert_eq!(
        root.tag_name().namespace(),
        Some("http://schemas.microsoft.com/3dmanufacturing/core/2015/02")
    );
    assert_eq!(root.attribute("unit"), Some("millimeter"));
    let metadata: Vec<_> = root
        .children()
        .filter(|n| n.tag_name().name() == "metadata")
        .map(|n| (n.attribute("name").unwrap(), n.text().unwrap()))
        .collect();
    assert_eq!(metadata[0], ("Title", "Gear & pinion"));
    assert!(metadata[1].0 == "Application" && metadata[1].1.starts_with("flankwright "));

    let named = |node: Node<'_, '_>, name: &str| node.tag_name().name() == name;
    let written: Vec<_> = root.descendants().filter(|n| named(*n, "object")).collect();
    let items: Vec<&str> =
        root.descendants().filter(|n| named(*n, "item")).map(|n| n.attribute("objectid").unwrap()).collect();
    assert_eq!(items, written.iter().map(|o| o.attribute("id").unwrap()).collect::<Vec<_>>());
    let kinds: Vec<_> =
        written.iter().map(|o| (o.attribute("name").unwrap(), o.attribute("type").unwrap())).collect();
    assert_eq!(kinds, [("blank \"A\" <1> & more", "model"), ("flank ", "surface")]);
    for (object, NamedMesh { mesh, .. }) in written.iter().zip(objects) {
        let vertices: Vec<_> = object
            .descendants()
            .filter(|n| named(*n, "vertex"))
            .map(|n| Vector3::new(attribute(n, "x"), attribute(n, "y"), attribute(n, "z")))
            .collect();
        let triangles: Vec<[u32; 3]> = object
            .descendants()
            .filter(|n| named(*n, "triangle"))
            .map(|n| [attribute(n, "v1"), attribute(n, "v2"), attribute(n, "v3")])
            .collect();
        assert_eq!(triangles, mesh.triangles);
        assert_eq!(vertices.len(), mesh.vertices.len());
        assert!(
            vertices
                .iter()
                .zip(&mesh.vertices)
                .all(|(read, own): (&Vector3<f64>, _)| (read - own).amax() <= 0.51e-6)
        );
    }
    assert_eq!(three_mf("", &[]).unwrap_err().code(), "too-few");
}

#[test]
fn numbers_of_a_three_mf_file_have_no_exponent_and_no_negative_zero() {
    let mut mesh = cube();
    mesh.vertices[0].x = -1e-12;
    mesh.vertices[1].y = 4.2e-7;
    mesh.vertices[6].z = 12345.5;
    let model = unpack(&three_mf("t", &[NamedMesh { name: "n", mesh: &mesh }]).unwrap(), "3D/3dmodel.model");
    let vertices: Vec<&str> = model.lines().filter(|line| line.starts_with("<vertex ")).collect();
    assert_eq!(vertices[0], r#"<vertex x="0" y="0" z="0"/>"#);
    assert_eq!(vertices[1], r#"<vertex x="10" y="0" z="0"/>"#);
    assert_eq!(vertices[6], r#"<vertex x="10" y="10" z="12345.5"/>"#);
}

#[test]
fn a_vtp_mesh_carries_values_at_its_vertices() {
    let points = wave(9, 14);
    let mesh = patch(&points, 14, PatchSide::RowsTimesColumns).unwrap();
    let deviation: Vec<f64> = points.iter().map(|p| 1000.0 * p.z / 3.0).collect();
    let text =
        vtp_of_mesh(&mesh, &[PointData { name: "deviation_um", values: PointValues::Scalars(&deviation) }])
            .unwrap();
    let document = Document::parse(&text).unwrap();
    let file = document.root_element();
    assert_eq!(file.attribute("type"), Some("PolyData"));
    let piece = child(child(file, "PolyData"), "Piece");
    assert_eq!(attribute::<usize>(piece, "NumberOfPoints"), points.len());
    assert_eq!(attribute::<usize>(piece, "NumberOfPolys"), mesh.triangles.len());
    assert_eq!(attribute::<usize>(piece, "NumberOfLines"), 0);
    assert_eq!(child(piece, "PointData").attribute("Scalars"), Some("deviation_um"));
    assert_eq!(numbers(&document, "Points"), flat(&points));
    assert_eq!(numbers(&document, "deviation_um"), deviation);
    let corners: Vec<f64> = mesh.triangles.iter().flatten().map(|&c| f64::from(c)).collect();
    assert_eq!(numbers(&document, "connectivity"), corners);
    let ends: Vec<f64> = (1..=mesh.triangles.len()).map(|i| 3.0 * i as f64).collect();
    assert_eq!(numbers(&document, "offsets"), ends);
}

#[test]
fn a_vtp_path_carries_scalars_rows_and_vectors() {
    let paths: Vec<Vec<Vector3<f64>>> = [5, 2, 9].map(|n| wave(1, n)).to_vec();
    let points = paths.concat();
    let axes: Vec<_> = points.iter().map(|p| Vector3::new(0.1 * p.x, p.y - 0.3, 1.0).normalize()).collect();
    let times: Vec<f64> = (0..16).map(|i| 0.01 * f64::from(i)).collect();
    let rows = [0, 0, 0, 0, 0, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, -7];
    let data = [
        PointData { name: "axis", values: PointValues::Vectors(&axes) },
        PointData { name: "block_time_s", values: PointValues::Scalars(&times) },
        PointData { name: "row <of> \"the\" flank", values: PointValues::Integers(&rows) },
    ];
    let text = vtp_of_paths(&paths, &data).unwrap();
    assert_eq!(text, vtp_of_paths(&paths, &data).unwrap());
    let document = Document::parse(&text).unwrap();
    let piece = document.descendants().find(|n| n.has_tag_name("Piece")).unwrap();
    assert_eq!(
        (attribute::<usize>(piece, "NumberOfPoints"), attribute::<usize>(piece, "NumberOfLines")),
        (16, 3)
    );
    assert_eq!(child(piece, "PointData").attribute("Scalars"), Some("block_time_s"));
    assert_eq!(numbers(&document, "Points"), flat(&points));
    assert_eq!(numbers(&document, "axis"), flat(&axes));
    assert_eq!(numbers(&document, "block_time_s"), times);
    assert_eq!(numbers(&document, "row <of> \"the\" flank"), rows.map(f64::from));
    assert_eq!(numbers(&document, "connectivity"), (0..16).map(f64::from).collect::<Vec<_>>());
    assert_eq!(numbers(&document, "offsets"), [5.0, 7.0, 16.0]);
}

#[test]
fn point_data_that_do_not_fit_are_refused() {
    let paths = [wave(1, 4)];
    let refused = |values| vtp_of_paths(&paths, &[PointData { name: "q", values }]).unwrap_err();
    assert_eq!(refused(PointValues::Scalars(&[0.0; 3])).code(), "wrong-count");
    assert_eq!(refused(PointValues::Integers(&[0; 5])).code(), "wrong-count");
    let error = refused(PointValues::Scalars(&[0.0, 1.0, f64::NAN, 2.0]));
    assert!(matches!(error, MeshError::InvalidNumber { index: 2, .. }), "{error:?}");
    let mut axes = [Vector3::x(); 4];
    axes[1].z = f64::INFINITY;
    let error = refused(PointValues::Vectors(&axes));
    assert!(matches!(error, MeshError::InvalidNumber { index: 1, value: f64::INFINITY, .. }), "{error:?}");
    let twice = [PointData { name: "q", values: PointValues::Integers(&[1; 4]) }; 2];
    assert_eq!(vtp_of_paths(&paths, &twice).unwrap_err().code(), "duplicate-name");
    assert_eq!(vtp_of_paths(&[], &[]).unwrap_err().code(), "too-few");
    assert_eq!(vtp_of_paths(&[wave(1, 2), wave(1, 1)], &[]).unwrap_err().code(), "too-few");
    let lost = vec![Vector3::x(), Vector3::repeat(f64::NAN)];
    assert_eq!(vtp_of_paths(&[lost], &[]).unwrap_err().code(), "invalid-number");
}

proptest! {
    /// A loop whose radius changes at random from point to point, with a bore: every end face closes, the volume is that of the prism.
    #[test]
    fn random_stars_make_closed_bodies(
        radii in prop::collection::vec(10.0..60.0f64, 3..80),
        bore in 3usize..30,
        tilt in -1.2..1.2f64,
        length in -50.0..50.0f64,
    ) {
        prop_assume!(length.abs() > 0.01);
        let around = |i: usize, n: usize| std::f64::consts::TAU * i as f64 / n as f64;
        let n = radii.len();
        let outline: Vec<_> = radii
            .iter()
            .enumerate()
            .map(|(i, r)| Vector3::new(r * around(i, n).cos(), r * around(i, n).sin(), 0.0))
            .collect();
        // The bore lies inside a triangle of three points at the smallest radius.
        let hole = star(bore, 3.0, 0.0, 0.0, 0.0);
        let area = trapezoids(&outline) - trapezoids(&hole);
        let mut sections = prism(&outline, &[hole], &[0.0, length]);
        let turn = nalgebra::Rotation3::from_scaled_axis(Vector3::new(1.0, 0.6, 0.2) * tilt);
        for section in &mut sections {
            section.outline.iter_mut().chain(section.holes.iter_mut().flatten()).for_each(|p| *p = turn * *p);
        }
        let body = swept(&sections).unwrap();
        prop_assert!((body.volume() / (area * length.abs()) - 1.0).abs() < 1e-10);
        prop_assert_eq!(read_stl(&stl(&body).unwrap()).len(), body.triangles.len());
    }
}
