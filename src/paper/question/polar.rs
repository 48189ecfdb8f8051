//! Questions about polar and spherical forms: §3 of the paper.

use super::equations::{curve, fourier, harmonic};
use super::{Answer, form, joined, wrong_subject};
use crate::document::{Coordinates, Format, write_parametrization, write_surface_parametrization};
use crate::error::Result;
use crate::implicitize::SquaredForm;
use crate::limits::Limits;
use crate::parametrize::{
    AngleRange, BranchRadius, Parametrization, PolarMethod, SurfaceMethod, SurfaceParametrization,
    fourier_branches, harmonic_radii, parametrize, parametrize_intersection,
    parametrize_space_superquadric, parametrize_superquadric, parametrize_surface,
};
use crate::roots::RealRoot;
use crate::shape::Form;

/// Decimals of angles that have no closed form.
const DECIMALS: u32 = 6;

/// Decimals of the tangents at which branches fold.
const TANGENT_DECIMALS: u32 = 12;

/// The polar form of a plane curve, or the spherical form of a surface.
pub(super) enum Polar {
    Plane(Box<Parametrization>),
    Space(Box<SurfaceParametrization>),
}

pub(super) fn polar(subject: &str, limits: &Limits) -> Result<Polar> {
    Ok(match form(subject)? {
        Form::Surface(surface) => Polar::Space(Box::new(parametrize_surface(&surface, limits)?)),
        Form::Superquadric(shape) => Polar::Plane(Box::new(parametrize_superquadric(&shape))),
        Form::SpaceSuperquadric(shape) => {
            Polar::Space(Box::new(parametrize_space_superquadric(&shape)))
        }
        _ => Polar::Plane(Box::new(parametrize(&curve(subject)?, limits)?)),
    })
}

fn in_the_plane(subject: &str, limits: &Limits) -> Result<Box<Parametrization>> {
    match polar(subject, limits)? {
        Polar::Plane(found) => Ok(found),
        Polar::Space(_) => Err(wrong_subject(subject, "a plane curve")),
    }
}

pub(super) fn back(subject: &str, claimed: &str, _: &Limits) -> Result<Answer> {
    let (agrees, is_back) = match form(subject)? {
        Form::Harmonic(surface) => {
            let radii = harmonic_radii(&harmonic(subject)?.expand())?;
            let Form::Harmonic(claimed) = form(claimed)? else {
                return Err(wrong_subject(claimed, "a sum of spherical harmonics"));
            };
            (radii.contains(&claimed), radii.contains(&surface))
        }
        _ => {
            let radius = fourier(subject)?;
            let radii = fourier_branches(&SquaredForm::new(&radius)?.expand())?.radii;
            (radii.contains(&fourier(claimed)?), radii.contains(&radius))
        }
    };
    let found = if is_back {
        "the same coefficients"
    } else {
        "other coefficients"
    };
    Ok(Answer {
        found: found.into(),
        agrees,
    })
}

pub(super) fn lemma(subject: &str, claimed: &str, limits: &Limits) -> Result<Answer> {
    let (name, symbol, step) = match polar(subject, limits)? {
        Polar::Plane(found) => {
            let name = match found.method {
                PolarMethod::Lines => "lines".into(),
                PolarMethod::Lemma(number) => format!("Lemma {number}"),
                PolarMethod::Factors => "factors".into(),
                PolarMethod::Numeric => "Lemma 6".into(),
            };
            (name, "r", found.step)
        }
        Polar::Space(found) => {
            let name = match found.method {
                SurfaceMethod::Cones => "cones".into(),
                SurfaceMethod::Lemma(number) => format!("Lemma {number}"),
                SurfaceMethod::Factors => "factors".into(),
                SurfaceMethod::Numeric => "no closed form".into(),
            };
            (name, "R", found.step)
        }
    };
    let power = match step {
        1 => String::new(),
        k => format!(" in {symbol}^{k}"),
    };
    Ok(Answer::text(name + &power, claimed))
}

pub(super) fn radius(subject: &str, claimed: &str, limits: &Limits) -> Result<Answer> {
    let mut text = Vec::new();
    let (format, out) = (Format::Text, &mut text);
    match polar(subject, limits)? {
        Polar::Plane(found) => write_parametrization(&found, None, DECIMALS, format, out),
        Polar::Space(found) => {
            write_surface_parametrization(&found, &[], &[], DECIMALS, format, out)
        }
    }?;
    let text = String::from_utf8_lossy(&text);
    let lines = text.lines().map(|line| line.trim_start_matches("# "));
    let radii = lines.filter(|line| line.starts_with("r = ") || line.starts_with("R = "));
    Ok(Answer::text(radii.collect::<Vec<_>>().join("; "), claimed))
}

/// The ranges as text, such as `[0, pi/4] and (3*pi/4, pi]`.
pub(super) fn ranges_text(ranges: &[AngleRange]) -> String {
    let text = |range: &AngleRange| {
        let end = |angle: &crate::parametrize::ExactAngle| {
            angle
                .closed_form()
                .unwrap_or_else(|| angle.to_decimal(DECIMALS))
        };
        let [open, close] = [
            if range.closed[0] { '[' } else { '(' },
            if range.closed[1] { ']' } else { ')' },
        ];
        format!("{open}{}, {}{close}", end(&range.from), end(&range.to))
    };
    match ranges {
        [] => "no angle".into(),
        _ => ranges.iter().map(text).collect::<Vec<_>>().join(" and "),
    }
}

pub(super) fn real(subject: &str, claimed: &str, limits: &Limits) -> Result<Answer> {
    let found = in_the_plane(subject, limits)?;
    let ranges = found.branches.first().map_or(&[][..], |b| &b.real);
    Ok(Answer::text(ranges_text(ranges), claimed))
}

pub(super) fn lines(subject: &str, claimed: &str, limits: &Limits) -> Result<Answer> {
    let found = in_the_plane(subject, limits)?.lines;
    let angles = found.iter().map(|angle| {
        let decimal = || angle.to_decimal(DECIMALS);
        angle.closed_form().unwrap_or_else(decimal)
    });
    let found = match &found[..] {
        [] => "none".into(),
        _ => joined(angles),
    };
    Ok(Answer::text(found, claimed))
}

pub(super) fn curves(subject: &str, claimed: &str, limits: &Limits) -> Result<Answer> {
    let Form::Intersection(surfaces) = form(subject)? else {
        return Err(wrong_subject(subject, "two surfaces"));
    };
    let found = parametrize_intersection(&surfaces, limits)?;
    let curves = found.curves.iter().map(|curve| {
        let formulas = Coordinates::from(curve).formulas(Format::Text);
        format!("({})", formulas.join(", "))
    });
    Ok(Answer::text(
        curves.collect::<Vec<_>>().join(" and "),
        claimed,
    ))
}

pub(super) fn folds(subject: &str, claimed: &str, limits: &Limits) -> Result<Answer> {
    let found = in_the_plane(subject, limits)?;
    let mut roots = found.branches.iter().filter_map(|b| match &b.radius {
        BranchRadius::Root(root) => Some(root),
        _ => None,
    });
    let Some(root) = roots.next() else {
        return Err(wrong_subject(subject, "a curve without a closed form"));
    };
    let discriminant = root.discriminant();
    let degree = discriminant.len().saturating_sub(1);
    let zeros = RealRoot::all_of(&discriminant);
    let zeros = joined(zeros.iter().map(|t| t.to_decimal(TANGENT_DECIMALS)));
    Ok(Answer::text(
        format!("the degree {degree} and the real zeros {zeros}"),
        claimed,
    ))
}
