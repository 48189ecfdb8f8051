//! Quartics in R whose coefficients are forms: the discriminant, the depressed form, and the names of the roots.

use super::forms::{LemmaForm, product};

/// The name of a real root: `pair` is 1 for the two larger y, −1 for the two smaller ones, and 0 if there are only two; `sign`
/// is 1 for the larger root of the pair and −1 for the smaller one.
#[derive(Clone, Copy, Debug)]
pub(in crate::parametrize) struct Index {
    pub(super) pair: i8,
    pub(super) sign: i8,
}

/// The names of four real roots, from the largest y to the smallest.
pub(super) const ROOTS: [Index; 4] = [
    Index { pair: 1, sign: 1 },
    Index { pair: 1, sign: -1 },
    Index { pair: -1, sign: 1 },
    Index { pair: -1, sign: -1 },
];

/// 256s³v³ − 192s²puv² − 128s²q²v² + 144s²qu²v − 27s²u⁴ + 144sp²qv² − 6sp²u²v − 80spq²uv + 18spqu³ + 16sq⁴v −
/// 4sq³u² − 27p⁴v² + 18p³quv − 4p³u³ − 4p²q³v + p²q²u²
pub(super) fn discriminant<F: LemmaForm>([s, p, q, u, v]: [&F; 5]) -> F {
    let rest: [(i64, &[&F]); 15] = [
        (-192, &[s, s, p, u, v, v]),
        (-128, &[s, s, q, q, v, v]),
        (144, &[s, s, q, u, u, v]),
        (-27, &[s, s, u, u, u, u]),
        (144, &[s, p, p, q, v, v]),
        (-6, &[s, p, p, u, u, v]),
        (-80, &[s, p, q, q, u, v]),
        (18, &[s, p, q, u, u, u]),
        (16, &[s, q, q, q, q, v]),
        (-4, &[s, q, q, q, u, u]),
        (-27, &[p, p, p, p, v, v]),
        (18, &[p, p, p, q, u, v]),
        (-4, &[p, p, p, u, u, u]),
        (-4, &[p, p, q, q, q, v]),
        (1, &[p, p, q, q, u, u]),
    ];
    let first = product(256, &[s, s, s, v, v, v]);
    rest.iter()
        .fold(first, |sum, (c, forms)| sum.plus(&product(*c, forms)))
}

/// The coefficients A = 16sq − 6p², B and C of the quartic y⁴ + Ay² + By + C in y = 4sR + p.
pub(super) fn depressed<F: LemmaForm>([s, p, q, u, v]: [&F; 5]) -> [F; 3] {
    let a = product(16, &[s, q]).plus(&product(-6, &[p, p]));
    let b = product(64, &[s, s, u])
        .plus(&product(-32, &[s, p, q]))
        .plus(&product(8, &[p, p, p]));
    let c = product(256, &[s, s, s, v])
        .plus(&product(-64, &[s, s, p, u]))
        .plus(&product(16, &[s, p, p, q]))
        .plus(&product(-3, &[p, p, p, p]));
    [a, b, c]
}
