//! Proofs about all points of a patch over a box of its parameters, in doubles with bounds of their errors.

use crate::error::Invariant;
use crate::intervals::Interval;
use crate::poly::SparsePolynomial;
use crate::shape::{Patch, PatchFunction};

/// The coordinates of a patch as quotients of forms in the two parameters. A parameter value may be infinite.
#[derive(Debug)]
pub(super) struct PatchBoxes {
    coordinates: [Quotient; 3],
    /// Whether it is proved that no denominator has a zero at any parameter values, so that the patch is connected.
    pub(super) is_connected: bool,
}

/// A numerator and a denominator as forms of the same degrees.
#[derive(Debug)]
struct Quotient {
    above: Terms,
    below: Terms,
    degrees: [usize; 2],
}

type Terms = Vec<([usize; 2], Interval)>;

/// A box of parameters: for each parameter, whether the variable is s or 1/s, and its range within [−1, 1].
#[derive(Clone, Copy)]
struct ParameterBox {
    is_inverse: [bool; 2],
    sides: [[f64; 2]; 2],
}

/// The number of boxes that may be divided to prove that a patch is connected.
const CONNECTED_BUDGET: usize = 10_000;

impl PatchBoxes {
    pub(super) fn new(patch: &Patch) -> Self {
        // A parameter that is a number takes no infinite value, so a denominator may vanish there; this case is not examined.
        let is_closed = |f: &SparsePolynomial<2>| {
            f.terms().all(|(e, _)| {
                let mut with_parameters = e.iter().zip(patch.parameters());
                with_parameters.all(|(e, parameter)| *e == 0 || parameter.is_angle())
            })
        };
        let denominators = patch.coordinates().each_ref().map(|f| f.denominator());
        let is_connected = denominators.iter().all(|f| is_closed(f)) && {
            let denominators = denominators.map(Quotient::of_polynomial);
            all(CONNECTED_BUDGET, |parameters| {
                denominators.iter().all(|d| {
                    let [value, _] = d.over(parameters);
                    value.sign().is_some()
                })
            })
        };
        Self {
            coordinates: patch.coordinates().each_ref().map(Quotient::new),
            is_connected,
        }
    }

    /// Whether it is proved, with at most `budget` boxes, that all points of the patch are farther from a point than `radius`.
    ///
    /// Lemma. Over a box, |n/d − p| ≥ min |n − p d| / max |d|.
    /// Proof. The quotient is at least the least numerator over the largest denominator. Where d = 0, the patch has no point.
    pub(super) fn are_farther(
        &self,
        point: &[Interval; 3],
        radius: Interval,
        budget: usize,
    ) -> bool {
        let level = radius.squared();
        all(budget, |parameters| {
            let mut sum = Interval::ZERO;
            for (quotient, p) in self.coordinates.iter().zip(point) {
                let [above, below] = quotient.over(parameters);
                let least = Interval::from((above - *p * below).mignitude());
                let most = below.magnitude();
                if least.low() > 0.0 && most == 0.0 {
                    return true;
                }
                if most > 0.0 {
                    sum = sum + (least / Interval::from(most)).squared();
                }
            }
            sum.low() > level.high()
        })
    }
}

/// Whether `is_proved` holds for every box of some division of all parameters into at most `budget` boxes.
fn all(budget: usize, is_proved: impl Fn(&ParameterBox) -> bool) -> bool {
    let charts = [[false, false], [false, true], [true, false], [true, true]];
    let mut open: Vec<ParameterBox> = charts
        .into_iter()
        .map(|is_inverse| ParameterBox {
            is_inverse,
            sides: [[-1.0, 1.0]; 2],
        })
        .collect();
    let mut divided = 0;
    while let Some(next) = open.pop() {
        if is_proved(&next) {
            continue;
        }
        divided += 1;
        if divided > budget {
            return false;
        }
        open.extend(next.halves());
    }
    true
}

/// The terms of a polynomial with enclosures of their coefficients.
fn terms(f: &SparsePolynomial<2>) -> Terms {
    let terms = f.terms();
    terms
        .map(|(e, c)| (e.map(|k| k as usize), Interval::narrowest(c)))
        .collect()
}

impl Quotient {
    fn new(f: &PatchFunction) -> Self {
        Self {
            above: terms(f.numerator()),
            below: terms(f.denominator()),
            degrees: [0, 1].map(|v| f.degree_in(v) as usize),
        }
    }

    /// A polynomial, as the quotient of a form of its degrees and 1.
    fn of_polynomial(f: &SparsePolynomial<2>) -> Self {
        let above = terms(f);
        let degree = |v: usize| above.iter().map(|(e, _)| e[v]).fold(0, usize::max);
        Self {
            degrees: [0, 1].map(degree),
            below: vec![([0, 0], Interval::from(1.0))],
            above,
        }
    }

    /// Enclosures of numerator and denominator over a box.
    fn over(&self, parameters: &ParameterBox) -> [Interval; 2] {
        let powers: [Vec<Interval>; 2] = [0, 1].map(|v| {
            let [low, high] = parameters.sides[v];
            powers(Interval::between(low, high), self.degrees[v])
        });
        let exponent = |v: usize, e: usize| match parameters.is_inverse[v] {
            false => e,
            true => self.degrees[v] - e,
        };
        [&self.above, &self.below].map(|terms| {
            let mut value = Interval::ZERO;
            for ([i, j], c) in terms {
                let monomial = powers[0][exponent(0, *i)] * powers[1][exponent(1, *j)];
                value = value + *c * monomial;
            }
            value
        })
    }
}

impl ParameterBox {
    /// The two halves of a box, which is divided across its longer side.
    fn halves(self) -> [Self; 2] {
        let length = |v: usize| self.sides[v][1] - self.sides[v][0];
        let across = usize::from(length(1) > length(0));
        let [low, high] = self.sides[across];
        let middle = f64::midpoint(low, high);
        [[low, middle], [middle, high]].map(|side| {
            let mut half = self;
            half.sides[across] = side;
            half
        })
    }
}

/// The powers 1, x, x², …. Even powers are squares, so that they are not negative.
fn powers(x: Interval, degree: usize) -> Vec<Interval> {
    let mut powers = vec![Interval::from(1.0)];
    for k in 1..=degree {
        let last = *powers.last().invariant("there is a first power");
        powers.push(match k % 2 {
            0 => powers[k / 2].squared(),
            _ => last * x,
        });
    }
    powers
}
