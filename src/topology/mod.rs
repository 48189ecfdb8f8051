//! What a real plane curve is, entirely: its components and which contains which, their exact extents, its singular points, its
//! asymptotes and its genus.
//!
//! **Method.** The curve is swept by the lines t = const in coordinates in which no line is vertical and no branch tends to infinity
//! over a finite t (`sweep`). Above each critical value the real points are isolated: bounds of all complex roots are narrowed until
//! they have as many components as there are distinct roots, which subresultants tell (`clusters`). Lines between the points,
//! which the curve does not meet near the critical value, then tell which arcs end at which point (`fibre`). The graph of points
//! and arcs is isotopic to the curve, so nothing is missing (`components`). The local structure of singular points and the genus come
//! from Newton polygons modulo a prime of good reduction (`places`, `resolution`, `genus`).
//!
//! Cost: a discriminant of degree n(n − 1), and the isolation of n roots for each of its real zeros.

mod absolute;
mod asymptote;
mod clusters;
mod components;
mod coordinate;
mod extent;
mod fibre;
mod fixed_point;
mod genus;
mod guess;
#[cfg(test)]
mod laws;
mod locate;
mod origin;
mod places;
mod resolution;
mod series;
mod singular;
mod strip;
mod sweep;

pub use asymptote::{Asymptote, AtInfinity};
pub use components::ComponentKind;
pub use coordinate::Coordinate;
pub use genus::Genus;
pub use singular::{SingularKind, Singularity};
pub(crate) use strip::{Strip, range};

use components::Components;
use extent::{Axis, CriticalValues, Extent, extents};
use locate::{some_points, value_at, value_on_arc};
use resolution::Resolution;
use sweep::{Sheared, Sweep};

use crate::error::{Error, Invariant, Result};
use crate::factor::squarefree_plane;
use crate::limits::Limits;
use crate::poly::PlanePolynomial;
use crate::roots::real_roots;

/// The shears that are tried: x = t + shear·y.
const SHEARS: [i64; 11] = [0, 1, -1, 2, -2, 3, -3, 5, -7, 11, -13];

/// A connected component of a real plane curve.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Component {
    /// Whether it is bounded, unbounded or a point.
    pub kind: ComponentKind,
    /// The indices of the components directly inside.
    pub contains: Vec<usize>,
    /// The smallest and the largest x, then y; `None` where it is unbounded.
    pub extent: [[Option<Coordinate>; 2]; 2],
    /// The indices of its singular points.
    pub singular_points: Vec<usize>,
    /// About some points of the component, among them its singular points, and at least one of each piece between critical points
    /// in the direction of the sweep.
    pub some_points: Vec<[f64; 2]>,
}

/// A real singular point of a plane curve.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct SingularPoint {
    /// The coordinates x and y.
    pub at: [Coordinate; 2],
    /// The invariants of the point.
    pub singularity: Singularity,
    /// The index of the component on which it lies.
    pub component: usize,
}

/// The topology of a real plane curve.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Topology {
    /// The connected components.
    pub components: Vec<Component>,
    /// The real singular points.
    pub singular_points: Vec<SingularPoint>,
    /// The asymptotes.
    pub at_infinity: AtInfinity,
}

impl Topology {
    /// The topology of the curve f = 0 in the real plane. Repeated factors do not matter.
    ///
    /// ```
    /// use stellate::limits::Limits;
    /// use stellate::poly::PlanePolynomial;
    /// use stellate::topology::{ComponentKind, Topology};
    /// // y² = x² (x − 1): a curve, and the isolated point (0, 0)
    /// let f = [((3, 0), 1.into()), ((2, 0), (-1).into()), ((0, 2), (-1).into())];
    /// let topology = Topology::of(&PlanePolynomial::from_terms(f), &Limits::none())?;
    /// let kinds: Vec<ComponentKind> = topology.components.iter().map(|c| c.kind).collect();
    /// assert_eq!(kinds, [ComponentKind::Unbounded, ComponentKind::Point]);
    /// assert_eq!(topology.singular_points[0].singularity.kind().name(), "isolated");
    /// # Ok::<(), stellate::error::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Usage`] for the polynomial 0, whose zero set is no curve; those of the limits: a discriminant takes too much work.
    pub fn of(f: &PlanePolynomial, limits: &Limits) -> Result<Self> {
        let Some(degree) = f.degree() else {
            return Err(Error::Usage("the polynomial 0 has no curve".into()));
        };
        if degree == 0 {
            return Ok(Self {
                components: Vec::new(),
                singular_points: Vec::new(),
                at_infinity: AtInfinity::default(),
            });
        }
        let f = squarefree_plane(f, limits)?.into_primitive();
        for shear in SHEARS {
            let Some(curve) = Sheared::new(&f, shear, limits)? else {
                continue;
            };
            let resolution = Resolution::new(&curve, limits)?;
            if resolution.tells_points_apart() {
                return Self::swept(&f, curve, &resolution, limits);
            }
        }
        Err(Error::limit(
            "no projection was found that tells the singular points of the curve apart".to_owned(),
        ))
    }

