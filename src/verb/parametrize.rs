//! The verb `parametrize`: r(θ) for plane curves, R(θ, φ) for surfaces, and coordinates for intersections.

use super::arcs::{ArcSearch, arcs_of_others, refuse_arcs};
use super::claims::{
    claim_branches, claim_harmonic_radii, claim_intersection, claim_surface_branches,
};
use super::equation::{Taken, check_curve, check_surface, squared_harmonics, through_equation};
use super::fit::{exact_form, refuse_contour_options};
use super::{Content, Given, Remark, Work};
use crate::arcs::IntersectionArcs;
use crate::error::{Error, Result};
use crate::fit::{FitOptions, FitSize};
use crate::implicitize::SquaredForm;
use crate::limits::Limits;
use crate::options::options;
use crate::parametrize::{
    Branch, BranchFit, BranchFitOptions, BranchRadius, DEFAULT_HARMONICS, DirectionAnswer,
    IntersectionParametrization, MeridianBranch, Parametrization, PolarMethod,
    SurfaceParametrization, fit_branch, harmonic_radii, parametrize as parametrize_curve,
    parametrize_intersection, parametrize_space_superquadric, parametrize_superquadric,
    parametrize_surface,
};
use crate::sample::{Direction, Ray, RaySolver, SpaceDirection};
use crate::shape::{Form, FourierRadius, HarmonicSurface, ImplicitSurface};

options! {
    /// How a form is parametrized.
    ParametrizeOptions {
        /// How a contour is fitted. For an exact form: the size, the number of samples and the decimals of the Fourier fit of a
        /// branch without a closed form.
        fit: FitOptions = FitOptions::default(),
        /// The branch that is fitted by a Fourier series if there is no closed form; by default the outermost.
        branch: Option<usize> = None,
        /// For a surface: the meridians on which the exact ranges of φ are determined or, if `phis` is not empty, the angles θ
        /// of the directions.
        thetas: Vec<Direction> = Vec::new(),
        /// For a surface: the angles φ of the directions (θ, φ) in which the certified answers are determined.
        phis: Vec<Direction> = Vec::new(),
        /// For an intersection: how the arcs of components without a parametrization are followed.
        arcs: ArcSearch = ArcSearch::default(),
        /// Whether these arcs are followed.
        with_arcs: bool = true,
    }
}

/// The parametric form of a form.
#[derive(Clone, Debug)]
#[expect(
    clippy::large_enum_variant,
    reason = "there is one of these for each form that is parametrized"
)]
#[non_exhaustive]
pub enum Parametrized {
    /// A plane curve with its branches r(θ).
    Curve {
        /// The branches.
        polar: Parametrization,
        /// The Fourier fit of a branch without a closed form.
        fit: Option<BranchFit>,
    },
    /// A surface whose branches R(θ, φ) are finite sums of spherical harmonics: R(d), and −R(−d) if that is another one.
    Harmonics(Vec<HarmonicSurface>),
    /// A surface with its branches R(θ, φ).
    Surface {
        /// The branches.
        spherical: SurfaceParametrization,
        /// The answers on the requested meridians.
        meridians: Vec<OnMeridian>,
        /// The answers in the requested directions.
        directions: Vec<InDirection>,
    },
    /// The curve in which surfaces meet.
    Intersection {
        /// The components with a parametrization.
        found: IntersectionParametrization,
        /// Certified arcs of the components without a parametrization.
        arcs: Option<IntersectionArcs>,
    },
}

/// The exact ranges on one meridian.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct OnMeridian {
    /// The angle θ of the meridian.
    pub theta: Direction,
    /// The ranges of φ of every branch.
    pub branches: Vec<MeridianBranch>,
}

/// The certified answers in one direction.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct InDirection {
    /// The direction.
    pub direction: SpaceDirection,
    /// The signs that the formulas of the branches have there.
    pub answer: DirectionAnswer,
    /// The certified points of every factor in this direction.
    pub rays: Vec<Ray<3>>,
}

const PARAMETRIZE: Taken = Taken {
    verb: "parametrize",
    these: "plane curves, surfaces and intersections of surfaces",
};

