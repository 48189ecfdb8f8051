//! Proofs whether a polynomial has zeros on a sphere, by patches of the sphere, in doubles with bounds of their errors.

use crate::intervals::interval::{exactly, minus, product, square};
use crate::intervals::{Field, Interval};

/// The largest number of patches.
const MAX_PATCHES: usize = 30_000;
/// Patches smaller than this part of the radius are not divided.
const SMALLEST: f64 = 1e-8;
/// At the beginning each face of the cube has this many patches along each side.
const FIRST: i32 = 2;

/// The result of the search on a sphere.
#[derive(Debug, PartialEq)]
pub(super) enum OnSphere {
    /// f has both signs.
    Zeros,
    /// f has one sign.
    NoZeros,
    /// f has one sign, except perhaps near these points.
    Unknown(Vec<[f64; 3]>),
}

/// A patch of the sphere: the projection of the square [u − half, u + half] × [w − half, w + half] on a face of the cube about
/// the center.
#[derive(Clone, Copy)]
struct Patch {
    axis: usize,
    side: f64,
    u: f64,
    w: f64,
    half: f64,
}

impl Patch {
    /// The unit vector in the direction of a point of the face.
    fn direction(&self, u: Interval, w: Interval) -> [Interval; 3] {
        let mut v = [Interval::from(self.side); 3];
        v[(self.axis + 1) % 3] = u;
        v[(self.axis + 2) % 3] = w;
        let length = square(v).sqrt();
        v.map(|x| x / length)
    }

    /// The unit vector in the direction of the middle.
    fn normal(&self) -> [Interval; 3] {
        self.direction(Interval::from(self.u), Interval::from(self.w))
    }

