//! The distance of a point from a quadric or a conic, by the roots of a polynomial of degree at most 6 in Lagrange's multiplier.
//!
//! Let f = xᵀAx + 2bᵀx + c, and let g = Ap + b be half of the gradient at the point p. Where the gradient of f is not 0, the
//! nearest points x fulfil x − p = −λ(Ax + b) for a number λ, so (I + λA)(x − p) = −λg.
//!
//! **Lemma.** Let y = (I + λA)⁻¹g, as a vector of rational functions of λ in lowest terms. The critical points of the distance
//! on f = 0 are, besides points at which the gradient is 0:
//!
//! - x = p − λy for the real roots λ of F = f(p) − λ g·y − λ|y|²; their squared distance is λ²|y|²;
//! - for the roots λ of det(I + λA) at which y has no pole, the points x = p − λy + k with f(x) = 0 and k in the kernel of
//!   I + λA; there are such points if and only if λF(λ) ≥ 0, and their squared distance is λ²|y|² + λF(λ).
//!
//! Proof. With x = p − λy one has f(x) = f(p) − 2λ g·y + λ² yᵀAy, and λAy = g − y, so f(x) = F(λ). If λ is no root of the
//! determinant, x is the only solution. If it is one, let k be in the kernel, k ≠ 0. As A is symmetric, kᵀ(I + tA) = (1 − t/λ)kᵀ, so
//! (1 − t/λ) k·y(t) = k·g for all t. If y has no pole at λ, k·g = 0, and y(λ) is a solution that is orthogonal to the kernel; then |x − p|² +
//! λf(x) does not change along the kernel, because its gradient is 0 there, so f(x) = 0 if and only if |k|² = λF(λ), and the
//! kernel has vectors of every length. If y has a pole at λ, then k·g ≠ 0 for some k (else y(t), which is in the orthogonal complement of
//! the kernel, would tend to a solution there), and there is no solution. ∎
//!
//! Law: `distances_are_those_of_many_points`.

use nalgebra::Matrix3;

use super::DistanceBounds;
use super::exact::{exact_difference, power_of_two, squared_length};
use super::linear::solved;
use crate::error::Invariant;
use crate::exact::Rational;
use crate::intervals::{Field, Interval};
use crate::poly::{IntegerPolynomial, RationalFunction, Ring, SparsePolynomial};
use crate::roots::{RealRoot, real_roots};

/// The squared distance is computed to about so many bits.
const BITS: i64 = 80;
/// The largest precision of a root, for a squared distance that cancels.
const MOST_BITS: i64 = 2000;

/// A polynomial of degree 2 with its matrix.
pub(super) struct Quadric<'a> {
    polynomial: &'a SparsePolynomial<3>,
    matrix: [[Rational; 3]; 3],
}

/// The nearest point of a quadric.
pub(super) struct NearestOnQuadric {
    /// The squares of bounds of the distance.
    pub(super) squares: [Rational; 2],
    /// About the point.
    pub(super) foot: [f64; 3],
}

impl NearestOnQuadric {
    /// What is known of the nearer one of two points.
    fn or_nearer(self, other: Self) -> Self {
        let foot = if other.squares[1] < self.squares[1] {
            other.foot
        } else {
            self.foot
        };
        let [[a, b], [c, d]] = [self.squares, other.squares];
        Self {
            squares: [a.min(c), b.min(d)],
            foot,
        }
    }

    /// The bounds of the distance.
    pub(super) fn bounds(&self) -> DistanceBounds {
        let [low, high] = &self.squares;
        if high.is_zero() {
            return DistanceBounds::ZERO;
        }
        let root = |square: &Rational| Interval::from(square).or_zero().sqrt();
        DistanceBounds {
            low: root(low).low(),
            high: root(high).high(),
        }
    }
}

impl<'a> Quadric<'a> {
    /// `None` for a polynomial of another degree.
    pub(super) fn of(field: &'a Field) -> Option<Self> {
        let polynomial = field.polynomial();
        if polynomial.degree() != Some(2) {
            return None;
        }
        let mut matrix: [[Rational; 3]; 3] = Default::default();
        for (e, c) in polynomial.terms() {
            let mut axes = (0..3).flat_map(|i| std::iter::repeat_n(i, e[i] as usize));
            if let (Some(i), Some(j)) = (axes.next(), axes.next()) {
                let half = c / &Rational::from(2);
                matrix[i][j] = &matrix[i][j] + &half;
                matrix[j][i] = &matrix[j][i] + half;
            }
        }
        Some(Self { polynomial, matrix })
    }

