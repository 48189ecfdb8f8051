//! Outlines in GeoJSON (RFC 7946): the outer rings of polygons, and lines that end where they begin.

use std::fmt;

use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{self, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::Number;

use super::rings::{Ring, Rings};
use super::{ContourKind, LeftOut, counted};
use crate::error::{Error, Result};
use crate::rows::double;

/// The types of GeoJSON, and that of TopoJSON.
const TYPES: [&str; 10] = [
    "Feature",
    "FeatureCollection",
    "GeometryCollection",
    "LineString",
    "MultiLineString",
    "MultiPoint",
    "MultiPolygon",
    "Point",
    "Polygon",
    "Topology",
];
const RIGHT: &str = "an outline is a Polygon, a MultiPolygon, or a line that ends where it begins";

/// Whether a text is GeoJSON: a JSON object whose member `type` is one of its types.
#[must_use]
pub(crate) fn is_geojson(text: &str) -> bool {
    #[derive(Deserialize)]
    struct Typed {
        r#type: Option<String>,
    }
    let text = text.trim_start_matches('\u{feff}').trim_start();
    // A document of a verb, or a formula, is not read twice.
    text.starts_with('{')
        && text.contains("\"type\"")
        && serde_json::from_str::<Typed>(text)
            .is_ok_and(|typed| typed.r#type.is_some_and(|name| TYPES.contains(&&*name)))
}

/// A geometry, a feature or a collection; what else it says is of no interest.
#[derive(Debug, Deserialize)]
struct Object {
    r#type: String,
    features: Option<Vec<Object>>,
    geometry: Option<Box<Object>>,
    geometries: Option<Vec<Object>>,
    coordinates: Option<Nested>,
}

/// Lists of lists of positions.
#[derive(Debug)]
enum Nested {
    Number(f64),
    /// The first two numbers of a position; an altitude is dropped.
    Position([f64; 2]),
    List(Vec<Nested>),
}

/// What was found.
#[derive(Debug, Default)]
struct Found {
    rings: Vec<Ring>,
    points: usize,
    open_lines: usize,
}

/// The polygons in a text of GeoJSON.
///
/// # Errors
/// [`Error::Data`] for what is no GeoJSON, and for GeoJSON without a polygon.
pub(super) fn read_geojson(text: &str, place: &str) -> Result<Rings> {
    let wrong = |message: String| Error::data(place, message);
    let text = text.trim_start_matches('\u{feff}');
    let root: Object = serde_json::from_str(text)
        .map_err(|error| Error::decoding(place, "this cannot be read as GeoJSON", &error))?;
    let mut found = Found::default();
    // Objects that are not read yet, the next one last. The parser bounds the depth, but not the number.
    let mut open = vec![root];
    while let Some(object) = open.pop() {
        open.extend(object.features.into_iter().flatten().rev());
        open.extend(object.geometries.into_iter().flatten().rev());
        open.extend(object.geometry.map(|geometry| *geometry));
        if object.r#type == "Topology" {
            return Err(wrong("this is TopoJSON; save it as GeoJSON".into()));
        }
        let coordinates = object.coordinates.unwrap_or(Nested::List(Vec::new()));
        found
            .take(&object.r#type, coordinates)
            .map_err(|message| wrong(format!("the type {}: {message}", object.r#type)))?;
    }
    if found.rings.is_empty() {
        return Err(wrong(format!("this is GeoJSON {}; {RIGHT}", found.text())));
    }
    let rest = LeftOut {
        kind: ContourKind::Polygons,
        open: found.points + found.open_lines,
        ..LeftOut::default()
    };
    Ok(Rings::new(found.rings, rest))
}

impl Found {
    fn take(&mut self, name: &str, coordinates: Nested) -> std::result::Result<(), String> {
        match name {
            "Polygon" => self.polygon(coordinates.list()?)?,
            "MultiPolygon" => {
                for polygon in coordinates.list()? {
                    self.polygon(polygon.list()?)?;
                }
            }
            "LineString" => self.line(coordinates)?,
            "MultiLineString" => {
                for line in coordinates.list()? {
                    self.line(line)?;
                }
            }
            "Point" => self.points += 1,
            "MultiPoint" => self.points += coordinates.list()?.len(),
            "Feature" | "FeatureCollection" | "GeometryCollection" => {}
            _ => {
                return Err(format!(
                    "that is no type of GeoJSON, whose types are {}",
                    TYPES[..9].join(", ")
                ));
            }
        }
        Ok(())
    }

    /// The outer ring of a polygon; the others are holes.
    fn polygon(&mut self, rings: Vec<Nested>) -> std::result::Result<(), String> {
        let holes = rings.len().saturating_sub(1);
        if let Some(outer) = rings.into_iter().next() {
            self.rings.push(Ring::new(outer.positions()?, holes));
        }
        Ok(())
    }

    fn line(&mut self, line: Nested) -> std::result::Result<(), String> {
        let points = line.positions()?;
        if points.len() > 3 && points.first() == points.last() {
            self.rings.push(Ring::new(points, 0));
        } else {
            self.open_lines += 1;
        }
        Ok(())
    }

    /// What there is instead of polygons.
    fn text(&self) -> String {
        let all = [
            counted(self.points, "point", "points"),
            counted(self.open_lines, "open line", "open lines"),
        ];
        let all: Vec<String> = all.into_iter().flatten().collect();
        match all.is_empty() {
            true => "without a geometry".into(),
            false => format!("of {}", all.join(" and ")),
        }
    }
}

impl Nested {
    fn list(self) -> std::result::Result<Vec<Nested>, String> {
        match self {
            Self::List(list) => Ok(list),
            _ => Err("its coordinates are not nested as deep as they must be".into()),
        }
    }

    fn positions(self) -> std::result::Result<Vec<[f64; 2]>, String> {
        let positions = self.list()?.into_iter().map(|position| match position {
            Self::Position(position) => Ok(position),
            Self::List(list) if list.is_empty() => Err("a position has two numbers, [x, y]".into()),
            _ => Err("its coordinates are nested deeper than they may be".into()),
        });
        positions.collect()
    }
}

impl<'de> Deserialize<'de> for Nested {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        deserializer.deserialize_any(NestedVisitor)
    }
}

struct NestedVisitor;

impl<'de> Visitor<'de> for NestedVisitor {
    type Value = Nested;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("coordinates, which are numbers in lists")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> std::result::Result<Nested, A::Error> {
        let Some(first) = list.next_element()? else {
            return Ok(Nested::List(Vec::new()));
        };
        if let Nested::Number(x) = first {
            let Some(Nested::Number(y)) = list.next_element()? else {
                return Err(de::Error::custom("a position has two numbers, [x, y]"));
            };
            while list.next_element::<IgnoredAny>()?.is_some() {}
            return Ok(Nested::Position([x, y]));
        }
        let mut all = vec![first];
        while let Some(next) = list.next_element()? {
            all.push(next);
        }
        Ok(Nested::List(all))
    }

    #[expect(
        clippy::cast_precision_loss,
        reason = "the conversion rounds to the nearest double"
    )]
    fn visit_u64<E>(self, integer: u64) -> std::result::Result<Nested, E> {
        Ok(Nested::Number(integer as f64))
    }

    #[expect(
        clippy::cast_precision_loss,
        reason = "the conversion rounds to the nearest double"
    )]
    fn visit_i64<E>(self, integer: i64) -> std::result::Result<Nested, E> {
        Ok(Nested::Number(integer as f64))
    }

    /// A number with all its digits, if it is no integer.
    fn visit_map<A: MapAccess<'de>>(self, map: A) -> std::result::Result<Nested, A::Error> {
        let number = Number::deserialize(MapAccessDeserializer::new(map))?;
        let value = double(number.as_str()).map_err(de::Error::custom)?;
        Ok(Nested::Number(value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::OutlineOptions;

    fn rings(text: &str) -> Result<Rings> {
        read_geojson(text, "a.geojson")
    }

    fn message(text: &str) -> String {
        rings(text).unwrap_err().to_string()
    }

    const SQUARE: &str = "[[0,0],[2,0],[2,2],[0,2],[0,0]]";

    #[test]
    fn polygons_are_read_wherever_they_are() {
        let small = "[[9,9],[10,9],[10,9.1,777],[9,9]]";
        for text in [
            format!(r#"{{"type":"Polygon","coordinates":[{SQUARE}]}}"#),
            format!(r#"{{"coordinates":[{SQUARE},{small}],"type":"Polygon"}}"#),
            format!(r#"{{"type":"MultiPolygon","coordinates":[[{small}],[{SQUARE}]]}}"#),
            format!(r#"{{"type":"LineString","coordinates":{SQUARE}}}"#),
            format!(
                r#"{{"type":"FeatureCollection","crs":{{}},"features":[
                    {{"type":"Feature","properties":{{"a":[1]}},"geometry":{{"type":"Point","coordinates":[1,2]}}}},
                    {{"type":"Feature","properties":null,"geometry":null}},
                    {{"type":"Feature","geometry":{{"type":"GeometryCollection","geometries":[
                        {{"type":"Polygon","coordinates":[{SQUARE}]}}]}}}}]}}"#
            ),
        ] {
            assert!(is_geojson(&text), "{text}");
            let (outline, _) = rings(&text)
                .unwrap()
                .outline(0, &OutlineOptions::default(), "a")
                .unwrap();
            assert_eq!(
                outline.points(),
                [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]
            );
        }
        let text = format!(
            r#"{{"type":"GeometryCollection","geometries":[
                {{"type":"MultiPolygon","coordinates":[[{small}],[{SQUARE},{small}]]}},
                {{"type":"MultiPoint","coordinates":[[1,2],[3,4]]}},
                {{"type":"LineString","coordinates":[[1,2],[3,4]]}}]}}"#
        );
        let (_, left_out) = rings(&text)
            .unwrap()
            .outline(0, &OutlineOptions::default(), "a")
            .unwrap();
        assert_eq!((left_out.parts, left_out.holes, left_out.open), (1, 1, 3));
    }

    #[test]
    fn numbers_have_all_their_digits() {
        let text = r#"{"type":"Polygon","coordinates":[[[500000.12700000004,4649776.458000001],[1e-5,1],[2,7e0]]]}"#;
        let (outline, _) = rings(text)
            .unwrap()
            .outline(0, &OutlineOptions::default(), "a")
            .unwrap();
        assert!(
            outline
                .points()
                .contains(&[500_000.127_000_000_04, 4_649_776.458_000_001])
        );
    }

    #[test]
    fn what_has_no_polygon_is_named() {
        let point = r#"{"type":"Point","coordinates":[1,2]}"#;
        assert!(message(point).contains("this is GeoJSON of one point; an outline is a Polygon"));
        let collection = format!(
            r#"{{"type":"GeometryCollection","geometries":[{point},{point},
                {{"type":"MultiLineString","coordinates":[[[1,2],[3,4]]]}}]}}"#
        );
        assert!(message(&collection).contains("of 2 points and one open line; an outline"));
        let empty = r#"{"type":"FeatureCollection","features":[]}"#;
        assert!(message(empty).contains("this is GeoJSON without a geometry"));
        assert!(message(r#"{"type":"Topology","arcs":[]}"#).contains("TopoJSON"));
        assert!(message(r#"{"type":"Polygone","coordinates":[]}"#).contains("no type of GeoJSON"));
        for (coordinates, part) in [
            ("[[0,0],[1,0],[1,1]]", "not nested as deep"),
            ("[[[[0,0],[1,0],[1,1]]]]", "nested deeper"),
            ("[[[0],[1,0],[1,1]]]", "a position has two numbers"),
            ("[[[0,\"1\"],[1,0],[1,1]]]", "expected coordinates"),
            ("[[[0,1e999],[1,0],[1,1]]]", "too large for a double"),
            ("[[[0,1],[1,0]", "line 1 column"),
            ("[[[0,0],[1,0]]]", "at least three points"),
        ] {
            let text = format!(r#"{{"type":"Polygon","coordinates":{coordinates}}}"#);
            let found = rings(&text)
                .and_then(|mut rings| rings.outline(0, &OutlineOptions::default(), "a"));
            let message = found.unwrap_err().to_string();
            assert!(message.contains(part), "{coordinates}: {message}");
        }
        let deep = format!(
            r#"{{"type":"Polygon","coordinates":{}"#,
            "[".repeat(100_000)
        );
        assert!(message(&deep).contains("recursion limit"));
    }

    #[test]
    fn documents_and_formulas_are_no_geojson() {
        for text in [
            r#"{"schema":"stellate/1","kind":"fourier"}"#,
            r#"{"type":"package"}"#,
            r#"{"a":{"type":"Polygon"}}"#,
            "{t^2, t^3}",
            "[1]",
        ] {
            assert!(!is_geojson(text), "{text}");
        }
    }
}
