//! The laws of `exact.rs`, on spheres, whose distances are known.

use super::*;
use crate::intervals::tests::sphere;
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

    /// A point at a known distance from the unit sphere, against a radius that is a little larger or smaller, is decided, and as it
    /// is. The bounds are those of the squared distance.
    #[test]
    fn distances_from_a_sphere_are_decided(turn in 0usize..3, signs in 0u8..8, far in 2i64..30, below in 10i64..11, k in 8i64..60, is_inside in any::<bool>()) {
        prop_assume!(far != below);
        let size = Rational::from(far) / Rational::from(below);
        let direction: [Rational; 3] = std::array::from_fn(|i| {
            let sign = if signs >> i & 1 == 1 { -1 } else { 1 };
            Rational::from([1i64, 2, 2][(i + turn) % 3] * sign) / Rational::from(3)
        });
        let p = direction.each_ref().map(|x| x * &size);
        let distance = (&size - &Rational::one()).abs();
        let off = power_of_two(-k) * &distance;
        let d = if is_inside { &distance + &off } else { &distance - &off };
        let field = Field::new(&sphere(1));
        let start = direction.each_ref().map(Rational::to_f64);
        let sign = if far > below { 1 } else { -1 };
        let square = &distance * &distance;
        match decide(&field, &p, &d, start, sign, None) {
            Some(Answer::Outside { low }) => prop_assert!(!is_inside && low <= square && low > &d * &d),
            Some(Answer::Inside { low, high, .. }) => {
                prop_assert!(is_inside && low <= square && square <= high && high <= &d * &d);
            }
            _ => prop_assert!(false, "not decided"),
        }
    }
}