    /// The nearest point; `None` if there is no real point.
    pub(super) fn nearest(&self, p: &[Rational; 3]) -> Option<NearestOnQuadric> {
        let here = self.polynomial.evaluate(p);
        if here.is_zero() {
            return Some(NearestOnQuadric {
                squares: [Rational::zero(), Rational::zero()],
                foot: p.each_ref().map(Rational::to_f64),
            });
        }
        let two = Rational::from(2);
        let g: [Rational; 3] =
            std::array::from_fn(|i| self.polynomial.derivative(i).evaluate(p) / &two);
        let (determinant, adjoint) = self.of_multiplier(&g);
        let multiplier = Multiplier::new(p, &here, &g, &determinant, &adjoint);
        let mut found = Vec::new();
        for root in real_roots(multiplier.value.numerator()) {
            found.push(multiplier.regular(root)?);
        }
        for root in RealRoot::all_of(&determinant) {
            if multiplier.has_special(&root) {
                found.push(multiplier.special(root, |lambda| self.kernel(lambda))?);
            }
        }
        found.extend(self.nearest_singular(p, &g));
        found.into_iter().reduce(NearestOnQuadric::or_nearer)
    }

    /// det(I + λA), and the adjoint matrix of I + λA times g, by the coefficients of powers of λ.
    fn of_multiplier(&self, g: &[Rational; 3]) -> ([Rational; 4], [[Rational; 3]; 3]) {
        let a = &self.matrix;
        let minor = |i: usize, j: usize| {
            let [r, s] = [(i + 1) % 3, (i + 2) % 3];
            let [u, v] = [(j + 1) % 3, (j + 2) % 3];
            &a[r][u] * &a[s][v] - &a[r][v] * &a[s][u]
        };
        let adjoint: [[Rational; 3]; 3] =
            std::array::from_fn(|i| std::array::from_fn(|j| minor(j, i)));
        let trace = &a[0][0] + &a[1][1] + &a[2][2];
        let minors = &adjoint[0][0] + &adjoint[1][1] + &adjoint[2][2];
        let determinant = (0..3).map(|j| &a[0][j] * &adjoint[j][0]).sum();
        let times = |m: &[[Rational; 3]; 3], i: usize| -> Rational {
            m[i].iter().zip(g).map(|(m, g)| m * g).sum()
        };
        let above = std::array::from_fn(|i| {
            // adj(I + λA) = I + λ (tr A − A) + λ² adj A
            let first = &trace * &g[i] - times(a, i);
            [g[i].clone(), first, times(&adjoint, i)]
        });
        ([Rational::one(), trace, minors, determinant], above)
    }

    /// About a unit vector of the kernel of I + λA.
    fn kernel(&self, lambda: f64) -> [f64; 3] {
        let matrix = Matrix3::from_fn(|i, j| self.matrix[i][j].to_f64());
        let eigen = matrix.symmetric_eigen();
        let off = |k: usize| (1.0 + lambda * eigen.eigenvalues[k]).abs();
        let nearest = (0..3).min_by(|&j, &k| off(j).total_cmp(&off(k)));
        let k = nearest.invariant("there are three eigenvalues");
        eigen.eigenvectors.column(k).into_owned().into()
    }

    /// The nearest zero with the gradient 0, x = p + v with Av = −g.
    fn nearest_singular(&self, p: &[Rational; 3], g: &[Rational; 3]) -> Option<NearestOnQuadric> {
        let a = &self.matrix;
        let times = |v: &[Rational; 3]| -> [Rational; 3] {
            std::array::from_fn(|i| a[i].iter().zip(v).map(|(a, v)| a * v).sum())
        };
        // The shortest solution is a multiple of A: v = −Az with A²z = g.
        let rows = std::array::from_fn(|i| {
            let [x, y, z] = times(&a[i]);
            [x, y, z, g[i].clone()]
        });
        let (z, _) = solved(rows);
        let back = times(&z);
        if times(&back) != *g {
            return None;
        }
        let x = exact_difference(p, &back);
        self.polynomial.evaluate(&x).is_zero().then(|| {
            let square = squared_length(&back);
            NearestOnQuadric {
                squares: [square.clone(), square],
                foot: x.map(|x| x.to_f64()),
            }
        })
    }
}

