//! Branches of any degree: certified roots that are followed from direction to direction (Lemma 6).
//!
//! P(θ, R) = Σ f_(low + ik)(cos θ, sin θ) R^i with R = r^k has a constant number of real roots between *critical* directions,
//! which are the zeros of its first coefficient, its last coefficient and its discriminant. These zeros are algebraic, so the
//! angles at which branches begin, end, meet, vanish or become infinite are known exactly.

mod branch;
mod count;
#[cfg(test)]
mod laws;
mod link;

use malachite::Integer;
use malachite::base::num::arithmetic::traits::Pow;
use malachite::base::num::basic::traits::{One, Zero};
use malachite::base::polynomial::Polynomial;

use branch::Graph;
pub use branch::{RootArc, RootBranch};
use link::{Context, Critical, Link};

use super::angle::ExactAngle;
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::poly::{
    BinaryForm, IntegerPolynomial, Weights, divide_exactly, primitive_part, signed_subresultant,
    squarefree_decomposition,
};
use crate::roots::{RealRoot, between, disjoint, distinct_roots, real_roots};
use crate::sample::Direction;
use crate::topology::Strip;

/// The polynomial in R = r^step whose coefficients are forms: `forms[i]` has degree `lowest + i·step`.
#[derive(Clone, Debug)]
pub(super) struct Equation {
    pub(super) forms: Vec<BinaryForm>,
    pub(super) lowest: usize,
    pub(super) step: usize,
}

impl Equation {
    /// The slopes, ascending, of all directions but the vertical one in which a root R may be multiple, 0 or infinite, and 0. The
    /// equation must have no repeated factors and a degree of at least 1 in R.
    ///
    /// # Errors
    /// Those of [`signed_subresultant`].
    pub(super) fn critical_slopes(&self, limits: &Limits) -> Result<Vec<RealRoot>> {
        let [low, .., top] = self.forms.as_slice() else {
            return Ok(Vec::new());
        };
        let outer = [low.dehomogenized(), top.dehomogenized()];
        if self.forms.len() == 2 {
            return Ok(critical_slopes(&outer));
        }
        let discriminant = self.discriminant(&Strip::of_slope(&self.forms), limits)?;
        Ok(critical_slopes(&[outer[0], outer[1], &discriminant]))
    }

    fn weights(&self) -> Weights {
        Weights {
            lowest: self.lowest,
            step: self.step.cast_signed(),
        }
    }

    /// The discriminant with respect to R at (1, t), up to its sign; the strip is that of the slope.
    fn discriminant(&self, strip: &Strip, limits: &Limits) -> Result<IntegerPolynomial> {
        let eliminant = signed_subresultant(strip.coefficients(), 0, self.weights(), limits)?;
        // sRes_0 = ± a_m · discriminant
        let top = &self.forms[self.forms.len() - 1];
        let discriminant = divide_exactly(&eliminant, top.dehomogenized());
        Ok(discriminant.invariant("the leading coefficient divides sRes_0"))
    }

    /// P in an exact direction, ascending in R and up to a positive factor.
    fn along(&self, direction: &Direction) -> IntegerPolynomial {
        let (u, v, w) = direction.integers();
        let unit = w.pow(self.step as u64);
        // f_i(U/W, V/W) W^(lowest + m·step) = f_i(U, V) W^((m − i)·step)
        let mut power = Integer::ONE;
        let mut coefficients = Vec::with_capacity(self.forms.len());
        for form in self.forms.iter().rev() {
            coefficients.push(form.evaluate(u, v) * &power);
            power *= &unit;
        }
        coefficients.reverse();
        IntegerPolynomial::from_coefficients_asc(coefficients)
    }
}

