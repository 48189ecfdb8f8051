//! Factors over an imaginary quadratic field, of a polynomial that is irreducible over Q.

use crate::error::{Invariant, Result};
use crate::exact::Rational;
use crate::limits::Limits;
use crate::modular::{PrimeField, Reconstruction, SplitMix, kernel, large_primes};
use crate::poly::{Ring, SparsePolynomial};

#[cfg(test)]
#[path = "conjugate_laws.rs"]
mod laws;

/// Polynomials of higher degrees are not split: the linear systems have some thousand unknowns.
const MAX_DEGREE: u64 = 10;
/// The number of rows beyond those that are needed; each makes an accidental solution 2³¹ times less likely.
const MORE_POINTS: usize = 8;
/// A lifting ends without a result after so many primes.
const MAX_PRIMES: usize = 2000;
/// The sign of f is compared at so many points.
const SAMPLES: u64 = 40;

/// Polynomials g and h over Q with c·f = g² + D·h², c ≠ 0, D > 0: the real zeros of f are the common zeros of g and h. `None` if f has no
/// such pair, and for degrees above 10. f must be irreducible over Q.
///
/// f is then φ·φ̄ with φ = g + √−D h. As in Ruppert's and Gao's method, the closed forms (G dx + H dy + K dz)/f with G, H, K of degrees
/// less than n = deg f are spanned by the dφ/φ of the absolutely irreducible factors. So there are two of them: df/f, and one
/// that is found by linear algebra modulo primes. Its multiple without trace is ω = √−D (dφ/φ − dφ̄/φ̄), where −D is its square on f = 0
/// divided by that of df. Then dφ/φ = (df/f + ω/√−D)/2 is a linear system for φ. In the end the identity is checked exactly; nothing
/// rests on the rest.
///
/// Cost: Gaussian elimination with n(n + 1)(n + 2)/2 unknowns, unless f changes its sign at sample points.
///
/// # Errors
/// Those of `limits`.
pub(crate) fn conjugate_pair(
    f: &SparsePolynomial<3>,
    limits: &Limits,
) -> Result<Option<[SparsePolynomial<3>; 2]>> {
    let f = &f.primitive();
    let Some(degree) = f.degree().filter(|n| n % 2 == 0 && *n <= MAX_DEGREE) else {
        return Ok(None);
    };
    if degree == 0 || changes_sign(f) {
        return Ok(None);
    }
    let Some(form) = traceless_form(f, degree, limits)? else {
        return Ok(None);
    };
    let Some(square) = square_on_zeros(f, &form).filter(|square| square.signum() < 0) else {
        return Ok(None);
    };
    let Some([g, h]) = factor(f, degree, &form, &square, limits)? else {
        return Ok(None);
    };
    let norm = g.squared().minus(&h.squared().scaled(&square));
    let lead = |f: &SparsePolynomial<3>| f.terms().map(|(_, c)| c.clone()).next();
    let is_norm = lead(&norm)
        .zip(lead(f))
        .is_some_and(|(a, b)| norm == f.scaled(&(a / b)));
    if !is_norm {
        return Ok(None);
    }
    let [g, h] = reduced(g, h).map(|f| squarefree(&f, limits));
    let mut both = [g?, h?];
    if both[0].degree() > both[1].degree() {
        both.swap(0, 1);
    }
    Ok(Some(both))
}

/// The product of the different irreducible factors, which has the same zeros.
fn squarefree(f: &SparsePolynomial<3>, limits: &Limits) -> Result<SparsePolynomial<3>> {
    let one = SparsePolynomial::constant(Rational::one());
    let factors = super::factor_space(f, limits)?.factors;
    Ok(factors
        .iter()
        .fold(one, |all, factor| all.times(&factor.polynomial)))
}

/// Whether f has both signs at some points; a norm g² + D·h² has not.
fn changes_sign(f: &SparsePolynomial<3>) -> bool {
    let mut random = SplitMix(1);
    let mut signs = [false; 2];
    for k in 0..SAMPLES {
        // Multiples of 1/16, at most 4 to 100 in size.
        let most = 64 * (1 + (k % 5) * (k % 5));
        let point = [0; 3].map(|_| {
            let [at, middle] = [random.next() % (2 * most), most]
                .map(|n| i64::try_from(n).invariant("less than 2^12"));
            Rational::from(at - middle) / Rational::from(16)
        });
        match f.evaluate(&point).signum() {
            1 => signs[0] = true,
            -1 => signs[1] = true,
            _ => {}
        }
        if signs == [true; 2] {
            return true;
        }
    }
    false
}

