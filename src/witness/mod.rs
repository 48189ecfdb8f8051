//! Witnesses: the claims of a run, written down so that the checker of [`crate::proof`] needs nothing but evaluation.
//!
//! A [`Proof`] is the document that the page about proof files defines. Each claim is made from exact objects of the engine; what
//! has no witness is claimed without one. The names T1 to T8 are those of the theorems on that page.

mod breakpoints;
mod distance;
mod equation;
mod fit;
mod forms;
mod line;
mod minima;
mod positive;
mod proof;
mod rays;
mod sectors;

pub(crate) use distance::{ClaimedPoint, InspectedForm, inspected_point};
pub(crate) use equation::{factors, identity, irreducible, of_radius, unproved};
pub(crate) use fit::fit_error;
pub(crate) use forms::{curve_form, harmonic_form, radius_form, surface_form};
pub(crate) use positive::{positive_radius, positive_sphere};
pub use proof::Proof;
pub(crate) use rays::{ray, superquadric_ray};
pub(crate) use sectors::sectors;
