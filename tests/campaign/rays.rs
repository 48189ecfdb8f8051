//! Rays in the plane and in space: how many roots there are, their multiplicities, and that every r and every coordinate is the
//! nearest double, by Sturm counts between the points where rounding changes.

use num_bigint::BigInt;
use num_traits::{One, Zero};
use stellate::exact::Rational;
use stellate::poly::SpacePolynomial;
use stellate::sample::{
    Direction, RationalDirection, Ray, RaySolver, Sample, SpaceDirection, UnitVector,
};

use super::draw::Draw;
use super::exact::{Poly, Q, num, power_of_two, rounding_interval, tower, value};
use super::harness::Outcome;
use super::terms::{Terms, random};

/// An exact direction: integers over a common denominator.
pub(crate) struct Way<const V: usize> {
    pub(crate) vector: [BigInt; V],
    pub(crate) length: BigInt,
    ours: RationalDirection<V>,
    name: String,
}

impl<const V: usize> Way<V> {
    pub(crate) fn new((vector, length): ([BigInt; V], BigInt)) -> Self {
        let component = |u: &BigInt| Rational::new(u.clone(), length.clone()).unwrap();
        let ours = RationalDirection::new(&vector.each_ref().map(component)).unwrap();
        let name = format!("in the direction {vector:?}/{length}");
        Self {
            vector,
            length,
            ours,
            name,
        }
    }

    fn of(direction: &impl UnitVector<V>, name: String) -> Self {
        let (vector, length) = integer_vector(direction);
        Self {
            vector,
            length,
            ours: RationalDirection::new(&direction.components()).unwrap(),
            name,
        }
    }
}

/// The components over their least common denominator, and that.
pub(crate) fn integer_vector<const V: usize>(
    direction: &impl UnitVector<V>,
) -> ([BigInt; V], BigInt) {
    let components = direction.components();
    let length = components.iter().fold(BigInt::one(), |w, c| {
        let gcd = Q::new(w.clone(), c.denom()).denom().clone();
        w * gcd
    });
    let scale = Rational::from(&length);
    (components.map(|c| (c * &scale).numer()), length)
}

fn plane_direction(draw: &mut Draw) -> (Direction, String) {
    if draw.once_in(2) {
        let degrees = draw.below(360) as i64;
        let direction = Direction::from_degrees(&Rational::from(degrees));
        (direction, format!("{degrees}deg"))
    } else {
        let theta = draw.below(1 << 52) as f64 / (1u64 << 50) as f64;
        (Direction::from_radians(theta), format!("{theta}"))
    }
}

pub(crate) fn way2(draw: &mut Draw) -> Way<2> {
    if draw.once_in(3) {
        let bits = 2 + draw.below(120);
        return Way::new(draw.unit2(bits));
    }
    let (direction, name) = plane_direction(draw);
    Way::of(&direction, format!("--theta {name}"))
}

pub(crate) fn way3(draw: &mut Draw) -> Way<3> {
    if draw.once_in(2) {
        let bits = 2 + draw.below(60);
        return Way::new(draw.unit3(bits));
    }
    let [(theta, a), (phi, b)] = [0; 2].map(|_: i32| plane_direction(draw));
    Way::of(
        &SpaceDirection::new(theta, phi),
        format!("--theta {a} --phi {b}"),
    )
}

/// f(s U) as a polynomial in s = r/W, without the powers of s that divide it.
pub(crate) fn along<const V: usize>(f: &Terms<V>, vector: &[BigInt; V]) -> Poly {
    let mut sums = vec![BigInt::zero(); f.degree() as usize + 1];
    for (e, c) in &f.0 {
        let mut term = c.clone();
        for (u, &k) in vector.iter().zip(e) {
            term *= u.pow(k);
        }
        sums[e.iter().sum::<u32>() as usize] += term;
    }
    let lowest = sums.iter().position(|c| !c.is_zero());
    Poly::new(sums.split_off(lowest.unwrap_or(0)))
}

/// The interval of s in which factor·s rounds to the double; `None` where the double is infinite.
fn interval(double: f64, factor: &BigInt) -> Option<[Q; 2]> {
    if !double.is_finite() || factor.is_zero() {
        return None;
    }
    let factor = Q::from_integer(factor.clone());
    let [low, high] = rounding_interval(double).map(|end| end / &factor);
    Some(if low <= high {
        [low, high]
    } else {
        [high, low]
    })
}

