//! Outlines in SVG drawings: the closed paths and basic shapes.

use std::collections::HashMap;
use std::f64::consts::TAU;

use kurbo::{Affine, Arc, Point};
use roxmltree::{Document, Node, ParsingOptions};
use svgtypes::NumberListParser;

use super::cut::{Piece, cut};
use super::rings::{Ring, Rings, is_inside, signed_area};
use super::rows::MAX_ROWS;
use super::svg_path::{Subpath, subpaths};
use super::svg_style::{Look, Styles};
use super::viewport::{Along, Viewport};
use super::{ContourKind, LeftOut, counted};
use crate::error::{Error, Result};

/// The largest number of closed paths in a drawing: which one is within which is asked of all pairs.
const MAX_PATHS: usize = 20_000;
/// The largest number of elements, each as often as it is used.
const MAX_ELEMENTS: usize = 1_000_000;
/// The deepest chain of elements that use others.
const MAX_USES: usize = 32;
/// A path that ends this near to its beginning, relative to its size, is closed: relative steps are rounded.
const NEAR: f64 = 1e-6;

/// Namespaces.
const SVG: &str = "http://www.w3.org/2000/svg";
const XLINK: &str = "http://www.w3.org/1999/xlink";

/// An element that is still to be drawn.
struct Pending<'a, 'input> {
    node: Node<'a, 'input>,
    port: Viewport,
    /// The element that uses this one, and how many do so around it.
    used: Option<Node<'a, 'input>>,
    uses: usize,
    /// How what is around it is drawn.
    look: Look,
}

/// What has been found.
#[derive(Default)]
struct Drawing {
    /// The closed subpaths of each element.
    elements: Vec<Vec<Vec<[f64; 2]>>>,
    paths: usize,
    points: usize,
    open: usize,
    /// The number of closed paths whose signed area is 0.
    flat: usize,
    /// The number of elements with paths that have no paint.
    unpainted: usize,
    texts: usize,
    pictures: usize,
}

/// The closed paths in a text of SVG, without those that are holes in others of the same path.
///
/// # Errors
/// [`Error::Data`] for what is no SVG and for a drawing without a closed path; [`Error::Limit`] beyond the limits above.
pub(super) fn read_drawing(text: &str, place: &str) -> Result<Rings> {
    let wrong = |message: String| Error::data(place, message);
    let options = ParsingOptions {
        allow_dtd: true,
        ..ParsingOptions::default()
    };
    let document = Document::parse_with_options(text, options)
        .map_err(|error| Error::decoding(place, "this cannot be read as SVG", &error))?;
    let root = document.root_element();
    if root.tag_name().name() != "svg" {
        let name = root.tag_name().name();
        return Err(wrong(format!(
            "this is XML with the root <{name}>, no SVG drawing"
        )));
    }
    let port = Viewport::of_drawing(root).map_err(wrong)?;
    let mut drawing = Drawing::default();
    drawing.draw(&document, port, place)?;
    let Drawing { elements, open, .. } = &drawing;
    let mut rings: Vec<Ring> = elements
        .iter()
        .flat_map(|paths| outer_rings(paths))
        .collect();
    if rings.is_empty() {
        return Err(wrong(format!(
            "the drawing has no closed path{}; Z closes a path, and polygons, circles, ellipses and rectangles are closed",
            drawing.text()
        )));
    }
    let background = port
        .extent
        .is_some_and(|extent| remove_background(&mut rings, extent));
    let rest = LeftOut {
        kind: ContourKind::Drawing,
        open: *open,
        background,
        ..LeftOut::default()
    };
    Ok(Rings::new(rings, rest))
}

impl Drawing {
    fn draw(&mut self, document: &Document<'_>, port: Viewport, place: &str) -> Result<()> {
        let styles = Styles::of(document).map_err(|message| Error::data(place, message))?;
        let named = document.descendants();
        let named = named.filter_map(|node| Some((node.attribute("id")?, node)));
        let named: HashMap<&str, Node<'_, '_>> = named.collect();
        let mut pending = vec![Pending {
            node: document.root_element(),
            port,
            used: None,
            uses: 0,
            look: Look::INITIAL,
        }];
        let mut elements = 0;
        while let Some(next) = pending.pop() {
            self.element(&next, &styles, &named, &mut pending)
                .map_err(|message| {
                    let row = document.text_pos_at(next.node.range().start).row;
                    let name = next.node.tag_name().name();
                    Error::data(format!("{place}, row {row}, <{name}>"), message)
                })?;
            elements += 1;
            for (count, most, what) in [
                (elements, MAX_ELEMENTS, "elements"),
                (self.paths, MAX_PATHS, "closed paths"),
                (self.points, MAX_ROWS, "points"),
            ] {
                if count > most {
                    return Err(Error::limit(format!("{place} has more than {most} {what}")));
                }
            }
        }
        Ok(())
    }

