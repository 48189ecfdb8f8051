//! Equations of curves and patches: they vanish at more parameters than their degrees allow, and have the degrees that the
//! number of parameters of a general point says.

use std::time::Duration;

use num_bigint::BigInt;
use num_traits::{One, Zero};
use stellate::implicitize::{IsolatedPoint, implicitize_patch, implicitize_plane, real_image};
use stellate::limits::Limits;
use stellate::parametrize::{Rationality, rational_parametrization};
use stellate::poly::{BinaryForm, RationalFunction, SparsePolynomial};
use stellate::shape::{Parameter, Patch, PatchFunction, PlaneCurve};

use super::draw::Draw;
use super::exact::{Poly, Q, Sturm, num, our};
use super::harness::Outcome;
use super::terms::{Terms, plane_terms, random, space_terms, value_of};

/// A rational function as the case has it.
#[derive(Clone, Debug)]
struct Function {
    top: Poly,
    bottom: Poly,
}

impl Function {
    fn value(&self, at: &Q) -> Option<Q> {
        let below = self.bottom.value_at(at);
        (!below.is_zero()).then(|| self.top.value_at(at) / below)
    }

    /// Numerator of f(t) − v.
    fn minus(&self, v: &Q) -> Poly {
        let other = self.bottom.scaled(&-v.numer());
        self.top.scaled(v.denom()).plus(&other)
    }

    /// In lowest terms, the larger degree.
    fn degree(&self) -> usize {
        let common = self.top.gcd(&self.bottom).degree();
        self.top.degree().max(self.bottom.degree()) - common
    }

    fn ours(&self) -> RationalFunction {
        RationalFunction::new(&self.top.to_coefficients(), &self.bottom.to_coefficients()).unwrap()
    }

    fn text(&self) -> String {
        let poly = |f: &Poly| {
            let terms = f.0.iter().enumerate().map(|(k, c)| format!("({c})*t^{k}"));
            terms.collect::<Vec<_>>().join(" + ")
        };
        format!("({})/({})", poly(&self.top), poly(&self.bottom))
    }
}

fn small_poly(draw: &mut Draw, degree: u64, size: i64) -> Poly {
    let degree = draw.below(degree + 1);
    Poly::new((0..=degree).map(|_| draw.small(size).into()).collect())
}

/// Two functions of the same parameter: polynomials, fractions, trigonometric series, some in powers of another function.
fn coordinates(draw: &mut Draw, degree: u64) -> Option<[Function; 2]> {
    let size = draw.pick(&[2, 5, 30]);
    let mut functions = match draw.below(4) {
        0 => [0; 2].map(|_: i32| Function {
            top: small_poly(draw, degree, size),
            bottom: Poly::of(&[1]),
        }),
        1 => {
            let bottom = small_poly(draw, degree / 2, size);
            [0; 2].map(|_: i32| Function {
                top: small_poly(draw, degree, size),
                bottom: bottom.clone(),
            })
        }
        2 => [0; 2].map(|_: i32| Function {
            top: small_poly(draw, degree, size),
            bottom: small_poly(draw, degree, size),
        }),
        _ => {
            // A form of degree 2n in (1 − s², 2s) over (1 + s²)^n
            let n = 1 + draw.index((degree / 2) as usize);
            [0; 2].map(|_: i32| {
                let parts = (0..=n).map(|k| {
                    let c = Poly::of(&[1, 0, -1]).power(k);
                    let s = Poly::of(&[0, 2]).power(n - k);
                    c.times(&s).scaled(&draw.small(size).into())
                });
                Function {
                    top: parts.fold(Poly::of(&[]), |sum, part| sum.plus(&part)),
                    bottom: Poly::of(&[1, 0, 1]).power(n),
                }
            })
        }
    };
    if functions.iter().any(|f| f.bottom.is_zero()) {
        return None;
    }
    // Run over several times.
    if draw.once_in(5) {
        let inner = draw.pick(&[vec![0i64, 0, 1], vec![1, 1, 2], vec![0, -1, 0, 1]]);
        let inner = Poly::of(&inner);
        let compose = |f: &Poly| {
            let terms = f.0.iter().rev();
            terms.fold(Poly::of(&[]), |sum, c| {
                sum.times(&inner).plus(&Poly::new(vec![c.clone()]))
            })
        };
        for f in &mut functions {
            *f = Function {
                top: compose(&f.top),
                bottom: compose(&f.bottom),
            };
        }
    }
    let constant = functions.iter().any(|f| f.degree() == 0);
    (!constant).then_some(functions)
}

