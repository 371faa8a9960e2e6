//! One combination of a study: the job with other bodies or another shift.

use crate::job::{LoadedTangentialJob, ShiftRatio, TangentialExplore};
use generating_grinding::job::Steps;

/// What is changed; `None` keeps the value of the job. Lengths mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Variant {
    pub worm_threads: Option<u32>,
    pub worm_tip_diameter: Option<f64>,
    pub dresser_tip_diameter: Option<f64>,
    pub shift_ratio: Option<f64>,
}

/// How many combinations a study makes.
pub(super) fn count(explore: &TangentialExplore) -> usize {
    explore
        .worm_threads
        .len()
        .max(1)
        .saturating_mul(Steps::count_of(explore.worm_tip_diameter))
        .saturating_mul(Steps::count_of(explore.dresser_tip_diameter))
        .saturating_mul(Steps::count_of(explore.shift_ratio))
}

impl Variant {
    /// Every combination, the shift ratio innermost.
    pub fn all(explore: &TangentialExplore) -> Vec<Self> {
        let threads: Vec<Option<u32>> = match explore.worm_threads.as_slice() {
            [] => vec![None],
            given => given.iter().copied().map(Some).collect(),
        };
        let mut all = Vec::new();
        for worm_threads in threads {
            for worm_tip_diameter in Steps::each(explore.worm_tip_diameter) {
                for dresser_tip_diameter in Steps::each(explore.dresser_tip_diameter) {
                    for shift_ratio in Steps::each(explore.shift_ratio) {
                        all.push(Self { worm_threads, worm_tip_diameter, dresser_tip_diameter, shift_ratio });
                    }
                }
            }
        }
        all
    }

    /// The job with it. A pitch diameter that the job gives follows the tip; the scale along the worm follows another ratio.
    pub fn job(self, base: &LoadedTangentialJob) -> LoadedTangentialJob {
        let mut changed = base.clone();
        let job = &mut changed.job;
        job.explore = None;
        if let Some(threads) = self.worm_threads {
            job.worm.threads = threads;
        }
        if let Some(tip) = self.worm_tip_diameter {
            if let (Some(pitch), Some(before)) = (job.worm.pitch_diameter, job.worm.tip_diameter) {
                job.worm.pitch_diameter = Some(pitch + tip - before);
            } else {
                job.worm.pitch_diameter = None;
            }
            job.worm.tip_diameter = Some(tip);
        }
        if let Some(tip) = self.dresser_tip_diameter {
            job.dresser.pitch_diameter =
                job.dresser.pitch_diameter.map(|pitch| pitch + tip - job.dresser.tip_diameter);
            job.dresser.tip_diameter = tip;
        }
        if let Some(ratio) = self.shift_ratio {
            job.grinding.shift_ratio = ShiftRatio::Number(ratio);
            job.grinding.shift_width = None;
        }
        changed
    }
}
