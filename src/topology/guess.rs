//! Guesses of the complex roots of a polynomial, in doubles. Nothing is proved of them.

use nalgebra::Complex;

/// The largest number of steps of Aberth's method.
const MAX_STEPS: usize = 100;

/// The radius of the circle for roots that are 0.
const TINY: f64 = 1e-30;

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
    let points: Vec<(u32, f64)> = (0u32..)
        .zip(coefficients)
        .filter(|(_, c)| **c != 0.0)
        .map(|(j, c)| (j, c.abs().log2()))
        .collect();
    let run = |a: (u32, f64), b: (u32, f64)| f64::from(b.0 - a.0);
    let mut hull: Vec<(u32, f64)> = Vec::new();
    for point in points {
        while let [.., a, b] = hull[..]
            && (b.1 - a.1) * run(a, point) <= (point.1 - a.1) * run(a, b)
        {
            hull.pop();
        }
        hull.push(point);
    }
    let mut z = Vec::new();
    let mut turned = 0.25;
    let mut add = |radius: f64, count: u32| {
        // Every circle is turned a little more, so that no two points are on one ray.
        turned += 0.1;
        let points = (0..count).map(|k| {
            let turn = (f64::from(k) + turned) / f64::from(count);
            Complex::from_polar(radius, std::f64::consts::TAU * turn)
        });
        z.extend(points);
    };
    if let Some(first) = hull.first() {
        add(TINY, first.0);
    }
    for pair in hull.windows(2) {
        let slope = (pair[0].1 - pair[1].1) / run(pair[0], pair[1]);
        add(slope.exp2(), pair[1].0 - pair[0].0);
    }
    z
}
