//! Taylor expansions of trigonometric polynomials at complex angles, in doubles, with bounds of all errors.
//!
//! With z = e^(it), twice a coordinate is X(z) = Σ (C_k z^k + C̄_k z^(−k)) with C_k = a_k − i b_k, k ≤ N. It is expanded in ζ at z e^ζ:
//! X(z e^ζ) = Σ_j X_j ζ^j with X_j = Σ_k k^j/j! (C_k z^k + (−1)^j C̄_k z^(−k)).
//!
//! Lemma 1 (errors). Let S_j = Σ_k k^j/j! |C_k| (|z|^k + |z|^(−k)). The computed X_j differs from X_j at z, and for ||z| − 1| ≤
//! 2^(−50) also from X_j at z/|z|, by at most `relative_error(ROUNDINGS_OF_A_POWER·N + MORE_ROUNDINGS)` times S_j.
//! Proof. A complex product has an error of at most √5 units (Brent, Percival and Zimmermann 2007), 1/z one of at most 4. So z^k
//! has at most 3k, z^(−k) at most 7k units; moving z to z/|z| changes both by at most 8k units. The coefficient, its product, the
//! weight, its product and the sum count N + 20; the rest is for one [`Expansion::combination`].
//! Law: `expansions_hold_the_exact_values`.
//!
//! Lemma 2 (rest). For |ζ| ≤ ρ, Nρ ≤ 1, the terms after order J add up to at most e S_(J+1) ρ^(J+1), and their derivative to at
//! most (J+1) e S_(J+1) ρ^J.
//! Proof. Σ_(j>J) y^j/j! ≤ y^(J+1)/(J+1)! e^y, and Σ_(j>J) j y^(j−1)/j! ≤ y^J/J! e^y, for y = kρ ≤ 1.
//!
//! Bounds are computed by fewer than 2^20 operations on non-negative numbers; [`COVER`] covers their rounding.

use nalgebra::Complex;

use crate::exact::Rational;
use crate::intervals::interval::relative_error;

/// The order J of the expansions.
const ORDER: usize = 5;

/// A factor that covers the rounding of a bound.
pub(super) const COVER: f64 = 1.0 + 1.0 / 1_073_741_824.0;

const ROUNDINGS_OF_A_POWER: usize = 17;
const MORE_ROUNDINGS: usize = 40;

/// A number that is at least e.
const E_ABOVE: f64 = 2.719;

/// The absolute value. Where its square underflows, the bounds of the errors are far larger.
fn size(c: Complex<f64>) -> f64 {
    c.norm_sqr().sqrt()
}

/// Twice a trigonometric polynomial, scaled so that the largest coefficient of a wave is about 1.
#[derive(Debug)]
pub(super) struct Wave {
    /// The numbers C_k for k ≤ N.
    coefficients: Vec<Complex<f64>>,
    sizes: Vec<f64>,
    /// For each k, k^j/j! for j ≤ J + 1.
    weights: Vec<[f64; ORDER + 2]>,
    /// The error of a coefficient of an expansion, as a multiple of S_j.
    relative: f64,
}

impl Wave {
    /// The polynomial Σ (a_k cos kt + b_k sin kt), whose coefficients are at most about 1.
    #[expect(clippy::cast_precision_loss, reason = "the degree is small")]
    pub(super) fn new(cos: &[Rational], sin: &[Rational]) -> Self {
        let coefficients: Vec<Complex<f64>> = cos
            .iter()
            .zip(sin)
            .map(|(a, b)| Complex::new(a.to_f64(), -b.to_f64()))
            .collect();
        let weights = (0..coefficients.len()).map(|k| {
            let mut weights = [1.0; ORDER + 2];
            for j in 1..weights.len() {
                weights[j] = weights[j - 1] * k as f64 / j as f64;
            }
            weights
        });
        let degree = coefficients.len() - 1;
        Self {
            sizes: coefficients.iter().map(|c| c.norm()).collect(),
            weights: weights.collect(),
            relative: relative_error(ROUNDINGS_OF_A_POWER * degree + MORE_ROUNDINGS),
            coefficients,
        }
    }

    /// The degree N.
    pub(super) fn degree(&self) -> usize {
        self.coefficients.len() - 1
    }

    pub(super) fn coefficients(&self) -> &[Complex<f64>] {
        &self.coefficients
    }
}

/// The powers z^k, z^(−k), |z|^k + |z|^(−k) for k up to a degree.
#[derive(Debug)]
pub(super) struct Powers(Vec<(Complex<f64>, Complex<f64>, f64)>);

