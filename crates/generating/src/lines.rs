//! Numbers of one flank that decomposition and mapping need: directions on the flanks and the contact relations of
//! `docs/mathematics/generating-contact.md`, for cylinders and cones. Knows no target.

use contact::FlankPair;
use foundation::geometry::Flank;
use foundation::kinematics::MotionLaw;
use foundation::modification::EvaluationField;
use foundation::numerics::{Jet2, extremes, monotone_root};

/// Directions and mapping constants of one flank of a pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlankLines {
    /// tan(rho_1) of the tool's lines: those that a dresser leaves, or a direction given for the tool.
    pub t_1: f64,
    /// t_K = tan(rho_K) of the contact path on the workpiece.
    pub t_k: f64,
    /// T1 = cos b1 (t_1 - s tan b1).
    pub big_t1: f64,
    /// s tan(beta_b1).
    pub worm_path: f64,
    /// cos(beta_b1).
    pub cos_b1: f64,
    /// cos(beta_b2).
    pub cos_b2: f64,
    /// E of R7 at zero feeds, mm.
    pub e: f64,
    /// C_c1, mm.
    pub c_c1: f64,
    /// C_c2, mm.
    pub c_c2: f64,
    /// C_zV11, C_zV21: what the feeds z_V1, z_V2 do to z_1.
    pub worm_feeds: [f64; 2],
    /// C_zV12, C_zV22: what the feeds z_V1, z_V2 do to z_2.
    pub work_feeds: [f64; 2],
    /// Chat_zV1, Chat_zV2 of R7; zero between cylinders.
    pub roll_feeds: [f64; 2],
    /// sin of the operating normal pressure angle.
    pub sin_an: f64,
    /// s of the flank.
    pub s: f64,
    /// B_F = r_b2 cos b2, mm: normal displacement per radian of the workpiece.
    pub lever: f64,
    /// Middle of the evaluation field: w_m, mm.
    pub w_m: f64,
    /// Middle of the evaluation field: z_m, mm.
    pub z_m: f64,
    /// Field in w, mm.
    pub roll: [f64; 2],
    /// Field in z, mm.
    pub face: [f64; 2],
}

/// Points along each edge of the field on which a mapping that is not affine is sampled.
const EDGE: usize = 64;

impl FlankLines {
    /// For a flank pair, its evaluation field and the direction tan(rho_1) of the tool's lines.
    pub fn new(pair: &FlankPair, field: &EvaluationField, t_1: f64) -> Self {
        let s = pair.flank().sign();
        let (b_1, b_2) = (pair.worm.base_helix_angle, pair.work.base_helix_angle);
        Self {
            t_1,
            t_k: s * b_2.tan(),
            big_t1: b_1.cos() * (t_1 - s * b_1.tan()),
            worm_path: s * b_1.tan(),
            cos_b1: b_1.cos(),
            cos_b2: b_2.cos(),
            e: -pair.hat_c,
            c_c1: pair.c_c1,
            c_c2: pair.c_c2,
            worm_feeds: [pair.c_zv11, pair.c_zv21],
            work_feeds: [pair.c_zv12, pair.c_zv22],
            roll_feeds: [pair.hat_zv1, pair.hat_zv2],
            sin_an: pair.operating_alpha_n.sin(),
            s,
            lever: pair.work.base_radius * b_2.cos(),
            w_m: field.roll_middle(),
            z_m: field.face_middle(),
            roll: field.roll(),
            face: field.face(),
        }
    }

    /// p_1 = Chat_w1/(tan rho_1 + C_w1).
    fn worm_pull(&self) -> f64 {
        1.0 / self.big_t1
    }

    /// tan(rho_2) on the workpiece at diagonal ratio K (K != 0).
    pub fn work_direction(&self, ratio: f64) -> f64 {
        let at = |c: [f64; 2]| c[0] * ratio + c[1];
        let pull = at(self.roll_feeds) - self.worm_pull() * at(self.worm_feeds);
        self.t_k + at(self.work_feeds) / (self.cos_b2 * pull)
    }

