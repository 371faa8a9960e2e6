//! Topographies as nets in space: the nominal flank as a plane, the value drawn at right angles to it.

use super::axes::{TICK_SIZE, vertical_bar};
use super::error::{ChartError, LEAST_SPAN, check_count, check_values};
use super::numbers::{decimal_exponent, format_fixed, format_significant};
use super::palette::{FAINT, INK, MUTED, signed_color};
use super::scale::{Axis, decimals_of, round_below};
use super::svg::{Anchor, Canvas, Stroke, Svg, TextStyle};
use super::topography::{NamedTopography, Topography, common_range};

/// Nets to draw beside each other with one scale.
#[derive(Clone, Debug, PartialEq)]
pub struct TopographyNet {
    /// Heading of the chart.
    pub title: String,
    /// One panel per flank.
    pub panels: Vec<NamedTopography>,
    /// Lowest and highest value that the scale must hold, um, to share it with other nets; `None` takes the range of
    /// these panels.
    pub range_um: Option<(f64, f64)>,
}

const WIDTH: f64 = 880.0;
/// Height that the values take from the lowest to the highest.
const RELIEF_HEIGHT: f64 = 120.0;
/// Lines of a net in each direction; a finer grid is thinned for the eye.
const MOST_LINES: usize = 21;

/// Oblique view of a panel: z runs to the right and towards the viewer, w to the back, the value upwards.
struct View<'a> {
    field: &'a Topography,
    origin: [f64; 2],
    per_um: f64,
    floor_um: f64,
}

impl View<'_> {
    const ALONG_Z: [f64; 2] = [204.0, 42.0];
    const ALONG_W: [f64; 2] = [104.0, -66.0];

    fn at(&self, z_share: f64, w_share: f64, f_um: f64) -> [f64; 2] {
        let [zx, zy] = Self::ALONG_Z;
        let [wx, wy] = Self::ALONG_W;
        [
            self.origin[0] + zx * z_share + wx * w_share,
            self.origin[1] + zy * z_share + wy * w_share - self.per_um * f_um,
        ]
    }

    fn z_share(&self, j: usize) -> f64 {
        share(self.field.z_mm(), j)
    }

    fn w_share(&self, i: usize) -> f64 {
        share(self.field.w_mm(), i)
    }

    fn surface(&self, i: usize, j: usize) -> [f64; 2] {
        self.at(self.z_share(j), self.w_share(i), self.field.f_um()[i][j])
    }
}

fn share(values: &[f64], k: usize) -> f64 {
    (values[k] - values[0]) / (values[values.len() - 1] - values[0])
}

