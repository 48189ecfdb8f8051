//! The points of a curve or a surface on one line through the origin.

use std::sync::OnceLock;
use std::sync::atomic::AtomicU64;
use std::sync::atomic::Ordering::Relaxed;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Gcd;
use malachite::base::num::basic::traits::One;
use malachite::base::polynomial::Polynomial;

use super::guess::real_root_guesses;
use super::ladder::{LEVELS, Ladder};
use super::parts::{ExpandedParts, HomogeneousParts, PartsByDegree};
use super::point::{Found, Ray, Sample, in_order};
use super::unit_vector::{RationalLine, UnitVector};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::IntegerPolynomial;
use crate::roots::{RealRoot, real_roots};

/// A guess in doubles is used only if it is proved to this many bits.
const GUESS_BITS: i64 = 40;

/// Solves f = 0 along lines through the origin.
///
/// In a direction (u, v), f(ru, rv) = Σ_d r^d f_d(u, v) is a polynomial in r whose coefficients are the values of the
/// homogeneous parts (§3 of the paper). A power of r is divided out, and a polynomial in r^k is treated as one in a single
/// variable. Its roots are isolated exactly and rounded exactly.
///
/// ```
/// use stellate::poly::PlanePolynomial;
/// use stellate::sample::{Direction, Ray, RaySolver};
///
/// // x² + y² − 2x: a circle through the origin.
/// let f = PlanePolynomial::from_terms([((2, 0), 1.into()), ((0, 2), 1.into()), ((1, 0), (-2).into())]);
/// let solver = RaySolver::new(&f);
/// let Ray::Points(points) = solver.solve(&Direction::from_radians(1.0)) else { panic!() };
/// assert_eq!(points.len(), 1);
/// assert_eq!(points[0].r, 2.0 * 1f64.cos());
/// ```
#[derive(Debug)]
pub struct RaySolver<'a, P, const V: usize> {
    polynomial: &'a P,
    /// The center c, from which rays begin; `None` if it is the origin of the points' coordinates.
    center: Option<[Rational; V]>,
    expansion: OnceLock<ExpandedParts<'a, V>>,
    ladder: Ladder<V>,
    exact: AtomicU64,
}

/// The number of directions that each precision decided.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct StageCounts {
    /// The number of directions that bounded arithmetic decided, for each precision of [`StageCounts::BITS`].
    pub bounded: [u64; LEVELS],
    /// The number of directions that exact arithmetic decided.
    pub exact: u64,
}

impl StageCounts {
    /// The precisions of bounded arithmetic, in bits.
    pub const BITS: [u32; LEVELS] = [128, 192, 256, 384, 512, 768];
}

impl<'a, P: HomogeneousParts<V>, const V: usize> RaySolver<'a, P, V> {
    /// The solver for the curve or surface `polynomial = 0`.
    #[must_use]
    pub fn new(polynomial: &'a P) -> Self {
        Self {
            polynomial,
            center: None,
            expansion: OnceLock::new(),
            ladder: Ladder::default(),
            exact: AtomicU64::new(0),
        }
    }

    /// Sets the center c of the polynomial's coordinates. The coordinates of points are c + r·(u, v), each rounded once.
    ///
    /// ```
    /// use stellate::poly::PlanePolynomial;
    /// use stellate::sample::{Direction, Ray, RaySolver};
    ///
    /// // The circle of radius 1/10 about (1/5, 3).
    /// let f = PlanePolynomial::from_terms([((2, 0), 100.into()), ((0, 2), 100.into()), ((0, 0), (-1).into())]);
    /// let solver = RaySolver::new(&f).about(["1/5".parse()?, 3.into()]);
    /// let Ray::Points(points) = solver.solve(&Direction::from_radians(0.0)) else { panic!() };
    /// assert_eq!(points[0].position, [0.3, 3.0]); // and not 0.2 + 0.1 in doubles
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    #[must_use]
    pub fn about(self, center: [Rational; V]) -> Self {
        let is_origin = center.iter().all(Rational::is_zero);
        Self {
            center: (!is_origin).then_some(center),
            ..self
        }
    }

