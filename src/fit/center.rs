//! The center of a fit: the point from which the radius is measured.

use super::best_center::best_center;
use super::kernel::kernel;
use super::least_squares::widest_gap;
use super::radius::{ContourRadius, outside, star_shaped_about};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::shape::{Contour, PointCloud};

/// In a picture, the radius about a center that sees the whole outline may jump by this many pixels: edges are staircases, and
/// compressed pictures have noise.
const NOISE_JUMP: f64 = 4.0;

/// The center that a fit should have.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum CenterChoice {
    /// The centroid of the area if it sees the whole outline; otherwise the best replacement (see [`CenterOrigin`]).
    #[default]
    Auto,
    /// The centroid of the area, which must be strictly inside the outline.
    Centroid,
    /// The middle of the kernel, which must not be empty: the centroid of the set of points that see the whole outline.
    Kernel,
    /// A point that sees as much of the outline as a search finds: the middle of the kernel if there is one.
    Best,
    /// This point, which must be strictly inside the outline.
    Point([Rational; 2]),
    /// This point, which is the center of a mesh in space.
    InSpace([Rational; 3]),
}

/// The origin of a center.
#[non_exhaustive]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CenterOrigin {
    /// The center is the centroid of the enclosed area.
    Centroid,
    /// The center was given.
    Given,
    /// The outline is not star-shaped about its centroid, but it is about this point: the centroid
    /// of the kernel (the set of points that see the whole outline).
    Kernel,
    /// The centroid lies outside the outline and no kernel was found: this is the middle of the longest
    /// inside piece of the horizontal line through the centroid.
    ChordMiddle,
    /// The middle of a cloud: the centroid of the polygon through its points in the order of their directions from their median.
    Cloud,
    /// A search found no point inside the outline from which less of it is hidden.
    Best,
}

impl CenterOrigin {
    /// A phrase for people, such as "the centroid".
    #[must_use]
    pub fn describe(self) -> &'static str {
        match self {
            Self::Centroid => "the centroid",
            Self::Given => "the given point",
            Self::Cloud => "the middle of the points",
            Self::Best => "the point that sees the most of it, as far as a search found",
            Self::Kernel => "the middle of the kernel (the points that see the whole outline)",
            Self::ChordMiddle => {
                "the middle of the longest inside chord at the centroid's height (the centroid lies \
                 outside the outline)"
            }
        }
    }
}

/// The error for a point in space as the center of an outline.
fn in_space() -> Error {
    Error::Usage("--center: the center of an outline in the plane is X,Y, such as 12.5,-3".into())
}

/// A chosen center, strictly inside the outline.
#[non_exhaustive]
#[derive(Clone, Debug, PartialEq)]
pub struct Center {
    /// The exact center: the exact value of a double, a multiple of 10^−D after rounding to D decimals, or the given point.
    pub exact: [Rational; 2],
    /// The doubles nearest to the exact center; radii are measured from this point.
    pub point: [f64; 2],
    /// The origin of the center.
    pub origin: CenterOrigin,
    /// Whether the outline is exactly star-shaped about `point`; `None` for a cloud.
    pub star_shaped: Option<bool>,
}

