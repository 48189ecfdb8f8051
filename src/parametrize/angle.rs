//! Exact angles, and ranges of angles.

use std::cmp::Ordering;

use crate::exact::{Rational, arctangent, pi};
use crate::poly::IntegerPolynomial;
use crate::roots::RealRoot;
use malachite::Integer;
use malachite::base::polynomial::Polynomial;

/// An exact angle.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum ExactAngle {
    /// A rational multiple of π.
    Pi(Rational),
    /// The angle `times · arctan t + half_turns · π`, for a real root t of a polynomial.
    Arctangent {
        /// The root t.
        tangent: RealRoot,
        /// The rational value of t, if it has one.
        rational: Option<Rational>,
        /// The factor: 1, or 2 if t is the tangent of half the angle.
        times: i32,
        /// The number of half turns that are added.
        half_turns: i32,
    },
}

/// The minimal polynomials (ascending) of tan(jπ/24), as far as they are at most quadratic, with the numbers j in [0, 24) that
/// belong to their roots.
const SPECIAL_TANGENTS: [(&[i64], &[i32]); 9] = [
    (&[0, 1], &[0]),
    (&[-1, 1], &[6]),
    (&[1, 1], &[18]),
    (&[-3, 0, 1], &[8, 16]),
    (&[-1, 0, 3], &[4, 20]),
    (&[-1, 2, 1], &[3, 15]),
    (&[-1, -2, 1], &[9, 21]),
    (&[1, -4, 1], &[2, 10]),
    (&[1, 4, 1], &[14, 22]),
];

impl ExactAngle {
    /// The angle 0.
    #[must_use]
    pub fn zero() -> Self {
        Self::Pi(Rational::zero())
    }

    /// The angle π.
    #[must_use]
    pub fn pi() -> Self {
        Self::Pi(Rational::one())
    }

    /// The exact order of this angle and π.
    #[must_use]
    pub fn cmp_pi(&self) -> Ordering {
        match self {
            Self::Pi(q) => q.cmp(&Rational::one()),
            // times·arctan t is strictly between −π and π.
            Self::Arctangent {
                tangent,
                half_turns,
                ..
            } => half_turns.cmp(&1).then(tangent.signum().cmp(&0)),
        }
    }

    /// The exact order of this angle and another one.
    ///
    /// If bounds do not separate the angles soon, algebra decides whether they differ by a multiple of π or of a part of π
    /// (`spacing`). If they do, they are equal as soon as the bounds show that they are closer than that; if they do not, they
    /// are different, and narrower bounds will separate them.
    ///
    /// Cost: a gcd of the polynomials of both tangents, of degrees m and n, or in the worst case of degrees m and 2n; then
    /// bounds with as many bits as necessary.
    #[must_use]
    pub fn compare(&self, other: &Self) -> Ordering {
        if let (Self::Pi(a), Self::Pi(b)) = (self, other) {
            return a.cmp(b);
        }
        let mut bits = 64;
        let mut spacing: Option<Option<Rational>> = None;
        loop {
            let ((low, high), (other_low, other_high)) = (self.bounds(bits), other.bounds(bits));
            if high < other_low {
                return Ordering::Less;
            }
            if other_high < low {
                return Ordering::Greater;
            }
            if let Some(spacing) = spacing.get_or_insert_with(|| self.spacing(other)) {
                // The bounds overlap, so the difference is at most the distance between the outer bounds.
                let most = (high - &other_low).max(other_high - &low);
                if most < *spacing {
                    return Ordering::Equal;
                }
            }
            bits *= 2;
        }
    }

    /// The angle in [0, π) with the given tangent.
    #[must_use]
    pub fn of_tangent(tangent: RealRoot) -> Self {
        if let Some(j) = special(&tangent) {
            return Self::Pi(Rational::from(j) / Rational::from(24));
        }
        let half_turns = i32::from(tangent.signum() < 0);
        Self::Arctangent {
            rational: tangent.as_rational(),
            tangent,
            times: 1,
            half_turns,
        }
    }

    /// The angle in [0, 2π) other than π whose half has the given tangent.
    #[must_use]
    pub fn of_half_tangent(tangent: RealRoot) -> Self {
        if let Some(j) = special(&tangent) {
            return Self::Pi(Rational::from(j) / Rational::from(12));
        }
        let half_turns = if tangent.signum() < 0 { 2 } else { 0 };
        Self::Arctangent {
            rational: tangent.as_rational(),
            tangent,
            times: 2,
            half_turns,
        }
    }

    /// The angle plus π.
    #[must_use]
    pub fn plus_pi(&self) -> Self {
        match self {
            Self::Pi(q) => Self::Pi(q + &Rational::one()),
            Self::Arctangent {
                tangent,
                rational,
                times,
                half_turns,
            } => Self::Arctangent {
                tangent: tangent.clone(),
                rational: rational.clone(),
                times: *times,
                half_turns: half_turns + 1,
            },
        }
    }

    /// Certified decimals: the angle, rounded to `digits` places after the point.
    ///
    /// Bounds are narrowed until both are rounded to the same decimals. That ends, because the angle is 0 or transcendental
    /// (Lindemann).
    #[must_use]
    pub fn to_decimal(&self, digits: u32) -> String {
        let mut bits = digits * 4 + 16;
        loop {
            let (low, high) = self.bounds(bits);
            let (a, b) = (low.to_decimal(digits), high.to_decimal(digits));
            if a == b {
                return a;
            }
            bits *= 2;
        }
    }

