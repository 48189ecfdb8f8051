//! Three linear equations with a symmetric matrix, exactly.

use crate::exact::Rational;

/// A solution of three equations with a symmetric matrix without negative eigenvalues, if there is one, and a basis of the directions in
/// which there are others. The last number of each row is the right side.
pub(super) fn solved(mut rows: [[Rational; 4]; 3]) -> ([Rational; 3], Vec<[Rational; 3]>) {
    let determined: [bool; 3] = std::array::from_fn(|pivot| {
        let Some(over) = rows[pivot][pivot].recip() else {
            return false;
        };
        let own = rows[pivot].each_ref().map(|x| x * &over);
        for (k, row) in rows.iter_mut().enumerate() {
            if k != pivot {
                let factor = row[pivot].clone();
                *row = std::array::from_fn(|i| &row[i] - &factor * &own[i]);
            }
        }
        rows[pivot] = own;
        true
    });
    let column = |of: usize, free: Rational| {
        std::array::from_fn(|k| match determined[k] {
            true => rows[k][of].clone(),
            false => free.clone(),
        })
    };
    let solution = column(3, Rational::zero());
    let free = (0..3).filter(|&j| !determined[j]).map(|j| {
        let mut direction = column(j, Rational::zero()).map(|x: Rational| -x);
        direction[j] = Rational::one();
        direction
    });
    let free = free.collect();
    (solution, free)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// The equations MᵀM x = MᵀM s have the solution s and those that differ from it in the kernel.
        #[test]
        fn all_solutions_are_found(m in prop::array::uniform3(prop::array::uniform3(-2i64..3)), s in prop::array::uniform3(-9i64..9)) {
            let number = |n: i64| Rational::from(n);
            let square = |i: usize, j: usize| (0..3).map(|k| m[k][i] * m[k][j]).sum::<i64>();
            let rows = std::array::from_fn(|i| {
                let right = (0..3).map(|j| square(i, j) * s[j]).sum();
                [square(i, 0), square(i, 1), square(i, 2), right].map(number)
            });
            let (solution, free) = solved(rows.clone());
            let image = |x: &[Rational; 3], row: &[Rational; 4]| -> Rational {
                x.iter().zip(row).map(|(x, c)| x * c).sum()
            };
            for row in &rows {
                prop_assert_eq!(image(&solution, row), row[3].clone());
                for direction in &free {
                    prop_assert!(image(direction, row).is_zero());
                }
            }
            let [a, b, c] = m;
            let determinant = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                + a[2] * (b[0] * c[1] - b[1] * c[0]);
            prop_assert_eq!(free.is_empty(), determinant != 0);
        }
    }
}
