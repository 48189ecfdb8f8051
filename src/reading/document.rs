//! JSON documents are read into forms. An error names the place in the document.

use std::collections::BTreeSet;

use serde_json::{Map, Value};

use super::SCHEMA;
use super::json::read_json;
use super::node::{Node, NodePath};
use super::superquadric::read_superquadric;
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::language::{
    MAX_DEGREE, MAX_HARMONIC, Numbers, check_size, constant_message, implicit, parse_form,
};
use crate::poly::{SparsePolynomial, total_degree};
use crate::shape::{EllipticSeries, Form, FourierRadius, HarmonicSurface};

/// Reads the form of a JSON document.
///
/// The kinds are `implicit`, `fourier`, `spherical`, `superquadric`, `intersection` and `parametric`. The form of a `parametric` document is
/// the first of these that it has: its surfaces (if one curve is not their whole intersection), its elliptic series, its coordinates as functions of parameters (if it has no branches), its superquadric, its
/// implicit equation, the Fourier radius that was fitted, or the exact Fourier radius of its first branch. Unknown fields are
/// ignored.
///
/// Numbers may be strings (`"p/q"`, decimals, hexadecimal floats) or JSON numbers; both are read from their text.
///
/// ```
/// use stellate::reading::read_document;
/// use stellate::language::Numbers;
/// let text = r#"{"schema":"stellate/1","kind":"implicit","variables":["x","y"],
///     "terms":[{"exponents":[2,0],"coefficient":"1"},{"exponents":[0,1],"coefficient":0.1}]}"#;
/// assert!(read_document(text, "parabola.json", Numbers::Exact).is_ok());
///
/// let error = read_document(&text.replace("0.1", "true"), "parabola.json", Numbers::Exact);
/// let message = "parabola.json: terms[1].coefficient: expected a number or a string such as \"1/3\"";
/// assert_eq!(error.unwrap_err().to_string(), message);
/// ```
///
/// # Errors
/// [`Error::Syntax`] if the text is not JSON, or has a field twice; [`Error::Data`] with the place if a field is missing or
/// wrong, or if the kind is another one; [`Error::Limit`] beyond the limits of
/// [`crate::language`].
pub fn read_document(text: &str, source_name: &str, numbers: Numbers) -> Result<Form> {
    check_size(text, source_name)?;
    let value = read_json(text, source_name)?;
    let root = Node {
        value: &value,
        place: NodePath::Root(source_name),
        numbers,
    };
    let object = root.object()?;
    if !object.contains_key("schema") {
        return Err(root.wrong(format!(
            "this is JSON, but no document of stellate: those have \"schema\": \"{SCHEMA}\" and are written with --format json"
        )));
    }
    let schema = root.field(object, "schema")?;
    if schema.string()? != SCHEMA {
        return Err(schema.wrong(format!("expected \"{SCHEMA}\"")));
    }
    let kind = root.field(object, "kind")?;
    match kind.string()? {
        "implicit" => read_implicit(&root, object, source_name),
        "fourier" => read_fourier(&root).map(Form::Fourier),
        "spherical" => read_spherical(&root).map(Form::Harmonic),
        "superquadric" => read_superquadric(&root, object),
        "intersection" => read_intersection(&root, object, source_name),
        "parametric" if holds_more_than_a_curve(object) => {
            read_intersection(&root, object, source_name)
        }
        "parametric" if object.contains_key("elliptic") => {
            let node = root.field(object, "elliptic")?;
            let names = ["x_cos", "x_sin", "y_cos", "y_sin"];
            let series = EllipticSeries::new(read_harmonics(&node, names)?);
            Ok(Form::PlaneCurve(series.to_plane_curve()))
        }
        "parametric" if !object.contains_key("branches") && object.contains_key("coordinates") => {
            read_coordinates(&root, object, source_name)
        }
        "parametric" => {
            if object.contains_key("superquadric") {
                let node = root.field(object, "superquadric")?;
                return read_superquadric(&node, node.object()?);
            }
            if object.contains_key("implicit") {
                let node = root.field(object, "implicit")?;
                return read_implicit(&node, node.object()?, source_name);
            }
            if object.get("method").and_then(Value::as_str) == Some("harmonics") {
                let branches = root.field(object, "branches")?;
                let first = branches.item(branches.array()?, 0)?;
                let node = first.field(first.object()?, "spherical")?;
                return read_spherical(&node).map(Form::Harmonic);
            }
            let radius = if object.contains_key("fit") {
                // A curve without a closed form has a fitted Fourier radius (Lemma 6).
                let fit = root.field(object, "fit")?;
                read_fourier(&fit.field(fit.object()?, "fourier")?)?
            } else {
                let branches = root.field(object, "branches")?;
                let first = branches.item(branches.array()?, 0)?;
                read_fourier(&first.field(first.object()?, "fourier")?)?
            };
            // The branches have one center, which belongs to the whole document.
            Ok(Form::Fourier(match root.plane_center(object)? {
                Some(center) => radius.with_center(center),
                None => radius,
            }))
        }
        other => {
            let shown: String = other.chars().take(30).collect();
            Err(kind.wrong(format!(
                "a document of kind \"{shown}\" is no form; the kinds of forms are \"fourier\", \"implicit\", \
                 \"intersection\", \"parametric\", \"spherical\" and \"superquadric\""
            )))
        }
    }
}

