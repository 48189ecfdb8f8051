//! The usual mistakes of programs that convert a radius into a polynomial. Each is represented by the exact curve that it leads
//! to.

use std::borrow::Cow;

use super::comparison::{Comparison, Diagnosis};
use crate::error::Invariant;
use crate::exact::Rational;
use crate::implicitize::SquaredForm;
use crate::poly::{Ring, SparsePolynomial, total_degree};
use crate::shape::FourierRadius;

/// The numbers of correct digits at which a mistaken reference is compared with the right one. A number with fewer correct
/// digits is a fault.
const MARKS: [u32; 4] = [12, 9, 6, 3];

/// A mistake explains the faults only if the faults that are left, times this number, are at most the faults before.
const LEFT: usize = 10;

/// A mistake, and the form that it leads to instead of the reference.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Mistaken<T> {
    /// A short name: `a0 halved`.
    pub(super) name: Cow<'static, str>,
    /// What a program with this mistake does, and what would be right.
    pub(super) explanation: Cow<'static, str>,
    /// The exact form that such a program computes.
    pub(super) form: T,
}

/// The mistakes that explain the faults of a comparison. Only those count that give as many of the worst numbers as there are faults one
/// digit more on average: numbers that miss a mark by little can pass it by chance. At the highest mark at which some of them leaves at
/// most a tenth of the faults, these are the mistakes that leave the fewest. `compare` compares the same numbers with the form of a mistake.
pub(super) fn diagnose<T>(
    found: &Comparison,
    mistakes: impl IntoIterator<Item = Mistaken<T>>,
    compare: impl Fn(&T) -> Option<Comparison>,
) -> Vec<Diagnosis> {
    let faults = |comparison: &Comparison| MARKS.map(|mark| comparison.below(mark).len());
    let before = faults(found);
    if before[0] == 0 {
        return Vec::new();
    }
    let worst = before.map(|count| mean_of_worst(found, count));
    let tried = mistakes.into_iter().filter_map(|mistake| {
        let compared = compare(&mistake.form)?;
        let after = faults(&compared);
        let gains: [bool; MARKS.len()] =
            std::array::from_fn(|k| mean_of_worst(&compared, before[k]) >= worst[k] + 1.0);
        Some((mistake, after, gains))
    });
    let tried: Vec<_> = tried.collect();
    for (k, mark) in MARKS.into_iter().enumerate() {
        let gaining = || tried.iter().filter(|(.., gains)| gains[k]);
        let left = gaining().map(|(_, after, _)| after[k]).min();
        let Some(left) = left.filter(|left| before[k] > 0 && left * LEFT <= before[k]) else {
            continue;
        };
        let explain = gaining().filter(|(_, after, _)| after[k] == left);
        return explain
            .map(|(mistake, ..)| Diagnosis {
                name: mistake.name.clone(),
                explanation: mistake.explanation.clone(),
                mark,
                compared: found.all().count(),
                faults: before[k],
                faults_left: left,
            })
            .collect();
    }
    Vec::new()
}

/// The number of correct digits of the `count` worst numbers, on average.
#[expect(clippy::cast_precision_loss, reason = "a count of numbers is small")]
fn mean_of_worst(comparison: &Comparison, count: usize) -> f64 {
    let mut digits: Vec<f64> = comparison.all().map(|row| row.deviation.digits()).collect();
    digits.sort_unstable_by(f64::total_cmp);
    digits.truncate(count);
    digits.iter().sum::<f64>() / digits.len().max(1) as f64
}

