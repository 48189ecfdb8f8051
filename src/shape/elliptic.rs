//! [`EllipticSeries`]: a closed curve that is given by finite Fourier series of its coordinates.

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Gcd;

use super::fourier::{series, series_as_function};
use super::{FourierRadius, Parameter, ParametricCurve, PlaneCurve};
use crate::exact::Rational;
use crate::poly::{BinaryForm, RationalFunction, harmonics_of_form};

/// The closed curve
///
/// x(t) = a_0 + Σ_{n=1..N} (a_n cos nt + b_n sin nt), y(t) = c_0 + Σ_{n=1..N} (c_n cos nt + d_n sin nt)
///
/// with exact rational coefficients, for t in [0, 2π]: the elliptic Fourier series of Kuhl and Giardina (1982). The n-th terms
/// trace an ellipse n times.
///
/// `N` is the *true* number of harmonics: trailing harmonics that are zero are dropped on construction.
///
/// ```
/// use stellate::exact::Rational;
/// use stellate::shape::EllipticSeries;
///
/// let q = |v: &[i64]| v.iter().map(|&c| Rational::from(c)).collect::<Vec<_>>();
/// // An ellipse about (5, 7).
/// let ellipse = EllipticSeries::new([q(&[5, 3, 0]), q(&[0, 0, 0]), q(&[7, 0]), q(&[0, 2])]);
/// assert_eq!(ellipse.harmonics(), 1);
/// assert_eq!(ellipse.y_sin(), q(&[0, 2]));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EllipticSeries {
    /// The coefficients of x by cosines and sines, then those of y, for n = 0, …, N.
    lists: [Vec<Rational>; 4],
}

impl EllipticSeries {
    /// The curve with these coefficients of x by cosines and sines, then of y, from n = 0 on. Those of sin 0 are ignored; shorter
    /// lists are padded with zeros.
    #[must_use]
    pub fn new(mut lists: [Vec<Rational>; 4]) -> Self {
        let used = |list: &Vec<Rational>| {
            list.iter()
                .rposition(|c| !c.is_zero())
                .map_or(0, |last| last + 1)
        };
        for i in [1, 3] {
            if let Some(first) = lists[i].first_mut() {
                *first = Rational::zero();
            }
        }
        let len = lists.iter().map(used).max().unwrap_or(1).max(1);
        for list in &mut lists {
            list.resize(len, Rational::zero());
        }
        Self { lists }
    }

    /// The curve (r cos θ, r sin θ) about the center of a radius, which has one harmonic more.
    #[must_use]
    pub fn from_radius(radius: &FourierRadius) -> Self {
        let n = radius.harmonics();
        let mut lists: [Vec<Rational>; 4] = std::array::from_fn(|_| vec![Rational::zero(); n + 2]);
        let half = Rational::from_dyadic(Integer::from(1), -1);
        let mut add = |list: usize, n: usize, c: Rational| lists[list][n] = &lists[list][n] + c;
        for m in 0..=n {
            let (a, b) = (radius.cos(m) * &half, radius.sin(m) * &half);
            // cos mθ cos θ = (cos (m+1)θ + cos (m−1)θ)/2, and so on; for m = 0 the second angle is −θ, whose sine is −sin θ.
            let (below, of_sine) = match m {
                0 => (1, Rational::from(-1)),
                _ => (m - 1, Rational::one()),
            };
            add(0, m + 1, a.clone());
            add(0, below, a.clone());
            add(1, m + 1, b.clone());
            add(1, below, &b * &of_sine);
            add(2, m + 1, -&b);
            add(2, below, b);
            add(3, m + 1, a.clone());
            add(3, below, -(a * of_sine));
        }
        for (i, c) in [0, 2].into_iter().zip(radius.center()) {
            add(i, 0, c.clone());
        }
        Self::new(lists)
    }

    /// The series of a plane curve; `None` if its coordinates are not trigonometric polynomials of one angle.
    pub(crate) fn of_plane_curve(curve: &PlaneCurve) -> Option<Self> {
        curve.parameter().step()?;
        let [[a, b], [c, d]] = harmonics_of_curve(curve)?;
        Some(Self::new([a, b, c, d]))
    }

    /// The series of two functions of tan(t/2); `None` if they are not trigonometric polynomials of t.
    pub(crate) fn of_functions(functions: [&RationalFunction; 2]) -> Option<Self> {
        let [x, y] = functions.map(harmonics_of_function);
        let ([a, b], [c, d]) = (x?, y?);
        Some(Self::new([a, b, c, d]))
    }

    /// The series of the same curve, traced once, if all harmonics are multiples of a number g > 1: then t runs g times around it.
    pub(crate) fn traced_once(&self) -> Option<Self> {
        let harmonics =
            (1..=self.harmonics()).filter(|&n| self.lists.iter().any(|c| !c[n].is_zero()));
        let step = harmonics.fold(0, |g: usize, n| g.gcd(n));
        let every = |list: &Vec<Rational>| list.iter().step_by(step).cloned().collect();
        (step > 1).then(|| Self::new(self.lists.each_ref().map(every)))
    }

    /// The number of harmonics N.
    #[must_use]
    pub fn harmonics(&self) -> usize {
        self.lists[0].len() - 1
    }

    /// The coefficients a_0, …, a_N of the cosines in x.
    #[must_use]
    pub fn x_cos(&self) -> &[Rational] {
        &self.lists[0]
    }