    /// Finds the points in one direction.
    ///
    /// Bounded arithmetic of 128 to 768 bits is tried first, beginning with the precision that decided the last direction. It
    /// proves its answer or gives none. It gives none for a multiple root, for a root in the middle between two doubles, and for
    /// a line in the curve or surface; then exact arithmetic decides.
    ///
    /// Cost, for a polynomial of degree d: one product for every coefficient of f, then d² additions for the roots of one
    /// polynomial.
    #[must_use]
    pub fn solve(&self, direction: &impl UnitVector<V>) -> Ray<V> {
        let (vector, w) = direction.over_common_denominator();
        let expansion = self.expansion.get_or_init(|| self.polynomial.expanded());
        let bounded = self.ladder.solve(
            expansion,
            &RationalLine {
                vector: &vector,
                w: &w,
                center: self.center.as_ref(),
            },
        );
        bounded.map_or_else(|_| self.solve_exactly(direction), Ray::Points)
    }

    /// The origin of the coordinates of points, in those of the polynomial.
    pub(crate) fn center(&self) -> [Rational; V] {
        self.center
            .clone()
            .unwrap_or_else(|| std::array::from_fn(|_| Rational::zero()))
    }

    /// The number of directions that each precision has decided so far.
    #[must_use]
    pub fn stage_counts(&self) -> StageCounts {
        StageCounts {
            bounded: self.ladder.counts(),
            exact: self.exact.load(Relaxed),
        }
    }

    /// Finds the points in one direction by exact arithmetic alone.
    ///
    /// Cost: the evaluation of every homogeneous part (its number of coefficients times its degree times the bits of the
    /// direction), then the roots of one polynomial.
    #[must_use]
    pub fn solve_exactly(&self, direction: &impl UnitVector<V>) -> Ray<V> {
        self.exact.fetch_add(1, Relaxed);
        let Some((gap, in_power)) = self.restricted(direction) else {
            return Ray::Line;
        };
        let signed = |f: &IntegerPolynomial, sign: i32| -> Vec<(i32, RealRoot)> {
            positive_or_all(f, gap)
                .into_iter()
                .map(|root| (sign, root))
                .collect()
        };
        let mut roots = signed(&in_power, 1);
        if gap > 1 && gap.is_multiple_of(2) {
            roots.extend(signed(&in_power, -1));
        } else if gap > 1 {
            roots.extend(signed(&reflected(&in_power), -1));
        }
        let unit = direction.components();
        let samples = roots
            .into_iter()
            .map(|(sign, mut root)| {
                let sign = Rational::from(sign);
                let scales = unit.each_ref().map(|u| &sign * u);
                let zero = Rational::zero();
                let relative = Sample {
                    branch: 0,
                    r: root.nearest_f64(gap, &sign, &zero),
                    position: scales
                        .each_ref()
                        .map(|scale| root.nearest_f64(gap, scale, &zero)),
                    multiplicity: root.multiplicity(),
                };
                let position = self.center.as_ref().map(|center| {
                    std::array::from_fn(|i| root.nearest_f64(gap, &scales[i], &center[i]))
                });
                Found { relative, position }
            })
            .collect();
        Ray::Points(in_order(samples))
    }

    /// The distances r of [`Self::solve`] as exact numbers, the largest first; `None` if the whole line belongs
    /// to the curve or surface.
    ///
    /// ```
    /// use stellate::exact::Rational;
    /// use stellate::poly::PlanePolynomial;
    /// use stellate::sample::{Direction, RaySolver};
    ///
    /// // x² + y² = 2
    /// let f = PlanePolynomial::from_terms([((2, 0), 1.into()), ((0, 2), 1.into()), ((0, 0), (-2).into())]);
    /// let found = RaySolver::new(&f).exact_distances(&Direction::from_degrees(&Rational::from(30)));
    /// let digits: Vec<_> = found.unwrap().iter().map(|r| r.to_decimal(30)).collect();
    /// assert_eq!(digits, ["1.414213562373095048801688724210", "-1.414213562373095048801688724210"]);
    /// ```
    ///
    /// Cost: as for [`Self::solve_exactly`].
    #[must_use]
    pub fn exact_distances(&self, direction: &impl UnitVector<V>) -> Option<Vec<RealRoot>> {
        let (vector, w) = direction.over_common_denominator();
        let coefficients = along(self.polynomial, &vector, &w);
        let lowest = coefficients.last()?.0;
        let mut roots = real_roots(&divided(coefficients, lowest, 1));
        roots.reverse();
        Some(roots)
    }

