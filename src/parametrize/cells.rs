//! The circle of directions, cut at the zeros of forms, with the exact signs of the forms in every direction.

use malachite::Integer;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial;

use super::angle::{AngleRange, ExactAngle};
use crate::exact::Rational;
use crate::poly::{
    BinaryForm, IntegerPolynomial, divide_exactly, integer_sign, polynomial_gcd, primitive_part,
};
use crate::roots::{RealRoot, disjoint, real_roots};

/// The circle [0, 2π] cut at the zeros of some forms: marks (the cuts, and 0 and 2π) and the open
/// cells between them, in which no form changes its sign.
pub(super) struct Cells {
    /// The marks, ascending from 0 to 2π.
    marks: Vec<Mark>,
    /// One direction inside each cell; there is one cell fewer than marks.
    insides: Vec<SignedDirection>,
}

/// A direction, with the signs of all the forms in their order.
#[derive(Clone, Debug)]
pub(super) struct SignedDirection {
    pub(super) signs: Vec<i8>,
    /// A vector in this direction, if the direction is rational.
    pub(super) vector: Option<(Integer, Integer)>,
    /// Otherwise the tangent of the angle, and whether the direction is in [π, 2π).
    slope: Option<(RealRoot, bool)>,
}

struct Mark {
    angle: ExactAngle,
    place: SignedDirection,
    /// Vectors in the cells before and after the mark; if the mark is rational, vectors at the mark itself.
    beside: [Vector; 2],
}

type Vector = (Integer, Integer);

impl Cells {
    /// Cuts the circle at the real zeros of all the forms that are not 0. Cost: the real roots of their product.
    pub(super) fn cut(forms: &[&BinaryForm]) -> Self {
        let mut product = IntegerPolynomial::one();
        let mut vertical = false;
        for form in forms.iter().filter(|f| !f.is_zero()) {
            let new = primitive_part(form.dehomogenized());
            let common = polynomial_gcd(&product, &new);
            product *= divide_exactly(&new, &common).unwrap_or(new);
            // f(0, 1) = 0 exactly if the degree in t is smaller than that of the form.
            vertical |= form.dehomogenized().coefficients_asc().len() <= form.degree();
        }
        // With disjoint enclosures, no end of an enclosure is another mark, and there are numbers between two neighbors.
        let tangents = disjoint(real_roots(&product));
        let (negative, other): (Vec<_>, Vec<_>) =
            tangents.into_iter().partition(|t| t.signum() < 0);
        let rational = |angle: ExactAngle, vector: Vector| Mark {
            angle,
            place: SignedDirection::rational(forms, vector.clone()),
            beside: [vector.clone(), vector],
        };
        let mut half: Vec<Mark> = Vec::new();
        if other.first().is_none_or(|t| t.signum() != 0) {
            half.push(rational(ExactAngle::zero(), (Integer::ONE, Integer::ZERO)));
        }
        half.extend(other.into_iter().map(|t| Mark::algebraic(t, forms)));
        if vertical {
            let up = ExactAngle::Pi(Rational::one() / Rational::from(2));
            half.push(rational(up, (Integer::ZERO, Integer::ONE)));
        }
        half.extend(negative.into_iter().map(|t| Mark::algebraic(t, forms)));
        let other_half: Vec<Mark> = half.iter().map(|mark| mark.opposite(forms)).collect();
        let mut marks = half;
        marks.extend(other_half);
        let end = Mark {
            angle: ExactAngle::Pi(Rational::from(2)),
            place: marks[0].place.clone(),
            beside: marks[0].beside.clone(),
        };
        marks.push(end);
        let between = |pair: &[Mark]| between(&pair[0].beside[1], &pair[1].beside[0]);
        let insides = marks
            .windows(2)
            .map(|pair| SignedDirection::rational(forms, between(pair)))
            .collect();
        Self { marks, insides }
    }

