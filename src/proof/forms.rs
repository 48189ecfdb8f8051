//! The table of forms, and reading them.

use std::collections::BTreeSet;

use num_bigint::BigInt;

use super::json::{Fields, LARGEST_INTEGER, LONGEST_LIST, Value};
use super::numbers::{Exact, common_denominator, vector};
use super::parametric::{Coordinate, Parametric};
use super::refusal::{Checked, Refusal, need};
use super::series::{Harmonics, Series, SphericalTerm};
use super::sparse::{Exponents, Sparse};

/// The largest degree, exponent and multiplicity.
pub(super) const HIGHEST_DEGREE: u32 = 512;
/// The largest number of roots, parts and factors, and of the cosine coefficients of a radius.
pub(super) const MOST_PARTS: usize = 512;
/// The largest degree of a spherical harmonic.
const HIGHEST_HARMONIC: u32 = 128;

/// A polynomial f = terms/denominator in two or three variables, which is not zero.
#[derive(Debug)]
pub(super) struct Implicit {
    pub(super) dimension: usize,
    pub(super) terms: Sparse,
    /// Positive.
    pub(super) denominator: BigInt,
}

#[derive(Debug)]
enum Form {
    Implicit(Implicit),
    Series(Series),
    Parametric(Parametric),
}

/// The forms that the claims of a document refer to.
#[derive(Debug)]
pub(super) struct Forms {
    forms: Vec<Form>,
}

impl Forms {
    pub(super) fn read(value: &Value) -> Checked<Self> {
        let forms = value.list(0..=LONGEST_LIST, read_form)?;
        Ok(Self { forms })
    }

    fn form(&self, index: &Value) -> Checked<&Form> {
        let index = usize::try_from(index.integer(0..=LARGEST_INTEGER)?).ok();
        index
            .and_then(|index| self.forms.get(index))
            .ok_or_else(|| Refusal::new("there is no form of this index"))
    }

    pub(super) fn implicit(&self, index: &Value) -> Checked<&Implicit> {
        match self.form(index)? {
            Form::Implicit(form) => Ok(form),
            _ => Err(Refusal::new("an implicit form is expected")),
        }
    }

    pub(super) fn series(&self, index: &Value) -> Checked<&Series> {
        match self.form(index)? {
            Form::Series(form) => Ok(form),
            _ => Err(Refusal::new("a Fourier or spherical form is expected")),
        }
    }

    pub(super) fn parametric(&self, index: &Value) -> Checked<&Parametric> {
        match self.form(index)? {
            Form::Parametric(form) => Ok(form),
            _ => Err(Refusal::new("a parametric form is expected")),
        }
    }

    /// An implicit form or a radius.
    pub(super) fn locus(&self, index: &Value) -> Checked<Locus<'_>> {
        match self.form(index)? {
            Form::Implicit(form) => Ok(Locus::Implicit(form)),
            Form::Series(form) => Ok(Locus::Series(form)),
            Form::Parametric(_) => Err(Refusal::new("a parametric form is not allowed here")),
        }
    }
}

/// A form that describes a curve or a surface without parameters.
#[derive(Debug)]
pub(super) enum Locus<'a> {
    Implicit(&'a Implicit),
    Series(&'a Series),
}

impl Locus<'_> {
    pub(super) fn dimension(&self) -> usize {
        match self {
            Self::Implicit(form) => form.dimension,
            Self::Series(form) => form.dimension(),
        }
    }
}

fn read_form(value: &Value) -> Checked<Form> {
    let Value::Object(map) = value else {
        return Err(Refusal::new("a form is an object"));
    };
    match map.get("kind") {
        Some(Value::Text(kind)) => match kind.as_str() {
            "implicit" => {
                let fields = value.fields(&["kind", "variables", "terms"], &[])?;
                read_implicit(&fields).map(Form::Implicit)
            }
            "fourier" => {
                let fields = value.fields(&["kind", "cos", "sin"], &["center"])?;
                read_fourier(&fields).map(Form::Series)
            }
            "spherical" => {
                let fields = value.fields(&["kind", "degree", "coefficients"], &["center"])?;
                read_spherical(&fields).map(Form::Series)
            }
            "parametric" => {
                let fields = value.fields(&["kind", "parameters", "coordinates"], &[])?;
                read_parametric(&fields).map(Form::Parametric)
            }
            _ => Err(Refusal::new("the kind of this form is unknown")),
        },
        _ => Err(Refusal::new("the kind of this form is missing")),
    }
}

/// Reads the terms of a polynomial: the polynomial times its common denominator, and this denominator.
fn read_terms(value: &Value, generators: usize) -> Checked<(Sparse, BigInt)> {
    let mut seen: BTreeSet<Exponents> = BTreeSet::new();
    let terms = value.list(0..=LONGEST_LIST, |term| {
        let fields = term.fields(&["exponents", "coefficient"], &[])?;
        let exponents = fields.get("exponents", |list| read_exponents(list, generators))?;
        let coefficient = fields.get("coefficient", Exact::read_coefficient)?;
        need(!coefficient.is_zero(), "a coefficient is 0")?;
        need(seen.insert(exponents), "a term is given twice")?;
        Ok((exponents, coefficient))
    })?;
    let (exponents, coefficients): (Vec<_>, Vec<_>) = terms.into_iter().unzip();
    let (integers, common) = common_denominator(&coefficients);
    let mut polynomial = Sparse::default();
    for (exponents, c) in exponents.into_iter().zip(integers) {
        polynomial.add_term(exponents, c);
    }
    Ok((polynomial, common))
}

