//! Real roots as exact objects: a polynomial, and the root itself or an interval that holds it alone.

use std::cmp::Ordering;
use std::convert::Infallible;
use std::sync::Arc;

use malachite::Integer;
use malachite::base::num::logic::traits::SignificantBits;

use crate::error::Invariant;
use crate::exact::{Dyadic, Rational, nearest_double};
use crate::poly::{IntegerPolynomial, leading_value, polynomial_gcd, sign_at, sign_at_rational};

/// One step of refinement adds at most this many bits.
const MAX_STEP: u32 = 1 << 16;

/// A real root of a polynomial with integer coefficients. The root is exact; its enclosure can be made as narrow as wanted.
#[derive(Clone, Debug)]
pub struct RealRoot {
    polynomial: Arc<IntegerPolynomial>,
    place: Location,
    multiplicity: usize,
}

#[derive(Clone, Debug)]
enum Location {
    Exact(Dyadic),
    /// The only root of the squarefree polynomial in this open interval. The polynomial has the sign `sign_low` at `low` and the
    /// opposite sign at `high`.
    Between {
        low: Dyadic,
        high: Dyadic,
        sign_low: i8,
    },
}

impl RealRoot {
    /// A root that is known exactly.
    pub(crate) fn exact(
        polynomial: &Arc<IntegerPolynomial>,
        point: Dyadic,
        multiplicity: usize,
    ) -> Self {
        Self {
            polynomial: Arc::clone(polynomial),
            place: Location::Exact(point),
            multiplicity,
        }
    }

    /// The only root between two numbers. The caller must ensure that the polynomial has the sign `sign_low` at the lower number,
    /// the opposite sign at the upper one, and one root between them.
    pub(crate) fn between(
        polynomial: &Arc<IntegerPolynomial>,
        (low, high): (Dyadic, Dyadic),
        sign_low: i8,
        multiplicity: usize,
    ) -> Self {
        Self {
            polynomial: Arc::clone(polynomial),
            place: Location::Between {
                low,
                high,
                sign_low,
            },
            multiplicity,
        }
    }

    /// The multiplicity of the root.
    #[must_use]
    pub fn multiplicity(&self) -> usize {
        self.multiplicity
    }

    /// Certified bounds `low ≤ root ≤ high`. They are equal only if the root is already known exactly; [`Self::as_rational`] finds
    /// every rational root. [`Self::refine_to_width`] makes the bounds narrower.
    #[must_use]
    pub fn bounds(&self) -> (Rational, Rational) {
        let (low, high) = self.enclosure();
        (low.to_rational(), high.to_rational())
    }

    /// References to the [`Self::bounds`].
    pub(crate) fn enclosure(&self) -> (&Dyadic, &Dyadic) {
        match &self.place {
            Location::Exact(point) => (point, point),
            Location::Between { low, high, .. } => (low, high),
        }
    }

    /// Exact comparison with a rational number.
    #[must_use]
    pub fn cmp_rational(&self, q: &Rational) -> Ordering {
        match &self.place {
            Location::Exact(root) => root.to_rational().cmp(q),
            Location::Between { low, .. } if *q <= low.to_rational() => Ordering::Greater,
            Location::Between { high, .. } if *q >= high.to_rational() => Ordering::Less,
            Location::Between { sign_low, .. } => {
                side(*sign_low, sign_at_rational(&self.polynomial, q))
            }
        }
    }

    /// Exact comparison with a dyadic number.
    pub(crate) fn cmp_dyadic(&self, point: &Dyadic) -> Ordering {
        match &self.place {
            Location::Exact(root) => root.cmp(point),
            Location::Between { low, .. } if point <= low => Ordering::Greater,
            Location::Between { high, .. } if point >= high => Ordering::Less,
            Location::Between { sign_low, .. } => side(*sign_low, sign_at(&self.polynomial, point)),
        }
    }

    /// The sign of the root.
    #[must_use]
    pub fn signum(&self) -> i8 {
        match self.cmp_dyadic(&Dyadic::zero()) {
            Ordering::Less => -1,
            Ordering::Equal => 0,
            Ordering::Greater => 1,
        }
    }

