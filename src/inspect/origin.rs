//! The origin of the coordinates in which a zero set is inspected.
//!
//! Far from the origin doubles lose the digits of the distance from the origin, to each power of it that the polynomial has. So a
//! zero set that is far away, as outlines on maps are, is moved to the origin. The change of coordinates is exact.

use std::collections::BTreeMap;

use malachite::base::num::arithmetic::traits::DivRound;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::base::rounding_modes::RoundingMode;

use super::exact::power_of_two;
use super::linear::solved;
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{SparsePolynomial, total_degree, with_integers};

/// A zero set is moved if its middle is farther away than 2^6 times the distance from the middle to the nearest zero on the lines
/// along the axes, and than 2^6 times the tolerance.
const FAR: i64 = 6;
/// The middle is rounded down to 2^−4 of the larger one of these.
const ROUND: i64 = 4;

/// The middle of the zero set of f, rounded to few digits, if it is far from the origin compared with the distance of zeros from it
/// and with the tolerance. Any point would do; this one makes the coefficients of f small.
///
/// Let f_d be the sum of the terms of the highest degree. With coordinates c + X the terms of degree d − 1 become f_{d−1} +
/// c·∇f_d, and c makes their coefficients as small as it can (least squares). It moves with the zero set. Where f_d does not
/// determine c in a direction, the roots of f on the line in this direction have their mean at c.
///
/// # Errors
/// Those of `limits`.
pub(super) fn far_middle(
    f: &SparsePolynomial<3>,
    tolerance: &Rational,
    limits: &Limits,
) -> Result<Option<[Rational; 3]>> {
    let Some(middle) = middle(f, limits)? else {
        return Ok(None);
    };
    let exponents = middle.iter().filter_map(exponent_of);
    let farthest = exponents.max().invariant("the middle is not the origin");
    let least = exponent_of(tolerance).invariant("a tolerance is positive");
    if farthest < least + FAR {
        return Ok(None);
    }
    let size = size_about(f, &middle).map_or(least, |size| size.max(least));
    Ok((farthest >= size + FAR).then(|| {
        let unit = size - ROUND;
        middle.map(|c| Rational::from_dyadic((c * power_of_two(-unit)).floor_integer(), unit))
    }))
}

/// The exponent e with 2^(e−1) ≤ |x| < 2^(e+1), about; `None` for 0.
fn exponent_of(x: &Rational) -> Option<i64> {
    let bits = |n: u64| n.cast_signed();
    (!x.is_zero()).then(|| {
        bits(x.numerator().significant_bits()) - bits(x.denominator_ref().significant_bits())
    })
}

/// The middle, exactly; `None` if it is the origin.
fn middle(f: &SparsePolynomial<3>, limits: &Limits) -> Result<Option<[Rational; 3]>> {
    let Some(degree) = f.degree().filter(|&d| d > 0) else {
        return Ok(None);
    };
    let of_degree = |d: u64| {
        let terms = f.terms().filter(move |(e, _)| total_degree(e) == d);
        terms.map(|(e, c)| (*e, c.clone()))
    };
    let top = SparsePolynomial::from_terms(of_degree(degree));
    let slopes: [BTreeMap<[u32; 3], Rational>; 3] = std::array::from_fn(|i| {
        let slope = top.derivative(i);
        slope.terms().map(|(e, c)| (*e, c.clone())).collect()
    });
    let next: BTreeMap<[u32; 3], Rational> = of_degree(degree - 1).collect();
    let product = |a: &BTreeMap<[u32; 3], Rational>, b: &BTreeMap<[u32; 3], Rational>| {
        let both = a.iter().filter_map(|(e, x)| Some(x * b.get(e)?));
        both.sum::<Rational>()
    };
    // The normal equations, and their right sides.
    let rows = slopes.each_ref().map(|a| {
        let [x, y, z] = slopes.each_ref().map(|b| product(a, b));
        [x, y, z, -product(a, &next)]
    });
    let (mut middle, free) = solved(rows);
    for direction in free {
        let is_constant = |i: usize| f.degree_in(i) == 0 || direction[i].is_zero();
        if (0..3).all(is_constant) {
            continue;
        }
        let row = f.about(&middle, limits)?.along(&direction);
        let degree = row.len() as i64 - 1;
        if degree > 0
            && let Some(over) = row[row.len() - 1].recip()
        {
            let mean = -(&row[row.len() - 2] * &over) / Rational::from(degree);
            middle = std::array::from_fn(|i| &middle[i] + &mean * &direction[i]);
        }
    }
    Ok(middle.iter().any(|c| !c.is_zero()).then_some(middle))
}

