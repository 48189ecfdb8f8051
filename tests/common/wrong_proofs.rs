//! Wrong proofs, made from right ones: one thing is changed so that the claim is false, or its witness proves nothing.
//!
//! Every change is wrong by construction, or an exact evaluation here shows that the claim is false.

mod roots;

use std::collections::BTreeMap;

use serde_json::{Value, json};
use stellate::exact::Rational;
use stellate::proof::check;

use super::random::SplitMix;

/// One claim with the table of forms, and the other claims of the proof.
struct Case {
    forms: Vec<Value>,
    claim: Value,
    others: Vec<Value>,
}

/// Changes the claim or a form. `None` if the change does not apply, or would not be wrong for sure.
type Change = fn(&mut Case, &mut SplitMix) -> Option<()>;

const CHANGES: [(&str, Change); 33] = [
    ("root-count", roots::a_root_is_left_out),
    ("root-count", roots::a_root_is_counted_twice),
    ("root-count", roots::a_multiplicity_is_larger),
    ("root-count", roots::a_double_is_another),
    ("root-count", roots::a_double_has_the_other_sign),
    ("root-count", roots::a_coordinate_is_another),
    ("root-count", roots::the_order_is_larger),
    ("root-count", roots::a_breakpoint_is_left_out),
    ("root-count", roots::a_breakpoint_goes_past_a_root),
    ("root-count", roots::the_direction_is_opposite),
    ("root-count", roots::the_direction_is_no_unit_vector),
    ("root-count", roots::a_coefficient_moves_a_root),
    ("root-count", roots::a_part_is_another),
    ("series-equation", a_coefficient_is_another),
    ("series-equation", a_harmonic_is_another),
    ("series-equation", the_power_is_another),
    ("identity", an_equation_is_another),
    ("identity", the_curve_is_another),
    ("factorization", the_constant_is_another),
    ("factorization", a_factor_is_counted_twice),
    ("factorization", a_factor_is_another),
    ("irreducible", the_prime_is_composite),
    ("irreducible", the_line_is_a_point),
    ("irreducible", the_polynomial_is_a_product),
    ("positive-radius", the_mean_is_negative),
    ("distance", a_bound_contradicts_another_one),
    ("distance", the_relation_is_the_opposite),
    ("distance", the_end_is_too_far),
    ("side", the_sign_is_another),
    ("sectors", a_count_is_another),
    ("sectors", a_cut_is_left_out),
    ("sectors", the_angles_are_elsewhere),
    ("fit-error", the_error_is_another),
];

/// Changes that are wrong for every claim.
const ALWAYS: [Change; 4] = [
    |case, _| {
        case.claim["statement"]["form"] = json!(case.forms.len());
        Some(())
    },
    |case, _| {
        case.claim["statement"]["sure"] = json!(true);
        Some(())
    },
    |case, _| {
        case.claim["witness"]["note"] = json!("1");
        Some(())
    },
    |case, words| {
        let names: Vec<&str> = CHANGES.iter().map(|(name, _)| *name).collect();
        let other = names[index(words, names.len())];
        (case.claim["claim"] != other).then(|| case.claim["claim"] = json!(other))
    },
];

fn index(words: &mut SplitMix, length: usize) -> usize {
    usize::try_from(words.word() % u64::try_from(length).unwrap()).unwrap()
}

fn exact(value: &Value) -> Rational {
    value.as_str().unwrap().parse().unwrap()
}

fn list(value: &mut Value) -> Option<&mut Vec<Value>> {
    value.as_array_mut().filter(|list| !list.is_empty())
}

/// One of the elements of a list that is not empty.
fn pick<'a>(value: &'a mut Value, words: &mut SplitMix) -> Option<&'a mut Value> {
    let list = list(value)?;
    let chosen = index(words, list.len());
    list.get_mut(chosen)
}

fn add(value: &mut Value, what: &Rational) -> Option<()> {
    let sum = &exact(value) + what;
    *value = json!(sum.to_string());
    (!sum.is_zero()).then_some(())
}

