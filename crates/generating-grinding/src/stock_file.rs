//! Stock as a table: CSV with the columns flank, w_mm, z_mm and um, and space where each tooth space has its own. Reads and writes it.

use foundation::geometry::{Flank, Sides};
use grinding_technology::{StockMap, TechnologyError};
use job::decimal_comma::with_points;
use job::table_rows::{Row, TableForm};
use job::{Cell, Column, CsvError, CsvTable, Diagnostic, JobError, Problem, Source};
use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::path::Path;

const FORM: TableForm<4> = TableForm {
    columns: ["flank", "w_mm", "z_mm", "um"],
    optional: Some("space"),
    row: "each place of a grid over length of roll and face width",
};
/// No stock is more than this, um.
const MOST_UM: f64 = 5000.0;

/// Amounts on the places of a grid, um.
type Amounts = BTreeMap<Place, f64>;

/// A place with an order.
#[derive(Clone, Copy, Debug)]
struct Place(f64, f64);

impl Ord for Place {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0).then(self.1.total_cmp(&other.1))
    }
}

impl PartialOrd for Place {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Place {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Place {}

/// Stock that a table adds on each flank; `None` for a flank without rows.
#[derive(Clone, Debug, PartialEq)]
pub struct StockTable {
    /// The amounts, mm.
    pub flanks: Sides<Option<StockMap>>,
    /// Spaces of a flank that the table does not have, which get the mean of those that it has.
    pub left_out: Sides<usize>,
}

/// Reads the stock of a gear with so many tooth spaces.
///
/// # Errors
/// Those of [`Source::read`]; `invalid-table`, `unknown-value`, `invalid-number` with line, column and value.
pub fn read_stock(path: &Path, spaces: usize) -> Result<StockTable, JobError> {
    parse_stock(Source::read(path)?, spaces)
}

/// As [`read_stock`], from a text.
///
/// # Errors
/// As [`read_stock`].
pub fn parse_stock(source: Source, spaces: usize) -> Result<StockTable, JobError> {
    table(source.text(), spaces).map_err(|finding| JobError::single(source, finding))
}

/// The rows of a table that [`read_stock`] reads.
///
/// # Errors
/// [`CsvError`] for numbers that are not finite.
pub fn stock_table(flanks: &Sides<Option<MeasuredStock>>) -> Result<CsvTable, CsvError> {
    let mut table =
        CsvTable::new(&["flank", "space", "w_mm", "z_mm", "um"].map(|name| Column::new(name, "")));
    for (flank, of_flank) in flanks.iter() {
        let Some(MeasuredStock { w, z, spaces }) = of_flank else { continue };
        for (space, amounts) in spaces {
            for (k, um) in amounts.iter().enumerate() {
                table.push_cells(&[
                    Cell::Word(flank.name()),
                    Cell::Number(*space as f64),
                    Cell::Number(w[k / z.len()]),
                    Cell::Number(z[k % z.len()]),
                    Cell::Number(*um),
                ])?;
            }
        }
    }
    Ok(table)
}

/// Stock of one flank as it was measured.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredStock {
    /// Lengths of roll, mm.
    pub w: Vec<f64>,
    /// Heights, mm.
    pub z: Vec<f64>,
    /// Numbers of tooth spaces with their amounts `[w][z]`, um.
    pub spaces: Vec<(usize, Vec<f64>)>,
}

fn table(text: &str, spaces: usize) -> Result<StockTable, Diagnostic> {
    let mut found: Sides<BTreeMap<Option<usize>, Amounts>> = Sides::both(BTreeMap::new());
    for row in FORM.rows(&with_points(text))? {
        let flank = row.flank(0)?;
        let space = space_of(&row, spaces)?;
        let place = Place(row.length_of_roll(1)?, row.number(2)?);
        let within = |um: &f64| um.abs() <= MOST_UM;
        let um: f64 = row.parsed(3, &format!("um, from -{MOST_UM} to {MOST_UM}"), within)?;
        if found[flank].entry(space).or_default().insert(place, um).is_some() {
            let text =
                format!("the place w = {}, z = {} stands twice on the {flank} flank", place.0, place.1);
            return Err(FORM
                .malformed(text)
                .value(format!("{} mm, {} mm", place.0, place.1))
                .way_out("delete one of the two rows")
                .span(Some(row.place())));
        }
    }
    let mut left_out = Sides::both(0);
    let flanks = Sides::try_from_fn(|flank| {
        let of_flank = &found[flank];
        if of_flank.is_empty() {
            return Ok(None);
        }
        let (map, missing) = grid(flank, of_flank, spaces)?;
        left_out[flank] = missing;
        Ok::<_, Diagnostic>(Some(map))
    })?;
    Ok(StockTable { flanks, left_out })
}

/// Number of the tooth space of a row; `None` where the table is for all.
fn space_of(row: &Row<'_, 4>, spaces: usize) -> Result<Option<usize>, Diagnostic> {
    let Some(cell) = row.optional() else { return Ok(None) };
    match cell.parse().ok().filter(|space| *space < spaces) {
        Some(space) => Ok(Some(space)),
        None => Err(row
            .wrong_optional(Problem::InvalidNumber, format!("a whole number from 0 to {}", spaces - 1))
            .way_out("number the tooth spaces from 0 in the sense of rising angle, or leave the column out")),
    }
}

/// The grid of a flank, and how many spaces it has not.
fn grid(
    flank: Flank,
    of_flank: &BTreeMap<Option<usize>, Amounts>,
    spaces: usize,
) -> Result<(StockMap, usize), Diagnostic> {
    let places = |of: fn(&Place) -> f64| {
        let mut all: Vec<f64> = of_flank.values().flat_map(|amounts| amounts.keys().map(of)).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    };
    let (w, z) = (places(|place| place.0), places(|place| place.1));
    let count = w.len() * z.len();
    if let Some((space, amounts)) = of_flank.iter().find(|(_, amounts)| amounts.len() != count) {
        let of = space.map_or(String::new(), |space| format!(" in space {space}"));
        return Err(FORM
            .malformed(format!("the rows of the {flank} flank{of} form no full grid"))
            .value(format!("{} rows for {} x {} values of w_mm and z_mm", amounts.len(), w.len(), z.len()))
            .way_out("give every pair of w_mm and z_mm once, in each space the same"));
    }
    // Keys are in order: first by w, then by z.
    let mm = |amounts: &Amounts| -> Vec<f64> { amounts.values().map(|um| 1e-3 * um).collect() };
    let listed: Vec<Vec<f64>> = of_flank.values().map(mm).collect();
    let (all, missing) = if of_flank.contains_key(&None) {
        (listed, 0)
    } else {
        let share = 1.0 / listed.len() as f64;
        let mean: Vec<f64> =
            (0..count).map(|k| share * listed.iter().map(|one| one[k]).sum::<f64>()).collect();
        let of_space = |space: usize| of_flank.get(&Some(space)).map_or_else(|| mean.clone(), mm);
        ((0..spaces).map(of_space).collect(), spaces - listed.len())
    };
    let refused = |error: TechnologyError| FORM.malformed(error.to_string()).way_out("correct the table");
    Ok((StockMap::new(w, z, all).map_err(refused)?, missing))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<StockTable, JobError> {
        parse_stock(Source::new("stock.csv", text), 3)
    }

    #[test]
    fn a_table_without_spaces_is_for_all() {
        let table =
            read("flank,w_mm,z_mm,um\nleft,5,-1,100\nleft,5,1,110\nleft,9,-1,120\nleft,9,1,130\n").unwrap();
        assert!(table.flanks.right.is_none());
        assert_eq!(table.flanks.left.unwrap().spaces(), 1);
        assert_eq!(table.left_out, Sides::both(0));
    }

    #[test]
    fn what_is_written_comes_back() {
        let measured = MeasuredStock {
            w: vec![5.0, 9.0],
            z: vec![-1.0, 1.0],
            spaces: vec![(0, vec![100.0, 110.0, 120.0, 130.0]), (1, vec![90.0; 4]), (2, vec![80.5; 4])],
        };
        let text = stock_table(&Sides { left: Some(measured), right: None }).unwrap();
        let table = read(text.text()).unwrap();
        let map = table.flanks.left.unwrap();
        let want = StockMap::new(
            vec![5.0, 9.0],
            vec![-1.0, 1.0],
            vec![vec![0.1, 0.11, 0.12, 0.13], vec![0.09; 4], vec![0.0805; 4]],
        );
        assert_eq!(map, want.unwrap());
    }

    #[test]
    fn spaces_that_are_not_there_get_the_mean() {
        let table = read("flank,space,w_mm,z_mm,um\nright,0,5,0,100\nright,2,5,0,120\n").unwrap();
        assert_eq!(table.left_out, Sides { left: 0, right: 1 });
        let want = StockMap::new(vec![5.0], vec![0.0], vec![vec![0.1], vec![0.11], vec![0.12]]).unwrap();
        assert_eq!(table.flanks.right, Some(want));
    }

    #[test]
    fn what_is_wrong_is_told_with_its_place() {
        for (rows, code, says) in [
            ("flank,w_mm,z_mm,um\nleft,5,0,nine\n", "invalid-number", "um"),
            ("flank,w_mm,z_mm,um\nleft,5,0,9000\n", "invalid-number", "5000"),
            ("flank,space,w_mm,z_mm,um\nleft,3,5,0,9\n", "invalid-number", "from 0 to 2"),
            ("flank,w_mm,z_mm,um\nup,5,0,9\n", "unknown-value", "left or right"),
            ("flank,w_mm,z_mm,um\nleft,5,0,9\nleft,5,0,8\n", "invalid-table", "twice"),
            ("flank,w_mm,z_mm,um\nleft,5,0,9\nleft,6,1,8\n", "invalid-table", "no full grid"),
            ("flank,w_mm,um\nleft,5,9\n", "invalid-table", "z_mm"),
        ] {
            let error = read(rows).unwrap_err();
            let finding = &error.diagnostics[0];
            assert!(finding.code == code && finding.to_string().contains(says), "{rows}: {error}");
        }
    }
}
