//! Ternary forms: homogeneous polynomials in x, y and z.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::{Gcd, Square};
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use super::ternary_terms::on_meridian;
use super::{BinaryForm, IntegerPolynomial, Ring, SparsePolynomial, polynomial_sqrt};
use crate::error::Invariant;
use crate::exact::Rational;

/// A homogeneous polynomial `f(x, y, z) = Σ_j f_j(x, y) z^j` with integer coefficients, stored as a binary form of degree d − j
/// for every power of z. It can be converted into a [`SparsePolynomial`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TernaryForm {
    /// The d + 1 binary forms; `rows[j]` has the degree d − j.
    rows: Vec<BinaryForm>,
}

impl TernaryForm {
    /// The form whose coefficients of z⁰, z¹, …, z^d are these binary forms.
    ///
    /// # Panics
    /// If the degrees are not d, d − 1, …, 0.
    pub(crate) fn from_rows(rows: Vec<BinaryForm>) -> Self {
        let descending = rows.iter().rev().enumerate();
        assert!(
            !rows.is_empty() && descending.into_iter().all(|(d, row)| row.degree() == d),
            "row j of a ternary form has degree d - j"
        );
        Self { rows }
    }

    /// The sum of the terms c x^i y^j z^k, with i + j + k = `degree`.
    ///
    /// # Panics
    /// If a term has another degree.
    pub(crate) fn from_terms(
        degree: usize,
        terms: impl IntoIterator<Item = ([usize; 3], Integer)>,
    ) -> Self {
        // The rows are only as long as the terms require.
        let mut rows: Vec<Vec<Integer>> = vec![Vec::new(); degree + 1];
        for ([i, j, k], c) in terms {
            assert_eq!(i + j + k, degree, "the terms of a form have one degree");
            let row = &mut rows[k];
            if row.len() <= j {
                row.resize(j + 1, Integer::ZERO);
            }
            row[j] += c;
        }
        let rows = rows.into_iter().enumerate();
        Self::from_rows(
            rows.map(|(k, row)| {
                let row = IntegerPolynomial::from_coefficients_asc(row);
                BinaryForm::from_dehomogenized(degree - k, row)
            })
            .collect(),
        )
    }

    /// The zero form of degree `degree`.
    pub(crate) fn zero(degree: usize) -> Self {
        Self::from_rows((0..=degree).rev().map(BinaryForm::zero).collect())
    }

    /// The form `x² + y² + z²`.
    #[cfg(test)]
    pub(crate) fn rho() -> Self {
        let one = || Integer::from(1);
        Self::from_terms(
            2,
            [([2, 0, 0], one()), ([0, 2, 0], one()), ([0, 0, 2], one())],
        )
    }

