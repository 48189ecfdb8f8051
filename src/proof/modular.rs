//! Polynomials over the integers modulo a prime, and whether one is irreducible.

use num_bigint::BigInt;

/// A polynomial modulo a prime: ascending coefficients from 0 to the prime, the last one not 0.
type Residues = Vec<u64>;

/// Whether this number below 2^32 is a prime, by trial division.
pub(super) fn is_prime(p: u64) -> bool {
    p >= 2 && (2..=p.isqrt()).all(|divisor| !p.is_multiple_of(divisor))
}

/// Whether the polynomial, whose last coefficient is the leading one, keeps its degree modulo a prime below 2^32 and is
/// irreducible there. x^(p^d) − x is the product of all monic irreducible polynomials whose degrees divide d; so a polynomial of
/// degree n is irreducible if and only if it is coprime to x^(p^d) − x for all d ≤ n/2.
pub(super) fn is_irreducible(polynomial: &[BigInt], p: u64) -> bool {
    let reduced = polynomial
        .iter()
        .map(|c| residue(c, p))
        .collect::<Option<Residues>>();
    let field = Field { p };
    let Some(f) = reduced.filter(|f| f.len() > 1 && f.last() != Some(&0)) else {
        return false;
    };
    let f = field.monic(f);
    let mut image = vec![0, 1];
    for _ in 0..(f.len() - 1) / 2 {
        image = field.power(&image, p, &f);
        let mut difference = image.clone();
        if difference.len() < 2 {
            difference.resize(2, 0);
        }
        difference[1] = (difference[1] + p - 1) % p;
        if field.have_common_divisor(f.clone(), Field::trimmed(difference)) {
            return false;
        }
    }
    true
}

fn residue(c: &BigInt, p: u64) -> Option<u64> {
    let modulus = BigInt::from(p);
    u64::try_from(((c % &modulus) + &modulus) % modulus).ok()
}

/// The integers modulo a prime below 2^32, so that products fit into 64 bits.
struct Field {
    p: u64,
}

impl Field {
    fn trimmed(mut f: Residues) -> Residues {
        while f.last() == Some(&0) {
            f.pop();
        }
        f
    }

    /// a^(p − 2), the inverse of a by Fermat's theorem.
    fn inverse(&self, a: u64) -> u64 {
        let (mut result, mut square, mut exponent) = (1, a, self.p - 2);
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = result * square % self.p;
            }
            square = square * square % self.p;
            exponent >>= 1;
        }
        result % self.p
    }

    /// The multiple with leading coefficient 1 of a polynomial that is not zero.
    fn monic(&self, mut f: Residues) -> Residues {
        let inverse = self.inverse(f.last().copied().unwrap_or(1));
        for c in &mut f {
            *c = *c * inverse % self.p;
        }
        f
    }

    /// The remainder of a division by a monic polynomial.
    fn remainder(&self, mut a: Residues, monic: &[u64]) -> Residues {
        while a.len() >= monic.len() {
            let Some(leading) = a.pop() else { break };
            let start = a.len() + 1 - monic.len();
            // Subtracting leading·c is adding (p − leading)·c.
            let negative = (self.p - leading) % self.p;
            for (slot, c) in a[start..].iter_mut().zip(monic) {
                *slot = (*slot + negative * c) % self.p;
            }
        }
        Self::trimmed(a)
    }

    fn product(&self, a: &[u64], b: &[u64], monic: &[u64]) -> Residues {
        let mut result = vec![0; (a.len() + b.len()).saturating_sub(1)];
        for (i, x) in a.iter().enumerate() {
            for (slot, y) in result[i..].iter_mut().zip(b) {
                *slot = (*slot + x * y) % self.p;
            }
        }
        self.remainder(result, monic)
    }

    /// base^exponent modulo the monic polynomial.
    fn power(&self, base: &[u64], exponent: u64, monic: &[u64]) -> Residues {
        let mut result = self.remainder(vec![1], monic);
        for digit in (0..u64::BITS - exponent.leading_zeros()).rev() {
            result = self.product(&result, &result, monic);
            if exponent >> digit & 1 == 1 {
                result = self.product(&result, base, monic);
            }
        }
        result
    }

    /// Whether the greatest common divisor is not constant, by Euclid's algorithm.
    fn have_common_divisor(&self, mut a: Residues, mut b: Residues) -> bool {
        while !b.is_empty() {
            b = self.monic(b);
            let rest = self.remainder(a, &b);
            (a, b) = (b, rest);
        }
        a.len() > 1
    }
}

#[cfg(test)]
mod tests {
    use num_bigint::BigInt;

    use super::{is_irreducible, is_prime};

    #[test]
    fn primes_have_no_divisors() {
        let primes: Vec<_> = (0..30).filter(|n| is_prime(*n)).collect();
        assert_eq!(primes, [2, 3, 5, 7, 11, 13, 17, 19, 23, 29]);
        assert!(is_prime((1 << 31) - 1));
        assert!(!is_prime(46_337 * 46_337));
    }

    /// The polynomial over the prime field with these digits as coefficients.
    fn polynomial(mut number: u64, p: u64) -> Vec<u64> {
        let mut digits = Vec::new();
        while number > 0 {
            digits.push(number % p);
            number /= p;
        }
        digits
    }

    #[test]
    fn irreducible_polynomials_are_those_that_are_no_products() {
        for (p, degree) in [(2_u64, 6_u32), (3, 4), (5, 3)] {
            let polynomials: Vec<_> = (p..p.pow(degree + 1))
                .map(|number| polynomial(number, p))
                .collect();
            let mut products = std::collections::BTreeSet::new();
            for f in &polynomials {
                for g in &polynomials {
                    if f.len() + g.len() <= degree as usize + 2 {
                        let mut product = vec![0; f.len() + g.len() - 1];
                        for (i, a) in f.iter().enumerate() {
                            for (j, b) in g.iter().enumerate() {
                                product[i + j] = (product[i + j] + a * b) % p;
                            }
                        }
                        products.insert(product);
                    }
                }
            }
            for f in &polynomials {
                // Multiples of p do not matter.
                let lifted: Vec<_> = f
                    .iter()
                    .map(|c| BigInt::from(*c) - BigInt::from(3 * p))
                    .collect();
                assert_eq!(
                    is_irreducible(&lifted, p),
                    !products.contains(f),
                    "{f:?} modulo {p}"
                );
            }
        }
    }

    #[test]
    fn the_degree_is_kept() {
        let linear = [1, 1, 5].map(BigInt::from);
        assert!(!is_irreducible(&linear, 5));
        assert!(is_irreducible(&linear[..2], 5));
        assert!(!is_irreducible(&linear[..1], 5));
    }
}
