//! probe
use stellate::arcs::{ArcOptions, trace_intersection};
use stellate::language::{Numbers, parse_form};
use stellate::limits::Limits;
use stellate::shape::Form;
#[test]
fn probe() {
    for (text, b) in [
        ("x^2+y^2+z^2 = 1; x^2+y^2 = z^2", 1.25),
        ("x^2+y^2+z^2 = 4; (x-1)^2+y^2 = 1", 2.5),
        ("x^3+y^3=1+x; z=x", 3.0),
        ("x^4+y^4+z^4=1; x^2+y^2=1/2+z/10", 1.3),
        ("x^2+y^2+z^2=1; x^2+y^2=1", 1.3),
        ("x^2+y^2+z^2=1; (x-2)^2+y^2+z^2=1", 1.3),
        (
            "(x^2+9/4*y^2+z^2-1)^3 - x^2*z^3 - 9/80*y^2*z^3; x^2+y^2+(z-1/2)^2=1/2",
            1.5,
        ),
    ] {
        let Form::Intersection(p) = parse_form(text, "<form>", Numbers::Exact).unwrap() else {
            panic!()
        };
        let options = ArcOptions {
            bounds: [[-b, b]; 3],
            resolution: 64,
        };
        let t = std::time::Instant::now();
        let found = trace_intersection([&p[0], &p[1]], &options, &Limits::none(), &|_| {}).unwrap();
        println!("{text}: {:?}", t.elapsed());
        for a in &found.arcs {
            let r = a.points.iter().map(|p| p.radius).fold(0.0, f64::max);
            println!(
                "   {} points {:?} radius {r:e} first {:?}",
                a.points.len(),
                a.ends,
                a.points[0].position
            );
        }
        println!(
            "   unresolved {} {:?}",
            found.unresolved.len(),
            found.unresolved.iter().take(3).collect::<Vec<_>>()
        );
    }
}
