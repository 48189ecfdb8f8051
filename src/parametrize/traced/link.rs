//! The real roots R of P(t, ·) on both sides of one critical t: which root below continues as which root above, and which
//! roots meet, tend to 0 or tend to infinity there.
//!
//! Below, α is the critical t, and the *window* is an interval [t−, t+] that holds α and no other critical t. So the real roots
//! at t− are those just below α, and the real roots at t+ those just above it. *Separators* cut the strip window × ℝ into
//! *bands*: a separator is an R with P(t, R) ≠ 0 for all t in the window, so no root leaves its band. A band is *ordinary*
//! unless its roots tend to 0 or to ±∞ at α.
//!
//! Lemma 1. If an ordinary band has one root at t− and one at t+, both tend to the same root at α.
//! Proof. A root of odd multiplicity at α has an odd number of real roots near it on each side, one of even multiplicity an
//! even number. The one root below tends to a root of odd multiplicity, so the one root above tends to it, too.
//!
//! Lemma 2. If α is no zero of the discriminant, no two roots meet at α. If α is a simple zero of it, and at most one root
//! tends to 0 and at most one to infinity, exactly one pair of roots meets at α, and it is real on one side of α only.
//! Proof. Up to a factor that is not 0 at α, the discriminant of P is the product of the discriminants of its local factors, one
//! for each multiple root at α. Each of these vanishes at α, to an order of at least 2 if the root is triple or more. So a simple
//! zero leaves one double root. It is real, as complex ones come in pairs, and its discriminant changes its sign at α.
//!
//! Lemma 3. Let one ordinary band have two roots on each side, which tend to one double root at α, and let no other two roots
//! meet at α, complex ones included. If α is a zero of the discriminant of multiplicity k, the two roots cross if k/2 is odd and
//! touch if it is even.
//! Proof. The two roots are the zeros of a quadratic factor with analytic coefficients (Weierstrass). Its discriminant is
//! (t − α)^k times an analytic function without a zero; it is positive on both sides, so k is even and the difference of the two
//! analytic roots is (t − α)^(k/2) times such a function.
//!
//! Laws: `branches_are_the_certified_roots`, `folds_nodes_cusps_and_asymptotes`, `isolated_points_are_kept`.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::logic::traits::SignificantBits;

use super::count::{count_roots, zero_multiplicity};
use crate::error::Result;
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{IntegerPolynomial, Weights, squarefree_decomposition};
use crate::roots::{RealRoot, real_roots, strictly_between};
use crate::topology::{Strip, range};

/// How often the window around an irrational α is narrowed, by at least 8 bits each time, before the search for separators ends.
/// Several roots that may meet at α or may only come near each other are then left unpaired.
const MAX_ROUNDS: u32 = 60;

/// The roots R just below and just above a critical t = α, and their limits at α. The rank of a root is its index among the roots
/// of its side, ascending.
#[derive(Clone, Debug, Default)]
pub(super) struct Link {
    /// The sign of the limit of each root below α, then the same for the roots above; `None` stands for an infinite limit.
    pub(super) limits: [Vec<Option<i8>>; 2],
    /// Pairs (rank below, rank above) of roots that are one continuous root.
    pub(super) pairs: Vec<(usize, usize)>,
    /// The signs of the real roots of P(α, ·) to which no real root below or above tends.
    pub(super) isolated: Vec<i8>,
    /// Whether R = 0 is a root at α.
    pub(super) zero: bool,
    /// Whether the leading coefficient vanishes at α.
    pub(super) loses: bool,
    /// The signs of the distinct real roots R ≠ 0 at α, ascending.
    pub(super) finite: Vec<i8>,
    /// Whether the other fields are complete. If they are not, some roots that continue through α are not paired, and an
    /// isolated root may be missing.
    pub(super) complete: bool,
}

/// A critical t.
pub(super) enum Critical<'a> {
    /// A rational number, and a distance within which there is no other critical t.
    Rational(&'a Rational, Rational),
    /// An irrational number, as a root whose enclosure holds no other critical t.
    Irrational(&'a RealRoot),
}

/// The polynomial P, and the properties of it at α that are known beforehand.
pub(super) struct Context<'a> {
    pub(super) strip: &'a Strip,
    pub(super) weights: Weights,
    /// The step of the weights.
    pub(super) step: usize,
    /// The multiplicity of α as a root of the discriminant.
    pub(super) multiplicity: usize,
    pub(super) limits: &'a Limits,
}

