//! Radii: Fourier series and sums of spherical harmonics, as solid harmonics with integer coefficients.

use std::cell::OnceCell;

use num_bigint::BigInt;

use super::arcs::Arc;
use super::numbers::{Exact, common_denominator, powers};
use super::refusal::{Checked, need};
use super::sparse::Sparse;
use super::univariate::{Coefficients, add_multiple, product};

/// A radius: the sum of harmonics of degrees 0 to N.
#[derive(Debug)]
pub(super) struct Series {
    pub(super) center: Vec<Exact>,
    /// The harmonics are multiplied by this positive integer.
    pub(super) scale: BigInt,
    pub(super) harmonics: Harmonics,
    /// The parts of [`Self::solid_harmonics`].
    solid: OnceCell<Vec<Sparse>>,
    /// The quarters of the curve of a radius in the plane.
    pub(super) quarters: OnceCell<Vec<Arc>>,
}

/// The coefficients of a radius, times the scale.
#[derive(Debug)]
pub(super) enum Harmonics {
    Plane {
        cos: Vec<BigInt>,
        sin: Vec<BigInt>,
    },
    Space {
        degree: u32,
        coefficients: Vec<SphericalTerm>,
    },
}

/// The coefficient of Y(l, m).
#[derive(Debug)]
pub(super) struct SphericalTerm {
    pub(super) l: u32,
    pub(super) m: i64,
    pub(super) value: BigInt,
}

/// A and B of theorem T2, homogeneous of the degrees N and N − 1: on the unit circle or sphere the radius times the scale is A + B.
#[derive(Debug)]
pub(super) struct Parity {
    pub(super) same: Sparse,
    pub(super) other: Sparse,
}

/// The rational numbers a and b of a radius a + b·|e| in the direction of a vector e.
#[derive(Debug)]
pub(super) struct RadiusParts {
    pub(super) rational: Exact,
    pub(super) of_length: Exact,
}

impl Series {
    pub(super) fn new(center: Vec<Exact>, scale: BigInt, harmonics: Harmonics) -> Self {
        Self {
            center,
            scale,
            harmonics,
            solid: OnceCell::new(),
            quarters: OnceCell::new(),
        }
    }

    pub(super) fn dimension(&self) -> usize {
        self.center.len()
    }

    /// N, the degree of the last harmonic that is listed.
    pub(super) fn top(&self) -> u32 {
        match &self.harmonics {
            Harmonics::Plane { cos, .. } => u32::try_from(cos.len()).unwrap_or(1).saturating_sub(1),
            Harmonics::Space { degree, .. } => *degree,
        }
    }

    /// The factor by which [`Self::solid_harmonics`] are those of the radius.
    pub(super) fn solid_scale(&self) -> BigInt {
        match &self.harmonics {
            Harmonics::Plane { .. } => self.scale.clone(),
            Harmonics::Space { degree, .. } => &self.scale << degree,
        }
    }

    /// The solid harmonics r^n·(harmonic n) for n = 0 to N, times [`Self::solid_scale`].
    pub(super) fn solid_harmonics(&self) -> &[Sparse] {
        self.solid.get_or_init(|| match &self.harmonics {
            Harmonics::Plane { cos, sin } => cos
                .iter()
                .zip(sin)
                .zip(0..)
                .map(|((cos, sin), n)| {
                    let mut harmonic = Sparse::default();
                    for (is_sine, factor) in [(false, cos), (true, sin)] {
                        for (k, c) in multiple_angle(n, is_sine) {
                            harmonic.add_term([n - k, k, 0, 0], c * factor);
                        }
                    }
                    harmonic
                })
                .collect(),
            Harmonics::Space {
                degree,
                coefficients,
            } => {
                let mut harmonics = vec![Sparse::default(); *degree as usize + 1];
                for term in coefficients {
                    let factor = &term.value << (degree - term.l);
                    add_spherical(&mut harmonics[term.l as usize], term.l, term.m, &factor);
                }
                harmonics
            }
        })
    }

    /// A = Σ K_n ρ^((N − n)/2) over the n of the parity of N, and B = Σ K_n ρ^((N − 1 − n)/2) over the others.
    pub(super) fn parity(&self) -> Checked<Parity> {
        let rho = Sparse::squared_radius(self.dimension());
        let (mut sums, mut power) = ([Sparse::default(), Sparse::default()], Sparse::constant(1));
        for (distance, harmonic) in self.solid_harmonics().iter().rev().enumerate() {
            sums[distance % 2].add_multiple(&BigInt::from(1), &harmonic.times(&power)?);
            if distance % 2 == 1 {
                power = power.times(&rho)?;
            }
        }
        let [same, other] = sums;
        Ok(Parity { same, other })
    }

