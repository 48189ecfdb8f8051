//! Isolated real points of a curve: points that two conjugate complex parameters reach and no real parameter does.

use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use super::conjugate::isolated_of_series;
use super::eliminant::{deflated_resultant, pairs_of_poles};
use super::enclosure::{Enclosure, Precision};
use super::isolated_point::{Isolated, IsolatedPoint, SHORT_BITS};
use super::pair::{Coordinate, DoublePoints, Pair, are_poles, coordinate, has_value};
use super::reached::{RealPartner, is_reached, is_reached_by_no_other, real_partners};
use super::symmetric::{Rows, bezoutian, in_sum_and_product};
use super::views::{CHANGES, changed_parameter, projections};
use crate::error::Result;
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{IntegerPolynomial, RationalFunction, polynomial_gcd};
use crate::roots::{RealRoot, real_roots};
use crate::shape::EllipticSeries;

/// The numbers of bits after the point in the first attempt and in the last one.
const FIRST_BITS: u64 = 384;
const MOST_BITS: u64 = 1 << 13;

/// Finds the isolated points of a curve in the plane or in space that its parametrization traces once. An elliptic Fourier series
/// that is general enough is searched in z = e^(it) ([`isolated_of_series`]), every other curve by resultants.
///
/// # Errors
/// Those of `limits`; [`Error::Limit`](crate::error::Error::Limit) if the degrees are too large for resultants.
pub(super) fn isolated<const N: usize>(
    coordinates: [&RationalFunction; N],
    limits: &Limits,
) -> Result<Isolated> {
    if coordinates.iter().any(|f| f.degree() == 1) {
        // Different parameters have different points, so there is no isolated point.
        return Ok(Isolated {
            points: Vec::new(),
            complete: true,
        });
    }
    if let [x, y] = coordinates[..]
        && let Some(series) = EllipticSeries::of_functions([x, y])
        && let Some(found) = isolated_of_series(&series, [x, y], limits)?
    {
        return Ok(found);
    }
    isolated_by_resultants(coordinates, limits)
}

/// The isolated points, by resultants. The answer is incomplete if the degrees are large.
///
/// Two conjugate parameters s, s̄ with the same point are a common zero of the quotients `(f(s) − f(σ))/(s − σ)` for the coordinates
/// f, written in S = s + σ and P = sσ, with S² < 4P. Their point is real. It is isolated if no real parameter reaches it, s = ∞
/// included. Every claim is exact:
/// - A curve in space is searched in a projection to a plane that traces the projected curve once. A pair of parameters with the
///   same projected point has the same point in space if the other quotients vanish, too.
/// - S is a real root of the resultant with respect to P, from which pairs of poles are divided out. If S is a simple zero of
///   it and not a zero of both leading coefficients, there is one P, a simple common zero. If S is rational, the values of P are
///   the real roots of a gcd.
/// - A determinant that is not 0 proves that no other parameter has the point. If it may be 0, real parameters are searched
///   exactly: by a gcd if the point is rational; else all real t are found whose point two conjugate parameters have as well, and
///   enclosures tell which of the finitely many pairs each of them belongs to.
///
/// # Errors
/// Those of `limits`.
pub(super) fn isolated_by_resultants<const N: usize>(
    coordinates: [&RationalFunction; N],
    limits: &Limits,
) -> Result<Isolated> {
    let mut best = Isolated {
        points: Vec::new(),
        complete: false,
    };
    for [u, v] in projections(&coordinates) {
        for change in CHANGES {
            let changed = coordinates.map(|f| changed_parameter(f, change));
            let projected = [&u, &v].map(|f| changed_parameter(f, change));
            let found = search(changed.each_ref(), projected.each_ref(), limits)?;
            if found.complete {
                return Ok(found);
            }
            if found.points.len() > best.points.len() {
                best = found;
            }
        }
    }
    Ok(best)
}

