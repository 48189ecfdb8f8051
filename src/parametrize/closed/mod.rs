//! Closed forms of r for up to five equally spaced homogeneous parts (Lemmas 2–5 in the plane, 7–10 in
//! space: the same formulas over other forms), and the exact ranges in which they are real.

mod forms;
mod lemma2;
mod lemma3;
mod lemma4;
mod lemma5;
mod quartic;
mod quartic_signs;

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
    /// A formula, and where it holds.
    pub(super) roots: Vec<(Expression<F>, Rule)>,
    /// The forms whose signs the rules ask for.
    pub(super) critical: Vec<F>,
}

/// Which formula it is: this decides where it holds, and its sign.
#[derive(Clone, Copy, Debug)]
pub(super) enum Rule {
    /// Lemma 2.
    Linear,
    /// Lemma 3, with the sign of the square root.
    Quadratic(i8),
    /// Lemma 4 by cube roots: the one real root.
    CubicOne,
    /// Lemma 4 in cosine form: the j-th of three real roots.
    CubicThree(usize),
    /// Lemma 5.
    Quartic { cosine: bool, index: Index },
    /// Lemma 5 where the linear term of the depressed quartic vanishes.
    Biquadratic(Index),
}

/// The lemmas solve polynomials in R^k up to this degree.
pub(super) const LARGEST_SOLVED_DEGREE: usize = 4;

/// The closed forms for 2 to 5 parts, in descending order; `None` for another number.
pub(super) fn solve<F: LemmaForm>(parts: &[F]) -> Option<Solved<F>> {
    match parts {
        [s, q] => Some(lemma2::lemma_2([s, q])),
        [s, p, q] => Some(lemma3::lemma_3([s, p, q])),
        [s, p, q, u] => Some(lemma4::lemma_4([s, p, q, u])),
        [s, p, q, u, v] => Some(lemma5::lemma_5([s, p, q, u, v])),
        _ => None,
    }
}

/// The discriminant in R of 3 to 5 parts, descending; `None` for another number.
pub(super) fn discriminant<F: LemmaForm>(parts: &[F]) -> Option<F> {
    match parts {
        [s, p, q] => Some(lemma3::discriminant([s, p, q])),
        [s, p, q, u] => Some(lemma4::discriminant([s, p, q, u])),
        [s, p, q, u, v] => Some(quartic::discriminant([s, p, q, u, v])),
        _ => None,
    }
}

impl Rule {
    /// Whether the formula is real nowhere else than where it is the root that the rule says. Square roots and quotients are;
    /// arccosines beyond 1 and sums of conjugate cube roots are real again where they belong to another root, or to none.
    pub(super) fn holds_where_real(self) -> bool {
        match self {
            Self::Linear | Self::Quadratic(_) => true,
            Self::CubicOne | Self::CubicThree(_) | Self::Quartic { .. } | Self::Biquadratic(_) => {
                false
            }
        }
    }

    /// Where the formula is real, finite and the root that the rule says: the same as the rule's sign being known.
    ///
    /// `critical` are the forms of the [`Solved`] that the rule is from.
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
                // Where s = 0 the formula has no value; the root that stays finite is its limit.
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

/// [`Signs::all_real`] but for s ≠ 0.
fn all_real(forms: &quartic_signs::Critical<TernaryForm>) -> Vec<Condition> {
    vec![
        Condition::form(&forms.discriminant, Relation::AtLeastZero),
        Condition::form(&forms.a, Relation::Negative),
        Condition::form(&forms.inner, Relation::AtLeastZero),
        Condition::form(&forms.resolvent_p, Relation::Negative),
    ]
}

/// Where a branch is real.
#[derive(Clone, Debug)]
pub(super) struct Ranges {
    /// Where r is real and finite, of either sign.
    pub(super) real: Vec<AngleRange>,
    /// Where r > 0.
    pub(super) positive: Vec<AngleRange>,
}

/// The branches r of one root R = r^k: one for odd k, two of opposite sign for even k.
pub(super) fn branches_of<F: LemmaForm>(root: &Expression<F>, k: u32) -> Vec<Expression<F>> {
    let radius = root.clone().root(k);
    if k.odd() {
        return vec![radius];
    }
    vec![radius.clone(), radius.negated()]
}

/// Where the branches of every rule are real, in the order of [`branches_of`] for every root: exact ranges of
/// the angle of the plane.
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

/// The exact signs of the branches in the direction of a rational vector, in the same order; `None` where a
/// formula has no real value.
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

/// The exact sign of the root R that a formula gives at a place, with the cells beside a mark; `None` where it is
/// not real, not finite, or not given by this formula.
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
        Rule::Biquadratic(index) => (Signs::of(at).biquadratic_real(), index),
    };
    real.then(|| quartic?.sign_of(at, beside, index)).flatten()
}
