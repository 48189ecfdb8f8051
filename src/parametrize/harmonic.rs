//! Theorem 2 in space, back: the spherical harmonics of a surface whose radius is a finite sum of them.

use malachite::Integer;

use crate::error::Result;
use crate::exact::Rational;
use crate::poly::{Ring, TernaryForm, harmonics_of_ternary_form};
use crate::shape::{HarmonicSurface, ImplicitSurface, MAX_HARMONIC_DEGREE};

/// The radii R(d) of a surface that are finite sums of spherical harmonics; empty if the surface has none.
///
/// The equation has the parts `c ρ^n`, `M` and `P` of degrees 2n, 2n − 1 and 2n − 2, with L = n − 1, as
/// [`crate::implicitize::SquaredHarmonics`] makes it. Then on the unit sphere `c r² + M r + P = 0`, and the radii are `odd ± even` with
/// `odd = −M/2c` and `even² = odd² − P/c`: exact if M is divisible by ρ^⌊L/2+1⌋ and the discriminant is the square of a form. The radius
/// with a positive first even coefficient comes first; the other one is −R(−d). If P = 0, then `−M/c` is the only radius.
///
/// ```
/// use stellate::implicitize::SquaredHarmonics;
/// use stellate::parametrize::harmonic_radii;
/// use stellate::shape::HarmonicSurface;
///
/// let surface = HarmonicSurface::new([((0, 0), 2.into()), ((3, -2), "1/7".parse()?)])?;
/// let equation = SquaredHarmonics::new(&surface)?.expand();
/// assert_eq!(harmonic_radii(&equation)?[0], surface);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`crate::error::Error::Limit`] beyond [`MAX_HARMONIC_DEGREE`].
pub fn harmonic_radii(surface: &ImplicitSurface) -> Result<Vec<HarmonicSurface>> {
    let radii = match sums(surface) {
        None => Vec::new(),
        Some((scale, odd, None)) => vec![sum(&scale, &odd, None)?],
        Some((scale, odd, Some(even))) => {
            let opposite = even.scaled(&Integer::from(-1));
            let mut radii = vec![
                sum(&scale, &odd, Some(&even))?,
                sum(&scale, &odd, Some(&opposite))?,
            ];
            let is_positive = |r: &HarmonicSurface| {
                let mut even = r.terms().filter(|(l, ..)| l % 2 == 0);
                even.next().is_some_and(|(_, _, c)| c.signum() > 0)
            };
            if !is_positive(&radii[0]) {
                radii.reverse();
            }
            radii
        }
    };
    let about = |radius: HarmonicSurface| radius.with_center(surface.center().clone());
    Ok(radii.into_iter().map(about).collect())
}

/// The factor by which the two forms are larger than the sums of the odd and of the even harmonics; the second form is `None`
/// if there is one radius.
fn sums(surface: &ImplicitSurface) -> Option<(Integer, Vec<TernaryForm>, Option<TernaryForm>)> {
    let parts = surface.by_degree();
    let degree = parts.degree()?;
    let n = degree / 2;
    if !degree.is_multiple_of(2) || !(1..=MAX_HARMONIC_DEGREE + 1).contains(&n) {
        return None;
    }
    let degrees = parts.homogeneous_degrees();
    if degrees.iter().any(|d| d + 2 < degree) || degrees.len() < 2 {
        return None;
    }
    let (power, top) = parts.part(degree).strip_rho()?;
    if power != n {
        return None;
    }
    let c = top.evaluate(&[Integer::from(1), Integer::from(0), Integer::from(0)]);
    let middle = parts.part(degree - 1).scaled(&Integer::from(-1));
    let low = parts.part(degree - 2);
    if low.is_zero() {
        return Some((c, vec![middle], None));
    }
    // 2c times the sum of the odd harmonics, of degree L or L − 1
    let l = n - 1;
    let mut odd = middle;
    for _ in 0..=l / 2 {
        if odd.is_zero() {
            break;
        }
        odd = odd.divided_by_rho()?;
    }
    let four_low = low.scaled(&(&c * Integer::from(-4)));
    let is_zero = odd.is_zero();
    let square = match (l % 2, is_zero) {
        (0, true) => four_low,
        (0, false) => odd.squared_densely().times_rho_power(1).plus(&four_low),
        (_, true) => four_low.divided_by_rho()?,
        (_, false) => odd.squared_densely().plus(&four_low).divided_by_rho()?,
    };
    let even = square.square_root()?;
    let odd = if is_zero { Vec::new() } else { vec![odd] };
    Some((c * Integer::from(2), odd, Some(even)))
}

fn sum(
    scale: &Integer,
    odd: &[TernaryForm],
    even: Option<&TernaryForm>,
) -> Result<HarmonicSurface> {
    let forms = odd.iter().chain(even);
    let scale = Rational::whole(scale);
    let terms = forms.flat_map(harmonics_of_ternary_form);
    HarmonicSurface::new(terms.map(|(l, m, c)| ((l as usize, m as isize), c / &scale)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::implicitize::SquaredHarmonics;
    use crate::language::{Numbers, parse_form};
    use crate::shape::Form;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn the_coefficients_come_back(
            list in prop::collection::vec((0usize..7, 0usize..13, -9i64..10, 1i64..7), 1..12),
            parity in 0usize..3,
        ) {
            let terms = list.into_iter().map(|(l, m, p, q)| {
                let l = if parity < 2 { l / 2 * 2 + parity } else { l };
                let m = (m % (2 * l + 1)) as isize - l as isize;
                ((l, m), Rational::new(p, q).unwrap())
            });
            let surface = HarmonicSurface::new(terms).unwrap();
            prop_assume!(!surface.is_zero());
            let equation = SquaredHarmonics::new(&surface).unwrap().expand();
            let radii = harmonic_radii(&equation).unwrap();
            prop_assert!(radii.contains(&surface), "{:?} {:?}", surface, radii);
            let only_odd = surface.terms().all(|(l, ..)| l % 2 == 1);
            prop_assert_eq!(radii.len(), if only_odd { 1 } else { 2 });
        }
    }

    #[test]
    fn other_surfaces_have_no_harmonics() {
        for text in [
            "x^2 + y^2 + 2z^2 = 1",
            "x^4 + y^4 + z^4 = 1",
            "(x^2 + y^2 + z^2)^2 = x*y*z + x^2",
            "(x^2 + y^2 + z^2)^2 = 2x^2",
            "x^2 + y^2 + z^2 = -1",
            "x + y + z = 1",
            "(x^2 + y^2 + z^2)^2 = x + y",
            "x^2 + y^2 + z^2 = 0",
        ] {
            let Ok(Form::Surface(surface)) = parse_form(text, "<form>", Numbers::Exact) else {
                panic!("{text} is a surface");
            };
            assert!(harmonic_radii(&surface).unwrap().is_empty(), "{text}");
        }
    }
}