    /// The maximal ranges within [0, 2π] in which `holds` is true; an isolated angle is a range [θ, θ]. `holds` is called with
    /// a direction and the two cells on both sides of it.
    pub(super) fn ranges(
        &self,
        holds: impl Fn(&SignedDirection, &[&SignedDirection]) -> bool,
    ) -> Vec<AngleRange> {
        let mut ranges: Vec<AngleRange> = Vec::new();
        let mut open: Option<AngleRange> = None;
        let cells = self.insides.len();
        for (index, mark) in self.marks.iter().enumerate() {
            let around = [
                &self.insides[(index + cells - 1) % cells],
                &self.insides[index % cells],
            ];
            let at_mark = holds(&mark.place, &around);
            let after = self.insides.get(index).is_some_and(|cell| holds(cell, &[]));
            match (open.take(), at_mark, after) {
                (Some(range), true, true) => open = Some(range),
                (Some(mut range), _, _) => {
                    range.to = mark.angle.clone();
                    range.closed[1] = at_mark;
                    ranges.push(range);
                    open = after.then(|| started(&mark.angle, at_mark));
                }
                (None, _, true) => open = Some(started(&mark.angle, at_mark)),
                // The angle 2π is the direction of 0.
                (None, true, false) if index + 1 < self.marks.len() => {
                    ranges.push(AngleRange::point(mark.angle.clone()));
                }
                (None, _, false) => {}
            }
        }
        ranges
    }
}

impl SignedDirection {
    pub(super) fn rational(forms: &[&BinaryForm], (u, v): Vector) -> Self {
        let sign = |form: &&BinaryForm| integer_sign(&form.evaluate(&u, &v));
        Self {
            signs: forms.iter().map(sign).collect(),
            vector: Some((u, v)),
            slope: None,
        }
    }

    /// The sign of another form in this direction.
    pub(super) fn sign_of(&self, form: &BinaryForm) -> i8 {
        if let Some((u, v)) = &self.vector {
            return integer_sign(&form.evaluate(u, v));
        }
        let Some((slope, below)) = &self.slope else {
            return 0;
        };
        // (1, t) has an angle in [0, π) only for t ≥ 0.
        let is_turned = *below != (slope.signum() < 0);
        let sign = slope.sign_of(form.dehomogenized());
        if is_turned && !form.is_even() {
            -sign
        } else {
            sign
        }
    }
}

impl Mark {
    /// The direction in [0, π) with an algebraic tangent. A form that does not vanish there has the sign that it has in the
    /// neighbouring cells.
    fn algebraic(mut tangent: RealRoot, forms: &[&BinaryForm]) -> Self {
        // The enclosure is narrowed so that it does not hold 0, where there may be a mark.
        tangent.refine(8);
        let (low, high) = tangent.enclosure();
        let upward = |t: Rational| {
            let (u, v) = (t.denominator(), t.numerator());
            if v < 0 { (-u, -v) } else { (u, v) }
        };
        let beside = [upward(low.to_rational()), upward(high.to_rational())];
        let near = SignedDirection::rational(forms, beside[0].clone());
        let signs = forms.iter().zip(near.signs).map(|(form, sign)| {
            if tangent.is_root_of(form.dehomogenized()) {
                0
            } else {
                sign
            }
        });
        Self {
            place: SignedDirection {
                signs: signs.collect(),
                vector: None,
                slope: Some((tangent.clone(), false)),
            },
            angle: ExactAngle::of_tangent(tangent),
            beside,
        }
    }

    /// The opposite direction.
    fn opposite(&self, forms: &[&BinaryForm]) -> Self {
        let turned = |(u, v): &Vector| (-u, -v);
        let signs = forms.iter().zip(&self.place.signs);
        Self {
            angle: self.angle.plus_pi(),
            place: SignedDirection {
                signs: signs
                    .map(|(f, &s)| if f.is_even() { s } else { -s })
                    .collect(),
                vector: self.place.vector.as_ref().map(turned),
                slope: self.place.slope.clone().map(|(t, below)| (t, !below)),
            },
            beside: self.beside.each_ref().map(turned),
        }
    }
}

fn started(angle: &ExactAngle, closed: bool) -> AngleRange {
    AngleRange {
        from: angle.clone(),
        to: angle.clone(),
        closed: [closed, closed],
    }
}