/// The functions of λ of the lemma, for a point.
struct Multiplier<'a> {
    p: &'a [Rational; 3],
    /// y = (I + λA)⁻¹g.
    y: [RationalFunction; 3],
    /// λ²|y|², the squared distance of p − λy.
    square: RationalFunction,
    /// F, the value of f at p − λy.
    value: RationalFunction,
    /// λF, the squared length of k.
    beyond: RationalFunction,
}

impl<'a> Multiplier<'a> {
    /// From f(p), g, and the coefficients of det(I + λA) and of adj(I + λA)g.
    fn new(
        p: &'a [Rational; 3],
        here: &Rational,
        g: &[Rational; 3],
        determinant: &[Rational],
        adjoint: &[[Rational; 3]; 3],
    ) -> Self {
        let function = |above: &[Rational], below: &[Rational]| {
            RationalFunction::new(above, below).invariant("neither 1 nor det(I + λA) is 0")
        };
        let one = [Rational::one()];
        let lambda = function(&[Rational::zero(), Rational::one()], &one);
        let y = adjoint.each_ref().map(|above| function(above, determinant));
        let zero = RationalFunction::default;
        let length = y.iter().fold(zero(), |sum, y| sum.plus(&y.squared()));
        let along = y.iter().zip(g).fold(zero(), |sum, (y, g)| {
            sum.plus(&y.times(&function(std::slice::from_ref(g), &one)))
        });
        let change = lambda.times(&along.plus(&length));
        let value = zero().minus(&change).plus_constant(here);
        Self {
            p,
            square: lambda.squared().times(&length),
            beyond: lambda.times(&value),
            value,
            y,
        }
    }

    /// About the point p − λy; `None` at a pole.
    fn point(&self, root: &RealRoot) -> Option<[f64; 3]> {
        let (low, high) = root.bounds();
        let lambda = (low + high) / Rational::from(2);
        let mut point = [0.0; 3];
        for (i, y) in self.y.iter().enumerate() {
            point[i] = (&self.p[i] - y.evaluate(&lambda)? * &lambda).to_f64();
        }
        Some(point)
    }

    /// The critical point of a root of F.
    fn regular(&self, mut root: RealRoot) -> Option<NearestOnQuadric> {
        Some(NearestOnQuadric {
            squares: enclosed(&mut root, &self.square)?,
            foot: self.point(&root)?,
        })
    }

    /// Whether there are critical points for a root of det(I + λA).
    fn has_special(&self, root: &RealRoot) -> bool {
        let has_pole = self.y.iter().any(|y| root.is_root_of(y.denominator()));
        let sign =
            |f: &RationalFunction| root.sign_of(f.numerator()) * root.sign_of(f.denominator());
        !has_pole && sign(&self.beyond) >= 0
    }

    /// One of these points; `kernel` are unit vectors of the kernel.
    fn special(
        &self,
        mut root: RealRoot,
        kernel: impl Fn(f64) -> [f64; 3],
    ) -> Option<NearestOnQuadric> {
        let squares = enclosed(&mut root, &self.square.plus(&self.beyond))?;
        let length = enclosed(&mut root, &self.beyond)?[1]
            .to_f64()
            .max(0.0)
            .sqrt();
        let middle = self.point(&root)?;
        let along = kernel(root.to_f64());
        let foot = std::array::from_fn(|i| middle[i] + length * along[i]);
        Some(NearestOnQuadric { squares, foot })
    }
}

