//! A tool shift whose diagonal ratio keeps its sign by construction: the logarithm of the ratio at equidistant feeds decides,
//! the ratio between them is a straight line. Knows no flank.

use foundation::kinematics::{LawError, MotionLaw, PiecewisePolynomial};

/// F' = sign exp(logs[k]) at equidistant feeds.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct RatioNodes {
    feeds: [f64; 2],
    sign: f64,
    logs: Vec<f64>,
}

impl RatioNodes {
    /// At least two nodes over an ascending interval of feeds [mm].
    pub fn new(feeds: [f64; 2], sign: f64, logs: Vec<f64>) -> Self {
        Self { feeds, sign, logs }
    }

    /// The same with other logarithms.
    pub fn with(&self, logs: Vec<f64>) -> Self {
        Self { logs, ..self.clone() }
    }

    /// ln |F'| at the nodes.
    pub fn logs(&self) -> &[f64] {
        &self.logs
    }

    /// (feed, F') of the nodes.
    pub fn nodes(&self) -> Vec<[f64; 2]> {
        let at = |k: usize| self.feeds[0] + self.step() * k as f64;
        self.logs.iter().enumerate().map(|(k, log)| [at(k), self.sign * log.exp()]).collect()
    }

    fn step(&self) -> f64 {
        (self.feeds[1] - self.feeds[0]) / (self.logs.len() - 1) as f64
    }

    /// F: parabolas that meet with their slopes, zero in the middle of the feeds; the tangents continue.
    ///
    /// # Errors
    /// `NotFinite` for ratios that overflow.
    pub fn law(&self) -> Result<MotionLaw, LawError> {
        let nodes = self.nodes();
        let mut f = 0.0;
        let pieces = nodes.windows(2).map(|pair| {
            let ([a, m], [b, n]) = (pair[0], pair[1]);
            let piece = [f, m, 0.5 * (n - m) / (b - a), 0.0];
            f += 0.5 * (m + n) * (b - a);
            piece
        });
        let pieces = pieces.collect();
        let law = PiecewisePolynomial::new(nodes.iter().map(|node| node[0]).collect(), pieces)?;
        let law = MotionLaw::Pieces(law);
        Ok(law.raised(-law.value(0.5 * (self.feeds[0] + self.feeds[1]))))
    }

    /// F as a spline through 257 of its points: C2, as the exact contact asks of a law. It rounds the corners of F' over two or
    /// three points, which moves F by some 0.1 um where the ratio changes its course as much as by its half.
    ///
    /// # Errors
    /// As [`Self::law`].
    pub fn smooth_law(&self) -> Result<MotionLaw, LawError> {
        self.law()?.smooth(self.feeds)
    }

    /// dF/d logs[k] at a feed within the interval, up to a constant that is the same at all feeds.
    pub fn slopes(&self, feed: f64) -> Vec<f64> {
        let (step, last) = (self.step(), self.logs.len() - 1);
        let place = ((feed - self.feeds[0]) / step).clamp(0.0, last as f64);
        let piece = (place as usize).min(last - 1);
        let t = place - piece as f64;
        let hat = |k: usize| match k {
            // Areas under the hat of node k up to the feed, in steps.
            _ if k > piece + 1 => 0.0,
            _ if k == piece + 1 => 0.5 * t * t,
            _ => {
                let before = if k == 0 { 0.0 } else { 0.5 };
                before + if k == piece { t - 0.5 * t * t } else { 0.5 }
            }
        };
        self.logs.iter().enumerate().map(|(k, log)| self.sign * log.exp() * step * hat(k)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nodes() -> RatioNodes {
        RatioNodes::new([-20.0, 25.0], -1.0, vec![0.1, -0.4, 0.3, 0.8, -0.2])
    }

    #[test]
    fn the_ratio_is_a_broken_line_through_the_nodes() {
        let (nodes, law) = (nodes(), nodes().law().unwrap());
        for [feed, ratio] in nodes.nodes() {
            assert!((law.jet(feed)[1] - ratio).abs() < 1e-14);
        }
        let [a, b] = [nodes.nodes()[1], nodes.nodes()[2]];
        let middle = law.jet(0.5 * (a[0] + b[0]));
        assert!((middle[1] - 0.5 * (a[1] + b[1])).abs() < 1e-14);
        assert!(law.value(2.5).abs() < 1e-14);
        let smooth = nodes.smooth_law().unwrap();
        for k in 0..=400 {
            let v = -20.0 + 45.0 * f64::from(k) / 400.0;
            let ([f, f1, _], [g, g1, _]) = (law.jet(v), smooth.jet(v));
            // h^2 of the smooth law (0.18 mm) times the jumps of F'' at the nodes, some 0.1/mm, over some ten; F' by h/10 of them.
            assert!((f - g).abs() < 3e-4 && (f1 - g1).abs() < 6e-3, "{v}: {f} {g}, {f1} {g1}");
        }
    }

    #[test]
    fn slopes_are_derivatives_up_to_a_constant() {
        let (nodes, h) = (nodes(), 1e-6);
        for k in 0..5 {
            let at = |change: f64| {
                let mut logs = nodes.logs().to_vec();
                logs[k] += change;
                nodes.with(logs).law().unwrap()
            };
            let (more, less) = (at(h), at(-h));
            let slope = |v: f64| (more.value(v) - less.value(v)) / (2.0 * h);
            for v in [-20.0, -13.0, -8.75, 1.0, 13.75, 20.0, 25.0] {
                let exact = nodes.slopes(v)[k] - nodes.slopes(-20.0)[k];
                assert!((slope(v) - slope(-20.0) - exact).abs() < 1e-7, "{k} {v}");
            }
        }
    }
}
