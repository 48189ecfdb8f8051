//! The box in which a surface is meshed if nobody gives one, and what it is known to hold.

use super::critical::{Pieces, bounded_pieces};
use super::extent::{BoxSides, Extent, extent, joined};
use super::frame::Frame;
use crate::error::Result;
use crate::factor::factor_space;
use crate::limits::Limits;
use crate::parallel;
use crate::sample::{Ray, RaySolver, SpaceDirection};
use crate::shape::ImplicitSurface;

/// The number of directions from the origin in which points of a surface are found.
const DIRECTIONS: usize = 400;
/// If the largest radius is more than this times the median, the surface continues beyond the box.
const LARGEST_OVER_MEDIAN: f64 = 4.0;
/// The margin of a box, in parts of its longest side.
const MARGIN: f64 = 0.08;
/// The least box of an unbounded surface of which no point was found.
const NOTHING_SEEN: BoxSides = [[-1.5, 1.5]; 3];
/// Half the side of the box around a single point.
const AROUND_A_POINT: f64 = 1.0;
/// How often the proof is repeated in other coordinates.
const FRAMES: usize = 5;

/// What is known about the parts of a surface outside of a box.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Held {
    /// It is proved that there are none.
    Whole,
    /// It is proved that no bounded piece of the surface lies there.
    BoundedPieces,
    /// Neither of these is proved.
    Unproved,
    /// The box was given, and nothing was looked for outside of it.
    #[default]
    NotAsked,
}

impl Held {
    /// What is known of two surfaces together.
    pub(super) fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Whole, Self::Whole) => Self::Whole,
            (Self::Whole | Self::BoundedPieces, Self::Whole | Self::BoundedPieces) => {
                Self::BoundedPieces
            }
            _ => Self::Unproved,
        }
    }
}

/// A box around a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SurfaceBox {
    /// The sides of the box.
    pub bounds: BoxSides,
    /// Whether the surface is known or seems to be bounded: this is proved, or no point that was found is far away from the others.
    pub seems_bounded: bool,
    /// What is proved.
    pub held: Held,
    /// The part of the box in which all bounded pieces are, without those of factors of which nothing is proved.
    pub pieces: Option<BoxSides>,
}

/// A box with a margin around a surface: around its certified points in many directions from the origin, except for points that
/// are much farther away than most, and around everything that is proved to be a place of it. `None` if it is proved that there are no points.
///
/// For every factor over Q, a bounded surface is enclosed if its leading form, for suitable weights of the variables, has no zero;
/// else the bounded pieces of the surface are enclosed by the critical values of the coordinates, if these are finitely many and
/// can be found by little work. For a bounded surface that is thin, far from the origin, or very small, the proof is repeated in
/// coordinates in which it is none of these; the margin of each side is then in proportion to the side.
///
/// # Errors
/// Those of `limits` and of [`factor_space`].
pub fn mesh_bounds(surface: &ImplicitSurface, limits: &Limits) -> Result<Option<SurfaceBox>> {
    let surface = &*surface.in_original_coordinates(limits)?;
    let first = bounds_in_place(surface, limits)?;
    let mut last = first;
    let mut frame: Option<Frame> = None;
    for _ in 0..FRAMES {
        let Some(core) = last.core.filter(|_| last.is_whole()) else {
            break;
        };
        let core = frame.map_or(core, |frame| frame.box_outward(&core));
        let Some(next) = Frame::of(&core) else {
            break;
        };
        if frame.is_some_and(|frame| next.is_like(&frame)) {
            break;
        }
        let local = ImplicitSurface::new(next.polynomial(surface.polynomial(), limits)?);
        let found = bounds_in_place(&local, limits)?;
        if found.surface_box.is_none() {
            return Ok(None);
        }
        if !found.is_whole() {
            break;
        }
        (last, frame) = (found, Some(next));
    }
    let Some((frame, found)) = frame.zip(last.surface_box).filter(|_| !last.is_tiny) else {
        return Ok(first.surface_box);
    };
    Ok(Some(SurfaceBox {
        bounds: frame.box_outward(&found.bounds),
        pieces: found.pieces.map(|sides| frame.box_outward(&sides)),
        ..found
    }))
}

/// What is found of the place of a surface without a change of coordinates.
#[derive(Clone, Copy)]
struct InPlace {
    surface_box: Option<SurfaceBox>,
    /// The box around what is proved, without margins.
    core: Option<BoxSides>,
    /// Whether that is hardly more than a point.
    is_tiny: bool,
}

