//! flankwright plans, simulates and proves the manufacture of gear teeth: generating grinding with its dressing, tangential dressing,
//! five-axis milling, measuring of skiving tools, the electronic gearbox, and the inspection of gears.
//!
//! A process maps settings to a flank; planning inverts that map; a simulation that shares no formula with it is the
//! referee. This page goes that way once: a gear, the flank that is wanted, what the conventional method makes of it,
//! and the plan that makes it. Units are mm and rad inside the library, degrees and micrometres in files.
//!
//! # A gear and the flank that is wanted
//!
//! [`geometry::Gear`] turns drawing data into base data, one involute flank a side. A flank point has two coordinates:
//! length of roll w and axial position z. [`modification::Modification`] is what the flank should be there, as a
//! function f_t(w, z): transverse, positive where material stands.
//!
//! ```
//! use flankwright::geometry::{Flank, Gear, GearData, Sides};
//! use flankwright::modification::{EvaluationField, Modification, ModificationSpec};
//!
//! let gear = Gear::new(GearData {
//!     teeth: 19,
//!     normal_module: 3.5,
//!     pressure_angle: Sides::both(17.5f64.to_radians()),
//!     helix_angle: -35f64.to_radians(), // left-hand
//!     profile_shift: 0.0,
//!     cone_angle: 0.0,
//! })?;
//! let flank = gear.flank(Flank::Left);
//! assert!((2.0 * flank.base_radius - 75.762956).abs() < 1e-6);
//!
//! // The field on which the flank is judged: from the form to the tip diameter, over the face width.
//! let roll = [flank.length_of_roll(76.2065 / 2.0)?, flank.length_of_roll(88.5315 / 2.0)?];
//! let field = EvaluationField::new(roll, [-20.0, 20.0], flank.base_radius, flank.base_helix_angle)?;
//!
//! let spec = serde_json::json!({ "kind": "helix_crowning", "amount_um": 20.0 });
//! let target = Modification::build(&ModificationSpec::from_json(&spec)?, &field)?;
//! assert!((target.value(roll[0], 20.0)? + 0.020).abs() < 1e-12); // 20 um removed at the face
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What a motion leaves on the flank
//!
//! [`contact::ExactContact`] finds what any worm surface leaves on the workpiece under any [`kinematics`] motion, with
//! exact derivatives. Here a plain worm approaches the gear along a parabola of the axial feed, the conventional way to
//! make a crowning: it comes with an unwanted twist.
//!
//! ```
//! use flankwright::contact::{ExactContact, ModifiedThread, Pair, Unmodified};
//! use flankwright::geometry::{Flank, WormChoice, worm_for_gear};
//! use flankwright::kinematics::MotionLaw;
//! # use flankwright::geometry::{Gear, GearData, Sides};
//! # let gear = Gear::new(GearData { teeth: 19, normal_module: 3.5, pressure_angle: Sides::both(17.5f64.to_radians()),
//! #     helix_angle: -35f64.to_radians(), profile_shift: 0.0, cone_angle: 0.0 })?;
//!
//! let choice = WormChoice {
//!     threads: 3,
//!     hand: -1.0,
//!     pitch_diameter: None,
//!     tip_diameter: Some(200.0),
//!     pressure_angle: None,
//!     profile_shift: 0.0,
//!     cone_angle: 0.0,
//! };
//! let made = worm_for_gear(&gear, &choice)?;
//! let pair = Pair::without_backlash(made.worm, gear, made.crossed_axes_angle)?;
//!
//! // No shift of the worm; the centre distance falls by 55.7 um over 20 mm of feed.
//! let mut motion = pair.motion(MotionLaw::zero());
//! motion.delta_d = MotionLaw::polynomial(0.0, vec![0.0, 0.0, -0.0557 / (20.0 * 20.0)]);
//! let worm = ModifiedThread::new(*pair.worm.flank(Flank::Left), &Unmodified);
//! let contact = ExactContact::new(&pair, Flank::Left, &motion, &worm);
//!
//! let f_n = contact.solve_grid(&[4.105, 22.9], &[-20.0, 20.0])?; // row-major [w][z]
//! let twist_um = -1e3 * (f_n[3].f_n - f_n[2].f_n - f_n[1].f_n + f_n[0].f_n);
//! assert!((twist_um + 43.1).abs() < 0.5, "{twist_um}"); // normal, from the corners
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A plan and its proof
//!
//! [`workflow::plan_job`] takes the job that a file describes, chooses the diagonal ratio, corrects the command until the
//! exact flank fits, finds the dressing motion, and hands bodies and motions, nothing else, to the referee ([`removal`]):
//! rays of the worm shortened by the dresser, then rays of the workpiece shortened by the worm that those rays left.
//!
//! ```
//! use flankwright::exchange::{Source, parse_job};
//! use flankwright::numerics::Silent;
//! use flankwright::workflow::{Status, plan_job};
//!
//! let job = parse_job(Source::new(
//!     "tour.toml",
//!     r#"
//!     [job]
//!     name = "tour"
//!     process = "generating-grinding"
//!     [gear]
//!     teeth = 19
//!     normal_module = 3.5
//!     normal_pressure_angle_deg = 17.5
//!     helix_angle_deg = -35.0
//!     profile_shift = 0.0
//!     face_width = 40.0
//!     tip_diameter = 88.5315
//!     root_diameter = 72.4315
//!     form_diameter = 76.2065
//!     [target]
//!     modifications = [ { kind = "helix_crowning", amount_um = 20.0, flank = "both" } ]
//!     [worm]
//!     threads = 3
//!     tip_diameter = 200.0
//!     [dresser]
//!     tip_diameter = 123.0
//!     [grinding]
//!     method = "diagonal"
//!     [grid]
//!     profile_points = 5
//!     helix_points = 5
//!     "#,
//! ))?;
//! let outcome = plan_job(&job, &Silent).expect("these bodies can make it");
//! assert_eq!(outcome.result.verdict.status(), Status::Met);
//! for flank in outcome.result.flanks.values() {
//!     assert!(flank.max_deviation_um < 0.02); // simulated against target
//!     assert!(flank.model_difference_um < 0.001); // analytic against referee
//!     assert!(flank.simulated_characteristics.twist_corner_um.abs() < 0.02);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # To the machine
//!
//! A machine is a tree of axes ([`machine`]). Every pose of two bodies becomes positions of its axes, all solutions of it, and a
//! program is what a reader that knows nothing of the writer reads back from its text ([`nc`]). Strokes, speed and the way back to
//! the bodies are in [`motion`]; a job that names a machine gets programs that the referee has proven.
//!
//! ```
//! use flankwright::exchange::machine::read_machine;
//! use flankwright::kinematics::DressingPosition;
//! use flankwright::machine::{DressingRule, Mounts, Role, Station};
//! use flankwright::motion::axis_words;
//! use flankwright::nc::{Block, Dialect, Header, Program, WriteOptions, write_checked};
//!
//! let grinder = read_machine("../../machines/no-swivel.toml".as_ref())?;
//! let machine = &grinder.machine;
//! let dresser = DressingPosition {
//!     worm_angle: 0.3, worm_shift: -11.0, crossing_angle: 0.055, centre_distance: 153.0, offset: 0.0,
//! };
//! let pose = Mounts::default().spindles(&dresser.pose());
//! let solutions = machine.judged(Station::Dresser, machine.dressing(&pose, DressingRule::Swivel(0.0), None)?)?;
//! assert_eq!(solutions.len(), 2);
//! let at = machine.first(&solutions)?.at; // within travel, the head tilted least
//! assert!((at[machine.needed(Role::Radial)?] + 153.0).abs() < 1e-9);
//!
//! let axes: Vec<usize> = machine.axes_at(Station::Dresser)?;
//! let words = axis_words(machine, &axes, |name| grinder.file.axes[name].letter.as_deref())?;
//! let header = Header { name: "TOUR".into(), axes: words.words.clone(), chord_tolerance: 1e-4 };
//! let blocks = vec![Block::Rapid(words.targets(machine, &at, |_| true)), Block::End];
//! let checked = write_checked(&Program::new(header, blocks)?, Dialect::Siemens, &WriteOptions::default())?;
//! assert!(checked.written.text.contains("X-153.000000"), "{}", checked.written.text);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`workflow::write_outcome`] writes result, tables, settings and report; [`workflow::simulate_job`] runs settings that
//! stand in a job; the crate `flankwright-verify` recomputes reference files.
//!
//! # The rooms
//!
//! Mathematics, contact, referee, machines, programs, processes and files are crates of their own, re-exported here as modules; what each of
//! them may know stands in `ARCHITECTURE.md`, and `tests/crates.rs` holds it. [`removal`] is the referee. [`processes`] is the registry.

pub mod exchange;
mod registry;
pub mod workflow;

pub use contact;
pub use control;
pub use foundation::{geometry, inverse, kinematics, modification, numerics};
pub use machine;
pub use metrology;
pub use motion;
pub use nc;
pub use referee as removal;
pub use registry::{TooLate, add_process, processes};
pub use report;
pub use verdict;

/// The processes, each a crate of its own.
pub mod process {
    pub use dressing;
    pub use generating::{self, correction};
    pub use milling;
    pub use skiving;
    pub use tangential_dressing;
}