    fn swept(
        f: &PlanePolynomial,
        curve: Sheared,
        resolution: &Resolution,
        limits: &Limits,
    ) -> Result<Self> {
        let mut sweep = Sweep::new(curve, limits)?;
        let graph = Components::new(&sweep);
        let in_x = match sweep.curve.shear {
            0 => CriticalValues::from(&sweep),
            _ => CriticalValues::new(f, Axis::X, limits)?,
        };
        let axes = [in_x, CriticalValues::new(f, Axis::Y, limits)?];
        let [in_x, in_y] = [
            extents(&sweep, &graph, f, &axes[0], limits)?,
            extents(&sweep, &graph, f, &axes[1], limits)?,
        ];
        let mut components = Vec::with_capacity(graph.list.len());
        for (index, pieces) in graph.list.iter().enumerate() {
            let mut extent = [in_x[index].clone(), in_y[index].clone()];
            for (axis, range) in axes.iter().zip(&mut extent) {
                if range.is_none() {
                    // The component is a point, or a line on which the coordinate is constant.
                    let value = match pieces.points.first() {
                        Some(&place) => value_at(&mut sweep, place, axis, limits)?,
                        None => value_on_arc(&sweep, pieces.arcs[0], axis)?,
                    };
                    *range = Some([Some(value.clone()), Some(value)]);
                }
            }
            let extent = extent.map(|range: Option<Extent>| {
                let range = range.invariant("it was just set");
                range.map(|end| end.map(Coordinate::from))
            });
            components.push(Component {
                kind: pieces.kind,
                contains: graph.contains[index].clone(),
                extent,
                singular_points: Vec::new(),
                some_points: some_points(&sweep, pieces),
            });
        }
        let mut singular_points = Vec::new();
        for (component, pieces) in graph.list.iter().enumerate() {
            for &(fibre, place) in &pieces.points {
                let point = &sweep.fibres[fibre].points[place];
                let types = resolution.above(&sweep.fibres[fibre].value);
                let types = types.invariant("this was checked before the sweep");
                let Some(local) = types
                    .iter()
                    .find(|t| t.fibre_multiplicity == point.multiplicity && t.milnor() > 0)
                else {
                    continue;
                };
                let singularity = Singularity::new(local, point.arcs[0] + point.arcs[1]);
                let at = [
                    value_at(&mut sweep, (fibre, place), &axes[0], limits)?,
                    value_at(&mut sweep, (fibre, place), &axes[1], limits)?,
                ];
                components[component]
                    .singular_points
                    .push(singular_points.len());
                singular_points.push(SingularPoint {
                    at: at.map(Coordinate::from),
                    singularity,
                    component,
                });
            }
        }
        // A curve without unbounded components has none, whatever points at infinity its equation has.
        let mut ends = components.iter().flat_map(|c| c.extent.iter().flatten());
        let at_infinity = match ends.any(Option::is_none) {
            true => asymptote::at_infinity(f, &axes),
            false => AtInfinity::default(),
        };
        Ok(Self {
            components,
            singular_points,
            at_infinity,
        })
    }
}

impl Resolution {
    /// Whether the multiplicities in the fibres tell which local type belongs to which point.
    fn tells_points_apart(&self) -> bool {
        self.conjugates.iter().all(|conjugates| {
            if real_roots(&conjugates.polynomial).is_empty() {
                return true;
            }
            let Some(types) = &conjugates.types else {
                return false;
            };
            types.iter().all(|a| {
                types
                    .iter()
                    .all(|b| a.fibre_multiplicity != b.fibre_multiplicity || a == b)
            })
        })
    }
}
