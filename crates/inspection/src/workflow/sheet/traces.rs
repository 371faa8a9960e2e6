//! Rows of traces: one for each line of the flanks that was measured, the middle one first.

use super::super::evaluate::{EvaluatedTrace, trace_name};
use super::Filling;
use crate::page::sheet::{
    JudgedBy, LineLook, ScaleLine, SheetBand, SheetCharacteristic, SheetLimits, SheetTrace, TraceField,
    TraceRow,
};
use foundation::geometry::{Flank, Sides};
use measured_files::inspection::{Section, Trace, TraceKind};
use metrology::inspection::{
    BandFit, BandVerdict, KBand, MeasuredSection, TeethSummary, ToleranceQuantity, TraceSamples,
};
use report::charts::{format_fixed, format_significant};

/// Deviations beyond this are no measurement of a tooth, um.
const LARGEST_UM: f64 = 1e7;

/// Symbols and judged quantities of slope, total and form deviation, then the symbol of the crowning.
type Names = ([(&'static str, ToleranceQuantity); 3], &'static str);

impl Filling<'_> {
    /// Rows with the first of the profiles and the first of the helix traces in front, and what is not drawn.
    pub(super) fn rows(&self) -> (Vec<TraceRow>, Vec<String>) {
        let evaluated = self.evaluated();
        let mut undrawn = Vec::new();
        let [mut first, mut further] = [Vec::new(), Vec::new()];
        for kind in [TraceKind::Profile, TraceKind::Helix] {
            let mut rows =
                self.tags(kind).into_iter().map(|tag| self.row(kind, &tag, &evaluated, &mut undrawn));
            first.push(rows.next().unwrap_or_else(|| self.empty_row(kind)));
            further.extend(rows);
        }
        (first.into_iter().chain(further).collect(), undrawn)
    }

    /// The evaluation of each trace, where there is one.
    fn evaluated(&self) -> Vec<Option<&EvaluatedTrace>> {
        let mut list = vec![None; self.inspection.traces.len()];
        for one in &self.gear.traces {
            if let Some(place) = list.get_mut(one.trace) {
                *place = Some(one);
            }
        }
        list
    }

    /// Marks of the lines that were measured: none first, then from root to tip or from below upwards.
    fn tags(&self, kind: TraceKind) -> Vec<String> {
        let of_kind = self.inspection.traces.iter().filter(|trace| trace.kind == kind);
        let mut tags: Vec<&str> = of_kind.map(|trace| trace.tag.as_str()).collect();
        let rank = |tag: &str| match tag {
            "" => 0,
            "u" | "f" => 1,
            "o" | "k" => 2,
            _ => 3,
        };
        tags.sort_by_key(|tag| (rank(tag), *tag));
        tags.dedup();
        tags.into_iter().map(str::to_owned).collect()
    }

    fn row(
        &self,
        kind: TraceKind,
        tag: &str,
        evaluated: &[Option<&EvaluatedTrace>],
        undrawn: &mut Vec<String>,
    ) -> TraceRow {
        let of_row = |flank: Flank| {
            let all = self.inspection.traces.iter().zip(evaluated);
            all.filter(move |(t, _)| t.kind == kind && t.flank == flank && t.tag == tag)
        };
        let mut row = self.empty_row(kind);
        let all = || Flank::BOTH.into_iter().flat_map(of_row);
        row.name = row_name(kind, tag, all().map(|(trace, _)| trace.position_mm));
        row.slope_words = self.slope_words(kind, all().filter_map(|(_, one)| *one));
        row.flanks = Sides::from_fn(|flank| {
            let traces: Vec<(&Trace, Option<&EvaluatedTrace>)> =
                of_row(flank).map(|(t, e)| (t, *e)).collect();
            self.field(kind, flank, &traces, undrawn)
        });
        row
    }

    /// A row without traces.
    pub(super) fn empty_row(&self, kind: TraceKind) -> TraceRow {
        let (name, slope_words) = (row_name(kind, "", [].into_iter()), String::new());
        let flanks = Sides::default();
        let external = self.inspection.gear.teeth > 0;
        match kind {
            TraceKind::Profile => TraceRow {
                name,
                coordinate: "w".into(),
                rising: external,
                top: "tip".into(),
                bottom: "root".into(),
                scale: "d mm".into(),
                slope_words,
                flanks,
            },
            TraceKind::Helix if self.options.top_up => TraceRow {
                name,
                coordinate: "z".into(),
                rising: true,
                top: "top, +z".into(),
                bottom: "lower end".into(),
                scale: "z of file, mm".into(),
                slope_words,
                flanks,
            },
            TraceKind::Helix => TraceRow {
                name,
                coordinate: self.face.symbol().into(),
                rising: self.face.rises(),
                top: "far face".into(),
                bottom: format!("datum {}", self.face.datum_name()),
                scale: format!("{} mm", self.face.symbol()),
                slope_words,
                flanks,
            },
        }
    }

    /// Sign and reference length of the slopes of a row.
    fn slope_words<'a>(&self, kind: TraceKind, mut of: impl Iterator<Item = &'a EvaluatedTrace>) -> String {
        let Some(first) = of.next() else { return String::new() };
        let length = first.evaluation.slope.length;
        let same = of.all(|one| (one.evaluation.slope.length - length).abs() < 1e-6);
        let ([(symbol, _), ..], _) = names(kind);
        let length = if same {
            format!("per {} mm", format_fixed(length, 3))
        } else {
            "per range of each trace".into()
        };
        format!("{symbol} {}; {length}", self.sign_words(kind))
    }

    fn field(
        &self,
        kind: TraceKind,
        flank: Flank,
        traces: &[(&Trace, Option<&EvaluatedTrace>)],
        undrawn: &mut Vec<String>,
    ) -> TraceField {
        if traces.is_empty() {
            return TraceField::default();
        }
        let factor = self.to_transverse(flank);
        let band = self.options.bands(kind)[flank].as_ref();
        let relief = traces.iter().any(|(_, one)| one.is_some_and(|one| one.tip_relief.is_some()));
        let mut drawn = Vec::with_capacity(traces.len());
        for (trace, one) in traces {
            let Some(mut sheet) = samples(trace, factor) else {
                undrawn
                    .push(format!("{}: not drawn, its samples are no trace of a tooth", trace_name(trace)));
                continue;
            };
            let verdict = band.and_then(|(band, fit)| judged(band, *fit, trace, factor));
            sheet.mean_line = one.map(|one| {
                let e = &one.evaluation;
                [e.range.from(), e.range.to()].map(|a| [a, 1e3 * e.line.at(a)])
            });
            sheet.band = band.zip(verdict).map(|((band, _), verdict)| SheetBand {
                corners: band.corners().iter().map(|[a, lo, hi]| [*a, 1e3 * lo, 1e3 * hi]).collect(),
                shift_um: 1e3 * verdict.shift,
                passed: verdict.passed(),
            });
            sheet.values = values(*one, relief, band.map(|_| verdict));
            drawn.push(sheet);
        }
        let characteristics = self.characteristics(kind, relief, band.is_some(), &drawn);
        TraceField { traces: drawn, lines: self.lines(kind, flank), characteristics }
    }

    /// Factor that makes transverse deviations of those of the file.
    pub(super) fn to_transverse(&self, flank: Flank) -> f64 {
        let section = match self.inspection.conditions.section {
            Section::Transverse => MeasuredSection::Transverse,
            Section::Normal => MeasuredSection::Normal,
        };
        section.to_transverse(self.gear.gear.flank(flank).base_helix_angle).unwrap_or(1.0)
    }

    fn characteristics(
        &self,
        kind: TraceKind,
        relief: bool,
        band: bool,
        traces: &[SheetTrace],
    ) -> Vec<SheetCharacteristic> {
        let (judged, crowning) = names(kind);
        let slope = judged[0].1;
        let limited = judged.map(|(symbol, quantity)| (symbol, self.limits(quantity, quantity == slope)));
        let free = [(crowning, SheetLimits::default())];
        let relief = relief.then_some(("f_Ko", SheetLimits::default()));
        let margin = band.then_some(("K", SheetLimits { lower: Some(0.0), upper: None }));
        let all = limited.into_iter().chain(free).chain(relief).chain(margin).enumerate();
        let of = |(n, (symbol, limits)): (usize, (&str, SheetLimits))| {
            let values: Vec<f64> = traces.iter().filter_map(|t| t.values.get(n).copied().flatten()).collect();
            let summary = TeethSummary::of(&values).ok();
            SheetCharacteristic {
                symbol: symbol.into(),
                unit: "µm",
                mean: summary.map(|s| s.mean),
                range: summary.filter(|s| s.teeth > 1).map(|s| s.range()),
                limits,
                judged: if n == 0 { JudgedBy::Mean } else { JudgedBy::Each },
            }
        };
        all.map(of).collect()
    }

    fn lines(&self, kind: TraceKind, flank: Flank) -> Vec<ScaleLine> {
        let of = &self.inspection.conditions.flanks[flank];
        let relief = |end: usize| of.tip_relief_mm.map(|zone| zone[end]);
        let root = |end: usize| of.root_relief_mm.map(|zone| zone[end]);
        let places = match kind {
            TraceKind::Profile => vec![
                ("start", of.w_start_mm, LineLook::End),
                ("w_1", of.w_1_mm, LineLook::Limit),
                ("w_2", of.w_2_mm, LineLook::Limit),
                ("dk_1", relief(0), LineLook::Relief),
                ("dk_2", relief(1), LineLook::Relief),
                ("dr_1", root(0), LineLook::Relief),
                ("dr_2", root(1), LineLook::Relief),
                ("end", of.w_end_mm, LineLook::End),
            ],
            TraceKind::Helix => vec![
                ("z_a", of.z_a_mm, LineLook::End),
                ("z_1", of.z_1_mm, LineLook::Limit),
                ("z_2", of.z_2_mm, LineLook::Limit),
                ("z_b", of.z_b_mm, LineLook::End),
            ],
        };
        let base = self.gear.gear.flank(flank).base_radius;
        let value = |at: f64| match kind {
            TraceKind::Profile => 2.0 * base.hypot(at),
            TraceKind::Helix if self.options.top_up => at + 0.5 * self.face.width.unwrap_or(0.0),
            TraceKind::Helix => self.face.distance(at),
        };
        let known = places.into_iter().filter_map(|(name, at, look)| Some((name, at?, look)));
        known
            .map(|(name, at_mm, look)| ScaleLine { at_mm, name: name.into(), value: value(at_mm), look })
            .collect()
    }
}