/// The ranks of the roots of P(t−, ·) and of P(t+, ·) between two neighbouring separators.
#[derive(Clone, Debug, Default)]
struct Band {
    below: Vec<usize>,
    above: Vec<usize>,
    kind: Kind,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Kind {
    #[default]
    Ordinary,
    /// All roots of the band tend to 0.
    Zero,
    /// All roots of the band tend to ±∞.
    Infinite,
}

impl Link {
    /// Follows the roots through α: the window is narrowed until separators tell the roots apart.
    ///
    /// If α is rational, the roots of P(α, ·) are known, and numbers between them are separators of a sufficiently narrow
    /// window. If α is irrational, midpoints between neighbouring roots at t− and at t+ are tried as separators. By Lemma 2 the
    /// multiplicity of α in the discriminant tells when there are enough of them; where it is 2 or more, the number of real
    /// roots at α does.
    ///
    /// # Errors
    /// Those of [`count_roots`].
    pub(super) fn through(critical: &Critical<'_>, cx: &Context<'_>) -> Result<Self> {
        match critical {
            Critical::Rational(alpha, room) => Ok(through_rational(alpha, room, cx)),
            Critical::Irrational(alpha) => through_irrational(alpha, cx),
        }
    }
}

fn through_rational(alpha: &Rational, room: &Rational, cx: &Context<'_>) -> Link {
    let at_alpha = cx.strip.along(alpha);
    let degree = |g: &IntegerPolynomial| g.coefficients_asc().len().saturating_sub(1);
    let lost = cx.strip.coefficients().len() - 1 - degree(&at_alpha);
    let zeros = zero_multiplicity(&at_alpha);
    let bounds = Bounds::new(
        at_alpha
            .coefficients_asc()
            .iter()
            .map(|c| exactly(&Rational::whole(c))),
        lost,
        zeros,
    );
    let mut roots = real_roots(&at_alpha);
    roots.retain(|root| root.signum() != 0);
    let mut separators = bounds.map(|b| b.separators()).unwrap_or_default();
    for i in 1..roots.len() {
        let (before, after) = roots.split_at_mut(i);
        // `bounds` has separators around 0 already.
        if before[i - 1].signum() == after[0].signum() {
            separators.push(rational_between(&mut before[i - 1], &mut after[0]));
        }
    }
    separators.sort_unstable();
    let mut width = room.clone();
    let sixteenth = Rational::one() / Rational::from(16);
    let window = loop {
        width = width * &sixteenth;
        let window = (alpha - &width, alpha + &width);
        if separators
            .iter()
            .all(|r| cx.strip.is_free(r, &window.0, &window.1))
        {
            break window;
        }
    };
    let bands = Bands::new(cx.strip, &window, &separators, lost, zeros);
    let mut link = bands.link(|band| {
        // The separators leave one root at α in each band, so two roots on each side tend to that one root.
        let parts = squarefree_decomposition(&at_alpha);
        let distinct: usize = parts.iter().map(|(_, g)| degree(g)).sum();
        let only = degree(&at_alpha) - distinct == 1;
        crossing(band, only && lost <= 1, cx.multiplicity)
    });
    link.finite = roots.iter().map(RealRoot::signum).collect();
    for root in roots {
        let place = bands.place(&root);
        if bands.list[place].is_empty() {
            link.isolated.push(root.signum());
        }
    }
    link.complete = true;
    link
}

fn through_irrational(alpha: &RealRoot, cx: &Context<'_>) -> Result<Link> {
    let coefficients = cx.strip.coefficients();
    let vanishes = |a: &&IntegerPolynomial| **a == IntegerPolynomial::ZERO || alpha.is_root_of(a);
    let lost = coefficients.iter().rev().take_while(vanishes).count();
    let zeros = coefficients.iter().take_while(vanishes).count();
    let kept = &coefficients[zeros..coefficients.len() - lost];
    let simple = cx.multiplicity == 0;
    let fold = cx.multiplicity == 1 && lost <= 1 && zeros <= 1;
    let mut count = None;
    let mut alpha = alpha.clone();
    let mut round = 0;
    loop {
        cx.limits.check()?;
        let (low, high) = alpha.enclosure();
        let window = (low.to_rational(), high.to_rational());
        let magnitudes = coefficients.iter().enumerate().map(|(i, a)| {
            let gone = i < zeros || i >= coefficients.len() - lost;
            if gone {
                exactly(&Rational::zero())
            } else {
                range(a, &window.0, &window.1)
            }
        });
        let separators = Bounds::new(magnitudes, lost, zeros)
            .map(|bounds| bounds.separators())
            .filter(|list| {
                list.iter()
                    .all(|r| cx.strip.is_free(r, &window.0, &window.1))
            });
        if let Some(mut separators) = separators {
            for t in [&window.0, &window.1] {
                let mut roots = real_roots(&cx.strip.along(t));
                for i in 1..roots.len() {
                    let (before, after) = roots.split_at_mut(i);
                    let middle = rational_between(&mut before[i - 1], &mut after[0]);
                    if cx.strip.is_free(&middle, &window.0, &window.1) {
                        separators.push(middle);
                    }
                }
            }
            separators.sort_unstable();
            separators.dedup();
            let bands = Bands::new(cx.strip, &window, &separators, lost, zeros);
            let occupied = bands.ordinary().filter(|b| !b.is_empty());
            let clear = occupied.clone().all(|b| b.passes() || b.folds());
            let folds = occupied.clone().filter(|b| b.folds()).count();
            if clear && (simple && folds == 0 || fold && folds == 1) {
                let mut link = bands.link(|_| None);
                link.complete = true;
                return Ok(link);
            }
            if !simple && !fold {
                let known = match count {
                    Some(known) => known,
                    None => {
                        let weights = Weights {
                            lowest: cx.weights.lowest + zeros * cx.step,
                            ..cx.weights
                        };
                        *count.insert(count_roots(kept, weights, &alpha, cx.limits)?)
                    }
                };
                let distinct = occupied.clone().count();
                // Some root tends to a root at α in each occupied band. That is the only one in the band if the band is
                // clear (Lemma 1, or the two roots of a fold), or if there are no more real roots than bands. The real
                // roots that are left are isolated.
                if clear || distinct == known.real {
                    let only = known.repeated == 1 && zeros <= 1 && lost <= 1;
                    let mut link = bands.link(|band| {
                        crossing(band, only && distinct == known.real, cx.multiplicity)
                    });
                    let positive = occupied.filter(|b| bands.is_positive(b)).count();
                    let isolated = known.real.saturating_sub(distinct);
                    let isolated_positive = known.positive.saturating_sub(positive).min(isolated);
                    link.isolated = [
                        vec![-1; isolated - isolated_positive],
                        vec![1; isolated_positive],
                    ]
                    .concat();
                    link.finite.extend(&link.isolated);
                    link.finite.sort_unstable();
                    link.complete = true;
                    return Ok(link);
                }
            }
            round += 1;
            if round > MAX_ROUNDS && !simple && !fold {
                return Ok(bands.link(|_| None));
            }
        }
        let width = window.1 - window.0;
        let bits = width.denominator().significant_bits().cast_signed()
            - width.numerator().significant_bits().cast_signed();
        alpha.refine_to_width(-bits - 8);
    }
}

fn exactly(q: &Rational) -> (Rational, Rational) {
    (q.clone(), q.clone())
}

/// The pairs of a band with two roots on each side, by Lemma 3. `only` says that these meet in one double root and that no
/// other two roots meet at α; `multiplicity` is that of α in the discriminant.
fn crossing(band: &Band, only: bool, multiplicity: usize) -> Option<Vec<(usize, usize)>> {
    if !only || band.below.len() != 2 || band.above.len() != 2 {
        return None;
    }
    let (a, b) = (&band.below, &band.above);
    Some(if (multiplicity / 2) % 2 == 1 {
        vec![(a[0], b[1]), (a[1], b[0])]
    } else {
        vec![(a[0], b[0]), (a[1], b[1])]
    })
}

/// Cauchy's bounds of the roots at α that are neither 0 nor infinite.
struct Bounds {
    /// The absolute values of these roots are less than this; `None` if no root is infinite at α.
    above: Option<Rational>,
    /// The absolute values of these roots are more than this; `None` if 0 is no root at α.
    below: Option<Rational>,
}

impl Bounds {
    /// The bounds from enclosures of the coefficients, of which the last `lost` and the first `zeros` are 0. `None` if the
    /// enclosure of the last or of the first other coefficient holds 0.
    fn new(
        coefficients: impl Iterator<Item = (Rational, Rational)>,
        lost: usize,
        zeros: usize,
    ) -> Option<Self> {
        let mut list: Vec<(Rational, Rational)> = coefficients.collect();
        while list.last().is_some_and(|(a, b)| a.is_zero() && b.is_zero()) {
            list.pop();
        }
        let kept = list.get(zeros..)?;
        let least = |(a, b): &(Rational, Rational)| {
            if a.signum() * b.signum() <= 0 {
                None
            } else {
                Some(a.abs().min(b.abs()))
            }
        };
        let largest = kept.iter().map(|(a, b)| a.abs().max(b.abs())).max()?;
        let above = if lost > 0 {
            Some(power_of_two_above(
                &(Rational::one() + &largest / &least(kept.last()?)?),
            ))
        } else {
            None
        };
        let below = if zeros > 0 {
            let first = least(kept.first()?)?;
            power_of_two_above(&((&first + &largest) / first)).recip()
        } else {
            None
        };
        Some(Self { above, below })
    }

