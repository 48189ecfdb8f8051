//! The zero set of a plane curve in a picture: all of its components, or a remark.

use std::time::Duration;

use super::{Remark, Work};
use crate::error::{Error, Result};
use crate::exact::Rational;
use crate::parametrize::born_of_radius;
use crate::picture::{Layer, Window, extent, isolated_origin, trace_zero_set};
use crate::shape::ImplicitCurve;
use crate::topology::{Component, ComponentKind, Coordinate, Topology};

/// The longest time that is spent on the components of a curve before it is drawn without knowing them.
const PATIENCE: Duration = Duration::from_secs(20);

/// An oval smaller than this part of the window is marked by a dot.
const DOT: f64 = 1.0 / 400.0;

/// An oval smaller than this part of the window is traced once more, by a grid of its own.
const SMALL: f64 = 1.0 / 8.0;

/// The number of cells along a small oval.
const CELLS_OF_SMALL: u32 = 60;

/// A curve that is to be traced, with what is known of its components.
pub(super) struct ZeroSet {
    /// The layer of the figure into which it is traced.
    pub(super) layer: usize,
    curve: ImplicitCurve,
    /// `None` if the components were not found in time.
    topology: Option<Topology>,
}

impl ZeroSet {
    pub(super) fn new(layer: usize, curve: ImplicitCurve, work: &Work) -> Result<Self> {
        let limits = work.bounds().for_at_most(PATIENCE);
        let found = work.stage("topology", || {
            let born = born_of_radius(&curve);
            match born.as_ref().and_then(|found| found.radii.first()) {
                Some(radius) => {
                    let multiplicity = curve.polynomial().lowest_degree().unwrap_or(0);
                    Topology::of_radius(radius, multiplicity, &limits)
                }
                None => Topology::of(curve.polynomial(), &limits),
            }
        });
        let topology = match found {
            Ok(topology) => Some(topology),
            Err(Error::Limit { .. }) => {
                work.remark(Remark::ComponentsUnknown);
                None
            }
            Err(other) => return Err(other),
        };
        Ok(Self {
            layer,
            curve,
            topology,
        })
    }

    fn center(&self) -> [f64; 2] {
        self.curve.center().each_ref().map(Rational::to_f64)
    }

    /// The points that the window should show: the corners of bounded components; of the others the singular points, points in all
    /// directions, and the point nearest to the middle of all these.
    pub(super) fn seen(&self, work: &Work) -> Result<Vec<[f64; 2]>> {
        let [a, b] = self.center();
        let components = self.topology.iter().flat_map(|t| &t.components);
        let (bounded, others): (Vec<_>, Vec<_>) = components.partition(|c| bounds(c).is_some());
        let corners = bounded.into_iter().filter_map(bounds);
        let mut seen: Vec<[f64; 2]> = corners
            .flat_map(|[x, y]| [[x[0], y[0]], [x[1], y[1]]])
            .collect();
        if let Some(topology) = &self.topology {
            let indices = others.iter().flat_map(|c| &c.singular_points);
            let points = indices.map(|&index| &topology.singular_points[index]);
            seen.extend(points.map(|p| p.at.each_ref().map(Coordinate::to_f64)));
        }
        if self.topology.is_none() || !others.is_empty() {
            let around = extent(&self.curve, work.bounds())?;
            seen.extend(around.into_iter().map(|[x, y]| [x - a, y - b]));
        }
        let [x, y] = middle(&seen);
        let distance = |p: &&[f64; 2]| (p[0] - x).hypot(p[1] - y);
        for component in others {
            let points = component.some_points.iter();
            seen.extend(points.min_by(|p, q| distance(p).total_cmp(&distance(q))));
        }
        Ok(seen.into_iter().map(|[x, y]| [x + a, y + b]).collect())
    }