fn curve_of(functions: &[Function; 2]) -> PlaneCurve {
    PlaneCurve::new(
        Parameter::number("t"),
        functions.each_ref().map(Function::ours),
    )
}

fn limits(seconds: u64) -> Limits {
    Limits::none().with_time_limit(Duration::from_secs(seconds))
}

/// The degrees in each variable.
fn degrees<const V: usize>(terms: &[([u32; V], Q)]) -> [u32; V] {
    std::array::from_fn(|v| terms.iter().map(|(e, _)| e[v]).max().unwrap_or(0))
}

/// f = 0 at so many parameters that f(x(t), y(t)) = 0.
fn assert_vanishes(terms: &[([u32; 2], Q)], functions: &[Function; 2]) {
    let top = degrees(terms);
    let most = functions
        .iter()
        .zip(top)
        .map(|(f, d)| f.top.degree().max(f.bottom.degree()) * d as usize);
    let mut left = most.sum::<usize>() + 1;
    let mut t = 0i64;
    while left > 0 {
        let at = Q::from_integer(t.into());
        t = if t > 0 { -t } else { 1 - t };
        if let [Some(x), Some(y)] = functions.each_ref().map(|f| f.value(&at)) {
            assert!(
                value_of(terms.to_vec(), &[x, y]).is_zero(),
                "f(α({at})) is not 0"
            );
            left -= 1;
        }
    }
}

pub(crate) fn plane_curves(draw: &mut Draw) -> Outcome {
    let Some(functions) = coordinates(draw, 5) else {
        return Outcome::Open;
    };
    let [x, y] = functions.each_ref().map(Function::text);
    draw.input = format!("stellate implicitize 'x = {x}; y = {y}'");
    let Ok(equation) = implicitize_plane(&curve_of(&functions), &limits(20)) else {
        return Outcome::Open;
    };
    let terms = plane_terms(equation.curve.polynomial());
    assert_vanishes(&terms, &functions);
    // How many parameters a general point has: as most of some have, since one may be infinite and others may meet.
    let counts = (0..5).filter_map(|_| {
        let at = draw.fraction(100, 20);
        let point = functions.each_ref().map(|f| f.value(&at));
        let [Some(x), Some(y)] = point else {
            return None;
        };
        let [a, b] = [functions[0].minus(&x), functions[1].minus(&y)];
        // Without the common factors of numerator and denominator.
        let poles = functions[0].bottom.times(&functions[1].bottom);
        let mut common = a.gcd(&b);
        loop {
            let with_poles = common.gcd(&poles);
            if with_poles.degree() == 0 {
                break;
            }
            common = divided(&common, &with_poles);
        }
        Some(common.degree())
    });
    let mut counts: Vec<usize> = counts.collect();
    counts.sort_unstable();
    if counts.len() < 3 {
        return Outcome::Open;
    }
    let count = counts[counts.len() / 2];
    assert_eq!(count, equation.tracing_index, "the tracing index");
    let [in_x, in_y] = degrees(&terms).map(|d| d as usize * equation.tracing_index);
    assert_eq!(
        [in_x, in_y],
        [functions[1].degree(), functions[0].degree()],
        "degrees"
    );
    Outcome::Checked
}

/// The exact quotient.
fn divided(f: &Poly, g: &Poly) -> Poly {
    f.primitive().quotient(&g.primitive())
}

