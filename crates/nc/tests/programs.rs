//! Programs for the tests and the benchmark of `nc`: strokes, and random blocks of every kind that a dialect has.

use nc::{
    Angles, AxisMotion, AxisWord, BSplineMotion, Block, Coupling, CubicMotion, CubicSpan, CurveTable,
    Dialect, Gear, GearLeader, GearSynchronisation, Header, Orientation, Pace, Program, Repetition,
    TablePiece, Targets, TipControl, TipMotion, ToothData,
};

/// Axes that every program here has, by index.
pub const X: usize = 0;
pub const Y: usize = 1;
pub const Z: usize = 2;
pub const A: usize = 3;
pub const C: usize = 4;
pub const B: usize = 5;
/// The worm: spindle 0, an axis on Siemens.
pub const WORM: usize = 6;

/// The axis map of `docs/mathematics/programs.md#the-independent-reader`.
pub fn axes(dialect: Dialect) -> Vec<AxisWord> {
    use AxisMotion::{Linear, Rotary};
    let names = [
        ("X1", Linear, 'X'),
        ("V1", Linear, 'Y'),
        ("Z1", Linear, 'Z'),
        ("A1", Rotary, 'A'),
        ("C2", Rotary, 'C'),
        ("C5", Rotary, 'B'),
    ];
    let siemens = dialect == Dialect::Siemens;
    let mut axes: Vec<AxisWord> = names
        .into_iter()
        .map(|(name, motion, letter)| {
            // One letter among the addresses, as machines have it.
            if siemens && letter != 'A' {
                AxisWord::named(name, motion)
            } else {
                AxisWord::letter(name, motion, letter)
            }
        })
        .collect();
    axes.push(if siemens { AxisWord::named("B1", Rotary) } else { AxisWord::spindle("B1", 0) });
    axes.push(AxisWord::spindle("B3", 1));
    axes
}

pub fn header(dialect: Dialect) -> Header {
    Header { name: "GRIND_1".into(), axes: axes(dialect), chord_tolerance: 5e-5 }
}

pub fn program(dialect: Dialect, mut blocks: Vec<Block>) -> Program {
    blocks.push(Block::End);
    Program::new(header(dialect), blocks).expect("a program of the tests")
}

/// The diagonal stroke of `docs/mathematics/programs.md#how-it-is-verified`: z 40, 200 blocks, C endless.
pub fn stroke(dialect: Dialect, count: usize) -> Program {
    let mut blocks = vec![Block::Rapid(place(0.0))];
    for k in 1..=count {
        blocks.push(Block::Linear { target: place(k as f64 / 200.0), duration: 0.05 });
    }
    program(dialect, blocks)
}

/// Where all six axes stand at u; Z goes up and down.
pub fn place(u: f64) -> Targets {
    let z = -25.0 + 50.0 * (u - 2.0 * (0.5 * (u + 1.0)).floor()).abs();
    let angle = 360.0 * 40.0 * u + 0.489_907_768_025_508 * (z + 25.0);
    let x = 120.0 - 0.02 * (1.0 - ((z / 25.0) * (z / 25.0)));
    let targets = Targets::of_first(&[x, -15.0 + 30.0 * u, z, 20f64.to_radians(), angle.to_radians()]);
    targets.with(B, (-angle / 7.0).to_radians())
}

/// Numbers that look random and are the same everywhere.
pub struct Draw(u64);

impl Draw {
    pub fn new(seed: u64) -> Self {
        Self(seed | 1)
    }

    pub fn next(&mut self) -> u64 {
        // Marsaglia's shifts with a multiplication.
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    pub fn below(&mut self, count: u64) -> u64 {
        (self.next() >> 11) % count
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.next() >> 11) as f64 / (1u64 << 53) as f64)
    }

    fn duration(&mut self) -> f64 {
        10f64.powf(self.between(-4.0, 3.0))
    }

    /// Places of axes, in the size of machines, sometimes round or of the greatest size.
    fn value(&mut self, axis: usize) -> f64 {
        let linear = axis < A;
        match self.below(8) {
            0 if linear => self.between(-999_999.0, 999_999.0),
            0 => self.between(-1e6, 1e6),
            1 => 0.0,
            2 => self.between(-10.0, 10.0).round(),
            _ if linear => self.between(-300.0, 300.0),
            _ => self.between(-100.0, 100.0),
        }
    }

    fn targets(&mut self, count: usize) -> Targets {
        let mut targets = Targets::NONE;
        while targets.is_empty() {
            for axis in 0..count {
                if self.below(2) == 0 {
                    targets.set(axis, self.value(axis));
                }
            }
        }
        targets
    }
}