    /// Diagonal ratio for tan(rho_2) = t_2.
    pub fn ratio_of_direction(&self, t_2: f64) -> f64 {
        let p_1 = self.worm_pull();
        let p_2 = 1.0 / (self.cos_b2 * (t_2 - self.t_k));
        (p_1 * self.worm_feeds[1] + p_2 * self.work_feeds[1] - self.roll_feeds[1])
            / (self.roll_feeds[0] - p_1 * self.worm_feeds[0] - p_2 * self.work_feeds[0])
    }

    /// Slope m of the lines w_2 + m z_2 = const that worm lines w_1 = const leave (cylindrical worm): zero for a cylindrical
    /// workpiece, lines of equal rack height for a conical one.
    pub fn profile_slope(&self) -> f64 {
        let pull = self.roll_feeds[1] / self.work_feeds[1];
        pull / (1.0 / self.cos_b2 + pull * self.t_k)
    }

    /// Whether both bodies are cylinders: no feed changes the rolls in contact.
    pub fn is_cylindrical(&self) -> bool {
        // C_zV12 and both Chat are sines of cone angles; rounding leaves 1e-16 of them.
        [self.work_feeds[0], self.roll_feeds[0], self.roll_feeds[1]].iter().all(|c| c.abs() < 1e-12)
    }

    /// The flank.
    pub fn flank(&self) -> Flank {
        if self.s > 0.0 { Flank::Left } else { Flank::Right }
    }

    /// Worm roll that grinds workpiece roll w_2 between cylinders (R7), mm.
    pub fn worm_roll(&self, w_2: f64) -> f64 {
        self.cos_b1 * (self.e - w_2 / self.cos_b2)
    }

    /// Feed z_V2 at which (w_2, z_2) of a cylindrical workpiece is ground, whatever the law of the shift, mm.
    pub fn path_feed(&self, w_2: f64, z_2: f64) -> f64 {
        self.c_c2 - self.t_k * w_2 - z_2
    }

    /// Feed z_V2 at which (w_2, z_2) is ground under z_V1 = law(z_V2), mm.
    pub fn feed(&self, w_2: f64, z_2: f64, law: &MotionLaw) -> f64 {
        feed_of(self.work_feeds, law, z_2 + self.t_k * w_2 - self.c_c2)
    }

    /// Worm point (w_1, z_1) that grinds (w_2, z_2) under z_V1 = law(z_V2), mm.
    pub fn worm_point(&self, w_2: f64, z_2: f64, law: &MotionLaw) -> (f64, f64) {
        let feed = self.feed(w_2, z_2, law);
        let shift = law.value(feed);
        let at = |c: [f64; 2]| c[0] * shift + c[1] * feed;
        let w_1 = self.cos_b1 * (self.e - at(self.roll_feeds) - w_2 / self.cos_b2);
        (w_1, self.c_c1 - self.worm_path * w_1 + at(self.worm_feeds))
    }

    /// Workpiece roll that worm roll w_1 of a cylindrical worm grinds in the middle of the face width, mm.
    pub fn work_roll(&self, w_1: f64) -> f64 {
        let pull = self.roll_feeds[1] / self.work_feeds[1];
        let constant = self.e - w_1 / self.cos_b1 - pull * (self.z_m - self.c_c2);
        constant / (1.0 / self.cos_b2 + pull * self.t_k)
    }

    /// d(work roll)/d(worm roll) of [`FlankLines::work_roll`].
    pub fn work_roll_slope(&self) -> f64 {
        let pull = self.roll_feeds[1] / self.work_feeds[1];
        -1.0 / (self.cos_b1 * (1.0 / self.cos_b2 + pull * self.t_k))
    }

