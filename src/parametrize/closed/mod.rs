//! Closed forms of r for up to five homogeneous parts of equally spaced degrees, with the exact ranges in which they are real:
//! Lemmas 2–5 in the plane, and Lemmas 7–10 in space, which are the same formulas with other forms.

mod forms;
mod lemma2;
mod lemma3;
mod lemma4;
mod lemma5;
mod quartic;
mod quartic_signs;
mod symmetric;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Parity;

use super::angle::AngleRange;
use super::cells::{Cells, SignedDirection};
use super::condition::{Condition, Relation};
use super::expression::Expression;
use crate::poly::{BinaryForm, TernaryForm};

pub(super) use forms::{LemmaForm, integer_square_part, squarefree_kernel};
use quartic::Index;
use quartic_signs::{QuarticRoots, Signs};

/// The formulas for the roots R of `Σ parts[i] R^(n−i) = 0`, n = 1 … 4.
#[derive(Clone, Debug)]
pub(super) struct Solved<F> {
    /// The formulas, each with the rule that decides where it holds.
    pub(super) roots: Vec<(Expression<F>, Rule)>,
    /// The forms whose signs the rules use.
    pub(super) critical: Vec<F>,
}

/// The kind of a formula. It decides where the formula holds, and the sign of its value.
#[derive(Clone, Copy, Debug)]
pub(super) enum Rule {
    /// Lemma 2, one root.
    Linear,
    /// Lemma 3, with the sign of the square root.
    Quadratic(i8),
    /// Lemma 4 by cube roots, for the only real root.
    CubicOne,
    /// Lemma 4 in cosine form, for the j-th of three real roots.
    CubicThree(usize),
    /// Lemma 5 in general.
    Quartic { cosine: bool, index: Index },
    /// Lemma 5, in a direction in which the linear term of the depressed quartic vanishes.
    Biquadratic(Index),
    /// Lemma 5, if the linear term of the depressed quartic vanishes in every direction.
    SymmetricQuartic(Index),
}

/// The lemmas solve polynomials in R = r^k up to this degree.
pub(super) const LARGEST_SOLVED_DEGREE: usize = 4;

/// The closed forms for 2 to 5 parts, given in descending order; `None` for another number of parts.
pub(super) fn solve<F: LemmaForm>(parts: &[F]) -> Option<Solved<F>> {
    match parts {
        [s, q] => Some(lemma2::lemma_2([s, q])),
        [s, p, q] => Some(lemma3::lemma_3([s, p, q])),
        [s, p, q, u] => Some(lemma4::lemma_4([s, p, q, u])),
        [s, p, q, u, v] => Some(lemma5::lemma_5([s, p, q, u, v])),
        _ => None,
    }
}

/// The discriminant with respect to R for 3 to 5 parts, given in descending order; `None` for another number of parts.
pub(super) fn discriminant<F: LemmaForm>(parts: &[F]) -> Option<F> {
    match parts {
        [s, p, q] => Some(lemma3::discriminant([s, p, q])),
        [s, p, q, u] => Some(lemma4::discriminant([s, p, q, u])),
        [s, p, q, u, v] => Some(quartic::discriminant([s, p, q, u, v])),
        _ => None,
    }
}

impl Rule {
    /// Whether the formula is real only where it is the root that the rule stands for. This is so for square roots and
    /// quotients. Arccosines of numbers beyond 1 and sums of conjugate cube roots are real again where they are another root or
    /// none.
    pub(super) fn holds_where_real(self) -> bool {
        match self {
            Self::Linear | Self::Quadratic(_) | Self::SymmetricQuartic(_) => true,
            Self::CubicOne | Self::CubicThree(_) | Self::Quartic { .. } | Self::Biquadratic(_) => {
                false
            }
        }
    }

    /// The condition under which the formula is real, finite and the root that the rule stands for, that is the condition under
    /// which the rule knows its sign.
    ///
    /// `critical` must be the forms of the [`Solved`] to which the rule belongs.
    pub(super) fn condition(self, critical: &[TernaryForm]) -> Condition {
        use Relation::{AtLeastZero, AtMostZero, Negative, NotZero, Positive, Zero};
        let form = Condition::form;
        match self {
            Self::Linear => {
                let forms = lemma2::Critical::named(critical);
                form(&forms.top, NotZero)
            }
            Self::Quadratic(_) => {
                let forms = lemma3::Critical::named(critical);
                let real =
                    Condition::any([form(&forms.inside, AtLeastZero), form(&forms.outside, Zero)]);
                // At s = 0 the formula has no value; the root that stays finite is its limit.
                let finite = form(&forms.s, NotZero);
                Condition::all([finite, real])
            }
            Self::CubicOne => {
                let forms = lemma4::Critical::named(critical);
                Condition::all([
                    form(&forms.s, NotZero),
                    form(&forms.discriminant, AtMostZero),
                ])
            }
            Self::CubicThree(_) => {
                let forms = lemma4::Critical::named(critical);
                Condition::all([
                    form(&forms.s, NotZero),
                    form(&forms.discriminant, AtLeastZero),
                    form(&forms.big_p, Negative),
                ])
            }
            Self::Quartic { cosine: true, .. } => {
                let forms = quartic_signs::Critical::named(critical);
                let mut all = vec![form(&forms.s, NotZero)];
                all.extend(all_real(&forms));
                Condition::all(all)
            }
            Self::Quartic { index, .. } => {
                let forms = quartic_signs::Critical::named(critical);
                let sign = if index.pair > 0 { Negative } else { Positive };
                let triple = Condition::all([
                    form(&forms.discriminant, Zero),
                    form(&forms.resolvent_p, Zero),
                    form(&forms.b, NotZero),
                ]);
                Condition::all([
                    form(&forms.s, NotZero),
                    form(&forms.discriminant, AtMostZero),
                    Condition::all(all_real(&forms)).negated(),
                    Condition::any([form(&forms.b, sign), triple]),
                ])
            }
            Self::SymmetricQuartic(index) => {
                symmetric::condition(&quartic_signs::Critical::named(critical), index)
            }
            Self::Biquadratic(_) => {
                let forms = quartic_signs::Critical::named(critical);
                Condition::all([
                    form(&forms.s, NotZero),
                    form(&forms.b, Zero),
                    Condition::all(all_real(&forms)).negated(),
                    form(&forms.inner, AtLeastZero),
                    Condition::any([form(&forms.a, AtMostZero), form(&forms.c, AtMostZero)]),
                ])
            }
        }
    }
}