    /// The degree d, which the zero form has as well.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.rows.len() - 1
    }

    /// Whether every coefficient is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.rows.iter().all(BinaryForm::is_zero)
    }

    /// The coefficients of z⁰, z¹, …, which are forms in x and y.
    pub(crate) fn rows(&self) -> &[BinaryForm] {
        &self.rows
    }

    /// The non-zero terms as ([i, j, k], coefficient of x^i y^j z^k), in canonical order.
    pub(crate) fn terms(&self) -> impl Iterator<Item = ([usize; 3], &Integer)> {
        let rows = self.rows.iter().map(BinaryForm::terms);
        in_canonical_order(self.degree(), rows)
    }

    /// The terms of [`Self::terms`], moved.
    pub(crate) fn into_terms(self) -> impl Iterator<Item = ([usize; 3], Integer)> {
        let degree = self.degree();
        in_canonical_order(degree, self.rows.into_iter().map(BinaryForm::into_terms))
    }

    /// The gcd of the coefficients; 0 for the zero form.
    pub(crate) fn content(&self) -> Integer {
        let contents = self.rows.iter().map(BinaryForm::content);
        contents.fold(Integer::ZERO, |gcd, c| {
            Integer::from(gcd.unsigned_abs_ref().gcd(c.unsigned_abs_ref()))
        })
    }

    /// The quotient `f / divisor`; the divisor must divide the content.
    pub(crate) fn div_exact(&self, divisor: &Integer) -> Self {
        self.each(|row| row.div_exact(divisor))
    }

    /// The product `factor · f`.
    pub(crate) fn scaled(&self, factor: &Integer) -> Self {
        self.each(|row| row.scaled(factor))
    }

    /// The product `(x² + y² + z²)^power f`, by two additions in place for each coefficient of each of the products by x² + y² + z².
    pub(crate) fn times_rho_power(self, power: usize) -> Self {
        let first = self.degree();
        let last = first + 2 * power;
        let rows = self.rows.into_iter().map(BinaryForm::into_coefficients);
        let mut rows: Vec<Vec<Integer>> = rows.collect();
        rows.resize(last + 1, Vec::new());
        for (k, row) in rows.iter_mut().enumerate() {
            row.resize(last - k + 1, Integer::ZERO);
        }
        for degree in (first + 2..=last).step_by(2) {
            // From above, so that what is added is still that of the form before.
            for k in (0..=degree).rev() {
                let (below, row) = rows.split_at_mut(k);
                let row = &mut row[0][..=degree - k];
                for j in (2..row.len()).rev() {
                    let (low, high) = row.split_at_mut(j);
                    high[0] += &low[j - 2];
                }
                if k >= 2 {
                    for (c, flat) in row.iter_mut().zip(&below[k - 2]) {
                        *c += flat;
                    }
                }
            }
        }
        let rows = rows.into_iter().map(BinaryForm::from_coefficients);
        Self::from_rows(rows.collect())
    }

    /// The square of a form without many zeros, as one square of a univariate polynomial (Kronecker's substitution): at x = 1
    /// the power y^j z^k becomes t^(j + (2d+1) k). Cost: one square with 2(d + 1)² coefficients, whatever the number of terms.
    pub(crate) fn squared_densely(&self) -> Self {
        let degree = self.degree();
        let stride = 2 * degree + 1;
        let mut packed = vec![Integer::ZERO; stride * degree + 1];
        for (k, row) in self.rows.iter().enumerate() {
            for (j, c) in row.terms() {
                packed[stride * k + j] = c.clone();
            }
        }
        let square = IntegerPolynomial::from_coefficients_asc(packed).square();
        let mut coefficients = square.into_coefficients_asc().into_iter();
        let rows = (0..=2 * degree).rev().map(|d| {
            // Row k = 2·degree − d has degree d; what is above it in its stride is 0.
            let row: Vec<Integer> = coefficients.by_ref().take(stride).collect();
            BinaryForm::from_dehomogenized(d, IntegerPolynomial::from_coefficients_asc(row))
        });
        Self::from_rows(rows.collect())
    }

    /// The form g with g² = f and a positive first coefficient in Kronecker's substitution of [`Self::squared_densely`]; `None` if f is no
    /// square.
    pub(crate) fn square_root(&self) -> Option<Self> {
        let degree = self.degree();
        if !degree.is_multiple_of(2) {
            return None;
        }
        let half = degree / 2;
        let stride = degree + 1;
        let mut packed = vec![Integer::ZERO; stride * degree + 1];
        for (k, row) in self.rows.iter().enumerate() {
            for (j, c) in row.terms() {
                packed[stride * k + j] = c.clone();
            }
        }
        let root = polynomial_sqrt(&IntegerPolynomial::from_coefficients_asc(packed))?;
        let mut coefficients = root.into_coefficients_asc();
        coefficients.resize(stride * (half + 1), Integer::ZERO);
        let rows = coefficients.chunks(stride).enumerate().map(|(k, row)| {
            let own = row.get(..half + 1 - k.min(half))?;
            let rest = row.get(own.len()..)?;
            let in_t = IntegerPolynomial::from_coefficients_asc(own.to_vec());
            rest.iter()
                .all(|c| *c == 0)
                .then(|| BinaryForm::from_dehomogenized(half - k, in_t))
        });
        let rows: Option<Vec<BinaryForm>> = rows.take(half + 1).collect();
        let root = Self::from_rows(rows?);
        (root.squared_densely() == *self).then_some(root)
    }

    fn each(&self, change: impl Fn(&BinaryForm) -> BinaryForm) -> Self {
        Self {
            rows: self.rows.iter().map(change).collect(),
        }
    }

    /// The quotient `f / (x² + y² + z²)`; `None` if it is not a form.
    pub(crate) fn divided_by_rho(&self) -> Option<Self> {
        let degree = self.degree();
        if degree < 2 || !self.vanishes_at_an_isotropic_vector() {
            return None;
        }
        // The division begins with the highest power of z: q_j = f_(j+2) − (x² + y²) q_(j+2).
        let mut rest = self.rows.clone();
        let mut quotient = Vec::with_capacity(degree - 1);
        for j in (0..=degree - 2).rev() {
            let q = rest[j + 2].clone();
            rest[j] = rest[j].minus(&q.times_rho());
            quotient.push(q);
        }
        quotient.reverse();
        let divides = rest[0].is_zero() && rest[1].is_zero();
        divides.then(|| Self::from_rows(quotient))
    }

    /// Whether f(3, 4, 5i) = 0. This is necessary for x² + y² + z² to divide f, because 3² + 4² + (5i)² = 0. The value costs
    /// far less than a division, which fills the zeros of f with coefficients.
    fn vanishes_at_an_isotropic_vector(&self) -> bool {
        let (three, four) = (Integer::from(3), Integer::from(4));
        // Horner's rule in z² = −25, separately for the even and the odd powers of z.
        let mut sums = [Integer::ZERO, Integer::ZERO];
        for (j, row) in self.rows.iter().enumerate().rev() {
            let sum = &mut sums[j % 2];
            *sum *= Integer::from(-25);
            if !row.is_zero() {
                *sum += row.evaluate(&three, &four);
            }
        }
        sums.iter().all(|sum| *sum == 0)
    }

    /// The largest e such that `(x² + y² + z²)^e` divides f, and the quotient; `None` for the zero form.
    pub(crate) fn strip_rho(&self) -> Option<(usize, Self)> {
        if self.is_zero() {
            return None;
        }
        let (mut power, mut rest) = (0, self.clone());
        while let Some(quotient) = rest.divided_by_rho() {
            rest = quotient;
            power += 1;
        }
        Some((power, rest))
    }

    /// The value `f(u, v, w)`. Cost: the evaluation of d + 1 binary forms.
    pub(crate) fn evaluate(&self, [u, v, w]: &[Integer; 3]) -> Integer {
        let rows = self.rows.iter().rev();
        rows.fold(Integer::ZERO, |value, row| {
            let here = if row.is_zero() {
                Integer::ZERO
            } else {
                row.evaluate(u, v)
            };
            value * w + here
        })
    }

    /// The form on the plane through the z axis and (a, b, 0), where a² + b² = c²: the binary form `c^d f(aY/c, bY/c, X)` in
    /// (X, Y) = (cos φ, sin φ).
    pub(crate) fn on_meridian(&self, a: &Integer, b: &Integer, c: &Integer) -> BinaryForm {
        let terms: Vec<_> = self.terms().collect();
        on_meridian(self.degree(), &terms, [a, b, c])
    }

    fn assert_same_degree(&self, other: &Self) {
        assert_eq!(
            self.degree(),
            other.degree(),
            "forms of one degree are added"
        );
    }
}