fn read_exponents(value: &Value, generators: usize) -> Checked<Exponents> {
    let list = value.list(generators..=generators, |exponent| {
        exponent.count(HIGHEST_DEGREE)
    })?;
    need(
        list.iter().sum::<u32>() <= HIGHEST_DEGREE,
        "the degree of a term is above 512",
    )?;
    let mut exponents = [0; 4];
    for (slot, exponent) in exponents.iter_mut().zip(list) {
        *slot = exponent;
    }
    Ok(exponents)
}

fn read_implicit(fields: &Fields<'_>) -> Checked<Implicit> {
    let variables = fields.get("variables", |value| value.list(2..=3, Value::text))?;
    let dimension = match variables.as_slice() {
        ["x", "y"] => 2,
        ["x", "y", "z"] => 3,
        _ => return Err(Refusal::new("the variables are x, y or x, y, z").within("variables")),
    };
    let (terms, denominator) = fields.get("terms", |value| read_terms(value, dimension))?;
    need(!terms.is_zero(), "an implicit form has at least one term")?;
    Ok(Implicit {
        dimension,
        terms,
        denominator,
    })
}

fn read_center(fields: &Fields<'_>, dimension: usize) -> Checked<Vec<Exact>> {
    let center = fields.optional("center", |value| vector(value, dimension))?;
    Ok(center.unwrap_or_else(|| vec![Exact::zero(); dimension]))
}

fn read_fourier(fields: &Fields<'_>) -> Checked<Series> {
    let mut all = fields.get("cos", |value| {
        value.list(1..=MOST_PARTS, Exact::read_coefficient)
    })?;
    let length = all.len();
    let sin = fields.get("sin", |value| {
        value.list(length..=length, Exact::read_coefficient)
    })?;
    need(sin.first().is_some_and(Exact::is_zero), "sin[0] is not 0")?;
    all.extend(sin);
    let (mut cos, scale) = common_denominator(&all);
    let sin = cos.split_off(length);
    Ok(Series::new(
        read_center(fields, 2)?,
        scale,
        Harmonics::Plane { cos, sin },
    ))
}

fn read_spherical(fields: &Fields<'_>) -> Checked<Series> {
    let degree = fields.get("degree", |value| value.count(HIGHEST_HARMONIC))?;
    let mut seen = BTreeSet::new();
    let terms = fields.get("coefficients", |value| {
        value.list(0..=LONGEST_LIST, |term| {
            let fields = term.fields(&["l", "m", "value"], &[])?;
            let l = fields.get("l", |value| value.count(degree))?;
            let m = fields.get("m", |value| value.integer(-i64::from(l)..=i64::from(l)))?;
            need(seen.insert((l, m)), "a coefficient is given twice")?;
            Ok((l, m, fields.get("value", Exact::read_coefficient)?))
        })
    })?;
    let values: Vec<_> = terms.iter().map(|(_, _, value)| value.clone()).collect();
    let (integers, scale) = common_denominator(&values);
    let terms = terms.into_iter().zip(integers);
    let coefficients = terms
        .map(|((l, m, _), value)| SphericalTerm { l, m, value })
        .collect();
    let harmonics = Harmonics::Space {
        degree,
        coefficients,
    };
    Ok(Series::new(read_center(fields, 3)?, scale, harmonics))
}

fn read_parametric(fields: &Fields<'_>) -> Checked<Parametric> {
    let angles = fields.get("parameters", |value| {
        value.list(1..=2, |parameter| match parameter.text()? {
            "angle" => Ok(true),
            "rational" => Ok(false),
            _ => Err(Refusal::new("a parameter is an angle or rational")),
        })
    })?;
    let mut curve = Parametric::new(&angles);
    curve.coordinates = fields.get("coordinates", |value| {
        value.list(2..=3, |coordinate| {
            let fields = coordinate.fields(&["numerator", "denominator"], &[])?;
            let generators = curve.generators();
            let read = |value| read_terms(value, generators);
            let (above, above_scale) = fields.get("numerator", read)?;
            let (below, below_scale) = fields.get("denominator", read)?;
            need(
                !curve.reduced(below.clone()).is_zero(),
                "this denominator is zero",
            )?;
            let [mut numerator, mut denominator] = [Sparse::default(), Sparse::default()];
            numerator.add_multiple(&below_scale, &above);
            denominator.add_multiple(&above_scale, &below);
            Ok(Coordinate {
                numerator,
                denominator,
            })
        })
    })?;
    Ok(curve)
}