    /// Draws an element. What is in it, or what it uses, is pending then.
    fn element<'a, 'input>(
        &mut self,
        next: &Pending<'a, 'input>,
        styles: &Styles<'_>,
        named: &HashMap<&str, Node<'a, 'input>>,
        pending: &mut Vec<Pending<'a, 'input>>,
    ) -> std::result::Result<(), String> {
        let node = next.node;
        let style = styles.of_element(node);
        if !is_of_svg(node) || !style.is_displayed() {
            return Ok(());
        }
        let look = style.look(next.look);
        let port = next.port.transformed(&style.placement()?)?;
        let mut open = |port: Viewport| {
            let mut all = node.children().filter(Node::is_element);
            let children: Vec<_> = match node.tag_name().name() {
                "switch" => all.find(is_chosen).into_iter().collect(),
                // The first child is drawn first.
                _ => all.rev().collect(),
            };
            pending.extend(children.into_iter().map(|node| Pending {
                node,
                port,
                used: None,
                uses: next.uses,
                look,
            }));
        };
        match node.tag_name().name() {
            "g" | "a" | "switch" => open(port),
            "svg" if node.parent_element().is_none() => open(port),
            "svg" => open(port.nested(node, next.used)?),
            // A symbol is drawn where it is used.
            "symbol" if next.used.is_some() => open(port.nested(node, next.used)?),
            "use" => {
                let name = node.attribute("href").or(node.attribute((XLINK, "href")));
                let target = name.and_then(|name| named.get(name.strip_prefix('#')?));
                if next.uses == MAX_USES {
                    return Err(format!(
                        "elements use others in a chain of more than {MAX_USES}, or each other in a circle"
                    ));
                }
                if let Some(&target) = target {
                    let x = port.length(node, "x", Along::X)?.unwrap_or(0.0);
                    let y = port.length(node, "y", Along::Y)?.unwrap_or(0.0);
                    pending.push(Pending {
                        node: target,
                        port: port.moved(Affine::translate((x, y))),
                        used: Some(node),
                        look,
                        uses: next.uses + 1,
                    });
                }
            }
            _ if !look.is_visible => {}
            "text" => self.texts += 1,
            "image" => self.pictures += 1,
            _ => {
                let subpaths = shape(node, &port)?;
                if look.paints() {
                    self.take(subpaths, port.to_outline)?;
                } else {
                    self.unpainted += usize::from(!subpaths.is_empty());
                }
            }
        }
        Ok(())
    }

    /// Takes the closed ones of the subpaths of an element.
    fn take(&mut self, subpaths: Vec<Subpath>, by: Affine) -> std::result::Result<(), String> {
        let mut closed = Vec::new();
        for path in subpaths {
            let pieces = path.pieces.into_iter();
            let pieces: Vec<Piece> = pieces.map(|piece| piece.transformed(by)).collect();
            let points = cut(by * path.start, &pieces);
            if !points.iter().flatten().all(|c| c.is_finite()) {
                return Err("a coordinate is too large for a double".into());
            }
            self.points += points.len();
            match ring(points, path.is_closed) {
                Some(points) => closed.push(points),
                None if path.is_closed => self.flat += 1,
                None => self.open += 1,
            }
        }
        self.paths += closed.len();
        if !closed.is_empty() {
            self.elements.push(closed);
        }
        Ok(())
    }

    /// What there is instead of closed paths.
    fn text(&self) -> String {
        let all = [
            counted(self.open, "open path", "open paths"),
            counted(
                self.flat,
                "closed path whose signed area is 0, which crosses itself or is a line",
                "closed paths whose signed areas are 0, which cross themselves or are lines",
            ),
            counted(
                self.unpainted,
                "shape without fill and stroke",
                "shapes without fill and stroke",
            ),
            counted(self.texts, "text", "texts"),
            counted(self.pictures, "picture", "pictures"),
        ];
        let all: Vec<String> = all.into_iter().flatten().collect();
        match all.is_empty() {
            true => String::new(),
            false => format!("; it has {}", all.join(", ")),
        }
    }
}