    /// The workpiece point (w_2, z_2) that (w_1, z_1) grinds under z_V1 = law(z_V2), as functions of (w_1, z_1). Where the law
    /// stands still (one worm line for a stretch of the feed) a point of that stretch, without derivatives.
    pub fn work_point(&self, w_1: f64, z_1: f64, law: &MotionLaw) -> [Jet2; 2] {
        let reached = z_1 + self.worm_path * w_1 - self.c_c1;
        let feed = feed_of(self.worm_feeds, law, reached);
        let [shift, slope, bend] = law.jet(feed);
        let rate = self.worm_feeds[0] * slope + self.worm_feeds[1];
        let (v_1, v_2) =
            if rate == 0.0 { (0.0, 0.0) } else { (1.0 / rate, -self.worm_feeds[0] * bend / rate.powi(3)) };
        let along = |h: [f64; 3]| Jet2::ridge(h, self.worm_path, 1.0);
        let feed = along([feed, v_1, v_2]);
        let shift = along([shift, slope * v_1, bend * v_1 * v_1 + slope * v_2]);
        let moved = |c: [f64; 2]| shift * c[0] + feed * c[1];
        let from_worm = Jet2 { f: w_1 / self.cos_b1 - self.e, fu: 1.0 / self.cos_b1, ..Jet2::default() };
        let w = (from_worm + moved(self.roll_feeds)) * -self.cos_b2;
        let z = w * -self.t_k + moved(self.work_feeds) + Jet2::constant(self.c_c2);
        [w, z]
    }

    /// The four corners of the evaluation field.
    pub fn corners(&self) -> [(f64, f64); 4] {
        let ([w0, w1], [z0, z1]) = (self.roll, self.face);
        [(w0, z0), (w0, z1), (w1, z0), (w1, z1)]
    }

    /// Points in which the extremes over the field are looked for: the corners under a constant ratio, where everything is
    /// affine; points all along the edges otherwise.
    fn outline(&self, law: &MotionLaw) -> Vec<(f64, f64)> {
        if law.is_affine() {
            return self.corners().to_vec();
        }
        let ([w0, w1], [z0, z1]) = (self.roll, self.face);
        (0..=EDGE)
            .map(|k| k as f64 / EDGE as f64)
            .flat_map(|x| {
                let (w, z) = (w0 + x * (w1 - w0), z0 + x * (z1 - z0));
                [(w, z0), (w, z1), (w0, z), (w1, z)]
            })
            .collect()
    }

    /// Worm positions [min, max] of z_1 over the field, mm.
    pub fn occupation(&self, law: &MotionLaw) -> [f64; 2] {
        extremes(self.outline(law).into_iter().map(|(w, z)| self.worm_point(w, z, law).1))
    }

    /// Worm lines [min, max] of xi_1 = z_1 + t_1 w_1 over the field, mm.
    pub fn line_range(&self, law: &MotionLaw) -> [f64; 2] {
        extremes(self.outline(law).into_iter().map(|(w, z)| {
            let (w_1, z_1) = self.worm_point(w, z, law);
            z_1 + self.t_1 * w_1
        }))
    }

    /// Worm rolls [min, max] of w_1 over the field, mm.
    pub fn worm_rolls(&self, law: &MotionLaw) -> [f64; 2] {
        extremes(self.outline(law).into_iter().map(|(w, z)| self.worm_point(w, z, law).0))
    }

    /// Feeds [min, max] of z_V2 over the field, mm.
    pub fn feed_range(&self, law: &MotionLaw) -> [f64; 2] {
        extremes(self.corners().into_iter().map(|(w, z)| self.feed(w, z, law)))
    }
}

/// v with c_0 law(v) + c_1 v = value.
fn feed_of([c_0, c_1]: [f64; 2], law: &MotionLaw, value: f64) -> f64 {
    if c_0 == 0.0 {
        return value / c_1;
    }
    monotone_root(|v| {
        let [f, f_1, _] = law.jet(v);
        (c_0 * f + c_1 * v - value, c_0 * f_1 + c_1)
    })
}