fn check<const V: usize>(found: &Ray<V>, f: &Terms<V>, way: &Way<V>) {
    let g = along(f, &way.vector);
    let points = match found {
        Ray::Line => {
            assert!(g.is_zero(), "a line where f does not vanish");
            return;
        }
        Ray::Points(points) => points,
    };
    assert!(!g.is_zero(), "points where f vanishes identically");
    let chains = tower(&g);
    let total = chains.first().map_or(0, |chain| chain.count());
    assert_eq!(points.len(), total, "the number of distinct roots");
    for (k, chain) in chains.iter().enumerate() {
        let deep = |p: &&Sample<V>| p.multiplicity > k;
        assert_eq!(
            points.iter().filter(deep).count(),
            chain.count(),
            "roots of multiplicity above {k}"
        );
        for point in points {
            let Some([low, high]) = interval(point.r, &way.length) else {
                continue;
            };
            let [open, closed] = chain.count_open_and_closed(&low, &high);
            let here = points
                .iter()
                .filter(deep)
                .filter(|p| p.r == point.r)
                .count();
            assert!(
                open <= here && here <= closed,
                "{here} roots of multiplicity above {k} at {}, {open} to {closed} by Sturm",
                point.r
            );
        }
    }
    assert!(points.iter().all(|p| p.multiplicity <= chains.len()));
    for (i, point) in points.iter().enumerate() {
        assert_eq!(point.branch, i);
        assert!(i == 0 || points[i - 1].r >= point.r, "descending");
        let Some([mut low, mut high]) = interval(point.r, &way.length) else {
            continue;
        };
        for (x, u) in point.position.iter().zip(&way.vector) {
            if u.is_zero() {
                assert_eq!(*x, 0.0);
            } else if let Some([a, b]) = interval(*x, u) {
                low = low.max(a);
                high = high.min(b);
            }
        }
        assert!(low <= high, "r and the coordinates belong together");
        let [_, closed] = chains[0].count_open_and_closed(&low, &high);
        assert!(
            closed > 0,
            "coordinates {:?} of r = {}",
            point.position,
            point.r
        );
    }
}

fn check_plane(draw: &mut Draw, f: &Terms<2>, way: &Way<2>) -> Outcome {
    draw.input = format!("stellate sample '{}' {}", f.text(), way.name);
    let polynomial = f.to_plane();
    check(&RaySolver::new(&polynomial).solve(&way.ours), f, way);
    Outcome::Checked
}

fn check_space(draw: &mut Draw, f: &Terms<3>, way: &Way<3>) -> Outcome {
    draw.input = format!("stellate sample '{} + 0z' {}", f.text(), way.name);
    let polynomial = SpacePolynomial::from(&f.to_sparse());
    check(&RaySolver::new(&polynomial).solve(&way.ours), f, way);
    Outcome::Checked
}

fn bits(draw: &mut Draw) -> u64 {
    match draw.below(8) {
        0 => 60 + draw.below(2000),
        1..4 => 60 + draw.below(400),
        _ => 1 + draw.below(60),
    }
}

/// Any polynomials, products of them, and some in powers of r.
pub(crate) fn plane(draw: &mut Draw) -> Outcome {
    let bits = bits(draw);
    let mut f = random::<2>(draw, 7, bits);
    match draw.below(6) {
        0 => f = f.times(&random(draw, 3, bits)),
        1 => f = f.power(2),
        2 => {
            let rho = Terms::<2>::variable(0)
                .power(2)
                .plus(&Terms::variable(1).power(2));
            f = f.substituted(&[rho, Terms::constant(draw.integer(bits))]);
            if f.degree() == 0 {
                f = Terms::variable(0);
            }
        }
        _ => {}
    }
    let way = way2(draw);
    check_plane(draw, &f, &way)
}

/// k (V x − U y) + ε x, which is ε U in the direction, smaller than its terms by as many bits as k has.
fn nearly_vanishing(draw: &mut Draw, way: &Way<2>, bits: u64) -> Terms<2> {
    let [u, v] = &way.vector;
    let k = draw.natural(bits);
    let small = BigInt::from(draw.small(2));
    Terms::linear(&[&k * v + small, -(k * u)], BigInt::zero())
}

/// Forms that nearly vanish in the direction, as the lowest part, in the middle or at the top.
pub(crate) fn vanishing(draw: &mut Draw) -> Outcome {
    let way = way2(draw);
    let length = if draw.once_in(4) {
        60 + draw.below(2000)
    } else {
        60 + draw.below(400)
    };
    let mut form = nearly_vanishing(draw, &way, length);
    for _ in 0..draw.below(3) {
        let bits = 1 + draw.below(200);
        let other = if draw.once_in(4) {
            nearly_vanishing(draw, &way, bits)
        } else {
            Terms::linear(&[draw.integer(bits), draw.integer(bits)], BigInt::zero())
        };
        form = form.times(&other);
    }
    let low = form.degree();
    let high = low + 1 + draw.below(8) as u32;
    let shift = draw.below(400) as u32;
    let mut others = vec![([high, 0], BigInt::from(draw.small(1)) << shift)];
    others.push(([0, low + 1], BigInt::from(draw.small(1))));
    if draw.once_in(2) {
        others.push(([0, 0], BigInt::from(draw.small(1))));
    }
    if draw.once_in(2) && low > 1 {
        others.push(([low - 1, 0], draw.integer(shift.into())));
    }
    let scale = BigInt::one() << draw.below(200);
    let f = form.scaled(&scale).plus(&Terms::new(others));
    if f.degree() == 0 {
        return Outcome::Open;
    }
    check_plane(draw, &f, &way)
}