impl Powers {
    pub(super) fn new(z: Complex<f64>, degree: usize) -> Self {
        let inverse = z.conj() / z.norm_sqr();
        let (size, small) = (z.norm(), 1.0 / z.norm());
        let one = Complex::new(1.0, 0.0);
        let (mut up, mut down, mut sizes) = (one, one, [1.0, 1.0]);
        let mut powers = Vec::with_capacity(degree + 1);
        for _ in 0..=degree {
            powers.push((up, down, sizes[0] + sizes[1]));
            up *= z;
            down *= inverse;
            sizes = [sizes[0] * size, sizes[1] * small];
        }
        Self(powers)
    }
}

/// The expansion of X at a number z.
#[derive(Clone, Copy, Debug)]
pub(super) struct Expansion {
    terms: [Complex<f64>; ORDER + 1],
    /// Bounds of the errors of the terms.
    errors: [f64; ORDER + 1],
    /// e S_(J+1)
    rest: f64,
    /// e S_1, a bound of the derivative where Nρ ≤ 1.
    slope: f64,
    degree: f64,
}

impl Expansion {
    #[expect(clippy::cast_precision_loss, reason = "the degree is small")]
    pub(super) fn new(wave: &Wave, powers: &Powers) -> Self {
        let mut terms = [Complex::new(0.0, 0.0); ORDER + 1];
        let mut sums = [0.0; ORDER + 2];
        let all = wave.coefficients.iter().zip(&wave.sizes);
        for (((c, size), weights), (up, down, both)) in all.zip(&wave.weights).zip(&powers.0) {
            let (above, below) = (c * up, c.conj() * down);
            let parts = [above + below, above - below];
            for (j, term) in terms.iter_mut().enumerate() {
                *term += parts[j % 2] * weights[j];
            }
            let size = size * both;
            for (sum, weight) in sums.iter_mut().zip(weights) {
                *sum += size * weight;
            }
        }
        Self {
            terms,
            errors: std::array::from_fn(|j| wave.relative * sums[j] * COVER),
            rest: E_ABOVE * sums[ORDER + 1] * COVER,
            slope: E_ABOVE * sums[1] * COVER,
            degree: wave.degree() as f64,
        }
    }

    /// The expansion of α X + β Y, where X is this one and Y the other.
    pub(super) fn combination(&self, alpha: f64, other: &Self, beta: f64) -> Self {
        let sizes = [alpha.abs(), beta.abs()];
        let sum = |a: f64, b: f64| sizes[0] * a + sizes[1] * b;
        Self {
            terms: std::array::from_fn(|j| self.terms[j] * alpha + other.terms[j] * beta),
            errors: std::array::from_fn(|j| sum(self.errors[j], other.errors[j])),
            rest: sum(self.rest, other.rest),
            slope: sum(self.slope, other.slope),
            degree: self.degree.max(other.degree),
        }
    }

    /// The value X_0.
    pub(super) fn value(&self) -> Complex<f64> {
        self.terms[0]
    }

    /// A bound of the error of the value.
    pub(super) fn error(&self) -> f64 {
        self.errors[0]
    }

    /// The terms X_j with the bounds of their errors.
    #[cfg(test)]
    pub(super) fn errors_of_terms(&self) -> [(Complex<f64>, f64); ORDER + 1] {
        std::array::from_fn(|j| (self.terms[j], self.errors[j]))
    }

    /// The first derivative X_1.
    pub(super) fn derivative(&self) -> Complex<f64> {
        self.terms[1]
    }

    /// A bound of |X(z e^ζ) − X(z e^ζ′)|/|ζ − ζ′| for ζ and ζ′ within 1/N.
    pub(super) fn slope(&self) -> f64 {
        self.slope
    }

    /// Whether ζ may be as large as that in the other bounds.
    fn reaches(&self, radius: f64) -> bool {
        radius * self.degree * COVER <= 1.0
    }

    /// A bound of the terms of order 2 and more for |ζ| ≤ radius.
    fn bend(&self, radius: f64) -> f64 {
        if !self.reaches(radius) {
            return f64::INFINITY;
        }
        let mut sum = self.rest;
        for j in (2..=ORDER).rev() {
            sum = sum * radius + size(self.terms[j]) + self.errors[j];
        }
        sum * radius * radius * COVER
    }

    /// A bound of the Lipschitz constant of the terms of order 2 and more for |ζ| ≤ radius.
    #[expect(clippy::cast_precision_loss, reason = "an order is small")]
    fn bend_slope(&self, radius: f64) -> f64 {
        if !self.reaches(radius) {
            return f64::INFINITY;
        }
        let mut power = radius;
        let mut sum = 0.0;
        for j in 2..=ORDER {
            sum += j as f64 * (size(self.terms[j]) + self.errors[j]) * power;
            power *= radius;
        }
        (sum + (ORDER + 1) as f64 * self.rest * power) * COVER
    }