    /// (k, g) with f(ru, rv) = c r^j g(r^k) and g(0) ≠ 0; `None` if f vanishes identically along the line.
    fn restricted(&self, direction: &impl UnitVector<V>) -> Option<(u32, IntegerPolynomial)> {
        let (vector, w) = direction.over_common_denominator();
        let coefficients = along(self.polynomial, &vector, &w);
        let lowest = coefficients.last()?.0;
        let gap = coefficients
            .iter()
            .fold(0, |g: usize, (d, _)| g.gcd(d - lowest))
            .max(1);
        let in_power = divided(coefficients, lowest, gap);
        let gap = u32::try_from(gap).invariant("degrees are far below 2^32");
        Some((gap, in_power))
    }
}

/// The polynomial g for which r^lowest g(r^gap) has these coefficients, descending.
fn divided(coefficients: Vec<(usize, Integer)>, lowest: usize, gap: usize) -> IntegerPolynomial {
    let highest = coefficients.first().map_or(lowest, |(d, _)| *d);
    let mut dense = vec![Integer::default(); (highest - lowest) / gap + 1];
    for (d, c) in coefficients {
        dense[(d - lowest) / gap] = c;
    }
    IntegerPolynomial::from_coefficients_asc(dense)
}

/// The non-zero coefficients (d, c_d), descending in d, of f(λ U/W, λ V/W) = Σ c_d λ^d, all multiplied by W to the degree of f.
/// There are none if f vanishes identically on this line. The vector need not be a unit vector.
pub(crate) fn along<P: PartsByDegree<V>, const V: usize>(
    polynomial: &P,
    vector: &[Integer; V],
    w: &Integer,
) -> Vec<(usize, Integer)> {
    // f_d(U/W, V/W) W^top = f_d(U, V) W^(top − d)
    let mut coefficients: Vec<(usize, Integer)> = Vec::new();
    let mut w_power = Integer::ONE;
    // The polynomial 0 has no values.
    let mut above = polynomial.top_degree().unwrap_or(0);
    for (degree, value) in polynomial.values_at(vector) {
        for _ in degree..above {
            w_power *= w;
        }
        above = degree;
        if value != 0 {
            coefficients.push((above, value * &w_power));
        }
    }
    coefficients
}

/// The real roots of g, only the positive ones if k > 1; guesses have narrowed their enclosures.
fn positive_or_all(g: &IntegerPolynomial, k: u32) -> Vec<RealRoot> {
    let mut roots = real_roots(g);
    if k > 1 {
        roots.retain(|root| root.signum() > 0);
    }
    if !roots.is_empty() {
        for guess in real_root_guesses(g) {
            for root in &mut roots {
                root.try_guess(guess, GUESS_BITS);
            }
        }
    }
    roots
}

