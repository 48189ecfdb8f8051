//! Exact conversion between parametric and implicit forms of star-shaped curves and surfaces, after
//! Ünsalan & Erçil, *Conversions between Parametric and Implicit Forms Using Polar/Spherical Coordinate
//! Representations*, Computer Vision and Image Understanding 81, 1–25 (2001).
//!
//! A **radius** r(θ) traces the points r(θ)(cos θ, sin θ). An **implicit form** is a polynomial f that is 0 on a curve or surface.
//! Its **homogeneous part** f_d consists of the terms of degree d, so f(r cos θ, r sin θ) = Σ r^d f_d(cos θ, sin θ): in each
//! direction an implicit form is a polynomial in r, and its roots are the radii. In the other direction, a radius that is a Fourier
//! series with N harmonics becomes an implicit polynomial of degree 2(N+1), because the odd powers of r can be squared away.
//!
//! **Exact** results are rational numbers, and polynomials and functions with rational coefficients. **Certified** results are
//! doubles or counts with a proof, such as sampled points. All other numbers are **approximate**, such as the coefficients that
//! Definition 1 gives for a measured contour; but everything that is computed from these coefficients is exact or certified again.
//!
//! Each verb of the command line is a function of [`verb`]: it takes a form and returns an outcome, which [`document`] writes.
//!
//! ```
//! use stellate::language::Numbers;
//! use stellate::verb::{self, Given, ImplicitizeOptions, Work};
//! let given = Given::read("r = 1 + 1/5*cos(t) + 0.1*sin(t)", Numbers::Exact)?;
//! let found = verb::implicitize(given, &ImplicitizeOptions::default(), &Work::default())?;
//! # Ok::<(), stellate::error::Error>(())
//! ```
//!
//! The modules can also be used directly:
//!
//! ```
//! use stellate::implicitize::SquaredForm;
//! use stellate::language::{Numbers, parse_form};
//! use stellate::parametrize::fourier_branches;
//! use stellate::sample::{Direction, Ray, RaySolver};
//! use stellate::shape::Form;
//!
//! let form = parse_form("r = 1 + 1/5*cos(t) + 0.1*sin(t)", "example", Numbers::Exact)?;
//! let Form::Fourier(radius) = form else { unreachable!() };
//!
//! // Theorem 2: a polynomial of degree 2(N+1) with exact coefficients …
//! let curve = SquaredForm::new(&radius)?.expand();
//! assert_eq!(curve.polynomial().homogeneous_degrees(), [4, 3, 2]);
//!
//! // … and back, exactly (Lemma 3).
//! assert_eq!(fourier_branches(&curve)?.radii[0], radius);
//!
//! // Certified points: all real roots along an exact direction, each the nearest double.
//! let east = Direction::from_radians(0.0);
//! let Ray::Points(points) = RaySolver::new(curve.polynomial()).solve(&east) else { unreachable!() };
//! assert_eq!(points.iter().map(|p| p.r).collect::<Vec<_>>(), [1.2, -0.8]);
//! # Ok::<(), stellate::error::Error>(())
//! ```
//!
//! # From the paper to the modules
//!
//! | paper | module |
//! | --- | --- |
//! | Definition 1 (Fourier coefficients of a contour) | [`fit`] |
//! | Lemma 1 (r(θ) as a series) | [`shape::FourierRadius`] |
//! | Theorem 1, Eq. (1) | [`implicitize::polar_plane`]; the same by a resultant: [`implicitize::implicitize_plane`] |
//! | Theorem 2, Eqs. (5)–(9), Appendix B | [`implicitize::SquaredForm`] |
//! | Theorem 2 in space, beyond the paper | [`implicitize::SquaredHarmonics`], and back [`parametrize::harmonic_radii`]; fits to meshes: [`fit::fit_mesh`]; inspection: [`inspect::HarmonicInspector`] |
//! | Theorem 3, Eqs. (10), (11) | [`implicitize::polar_space_curve`]; all equations: [`implicitize::implicitize_space_curve`] |
//! | Theorem 4, Eq. (15) | [`implicitize::polar_patch`]; by linear algebra: [`implicitize::implicitize_patch`] |
//! | Appendix A (cos nθ, sin nθ as forms) | [`poly::BinaryForm`] |
//! | homogeneous parts (§3) | [`poly::PlanePolynomial`] |
//! | Lemmas 2 to 5: closed forms, exact ranges; series taken back exactly | [`parametrize`] |
//! | Lemmas 7 to 10, Theorem 6: surfaces, on meridians and in directions | [`parametrize::parametrize_surface`] |
//! | Theorem 7: intersections as curves | [`parametrize::parametrize_intersection`]; where there is no formula: [`arcs`] |
//! | superquadrics (Examples 6 and 10, Eqs. (20), (77)) | [`shape::Superquadric`], [`shape::SpaceSuperquadric`] |
//! | factors (Example 8) | [`factor`] |
//! | beyond the paper: components, singular points and genus of plane curves | [`topology`] |
//! | beyond the paper: genus and rational parametrizations | [`parametrize::rational_parametrization`] |
//! | Lemma 6: branches of any degree, with exact ranges and a Fourier fit | [`parametrize`] ([`parametrize::RootBranch`], [`parametrize::fit_branch`]) |
//! | Theorem 5 (which lemma applies) | [`describe`] |
//! | roots in a direction | [`sample`] |
//! | triangles of a surface | [`mesh`] |
//! | Theorem 8, Example 12 (inspection) | [`inspect`] |
//! | beyond the paper: comparisons of float programs with exact results, and test vectors for them | [`check`] |
//! | all statements of the paper, checked one by one, with errata | [`paper`] |
//! | the time comparison that the paper leaves to others | `compare`, with the feature `cli` |
//!
//! # Features
//!
//! By default there is `cli`: the program, with all of these but `more-images` and `columnar`. Without default features there is the
//! exact core, with some 60 crates. Added can be:
//!
//! | feature | what it adds |
//! | --- | --- |
//! | `pictures` | the module `picture` and the verbs `plot` and `ladder_chart`: SVG and PNG |
//! | `images` | outlines of silhouettes in PNG, JPEG and BMP, and of drawings in SVG |
//! | `more-images` | silhouettes in GIF, TIFF and WebP, too |
//! | `meshes` | the verb `fit_mesh`, and the certified distance of a mesh from its fit |
//! | `gzip` | files of spherical harmonics that gzip packed |
//! | `unicode` | fullwidth and mathematical letters in formulas, as documents have them |
//! | `columnar` | points of an inspection in Parquet and Arrow files |
//!
//! # The order of the modules
//!
//! Arithmetic modulo primes, fast integers → [`exact`] numbers → [`poly`]nomials → their real [`roots`] and [`factor`]s → [`shape`]s
//! → [`topology`], [`implicitize`], [`fit`], [`language`], [`reading`] → [`parametrize`], [`sample`], [`mesh`], [`arcs`], [`describe`] →
//! [`inspect`], [`check`], [`picture`] → [`verb`] → [`document`] → [`paper`] → the command line. A file imports only from modules
//! that come before its own, and from [`error`] and [`limits`].
//!
//! # Conventions
//!
//! - Coefficients of univariate polynomials ascend; the zero polynomial has no degree (`None`).
//! - Terms are ordered by total degree, then by exponents, both descending.
//! - A canonical polynomial has coprime integer coefficients and its first term positive.
//! - The coordinates of a parametric form are rational functions of s. If the parameter t is a number, s = t. If it is an angle,
//!   s = tan(g·t/2), where all multiples of the angle that occur are multiples of g·t ([`shape::Parameter`]).
//! - θ is in radians from +x towards +y, φ from +z.
//! - Fourier radii are `a0 + Σ a_n cos nθ + b_n sin nθ`: a0 is the mean, not twice the mean.
//! - Ranges of angles lie in [0, 2π]; for each end they state whether it belongs to the range.
//! - An exact number is an [`exact::Rational`], a certified one a [`roots::RealRoot`] or a
//!   [`sample::Sample`], and an approximate one an `f64`, which is printed after ≈.
//!
//! Departures from the paper are marked `DIFFERENCE`, with the erratum.

// The command line names this library as programs do.
#[cfg(feature = "cli")]
extern crate self as stellate;

pub mod arcs;
mod bigint;
pub mod check;
#[cfg(feature = "cli")]
#[doc(hidden)]
pub mod cli;
#[cfg(feature = "cli")]
pub mod compare;
mod coordinate_names;
pub mod describe;
pub mod document;
pub mod error;
pub mod exact;
pub mod factor;
pub mod fit;
pub mod guide;
mod html;
pub mod implicitize;
pub mod inspect;
mod intervals;
pub mod language;
pub mod limits;
pub mod mesh;
mod modular;
mod notation;
mod options;
pub mod paper;
mod parallel;
pub mod parametrize;
#[cfg(feature = "pictures")]
pub mod picture;
pub mod poly;
pub mod proof;
#[cfg(feature = "python")]
mod python;
pub mod reading;
pub mod roots;
mod rows;
pub mod sample;
pub mod shape;
pub mod sphere;
pub mod topology;
pub mod verb;
pub mod witness;

// The example of the README is a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
