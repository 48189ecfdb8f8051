//! Wrong claims about the roots on a ray.

use serde_json::{Value, json};
use stellate::exact::Rational;

use super::super::random::SplitMix;
use super::{Case, add, exact, form, index, list, pick, value_at};

fn roots(case: &mut Case) -> &mut Value {
    &mut case.claim["statement"]["roots"]
}

/// The doubles that are nearest to the roots.
fn nearest(case: &mut Case) -> Option<Vec<f64>> {
    let all = roots(case).as_array()?.iter();
    all.map(|root| root["nearest"].as_str()?.parse().ok())
        .collect()
}

pub(super) fn a_root_is_left_out(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let all = list(roots(case))?;
    let chosen = index(words, all.len());
    all.remove(chosen);
    Some(())
}

pub(super) fn a_root_is_counted_twice(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let all = list(roots(case))?;
    let chosen = index(words, all.len());
    let copy = all[chosen].clone();
    all.insert(chosen, copy);
    Some(())
}

pub(super) fn a_multiplicity_is_larger(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let root = pick(roots(case), words)?;
    root["multiplicity"] = json!(root["multiplicity"].as_u64()? + 1);
    Some(())
}

/// Three doubles away: at a tie two neighbours are both the nearest.
fn away(value: &Value, words: &mut SplitMix) -> Option<Value> {
    let double: f64 = value.as_str()?.parse().ok()?;
    let other = if words.word().is_multiple_of(2) {
        double.next_up().next_up().next_up()
    } else {
        double.next_down().next_down().next_down()
    };
    other.is_finite().then(|| json!(format!("{other:e}")))
}

pub(super) fn a_double_is_another(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let root = pick(roots(case), words)?;
    root["nearest"] = away(&root["nearest"], words)?;
    Some(())
}

pub(super) fn a_double_has_the_other_sign(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let root = pick(roots(case), words)?;
    let double: f64 = root["nearest"].as_str()?.parse().ok()?;
    root["nearest"] = json!(format!("{:e}", -double));
    (double.abs() > 1e-300).then_some(())
}

pub(super) fn a_coordinate_is_another(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let root = pick(roots(case), words)?;
    let coordinate = pick(&mut root["position"], words)?;
    *coordinate = away(coordinate, words)?;
    Some(())
}

pub(super) fn the_order_is_larger(case: &mut Case, _: &mut SplitMix) -> Option<()> {
    let order = &mut case.claim["statement"]["order_at_zero"];
    *order = json!(order.as_u64()? + 1);
    Some(())
}

/// The program writes no breakpoint that is not needed.
pub(super) fn a_breakpoint_is_left_out(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let all = list(&mut case.claim["witness"]["breakpoints"])?;
    let chosen = index(words, all.len());
    all.remove(chosen);
    Some(())
}

/// A breakpoint with a root on each side in the neighbouring pieces goes below the first of the two.
pub(super) fn a_breakpoint_goes_past_a_root(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let doubles = nearest(case)?;
    let all = list(&mut case.claim["witness"]["breakpoints"])?;
    let chosen = index(words, all.len());
    let at: Vec<f64> = all.iter().map(|b| exact(b).to_f64()).collect();
    let start = chosen.checked_sub(1).map_or(f64::NEG_INFINITY, |k| at[k]);
    let end = at.get(chosen + 1).copied().unwrap_or(f64::INFINITY);
    let between = |low: f64, high: f64| doubles.iter().copied().find(|x| low < *x && *x < high);
    let before = between(start, at[chosen])?;
    between(at[chosen], end)?;
    let low = start.max(before - 1.0 - before.abs());
    let middle = low + (before - low) * 0.75;
    all[chosen] = json!(Rational::try_from(middle).ok()?.to_string());
    // Far enough from rounding.
    (low < middle && middle < before - 1e-9 * before.abs()).then_some(())
}

pub(super) fn the_direction_is_opposite(case: &mut Case, _: &mut SplitMix) -> Option<()> {
    let doubles = nearest(case)?;
    let mirrored = doubles.iter().rev().map(|x| -x);
    let differs = |(x, y): (&f64, f64)| (x - y).abs() > 1e-6 * x.abs();
    if !doubles.iter().zip(mirrored).any(differs) {
        return None;
    }
    for component in list(&mut case.claim["statement"]["direction"])? {
        *component = json!((-exact(component)).to_string());
    }
    Some(())
}

pub(super) fn the_direction_is_no_unit_vector(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let component = pick(&mut case.claim["statement"]["direction"], words)?;
    let value = exact(component);
    *component = json!((&value * &Rational::from(2)).to_string());
    (!value.is_zero()).then_some(())
}

/// A coefficient changes, and there is no change of sign any more between the numbers that round to a simple root.
pub(super) fn a_coefficient_moves_a_root(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let root = pick(roots(case), words)?.clone();
    let direction: Vec<Rational> = case.claim["statement"]["direction"]
        .as_array()?
        .iter()
        .map(exact)
        .collect();
    let form = form(case, "form")?;
    let term = pick(&mut form["terms"], words)?;
    add(&mut term["coefficient"], &Rational::one())?;
    let double: f64 = root["nearest"].as_str()?.parse().ok()?;
    let signs = [double.next_down(), double.next_up()].map(|end| {
        let end = Rational::try_from(end).ok()?;
        let point: Vec<Rational> = direction.iter().map(|u| u * &end).collect();
        Some(value_at(form, &point)?.signum())
    });
    let is_simple = root["multiplicity"] == 1;
    (is_simple && signs[0]? == signs[1]? && signs[0] != Some(0)).then_some(())
}

pub(super) fn a_part_is_another(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let part = pick(&mut case.claim["witness"]["parts"], words)?;
    let coefficients = list(&mut part["coefficients"])?;
    add(&mut coefficients[0], &Rational::one())
}
