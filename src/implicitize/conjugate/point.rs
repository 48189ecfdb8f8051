//! The point of a zero, to hundreds of bits.

use malachite::Integer;

use super::expansion::{COVER, Inverted};
use super::search::{MAX_CONTRACTION, Zero, log_distance};
use crate::exact::Rational;
use crate::implicitize::enclosure::{Enclosure, Precision};

/// The bits after the point, and the accuracy of log z that is reached with them.
const PRECISION: Precision = Precision { bits: 272 };
const ACCURACY: f64 = f64::from_bits((1023 - 220) << 52);

/// The most steps; each gains about 45 bits.
const MAX_STEPS: usize = 9;

/// Two coordinates Σ (a_k cos kt + b_k sin kt), each by the lists of a_k and b_k.
pub(super) type Lists = [[Vec<Rational>; 2]; 2];

/// A complex number.
#[derive(Clone, Debug)]
struct Complex {
    re: Enclosure,
    im: Enclosure,
}

impl Complex {
    fn times(&self, other: &Self) -> Self {
        let product = |a, b| PRECISION.times(a, b);
        Self {
            re: product(&self.re, &other.re).minus(&product(&self.im, &other.im)),
            im: product(&self.re, &other.im).plus(&product(&self.im, &other.re)),
        }
    }
}

/// The coefficients of two coordinates, enclosed.
pub(super) struct EnclosedLists(Vec<[[Enclosure; 2]; 2]>);

impl EnclosedLists {
    pub(super) fn new(lists: &Lists) -> Self {
        let [[x, _], [y, _]] = lists;
        let len = x.len().max(y.len());
        let entry = |list: &Vec<Rational>, k: usize| {
            list.get(k)
                .map_or_else(Enclosure::zero, |c| PRECISION.rational(c))
        };
        let waves = (0..len).map(|k| {
            lists
                .each_ref()
                .map(|[cos, sin]| [entry(cos, k), entry(sin, k)])
        });
        Self(waves.collect())
    }

    /// Twice the two coordinates at z; `None` if z may be 0.
    fn at(&self, z: &Complex) -> Option<[Complex; 2]> {
        let square = PRECISION
            .times(&z.re, &z.re)
            .plus(&PRECISION.times(&z.im, &z.im));
        let inverse = Complex {
            re: PRECISION.over(&z.re, &square)?,
            im: PRECISION.over(&Enclosure::zero().minus(&z.im), &square)?,
        };
        let zero = || Complex {
            re: Enclosure::zero(),
            im: Enclosure::zero(),
        };
        let one = || Complex {
            re: PRECISION.integer(&1.into()),
            im: Enclosure::zero(),
        };
        let (mut up, mut down, mut sums) = (one(), one(), [zero(), zero()]);
        for (k, wave) in self.0.iter().enumerate() {
            if k > 0 {
                up = up.times(z);
                down = down.times(&inverse);
            }
            let [plus_re, plus_im] = [up.re.plus(&down.re), up.im.plus(&down.im)];
            let [minus_re, minus_im] = [up.re.minus(&down.re), up.im.minus(&down.im)];
            for (sum, [a, b]) in sums.iter_mut().zip(wave) {
                // (a − ib) z^k + (a + ib) z^(−k)
                let product = |c, part| PRECISION.times(c, part);
                sum.re = sum
                    .re
                    .plus(&product(a, &plus_re))
                    .plus(&product(b, &minus_im));
                sum.im = sum
                    .im
                    .plus(&product(a, &plus_im))
                    .minus(&product(b, &minus_re));
            }
        }
        Some(sums)
    }
}

/// The number z of a zero, as a double, and bounds of both coordinates there.
pub(super) struct Point {
    pub(super) z: nalgebra::Complex<f64>,
    pub(super) bounds: [[Rational; 2]; 2],
}

/// The point of a zero; `None` if the accuracy is not reached.
///
/// Lemma 7. For Z in the disk of the zero at z with the contraction κ ≤ 1/2, |log(Z/z)| ≤ 2 |G(Z)|.
/// Proof. G is 0 at the zero, so |G(ζ) − (ζ − ζ₀)| ≤ κ |ζ − ζ₀|.
pub(super) fn point(lists: &EnclosedLists, zero: &Zero) -> Option<Point> {
    let inverted = Inverted::new(&zero.expansions);
    let unit = Rational::whole(Integer::from(1) << PRECISION.bits);
    let fixed = |x: f64| Some((Rational::try_from(x).ok()? * &unit).floor_integer());
    let mut z = [fixed(zero.z.re)?, fixed(zero.z.im)?];
    for _ in 0..MAX_STEPS {
        let [re, im] = z.each_ref().map(Enclosure::fixed);
        let values = lists.at(&Complex { re, im })?;
        let bounds = values.each_ref().map(|v| PRECISION.bounds(&v.im));
        let sizes = bounds
            .each_ref()
            .map(|[low, high]| low.abs().max(high.abs()));
        let size = sizes[0].to_f64().hypot(sizes[1].to_f64());
        let error = inverted.norm * size / (1.0 - MAX_CONTRACTION) * COVER;
        if error <= ACCURACY {
            let [re, im] = z
                .each_ref()
                .map(|part| (Rational::whole(part) / &unit).to_f64());
            let near = nalgebra::Complex::new(re, im);
            // The distance is never NaN.
            if log_distance(near, zero.z) > zero.reach {
                return None;
            }
            let mut found = values.iter().zip(zero.slopes).map(|(value, slope)| {
                let error = Rational::try_from(slope * error * COVER).ok()?;
                let [low, high] = PRECISION.bounds(&value.re);
                Some([low - &error, high + &error].map(|twice| twice / Rational::from(2)))
            });
            let bounds = [found.next()??, found.next()??];
            return Some(Point { z: near, bounds });
        }
        let middles = bounds.map(|[low, high]| ((low + high) / Rational::from(2)).to_f64());
        let step = inverted.step_for(middles);
        let [re, im] = [fixed(step.re)?, fixed(step.im)?];
        // z (1 + ζ)
        z = [
            &z[0] + ((&z[0] * &re - &z[1] * &im) >> PRECISION.bits),
            &z[1] + ((&z[0] * &im + &z[1] * &re) >> PRECISION.bits),
        ];
    }
    None
}
