//! The campaign: every certified claim against slow twins that share no code with the program.
//!
//! By default every kind of case runs a few times from a fixed seed, so that the campaign itself is tested. With
//! `STELLATE_CAMPAIGN=minutes` fresh cases are drawn until the time is over:
//!
//! - `STELLATE_CAMPAIGN_SEED=n` begins at a seed that was printed; 0 minutes are one turn of every kind.
//! - `STELLATE_CAMPAIGN_KIND=name` runs one kind (several, separated by commas).
//!
//! A case is determined by its kind and its seed. A failure is printed with both, and with its input as a command where
//! there is one; the campaign goes on and fails at the end.

#![expect(clippy::unwrap_used, reason = "a case fails by panicking")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    clippy::float_cmp,
    reason = "draws are converted to small numbers, and doubles are compared bit by bit"
)]

#[path = "campaign/angles.rs"]
mod angles;
#[path = "campaign/branches.rs"]
mod branches;
#[path = "campaign/draw.rs"]
mod draw;
#[path = "campaign/exact.rs"]
mod exact;
#[path = "campaign/factors.rs"]
mod factors;
#[path = "campaign/fourier.rs"]
mod fourier;
#[path = "campaign/harness.rs"]
mod harness;
#[path = "campaign/inspection.rs"]
mod inspection;
#[path = "campaign/numbers.rs"]
mod numbers;
#[path = "campaign/outlines.rs"]
mod outlines;
#[path = "campaign/parametric.rs"]
mod parametric;
#[path = "campaign/proofs.rs"]
mod proofs;
#[path = "campaign/rays.rs"]
mod rays;
#[path = "campaign/roots.rs"]
mod roots;
#[path = "campaign/superquadrics.rs"]
mod superquadrics;
#[path = "campaign/terms.rs"]
mod terms;
#[path = "campaign/texts.rs"]
mod texts;

mod common;

use harness::{Kind, Weight, campaign};

/// All kinds of cases, with how many of them run by default.
fn kinds() -> Vec<Kind> {
    use Weight::{Cheap, Heavy};
    vec![
        Kind::new("doubles", Cheap, 200, numbers::doubles),
        Kind::new("decimals", Cheap, 100, numbers::decimals),
        Kind::new("literals", Cheap, 200, numbers::literals),
        Kind::new("rationals", Cheap, 100, numbers::rationals),
        Kind::new("dyadics", Cheap, 100, numbers::dyadics),
        Kind::new("tables", Cheap, 20, texts::tables),
        Kind::new("expressions", Cheap, 20, texts::expressions),
        Kind::new("documents", Cheap, 20, texts::documents),
        Kind::new("outlines", Cheap, 20, outlines::outlines),
        Kind::new("enclosures", Cheap, 10, angles::enclosures),
        Kind::new("series", Cheap, 5, angles::series),
        Kind::new("real-roots", Heavy, 5, roots::real_roots_of),
        Kind::new("rays-plane", Heavy, 8, rays::plane),
        Kind::new("rays-vanishing", Heavy, 8, rays::vanishing),
        Kind::new("rays-backwards", Heavy, 5, rays::backwards),
        Kind::new("rays-space", Heavy, 5, rays::space),
        Kind::new("superquadrics", Heavy, 2, superquadrics::plane),
        Kind::new("theorem-2", Heavy, 3, fourier::schoolbook),
        Kind::new("theorem-2-values", Heavy, 2, fourier::values),
        Kind::new("round-trip", Heavy, 5, fourier::round_trip),
        Kind::new("star-shaped", Heavy, 3, fourier::star_shaped),
        Kind::new("products", Heavy, 3, factors::products),
        Kind::new("gcds", Heavy, 3, factors::gcds),
        Kind::new("factors", Heavy, 3, factors::factors),
        Kind::new("plane-curves", Heavy, 3, parametric::plane_curves),
        Kind::new("isolated-points", Heavy, 2, parametric::isolated_points),
        Kind::new("patches", Heavy, 1, parametric::patches),
        Kind::new("rational-curves", Heavy, 2, parametric::rational_curves),
        Kind::new("branches", Heavy, 2, branches::branches),
        Kind::new("surface-branches", Heavy, 2, branches::surface_branches),
        Kind::new("inspect-plane", Heavy, 3, inspection::plane),
        Kind::new("inspect-space", Heavy, 3, inspection::space),
        Kind::new("check-digits", Heavy, 3, angles::check_digits),
        Kind::new("proofs", Heavy, 20, proofs::of_commands),
    ]
}

#[test]
fn every_certified_claim_holds() {
    campaign("STELLATE_CAMPAIGN", &kinds());
}
