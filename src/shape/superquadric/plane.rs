//! [`Superquadric`]: the plane superquadrics of Example 6, Eq. (20).

use std::cmp::Ordering;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Parity;

use super::roots::{Exponent, FIRST_BITS, exact_power, exact_root, scaled_root};
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::poly::PlanePolynomial;
use crate::shape::Radial;

/// The closed curve `|x/a1|^(2/ε) + |y/a2|^(2/ε) = c` about the origin, with exact a1, a2, ε, c > 0.
///
/// By Lemma 2, `r(θ) = c^(ε/2) / [|cos θ/a1|^(2/ε) + |sin θ/a2|^(2/ε)]^(ε/2)`, positive for every θ.
///
/// DIFFERENCE (erratum Eq. (20)): Eq. (20) as printed has `[… − a]^(ε2/ε1) = 1` and no absolute values. That does not give the
/// printed r(θ). The absolute values may be omitted only if 2/ε is an even integer.
///
/// ```
/// use stellate::exact::Rational;
/// use stellate::shape::Superquadric;
///
/// let one = Rational::one;
/// let astroid = Superquadric::new([one(), one()], Rational::from(3), one()).unwrap();
/// assert_eq!(astroid.exponent().to_string(), "2/3");
/// assert!(!astroid.is_convex());
/// assert!(astroid.polynomial().is_none());
/// assert!(Superquadric::new([one(), one()], Rational::zero(), one()).is_none());
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Superquadric {
    semi_axes: [Rational; 2],
    epsilon: Rational,
    level: Rational,
}

impl Superquadric {
    /// The superquadric with a1 and a2, ε and c; `None` unless all of them are positive.
    #[must_use]
    pub fn new(semi_axes: [Rational; 2], epsilon: Rational, level: Rational) -> Option<Self> {
        let shape = Self {
            semi_axes,
            epsilon,
            level,
        };
        let [a1, a2] = &shape.semi_axes;
        let positive = [a1, a2, &shape.epsilon, &shape.level].map(|q| q.signum() > 0);
        (positive == [true; 4]).then_some(shape)
    }

    /// The semi-axes a1 and a2.
    #[must_use]
    pub fn semi_axes(&self) -> &[Rational; 2] {
        &self.semi_axes
    }

    /// The number ε.
    #[must_use]
    pub fn epsilon(&self) -> &Rational {
        &self.epsilon
    }

    /// The level c, which is the paper's a.
    #[must_use]
    pub fn level(&self) -> &Rational {
        &self.level
    }

    /// The exponent 2/ε.
    #[must_use]
    pub fn exponent(&self) -> Rational {
        Rational::from(2) / &self.epsilon
    }

    /// The number c^(ε/2) by which the semi-axes are multiplied for c ≠ 1, if it is rational.
    pub(crate) fn exact_scale(&self) -> Option<Rational> {
        let half = &self.epsilon / &Rational::from(2);
        exact_power(&self.level, Exponent::from(&half))
    }

    /// Whether the region inside is convex. It is a stretched disk of the norm with exponent 2/ε, and this is a norm exactly
    /// for 2/ε ≥ 1 (Minkowski).
    #[must_use]
    pub fn is_convex(&self) -> bool {
        self.epsilon <= Rational::from(2)
    }

    /// The exponent 2/ε if it is an even integer, so that the absolute values can be omitted.
    #[must_use]
    pub fn even_exponent(&self) -> Option<usize> {
        let exponent = self.exponent();
        let even = exponent.is_integer() && exponent.numerator().even();
        even.then(|| usize::try_from(&exponent.numerator()).ok())?
    }

    /// The primitive polynomial that is proportional to `(x/a1)^n + (y/a2)^n − c`, if n = 2/ε is an even integer.
    #[must_use]
    pub fn polynomial(&self) -> Option<PlanePolynomial> {
        let n = self.even_exponent()?;
        let power = i64::try_from(n).ok()?;
        let [a1, a2] = &self.semi_axes;
        let terms = [
            ((n, 0), a1.pow(-power)?),
            ((0, n), a2.pow(-power)?),
            ((0, 0), -self.level.clone()),
        ];
        Some(PlanePolynomial::from_terms(terms).primitive())
    }
}

