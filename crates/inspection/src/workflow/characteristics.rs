//! What statistics are made of: every figure of a measured part under a name that is the same on all parts, with the limits of a class, and
//! to which series the part belongs.

use super::result::{GearInspectionResult, TraceInspectionResult};
use super::run::GearInspection;
use foundation::geometry::Flank;
use measured_files::inspection::measured_at;
use metrology::inspection::{ToleranceQuantity, Tolerances};
use std::collections::{BTreeMap, HashMap};

/// The value as it stands: of one tooth, or of the whole gear.
pub const SINGLE: &str = "single";
/// Units.
const UM: &str = "um";
const NONE: &str = "1";

/// Which part it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PartIdentity {
    /// The series whose trend it belongs to: its drawing, else the name of the gear, else teeth and module.
    pub series: String,
    /// Its number, else the name of its file.
    pub part: String,
    /// When its measurement began, in a form that sorts as text; none where the file's date could be read in two ways.
    pub time: Option<String>,
}

impl PartIdentity {
    /// Of an evaluated part.
    pub fn of(found: &GearInspection) -> Self {
        let head = |key: &str| {
            let text = found.result.head.get(key).map(|text| text.trim());
            text.filter(|text| !text.is_empty()).map(str::to_owned)
        };
        let gear = &found.inspection.gear;
        let body = || format!("z {} mn {}", gear.teeth, gear.normal_module_mm);
        let date = found.inspection.date.as_ref();
        Self {
            series: head("drawing").or_else(|| head("name")).unwrap_or_else(body),
            part: head("part").unwrap_or_else(|| found.result.job.clone()),
            time: date.and_then(|date| measured_at(date, found.inspection.time.as_deref())),
        }
    }
}

/// A figure of a part.
#[derive(Clone, Debug, PartialEq)]
pub struct PartCharacteristic {
    /// Symbol, e.g. `fHa`, `Fp`; of a line beside the middle one with its mark behind a point, e.g. `fHa.o`.
    pub name: String,
    /// Flank, where it is one of a flank.
    pub flank: Option<Flank>,
    /// Tooth as the machine counts, where it is one of a tooth.
    pub tooth: Option<u32>,
    /// What was made of single values: `single`, `mean`, `range` or `max`; a line that was measured again is `single-2`.
    pub statistic: String,
    /// Its unit.
    pub unit: &'static str,
    /// The value.
    pub value: f64,
    /// Lower limit, in the same unit.
    pub lower_limit: Option<f64>,
    /// Upper limit, in the same unit.
    pub upper_limit: Option<f64>,
}

/// One word for a characteristic, e.g. `fHa.left.mean`, `ffb.right.tooth-18.single`, `Fr.single`: the same in every version.
pub fn characteristic_key(name: &str, flank: Option<Flank>, tooth: Option<u32>, statistic: &str) -> String {
    let flank = flank.map(|flank| flank.name().to_owned());
    let tooth = tooth.map(|tooth| format!("tooth-{tooth}"));
    let words = [Some(name.to_owned()), flank, tooth, Some(statistic.to_owned())];
    words.into_iter().flatten().collect::<Vec<_>>().join(".")
}

/// The word of a characteristic as pages print it: `f_Hα, left flank, mean` for `fHa.left.mean`.
pub fn characteristic_in_words(key: &str) -> String {
    let mut words = key.split('.');
    let mut printed = vec![match words.next().unwrap_or_default() {
        "x-span" => "x from the span".to_owned(),
        "x-balls" => "x over balls".to_owned(),
        "class" => "class".to_owned(),
        symbol => symbol_with_index(symbol),
    }];
    printed.extend(words.filter_map(|word| match word {
        "left" | "right" => Some(format!("{word} flank")),
        SINGLE => None,
        "max" => Some("largest".to_owned()),
        _ => Some(match (word.strip_prefix("tooth-"), word.strip_prefix("single-")) {
            (Some(tooth), _) => format!("tooth {tooth}"),
            (None, Some(number)) => format!("measurement {number}"),
            (None, None) => word.to_owned(),
        }),
    }));
    printed.join(", ")
}

