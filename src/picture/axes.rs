//! The box of a scene: its back walls with a grid, and ticks and names on three outer edges.

use plotters::coord::Shift;
use plotters::drawing::DrawingArea;
use plotters::element::{PathElement, Polygon, Text};
use plotters::prelude::DrawingBackend;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, RGBColor, ShapeStyle};

use super::camera::{Camera, Seen};
use super::heading::Drawn;
use super::text::{font, text_width};
use super::ticks::{self, Ticks};
use super::units::FINER;

const NAMES: [&str; 3] = ["x", "y", "z"];

/// The largest number of ticks on an edge.
const MOST: usize = 6;

/// The sizes of the letters of numbers and names.
const NUMBER_SIZE: u32 = 13;
const NAME_SIZE: u32 = 17;

/// The length of the mark of a tick, and the distance from an edge to its numbers and from these to its name.
const TICK: f64 = 5.0;
const TO_NUMBER: f64 = 9.0;
const TO_NAME: f64 = 6.0;

/// Neighbouring texts have at least this distance, and letters have at least this distance from the edge of the picture.
const GAP: f64 = 4.0;

/// A text on the picture.
struct Label {
    text: String,
    size: u32,
    middle: Seen,
    /// Half the width and half the height.
    half: [f64; 2],
}

/// An outer edge of the box.
struct Edge {
    axis: usize,
    /// The side of the box in the directions of the other two axes.
    sides: [usize; 3],
    ends: [Seen; 2],
    /// The direction away from the box, of length 1.
    out: [f64; 2],
}

/// The numbers and names at the edges of a box.
pub(super) struct BoxAxes {
    edges: [Edge; 3],
    ticks: [Ticks; 3],
    labels: Vec<Label>,
}

impl BoxAxes {
    /// The axes of the box that a camera sees: along an edge of the floor for x and for y, and along the leftmost upright edge
    /// for z.
    pub(super) fn new(camera: &Camera) -> Self {
        let edges = [0, 1, 2].map(|axis| Edge::new(axis, camera));
        let ticks = ticks::fitting(camera.bounds, MOST, camera.equal, |k, ticks| {
            let labels = edges[k].numbers(ticks, camera);
            labels.windows(2).all(|pair| pair[0].is_apart(&pair[1]))
        });
        let numbers = [0, 1, 2].map(|k| edges[k].numbers(&ticks[k], camera));
        let names = edges.iter().zip(&numbers);
        let mut labels: Vec<Label> = names.map(|(edge, numbers)| edge.name(numbers)).collect();
        // Where two edges meet, one of them has no number.
        for number in numbers.into_iter().flatten() {
            if labels.iter().all(|label| label.is_apart(&number)) {
                labels.push(number);
            }
        }
        Self {
            edges,
            ticks,
            labels,
        }
    }

    /// A sentence for the legend if the numbers at the edges are not the coordinates themselves.
    pub(super) fn note(&self) -> Option<String> {
        let with_note = self.ticks.iter().zip(NAMES);
        let with_note = with_note.filter(|(ticks, _)| ticks.has_note());
        let titles: Vec<String> = with_note.map(|(ticks, name)| ticks.title(name)).collect();
        (!titles.is_empty()).then(|| format!("numbers at the axes: {}", titles.join(", ")))
    }

    /// How far the texts reach beyond the picture of the box: to the sides, and downwards.
    pub(super) fn beyond(&self, camera: &Camera) -> [f64; 2] {
        let (mut aside, mut below) = (0.0f64, 0.0f64);
        for Label { middle, half, .. } in &self.labels {
            let right = middle.x + half[0] - camera.size[0];
            aside = aside.max(right).max(half[0] - middle.x);
            below = below.max(middle.y + half[1] - camera.size[1]);
        }
        [aside + GAP, below + GAP]
    }

