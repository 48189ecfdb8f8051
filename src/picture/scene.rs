//! Scenes: curves and surfaces in space, in perspective and with axes.

use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, IntoDrawingArea};
use plotters::element::{PathElement, Polygon};
use plotters::prelude::{DrawingBackend, SVGBackend};
use plotters::style::{Color, RGBColor, ShapeStyle, WHITE};

use super::axes::BoxAxes;
use super::camera::{Camera, Seen};
use super::cut;
use super::heading::{self, Drawn, Mark, Row, color, compacted, dot, shown_in_units};
use super::order::{Piece, from_behind};
use super::text::load_font;
use super::units::FINER;
use crate::error::{Error, Invariant, Result};

/// The number of units beside and below the box for numbers and names, if these need no more.
const AROUND: f64 = 74.0;
const BELOW: f64 = 56.0;
/// The largest height of the picture of the box.
const HEIGHT: f64 = 640.0;
/// Lines are cut into pieces of at most this part of the box's diagonal, and are drawn nearer to the eye by this part. So a
/// curve on a surface is visible where the surface is.
const PIECE: f64 = 0.012;

/// The colour that is mixed with the colour of a surface on its inside.
const INSIDE: RGBColor = RGBColor(205, 200, 190);

/// A layer of a scene.
#[derive(Clone, Debug, Default)]
pub(crate) struct SpaceLayer {
    /// The label in the legend.
    pub label: String,
    /// Polylines; closed ones end where they begin.
    pub lines: Vec<Vec<[f64; 3]>>,
    /// Small polygons, seen from both sides.
    pub facets: Vec<Vec<[f64; 3]>>,
    /// A normal for every facet, or no normals. A facet with a normal is shaded by it and drawn without its edges.
    pub normals: Vec<[f64; 3]>,
    /// Whether the facets are the boundary of a body and counterclockwise as seen from outside. Then facets that are seen from
    /// inside are hidden by others; they are not drawn if the whole body is shown.
    pub closed: bool,
    /// Single points.
    pub points: Vec<[f64; 3]>,
}

impl SpaceLayer {
    fn all_points(&self) -> impl Iterator<Item = &[f64; 3]> {
        let lists = self.lines.iter().chain(&self.facets);
        lists.flatten().chain(&self.points)
    }
}

/// Layers in a box with axes.
#[derive(Clone, Debug)]
pub(crate) struct Scene {
    /// The heading; it may be empty.
    pub title: String,
    /// The width of the picture, in units of the SVG.
    pub width: u32,
    /// The box that is shown; parts outside are cut off. `None` stands for a box around everything.
    pub bounds: Option<[[f64; 2]; 3]>,
    /// The direction of the eye, in degrees from +x towards +y.
    pub azimuth: f64,
    /// The height of the eye, in degrees above the plane of x and y.
    pub elevation: f64,
    /// The layers.
    pub layers: Vec<SpaceLayer>,
}

/// The way in which a piece is drawn.
enum Paint {
    /// A facet with the colour of its inside, and with that of the edges that it had before it was cut. There is no colour of
    /// edges if the facet is shaded smoothly.
    Facet(RGBColor, Option<RGBColor>),
    Line(RGBColor),
    Dot(RGBColor),
}

impl Scene {
    /// The scene as an SVG text. The three axes have equal units unless the box is very thin. The farthest pieces are drawn
    /// first, so that near ones hide them. Surfaces are shaded by their slope.
    ///
    /// # Errors
    /// [`Error::Data`] if there is nothing finite to draw.
    pub(crate) fn to_svg(&self) -> Result<String> {
        load_font();
        let (camera, axes) = self.view(self.bounds()?);
        let rows = self.rows(&camera, &axes);
        let heading = heading::height(&self.title, &rows, self.width);
        let [_, below] = axes.beyond(&camera);
        let height = heading + pixels(camera.size[1] + below.max(BELOW));
        let mut svg = String::new();
        {
            let size = (self.width * FINER, height * FINER);
            let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
            let drawn = self.draw(&area, (&camera, &axes), heading, rows);
            drawn.map_err(|e| Error::data("figure", e.to_string()))?;
        }
        Ok(compacted(&shown_in_units(&svg, self.width, height)))
    }

