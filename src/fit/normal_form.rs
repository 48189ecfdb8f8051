//! The normal form of an elliptic series, in which the shapes of specimens are compared.

use super::as_f64;
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::shape::EllipticSeries;

/// An elliptic series in normal form, and what was taken out of it.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct NormalForm {
    /// The series. Its middle is the origin, and its first harmonic is an ellipse that is traced counter-clockwise from the end of
    /// its major half axis, (1, 0), on.
    pub series: EllipticSeries,
    /// The length of the major half axis of the first harmonic, by which all coefficients were divided.
    pub size: f64,
    /// The angle from the x axis to that half axis, in radians, by which the curve was turned back.
    pub rotation: f64,
    /// The parameter t at the end of that half axis, where the curve now starts.
    pub start: f64,
    /// Whether the direction was reversed, so that the first harmonic is traced counter-clockwise.
    pub reversed: bool,
}

/// The normal form of a series: without position, size, rotation, starting point and direction (Kuhl & Giardina, Eqs. (12) to (16)).
///
/// With the matrices M_n of the coefficients of x and y by cos nt and sin nt, the normal ones are R(−ψ) M_n R(nθ)/E, where R turns by
/// an angle, θ = ½ atan2(2(a_1 b_1 + c_1 d_1), a_1² + c_1² − b_1² − d_1²) is the parameter at the end of the major half axis, ψ its
/// direction and E its length. Of its two ends, that with θ in (−π/2, π/2] is taken; from the other one the even harmonics
/// have the other sign.
///
/// The numbers are computed in doubles, with errors of some 10⁻¹⁶ of E, and rounded to `decimals`, if that is given.
///
/// ```
/// use stellate::exact::Rational;
/// use stellate::fit::normal_form;
/// use stellate::shape::EllipticSeries;
///
/// let q = |v: [i64; 2]| v.map(Rational::from).to_vec();
/// // An ellipse about (5, 7) with the half axes 4 along y and 2 along x, traced clockwise.
/// let ellipse = EllipticSeries::new([q([5, 0]), q([0, 2]), q([7, 4]), q([0, 0])]);
/// let found = normal_form(&ellipse, Some(12))?;
/// assert!(found.reversed && (found.size - 4.0).abs() < 1e-12);
/// let half = Rational::from(1) / Rational::from(2);
/// let expected = EllipticSeries::new([q([0, 1]), q([0, 0]), q([0, 0]), vec![0.into(), half]]);
/// assert_eq!(found.series, expected);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Hypothesis`] if the first harmonic is 0.
pub fn normal_form(series: &EllipticSeries, decimals: Option<u32>) -> Result<NormalForm> {
    let mut harmonics: Vec<[f64; 4]> = (0..=series.harmonics())
        .map(|n| series.lists().each_ref().map(|list| list[n].to_f64()))
        .collect();
    harmonics[0] = [0.0; 4];
    let Some([a, b, c, d]) = harmonics.get(1).copied() else {
        return Err(no_first_harmonic());
    };
    let reversed = a * d - b * c < 0.0;
    if reversed {
        for [_, b, _, d] in &mut harmonics {
            (*b, *d) = (-*b, -*d);
        }
    }
    let [a, b, c, d] = if reversed {
        [a, -b, c, -d]
    } else {
        [a, b, c, d]
    };
    let start = (2.0 * (a * b + c * d)).atan2(a * a + c * c - b * b - d * d) / 2.0;
    for (n, [a, b, c, d]) in harmonics.iter_mut().enumerate() {
        let (sin, cos) = (as_f64(n) * start).sin_cos();
        (*a, *b) = (*a * cos + *b * sin, *b * cos - *a * sin);
        (*c, *d) = (*c * cos + *d * sin, *d * cos - *c * sin);
    }
    let [a, _, c, _] = harmonics[1];
    let (size, rotation) = (a.hypot(c), c.atan2(a));
    if size <= 0.0 {
        return Err(no_first_harmonic());
    }
    let (sin, cos) = rotation.sin_cos();
    for [a, b, c, d] in &mut harmonics {
        (*a, *c) = ((*a * cos + *c * sin) / size, (*c * cos - *a * sin) / size);
        (*b, *d) = ((*b * cos + *d * sin) / size, (*d * cos - *b * sin) / size);
    }
    // These three are exact by the choice of the angles.
    if let Some(first) = harmonics.get_mut(1) {
        (first[0], first[1], first[2]) = (1.0, 0.0, 0.0);
    }
    let exact = |value: f64| -> Result<Rational> {
        let exact = Rational::try_from(value)
            .map_err(|_| Error::Usage("the series is too large for doubles".into()))?;
        Ok(match decimals {
            None => exact,
            Some(digits) => exact.round_decimals(digits),
        })
    };
    let mut lists: [Vec<Rational>; 4] = Default::default();
    for harmonic in &harmonics {
        for (list, &value) in lists.iter_mut().zip(harmonic) {
            list.push(exact(value)?);
        }
    }
    Ok(NormalForm {
        series: EllipticSeries::new(lists),
        size,
        rotation,
        start,
        reversed,
    })
}

