//! Points of parametric forms for drawing: doubles without certificate.

use super::{Parameter, ParametricCurve, Patch, PatchFunction};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, RationalFunction, SparsePolynomial};
use crate::roots::real_roots;

/// The range of a parameter that is a number. A picture shows at least this part of a curve that goes to infinity, and exactly
/// this part of a patch.
pub(crate) const DRAWN_NUMBERS: [f64; 2] = [-1.5, 1.5];

/// A value of s as the ratio of two doubles, so that s may be infinite.
type Ratio = [f64; 2];

impl Parameter {
    /// `count + 1` values of s over the given range. Without a range they cover a full period of an angle, or all numbers
    /// except infinity.
    fn values(&self, range: Option<[f64; 2]>, count: u32) -> Vec<Ratio> {
        let part = |k: u32| f64::from(k) / f64::from(count);
        let between = |[a, b]: [f64; 2], k: u32| a + (b - a) * part(k);
        match (self.step(), range) {
            (Some(step), range) => {
                let step = step.to_f64();
                let range = range.unwrap_or([0.0, std::f64::consts::TAU / step]);
                (0..=count)
                    .map(|k| {
                        let (sin, cos) = (between(range, k) * step / 2.0).sin_cos();
                        [sin, cos]
                    })
                    .collect()
            }
            (None, None) => {
                // The tangent takes all numbers; its infinite ends are left out.
                let right = std::f64::consts::FRAC_PI_2;
                (0..=count)
                    .map(|k| {
                        let angle = between([-right, right], k) * (1.0 - 1e-9);
                        let (sin, cos) = angle.sin_cos();
                        [sin, cos]
                    })
                    .collect()
            }
            (None, Some(range)) => (0..=count).map(|k| [between(range, k), 1.0]).collect(),
        }
    }
}

impl<const N: usize> ParametricCurve<N> {
    /// Lines of points along the curve, about `count` points in all, over the range of the parameter. A line ends at a pole.
    ///
    /// Without a range the lines cover a full period of an angle, or all numbers.
    #[must_use]
    pub fn polylines(&self, range: Option<[f64; 2]>, count: u32) -> Vec<Vec<[f64; N]>> {
        let values = self.parameter().values(range, count.max(1));
        let curve = self.in_doubles();
        let mut lines: Vec<Vec<[f64; N]>> = vec![Vec::new()];
        let mut signs: Option<[bool; N]> = None;
        for s in values {
            let forms = curve.forms(s);
            let point = forms.map(|[p, q]| p / q);
            let now = forms.map(|[_, q]| q > 0.0);
            // At a pole the denominator changes its sign.
            let jumps = signs.is_some_and(|before| before != now);
            if jumps && !self.is_bounded() {
                lines.push(Vec::new());
            }
            signs = Some(now);
            if point.iter().all(|v| v.is_finite())
                && let Some(line) = lines.last_mut()
            {
                line.push(point);
            }
        }
        lines.retain(|line| line.len() > 1);
        lines
    }

    /// A box that shows the curve. If the curve is bounded, the box holds all of it; if not, the box holds most of its points
    /// for parameters in the range, or between −3/2 and 3/2. `None` if no point is finite.
    #[must_use]
    pub fn extent(&self, range: Option<[f64; 2]>) -> Option<[[f64; 2]; N]> {
        const POINTS: u32 = 720;
        let bounded = self.is_bounded();
        let range = if self.parameter().is_angle() || bounded {
            range
        } else {
            range.or(Some(DRAWN_NUMBERS))
        };
        let lines = self.polylines(range, POINTS);
        // Near poles the curve goes to infinity; then the largest and smallest values are left out.
        let has_poles = !bounded && lines.len() > 1;
        box_around(&lines.concat(), if has_poles { 0.05 } else { 0.0 })
    }

    /// Whether no coordinate has a real pole or a pole at infinity; this is decided exactly.
    #[must_use]
    pub fn is_bounded(&self) -> bool {
        self.coordinates().iter().all(|f| {
            let degree = |p: &IntegerPolynomial| p.coefficients_asc().len();
            degree(f.numerator()) <= degree(f.denominator())
                && real_roots(f.denominator()).is_empty()
        })
    }
}

/// The box around points. In each coordinate the given share of the smallest and of the largest values is left out, and the
/// range of the others is made half as large again.
fn box_around<const N: usize>(points: &[[f64; N]], left_out: f64) -> Option<[[f64; 2]; N]> {
    let last = points.len().checked_sub(1)?;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "a share of a number of points"
    )]
    let skipped = (left_out * last as f64) as usize;
    let mut bounds = [[0.0; 2]; N];
    for (k, side) in bounds.iter_mut().enumerate() {
        let mut values: Vec<f64> = points.iter().map(|p| p[k]).collect();
        values.sort_unstable_by(f64::total_cmp);
        let (low, high) = (values[skipped], values[last - skipped]);
        let more = if skipped > 0 { (high - low) / 4.0 } else { 0.0 };
        *side = [low - more, high + more];
    }
    Some(bounds)
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

impl Patch {
    /// The points of the surface on a grid of parameters, with a row for each value of the first parameter; `None` at poles.
    ///
    /// Without ranges the grid covers a full period of an angle, and −3/2 to 3/2 for a number.
    #[must_use]
    pub fn grid(
        &self,
        ranges: [Option<[f64; 2]>; 2],
        counts: [u32; 2],
    ) -> Vec<Vec<Option<[f64; 3]>>> {
        let [first, second] = [0, 1].map(|k| {
            let parameter = &self.parameters()[k];
            let range = if parameter.is_angle() {
                ranges[k]
            } else {
                ranges[k].or(Some(DRAWN_NUMBERS))
            };
            parameter.values(range, counts[k].max(1))
        });
        let patch = self.in_doubles();
        let point = |at: [Ratio; 2]| patch.at(at);
        let row = |s: &Ratio| second.iter().map(|t| point([*s, *t])).collect();
        first.iter().map(row).collect()
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::PlaneCurve;
    use std::str::FromStr;

    fn function(p: &str, q: &str) -> RationalFunction {
        let polynomial = |text: &str| IntegerPolynomial::from_str(text).unwrap();
        RationalFunction::from_integers(polynomial(p), polynomial(q)).unwrap()
    }

    #[test]
    fn a_circle_is_closed_and_a_hyperbola_has_two_arms() {
        let circle = [function("-x^2+1", "x^2+1"), function("2*x", "x^2+1")];
        let circle = PlaneCurve::new(Parameter::angle("t", Rational::one()), circle);
        let lines = circle.polylines(None, 100);
        assert_eq!(lines.len(), 1);
        assert!(
            lines[0]
                .iter()
                .all(|[x, y]| (x * x + y * y - 1.0).abs() < 1e-12)
        );
        let (first, last) = (lines[0][0], lines[0][100]);
        assert!((first[0] - last[0]).hypot(first[1] - last[1]) < 1e-12);

        let hyperbola = [function("x", "1"), function("1", "x")];
        let hyperbola = PlaneCurve::new(Parameter::number("t"), hyperbola);
        assert!(!hyperbola.is_bounded());
        let lines = hyperbola.polylines(None, 101);
        assert_eq!(lines.len(), 2);
        // The box shows the middle of the hyperbola, not the parts that go to infinity.
        let [x, y] = hyperbola.extent(None).unwrap();
        assert!(x[1] < 3.0 && y[1] < 40.0, "{x:?} {y:?}");
    }
}