/// The radii that mistakes with the series lead to, without those that leave this radius unchanged or give 0.
pub(super) fn mistaken_radii(radius: &FourierRadius) -> Vec<Mistaken<FourierRadius>> {
    let half = || Rational::from_dyadic(1.into(), -1);
    let (one, two) = (Rational::one, || Rational::from(2));
    let scaled = |mean: Rational, others: Rational| {
        mapped(radius, |n, a, b| {
            let factor = if n == 0 { &mean } else { &others };
            [a * factor, b * factor]
        })
    };
    let sign = |n: usize| Rational::from(if n.is_multiple_of(2) { 1 } else { -1 });
    let opposite = |n: usize, a: &Rational, b: &Rational| [a * &sign(n), b * &sign(n)];
    let all = vec![
        Mistaken {
            name: "a0 halved".into(),
            explanation: "a0 is the mean of the radii, 1/Ns times their sum, and not half of it".into(),
            form: scaled(half(), one()),
        },
        Mistaken {
            name: "a0 doubled".into(),
            explanation: "the series begins with a0, the mean of the radii; one that begins with a0/2 has twice that a0".into(),
            form: scaled(two(), one()),
        },
        Mistaken {
            name: "all coefficients halved".into(),
            explanation: "Definition 1 as it is printed: right are a0 = 1/Ns sum r(k), and an, bn with 2/Ns".into(),
            form: scaled(half(), half()),
        },
        Mistaken {
            name: "all coefficients doubled".into(),
            explanation: "right are a0 = 1/Ns sum r(k), and an, bn with 2/Ns; these are twice that".into(),
            form: scaled(two(), two()),
        },
        Mistaken {
            name: "an and bn halved".into(),
            explanation: "the factor of an and bn is 2/Ns; 1/Ns is that of a0".into(),
            form: scaled(one(), half()),
        },
        Mistaken {
            name: "an and bn doubled".into(),
            explanation: "an and bn are counted twice, as the amplitudes of a spectrum with two sides are".into(),
            form: scaled(one(), two()),
        },
        Mistaken {
            name: "x and y swapped".into(),
            explanation: "x = r cos t and y = r sin t; with the two exchanged (rows and columns of an image) it is r(pi/2 - t)".into(),
            form: mapped(radius, |n, a, b| match n % 4 {
                0 => [a.clone(), -b],
                1 => [b.clone(), a.clone()],
                2 => [-a, b.clone()],
                _ => [-b, -a],
            }),
        },
        Mistaken {
            name: "sine sign flipped".into(),
            explanation: "r(-t): the contour runs clockwise, or y points down as in images, or bn has the sign of a transform with exp(-i n t)".into(),
            form: mapped(radius, |_, a, b| [a.clone(), -b]),
        },
        Mistaken {
            name: "x mirrored".into(),
            explanation: "r(pi - t): the sign of x, or angles measured from -x the other way round".into(),
            form: mapped(radius, |n, a, b| [a * &sign(n), -(b * &sign(n))]),
        },
        Mistaken {
            name: "curve reflected in the origin".into(),
            explanation: "r(t + pi): all odd harmonics, or the part of odd degree of F, have the wrong sign".into(),
            form: mapped(radius, opposite),
        },
        Mistaken {
            name: "reflected branch".into(),
            explanation: "-r(t + pi), the other solution of F = 0 on the same line: the wrong sign before the root".into(),
            form: mapped(radius, |n, a, b| opposite(n, a, b).map(|v| -v)),
        },
        Mistaken {
            name: "last harmonic dropped".into(),
            explanation: "N is one too small, and the degree 2(N + 1) two".into(),
            form: truncated(radius, radius.harmonics().saturating_sub(1)),
        },
    ];
    let single = single_coefficients(radius);
    let differs = |m: &Mistaken<FourierRadius>| m.form != *radius && !m.form.is_zero();
    all.into_iter().chain(single).filter(differs).collect()
}