/// The form that a field of the statement names.
fn form<'a>(case: &'a mut Case, field: &str) -> Option<&'a mut Value> {
    let index = case.claim["statement"][field].as_u64()?;
    case.forms.get_mut(usize::try_from(index).unwrap())
}

/// The value of an implicit form.
fn value_at(form: &Value, point: &[Rational]) -> Option<Rational> {
    let mut sum = Rational::zero();
    for term in form["terms"].as_array()? {
        let exponents = term["exponents"].as_array()?;
        let powers = point.iter().zip(exponents).map(|(x, e)| x.pow(e.as_i64()?));
        let product = powers.collect::<Option<Vec<_>>>()?;
        let term = product
            .iter()
            .fold(exact(&term["coefficient"]), |a, b| &a * b);
        sum = &sum + &term;
    }
    Some(sum)
}

fn a_coefficient_is_another(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let terms = &mut form(case, "form")?["terms"];
    if terms.as_array()?.len() < 2 {
        return None;
    }
    add(&mut pick(terms, words)?["coefficient"], &Rational::one())
}

/// T is the difference of the squares of two parts of the series, of which only one changes; so does its square, unless the part
/// changes its sign.
fn a_harmonic_is_another(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let radius = form(case, "radius")?;
    let coefficient = match radius["kind"].as_str()? {
        "fourier" => pick(&mut radius["cos"], words)?,
        _ => &mut pick(&mut radius["coefficients"], words)?["value"],
    };
    let more = Rational::from(3);
    if &exact(coefficient) * &Rational::from(2) == -&more {
        return None;
    }
    add(coefficient, &more)
}

fn the_power_is_another(case: &mut Case, _: &mut SplitMix) -> Option<()> {
    let statement = case.claim["statement"].as_object_mut()?;
    if statement.remove("square").is_none() {
        statement.insert("square".into(), json!(true));
    }
    Some(())
}

/// The value of a polynomial in the parameters.
fn terms_at(terms: &Value, parameters: &[Rational]) -> Option<Rational> {
    value_at(&json!({ "terms": terms }), parameters)
}

/// The coordinates of a curve or patch with rational parameters.
fn point_of(curve: &Value, parameters: &[Rational]) -> Option<Vec<Rational>> {
    let coordinates = curve["coordinates"].as_array()?.iter();
    let quotient = |c: &Value| {
        let below = terms_at(&c["denominator"], parameters)?;
        (!below.is_zero()).then_some(())?;
        Some(&terms_at(&c["numerator"], parameters)? / &below)
    };
    coordinates.map(quotient).collect()
}

/// Whether the identity does not hold at some parameters.
fn is_violated(case: &Case) -> Option<()> {
    let statement = &case.claim["statement"];
    let at = |index: &Value| case.forms.get(usize::try_from(index.as_u64()?).unwrap());
    let curve = at(&statement["curve"])?;
    let parameters: Vec<Rational> = [7, 5]
        .iter()
        .map(|d| &Rational::from(3) / &Rational::from(*d))
        .take(curve["parameters"].as_array()?.len())
        .collect();
    let point = point_of(curve, &parameters)?;
    let mut equations = statement["equations"].as_array()?.iter();
    let is_zero = |index| Some(value_at(at(index)?, &point)?.is_zero());
    equations
        .any(|index| is_zero(index) == Some(false))
        .then_some(())
}

fn an_equation_is_another(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let first = case.claim["statement"]["equations"][0].as_u64()?;
    let terms = &mut case.forms[usize::try_from(first).unwrap()]["terms"];
    add(&mut pick(terms, words)?["coefficient"], &Rational::one())?;
    is_violated(case)
}

fn the_curve_is_another(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let coordinate = pick(&mut form(case, "curve")?["coordinates"], words)?;
    let terms = pick(&mut coordinate["numerator"], words)?;
    add(&mut terms["coefficient"], &Rational::one())?;
    is_violated(case)
}

