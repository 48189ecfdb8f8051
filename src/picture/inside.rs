//! Tests that all letters of a picture are inside it, and that numbers of an axis do not touch.

use proptest::prelude::*;

use super::chart::{Chart, Series};
use super::figure::{Figure, Layer};
use super::scene::{Scene, SpaceLayer};
use super::text::text_width;
use super::trace::Window;

/// The formula of a long legend.
const FORMULA: &str =
    "zero set, degree 4, x^4 + 2x^2y^2 + y^4 - 3x^3 + 9xy^2 - 1/7*x^2 + 1/9*y^2 - 1/100";

/// A text and its box in units: left, right, top and bottom.
#[derive(Debug)]
struct Placed {
    text: String,
    sides: [f64; 4],
}

/// The size of a picture and its texts.
fn placed(svg: &str) -> ([f64; 2], Vec<Placed>) {
    let document = roxmltree::Document::parse(svg).unwrap();
    let root = document.root_element();
    let number = |node: &roxmltree::Node<'_, '_>, name: &str| -> f64 {
        node.attribute(name).unwrap().parse().unwrap()
    };
    let finer = f64::from(super::units::FINER);
    let texts = document.descendants().filter(|n| n.has_tag_name("text"));
    let texts = texts.map(|node| {
        let text = node.text().unwrap_or_default().trim().to_owned();
        let [x, y, size] = ["x", "y", "font-size"].map(|name| number(&node, name) / finer);
        // The drawing library draws letters smaller than the size that they are measured with.
        let width = text_width(&text, 1000) * size * 1.164 / 1000.0;
        let before = match node.attribute("text-anchor").unwrap() {
            "start" => 0.0,
            "middle" => width / 2.0,
            _ => width,
        };
        let (left, right) = (-before, width - before);
        let (top, bottom) = match node.attribute("dy").unwrap() {
            "0.76em" => (0.0, 0.76 * size),
            "0.5ex" => (-0.5 * size, 0.3 * size),
            _ => (-size, 0.0),
        };
        let sides = if node
            .attribute("transform")
            .is_some_and(|t| t.contains("270"))
        {
            [x + top, x + bottom, y - right, y - left]
        } else {
            [x + left, x + right, y + top, y + bottom]
        };
        Placed { text, sides }
    });
    (
        [number(&root, "width"), number(&root, "height")],
        texts.collect(),
    )
}

fn check(svg: &str) -> std::result::Result<(), TestCaseError> {
    let ([width, height], texts) = placed(svg);
    for Placed { text, sides } in &texts {
        let [left, right, top, bottom] = *sides;
        let is_inside = left >= 0.0 && right <= width && top >= 0.0 && bottom <= height;
        prop_assert!(
            is_inside,
            "{} at {:?} in {} x {}",
            text,
            sides,
            width,
            height
        );
    }
    for (k, a) in texts.iter().enumerate() {
        for b in &texts[k + 1..] {
            let apart = a.sides[1] <= b.sides[0]
                || b.sides[1] <= a.sides[0]
                || a.sides[3] <= b.sides[2]
                || b.sides[3] <= a.sides[2];
            prop_assert!(apart, "{:?} and {:?}", a, b);
        }
    }
    Ok(())
}

/// A range of numbers of any size, near 0 or far away from it.
fn range() -> impl Strategy<Value = [f64; 2]> {
    let far = prop_oneof![Just(0.0), -1.0f64..1.0, (-1e9f64..1e9), Just(1e15)];
    (far, 0.1f64..10.0, -0.5f64..0.5, -90i32..=90).prop_map(|(far, size, shift, exponent)| {
        let power = 10f64.powi(exponent);
        let low = (far + shift * size) * power;
        [low, low + size * power]
    })
}

fn figure(width: u32, window: Window) -> Figure {
    Figure {
        title: "A title that has several words and does not fit into a narrow picture".into(),
        width,
        window,
        layers: [FORMULA, "outline, a_file_name_without_any_blanks_in_it_that_is_too_long_for_a_line_of_a_legend.csv"]
            .map(|label| Layer {
                label: label.into(),
                ..Layer::default()
            })
            .into(),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn all_letters_of_a_figure_are_inside(x in range(), aspect in 0.1f64..10.0, far in -1e6f64..1e6, width in 300u32..=1200) {
        let size = (x[1] - x[0]) * aspect;
        let y = [far * size, far * size + size];
        check(&figure(width, Window { x, y }).to_svg().unwrap())?;
    }

    #[test]
    fn all_letters_of_a_chart_are_inside(x in range(), y in range()) {
        let chart = Chart {
            title: String::new(),
            labels: ["x".into(), "correct digits".into()],
            y,
            logarithmic: false,
            series: vec![Series { points: vec![[x[0], y[0]], [x[1], y[1]]], ..Series::default() }],
        };
        check(&chart.to_svg().unwrap())?;
    }

    #[test]
    fn all_letters_of_a_scene_are_inside(
        x in range(),
        shares in prop::array::uniform2(0.2f64..1.0),
        azimuth in 0.0f64..360.0,
        elevation in 5.0f64..60.0,
        width in 300u32..=1200,
    ) {
        let size = x[1] - x[0];
        let scene = Scene {
            title: String::new(),
            width,
            bounds: Some([x, [0.0, shares[0] * size], [-size, (shares[1] - 1.0) * size]]),
            azimuth,
            elevation,
            layers: vec![SpaceLayer { label: FORMULA.into(), ..SpaceLayer::default() }],
        };
        check(&scene.to_svg().unwrap())?;
    }
}

#[test]
fn a_legend_names_the_whole_formula() {
    let unit = Window {
        x: [0.0, 1.0],
        y: [0.0, 1.0],
    };
    for width in [300, 420, 900] {
        let (_, texts) = placed(&figure(width, unit).to_svg().unwrap());
        let all: Vec<&str> = texts.iter().map(|placed| placed.text.as_str()).collect();
        let without_blanks = |text: &str| text.split_whitespace().collect::<String>();
        let formula = without_blanks(FORMULA);
        assert!(without_blanks(&all.concat()).contains(&formula), "{all:?}");
    }
}
