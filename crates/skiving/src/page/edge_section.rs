//! A section across the rounded edge at one track: faces, rounding, contact point with its normal, and the light beam on it.

use crate::measuring::{RealTool, conventional_reading};
use crate::workflow::SkivingBodies;
use foundation::geometry::Flank;
use report::charts::{
    ChartError, Drawing, DrawingLayer, DrawingLook, DrawingNote, check_values, drawing, format_fixed,
    format_significant,
};
use report::{Block, Figure};

/// How far the rake face is drawn, and how far clearance face and beam are, in radii of the rounding.
const RAKE: f64 = 4.0;
const FACES: f64 = 2.2;
/// How far from the centre of the rounding its names stand, in its radii: where it begins and ends, conventional touch, contact.
const ENDS: [f64; 2] = [1.45, 2.8];
const CONVENTIONAL: f64 = 3.6;
const CONTACT: f64 = 2.4;
/// Points of an arc.
const ARC: usize = 60;

/// The section across each edge at its middle track; nothing for sharp edges.
pub(super) fn blocks(bodies: &SkivingBodies) -> Result<Vec<Block>, ChartError> {
    if bodies.pair.tool().rounding().radius == 0.0 {
        return Ok(Vec::new());
    }
    Flank::BOTH.into_iter().map(|flank| EdgeSection::of_middle(bodies, flank).block()).collect()
}

/// The edge across its centre curve. Angles on the rounding count from the normal of the rake face, deg.
struct EdgeSection {
    /// Flank that the edge cuts.
    flank: Flank,
    /// Its track, from 1.
    track: usize,
    /// rho_e: radius of the rounding, um.
    rounding_um: f64,
    /// theta: contact point.
    contact_deg: f64,
    /// theta_lo and theta_hi: where the rounding begins and ends.
    range_deg: [f64; 2],
    /// theta_c: normal of the clearance face.
    clearance_deg: f64,
    /// b_r: width of the chamfer on the rake face, um; 0 for none.
    rake_chamfer_um: f64,
    /// r_L: radius of the beam, um.
    beam_um: f64,
    /// Angle between the beam and the plane of the section, deg.
    beam_across_deg: f64,
    /// Where a beam parallel to the tool's axis would touch instead; none where it rests on the body.
    conventional_deg: Option<f64>,
}

impl EdgeSection {
    /// At the middle track of an edge.
    fn of_middle(bodies: &SkivingBodies, flank: Flank) -> Self {
        let rounding = bodies.pair.tool().rounding();
        let tracks = &bodies.flanks[flank].tracks;
        let middle = tracks.len() / 2;
        let (track, pose) = &tracks[middle];
        let ideal = RealTool::ideal(bodies.teeth());
        let usual = conventional_reading(&bodies.edges[flank], &ideal, track, &bodies.beam, 0);
        let section = &track.section;
        Self {
            flank,
            track: middle + 1,
            rounding_um: 1e3 * rounding.radius,
            contact_deg: section.contact_angle.to_degrees(),
            range_deg: section.range.map(f64::to_degrees),
            clearance_deg: section.clearance_angle.to_degrees(),
            rake_chamfer_um: 1e3 * rounding.rake_chamfer_width,
            beam_um: 1e3 * bodies.beam.radius,
            beam_across_deg: pose.beam_in_tool.dot(&section.tangent).abs().min(1.0).asin().to_degrees(),
            conventional_deg: usual.ok().map(|found| found.angle.to_degrees()),
        }
    }

    fn block(&self) -> Result<Block, ChartError> {
        self.check()?;
        let svg = drawing(&Drawing {
            title: format!("Edge for the {} flank across track {}", self.flank, self.track),
            subtitle:
                "section perpendicular to the edge; up: normal of the rake face, right: out of the tooth"
                    .into(),
            axes: Some(["out of the tooth [mm]".into(), "along the rake normal [mm]".into()]),
            layers: self.layers(),
            notes: self.notes(),
        })?;
        let [lo, hi] = self.range_deg.map(|degrees| format_fixed(degrees, 2));
        let beam = format!(
            " Beam of {} µm radius, {}° out of the plane of the section.",
            format_significant(self.beam_um, 4),
            format_fixed(self.beam_across_deg, 2)
        );
        let caption = format!(
            "Rounding ρ = {} µm, θ from {lo}° to {hi}°; contact at θ = {}°, {}° before the rounding ends.{beam}",
            format_significant(self.rounding_um, 4),
            format_fixed(self.contact_deg, 2),
            format_fixed(self.range_deg[1] - self.contact_deg, 2)
        );
        let id = format!("edge-for-the-{}-flank-across-track-{}", self.flank, self.track);
        Ok(Block::Figure(Figure::new(id, svg, caption)))
    }

