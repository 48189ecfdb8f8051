//! Questions about equations (§2 of the paper) and about homogeneous parts.

use super::{Answer, form, joined, parts, polynomial, text_of, wrong_subject};
use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::factor::{factor_plane, factor_space};
use crate::fit::{ContourKind, FitOptions, FitSize, contour_from_reader, fit_within};
use crate::implicitize::{
    PolarFactor, Role, SquaredForm, SquaredHarmonics, implicitize_patch, implicitize_plane,
    implicitize_space_curve, parity_sums, polar_patch, polar_plane, polar_space_curve, square_away,
};
use crate::limits::Limits;
use crate::paper::data::example;
use crate::paper::formula::Formula;
use crate::paper::identity::{Comparison, Meanings};
use crate::poly::{PlanePolynomial, Ring, SparsePolynomial};
use crate::shape::{Form, FourierRadius, ImplicitCurve};

type Equation = SparsePolynomial<3>;

/// The curve of an equation in x and y, or of a radius by Theorem 2.
pub(super) fn curve(subject: &str) -> Result<ImplicitCurve> {
    match form(subject)? {
        Form::Curve(curve) => Ok(curve),
        Form::Fourier(radius) => Ok(SquaredForm::new(&radius)?.expand()),
        _ => Err(wrong_subject(subject, "a plane curve or a Fourier radius")),
    }
}

pub(super) fn fourier(subject: &str) -> Result<FourierRadius> {
    match form(subject)? {
        Form::Fourier(radius) => Ok(radius),
        _ => Err(wrong_subject(subject, "a Fourier radius")),
    }
}

/// The polynomial of Theorem 2 in space for a sum of spherical harmonics.
pub(super) fn harmonic(subject: &str) -> Result<SquaredHarmonics> {
    match form(subject)? {
        Form::Harmonic(surface) => SquaredHarmonics::new(&surface),
        _ => Err(wrong_subject(subject, "a sum of spherical harmonics")),
    }
}

/// The degrees of the homogeneous parts of the polynomial of a plane curve, or of a sum of spherical harmonics.
fn degrees_of(subject: &str) -> Result<Vec<usize>> {
    if let Form::Harmonic(_) = form(subject)? {
        let surface = harmonic(subject)?.expand();
        return Ok(surface.by_degree().homogeneous_degrees());
    }
    Ok(curve(subject)?.polynomial().homogeneous_degrees())
}

pub(super) fn equation(subject: &str, claimed: &str, limits: &Limits) -> Result<Answer> {
    let found: Vec<Equation> = match form(subject)? {
        Form::PlaneCurve(curve) => vec![Equation::from(
            implicitize_plane(&curve, limits)?.curve.polynomial(),
        )],
        Form::Patch(patch) => vec![
            implicitize_patch(&patch, limits)?
                .surface
                .polynomial()
                .clone(),
        ],
        Form::SpaceCurve(curve) => implicitize_space_curve(&curve, limits)?
            .surfaces
            .iter()
            .map(|s| s.polynomial().clone())
            .collect(),
        Form::Superquadric(shape) => match shape.polynomial() {
            Some(f) => vec![Equation::from(&f)],
            None => Vec::new(),
        },
        Form::SpaceSuperquadric(shape) => vec![shape.polynomial()?],
        Form::Harmonic(_) => vec![harmonic(subject)?.expand().polynomial().clone()],
        _ => vec![Equation::from(curve(subject)?.polynomial())],
    };
    Answer::polynomials(&found, claimed)
}

pub(super) fn polar_equation(subject: &str, claimed: &str, limits: &Limits) -> Result<Answer> {
    let product = |factors: &[PolarFactor]| {
        let one = Equation::constant(Rational::one());
        factors.iter().fold(one, |product, factor| {
            let times = (0..factor.multiplicity).map(|_| &factor.polynomial);
            times.fold(product, |product, g| product.times(g))
        })
    };
    let found = match form(subject)? {
        Form::PlaneCurve(curve) => vec![product(&polar_plane(&curve, limits)?.factors)],
        Form::Patch(patch) => vec![product(&polar_patch(&patch, limits)?.factors)],
        Form::SpaceCurve(curve) => {
            let found = polar_space_curve(&curve, limits)?;
            let surfaces = [found.first, found.second].into_iter().flatten();
            surfaces.map(|surface| surface.equation).collect()
        }
        _ => return Err(wrong_subject(subject, "a parametric form")),
    };
    Answer::polynomials(&found, claimed)
}

pub(super) fn spurious(subject: &str, claimed: &str, limits: &Limits) -> Result<Answer> {
    // The factor x² + y² does not count, because its only real point is the origin.
    let beside = |factors: Vec<PolarFactor>| -> Vec<Equation> {
        let known = [Role::Form, Role::SquaredRadius];
        let others = factors.into_iter().filter(|f| !known.contains(&f.role));
        others.map(|f| f.polynomial).collect()
    };
    let found = match form(subject)? {
        Form::PlaneCurve(curve) => beside(polar_plane(&curve, limits)?.factors),
        Form::Patch(patch) => beside(polar_patch(&patch, limits)?.factors),
        Form::SpaceCurve(curve) => {
            let components = polar_space_curve(&curve, limits)?.components;
            components.into_iter().map(|[_, second]| second).collect()
        }
        _ => return Err(wrong_subject(subject, "a parametric form")),
    };
    match (&found[..], claimed) {
        ([], _) => Ok(Answer::text("none".into(), claimed)),
        (_, "none") => {
            let texts = found.iter().map(text_of).collect::<Result<Vec<_>>>()?;
            Ok(Answer::text(texts.join("; "), claimed))
        }
        _ => Answer::polynomials(&found, claimed),
    }
}

