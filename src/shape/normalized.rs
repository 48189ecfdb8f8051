//! Normalised spherical harmonics in doubles.

/// The harmonics of a direction: those of degree l and order m at l² + l + m, with the mean square 1 over the sphere.
#[derive(Debug)]
pub(crate) struct NormalizedHarmonics {
    degree: usize,
    /// The factors of the recurrence `P_l^m = a z P_(l−1)^m − b P_(l−2)^m`, by l and m.
    factors: Vec<[f64; 2]>,
    legendre: Vec<f64>,
}

impl NormalizedHarmonics {
    pub(crate) fn new(degree: usize) -> Self {
        let mut factors = Vec::new();
        for l in 0..=degree {
            for m in 0..=l {
                let (lf, mf) = (as_f64(l), as_f64(m));
                let factor = if m == l {
                    // P_m^m from P_(m−1)^(m−1), with √2 for the first cosine.
                    let double = if m == 1 { 2.0 } else { 1.0 };
                    let square = if m == 0 {
                        1.0
                    } else {
                        double * (2.0 * mf + 1.0) / (2.0 * mf)
                    };
                    [square.sqrt(), 0.0]
                } else {
                    let a = ((4.0 * lf * lf - 1.0) / (lf * lf - mf * mf)).sqrt();
                    let before = lf - 1.0;
                    let b = match l - 1 > m {
                        true => {
                            ((before * before - mf * mf) / (4.0 * before * before - 1.0)).sqrt()
                        }
                        false => 0.0,
                    };
                    [a, a * b]
                };
                factors.push(factor);
            }
        }
        Self {
            degree,
            legendre: vec![0.0; factors.len()],
            factors,
        }
    }

    fn at(l: usize, m: usize) -> usize {
        l * (l + 1) / 2 + m
    }

    /// The Legendre functions at z = cos φ, with (sin φ)^m, by [`Self::at`].
    pub(crate) fn latitude(&mut self, z: f64, sine: f64) -> &[f64] {
        for m in 0..=self.degree {
            let first = Self::at(m, m);
            let start = match m {
                0 => 1.0,
                _ => self.legendre[Self::at(m - 1, m - 1)] * self.factors[first][0] * sine,
            };
            self.legendre[first] = start;
            let (mut before, mut last) = (0.0, start);
            for l in m + 1..=self.degree {
                let at = Self::at(l, m);
                let [a, ab] = self.factors[at];
                let next = a * z * last - ab * before;
                (before, last) = (last, next);
                self.legendre[at] = next;
            }
        }
        &self.legendre
    }

    /// All harmonics in a direction.
    pub(crate) fn values(&mut self, [x, y, z]: [f64; 3], out: &mut [f64]) {
        let sine = x.hypot(y);
        let (c, s) = if sine > 0.0 {
            (x / sine, y / sine)
        } else {
            (1.0, 0.0)
        };
        let degree = self.degree;
        let legendre = self.latitude(z, sine);
        let (mut cos, mut sin) = (1.0, 0.0);
        for m in 0..=degree {
            for l in m..=degree {
                let value = legendre[Self::at(l, m)];
                out[l * l + l + m] = value * cos;
                if m > 0 {
                    out[l * l + l - m] = value * sin;
                }
            }
            (cos, sin) = (cos * c - sin * s, cos * s + sin * c);
        }
    }
}

/// The factor by which the normalised harmonic is larger than Y(l, m): √((2 − δ)(2l + 1)(l − m)!/(l + m)!).
pub(crate) fn harmonic_norm(l: usize, order: usize) -> f64 {
    let mut square = as_f64(2 * l + 1) * if order == 0 { 1.0 } else { 2.0 };
    for k in l - order + 1..=l + order {
        square /= as_f64(k);
    }
    square.sqrt()
}

#[expect(clippy::cast_precision_loss, reason = "degrees and counts are small")]
fn as_f64(n: usize) -> f64 {
    n as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::shape::{HarmonicPair, HarmonicSurface};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]
        /// A normalised harmonic is its norm times the exact unnormalised one.
        #[test]
        fn harmonics_are_the_exact_ones(l in 0usize..13, order in 0usize..13, p in -20i64..20, q in -20i64..20) {
            let order = order % (l + 1);
            let n = Rational::from(p * p + q * q + 100);
            let unit = [20 * p, 20 * q, p * p + q * q - 100].map(|x| Rational::from(x) / &n);
            let near = unit.each_ref().map(Rational::to_f64);
            let mut values = vec![0.0; (l + 1) * (l + 1)];
            NormalizedHarmonics::new(l).values(near, &mut values);
            for m in [order.cast_signed(), -order.cast_signed()] {
                let surface = HarmonicSurface::new([((l, m), Rational::one())]).unwrap();
                let exact = HarmonicPair::new(&surface).value(&unit).to_f64() * harmonic_norm(l, order);
                let found = values[(l * l + l).checked_add_signed(m).unwrap()];
                prop_assert!((found - exact).abs() <= 1e-12 * (1.0 + exact.abs()));
            }
        }
    }
}