/// The conditions of [`Signs::all_real`] except s ≠ 0.
fn all_real(forms: &quartic_signs::Critical<TernaryForm>) -> Vec<Condition> {
    vec![
        Condition::form(&forms.discriminant, Relation::AtLeastZero),
        Condition::form(&forms.a, Relation::Negative),
        Condition::form(&forms.inner, Relation::AtLeastZero),
        Condition::form(&forms.resolvent_p, Relation::Negative),
    ]
}

/// The exact ranges in which a branch is real.
#[derive(Clone, Debug)]
pub(super) struct Ranges {
    /// The ranges in which r is real and finite, of either sign.
    pub(super) real: Vec<AngleRange>,
    /// The ranges in which r > 0.
    pub(super) positive: Vec<AngleRange>,
}

/// The branches r of a root R = r^k: one if k is odd, two of opposite sign if k is even.
pub(super) fn branches_of<F: LemmaForm>(root: &Expression<F>, k: u32) -> Vec<Expression<F>> {
    let radius = root.clone().root(k);
    if k.odd() {
        return vec![radius];
    }
    vec![radius.clone(), radius.negated()]
}

/// The exact ranges of the angle in which the branches are real, for all rules and in the order of [`branches_of`] for each
/// root.
pub(super) fn ranges(
    rules: impl IntoIterator<Item = Rule>,
    critical: &[BinaryForm],
    parts: &[BinaryForm],
    k: u32,
) -> Vec<Ranges> {
    let cells = Cells::cut(&critical.iter().collect::<Vec<_>>());
    let quartic = QuarticRoots::new(parts);
    let ranges = rules.into_iter().flat_map(|rule| {
        let sign = |at: &SignedDirection, beside: &[&SignedDirection]| {
            sign(rule, at, beside, quartic.as_ref())
        };
        ranges_of(&cells, k, sign)
    });
    ranges.collect()
}

/// The exact signs of the branches in the direction of a rational vector, in the same order; `None` if a formula has no real
/// value.
pub(super) fn signs_at(
    vector: (Integer, Integer),
    rules: impl IntoIterator<Item = Rule>,
    critical: &[BinaryForm],
    parts: &[BinaryForm],
    k: u32,
) -> Vec<Option<i8>> {
    let place = SignedDirection::rational(&critical.iter().collect::<Vec<_>>(), vector);
    let quartic = QuarticRoots::new(parts);
    let signs = rules.into_iter().flat_map(|rule| {
        let sign = sign(rule, &place, &[], quartic.as_ref());
        if k.odd() {
            return vec![sign];
        }
        let real = sign.filter(|&s| s >= 0);
        vec![real, real.map(|s| -s)]
    });
    signs.collect()
}

fn ranges_of(
    cells: &Cells,
    k: u32,
    sign: impl Fn(&SignedDirection, &[&SignedDirection]) -> Option<i8>,
) -> Vec<Ranges> {
    let positive = cells.ranges(|at, beside| sign(at, beside) == Some(1));
    if k.odd() {
        return vec![Ranges {
            real: cells.ranges(|at, beside| sign(at, beside).is_some()),
            positive,
        }];
    }
    let real = cells.ranges(|at, beside| sign(at, beside).is_some_and(|v| v >= 0));
    let negative = Ranges {
        real: real.clone(),
        positive: Vec::new(),
    };
    vec![Ranges { real, positive }, negative]
}

/// The exact sign of the root R that a formula gives in a direction, from the cells beside it if it is a mark. `None` if the
/// root is not real, not finite, or not given by this formula.
fn sign(
    rule: Rule,
    at: &SignedDirection,
    beside: &[&SignedDirection],
    quartic: Option<&QuarticRoots<'_>>,
) -> Option<i8> {
    let (real, index) = match rule {
        Rule::Linear => return lemma2::sign(at),
        Rule::Quadratic(of_root) => return lemma3::sign(at, of_root),
        Rule::CubicOne => return lemma4::sign_of_one(at),
        Rule::CubicThree(rank) => return lemma4::sign_of_three(at, rank),
        Rule::Quartic {
            cosine: true,
            index,
        } => (Signs::of(at).all_real(), index),
        Rule::Quartic { index, .. } => (Signs::of(at).pair_real(index.pair), index),
        Rule::SymmetricQuartic(index) => return symmetric::sign(quartic?, at, beside, index),
        Rule::Biquadratic(index) => (Signs::of(at).biquadratic_real(), index),
    };
    real.then(|| quartic?.sign_of(at, beside, index)).flatten()
}