/// The monomials of degree at most `degree`.
fn monomials(degree: u64) -> Vec<[u32; 3]> {
    let n = u32::try_from(degree).invariant("a degree of at most 10");
    let mut all = Vec::new();
    for i in 0..=n {
        for j in 0..=n - i {
            all.extend((0..=n - i - j).map(|k| [i, j, k]));
        }
    }
    all
}

fn gradient(f: &SparsePolynomial<3>) -> [SparsePolynomial<3>; 3] {
    [0, 1, 2].map(|axis| f.derivative(axis))
}

/// Polynomials modulo a prime, for values at points.
struct Modulo {
    field: PrimeField,
    random: SplitMix,
}

/// A point modulo a prime, as lists of powers.
struct Powers([Vec<u64>; 3]);

impl Modulo {
    fn new(prime: u64) -> Self {
        Self {
            field: PrimeField::new(prime),
            random: SplitMix(prime),
        }
    }

    fn point(&mut self, degree: u64) -> Powers {
        let count = usize::try_from(degree).invariant("a degree of at most 10") + 1;
        Powers([0; 3].map(|_| {
            let x = self.random.next() % self.field.prime();
            self.field.powers(x, count)
        }))
    }

    /// `None` if the prime divides the denominator.
    fn number(&self, c: &Rational) -> Option<u64> {
        let [above, below] =
            [c.numerator(), c.denominator()].map(|n| self.field.reduce_integer(&n));
        (below != 0).then(|| self.field.mul(above, self.field.inverse(below)))
    }

    fn polynomial(&self, f: &SparsePolynomial<3>) -> Option<Vec<([u32; 3], u64)>> {
        f.terms()
            .map(|(e, c)| Some((*e, self.number(c)?)))
            .collect()
    }

    fn monomial(&self, e: &[u32; 3], at: &Powers) -> u64 {
        let [x, y, z] = [0, 1, 2].map(|v| at.0[v][e[v] as usize]);
        self.field.mul(self.field.mul(x, y), z)
    }

    /// The derivative of a monomial.
    fn slope(&self, e: &[u32; 3], axis: usize, at: &Powers) -> u64 {
        let mut lower = *e;
        match lower[axis].checked_sub(1) {
            None => 0,
            Some(less) => {
                lower[axis] = less;
                self.field
                    .mul(u64::from(e[axis]), self.monomial(&lower, at))
            }
        }
    }

    fn value(&self, f: &[([u32; 3], u64)], at: &Powers) -> u64 {
        let terms = f
            .iter()
            .map(|(e, c)| self.field.mul(*c, self.monomial(e, at)));
        terms.fold(0, |sum, term| self.field.sum(sum, term))
    }
}

/// Polynomials with given monomials for each, as one vector of coefficients.
type Support = Vec<(usize, [u32; 3])>;

/// The rows of a matrix modulo a prime, whose columns are the places of a support; `None` if the prime does not suit.
type Rows<'a> = dyn Fn(&mut Modulo, &Support) -> Option<Vec<Vec<u64>>> + 'a;

/// The place of a vector among those of a kernel.
type Choose<'a> = dyn Fn(&Modulo, &Support, &[Vec<u64>]) -> Option<usize> + 'a;

/// The N polynomials whose coefficients are a vector of the kernels of matrices modulo primes. `rows` gives the matrix for a support; its
/// kernel must have the dimension 2, and `choose` takes one of its vectors modulo the first prime.
fn lifted<const N: usize>(
    monomials: &[[u32; 3]],
    limits: &Limits,
    rows: &Rows<'_>,
    choose: &Choose<'_>,
) -> Result<Option<[SparsePolynomial<3>; N]>> {
    let all: Support = (0..N)
        .flat_map(|k| monomials.iter().map(move |e| (k, *e)))
        .collect();
    let mut support: Option<Support> = None;
    let mut reconstruction = Reconstruction::new();
    for prime in large_primes().take(MAX_PRIMES) {
        limits.check()?;
        let mut modulo = Modulo::new(prime);
        let columns = support.as_ref().unwrap_or(&all);
        let Some(matrix) = rows(&mut modulo, columns) else {
            continue;
        };
        let found = kernel(matrix, columns.len(), prime).vectors;
        if support.is_none() {
            if found.len() != 2 {
                return Ok(None);
            }
            let Some(chosen) = choose(&modulo, &all, &found) else {
                return Ok(None);
            };
            let nonzero = all.iter().zip(&found[chosen]).filter(|(_, c)| **c != 0);
            support = Some(nonzero.map(|(place, _)| *place).collect());
            // The first vector of the kernel for these columns alone is the chosen one.
            continue;
        }
        let Some(image) = found.first() else {
            continue;
        };
        if let Some(integers) = reconstruction.add(image, prime) {
            let polynomials = std::array::from_fn(|k| {
                let own = columns.iter().zip(&integers).filter(|((i, _), _)| *i == k);
                SparsePolynomial::from_terms(own.map(|((_, e), c)| (*e, Rational::whole(c))))
            });
            return Ok(Some(polynomials));
        }
    }
    Ok(None)
}

