//! The cells of a patch in a picture.

use super::Patch;
use super::patch_grid::{Node, point};
use super::polyline::box_around;
use crate::error::Invariant;

/// The least number of cells along each parameter of a picture.
const CELLS: u32 = 54;

/// For each degree of the coordinates in an angle so many cells are drawn, unless there are too many: an oscillation has 16.
const CELLS_PER_DEGREE: u32 = 8;

/// A picture has no more cells than this because of oscillations.
const MOST_CELLS: u32 = 20_000;

/// The cells of a grid as quadrilaterals, and a box that shows them: all of them, or most of them where coordinates have poles.
pub(crate) struct PatchFacets {
    pub facets: Vec<Vec<[f64; 3]>>,
    pub extent: Option<[[f64; 2]; 3]>,
}

impl Patch {
    /// The cells of a grid, `cells` of them along each parameter, or as many as its oscillations need. Cells with a corner at a pole
    /// are left out, and those in which a denominator changes its sign.
    pub(crate) fn facets(&self, ranges: [Option<[f64; 2]>; 2], cells: Option<u32>) -> PatchFacets {
        let counts = cells.map_or_else(|| self.cells_for_oscillations(), |count| [count; 2]);
        let nodes = self.nodes(ranges, counts);
        let mut facets = Vec::new();
        let mut has_poles = [false; 3];
        for pair in nodes.windows(2) {
            for (left, right) in pair[0].windows(2).zip(pair[1].windows(2)) {
                let corners = [&left[0], &right[0], &right[1], &left[1]];
                for (k, has_pole) in has_poles.iter_mut().enumerate() {
                    let is_cut = |node: &Node| !node[k].value.is_finite();
                    let sign = left[0][k].is_above;
                    *has_pole |= corners.iter().any(|n| is_cut(n) || n[k].is_above != sign);
                }
                let signs = |node: &Node| node.map(|v| v.is_above);
                if corners.iter().all(|node| signs(node) == signs(&left[0])) {
                    let points = corners.into_iter().map(point);
                    facets.extend(points.collect::<Option<Vec<_>>>());
                }
            }
        }
        let points: Vec<_> = nodes.iter().flatten().filter_map(point).collect();
        PatchFacets {
            facets,
            extent: box_around(&points, has_poles),
        }
    }

    fn cells_for_oscillations(&self) -> [u32; 2] {
        let wanted = [0, 1].map(|v| {
            let degrees = self.coordinates().iter().map(|f| f.degree_in(v));
            let degree = degrees.max().invariant("a patch has coordinates");
            match self.parameters()[v].is_angle() {
                true => CELLS.max(degree.saturating_mul(CELLS_PER_DEGREE)),
                false => CELLS,
            }
        });
        let all = u64::from(wanted[0]) * u64::from(wanted[1]);
        if all <= u64::from(MOST_CELLS) {
            return wanted;
        }
        // The parameter with fewer oscillations keeps its cells, or as many as a square grid has.
        let few = wanted[0].min(wanted[1]).min(MOST_CELLS.isqrt());
        let many = MOST_CELLS / few;
        match wanted[0] <= wanted[1] {
            true => [few, many],
            false => [many, few],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::patch_grid::tests::patch;

    #[test]
    fn oscillations_have_cells() {
        let many = patch("x = cos(70*u)*(2+cos(v)); y = sin(u)*cos(60*v); z = sin(61*v + 3*u)");
        let [along_u, along_v] = many.cells_for_oscillations();
        assert_eq!([along_u, along_v], [141, 141]);
        let one = patch("x = cos(500*u); y = v; z = sin(u)");
        assert_eq!(one.cells_for_oscillations(), [370, 54]);
    }

    #[test]
    fn cells_with_a_pole_are_left_out() {
        let ranges = [Some([-1.0, 1.0]), Some([0.0, 1.0])];
        let facets = |text: &str| patch(text).facets(ranges, Some(5)).facets.len();
        assert_eq!(facets("x = u; y = v; z = u*v"), 25);
        // A pole between the lines of the grid, at u = 0, and one at corners, at v = 0.
        assert_eq!(facets("x = u; y = v; z = 1/u"), 20);
        assert_eq!(facets("x = u; y = v; z = 1/v"), 20);
        assert_eq!(facets("x = u; y = v; z = 1/(u*v)"), 16);
        // At the double pole the value is large on both sides.
        assert_eq!(facets("x = u; y = v; z = 1/u^2"), 25);
        // One corner, at which the function has no value.
        assert_eq!(facets("x = u; y = v; z = v/(v^2+(u+1)^2)"), 24);
    }

    #[test]
    fn near_poles_the_box_shows_most_points() {
        let near = patch("x = u; y = v; z = 1/(5*u-1)");
        let [x, y, z] = near.facets([Some([-1.0, 1.0]); 2], None).extent.unwrap();
        assert_eq!([x, y], [[-1.0, 1.0]; 2]);
        assert!(z[0] > -10.0 && z[1] < 10.0, "{z:?}");
    }
}
