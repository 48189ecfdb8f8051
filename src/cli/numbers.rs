//! Lists of numbers in options.

use stellate::error::{Error, Result};

/// The sides of a box.
pub(crate) type Bounds = [[f64; 2]; 3];

/// N finite numbers with commas between them.
pub(crate) fn numbers_of<const N: usize>(text: &str) -> Option<[f64; N]> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|t| t.trim().parse().ok()).collect();
    let numbers: [f64; N] = numbers?.try_into().ok()?;
    numbers.iter().all(|v| v.is_finite()).then_some(numbers)
}

/// `--window` in space.
pub(crate) fn space_window(text: &str) -> Result<Bounds> {
    let wrong = || {
        Error::Usage(format!(
            "--window {text}: expected X0,X1,Y0,Y1,Z0,Z1 with X0 < X1 and so on, such as -1,1,-1,1,0,2"
        ))
    };
    let [x0, x1, y0, y1, z0, z1] = numbers_of::<6>(text).ok_or_else(wrong)?;
    if x0 < x1 && y0 < y1 && z0 < z1 {
        Ok([[x0, x1], [y0, y1], [z0, z1]])
    } else {
        Err(wrong())
    }
}
