//! The claim `root-count`: the real roots of a polynomial in one direction, their multiplicities and nearest doubles (T1).

use num_bigint::BigInt;

use super::bernstein::{Interval, RootInterval, intervals, isolated_roots};
use super::forms::{Forms, HIGHEST_DEGREE, MOST_PARTS};
use super::json::{Claim, Value};
use super::numbers::{
    Exact, common_denominator, is_zero, midpoints, read_double, sign, unit_vector, vector,
};
use super::refusal::{Checked, Refusal, need};
use super::univariate::{Coefficients, End, power, product, sign_at, trimmed};

/// A part of the polynomial, whose roots have this multiplicity.
struct Part {
    multiplicity: u32,
    coefficients: Coefficients,
}

/// A root as the statement gives it.
struct StatedRoot {
    multiplicity: u32,
    nearest: Option<f64>,
    position: Option<Vec<f64>>,
}

pub(super) fn check(forms: &Forms, claim: &Claim<'_>) -> Checked<()> {
    let required = ["form", "direction", "order_at_zero", "roots"];
    let statement = claim.statement(&required, &["center"])?;
    let form = statement.get("form", |index| forms.implicit(index))?;
    let dimension = form.dimension;
    let direction = statement.get("direction", |value| unit_vector(value, dimension))?;
    let center = statement
        .optional("center", |value| vector(value, dimension))?
        .unwrap_or_else(|| vec![Exact::zero(); dimension]);
    let order = statement.get("order_at_zero", read_order)?;
    let roots = statement.get("roots", |value| {
        value.list(0..=MOST_PARTS, |root| read_root(root, dimension))
    })?;
    let witness = claim.witness(&["breakpoints"], &["parts"])?;
    let pieces = witness.get("breakpoints", |value| {
        intervals(value, &End::MinusInfinity, &End::Infinity)
    })?;
    let parts = witness.optional("parts", |value| value.list(1..=MOST_PARTS, read_part))?;

    let along = trimmed(form.terms.along(&direction));
    let Some(order) = order else {
        need(
            along.is_empty(),
            "the polynomial does not vanish on the line",
        )?;
        return need(
            roots.is_empty() && pieces.len() == 1 && parts.is_none(),
            "a line has no roots, no breakpoints and no parts",
        );
    };
    let lowest = along.iter().position(|c| !is_zero(c));
    need(
        lowest == Some(order as usize),
        "the order of the root 0 is different, or the polynomial vanishes on the line",
    )?;
    let polynomial = along[order as usize..].to_vec();
    let parts = match parts {
        Some(parts) => {
            need_product(&parts, &polynomial)?;
            parts
        }
        None => vec![Part {
            multiplicity: 1,
            coefficients: polynomial,
        }],
    };
    let one = vec![BigInt::from(1)];
    let simple = parts
        .iter()
        .fold(one, |result, part| product(&result, &part.coefficients));

    let found = isolated_roots(&simple, &pieces)?;
    need(
        found.len() == roots.len(),
        &format!("there are {} roots, not {}", found.len(), roots.len()),
    )?;
    for (index, (found, stated)) in found.iter().zip(&roots).enumerate() {
        check_root(&simple, &parts, found, stated, &center, &direction)
            .map_err(|refusal| refusal.at(index).within("roots").within("statement"))?;
    }
    Ok(())
}

/// The order of the root 0, or `None` for a line on which the polynomial vanishes.
fn read_order(value: &Value) -> Checked<Option<u32>> {
    match value {
        Value::Text(text) if text == "line" => Ok(None),
        _ => value.count(HIGHEST_DEGREE).map(Some),
    }
}

fn read_root(value: &Value, dimension: usize) -> Checked<StatedRoot> {
    let fields = value.fields(&["multiplicity"], &["nearest", "position"])?;
    Ok(StatedRoot {
        multiplicity: fields.get("multiplicity", |value| value.count(HIGHEST_DEGREE))?,
        nearest: fields.optional("nearest", read_double)?,
        position: fields.optional("position", |value| {
            value.list(dimension..=dimension, read_double)
        })?,
    })
}

