//! The usual mistakes with spherical harmonics.

use std::f64::consts::{FRAC_PI_2, PI};

use super::GivenSpaceRadius;
use crate::check::mistakes::Mistaken;
use crate::exact::Rational;
use crate::reading::Normalization;
use crate::shape::HarmonicSurface;

/// The surfaces that mistakes with the coefficients lead to, without those that leave the surface unchanged.
pub(super) fn mistaken_surfaces(surface: &HarmonicSurface) -> Vec<Mistaken<HarmonicSurface>> {
    let mut all = Vec::new();
    let mut add = |name: String, explanation: String, terms: Vec<((usize, isize), Rational)>| {
        if let Ok(form) = HarmonicSurface::new(terms)
            && !form.has_same_radii(surface)
            && !form.is_zero()
        {
            all.push(Mistaken {
                name: name.into(),
                explanation: explanation.into(),
                form: form.with_center(surface.center().clone()),
            });
        }
    };
    let mapped =
        |f: &dyn Fn(usize, isize) -> (isize, Rational)| -> Vec<((usize, isize), Rational)> {
            let terms = surface.terms().map(|(l, m, c)| {
                let (order, factor) = f(l, m);
                ((l, order), c * factor)
            });
            terms.collect()
        };
    let sign = |is_negative: bool| Rational::from(if is_negative { -1 } else { 1 });
    let phase = |m: isize| sign(m % 2 != 0);
    add(
        "Condon–Shortley phase".into(),
        "harmonics of odd order m have the wrong sign: the phase (-1)^m is there where it is not meant, or the other way round".into(),
        mapped(&|_, m| (m, phase(m))),
    );
    add(
        "m negated".into(),
        "the coefficients of m and -m, of cosines and sines, are exchanged".into(),
        mapped(&|_, m| (-m, Rational::one())),
    );
    add(
        "sign of the sines".into(),
        "R(-theta, phi): the complex conjugate was taken, or theta runs the other way round".into(),
        mapped(&|_, m| (m, sign(m < 0))),
    );
    add(
        "reflected in the origin".into(),
        "R(-d): harmonics of odd degree have the wrong sign".into(),
        mapped(&|l, m| (m, sign(l % 2 == 1))),
    );
    add(
        "z mirrored".into(),
        "R(theta, pi - phi): phi is measured from -z".into(),
        mapped(&|l, m| (m, sign((l + m.unsigned_abs()) % 2 == 1))),
    );
    for (name, ratio) in [
        ("√2 too much", 2f64.sqrt()),
        ("√2 too little", 0.5f64.sqrt()),
    ] {
        add(
            format!("real and complex harmonics: {name}"),
            "the harmonics with m ≠ 0 have a factor √2 between real and complex ones".into(),
            mapped(&|_, m| {
                (
                    m,
                    if m == 0 {
                        Rational::one()
                    } else {
                        exact(ratio)
                    },
                )
            }),
        );
    }
    let norms = [
        ("4π", Normalization::FourPi),
        ("orthonormal", Normalization::Orthonormal),
        ("Schmidt", Normalization::Schmidt),
    ];
    for (name, normalization) in norms {
        for (is_divided, what) in [
            (
                true,
                "the coefficients belong to harmonics with this normalization",
            ),
            (
                false,
                "the harmonics are multiplied by the factor of this normalization, which the coefficients have already",
            ),
        ] {
            let factor = |l: usize, m: isize| {
                let norm = normalization.factor(l, m.unsigned_abs());
                exact(if is_divided { 1.0 / norm } else { norm })
            };
            // Of harmonics with the factor 1 the normalization is right.
            if surface
                .terms()
                .all(|(l, m, _)| factor(l, m) == Rational::one())
            {
                continue;
            }
            for with_phase in [false, true] {
                let phase = |m| {
                    if with_phase {
                        phase(m)
                    } else {
                        Rational::one()
                    }
                };
                let and = if with_phase {
                    " and Condon–Shortley phase"
                } else {
                    ""
                };
                add(
                    format!("normalization: {name}{and}"),
                    what.into(),
                    mapped(&|l, m| (m, factor(l, m) * phase(m))),
                );
            }
        }
    }
    all
}

/// The same surface without some harmonics.
pub(super) fn without(
    surface: &HarmonicSurface,
    missing: &[(usize, isize)],
) -> Option<Mistaken<HarmonicSurface>> {
    let left = surface
        .terms()
        .filter(|(l, m, _)| !missing.contains(&(*l, *m)))
        .map(|(l, m, c)| ((l, m), c.clone()));
    let form = HarmonicSurface::new(left).ok()?;
    Some(Mistaken {
        name: missing_name(surface, missing).into(),
        explanation: format!("left out: {}", list(missing)).into(),
        form: form.with_center(surface.center().clone()),
    })
}

