//! Outlines and clouds as documents, which a form carries to where its file is not: the points in their order, exactly.

use serde::{Deserialize, Serialize};

use crate::error::{Error, Invariant, Result};
use crate::exact::Rational;
use crate::language::{Numbers, number_at};
use crate::reading::SCHEMA;
use crate::shape::{Contour, GivenPoints, PointCloud};
use crate::verb::{Content, ReadOptions};

/// The kind of the document.
const KIND: &str = "contour";

#[derive(Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct Document {
    schema: String,
    kind: String,
    /// Whether the points are in no order.
    cloud: bool,
    /// The size of a pixel, if the outline was traced in a picture, else 0.
    resolution: String,
    points: Vec<[String; 2]>,
    /// Empty if every weight is 1.
    weights: Vec<String>,
}

#[derive(Debug, Deserialize)]
struct Head {
    kind: String,
}

fn exact(double: f64) -> String {
    let exact = Rational::try_from(double).invariant("the numbers of outlines are finite");
    exact.to_string()
}

/// The document of an outline or a cloud.
pub(super) fn written(content: &Content) -> Result<Vec<u8>> {
    let (cloud, resolution, points, weights) = match content {
        Content::Contour(contour) => (
            false,
            contour.resolution(),
            contour.given_points(),
            contour.given_weights(),
        ),
        Content::Cloud(cloud) => (true, 0.0, cloud.points().to_vec(), cloud.weights().to_vec()),
        Content::Exact(_) => {
            return Err(Error::internal("contour", "an exact form has a document"));
        }
    };
    let points = points.into_iter().map(|[x, y]| [exact(x), exact(y)]);
    let document = Document {
        schema: SCHEMA.into(),
        kind: KIND.into(),
        cloud,
        resolution: exact(resolution),
        points: points.collect(),
        weights: weights.into_iter().map(exact).collect(),
    };
    Ok(serde_json::to_vec(&document).map_err(std::io::Error::from)?)
}

/// What the text of a document of this kind has; `None` for another text.
pub(super) fn read(text: &str, place: &str, options: &ReadOptions) -> Result<Option<Content>> {
    let is_contour = text.trim_start().starts_with('{')
        && serde_json::from_str::<Head>(text).is_ok_and(|head| head.kind == KIND);
    if !is_contour {
        return Ok(None);
    }
    // An outline that was read is mended already.
    options.outline.clone().repair(false).check(None)?;
    let document: Document =
        serde_json::from_str(text).map_err(|error| Error::decoding(place, "contour", &error))?;
    if document.schema != SCHEMA {
        return Err(Error::data(
            place,
            format!("schema: expected \"{SCHEMA}\", found {:?}", document.schema),
        ));
    }
    let double = |text: &String| {
        let exact = number_at(place, text, Numbers::Exact)?;
        let double = exact.to_f64();
        match Rational::try_from(double) {
            Ok(same) if same == exact => Ok(double),
            _ => Err(Error::data(
                place,
                format!("{text} is no double, as the numbers of an outline are"),
            )),
        }
    };
    let points = document
        .points
        .iter()
        .map(|[x, y]| Ok([double(x)?, double(y)?]));
    let given = GivenPoints {
        points: points.collect::<Result<_>>()?,
        weights: document.weights.iter().map(double).collect::<Result<_>>()?,
        rows: Vec::new(),
    };
    Ok(Some(if document.cloud || options.cloud {
        Content::Cloud(PointCloud::new(given, place)?)
    } else {
        let contour = Contour::from_rows(given, place)?;
        Content::Contour(contour.with_resolution(double(&document.resolution)?))
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outlines_and_clouds_come_back() {
        let given = GivenPoints {
            // Given clockwise.
            points: vec![[0.1, 0.0], [0.0, 2.5e-9], [1.0 / 3.0, 2.0], [2.0, -0.7]],
            weights: vec![1.0, 0.1, 3.0, 0.0],
            rows: Vec::new(),
        };
        let contour = Contour::from_rows(given.clone(), "points").unwrap();
        let cloud = PointCloud::new(given, "points").unwrap();
        for content in [
            Content::Contour(contour.with_resolution(0.1)),
            Content::Cloud(cloud),
        ] {
            let text = String::from_utf8(written(&content).unwrap()).unwrap();
            let again = read(&text, "points", &ReadOptions::default()).unwrap();
            match (content, again) {
                (Content::Contour(one), Some(Content::Contour(other))) => assert_eq!(one, other),
                (Content::Cloud(one), Some(Content::Cloud(other))) => assert_eq!(one, other),
                (content, again) => panic!("{content:?} came back as {again:?}"),
            }
        }
        let radius = r#"{"schema": "stellate/1", "kind": "fourier", "cos": ["1"], "sin": ["0"]}"#;
        let options = ReadOptions::default();
        assert!(read(radius, "radius", &options).unwrap().is_none());
        assert!(read("r = 1", "text", &options).unwrap().is_none());
        assert!(read(r#"{"kind": "contour"}"#, "empty", &options).is_err());
    }
}