    /// A bound of the distance between the middle and any point of the projected square. The sides are arcs of great circles,
    /// so a corner is farthest.
    fn radius(&self, normal: [Interval; 3]) -> Interval {
        let (u, w, h) = (
            Interval::from(self.u),
            Interval::from(self.w),
            Interval::from(self.half),
        );
        let corners = [
            (u - h, w - h),
            (u - h, w + h),
            (u + h, w - h),
            (u + h, w + h),
        ];
        let far = corners.map(|(u, w)| square(minus(self.direction(u, w), normal)));
        let [a, b, c, d] = far;
        a.max(b).max(c.max(d)).sqrt()
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

/// Looks for zeros of f on the sphere of radius d* about p*, where |p* − p| + |d* − d| ≤ `slack` and d* ≥ d.
///
/// Lemma 14. Let n be the unit vector of the middle of a patch, x₀ = p* + d*n, and m a double within `off` of x₀. Then
/// f is within |G|·off + (|Gₜ| + |G·n| r/(2d) )r + κ(r + off)² of f(m) at all points x of the sphere within r of x₀, where G = ∇f(m),
/// Gₜ = G − (G·n)n, and κ bounds the size of the curvature within r + off.
///
/// Proof. f(x) − f(m) = G·(x₀ − m) + G·(x − x₀) + κ′|x − m|² with |κ′| ≤ κ; and (x − x₀)·n = −|x − x₀|²/(2d*), because both
/// points are on the sphere.
///
/// Laws: `free_spheres_have_one_sign`, `touching_spheres_are_not_called_free`,
/// `doubles_beside_a_sphere_are_not_taken_for_its_points`.
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
    let (center, d) = (exactly(p), Interval::from(d));
    let mut signs = [false; 2];
    let mut unknown = Vec::new();
    let mut looked_at = 0;
    while let Some(patch) = patches.pop() {
        let normal = patch.normal();
        let exact_middle = [0, 1, 2].map(|i| center[i] + d * normal[i]);
        let middle = exact_middle.map(Interval::middle);
        let off = square(minus(exact_middle, exactly(middle))).sqrt() + Interval::from(slack);
        // d* is at most d + `slack`.
        let radius = (d + Interval::from(slack)) * patch.radius(normal);
        let local = field.local(middle);
        let outward = product(local.gradient, normal);
        let along = square([0, 1, 2].map(|i| local.gradient[i] - outward * normal[i])).sqrt();
        let bend = local.curvature((radius + off).high(), false).abs();
        let spread = |r: Interval| {
            local.slope() * off
                + (along + outward.abs() * r / (d * 2.0)) * r
                + bend * (r + off).squared()
        };
        let surplus = local.value.mignitude();
        if spread(Interval::ZERO).high() < surplus {
            signs[usize::from(local.value.is_positive())] = true;
            if signs == [true; 2] {
                return OnSphere::Zeros;
            }
        }
        looked_at += 1;
        if spread(radius).high() < surplus {
            continue;
        }
        if radius.high() < SMALLEST * d.low() || looked_at + patches.len() > MAX_PATCHES {
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
    use crate::exact::Rational;
    use crate::intervals::tests::{cubic, sphere};
    use crate::intervals::{distance, dot, rational, rationals};
    use crate::poly::{Ring, SparsePolynomial};
    use malachite::Integer;
    use malachite::base::num::arithmetic::traits::CeilingSqrt;
    use proptest::prelude::*;

    #[test]
    fn two_spheres() {
        let f = Field::new(&sphere(1));
        assert_eq!(on_sphere(&f, [0.3, 0.2, 0.1], 0.5, 0.0), OnSphere::NoZeros);
        assert_eq!(on_sphere(&f, [0.3, 0.2, 0.1], 0.9, 0.0), OnSphere::Zeros);
        // The sphere is inside the ball f < 0.
        assert_eq!(on_sphere(&f, [0.3, 0.2, 0.1], 1.4, 0.0), OnSphere::NoZeros);
        // The sphere touches the zero set in one point.
        let OnSphere::Unknown(points) = on_sphere(&f, [0.5, 0.0, 0.0], 0.5, 0.0) else {
            panic!()
        };
        assert!(points.iter().all(|x| distance(*x, [1.0, 0.0, 0.0]) < 1e-4));
    }

    proptest! {
        /// The farthest corner of a patch is at the computed distance from its middle.
        #[test]
        fn the_farthest_corner_is_at_the_radius(axis in 0usize..3, side in prop::sample::select(vec![-1.0, 1.0]), u in -0.75f64..0.75, w in -0.75f64..0.75, half in 0.01f64..0.25) {
            let patch = Patch { axis, side, u, w, half };
            let point = |u: f64, w: f64| -> [f64; 3] {
                let mut v = [side; 3];
                (v[(axis + 1) % 3], v[(axis + 2) % 3]) = (u, w);
                let length = dot(v, v).sqrt();
                v.map(|x| x / length)
            };
            let middle = point(u, w);
            let corners = [(-half, -half), (-half, half), (half, -half), (half, half)];
            let far = corners.map(|(a, b)| distance(point(u + a, w + b), middle));
            let farthest = far.into_iter().fold(0.0, f64::max);
            let radius = patch.radius(patch.normal());
            prop_assert!(radius.low() <= farthest * (1.0 + 1e-12) && radius.high() >= farthest * (1.0 - 1e-12));
            prop_assert!(radius.high() - radius.low() < 1e-12);
        }

        /// If a sphere is proved to have no zeros, f has one sign at all of its points.
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

        /// Lemma 14 on planes a·x = c whose normal has the rational length 3. A sphere that touches the plane, perhaps only
        /// with all of its slack, is not proved to have no zeros. A sphere that stays on its side, however narrowly, is not
        /// proved to have both signs.
        #[test]
        fn touching_spheres_are_not_called_free(turn in 0usize..3, signs in 0u8..8, p in prop::array::uniform3(-2.0f64..2.0), d in 0.05f64..1.0, slack in prop_oneof![Just(0.0), 1e-17f64..1e-12], nudge in -60i64..-30) {
            let sign = |k: usize| if signs >> k & 1 == 1 { -1 } else { 1 };
            let normal: [i64; 3] = std::array::from_fn(|i| [1i64, 2, 2][(i + turn) % 3] * sign(i));
            let [x, y, z] = [0, 1, 2].map(|i| SparsePolynomial::<3>::variable(i).scaled(&Rational::from(normal[i])));
            let linear = x.plus(&y).plus(&z);
            let at_p = linear.evaluate(&rationals(p));
            let three = Rational::from(3);
            // The farthest point of the sphere of radius d + slack is on the plane.
            let plane = |far: Rational| Field::new(&linear.minus(&SparsePolynomial::constant(&at_p + &(far * &three))));
            let reach = rational(d) + rational(slack);
            prop_assert!(on_sphere(&plane(reach.clone()), p, d, slack) != OnSphere::NoZeros);
            let beyond = reach + Rational::from(2).pow(nudge).unwrap();
            prop_assert!(on_sphere(&plane(beyond), p, d, slack) != OnSphere::Zeros);
        }

        /// Lemma 14 at the middle of a patch that is near the origin, where the value of f is known much better than the
        /// middle. A sphere just beside a plane is not proved to have both signs because a double is on the other side.
        #[test]
        fn doubles_beside_a_sphere_are_not_taken_for_its_points(
            axis in 0usize..3, side in prop::bool::ANY, level in 1u32..8, place in [0i64..1 << 30, 0i64..1 << 30], d in 0.05f64..4.0, nudge in -90i64..-58,
        ) {
            // The middle of a patch, times a power of two.
            let one = 1i64 << level;
            let [u, w] = place.map(|k| 2 * (k % one) + 1 - one);
            let mut normal = [if side { one } else { -one }; 3];
            normal[(axis + 1) % 3] = u;
            normal[(axis + 2) % 3] = w;
            let doubles = normal.map(|x| f64::from(i32::try_from(x).unwrap()));
            let length = dot(doubles, doubles).sqrt();
            let p = doubles.map(|x| -d * x / length);
            let linear = [0, 1, 2].map(|i| SparsePolynomial::<3>::variable(i).scaled(&Rational::from(normal[i])));
            let linear = linear[0].plus(&linear[1]).plus(&linear[2]);
            // The length of the normal; it is too large by less than 2^(−200).
            let square = normal.iter().map(|x| x * x).sum::<i64>();
            let root = (Integer::from(square) << 400u64).ceiling_sqrt();
            let far = linear.evaluate(&rationals(p)) + rational(d) * Rational::from_dyadic(root, -200);
            let beyond = far + Rational::from(2).pow(nudge).unwrap();
            let f = Field::new(&linear.minus(&SparsePolynomial::constant(beyond)));
            prop_assert!(on_sphere(&f, p, d, 0.0) != OnSphere::Zeros);
        }
    }
}
