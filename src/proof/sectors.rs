//! The claim `sectors`: the number of real roots in every direction of a sector (T7).

use num_bigint::BigInt;

use super::bernstein::{Interval, coefficients_on, intervals};
use super::forms::{Forms, Implicit};
use super::json::{Claim, LARGEST_INTEGER, LONGEST_LIST, Value};
use super::numbers::{Exact, sign, vector};
use super::refusal::{Checked, Refusal, need};
use super::tangent::is_below_arctangent;
use super::univariate::{Coefficients, End, alternate, shift, sign_changes, variations};

/// A closed interval of directions about which nothing is claimed.
struct Cut {
    low: Exact,
    high: Exact,
    angle: Option<[Exact; 2]>,
}

/// The numbers of negative and positive roots.
#[derive(PartialEq, Eq)]
struct Counts {
    negative: i64,
    positive: i64,
}

/// A part of a sector with breakpoints of its own.
struct Piece {
    to: Exact,
    intervals: Vec<Interval>,
}

pub(super) fn check(forms: &Forms, claim: &Claim<'_>) -> Checked<()> {
    let fields = claim.statement(&["form", "cuts", "counts"], &[])?;
    let form = fields.get("form", |index| forms.implicit(index))?;
    need(form.dimension == 2, "sectors are those of a form in x, y")?;
    let cuts = fields.get("cuts", |list| list.list(0..=LONGEST_LIST, read_cut))?;
    let number = cuts.len() + 1;
    let counts = fields.get("counts", |list| {
        list.list(number..=number, |value| unless_null(value, read_counts))
    })?;
    let sectors = claim.witness(&["sectors"], &[])?.get("sectors", |list| {
        list.list(number..=number, |sector| {
            unless_null(sector, |sector| sector.list(1..=LONGEST_LIST, read_piece))
        })
    })?;
    let charts = [Chart::new(form, true), Chart::new(form, false)];
    let mut start = Exact::zero();
    let end = Exact::integer(4);
    for (index, (counts, sector)) in counts.iter().zip(&sectors).enumerate() {
        let cut = cuts.get(index);
        let low = cut.map_or(&end, |cut| &cut.low);
        check_sector(&charts, &start, low, sector.as_deref(), counts.as_ref())
            .map_err(|refusal| refusal.at(index).within("sectors").within("witness"))?;
        if let Some(cut) = cut {
            check_angle(cut)
                .map_err(|refusal| refusal.at(index).within("cuts").within("statement"))?;
            start = cut.high.clone();
        }
    }
    Ok(())
}

fn unless_null<T>(value: &Value, read: impl FnOnce(&Value) -> Checked<T>) -> Checked<Option<T>> {
    if *value == Value::Null {
        Ok(None)
    } else {
        read(value).map(Some)
    }
}

fn read_pair(value: &Value) -> Checked<[Exact; 2]> {
    let pair = vector(value, 2)?;
    pair.try_into()
        .map_err(|_| Refusal::new("two numbers are expected"))
}

fn read_cut(value: &Value) -> Checked<Cut> {
    let fields = value.fields(&["between"], &["angle"])?;
    let [low, high] = fields.get("between", read_pair)?;
    let [two, four] = [2, 4].map(Exact::integer);
    need(
        low.sign() >= 0 && low <= high && high <= four && (high <= two || low >= two),
        "a cut is an interval within [0, 2] or [2, 4]",
    )?;
    Ok(Cut {
        low,
        high,
        angle: fields.optional("angle", read_pair)?,
    })
}

fn read_counts(value: &Value) -> Checked<Counts> {
    let fields = value.fields(&["negative", "positive"], &[])?;
    let read = |value: &Value| value.integer(0..=LARGEST_INTEGER);
    Ok(Counts {
        negative: fields.get("negative", read)?,
        positive: fields.get("positive", read)?,
    })
}

fn read_piece(value: &Value) -> Checked<Piece> {
    let fields = value.fields(&["to", "breakpoints"], &[])?;
    Ok(Piece {
        to: fields.get("to", Exact::read)?,
        intervals: fields.get("breakpoints", |value| {
            let pieces = intervals(value, &End::MinusInfinity, &End::Infinity)?;
            let has_zero = |piece: &Interval| matches!(&piece.to, End::At(end) if end.is_zero());
            need(
                pieces.iter().any(has_zero),
                "0 is not among the breakpoints",
            )?;
            Ok(pieces)
        })?,
    })
}

