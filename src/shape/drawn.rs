//! Values of parameters for drawing, and coordinates of parametric forms in doubles without certificate.

use super::{Parameter, ParametricCurve, Patch, PatchFunction};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, RationalFunction, SparsePolynomial};

/// The range of a parameter that is a number. A picture shows at least this part of a curve that goes to infinity, and exactly
/// this part of a patch.
pub(crate) const DRAWN_NUMBERS: [f64; 2] = [-1.5, 1.5];

/// A value of s as the ratio of two doubles, so that s may be infinite.
pub(super) type Ratio = [f64; 2];

impl Parameter {
    /// The largest magnitude of a number that is drawn; beyond are the infinite ends.
    pub(super) const LARGEST_NUMBER: f64 = 6e8;

    /// `count + 1` values over the given range. Without a range they cover a full period of an angle, or all numbers except
    /// the infinite ends.
    pub(super) fn values(&self, range: Option<[f64; 2]>, count: u32) -> Vec<f64> {
        let part = |k: u32| f64::from(k) / f64::from(count);
        let between = |[a, b]: [f64; 2], k: u32| a * (1.0 - part(k)) + b * part(k);
        match (self.step(), range) {
            (_, Some(range)) => (0..=count).map(|k| between(range, k)).collect(),
            (Some(step), None) => {
                let period = std::f64::consts::TAU / step.to_f64();
                (0..=count).map(|k| between([0.0, period], k)).collect()
            }
            (None, None) => {
                // The tangent takes all numbers.
                let right = Self::LARGEST_NUMBER.atan();
                (0..=count)
                    .map(|k| between([-right, right], k).tan())
                    .collect()
            }
        }
    }

    /// Whether the parameter takes this value of s in a range, up to rounding. Without a range it takes all values, a number only
    /// finite ones.
    pub(super) fn meets(&self, range: Option<[f64; 2]>, [above, below]: Ratio) -> bool {
        match (self.step(), range) {
            (None, _) if below == 0.0 => false,
            (_, None) => true,
            (None, Some([low, high])) => low <= above / below && above / below <= high,
            (Some(step), Some([low, high])) => {
                let period = std::f64::consts::TAU / step.to_f64();
                let value = above.atan2(below) / std::f64::consts::PI * period;
                let next = value + ((low - value) / period).ceil() * period;
                next <= high
            }
        }
    }

    /// s for a value of the parameter, as a ratio: for an angle of the coordinates of a unit vector, for a number exactly and of
    /// numbers of which the larger is between 1/2 and 1.
    pub(super) fn ratio(&self, value: f64) -> Ratio {
        match self.step() {
            Some(step) => {
                let (sin, cos) = (value * step.to_f64() / 2.0).sin_cos();
                [sin, cos]
            }
            None => {
                if value.is_infinite() {
                    return [value.signum(), 0.0];
                }
                let mut ratio = [value, 1.0];
                while ratio[0].abs() > 1.0 {
                    ratio = ratio.map(|v| v / 2.0);
                }
                ratio
            }
        }
    }
}

/// The coordinates of a curve in doubles without certificate, as numerators and denominators in s.
#[derive(Debug)]
pub(crate) struct CurveInDoubles<const N: usize> {
    coordinates: [[Vec<f64>; 2]; N],
}

impl<const N: usize> ParametricCurve<N> {
    pub(crate) fn in_doubles(&self) -> CurveInDoubles<N> {
        let doubles = |f: &IntegerPolynomial| {
            let coefficients = f.coefficients_asc().iter();
            coefficients.map(|c| Rational::whole(c).to_f64()).collect()
        };
        let both = |f: &RationalFunction| [doubles(f.numerator()), doubles(f.denominator())];
        CurveInDoubles {
            coordinates: self.coordinates().each_ref().map(both),
        }
    }
}

impl<const N: usize> CurveInDoubles<N> {
    /// The point at s.
    pub(crate) fn at(&self, s: Ratio) -> [f64; N] {
        self.forms(s).map(|[p, q]| p / q)
    }

    /// The numerators and denominators at s = a/b, each pair as forms of the same degree.
    fn forms(&self, [a, b]: Ratio) -> [[f64; 2]; N] {
        self.coordinates.each_ref().map(|both| {
            let length = both[0].len().max(both[1].len());
            both.each_ref().map(|coefficients| {
                let (mut value, mut power) = (0.0, 1.0);
                for k in (0..length).rev() {
                    value = value * a + coefficients.get(k).unwrap_or(&0.0) * power;
                    power *= b;
                }
                value
            })
        })
    }
}

/// The coordinates of a patch in doubles without certificate.
#[derive(Debug)]
pub(crate) struct PatchInDoubles {
    functions: [[Doubles; 2]; 3],
}

impl Patch {
    pub(crate) fn in_doubles(&self) -> PatchInDoubles {
        PatchInDoubles {
            functions: self.coordinates().each_ref().map(Doubles::of),
        }
    }
}

impl PatchInDoubles {
    /// The point at (s1, s2); `None` at a pole.
    pub(crate) fn at(&self, s: [Ratio; 2]) -> Option<[f64; 3]> {
        let point = self.functions.each_ref().map(|[p, q]| p.at(s) / q.at(s));
        point.iter().all(|v| v.is_finite()).then_some(point)
    }
}

/// A polynomial with coefficients in doubles, as a form in each variable.
#[derive(Debug)]
struct Doubles {
    terms: Vec<([i32; 2], f64)>,
    degrees: [i32; 2],
}

impl Doubles {
    fn of(f: &PatchFunction) -> [Self; 2] {
        let exponent = |e: u32| i32::try_from(e).invariant("exponents are below 2^31");
        let degrees = [0, 1].map(|v| exponent(f.degree_in(v)));
        [f.numerator(), f.denominator()].map(|p: &SparsePolynomial<2>| Self {
            terms: p
                .terms()
                .map(|(e, c)| (e.map(exponent), c.to_f64()))
                .collect(),
            degrees,
        })
    }

    fn at(&self, s: [Ratio; 2]) -> f64 {
        let monomial = |e: &[i32; 2]| {
            let factor = |v: usize| s[v][0].powi(e[v]) * s[v][1].powi(self.degrees[v] - e[v]);
            factor(0) * factor(1)
        };
        self.terms.iter().map(|(e, c)| c * monomial(e)).sum()
    }
}