pub(super) fn origin(subject: &str, claimed: &str, _: &Limits) -> Result<Answer> {
    let multiplicity = degrees_of(subject)?.into_iter().min();
    let multiplicity = multiplicity.invariant("the polynomial of a curve is not 0");
    Ok(Answer::text(multiplicity.to_string(), claimed))
}

pub(super) fn degrees(subject: &str, claimed: &str, _: &Limits) -> Result<Answer> {
    Ok(Answer::text(joined(degrees_of(subject)?), claimed))
}

pub(super) fn fitted_degrees(subject: &str, claimed: &str, limits: &Limits) -> Result<Answer> {
    let [name, harmonics] = parts(subject)?;
    let (Some(rows), Ok(harmonics)) = (example(name), harmonics.parse()) else {
        return Err(wrong_subject(
            subject,
            "an outline of paper-examples, and a number",
        ));
    };
    let contour = contour_from_reader(rows.as_bytes(), ContourKind::Rows, name)?;
    let options = FitOptions::new(FitSize::Harmonics(harmonics));
    let radius = fit_within(&contour, &options, limits)?.radius;
    let curve = SquaredForm::new(&radius)?.expand();
    let degrees = curve.polynomial().homogeneous_degrees();
    Ok(Answer::text(joined(degrees), claimed))
}

pub(super) fn factors(subject: &str, claimed: &str, limits: &Limits) -> Result<Answer> {
    let f = polynomial(subject)?;
    let found: Vec<Equation> = match f.to_plane() {
        Some(f) => {
            let power = |g: &PlanePolynomial, k: usize| Equation::from(g).pow(narrow(k));
            let factors = factor_plane(&f, limits)?.factors;
            factors
                .iter()
                .map(|g| power(&g.polynomial, g.multiplicity))
                .collect()
        }
        None => {
            let factors = factor_space(&f, limits)?.factors;
            factors
                .iter()
                .map(|g| g.polynomial.pow(narrow(g.multiplicity)))
                .collect()
        }
    };
    Answer::polynomials(&found, claimed)
}

/// An exponent as a `u32`; degrees of polynomials are far below 2³².
fn narrow(k: usize) -> u32 {
    u32::try_from(k).invariant("degrees are below 2^32")
}

pub(super) fn same(subject: &str, claimed: &str, _: &Limits) -> Result<Answer> {
    let agrees = match (form(subject)?, form(claimed)?) {
        (Form::Curve(a), Form::Curve(b)) => {
            a.polynomial().primitive() == b.polynomial().primitive()
        }
        (a, b) => a == b,
    };
    let found = if agrees { "the same" } else { "different" };
    Ok(Answer {
        found: found.into(),
        agrees,
    })
}

pub(super) fn perfect_square(subject: &str, claimed: &str, _: &Limits) -> Result<Answer> {
    if let Form::Harmonic(_) = form(subject)? {
        let found = match harmonic(subject)?.is_perfect_square() {
            true => "a perfect square",
            false => "no perfect square",
        };
        return Ok(Answer::text(found.into(), claimed));
    }
    let form = SquaredForm::new(&fourier(subject)?)?;
    let reduced = Equation::from(form.expand().polynomial());
    let full = Equation::from(form.expand_unreduced().polynomial());
    let found = if reduced.squared().primitive() == full.primitive() {
        "a perfect square"
    } else {
        "no perfect square"
    };
    Ok(Answer::text(found.into(), claimed))
}

/// The symbols of [`squared_away`].
const SYMBOLS: [&str; 8] = ["K0", "K1", "K2", "K3", "K4", "K5", "K6", "rho"];

pub(super) fn squared_away(subject: &str, claimed: &str, _: &Limits) -> Result<Answer> {
    let most = SYMBOLS.len() - 2;
    let harmonics: usize = match subject.parse() {
        Ok(n) if n <= most => n,
        _ => return Err(wrong_subject(subject, &format!("N, at most {most}"))),
    };
    let mut meanings = Meanings::default();
    let rho = SYMBOLS.len() - 1;
    let symbols = SYMBOLS.iter().map(|name| meanings.symbol(name));
    let symbols = symbols.collect::<Result<Vec<_>>>()?;
    let k = &symbols[..=harmonics];
    let one = SparsePolynomial::constant(Rational::one());
    let (odd, even) = parity_sums(k, &symbols[rho]);
    let power = |e| symbols[rho].pow(narrow(e));
    let parts = square_away(harmonics, &one, power, odd.as_ref(), &even);
    let top = match parts.middle {
        Some(middle) => parts.top.minus(&middle),
        None => parts.top,
    };
    let found = top.plus(&parts.low);
    let terms = found.len();
    let comparison = meanings.compare_with(found, &Formula::parse(claimed)?)?;
    Ok(match comparison {
        Comparison::Equal => Answer {
            found: format!("the same {terms} terms"),
            agrees: true,
        },
        Comparison::Different(place) => Answer {
            found: format!("different: {place}"),
            agrees: false,
        },
    })
}
