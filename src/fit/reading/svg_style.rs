//! What attributes and style sheets say of the elements of a drawing: whether they are drawn, and where.

use roxmltree::{Document, Node};
use simplecss::{
    AttributeOperator, Declaration, DeclarationTokenizer, Element, PseudoClass, StyleSheet,
};
use svgtypes::{Length, LengthUnit, Paint};

/// Properties that move a shape in ways that are not read.
const NOT_READ: [&str; 4] = ["translate", "rotate", "scale", "transform-box"];

/// Properties that are read.
const READ: [&str; 10] = [
    "display",
    "visibility",
    "opacity",
    "fill",
    "fill-opacity",
    "stroke",
    "stroke-opacity",
    "stroke-width",
    "transform",
    "transform-origin",
];
/// The largest number of rules that paint, hide or move shapes: each is compared with every element.
const MAX_RULES: usize = 1000;

/// The rules of a drawing's style sheets that paint, hide or move shapes.
pub(super) struct Styles<'input>(StyleSheet<'input>);

/// How an element is drawn, which the elements in it inherit.
#[derive(Clone, Copy)]
pub(super) struct Look {
    pub(super) is_visible: bool,
    /// Whether there is a paint to fill shapes, and whether it is opaque.
    fill: [bool; 2],
    /// Whether there is a paint for lines, whether it is opaque, and whether lines have a width.
    stroke: [bool; 3],
}

impl Look {
    /// That of a drawing which says nothing of it.
    pub(super) const INITIAL: Self = Self {
        is_visible: true,
        fill: [true; 2],
        stroke: [false, true, true],
    };

    /// Whether a shape is filled, or has a line around it.
    pub(super) fn paints(self) -> bool {
        let all = |parts: &[bool]| parts.iter().all(|part| *part);
        all(&self.fill) || all(&self.stroke)
    }
}

/// The system of an element in that of its parent, as texts.
pub(super) struct Placement<'a> {
    pub(super) transform: Option<&'a str>,
    /// The point about which it is applied.
    pub(super) origin: [f64; 2],
}

impl<'input> Styles<'input> {
    /// # Errors
    /// A message for more than 1000 such rules.
    pub(super) fn of(document: &'input Document<'_>) -> Result<Self, String> {
        let mut sheet = StyleSheet::new();
        let elements = document.descendants();
        for style in elements.filter(|node| node.tag_name().name() == "style") {
            for text in style.children().filter_map(|node| node.text()) {
                sheet.parse_more(text);
            }
        }
        let declarations = || sheet.rules.iter().flat_map(|rule| &rule.declarations);
        let hides_by_opacity = declarations().any(|d| d.name == "opacity" && is_zero(d.value));
        let is_relevant = |name: &str| match name {
            "opacity" => hides_by_opacity,
            _ => READ.contains(&name) || NOT_READ.contains(&name),
        };
        sheet
            .rules
            .retain(|rule| rule.declarations.iter().any(|d| is_relevant(d.name)));
        if sheet.rules.len() > MAX_RULES {
            return Err(format!(
                "the style sheets have more than {MAX_RULES} rules that paint, hide or move shapes"
            ));
        }
        Ok(Self(sheet))
    }

    /// What is said of an element.
    pub(super) fn of_element<'a, 'node>(
        &'a self,
        node: Node<'a, 'node>,
    ) -> ElementStyle<'a, 'node> {
        let rules = self.0.rules.iter();
        let rules = rules.filter(|rule| rule.selector.matches(&Styled(node)));
        let of_rules = rules.flat_map(|rule| rule.declarations.iter().copied());
        // An element without a style of its own declares nothing.
        let own = DeclarationTokenizer::from(node.attribute("style").unwrap_or_default());
        ElementStyle {
            node,
            declarations: of_rules.chain(own).collect(),
        }
    }
}

/// An element, and what style sheets and then its own style declare for it.
pub(super) struct ElementStyle<'a, 'node> {
    node: Node<'a, 'node>,
    declarations: Vec<Declaration<'a>>,
}