fn names(kind: TraceKind) -> Names {
    use metrology::inspection::ToleranceQuantity as Q;
    match kind {
        TraceKind::Profile => {
            ([("f_Hα", Q::ProfileSlope), ("F_α", Q::ProfileTotal), ("f_fα", Q::ProfileForm)], "C_α")
        }
        TraceKind::Helix => {
            ([("f_Hβ", Q::HelixSlope), ("F_β", Q::HelixTotal), ("f_fβ", Q::HelixForm)], "C_β")
        }
    }
}

/// What a row shows: kind, line, and where it lies if all its traces lie there.
fn row_name(kind: TraceKind, tag: &str, mut positions: impl Iterator<Item = f64>) -> String {
    let (word, place) = match kind {
        TraceKind::Profile => ("Profile", "z"),
        TraceKind::Helix => ("Helix", "w"),
    };
    let mark = if tag.is_empty() { String::new() } else { format!(" {tag}") };
    let at = positions.next().filter(|first| positions.all(|at| (at - first).abs() < 1e-6));
    let at = at.map(|at| format!(" at {place} = {} mm", format_significant(at, 5))).unwrap_or_default();
    format!("{word}{mark}{at}")
}

/// A trace in um of the transverse section; none if it cannot be drawn.
fn samples(trace: &Trace, factor: f64) -> Option<SheetTrace> {
    let ascends = trace.abscissa_mm.windows(2).all(|pair| pair[0] < pair[1]);
    let finite = trace.abscissa_mm.iter().all(|a| a.is_finite());
    let small = trace.f_um.iter().all(|f| f.is_nan() || f.abs() <= LARGEST_UM);
    (ascends && finite && small && trace.abscissa_mm.len() == trace.f_um.len()).then(|| SheetTrace {
        tooth: trace.tooth,
        abscissa_mm: trace.abscissa_mm.clone(),
        f_um: trace.f_um.iter().map(|f| factor * f).collect(),
        mean_line: None,
        band: None,
        values: Vec::new(),
    })
}

fn judged(band: &KBand, fit: BandFit, trace: &Trace, factor: f64) -> Option<BandVerdict> {
    let deviation = trace.f_um.iter().map(|um| 1e-3 * factor * um).collect();
    let samples = TraceSamples::new(trace.abscissa_mm.clone(), deviation).ok()?;
    band.judge(&samples, fit).ok()
}

/// Values in the order of the characteristics.
fn values(one: Option<&EvaluatedTrace>, relief: bool, band: Option<Option<BandVerdict>>) -> Vec<Option<f64>> {
    let e = one.map(|one| &one.evaluation);
    let mm =
        [e.map(|e| e.slope.printed()), e.map(|e| e.total), e.map(|e| e.form), e.map(|e| e.crowning.height)];
    let relief = relief.then(|| one.and_then(|one| one.tip_relief.as_ref()).map(|relief| relief.amount));
    let band = band.map(|verdict| verdict.map(|verdict| verdict.margin));
    mm.into_iter().chain(relief).chain(band).map(|mm| mm.map(|mm| 1e3 * mm)).collect()
}