/// The terms ([i, j, k], c) in descending lexicographic order of their exponents, from the terms (j, c) of every power of z,
/// ascending in k.
fn in_canonical_order<C>(
    degree: usize,
    rows: impl Iterator<Item = impl Iterator<Item = (usize, C)>>,
) -> impl Iterator<Item = ([usize; 3], C)> {
    // For one power of x the exponents of y descend while those of z ascend.
    let mut columns: Vec<Vec<([usize; 3], C)>> = Vec::new();
    columns.resize_with(degree + 1, Vec::new);
    for (k, row) in rows.enumerate() {
        for (j, c) in row {
            let i = degree - k - j;
            columns[i].push(([i, j, k], c));
        }
    }
    columns.into_iter().rev().flatten()
}

impl From<&TernaryForm> for SparsePolynomial<3> {
    fn from(form: &TernaryForm) -> Self {
        let exponent = |e: usize| u32::try_from(e).invariant("degrees are below 2^32");
        let terms = form.terms();
        Self::from_terms(terms.map(|(e, c)| (e.map(exponent), Rational::whole(c))))
    }
}

impl Ring for TernaryForm {
    fn plus(&self, other: &Self) -> Self {
        self.assert_same_degree(other);
        let pairs = self.rows.iter().zip(&other.rows);
        Self {
            rows: pairs.map(|(a, b)| a.plus(b)).collect(),
        }
    }

