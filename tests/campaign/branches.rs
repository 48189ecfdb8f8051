//! Branches of curves and surfaces: in exact directions as many are real, and as many positive, as Sturm counts.

use std::time::Duration;

use num_bigint::BigInt;
use num_traits::{Signed, Zero};
use stellate::limits::Limits;
use stellate::parametrize::{AngleRange, ExactAngle, parametrize, parametrize_surface};
use stellate::sample::{Direction, SpaceDirection};
use stellate::shape::{ImplicitCurve, ImplicitSurface};

use super::angles::{arctangent_bounds, pi_bounds};
use super::draw::Draw;
use super::exact::{Q, Sturm, tower, value, whole};
use super::harness::Outcome;
use super::rays::{along, integer_vector, near, roots_along, way_of_half_tangent};
use super::roots::decimal;
use super::terms::{Terms, random};

/// The digits to which the ends of ranges are compared with a direction.
const DIGITS: u32 = 50;

/// The order of an end and the angle 2 atan t in [0, 2π); `None` if they agree in all digits.
fn is_below(end: &ExactAngle, angle: &[Q; 2]) -> Option<bool> {
    let end = decimal(&end.to_decimal(DIGITS));
    let close = Q::new(1.into(), BigInt::from(10).pow(DIGITS - 1));
    if &end + &close < angle[0] {
        Some(true)
    } else if &end - &close > angle[1] {
        Some(false)
    } else {
        None
    }
}

fn angle_of(t: &Q) -> [Q; 2] {
    let [low, high] = arctangent_bounds(t, 220).map(|a| a * whole(2));
    if t.is_negative() {
        let [a, b] = pi_bounds(220).map(|p| p * whole(2));
        [a + low, b + high]
    } else {
        [low, high]
    }
}

/// Whether the angle 2 atan t is in one of the ranges; `None` at the end of one.
pub(crate) fn is_in(ranges: &[AngleRange], t: &Q) -> Option<bool> {
    let angle = angle_of(t);
    let mut inside = false;
    for range in ranges {
        let full = t.is_zero() && range.closed == [true, true] && !range.is_point();
        if full && range.from.to_decimal(3) == "0.000" && range.to.to_decimal(3) == "6.283" {
            return Some(true);
        }
        inside |= is_below(&range.from, &angle)? && !is_below(&range.to, &angle)?;
    }
    Some(inside)
}

/// Sums of a few forms, so that all lemmas have their turn; or any polynomial; or a product.
fn curve(draw: &mut Draw) -> Terms<2> {
    let size = draw.pick(&[2i64, 6, 60]);
    let form = |draw: &mut Draw, degree: u32| {
        let terms = (0..=degree).map(|k| ([degree - k, k], BigInt::from(draw.small(size))));
        Terms::<2>::new(terms.collect::<Vec<_>>())
    };
    let sum = |draw: &mut Draw| {
        let step = 1 + draw.below(3) as u32;
        let count = 2 + draw.below(4) as u32;
        let low = draw.below(2) as u32;
        (0..count).fold(Terms::default(), |f: Terms<2>, k| {
            let degree = low + k * step;
            if degree > 7 {
                f
            } else {
                f.plus(&form(draw, degree))
            }
        })
    };
    match draw.below(5) {
        0 => random(draw, 6, 5),
        1 => {
            let g = sum(draw);
            let h = form(draw, 2).plus(&form(draw, 1)).plus(&form(draw, 0));
            g.times(&h)
        }
        _ => sum(draw),
    }
}