    /// ±`above` and ±`below`, or 0 in place of ±`below` if 0 is no root at α.
    fn separators(&self) -> Vec<Rational> {
        let both = |r: &Rational| [-r.clone(), r.clone()];
        let mut list: Vec<Rational> = self.above.iter().flat_map(both).collect();
        match &self.below {
            Some(r) => list.extend(both(r)),
            None => list.push(Rational::zero()),
        }
        list
    }
}

fn power_of_two_above(q: &Rational) -> Rational {
    let bits = q.numerator().significant_bits() + 1;
    let exponent = bits.cast_signed() - q.denominator().significant_bits().cast_signed();
    Rational::from_dyadic(Integer::from(1), exponent)
}

/// A rational number strictly between two roots, a < b.
fn rational_between(a: &mut RealRoot, b: &mut RealRoot) -> Rational {
    let mut bits = 4;
    loop {
        let (end, start) = (a.enclosure().1.to_rational(), b.enclosure().0.to_rational());
        if end < start {
            return strictly_between(&end, &start);
        }
        a.refine_to_width(-bits);
        b.refine_to_width(-bits);
        bits *= 2;
    }
}

/// The strip [t−, t+] × ℝ, cut by separators.
struct Bands {
    separators: Vec<Rational>,
    list: Vec<Band>,
    signs: [Vec<i8>; 2],
}

impl Bands {
    fn new(
        strip: &Strip,
        window: &(Rational, Rational),
        separators: &[Rational],
        lost: usize,
        zeros: usize,
    ) -> Self {
        let mut bands = Self {
            separators: separators.to_vec(),
            list: vec![Band::default(); separators.len() + 1],
            signs: [Vec::new(), Vec::new()],
        };
        for (side, t) in [&window.0, &window.1].into_iter().enumerate() {
            for (rank, root) in real_roots(&strip.along(t)).into_iter().enumerate() {
                bands.signs[side].push(root.signum());
                let place = bands.place(&root);
                let band = &mut bands.list[place];
                let ranks = if side == 0 {
                    &mut band.below
                } else {
                    &mut band.above
                };
                ranks.push(rank);
            }
        }
        let last = bands.list.len() - 1;
        if lost > 0 {
            bands.list[0].kind = Kind::Infinite;
            bands.list[last].kind = Kind::Infinite;
        }
        if zeros > 0 {
            let middle = bands
                .separators
                .iter()
                .take_while(|r| r.signum() < 0)
                .count();
            bands.list[middle].kind = Kind::Zero;
        }
        bands
    }