    /// The view of the box and its axes, such that nothing is beyond the sides of the picture.
    fn view(&self, bounds: [[f64; 2]; 3]) -> (Camera, BoxAxes) {
        const ATTEMPTS: usize = 4;
        /// The box has at least this part of the width.
        const NARROWEST: f64 = 0.25;
        let width = f64::from(self.width);
        let view_with = |around: f64| {
            let room = (width - 2.0 * around).max(NARROWEST * width);
            let direction = [self.azimuth, self.elevation];
            let camera = Camera::new(bounds, direction, [room, HEIGHT]);
            let axes = BoxAxes::new(&camera);
            (camera, axes)
        };
        let mut around = AROUND;
        let (mut camera, mut axes) = view_with(around);
        for _ in 0..ATTEMPTS {
            let [aside, _] = axes.beyond(&camera);
            if aside <= (width - camera.size[0]) / 2.0 {
                break;
            }
            around = around.max(aside);
            (camera, axes) = view_with(around);
        }
        (camera, axes)
    }

    /// The given box, or the box around all finite points.
    fn bounds(&self) -> Result<[[f64; 2]; 3]> {
        let mut around = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        let finite = |p: &&[f64; 3]| p.iter().all(|v| v.is_finite());
        for p in self
            .layers
            .iter()
            .flat_map(SpaceLayer::all_points)
            .filter(finite)
        {
            for (k, v) in p.iter().enumerate() {
                around[k] = [around[k][0].min(*v), around[k][1].max(*v)];
            }
        }
        let bounds = self.bounds.unwrap_or(around);
        if bounds
            .iter()
            .any(|[a, b]| !(a.is_finite() && b.is_finite() && a <= b))
        {
            return Err(Error::data("figure", "there is nothing finite to draw"));
        }
        Ok(bounds)
    }

    fn rows(&self, camera: &Camera, axes: &BoxAxes) -> Vec<Row> {
        let mut rows: Vec<Row> = self
            .layers
            .iter()
            .enumerate()
            .filter(|(_, layer)| !layer.label.is_empty())
            .map(|(index, layer)| Row {
                label: layer.label.clone(),
                mark: match (layer.facets.is_empty(), layer.lines.is_empty()) {
                    (false, _) => Mark::Area(mixed(color(index), WHITE, 0.35).filled()),
                    (true, false) => Mark::Line(line_style(color(index))),
                    (true, true) => Mark::None,
                },
                dot: (!layer.points.is_empty()).then(|| color(index)),
            })
            .collect();
        let unequal = "the axes do not have one unit of length";
        let unequal = (!camera.equal).then(|| unequal.to_owned());
        rows.extend(axes.note().into_iter().chain(unequal).map(|label| Row {
            label,
            mark: Mark::None,
            dot: None,
        }));
        rows
    }