    /// Traces the curve into its layer, in the curve's original coordinates.
    pub(super) fn trace(
        &self,
        window: &Window,
        cells: u32,
        layer: &mut Layer,
        work: &Work,
    ) -> Result<()> {
        let [a, b] = self.center();
        let local = Window {
            x: window.x.map(|v| v - a),
            y: window.y.map(|v| v - b),
        };
        let mut lines = trace_zero_set(self.curve.polynomial(), &local, cells, work.bounds())?;
        let mut points = Vec::new();
        let mut ovals = Vec::new();
        match &self.topology {
            None => {
                if isolated_origin(self.curve.polynomial()) {
                    points.push([0.0, 0.0]);
                }
            }
            Some(topology) => {
                let mut outside = Vec::new();
                for component in &topology.components {
                    if is_outside(component, &local) {
                        outside.push(place(component, [a, b]));
                        continue;
                    }
                    let Some(own) = bounds(component) else {
                        continue;
                    };
                    let own = Window {
                        x: own[0],
                        y: own[1],
                    };
                    let middle = [
                        f64::midpoint(own.x[0], own.x[1]),
                        f64::midpoint(own.y[0], own.y[1]),
                    ];
                    if component.kind == ComponentKind::Point {
                        points.push(middle);
                    } else if own.size() < DOT * local.size() {
                        ovals.push(middle);
                        work.remark(Remark::DrawnAsDot {
                            at: [middle[0] + a, middle[1] + b],
                            size: own.size(),
                        });
                    } else if own.size() < SMALL * local.size() {
                        let around = own.padded(0.05);
                        let more = trace_zero_set(
                            self.curve.polynomial(),
                            &around,
                            CELLS_OF_SMALL,
                            work.bounds(),
                        )?;
                        lines.extend(more);
                    }
                }
                if !outside.is_empty() {
                    work.remark(Remark::OutsideWindow(outside));
                }
            }
        }
        let moved = |[x, y]: [f64; 2]| [x + a, y + b];
        layer.lines = lines
            .into_iter()
            .map(|line| line.into_iter().map(moved).collect())
            .collect();
        layer.points.extend(points.into_iter().map(moved));
        layer.ovals.extend(ovals.into_iter().map(moved));
        Ok(())
    }
}

/// The middle of the smallest window that shows the points; the origin if there are none.
fn middle(points: &[[f64; 2]]) -> [f64; 2] {
    [0, 1].map(|axis| {
        let coordinates = || points.iter().map(|p| p[axis]);
        let low = coordinates().reduce(f64::min).unwrap_or(0.0);
        low.midpoint(coordinates().reduce(f64::max).unwrap_or(0.0))
    })
}

/// The smallest and the largest coordinates, about; `None` if the component is not bounded.
fn bounds(component: &Component) -> Option<[[f64; 2]; 2]> {
    let [x, y] = component.extent.each_ref().map(|ends| {
        let [low, high] = ends.each_ref().map(|c| c.as_ref().map(|c| c.to_f64()));
        Some([low?, high?])
    });
    Some([x?, y?])
}

/// Whether a component has no point in the window, as its extent shows.
fn is_outside(component: &Component, window: &Window) -> bool {
    let sides = [window.x, window.y];
    component
        .extent
        .iter()
        .zip(sides)
        .any(|(ends, [from, to])| {
            let [low, high] = ends.each_ref().map(|c| c.as_ref().map(|c| c.to_f64()));
            low.is_some_and(|low| low > to) || high.is_some_and(|high| high < from)
        })
}

/// The kind and the extent of a component in the original coordinates.
fn place(component: &Component, center: [f64; 2]) -> (ComponentKind, [[f64; 2]; 2]) {
    let mut extent = [[f64::NEG_INFINITY, f64::INFINITY]; 2];
    for ((ends, known), moved) in extent.iter_mut().zip(&component.extent).zip(center) {
        for (end, known) in ends.iter_mut().zip(known) {
            if let Some(known) = known {
                *end = known.to_f64() + moved;
            }
        }
    }
    (component.kind, extent)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::{Numbers, parse_form};
    use crate::shape::Form;

    fn window(equation: &str) -> Window {
        let Ok(Form::Curve(curve)) = parse_form(equation, "a test", Numbers::Exact) else {
            panic!("{equation} is a plane curve");
        };
        let work = Work::default();
        Window::around(ZeroSet::new(0, curve, &work).unwrap().seen(&work).unwrap()).unwrap()
    }

    #[test]
    fn symmetric_curves_have_symmetric_windows() {
        for equation in ["y^2=x^3-x", "y^2=x^3", "x*y=1", "y^2*(x-3)=x^3", "y=x^3-x"] {
            let Window { x, y } = window(equation);
            assert!((y[0] + y[1]).abs() < 1e-6 * y[1], "{equation}: {y:?}");
            assert!(x[0] < x[1], "{equation}: {x:?}");
        }
    }

    #[test]
    fn a_window_has_a_point_of_each_component() {
        let small = window("x^2+y^2=1");
        assert!(small.x[1] < 2.0);
        let with_line = window("(x^2+y^2-1)*(x-100)");
        assert!(with_line.x[1] >= 100.0);
        let with_cusp = window("(x^2+y^2-1)*((y-90)^2-(x-50)^3)");
        assert!(with_cusp.x[1] >= 50.0 && with_cusp.y[1] >= 90.0);
    }
}