    /// Whether X is proved not to be real for any ζ with |Re ζ| ≤ outward and |Im ζ| ≤ around.
    pub(super) fn is_never_real(&self, around: f64, outward: f64) -> bool {
        let error = self.errors[1];
        let linear =
            (self.terms[1].re.abs() + error) * around + (self.terms[1].im.abs() + error) * outward;
        let radius = around.hypot(outward) * COVER;
        self.terms[0].im.abs() > (self.errors[0] + linear + self.bend(radius)) * COVER
    }

    /// Whether X is proved not to be real for any ζ of at most this radius with Re ζ ≠ 0, for an expansion at a number of absolute
    /// value 1.
    ///
    /// Lemma 3. With ζ = iw, X is Σ ξ_j w^j with real ξ_j = i^j X_j, so Im X/Im w is ξ_1 + Σ_(j>1) ξ_j Im(w^j)/Im(w), and
    /// |Im(w^j)| ≤ j ρ^(j−1) |Im w|.
    /// Proof. On the circle X is real; w^j − w̄^j is (w − w̄) times a sum of j products of j − 1 factors w or w̄.
    /// Law: `numbers_beside_the_circle_are_excluded_rightly`.
    pub(super) fn is_never_real_beside_circle(&self, radius: f64) -> bool {
        self.terms[1].im.abs() > (self.errors[1] + self.bend_slope(radius)) * COVER
    }

    /// Whether X is proved to differ by more than `error` from a value at all e^(iφ) z, |φ| ≤ around, for an expansion at a number
    /// of absolute value 1.
    pub(super) fn never_has(&self, value: f64, error: f64, around: f64) -> bool {
        let linear = (self.terms[1].im.abs() + self.errors[1]) * around;
        (self.terms[0].re - value).abs()
            > (error + self.errors[0] + linear + self.bend(around)) * COVER
    }
}

/// The two coordinates at a number z, and the inverse of the derivative of their imaginary parts: the combinations of both that
/// change with Im ζ alone and with Re ζ alone, up to errors and terms of higher order.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inverted {
    /// The combinations, times the determinant.
    combinations: [Expansion; 2],
    /// The factors of the two coordinates in them.
    factors: [[f64; 2]; 2],
    determinant: f64,
    /// Frobenius' norm of the inverse.
    pub(super) norm: f64,
}

impl Inverted {
    pub(super) fn new([x, y]: &[Expansion; 2]) -> Self {
        let (a, b) = (x.derivative(), y.derivative());
        let determinant = a.re * b.im - a.im * b.re;
        let squares = a.norm_sqr() + b.norm_sqr();
        let factors = [[b.im, -a.im], [-b.re, a.re]];
        Self {
            combinations: factors.map(|[alpha, beta]| x.combination(alpha, y, beta)),
            factors,
            determinant,
            norm: squares.sqrt() / determinant.abs() * COVER,
        }
    }

    /// Whether a combination proves that not both coordinates are real in a box, as in [`Expansion::is_never_real`].
    pub(super) fn is_never_real(&self, around: f64, outward: f64) -> bool {
        let mut both = self.combinations.iter();
        both.any(|c| c.is_never_real(around, outward))
    }

    /// Newton's step ζ.
    pub(super) fn step(&self) -> Complex<f64> {
        let [around, outward] = &self.combinations;
        -Complex::new(outward.terms[0].im, around.terms[0].im) / self.determinant
    }

    /// The step ζ for other imaginary parts.
    pub(super) fn step_for(&self, [x, y]: [f64; 2]) -> Complex<f64> {
        let [[a, b], [c, d]] = self.factors;
        -Complex::new(c * x + d * y, a * x + b * y) / self.determinant
    }

    /// A bound of |G(0)|, where G is the inverse of the derivative times the imaginary parts.
    pub(super) fn value(&self) -> f64 {
        let largest = |c: &Expansion| c.terms[0].im.abs() + c.errors[0];
        let [around, outward] = &self.combinations;
        largest(around).hypot(largest(outward)) / self.determinant.abs() * COVER
    }

    /// A bound of |G(ζ) − ζ − G(ζ′) + ζ′|/|ζ − ζ′| for |ζ|, |ζ′| ≤ radius, where ζ stands for the vector (Im ζ, Re ζ).
    pub(super) fn contraction(&self, radius: f64) -> f64 {
        let row = |c: &Expansion, [along, across]: [f64; 2]| {
            let error = c.errors[1];
            let linear = (along.abs() + error).hypot(across.abs() + error);
            linear + c.bend_slope(radius)
        };
        let [around, outward] = &self.combinations;
        // Im(c ζ) = Re c Im ζ + Im c Re ζ.
        let [c, d] = [around.terms[1], outward.terms[1]];
        let rows = [
            row(around, [c.re - self.determinant, c.im]),
            row(outward, [d.re, d.im - self.determinant]),
        ];
        rows[0].hypot(rows[1]) / self.determinant.abs() * COVER
    }
}
