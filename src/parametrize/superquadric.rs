//! Example 6: the radius of a superquadric, by Lemma 2 with real degrees.

use malachite::Integer;

use super::angle::AngleRange;
use super::expression::Expression;
use super::parametrization::{Branch, Parametrization, PolarMethod, Radius};
use crate::exact::Rational;
use crate::poly::BinaryForm;
use crate::shape::Superquadric;

/// `r(θ) = (c / (|cos θ/a1|^(2/ε) + |sin θ/a2|^(2/ε)))^(ε/2)` (Eq. (20)): real and positive for every θ.
///
/// Where 2/ε is an even integer the absolute values are left out, and this is Lemma 2 for the polynomial. The other
/// root, −r(θ), has the same points and is not listed.
///
/// ```
/// use stellate::exact::Rational;
/// use stellate::parametrize::parametrize_superquadric;
/// use stellate::shape::Superquadric;
///
/// let one = Rational::one;
/// let square = Superquadric::new([one(), one()], "1/2".parse()?, one()).unwrap();
/// let curve = parametrize_superquadric(&square);
/// assert_eq!((curve.step, curve.branches.len()), (4, 1));
/// # Ok::<(), stellate::error::Error>(())
/// ```
#[must_use]
pub fn parametrize_superquadric(shape: &Superquadric) -> Parametrization {
    let exponent = shape.exponent();
    let [a1, a2] = shape.semi_axes();
    let term = |cosine: i64, sine: i64, axis: &Rational| {
        let form = BinaryForm::from_coefficients([cosine, sine].map(Integer::from).to_vec());
        let scaled = over(Expression::form(form), axis);
        let magnitude = if shape.even_exponent().is_some() {
            scaled
        } else {
            Expression::Absolute(Box::new(scaled))
        };
        power(magnitude, &exponent)
    };
    let sum = Expression::Sum(Box::new(term(1, 0, a1)), Box::new(term(0, 1, a2)));
    let quotient = Expression::Quotient(
        Box::new(Expression::Constant(shape.level().clone())),
        Box::new(sum),
    );
    let half = shape.epsilon() / &Rational::from(2);
    let step = exponent
        .is_integer()
        .then(|| usize::try_from(&exponent.numerator()).ok())
        .flatten();
    Parametrization {
        method: PolarMethod::Lemma(2),
        step: step.unwrap_or(1),
        lines: Vec::new(),
        branches: vec![Branch {
            factor: 0,
            radius: Radius::Closed(power(quotient, &half)),
            real: vec![AngleRange::full_circle()],
            positive: vec![AngleRange::full_circle()],
        }],
        notes: vec![format!(
            "Lemma 2 for parts of the degrees {exponent} and 0 gives r^{}; -r(theta) has the same points",
            if exponent.is_integer() {
                exponent.to_string()
            } else {
                format!("({exponent})")
            }
        )],
        center: [Rational::zero(), Rational::zero()],
        rational: Vec::new(),
        superquadric: Some(shape.clone()),
    }
}

/// a/q with the denominator of q multiplied up: `3*cos(theta)/2`.
fn over(a: Expression, q: &Rational) -> Expression {
    let constant = |c: Integer| BinaryForm::from_coefficients(vec![c]);
    a.times(constant(q.denominator()))
        .over(constant(q.numerator()))
}

fn power(a: Expression, q: &Rational) -> Expression {
    let inverse = u32::try_from(&q.denominator())
        .ok()
        .filter(|_| q.numerator() == 1);
    match inverse {
        Some(k) => a.root(k),
        None => Expression::Power(Box::new(a), q.clone()),
    }
}
