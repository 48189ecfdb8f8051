//! The numbers that options take. The verbs and the writers check them, so that a program that calls the library gets the same messages
//! as a user of the command line.

use std::ops::RangeInclusive;

use crate::error::{Error, Result};

/// The whole numbers that an option takes.
#[derive(Clone, Copy, Debug)]
pub struct Allowed {
    option: &'static str,
    least: u32,
    most: u32,
    usual: u32,
}

/// The digits or decimals that are written.
pub const DIGITS: Allowed = Allowed::new("--digits", 0, 10_000, 16);

/// The cells along the larger side of a picture.
pub const PICTURE_CELLS: Allowed = Allowed::new("--cells", 8, 4000, 240);

/// The cells along the longest side of the box of a mesh.
pub const MESH_RESOLUTION: Allowed = Allowed::new("--resolution", 2, 1024, 64);

/// The steps along the longest side of the box in which an intersection is followed.
pub const ARC_RESOLUTION: Allowed = Allowed::new("--resolution", 2, 4096, 64);

impl Allowed {
    const fn new(option: &'static str, least: u32, most: u32, usual: u32) -> Self {
        Self {
            option,
            least,
            most,
            usual,
        }
    }

    /// The least and the largest number.
    #[must_use]
    pub fn range(&self) -> RangeInclusive<u32> {
        self.least..=self.most
    }

    /// A number that is right, for messages.
    #[must_use]
    pub fn usual(&self) -> u32 {
        self.usual
    }

    /// Refuses a number that the option does not take.
    ///
    /// # Errors
    /// [`Error::Usage`] with the option and the numbers that it takes.
    ///
    /// ```
    /// assert!(stellate::verb::DIGITS.check(10_000).is_ok());
    /// let error = stellate::verb::DIGITS.check(10_001).unwrap_err();
    /// assert_eq!(error.to_string(), "--digits 10001: expected a whole number from 0 to 10000, such as 16");
    /// ```
    pub fn check(&self, number: u32) -> Result<()> {
        if self.range().contains(&number) {
            return Ok(());
        }
        Err(Error::Usage(format!(
            "{} {number}: expected a whole number from {} to {}, such as {}",
            self.option, self.least, self.most, self.usual
        )))
    }
}

/// Refuses a number that is not greater than 0, or no finite number.
pub(super) fn check_positive(option: &str, number: f64) -> Result<()> {
    if number > 0.0 && number.is_finite() {
        return Ok(());
    }
    Err(Error::Usage(format!(
        "{option} {number}: expected a number greater than 0, such as 0.1, 1e-3 or 1/10"
    )))
}

/// Refuses the sides of a box, or of a window, that do not ascend.
pub(super) fn check_sides(sides: &[[f64; 2]]) -> Result<()> {
    if sides
        .iter()
        .all(|[a, b]| a < b && a.is_finite() && b.is_finite())
    {
        return Ok(());
    }
    let shown: Vec<String> = sides.iter().flatten().map(f64::to_string).collect();
    let expected = match sides.len() {
        2 => "X0,X1,Y0,Y1 with X0 < X1 and Y0 < Y1, such as -1,1,-1,1",
        _ => "X0,X1,Y0,Y1,Z0,Z1 with X0 < X1 and so on, such as -1,1,-1,1,0,2",
    };
    Err(Error::Usage(format!(
        "--window {}: expected {expected}",
        shown.join(",")
    )))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Format, write_described};
    use crate::language::Numbers;
    use crate::verb::{
        DescribeOptions, Given, InspectionOptions, MeshingOptions, Work, describe, inspect, mesh,
    };

    #[test]
    fn wrong_numbers_are_refused_with_their_option() {
        for (allowed, wrong, right) in [
            (PICTURE_CELLS, 7, 8),
            (MESH_RESOLUTION, 1025, 1024),
            (ARC_RESOLUTION, 1, 2),
        ] {
            let message = allowed.check(wrong).unwrap_err().to_string();
            assert!(
                message.starts_with(&format!("{} {wrong}: ", allowed.option)),
                "{message}"
            );
            assert!(allowed.check(right).is_ok());
        }
        for wrong in [0.0, -1.0, f64::INFINITY, f64::NAN] {
            assert!(check_positive("--reach", wrong).is_err());
            assert!(check_sides(&[[wrong, -1.0], [0.0, 1.0]]).is_err());
        }
        assert!(check_sides(&[[-1.0, 1.0], [0.0, 1.0]]).is_ok());
    }

    #[test]
    fn verbs_and_writers_refuse_what_the_command_line_refuses() {
        let given = || Given::read("x^2 + y^2 = 1", Numbers::Exact).unwrap();
        let work = Work::default();
        for reach in [-1.0, 0.0, f64::INFINITY] {
            let options = InspectionOptions::default().reach(Some(reach));
            let message = inspect(given(), 2, &options, &work)
                .unwrap_err()
                .to_string();
            assert!(
                message.starts_with(&format!("--reach {reach}: ")),
                "{message}"
            );
        }
        let found = describe(given(), &DescribeOptions::default(), &work).unwrap();
        let mut out = Vec::new();
        assert!(write_described(&found, 10_001, Format::Text, &mut out).is_err());
        assert!(out.is_empty());
        let options = MeshingOptions::default().resolution(1);
        let message = mesh(given(), &options, &work).unwrap_err().to_string();
        assert!(message.starts_with("--resolution 1: "), "{message}");
    }

    #[cfg(feature = "pictures")]
    #[test]
    fn pictures_are_refused_with_the_option() {
        use crate::verb::{Frame, PlotOptions, plot};
        let window = crate::picture::Window {
            x: [1.0, -1.0],
            y: [0.0, 1.0],
        };
        let usual = PlotOptions::default;
        for (options, option) in [
            (usual().cells(Some(7)), "--cells 7: "),
            (usual().view(Some([0.0, 90.0])), "--view 0,90: "),
            (
                usual().ranges(vec![("t".into(), [1.0, 1.0])]),
                "--range t=1,1: ",
            ),
            (
                usual().window(Some(Frame::Plane(window))),
                "--window 1,-1,0,1: ",
            ),
        ] {
            let curve = Given::read("x = t; y = t^2", Numbers::Exact).unwrap();
            let message = plot(vec![curve], &options, &Work::default());
            let message = message.unwrap_err().to_string();
            assert!(message.starts_with(option), "{message}");
        }
    }
}
