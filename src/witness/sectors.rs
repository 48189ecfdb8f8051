//! Claims about the number of roots in every direction of a sector (T7).

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;
use serde_json::{Value, json};

use super::breakpoints::{End, Roots, on, shift};
use super::forms::{curve_form, texts};
use super::proof::Proof;
use super::rays::apart;
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{BinaryForm, IntegerPolynomial, PlanePolynomial, integer_sign, negate_odd};
use crate::roots::{RealRoot, real_roots, sign_changes};

/// Cuts are this many decimal places wide at first, and twice as many where two of them would overlap.
const PLACES: u32 = 16;
const MOST_PLACES: u32 = 128;
/// An interval of directions is not halved more often than this, and there are no more pieces.
const DEEPEST: u32 = 600;
const MOST_PIECES: usize = 3000;
/// An interval of λ is not divided more often than this for one interval of directions.
const DIVISIONS: u32 = 2;
/// Where an interval of λ is divided, in sixteenths. With fixed breakpoints a root crosses one of them at some direction.
const SHARES: [i64; 4] = [8, 7, 10, 5];

/// Claims the number of roots λ < 0 and λ > 0 in all directions but small intervals about the critical ones: `sectors`. The slopes
/// are those of all directions but the vertical one in which a root may be multiple, 0 or infinite.
///
/// # Errors
/// Those of `limits`.
pub(crate) fn sectors(
    proof: &mut Proof,
    f: &PlanePolynomial,
    slopes: &[RealRoot],
    limits: &Limits,
) -> Result<()> {
    let Some(form) = curve_form(proof, f) else {
        return Ok(());
    };
    let f = f.primitive();
    let search = Search {
        charts: [Chart::new(&f, true), Chart::new(&f, false)],
        limits,
    };
    let mut places = PLACES;
    while places <= MOST_PLACES {
        if let Some(cuts) = cuts(slopes, places) {
            if let Some(sectors) = search.sectors(&cuts)? {
                let (statement, witness) = written(form, &sectors);
                proof.claim("sectors", &statement, Some(witness));
                return Ok(());
            }
            break;
        }
        places *= 2;
    }
    proof.claim("sectors", &json!({ "form": form }), None);
    Ok(())
}

/// The numbers of roots λ < 0 and λ > 0.
type Counts = [usize; 2];

/// An interval of directions that ends at `to`, and the breakpoints of λ.
struct Piece {
    to: Rational,
    breakpoints: Vec<Rational>,
}

/// What is between two cuts, and the cut after it.
struct Sector {
    counts: Option<Counts>,
    pieces: Vec<Piece>,
    cut: Option<[Rational; 2]>,
}

fn written(form: usize, sectors: &[Sector]) -> (Value, Value) {
    let cuts = sectors.iter().filter_map(|sector| sector.cut.as_ref());
    let cuts: Vec<Value> = cuts
        .map(|cut| json!({ "between": texts(cut), "angle": texts(&angles(cut)) }))
        .collect();
    let counts = sectors.iter().map(|sector| match sector.counts {
        Some([negative, positive]) => json!({ "negative": negative, "positive": positive }),
        None => Value::Null,
    });
    let piece = |piece: &Piece| json!({ "to": piece.to.to_string(), "breakpoints": texts(&piece.breakpoints) });
    let pieces = sectors.iter().map(|sector| match sector.counts {
        Some(_) => sector.pieces.iter().map(piece).collect(),
        None => Value::Null,
    });
    let counts: Vec<Value> = counts.collect();
    let pieces: Vec<Value> = pieces.collect();
    (
        json!({ "form": form, "cuts": cuts, "counts": counts }),
        json!({ "sectors": pieces }),
    )
}

/// Decimals about the angles of a cut, less π/2 for the second chart.
fn angles([low, high]: &[Rational; 2]) -> [Rational; 2] {
    let middle = Rational::from(if *high <= Rational::from(2) { 1 } else { 3 });
    let unit = ten_to(15);
    let two = Rational::from(2);
    let angle = |s: &Rational| {
        let near = (s - &middle).to_f64().atan();
        Rational::try_from(near).invariant("an arc tangent is finite")
    };
    [
        &((&angle(low) * &unit).floor() - &two) / &unit,
        &((&angle(high) * &unit).floor() + &(&two + &Rational::one())) / &unit,
    ]
}

