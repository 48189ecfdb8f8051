//! `stellate plot` in space: curves and patches in perspective.

use stellate::error::{Error, Result};
use stellate::picture::{Scene, SpaceLayer};
use stellate::shape::{DRAWN_NUMBERS, Form, Parameter};

use super::arguments::Plot;
use super::input::{Content, Input};

/// Points along a curve, and cells along each parameter of a patch.
const CURVE_POINTS: u32 = 720;
const PATCH_CELLS: u32 = 54;

/// Whether a form is drawn in space.
pub(crate) fn is_in_space(input: &Input) -> bool {
    matches!(
        input.content,
        Content::Exact(
            Form::SpaceCurve(_) | Form::Patch(_) | Form::Surface(_) | Form::Intersection(_)
        )
    )
}

/// The scene of several forms, as SVG.
pub(crate) fn scene(verb: &Plot, inputs: Vec<Input>) -> Result<String> {
    let ranges = ranges(verb)?;
    let [azimuth, elevation] = view(&verb.view)?;
    let bounds = verb.window.as_deref().map(bounds).transpose()?;
    let mut layers = Vec::new();
    let mut around: Option<Bounds> = None;
    for input in inputs {
        let (layer, extent) = layer(input, &ranges)?;
        layers.push(layer);
        around = match (around, extent) {
            (Some(a), Some(b)) => {
                Some([0, 1, 2].map(|k| [a[k][0].min(b[k][0]), a[k][1].max(b[k][1])]))
            }
            (a, b) => a.or(b),
        };
    }
    Scene {
        title: verb.title.clone(),
        bounds: bounds.or(around),
        azimuth,
        elevation,
        layers,
    }
    .to_svg()
}

/// The sides of a box.
type Bounds = [[f64; 2]; 3];

/// A parameter's name and the part of it that is drawn.
pub(crate) type Range = (String, [f64; 2]);

/// `--range NAME=A,B`
pub(crate) fn ranges(verb: &Plot) -> Result<Vec<Range>> {
    let read = |text: &String| {
        let (name, numbers) = text.split_once('=')?;
        let [a, b] = numbers_of::<2>(numbers)?;
        (a < b).then(|| (name.trim().to_owned(), [a, b]))
    };
    verb.range
        .iter()
        .map(|text| {
            read(text).ok_or_else(|| {
                Error::Usage(format!(
                    "--range {text}: expected NAME=A,B with A < B, such as t=-2,2"
                ))
            })
        })
        .collect()
}

/// The range given for a parameter, if there is one.
pub(crate) fn range_of(parameter: &Parameter, ranges: &[Range]) -> Option<[f64; 2]> {
    let given = ranges.iter().rfind(|(name, _)| name == parameter.name());
    given.map(|(_, range)| *range)
}

/// What the legend says of the range of a parameter.
pub(crate) fn range_text(parameter: &Parameter, range: Option<[f64; 2]>) -> Option<String> {
    range.map(|[a, b]| format!("{} from {a} to {b}", parameter.name()))
}

fn view(text: &str) -> Result<[f64; 2]> {
    let found = numbers_of::<2>(text).filter(|[_, elevation]| elevation.abs() < 90.0);
    found.ok_or_else(|| {
        Error::Usage(format!(
            "--view {text}: expected AZIMUTH,ELEVATION in degrees, such as 30,25, with the elevation between -90 and 90"
        ))
    })
}

fn bounds(text: &str) -> Result<[[f64; 2]; 3]> {
    let wrong = || {
        Error::Usage(format!(
            "--window {text}: expected X0,X1,Y0,Y1,Z0,Z1 with X0 < X1 and so on, such as -1,1,-1,1,0,2"
        ))
    };
    let [x0, x1, y0, y1, z0, z1] = numbers_of::<6>(text).ok_or_else(wrong)?;
    if x0 < x1 && y0 < y1 && z0 < z1 {
        Ok([[x0, x1], [y0, y1], [z0, z1]])
    } else {
        Err(wrong())
    }
}

/// N finite numbers with commas between them.
pub(crate) fn numbers_of<const N: usize>(text: &str) -> Option<[f64; N]> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|t| t.trim().parse().ok()).collect();
    let numbers: [f64; N] = numbers?.try_into().ok()?;
    numbers.iter().all(|v| v.is_finite()).then_some(numbers)
}

/// What is drawn of a form, and the box that shows it.
fn layer(input: Input, ranges: &[Range]) -> Result<(SpaceLayer, Option<Bounds>)> {
    let name = input.short_name();
    let label = |kind: &str, parts: Vec<String>| {
        let parts = parts.into_iter().map(|part| format!(", {part}"));
        format!("{kind}, {name}{}", parts.collect::<String>())
    };
    match input.content {
        Content::Exact(Form::SpaceCurve(curve)) => {
            let range = range_of(curve.parameter(), ranges);
            let said = range_text(curve.parameter(), range);
            let drawn = SpaceLayer {
                label: label("space curve", said.into_iter().collect()),
                lines: curve.polylines(range, CURVE_POINTS),
                ..SpaceLayer::default()
            };
            Ok((drawn, curve.extent(range)))
        }
        Content::Exact(Form::Patch(patch)) => {
            let given = patch.parameters().each_ref().map(|p| range_of(p, ranges));
            let shown = patch.parameters().iter().zip(given).map(|(p, range)| {
                let numbers = (!p.is_angle()).then_some(DRAWN_NUMBERS);
                range_text(p, range.or(numbers))
            });
            let grid = patch.grid(given, [PATCH_CELLS; 2]);
            let drawn = SpaceLayer {
                label: label("patch", shown.flatten().collect()),
                facets: SpaceLayer::grid_facets(&grid),
                ..SpaceLayer::default()
            };
            let extent = around(drawn.facets.iter().flatten());
            Ok((drawn, extent))
        }
        Content::Exact(Form::Surface(_) | Form::Intersection(_)) => Err(Error::Usage(format!(
            "{name}: plot draws curves and patches in space from their parameters; this form has only equations in x, y and z"
        ))),
        _ => Err(Error::Usage(format!(
            "{name}: this form is in the plane and cannot be drawn with one in space"
        ))),
    }
}

/// The box around finite points.
fn around<'a>(points: impl Iterator<Item = &'a [f64; 3]>) -> Option<Bounds> {
    points
        .filter(|p| p.iter().all(|v| v.is_finite()))
        .fold(None, |bounds: Option<Bounds>, p| {
            let b = bounds.unwrap_or(p.map(|v| [v, v]));
            Some([0, 1, 2].map(|k| [b[k][0].min(p[k]), b[k][1].max(p[k])]))
        })
}
