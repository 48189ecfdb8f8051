//! The equations of a space curve: generators of all polynomials that vanish on it, by certified linear algebra.

use super::map::RationalMap;
use super::tracing::tracing_index;
use super::vanishing::{kernel_modulo, lift, monomials};
use crate::error::{Error, Invariant, Result};
use crate::limits::Limits;
use crate::modular::{Span, large_primes};
use crate::poly::SparsePolynomial;
use crate::shape::{ImplicitSurface, SpaceCurve};

/// The equations of a parametric space curve.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct SpaceCurveEquations {
    /// Surfaces whose intersection is the curve and nothing else, by ascending degree. Their polynomials are a minimal set of
    /// generators, degree by degree, of all polynomials that vanish on the curve.
    pub surfaces: Vec<ImplicitSurface>,
    /// The degree of the curve: the number of points, complex ones and those at infinity included, in which it meets a general
    /// plane.
    pub degree: usize,
    /// The tracing index of the parametrization: see [`PlaneEquation::tracing_index`](super::PlaneEquation::tracing_index).
    pub tracing_index: usize,
}

/// The sets of variables that an equation may have, in the order of preference: fewer variables first.
const PREFERRED: [[bool; 3]; 7] = [
    [true, false, false],
    [false, true, false],
    [false, false, true],
    [true, true, false],
    [true, false, true],
    [false, true, true],
    [true, true, true],
];

/// Finds equations whose common zero set is the space curve alone.
///
/// The polynomials of degree at most e that vanish on the curve are the kernel of the values of the monomials at random points
/// modulo a prime. Those that are not combinations of multiples of equations of lower degree are lifted to Q and proved by
/// exact substitution. A curve of degree D that is in no plane is cut out, even as a scheme, by its equations of degree at most
/// D − 1, because it is (D−1)-regular (Gruson, Lazarsfeld & Peskine 1983). A curve in a plane is cut out by the plane and one
/// equation of degree D.
///
/// ```
/// use stellate::implicitize::implicitize_space_curve;
/// use stellate::language::{Numbers, parse_form};
/// use stellate::limits::Limits;
/// use stellate::shape::Form;
///
/// // Example 3
/// let form = parse_form("x = sin(t); y = cos(t); z = cos(t)^2", "<form>", Numbers::Exact)?;
/// let Form::SpaceCurve(curve) = form else { panic!("a space curve") };
/// let equations = implicitize_space_curve(&curve, &Limits::none())?;
/// for (surface, text) in equations.surfaces.into_iter().zip(["x^2 + y^2 - 1 + 0z", "x^2 + z - 1"]) {
///     assert_eq!(Form::Surface(surface), parse_form(text, "<form>", Numbers::Exact)?);
/// }
/// assert_eq!((equations.degree, equations.tracing_index), (4, 1));
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// Cost: Gaussian elimination with C(D+2, 3) columns, and once more for every equation and every prime that it needs.
///
/// # Errors
/// [`Error::Hypothesis`] if all coordinates are constant; [`Error::Limit`] for curves of degree above 19; those of
/// `limits`.
pub fn implicitize_space_curve(curve: &SpaceCurve, limits: &Limits) -> Result<SpaceCurveEquations> {
    if curve.is_point() {
        return Err(Error::Hypothesis {
            statement: "implicitization",
            witness: "all coordinates are constant: that is a point, not a curve".into(),
        });
    }
    let tracing_index = tracing_index(curve.coordinates(), limits)?;
    let degree = projective_degree(curve) / tracing_index;
    let map = RationalMap::of_curve(curve);
    let prime = large_primes()
        .next()
        .invariant("there are primes below 2^31");
    let mut surfaces: Vec<SparsePolynomial<3>> = Vec::new();
    // A basis, modulo the prime, of the equations of degree at most e − 1.
    let mut below: Vec<Vec<u64>> = Vec::new();
    let mut below_monomials = monomials(0, [true; 3]);
    let mut e = 0;
    let mut in_a_plane = false;
    while e < if in_a_plane {
        degree
    } else {
        (degree - 1).max(1)
    } {
        limits.check()?;
        e += 1;
        let degree_limit = u32::try_from(e).invariant("a degree is below 2^32");
        let all = monomials(degree_limit, [true; 3]);
        let kernel = kernel_modulo(&map, &all, prime, limits)?;
        let mut span = Span::new(all.len(), prime);
        for vector in multiples(&below, &below_monomials, &all) {
            // All these polynomials vanish on the curve, so no others are in the kernel.
            if span.len() == kernel.vectors.len() {
                break;
            }
            span.add(vector);
        }
        for variables in PREFERRED {
            if span.len() == kernel.vectors.len() {
                break;
            }
            let some = monomials(degree_limit, variables);
            let fewer = (variables != [true; 3])
                .then(|| kernel_modulo(&map, &some, prime, limits))
                .transpose()?;
            for vector in &fewer.as_ref().unwrap_or(&kernel).vectors {
                if span.add(spread(vector, &some, &all)) {
                    surfaces.push(lift(&map, &some, vector, limits)?);
                }
            }
        }
        in_a_plane |= e == 1 && !surfaces.is_empty();
        (below, below_monomials) = (kernel.vectors, all);
    }
    Ok(SpaceCurveEquations {
        surfaces: surfaces.into_iter().map(ImplicitSurface::new).collect(),
        degree,
        tracing_index,
    })
}

/// The degree of (x : y : z : 1) as a map to projective space, that is the largest degree of the numerators and the denominator
/// over the least common denominator.
fn projective_degree(curve: &SpaceCurve) -> usize {
    use crate::poly::{IntegerPolynomial, polynomial_gcd};
    use malachite::base::polynomial::Polynomial;
    let degree = |p: &IntegerPolynomial| p.coefficients_asc().len().saturating_sub(1);
    let mut common = IntegerPolynomial::one();
    for f in curve.coordinates() {
        let q = f.denominator();
        let shared = polynomial_gcd(&common, q);
        common *= crate::poly::divide_exactly(q, &shared).invariant("a gcd divides");
    }
    let below = degree(&common);
    let above = curve.coordinates().iter().map(|f| {
        let numerator = f.numerator();
        if *numerator == IntegerPolynomial::default() {
            return 0;
        }
        degree(numerator) + below - degree(f.denominator())
    });
    above.fold(below, usize::max)
}

/// The vectors of `below` times 1, x, y and z, as vectors over the larger list of monomials.
fn multiples(below: &[Vec<u64>], from: &[[u32; 3]], to: &[[u32; 3]]) -> Vec<Vec<u64>> {
    let mut result = Vec::new();
    for shift in [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]] {
        let shifted: Vec<[u32; 3]> = from
            .iter()
            .map(|e| std::array::from_fn(|v| e[v] + shift[v]))
            .collect();
        result.extend(below.iter().map(|vector| spread(vector, &shifted, to)));
    }
    result
}

/// The same polynomial as a vector over a list of monomials that contains its own.
fn spread(vector: &[u64], from: &[[u32; 3]], to: &[[u32; 3]]) -> Vec<u64> {
    let mut result = vec![0; to.len()];
    for (e, &c) in from.iter().zip(vector).filter(|(_, c)| **c != 0) {
        let place = to.binary_search_by(|other| crate::poly::term_order(e, other));
        if let Ok(place) = place {
            result[place] = c;
        }
    }
    result
}
