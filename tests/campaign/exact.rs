//! The slow twins' arithmetic: num-rational, and univariate polynomials over num-bigint with Sturm's theorem.

use malachite::Integer;
use malachite::base::polynomial::Polynomial;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use stellate::exact::{Rational, integer_from_num, integer_to_num};
use stellate::poly::IntegerPolynomial;

pub(crate) type Q = BigRational;

pub(crate) fn num(q: &Rational) -> Q {
    Q::from(q)
}

pub(crate) fn our(q: &Q) -> Rational {
    Rational::from(q.clone())
}

pub(crate) fn integer(n: &BigInt) -> Integer {
    integer_from_num(n)
}

pub(crate) fn big(n: &Integer) -> BigInt {
    integer_to_num(n)
}

pub(crate) fn whole(n: i64) -> Q {
    Q::from_integer(n.into())
}

/// 2^k
pub(crate) fn power_of_two(k: i64) -> Q {
    let power = Q::from_integer(BigInt::one() << k.unsigned_abs());
    if k < 0 { power.recip() } else { power }
}

/// The exact value of a finite double.
pub(crate) fn value(double: f64) -> Q {
    Q::from_float(double).unwrap()
}

/// The midpoints of a finite double with its neighbours; the neighbour beyond the largest one is 2^1024.
pub(crate) fn rounding_interval(double: f64) -> [Q; 2] {
    let at = |v: f64| {
        if v.is_finite() {
            value(v)
        } else {
            power_of_two(1024) * whole(if v > 0.0 { 1 } else { -1 })
        }
    };
    [double.next_down(), double.next_up()].map(|v| (at(v) + value(double)) / whole(2))
}

/// Whether the last bit is 0.
pub(crate) fn is_even(double: f64) -> bool {
    double.to_bits() & 1 == 0
}

/// The nearest double with ties to even, by the bits of the quotient.
pub(crate) fn nearest(q: &Q) -> f64 {
    if q.is_zero() {
        return 0.0;
    }
    let (n, d) = (q.numer().abs(), q.denom());
    // 2^e <= |q| < 2^(e + 1)
    let mut e = n.bits() as i64 - d.bits() as i64;
    if q.abs() < power_of_two(e) {
        e -= 1;
    }
    let unit = e.max(-1022) - 52;
    let scaled = q.abs() * power_of_two(-unit);
    let floor = scaled.floor().to_integer();
    let rest = scaled - Q::from_integer(floor.clone());
    let half = Q::new(1.into(), 2.into());
    let up = rest > half || rest == half && (&floor % BigInt::from(2)).is_one();
    let mantissa = u64::try_from(floor + BigInt::from(u8::from(up))).unwrap();
    // The mantissa and the exponent add up, carries included.
    let bits = mantissa as u128 + (((unit + 1074) as u128) << 52);
    let double = if bits >= 0x7ff0_0000_0000_0000 {
        f64::INFINITY
    } else {
        f64::from_bits(bits as u64)
    };
    if q.is_negative() { -double } else { double }
}

/// A polynomial with integer coefficients, ascending, the last one not 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Poly(pub(crate) Vec<BigInt>);

impl Poly {
    pub(crate) fn new(mut coefficients: Vec<BigInt>) -> Self {
        while coefficients.last().is_some_and(Zero::is_zero) {
            coefficients.pop();
        }
        Self(coefficients)
    }

    pub(crate) fn of(coefficients: &[i64]) -> Self {
        Self::new(coefficients.iter().map(|&c| c.into()).collect())
    }

    pub(crate) fn of_integers(f: &IntegerPolynomial) -> Self {
        Self::new(f.coefficients_asc().iter().map(big).collect())
    }

    pub(crate) fn to_integers(&self) -> IntegerPolynomial {
        IntegerPolynomial::from_coefficients_asc(self.0.iter().map(integer).collect())
    }

    pub(crate) fn of_coefficients(f: &[Rational]) -> Self {
        Self::new(f.iter().map(|c| BigInt::try_from(c).unwrap()).collect())
    }

