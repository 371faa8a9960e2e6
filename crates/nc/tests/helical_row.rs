//! The middle row of the helical case of `docs/mathematics/milling.md` in closed form (sections 1.1, 2, 3 and 5): tips and axes of an end
//! mill. What the milling kinematics of the reference make of it (`feed` of the reference for five-axis milling) stands here as numbers.

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn sum(a: Vector, factor: f64, b: Vector) -> Vector {
    [0, 1, 2].map(|k| a[k] + factor * b[k])
}

fn unit(a: Vector) -> Vector {
    let length = dot(a, a).sqrt();
    a.map(|part| part / length)
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn radial(angle: f64) -> Vector {
    [angle.sin(), angle.cos(), 0.0]
}

fn tangent(angle: f64) -> Vector {
    [angle.cos(), -angle.sin(), 0.0]
}

/// The left flank of m_n 6, z 23, alpha_n 20 deg, beta 25 deg.
struct Helicoid {
    base: f64,
    eta_base: f64,
    beta_base: f64,
    lead: f64,
    root: f64,
    /// Length of roll at the form radius 71.5 mm and at the tip.
    range: [f64; 2],
}

impl Helicoid {
    fn new() -> Self {
        let (module, teeth) = (6.0, 23.0);
        let (normal, beta) = (20f64.to_radians(), 25f64.to_radians());
        let pitch = 0.5 * teeth * module / beta.cos();
        let transverse = (normal.tan() / beta.cos()).atan();
        let base = pitch * transverse.cos();
        let lead = beta.tan() / pitch;
        let eta_base = std::f64::consts::FRAC_PI_2 / teeth - (transverse.tan() - transverse);
        let roll = |radius: f64| (radius * radius - base * base).sqrt();
        let range = [roll(71.5), roll(pitch + module)];
        Self { base, eta_base, beta_base: (lead * base).atan(), lead, root: pitch - 1.25 * module, range }
    }

    /// Point, its derivatives along w and z, and the normal out of the material.
    fn at(&self, w: f64, z: f64) -> [Vector; 4] {
        let phi = w / self.base + self.eta_base - self.lead * z;
        let (e, u) = (radial(phi), tangent(phi));
        let point = sum(sum(e.map(|part| self.base * part), -w, u), z, [0.0, 0.0, 1.0]);
        let along_w = e.map(|part| w / self.base * part);
        let along_z = [-self.lead * point[1], self.lead * point[0], 1.0];
        let (sin, cos) = self.beta_base.sin_cos();
        [point, along_w, along_z, sum(u.map(|part| -cos * part), -sin, [0.0, 0.0, 1.0])]
    }

    /// Point of the guide curve, normal of the column plane, normal of the root cylinder.
    fn column(&self, u: f64) -> [Vector; 3] {
        let e = radial(-self.lead * u);
        let c = sum(e.map(|part| self.root * part), u, [0.0, 0.0, 1.0]);
        [c, unit([-self.lead * c[1], self.lead * c[0], 1.0]), e]
    }

    /// z at which the column plane at u meets the flank at w.
    fn section(&self, w: f64, u: f64) -> f64 {
        let [c, t, _] = self.column(u);
        let mut z = u;
        for _ in 0..60 {
            let [point, _, along_z, _] = self.at(w, z);
            let step = dot(sum(point, -1.0, c), t) / dot(along_z, t);
            z -= step;
            if step.abs() < 1e-13 * z.abs().max(1.0) {
                break;
            }
        }
        z
    }

    /// Length of the column's arc over w, by Simpson's rule.
    fn arc(&self, from: f64, to: f64, u: f64) -> f64 {
        let [_, t, _] = self.column(u);
        let rate = |w: f64| {
            let [_, along_w, along_z, _] = self.at(w, self.section(w, u));
            let way = sum(along_w, -dot(along_w, t) / dot(along_z, t), along_z);
            dot(way, way).sqrt()
        };
        let parts = 400;
        let h = (to - from) / f64::from(parts);
        let weight = |k: i32| if k == 0 || k == parts { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
        (0..=parts).map(|k| weight(k) * rate(from + h * f64::from(k))).sum::<f64>() * h / 3.0
    }
}

/// Tip and axis of the end mill of radius 2.5 mm that touches 5 mm above its tip, at the columns -10, -7.5 .. 10 mm.
pub fn tips() -> Vec<(Vector, Vector)> {
    let flank = Helicoid::new();
    let [low, high] = flank.range;
    let (mut inner, mut outer) = (low, high);
    let half = 0.5 * flank.arc(low, high, 0.0);
    for _ in 0..60 {
        let middle = 0.5 * (inner + outer);
        if flank.arc(low, middle, 0.0) < half { inner = middle } else { outer = middle }
    }
    (0..9)
        .map(|k| {
            let u = -10.0 + 2.5 * f64::from(k);
            let [_, t, base_normal] = flank.column(u);
            let [point, _, _, n] = flank.at(inner, flank.section(inner, u));
            let axis = unit(cross(n, t));
            let axis = if dot(axis, base_normal) > 0.0 { axis } else { axis.map(|part| -part) };
            (sum(sum(point, 2.5, n), -5.0, axis), axis)
        })
        .collect()
}

/// C and A of the trunnion, deg.
pub const ANGLES: [[f64; 2]; 9] = [
    [26.32531563267689, 80.7417297139169],
    [25.447987997064672, 80.7417297139169],
    [24.570660361452454, 80.7417297139169],
    [23.693332725840236, 80.7417297139169],
    [22.81600509022801, 80.7417297139169],
    [21.938677454615792, 80.7417297139169],
    [21.061349819003574, 80.7417297139169],
    [20.184022183391363, 80.7417297139169],
    [19.306694547779134, 80.7417297139169],
];

/// X, Y and Z of the slides without tip control, mm.
pub const PLACES: [Vector; 9] = [
    [-27.76863007168717, -28.728667496379337, 23.432569788818824],
    [-27.768630071687163, -31.19610038162429, 23.834782365464235],
    [-27.76863007168717, -33.66353326686924, 24.23699494210966],
    [-27.76863007168717, -36.1309661521142, 24.639207518755086],
    [-27.768630071687166, -38.59839903735916, 25.041420095400497],
    [-27.76863007168717, -41.06583192260412, 25.443632672045908],
    [-27.76863007168717, -43.533264807849065, 25.84584524869132],
    [-27.768630071687166, -46.00069769309404, 26.24805782533673],
    [-27.768630071687166, -48.46813057833899, 26.65027040198214],
];

/// Speed of the tip from a column to the next, mm/min.
pub const SPEEDS: [f64; 8] = [
    1189.853313448606,
    1189.8533134486065,
    1189.8533134486065,
    1189.8533134486067,
    1189.8533134486065,
    1189.8533134486067,
    1189.8533134486072,
    1189.8533134486058,
];

/// Feed in inverse time from a column to the next, 1/min.
pub const FEEDS: [f64; 8] = [
    434.1753739425357,
    434.1753739425356,
    434.1753739425357,
    434.17537394253577,
    434.1753739425356,
    434.17537394253577,
    434.17537394253577,
    434.1753739425354,
];