/// Whether a child of a `switch` may be the one that is drawn: it asks for no language, or for English, and for no extension.
fn is_chosen(node: &Node<'_, '_>) -> bool {
    let mut languages = node.attribute("systemLanguage").unwrap_or("en").split(',');
    let is_english = |tag: &str| tag.trim() == "en" || tag.trim().starts_with("en-");
    languages.any(is_english) && node.attribute("requiredExtensions").is_none()
}

/// Whether an element is one of SVG.
fn is_of_svg(node: Node<'_, '_>) -> bool {
    node.tag_name().namespace().is_none_or(|name| name == SVG)
}

/// The subpaths of an element; none if it is no shape.
fn shape(node: Node<'_, '_>, port: &Viewport) -> std::result::Result<Vec<Subpath>, String> {
    let length = |name: &str, along: Along| port.length(node, name, along);
    let or_zero = |name: &str, along: Along| Ok::<f64, String>(length(name, along)?.unwrap_or(0.0));
    let one = match node.tag_name().name() {
        "path" => return subpaths(node.attribute("d").unwrap_or_default()),
        "polygon" => points(node).map(|points| Subpath::polygon(points, true))?,
        "polyline" => points(node).map(|points| Subpath::polygon(points, false))?,
        "line" => {
            let from = (or_zero("x1", Along::X)?, or_zero("y1", Along::Y)?);
            let to = (or_zero("x2", Along::X)?, or_zero("y2", Along::Y)?);
            Subpath::polygon([from, to], false)
        }
        "circle" => {
            let r = or_zero("r", Along::Both)?;
            ellipse([or_zero("cx", Along::X)?, or_zero("cy", Along::Y)?], [r, r])
        }
        "ellipse" => {
            let (rx, ry) = (length("rx", Along::X)?, length("ry", Along::Y)?);
            let radii = [rx.or(ry).unwrap_or(0.0), ry.or(rx).unwrap_or(0.0)];
            ellipse([or_zero("cx", Along::X)?, or_zero("cy", Along::Y)?], radii)
        }
        "rect" => {
            let corner = [or_zero("x", Along::X)?, or_zero("y", Along::Y)?];
            let sides = [or_zero("width", Along::X)?, or_zero("height", Along::Y)?];
            let (rx, ry) = (length("rx", Along::X)?, length("ry", Along::Y)?);
            let radii = [rx.or(ry).unwrap_or(0.0), ry.or(rx).unwrap_or(0.0)];
            rectangle(corner, sides, radii)
        }
        _ => return Ok(Vec::new()),
    };
    Ok(match one.pieces.is_empty() {
        true => Vec::new(),
        false => vec![one],
    })
}

/// The points of a polygon or of a polyline.
fn points(node: Node<'_, '_>) -> std::result::Result<Vec<(f64, f64)>, String> {
    let text = node.attribute("points").unwrap_or_default();
    let numbers = NumberListParser::from(text).collect::<std::result::Result<Vec<f64>, _>>();
    let numbers = numbers.map_err(|error| format!("points: {error}"))?;
    match numbers.as_chunks() {
        (points, []) => Ok(points.iter().map(|&[x, y]| (x, y)).collect()),
        _ => Err("points: the last point has no y".into()),
    }
}

fn ellipse([x, y]: [f64; 2], [rx, ry]: [f64; 2]) -> Subpath {
    let mut path = Subpath::polygon([(x + rx, y)], true);
    if rx > 0.0 && ry > 0.0 {
        let arc = Arc::new((x, y), (rx, ry), 0.0, TAU, 0.0);
        path.pieces.push(Piece::arc(&arc, path.start));
    }
    path
}

