//! Fits of sums of spherical harmonics to closed meshes.

mod coefficients;
mod crossing;
mod kernel;
mod nodes;
mod rays;
mod star;

use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::options::options;
use crate::shape::{HarmonicSurface, Solid};

use super::{CenterChoice, Estimator};
use coefficients::{Samples, least_squares, quadrature};
use kernel::{Kernel, kernel};
use rays::Rays;
use star::visible;

/// The largest degree of a fit.
pub const MAX_FIT_DEGREE: usize = 80;

/// The size of a fit to a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum MeshFitSize {
    /// The degree L.
    Degree(usize),
    /// The least degree with which the radial error is at most this.
    Tolerance(f64),
}

options! {
    /// How a sum of spherical harmonics is fitted to a mesh.
    MeshFitOptions of {
        /// The degree, or the tolerance that determines it.
        size: MeshFitSize,
    } {
        /// The center, from which radii are measured: by default the centroid of the solid if it sees the whole mesh, else the deepest point
        /// of the kernel.
        center: CenterChoice = CenterChoice::Auto,
        /// How the coefficients are found: integrals over the sphere, or least squares at the vertices.
        estimator: Estimator = Estimator::Quadrature,
        /// The least number of directions of the quadrature; by default it grows with the mesh.
        samples: Option<usize> = None,
    }
}

/// A sum of spherical harmonics that was fitted to a mesh.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct MeshFit {
    /// The surface, with its center.
    pub surface: HarmonicSurface,
    /// The largest difference of the radii of mesh and surface, in doubles: that in all sampled directions, those of all vertices, and
    /// those of the points of triangles and edges that are nearest to the center, and from the largest of these up to the next maximum.
    pub max_radial_error: f64,
    /// The root of the mean square of the difference over the sphere, in doubles.
    pub rms_radial_error: f64,
    /// Whether every ray from the center meets the mesh once, decided exactly. A fit to another mesh is refused.
    pub is_star_shaped: bool,
    /// The number of directions by which the coefficients were found.
    pub samples: usize,
    /// Whether the center is a point of the kernel because the centroid does not see the whole mesh.
    pub is_moved: bool,
}

/// Fits a sum of spherical harmonics to a closed mesh that is star-shaped about some point.
///
/// Quadrature takes the products of radii and harmonics at the nodes of Gauss and Legendre by equal angles; least squares fit the radii of the
/// vertices, weighted by their parts of the sphere. Radii are doubles, and each coefficient is the exact value of one; the mesh is proved to
/// be star-shaped by exact signs.
///
/// ```
/// use stellate::fit::{MeshFitOptions, MeshFitSize, fit_mesh};
/// use stellate::limits::Limits;
/// use stellate::reading::{SolidFormat, read_solid};
/// // An octahedron with corners at the distance 1.
/// let text = "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n\
///     f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";
/// let solid = read_solid(text.as_bytes(), SolidFormat::Obj, "octahedron.obj")?;
/// let found = fit_mesh(&solid, &MeshFitOptions::new(MeshFitSize::Degree(4)), &Limits::none())?;
/// assert_eq!(found.surface.degree(), 4);
/// assert!(found.is_star_shaped && found.max_radial_error < 0.2);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// [`Error::Data`] for a mesh that crosses itself or is not star-shaped about any point, with a proof; [`Error::Usage`] for a center that does
/// not see the whole mesh; [`Error::Limit`] for a degree beyond [`MAX_FIT_DEGREE`] and for a tolerance that no degree reaches.
pub fn fit_mesh(solid: &Solid, options: &MeshFitOptions, limits: &Limits) -> Result<MeshFit> {
    let degree = match options.size {
        MeshFitSize::Degree(degree) => degree,
        MeshFitSize::Tolerance(_) => MAX_FIT_DEGREE,
    };
    if degree > MAX_FIT_DEGREE {
        return Err(Error::limit(format!(
            "a fit of a degree beyond {MAX_FIT_DEGREE}"
        )));
    }
    let is_least_squares = options.estimator == Estimator::LeastSquares;
    if is_least_squares && matches!(options.size, MeshFitSize::Tolerance(_)) {
        return Err(Error::Usage(
            "--tolerance finds the degree by quadrature; give least squares a --degree".into(),
        ));
    }
    let (center, is_moved) = center(solid, &options.center)?;
    let near = center.each_ref().map(Rational::to_f64);
    let mut rays = Rays::new(solid, near);
    let samples = Samples::new(&mut rays, degree, options.samples, limits)?;
    let found = match is_least_squares {
        true => least_squares(&rays, degree, limits)?,
        false => quadrature(&samples, degree, limits)?,
    };
    let errors = samples.errors(&rays, &found, degree, limits)?;
    let mut largest = |degree: usize| {
        let count = (degree + 1) * (degree + 1);
        samples.largest_near(&errors[degree], &mut rays, &found[..count], degree)
    };
    let (degree, largest) = match options.size {
        MeshFitSize::Degree(degree) => (degree, largest(degree)),
        MeshFitSize::Tolerance(tolerance) => {
            let mut least = f64::INFINITY;
            let reached = (0..=degree).find_map(|l| {
                let sampled = errors[l].largest;
                let error = if sampled <= tolerance {
                    largest(l)
                } else {
                    sampled
                };
                least = least.min(error);
                (error <= tolerance).then_some((l, error))
            });
            reached.ok_or_else(|| {
                Error::limit(format!(
                    "the radial error is ≈ {least:.3e} at best, with degrees up to {MAX_FIT_DEGREE}"
                ))
            })?
        }
    };
    let terms = coefficients::unnormalised(&found, degree)?;
    Ok(MeshFit {
        surface: HarmonicSurface::new(terms)?.with_center(center),
        max_radial_error: largest,
        rms_radial_error: errors[degree].mean_square.sqrt(),
        is_star_shaped: true,
        samples: match is_least_squares {
            true => solid.vertices().len(),
            false => samples.len(),
        },
        is_moved,
    })
}