/// The polynomial g(−x).
fn reflected(g: &IntegerPolynomial) -> IntegerPolynomial {
    let flipped = g.coefficients_asc().iter().enumerate();
    IntegerPolynomial::from_coefficients_asc(
        flipped
            .map(|(i, c)| if i.is_multiple_of(2) { c.clone() } else { -c })
            .collect(),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poly::{PlanePolynomial, SpacePolynomial};
    use crate::sample::{Direction, SpaceDirection};
    use proptest::prelude::*;

    fn curve(terms: &[(usize, usize, i64)]) -> PlanePolynomial {
        PlanePolynomial::from_terms(terms.iter().map(|&(i, j, c)| ((i, j), Rational::from(c))))
    }

    fn points(f: &PlanePolynomial, d: &Direction) -> Vec<Sample> {
        match RaySolver::new(f).solve(d) {
            Ray::Points(points) => points,
            Ray::Line => panic!("a line"),
        }
    }

    #[test]
    #[expect(clippy::float_cmp, reason = "these are exact")]
    fn gaps_lines_and_multiplicities() {
        // x⁴ + y⁴ = 16 has two points along x, from a polynomial in r⁴.
        let f = curve(&[(4, 0, 1), (0, 4, 1), (0, 0, -16)]);
        let east = Direction::from_radians(0.0);
        let found = points(&(&f * &f), &east);
        let shown: Vec<_> = found
            .iter()
            .map(|p| (p.r, p.position[0], p.multiplicity))
            .collect();
        assert_eq!(shown, [(2.0, 2.0, 2), (-2.0, -2.0, 2)]);
        // x³ + y³ = −8 has an odd gap and a negative root.
        let g = curve(&[(3, 0, 1), (0, 3, 1), (0, 0, 8)]);
        assert_eq!(points(&g, &east)[0].r, -2.0);
        // x y = 0 holds the whole axis.
        let cross = curve(&[(1, 1, 1)]);
        assert_eq!(RaySolver::new(&cross).solve(&east), Ray::Line);
        // x² + y² = 0 has only the origin.
        assert_eq!(points(&curve(&[(2, 0, 1), (0, 2, 1)]), &east), []);
    }

    proptest! {
        /// A product of circles about the origin and a line, built from known roots.
        #[test]
        fn products_of_circles_and_lines(radii in prop::collection::btree_set(1i64..50, 1..4), a in -9i64..9, theta in 0.0f64..6.3) {
            let mut f = curve(&[(0, 0, 1)]);
            for r in &radii {
                f = &f * &curve(&[(2, 0, 1), (0, 2, 1), (0, 0, -r * r)]);
            }
            // The line x + a y = 1000 is farther from the origin than every circle: its distance is above 110, the radii are below 50.
            f = &f * &curve(&[(1, 0, 1), (0, 1, a), (0, 0, -1000)]);
            let d = Direction::from_radians(theta);
            let slope = d.u() + Rational::from(a) * d.v();
            prop_assume!(!slope.is_zero());
            let mut expected: Vec<f64> = radii.iter().flat_map(|&r| [Rational::from(r).to_f64(), Rational::from(-r).to_f64()]).collect();
            expected.push((Rational::from(1000) / slope).to_f64());
            expected.sort_by(|a, b| b.total_cmp(a));
            let found: Vec<f64> = points(&f, &d).iter().map(|p| p.r).collect();
            prop_assert_eq!(found, expected);
        }
    }

    /// Terms of a random polynomial, of degree up to 9.
    fn terms<const V: usize>() -> impl Strategy<Value = Vec<([u32; V], i64)>> {
        let exponents = prop::array::uniform::<_, V>(0u32..4);
        prop::collection::vec((exponents, -9i64..9), 1..12)
    }

    /// The solver gives the points that exact arithmetic alone gives, and it counts every direction once.
    fn check_stages<P: HomogeneousParts<V>, const V: usize>(
        f: &P,
        directions: &[impl UnitVector<V>],
    ) {
        let solver = RaySolver::new(f);
        for direction in directions {
            let ray = solver.solve(direction);
            assert_eq!(ray, solver.solve_exactly(direction));
            let exact = solver.exact_distances(direction).map(|distances| {
                let pairs = distances.iter().map(|r| (r.to_f64(), r.multiplicity()));
                pairs.collect::<Vec<_>>()
            });
            let expected = match ray {
                Ray::Points(points) => Some(points.iter().map(|p| (p.r, p.multiplicity)).collect()),
                Ray::Line => None,
            };
            assert_eq!(exact, expected);
        }
        let counts = solver.stage_counts();
        let solved: u64 = counts.bounded.iter().sum();
        assert_eq!(solved + counts.exact, 2 * directions.len() as u64);
    }

    proptest! {
        #[test]
        fn the_stages_agree_in_the_plane(terms in terms::<2>(), theta in -7.0f64..7.0, degrees in -720i64..720, gap in 1usize..4) {
            let terms = terms.into_iter().map(|([i, j], c)| ((i as usize * gap, j as usize * gap), Rational::from(c)));
            let f = PlanePolynomial::from_terms(terms);
            let directions = [Direction::from_radians(theta), Direction::from_degrees(&Rational::from(degrees))];
            check_stages(&f, &directions);
        }

        #[test]
        fn the_stages_agree_in_space(terms in terms::<3>(), theta in -7.0f64..7.0, phi in 0.0f64..3.2, degrees in -720i64..720) {
            let mut sum = crate::poly::SparsePolynomial::zero();
            for (exponents, c) in terms {
                sum.add_term(exponents, Rational::from(c));
            }
            let f = SpacePolynomial::from(&sum);
            let angle = |a| Direction::from_radians(a);
            let round = Direction::from_degrees(&Rational::from(degrees));
            let directions = [SpaceDirection::new(angle(theta), angle(phi)), SpaceDirection::new(round, angle(phi))];
            check_stages(&f, &directions);
        }
    }

    #[test]
    fn most_directions_need_no_exact_arithmetic() {
        let f = curve(&[(6, 0, 1), (0, 6, 1), (1, 3, 1), (1, 0, -1), (0, 0, -1)]);
        let solver = RaySolver::new(&f);
        for direction in &Direction::around(100) {
            assert_ne!(solver.solve(direction), Ray::Line);
        }
        let counts = solver.stage_counts();
        assert!(counts.bounded[0] > 90, "{counts:?}");
    }
}