fn rectangle([x, y]: [f64; 2], [w, h]: [f64; 2], [rx, ry]: [f64; 2]) -> Subpath {
    let (right, bottom) = (x + w, y + h);
    if !(w > 0.0 && h > 0.0) {
        return Subpath::polygon([], true);
    }
    let (rx, ry) = (rx.min(w / 2.0), ry.min(h / 2.0));
    if !(rx > 0.0 && ry > 0.0) {
        return Subpath::polygon([(x, y), (right, y), (right, bottom), (x, bottom)], true);
    }
    let mut path = Subpath::polygon([(x + rx, y)], true);
    // The end of each side, and the end and the middle of the corner after it.
    let quarter = TAU / 4.0;
    for (k, side, corner, middle) in [
        (3.0, (right - rx, y), (right, y + ry), (right - rx, y + ry)),
        (
            0.0,
            (right, bottom - ry),
            (right - rx, bottom),
            (right - rx, bottom - ry),
        ),
        (
            1.0,
            (x + rx, bottom),
            (x, bottom - ry),
            (x + rx, bottom - ry),
        ),
        (2.0, (x, y + ry), (x + rx, y), (x + rx, y + ry)),
    ] {
        path.pieces.push(Piece::Line(Point::from(side)));
        let arc = Arc::new(middle, (rx, ry), k * quarter, quarter, 0.0);
        path.pieces.push(Piece::arc(&arc, Point::from(corner)));
    }
    path
}

/// The ring of a path, if it is closed and encloses an area.
fn ring(mut points: Vec<[f64; 2]>, is_closed: bool) -> Option<Vec<[f64; 2]>> {
    let [low, high] = extent(&points)?;
    let size = (high[0] - low[0]).max(high[1] - low[1]);
    let (first, last) = (*points.first()?, *points.last()?);
    let returns = (first[0] - last[0]).hypot(first[1] - last[1]) <= NEAR * size;
    if returns {
        points.pop();
    }
    let encloses = || signed_area(&points).abs() > 0.0;
    ((is_closed || returns) && points.len() > 2 && encloses()).then_some(points)
}

/// The corners of the box around points.
fn extent(points: &[[f64; 2]]) -> Option<[[f64; 2]; 2]> {
    let corner = |of: fn(f64, f64) -> f64| {
        points
            .iter()
            .copied()
            .reduce(|a, b| [of(a[0], b[0]), of(a[1], b[1])])
    };
    Some([corner(f64::min)?, corner(f64::max)?])
}

/// The rings of an element that are no holes: those within an even number of others.
fn outer_rings(paths: &[Vec<[f64; 2]>]) -> Vec<Ring> {
    let rings: Vec<Ring> = paths
        .iter()
        .map(|path| Ring::new(path.clone(), 0))
        .collect();
    let boxes: Vec<_> = rings.iter().map(|ring| extent(&ring.points)).collect();
    let is_within = &|k: usize, around: usize| {
        let (Some([low, high]), Some(first)) = (boxes[around], rings[k].points.first()) else {
            return false;
        };
        rings[around].area > rings[k].area
            && (0..2).all(|i| (low[i]..=high[i]).contains(&first[i]))
            && is_inside(*first, &rings[around].points)
    };
    let around = |k: usize| (0..rings.len()).filter(move |&j| j != k && is_within(k, j));
    let area = |k: &usize| rings[*k].area;
    let mut holes = vec![0_usize; rings.len()];
    let is_hole: Vec<bool> = (0..rings.len())
        .map(|k| {
            let nearest = around(k).min_by(|a, b| area(a).total_cmp(&area(b)));
            let hole = nearest.filter(|_| around(k).count() % 2 == 1);
            hole.inspect(|&of| holes[of] += 1).is_some()
        })
        .collect();
    let kept = rings.into_iter().zip(holes).zip(is_hole);
    kept.filter(|(_, is_hole)| !is_hole)
        .map(|((ring, holes), _)| Ring { holes, ..ring })
        .collect()
}

/// Removes the first rectangle that covers the whole drawing, and tells whether there is one.
fn remove_background(rings: &mut Vec<Ring>, drawing: [[f64; 2]; 2]) -> bool {
    let sides = |[low, high]: [[f64; 2]; 2]| [high[0] - low[0], high[1] - low[1]];
    let near = NEAR * sides(drawing)[0].max(sides(drawing)[1]);
    let covers = |ring: &Ring| {
        extent(&ring.points).is_some_and(|around| {
            let [w, h] = sides(around);
            let is_around = (0..2).all(|k| {
                around[0][k] <= drawing[0][k] + near && around[1][k] >= drawing[1][k] - near
            });
            ring.points.len() == 4
                && ring.holes == 0
                && is_around
                && ring.area >= w * h * (1.0 - NEAR)
        })
    };
    let found = rings.iter().position(covers);
    found.is_some_and(|at| rings.len() > 1 && !rings.remove(at).points.is_empty())
}

#[cfg(test)]
#[path = "drawing_laws.rs"]
mod laws;