/// Cuts of the numbers s from 0 to 4 about the critical directions, ascending; `None` if two of them overlap.
fn cuts(slopes: &[RealRoot], places: u32) -> Option<Vec<[Rational; 2]>> {
    let unit = ten_to(places);
    let [zero, one, two, three, four] = [0, 1, 2, 3, 4].map(Rational::from);
    let mut enclosures = vec![[three.clone(), three.clone()]];
    for slope in slopes {
        if let Some(t) = slope.as_rational() {
            if t == -&one {
                enclosures.push([four.clone(), four.clone()]);
            }
            let s = direction(&t);
            enclosures.push([s.clone(), s]);
            continue;
        }
        let mut slope = slope.clone();
        let mut width = -4 * i64::from(places);
        loop {
            slope.refine_to_width(width);
            let (low, high) = slope.bounds();
            let is_inside = |t: &Rational| low < *t && *t < high;
            if !is_inside(&one) && !is_inside(&-&one) {
                // The slope is not −1, which has two directions.
                let low = if low == -&one {
                    zero.clone()
                } else {
                    direction(&low)
                };
                enclosures.push([low, direction(&high)]);
                break;
            }
            width *= 2;
        }
    }
    enclosures.sort_unstable();
    let mut cuts: Vec<[Rational; 2]> = Vec::new();
    for [low, high] in enclosures {
        let outward = [
            &((&low * &unit).floor() - &one) / &unit,
            &((&high * &unit).floor() + &two) / &unit,
        ];
        let [mut a, mut b] = outward;
        a = a.max(zero.clone());
        b = b.min(four.clone());
        let parts = match (a < two, b > two) {
            (true, true) if high < two => vec![[a, two.clone()]],
            (true, true) if low > two => vec![[two.clone(), b]],
            (true, true) => vec![[a, two.clone()], [two.clone(), b]],
            _ => vec![[a, b]],
        };
        for cut in parts {
            if cuts.last().is_some_and(|last| last[1] > cut[0]) {
                return None;
            }
            cuts.push(cut);
        }
    }
    Some(cuts)
}

/// The number s of the direction with the slope t: t + 1, or 3 − 1/t beyond the diagonals.
fn direction(t: &Rational) -> Rational {
    let one = Rational::one();
    if *t < -&one || *t > one {
        &Rational::from(3) - &(&one / t)
    } else {
        t + &one
    }
}

/// f(λ d(s))/λ^k as a polynomial in λ and s: lists of the coefficients of the powers of λ, by the powers of s.
struct Chart {
    columns: Vec<Vec<Integer>>,
}

impl Chart {
    /// The chart of d(s) = (1, s − 1), or that of d(s) = (3 − s, 1).
    fn new(f: &PlanePolynomial, first: bool) -> Self {
        let degrees = f.homogeneous_degrees();
        let (top, low) = (degrees[0], degrees[degrees.len() - 1]);
        let rows: Vec<Vec<Integer>> = (low..=top)
            .map(|d| {
                let form = f.part(d).cloned().unwrap_or_else(|| BinaryForm::zero(d));
                let mut row = form.dehomogenized().coefficients_asc().to_vec();
                row.resize(top + 1, Integer::ZERO);
                if first {
                    shift(&mut row, &Integer::from(-1));
                } else {
                    row[..=d].reverse();
                    shift(&mut row, &Integer::from(3));
                    negate_odd(&mut row);
                }
                row
            })
            .collect();
        let columns = (0..=top).map(|j| rows.iter().map(|row| row[j].clone()).collect());
        let mut columns: Vec<Vec<Integer>> = columns.collect();
        while columns
            .last()
            .is_some_and(|column| column.iter().all(|c| *c == 0))
        {
            columns.pop();
        }
        Self { columns }
    }