    /// Whether the root is also a root of g.
    #[doc(hidden)]
    #[must_use]
    pub fn is_root_of(&self, g: &IntegerPolynomial) -> bool {
        match &self.place {
            Location::Exact(point) => sign_at(g, point) == 0,
            Location::Between { low, high, .. } => {
                // The polynomial has one root in the interval, and it is simple. So the common factor has this root exactly if
                // its sign changes.
                let common = polynomial_gcd(&self.polynomial, g);
                common.coefficients_asc().len() > 1
                    && sign_at(&common, low) * sign_at(&common, high) < 0
            }
        }
    }

    /// Whether both roots are the same number. They are if this root is a root of the other's polynomial and lies in the other's
    /// enclosure.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        let (low, high) = other.enclosure();
        let is_inside = self.cmp_dyadic(low).is_ge() && self.cmp_dyadic(high).is_le();
        match &other.place {
            Location::Exact(point) => self.cmp_dyadic(point).is_eq(),
            Location::Between { .. } => is_inside && self.is_root_of(&other.polynomial),
        }
    }

    /// The root as a fraction, if it is rational.
    #[must_use]
    pub fn as_rational(&self) -> Option<Rational> {
        if let Location::Exact(point) = &self.place {
            return Some(point.to_rational());
        }
        // If the root is p/q in lowest terms, q divides the leading coefficient `lead`. Two fractions with denominators up to
        // |lead| are at least 1/lead² apart, so in a shorter interval the simplest fraction is the only candidate.
        let lead = self.polynomial.coefficients_asc().last()?;
        let mut here = self.clone();
        let bits = i64::try_from(2 * lead.significant_bits()).ok()? + 1;
        here.refine_to_width(-bits);
        let (low, high) = here.enclosure();
        let candidate = Rational::simplest_between(&low.to_rational(), &high.to_rational());
        (self.cmp_rational(&candidate) == Ordering::Equal).then_some(candidate)
    }

    /// The polynomial of which this is a root.
    pub(crate) fn polynomial(&self) -> &IntegerPolynomial {
        &self.polynomial
    }

    /// Compares two roots; the enclosures are bisected until they are disjoint. The caller must ensure that the roots are distinct.
    pub(crate) fn cmp_distinct(&mut self, other: &mut Self) -> Ordering {
        loop {
            let (a, b) = (self.enclosure(), other.enclosure());
            if a.1 <= b.0 {
                return Ordering::Less;
            }
            if b.1 <= a.0 {
                return Ordering::Greater;
            }
            self.bisect();
            other.bisect();
        }
    }

    /// Narrows the enclosure to a relative distance of 2^−`bits` about `guess`, if the root is proved to be there. Two exact
    /// signs prove it.
    pub(crate) fn try_guess(&mut self, guess: f64, bits: i64) {
        let Location::Between { low, high, .. } = &self.place else {
            return;
        };
        let Some(point) = Dyadic::from_f64(guess) else {
            return;
        };
        let Some(size) = point.log2() else {
            return;
        };
        let radius = Dyadic::new(Integer::from(1), size - bits);
        let (a, b) = (point.minus(&radius), point.plus(&radius));
        if a > *low && b < *high {
            self.shrink_to(&a);
            self.shrink_to(&b);
        }
    }

    /// Uses an exact comparison with `point` to shrink the enclosure.
    fn shrink_to(&mut self, point: &Dyadic) {
        let order = self.cmp_dyadic(point);
        if let Location::Between { low, high, .. } = &mut self.place {
            match order {
                Ordering::Equal => self.place = Location::Exact(point.clone()),
                Ordering::Greater if point > low => *low = point.clone(),
                Ordering::Less if point < high => *high = point.clone(),
                _ => {}
            }
        }
    }

    fn bisect(&mut self) {
        if let Location::Between { low, high, .. } = &self.place {
            let middle = low.midpoint(high);
            self.shrink_to(&middle);
        }
    }

    /// Shrinks the enclosure until it does not contain 0 and its width is at most 2^−`bits` times
    /// the size of the root.
    ///
    /// Quadratic interval refinement (Abbott): a secant step proposes a subinterval of 1/N of the
    /// width. If exact signs confirm that it holds the root, N is squared; if not, the interval is halved and the square root
    /// of N is taken.
    pub fn refine(&mut self, bits: i64) {
        let mut step = 2u32;
        loop {
            let Location::Between { low, high, .. } = &self.place else {
                return;
            };
            if low.signum() * high.signum() < 0 {
                self.shrink_to(&Dyadic::zero());
                continue;
            }
            let width = high.minus(low);
            let size = low.log2().into_iter().chain(high.log2()).min();
            let done = match (low.signum(), high.signum()) {
                (0, _) | (_, 0) => false,
                _ => width.log2().zip(size).is_some_and(|(w, s)| w < s - bits),
            };
            if done {
                return;
            }
            // Near 0 secants do not help, and halving would take one step for every leading zero bit of a tiny root.
            if low.signum() == 0 || high.signum() == 0 {
                self.approach_zero();
                continue;
            }
            if self.secant(step) {
                step = (step * 2).min(MAX_STEP);
            } else {
                step = (step / 2).max(1);
            }
        }
    }

    /// Shrinks the enclosure until it is at most `2^exponent` wide.
    pub fn refine_to_width(&mut self, exponent: i64) {
        let mut step = 2u32;
        while let Location::Between { low, high, .. } = &self.place {
            if high.minus(low).log2().is_none_or(|width| width < exponent) {
                return;
            }
            step = if self.secant(step) {
                (step * 2).min(MAX_STEP)
            } else {
                (step / 2).max(1)
            };
        }
    }

    /// Moves the end of the enclosure that is 0 away from 0, by cuts at 2^−4, 2^−8, 2^−16, … times the size of the other end. The
    /// caller must ensure that the root is not 0.
    fn approach_zero(&mut self) {
        let mut drop = 4;
        while let Location::Between { low, high, .. } = &self.place {
            let (outer, sign) = if low.signum() == 0 {
                (high, 1)
            } else {
                (low, -1)
            };
            let Some(size) = outer.log2() else { return };
            let cut = Dyadic::new(Integer::from(sign), size - drop);
            self.shrink_to(&cut);
            if let Location::Between { low, high, .. } = &self.place
                && low.signum() != 0
                && high.signum() != 0
            {
                return;
            }
            drop *= 2;
        }
    }

    /// One step of quadratic interval refinement with 2^`step` subintervals. Returns whether the root was in the proposed one.
    fn secant(&mut self, step: u32) -> bool {
        let Location::Between { low, high, .. } = &self.place else {
            return true;
        };
        let (low, high) = (low.clone(), high.clone());
        let bits = 64 + u64::from(step);
        let at_low = leading_value(&self.polynomial, &low, bits);
        let at_high = leading_value(&self.polynomial, &high, bits);
        let (numerator, denominator) = ratio_to_sum(&at_low, &at_high, bits);
        let width = high.minus(&low);
        let unit = width.times_power_of_two(-i64::from(step));
        // index = round(2^step |f(low)| / (|f(low)| + |f(high)|))
        let index = ((numerator << (step + 1)) + &denominator) / (denominator << 1u64);
        let guess = low.plus(&unit.times_integer(&index));
        let before = self.cmp_dyadic(&guess);
        self.shrink_to(&guess);
        let neighbour = match before {
            Ordering::Equal => return true,
            Ordering::Greater => guess.plus(&unit),
            Ordering::Less => guess.minus(&unit),
        };
        let inside = self.cmp_dyadic(&neighbour) != before;
        self.shrink_to(&neighbour);
        if !inside {
            self.bisect();
        }
        inside
    }

    /// The double nearest to the root (ties to even).
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        self.clone()
            .nearest_f64(1, &Rational::one(), &Rational::zero())
    }

    /// Certified decimals: the root rounded to `digits` places after the point.
    ///
    /// ```
    /// use stellate::roots::RealRoot;
    /// let roots = RealRoot::all_of(&[(-2).into(), 0.into(), 1.into()]); // x² − 2
    /// assert_eq!(roots[1].to_decimal(30), "1.414213562373095048801688724210");
    /// ```
    #[must_use]
    pub fn to_decimal(&self, digits: u32) -> String {
        if let Some(exact) = self.as_rational() {
            return exact.to_decimal(digits);
        }
        // An irrational root is not in the middle between two decimals, so both bounds are rounded alike in the end.
        let mut root = self.clone();
        let mut bits = i64::from(digits) * 4 + 16;
        loop {
            root.refine_to_width(-bits);
            let (low, high) = root.enclosure();
            let text = low.to_rational().to_decimal(digits);
            if text == high.to_rational().to_decimal(digits) {
                return text;
            }
            bits += 16;
        }
    }

    /// The double nearest to `from + scale · root^(1/k)`, where for k > 1 the root must be positive.
    ///
    /// A guess in doubles is corrected by exact comparisons with the midpoints between neighbouring doubles. A number that is
    /// too large for a double becomes ±∞.
    pub(crate) fn nearest_f64(&mut self, k: u32, scale: &Rational, from: &Rational) -> f64 {
        if scale.is_zero() {
            return from.to_f64();
        }
        if let Location::Exact(point) = &self.place {
            if k == 1 {
                return (from + &(point.to_rational() * scale)).to_f64();
            }
            if point.signum() == 0 {
                return from.to_f64();
            }
        }
        self.refine(56);
        let (low, high) = self.enclosure();
        let middle = low.midpoint(high).to_rational();
        let step = if k == 1 {
            (middle * scale).to_f64()
        } else {
            // (root · |scale|^k)^(1/k): the two factors alone may be too large for a double.
            let power = scale
                .abs()
                .pow(i64::from(k))
                .invariant("a power with a natural exponent exists");
            root_f64(&(middle * power), k) * f64::from(scale.signum())
        };
        let guess = match from.is_zero() {
            true => step,
            false => from.to_f64() + step,
        };
        self.walk_to_nearest(guess, k, scale, from)
    }

    fn walk_to_nearest(&self, guess: f64, k: u32, scale: &Rational, from: &Rational) -> f64 {
        // Compares the root with ((bound − from)/scale)^k; a negative scale reverses the order.
        let side = |bound: &Rational| {
            let q = (bound - from) / scale;
            // For k > 1 both sides must be positive to be compared by powers.
            let order = if k > 1 && q.signum() <= 0 {
                Ordering::Greater
            } else {
                self.cmp_rational(
                    &q.pow(i64::from(k))
                        .invariant("a power with a natural exponent exists"),
                )
            };
            Ok::<_, Infallible>(if scale.signum() < 0 {
                order.reverse()
            } else {
                order
            })
        };
        let Ok(double) = nearest_double(guess, side);
        double
    }
}

