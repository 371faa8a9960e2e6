//! 3MF: a package of several named bodies in mm, as the core specification 1.3 of the 3MF Consortium has it.

use super::error::MeshError;
use super::triangle_mesh::TriangleMesh;
use job::xml::escape;
use std::io::{self, BufWriter, Cursor, Write};
use zip::result::ZipError;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, System, ZipWriter};

const CONTENT_TYPES: &str = concat!(
    r#"<?xml version="1.0" encoding="UTF-8"?>"#,
    "\n",
    r#"<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">"#,
    r#"<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>"#,
    r#"<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>"#,
    "</Types>\n"
);

const RELATIONSHIPS: &str = concat!(
    r#"<?xml version="1.0" encoding="UTF-8"?>"#,
    "\n",
    r#"<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">"#,
    r#"<Relationship Id="model" Target="/3D/3dmodel.model" "#,
    r#"Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>"#,
    "</Relationships>\n"
);

/// Positions are written in whole nanometres: a thousandth of what a machine resolves, half the text of all digits.
const PER_MILLIMETRE: f64 = 1e6;

/// Longest text of a vertex and of a triangle, bytes; beyond 4 GiB the package needs the wide form of its directory.
const LONGEST_LINE: usize = 96;

/// A mesh with the name under which other programs show it.
#[derive(Clone, Copy, Debug)]
pub struct NamedMesh<'a> {
    /// The name.
    pub name: &'a str,
    /// The mesh, mm.
    pub mesh: &'a TriangleMesh,
}

/// Meshes as one 3MF package (mm), each an object of its own, all in the build. A closed mesh becomes an object of type `model`, an
/// open one of type `surface`. Positions are rounded to 1 nm. The package holds no time: the same meshes give the same bytes.
///
/// # Errors
/// [`MeshError::TooFew`] without an object, those of [`TriangleMesh::check`] for each; [`MeshError::Package`] if the package becomes
/// larger than the format allows.
pub fn three_mf(title: &str, objects: &[NamedMesh<'_>]) -> Result<Vec<u8>, MeshError> {
    if objects.is_empty() {
        return Err(MeshError::TooFew { what: "objects of a 3MF file", least: 1, found: 0 });
    }
    let mut kinds = Vec::with_capacity(objects.len());
    for object in objects {
        kinds.push(match object.mesh.check_watertight() {
            Ok(()) => "model",
            Err(MeshError::NotWatertight { .. } | MeshError::NoVolume) => "surface",
            Err(error) => return Err(error),
        });
    }
    package(title, objects, &kinds).map_err(|error| MeshError::Package { reason: error.to_string() })
}

fn package(title: &str, objects: &[NamedMesh<'_>], kinds: &[&str]) -> Result<Vec<u8>, ZipError> {
    let lines: usize = objects.iter().map(|o| o.mesh.vertices.len() + o.mesh.triangles.len()).sum();
    // System and rights are fixed, too, so that every machine writes the same bytes.
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .last_modified_time(DateTime::DEFAULT)
        .system(System::Unix)
        .unix_permissions(0o644);
    let mut package = ZipWriter::new(Cursor::new(Vec::new()));
    for (path, text) in [("[Content_Types].xml", CONTENT_TYPES), ("_rels/.rels", RELATIONSHIPS)] {
        package.start_file(path, options)?;
        package.write_all(text.as_bytes())?;
    }
    package.start_file("3D/3dmodel.model", options.large_file(lines > u32::MAX as usize / LONGEST_LINE))?;
    let mut text = BufWriter::with_capacity(1 << 16, &mut package);
    write_model(&mut text, title, objects, kinds)?;
    text.flush()?;
    drop(text);
    Ok(package.finish()?.into_inner())
}

fn write_model(
    text: &mut impl Write,
    title: &str,
    objects: &[NamedMesh<'_>],
    kinds: &[&str],
) -> io::Result<()> {
    writeln!(text, r#"<?xml version="1.0" encoding="UTF-8"?>"#)?;
    let namespace = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
    writeln!(text, r#"<model unit="millimeter" xml:lang="en-US" xmlns="{namespace}">"#)?;
    writeln!(text, r#"<metadata name="Title">{}</metadata>"#, escape(title))?;
    writeln!(text, r#"<metadata name="Application">flankwright {}</metadata>"#, env!("CARGO_PKG_VERSION"))?;
    writeln!(text, "<resources>")?;
    for (i, (object, kind)) in objects.iter().zip(kinds).enumerate() {
        writeln!(text, r#"<object id="{}" type="{kind}" name="{}"><mesh>"#, i + 1, escape(object.name))?;
        write_mesh(text, object.mesh)?;
        writeln!(text, "</mesh></object>")?;
    }
    writeln!(text, "</resources>\n<build>")?;
    for id in 1..=objects.len() {
        writeln!(text, r#"<item objectid="{id}"/>"#)?;
    }
    writeln!(text, "</build>\n</model>")
}

fn write_mesh(text: &mut impl Write, mesh: &TriangleMesh) -> io::Result<()> {
    writeln!(text, "<vertices>")?;
    for vertex in &mesh.vertices {
        // Adding zero turns -0 into 0.
        let [x, y, z] =
            [vertex.x, vertex.y, vertex.z].map(|c| (c * PER_MILLIMETRE).round() / PER_MILLIMETRE + 0.0);
        writeln!(text, r#"<vertex x="{x}" y="{y}" z="{z}"/>"#)?;
    }
    writeln!(text, "</vertices>\n<triangles>")?;
    for [a, b, c] in &mesh.triangles {
        writeln!(text, r#"<triangle v1="{a}" v2="{b}" v3="{c}"/>"#)?;
    }
    writeln!(text, "</triangles>")
}
