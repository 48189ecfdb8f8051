//! The coordinates of a parametric curve for drawing: in doubles where these have enough digits, else from exact values.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::logic::traits::SignificantBits;

use super::ParametricCurve;
use super::drawn::Ratio;
use crate::error::Invariant;
use crate::exact::{Dyadic, Rational};
use crate::poly::{
    BinaryForm, IntegerPolynomial, RationalFunction, integer_sign, numerator_at, scaled_harmonics,
};

/// Values in doubles are taken if their error is at most this share of them.
const SMALL: f64 = 1.0 / (1 << 24) as f64;

/// Harmonics in doubles are taken if their error is at most this share of the sum of all amplitudes.
const SMALL_IN_HARMONICS: f64 = 1.0 / (1 << 30) as f64;

/// Sums of magnitudes that are smaller than this are not evaluated in doubles.
const TINY: f64 = 1e-280;

/// The coordinates of a curve, to be evaluated many times.
#[derive(Debug)]
pub(super) struct CurveValues<const N: usize> {
    coordinates: [Coordinate; N],
}

/// A value for drawing.
#[derive(Clone, Copy, Debug)]
pub(super) struct Value {
    /// The coordinate; it is not finite at a pole.
    pub(super) value: f64,
    /// Whether the denominator is positive. At a pole of odd order this changes.
    pub(super) is_above: bool,
}

/// A numerator and a denominator as forms of one degree in (a, b), where s = a/b.
#[derive(Debug)]
struct Coordinate {
    exact: [IntegerPolynomial; 2],
    degree: usize,
    forms: [Form; 2],
}

/// A form in doubles times 2^`exponent`, so that the largest double is about 1.
#[derive(Debug)]
struct Form {
    exponent: i32,
    basis: Basis,
}

#[derive(Debug)]
enum Basis {
    /// The coefficients, ascending in s, and whether none of them is so much smaller than the largest that it loses digits.
    Coefficients { values: Vec<f64>, is_plain: bool },
    /// The harmonics (m, cosine, sine) of the angle h with s = tan h. The sum of the amplitudes is `size`.
    Harmonics {
        waves: Vec<(usize, f64, f64)>,
        size: f64,
    },
}

/// A value in doubles, and a bound of its error.
struct Near {
    value: f64,
    error: f64,
    /// An error that is smaller than this does not matter, however small the value is.
    negligible: f64,
}

impl<const N: usize> CurveValues<N> {
    pub(super) fn of(curve: &ParametricCurve<N>) -> Self {
        let parts = |f: &RationalFunction| [f.numerator().clone(), f.denominator().clone()];
        Self::of_quotients(
            curve.parameter().is_angle(),
            curve
                .coordinates()
                .each_ref()
                .map(|f| (parts(f), f.degree())),
        )
    }

    /// The values of numerators and denominators of at most the given degrees.
    pub(super) fn of_quotients(
        is_angle: bool,
        coordinates: [([IntegerPolynomial; 2], usize); N],
    ) -> Self {
        Self {
            coordinates: coordinates
                .map(|(parts, degree)| Coordinate::new(parts, degree, is_angle)),
        }
    }

    /// The coordinates at s = a/b. For an angle, (a, b) is a unit vector.
    pub(super) fn at(&self, s: Ratio) -> [Value; N] {
        self.coordinates.each_ref().map(|c| c.at(s))
    }
}

impl Coordinate {
    fn new(exact: [IntegerPolynomial; 2], degree: usize, is_angle: bool) -> Self {
        let form = |p: &IntegerPolynomial| {
            if is_angle {
                Form::harmonics(p, degree)
            } else {
                Form::coefficients(p)
            }
        };
        Self {
            forms: exact.each_ref().map(form),
            exact,
            degree,
        }
    }

    fn at(&self, s: Ratio) -> Value {
        let [above, below] = self.forms.each_ref().map(|form| form.at(s, self.degree));
        let is_good = |near: &Near, negligible: f64| {
            near.value.is_finite()
                && (near.error <= near.value.abs() * SMALL || near.error <= negligible)
        };
        if is_good(&above, above.negligible) && is_good(&below, 0.0) {
            let scale = self.forms[0].exponent - self.forms[1].exponent;
            return Value {
                value: times_power_of_two(above.value / below.value, scale),
                is_above: below.value > 0.0,
            };
        }
        self.exactly_at(s)
    }

    /// The coordinate from exact values of the numerator and the denominator.
    fn exactly_at(&self, [a, b]: Ratio) -> Value {
        let [above, below] = &self.exact;
        let is_turned = b < 0.0 && !self.degree.is_multiple_of(2);
        let Some(s) = Dyadic::from_f64(a / b) else {
            // s is infinite.
            let leading = |f: &IntegerPolynomial| f.coefficients_asc().get(self.degree).cloned();
            let [p, q] = [above, below].map(|f| leading(f).unwrap_or_default());
            return Value {
                value: quotient(&p, &q),
                is_above: (integer_sign(&q) > 0) != is_turned,
            };
        };
        let [p, q] = [above, below].map(|f| numerator_at(f, &s));
        let degree = |f: &IntegerPolynomial| f.coefficients_asc().len().saturating_sub(1);
        // The value of a polynomial of degree d has been multiplied by 2^(d·shift).
        let shift = s.exponent().min(0).unsigned_abs();
        let lifted = |value, f| value << (shift * (self.degree - degree(f)) as u64);
        Value {
            is_above: (integer_sign(&q) > 0) != is_turned,
            value: quotient(&lifted(p, above), &lifted(q, below)),
        }
    }
}