    /// The coefficients by the powers of λ in one direction, times a positive number.
    fn along(&self, s: &Rational) -> Vec<Integer> {
        let (p, q) = (s.numerator(), s.denominator());
        let mut sum = vec![Integer::ZERO; self.columns[0].len()];
        let mut scale = Integer::from(1);
        for column in self.columns.iter().rev() {
            for (slot, c) in sum.iter_mut().zip(column) {
                *slot *= &p;
                *slot += c * &scale;
            }
            scale *= &q;
        }
        sum
    }

    /// The number of roots λ between two ends, if theorem T7 shows that it is the same for all directions from `low` to `high`.
    fn roots(&self, [low, high]: [&Rational; 2], from: &End, to: &End) -> Option<usize> {
        let columns: Vec<_> = self.columns.iter().map(|c| on(c, from, to)).collect();
        let ends = [low, high].map(|s| End::At(s.clone()));
        let length = columns[0].len();
        let mut signs: Vec<i8> = Vec::new();
        for index in 0..length {
            let row: Vec<Integer> = columns.iter().map(|column| column[index].clone()).collect();
            let row: Vec<i8> = on(&row, &ends[0], &ends[1])
                .iter()
                .map(integer_sign)
                .collect();
            let [has_plus, has_minus] = [1, -1].map(|sign| row.contains(&sign));
            let is_outer = index == 0 || index + 1 == length;
            if is_outer && (has_plus == has_minus || row[0] == 0 || row[row.len() - 1] == 0) {
                return None;
            }
            match (has_plus, has_minus) {
                (true, true) => {
                    let last = signs.last().copied();
                    let last = last.invariant("the first coefficient has one sign");
                    signs.extend([last, -last]);
                }
                (true, false) => signs.push(1),
                (false, true) => signs.push(-1),
                (false, false) => {}
            }
        }
        Some(sign_changes(signs.into_iter())).filter(|changes| *changes <= 1)
    }
}

struct Search<'a> {
    charts: [Chart; 2],
    limits: &'a Limits,
}

