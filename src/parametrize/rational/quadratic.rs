//! Curves with three homogeneous parts: the double cover `w² = p² − 4sq` of the line of slopes.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::CheckedSqrt;

use super::conic::{ConicParametrization, Points, points};
use super::legendre::Solution;
use super::polynomials::{constant, form_at};
use super::{Cover, RationalCurve, Rationality};
use crate::exact::integer_to_num;
use crate::parametrize::closed::{integer_square_part, squarefree_kernel};
use crate::poly::{BinaryForm, IntegerPolynomial, Ring};

/// The values of the conic at |t0|, |t1| up to this number are searched for a small quadratic field.
const FIELD_SEARCH: i64 = 12;

/// Decides about `s R² + p R + q = 0`, that is `R = (−p ± h √k) / 2s` where `p² − 4sq = h² k` and k is squarefree up to
/// constants.
///
/// The curve is birational to `w² = k(t0, t1)`. If k has the degree 2g + 2, the genus is g. For degree 2 this is a conic; for
/// degree 0 it is a pair of conjugate curves.
pub(super) fn rationality(s: &BinaryForm, p: &BinaryForm, q: &BinaryForm) -> Option<Rationality> {
    let discriminant = p.squared().minus(&s.times(q).scaled(&Integer::from(4)));
    let (h, k) = squarefree_kernel(&discriminant);
    match k.degree() {
        0 => {
            let value = k.coefficient(0);
            // If the value were a square, the curve would be reducible.
            let square = value >= 0 && value.checked_sqrt().is_some();
            (!square).then_some(Rationality::Conjugates { count: 2 })
        }
        2 => match points(&k) {
            Points::Found(list) => {
                let cover = DoubleCover { s, p, h, k };
                let curves = list.iter().flat_map(|point| cover.curves(point));
                let shortest = curves.min_by_key(RationalCurve::length)?;
                Some(Rationality::Parametrized(shortest))
            }
            Points::Other(Solution::None(place)) => Some(Rationality::NoRationalPoint {
                field: integer_to_num(&smallest_field(&k)),
                conic: k,
                place,
            }),
            Points::Other(Solution::NotDecided(number)) => Some(Rationality::NotDecided {
                conic: k,
                number: integer_to_num(&number),
            }),
            Points::Other(Solution::Point(_)) => None,
        },
        degree => Some(Rationality::PositiveGenus {
            genus: degree / 2 - 1,
            cover: Cover::Double(k),
        }),
    }
}

struct DoubleCover<'a> {
    s: &'a BinaryForm,
    p: &'a BinaryForm,
    h: BinaryForm,
    k: BinaryForm,
}

impl DoubleCover<'_> {
    /// The curves that the lines through a point of the conic give, in both directions of the parameter.
    fn curves(&self, point: &[Integer; 3]) -> Vec<RationalCurve> {
        let conic = ConicParametrization::through(&self.k, point);
        let both = [false, true].map(|inverse| {
            let [t0, t1, w] = conic.polynomials(inverse);
            let slope = [t0, t1];
            let root: IntegerPolynomial = form_at(&self.h, &slope) * w;
            let numerator = root - form_at(self.p, &slope);
            let denominator = form_at(self.s, &slope) * constant(2);
            RationalCurve::along(&slope, &numerator, &denominator)
        });
        both.into_iter().flatten().collect()
    }
}

/// A small number d such that the conic has a point over Q(√d): a value of k, divided by the squares of small primes.
fn smallest_field(k: &BinaryForm) -> Integer {
    let values = (0..=FIELD_SEARCH).flat_map(|t0| {
        (-FIELD_SEARCH..=FIELD_SEARCH)
            .map(move |t1| k.evaluate(&Integer::from(t0), &Integer::from(t1)))
    });
    let fields = values.filter(|v| *v != 0).map(|v| integer_square_part(v).1);
    fields
        .min_by_key(|d| d.unsigned_abs_ref().clone())
        .unwrap_or_else(|| k.coefficient(0))
}
