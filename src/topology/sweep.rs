//! A plane curve over the line of the first coordinate: the critical values, the points above them, and the arcs between them.
//!
//! In the coordinates (t, R) with x = t + shear·R and y = R, f has a constant leading coefficient in R, so no arc is vertical and
//! none tends to infinity over a finite t. The critical values are the zeros of the discriminant with respect to R. Over an open
//! interval between two of them, the curve consists of arcs that are graphs of functions of t and do not meet.

use malachite::base::num::basic::traits::Zero;

use super::fibre::Fibre;
use super::strip::Strip;
use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::modular::PrimeField;
use crate::poly::{
    IntegerPolynomial, PlanePolynomial, Weights, signed_subresultant, squarefree_decomposition,
};
use crate::roots::{RealRoot, between, disjoint, distinct_roots, real_roots};

/// A squarefree polynomial in sheared coordinates, with its discriminant.
#[derive(Clone, Debug)]
pub(crate) struct Sheared {
    pub(crate) shear: i64,
    pub(crate) strip: Strip,
    /// The degree of the curve, which is the degree in R.
    pub(crate) degree: usize,
    /// The discriminant with respect to R, up to a constant.
    pub(crate) discriminant: IntegerPolynomial,
    /// The squarefree parts of the discriminant with their multiplicities.
    pub(crate) parts: Vec<(usize, IntegerPolynomial)>,
}

impl Sheared {
    /// The polynomial f(t + shear·R, R); `None` if its leading coefficient in R is not constant. f must be squarefree and have a
    /// degree of at least 1.
    ///
    /// # Errors
    /// Those of [`signed_subresultant`].
    pub(crate) fn new(f: &PlanePolynomial, shear: i64, limits: &Limits) -> Result<Option<Self>> {
        let strip = Strip::of_plane(f, shear);
        let degree = f.degree().invariant("the polynomial is not 0");
        if strip.coefficients().len() != degree + 1 {
            return Ok(None);
        }
        let discriminant = eliminant(&strip, degree, 0, limits)?;
        if discriminant == IntegerPolynomial::ZERO {
            return Err(Error::internal(
                "the discriminant of a curve",
                "a squarefree polynomial has a discriminant that is not 0",
            ));
        }
        let parts = squarefree_decomposition(&discriminant);
        Ok(Some(Self {
            shear,
            strip,
            degree,
            discriminant,
            parts,
        }))
    }
}

impl Sheared {
    /// The coefficients modulo a prime, by powers of R and then of t.
    pub(super) fn modulo(&self, field: &PrimeField) -> Vec<Vec<u64>> {
        let coefficients = self.strip.coefficients().iter();
        coefficients.map(|a| field.residues(a)).collect()
    }
}

/// sRes_j(f, ∂f/∂R) for coefficients whose degrees fall from `degree` by one each.
pub(super) fn eliminant(
    strip: &Strip,
    degree: usize,
    j: usize,
    limits: &Limits,
) -> Result<IntegerPolynomial> {
    let weights = Weights {
        lowest: degree,
        step: -1,
    };
    signed_subresultant(strip.coefficients(), j, weights, limits)
}

/// The curve over the t-line.
#[derive(Clone, Debug)]
pub(crate) struct Sweep {
    pub(crate) curve: Sheared,
    /// The points above the critical values, ascending; the enclosures of the values are disjoint.
    pub(crate) fibres: Vec<Fibre>,
    /// A value below, between and above the critical ones.
    pub(crate) insides: Vec<Rational>,
    /// The arcs over each interval, ascending: R of their points above the value inside.
    pub(crate) arcs: Vec<Vec<RealRoot>>,
}

impl Sweep {
    /// Finds the points and arcs of the curve.
    ///
    /// # Errors
    /// Those of [`signed_subresultant`], and [`Error::Limit`] if two points of a fibre are too near each other.
    pub(crate) fn new(curve: Sheared, limits: &Limits) -> Result<Self> {
        let values = disjoint(distinct_roots(curve.parts.iter().map(|(_, g)| g)));
        let insides = between(&values);
        let mut subresultants = Vec::new();
        let mut fibres = Vec::with_capacity(values.len());
        for (index, value) in values.iter().enumerate() {
            limits.check()?;
            let lost = curve.lost_roots(value, &mut subresultants, limits)?;
            let (low, high) = value.enclosure();
            let room = (low.to_rational() - &insides[index])
                .min(&insides[index + 1] - &high.to_rational());
            let distinct = curve.degree - lost;
            fibres.push(Fibre::new(&curve.strip, value, &room, distinct, limits)?);
        }
        let arcs = insides
            .iter()
            .map(|t| real_roots(&curve.strip.along(t)))
            .collect::<Vec<_>>();
        for (index, fibre) in fibres.iter().enumerate() {
            for side in 0..2 {
                let ends: usize = fibre.points.iter().map(|point| point.arcs[side]).sum();
                if ends != arcs[index + side].len() {
                    return Err(Error::internal(
                        "the topology of a curve",
                        "every arc over an interval ends at its ends",
                    ));
                }
            }
        }
        Ok(Self {
            curve,
            fibres,
            insides,
            arcs,
        })
    }

    /// The number of arcs that end at the points before `point` of a fibre, on one side.
    pub(crate) fn arcs_below(&self, fibre: usize, point: usize, side: usize) -> usize {
        let before = self.fibres[fibre].points[..point].iter();
        before.map(|p| p.arcs[side]).sum()
    }
}

impl Sheared {
    /// The degree of f minus the number of its distinct complex roots at a critical value: the first index j with sRes_j ≠ 0
    /// there (Basu, Pollack, Roy, Proposition 4.24). At a simple zero of the discriminant it is 1.
    fn lost_roots(
        &self,
        value: &RealRoot,
        subresultants: &mut Vec<IntegerPolynomial>,
        limits: &Limits,
    ) -> Result<usize> {
        if self.multiplicity(value) == 1 {
            return Ok(1);
        }
        for j in 1..self.degree {
            if subresultants.len() < j {
                subresultants.push(eliminant(&self.strip, self.degree, j, limits)?);
            }
            let vanishes = subresultants[j - 1] == IntegerPolynomial::ZERO
                || value.is_root_of(&subresultants[j - 1]);
            if !vanishes {
                return Ok(j);
            }
        }
        Err(Error::internal(
            "the topology of a curve",
            "sRes_(n−1) is n times the leading coefficient, which is not 0",
        ))
    }

    /// The multiplicity of a value as a zero of the discriminant.
    pub(crate) fn multiplicity(&self, value: &RealRoot) -> usize {
        let part = self.parts.iter().find(|(_, g)| value.is_root_of(g));
        part.map_or(0, |(multiplicity, _)| *multiplicity)
    }
}