    /// The coefficients 0, b_1, …, b_N of the sines in x.
    #[must_use]
    pub fn x_sin(&self) -> &[Rational] {
        &self.lists[1]
    }

    /// The coefficients c_0, …, c_N of the cosines in y.
    #[must_use]
    pub fn y_cos(&self) -> &[Rational] {
        &self.lists[2]
    }

    /// The coefficients 0, d_1, …, d_N of the sines in y.
    #[must_use]
    pub fn y_sin(&self) -> &[Rational] {
        &self.lists[3]
    }

    /// All coefficients: those of x by cosines and sines, then those of y.
    #[must_use]
    pub fn lists(&self) -> &[Vec<Rational>; 4] {
        &self.lists
    }

    /// The series of at most this many harmonics.
    #[must_use]
    pub fn truncated(&self, harmonics: usize) -> Self {
        let cut = |list: &Vec<Rational>| list.iter().take(harmonics + 1).cloned().collect();
        Self::new(self.lists.each_ref().map(cut))
    }

    /// The curve as a pair of rational functions of s = tan(t/2).
    #[must_use]
    pub fn to_plane_curve(&self) -> PlaneCurve {
        let [a, b, c, d] = &self.lists;
        PlaneCurve::new(
            Parameter::angle("t", Rational::one()),
            [series_as_function(a, b), series_as_function(c, d)],
        )
    }

    /// About `count` points of the curve for drawing, closed. The series are summed in doubles; the error is about N·10⁻¹⁶ of the
    /// size.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "a count of points is small")]
    pub fn polyline(&self, count: usize) -> Vec<[f64; 2]> {
        let lists = self
            .lists
            .each_ref()
            .map(|list| list.iter().map(Rational::to_f64).collect::<Vec<f64>>());
        let [a, b, c, d] = &lists;
        let count = count.max(3);
        (0..=count)
            .map(|k| {
                let t = std::f64::consts::TAU * ((k % count) as f64 / count as f64);
                [series(a, b, t), series(c, d, t)]
            })
            .collect()
    }

    /// The power (a_n² + b_n² + c_n² + d_n²)/2 of the n-th harmonic, for n ≤ N.
    #[must_use]
    pub fn power(&self, n: usize) -> Rational {
        let squares = self.lists.iter().map(|list| &list[n] * &list[n]);
        squares.sum::<Rational>() / Rational::from(2)
    }
}

/// The coefficients of the cosines and sines of t = 2 arctan s in each coordinate, from n = 0 on; `None` if a coordinate is not a
/// trigonometric polynomial of t.
pub(crate) fn harmonics_of_curve<const N: usize>(
    curve: &ParametricCurve<N>,
) -> Option<[[Vec<Rational>; 2]; N]> {
    let mut all = std::array::from_fn(|_| [Vec::new(), Vec::new()]);
    for (lists, f) in all.iter_mut().zip(curve.coordinates()) {
        *lists = harmonics_of_function(f)?;
    }
    Some(all)
}

/// The coefficients of the cosines and sines of t, for a function of s = tan(t/2) whose denominator is a power of 1 + s² (up to a
/// constant) and whose numerator has at most its degree.
fn harmonics_of_function(f: &RationalFunction) -> Option<[Vec<Rational>; 2]> {
    let (above, below) = (f.numerator(), f.denominator());
    let [lowest, ..] = below.coefficients_asc() else {
        return None;
    };
    let degree = below.coefficients_asc().len() - 1;
    let power = BinaryForm::rho_power(degree / 2).scaled(lowest);
    if power.dehomogenized() != below || above.coefficients_asc().len() > degree + 1 {
        return None;
    }
    let form = BinaryForm::from_dehomogenized(degree, above.clone());
    let lowest = Rational::whole(lowest);
    let mut lists = [(); 2].map(|()| vec![Rational::zero(); degree / 2 + 1]);
    // All harmonics of t/2 are even.
    for (n, a, b) in harmonics_of_form(&form) {
        lists[0][n / 2] = a / &lowest;
        lists[1][n / 2] = b / &lowest;
    }
    Some(lists)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_series_of_a_curve_comes_back(numbers in prop::collection::vec(-20i64..20, 4..24)) {
            let q: Vec<Rational> = numbers.iter().map(|&c| Rational::from(c) / Rational::from(7)).collect();
            let (a, rest) = q.split_at(numbers.len() / 4);
            let (b, rest) = rest.split_at(numbers.len() / 4);
            let (c, d) = rest.split_at(numbers.len() / 4);
            let series = EllipticSeries::new([a, b, c, d].map(<[Rational]>::to_vec));
            prop_assert_eq!(EllipticSeries::of_plane_curve(&series.to_plane_curve()), Some(series));
        }
    }

    #[test]
    fn a_radius_is_a_series() {
        let q = |v: &[i64]| v.iter().map(|&c| Rational::from(c)).collect::<Vec<_>>();
        for (cos, sin) in [
            (q(&[3, 1, -2]), q(&[0, 5, 7])),
            (q(&[0, 0, 1]), q(&[0])),
            (q(&[4]), q(&[0])),
        ] {
            let radius = FourierRadius::new(cos, sin);
            let plane = radius.to_plane_curve();
            let series = EllipticSeries::from_radius(&radius);
            assert_eq!(series.to_plane_curve(), plane);
        }
    }
}
