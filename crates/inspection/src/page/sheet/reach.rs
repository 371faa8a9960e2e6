//! How far a trace with its mean line and its band lies from the axis of its lane.

use super::traces_data::SheetTrace;
use foundation::numerics::extremes;

/// Deviation that lies on the axis of the trace's lane, um: the middle of the mean line, else of the trace.
pub(super) fn zero_of(trace: &SheetTrace) -> f64 {
    if let Some([a, b]) = trace.mean_line {
        return 0.5 * (a[1] + b[1]);
    }
    let [lo, hi] = extremes(trace.f_um.iter().copied().filter(|f| f.is_finite()));
    if lo > hi { 0.0 } else { 0.5 * (lo + hi) }
}

/// Limits of a band as they lie beside the trace, [mm, lower um, upper um].
pub(super) fn beside(trace: &SheetTrace) -> impl Iterator<Item = [f64; 3]> + '_ {
    let band = trace.band.iter();
    band.flat_map(|band| band.corners.iter().map(|[a, lo, hi]| [*a, lo - band.shift_um, hi - band.shift_um]))
}

/// How far anything of a trace lies from the axis of its lane, um.
pub(super) fn reach(trace: &SheetTrace) -> f64 {
    let zero = zero_of(trace);
    let line = trace.mean_line.iter().flatten().map(|end| end[1]);
    let all = trace.f_um.iter().copied().filter(|f| f.is_finite()).chain(line);
    all.chain(beside(trace).flat_map(|[_, lo, hi]| [lo, hi])).map(|f| (f - zero).abs()).fold(0.0, f64::max)
}
