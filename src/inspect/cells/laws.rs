//! The charts against exact values, and the boxes against exact points.

#![expect(clippy::cast_precision_loss, reason = "the numbers of tests are small")]

use proptest::prelude::*;

use super::*;
use crate::error::Invariant;

/// A surface with small coefficients.
pub(in crate::inspect) fn surface(mean: i64, list: &[(usize, usize, i64)]) -> HarmonicSurface {
    let terms = list.iter().map(|&(l, m, c)| {
        let m = (m % (2 * l + 1)).cast_signed() - l.cast_signed();
        // The harmonics grow like the factorials.
        let size = (1..=m.unsigned_abs()).map(|k| Rational::whole(Integer::from(l + k)));
        let size = size.fold(Rational::from(10), |product, k| product * k);
        ((l, m), Rational::from(c) / size)
    });
    let mean = ((0, 0), Rational::from(mean));
    HarmonicSurface::new(terms.chain([mean])).invariant("the orders are right")
}

/// A rational point of the unit circle.
fn circle(p: i64, q: i64) -> [Rational; 2] {
    let below = Rational::from(p * p + q * q);
    [
        Rational::from(p * p - q * q) / &below,
        Rational::from(2 * p * q) / below,
    ]
}

/// The derivatives of cos nα and sin nα of an order.
fn wave([cos, sin]: &[Rational; 2], n: usize, is_sine: bool, order: usize) -> Rational {
    let (mut c, mut s) = (Rational::one(), Rational::zero());
    for _ in 0..n {
        (c, s) = (&c * cos - &s * sin, &s * cos + &c * sin);
    }
    let mut value = if is_sine { [s, c] } else { [c, -s] };
    for _ in 0..order {
        let n = Rational::whole(Integer::from(n));
        let [v, t] = value;
        value = [&n * t, -(n * v)];
    }
    let [value, _] = value;
    value
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    #[test]
    fn derivatives_are_those_of_the_radius(
        list in prop::collection::vec((0usize..9, 0usize..17, -9i64..10), 1..9),
        p in 1i64..9, q in -9i64..9, a in 1i64..9, b in 1i64..9, chart in 0usize..2,
    ) {
        let surface = surface(2, &list);
        let pair = HarmonicPair::new(&surface);
        let terms = wave_coefficients(&pair, AXES[chart]);
        let size: Rational = terms.iter().map(|(.., c)| c.abs()).sum();
        let waves = Waves::new(surface.degree(), &terms, &Rational::one());
        let (theta, phi) = (circle(p, q), circle(a, b));
        // The exact sum is the radius.
        let value = |i: usize, j: usize| -> Rational {
            let terms = terms.iter().map(|(m, is_sine, n, c)| {
                c * wave(&theta, *m, *is_sine, i) * wave(&phi, *n, m % 2 == 1, j)
            });
            terms.sum()
        };
        let local = [&phi[1] * &theta[0], &phi[1] * &theta[1], phi[0].clone()];
        let mut unit: [Rational; 3] = std::array::from_fn(|_| Rational::zero());
        for (x, axis) in local.into_iter().zip(AXES[chart]) {
            unit[axis] = x;
        }
        prop_assert_eq!(value(0, 0), pair.value(&unit));
        let found = waves.derivatives::<ORDERS>(
            theta.each_ref().map(Rational::to_f64),
            phi.each_ref().map(Rational::to_f64),
        );
        for (i, list) in found.iter().enumerate() {
            for (j, found) in list.iter().enumerate().take(ORDERS - i) {
                let off = (Rational::try_from(*found).unwrap() - value(i, j)).abs();
                prop_assert!(off <= Rational::try_from(waves.errors()[i + j]).unwrap());
                prop_assert!(value(i, j).abs() <= Rational::try_from(waves.sizes()[i + j]).unwrap());
            }
        }
        // The bounds are not far from the roundings.
        prop_assert!(waves.errors()[0] <= size.to_f64() * 1e-13);
    }

    #[test]
    fn boxes_and_bounds_hold_the_surface(
        list in prop::collection::vec((0usize..9, 0usize..17, -9i64..10), 1..9),
        directions in prop::collection::vec([-90i64..90, -90i64..90, -90i64..90], 24),
    ) {
        let surface = surface(2, &list);
        prop_assume!(surface.degree() > 0);
        let pair = HarmonicPair::new(&surface);
        let tree = CellTree::new(&surface, &pair).unwrap();
        for v in directions {
            prop_assume!(v != [0; 3]);
            let (chart, at) = tree.angles(&v.map(|x| x as f64));
            // The node of every level that holds the direction has the point in its box.
            let mut place = (0..6)
                .map(|code| (CellTree::square(code), code))
                .find(|(square, _)| {
                    let turns = ((square.middle()[0] - at[0]) / std::f64::consts::TAU).round();
                    let at = [at[0] + turns * std::f64::consts::TAU, at[1]];
                    square.chart == chart && square.holds(&at)
                })
                .unwrap();
            let turns = ((place.0.middle()[0] - at[0]) / std::f64::consts::TAU).round();
            let at = [at[0] + turns * std::f64::consts::TAU, at[1]];
            let here = Expansion::new(&tree.charts[chart].waves, at, &[0.0; 3]);
            for level in 0..=tree.divisions {
                let node = tree.node(level, place.1);
                for (x, axis) in here.value.into_iter().zip(AXES[chart]) {
                    prop_assert!(node.extent.low[axis] <= x + 1e-14 && x <= node.extent.high[axis] + 1e-14);
                }
                // A third derivative by differences of second ones, along θ.
                let step = 1e-4;
                let next = Expansion::new(&tree.charts[chart].waves, [at[0] + step, at[1]], &[0.0; 3]);
                let third: [f64; 3] = std::array::from_fn(|i| (next.bends[0][i] - here.bends[0][i]) / step);
                prop_assert!(length(&third) / 6.0 <= node.third * 1.05 + 1e-9);
                if level < tree.divisions {
                    let parts = place.0.parts().into_iter().enumerate();
                    let (i, part) = parts.into_iter().find(|(_, part)| part.holds(&at)).unwrap();
                    place = (part, 4 * place.1 + i);
                }
            }
        }
    }

    #[test]
    fn cells_are_not_nearer(
        list in prop::collection::vec((0usize..9, 0usize..17, -9i64..10), 1..9),
        p in [-40i64..40, -40i64..40, -40i64..40],
        start in [0.8f64..2.3, 0.8f64..2.3], half in 0.0001f64..0.2,
        inside in [-1.0f64..1.0, -1.0f64..1.0],
    ) {
        let surface = surface(2, &list);
        prop_assume!(surface.degree() > 0);
        let pair = HarmonicPair::new(&surface);
        let tree = CellTree::new(&surface, &pair).unwrap();
        let p = p.map(|x| x as f64 / 20.0);
        let chart = &tree.charts[0];
        let here = Expansion::new(&chart.waves, start, &p);
        let ends = [-half, half].map(|off| start.map(|x| x + off));
        let third = tree.nodes.iter().take(6).fold(0.0, |third: f64, node| third.max(node.third));
        prop_assume!(ends[0][1] > FRAC_PI_4 && ends[1][1] < 3.0 * FRAC_PI_4);
        let least = here.least_distance(ends[0], ends[1], third, &chart.errors);
        let at = [0, 1].map(|i| start[i] + half * inside[i]);
        let there = Expansion::new(&chart.waves, at, &p);
        prop_assert!(least <= there.distance()[0] + 1e-13);
    }
}
