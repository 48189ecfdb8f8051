//! The nearest point of a harmonic surface in exact arithmetic.

use malachite::Integer;
use malachite::base::num::basic::traits::{One, Zero};

use super::cells::{CellTree, Isolated, NearestOnSphere};
use crate::error::Invariant;
use crate::exact::{Dyadic, Rational};
use crate::intervals::rational;
use crate::poly::{TernaryForm, with_integers};
use crate::shape::{HarmonicPair, HarmonicSurface};

/// The parameters of the nearest direction have so many bits after the point, in turn.
const STEP_BITS: [i64; 6] = [96, 128, 192, 256, 320, 400];
/// Bounds of the squared distance that do not decide whether the point is within the tolerance are refined until they differ by less than
/// this part, 2^(−220).
const ENOUGH: i64 = -220;
/// Simple directions are sought so near to the one in doubles: within 2^(−26).
const SIMPLE: i64 = -26;

/// A harmonic surface for exact values.
#[derive(Debug)]
pub(super) struct ExactSurface {
    surface: HarmonicSurface,
    pair: HarmonicPair,
}

/// A unit vector with rational coordinates, and R and its gradient along the sphere there.
struct Place {
    direction: [Rational; 3],
    radius: Rational,
    gradient: [Rational; 3],
}

/// What bounds of a squared distance shall determine.
#[derive(Debug)]
pub(super) struct RefinementGoal {
    /// They differ by at most this part;
    part: Rational,
    /// and they are on one side of this level, the squared tolerance.
    level: Rational,
    /// Or else they differ by at most this part.
    smallest: Rational,
}

impl RefinementGoal {
    /// The goal for bounds that differ by at most a part, and for the squared tolerance.
    pub(super) fn new(relative: f64, level: Rational) -> Self {
        Self {
            part: rational(relative),
            level,
            smallest: Rational::from(2).pow(ENOUGH).invariant("two is not 0"),
        }
    }

    fn is_met(&self, [low, high]: &[Rational; 2]) -> bool {
        let width = high - low;
        let is_decided = *high <= self.level || *low > self.level;
        let part = if is_decided {
            &self.part
        } else {
            &self.smallest
        };
        width <= high * part
    }
}

impl ExactSurface {
    pub(super) fn new(surface: &HarmonicSurface, pair: HarmonicPair) -> Self {
        Self {
            surface: surface.clone(),
            pair,
        }
    }

    pub(super) fn center(&self) -> &[Rational; 3] {
        self.surface.center()
    }

    /// The mean of R.
    pub(super) fn mean(&self) -> &Rational {
        self.surface.coefficient(0, 0)
    }

    fn relative(&self, point: &[Rational; 3]) -> [Rational; 3] {
        std::array::from_fn(|i| &point[i] - &self.center()[i])
    }

    /// The sign of ρ − R(p/ρ) for a point p at the distance ρ from the center, and −1 for the center, where R > 0.
    pub(super) fn side(&self, point: &[Rational; 3]) -> i8 {
        let p = self.relative(point);
        if p.iter().all(Rational::is_zero) {
            return -1;
        }
        self.sign_of_difference(&p)
    }

    /// Whether a point that is not the center is on the surface: R(p/ρ) = ρ or R(−p/ρ) = −ρ.
    pub(super) fn is_on(&self, point: &[Rational; 3]) -> bool {
        let p = self.relative(point);
        if p.iter().all(Rational::is_zero) {
            return false;
        }
        // −(ρ + R(−p/ρ)) is the difference for −p and the surface with −R.
        let opposite = p.each_ref().map(|x| -x);
        self.sign_of_difference(&p) == 0 || self.sign_of_sum(&opposite) == 0
    }

    fn sign_of_difference(&self, p: &[Rational; 3]) -> i8 {
        let [rational, irrational, square] = self.in_powers(p);
        sign_of(&rational, &irrational, &square)
    }

    fn sign_of_sum(&self, p: &[Rational; 3]) -> i8 {
        let [rational, irrational, square] = self.in_powers(p);
        // ρ^L (ρ + R): all but the power of ρ changes its sign.
        let power = square
            .pow(i64::try_from(self.surface.degree().div_ceil(2)).invariant("a degree is small"));
        let twice = power.invariant("a point that is not the center") * Rational::from(2);
        match self.surface.degree() % 2 {
            0 => sign_of(&-rational, &(twice - irrational), &square),
            _ => sign_of(&(twice - rational), &-irrational, &square),
        }
    }