/// Bounds of a function at a root, narrow ones if the value is not 0; `None` if the root is a pole.
fn enclosed(root: &mut RealRoot, f: &RationalFunction) -> Option<[Rational; 2]> {
    let mut bits = BITS;
    loop {
        root.refine(bits);
        let (low, high) = root.bounds();
        let place = [low, high];
        let [above, below] = [f.numerator(), f.denominator()].map(|f| range(f, &place));
        let quotient = (below[0].signum() * below[1].signum() > 0)
            .then(|| ends(above.iter().flat_map(|a| below.iter().map(move |b| a / b))));
        let is_last = bits > MOST_BITS;
        if let Some([low, high]) = quotient {
            let size = low.abs().max(high.abs());
            let width = &high - &low;
            if is_last || width * power_of_two(BITS / 2 + 20) <= size {
                return Some([low, high]);
            }
        } else if is_last {
            return None;
        }
        bits *= 2;
    }
}

/// Bounds of a polynomial on an interval.
fn range(f: &IntegerPolynomial, x: &[Rational; 2]) -> [Rational; 2] {
    let zero = || [Rational::zero(), Rational::zero()];
    f.coefficients_asc().iter().rev().fold(zero(), |value, c| {
        let products = value.iter().flat_map(|v| x.iter().map(move |x| v * x));
        let c = Rational::whole(c);
        ends(products).map(|end| end + &c)
    })
}

