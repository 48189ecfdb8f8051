//! A polynomial as a function of doubles: exact signs, Taylor bounds over boxes, certified crossings.

mod bounds;
mod crossing;

pub(crate) use bounds::Verdict;
pub(crate) use crossing::Crossing;

use crate::exact::Rational;
use crate::poly::SparsePolynomial;

/// Half of the distance from 1 to the next double.
const UNIT: f64 = 1.11e-16;
/// Below this products may lose digits to underflow.
const TINY: f64 = 1e-280;

/// f, with its coefficients also as doubles, scaled so that the largest is 1.
pub(crate) struct Field {
    exact: SparsePolynomial<3>,
    terms: Vec<([usize; 3], f64)>,
    /// In each variable.
    degrees: [usize; 3],
    /// A relative error bound of a sum of terms in doubles.
    relative: f64,
}

#[expect(
    clippy::cast_precision_loss,
    reason = "degrees and numbers of terms are small"
)]
impl Field {
    pub(crate) fn new(f: &SparsePolynomial<3>) -> Self {
        let largest = f.terms().map(|(_, c)| c.abs()).max();
        let scale = largest.and_then(|c| c.recip()).unwrap_or_default();
        let exact = f.scaled(&scale);
        let terms: Vec<([usize; 3], f64)> = exact
            .terms()
            .map(|(e, c)| (e.map(|k| k as usize), c.to_f64()))
            .collect();
        let degrees = terms.iter().fold([0; 3], |d: [usize; 3], (e, _)| {
            std::array::from_fn(|i| d[i].max(e[i]))
        });
        // One rounding per coefficient, the powers, two products, one sum per term.
        let roundings = terms.len() + degrees.iter().sum::<usize>() + 8;
        Self {
            relative: 1.01 * UNIT * roundings as f64,
            exact,
            terms,
            degrees,
        }
    }

    fn powers(&self, p: [f64; 3]) -> [Vec<f64>; 3] {
        std::array::from_fn(|i| {
            let mut list = Vec::with_capacity(self.degrees[i] + 1);
            let mut power = 1.0;
            for _ in 0..=self.degrees[i] {
                list.push(power);
                power *= p[i];
            }
            list
        })
    }

    /// (f, Σ |term|) in doubles.
    fn sums(&self, p: [f64; 3]) -> (f64, f64) {
        let [x, y, z] = self.powers(p);
        self.terms
            .iter()
            .fold((0.0, 0.0), |(sum, size), ([i, j, k], c)| {
                let term = c * x[*i] * y[*j] * z[*k];
                (sum + term, size + term.abs())
            })
    }

    fn tiny(&self, p: [f64; 3]) -> f64 {
        let sizes = p.iter().zip(self.degrees);
        sizes.fold(TINY, |size, (x, d)| size * x.abs().max(1.0).powf(d as f64))
    }

    /// The exact sign of f at a point: by doubles with an error bound where that decides, else exactly.
    pub(crate) fn sign(&self, p: [f64; 3]) -> i8 {
        let (value, size) = self.sums(p);
        if value.abs() > size * self.relative + self.tiny(p) {
            return if value > 0.0 { 1 } else { -1 };
        }
        self.exact_value(p).signum()
    }

    /// f, exactly, at a point with finite coordinates.
    pub(crate) fn exact_value(&self, p: [f64; 3]) -> Rational {
        let exact = p.map(|x| Rational::try_from(x).unwrap_or_default());
        self.exact.evaluate(&exact)
    }

    /// f in doubles, with no bound of its error.
    pub(crate) fn value(&self, p: [f64; 3]) -> f64 {
        self.sums(p).0
    }

    /// The gradient in doubles, with no bound of its error.
    pub(crate) fn gradient(&self, p: [f64; 3]) -> [f64; 3] {
        let powers = self.powers(p);
        let mut gradient = [0.0; 3];
        for (e, c) in &self.terms {
            for axis in 0..3 {
                if e[axis] > 0 {
                    let factors = (0..3).map(|i| {
                        if i == axis {
                            e[i] as f64 * powers[i][e[i] - 1]
                        } else {
                            powers[i][e[i]]
                        }
                    });
                    gradient[axis] += c * factors.product::<f64>();
                }
            }
        }
        gradient
    }
}

pub(crate) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}

/// a + t (b − a)
pub(crate) fn between(a: [f64; 3], b: [f64; 3], t: f64) -> [f64; 3] {
    std::array::from_fn(|i| a[i] + t * (b[i] - a[i]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::poly::Ring;

    #[test]
    fn signs_are_exact_where_doubles_vanish() {
        // (x − y)² − 2⁻¹⁰⁰ z² beside x = y
        let [x, y, z] = [0, 1, 2].map(SparsePolynomial::<3>::variable);
        let small = Rational::from(2).pow(-100).unwrap();
        let f = Field::new(&x.minus(&y).squared().minus(&z.squared().scaled(&small)));
        assert_eq!(f.sign([1.0, 1.0, 1.0]), -1);
        assert_eq!(f.sign([1.0, 1.0, 0.0]), 0);
        // (4·2⁻⁵²)² = 2⁻¹⁰⁰
        for (ulps, sign) in [(3.0, -1), (4.0, 0), (5.0, 1)] {
            assert_eq!(f.sign([1.0, 1.0 + ulps * f64::EPSILON, 1.0]), sign);
        }
    }
}