/// A claimed isolated point is on the curve, and no real parameter reaches it, infinity included.
pub(crate) fn isolated_points(draw: &mut Draw) -> Outcome {
    let Some(functions) = coordinates(draw, 4) else {
        return Outcome::Open;
    };
    let [x, y] = functions.each_ref().map(Function::text);
    draw.input = format!("stellate implicitize 'x = {x}; y = {y}'");
    let curve = curve_of(&functions);
    let Ok(equation) = implicitize_plane(&curve, &limits(10)) else {
        return Outcome::Open;
    };
    let Ok(image) = real_image(&curve, equation.tracing_index, &limits(10)) else {
        return Outcome::Open;
    };
    let terms = plane_terms(equation.curve.polynomial());
    let mut claims = 0;
    for point in &image.isolated.points {
        let IsolatedPoint::Exact(point) = point else {
            continue;
        };
        claims += 1;
        let point = [num(&point[0]), num(&point[1])];
        assert!(
            value_of(terms.clone(), &point).is_zero(),
            "{point:?} is on the curve"
        );
        let [a, b] = [functions[0].minus(&point[0]), functions[1].minus(&point[1])];
        let mut common = a.gcd(&b);
        let poles = functions[0].bottom.times(&functions[1].bottom);
        loop {
            let with_poles = common.gcd(&poles);
            if with_poles.degree() == 0 {
                break;
            }
            common = divided(&common, &with_poles);
        }
        let real = if common.degree() == 0 {
            0
        } else {
            Sturm::new(&common).count()
        };
        assert_eq!(real, 0, "real parameters reach {point:?}");
        let at_infinity = functions.iter().zip(&point).all(|(f, v)| {
            let (top, bottom) = (f.top.degree(), f.bottom.degree());
            match top.cmp(&bottom) {
                std::cmp::Ordering::Greater => false,
                std::cmp::Ordering::Less => v.is_zero(),
                std::cmp::Ordering::Equal => {
                    Q::new(f.top.0[top].clone(), f.bottom.0[bottom].clone()) == *v
                }
            }
        });
        assert!(!at_infinity, "t = ∞ reaches {point:?}");
    }
    if claims > 0 {
        Outcome::Checked
    } else {
        Outcome::Open
    }
}

pub(crate) fn patches(draw: &mut Draw) -> Outcome {
    let degree = 1 + draw.below(2) as u32;
    let polynomial = |draw: &mut Draw| {
        let mut terms = Vec::new();
        for i in 0..=degree {
            for j in 0..=degree {
                if draw.once_in(2) {
                    terms.push(([i, j], BigInt::from(draw.small(4))));
                }
            }
        }
        Terms::<2>::new(terms)
    };
    let one = Terms::<2>::constant(BigInt::one());
    let shared = if draw.once_in(3) {
        polynomial(draw)
    } else {
        one.clone()
    };
    let mut functions: Vec<(Terms<2>, Terms<2>)> = Vec::new();
    for _ in 0..3 {
        let bottom = if draw.once_in(4) {
            one.clone()
        } else {
            shared.clone()
        };
        functions.push((polynomial(draw), bottom));
    }
    if functions
        .iter()
        .any(|(p, q)| p.0.is_empty() || q.0.is_empty())
    {
        return Outcome::Open;
    }
    let texts = functions.iter().zip(["x", "y", "z"]).map(|((p, q), name)| {
        let text = |f: &Terms<2>| f.text().replace('x', "u").replace('y', "v");
        format!("{name} = ({})/({})", text(p), text(q))
    });
    draw.input = format!(
        "stellate implicitize '{}'",
        texts.collect::<Vec<_>>().join("; ")
    );
    let ours = |f: &Terms<2>| {
        SparsePolynomial::<2>::from_terms(
            f.0.iter()
                .map(|(e, c)| (*e, our(&Q::from_integer(c.clone())))),
        )
    };
    let none = Limits::none();
    let made: Option<Vec<PatchFunction>> = functions
        .iter()
        .map(|(p, q)| PatchFunction::new(&ours(p), &ours(q), &none).unwrap())
        .collect();
    let Some(Ok(made)) = made.map(<[PatchFunction; 3]>::try_from) else {
        return Outcome::Open;
    };
    let patch = Patch::new(["u", "v"].map(Parameter::number), made);
    let Ok(equation) = implicitize_patch(&patch, &limits(20)) else {
        return Outcome::Open;
    };
    let terms = space_terms(equation.surface.polynomial());
    // In each parameter the numerator of f∘α has at most this degree; a grid of one more of each decides.
    let degree_in = |v: usize| {
        let one = |f: &Terms<2>| f.0.keys().map(|e| e[v]).max().unwrap_or(0);
        let each = functions.iter().map(|(p, q)| one(p).max(one(q)));
        let top = degrees(&terms);
        each.zip(top).map(|(d, e)| d * e).sum::<u32>()
    };
    let values = |count: u32, poles: &dyn Fn(&Q) -> bool| {
        let all = (0..)
            .map(|k: i64| Q::from_integer((if k % 2 == 0 { k / 2 } else { -k / 2 - 1 }).into()));
        all.filter(|q| !poles(q))
            .take(count as usize + 1)
            .collect::<Vec<_>>()
    };
    // Not more points than take a second.
    let grid = [degree_in(0), degree_in(1)];
    let is_sample = grid[0] * grid[1] > 150;
    let [us, vs] = grid.map(|d| values(d, &|_| false));
    let mut asked = 0;
    for u in &us {
        for v in &vs {
            if is_sample && !draw.once_in(u64::from(grid[0] * grid[1]) / 60) {
                continue;
            }
            let at = [u.clone(), v.clone()];
            let mut point = [Q::zero(), Q::zero(), Q::zero()];
            let mut is_pole = false;
            for (value, (p, q)) in point.iter_mut().zip(&functions) {
                let below = q.value_at(&at);
                is_pole |= below.is_zero();
                if !below.is_zero() {
                    *value = p.value_at(&at) / below;
                }
            }
            if !is_pole {
                asked += 1;
                assert!(
                    value_of(terms.clone(), &point).is_zero(),
                    "f(α({u}, {v})) is not 0"
                );
            }
        }
    }
    if asked > 0 {
        Outcome::Checked
    } else {
        Outcome::Open
    }
}

