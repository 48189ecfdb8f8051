//! Proofs that a factor is irreducible.

use std::fmt;

/// A coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Variable {
    /// The coordinate x, which is also the variable of a univariate polynomial.
    X,
    /// The coordinate y.
    Y,
    /// The coordinate z.
    Z,
}

impl Variable {
    pub(super) fn from_index(index: usize) -> Self {
        match index {
            0 => Self::X,
            1 => Self::Y,
            _ => Self::Z,
        }
    }
}

impl fmt::Display for Variable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
        })
    }
}

/// The reason why a factor has no proper factors over the rational numbers. In every case the coefficients of the factor in the
/// variable in question have no common factor.
///
/// A homogeneous factor is judged by its value at 1 for the last variable.
///
/// `Display` writes the reason as one phrase.
#[non_exhaustive]
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Irreducibility {
    /// The factor has degree 1 in a variable.
    Linear {
        /// The variable.
        variable: Variable,
    },
    /// No degree of a proper factor is possible modulo all these primes. If there is one prime, the factor is irreducible
    /// modulo it.
    Degrees {
        /// The primes.
        primes: Vec<u64>,
    },
    /// No degree of a proper factor is possible at all these points, at each of which the factor keeps its degree in the
    /// remaining variable. If there is one point, the factor is irreducible there.
    Specialization {
        /// The values of all variables but one.
        points: Vec<Vec<(Variable, i64)>>,
    },
    /// The factor is irreducible as a polynomial in a power of a variable. By Capelli's theorem (Lang, *Algebra*, VI, Theorem
    /// 9.1) it is also irreducible in the variable itself, because the norm of a root is not such a power.
    Capelli {
        /// The variable.
        variable: Variable,
        /// The prime exponent of its power.
        exponent: u32,
    },
    /// No product of some, but not all, of the local factors (modulo a prime power, or as power series at a point) is a factor.
    Recombination {
        /// The number of local factors of the polynomial in which the factor was found.
        local: usize,
    },
}

impl fmt::Display for Irreducibility {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Linear { variable } => write!(f, "linear in {variable}"),
            Self::Degrees { primes } => match primes.as_slice() {
                [p] => write!(f, "irreducible modulo {p}"),
                _ => {
                    f.write_str("no degree of a factor is possible modulo all of ")?;
                    list(f, primes, |f, p| write!(f, "{p}"))
                }
            },
            Self::Specialization { points } => {
                let write_point = |f: &mut fmt::Formatter<'_>, point: &Vec<(Variable, i64)>| {
                    for (k, (v, a)) in point.iter().enumerate() {
                        let comma = if k > 0 { ", " } else { "" };
                        write!(f, "{comma}{v} = {a}")?;
                    }
                    Ok(())
                };
                match points.as_slice() {
                    [point] => {
                        f.write_str("irreducible at ")?;
                        write_point(f, point)
                    }
                    _ => {
                        f.write_str("no degree of a factor is possible at all of ")?;
                        list(f, points, write_point)
                    }
                }
            }
            Self::Capelli { variable, exponent } => write!(
                f,
                "irreducible in {variable}^{exponent}, and by Capelli's theorem in {variable}"
            ),
            Self::Recombination { local } => {
                write!(f, "no product of some of {local} local factors divides it")
            }
        }
    }
}

fn list<T>(
    f: &mut fmt::Formatter<'_>,
    items: &[T],
    write_item: impl Fn(&mut fmt::Formatter<'_>, &T) -> fmt::Result,
) -> fmt::Result {
    for (k, item) in items.iter().enumerate() {
        match k {
            0 => {}
            _ if k + 1 == items.len() => f.write_str(" and ")?,
            _ => f.write_str("; ")?,
        }
        write_item(f, item)?;
    }
    Ok(())
}
