//! Test vectors as one JSON document.

use std::io::{self, Write};

use serde::Serialize;

use super::json::Number;
use super::{SCHEMA, center_comment};
use crate::check::{CoefficientVector, PointVector, RadiusVector, TestVectors, VectorInput};
use crate::error::Result;
use crate::exact::hex_literal;
use crate::notation::Notation;

#[derive(Serialize)]
struct VectorsDocument {
    schema: &'static str,
    kind: &'static str,
    variables: &'static [&'static str],
    #[serde(skip_serializing_if = "Option::is_none")]
    center: Option<Vec<String>>,
    inputs: Vec<InputEntry>,
    rounded_inputs: usize,
    coefficients: Vec<CoefficientEntry>,
    radii: Vec<RadiusEntry>,
    points: Vec<PointEntry>,
}

/// A double, as a decimal and with all its bits.
#[derive(Serialize)]
struct Double {
    double: Number,
    hex: String,
}

#[derive(Serialize)]
struct InputEntry {
    name: String,
    #[serde(flatten)]
    value: Double,
}

#[derive(Serialize)]
struct CoefficientEntry {
    exponents: Vec<u32>,
    exact: String,
    #[serde(flatten)]
    nearest: Double,
    condition: Option<Number>,
}

#[derive(Serialize)]
struct RadiusEntry {
    theta: Double,
    r: Double,
    condition: Number,
}

#[derive(Serialize)]
struct PointEntry {
    direction: Vec<String>,
    r: Double,
    position: Vec<Double>,
    multiplicity: usize,
    condition: Number,
}

/// Writes test vectors as a JSON document of kind `vectors`.
///
/// `inputs` are the numbers for a float program: `a0`, `a1`, `b1`, … of the radius, or the coefficients of the polynomial.
/// Every double is written as the shortest decimal that is read back as it (`double`) and as a hexadecimal float (`hex`).
/// `coefficients` have the exact value `p/q`, the nearest double, and the condition number with respect to the inputs. `radii`
/// have the double nearest to r(θ), where θ is the given double. `points` have an exact direction, the doubles nearest to r and
/// to the coordinates, and the condition number of the root with respect to the coefficients. A condition number K means that,
/// to first order, the relative error of an output can be K times that of the inputs, which is a loss of log₁₀ K digits; it is
/// null if there are no inputs. An infinite number is `"inf"`.
///
/// # Errors
/// Those of `out`.
pub fn write_vectors(vectors: &TestVectors, out: &mut dyn Write) -> Result<()> {
    let axes = if vectors.in_space { 3 } else { 2 };
    let document = VectorsDocument {
        schema: SCHEMA,
        kind: "vectors",
        variables: if vectors.in_space {
            &["x", "y", "z"]
        } else {
            &["x", "y"]
        },
        center: center_comment(&vectors.center)
            .map(|_| vectors.center.iter().map(ToString::to_string).collect()),
        inputs: vectors.inputs.iter().map(input).collect(),
        rounded_inputs: vectors.rounded,
        coefficients: vectors
            .coefficients
            .iter()
            .map(|c| coefficient(c, axes))
            .collect(),
        radii: vectors.radii.iter().map(radius).collect(),
        points: vectors.points.iter().map(|p| point(p, axes)).collect(),
    };
    serde_json::to_writer_pretty(&mut *out, &document).map_err(io::Error::from)?;
    Ok(writeln!(out)?)
}

fn double(value: f64) -> Double {
    Double {
        double: Number(value),
        hex: hex_literal(value),
    }
}

fn input(input: &VectorInput) -> InputEntry {
    let (name, value) = match input {
        VectorInput::Cosine(n, value) => (format!("a{n}"), *value),
        VectorInput::Sine(n, value) => (format!("b{n}"), *value),
        VectorInput::Coefficient(exponents, value) => {
            let monomial = Notation::Text.monomial(exponents);
            let name = if monomial.is_empty() {
                "1".into()
            } else {
                monomial
            };
            (name, *value)
        }
    };
    InputEntry {
        name,
        value: double(value),
    }
}

fn coefficient(vector: &CoefficientVector, axes: usize) -> CoefficientEntry {
    CoefficientEntry {
        exponents: vector.exponents[..axes].to_vec(),
        exact: vector.exact.to_string(),
        nearest: double(vector.double),
        condition: vector.condition.as_ref().map(|c| Number(c.to_f64())),
    }
}

fn radius(vector: &RadiusVector) -> RadiusEntry {
    RadiusEntry {
        theta: double(vector.theta),
        r: double(vector.r),
        condition: Number(vector.condition),
    }
}

fn point(vector: &PointVector, axes: usize) -> PointEntry {
    PointEntry {
        direction: vector.unit[..axes]
            .iter()
            .map(ToString::to_string)
            .collect(),
        r: double(vector.r),
        position: vector.position[..axes].iter().map(|v| double(*v)).collect(),
        multiplicity: vector.multiplicity,
        condition: Number(vector.condition),
    }
}
