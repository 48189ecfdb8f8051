//! Polynomials modulo a prime below 2⁶³: just enough for gcds.

/// a·b mod p.
pub(super) fn mul_mod(a: u64, b: u64, p: u64) -> u64 {
    let product = u128::from(a) * u128::from(b) % u128::from(p);
    u64::try_from(product).unwrap_or(0)
}

/// 1/a mod the prime p, by Fermat.
pub(super) fn inverse_mod(a: u64, p: u64) -> u64 {
    let (mut result, mut base, mut exponent) = (1, a % p, p - 2);
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = mul_mod(result, base, p);
        }
        base = mul_mod(base, base, p);
        exponent >>= 1;
    }
    result
}

/// The monic gcd of two non-zero polynomials (ascending, trimmed), by Euclid.
pub(super) fn gcd_mod(mut f: Vec<u64>, mut g: Vec<u64>, p: u64) -> Vec<u64> {
    while !g.is_empty() {
        remainder(&mut f, &g, p);
        std::mem::swap(&mut f, &mut g);
    }
    let inverse = inverse_mod(f[f.len() - 1], p);
    for c in &mut f {
        *c = mul_mod(*c, inverse, p);
    }
    f
}

/// f mod g, in place.
fn remainder(f: &mut Vec<u64>, g: &[u64], p: u64) {
    let inverse = inverse_mod(g[g.len() - 1], p);
    while f.len() >= g.len() {
        let top = f.pop().unwrap_or(0);
        if top != 0 {
            let factor = p - mul_mod(top, inverse, p);
            let start = f.len() + 1 - g.len();
            for (i, &c) in g[..g.len() - 1].iter().enumerate() {
                let sum = u128::from(f[start + i]) + u128::from(mul_mod(factor, c, p));
                f[start + i] = u64::try_from(sum % u128::from(p)).unwrap_or(0);
            }
        }
    }
    while f.last() == Some(&0) {
        f.pop();
    }
}