impl Center {
    /// Chooses the center of `contour` and, if `decimals` is given, rounds it to this many decimals.
    ///
    /// For [`CenterChoice::Auto`] these points are tried in turn: the centroid, if the outline is star-shaped about it, or if the
    /// outline was traced in a picture and its radius jumps by at most four pixels, which noise can do; the
    /// centroid of the kernel, if the outline is star-shaped about that (it is found in floating point and verified exactly, so
    /// a kernel thinner than rounding may be missed); the centroid again, if it is inside; and the middle of the longest inside
    /// piece of the horizontal line through the centroid.
    /// Cost: O(n) for n vertices, or O(n log n) if the kernel is computed.
    ///
    /// ```
    /// use stellate::fit::{Center, CenterChoice, CenterOrigin};
    /// use stellate::shape::Contour;
    ///
    /// let l_shape = vec![[0., 0.], [9., 0.], [9., 1.], [1., 1.], [1., 9.], [0., 9.]];
    /// let l_shape = Contour::new(l_shape, "L").unwrap();
    /// let center = Center::choose(&l_shape, &CenterChoice::Auto, None).unwrap();
    /// assert_eq!(center.origin, CenterOrigin::Kernel);
    /// assert_eq!(center.point, [0.5, 0.5]);
    /// assert_eq!(center.star_shaped, Some(true));
    /// ```
    ///
    /// # Errors
    /// [`Error::Usage`] if a given center, or the rounded one, is not strictly inside the outline.
    pub fn choose(contour: &Contour, choice: &CenterChoice, decimals: Option<u32>) -> Result<Self> {
        let (exact, origin) = match choice {
            CenterChoice::Point(point) => {
                let nearest = [point[0].to_f64(), point[1].to_f64()];
                if !contour.contains(nearest) {
                    return Err(outside(contour, nearest));
                }
                (point.clone(), CenterOrigin::Given)
            }
            CenterChoice::InSpace(_) => return Err(in_space()),
            CenterChoice::Auto => {
                let (point, origin) = automatic(contour)?;
                (exactly(point)?, origin)
            }
            CenterChoice::Centroid => {
                let point = contour.centroid();
                if !contour.contains(point) {
                    return Err(Error::Usage(format!(
                        "the centroid ({}, {}) is not inside the outline; --center auto takes a point that is",
                        point[0], point[1]
                    )));
                }
                (exactly(point)?, CenterOrigin::Centroid)
            }
            CenterChoice::Kernel => {
                let point = kernel_middle(contour).ok_or_else(|| {
                    Error::Usage(
                        "no point was found that sees the whole outline; --center best takes one that sees much of it".into(),
                    )
                })?;
                (exactly(point)?, CenterOrigin::Kernel)
            }
            CenterChoice::Best => match kernel_middle(contour) {
                Some(point) => (exactly(point)?, CenterOrigin::Kernel),
                None => {
                    let others: Vec<[f64; 2]> = automatic(contour)
                        .into_iter()
                        .map(|(point, _)| point)
                        .collect();
                    let point = best_center(contour, &others)?;
                    (exactly(point)?, CenterOrigin::Best)
                }
            },
        };
        let exact = match decimals {
            None => exact,
            Some(digits) => exact.map(|c| c.round_decimals(digits)),
        };
        let point = [exact[0].to_f64(), exact[1].to_f64()];
        if !contour.contains(point) {
            return Err(match decimals {
                Some(digits) => Error::Usage(format!(
                    "rounded to {digits} decimals the center is ({}, {}), which is not inside the \
                     outline; keep more decimals",
                    point[0], point[1]
                )),
                None => Error::internal("the choice of a center", "it is not inside the outline"),
            });
        }
        Ok(Self {
            star_shaped: Some(star_shaped_about(contour, point)),
            exact,
            point,
            origin,
        })
    }

    /// Chooses the center of a cloud and, if `decimals` is given, rounds it to this many decimals: the given point, or the middle
    /// of the points.
    ///
    /// # Errors
    /// [`Error::Usage`] for a choice that needs an outline, or if half of the directions from the middle have no point.
    pub(super) fn of_cloud(
        cloud: &PointCloud,
        choice: &CenterChoice,
        decimals: Option<u32>,
    ) -> Result<Self> {
        let (exact, origin) = match choice {
            CenterChoice::Point(point) => (point.clone(), CenterOrigin::Given),
            CenterChoice::InSpace(_) => return Err(in_space()),
            CenterChoice::Auto | CenterChoice::Centroid => {
                (exactly(middle(cloud)?)?, CenterOrigin::Cloud)
            }
            CenterChoice::Kernel | CenterChoice::Best => {
                return Err(Error::Usage(
                    "--center kernel and best are for outlines; the points of a cloud have no order".into(),
                ));
            }
        };
        let exact = match decimals {
            None => exact,
            Some(digits) => exact.map(|c| c.round_decimals(digits)),
        };
        Ok(Self {
            star_shaped: None,
            point: exact.each_ref().map(Rational::to_f64),
            exact,
            origin,
        })
    }
}

