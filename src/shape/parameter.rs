//! The parameters of parametric curves and surfaces.

use std::fmt;

use crate::exact::Rational;

/// A parameter. The coordinates of a parametric form are rational functions of a variable s, which is the parameter itself or
/// the tangent of a multiple of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameter {
    name: String,
    step: Option<Rational>,
}

impl Parameter {
    /// A parameter t that runs through the real numbers: s = t.
    #[must_use]
    pub fn number(name: &str) -> Self {
        Self {
            name: name.into(),
            step: None,
        }
    }

    /// An angle t: s = tan(step·t/2), so that `cos(step·t) = (1 − s²)/(1 + s²)` and
    /// `sin(step·t) = 2s/(1 + s²)`.
    #[must_use]
    pub fn angle(name: &str, step: Rational) -> Self {
        Self {
            name: name.into(),
            step: Some(step),
        }
    }

    /// The name of the parameter.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The positive number g in s = tan(g·t/2), if the parameter is an angle; all coordinates have the period 2π/g.
    #[must_use]
    pub fn step(&self) -> Option<&Rational> {
        self.step.as_ref()
    }

    /// Whether the parameter is an angle; then s may be infinite, at t = π/g.
    #[must_use]
    pub fn is_angle(&self) -> bool {
        self.step.is_some()
    }
}

impl fmt::Display for Parameter {
    /// The variable s in terms of the parameter.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.step {
            None => f.write_str(&self.name),
            Some(step) => {
                let half = step / Rational::from(2);
                let (p, q) = (half.numerator(), half.denominator());
                let factor = if p == 1 {
                    String::new()
                } else {
                    format!("{p}*")
                };
                write!(f, "tan({factor}{}", self.name)?;
                if q != 1 {
                    write!(f, "/{q}")?;
                }
                f.write_str(")")
            }
        }
    }
}
