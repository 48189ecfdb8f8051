//! Guesses of the complex roots of a polynomial, in doubles. Nothing is proved of them.

use nalgebra::Complex;

/// The largest number of steps of Aberth's method.
const MAX_STEPS: usize = 100;

/// Approximations of all roots: Aberth's method from points on circles whose radii are those of the Newton polygon (Bini, *Numerical
/// computation of polynomial zeros by means of Aberth's method*, Numerical Algorithms 13, 1996).
pub(super) fn guessed_roots(coefficients: &[f64]) -> Vec<Complex<f64>> {
    let mut z = circles(coefficients);
    for _ in 0..MAX_STEPS {
        let mut largest = 0.0f64;
        for i in 0..z.len() {
            let step = aberth(coefficients, &z, i);
            if step.norm().is_finite() {
                z[i] -= step;
                largest = largest.max(step.norm() / z[i].norm());
            }
        }
        if largest < 1e-14 {
            break;
        }
    }
    z
}

/// Aberth's correction of the i-th approximation.
fn aberth(coefficients: &[f64], z: &[Complex<f64>], i: usize) -> Complex<f64> {
    let zero = Complex::new(0.0, 0.0);
    let (mut value, mut slope) = (zero, zero);
    for c in coefficients.iter().rev() {
        slope = slope * z[i] + value;
        value = value * z[i] + c;
    }
    if value == zero {
        return zero;
    }
    let others = z.iter().enumerate().filter(|(j, _)| *j != i);
    let sum: Complex<f64> = others.map(|(_, other)| (z[i] - other).inv()).sum();
    (slope / value - sum).inv()
}

/// For each edge of the upper convex hull of the points (j, log |c_j|), as many points on a circle as the edge is long.
fn circles(coefficients: &[f64]) -> Vec<Complex<f64>> {
    let points: Vec<(f64, f64)> = (0u32..)
        .zip(coefficients)
        .filter(|(_, c)| **c != 0.0)
        .map(|(j, c)| (f64::from(j), c.abs().log2()))
        .collect();
    let mut hull: Vec<(f64, f64)> = Vec::new();
    for point in points {
        while let [.., a, b] = hull[..]
            && (b.1 - a.1) * (point.0 - a.0) <= (point.1 - a.1) * (b.0 - a.0)
        {
            hull.pop();
        }
        hull.push(point);
    }
    let mut z = Vec::new();
    let mut add = |radius: f64, count: f64| {
        let turn = std::f64::consts::TAU / count;
        let mut k = 0.25 + 0.1 * hull.len() as f64;
        for _ in 0..count as usize {
            z.push(Complex::from_polar(radius, turn * k));
            k += 1.0;
        }
    };
    if let Some(first) = hull.first() {
        add(1e-30, first.0);
    }
    for pair in hull.windows(2) {
        let length = pair[1].0 - pair[0].0;
        add(((pair[0].1 - pair[1].1) / length).exp2(), length);
    }
    z
}
