//! Why a factor is irreducible.

use std::fmt;

/// One of the coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Variable {
    /// x, also the variable of a univariate polynomial.
    X,
    /// y.
    Y,
    /// z.
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

/// Why a factor has no proper factors over the rational numbers. Each reason goes with a factor
/// whose coefficients in the variable in question have no common factor.
///
/// A homogeneous factor is judged with its last variable put to 1.
///
/// `Display` gives one phrase.
#[non_exhaustive]
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Irreducibility {
    /// Of degree 1 in a variable.
    Linear {
        /// That variable.
        variable: Variable,
    },
    /// No proper factor has a degree that is possible modulo all these primes; with one prime, it is
    /// irreducible modulo that.
    Degrees {
        /// The primes.
        primes: Vec<u64>,
    },
    /// No proper factor has a degree that is possible at all these points, each of which keeps the
    /// degree in the remaining variable; with one point, it is irreducible there.
    Specialization {
        /// The values of all variables but one.
        points: Vec<Vec<(Variable, i64)>>,
    },
    /// Irreducible in a power of a variable, and Capelli's theorem (Lang, *Algebra*, VI, Theorem 9.1)
    /// says that it is in the variable itself: the norm of a root is no such power.
    Capelli {
        /// The variable.
        variable: Variable,
        /// The prime exponent of its power.
        exponent: u32,
    },
    /// No product of some, not all, of its local factors (modulo a prime power, or power series at a
    /// point) is a factor.
    Recombination {
        /// The number of local factors of the polynomial it was found in.
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