/// The isolated points, searched with this parameter in this projection.
fn search<const N: usize>(
    coordinates: [&RationalFunction; N],
    projected: [&RationalFunction; 2],
    limits: &Limits,
) -> Result<Isolated> {
    let equation = |f: &RationalFunction| in_sum_and_product(&bezoutian(f));
    let points = DoublePoints {
        coordinates: projected,
        equations: projected.map(equation),
    };
    let [a, b] = &points.equations;
    let poles = pairs_of_poles(projected.map(RationalFunction::denominator), limits)?;
    let eliminated = deflated_resultant([a, b], &poles, limits)?;
    // At a common zero of both leading coefficients, a zero of the resultant may have no P.
    let both_leads = polynomial_gcd(&a.lead(), &b.lead());
    let lost = coordinates.into_iter().filter(|f| !projected.contains(f));
    let mut search = IsolatedSearch {
        coordinates,
        lost: lost.map(equation).collect(),
        points,
        limits,
        linear: None,
        pairs: Vec::new(),
        // If the resultant is 0, the curve is not traced once.
        complete: eliminated != IntegerPolynomial::ZERO,
    };
    for sum in real_roots(&eliminated) {
        limits.check()?;
        let is_single = !sum.is_root_of(&both_leads) && search.is_single(&sum)?;
        let rational = match short_fraction(&sum) {
            None if !is_single => sum.as_rational(),
            found => found,
        };
        if let Some(sum) = rational {
            let [a, b] = &search.points.equations;
            let common = polynomial_gcd(&a.at(&sum), &b.at(&sum));
            let quarter = &sum * &sum / Rational::from(4);
            for product in real_roots(&common) {
                // The parameters are conjugate if (s + σ)² < 4sσ.
                if product.cmp_rational(&quarter).is_gt() {
                    let sum = sum.clone();
                    search.add(Pair::RationalSum { sum, product })?;
                }
            }
        } else if is_single {
            search.add_if_conjugate(sum)?;
        } else {
            search.complete = false;
        }
    }
    search.isolated()
}

/// The root, if it is a short fraction.
fn short_fraction(root: &RealRoot) -> Option<Rational> {
    let mut root = root.clone();
    root.refine_to_width(-2 * SHORT_BITS.cast_signed());
    let (low, high) = root.enclosure();
    let candidate = Rational::simplest_between(&low.to_rational(), &high.to_rational());
    (candidate.bits() <= SHORT_BITS && root.cmp_rational(&candidate).is_eq()).then_some(candidate)
}

/// A pair of conjugate parameters with its point.
struct Found<const N: usize> {
    pair: Pair,
    /// The precision of the enclosures.
    precision: Precision,
    /// Enclosures of the sum and the product of the two parameters.
    enclosed: [Enclosure; 2],
    /// Enclosures of the coordinates of the point.
    point: [Enclosure; N],
    /// The exact point, if it was found to be rational.
    exact: Option<[Rational; N]>,
}

struct IsolatedSearch<'a, const N: usize> {
    coordinates: [&'a RationalFunction; N],
    /// The pairs of parameters with the same projected point.
    points: DoublePoints<'a>,
    /// The equations in S and P of the coordinates that the projection loses. They hold if the point in space is the same, too.
    lost: Vec<Rows>,
    limits: &'a Limits,
    /// The first subresultant, computed when it is first needed.
    linear: Option<[IntegerPolynomial; 2]>,
    /// The pairs that were found so far.
    pairs: Vec<Found<N>>,
    /// Whether every pair was found and every decision about the pairs was made.
    complete: bool,
}