    /// Certified bounds, about 2^−`bits` apart.
    pub(super) fn bounds(&self, bits: u32) -> (Rational, Rational) {
        let times_pi = |q: &Rational| {
            let (low, high) = pi(bits + 8);
            if q.is_zero() {
                (Rational::zero(), Rational::zero())
            } else {
                (low * q, high * q)
            }
        };
        match self {
            Self::Pi(q) => times_pi(q),
            Self::Arctangent {
                tangent,
                times,
                half_turns,
                ..
            } => {
                let mut root = tangent.clone();
                root.refine(i64::from(bits) + 4);
                let (t_low, t_high) = root.enclosure();
                let times = Rational::from(*times);
                let (low, high) = times_pi(&Rational::from(*half_turns));
                (
                    low + arctangent(&t_low.to_rational(), bits + 8).0 * &times,
                    high + arctangent(&t_high.to_rational(), bits + 8).1 * times,
                )
            }
        }
    }

    /// A closed form such as `3*pi/4` or `pi + atan(1/2)`, if there is a simple one.
    #[must_use]
    pub fn closed_form(&self) -> Option<String> {
        match self {
            Self::Pi(q) => Some(multiple_of_pi(q)),
            Self::Arctangent {
                rational,
                times,
                half_turns,
                ..
            } => {
                let t = rational.as_ref()?;
                let factor = if *times == 1 {
                    String::new()
                } else {
                    format!("{times}*")
                };
                let arctangent = if t.signum() < 0 {
                    format!("- {factor}atan({})", t.abs())
                } else {
                    format!("+ {factor}atan({t})")
                };
                Some(match half_turns {
                    0 => arctangent.trim_start_matches("+ ").to_string(),
                    n => format!("{} {arctangent}", multiple_of_pi(&Rational::from(*n))),
                })
            }
        }
    }

    /// An exact description: the closed form, or the polynomial of the tangent and an interval that holds it.
    #[must_use]
    pub fn describe(&self) -> String {
        if let Some(nice) = self.closed_form() {
            return nice;
        }
        let Self::Arctangent {
            tangent,
            times,
            half_turns,
            ..
        } = self
        else {
            return String::new();
        };
        let factor = if *times == 1 {
            String::new()
        } else {
            format!("{times}*")
        };
        let turns = match half_turns {
            0 => String::new(),
            n => format!("{} + ", multiple_of_pi(&Rational::from(*n))),
        };
        let mut root = tangent.clone();
        root.refine(20);
        let (low, high) = root.enclosure();
        format!(
            "{turns}{factor}atan(t) with {} = 0, {} < t < {}",
            tangent.polynomial().to_string().replace('x', "t"),
            low.to_rational(),
            high.to_rational()
        )
    }
}

fn multiple_of_pi(q: &Rational) -> String {
    let (p, over) = (q.numerator(), q.denominator());
    let numerator = if p == 1 {
        "pi".into()
    } else {
        format!("{p}*pi")
    };
    match (q.is_zero(), q.is_integer()) {
        (true, _) => "0".into(),
        (_, true) => numerator,
        _ => format!("{numerator}/{over}"),
    }
}

/// The number j in [0, 24) with tan(jπ/24) = t, if the table has one.
fn special(t: &RealRoot) -> Option<i32> {
    SPECIAL_TANGENTS
        .iter()
        .find_map(|(coefficients, multiples)| {
            let integers = coefficients.iter().map(|&c| Integer::from(c)).collect();
            let polynomial = IntegerPolynomial::from_coefficients_asc(integers);
            if !t.is_root_of(&polynomial) {
                return None;
            }
            let nearest =
                |j: &&i32| (f64::from(**j) * std::f64::consts::PI / 24.0).tan() - t.to_f64();
            let closest = |a: &&i32, b: &&i32| nearest(a).abs().total_cmp(&nearest(b).abs());
            multiples.iter().min_by(closest).copied()
        })
}

/// An interval of angles within [0, 2π].
#[derive(Clone, Debug)]
pub struct AngleRange {
    /// The lower end of the range.
    pub from: ExactAngle,
    /// The upper end of the range; it is equal to the lower end for an isolated angle.
    pub to: ExactAngle,
    /// For each end, whether it belongs to the range.
    pub closed: [bool; 2],
}

impl AngleRange {
    /// The full circle [0, 2π].
    #[must_use]
    pub fn full_circle() -> Self {
        Self {
            from: ExactAngle::zero(),
            to: ExactAngle::Pi(Rational::from(2)),
            closed: [true, true],
        }
    }

    /// Whether the range is the full circle.
    pub(crate) fn is_full_circle(&self) -> bool {
        let is = |angle: &ExactAngle, n: i32| matches!(angle, ExactAngle::Pi(q) if *q == Rational::from(n));
        self.closed == [true, true] && is(&self.from, 0) && is(&self.to, 2)
    }

    /// Whether the range is a single angle.
    #[must_use]
    pub fn is_point(&self) -> bool {
        self.closed == [true, true] && self.from.describe() == self.to.describe()
    }

    /// The isolated angle [θ, θ].
    #[must_use]
    pub fn point(angle: ExactAngle) -> Self {
        Self {
            from: angle.clone(),
            to: angle,
            closed: [true, true],
        }
    }
}