fn read_part(value: &Value) -> Checked<Part> {
    let fields = value.fields(&["multiplicity", "coefficients"], &[])?;
    let multiplicity = fields.get("multiplicity", |value| value.count(HIGHEST_DEGREE))?;
    need(multiplicity > 0, "a multiplicity is at least 1")?;
    let coefficients = fields.get("coefficients", |value| {
        value.list(2..=MOST_PARTS + 1, Exact::read_coefficient)
    })?;
    let (coefficients, _) = common_denominator(&coefficients);
    need(
        coefficients.last().is_some_and(|c| !is_zero(c)),
        "a leading coefficient is 0",
    )?;
    Ok(Part {
        multiplicity,
        coefficients,
    })
}

/// Needs the polynomial to be a rational multiple of the product of the parts with their multiplicities.
fn need_product(parts: &[Part], polynomial: &[BigInt]) -> Checked<()> {
    let degree: usize = parts
        .iter()
        .map(|part| part.multiplicity as usize * (part.coefficients.len() - 1))
        .sum();
    need(
        degree + 1 == polynomial.len(),
        "the degrees of the parts do not add up to that of the polynomial",
    )?;
    let whole = parts.iter().fold(vec![BigInt::from(1)], |result, part| {
        product(
            &result,
            &power(&part.coefficients, part.multiplicity as usize),
        )
    });
    let (Some(a), Some(b)) = (whole.last(), polynomial.last()) else {
        return Err(Refusal::new("the polynomial is zero"));
    };
    need(
        whole.iter().zip(polynomial).all(|(c, d)| c * b == d * a),
        "the product of the parts is another polynomial",
    )
}

/// Compares a root with what is stated about it.
fn check_root(
    simple: &[BigInt],
    parts: &[Part],
    found: &RootInterval,
    stated: &StatedRoot,
    center: &[Exact],
    direction: &[Exact],
) -> Checked<()> {
    let Interval { from, to } = &found.interval;
    // All parts without a root in the interval keep their signs; exactly one part has the root.
    let mut changing = parts
        .iter()
        .filter(|part| sign_at(&part.coefficients, from) != sign_at(&part.coefficients, to));
    match (changing.next(), changing.next()) {
        (Some(part), None) if part.multiplicity == stated.multiplicity => {}
        (Some(part), None) => {
            let reason = format!("the multiplicity is {}", part.multiplicity);
            return Err(Refusal::new(reason).within("multiplicity"));
        }
        _ => return Err(Refusal::new("not exactly one part has this root")),
    }
    let root = Root { simple, found };
    if let Some(double) = stated.nearest {
        need(
            root.is_nearest(double, &Exact::zero(), &Exact::one()),
            "another double is nearer",
        )
        .map_err(|refusal| refusal.within("nearest"))?;
    }
    let positions = stated.position.iter().flatten().zip(center).zip(direction);
    for (axis, ((double, c), u)) in positions.enumerate() {
        need(root.is_nearest(*double, c, u), "another double is nearer")
            .map_err(|refusal| refusal.at(axis).within("position"))?;
    }
    Ok(())
}

/// The only root of a polynomial in an interval.
struct Root<'a> {
    simple: &'a [BigInt],
    found: &'a RootInterval,
}

impl Root<'_> {
    /// The sign of root − q. The sign of the polynomial at q tells on which side of the root q is.
    fn compared_with(&self, q: &Exact) -> i64 {
        match (&self.found.interval.from, &self.found.interval.to) {
            (End::At(from), _) if q <= from => 1,
            (_, End::At(to)) if q >= to => -1,
            _ => sign_at(self.simple, &End::At(q.clone())) * self.found.sign_before,
        }
    }

    /// Whether no double is nearer to c + u·root. At a midpoint both neighbours are nearest.
    fn is_nearest(&self, double: f64, c: &Exact, u: &Exact) -> bool {
        let side = |bound: &Exact| {
            let rest = bound - c;
            if u.is_zero() {
                -rest.sign()
            } else {
                self.compared_with(&rest.divided_by(u)) * sign(u.numerator())
            }
        };
        let [low, high] = midpoints(double);
        low.is_none_or(|low| side(&low) >= 0) && high.is_none_or(|high| side(&high) <= 0)
    }
}