impl<const N: usize> IsolatedSearch<'_, N> {
    /// The first subresultant.
    fn linear(&mut self) -> Result<&[IntegerPolynomial; 2]> {
        let linear = match self.linear.take() {
            Some(linear) => linear,
            None => self.points.linear(self.limits)?,
        };
        Ok(self.linear.insert(linear))
    }

    /// The first subresultant, if an exact test at the pair needs it.
    fn linear_for(&mut self, pair: &Pair) -> Result<Option<&[IntegerPolynomial; 2]>> {
        match pair {
            Pair::RationalSum { .. } => Ok(None),
            Pair::RealSum { .. } => self.linear().map(Some),
        }
    }

    /// Whether exactly one P, a simple common zero, belongs to this sum.
    ///
    /// If the sum is a simple zero of the resultant, the curves a = 0 and b = 0 meet over it once. So they do not meet in a
    /// point where both are singular, or both tangent to the line S = const.
    fn is_single(&mut self, sum: &RealRoot) -> Result<bool> {
        let degrees = self.points.equations.each_ref().map(Rows::degree);
        if degrees.contains(&0) {
            // One of the two does not depend on P; the other one alone determines the values of P.
            return Ok(degrees.contains(&1));
        }
        if sum.multiplicity() == 1 {
            return Ok(true);
        }
        let [_, lead] = self.linear()?;
        Ok(*lead != IntegerPolynomial::ZERO && !sum.is_root_of(lead))
    }

    /// Adds the pair with this sum if its parameters are conjugate.
    fn add_if_conjugate(&mut self, sum: RealRoot) -> Result<()> {
        let pair = Pair::RealSum { sum };
        let mut precision = Precision { bits: FIRST_BITS };
        let mut is_exact = false;
        while precision.bits <= MOST_BITS {
            self.limits.check()?;
            if let Some([sum, product]) = pair.enclosed(&self.points, precision) {
                let four = precision.integer(&4.into());
                let square = precision.times(&sum, &sum);
                let discriminant = square.minus(&precision.times(&four, &product));
                match discriminant.sign() {
                    Some(-1) => return self.add(pair),
                    Some(_) => return Ok(()),
                    None if is_exact => {}
                    None => {
                        is_exact = true;
                        // S² − 4P
                        let square = [0, 0, 1].map(malachite::Integer::from).to_vec();
                        let discriminant = Rows::new(vec![
                            IntegerPolynomial::from_coefficients_asc(square),
                            IntegerPolynomial::from_coefficients_asc(vec![(-4).into()]),
                        ]);
                        if pair.is_zero_of(&discriminant, self.linear_for(&pair)?) {
                            return Ok(());
                        }
                    }
                }
            }
            precision.bits *= 2;
        }
        self.complete = false;
        Ok(())
    }

    /// Adds a pair of conjugate parameters, unless they are poles or have different points in space.
    fn add(&mut self, pair: Pair) -> Result<()> {
        if !self.is_same_point(&pair)? {
            return Ok(());
        }
        let mut precision = Precision { bits: FIRST_BITS };
        while precision.bits <= MOST_BITS {
            self.limits.check()?;
            if let Some(enclosed) = pair.enclosed(&self.points, precision) {
                let coordinates = self.coordinates;
                let mut values = coordinates.map(|f| coordinate(f, &enclosed, precision));
                if precision.bits > FIRST_BITS {
                    let linear = self.linear_for(&pair)?;
                    for (value, f) in values.iter_mut().zip(coordinates) {
                        if matches!(value, Coordinate::Undecided) && are_poles(f, &pair, linear) {
                            *value = Coordinate::Pole;
                        }
                    }
                }
                if values.iter().any(|v| matches!(v, Coordinate::Pole)) {
                    return Ok(());
                }
                if let Some(point) = all_values(values) {
                    let exact = self.rational_point(&pair, &point, precision)?;
                    self.pairs.push(Found {
                        pair,
                        precision,
                        enclosed,
                        point,
                        exact,
                    });
                    return Ok(());
                }
            }
            precision.bits *= 2;
        }
        self.complete = false;
        Ok(())
    }

    /// Whether two conjugate parameters with the same projected point have the same point in space, exactly.
    fn is_same_point(&mut self, pair: &Pair) -> Result<bool> {
        if self.lost.is_empty() {
            return Ok(true);
        }
        self.linear_for(pair)?;
        let linear = self.linear.as_ref();
        Ok(self.lost.iter().all(|f| pair.is_zero_of(f, linear)))
    }

    /// The exact point, if all coordinates are short fractions and prove to be right.
    fn rational_point(
        &mut self,
        pair: &Pair,
        point: &[Enclosure; N],
        precision: Precision,
    ) -> Result<Option<[Rational; N]>> {
        let candidates = point.each_ref().map(|value| {
            let [low, high] = precision.bounds(value);
            Rational::simplest_between(&low, &high)
        });
        if candidates.iter().any(|q| q.bits() > SHORT_BITS) {
            return Ok(None);
        }
        let coordinates = self.coordinates;
        let linear = self.linear_for(pair)?;
        let mut all = coordinates.iter().zip(&candidates);
        let exact = all.all(|(f, value)| has_value(f, pair, value, linear));
        Ok(exact.then_some(candidates))
    }

    /// The points of the pairs that no real parameter reaches.
    fn isolated(mut self) -> Result<Isolated> {
        let coordinates = self.coordinates;
        let mut points: Vec<IsolatedPoint> = Vec::new();
        let mut open = Vec::new();
        for (k, found) in self.pairs.iter().enumerate() {
            let is_isolated = match &found.exact {
                Some(point) => !is_reached(coordinates, point),
                None if is_reached_by_no_other(
                    coordinates,
                    &found.enclosed,
                    &found.point,
                    found.precision,
                ) =>
                {
                    true
                }
                None => {
                    open.push(k);
                    continue;
                }
            };
            if is_isolated {
                points.push(found.rounded());
            }
        }
        if !open.is_empty() {
            let partners = real_partners(&self.points, self.limits)?;
            for k in open {
                match self.is_reached_by_one_of(&partners, k)? {
                    Some(true) => {}
                    Some(false) => points.push(self.pairs[k].rounded()),
                    None => self.complete = false,
                }
            }
        }
        let mut different: Vec<IsolatedPoint> = Vec::new();
        for point in points {
            if !different.contains(&point) {
                different.push(point);
            }
        }
        Ok(Isolated {
            points: different,
            complete: self.complete,
        })
    }

    /// Whether the k-th pair shares its point with one of these real parameters or with t = ∞; `None` if it is not decided.
    ///
    /// If a real parameter is proved to share its point with two conjugate parameters, these are one of the pairs, provided
    /// that the search is complete. So if its point is away from the points of all other pairs, it shares the point of this
    /// one. In a projection that does not suffice.
    fn is_reached_by_one_of(&mut self, partners: &[RealPartner], k: usize) -> Result<Option<bool>> {
        let coordinates = self.coordinates;
        let at_infinity = coordinates.iter().map(|f| f.evaluate_at_infinity());
        if let Some(at_infinity) = at_infinity.collect::<Option<Vec<Rational>>>() {
            let found = &self.pairs[k];
            let values = found.point.iter().zip(&at_infinity);
            let mut values = values.map(|(value, q)| found.precision.excludes(value, q));
            if !values.any(|excluded| excluded) {
                let pair = found.pair.clone();
                let linear = self.linear_for(&pair)?;
                let mut values = coordinates.iter().zip(&at_infinity);
                if values.all(|(f, value)| has_value(f, &pair, value, linear)) {
                    return Ok(Some(true));
                }
            }
        }
        let mut bits = FIRST_BITS;
        while bits <= MOST_BITS {
            self.limits.check()?;
            let precision = Precision { bits };
            bits *= 2;
            let pairs: Option<Vec<[Enclosure; N]>> = self
                .pairs
                .iter()
                .map(|found| self.point_of(&found.pair, precision))
                .collect();
            let (Some(pairs), Some(points)) = (
                pairs,
                partners
                    .iter()
                    .map(|partner| partner.point(coordinates, precision))
                    .collect::<Option<Vec<_>>>(),
            ) else {
                continue;
            };
            let meets =
                |a: &[Enclosure; N], b: &[Enclosure; N]| a.iter().zip(b).all(|(a, b)| a.meets(b));
            let mut near = partners.iter().zip(&points);
            if !near.clone().any(|(_, point)| meets(point, &pairs[k])) {
                return Ok(Some(false));
            }
            let alone = |point: &[Enclosure; N]| {
                pairs.iter().filter(|pair| meets(pair, point)).count() == 1
            };
            let is_reached = near.any(|(partner, point)| {
                partner.proved
                    && self.lost.is_empty()
                    && self.complete
                    && meets(point, &pairs[k])
                    && alone(point)
            });
            if is_reached {
                return Ok(Some(true));
            }
        }
        Ok(None)
    }

    /// Enclosures of the coordinates of the point of a pair; `None` if the precision is too low.
    fn point_of(&self, pair: &Pair, precision: Precision) -> Option<[Enclosure; N]> {
        let enclosed = pair.enclosed(&self.points, precision)?;
        all_values(
            self.coordinates
                .map(|f| coordinate(f, &enclosed, precision)),
        )
    }
}

/// The values of all coordinates; `None` if one of them is infinite or not decided.
fn all_values<const N: usize>(coordinates: [Coordinate; N]) -> Option<[Enclosure; N]> {
    let values = coordinates.into_iter().map(|coordinate| match coordinate {
        Coordinate::Value(value) => Some(value),
        _ => None,
    });
    values.collect::<Option<Vec<_>>>()?.try_into().ok()
}

impl<const N: usize> Found<N> {
    fn rounded(&self) -> IsolatedPoint {
        match &self.exact {
            Some(point) => IsolatedPoint::Exact(point.to_vec()),
            None => {
                let middles = self.point.iter().map(|value| {
                    let [low, high] = self.precision.bounds(value);
                    ((low + high) / Rational::from(2)).to_f64()
                });
                IsolatedPoint::Near(middles.collect())
            }
        }
    }
}