    /// The radius in the direction of a vector, which is not zero. For the vector X/W with integers X, a harmonic K_n is
    /// K_n(X)/|X|^n; this is rational for even n, and a rational multiple of |X| for odd n.
    pub(super) fn radius(&self, direction: &[Exact]) -> Checked<RadiusParts> {
        let (vector, common) = common_denominator(direction);
        let square: BigInt = vector.iter().map(|x| x * x).sum();
        need(
            square != BigInt::ZERO,
            "the radius has no direction at its center",
        )?;
        let values = self.harmonics_at(&vector);
        let half = values.len() / 2;
        let squares = powers(&square, half);
        let mut sums = [BigInt::ZERO, BigInt::ZERO];
        for (n, value) in values.iter().enumerate() {
            sums[n % 2] += value * &squares[half - n.div_ceil(2)];
        }
        let denominator = &squares[half] * self.solid_scale();
        let [even, odd] = sums;
        Ok(RadiusParts {
            rational: Exact::fraction(even, denominator.clone()),
            of_length: Exact::fraction(odd * common, denominator),
        })
    }

    /// The values of the solid harmonics at a point with integer coordinates.
    fn harmonics_at(&self, point: &[BigInt]) -> Vec<BigInt> {
        match (&self.harmonics, point) {
            (Harmonics::Plane { cos, sin }, [x, y]) => {
                let (mut re, mut im) = (BigInt::from(1), BigInt::ZERO);
                let mut values = Vec::with_capacity(cos.len());
                for (c, s) in cos.iter().zip(sin) {
                    values.push(c * &re + s * &im);
                    (re, im) = (&re * x - &im * y, &re * y + &im * x);
                }
                values
            }
            _ => {
                let parts = self.solid_harmonics().iter().enumerate();
                parts
                    .map(|(n, part)| {
                        part.parts_at(point)
                            .swap_remove(n.min(part.degree() as usize))
                    })
                    .collect()
            }
        }
    }

    /// The radius in the direction of a unit vector.
    pub(super) fn radius_at_unit(&self, direction: &[Exact]) -> Checked<Exact> {
        let RadiusParts {
            rational,
            of_length,
        } = self.radius(direction)?;
        Ok(&rational + &of_length)
    }

    /// The point of the curve or surface in the direction of a unit vector.
    pub(super) fn point(&self, direction: &[Exact]) -> Checked<Vec<Exact>> {
        let radius = self.radius_at_unit(direction)?;
        Ok(self
            .center
            .iter()
            .zip(direction)
            .map(|(c, u)| c + &(&radius * u))
            .collect())
    }

    /// The polynomial (1 + t²)^N·r·scale of formal degree 2N on a quarter of the circle, 0 ≤ t ≤ 1. With z = i^q·(1 + i t)², a
    /// harmonic c cos nθ + s sin nθ is the real part of (c − i s)·z^n/(1 + t²)^n; the sum is formed by Horner's scheme.
    pub(super) fn on_quarter(&self, quarter: usize) -> Coefficients {
        let Harmonics::Plane { cos, sin } = &self.harmonics else {
            return Vec::new();
        };
        let [x, y] = quarter_direction(quarter);
        let (mut re, mut im) = (vec![BigInt::ZERO], vec![BigInt::ZERO]);
        let mut power = vec![BigInt::from(1)];
        let minus = BigInt::from(-1);
        for (c, s) in cos.iter().zip(sin).rev() {
            let (mut next_re, mut next_im) = (product(&re, &x), product(&re, &y));
            add_multiple(&mut next_re, &minus, &product(&im, &y));
            add_multiple(&mut next_im, &BigInt::from(1), &product(&im, &x));
            add_multiple(&mut next_re, c, &power);
            add_multiple(&mut next_im, &-s, &power);
            (re, im) = (next_re, next_im);
            power = product(&power, &length_polynomial());
        }
        re.truncate(2 * cos.len() - 1);
        re
    }
}

/// 1 + t².
pub(super) fn length_polynomial() -> Coefficients {
    [1, 0, 1].map(BigInt::from).to_vec()
}

/// The real and the imaginary part of i^quarter·(1 + i t)², the direction of the angle quarter·π/2 + 2 atan t.
pub(super) fn quarter_direction(quarter: usize) -> [Coefficients; 2] {
    let (x, y): ([i32; 3], [i32; 3]) = match quarter % 4 {
        0 => ([1, 0, -1], [0, 2, 0]),
        1 => ([0, -2, 0], [1, 0, -1]),
        2 => ([-1, 0, 1], [0, -2, 0]),
        _ => ([0, 2, 0], [-1, 0, 1]),
    };
    [x, y].map(|list| list.map(BigInt::from).to_vec())
}