    /// Draws the three walls behind everything else.
    pub(super) fn draw_walls<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
        camera: &Camera,
        place: &impl Fn(Seen) -> (i32, i32),
    ) -> Drawn<B> {
        let at = |p: [f64; 3]| place(camera.see(p));
        let back = camera.front.map(|f| 1 - f);
        let grid = ShapeStyle::from(RGBColor(222, 222, 222)).stroke_width(FINER);
        let edge = ShapeStyle::from(RGBColor(150, 150, 150)).stroke_width(FINER);
        for k in 0..3 {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let corner = |a: usize, b: usize| {
                let mut sides = [0; 3];
                (sides[k], sides[i], sides[j]) = (back[k], a, b);
                camera.corner(sides)
            };
            let corners = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
            let outline: Vec<(i32, i32)> = corners.iter().map(|&p| at(p)).collect();
            area.draw(&Polygon::new(
                outline.clone(),
                RGBColor(250, 250, 250).filled(),
            ))?;
            for (along, across) in [(i, j), (j, i)] {
                for &value in self.ticks[along].values() {
                    let end = |side: usize| {
                        let mut p = camera.corner(back);
                        p[along] = value;
                        p[across] = camera.bounds[across][side];
                        at(p)
                    };
                    area.draw(&PathElement::new(vec![end(0), end(1)], grid))?;
                }
            }
            let mut closed = outline;
            closed.extend_from_within(..1);
            area.draw(&PathElement::new(closed, edge))?;
        }
        Ok(())
    }

    /// Draws the edges with their ticks, numbers and names.
    pub(super) fn draw_labels<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
        camera: &Camera,
        place: &impl Fn(Seen) -> (i32, i32),
    ) -> Drawn<B> {
        let style = ShapeStyle::from(RGBColor(60, 60, 60)).stroke_width(FINER);
        for (edge, ticks) in self.edges.iter().zip(&self.ticks) {
            let ends = edge.ends.map(place).to_vec();
            area.draw(&PathElement::new(ends, style))?;
            for &value in ticks.values() {
                let seen = edge.seen(value, camera);
                let mark = vec![place(seen), place(edge.outside(seen, TICK))];
                area.draw(&PathElement::new(mark, style))?;
            }
        }
        for label in &self.labels {
            let style = font(label.size).pos(Pos::new(HPos::Center, VPos::Center));
            let text = label.text.clone();
            area.draw(&Text::new(text, place(label.middle), style))?;
        }
        Ok(())
    }
}

impl Edge {
    fn new(axis: usize, camera: &Camera) -> Self {
        let back = camera.front.map(|f| 1 - f);
        let mut sides = camera.front;
        if axis == 2 {
            // One of the two upright edges at the sides of the picture.
            let candidates = [[camera.front[0], back[1], 0], [back[0], camera.front[1], 0]];
            let [a, b] = candidates.map(|sides| camera.see(camera.corner(sides)).x);
            sides = candidates[usize::from(b < a)];
        } else {
            sides[2] = back[2];
        }
        let ends = [0, 1].map(|side| {
            let mut sides = sides;
            sides[axis] = side;
            camera.see(camera.corner(sides))
        });
        // The outward direction: across the edge, away from the middle of the box.
        let center = camera.see(camera.bounds.map(|[a, b]| f64::midpoint(a, b)));
        let [low, high] = ends;
        let (dx, dy) = (high.x - low.x, high.y - low.y);
        let length = dx.hypot(dy).max(1e-9);
        let middle = (f64::midpoint(low.x, high.x), f64::midpoint(low.y, high.y));
        let mut out = [-dy / length, dx / length];
        if out[0] * (middle.0 - center.x) + out[1] * (middle.1 - center.y) < 0.0 {
            out = out.map(|v| -v);
        }
        Self {
            axis,
            sides,
            ends,
            out,
        }
    }

    /// The place of a number on the edge.
    fn seen(&self, value: f64, camera: &Camera) -> Seen {
        let mut p = camera.corner(self.sides);
        p[self.axis] = value;
        camera.see(p)
    }

    /// The point at a distance outside of a point of the edge.
    fn outside(&self, at: Seen, by: f64) -> Seen {
        Seen {
            x: at.x + self.out[0] * by,
            y: at.y + self.out[1] * by,
        }
    }

    /// A text whose nearest part has this distance from a point of the edge.
    fn label(&self, text: String, size: u32, at: Seen, distance: f64) -> Label {
        let half = [text_width(&text, size) / 2.0, f64::from(size) / 2.0];
        let middle = self.outside(at, distance + self.reach(half));
        Label {
            text,
            size,
            middle,
            half,
        }
    }

    /// Half the length of a text in the outward direction.
    fn reach(&self, half: [f64; 2]) -> f64 {
        self.out[0].abs() * half[0] + self.out[1].abs() * half[1]
    }

    fn numbers(&self, ticks: &Ticks, camera: &Camera) -> Vec<Label> {
        let numbers = ticks.values().iter().zip(ticks.labels());
        let label = |(value, text): (&f64, &String)| {
            let at = self.seen(*value, camera);
            self.label(text.clone(), NUMBER_SIZE, at, TO_NUMBER)
        };
        numbers.map(label).collect()
    }

    fn name(&self, numbers: &[Label]) -> Label {
        let widest = numbers.iter().map(|label| 2.0 * self.reach(label.half));
        let distance = TO_NUMBER + widest.fold(0.0, f64::max) + TO_NAME;
        let [low, high] = self.ends;
        let middle = Seen {
            x: f64::midpoint(low.x, high.x),
            y: f64::midpoint(low.y, high.y),
        };
        self.label(NAMES[self.axis].into(), NAME_SIZE, middle, distance)
    }
}

impl Label {
    fn is_apart(&self, other: &Self) -> bool {
        let [dx, dy] = [
            (self.middle.x - other.middle.x).abs(),
            (self.middle.y - other.middle.y).abs(),
        ];
        dx >= self.half[0] + other.half[0] + GAP || dy >= self.half[1] + other.half[1]
    }
}
