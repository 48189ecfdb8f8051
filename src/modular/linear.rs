//! Linear algebra modulo a prime, by Gaussian elimination: kernels, spans and determinants.

use super::PrimeField;

/// The kernel of a matrix modulo a prime.
pub(crate) struct Kernel {
    /// For each column that depends on the columns before it, the vector of the kernel that is 1 there, 0 at all other such
    /// columns, and 0 after it.
    pub(crate) vectors: Vec<Vec<u64>>,
}

/// The kernel of the matrix with these rows, all of length `columns`, modulo a prime below 2³¹.
///
/// Numbers that are still to be eliminated are kept below p² and reduced when they are used.
pub(crate) fn kernel(mut rows: Vec<Vec<u64>>, columns: usize, p: u64) -> Kernel {
    let field = PrimeField::new(p);
    let square = field.square();
    let mut pivots: Vec<usize> = Vec::new();
    let mut free = Vec::new();
    for column in 0..columns {
        let rank = pivots.len();
        for row in &mut rows[rank..] {
            row[column] %= p;
        }
        let Some(found) = (rank..rows.len()).find(|&i| rows[i][column] != 0) else {
            free.push(column);
            continue;
        };
        rows.swap(rank, found);
        let inverse = field.inverse(rows[rank][column]);
        for c in &mut rows[rank][column..] {
            *c = *c % p * inverse % p;
        }
        let (done, open) = rows.split_at_mut(rank + 1);
        let top = &done[rank];
        for row in open.iter_mut().filter(|row| row[column] != 0) {
            let factor = p - row[column];
            for (c, t) in row[column..].iter_mut().zip(&top[column..]) {
                *c += factor * t;
                if *c >= square {
                    *c -= square;
                }
            }
        }
        pivots.push(column);
    }
    let vectors = free.iter().map(|&column| {
        let mut vector = vec![0; columns];
        vector[column] = 1;
        for (row, &pivot) in rows.iter().zip(&pivots).rev() {
            if pivot < column {
                let entries = row[pivot + 1..=column].iter().zip(&vector[pivot + 1..]);
                let sum = entries.fold(0, |sum, (a, b)| (sum + a * b) % p);
                vector[pivot] = (p - sum) % p;
            }
        }
        vector
    });
    Kernel {
        vectors: vectors.collect(),
    }
}

/// A growing vector space modulo a prime below 2³¹.
pub(crate) struct Span {
    prime: u64,
    /// For each column, the basis vector whose first non-zero entry, a 1, is in this column.
    rows: Vec<Option<Vec<u64>>>,
    dimension: usize,
}

impl Span {
    pub(crate) fn new(columns: usize, prime: u64) -> Self {
        Self {
            prime,
            rows: vec![None; columns],
            dimension: 0,
        }
    }

    pub(crate) fn len(&self) -> usize {
        self.dimension
    }

    /// Adds a vector. Returns whether it was not in the space before.
    pub(crate) fn add(&mut self, mut vector: Vec<u64>) -> bool {
        let field = PrimeField::new(self.prime);
        let (p, square) = (self.prime, field.square());
        // The numbers are kept below p² and reduced when they are used.
        for column in 0..vector.len() {
            vector[column] %= p;
            if vector[column] == 0 {
                continue;
            }
            match &self.rows[column] {
                Some(row) => {
                    let factor = p - vector[column];
                    for (c, r) in vector[column..].iter_mut().zip(&row[column..]) {
                        *c += factor * r;
                        if *c >= square {
                            *c -= square;
                        }
                    }
                }
                None => {
                    let inverse = field.inverse(vector[column]);
                    for c in &mut vector[column..] {
                        *c = *c % p * inverse % p;
                    }
                    self.rows[column] = Some(vector);
                    self.dimension += 1;
                    return true;
                }
            }
        }
        false
    }
}

/// The determinant of a square matrix modulo a prime below 2³¹.
pub(crate) fn determinant(mut rows: Vec<Vec<u64>>, p: u64) -> u64 {
    let (n, field) = (rows.len(), PrimeField::new(p));
    let mut value = 1;
    for k in 0..n {
        let Some(pivot) = (k..n).find(|&i| rows[i][k] != 0) else {
            return 0;
        };
        if pivot != k {
            rows.swap(pivot, k);
            value = (p - value) % p;
        }
        value = value * rows[k][k] % p;
        let inverse = field.inverse(rows[k][k]);
        let (done, open) = rows.split_at_mut(k + 1);
        let top = &done[k];
        for row in open.iter_mut().filter(|row| row[k] != 0) {
            let factor = p - row[k] * inverse % p;
            for (c, t) in row[k..].iter_mut().zip(&top[k..]) {
                *c = (*c + factor * t) % p;
            }
        }
    }
    value
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const P: u64 = 1_000_003;

    proptest! {
        #[test]
        fn kernels_vanish_and_have_the_right_dimension(
            basis in prop::collection::vec(prop::collection::vec(0..P, 7), 1..6),
            mix in prop::collection::vec(prop::collection::vec(0..P, 5), 9),
        ) {
            let rows: Vec<Vec<u64>> = mix.iter().map(|m| {
                (0..7).map(|c| m.iter().zip(&basis).fold(0, |s, (a, b)| (s + a * b[c]) % P)).collect()
            }).collect();
            let kernel = kernel(rows.clone(), 7, P);
            for vector in &kernel.vectors {
                for row in &rows {
                    prop_assert_eq!(row.iter().zip(vector).fold(0, |s, (a, b)| (s + a * b) % P), 0);
                }
            }
            // Random vectors are independent except with a probability of 1e-5.
            prop_assert_eq!(kernel.vectors.len(), 7 - basis.len());
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(12))]
        #[test]
        fn large_kernels_are_those_of_a_span(seed in 0u64..1000, rank in 1usize..190) {
            let mut random = super::super::SplitMix(seed);
            let columns = 200;
            // The vectors have steps, so that columns other than the last ones are free.
            let basis: Vec<Vec<u64>> = (0..rank).map(|k| {
                (0..columns).map(|c| if c < k { 0 } else { random.next() % P }).collect()
            }).collect();
            let rows: Vec<Vec<u64>> = (0..columns + 8).map(|_| {
                let weights: Vec<u64> = (0..rank).map(|_| random.next() % P).collect();
                (0..columns).map(|c| weights.iter().zip(&basis).fold(0, |s, (a, b)| (s + a * b[c]) % P)).collect()
            }).collect();
            let mut span = Span::new(columns, P);
            for row in &rows {
                span.add(row.clone());
            }
            let kernel = kernel(rows.clone(), columns, P);
            prop_assert_eq!(kernel.vectors.len(), columns - span.len());
            for (vector, row) in kernel.vectors.iter().zip(rows.iter().cycle().skip(rank)) {
                prop_assert_eq!(row.iter().zip(vector).fold(0, |s, (a, b)| (s + a * b) % P), 0);
            }
        }
    }
}
