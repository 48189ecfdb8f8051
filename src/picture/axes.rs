//! The box of a scene: its back walls with a grid, and ticks and names on three outer edges.

use plotters::coord::Shift;
use plotters::drawing::DrawingArea;
use plotters::element::{PathElement, Polygon, Text};
use plotters::prelude::DrawingBackend;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, RGBColor, ShapeStyle, TextStyle};

use super::camera::{Camera, Seen};
use super::heading::{Drawn, FINER, font, tick};

const NAMES: [&str; 3] = ["x", "y", "z"];

/// The distances, in units, from an edge to the numbers of its ticks and to its name.
const TO_NUMBER: f64 = 18.0;
const TO_NAME: f64 = 46.0;

/// The ticks of an axis: three to seven numbers that are multiples of 1, 2 or 5 times a power of ten.
fn ticks([low, high]: [f64; 2]) -> Vec<f64> {
    let rough = (high - low) / 5.0;
    let power = 10f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0]
        .map(|m| m * power)
        .into_iter()
        .find(|&s| s >= rough * 0.999)
        .unwrap_or(rough);
    let slack = 1e-9 * (high - low);
    let mut ticks = Vec::new();
    let mut k = ((low - slack) / step).ceil();
    while k * step <= high + slack && ticks.len() < 20 {
        ticks.push(k * step);
        k += 1.0;
    }
    ticks
}

/// Draws the three walls behind everything else.
pub(super) fn draw_walls<B: DrawingBackend>(
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
            for value in ticks(camera.bounds[along]) {
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

/// Draws the numbers and names along an edge of the floor for x and for y, and along the leftmost upright edge for z.
pub(super) fn draw_labels<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    camera: &Camera,
    place: &impl Fn(Seen) -> (i32, i32),
) -> Drawn<B> {
    let center =
        camera.see([0, 1, 2].map(|k| f64::midpoint(camera.bounds[k][0], camera.bounds[k][1])));
    let back = camera.front.map(|f| 1 - f);
    for k in 0..3 {
        let mut sides = camera.front;
        if k == 2 {
            // One of the two upright edges at the sides of the picture.
            let candidates = [[camera.front[0], back[1], 0], [back[0], camera.front[1], 0]];
            let [a, b] = candidates.map(|sides| camera.see(camera.corner(sides)).x);
            sides = candidates[usize::from(b < a)];
        } else {
            sides[2] = back[2];
        }
        let end = |side: usize| {
            let mut sides = sides;
            sides[k] = side;
            camera.see(camera.corner(sides))
        };
        let (low, high) = (end(0), end(1));
        // The outward direction: across the edge, away from the middle of the box.
        let (dx, dy) = (high.x - low.x, high.y - low.y);
        let length = dx.hypot(dy).max(1e-9);
        let middle = (f64::midpoint(low.x, high.x), f64::midpoint(low.y, high.y));
        let mut out = (-dy / length, dx / length);
        if out.0 * (middle.0 - center.x) + out.1 * (middle.1 - center.y) < 0.0 {
            out = (-out.0, -out.1);
        }
        let moved = |x: f64, y: f64, by: f64| {
            place(Seen {
                x: x + out.0 * by,
                y: y + out.1 * by,
            })
        };
        let edge = ShapeStyle::from(RGBColor(60, 60, 60)).stroke_width(FINER);
        let ends = vec![place(low), place(high)];
        area.draw(&PathElement::new(ends, edge))?;
        for value in ticks(camera.bounds[k]) {
            let mut p = camera.corner(sides);
            p[k] = value;
            let seen = camera.see(p);
            let mark = vec![place(seen), moved(seen.x, seen.y, 5.0)];
            area.draw(&PathElement::new(mark, edge))?;
            let at = moved(seen.x, seen.y, TO_NUMBER);
            area.draw(&Text::new(tick(value), at, centered(13)))?;
        }
        let at = moved(middle.0, middle.1, TO_NAME);
        area.draw(&Text::new(NAMES[k], at, centered(17)))?;
    }
    Ok(())
}

fn centered(size: u32) -> TextStyle<'static> {
    font(size).pos(Pos::new(HPos::Center, VPos::Center))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn ticks_are_few_and_inside(low in -1e3f64..1e3, size in 1e-3f64..1e4) {
            let found = ticks([low, low + size]);
            prop_assert!((2..=7).contains(&found.len()), "{:?}", found);
            prop_assert!(found.iter().all(|v| *v >= low - 1e-6 * size && *v <= low + size * 1.000_001));
        }
    }
}
