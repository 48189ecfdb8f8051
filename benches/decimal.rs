//! Long numbers in decimal: a ladder over their length, beside malachite and `num-bigint`.
//!
//! `cargo bench --bench decimal`. Every answer is verified before it is timed.

#![expect(clippy::unwrap_used, reason = "a bench fails by panicking")]

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use malachite::Integer;
use malachite::base::num::basic::traits::One;
use mimalloc::MiMalloc;
use num_bigint::BigInt;
use stellate::exact::Rational;

/// As in the program.
#[global_allocator]
static ALLOCATOR: MiMalloc = MiMalloc;

#[path = "../tests/common/mod.rs"]
mod common;
use common::random::SplitMix;

fn decimal(c: &mut Criterion) {
    let mut group = c.benchmark_group("decimal");
    group.sample_size(20);
    let mut random = SplitMix(0x9E37_79B9_7F4A_7C15);
    // In limbs of 64 bits, all of them in use.
    for limbs in [1, 4, 20, 200, 400, 2000] {
        let bits = 64 * limbs - 1;
        let number = random.integer(bits) | Integer::ONE << bits;
        let rational = Rational::from(stellate::exact::integer_to_num(&number));
        let of_num = BigInt::try_from(&rational).unwrap();
        // The three of them agree, and the digits are those of the number.
        let digits = rational.to_string();
        assert_eq!(digits, number.to_string());
        assert_eq!(digits, of_num.to_string());
        assert_eq!(digits.parse::<Rational>().unwrap(), rational);

        group.bench_with_input(BenchmarkId::new("stellate", limbs), &rational, |b, x| {
            b.iter(|| black_box(x).to_string());
        });
        group.bench_with_input(BenchmarkId::new("malachite", limbs), &number, |b, x| {
            b.iter(|| black_box(x).to_string());
        });
        group.bench_with_input(BenchmarkId::new("num_bigint", limbs), &of_num, |b, x| {
            b.iter(|| black_box(x).to_string());
        });
    }
    group.finish();
}

criterion_group!(benches, decimal);
criterion_main!(benches);
