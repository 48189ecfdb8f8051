//! The singular curves and points of a surface in a box, for meshes and pictures.

use nalgebra::Vector3;

use super::{BoxSides, Work};
use crate::error::Result;
use crate::factor::factor_space;
use crate::intervals::{Field, between, distance};
use crate::mesh::Mesh;
use crate::parametrize::{CommonPoint, singular_locus};
use crate::shape::{ImplicitSurface, SpaceCurve};

/// The number of parameters at which a curve is evaluated first.
const SAMPLES: u32 = 360;
/// Pieces longer than this part of the diagonal of the box are halved, at most so often.
const PIECE: f64 = 0.01;
const HALVINGS: u32 = 12;

/// The parts of circles and spheres, in sides of a cell, on which signs tell what a singular curve or point is.
const RADIUS: f64 = 0.25;
const ROUND: u32 = 24;

/// What triangles do not show of a surface in a box, or not well.
#[derive(Default)]
pub(super) struct SingularParts {
    /// Singular curves without those parts along which one sheet runs.
    curves: Vec<Vec<[f64; 3]>>,
    /// Points of these curves at which sheets cross.
    pub(super) crossings: Vec<[f64; 3]>,
    /// Isolated points.
    points: Vec<[f64; 3]>,
    /// Whether there may be more.
    may_be_more: bool,
}

/// Directions in all parts of space.
fn sphere() -> impl Iterator<Item = [f64; 3]> {
    let steps = -2..=2i8;
    let all = steps.clone().flat_map(move |i| {
        let steps = steps.clone();
        steps
            .clone()
            .flat_map(move |j| steps.clone().map(move |k| [i, j, k]))
    });
    let outer = all.filter(|d| d.iter().any(|x| x.abs() == 2));
    outer.map(|d| {
        let d = d.map(f64::from);
        let length = distance(d, [0.0; 3]);
        d.map(|x| x / length)
    })
}

/// How often f changes its sign on a small circle around a point, across a direction.
fn sign_changes(field: &Field, at: [f64; 3], along: [f64; 3], radius: f64) -> usize {
    let along = Vector3::from(along);
    let other = if along.x.abs() < 0.6 * along.norm() {
        Vector3::x()
    } else {
        Vector3::y()
    };
    let first = along.cross(&other).normalize();
    let second = along.cross(&first).normalize();
    let signs: Vec<i8> = (0..ROUND)
        .map(|k| {
            // No direction of the circle is one of the axes, along which signs are often 0.
            let angle = std::f64::consts::TAU * (f64::from(k) + 0.3) / f64::from(ROUND);
            let step = radius * (angle.cos() * first + angle.sin() * second);
            field.sign([at[0] + step.x, at[1] + step.y, at[2] + step.z])
        })
        .collect();
    let next = signs.iter().cycle().skip(1);
    signs.iter().zip(next).filter(|(a, b)| a != b).count()
}

impl SingularParts {
    /// Adds those parts of a line along which the surface is not a single sheet: there f changes its sign twice on small circles
    /// around the line.
    fn add_line(&mut self, line: &[[f64; 3]], field: &Field, radius: f64) {
        let mut part: Vec<[f64; 3]> = Vec::new();
        for pair in line.windows(2) {
            let middle = between(pair[0], pair[1], 0.5);
            let along = [0, 1, 2].map(|i| pair[1][i] - pair[0][i]);
            let changes = sign_changes(field, middle, along, radius);
            if changes == 2 {
                if !part.is_empty() {
                    self.curves.push(std::mem::take(&mut part));
                }
                continue;
            }
            if changes > 2 {
                self.crossings.push(middle);
            }
            if part.is_empty() {
                part.push(pair[0]);
            }
            part.push(pair[1]);
        }
        if !part.is_empty() {
            self.curves.push(part);
        }
    }

    pub(super) fn add_to(self, mesh: &mut Mesh) {
        mesh.curves = self.curves;
        mesh.has_crossings = !self.crossings.is_empty();
        mesh.points = self.points;
        mesh.may_be_singular = self.may_be_more;
    }
}

