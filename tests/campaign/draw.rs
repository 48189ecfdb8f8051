//! Draws: random numbers, and those that bounded arithmetic and rounding find hard.

#![allow(dead_code, reason = "every program uses its own part of this")]

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::common::random::SplitMix;

/// What a case is drawn from, and how it describes its input.
pub(crate) struct Draw {
    words: SplitMix,
    /// The input of the case, as a command if possible.
    pub(crate) input: String,
}

impl Draw {
    /// Determined by the kind and the seed.
    pub(crate) fn new(kind: &str, seed: u64) -> Self {
        let mix = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        let hash = kind.bytes().fold(0xcbf2_9ce4_8422_2325, mix);
        let mut words = SplitMix(seed);
        let first = words.word();
        Self {
            words: SplitMix(first ^ hash),
            input: String::new(),
        }
    }

    pub(crate) fn word(&mut self) -> u64 {
        self.words.word()
    }

    /// From 0 to n − 1.
    pub(crate) fn below(&mut self, n: u64) -> u64 {
        self.word() % n
    }

    /// The same for an index.
    pub(crate) fn index(&mut self, n: usize) -> usize {
        self.below(n as u64) as usize
    }

    /// Once in n times.
    pub(crate) fn once_in(&mut self, n: u64) -> bool {
        self.below(n) == 0
    }

    /// Between −size and size.
    pub(crate) fn small(&mut self, size: i64) -> i64 {
        self.below(2 * size as u64 + 1) as i64 - size
    }

    pub(crate) fn pick<T: Clone>(&mut self, from: &[T]) -> T {
        from[self.index(from.len())].clone()
    }

    /// A positive integer of this many bits, of which long runs are all ones or all zeros half of the time.
    pub(crate) fn natural(&mut self, bits: u64) -> BigInt {
        let bits = bits.max(1);
        let mut value = BigInt::one();
        for _ in 0..bits / 64 + 1 {
            let limb = match self.below(6) {
                0 => u64::MAX,
                1 => 0,
                2 => 1 << self.below(64),
                _ => self.word(),
            };
            value = (value << 64u32) + BigInt::from(limb);
        }
        value >> (64 * (bits / 64 + 1) + 1 - bits)
    }

    /// The same of either sign.
    pub(crate) fn integer(&mut self, bits: u64) -> BigInt {
        let value = self.natural(bits);
        if self.once_in(2) { value } else { -value }
    }

    /// Mostly small fractions, some doubles, some long ones; sometimes 0.
    pub(crate) fn rational(&mut self) -> BigRational {
        match self.below(12) {
            0 => BigRational::zero(),
            1 => {
                let double = self.double(8);
                BigRational::from_float(double).unwrap()
            }
            2 => {
                let bits = 1 + self.below(200);
                BigRational::new(self.integer(bits), self.natural(bits))
            }
            _ => BigRational::new(self.small(60).into(), (1 + self.below(12)).into()),
        }
    }

    /// A fraction that is not 0.
    pub(crate) fn nonzero(&mut self) -> BigRational {
        let value = self.rational();
        if value.is_zero() {
            BigRational::one()
        } else {
            value
        }
    }

    /// A small fraction.
    pub(crate) fn fraction(&mut self, size: i64, denominator: u64) -> BigRational {
        BigRational::new(
            self.small(size).into(),
            (1 + self.below(denominator)).into(),
        )
    }

    /// A normal double of either sign, of a size between 2^−exponent and 2^exponent, with any mantissa or one that is all
    /// zeros or all ones.
    pub(crate) fn double(&mut self, exponent: u64) -> f64 {
        let mantissa = match self.below(6) {
            0 => 0,
            1 => (1 << 52) - 1,
            2 => 1,
            _ => self.word() >> 12,
        };
        let exponent = 1023 - exponent + self.below(2 * exponent);
        let sign = self.word() & (1 << 63);
        f64::from_bits(sign | exponent << 52 | mantissa)
    }

    /// 2^−60, 2^−200 or 1/2 ulp of a double relatively, of either sign, or 0.
    pub(crate) fn tiny(&mut self) -> BigRational {
        let shift = self.pick(&[53u32, 60, 60, 61, 100, 200]);
        let value = BigRational::new(BigInt::one(), BigInt::one() << shift);
        match self.below(3) {
            0 => BigRational::zero(),
            1 => value,
            _ => -value,
        }
    }

    /// Three integers (u, v, w) with u² + v² + w² a square, and the root of that; of about so many bits.
    pub(crate) fn unit3(&mut self, bits: u64) -> ([BigInt; 3], BigInt) {
        let bits = bits.max(2) / 2 + 1;
        let [m, n, p, q] = [0; 4].map(|_: i32| self.integer(bits));
        let vector = [
            &m * &m + &n * &n - &p * &p - &q * &q,
            (&m * &q + &n * &p) * 2,
            (&n * &q - &m * &p) * 2,
        ];
        (vector, &m * &m + &n * &n + &p * &p + &q * &q)
    }

    /// Two integers with u² + v² = w², likewise.
    pub(crate) fn unit2(&mut self, bits: u64) -> ([BigInt; 2], BigInt) {
        let bits = bits.max(2) / 2 + 1;
        let [m, n] = [0; 2].map(|_: i32| self.integer(bits));
        let (a, b, w) = (&m * &m - &n * &n, &m * &n * 2, &m * &m + &n * &n);
        (if self.once_in(2) { [a, b] } else { [b, a] }, w)
    }
}
