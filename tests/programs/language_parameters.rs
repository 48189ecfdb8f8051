//! Parameters of curves and patches: which ones there are, and the limit of their multiples.

use stellate::error::Error;
use stellate::language::{Numbers, parse_form};
use stellate::shape::Form;

#[test]
fn a_parameter_that_falls_away_is_none() {
    let kind = |text: &str| match parse_form(text, "<form>", Numbers::Exact) {
        Ok(Form::PlaneCurve(_)) => "plane curve".to_owned(),
        Ok(Form::SpaceCurve(curve)) => format!("space curve in {}", curve.parameter().name()),
        Ok(Form::Patch(_)) => "patch".into(),
        Ok(other) => panic!("{text}: {other:?}"),
        Err(error) => error.to_string(),
    };
    assert_eq!(kind("x = t; y = t^2; z = u^0"), "space curve in t");
    assert_eq!(kind("x = t; y = t^2; z = t*phi^-0"), "space curve in t");
    assert_eq!(
        kind("x = u/u; y = cos(v); z = sin(v) + 0*u"),
        "space curve in v"
    );
    assert_eq!(kind("x = u; y = v; z = u^0"), "patch");
    for point in [
        "x = -0*t/(1+t^2); y = 0*t",
        "x = 0*t; y = (1-t^2)/(-1+t^2)",
        "x = cos(t)^2 + sin(t)^2; y = 2; z = 3",
        "x = u/u; y = 2*v^0; z = 3",
    ] {
        let message = kind(point);
        assert!(message.starts_with("<form>:1:1: "), "{point}: {message}");
        assert!(
            message.contains("a point, not a curve"),
            "{point}: {message}"
        );
    }
}

#[test]
fn the_limit_of_multiples_holds_for_what_the_form_is() {
    // cos(113t/280) cos t and cos 3t sin t have multiples of t/280 up to 393 and up to 1120.
    for (text, is_read) in [
        ("x = cos(113/280*t)*cos(t); y = cos(3t)", true),
        ("x = cos(113/280*t)*cos(t); y = cos(3t)*sin(t)", false),
        ("x = cos(1000t); y = sin(t)", true),
        ("x = cos(1000t)*cos(t); y = sin(t)", false),
        ("x = cos(t)^1000; y = sin(t)", true),
        ("x = cos(t)^1001; y = sin(t)", false),
        ("x = cos(t/1000) ; y = sin(t)", true),
    ] {
        let read = parse_form(text, "<form>", Numbers::Exact);
        assert_eq!(read.is_ok(), is_read, "{text}");
        match read {
            Ok(form) => assert_eq!(form.to_string().parse::<Form>().unwrap(), form, "{text}"),
            Err(error) => assert!(matches!(error, Error::Limit { .. }), "{text}: {error}"),
        }
    }
}
