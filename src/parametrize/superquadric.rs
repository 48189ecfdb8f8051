//! Examples 6 and 10: the radii of superquadrics, by Lemmas 2 and 7 with real exponents.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Parity;

use super::angle::AngleRange;
use super::condition::Condition;
use super::expression::Expression;
use super::parametrization::{Branch, BranchRadius, Parametrization, PolarMethod};
use super::surface::{SurfaceBranch, SurfaceMethod, SurfaceParametrization};
use crate::exact::Rational;
use crate::poly::{BinaryForm, HomogeneousPolynomial, TernaryForm};
use crate::shape::{Form, SpaceSuperquadric, Superquadric};

/// `r(θ) = (c / (|cos θ/a1|^(2/ε) + |sin θ/a2|^(2/ε)))^(ε/2)` (Eq. (20)): real and positive for every θ.
///
/// If 2/ε is an even integer, the absolute values are left out, and this is Lemma 2 for the polynomial. The other root, −r(θ),
/// gives the same points and is not listed.
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
            radius: BranchRadius::Closed(power(quotient, &half)),
            real: vec![AngleRange::full_circle()],
            positive: vec![AngleRange::full_circle()],
            holds_where_real: true,
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
        of: Form::Superquadric(shape.clone()),
    }
}

/// `R(θ, φ) = (c / ([|α/a1|^(2/ε2) + |β/a2|^(2/ε2)]^(ε2/ε1) + |γ/a3|^(2/ε1)))^(ε1/2)` (Eq. (77), corrected), with
/// (α, β, γ) = (sin φ cos θ, sin φ sin θ, cos φ): real and positive in every direction.
///
/// ```
/// use stellate::exact::Rational;
/// use stellate::parametrize::parametrize_space_superquadric;
/// use stellate::shape::SpaceSuperquadric;
///
/// let one = Rational::one;
/// let shape = SpaceSuperquadric::new([one(), one(), 2.into()], [one(), one()], one()).unwrap();
/// let ellipsoid = parametrize_space_superquadric(&shape);
/// assert_eq!(ellipsoid.branches[0].radius.approximate([0.0, 0.0, 1.0]), 2.0);
/// ```
#[must_use]
pub fn parametrize_space_superquadric(shape: &SpaceSuperquadric) -> SurfaceParametrization {
    let [of_xy, of_sum, of_z] = shape.exponents();
    let term = |axis: usize, exponent: &Rational| {
        let mut exponents = [0; 3];
        exponents[axis] = 1;
        let form = TernaryForm::from_terms(1, [(exponents, Integer::from(1))]);
        let scaled = over(Expression::form(form), &shape.semi_axes()[axis]);
        let even = exponent.is_integer() && exponent.numerator().even();
        let magnitude = if even {
            scaled
        } else {
            Expression::Absolute(Box::new(scaled))
        };
        power(magnitude, exponent)
    };
    let sum = |a, b| Expression::Sum(Box::new(a), Box::new(b));
    let around = power(sum(term(0, &of_xy), term(1, &of_xy)), &of_sum);
    let quotient = Expression::Quotient(
        Box::new(Expression::Constant(shape.level().clone())),
        Box::new(sum(around, term(2, &of_z))),
    );
    let half = &shape.epsilon()[0] / &Rational::from(2);
    let step = of_z
        .is_integer()
        .then(|| usize::try_from(&of_z.numerator()).ok());
    SurfaceParametrization {
        method: SurfaceMethod::Lemma(7),
        step: step.flatten().unwrap_or(1),
        factors: Vec::new(),
        branches: vec![SurfaceBranch {
            factor: 0,
            radius: power(quotient, &half),
            condition: "and positive in every direction".into(),
            real_where: Condition::All(Vec::new()),
            holds_where_real: true,
        }],
        notes: vec![format!(
            "Lemma 7 for parts of the degrees {of_z} and 0; -R(theta, phi) has the same points"
        )],
        of: Form::SpaceSuperquadric(shape.clone()),
    }
}

/// The quotient a/q, written with the denominator of q as a factor: `3*cos(theta)/2`.
fn over<F: HomogeneousPolynomial>(a: Expression<F>, q: &Rational) -> Expression<F> {
    a.times(F::constant(q.denominator()))
        .over(F::constant(q.numerator()))
}

fn power<F: HomogeneousPolynomial>(a: Expression<F>, q: &Rational) -> Expression<F> {
    let inverse = u32::try_from(&q.denominator())
        .ok()
        .filter(|_| q.numerator() == 1);
    match inverse {
        Some(k) => a.root(k),
        None => Expression::Power(Box::new(a), q.clone()),
    }
}
