//! [`FourierRadius`]: a curve that is given by a finite Fourier series of its radius.

use malachite::base::num::arithmetic::traits::{DivExact, IsPowerOf2, LcmAssign};
use malachite::base::num::basic::traits::One;
use malachite::{Integer, Natural};

use super::{Parameter, PlaneCurve};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{BinaryForm, RationalFunction, Ring, doubled_form_from_harmonics};

/// The radius `r(θ) = a0 + Σ_{n=1..N} (a_n cos nθ + b_n sin nθ)` with exact rational coefficients
/// (Lemma 1), and the center, from which the radius is measured.
///
/// `N` is the *true* number of harmonics: trailing pairs that are zero are dropped on construction.
///
/// ```
/// use stellate::exact::Rational;
/// use stellate::shape::FourierRadius;
///
/// let zero = || Rational::from(0);
/// let r = FourierRadius::new(vec![1.into(), zero(), zero()], vec![zero(), 2.into(), zero()]);
/// assert_eq!(r.harmonics(), 1);
/// assert_eq!(r.sin(1), &Rational::from(2));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FourierRadius {
    cos: Vec<Rational>,
    sin: Vec<Rational>,
    center: [Rational; 2],
}

impl FourierRadius {
    /// The radius with `cos = [a0, a1, …]` and `sin = [ignored, b1, …]`; the shorter list is padded with zeros.
    #[must_use]
    pub fn new(mut cos: Vec<Rational>, mut sin: Vec<Rational>) -> Self {
        let len = cos.len().max(sin.len()).max(1);
        cos.resize(len, Rational::zero());
        sin.resize(len, Rational::zero());
        sin[0] = Rational::zero();
        while cos.len() > 1
            && cos.last().is_some_and(Rational::is_zero)
            && sin.last().is_some_and(Rational::is_zero)
        {
            cos.pop();
            sin.pop();
        }
        Self {
            cos,
            sin,
            center: [Rational::zero(), Rational::zero()],
        }
    }

    /// The same radius measured from `center`.
    #[must_use]
    pub fn with_center(mut self, center: [Rational; 2]) -> Self {
        self.center = center;
        self
    }

    /// The center, in the contour's coordinates.
    #[must_use]
    pub fn center(&self) -> &[Rational; 2] {
        &self.center
    }

    /// The number of harmonics N: the largest n with `a_n ≠ 0` or `b_n ≠ 0`, or 0 for a constant.
    #[must_use]
    pub fn harmonics(&self) -> usize {
        self.cos.len() - 1
    }

    /// The coefficient `a_n`, for n ≤ N.
    #[must_use]
    pub fn cos(&self, n: usize) -> &Rational {
        &self.cos[n]
    }

    /// The coefficient `b_n`, for n ≤ N; `b_0` is 0.
    #[must_use]
    pub fn sin(&self, n: usize) -> &Rational {
        &self.sin[n]
    }

    /// The coefficients `[a_0, …, a_N]`.
    #[must_use]
    pub fn cosines(&self) -> &[Rational] {
        &self.cos
    }

    /// The coefficients `[0, b_1, …, b_N]`.
    #[must_use]
    pub fn sines(&self) -> &[Rational] {
        &self.sin
    }

    /// The numbers (D, D·cosines, D·sines), where D is the least common denominator of all coefficients.
    #[doc(hidden)]
    #[must_use]
    pub fn over_common_denominator(&self) -> (Integer, Vec<Integer>, Vec<Integer>) {
        // D = 2^power · odd. If all coefficients are dyadic, no gcd is computed.
        let (mut power, mut odd) = (0, Natural::ONE);
        for q in self.cos.iter().chain(&self.sin) {
            let denominator = q.denominator_ref();
            power = power.max(factors_of_two(denominator));
            if !denominator.is_power_of_2() {
                let own = denominator >> factors_of_two(denominator);
                odd.lcm_assign(own);
            }
        }
        let common = Integer::from(&odd << power);
        let integer = |q: &Rational| {
            if odd == 1 {
                let own = factors_of_two(q.denominator_ref());
                return q.numerator() << (power - own);
            }
            q.numerator() * (&common).div_exact(q.denominator())
        };
        let cos = self.cos.iter().map(integer).collect();
        let sin = self.sin.iter().map(integer).collect();
        (common, cos, sin)
    }