fn the_constant_is_another(case: &mut Case, _: &mut SplitMix) -> Option<()> {
    add(&mut case.claim["statement"]["constant"], &Rational::one())
}

fn a_factor_is_counted_twice(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let factor = pick(&mut case.claim["statement"]["factors"], words)?;
    factor["multiplicity"] = json!(factor["multiplicity"].as_u64()? + 1);
    Some(())
}

fn a_factor_is_another(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let whole = case.claim["statement"]["form"].as_u64()?;
    let factor = pick(&mut case.claim["statement"]["factors"], words)?;
    let index = factor["form"].as_u64().filter(|index| *index != whole)?;
    let terms = &mut case.forms[usize::try_from(index).unwrap()]["terms"];
    add(&mut pick(terms, words)?["coefficient"], &Rational::one())
}

fn the_prime_is_composite(case: &mut Case, _: &mut SplitMix) -> Option<()> {
    let prime = &mut case.claim["witness"]["prime"];
    *prime = json!(prime.as_u64().filter(|p| *p > 2)? + 1);
    Some(())
}

fn the_line_is_a_point(case: &mut Case, _: &mut SplitMix) -> Option<()> {
    for component in list(&mut case.claim["witness"]["direction"])? {
        *component = json!("0");
    }
    Some(())
}

fn the_polynomial_is_a_product(case: &mut Case, _: &mut SplitMix) -> Option<()> {
    let mut product = form(case, "form")?.clone();
    // f·(x + 7)
    let mut sums: BTreeMap<Vec<i64>, Rational> = BTreeMap::new();
    for term in product["terms"].as_array()? {
        let exponents = term["exponents"].as_array()?.iter();
        let exponents: Vec<i64> = exponents.map(Value::as_i64).collect::<Option<_>>()?;
        let coefficient = exact(&term["coefficient"]);
        let mut raised = exponents.clone();
        raised[0] += 1;
        for (e, factor) in [(exponents, Rational::from(7)), (raised, Rational::one())] {
            let sum = sums.entry(e).or_insert_with(Rational::zero);
            *sum = &*sum + &(&coefficient * &factor);
        }
    }
    let terms = sums.into_iter().filter(|(_, c)| !c.is_zero());
    product["terms"] = terms
        .map(|(e, c)| json!({ "exponents": e, "coefficient": c.to_string() }))
        .collect();
    case.claim["statement"]["form"] = json!(case.forms.len());
    case.forms.push(product);
    Some(())
}

/// The mean of the radius over all directions is its constant term.
fn the_mean_is_negative(case: &mut Case, _: &mut SplitMix) -> Option<()> {
    if case.claim["statement"]["positive"] != true {
        return None;
    }
    let radius = form(case, "form")?;
    let mean = match radius["kind"].as_str()? {
        "fourier" => &mut radius["cos"][0],
        _ => {
            let mut terms = radius["coefficients"].as_array_mut()?.iter_mut();
            &mut terms.find(|term| term["l"] == 0)?["value"]
        }
    };
    *mean = json!((-&(&exact(mean) + &Rational::one())).to_string());
    Some(())
}

/// A point cannot be within a bound beyond which all points are, nor the other way round.
fn a_bound_contradicts_another_one(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let statement = &case.claim["statement"];
    let opposite = match statement["relation"].as_str()? {
        "at-most" => "more-than",
        "more-than" => "at-most",
        _ => return None,
    };
    let others = case.others.iter().filter(|other| {
        let other = &other["statement"];
        other["relation"] == opposite
            && other["point"] == statement["point"]
            && other["form"] == statement["form"]
    });
    let bounds: Vec<Value> = others
        .map(|other| other["statement"]["bound"].clone())
        .collect();
    let chosen = index(words, bounds.len().max(1));
    case.claim["statement"]["bound"] = bounds.get(chosen)?.clone();
    // A checker would divide the cover of a false claim up to the limit.
    if let Some(depth) = case.claim["witness"].get_mut("depth") {
        *depth = json!(6);
    }
    Some(())
}