/// w² = form(1, t) as Poly in t.
fn of_form(form: &BinaryForm) -> Poly {
    // Coefficients of x^(d−k) y^k.
    Poly::new(form.coefficients())
}

/// Claimed parametrizations satisfy the equation; conics that are said to have no rational point have none of small height.
pub(crate) fn rational_curves(draw: &mut Draw) -> Outcome {
    let size = draw.pick(&[3, 12, 200]);
    let form = |draw: &mut Draw, degree: u32| {
        let terms = (0..=degree).map(|k| ([degree - k, k], BigInt::from(draw.small(size))));
        Terms::<2>::new(terms.collect::<Vec<_>>())
    };
    let top = 2 + draw.below(3) as u32;
    let f = match draw.below(3) {
        0 => form(draw, top).plus(&form(draw, top - 1)),
        1 => form(draw, top)
            .plus(&form(draw, top - 1))
            .plus(&form(draw, top - 2)),
        _ => form(draw, 2).plus(&form(draw, 1)).plus(&form(draw, 0)),
    };
    if f.degree() == 0 {
        return Outcome::Open;
    }
    draw.input = format!("stellate parametrize '{}'", f.text());
    let polynomial = f.to_plane();
    match rational_parametrization(&polynomial) {
        Some(Rationality::Parametrized(curve)) => {
            let functions = [&curve.x, &curve.y].map(|f| {
                let [top, bottom] = f.coefficients().map(|c| Poly::of_coefficients(&c));
                Function { top, bottom }
            });
            assert_vanishes(&plane_terms(&polynomial), &functions);
        }
        Some(Rationality::NoRationalPoint { conic, .. }) => {
            let conic = of_form(&conic);
            let degree = conic.degree().max(2);
            for q in 1..12i64 {
                for p in -12..13i64 {
                    let at = Q::new(p.into(), q.into());
                    let value = conic.value_at(&at);
                    let root = our(&value).sqrt();
                    assert!(root.is_none(), "w² = {value} at t = {at}, degree {degree}");
                }
            }
        }
        _ => return Outcome::Open,
    }
    Outcome::Checked
}

#[test]
fn a_random_function_is_what_its_text_says() {
    let mut draw = Draw::new("function", 1);
    let terms = random::<2>(&mut draw, 3, 5);
    assert!(terms.degree() > 0);
    let f = Function {
        top: Poly::of(&[-1, 0, 1]),
        bottom: Poly::of(&[1, 1]),
    };
    assert_eq!(f.degree(), 1);
    assert_eq!(
        f.value(&Q::from_integer(3.into())),
        Some(Q::from_integer(2.into()))
    );
}
