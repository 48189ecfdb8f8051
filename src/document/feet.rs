//! The nearest points of a form to inspected points, in rows and documents.

use serde::Serialize;

use super::json::Number;
use crate::inspect::{Foot, InspectedPoint};

/// The coordinates of a foot and of the normal there, and the bounds of the signed distance.
pub(super) struct FootParts {
    point: Option<Vec<f64>>,
    normal: Option<Vec<f64>>,
    signed: Option<[f64; 2]>,
}

/// A foot in JSON.
#[derive(Serialize)]
pub(super) struct FootEntry {
    point: Option<Vec<Number>>,
    normal: Option<Vec<Number>>,
    signed_low: Option<Number>,
    signed_high: Option<Number>,
}

/// The names of the columns of feet, for points with two or three coordinates.
pub(super) fn foot_names(dimension: usize) -> Vec<String> {
    let axes = &["x", "y", "z"][..dimension];
    let names = ["foot", "normal"].into_iter();
    let names = names.flat_map(|name| axes.iter().map(move |axis| format!("{name}_{axis}")));
    let bounds = ["signed_low", "signed_high"].map(str::to_owned);
    names.chain(bounds).collect()
}

/// The sentence for a foot.
pub(super) fn foot_text(foot: &Foot, dimension: usize) -> String {
    let list = |v: [f64; 3]| {
        let parts = coordinates(v, dimension).into_iter();
        parts
            .map(|x| format!("{x:?}"))
            .collect::<Vec<_>>()
            .join(", ")
    };
    let normal = match foot.normal {
        Some(normal) => format!(", with the normal ({})", list(normal)),
        None => String::new(),
    };
    format!("its foot is about ({}){normal}", list(foot.point))
}

/// The first coordinates of a vector; −0 becomes 0.
fn coordinates(v: [f64; 3], dimension: usize) -> Vec<f64> {
    v[..dimension].iter().map(|x| x + 0.0).collect()
}

impl FootParts {
    pub(super) fn of(point: &InspectedPoint<'_>, dimension: usize) -> Self {
        let parts = |v: [f64; 3]| coordinates(v, dimension);
        let signed = point.inspection.signed_distance();
        Self {
            point: point.foot.map(|foot| parts(foot.point)),
            normal: point.foot.and_then(|foot| foot.normal).map(parts),
            signed: signed.map(|bounds| bounds.map(|x| x + 0.0)),
        }
    }

    /// The fields of a row; what there is not is empty.
    pub(super) fn fields(self, dimension: usize) -> Vec<String> {
        let fields = |values: Option<Vec<f64>>, count: usize| match values {
            Some(values) => values.into_iter().map(|x| format!("{x:?}")).collect(),
            None => vec![String::new(); count],
        };
        let mut all = fields(self.point, dimension);
        all.extend(fields(self.normal, dimension));
        all.extend(fields(self.signed.map(Vec::from), 2));
        all
    }
}

impl From<FootParts> for FootEntry {
    fn from(parts: FootParts) -> Self {
        let numbers = |values: Vec<f64>| values.into_iter().map(Number).collect();
        Self {
            point: parts.point.map(numbers),
            normal: parts.normal.map(numbers),
            signed_low: parts.signed.map(|[low, _]| Number(low)),
            signed_high: parts.signed.map(|[_, high]| Number(high)),
        }
    }
}