impl InPlace {
    fn is_whole(&self) -> bool {
        self.surface_box
            .is_some_and(|found| found.held == Held::Whole)
    }
}

/// The box of a surface in its own coordinates.
fn bounds_in_place(surface: &ImplicitSurface, limits: &Limits) -> Result<InPlace> {
    let seen = seen_from_origin(surface, limits)?;
    let sizes = seen.map(|(bounds, _)| bounds.map(|[a, b]| a.abs().max(b.abs())));
    let (mut proved, mut core, mut is_tiny, mut held) = (None, None, true, Held::Whole);
    for factor in factor_space(surface.polynomial(), limits)?.factors {
        let f = &factor.polynomial;
        let found = extent(f, sizes, limits)?;
        is_tiny &= matches!(found, Extent::Tiny(_) | Extent::Empty);
        if let Extent::Within(place) | Extent::Tiny(place) = found {
            core = [core, Some(place)].into_iter().flatten().reduce(joined);
        }
        let (place, here) = match found {
            Extent::Empty => (None, Held::Whole),
            Extent::Within(place) => (Some(place), Held::Whole),
            Extent::Tiny(place) => {
                let grown = place.map(|[a, b]| [a - AROUND_A_POINT, b + AROUND_A_POINT]);
                (Some(grown), Held::Whole)
            }
            Extent::Unknown => match bounded_pieces(f, limits)? {
                None => (None, Held::Unproved),
                Some(Pieces::Nowhere) => (None, Held::BoundedPieces),
                Some(Pieces::Within(place)) => (Some(place), Held::BoundedPieces),
            },
        };
        proved = [proved, place].into_iter().flatten().reduce(joined);
        held = held.and(here);
    }
    let (seen, all_near) = seen.map_or((None, false), |(bounds, all)| (Some(bounds), all));
    let seen = seen.map(with_margin);
    let bounds = match (seen, proved.map(with_margin)) {
        (Some(seen), Some(_)) if proved.is_some_and(|place| is_within(place, seen)) => Some(seen),
        (_, Some(place)) if held == Held::Whole => Some(place),
        (Some(seen), Some(place)) => Some(joined(seen, place)),
        // Of a cone, rays from its apex see nothing.
        (None, Some(place)) => Some(joined(place, NOTHING_SEEN)),
        (None, None) if held != Held::Whole => Some(NOTHING_SEEN),
        (seen, None) => seen,
    };
    let found = bounds.map(|bounds| SurfaceBox {
        bounds,
        seems_bounded: held == Held::Whole || all_near,
        held,
        pieces: proved,
    });
    Ok(InPlace {
        surface_box: found,
        core,
        is_tiny,
    })
}

fn is_within(inner: BoxSides, outer: BoxSides) -> bool {
    let mut sides = inner.iter().zip(outer);
    sides.all(|([a, b], [low, high])| *a >= low && *b <= high)
}

fn with_margin(bounds: BoxSides) -> BoxSides {
    let longest = bounds.iter().fold(0.0, |l: f64, [a, b]| l.max(b - a));
    // A point, or a surface in a plane through the origin, also gets a box.
    let margin = if longest > 0.0 { MARGIN * longest } else { 1.0 };
    bounds.map(|[a, b]| [a - margin, b + margin])
}

/// The box around the certified points of a surface in many directions from the origin, except for points that are much farther
/// away than most, and whether no point was left out.
fn seen_from_origin(
    surface: &ImplicitSurface,
    limits: &Limits,
) -> Result<Option<(BoxSides, bool)>> {
    let solver = RaySolver::new(surface.by_degree());
    let points = |direction: &SpaceDirection| match solver.solve(direction) {
        Ray::Points(points) => points,
        Ray::Line => Vec::new(),
    };
    let directions = SpaceDirection::fibonacci(DIRECTIONS);
    let mut samples = parallel::try_map(&directions, limits, |d| Ok(points(d)))?.concat();
    samples.sort_unstable_by(|a, b| a.r.abs().total_cmp(&b.r.abs()));
    let Some(median) = samples.get(samples.len() / 2).map(|s| s.r.abs()) else {
        return Ok(None);
    };
    let near: Vec<[f64; 3]> = samples
        .iter()
        .filter(|s| s.r.abs() <= LARGEST_OVER_MEDIAN * median)
        .map(|s| s.position)
        .collect();
    let all = near.len() == samples.len();
    let bounds = [0, 1, 2].map(|i: usize| {
        let values = near.iter().map(|p| p[i]);
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| {
            [a.min(v), b.max(v)]
        })
    });
    Ok(Some((bounds, all)))
}