fn no_first_harmonic() -> Error {
    Error::Hypothesis {
        statement: "the normal form of an elliptic series",
        witness: "its first harmonic is 0, so it has no major half axis".into(),
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use proptest::prelude::*;

    use super::*;

    fn series(numbers: &[f64]) -> EllipticSeries {
        let exact = |k: usize| -> Vec<Rational> {
            let list = numbers.iter().skip(k).step_by(4);
            list.map(|&c| Rational::try_from(c).unwrap()).collect()
        };
        EllipticSeries::new([exact(0), exact(1), exact(2), exact(3)])
    }

    proptest! {
        /// The normal form does not depend on position, size, rotation, starting point and direction, up to the choice of the end
        /// of the half axis.
        #[test]
        fn specimens_are_alike(
            numbers in prop::collection::vec(-1.0f64..1.0, 20),
            size in 0.1f64..10.0,
            turn in 0.0..TAU,
            start in 0.0..TAU,
            is_reversed: bool,
        ) {
            let plain = series(&numbers);
            let [a, b, c, d] = [0, 1, 2, 3].map(|i| numbers[4 + i]);
            // The half axes differ, and the ellipse is not a line.
            let (half, determinant) = ((a * a + b * b + c * c + d * d) / 2.0, (a * d - b * c).abs());
            prop_assume!(determinant > 0.05 && half - determinant > 0.05);
            let moved: Vec<f64> = numbers
                .chunks(4)
                .enumerate()
                .flat_map(|(n, four)| {
                    let sign = if is_reversed { -1.0 } else { 1.0 };
                    let [a, b, c, d] = [four[0], sign * four[1], four[2], sign * four[3]];
                    let (s, k) = (as_f64(n) * start).sin_cos();
                    let [a, b, c, d] = [a * k + b * s, b * k - a * s, c * k + d * s, d * k - c * s];
                    let (s, k) = turn.sin_cos();
                    [a * k - c * s, b * k - d * s, a * s + c * k, b * s + d * k].map(|v| v * size)
                })
                .collect();
            let found = [plain, series(&moved)].map(|s| normal_form(&s, None).unwrap());
            prop_assert!((found[1].size / found[0].size / size - 1.0).abs() < 1e-12);
            let differs = |sign: f64| -> f64 {
                let lists = found[0].series.lists().iter().zip(found[1].series.lists());
                let pairs = lists.flat_map(|(p, q)| p.iter().zip(q).enumerate());
                let sizes = pairs.map(|(n, (p, q))| {
                    let sign = if n % 2 == 0 { sign } else { 1.0 };
                    (p.to_f64() - sign * q.to_f64()).abs()
                });
                sizes.fold(0.0, f64::max)
            };
            prop_assert!(differs(1.0).min(differs(-1.0)) < 1e-11);
        }
    }
}