/// Draws nets over face width and length of roll. The scale is the same for all panels and stated by a bar in um;
/// corner values are printed because they show slopes and twist.
///
/// # Errors
/// [`ChartError::TooFewValues`] without any panel, [`ChartError::InvalidNumber`] for a given range that is not finite.
pub fn topography_net(net: &TopographyNet) -> Result<Svg, ChartError> {
    check_count("topography net panels", net.panels.len(), 1)?;
    let (lo, hi) = match net.range_um {
        None => common_range(&net.panels),
        Some((lo, hi)) => {
            check_values("topography net range", &[lo, hi])?;
            let (a, b) = common_range(&net.panels);
            (lo.min(a), hi.max(b))
        }
    };
    let (lo, hi) = (lo.min(0.0), hi.max(0.0));
    let flat = hi - lo <= LEAST_SPAN;
    let (per_um, relief) = if flat { (0.0, 30.0) } else { (RELIEF_HEIGHT / (hi - lo), RELIEF_HEIGHT) };
    let above = per_um * hi;
    let plane_top = 78.0 + above;
    let plane_height = View::ALONG_Z[1] - View::ALONG_W[1];
    let below = relief - above;
    let height = plane_top + plane_height + below + 42.0;
    let mut canvas = Canvas::new(WIDTH, height, &net.title);
    canvas.heading(
        "dotted: nominal flank; values normal to it, up = material left standing; corner values in µm",
    );
    let size = lo.abs().max(hi.abs());
    for (k, panel) in net.panels.iter().enumerate() {
        let places = net.panels.len().max(2) as f64;
        let left = k as f64 * WIDTH / places;
        let floor_um = if flat { 0.0 } else { lo };
        let origin = [left + 64.0, plane_top - View::ALONG_W[1]];
        let view = View { field: &panel.topography, origin, per_um, floor_um };
        canvas.text([left, 60.0], &panel.name, TextStyle::new(13.0, Anchor::Start).bold());
        draw_floor(&mut canvas, &view, if flat { relief } else { 0.0 });
        let corners = corners(&view, size);
        corners[0].draw_stick(&mut canvas);
        let sum: f64 = panel.topography.f_um().iter().flatten().sum();
        // What lies above is drawn later: the plane over relief, standing material over the plane.
        if sum > 0.0 {
            draw_plane(&mut canvas, &view);
            draw_surface(&mut canvas, &view, size);
        } else {
            draw_surface(&mut canvas, &view, size);
            draw_plane(&mut canvas, &view);
        }
        corners[1..].iter().for_each(|corner| corner.draw_stick(&mut canvas));
        corners.iter().for_each(|corner| corner.draw_value(&mut canvas));
        if !flat {
            let bar = round_below(0.4 * (hi - lo));
            let label = printed(bar, bar, decimals_of);
            vertical_bar(&mut canvas, left + 10.0, 76.0, per_um * bar, &format!("{label} µm"));
        }
    }
    Ok(canvas.finish())
}

/// The base below everything, with the scales of z and w on the edges that nothing can cover.
fn draw_floor(canvas: &mut Canvas, view: &View, drop: f64) {
    let at = |z: f64, w: f64| {
        let [x, y] = view.at(z, w, view.floor_um);
        [x, y + drop]
    };
    let faint = Stroke::solid(FAINT, 0.8);
    canvas.loops(&[vec![at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)]], "none", Some(faint));
    for (z, w) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
        canvas.line(at(z, w), view.at(z, w, 0.0), faint);
    }
    let label = TextStyle::new(11.0, Anchor::Middle);
    let (z, w) = (view.field.z_mm(), view.field.w_mm());
    for (share, text) in Axis::tight(z[0], z[z.len() - 1], 5).ticks() {
        let [x, y] = at(share, 0.0);
        canvas.line([x, y], [x - 3.0, y + 4.0], Stroke::solid(INK, 0.8));
        canvas.text([x - 6.0, y + 15.0], &text, label);
    }
    for (share, text) in Axis::tight(w[0], w[w.len() - 1], 4).ticks() {
        let [x, y] = at(1.0, share);
        canvas.line([x, y], [x + 4.0, y + 1.5], Stroke::solid(INK, 0.8));
        canvas.text([x + 7.0, y + 7.0], &text, TextStyle::new(11.0, Anchor::Start));
    }
    let [x, y] = at(0.5, 0.0);
    canvas.text([x - 14.0, y + 34.0], "z [mm]", TextStyle::new(TICK_SIZE, Anchor::Middle));
    let [x, y] = at(1.0, 0.5);
    canvas.text([x + 34.0, y + 18.0], "w [mm]", TextStyle::new(TICK_SIZE, Anchor::Start));
    let side = TextStyle::new(TICK_SIZE, Anchor::Start).muted();
    let [x, y] = at(0.0, 0.0);
    // Below the number of the scale at this corner.
    canvas.text([x - 6.0, y + 30.0], "face I", TextStyle { anchor: Anchor::Middle, ..side });
    canvas.text([x - 6.0, y + 43.0], "(not datum)", TextStyle { anchor: Anchor::Middle, ..side });
    let [x, y] = at(1.0, 0.0);
    canvas.text([x + 12.0, y + 26.0], "face II, root", side);
    canvas.text([x + 12.0, y + 39.0], "(datum face)", side);
    let [x, y] = at(1.0, 1.0);
    canvas.text([x + 34.0, y + 1.0], "tip", side);
}