/// The polynomials (G, H, K) of a closed form over f besides df, without trace: the top part of xG + yH + zK is 0.
fn traceless_form(
    f: &SparsePolynomial<3>,
    degree: u64,
    limits: &Limits,
) -> Result<Option<[SparsePolynomial<3>; 3]>> {
    let slopes = gradient(f);
    let monomials = monomials(degree - 1);
    let points = 3 * monomials.len() / 2 + MORE_POINTS;
    let rows = |modulo: &mut Modulo, support: &Support| {
        let of_f = modulo.polynomial(f)?;
        let of_slopes = [0, 1, 2].map(|i| modulo.polynomial(&slopes[i]));
        let [Some(x), Some(y), Some(z)] = of_slopes else {
            return None;
        };
        let of_slopes = [x, y, z];
        let mut rows = Vec::with_capacity(3 * points);
        for _ in 0..points {
            let at = modulo.point(degree);
            let value = modulo.value(&of_f, &at);
            let slopes = of_slopes.each_ref().map(|s| modulo.value(s, &at));
            // f (∂ω_a/∂b − ∂ω_b/∂a) − ω_a ∂f/∂b + ω_b ∂f/∂a
            for (a, b) in [(0, 1), (0, 2), (1, 2)] {
                let entry = |(k, e): &(usize, [u32; 3])| {
                    let part = |other: usize| {
                        let first = modulo.field.mul(value, modulo.slope(e, other, &at));
                        let second = modulo.field.mul(modulo.monomial(e, &at), slopes[other]);
                        modulo.field.minus(first, second)
                    };
                    match *k {
                        k if k == a => part(b),
                        k if k == b => modulo.field.minus(0, part(a)),
                        _ => 0,
                    }
                };
                rows.push(support.iter().map(entry).collect());
            }
        }
        Some(rows)
    };
    // The vector that is no multiple of df.
    let choose = |modulo: &Modulo, support: &Support, found: &[Vec<u64>]| {
        let of_f: Vec<u64> = support
            .iter()
            .map(|(k, e)| {
                let c = slopes[*k].terms().find(|(other, _)| *other == e);
                c.map_or(Some(0), |(_, c)| modulo.number(c))
            })
            .collect::<Option<_>>()?;
        let is_multiple = |vector: &[u64]| {
            let pairs = || vector.iter().zip(&of_f);
            let Some((a, b)) = pairs().find(|(_, b)| **b != 0) else {
                return false;
            };
            pairs().all(|(x, y)| modulo.field.mul(*x, *b) == modulo.field.mul(*y, *a))
        };
        (0..found.len()).find(|k| !is_multiple(&found[*k]))
    };
    let Some(form) = lifted::<3>(&monomials, limits, &rows, &choose)? else {
        return Ok(None);
    };
    // Along (x, y, z) both dφ/φ and dφ̄/φ̄ have the top part n/2, and df/f has n.
    let variables = [0, 1, 2].map(SparsePolynomial::<3>::variable);
    let along = (0..3).fold(SparsePolynomial::zero(), |sum, k| {
        sum.plus(&form[k].times(&variables[k]))
    });
    let is_top = |e: &[u32; 3]| u64::from(e.iter().sum::<u32>()) == degree;
    let Some((top, c)) = f.terms().find(|(e, _)| is_top(e)) else {
        return Ok(None);
    };
    let n = Rational::from(i64::try_from(degree).invariant("a degree of at most 10"));
    let of_form = along.terms().find(|(e, _)| *e == top);
    let trace = of_form.map_or_else(Rational::zero, |(_, d)| d / c / n);
    Ok(Some(std::array::from_fn(|k| {
        form[k].minus(&slopes[k].scaled(&trace))
    })))
}

/// The constant ω_x²/(∂f/∂x)² on f = 0, from the remainders of both by f along a line; for another variable if f does not have x.
fn square_on_zeros(f: &SparsePolynomial<3>, form: &[SparsePolynomial<3>; 3]) -> Option<Rational> {
    let axis = (0..3).find(|axis| f.degree_in(*axis) > 0)?;
    let slope = f.derivative(axis);
    (1..20i64).find_map(|k| {
        let at = [
            Rational::from(k),
            Rational::from(2 * k + 1) / Rational::from(3),
        ];
        let divisor = along(f, axis, &at);
        if divisor.len() != f.degree_in(axis) as usize + 1 {
            return None;
        }
        let square = |g: &SparsePolynomial<3>| remainder(along(&g.squared(), axis, &at), &divisor);
        let (above, below) = (square(&form[axis]), square(&slope));
        let place = below.iter().position(|c| !c.is_zero())?;
        Some(above.get(place)? / &below[place])
    })
}

