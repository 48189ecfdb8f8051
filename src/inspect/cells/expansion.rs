//! The surface near one of its points, and a lower bound of the distance between a point and a cell.

use super::waves::{ABOVE, Turn, Waves};
use crate::intervals::interval::UNIT;

/// The nominal angles differ by at most this from the angles of their cosines and sines, for which the library is trusted up to
/// 2^(−48) each.
pub(super) const ANGLE: f64 = 4.0 * f64::EPSILON * 16.0;

/// The surface point `X = R d` at the angles (θ, φ) of a chart, less a point p, and its derivatives.
#[derive(Clone, Copy, Debug)]
pub(super) struct Expansion {
    /// The angles θ and φ.
    pub(super) at: [f64; 2],
    /// X − p
    pub(super) value: [f64; 3],
    /// X_θ and X_φ
    pub(super) slopes: [[f64; 3]; 2],
    /// X_θθ, X_θφ and X_φφ
    pub(super) bends: [[f64; 3]; 3],
}

/// Bounds of the errors of an expansion: of the value, the slopes and the bends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Errors {
    pub(super) value: f64,
    pub(super) slope: f64,
    pub(super) bend: f64,
}

impl Errors {
    /// **Lemma 2.** The value, the slopes and the bends of [`Expansion::new`] are wrong by at most these lengths, besides 4u|X − p| for
    /// the value.
    ///
    /// Proof. With E_k and S_k, the bounds of errors and sizes of derivatives of R, a derivative of X of order k is a sum of at most four
    /// products of a derivative of R and a unit vector, that is wrong by less than 16u (of two waves, each wrong by 4u, in one product), and
    /// the products and sums are rounded at most 4 times in each of three coordinates: less than 2·(16 + 4)u S_k in all.
    pub(super) fn new(waves: &Waves) -> Self {
        let (e, s) = (waves.errors(), waves.sizes());
        let rounding = 40.0 * UNIT;
        Self {
            value: (e[0] + rounding * s[0]) * ABOVE,
            slope: (e[1] + e[0] + rounding * (s[1] + s[0])) * ABOVE,
            bend: (e[2] + 2.0 * e[1] + e[0] + rounding * (s[2] + 2.0 * s[1] + s[0])) * ABOVE,
        }
    }

    /// A bound of the error of the expansion at v with |v₁| + |v₂| ≤ r.
    pub(super) fn within(&self, r: f64) -> f64 {
        (self.value + r * (self.slope + r * self.bend)) * ABOVE
    }
}

/// The cosine and the sine of an angle.
pub(super) fn turn(angle: f64) -> Turn {
    let (sin, cos) = angle.sin_cos();
    [cos, sin]
}

impl Expansion {
    /// The expansion at the angles, less the point p in the coordinates of the chart.
    pub(super) fn new(waves: &Waves, at: [f64; 2], p: &[f64; 3]) -> Self {
        let [theta, phi] = at.map(turn);
        let r = waves.derivatives::<3>(theta, phi);
        let ([ct, st], [cp, sp]) = (theta, phi);
        let d = [sp * ct, sp * st, cp];
        let by_theta = [-sp * st, sp * ct, 0.0];
        let by_phi = [cp * ct, cp * st, -sp];
        let twice_by_theta = [-sp * ct, -sp * st, 0.0];
        let by_both = [-cp * st, cp * ct, 0.0];
        let sum = |a: f64, b: f64, c: f64, e: f64, u: &[f64; 3], v: &[f64; 3], w: &[f64; 3]| {
            std::array::from_fn(|i| a * d[i] + b * u[i] + c * v[i] + e * w[i])
        };
        Self {
            at,
            value: std::array::from_fn(|i| r[0][0] * d[i] - p[i]),
            slopes: [
                std::array::from_fn(|i| r[1][0] * d[i] + r[0][0] * by_theta[i]),
                std::array::from_fn(|i| r[0][1] * d[i] + r[0][0] * by_phi[i]),
            ],
            bends: [
                sum(
                    r[2][0],
                    2.0 * r[1][0],
                    r[0][0],
                    0.0,
                    &by_theta,
                    &twice_by_theta,
                    &d,
                ),
                sum(
                    r[1][1], r[1][0], r[0][1], r[0][0], &by_phi, &by_theta, &by_both,
                ),
                sum(r[0][2] - r[0][0], 2.0 * r[0][1], 0.0, 0.0, &by_phi, &d, &d),
            ],
        }
    }

    /// The computed distance, and a bound of the part of its error that is relative to it.
    pub(super) fn distance(&self) -> [f64; 2] {
        let distance = length(&self.value);
        [distance, 16.0 * UNIT * distance]
    }

    /// Half the gradient of the squared distance.
    pub(super) fn gradient(&self) -> [f64; 2] {
        self.slopes.each_ref().map(|slope| dot(slope, &self.value))
    }

    /// Half the second derivatives of the squared distance.
    pub(super) fn curvature(&self) -> [f64; 3] {
        let [a, b] = &self.slopes;
        let [aa, ab, bb] = self.bends.each_ref().map(|bend| dot(bend, &self.value));
        [dot(a, a) + aa, dot(a, b) + ab, dot(b, b) + bb]
    }