/// Blocks of every kind that the dialect takes, `stand_alone` only those of LinuxCNC's interpreter.
pub fn random(dialect: Dialect, seed: u64, count: usize, stand_alone: bool) -> Program {
    let mut draw = Draw::new(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5eed);
    let all = Targets::of_first(&[0.0; 6].map(|_| draw.between(-50.0, 50.0)));
    let mut blocks = vec![Block::Rapid(all)];
    let mut table = 0;
    let siemens = dialect == Dialect::Siemens;
    while blocks.len() < count {
        match draw.below(if siemens { 20 } else { 16 }) {
            0 => blocks.push(Block::Rapid(draw.targets(6))),
            1 => blocks.push(Block::Dwell(draw.between(1e-3, 5.0))),
            2 => {
                let spindle = if stand_alone { 0 } else { draw.below(2) as u8 };
                let speed = draw.between(-6000.0, 6000.0);
                let speed = if dialect == Dialect::Fanuc { speed.round() } else { speed };
                let speed = if draw.below(4) == 0 { 0.0 } else { speed * std::f64::consts::PI / 30.0 };
                blocks.push(Block::Spindle { spindle, speed });
            }
            3 => blocks.push(Block::Comment("STROKE 1 OF 7".into())),
            4 => blocks.push(Block::Stop),
            5 if !stand_alone && dialect != Dialect::LinuxCnc => gear(&mut draw, dialect, table, &mut blocks),
            6 => {
                blocks.push(Block::Output { number: 1 + draw.below(15) as u8, on: draw.below(2) == 0 });
                blocks.push(Block::Linear { target: draw.targets(6), duration: draw.duration() });
            }
            16 | 17 => {
                let spans = (0..6).filter(|_| draw.below(2) == 0).collect::<Vec<_>>();
                let spans = spans.into_iter().map(|axis| {
                    let span = CubicSpan {
                        end: draw.between(-50.0, 50.0),
                        start_slope: draw.between(-50.0, 50.0),
                        end_slope: draw.between(-50.0, 50.0),
                    };
                    (axis, span)
                });
                let spans: Vec<_> = spans.collect();
                if !spans.is_empty() {
                    // The follower of a gear does not stand still: a curve starts at a known place.
                    blocks.push(Block::Rapid(all));
                    blocks.push(Block::Cubic(Box::new(CubicMotion { spans, duration: draw.duration() })));
                }
            }
            18 => {
                blocks.push(Block::Rapid(all));
                blocks.push(Block::BSpline(Box::new(spline(&mut draw))));
            }
            19 => {
                table += 1;
                blocks.push(Block::Table(Box::new(curve_table(&mut draw, table))));
            }
            _ => blocks.push(Block::Linear { target: draw.targets(6), duration: draw.duration() }),
        }
    }
    program(dialect, blocks)
}

fn spline(draw: &mut Draw) -> BSplineMotion {
    let degree = 2 + draw.below(2) as usize;
    let count = degree + draw.below(5) as usize;
    let mut knots = vec![0.0; degree + 1];
    for k in 0..=count - degree {
        let step = if k == 0 { 1.0 } else { draw.between(0.1, 2.0) };
        knots.push(knots[degree + k] + step);
    }
    knots.extend(vec![knots[knots.len() - 1]; degree]);
    let points =
        (0..count).map(|_| Targets::NONE.with(X, draw.between(-9.0, 9.0)).with(C, draw.between(-9.0, 9.0)));
    BSplineMotion { degree, points: points.collect(), knots, duration: draw.duration() }
}

/// C over Z, of three repetitions in turn.
fn curve_table(draw: &mut Draw, id: u32) -> CurveTable {
    let repetition = [Repetition::Held, Repetition::Leader, Repetition::Both][id as usize % 3];
    let start = [draw.between(-50.0, 0.0), draw.between(-3.0, 3.0)];
    let sign = if draw.below(2) == 0 { 1.0 } else { -1.0 };
    let mut leader = start[0];
    let count = 1 + draw.below(6) as usize;
    let pieces = (0..count).map(|k| {
        leader += sign * draw.between(0.1, 20.0);
        let end = if k + 1 == count && repetition == Repetition::Leader {
            start[1]
        } else {
            draw.between(-3.0, 3.0)
        };
        let follower =
            CubicSpan { end, start_slope: draw.between(-2.0, 2.0), end_slope: draw.between(-2.0, 2.0) };
        TablePiece { leader, follower }
    });
    CurveTable { id, follower: C, leader: Z, start, pieces: pieces.collect(), repetition }
}