impl Search<'_> {
    /// The sectors between the cuts, without the cuts that are not needed; `None` if a sector needs too many pieces.
    fn sectors(&self, cuts: &[[Rational; 2]]) -> Result<Option<Vec<Sector>>> {
        let mut sectors: Vec<Sector> = Vec::new();
        let mut start = Rational::zero();
        let ends = cuts.iter().map(|cut| (cut[0].clone(), Some(cut.clone())));
        for (end, cut) in ends.chain([(Rational::from(4), None)]) {
            let mut found = Vec::new();
            let mut counts = None;
            if start < end {
                // 2 is an end of a piece.
                let two = Rational::from(2);
                let mut stops = vec![end.clone()];
                if start < two && two < end {
                    stops.insert(0, two);
                }
                for stop in stops {
                    let Some(of_piece) = self.divide(&start, &stop, 0, &mut found)? else {
                        return Ok(None);
                    };
                    counts = Some(of_piece);
                    start = stop;
                }
            }
            if let Some(next) = &cut {
                start.clone_from(&next[1]);
            }
            let sector = Sector {
                counts,
                pieces: found,
                cut,
            };
            self.joined(&mut sectors, sector);
        }
        Ok(Some(sectors))
    }

    /// Adds a sector, or makes it a part of the last one if the cut between them is not needed.
    fn joined(&self, sectors: &mut Vec<Sector>, next: Sector) {
        if let Some(last) = sectors.last_mut()
            && let Some([low, high]) = &last.cut
            && last.counts.is_some()
            && last.counts == next.counts
            && let Some((counts, breakpoints)) = self.piece(low, high)
            && Some(counts) == next.counts
        {
            last.pieces.push(Piece {
                to: high.clone(),
                breakpoints,
            });
            last.pieces.extend(next.pieces);
            last.cut = next.cut;
        } else {
            sectors.push(next);
        }
    }

    /// Divides an interval of directions into pieces, and returns the counts, which are the same in all of them.
    fn divide(
        &self,
        low: &Rational,
        high: &Rational,
        depth: u32,
        found: &mut Vec<Piece>,
    ) -> Result<Option<Counts>> {
        self.limits.check()?;
        if let Some((counts, breakpoints)) = self.piece(low, high) {
            found.push(Piece {
                to: high.clone(),
                breakpoints,
            });
            return Ok(Some(counts));
        }
        if depth == DEEPEST || found.len() > MOST_PIECES {
            return Ok(None);
        }
        let middle = inside(low, high);
        let first = self.divide(low, &middle, depth + 1, found)?;
        let second = match first {
            Some(_) => self.divide(&middle, high, depth + 1, found)?,
            None => None,
        };
        Ok(first.filter(|_| first == second))
    }

    /// The counts and breakpoints for an interval of directions, if they are the same for all of it.
    fn piece(&self, low: &Rational, high: &Rational) -> Option<(Counts, Vec<Rational>)> {
        let chart = &self.charts[usize::from(*low >= Rational::from(2))];
        let coefficients = chart.along(&inside(low, high));
        let polynomial = IntegerPolynomial::from_coefficients_asc(coefficients.clone());
        if integer_sign(&coefficients[0]) == 0 || integer_sign(coefficients.last()?) == 0 {
            return None;
        }
        let roots = real_roots(&polynomial);
        if roots.iter().any(|root| root.multiplicity() > 1) {
            return None;
        }
        let enclosures = apart(roots);
        let roots = Roots {
            coefficients: &coefficients,
            enclosures: &enclosures,
        };
        let zero = End::At(Rational::zero());
        let mut counts = [0, 0];
        let mut breakpoints = Vec::new();
        for (half, [from, to]) in [[&End::Below, &zero], [&zero, &End::Above]]
            .iter()
            .enumerate()
        {
            let mut start = (*from).clone();
            let mut ends: Vec<End> = roots
                .breakpoints(from, to)?
                .into_iter()
                .map(End::At)
                .collect();
            ends.push((*to).clone());
            for end in ends {
                counts[half] += divided(chart, [low, high], [&start, &end], 0, &mut breakpoints)?;
                breakpoints.extend(end.rational());
                start = end;
            }
        }
        Some((counts, breakpoints))
    }
}

/// The number of roots between two ends, after dividing the interval as needed; the dividing numbers are added in order.
fn divided(
    chart: &Chart,
    directions: [&Rational; 2],
    [from, to]: [&End; 2],
    depth: u32,
    breakpoints: &mut Vec<Rational>,
) -> Option<usize> {
    if let Some(roots) = chart.roots(directions, from, to) {
        return Some(roots);
    }
    if depth == DIVISIONS {
        return None;
    }
    let two = Rational::from(2);
    let one = Rational::one();
    let candidates: Vec<Rational> = match (from, to) {
        (End::At(a), End::At(b)) => SHARES
            .iter()
            .map(|share| a + &(&(b - a) * &(&Rational::from(*share) / &Rational::from(16))))
            .collect(),
        (End::At(a), _) => vec![&(a * &two) + &one],
        (_, End::At(b)) => vec![&(b * &two) - &one],
        (End::Below | End::Above, _) => return None,
    };
    for middle in candidates {
        let at = End::At(middle.clone());
        let mut found = Vec::new();
        let first = divided(chart, directions, [from, &at], depth + 1, &mut found);
        let Some(first) = first else { continue };
        found.push(middle);
        if let Some(second) = divided(chart, directions, [&at, to], depth + 1, &mut found) {
            breakpoints.extend(found);
            return Some(first + second);
        }
    }
    None
}

/// 10^places.
fn ten_to(places: u32) -> Rational {
    Rational::whole(Integer::from(10).pow(u64::from(places)))
}

/// A simple rational number in the middle third of an interval.
fn inside(low: &Rational, high: &Rational) -> Rational {
    let third = &(high - low) / &Rational::from(3);
    Rational::simplest_between(&(low + &third), &(high - &third))
}