/// The circle of directions, cut into sectors at the critical directions, with the real roots in each sector and their
/// connections across the cuts.
#[derive(Debug)]
pub(super) struct Tracing {
    equation: Equation,
    /// The critical slopes t = y/x, ascending and with disjoint enclosures; 0 is always one of them.
    slopes: Vec<RealRoot>,
    /// Slopes below, between and above the critical ones.
    insides: Vec<Rational>,
    /// The signs of the real roots R at each slope of `insides`, ascending in R.
    roots: Vec<Vec<i8>>,
    /// A link for each critical slope, and one for the vertical direction at the end.
    links: Vec<Link>,
    /// The discriminant with respect to R, as a polynomial in t = tan θ.
    discriminant: IntegerPolynomial,
    graph: Graph,
}

/// A sector: the directions between two neighbouring critical ones. Their slopes are in one interval (`cell`), and x > 0 or, if
/// `turned`, x < 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Sector {
    cell: usize,
    turned: bool,
}

impl Tracing {
    /// Cuts the circle and follows the roots. The equation must have a degree of at least 1 in R, and no repeated factors.
    ///
    /// # Errors
    /// Those of [`signed_subresultant`].
    pub(super) fn new(equation: Equation, limits: &Limits) -> Result<Self> {
        let strip = Strip::of_slope(&equation.forms);
        let weights = equation.weights();
        let top = &equation.forms[equation.forms.len() - 1];
        let low = &equation.forms[0];
        let discriminant = equation.discriminant(&strip, limits)?;
        let m = equation.forms.len() - 1;
        let degree = (2 * m - 2) * equation.lowest + equation.step * m * (m - 1);
        let slopes = disjoint(critical_slopes(&[
            top.dehomogenized(),
            low.dehomogenized(),
            &discriminant,
        ]));
        let insides = between(&slopes);
        let at = |t: &Rational| {
            real_roots(&strip.along(t))
                .iter()
                .map(RealRoot::signum)
                .collect()
        };
        let roots = insides.iter().map(at).collect();
        let parts = squarefree_decomposition(&discriminant);
        let mut links = Vec::with_capacity(slopes.len() + 1);
        for (index, slope) in slopes.iter().enumerate() {
            limits.check()?;
            let root_of = parts.iter().find(|(_, g)| slope.is_root_of(g));
            let cx = Context {
                strip: &strip,
                weights,
                step: equation.step,
                multiplicity: root_of.map_or(0, |(m, _)| *m),
                limits,
            };
            links.push(match slope.as_rational() {
                Some(alpha) => {
                    let room = (&alpha - &insides[index]).min(&insides[index + 1] - &alpha);
                    Link::through(&Critical::Rational(&alpha, room), &cx)?
                }
                None => Link::through(&Critical::Irrational(slope), &cx)?,
            });
        }
        // The vertical direction has t = 0 in the other chart. Negative t of that chart are the slopes beyond the vertical.
        let reciprocal = |t: &Rational| t.abs().recip().unwrap_or_default();
        let room = reciprocal(&insides[0]).min(reciprocal(&insides[insides.len() - 1]));
        let vertical = Strip::of_cotangent(&equation.forms);
        let drop = degree + 1 - discriminant.coefficients_asc().len();
        let cx = Context {
            strip: &vertical,
            weights,
            step: equation.step,
            multiplicity: drop,
            limits,
        };
        let mut link = Link::through(&Critical::Rational(&Rational::zero(), room), &cx)?;
        link.limits.reverse();
        for (before, after) in &mut link.pairs {
            std::mem::swap(before, after);
        }
        links.push(link);
        let mut tracing = Self {
            equation,
            slopes,
            insides,
            roots,
            links,
            discriminant,
            graph: Graph::default(),
        };
        tracing.graph = tracing.new_graph();
        Ok(tracing)
    }

    /// The discriminant of P with respect to R at (1, t), made primitive.
    pub(super) fn discriminant(&self) -> IntegerPolynomial {
        primitive_part(&self.discriminant)
    }

    /// The angles in [0, 2π) at which some link is not complete.
    pub(super) fn open_angles(&self) -> Vec<ExactAngle> {
        let boundaries = self.boundaries();
        let open = boundaries
            .iter()
            .filter(|(index, _)| !self.links[*index].complete);
        open.map(|&(index, turned)| self.angle(index, turned))
            .collect()
    }

