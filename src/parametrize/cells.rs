//! The circle of directions, cut where forms vanish: exact signs in every direction.

use malachite::Integer;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial;

use super::angle::{AngleRange, ExactAngle};
use crate::exact::Rational;
use crate::poly::{BinaryForm, IntegerPolynomial, RealRoot, primitive_part, real_roots};

/// A direction at which the exact sign of any form can be asked.
#[derive(Clone, Debug)]
pub(super) enum Heading {
    /// (u, v), not both 0.
    Rational(Integer, Integer),
    /// (1, t), or (−1, −t) if `opposite`, for an algebraic t.
    Algebraic { tangent: RealRoot, opposite: bool },
}

impl Heading {
    /// −1, 0 or 1.
    pub(super) fn sign(&self, form: &BinaryForm) -> i8 {
        match self {
            Self::Rational(u, v) => {
                let value = form.evaluate(u, v);
                i8::from(value > 0) - i8::from(value < 0)
            }
            Self::Algebraic { tangent, opposite } => {
                let sign = tangent.sign_of(form.dehomogenized());
                if *opposite && !form.is_even() {
                    -sign
                } else {
                    sign
                }
            }
        }
    }

    fn opposite(&self) -> Self {
        match self {
            Self::Rational(u, v) => Self::Rational(-u, -v),
            Self::Algebraic { tangent, opposite } => Self::Algebraic {
                tangent: tangent.clone(),
                opposite: !opposite,
            },
        }
    }
}

/// The circle [0, 2π] cut at the zeros of some forms: marks (the cuts, and 0 and 2π) and the open
/// cells between them, in which no form changes its sign.
pub(super) struct Cells {
    /// Ascending from 0 to 2π.
    marks: Vec<(ExactAngle, Heading)>,
    /// A heading inside each cell; one fewer than marks.
    insides: Vec<Heading>,
}

impl Cells {
    /// Cuts at the real zeros of all the (non-zero) forms.
    pub(super) fn cut(forms: &[&BinaryForm]) -> Self {
        let mut product = IntegerPolynomial::one();
        let mut vertical = false;
        for form in forms.iter().filter(|f| !f.is_zero()) {
            product *= primitive_part(form.dehomogenized());
            // f(0, 1) = 0 where the degree in t drops.
            vertical |= form.dehomogenized().coefficients_asc().len() <= form.degree();
        }
        let tangents = real_roots(&product);
        let (negative, other): (Vec<_>, Vec<_>) =
            tangents.into_iter().partition(|t| t.signum() < 0);
        let algebraic = |mut tangent: RealRoot| {
            // Away from 0, where there may be a mark.
            tangent.refine(8);
            let opposite = tangent.signum() < 0;
            let heading = Heading::Algebraic {
                tangent: tangent.clone(),
                opposite,
            };
            (ExactAngle::of_tangent(tangent), heading)
        };
        let up = (
            ExactAngle::Pi(Rational::one() / Rational::from(2)),
            Heading::Rational(Integer::ZERO, Integer::ONE),
        );
        let mut half: Vec<(ExactAngle, Heading)> = Vec::new();
        if other.first().is_none_or(|t| t.signum() != 0) {
            half.push((ExactAngle::zero(), east()));
        }
        half.extend(other.into_iter().map(algebraic));
        half.extend(vertical.then_some(up));
        half.extend(negative.into_iter().map(algebraic));
        let mut marks = half.clone();
        marks.extend(
            half.iter()
                .map(|(angle, heading)| (angle.plus_pi(), heading.opposite())),
        );
        marks.push((ExactAngle::Pi(Rational::from(2)), marks[0].1.clone()));
        let insides = marks
            .windows(2)
            .map(|pair| between(&pair[0].1, &pair[1].1))
            .collect();
        Self { marks, insides }
    }