impl Radial<2> for Superquadric {
    fn approximate_along(&self, [u, v]: [f64; 2]) -> f64 {
        let [a1, a2] = self.semi_axes.each_ref().map(Rational::to_f64);
        let exponent = self.exponent().to_f64();
        let (u, v) = ((u / a1).abs(), (v / a2).abs());
        // The larger number is factored out, so that no power overflows.
        let largest = u.max(v);
        let sum = (u / largest).powf(exponent) + (v / largest).powf(exponent);
        (self.level.to_f64() / sum).powf(1.0 / exponent) / largest
    }

    /// The exact order of `|x/a1|^(2/ε) + |y/a2|^(2/ε)` and c.
    ///
    /// With 2/ε = p/q in lowest terms the left side is `α^(1/q) + β^(1/q)` with rational `α = |x/a1|^p`, `β = |y/a2|^p`.
    /// Integer q-th roots at growing precision decide which side is larger. The sides can only be equal if both roots are
    /// rational, because real radicals of different classes are linearly independent over Q (Besicovitch 1940); exact roots
    /// decide this case. So every comparison ends, unless it needs roots of numbers of more than 2²² bits.
    fn compare(&self, [x, y]: &[Rational; 2]) -> Result<Ordering> {
        let exponent = Exponent::from(&self.exponent());
        let why = || {
            format!(
                "the exponent 2/e = {} or the numbers are too long",
                self.exponent()
            )
        };
        let [a1, a2] = &self.semi_axes;
        let bases = [(x / a1).abs(), (y / a2).abs()];
        exponent.check_size(bases[0].bits().max(bases[1].bits()), &why)?;
        let power = i64::try_from(exponent.p).invariant("a power is within the limit of bits");
        let radicands = bases.map(|base| base.pow(power).invariant("a power is not negative"));
        let roots = radicands.each_ref().map(|r| exact_root(r, exponent.q));
        if let [Some(first), Some(second)] = roots {
            return Ok((first + second).cmp(&self.level));
        }
        let mut bits = FIRST_BITS;
        loop {
            exponent.check_size(bits, &why)?;
            let unit = Rational::whole(Integer::from(1) << bits);
            let roots = radicands
                .each_ref()
                .map(|r| scaled_root(r, exponent.q, bits));
            // Each root is less than one unit above its floor.
            let low = Rational::whole(Integer::from(&roots[0] + &roots[1]));
            let scaled = &self.level * &unit;
            if low >= scaled {
                // The roots are not both rational here, so one of them is larger than its floor.
                return Ok(Ordering::Greater);
            }
            if low + Rational::from(2) <= scaled {
                return Ok(Ordering::Less);
            }
            bits *= 2;
        }
    }
}

/// Values for drawing: doubles without certificate.
impl Superquadric {
    /// The radius r(θ) in doubles without a bound of the error.
    #[must_use]
    pub fn approximate(&self, theta: f64) -> f64 {
        let (s, c) = theta.sin_cos();
        self.approximate_along([c, s])
    }

    /// Points (x, y) of the curve for drawing, closed: `4·count` directions with equal steps in θ, and as many with equal steps
    /// in the parameter of `(a1 cos^ε, a2 sin^ε)`. The points of one kind are dense where those of the other kind are sparse.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "a count of points is small")]
    pub fn polyline(&self, count: usize) -> Vec<[f64; 2]> {
        let [a1, a2] = self.semi_axes.each_ref().map(Rational::to_f64);
        let epsilon = self.epsilon.to_f64();
        let steps = (0..count.max(2)).map(|k| k as f64 / count.max(2) as f64);
        let angles = steps.flat_map(|step| {
            let even = step * std::f64::consts::FRAC_PI_2;
            let (s, c) = even.sin_cos();
            [even, (a2 * s.powf(epsilon)).atan2(a1 * c.powf(epsilon))]
        });
        let mut quadrant: Vec<f64> = angles.collect();
        quadrant.sort_unstable_by(f64::total_cmp);
        let arc = |theta: &f64| {
            let r = self.approximate(*theta);
            [r * theta.cos(), r * theta.sin()]
        };
        let arc: Vec<[f64; 2]> = quadrant.iter().map(arc).collect();
        let top = [0.0, self.approximate_along([0.0, 1.0])];
        let mut points = arc.clone();
        points.push(top);
        points.extend(arc.iter().rev().map(|[x, y]| [-x, *y]));
        points.extend(arc.iter().map(|[x, y]| [-x, -y]));
        points.push([0.0, -top[1]]);
        points.extend(arc.iter().rev().map(|[x, y]| [*x, -y]));
        points
    }
}
