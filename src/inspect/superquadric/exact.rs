//! Points of a superquadric with rational coordinates, for points exactly at the tolerance.

use crate::exact::Rational;
use crate::shape::{SpaceSuperquadric, Superquadric};

/// The axes on which a straight part of the surface ends: a vertex, an edge or a face.
type Straight = Vec<usize>;

/// The vertices of a superquadric, and its straight edges and faces.
#[derive(Debug)]
pub(super) struct ExactPoints {
    /// The semi-axes for the level 1; none if they are not rational.
    axes: Vec<Rational>,
    straight: Vec<Straight>,
}

impl ExactPoints {
    pub(super) fn plane(shape: &Superquadric) -> Self {
        let mut straight = vec![vec![0], vec![1]];
        if shape.epsilon() == &Rational::from(2) {
            straight.push(vec![0, 1]);
        }
        Self {
            axes: axes(shape.semi_axes(), shape.exact_scale()),
            straight,
        }
    }

    pub(super) fn space(shape: &SpaceSuperquadric) -> Self {
        let mut straight = vec![vec![0], vec![1], vec![2]];
        let [is_straight, is_straight_around] =
            shape.epsilon().each_ref().map(|e| *e == Rational::from(2));
        if is_straight_around {
            straight.push(vec![0, 1]);
        }
        if is_straight {
            straight.extend([vec![0, 2], vec![1, 2]]);
        }
        if is_straight && is_straight_around {
            straight.push(vec![0, 1, 2]);
        }
        Self {
            axes: axes(shape.semi_axes(), shape.exact_scale()),
            straight,
        }
    }

    /// The squared distance of the nearest one of these points.
    pub(super) fn nearest(&self, point: &[Rational; 3]) -> Option<Rational> {
        let distances = self.straight.iter().filter_map(|part| {
            let foot = self.foot(point, part)?;
            Some(self.squared_distance(point, &foot))
        });
        distances.min()
    }

    /// The squared distance of the farthest vertex.
    pub(super) fn farthest(&self, point: &[Rational; 3]) -> Option<Rational> {
        let distances = self.axes.iter().enumerate().map(|(i, a)| {
            let mut vertex = [0; 3].map(|_| Rational::zero());
            vertex[i] = match point[i].signum() {
                -1 => a.clone(),
                _ => -a,
            };
            self.squared_distance(point, &vertex)
        });
        distances.max()
    }

    /// The nearest point of the plane, line or vertex with Σ |x_i|/a_i = 1 over these axes on the side of the point, if it is on the
    /// surface.
    fn foot(&self, point: &[Rational; 3], part: &[usize]) -> Option<[Rational; 3]> {
        let sided = |i: usize| {
            match point[i].signum() {
                -1 => -self.axes.get(i)?.clone(),
                _ => self.axes.get(i)?.clone(),
            }
            .recip()
        };
        let normal: Vec<Rational> = part.iter().map(|&i| sided(i)).collect::<Option<_>>()?;
        let pairs = || normal.iter().zip(part);
        let value: Rational = pairs().map(|(n, &i)| n * &point[i]).sum();
        let square: Rational = normal.iter().map(|n| n * n).sum();
        let off = (Rational::one() - value) / square;
        let mut foot = [0; 3].map(|_| Rational::zero());
        for (n, &i) in pairs() {
            foot[i] = &point[i] + &(&off * n);
            if (&foot[i] * n).signum() < 0 {
                return None;
            }
        }
        Some(foot)
    }

    fn squared_distance(&self, point: &[Rational; 3], other: &[Rational; 3]) -> Rational {
        (0..self.axes.len())
            .map(|i| {
                let off = &point[i] - &other[i];
                &off * &off
            })
            .sum()
    }
}

fn axes(axes: &[Rational], scale: Option<Rational>) -> Vec<Rational> {
    scale.map_or_else(Vec::new, |scale| axes.iter().map(|a| a * &scale).collect())
}