pub(crate) fn branches(draw: &mut Draw) -> Outcome {
    let f = curve(draw);
    if f.degree() == 0 || f.degree() > 9 {
        return Outcome::Open;
    }
    draw.input = format!("stellate parametrize '{}'", f.text());
    let limits = Limits::none().with_time_limit(Duration::from_secs(10));
    let Ok(found) = parametrize(&ImplicitCurve::new(f.to_plane()), &limits) else {
        return Outcome::Open;
    };
    let mut asked: Vec<Q> = (0..3).map(|_| draw.rational()).collect();
    let ends = found
        .branches
        .iter()
        .flat_map(|b| b.real.iter().chain(&b.positive));
    let ends: Vec<_> = ends.flat_map(|r| [&r.from, &r.to]).collect();
    for _ in 0..if ends.is_empty() { 0 } else { 4 } {
        let theta: f64 = draw.pick(&ends).to_decimal(20).parse().unwrap();
        let t = (theta / 2.0).tan();
        if t.is_finite() && t.abs() < 1e12 {
            asked.push(value(t));
            asked.push(value(t.next_down()));
            asked.push(value(t * (1.0 + 1e-9)));
        }
    }
    let mut outcome = Outcome::Open;
    'direction: for t in asked {
        let way = way_of_half_tangent(&t);
        let g = roots_along(&f, &way);
        // Not on a line, nor where branches meet.
        if g.is_zero() || tower(&g).len() > 1 {
            continue;
        }
        let [mut real, mut positive] = [0; 2];
        for branch in &found.branches {
            let (Some(is_real), Some(is_positive)) =
                (is_in(&branch.real, &t), is_in(&branch.positive, &t))
            else {
                continue 'direction;
            };
            real += usize::from(is_real);
            positive += usize::from(is_positive);
            assert!(is_real || !is_positive);
        }
        let (all, below) = if g.degree() == 0 {
            (0, 0)
        } else {
            let sturm = Sturm::new(&g);
            (sturm.count(), sturm.count_up_to(&Q::zero()))
        };
        assert_eq!(
            real,
            all,
            "real branches at tan(θ/2) = {t}, θ ≈ {}",
            near(&way)
        );
        assert_eq!(positive, all - below, "positive ones at tan(θ/2) = {t}");
        outcome = Outcome::Checked;
    }
    outcome
}

/// The terms of highest degree.
fn top_form(f: &Terms<3>) -> impl Iterator<Item = ([u32; 3], BigInt)> {
    let terms =
        f.0.iter()
            .filter(|(e, _)| e.iter().sum::<u32>() == f.degree());
    terms.map(|(e, c)| (*e, c.clone()))
}

pub(crate) fn surface_branches(draw: &mut Draw) -> Outcome {
    let form = |draw: &mut Draw, degree: u32| {
        let mut terms = Vec::new();
        for i in 0..=degree {
            for j in 0..=degree - i {
                if draw.once_in(2) {
                    terms.push(([i, j, degree - i - j], BigInt::from(draw.small(5))));
                }
            }
        }
        Terms::<3>::new(terms)
    };
    let step = 1 + draw.below(2) as u32;
    let count = 2 + draw.below(4) as u32;
    let low = draw.below(2) as u32;
    let f = (0..count).fold(Terms::default(), |f: Terms<3>, k| {
        f.plus(&form(draw, (low + k * step).min(6)))
    });
    if f.degree() == 0 {
        return Outcome::Open;
    }
    draw.input = format!("stellate parametrize '{} + 0z'", f.text());
    let limits = Limits::none().with_time_limit(Duration::from_secs(10));
    let surface = ImplicitSurface::new(f.to_sparse());
    let Ok(found) = parametrize_surface(&surface, &limits) else {
        return Outcome::Open;
    };
    if found.factors.iter().any(|factor| factor.is_numeric()) {
        return Outcome::Open;
    }
    let mut outcome = Outcome::Open;
    for _ in 0..4 {
        let angle = |draw: &mut Draw| {
            if draw.once_in(3) {
                let degrees = 15 * draw.below(24) as i64;
                Direction::from_degrees(&stellate::exact::Rational::from(degrees))
            } else {
                Direction::from_radians(draw.below(1 << 50) as f64 / (1u64 << 48) as f64)
            }
        };
        let direction = SpaceDirection::new(angle(draw), angle(draw));
        let vector = integer_vector(&direction).0;
        let g = along(&f, &vector);
        // Where the form of highest degree is 0 the formulas have no value, and where a root is double (it may be 0) two
        // formulas may have the same one.
        let top = Terms::new(top_form(&f));
        let least = f.0.keys().map(|e| e.iter().sum::<u32>()).min().unwrap_or(0);
        let zeros = (f.degree() - least) as usize - g.degree().min((f.degree() - least) as usize);
        let is_special = along(&top, &vector).is_zero() || zeros > 1;
        if g.is_zero() || tower(&g).len() > 1 || is_special {
            continue;
        }
        let (all, below) = if g.degree() == 0 {
            (0, 0)
        } else {
            let sturm = Sturm::new(&g);
            (sturm.count(), sturm.count_up_to(&Q::zero()))
        };
        let signs = found.in_direction(&direction).branches;
        let of = |sign: i8| signs.iter().filter(|s| **s == Some(sign)).count();
        assert_eq!([of(1), of(-1)], [all - below, below], "{direction:?}");
        outcome = Outcome::Checked;
    }
    outcome
}
