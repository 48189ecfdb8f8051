//! Theorem 2 in doubles, computed by the same generic functions as the exact polynomial.

use crate::exact::Rational;
use crate::implicitize::{parity_sums, square_away};
use crate::poly::{PlanePolynomial, Ring, SparsePolynomial};
use crate::shape::FourierRadius;

/// A binary form in doubles: the k-th number is the coefficient of x^(d−k) y^k.
#[derive(Clone, Debug, PartialEq)]
struct FloatForm(Vec<f64>);

impl Ring for FloatForm {
    fn plus(&self, other: &Self) -> Self {
        Self(self.0.iter().zip(&other.0).map(|(a, b)| a + b).collect())
    }

    fn minus(&self, other: &Self) -> Self {
        Self(self.0.iter().zip(&other.0).map(|(a, b)| a - b).collect())
    }

    fn times(&self, other: &Self) -> Self {
        let mut product = vec![0.0; self.0.len() + other.0.len() - 1];
        for (i, a) in self.0.iter().enumerate() {
            for (j, b) in other.0.iter().enumerate() {
                product[i + j] += a * b;
            }
        }
        Self(product)
    }
}

impl FloatForm {
    /// (x² + y²)^power, by repeated products.
    fn rho_power(power: usize) -> Self {
        let rho = Self(vec![1.0, 0.0, 1.0]);
        (0..power).fold(Self(vec![1.0]), |form, _| form.times(&rho))
    }

    fn scaled(&self, factor: f64) -> Self {
        Self(self.0.iter().map(|c| c * factor).collect())
    }
}

/// The polynomial F of Theorem 2 for a Fourier radius, computed as in the paper, with doubles from end to end. It has at most
/// three homogeneous parts.
///
/// ```
/// use stellate::check::FloatTheorem2;
/// use stellate::shape::FourierRadius;
/// // r = 2: F = x² + y² − 4
/// let f = FloatTheorem2::new(&FourierRadius::new(vec![2.into()], vec![]));
/// assert_eq!((f.evaluate(1.0, 2.0), f.radii([1.0, 0.0])), (1.0, [-2.0, 2.0]));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct FloatTheorem2 {
    /// The parts (d, coefficients of x^d, x^(d−1) y, …), descending in the degree d.
    parts: Vec<(usize, Vec<f64>)>,
}

impl FloatTheorem2 {
    /// Rounds the coefficients of the radius to doubles and runs the paper's algorithm: K_n by Appendix A, the two sums by
    /// Horner's rule in x² + y², then Eq. (7) or (8).
    #[must_use]
    pub fn new(radius: &FourierRadius) -> Self {
        let n = radius.harmonics();
        let [mut re, mut im] = [FloatForm(vec![1.0]), FloatForm(vec![0.0])];
        let mut k = Vec::new();
        for m in 0..=n {
            let [a, b] = [radius.cos(m), radius.sin(m)].map(Rational::to_f64);
            k.push(re.scaled(a).plus(&im.scaled(b)));
            // (x + iy)^(m+1) = (re + i·im)(x + iy)
            let [x, y] = [FloatForm(vec![1.0, 0.0]), FloatForm(vec![0.0, 1.0])];
            let next = re.times(&x).minus(&im.times(&y));
            im = re.times(&y).plus(&im.times(&x));
            re = next;
        }
        let (odd, even) = parity_sums(&k, &FloatForm::rho_power(1));
        let unit = FloatForm(vec![1.0]);
        let parts = square_away(n, &unit, FloatForm::rho_power, odd.as_ref(), &even);
        let middle = parts.middle.map(|form| form.scaled(-1.0));
        let forms = [Some(parts.top), middle, Some(parts.low)];
        Self {
            parts: forms
                .into_iter()
                .flatten()
                .map(|form| (form.0.len() - 1, form.0))
                .collect(),
        }
    }

    /// The polynomial whose coefficients are exactly these doubles; `None` if one of them is not finite.
    #[must_use]
    pub fn polynomial(&self) -> Option<SparsePolynomial<3>> {
        let mut terms = Vec::new();
        for (degree, form) in &self.parts {
            for (k, c) in form.iter().enumerate() {
                let coefficient = Rational::try_from(*c).ok()?;
                terms.push(((degree - k, k), coefficient));
            }
        }
        let plane = PlanePolynomial::from_terms(terms);
        Some(SparsePolynomial::from(&plane))
    }

    /// The value F(x, y), computed in doubles as the sum of all monomials.
    #[must_use]
    pub fn evaluate(&self, x: f64, y: f64) -> f64 {
        self.parts.iter().map(|(_, form)| value(form, x, y)).sum()
    }

    /// The two roots r of the quadratic equation s r² + p r + q = 0 that F(rx, ry) = 0 becomes after division by a power of r,
    /// for a direction (x, y) = (cos θ, sin θ). The values s, p and q of the parts at (x, y) are sums of monomials. The
    /// quadratic formula is used in the form in which −p and the root of the discriminant have equal signs, so that digits
    /// cancel only in the discriminant. If the discriminant is negative, both roots are NaN.
    #[must_use]
    pub fn radii(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let top = self.parts.first().map_or(0, |(d, _)| *d);
        let mut values = [0.0; 3];
        for (degree, form) in &self.parts {
            values[(top - degree).min(2)] = value(form, x, y);
        }
        let [s, p, q] = values;
        let w = -(p + (p * p - 4.0 * s * q).sqrt().copysign(p)) / 2.0;
        [w / s, q / w]
    }
}

/// The value of a form at (x, y), computed monomial by monomial.
fn value(form: &[f64], x: f64, y: f64) -> f64 {
    // Powers are repeated products, which are the same on every machine; those of the standard library need not be.
    let powers = |base: f64| -> Vec<f64> {
        let next = |p: &f64| Some(p * base);
        std::iter::successors(Some(1.0), next)
            .take(form.len())
            .collect()
    };
    let (xs, ys) = (powers(x), powers(y));
    let terms = form.iter().zip(xs.iter().rev()).zip(&ys);
    terms.map(|((c, x), y)| c * x * y).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_integers_are_exact() {
        // For r = 1 + cos t, F = (ρ − x)² − ρ with ρ = x² + y².
        let radius = FourierRadius::new(vec![1.into(), 1.into()], vec![]);
        let f = FloatTheorem2::new(&radius);
        let exact = crate::implicitize::SquaredForm::new(&radius)
            .unwrap()
            .expand();
        assert_eq!(
            f.polynomial().unwrap(),
            SparsePolynomial::from(exact.polynomial())
        );
        let found = f.radii([1f64.cos(), 1f64.sin()]);
        let near = |r: f64| found.iter().any(|v| (v - r).abs() < 1e-15);
        assert!(near(1.0 + 1f64.cos()) && near(1f64.cos() - 1.0));
        assert!(f.evaluate(2.0, 0.0).abs() < 1e-15);
        assert!((f.evaluate(1.0, 1.0) - (1.0 - 2.0)).abs() < 1e-15);
    }
}
