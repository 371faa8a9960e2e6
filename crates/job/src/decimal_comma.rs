//! Tables as spreadsheets of countries with a decimal comma write them: `;` between the cells, `,` in the numbers.

use std::borrow::Cow;

/// The text with `,` between cells and `.` in numbers, byte for byte where it was, so that places in it stay. A text whose first line
/// has commas or no semicolon stays as it is, and so do comments.
pub fn with_points(text: &str) -> Cow<'_, str> {
    let is_row = |line: &&str| !line.trim().is_empty() && !line.starts_with('#');
    let titles = text.split(['\n', '\r']).find(is_row).unwrap_or_default();
    if !titles.contains(';') || titles.contains(',') {
        return Cow::Borrowed(text);
    }
    let line = |line: &str| {
        if is_row(&line) { line.replace(',', ".").replace(';', ",") } else { line.to_owned() }
    };
    Cow::Owned(text.split_inclusive(['\n', '\r']).map(line).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn semicolons_part_cells_and_commas_are_points() {
        let german = "# 1,5; kept\r\nw_mm;z_mm;f_um\r\n1,5;-2,0;3\r\n";
        assert_eq!(with_points(german), "# 1,5; kept\r\nw_mm,z_mm,f_um\r\n1.5,-2.0,3\r\n");
        let plain = "w_mm,z_mm,f_um\n1.5,-2.0,3\n";
        assert!(matches!(with_points(plain), Cow::Borrowed(same) if same == plain));
        // Neither the one nor the other: told by the reader of the table.
        assert_eq!(with_points("a;b,c\n1;2,3\n"), "a;b,c\n1;2,3\n");
    }
}
