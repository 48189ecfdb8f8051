//! Forms on unit vectors, simplified for printing.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{Abs, CheckedSqrt, DivRem, Gcd, Parity};
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial;

use crate::factor::squarefree_form;
use crate::limits::Limits;
use crate::poly::{
    BinaryForm, HomogeneousPolynomial, IntegerPolynomial, Ring, TernaryForm,
    squarefree_decomposition,
};

/// Square factors of constants are taken out of roots for primes up to this one.
const LARGEST_SQUARE_PRIME: u32 = 1000;

/// Square factors of ternary forms are taken out of roots up to this degree.
const LARGEST_SQUARE_DEGREE: usize = 24;

/// A form from which square factors can be taken out of a root.
pub(in crate::parametrize) trait LemmaForm: HomogeneousPolynomial {
    /// (h, g) with `form = h² g`; g is squarefree up to constants, except for the limits above.
    fn squarefree_kernel(&self) -> (Self, Self);
}

impl LemmaForm for BinaryForm {
    fn squarefree_kernel(&self) -> (Self, Self) {
        squarefree_kernel(self)
    }
}

impl LemmaForm for TernaryForm {
    fn squarefree_kernel(&self) -> (Self, Self) {
        let Some((_, first)) = self.terms().next() else {
            return (Self::zero(0), Self::zero(0));
        };
        let whole = || (constant(1), self.clone());
        if self.degree() > LARGEST_SQUARE_DEGREE {
            return whole();
        }
        let signed_content = if *first < 0 {
            -self.content()
        } else {
            self.content()
        };
        let Ok(parts) = squarefree_form(self, &Limits::none()) else {
            return whole();
        };
        let (root, rest) = integer_square_part(signed_content);
        let (mut outside, mut inside) = (Self::constant(root), Self::constant(rest));
        for (multiplicity, part) in parts {
            for _ in 0..multiplicity / 2 {
                outside = outside.times(&part);
            }
            if multiplicity.odd() {
                inside = inside.times(&part);
            }
        }
        (outside, inside)
    }
}

/// The product of c and some forms.
pub(super) fn product<F: HomogeneousPolynomial>(c: i64, forms: &[&F]) -> F {
    let one = F::constant(Integer::from(c));
    forms.iter().fold(one, |product, form| product.times(form))
}

/// The constant form c.
pub(super) fn constant<F: HomogeneousPolynomial>(c: i64) -> F {
    product(c, &[])
}

pub(super) fn negative<F: HomogeneousPolynomial>(form: &F) -> F {
    form.scaled(&Integer::from(-1))
}

/// The forms, divided by the gcd of all their coefficients; the first coefficient of the last form is positive.
pub(super) fn reduced<F: HomogeneousPolynomial, const N: usize>(forms: [F; N]) -> [F; N] {
    let mut content = Integer::ZERO;
    for form in &forms {
        content = Integer::from(
            content
                .unsigned_abs_ref()
                .gcd(form.content().unsigned_abs_ref()),
        );
    }
    let last_is_negative = forms[N - 1]
        .monomials()
        .first()
        .is_some_and(|(_, c)| **c < 0);
    if last_is_negative {
        content = -content;
    }
    if content == 0 {
        return forms;
    }
    forms.map(|form| form.div_exact(&content))
}

/// (h, g) with `form = h² g` on unit vectors; g is squarefree up to constants.
pub(super) fn square_part<F: LemmaForm>(form: &F) -> (F, F) {
    form.on_unit_vectors().squarefree_kernel()
}

/// (h, g) with `form = h² g`; g is squarefree up to constants.
pub(in crate::parametrize) fn squarefree_kernel(form: &BinaryForm) -> (BinaryForm, BinaryForm) {
    let in_t = form.dehomogenized();
    let Some(lead) = in_t.coefficients_asc().last() else {
        return (BinaryForm::zero(0), BinaryForm::zero(0));
    };
    let mut outside = IntegerPolynomial::one();
    let mut inside = IntegerPolynomial::one();
    for (multiplicity, part) in squarefree_decomposition(in_t) {
        for _ in 0..multiplicity / 2 {
            outside *= &part;
        }
        if multiplicity.odd() {
            inside *= &part;
        }
    }
    let sign = if *lead > 0 {
        Integer::ONE
    } else {
        -Integer::ONE
    };
    let (root, rest) = integer_square_part(form.content() * sign);
    let constant = |c: Integer| IntegerPolynomial::from_coefficients_asc(vec![c]);
    let x_power = form.degree() + 1 - in_t.coefficients_asc().len();
    let degree = |p: &IntegerPolynomial| p.coefficients_asc().len() - 1;
    (
        BinaryForm::from_dehomogenized(degree(&outside) + x_power / 2, outside * constant(root)),
        BinaryForm::from_dehomogenized(degree(&inside) + x_power % 2, inside * constant(rest)),
    )
}

/// (a, b) with value = a² b, where a takes all square factors of small primes.
pub(in crate::parametrize) fn integer_square_part(value: Integer) -> (Integer, Integer) {
    if value > 0
        && let Some(root) = (&value).checked_sqrt()
    {
        return (root, Integer::ONE);
    }
    let mut root = Integer::ONE;
    let mut rest = value;
    for p in 2..LARGEST_SQUARE_PRIME {
        let square = Integer::from(p * p);
        if square > (&rest).abs() {
            break;
        }
        loop {
            let (quotient, remainder) = (&rest).div_rem(&square);
            if remainder != 0 {
                break;
            }
            rest = quotient;
            root *= Integer::from(p);
        }
    }
    (root, rest)
}