    pub(crate) fn to_coefficients(&self) -> Vec<Rational> {
        self.0.iter().map(Rational::from).collect()
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// 0 for constants.
    pub(crate) fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self(Vec::new());
        }
        let mut product = vec![BigInt::zero(); self.0.len() + other.0.len() - 1];
        for (i, a) in self.0.iter().enumerate() {
            for (j, b) in other.0.iter().enumerate() {
                product[i + j] += a * b;
            }
        }
        Self(product)
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        let at = |f: &Self, i: usize| f.0.get(i).cloned().unwrap_or_default();
        let length = self.0.len().max(other.0.len());
        Self::new((0..length).map(|i| at(self, i) + at(other, i)).collect())
    }

    pub(crate) fn scaled(&self, factor: &BigInt) -> Self {
        Self::new(self.0.iter().map(|c| c * factor).collect())
    }

    pub(crate) fn power(&self, exponent: usize) -> Self {
        (0..exponent).fold(Self::of(&[1]), |power, _| power.times(self))
    }

    pub(crate) fn derivative(&self) -> Self {
        let terms = self.0.iter().enumerate().skip(1);
        Self::new(terms.map(|(i, c)| c * BigInt::from(i)).collect())
    }

    /// The quotient by the largest positive integer that divides all coefficients.
    pub(crate) fn primitive(&self) -> Self {
        let content = self.0.iter().fold(BigInt::zero(), |g, c| gcd(&g, c));
        if content.is_zero() {
            return self.clone();
        }
        Self(self.0.iter().map(|c| c / &content).collect())
    }

    /// The remainder by g times |lead of g|^(d + 1), where d is the difference of the degrees.
    fn pseudo_remainder(&self, g: &Self) -> Self {
        let lead = g.0.last().unwrap();
        let (size, flip) = (lead.abs(), lead.is_negative());
        let mut rest = self.0.clone();
        for shift in (0..=self.degree() - g.degree()).rev() {
            let top = rest.pop().unwrap();
            let top = if flip { -top } else { top };
            for (i, c) in rest.iter_mut().enumerate() {
                *c *= &size;
                if i >= shift {
                    *c -= &top * &g.0[i - shift];
                }
            }
        }
        Self::new(rest)
    }

    /// Every coefficient divided, exactly.
    fn divided(&self, by: &BigInt) -> Self {
        let divide = |c: &BigInt| {
            let quotient = c / by;
            assert_eq!(&quotient * by, *c, "the twin divides exactly");
            quotient
        };
        Self(self.0.iter().map(divide).collect())
    }

    /// The signed subresultant chain up to positive factors: each is a negative multiple of a remainder modulo those two before it.
    fn chain(&self, other: &Self) -> Vec<Self> {
        let mut chain = vec![self.clone(), other.clone()];
        let (mut lead, mut height) = (BigInt::one(), BigInt::one());
        loop {
            let (a, b) = (&chain[chain.len() - 2], &chain[chain.len() - 1]);
            if b.is_zero() {
                chain.pop();
                return chain;
            }
            let drop = (a.degree() - b.degree()) as u32;
            let divisor = &lead * height.pow(drop);
            let next = a.pseudo_remainder(b).divided(&-divisor);
            lead = b.0.last().unwrap().abs();
            if drop > 0 {
                height = lead.pow(drop) / height.pow(drop - 1);
            }
            chain.push(next);
        }
    }

    /// The quotient by a primitive polynomial, which divides exactly.
    pub(crate) fn quotient(&self, g: &Self) -> Self {
        let lead = g.0.last().unwrap();
        let mut rest = self.0.clone();
        let mut quotient = vec![BigInt::zero(); (rest.len() + 1).saturating_sub(g.0.len())];
        for i in (0..quotient.len()).rev() {
            let c = &rest[i + g.0.len() - 1] / lead;
            for (j, d) in g.0.iter().enumerate() {
                rest[i + j] -= &c * d;
            }
            quotient[i] = c;
        }
        assert!(rest.iter().all(Zero::is_zero), "the twin divides exactly");
        Self::new(quotient)
    }

    /// A greatest common divisor, primitive with positive lead; the other one may be 0.
    pub(crate) fn gcd(&self, other: &Self) -> Self {
        let (a, b) = (self.primitive(), other.primitive());
        let chain = if a.0.len() < b.0.len() {
            b.chain(&a)
        } else {
            a.chain(&b)
        };
        let last = chain[chain.len() - 1].primitive();
        let negative = last.0.last().is_some_and(Signed::is_negative);
        last.scaled(&BigInt::from(if negative { -1 } else { 1 }))
    }

    /// The sign at a rational number.
    pub(crate) fn sign_at(&self, at: &Q) -> i8 {
        let (p, q) = (at.numer(), at.denom());
        let mut power = BigInt::one();
        let mut value = BigInt::zero();
        for c in self.0.iter().rev() {
            value = value * p + c * &power;
            power *= q;
        }
        sign(&value)
    }

    pub(crate) fn value_at(&self, at: &Q) -> Q {
        let terms = self.0.iter().rev();
        terms.fold(Q::zero(), |v, c| v * at + Q::from_integer(c.clone()))
    }
}