    /// All sectors, in the order of angles from 0.
    fn sectors(&self) -> Vec<Sector> {
        let zero = self.slopes.iter().take_while(|t| t.signum() < 0).count();
        let right =
            |cells: std::ops::Range<usize>, turned| cells.map(move |cell| Sector { cell, turned });
        let cells = self.insides.len();
        let half = right(zero + 1..cells, false).chain(right(0..zero + 1, true));
        let other = right(zero + 1..cells, true).chain(right(0..zero + 1, false));
        half.chain(other).collect()
    }

    /// The boundary before each sector: the index of its link, and whether it is turned.
    fn boundaries(&self) -> Vec<(usize, bool)> {
        let vertical = self.slopes.len();
        let before = |sector: &Sector| {
            if sector.cell == 0 {
                // The boundary is the vertical; it is turned if the sector before it has x > 0.
                (vertical, !sector.turned)
            } else {
                (sector.cell - 1, sector.turned)
            }
        };
        self.sectors().iter().map(before).collect()
    }

    /// The angle in [0, 2π) that belongs to a link.
    fn angle(&self, index: usize, turned: bool) -> ExactAngle {
        let angle = match self.slopes.get(index) {
            None => ExactAngle::Pi(Rational::one() / Rational::from(2)),
            Some(slope) => ExactAngle::of_tangent(slope.clone()),
        };
        // `of_tangent` gives an angle in [0, π), in which x < 0 for negative slopes.
        let is_left = self.slopes.get(index).is_some_and(|t| t.signum() < 0);
        if turned != is_left {
            angle.plus_pi()
        } else {
            angle
        }
    }

    /// Whether a turn by π changes the signs of all R.
    fn is_odd(&self) -> bool {
        self.equation.step % 2 == 1
    }

    /// The signs of the roots R in a sector, ascending in R.
    fn signs(&self, sector: Sector) -> Vec<i8> {
        let signs = &self.roots[sector.cell];
        if sector.turned && self.is_odd() {
            signs.iter().rev().map(|s| -s).collect()
        } else {
            signs.clone()
        }
    }

    /// The link for directions with x > 0, or for the opposite ones if `turned`.
    fn link(&self, index: usize, turned: bool) -> Link {
        let mut link = self.links[index].clone();
        if turned && self.is_odd() {
            let [before, after] = link.limits.each_ref().map(Vec::len);
            for list in &mut link.limits {
                list.reverse();
                for limit in list.iter_mut().flatten() {
                    *limit = -*limit;
                }
            }
            for (a, b) in &mut link.pairs {
                (*a, *b) = (before - 1 - *a, after - 1 - *b);
            }
            for sign in link.isolated.iter_mut().chain(&mut link.finite) {
                *sign = -*sign;
            }
            link.finite.reverse();
        }
        link
    }

    /// The index of the sector in which a direction is; `None` for a critical direction.
    fn sector_of(&self, u: &Integer, v: &Integer) -> Option<usize> {
        let slope = Rational::from_integers(v.clone(), u.clone())?;
        let cell = self
            .slopes
            .partition_point(|t| t.cmp_rational(&slope).is_lt());
        if self
            .slopes
            .get(cell)
            .is_some_and(|t| t.cmp_rational(&slope).is_eq())
        {
            return None;
        }
        let turned = *u < 0;
        self.sectors()
            .iter()
            .position(|s| *s == Sector { cell, turned })
    }
}

/// The distinct real zeros of some polynomials, and 0, ascending. Each is a root of a factor that is as small as squarefree
/// decompositions make it.
fn critical_slopes(polynomials: &[&IntegerPolynomial]) -> Vec<RealRoot> {
    let t = IntegerPolynomial::from_coefficients_asc(vec![Integer::ZERO, Integer::ONE]);
    let parts: Vec<IntegerPolynomial> = polynomials
        .iter()
        .flat_map(|f| squarefree_decomposition(f))
        .map(|(_, part)| part)
        .collect();
    distinct_roots(std::iter::once(&t).chain(&parts))
}
