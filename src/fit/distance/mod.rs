//! How far a fitted curve is from the outline: certified bounds of the Hausdorff distance, and approximate measures.
//!
//! The curve is replaced by a polygon from which it differs by a proved amount ([`traced`]). The distance of two polygons is
//! enclosed by branch and bound over their edges ([`hausdorff`]); a tree of boxes finds nearest edges ([`polygon`]). A search for
//! the fewest harmonics ([`search`]) measures few of the curves.

mod fourier_transform;
mod hausdorff;
mod near;
mod overlap;
mod polygon;
mod search;
mod traced;

use crate::error::Result;
use crate::exact::Rational;
use crate::limits::Limits;
use crate::shape::{Contour, EllipticSeries, FourierRadius};
pub(crate) use near::NearPolygon;
pub(super) use polygon::Frame;
use polygon::Polygon;
pub(super) use search::{DistanceSearch, Step, before};
use traced::Tracer;

/// The bounds of the distance are this close together, relative to the lower one, …
const RELATIVE: f64 = 0.005;
/// … or this close, relative to half the longer side of the outline's box.
const ABSOLUTE: f64 = 5e-7;

/// How far a closed curve is from an outline.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Distances {
    /// Certified bounds of the Hausdorff distance: the largest distance of a point of either one from the other.
    pub hausdorff: HausdorffBounds,
    /// The mean distance of the points of the outline from the curve, by arc length; approximate.
    pub mean: f64,
    /// The area of the intersection over that of the union of what the outline and the curve enclose; approximate. Of a curve
    /// that crosses itself, a point is enclosed if a ray from it crosses the curve an odd number of times.
    pub overlap: f64,
}

/// Certified bounds of a Hausdorff distance.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct HausdorffBounds {
    /// The lower bound.
    pub low: f64,
    /// The upper bound.
    pub high: f64,
}

/// How far a closed curve is from an outline; `None` if the curve has so many harmonics that a polygon near it has more than
/// 2^22 vertices.
///
/// The bounds of the Hausdorff distance are at most 1 % apart, or 10^(−6) of half the longer side of the outline's box. They are
/// proved: for the exact coordinates of the outline and the exact coefficients of the curve, provided that the arithmetic of
/// doubles is that of IEEE 754.
///
/// Cost: for M vertices of a polygon near the curve, at least 8 for each harmonic, more with the square root of the wanted
/// precision, a fast Fourier transform of length M, and O(log M) operations for each vertex of both polygons.
///
/// ```
/// use stellate::exact::Rational;
/// use stellate::fit::distances;
/// use stellate::limits::Limits;
/// use stellate::shape::{Contour, EllipticSeries};
///
/// let square = vec![[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
/// let square = Contour::new(square, "square")?;
/// let q = |v: [i64; 2]| v.map(Rational::from).to_vec();
/// let circle = EllipticSeries::new([q([0, 1]), q([0, 0]), q([0, 0]), q([0, 1])]);
/// let found = distances(&square, &circle, &Limits::none())?.unwrap();
/// // A corner is √2 from the middle.
/// let exact = 2f64.sqrt() - 1.0;
/// assert!(found.hausdorff.low <= exact && exact <= found.hausdorff.high);
/// assert!((found.overlap - std::f64::consts::PI / 4.0).abs() < 1e-3);
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of `limits`.
pub fn distances(
    contour: &Contour,
    curve: &EllipticSeries,
    limits: &Limits,
) -> Result<Option<Distances>> {
    let mut outline = Outline::new(contour);
    let Some((bounds, polygon)) = outline.enclose(curve, f64::INFINITY, limits)? else {
        return Ok(None);
    };
    Ok(Some(Distances {
        hausdorff: outline.in_its_units(bounds),
        mean: hausdorff::mean(&outline.polygon, &polygon) * outline.frame.scale(),
        overlap: overlap::overlap(&outline.polygon, &polygon),
    }))
}

/// Whether r(θ) > 0 for every angle, decided by certified values of the series; `None` if they do not decide it within the stated
/// cost of [`distances`].
///
/// The radius is traced as the curve x(t) = r(t): between two vertices it is as near their mean as the curve is to its polygon.
pub(crate) fn is_positive_by_values(
    radius: &FourierRadius,
    limits: &Limits,
) -> Result<Option<bool>> {
    /// The numbers of vertices that are tried, each 16 times the one before.
    const TRIALS: u32 = 3;
    let lists = [radius.cosines(), radius.sines()].map(<[Rational]>::to_vec);
    let size: f64 = lists.iter().flatten().map(|c| c.to_f64().abs()).sum();
    if !size.is_normal() {
        return Ok(None);
    }
    let [cos, sin] = lists;
    let series = EllipticSeries::new([cos, sin, Vec::new(), Vec::new()]);
    let tracer = Tracer::new(&series, &Frame::about_origin(size));
    for trial in 0..TRIALS {
        let Some(traced) = tracer.polygon(tracer.first_count() << (4 * trial), limits)? else {
            return Ok(None);
        };
        let least = traced
            .points
            .iter()
            .map(|p| p[0])
            .fold(f64::INFINITY, f64::min);
        if least.abs() > traced.error {
            return Ok(Some(least > 0.0));
        }
    }
    Ok(None)
}

/// An outline to which the distances of many curves are measured.
#[derive(Debug)]
struct Outline {
    frame: Frame,
    polygon: Polygon,
    /// Vertices that were far from earlier curves.
    far: Vec<[f64; 2]>,
}

impl Outline {
    fn new(contour: &Contour) -> Self {
        let frame = Frame::of(contour);
        let points = contour.points().iter().map(|&p| frame.inside(p)).collect();
        Self {
            polygon: Polygon::new(points),
            frame,
            far: Vec::new(),
        }
    }

    fn in_its_units(&self, bounds: HausdorffBounds) -> HausdorffBounds {
        HausdorffBounds {
            low: bounds.low * self.frame.scale(),
            high: bounds.high * self.frame.scale(),
        }
    }

    /// Bounds of the Hausdorff distance in units of the frame, and the polygon from which they were computed. If the distance is
    /// certainly larger than `enough`, the bounds may be far apart.
    fn enclose(
        &mut self,
        curve: &EllipticSeries,
        enough: f64,
        limits: &Limits,
    ) -> Result<Option<(HausdorffBounds, Polygon)>> {
        let tracer = Tracer::new(curve, &self.frame);
        let mut count = tracer.first_count();
        loop {
            limits.check()?;
            let Some(traced) = tracer.polygon(count, limits)? else {
                return Ok(None);
            };
            let error = traced.error + polygon::ROUNDING * f64::max(1.0, tracer.size());
            let polygon = Polygon::new(traced.points);
            let distances = self.far.iter().map(|&p| polygon.nearest(p, 0).distance);
            let known = distances.fold(0.0, f64::max) - error;
            if known > enough {
                let bounds = HausdorffBounds {
                    low: known,
                    high: f64::INFINITY,
                };
                return Ok(Some((bounds, polygon)));
            }
            let found = hausdorff::enclose([&self.polygon, &polygon], limits)?;
            let bounds = HausdorffBounds {
                low: (found.low - error).max(0.0),
                high: found.high + error,
            };
            // The error widens the bounds on both sides.
            let allowed = f64::max(RELATIVE * bounds.low, ABSOLUTE) / 2.0;
            if error <= allowed || bounds.low > enough {
                self.far.extend(found.far);
                return Ok(Some((bounds, polygon)));
            }
            count = tracer.enough_count(count, traced.error, allowed);
        }
    }
}