/// The centroid of the polygon through the points of a cloud in the order of their directions from their median.
fn middle(cloud: &PointCloud) -> Result<[f64; 2]> {
    let counts = |i: usize| cloud.weights().get(i).is_none_or(|&w| w > 0.0);
    let points = cloud
        .points()
        .iter()
        .enumerate()
        .filter(|(i, _)| counts(*i));
    let points: Vec<[f64; 2]> = points.map(|(_, p)| *p).collect();
    let median: [f64; 2] = std::array::from_fn(|k| {
        let mut values: Vec<f64> = points.iter().map(|p| p[k]).collect();
        let half = values.len() / 2;
        *values.select_nth_unstable_by(half, f64::total_cmp).1
    });
    let relative = |p: &[f64; 2]| [p[0] - median[0], p[1] - median[1]];
    // Products of coordinates in this unit do not overflow.
    let sizes = points.iter().flat_map(relative).map(f64::abs);
    let unit = sizes.fold(0.0, f64::max);
    let around = points.iter().map(|p| relative(p).map(|c| c / unit));
    let mut around: Vec<(f64, [f64; 2])> = around.map(|[x, y]| (y.atan2(x), [x, y])).collect();
    around.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let next = around.iter().cycle().skip(1);
    let (mut area, mut moments) = (0.0, [0.0; 2]);
    for ((_, p), (_, q)) in around.iter().zip(next) {
        let twice = p[0] * q[1] - p[1] * q[0];
        area += twice / 2.0;
        for k in 0..2 {
            moments[k] += twice * (p[k] + q[k]) / 6.0;
        }
    }
    let middle: [f64; 2] = std::array::from_fn(|k| median[k] + unit * moments[k] / area);
    let angles = points
        .iter()
        .map(|p| (p[1] - middle[1]).atan2(p[0] - middle[0]));
    let (from, to) = widest_gap(&angles.collect::<Vec<_>>());
    if middle.iter().any(|c| !c.is_finite()) || to - from >= std::f64::consts::PI {
        return Err(Error::Usage(
            "no middle of the points was found from which they lie all around; give a center with --center X,Y".into(),
        ));
    }
    Ok(middle)
}

fn automatic(contour: &Contour) -> Result<([f64; 2], CenterOrigin)> {
    let centroid = contour.centroid();
    if star_shaped_about(contour, centroid) {
        return Ok((centroid, CenterOrigin::Centroid));
    }
    if contour.resolution() > 0.0 && contour.contains(centroid) {
        let (jump, _) = ContourRadius::new(contour, centroid)?.largest_jump();
        if jump <= NOISE_JUMP * contour.resolution() {
            return Ok((centroid, CenterOrigin::Centroid));
        }
    }
    if let Some(point) = kernel_middle(contour) {
        return Ok((point, CenterOrigin::Kernel));
    }
    if contour.contains(centroid) {
        return Ok((centroid, CenterOrigin::Centroid));
    }
    chord_middle(contour, centroid[1])
        .filter(|&point| contour.contains(point))
        .map(|point| (point, CenterOrigin::ChordMiddle))
        .ok_or_else(|| {
            Error::Usage(
                "the centroid lies outside the outline and no interior point was found beside it; \
                 give one with --center X,Y"
                    .into(),
            )
        })
}

/// The centroid of the kernel, if the outline is star-shaped about it.
fn kernel_middle(contour: &Contour) -> Option<[f64; 2]> {
    let region = kernel(contour)?;
    Some(region.centroid()).filter(|&point| star_shaped_about(contour, point))
}

/// The middle of the longest piece of the line y = `height` inside the outline.
fn chord_middle(contour: &Contour, height: f64) -> Option<[f64; 2]> {
    let mut crossings: Vec<f64> = contour
        .edges()
        .filter(|(p, q)| (p[1] <= height) != (q[1] <= height))
        .map(|(p, q)| {
            let t = (height - p[1]) / (q[1] - p[1]);
            p[0] + t * (q[0] - p[0])
        })
        .collect();
    crossings.sort_unstable_by(f64::total_cmp);
    crossings
        .chunks_exact(2)
        .max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])))
        .map(|chord| [f64::midpoint(chord[0], chord[1]), height])
}

/// The exact values of two doubles.
fn exactly(point: [f64; 2]) -> Result<[Rational; 2]> {
    let exact = |c: f64| {
        Rational::try_from(c).map_err(|_| Error::Usage(format!("the center's coordinate is {c}")))
    };
    Ok([exact(point[0])?, exact(point[1])?])
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "these centers are exact")]
mod tests {
    use super::*;

    fn contour(points: &[[f64; 2]]) -> Contour {
        Contour::new(points.to_vec(), "outline").unwrap()
    }