/// Whether a document of an intersection of surfaces has no curve, or more than one and what it approaches.
fn holds_more_than_a_curve(object: &Map<String, Value>) -> bool {
    let list = |name: &str| {
        let list = object.get(name).and_then(Value::as_array);
        list.map_or(&[][..], Vec::as_slice)
    };
    let has_isolated = list("beyond")
        .iter()
        .any(|entry| entry["kind"] == "isolated");
    let is_one =
        list("curves").len() == 1 && list("others").is_empty() && list("points").is_empty();
    object.contains_key("surfaces") && (!is_one || has_isolated)
}

/// Reads the surfaces of a document of an intersection.
fn read_intersection(
    root: &Node<'_>,
    object: &Map<String, Value>,
    source_name: &str,
) -> Result<Form> {
    if let Some((node, _)) = root.center(object)? {
        return Err(
            node.wrong("a center belongs to each of the surfaces, not to what they have in common")
        );
    }
    let list = root.field(object, "surfaces")?;
    let entries = list.array()?;
    if entries.len() < 2 {
        return Err(list.wrong("expected at least two surfaces"));
    }
    let mut surfaces = Vec::new();
    for n in 0..entries.len() {
        let node = list.item(entries, n)?;
        match read_implicit(&node, node.object()?, source_name)? {
            Form::Surface(surface) => surfaces.push(surface),
            _ => return Err(node.wrong("expected a surface, with the variables x, y and z")),
        }
    }
    Ok(Form::Intersection(surfaces))
}

/// Reads a parametric form from its coordinates, each a formula of the input language.
fn read_coordinates(
    root: &Node<'_>,
    object: &Map<String, Value>,
    source_name: &str,
) -> Result<Form> {
    let coordinates = root.field(object, "coordinates")?;
    let fields = coordinates.object()?;
    let mut text = String::new();
    for name in fields.keys() {
        let formula = coordinates.field(fields, name)?;
        text.push_str(&format!("{name} = {}\n", formula.string()?));
    }
    let name = format!("{source_name}: coordinates");
    match parse_form(&text, &name, root.numbers)? {
        form @ (Form::PlaneCurve(_) | Form::SpaceCurve(_) | Form::Patch(_)) => Ok(form),
        _ => {
            Err(coordinates
                .wrong("expected functions of a parameter, such as {\"x\": \"cos(t)\", …}"))
        }
    }
}

fn read_implicit(root: &Node<'_>, object: &Map<String, Value>, source_name: &str) -> Result<Form> {
    let variables = root.field(object, "variables")?;
    let names: Vec<Option<&str>> = variables.array()?.iter().map(Value::as_str).collect();
    let in_space = match names.as_slice() {
        [Some("x"), Some("y")] => false,
        [Some("x"), Some("y"), Some("z")] => true,
        _ => return Err(variables.wrong("expected [\"x\",\"y\"] or [\"x\",\"y\",\"z\"]")),
    };
    let terms = root.field(object, "terms")?;
    let list = terms.array()?;
    let mut polynomial = SparsePolynomial::zero();
    for n in 0..list.len() {
        let term = terms.item(list, n)?;
        let fields = term.object()?;
        let exponents_node = term.field(fields, "exponents")?;
        let powers = exponents_node.array()?;
        if powers.len() != names.len() {
            return Err(exponents_node.wrong(format!("expected {} exponents", names.len())));
        }
        let mut exponents = [0; 3];
        for (i, exponent) in exponents.iter_mut().enumerate().take(powers.len()) {
            *exponent = exponents_node.item(powers, i)?.natural()?;
        }
        if exponents.iter().any(|&e| e > MAX_DEGREE / 3) {
            check_exponents(&exponents_node.place.to_string(), &exponents)?;
        }
        let coefficient = term.field(fields, "coefficient")?.number()?;
        let (is_zero, len) = (coefficient.is_zero(), polynomial.len());
        polynomial.add_term(exponents, coefficient);
        if !is_zero && polynomial.len() <= len {
            return Err(exponents_node.wrong("this term was given before"));
        }
    }
    if let Some(value) = polynomial.as_constant() {
        return Err(terms.wrong(constant_message(&value)));
    }
    check_degrees(root, object, &polynomial)?;
    let center = root.center(object)?;
    implicit(
        polynomial,
        in_space,
        center,
        source_name,
        |node, message| node.wrong(message),
    )
}