/// The singular curves and points of a surface in a box, if its mesh says that there may be some.
pub(super) fn singular_parts(
    mesh: &Mesh,
    surface: &ImplicitSurface,
    bounds: &BoxSides,
    work: &Work,
) -> Result<SingularParts> {
    let mut parts = SingularParts::default();
    if !mesh.may_be_singular {
        return Ok(parts);
    }
    for factor in factor_space(surface.polynomial(), work.bounds())?.factors {
        let found = singular_locus(&factor.polynomial, work.bounds())?;
        parts.may_be_more |= !found.complete;
        let field = Field::new(&factor.polynomial);
        let radius = RADIUS * mesh.cell;
        for line in found.curves.iter().flat_map(|curve| in_box(curve, bounds)) {
            parts.add_line(&line, &field, radius);
        }
        let points = found.points.iter().map(CommonPoint::near);
        let is_isolated = |p: &[f64; 3]| {
            let signs = sphere().map(|d| field.sign([0, 1, 2].map(|i| p[i] + radius * d[i])));
            signs.collect::<std::collections::BTreeSet<i8>>().len() == 1
        };
        let shown = points.filter(|p| is_inside(p, bounds) && is_isolated(p));
        parts.points.extend(shown);
    }
    Ok(parts)
}

fn is_inside(p: &[f64; 3], bounds: &BoxSides) -> bool {
    p.iter().zip(bounds).all(|(x, [a, b])| a <= x && x <= b)
}

/// A parameter a/b with a point of the curve.
type Sample = ([f64; 2], [f64; 3]);

/// The parts of a curve in a box, as polylines with short pieces.
fn in_box(curve: &SpaceCurve, bounds: &BoxSides) -> Vec<Vec<[f64; 3]>> {
    let diagonal = bounds
        .iter()
        .map(|[a, b]| (b - a).powi(2))
        .sum::<f64>()
        .sqrt();
    let in_doubles = curve.in_doubles();
    let sample = |ratio: [f64; 2]| -> Sample { (ratio, in_doubles.at(ratio)) };
    let first: Vec<Sample> = (0..=SAMPLES)
        .map(|k| {
            let half_angle = std::f64::consts::PI * (f64::from(k) / f64::from(SAMPLES) - 0.5);
            sample([half_angle.sin(), half_angle.cos()])
        })
        .collect();
    let is_shown = |(_, p): &Sample| is_inside(p, bounds);
    let mut lines: Vec<Vec<[f64; 3]>> = Vec::new();
    let mut line: Vec<[f64; 3]> = Vec::new();
    for pair in first.windows(2) {
        let mut left = vec![(pair[0], pair[1], 0)];
        while let Some((a, b, halvings)) = left.pop() {
            let length = distance(a.1, b.1);
            let is_short = length <= PIECE * diagonal;
            if !is_short && halvings < HALVINGS {
                let middle = sample([a.0[0] + b.0[0], a.0[1] + b.0[1]]);
                left.push((middle, b, halvings + 1));
                left.push((a, middle, halvings + 1));
                continue;
            }
            if is_short && is_shown(&a) && is_shown(&b) {
                if line.is_empty() {
                    line.push(a.1);
                }
                line.push(b.1);
            } else if !line.is_empty() {
                lines.push(std::mem::take(&mut line));
            }
        }
    }
    if !line.is_empty() {
        lines.push(line);
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_and_a_circle_are_whole_in_a_box() {
        let curve = |text: &str| -> SpaceCurve {
            match crate::language::parse_form(text, "a test", crate::language::Numbers::Exact) {
                Ok(crate::shape::Form::SpaceCurve(curve)) => curve,
                other => panic!("{other:?}"),
            }
        };
        let bounds = [[-50.0, 50.0]; 3];
        for (text, length) in [
            ("x = 0; y = 0; z = t", 100.0),
            ("x = cos(t); y = sin(t); z = 1", 2.0 * std::f64::consts::PI),
            ("x = t; y = t^2; z = 0", 101.4),
        ] {
            let lines = in_box(&curve(text), &bounds);
            assert_eq!(lines.len(), 1, "{text}");
            let found: f64 = lines[0]
                .windows(2)
                .map(|pair| crate::intervals::distance(pair[0], pair[1]))
                .sum();
            assert!((found - length).abs() < 0.03 * length, "{text}: {found}");
        }
    }
}
