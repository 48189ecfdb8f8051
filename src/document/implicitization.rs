//! What is said of an equation that was found from a parametric form.

use serde_json::{Value, json};

use super::implicit::polynomial_text;
use super::{Annotations, Coordinates, Format};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::implicitize::{
    Coverage, IsolatedPoint, PlaneEquation, PointBeyond, PolarFactor, PolarInverse, PolarPatch,
    PolarPlane, PolarSpaceCurve, PolarSurface, RealImage, Run, SpaceCurveEquations,
    SurfaceEquation,
};
use crate::shape::ParametricCurve;

impl Annotations {
    /// Of the equation of a plane curve.
    #[must_use]
    pub fn of_plane(equation: &PlaneEquation, run: Run) -> Self {
        let mut annotations = Self::default();
        let degree = equation.curve.polynomial().degree();
        let degree = degree.invariant("an equation is not 0");
        annotations.irreducible(degree as u64);
        annotations.tracing_index(run.count(equation.tracing_index));
        annotations
    }

    fn irreducible(&mut self, degree: u64) {
        self.notes.push(format!(
            "the irreducible equation, of degree {degree}; that it vanishes identically is proved by substitution"
        ));
        self.fields.push(("irreducible", json!(true)));
    }

    /// Of the equation of a patch.
    #[must_use]
    pub fn of_patch(equation: &SurfaceEquation, run: Run) -> Self {
        let mut annotations = Self::default();
        let degree = equation.surface.polynomial().degree();
        annotations.irreducible(degree.invariant("an equation is not 0"));
        match equation
            .tracing_index
            .and_then(|index| run.checked_count(index))
        {
            Some(index) => {
                annotations.notes.push(format!(
                    "tracing index {index}: a general point of the surface has {index} parameter {} (complex ones \
                     included; counted at random points modulo a prime, not proved)",
                    if index == 1 { "value" } else { "values" }
                ));
                annotations.fields.push(("tracing_index", json!(index)));
                annotations
                    .fields
                    .push(("tracing_index_proved", json!(false)));
            }
            None => annotations
                .notes
                .push("the tracing index was not found: counts at random points disagree".into()),
        }
        annotations
    }

    /// Of the equations of a space curve.
    #[must_use]
    pub fn of_space_curve(equations: &SpaceCurveEquations, run: Run) -> Self {
        let mut annotations = Self::default();
        annotations.notes.push(format!(
            "these equations generate all polynomials that vanish on the curve: they cut out the curve alone, of degree {}",
            equations.degree
        ));
        annotations
            .fields
            .push(("curve_degree", json!(equations.degree)));
        // These surfaces have nothing else in common; what the paper's two have is added with them.
        annotations.fields.push(("components", json!([])));
        annotations.tracing_index(run.count(equations.tracing_index));
        annotations
    }

    fn tracing_index(&mut self, index: usize) {
        self.notes.push(format!(
            "tracing index {index}: the parametrization runs over the curve {}",
            times(index)
        ));
        self.fields.push(("tracing_index", json!(index)));
    }

    /// Adds how many real values of the parameter have a general point of what they reach: one number, or several if that
    /// is not the same everywhere; `counts` and `tracing_index` count values of s. It is said in words only if it is another
    /// number than the tracing index.
    pub fn add_real_tracing(&mut self, counts: Option<&[usize]>, run: Run, tracing_index: usize) {
        let counts: Option<Vec<usize>> =
            counts.map(|counts| counts.iter().map(|&count| run.count(count)).collect());
        let tracing_index = run.count(tracing_index);
        let index = match counts.as_deref() {
            Some([index]) => {
                if *index != tracing_index {
                    self.notes.push(format!(
                        "real tracing index {index}: real values of the parameter run {} over what they reach",
                        times(*index)
                    ));
                }
                json!(index)
            }
            Some(several) => {
                let all: Vec<String> = several.iter().map(|&k| times(k)).collect();
                self.notes.push(format!(
                    "there is no one real tracing index: real values of the parameter run over some arcs of the curve {}",
                    all.join(", over others ")
                ));
                self.fields.push(("real_tracing_indices", json!(several)));
                Value::Null
            }
            None => {
                self.notes
                    .push("the real tracing index was not found".into());
                Value::Null
            }
        };
        self.fields.push(("real_tracing_index", index));
    }

    /// Adds the form that the equation came from.
    pub fn add_coordinates(&mut self, coordinates: &Coordinates) {
        let formulas = coordinates.formulas(Format::Text);
        let rows = ["x", "y", "z"].into_iter().zip(&formulas);
        let rows: Vec<String> = rows.map(|(name, f)| format!("{name} = {f}")).collect();
        self.notes
            .insert(0, format!("parametric form: {}", rows.join("; ")));
        self.fields
            .push(("parameters", json!(coordinates.parameters())));
        self.fields
            .push(("coordinates", json!(coordinates.fields())));
    }