/// The terms of the real or the imaginary part of (x + i y)^n: the exponents k of y with the coefficients of x^(n − k) y^k.
pub(super) fn multiple_angle(n: u32, imaginary: bool) -> Vec<(u32, BigInt)> {
    let mut terms = Vec::new();
    let mut binomial = BigInt::from(1);
    for k in 0..=n {
        if (k % 2 == 1) == imaginary {
            terms.push((
                k,
                if k % 4 < 2 {
                    binomial.clone()
                } else {
                    -&binomial
                },
            ));
        }
        binomial = binomial * (n - k) / (k + 1);
    }
    terms
}

/// Adds factor·2^l·r^l·Y(l, m). With σ = x² + y² and m ≥ 0, r^l Y(l, m) is Re (x + i y)^m times Σ_j a_j z^(l − m − 2j) σ^j with
/// a_j = (−1)^j (l + m)!/(2^(m + 2j) j! (m + j)! (l − m − 2j)!): the value of d^m P_l/du^m at u = 1 gives a_0, and the other a_j
/// follow since the Laplacian of the sum is 0, which is a_{j+1}·4(j + 1)(j + 1 + m) = −a_j·(l − m − 2j)(l − m − 2j − 1).
pub(super) fn add_spherical(sum: &mut Sparse, l: u32, m: i64, factor: &BigInt) {
    let order = u32::try_from(m.unsigned_abs()).unwrap_or(u32::MAX).min(l);
    let around = multiple_angle(order, m < 0);
    // 2^l·a_0 = 2^(l − m)·(l + m)!/(m! (l − m)!), which is 2^(l − m) times a product of binomial coefficients' factors.
    let mut coefficient = BigInt::from(1) << (l - order);
    for k in 1..=l + order {
        coefficient *= k;
    }
    for k in (1..=order).chain(1..=l - order) {
        coefficient /= k;
    }
    coefficient *= factor;
    for j in 0..=(l - order) / 2 {
        let height = l - order - 2 * j;
        let mut binomial = BigInt::from(1);
        for i in 0..=j {
            for (k, c) in &around {
                let exponents = [order - k + 2 * (j - i), k + 2 * i, height, 0];
                sum.add_term(exponents, c * &binomial * &coefficient);
            }
            binomial = binomial * (j - i) / (i + 1);
        }
        if height >= 2 {
            // The product is divisible by the divisor since all 2^l·a_j are integers.
            coefficient = -(coefficient * height * (height - 1)) / (4 * (j + 1) * (j + 1 + order));
        }
    }
}

#[cfg(test)]
mod tests {
    use num_bigint::BigInt;

    use super::{add_spherical, multiple_angle};
    use crate::proof::refusal::Checked;
    use crate::proof::sparse::Sparse;

    fn factorial(n: u32) -> BigInt {
        (1..=n).map(BigInt::from).product()
    }

    fn binomial(n: u32, k: u32) -> BigInt {
        factorial(n) / (factorial(k) * factorial(n - k))
    }

    /// 2^l·r^l·Y(l, m) by the formula of the page: the real or the imaginary part of (x + i y)^|m| times
    /// Σ_k (−1)^k C(l, k) C(2l − 2k, l) (l − 2k)!/(l − 2k − |m|)! z^(l − 2k − |m|) (x² + y² + z²)^k.
    fn by_definition(l: u32, m: i64) -> Checked<Sparse> {
        let order = u32::try_from(m.unsigned_abs()).unwrap();
        let mut around = Sparse::default();
        for (k, c) in multiple_angle(order, m < 0) {
            around.add_term([order - k, k, 0, 0], c);
        }
        let mut sum = Sparse::default();
        for k in 0..=(l - order) / 2 {
            let height = l - 2 * k - order;
            let c = binomial(l, k) * binomial(2 * l - 2 * k, l) * factorial(l - 2 * k)
                / factorial(height);
            let mut term = Sparse::default();
            term.add_term([0, 0, height, 0], if k % 2 == 0 { c } else { -c });
            let rho = Sparse::squared_radius(3).power(k)?;
            sum.add_multiple(&BigInt::from(1), &around.times(&term)?.times(&rho)?);
        }
        Ok(sum)
    }

    #[test]
    fn spherical_harmonics_are_those_of_the_page() {
        for l in 0..9 {
            for m in -i64::from(l)..=i64::from(l) {
                let mut found = Sparse::default();
                add_spherical(&mut found, l, m, &BigInt::from(1));
                assert_eq!(found, by_definition(l, m).unwrap(), "l = {l}, m = {m}");
            }
        }
    }
}
