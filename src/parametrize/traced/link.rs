//! What becomes of the real roots of P(t, ·) at one critical t: which go on, meet, or leave.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::logic::traits::SignificantBits;

use super::count::{count_roots, zero_multiplicity};
use super::strictly_between;
use super::strip::{Strip, range};
use crate::error::Result;
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{IntegerPolynomial, Weights, squarefree_decomposition};
use crate::roots::{RealRoot, real_roots};

/// How often an enclosure is shrunk before several roots that meet at one irrational t, and may as well
/// only come near each other, are left unconnected. Each time it is 8 bits or more narrower.
const MAX_ROUNDS: u32 = 60;

/// The roots R just below and just above a critical t = α, each list ascending, and their limits at α.
#[derive(Clone, Debug, Default)]
pub(super) struct Link {
    /// The sign of the limit of every root below, and of every one above; `None` if it is infinite.
    pub(super) limits: [Vec<Option<i8>>; 2],
    /// Pairs (rank below, rank above) of roots that are one continuous root.
    pub(super) pairs: Vec<(usize, usize)>,
    /// The signs of real roots of P(α, ·) that no root beside tends to.
    pub(super) isolated: Vec<i8>,
    /// Whether R = 0 is a root at α.
    pub(super) zero: bool,
    /// Whether the leading coefficient vanishes at α.
    pub(super) loses: bool,
    /// The signs of the distinct real roots R ≠ 0 at α, ascending.
    pub(super) finite: Vec<i8>,
    /// Whether all this is complete. If not, some roots that go on through α are not paired, and an
    /// isolated root may be missing.
    pub(super) complete: bool,
}

/// Where a critical t is.
pub(super) enum Critical<'a> {
    /// A rational number, and how far below and above it the next ones are at least.
    Rational(&'a Rational, Rational),
    /// A root whose enclosure holds no other critical t.
    Irrational(&'a RealRoot),
}

/// What P is, besides its values.
pub(super) struct Context<'a> {
    pub(super) strip: &'a Strip,
    pub(super) weights: Weights,
    /// The multiplicity of α as a root of the discriminant.
    pub(super) multiplicity: usize,
    pub(super) limits: &'a Limits,
}

/// Roots of P(t−, ·) and P(t+, ·) between two neighbouring separators.
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
    /// All of them tend to 0.
    Zero,
    /// All of them tend to ±∞.
    Infinite,
}

impl Link {
    /// Follows the roots through α.
    ///
    /// A *separator* is an R at which P(·, R) has no zero in [t−, t+]: no root crosses it there. Roots are
    /// told apart by separators as t− and t+ approach α. For rational α the roots of P(α, ·) are known, so
    /// they give the separators; otherwise midpoints between the roots at t− and t+ are tried, and the
    /// multiplicity of the discriminant, or the number of real roots at α, says when there are enough.
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
        // Around 0 there are separators already.
        if before[i - 1].signum() == after[0].signum() {
            separators.push(rational_between(&mut before[i - 1], &mut after[0]));
        }
    }
    separators.sort();
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
        // One root at α is in the band: two branches cross there, if that is all that happens at α.
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
            separators.sort();
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
                            lowest: cx.weights.lowest + zeros * cx.weights.step,
                            ..cx.weights
                        };
                        *count.insert(count_roots(kept, weights, &alpha, cx.limits)?)
                    }
                };
                let distinct = occupied.clone().count();
                // Separated bands hold at least one root at α each, and clear ones exactly one.
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

/// For two roots below and two above that meet in one double root, where nothing else happens: analytic
/// branches, whose difference changes its sign if the discriminant has an odd number of double zeros.
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

/// Where the roots at α are that are neither 0 nor infinite (Cauchy).
struct Bounds {
    /// Their absolute values are less than this, if there are infinite ones.
    above: Option<Rational>,
    /// And more than this, if 0 is one.
    below: Option<Rational>,
}

impl Bounds {
    /// From enclosures of the coefficients, of which the last `lost` and the first `zeros` are 0. `None` if the
    /// enclosures are too wide to tell.
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

    /// ±above, ±below; 0 if it is no root.
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

/// The strip [t−, t+] × R, cut by separators.
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

    /// The sign of the roots of an ordinary band, which are on one side of 0.
    fn is_positive(&self, band: &Band) -> bool {
        let below = band.below.first().map(|&rank| self.signs[0][rank]);
        let above = band.above.first().map(|&rank| self.signs[1][rank]);
        below.or(above) == Some(1)
    }

    /// Pairs what passes through; `meeting` may pair what meets.
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

    /// One root goes through.
    fn passes(&self) -> bool {
        self.below.len() == 1 && self.above.len() == 1
    }

    /// Two roots of one side meet and are not real on the other.
    fn folds(&self) -> bool {
        matches!((self.below.len(), self.above.len()), (2, 0) | (0, 2))
    }
}