impl<'a> ElementStyle<'a, '_> {
    /// The value of a property: what is important, what its own style says, what rules say, and what its attribute says, in this
    /// order; the later one of two.
    fn property(&self, name: &str) -> Option<&'a str> {
        let all = || self.declarations.iter().rev().filter(|d| d.name == name);
        let declared = all().find(|d| d.important).or_else(|| all().next());
        let declared = declared.map(|d| d.value.trim());
        declared.or_else(|| self.node.attribute(name))
    }

    /// Whether an element and what is in it are drawn, and not wholly transparent.
    pub(super) fn is_displayed(&self) -> bool {
        self.property("display") != Some("none") && !self.property("opacity").is_some_and(is_zero)
    }

    /// How an element is drawn inside of what is drawn like this: as it says itself, or else as what is around it.
    pub(super) fn look(&self, around: Look) -> Look {
        let own = |name: &str| self.property(name).filter(|value| *value != "inherit");
        let opaque = |name: &str, before: bool| own(name).map_or(before, |value| !is_zero(value));
        let paint = |name: &str, before: bool| own(name).map_or(before, is_paint);
        Look {
            is_visible: own("visibility").map_or(around.is_visible, |value| {
                !matches!(value, "hidden" | "collapse")
            }),
            fill: [
                paint("fill", around.fill[0]),
                opaque("fill-opacity", around.fill[1]),
            ],
            stroke: [
                paint("stroke", around.stroke[0]),
                opaque("stroke-opacity", around.stroke[1]),
                opaque("stroke-width", around.stroke[2]),
            ],
        }
    }

    /// Where an element is, in the system of its parent.
    ///
    /// # Errors
    /// A message for a property that moves it in a way that is not read.
    pub(super) fn placement(&self) -> Result<Placement<'a>, String> {
        let mut others = NOT_READ.iter();
        let other = others.find(|name| {
            let by_attribute = self.node.attribute(**name);
            self.property(name)
                .filter(|value| by_attribute != Some(value))
                .is_some()
        });
        if let Some(name) = other {
            return Err(format!(
                "the property {name} of a style is not read; transform is"
            ));
        }
        let transform = self.property("transform").filter(|text| *text != "none");
        let origin = match self.property("transform-origin") {
            Some(text) if transform.is_some() => origin(text)?,
            _ => [0.0; 2],
        };
        Ok(Placement { transform, origin })
    }
}

/// Whether an opacity or a width is 0, or less, which is the same.
fn is_zero(value: &str) -> bool {
    let end = |c: char| c == '%' || c.is_alphabetic();
    let number = value.trim().trim_end_matches(end).parse::<f64>();
    number.is_ok_and(|number| number <= 0.0)
}

/// Whether a shape with this paint can be seen.
fn is_paint(value: &str) -> bool {
    match Paint::from_str(value) {
        Ok(Paint::None) => false,
        Ok(Paint::Color(color)) => color.alpha > 0,
        _ => true,
    }
}

/// Two lengths in units of the drawing.
fn origin(text: &str) -> Result<[f64; 2], String> {
    let wrong =
        || format!("transform-origin=\"{text}\": expected two lengths in px, such as 10 20");
    let lengths: Vec<f64> = text
        .split_whitespace()
        .map(|part| match part.parse::<Length>() {
            Ok(length) if matches!(length.unit, LengthUnit::None | LengthUnit::Px) => {
                Ok(length.number)
            }
            _ => Err(wrong()),
        })
        .collect::<Result<_, _>>()?;
    lengths.try_into().map_err(|_| wrong())
}

/// An element, as selectors see it.
struct Styled<'a, 'input>(Node<'a, 'input>);

impl Element for Styled<'_, '_> {
    fn parent_element(&self) -> Option<Self> {
        self.0.parent_element().map(Self)
    }

    fn prev_sibling_element(&self) -> Option<Self> {
        self.0.prev_sibling_element().map(Self)
    }

    fn has_local_name(&self, name: &str) -> bool {
        self.0.tag_name().name() == name
    }

    fn attribute_matches(&self, name: &str, operator: AttributeOperator<'_>) -> bool {
        self.0
            .attribute(name)
            .is_some_and(|value| operator.matches(value))
    }

    fn pseudo_class_matches(&self, class: PseudoClass<'_>) -> bool {
        matches!(class, PseudoClass::FirstChild) && self.0.prev_sibling_element().is_none()
    }
}