/// The exponent of about the distance of a point from the nearest root, real or not, of f on the lines through the point along the
/// axes; `None` if the point is a root.
fn size_about(f: &SparsePolynomial<3>, point: &[Rational; 3]) -> Option<i64> {
    let of_axis = |axis: usize| {
        let (row, _) = with_integers(&f.along_axis(axis, point));
        let bits: Vec<i64> = row
            .coefficients_asc()
            .iter()
            .map(|c| c.significant_bits().cast_signed())
            .collect();
        // The first coefficient is the value at the point.
        let (first, others) = bits.split_first().filter(|(first, _)| **first > 0)?;
        let used = (1i64..).zip(others).filter(|(_, bits)| **bits > 0);
        // A product of k roots is about a_0/a_k, up to a binomial coefficient.
        used.map(|(k, bits)| (first - bits).div_round(k, RoundingMode::Ceiling).0)
            .min()
    };
    (0..3).filter_map(of_axis).min()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::inspect::{Inspector, InspectorOptions, Verdict};
    use crate::language::{Numbers, parse_form};
    use crate::shape::{Form, ImplicitCurve, ImplicitSurface};

    /// Zero sets about the origin, or through it.
    const FORMS: [&str; 12] = [
        "x^2 + y^2 = 1",
        "x^2/4 + x*y/5 + 3*y^2 = 2",
        "x^4 + y^4 = 1",
        "y^2 = x^3 - x",
        "y = x^2",
        "(x + y)^2 = x - y",
        "x*y = 1",
        "x + 2*y = 0",
        "x^2 + y^2 + z^2 = 1",
        "x^2 + 2*y^2 + 3*z^2 - x*z = 1",
        "x^4 + y^4 + z^4 = 1",
        "z = x^2 - y^2",
    ];

    fn polynomial(form: &str) -> SparsePolynomial<3> {
        match parse_form(form, "<form>", Numbers::Exact).unwrap() {
            Form::Surface(surface) => surface.polynomial().clone(),
            Form::Curve(curve) => curve.polynomial().into(),
            other => panic!("{other:?}"),
        }
    }

    fn inspector(f: &SparsePolynomial<3>) -> Inspector {
        let options = InspectorOptions::new("1/10".parse().unwrap());
        let found = match f.to_plane() {
            Some(plane) => Inspector::plane(&ImplicitCurve::new(plane), &options, &Limits::none()),
            None => Inspector::surface(&ImplicitSurface::new(f.clone()), &options, &Limits::none()),
        };
        found.unwrap()
    }

    fn vector(range: std::ops::Range<i64>, over: i64) -> impl Strategy<Value = [Rational; 3]> {
        let number = range.prop_map(move |n| Rational::from(n) / Rational::from(over));
        prop::array::uniform3(number)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]

        /// What is found for a point does not change when it is moved together with the form.
        #[test]
        fn a_moved_form_is_inspected_alike(
            form in prop::sample::select(&FORMS[..]),
            by in vector(-1_000_000_000_000..1_000_000_000_000, 1000),
            point in vector(-200..200, 100),
        ) {
            let f = polynomial(form);
            let is_plane = f.degree_in(2) == 0;
            let [mut by, mut point] = [by, point];
            if is_plane {
                by[2] = Rational::zero();
                point[2] = Rational::zero();
            }
            let back = by.each_ref().map(|c| -c.clone());
            let moved = f.about(&back, &Limits::none()).unwrap();
            let there = std::array::from_fn(|i| &point[i] + &by[i]);
            let near = inspector(&f).inspect(&point);
            let far_inspector = inspector(&moved);
            let far = far_inspector.inspect(&there);
            prop_assert_eq!(near.verdict, far.verdict);
            prop_assert_eq!(near.sign, far.sign);
            prop_assert_eq!(near.curve, far.curve);
            prop_assert!(near.verdict != Verdict::Undecided);
            let [a, b] = [near.distance, far.distance];
            prop_assert!(a.low <= b.high && b.low <= a.high, "{a:?} {b:?}");
            // The bounds are about as close.
            let width = |d: &crate::inspect::DistanceBounds| d.high - d.low;
            prop_assert!(width(&b) <= 4.0 * width(&a) + 2e-6 * a.high, "{a:?} {b:?}");
            let side = far_inspector.side(there.each_ref().map(Rational::to_f64));
            prop_assert!(far.distance.low < 1e-3 || Some(side) == far.sign);
        }

        /// The middle moves with the form.
        #[test]
        fn the_middle_moves_with_the_form(
            form in prop::sample::select(&FORMS[..]),
            by in vector(1_000_000..1_000_000_000_000, 1000),
        ) {
            let f = polynomial(form);
            let mut by = by;
            if f.degree_in(2) == 0 {
                by[2] = Rational::zero();
            }
            let back = by.each_ref().map(|c| -c.clone());
            let moved = f.about(&back, &Limits::none()).unwrap();
            let none = Limits::none();
            let found = far_middle(&moved, &"1/10".parse().unwrap(), &none).unwrap().unwrap();
            let [old, new] = [&f, &moved].map(|f| middle(f, &none).unwrap().unwrap_or_default());
            for i in 0..3 {
                // Along a line the middle is not determined.
                if form != "x + 2*y = 0" {
                    prop_assert_eq!(&new[i] - &old[i], by[i].clone());
                }
                prop_assert!((&found[i] - &new[i]).abs() < Rational::one());
            }
        }
    }

    #[test]
    fn what_is_near_the_origin_stays() {
        let middle = |form: &str, tolerance: &str| {
            let tolerance = tolerance.parse().unwrap();
            far_middle(&polynomial(form), &tolerance, &Limits::none()).unwrap()
        };
        for form in FORMS {
            assert_eq!(middle(form, "1/10"), None, "{form}");
        }
        // A line that is nearer than 64 times the tolerance.
        assert_eq!(middle("x + 2*y = 3", "1/10"), None);
        assert!(middle("x + 2*y = 3", "1/1000").is_some());
    }
}