    fn check(&self) -> Result<(), ChartError> {
        let name = format!("section of the {} edge, track {}", self.flank, self.track);
        let [lo, hi] = self.range_deg;
        let lengths = [self.rounding_um, self.rake_chamfer_um];
        check_values(&format!("{name}, lengths"), &lengths)?;
        check_values(&format!("{name}, beam"), &[self.beam_um, self.beam_across_deg])?;
        let touch = self.conventional_deg.unwrap_or(0.0);
        check_values(&format!("{name}, angles"), &[self.contact_deg, lo, hi, self.clearance_deg, touch])
    }

    fn layers(&self) -> Vec<DrawingLayer> {
        let layer = |name: &str, look, lines_mm| DrawingLayer { name: name.into(), look, lines_mm };
        let [lo, hi] = self.range_deg;
        let arc: Vec<[f64; 2]> =
            (0..=ARC).map(|k| self.on_rounding(lo + (hi - lo) * k as f64 / ARC as f64)).collect();
        let far = 1e-3 * FACES * self.rounding_um;
        // Off the rounding on both sides: on the rake face a chamfer if there is one, then the face.
        let rake_edge = along(self.on_rounding(lo), lo, -1e-3 * self.rake_chamfer_um);
        let rake = along(rake_edge, 0.0, -1e-3 * RAKE * self.rounding_um);
        let clearance_edge = self.on_rounding(hi);
        let clearance = along(clearance_edge, self.clearance_deg, far);
        let mut body = vec![rake, rake_edge];
        body.extend(&arc);
        body.extend([clearance_edge, clearance, [rake[0], clearance[1]]]);
        let chamfer = (self.rake_chamfer_um > 0.0).then(|| vec![rake_edge, self.on_rounding(lo)]);
        let ray = |degrees, radii| vec![[0.0, 0.0], self.beyond(degrees, radii)];
        let rays = vec![ray(lo, ENDS[0]), ray(hi, ENDS[1])];
        let touch = self.conventional_deg.map(|at| vec![self.on_rounding(at), self.beyond(at, CONVENTIONAL)]);
        let normal = vec![self.on_rounding(self.contact_deg), self.beyond(self.contact_deg, CONTACT)];
        let mut layers = vec![layer("tooth", DrawingLook::Material, vec![body])];
        layers.push(layer("light beam", DrawingLook::OtherBody, vec![self.beam()]));
        layers.extend([
            layer("rounding", DrawingLook::Edge, vec![arc]),
            layer("chamfer", DrawingLook::DottedEdge, chamfer.into_iter().collect()),
            layer("ends of the rounding", DrawingLook::Net, rays),
            layer("normal at the contact", DrawingLook::Path(0), vec![normal]),
            layer("where a conventional beam touches", DrawingLook::Path(1), touch.into_iter().collect()),
        ]);
        layers
    }

    /// The beam where the plane cuts it, as far as the faces are drawn.
    fn beam(&self) -> Vec<[f64; 2]> {
        let radius = 1e-3 * self.beam_um;
        let slope = self.beam_across_deg.to_radians().sin().abs();
        let far = 1e-3 * FACES * self.rounding_um;
        // Along its own direction the ellipse is as long as radius / slope.
        let reach = if slope * far >= radius { radius / slope } else { far };
        let side = |sign: f64| {
            (0..=ARC).map(move |k| {
                let along_beam = sign * reach * (2.0 * k as f64 / ARC as f64 - 1.0);
                let share = slope * along_beam / radius;
                let out = radius * (1.0 - sign * (1.0 - share * share).max(0.0).sqrt());
                let [x, y] = place(self.contact_deg, 1e-3 * self.rounding_um + out);
                along([x, y], self.contact_deg, along_beam)
            })
        };
        side(1.0).chain(side(-1.0)).collect()
    }

    fn notes(&self) -> Vec<DrawingNote> {
        let [lo, hi] = self.range_deg;
        let note = |degrees: f64, radii: f64, text: &str| DrawingNote {
            at_mm: self.beyond(degrees, radii),
            text: text.into(),
        };
        let mut notes = vec![
            note(lo, ENDS[0], "θ_lo"),
            note(hi, ENDS[1], "θ_hi"),
            note(self.contact_deg, CONTACT, "contact θ"),
            note(0.0, 0.0, "c"),
        ];
        notes.extend(self.conventional_deg.map(|degrees| note(degrees, CONVENTIONAL, "conventional")));
        notes
    }

    /// So many radii from the centre of the rounding.
    fn beyond(&self, degrees: f64, radii: f64) -> [f64; 2] {
        place(degrees, 1e-3 * radii * self.rounding_um)
    }

    fn on_rounding(&self, degrees: f64) -> [f64; 2] {
        place(degrees, 1e-3 * self.rounding_um)
    }
}

/// The place in a direction that counts from the rake normal towards the outside.
fn place(degrees: f64, distance: f64) -> [f64; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [distance * sin, distance * cos]
}

/// From a place with a normal `degrees` along its tangent, away from the rake face.
fn along([x, y]: [f64; 2], degrees: f64, distance: f64) -> [f64; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [x + distance * cos, y - distance * sin]
}
