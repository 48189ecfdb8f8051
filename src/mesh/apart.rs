//! Parts of a surface that are apart from each other, and their meshes together.

use super::bounds::{Held, mesh_bounds};
use super::extent::{BoxSides, joined};
use super::triangles::Mesh;
use crate::error::Result;
use crate::factor::factor_space;
use crate::limits::Limits;
use crate::poly::{Ring, SparsePolynomial};
use crate::shape::ImplicitSurface;

/// A product of factors, and a box that holds all of its zeros.
struct Part {
    polynomial: SparsePolynomial<3>,
    sides: BoxSides,
}

/// The surface as several surfaces in disjoint boxes, each of which is a product of factors over Q; factors without a real point are
/// left out. `None` if it is not proved that it has such parts.
///
/// Cost: a factorization, and [`mesh_bounds`] for each factor if there are several.
///
/// # Errors
/// Those of [`mesh_bounds`].
pub(crate) fn parts_apart(
    surface: &ImplicitSurface,
    limits: &Limits,
) -> Result<Option<Vec<ImplicitSurface>>> {
    let surface = surface.in_original_coordinates(limits)?;
    let factors = factor_space(surface.polynomial(), limits)?.factors;
    if factors.len() < 2 {
        return Ok(None);
    }
    let mut parts: Vec<Part> = Vec::new();
    for factor in factors {
        let found = mesh_bounds(&ImplicitSurface::new(factor.polynomial.clone()), limits)?;
        let Some(found) = found else {
            continue;
        };
        if found.held != Held::Whole {
            return Ok(None);
        }
        add(
            &mut parts,
            Part {
                polynomial: factor.polynomial,
                sides: found.bounds,
            },
        );
    }
    let surfaces = parts
        .into_iter()
        .map(|part| ImplicitSurface::new(part.polynomial));
    Ok(Some(surfaces.collect()).filter(|parts: &Vec<_>| parts.len() > 1))
}

/// Adds a part, together with all parts whose boxes it meets, and those which the larger box then meets.
fn add(parts: &mut Vec<Part>, mut new: Part) {
    while let Some(index) = parts.iter().position(|part| meet(&part.sides, &new.sides)) {
        let other = parts.remove(index);
        new = Part {
            polynomial: other.polynomial.times(&new.polynomial),
            sides: joined(other.sides, new.sides),
        };
    }
    parts.push(new);
}

fn meet(a: &BoxSides, b: &BoxSides) -> bool {
    a.iter().zip(b).all(|(a, b)| a[0] <= b[1] && b[0] <= a[1])
}

impl Mesh {
    /// Adds the mesh of a surface that is apart from this one: the boxes that are proved to hold the two are disjoint.
    ///
    /// # Errors
    /// [`crate::error::Error::Limit`] for more than 2³² vertices.
    pub(crate) fn append(&mut self, other: Self) -> Result<()> {
        let first = self.index_of_next(other.vertices.len())?;
        let before = self.triangles.len();
        self.factors
            .extend(other.factors.iter().map(|index| before + index));
        let moved = other.triangles.iter().map(|t| t.map(|v| v + first));
        self.triangles.extend(moved);
        self.vertices.extend(other.vertices);
        self.normals.extend(other.normals);
        self.vertex_bound = self.vertex_bound.max(other.vertex_bound);
        self.boxes += other.boxes;
        self.cell = match (self.cells[1], other.cells[1]) {
            (1.., 0) => self.cell,
            (0, 1..) => other.cell,
            _ => self.cell.max(other.cell),
        };
        for (sum, count) in self.cells.iter_mut().zip(other.cells) {
            *sum += count;
        }
        self.shared_cells += other.shared_cells;
        self.held = self.held.and(other.held);
        self.may_be_singular |= other.may_be_singular;
        self.may_meet_origin |= other.may_meet_origin;
        self.curves.extend(other.curves);
        self.has_crossings |= other.has_crossings;
        self.points.extend(other.points);
        self.inward += other.inward;
        self.bent_edges += other.bent_edges;
        self.merged += other.merged;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::Form;

    fn surface(text: &str) -> ImplicitSurface {
        match text.parse() {
            Ok(Form::Surface(surface)) => surface,
            other => unreachable!("{other:?}"),
        }
    }

    fn count(text: &str) -> Option<usize> {
        let parts = parts_apart(&surface(text), &Limits::none()).unwrap();
        parts.map(|parts| parts.len())
    }

    #[test]
    fn factors_in_disjoint_boxes_are_apart() {
        let ball = |x: i64, r: i64| format!("((x-{x})^2 + y^2 + z^2 - {})", r * r);
        let product = |balls: &[(i64, i64)]| {
            let all: Vec<_> = balls.iter().map(|(x, r)| ball(*x, *r)).collect();
            all.join("*")
        };
        assert_eq!(count(&product(&[(0, 1), (100, 1)])), Some(2));
        assert_eq!(count(&product(&[(0, 1), (0, 2)])), None);
        assert_eq!(count(&product(&[(0, 1), (1, 1), (100, 1)])), Some(2));
        // The third box meets both others.
        assert_eq!(count(&product(&[(0, 2), (6, 2), (3, 2)])), None);
        // A factor without real points, an unbounded one, and a single one.
        let pair = product(&[(0, 1), (100, 1)]);
        assert_eq!(count(&format!("{pair}*(x^2+y^4+z^2+1)")), Some(2));
        assert_eq!(count(&format!("{pair}*(y-9)")), None);
        assert_eq!(count(&ball(0, 1)), None);
    }
}