/// The name of the mistake to leave out harmonics: those of m and −m together are named by m.
pub(super) fn missing_name(surface: &HarmonicSurface, missing: &[(usize, isize)]) -> String {
    let last = surface.degree();
    let is_whole = |l: usize| {
        surface
            .terms()
            .filter(|(degree, ..)| *degree == l)
            .all(|(l, m, _)| missing.contains(&(l, m)))
    };
    let first = (0..=last).find(|l| missing.iter().any(|(degree, _)| degree == l));
    if let Some(first) = first
        && missing.len() > 2
        && (first..=last).all(is_whole)
    {
        return match first == last {
            true => format!("missing: degree {last}"),
            false => format!("missing: degrees {first} to {last}"),
        };
    }
    let mut pairs: Vec<String> = Vec::new();
    for &(l, m) in missing {
        let is_pair = m != 0 && missing.contains(&(l, -m));
        if m < 0 && is_pair {
            continue;
        }
        pairs.push(format!("({l}, {m})"));
    }
    format!("missing: {}", pairs.join(", "))
}

fn list(missing: &[(usize, isize)]) -> String {
    let names: Vec<String> = missing.iter().map(|(l, m)| format!("Y({l},{m})")).collect();
    names.join(", ")
}

/// The radii with angles that were meant otherwise.
pub(super) fn mistaken_angles(radii: &[GivenSpaceRadius]) -> Vec<Mistaken<Vec<GivenSpaceRadius>>> {
    let degrees = |[theta, phi]: [f64; 2]| [theta.to_radians(), phi.to_radians()];
    let exchanged = |[theta, phi]: [f64; 2]| [phi, theta];
    let latitude = |[theta, phi]: [f64; 2]| [theta, FRAC_PI_2 - phi];
    type Change<'a> = &'a dyn Fn([f64; 2]) -> [f64; 2];
    let all: [(&str, &str, Change<'_>); 8] = [
        (
            "degrees for radians",
            "the angles are in degrees; radians are meant",
            &degrees,
        ),
        (
            "theta and phi exchanged",
            "theta is the angle about z, from x to y, and phi the one from z",
            &exchanged,
        ),
        (
            "latitude for colatitude",
            "phi is measured from z, not from the plane of x and y",
            &latitude,
        ),
        (
            "degrees for radians, theta and phi exchanged",
            "the angles are in degrees, and theta is the one about z",
            &|at| exchanged(degrees(at)),
        ),
        (
            "degrees for radians, latitude for colatitude",
            "the angles are in degrees, and phi is measured from z",
            &|at| latitude(degrees(at)),
        ),
        (
            "theta and phi exchanged, latitude for colatitude",
            "theta is the angle about z, and phi is measured from z",
            &|at| latitude(exchanged(at)),
        ),
        (
            "phi from -z",
            "phi is measured from z, not from -z",
            &|[theta, phi]| [theta, PI - phi],
        ),
        (
            "theta from y",
            "theta is measured from x towards y, not from y towards x",
            &|[theta, phi]| [FRAC_PI_2 - theta, phi],
        ),
    ];
    all.into_iter()
        .map(|(name, explanation, change)| Mistaken {
            name: name.into(),
            explanation: explanation.into(),
            form: radii
                .iter()
                .map(|given| {
                    let [theta, phi] = change([given.theta, given.phi]);
                    GivenSpaceRadius {
                        theta,
                        phi,
                        ..*given
                    }
                })
                .collect(),
        })
        .collect()
}

/// A surface times a factor, if the numbers of the float program are nearly that times the exact ones: the middle of their ratios.
pub(super) fn scaled(
    surface: &HarmonicSurface,
    mut ratios: Vec<f64>,
) -> Option<Mistaken<HarmonicSurface>> {
    ratios.retain(|ratio| ratio.is_finite());
    let place = ratios.len().checked_sub(1)? / 2;
    let middle = *ratios.select_nth_unstable_by(place, f64::total_cmp).1;
    if (middle - 1.0).abs() < 1e-9 || middle.abs() < 1e-300 {
        return None;
    }
    // A simple factor, if there is one that near.
    let near = |x: f64| Rational::try_from(x).ok();
    let width = 1e-13 * middle.abs();
    let factor = Rational::simplest_between(&near(middle - width)?, &near(middle + width)?);
    let terms = surface.terms().map(|(l, m, c)| ((l, m), c * &factor));
    let form = HarmonicSurface::new(terms).ok()?;
    let shown = if factor.bits() < 40 {
        factor.to_string()
    } else {
        format!("≈ {middle}")
    };
    Some(Mistaken {
        name: "scale".into(),
        explanation: format!("everything is {shown} times what is right").into(),
        form: form.with_center(surface.center().clone()),
    })
}

/// The exact value of a double that is finite by its making.
fn exact(x: f64) -> Rational {
    Rational::try_from(x).unwrap_or_else(|_| Rational::one())
}