/// A center that sees the whole mesh, and whether it replaces the centroid.
fn center(solid: &Solid, choice: &CenterChoice) -> Result<([Rational; 3], bool)> {
    let exact = |point: [f64; 3]| -> Result<[Rational; 3]> {
        let [Ok(x), Ok(y), Ok(z)] = point.map(Rational::try_from) else {
            return Err(Error::data(
                solid.place(),
                "its coordinates are beyond the range of doubles",
            ));
        };
        Ok([x, y, z])
    };
    match choice {
        CenterChoice::Point(_) => Err(Error::Usage(
            "--center: the center of a mesh is X,Y,Z, such as 0.5,1,-2".into(),
        )),
        CenterChoice::InSpace(point) => {
            check_seen(solid, point, "the center")?;
            Ok((point.clone(), false))
        }
        CenterChoice::Centroid => {
            let centroid = exact(solid.moments().1)?;
            check_seen(solid, &centroid, "the centroid")?;
            Ok((centroid, false))
        }
        CenterChoice::Auto => {
            let centroid = exact(solid.moments().1)?;
            if visible(solid, &centroid).is_star_shaped() {
                return Ok((centroid, false));
            }
            Ok((exact(deepest(solid)?)?, true))
        }
        CenterChoice::Kernel | CenterChoice::Best => Ok((exact(deepest(solid)?)?, false)),
    }
}

/// How often a mesh goes around a point.
#[cfg(feature = "meshes")]
pub(crate) fn turns_of_mesh(solid: &Solid, point: &[Rational; 3]) -> i64 {
    visible(solid, point).turns
}

fn check_seen(solid: &Solid, point: &[Rational; 3], what: &str) -> Result<()> {
    let seen = visible(solid, point);
    if seen.is_star_shaped() {
        return Ok(());
    }
    // A mesh that is star-shaped about no point is refused for that.
    deepest(solid)?;
    let [x, y, z] = point.each_ref().map(Rational::to_f64);
    Err(Error::Usage(format!(
        "{what} {x}, {y}, {z} does not see the whole mesh: {} of {} triangles are seen from outside or from their edge; --center kernel finds a point that does",
        seen.turned,
        solid.triangles().len()
    )))
}

/// The deepest point of the kernel.
fn deepest(solid: &Solid) -> Result<[f64; 3]> {
    let found = kernel(solid);
    if let Kernel::Point(point) = &found {
        let exact = point.map(Rational::try_from);
        if let [Ok(x), Ok(y), Ok(z)] = exact
            && visible(solid, &[x, y, z]).is_star_shaped()
        {
            return Ok(*point);
        }
    }
    if let Some([a, b]) = crossing::crossing(solid) {
        let message = format!("the mesh crosses itself: triangles {} and {}", a + 1, b + 1);
        return Err(Error::data(solid.place(), message));
    }
    let message = match found {
        Kernel::Empty(triangles) => {
            let [a, b, c, d] = triangles.iter().map(|k| k + 1).collect::<Vec<_>>()[..] else {
                return Err(Error::internal("the kernel of a mesh", "four planes prove it empty"));
            };
            format!(
                "the mesh is not star-shaped: no point is inside of the planes of its triangles {a}, {b}, {c} and {d}, which is proved; so no radius R(theta, phi) describes it"
            )
        }
        Kernel::Point(_) => "every triangle is seen from inside from one point, around which the mesh goes more than once: it is not star-shaped".into(),
        Kernel::Unknown => "no point was found from which the whole mesh is seen, and doubles do not prove that there is none".into(),
    };
    Err(Error::data(solid.place(), message))
}

#[cfg(test)]
pub(crate) mod laws;