/// A gear that is defined, on for one stroke, and off again.
fn gear(draw: &mut Draw, dialect: Dialect, table: u32, blocks: &mut Vec<Block>) {
    let (teeth, threads) = (draw.below(200) as u32 + 1, draw.below(5) as i32 + 1);
    let (normal_module, helix_angle) = (2.5, draw.between(-0.6, 0.6));
    let mut leaders = vec![
        GearLeader { axis: WORM, coupling: Coupling::Ratio { num: threads.into(), den: teeth.into() } },
        GearLeader {
            axis: Z,
            coupling: Coupling::Ratio { num: 2.0 * helix_angle.sin(), den: f64::from(teeth) * normal_module },
        },
    ];
    let mut synchronisation = None;
    if dialect == Dialect::Siemens {
        if table > 0 && draw.below(2) == 0 {
            leaders[1].coupling = Coupling::Table(table);
        }
        let sizes = [draw.between(-11.9, 3.0), draw.between(-11.9, 3.0)].map(|size| 10f64.powf(size));
        let coupling = Coupling::Ratio { num: -sizes[0], den: sizes[1] };
        leaders.push(GearLeader { axis: Y, coupling });
        if draw.below(2) == 0 {
            let leaders = leaders.iter().map(|leader| draw.value(leader.axis)).collect();
            synchronisation = Some(Box::new(GearSynchronisation { follower: draw.value(C), leaders }));
        }
    }
    let teeth = ToothData { teeth, threads, normal_module, helix_angle };
    blocks.push(Block::GearDefine(Box::new(Gear { follower: C, leaders, teeth: Some(teeth) })));
    blocks.push(Block::Spindle { spindle: 0, speed: 100.0 * std::f64::consts::PI / 30.0 });
    blocks.push(Block::GearOn { follower: C, synchronisation });
    blocks.push(Block::Linear { target: Targets::NONE.with(Z, draw.value(Z)), duration: draw.duration() });
    blocks.push(Block::GearOff { follower: C });
}

/// Strokes of axis values and blocks under tip control in turn, directions or angles by the seed: for Siemens and Fanuc, and with
/// directions and without axis values as cutter locations.
pub fn tips(dialect: Dialect, seed: u64, count: usize, axis_values: bool) -> Program {
    let mut draw = Draw::new(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x71b5);
    let mut blocks = Vec::new();
    while blocks.len() < count {
        if axis_values {
            let all = Targets::of_first(&[0.0; 6].map(|_| draw.between(-50.0, 50.0)));
            blocks.push(Block::Rapid(all));
            blocks.push(Block::Linear { target: draw.targets(6), duration: draw.duration() });
        }
        let (number, offset) = (1 + draw.below(9999) as u32, 1 + draw.below(999) as u32);
        blocks.push(Block::Tool { number, length_offset: Some(offset) });
        let speed = draw.between(1.0, 20_000.0).round() * std::f64::consts::PI / 30.0;
        blocks.push(Block::Spindle { spindle: 0, speed: if draw.below(2) == 0 { speed } else { -speed } });
        let angles = axis_values && draw.below(2) == 0;
        blocks.push(Block::TipControlOn(if angles { TipControl::Angles } else { TipControl::Directions }));
        let (mut oriented, mut paced) = (false, false);
        for _ in 0..10 {
            match draw.below(10) {
                0 => {
                    blocks.push(Block::TipSpeed(draw.between(0.1, 1e5) / 60.0));
                    paced = true;
                }
                1 => blocks.push(Block::Dwell(draw.between(1e-3, 5.0))),
                2 => blocks.push(Block::Comment("ROW 1 OF 7".into())),
                _ => blocks.push(Block::Tip(tip(&mut draw, angles, &mut oriented, &mut paced))),
            }
        }
        blocks.push(Block::TipControlOff);
    }
    program(dialect, blocks)
}

fn tip(draw: &mut Draw, angles: bool, oriented: &mut bool, paced: &mut bool) -> TipMotion {
    let orientation = match draw.below(4) {
        0 if *oriented => Orientation::Kept,
        _ if angles => {
            let words = [(C, draw.value(C)), (A, draw.value(A)), (B, draw.value(B))];
            Orientation::Angles(Angles::new(&words[..1 + draw.below(3) as usize]).expect("axes of their own"))
        }
        _ => Orientation::Direction(direction(draw)),
    };
    *oriented = true;
    let pace = match draw.below(4) {
        0 => Pace::Rapid,
        1 => Pace::Duration(draw.duration()),
        2 if *paced => Pace::Kept,
        _ => Pace::Speed(draw.between(0.1, 1e5) / 60.0),
    };
    *paced = match pace {
        Pace::Duration(_) => false,
        Pace::Speed(_) => true,
        _ => *paced,
    };
    TipMotion { tip: [X, Y, Z].map(|axis| draw.value(axis)), orientation, pace }
}

/// A unit vector, now and then in a plane of the frame.
pub fn direction(draw: &mut Draw) -> [f64; 3] {
    if draw.below(8) == 0 {
        return [0.6, -0.0, 0.8];
    }
    loop {
        let parts: [f64; 3] = std::array::from_fn(|_| draw.between(-1.0, 1.0));
        let length = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
        if length > 0.1 {
            return parts.map(|part| part / length);
        }
    }
}