/// A root next to a double or next to a midpoint of two.
fn known_root(draw: &mut Draw, start: f64) -> Q {
    let at = (0..draw.below(3)).fold(start, |at, _| at.next_up());
    let exact = value(at);
    let halfway = (&exact + value(at.next_up())) / (Q::one() + Q::one());
    let beside = match draw.below(4) {
        0 => return exact,
        1 => Q::zero(),
        2 => power_of_two(-60),
        _ => power_of_two(-200),
    };
    let beside = if draw.once_in(2) { -beside } else { beside };
    &halfway + &halfway * beside
}

fn known_roots(draw: &mut Draw) -> Vec<Q> {
    let mut start = draw.double(40);
    let count = 1 + draw.below(5);
    (0..count)
        .map(|_| {
            if draw.once_in(2) {
                start = draw.double(40);
            }
            known_root(draw, start)
        })
        .collect()
}

/// Polynomials with known roots 0, 1 or 2 ulps apart, at midpoints and beside them, some multiple; lines, or circles of powers.
pub(crate) fn backwards(draw: &mut Draw) -> Outcome {
    let way = way2(draw);
    let [u, v] = &way.vector;
    let most = draw.pick(&[100, 100, 500, 1900]);
    let long = 100 + draw.below(most);
    let constant = draw.natural(long);
    let mut f = if draw.once_in(2) {
        let a = draw.natural(long);
        Terms::<2>::new([([2, 0], a.clone()), ([0, 2], a), ([0, 0], constant)])
    } else {
        Terms::constant(constant)
    };
    let rho = Terms::new([([2, 0], BigInt::one()), ([0, 2], BigInt::one())]);
    let half = draw.below(4) as u32;
    for root in known_roots(draw) {
        let factor = if half < 2 {
            // q (U x + V y) − p W
            let q = root.denom();
            Terms::linear(&[q * u, q * v], -(root.numer() * &way.length))
        } else {
            // q^g (x² + y²)^(g/2) − p^g
            let [p, q] = [root.numer(), root.denom()].map(|n| n.pow(2 * half));
            rho.power(half as usize)
                .scaled(&q)
                .plus(&Terms::constant(-p))
        };
        let most = if half < 2 && draw.once_in(3) { 2 } else { 1 };
        f = f.times(&factor.power(most));
        if f.degree() > 14 {
            break;
        }
    }
    check_plane(draw, &f, &way)
}

/// In space: any polynomials, roots built backwards, and forms that nearly vanish.
pub(crate) fn space(draw: &mut Draw) -> Outcome {
    let way = way3(draw);
    let [u, v, w] = &way.vector;
    let bits = bits(draw).min(600);
    let f = match draw.below(3) {
        0 => random::<3>(draw, 5, bits),
        1 => {
            let mut f = Terms::constant(draw.natural(bits));
            for root in known_roots(draw).into_iter().take(3) {
                let q = root.denom();
                let line = Terms::linear(&[q * u, q * v, q * w], -(root.numer() * &way.length));
                f = f.times(&line);
            }
            f
        }
        _ => {
            let [k, l] = [0; 2].map(|_: i32| draw.integer(bits));
            let small = BigInt::from(draw.small(2));
            // k (v x − u y) + l (w y − v z) + ε x
            let form = Terms::linear(
                &[&k * v + small, &l * w - &k * u, -(&l * v)],
                BigInt::zero(),
            );
            let high = 2 + draw.below(4) as u32;
            let top = Terms::new([([high, 0, 0], draw.integer(40)), ([0, 1, 1], BigInt::one())]);
            form.times(&random(draw, 1, 30)).plus(&top)
        }
    };
    if f.degree() == 0 {
        return Outcome::Open;
    }
    check_space(draw, &f, &way)
}

/// f along a direction, for other kinds.
pub(crate) fn roots_along(f: &Terms<2>, way: &Way<2>) -> Poly {
    along(f, &way.vector)
}

/// The half-angle tangent's direction (1 − t², 2t)/(1 + t²).
pub(crate) fn way_of_half_tangent(t: &Q) -> Way<2> {
    let (p, q) = (t.numer(), t.denom());
    Way::new(([q * q - p * p, p * q * 2], p * p + q * q))
}

/// The double of a component, for messages.
pub(crate) fn near(way: &Way<2>) -> f64 {
    let [u, v] = way.ours.components().map(|c| num(&c));
    super::exact::nearest(&v).atan2(super::exact::nearest(&u))
}
