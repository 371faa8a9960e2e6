//! The scene of measuring a skiving tool: the ideal tool in its poses at the beam, and at the stylus where one scans. Coordinates are
//! those of the machine. Knows no file, and no readings.

mod skiving_mesh;

use crate::MeasuringTrack;
use crate::measuring::{Beam, MeasuringPose};
use crate::workflow::SkivingOutcome;
use crate::workflow::finding::failure;
use crate::workflow::scene::skiving_mesh::skiving_tool;
use foundation::geometry::Flank;
use foundation::kinematics::{Pose, Room};
use nalgebra::{Rotation3, Vector3};
use run::{RunFailure, finished, unmeshed};
use scene::mesh::{MeshError, TriangleMesh, revolved};
use scene::{Body, BodyKind, Coordinate, Frame, Scene, Stage, numbers, place};

/// Corners of a beam.
const AROUND: usize = 24;
/// How far a beam is drawn to both sides, in pitch radii of the tool.
const REACH: f64 = 1.0;

/// Tool and beam of a run with a stage for each flank, its frames the poses of the tracks; the same for a stylus that scans.
///
/// # Errors
/// [`RunFailure`] for bodies that cannot be meshed and poses without numbers.
pub fn scene_of_skiving(outcome: &SkivingOutcome) -> Result<Scene, RunFailure> {
    let bodies = &outcome.prepared.bodies;
    let tool = bodies.pair.tool();
    let mesh =
        skiving_tool(tool, &bodies.edges).map_err(|e| failure(&e))?.map_err(|e| unmeshed("tool", &e))?;
    let reach = REACH * tool.pitch_radius();
    let rod = |id: &str, kind: BodyKind, beam: &Beam| {
        let mesh = cylinder(beam, reach).map_err(|e| unmeshed(id, &e))?;
        Ok::<_, RunFailure>(Body::new(id, kind, true, &mesh))
    };
    let mut shown =
        vec![Body::new("tool", BodyKind::Tool, true, &mesh), rod("beam", BodyKind::Beam, &bodies.beam)?];
    let mut stages: Vec<Stage> = Flank::BOTH
        .into_iter()
        .map(|flank| {
            let tracks = bodies.flanks[flank].tracks.iter();
            stage("measuring", &format!("Measuring the edge of the {flank} flank"), flank, tracks)
        })
        .collect();
    if let Some(scan) = &outcome.scan {
        shown.push(rod("stylus", BodyKind::Stylus, &scan.stylus)?);
        for flank in Flank::BOTH {
            let places: Vec<_> = scan.places[flank].iter().map(|at| (at.track, at.pose)).collect();
            stages.push(stage(
                "scanning",
                &format!("Scanning the edge of the {flank} flank"),
                flank,
                places.iter(),
            ));
        }
    }
    finished(Scene { bodies: shown, stages })
}

/// Tooth 0 at all places of an edge, from one end of it to the other.
fn stage<'a>(
    id: &str,
    title: &str,
    flank: Flank,
    places: impl Iterator<Item = &'a (MeasuringTrack, MeasuringPose)>,
) -> Stage {
    let mut frames: Vec<Frame> = places
        .map(|(track, pose)| {
            let stand = tool_pose(pose);
            let mut frame = Frame::new(track.place, [("tool", numbers(&stand))]);
            frame.contact.push(place(&(stand.rotation() * track.contact.point + stand.translation())));
            frame
        })
        .collect();
    frames.sort_by(|a, b| a.at.total_cmp(&b.at));
    Stage {
        id: format!("{id}-{flank}"),
        title: title.to_owned(),
        coordinate: Coordinate { label: "place along the edge", unit: "1" },
        frames,
    }
}

/// Marks the frame of the tool.
struct Tool;

/// The tool in the machine: swivelled about X, turned about its own axis.
fn tool_pose(pose: &MeasuringPose) -> Pose<Room, Tool> {
    let swivelled = Pose::<Room, Room>::rx(pose.swivel).then(&Pose::<Room, Tool>::rz(pose.turn));
    Pose::rigid(*swivelled.rotation(), pose.position)
}

/// A beam as a closed cylinder in coordinates of the machine.
fn cylinder(beam: &Beam, reach: f64) -> Result<TriangleMesh, MeshError> {
    let [from, to] = [-reach, reach];
    let mut mesh = revolved(&[[0.0, from], [beam.radius, from], [beam.radius, to], [0.0, to]], AROUND)?;
    // A beam stands upright but for its tilts.
    let turn = Rotation3::rotation_between(&Vector3::z(), &beam.unit()).unwrap_or_else(Rotation3::identity);
    for vertex in &mut mesh.vertices {
        *vertex = turn * *vertex + beam.point;
    }
    Ok(mesh)
}