/// The polar or spherical form of a curve or surface (§3 of the paper), or the parametric form of an intersection (Theorem 7).
///
/// ```
/// use stellate::language::Numbers;
/// use stellate::verb::{self, Given, Parametrized, ParametrizeOptions, Work};
/// let given = Given::read("x^4 - x^2 + y^2 = 0", Numbers::Exact)?;
/// let found = verb::parametrize(given, &ParametrizeOptions::default(), &Work::default())?;
/// let Parametrized::Curve { polar, .. } = found else { unreachable!() };
/// assert_eq!(polar.branches.len(), 2); // r of either sign
/// # Ok::<(), stellate::error::Error>(())
/// ```
///
/// # Errors
/// Those of the functions of [`crate::parametrize`]; [`Error::Usage`] for an option that the form does not have.
pub fn parametrize(
    given: Given,
    options: &ParametrizeOptions,
    work: &Work,
) -> Result<Parametrized> {
    // For an exact form, the options describe the fit of a branch (Lemma 6).
    let is_exact = matches!(given.content(), Content::Exact(_));
    let fitted = if is_exact {
        refuse_contour_options(&options.fit)?;
        exact_form(given, &FitOptions::default(), work)?
    } else {
        exact_form(given, &options.fit, work)?
    };
    if let Form::Harmonic(surface) = &fitted.form {
        refuse_arcs(&options.arcs)?;
        refuse_harmonics_options(options)?;
        let equation = squared_harmonics(surface, work)?;
        let radii = work.stage("parametrize", || harmonic_radii(&equation.expand()))?;
        let others = radii
            .into_iter()
            .filter(|radius| !radius.has_same_radii(surface));
        let radii: Vec<_> = std::iter::once(surface.clone()).chain(others).collect();
        work.claim(|proof| claim_harmonic_radii(proof, &equation.expand(), &radii))?;
        return Ok(Parametrized::Harmonics(radii));
    }
    let form = through_equation(fitted.form, work)?;
    if let Form::Intersection(surfaces) = &form {
        refuse_series_options(options, "an intersection of surfaces")?;
        return intersection(surfaces, options, work);
    }
    refuse_arcs(&options.arcs)?;
    if let Form::Surface(surface) = &form {
        // The sphere has the closed form of Lemma 7.
        if surface.polynomial().degree() > Some(2) && options.thetas.is_empty() {
            let radii = work.stage("parametrize", || harmonic_radii(surface))?;
            if !radii.is_empty() {
                refuse_harmonics_options(options)?;
                work.claim(|proof| claim_harmonic_radii(proof, surface, &radii))?;
                return Ok(Parametrized::Harmonics(radii));
            }
        }
        return of_surface(surface, options, work);
    }
    if let Form::SpaceSuperquadric(shape) = &form {
        refuse_series_options(options, "a superquadric in space")?;
        if !options.thetas.is_empty() {
            return Err(Error::Usage(
                "--theta and --phi ask where R is real; that of a superquadric is real and positive in every direction".into(),
            ));
        }
        let spherical = parametrize_space_superquadric(shape);
        work.claim(|proof| claim_surface_branches(proof, &spherical, false, work))?;
        return Ok(Parametrized::Surface {
            spherical,
            meridians: Vec::new(),
            directions: Vec::new(),
        });
    }
    if !options.thetas.is_empty() {
        return Err(Error::Usage(
            "--theta and --phi are for surfaces: the ranges of a plane curve are over theta and given in full".into(),
        ));
    }
    let polar = work.stage("parametrize", || match &form {
        Form::Fourier(radius) => {
            work.check_degree(2 * radius.harmonics() + 2)?;
            of_radius(radius, work.bounds())
        }
        Form::Curve(curve) => {
            check_curve(curve, work)?;
            parametrize_curve(curve, work.bounds())
        }
        Form::Superquadric(shape) => Ok(parametrize_superquadric(shape)),
        _ => Err(PARAMETRIZE.not_this()),
    })?;
    let fit = branch_fit(options, is_exact, &polar, work)?;
    work.claim(|proof| claim_branches(proof, &polar, work))?;
    Ok(Parametrized::Curve { polar, fit })
}

impl Parametrized {
    /// Whether the radius can be written as a table of Fourier coefficients.
    #[must_use]
    pub fn is_series(&self) -> bool {
        match self {
            Self::Curve { polar, fit } => {
                let is_series = |b: &Branch| matches!(b.radius, BranchRadius::Fourier(_));
                polar.branches.first().is_some_and(is_series)
                    || fit.is_some() && polar.method == PolarMethod::Numeric
            }
            Self::Surface { .. } | Self::Harmonics(_) | Self::Intersection { .. } => false,
        }
    }
}

/// Refuses the options that mean nothing for radii that are sums of harmonics.
fn refuse_harmonics_options(options: &ParametrizeOptions) -> Result<()> {
    refuse_series_options(options, "a harmonic surface")?;
    if !options.thetas.is_empty() {
        return Err(Error::Usage(
            "--theta and --phi ask where R is real; a sum of harmonics is real in every direction: sample gives its values".into(),
        ));
    }
    Ok(())
}

/// Refuses the options of Fourier series for a form that has no plane radius.
fn refuse_series_options(options: &ParametrizeOptions, this: &str) -> Result<()> {
    let given = series_options(options);
    match given.iter().find(|(_, given)| *given) {
        Some((name, _)) => Err(Error::Usage(format!(
            "{name} belongs to Fourier series of plane radii; this is {this}"
        ))),
        None => Ok(()),
    }
}