    fn draw<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
        (camera, axes): (&Camera, &BoxAxes),
        heading: u32,
        rows: Vec<Row>,
    ) -> Drawn<B> {
        area.fill(&WHITE)?;
        heading::draw(area, &self.title, rows, self.width)?;
        let left = (f64::from(self.width) - camera.size[0]) / 2.0;
        let place = |seen: Seen| {
            let fine = f64::from(FINER);
            (
                rounded((seen.x + left) * fine),
                rounded((seen.y + f64::from(heading)) * fine),
            )
        };
        axes.draw_walls(area, camera, &place)?;
        if self.layers.iter().all(|layer| layer.facets.is_empty()) {
            self.draw_shadows(area, camera, &place)?;
        }
        let (pieces, paints) = self.pieces(camera);
        for piece in from_behind(pieces, camera.eye()) {
            let shown: Vec<(i32, i32)> = piece
                .corners
                .iter()
                .map(|&p| place(camera.see(p)))
                .collect();
            match &paints[piece.item] {
                Paint::Facet(color, edge) => {
                    let outline: Vec<_> = shown.iter().chain(shown.first()).copied().collect();
                    area.draw(&Polygon::new(shown, color.filled()))?;
                    // A line of the same colour covers the seam between neighbouring facets.
                    let line = |color: RGBColor| ShapeStyle::from(color).stroke_width(FINER / 2);
                    let whole = piece.edges.iter().all(|edge| *edge);
                    match edge {
                        Some(edge) if whole => {
                            area.draw(&PathElement::new(outline, line(*edge)))?;
                        }
                        _ => {
                            area.draw(&PathElement::new(outline.clone(), line(*color)))?;
                            let ends = outline.windows(2).zip(&piece.edges);
                            for (ends, _) in ends.filter(|(_, drawn)| **drawn) {
                                if let Some(edge) = edge {
                                    area.draw(&PathElement::new(ends.to_vec(), line(*edge)))?;
                                }
                            }
                        }
                    }
                }
                Paint::Line(color) => {
                    area.draw(&PathElement::new(shown, line_style(*color)))?;
                }
                Paint::Dot(color) => {
                    if let Some(&at) = shown.first() {
                        area.draw(&dot(at, *color))?;
                    }
                }
            }
        }
        axes.draw_labels(area, camera, &place)?;
        area.present()
    }

    /// Draws shadows of curves on the floor, if nothing else shows how high the curves are.
    fn draw_shadows<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
        camera: &Camera,
        place: &impl Fn(Seen) -> (i32, i32),
    ) -> Drawn<B> {
        let floor = camera.bounds[2][1 - camera.front[2]];
        let style = ShapeStyle::from(RGBColor(185, 185, 185)).stroke_width(FINER);
        for line in self.layers.iter().flat_map(|layer| &layer.lines) {
            for pair in line.windows(2) {
                if let Some(ends) = cut::segment([pair[0], pair[1]], &camera.bounds) {
                    let ends = ends.map(|[x, y, _]| place(camera.see([x, y, floor])));
                    area.draw(&PathElement::new(ends.to_vec(), style))?;
                }
            }
        }
        Ok(())
    }

    /// All pieces inside the box, and the way in which each is drawn. Lines and points are moved slightly towards the eye, so
    /// that a curve on a surface is visible where the surface is.
    fn pieces(&self, camera: &Camera) -> (Vec<Piece>, Vec<Paint>) {
        let (mut all, mut paints) = (Vec::new(), Vec::new());
        let mut add = |corners: Vec<[f64; 3]>, paint: Paint| {
            all.push(Piece::whole(corners, paints.len()));
            paints.push(paint);
        };
        let finite = |p: &[f64; 3]| p.iter().all(|v| v.is_finite());
        for (index, layer) in self.layers.iter().enumerate() {
            let base = color(index);
            let inside = |p: &[f64; 3]| {
                let mut sides = p.iter().zip(&camera.bounds);
                sides.all(|(v, [a, b])| a <= v && v <= b)
            };
            let is_body = layer.closed && layer.facets.iter().flatten().all(inside);
            for (number, facet) in layer.facets.iter().enumerate() {
                if !facet.iter().all(finite) || (is_body && camera.facing(facet) < 0.0) {
                    continue;
                }
                let corners = cut::polygon(facet, &camera.bounds);
                if !corners.is_empty() {
                    let paint = facet_paint(base, &corners, layer.normals.get(number), camera);
                    add(corners, paint);
                }
            }
            for pair in layer.lines.iter().flat_map(|line| line.windows(2)) {
                if !pair.iter().all(finite) {
                    continue;
                }
                if let Some(ends) = cut::segment([pair[0], pair[1]], &camera.bounds) {
                    for piece in pieces(ends, camera) {
                        let lifted = piece.map(|p| camera.lifted(p, PIECE));
                        add(lifted.to_vec(), Paint::Line(base));
                    }
                }
            }
            for &point in layer.points.iter().filter(|p| finite(p)) {
                if cut::segment([point, point], &camera.bounds).is_some() {
                    add(vec![camera.lifted(point, 2.0 * PIECE)], Paint::Dot(base));
                }
            }
        }
        (all, paints)
    }
}

/// The way in which a facet is drawn: it is shaded by its own slope or by a given normal.
fn facet_paint(
    base: RGBColor,
    corners: &[[f64; 3]],
    normal: Option<&[f64; 3]>,
    camera: &Camera,
) -> Paint {
    let Some(&normal) = normal else {
        let shade = shaded(base, camera.facing(corners));
        return Paint::Facet(shade, Some(mixed(shade, RGBColor(0, 0, 0), 0.15)));
    };
    // A surface with normals has an inside and an outside.
    let side = if camera.facing(corners) < 0.0 {
        mixed(base, INSIDE, 0.55)
    } else {
        base
    };
    Paint::Facet(shaded(side, camera.facing_normal(corners[0], normal)), None)
}