/// Refuses the degree and the degrees of the homogeneous parts that a document states, if its terms have others.
fn check_degrees(
    root: &Node<'_>,
    object: &Map<String, Value>,
    polynomial: &SparsePolynomial<3>,
) -> Result<()> {
    let degrees: BTreeSet<u64> = polynomial.terms().map(|(e, _)| total_degree(e)).collect();
    let descending: Vec<u64> = degrees.into_iter().rev().collect();
    let stated = [
        ("degree", Value::from(descending.first().copied())),
        ("homogeneous_degrees", Value::from(descending)),
    ];
    for (name, value) in stated {
        if object.get(name).is_some_and(|stated| *stated != value) {
            let node = root.field(object, name)?;
            return Err(node.wrong(format!("the terms of this document have {value} here")));
        }
    }
    Ok(())
}

fn read_spherical(node: &Node<'_>) -> Result<HarmonicSurface> {
    let object = node.object()?;
    let list = node.field(object, "coefficients")?;
    let entries = list.array()?;
    let mut terms = Vec::with_capacity(entries.len());
    let mut seen = BTreeSet::new();
    for n in 0..entries.len() {
        let entry = list.item(entries, n)?;
        let fields = entry.object()?;
        let l = entry.field(fields, "l")?.natural()? as usize;
        let order = entry.field(fields, "m")?;
        let m = order.value.as_i64().and_then(|m| isize::try_from(m).ok());
        let m = m.filter(|m| m.unsigned_abs() <= l);
        let m = m.ok_or_else(|| order.wrong(format!("expected an integer from -{l} to {l}")))?;
        if !seen.insert((l, m)) {
            return Err(entry.wrong(format!("Y({l}, {m}) was given before")));
        }
        terms.push(((l, m), entry.field(fields, "value")?.number()?));
    }
    let mut surface = HarmonicSurface::new(terms)?;
    if let Some(center) = node.space_center(object)? {
        surface = surface.with_center(center);
    }
    if object.contains_key("radius_rounding") {
        surface = surface.with_rounding(node.field(object, "radius_rounding")?.number()?);
    }
    Ok(surface)
}

fn read_fourier(node: &Node<'_>) -> Result<FourierRadius> {
    let [cos, sin] = read_harmonics(node, ["cos", "sin"])?;
    let radius = FourierRadius::new(cos, sin);
    Ok(match node.plane_center(node.object()?)? {
        Some(center) => radius.with_center(center),
        None => radius,
    })
}

/// Reads lists of coefficients of the same length: of cosines and sines in turn, from harmonic 0 on.
fn read_harmonics<const K: usize>(node: &Node<'_>, names: [&str; K]) -> Result<[Vec<Rational>; K]> {
    let object = node.object()?;
    let mut lists: [Vec<Rational>; K] = std::array::from_fn(|_| Vec::new());
    for (i, name) in names.into_iter().enumerate() {
        let list = node.field(object, name)?;
        let values = list.array()?;
        if values.len() > MAX_HARMONIC as usize + 1 {
            let limit = format!("{}: a harmonic beyond {MAX_HARMONIC}", list.place);
            return Err(Error::limit(limit));
        }
        let numbers: Result<Vec<Rational>> = (0..values.len())
            .map(|n| list.item(values, n)?.number())
            .collect();
        let numbers = numbers?;
        if i == 0 && numbers.is_empty() {
            return Err(
                list.wrong("expected the coefficients of cos 0, cos t, …; the list is empty")
            );
        }
        if i > 0 && numbers.len() != lists[0].len() {
            return Err(list.wrong(format!(
                "expected as many entries as in {}, {}; found {}",
                names[0],
                lists[0].len(),
                numbers.len()
            )));
        }
        if i % 2 == 1 && numbers.first().is_some_and(|b| !b.is_zero()) {
            return Err(list.wrong("the first entry, of sin 0, is 0"));
        }
        lists[i] = numbers;
    }
    Ok(lists)
}

/// Refuses exponents beyond [`MAX_DEGREE`].
pub(super) fn check_exponents(place: &str, exponents: &[u32; 3]) -> Result<()> {
    let degree: u64 = exponents.iter().map(|&e| u64::from(e)).sum();
    if degree > u64::from(MAX_DEGREE) {
        return Err(Error::limit(format!(
            "{place}: a degree beyond {MAX_DEGREE}"
        )));
    }
    Ok(())
}
