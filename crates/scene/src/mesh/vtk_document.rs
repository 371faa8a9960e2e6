//! The frame of a VTK XML file with its numbers behind the structure, in base64 (encoding of the VTK file formats, `appended`).

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use job::xml::escape;
use nalgebra::Vector3;
use std::fmt::Write;

/// Arrays whose place in the appended data is known when they are named.
#[derive(Debug, Default)]
pub(super) struct VtkDocument {
    structure: String,
    data: String,
}

impl VtkDocument {
    /// Adds a line of structure.
    pub(super) fn line(&mut self, text: &str) {
        self.structure.push_str(text);
        self.structure.push('\n');
    }

    /// Adds an array of numbers.
    pub(super) fn numbers(&mut self, name: &str, values: &[f64]) {
        self.array(name, "Float64", 1, values.iter().flat_map(|v| v.to_le_bytes()).collect());
    }

    /// Adds an array of vectors.
    pub(super) fn vectors(&mut self, name: &str, values: &[Vector3<f64>]) {
        let bytes = values.iter().flat_map(|v| [v.x, v.y, v.z]).flat_map(f64::to_le_bytes).collect();
        self.array(name, "Float64", 3, bytes);
    }

    /// Adds an array of whole numbers.
    pub(super) fn integers(&mut self, name: &str, values: impl Iterator<Item = i32>) {
        self.array(name, "Int32", 1, values.flat_map(i32::to_le_bytes).collect());
    }

    fn array(&mut self, name: &str, kind: &str, components: usize, bytes: Vec<u8>) {
        // Writing to a text cannot fail.
        let _ = writeln!(
            self.structure,
            r#"<DataArray type="{kind}" Name="{}" NumberOfComponents="{components}" format="appended" offset="{}"/>"#,
            escape(name),
            self.data.len()
        );
        // The number of bytes and the bytes are one piece of base64.
        let mut block = (bytes.len() as u64).to_le_bytes().to_vec();
        block.extend(bytes);
        STANDARD.encode_string(&block, &mut self.data);
    }

    /// The whole file of a type, e.g. `PolyData`.
    pub(super) fn finish(self, kind: &str) -> String {
        let Self { structure, data } = self;
        format!(
            "<?xml version=\"1.0\"?>\n\
             <VTKFile type=\"{kind}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
             <{kind}>\n{structure}</{kind}>\n\
             <AppendedData encoding=\"base64\">\n_{data}\n</AppendedData>\n</VTKFile>\n"
        )
    }
}