    /// ρ^L (ρ − R(p/ρ)) as E + Oρ: the rational numbers E, O and ρ².
    ///
    /// With the forms of degrees L and L − 1 it is `ρ^(L+1) − (form of degree L) − ρ (form of degree L − 1)`.
    fn in_powers(&self, p: &[Rational; 3]) -> [Rational; 3] {
        let square: Rational = p.iter().map(|x| x * x).sum();
        let degree = self.surface.degree();
        let value = |form: &TernaryForm| {
            let (vector, below) = integers(p);
            let below = self.pair.unit() * power(&below, form.degree());
            Rational::from_integers(form.evaluate(&vector), below)
                .invariant("a denominator is not 0")
        };
        let even = value(self.pair.even());
        let odd = self.pair.odd().map_or_else(Rational::zero, value);
        let half = i64::try_from(degree.div_ceil(2)).invariant("a degree is small");
        let top = square.pow(half).invariant("the exponent is not negative");
        if degree.is_multiple_of(2) {
            [-even, top - odd, square]
        } else {
            [top - odd, -even, square]
        }
    }

    /// Whether some point of the surface in a simple direction is at least as far from a point as the square root of `level`.
    pub(super) fn goes_beyond(&self, point: &[Rational; 3], level: &Rational) -> bool {
        let p = self.relative(point);
        let axes = (0..6).map(|k| {
            std::array::from_fn(|i| match (i == k / 2, k % 2) {
                (true, 0) => Rational::one(),
                (true, _) => Rational::from(-1),
                (false, _) => Rational::zero(),
            })
        });
        let away = simple_direction(&p.each_ref().map(|x| -x.to_f64()), SIMPLE);
        axes.chain(away).any(|d: [Rational; 3]| {
            let r = self.pair.value(&d);
            squared_distance(&d, &r, &p) >= *level
        })
    }

    /// Bounds of the squared distance of a point from the surface: the second one is the squared distance of some point of the surface.
    /// They are equal if the nearest point is in a simple rational direction.
    ///
    /// **Lemma.** Let q be a direction in a rectangle of angles on which half the second derivatives of the squared distance f are at least λ in
    /// all directions, and g half its gradient along the sphere at q. Then f ≥ f(q) − |g|²/λ on the rectangle.
    ///
    /// Proof. f(q + v) ≥ f(q) + 2g·v + λ|v|², since a derivative by θ is at most the one along the sphere.
    ///
    /// Law: `refined_distances_are_those_of_the_equation`.
    pub(super) fn refine(
        &self,
        cells: &CellTree,
        near: [f64; 3],
        slack: f64,
        found: &NearestOnSphere,
        point: &[Rational; 3],
        goal: &RefinementGoal,
    ) -> Option<[Rational; 2]> {
        let isolated = cells.isolate(near, slack, found)?;
        let outside = Rational::try_from(isolated.outside).ok()?;
        let outside = &outside * &outside;
        let curvature = Rational::try_from(isolated.curvature).ok()?;
        let p = self.relative(point);
        let mut best: Option<[Rational; 2]> = None;
        let mut take = |place: &Place| {
            let high = squared_distance(&place.direction, &place.radius, &p);
            let gradient = half_gradient(place, &p);
            let lost = gradient.iter().map(|x| x * x).sum::<Rational>() / &curvature;
            let low = (&high - &lost).max(Rational::zero()).min(outside.clone());
            let bounds = match best.take() {
                Some([l, h]) => [l.max(low), h.min(high)],
                None => [low, high],
            };
            let is_enough = lost.is_zero() || goal.is_met(&bounds);
            best = Some(bounds);
            (gradient, is_enough)
        };
        let mut direction = isolated.direction;
        let simple = simple_direction(&direction, SIMPLE);
        if let Some(simple) = simple
            && isolated.holds(&simple.each_ref().map(Rational::to_f64))
        {
            let (_, is_enough) = take(&self.place(simple));
            if is_enough {
                return best;
            }
        }
        let mut exact = near_direction(
            &direction.map(|x| Rational::try_from(x).unwrap_or_else(|_| Rational::zero())),
            STEP_BITS[0],
        );
        for bits in STEP_BITS {
            direction = exact.each_ref().map(Rational::to_f64);
            if !isolated.holds(&direction) {
                break;
            }
            let (gradient, is_enough) = take(&self.place(exact.clone()));
            if is_enough {
                break;
            }
            let step = isolated.step(&gradient);
            let moved = std::array::from_fn(|i| &exact[i] + &step[i]);
            exact = near_direction(&moved, bits);
        }
        best
    }