/// `f_Hα` for `fHa`, `F_p` for `Fp`.
fn symbol_with_index(symbol: &str) -> String {
    let mut letters = symbol.chars();
    let Some(first) = letters.next() else { return String::new() };
    let index = letters.as_str();
    let greek = [("Ha", "Hα"), ("Hb", "Hβ"), ("fa", "fα"), ("fb", "fβ"), ("a", "α"), ("b", "β")];
    let index = greek.iter().find(|(plain, _)| *plain == index).map_or(index, |(_, greek)| *greek);
    if index.is_empty() { symbol.to_owned() } else { format!("{first}_{index}") }
}

/// All figures of a part: single teeth, what was made of them (slopes are judged by their mean, total and form deviations by the largest),
/// pitch, run-out, thickness, class. With a class of ISO 1328-1 its tolerances are the limits, where the standard has them for the gear.
pub fn part_characteristics(found: &GearInspection, class: Option<i32>) -> Vec<PartCharacteristic> {
    let limits = found.gear.tolerances.as_ref().zip(class).map(|(t, class)| limits(t, class));
    let mut list = List { limits: limits.unwrap_or_default(), values: Vec::new(), repeated: HashMap::new() };
    let result = &found.result;
    for trace in &result.traces {
        for (figure, value) in figures(trace) {
            list.push(
                &name(trace.kind, figure, &trace.tag),
                side(trace.flank),
                Some(trace.tooth),
                SINGLE,
                value,
            );
        }
    }
    list.lines(result);
    for (flank, pitch) in &result.pitch {
        for (symbol, value) in [
            ("fp", pitch.single_um),
            ("fu", pitch.neighbours_um),
            ("Rp", pitch.range_um),
            ("Fp", pitch.total_um),
            ("Fpk", pitch.sector_um),
        ] {
            list.push(symbol, side(flank), None, SINGLE, value);
        }
    }
    for (symbol, value, unit) in [
        ("Rs", result.thickness_variation_um, UM),
        ("Fr", result.run_out_um, UM),
        ("fe", result.eccentricity.map(|[amount, _]| amount), UM),
        ("x-span", result.thickness.x_from_span, NONE),
        ("x-balls", result.thickness.x_from_balls, NONE),
        ("class", result.class.map(f64::from), NONE),
    ] {
        let Some(value) = value else { continue };
        list.push(symbol, None, None, SINGLE, value);
        if let Some(last) = list.values.last_mut() {
            last.unit = unit;
        }
    }
    list.values
}

/// Figures of a trace by the words of summaries.
fn figures(trace: &TraceInspectionResult) -> impl Iterator<Item = (&'static str, f64)> {
    let always =
        [("fH", trace.slope_um), ("F", trace.total_um), ("ff", trace.form_um), ("C", trace.crowning_um)];
    always.into_iter().chain(trace.tip_relief_um.map(|value| ("fKo", value)))
}

/// Whether the standard judges it: slopes by their mean over the teeth, everything else value by value.
fn is_judged(name: &str, statistic: &str) -> bool {
    if name.starts_with("fH") { statistic == "mean" } else { matches!(statistic, SINGLE | "max") }
}

/// `fHa` from profile and fH; of a marked line with its mark, `fHa.o`.
fn name(kind: &str, figure: &str, tag: &str) -> String {
    let index = match (kind, figure) {
        (_, "fKo") => "",
        ("profile", _) => "a",
        _ => "b",
    };
    let mark = if tag.is_empty() { "" } else { "." };
    format!("{figure}{index}{mark}{tag}")
}

fn side(word: &str) -> Option<Flank> {
    Flank::BOTH.into_iter().find(|flank| flank.name() == word)
}