/// The order of the root and a point inside its interval, where the polynomial has the sign `sign` at the point.
fn side(sign_low: i8, sign: i8) -> Ordering {
    match sign {
        0 => Ordering::Equal,
        s if s == sign_low => Ordering::Greater,
        _ => Ordering::Less,
    }
}

/// (|a|, |a| + |b|), rounded to about `bits` bits and up to a common factor.
fn ratio_to_sum(a: &(Integer, i64), b: &(Integer, i64), bits: u64) -> (Integer, Integer) {
    let top = |v: &(Integer, i64)| v.0.significant_bits().cast_signed() + v.1;
    let unit = top(a).max(top(b)) - bits.cast_signed();
    let cut = |v: &(Integer, i64)| {
        let magnitude = Integer::from(v.0.unsigned_abs_ref().clone());
        let shift = v.1 - unit;
        if shift >= 0 {
            magnitude << shift.unsigned_abs()
        } else {
            magnitude >> shift.unsigned_abs()
        }
    };
    let (a, b) = (cut(a), cut(b));
    let sum = &a + b;
    (a, sum)
}

/// A guess of q^(1/k) in doubles, for q > 0 and without overflow.
#[expect(
    clippy::cast_precision_loss,
    reason = "a guess: exact comparisons decide"
)]
fn root_f64(q: &Rational, k: u32) -> f64 {
    let bits = |n: &Integer| n.significant_bits().cast_signed();
    let exponent = bits(&q.numerator()) - bits(&q.denominator());
    let whole = exponent.div_euclid(i64::from(k));
    let mantissa = (q * &Rational::from_dyadic(Integer::from(1), -whole * i64::from(k))).to_f64();
    let root = mantissa.powf(1.0 / f64::from(k));
    let value = root * (whole as f64).exp2();
    if value.is_finite() { value } else { f64::MAX }
}