    /// Adds what the zero set of a curve has beyond the points of real parameters.
    pub fn add_real_image<const N: usize>(
        &mut self,
        curve: &ParametricCurve<N>,
        image: &RealImage<N>,
        run: Run,
        tracing_index: usize,
    ) {
        self.add_real_tracing(image.real_counts.as_deref(), run, tracing_index);
        let name = curve.parameter().name();
        let exact = |p: &[Rational; N]| tuple(p.iter().map(ToString::to_string));
        let near = |p: &[f64; 2]| format!("≈ {}", tuple(p.iter().map(|v| format!("{v:.12}"))));
        let mut beyond = Vec::new();
        if let Some(point) = &image.approached {
            let point = exact(point);
            self.notes.push(format!(
                "beyond the real image: {point} is only approached, as {name} goes to infinity"
            ));
            beyond.push(json!({"kind": "approached", "point": point}));
        }
        match &image.coverage {
            Coverage::Whole => {}
            Coverage::Part(turns) => {
                let turns = turns.iter().map(|&s| turning_point(curve, s));
                let mut turns: Vec<String> = turns.collect();
                turns.sort();
                turns.dedup();
                self.notes.push(format!(
                    "beyond the real image: real values of {name} turn back at {}, the curve goes on",
                    turns.join(" and ")
                ));
                beyond.push(json!({"kind": "part", "turning_points": turns}));
            }
            Coverage::Unknown => self.notes.push(format!(
                "whether real values of {name} reach the whole real curve is not decided"
            )),
        }
        for point in &image.isolated.points {
            let point = match point {
                IsolatedPoint::Exact(point) => tuple(point.iter().map(ToString::to_string)),
                IsolatedPoint::Near(point) => near(point),
            };
            self.notes.push(format!(
                "beyond the real image: {point} is an isolated real point, of two conjugate complex {name}"
            ));
            beyond.push(json!({"kind": "isolated", "point": point}));
        }
        if N == 2 && !image.isolated.complete {
            self.notes
                .push("there may be more isolated real points: not all pairs of conjugate complex parameters were decided".into());
        }
        self.fields.push(("beyond", json!(beyond)));
    }

    /// Adds a point of the zero set that is not on the patch.
    pub fn add_point_beyond(&mut self, found: Option<&PointBeyond>) {
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
        let point = tuple(found.point.iter().map(ToString::to_string));
        self.notes.push(format!(
            "beyond the patch: {range} on the patch, but the zero set has the point ≈ {point} (two coordinates exact, \
             the third the double nearest to an exact root)"
        ));
        let entry = json!([{"kind": "point", "point": point, "bound": range}]);
        self.fields.push(("beyond", entry));
    }

    /// Adds what Theorem 1 gave.
    pub fn add_polar_plane(&mut self, polar: &PolarPlane) {
        self.polar(
            ["Theorem 1, Eq. (1)", "x^2 + y^2", "y/x"],
            &polar.inverse,
            &polar.factors,
        );
    }

    /// Adds what Theorem 4 gave.
    pub fn add_polar_patch(&mut self, polar: &PolarPatch) {
        let names = ["Theorem 4, Eq. (15)", "x^2 + y^2 + z^2", "y/x and z/x"];
        self.polar(names, &polar.inverse, &polar.factors);
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
                self.notes.push(format!("{statement}: {radius} = {right}"));
                json!({"squared_radius": [above, below], "factors": factors_json})
            }
            PolarInverse::Relation(reason) => {
                self.notes.push(format!(
                    "{statement}: {reason}; a polynomial relation between {direction} and {radius} is taken instead"
                ));
                json!({"reason": reason, "factors": factors_json})
            }
        };
        self.notes
            .push("cleared of denominators it has the factors".into());
        self.notes.extend(factors.iter().map(factor_text));
        self.fields.push(("polar", entry));
    }

    /// Adds what Theorem 3 gave.
    pub fn add_polar_space_curve(&mut self, polar: &PolarSpaceCurve) {
        let mut surfaces = Vec::new();
        for (name, surface) in [("Eq. (10)", &polar.first), ("Eq. (11)", &polar.second)] {
            match surface {
                Ok(surface) => {
                    self.notes.push(format!(
                        "Theorem 3, {name}, cleared of denominators: {} = 0, with the factors",
                        polynomial_text(&surface.equation)
                    ));
                    self.notes.extend(surface.factors.iter().map(factor_text));
                    surfaces.push(surface_json(name, surface));
                }
                Err(reason) => {
                    self.notes.push(format!("Theorem 3, {name}: {reason}"));
                    surfaces.push(json!({"equation": name, "reason": reason}));
                }
            }
        }
        for [on, also] in &polar.components {
            self.notes.push(format!(
                "spurious component of the two surfaces: {} = 0 on {} = 0",
                polynomial_text(also),
                polynomial_text(on)
            ));
        }
        let components = polar
            .components
            .iter()
            .map(|[on, also]| json!([polynomial_text(on), polynomial_text(also)]));
        let components: Vec<Value> = components.collect();
        self.fields.push(("polar", json!({"surfaces": surfaces})));
        self.fields.retain(|(name, _)| *name != "components");
        self.fields.push(("components", json!(components)));
    }
}

/// Once, twice, three times …
fn times(count: usize) -> String {
    match count {
        1 => "once".into(),
        2 => "twice".into(),
        n => format!("{n} times"),
    }
}

fn tuple(coordinates: impl Iterator<Item = String>) -> String {
    format!("({})", coordinates.collect::<Vec<_>>().join(", "))
}

/// The point at a rounded parameter value.
fn turning_point<const N: usize>(curve: &ParametricCurve<N>, s: f64) -> String {
    let point = match Rational::try_from(s) {
        Ok(s) => curve.point(&s),
        Err(_) => curve.point_at_infinity(),
    };
    match point {
        Some(point) => format!("≈ {}", tuple(point.iter().map(|v| v.to_f64().to_string()))),
        None => "infinity".into(),
    }
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