    fn place(&self, direction: [Rational; 3]) -> Place {
        let (vector, below) = integers(&direction);
        let mut radius = Rational::zero();
        let mut gradient: [Rational; 3] = std::array::from_fn(|_| Rational::zero());
        for form in self.pair.odd().into_iter().chain([self.pair.even()]) {
            let degree = form.degree();
            let (value, slopes) = value_and_gradient(form, &vector);
            let unit = self.pair.unit() * power(&below, degree);
            let over = |c: Integer, d: &Integer| {
                Rational::from_integers(c, d.clone()).invariant("a denominator is not 0")
            };
            let value = over(value, &unit);
            let outward = &value * &Rational::whole(Integer::from(degree));
            for i in 0..3 {
                // The gradient has the degree d − 1.
                let slope = over(&slopes[i] * &below, &unit);
                gradient[i] = &gradient[i] + slope - &outward * &direction[i];
            }
            radius = radius + value;
        }
        Place {
            direction,
            radius,
            gradient,
        }
    }
}

impl Isolated {
    /// A step of Newton's method for half the gradient of the squared distance along the sphere, with the second derivatives in doubles.
    fn step(&self, gradient: &[Rational; 3]) -> [Rational; 3] {
        // Powers of two keep small gradients in the range of doubles.
        let size = gradient
            .iter()
            .map(Rational::abs)
            .max()
            .unwrap_or_else(Rational::zero);
        if size.is_zero() {
            return std::array::from_fn(|_| Rational::zero());
        }
        let scaled = gradient.each_ref().map(|x| (x / &size).to_f64());
        let step = self.step_of(&scaled);
        step.map(|x| Rational::try_from(x).map_or_else(|_| Rational::zero(), |x| x * &size))
    }
}

/// The sign of E + Oρ, with ρ² given.
fn sign_of(rational: &Rational, irrational: &Rational, square: &Rational) -> i8 {
    match (rational.signum(), irrational.signum()) {
        (e, 0) => e,
        (0, o) => o,
        (e, o) if e == o => e,
        (e, o) => match (rational * rational).cmp(&(irrational * irrational * square)) {
            std::cmp::Ordering::Greater => e,
            std::cmp::Ordering::Less => o,
            std::cmp::Ordering::Equal => 0,
        },
    }
}

fn squared_distance(direction: &[Rational; 3], radius: &Rational, p: &[Rational; 3]) -> Rational {
    (0..3)
        .map(|i| {
            let off = &direction[i] * radius - &p[i];
            &off * &off
        })
        .sum()
}

/// Half the gradient of |Rd − p|² along the sphere: (R − d·p)∇R − R(p − (d·p)d).
fn half_gradient(place: &Place, p: &[Rational; 3]) -> [Rational; 3] {
    let d = &place.direction;
    let along: Rational = (0..3).map(|i| &d[i] * &p[i]).sum();
    let ahead = &place.radius - &along;
    std::array::from_fn(|i| {
        let aside = &p[i] - &along * &d[i];
        &ahead * &place.gradient[i] - &place.radius * aside
    })
}