    /// The maximal ranges in which `holds`, within [0, 2π]; isolated angles as [θ, θ].
    pub(super) fn ranges(&self, holds: impl Fn(&Heading) -> bool) -> Vec<AngleRange> {
        let mut ranges: Vec<AngleRange> = Vec::new();
        let mut open: Option<AngleRange> = None;
        for (index, (angle, heading)) in self.marks.iter().enumerate() {
            let at_mark = holds(heading);
            let after = self.insides.get(index).is_some_and(&holds);
            match (open.take(), at_mark, after) {
                (Some(range), true, true) => open = Some(range),
                (Some(mut range), _, _) => {
                    range.to = angle.clone();
                    range.closed[1] = at_mark;
                    ranges.push(range);
                    open = after.then(|| started(angle, at_mark));
                }
                (None, _, true) => open = Some(started(angle, at_mark)),
                // 2π is 0 again.
                (None, true, false) if index + 1 < self.marks.len() => {
                    ranges.push(AngleRange::point(angle.clone()));
                }
                (None, _, false) => {}
            }
        }
        ranges
    }
}

fn started(angle: &ExactAngle, closed: bool) -> AngleRange {
    AngleRange {
        from: angle.clone(),
        to: angle.clone(),
        closed: [closed, closed],
    }
}

fn east() -> Heading {
    Heading::Rational(Integer::ONE, Integer::ZERO)
}

/// A rational heading strictly between two neighbouring marks, less than π apart or π apart.
fn between(from: &Heading, to: &Heading) -> Heading {
    // Rational vectors inside the cell next to each mark, then their sum: it lies between them.
    let (_, (u0, v0)) = vectors(from);
    let ((u1, v1), _) = vectors(to);
    let cross = &u0 * &v1 - &v0 * &u1;
    if cross > 0 {
        return Heading::Rational(u0 + u1, v0 + v1);
    }
    if u0 == u1 && v0 == v1 {
        // The enclosures of two tangents touch here, and neither tangent is an end of its own.
        return Heading::Rational(u0, v0);
    }
    // A half turn: the left normal.
    Heading::Rational(-v0, u0)
}

type Vector = (Integer, Integer);

/// Vectors just clockwise of (or at) a heading and just counter-clockwise of (or at) it, so close that
/// neighbouring marks are apart.
fn vectors(heading: &Heading) -> (Vector, Vector) {
    match heading {
        Heading::Rational(u, v) => ((u.clone(), v.clone()), (u.clone(), v.clone())),
        Heading::Algebraic { tangent, opposite } => {
            let (low, high) = tangent.bounds();
            let vector = |t: Rational| {
                let (u, v) = (t.denominator(), t.numerator());
                if *opposite { (-u, -v) } else { (u, v) }
            };
            (vector(low.to_rational()), vector(high.to_rational()))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let ranges = cells.ranges(|h| holds(h.sign(f)));
        ranges.iter().map(text).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn signs_of_forms_around_the_circle() {
        let positive = |s: i8| s > 0;
        let not_negative = |s: i8| s >= 0;
        // x² − y² ≥ 0
        assert_eq!(
            shown(&form(&[1, 0, -1]), not_negative),
            "[0, pi/4] [3*pi/4, 5*pi/4] [7*pi/4, 2*pi]"
        );
        // 2xy > 0: zeros at 0 and at π/2
        assert_eq!(shown(&form(&[0, 2, 0]), positive), "(0, pi/2) (pi, 3*pi/2)");
        assert_eq!(
            shown(&form(&[0, 2, 0]), not_negative),
            "[0, pi/2] [pi, 3*pi/2]"
        );
        // An odd form: x − 2y > 0
        assert_eq!(
            shown(&form(&[1, -2]), positive),
            "[0, atan(1/2)) (pi + atan(1/2), 2*pi]"
        );
        // Nowhere zero, and everywhere but at single directions
        assert_eq!(shown(&form(&[1, 0, 1]), positive), "[0, 2*pi]");
        assert_eq!(
            shown(&form(&[1, -2, 1]), positive),
            "[0, pi/4) (pi/4, 5*pi/4) (5*pi/4, 2*pi]"
        );
        // Isolated admissible angles: −(x − y)² ≥ 0
        assert_eq!(
            shown(&form(&[-1, 2, -1]), not_negative),
            "[pi/4, pi/4] [5*pi/4, 5*pi/4]"
        );
        // x > 0, y > 0
        assert_eq!(shown(&form(&[1, 0]), positive), "[0, pi/2) (3*pi/2, 2*pi]");
        assert_eq!(shown(&form(&[0, 1]), positive), "(0, pi)");
    }
}