/// The sector from the end of the last cut to the beginning of the next one.
fn check_sector(
    charts: &[Chart; 2],
    start: &Exact,
    end: &Exact,
    pieces: Option<&[Piece]>,
    counts: Option<&Counts>,
) -> Checked<()> {
    need(start <= end, "the cuts do not ascend")?;
    let (Some(pieces), Some(counts)) = (pieces, counts) else {
        return need(
            start == end && pieces.is_none() && counts.is_none(),
            "an empty sector, and only that, has null for its count and its witness",
        );
    };
    need(
        pieces.last().is_some_and(|piece| piece.to == *end),
        "the last piece does not end where the sector ends",
    )?;
    let (mut from, two) = (start, Exact::integer(2));
    for (index, piece) in pieces.iter().enumerate() {
        let to = &piece.to;
        need(from < to, "the pieces do not ascend").map_err(|refusal| refusal.at(index))?;
        need(*to <= two || *from >= two, "a piece has 2 inside")
            .map_err(|refusal| refusal.at(index))?;
        let directions = Interval {
            from: End::At(from.clone()),
            to: End::At(to.clone()),
        };
        let chart = &charts[usize::from(*from >= two)];
        let found = chart
            .constant_counts(&directions, &piece.intervals)
            .map_err(|refusal| refusal.at(index))?;
        need(
            found == *counts,
            &format!(
                "there are {} negative and {} positive roots",
                found.negative, found.positive
            ),
        )
        .map_err(|refusal| refusal.at(index))?;
        from = to;
    }
    Ok(())
}

/// The polynomial f(λ d(s))/λ^k for the lowest degree k of f: its coefficients are, by the powers of s, lists by the powers of λ.
struct Chart {
    columns: Vec<Coefficients>,
}

impl Chart {
    /// The chart of d(s) = (1, s − 1), or that of d(s) = (3 − s, 1).
    fn new(form: &Implicit, first: bool) -> Self {
        let lowest = form.terms.lowest_degree();
        let length = (form.terms.degree() - lowest) as usize + 1;
        // The homogeneous part of every degree, as a polynomial in y or in x.
        let mut rows = vec![Coefficients::new(); length];
        for (&[i, j, ..], c) in form.terms.terms() {
            let row = &mut rows[(i + j - lowest) as usize];
            let exponent = if first { j } else { i } as usize;
            if row.len() <= exponent {
                row.resize(exponent + 1, BigInt::ZERO);
            }
            row[exponent] = c.clone();
        }
        for row in &mut rows {
            if first {
                shift(row, &BigInt::from(-1));
            } else {
                shift(row, &BigInt::from(3));
                alternate(row);
            }
        }
        let degree_in_s = rows.iter().map(Vec::len).max().unwrap_or(0);
        let column = |k| {
            rows.iter()
                .map(|row| row.get(k).cloned().unwrap_or_default())
                .collect()
        };
        Self {
            columns: (0..degree_in_s).map(column).collect(),
        }
    }

    /// The numbers of roots, which are the same for all directions of a closed interval: theorem T7.
    fn constant_counts(&self, directions: &Interval, pieces: &[Interval]) -> Checked<Counts> {
        let mut counts = Counts {
            negative: 0,
            positive: 0,
        };
        for (index, piece) in pieces.iter().enumerate() {
            let roots = self.constant_roots(directions, piece).map_err(|refusal| {
                Refusal::new(format!("interval {index} of λ: {}", refusal.reason()))
            })?;
            let positive = matches!(&piece.from, End::At(from) if from.sign() >= 0);
            *(if positive {
                &mut counts.positive
            } else {
                &mut counts.negative
            }) += roots;
        }
        Ok(counts)
    }

    fn constant_roots(&self, directions: &Interval, piece: &Interval) -> Checked<i64> {
        let columns = self
            .columns
            .iter()
            .map(|column| coefficients_on(column, piece));
        let columns = columns.collect::<Checked<Vec<_>>>()?;
        let length = columns.first().map_or(0, Vec::len);
        let mut signs: Vec<i64> = Vec::new();
        for index in 0..length {
            let row: Vec<_> = columns.iter().map(|column| column[index].clone()).collect();
            let row = coefficients_on(&row, directions)?;
            if index == 0 || index + 1 == length {
                let ends = [row.first(), row.last()].map(|c| c.map_or(0, sign));
                need(
                    variations(&row) == 0 && !ends.contains(&0),
                    "an end of the interval may be a root, or the degree may be lower",
                )?;
            }
            let has = |wanted: i64| row.iter().any(|c| sign(c) == wanted);
            match (has(1), has(-1)) {
                (true, true) => {
                    let last = signs.last().copied();
                    let last =
                        last.ok_or_else(|| Refusal::new("the first coefficient has both signs"))?;
                    signs.extend([last, -last]);
                }
                (true, false) => signs.push(1),
                (false, true) => signs.push(-1),
                (false, false) => {}
            }
        }
        match sign_changes(signs.into_iter()) {
            0 => Ok(0),
            1 => Ok(1),
            many => Err(Refusal::new(format!("there may be {many} roots"))),
        }
    }
}

/// The angles of a cut lie within the stated ones. They are atan(s − 1) for s ≤ 2, and π/2 + atan(s − 3) for s ≥ 2.
fn check_angle(cut: &Cut) -> Checked<()> {
    let Some([alpha, beta]) = &cut.angle else {
        return Ok(());
    };
    let middle = Exact::integer(if cut.high <= Exact::integer(2) { 1 } else { 3 });
    need(
        is_below_arctangent(alpha, &(&cut.low - &middle))
            && is_below_arctangent(&-beta, &(&middle - &cut.high)),
        "the angles do not enclose the cut",
    )
    .map_err(|refusal| refusal.within("angle"))
}