/// The least and the greatest of some numbers.
fn ends(numbers: impl Iterator<Item = Rational>) -> [Rational; 2] {
    let mut all: Vec<Rational> = numbers.collect();
    all.sort_unstable();
    let high = all.pop().invariant("there are numbers");
    [all.into_iter().next().unwrap_or_else(|| high.clone()), high]
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::intervals::rational;
    use crate::language::{Numbers, parse_form};
    use crate::shape::Form;

    fn polynomial(form: &str) -> SparsePolynomial<3> {
        match parse_form(form, "<form>", Numbers::Exact).unwrap() {
            Form::Surface(surface) => surface.polynomial().clone(),
            Form::Curve(curve) => curve.polynomial().into(),
            other => panic!("{other:?}"),
        }
    }

    fn nearest(f: &SparsePolynomial<3>, p: &[Rational; 3]) -> Option<([f64; 2], [f64; 3])> {
        let field = Field::new(f);
        let found = Quadric::of(&field).unwrap().nearest(p)?;
        let bounds = found.bounds();
        Some(([bounds.low, bounds.high], found.foot))
    }

    /// Points in special positions have whole circles or pairs of nearest points, or the nearest point is singular.
    #[test]
    fn points_in_special_positions() {
        for (form, point, square) in [
            ("x^2 + y^2 + z^2 = 1", ["0", "0", "0"], "1"),
            ("x^2 + y^2 + z^2 = 1", ["3", "4", "12"], "144"),
            ("x^2 + y^2 = 2", ["0", "0", "0"], "2"),
            ("x^2/9 + y^2/4 + z^2 = 1", ["0", "0", "0"], "1"),
            ("x^2/9 + y^2/4 + z^2 = 1", ["1", "0", "0"], "7/8"),
            ("x^2/9 + y^2/4 = 1", ["0", "0", "0"], "4"),
            ("x^2/9 + y^2/4 = 1", ["1", "0", "0"], "16/5"),
            // A spheroid, from its axis and from its equator.
            ("x^2 + y^2 + 4*z^2 = 4", ["0", "0", "0"], "1"),
            ("x^2/4 + y^2 + z^2 = 1", ["1", "0", "0"], "2/3"),
            // A paraboloid of revolution, from its axis, and a parabola.
            ("z = x^2 + y^2", ["0", "0", "1"], "3/4"),
            ("z = x^2 + y^2", ["0", "0", "1/4"], "1/16"),
            ("y = x^2", ["0", "1", "0"], "3/4"),
            ("x^2 + y^2 = z^2", ["0", "0", "1"], "1/2"),
            // The apex of a cone, an isolated point, and the crossing of two lines.
            ("x^2 + y^2 = 3*z^2", ["0", "0", "0"], "0"),
            ("x^2 + y^2 = z^2", ["5", "0", "-5"], "0"),
            ("x^2 + 2*y^2 + 3*z^2 = 0", ["1", "2", "3"], "14"),
            ("(x-1)^2 + 2*(y-2)^2 + 3*(z-4)^2 = 0", ["0", "0", "0"], "21"),
            ("x^2 = 2*y^2", ["1", "0", "0"], "1/3"),
            ("x^2 + y^2 = 0", ["3", "4", "0"], "25"),
            ("x^2 + y^2 + 0*z = 0", ["3", "4", "9"], "25"),
            ("x*y = 1", ["0", "0", "0"], "2"),
            ("x^2 - y^2 = 1", ["0", "3", "0"], "11/2"),
            ("x^2 - y^2 - z^2 = 1", ["0", "0", "0"], "1"),
        ] {
            let p = point.map(|c| c.parse().unwrap());
            let ([low, high], foot) = nearest(&polynomial(form), &p).unwrap();
            let square: Rational = square.parse().unwrap();
            assert!(
                rational(low).pow(2).unwrap() <= square,
                "{form} {point:?}: {low}"
            );
            assert!(
                square <= rational(high).pow(2).unwrap(),
                "{form} {point:?}: {high}"
            );
            assert!(high - low <= 1e-14 * high, "{form} {point:?}: {low} {high}");
            let value = polynomial(form).evaluate(&foot.map(rational)).to_f64();
            assert!(value.abs() < 1e-12, "{form} {point:?}: {foot:?}");
        }
    }

    #[test]
    fn without_real_points_there_is_no_distance() {
        for form in [
            "x^2 + y^2 + 1 = 0",
            "x^2 + y^2 + z^2 + 1 = 0",
            "x^2 + 0*y = -2",
        ] {
            let p = [1, 2, 0].map(Rational::from);
            assert_eq!(nearest(&polynomial(form), &p), None, "{form}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]

        /// Lemma: no zero on any of many lines through the point is nearer, and the foot is a zero at the distance.
        #[test]
        fn distances_are_those_of_many_points(
            coefficients in prop::array::uniform10(-4i64..5),
            is_flat in any::<bool>(),
            p in prop::array::uniform3(-12i64..13),
        ) {
            let exponents = [
                [2, 0, 0], [0, 2, 0], [0, 0, 2], [1, 1, 0], [1, 0, 1], [0, 1, 1], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0],
            ];
            let terms = exponents.into_iter().zip(coefficients);
            let used = terms.filter(|(e, _)| !is_flat || e[2] == 0);
            let f = SparsePolynomial::from_terms(used.map(|(e, c)| (e, Rational::from(c))));
            prop_assume!(f.degree() == Some(2));
            let mut p = p.map(|c| Rational::from(c) / Rational::from(4));
            if is_flat {
                p[2] = Rational::zero();
            }
            let about = f.about(&p, &crate::limits::Limits::none()).unwrap();
            let heights = if is_flat { 0..1 } else { -12..13 };
            let mut least = f64::INFINITY;
            for height in heights {
                for k in 0..60 {
                    let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / 60.0).sin_cos();
                    let z = f64::from(height) / 12.5;
                    let r = (1.0 - z * z).sqrt();
                    let u = [r * cos, r * sin, z].map(rational);
                    let row: Vec<f64> = about.along(&u).iter().map(Rational::to_f64).collect();
                    let [c, b, a] = [0, 1, 2].map(|i| row.get(i).copied().unwrap_or(0.0));
                    let root = (b * b - 4.0 * a * c).sqrt();
                    // The smaller root, without cancellation.
                    let t = (2.0 * c / (b.abs() + root)).abs();
                    if t.is_finite() {
                        least = least.min(t);
                    }
                }
            }
            match nearest(&f, &p) {
                None => prop_assert!(least.is_infinite(), "{least}"),
                Some(([low, high], foot)) => {
                    prop_assert!(low <= least * (1.0 + 1e-9), "{low} {least}");
                    prop_assert!(high - low <= 1e-12 * high);
                    let from = p.each_ref().map(Rational::to_f64);
                    let length = crate::intervals::distance(from, foot);
                    prop_assert!((length - high).abs() <= 1e-7 * (1.0 + high), "{length} {high}");
                    let value = f.evaluate(&foot.map(rational)).to_f64();
                    let slope = (0..3).map(|i| f.derivative(i).evaluate(&foot.map(rational)).to_f64().abs());
                    let slope: f64 = slope.sum();
                    prop_assert!(value.abs() <= 1e-6 * (1.0 + high) * (1e-6 + slope), "{value} {slope}");
                }
            }
        }
    }
}