    fn given(x: &str, y: &str) -> CenterChoice {
        CenterChoice::Point([x.parse().unwrap(), y.parse().unwrap()])
    }

    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    /// A U of width 10 with walls of different thickness. Its centroid is in the hollow, and its kernel is empty.
    const U: [[f64; 2]; 8] = [
        [0., 0.],
        [10., 0.],
        [10., 9.],
        [8., 9.],
        [8., 1.],
        [1., 1.],
        [1., 9.],
        [0., 9.],
    ];

    #[test]
    fn star_shaped_is_strict() {
        let square = contour(&SQUARE);
        assert!(star_shaped_about(&square, [1.0, 1.0]));
        for outside in [[0.0, 1.0], [2.0, 2.0], [3.0, 1.0], [f64::NAN, 1.0]] {
            assert!(!star_shaped_about(&square, outside));
        }
        // An L has its corner square as its kernel; the border of the kernel is in line with edges.
        let l = contour(&[[0., 0.], [3., 0.], [3., 1.], [1., 1.], [1., 3.], [0., 3.]]);
        assert!(star_shaped_about(&l, [0.5, 0.5]));
        assert!(star_shaped_about(&l, [1f64.next_down(), 0.5]));
        assert!(!star_shaped_about(&l, [1.0, 0.5]));
    }

    #[test]
    fn a_centroid_that_sees_everything_is_taken() {
        let center = Center::choose(&contour(&SQUARE), &CenterChoice::Auto, None).unwrap();
        assert_eq!(center.origin, CenterOrigin::Centroid);
        assert_eq!(center.exact, [Rational::one(), Rational::one()]);
        assert_eq!(center.star_shaped, Some(true));
    }

    #[test]
    fn a_centroid_outside_gives_way_to_the_thickest_chord() {
        let center = Center::choose(&contour(&U), &CenterChoice::Auto, None).unwrap();
        assert_eq!(center.origin, CenterOrigin::ChordMiddle);
        assert_eq!(center.point[0], 9.0);
        assert_eq!(center.star_shaped, Some(false));
    }

    #[test]
    fn a_given_center_must_be_inside() {
        let square = contour(&SQUARE);
        let center = Center::choose(&square, &given("1/3", "0.1"), None).unwrap();
        assert_eq!(center.exact[0].to_string(), "1/3");
        assert_eq!(center.star_shaped, Some(true));
        for (x, y) in [
            ("5", "5"),
            ("0", "1"),
            ("2", "2"),
            ("1e3000", "0"),
            ("1e-200", "1"),
        ] {
            let error = Center::choose(&square, &given(x, y), None).unwrap_err();
            assert!(error.to_string().contains("is not inside the outline"));
        }
    }

    #[test]
    fn a_choice_that_the_outline_does_not_have_is_refused() {
        let refused = |points: &[[f64; 2]], choice: CenterChoice| {
            Center::choose(&contour(points), &choice, None)
                .unwrap_err()
                .to_string()
        };
        assert!(refused(&U, CenterChoice::Centroid).contains("--center auto takes"));
        assert!(refused(&U, CenterChoice::Kernel).contains("--center best takes"));
    }

    /// Of the U, no point sees everything; the best one hides less than the one that is chosen otherwise.
    #[test]
    fn the_best_center_hides_the_least() {
        let hidden = |choice: CenterChoice| {
            let contour = contour(&U);
            let center = Center::choose(&contour, &choice, None).unwrap();
            let radius = ContourRadius::new(&contour, center.point).unwrap();
            (radius.hidden_share(), center.origin)
        };
        let (best, origin) = hidden(CenterChoice::Best);
        assert_eq!(origin, CenterOrigin::Best);
        let (auto, _) = hidden(CenterChoice::Auto);
        assert!(best < auto - 0.05, "{best} {auto}");
        // A square has a kernel, which is all of it.
        let center = Center::choose(&contour(&SQUARE), &CenterChoice::Best, None).unwrap();
        assert_eq!(
            (center.origin, center.point),
            (CenterOrigin::Kernel, [1.0, 1.0])
        );
    }

    #[test]
    fn rounding_comes_before_everything_else() {
        let square = contour(&SQUARE);
        let center = Center::choose(&square, &given("1/3", "2/3"), Some(2)).unwrap();
        assert_eq!(center.exact.map(|c| c.to_string()), ["33/100", "67/100"]);
        let error = Center::choose(&square, &given("1/3", "2/3"), Some(0)).unwrap_err();
        assert_eq!(
            error.to_string(),
            "rounded to 0 decimals the center is (0, 1), which is not inside the outline; keep more \
             decimals"
        );
    }
}