/// The coefficients by powers of one variable, with values for the other two.
fn along(f: &SparsePolynomial<3>, axis: usize, at: &[Rational; 2]) -> Vec<Rational> {
    let mut all = vec![Rational::zero(); f.degree_in(axis) as usize + 1];
    for (e, c) in f.terms() {
        let power = |k: usize| at[k].pow(i64::from(e[(axis + 1 + k) % 3]));
        if let [Some(y), Some(z)] = [power(0), power(1)] {
            let place = e[axis] as usize;
            all[place] = &all[place] + &(c * &y * z);
        }
    }
    while all.last().is_some_and(Rational::is_zero) {
        all.pop();
    }
    all
}

/// The remainder of a division of polynomials, ascending; as long as the divisor without its last coefficient.
fn remainder(mut above: Vec<Rational>, divisor: &[Rational]) -> Vec<Rational> {
    let Some((lead, rest)) = divisor.split_last() else {
        return above;
    };
    while above.len() > rest.len() {
        let Some(top) = above.pop() else { break };
        let factor = top / lead;
        let start = above.len() - rest.len();
        for (c, d) in above[start..].iter_mut().zip(rest) {
            *c = &*c - &(&factor * d);
        }
    }
    above.resize(rest.len(), Rational::zero());
    above
}

/// The polynomials g and h of φ = g + √v h, v = `square`, with 2 f dφ = φ (df + ω/√v).
fn factor(
    f: &SparsePolynomial<3>,
    degree: u64,
    form: &[SparsePolynomial<3>; 3],
    square: &Rational,
    limits: &Limits,
) -> Result<Option<[SparsePolynomial<3>; 2]>> {
    let slopes = gradient(f);
    let inverse = square.recip();
    let monomials = monomials(degree / 2);
    let points = monomials.len() / 3 + MORE_POINTS;
    let rows = |modulo: &mut Modulo, support: &Support| {
        let of_f = modulo.polynomial(f)?;
        let inverse = modulo.number(inverse.as_ref()?)?;
        let both: Vec<_> = (0..3)
            .map(|k| Some((modulo.polynomial(&slopes[k])?, modulo.polynomial(&form[k])?)))
            .collect::<Option<_>>()?;
        let mut rows = Vec::with_capacity(6 * points);
        for _ in 0..points {
            let at = modulo.point(degree);
            let value = modulo.value(&of_f, &at);
            let twice = modulo.field.minus(0, modulo.field.sum(value, value));
            for (axis, (slope, form)) in both.iter().enumerate() {
                let [slope, form] = [slope, form].map(|f| modulo.value(f, &at));
                // g ∂f + h ω − 2 f ∂g, and h ∂f + g ω/v − 2 f ∂h
                for own in 0..2 {
                    let other = match own {
                        0 => form,
                        _ => modulo.field.mul(form, inverse),
                    };
                    let entry = |(k, e): &(usize, [u32; 3])| {
                        let monomial = modulo.monomial(e, &at);
                        if *k != own {
                            return modulo.field.mul(monomial, other);
                        }
                        let of_slope = modulo.field.mul(twice, modulo.slope(e, axis, &at));
                        modulo
                            .field
                            .sum(modulo.field.mul(monomial, slope), of_slope)
                    };
                    rows.push(support.iter().map(entry).collect());
                }
            }
        }
        Some(rows)
    };
    lifted::<2>(&monomials, limits, &rows, &|_, _, _| Some(0))
}

/// The simplest basis of the space of g and h: the highest term of the one does not occur in the other.
fn reduced(g: SparsePolynomial<3>, h: SparsePolynomial<3>) -> [SparsePolynomial<3>; 2] {
    let key = |e: &[u32; 3]| (e.iter().sum::<u32>(), *e);
    let top = |f: &SparsePolynomial<3>| {
        let terms = f.terms().max_by_key(|(e, _)| key(e));
        terms.map(|(e, c)| (*e, c.clone()))
    };
    let without = |f: &SparsePolynomial<3>, g: &SparsePolynomial<3>| match top(g) {
        None => f.clone(),
        Some((e, c)) => {
            let own = f.terms().find(|(other, _)| **other == e);
            own.map_or_else(|| f.clone(), |(_, own)| f.minus(&g.scaled(&(own / &c))))
        }
    };
    let h = without(&h, &g);
    let g = without(&g, &h);
    [g.primitive(), h.primitive()]
}