/// The witness is one that fits the false claim.
fn the_relation_is_the_opposite(case: &mut Case, _: &mut SplitMix) -> Option<()> {
    let statement = &mut case.claim["statement"];
    let opposite = match statement["relation"].as_str()? {
        "at-most" => "more-than",
        "meets" => "misses",
        _ => return None,
    };
    statement["relation"] = json!(opposite);
    case.claim["witness"] = json!({ "depth": 4 });
    Some(())
}

fn the_end_is_too_far(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let statement = &case.claim["statement"];
    let far = &exact(&statement["bound"]) + &Rational::one();
    let mut end = statement["point"].clone();
    add(&mut end[0], &far);
    *pick(&mut case.claim["witness"]["segment"], words)? = end;
    Some(())
}

fn the_sign_is_another(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let sign = &mut case.claim["statement"]["sign"];
    let more = 1 + i64::try_from(words.word() % 2).unwrap();
    *sign = json!((sign.as_i64()? + 1 + more) % 3 - 1);
    Some(())
}

fn a_count_is_another(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let count = pick(&mut case.claim["statement"]["counts"], words)?;
    let side = ["negative", "positive"][index(words, 2)];
    count[side] = json!(count.get(side)?.as_u64()? + 1);
    Some(())
}

/// Two sectors with different counts become one.
fn a_cut_is_left_out(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let statement = &mut case.claim["statement"];
    let cuts = list(&mut statement["cuts"])?;
    let chosen = index(words, cuts.len());
    cuts.remove(chosen);
    let counts = list(&mut statement["counts"])?;
    let other = counts.remove(chosen + 1);
    if other == counts[chosen] || other.is_null() || counts[chosen].is_null() {
        return None;
    }
    let sectors = list(&mut case.claim["witness"]["sectors"])?;
    let mut next = sectors.remove(chosen + 1);
    sectors[chosen].as_array_mut()?.append(next.as_array_mut()?);
    Some(())
}

fn the_angles_are_elsewhere(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let cut = pick(&mut case.claim["statement"]["cuts"], words)?;
    for end in list(&mut cut["angle"])? {
        *end = json!((&exact(end) + &Rational::one()).to_string());
    }
    Some(())
}

fn the_error_is_another(case: &mut Case, words: &mut SplitMix) -> Option<()> {
    let error = &mut case.claim["statement"][["max", "rms"][index(words, 2)]];
    let width = &exact(&error[1]) - &exact(&error[0]);
    for end in list(error)? {
        *end = json!((&exact(end) + &(&width * &Rational::from(2))).to_string());
    }
    Some(())
}

/// Wrong proofs made from the claims of a proof, at most this many.
pub(crate) fn wrong_proofs(text: &str, most: usize, words: &mut SplitMix) -> Vec<String> {
    let proof: Value = serde_json::from_str(text).unwrap();
    assert!(check(text, false).unwrap().holds(), "{text}");
    let claims = proof["claims"].as_array().unwrap();
    let proved: Vec<&Value> = claims.iter().filter(|c| !c["witness"].is_null()).collect();
    let mut made = Vec::new();
    for _ in 0..4 * most {
        if made.len() == most || proved.is_empty() {
            break;
        }
        let claim = proved[index(words, proved.len())].clone();
        let own = CHANGES.iter().filter(|(name, _)| claim["claim"] == *name);
        let mut own: Vec<Change> = own.map(|(_, change)| *change).collect();
        // One in ten changes is of the kind that is always wrong.
        if words.word().is_multiple_of(10) {
            own = ALWAYS.to_vec();
        }
        let mut case = Case {
            forms: proof["forms"].as_array().unwrap().clone(),
            claim,
            others: claims.clone(),
        };
        let change = own[index(words, own.len())];
        if change(&mut case, words).is_some() {
            let Case { forms, claim, .. } = case;
            let wrong = json!({ "schema": "stellate/1", "kind": "proof", "forms": forms, "claims": [claim] });
            made.push(wrong.to_string());
        }
    }
    made
}