/// The greatest common divisor, by Euclid.
pub(crate) fn gcd(a: &BigInt, b: &BigInt) -> BigInt {
    let (mut a, mut b) = (a.abs(), b.abs());
    while !b.is_zero() {
        (a, b) = (b.clone(), a % &b);
    }
    a
}

pub(crate) fn sign(n: &BigInt) -> i8 {
    if n.is_zero() {
        0
    } else if n.is_positive() {
        1
    } else {
        -1
    }
}

/// The Sturm chain of a polynomial divided by the last of it: distinct roots are counted, also of one with multiple roots.
pub(crate) struct Sturm {
    chain: Vec<Poly>,
    /// The greatest common divisor of the polynomial and its derivative.
    pub(crate) repeated: Poly,
}

impl Sturm {
    pub(crate) fn new(f: &Poly) -> Self {
        let f = f.primitive();
        let mut chain = f.chain(&f.derivative());
        let mut repeated = Poly::of(&[1]);
        if chain[chain.len() - 1].degree() > 0 {
            repeated = chain[chain.len() - 1].primitive();
            if repeated.0[repeated.degree()].is_negative() {
                repeated = repeated.scaled(&BigInt::from(-1));
            }
            chain = chain.iter().map(|p| p.quotient(&repeated)).collect();
        }
        Self { chain, repeated }
    }

    fn changes(signs: impl Iterator<Item = i8>) -> usize {
        let signs: Vec<i8> = signs.filter(|s| *s != 0).collect();
        signs.windows(2).filter(|w| w[0] != w[1]).count()
    }

    fn changes_at(&self, at: &Q) -> usize {
        Self::changes(self.chain.iter().map(|p| p.sign_at(at)))
    }

    fn changes_at_infinity(&self, positive: bool) -> usize {
        let at = |p: &Poly| {
            let lead = sign(p.0.last().unwrap());
            if positive || p.degree().is_multiple_of(2) {
                lead
            } else {
                -lead
            }
        };
        Self::changes(self.chain.iter().map(at))
    }

    /// All distinct real roots.
    pub(crate) fn count(&self) -> usize {
        self.changes_at_infinity(false) - self.changes_at_infinity(true)
    }

    /// Those that are at most so large.
    pub(crate) fn count_up_to(&self, high: &Q) -> usize {
        self.changes_at_infinity(false) - self.changes_at(high)
    }

    /// Those x with low < x ≤ high.
    pub(crate) fn count_between(&self, low: &Q, high: &Q) -> usize {
        self.changes_at(low) - self.changes_at(high)
    }

    /// Whether it is a root.
    pub(crate) fn vanishes_at(&self, at: &Q) -> bool {
        self.chain[0].sign_at(at) == 0
    }

    /// Those between, without and with the ends.
    pub(crate) fn count_open_and_closed(&self, low: &Q, high: &Q) -> [usize; 2] {
        let half_open = self.count_between(low, high);
        let open = half_open - usize::from(low < high && self.vanishes_at(high));
        [open, half_open + usize::from(self.vanishes_at(low))]
    }
}

/// The chains of f, of the common divisor of f and its derivative, and so on: a root of multiplicity m is a root of m of them.
pub(crate) fn tower(f: &Poly) -> Vec<Sturm> {
    let mut chains = Vec::new();
    let mut next = f.clone();
    while next.degree() > 0 {
        let sturm = Sturm::new(&next);
        next = sturm.repeated.clone();
        chains.push(sturm);
    }
    chains
}

#[test]
fn the_twin_counts_and_rounds() {
    // (x − 1)² (x + 2) (x² + 1)
    let f = Poly::of(&[-1, 1])
        .power(2)
        .times(&Poly::of(&[2, 1]))
        .times(&Poly::of(&[1, 0, 1]));
    let chains = tower(&f);
    assert_eq!(
        [chains[0].count(), chains[1].count(), chains.len()],
        [2, 1, 2]
    );
    assert_eq!(
        chains[0].count_open_and_closed(&whole(-2), &whole(1)),
        [0, 2]
    );
    assert_eq!(chains[0].count_up_to(&whole(0)), 1);
    for double in [0.1, 1.0, -3.5e300, 5e-324, f64::MAX, 2.5e-310] {
        assert_eq!(nearest(&value(double)), double);
        let [low, high] = rounding_interval(double);
        let even = [&low, &high].map(|m| nearest(m) == double);
        assert_eq!(even, [is_even(double); 2], "{double}");
    }
}
