//! Claims about the points in a direction: their number, their multiplicities and their nearest doubles.

use malachite::Integer;
use malachite::base::num::basic::traits::Zero;
use malachite::base::polynomial::Polynomial;
use serde_json::{Value, json};

use super::breakpoints::{End, Roots};
use super::forms::texts;
use super::proof::Claim;
use crate::exact::Rational;
use crate::poly::{IntegerPolynomial, squarefree_decomposition};
use crate::roots::{RealRoot, real_roots};
use crate::sample::{HomogeneousParts, Ray, UnitVector, along};

/// The claim of all points of a ray: `root-count`. `form` is the index of the polynomial, and `center` the origin of the coordinates
/// of the points.
pub(crate) fn ray<P: HomogeneousParts<V>, const V: usize>(
    form: Option<usize>,
    polynomial: &P,
    center: &[Rational; V],
    direction: &impl UnitVector<V>,
    ray: &Ray<V>,
) -> Claim {
    let unit = direction.components();
    let mut statement = json!({ "form": form, "direction": texts(&unit) });
    if center.iter().any(|c| !c.is_zero()) {
        statement["center"] = texts(center);
    }
    let (vector, w) = direction.over_common_denominator();
    let along = along(polynomial, &vector, &w);
    let witness = match (ray, along.last()) {
        (Ray::Points(points), Some((lowest, _))) => {
            statement["order_at_zero"] = json!(lowest);
            statement["roots"] = points.iter().rev().map(root).collect();
            restricted_witness(&along)
        }
        _ => {
            statement["order_at_zero"] = json!("line");
            statement["roots"] = json!([]);
            Some(json!({ "breakpoints": [] }))
        }
    };
    Claim::new("root-count", &statement, witness.filter(|_| form.is_some()))
}

/// The claim of all points of a ray of a form that proof files cannot state, which has no witness: a superquadric with these
/// semi-axes, exponents ε and level.
pub(crate) fn superquadric_ray<const V: usize>(
    [semi_axes, epsilon, level]: [&[Rational]; 3],
    direction: &impl UnitVector<V>,
    ray: &Ray<V>,
) -> Claim {
    let points = match ray {
        Ray::Points(points) => points.as_slice(),
        Ray::Line => &[],
    };
    let roots: Value = points.iter().rev().map(root).collect();
    let direction = texts(&direction.components());
    let shape =
        json!({ "semi_axes": texts(semi_axes), "epsilon": texts(epsilon), "level": texts(level) });
    let statement = json!({ "superquadric": shape, "direction": direction, "roots": roots });
    Claim::new("root-count", &statement, None)
}

fn root<const V: usize>(point: &crate::sample::Sample<V>) -> Value {
    let position: Vec<String> = point.position.iter().map(|c| double(*c)).collect();
    json!({ "multiplicity": point.multiplicity, "nearest": double(point.r), "position": position })
}

fn double(value: f64) -> String {
    match value {
        f64::INFINITY => "inf".into(),
        f64::NEG_INFINITY => "-inf".into(),
        value => format!("{value:e}"),
    }
}

/// The breakpoints for the non-zero coefficients (d, c_d), descending in d, divided by the lowest power; and the squarefree parts
/// if there are multiple roots.
fn restricted_witness(along: &[(usize, Integer)]) -> Option<Value> {
    let (lowest, _) = along.last()?;
    let mut coefficients = vec![Integer::ZERO; along.first()?.0 - lowest + 1];
    for (d, c) in along {
        coefficients[d - lowest].clone_from(c);
    }
    let whole = IntegerPolynomial::from_coefficients_asc(coefficients);
    let parts = squarefree_decomposition(&whole);
    let is_squarefree = parts.iter().all(|(multiplicity, _)| *multiplicity == 1);
    let squarefree = match is_squarefree {
        true => whole,
        false => parts
            .iter()
            .map(|(_, part)| part.clone())
            .reduce(|product, part| &product * &part)?,
    };
    let enclosures = apart(real_roots(&squarefree));
    let roots = Roots {
        coefficients: squarefree.coefficients_asc(),
        enclosures: &enclosures,
    };
    let breakpoints = roots.breakpoints(&End::Below, &End::Above)?;
    let mut witness = json!({ "breakpoints": texts(&breakpoints) });
    if !is_squarefree {
        let part = |(multiplicity, part): &(usize, IntegerPolynomial)| {
            let coefficients: Vec<String> = part
                .coefficients_asc()
                .iter()
                .map(Integer::to_string)
                .collect();
            json!({ "multiplicity": multiplicity, "coefficients": coefficients })
        };
        witness["parts"] = parts.iter().map(part).collect();
    }
    Some(witness)
}

/// Enclosures of distinct roots, ascending, that have gaps between them.
pub(super) fn apart(mut roots: Vec<RealRoot>) -> Vec<(Rational, Rational)> {
    let mut exponent = 0;
    loop {
        let bounds: Vec<_> = roots.iter().map(RealRoot::bounds).collect();
        if bounds.windows(2).all(|pair| pair[0].1 < pair[1].0) {
            return bounds;
        }
        exponent -= 8;
        for root in &mut roots {
            root.refine_to_width(exponent);
        }
    }
}
