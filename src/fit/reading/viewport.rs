//! Lengths and coordinate systems of SVG.

use kurbo::{Affine, Vec2};
use roxmltree::Node;
use svgtypes::{Align, AspectRatio, Length, LengthUnit, Transform, ViewBox};

use super::svg_style::Placement;

/// The direction in which a length is measured, of which a percentage is taken.
#[derive(Clone, Copy, Debug)]
pub(super) enum Along {
    X,
    Y,
    /// Neither: the root of the mean square of both.
    Both,
}

/// A coordinate system: how it lies in the outline's one, and its size, if it has one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Viewport {
    pub(super) to_outline: Affine,
    pub(super) size: Option<[f64; 2]>,
    /// The corners of the whole drawing in the outline's system.
    pub(super) extent: Option<[[f64; 2]; 2]>,
}

impl Viewport {
    /// The system of the whole drawing. It is that of its view box; y is mirrored about its middle line, so that y points up
    /// in the same range.
    pub(super) fn of_drawing(root: Node<'_, '_>) -> Result<Self, String> {
        let unsized_port = Self {
            to_outline: Affine::IDENTITY,
            size: None,
            extent: None,
        };
        let view = view_box(root)?;
        let [width, height] = [("width", Along::X), ("height", Along::Y)].map(|(name, along)| {
            // A percentage is one of the window, which nobody knows.
            unsized_port.length(root, name, along).ok().flatten()
        });
        let ([left, top], size) = match view {
            Some(view) => ([view.x, view.y], Some([view.w, view.h])),
            None => ([0.0, 0.0], width.zip(height).map(|(w, h)| [w, h])),
        };
        let high = size.map(|[_, h]| h).or(height).unwrap_or(0.0);
        Ok(Self {
            to_outline: Affine::new([1.0, 0.0, 0.0, -1.0, 0.0, 2.0 * top + high]),
            size,
            extent: size.map(|[w, h]| [[left, top], [left + w, top + h]]),
        })
    }

    /// The length in an attribute, in the units of this system; `None` if there is none.
    pub(super) fn length(
        &self,
        node: Node<'_, '_>,
        name: &str,
        along: Along,
    ) -> Result<Option<f64>, String> {
        let Some(text) = node.attribute(name) else {
            return Ok(None);
        };
        let wrong = |what: &str| format!("{name}=\"{text}\" {what}");
        if text.trim() == "auto" {
            return Ok(None);
        }
        let length: Length = text.trim().parse().map_err(|_| wrong("is no length"))?;
        let unit = match length.unit {
            LengthUnit::None | LengthUnit::Px => 1.0,
            LengthUnit::In => 96.0,
            LengthUnit::Cm => 96.0 / 2.54,
            LengthUnit::Mm => 96.0 / 25.4,
            LengthUnit::Pt => 4.0 / 3.0,
            LengthUnit::Pc => 16.0,
            LengthUnit::Em | LengthUnit::Ex => {
                return Err(wrong("depends on a font; give it a length in px or mm"));
            }
            LengthUnit::Percent => {
                let size = self
                    .size
                    .ok_or_else(|| wrong("is a part of a drawing without a viewBox"))?;
                let whole = match (along, size) {
                    (Along::X, [w, _]) => w,
                    (Along::Y, [_, h]) => h,
                    (Along::Both, [w, h]) => w.hypot(h) / std::f64::consts::SQRT_2,
                };
                whole / 100.0
            }
        };
        Ok(Some(length.number * unit))
    }

    /// The system that a transform about a point makes. Styles may have units, `px` and `deg`, which are those of attributes.
    pub(super) fn transformed(&self, placement: &Placement<'_>) -> Result<Self, String> {
        let Some(text) = placement.transform else {
            return Ok(*self);
        };
        let by: Transform = text
            .replace("px", "")
            .replace("deg", "")
            .parse()
            .map_err(|_| format!("transform=\"{text}\" is no transform"))?;
        let by = Affine::new([by.a, by.b, by.c, by.d, by.e, by.f]);
        let [x, y] = placement.origin;
        let origin = Vec2::new(x, y);
        Ok(self.moved(Affine::translate(origin) * by * Affine::translate(-origin)))
    }

    pub(super) fn moved(&self, by: Affine) -> Self {
        Self {
            to_outline: self.to_outline * by,
            ..*self
        }
    }

    /// The system within an `svg` in a drawing, or within a `symbol`, whose size may be given where it is used.
    pub(super) fn nested(
        &self,
        node: Node<'_, '_>,
        used: Option<Node<'_, '_>>,
    ) -> Result<Self, String> {
        let side = |name, along, k: usize| -> Result<Option<f64>, String> {
            let given = used.map_or(Ok(None), |used| self.length(used, name, along))?;
            let own = self.length(node, name, along)?;
            Ok(given.or(own).or(self.size.map(|size| size[k])))
        };
        let (width, height) = (side("width", Along::X, 0)?, side("height", Along::Y, 1)?);
        let corner = Vec2::new(
            self.length(node, "x", Along::X)?.unwrap_or(0.0),
            self.length(node, "y", Along::Y)?.unwrap_or(0.0),
        );
        let size = width.zip(height).map(|(w, h)| [w, h]);
        let moved = self.moved(Affine::translate(corner));
        let Some((view, [w, h])) = view_box(node)?.zip(size) else {
            return Ok(Self { size, ..moved });
        };
        let aspect: Option<AspectRatio> = node
            .attribute("preserveAspectRatio")
            .and_then(|text| text.parse().ok());
        let (align, slice) = aspect.map_or((Align::XMidYMid, false), |a| (a.align, a.slice));
        let (sx, sy) = (w / view.w, h / view.h);
        let both = if slice { sx.max(sy) } else { sx.min(sy) };
        let (sx, sy) = if align == Align::None {
            (sx, sy)
        } else {
            (both, both)
        };
        let left = match align {
            Align::None | Align::XMinYMin | Align::XMinYMid | Align::XMinYMax => 0.0,
            Align::XMidYMin | Align::XMidYMid | Align::XMidYMax => 0.5,
            Align::XMaxYMin | Align::XMaxYMid | Align::XMaxYMax => 1.0,
        };
        let upper = match align {
            Align::None | Align::XMinYMin | Align::XMidYMin | Align::XMaxYMin => 0.0,
            Align::XMinYMid | Align::XMidYMid | Align::XMaxYMid => 0.5,
            Align::XMinYMax | Align::XMidYMax | Align::XMaxYMax => 1.0,
        };
        let offset = Vec2::new(
            left * (w - sx * view.w) - sx * view.x,
            upper * (h - sy * view.h) - sy * view.y,
        );
        Ok(Self {
            size: Some([view.w, view.h]),
            ..moved.moved(Affine::translate(offset) * Affine::scale_non_uniform(sx, sy))
        })
    }
}

fn view_box(node: Node<'_, '_>) -> Result<Option<ViewBox>, String> {
    let text = node.attribute("viewBox");
    let view = text.map(|text| text.parse::<ViewBox>().map_err(|error| error.to_string()));
    view.transpose()
}