    /// The largest length of a slope, and half the largest one of a bend.
    pub(super) fn sizes(&self) -> (f64, f64) {
        let lengths = self.slopes.each_ref().map(length);
        let bends = self.bends.each_ref().map(length);
        let largest = bends.into_iter().fold(0.0, f64::max);
        (lengths[0].max(lengths[1]) * ABOVE, 0.5 * largest * ABOVE)
    }

    /// A step of Newton's method to a minimum of the distance; `None` where the squared distance is not convex.
    pub(super) fn newton_step(&self) -> Option<[f64; 2]> {
        let ([g, h], [a, b, c]) = (self.gradient(), self.curvature());
        let determinant = a * c - b * b;
        (a > 0.0 && determinant > 0.0)
            .then(|| [(b * h - c * g) / determinant, (b * g - a * h) / determinant])
    }

    /// A step of Newton's method, or downhill, to a point at which the distance is less.
    pub(super) fn descent(&self) -> [f64; 2] {
        self.newton_step().unwrap_or_else(|| {
            let [a, b] = &self.slopes;
            let steepness = dot(a, a).max(dot(b, b)).max(f64::MIN_POSITIVE);
            self.gradient().map(|g| -g / steepness)
        })
    }

    /// A number that the distance |X(u + v) − p| is not below, for all v with low ≤ u + v ≤ high in both coordinates; `third` is a bound of
    /// |X'''|/6 along all directions of length |v₁| + |v₂| = 1 in a rectangle that holds u and these points.
    ///
    /// **Lemma 3.** Let D be the value, T(v) = T₁v₁ + T₂v₂ with |Tᵢ| ≤ t, B(v) half the second derivative along v, so that |B(v)| ≤ b s²
    /// with s = |v₁| + |v₂| and the largest half length b of a bend. Let s ≤ r, M = `third` and G the matrix of |T(v)|² + 2D·B(v). Then
    ///
    /// |D + T(v) + B(v) + κ|² ≥ |D|² + 2D·T(v) + v'Gv − 4r(tb + M(|D| + tr + br²))|v|².
    ///
    /// Proof. Let P = D + T(v) + B(v). Then |P + κ|² ≥ |P|² − 2|P||κ| with |κ| ≤ Ms³; and |P|² ≥ |D|² + 2D·T(v) + v'Gv − 2tbs³, because
    /// |B(v)|² ≥ 0. Here s³ ≤ rs² ≤ 2r|v|². Moreover v'Gv ≥ (G₁₁ − |G₁₂|)v₁² + (G₂₂ − |G₁₂|)v₂².
    ///
    /// Rounding. As in Lemma 4 of the arcs of a plane curve. The errors of D, T and B (Lemma 2) change the left side by at most
    /// `value + slope·r + bend·r²`, which is subtracted at the end.
    ///
    /// Law: `cells_are_not_nearer`.
    pub(super) fn least_distance(
        &self,
        low: [f64; 2],
        high: [f64; 2],
        third: f64,
        errors: &Errors,
    ) -> f64 {
        let square = dot(&self.value, &self.value);
        let distance = square.sqrt();
        let (t, b) = self.sizes();
        let ends = [0, 1].map(|i| [low[i] - self.at[i] - ANGLE, high[i] - self.at[i] + ANGLE]);
        let reach = ends.map(|[a, b]| a.abs().max(b.abs()));
        let r = (reach[0] + reach[1]) * ABOVE;

        let lost = 4.0 * r * (t * b + third * (distance + r * (t + r * b))) * ABOVE;
        let [first, mixed, second] = self.curvature();
        let parts = t * t + 2.0 * b * distance;
        let aside = mixed.abs() + lost + 64.0 * UNIT * (parts + lost);
        let curvatures = [first - aside, second - aside];

        let error = 8.0 * UNIT * distance * t;
        let gradient = self.gradient();
        let change: f64 = (0..2)
            .map(|i| lowest(gradient[i], curvatures[i], ends[i]) - 2.0 * error * reach[i])
            .sum();
        let least = square * (1.0 - 8.0 * UNIT) + change * (1.0 + change.signum() * -4.0 * UNIT);
        if least > 0.0 {
            let wrong = errors.within(r);
            least.sqrt() * (1.0 - 4.0 * UNIT) - 8.0 * UNIT * distance - wrong
        } else {
            0.0
        }
    }
}

/// A lower bound of 2·`slope`·v + `curvature`·v² between two ends; each is computed with less than 12 roundings.
fn lowest(slope: f64, curvature: f64, [low, high]: [f64; 2]) -> f64 {
    let value = |v: f64| {
        let (linear, square) = (2.0 * slope * v, curvature * v * v);
        linear + square - 16.0 * UNIT * (linear.abs() + square.abs())
    };
    let least = value(low).min(value(high));
    let vertex = -slope / curvature;
    if curvature > 0.0 && low < vertex && vertex < high {
        return least.min(-(slope * slope / curvature) * (1.0 + 16.0 * UNIT));
    }
    least
}

/// The scalar product.
pub(super) fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The length, in doubles.
pub(super) fn length(a: &[f64; 3]) -> f64 {
    dot(a, a).sqrt()
}