/// The options of Fourier series of branches, and which of them are given.
fn series_options(options: &ParametrizeOptions) -> [(&'static str, bool); 5] {
    let fit = &options.fit;
    [
        ("--branch", options.branch.is_some()),
        ("--harmonics", fit.harmonics().is_some()),
        ("--tolerance", fit.tolerance().is_some()),
        ("--samples", fit.samples.is_some()),
        ("--decimals", fit.decimals.is_some()),
    ]
}

/// Theorem 6: R(θ, φ), and the exact answers on the requested meridians and in the requested directions.
fn of_surface(
    surface: &ImplicitSurface,
    options: &ParametrizeOptions,
    work: &Work,
) -> Result<Parametrized> {
    refuse_series_options(options, "a surface")?;
    check_surface(surface, work)?;
    let spherical = work.stage("parametrize", || {
        parametrize_surface(surface, work.bounds())
    })?;
    let (thetas, phis) = (&options.thetas, &options.phis);
    let (meridians, directions) = work.stage("ranges", || -> Result<_> {
        if phis.is_empty() {
            let meridians = thetas.iter().map(|theta| {
                Ok(OnMeridian {
                    branches: spherical.on_meridian(theta, work.bounds())?,
                    theta: theta.clone(),
                })
            });
            return Ok((meridians.collect::<Result<_>>()?, Vec::new()));
        }
        let pairs = thetas.iter().flat_map(|theta| {
            let along = phis.iter();
            along.map(|phi| SpaceDirection::new(theta.clone(), phi.clone()))
        });
        let answers = pairs.map(|direction| {
            let factors = spherical.factors.iter();
            InDirection {
                answer: spherical.in_direction(&direction),
                rays: factors
                    .map(|f| RaySolver::new(&f.polynomial).solve(&direction))
                    .collect(),
                direction,
            }
        });
        Ok((Vec::new(), answers.collect()))
    })?;
    work.claim(|proof| claim_surface_branches(proof, &spherical, !thetas.is_empty(), work))?;
    Ok(Parametrized::Surface {
        spherical,
        meridians,
        directions,
    })
}

/// Theorem 7: the curve in which surfaces meet, with certified arcs of the components that have no parametrization.
fn intersection(
    surfaces: &[ImplicitSurface],
    options: &ParametrizeOptions,
    work: &Work,
) -> Result<Parametrized> {
    let found = work.stage("parametrize", || {
        parametrize_intersection(surfaces, work.bounds())
    })?;
    work.claim(|proof| {
        claim_intersection(proof, surfaces, &found);
        Ok(())
    })?;
    let has_arcs = options.with_arcs && surfaces.len() == 2;
    if found.curves.is_empty() && !has_arcs && !found.others.is_empty() {
        let reasons: Vec<&str> = found.others.iter().map(|o| o.reason.as_str()).collect();
        return Err(Error::Hypothesis {
            statement: "Theorem 7 with a rational or trigonometric relation",
            witness: reasons.join("; "),
        });
    }
    let search = &options.arcs;
    let arcs = if found.others.is_empty() {
        if search.window.is_some() || search.resolution.is_some() {
            work.remark(Remark::NoArcsNeeded);
        }
        None
    } else if has_arcs {
        Some(arcs_of_others(&found, surfaces, search, work)?)
    } else {
        work.remark(Remark::ComponentsLeftOut);
        None
    };
    Ok(Parametrized::Intersection { found, arcs })
}

/// The Fourier fit of a branch without a closed form, if there is one.
fn branch_fit(
    options: &ParametrizeOptions,
    is_exact: bool,
    polar: &Parametrization,
    work: &Work,
) -> Result<Option<BranchFit>> {
    let fit = &options.fit;
    let is_root = |b: &Branch| matches!(&b.radius, BranchRadius::Root(root) if !root.is_point());
    if !polar.branches.iter().any(is_root) {
        // The other options have made the fit of a contour.
        let given = series_options(options);
        let mut unused = given
            .iter()
            .filter(|(name, given)| *given && (is_exact || *name == "--branch"));
        return match unused.next() {
            Some((name, _)) => Err(Error::Usage(format!(
                "{name} is for contours and for branches without a closed form (Lemma 6); the radii of this form are exact"
            ))),
            None => Ok(None),
        };
    }
    let options = BranchFitOptions::default()
        .branch(options.branch)
        .size(fit.size.unwrap_or(FitSize::Harmonics(DEFAULT_HARMONICS)))
        .samples(fit.samples)
        .decimals(fit.decimals);
    let fit = work.stage("fit", || fit_branch(polar, &options, work.bounds()))?;
    match &fit {
        None => work.remark(Remark::NoFourierFit),
        Some(fit) if !fit.jumps.is_empty() => work.remark(Remark::Jumps(fit.jumps.len())),
        Some(_) => {}
    }
    Ok(fit)
}

/// The branches of the implicit equation of a radius. The radius itself is parametric already, and comes first.
fn of_radius(radius: &FourierRadius, limits: &Limits) -> Result<Parametrization> {
    let mut curve = parametrize_curve(&SquaredForm::new(radius)?.expand(), limits)?;
    // Two branches describe the same points; the given radius comes first.
    let is_given = |b: &Branch| matches!(&b.radius, BranchRadius::Fourier(r) if r == radius);
    if let Some(given) = curve.branches.iter().position(is_given) {
        curve.branches.swap(0, given);
    }
    Ok(curve)
}