/// Mistakes with a single coefficient, or with the indices of the harmonics.
fn single_coefficients(radius: &FourierRadius) -> Vec<Mistaken<FourierRadius>> {
    let last = radius.harmonics();
    let keep = |a: &Rational, b: &Rational| [a.clone(), b.clone()];
    let mut all = vec![
        Mistaken {
            name: "last sine dropped".into(),
            explanation: "the sum over the sines ends one too early".into(),
            form: mapped(radius, |n, a, b| {
                if n == last { [a.clone(), Rational::zero()] } else { keep(a, b) }
            }),
        },
        Mistaken {
            name: "last cosine dropped".into(),
            explanation: "the sum over the cosines ends one too early".into(),
            form: mapped(radius, |n, a, b| {
                if n == last { [Rational::zero(), b.clone()] } else { keep(a, b) }
            }),
        },
        Mistaken {
            name: "harmonics shifted by one".into(),
            explanation: "every harmonic has the coefficients of the one before: an index begins at 0 instead of 1".into(),
            form: mapped(radius, |n, a, b| match n {
                0 => keep(a, b),
                1 => [radius.cos(0).clone(), Rational::zero()],
                _ => keep(radius.cos(n - 1), radius.sin(n - 1)),
            }),
        },
        Mistaken {
            name: "harmonics shifted by one".into(),
            explanation: "every harmonic has the coefficients of the next: an index begins at 1 instead of 0".into(),
            form: mapped(radius, |n, a, b| match n {
                0 => keep(a, b),
                _ if n == last => [Rational::zero(), Rational::zero()],
                _ => keep(radius.cos(n + 1), radius.sin(n + 1)),
            }),
        },
    ];
    if last <= MOST_FLIPPED {
        for k in 0..=last {
            let flipped = |name: String, form| Mistaken {
                name: name.into(),
                explanation: "this coefficient has the wrong sign".into(),
                form,
            };
            let at = |n: usize| Rational::from(if n == k { -1 } else { 1 });
            all.push(flipped(
                format!("sign of a{k} flipped"),
                mapped(radius, |n, a, b| [a * &at(n), b.clone()]),
            ));
            all.push(flipped(
                format!("sign of b{k} flipped"),
                mapped(radius, |n, a, b| [a.clone(), b * &at(n)]),
            ));
        }
    }
    all
}

/// The largest number of harmonics for which the sign of every coefficient is tried.
const MOST_FLIPPED: usize = 40;

/// The radius with the coefficients f(n, a_n, b_n).
fn mapped(
    radius: &FourierRadius,
    f: impl Fn(usize, &Rational, &Rational) -> [Rational; 2],
) -> FourierRadius {
    let pairs = radius.cosines().iter().zip(radius.sines()).enumerate();
    let (cos, sin) = pairs
        .map(|(n, (a, b))| {
            let [a, b] = f(n, a, b);
            (a, b)
        })
        .unzip();
    FourierRadius::new(cos, sin).with_center(radius.center().clone())
}

/// The radius without its harmonics above the given one.
pub(super) fn truncated(radius: &FourierRadius, harmonics: usize) -> FourierRadius {
    mapped(radius, |n, a, b| {
        if n <= harmonics {
            [a.clone(), b.clone()]
        } else {
            [Rational::zero(), Rational::zero()]
        }
    })
}

/// The polynomials that mistakes lead to: mistakes with the series if the curve has one, otherwise with the coordinates, and
/// mistakes with the degree.
pub(super) fn mistaken_polynomials(
    polynomial: &SparsePolynomial<3>,
    radius: Option<&FourierRadius>,
    in_space: bool,
) -> Vec<Mistaken<SparsePolynomial<3>>> {
    let mut all = match radius {
        Some(radius) => of_series(radius, polynomial),
        None => of_coordinates(polynomial, in_space),
    };
    let axes = if in_space { 3 } else { 2 };
    let rho = SparsePolynomial::from_terms((0..axes).map(|axis| {
        let exponents = std::array::from_fn(|i| if i == axis { 2 } else { 0 });
        (exponents, Rational::one())
    }));
    all.push(Mistaken {
        name: "degree too high by two".into(),
        explanation: "the polynomial times the squared radius: N was taken one too large, or a factor was not divided out".into(),
        form: polynomial.times(&rho),
    });
    if polynomial.len() <= LONGEST_SQUARED {
        all.push(Mistaken {
            name: "squared once too often".into(),
            explanation: "the polynomial squared has the same zeros, each twice".into(),
            form: polynomial.squared(),
        });
    }
    all.retain(|m| m.form != *polynomial && m.form.as_constant().is_none());
    all
}

/// The largest number of terms of a polynomial that is squared; longer ones take too long.
const LONGEST_SQUARED: usize = 400;