/// Lower and upper limits of the symbols of the standard, um.
fn limits(tolerances: &Tolerances, class: i32) -> Vec<(&'static str, [Option<f64>; 2])> {
    let of = |quantity: ToleranceQuantity| {
        // Whole nm, so that the limit in um is the number of the tables.
        let upper = (1e6 * tolerances.rounded(quantity, class).ok()?).round() / 1e3;
        // Slopes have a sign; everything else is a range or a largest amount.
        let slope = matches!(quantity, ToleranceQuantity::ProfileSlope | ToleranceQuantity::HelixSlope);
        Some((quantity.symbol(), [slope.then_some(-upper), Some(upper)]))
    };
    let verified = ToleranceQuantity::ALL.into_iter().filter(|quantity| !quantity.is_informative());
    verified.filter_map(of).collect()
}

/// Name, flank, tooth and statistic.
type Line = (String, Option<Flank>, Option<u32>, &'static str);

struct List {
    limits: Vec<(&'static str, [Option<f64>; 2])>,
    values: Vec<PartCharacteristic>,
    /// How often a line of a tooth was measured.
    repeated: HashMap<Line, u32>,
}

impl List {
    /// Means and ranges of the lines, and the largest of what is judged tooth by tooth.
    fn lines(&mut self, result: &GearInspectionResult) {
        let mut largest: BTreeMap<(&str, &str, &str, &str), f64> = BTreeMap::new();
        for trace in &result.traces {
            for (figure, value) in [("F", trace.total_um), ("ff", trace.form_um)] {
                let most = largest.entry((trace.kind, trace.flank, &trace.tag, figure)).or_insert(value);
                *most = most.max(value);
            }
        }
        for kind in ["profile", "helix"] {
            for row in result.summary.iter().filter(|row| row.kind == kind) {
                let (name, flank) = (name(kind, row.characteristic, &row.tag), side(row.flank));
                self.push(&name, flank, None, "mean", row.mean_um);
                if let Some(range) = row.range_um {
                    self.push(&name, flank, None, "range", range);
                }
                if let Some(most) = largest.get(&(kind, row.flank, &row.tag, row.characteristic)) {
                    self.push(&name, flank, None, "max", *most);
                }
            }
        }
    }

    fn push(
        &mut self,
        name: &str,
        flank: Option<Flank>,
        tooth: Option<u32>,
        statistic: &'static str,
        value: f64,
    ) {
        let times = self.repeated.entry((name.to_owned(), flank, tooth, statistic)).or_insert(0);
        *times += 1;
        // A line that was measured again is a value of its own.
        let word = if *times > 1 { format!("{statistic}-{times}") } else { statistic.to_owned() };
        let known = self.limits.iter().find(|(of, _)| *of == name && is_judged(name, statistic));
        let [lower_limit, upper_limit] = known.map_or([None; 2], |(_, limits)| *limits);
        self.values.push(PartCharacteristic {
            name: name.to_owned(),
            flank,
            tooth,
            statistic: word,
            unit: UM,
            value,
            lower_limit,
            upper_limit,
        });
    }
}

#[cfg(test)]
mod tests {
    use super::characteristic_in_words;

    #[test]
    fn words_of_pages_are_no_keys() {
        for (key, words) in [
            ("fHa.left.mean", "f_Hα, left flank, mean"),
            ("Fb.right.max", "F_β, right flank, largest"),
            ("ffb.right.tooth-18.single", "f_fβ, right flank, tooth 18"),
            ("fHa.o.left.single-2", "f_Hα, o, left flank, measurement 2"),
            ("fKo.left.range", "f_Ko, left flank, range"),
            ("Fr.single", "F_r"),
            ("fp.left.single", "f_p, left flank"),
            ("x-span.single", "x from the span"),
        ] {
            assert_eq!(characteristic_in_words(key), words);
        }
    }
}
