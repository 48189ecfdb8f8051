//! Whether a polynomial has zeros on a sphere: patches of the sphere, in doubles with bounds of their errors.

use crate::field::{Field, distance, dot};

/// So many patches at most.
const MAX_PATCHES: usize = 30_000;
/// Patches are not divided below this part of the radius.
const SMALLEST: f64 = 1e-8;
/// Faces of the cube are divided into so many patches along each side to begin with.
const FIRST: i32 = 2;

/// What the patches tell.
#[derive(Debug, PartialEq)]
pub(super) enum OnSphere {
    /// f has both signs.
    Zeros,
    /// f has one sign.
    NoZeros,
    /// f has one sign but perhaps in the neighbourhood of these points.
    Unknown(Vec<[f64; 3]>),
}

/// Part of a face of the cube about the centre, projected to the sphere: u and w in [u − half, u + half] and so on.
#[derive(Clone, Copy)]
struct Patch {
    axis: usize,
    side: f64,
    u: f64,
    w: f64,
    half: f64,
}

impl Patch {
    fn direction(&self, u: f64, w: f64) -> [f64; 3] {
        let mut v = [0.0; 3];
        v[self.axis] = self.side;
        v[(self.axis + 1) % 3] = u;
        v[(self.axis + 2) % 3] = w;
        let length = dot(v, v).sqrt();
        v.map(|x| x / length)
    }

    /// The farthest point of a projected square from its middle is a corner: all its sides are arcs of great circles.
    fn radius(&self, middle: [f64; 3]) -> f64 {
        let h = self.half;
        let corners = [(-h, -h), (-h, h), (h, -h), (h, h)];
        let far = corners.map(|(a, b)| distance(self.direction(self.u + a, self.w + b), middle));
        far.into_iter().fold(0.0, f64::max) * (1.0 + 1e-9)
    }

    fn quarters(self) -> [Self; 4] {
        let h = self.half / 2.0;
        [(-h, -h), (-h, h), (h, -h), (h, h)].map(|(a, b)| Self {
            u: self.u + a,
            w: self.w + b,
            half: h,
            ..self
        })
    }
}

/// Looks for zeros of f on the sphere of radius d about p, both of which may be off by `slack` together.
///
/// On a patch of radius ρ about a point m of the sphere with normal n, all w = x − m have |w·n| ≤ ρ²/(2d), so f(x) − f(m) is
/// at most |∇f − (∇f·n)n|ρ + |∇f·n|ρ²/(2d) and the curvature times ρ².
pub(super) fn on_sphere(field: &Field, p: [f64; 3], d: f64, slack: f64) -> OnSphere {
    let mut patches = Vec::new();
    let h = 1.0 / f64::from(FIRST);
    let middles = || (0..FIRST).map(move |i| f64::from(2 * i + 1) * h - 1.0);
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            for u in middles() {
                patches.extend(middles().map(|w| Patch {
                    axis,
                    side,
                    u,
                    w,
                    half: h,
                }));
            }
        }
    }
    // How far the middle of a patch may be from the sphere and from where it should be.
    let size = p.iter().fold(d, |m: f64, x| m.max(x.abs()));
    let off = 8.0 * f64::EPSILON * size + slack;
    let mut signs = [false; 2];
    let mut unknown = Vec::new();
    let mut looked_at = 0;
    while let Some(patch) = patches.pop() {
        let normal = patch.direction(patch.u, patch.w);
        let middle: [f64; 3] = std::array::from_fn(|i| p[i] + d * normal[i]);
        let radius = d * patch.radius(normal) + off;
        let local = field.local(middle);
        let outward = dot(local.gradient, normal);
        let along = (dot(local.gradient, local.gradient) - outward * outward)
            .max(0.0)
            .sqrt()
            + local.gradient_error
            + 1e-14 * outward.abs();
        let [low, high] = local.curvature(radius, false);
        let bend = low.abs().max(high.abs());
        let spread =
            |r: f64| along * r + outward.abs() * (r * r / (2.0 * d) + 2.0 * off) + bend * r * r;
        let surplus = local.value.abs() - local.error;
        let sign = usize::from(local.value > 0.0);
        if surplus > spread(off) * (1.0 + 1e-9) {
            signs[sign] = true;
            if signs == [true; 2] {
                return OnSphere::Zeros;
            }
        }
        looked_at += 1;
        if surplus > spread(radius) * (1.0 + 1e-9) {
            continue;
        }
        if radius < SMALLEST * d || looked_at + patches.len() > MAX_PATCHES {
            unknown.push(middle);
        } else {
            patches.extend(patch.quarters());
        }
    }
    if unknown.is_empty() {
        OnSphere::NoZeros
    } else {
        OnSphere::Unknown(unknown)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::tests::{cubic, sphere};
    use proptest::prelude::*;

    #[test]
    fn two_spheres() {
        let f = Field::new(&sphere(1));
        assert_eq!(on_sphere(&f, [0.3, 0.2, 0.1], 0.5, 0.0), OnSphere::NoZeros);
        assert_eq!(on_sphere(&f, [0.3, 0.2, 0.1], 0.9, 0.0), OnSphere::Zeros);
        // The small sphere inside the ball.
        assert_eq!(on_sphere(&f, [0.3, 0.2, 0.1], 1.4, 0.0), OnSphere::NoZeros);
        // Touching in one point.
        let OnSphere::Unknown(points) = on_sphere(&f, [0.5, 0.0, 0.0], 0.5, 0.0) else {
            panic!()
        };
        assert!(points.iter().all(|x| distance(*x, [1.0, 0.0, 0.0]) < 1e-4));
    }

    proptest! {
        /// No point of a sphere that is said to be free of zeros has another sign than another one.
        #[test]
        fn free_spheres_have_one_sign(c in prop::collection::vec(-9i64..10, 20), p in prop::array::uniform3(-2.0f64..2.0), d in 0.05f64..1.0, v in prop::array::uniform3(-1.0f64..1.0)) {
            prop_assume!(dot(v, v) > 1e-3);
            let f = Field::new(&cubic(&c));
            let scale = d / dot(v, v).sqrt();
            let [a, b] = [scale, -scale].map(|s| f.value(std::array::from_fn(|i| p[i] + s * v[i])));
            if a * b < 0.0 {
                prop_assert!(on_sphere(&f, p, d, 0.0) != OnSphere::NoZeros);
            }
        }
    }
}
