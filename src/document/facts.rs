//! The facts about an answer, as sentences and as fields of JSON documents.

use serde_json::{Value, json};

use super::Coordinates;
use super::fit_report::least_squares_sentence;
use super::remark::{part_text, rounding_note};
use crate::exact::Rational;
use crate::implicitize::{
    EquationProof, IsolatedPoint, PointBeyond, PolarFactor, PolarInverse, PolarSurface,
};
use crate::notation::{Format, polynomial_text};
use crate::poly::SparsePolynomial;
use crate::shape::Form;
use crate::verb::{BeyondCurve, Fact, FitReport, PolarTheorem, Reach};

/// The sentences and fields of a document besides the answer itself.
#[derive(Debug, Default)]
pub(super) struct Annotations {
    /// Sentences for the reader: they are comments, or the field `notes` of a JSON document.
    pub(super) notes: Vec<String>,
    /// Further fields of the JSON document.
    pub(super) fields: Vec<(&'static str, Value)>,
}

impl From<&[Fact]> for Annotations {
    fn from(facts: &[Fact]) -> Self {
        let mut annotations = Self::default();
        for fact in facts {
            annotations.add(fact);
        }
        annotations
    }
}

impl Annotations {
    fn note(&mut self, text: impl Into<String>) {
        self.notes.push(text.into());
    }

    fn field(&mut self, name: &'static str, value: Value) {
        self.fields.push((name, value));
    }

    fn add(&mut self, fact: &Fact) {
        match fact {
            Fact::Parametric(form) => self.parametric(form),
            Fact::Outline {
                vertices,
                area,
                centroid: [x, y],
            } => self.note(format!(
                "a contour of {vertices} vertices, area ≈ {area}, centroid ≈ ({x}, {y}); what follows is the fit of a Fourier series"
            )),
            Fact::Fit(report) => self.fit(report),
            Fact::PerfectSquare => self.note(super::remark::PERFECT_SQUARE),
            Fact::Harmonics(degree) => self.note(format!(
                "the equation of a harmonic surface of degree {degree}: Eqs. (7) and (8) with solid harmonics"
            )),
            Fact::RoundedRadius(bound) => self.note(rounding_note(bound)),
            Fact::Irreducible { degree, proof } => {
                let proof = match proof {
                    EquationProof::Substitution => {
                        "that it vanishes identically is proved by substitution"
                    }
                    EquationProof::CoefficientBound => {
                        "it is the resultant, computed modulo more primes than its coefficients can need"
                    }
                };
                self.note(format!(
                    "the irreducible equation, of degree {degree}; {proof}"
                ));
                self.field("irreducible", json!(true));
            }
            Fact::TracingIndex(index) => {
                self.note(format!(
                    "tracing index {index}: the parametrization runs over the curve {}",
                    times(*index)
                ));
                self.field("tracing_index", json!(index));
            }
            Fact::PatchTracingIndex(index) => self.patch_tracing_index(*index),
            Fact::CutsOutCurve(degree) => {
                self.note(format!(
                    "these equations generate all polynomials that vanish on the curve: they cut out the curve alone, of degree {degree}"
                ));
                self.field("curve_degree", json!(degree));
                // These surfaces have no other component in common; the components of the paper's two surfaces are added with
                // these surfaces.
                self.field("components", json!([]));
            }
            Fact::RealTracing { counts, complex } => self.real_tracing(counts.as_deref(), *complex),
            Fact::BeyondCurve(beyond) => self.beyond_curve(beyond),
            Fact::TopologyOfEquation => self.note(
                "the components, their extents, singular points and asymptotes are those of the equation, which has more real \
                 points than the curve",
            ),
            Fact::BeyondPatch(found) => self.beyond_patch(found.as_ref()),
            Fact::Polar {
                theorem,
                inverse,
                factors,
            } => self.polar(
                match theorem {
                    PolarTheorem::One => ["Theorem 1, Eq. (1)", "x^2 + y^2", "y/x"],
                    PolarTheorem::Four => {
                        ["Theorem 4, Eq. (15)", "x^2 + y^2 + z^2", "y/x and z/x"]
                    }
                },
                inverse,
                factors,
            ),
            Fact::PolarSpaceCurve {
                surfaces,
                components,
            } => self.polar_space_curve(surfaces, components),
            Fact::Missing(part) => self.note(format!(
                "not finished within the limits: {}",
                part_text(*part)
            )),
        }
    }