/// A rational vector strictly between two neighbouring marks. The given vectors are just after the first mark and just before
/// the second one.
fn between((u0, v0): &Vector, (u1, v1): &Vector) -> Vector {
    let cross = u0 * v1 - v0 * u1;
    if cross > 0 {
        return (u0 + u1, v0 + v1);
    }
    // The marks are half a turn apart; the left normal of the first vector is between them.
    (-v0, u0.clone())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn form(coefficients: &[i64]) -> BinaryForm {
        BinaryForm::from_coefficients(coefficients.iter().map(|&c| Integer::from(c)).collect())
    }

    fn shown(f: &BinaryForm, holds: impl Fn(i8) -> bool) -> String {
        let cells = Cells::cut(&[f]);
        let text = |r: &AngleRange| {
            let [a, b] = r.closed;
            format!(
                "{}{}, {}{}",
                if a { '[' } else { '(' },
                r.from.describe(),
                r.to.describe(),
                if b { ']' } else { ')' }
            )
        };
        let ranges = cells.ranges(|place, _| holds(place.signs[0]));
        ranges.iter().map(text).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn signs_of_forms_around_the_circle() {
        let positive = |s: i8| s > 0;
        let not_negative = |s: i8| s >= 0;
        // The set x² − y² ≥ 0.
        assert_eq!(
            shown(&form(&[1, 0, -1]), not_negative),
            "[0, pi/4] [3*pi/4, 5*pi/4] [7*pi/4, 2*pi]"
        );
        // The set 2xy > 0; the form has zeros at 0 and at π/2.
        assert_eq!(shown(&form(&[0, 2, 0]), positive), "(0, pi/2) (pi, 3*pi/2)");
        assert_eq!(
            shown(&form(&[0, 2, 0]), not_negative),
            "[0, pi/2] [pi, 3*pi/2]"
        );
        // The set x − 2y > 0, for a form of odd degree.
        assert_eq!(
            shown(&form(&[1, -2]), positive),
            "[0, atan(1/2)) (pi + atan(1/2), 2*pi]"
        );
        // A form without zeros, and a form that is not 0 except in single directions.
        assert_eq!(shown(&form(&[1, 0, 1]), positive), "[0, 2*pi]");
        assert_eq!(
            shown(&form(&[1, -2, 1]), positive),
            "[0, pi/4) (pi/4, 5*pi/4) (5*pi/4, 2*pi]"
        );
        // The set −(x − y)² ≥ 0 consists of isolated angles.
        assert_eq!(
            shown(&form(&[-1, 2, -1]), not_negative),
            "[pi/4, pi/4] [5*pi/4, 5*pi/4]"
        );
        // The sets x > 0 and y > 0.
        assert_eq!(shown(&form(&[1, 0]), positive), "[0, pi/2) (3*pi/2, 2*pi]");
        assert_eq!(shown(&form(&[0, 1]), positive), "(0, pi)");
    }

    proptest! {
        /// The zeros of `k·(q y − p x)² − x²` are irrational, or the isolation does not know that they are rational, and are near the
        /// rational p/q, a zero of another form. Directions inside cells are no zeros, and the signs at marks are exact.
        #[test]
        fn zeros_that_are_near_each_other_are_told_apart(
            (p, q) in (-40i64..41, 1i64..17),
            k in prop::sample::select(vec![2i64, 3, 7, 100, 5_000, 80_003, 1 << 20, 3_000_017]),
            others in prop::collection::vec(prop::collection::vec(-9i64..10, 2..5), 0..3),
        ) {
            let line = form(&[-p, q]);
            let near = form(&[k * p * p - 1, -2 * k * p * q, k * q * q]);
            let mut forms = vec![line, near];
            forms.extend(others.iter().map(|c| form(c)));
            let forms: Vec<&BinaryForm> = forms.iter().collect();
            let cells = Cells::cut(&forms);
            for inside in &cells.insides {
                for (form, sign) in forms.iter().zip(&inside.signs) {
                    prop_assert!(form.is_zero() || *sign != 0, "a cell has no zeros inside");
                }
            }
            for mark in &cells.marks {
                for (form, sign) in forms.iter().zip(&mark.place.signs) {
                    prop_assert_eq!(*sign, mark.place.sign_of(form));
                }
            }
        }
    }
}
