//! The limits of the input language, and the account that keeps an expansion within them.

use super::source::{Source, Span};
use crate::error::Result;

/// The longest text that is read: 256 MiB.
pub const MAX_TEXT_BYTES: usize = 256 << 20;

/// The deepest nesting of parentheses and of towers of `^`.
pub const MAX_NESTING: u32 = 256;

/// The largest exponent of one power, and the largest total degree after expansion.
pub const MAX_DEGREE: u32 = 20_002;

/// The largest number of terms of a polynomial after expansion.
pub const MAX_TERMS: usize = 5_000_000;

/// The largest index n of `cos(n*t)` and `sin(n*t)`.
pub const MAX_HARMONIC: u32 = 100_000;

/// The largest number of digits of one number, written or computed.
pub const MAX_DIGITS: usize = 10_000_000;

/// The largest number of products of coefficients, computed term by term, in the expansion of one text. Each is counted with
/// the number of its 64-bit words.
pub const MAX_PRODUCTS: u64 = 1 << 25;

/// The largest number of bits that the products and powers of one text, or the coefficients of one polynomial over their common
/// denominator, may have in all: 2 GiB.
pub const MAX_BITS: u64 = 1 << 34;

/// The largest number of coefficients, with the zeros between them, of the homogeneous parts of a plane polynomial or of a
/// polynomial that is expanded.
pub const MAX_COEFFICIENTS: usize = 20_000_000;

/// The amounts that the expansion of one text may still spend.
#[derive(Debug)]
pub(super) struct Budget {
    products: u64,
    bits: u64,
}

impl Budget {
    pub(super) fn new() -> Self {
        Self {
            products: MAX_PRODUCTS,
            bits: MAX_BITS,
        }
    }

    /// Accounts for `count` products of coefficients with `bits` bits, before they are made.
    pub(super) fn spend_products(
        &mut self,
        count: u64,
        bits: u64,
        source: Source<'_>,
        at: Span,
    ) -> Result<()> {
        let work = count.saturating_mul(bits / 64 + 1);
        let limit = || {
            format!(
                "expanding takes more than {MAX_PRODUCTS} products of 64-bit parts of coefficients"
            )
        };
        spend(&mut self.products, work, limit, source, at)
    }

    /// Accounts for `count` numbers of about `bits` bits each, before they are computed.
    pub(super) fn spend_bits(
        &mut self,
        count: u64,
        bits: u64,
        source: Source<'_>,
        at: Span,
    ) -> Result<()> {
        // Ten bits are about three digits.
        if bits / 10 > MAX_DIGITS as u64 / 3 {
            let limit = format!("a number of more than {MAX_DIGITS} digits");
            return Err(source.limit(at, limit));
        }
        let all = count.saturating_mul(bits);
        let limit = || format!("the expanded coefficients have more than {MAX_BITS} bits in all");
        spend(&mut self.bits, all, limit, source, at)
    }
}

/// Subtracts an amount from the rest; the error says which limit is reached.
fn spend(
    left: &mut u64,
    amount: u64,
    limit: impl FnOnce() -> String,
    source: Source<'_>,
    at: Span,
) -> Result<()> {
    *left = left
        .checked_sub(amount)
        .ok_or_else(|| source.limit(at, limit()))?;
    Ok(())
}
