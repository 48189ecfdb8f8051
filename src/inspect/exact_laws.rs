//! The laws of `exact.rs`, on spheres, whose distances are known.

use super::*;
use crate::intervals::tests::sphere;
use malachite::Integer;
use malachite::base::num::arithmetic::traits::{FloorSqrt, UnsignedAbs};
use proptest::prelude::*;

#[test]
fn products_and_roundings_are_exact() {
    let [a, b] = [[1, -2, 3], [5, 7, 4]].map(|v| v.map(Rational::from));
    assert_eq!(exact_dot(&a, &b), Rational::from(3));
    assert_eq!(squared_length(&a), Rational::from(14));
    assert_eq!(exact_difference(&a, &b), [-4, -9, -1].map(Rational::from));
    let third = Rational::from(1) / Rational::from(3);
    let quarter = Rational::from(1) / Rational::from(4);
    assert_eq!(rounded(&third, 2), quarter);
    assert_eq!(rounded(&-third, 2), Rational::from(-1) / Rational::from(2));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    /// A point at a known distance from a sphere is decided rightly against a tolerance that is slightly larger or smaller. The
    /// foot is rational or not, and far or near. The bounds of the squared distance hold.
    #[test]
    fn distances_from_a_sphere_are_decided(
        turn in 0usize..3, signs in 0u8..8, size in (1i64..40, 1i64..11), square in 1i64..12, k in 8i64..60, is_inside in any::<bool>(),
    ) {
        let size = Rational::from(size.0) / Rational::from(size.1);
        let radius = close_root(square);
        prop_assume!((&size - &radius).abs() > power_of_two(-8));
        let direction: [Rational; 3] = std::array::from_fn(|i| {
            let sign = if signs >> i & 1 == 1 { -1 } else { 1 };
            Rational::from([1i64, 2, 2][(i + turn) % 3] * sign) / Rational::from(3)
        });
        let p = direction.each_ref().map(|x| x * &size);
        let distance = (&size - &radius).abs();
        let off = power_of_two(-k) * &distance;
        let d = if is_inside { &distance + &off } else { &distance - &off };
        let field = Field::new(&sphere(square));
        let start = direction.each_ref().map(|x| (x * &radius).to_f64());
        let sign = if size > radius { 1 } else { -1 };
        // The exact square is as near to this number as the root is to its rational approximation.
        let exact = &distance * &distance;
        let wrong = power_of_two(-900);
        match decide(&field, &p, &d, start, sign, None, &Limits::none()) {
            Some(Answer::Outside { low }) => prop_assert!(!is_inside && low <= exact + wrong && low > &d * &d),
            Some(Answer::Inside { low, high, .. }) => {
                prop_assert!(is_inside && low <= &exact + &wrong && exact <= &high + &wrong && high <= &d * &d);
            }
            _ => prop_assert!(false, "not decided"),
        }
    }
}

proptest! {
    /// A rational zero is found again from a point near it, and no zero is found where there is none.
    #[test]
    fn simple_zeros_are_found_again(turn in 0usize..3, signs in 0u8..8, off in prop::array::uniform3(-900i64..900)) {
        let zero: [Rational; 3] = std::array::from_fn(|i| {
            let sign = if signs >> i & 1 == 1 { -1 } else { 1 };
            Rational::from([2i64, 3, 6][(i + turn) % 3] * sign) / Rational::from(7)
        });
        let width = power_of_two(-20);
        let beside: [Rational; 3] = std::array::from_fn(|i| &zero[i] + &(&width * &Rational::from(off[i]) / Rational::from(1000)));
        prop_assert_eq!(rational_zero(&Field::new(&sphere(1)), &beside, &width), Some(zero));
        prop_assert_eq!(rational_zero(&Field::new(&sphere(2)), &beside, &width), None);
    }

    /// The point is exactly on the sphere and near the direction, whether the direction is long or short.
    #[test]
    fn points_of_the_sphere_are_on_it_and_next_to_the_direction(v in prop::array::uniform3(-50i64..50), k in -60i64..60, d in 1i64..40, p in prop::array::uniform3(-9i64..10)) {
        prop_assume!(v != [0; 3]);
        let direction = v.map(|x| Rational::from(x) * power_of_two(k));
        let (p, d) = (p.map(Rational::from), Rational::from(d) / Rational::from(7));
        let away = exact_difference(&on_sphere(&p, &d, &direction).unwrap(), &p);
        prop_assert_eq!(squared_length(&away), &d * &d);
        // Compares cos² of the angle between the two directions, and the sign of the cosine.
        let product = exact_dot(&away, &direction);
        prop_assert!(product.signum() > 0);
        let cosine = &product * &product / (squared_length(&away) * squared_length(&direction));
        prop_assert!(Rational::one() - cosine < power_of_two(-400));
    }
}

#[test]
fn no_direction_has_no_point_of_the_sphere() {
    let [p, zero] = [[1, 2, 3], [0; 3]].map(|v| v.map(Rational::from));
    assert_eq!(on_sphere(&p, &Rational::one(), &zero), None);
}

/// √n to 1000 bits.
fn close_root(n: i64) -> Rational {
    let scaled = Rational::from(n) * power_of_two(2000);
    let root = scaled.numerator().unsigned_abs().floor_sqrt();
    Rational::from_dyadic(Integer::from(root), -1000)
}