    fn minus(&self, other: &Self) -> Self {
        self.assert_same_degree(other);
        let pairs = self.rows.iter().zip(&other.rows);
        Self {
            rows: pairs.map(|(a, b)| a.minus(b)).collect(),
        }
    }

    fn times(&self, other: &Self) -> Self {
        let mut product = Self::zero(self.degree() + other.degree());
        for (j, a) in self.rows.iter().enumerate().filter(|(_, a)| !a.is_zero()) {
            for (k, b) in other.rows.iter().enumerate().filter(|(_, b)| !b.is_zero()) {
                let sum = product.rows[j + k].plus(&a.times(b));
                product.rows[j + k] = sum;
            }
        }
        product
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::poly::SparsePolynomial;
    use proptest::prelude::*;

    fn form(degree: usize) -> impl Strategy<Value = TernaryForm> {
        let all: Vec<[usize; 3]> = (0..=degree)
            .flat_map(|i| (0..=degree - i).map(move |j| [i, j, degree - i - j]))
            .collect();
        prop::collection::vec(-9i64..10, all.len()).prop_map(move |values| {
            let values = values.into_iter().map(Integer::from);
            TernaryForm::from_terms(degree, all.iter().copied().zip(values))
        })
    }

    fn sparse(f: &TernaryForm) -> SparsePolynomial<3> {
        let narrow = |e: [usize; 3]| e.map(|k| u32::try_from(k).unwrap());
        SparsePolynomial::from_terms(f.terms().map(|(e, c)| (narrow(e), Rational::whole(c))))
    }

    proptest! {
        /// Products, sums and values agree with those of sparse polynomials.
        #[test]
        fn forms_agree_with_sparse_polynomials(f in form(3), g in form(2), h in form(3), at in prop::array::uniform3(-9i64..10)) {
            prop_assert_eq!(sparse(&f.times(&g)), sparse(&f).times(&sparse(&g)));
            prop_assert_eq!(f.squared_densely(), f.times(&f));
            let root = f.squared_densely().square_root();
            prop_assert!(root.as_ref() == Some(&f) || root == Some(f.scaled(&Integer::from(-1))));
            prop_assert!(f.is_zero() || g.is_zero() || f.times(&f).times_rho_power(1).square_root().is_none());
            let powers = std::iter::successors(Some(g.clone()), |g| Some(g.times(&TernaryForm::rho())));
            for (power, product) in powers.enumerate().take(4) {
                prop_assert_eq!(g.clone().times_rho_power(power), product);
            }
            prop_assert_eq!(sparse(&f.plus(&h)), sparse(&f).plus(&sparse(&h)));
            prop_assert_eq!(sparse(&f.minus(&h)), sparse(&f).minus(&sparse(&h)));
            let value = sparse(&f).evaluate(&at.map(Rational::from));
            prop_assert_eq!(Rational::whole(f.evaluate(&at.map(Integer::from))), value);
        }

        /// All powers of x² + y² + z² are divided out exactly.
        #[test]
        fn powers_of_the_squared_length_come_off(f in form(3), e in 0usize..4) {
            prop_assume!(f.divided_by_rho().is_none());
            let product = (0..e).fold(f.clone(), |g, _| g.times(&TernaryForm::rho()));
            prop_assert_eq!(product.strip_rho(), Some((e, f)));
        }

        /// On a meridian a form is a binary form with the same values.
        #[test]
        fn a_meridian_has_the_values_of_the_form(f in form(4), x in -9i64..10, y in -9i64..10) {
            let on_meridian = f.on_meridian(&3.into(), &4.into(), &5.into());
            let value = f.evaluate(&[3 * y, 4 * y, 5 * x].map(Integer::from));
            prop_assert_eq!(on_meridian.evaluate(&x.into(), &y.into()), value);
        }
    }
}