    /// The curve (r cos θ, r sin θ) about its center, as a function of s = tan(θ/2):
    /// `r = Σ a_n Re (1+is)^(2n) (1+s²)^(N−n) + b_n Im … over (1+s²)^N`.
    #[must_use]
    pub fn to_plane_curve(&self) -> PlaneCurve {
        let n = self.harmonics();
        let (denominator, cos, sin) = self.over_common_denominator();
        // The harmonics of θ are the even harmonics of θ/2.
        let halves = (0..=n).map(|m| (2 * m, &cos[m], &sin[m]));
        let above = doubled_form_from_harmonics(2 * n, halves);
        let below = BinaryForm::rho_power(n + 1).scaled(&(denominator << 1u64));
        let turn = |c: [i64; 3]| {
            let c = c.iter().map(|&c| Integer::from(c)).collect();
            let factor = BinaryForm::from_coefficients(c).times(&above);
            let (p, q) = (factor.dehomogenized(), below.dehomogenized());
            RationalFunction::from_integers(p.clone(), q.clone())
                .invariant("a power of 1 + s^2 is not 0")
        };
        let parameter = Parameter::angle("t", Rational::one());
        // cos θ = (1 − s²)/(1 + s²), sin θ = 2s/(1 + s²)
        PlaneCurve::new(parameter, [turn([1, 0, -1]), turn([0, 2, 0])])
    }

    /// The series as a function of s = tan(θ/2).
    pub(crate) fn to_function(&self) -> RationalFunction {
        let n = self.harmonics();
        let (denominator, cos, sin) = self.over_common_denominator();
        let halves = (0..=n).map(|m| (2 * m, &cos[m], &sin[m]));
        let above = doubled_form_from_harmonics(2 * n, halves);
        let below = BinaryForm::rho_power(n).scaled(&(denominator << 1u64));
        RationalFunction::from_integers(
            above.dehomogenized().clone(),
            below.dehomogenized().clone(),
        )
        .invariant("a power of 1 + s^2 is not 0")
    }

    /// Whether r is identically 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.cos.len() == 1 && self.cos[0].is_zero()
    }
}

/// The series Σ (a_n cos nt + b_n sin nt) as a function of s = tan(t/2).
pub(super) fn series_as_function(cos: &[Rational], sin: &[Rational]) -> RationalFunction {
    FourierRadius::new(cos.to_vec(), sin.to_vec()).to_function()
}

/// Values for drawing: doubles without certificate.
impl FourierRadius {
    /// About `count` points (x, y) of the curve for drawing, closed, in the contour's own coordinates. Where r < 0 the point
    /// r(θ)(cos θ, sin θ) is on the opposite side of the center.
    ///
    /// The series is summed in doubles; the error is about N·10⁻¹⁶ of the size.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "a count of points is small")]
    pub fn polyline(&self, count: usize) -> Vec<[f64; 2]> {
        let [cx, cy] = self.center.each_ref().map(Rational::to_f64);
        let (cos, sin) = self.to_doubles();
        let count = count.max(3);
        (0..=count)
            .map(|k| {
                let theta = std::f64::consts::TAU * ((k % count) as f64 / count as f64);
                let radius = series(&cos, &sin, theta);
                [cx + radius * theta.cos(), cy + radius * theta.sin()]
            })
            .collect()
    }

    /// The radius r(θ) in doubles, as accurate as [`FourierRadius::polyline`].
    #[must_use]
    pub fn approximate(&self, theta: f64) -> f64 {
        let (cos, sin) = self.to_doubles();
        series(&cos, &sin, theta)
    }

    /// The coefficients of the cosines and the sines, in doubles.
    pub(crate) fn to_doubles(&self) -> (Vec<f64>, Vec<f64>) {
        let doubles = |v: &[Rational]| v.iter().map(Rational::to_f64).collect();
        (doubles(&self.cos), doubles(&self.sin))
    }
}

/// a0 + Σ a_n cos nθ + b_n sin nθ
#[expect(
    clippy::cast_precision_loss,
    reason = "the number of harmonics is small"
)]
pub(crate) fn series(cos: &[f64], sin: &[f64], theta: f64) -> f64 {
    let terms = cos.iter().zip(sin).enumerate().map(|(n, (a, b))| {
        let (s, c) = (n as f64 * theta).sin_cos();
        a * c + b * s
    });
    terms.sum()
}

/// The number of times that a denominator can be halved.
fn factors_of_two(denominator: &Natural) -> u64 {
    denominator
        .trailing_zeros()
        .invariant("a denominator is not 0")
}
