//! What a job asks of the fit: where deviations are taken, which variables, how their values are found, how much trouble is taken.

use super::names::{channel_of, variable_of};
use crate::job::{
    DeviationMeasure, FitMethod as JobMethod, FitWeights, TangentialJob, VariableRule, Variables,
};
use crate::workflow::finding;
use crate::{Channel, FitGrid, FitLimits, FitMethod, TangentialModel, Variable, Weights};
use contact::Measure;
use foundation::geometry::Flank;
use run::RunFailure;

/// Rules of the fit.
#[derive(Clone, Debug)]
pub struct FitRules {
    /// How deviations are measured.
    pub measure: Measure,
    /// Where the fit asks.
    pub grid: FitGrid,
    /// How its points count.
    pub weights: Weights,
    /// The grid of the result, on which a set of variables is judged.
    pub judged_on: FitGrid,
    /// How far the fit goes.
    pub limits: FitLimits,
    /// Which variables it may use.
    pub choice: Choice,
    /// Methods that are tried, in their order.
    pub methods: Vec<FitMethod>,
    /// Parts in which the target may be stepped up.
    pub steps: usize,
    /// Whether the methods are compared.
    pub compare_methods: bool,
    /// Whether the flank is compared with crowning by radial feed.
    pub compare_radial: bool,
    splines: Vec<(Channel, usize)>,
}

/// Variables beside splines.
#[derive(Clone, Debug)]
pub enum Choice {
    /// These.
    Given(Vec<Variable>),
    /// The plan takes few that meet the tolerance.
    Chosen {
        /// Channels that the machine lacks, and the profile of a dresser that exists.
        excluded: Vec<Channel>,
        /// Most variables.
        most: usize,
    },
}

impl FitRules {
    /// Of a job.
    ///
    /// # Errors
    /// A finding on `dressing` for a channel or variable that the process does not know.
    pub(super) fn of_job(job: &TangentialJob) -> Result<Self, RunFailure> {
        let dressing = &job.dressing;
        let choice = match dressing.variables.named() {
            Some(list) => {
                let of = |(i, &v): (usize, _)| variable_of(v, &format!("dressing.variables[{i}]"));
                Choice::Given(list.iter().enumerate().map(of).collect::<Result<_, _>>()?)
            }
            None => {
                let of = |(i, &c): (usize, _)| channel_of(c, &format!("dressing.exclude[{i}]"));
                let mut excluded =
                    dressing.exclude.iter().enumerate().map(of).collect::<Result<Vec<_>, _>>()?;
                if job.dresser.exists() {
                    excluded.push(Channel::Profile(None));
                }
                Choice::Chosen { excluded, most: dressing.most_variables }
            }
        };
        let splines = dressing.splines.iter().enumerate();
        Ok(Self {
            measure: match dressing.measure {
                DeviationMeasure::Ray => Measure::Ray,
                DeviationMeasure::Arc => Measure::Arc,
            },
            grid: match dressing.weights {
                FitWeights::Uniform => FitGrid::Graded(dressing.fit_points),
                FitWeights::Source => FitGrid::Radii(dressing.fit_points),
            },
            weights: match dressing.weights {
                FitWeights::Uniform => Weights::Uniform,
                FitWeights::Source => Weights::Source,
            },
            judged_on: FitGrid::Equidistant(job.grid.profile_points, job.grid.helix_points),
            limits: match &dressing.variables {
                Variables::Rule(VariableRule::Source) => FitLimits::SOURCE,
                Variables::Rule(VariableRule::Auto) | Variables::List(_) => FitLimits::STEADY,
            },
            choice,
            methods: match dressing.method {
                JobMethod::Auto => FitMethod::ALL.to_vec(),
                JobMethod::Svd => vec![FitMethod::Plain],
                JobMethod::Damped => vec![FitMethod::Damped],
                JobMethod::GaussNewton => vec![FitMethod::GaussNewton],
            },
            steps: dressing.steps,
            compare_methods: dressing.compare_methods,
            compare_radial: dressing.compare_radial,
            splines: splines
                .map(|(i, spline)| {
                    Ok((channel_of(spline.channel, &format!("dressing.splines[{i}]"))?, spline.intervals))
                })
                .collect::<Result<_, RunFailure>>()?,
        })
    }

    /// Straight to the target, and in steps where the job allows them.
    pub fn ways_there(&self) -> Vec<usize> {
        if self.steps > 1 { vec![1, self.steps] } else { vec![1] }
    }

    /// Coefficients of the splines beside the powers, for a pass of the bodies.
    ///
    /// # Errors
    /// A finding on the spline that cannot be.
    pub fn spline_variables(
        &self,
        model: &TangentialModel,
        pass: &[Flank],
    ) -> Result<Vec<Variable>, RunFailure> {
        let mut all = Vec::new();
        for (i, &(channel, intervals)) in self.splines.iter().enumerate() {
            let functions = Variable::spline(channel, intervals, model.spline_range(channel, pass));
            all.extend(functions.map_err(|e| finding::on_field(&e, &format!("dressing.splines[{i}]")))?);
        }
        Ok(all)
    }
}