    fn fit(&mut self, report: &FitReport) {
        if let Some(radial) = &report.radial {
            self.note(format!(
                "radial error of the fit ≈ {:.3e} at most, ≈ {:.3e} rms",
                radial.max_error, radial.rms_error
            ));
            if let Some(seen) = radial.outline {
                self.field("outline_star_shaped", json!(seen.star_shaped));
                self.field("hidden_share", json!(seen.hidden_share));
            }
        }
        if let Some(found) = &report.least_squares {
            self.note(least_squares_sentence(found));
        }
        if let Some(power) = report.harmonic_power {
            self.note(format!(
                "the harmonics of the fit have ≈ {:.6} of the power of all harmonics",
                power
            ));
            self.field("harmonic_power", json!(power));
        }
    }

    fn patch_tracing_index(&mut self, index: Option<usize>) {
        let Some(index) = index else {
            self.note("the tracing index was not found: counts at random points disagree");
            return;
        };
        self.note(format!(
            "tracing index {index}: a general point of the surface has {index} parameter {} (complex ones \
             included; counted at random points modulo a prime, not proved)",
            if index == 1 { "value" } else { "values" }
        ));
        self.field("tracing_index", json!(index));
        self.field("tracing_index_proved", json!(false));
    }

    /// A sentence is written only if the number of real parameter values differs from that of complex ones.
    fn real_tracing(&mut self, counts: Option<&[usize]>, complex: usize) {
        let index = match counts {
            Some([index]) => {
                if *index != complex {
                    self.note(format!(
                        "real tracing index {index}: real values of the parameter run {} over what they reach",
                        times(*index)
                    ));
                }
                json!(index)
            }
            Some(several) => {
                let all: Vec<String> = several.iter().map(|&k| times(k)).collect();
                self.note(format!(
                    "there is no one real tracing index: real values of the parameter run over some arcs of the curve {}",
                    all.join(", over others ")
                ));
                self.field("real_tracing_indices", json!(several));
                Value::Null
            }
            None => {
                self.note("the real tracing index was not found");
                Value::Null
            }
        };
        self.field("real_tracing_index", index);
    }

    fn parametric(&mut self, form: &Form) {
        let coordinates = match form {
            Form::PlaneCurve(curve) => Coordinates::from(curve),
            Form::SpaceCurve(curve) => Coordinates::from(curve),
            Form::Patch(patch) => Coordinates::from(patch),
            _ => return,
        };
        let formulas = coordinates.formulas(Format::Text);
        let rows = ["x", "y", "z"].into_iter().zip(&formulas);
        let rows: Vec<String> = rows.map(|(name, f)| format!("{name} = {f}")).collect();
        self.note(format!("parametric form: {}", rows.join("; ")));
        self.field("parameters", json!(coordinates.parameters()));
        self.field("coordinates", json!(coordinates.fields()));
    }

    fn beyond_curve(&mut self, found: &BeyondCurve) {
        let name = &found.parameter;
        let mut beyond = Vec::new();
        if let Some(point) = &found.approached {
            let point = tuple(point);
            self.note(format!(
                "beyond the real image: {point} is only approached, as {name} goes to infinity"
            ));
            beyond.push(json!({"kind": "approached", "point": point}));
        }
        match &found.reach {
            Reach::Whole => {}
            Reach::TurnsBack(turns) => {
                let at = |point: &Option<Vec<f64>>| match point {
                    Some(point) => format!("≈ {}", tuple(point)),
                    None => "infinity".into(),
                };
                let mut turns: Vec<String> = turns.iter().map(at).collect();
                turns.sort_unstable();
                turns.dedup();
                self.note(format!(
                    "beyond the real image: real values of {name} turn back at {}, the curve goes on",
                    turns.join(" and ")
                ));
                beyond.push(json!({"kind": "part", "turning_points": turns}));
            }
            Reach::Unknown => self.note(format!(
                "whether real values of {name} reach the whole real curve is not decided"
            )),
        }
        for point in &found.isolated {
            let point = match point {
                IsolatedPoint::Exact(point) => tuple(point),
                IsolatedPoint::Near(point) => {
                    let rounded: Vec<String> = point.iter().map(|v| format!("{v:.12}")).collect();
                    format!("≈ {}", tuple(&rounded))
                }
            };
            self.note(format!(
                "beyond the real image: {point} is an isolated real point, of conjugate complex {name}"
            ));
            beyond.push(json!({"kind": "isolated", "point": point}));
        }
        if !found.are_all {
            self.note("there may be more isolated real points: not all pairs of conjugate complex parameters were decided");
        }
        self.field("beyond", json!(beyond));
    }