/// The short pieces of a segment.
fn pieces([p, q]: [[f64; 3]; 2], camera: &Camera) -> Vec<[[f64; 3]; 2]> {
    let (a, b) = (camera.see(p), camera.see(q));
    let longest = camera.size[0].hypot(camera.size[1]) * PIECE;
    let count = (((b.x - a.x).hypot(b.y - a.y)) / longest)
        .ceil()
        .clamp(1.0, 1000.0);
    let at = |k: f64| [0, 1, 2].map(|i| p[i] + (q[i] - p[i]) * (k / count));
    let mut pieces = Vec::new();
    let mut k = 0.0;
    while k < count {
        pieces.push([at(k), at(k + 1.0)]);
        k += 1.0;
    }
    pieces
}

/// The shade of a facet; the light comes from the eye. Both sides of a facet look alike, because a patch may cover its surface
/// twice, once from each side.
fn shaded(base: RGBColor, facing: f64) -> RGBColor {
    let lit = mixed(base, WHITE, 0.4);
    mixed(RGBColor(30, 30, 40), lit, 0.42 + 0.58 * facing.abs())
}

/// The colour between a (t = 0) and b (t = 1).
fn mixed(a: RGBColor, b: RGBColor, t: f64) -> RGBColor {
    let channel = |a: u8, b: u8| {
        let value = f64::from(a) + t * (f64::from(b) - f64::from(a));
        u8::try_from(pixels(value.clamp(0.0, 255.0))).invariant("255 is a byte")
    };
    RGBColor(channel(a.0, b.0), channel(a.1, b.1), channel(a.2, b.2))
}

fn line_style(color: RGBColor) -> ShapeStyle {
    ShapeStyle::from(color).stroke_width(2 * FINER)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a number of pixels, rounded up"
)]
fn pixels(value: f64) -> u32 {
    value.max(0.0).ceil() as u32
}

#[expect(clippy::cast_possible_truncation, reason = "a place on the picture")]
fn rounded(value: f64) -> i32 {
    value.round() as i32
}

#[cfg(test)]
mod tests {
    use super::super::units::WIDTH;
    use super::*;

    fn scene(layers: Vec<SpaceLayer>) -> Scene {
        Scene {
            title: String::new(),
            width: WIDTH,
            bounds: None,
            azimuth: 30.0,
            elevation: 25.0,
            layers,
        }
    }

    fn square(x: f64) -> Vec<[f64; 3]> {
        vec![
            [x, -1.0, -1.0],
            [x, 1.0, -1.0],
            [x, 1.0, 1.0],
            [x, -1.0, 1.0],
        ]
    }

    #[test]
    fn what_is_nearer_is_drawn_later() {
        let layer = |x: f64| SpaceLayer {
            facets: vec![square(x)],
            ..SpaceLayer::default()
        };
        // The eye is on the side of large x.
        for (first, second) in [(0.0, 1.0), (1.0, 0.0)] {
            let svg = scene(vec![layer(first), layer(second)]).to_svg().unwrap();
            // The last facet has the colour of the nearer layer.
            let hue = |index: usize| {
                let RGBColor(r, g, b) = color(index);
                [r > b, g > b]
            };
            let last = svg.rfind("<polygon").unwrap();
            let fill = svg[last..].split("fill=\"#").nth(1).unwrap();
            let channel = |k: usize| u8::from_str_radix(&fill[2 * k..2 * k + 2], 16).unwrap();
            let nearer = usize::from(second > first);
            assert_eq!(
                [channel(0) > channel(2), channel(1) > channel(2)],
                hue(nearer)
            );
            assert_eq!(svg.matches("<polygon").count() - 3, 2);
        }
    }

    #[test]
    fn nothing_finite_is_refused() {
        let nowhere = SpaceLayer {
            points: vec![[f64::NAN, 0.0, 0.0]],
            ..SpaceLayer::default()
        };
        assert!(scene(vec![nowhere]).to_svg().is_err());
        assert!(scene(vec![]).to_svg().is_err());
    }
}