/// About p/q; not finite for q = 0.
fn quotient(p: &Integer, q: &Integer) -> f64 {
    let ((p, p_exponent), (q, q_exponent)) = (first_bits(p), first_bits(q));
    times_power_of_two(p / q, p_exponent - q_exponent)
}

/// The first 64 bits of an integer, times a power of two.
fn first_bits(value: &Integer) -> (f64, i32) {
    let dropped = value.significant_bits().saturating_sub(64);
    let kept = Rational::whole(&(value >> dropped)).to_f64();
    let dropped = i32::try_from(dropped).invariant("a number has less than 2^31 bits");
    (kept, dropped)
}

/// x · 2^k, in two steps because 2^k may be no double where the product is.
fn times_power_of_two(x: f64, k: i32) -> f64 {
    let half = k / 2;
    x * 2f64.powi(half) * 2f64.powi(k - half)
}

/// The number of bits of the largest of some integers, and each of them divided by 2 to this number.
fn scaled<'a>(all: impl Iterator<Item = &'a Integer> + Clone) -> (i32, impl Iterator<Item = f64>) {
    let bits = all.clone().map(SignificantBits::significant_bits).max();
    let bits = i32::try_from(bits.unwrap_or(0)).invariant("a number has less than 2^31 bits");
    let values = all.map(move |c| {
        let (kept, exponent) = first_bits(c);
        times_power_of_two(kept, exponent - bits)
    });
    (bits, values)
}

impl Form {
    fn coefficients(f: &IntegerPolynomial) -> Self {
        let coefficients = f.coefficients_asc();
        let (exponent, values) = scaled(coefficients.iter());
        let values: Vec<_> = values.collect();
        let mut both = coefficients.iter().zip(&values);
        let is_plain = both.all(|(exact, near)| *exact == 0 || near.abs() > TINY);
        Self {
            exponent,
            basis: Basis::Coefficients { values, is_plain },
        }
    }

    fn harmonics(f: &IntegerPolynomial, degree: usize) -> Self {
        if *f == IntegerPolynomial::ZERO {
            return Self::coefficients(f);
        }
        // The first variable is cos h.
        let form = BinaryForm::from_dehomogenized(degree, f.clone());
        let harmonics = scaled_harmonics(&form);
        let (bits, values) = scaled(harmonics.iter().flat_map(|(_, cos, sin)| [cos, sin]));
        let values: Vec<_> = values.collect();
        let waves = harmonics.iter().zip(values.chunks_exact(2));
        let degree = i32::try_from(degree).invariant("degrees are below 2^31");
        Self {
            exponent: bits - degree,
            basis: Basis::Harmonics {
                waves: waves.map(|((m, ..), v)| (*m, v[0], v[1])).collect(),
                size: values.iter().map(|v| v.abs()).sum(),
            },
        }
    }

    fn at(&self, [a, b]: Ratio, degree: usize) -> Near {
        match &self.basis {
            Basis::Coefficients { values, is_plain } => {
                let (mut value, mut size, mut power) = (0.0, 0.0, 1.0);
                let mut smallest_power = 1.0;
                for k in (0..=degree).rev() {
                    smallest_power = f64::abs(power);
                    let term = values.get(k).unwrap_or(&0.0) * power;
                    value = value * a + term;
                    size = size * a.abs() + term.abs();
                    power *= b;
                }
                let is_plain =
                    values.is_empty() || *is_plain && size > TINY && smallest_power > TINY;
                Near {
                    value,
                    error: rounding(size, degree, is_plain),
                    negligible: 0.0,
                }
            }
            Basis::Harmonics { waves, size } => {
                // (cos mh, sin mh) for the m of one parity
                let turn = [b * b - a * a, 2.0 * a * b];
                let mut wave = if degree.is_multiple_of(2) {
                    [1.0, 0.0]
                } else {
                    [b, a]
                };
                let mut value = 0.0;
                for (_, cos, sin) in waves {
                    value += cos * wave[0] + sin * wave[1];
                    wave = [
                        wave[0] * turn[0] - wave[1] * turn[1],
                        wave[0] * turn[1] + wave[1] * turn[0],
                    ];
                }
                Near {
                    value,
                    error: rounding(*size, degree, *size > TINY),
                    negligible: size * SMALL_IN_HARMONICS,
                }
            }
        }
    }
}

/// A bound of the rounding errors of a sum of magnitude `size` with a number of terms that belongs to the degree. With numbers near the
/// ends of the doubles, which are not `plain`, rounding is no small share of them.
fn rounding(size: f64, degree: usize, is_plain: bool) -> f64 {
    if !is_plain {
        return f64::INFINITY;
    }
    let degree = u32::try_from(degree).invariant("the degrees of a form are below 2^32");
    size * 8.0 * (f64::from(degree) + 4.0) * f64::EPSILON
}