fn draw_plane(canvas: &mut Canvas, view: &View) {
    let mut lines = Vec::new();
    for k in 0..=4 {
        let s = f64::from(k) / 4.0;
        lines.push(vec![view.at(s, 0.0, 0.0), view.at(s, 1.0, 0.0)]);
        lines.push(vec![view.at(0.0, s, 0.0), view.at(1.0, s, 0.0)]);
    }
    canvas.polylines(&lines, Stroke { color: MUTED, width: 0.8, dash: "1.5 2.5" });
}

/// Patches from the back to the front, each hiding what lies behind it.
fn draw_surface(canvas: &mut Canvas, view: &View, size: f64) {
    let rows = thinned(view.field.w_mm().len());
    let columns = thinned(view.field.z_mm().len());
    for i in rows.windows(2).rev() {
        for j in columns.windows(2) {
            let f = view.field.f_um();
            let mean = 0.25 * (f[i[0]][j[0]] + f[i[0]][j[1]] + f[i[1]][j[0]] + f[i[1]][j[1]]);
            // Half the strength of the maps: the net is read by its lines.
            let fill = signed_color(if size > 0.0 { 0.6 * mean / size } else { 0.0 });
            let patch = vec![
                view.surface(i[0], j[0]),
                view.surface(i[0], j[1]),
                view.surface(i[1], j[1]),
                view.surface(i[1], j[0]),
            ];
            canvas.loops(&[patch], &fill, Some(Stroke::solid("#33383d", 0.5)));
        }
    }
}

/// Evenly spread indices with both ends.
fn thinned(count: usize) -> Vec<usize> {
    let lines = count.min(MOST_LINES);
    (0..lines).map(|k| (k * (count - 1) + (lines - 1) / 2) / (lines - 1)).collect()
}

/// A value beside others up to `size`: with the decimals of that size, or a power of ten where these would be zeros.
fn printed(value: f64, size: f64, decimals: impl Fn(f64) -> usize) -> String {
    if size < 1e-4 { format_significant(value, 1) } else { format_fixed(value, decimals(size)) }
}

/// A corner of the net: foot on the plane, head on the surface, and the place of its value.
struct Corner {
    foot: [f64; 2],
    head: [f64; 2],
    value: String,
    value_at: [f64; 2],
    anchor: Anchor,
}

/// The corners, the hindmost first: the surface may hide it.
fn corners(view: &View, size: f64) -> [Corner; 4] {
    let (last_i, last_j) = (view.field.w_mm().len() - 1, view.field.z_mm().len() - 1);
    [(last_i, 0), (last_i, last_j), (0, 0), (0, last_j)].map(|(i, j)| {
        let foot = view.at(view.z_share(j), view.w_share(i), 0.0);
        let head = view.surface(i, j);
        let (anchor, shift) = if j == 0 { (Anchor::End, -7.0) } else { (Anchor::Start, 7.0) };
        let hindmost = i == last_i && j == 0;
        // The hindmost value stands at the top, clear of the surface; the others beside the middle.
        let y = if hindmost { foot[1].min(head[1]) } else { 0.5 * (foot[1] + head[1]) + 3.0 };
        let value =
            printed(view.field.f_um()[i][j], size, |size| (2 - decimal_exponent(size)).max(0) as usize);
        Corner { foot, head, value, value_at: [foot[0] + shift, y], anchor }
    })
}

impl Corner {
    fn draw_stick(&self, canvas: &mut Canvas) {
        canvas.line(self.foot, self.head, Stroke::solid(INK, 1.3));
        canvas.disc(self.head, 2.2, INK, Stroke::solid(INK, 0.5));
    }

    fn draw_value(&self, canvas: &mut Canvas) {
        canvas.text(self.value_at, &self.value, TextStyle::new(TICK_SIZE, self.anchor).halo());
    }
}
