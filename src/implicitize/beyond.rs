//! A real point of the zero set of a patch's equation that is not on the patch.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;

use crate::error::Invariant;
use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, SparsePolynomial};
use crate::roots::real_roots;
use crate::shape::{Basis, ImplicitSurface, Patch, quotient_in_harmonics};

/// A point of the zero set that is not on the patch, with the proof: one of its coordinates is out of the patch's range.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PointBeyond {
    /// The index of that coordinate: 0, 1, 2 for x, y, z.
    pub coordinate: usize,
    /// A lower and an upper bound of that coordinate on the patch; `None` if no bound is known.
    pub bounds: [Option<Rational>; 2],
    /// The point: two rational coordinates, and the third as the double nearest to an exact root.
    pub point: [f64; 3],
}

/// The values of a second coordinate that are tried.
const TRIED: [i64; 9] = [0, 1, -1, 2, -2, 4, -4, 8, -8];

/// Searches a few lines for a real zero one of whose coordinates has a value that it has nowhere on the patch. Such a point
/// proves that the zero set has more points than the patch; `None` proves nothing.
///
/// The bounds of the coordinates are exact: a finite Fourier series is at most the sum of its amplitudes, and an even power of
/// a number is not negative.
#[must_use]
pub fn point_beyond(patch: &Patch, surface: &ImplicitSurface) -> Option<PointBeyond> {
    (0..3).find_map(|k| {
        let bounds = bounds(patch, k);
        let [low, high] = &bounds;
        let one = Rational::one();
        let outside = [
            high.as_ref().map(|h| h + &one),
            low.as_ref().map(|l| l - &one),
        ];
        outside.into_iter().flatten().find_map(|value| {
            let point = point_with(surface, k, &value)?;
            Some(PointBeyond {
                coordinate: k,
                bounds: bounds.clone(),
                point,
            })
        })
    })
}

/// A real zero whose coordinate number k has the given value.
fn point_with(surface: &ImplicitSurface, k: usize, value: &Rational) -> Option<[f64; 3]> {
    for (second, third) in [((k + 1) % 3, (k + 2) % 3), ((k + 2) % 3, (k + 1) % 3)] {
        for tried in TRIED {
            let tried = Rational::from(tried);
            let f = on_a_line(surface.polynomial(), [(k, value), (second, &tried)], third);
            let root = if f == IntegerPolynomial::ZERO {
                Some(0.0)
            } else {
                real_roots(&f).first().map(crate::roots::RealRoot::to_f64)
            };
            if let Some(root) = root {
                let mut point = [0.0; 3];
                point[k] = value.to_f64();
                point[second] = tried.to_f64();
                point[third] = root;
                return Some(point);
            }
        }
    }
    None
}

/// f as a polynomial in one coordinate, where the other two have given values.
fn on_a_line(
    f: &SparsePolynomial<3>,
    given: [(usize, &Rational); 2],
    third: usize,
) -> IntegerPolynomial {
    let mut sum = SparsePolynomial::<1>::zero();
    for (e, c) in f.terms() {
        let value = given.iter().fold(c.clone(), |value, (k, x)| {
            let power = x.pow(i64::from(e[*k]));
            value * power.invariant("an exponent is not negative")
        });
        sum.add_term([e[third]], value);
    }
    let sum = sum.primitive();
    // The length is 0 for the polynomial 0.
    let length = sum
        .terms()
        .map(|(e, _)| e[0] as usize + 1)
        .max()
        .unwrap_or(0);
    let mut coefficients = vec![Integer::ZERO; length];
    for (e, c) in sum.terms() {
        coefficients[e[0] as usize] = c.numerator();
    }
    IntegerPolynomial::from_coefficients_asc(coefficients)
}

/// A lower and an upper bound of a coordinate on the patch; `None` if no bound is known.
fn bounds(patch: &Patch, k: usize) -> [Option<Rational>; 2] {
    let f = &patch.coordinates()[k];
    let all_angles = patch
        .parameters()
        .iter()
        .all(crate::shape::Parameter::is_angle);
    if all_angles {
        let functions = [f.numerator(), f.denominator()];
        let [above, below] = quotient_in_harmonics(functions, patch.parameters());
        let divisor = below
            .get(&[Basis::Power(0); 2])
            .filter(|_| below.len() == 1);
        let amplitude = divisor.map(|divisor| {
            let sum = above
                .values()
                .fold(Rational::zero(), |sum, c| sum + c.abs());
            sum / divisor.abs()
        });
        return [amplitude.as_ref().map(|a| -a.clone()), amplitude];
    }
    let no_angles = patch.parameters().iter().all(|p| !p.is_angle());
    let Some(below) = f.denominator().as_constant().filter(|_| no_angles) else {
        return [None, None];
    };
    let mut constant = Rational::zero();
    let mut signs = [false; 2];
    for (e, c) in f.numerator().terms() {
        match e {
            [0, 0] => constant = c / &below,
            [a, b] if a % 2 == 0 && b % 2 == 0 => signs[usize::from(c.signum() > 0)] = true,
            _ => signs = [true, true],
        }
    }
    match signs {
        [false, true] => [Some(constant), None],
        [true, false] => [None, Some(constant)],
        _ => [None, None],
    }
}
