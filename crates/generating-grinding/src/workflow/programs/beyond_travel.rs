//! How far the programs of a run go beyond the travel of their machine: they are laid out once more on the same machine with longer
//! ways of as few axes as can be, so that the whole way is known and can be drawn, not only the place where it was first left.

use super::axis_curves::chart;
use super::build::BuiltProgram;
use super::task::ProgramTask;
use foundation::numerics::extremes;
use job::machine::LoadedMachine;
use report::charts::AxisChart;
use run::RunFailure;
use run::program_check::shown_word;

/// An axis whose travel does not suffice. mm or deg.
pub struct BeyondTravel {
    /// Its name.
    pub axis: String,
    /// "mm" or "deg".
    pub unit: &'static str,
    /// From where to where the programs need it.
    pub needed: [f64; 2],
    /// Its travel.
    pub travel: [f64; 2],
    /// File of the program that goes farthest beyond.
    pub file: String,
    /// The axis over that program, with its travel.
    pub chart: Option<AxisChart>,
}

impl ProgramTask<'_> {
    /// The axes that the programs drive beyond their travel, in the machine's order; none where they cannot be laid out on longer ways
    /// either.
    pub fn beyond_travel(&self) -> Vec<BeyondTravel> {
        let machine = &self.machine.machine;
        let axes = machine.axes().iter().enumerate();
        let limited: Vec<usize> = axes.filter(|(_, axis)| axis.travel.is_some()).map(|(k, _)| k).collect();
        let alone = limited.iter().map(|&one| vec![one]);
        let pairs = limited
            .iter()
            .enumerate()
            .flat_map(|(k, &one)| limited[k + 1..].iter().map(move |&other| vec![one, other]));
        // As few axes as can be: with more travel on others the bodies could come together in another way.
        let found = alone.chain(pairs).find_map(|longer| {
            let wide = LoadedMachine { machine: machine.with_longer_ways(&longer), ..self.machine.clone() };
            // The ways are the same under every control.
            let dialects = self.dialects.get(..1).unwrap_or_default();
            let task = ProgramTask { machine: &wide, dialects, ..self.clone() };
            let built = task.build().ok()?;
            Some(longer.iter().filter_map(|&number| self.beyond(number, &built.programs)).collect())
        });
        found.unwrap_or_default()
    }

    fn beyond(&self, number: usize, programs: &[BuiltProgram]) -> Option<BeyondTravel> {
        let axis = &self.machine.machine.axes()[number];
        let travel = axis.travel?;
        let way = |program: &BuiltProgram| {
            let rows = program.layout.trace.rows.iter().map(|row| row.at[number]);
            let resting = program.layout.at_rest.iter().filter(|(at, _)| *at == number).map(|(_, x)| *x);
            extremes(rows.chain(resting))
        };
        let margin = |[from, to]: [f64; 2]| axis.margin(from).min(axis.margin(to));
        let worst = programs.iter().min_by(|a, b| margin(way(a)).total_cmp(&margin(way(b))))?;
        let [from, to] = way(worst);
        if !(from.is_finite() && to.is_finite()) || (axis.admits(from) && axis.admits(to)) {
            return None;
        }
        let word =
            worst.words.place(number).map_or_else(String::new, |k| shown_word(&worst.words.words[k].word));
        let shown = |x: f64| axis.joint.shown(x);
        Some(BeyondTravel {
            axis: axis.name.clone(),
            unit: axis.joint.unit(),
            needed: extremes(programs.iter().flat_map(way)).map(shown),
            travel: travel.map(shown),
            file: worst.file.clone(),
            chart: chart(axis, &word, number, &worst.layout.trace.rows),
        })
    }

    /// A refusal for an axis beyond its travel, with the whole way that the programs need; any other as it is.
    pub fn with_ways(&self, failure: RunFailure) -> RunFailure {
        match &failure {
            RunFailure::NotProducible(finding) if finding.code == "axis-limit" => {}
            _ => return failure,
        }
        let way = |of: &BeyondTravel| {
            let ([a, b], [from, to]) = (of.needed, of.travel);
            format!("{} from {a:.1} to {b:.1} {}, travel {from:.1} to {to:.1}", of.axis, of.unit)
        };
        let ways: Vec<String> = self.beyond_travel().iter().map(way).collect();
        if ways.is_empty() {
            return failure;
        }
        failure.amended(|finding| {
            let message = format!("{}; the whole way needs {}", finding.message, ways.join("; "));
            job::Diagnostic { message: message.into(), ..finding }
        })
    }
}