    /// The index of the band that a root is in; no root is on a separator.
    fn place(&self, root: &RealRoot) -> usize {
        self.separators
            .partition_point(|r| root.cmp_rational(r).is_gt())
    }

    fn ordinary(&self) -> impl Iterator<Item = &Band> + Clone {
        self.list.iter().filter(|b| b.kind == Kind::Ordinary)
    }

    /// Whether the roots of an ordinary band are positive. They all have one sign, as 0 is a separator or in another band.
    fn is_positive(&self, band: &Band) -> bool {
        let below = band.below.first().map(|&rank| self.signs[0][rank]);
        let above = band.above.first().map(|&rank| self.signs[1][rank]);
        below.or(above) == Some(1)
    }

    /// The link that the bands show: a root that passes through its band is paired, and `meeting` may pair the roots of every
    /// other ordinary band.
    fn link(&self, meeting: impl Fn(&Band) -> Option<Vec<(usize, usize)>>) -> Link {
        let mut link = Link {
            limits: self
                .signs
                .each_ref()
                .map(|signs| signs.iter().map(|&s| Some(s)).collect()),
            ..Link::default()
        };
        for band in &self.list {
            let limit = match band.kind {
                Kind::Ordinary => None,
                Kind::Zero => Some(Some(0)),
                Kind::Infinite => Some(None),
            };
            link.zero |= band.kind == Kind::Zero;
            if let Some(limit) = limit {
                for &rank in &band.below {
                    link.limits[0][rank] = limit;
                }
                for &rank in &band.above {
                    link.limits[1][rank] = limit;
                }
            }
            if band.kind == Kind::Infinite {
                link.loses = true;
                continue;
            }
            if band.kind == Kind::Ordinary && !band.is_empty() {
                link.finite
                    .push(if self.is_positive(band) { 1 } else { -1 });
            }
            if band.passes() {
                link.pairs.push((band.below[0], band.above[0]));
            } else if band.kind == Kind::Ordinary
                && let Some(pairs) = meeting(band)
            {
                link.pairs.extend(pairs);
            }
        }
        link
    }
}

impl Band {
    fn is_empty(&self) -> bool {
        self.below.is_empty() && self.above.is_empty()
    }

    /// Whether the band has one root below and one above, which are one continuous root (Lemma 1).
    fn passes(&self) -> bool {
        self.below.len() == 1 && self.above.len() == 1
    }

    /// Whether the band has two roots on one side, which meet at α, and none on the other.
    fn folds(&self) -> bool {
        matches!((self.below.len(), self.above.len()), (2, 0) | (0, 2))
    }
}
