//! Minima of functions of an angle, in doubles.

use std::f64::consts::TAU;

/// The number of angles at which a radius is evaluated to find its nearest and its farthest point.
pub(super) const ANGLES: usize = 4096;

/// The angle with this number, which need not be whole.
pub(super) fn angle(k: f64) -> f64 {
    k * TAU / real(ANGLES)
}

#[expect(clippy::cast_precision_loss, reason = "a small count")]
pub(super) fn real(count: usize) -> f64 {
    count as f64
}

/// The indices of the local minima of values around a circle, the least first; 0 if no values can be compared.
pub(super) fn minima(values: &[f64]) -> Vec<usize> {
    let count = values.len();
    let is_low = |&k: &usize| {
        values[k] <= values[(k + 1) % count] && values[k] <= values[(k + count - 1) % count]
    };
    let mut found: Vec<usize> = (0..count).filter(is_low).collect();
    found.sort_unstable_by(|&i, &j| values[i].total_cmp(&values[j]).then(i.cmp(&j)));
    if found.is_empty() {
        found.push(0);
    }
    found
}

/// Where the function has its minimum between the neighbours of an index: the golden section.
pub(super) fn narrowed(index: usize, value: impl Fn(f64) -> f64) -> f64 {
    let ratio = 0.618_033_988_749_895;
    let (mut low, mut high) = (real(index) - 1.0, real(index) + 1.0);
    for _ in 0..60 {
        let a = high - ratio * (high - low);
        let b = low + ratio * (high - low);
        if value(a) < value(b) {
            high = b;
        } else {
            low = a;
        }
    }
    f64::midpoint(low, high)
}