fn of_series(
    radius: &FourierRadius,
    polynomial: &SparsePolynomial<3>,
) -> Vec<Mistaken<SparsePolynomial<3>>> {
    let expanded = |radius: &FourierRadius| {
        let form = SquaredForm::new(radius).ok()?;
        Some(SparsePolynomial::from(form.expand().polynomial()))
    };
    let mut all: Vec<Mistaken<SparsePolynomial<3>>> = mistaken_radii(radius)
        .into_iter()
        .filter_map(|m| {
            Some(Mistaken {
                name: m.name,
                explanation: m.explanation,
                form: expanded(&m.form)?,
            })
        })
        .collect();
    let Ok(form) = SquaredForm::new(radius) else {
        return all;
    };
    let top = polynomial.degree();
    let top = top.invariant("the polynomial of a curve is not 0");
    let scaled = |below: u64, factor: Rational| {
        let terms = polynomial.terms().map(|(e, c)| {
            let is_part = total_degree(e) + below == top;
            (*e, if is_part { c * &factor } else { c.clone() })
        });
        SparsePolynomial::from_terms(terms)
    };
    all.push(Mistaken {
        name: "cross term once".into(),
        explanation:
            "the part of degree 2N + 1 is the cross term of a square: it stands there twice".into(),
        form: scaled(1, Rational::from_dyadic(1.into(), -1)),
    });
    all.push(Mistaken {
        name: "sign of the low part".into(),
        explanation: "the part of degree 2N has the wrong sign: the sides of Eq. (7) or (8) are added, or subtracted the other way round".into(),
        form: scaled(2, Rational::from(-1)),
    });
    let [left, right] = form.sides().map(|side| SparsePolynomial::from(&side));
    all.push(Mistaken {
        name: "unsquared form".into(),
        explanation:
            "one side of Eq. (7) or (8) alone, without the square that removes the odd powers of r"
                .into(),
        form: left.clone(),
    });
    all.push(Mistaken {
        name: "unsquared form".into(),
        explanation: "the difference of the sides of Eq. (7) or (8) before they are squared, with the odd power of r left out".into(),
        form: left.minus(&right),
    });
    if left.len() <= LONGEST_SQUARED {
        all.push(Mistaken {
            name: "r^2 left out".into(),
            explanation: "the difference of the squares in Eq. (7) or (8) without the factor r^2 of one of them".into(),
            form: left.squared().minus(&right.squared()),
        });
    }
    all
}

fn of_coordinates(
    polynomial: &SparsePolynomial<3>,
    in_space: bool,
) -> Vec<Mistaken<SparsePolynomial<3>>> {
    let swapped = |a: usize, b: usize| {
        let terms = polynomial.terms().map(|(e, c)| {
            let mut e = *e;
            e.swap(a, b);
            (e, c.clone())
        });
        SparsePolynomial::from_terms(terms)
    };
    // f with some of its coordinates multiplied by the factor.
    let scaled = |axes: &[usize], factor: Rational| {
        let terms = polynomial.terms().map(|(e, c)| {
            let power: i64 = axes.iter().map(|&axis| i64::from(e[axis])).sum();
            let power = factor.pow(power);
            (*e, c * &power.invariant("an exponent is not negative"))
        });
        SparsePolynomial::from_terms(terms)
    };
    let minus = || Rational::from(-1);
    let all_axes = [0, 1, 2];
    let coordinates =
        "the roles of two coordinates, or rows and columns of an image, are exchanged";
    let mirrored = "one coordinate has the wrong sign";
    let mut all = vec![
        ("x and y swapped", coordinates, swapped(0, 1)),
        ("x mirrored", mirrored, scaled(&[0], minus())),
        ("y mirrored", mirrored, scaled(&[1], minus())),
        (
            "reflected in the origin",
            "the parts of odd degree have the wrong sign",
            scaled(&all_axes, minus()),
        ),
        (
            "half the size",
            "all coordinates are halved, as Definition 1 does as it is printed",
            scaled(&all_axes, Rational::from(2)),
        ),
        (
            "twice the size",
            "all coordinates are doubled",
            scaled(&all_axes, Rational::from_dyadic(1.into(), -1)),
        ),
    ];
    if in_space {
        all.push(("x and z swapped", coordinates, swapped(0, 2)));
        all.push(("y and z swapped", coordinates, swapped(1, 2)));
        all.push(("z mirrored", mirrored, scaled(&[2], minus())));
    }
    all.into_iter()
        .map(|(name, explanation, form)| Mistaken {
            name: name.into(),
            explanation: explanation.into(),
            form,
        })
        .collect()
}