    fn beyond_patch(&mut self, found: Option<&PointBeyond>) {
        let Some(found) = found else {
            return;
        };
        let name = ["x", "y", "z"][found.coordinate];
        let range = match &found.bounds {
            [Some(low), Some(high)] => format!("{low} <= {name} <= {high}"),
            [Some(low), None] => format!("{name} >= {low}"),
            [None, Some(high)] => format!("{name} <= {high}"),
            [None, None] => return,
        };
        let point = tuple(&found.point);
        self.note(format!(
            "beyond the patch: {range} on the patch, but the zero set has the point ≈ {point} (two coordinates exact, \
             the third the double nearest to an exact root)"
        ));
        let entry = json!([{"kind": "point", "point": point, "bound": range}]);
        self.field("beyond", entry);
    }

    fn polar(
        &mut self,
        [statement, radius, direction]: [&str; 3],
        inverse: &PolarInverse,
        factors: &[PolarFactor],
    ) {
        let factors_json: Vec<Value> = factors.iter().map(factor_json).collect();
        let entry = match inverse {
            PolarInverse::Function([above, below]) => {
                let whole = below.as_constant().is_some_and(|c| c == Rational::one());
                let (above, below) = (polynomial_text(above), polynomial_text(below));
                let right = if whole {
                    above.clone()
                } else {
                    format!("({above})/({below})")
                };
                self.note(format!("{statement}: {radius} = {right}"));
                json!({"squared_radius": [above, below], "factors": factors_json})
            }
            PolarInverse::Relation(reason) => {
                self.note(format!(
                    "{statement}: {reason}; a polynomial relation between {direction} and {radius} is taken instead"
                ));
                json!({"reason": reason, "factors": factors_json})
            }
        };
        self.note("cleared of denominators it has the factors");
        self.notes.extend(factors.iter().map(factor_text));
        self.field("polar", entry);
    }

    fn polar_space_curve(
        &mut self,
        both: &[Result<PolarSurface, String>; 2],
        components: &[[SparsePolynomial<3>; 2]],
    ) {
        let mut surfaces = Vec::new();
        for (name, surface) in ["Eq. (10)", "Eq. (11)"].into_iter().zip(both) {
            match surface {
                Ok(surface) => {
                    self.note(format!(
                        "Theorem 3, {name}, cleared of denominators: {} = 0, with the factors",
                        polynomial_text(&surface.equation)
                    ));
                    self.notes.extend(surface.factors.iter().map(factor_text));
                    surfaces.push(surface_json(name, surface));
                }
                Err(reason) => {
                    self.note(format!("Theorem 3, {name}: {reason}"));
                    surfaces.push(json!({"equation": name, "reason": reason}));
                }
            }
        }
        for [on, also] in components {
            self.note(format!(
                "spurious component of the two surfaces: {} = 0 on {} = 0",
                polynomial_text(also),
                polynomial_text(on)
            ));
        }
        let pair = |[on, also]: &[SparsePolynomial<3>; 2]| {
            json!([polynomial_text(on), polynomial_text(also)])
        };
        let components: Vec<Value> = components.iter().map(pair).collect();
        self.field("polar", json!({"surfaces": surfaces}));
        self.fields.retain(|(name, _)| *name != "components");
        self.field("components", json!(components));
    }
}

/// The word for a number of times: once, twice, three times and so on.
fn times(count: usize) -> String {
    match count {
        1 => "once".into(),
        2 => "twice".into(),
        n => format!("{n} times"),
    }
}

fn tuple(coordinates: &[impl ToString]) -> String {
    let coordinates: Vec<String> = coordinates.iter().map(ToString::to_string).collect();
    format!("({})", coordinates.join(", "))
}

fn factor_text(factor: &PolarFactor) -> String {
    let power = match factor.multiplicity {
        1 => String::new(),
        m => format!(", multiplicity {m}"),
    };
    format!(
        "  {}{power}: {}",
        polynomial_text(&factor.polynomial),
        factor.role.describe()
    )
}

fn factor_json(factor: &PolarFactor) -> Value {
    json!({
        "polynomial": polynomial_text(&factor.polynomial),
        "multiplicity": factor.multiplicity,
        "role": factor.role.name(),
    })
}

fn surface_json(name: &str, surface: &PolarSurface) -> Value {
    json!({
        "equation": name,
        "polynomial": polynomial_text(&surface.equation),
        "factors": surface.factors.iter().map(factor_json).collect::<Vec<_>>(),
    })
}