/// The value and the gradient of a form at a vector (x, y, z): Σ xⁱ G_i(y, z) and its derivatives, by Horner's rule in x.
fn value_and_gradient(form: &TernaryForm, vector: &[Integer; 3]) -> (Integer, [Integer; 3]) {
    let degree = form.degree();
    let [x, y, z] = vector;
    let powers = |x: &Integer| {
        let all = std::iter::successors(Some(Integer::ONE), |power| Some(power * x));
        all.take(degree + 1).collect::<Vec<_>>()
    };
    let (of_y, of_z) = (powers(y), powers(z));
    let products = of_y.iter().enumerate();
    let products: Vec<Vec<Integer>> = products
        .map(|(j, y)| of_z[..=degree - j].iter().map(|z| y * z).collect())
        .collect();
    // G_i and its derivatives by y and z
    let mut parts = vec![[Integer::ZERO; 3]; degree + 1];
    for ([i, j, k], c) in form.terms() {
        let [g, by_y, by_z] = &mut parts[i];
        *g += c * &products[j][k];
        if j > 0 {
            *by_y += c * Integer::from(j) * &products[j - 1][k];
        }
        if k > 0 {
            *by_z += c * Integer::from(k) * &products[j][k - 1];
        }
    }
    let mut value = Integer::ZERO;
    let mut gradient = [Integer::ZERO; 3];
    for [g, by_y, by_z] in parts.into_iter().rev() {
        // (xF)′ = xF′ + F
        gradient[0] = &gradient[0] * x + &value;
        value = value * x + g;
        gradient[1] = &gradient[1] * x + by_y;
        gradient[2] = &gradient[2] * x + by_z;
    }
    (value, gradient)
}

/// A vector as integers over one denominator.
fn integers(vector: &[Rational; 3]) -> ([Integer; 3], Integer) {
    let (scaled, below) = with_integers(vector);
    let mut list = malachite::base::polynomial::Polynomial::into_coefficients_asc(scaled);
    list.resize(3, Integer::ZERO);
    (
        list.try_into().invariant("a vector has three coordinates"),
        below,
    )
}

fn power(x: &Integer, exponent: usize) -> Integer {
    use malachite::base::num::arithmetic::traits::Pow;
    x.pow(exponent as u64)
}

/// The rational unit vector `(2s, 2t, 1 − s² − t²)/(1 + s² + t²)` for parameters made from s = v₁/(|v| + v₃) and t = v₂/(|v| + v₃), where the
/// third coordinate is the largest one; `None` for no direction.
fn by_parameters(
    v: &[Rational; 3],
    length: &Rational,
    made: impl Fn(&Rational) -> Rational,
) -> Option<[Rational; 3]> {
    let last = (0..3).max_by_key(|i| v[*i].abs())?;
    let sign = Rational::from(i32::from(v[last].signum()));
    let below = (length + v[last].abs()).recip()?;
    let [a, b] = [(last + 1) % 3, (last + 2) % 3];
    let [s, t] = [a, b].map(|i| made(&(&v[i] * &below)));
    let squares = &s * &s + &t * &t;
    let weight = (Rational::one() + &squares).recip()?;
    let mut unit: [Rational; 3] = std::array::from_fn(|_| Rational::zero());
    unit[a] = s * Rational::from(2) * &weight;
    unit[b] = t * Rational::from(2) * &weight;
    unit[last] = sign * (Rational::one() - squares) * weight;
    Some(unit)
}

/// The direction of a vector of length nearly 1, with parameters of this many bits after the point.
fn near_direction(v: &[Rational; 3], bits: i64) -> [Rational; 3] {
    let square: Rational = v.iter().map(|x| x * x).sum();
    // √(1 + ε) is 1 + ε/2 − ε²/8 up to ε³/16.
    let off = square - Rational::one();
    let length = Rational::one() + &off / Rational::from(2) - &off * &off / Rational::from(8);
    let unit = Rational::from(2).pow(bits).invariant("two is not 0");
    let made = |s: &Rational| Dyadic::new((s * &unit).floor_integer(), -bits).to_rational();
    by_parameters(v, &length, made).invariant("a direction is not 0")
}

/// A direction with simple parameters near that of a vector, whose parameters differ by less than a power of two.
fn simple_direction(v: &[f64; 3], exponent: i64) -> Option<[Rational; 3]> {
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let unit = v.map(|x| Rational::try_from(x / length).ok());
    let [Some(a), Some(b), Some(c)] = unit else {
        return None;
    };
    let off = Rational::from(2).pow(exponent)?;
    let made = |s: &Rational| Rational::simplest_between(&(s - &off), &(s + &off));
    by_parameters(&[a, b, c], &Rational::one(), made)
}
